"""Whether lists of functions that are kept by hand have all that the headers declare. Usage: check_lists.py SOURCE"""

import ast
import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "api"))
from declarations import CPP_HEADERS, functions

SOURCE = Path(sys.argv[1])

# What C++ and Python do not have by the name that it has in C, and why.
ELSEWHERE = {
    "version": "of the compiled library; in C++ it is headers only",
    "strerror": "in C++ in status.hpp",
    "contact_function": "Brent's method; in the compiled library only",
    "f_neg": "evaluate_f() of contact/evaluation.hpp",
    "_residual": "a building block of 1.0's programs",
    "_cholesky_decomp": "factorize() of algebra/symmetric.hpp",
    "_cholesky_solve": "solve() of algebra/symmetric.hpp",
    "zheng_ellipses": "in history/zheng.hpp",
    "zheng_ellipsoids": "in history/zheng.hpp",
}

# The functions of an object are members of a class in C++ and Python, or parts of what makes it.
CLASSES = {"pw85_neighbors_": "Neighbors"}


def text(path):
    return (SOURCE / path).read_text(encoding="utf-8")


def c_functions():
    headers = ("pw85.h", "pw85_zheng.h")
    return [function.name for header in headers for function in functions(header)]


def plain(name):
    """The name of a C function without its prefix, which is that of Python."""
    return re.sub(r"^pw85_|_batch(?=$|_2d$)", "", name)


def python_all():
    """The list __all__ of the package."""
    for node in ast.parse(text("python/pypw85/__init__.py")).body:
        if isinstance(node, ast.Assign) and node.targets[0].id == "__all__":
            return ast.literal_eval(node.value)
    raise SystemExit("pypw85 has no __all__")


def python_imports():
    """What the package takes from its modules, without private names."""
    imported = [node for node in ast.parse(text("python/pypw85/__init__.py")).body if isinstance(node, ast.ImportFrom)]
    names = {alias.asname or alias.name for node in imported for alias in node.names}
    return {name for name in names if not name.startswith("_")}


def complaints():
    names = [name for name in c_functions() if not name.startswith(tuple(CLASSES))]
    in_cpp = {re.sub(r"_batch$", "", function.name) for header in CPP_HEADERS for function in functions(header)}
    for name in map(plain, names):
        if re.sub(r"_2d$", "", name) not in in_cpp | ELSEWHERE.keys():
            yield f"{name}: not in {' or '.join(CPP_HEADERS)}"
    public = python_all()
    yield from (f"{name}: not in pypw85" for name in map(plain, names) if name[0] != "_" and name not in public)
    yield from (f"{name}: imported by pypw85, not in __all__" for name in python_imports() - set(public))
    yield from (f"{name}: not in pypw85" for name in CLASSES.values() if name not in public)
    if public != sorted(public):
        yield "pypw85.__all__ is not sorted"
    entries = set(re.findall(r":: pypw85\.(\w+)$", text("docs/api/python.rst"), re.MULTILINE))
    yield from (f"{name}: not in docs/api/python.rst" for name in set(public) - entries)
    landing = text("docs/index.rst")
    yield from (f"{name}: not in docs/index.rst" for name in names if f":c:func:`{name}`" not in landing)


found = sorted(complaints())
print("\n".join(found))
sys.exit(1 if found or len(c_functions()) < 40 else 0)
