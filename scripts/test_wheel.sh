#!/bin/sh
# Makes the wheel, and of it one for other systems (auditwheel): what that needs of a system, and whether it works where it is
# installed alone, by the command with which cibuildwheel tests wheels. Usage: scripts/test_wheel.sh; status 77: no auditwheel.
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
# NumPy and click are those of the system; the package is not.
/usr/bin/python3 -m venv --system-site-packages "$work/venv"
# shellcheck disable=SC2086
"$work/venv/bin/python" $pip -q install --no-index --no-deps "$work/repaired"/*.whl
PYTHONPATH='' "$work/venv/bin/python" scripts/check_wheel.py "$work/repaired" "$work/venv"
