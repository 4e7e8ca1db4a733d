# Run in the root of the repository. Debian's default for libdir depends on the
# architecture; lib is the same everywhere.
set -e
# start
meson setup build --prefix="$HOME/.local" --libdir=lib \
  -Dtests=disabled -Dbench=disabled -Dpython=disabled
meson compile -C build
meson install -C build
# end
