#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Builds pw85 with its tests in ./build-test and runs the tests. On Debian and Ubuntu it first installs the missing packages that
# the tests need, by apt-get as root or through sudo. It can be run again at any time. Arguments are passed to `meson test`, the words
# of PW85_SETUP_OPTIONS to `meson setup`.
set -eu
cd "$(dirname "$0")/.."
. scripts/packages.sh
# shellcheck disable=SC2086 # a list of words
if command -v apt-get >/dev/null; then install_packages $test_packages; fi

build=$PWD/build-test
# Tests of installations compile the library again; ccache gives them the objects of this build. It learns from the compiler which
# headers a unit has, and so does not run the preprocessor before.
export CCACHE_DIR="${CCACHE_DIR:-$build/ccache}" CCACHE_NOHASHDIR=1 CCACHE_DEPEND=1
export CCACHE_SLOPPINESS=include_file_mtime,include_file_ctime,pch_defines,time_macros
export CCACHE_IGNOREOPTIONS='-Werror -DBOOST_ALL_NO_LIB'
export PIP_CONFIG_SETTINGS="${PIP_CONFIG_SETTINGS:-builddir=build-wheel}" # with the same relative paths
# shellcheck disable=SC2086 # a list of words
[ -f "$build/build.ninja" ] || meson setup "$build" -Dtests=enabled -Dbench=disabled ${PW85_SETUP_OPTIONS-}
meson compile -C "$build"
status=0
meson test -C "$build" --print-errorlogs "$@" || status=$?
[ $# -gt 0 ] || cat <<END

These were the tests that a change needs. Others, by name:
  scripts/test.sh --suite thorough         the same with three eighths of the random inputs, not one
  scripts/test.sh --suite wheel            wheels, and the interpreters for which the Python package is built
  scripts/test.sh --suite whole            all random inputs, whole proofs and long sweeps
  scripts/test.sh --suite SUITE            one of: $(meson introspect --tests "$build" | tr ',' '\n' | sed -n 's/.*"pw85:\([a-z]*\)".*/\1/p' | sort -u | tr '\n' ' ')
  .ci/run list                             checks beyond tests: sanitizers, other machines, packages
END
exit $status
