"""Runs a program, by Meson's emulator if there is one, and compares what it prints with a file.
Usage: check_output.py EXPECTED PROGRAM [ARGUMENT...]"""

import difflib
import os
import shlex
import subprocess
import sys
from pathlib import Path

expected = Path(sys.argv[1]).read_text(encoding="utf-8")
emulator = shlex.split(os.environ.get("MESON_EXE_WRAPPER", ""))
done = subprocess.run([*emulator, *sys.argv[2:]], stdout=subprocess.PIPE, text=True, encoding="utf-8")
sys.stdout.writelines(difflib.unified_diff(expected.splitlines(True), done.stdout.splitlines(True),
                                           "expected", "printed"))
sys.exit(done.returncode or done.stdout != expected)
