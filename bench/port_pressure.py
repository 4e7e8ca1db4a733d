#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Estimates what limits the speed of the contact function. For many pairs it is the arithmetic of the loops, which keeps the ports
of the processor busy; for one pair it is the latency of operations that depend on each other.

    port_pressure.py BUILD

BUILD is a build directory with the targets avx512 and avx2. Needs objdump and llvm-mca, whose model of Skylake has the two ports
for 512 bits of later processors. Prints, for the loops over packs of eight pairs, their instructions and cycles per pack; and for
one pair, by the number of Halley steps, the cycles of the whole path without mispredicted branches, and the cycles that the ports
alone would need.
"""

import heapq
import pathlib
import re
import subprocess
import sys

PACKS = {
    "contact_batch": r"compute<pw85::detail::kernels::PairArrays<3>, pw85::detail::kernels::ContactArrays>",
    "overlap_batch": r"compute<pw85::detail::kernels::PairArrays<3>, pw85::detail::kernels::OverlapArray>",
}
ONE_PAIR = r"> pw85::detail::maximize<double, 3>"
ARITHMETIC = r"v(f|mul|add|sub|div|max|min|rcp|rsqrt|sqrt|cmp|blend)"
SHUFFLE = r"v(unpck|perm|insert|broadcast)"
TAKEN = 1000  # cost of a jump that is taken, which leaves the common path


def output(command, **options):
    return subprocess.run(command, check=True, text=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, **options).stdout


def instructions(disassembly, function):
    """The addresses and instructions of a function."""
    body = re.search(rf"^[0-9a-f]+ <[^\n]*{function}[^\n]*>:\n(.*?)\n\n", disassembly, re.M | re.S).group(1)
    return [(int(m.group(1), 16), m.group(2)) for m in re.finditer(r"^ *([0-9a-f]+):\t(.*)$", body, re.M)]


def jump_target(code, places, i):
    """The target of instruction i if it is a jump, or None."""
    jump = re.match(r"j\w+\s+([0-9a-f]+)", code[i][1])
    return places.get(int(jump.group(1), 16)) if jump else None


def loops(code):
    """The first instruction of each loop, and its body up to the last jump back."""
    places = {address: i for i, (address, _) in enumerate(code)}
    found = {}
    for i in range(len(code)):
        target = jump_target(code, places, i)
        if target is not None and target <= i:
            found[target] = i
    return {begin: [text for _, text in code[begin : end + 1]] for begin, end in sorted(found.items())}


def is_call(text):
    return text.startswith("call")


def search_loop(code):
    """The first instruction of the longest loop that the function enters without a call, and the path of one round."""
    for begin, body in sorted(loops(code).items(), key=lambda item: -len(item[1])):
        ways = {i: path(code, 0, lambda k, i=i: k == i, is_call) for i in range(begin, begin + len(body))}
        head = min((i for i in ways if ways[i]), key=lambda i: len(ways[i]), default=None)
        step = head and path(code, head, lambda i, head=head: i == head, lambda text: "sqrt" in text)
        if step:
            return head, step
    raise ValueError("no loop")


def straight(texts):
    return [re.sub(r"<.*?>|#.*", "", text) for text in texts if not re.match(r"j|call|ret|push|pop", text)]


def simulate(texts, iterations):
    """The cycles of so many consecutive runs, and the cycles of ports 0, 1 and 5 per run."""
    command = ["llvm-mca", "-mcpu=skylake-avx512", "-noalias", f"-iterations={iterations}"]
    report = output(command, input="\n".join(straight(texts)) + "\n")
    cycles = int(re.search(r"Total Cycles:\s+(\d+)", report).group(1))
    busy = re.search(r"Resource pressure per iteration:\n.*\n(.*)", report).group(1).replace(" - ", " 0 ").split()
    return cycles, busy[2], busy[3], busy[7]


def path(code, begin, is_end, is_barred):
    """The path from an instruction to the next one for which is_end(), without instructions for which is_barred(), and with the
    fewest jumps that are taken."""
    places = {address: i for i, (address, _) in enumerate(code)}
    queue, seen = [(0, begin, [])], set()
    while queue:
        cost, i, way = heapq.heappop(queue)
        if way and is_end(i):
            return way
        text = code[i][1]
        if (i in seen and way) or is_barred(text):
            continue
        seen.add(i)
        target = jump_target(code, places, i)
        if target is not None:
            heapq.heappush(queue, (cost + TAKEN, target, [*way, text]))
        if not re.match(r"jmp|ret", text):
            heapq.heappush(queue, (cost + 1, i + 1, [*way, text]))
    return []


def many_pairs(disassembly):
    """Of loops with the same operations, which differ in the jumps around them, the shortest one is shown."""
    for name, function in PACKS.items():
        shown = {}
        for body in sorted(loops(instructions(disassembly, function)).values(), key=len, reverse=True):
            wide = [text for text in body if "zmm" in text]
            if len(wide) < 40:
                continue
            _, port0, _, port5 = simulate(body, 100)
            arithmetic, shuffles = (sum(bool(re.match(p, text)) for text in wide) for p in (ARITHMETIC, SHUFFLE))
            shown[arithmetic, shuffles] = f"{len(body)} instructions; port 0 busy {port0}, port 5 {port5} cycles"
        for (arithmetic, shuffles), text in shown.items():
            print(f"{name}: {arithmetic} arithmetic, {shuffles} shuffles: {text}")


def one_pair(disassembly):
    code = instructions(disassembly, ONE_PAIR)
    head, step = search_loop(code)
    start = path(code, 0, lambda i: i == head, is_call)
    last = path(code, head, lambda i: code[i][1].startswith("ret"), is_call)
    print(f"one pair: {len(start)} instructions before the first step, {len(step)} in a step, {len(last)} in the last and the end")
    before = 0
    for steps in range(1, 5):
        cycles, port0, port1, port5 = simulate(start + step * (steps - 1) + last, 1)
        more = f", {cycles - before} more" if before else ""
        print(f"{steps} steps: {cycles} cycles{more}; ports 0, 1 and 5 busy {port0}, {port1} and {port5}")
        before = cycles


def main():
    simd = pathlib.Path(sys.argv[1]) / "src" / "simd"
    for folder, unit, report in (("lanes_avx512", "lanes_contact", many_pairs), ("lanes_avx512", "lanes_overlap", many_pairs),
                                 ("shared_avx2", "shared_solver", one_pair)):
        report(output(["objdump", "-d", "-C", "--no-show-raw-insn", simd / f"libpw85_{folder}.a.p" / f"{unit}.cpp.o"]))


main()
