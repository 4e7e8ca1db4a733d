"""Whether the recipes can be filled in, and the results, the workflows and the templates can be read: YAML, JSON, TOML, Python, shell,
INI; and whether they name what the sources have: the version, parts of .ci/run, options of Meson, dependencies. This is not a run of
them. Usage: test_recipes.py; the exit status is 77 without PyYAML.
"""

import ast
import configparser
import json
import re
import shlex
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent
sys.path[:0] = [str(HERE), str(ROOT / "scripts"), str(ROOT / ".ci")]
import fill  # noqa: E402
import release_notes  # noqa: E402

try:
    import yaml
except ImportError:
    sys.exit(77)

EXAMPLE = {
    "repository": "git.example.invalid/pw85",
    "homepage": "example.invalid/pw85",
    "archive": "example.invalid/pw85-@VERSION@.tar.gz",
    "archive_sha256": "0" * 64,
    "archive_sha512": "0" * 128,
    "archive_folder": "pw85-@VERSION@",
    "octave_archive": "example.invalid/pw85-octave-@VERSION@.tar.gz",
    "octave_archive_sha256": "0" * 64,
    "contact": "pw85@example.invalid",
    "maintainers": ["one", "two"],
}
VERSION = release_notes.version_of_sources()


def read_ini(text):
    parser = configparser.ConfigParser()
    parser.read_string(text)
    return parser


def read_shell(text):
    subprocess.run(["bash", "-n"], input=text, text=True, check=True, capture_output=True)
    return shlex.split(text, comments=True)


def read_cmake(text):
    """Parentheses and quotes are closed: Debian's cmake has no check of syntax alone."""
    plain = re.sub(r'"(?:[^"\\]|\\.)*"|#.*', "", text)
    if plain.count("(") != plain.count(")") or '"' in plain:
        raise ValueError("a parenthesis or a quote is not closed")
    return text


def read_dockerfile(text):
    """Each instruction is known."""
    for line in re.sub(r"\\\n", " ", text).splitlines():
        if line and not re.match(r"#|(FROM|RUN|COPY|WORKDIR) \S", line):
            raise ValueError(f"not an instruction: {line}")
    return text


READERS = {
    ".yaml": lambda text: [*yaml.safe_load_all(text)], ".yml": yaml.safe_load, ".json": json.loads, ".py": ast.parse,
    ".wrap": read_ini, ".sh": read_shell, ".cmake": read_cmake, ".txt": read_cmake, "Dockerfile": read_dockerfile, ".c": str,
}  # fmt: skip


def complaints_of_file(name, text):
    kind = Path(name).suffix or Path(name).name
    try:
        READERS[kind](text)
    except Exception as error:
        yield f"{name}: {error}"
    if re.search(r"@[A-Z_]+@", text):
        yield f"{name}: not filled in: {re.search(r'@[A-Z_]+@', text)[0]}"


def complaints_of_recipes(folder):
    fill.write(folder, EXAMPLE)
    files = [path for path in sorted(Path(folder).rglob("*")) if path.is_file()]
    if len(files) < 13:
        yield f"there are only {len(files)} recipes"
    texts = {str(path.relative_to(folder)): path.read_text(encoding="utf-8") for path in files}
    unreadable = [complaint for name, text in texts.items() for complaint in complaints_of_file(name, text)]
    if unreadable:
        yield from unreadable
        return
    for name, text in texts.items():
        if not name.endswith(".c") and "Not yet run" not in text:
            yield f"{name}: does not say whether it has run"
        yield from (f"{name}: there is no option {option}" for option in set(re.findall(r" -D(\w+)=", text)) - options())
    versions = {
        "conda-forge": yaml.safe_load(texts["conda-forge/recipe.yaml"])["context"]["version"],
        "vcpkg": json.loads(texts["vcpkg/vcpkg.json"])["version"],
        "conan": next(iter(yaml.safe_load(texts["conan/conandata.yml"])["sources"])),
        "octave": next(yaml.safe_load_all(texts["octave/pw85.yaml"]))["versions"][0]["id"],
        "spack": re.search(r' version\("(.*?)"', texts["spack/package.py"])[1],
        "wrapdb": re.search(r"pw85-(.*?)\.tar", texts["wrapdb/pw85.wrap"])[1],
    }
    yield from (f"{name}: version {version} instead of {VERSION}" for name, version in versions.items() if version != VERSION)
    provided = {word.strip() for word in read_ini(texts["wrapdb/pw85.wrap"])["provide"]["dependency_names"].split(",")}
    if not provided >= {"pw85", "pw85-headers"}:
        yield f"wrapdb/pw85.wrap provides only {provided}"
    yield from complaints_of_vcpkg(texts, {name for name in provided if not name.endswith("-headers")})
    yield from complaints_of_octave(texts["octave/pw85.yaml"])
    yield from complaints_of_conda(yaml.safe_load(texts["conda-forge/recipe.yaml"]))


# The ports of vcpkg that define the commands of a portfile, by the beginnings of their names.
PORTS = {"vcpkg_cmake_config_": "vcpkg-cmake-config", "vcpkg_configure_meson": "vcpkg-tool-meson"}


def complaints_of_vcpkg(texts, packages):
    """The ports of all commands are named, and the CMake packages of all libraries are moved."""
    portfile = texts["vcpkg/portfile.cmake"]
    ports = {one if isinstance(one, str) else one["name"] for one in json.loads(texts["vcpkg/vcpkg.json"])["dependencies"]}
    for command, port in PORTS.items():
        if command in portfile and port not in ports:
            yield f"vcpkg: {command} needs the port {port}"
    moved = set(re.findall(r"CONFIG_PATH lib/cmake/(\w+)", portfile))
    yield from (f"vcpkg: lib/cmake/{name} stays where it is" for name in sorted(packages - moved))


def complaints_of_octave(text):
    """The index of packages wants these members, the name of the file, and the dependencies of DESCRIPTION."""
    entry = next(yaml.safe_load_all(text))
    text = (ROOT / "octave/DESCRIPTION").read_text(encoding="utf-8")
    described = dict(line.split(": ", 1) for line in text.splitlines() if line[0] != " ")
    if entry["layout"] != "package" or entry["permalink"] != described["Name"]:
        yield "octave: layout or permalink"
    missing = {"description", "icon", "links", "maintainers", "versions"} - entry.keys()
    yield from (f"octave: there is no {name}" for name in sorted(missing))
    if entry["versions"][0]["depends"] != [described["Depends"], "pkg"]:
        yield f"octave: depends on {entry['versions'][0]['depends']}"


def complaints_of_conda(recipe):
    """A script with a variable of a shell of Unix is not run on Windows."""
    for output in recipe["outputs"]:
        if "${" in str(output["build"]["script"]).replace("${{", "") and output["build"].get("skip") != "win":
            yield f"conda-forge: the script of {output['package']['name']} needs a shell of Unix"


# The Debian packages of what Meson looks for to build the manual and the tests; readelf, nm and objdump come with g++.
DEBIAN = {
    "/usr/bin/python3": ["python3-dev"], "doxygen": ["doxygen"], "clang++": ["clang", "lld"], "cmake": ["cmake"],
    "glib-2.0": ["libglib2.0-dev"], "hdf5": ["libhdf5-dev"], "boost": ["libboost-dev"], "mpfr": ["libmpfr-dev"],
    "readelf": ["g++"], "nm": ["g++"], "objdump": ["g++"], "env": [], "threads": [], "dl": [],
}  # fmt: skip
SOUGHT = re.compile(r"(?:find_program|dependency)\(\s*'([\w./+-]+)'((?:[^()]|\([^()]*\))*)\)")


def complaints_of_debian():
    """debian/control names, by the profile, what a build with the manual and with the tests looks for, and what the command imports."""
    relations = re.search(r"^Build-Depends:(.*?)^\S", (ROOT / "debian/control").read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)
    named = {part.split()[0]: part for part in re.split(r",\s*", relations[1].strip())}
    needed = {"nocheck": tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]["dependencies"], "nodoc": []}
    needed["nocheck"] = [f"python3-{re.match(r'[a-z]+', one)[0]}" for one in needed["nocheck"] if "numpy" not in one]
    for profile, folder in (("nodoc", "docs"), ("nocheck", "tests")):
        for path in (ROOT / folder).rglob("meson.build"):
            for name, rest in SOUGHT.findall(path.read_text(encoding="utf-8")):
                if "required: false" in rest or (path.parent / name).exists():
                    continue
                if name not in DEBIAN:
                    yield f"{path.relative_to(ROOT)} looks for {name}: which package of Debian has it?"
                needed[profile] += DEBIAN.get(name, [])
    for profile, packages in needed.items():
        for package in sorted(set(packages)):
            if named.get(package) not in (package, f"{package} <!{profile}>"):
                yield f"debian/control: Build-Depends lacks {package} <!{profile}>"


def options():
    """Those of Meson's own that recipes use, and ours."""
    ours = re.findall(r"^option\('(\w+)'", (ROOT / "meson_options.txt").read_text(encoding="utf-8"), re.MULTILINE)
    return {*ours, "default_library", "b_lundef"}


def complaints_of_host():
    """Workflows, templates, and what belongs to a release."""
    hosted = [*ROOT.glob(".github/**/*.yml"), ROOT / "debian/upstream/metadata", ROOT / "CITATION.cff"]
    for path in hosted:
        text = path.read_text(encoding="utf-8")
        yield from complaints_of_file(path.name if path.suffix == ".yml" else f"{path}.yaml", text)
    workflows = {path.stem: yaml.safe_load(path.read_text(encoding="utf-8")) for path in ROOT.glob(".github/workflows/*.yml")}
    for name, workflow in workflows.items():
        for job, what in workflow["jobs"].items():
            if "runs-on" not in what or not all(("run" in step) != ("uses" in step) for step in what["steps"]):
                yield f"{name}: the job {job} is not complete"
    yield from complaints_of_parts(workflows["checks"])


def complaints_of_parts(workflow):
    import checks

    jobs = workflow["jobs"]["debian"]["strategy"]["matrix"]["include"]
    on_x86 = [part for job in jobs if not job["runner"].endswith("-arm") for part in job["parts"].split()]
    unknown = {part for job in jobs for part in job["parts"].split()} - checks.PARTS.keys()
    missing = {name for name, part in checks.PARTS.items() if part.by_default} - set(on_x86)
    yield from (f"checks.yml: .ci/run has no part {part}" for part in sorted(unknown))
    yield from (f"checks.yml does not run the part {part}" for part in sorted(missing))


# What hosts show in another way on the page of a release than in a file: names of people, emphasis by mistake, links to files.
MISREAD = re.compile(r"(?<![\w`])@\w+|\w\*\*\w|\]\((?!https?://)[^)]*\)")


def new_functions():
    """The functions that this version has first, but for those of many rows, which come with them."""
    lists = [path.read_text(encoding="utf-8") for path in (ROOT / "debian").glob("*.symbols")]
    first = {name for text in lists for name in re.findall(rf"^ (\w+)@Base {re.escape(VERSION)}$", text, re.MULTILINE)}
    return sorted({name.replace("_batch", "") for name in first})


def complaints_of_release():
    text = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    section = release_notes.section(text, VERSION)
    if section:
        page = re.sub(r"`[^`]*`", "", release_notes.with_long_lines(section))
        yield from (f"CHANGELOG.md: {found!r} is misread on the page of a release" for found in MISREAD.findall(page))
        yield from (f"CHANGELOG.md, {VERSION}: {name} is not named" for name in new_functions() if not re.search(rf"`{name}\b", section))
    else:
        yield f"CHANGELOG.md has no section for {VERSION} with a date"
    notes = release_notes.section("# A\n\n## [2.0.0] - 2026-01-02\n\n- b\n\n## [1.0.0] - 2025-01-02\n\n- c\n", "2.0.0")
    if notes != "- b":
        yield f"notes of a release are {notes!r}"
    joined = release_notes.with_long_lines("### A\n\nb\nc:\n\n- d\n  -e f\n- g\n\n#### H\n\n- i\n  j")
    if joined != "### A\n\nb c:\n\n- d -e f\n- g\n\n#### H\n\n- i j":
        yield f"joined lines are {joined!r}"
    done = subprocess.run([sys.executable, HERE / "fill.py", "/nowhere"], capture_output=True, text=True)
    empty = [name for name, value in fill.addresses().items() if not value]
    if empty and (done.returncode == 0 or "archive" not in done.stderr):
        yield "recipes are filled in without addresses"


def main():
    with tempfile.TemporaryDirectory(prefix="pw85-recipes-") as folder:
        found = [*complaints_of_recipes(folder), *complaints_of_host(), *complaints_of_release(), *complaints_of_debian()]
    print("\n".join(found))
    return 1 if found else 0


sys.exit(main())
