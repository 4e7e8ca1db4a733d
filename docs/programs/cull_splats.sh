#!/bin/sh
# Prints what culling a million splats takes on this machine: run it in the root of the repository, with pypw85 on PYTHONPATH.
set -eu
date +"Measured on %Y-%m-%d, $(nproc) threads,$(lscpu | sed -n 's/^Model name: */ /p')"
exec python3 examples/python/cull_splats.py --times 1000000
