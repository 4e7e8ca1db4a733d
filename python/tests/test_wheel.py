# SPDX-License-Identifier: BSD-3-Clause
"""The wheel: built offline from a copy of the sources, installed somewhere else, used from there."""

import email
import importlib.metadata
import os
import pathlib
import platform
import re
import shutil
import subprocess
import sys
import tomllib
import venv

import pytest

import pypw85

SOURCE = pathlib.Path(os.environ["PYPW85_SOURCE"])
PIP = [sys.executable, "-m", "pip", "--no-cache-dir", "--disable-pip-version-check", "install", "--no-index",
       "--no-build-isolation", "--no-deps"]


def run(*command, succeeds=True, **kwargs):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **kwargs)
    assert (done.returncode == 0) == succeeds, done.stdout
    return done.stdout


@pytest.fixture(scope="module")
def copy(tmp_path_factory):
    copy = tmp_path_factory.mktemp("source") / "pw85"
    made = shutil.ignore_patterns(".git", "build*", ".mesonpy*")
    shutil.copytree(SOURCE, copy, ignore=lambda folder, names: made(folder, names) if folder == str(SOURCE) else {"__pycache__"})
    return copy


@pytest.fixture(scope="module")
def installed(copy, tmp_path_factory):
    target = tmp_path_factory.mktemp("target")
    # Another python3 comes first on the path, as that of pyenv. The wheel is for the Python that runs pip.
    foreign = tmp_path_factory.mktemp("foreign")
    (foreign / "python3").write_text("#!/bin/sh\nexit 1\n")
    (foreign / "python3").chmod(0o755)
    run(*PIP, "--target", str(target), str(copy), env={**os.environ, "PATH": f"{foreign}:{os.environ['PATH']}"})
    return target


@pytest.fixture(scope="module")
def information(installed):
    return installed / f"pypw85-{pypw85.version()}.dist-info"


def names(folder):
    return {path.relative_to(folder) for path in folder.rglob("*") if path.is_file()}


def test_content(installed, information):
    """The package and nothing else, with stubs and licence."""
    assert {path.name for path in installed.iterdir()} == {"bin", "pypw85", information.name}
    assert [path.name for path in (installed / "bin").iterdir()] == ["pw85"]
    files = names(installed / "pypw85")
    source = SOURCE / "python" / "pypw85"
    sources = {name for name in names(source) if name.suffix in (".py", ".pyi", ".typed", ".html")}
    modules = {name.with_name(name.name.replace(".in.", ".")) for name in sources}  # templates are modules when they are made
    assert modules | {pathlib.Path("py.typed")} <= files
    assert not any(path.name.startswith("libpw85") for path in files)
    if pathlib.Path("/usr/share/javascript/three/build/three.min.js").is_file():
        assert {pathlib.Path("three/three.min.js"), pathlib.Path("three/OrbitControls.js")} <= files
    assert (information / "LICENSE").read_bytes() == (SOURCE / "LICENSE").read_bytes()


def test_licence(installed):
    """Nothing of the GNU Scientific Library, so that the licence is the one that the wheel states."""
    [extension] = (installed / "pypw85").glob("_core*.so")
    assert b"gsl_" not in extension.read_bytes()


def test_metadata(information):
    metadata = email.message_from_bytes((information / "METADATA").read_bytes())
    assert metadata["Name"] == "pypw85"
    assert metadata["Version"] == pypw85.metadata["version"]
    assert metadata["Summary"] == pypw85.metadata["description"]
    assert metadata["Author"] == pypw85.metadata["author"]
    assert "License :: OSI Approved :: BSD License" in metadata.get_all("Classifier")
    assert metadata["Description-Content-Type"] == "text/markdown"
    readme = metadata.get_payload(decode=True).decode("utf-8")
    assert readme.strip() == (SOURCE / "README.md").read_text(encoding="utf-8").strip()


def test_metadata_of_an_installation_by_meson(information, tmp_path):
    """It says what the wheel says."""
    outputs = [tmp_path / "METADATA", tmp_path / "entry_points.txt", tmp_path / "INSTALLER"]
    run(sys.executable, str(SOURCE / "python/dist_info.py"), str(SOURCE / "pyproject.toml"), pypw85.version(), *map(str, outputs))

    def fields(path):
        message = email.message_from_bytes(path.read_bytes())
        plain = sorted((name, re.sub(r"[\s'\",]", "", value)) for name, value in message.items())
        return [(name, value) for name, value in plain if not name.startswith(("License", "Metadata-Version"))], message.get_payload()

    assert fields(outputs[0]) == fields(information / "METADATA")
    assert outputs[1].read_text().split() == (information / "entry_points.txt").read_text().split()


def test_versions_of_python():
    """Those of the classifiers are those for which cibuildwheel builds, without a gap from the oldest that is allowed."""
    project = tomllib.loads((SOURCE / "pyproject.toml").read_text(encoding="utf-8"))
    minors = [int(minor) for minor in re.findall(r"Python :: 3\.(\d+)", "\n".join(project["project"]["classifiers"]))]
    assert minors == list(range(11, minors[-1] + 1))
    assert project["tool"]["cibuildwheel"]["build"].split() == [f"cp3{minor}-*" for minor in minors]
    assert project["project"]["requires-python"] == ">= 3.11"
    assert project["tool"]["ruff"]["target-version"] == "py311"


def imported_by_pages():
    """Top-level modules that programs of the manual import, and those that the functions they call need for files and pictures."""
    programs = [*SOURCE.glob("examples/python/*.py"), *SOURCE.glob("docs/programs/*.py")]
    lines = [line for path in programs for line in path.read_text(encoding="utf-8").splitlines()]
    for page in SOURCE.glob("docs/**/*.rst"):
        lines += re.sub(r"^ *(>>>|\.\.\.) ?", "", page.read_text(encoding="utf-8"), flags=re.MULTILINE).splitlines()
    matches = [re.match(r" *(?:import|from) (\w+)(?:[.\w]*)(?: import \w.*| as \w+)?$", line) for line in lines]
    return {match[1] for match in matches if match} - set(sys.stdlib_module_names)


def test_extras():
    """What the manual's programs import is in the extra `pages`, and what Sphinx imports for it in `docs`."""
    extras = tomllib.loads((SOURCE / "pyproject.toml").read_text(encoding="utf-8"))["project"]["optional-dependencies"]
    plain = {name: {re.sub(r"\[.*", "", requirement) for requirement in extra} for name, extra in extras.items()}
    imported = imported_by_pages()
    assert {"numpy", "pypw85", "scipy"} <= imported  # that imports are found at all
    assert imported - {"numpy", "pypw85"} <= plain["pages"]
    assert plain["plot"] | plain["files"] | plain["dask"] <= plain["pages"]
    conf = (SOURCE / "docs/conf.py").read_text(encoding="utf-8")
    used = re.findall(r'^    "(\w+)",$', conf.partition("extensions = [")[2].partition("]")[0], re.MULTILINE)
    own = {path.stem for path in (SOURCE / "docs/extensions").glob("*.py")}
    packages = {name.replace("myst_parser", "myst-parser").replace("_", "-") for name in used if name not in own}
    assert packages | {"sphinx", "furo"} <= plain["docs"]


def test_libraries(installed):
    """No more than what every system with wheels has (PEP 600), and the run-time library of OpenMP, which auditwheel puts into the
    wheel (scripts/test_wheel.sh): this says it without auditwheel, which Debian 12 lacks."""
    (extension,) = (installed / "pypw85").glob("_core*.so")
    needed = set(re.findall(r"NEEDED.*\[([\w+-]+)\.so", run("readelf", "--dynamic", "--wide", str(extension))))
    assert needed <= {"libc", "libm", "libstdc++", "libgcc_s", "libpthread", "libdl", "libgomp",
                      "ld-linux-x86-64", "ld-linux-aarch64"}


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="libraries of ELF")
def test_hardening(installed):
    """As the libraries are."""
    (extension,) = (installed / "pypw85").glob("_core*.so")
    options = ["--landing-pads"] if platform.machine() == "x86_64" else []
    run(sys.executable, str(SOURCE / "tests/flags/check_hardening.py"), *options, str(extension))


def test_cibuildwheel():
    """What pyproject.toml tells cibuildwheel agrees with the rest of it."""
    project = tomllib.loads((SOURCE / "pyproject.toml").read_text(encoding="utf-8"))
    table = project["tool"]["cibuildwheel"]
    oldest = min(int(minor) for minor in re.findall(r"cp3(\d+)-\*", table["build"]))
    assert project["project"]["requires-python"] == f">= 3.{oldest}"
    assert (SOURCE / re.fullmatch(r"python {project}/(\S+)", table["test-command"])[1]).is_file()
    for system in ("linux", "macos"):
        assert re.search(r"three-[\d.]+\.tgz \| tar -xz -C /tmp", table[system]["before-all"])
    assert table["config-settings"] == {"setup-args": "-Dthree=/tmp/package"}  # npm's packages unpack to that folder
    image = re.search(r"cibuildwheel[^`]*``(manylinux\w+)``", (SOURCE / "docs/installation.rst").read_text(encoding="utf-8"))[1]
    assert {table["linux"][f"manylinux-{machine}-image"] for machine in ("x86_64", "aarch64")} == {image}


def test_use(installed, tmp_path):
    program = "import pypw85; print(pypw85.__file__); print(pypw85.contact([2, 0, 0], *[[1, 0, 0, 1, 0, 1]] * 2)[0])"
    environment = {**os.environ, "PYTHONPATH": str(installed)}
    where, mu2 = run(sys.executable, "-c", program, cwd=tmp_path, env=environment).split()
    assert pathlib.Path(where).is_relative_to(installed)
    assert float(mu2) == 1


def test_command(installed, tmp_path):
    """From the entry point of the wheel to a first picture."""
    (tmp_path / "a.csv").write_text("x,y,z,radius\n0,0,0,1\n1,0,0,1\n")
    (point,) = importlib.metadata.Distribution.at(next(installed.glob("*.dist-info"))).entry_points
    assert (point.name, point.value) == ("pw85", "pypw85.cli:main")
    environment = {**os.environ, "PYTHONPATH": str(installed)}
    assert "overlaps" in run(sys.executable, "-m", "pypw85", "check", "a.csv", succeeds=False, cwd=tmp_path, env=environment)
    run(sys.executable, "-m", "pypw85", "draw", "a.csv", "a.png", cwd=tmp_path, env=environment)
    assert (tmp_path / "a.png").stat().st_size > 1000


def test_editable_installation_is_refused(copy, tmp_path):
    """Pip would pretend that it succeeded."""
    venv.create(tmp_path / "env", system_site_packages=True)
    output = run(str(tmp_path / "env" / "bin" / "python"), *PIP[1:], "-e", str(copy), succeeds=False)
    assert "pypw85 has no editable installation" in output
