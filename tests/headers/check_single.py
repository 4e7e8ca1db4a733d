# SPDX-License-Identifier: BSD-3-Clause
"""The single header that scripts/single_header.py makes, in a folder without any other: it compiles without warnings, in two units that
link, by all compilers that are there, and a compiler reads the same text as by pw85/pw85.hpp, so that all results are the same bits.

Usage: check_single.py SOURCE COMPILER...
"""

import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

STRICT = ["-std=c++20", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wsign-conversion", "-Wshadow", "-Werror"]
UNITS = {
    "one.cpp": """
#include "pw85_all.hpp"
#include "pw85_all.hpp"
char const *other();
int main()
{
    pw85::Vector<double, 3> const r12{3.0, 0.0, 0.0};
    pw85::SymmetricMatrix<double, 3> const q{1.0, 0.0, 0.0, 1.0, 0.0, 1.0};
    return pw85::contact(r12, q, q).mu2 == 2.25 && *other() == 's' ? 0 : 1;
}
""",
    "two.cpp": """
#include "pw85_all.hpp"
char const *other() { return pw85::strerror(pw85::Status::success); }
""",
}


def run(*command, folder):
    return subprocess.run([str(word) for word in command], cwd=folder, check=True, text=True, stdout=subprocess.PIPE).stdout


def preprocessed(compiler, include, header, folder):
    """What a compiler reads, as words."""
    return run(*compiler, "-std=c++20", "-E", "-P", "-x", "c++", *include, "-include", header, "/dev/null", folder=folder).split()


def main():
    source, compilers = Path(sys.argv[1]), [word.split() for word in sys.argv[2:]]
    with tempfile.TemporaryDirectory(prefix="pw85-single-") as name:
        folder = Path(name)
        text = run(sys.executable, source / "scripts/single_header.py", folder=folder)
        (folder / "pw85_all.hpp").write_text(text, encoding="utf-8")
        for unit, program in UNITS.items():
            (folder / unit).write_text(program, encoding="utf-8")
        run(*compilers[0], *STRICT, *UNITS, "-o", "program", folder=folder)
        run("./program", folder=folder)
        for compiler in [["g++"], ["clang++"]]:
            if compiler not in compilers and shutil.which(compiler[0]):
                run(*compiler, *STRICT, "-fsyntax-only", *UNITS, folder=folder)
        alone = preprocessed(compilers[0], [], folder / "pw85_all.hpp", folder)
        if alone != preprocessed(compilers[0], ["-I", source / "include"], "pw85/pw85.hpp", folder):
            print("the single header is not what pw85/pw85.hpp includes")
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
