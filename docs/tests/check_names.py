"""Whether namespace pw85 offers the names that the reference lists for C++, and no others: as Clang completes `pw85::`.

Usage: check_names.py CLANG SOURCE INCLUDE, where INCLUDE has version.h. Without Clang the test is skipped.
"""

import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "api"))
from declarations import functions
from public_headers import values

HEADERS = (
    *(f"pw85/{name}.hpp" for name in ("pw85", "batch", "enclosing", "systems", "simulation")),
    *(f"pw85/history/{name}.hpp" for name in ("legacy", "zheng")),
)
NO_NAMES = {"detail", "operator"}  # what is not public; operators are found by the types of their operands


def listed(source):
    """What the reference lists, by its directives (docs/extensions/reference.py)."""
    page = "\n".join(path.read_text(encoding="utf-8") for path in sorted((source / "docs/api").glob("cpp*.rst")))
    for kind, argument in re.findall(r"^\.\. ([\w-]+):: ([\w/.:]+)", page, re.MULTILINE):
        if kind == "cpp-functions":
            yield from (f"pw85::{function.name}" for function in functions(argument))
        elif kind == "cpp-values":
            yield from (f"pw85::{name}" for name in values(argument))
        elif kind in ("doxygenfunction", "doxygenstruct", "doxygenclass", "doxygenenum", "doxygentypedef"):
            yield argument


def offered(namespace, clang, includes):
    """The names in a namespace."""
    lines = [*(f"#include <{header}>" for header in HEADERS), f"auto x = {namespace}::"]
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder) / "names.cpp"
        program.write_text("\n".join(lines) + "\n", encoding="utf-8")
        place = f"-code-completion-at={program}:{len(lines)}:{len(lines[-1]) + 1}"
        command = [clang, "-std=c++20", "-fsyntax-only", *(f"-I{path}" for path in includes), "-Xclang", place, program]
        done = subprocess.run(command, text=True, capture_output=True, check=False)
    found = set(re.findall(r"^COMPLETION: (\w+)", done.stdout, re.MULTILINE))
    return {f"{namespace}::{name}" for name in found - NO_NAMES}


def main():
    clang, source, include = sys.argv[1], Path(sys.argv[2]), sys.argv[3]
    if shutil.which(clang) is None:
        print("There is no Clang.")
        return 77
    reference = set(listed(source))
    namespaces = {name.rpartition("::")[0] for name in reference}
    names = set().union(*(offered(namespace, clang, (source / "include", include)) for namespace in namespaces)) - namespaces
    for name in sorted(names - reference):
        print(f"{name}: offered, not in docs/api/cpp*.rst")
    for name in sorted(reference - names):
        print(f"{name}: in docs/api/cpp*.rst, not offered")
    return 0 if names == reference and len(names) > 50 else 1


sys.exit(main())
