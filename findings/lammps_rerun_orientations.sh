#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The command rerun reads the positions of each snapshot, but keeps the initial orientations of ellipsoids, without a warning. Energies,
# torques and overlaps are those of bodies that do not rotate.
#
# LAMMPS of 7 January 2022 (Debian 12, 20220106.git7586adbb6a+ds1-2+b2). Two Gay-Berne ellipsoids (1, 1, 3) turn freely; the dump has their
# positions and quaternions. Potential energy of the snapshots, seen on 30 November 2026:
#
#   step    run            rerun ... dump x y z
#      0    -0.0512695    -0.0512695
#    500    -0.517633     -0.129359
#   1000    -0.0941356    -0.122468
#
# The quaternions that the rerun writes are 1 0 0 0 in each snapshot. read_dump, which rerun calls, keeps the old orientations too; it has
# no field for quaternions: "quatw" is an illegal command. The documentation says that other properties, such as charges, come from a data
# file; orientations, which differ in each snapshot, are not named.
# What helps: a data file of each snapshot (write_data), read by read_data and followed by "run 0".
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
cat >in.settings <<'EOF'
pair_coeff * * 1.0 1.0 1 1 1 1 1 1
compute q all property/atom quatw quati quatj quatk
thermo_style custom step pe
thermo_modify format float %.8g
thermo 500
dump d all custom 500 ${out} id x y z c_q[1] c_q[2] c_q[3] c_q[4]
dump_modify d sort id format float %.17g
EOF
cat >in.run <<'EOF'
units lj
atom_style ellipsoid
region box block -10 10 -10 10 -10 10
create_box 1 box
create_atoms 1 single 0 0 0
create_atoms 1 single 0 2 0
set group all shape 1 1 3
set group all density 1
set atom 1 angmom 0.3 0.2 0.1
set atom 2 angmom -0.2 0.5 0.1
pair_style gayberne 1.0 1.0 1.0 8.0
include in.settings
fix move all nve/asphere
timestep 0.002
write_data start.data
run 1000
write_data end.data
EOF
cat >in.rerun <<'EOF'
units lj
atom_style ellipsoid
pair_style gayberne 1.0 1.0 1.0 8.0
read_data start.data
include in.settings
rerun run.dump dump x y z box no
EOF
cat >in.snapshot <<'EOF'
units lj
atom_style ellipsoid
pair_style gayberne 1.0 1.0 1.0 8.0
read_data end.data
include in.settings
run 0
EOF
cat >in.field <<'EOF'
units lj
atom_style ellipsoid
pair_style gayberne 1.0 1.0 1.0 8.0
read_data start.data
read_dump run.dump 1000 x y z quatw
EOF
for name in run rerun snapshot; do
  usr/bin/lmp -in in.$name -log log.$name -screen none -var out $name.dump
  awk '$1 == "Step" { on = 1; next } $1 == "Loop" { on = 0 } on' log.$name >energies.$name
  awk 'NF == 8 { print $5, $6, $7, $8 }' $name.dump >turns.$name
done
usr/bin/lmp -in in.field -log log.field -screen none >field 2>&1 && exit 1
grep -q "Illegal read_dump command" log.field
echo "run" && cat energies.run && echo "rerun" && cat energies.rerun && echo "snapshot" && cat energies.snapshot
echo "last quaternions of the run:" && tail -n 2 turns.run && echo "of the rerun:" && tail -n 2 turns.rerun
grep -i "orient\|quat\|ellips" log.rerun | grep -i warning && exit 1
[ "$(sort -u turns.rerun)" = "1 0 0 0" ]
[ "$(wc -l <turns.rerun)" -eq 6 ]
awk 'FNR == NR { was[$1] = $2; next }
  $1 in was { ratio[$1] = $2 / was[$1] }
  END { if (!(ratio[0] > 0.9999 && ratio[0] < 1.0001 && ratio[500] < 0.5 && ratio[1000] > 1.1)) exit 1 }' energies.run energies.rerun
awk 'FNR == NR { last = $2; next } END { if (!($2 / last > 0.9999 && $2 / last < 1.0001)) exit 1 }' energies.run energies.snapshot
