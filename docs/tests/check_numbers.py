"""Whether numbers that pages and comments repeat are those of the code, whether the constants that bench/choices.py replaces are there,
and whether each address in the sources is one of those that are known to hold what is said. Usage: check_numbers.py SOURCE
"""

import re
import sys
from pathlib import Path

SOLVER, HEADER = "include/pw85/contact/solver.hpp", "include/pw85.h"
BIBTEX = "docs/pw85.bib"
PERCOLATION, THRESHOLDS = "docs/reference/percolation.rst", "reference/percolation/thresholds.py"
EVALUATIONS = (SOLVER, r"max_evaluations = (\d+);")

# (file, pattern of what is in it), (file, pattern of what it must be)
REPEATED = [
    ((HEADER, r"evaluates f at most (\d+) times"), EVALUATIONS),
    (("docs/optimization.rst", r"No more than (\d+) evaluations"), EVALUATIONS),
    (("docs/optimization.rst", r"``PW85_MAX_ITER`` \((\d+)\)"), (HEADER, r"define PW85_MAX_ITER (\d+)")),
    (("docs/optimization.rst", r"``PW85_NR_ITER`` \((\d+)\)"), (HEADER, r"define PW85_NR_ITER (\d+)")),
    (("docs/optimization.rst", r"``PW85_LAMBDA_ATOL`` \(10\\ :sup:`-(\d+)`\)"), (HEADER, r"LAMBDA_ATOL 1e-(\d+)")),
    ((PERCOLATION, r"(0\.\d+) along a given edge"), (THRESHOLDS, r'"axis": (0\.\d+)')),
    ((PERCOLATION, r"(0\.\d+) along any of"), (THRESHOLDS, r'"any": (0\.\d+)')),
    ((PERCOLATION, r"1/\\nu = (\d\.\d+)`"), (THRESHOLDS, r"INVERSE_NU = (\d\.\d+)")),
    (("CITATION.cff", r"(?<!-)version: (\d\S+)"), ("meson.build", r"project\( *'pw85',.*? version: '(\S+)'")),
    (("debian/changelog", r"^pw85 \((\S+)-\d+\)"), ("CITATION.cff", r"(?<!-)version: (\d\S+)")),
    (("js/README.md", r"makes pw85-(\S+)\.tgz"), ("CITATION.cff", r"(?<!-)version: (\d\S+)")),
    ((BIBTEX, r"Version (\S+)}"), ("CITATION.cff", r"(?<!-)version: (\d\S+)")),
    ((BIBTEX, r"title = {(pw85.*?)},"), ("CITATION.cff", r'title: "(pw85.*?)"')),
    ((BIBTEX, r"author = {{(.*?)}},"), ("CITATION.cff", r"- name: (.*?) version:")),
    ((BIBTEX, r"title = {(Statistical.*?)},"), ("CITATION.cff", r'title: "(Statistical.*?)"')),
    ((BIBTEX, r"author = {(\w+), John"), ("CITATION.cff", r"family-names: (\w+) given-names: John W\.")),
    ((BIBTEX, r"and (\w+), M. S.}"), ("CITATION.cff", r"family-names: (\w+) given-names: M. S\.")),
    *[
        ((BIBTEX, rf"{bibtex} = {{(.*?)}}"), ("CITATION.cff", rf" {cff}: (\S.*?)(?: \w+:|$)"))
        for bibtex, cff in (("journal", "journal"), ("volume", "volume"), ("number", "issue"), ("year", "year"), ("doi", "doi"))
    ],
    ((BIBTEX, r"pages = {(\d+)"), ("CITATION.cff", r"start: (\d+)")),
    ((BIBTEX, r"pages = {\d+--(\d+)"), ("CITATION.cff", r"end: (\d+)")),
    (("src/brent/brent.cpp", r"lambda_atol, (1e-\d+),"), (HEADER, r"LAMBDA_ATOL (1e-\d+)")),
]

# Where addresses lead to; not to a place of this library, which has none.
HOSTS = """127.0.0.1 creativecommons.org deb.debian.org doi.org keepachangelog.com matplotlib.org purl.org registry.npmjs.org
    semver.org threejs.org www.debian.org www.lammps.org www.w3.org""".split()
EARLIER = ("docs/migration.rst", "github.com")  # the page that names the earlier implementation


def sources(source):
    """The text files, without those that were built."""
    for path in sorted(source.rglob("*")):
        name = path.relative_to(source)
        if path.is_file() and not re.match(r"build|install/|subprojects|\.git/|\.\w+_cache", str(name)):
            try:
                yield str(name), path.read_text(encoding="utf-8")
            except UnicodeDecodeError:
                continue


def unknown_addresses(source):
    for name, text in sources(source):
        for address, host in re.findall(r"""(https?://([\w.-]+)[^\s"'`<>)]*)""", text):
            if host not in HOSTS and (name, host) != EARLIER:
                yield f"{name} names {address}, of which nothing is known"


def unknown_constants(source):
    sys.path.insert(0, str(source / "bench"))
    from choices import CHOICES, NORMAL_CHOICES

    for header, text, *_ in [*CHOICES, *NORMAL_CHOICES]:
        count = (source / "include/pw85" / header).read_text(encoding="utf-8").count(text)
        if count != 1:
            yield f"bench/choices.py replaces {text}, which is there {count} times in {header}"


def found_at(source, place):
    path, pattern = place
    text = (source / path).read_text(encoding="utf-8")
    text = " ".join(re.sub(r"\n \* ", "\n", text).split())  # lines of a comment of C are filled
    found = re.findall(pattern, text)
    return re.sub("[,{}]", "", found[0]) if len(found) == 1 else f"{len(found)} matches of {pattern} in {path}"


def main():
    source = Path(sys.argv[1])
    wrong = 0
    for repeated, original in REPEATED:
        stated, actual = found_at(source, repeated), found_at(source, original)
        if stated != actual:
            wrong += 1
            print(f"{repeated[0]} says {stated}, but {original[0]} {actual}")
    unknown = [*unknown_addresses(source), *unknown_constants(source)]
    print("\n".join(unknown))
    return 1 if wrong or unknown else 0


sys.exit(main())
