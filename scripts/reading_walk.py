#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""How far a reader of the headers walks from a question to its answer, for an ordinary pair: functions and files entered, and returns.

Usage: reading_walk.py [FOLDER...], the folders with pw85/pw85.hpp and pw85/version.h (by default include and build-test/include)

The reader follows the calls that one computation makes, enters each function once, and goes back to the caller at its end. A return is
a change to a file that was seen before. Functions of pw85/algebra, which the reader knows, do not count. Needs g++ and addr2line.
"""

import subprocess
import sys
import tempfile
from pathlib import Path

QUESTIONS = {"contact": "contact(r, q1, q2)", "overlap": "overlap(r, q1, q2)", "distance": "distance(2.0 * r, q1, q2)",
             "common part": "overlap_volume(r, q1, q2)"}  # fmt: skip
PROGRAM = """#include <cstdio>
#include <pw85/pw85.hpp>
#define PW85_HOOK(name, sign) extern "C" __attribute__((no_instrument_function)) \
    void __cyg_profile_func_##name(void *f, void *) { if (recording) std::printf(sign " %p\\n", f); }
bool recording = false;
PW85_HOOK(enter, "+")
PW85_HOOK(exit, "-")
int main()
{
    pw85::Vector<double, 3> const r{1.1, 0.7, 0.4};
    pw85::SymmetricMatrix<double, 3> const q1{1.5, 0.2, -0.1, 0.8, 0.15, 0.6}, q2{0.5, -0.1, 0.05, 1.2, 0.1, 0.9};
    recording = true;
    (void)pw85::QUESTION;
    recording = false;
}
"""


def walk(program):
    """The functions that are entered, and the files in the order in which they are read."""
    trace = [line.split() for line in subprocess.check_output([program], text=True).splitlines()]
    addresses = sorted({address for _, address in trace})
    lines = subprocess.check_output(["addr2line", "-e", program, *addresses], text=True).split("\n")
    place = {address: line.partition(" ")[0] for address, line in zip(addresses, lines)}
    seen, files, stack = set(), [], []
    for sign, address in trace:
        where = place[address]
        if sign == "-":
            stack.pop()
        elif None in stack or where in seen or "/pw85/" not in where or "/pw85/algebra/" in where:
            stack.append(None)  # below, nothing is read
        else:
            seen.add(where)
            stack.append(where)
        if stack and None not in stack and files[-1:] != [stack[-1].partition(":")[0]]:
            files.append(stack[-1].partition(":")[0])
    return seen, files


include = [f"-I{folder}" for folder in sys.argv[1:] or ["include", "build-test/include"]]
print(f"{'':12}{'functions':>10}{'files':>7}{'returns':>9}")
with tempfile.TemporaryDirectory() as folder:
    source, program = Path(folder, "walk.cpp"), Path(folder, "walk")
    for name, call in QUESTIONS.items():
        source.write_text(PROGRAM.replace("QUESTION", call), encoding="utf-8")
        subprocess.run(["g++", "-std=c++20", "-O0", "-g", "-no-pie", "-finstrument-functions", *include, source, "-o", program], check=True)
        functions, files = walk(program)
        print(f"{name:12}{len(functions):10}{len(set(files)):7}{len(files) - len(set(files)):9}")
