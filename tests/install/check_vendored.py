# SPDX-License-Identifier: BSD-3-Clause
"""Whether the crate pw85-sys compiles the library with the flags of Meson, but for those of hardening and of threads.

    check_vendored.py BUILD_DIR

runs the build script of the crate, which is compiled by rustc, with a compiler that notes its arguments and compiles nothing. BUILD_DIR is
a build of Meson without GSL, of which nothing but its compile_commands.json is read.
"""

import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

from test_install import units

SOURCE = Path(__file__).resolve().parents[2]
CRATE = SOURCE / "rust/pw85-sys"
NOT_OF_CRATES = {"-fstack-protector-strong", "-fcf-protection", "-mbranch-protection=standard", "-D_FORTIFY_SOURCE=2", "-fopenmp"}
PARTS = ("contact", "geometry")
COMPILER = """\
#!/bin/sh
case "$*" in *-fsyntax-only*) exec c++ "$@" ;; esac
printf '%s\\n' "$*" >>{log}
for object; do :; done
: >"$object"
"""


def output_of(*command, environment=None):
    return subprocess.run(command, check=True, capture_output=True, text=True, env=environment).stdout


def noted_by_compiler(folder):
    """The command lines of the build script."""
    compiler, log, script = folder / "c++", folder / "log", folder / "build"
    compiler.write_text(COMPILER.format(log=log))
    compiler.chmod(0o755)
    version = {f"CARGO_PKG_VERSION{part}": "0" for part in ("", "_MAJOR", "_MINOR", "_PATCH")}  # read here and by the script
    output_of("rustc", "--edition=2021", "-o", script, CRATE / "build.rs", environment=os.environ | version)
    host = next(line.split()[1] for line in output_of("rustc", "-vV").splitlines() if line.startswith("host: "))
    environment = {name: value for name, value in os.environ.items() if name != "DOCS_RS" and not name.startswith(("CXX", "AR"))} | version
    environment |= {"CARGO_FEATURE_VENDORED": "1", "CARGO_MANIFEST_DIR": str(CRATE), "OUT_DIR": str(folder), "TARGET": host,
                    "CARGO_CFG_TARGET_ARCH": host.partition("-")[0], "CXX": str(compiler), "AR": "true"}  # fmt: skip
    subprocess.run([script], check=True, env=environment, stdout=subprocess.DEVNULL)
    return log.read_text().splitlines()


def units_of_crate(folder):
    """The units of the crate with their flags, as those of a build of Meson."""
    commands = [{"file": line.split()[line.split().index("-c") + 1], "command": f"c++ {line}"} for line in noted_by_compiler(folder)]
    (folder / "compile_commands.json").write_text(json.dumps(commands))
    return set(units(folder, SOURCE))


def units_of_meson(build):
    """The units of the parts that the crate declares."""
    lines = (SOURCE / "src/sources.txt").read_text().splitlines()
    wanted = {"src/brent/brent_boost.cpp", *(f"src/{line.split()[1]}" for line in lines if line.split()[0] in PARTS)}
    listed = [(name, flags) for name, *flags in units(build, SOURCE) if name in wanted]
    return {(name, *(flag for flag in flags if flag not in NOT_OF_CRATES)) for name, flags in listed}


def main(build):
    with tempfile.TemporaryDirectory() as name:
        crate, meson = units_of_crate(Path(name)), units_of_meson(Path(build).resolve())
    for unit in sorted(crate - meson):
        print("the crate alone:", *unit)
    for unit in sorted(meson - crate):
        print("Meson alone:", *unit)
    print(f"{len(crate)} units of the crate, {len(crate ^ meson)} differ")
    return 1 if crate != meson or not crate else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
