# Run in the root of the repository, after docs.sh. On Debian: apt-get install python3-matplotlib libbenchmark-dev and
# what the tests need. Have the machine to yourself.
set -e
# start
meson compile -C build-docs measurements
meson compile -C build-docs pictures
# end
