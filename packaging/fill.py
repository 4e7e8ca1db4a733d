"""Writes the recipes with the version of meson.build and the addresses of address.toml. Usage: fill.py FOLDER"""

import re
import sys
import tomllib
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "scripts"))
from release_notes import version_of_sources  # noqa: E402

RECIPES = ["conda-forge", "vcpkg", "conan", "spack", "wrapdb", "oss-fuzz", "cran", "octave", "npm", "crates-io"]


def addresses():
    return tomllib.loads((HERE / "address.toml").read_text(encoding="utf-8"))


def date_of_sources():
    """The day of this version, as the package for Octave states it."""
    return re.search(r"^Date: (.*)$", (HERE.parent / "octave/DESCRIPTION").read_text(encoding="utf-8"), re.MULTILINE)[1]


def filled(text, words):
    """The text with each @WORD@ replaced. A line with @MAINTAINERS@ is repeated for each of them."""
    lines = []
    for line in text.splitlines():
        repeated = words["maintainers"] if "@MAINTAINERS@" in line else [""]
        lines += [line.replace("@MAINTAINERS@", name) for name in repeated]
    # The archive and its folder contain the version, which is replaced last.
    text = "\n".join([*lines, ""])
    for name, value in words.items():
        if name != "maintainers":
            text = text.replace(f"@{name.upper()}@", value)
    return text.replace("@VERSION@", version_of_sources()).replace("@DATE@", date_of_sources())


def write(folder, words):
    for recipe in RECIPES:
        for path in sorted((HERE / recipe).rglob("*")):
            if path.is_file() and "__pycache__" not in path.parts:
                target = Path(folder) / path.relative_to(HERE)
                target.parent.mkdir(parents=True, exist_ok=True)
                target.write_text(filled(path.read_text(encoding="utf-8"), words), encoding="utf-8")


def main():
    words = addresses()
    missing = [name for name, value in words.items() if not value]
    if missing:
        sys.exit(f"packaging/address.toml lacks {', '.join(missing)}")
    write(sys.argv[1], words)


if __name__ == "__main__":
    main()
