#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Whether what is made of the C headers depends on their prose, and whether their attributes are read strictly.

    check_prose.py SOURCE_DIR

rewords every sentence of the contracts at random: words are dropped, exchanged for others, and change their order. What stands in
brackets behind the names of parameters stays, as do the names, the titles of sections, and the functions and rows of
api/pw85_batch.txt. All files that api/ makes must be the same as before, but for comments and docstrings. Then attributes, and the lines
that say what is made in a header, are spoiled one by one: the programs must refuse each, and name the line.
"""

import ast
import json
import random
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

NEEDED = ("api", "include", "meson.build", "fortran/pw85.in.f90", "fortran/pw85.f90", "r/DESCRIPTION.in", "octave/DESCRIPTION.in",
          "rust/pw85/Cargo.toml.in", "rust/pw85-sys/Cargo.toml.in", "js", "CHANGELOG.md", "debian", "python/pypw85",
          "src/simd/one_pair.hpp", "src/c_api", "src/brent")  # fmt: skip
SHARES = (0.2, 1.0)  # of words that are dropped, one for each trial
# The beginnings of the names of what is made.
MADE = ("include/pw85_batch.h", "include/pw85/batch/", "include/pw85/linked.hpp", "include/pw85/simulation/", "include/pw85/systems/",
        "src/base/objects.hpp", "src/c_api/objects_", "src/c_api/contact_lanes", "src/c_api/contact.cpp", "fortran/", "r/R/", "r/man/",
        "r/src/", "octave/inst/", "octave/src/", "rust/pw85/src/", "rust/pw85-sys/src/", "js/", "debian/", "table of the tests",
        "table of Python", "objects of Python", "legacy.py", "_functions.py",
        "pw85_gpu.h: attributes", "pw85_any_dimension.h: attributes", "pw85_pre1.h: attributes")  # fmt: skip
COMMENT = re.compile(r"/\*\*[\s\S]*?\*/|(?:^ *///.*\n)+", re.MULTILINE)
# What is data in a comment: marks, tags with their names and attributes, titles.
DATA = re.compile(
    r"/\*\*| *\*/|^ *\*|^ *///|@(?:param(?:\[out\])? [\w,]+|return)(?:\s+\[[^\]]*\])?|@name .*|@[{}]|@file.*|@brief"
    r"|\[[^\]]*\]",
    re.MULTILINE,
)
OTHER_WORDS = {"may": "can", "null": "absent", "is": "becomes", "as": "like", "for": "of", "see": "compare", "NaN": "nothing",
               "the": "this",
               "n": "many", "number": "count", "from": "since", "returns": "gives"}  # fmt: skip
# A sentence in which a program could find what it looks for.
BAIT = "n×9, or null: as for pw85_f_neg(), see pw85_volume(); `q` may be null, NaN > 0, any output may be null"
ROWS = re.compile(r"^(pw85\w+(?: [\w -]+)?:)(.*)$|^(    \w+: \[[^\]]*\])(.*)$", re.MULTILINE)


def reworded_text(text, draw, share):
    """The words of a text without a share of them, with others in their place, in another order, and with bait."""
    words = [OTHER_WORDS.get(word, word) for word in text.split() if draw.random() > share]
    draw.shuffle(words)
    if words and draw.random() < 0.3:
        words += BAIT.split()
    return " ".join(words)


def reworded_comment(comment, draw, share):
    """A comment whose data are in their places. Each line keeps its mark, and each text between data stays on its lines."""
    parts, place = [], 0
    for match in DATA.finditer(comment):
        parts += [between(comment[place : match.start()], draw, share), match[0]]
        place = match.end()
    return "".join([*parts, between(comment[place:], draw, share)])


def between(text, draw, share):
    return re.sub(r"\S(?:[^\n]*\S)?", lambda match: reworded_text(match[0], draw, share) or "word", text)


def reword(folder, share):
    draw = random.Random(1)
    for path in sorted((folder / "include").rglob("*.h*")):
        text = COMMENT.sub(lambda match: reworded_comment(match[0], draw, share), path.read_text(encoding="utf-8"))
        path.write_text(text, encoding="utf-8")
    path = folder / "api/pw85_batch.txt"
    text = path.read_text(encoding="utf-8")
    text = ROWS.sub(lambda match: f"{match[1] or match[3]} {reworded_text(match[2] or match[4], draw, share)}", text)
    path.write_text(text, encoding="utf-8")


def without_texts(path, text):
    """A made file without comments, docstrings and empty lines."""
    if path.endswith(".f90"):
        text = re.sub(r"^ *!.*\n", "", text, flags=re.MULTILINE)
    elif path.endswith(".Rd"):
        text = "\n".join(re.findall(r"^\\(?:name|alias|item)\{[^}]*\}|^\\(?:usage|examples)\{\n[\s\S]*?\n\}", text, re.MULTILINE))
    elif path.endswith(".m"):
        text = re.sub(r"^%(?!!).*\n", "", text, flags=re.MULTILINE)
    elif path.endswith((".h", ".hpp", ".c", ".cpp", ".js", ".ts", ".rs")):
        examples = re.findall(r"^/// ```\n([\s\S]*?)^/// ```", text, re.MULTILINE)  # of Rust, which are programs
        text = "".join([re.sub(r"/\*.*?\*/|//[^\n]*", "", text, flags=re.DOTALL), *examples])
    elif path.endswith(".py"):
        tree = ast.parse(text)
        for node in ast.walk(tree):
            if isinstance(node, (ast.FunctionDef, ast.Module)) and ast.get_docstring(node) is not None:
                node.body = node.body[1:] or [ast.Pass()]
        text = ast.unparse(tree)
    return re.sub(r"\s*\n\s*", "\n", text)


def made(folder):
    """All that is made in a folder, by names; printed by a process of its own, which imports the programs of this folder."""
    sys.path.insert(0, str(folder / "api"))
    import causes
    import committed
    import declarations
    import public_headers
    import javascript
    import pages
    import python
    import tables

    files = {str(path.relative_to(folder)): text for path, text in committed.files().items()}
    listed = [one for one in declarations.functions(*public_headers.HOST_HEADERS) if not one.is_of_simulations()]
    files["table of the tests"] = "\n".join(line for function in listed for line in tables.lines(function))
    files["table of Python"] = python.rows_table()
    files["objects of Python"] = python.objects_table()
    files["names of Python"] = "\n".join(line for lines in python.made_lines().values() for line in lines)
    for name in ("_functions", "legacy"):
        files[f"{name}.py"] = python.module(folder / f"python/pypw85/{name}.in.py")
    files["modules of JavaScript"] = "\n".join(name for module in javascript.ASKED for name in javascript.exports(module))
    for header in public_headers.EVERY_HEADER:  # some attributes reach tests and pages alone
        parameters = [(one, own) for one in declarations.functions(header) for own in one.flattened]
        listed = [(one.name, own.name, vars(own.attributes) | {"words": sorted(own.attributes.words)}) for one, own in parameters]
        files[f"{header}: attributes"] = "\n".join(map(str, listed))
    for cause in causes.CAUSES:
        files[f"cause: {cause.key}"] = "\n".join(one.name for one in declarations.functions_with_status() if cause.is_of(one))
    files["functions of the pages"] = "\n".join(f"{name}: {place}" for name, place in pages.places_in_python().items())
    return {path: without_texts(path, text) for path, text in files.items()}


def run(folder):
    done = subprocess.run([sys.executable, "-B", __file__, "made", folder], capture_output=True, text=True)
    return (json.loads(done.stdout) if done.returncode == 0 else None), done.stderr


def copied(source, folder):
    for name in NEEDED:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (shutil.copytree if (source / name).is_dir() else shutil.copy)(source / name, folder / name)
    return folder


def complaints_of_rewording(source, folder):
    expected, error = run(source)
    if expected is None:
        yield f"nothing can be made: {error}"
        return
    for share in SHARES:
        other = copied(source, folder / str(share))
        reword(other, share)
        found, error = run(other)
        if found is None:
            yield f"{share} of the words dropped: nothing is made of reworded headers: {error}"
            continue
        if (other / "include/pw85.h").read_text(encoding="utf-8") == (source / "include/pw85.h").read_text(encoding="utf-8"):
            yield f"{share} of the words dropped: nothing is reworded"
        for path in sorted(expected.keys() | found.keys()):
            if expected.get(path) != found.get(path):
                yield f"{share} of the words dropped: {path} depends on prose"
    yield from (f"{path}: nothing is compared" for path, text in expected.items() if not text.strip())
    yield from (f"nothing of {language} is compared" for language in MADE if not any(path.startswith(language) for path in expected))


FORMS = "@param q1,q2 [length²; definite]"
OUT = "@param[out] out [members mu2, lambda]"
LIKE = "r12,q1,q2 [as pw85_contact()]"
# What replaces a part of a header, and what is said then.
SPOILED = {
    "pw85.h": (
        (FORMS, "@param q1,q2 [length²; positive_definite]", "unknown attribute: positive_definite"),
        (FORMS, "@param q1,q2\n *        [length²; positive_definite]", "unknown attribute: positive_definite"),
        (FORMS, "@param q1,q2 [length², definite]", "unknown attribute: length², definite"),
        (FORMS, "@param q1,q2 [lengths²; definite]", "unknown attribute: lengths²"),
        (FORMS, "@param q1,q2 [length^2; definite]", "unknown attribute: length^2"),
        (FORMS, "@param q1,q2 [length²; definite;]", "unknown attribute: definite;"),
        (FORMS, "@param q1,q2 []", "unknown attribute: none between the brackets"),
        (FORMS, "@param q1,q2 [n×6; length²; definite]", "unknown attribute: n×6"),
        (FORMS, "@param q1,q2 [0×6; length²; definite]", "unknown attribute: 0×6"),
        (FORMS, "@param q1,q2 [length²; time; definite]", "time must not stand behind length²"),
        (FORMS, "@param q1,q2 [length²; definite; definite]", "definite must not stand behind definite"),
        (FORMS, "@param q1,q2 [definite; length²]", "length² must not stand behind definite"),
        (FORMS, "@param q1,q2 [length²; definite", "attributes must stand between brackets behind the name: [length²; definite"),
        (FORMS, "@param q1,q2 forms [length²; definite]", "attributes must stand between brackets behind the name: forms [length²"),
        (FORMS, "@param q1,q2 (length²; definite)", "attributes must stand between brackets behind the name: (length²"),
        (FORMS, "@param[in] q1,q2 [length²; definite]", "not understood: @param[in] q1,q2"),
        (FORMS, "@param q1, q2 [length²; definite]", "not understood: @param q1, q2"),
        (FORMS, "@params q1,q2 [length²; definite]", "not understood: @params q1,q2"),
        (FORMS, "@arg q1,q2 [length²; definite]", "not understood: @arg q1,q2"),
        (FORMS, "@param q1,q3 [length²; definite]", "no such parameter: q3"),
        (FORMS, "@param q1 [length²; definite]", "pw85_contact(), q2: not described"),
        (FORMS, "@param q1,q2 [2×2; length²; definite]", "2×2 are not 6 numbers"),
        (FORMS, "@param q1,q2 [number of pairs]", "not a number of rows: pairs"),
        (FORMS, "@param q1,q2 [without q; definite]", "not a struct that has q"),
        (FORMS, "@param q1,q2 [definite; member q1, q2]", "inputs are not members of a result: q1"),
        (FORMS, "@param q1,q2 [definite; -1 on error]", "inputs stay as they are: -1 on error"),
        (FORMS, "@param[out] q1,q2 [length²; definite]", "an input must not have @param[out]"),
        (FORMS, "@param r12,q1,q2 [length²; definite]", "r12 is described twice"),
        (OUT, "@param out [members mu2, lambda]", "an output needs @param[out]"),
        (OUT, "@param[out] out [> 0; members mu2, lambda]", "outputs have no limits: > 0"),
        (OUT, "@param[out] out [members mu2, lambdas]", "has no member lambdas"),
        (FORMS, "@param q1,q2 [length²; optional; definite]", "only outputs of doubles can be optional"),
        ("overlap [-1 on error]", "overlap [optional; -1 on error]", "only outputs of doubles can be optional"),
        ("volume [length³]", "volume [length³; optional if not needed]", "only outputs of doubles can be optional"),
        (FORMS, "@param q1,q2 [as pw85_contact()]", "pw85_contact() does not say what q1 is"),
        (LIKE, "r12,q1,q2 [as pw85_kontact()]", "no function pw85_kontact()"),
        (LIKE, "r12,q1,q2 [as pw85_volume()]", "pw85_volume() does not say what r12 is"),
        ("lambda [0..1]", "lambda [optional; 0..1]", "a number cannot be absent: optional"),
        ("lambda [0..1]", "lambda [3; 0..1]", "a number has no extents: 3"),
        ("member q1, q2]", "member q1]", "1 members for 2 outputs"),
        ("overlap [-1 on error]", "overlap", "no value on error"),
        ("@param params [15; mixed units]", "@param params [mixed units]", "an array without extents"),
        ("@return [NaN on error]", "@return [nan on error]", "unknown attribute: nan on error"),
        (FORMS, "@param q1,q2 [length²; rotation]", "rotation needs 9 numbers, not 6"),
        (FORMS, "@param q1,q2 [length²; 1..16]", "1..16 limits int, not double"),
        (FORMS, "@param q1,q2 [length²; near the cell]", "near the cell needs 3 numbers, not 6"),
        (FORMS, "@param q1,q2 [length²; > 0; != 0]", "> 0 and != 0 exclude each other"),
        ("lambda [0..1]", "lambda [definite]", "definite needs 3 or 6 or n(n+1)/2 numbers, not 1"),
        (OUT, "@param[out] out [members mu2, mu2]", "mu2, mu2: a member stands twice"),
        (OUT, "@param[out] out [members mu2, lambda; -1 on error]", "outputs of type double cannot be -1 on error"),
        ("overlap [-1 on error]", "overlap [NaN on error]", "outputs of type int cannot be NaN on error"),
        (
            "pw85_volume(double const q[6], double *volume)",
            "pw85_volume(double const q[6], double *volume, double *volume)",
            "two parameters of one name: q, volume, volume",
        ),
        ("pw85_volume(double const q[6], double *volume)", "pw85_volume(double const *q, double *volume)", "an array without extents"),
        ("pw85_volume(double const q[6], double *volume)", "pw85_volume(double q[6], double *volume)", "an output needs @param[out]"),
        (
            "pw85_volume(double const q[6], double *volume);",
            "pw85_volume(double const q[6], double *volume)",
            "not understood: PW85_API int pw85_volume(",
        ),
        ("PW85_API int pw85_volume(", "int pw85_volume(", "not understood: int pw85_volume("),
        ("PW85_API int pw85_volume(", "PW85_API long pw85_volume(", "not understood: PW85_API long pw85_volume("),
        ("PW85_API int pw85_volume(", "PW85_API int pw85_contact(", "declared twice, also at pw85.h:"),
        ("PW85_API int pw85_volume(", "PW85_API int pw85_volumes(", "pw85/pw85.hpp does not declare volumes()"),
        ("@name Volumes and", "@named Volumes and", "not understood: @named Volumes and"),
        ("@return #PW85_SUCCESS", "@return #PW85_SUCCES", "not understood: #PW85_SUCCES"),
        ("@return #PW85_SUCCESS", "@returns #PW85_SUCCESS", "not understood: @returns #PW85_SUCCESS"),
        ("pw85_contact(double const r12[3]", "pw85_contact(float const r12[3]", "r12: of no type in TYPES of api/parameters.py"),
        ("pw85_contact(double const r12[3]", "pw85_contact(double const r12[2 + 1]", "of no type in TYPES"),
        ("pw85_is_reproducible(int *on)", "pw85_is_reproducible(char *on)", "on: TYPES of api/fortran.py has no entry char"),
        ("int *contains", "int64_t *contains", "pw85_contains(): parameters that languages cannot take as rows"),
        ("PW85_API int pw85_contact(", "PW85_API pw85_contact(", "not understood: PW85_API pw85_contact("),
        ("#define PW85_DIM 3", "#define PW85_DIM 0x3", "constants are macros of decimal numbers"),
        ("#define PW85_DIM 3", "enum pw85_mode {", "constants are macros of decimal numbers"),
    ),
    "pw85_systems.h": (
        ("system [without q; with cell]", "system [without p; with cell]", "not a struct that has p"),
        ("system [without q; with cell]", "system [with cell; without q]", "without q must not stand behind with cell"),
        ("[num_pairs×2; index]", "[num_pairs×2; length; index]", "only doubles have units: length"),
        ("[num_pairs×2; index]", "[3×num_pairs; index]", "unknown attribute: 3×num_pairs"),
        ("[num_pairs×2; index]", "[num_pairs×2; indices]", "unknown attribute: indices"),
        ("[num_pairs; time; member time]", "[num_pairs; time; member tim]", "no struct of C++ has the member tim"),
        ("[num_pairs×2; index]", "[num_pairs×2; index", "attributes must stand between brackets"),
        ("/** [number of pairs] 0 is", "/** 0 is", "number of what?"),
        ("int32_t const *images;\n} pw85_pair_list", "int32_t const *pairs;\n} pw85_pair_list", "two members of one name"),
    ),
}
# One of each kind of headers: one row, systems, simulations, n dimensions, devices, older programs.
EVERY = ("pw85.h", "pw85_systems.h", "pw85_simulation_trials.h", "pw85_any_dimension.h", "pw85_gpu.h", "pw85_pre1.h")
# What replaces a part of a file that says what is made, and what is said then.
HARD_ELLIPSOIDS = "include/pw85/simulation/hard_ellipsoids.hpp"
SPOILED_PARTS = (
    (HARD_ELLIPSOIDS, "py: members of", "py: member of", "not understood: member"),
    (HARD_ELLIPSOIDS, "members of pw85_hard_ellipsoids", "members of pw85_hard_ellipsoid", "no object has members: pw85_hard_ellipsoid"),
    (HARD_ELLIPSOIDS, "of pw85_simulation_state.h", "of pw85_simulations.h", "no such header or section: pw85_simulations.h"),
    ("include/pw85/systems/periodic.hpp", "// Made by", "// made by", "no part that is made"),
    ("include/pw85/systems/meshes.hpp", "Triangle meshes\n", "Neighbour lists\n", "in no made part of a header of C++"),
    ("include/pw85/systems/periodic.hpp", "functions of Periodic cells", "functions of Cells", "no such header or section: Cells"),
    ("include/pw85/systems/lists.hpp", "py: pairs of", "py: triples of", "not understood: triples"),
    ("include/pw85/linked.hpp", "templates of", "template of", "not understood: template"),
    ("include/pw85_batch.h", "py: rows of", "py: row of", "not understood: row"),
    ("api/pw85_batch.txt", "\npw85_compare:", "\npw85_compares:", "no function pw85_compares() of one row"),
    ("api/pw85_batch.txt", "    sign: [n] -1", "    signs: [n] -1", "pw85_compare_batch() has no parameter signs"),
    ("api/pw85_batch.txt", "    sign: [n] -1", "    sign: n, -1", "described twice, or without brackets"),
    ("api/pw85_batch.txt", "pw85_hertz contacts\n", "pw85_hertz contacts\npw85_hertz contacts\n", "of one row, or it is named twice"),
    ("api/pw85_batch.txt", "pw85_hertz contacts\n", "pw85_hertz contacts\n contacts\n", "not understood"),
)


def complaint_of(make, new, said, place):
    """What is wrong with the error of a spoiled text, which must say this, at this place."""
    try:
        make()
    except Exception as error:  # of another type it would end with a traceback
        if type(error).__name__ == "Refused" and said in str(error) and re.match(place, str(error)):
            return []
        return [f"{new}: {error}"]
    return [f"{new}: accepted"]


def complaints_of_spoiling(folder):
    """Whether each error of a header is found, with its line or that of the comment."""
    sys.path.insert(0, str(folder / "api"))
    import batch
    import classes
    import declarations
    import public_headers
    import fortran
    import linked
    import rows
    import shims

    def make(header):
        declarations.c_functions()
        for one in declarations.functions(header):
            one.flattened, one.is_nan_on_error()
        rows.row_functions.cache_clear()
        made = (linked, shims, batch, fortran) if header != "pw85_systems.h" else (classes,)
        return rows.row_functions(), [program.files() for program in made]

    for header, listed in SPOILED.items():
        text = (folder / "include" / header).read_text(encoding="utf-8")
        for old, new, said in listed:
            begin = text.find(old)
            if begin < 0:
                yield f"{header} does not say {old}"
                continue
            first, last = (text.count("\n", 0, place) + 1 for place in (text.rfind("/**", 0, begin), begin))
            lines = range(first, last + 1)
            public_headers.replace({header: text.replace(old, new, 1)})
            yield from complaint_of(lambda: make(header), new, said, rf"{header}:(?:{'|'.join(map(str, lines))}): ")
        public_headers.replace({header: text})


def complaints_of_parts(folder):
    """Whether each error of what says what is made is found; called after complaints_of_spoiling()."""
    import batch
    import classes
    import cpp
    import linked

    for path, old, new, said in SPOILED_PARTS:
        spoiled, name = folder / path, path.rpartition("/")[2]
        text = spoiled.read_text(encoding="utf-8")
        if old not in text:
            yield f"{name} does not say {old}"
            continue
        spoiled.write_text(text.replace(old, new, 1), encoding="utf-8")
        cpp.by_hand.cache_clear()
        yield from complaint_of(lambda: (batch.header(), classes.files(), linked.files()), new, said, rf"(?:{name}|pw85_\w+\.h):(?:\d+:)? ")
        spoiled.write_text(text, encoding="utf-8")


def complaints_of_program(folder):
    """Whether the program that a maintainer calls ends with the sentence alone, whatever the header."""
    for name in EVERY:
        header = folder / f"include/{name}"
        text = header.read_text(encoding="utf-8")
        header.write_text(re.sub(r"(@param\S* \S+ \[[^\]\n]*)\]", r"\1; unheard-of]", text, count=1), encoding="utf-8")
        done = subprocess.run([sys.executable, "-B", folder / "api/committed.py"], capture_output=True, text=True)
        if done.returncode != 1 or done.stdout or not re.fullmatch(rf"{name}:\d+: .*: unknown attribute: unheard-of\n", done.stderr):
            yield f"committed.py, {name}: {done.returncode}, {done.stderr or 'accepted'}"
        header.write_text(text, encoding="utf-8")


def main(source):
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        other = copied(source, folder / "spoiled")
        parts = (complaints_of_spoiling, complaints_of_parts, complaints_of_program)
        found = [*complaints_of_rewording(source, folder), *(complaint for part in parts for complaint in part(other))]
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    if sys.argv[1] == "made":
        json.dump(made(Path(sys.argv[2])), sys.stdout)
    else:
        sys.exit(main(Path(sys.argv[1]).resolve()))
