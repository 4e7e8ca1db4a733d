# Run in the root of the repository, after build.sh.
set -e
# start
export PKG_CONFIG_PATH="$HOME/.local/lib/pkgconfig"
cc -std=c99 examples/c/tutorial.c -o tutorial $(pkg-config --cflags --libs pw85) -lm
LD_LIBRARY_PATH="$HOME/.local/lib" ./tutorial
# end
