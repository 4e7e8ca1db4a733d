# SPDX-License-Identifier: BSD-3-Clause
"""Functions that the package makes of the declarations of the C API, when the headers or the templates change."""

import os
import pathlib
import re
import shutil
import subprocess
import sys

import pytest

SOURCE = pathlib.Path(os.environ["PYPW85_SOURCE"])
DECLARATIONS = """
/** Girth of an ellipsoid; see pw85_contact() for what it is not.
 *
 * Its error is below 3 u.
 *
 * @param q [definite] form of the ellipsoid
 * @param[out] girth [optional] in the cube of the unit of the semi-axes
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_girth(double const q[6], double *girth);

"""
BATCH_DECLARATIONS = """
/** pw85_girth() for n ellipsoids.
 *
 * @param n [number of ellipsoids]
 * @param q [n×6; definite]
 * @param[out] girth [n]
 * @return as for pw85_contact_batch() */
PW85_API int pw85_girth_batch(size_t n, double const *q, double *girth);

"""
GIRTH = '''
@overload
def girth(q: Row, out: Floats | None = None) -> float: ...
@overload
def girth(q: Rows, out: Any = None, **kwargs: Any) -> Floats: ...
@overload
def girth(q: ArrayLike, out: Any = None, **kwargs: Any) -> Any: ...
@listed
def girth(q: ArrayLike, out: Any = None, **kwargs: Any) -> Any:
    """Girth of an ellipsoid; see `contact` for what it is not.

    Parameters
    ----------
    q : (..., 6) array_like
        Form of the ellipsoid.
    out : (...) array, optional
        Output array.
    **kwargs
        Other keyword arguments of ufuncs.

    Returns
    -------
    (...) array or number
        In the cube of the unit of the semi-axes.

    Raises
    ------
    PW85Error
        For a single row: a number is not finite or a form is not positive definite. In arrays, invalid rows become NaN.

    Notes
    -----
    Its error is below 3 u.
    """
    return _core.call_girth(q, out, kwargs)
'''


LIST_DECLARATIONS = """
/** Girths for the pairs of a neighbour list; arguments as for pw85_contact_pairs().
 *
 * @param list,system [as pw85_contact_pairs()]
 * @param weight [num_pairs] at most 1
 * @param[out] d_mu2 [num_pairs×3; optional]
 * @param[out] girth [num_pairs; optional] */
PW85_API int pw85_girth_pairs(pw85_pair_list const *list, pw85_system const *system, double const *weight, double *d_mu2,
                               double *girth);

/** Girths of the particles.
 *
 * @param list,system [as pw85_contact_pairs()]
 * @param[out] girth [num_particles] */
PW85_API int pw85_girth_particles(pw85_pair_list const *list, pw85_system const *system, double *girth);

"""


GIRTH_STRUCT = """template <class T> struct Girth {
    T girth;
    StatusCode status;
};
"""
# A struct of the same name that is no result.
DETAIL = """namespace pw85::detail {
struct Girth {
    int bound;
};
} // namespace pw85::detail
"""


def template(name, title, *lines):
    """That of a function of which one section is given."""
    return "\n    ".join(["@declared", f"def {name}():", f'"""{title}', "-" * len(title), *lines, '"""\n']).replace("    def", "def", 1)


@pytest.fixture
def make(tmp_path):
    """Makes a file of a template, by headers that declare one more function."""
    for folder in ("api", "include", "js", "octave", "r", "rust", "src/c_api"):
        shutil.copytree(SOURCE / folder, tmp_path / folder)
    for name in ("CHANGELOG.md", "meson.build", "fortran/pw85.in.f90", "fortran/pw85.f90", "debian/libpw85-3.symbols",
                 "debian/libpw85-gpu3.symbols", "python/pypw85/__init__.in.py", "src/simd/one_pair.hpp",
                 "src/base/objects.hpp", "src/base/signatures.hpp", "src/rare/shapes.cpp"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(SOURCE / name, tmp_path / name)
    for name, added in (("pw85.h", DECLARATIONS), ("pw85_batch.h", BATCH_DECLARATIONS), ("pw85_systems.h", LIST_DECLARATIONS)):
        header = tmp_path / "include" / name
        text = header.read_text(encoding="utf-8")
        place = text.index("/* clang-format on" if name == "pw85_batch.h" else "/** @}")  # where the program would make it
        header.write_text(text[:place] + added.lstrip() + text[place:], encoding="utf-8")
    girth = "template <class T> PW85_FUNCTION inline Girth<T> girth(SymmetricMatrix<T, 3> const &q) noexcept"
    cpp = tmp_path / "include/pw85/pw85.hpp"  # declares the template that C calls
    first, last = cpp.read_text(encoding="utf-8").split("/// Computes the volume of an ellipsoid,", 1)
    declared = f"/// The girth.\n///\n/// @param q form\n{girth};\n\n"
    cpp.write_text(f"{first}{declared}/// Computes the volume of an ellipsoid,{last}", encoding="utf-8")
    text = f"{GIRTH_STRUCT}{girth} {{ return {{}}; }}\n{DETAIL}"
    (tmp_path / "include/pw85/bodies/girth.hpp").write_text(text, encoding="utf-8")

    def run(kind, template="", succeeds=True):
        (tmp_path / "in").write_text(template, encoding="utf-8")
        paths = [] if kind == "table" else [tmp_path / "in"]
        done = subprocess.run([sys.executable, "-B", tmp_path / "api" / "python.py", kind, *paths, tmp_path / "out"],
                              capture_output=True, text=True)  # fmt: skip
        assert (done.returncode == 0) == succeeds, done.stderr
        return (tmp_path / "out").read_text(encoding="utf-8") if succeeds else done.stderr

    return run


def test_new_function(make):
    """It is in the table, among the ufuncs and in the module, where a template does not know of it."""
    row = r'\{"girth", "\(6\)->\(\)",.*?pw85_girth\(in\[0\], out\[0\]\).*?batch<pw85_girth_batch>, nullptr, false\}'
    assert re.search(row, make("table"), re.S)
    assert "\ngirth\n" in make("names", "#@ names\n").replace(",", "")
    assert GIRTH in make("functions")


def test_names_of_a_package(make):
    """It offers the new function beside what its template imports and assigns, in order, without private names."""
    text = make("names", """
from . import _core, zoo
from ._functions import (
    #@ functions
)
from ._forms import full as abc
_x = 1
width = 2
__all__ = [
    #@ all
]
""")
    names = {}
    exec(text[text.index("__all__") :], names)
    assert {"abc", "contact", "distance_box", "girth", "width", "zoo"} <= set(names["__all__"])
    assert names["__all__"] == sorted(names["__all__"]) and not any(name.startswith("_") for name in names["__all__"])
    assert "\n    girth,\n" in text and "\n    _cholesky_solve,\n" in text and "det_sym" not in text


def run_program(folder, *arguments):
    done = subprocess.run([sys.executable, "-B", *arguments], cwd=folder, capture_output=True, text=True)
    return done.returncode, done.stdout + done.stderr


def test_committed_files(make, tmp_path):
    """One command regenerates them with the new functions; before, it names each of them."""
    status, text = run_program(tmp_path, "api/committed.py", "check")
    names = ("fortran/pw85.f90", "include/pw85/batch/rows.hpp", "include/pw85/systems/lists.hpp", "debian/libpw85-3.symbols",
             "include/pw85_batch.h", "src/c_api/others_rows.cpp", "src/c_api/others.cpp")
    assert status == 1 and all(name in text for name in names)
    assert run_program(tmp_path, "api/committed.py") == (0, "")
    assert run_program(tmp_path, "api/committed.py", "check") == (0, "")
    fortran, rows, lists, symbols, batch, many_rows, one_row = ((tmp_path / name).read_text(encoding="utf-8") for name in names)
    assert "function pw85_girth(q, girth) result(status) bind(C, name='pw85_girth')" in fortran
    assert "StatusCode girth_batch(Forms q, std::span<double> girth) noexcept" in rows
    assert "PW85_API int pw85_girth_batch(size_t n, double const *q, double *girth);" in batch
    assert "return put(result.status, result.girth, girth);" in one_row
    many = 'return each_row(names, n, pw85_girth, RowsOf<6>{q}, OptionalRowsOf<1>{girth});'
    assert many in " ".join(many_rows.split())
    assert "call_pairs(pw85_girth_pairs, list, particles, weight, d_mu2, girth)" in lists
    assert "/// @param weight one for each pair: at most 1\n/// @param[out] d_mu2,girth one for each pair, or empty\n" in lists
    assert "girth_particles" not in lists  # its rows are not those of pairs: it is in sums.hpp
    version = re.search(r"version: '(.*)'", (tmp_path / "meson.build").read_text(encoding="utf-8"))[1]
    assert f"\n pw85_girth@Base {version}\n" in symbols


def test_first_version_of_a_symbol(make, tmp_path):
    """What the list has keeps its version; what is new has that of the library; what is gone is not in the list."""
    path, build = tmp_path / "debian/libpw85-3.symbols", tmp_path / "meson.build"
    build.write_text(re.sub("version: '.*'", "version: '3.7.1'", build.read_text(encoding="utf-8"), count=1), encoding="utf-8")
    path.write_text(path.read_text(encoding="utf-8") + " pw85_gone@Base 3.0.0\n", encoding="utf-8")
    with (tmp_path / "CHANGELOG.md").open("a", encoding="utf-8") as log:
        log.write("\n## [3.7.1] - 2026-01-02\n")  # its day is in a made file
    assert run_program(tmp_path, "api/committed.py") == (0, "")
    text = path.read_text(encoding="utf-8")
    assert " pw85_girth@Base 3.7.1\n" in text and " pw85_contact@Base 3.0.0\n" in text and "gone" not in text


def test_pages(make, tmp_path):
    """The manual has the new function in its section and among purposes."""
    program = "import pages; print(pages.python_functions('Version and errors'), [one.name for one in pages.unmentioned('')][4:5])"
    expected = "['version', 'strerror', 'set_reproducible', 'is_reproducible', 'girth'] ['pw85_girth']\n"
    assert run_program(tmp_path / "api", "-c", program) == (0, expected)


def test_what_a_template_says(make):
    text = make("functions", '''
@declared
def girth(form=None, v=None) -> Girth:
    """Parameters
    ----------
    form : (..., 6) array_like, optional
        The one.

    Examples
    --------
    >>> girth()
    """
    return Girth(_core.call_girth(form, v, kwargs))
''')
    head, made = text.partition("@listed")[::2]
    assert head == "\n"
    assert made.startswith("\ndef girth(form: ArrayLike | None = None, v: Floats | None = None, **kwargs: Any) -> Girth:\n")
    function = made.partition("\n\n\n")[0]
    for part in ("Girth of an ellipsoid", "        The one.\n    v : (...) array, optional", "    Notes\n", "    >>> girth()"):
        assert part in function
    assert "Form of the ellipsoid" not in function and function.endswith("    return Girth(_core.call_girth(form, v, kwargs))")


def test_one_of_two_parameters(make):
    """What is said of one leaves the other, of which the headers say the same."""
    text = make("functions", template("distance_box", "Parameters", "upper : (..., 3) array_like", "    The upper one."))
    lower = "    lower : (..., 3) array_like\n        Corners of the box, relative to the centre of the ellipsoid; `lower` <= `upper`.\n"
    upper = "    upper : (..., 3) array_like\n        The upper one.\n"
    assert lower + upper in text


@pytest.mark.parametrize("title, line, complaint", [("Parameters", "radius : (...)", "girth(): no such parameter: radius"),
                                                    ("Warning", "None.", "girth(): no such section: Warning")])  # fmt: skip
def test_what_is_not_declared(make, title, line, complaint):
    assert complaint in make("functions", template("girth", title, line), succeeds=False)


def test_linked_functions_are_compared():
    """The program that compares the functions of linked.hpp with the templates leaves out none."""
    header, program = ((SOURCE / name).read_text(encoding="utf-8") for name in ("include/pw85/linked.hpp", "tests/test_linked.cpp"))
    linked = set(re.findall(r"^/// Computes (\w+)\(\) by pw85_", header, re.MULTILINE))
    assert {"contact", "overlap", "area"} <= linked and linked == set(re.findall(r"^    COMPARE\((\w+), ", program, re.MULTILINE))


@pytest.mark.parametrize("files, line", [("r/man/*.Rd", ""), ("octave/inst/*.m", "%"), ("rust/pw85/src/questions.rs", " *///"),
                                         ("js/pw85.d.ts", r" *\* @param")])  # fmt: skip
def test_words_of_c(files, line):
    """What the headers say is said without pointers and statuses in languages that have none."""
    text = "\n".join(path.read_text(encoding="utf-8") for path in sorted(SOURCE.glob(files)))
    said = " ".join(found for found in text.splitlines() if re.match(line, found))
    assert len(said) > 1000 and re.findall(r"\bnull\b|\bpointers?\b|\w+ success\b|#PW85\w+|.{20}may be the same array", said) == []


def test_titles_of_r():
    titles = [re.search(r"^\\title\{(.*)\}$", path.read_text(encoding="utf-8"), re.M)[1] for path in (SOURCE / "r/man").glob("*.Rd")]
    assert len(titles) > 40 and not [title for title in titles if re.search(r" (?:all|at|by|in|of|to|that|which)$|`", title)]
