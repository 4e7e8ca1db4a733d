"""Directive ``measured-table``: chosen columns of a table in docs/measurements.json, or of a file like reference/crystals/crystals.csv,
with headings for readers; and chosen rows, those with one of the values in a column, or in each of several columns, or the last of
those that are alike in a column (that of the best target).

.. measured-table:: table
   :columns: column=heading; column:.3f=heading
   :where: column=value value; column=value
   :last-of: column
   :name: label

   Caption.
"""

import csv

import measurements
from docutils.parsers.rst import directives
from number_table import NumberTable

ROOT = measurements.RESULTS.parent.parent


def text(cell, form=""):
    if form:
        return format(float(cell), form)
    return f"{cell:g}" if isinstance(cell, float) else str(cell)


def read(path):
    with path.open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


class MeasuredTable(NumberTable):
    option_spec = {  # noqa: RUF012 (as docutils has it)
        "columns": directives.unchanged_required,
        "where": directives.unchanged,
        "last-of": directives.unchanged,
        "name": directives.unchanged,
    }

    def path(self):
        return ROOT / self.arguments[0] if self.arguments[0].endswith(".csv") else measurements.RESULTS

    def rows(self):
        path = self.path()
        rows = measurements.read_table(self.arguments[0]) if path == measurements.RESULTS else read(path)
        for condition in filter(None, self.options.get("where", "").split(";")):
            column, _, values = condition.strip().partition("=")
            rows = [row for row in rows if row[column] in values.split()]
        if "last-of" in self.options:
            rows = list({row[self.options["last-of"]]: row for row in rows}.values())
        return rows

    def files(self):
        return [self.path()]

    def table(self):
        columns = [entry.strip().split("=") for entry in self.options["columns"].split(";")]
        yield [heading for _, heading in columns]
        forms = [column.partition(":")[::2] for column, _ in columns]
        for row in self.rows():
            yield [text(row.get(column, ""), form) for column, form in forms]

    def options_of_list(self):
        return [f"   :name: {self.options['name']}"] if "name" in self.options else []


def setup(app):
    app.add_directive("measured-table", MeasuredTable)
    return {"parallel_read_safe": True}
