"""Whether tests see changes of the mathematics: each mutant is one changed expression of a header, and its test, compiled with this
header in place of the true one, must fail. Prints the Test Anything Protocol. Usage: mutants.py SOURCE BUILD
"""

import json
import os
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

# Header, what is changed into what, and the test that must fail.
MUTANTS = [
    ("contact/evaluation.hpp", "(alpha - lambda) * su)", "(alpha + lambda) * su)", "test_evaluation"),
    ("contact/evaluation.hpp", "alpha * alpha * dot(s, p) - lambda", "alpha * dot(s, p) - lambda", "test_evaluation"),
    ("contact/geometry.hpp", "return at.weight1 * product(q1, at.v);", "return at.weight2 * product(q1, at.v);", "test_geometry"),
    ("contact/geometry.hpp", "T(T(2) * at.lambda1 * at.lambda2)", "T(at.lambda1 * at.lambda2)", "test_geometry"),
    ("contact/contact_hessian.hpp", "ellipsoid == 1 ? -own : own", "ellipsoid == 2 ? -own : own", "test_hessian"),
    ("contact/contact_hessian.hpp", "fixed - T(0.5) * (dot(x.turn", "fixed + T(0.5) * (dot(x.turn", "test_hessian"),
    ("contact/contact_hessian.hpp", "T(2) * (weight * fixed", "T(1) * (weight * fixed", "test_hessian"),
    ("contact/forms.hpp", "two * (x * y - w * z)", "two * (x * y + w * z)", "test_forms"),
    ("algebra/sine_cosine.hpp", "w * (-1.0 / 5040", "w * (-1.0 / 5039", "test_elementary"),
    ("distance/support.hpp", "return {T(T(1) / extent) * point, extent};", "return {point, extent};", "test_distance"),
    ("distance/distance_derivatives.hpp", "cross(n, product(turn, rows[k]))", "cross(product(turn, rows[k]), n)", "test_distance"),
    ("distance/walls.hpp", "radius - dot(n2, across) - s.extent", "radius + dot(n2, across) - s.extent", "test_walls"),
    ("shapes/triangle.hpp", "form.map(i - m)) < T(0));", "form.map(i - m)) > T(0));", "test_shapes"),
    ("motion/closest_passage.hpp", "at_end = (t == T(0) && along >= T(0))", "at_end = (t == T(0) && along <= T(0))",
     "test_closest_passage"),
    ("motion/free_path.hpp", "length < plane.until ? length", "length > plane.until ? length", "test_free_path"),
    ("overlap/compare.hpp", "(concentric ? 0 : 1) - (positive ? 1 : 0)", "(concentric ? 1 : 0) - (positive ? 1 : 0)", "test_compare"),
    ("overlap/containment_factor.hpp", "W(W(1) / search.best.root2)", "W(W(2) / search.best.root2)", "test_containment_factor"),
    ("overlap/quartic.hpp", "int apart_margin = 20", "int apart_margin = 19", "proofs recall"),
    ("contact/rational_search.hpp", "int adjugate_error = 13", "int adjugate_error = 12", "proofs recall"),
    ("algebra/symmetric.hpp", "D == 2 ? 8 : 16", "D == 2 ? 8 : 15", "proofs recall"),
]


class Tests:
    """The programs of a build folder, compiled anew with other headers."""

    def __init__(self, source, build):
        self.source, self.build = source, build
        self.units = {Path(unit["output"]).name: unit for unit in json.loads((build / "compile_commands.json").read_text())}
        ninja = subprocess.run(["ninja", "-C", build, "-t", "commands"], check=True, stdout=subprocess.PIPE, text=True).stdout
        self.links = [shlex.split(line) for line in ninja.splitlines() if " -o tests/" in line and " -c " not in line]

    def fails(self, program, include, work):
        """Whether a test fails with the headers of a folder; an error of the compiler is none of a test."""
        name, *arguments = program.split() if " " in program else (program, "--tap", "-k", "-m", "thorough")
        unit = self.units[f"{name}.cpp.o"]
        changed = work / "changed.o"
        words = [f"-I{include}" if word == "-I../include" else word for word in shlex.split(unit["command"])]
        words[words.index("-o") + 1] = str(changed)
        self.run(words)
        link = next(words for words in self.links if Path(words[words.index("-o") + 1]).name == name)
        link = [str(changed) if word == unit["output"] else word for word in link]
        link[link.index("-o") + 1] = str(work / "changed")
        self.run(link)
        environment = {**os.environ, "LD_LIBRARY_PATH": str(self.build / "src")}
        return subprocess.run([work / "changed", *arguments], env=environment, cwd=self.build, timeout=300,
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode != 0

    def run(self, words):
        subprocess.run(words, cwd=self.build, check=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)


def is_seen(tests, header, old, new, test):
    with tempfile.TemporaryDirectory(prefix="pw85-mutant-") as folder:
        include = Path(folder) / "include"
        shutil.copytree(tests.source / "include", include)
        changed = include / "pw85" / header
        text = changed.read_text(encoding="utf-8")
        if text.count(old) != 1:
            return False, f"{header} has {text.count(old)} times {old!r}"
        changed.write_text(text.replace(old, new), encoding="utf-8")
        try:
            return tests.fails(test, include, Path(folder)), f"{test} passes with {new!r}"
        except subprocess.CalledProcessError as error:
            return False, f"{error}\n{error.stdout.decode()}"
        except subprocess.TimeoutExpired:
            return True, ""


def main():
    source, build = (Path(word).resolve() for word in sys.argv[1:])
    tests = Tests(source, build)
    print(f"1..{len(MUTANTS)}")
    all_seen = True
    for number, (header, old, new, test) in enumerate(MUTANTS, 1):
        seen, why = is_seen(tests, header, old, new, test)
        all_seen = all_seen and seen
        print(f"{'ok' if seen else 'not ok'} {number} {header}: {new}", flush=True)
        if not seen:
            print("\n".join(f"# {line}" for line in why.splitlines()[:20]), flush=True)
    return 0 if all_seen else 1


if __name__ == "__main__":
    sys.exit(main())
