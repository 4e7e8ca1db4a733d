#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Builds the styles for LAMMPS, and runs their tests, with the LAMMPS of another release of Debian:
#   scripts/test_lammps.sh RELEASE       RELEASE is trixie (13), ...; see scripts/test_release.sh
# It exits with 77 if there is no such system and the tool that makes it is missing.
set -eu
cd "$(dirname "$0")/.."
release=${1:?usage: $0 RELEASE}
[ -d "build-$release" ] || command -v mmdebstrap >/dev/null || exit 77

# shellcheck disable=SC2016 # expanded by the inner shell
exec scripts/test_release.sh "$release" sh -euc '
  . scripts/packages.sh
  install_packages $build_packages cmake gfortran binutils patchelf libglib2.0-dev libhdf5-dev libboost-dev libmpfr-dev \
    lammps liblammps-dev libfmt-dev python3-lammps openmpi-bin libopenmpi-dev \
    python3-dev python3-numpy python3-scipy python3-matplotlib python3-h5py python3-pytest python3-gsd python3-click python3-tqdm \
    python3-pandas python3-nbclient python3-ipykernel
  [ -f build-lammps/build.ninja ] || meson setup build-lammps -Dtests=enabled -Dbench=disabled -Dgpu=disabled \
    -Dfortran=disabled -Dpython=disabled -Ddefault_library=shared -Dlammps=enabled
  exec meson test -C build-lammps --suite lammps --print-errorlogs --timeout-multiplier 10'
