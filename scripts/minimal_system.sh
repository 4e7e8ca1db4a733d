# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=sh
# Other scripts source this file. It makes minimal systems of Debian or Ubuntu, and runs commands in them. Both need root.

# make_system RELEASE: makes the folder build-RELEASE unless it is there. It needs mmdebstrap, for a release of Ubuntu also
# distro-info-data and ubuntu-archive-keyring.
make_system() {
  system=$PWD/build-$1
  [ ! -d "$system" ] || return 0
  rm -rf "$system.unfinished"
  # Minimal systems of Ubuntu lack apt. Only Ubuntu has the component universe; other archives ignore it.
  mmdebstrap --variant=minbase --include=apt --components=main,universe "$1" "$system.unfinished"
  mv "$system.unfinished" "$system"
}

# list_sources: the files that git tracks, or all sources where there is no repository, as in the folder of a tarball. Each name ends
# with a null character.
list_sources() {
  if [ -e .git ]; then
    git ls-files -z
  else
    find . \( -path './build*' -o -path ./install -o -name __pycache__ -o -path './.mesonpy*' \) -prune -o ! -type d -printf '%P\0'
  fi
}

# run_in_system SYSTEM FOLDER COMMAND...: runs a command in a folder of a system, whose path begins with the root of that system. The
# mounts and processes of the command end with the command. If `offline` is not empty, there is no network but the loopback device.
run_in_system() {
  # shellcheck disable=SC2016 # expanded by the inner shell
  unshare --mount --pid --fork --kill-child ${offline:+--net} sh -euc '
    offline=$1 system=$2 folder=$3
    shift 3
    [ -z "$offline" ] || ip link set lo up
    mount -t proc proc "$system/proc"
    mount --rbind /sys "$system/sys"
    mount -t devpts -o newinstance,ptmxmode=666 devpts "$system/dev/pts"
    exec chroot "$system" env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin PW85_SETUP_OPTIONS="${PW85_SETUP_OPTIONS-}" \
      sh -c "cd \"\$0\" && exec \"\$@\"" "$folder" "$@"' sh "${offline-}" "$@"
}
