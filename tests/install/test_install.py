"""Installs pw85 into a fresh prefix, and builds and runs programs in C99 and C++20 against it in four ways: pkg-config and
the compiler, CMake, Meson with the system dependency, Meson with a subproject; each with shared and static libraries. The headers alone, too, where there is nothing else.

Prints the Test Anything Protocol. Usage: test_install.py SOURCE_DIR
"""

import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
EXPECTED = "mu^2 = 3.36271\nlambda = 0.166859\n"
LIBRARIES_ONLY = [f"-D{name}=disabled" for name in ("tests", "bench", "python", "fortran")]
# How fast the library is does not matter here; unoptimised it takes less time to build.
OPTIONS = [*LIBRARIES_ONLY, "-Doptimization=0", "-Doptimized=false"]
LANGUAGES = {"c": ("CC", "cc", "c99"), "cpp": ("CXX", "c++", "c++20")}


class Failed(Exception):
    pass


def run(*command, cwd=None, **environment):
    """Output of a command that must succeed."""
    arguments = [str(word) for word in command]
    done = subprocess.run(arguments, cwd=cwd, env={**os.environ, **environment}, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    if done.returncode != 0:
        raise Failed(f"{' '.join(arguments)}: status {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


def check_program(program, **environment):
    output = run(program, **environment)
    if output != EXPECTED:
        raise Failed(f"{program} printed {output!r}")


def links_shared_library(program):
    return "libpw85.so" in run("ldd", program)


class Installation:
    def __init__(self, source, work):
        self.source, self.work = source, work
        self.prefix, self.build = work / "prefix", work / "build"
        self.libdir = self.prefix / "lib"

    def install(self):
        """The installation itself, first staged to see that nothing is written outside DESTDIR."""
        run("meson", "setup", self.build, self.source, f"--prefix={self.prefix}", "--libdir=lib", *OPTIONS,
            "-Ddefault_library=both")
        run("meson", "compile", "-C", self.build)
        stage = self.work / "stage"
        run("meson", "install", "--no-rebuild", "-C", self.build, DESTDIR=str(stage))
        if self.prefix.exists():
            raise Failed(f"{self.prefix} was written to in spite of DESTDIR")
        staged = {path.relative_to(stage) for path in stage.rglob("*") if not path.is_dir()}
        run("meson", "install", "--no-rebuild", "-C", self.build)
        root = Path(self.prefix.anchor)
        installed = {path.relative_to(root) for path in self.prefix.rglob("*") if not path.is_dir()}
        if staged != installed:
            raise Failed(f"staged and installed files differ: {sorted(map(str, staged ^ installed))}")

    def check_files(self):
        wanted = [self.libdir / name for name in (
            "libpw85.so", "libpw85.so.3", "libpw85.a", "libpw85_legacy.so", "libpw85_legacy.so.3", "libpw85_legacy.a",
            "pkgconfig/pw85.pc", "pkgconfig/pw85-headers.pc", "pkgconfig/pw85_legacy.pc", "cmake/pw85/pw85Config.cmake",
            "cmake/pw85/pw85ConfigVersion.cmake")]
        wanted += [self.prefix / "include" / name for name in (
            "pw85.h", "pw85_legacy.h", "pw85_zheng.h", "pw85_pre1.h", "pw85/pw85.hpp", "pw85/version.h")]
        wanted.append(self.prefix / "share/pw85/pw85_ref_data.h5")
        missing = [str(path) for path in wanted if not path.exists()]
        if missing:
            raise Failed(f"not installed: {missing}")
        headers = {path.relative_to(self.source / "include") for path in (self.source / "include").rglob("*.h*")
                   if path.suffix in (".h", ".hpp")}
        missing = [str(header) for header in sorted(headers) if not (self.prefix / "include" / header).exists()]
        if missing:
            raise Failed(f"headers not installed: {missing}")

    def check_symbols(self):
        """Shared libraries export what begins with pw85, and no more."""
        for name in ("libpw85.so", "libpw85_legacy.so"):
            lines = run("nm", "--dynamic", "--defined-only", self.libdir / name).splitlines()
            # Weak symbols (W, V) are inline functions of the standard library, which unoptimised builds do not inline.
            symbols = [line.split()[-1] for line in lines if line.split()[-2] not in "WV"]
            # The lock of a critical section, which OpenMP shares by its name.
            foreign = [symbol for symbol in symbols if not symbol.startswith(("pw85", ".gomp_critical_user_pw85"))]
            if foreign or not symbols:
                raise Failed(f"{name} exports {foreign or 'nothing'}")

    def environment(self):
        return {"PKG_CONFIG_PATH": str(self.libdir / "pkgconfig"), "LD_LIBRARY_PATH": str(self.libdir)}

    def project(self, name):
        """A fresh folder with the sources of the consumers."""
        folder = self.work / name
        folder.mkdir()
        for file in ("consumer.c", "consumer.cpp", "CMakeLists.txt"):
            shutil.copy(HERE / file, folder)
        shutil.copy(HERE / "consumer_meson.build", folder / "meson.build")
        shutil.copy(HERE / "consumer_options.txt", folder / "meson_options.txt")
        return folder

    def with_pkg_config(self, kind, language):
        variable, compiler, standard = LANGUAGES[language]
        folder = self.project(f"pkg-config-{kind}-{language}")
        static = ["--static"] if kind == "static" else []
        flags = run("pkg-config", "--cflags", "--libs", *static, "pw85", "pw85_legacy", **self.environment()).split()
        if kind == "static":
            # Both are in one folder: name the archives, leave the rest to the linker.
            flags = [f"-l:lib{flag[2:]}.a" if flag in ("-lpw85", "-lpw85_legacy") else flag for flag in flags]
        program = folder / "consumer"
        command = os.environ.get(variable, compiler).split()
        run(*command, f"-std={standard}", "-pedantic-errors", "-Wall", "-Wextra", "-Werror",
            folder / f"consumer.{language}", "-o", program, *flags)
        self.check(program, kind)

    def with_cmake(self, kind, language):
        folder = self.project(f"cmake-{kind}-{language}")
        build = folder / "build"
        run("cmake", "-G", "Ninja", "-S", folder, "-B", build, f"-DCMAKE_PREFIX_PATH={self.prefix}",
            f"-DPW85_USE_STATIC_LIBS={'ON' if kind == 'static' else 'OFF'}",
            f"-DLANGUAGE={'C' if language == 'c' else 'CXX'}")
        run("cmake", "--build", build)
        self.check(build / "consumer", kind)

    def with_meson(self, kind, language, subproject=False):
        name = f"meson-{'subproject' if subproject else 'system'}-{kind}"
        folder = self.work / name
        if not folder.exists():
            self.project(name)
            if subproject:
                (folder / "subprojects").mkdir()
                (folder / "subprojects/pw85").symlink_to(self.source)
            environment = {} if subproject else self.environment()
            fast_to_build = ["-Dpw85:optimized=false"] if subproject else []
            run("meson", "setup", folder / "build", folder, f"-Ddefault_library={kind}",
                f"-Dsubproject={'true' if subproject else 'false'}", "-Doptimization=0", *fast_to_build, **environment)
            run("meson", "compile", "-C", folder / "build")
        self.check(folder / f"build/consumer_{language}", kind, installed=not subproject)

    def with_meson_subproject(self, kind, language):
        self.with_meson(kind, language, subproject=True)

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
        run(*command, "-std=c++20", folder / "headers.cpp", "-o", folder / "consumer", *flags)
        check_program(folder / "consumer")
        run("cmake", "-G", "Ninja", "-S", folder, "-B", folder / "cmake", f"-DCMAKE_PREFIX_PATH={prefix}")
        run("cmake", "--build", folder / "cmake")
        check_program(folder / "cmake/consumer")
        for subproject in ("false", "true"):
            meson = folder / f"meson-{subproject}"
            run("meson", "setup", meson, folder, f"-Dsubproject={subproject}",
                **(nothing if subproject == "true" else installed))
            run("meson", "compile", "-C", meson)
            check_program(meson / "consumer")

    def optimization(self):
        """The library sets its own level, behind those of build types, of flags of a distribution, and of other projects."""
        ways = {"plain": ["--buildtype=plain"], "debug": ["--buildtype=debug"],
                "own": ["--buildtype=debug", "-Doptimized=false"]}
        for way, options in ways.items():
            build = self.work / f"optimization-{way}"
            run("meson", "setup", build, self.source, *LIBRARIES_ONLY, *options, CXXFLAGS="-O2")
            self.check_level(build, "-O2" if way == "own" else "-O3")
        folder = self.project("optimization-subproject")
        (folder / "subprojects").mkdir()
        (folder / "subprojects/pw85").symlink_to(self.source)
        run("meson", "setup", folder / "build", folder, "--buildtype=debug", "-Dsubproject=true")
        self.check_level(folder / "build", "-O3")

    def check_level(self, build, wanted):
        """Of several levels on a command line, the last one counts."""
        units = 0
        for unit in json.loads((build / "compile_commands.json").read_text()):
            if (build / unit["file"]).resolve().is_relative_to(self.source / "src"):
                units += 1
                levels = [word for word in unit["command"].split() if word.startswith("-O")]
                if levels[-1:] != [wanted]:
                    raise Failed(f"{build}: {unit['file']} is compiled with {levels}, not {wanted}")
        if units == 0:
            raise Failed(f"{build} has no unit of the library")

    def example(self, name, *options):
        """An example, as a project of its own against the installed library."""
        build = self.work / f"example-{name}"
        examples = self.source / "examples"
        run("meson", "setup", build, examples / name, f"-Dpw85_include={self.prefix}/include", *options)
        run("meson", "compile", "-C", build)
        output = run(build / "tutorial", **self.environment())
        if output != (examples / name / "tutorial.txt").read_text():
            raise Failed(f"examples/{name} printed {output!r}")

    def moved(self):
        """The CMake package and the library work from another place."""
        elsewhere = self.work / "elsewhere"
        shutil.copytree(self.prefix, elsewhere, symlinks=True)
        folder = self.project("cmake-moved")
        run("cmake", "-G", "Ninja", "-S", folder, "-B", folder / "build", f"-DCMAKE_PREFIX_PATH={elsewhere}", "-DLANGUAGE=C")
        run("cmake", "--build", folder / "build")
        cache = (folder / "build/CMakeCache.txt").read_text()
        if f"{elsewhere}/lib/cmake/pw85" not in cache:
            raise Failed("the package was found elsewhere")
        check_program(folder / "build/consumer")


def cases(installation):
    yield "install", installation.install
    yield "files", installation.check_files
    yield "symbols", installation.check_symbols
    ways = {"pkg-config": installation.with_pkg_config, "cmake": installation.with_cmake,
            "meson": installation.with_meson, "subproject": installation.with_meson_subproject}
    for way, test in ways.items():
        for kind in ("shared", "static"):
            for language in LANGUAGES:
                yield f"{way}/{kind}/{language}", lambda t=test, k=kind, l=language: t(k, l)
    yield "cmake/moved", installation.moved
    yield "headers", installation.headers_only
    yield "optimization", installation.optimization
    yield "examples/c", lambda: installation.example("c", f"-Dpw85_lib={installation.libdir}")
    yield "examples/cpp", lambda: installation.example("cpp")


def main():
    source = Path(sys.argv[1]).resolve()
    failures = 0
    with tempfile.TemporaryDirectory(prefix="pw85-install-") as folder:
        all_cases = list(cases(Installation(source, Path(folder).resolve())))
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
