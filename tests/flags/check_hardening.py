# SPDX-License-Identifier: BSD-3-Clause
"""Whether shared libraries are hardened, as meson.build has it: tables of the linker are read-only once the library is loaded, the
stack is protected and not executable, and, on processors of x86-64, each exported function begins with the landing pad of an indirect
jump. Usage: check_hardening.py [--landing-pads] LIBRARY...
"""

import re
import subprocess
import sys


def read(*command):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, encoding="utf-8").stdout


def without_landing_pad(library):
    """The exported functions whose first instruction is another one."""
    exported = {line.split()[2] for line in read("nm", "--dynamic", "--defined-only", library).splitlines() if line.split()[1] == "T"}
    code = read("objdump", "--disassemble", "--no-show-raw-insn", library)
    first = dict(re.findall(r"^[0-9a-f]+ <(\w+)>:\n\s*[0-9a-f]+:\s*(\w+)", code, re.MULTILINE))
    return sorted(name for name in exported if first.get(name) != "endbr64")


def defects(library, landing_pads):
    segments = read("readelf", "--wide", "--program-headers", library)
    if "GNU_RELRO" not in segments:
        yield "has no part that is read-only after it is loaded"
    if not re.search(r"GNU_STACK.* RW ", segments):
        yield "has an executable stack"
    if not re.search(r"\bFLAGS\b.*BIND_NOW|FLAGS_1.*\bNOW\b", read("readelf", "--wide", "--dynamic", library)):
        yield "binds functions when they are called first"
    if "__stack_chk_fail" not in read("nm", "--dynamic", "--undefined-only", library):
        yield "does not protect the stack"
    if landing_pads and without_landing_pad(library):
        yield f"has functions without landing pads: {without_landing_pad(library)}"


arguments = sys.argv[1:]
pads = "--landing-pads" in arguments
found = [f"{library} {defect}" for library in arguments if library != "--landing-pads" for defect in defects(library, pads)]
print("\n".join(found))
sys.exit(1 if found else 0)
