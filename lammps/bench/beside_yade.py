# SPDX-License-Identifier: GPL-2.0-only
"""Drops ellipsoids into an open box, with pair_style pw85/granular and in YADE: time per grain and step, and error of the energy.

    python3 beside_yade.py path/to/pw85.in [--edge 4] [--nodes 1000] [--cells 20] [--timesteps 0.002 0.004]

YADE's ellipsoids are bodies of its shape LevelSet: distances on a grid, with a number of cells along the shortest axis, and nodes on the
surface. Both programs have the same shapes, springs and walls, and starts of the same kind. There is neither damping nor friction,
so that the energy does not change. Prints a table with commas. Its largest errors of the energy are in units of the work of gravity.
Its times are those of a step for each grain, in microseconds on one core, after the start: YADE's is processor time, LAMMPS's is its
loop time, so that the machine must be quiet.
"""

import argparse
import os
import re
import subprocess
import tempfile
from pathlib import Path

COLUMNS = ("timestep", "pw85_us", "pw85_error", "yade_us", "yade_error")

ELLIPSOIDS = """
variable pw85 index pw85.in
units lj
atom_style ellipsoid
boundary f f f
include ${{pw85}}
comm_modify vel yes
lattice sc $(1/1.6^3)
region box block 0 {edge} 0 {edge} 0 $({edge}+1)
region grains block 0 $({edge}-0.5) 0 $({edge}-0.5) 0 $({edge}-0.5)
create_box 1 box
create_atoms 1 region grains
displace_atoms all move 0.8 0.8 0.8 units box
set type 1 shape 1.0 1.0 1.5
set type 1 density 1.0
set type 1 quat/random 4711
pair_style pw85/granular
pair_coeff * * hooke {stiffness} 0
neighbor 0.2 bin
neigh_modify delay 0
variable length equal {edge}*1.6
fix sides all wall/pw85 xplane 0 ${{length}} law hooke {stiffness} 0
fix ends all wall/pw85 yplane 0 ${{length}} law hooke {stiffness} 0
fix floor all wall/pw85 zplane 0 NULL law hooke {stiffness} 0
fix weight all gravity 1.0 vector 0 0 -1
fix move all nve/asphere
timestep {timestep}
compute spin all erotate/asphere
compute mass all property/atom mass
variable work atom -c_mass*z
compute work all reduce sum v_work
variable energy equal pe+ke+c_spin+f_sides+f_ends+f_floor-c_work
thermo_style custom step v_energy c_work pe ke
thermo_modify norm no format float %.12g
thermo {every}
run {steps}
"""

YADE = """
import os, time, numpy
from math import acos
lengths, edge = (0.5, 0.5, 0.75), {edge}
O.materials.append(FrictMat(density=1, frictionAngle=0))
stiffness = MatchMaker(algo="val", val={stiffness})
O.engines = [
    ForceResetter(), InsertionSortCollider([Bo1_LevelSet_Aabb(), Bo1_Wall_Aabb()], verletDist=0),
    InteractionLoop([Ig2_LevelSet_LevelSet_ScGeom(), Ig2_Wall_LevelSet_ScGeom()],
                    [Ip2_FrictMat_FrictMat_FrictPhys(kn=stiffness, ks=stiffness)],
                    [Law2_ScGeom_FrictPhys_CundallStrack(sphericalBodies=False)]),
    NewtonIntegrator(damping=0, gravity=(0, 0, -1), kinSplit=True)]
numpy.random.seed(4711)
first = levelSetBody("superellipsoid", extents=lengths, epsilons=(1, 1), spacing=1 / {cells}, nSurfNodes=2, nodesPath=2).shape
for place in numpy.ndindex(edge, edge, edge):
    q = numpy.random.normal(size=4)
    q /= numpy.linalg.norm(q)
    O.bodies.append(levelSetBody(center=tuple(1.6 * (numpy.array(place) + 0.5)), grid=first.lsGrid, distField=first.distField,
                                 nSurfNodes={nodes}, nodesPath=2, dynamic=True,
                                 orientation=Quaternion(tuple(q[1:]), 2 * acos(q[0]))))
for axis in range(3):
    O.bodies.append(wall((0, 0, 0), axis))
for axis in range(2):
    O.bodies.append(wall(tuple(1.6 * edge if k == axis else 0 for k in range(3)), axis))
O.dt, O.trackEnergy = {timestep}, True
begin = time.process_time()
for part in range({steps} // {every}):
    O.run({every}, True)
    energies = dict(O.energy.items())
    print("row", sum(energies.values()), -energies["gravWork"], flush=True)
print("seconds", time.process_time() - begin, flush=True)
os._exit(0)
"""


def run(command, script, name):
    """The text that a program prints."""
    with tempfile.TemporaryDirectory() as directory:
        Path(directory, name).write_text(script)
        return subprocess.run([*command, name], cwd=directory, env={**os.environ, "OMP_NUM_THREADS": "1"}, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False).stdout


def cells(rows, seconds, count, steps, every):
    """The time of a step and grain in microseconds, and the error of the energy, or why there are none.

    rows: the energy and the work of gravity at equidistant steps"""
    if len(rows) < steps // every:
        return "", f"stops after {len(rows) * every} of {steps} steps"
    error = max(abs(energy - rows[0][0]) for energy, _ in rows) / max(abs(work - rows[0][1]) for _, work in rows)
    return f"{1e6 * seconds / count / steps:.3g}", f"{error:.1g}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("include")
    parser.add_argument("--edge", type=int, default=4)
    parser.add_argument("--nodes", type=int, default=1000)
    parser.add_argument("--cells", type=int, default=20)
    parser.add_argument("--stiffness", type=float, default=2000.0)
    parser.add_argument("--time", type=float, default=4.0)
    parser.add_argument("--timesteps", type=float, nargs="+", default=[0.002, 0.004])
    arguments = parser.parse_args()
    include = str(Path(arguments.include).resolve())
    print(*COLUMNS, sep=",", flush=True)
    for timestep in arguments.timesteps:
        every = 10
        steps = round(arguments.time / timestep / every) * every
        values = {**vars(arguments), "timestep": timestep, "steps": steps, "every": every}
        text = run(["lmp", "-log", "none", "-var", "pw85", include, "-in"], ELLIPSOIDS.format(**values), "in.lammps")
        rows = [[float(word) for word in row.split()[1:3]] for row in re.findall(r"^ +\d+(?: +[-+.e\d]+){4} *$", text, re.MULTILINE)]
        loop = re.search(r"Loop time of (\S+)", text)
        here = cells(rows, float(loop.group(1)) if loop else 0.0, arguments.edge**3, steps, every)
        text = run(["yade", "-j1", "-n", "-x"], YADE.format(**values), "drop.py")
        rows = [[float(word) for word in row.split()] for row in re.findall(r"^row (.*)$", text, re.MULTILINE)]
        seconds = re.search(r"^seconds (\S+)", text, re.MULTILINE)
        there = cells(rows, float(seconds.group(1)) if seconds else 0.0, arguments.edge**3, steps, every)
        print(timestep, *here, *there, sep=",", flush=True)


if __name__ == "__main__":
    main()
