#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# If "set density" comes before "set shape", its number is the mass of the ellipsoid, not the density, and the data file states another
# density.
#
# LAMMPS of 7 January 2022 (Debian 12, 20220106.git7586adbb6a+ds1-2+b2), two ellipsoids with the diameters 1, 2, 3 (volume pi) and
# "density 2", seen on 30 November 2026:
#
#   set density, then shape    mass 2          density in the file of write_data 0.63662
#   set shape, then density    mass 6.28319    2
#
# Atoms begin as points, and the density of a point is its mass; "set shape" keeps masses. Kinetic energies, moments of
# inertia and frequencies follow the mass. There is no warning.
# Needs apt-get; MPI runs on one machine.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"
version=20220106.git7586adbb6a+ds1-2+b2
missing=$(apt-get install -s --no-install-recommends lammps=$version 2>/dev/null | awk '/^Inst/ { print $2 }' | grep -v lammps-data || true)
# shellcheck disable=SC2086 # a list of words
apt-get download -qq lammps=$version liblammps0=$version openmpi-bin openmpi-common libopenmpi3 $missing 2>/dev/null
for package in *.deb; do dpkg -x "$package" .; done
libraries=$dir/usr/lib/x86_64-linux-gnu
export LD_LIBRARY_PATH="$libraries:$libraries/openmpi/lib" OPAL_PREFIX="$dir/usr"
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_btl=self,vader OMPI_MCA_btl_vader_single_copy_mechanism=none
export OMP_NUM_THREADS=1
cat >in.order <<'EOF'
units lj
atom_style ellipsoid
region box block -10 10 -10 10 -10 10
create_box 1 box
create_atoms 1 single 0 0 0
create_atoms 1 single 0 5 0
set atom 1 density 2
set group all shape 1 2 3
set atom 2 density 2
pair_style zero 5
pair_coeff * *
dump d all custom 1 masses id mass
dump_modify d sort id
fix move all nve/asphere
run 0
write_data out.data
EOF
usr/bin/lmp -in in.order -log log.order -screen none
tail -n 2 masses
sed -n '/^Atoms/,/^Velocities/p' out.data | awk 'NF > 6 { print $1, "density", $4 }' | sort | tee densities
awk 'NF == 2 && $1 == 1 { one = $2 } NF == 2 && $1 == 2 { two = $2 }
  END { if (!(one == 2 && two > 6.283 && two < 6.2833)) exit 1 }' masses
awk '$1 == 1 { one = $3 } $1 == 2 { two = $3 }
  END { if (!(one > 0.63661 && one < 0.63663 && two > 1.9999 && two < 2.0001)) exit 1 }' densities
if grep -i warning log.order | grep -i "density\|shape\|mass"; then exit 1; fi
