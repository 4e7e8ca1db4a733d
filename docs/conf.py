"""Configuration of Sphinx. Meson passes the release, the place of Doxygen's XML, and the built Python package."""

import enum
import gc
import importlib
import os
import re
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE / "extensions"), str(HERE.parent / "api")]

import measurements  # noqa: E402
from sphinx.pycode import ModuleAnalyzer  # noqa: E402
from sphinx.util.nodes import make_refnode  # noqa: E402

# Sphinx makes millions of nodes, and keeps most of them. Python seeks circles that can be freed after 700 new objects by default.
gc.set_threshold(100_000, 20, 100)

project = "pw85"
copyright = "the authors of pw85"
author = "the authors of pw85"
extensions = [
    "myst_parser",
    "breathe",
    "sphinx.ext.autodoc",
    "sphinx.ext.mathjax",
    "sphinx.ext.napoleon",
    "sphinx_copybutton",
    "sphinx_inline_tabs",
    "cause_table",
    "declaration_ids",
    "furo_of_debian",
    "equation_of_state_table",
    "measured_table",
    "percolation_table",
    "program_table",
    "reference",
    "search",
    "status_table",
    "virial_table",
]
highlight_language = "none"
source_suffix = {".rst": "restructuredtext", ".md": "markdown"}
nitpicky = True
nitpick_ignore_regex = [
    # Files to which pages refer that are also read elsewhere.
    ("myst", r".*"),
    # Standard types; template parameters; the namespace, which has no page.
    ("c:identifier", r"size_t|int32_t|int64_t"),
    # Shapes of arrays; types of other packages.
    ("py:class", r"[a-z]\w*|\d+|(?:numpy|np|os|torch|collections)\..*"),
    ("cpp:identifier", r"T|D|pw85(?:::(?:legacy|zheng))?|detail|(?:detail::)?rotation_axes<D>|pw85_\w+|\w+<T, D>|ShapeContact<T, [23]>"),
]
add_function_parentheses = True
default_role = "code"
numfig = True
rst_epilog = f"""
.. |contact-problems| replace:: {measurements.number_of_contact_problems():,}
.. |conditions| replace:: {measurements.conditions()}
.. |conditions-side-by-side| replace:: {measurements.conditions("side_by_side")}
.. |conditions-of-instructions| replace:: {measurements.conditions("instructions")}
.. |conditions-of-convex_peers| replace:: {measurements.conditions("convex_peers")}
.. |conditions-of-languages| replace:: {measurements.conditions("languages")}
.. |conditions-of-peers| replace:: {measurements.conditions("peers")}
.. |conditions-of-common_parts| replace:: {measurements.conditions("common_parts")}
.. |conditions-of-rounded| replace:: {measurements.conditions("rounded")}
.. |conditions-of-signed_distance| replace:: {measurements.conditions("signed_distance")}
.. |conditions-of-signed_distance_peers| replace:: {measurements.conditions("signed_distance_peers")}
.. |conditions-of-growth| replace:: {measurements.conditions("growth")}
.. |conditions-of-any_dimension| replace:: {measurements.conditions("any_dimension")}
.. |conditions-of-enclosing| replace:: {measurements.conditions("enclosing")}
.. |conditions-of-monte_carlo| replace:: {measurements.conditions("monte_carlo")}
.. |conditions-of-hoomd_monte_carlo| replace:: {measurements.conditions("hoomd_monte_carlo")}
.. |conditions-of-public_monte_carlo| replace:: {measurements.conditions("public_monte_carlo")}
.. |conditions-of-factored| replace:: {measurements.conditions("factored")}
.. |conditions-of-shapes| replace:: {measurements.conditions("shapes")}
.. |conditions-of-arrays| replace:: {measurements.conditions("arrays")}
.. |conditions-of-bodies| replace:: {measurements.conditions("bodies")}
.. |conditions-of-calls| replace:: {measurements.conditions("calls")}
.. |conditions-of-samples| replace:: {measurements.conditions("samples")}
.. |conditions-of-sizes| replace:: {measurements.conditions("sizes")}
.. |conditions-of-gpu| replace:: {measurements.conditions("gpu")}
.. |conditions-of-files| replace:: {measurements.conditions("files")}
"""

breathe_default_project = "c"
breathe_domain_by_extension = {"h": "c", "hpp": "cpp"}
breathe_show_include = False

autodoc_typehints = "signature"
# Names of types that signatures show as they are; the page of Python's reference says what they are.
PYTHON_TYPES = ["ArrayLike", "Floats", "Ints", "NDArray"]
autodoc_type_aliases = {name: name for name in PYTHON_TYPES}
# Pages of pypw85.torch need its texts only.
autodoc_mock_imports = ["torch"]
autodoc_member_order = "bysource"
napoleon_use_rtype = False
napoleon_use_param = False

html_theme = "furo"
pygments_style = "code_colours.Light"
pygments_dark_style = "code_colours.Dark"
html_title = "pw85"
# The second folder is that of what is compiled for the interactive page.
html_static_path = ["_static", os.environ["PW85_DOCS_BUILT"]]
html_css_files = ["pw85.css"]
html_show_copyright = False
html_copy_source = False
html_favicon = "_static/favicon.svg"
copybutton_prompt_text = r">>> |\.\.\. |\$ "
copybutton_prompt_is_regexp = True

# Formulas are typeset by KaTeX from the system, copied into the pages so that they need no network; where it is not
# installed, by MathJax from its servers.
katex = Path("/usr/share/javascript/katex")
if katex.is_dir():
    html_static_path += [str(katex)]
    html_css_files += ["katex.min.css"]
    mathjax_path = "katex.min.js"
    mathjax_options = {"defer": "defer"}
    html_js_files = [("typeset.js", {"defer": "defer"})]


def escape_bars(app, what, name, obj, options, lines):
    """|x| in docstrings is a length, not a substitution."""
    lines[:] = [line if line.lstrip().startswith((">>>", "...")) else line.replace("|", "\\|") for line in lines]


def link_names(app, what, name, obj, options, lines):
    """Names of the package in docstrings, as types (*System*) or as code (`System`), refer to their texts."""
    import pypw85

    def link(match):
        known = match[2] in pypw85.__all__
        return f":py:obj:`{match[2]} <pypw85.{match[2]}>`" if known else match[0]

    lines[:] = [re.sub(r"(?<![\w*`:])([*`])(?:pypw85\.)?(\w+)\1(?![\w*`])", link, line) for line in lines]


def link_types(app, env, node, contents):
    """Names of types in signatures lead to where they are explained."""
    if node.get("reftype") == "class" and node["reftarget"] in PYTHON_TYPES:
        return make_refnode(app.builder, node["refdoc"], "api/python", "python-types", contents)
    return None


def without_overloads(app):
    """A function has one entry for numbers and arrays, as its text has."""
    importlib.import_module("pypw85.legacy")
    for name, module in list(sys.modules.items()):
        if name.startswith("pypw85.") and module.__file__.endswith(".py"):
            analyzer = ModuleAnalyzer.for_module(name)
            analyzer.analyze()
            analyzer.overloads.clear()


def no_constructor(app, what, name, obj, options, signature, returned):
    """An enumeration is not made by calling it."""
    return (None, None) if isinstance(obj, enum.EnumMeta) else None


def setup(app):
    app.connect("autodoc-process-signature", no_constructor)
    app.connect("builder-inited", without_overloads)
    app.connect("missing-reference", link_types)
    app.connect("autodoc-process-docstring", escape_bars)
    app.connect("autodoc-process-docstring", link_names)
