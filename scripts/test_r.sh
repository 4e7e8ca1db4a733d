#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Tests the R package: installs the library and the package into build-r, with the packages of Debian or Ubuntu that they need, runs R CMD
# check as CRAN does but for its network and the PDF manual, README's programs, and compares bits with those of a program in C.
set -eu
cd "$(dirname "$0")/.."
. scripts/library.sh
# shellcheck disable=SC2086,SC2154 # a list of words
install_library build-r $r_packages
rm -rf build-r/r && mkdir -p build-r/r/library
cp -R r build-r/r/pw85
cd build-r/r

echo '+ configure without the library'
if (cd pw85 && PKG_CONFIG_LIBDIR=/nonexistent PKG_CONFIG_PATH='' ./configure) 2>message; then exit 1; fi
grep -q 'the library pw85, version [0-9.]* or later, is not installed' message

export PKG_CONFIG_PATH="$prefix/lib/pkgconfig" R_LIBS="$PWD/library"
echo '+ R CMD INSTALL, without warnings'
echo 'CFLAGS += -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror' >makevars
R_MAKEVARS_USER="$PWD/makevars" R CMD INSTALL pw85 >install.log 2>&1 || { cat install.log && exit 1; }
if grep -i warning: install.log; then exit 1; fi

echo '+ the bits of C'
# shellcheck disable=SC2046 # a list of words
cc -std=c99 pw85/data-raw/pairs.c -o pairs $(pkg-config --cflags --libs pw85) -Wl,-rpath,"$prefix/lib"
./pairs | diff - pw85/tests/testthat/pairs.txt

echo '+ the bits of C, of pairs of all sizes'
cd ../..
PW85_MEASURE_ONCE='' /usr/bin/python3 bench/languages.py build-r C R
cd build-r/r

echo '+ README'
# shellcheck disable=SC2016 # the marks of blocks
sed -n '/^```r$/,/^```$/p' pw85/README.md | sed '/^```/d' >readme.R
# shellcheck disable=SC2016
sed -n '/^```text$/,/^```$/p' pw85/README.md | sed '/^```/d' >expected
sed -n 's/^overlap_area.* # /[1] /p' pw85/README.md >>expected
Rscript readme.R | diff - expected
grep -q "$(head -n 1 expected)" ../../examples/c/pair.txt

echo '+ R CMD build, R CMD check'
R CMD build pw85 >build.log 2>&1 || { cat build.log && exit 1; }
# The checks that need a network, and the one that needs LaTeX, are left out.
_R_CHECK_CRAN_INCOMING_=FALSE _R_CHECK_SYSTEM_CLOCK_=FALSE R CMD check --as-cran --no-manual pw85_*.tar.gz >check.log 2>&1 || true
tail -n 4 check.log
grep -qx 'Status: OK' check.log || { cat check.log pw85.Rcheck/tests/*.fail pw85.Rcheck/00install.out 2>/dev/null && exit 1; }
