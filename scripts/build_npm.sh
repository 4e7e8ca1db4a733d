#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# build_npm.sh [BUILD [FOLDER]] builds the modules of the npm package, pw85.wasm and plane.wasm, in the folder BUILD (build-npm), and writes
# them to FOLDER (js/, which then is the package). Needs the packages that js/README.md names.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
build=${1:-$root/build-npm}
folder=${2:-$root/js}
# The headers of Boost, without those of other libraries of this system.
mkdir -p "$build/boost/include"
ln -sfn /usr/include/boost "$build/boost/include/boost"
unset CFLAGS CXXFLAGS CPPFLAGS LDFLAGS # which are for this machine
launcher=
if command -v ccache >/dev/null; then launcher="'ccache'"; fi
printf '[constants]\nlauncher = [%s]\n' "$launcher" >"$build/launcher.ini"
[ -f "$build/library/build.ninja" ] || BOOST_ROOT=$build/boost meson setup "$build/library" "$root" \
  --cross-file "$build/launcher.ini" --cross-file "$root/scripts/cross/wasm32-wasi.ini" --optimization=2 -Doptimized=false \
  -Dcpp_eh=none -Dcpp_rtti=false "-Dcpp_args=-msimd128 -mnontrapping-fptoint" -Dtests=disabled -Dbench=disabled -Dpython=disabled \
  -Dfortran=disabled -Dgsl=disabled -Dgpu=disabled -Dsystems=false -Dsimulation=false
ninja -C "$build/library" src/libpw85.a
# Of functions that several units have, the linker takes the first one: volumes call some that other units compile to be short.
first=$build/library/src/libpw85.a.p/c_api_volumes.cpp.o
# A call needs at most 16 kB of the stack (pw85.h). The stack is below all other data, so that nothing can be overwritten.
for module in pw85 plane; do
  exports=$(/usr/bin/python3 "$root/api/javascript.py" "$module")
  # shellcheck disable=SC2086 # a list of words
  clang++ --target=wasm32-wasi -msimd128 -nostartfiles -fno-exceptions "$root/js/module.cpp" "$first" \
    "$build/library/src/libpw85.a" $exports -Wl,--no-entry,--strip-all,--stack-first,-z,stack-size=262144,--initial-memory=1048576 \
    -o "$build/$module.wasm"
  wasm-opt -Oz --enable-simd --enable-nontrapping-float-to-int "$build/$module.wasm" -o "$folder/$module.wasm"
  chmod 644 "$folder/$module.wasm"
done
