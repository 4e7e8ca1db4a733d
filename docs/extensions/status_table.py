"""Directive ``pw85-status-table``: the table of status codes."""

from docutils import nodes
from docutils.statemachine import StringList
from docutils.parsers.rst import Directive
from statuses import STATUS_H, status_codes


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
