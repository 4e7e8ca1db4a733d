# SPDX-License-Identifier: BSD-3-Clause
"""Whether DLLs export functions of pw85, and no others. Usage: check_exports.py OBJDUMP DLL..."""

import re
import subprocess
import sys


def exports(objdump, dll):
    text = subprocess.run([objdump, "-p", dll], check=True, text=True, stdout=subprocess.PIPE).stdout
    names = text.partition("[Ordinal/Name Pointer] Table")[2].partition("\n\n")[0]
    return re.findall(r"^\s*\[ *\d+\](?: \+base\[ *\d+\])? +(?:[0-9a-f]+ +)?(\w+)$", names, re.MULTILINE)


def main():
    objdump, *dlls = sys.argv[1:]
    good = True
    for dll in dlls:
        names = exports(objdump, dll)
        foreign = [name for name in names if not name.startswith("pw85")]
        print(f"{dll}: {len(names)} functions, foreign: {foreign}")
        good = good and names and not foreign
    return 0 if good else 1


sys.exit(main())
