# SPDX-License-Identifier: BSD-3-Clause
# The other scripts source this file. It installs the Debian or Ubuntu packages that are missing.

# install_packages PACKAGE...
install_packages() {
  missing=
  for package in "$@"; do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing="$missing $package"
  done
  [ -z "$missing" ] && return 0
  as_root=
  [ "$(id -u)" -eq 0 ] || as_root=sudo
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get update -qq || return
  # shellcheck disable=SC2086 # a list of words
  available=$(LC_ALL=C apt-cache policy $missing | awk -F: '/^[^ ]/ { name = $1 } /Candidate: [^(]/ { print name }')
  # Packages that a release does not have are left out, and the tests that need them are skipped. Ubuntu 24.04, for example, has no
  # PyTorch, and has Chromium only as a snap.
  # shellcheck disable=SC2086 # a list of words
  absent=$(printf '%s\n' $missing | grep -vxF "$available" || true)
  [ -z "$absent" ] || echo "Not in this release:" $absent
  [ -n "$available" ] || return 0
  echo "Installing packages:" $available
  # shellcheck disable=SC2086 # a list of words
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $available
}

build_packages='gcc g++ meson ninja-build pkg-config libgsl-dev'
# README's, for the Python package, and what its tests need.
python_packages='python3-dev python3-venv python3-numpy python3-mesonpy python3-click python3-tqdm libboost-dev'
python_test_packages='python3 python3-pytest python3-h5py python3-gsd libjs-three chromium-driver python3-selenium python3-nbclient
  python3-ipykernel python3-matplotlib python3-dask python3-pandas python3-xarray python3-scipy python3-torch python3-meshio python3-ase
  python3-zstandard python3-mdanalysis mypy'
test_packages="$build_packages $python_packages $python_test_packages ccache python3-pip patchelf cmake gfortran binutils libglib2.0-dev
  libhdf5-dev libmpfr-dev libx11-dev libeigen3-dev libtbb-dev python3-yaml"
# Those of scripts/test_r.sh; devscripts has checkbashisms.
r_packages='r-base-core r-base-dev r-cran-testthat r-cran-knitr r-cran-rmarkdown devscripts'
# Those of scripts/test_octave.sh.
octave_packages='octave octave-dev make'
# Those of scripts/build_npm.sh, and of scripts/test_npm.sh, which installs npm, too, where nodejs comes without it.
wasm_packages='clang lld llvm binaryen libc++-dev-wasm32 libclang-rt-dev-wasm32 libboost-dev meson ninja-build'
npm_packages="$wasm_packages nodejs python3 chromium chromium-driver python3-selenium node-typescript"
# Those of scripts/test_rust.sh.
rust_packages='rustc cargo rustfmt rust-clippy'
