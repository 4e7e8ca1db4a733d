#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Builds js/pw85.wasm, with which the folder js/ is an npm package, in the folder build-npm. Needs the packages emscripten and
# libboost-dev of Debian or Ubuntu.
set -eu
cd "$(dirname "$0")/.."
build="build-npm"
# The headers of Boost, without those of other libraries of this system.
mkdir -p $build/boost/include
ln -sfn /usr/include/boost $build/boost/include/boost
[ -f $build/library/build.ninja ] || BOOST_ROOT=$PWD/$build/boost meson setup $build/library \
  --cross-file scripts/cross/wasm32-emscripten.ini --optimization=2 -Doptimized=false -Dcpp_eh=none -Dcpp_rtti=false \
  -Dcpp_args=-msimd128 -Dtests=disabled -Dbench=disabled -Dpython=disabled -Dfortran=disabled -Dgsl=disabled -Dgpu=disabled \
  -Dsystems=false -Dsimulation=false
ninja -C $build/library src/libpw85.a
# A call needs at most 16 kB of the stack (pw85.h). The stack is below all other data, so that nothing can be overwritten.
em++ -O2 -msimd128 --no-entry js/module.cpp $build/library/src/libpw85.a -o js/pw85.wasm -sSTANDALONE_WASM -sALLOW_MEMORY_GROWTH=1 \
  -sINITIAL_MEMORY=1MB -sTOTAL_STACK=256KB -Wl,--stack-first -sSUPPORT_ERRNO=0 \
  "-sEXPORTED_FUNCTIONS=$(/usr/bin/python3 api/javascript.py)"
chmod 644 js/pw85.wasm
