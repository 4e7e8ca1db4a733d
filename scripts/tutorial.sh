#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Builds pw85, with the Fortran module if there is a compiler for it, installs it into ./install, builds the C tutorial (examples/c)
# with the installed library, and runs it. On Debian and Ubuntu it first installs the missing packages that it needs, by apt-get as
# root or through sudo. It can be run again at any time, and then finds compilers that were installed in the meantime. The words of
# PW85_SETUP_OPTIONS are passed to `meson setup`.
set -eu
cd "$(dirname "$0")/.."
. scripts/packages.sh
# shellcheck disable=SC2086 # a list of words
if command -v apt-get >/dev/null; then install_packages $build_packages; fi

prefix=$PWD/install
build=$PWD/build-install
if [ -f "$build/build.ninja" ]; then
  meson setup --reconfigure "$build"
else
  # shellcheck disable=SC2086 # a list of words
  meson setup "$build" --prefix="$prefix" --libdir=lib -Dtests=disabled -Dbench=disabled -Dpython=disabled \
    -Ddefault_library=shared -Djoined=true ${PW85_SETUP_OPTIONS-}
fi
meson compile -C "$build"
meson install -C "$build"

tutorial=$PWD/build-tutorial
[ -f "$tutorial/build.ninja" ] ||
  meson setup "$tutorial" examples/c -Dpw85_include="$prefix/include" -Dpw85_lib="$prefix/lib"
meson compile -C "$tutorial"
echo
echo "pw85 is installed in $prefix. README.md, section Languages, shows how to compile your own programs."
echo "The tutorial prints:"
echo
LD_LIBRARY_PATH="$prefix/lib" "$tutorial/tutorial"
