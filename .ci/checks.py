"""The checks of .ci/run: README's two commands, all tests with gcc and clang without warnings, the styles for LAMMPS, sanitizers,
valgrind, format, static analysis, other platforms, Debian packages, the ABI.

The results are counted from the logs of `meson test`, so that no list of tests is needed here. A step that is not a test counts as
one result. The last lines of the output are "N skipped" and "N passed, N failed".
"""

import contextlib
import fnmatch
import json
import os
import shutil
import subprocess
import sys
import time
import xml.etree.ElementTree as ElementTree
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
BUILDS = ROOT / "build-ci"
TEST_COMMAND_BUILD = ROOT / "build-test"  # the build folder of scripts/test.sh
CLANG = {"CC": "clang", "CXX": "clang++"}
# For machines of scripts/test_cross.sh, the tests to run and their environment. Only tests run that can find an error of that
# machine: on 64-bit ARM those of code that is compiled per instruction set. In emulation SVE is ten times as slow as NEON, and the
# examples take a minute.
QUICK = ["--suite", "quick", "--suite", "portable"]
WITH_LIBRARIES = {
    "aarch64-linux-gnu": ([*QUICK, "--suite", "kernels", "--no-suite", "targets", "--no-suite", "examples"], {"QEMU_CPU": "cortex-a72"}),
    "i686-linux-gnu": (QUICK, {}),
}
NOT_IN_CI = ["powerpc64le-linux-gnu", "riscv64-linux-gnu"]  # half a minute each, and ARM and z/Architecture find the same errors
ONE_LIBRARY = "-Ddefault_library=shared"  # half the time to compile; the other parts build both
ONLY_TESTS = ["-Dtests=enabled", "-Dgpu=enabled", "-Dbench=disabled", "-Dpython=disabled", "-Dfortran=disabled"]


# Checks that may be skipped, by patterns of their names, with the reason. The list of skipped checks marks all others.
MAY_BE_SKIPPED = {
    "ruff": "Debian's sid may be out of order, or have another minor version",
    "scripts/test_wheel.sh": "Debian's sid may be out of order",
    "*: tests with libraries": "Debian may not have the packages for another machine",
    "build-ci-address-undefined: * / stack *": "instrumented code takes more stack than the library does",
    "build-ci-clang: * -fopenmp is safe": "Clang 14 finds no OpenMP run-time library in Debian 12",
    "build-ci-*threads*": "Clang 14 finds no OpenMP run-time library in Debian 12",
}


class Results:
    def __init__(self):
        self.passed, self.failed, self.failures, self.skipped, self.times = 0, 0, [], [], []

    @contextlib.contextmanager
    def part(self, name):
        """Measures the time of a part."""
        start = time.monotonic()
        yield
        self.times.append((name, time.monotonic() - start))
        print(f"== {name}: {self.times[-1][1] / 60:.1f} minutes", flush=True)

    def add(self, name, ok):
        if ok:
            self.passed += 1
        else:
            self.failed += 1
            self.failures.append(name)
            print(f"FAILED: {name}", flush=True)

    def skip(self, name):
        """Notes a check that was not run."""
        allowed = any(fnmatch.fnmatchcase(name, pattern) for pattern in MAY_BE_SKIPPED)
        self.skipped.append(name if allowed else f"{name} (not in MAY_BE_SKIPPED)")

    def add_report(self, step, log):
        """Adds the results of `meson test`. The log, with a JSON object per line, has the result of each program; the JUnit report
        next to it has the results of its cases, if the program reports cases. A program that fails without a failing case (it
        crashes, exceeds its time, or leaks memory) counts as one more failure."""
        cases = read_cases(log.with_suffix(".junit.xml"))
        for line in log.read_text().splitlines():
            program = json.loads(line)
            name, result = program["name"], program["result"]
            own = cases.get(name, [])
            for case, ended in own:
                if ended == "skipped":
                    self.skip(f"{step}: {name} {case}")
                else:
                    self.add(f"{step}: {name} {case}", ended == "passed")
            if result not in ("OK", "EXPECTEDFAIL", "SKIP") and all(ended != "failed" for _, ended in own):
                self.add(f"{step}: {name}: {result}", False)
            elif not own and result == "SKIP":
                self.skip(f"{step}: {name}")
            elif not own:
                self.add(f"{step}: {name}", True)


def read_cases(report):
    """The cases of each program that reports them: name of the program -> [(name of the case, its outcome)]."""
    cases = {}
    if not report.exists():
        return cases
    for suite in ElementTree.parse(report).getroot().iter("testsuite"):
        # Suites of programs with cases are named after the project and the program; the others have no colon.
        program = suite.get("name").split(".", 1)[-1]
        if ":" in program:
            cases[program] = [(case.get("name"), outcome(case)) for case in suite.iter("testcase")]
    return cases


def outcome(case):
    """The outcome of one case of a JUnit report."""
    if case.find("failure") is not None or case.find("error") is not None:
        return "failed"
    return "passed" if case.find("skipped") is None else "skipped"


def folder_of(name):
    """The build folder of a part. It is next to that of the test command, so that paths are the same and ccache finds its
    results."""
    return ROOT / f"build-ci-{name}"


def status(command, **environment):
    print("+", *command, flush=True)
    return subprocess.run(command, cwd=ROOT, env={**os.environ, **environment}).returncode


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
    before = results.failed
    logs = sorted((folder / "meson-logs").glob("testlog*.json"), key=lambda path: path.stat().st_mtime)
    if logs:
        results.add_report(folder.name, logs[-1])
    if not logs or (not ok and results.failed == before):
        results.add(f"{folder.name}: meson test", False)


def test_command(results):
    """Runs README's test command in a fresh folder, with benchmarks and pages, and with warnings as errors."""
    shutil.rmtree(TEST_COMMAND_BUILD, ignore_errors=True)
    ok = run(["scripts/test.sh"], PW85_SETUP_OPTIONS="--werror -Dbench=enabled -Ddocs=enabled")
    report(results, TEST_COMMAND_BUILD, ok)


def check_format(results):
    results.add("format", run(["clang-format", "--dry-run", "-Werror", *tracked("*.c", "*.cpp", "*.h", "*.hpp")]))


def check_with_libraries(results, machine):
    """Runs the tests for another machine, and adds whether the libraries that they need were available."""
    folder = ROOT / f"build-{machine}"
    shutil.rmtree(folder, ignore_errors=True)
    arguments, environment = WITH_LIBRARIES[machine]
    ok = run(["scripts/test_cross.sh", machine, *arguments], PW85_SETUP_OPTIONS=f"--werror {ONE_LIBRARY}", **environment)
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


def check_platforms(results):
    """Tests the core and the library on the platforms for which Debian has a compiler and an emulator. All platforms run the
    contact problems; those for which Debian has the libraries that tests need run more tests."""
    boost = BUILDS / "boost"  # the headers of Boost, without those of other libraries of this system
    (boost / "include").mkdir(parents=True, exist_ok=True)
    if not (boost / "include/boost").exists():
        (boost / "include/boost").symlink_to("/usr/include/boost")
    options = ["-Dgsl=disabled", *(f"-D{name}=disabled" for name in ("bench", "python", "fortran"))]
    machines = [machine for machine in sorted((ROOT / "scripts/cross").glob("*.ini")) if machine.stem not in NOT_IN_CI]
    with wine() as environment:
        for machine in machines:
            if machine.stem in WITH_LIBRARIES and check_with_libraries(results, machine.stem):
                continue
            if build(results, machine.stem, [f"--cross-file={machine}", *options], {"BOOST_ROOT": str(boost)},
                     ["contact_problems", "portable_headers", "portable_library", "portable_c"]):
                test(results, folder_of(machine.stem), ["--suite", "portable"], **environment)


def tracked(*patterns):
    return subprocess.run(["git", "ls-files", "--", *patterns], cwd=ROOT, check=True, text=True,
                          stdout=subprocess.PIPE).stdout.split()


def check_static(results):
    """Static analysis, beside the compilers' warnings and mypy, which the tests run. The analyser of GCC 12 is only for C, where it
    would see only programs that use the library."""
    scripts = [file for file in tracked("*.sh", ".ci/run", "debian/tests/consumer") if file != "scripts/packages.sh"]
    results.add("shellcheck", run(["shellcheck", "-x", "-s", "sh", "-e", "SC2046", *scripts]))  # unquoted lists of words
    prose = [file for file in tracked() if not file.endswith((".svg", ".png", ".ipynb", ".h5", ".js", ".out", "words.txt", "_pairs.txt"))]
    results.add("codespell", run(["codespell", "-L", "nin,numer", *prose]))
    add_unless_missing(results, "ruff", ["scripts/sid.sh", "ruff", "check"])
    glib = subprocess.run(["pkg-config", "--cflags", "glib-2.0"], check=True, text=True, stdout=subprocess.PIPE).stdout.split()
    for file in tracked("*.c", ":!tests/headers/c89.c"):
        results.add(f"analyzer: {file}", run(["gcc", "-std=c99", "-O2", "-fanalyzer", "-Werror", "-Iinclude",
                                              f"-I{TEST_COMMAND_BUILD}/include", "-D_POSIX_C_SOURCE=200809L",
                                              *glib, "-c", file, "-o", "/dev/null"]))


def check_tidy(results):
    """Runs clang-tidy on each source of the library, with the arguments of the build by clang. A source that is compiled more than
    once is analysed once: as the first of its units, which is for the newest instruction set."""
    folder = folder_of("clang")
    commands = folder / "compile_commands.json"
    units = json.loads(commands.read_text()) if commands.exists() else []
    of_file = {str((folder / unit["file"]).resolve()): unit for unit in reversed(units)}
    ours = sorted(file for file in of_file if Path(file).is_relative_to(ROOT / "src"))
    database = BUILDS / "tidy"
    database.mkdir(parents=True, exist_ok=True)
    (database / "compile_commands.json").write_text(json.dumps([of_file[file] for file in ours]))
    ok = subprocess.run(["xargs", "-P2", "-n1", "clang-tidy", "--quiet", "-p", str(database)], cwd=ROOT, text=True,
                        input="\n".join(ours)).returncode == 0
    results.add("clang-tidy", ok and bool(ours))


def check_debian(results):
    """Builds the Debian packages from the files that git tracks, runs lintian, and uses the unpacked packages in programs."""
    work = BUILDS / "debian"
    shutil.rmtree(work, ignore_errors=True)
    (work / "pw85").mkdir(parents=True)
    run(["cp", "--parents", "-t", str(work / "pw85"), *tracked()])
    ok = subprocess.run(["dpkg-buildpackage", "-b", "-us", "-uc", "-d"], cwd=work / "pw85",
                        env={**os.environ, "PATH": "/usr/bin:/bin", "DEB_BUILD_OPTIONS": "nocheck",
                             "DEB_BUILD_PROFILES": "nocheck"}).returncode == 0
    results.add("debian: packages", ok)
    # lintian expects that the first version of a package closes a bug report that asks for it. There is no such report.
    changes = [str(file) for file in work.glob("*.changes")]
    results.add("debian: lintian", run(["lintian", "--allow-root", "--fail-on=error,warning",
                                        "--suppress-tags=initial-upload-closes-no-bugs", *changes]))
    for package in sorted(work.glob("*.deb")):
        run(["dpkg", "-x", str(package), str(work / "root")])
    results.add("debian: consumer", run(["debian/tests/consumer", str(work / "root")]))


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
    test_some(results, "lammps", ["--suite=lammps"], [*ONLY_TESTS, ONE_LIBRARY, "-Dlammps=enabled", "-Dpython=enabled"], {})


def check_clang(results):
    """Runs the tests that depend on the optimisation of a compiler, with clang. The sanitizers run all tests with clang."""
    suites = ["--suite=quick", "--suite=portable", "--suite=flags"]
    test_some(results, "clang", suites, [*ONLY_TESTS, "-Dgsl=disabled"], CLANG)


def check_sanitizers(results):
    """Runs the tests with sanitizers, by clang, which compiles instrumented code ten times as fast as GCC."""
    options = [*ONLY_TESTS, ONE_LIBRARY, "-Dgsl=disabled", "-Db_lundef=false", "-Doptimization=1", "-Doptimized=false"]
    test_some(results, "address-undefined", ["--no-suite=install", "--no-suite=flags"],
              [*options, "-Db_sanitize=address,undefined"], CLANG, UBSAN_OPTIONS="halt_on_error=1:print_stacktrace=1",
              ASAN_OPTIONS="detect_leaks=1")
    test_some(results, "thread", ["--suite=threads"], [*options, "-Db_sanitize=thread", "-Dopenmp=disabled"], CLANG,
              TSAN_OPTIONS="halt_on_error=1")


def check_all(results):
    parts = {
        "format": check_format,
        "tests": test_command,
        "tutorial": lambda results: results.add("scripts/tutorial.sh", run(["scripts/tutorial.sh"])),
        "wheel": lambda results: add_unless_missing(results, "scripts/test_wheel.sh", ["scripts/test_wheel.sh"]),
        "static": check_static,
        "valgrind": check_valgrind,
        "lammps": check_lammps,
        "clang": check_clang,
        "clang-tidy": check_tidy,
        "platforms": check_platforms,
        "debian": check_debian,
        "abi": check_abi,
        "sanitizers": check_sanitizers,
    }
    for name, check in parts.items():
        with results.part(name):
            check(results)


def main():
    start = time.monotonic()
    results = Results()
    # The parts share a cache of compiled objects. What it ignores does not change an object: warnings are errors in the first part,
    # so that what it compiled has none, and the other is about automatic linking on Windows. Meson's paths of sources are relative.
    os.environ.setdefault("CCACHE_DIR", str(BUILDS / "ccache"))
    os.environ["CCACHE_IGNOREOPTIONS"] = "-Werror -DBOOST_ALL_NO_LIB"
    os.environ.update(CCACHE_NOHASHDIR="1", CCACHE_SLOPPINESS="include_file_mtime,include_file_ctime",
                      CMAKE_C_COMPILER_LAUNCHER="ccache", CMAKE_CXX_COMPILER_LAUNCHER="ccache")  # Meson finds it by itself
    os.environ["PIP_CONFIG_SETTINGS"] = "builddir=build-ci-wheel"  # wheels are built where the relative paths are the same, too
    check_all(results)
    print(f"\n{(time.monotonic() - start) / 60:.0f} minutes: " +
          ", ".join(f"{name} {seconds / 60:.1f}" for name, seconds in results.times))
    for name in results.skipped:
        print(f"SKIPPED: {name}")
    for name in results.failures:
        print(f"FAILED: {name}")
    print(f"{len(results.skipped)} skipped\n{results.passed} passed, {results.failed} failed")
    return 1 if results.failed else 0


if __name__ == "__main__":
    sys.exit(main())
