"""A table of numbers in a page, whose rows a directive computes."""

from docutils import nodes
from docutils.parsers.rst import Directive
from docutils.statemachine import StringList


class NumberTable(Directive):
    """A directive whose content is the caption. `files` are those that the rows depend on, `table` yields the headings and then the
    rows, and `options_of_list` the options of the list."""

    required_arguments = 1
    has_content = True

    def files(self):
        raise NotImplementedError

    def table(self):
        raise NotImplementedError

    def options_of_list(self):
        return ()

    def run(self):
        files = [str(path) for path in self.files()]
        self.state.document.settings.record_dependencies.add(*files)
        lines = [f".. list-table:: {' '.join(self.content)}", "   :header-rows: 1", "   :class: numbers", *self.options_of_list(), ""]
        for cells in self.table():
            lines += [("   * - " if i == 0 else "     - ") + cell for i, cell in enumerate(cells)]
        container = nodes.container()
        self.state.nested_parse(StringList(lines, files[0]), self.content_offset, container)
        return container.children
