#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Compares the bits of 1,000 pairs in eight languages: builds the library, the packages for all languages and a program in each, in
# build-languages, with the packages of Debian or Ubuntu that they need.
set -eu
cd "$(dirname "$0")/.."
. scripts/packages.sh
# shellcheck disable=SC2086,SC2154 # a list of words
if command -v apt-get >/dev/null; then
  install_packages $build_packages $python_packages gfortran r-base-core r-base-dev $octave_packages $rust_packages $npm_packages
fi
build="build-languages"
[ -f $build/build.ninja ] || meson setup $build -Dtests=disabled -Dbench=disabled -Dgpu=disabled -Dpython=enabled -Dfortran=enabled
meson compile -C $build
PW85_MEASURE_ONCE='' /usr/bin/python3 bench/languages.py $build
