# Run in the root of the repository, after debian.sh. For the tests of the pages also
# hunspell hunspell-en-gb nodejs chromium chromium-driver python3-selenium.
set -e
# start
sudo apt-get install doxygen furo python3-breathe python3-sphinx # Debian, Ubuntu
sudo apt-get install python3-sphinx-inline-tabs python3-sphinx-copybutton
sudo apt-get install python3-myst-parser libjs-katex libjs-three libboost-dev
sudo apt-get install clang lld llvm binaryen libc++-dev-wasm32 libclang-rt-dev-wasm32
meson setup build-docs -Ddocs=enabled
meson compile -C build-docs docs
# end
