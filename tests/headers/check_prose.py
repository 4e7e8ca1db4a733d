#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Whether what is made of the C headers depends on their prose, and whether their attributes are read strictly.

    check_prose.py SOURCE_DIR

rewords every sentence of the contracts at random: words are dropped, exchanged for others, and change their order. What stands in
brackets behind the names of parameters stays, as do the names, the titles of sections, and the functions and rows of
api/pw85_batch.h.in. All files that api/ makes must be the same as before, but for comments and docstrings. Then attributes and lines of
the templates of C++ are spoiled one by one: the programs must refuse each, and name the line.
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
SEEDS = (1, 2)
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
ROWS = re.compile(r"^(@(?:rows|lanes) [\w]+(?: [\w -]+)?:)(.*)$|^(    \w+: \[[^\]]*\])(.*)$", re.MULTILINE)


def reworded_text(text, draw):
    """The words of a text without some of them, with others in their place, in another order, and with bait."""
    words = [OTHER_WORDS.get(word, word) for word in text.split() if draw.random() > 0.2]
    draw.shuffle(words)
    if words and draw.random() < 0.3:
        words += BAIT.split()
    return " ".join(words)


def reworded_comment(comment, draw):
    """A comment whose data are in their places. Each line keeps its mark, and each text between data stays on its lines."""
    parts, place = [], 0
    for match in DATA.finditer(comment):
        parts += [between(comment[place : match.start()], draw), match[0]]
        place = match.end()
    return "".join([*parts, between(comment[place:], draw)])


def between(text, draw):
    return re.sub(r"\S(?:[^\n]*\S)?", lambda match: reworded_text(match[0], draw) or "word", text)


def reword(folder, seed):
    draw = random.Random(seed)
    for path in sorted((folder / "include").rglob("*.h*")):
        text = COMMENT.sub(lambda match: reworded_comment(match[0], draw), path.read_text(encoding="utf-8"))
        path.write_text(text, encoding="utf-8")
    path = folder / "api/pw85_batch.h.in"
    text = COMMENT.sub(lambda match: reworded_comment(match[0], draw), path.read_text(encoding="utf-8"))
    text = ROWS.sub(lambda match: f"{match[1] or match[3]} {reworded_text(match[2] or match[4], draw)}", text)
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
        text = re.sub(r"/\*.*?\*/|//[^\n]*", "", text, flags=re.DOTALL)
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
    import pages
    import python
    import tables

    files = {str(path.relative_to(folder)): text for path, text in committed.files().items()}
    listed = [one for header in declarations.HOST_HEADERS for one in declarations.functions(header) if not one.is_of_simulations()]
    files["table of the tests"] = "\n".join(line for function in listed for line in tables.lines(function))
    files["table of Python"] = python.rows_table(python.row_functions())
    files["objects of Python"] = python.objects_table()
    files["names of Python"] = "\n".join(line for lines in python.made_lines().values() for line in lines)
    for name in ("_functions", "legacy"):
        files[f"{name}.py"] = python.module(folder / f"python/pypw85/{name}.in.py")
    for cause in causes.CAUSES:
        files[f"cause: {cause.key}"] = "\n".join(one.name for one in causes.FUNCTIONS if causes.has_cause(one, cause))
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
    for seed in SEEDS:
        other = copied(source, folder / str(seed))
        reword(other, seed)
        found, error = run(other)
        if found is None:
            yield f"seed {seed}: nothing is made of reworded headers: {error}"
            continue
        if (other / "include/pw85.h").read_text(encoding="utf-8") == (source / "include/pw85.h").read_text(encoding="utf-8"):
            yield f"seed {seed}: nothing is reworded"
        for path in sorted(expected.keys() | found.keys()):
            if expected.get(path) != found.get(path):
                yield f"seed {seed}: {path} depends on prose"


# What replaces a part of pw85.h, and what is said then.
FORMS = "@param q1,q2 [length²; definite]"
SPOILED = (
    (FORMS, "@param q1,q2 [length²; positive_definite]", "unknown attribute: positive_definite"),
    (FORMS, "@param q1,q2\n *        [length²; positive_definite]", "unknown attribute: positive_definite"),
    (FORMS, "@param q1,q3 [length²; definite]", "no such parameter: q3"),
    (FORMS, "@param q1 [length²; definite]", "pw85_contact(), q2: not described"),
    (FORMS, "@param q1,q2 [2×2; length²; definite]", "are not 6 numbers"),
    (FORMS, "@param r12,q1,q2 [length²; definite]", "r12 is described twice"),
    ("@param[out] out [members mu2, lambda]", "@param out [members mu2, lambda]", "an output"),
    ("r12,q1,q2 [as pw85_contact()]", "r12,q1,q2 [as pw85_kontact()]", "no function pw85_kontact()"),
    ("member q1, q2]", "member q1]", "1 members for 2 outputs"),
    ("@param params [15; mixed units]", "@param params [mixed units]", "an array without extents"),
)


# What replaces a part of a template of C++, and what is said then.
SPOILED_TEMPLATES = (
    ("hard_ellipsoids", "@member sweep", "@member sweeps", "no function pw85_hard_ellipsoids_sweeps()"),
    ("hard_ellipsoids", "        take: bool\n        is_free", "        takes: bool\n        is_free", "no such parameter: takes"),
    ("hard_ellipsoids", "@member chain without direction", "@member chain without a direction", "not understood"),
    ("neighbors", "@function neighbors_holds", "@functions neighbors_holds", "not understood"),
    ("lists", "@pairs pw85_systems.h", "@triples pw85_systems.h", "not understood"),
    ("linked", "//@ others", "//@ other", "not understood"),
)


def complaints_of_templates(source, folder):
    other = copied(source, folder / "templates")
    for name, old, new, said in SPOILED_TEMPLATES:
        template = other / f"api/{name}.hpp.in"
        text = template.read_text(encoding="utf-8")
        if old not in text:
            yield f"{name}.hpp.in does not say {old}"
            continue
        template.write_text(text.replace(old, new, 1), encoding="utf-8")
        command = [sys.executable, "-B", "-c", "import classes, linked; classes.files(), linked.files()"]
        done = subprocess.run(command, cwd=other / "api", capture_output=True, text=True)
        template.write_text(text, encoding="utf-8")
        if done.returncode == 0 or said not in done.stderr or not re.search(rf"{name}\.hpp\.in: (//)?@", done.stderr):
            yield f"{new}: {done.stderr or 'accepted'}"


def complaints_of_spoiling(source, folder):
    """What is refused by the parser alone, which reads all functions of pw85.h."""
    other = copied(source, folder / "spoiled")
    header = other / "include/pw85.h"
    text = header.read_text(encoding="utf-8")
    for old, new, said in SPOILED:
        if old not in text:
            yield f"pw85.h does not say {old}"
            continue
        header.write_text(text.replace(old, new, 1), encoding="utf-8")
        program = "import declarations as d\nfor one in d.functions('pw85.h'): one.flattened"
        done = subprocess.run([sys.executable, "-B", "-c", program], cwd=other / "api", capture_output=True, text=True)
        if done.returncode == 0 or said not in done.stderr or not re.search(r"pw85\.h:\d+: pw85_", done.stderr):
            yield f"{new}: {done.stderr or 'accepted'}"


def main(source):
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        parts = (complaints_of_rewording, complaints_of_spoiling, complaints_of_templates)
        found = [complaint for part in parts for complaint in part(source, folder)]
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    if sys.argv[1] == "made":
        json.dump(made(Path(sys.argv[2])), sys.stdout)
    else:
        sys.exit(main(Path(sys.argv[1]).resolve()))
