"""Reference pages from the headers, so that no list of functions is kept by hand (api/declarations.py reads them).

.. function-table:: pw85.h

    A table of the functions of a C header for each of its sections: name and first sentence.

.. cpp-functions:: pw85/pw85.hpp

    The sections of a C++ header with all their functions.

.. cpp-values:: pw85/pw85.hpp

    The structures that it declares, with their members.

.. cpp-headers::

    What the given C++ headers, one on each line, say at their top.

.. fortran-functions:: pw85.h

    The same for Fortran, in the sections of the C header.

.. r-functions:: pw85.h

    The functions of R that are made from the sections of a C header.

.. octave-functions:: pw85.h

    The functions of Octave that are made from the sections of a C header.

.. javascript-functions:: pw85.h

    The functions of JavaScript for those of the sections of a C header.

.. rust-functions:: pw85.h

    The same for Rust.

.. python-functions:: Distance

    The functions of Python for those of a section of the C headers, with their texts.

.. functions-by-purpose::

    A table with the given rows. Functions for many rows stand behind those for one, and functions that no row names follow at the
    end with their first sentences.
"""

import textwrap

import declarations
import fortran
import public_headers
import octave
import javascript
import pages
import r
import rust
from docutils import nodes
from docutils.parsers.rst import Directive
from docutils.statemachine import StringList
from sphinx import addnodes
from sphinx.util.nodes import nested_parse_with_titles


def as_text(sentence):
    """A sentence of a comment as reStructuredText."""
    return sentence.replace("\\", "\\\\").replace("*", "\\*").replace("|", "\\|").replace("`", "``")


def without_links(parsed):
    """The nodes with plain names in the place of links: the manual has no entries for what a header calls."""
    for node in parsed:
        for link in list(node.findall(addnodes.pending_xref)):
            link.replace_self(link.children)
    return parsed


class FromHeader(Directive):
    required_arguments = 1

    def run(self):
        header = self.arguments[0]
        self.depend_on(header)
        lines = [line for section in declarations.sections(header) if section.functions for line in self.lines(section)]
        return self.parsed(lines)

    def depend_on(self, *names):
        for header in names:
            self.state.document.settings.record_dependencies.add(str(public_headers.INCLUDE / header))

    def parsed(self, lines):
        node = nodes.section()
        node.document = self.state.document
        nested_parse_with_titles(self.state, StringList(lines, self.name), node)
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
        names = [function.name for function in declarations.functions(*public_headers.CPP_HEADERS)]
        for function in section.functions:
            signature = f"({', '.join(function.written)})" if names.count(function.name) > 1 else ""
            yield from (f".. doxygenfunction:: pw85::{function.name}{signature}", "   :project: cpp", "")


class CppValues(FromHeader):
    def run(self):
        lines = []
        for name in public_headers.values(self.arguments[0]):
            lines += [f".. doxygenstruct:: pw85::{name}", "   :project: cpp", "   :members:", "   :undoc-members:", ""]
        return self.parsed(lines)


class CppHeaders(FromHeader):
    required_arguments = 0
    has_content = True

    def run(self):
        lines = []
        for header in self.content:
            lines += [f".. rubric:: {header}", "", f".. doxygenfile:: {header}", "   :project: cpp",
                      "   :sections: briefdescription detaileddescription", ""]  # fmt: skip
        return without_links(self.parsed(lines))


class FortranFunctions(FromHeader):
    def lines(self, section):
        if section.title:
            yield from (section.title, "~" * len(section.title), "")
        module = fortran.procedures()
        for function in section.functions:
            yield from self.entry(module[function.name.lower()], function.name)

    def entry(self, function, c_name):
        yield from (f".. fortran-function:: {function.kind} {function.name}({', '.join(function.arguments)})", "")
        yield from (f"   {as_text(function.comment)} See :c:func:`{c_name}`.", "")
        if function.declarations:
            yield from ("   .. code-block:: fortran", "")
        for declaration in function.declarations:
            lines = textwrap.wrap(declaration, 72, subsequent_indent="  ", break_long_words=False)
            yield from (f"      {line}{' &' if line is not lines[-1] else ''}" for line in lines)
        yield ""


class RFunctions(FromHeader):
    def lines(self, section):
        listed = [one for one in r.exported() if one.first.function in section.functions]
        if listed and section.title:
            yield from (section.title, "~" * len(section.title), "")
        for question in listed:
            yield from self.entry(question)

    def entry(self, question):
        row, dimension = question.first, max(question.rows)
        names = r.columns(question, dimension)
        shown = ", ".join(f"``{name}``" for name in names) if len(names) < 12 else f"``{names[0]}``, ..., ``{names[-1]}``"
        said = " ".join(r.voice(question).head())
        yield from (f"``{r.usage(question)}``", f"   {as_text(said)}", "")
        yield from (f"   Result: {shown}. {question.dimensions} See :c:func:`{row.function.name}`.", "")


class OctaveFunctions(FromHeader):
    def lines(self, section):
        listed = [one for one in octave.questions() if one.first.function in section.functions]
        if listed and section.title:
            yield from (section.title, "~" * len(section.title), "")
        for question in listed:
            usages = " or ".join(f"``{usage}``" for usage in octave.usages(question))
            yield from (usages, f"   {as_text(' '.join(octave.voice(question).head()))}", "")
            yield from (f"   {question.dimensions} See :c:func:`{question.first.function.name}`.", "")


class JavaScriptFunctions(FromHeader):
    def lines(self, section):
        listed = [row for row in javascript.asked() if row.function in section.functions]
        if listed and section.title:
            yield from (section.title, "~" * len(section.title), "")
        for row in listed:
            yield from self.entry(row)

    def entry(self, row):
        signature, said = javascript.signature(row), " ".join(javascript.voice(row).head())
        yield from (f"``{signature}``", f"   {as_text(said)} See :c:func:`{row.function.name}`.", "")


class RustFunctions(FromHeader):
    def lines(self, section):
        listed = [row for row in rust.asked() if row.function in section.functions]
        if listed and section.title:
            yield from (section.title, "~" * len(section.title), "")
        for row in listed:
            yield from self.entry(row, rust.names_in_rust())

    def entry(self, row, names):
        result = "()" if row.is_of_many() else rust.result_of(row)
        arguments = [one.name for one in row.function.parameters if one.name != "n" or not row.is_of_many()]
        taken = arguments if row.is_of_many() else [one.name for one in row.inputs]
        many = f"Many rows: ``{names[row.many.name]}()``. " if row.many and not row.is_of_many() else ""
        yield from (f"``{names[row.function.name]}({', '.join(taken)}) -> Result<{result}, Error>``",
                    f"   {as_text(' '.join(rust.voice(row).head()))}", "", f"   {many}See :c:func:`{row.function.name}`.", "")


class PythonFunctions(FromHeader):
    final_argument_whitespace = True

    def run(self):
        self.depend_on(*public_headers.C_HEADERS)
        return self.parsed([f".. autofunction:: pypw85.{name}" for name in pages.python_functions(self.arguments[0])])


class FunctionsByPurpose(FromHeader):
    required_arguments = 0
    has_content = True

    def run(self):
        self.depend_on(*pages.PURPOSE_HEADERS)
        text = pages.with_twins("\n".join(self.content))
        options = (":widths: 44 56", ":header-rows: 1", ":class: stacked")
        rows = ["* - Task", "  - Functions", *text.splitlines(), *self.others(text)]
        return self.parsed([".. list-table::", *(f"   {line}" for line in (*options, "", *rows))])

    def others(self, text):
        listed = pages.unmentioned(text)
        yield from ["* - **something else**", "  -"] if listed else []
        for function in listed:
            yield from (f"* - {as_text(function.brief())}", f"  - :c:func:`{function.name}`")


def setup(app):
    app.add_directive("fortran-functions", FortranFunctions)
    app.add_directive("functions-by-purpose", FunctionsByPurpose)
    app.add_directive("function-table", FunctionTable)
    app.add_directive("cpp-functions", CppFunctions)
    app.add_directive("cpp-headers", CppHeaders)
    app.add_directive("cpp-values", CppValues)
    app.add_directive("octave-functions", OctaveFunctions)
    app.add_directive("javascript-functions", JavaScriptFunctions)
    app.add_directive("python-functions", PythonFunctions)
    app.add_directive("r-functions", RFunctions)
    app.add_directive("rust-functions", RustFunctions)
    return {"parallel_read_safe": True}
