#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The barostats npt/asphere and nph/asphere count the rotation of the bodies as pressure: a gas of free ellipsoids is kept at half the
# pressure that was asked for, in twice the volume. npt/sphere does the same with balls.
#
# LAMMPS of 7 January 2022 (Debian 12, 20220106.git7586adbb6a+ds1-2+b2). 300 bodies that do not interact, at the pressure 1 and the
# temperature 1 (units lj), where N k T / P = 300. Means over steps 4000 to 14000, seen on 30 November 2026:
#
#   fixes                                      volume   column press   pressure of the barostat
#   npt/asphere                                602                     0.998
#   nph/asphere and langevin (angmom)          599      0.503          1.001
#   these two and fix_modify press             303      0.996          1.982
#   npt/sphere                                 602                     0.995
#
# The barostat computes its pressure with a compute temp/asphere (temp/sphere) of its own. Two thirds of that kinetic energy, divided by
# the volume, are the ideal part of the pressure, although rotation moves no momentum. The pressure on a wall is then too low by
# N k T / V, at any density. The column press shows it, unless "thermo_modify temp" names such a compute as well.
# In the third row "fix_modify barostat press p" names the pressure of "compute p all pressure t" with "compute t all temp".
# Where press is left out, the bodies exchange no energy between translation and rotation, and only the sum of both is set.
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
cat >in.gas <<'EOF'
units lj
atom_style ${bodies}
region box block 0 8 0 8 0 8
create_box 1 box
create_atoms 1 random 300 1 NULL
include in.${bodies}
velocity all create 1 77 loop all
pair_style none
comm_modify cutoff 1
neigh_modify delay 0 every 10 check no
timestep 0.005
compute t all temp
compute p all pressure t
include in.${barostat}
compute own all pressure barostat_temp
variable v equal vol
variable press equal press
fix mean all ave/time 10 1000 14000 v_v v_press c_own c_t file means
thermo_style custom step press
run 14000
EOF
cat >in.ellipsoid <<'EOF'
set group all shape 1 1 3
set group all quat/random 7
set group all density 1
variable x atom random(-1,1,11)
variable y atom random(-1,1,12)
variable z atom random(-1,1,13)
set group all angmom v_x v_y v_z
EOF
cat >in.sphere <<'EOF'
set group all diameter 1
set group all density 1
variable x atom random(-3,3,11)
variable y atom random(-3,3,12)
variable z atom random(-3,3,13)
set group all omega v_x v_y v_z
EOF
echo 'fix barostat all npt/asphere temp 1 1 0.5 iso 1 1 2' >in.npt
echo 'fix barostat all npt/sphere temp 1 1 0.5 iso 1 1 2' >in.spheres
{
  echo 'fix barostat all nph/asphere iso 1 1 2'
  echo 'fix bath all langevin 1 1 1 5 angmom 3.333'
} >in.nph
{
  cat in.nph
  echo 'fix_modify barostat press p'
} >in.modified

# Bodies, settings; volume, pressures by the output and by the barostat.
mean() {
  usr/bin/lmp -in in.gas -log none -screen none -var bodies "$1" -var barostat "$2"
  printf '%s %s: ' "$1" "$2"
  tail -1 means
  awk -v volume="$3" -v press="$4" -v own="$5" 'function off(x, y) { return x > 1.1 * y || x < 0.9 * y }
    END { exit off($2, volume) || (press > 0 && off($3, press)) || off($4, own) }' means
}
mean ellipsoid npt 600 -1 1
mean ellipsoid nph 600 0.5 1
mean ellipsoid modified 300 1 2
mean sphere spheres 600 -1 1
