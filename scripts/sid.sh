#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Runs a tool that Debian 12 lacks, from the packages of Debian's suite sid. The first call unpacks them into build-sid; they are
# not installed. Usage: scripts/sid.sh ruff|auditwheel [ARGUMENT...]. The exit status is 77 if the tool is not available, or if sid
# has another minor version of ruff than that whose rules the sources follow.
set -eu
cd "$(dirname "$0")/.."
. scripts/packages.sh
. scripts/unpack.sh
root=$PWD/build-sid
architecture=$(dpkg --print-architecture)
if [ ! -f "$root/complete" ]; then
  if ! { open_packages "$root" "$architecture" sid && unpack_packages "$root" "$architecture" ruff python3-auditwheel libc6 libgcc-s1; }
  then
    echo "The packages of Debian's sid cannot be had." >&2
    exit 77
  fi
  touch "$root/complete"
fi
tool=$1
shift
case $tool in
ruff) # with the C library that it was linked with
  libraries=$(dirname "$(find "$root/usr/lib" -name libc.so.6)")
  set -- "$root/usr/bin/ruff" "$@"
  set -- "$(find "$libraries/" -name 'ld-linux*')" --library-path "$libraries" "$@"
  version=$("$1" "$2" "$3" "$4" --version)
  case $version in
  'ruff 0.16.'*) exec "$@" ;;
  *)
    echo "Debian's sid has $version by now." >&2
    exit 77
    ;;
  esac
  ;;
auditwheel)
  install_packages python3-pyelftools python3-packaging patchelf >&2
  PYTHONPATH=$root/usr/lib/python3/dist-packages exec /usr/bin/python3 -m auditwheel "$@"
  ;;
*)
  echo "$tool: not known" >&2
  exit 2
  ;;
esac
