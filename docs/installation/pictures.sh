# Run in the root of the repository, after docs.sh. On Debian: apt-get install python3-matplotlib python3-h5py.
set -e
# start
meson compile -C build-docs measurements
meson compile -C build-docs pictures
# end
