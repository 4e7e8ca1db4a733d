# SPDX-License-Identifier: BSD-3-Clause
"""Writes what an installation by Meson says of the package: a folder pypw85-VERSION.dist-info, from pyproject.toml, so that
importlib.metadata and pip know the package and its version. A wheel has its own, by meson-python.

Usage: dist_info.py PYPROJECT VERSION OUTPUT...           OUTPUT are METADATA, entry_points.txt and INSTALLER, in any folder
"""

import sys
import tomllib
from pathlib import Path


def metadata(project, version, readme):
    """METADATA, version 2.1 of the core metadata (PEP 566)."""
    lines = [
        "Metadata-Version: 2.1",
        f"Name: {project['name']}",
        f"Version: {version}",
        f"Summary: {project['description']}",
        f"Author: {', '.join(author['name'] for author in project['authors'])}",
        f"Keywords: {','.join(project['keywords'])}",
        *(f"Classifier: {classifier}" for classifier in project["classifiers"]),
        *(f"Project-URL: {label}, {address}" for label, address in project["urls"].items()),
        f"Requires-Python: {project['requires-python'].replace(' ', '')}",
        *(f"Requires-Dist: {requirement}" for requirement in project["dependencies"]),
    ]
    for extra, requirements in project["optional-dependencies"].items():
        lines += [f"Provides-Extra: {extra}", *(f'Requires-Dist: {requirement}; extra == "{extra}"' for requirement in requirements)]
    return "\n".join([*lines, "Description-Content-Type: text/markdown", "", readme])


def entry_points(project):
    return "[console_scripts]\n" + "".join(f"{name} = {function}\n" for name, function in project["scripts"].items())


def main():
    pyproject, version, *outputs = sys.argv[1:]
    project = tomllib.loads(Path(pyproject).read_text(encoding="utf-8"))["project"]
    readme = (Path(pyproject).parent / project["readme"]).read_text(encoding="utf-8")
    texts = {"METADATA": metadata(project, version, readme), "entry_points.txt": entry_points(project), "INSTALLER": "meson\n"}
    for output in map(Path, outputs):
        output.write_text(texts[output.name], encoding="utf-8")


main()
