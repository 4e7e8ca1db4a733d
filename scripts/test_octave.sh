#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Tests the Octave package: installs the library and the package into build-octave, with the packages of Debian or Ubuntu that they need,
# runs the tests of the package and README's programs, compares bits with those of a program in C, and compiles the sources with the
# declarations that MATLAB documents, too.
set -eu
cd "$(dirname "$0")/.."
. scripts/library.sh
# shellcheck disable=SC2086,SC2154 # a list of words
install_library build-octave $octave_packages
sources=$PWD
rm -rf build-octave/octave && mkdir -p build-octave/octave/packages
cd build-octave/octave
"$sources/octave/package.sh"
folder=$PWD/packages

echo '+ the sources with the declarations of MATLAB'
for file in pw85_mex questions; do
  cc -std=c99 -O2 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -I"$sources/octave/tests/matlab" -I"$prefix/include" \
    -c "$sources/octave/src/$file.c" -o $file.o
done

# Octave without settings of the user. It installs to a folder of the test, also if root runs it, for whom pkg has another list.
run_octave() {
  octave-cli --no-history --norc --eval "pkg prefix $folder $folder; pkg local_list $folder/list; pkg global_list $folder/list; $1"
}

echo '+ pkg install without the library'
if PKG_CONFIG_LIBDIR=/nonexistent PKG_CONFIG_PATH='' run_octave 'pkg install -local pw85-*.tar.gz' >message 2>&1; then exit 1; fi
grep -q 'the library pw85, version [0-9.]* or later, is not installed' message || { cat message && exit 1; }

echo '+ pkg install'
export PKG_CONFIG_PATH="$prefix/lib/pkgconfig"
export CFLAGS='-O2 -Wall -Wextra -Wconversion -Wshadow -Werror'
run_octave 'pkg install -local -verbose pw85-*.tar.gz' >install.log 2>&1 || { cat install.log && exit 1; }
# Octave looks for help in the compiled file, which has none.
if grep -i warning: install.log | grep -v "help text found in file 'pw85_mex'\|called from"; then cat install.log && exit 1; fi

echo '+ the bits of C'
# shellcheck disable=SC2046 # a list of words
cc -std=c99 "$sources/r/data-raw/pairs.c" -o pairs $(pkg-config --cflags --libs pw85) -Wl,-rpath,"$prefix/lib"
./pairs >expected
run_octave "pkg load pw85; addpath $sources/octave/tests; pairs" | diff - expected

echo '+ the bits of C, of pairs of all sizes'
(cd "$sources" && PW85_MEASURE_ONCE='' /usr/bin/python3 bench/languages.py build-octave C Octave)

echo '+ README'
# shellcheck disable=SC2016 # the marks of blocks
sed -n '/^```octave$/,/^```$/p' "$sources/octave/README.md" | sed '/^```/d; s/^\(pw85_overlap_area.*\) %.*/printf ("%.4f %.4f %g\\n", \1);/' >readme.m
# shellcheck disable=SC2016
sed -n '/^```text$/,/^```$/p' "$sources/octave/README.md" | sed '/^```/d' >expected
sed -n 's/^pw85_overlap_area.* % //p' "$sources/octave/README.md" >>expected
run_octave 'source readme.m' | diff - expected
grep -q "$(head -n 1 expected)" "$sources/examples/c/pair.txt"

echo '+ the tests of the package'
run_octave 'pkg test pw85' >test.log 2>&1 || { cat test.log fntests.log && exit 1; }
if ! grep -q 'FAIL  *0$' test.log || ! grep 'PASS  ' test.log; then cat fntests.log && exit 1; fi
for file in arguments truths; do
  run_octave "pkg load pw85; [n, all] = test ('$sources/octave/tests/$file.tst'); disp ([n, all]); exit (n ~= all || n == 0)"
done
# Each function is listed, and each one that is listed is there.
sed -n 's/^  //p' "$sources/octave/INDEX" | sort >listed
(cd "$sources/octave/inst" && ls -- *.m) | sed 's|\.m$||' | sort | diff - listed
