# SPDX-License-Identifier: BSD-3-Clause
# The other scripts source this file. It unpacks Debian packages for another machine or of another suite into a folder, without
# installing them.

# apt_in FOLDER ARCHITECTURE COMMAND...: runs apt-get for another machine, independently of the packages of this one
apt_in() (
  apt=$1/apt architecture=$2
  shift 2
  sources=
  [ ! -f "$apt/sources.list" ] || sources="-o Dir::Etc::sourcelist=$apt/sources.list -o Dir::Etc::sourceparts=-"
  # shellcheck disable=SC2086 # a list of words
  exec apt-get -qq $sources -o "APT::Architecture=$architecture" -o "APT::Architectures=$architecture" -o APT::Sandbox::User= \
    -o "Dir::State=$apt" -o "Dir::State::status=$apt/status" -o "Dir::Cache=$apt" -o Acquire::Languages=none \
    -o Acquire::Retries=3 -o APT::Install-Recommends=0 "$@"
)

# open_packages FOLDER ARCHITECTURE [SUITE]: makes an empty FOLDER, and fetches the lists of packages for apt_in, of this system's
# suites or of another suite
open_packages() {
  rm -rf "$1"
  mkdir -p "$1/apt/lists/partial"
  : >"$1/apt/status"
  [ $# -lt 3 ] || echo "deb http://deb.debian.org/debian $3 main" >"$1/apt/sources.list"
  apt_in "$1" "$2" update
}

# unpack_packages FOLDER ARCHITECTURE PACKAGE...
unpack_packages() (
  folder=$1 architecture=$2
  shift 2
  cd "$folder/apt" && apt_in "$folder" "$architecture" download "$@" || exit
  for package in *.deb; do dpkg -x "$package" "$folder" || exit; done
  rm -r "$folder/apt"
)
