"""Directive ``program-table``: the programs of one kind of docs/other_programs.toml. Directive ``truth-table``: its true numbers.

.. program-table:: engine

.. truth-table::
"""

import tomllib
from pathlib import Path

from docutils import nodes
from docutils.parsers.rst import Directive
from docutils.statemachine import StringList

PATH = Path(__file__).resolve().parents[1] / "other_programs.toml"
LABELS = {
    "lengths": "Lengths",
    "scale": "Non-uniform scale",
    "quaternion": "Quaternion",
    "mass": "Mass, inertia",
    "margin": "Margin",
    "depth": "Depth",
    "tolerance": "Tolerance",
    "wrong": "Wrong",
}


def data():
    return tomllib.loads(PATH.read_text(encoding="utf-8"))


def text_of(value):
    """A true number, or several, as the pages show it."""
    return ", ".join(f"{x:.5g}" for x in (value if isinstance(value, list) else [value]))


def filled(text, truths):
    return text.format_map({name: text_of(truth["value"]) for name, truth in truths.items()})


def source(program):
    """How the statements were established."""
    return f"``findings/{program['script']}.sh``" if "script" in program else program["established"]


def cells(program, truths):
    """The two cells of a program's row, each a list of paragraphs."""
    yield [f"**{program['name']}**"]
    said = [f"**{label}:** {filled(program[key], truths)}" for key, label in LABELS.items() if key in program]
    packages = ", ".join(f"``{package}``" for package in program["packages"])
    yield [*said, f"**Run:** {packages}; {source(program)}"]


class Table(Directive):
    """A list table with one paragraph a line in each cell."""

    options_of_list = ()

    def rows(self):
        """The headings and then the rows; a cell is a list of paragraphs."""
        raise NotImplementedError

    def run(self):
        self.state.document.settings.record_dependencies.add(str(PATH))
        lines = [".. list-table::", "   :header-rows: 1", *self.options_of_list, ""]
        for row in self.rows():
            for i, paragraphs in enumerate(row):
                lines += [("   * - " if i == 0 else "     - ") + paragraphs[0]]
                lines += [line for paragraph in paragraphs[1:] for line in ("", "       " + paragraph)]
            lines.append("")
        container = nodes.container()
        self.state.nested_parse(StringList(lines, str(PATH)), self.content_offset, container)
        return container.children


class ProgramTable(Table):
    required_arguments = 1
    options_of_list = ("   :widths: 22 78", "   :class: stacked")

    def rows(self):
        made = data()
        yield [["program"], ["what an ellipsoid is there"]]
        for program in made["program"]:
            if program["kind"] == self.arguments[0]:
                yield cells(program, made["truths"])


class TruthTable(Table):
    options_of_list = ("   :widths: 76 24", "   :class: stacked")

    def rows(self):
        yield [["what"], ["true value"]]
        for truth in data()["truths"].values():
            yield [[truth["what"]], [text_of(truth["value"])]]


def setup(app):
    app.add_directive("program-table", ProgramTable)
    app.add_directive("truth-table", TruthTable)
    return {"parallel_read_safe": True}
