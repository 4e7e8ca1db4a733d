#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Tests and measures pw85_gpu.h on a machine with an NVIDIA GPU. It builds pw85 in ./build-gpu, runs the tests that need no device,
# then the same program on the device (also under compute-sanitizer if that is installed), arrays of those Python libraries for GPUs
# that are there, and bench/gpu. Arguments are passed to bench/gpu: the number of pairs, and the number of overlaps to compare with those
# of the host. `bench/measure.py --only gpu build-gpu/tests/gpu/bench_gpu` makes the manual's table of it.
set -eu
cd "$(dirname "$0")/.."
. scripts/packages.sh
# shellcheck disable=SC2086 # a list of words
if command -v apt-get >/dev/null; then install_packages $test_packages; fi

build=$PWD/build-gpu
[ -f "$build/build.ninja" ] ||
  meson setup "$build" -Dtests=enabled -Dbench=disabled -Dfortran=disabled -Dgpu=enabled
meson test -C "$build" --suite gpu --print-errorlogs
"$build/tests/gpu/test_gpu"
if command -v compute-sanitizer >/dev/null; then
  for tool in memcheck racecheck synccheck initcheck; do
    compute-sanitizer --tool "$tool" --error-exitcode 1 "$build/tests/gpu/test_gpu" -p /gpu/like_host -p /gpu/outputs -p /gpu/lists
  done
fi
PYTHONPATH=$build/python python3 -m pytest -rs python/tests/gpu_libraries.py
exec "$build/tests/gpu/bench_gpu" "$@"
