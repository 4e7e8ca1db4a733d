"""Debian's list of the functions that the libraries export, each with the version that had it first: debian/libpw85-3.symbols.

A function that the list does not have gets the present version. api/committed.py writes the list or compares it.
"""

import re

from declarations import SOURCE, functions, version

LIST = SOURCE / "debian/libpw85-3.symbols"
LIBRARIES = {"libpw85": ("pw85.h", "pw85_gpu.h"), "libpw85_legacy": ("pw85_legacy.h", "pw85_zheng.h")}


def text():
    major = version().split(".")[0]
    first = dict(re.findall(r"^ (\w+)@Base (\S+)$", LIST.read_text(encoding="utf-8"), re.MULTILINE))
    lines = []
    for library, headers in LIBRARIES.items():
        lines.append(f"{library}.so.{major} libpw85-{major} #MINVER#")
        names = sorted(function.name for header in headers for function in functions(header))
        lines += [f" {name}@Base {first.get(name, version())}" for name in names]
    return "".join(f"{line}\n" for line in lines)
