"""Completes the theme furo as Debian packages it: unbundled, so that its script is a module where a plain script is loaded, and
its stylesheet imports another by an address of Debian's web server, and lacks the colours for readers who prefer dark pages,
which the compiler of the stylesheet dropped. Other furo packages have all of this, and stay as they are."""

import re
from pathlib import Path

IMPORT = 'import Gumshoe from "./gumshoe-patched.js";'
NORMALIZE = "@import url(/javascript/normalize.css/normalize.css);"


DARK = re.compile(r"^@media not print \{\n(?P<rules>  body\[data-theme=\"dark\"\] \{.*?)\}\n\n", re.MULTILINE | re.DOTALL)


def bundle(path, reference, text_of):
    """Puts a text in the place of the reference to it, where there is one."""
    text = path.read_text(encoding="utf-8")
    if reference in text:
        path.write_text(text.replace(reference, text_of.read_text(encoding="utf-8")), encoding="utf-8")


def add_preferred_dark(path):
    """The colours of chosen dark pages, for who prefers dark ones and has not chosen light ones."""
    text = path.read_text(encoding="utf-8")
    if "prefers-color-scheme" in text:
        return
    rules = DARK.search(text)["rules"].replace('[data-theme="dark"]', ':not([data-theme="light"])')
    path.write_text(f"{text}\n@media screen and (prefers-color-scheme: dark) {{\n{rules}}}\n", encoding="utf-8")


def complete(app, exception):
    static = Path(app.outdir) / "_static"
    if exception or app.builder.format != "html":
        return
    bundle(static / "scripts/furo.js", IMPORT, static / "scripts/gumshoe-patched.js")
    bundle(static / "styles/furo.css", NORMALIZE, Path("/usr/share/javascript/normalize.css/normalize.css"))
    add_preferred_dark(static / "styles/furo.css")


def setup(app):
    app.connect("build-finished", complete)
    return {"parallel_read_safe": True}
