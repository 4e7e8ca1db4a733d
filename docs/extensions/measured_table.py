"""Directive ``measured-table``: chosen columns of a file in docs/measurements, with headings for readers.

.. measured-table:: file.csv
   :columns: column=heading; column=heading
   :name: label

   Caption.
"""

import csv
from pathlib import Path

from docutils import nodes
from docutils.parsers.rst import Directive, directives
from docutils.statemachine import StringList

MEASUREMENTS = Path(__file__).resolve().parents[1] / "measurements"


class MeasuredTable(Directive):
    required_arguments = 1
    has_content = True
    option_spec = {"columns": directives.unchanged_required, "name": directives.unchanged}

    def run(self):
        path = MEASUREMENTS / self.arguments[0]
        self.state.document.settings.record_dependencies.add(str(path))
        columns = [entry.strip().split("=") for entry in self.options["columns"].split(";")]
        with path.open(newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        lines = [f".. list-table:: {' '.join(self.content)}", "   :header-rows: 1", "   :class: numbers"]
        if "name" in self.options:
            lines.append(f"   :name: {self.options['name']}")
        lines.append("")
        for cells in [[heading for _, heading in columns]] + [[row[column] for column, _ in columns] for row in rows]:
            lines += [("   * - " if i == 0 else "     - ") + cell for i, cell in enumerate(cells)]
        container = nodes.container()
        self.state.nested_parse(StringList(lines, str(path)), self.content_offset, container)
        return container.children


def setup(app):
    app.add_directive("measured-table", MeasuredTable)
    return {"parallel_read_safe": True}
