"""The measured sections of docs/lammps.md."""

import measurements

COUNTS = ("1000", "10000", "100000", "256000")
STYLES = {
    "overlap": "`compute pw85/overlap`",
    "contact": "`compute pw85/contact`, per atom",
    "soft": "step of dynamics with `pair_style pw85/contact`, all of LAMMPS included",
}


def table(heads, rows):
    return ["| " + " | ".join(heads) + " |", "|---|" + "---:|" * (len(heads) - 1), *("| " + " | ".join(row) + " |" for row in rows)]


def grains():
    rows = measurements.read_table("grains")
    spheres = float(rows[0]["ns"])
    heads = ["twelve contacts for each grain", "instruction set", "ns per contact and step", "times the first row"]
    yield from table(heads, ([f"{row['grains']}, `{row['style']}`", row["set"], row["ns"], f"{float(row['ns']) / spheres:.1f}"]
                             for row in rows))
    yield from ["", f"({measurements.conditions('grains')}; `bench/grains.py`, one core, all of LAMMPS included.)"]


def grain_ranks():
    rows = measurements.read_table("grain_ranks")
    heads = [f"{int(rows[0]['grains']):,} ellipsoids", "ms per step", "times as fast"]
    yield from table(heads, ([row["run"], row["ms"], row["speedup"]] for row in rows))
    yield ""
    yield f"({measurements.conditions('grain_ranks')}; `bench/grains.py --ranks`. A grain takes {float(rows[0]['bytes']):g} bytes, all of"
    yield "LAMMPS included.)"


def grains_beside_yade():
    columns = ("timestep", "pw85_us", "yade_us", "pw85_error", "yade_error")
    heads = ["time step", "µs per grain and step, here", "YADE", "largest error of the energy, here", "YADE"]
    yield from table(heads, ([row[column] for column in columns] for row in measurements.read_table("grains_beside_yade")))
    yield from ["", f"({measurements.conditions('grains_beside_yade')}; `bench/beside_yade.py`, one core.)"]


def collisions(name, there):
    columns = ("shape", "timestep", "here_error", "there_error", "here_largest", "there_largest")
    heads = ["diameters", "time step", "error of the energy, here", there, "largest, here", there]
    return table(heads, ([row[column] for column in columns] for row in measurements.read_table(name)))


def grains_beside_superellipsoid():
    yield from collisions("grains_beside_superellipsoid", "`granular/superellipsoid`")
    yield from ["", f"({measurements.conditions('grains_beside_superellipsoid')}; `bench/beside_superellipsoid.py`.)", ""]
    times = measurements.read_table("times_beside_superellipsoid")
    heads = ["twelve contacts for each grain", "LAMMPS", "ns per contact and step"]
    yield from table(heads, ([f"{row['grains']}, `{row['style']}`", row["lammps"], row["ns"]] for row in times))
    yield ""
    yield f"({measurements.conditions('times_beside_superellipsoid')}; `bench/beside_superellipsoid.py --time`, one core.)"


def grains_beside_liggghts():
    yield from collisions("grains_beside_liggghts", "LIGGGHTS")
    yield from ["", f"({measurements.conditions('grains_beside_liggghts')}; `bench/beside_liggghts.py`.)", ""]
    times = measurements.read_table("times_beside_liggghts")
    names = {"LIGGGHTS": "LIGGGHTS 3.8.0"}
    heads = ["twelve contacts for each grain", "ns per contact and step", "times the first row"]
    yield from table(heads, ([f"{row['grains']}, {names.get(row['style'], '`' + row['style'] + '`')}", row["ns"],
                              f"{float(row['ns']) / float(times[0]['ns']):.1f}"] for row in times))
    yield from ["", f"({measurements.conditions('times_beside_liggghts')}; `bench/beside_liggghts.py --time`, one core.)"]


def grain_instructions():
    rows = measurements.read_table("grain_instructions")
    yield from table(["instructions per contact and step", "`gran/hertz/history`", "`pw85/granular`"],
                     ([row["part"], row["lammps"], row["ellipsoids"]] for row in rows))
    yield from ["", f"({measurements.conditions('grain_instructions')}; `bench/instructions.py`, by callgrind, with AVX2.)"]


def styles(column, ranks):
    """A row for each style, with a column for each number of ellipsoids."""
    rows = measurements.read_table("lammps_styles")
    cells = {(row["style"], row["ellipsoids"]): row[column] for row in rows if row["ranks"] == ranks}
    counts = [count for count in COUNTS if any(count == found for _, found in cells)]
    return [f"{int(count):,}" for count in counts], ([STYLES[style], *(cells[style, count] for count in counts)] for style in STYLES)


def cost():
    counts, rows = styles("ns", "1")
    yield from table(["ns for each ellipsoid", *counts], rows)
    yield from ["", f"({measurements.conditions('lammps_styles')}; `bench/scaling.py`, one core.)", ""]
    for row in measurements.read_table("lammps_batch"):
        ratio = float(row["compute"]) / float(row["batch"])
        yield f"For {int(row['ellipsoids']):,} ellipsoids, `compute pw85/{row['function']}` takes {row['compute']} ns for each pair of the"
        yield f"neighbour list, and the batch function takes {row['batch']} ns for the same list, a ratio of {ratio:.1f}."
    yield f"({measurements.conditions('lammps_batch')}; `bench/against_batch.py`.)"


def efficiency():
    counts, rows = styles("efficiency", "2")
    yield from table(["ellipsoids", *counts], rows)
    yield from ["", f"({measurements.conditions('lammps_styles')}; `bench/scaling.py`.)"]


def estimate():
    """What 1e9 ellipsoids on 1000 ranks would cost, from the times of 1e5 ellipsoids on one rank."""
    times = {row["style"]: float(row["ns"]) for row in measurements.read_table("lammps_styles")
             if (row["ellipsoids"], row["ranks"]) == ("100000", "1")}
    work = 1.1 * times["overlap"]  # ms for 1e6 ellipsoids and a tenth as many ghosts
    messages = 5 + 1 + 0.2
    yield from table(
        ["per rank and evaluation", ""],
        [
            [f"work of `pw85/overlap`: 1e6 × {times['overlap']:g} ns, and 10 % for ghosts", f"{work:.0f} ms"],
            ["forms to ghosts: 96,000 × 56 bytes = 5.4 MB, at 1 GB/s for each rank", "5 ms"],
            ["values back: 96,000 × 8 bytes = 0.8 MB", "1 ms"],
            ["latencies: 12 messages and two reductions over 1000 ranks", "< 0.2 ms"],
        ],
    )
    step = 1e-3 * times["soft"]
    part = 100 * work / (work + messages)
    yield ""
    yield f"That is {1e-3 * (work + messages):.2f} s for an answer about 1e9 ellipsoids, with an efficiency of {part:.0f} %. A step of"
    yield f"dynamics takes 1e6 × {times['soft']:g} ns = {step:.2f} s, to which the messages for positions and quaternions, forms, forces"
    yield f"and torques (20 values for each ghost, 15 MB) add 15 ms: a million steps in {1e6 * (step + 0.015) / 86400:.0f} days."


def hard():
    """What processors send each other in a sweep. Each exchange takes a message to each of six neighbours."""
    rows = [row for row in measurements.read_table("lammps_hard") if row["ranks"] == "2"]
    exchanges = 9  # those of bench/hard.py
    heads = ["ellipsoids of a rank", "ghosts", "MB in a sweep", "messages in a sweep"]
    cells = ([f"{int(row['ellipsoids']) // 2:,}", f"{int(row['ghosts']):,}", row["megabytes"], str(6 * exchanges)] for row in rows)
    yield from table(heads, cells)
    yield ""
    yield f"({measurements.conditions('lammps_hard')}; `bench/hard.py`, two ranks.)"


def example(name):
    """What an example of examples/lammps found: the values by form and quantity."""
    return {(row["form"], row["quantity"]): row["value"] for row in measurements.read_table("lammps_examples") if row["example"] == name}


def relax():
    found = example("relax")
    yield f"After {found['', 'steps']} steps ({found['', 'seconds']} s on one core), {found['', 'overlapping pairs']} pairs overlap."


def drum():
    found = example("drum")
    angles = [f"{found[form, 'angle']}° for {found[form, 'grains']} grains" for form in ("long", "short")]
    yield f"The angle is {angles[0]}, and {angles[1]} in the short form."


def heap():
    found = example("heap")
    stay, grains = found["long", "grains that stay"], found["long", "grains"]
    slopes = sorted(float(value) for (form, quantity), value in found.items() if form.startswith("seed") and quantity == "slope")
    few, many, spheres = (f"{degrees:.0f}°" for degrees in (slopes[0], slopes[-1], float(found["spheres", "slope"])))
    yield f"The slope is {found['long', 'slope']}° for the {stay} grains that stay of {grains}. The short form has {few} to {many} with"
    yield f"{len(slopes)} sets of random places and orientations (`-var seed`), and {spheres} with spheres (`-var aspect 1`): they roll,"
    yield "because the laws of this example have no rolling resistance."


def hopper():
    found = example("hopper")
    columns = "density", "flow", "law", "grains that leave"
    rows = ([hole, *(found[hole, column] for column in columns)] for hole in ("4", "4.5", "5"))
    yield from table(["D", "n", "flow", "flow by the law", "grains that leave"], rows)
    yield ""
    yield f"({measurements.conditions('lammps_examples')}; `bench/examples.py`, for this and the examples above.)"


SECTIONS = {
    section.__name__: section
    for section in (
        grains, grain_ranks, grains_beside_yade, grains_beside_superellipsoid, grains_beside_liggghts,
        grain_instructions, hard, cost, efficiency, estimate, relax, drum, heap, hopper,
    )
}
