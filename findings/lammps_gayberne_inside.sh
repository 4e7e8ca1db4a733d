#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Two Gay-Berne ellipsoids that overlap deeply, one behind the other, attract each other. A minimisation leaves them so, with exactly the
# energy of a pair that touches.
#
# LAMMPS of 7 January 2022 (Debian 12, 20220106.git7586adbb6a+ds1-2+b2), gayberne 1 1 1 8, all coefficients 1. Two parallel ellipsoids
# with the diameters 1, 1, 3, the centres z apart along the longest axis (they touch at 3), seen on 30 November 2026:
#
#   z        energy     force on the second along z
#   3.5      -0.534         -1.930    attraction
#   3.1225   -1.667         -0.004
#   2.5      26880          650240    repulsion
#   2.1      6.7e12         8.0e14
#   1.9      6.7e12        -8.0e14    attraction
#   1.5      26880         -650240
#   0.8775   -1.667          0.004
#   0.5      -0.534          1.930
#
# The potential has even powers of sigma/(h + gamma sigma), where h is the gap, z - 3 here. It is infinite at h = -gamma sigma, and is
# the same on both sides of z = 2. A gap below -sigma needs more than one diameter of overlap, which balls do not reach.
# Of 500 random places of a parallel pair that overlaps, minimize ends with an overlap at about 48. All 500 have the same energy then.
# Whether bodies overlap must be tested by their geometry.
# Needs apt-get, python3-numpy; MPI runs on one machine.
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
cat >in.pair <<'EOF'
variable z index 0.5 0.8775 1 1.5 1.9 2.1 2.5 3 3.1225 3.5
label next
clear
units lj
atom_style ellipsoid
atom_modify map array
region box block -20 20 -20 20 -20 20
create_box 1 box
create_atoms 1 single 0 0 0
create_atoms 1 single 0 0 ${z}
set group all shape 1 1 3
set group all density 1
set group all quat 0 0 1 0
pair_style gayberne 1 1 1 8
pair_coeff * * 1 1 1 1 1 1 1 1
thermo_style custom step pe
thermo_modify norm no
variable force equal fz[2]
variable energy equal pe
run 0 post no
print "${z} ${energy} ${force}" append pairs
next z
jump in.pair next
EOF
usr/bin/lmp -in in.pair -log none -screen none
cat pairs
awk '{ sign = $1 == 0.5 || ($1 > 2 && $1 < 3.1) ? 1 : $1 > 0.9 && $1 < 2 || $1 > 3.2 ? -1 : 0
       if (sign && sign * $3 <= 0) wrong++
       if (!sign && ($2 > -1.6 || $3^2 > 0.01)) wrong++ }
     END { exit wrong || NR != 10 }' pairs
cat >in.places <<'EOF'
units lj
atom_style ellipsoid
read_data places
pair_style gayberne 1 1 1 20
pair_coeff * * 1 1 1 1 1 1 1 1
neighbor 0.5 bin
compute energy all pe/atom
dump end all custom 1000000 end id x y z c_energy
dump_modify end sort id format float %.12g
min_style cg
min_modify dmax 0.5
minimize 0 1e-6 2000 20000
EOF
/usr/bin/python3 - <<'END'
import subprocess
import numpy as np

random = np.random.default_rng(1)
places = random.uniform(-1, 1, (4000, 3))
places = (places[np.linalg.norm(places, axis=1) < 0.98] * (1, 1, 3))[:500]
first = 60.0 * np.array([(i % 8, i // 8 % 8, i // 64) for i in range(500)])
rows = np.concatenate([first, first + places])
with open("places", "w", encoding="ascii") as file:
    file.write("Pairs\n\n1000 atoms\n1000 ellipsoids\n1 atom types\n")
    file.writelines(f"-30 450 {axis}lo {axis}hi\n" for axis in "xyz")
    file.write("\nAtoms # ellipsoid\n\n")
    file.writelines(f"{i + 1} 1 1 1 {x:.12g} {y:.12g} {z:.12g}\n" for i, (x, y, z) in enumerate(rows))
    file.write("\nEllipsoids\n\n")
    file.writelines(f"{i + 1} 1 1 3 1 0 0 0\n" for i in range(1000))
subprocess.run(["usr/bin/lmp", "-in", "in.places", "-log", "none", "-screen", "none"], check=True)
lines = open("end", encoding="ascii").read().split("ITEM: ATOMS")[-1].splitlines()[1:]
table = np.array([line.split() for line in lines], float)
apart = (table[500:, 1:4] - table[:500, 1:4] + 240) % 480 - 240
overlap = np.linalg.norm(apart / (1, 1, 3), axis=1) < 0.9
energies = 2 * table[:500, 4]
print(f"{overlap.sum()} of 500 overlap, energies {energies.min():.6f} to {energies.max():.6f}")
assert abs(overlap.sum() - 48) < 20 and np.allclose(energies, -5 / 3, atol=1e-4)
END
