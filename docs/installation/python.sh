# Run in the root of the repository. On Debian: apt-get install python3-pip python3-mesonpy python3-numpy python3-dev.
set -e
# start
python3 -m pip install --no-build-isolation .
# end
