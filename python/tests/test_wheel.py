"""The wheel: built offline from a copy of the sources, installed somewhere else, used from there."""

import os
import pathlib
import shutil
import subprocess
import sys

import pytest

SOURCE = pathlib.Path(os.environ["PYPW85_SOURCE"])


def run(*command, **kwargs):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **kwargs)
    assert done.returncode == 0, done.stdout
    return done.stdout


@pytest.fixture(scope="module")
def installed(tmp_path_factory):
    copy = tmp_path_factory.mktemp("source") / "pw85"
    shutil.copytree(SOURCE, copy, ignore=shutil.ignore_patterns(".git", "build*", ".mesonpy*", "__pycache__"))
    target = tmp_path_factory.mktemp("target")
    pip = [sys.executable, "-m", "pip", "--no-cache-dir", "--disable-pip-version-check", "install", "--no-index"]
    run(*pip, "--no-build-isolation", "--no-deps", "--target", str(target), str(copy))
    return target


def test_content(installed):
    """The package and nothing else, with stubs."""
    names = {path.name for path in installed.iterdir()}
    version = run(sys.executable, "-c", "import pypw85; print(pypw85.version())").strip()
    assert names == {"pypw85", f"pypw85-{version}.dist-info"}
    files = {path.name for path in (installed / "pypw85").iterdir()}
    assert {"__init__.py", "legacy.py", "gufuncs.py", "_core.pyi", "py.typed"} <= files
    assert not any(name.startswith("libpw85") for name in files)


def test_no_shared_library_of_ours(installed):
    if shutil.which("ldd") is None:
        pytest.skip("no ldd")
    (extension,) = (installed / "pypw85").glob("_core*.so")
    libraries = run("ldd", str(extension))
    assert "not found" not in libraries
    assert "pw85" not in libraries.replace(str(extension), "")


def test_use(installed, tmp_path):
    program = "import pypw85; print(pypw85.__file__); print(pypw85.contact([2, 0, 0], *[[1, 0, 0, 1, 0, 1]] * 2)[0])"
    environment = {**os.environ, "PYTHONPATH": str(installed)}
    where, mu2 = run(sys.executable, "-c", program, cwd=tmp_path, env=environment).split()
    assert pathlib.Path(where).is_relative_to(installed)
    assert float(mu2) == 1
