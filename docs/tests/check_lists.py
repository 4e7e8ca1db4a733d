"""Whether lists of functions have all that the headers declare, and whether the targets exist that pages tell users to build.

Usage: check_lists.py SOURCE
"""

import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "api"))
from declarations import functions
from public_headers import CPP_HEADERS
from pages import FUNCTION, PURPOSE_HEADERS, python_functions, unmentioned, with_twins
from python import package_names
from rows import BY_HAND

SOURCE = Path(sys.argv[1])

# What C++ and Python do not have by the name that it has in C, and why.
ELSEWHERE = {
    "version": "of the compiled library; in C++ it is headers only",
    "strerror": "in C++ in status.hpp",
    "set_reproducible": "of the compiled library",
    "is_reproducible": "of the compiled library",
    "contact_function": "Brent's method; in the compiled library only",
    "f_neg": "evaluate_f() of contact/evaluation.hpp",
    "_residual": "a building block of 1.0's programs",
    "_cholesky_decomp": "factorize() of algebra/symmetric.hpp",
    "_cholesky_solve": "solve() of algebra/symmetric.hpp",
    "zheng_ellipses": "in history/zheng.hpp",
    "zheng_ellipsoids": "in history/zheng.hpp",
}

# The functions of an object are members of a class in C++ and Python, or parts of what makes it.
CLASSES = {"pw85_neighbors_": "Neighbors", "pw85_mesh_": "Mesh", "pw85_hard_ellipsoids_": "HardEllipsoids",
           "pw85_random_addition_": "RandomAddition"}  # fmt: skip


def text(path):
    return (SOURCE / path).read_text(encoding="utf-8")


def c_functions():
    return [function.name for header in PURPOSE_HEADERS for function in functions(header)]


def plain(name):
    """The name of a C function without its prefix, which is that of Python."""
    return re.sub(r"^pw85_|_batch(?=$|_2d$)", "", name)


def on_page_of_python():
    """The names that docs/api/python.rst has, those of sections among them."""
    page = text("docs/api/python.rst")
    sections = re.findall(r"^\.\. python-functions:: (.*)$", page, re.MULTILINE)
    return re.findall(r":: pypw85\.(\w+)$", page, re.MULTILINE) + [name for one in sections for name in python_functions(one)]


def complaints_of_purposes():
    """The table of purposes completes what its rows name."""
    if with_twins(":c:func:`pw85_contact`") != ":c:func:`pw85_contact`, :c:func:`pw85_contact_batch`":
        yield "pw85_contact_batch does not follow pw85_contact"
    rows = ":c:func:`pw85_contact_batch_2d` :c:func:`pw85_contact_2d`"
    if with_twins(rows) != rows or {one.name for one in unmentioned(rows)} != set(c_functions()) - set(FUNCTION.findall(rows)):
        yield "functions are lost beside two that are named"


def complaints_of_targets():
    """``meson compile -C FOLDER TARGET`` on a page names a target of a meson.build."""
    targets = {name for file in SOURCE.rglob("meson.build") if "build" not in file.relative_to(SOURCE).parts[0]
               for name in re.findall(r"\b(?:run|alias)_target\(\s*'([\w-]+)'", file.read_text(encoding="utf-8"))}  # fmt: skip
    pages = [SOURCE / "README.md", *SOURCE.glob("*/README.md"), *SOURCE.glob("docs/**/*.rst"), *SOURCE.glob("docs/**/*.sh")]
    command = re.compile(r"meson compile -C \S+ ([a-z][\w-]*)(?=`|  |$)", re.MULTILINE)
    named = {(page, name) for page in pages for name in command.findall(page.read_text(encoding="utf-8"))}
    if len(named) < 5:
        yield f"only {len(named)} targets are found on pages"
    yield from (f"{page.relative_to(SOURCE)}: meson has no target {name}" for page, name in named if name not in targets)


def complaints():
    yield from complaints_of_targets()
    names = [name for name in c_functions() if not name.startswith(tuple(CLASSES))]
    in_cpp = {re.sub(r"_batch$", "", function.name) for header in CPP_HEADERS for function in functions(header)}
    for name in map(plain, names):
        if re.sub(r"_2d$", "", name) not in in_cpp | ELSEWHERE.keys():
            yield f"{name}: not in {' or '.join(CPP_HEADERS)}"
    public = set(package_names())
    in_space_too = {plain(name) for name in BY_HAND if name.endswith("_2d")}  # the function without this ending takes both
    yield from (f"{name}: not in pypw85" for name in map(plain, names) if name[0] != "_" and name not in public | in_space_too)
    yield from (f"{name}: not in pypw85" for name in CLASSES.values() if name not in public)
    entries = on_page_of_python()
    yield from (f"{name}: {entries.count(name)} times in docs/api/python.rst" for name in public if entries.count(name) != 1)
    yield from complaints_of_purposes()


found = sorted(complaints())
print("\n".join(found))
sys.exit(1 if found or len(c_functions()) < 40 else 0)
