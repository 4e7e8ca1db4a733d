#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Builds pw85 with its tests for another machine, one of scripts/cross/ for which there is a Debian, and runs them by an emulator.
# The libraries that the tests need come from Debian's packages for that machine. They are unpacked next to the build; only
# compilers and emulator are installed. Usage: scripts/test_cross.sh aarch64-linux-gnu|i686-linux-gnu|s390x-linux-gnu [ARGUMENT OF
# meson test...]
set -eu
cd "$(dirname "$0")/.."
. scripts/packages.sh
. scripts/unpack.sh
machine=$1
shift
build=$PWD/build-$machine
root=$build-root
libraries=$machine
emulators=qemu-user
case $machine in
aarch64-linux-gnu)
  architecture=arm64
  emulator="['qemu-aarch64', '-L', '$root']"
  ;;
s390x-linux-gnu)
  architecture=s390x
  emulator="['qemu-s390x', '-L', '$root']"
  ;;
i686-linux-gnu)
  architecture=i386 libraries=i386-linux-gnu
  emulator="['$root/lib/ld-linux.so.2', '--library-path', '$root/lib/i386-linux-gnu:$root/usr/lib/i386-linux-gnu']"
  emulators=
  ;;
*)
  echo "$machine: not known" >&2
  exit 2
  ;;
esac
# shellcheck disable=SC2086 # a list of words
install_packages $test_packages "g++-$machine" $emulators

if [ ! -f "$root/complete" ]; then
  open_packages "$root" "$architecture" || true # one of several sources may be unavailable
  mkdir -p "$root/boost/include"
  ln -s /usr/include/boost "$root/boost/include/boost" # the headers, which are the same on all machines
  packages=$(apt_in "$root" "$architecture" install -s libglib2.0-dev libhdf5-dev libmpfr-dev libgsl-dev libgomp1 libstdc++6 |
    sed -n 's/^Inst \([^ ]*\).*/\1/p' | grep -E '^(lib|zlib)' | grep -v -E 'python|^libc6-dev|^libc-dev|^libperl')
  # shellcheck disable=SC2086 # a list of words
  unpack_packages "$root" "$architecture" $packages
  cat >"$root/machine.ini" <<END
[binaries]
pkgconfig = 'pkg-config'
exe_wrapper = $emulator

[properties]
sys_root = '$root'
pkg_config_libdir = '$root/usr/lib/$libraries/pkgconfig'

[built-in options]
c_link_args = ['-Wl,-rpath-link,$root/usr/lib/$libraries:$root/lib/$libraries']
cpp_link_args = ['-Wl,-rpath-link,$root/usr/lib/$libraries:$root/lib/$libraries']
END
  touch "$root/complete"
fi
# shellcheck disable=SC2086 # a list of words
[ -f "$build/build.ninja" ] || BOOST_ROOT=$root/boost meson setup "$build" --cross-file "scripts/cross/$machine.ini" \
  --cross-file "$root/machine.ini" -Dtests=enabled -Dgpu=disabled -Dbench=disabled -Dpython=disabled -Dfortran=disabled \
  ${PW85_SETUP_OPTIONS-}
exec meson test -C "$build" --print-errorlogs --no-suite install --timeout-multiplier 10 "$@"
