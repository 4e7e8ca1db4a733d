# SPDX-License-Identifier: BSD-3-Clause
"""What the C++ headers say to compilers that they cannot work with, in the Test Anything Protocol.

One message that names the cure for an older standard and for arithmetic that is not that of IEEE 754, and the first one
does for integers. Nothing for the flags that the manual calls safe, with which its program prints what it shows. Usage:
check_requirements.py SOURCE_DIR BUILT_INCLUDE_DIR PROGRAM COMPILER..., with that program as the library's flags make it.
"""

import os
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

ENTRIES = ["pw85/pw85.hpp", "pw85/batch.hpp", "pw85/systems.hpp", "pw85/history/legacy.hpp", "pw85/history/zheng.hpp"]
INTEGERS = {
    "a vector of integers": "pw85::Vector const v{1, 0, 0}; (void)v;",
    "a spheroid of integers": "(void)pw85::spheroid(1, 2, pw85::Vector{0, 0, 1});",
    "an ellipse of integers": "(void)pw85::ellipse(1, 2, 0);",
    "a form of integers": "pw85::SymmetricMatrix<int, 3> const q{1, 0, 0, 1, 0, 1}; (void)q;",
    "a vector of truth values": "pw85::Vector<bool, 2> const v{true, false}; (void)v;",
}


def run_program(program):
    """By the emulator, if any, that Meson names."""
    wrapper = shlex.split(os.environ.get("MESON_EXE_WRAPPER", ""))
    return subprocess.run([*wrapper, str(program)], text=True, stdout=subprocess.PIPE)


class Compiler:
    def __init__(self, command, includes, work):
        self.command = [*command, *(f"-I{folder}" for folder in includes)]
        self.work = work
        self.is_gcc = "__clang__" not in self.macros()

    def macros(self):
        return subprocess.run([*self.command, "-dM", "-E", "-x", "c++", "/dev/null"], check=True, text=True,
                              stdout=subprocess.PIPE).stdout

    def run(self, *arguments):
        return subprocess.run([*self.command, *arguments], text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)

    def runs(self, flag):
        """Whether the libraries that a flag stands for are installed, where programs run."""
        source, program = self.work / "empty.cpp", self.work / "empty"
        source.write_text("int main() {}\n")
        return self.run(flag, str(source), "-o", str(program)).returncode == 0 and run_program(program).returncode == 0

    def compile(self, text, *flags):
        source = self.work / "unit.cpp"
        source.write_text(text)
        return self.run(*flags, "-fsyntax-only", str(source))


def errors(done):
    return [line for line in done.stdout.splitlines() if "error:" in line]


def refused(done, cure, most=1):
    """Whether the first of so many errors names the cure, besides that of stopping there."""
    lines = [line for line in errors(done) if "pw85/stop" not in line]
    return done.returncode != 0 and 1 <= len(lines) <= most and cure in lines[0], done.stdout


def accepted(done):
    return done.returncode == 0, done.stdout


def prints(program, page):
    """Whether the program of the manual prints what the manual shows."""
    ran = run_program(program)
    return ran.returncode == 0 and ran.stdout == (page / "contact.out").read_text(), ran.stdout


def prints_with(compiler, flags, page):
    program = compiler.work / "program"
    built = compiler.run("-std=c++20", *flags, str(page / "contact.cpp"), "-o", str(program))
    return prints(program, page) if built.returncode == 0 else (False, built.stdout)


def is_alone(flag):
    """Whether a flag cannot be with others: the other levels, and what makes other programs."""
    return flag != "-O2" and flag.startswith(("-O", "-fsanitize"))


def safe_flags(compiler, page):
    """Flags that go together are tested together, optimised, where they have effects; one by one if that fails, to name the one. The
    last of two that exclude each other counts: the library has the first one, -ffp-contract=off."""
    flags = (page / "safe.txt").read_text().split()
    missing = {flag for flag in flags if not compiler.runs(flag)}
    for flag in missing:
        yield f"{flag} is safe # SKIP the compiler lacks its library", (True, "")
    flags = [flag for flag in flags if flag not in missing]
    together = [flag for flag in flags if not is_alone(flag)]
    result = prints_with(compiler, together, page)
    if result[0]:
        yield f"{' '.join(together)} are safe", result
    for flag in flags:
        if is_alone(flag) or not result[0]:
            yield f"{flag} is safe", prints_with(compiler, [flag], page)
    if not result[0]:
        yield "they are safe together", result


def cases(compiler, program, page):
    yield "the flags of the library", prints(program, page)
    include_all = "".join(f"#include <{entry}>\n" for entry in ENTRIES)
    for entry in ENTRIES:
        for standard in ("c++11", "c++17"):
            done = compiler.compile(f"#include <{entry}>\n", f"-std={standard}")
            yield f"{entry} in {standard}", refused(done, "-std=c++20")
    # Each header alone in this standard: tests/headers.
    yield "all of them in c++20", accepted(compiler.compile(include_all, "-std=c++20"))
    others = ["-funsafe-math-optimizations", "-freciprocal-math"] if compiler.is_gcc else []
    flags = [*(page / "refused.txt").read_text().split(), *others]
    for entry in ENTRIES:
        done = compiler.compile(f"#include <{entry}>\n", "-std=c++20", flags[0])
        yield f"{entry} refuses {flags[0]}", refused(done, "-ffast-math")
    # That nothing follows the message is seen above, and below that the headers can be compiled with these flags.
    for flag in flags[1:]:
        done = compiler.compile(f"#include <{ENTRIES[0]}>\n", "-std=c++20", "-Wfatal-errors", flag)
        yield f"{flag} is refused", refused(done, "-ffast-math")
    allowed = compiler.compile("#define PW85_ALLOW_FAST_MATH\n" + include_all, "-std=c++20", *flags)
    yield "all of them are allowed", accepted(allowed)
    for name, statement in INTEGERS.items():
        text = f"#include <pw85/pw85.hpp>\nint main() {{ {statement} }}\n"
        yield name, refused(compiler.compile(text, "-std=c++20"), "write 1.0, not 1", most=3)
    yield from safe_flags(compiler, page)


def main():
    source, built_include, program, *command = sys.argv[1:]
    number = 0
    with tempfile.TemporaryDirectory(prefix="pw85-flags-") as work:
        compiler = Compiler(command, [Path(source) / "include", built_include], Path(work))
        for number, (name, (ok, output)) in enumerate(cases(compiler, program, Path(source) / "docs/flags"), 1):
            print(f"{'ok' if ok else 'not ok'} {number} {name}", flush=True)
            if not ok:
                print("\n".join(f"# {line}" for line in output.splitlines()), flush=True)
    print(f"1..{number}")


main()
