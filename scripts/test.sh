#!/bin/sh
# Builds pw85 with its tests in ./build-test and runs all tests. On Debian and Ubuntu it first installs the missing packages that
# the tests need. It can be run again at any time. Arguments are passed to `meson test`, the words of PW85_SETUP_OPTIONS to `meson
# setup`.
set -eu
cd "$(dirname "$0")/.."
. scripts/packages.sh
# shellcheck disable=SC2086 # a list of words
if command -v apt-get >/dev/null; then install_packages $test_packages; fi

build=$PWD/build-test
# shellcheck disable=SC2086 # a list of words
[ -f "$build/build.ninja" ] || meson setup "$build" -Dtests=enabled -Dbench=disabled ${PW85_SETUP_OPTIONS-}
meson compile -C "$build"
exec meson test -C "$build" --print-errorlogs "$@"
