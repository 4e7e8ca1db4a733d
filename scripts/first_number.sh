#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# From nothing to the first number: installs the packages that a way to use pw85 needs, follows README and the chapter on installation in a
# copy of the sources, and says how long both took. WAY is pkg-config, cmake (FetchContent), meson (a subproject), pip, r (the R package),
# octave, rust or npm; without one, all of them, of which later ones find packages of earlier ones. In a system where nothing is installed:
#   scripts/test_release.sh bookworm scripts/first_number.sh cmake
set -eu
cd "$(dirname "$0")/.."
. scripts/packages.sh

# The lines of files of the chapter on installation.
follow() {
  for page in "$@"; do
    sed -n '/^# start/,/^# end/p' "docs/installation/$page.sh" >"$work/commands"
    (cd "$work/pw85" && HOME=$work sh -e "$work/commands")
  done
}

# The packages after the first `apt-get install` of a README, whose line may end between them.
named_by() {
  # shellcheck disable=SC2016 # the marks of words
  tr '\n' ' ' <"$1" | sed 's/.*run `apt-get install \([^`]*\)`.*/\1/'
}

by_pkg_config() {
  follow build pkg-config
}

by_pip() {
  follow python
}

# README's project.
by_cmake() {
  # shellcheck disable=SC2016 # the marks of the block
  sed -n '/^```cmake/,/^```$/p' README.md | sed '1d;$d' >"$work/CMakeLists.txt"
  ln -s pw85/examples "$work/"
  cmake -S "$work" -B "$work/build"
  cmake --build "$work/build" --parallel "$(nproc)"
  "$work/build/pair_c"
}

by_meson() {
  mkdir "$work/subprojects"
  ln -s ../pw85 "$work/subprojects/"
  ln -s pw85/examples "$work/"
  cat >"$work/meson.build" <<'END'
project('pair', 'c', 'cpp', default_options: ['buildtype=release'])
executable('pair', 'examples/c/pair.c', dependencies: dependency('pw85', fallback: 'pw85'))
END
  meson setup "$work/build" "$work"
  meson compile -C "$work/build"
  "$work/build/pair"
}

# The commands and the first program of the README of the R package.
by_r() {
  # shellcheck disable=SC2016 # the marks of blocks
  sed -n '/^```sh$/,/^```$/p' r/README.md | sed '/^```/d' >"$work/commands"
  # shellcheck disable=SC2016
  sed -n '/^```r$/,/^```$/p;/^```text$/q' r/README.md | sed '/^```/d' >"$work/pair.R"
  mkdir "$work/library"
  (cd "$work/pw85" && R_LIBS="$work/library" sh -e "$work/commands")
  R_LIBS="$work/library" Rscript "$work/pair.R"
}

# The commands and the first program of the README of the Octave package.
by_octave() {
  # shellcheck disable=SC2016 # the marks of blocks
  sed -n '/^```sh$/,/^```$/p' octave/README.md | sed '/^```/d' >"$work/commands"
  # shellcheck disable=SC2016
  sed -n '/^```octave$/,/^```$/p;/^```text$/q' octave/README.md | sed '/^```/d' >"$work/pair.m"
  (cd "$work/pw85" && HOME=$work sh -e "$work/commands")
  HOME=$work octave-cli "$work/pair.m"
}

# The commands and the first program of the README of the crate for Rust.
by_rust() {
  # shellcheck disable=SC2016 # the marks of blocks
  sed -n '/^```sh$/,/^```$/p' rust/pw85/README.md | sed '/^```/d' >"$work/commands"
  (cd "$work/pw85" && sh -e "$work/commands")
  # shellcheck disable=SC2016
  sed -n '/^```rust$/,/^```$/p;/^```text$/q' rust/pw85/README.md | sed '/^```/d' >"$work/pw85/rust/pw85/examples/pair.rs"
  PKG_CONFIG_PATH="$work/pw85/install/lib/pkgconfig" LD_LIBRARY_PATH="$work/pw85/install/lib" \
    cargo run --offline --manifest-path "$work/pw85/rust/Cargo.toml" --example pair
}

# The commands and the first program of the README of the npm package.
by_npm() {
  # shellcheck disable=SC2016 # the marks of blocks
  sed -n '/^```sh$/,/^```$/p' js/README.md | sed '/^```/d' >"$work/commands"
  (cd "$work/pw85" && HOME=$work sh -e "$work/commands")
  mkdir "$work/program"
  # shellcheck disable=SC2016
  sed -n '/^```js$/,/^```$/p;/^```text$/q' js/README.md | sed '/^```/d' >"$work/program/pair.mjs"
  (cd "$work/program" && HOME=$work npm install --offline --no-audit --no-fund "$work"/pw85/pw85-*.tgz && node pair.mjs)
}

[ $# -gt 0 ] || set -- pkg-config cmake meson pip r octave rust npm
for way in "$@"; do
  # shellcheck disable=SC2154 # of packages.sh
  case $way in
    pkg-config) packages=$build_packages ;;
    cmake) packages='gcc g++ cmake make libboost-dev' ;;
    meson) packages='gcc g++ meson ninja-build libboost-dev' ;;
    pip) packages="gcc g++ $python_packages" ;;
    r) packages="$build_packages $(named_by r/README.md)" ;;
    octave) packages="$build_packages $(named_by octave/README.md)" ;;
    rust) packages="$build_packages $(named_by rust/pw85/README.md)" ;;
    npm) packages=$(named_by js/README.md) ;;
    *) echo "usage: $0 [pkg-config] [cmake] [meson] [pip] [r] [octave] [rust] [npm]" >&2 && exit 2 ;;
  esac
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
  mkdir "$work/pw85"
  tar --exclude='./build*' --exclude=./.git --exclude=./install -c . | tar -x -C "$work/pw85"
  began=$(date +%s)
  # shellcheck disable=SC2086 # a list of words
  install_packages $packages >"$work/log" 2>&1
  installed=$(date +%s)
  # A subshell outside a condition, so that its first failing command ends it.
  set +e
  (set -e && "by_$(echo "$way" | tr - _)") >>"$work/log" 2>&1
  failed=$?
  set -e
  [ $failed -eq 0 ] || { cat "$work/log" && exit 1; }
  ended=$(date +%s)
  tail -n 2 "$work/log"
  echo "$way: $((installed - began)) seconds for packages, then $((ended - installed)) seconds on $(nproc) processors."
  rm -rf "$work"
done
