"""Directive ``pw85-cause-table``: what makes functions of the library fail, with which status, and which functions (api/causes.py)."""

from causes import CAUSES
from declarations import functions_with_status
from public_headers import INCLUDE, PARTS
from docutils import nodes
from docutils.parsers.rst import Directive
from docutils.statemachine import StringList

WHOM = {"not definite": "all that take forms", "size": "all that take arrays of any length"}


def whom(cause):
    """The functions that a cause concerns, in words if they are many."""
    if cause.key in ("null", "NaN", "infinity", "not definite"):
        return WHOM.get(cause.key, "all")
    found = [function.name for function in functions_with_status() if cause.is_of(function)]
    return WHOM.get(cause.key) or ", ".join(f":c:func:`{name}`" for name in found)


class CauseTable(Directive):
    def run(self):
        for header in PARTS:
            self.state.document.settings.record_dependencies.add(str(INCLUDE / header))
        lines = [".. list-table::", "   :header-rows: 1", "   :widths: 34 18 48", "   :class: stacked", ""]
        lines += ["   * - cause", "     - status", "     - functions"]
        for cause in CAUSES:
            lines += [f"   * - {cause.text}", f"     - ``{cause.status}``", f"     - {whom(cause)}"]
        container = nodes.container()
        self.state.nested_parse(StringList(lines, self.name), self.content_offset, container)
        return container.children


def setup(app):
    app.add_directive("pw85-cause-table", CauseTable)
    return {"parallel_read_safe": True}
