# macOS with Homebrew.
# start
brew install gcc meson pkg-config gsl        # the library; gcc has OpenMP and Fortran
brew install python numpy boost              # Python
brew install glib hdf5 boost                 # tests
BOOST_ROOT=$(brew --prefix boost)            # on Apple's processors Meson does not find it by itself
export BOOST_ROOT
# end
