#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Builds the wheel, and from it a wheel for other systems (auditwheel). It shows what the wheel needs of a system, installs it into
# an environment of its own, and tests it there by the command that cibuildwheel uses. The exit status is 77 if there is no
# auditwheel.
set -eu
cd "$(dirname "$0")/.."
scripts/sid.sh auditwheel --version
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
pip='-m pip --no-cache-dir --disable-pip-version-check'
# shellcheck disable=SC2086 # a list of words
/usr/bin/python3 $pip -q wheel --no-index --no-build-isolation --no-deps -w "$work" "$PWD"
scripts/sid.sh auditwheel show "$work"/*.whl
scripts/sid.sh auditwheel repair -w "$work/repaired" "$work"/*.whl
# The environment uses NumPy and click of the system, and the package of the wheel.
/usr/bin/python3 -m venv --system-site-packages "$work/venv"
# shellcheck disable=SC2086
"$work/venv/bin/python" $pip -q install --no-index --no-deps "$work/repaired"/*.whl
PYTHONPATH='' "$work/venv/bin/python" scripts/check_wheel.py "$work/repaired" "$work/venv"
