# SPDX-License-Identifier: BSD-3-Clause
"""Whether archives have functions that a linker may replace, in the Test Anything Protocol.

Weak and unique symbols of one name are merged, and the one copy that stays may be for another processor or without NaN. So
pw85 has none, and what it uses of std:: has no instruction that depends on the processor. Usage: check_symbols.py NM OBJDUMP
ARCHIVE...
"""

import re
import subprocess
import sys

MERGED = re.compile(r"^\S+ [uvVwW] (\S+)$")
OF_PW85 = re.compile(r"^_Z+N?K?4pw85")
FLOATING_POINT = re.compile(r"%[xyz]mm|%st\b|%k[0-7]|\b[bhsdqvz]\d+\b[.,]")


def merged_symbols(nm, archive):
    lines = subprocess.run([nm, archive], check=True, text=True, stdout=subprocess.PIPE).stdout.splitlines()
    defined = (MERGED.match(line) for line in lines)
    return {match.group(1) for match in defined if match}


def with_floating_point(objdump, archive, symbols):
    """Those of some functions that use floating-point or vector registers."""
    found, function = set(), None
    command = [objdump, "-d", "--no-show-raw-insn", archive]
    for line in subprocess.run(command, check=True, text=True, stdout=subprocess.PIPE).stdout.splitlines():
        if label := re.match(r"^[0-9a-f]+ <(\S+)>:$", line):
            function = label.group(1)
        elif function in symbols and FLOATING_POINT.search(line.partition(":")[2]):
            found.add(function)
    return found


def offenders(nm, objdump, archive):
    merged = merged_symbols(nm, archive)
    return {symbol for symbol in merged if OF_PW85.match(symbol)} | with_floating_point(objdump, archive, merged)


def main():
    nm, objdump, *archives = sys.argv[1:]
    print(f"1..{len(archives)}")
    for number, archive in enumerate(archives, 1):
        found = sorted(offenders(nm, objdump, archive))
        for symbol in found:
            print(f"# {symbol}")
        print(f"{'not ok' if found else 'ok'} {number} {archive.rpartition('/')[2]}")


main()
