# SPDX-License-Identifier: BSD-3-Clause
"""Debian's lists of the functions that the libraries export, each with the version that had it first: debian/*.symbols, one for each
package.

A function that the list does not have gets the present version. api/committed.py writes the lists or compares them.
"""

import re

from declarations import functions
from public_headers import PARTS, SOURCE, version

# The packages, without the major version, and the headers of their libraries. A hyphen is between two numbers.
PACKAGES = {
    "libpw85-": {"libpw85": (*PARTS, "pw85/last_error.h", "pw85_any_dimension.h"), "libpw85_legacy": ("pw85_legacy.h", "pw85_zheng.h")},
    "libpw85-gpu": {"libpw85_gpu": ("pw85_gpu.h",)},
}


def files():
    """The texts of the lists by their paths."""
    major, texts = version().split(".")[0], {}
    for package, libraries in PACKAGES.items():
        path = SOURCE / f"debian/{package}{major}.symbols"
        first = dict(re.findall(r"^ (\w+)@Base (\S+)$", path.read_text(encoding="utf-8") if path.exists() else "", re.MULTILINE))
        texts[path] = ""
        for library, headers in libraries.items():
            names = sorted(function.name for function in functions(*headers))
            texts[path] += f"{library}.so.{major} {package}{major} #MINVER#\n"
            texts[path] += "".join(f" {name}@Base {first.get(name, version())}\n" for name in names)
    return texts
