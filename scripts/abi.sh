#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Checks that programs that were linked with the last release run with the libraries of this tree. abidiff (package abigail-tools)
# compares the libraries with scripts/abi: no function may be missing, and no type, size or status may have changed. New functions
# and statuses are allowed. Usage:
#   scripts/abi.sh            compares
#   scripts/abi.sh record     writes scripts/abi, for a release or an intended change
set -eu
cd "$(dirname "$0")/.."
case $#$* in
0 | 1record) ;;
*)
  echo "usage: scripts/abi.sh [record]" >&2
  exit 2
  ;;
esac
if [ "$(uname -m)" != x86_64 ]; then
  echo "scripts/abi is that of x86-64: nothing to compare with."
  exit 0
fi
build="build-abi"
# Only changed sources are compiled again.
build_libraries() {
  [ -f $build/build.ninja ] || meson setup $build --buildtype=debug \
    -Doptimized=false -Dsimd=disabled -Dgpu=disabled -Ddefault_library=shared -Dtests=disabled -Dbench=disabled -Dpython=disabled \
    -Dfortran=disabled || return
  meson compile -C $build
}
mkdir -p $build/headers
build_libraries >$build/log 2>&1 || { cat $build/log; exit 1; }
cp include/*.h include/pw85/last_error.h $build/headers # only types of the C API are compared; other types are internal
cc -std=c99 -g -shared -fPIC -Iinclude -I$build/include scripts/abi/constants.c -o $build/src/libconstants.so

failed=0
for library in libpw85 libpw85_gpu libpw85_legacy libconstants; do
  abidw --exported-interfaces-only --headers-dir $build/headers --drop-private-types --no-corpus-path --no-comp-dir-path \
    --no-elf-needed --no-show-locs --out-file $build/$library.abi "$(find $build/src -name $library.so)"
  if [ $# -eq 1 ]; then
    cp $build/$library.abi scripts/abi
  elif ! abidiff --no-added-syms scripts/abi/$library.abi $build/$library.abi; then
    echo "$library.so: not compatible with scripts/abi"
    failed=1
  fi
done
exit $failed
