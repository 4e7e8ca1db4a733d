set -e
# start version
pkg-config --modversion pw85
# end version
# start compile
cc program.c $(pkg-config --cflags --libs pw85_legacy) -lm -o program
./program
# end compile
# start links
libdir=$(pkg-config --variable=libdir pw85)
mkdir compatible
ln -s "$libdir/libpw85.so.3" compatible/libpw85.so
ln -s "$libdir/libpw85_legacy.so.3" compatible/libpw85_legacy.so
LD_LIBRARY_PATH=compatible:$libdir ./old_program
# end links
