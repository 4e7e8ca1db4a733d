"""Directive ``pw85-status-table``: the table of status codes, from the list in include/pw85/status.h."""

import re
from pathlib import Path

from docutils import nodes
from docutils.statemachine import StringList
from docutils.parsers.rst import Directive

STATUS_H = Path(__file__).resolve().parents[2] / "include" / "pw85" / "status.h"
ENTRY = re.compile(r'X\((\w+), (\w+), (\d+),\s*((?:"[^"]*"\s*)+)\)')


def status_codes():
    """(name in C, name in C++, value, text) for each code."""
    source = STATUS_H.read_text(encoding="utf-8").replace("\\\n", "\n")
    for c_name, cpp_name, value, literals in ENTRY.findall(source):
        yield c_name, cpp_name, value, "".join(re.findall(r'"([^"]*)"', literals))


class StatusTable(Directive):
    def run(self):
        self.state.document.settings.record_dependencies.add(str(STATUS_H))
        lines = [".. list-table::", "   :header-rows: 1", "   :widths: 20 20 8 52", "   :class: stacked", ""]
        lines += ["   * - C and Fortran", "     - C++ and Python", "     - value", "     - text of strerror"]
        codes = list(status_codes())
        if not codes:
            raise self.error(f"no status codes found in {STATUS_H}")
        for c_name, cpp_name, value, text in codes:
            lines += [f"   * - ``{c_name}``", f"     - ``{cpp_name}``", f"     - {value}", f"     - {text}"]
        container = nodes.container()
        self.state.nested_parse(StringList(lines, str(STATUS_H)), self.content_offset, container)
        return container.children


def setup(app):
    app.add_directive("pw85-status-table", StatusTable)
    return {"parallel_read_safe": True}
