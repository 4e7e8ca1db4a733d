#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Installs the Python package as README says, into an environment of its own, and runs its tests there, of which it leaves out those
# that build the package again (test_interpreter.py, test_wheel.py) and those of a GPU, for which Meson builds a driver. It shows the
# versions of Python and NumPy and how long README's commands took. Further arguments go to pytest. For other versions than this system
# has: scripts/test_release.sh trixie scripts/test_python.sh
set -eu
cd "$(dirname "$0")/.."
. scripts/packages.sh
# shellcheck disable=SC2086 # lists of words
install_packages gcc g++ $python_packages $python_test_packages
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
commands=$work/commands
sed -n '/^# start/,/^# end/p' docs/installation/python.sh >"$commands"
start=$(date +%s)
HOME=$work sh -e "$commands"
end=$(date +%s)
python=$work/.venv/pw85/bin/python
"$python" -c 'import sys, numpy, pypw85; print("Python", sys.version.split()[0], "NumPy", numpy.__version__, pypw85.__file__)'
echo "README's commands for Python took $((end - start)) seconds on $(nproc) processors."
# Jupyter's kernels are of the system, and find the package by the path.
packages=$("$python" -c 'import pathlib, pypw85; print(pathlib.Path(pypw85.__file__).parents[1])')
PYTHONPATH=$PWD/python/tests:$packages "$python" -m pytest -q -rs -p no:cacheprovider --ignore=python/tests/test_wheel.py \
  --ignore=python/tests/test_interpreter.py --ignore=python/tests/test_device.py "$@" python/tests
