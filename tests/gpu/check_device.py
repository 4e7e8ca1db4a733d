#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compiles the program for the device and looks at what comes of it. Usage: check_device.py PTXAS COMMAND...

The command must succeed without a word, and the program need nothing from outside. The first stages, which all pairs go through, must
keep everything in registers: no local memory, and where an assembler is here (PTXAS, or empty), as few registers as four blocks of
128 threads on a multiprocessor with 65536 have. The second stages may use local memory, but not more than a few kilobytes.
"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

KERNELS = [
    f"pw85_{what}_{stage}"
    for what in ("contact_batch", "overlap_batch", "derivatives_batch", "contact_pairs", "overlap_pairs", "derivatives_pairs")
    for stage in ("attempt", "fallback")
] + ["pw85_deliver"]
MOST_REGISTERS = {"attempt": 128, "fallback": 168, "deliver": 128}
MOST_LOCAL = {"attempt": 0, "fallback": 4096, "deliver": 0}

complaints = []


def complain(text):
    complaints.append(text)


def stage(kernel):
    return kernel.rsplit("_", 1)[1]


def check_usage(kernel, registers, local, spilled):
    print(f"{kernel}: {registers or '?'} registers, {local} bytes of local memory, {spilled} bytes spilled")
    if registers > MOST_REGISTERS[stage(kernel)]:
        complain(f"{kernel} has {registers} registers")
    if local > MOST_LOCAL[stage(kernel)]:
        complain(f"{kernel} has {local} bytes of local memory")
    if spilled > 0 and stage(kernel) != "fallback":
        complain(f"{kernel} spills {spilled} bytes")


def check_ptx(program):
    for outside in re.findall(r"^\.extern (.*)", program, re.MULTILINE):
        complain(f"from outside: {outside}")
    # A function's body ends with a brace in the first column.
    for entry in re.findall(r"\.entry (\w+)\(.*?^\}", program, re.MULTILINE | re.DOTALL):
        body = re.search(rf"\.entry {entry}\(.*?^\}}", program, re.MULTILINE | re.DOTALL)[0]
        local = sum(int(size) for size in re.findall(r"\.local .*\[(\d+)\]", body))
        if stage(entry) == "attempt" and re.search(r"\bcall\b", body):
            complain(f"{entry} calls functions")
        check_usage(entry, 0, local, 0)
    return re.findall(r"\.entry (\w+)\(", program)


def assemble(ptxas, path):
    command = [ptxas, "-arch=sm_90", "-v", str(path), "-o", "/dev/null"]
    text = subprocess.run(command, check=True, text=True, stderr=subprocess.PIPE).stderr
    functions = re.findall(
        r"Function properties for (\w+)\n\s*(\d+) bytes stack frame, (\d+) bytes spill stores, (\d+) bytes spill loads"
        r"(?:\n[^\n]*Used (\d+) registers)?",
        text,
    )
    for name, stack, stores, loads, registers in functions:
        if name in KERNELS:
            check_usage(name, int(registers), int(stack), int(stores) + int(loads))
    if not functions:
        complain("the assembler says nothing of functions")


def main():
    ptxas, command = sys.argv[1], sys.argv[2:]
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "program"
        done = subprocess.run([*command, "-o", str(path)], text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        print(done.stdout)
        if done.returncode != 0:
            sys.exit("it does not compile")
        program = path.read_text(encoding="utf-8")
        found = check_ptx(program)
        if ptxas:
            assemble(ptxas, path)
    if sorted(found) != sorted(KERNELS):
        complain(f"the kernels are {found}")
    print("\n".join(complaints))
    return 1 if complaints else 0


sys.exit(main())
