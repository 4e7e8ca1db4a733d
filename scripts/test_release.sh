#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Runs README's two commands, or COMMAND instead, in a minimal system of another release of Debian or Ubuntu:
#   scripts/test_release.sh RELEASE [COMMAND...]       RELEASE is trixie, noble, ...
# The system is the folder build-RELEASE, and its /pw85 has the files that git tracks. The folder is kept, and the next run
# continues with it. The script needs root and mmdebstrap, for a release of Ubuntu also distro-info-data and ubuntu-archive-keyring.
set -eu
cd "$(dirname "$0")/.."
. scripts/minimal_system.sh
release=${1:?usage: $0 RELEASE [COMMAND...]}
shift
[ $# -gt 0 ] || set -- sh -c 'scripts/tutorial.sh && scripts/test.sh'

make_system "$release"
mkdir -p "$system/pw85"
list_sources | tar --null --files-from=- -c | tar -x -C "$system/pw85"
run_in_system "$system" /pw85 "$@"
