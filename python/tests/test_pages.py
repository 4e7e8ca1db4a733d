# SPDX-License-Identifier: BSD-3-Clause
"""The page on the command, and the notebooks, do what they show."""

import gzip
import os
import pathlib
import re
import shutil
import subprocess
import sys

import pytest

SOURCE = pathlib.Path(os.environ["PYPW85_SOURCE"])
NOTEBOOKS = sorted((SOURCE / "examples" / "notebooks").glob("*.ipynb"))


def run_session(page, folder):
    """Runs the commands of a page in a folder, and returns what they printed."""
    (folder / "bin").mkdir()
    (folder / "bin" / "pw85").write_text(f'#!/bin/sh\nexec {sys.executable} -m pypw85.cli "$@"\n')
    (folder / "bin" / "pw85").chmod(0o755)
    environment = {**os.environ, "PATH": f"{folder / 'bin'}:{os.environ['PATH']}"}
    return subprocess.run(["sh", SOURCE / "docs" / page / "session.sh"], cwd=folder, env=environment, capture_output=True, encoding="utf-8")


def test_session(tmp_path):
    """The commands of the page print what it shows, and write what they say."""
    shutil.copy(SOURCE / "docs" / "command" / "grains.xyz", tmp_path)
    done = run_session("command", tmp_path)
    assert done.stdout == (SOURCE / "docs" / "command" / "session.out").read_text(encoding="utf-8"), done.stderr
    written = {path.name for path in tmp_path.iterdir() if path.is_file()} - {"grains.xyz"}
    assert written == {"contacts.csv", "grains.png", "grains.html", "grains.gsd", "apart.data", "packing.data",
                       "packing.vtk", "packing.png", "run.h5", "run.png", "saturated.h5", "saturated.svg", "slit.h5",
                       "sticky.h5"}  # fmt: skip


def test_upgrading(tmp_path):
    """A table and a run of 3.0 are refused, and can be used, as the page on upgrading says."""
    shutil.copy(SOURCE / "docs" / "upgrading" / "grains.csv", tmp_path)
    (tmp_path / "run.h5").write_bytes(gzip.decompress((SOURCE / "docs" / "upgrading" / "run.h5.gz").read_bytes()))
    done = run_session("upgrading", tmp_path)
    assert re.findall(r"^status \d+$", done.stdout, re.MULTILINE) == ["status 2", "status 1", "status 2"]  # 1: there are overlaps
    assert "leave it out (--ignore-columns tilt)" in done.stderr and "is a run of pypw85 3.0.0" in done.stderr
    assert done.stdout.endswith("no overlaps after 400 sweeps\n") and done.returncode == 0 and (tmp_path / "continued.h5").exists()


def test_there_are_three_notebooks():
    assert len(NOTEBOOKS) == 3


def texts_and_pictures(notebook):
    """Of each cell what it prints and its value, and how many pictures there are. What stands for a picture is no text."""
    texts, pictures = [], 0
    for cell in notebook.cells:
        outputs = [output for output in cell.get("outputs", []) if output.get("name") != "stderr"]
        shown = [output for output in outputs if "image/png" in output.get("data", {})]
        text = "".join(o.get("text") or o["data"]["text/plain"] for o in outputs if o not in shown)
        texts.append(re.sub(r"np\.\w+\((.*?)\)", r"\1", text))  # NumPy 2 shows the type of a number
        pictures += len(shown)
    return texts, pictures


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_notebooks(path):
    """They are committed with what they show: pictures, and the very same text."""
    nbclient = pytest.importorskip("nbclient")
    nbformat = pytest.importorskip("nbformat")
    notebook = nbformat.read(path, as_version=4)
    committed = texts_and_pictures(notebook)
    nbclient.NotebookClient(notebook, timeout=300, kernel_name="python3",
                            resources={"metadata": {"path": str(path.parent)}}).execute()  # fmt: skip
    assert texts_and_pictures(notebook) == committed
    assert committed[1] >= 1 and path.stat().st_size < 300_000
