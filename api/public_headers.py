# SPDX-License-Identifier: BSD-3-Clause
"""The public headers: which there are, their texts, and what stands in them beside functions."""

import re
from functools import cache
from pathlib import Path

from refusals import refuse

SOURCE = Path(__file__).resolve().parent.parent
INCLUDE = SOURCE / "include"
# The headers of functions of one row: a pair of ellipsoids; contacts of grains; an ellipsoid and a wall or another shape.
ONE_ROW = ("pw85.h", "pw85_grains.h", "pw85_shapes.h")
# Those of simulations, which pw85_simulation.h includes, and all with systems and objects.
SIMULATION = tuple(f"pw85_simulation_{name}.h" for name in ("state", "surroundings", "trials", "insertions", "observations", "addition"))
SYSTEMS = ("pw85_systems.h", *SIMULATION)
# The headers of the library pw85: one row; many rows; ellipsoids around points; systems of particles; simulations.
PARTS = (*ONE_ROW, "pw85_batch.h", "pw85_enclosing.h", *SYSTEMS)
# Those of the functions that take numbers and arrays of the host, whatever the library.
HOST_HEADERS = (*PARTS, "pw85_legacy.h", "pw85_zheng.h")
C_HEADERS = (*PARTS, "pw85_gpu.h", "pw85_zheng.h", "pw85_legacy.h", "pw85_pre1.h")
EVERY_HEADER = (*C_HEADERS, "pw85_any_dimension.h")
CPP_HEADERS = (
    "pw85/pw85.hpp",
    *(f"pw85/batch/{name}.hpp" for name in ("rows", "pairs")),
    "pw85/enclosing.hpp",
    *(f"pw85/systems/{name}.hpp" for name in ("lists", "sums", "periodic", "neighbors", "meshes")),
    *(f"pw85/simulation/{name}.hpp" for name in ("surroundings", "trials", "hard_ellipsoids", "addition", "random_addition")),
)
# What a header of C++ does not offer to users.
DETAIL = re.compile(r"^namespace (?:pw85::)?detail \{$.*?^\} // namespace (?:pw85::)?detail$", re.MULTILINE | re.DOTALL)


def source_text(name):
    """The text of a file of the source, by its name there."""
    return (SOURCE / name).read_text(encoding="utf-8")


replaced = {}  # texts of headers that are not yet those of the files
cached = []  # functions whose results follow from the texts


def of_texts(function):
    """A function that computes each result once, as long as the texts of the headers stay."""
    cached.append(cache(function))
    return cached[-1]


def replace(texts):
    """Takes these texts for those of headers."""
    replaced.update(texts)
    for function in cached:
        function.cache_clear()


def text_of(header):
    return replaced.get(header) or source_text(f"include/{header}")


def headers_in_folders():
    return sorted(path.relative_to(INCLUDE).as_posix() for path in INCLUDE.glob("pw85/*/*.hpp"))


def values(header):
    """The public structures that a C++ header declares or defines."""
    text = DETAIL.sub("", text_of(header))
    return re.findall(r"^(?:template <[^;{]*?> ?)?struct (\w+)(?:;| (?:: \w+ )?\{)", text, re.MULTILINE)


@cache
def version():
    """The version of the library, which stands in meson.build alone."""
    return re.search(r"^  version: '([\d.]+)'", source_text("meson.build"), re.MULTILINE)[1]


def with_version(template):
    return source_text(template).replace("@version@", version())


@cache
def statuses():
    """The status codes by their names in C: their names in C++ and their values."""
    found = re.findall(r"X\((PW85_\w+), (\w+), (\d+),", text_of("pw85/status.h"))
    return {c_name: (cpp_name, value) for c_name, cpp_name, value in found}


@cache
def macros():
    texts = (path.read_text(encoding="utf-8") for path in INCLUDE.rglob("*.h*"))
    return {*statuses(), *(name for text in texts for name in re.findall(r"#define (PW85_\w+)", text))}


@of_texts
def constants():
    """The macros of the C headers that are numbers, and the status codes, as texts."""
    found = {}
    for header in HOST_HEADERS:
        for line, text in enumerate(text_of(header).splitlines(), 1):
            if match := re.match(r"#define (PW85_\w+) (\S.*)|(?:typedef )?enum (?!pw85_status )", text):
                is_number = match[1] and re.fullmatch(r"[\d.e-]+", match[2])
                refuse(f"{header}:{line}", {f"constants are macros of decimal numbers, not: {text}": not is_number})
                found[match[1]] = match[2]
    return found | {name: value for name, (_, value) in statuses().items()}
