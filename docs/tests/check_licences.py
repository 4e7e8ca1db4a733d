# SPDX-License-Identifier: BSD-3-Clause
"""Whether the page on licences says what the sources say: the licence of each file, the projects whose headers are compiled into packages,
and what the Python package needs. Usage: check_licences.py SOURCE
"""

import fnmatch
import json
import re
import sys
import tomllib
from pathlib import Path

OURS = "BSD-3-Clause"
PLACES = ("include", "src", "python", "fortran", "js", "r", "octave", "rust", "lammps")  # from which packages are made
# The projects that have the headers that are included between angle brackets, by the beginnings of their names.
PROJECTS = {"boost/": "Boost", "gsl/": "GSL", "omp.h": "OpenMP", "numpy/": "NumPy", "Python.h": "Python", "R.h": "R", "Rinternals.h": "R",
            "R_ext/": "R", "mex.h": "MATLAB", "lammps/": "LAMMPS", "fmt/": "fmt", "glib.h": "GLib", "CGAL/": None}  # fmt: skip
# Those of compilers and systems.
SYSTEM = re.compile(r"(?:\w+mmintrin|immintrin|arm_neon|arm_sve|wasm_simd128|inttypes|math|pthread|dlfcn|sched|time|unistd|sys/\w+|std\w+|"
                    r"string|malloc|windows)\.h|\w+|pw85.*")  # fmt: skip
LICENCES_OF_PACKAGES = {"js/package.json": r'"license": "(.*?)"', "octave/DESCRIPTION": r"^License: (.*)$", "rust/pw85/Cargo.toml":
                        r'^license = "(.*)"$', "rust/pw85-sys/Cargo.toml": r'^license = "(.*)"$', "CITATION.cff": r"^license: (.*)$",
                        "meson.build": r"license: '(.*?)'"}  # fmt: skip


def files(source):
    for path in sorted(source.rglob("*")):
        name = str(path.relative_to(source))
        if path.is_file() and not re.match(r"build|install/|subprojects|\.git/|\.\w+_cache|\.mesonpy", name) and "__pycache__" not in name:
            yield name, path


def stated_in_dep5(source):
    """Pairs of patterns and licence, in the order of the file: the last one that matches holds."""
    for paragraph in (source / ".reuse/dep5").read_text(encoding="utf-8").split("\n\n"):
        fields = dict(re.findall(r"^([\w-]+): (.*)$", paragraph, re.MULTILINE))
        if "Files" in fields:
            yield fields["Files"].split(), fields["License"]


def licence_of(name, path, dep5):
    found = re.search(rb"SPDX-License-Identifier: ([\w.+ -]*[\w.+])", path.read_bytes()[:1000])
    if found and not name.startswith("LICENSES"):
        return found[1].decode()
    return [licence for patterns, licence in dep5 if any(fnmatch.fnmatchcase(name, pattern) for pattern in patterns)][-1]


def table(page, title):
    """The rows of a table below a title, without its head: lists of texts."""
    text = page.split(f"\n{title}\n", 1)[1]
    rows = re.split(r"\n   \* - ", text.split("\n\n   * - ", 1)[1].split("\n\n", 1)[0])[1:]
    return [[" ".join(cell.split()) for cell in row.split("\n     - ")] for row in rows]


def complaints_of_files(source, page):
    dep5 = list(stated_in_dep5(source))
    stated = {pattern: licence for licence, where, *_ in table(page, "Files of the sources") for pattern in re.findall(r"``(.*?)``", where)}
    used = set()
    for name, path in files(source):
        actual = licence_of(name, path, dep5)
        place = next((pattern for pattern in stated if name == pattern or (pattern.endswith("/") and name.startswith(pattern))), None)
        used.add(place)
        if actual != stated.get(place, OURS):
            yield f"{name} is under {actual}, and the page says {stated.get(place, OURS)}"
    yield from (f"the page names {place}, which is not there" for place in stated.keys() - used)
    texts = {path.stem for path in (source / "LICENSES").iterdir()}
    if texts != {word for licence in (OURS, *stated.values()) for word in licence.split(" AND ")}:
        yield f"LICENSES/ has {sorted(texts)}"


def complaints_of_headers(source, page):
    named = {word.strip() for project, *_ in table(page, "Licences of the code of others") for word in re.split(r"[,:] | of ", project)}
    for place in PLACES:
        for path in sorted((source / place).rglob("*")):
            if path.suffix not in (".c", ".h", ".cpp", ".hpp", ".in") or "tests" in path.parts or "bench" in path.parts:
                continue
            for header in re.findall(r"^ *# *include *<([^>]+)>", path.read_text(encoding="utf-8"), re.MULTILINE):
                project = next((PROJECTS[begin] for begin in PROJECTS if header.startswith(begin)), "")
                if (not project and not SYSTEM.fullmatch(header)) or (project and project not in named):
                    yield f"{path.relative_to(source)} includes {header}, whose project the page does not name"


def complaints_of_packages(source, page):
    python = tomllib.loads((source / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    optional = [word for extra in ("plot", "files", "meshes", "dask", "torch", "pages") for word in python["optional-dependencies"][extra]]
    needed = {re.match(r"\w+", word)[0] for word in (*python["dependencies"], *optional)}
    known = re.sub("pytorch", "torch", page.lower())
    yield from (f"the page does not name {name}, which the Python package needs" for name in sorted(needed) if name not in known)
    for name, pattern in LICENCES_OF_PACKAGES.items():
        found = re.findall(pattern, (source / name).read_text(encoding="utf-8"), re.MULTILINE)
        if found != [OURS]:
            yield f"{name} says {found}"
    text, of_js = ((source / name).read_text(encoding="utf-8") for name in ("LICENSE", "js/LICENSE"))
    if not of_js.startswith(text) or "Rich Felker" not in of_js:
        yield "js/LICENSE is not LICENSE with the notice of musl"
    if "LICENSE" not in json.loads((source / "js/package.json").read_text(encoding="utf-8"))["files"]:
        yield "js/package.json leaves out LICENSE"


def main():
    source = Path(sys.argv[1]).resolve()
    page = (source / "docs/licences.rst").read_text(encoding="utf-8")
    found = [*complaints_of_files(source, page), *complaints_of_headers(source, page), *complaints_of_packages(source, page)]
    print("\n".join(found))
    return 1 if found else 0


sys.exit(main())
