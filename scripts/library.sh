# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=sh
# For scripts that test the packages for other languages. install_library FOLDER PACKAGE... builds the library alone in a folder, and
# installs it into FOLDER/prefix, with the packages of Debian or Ubuntu that it and the caller need.
. scripts/packages.sh

install_library() {
  library_build=$1
  shift
  # shellcheck disable=SC2086,SC2154 # a list of words
  if command -v apt-get >/dev/null; then install_packages $build_packages libboost-dev "$@"; fi
  prefix=$PWD/$library_build/prefix
  [ -f "$library_build/build.ninja" ] || meson setup "$library_build" --prefix="$prefix" --libdir=lib -Dtests=disabled -Dbench=disabled \
    -Dpython=disabled -Dfortran=disabled -Dgsl=disabled -Dgpu=disabled -Ddefault_library=shared
  meson compile -C "$library_build"
  meson install -C "$library_build" --quiet
}
