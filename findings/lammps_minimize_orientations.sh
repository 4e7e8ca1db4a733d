#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The command minimize moves the centres of ellipsoids, but never turns them. It reports convergence with torques that are not zero.
#
# LAMMPS of 7 January 2022 (Debian 12, 20220106.git7586adbb6a+ds1-2+b2). Two Gay-Berne ellipsoids with the diameters 1, 1, 3, centres
# 2.2 apart along x, turned about y by 30 and -40 degrees; "minimize 0 1e-10", seen on 30 November 2026:
#
#   at the end of                   energy    norm of the forces   torques     turned by
#   min_style cg                    -1.0397   7e-13                +-0.23      30, -40
#   hftn, fire, quickmin            -1.0397   below 1e-10          +-0.23      30, -40
#   a damped run                    -1.6667   7e-15                0           -6, -6
#
# The norm of the forces, which is the criterion and the column fnorm, holds no torques, and there is no warning. The energy is a minimum at
# fixed orientations only.
# The damped run has the fixes nve/asphere and langevin, at the temperature 0 and with angmom 3.333.
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
cat >in.start <<'EOF'
units lj
atom_style ellipsoid
atom_modify map array
region box block -20 20 -20 20 -20 20
create_box 1 box
create_atoms 1 single 0 0 0
create_atoms 1 single 2.2 0 0
set group all shape 1 1 3
set group all density 1
set atom 1 quat 0 1 0 30
set atom 2 quat 0 1 0 -40
pair_style gayberne 1 1 1 8
pair_coeff * * 1 1 1 1 1 1 1 1
compute turned all property/atom quati quatj quatk tqy
variable first equal 360/PI*asin(c_turned[1][2])
variable second equal 360/PI*asin(c_turned[2][2])
variable torque equal c_turned[2][4]
variable energy equal pe
variable force equal fnorm
thermo_style custom step pe fnorm v_torque v_first v_second
thermo_modify norm no
include in.${end}
print "${end} energy ${energy} force ${force} torque ${torque} turned by ${first} ${second}" file result
EOF
for style in cg hftn fire quickmin; do
  printf 'min_style %s\nminimize 0 1e-10 100000 1000000\n' $style >in.$style
done
cat >in.damped <<'EOF'
fix move all nve/asphere
fix damping all langevin 0 0 0.5 1 angmom 3.333
timestep 0.005
run 20000
EOF
for end in cg hftn fire quickmin damped; do
  usr/bin/lmp -in in.start -log none -screen none -var end $end
  cat result
  awk -v damped="$( [ $end = damped ] && echo 1 || echo 0 )" '
    { turned = ($10 - 30)^2 + ($11 + 40)^2
      if (damped) exit !($3 < -1.6 && $7^2 < 1e-6 && turned > 1)
      exit !($3 > -1.05 && $5 < 1e-6 && $7^2 > 0.04 && turned < 1e-6) }' result
done
