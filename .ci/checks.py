# SPDX-License-Identifier: BSD-3-Clause
"""The checks of .ci/run, in parts that can be run alone: README's two commands, the tests with gcc and clang without warnings, the
styles for LAMMPS, sanitizers, valgrind, format, static analysis, other platforms, Debian packages, the ABI.

Usage: checks.py [--record] [all | list | PART...]

Without a name, the parts run that a change can break; `all` adds the other ones, and `list` names them. On two processors three
parts run at a time, where one needs no result of the other: many steps keep no processor busy all the time. The last lines of the
output are "N skipped" and "N passed, N failed".
"""

import argparse
import contextlib
import dataclasses
import fnmatch
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import threading
import time
import typing
from pathlib import Path

import times
from results import Results

ROOT = Path(__file__).resolve().parent.parent
BUILDS = ROOT / "build-ci"
TEST_COMMAND_BUILD = ROOT / "build-test"  # the build folder of scripts/test.sh
TIMES = BUILDS / "times.jsonl"  # processor seconds, see times.py
CLANG = {"CC": "clang", "CXX": "clang++"}
# The tests of these suites read sources, or compile them by compilers of their own. So they say the same in every build, and the test
# command runs them.
NOT_SOURCES = ["--no-suite=sources", "--no-suite=docs"]
# For machines of scripts/test_cross.sh, the tests to run and their environment. Only tests run that can find an error of that
# machine: on 64-bit ARM those of code that is compiled per instruction set. In emulation SVE is ten times as slow as NEON, and the
# examples take a minute.
QUICK = ["--suite", "quick", "--suite", "portable", *NOT_SOURCES]
WITH_LIBRARIES = {
    "aarch64-linux-gnu": ([*QUICK, "--suite", "kernels", "--suite", "thorough", "--no-suite", "targets", "--no-suite", "examples"],
                          {"QEMU_CPU": "cortex-a72"}),
    "i686-linux-gnu": (QUICK, {}),
}
NOT_IN_CI = ["powerpc64le-linux-gnu", "riscv64-linux-gnu"]  # half a minute each, and ARM and z/Architecture find the same errors
ONE_LIBRARY = "-Ddefault_library=shared"  # half the time to compile; the other parts build both
EACH_HEADER = "-Db_pch=false"  # each source of the tests includes what it uses
JOINED = "-Djoined=true"  # some sources in each unit; the part `tests` compiles each source alone
ONLY_TESTS = ["-Dtests=enabled", "-Dgpu=enabled", "-Dbench=disabled", "-Dpython=disabled", "-Dfortran=disabled"]


def folder_of(name):
    """The build folder of a part. It is next to that of the test command, so that paths are the same and ccache finds its
    results."""
    return ROOT / f"build-ci-{name}"


steps = []  # the commands of this part, with their seconds


def status(command, **environment):
    print("+", *command[:16], *(["..."] if len(command) > 16 else []), flush=True)
    start = time.monotonic()
    code = subprocess.run(command, cwd=ROOT, env={**os.environ, **environment}).returncode
    steps.append((" ".join(Path(word).name for word in command[:4]), time.monotonic() - start))
    return code


def run(command, **environment):
    return status(command, **environment) == 0


def add_unless_missing(results, name, command):
    """Adds the result of a script that exits with 77 if a tool that it downloads is not available."""
    result = status(command)
    if result == 77:
        results.skip(name)
    else:
        results.add(name, result == 0)


def set_up(name, options, environment):
    """Sets up a fresh build folder in which warnings are errors, and returns whether this succeeds."""
    folder = folder_of(name)
    shutil.rmtree(folder, ignore_errors=True)
    return run(["meson", "setup", str(folder), *options, "--werror"], **environment)


def build(results, name, options, environment, targets=()):
    """Builds everything or some targets in a fresh folder, without warnings, and returns whether this succeeds."""
    ok = set_up(name, options, environment) and run(["meson", "compile", "-C", str(folder_of(name)), *targets], **environment)
    results.add(f"{name}: build without warnings", ok)
    return ok


def test(results, folder, arguments=(), **environment):
    """Runs all or some tests. Their programs are built if necessary."""
    ok = run(["meson", "test", "-C", str(folder), "--print-errorlogs", *arguments], **environment)
    report(results, folder, ok)


def test_some(results, name, selection, options, compilers, **environment):
    """Runs the tests that the words of `selection` select, in a fresh folder, without warnings. Only their programs are built."""
    results.add(f"{name}: set up", set_up(name, options, compilers))
    test(results, folder_of(name), [*selection, "--timeout-multiplier=10"], **environment)


def report(results, folder, ok):
    """Adds the results of the last `meson test` in a folder; `ok` is whether it exited with 0."""
    before = len(results.failures)
    logs = sorted((folder / "meson-logs").glob("testlog*.json"), key=lambda path: path.stat().st_mtime)
    if logs:
        results.add_report(folder.name, logs[-1])
    if not logs or (not ok and len(results.failures) == before):
        results.add(f"{folder.name}: meson test", False)


def test_command(results):
    """Runs README's test command in a fresh folder, with warnings as errors."""
    shutil.rmtree(TEST_COMMAND_BUILD, ignore_errors=True)
    recorder = str(ROOT / ".ci" / "processor_time.py")
    # Another part runs beside it.
    ok = run(["scripts/test.sh", "--wrap", recorder, "--timeout-multiplier=4"], PW85_SETUP_OPTIONS="--werror", CCACHE_PREFIX=recorder,
             PW85_PROCESSOR_TIMES=str(TIMES))
    report(results, TEST_COMMAND_BUILD, ok)


def check_pages(results):
    """Adds the benchmarks and the pages to the build of the test command, which has run the suite docs, and tests the pages. They
    are made each time that something asks for them, so that the tests must not."""
    ok = run(["meson", "configure", str(TEST_COMMAND_BUILD), "-Dbench=enabled", "-Ddocs=enabled"]) and run(
        ["ninja", "-C", str(TEST_COMMAND_BUILD), "all", "docs"])
    results.add("pages: build without warnings", ok)
    test(results, TEST_COMMAND_BUILD, ["--no-rebuild", "--suite", "pages"])


def check_format(results):
    """What the texts alone say: nothing is built for it."""
    sources = tracked("*.c", "*.cpp", "*.h", "*.hpp")
    results.add("format", run(["clang-format", "--dry-run", "-Werror", *sources]))
    # The program leaves comments alone. A text between quotation marks may be longer: who searches for a message finds it.
    long = [f"{name}:{number}" for name in sources for number, line in enumerate((ROOT / name).read_text(encoding="utf-8").splitlines(), 1)
            if len(line) > 100 and '"' not in line]  # fmt: skip
    print("".join(f"{place}: more than 100 columns\n" for place in long), end="")
    results.add("columns", not long)
    scripts = [file for file in tracked("*.sh", ".ci/run", "debian/tests/consumer") if file != "scripts/packages.sh"]
    results.add("shellcheck", run(["shellcheck", "-x", "-s", "sh", "-e", "SC2046", *scripts]))  # unquoted lists of words
    prose = [file for file in tracked() if not file.endswith((".svg", ".png", ".ipynb", ".h5", ".js", ".out", "words.txt", "_pairs.txt"))]
    results.add("codespell", run(["codespell", "-L", "calcuations,crate,fo,lod,nd,nin,numer,rotat,te", *prose]))
    results.add("licences", run(["reuse", "lint"]))
    add_unless_missing(results, "ruff", ["scripts/sid.sh", "ruff", "check"])


def check_with_libraries(results, machine):
    """Runs the tests for another machine, and adds whether the libraries that they need were available."""
    folder = ROOT / f"build-{machine}"
    shutil.rmtree(folder, ignore_errors=True)
    arguments, environment = WITH_LIBRARIES[machine]
    ok = run(["scripts/test_cross.sh", machine, *arguments], PW85_SETUP_OPTIONS=f"--werror {ONE_LIBRARY} {EACH_HEADER}", **environment)
    if not (ROOT / f"build-{machine}-root/complete").exists():
        results.skip(f"{machine}: tests with libraries")
        return False
    report(results, folder, ok)
    return True


@contextlib.contextmanager
def wine():
    """Starts Wine, keeps it running, and yields the environment of its programs. When two programs start it at the same time, one
    of them may fail."""
    environment = {"WINEPREFIX": str(BUILDS / "wine"), "WINEDEBUG": "-all"}
    Path(environment["WINEPREFIX"]).mkdir(parents=True, exist_ok=True)
    server = "/usr/lib/wine/wineserver"
    run([server, "--persistent"], **environment)
    run(["/usr/lib/wine/wine64", "wineboot", "--init"], **environment)
    try:
        yield environment
    finally:
        run([server, "--kill"], **environment)


def build_for(results, machine, others=()):
    """Builds what runs wherever there is a compiler and an emulator, for the machine of a file of scripts/cross/, with other options."""
    boost = BUILDS / "boost"  # the headers of Boost, without those of other libraries of this system
    (boost / "include").mkdir(parents=True, exist_ok=True)
    if not (boost / "include/boost").exists():
        (boost / "include/boost").symlink_to("/usr/include/boost")
    options = ["-Dgsl=disabled", *(f"-D{name}=disabled" for name in ("bench", "python", "fortran")), *others]
    return build(results, machine.stem, [f"--cross-file={machine}", *options], {"BOOST_ROOT": str(boost)},
                 ["contact_problems", "headers_after_others", "portable_headers", "portable_library", "portable_saved_states",
                  "portable_c"])


def check_package_of_windows(results, machine, environment):
    """Installs what was built for Windows, and builds and runs a program with it by find_package, with the DLLs from where that says."""
    work = BUILDS / "windows"
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    for source, copy in (("windows_CMakeLists.txt", "CMakeLists.txt"), ("consumer.c", "consumer.c")):
        shutil.copy(ROOT / "tests/install" / source, work / copy)
    ok = run(["meson", "install", "-C", str(folder_of(machine)), "--destdir", str(work / "stage")])
    package = next((work / "stage").rglob("cmake/pw85"), work)
    ok = ok and run(["cmake", "-G", "Ninja", "-S", str(work), "-B", str(work / "build"), f"-Dpw85_DIR={package}",
                     "-DCMAKE_SYSTEM_NAME=Windows", f"-DCMAKE_C_COMPILER={machine}-gcc-posix"])
    ok = ok and run(["cmake", "--build", str(work / "build")])
    results.add(f"{machine}: find_package", ok and run(["/usr/lib/wine/wine64", str(work / "build/consumer.exe")], **environment))


def check_platforms(results):
    """Tests the core and the library on the platforms for which Debian has a compiler and an emulator. All platforms run the
    contact problems; those for which Debian has the libraries that tests need run more tests."""
    machines = [machine for machine in sorted((ROOT / "scripts/cross").glob("*.ini")) if machine.stem not in NOT_IN_CI]
    with wine() as environment:
        for machine in machines:
            if machine.stem in WITH_LIBRARIES and check_with_libraries(results, machine.stem):
                continue
            if build_for(results, machine):
                test(results, folder_of(machine.stem), ["--suite", "portable", "--suite", "thorough"], **environment)
                if "mingw" in machine.stem:
                    check_package_of_windows(results, machine.stem, environment)


def tracked(*patterns):
    """The files that git tracks; in the folder of a tarball, which has no repository, all sources. A pattern is a file, or has stars,
    which match slashes too; ":!NAME" leaves out a file or a folder."""
    listed = subprocess.run(["sh", "-c", ". scripts/minimal_system.sh && list_sources"], cwd=ROOT, check=True, text=True,
                            stdout=subprocess.PIPE).stdout.split("\0")[:-1]
    wanted = [pattern for pattern in patterns if not pattern.startswith(":!")] or ["*"]
    excluded = [pattern[2:] for pattern in patterns if pattern.startswith(":!")]
    return sorted(name for name in listed if any(fnmatch.fnmatchcase(name, pattern) for pattern in wanted)
                  and not any(name == one or name.startswith(f"{one}/") for one in excluded))  # fmt: skip


def check_static(results):
    """Static analysis, beside the compilers' warnings and mypy, which the tests run. The analyser of GCC 12 is only for C, where it
    would see only programs that use the library."""
    glib = subprocess.run(["pkg-config", "--cflags", "glib-2.0"], check=True, text=True, stdout=subprocess.PIPE).stdout.split()
    for file in tracked("*.c", ":!tests/headers/c89.c", ":!r/src", ":!octave/src"):  # R and Octave are not installed
        results.add(f"analyzer: {file}", run(["gcc", "-std=c99", "-O2", "-fanalyzer", "-Werror", "-Iinclude",
                                              f"-I{TEST_COMMAND_BUILD}/include", "-D_POSIX_C_SOURCE=200809L",
                                              *glib, "-c", file, "-o", "/dev/null"]))


# The analyser takes the lines of a loop again and again until its steps are used up. With a quarter of the steps that .clang-tidy allows
# it reaches nearly all of the lines in a third of the time.
FEWER_STEPS = """--config={InheritParentConfig: true, ExtraArgs: ["-Xclang", "-analyzer-config", "-Xclang", "max-nodes=25000"]}"""


def tidy(name, units, *options):
    """Analyses sources of the library with the arguments of the build by clang, two processes at a time, and returns whether nothing is
    found. Most of what a source consists of are headers, so the sources of a folder are read as one file, behind each other: the
    analyser follows no function of a file that is included."""
    database = BUILDS / "tidy" / name
    shutil.rmtree(database, ignore_errors=True)
    database.mkdir(parents=True)
    entries = []
    for (folder, *arguments), sources in sorted(units, key=lambda unit: -len(unit[1])):  # the longest first
        group = database / f"group_{len(entries)}.cpp"
        group.write_text("".join(f'#line 1 "{source}"\n{source.read_text()}' for source in sources))
        words = [*arguments, "-iquote", str(folder), "-c", str(group)]
        entries.append({"directory": str(folder_of("clang")), "arguments": words, "file": str(group)})
    (database / "compile_commands.json").write_text(json.dumps(entries))
    command = ["xargs", "-P2", "-n1", "clang-tidy", "--quiet", *options, "-p", str(database)]
    files = "\n".join(entry["file"] for entry in entries)
    return bool(entries) and subprocess.run(command, cwd=ROOT, text=True, input=files).returncode == 0


def sources_of(unit):
    """The sources of a unit: those that a unit of Meson joins, or the file itself."""
    joined = re.findall("^#include *<(.+)>$", unit.read_text(encoding="utf-8"), re.MULTILINE) if "-unity" in unit.name else []
    return [Path(name).resolve() for name in joined] or [unit]


def units_of_library(of_rows):
    """Sources of the library by their folder and the arguments of the compiler: those of the loops over rows, or all others. A source
    that is compiled more than once is there once: as the first of its units, which is for the newest instruction set."""
    build = folder_of("clang")
    commands = build / "compile_commands.json"
    units = json.loads(commands.read_text()) if commands.exists() else []
    of_file = {source: unit for unit in reversed(units) for source in reversed(sources_of((build / unit["file"]).resolve()))}
    found = {}
    for source in reversed(of_file):
        is_of_rows = source.parent == ROOT / "src/c_api" and source.stem.endswith(("_rows", "_lanes"))
        if source.is_relative_to(ROOT / "src") and is_of_rows in of_rows:
            words = shlex.split(of_file[source]["command"])
            found.setdefault((source.parent, *words[: words.index("-MD")]), []).append(source)
    return found.items()


def check_tidy(results):
    """All checks but one. The loops over rows are short, alike, and call functions that have files of their own. The analyser, which
    follows all paths, takes most of the time there, and so it sees them in the part `whole-clang-tidy`."""
    results.add("clang-tidy", tidy("others", units_of_library({False}), FEWER_STEPS))
    results.add("clang-tidy of rows", tidy("rows", units_of_library({True}), "--checks=-clang-analyzer-*"))


def check_whole_tidy(results):
    results.add("clang-tidy with all steps", tidy("whole", units_of_library({False, True})))


def build_debian(work, sources, **environment):
    """Builds the packages in `work`, from the files that git tracks in a folder of this name. Returns whether this succeeds."""
    shutil.rmtree(work, ignore_errors=True)
    (work / sources).mkdir(parents=True)
    run(["cp", "--parents", "-t", str(work / sources), *tracked()])
    words = {"PATH": "/usr/bin:/bin", "DEB_BUILD_OPTIONS": "nocheck", "DEB_BUILD_PROFILES": "nocheck", **environment}
    command = ["dpkg-buildpackage", "-b", "-us", "-uc"]
    return subprocess.run(command, cwd=work / sources, env={**os.environ, **words}).returncode == 0


def check_reproducible(results, first):
    """Builds the packages again, elsewhere, at another time of another zone, by one processor, and compares them bit by bit."""
    second = BUILDS / "debian-again"
    results.add("debian: packages, again", build_debian(second, "elsewhere/pw85", TZ="Pacific/Kiritimati", LC_ALL="C",
                                                        DEB_BUILD_OPTIONS="nocheck parallel=1"))
    packages = sorted(file.name for file in first.glob("*.deb"))
    others = {name: next(second.rglob(name), None) for name in packages}
    different = [name for name, other in others.items() if other is None or (first / name).read_bytes() != other.read_bytes()]
    print("not reproducible:", *different)
    results.add("debian: reproducible", len(packages) >= 5 and not different)


def check_without_pages(results):
    """Builds the packages without the manual, which needs no tool of the manual."""
    work = BUILDS / "debian-nodoc"
    ok = build_debian(work, "pw85", DEB_BUILD_OPTIONS="nocheck nodoc", DEB_BUILD_PROFILES="nocheck nodoc")
    names = {file.name.partition("_")[0].removesuffix("-dbgsym") for file in work.glob("*.deb")}
    results.add("debian: nodoc", ok and names == {"libpw85-3", "libpw85-dev", "libpw85-gpu3", "python3-pypw85"})


def check_debian(results):
    """Builds the Debian packages, runs lintian, uses the unpacked packages in programs, and builds them in other ways."""
    work = BUILDS / "debian"
    results.add("debian: packages", build_debian(work, "pw85"))
    # lintian expects that the first version of a package closes a bug report that asks for it. There is no such report.
    changes = [str(file) for file in work.glob("*.changes")]
    results.add("debian: lintian", run(["lintian", "--allow-root", "--fail-on=error,warning",
                                        "--suppress-tags=initial-upload-closes-no-bugs", *changes]))
    for package in sorted(work.glob("*.deb")):
        run(["dpkg", "-x", str(package), str(work / "root")])
    results.add("debian: consumer", run(["debian/tests/consumer", str(work / "root")]))
    check_reproducible(results, work)
    check_without_pages(results)


def check_abi(results):
    """Checks that programs that were linked before still run, and that this check finds what it should."""
    for script in ("scripts/abi.sh", "scripts/abi/check_mutants.py"):
        results.add(script, run([script]))


def quick_programs():
    """The tests of the suite `quick` that are compiled programs, not scripts."""
    listed = subprocess.run(["meson", "introspect", "--tests", str(TEST_COMMAND_BUILD)], check=True, stdout=subprocess.PIPE).stdout
    return [test["name"] for test in json.loads(listed)
            if "pw85:quick" in test["suite"] and Path(test["cmd"][0]).is_relative_to(TEST_COMMAND_BUILD)]


def check_valgrind(results):
    valgrind = "valgrind --quiet --error-exitcode=99 --leak-check=full --errors-for-leak-kinds=definite"
    test(results, TEST_COMMAND_BUILD, [*quick_programs(), "--wrap", valgrind, "--timeout-multiplier", "20"],
         G_SLICE="always-malloc", PW85_TARGET="avx2")  # valgrind does not support AVX-512


def check_lammps(results):
    options = [*ONLY_TESTS, ONE_LIBRARY, "-Dlammps=enabled", "-Dpython=enabled", "-Dgpu=disabled"]  # the styles use no GPU
    test_some(results, "lammps", ["--suite=lammps"], options, {})


def check_lammps_of_debian_13(results):
    """Runs the tests of the styles with a newer LAMMPS, whose own walls have another friction."""
    add_unless_missing(results, "scripts/test_lammps.sh trixie", ["scripts/test_lammps.sh", "trixie"])


def check_python_of_debian_13(results):
    """README's commands for Python and the tests of the installed package, with newer versions of Python and NumPy."""
    results.add("scripts/test_python.sh, trixie", run(["scripts/test_release.sh", "trixie", "scripts/test_python.sh"]))


def check_clang(results):
    """Runs the tests that depend on the optimisation of a compiler, with clang. The sanitizers run the examples, and how drivers of GPUs
    fail, with clang."""
    # Programs take more from a static library of joined units.
    suites = ["--suite=quick", "--suite=portable", "--suite=flags", "--no-suite=examples", "--no-suite=gpu", "--no-suite=install"]
    test_some(results, "clang", [*suites, *NOT_SOURCES], [*ONLY_TESTS, JOINED, "-Dgsl=disabled"], CLANG)


SANITIZED = [*ONLY_TESTS, ONE_LIBRARY, JOINED, "-Dgsl=disabled", "-Db_lundef=false", "-Doptimization=1", "-Doptimized=false"]


def check_addresses(results, selection):
    """Runs tests with sanitizers, by clang, which compiles instrumented code ten times as fast as GCC."""
    test_some(results, "address-undefined", selection, [*SANITIZED, "-Db_sanitize=address,undefined"], CLANG,
              UBSAN_OPTIONS="halt_on_error=1:print_stacktrace=1", ASAN_OPTIONS="detect_leaks=1")


def check_sanitizers(results):
    """The tests of memory, threads and bad input, and those that go through all functions."""
    check_addresses(results, SANITIZED_TESTS)
    # Threads do not depend on the instruction set: one of them compiles in half the time. These tests are few: what the library takes less
    # to compile without optimisation is more than they take longer.
    options = [*SANITIZED, "-Doptimization=0", "-Db_sanitize=thread", "-Dopenmp=disabled", "-Dsimd=disabled"]
    test_some(results, "thread", ["--suite=threads"], options, CLANG, TSAN_OPTIONS="halt_on_error=1")


def check_all_sanitizers(results):
    others = (f"--no-suite={suite}" for suite in ("install", "flags", "whole", "thorough", "headers"))
    check_addresses(results, [*others, *NOT_SOURCES])


# What ccache lacks are units of several sources. Whether these compile does not depend on the level, and the test docs_installation
# runs the same script with that of users, but with each source alone.
UNOPTIMIZED = "-Doptimization=0 -Doptimized=false -Dsimd=disabled -Dgpu=disabled"


def check_tutorial(results):
    """README's first command, in a copy of the sources: who calls it here keeps what it installed. As users run it while times are put on
    record, and otherwise without optimisation."""
    work = BUILDS / "tutorial"
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    ok = subprocess.run(["cp", "--parents", "-t", str(work), *tracked()], cwd=ROOT).returncode == 0
    how = {"CCACHE_DISABLE": "1"} if "PW85_RECORD" in os.environ else {"PW85_SETUP_OPTIONS": UNOPTIMIZED}
    results.add("scripts/tutorial.sh", ok and run([str(work / "scripts/tutorial.sh")], **how))


def check_pip(results):
    """README's commands for Python."""
    home = BUILDS / "home"
    shutil.rmtree(home, ignore_errors=True)
    cold = {"CCACHE_DISABLE": "1"} if "PW85_RECORD" in os.environ else {}
    results.add("docs/installation/python.sh", run(["sh", "-e", "docs/installation/python.sh"], HOME=str(home), **cold))


def check_wheel(results):
    """Wheels, the interpreters that Meson builds the package for, and what is in a wheel."""
    test(results, TEST_COMMAND_BUILD, ["--suite", "wheel"])
    add_unless_missing(results, "scripts/test_wheel.sh", ["scripts/test_wheel.sh"])


def check_r(results):
    """The R package: R CMD check, its tests and README, and the bits of C."""
    results.add("scripts/test_r.sh", run(["scripts/test_r.sh"]))


def check_octave(results):
    """The Octave package: its tests and README, and the bits of C."""
    results.add("scripts/test_octave.sh", run(["scripts/test_octave.sh"]))


def check_npm(results):
    """The npm package: its module, its tests in Node and Chromium, README, types, and the bits of C."""
    results.add("scripts/test_npm.sh", run(["scripts/test_npm.sh"]))


def check_rust(results):
    """The crates for Rust: their tests, examples and README, linter and formatter, and the bits of C."""
    results.add("scripts/test_rust.sh", run(["scripts/test_rust.sh"]))


def check_languages(results):
    """The bits of 1,000 pairs in C, C++, Fortran, Python, Rust, R, Octave and JavaScript."""
    results.add("scripts/test_languages.sh", run(["scripts/test_languages.sh"]))


def check_tarball(results):
    """The tarball of a release builds and tests itself in a minimal system without a network."""
    results.add("scripts/test_tarball.sh", run(["scripts/test_tarball.sh", "bookworm"]))


def check_foreign(results):
    """The library by a compiler and an emulator for 64-bit ARM. It compiles in little more than half the time with less optimisation, which
    changes no bit, and SVE of 256 bits compiles the sources of that of 512. The part `platforms` compiles both, as users do."""
    machine = ROOT / "scripts/cross/aarch64-linux-gnu.ini"
    one_length = f"--cross-file={ROOT}/.ci/one_vector_length.ini"
    if build_for(results, machine, [one_length, JOINED, "-Doptimization=1", "-Doptimized=false"]):
        test(results, folder_of(machine.stem), ["--suite", "portable"])


def check_thorough(results):
    """Three eighths of the random inputs of the programs of which the test command takes an eighth."""
    test(results, TEST_COMMAND_BUILD, ["--suite", "thorough"])


def check_whole(results):
    """All random inputs, whole proofs and long sweeps, in the folder of the test command."""
    test(results, TEST_COMMAND_BUILD, ["--suite", "whole"])


def check_formats(results):
    """Lets programs of Debian write tables of known ellipses, and reads these, in the folder of the test command."""
    test(results, TEST_COMMAND_BUILD, ["--suite", "formats"])


TEST = "$test_packages"
MEASURING = ("python3-skimage python3-opencv python3-sep python3-photutils source-extractor python3-regions octave-matgeom octave-image "
             "imagej xvfb xauth nodejs gnuastro")
LAMMPS = "lammps liblammps-dev libfmt-dev python3-lammps openmpi-bin libopenmpi-dev"
PAGES = ("doxygen python3-breathe furo python3-sphinx-inline-tabs python3-sphinx-copybutton python3-myst-parser libjs-katex nodejs "
         "hunspell hunspell-en-gb chromium $wasm_packages")
MACHINES = "qemu-user g++-aarch64-linux-gnu g++-i686-linux-gnu g++-s390x-linux-gnu g++-mingw-w64-x86-64-posix wine64 emscripten"


@dataclasses.dataclass
class Part:
    check: typing.Callable
    packages: str  # that it needs, as words of scripts/packages.sh
    after: tuple = ()  # parts that must have ended before, if they run at all
    by_default: bool = True
    alone: bool = False  # while times are put on record


# In the order in which they start where they can. Those by other compilers share no object with the tests.
PARTS = {
    "tests": Part(test_command, f"{TEST} qemu-user clang-19 clang-tools-19 libomp-19-dev", alone=True),
    "sanitizers": Part(check_sanitizers, f"{TEST} clang libclang-rt-14-dev"),
    "pages": Part(check_pages, f"{TEST} libbenchmark-dev libfcl-dev {PAGES}", after=("tests",)),
    "lammps": Part(check_lammps, f"{TEST} {LAMMPS}", after=("tests",)),
    "format": Part(check_format, "git clang-format shellcheck codespell reuse"),
    "tutorial": Part(check_tutorial, "$build_packages", after=("tests",), alone=True),
    "pip": Part(check_pip, "$python_packages", after=("tests",), by_default=False, alone=True),
    "wheel": Part(check_wheel, TEST, after=("tests",)),
    "static": Part(check_static, f"{TEST} git", after=("tests",)),
    "clang": Part(check_clang, f"{TEST} clang"),
    "clang-tidy": Part(check_tidy, f"{TEST} clang clang-tidy", after=("clang",)),
    "whole-clang-tidy": Part(check_whole_tidy, f"{TEST} clang clang-tidy", after=("clang", "clang-tidy"), by_default=False),
    "foreign": Part(check_foreign, f"{TEST} qemu-user g++-aarch64-linux-gnu"),
    "thorough": Part(check_thorough, TEST, after=("tests", "pages")),
    "whole": Part(check_whole, TEST, after=("tests", "pages"), by_default=False),
    "all-sanitizers": Part(check_all_sanitizers, f"{TEST} clang libclang-rt-14-dev", after=("tests", "sanitizers"), by_default=False),
    "lammps-of-debian-13": Part(check_lammps_of_debian_13, "git mmdebstrap", after=("lammps",), by_default=False),
    "python-of-debian-13": Part(check_python_of_debian_13, "git mmdebstrap", by_default=False),
    "r": Part(check_r, "$build_packages libboost-dev $r_packages", by_default=False),
    "octave": Part(check_octave, "$build_packages libboost-dev $octave_packages", by_default=False),
    "npm": Part(check_npm, "$npm_packages", by_default=False),
    "rust": Part(check_rust, "$build_packages libboost-dev $rust_packages", by_default=False),
    "languages": Part(check_languages, "$build_packages $python_packages gfortran $octave_packages $rust_packages $npm_packages "
                      "r-base-core r-base-dev", by_default=False),
    "tarball": Part(check_tarball, "$build_packages git mmdebstrap iproute2 xz-utils", by_default=False),
    "formats": Part(check_formats, f"{TEST} {MEASURING}", after=("tests",), by_default=False),
    "valgrind": Part(check_valgrind, f"{TEST} valgrind", after=("tests", "pages"), by_default=False),
    "platforms": Part(check_platforms, f"{TEST} {MACHINES}", after=("tests", "foreign"), by_default=False),
    "debian": Part(check_debian, f"{TEST} {PAGES} git lintian debhelper dpkg-dev fakeroot dh-python", after=("tests",), by_default=False),
    "abi": Part(check_abi, f"{TEST} abigail-tools", after=("tests",), by_default=False),
}
# A part needs the build folder that another one leaves.
NEEDS = {"pages": "tests", "static": "tests", "thorough": "tests", "whole": "tests", "valgrind": "tests", "formats": "tests",
         "clang-tidy": "clang", "whole-clang-tidy": "clang"}
# They run `meson test` in the build folder of the test command, which has one log: one of them at a time.
IN_TEST_BUILD = {"tests", "pages", "wheel", "thorough", "whole", "formats", "valgrind"}
# A run ends no sooner than these parts, behind each other, and then LAMMPS's launches, which are one at a time: the others take what
# these leave of the processors.
LONGEST_CHAIN = IN_TEST_BUILD | {"lammps"}


# The tests of memory, of threads and of bad input, and those of code that differs per instruction set. Headers
# that are only compiled are compiled by the part `clang`, with the same compiler.
SANITIZED_TESTS = ["--suite=quick", "--suite=kernels", "--suite=threads", "--no-suite=targets", "--no-suite=flags", "--no-suite=headers",
                   *NOT_SOURCES]


def install_packages(parts):
    """Installs what the parts need, at once."""
    words = " ".join(sorted({word for part in parts for word in PARTS[part].packages.split()} | {"ccache", "$test_packages"}))
    return subprocess.run(["sh", "-c", f". scripts/packages.sh; install_packages {words}"], cwd=ROOT).returncode == 0


def run_part(name, report_file):
    """Runs one part in this process, and writes its results."""
    results = Results()
    PARTS[name].check(results)
    report_file.write_text(json.dumps({**vars(results), "steps": [*results.steps, *steps]}))


class Scheduler:
    """Runs parts as processes of their own, some at a time."""

    def __init__(self, names, at_a_time, record):
        self.at_a_time, self.record = at_a_time, record
        self.waiting, self.running, self.ended = list(names), set(), set()
        self.changed, self.results, self.times = threading.Condition(), Results(), {}

    def can_start(self, name):
        if any(other in self.waiting or other in self.running for other in PARTS[name].after):
            return False
        if name in IN_TEST_BUILD and self.running & IN_TEST_BUILD:
            return False
        return not (self.record and self.running and any(PARTS[one].alone for one in (name, *self.running)))

    def next_part(self):
        """A part that can start now; None if all have started."""
        with self.changed:
            while self.waiting:
                for name in self.waiting:
                    if self.can_start(name):
                        self.waiting.remove(name)
                        self.running.add(name)
                        return name
                self.changed.wait()
        return None

    def work(self):
        while name := self.next_part():
            print(f"== {name}: started", flush=True)
            log, report_file = BUILDS / f"{name}.log", BUILDS / f"{name}.json"
            report_file.unlink(missing_ok=True)
            start = time.monotonic()
            with log.open("w") as output:
                first = [] if name in LONGEST_CHAIN else ["nice", "-n", "5"]
                process = subprocess.Popen([*first, sys.executable, __file__, "--one", name, str(report_file)], stdout=output,
                                           stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL)
                _, _, usage = os.wait4(process.pid, 0)
            self.end(name, log, report_file, time.monotonic() - start, usage.ru_utime + usage.ru_stime)

    def end(self, name, log, report_file, seconds, processor_seconds):
        found = Results(failures=[f"{name}: it ended without a result"])
        if report_file.exists():
            found = Results(**json.loads(report_file.read_text()))
        with self.changed:
            sys.stdout.write(log.read_text(errors="replace"))
            print(f"== {name}: {seconds / 60:.1f} minutes, {processor_seconds / 60:.1f} of processors", flush=True)
            self.results.add_all(found)
            self.times[name] = {"minutes": round(seconds / 60, 1), "processor_minutes": round(processor_seconds / 60, 1)}
            self.running.remove(name)
            self.changed.notify_all()

    def run(self):
        workers = [threading.Thread(target=self.work) for _ in range(self.at_a_time)]
        for worker in workers:
            worker.start()
        for worker in workers:
            worker.join()


def environment():
    """The parts share a cache of compiled objects. What it ignores does not change an object: warnings are errors in the first part,
    so that what it compiled has none, and the other is about automatic linking on Windows. Meson's paths of sources are relative.
    The compiler itself names the headers of a unit (CCACHE_DEPEND), so that none is preprocessed twice."""
    os.environ.setdefault("CCACHE_DIR", str(BUILDS / "ccache"))
    os.environ["CCACHE_IGNOREOPTIONS"] = "-Werror -DBOOST_ALL_NO_LIB"
    os.environ.update(CCACHE_NOHASHDIR="1", CCACHE_DEPEND="1",
                      CCACHE_SLOPPINESS="include_file_mtime,include_file_ctime,pch_defines,time_macros",
                      CMAKE_C_COMPILER_LAUNCHER="ccache", CMAKE_CXX_COMPILER_LAUNCHER="ccache")  # Meson finds it by itself
    os.environ["PIP_CONFIG_SETTINGS"] = "builddir=build-ci-wheel"  # wheels are built where the relative paths are the same, too


def report_times(scheduler, record):
    """The longest steps, and what takes longer than on record; or makes the record."""
    print("\nThe longest steps, in seconds:")
    for name, seconds in sorted(scheduler.results.steps, key=lambda step: -step[1])[:20]:
        print(f"{seconds:8.0f}  {name}")
    now = {}
    if "tests" in scheduler.times and TIMES.exists():
        listed = subprocess.run(["meson", "introspect", "--tests", str(TEST_COMMAND_BUILD)], check=True, stdout=subprocess.PIPE).stdout
        now = times.read(TIMES, json.loads(listed))
    if record:
        times.store(now, scheduler.times)
    for sentence in times.grown(now, times.load()):
        print(f"LONGER: {sentence}")


def list_parts():
    recorded = times.load().get("parts", {})
    for name, part in PARTS.items():
        took = recorded.get(name)
        minutes = f"{took['minutes']:5.1f} min, {took['processor_minutes']:5.1f} of processors" if took else "not on record"
        print(f"{name:20}{minutes:32}{'' if part.by_default else 'only by name or with `all`'}")


def chosen_parts(words):
    if not words:
        return [name for name, part in PARTS.items() if part.by_default]
    if words == ["all"]:
        return list(PARTS)
    unknown = [word for word in words if word not in PARTS]
    if unknown:
        sys.exit(f"no such part: {' '.join(unknown)}. `.ci/run list` names them.")
    wanted = {*words, *(NEEDS[word] for word in words if word in NEEDS)}
    return [name for name in PARTS if name in wanted]


def main():
    parser = argparse.ArgumentParser(description="Runs checks.")
    parser.add_argument("--record", action="store_true", help="put the times on record (.ci/times.json); README's commands run alone")
    parser.add_argument("--one", nargs=2, metavar=("PART", "FILE"), help=argparse.SUPPRESS)
    parser.add_argument("words", nargs="*", help="parts, `all` or `list`")
    arguments = parser.parse_args()
    if arguments.one:
        return run_part(arguments.one[0], Path(arguments.one[1]))
    if arguments.words == ["list"]:
        return list_parts()
    start = time.monotonic()
    names = chosen_parts(arguments.words)
    BUILDS.mkdir(exist_ok=True)
    TIMES.unlink(missing_ok=True)
    environment()
    if arguments.record:  # alone, and as on a new machine
        shutil.rmtree(os.environ["CCACHE_DIR"], ignore_errors=True)
        os.environ["PW85_RECORD"] = "1"
    if not install_packages(names):
        sys.exit("packages cannot be installed")
    scheduler = Scheduler(names, min(3, 1 + (os.cpu_count() or 1)), arguments.record)
    scheduler.run()
    report_times(scheduler, arguments.record)
    results = scheduler.results
    print(f"\n{(time.monotonic() - start) / 60:.0f} minutes: " +
          ", ".join(f"{name} {took['minutes']}" for name, took in scheduler.times.items()))
    for name in results.skipped:
        print(f"SKIPPED: {name}")
    for name in results.failures:
        print(f"FAILED: {name}")
    print(f"{len(results.skipped)} skipped\n{results.passed} passed, {len(results.failures)} failed")
    return 1 if results.failures else 0


if __name__ == "__main__":
    sys.exit(main())
