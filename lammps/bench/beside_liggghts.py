# SPDX-License-Identifier: GPL-2.0-only
"""Ellipsoids with pair_style pw85/granular beside LIGGGHTS, which has them as superquadrics.

    python3 beside_liggghts.py path/to/pw85.in [--there COMMAND] [--time] [--edge 12] [--repeat 3]

COMMAND starts LIGGGHTS (liggghts), compiled with USE_SUPERQUADRICS = "ON". Prints a table with commas: the errors of the energy in the
collisions of beside_superellipsoid.py, here by the law hooke, there by hooke/stiffness.

With --time, grains.in and liggghts.in run, which have the same lattice, in which each grain has twelve contacts. The time is the
processor time of a step and contact in nanoseconds, as in grains.py; the runs of both programs take turns. Spheres are measured in both,
as a scale.
"""

import argparse
import functools
import shlex
import tempfile
from pathlib import Path

import beside_superellipsoid as pairs
import grains
import numpy as np
import runs

COLLISIONS = """
units lj
atom_style superquadric
atom_modify map array
newton off
communicate single vel yes
region box block 0 {edge} 0 {edge} 0 {edge} units box
create_box 1 box
{atoms}
neighbor 0.2 bin
neigh_modify delay 0
fix k1 all property/global kn peratomtypepair 1 {stiffness}
fix k2 all property/global kt peratomtypepair 1 0
fix g1 all property/global gamman peratomtypepair 1 0
fix g2 all property/global gammat peratomtypepair 1 0
fix friction all property/global coefficientFriction peratomtypepair 1 0
pair_style gran model hooke/stiffness tangential no_history surface superquadric
pair_coeff * *
fix move all nve/superquadric integration_scheme 1
timestep {timestep}
dump state all custom {steps} state.txt id vx vy vz angmomx angmomy angmomz quat1 quat2 quat3 quat4
dump_modify state sort id format "%d {numbers}"
run {steps}
"""


def collide(program, diameters, timestep):
    """The relative errors of the energy of all pairs that have met."""
    lengths = " ".join(str(0.5 * x) for x in diameters)
    atoms = "\n".join(
        f"create_atoms 1 single {' '.join(map(str, x))} units box\n"
        f"set atom {k} shape {lengths} blockiness 2 2 density {pairs.DENSITY} quat_direct {' '.join(map(str, q))} vx {v}"
        for k, (x, q, v) in enumerate(zip(*pairs.start_state(diameters), strict=True), 1))
    with tempfile.TemporaryDirectory() as directory:
        script = Path(directory, "in.liggghts")
        script.write_text(COLLISIONS.format(edge=pairs.SPACING * pairs.PAIRS, atoms=atoms, stiffness=pairs.STIFFNESS, timestep=timestep,
                                            steps=round(pairs.TIME / timestep), numbers=" ".join(["%.17g"] * 10)))
        pairs.run(program, script)
        frames = Path(directory, "state.txt").read_text().split("ITEM: ATOMS")[1:]
    states = [np.array([line.split()[1:] for line in frame.split("ITEM:")[0].splitlines()[1:]], dtype=float) for frame in frames]
    return pairs.relative_errors(*((pairs.kinetic_energies(rows[:, :6], rows[:, 6:], diameters), rows[:, :6]) for rows in states))


def start_there(program, edge, spheres, steps):
    return runs.start("liggghts.in", program=program, edge=edge, height=edge, spheres=spheres, steps=steps)


def print_times(include, program, edge, repeat):
    here = grains.starts(("lammps", "ellipsoids"), include, edge)
    there = {(name, "LIGGGHTS"): functools.partial(start_there, program, edge, int(name == "spheres"))
             for name in ("spheres", "ellipsoids")}
    print("grains,style,ns")
    for row in grains.times_of_contacts({**here, **there}, edge, repeat):
        print(*row, sep=",", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("include", type=lambda name: Path(name).resolve())
    parser.add_argument("--there", type=shlex.split, default=["liggghts"])
    parser.add_argument("--time", action="store_true")
    parser.add_argument("--edge", type=int, default=12)
    parser.add_argument("--repeat", type=int, default=3)
    arguments = parser.parse_args()
    if arguments.time:
        print_times(arguments.include, arguments.there, arguments.edge, arguments.repeat)
    else:
        pairs.print_errors(arguments.include, functools.partial(collide, arguments.there))


if __name__ == "__main__":
    main()
