#!/bin/sh
# Whether programs that were linked with the last release can go on with the libraries of this tree: abidiff (package
# abigail-tools) finds no function that is gone and no type, size or status that has changed from what scripts/abi holds. New
# functions and statuses are no change. Usage:
#   scripts/abi.sh            compares
#   scripts/abi.sh record     makes scripts/abi anew: for a release, or where a change is meant
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
# Compiled anew only what changed; functions of the library alone are exported, as they are by an optimised one.
build_libraries() {
  [ -f $build/build.ninja ] || LDFLAGS="-Wl,--version-script=$PWD/scripts/abi/exports.map" meson setup $build --buildtype=debug \
    -Doptimized=false -Dsimd=disabled -Dgpu=disabled -Ddefault_library=shared -Dtests=disabled -Dbench=disabled -Dpython=disabled \
    -Dfortran=disabled || return
  meson compile -C $build
}
mkdir -p $build/headers
build_libraries >$build/log 2>&1 || { cat $build/log; exit 1; }
cp include/*.h $build/headers # the types of the C API; what others there are is the library's own affair
cc -std=c99 -g -shared -fPIC -Iinclude -I$build/include scripts/abi/constants.c -o $build/src/libconstants.so

failed=0
for library in libpw85 libpw85_legacy libconstants; do
  abidw --exported-interfaces-only --headers-dir $build/headers --drop-private-types --no-corpus-path --no-comp-dir-path \
    --no-elf-needed --no-show-locs --out-file $build/$library.abi $build/src/$library.so
  if [ $# -eq 1 ]; then
    cp $build/$library.abi scripts/abi
  elif ! abidiff --no-added-syms scripts/abi/$library.abi $build/$library.abi; then
    echo "$library.so: not compatible with scripts/abi"
    failed=1
  fi
done
exit $failed
