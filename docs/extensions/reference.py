"""Reference pages from the headers, so that no list of functions is kept by hand (docs/declarations.py reads them).

.. function-table:: pw85.h

    A table of the functions of a C header for each of its sections: name and first sentence.

.. cpp-functions:: pw85/pw85.hpp

    The sections of a C++ header with all their functions.
"""

import declarations
from docutils import nodes
from docutils.parsers.rst import Directive
from docutils.statemachine import StringList
from sphinx.util.nodes import nested_parse_with_titles


def as_text(sentence):
    """A sentence of a comment as reStructuredText."""
    return sentence.replace("\\", "\\\\").replace("*", "\\*").replace("|", "\\|").replace("`", "``")


class FromHeader(Directive):
    required_arguments = 1

    def run(self):
        header = self.arguments[0]
        path = str(declarations.INCLUDE / header)
        self.state.document.settings.record_dependencies.add(path)
        lines = [line for section in declarations.sections(header) if section.functions for line in self.lines(section)]
        node = nodes.section()
        node.document = self.state.document
        nested_parse_with_titles(self.state, StringList(lines, path), node)
        return node.children


class FunctionTable(FromHeader):
    def lines(self, section):
        yield f".. list-table:: {section.title}"
        yield from ("   :widths: 40 60", "   :class: functions", "")
        for function in section.functions:
            yield f"   * - :c:func:`{function.name}`"
            yield f"     - {as_text(function.brief())}"
        yield ""


class CppFunctions(FromHeader):
    def lines(self, section):
        yield from (section.title, "~" * len(section.title), "")
        names = [function.name for function in section.functions]
        for function in section.functions:
            signature = f"({', '.join(function.parameters)})" if names.count(function.name) > 1 else ""
            yield from (f".. doxygenfunction:: pw85::{function.name}{signature}", "   :project: cpp", "")


def setup(app):
    app.add_directive("function-table", FunctionTable)
    app.add_directive("cpp-functions", CppFunctions)
    return {"parallel_read_safe": True}
