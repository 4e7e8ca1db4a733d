# Run in the root of the repository.
set -e
# start
meson setup build-test -Dtests=enabled
meson test -C build-test
# end
