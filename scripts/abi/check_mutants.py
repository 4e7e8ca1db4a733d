#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests scripts/abi.sh in a copy of the tree: it must fail for changes that break programs, and succeed for changes that do not.
Each change is undone before the next one, so that little is compiled twice."""

import contextlib
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
HEADER, SOURCE = "include/pw85_zheng.h", "src/legacy/pw85_zheng.cpp"
ELLIPSES = "int pw85_zheng_ellipses(double const direction[2], double const q1[3], double const q2[3], double *distance)"

# Name, whether programs still run, and replacements: (file, old text, new text).
CHANGES = [
    ("nothing", True, []),
    ("a function is new", True, [
        (HEADER, "PW85_API int pw85_zheng_ellipses", "PW85_API int pw85_zheng_new(int a);\nPW85_API int pw85_zheng_ellipses"),
        (SOURCE, ELLIPSES, f"int pw85_zheng_new(int a) {{ return a; }}\n{ELLIPSES}")]),
    ("a function is gone", False, [
        (HEADER, "int pw85_zheng_ellipses(", "int pw85_zheng_ellipses_2d("),
        (SOURCE, "int pw85_zheng_ellipses(", "int pw85_zheng_ellipses_2d(")]),
    ("a parameter is new", False, [
        (HEADER, "const q2[3], double *distance)", "const q2[3], double *distance, int)"),
        (SOURCE, "const q2[3], double *distance)", "const q2[3], double *distance, int)")]),
    ("a parameter has another type", False, [
        (HEADER, "const q2[3], double *distance)", "const q2[3], float *distance)"),
        (SOURCE, f"{ELLIPSES}\n{{", f"{ELLIPSES.replace('double *distance', 'float *')}\n"
         "{\n    double *distance = nullptr;")]),
    ("a function returns something else", False, [
        (HEADER, "PW85_API int pw85_zheng_ellipses(", "PW85_API long pw85_zheng_ellipses("),
        (SOURCE, ELLIPSES, ELLIPSES.replace("int", "long", 1))]),
    ("a status is new", True, [
        ("include/pw85/status.h", 'X(PW85_EDEVICE,', 'X(PW85_ENEW, of_a_new_kind, 99, "new") X(PW85_EDEVICE,')]),
    ("a status has another number", False, [
        ("include/pw85/status.h", "not_positive_definite, 2", "not_positive_definite, 12")]),
    ("arrays have another length", False, [("include/pw85.h", "#define PW85_SYM 6", "#define PW85_SYM 7")]),
    ("a structure is larger", False, [
        ("include/pw85.h", "} pw85_motion;", "    double more;\n} pw85_motion;")]),
]


def copy_tree(target):
    listed = subprocess.run(["sh", "-c", ". scripts/minimal_system.sh && list_sources"], cwd=ROOT, check=True, text=True,
                            stdout=subprocess.PIPE)
    present = [file for file in listed.stdout.split("\0")[:-1] if (ROOT / file).is_file()]
    subprocess.run(["cp", "--parents", "-t", str(target), *present], cwd=ROOT, check=True)


@contextlib.contextmanager
def changed(tree, replacements):
    before = {}
    for file, old, new in replacements:
        path = tree / file
        text = path.read_text()
        before.setdefault(path, text)
        if text.count(old) != 1:
            sys.exit(f"{file} has {text.count(old)} times {old!r}")
        path.write_text(text.replace(old, new))
    yield
    for path, text in before.items():
        path.write_text(text)


def main():
    failures = 0
    with tempfile.TemporaryDirectory(prefix="pw85-abi-") as folder:
        tree = Path(folder)
        copy_tree(tree)
        subprocess.run(["scripts/abi.sh", "record"], cwd=tree, check=True)
        for name, compatible, replacements in CHANGES:
            with changed(tree, replacements):
                done = subprocess.run(["scripts/abi.sh"], cwd=tree, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            # A change that does not compile also fails, but without this message.
            ok = (done.returncode == 0) == compatible and (compatible or "not compatible with" in done.stdout)
            failures += not ok
            print(f"{'ok' if ok else 'FAILED'}: {name}" + ("" if ok else f"\n{done.stdout}"), flush=True)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
