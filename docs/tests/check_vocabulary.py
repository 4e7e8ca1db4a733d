"""Whether manual, contracts, comments and messages use the field's terms and plain English: the rules of docs/vocabulary.toml.

Usage: check_vocabulary.py SOURCE [--counts], which prints how often each rule is broken in each area instead of failing.
"""

import ast
import io
import re
import sys
import tokenize
import tomllib
from collections import Counter
from pathlib import Path

FOLDERS = ("bench", "data", "examples", "include", "lammps", "python", "r", "src", "tests")
AREAS = {
    "manual": ("README.md", "CONTRIBUTING.md", "docs/lammps.md", "docs/**/*.rst", *(f"{folder}/**/README.md" for folder in FOLDERS)),
    "contracts": ("include/*.h",),
    "headers": ("include/pw85/**/*.h*",),
    "sources": ("src/**/*.[ch]pp", "lammps/*.[ch]pp"),
    "python": ("python/pypw85/**/*.py",),
    "messages": ("python/pypw85/**/*.py", "lammps/*.[ch]pp", "api/causes.py", "include/pw85/status.h"),
}
COMMENT = re.compile(r"//[/!]?<?(?P<line>[^\n]*)|/\*[*!]?<?(?P<block>.*?)\*/|(?P<string>\"(?:\\.|[^\"\\\n])*\")", re.DOTALL)


def of_manual(text):
    """Paragraphs outside of code: (first line, text)."""
    text = re.sub(r"^```\w.*?^```", blanked, text, flags=re.MULTILINE | re.DOTALL)
    text = re.sub(r"^( *)\.\. (?:code-block|literalinclude|math|index|highlight|measured-table)::.*?(?=^\1\S)", blanked, text + "\n",
                  flags=re.MULTILINE | re.DOTALL)
    text = re.sub(r"``.*?``|`[^`\n]*`", lambda code: "`" + re.sub(r"[^\n]", "x", code[0])[1:], text, flags=re.DOTALL)
    yield from paragraphs(text, 1)


def blanked(found):
    return "\n" * found[0].count("\n")


def paragraphs(text, line):
    for paragraph in re.split(r"(\n\s*\n)", text):
        if paragraph.strip():
            yield line, paragraph
        line += paragraph.count("\n")


def of_c(text):
    """Comments, those of neighbouring lines as one: (first line, text, whether it is a string)."""
    begin, lines, last = 0, [], -1
    for found in COMMENT.finditer(text):
        line = text.count("\n", 0, found.start()) + 1
        if found["string"] is not None:
            yield line, found["string"][1:-1], True
            continue
        if found["block"] is not None:
            for first, paragraph in paragraphs(re.sub(r"^[ \t]*\*", "", found["block"], flags=re.MULTILINE), line):
                yield first, paragraph, False
            continue
        is_title = text[found.start():found.start() + 3] == "///"
        if line != last + 1 or text[:found.start()].rpartition("\n")[2].strip():
            if lines:
                yield begin, "\n".join(lines), False
            begin, lines = line, []
        lines.append(("¶" if is_title and not lines else "") + found["line"])
        last = line
    if lines:
        yield begin, "\n".join(lines), False


def of_python(text):
    """Comments, docstrings and other strings: (first line, text, whether it is a message)."""
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.COMMENT:
            yield token.start[0], token.string[1:], False
    tree = ast.parse(re.sub(r"import \(\n *#@.*\n\)", "import (made\n\n)", text))  # the build writes the names of gufuncs.in.py
    parents = (ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)
    bodies = [node.body[0] for node in ast.walk(tree) if isinstance(node, parents) and node.body]
    docstrings = {id(first.value) for first in bodies if isinstance(first, ast.Expr) and isinstance(first.value, ast.Constant)}
    joined = {id(part) for node in ast.walk(tree) if isinstance(node, ast.JoinedStr) for part in node.values}
    for node in ast.walk(tree):
        if isinstance(node, ast.JoinedStr):
            yield node.lineno, "".join(part.value if isinstance(part, ast.Constant) else "…" for part in node.values), True
        elif isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in joined:
            if id(node) in docstrings:
                for first, paragraph in paragraphs(node.value, node.lineno):
                    yield first, ("¶" if first == node.lineno else "") + paragraph, False
            elif " " in node.value:
                yield node.lineno, node.value, True


def texts(area, path, text):
    if area == "manual":
        return of_manual(text)
    pieces = of_python(text) if path.suffix == ".py" else of_c(text)
    return ((line, piece) for line, piece, is_message in pieces if is_message == (area == "messages"))


def findings(source, rules):
    """(rule, area, file, line, text found) of each place where a rule is broken."""
    for area, globs in AREAS.items():
        for path in sorted({path for glob in globs for path in source.glob(glob)}):
            for line, piece in texts(area, path, path.read_text(encoding="utf-8")):
                flat = re.sub(r"\s", " ", piece)
                squeezed = re.sub(r"(?<= ) ", "", flat) if "  " in flat else flat
                for rule in rules:
                    for found in rule["compiled"].finditer(squeezed):
                        yield rule, area, str(path.relative_to(source)), line + line_of(piece, squeezed, found), found[0], squeezed


def line_of(piece, squeezed, found):
    """The line of the text, from 0, in which a finding begins."""
    words = len(re.findall(r"\S+", squeezed[: found.start() + 1])) - 1
    starts = [start.start() for start in re.finditer(r"\S+", piece)]
    return piece.count("\n", 0, starts[max(words, 0)]) if starts else 0


def main():
    source = Path(sys.argv[1])
    here = Path(__file__).resolve().parents[1] / "vocabulary.toml"
    vocabulary = tomllib.loads(here.read_text(encoding="utf-8"))
    rules = vocabulary["rule"]
    for rule in rules:
        rule["compiled"] = re.compile(rule["words"], 0 if rule.get("case") else re.IGNORECASE)
    counts, wrong, used = Counter(), [], Counter()
    for rule, area, file, line, found, text in findings(source, rules):
        excepted = [one for one in rule.get("except", {}) if re.search(one, text)]
        if excepted:
            used.update(excepted)
            continue
        counts[rule["name"], area] += 1
        if area in rule["areas"]:
            wrong.append(f"{file}:{line}: “{found}”: {rule['instead']} ({rule['name']})")
    if sys.argv[2:] == ["--counts"]:
        print(f"{'':32}" + "".join(f"{area:>11}" for area in AREAS))
        for rule in rules:
            row = [counts[rule["name"], area] for area in AREAS]
            print(f"{rule['name']:32}" + "".join(f"{number:11}" for number in row))
        return 0
    unused = [one for rule in rules for one in rule.get("except", {}) if not used[one]]
    print("\n".join([*wrong, *(f"docs/vocabulary.toml: the exception {one} has nothing left to except" for one in unused)]))
    return 1 if wrong or unused else 0


sys.exit(main())
