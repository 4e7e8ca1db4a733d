#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The thermostat nvt/asphere keeps spheroids at 6/5 of the temperature that was asked for: it counts the spin about the axis of symmetry,
# which no pair of such bodies can change. Ellipsoids with three different axes get the right temperature.
#
# LAMMPS of 7 January 2022 (Debian 12, 20220106.git7586adbb6a+ds1-2+b2), 64 bodies with the pair style gayberne, at rest but for velocities
# at the start, at the temperature 1 (units lj). Means over steps 5000 to 25000, seen on 1 December 2026:
#
#   diameters   thermostat                        compute temp   compute temp/asphere   energy of rotation per body
#   1 1 2       nvt/asphere                       1.199          1.001                  1.21
#   1 1 2       nvt/asphere, extra/dof 67         1.001          0.829                  0.99
#   1 1.3 2     nvt/asphere                       0.995          0.994                  1.49
#
# True are 1 for compute temp, and k T/2 for each degree of freedom that takes part: 1 per spheroid, 1.5 per body of three axes. A spheroid
# has five of them, compute temp/asphere divides by six, and so all five have 6/5; the second row shows 5/6 of the true temperature in its
# column. "compute_modify ID_temp extra/dof N+3", with the ID of the fix and N spheroids, takes the spins out; the 3 is the momentum
# of the whole, which is left out by default. The documentation of compute temp/asphere warns of such bodies, but no message comes.
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
cat >in.bodies <<'EOF'
units lj
atom_style ellipsoid
lattice sc 0.1
region box block 0 4 0 4 0 4
create_box 1 box
create_atoms 1 box
set group all shape 1 ${width} 2
set group all quat/random 7
set group all mass 1
velocity all create 1 77 loop all
pair_style gayberne 1 3 1 3
pair_coeff 1 1 1 1 1 1 1 1 1 1 3
neighbor 0.5 bin
timestep 0.003
compute move all temp
compute both all temp/asphere
compute turn all erotate/asphere
fix bath all nvt/asphere temp 1 1 0.2
compute_modify bath_temp extra/dof ${extra}
variable each equal c_turn/count(all)
fix mean all ave/time 10 2000 25000 c_move c_both v_each file means start 5000
run 25000
EOF

# Width, degrees of freedom to leave out (3 is the default); temperatures of the centres and of both, energy of rotation per body. Seven
# starts with other velocities gave temperatures of the centres from 1.179 to 1.206, with the standard deviation 0.01. The bounds are 6 % away.
mean() {
  usr/bin/lmp -in in.bodies -log none -screen none -var width "$1" -var extra "$2"
  printf '1 %s 2, %s: ' "$1" "$2"
  tail -n 1 means
  awk -v move="$3" -v both="$4" -v each="$5" 'function off(x, y) { return x > 1.06 * y || x < 0.94 * y }
    END { exit off($2, move) || off($3, both) || off($4, each) }' means
}
mean 1 3 1.2 1 1.2
mean 1 67 1 0.8333 1
mean 1.3 3 1 1 1.5
