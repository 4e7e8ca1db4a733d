"""Compiles the interactive page's part in C++ to WebAssembly, as a script that pages can load from a file, too.

Usage: build.py COMPILER INCLUDE OUTPUT

The standard headers are those of GCC, of which only what needs no library is used: macros stand for what they would
include of the system's.
"""

import base64
import subprocess
import sys
import tempfile
from pathlib import Path

SOURCE = Path(__file__).with_name("interactive.cpp")
# With -mbulk-memory, which browsers know, copies need no memcpy().
OPTIONS = (
    "--target=wasm32 -mbulk-memory -std=c++20 -O2 -ffreestanding -fno-exceptions -fno-rtti -ffp-contract=off -fvisibility=hidden -nostdlib "
    "-nostdinc++ -D_GLIBCXX_OS_DEFINES -D__GLIBC_PREREQ(a,b)=1 -Wall -Wextra -Werror "
    "-Wl,--no-entry,--export=evaluate,--export=input,--export=output"
).split()


def standard_headers():
    """The folders that GCC searches for the headers of C++."""
    command = ["g++", "-E", "-x", "c++", "-v", "/dev/null"]
    listing = subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, encoding="utf-8")
    folders = [line.strip() for line in listing.stderr.splitlines() if line.startswith(" /")]
    return [option for folder in folders if "/c++/" in folder for option in ("-isystem", folder)]


def main():
    compiler, include, output = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        module = Path(folder) / "pw85.wasm"
        subprocess.run([compiler, *OPTIONS, *standard_headers(), f"-I{include}", SOURCE, "-o", module], check=True)
        text = base64.b64encode(module.read_bytes()).decode()
    Path(output).write_text(f'const PW85_WASM = "{text}";\n', encoding="utf-8")


main()
