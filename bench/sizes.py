#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures what functions and the library cost before they run: time of compilation, and bytes of code.

Usage: sizes.py BUILD functions|parts, a build directory with both kinds of library.

`functions` prints the rows `function,headers_seconds,headers_bytes,linked_seconds,linked_bytes,static_bytes`: for a file of C++ that
calls the function of pw85/pw85.hpp, and for one that calls that of pw85/linked.hpp, seconds of processor time of `c++ -O2 -c`, the least
of some, and bytes of text; and the bytes of text of a program in C with the function of the library, linked statically as pkg-config says,
without those of an empty program. The row `none` is a file that includes <cmath> alone.
`parts` prints `part,bytes`: the text of the shared libraries, and of the units in the folders of src/ of which libpw85 consists, those of
src/simd/ by their kinds.
"""

import csv
import os
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
COLUMNS = {
    "functions": ["function", "headers_seconds", "headers_bytes", "linked_seconds", "linked_bytes", "static_bytes"],
    "parts": ["part", "bytes"],
}
ROOMS = sorted(path.name for path in (ROOT / "src").iterdir() if path.is_dir())
LIBRARIES = ("libpw85", "libpw85_gpu", "libpw85_legacy")
# The same values in both languages: a pair, a way and a motion, a triangle.
VALUES = {
    "cpp": "pw85::Vector<double, 3> const r{x, x, x}, v{x, 1, 2}, w{x, 3, 1}; "
           "pw85::SymmetricMatrix<double, 3> const q{x, 0, 0, x, 0, x}; pw85::Motion<double, 3> const m{};",
    "c": "double const r[3] = {x, x, x}, v[3] = {x, 1, 2}, w[3] = {x, 3, 1}, q[6] = {x, 0, 0, x, 0, x}; pw85_motion const m = {0};",
}
# The arguments of each function in C++, those in C, and what C++ returns beside a structure.
FUNCTIONS = {
    "contact": ("r, q, q", "r, q, q, out", "mu2"),
    "overlap": ("r, q, q", "r, q, q, &yes", "overlap"),
    "distance": ("r, q, q", "r, q, q, out, 0, 0", "distance"),
    "contact_rounded": ("r, q, q", "r, q, q, out", "mu2"),
    "contains": ("r, q, q", "r, q, q, &yes", "contains"),
    "containment": ("r, q, q", "r, q, q, out, 0", "mu2"),
    "penetration": ("r, q, q", "r, q, q, out, 0", "depth"),
    "closest_passage": ("r, q, q, v, x", "r, q, q, v, x, out, 0", "mu2"),
    "first_contact": ("r, q, q, m, m, x", "r, q, q, &m, &m, x, out", "time"),
    "contact_triangle": ("r, v, w, q", "r, v, w, q, out, 0", "mu2"),
}


def text_bytes(*files):
    """Bytes of text of some files, together."""
    lines = subprocess.run(["size", *files], check=True, text=True, stdout=subprocess.PIPE).stdout.splitlines()[1:]
    return sum(int(line.split()[0]) for line in lines)


def processor_seconds(command):
    before = os.times()
    subprocess.run(command, check=True)
    after = os.times()
    return after.children_user - before.children_user + after.children_system - before.children_system


class Sizes:
    def __init__(self, build, folder):
        self.build, self.folder = build, folder
        self.include = [f"-I{path}" for path in (ROOT / "include", build / "include")]
        self.empty = self.static_bytes("int main(void) { return 0; }\n")

    def compiled(self, source):
        """Seconds and bytes of a file of C++."""
        path, done = self.folder / "a.cpp", self.folder / "a.o"
        path.write_text(source)
        command = ["c++", "-std=c++20", "-O2", *self.include, "-c", path, "-o", done]
        seconds = min(processor_seconds(command) for _ in range(1 if "PW85_MEASURE_ONCE" in os.environ else 5))
        return f"{seconds:.2f}", text_bytes(done)

    def static_bytes(self, source):
        """Bytes of a program in C with the static library."""
        path, program = self.folder / "a.c", self.folder / "a"
        path.write_text(source)
        environment = {**os.environ, "PKG_CONFIG_PATH": str(self.build / "meson-uninstalled")}
        query = ["pkg-config", "--static", "--libs", "pw85"]
        flags = subprocess.run(query, check=True, text=True, stdout=subprocess.PIPE, env=environment).stdout
        flags = flags.replace("-lpw85", str(self.build / "src" / "libpw85.a")).split()
        subprocess.run(["cc", "-std=c99", "-O2", *self.include, path, "-o", program, *flags], check=True)
        return text_bytes(program)

    def of_function(self, name, arguments, c_arguments, member):
        body = f"double f(double x) {{ {VALUES['cpp']} return pw85::{name}({arguments}).{member}; }}\n"
        program = f"#include <pw85.h>\nint main(int x, char **a) {{ {VALUES['c']} double out[2]; int yes = (a != 0);\n"
        program += f"  (void)r; (void)v; (void)w; (void)q; (void)m; (void)out; return pw85_{name}({c_arguments}) + yes; }}\n"
        return self.row(name, "pw85/pw85.hpp", "pw85/linked.hpp", body, program)

    def row(self, name, header, linked, body="", program=None):
        (seconds, size), (linked_seconds, linked_size) = (self.compiled(f"#include <{one}>\n{body}") for one in (header, linked))
        static = self.static_bytes(program) - self.empty if program else 0
        return dict(zip(COLUMNS["functions"], (name, seconds, size, linked_seconds, linked_size, static), strict=True))

    def functions(self):
        yield self.row("none", "cmath", "cmath")
        program = "#include <pw85.h>\nint main(void) { return pw85_version()[0]; }\n"
        yield self.row("version", "pw85/pw85.hpp", "pw85/linked.hpp", program=program)
        number = 2 if "PW85_MEASURE_ONCE" in os.environ else len(FUNCTIONS)  # in a trial run few: each takes seconds
        for name, words in list(FUNCTIONS.items())[:number]:
            yield self.of_function(name, *words)


def parts(build):
    for library in LIBRARIES:
        built = next((build / "src").rglob(f"{library}.so"), None)
        if built is None:
            sys.exit(f"{build} has no {library}.so: build the whole project first")
        yield {"part": library, "bytes": text_bytes(built)}
    units = {}
    for unit in [*(build / "src").glob("libpw85*.p/*.o"), *(build / "src/simd").glob("*.p/*.o")]:
        name, kind = unit.name.removeprefix(".._"), unit.parent.name.removeprefix("libpw85_").partition(".")[0].partition("_")[0]
        if kind.startswith("legacy"):
            continue
        room = next((room for room in ROOMS if name.startswith(f"{room}_")), "simd")
        room = f"simd, {kind}" if unit.parent.parent.name == "simd" and not unit.name.startswith("..") else room
        units.setdefault(room, []).append(unit)
    for part, files in sorted(units.items()):
        yield {"part": part, "bytes": text_bytes(*files)}


def main():
    build, what = Path(sys.argv[1]).resolve(), sys.argv[2]
    with tempfile.TemporaryDirectory() as folder:
        rows = list(Sizes(build, Path(folder)).functions() if what == "functions" else parts(build))
        table = csv.DictWriter(sys.stdout, COLUMNS[what], lineterminator="\n")
        table.writeheader()
        table.writerows(rows)


if __name__ == "__main__":
    main()
