#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Runs README's two commands, or COMMAND instead, in a minimal system of another release of Debian or Ubuntu:
#   scripts/test_release.sh RELEASE [COMMAND...]       RELEASE is trixie, noble, ...
# The system is the folder build-RELEASE, and its /pw85 has the files that git tracks. The folder is kept, and the next run
# continues with it. The script needs root and mmdebstrap, for a release of Ubuntu also distro-info-data and ubuntu-archive-keyring.
set -eu
cd "$(dirname "$0")/.."
release=${1:?usage: $0 RELEASE [COMMAND...]}
shift
[ $# -gt 0 ] || set -- sh -c 'scripts/tutorial.sh && scripts/test.sh'
system=$PWD/build-$release

if [ ! -d "$system" ]; then
  rm -rf "$system.unfinished"
  # Minimal systems of Ubuntu lack apt. Only Ubuntu has the component universe; other archives ignore it.
  mmdebstrap --variant=minbase --include=apt --components=main,universe "$release" "$system.unfinished"
  mv "$system.unfinished" "$system"
fi

mkdir -p "$system/pw85"
git ls-files -z | tar --null --files-from=- -c | tar -x -C "$system/pw85"
# The mounts and processes of the command end with the command.
# shellcheck disable=SC2016 # expanded by the inner shell
exec unshare --mount --pid --fork --kill-child sh -euc '
  mount -t proc proc "$0/proc"
  mount --rbind /sys "$0/sys"
  mount -t devpts -o newinstance,ptmxmode=666 devpts "$0/dev/pts"
  exec chroot "$0" env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin PW85_SETUP_OPTIONS="${PW85_SETUP_OPTIONS-}" \
    sh -c "cd /pw85 && exec \"\$@\"" sh "$@"' "$system" "$@"
