# Windows: in the UCRT64 shell of MSYS2.
# start
pacman -S mingw-w64-ucrt-x86_64-gcc mingw-w64-ucrt-x86_64-meson
pacman -S mingw-w64-ucrt-x86_64-pkgconf mingw-w64-ucrt-x86_64-gsl
pacman -S mingw-w64-ucrt-x86_64-gcc-fortran mingw-w64-ucrt-x86_64-python-numpy
pacman -S mingw-w64-ucrt-x86_64-glib2 mingw-w64-ucrt-x86_64-hdf5
pacman -S mingw-w64-ucrt-x86_64-boost mingw-w64-ucrt-x86_64-mpfr
pacman -S mingw-w64-ucrt-x86_64-python-click mingw-w64-ucrt-x86_64-python-tqdm
# end
