# SPDX-License-Identifier: BSD-3-Clause
"""Builds and installs the smallest library, the contact functions alone, by Meson and by CMake, and looks at what is there. Its objects are
those of the build of the tests where there is ccache.

Prints the Test Anything Protocol. Usage: test_parts.py SOURCE_DIR
"""

import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

LARGEST = 1_000_000  # bytes of text of the shared library
OFF = ("geometry", "systems", "simulation")
OF_PARTS = ("pw85_systems.h", "pw85_simulation*.h", "pw85_gpu.h", "pw85/systems*", "pw85/simulation*")
# A consumer of the part that is there, and of one that is not.
PROJECT = """\
cmake_minimum_required(VERSION 3.16)
project(consumer LANGUAGES CXX)
find_package(pw85 3 REQUIRED COMPONENTS {})
add_executable(consumer a.cpp)
target_compile_features(consumer PRIVATE cxx_std_20)
target_link_libraries(consumer PRIVATE pw85::pw85)
"""
PROGRAM = """\
#include <pw85.h>
#include <pw85_batch.h>
#include <pw85/batch.hpp>
#include <pw85/pw85.hpp>
int main()
{
    int yes;
    double const r[3] = {3, 0, 0}, q[6] = {1, 0, 0, 1, 0, 1};
    return pw85_overlap(r, q, q, &yes) + yes;
}
"""


class Failed(Exception):
    pass


def run(*command, succeeds=True, **environment):
    done = subprocess.run([str(word) for word in command], env={**os.environ, **environment}, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)  # fmt: skip
    if (done.returncode == 0) != succeeds:
        raise Failed(f"{' '.join(map(str, command))}: status {done.returncode}\n{done.stdout}")
    return done.stdout


def by_meson(source, work, prefix):
    build = work / "meson"
    options = [f"-D{name}=disabled" for name in ("tests", "bench", "python", "fortran", "docs")]
    run("meson", "setup", build, source, f"--prefix={prefix}", "--libdir=lib", *options, *(f"-D{name}=false" for name in OFF))
    run("meson", "compile", "-C", build)
    run("meson", "install", "--no-rebuild", "-C", build)


def by_cmake(source, work, prefix):
    build = work / "cmake"
    run("cmake", "-G", "Ninja", "-S", source, "-B", build, "-DBUILD_SHARED_LIBS=ON", "-DCMAKE_INSTALL_LIBDIR=lib",
        "-DCMAKE_BUILD_TYPE=Release", *(f"-DPW85_{name.upper()}=OFF" for name in OFF))  # fmt: skip
    run("cmake", "--build", build)
    run("cmake", "--install", build, "--prefix", prefix)


def check_library(prefix):
    library = prefix / "lib/libpw85.so"
    size = int(run("size", library).splitlines()[1].split()[0])
    print(f"# {size} bytes of text")
    if size > LARGEST:
        raise Failed(f"libpw85.so has {size} bytes of text, more than {LARGEST}")
    exported = {line.split()[-1] for line in run("nm", "--dynamic", "--defined-only", library).splitlines()}
    of_parts = [name for name in exported if re.search("neighbors|mesh|_pairs|cell|hard_ellipsoids|distance|triangle|volume|_2d", name)]
    if of_parts or not {"pw85_contact", "pw85_overlap_batch", "pw85_contact_derivatives_batch"} <= exported:
        raise Failed(f"libpw85.so exports {of_parts or 'too little'}")
    there = [path.name for pattern in OF_PARTS for path in (prefix / "include").glob(pattern)]
    if there or not (prefix / "include/pw85_batch.h").exists():
        raise Failed(f"installed headers: {there}")


def check_consumers(work, prefix):
    for component, succeeds in (("contact", True), ("systems", False), ("gpu", False)):
        folder = work / f"consumer-{component}"
        folder.mkdir()
        (folder / "CMakeLists.txt").write_text(PROJECT.format(component))
        (folder / "a.cpp").write_text(PROGRAM)
        text = run("cmake", "-G", "Ninja", "-S", folder, "-B", folder / "build", f"-DCMAKE_PREFIX_PATH={prefix}", succeeds=succeeds)
        if succeeds:
            run("cmake", "--build", folder / "build")
            run(folder / "build/consumer")
        elif f"without the part {component}" not in " ".join(text.split()):
            raise Failed(f"the part {component} is missing, and a project is told: {text}")
    parts = run("pkg-config", "--variable=parts", "pw85", PKG_CONFIG_PATH=str(prefix / "lib/pkgconfig")).strip()
    if parts != "contact":
        raise Failed(f"pkg-config says that pw85 has {parts}")


def check_refusals(source, work):
    """Parts without those that they need, and what needs all parts."""
    for options, message in ((["-Dsystems=false"], "needs the part systems"),
                             (["-Dsimulation=false", "-Dpython=enabled"], "needs all parts")):
        text = run("meson", "setup", work / f"refused{options[-1]}", source, *options, succeeds=False)
        if message not in text:
            raise Failed(f"{options} end in {text}")


def main():
    source = Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory(prefix="pw85-parts-") as folder:
        root = Path(folder)
        cases = [("refused combinations", lambda: check_refusals(source, root))]
        for name, build in (("Meson", by_meson), ("CMake", by_cmake)):
            work = root / name
            work.mkdir()
            prefix = work / "prefix"
            cases += [(f"built by {name}", lambda build=build, work=work, prefix=prefix: build(source, work, prefix)),
                      (f"the library of {name}", lambda prefix=prefix: check_library(prefix)),
                      (f"consumers of {name}", lambda work=work, prefix=prefix: check_consumers(work, prefix))]  # fmt: skip
        print(f"1..{len(cases)}")
        for number, (name, case) in enumerate(cases, 1):
            try:
                case()
                print(f"ok {number} {name}", flush=True)
            except Failed as failure:
                print(f"not ok {number} {name}", *(f"# {line}" for line in str(failure).splitlines()[-40:]), sep="\n", flush=True)


main()
