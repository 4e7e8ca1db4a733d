# SPDX-License-Identifier: BSD-3-Clause
"""The interpreter that Meson builds the package for."""

import json
import os
import pathlib
import subprocess
import venv

import pytest

SOURCE = os.environ["PYPW85_SOURCE"]
ONLY_PYTHON = [f"-D{name}=disabled" for name in ("tests", "bench", "fortran", "docs", "gpu", "openmp", "simd")]
CROSS_FILE = """
[binaries]
c = 'cc'
cpp = 'c++'
ar = 'ar'
pkgconfig = 'pkg-config'
[properties]
needs_exe_wrapper = true
[host_machine]
system = 'linux'
cpu_family = 'x86_64'
cpu = 'other'
endian = 'little'
"""


def meson_setup(folder, *options, path=()):
    """Status and output of `meson setup`."""
    search = os.pathsep.join([*map(str, path), "/usr/local/bin", "/usr/bin", "/bin"])
    environment = {key: value for key, value in os.environ.items() if key not in ("PYTHONPATH", "VIRTUAL_ENV")}
    command = ["meson", "setup", folder, SOURCE, *ONLY_PYTHON, *options]
    done = subprocess.run(command, env={**environment, "PATH": search},
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return done.returncode, done.stdout


def extension(folder):
    targets = json.loads((folder / "meson-info" / "intro-targets.json").read_text())
    return [target for target in targets if target["name"].startswith("_core")]


@pytest.fixture
def make_venv(tmp_path):
    def make(name, **options):
        venv.create(tmp_path / name, with_pip=False, **options)
        return tmp_path / name / "bin"

    return make


def test_active_virtual_environment(tmp_path, make_venv):
    path = [make_venv("env", system_site_packages=True)]
    status, output = meson_setup(tmp_path / "build", "-Dpython=enabled", path=path)
    assert status == 0, output
    assert f"Program python3 (numpy) found: YES ({tmp_path / 'env' / 'bin' / 'python3'})" in output
    assert "/usr/bin/python3" not in output
    assert extension(tmp_path / "build")


def make_foreign(folder):
    """A folder with a python3 that is none of the system, as that of pyenv, and lacks NumPy. It comes first on the path."""
    folder.mkdir()
    (folder / "python3").write_text('#!/bin/sh\nexec /usr/bin/python3 -S "$@"\n')
    (folder / "python3").chmod(0o755)
    return folder


def test_interpreter_that_is_asked_for(tmp_path, make_venv):
    """It is taken even if another one comes first on the path, and no other one takes its place."""
    path = [make_foreign(tmp_path / "bin")]
    wanted = make_venv("env", system_site_packages=True) / "python3"
    status, output = meson_setup(tmp_path / "build", "-Dpython=enabled", f"-Dpython_interpreter={wanted}", path=path)
    assert status == 0, output
    assert f"Program {wanted} (numpy) found: YES ({wanted})" in output
    assert extension(tmp_path / "build")
    status, output = meson_setup(tmp_path / "without", "-Dpython=enabled", f"-Dpython_interpreter={path[0] / 'python3'}")
    assert status != 0 and "numpy" in output


def test_active_environment_of_conda(tmp_path, monkeypatch):
    """Its Python is the base of nothing else; what CONDA_PREFIX names was made active on purpose."""
    path = [make_foreign(tmp_path / "bin")]
    monkeypatch.setenv("CONDA_PREFIX", "/usr")  # where the foreign one is
    status, output = meson_setup(tmp_path / "build", "-Dpython=enabled", path=path)
    assert status != 0 and "numpy" in output


def test_virtual_environment_without_numpy(tmp_path, make_venv):
    """It was made active on purpose: another interpreter would not be what is wanted."""
    path = [make_venv("env")]
    status, output = meson_setup(tmp_path / "enabled", "-Dpython=enabled", path=path)
    assert status != 0 and "numpy" in output
    status, output = meson_setup(tmp_path / "auto", "-Dpython=auto", path=path)
    assert status == 0, output
    assert not extension(tmp_path / "auto")


def test_other_interpreter_without_numpy(tmp_path):
    """One that just happens to be first on the path does not hide Debian's."""
    if not pathlib.Path("/usr/bin/python3").exists():
        pytest.skip("no /usr/bin/python3")
    path = [make_foreign(tmp_path / "bin")]
    status, output = meson_setup(tmp_path / "build", "-Dpython=enabled", path=path)
    assert status == 0, output
    assert "Program /usr/bin/python3 (numpy) found: YES" in output


def test_cross_compilation(tmp_path):
    cross_file = tmp_path / "cross.ini"
    cross_file.write_text(CROSS_FILE)
    status, output = meson_setup(tmp_path / "auto", f"--cross-file={cross_file}")
    assert status == 0, output
    assert not extension(tmp_path / "auto")
    status, output = meson_setup(tmp_path / "enabled", "-Dpython=enabled", f"--cross-file={cross_file}")
    assert status != 0 and "cannot be cross compiled" in output
