#!/bin/sh
# Whether programs that were linked with the libraries of an earlier revision, by default the last release (a tag v*), can go on
# with those of this one: abidiff (package abigail-tools) finds no function that is gone and no type that has changed. New functions
# are no change. Usage: scripts/abi.sh [REVISION]
set -eu
cd "$(dirname "$0")/.."
revision=${1-$(git describe --tags --abbrev=0 --match 'v*' 2>/dev/null || true)}
if [ -z "$revision" ]; then
  echo "There is no release to compare with."
  exit 0
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# build SOURCE FOLDER: the shared libraries, with what abidiff reads
build() {
  if ! { meson setup "$2" "$1" --buildtype=debug -Doptimized=false -Dsimd=disabled -Ddefault_library=shared -Dtests=disabled \
    -Dbench=disabled -Dpython=disabled -Dfortran=disabled && meson compile -C "$2"; } >"$work/log"; then
    cat "$work/log"
    exit 1
  fi
}

# Inline functions of the standard library are nobody's concern.
printf '[suppress_function]\nsymbol_name_not_regexp = ^pw85\n' >"$work/suppressions"
mkdir "$work/source"
git archive "$revision" | tar -x -C "$work/source"
build "$work/source" "$work/before"
build . "$work/after"
for library in pw85 pw85_legacy; do
  status=0
  abidiff --suppressions "$work/suppressions" --headers-dir1 "$work/source/include" --headers-dir2 include "$work/before/src/lib$library.so" \
    "$work/after/src/lib$library.so" || status=$?
  # 4 says that something changed, 8 that it is incompatible, 1 and 2 that abidiff failed; without 8, a function of the API is as
  # it was, or new.
  [ "$((status & 11))" -eq 0 ] || { echo "lib$library.so: not compatible with $revision"; exit 1; }
done
echo "Compatible with $revision."
