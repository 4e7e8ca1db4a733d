#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The IDs that create_atoms gives to the sites of a lattice depend on the number of processors.
#
# LAMMPS of 7 January 2022 (Debian 12, 20220106.git7586adbb6a+ds1-2+b2), create_atoms on a simple cubic lattice of 6 x 6 x 6 sites. Seen on
# 29 November 2026: of 216 atoms, on 2 processors 0, on 4 processors 180, on 8 processors 210 are at another site than the atom with
# that ID on one processor. What is drawn by the ID differs then; orientations of "set quat/random" are drawn by the place, and are the
# same at each site. After "reset_atom_ids sort yes" the IDs are the same on 1, 4 and 8 processors.
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
cat >in.lattice <<'EOF'
units lj
atom_style ellipsoid
lattice sc 1.0
region box block 0 6 0 6 0 6
create_box 1 box
create_atoms 1 box
set group all shape 1 1 0.5
set group all density 1
if "${sort} == yes" then "reset_atom_ids sort yes"
set group all quat/random 12345
compute q all property/atom quatw quati quatj quatk
dump d all custom 1 ${out} id x y z c_q[1] c_q[2] c_q[3] c_q[4]
dump_modify d sort id
pair_style none
fix move all nve/asphere
run 0
EOF
for sort in no yes; do
  for processors in 1 4 8; do
    usr/bin/orterun --oversubscribe -np "$processors" usr/bin/lmp -in in.lattice -log none -screen none -var sort "$sort" \
      -var out "$sort.$processors"
    tail -n +10 "$sort.$processors" | cut -d ' ' -f 1-4 >sites
    tail -n +10 "$sort.$processors" | cut -d ' ' -f 2- | sort >turned
    [ "$processors" -gt 1 ] || cp sites "sites.$sort"
    [ "$processors" -gt 1 ] || cp turned "turned.$sort"
    echo "$sort $processors $(diff "sites.$sort" sites | grep -c '^<') $(diff "turned.$sort" turned | grep -c '^<')" | tee -a counts
  done
done
cat >expected <<'EOF'
no 1 0 0
no 4 180 0
no 8 210 0
yes 1 0 0
yes 4 0 0
yes 8 0 0
EOF
diff expected counts
