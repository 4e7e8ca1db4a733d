# Run in the root of the repository.
set -e
# start
cmake --preset release
cmake --build --preset release
cmake --install build-cmake --prefix "$HOME/.local"
# end
