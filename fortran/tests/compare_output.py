"""Runs a program and compares what it prints with a file: compare_output.py PROGRAM EXPECTED."""

import difflib
import subprocess
import sys
from pathlib import Path

program, expected_path = sys.argv[1:]
actual = subprocess.run([program], check=True, capture_output=True, text=True).stdout.splitlines()
expected = Path(expected_path).read_text(encoding="utf-8").splitlines()
difference = list(difflib.unified_diff(expected, actual, "expected", "actual", lineterm=""))
print("\n".join(difference))
sys.exit(1 if difference else 0)
