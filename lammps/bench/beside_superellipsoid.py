# SPDX-License-Identifier: GPL-2.0-only
"""Ellipsoids with pair_style pw85/granular beside LAMMPS's granular/superellipsoid (since 30 March 2026).

    python3 beside_superellipsoid.py path/to/pw85.in [--there COMMAND] [--time] [--repeat 3]

COMMAND starts the LAMMPS that has granular/superellipsoid (lmp), which need not be the one that loads the styles of pw85 (lmp).

Pairs of ellipsoids with random orientations collide in space, without friction and damping, by the law hooke. Kinetic energy before and
after a collision is the same by an exact law, whatever the shapes and the place of the contact. Prints a table with commas: for each
shape and time step, the root mean square of the error of the energy over all pairs that meet, relative to the energy before, and the
largest error.

With --time, grains.in runs, in which each grain has twelve contacts. The time is the processor time of a step and contact in
nanoseconds, as in grains.py, which has the words; LAMMPS's spheres are measured in both programs, as a scale.
"""

import argparse
import shlex
import subprocess
import tempfile
from pathlib import Path

import grains
import numpy as np
import runs

COLUMNS = ("shape", "timestep", "here_error", "there_error", "here_largest", "there_largest")
SHAPES = {"1 : 1 : 1.5": (1.0, 1.0, 1.5), "1 : 1 : 3": (1.0, 1.0, 3.0), "1 : 1 : 0.4": (1.0, 1.0, 0.4)}
STIFFNESS, DENSITY, SPEED, TIME, SPACING = 2000.0, 1.0, 1.0, 8.0, 10.0
PAIRS = 8  # along each direction
EDGE = 12  # cells of the lattice of grains.in

COLLISIONS = """
units lj
atom_style ellipsoid {kind}
newton {newton}
{include}
comm_modify vel yes
read_data start.data
neighbor 0.2 bin
neigh_modify delay 0
{pair}
fix move all nve/asphere
timestep {timestep}
run {steps}
write_data end.data
"""
HERE = {
    "kind": "", "newton": "on", "blocks": (), "pair": f"pair_style pw85/granular\npair_coeff * * hooke {STIFFNESS} 0",
}
THERE = {
    "kind": "superellipsoid", "newton": "off", "include": "", "blocks": (2, 2),
    "pair": f"pair_style granular/superellipsoid\npair_coeff * * hooke {STIFFNESS} 0 tangential linear_history 0 0 0",
}


def start_state(diameters):
    """Centres, quaternions, and velocities along x, of pairs that fly at each other."""
    random = np.random.default_rng(4711)
    places = SPACING * (np.stack(np.meshgrid(*3 * [np.arange(PAIRS)], indexing="ij"), axis=-1).reshape(-1, 3) + 0.5)
    offsets = np.column_stack([np.full(len(places), 0.52 * max(diameters)), *random.uniform(-0.15, 0.15, (2, len(places)))])
    centers = np.concatenate([places - offsets, places + offsets])
    quaternions = random.normal(size=(len(centers), 4))
    quaternions /= np.linalg.norm(quaternions, axis=1)[:, None]
    return centers, quaternions, np.repeat([0.5 * SPEED, -0.5 * SPEED], len(places))


def start_data(diameters, blocks):
    """A data file of these pairs. `blocks`: the exponents of a superellipsoid"""
    centers, quaternions, speeds = start_state(diameters)
    sections = {
        "Atoms": [f"1 1 {DENSITY} {x} {y} {z}" for x, y, z in centers],
        "Velocities": [f"{v} 0 0 0 0 0" for v in speeds],
        "Ellipsoids": [" ".join(map(str, (*diameters, *q, *blocks))) for q in quaternions],
    }
    edge = SPACING * PAIRS
    head = [f"{len(centers)} atoms", f"{len(centers)} ellipsoids", "1 atom types", *(f"0 {edge} {d}lo {d}hi" for d in "xyz")]
    body = ([name, "", *(f"{k} {row}" for k, row in enumerate(rows, 1)), ""] for name, rows in sections.items())
    return "\n".join(["pairs", "", *head, "", *(line for lines in body for line in lines)])


def section(text, name):
    """The numbers of a section of a data file, in the order of the atoms."""
    lines = text.split(f"\n{name}", 1)[1].split("\n")[2:]
    rows = []
    for line in lines:
        if not line.strip():
            break
        rows.append([float(word) for word in line.split()])
    return np.array(sorted(rows))[:, 1:]


def kinetic_energies(motion, quaternions, diameters):
    """The kinetic energies of atoms with rows of velocity and angular momentum."""
    mass = DENSITY * np.pi / 6.0 * np.prod(diameters)
    squares = (0.5 * np.array(diameters)) ** 2
    inertia = mass / 5.0 * (squares.sum() - squares)
    w, v, momentum = quaternions[:, 0], quaternions[:, 1:], motion[:, 3:6]
    # the angular momentum in the axes of the body: the inverse rotation
    turn = 2.0 * np.cross(momentum, v)
    body = momentum + w[:, None] * turn + np.cross(turn, v)
    return 0.5 * mass * (motion[:, :3] ** 2).sum(axis=1) + 0.5 * (body**2 / inertia).sum(axis=1)


def energies(text, diameters):
    """The kinetic energies of all atoms of a data file, and their motions."""
    motion = section(text, "Velocities")
    return kinetic_energies(motion, section(text, "Ellipsoids")[:, 3:7], diameters), motion


def relative_errors(start, end):
    """Those of the energy of all pairs that have met, of energies and motions."""
    (before, first), (after, last) = start, end
    pairs = len(before) // 2
    met = (np.abs(last - first).max(axis=1) > 1e-9)[:pairs]
    total = (before[:pairs] + before[pairs:])[met]
    return (after[:pairs] + after[pairs:])[met] / total - 1.0


def collide(command, diameters, timestep, blocks, **words):
    """The relative errors of the energy of all pairs that have met."""
    with tempfile.TemporaryDirectory() as directory:
        start, end, script = (Path(directory, name) for name in ("start.data", "end.data", "in.lammps"))
        start.write_text(start_data(diameters, blocks))
        script.write_text(COLLISIONS.format(timestep=timestep, steps=round(TIME / timestep), **words))
        run(command, script)
        return relative_errors(*(energies(path.read_text(), diameters) for path in (start, end)))


def run(command, script):
    done = subprocess.run([*command, "-log", "none", "-in", script.name], cwd=script.parent, env=runs.environment(), text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    if done.returncode:
        raise RuntimeError(done.stdout[-2000:])


def print_errors(include, collide_there):
    """Prints the table. `collide_there` gives the errors of the other program for diameters and a time step."""
    print(*COLUMNS, sep=",", flush=True)
    for name, diameters in SHAPES.items():
        for timestep in (0.004, 0.001, 0.00025):
            errors = [collide(["lmp"], diameters, timestep, include=f"include {include}", **HERE), collide_there(diameters, timestep)]
            print(name, timestep, *(f"{np.sqrt(np.mean(x**2)):.1e}" for x in errors), *(f"{np.abs(x).max():.1e}" for x in errors),
                  sep=",", flush=True)


def print_times(include, there, repeat):
    print("grains,style,lammps,ns")
    for program, styles in (["lmp"], ("lammps", "ellipsoids")), (there, ("lammps", "superellipsoids")):
        for grain, style, time in grains.times_of_contacts(grains.starts(styles, include, EDGE, program), EDGE, repeat):
            print(grain, style, runs.version(program), time, sep=",", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("include", type=lambda name: Path(name).resolve())
    parser.add_argument("--there", type=shlex.split, default=["lmp"])
    parser.add_argument("--time", action="store_true")
    parser.add_argument("--repeat", type=int, default=3)
    arguments = parser.parse_args()
    if arguments.time:
        print_times(arguments.include, arguments.there, arguments.repeat)
    else:
        print_errors(arguments.include, lambda diameters, timestep: collide(arguments.there, diameters, timestep, **THERE))


if __name__ == "__main__":
    main()
