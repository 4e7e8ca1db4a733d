# Run in the root of the repository, after build.sh with a Fortran compiler.
set -e
# start
export PKG_CONFIG_PATH="$HOME/.local/lib/pkgconfig"
gfortran examples/fortran/closest_approach.f90 -o closest_approach \
  $(pkg-config --cflags --libs pw85_fortran)
LD_LIBRARY_PATH="$HOME/.local/lib" ./closest_approach
# end
