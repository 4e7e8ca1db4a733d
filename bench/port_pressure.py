#!/usr/bin/python3
"""What bounds the contact function of many pairs: the arithmetic of its loops, and how long ports are busy with it.

    port_pressure.py OBJECT

OBJECT is the lanes.cpp.o of the target avx512 in a build directory. Needs objdump and llvm-mca, whose model of Skylake has the two
ports for 512 bits of later processors. Prints, for each loop over packs of eight pairs, its instructions and cycles per pack.
"""

import re
import subprocess
import sys

KERNEL = r"compute<pw85::kernels::PairArrays<3>, pw85::kernels::ContactArrays>"
ARITHMETIC = r"v(f|mul|add|sub|div|max|min|rcp|rsqrt|sqrt|cmp|blend)"
SHUFFLE = r"v(unpck|perm|insert|broadcast)"


def output(command, **options):
    return subprocess.run(command, check=True, text=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, **options).stdout


def instructions(object_file):
    """Addresses and instructions of the kernel."""
    text = output(["objdump", "-d", "-C", "--no-show-raw-insn", object_file])
    body = re.search(rf"^[0-9a-f]+ <[^\n]*{KERNEL}[^\n]*>:\n(.*?)\n\n", text, re.M | re.S).group(1)
    return [(int(m.group(1), 16), m.group(2)) for m in re.finditer(r"^ *([0-9a-f]+):\t(.*)$", body, re.M)]


def loops(code):
    """The bodies between jumps back and where they lead."""
    places = {address: i for i, (address, _) in enumerate(code)}
    found = {}
    for i, (address, text) in enumerate(code):
        jump = re.match(r"j\w+\s+([0-9a-f]+)", text)
        target = int(jump.group(1), 16) if jump else address + 1
        if target <= address and target in places:
            found[places[target]] = i
    return [[text for _, text in code[begin : end + 1]] for begin, end in sorted(found.items())]


def main():
    for body in loops(instructions(sys.argv[1])):
        wide = [text for text in body if "zmm" in text]
        if len(wide) < 40:
            continue
        straight = [re.sub(r"<.*?>|#.*", "", text) for text in body if not re.match(r"j|call", text)]
        report = output(["llvm-mca", "-mcpu=skylake-avx512", "-noalias"], input="\n".join(straight) + "\n")
        busy = re.search(r"Resource pressure per iteration:\n.*\n(.*)", report).group(1).split()
        arithmetic, shuffles = (sum(bool(re.match(p, text)) for text in wide) for p in (ARITHMETIC, SHUFFLE))
        print(f"{len(body)} instructions: {arithmetic} arithmetic, {shuffles} shuffles; port 0 busy {busy[2]}, port 5 {busy[7]} cycles")


main()
