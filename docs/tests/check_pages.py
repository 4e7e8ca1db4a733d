"""Checks the built pages, in the Test Anything Protocol. Usage: check_pages.py WORDS HTML

- links: everything that a page refers to within the pages exists;
- formulas: KaTeX can typeset them all (skipped without Node.js and KaTeX);
- spelling: hunspell with a British dictionary and our own list knows every word of prose (skipped without it);
- marks: no page shows a mark with which docs/doxygen_filter.py keeps words from becoming links;
- listings: no line of code is longer than what a page shows without scrolling (what programs print may be);
- contrast: the colours of code are far enough from what is behind them;
- browser: what browser.py says (skipped without Chromium and Selenium). Screenshots, if it takes any, are put next to HTML.
"""

import importlib.util
import json
import re
import shutil
import subprocess
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urldefrag

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "api"))
from declarations import functions
from public_headers import C_HEADERS

KATEX = Path("/usr/share/javascript/katex/katex.js")
TYPESET = """
const katex = require(process.argv[1]);
for (const [page, formula] of JSON.parse(require("fs").readFileSync(0, "utf-8")))
    try { katex.renderToString(formula, {displayMode: true}); } catch (error) { console.log(`${page}: ${error.message}`); }
"""
LONGEST_LINE = 88
LEAST_CONTRAST = 4.5  # level AA of WCAG 2.1
PRINTED = {"highlight-none", "highlight-text"}  # what programs print
# What a search must find first: the chapter for its own word, then functions, and a sentence that says no where there is nothing.
SEARCHES = {
    "changelog": "changelog.html",
    "closest approach": "closest_approach.html",
    "containment": "containment.html",
    "contains": "containment.html",
    "curvature": "curvature.html",
    "distance": "distance.html",
    "euler angles": "tasks/euler.html",
    "event chain": "montecarlo.html",
    "forces": "forces.html",
    "GPU": "gpu.html",
    "hard ellipsoids": "montecarlo.html",
    "hertz": "curvature.html",
    "inertia": "bodies.html",
    "JavaScript": "api/javascript.html",
    "LAMMPS": "lammps.html",
    "license": "installation.html",
    "MATLAB": "api/octave.html",
    "mesh": "meshes.html",
    "minimum image": "glossary.html#term-minimum-image",
    "Monte Carlo": "montecarlo.html",
    "neighbors": "neighbors.html",
    "neighbour list": "neighbors.html",
    "NaN": "errors.html",
    "overlap": "#c.pw85_overlap",
    "packing": "tasks/relax.html",
    "performance": "performance.html",
    "periodic": "tasks/periodic.html",
    "pip": "installation.html",
    "quaternion": "#c.pw85_ellipsoid_quaternion",
    "relax": "tasks/relax.html",
    "Rust": "api/rust.html",
    "threads": "batch.html",
    "torque": "#c.pw85_contact_torque",
    "Windows": "installation.html",
    **dict.fromkeys(
        ["AMD GPU", "collision", "conda", "DEM", "Gay-Berne", "Julia", "molecular dynamics", "superellipsoid"],
        "limits.html",
    ),
}
VOID = {"area", "base", "br", "col", "embed", "hr", "img", "input", "link", "meta", "source", "track", "wbr"}
NOT_PROSE = {"script", "style", "code", "pre", "svg", "dt", "head"}
NOT_PROSE_CLASSES = {"math", "toc-drawer", "sidebar-drawer", "citation", "label", "related-pages", "reference"}


class Page(HTMLParser):
    """Identifiers, references, formulas and prose of a page."""

    def __init__(self, path):
        super().__init__()
        self.path, self.ids, self.references, self.formulas, self.prose = path, set(), [], [], []
        self.listings, self.in_listing, self.language = [], False, ""
        self.open = []  # (tag, whether it is prose, whether it is a formula)
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        if "id" in attributes:
            self.ids.add(attributes["id"])
        self.references += [attributes[name] for name in ("href", "src") if attributes.get(name)]
        if tag in VOID:
            return
        classes = set((attributes.get("class") or "").split())
        self.language = next((name for name in classes if name.startswith("highlight-")), self.language)
        if tag == "pre" and self.language not in PRINTED:
            self.listings.append("")
            self.in_listing = True
        prose = (self.open[-1][1] if self.open else True) and tag not in NOT_PROSE and not classes & NOT_PROSE_CLASSES
        self.open.append((tag, prose, "math" in classes))
        if "math" in classes:
            self.formulas.append("")

    def handle_endtag(self, tag):
        self.in_listing = self.in_listing and tag != "pre"
        while self.open and self.open.pop()[0] != tag:
            pass

    def handle_data(self, data):
        if self.in_listing:
            self.listings[-1] += data
        if any(formula for _, _, formula in self.open):
            self.formulas[-1] += data
        elif self.open and self.open[-1][1]:
            self.prose.append(data)


def check_links(pages):
    for page in pages.values():
        for reference in page.references:
            if re.match(r"[a-z]+:", reference):
                continue
            path, fragment = urldefrag(reference)
            path = path.partition("?")[0]
            target = (page.path.parent / unquote(path)).resolve() if path else page.path
            if not target.exists():
                yield f"{page.path}: {reference} does not exist"
            elif fragment and target in pages and unquote(fragment) not in pages[target].ids:
                yield f"{page.path}: nothing is called {reference}"


def check_formulas(pages):
    formulas = [
        [str(page.path), re.sub(r"^(\(\d+\))?.?\\[(\[]|\\[)\]]$", "", formula.strip(), flags=re.DOTALL)]
        for page in pages.values()
        for formula in page.formulas
    ]
    done = subprocess.run(
        ["node", "-e", TYPESET, KATEX],
        input=json.dumps(formulas),
        check=True,
        stdout=subprocess.PIPE,
        encoding="utf-8",
    )
    yield from done.stdout.splitlines()


def words_of_prose(page):
    """Names have digits, underscores, dots, or capitals inside, or are not written in Latin letters."""
    tokens = re.findall(r"[^\s/()\[\]{},;:\"“”–—…=]+", " ".join(page.prose).replace("’", "'"))
    candidates = {token.strip(".'!?*‘-") for token in tokens}
    return {word for word in candidates if re.fullmatch(r"[A-Z]?[a-zé'-]+", word)}


def parts_of(words):
    """Words, and the parts of those with a hyphen: hunspell names the part that it does not know."""
    return words | {part for word in words for part in word.split("-")}


def check_spelling(pages, words):
    prose = {page.path: words_of_prose(page) for page in pages.values()}
    done = subprocess.run(
        ["hunspell", "-l", "-d", "en_GB", "-i", "utf-8"],
        input="\n".join(sorted(set().union(*prose.values()))),
        check=True,
        stdout=subprocess.PIPE,
        encoding="utf-8",
    )
    unknown = set(done.stdout.split()) - words
    yield from (f"{path}: {word}" for path, found in prose.items() for word in sorted(unknown & parts_of(found)))


def check_marks(pages):
    for page in pages.values():
        yield from (f"{page.path}: {word}" for word in re.findall(r"%[A-Za-z]\w*", " ".join(page.prose)))


def check_listings(pages):
    for page in pages.values():
        for listing in page.listings:
            long = [line for line in listing.splitlines() if len(line) > LONGEST_LINE]
            yield from (f"{page.path}: {len(line)} columns: {line}" for line in long)


def luminance(colour):
    """The relative luminance of a colour as #rrggbb or #rgb, as WCAG 2.1 defines it."""
    digits = colour.lstrip("#")
    digits = "".join(2 * digit for digit in digits) if len(digits) == 3 else digits
    channels = [int(digits[i : i + 2], 16) / 255 for i in (0, 2, 4)]
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in channels]
    return sum(weight * c for weight, c in zip((0.2126, 0.7152, 0.0722), linear, strict=True))


def contrast(one, other):
    dark, light = sorted((luminance(one), luminance(other)))
    return (light + 0.05) / (dark + 0.05)


def check_contrast(root):
    """Colours of highlighted code, for light and for dark pages; that of white space (w) shows nothing."""
    style = (root / "_static/pygments.css").read_text(encoding="utf-8")
    for theme in ("", r'body\[data-theme="dark"\] '):
        background = re.search(rf"^{theme}\.highlight {{ background: (#\w+)", style, re.MULTILINE)[1]
        rules = re.findall(rf"^{theme}\.highlight \.(\w+) {{(.*?)}}", style, re.MULTILINE)
        colours = {name: re.search(r"(?<!-)color: (#\w+)", rule) for name, rule in rules if name != "w"}
        for name, colour in colours.items():
            if colour and contrast(colour[1], background) < LEAST_CONTRAST:
                yield f"code of class {name}: {colour[1]} on {background}: {contrast(colour[1], background):.2f}"
        if len(colours) < 20:
            yield f"_static/pygments.css has {len(colours)} colours"


def states_of_pairs():
    """Some pairs of ellipsoids as the address of the interactive page has them, and the numbers that it must show: those of rows in the
    reproducible mode, as the npm package computes them."""
    import pypw85

    pypw85.set_reproducible(True)

    def state(*lists):
        axes1, turn1, axes2, turn2, r12 = lists
        q1, q2 = pypw85.ellipsoid_quaternion(axes1, turn1), pypw85.ellipsoid_quaternion(axes2, turn2)
        numbers = [*pypw85.contact([r12], q1, q2), pypw85.distance([r12], q1, q2)[0]]
        return ";".join(",".join(map(str, x)) for x in lists), [f"{float(x[0]):#.15g}" for x in numbers]

    return [
        state([3, 2, 1], [1, 0, 0, 0], [4, 1, 1], [0.9, 0.1, 0.3, 0.2], [3, 2, 1]),
        state([8, 0.1, 8], [1, 2, 3, 4], [0.1, 5, 0.1], [0.3, -0.2, 0.1, 0.9], [10, 2, 3]),
        state([1, 2, 3], [0.5, 0.5, 0.5, 0.4], [3, 2, 1], [0.1, 0.2, 0.3, 0.4], [3.5, 0.25, 4.125]),
    ]


def places_of_functions():
    """Where functions of C are found by their names, with and without prefix."""
    pages = {"pw85": "c_pair", "pw85_legacy": "c_others", "pw85_zheng": "c_others", "pw85_pre1": "c_others"}
    page_of = {header: pages.get(header.removesuffix(".h"), header.replace("pw85", "c").removesuffix(".h")) for header in C_HEADERS}
    by_name = {one.name: f"api/{page_of[header]}.html#c.{one.name}" for header in C_HEADERS for one in functions(header)}
    by_plain_name = {re.sub("^pw85_", "", name): address for name, address in by_name.items()}
    return {name: place for name, place in {**by_plain_name, **by_name}.items() if name not in SEARCHES}


def check_in_browser(pages, root):
    import browser

    names = [str(path.relative_to(root)) for path in pages]
    return browser.check(root, names, SEARCHES, places_of_functions(), states_of_pairs(), root.parent / "screenshots")


def has_browser():
    has_selenium = importlib.util.find_spec("selenium") is not None
    return has_selenium and bool(shutil.which("chromedriver")) and bool(shutil.which("chromium"))


def has_hunspell():
    if not shutil.which("hunspell"):
        return False
    return subprocess.run(["hunspell", "-l", "-d", "en_GB"], input=b"", stderr=subprocess.DEVNULL).returncode == 0


def main():
    words = set(Path(sys.argv[1]).read_text(encoding="utf-8").split())
    root = Path(sys.argv[2]).resolve()
    pages = {path.resolve(): Page(path) for path in sorted(root.rglob("*.html"))}
    ours = {path: page for path, page in pages.items() if page.path.stem not in ("genindex", "search", "py-modindex")}
    checks = [
        ("links", True, lambda: check_links(pages)),
        ("formulas", bool(shutil.which("node")) and KATEX.exists(), lambda: check_formulas(ours)),
        ("spelling", has_hunspell(), lambda: check_spelling(ours, words)),
        ("marks", True, lambda: check_marks(ours)),
        ("listings", True, lambda: check_listings(ours)),
        ("contrast", True, lambda: check_contrast(root)),
        ("browser", has_browser(), lambda: check_in_browser(ours, root)),
    ]
    print(f"1..{len(checks)}")
    for number, (name, possible, check) in enumerate(checks, 1):
        complaints = list(check()) if possible else []
        if len(ours) < 15 or not any(page.formulas for page in ours.values()):
            complaints.append("pages or formulas are missing")
        print(f"{'not ok' if complaints else 'ok'} {number} {name}{'' if possible else ' # SKIP'}")
        for complaint in complaints:
            print(f"# {complaint}")


main()
