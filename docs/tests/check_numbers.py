"""Whether numbers and addresses that pages and comments repeat are those of the code. Usage: check_numbers.py SOURCE"""

import re
import sys
from pathlib import Path

SOLVER, HEADER = "include/pw85/solver.hpp", "include/pw85.h"
HOME = ("pyproject.toml", r'Homepage = "(\S+)"')
EVALUATIONS = (SOLVER, r"max_evaluations = (\d+);")

# (file, pattern of what is in it), (file, pattern of what it must be)
REPEATED = [
    ((HEADER, r"No more than (\d+) evaluations"), EVALUATIONS),
    (("docs/optimization.rst", r"No more than (\d+) evaluations"), EVALUATIONS),
    (("docs/optimization.rst", r"``PW85_MAX_ITER`` \((\d+)\)"), (HEADER, r"define PW85_MAX_ITER (\d+)")),
    (("docs/optimization.rst", r"``PW85_NR_ITER`` \((\d+)\)"), (HEADER, r"define PW85_NR_ITER (\d+)")),
    (("docs/optimization.rst", r"``PW85_LAMBDA_ATOL`` \(10\\ :sup:`-(\d+)`\)"), (HEADER, r"LAMBDA_ATOL 1e-(\d+)")),
    (("README.md", r"git clone (\S+)"), HOME),
    (("docs/index.rst", r"git clone (\S+)"), HOME),
    (("docs/installation.rst", r"git clone (\S+)"), HOME),
    (("CITATION.cff", r'repository-code: "(\S+)"'), HOME),
    (("debian/control", r"Homepage: (\S+)"), HOME),
    (("debian/copyright", r"Source: (\S+)"), HOME),
    (("src/brent.cpp", r"lambda_atol, (1e-\d+),"), (HEADER, r"LAMBDA_ATOL (1e-\d+)")),
]


def found_at(source, place):
    path, pattern = place
    text = " ".join((source / path).read_text(encoding="utf-8").split())
    found = re.findall(pattern, text)
    return found[0].replace(",", "") if len(found) == 1 else f"{len(found)} matches of {pattern} in {path}"


def main():
    source = Path(sys.argv[1])
    wrong = 0
    for repeated, original in REPEATED:
        stated, actual = found_at(source, repeated), found_at(source, original)
        if stated != actual:
            wrong += 1
            print(f"{repeated[0]} says {stated}, but {original[0]} {actual}")
    return 1 if wrong else 0


sys.exit(main())
