# SPDX-License-Identifier: BSD-3-Clause
"""Installs pw85 into a fresh prefix, and builds and runs programs in C99 and C++20 against it in four ways: pkg-config and
the compiler, CMake, Meson with the system dependency, Meson with a subproject; each with shared and static libraries. Also: CMake
in whose tree pw85 is built, with the flags that Meson uses; the headers alone, where there is nothing else.

Prints the Test Anything Protocol. Usage: test_install.py SOURCE_DIR BUILD_DIR_OF_TESTS [--whole]
"""

import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from pathlib import Path

HERE = Path(__file__).resolve().parent
EXPECTED = "mu^2 = 3.36271\nlambda = 0.166859\n"
LIBRARIES_ONLY = [f"-D{name}=disabled" for name in ("tests", "bench", "python", "fortran")]
# How fast the library is does not matter here. With ccache the objects are those of the build of the tests; otherwise it takes less
# time to compile unoptimised ones.
UNOPTIMIZED = [] if shutil.which("ccache") else ["-Doptimization=0", "-Doptimized=false"]
OPTIONS = [*LIBRARIES_ONLY, "-Dgpu=disabled", *UNOPTIMIZED]
LIBRARIES = ("pw85_gpu", "pw85_legacy", "pw85")
BEYOND_CONTACT = ("geometry", "systems", "simulation")
WITHOUT_SYSTEMS = [f"-DCMAKE_{language}_FLAGS=-DWITHOUT_SYSTEMS" for language in ("C", "CXX")]
LANGUAGES = {"c": ("CC", "cc", "c99"), "cpp": ("CXX", "c++", "c++20")}


class Failed(Exception):
    pass


def run(*command, cwd=None, **environment):
    """Output of a command that must succeed."""
    arguments = [str(word) for word in command]
    done = subprocess.run(arguments, cwd=cwd, env={**os.environ, **environment}, text=True, capture_output=True)
    if done.returncode != 0:
        raise Failed(f"{' '.join(arguments)}: status {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


def check_program(program, **environment):
    output = run(program, **environment)
    if output != EXPECTED:
        raise Failed(f"{program} printed {output!r}")


def links_shared_library(program):
    return "libpw85.so" in run("ldd", program)


def exported_symbols(library):
    lines = run("nm", "--dynamic", "--defined-only", library).splitlines()
    return [line.split()[-1] for line in lines]


def fields(package, kind):
    """The fields of a file for pkg-config, each with its words. Where there is the static library alone, Meson has no private flags of
    OpenMP, and one for the units of the user."""
    lines = [re.match(r"(\S+?)(?:=|:\s*)(.*)", line) for line in package.read_text().splitlines() if line]
    found = {line[1]: set(line[2].split()) for line in lines}
    if kind == "static":
        found["Libs"] = found.get("Libs", set()) | found.pop("Libs.private", set())
        found["Cflags"] -= {"-fopenmp"}
    return found


def made(source, folder, names):
    """What is no source."""
    return [name for name in names if Path(folder) == source and name.startswith(("build", ".git", "install"))]


def units(build, source):
    """The units of the library with the flags that matter for what they become."""
    of_no_matter = re.compile(r"-[IMWc]|-D_FILE_OFFSET_BITS=|-DBOOST_ALL_NO_LIB|-DNDEBUG|-fdiagnostics-color|-isystem|[^-]")
    found = []
    for unit in json.loads((build / "compile_commands.json").read_text()):
        file = (build / unit["file"]).resolve()
        if file.is_relative_to(source / "src"):
            words = [word for word in shlex.split(unit["command"]) if not of_no_matter.match(word) and word != "-o"]
            found.append((str(file.relative_to(source)), *sorted(set(words))))
    return sorted(found)


def files_below(folder):
    return [path.relative_to(folder) for path in folder.rglob("*") if not path.is_dir()]


class Installation:
    def __init__(self, source, tests_build, work, whole):
        self.source, self.tests_build, self.work, self.whole = source, tests_build, work, whole
        # A build beside the sources has the relative paths of the tests' build, so that ccache finds its objects.
        self.copy = work / "pw85"
        self.prefix, self.build = work / "prefix", self.copy / "build"
        self.libdir = self.prefix / "lib"

    def install(self):
        """The installation itself, first staged to see that nothing is written outside DESTDIR."""
        shutil.copytree(self.source, self.copy, ignore=lambda folder, names: made(self.source, folder, names))
        run("meson", "setup", self.build, self.copy, f"--prefix={self.prefix}", "--libdir=lib", *OPTIONS,
            "-Ddefault_library=both")
        run("meson", "compile", "-C", self.build)
        stage = self.work / "stage"
        run("meson", "install", "--no-rebuild", "-C", self.build, DESTDIR=str(stage))
        if self.prefix.exists():
            raise Failed(f"{self.prefix} was written to in spite of DESTDIR")
        staged = set(files_below(stage))
        run("meson", "install", "--no-rebuild", "-C", self.build)
        root = Path(self.prefix.anchor)
        installed = {path.relative_to(root) for path in self.prefix.rglob("*") if not path.is_dir()}
        self.installed = installed
        if staged != installed:
            raise Failed(f"staged and installed files differ: {sorted(map(str, staged ^ installed))}")

    def check_files(self):
        wanted = [self.libdir / name for name in (
            f"{pattern.replace('*', library)}" for library in LIBRARIES for pattern in (
                "lib*.so", "lib*.so.3", "lib*.a", "pkgconfig/*.pc", "cmake/*/*Config.cmake", "cmake/*/*ConfigVersion.cmake"))]
        wanted.append(self.libdir / "pkgconfig/pw85-headers.pc")
        wanted += [self.prefix / "include" / name for name in (
            "pw85.h", "pw85_grains.h", "pw85_shapes.h", "pw85_batch.h", "pw85_systems.h", "pw85_simulation.h", "pw85_gpu.h",
            "pw85_legacy.h", "pw85_zheng.h", "pw85_pre1.h", "pw85/pw85.hpp", "pw85/version.h")]
        wanted += [self.prefix / "share" / name for name in ("pw85/pw85_ref_data.h5", "doc/pw85/LICENSE")]
        missing = [str(path) for path in wanted if not path.exists()]
        if missing:
            raise Failed(f"not installed: {missing}")
        headers = {path.relative_to(self.source / "include") for path in (self.source / "include").rglob("*.h*")
                   if path.suffix in (".h", ".hpp")}
        include = self.prefix / "include"
        installed = set(files_below(include))
        if installed != headers | {Path("pw85/version.h")}:
            raise Failed(f"headers not installed, or installed and no headers: {sorted(map(str, installed ^ headers))}")

    def check_tags(self):
        """Those who package by Meson's tags lose nothing: each file has one, also of the parts that only the build of the tests has,
        and the libraries that programs load are what `runtime` means."""
        for build in (self.build, self.tests_build):
            plan = json.loads(run("meson", "introspect", "--install-plan", build))
            untagged = [file for files in plan.values() for file, details in files.items() if not details["tag"]]
            if untagged:
                raise Failed(f"without a tag of those who package: {untagged}")
        for tags, wanted in (("runtime", r"libpw85\w*\.so\.3.*"), ("devel", r"(?!libpw85\w*\.so\.3).*"), ("runtime,devel", ".*")):
            stage = self.work / f"stage-{tags}"
            run("meson", "install", "--no-rebuild", "-C", self.build, "--tags", tags, DESTDIR=str(stage))
            staged = set(files_below(stage))
            expected = {path for path in self.installed if re.fullmatch(wanted, path.name)}
            if staged != expected:
                raise Failed(f"installed by the tags {tags}: {sorted(map(str, staged ^ expected))} differ")

    def check_symbols(self):
        """Shared libraries export the functions that Debian's packages list, each with its first version, and nothing else; those
        with which releases are compared are among them."""
        lists = "".join(path.read_text() for path in sorted((self.source / "debian").glob("*.symbols")))
        listed = re.findall(r"^(\w+)\.so\S* .*\n((?: .*\n)+)", lists, re.MULTILINE)
        if sorted(library for library, _ in listed) != ["libpw85", "libpw85_gpu", "libpw85_legacy"]:
            raise Failed(f"debian/*.symbols know {[library for library, _ in listed]}")
        for library, lines in listed:
            names = {line.split("@")[0].strip() for line in lines.splitlines()}
            exported = set(exported_symbols(self.libdir / f"{library}.so"))
            if exported != names:
                raise Failed(f"{library}.so exports {sorted(exported - names)}, which debian/*.symbols do not have, and not "
                             f"{sorted(names - exported)}")
            record = ElementTree.parse(self.source / f"scripts/abi/{library}.abi")
            recorded = {symbol.get("name") for symbol in record.iter("elf-symbol")}
            if not recorded or recorded - exported:
                raise Failed(f"{library}.so does not export {sorted(recorded - exported) or 'anything known'} of scripts/abi")

    def environment(self):
        return {"PKG_CONFIG_PATH": str(self.libdir / "pkgconfig"), "LD_LIBRARY_PATH": str(self.libdir)}

    def project(self, name):
        """A fresh folder with the sources of the consumers."""
        folder = self.work / name
        folder.mkdir()
        for file in ("consumer.c", "consumer.cpp", "user.c", "user_98.cpp", "CMakeLists.txt"):
            shutil.copy(HERE / file, folder)
        shutil.copy(HERE / "consumer_meson.build", folder / "meson.build")
        shutil.copy(HERE / "consumer_options.txt", folder / "meson_options.txt")
        return folder

    def with_pkg_config(self, kind, language):
        variable, compiler, standard = LANGUAGES[language]
        folder = self.project(f"pkg-config-{kind}-{language}")
        static = ["--static"] if kind == "static" else []
        flags = run("pkg-config", "--cflags", "--libs", *static, *LIBRARIES, **self.environment()).split()
        if kind == "static":
            # All are in one folder: name the archives, leave the rest to the linker.
            flags = [f"-l:lib{flag[2:]}.a" if flag[2:] in LIBRARIES else flag for flag in flags]
        program = folder / "consumer"
        command = os.environ.get(variable, compiler).split()
        run(*command, f"-std={standard}", "-pedantic-errors", "-Wall", "-Wextra", "-Werror",
            folder / f"consumer.{language}", "-o", program, *flags)
        self.check(program, kind)

    def with_cmake(self, kind, language, prefix=None, name="cmake-{kind}-{language}", options=()):
        folder = self.project(name.format(kind=kind, language=language))
        build = folder / "build"
        run("cmake", "-G", "Ninja", "-S", folder, "-B", build, f"-DCMAKE_PREFIX_PATH={prefix or self.prefix}",
            f"-DPW85_USE_STATIC_LIBS={'ON' if kind == 'static' else 'OFF'}",
            f"-DLANGUAGE={'C' if language == 'c' else 'CXX'}", *options)
        run("cmake", "--build", build)
        self.check(build / "consumer", kind, installed=prefix is None)

    def with_meson(self, kind, language, subproject=False):
        name = f"meson-{'subproject' if subproject else 'system'}-{kind}"
        folder = self.work / name
        if not folder.exists():
            self.project(name)
            if subproject:
                (folder / "subprojects").mkdir()
                (folder / "subprojects/pw85").symlink_to(self.source)
            options = self.of_subproject(folder) if subproject else []
            environment = {} if subproject else self.environment()
            run("meson", "setup", folder / "build", folder, f"-Ddefault_library={kind}",
                f"-Dsubproject={'true' if subproject else 'false'}", "-Doptimization=0", "-Ddebug=false", *options, **environment)
            run("meson", "compile", "-C", folder / "build")
            if subproject:
                self.check_brent(folder / "build", "brent_boost.cpp")
        self.check(folder / f"build/consumer_{language}", kind, installed=not subproject)

    def within_cmake(self, kind, way):
        """pw85 built in the tree of a project with CMake, and in a shared library of that project, which exports no more than
        its own function."""
        folder = self.project(f"within-cmake-{kind}-{way}")
        shutil.copy(HERE / "within_CMakeLists.txt", folder / "CMakeLists.txt")
        (folder / "pw85").symlink_to(self.source)
        build = folder / "build"
        fast_to_build = ["-DPW85_OPTIMIZED=OFF", "-DPW85_GPU=OFF", f"-DPW85_SIMD={kind == 'shared'}"]
        if not self.whole:
            fast_to_build += [*WITHOUT_SYSTEMS, *(f"-DPW85_{part.upper()}=OFF" for part in BEYOND_CONTACT), "-DCMAKE_UNITY_BUILD=ON"]
        run("cmake", "-G", "Ninja", "-S", folder, "-B", build, *fast_to_build, f"-DFETCH={way == 'fetch'}",
            f"-DBUILD_SHARED_LIBS={kind == 'shared'}", "-DCMAKE_INSTALL_LIBDIR=lib", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON")
        run("cmake", "--build", build)
        self.check_brent(build, "brent_boost.cpp")
        for language in LANGUAGES:
            self.check(build / f"consumer_{language}", kind, installed=False)
        run(build / "consumer_98")
        if exported_symbols(build / "libuser.so") != ["user_overlap"]:
            raise Failed(f"the library of a project exports {exported_symbols(build / 'libuser.so')}")

        run("cmake", "--install", build, "--prefix", folder / "prefix")
        if self.whole:
            self.compare_installed(kind, folder / "prefix")
        for language in LANGUAGES:
            self.with_cmake(kind, language, folder / "prefix", name=f"installed-by-cmake-{kind}-{language}",
                            options=[] if self.whole else WITHOUT_SYSTEMS)

    def compare_installed(self, kind, prefix):
        """CMake installs the files that Meson installs."""
        other_kind = r"lib/\S*\.so(\.\S*)?" if kind == "static" else r"lib/\S*\.a"
        of_meson = {path for path in (str(path) for path in files_below(self.prefix)) if not re.fullmatch(other_kind, path)}
        of_project = r"lib/(cmake/user/.*|libuser\.so|libarchive\.a)|lib/cmake/pw85/pw85Targets-\w+\.cmake"
        of_cmake = {path for path in (str(path) for path in files_below(prefix)) if not re.fullmatch(of_project, path)}
        if of_cmake != of_meson:
            raise Failed(f"only CMake, or only Meson, installs {sorted(of_cmake ^ of_meson)}")

    def readme(self):
        """README's block for CMake, with an installed pw85 and with a copy of it. within_cmake() sees the library of a copy."""
        text = (self.source / "README.md").read_text()
        folder = self.work / "readme"
        folder.mkdir()
        (folder / "CMakeLists.txt").write_text(re.search(r"^```cmake\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)[1])
        for name, target in (("examples", self.source / "examples"), ("pw85", self.source)):
            (folder / name).symlink_to(target)
        printed = re.search(r"^```text\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)[1]
        for build, program, option in (("installed", "pair_c", f"-DCMAKE_PREFIX_PATH={self.prefix}"),
                                       ("copy", "pair_cpp", "-DCMAKE_DISABLE_FIND_PACKAGE_pw85=ON")):
            run("cmake", "-G", "Ninja", "-S", folder, "-B", folder / build, "-DPW85_GPU=OFF", option)
            run("cmake", "--build", folder / build, "--target", program)
            output = run(folder / build / program, **self.environment())
            if output != printed:
                raise Failed(f"README's program {program} printed {output!r}")

    def presets(self):
        listed = re.findall(r'^ +"(\w+)"', run("cmake", "--list-presets", cwd=self.source), re.MULTILINE)
        if listed != ["release", "bsd", "headers"]:
            raise Failed(f"cmake --list-presets knows {listed}")
        run("cmake", "--preset", "headers", "-B", self.work / "preset", cwd=self.source)

    def alone(self):
        """The commands of the chapter on installation that install pw85 with CMake."""
        home = self.work / "home"
        run("sh", "-e", self.source / "docs/installation/cmake.sh", cwd=self.copy, HOME=str(home))
        self.with_cmake("shared", "cpp", home / ".local", name="installed-alone")

    def static_within_shared(self):
        """As before, with the static library that is installed."""
        folder = self.project("static-within-shared")
        library = folder / "libuser.so"
        libraries = run("pkg-config", "--static", "--libs", "pw85", **self.environment()).replace("-lpw85", "-l:libpw85.a")
        run("cc", "-shared", "-fPIC", f"-I{self.prefix}/include", folder / "user.c", "-o", library, *libraries.split())
        if exported_symbols(library) != ["user_overlap"]:
            raise Failed(f"the library of a project exports {exported_symbols(library)}")

    def cmake_flags(self):
        """CMake compiles the units that Meson compiles, with the same flags, as the same version; the library's own level counts, unless
        that is switched off."""
        self.compare_flags("shared", simd=True, gsl=True)
        cmake = self.compare_flags("static", simd=False, gsl=False, optimized=False)
        for library in LIBRARIES:  # not compiled: their names count
            (cmake / f"lib{library}.a").touch()
        run("cmake", "--install", cmake, "--prefix", self.work / "not-compiled")
        self.compare_installed("static", self.work / "not-compiled")
        boost = self.work / "boost/include"  # the headers, without those of this system's other libraries
        boost.mkdir(parents=True)
        (boost / "boost").symlink_to("/usr/include/boost")
        for machine in ("aarch64-linux-gnu", "i686-linux-gnu"):
            compiler = shutil.which(f"{machine}-g++")
            if compiler:
                self.compare_flags(
                    "shared", simd=True, gsl=False, name=machine, environment={"BOOST_ROOT": str(boost.parent)},
                    meson_options=[f"--cross-file={self.source / 'scripts/cross' / machine}.ini"],
                    cmake_options=["-DCMAKE_SYSTEM_NAME=Linux", f"-DCMAKE_SYSTEM_PROCESSOR={machine.split('-')[0]}",
                                   f"-DCMAKE_CXX_COMPILER={compiler}"])

    def compare_flags(self, kind, simd, gsl, optimized=True, name="", environment=None, meson_options=(), cmake_options=()):
        meson, cmake = (self.work / f"flags-{builder}-{kind}-{simd}-{gsl}-{name}" for builder in ("meson", "cmake"))
        environment = {"CXXFLAGS": "-O2", **(environment or {})}  # of a distribution
        off = [f"-D{name}=disabled" for name, wanted in (("simd", simd), ("gsl", gsl)) if not wanted]
        run("meson", "setup", meson, self.source, *LIBRARIES_ONLY, "-Dgpu=disabled", "--buildtype=plain", "--libdir=lib",
            f"-Doptimized={str(optimized).lower()}", f"-Ddefault_library={kind}", *off, *meson_options, **environment)
        run("cmake", "-G", "Ninja", "-S", self.source, "-B", cmake, f"-DBUILD_SHARED_LIBS={kind == 'shared'}",
            f"-DPW85_SIMD={simd}", f"-DPW85_GSL={gsl}", f"-DPW85_OPTIMIZED={optimized}", "-DPW85_GPU=OFF",
            "-DCMAKE_INSTALL_LIBDIR=lib", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON", *cmake_options, **environment)
        for build in (meson, cmake):
            self.check_level(build, "-O3" if optimized else "-O2")

        def macros(header):
            return header.read_text().partition("#define")[2].split()

        for header, of_cmake in (("src/simd/instruction_sets.h", cmake / "kernels/instruction_sets.h"),
                                 ("include/pw85/version.h", cmake / "include/pw85/version.h")):
            if macros(meson / header) != macros(of_cmake):
                raise Failed(f"{header} differs:\n{of_cmake.read_text()}")
        packages = list((meson / "meson-private").glob("*.pc"))
        for package in packages:
            if fields(package, kind) != fields(cmake / "cmake" / package.name, kind):
                raise Failed(f"{package.name} differs:\n{package.read_text()}\n{(cmake / 'cmake' / package.name).read_text()}")
        differing = set(units(meson, self.source)) ^ set(units(cmake, self.source))
        if differing or not units(meson, self.source) or len(packages) != 4:
            raise Failed("\n".join(" ".join(unit) for unit in sorted(differing)))
        return cmake

    def cmake_versions(self):
        folder = self.project("cmake-versions")
        shutil.copy(HERE / "range_CMakeLists.txt", folder / "CMakeLists.txt")
        numbers = re.search(r"version: '(\d+)\.(\d+)\.(\d+)'", (Path(self.source) / "meson.build").read_text())
        major, minor, version = int(numbers[1]), int(numbers[2]), ".".join(numbers.groups())
        for wanted, accepted in ((f"{major}", True), (version, True), (f"{major - 1}", False), (f"{major + 1}", False),
                                 (f"{major}.{minor}...<{major + 1}", True), (f"1...{version}", True), (f"1...<{major}", False),
                                 (f"{major}.{minor + 1}...{major + 1}", False), (f"1...<{version}", False)):
            try:
                run("cmake", "-G", "Ninja", "-S", folder, "-B", folder / wanted.replace("<", "-"), f"-DWANTED={wanted}",
                    f"-DCMAKE_PREFIX_PATH={self.prefix}")
                found = True
            except Failed:
                found = False
            if found != accepted:
                raise Failed(f"find_package(pw85 {wanted}): {'' if found else 'not '}found")

    def cmake_components(self):
        """The parts of the library by name; test_parts.py sees what projects are told where one is missing."""
        folder = self.work / "cmake-components"
        folder.mkdir()
        (folder / "CMakeLists.txt").write_text(
            "cmake_minimum_required(VERSION 3.16)\nproject(components LANGUAGES C)\n"
            "find_package(pw85 3 REQUIRED COMPONENTS headers contact geometry systems simulation gpu legacy)\n"
            "find_package(pw85 3 QUIET COMPONENTS other)\nif(pw85_FOUND)\n  message(FATAL_ERROR found)\nendif()\n")
        run("cmake", "-G", "Ninja", "-S", folder, "-B", folder / "build", f"-DCMAKE_PREFIX_PATH={self.prefix}")
        parts = run("pkg-config", "--variable=parts", "pw85", **self.environment()).strip()
        if parts != "contact,geometry,systems,simulation":
            raise Failed(f"pkg-config says that pw85 has {parts}")

    def meson_via_cmake(self):
        folder = self.project("meson-via-cmake")
        shutil.copy(HERE / "via_cmake_meson.build", folder / "meson.build")
        run("meson", "setup", folder / "build", folder, f"-Dcmake_prefix_path={self.prefix}", "-Ddebug=false")
        run("meson", "compile", "-C", folder / "build")
        for language in LANGUAGES:
            self.check(folder / f"build/consumer_{language}", "shared")

    def with_meson_subproject(self, kind, language):
        self.with_meson(kind, language, subproject=True)

    def of_subproject(self, folder):
        """Options of what is quick to compile: the contact functions alone, some sources in each unit, or everything. Functions for GPUs
        need systems."""
        options = ["-Dpw85:optimized=false", "-Dpw85:simd=disabled", "-Dpw85:gpu=disabled"]
        if not self.whole:
            options += ["-Dpw85:joined=true", *(f"-Dpw85:{part}=false" for part in BEYOND_CONTACT)]
            options += [f"-D{language}_args=-DWITHOUT_SYSTEMS" for language in LANGUAGES]
            build = folder / "meson.build"
            build.write_text(build.read_text().replace("'pw85_gpu', ", ""))
        return options

    def check(self, program, kind, installed=True):
        check_program(program, **(self.environment() if installed else {}))
        if links_shared_library(program) != (kind == "shared"):
            raise Failed(f"{program} links the wrong kind of library: not {kind}")

    def headers_only(self):
        """Where there is no GSL, nor anything else, the headers can be installed, and used in every way."""
        prefix, build = self.work / "headers", self.work / "build-headers"
        nothing = {"PKG_CONFIG_LIBDIR": str(self.work / "nowhere"), "PKG_CONFIG_PATH": ""}
        run("meson", "setup", build, self.source, f"--prefix={prefix}", "--libdir=lib", "-Dlibrary=false", **nothing)
        run("meson", "install", "-C", build, **nothing)
        installed = {**nothing, "PKG_CONFIG_PATH": str(prefix / "lib/pkgconfig")}
        folder = self.work / "headers-only"
        (folder / "subprojects").mkdir(parents=True)
        (folder / "subprojects/pw85").symlink_to(self.source)
        shutil.copy(HERE / "headers.cpp", folder)
        shutil.copy(HERE / "headers_CMakeLists.txt", folder / "CMakeLists.txt")
        shutil.copy(HERE / "headers_meson.build", folder / "meson.build")
        (folder / "meson_options.txt").write_text("option('subproject', type: 'boolean')\n")

        flags = run("pkg-config", "--cflags", "--libs", "pw85-headers", **installed).split()
        command = os.environ.get("CXX", "c++").split()
        run(*command, "-std=c++20", "-DALL_HEADERS", folder / "headers.cpp", "-o", folder / "consumer", *flags)
        check_program(folder / "consumer")
        (folder / "pw85").symlink_to(self.source)
        without = [f"-DCMAKE_DISABLE_FIND_PACKAGE_{package}=ON" for package in ("GSL", "Boost", "OpenMP", "Python3")]
        for way in (f"-DCMAKE_PREFIX_PATH={prefix}", "-DFETCH=ON"):
            build = folder / f"cmake-{way == '-DFETCH=ON'}"
            run("cmake", "-G", "Ninja", "-S", folder, "-B", build, "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON", way, *without)
            run("cmake", "--build", build)
            check_program(build / "consumer")
            run("cmake", "--install", build, "--prefix", folder / build.name / "prefix")
            words = json.loads((build / "compile_commands.json").read_text())[0]["command"].split()
            if "-isystem" not in words or any(word.startswith("-I") for word in words):
                raise Failed(f"the compiler warns of the headers in the units of others: {words}")
        for subproject in ("false", "true"):
            meson = folder / f"meson-{subproject}"
            run("meson", "setup", meson, folder, f"-Dsubproject={subproject}", "-Ddebug=false",
                **(nothing if subproject == "true" else installed))
            run("meson", "compile", "-C", meson)
            check_program(meson / "consumer")

    def optimization(self):
        """The library sets its own level, behind that of the build type of another project; cmake_flags() sees those of a
        distribution. This project asks for GSL."""
        folder = self.project("subproject-debug")
        (folder / "subprojects").mkdir()
        (folder / "subprojects/pw85").symlink_to(self.source)
        build = folder / "build"
        run("meson", "setup", build, folder, "-Dsubproject=true", "-Dpw85:gpu=disabled", "-Dpw85:gsl=enabled", "--buildtype=debug")
        self.check_level(build, "-O3")
        self.check_brent(build, "brent_gsl.cpp")

    def check_brent(self, build, wanted):
        """Other projects have GSL, which is under the GPL, only if they ask for it."""
        lists = (build / "compile_commands.json", *build.rglob("unity_*.cxx"))
        found = {name for path in lists for name in re.findall(r"/(brent_(?:boost|gsl)\.cpp)\b", path.read_text())}
        if found != {wanted}:
            raise Failed(f"{build} has {found}, not {wanted}")

    def without_brent(self):
        """Without GSL and Boost, both are named."""
        nothing = self.work / "nothing"
        nothing.mkdir()
        meson = ["meson", "setup", self.work / "no-brent-meson", self.source, *LIBRARIES_ONLY, "-Dgpu=disabled", "-Dgsl=disabled"]
        cmake = ["cmake", "-S", self.source, "-B", self.work / "no-brent-cmake", "-DPW85_GPU=OFF", "-DCMAKE_DISABLE_FIND_PACKAGE_GSL=ON",
                 "-DCMAKE_DISABLE_FIND_PACKAGE_Boost=ON"]
        for command in (meson, cmake):
            done = subprocess.run([str(word) for word in command], env={**os.environ, "BOOST_ROOT": str(nothing)}, text=True,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            if done.returncode == 0 or not all(package in done.stdout for package in ("libgsl-dev", "libboost-dev")):
                raise Failed(f"{command[0]} without GSL and Boost: status {done.returncode}\n{done.stdout}")
        printed = run("cmake", "-S", self.source, "-B", self.work / "no-gsl-cmake", "-DPW85_GPU=OFF", "-DPW85_GSL=ON",
                      "-DCMAKE_DISABLE_FIND_PACKAGE_GSL=ON")
        if "GSL was not found" not in printed:
            raise Failed(f"CMake takes Boost in place of GSL without a word:\n{printed}")

    def check_level(self, build, wanted):
        """Of several levels on a command line, the last one counts. Code in n dimensions is compiled for its size."""
        units = 0
        for unit in json.loads((build / "compile_commands.json").read_text()):
            if (build / unit["file"]).resolve().is_relative_to(self.source / "src"):
                units += 1
                levels = [word for word in unit["command"].split() if word.startswith("-O")]
                is_compact = Path(unit["file"]).parent.name in ("any_dimension", "enclosing")
                if levels[-1:] != ["-O2" if is_compact else wanted]:
                    raise Failed(f"{build}: {unit['file']} is compiled with {levels}, not {wanted}")
        if units == 0:
            raise Failed(f"{build} has no unit of the library")

    def example(self, name, *options):
        """An example, as a project of its own against the installed library."""
        build = self.work / f"example-{name}"
        examples = self.source / "examples"
        run("meson", "setup", build, examples / name, f"-Dpw85_include={self.prefix}/include", "-Ddebug=false", *options)
        run("meson", "compile", "-C", build, "tutorial")
        output = run(build / "tutorial", **self.environment())
        if output != (examples / name / "tutorial.txt").read_text():
            raise Failed(f"examples/{name} printed {output!r}")

    def moved(self):
        """The packages for CMake and pkg-config and the library work from another place."""
        elsewhere = self.work / "elsewhere"
        shutil.copytree(self.prefix, elsewhere, symlinks=True)
        folder = self.project("cmake-moved")
        run("cmake", "-G", "Ninja", "-S", folder, "-B", folder / "build", f"-DCMAKE_PREFIX_PATH={elsewhere}", "-DLANGUAGE=C")
        run("cmake", "--build", folder / "build")
        cache = (folder / "build/CMakeCache.txt").read_text()
        if f"{elsewhere}/lib/cmake/pw85" not in cache:
            raise Failed("the package was found elsewhere")
        check_program(folder / "build/consumer")
        for package in (*LIBRARIES, "pw85-headers"):
            flags = run("pkg-config", "--cflags", "--libs", package, PKG_CONFIG_PATH=str(elsewhere / "lib/pkgconfig"))
            if str(self.prefix) in flags or str(elsewhere) not in flags:
                raise Failed(f"pkg-config knows {package} at {flags}")


def cases(installation):
    """All cases, or those that compile less: within CMake and as a subproject once instead of twice, the contact functions alone."""
    whole = installation.whole
    yield "install", installation.install
    yield "files", installation.check_files
    yield "tags", installation.check_tags
    yield "symbols", installation.check_symbols
    ways = {"pkg-config": installation.with_pkg_config, "cmake": installation.with_cmake,
            "meson": installation.with_meson, "subproject": installation.with_meson_subproject}
    for way, test in ways.items():
        for kind in ("shared", "static") if way != "subproject" or whole else ("static",):
            for language in LANGUAGES:
                yield f"{way}/{kind}/{language}", lambda t=test, k=kind, l=language: t(k, l)
    yield "moved", installation.moved
    for kind, way in (("static", "fetch"), ("shared", "subdirectory"))[: 2 if whole else 1]:
        yield f"cmake/{way}", lambda k=kind, w=way: installation.within_cmake(k, w)
    yield "cmake/readme", installation.readme
    yield "cmake/presets", installation.presets
    if whole:
        yield "cmake/alone", installation.alone
    yield "cmake/flags", installation.cmake_flags
    yield "cmake/versions", installation.cmake_versions
    yield "cmake/components", installation.cmake_components
    yield "meson/cmake", installation.meson_via_cmake
    yield "static within shared", installation.static_within_shared
    yield "headers", installation.headers_only
    yield "optimization", installation.optimization
    yield "without GSL and Boost", installation.without_brent
    yield "examples/c", lambda: installation.example("c", f"-Dpw85_lib={installation.libdir}")
    yield "examples/cpp", lambda: installation.example("cpp", f"-Dpw85_lib={installation.libdir}")


def main():
    source, tests_build = (Path(word).resolve() for word in sys.argv[1:3])
    failures = 0
    with tempfile.TemporaryDirectory(prefix="pw85-install-") as folder:
        all_cases = list(cases(Installation(source, tests_build, Path(folder).resolve(), "--whole" in sys.argv)))
        print(f"1..{len(all_cases)}", flush=True)
        for number, (name, case) in enumerate(all_cases, 1):
            try:
                case()
                print(f"ok {number} {name}", flush=True)
            except Failed as failure:
                failures += 1
                print(f"not ok {number} {name}", flush=True)
                for line in str(failure).splitlines():
                    print(f"# {line}", flush=True)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
