# SPDX-License-Identifier: BSD-3-Clause
"""Measures everything that README and manual show, and makes their tables and pictures from the results.

Usage: measure.py [--only TABLE] PROGRAM..., the programs of this folder, and pw85_uninstalled.in of a build with -Dlammps=enabled.
Have the machine to yourself.

All tables come from one run, which is written to docs/measurements.json with its conditions. --only replaces a single table, which a
program of this folder, of python/bench or of lammps/bench prints, or all tables of lammps/bench (--only lammps) or of sizes.py (--only
sizes), and stores its conditions with it. --only gpu, on a machine with a GPU, needs bench_gpu alone, --only hoomd_monte_carlo needs a
Python with HOOMD-blue, and --only languages the compilers and interpreters of eight languages. Tables that this run does not produce are
kept: instructions on another processor (instructions.py), comparisons with libraries that are not available now, and those of Python and
of LAMMPS if these are not built. Times are nanoseconds per pair, the shortest of several repetitions in which the functions take turns, in
several processes.
"""

import csv
import datetime
import json
import os
import platform
import re
import subprocess
import sys
from operator import itemgetter
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
RESULTS = ROOT / "docs" / "measurements.json"
# In each process, the parts of a program and its data have other addresses, which can make a short function slower by a third. So
# times are the least of several processes.
PROCESSES = 3
REPETITIONS = 11  # in each of them
# Tables of Python's programs, which are in python/bench: the program, and the library that it gets, in the build directory
PYTHON = {
    "arrays": ("compare_batches.py", "src/libpw85.so"),
    "any_dimension": ("compare_any_dimension.py", "python/bench/pypw85_any_dimension_loops.so"),
    "bodies": ("compare_bodies.py", "python/bench/pypw85_body_loops.so"),
    "calls": ("compare_calls.py", "python/bench/pypw85_c_loops.so"),
    "enclosing": ("compare_enclosing.py", "python/bench/pypw85_enclosing_peers.so"),
    "files": ("measure_files.py", None),
    "samples": ("measure_samples.py", None),
}
# What starts a LAMMPS that has pair_style granular/superellipsoid, if the one that is installed has not
NEWER_LAMMPS = ("--there", os.environ["NEWER_LAMMPS"]) if "NEWER_LAMMPS" in os.environ else ()
# What starts LIGGGHTS
LIGGGHTS = ("--there", os.environ.get("LIGGGHTS", "liggghts"))
# Tables of the programs of lammps/bench: the program, and its words after pw85_uninstalled.in
LAMMPS = {
    "grains": ("grains.py", "--repeat", "6"),
    "grain_ranks": ("grains.py", "--ranks"),
    "grains_beside_superellipsoid": ("beside_superellipsoid.py", *NEWER_LAMMPS),
    "times_beside_superellipsoid": ("beside_superellipsoid.py", "--time", *NEWER_LAMMPS),
    "grains_beside_liggghts": ("beside_liggghts.py", *LIGGGHTS),
    "times_beside_liggghts": ("beside_liggghts.py", "--time", "--repeat", "5", *LIGGGHTS),
    "grain_instructions": ("instructions.py",),
    "grains_beside_yade": ("beside_yade.py", "--timesteps", "0.004", "0.008", "0.016", "0.032"),
    "lammps_examples": ("examples.py",),
    "lammps_hard": ("hard.py",),
    "lammps_styles": ("scaling.py",),
    "lammps_batch": ("against_batch.py", "src/libpw85.so"),
}
# Tables that a whole run takes from the programs of their names
NAMED = "closest_approach common_parts condition digits evaluations factored peers rounded shapes signed_distance".split()
# Tables of sizes.py: its word for each
SIZES = {"sizes": "functions", "size_parts": "parts"}
# Those that take numbers of pairs or particles from the smallest to the largest, which takes minutes: what a trial run takes
LEAST = {"growth": ["1e3"], "public_monte_carlo": ["1024"], "monte_carlo": ["1e3", "1e3"]}
COMPARED = {"pw85 2.0", "HOOMD-blue 2 (quaternions)"}  # libraries that are not in Debian
DISPATCHED = "^(contact|overlap|contact_batch|overlap_batch)/[0-9e+]+$"


def processor(key):
    """The value of a key of /proc/cpuinfo for the first processor, or nothing."""
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
    except OSError:
        return ""
    return next((line.split(":", 1)[1].strip() for line in lines if line.startswith(key)), "")


def instruction_sets():
    """The instruction sets of src/simd/meson.build, from the oldest to the newest, each with the features that it needs."""
    text = (ROOT / "src" / "simd" / "meson.build").read_text(encoding="utf-8")
    rows = re.findall(r"^  \['(\w+)', \[([^\]]*)\]", re.search(r"x86_targets = \[\n(.*?)^\]", text, re.M | re.S)[1], re.M)
    return {"baseline": set(), **{name: set(re.findall(r"\w+", features)) for name, features in reversed(rows)}}


def environment(target, threads=1):
    return dict(os.environ, PW85_TARGET=target, OMP_NUM_THREADS=str(threads))


def read_table(program, *arguments, target, threads=1):
    text = subprocess.run([program, *arguments], check=True, stdout=subprocess.PIPE, text=True, env=environment(target, threads))
    return list(csv.DictReader(text.stdout.splitlines()))


def least_rows(program, target):
    """The rows of a table with names and numbers, each number the least of several processes."""
    runs = [read_table(program, target=target) for _ in range(1 if "PW85_MEASURE_ONCE" in os.environ else PROCESSES)]
    return [{key: min((row[key] for row in rows), key=number) for key in rows[0]} for rows in zip(*runs)]


def number(text):
    """The number that a text is, or 0 for a name."""
    try:
        return float(text)
    except ValueError:
        return 0.0


def program_rows(name, program, target):
    """The rows of a program of this folder, from several processes if libraries are compared by times of below a microsecond."""
    if name in {"side_by_side", "signed_distance_peers"}:
        return least_rows(program, target)
    return read_table(program, *(LEAST.get(name, []) if "PW85_MEASURE_ONCE" in os.environ else []), target=target)


def python_rows(name, build, target):
    """The rows of a table that a program of python/bench prints, with one thread and with all. In a trial run the numbers are small."""
    script, library = PYTHON[name]
    numbers = ["1000"] if "PW85_MEASURE_ONCE" in os.environ and name in ("arrays", "files", "samples") else []
    arguments = [ROOT / "python" / "bench" / script, *([build / library] if library else []), *numbers]
    rows = []
    for threads in sorted({1, os.cpu_count()}) if name == "arrays" else [os.cpu_count()]:
        variables = environment(target, threads) | {"PYTHONPATH": str(build / "python")}
        done = subprocess.run([sys.executable, *arguments], check=True, stdout=subprocess.PIPE, text=True, env=variables)
        rows += csv.DictReader(done.stdout.splitlines())
    return rows


def lammps_rows(name, include, target):
    """The rows of a table that a program of lammps/bench prints."""
    build = Path(include).resolve().parent.parent
    script, *words = LAMMPS[name]
    if name == "grains":
        words += ["--sets", *available_targets()]
    arguments = [str(build / word) if word.startswith("src/") else word for word in words]
    return read_table(sys.executable, ROOT / "lammps" / "bench" / script, include, *arguments, target=target)


def size_rows(name, build, target):
    return read_table(sys.executable, ROOT / "bench" / "sizes.py", build, SIZES[name], target=target)


def build_of(programs):
    return Path(programs["speed"]).resolve().parent.parent


def has_python(build):
    return all((build / path).exists() for path in ("python/pypw85/__init__.py", *(library for _, library in PYTHON.values() if library)))


def nanoseconds(program, name_filter, target, repetitions, threads=1):
    """The context, and the least time of each benchmark that matches. In a trial run each benchmark runs once."""
    processes = PROCESSES
    if "PW85_MEASURE_ONCE" in os.environ:
        processes = repetitions = 1
    options = {"filter": name_filter, "format": "json", "repetitions": repetitions, "min_time": 0.003}
    if repetitions > 1:
        options["enable_random_interleaving"] = "true"
    command = [program, *(f"--benchmark_{option}={value}" for option, value in options.items())]
    times = {}
    for _ in range(processes):
        done = subprocess.run(command, check=True, stdout=subprocess.PIPE, env=environment(target, threads))
        output = json.loads(done.stdout)
        for run in sorted(output["benchmarks"], key=itemgetter("family_index")):
            if run["run_type"] == "iteration":
                time = 1e9 / run["items_per_second"]
                times[run["run_name"]] = min(time, times.get(run["run_name"], time))
    return output["context"], times


def significant(time):
    return float(f"{time:.3g}")


def speed_rows(times, target):
    """FUNCTION/ASPECT as one row for each function, a column for each aspect ratio."""
    rows = {}
    for name, time in times.items():
        function, *case = name.split("/")
        if len(case) == 1:
            row = rows.setdefault(function, {"function": function, "target": target})
            row[f"aspect_{case[0]}"] = significant(time)
    return list(rows.values())


def near_rows(times, target):
    """FUNCTION/ASPECT/EXCESS as one row for each function and aspect ratio, a column for each |μ² - 1|."""
    rows = {}
    for name, time in times.items():
        function, aspect, excess = name.split("/")
        row = rows.setdefault((function, aspect), {"function": function, "target": target, "aspect": aspect})
        row[f"excess_{excess}"] = significant(time)
    return list(rows.values())


def list_rows(times, target):
    rows = {}
    for name, time in times.items():
        function, _, order, cell = name.split("/")
        row = rows.setdefault((function, order), {"function": function, "target": target, "order": order})
        row[cell] = significant(time)
    return list(rows.values())


def thread_rows(program, target):
    most = 1 if "PW85_MEASURE_ONCE" in os.environ else os.cpu_count() or 1
    for threads in range(1, most + 1):
        if threads & (threads - 1) == 0:
            for name, time in nanoseconds(program, "/million", target, 1, threads)[1].items():
                yield {"function": name.split("/")[0], "target": target, "threads": threads, "time": significant(time)}


def speed_tables(program, targets):
    """The names and rows of the tables of speed."""
    best = targets[-1]
    others = [row for t in targets[:-1] for row in speed_rows(nanoseconds(program, DISPATCHED, t, REPETITIONS)[1], t)]
    yield "speed", others + speed_rows(nanoseconds(program, "^[a-z0-9_]+/[0-9e+]+$", best, REPETITIONS)[1], best)
    yield "near", near_rows(nanoseconds(program, "^overlap[a-z_]*/[0-9]+/[0-9]", best, REPETITIONS)[1], best)
    yield "lists", list_rows(nanoseconds(program, "/list/", best, 1)[1], best)
    yield "threads", list(thread_rows(program, best))


def worst_rows(program, targets):
    """One row for each target and range of aspect ratios, with the worst error of each function. A trial run judges few pairs."""
    numbers = ["200"] if "PW85_MEASURE_ONCE" in os.environ else []
    rows = {}
    for target in targets:
        for found in read_table(program, "worst", *numbers, target=target):
            ends = {key: found[key] for key in ("aspect_from", "aspect_to", "pairs")}
            row = rows.setdefault((target, found["aspect_from"]), {"target": target, **ends})
            row.setdefault(found["function"], found["error"])  # the largest error comes first
    return list(rows.values())


def conditions_of(context, machine=None):
    return {
        "version": context["pw85"],
        "date": datetime.date.today().isoformat(),
        "compiler": context["compiler"],
        "processor": machine or processor("model name") or platform.machine(),
        "processors": context["num_cpus"],
        "load_average": significant(context["load_avg"][0]) if context.get("load_avg") else None,
    }


def available_targets():
    flags = set(processor("flags").split())
    return [target for target, needed in instruction_sets().items() if needed <= flags]


def context_of(program, target):
    return nanoseconds(program, "^overlap/2$", target, 1)[0]


def measured_tables(programs):
    """The names and rows of all tables that can be measured, one after the other: those that take long come last."""
    targets = available_targets()
    best = targets[-1]
    yield from speed_tables(programs["speed"], targets)
    yield "accuracy", read_table(programs["accuracy"], target=best)
    yield "worst", worst_rows(programs["accuracy"], targets)
    side_by_side = program_rows("side_by_side", programs["side_by_side"], best)
    if COMPARED <= {row["library"] for row in side_by_side}:
        yield "side_by_side", side_by_side
    named = [*NAMED, *SIZES]
    named += PYTHON if has_python(build_of(programs)) else []
    named += LAMMPS if "pw85_uninstalled" in programs else []
    for name in [*named, *LEAST]:
        yield name, rows_alone(name, programs, best)


def measure(programs):
    """Writes each table as soon as it is measured, so that a program that fails loses no other's numbers."""
    results = {"conditions": conditions_of(context_of(programs["speed"], available_targets()[-1])), "tables": {}}
    for name, rows in measured_tables(programs):
        results["tables"][name] = rows
        write(with_last(results))


def with_last(results):
    """The results, with the previous tables of everything that was not measured now."""
    last = last_results()
    kept = sorted(last["tables"].keys() - results["tables"].keys())
    conditions = {name: last.get("apart", {}).get(name, last["conditions"]) for name in kept}
    tables = results["tables"] | {name: last["tables"][name] for name in kept}
    return {"conditions": results["conditions"]} | ({"apart": conditions} if kept else {}) | {"tables": tables}


def last_results():
    return json.loads(RESULTS.read_text(encoding="utf-8"))


def put_apart(name, rows, conditions):
    """Replaces one table by one that was measured alone."""
    results = last_results()
    results["tables"][name] = rows
    results.setdefault("apart", {})[name] = conditions
    write(results)


def measure_only(name, programs):
    best = available_targets()[-1]
    context = context_of(programs["speed"], best)
    for table in {"lammps": LAMMPS, "sizes": SIZES}.get(name, [name]):
        put_apart(table, rows_alone(table, programs, best), conditions_of(context))


def measure_gpu(program):
    """The table of a GPU, whose machine need not have the other programs."""
    query = ["nvidia-smi", "--query-gpu=name,driver_version", "--format=csv,noheader"]
    device, driver = subprocess.run(query, check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines()[0].split(", ")
    context = json.loads(subprocess.run([program, "context"], check=True, stdout=subprocess.PIPE).stdout)
    host = f"{processor('model name')} with {context['num_cpus']} threads"
    rows = read_table(program, target=available_targets()[-1], threads=context["num_cpus"])
    put_apart("gpu", rows, conditions_of(context, f"{device} with driver {driver}, {host}"))


def rows_alone(name, programs, target):
    if name in PYTHON:
        return python_rows(name, build_of(programs), target)
    if name in SIZES:
        return size_rows(name, build_of(programs), target)
    if name in LAMMPS:
        return lammps_rows(name, programs["pw85_uninstalled"], target)
    if name == "languages":
        return read_table(sys.executable, ROOT / "bench" / "languages.py", build_of(programs), target=target)
    if name == "hoomd_monte_carlo":  # by an interpreter that has HOOMD-blue
        return read_table(sys.executable, ROOT / "bench" / "hoomd_monte_carlo.py", target=target)
    return program_rows(name, programs[name], target)


def to_json(results):
    """The results as JSON, with one row of a table per line."""
    tables = ",\n".join(
        f'  "{name}": [\n' + ",\n".join(f"   {json.dumps(row)}" for row in rows) + "\n  ]"
        for name, rows in results["tables"].items()
    )
    heads = "".join(f' "{key}": {json.dumps(results[key])},\n' for key in ("conditions", "apart") if key in results)
    return f'{{\n{heads} "tables": {{\n{tables}\n }}\n}}\n'


def write(results):
    RESULTS.write_text(to_json(results), encoding="utf-8")


def main():
    arguments = sys.argv[1:]
    only = arguments[1] if arguments[0] == "--only" else None
    programs = {Path(path).stem: path for path in arguments[2 if only else 0 :]}
    if "peers" not in programs and not only:
        sys.exit("peers was not built: it needs libfcl-dev and libeigen3-dev")
    if only == "gpu":
        measure_gpu(programs["bench_gpu"])
    elif only:
        measure_only(only, programs)
    else:
        measure(programs)
    subprocess.run([sys.executable, ROOT / "docs" / "measured_pages.py"], check=True)


if __name__ == "__main__":
    main()
