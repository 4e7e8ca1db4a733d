#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures what other choices of the constants of the solver would cost.

    choices.py BUILD [COMPILER]

Compiles choices.cpp with one constant of the headers replaced at a time, and prints three tables. Nothing is timed.
1. Constants of the solver: the mean number of evaluations of f at aspect ratios 2, 10, 100, 10⁴ and 10⁶, the largest number, and
   the per cent of pairs that are solved in the factorised form at 10⁴ and 10⁶.
2. Points of the test on the quartic: the per cent of pairs that 1, 2 and 4 of them leave undecided, and that 1 to 5 tests along
   the fixed-point map leave undecided.
3. The search for the normal of a distance: mean numbers of steps and solutions, and the per cent of searches that start again and
   that are nested, at aspect ratios 2, 10, 100, 1000 and 10⁴.
BUILD is a build directory, from which it takes version.h.
"""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent

# The header, its text with the constant, the same text with {} for the constant, and the values to try. The first is the constant.
CHOICES = [
    ("contact/iteration.hpp", "T(0.625) * (s.sum", "T({}) * (s.sum", ["0.625", "0.3", "0.45", "0.8", "1.2"]),
    ("contact/iteration.hpp", "result_digits<T>() / 9 + 2", "result_digits<T>() / 9 + {}", ["2", "1", "3", "5"]),
    ("contact/iteration.hpp", "minimum(T(0.25), maximum(T(-0.25), bent))", "minimum(T({0}), maximum(T(-{0}), bent))",
     ["0.25", "0.01", "4.0"]),
    ("contact/factorized_search.hpp", "shortest < T(0.1)", "shortest < T({})", ["0.1", "0.01", "0.5"]),
    ("contact/factorized_search.hpp", "(candidate.t, free_factorized_steps)", "(candidate.t, {})", ["3", "1", "6"]),
    ("contact/rational.hpp", "T(1024 * unit_roundoff<T>())", "T({} * unit_roundoff<T>())", ["1024", "0", "32", "32768", "1048576"]),
    ("contact/iteration.hpp", "max_rational_steps = 8", "max_rational_steps = {}", ["8", "4", "6", "12"]),
]

NORMAL_CHOICES = [
    ("distance/normal_search.hpp", "bound = T(1.5);", "bound = T({});", ["1.5", "1", "1.9"]),
    ("distance/normal_search.hpp", "mantissa_digits<T>() / 4", "mantissa_digits<T>() / {}", ["4", "3", "6"]),
    ("distance/normal_search.hpp", "max_normal_steps = 16", "max_normal_steps = {}", ["16", "10", "24"]),
    ("distance/normal_search.hpp", "max_last_steps = 6", "max_last_steps = {}", ["6", "0", "2"]),
]

# The points of the test on the quartic. The first two of the header are 1 and 2; these others are tried.
POINTS = (
    [1, 2, 0.5, 1.4],
    [1, 0.6, 1.7, 0.36],
    [1, 0.8, 1.25, 0.64],
)


def compile_program(build, compiler, include, program):
    flags = ["-std=c++20", "-O1", "-ffp-contract=off", f"-I{include}", f"-I{build}/include", f"-I{ROOT}/tests"]
    subprocess.run([compiler, *flags, ROOT / "bench" / "choices.cpp", "-o", program], check=True)


def rows_of(program, *arguments):
    done = subprocess.run([program, *map(str, arguments)], check=True, text=True, stdout=subprocess.PIPE)
    return [line.split(",") for line in done.stdout.splitlines()]


def run(build, compiler, header, old, new, *arguments):
    with tempfile.TemporaryDirectory() as folder:
        include = pathlib.Path(folder) / "pw85"
        shutil.copytree(ROOT / "include" / "pw85", include)
        text = (include / header).read_text()
        assert text.count(old) == 1, f"{header} has {text.count(old)} times {old}"
        (include / header).write_text(text.replace(old, new))
        solver = include / "contact" / "solver.hpp"  # its assertions hold only for the constants of the headers
        solver.write_text("\n".join(line for line in solver.read_text().splitlines() if "static_assert(" not in line))
        program = pathlib.Path(folder) / "choices"
        compile_program(build, compiler, folder, program)
        return rows_of(program, *arguments)


def print_tests(build, compiler):
    text = (ROOT / "include" / "pw85" / "overlap" / "quartic.hpp").read_text(encoding="utf-8")
    own = ["1", re.search(r"second_point = (\d+)", text)[1], "0.5", "0.25"]
    with tempfile.TemporaryDirectory() as folder:
        program = pathlib.Path(folder) / "choices"
        compile_program(build, compiler, ROOT / "include", program)
        print("undecided [%] at aspect 2, 10, 100 after 1, 2, 4 points; after 1 ... 5 tests along the fixed-point map")
        for points in (own, *POINTS):
            undecided = " | ".join(" ".join(row[1:]) for row in rows_of(program, *points))
            print(" ".join(map(str, points)), undecided, sep=": ", flush=True)


def print_normals(build, compiler):
    print("steps solutions % anew % nested, at aspect 2 ... 1e4")
    for header, old, pattern, values in NORMAL_CHOICES:
        for value in values:
            new = pattern.format(value)
            rows = run(build, compiler, header, old, new, "distance")
            print(f"{header + ': ' + new:60}", " | ".join(" ".join(row[1:]) for row in rows), flush=True)


def main():
    build, compiler = sys.argv[1], (sys.argv[2:] or ["g++"])[0]
    print(f"{'constant':60} {'evaluations at aspect 2 ... 1e6':36} largest   % factorised")
    for header, old, pattern, values in CHOICES:
        for value in values:
            new = pattern.format(value)
            rows = run(build, compiler, header, old, new)
            means = " ".join(f"{float(row[1]):6.3f}" for row in rows)
            largest = max(int(row[2]) for row in rows)
            shares = " ".join(f"{row[3]:>6}" for row in rows[3:])
            print(f"{header + ': ' + new:60} {means:36} {largest:7}   {shares}", flush=True)
    print_tests(build, compiler)
    print_normals(build, compiler)


if __name__ == "__main__":
    main()
