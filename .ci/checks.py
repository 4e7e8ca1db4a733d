"""The checks of .ci/run: README's two commands, all tests with gcc and clang without warnings, the styles for LAMMPS,
sanitizers, valgrind, format.

Results are counted from what `meson test` writes, so that suites need not be listed here; a step that is no test counts as
one. The last line is "N passed, N failed".
"""

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
TEST_COMMAND_BUILD = ROOT / "build-test"  # where scripts/test.sh builds
CLANG = {"CC": "clang", "CXX": "clang++"}
ONLY_TESTS = ["-Dtests=enabled", "-Dbench=disabled", "-Dpython=disabled", "-Dfortran=disabled"]


class Results:
    def __init__(self):
        self.passed, self.failed, self.failures = 0, 0, []

    def add(self, name, ok):
        if ok:
            self.passed += 1
        else:
            self.failed += 1
            self.failures.append(name)
            print(f"FAILED: {name}", flush=True)

    def add_report(self, step, log):
        """Results of `meson test`: those of each program from the log (a JSON object per line), those of its cases, where
        it reports cases, from the JUnit report next to it. A program that fails in any other way than by a failing case
        (it crashes, exceeds its time, leaks memory) counts as one more failure."""
        cases = read_cases(log.with_suffix(".junit.xml"))
        for line in log.read_text().splitlines():
            program = json.loads(line)
            name, result = program["name"], program["result"]
            ok = result in ("OK", "EXPECTEDFAIL", "SKIP")
            own = cases.get(name, [])
            for case, passed in own:
                self.add(f"{step}: {name} {case}", passed)
            if not ok and all(passed for _, passed in own):
                self.add(f"{step}: {name}: {result}", False)
            elif not own and result != "SKIP":
                self.add(f"{step}: {name}", ok)


def read_cases(report):
    """The cases of each program that reports them: name of the program -> [(name of the case, passed)]."""
    cases = {}
    if not report.exists():
        return cases
    for suite in ElementTree.parse(report).getroot().iter("testsuite"):
        # Suites of programs with cases are named after the project and the program; the others have no colon.
        program = suite.get("name").split(".", 1)[-1]
        if ":" in program:
            cases[program] = [(case.get("name"), case.find("failure") is None and case.find("error") is None)
                              for case in suite.iter("testcase") if case.find("skipped") is None]
    return cases


def run(command, **environment):
    print("+", *command, flush=True)
    return subprocess.run(command, cwd=ROOT, env={**os.environ, **environment}).returncode == 0


def build(results, name, options, environment):
    """Whether a build without warnings succeeds, in a fresh folder."""
    folder = BUILDS / name
    shutil.rmtree(folder, ignore_errors=True)
    ok = run(["meson", "setup", str(folder), *options, "--werror"], **environment) and \
        run(["meson", "compile", "-C", str(folder)])
    results.add(f"{name}: build without warnings", ok)
    return ok


def test(results, folder, arguments=(), **environment):
    ok = run(["meson", "test", "-C", str(folder), "--no-rebuild", "--print-errorlogs", *arguments], **environment)
    report(results, folder, ok)


def report(results, folder, ok):
    """Adds the results of the last `meson test` in a folder, which exited well or not."""
    before = results.failed
    logs = sorted((folder / "meson-logs").glob("testlog*.json"), key=lambda path: path.stat().st_mtime)
    if logs:
        results.add_report(folder.name, logs[-1])
    if not logs or (not ok and results.failed == before):
        results.add(f"{folder.name}: meson test", False)


def test_command(results):
    """Runs README's test command in a fresh folder, with benchmarks and pages, and with warnings as errors; whether it got
    to the tests."""
    shutil.rmtree(TEST_COMMAND_BUILD, ignore_errors=True)
    ok = run(["scripts/test.sh"], PW85_SETUP_OPTIONS="--werror -Dbench=enabled -Ddocs=enabled")
    report(results, TEST_COMMAND_BUILD, ok)
    return (TEST_COMMAND_BUILD / "meson-logs/testlog.json").exists()


def check_format(results):
    files = subprocess.run(["git", "ls-files", "*.c", "*.cpp", "*.h", "*.hpp"], cwd=ROOT, check=True, text=True,
                           stdout=subprocess.PIPE).stdout.split()
    results.add("format", run(["clang-format", "--dry-run", "-Werror", *files]))


def check_platforms(results):
    """The core and the library on the platforms that a compiler and an emulator of Debian serve, over the contact problems."""
    boost = BUILDS / "boost"  # the headers, without those of this system's other libraries
    (boost / "include").mkdir(parents=True, exist_ok=True)
    if not (boost / "include/boost").exists():
        (boost / "include/boost").symlink_to("/usr/include/boost")
    options = ["-Dgsl=disabled", *(f"-D{name}=disabled" for name in ("bench", "python", "fortran"))]
    for machine in sorted((ROOT / "scripts/cross").glob("*.ini")):
        if build(results, machine.stem, [f"--cross-file={machine}", *options], {"BOOST_ROOT": str(boost)}):
            test(results, BUILDS / machine.stem, ["--suite", "portable"], WINEPREFIX=str(BUILDS / "wine"), WINEDEBUG="-all")


def check_all(results):
    check_format(results)
    results.add("scripts/tutorial.sh", run(["scripts/tutorial.sh"]))
    if test_command(results):
        valgrind = "valgrind --quiet --error-exitcode=99 --leak-check=full --errors-for-leak-kinds=definite"
        test(results, TEST_COMMAND_BUILD, ["--suite", "quick", "--wrap", valgrind, "--timeout-multiplier", "20"],
             G_SLICE="always-malloc", PW85_TARGET="avx2")  # valgrind knows no AVX-512
    if build(results, "lammps", [*ONLY_TESTS, "-Dlammps=enabled", "-Dpython=enabled"], {}):
        test(results, BUILDS / "lammps", ["--suite", "lammps"])
    if build(results, "clang", [*ONLY_TESTS, "-Dgsl=disabled"], CLANG):
        test(results, BUILDS / "clang", ["--no-suite", "install"])
    check_platforms(results)
    if build(results, "address-undefined", [*ONLY_TESTS, "-Db_sanitize=address,undefined", "-Doptimization=2",
                                            "-Doptimized=false"], {}):
        test(results, BUILDS / "address-undefined", ["--no-suite", "install", "--timeout-multiplier", "10"],
             UBSAN_OPTIONS="halt_on_error=1:print_stacktrace=1", ASAN_OPTIONS="detect_leaks=1")
    if build(results, "thread", [*ONLY_TESTS, "-Db_sanitize=thread", "-Dopenmp=disabled", "-Doptimization=1",
                                 "-Doptimized=false"], {}):
        test(results, BUILDS / "thread", ["--suite", "threads", "--timeout-multiplier", "10"], TSAN_OPTIONS="halt_on_error=1")


def main():
    start = time.monotonic()
    results = Results()
    check_all(results)
    print(f"\n{(time.monotonic() - start) / 60:.0f} minutes")
    for name in results.failures:
        print(f"FAILED: {name}")
    print(f"{results.passed} passed, {results.failed} failed")
    return 1 if results.failed else 0


if __name__ == "__main__":
    sys.exit(main())
