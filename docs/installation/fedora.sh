# Fedora 38 or later.
# start
sudo dnf install gcc-c++ meson pkgconf-pkg-config gsl-devel     # the library
sudo dnf install gcc-gfortran python3-devel python3-numpy boost-devel # bindings
sudo dnf install python3-click python3-tqdm                     # the command
sudo dnf install python3-matplotlib python3-h5py                # files; gsd is on PyPI
sudo dnf install glib2-devel hdf5-devel boost-devel mpfr-devel  # tests
# end
