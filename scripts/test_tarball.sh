#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Makes the tarball of a release, and runs README's test command, or COMMAND instead, in the unpacked tarball, in a minimal system of
# Debian or Ubuntu. Packages are installed before; the command has no network:
#   scripts/test_tarball.sh RELEASE [COMMAND...]       RELEASE is bookworm, trixie, ...
# The system is the folder build-RELEASE, as in scripts/test_release.sh.
set -eu
cd "$(dirname "$0")/.."
. scripts/minimal_system.sh
release=${1:?usage: $0 RELEASE [COMMAND...]}
shift
[ $# -gt 0 ] || set -- scripts/test.sh

scripts/make_tarball.sh
make_system "$release"
folder=/$(basename build-dist/meson-dist/*.tar.gz .tar.gz)
rm -rf "${system:?}$folder"
tar -xf build-dist/meson-dist/*.tar.gz -C "$system"

# shellcheck disable=SC2016 # expanded in the system
run_in_system "$system" "$folder" sh -euc '. scripts/packages.sh && install_packages $test_packages'
offline=yes
run_in_system "$system" "$folder" "$@"
