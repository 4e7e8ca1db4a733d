"""Rewrites the measured sections of README.md and of docs/lammps.md, and the pictures of measurements, from docs/measurements.json.

Usage: measured_pages.py [--check]; with --check nothing is written: it fails, and says why, if any of them is out of date.
The measured tables of the manual are made with its pages (extensions/measured_table.py).
"""

import json
import re
import subprocess
import sys
from html import escape
from pathlib import Path

import measured_lammps
import measurements

HERE = Path(__file__).resolve().parent
README, LAMMPS_PAGE = HERE.parent / "README.md", HERE / "lammps.md"
SECTION = re.compile(r"<!-- measured (\w+) -->\n.*?<!-- end of measured -->", re.DOTALL)
TIMES = HERE.parent / ".ci" / "times.json"  # of README's commands, by `.ci/run --record tests tutorial pip`
# What README says before the minutes of its commands, and the parts of .ci/run that run them
COMMANDS = {r"scripts/tutorial\.sh +# ": "tutorial", r"scripts/test\.sh +# ": "tests", "These commands take ": "pip"}
PICTURES = {**{name: name for name in ("accuracy", "any_dimension", "digits", "evaluations", "growth")}, "throughput": "speed"}
ASPECTS = ("2", "10", "100", "1000")


def readme_section():
    """The section of README.md."""
    return "\n".join([*side_by_side(), "", *largest_error()])


def largest_error():
    """A sentence on the largest measured error of the contact function."""
    every = measurements.accuracy_of_all_problems()
    worst = float(every["worst_contact"])
    yield f"The largest relative error of μ² by `pw85_contact` is {worst:.2g} in units of u·cond, with u = 2⁻⁵³ and the entrywise"
    yield (f"[condition number](data/README.md) of the pair, over {int(every['pairs']):,} pairs with aspect ratios to 10⁶, "
           "size ratios to 10¹⁴ and")
    yield "|μ² - 1| down to 0."


def side_by_side():
    """The table of libraries, with its heading and conditions."""
    columns = {"library": "", "gives": "gives", **{f"aspect_{a}": f"aspect {a}" for a in ASPECTS}}
    columns |= {"wrong_1000": "wrong (%), aspect 1000", "wrong_1e-7": "wrong (%), near contact"}
    yield ("Nanoseconds per pair in one thread, and wrong answers in percent. Each program gets the same pairs of general ellipsoids, "
           "half of which")
    yield "overlap ([what is compared](docs/related.rst)). *Near contact* is |μ² - 1| = 10⁻⁷ at aspect ratio 10."
    yield ""
    yield "| " + " | ".join(columns.values()) + " |"
    yield "|---|---|" + "---:|" * (len(columns) - 2)
    for row in measurements.read_table("side_by_side"):
        label = f"`{row['library']}`" if row["library"].startswith("pw85_") else row["library"]
        yield "| " + " | ".join([label, *(row[column] for column in columns if column != "library")]) + " |"
    yield ""
    yield f"({measurements.conditions('side_by_side')}; one program, `bench/side_by_side`.)"


SECTIONS = {"speed": readme_section, **{name: lambda lines=lines: "\n".join(lines()) for name, lines in measured_lammps.SECTIONS.items()}}


def minutes(part):
    """How long one of README's commands takes, in words."""
    took = round(json.loads(TIMES.read_text(encoding="utf-8"))["parts"][part]["minutes"])
    return "about a minute" if took <= 1 else f"about {took} minutes"


def with_sections(page):
    """The text of a page with its sections, and the minutes of its commands, rewritten."""

    def section(found):
        return f"<!-- measured {found[1]} -->\n{SECTIONS[found[1]]()}\n<!-- end of measured -->"

    text = SECTION.sub(section, page.read_text(encoding="utf-8"))
    for before, part in COMMANDS.items():
        text = re.sub(rf"({before})about .*? (?=on two cores)", rf"\g<1>{minutes(part)} ", text)
    return text


def out_of_date():
    for page in (README, LAMMPS_PAGE):
        if page.read_text(encoding="utf-8") != with_sections(page):
            yield str(page)
    for picture, table in PICTURES.items():
        path = HERE / "pictures" / f"{picture}.svg"
        if escape(measurements.source(table)) not in path.read_text(encoding="utf-8"):
            yield str(path)
    for table in (HERE.parent / "reference").glob("*/*.csv"):
        path = HERE / "pictures" / f"{table.stem}.svg"
        if path.exists() and escape(measurements.source_of_file(table)) not in path.read_text(encoding="utf-8"):
            yield str(path)


def write():
    for page in (README, LAMMPS_PAGE):
        page.write_text(with_sections(page), encoding="utf-8")
    for picture in PICTURES:
        subprocess.run([sys.executable, HERE / "pictures" / f"{picture}.py"], check=True)


def main():
    if sys.argv[1:] != ["--check"]:
        write()
        return 0
    stale = list(out_of_date())
    for page in stale:
        print(f"{page} does not show what is in docs/measurements.json: run docs/measured_pages.py")
    return 1 if stale else 0


if __name__ == "__main__":
    sys.exit(main())
