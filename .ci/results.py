# SPDX-License-Identifier: BSD-3-Clause
"""The results of checks: what passed, failed and was skipped, and how long each step took. Results of tests are counted from the
logs of `meson test`, so that no list of tests is needed here. A step that is not a test counts as one result."""

import fnmatch
import json
import re
import xml.etree.ElementTree as ElementTree

# Checks that may be skipped, by patterns of their names, with the reason. The list of skipped checks marks all others.
MAY_BE_SKIPPED = {
    "ruff": "Debian's sid may be out of order, or have another minor version",
    "scripts/test_wheel.sh": "Debian's sid may be out of order",
    "*: tests with libraries": "Debian may not have the packages for another machine",
    "build-ci-address-undefined: * / stack *": "instrumented code takes more stack than the library does",
    "build-ci-clang: * -fopenmp is safe": "Clang 14 finds no OpenMP run-time library in Debian 12",
    "*test_lock_stays_off": "Debian's Python always has the global lock",
    "*test_mujoco.py::test_mujoco": "Debian has no package of MuJoCo",
    "*test_lammps_reads_and_writes_data": "LAMMPS is installed for the part lammps only",
    "*test_equation_of_state.py::test_same_bits*": "sines of NumPy have other last bits on processors without AVX-512",
    "build-ci-*threads*": "Clang 14 finds no OpenMP run-time library in Debian 12",
}


class Results:
    def __init__(self, passed=0, failures=(), skipped=(), steps=()):
        self.passed, self.failures, self.skipped, self.steps = passed, list(failures), list(skipped), list(steps)

    def add(self, name, ok, reason=""):
        """Counts a result. The reason of a failure stands in indented lines below its name."""
        if ok:
            self.passed += 1
        else:
            self.failures.append(name + reason)
            print(f"FAILED: {name}{reason}", flush=True)

    def skip(self, name):
        """Notes a check that was not run."""
        allowed = any(fnmatch.fnmatchcase(name, pattern) for pattern in MAY_BE_SKIPPED)
        self.skipped.append(name if allowed else f"{name} (not in MAY_BE_SKIPPED)")

    def add_all(self, other):
        self.passed += other.passed
        self.failures += other.failures
        self.skipped += other.skipped
        self.steps += other.steps

    def add_report(self, step, log):
        """Adds the results of `meson test`. The log, with a JSON object per line, has the result of each program; the JUnit report
        next to it has the results of its cases, if the program reports cases. A program that fails without a failing case (it
        crashes, exceeds its time, or leaks memory) counts as one more failure."""
        cases = read_cases(log.with_suffix(".junit.xml"))
        for line in log.read_text().splitlines():
            program = json.loads(line)
            name, result = program["name"], program["result"]
            self.steps.append((f"{step}: {name}", program["duration"]))
            own = cases.get(name, [])
            for case, ended in own:
                if ended == "skipped":
                    self.skip(f"{step}: {name} {case}")
                else:
                    self.add(f"{step}: {name} {case}", ended == "passed", comments(program.get("stdout", ""), case))
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


def comments(output, case):
    """The last ten comments that a program in the Test Anything Protocol prints about a case, as indented lines: those after its
    result or, if there are none, as GLib has it, those before it. GLib's marks of groups of tests say nothing of a case."""
    results = [(match.group(1).strip(), match.span()) for match in re.finditer(r"^(?:not )?ok (.*)$", output, re.MULTILINE)]
    place = next((k for k, (result, _) in enumerate(results) if result.startswith(case)), None)
    if place is None:
        return ""
    start, end = results[place][1]
    before = output[results[place - 1][1][1] if place > 0 else 0 : start]
    after = output[end : results[place + 1][1][0] if place + 1 < len(results) else len(output)]
    own, others = (re.findall(r"^# ?(?!Start of|End of)(.+)$", text, re.MULTILINE) for text in (after, before))
    return "".join(f"\n    {line}" for line in (own or others)[-10:])


def outcome(case):
    """The outcome of one case of a JUnit report."""
    if case.find("failure") is not None or case.find("error") is not None:
        return "failed"
    return "passed" if case.find("skipped") is None else "skipped"
