# Debian 12 or later, Ubuntu 24.04 or later.
# start
sudo apt-get install g++ meson pkg-config libgsl-dev            # the library
sudo apt-get install gfortran                                   # Fortran
sudo apt-get install python3-dev python3-numpy python3-click python3-tqdm   # Python
sudo apt-get install python3-venv python3-mesonpy libboost-dev  # its wheel
sudo apt-get install python3-matplotlib python3-h5py python3-gsd libjs-three # files
sudo apt-get install libglib2.0-dev libhdf5-dev libboost-dev libmpfr-dev    # tests
# end
