# SPDX-License-Identifier: BSD-3-Clause
"""Debian's lists of the functions that the libraries export, each with the version that had it first: debian/*.symbols, one for each
package.

A function that the list does not have gets the present version. api/committed.py writes the lists or compares them.
"""

import re

from declarations import PARTS, SOURCE, functions, version

# The packages, without the major version, and the headers of their libraries. A hyphen is between two numbers.
PACKAGES = {
    "libpw85-": {"libpw85": (*PARTS, "pw85/last_error.h", "pw85_any_dimension.h"), "libpw85_legacy": ("pw85_legacy.h", "pw85_zheng.h")},
    "libpw85-gpu": {"libpw85_gpu": ("pw85_gpu.h",)},
}


def text(package, libraries, known):
    major = version().split(".")[0]
    first = dict(re.findall(r"^ (\w+)@Base (\S+)$", known, re.MULTILINE))
    lines = []
    for library, headers in libraries.items():
        lines.append(f"{library}.so.{major} {package} #MINVER#")
        names = sorted(function.name for header in headers for function in functions(header))
        lines += [f" {name}@Base {first.get(name, version())}" for name in names]
    return "".join(f"{line}\n" for line in lines)


def files():
    """The texts of the lists by their paths."""
    texts = {}
    for name, libraries in PACKAGES.items():
        package = f"{name}{version().split('.')[0]}"
        path = SOURCE / "debian" / f"{package}.symbols"
        texts[path] = text(package, libraries, path.read_text(encoding="utf-8") if path.exists() else "")
    return texts
