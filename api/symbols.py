# SPDX-License-Identifier: BSD-3-Clause
"""Debian's lists of the functions that the libraries export, each with the version that had it first: debian/*.symbols, one for each
package.

A function that the list does not have gets the present version. api/committed.py writes the lists or compares them.
"""

import re

from declarations import functions
from public_headers import PARTS, SOURCE, source_text, version

# The packages, without the major version, and the headers of their libraries. A hyphen is between two numbers.
PACKAGES = {
    "libpw85-": {"libpw85": (*PARTS, "pw85/last_error.h", "pw85_any_dimension.h"), "libpw85_legacy": ("pw85_legacy.h", "pw85_zheng.h")},
    "libpw85-gpu": {"libpw85_gpu": ("pw85_gpu.h",)},
}


def files():
    major, texts = version().split(".")[0], {}
    for package, libraries in PACKAGES.items():
        path = f"debian/{package}{major}.symbols"
        known = source_text(path) if (SOURCE / path).exists() else ""
        first = dict(re.findall(r"^ (\w+)@Base (\S+)$", known, re.MULTILINE))
        texts[path] = ""
        for library, headers in libraries.items():
            names = sorted(function.name for function in functions(*headers))
            texts[path] += f"{library}.so.{major} {package}{major} #MINVER#\n"
            texts[path] += "".join(f" {name}@Base {first.get(name, version())}\n" for name in names)
    return texts
