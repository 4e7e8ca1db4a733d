# macOS with Homebrew.
# start
brew install gcc meson pkg-config gsl        # the library; gcc has OpenMP and Fortran
brew install python numpy boost              # Python
brew install glib hdf5 boost mpfr               # tests
BOOST_ROOT=$(brew --prefix boost)            # Meson does not look there by itself
export BOOST_ROOT
# end
