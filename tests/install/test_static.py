# SPDX-License-Identifier: BSD-3-Clause
"""What programs take from the static library: the functions that they call, and what those need.

Prints the Test Anything Protocol. Usage: test_static.py SOURCE_DIR BUILD_DIR LIBRARY
"""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

# The calls of programs, the most bytes of text that each adds to an empty program, and whether it may need GSL and threads.
CASES = {
    "version": ("return pw85_version()[0];", 10_000, False, False),
    # Clang 14 takes the most, 262,300 bytes for the contact: 150,400 are the solver for wide numbers, 8,000 the record of the cause
    # of a refusal, which knows the names of arrays. GCC 12 takes 65,700 and 5,600 for these two.
    "overlap": ("int yes = 0; return pw85_overlap(r, q, q, &yes) + yes;", 270_000, False, False),
    "contact": ("return pw85_contact(r, q, q, out);", 270_000, False, False),
    "contact of many": ("return pw85_contact_batch(1, r, q, q, out, 0);", 310_000, False, True),
    "Brent's method": ("return pw85_contact_function(r, q, q, out);", 300_000, True, False),  # with Boost.Math, too
}
PROGRAM = """\
#include <pw85.h>
#include <pw85_batch.h>
int main(int x, char **words)
{{
    double const r[3] = {{x, x, x}}, q[6] = {{x, 0, 0, x, 0, x}};
    double out[2];
    (void)words; (void)r; (void)q; (void)out;
    {}
}}
"""


def output(*command, **environment):
    arguments = [str(word) for word in command]
    return subprocess.run(arguments, check=True, text=True, stdout=subprocess.PIPE, env={**os.environ, **environment}).stdout


class Programs:
    def __init__(self, source, build, library, folder):
        self.include = [f"-I{source / 'include'}", f"-I{build / 'include'}"]
        flags = output("pkg-config", "--static", "--libs", "pw85", PKG_CONFIG_PATH=str(build / "meson-uninstalled")).split()
        self.flags = [str(library) if flag == "-lpw85" else flag for flag in flags]
        self.source, self.program = folder / "a.c", folder / "a"
        self.empty = self.linked("return 0;")

    def linked(self, call):
        """The bytes of text of a program."""
        self.source.write_text(PROGRAM.format(call))
        output(*os.environ.get("CC", "cc").split(), "-std=c99", *self.include, self.source, "-o", self.program, *self.flags)
        return int(output("size", self.program).splitlines()[1].split()[0])

    def complaints(self, call, most, with_gsl, with_threads):
        size = self.linked(call) - self.empty
        print(f"# {size} bytes")
        if size > most:
            yield f"takes {size} bytes, more than {most}"
        symbols = output("nm", self.program)
        if "gsl_" in symbols and not with_gsl:
            yield "takes GSL"
        if "GOMP_" in symbols and not with_threads:
            yield "takes threads"


def main():
    source, build, library = (Path(word).resolve() for word in sys.argv[1:])
    print(f"1..{len(CASES)}")
    with tempfile.TemporaryDirectory(prefix="pw85-static-") as folder:
        programs = Programs(source, build, library, Path(folder))
        for number, (name, case) in enumerate(CASES.items(), 1):
            found = list(programs.complaints(*case))
            print(f"{'not ok' if found else 'ok'} {number} {name}", *(f"# {text}" for text in found), sep="\n", flush=True)


main()
