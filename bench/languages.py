# SPDX-License-Identifier: BSD-3-Clause
"""The same 1,000 pairs in eight languages: their bits, also in units of length from 2^-40 to 2^40, and the time of a call and of a row.

Usage: languages.py BUILD [LANGUAGE...]

BUILD is a build folder of Meson with the library, for Fortran and Python also with the module and the package. The packages for R, Octave,
Rust and JavaScript are built from the sources beside this folder. Each program in the folder `languages` reads the pairs, computes their
overlaps, contact functions, distances and common volumes, as rows and one by one, writes all results, and prints the least time of each.
Each of the 100 rounds of calls combines the numbers of the pairs in another way, so that a processor cannot learn their branches. Each
program has rounded a number before: one call of overlap takes 80 ns more where the library must clear the flag of inexact results.

In the reproducible mode all results must have the bits of C: the program ends with status 1 and the first difference otherwise. R, Octave
and JavaScript compute one pair by the function of many rows, whose last bits need not be those of the function of one pair. Prints CSV:
nanoseconds of a call and of a row in one thread, and the time of a row over that of C. `fastest` is the usual mode, which JavaScript does
not have.
"""

import math
import os
import random
import shutil
import struct
import subprocess
import sys
from array import array
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PROGRAMS = ROOT / "bench" / "languages"
LANGUAGES = ("C", "C++", "Fortran", "Python", "Rust", "R", "Octave", "JavaScript")
MODES = {"reproducible": "1", "fastest": "0"}
# The results of each function, and the numbers that each has for one pair
FUNCTIONS = {
    "overlap": {"overlap": 1},
    "contact": {"mu2": 1, "lambda": 1},
    "distance": {"distance": 1, "point1": 3, "point2": 3},
    "overlap_volume": {"volume": 1},
}
ALONE_BY_ROWS = {"R", "Octave", "JavaScript"}
PAIRS = 1000
IS_TRIAL = "PW85_MEASURE_ONCE" in os.environ
PROCESSES, ROUNDS = (1, 1) if IS_TRIAL else (3, 100)


def random_form(generator, unit):
    """The form of a random ellipsoid: the sum of a² n nᵀ over its axes."""
    w, x, y, z = (generator.gauss(0, 1) for _ in range(4))
    s = 2 / (w * w + x * x + y * y + z * z)
    axes = [(1 - s * (y * y + z * z), s * (x * y + w * z), s * (x * z - w * y)),
            (s * (x * y - w * z), 1 - s * (x * x + z * z), s * (y * z + w * x)),
            (s * (x * z + w * y), s * (y * z - w * x), 1 - s * (x * x + y * y))]  # fmt: skip
    squares = [(unit * generator.uniform(0.25, 2.25)) ** 2 for _ in range(3)]
    return [sum(a * n[i] * n[j] for a, n in zip(squares, axes)) for i in range(3) for j in range(i, 3)]


def write_pairs(path, units):
    """Separations, then the first, then the second forms of 1,000 pairs, whose units of length are given powers of 2."""
    generator, parts = random.Random(85), [array("d"), array("d"), array("d")]
    for _ in range(PAIRS):
        unit = 2.0 ** generator.choice(units)
        parts[0].extend(unit * generator.gauss(0, 1.5) for _ in range(3))
        parts[1].extend(random_form(generator, unit))
        parts[2].extend(random_form(generator, unit))
    path.write_bytes(b"".join(part.tobytes() for part in parts))


def run(command, environment):
    done = subprocess.run(command, check=False, capture_output=True, text=True, env=environment)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
    return done.stdout


class Builder:
    """Builds the programs of the languages. Each method returns the words of a command, which the files and the rounds follow."""

    def __init__(self, build):
        self.build, self.work = build, build / "languages"
        self.work.mkdir(exist_ok=True)
        self.environment = os.environ | {
            "PKG_CONFIG_PATH": str(build / "meson-uninstalled"),
            "LD_LIBRARY_PATH": f"{build / 'src'}:{build / 'fortran'}",
            "PYTHONPATH": str(build / "python"),
            "R_LIBS": str(self.work / "r-library"),
            "CARGO_TARGET_DIR": str(self.work / "cargo"),
            "OMP_NUM_THREADS": "1",
        }  # fmt: skip

    def compiled(self, compiler, source, package="pw85"):
        program = self.work / f"rows{source.suffix}.program"
        flags = run(["pkg-config", "--cflags", "--libs", package], self.environment).split()
        run([*compiler, "-O2", PROGRAMS / source, "-o", program, *flags], self.environment)
        return [program]

    def c(self):
        return self.compiled(["cc", "-std=c99", "-D_POSIX_C_SOURCE=200809L"], Path("rows.c"))

    def cpp(self):
        return self.compiled(["c++", "-std=c++20", "-ffp-contract=off", "-fno-math-errno"], Path("rows.cpp"))

    def fortran(self):
        return self.compiled(["gfortran"], Path("rows.f90"), "pw85_fortran")

    def python(self):
        return [sys.executable, PROGRAMS / "rows.py"]

    def rust(self):
        folder = self.work / "rust"
        folder.mkdir(exist_ok=True)
        (folder / "Cargo.toml").write_text(
            f'[package]\nname = "rows"\nversion = "0.0.0"\nedition = "2021"\n\n[[bin]]\nname = "rows"\npath = "{PROGRAMS / "rows.rs"}"\n\n'
            f'[dependencies]\npw85 = {{ path = "{ROOT / "rust" / "pw85"}" }}\n\n[workspace]\n',
            encoding="utf-8",
        )
        cargo = "/usr/bin/cargo" if Path("/usr/bin/cargo").exists() else "cargo"
        path = {"PATH": f"/usr/bin:{os.environ['PATH']}"}  # the compiler that belongs to it
        run([cargo, "build", "--quiet", "--release", "--offline", "--manifest-path", folder / "Cargo.toml"], self.environment | path)
        return [self.work / "cargo" / "release" / "rows"]

    def copied(self, name):
        """A copy of a folder of the sources, in which the package is built."""
        folder = self.work / name
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(ROOT / name, folder, ignore=shutil.ignore_patterns("*.o", "*.so", "*.mex"))
        return folder

    def r(self):
        (self.work / "r-library").mkdir(exist_ok=True)
        run(["R", "CMD", "INSTALL", "--no-docs", self.copied("r")], self.environment)
        return ["Rscript", "--vanilla", PROGRAMS / "rows.R"]

    def octave(self):
        folder = self.copied("octave")
        run(["make", "-C", folder / "src"], self.environment)
        given = "w = argv (); [given, out, rounds] = deal (w{1:2}, str2double (w{3}));"
        starter = self.work / "octave_rows.m"
        starter.write_text(
            f"addpath ('{folder / 'inst'}', '{folder / 'src'}');\n{given}\nsource ('{PROGRAMS / 'rows.m'}');\n", encoding="utf-8"
        )
        return ["octave-cli", "--no-history", "--norc", "--quiet", starter]

    def javascript(self):
        run([ROOT / "scripts" / "build_npm.sh"], self.environment)
        return ["node", PROGRAMS / "rows.mjs"]


def numbers_of(path):
    numbers = array("d")
    numbers.frombytes(path.read_bytes())
    return numbers


def bits(number):
    """The bits of a number, those of all NaN alike: which one an operation returns is not specified."""
    return struct.pack("d", math.nan if math.isnan(number) else number)


def expected(language, in_c):
    """What a language must compute: the results of C, in which those one by one follow those of rows."""
    if language not in ALONE_BY_ROWS:
        return in_c
    found, start = array("d"), 0
    for results in FUNCTIONS.values():
        rows = in_c[start : start + PAIRS * sum(results.values())]
        found += rows + rows
        start += 2 * len(rows)
    return found


def place_of(index):
    """What a number of the results is, and of which pair."""
    parts = [(name, size, way) for results in FUNCTIONS.values() for way in ("rows", "calls") for name, size in results.items()]
    for name, size, way in parts:
        if index < size * PAIRS:
            return f"{name} of pair {index // size} by {way}"
        index -= size * PAIRS
    return "nothing"


def compare(language, found, in_c):
    """Ends the program if the results do not have the bits of C."""
    truth = expected(language, in_c)
    if len(found) != len(truth):
        sys.exit(f"{language}: {len(found)} numbers instead of {len(truth)}")
    for k, (x, y) in enumerate(zip(found, truth)):
        if bits(x) != bits(y):
            sys.exit(f"{language}: {place_of(k)} is {x.hex()}, and {y.hex()} in C")


def times_of(command, pairs, out, environment, rounds):
    """Nanoseconds of a call and of a row for each function."""
    lines = run([*command, pairs, out, str(rounds)], environment).splitlines()
    times = {name: (float(call), float(row)) for name, call, row in (line.split(",") for line in lines)}
    assert list(times) == list(FUNCTIONS), times
    return times


def least(runs):
    return {name: tuple(min(run[name][k] for run in runs) for k in (0, 1)) for name in FUNCTIONS}


def turn(commands, mode, builder, pairs, rounds):
    """The times of each language. In the reproducible mode their results are compared."""
    environment = builder.environment | {"PW85_REPRODUCIBLE": MODES[mode]}
    times, in_c = {}, None
    for language, command in commands.items():
        out = builder.work / f"results.{language}"
        times[language] = times_of(command, builder.work / pairs, out, environment, rounds)
        in_c = in_c or numbers_of(out)  # C comes first
        if mode == "reproducible":
            compare(language, numbers_of(out), in_c)
    return times


def measure(commands, mode, builder):
    """The least times of all languages, which take turns, for pairs of one size. Pairs of all sizes are compared once."""
    if mode == "reproducible":
        turn(commands, mode, builder, "pairs_of_all_sizes", 1)
    turns = [turn(commands, mode, builder, "pairs", ROUNDS) for _ in range(PROCESSES)]
    return {language: least([times[language] for times in turns]) for language in commands}


def significant(time):
    return f"{time:.3g}" if time < 1000 else f"{time:.0f}"


def line_of(language, mode, times, in_c):
    cells = []
    for name in FUNCTIONS:
        call, row = times[name]
        cells += [significant(call), significant(row), f"{row / in_c[name][1]:.2f}"]
    return ",".join([language, mode, *cells])


def main():
    builder, chosen = Builder(Path(sys.argv[1]).resolve()), sys.argv[2:] or LANGUAGES
    if not set(chosen) <= set(LANGUAGES):
        sys.exit(f"usage: languages.py BUILD [{' | '.join(LANGUAGES)}]...")
    write_pairs(builder.work / "pairs", [0])
    write_pairs(builder.work / "pairs_of_all_sizes", range(-40, 41))
    names = [name for name in LANGUAGES if name == "C" or name in chosen]
    commands = {name: getattr(builder, name.lower().replace("+", "p"))() for name in names}
    print("language,mode," + ",".join(f"{name}_{what}" for name in FUNCTIONS for what in ("call", "row", "ratio")))
    for mode in MODES:
        own_commands = {name: command for name, command in commands.items() if name != "JavaScript" or mode == "reproducible"}
        times = measure(own_commands, mode, builder)
        for language, own in times.items():
            print(line_of(language, mode, own, times["C"]), flush=True)


if __name__ == "__main__":
    main()
