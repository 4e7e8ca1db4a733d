"""The status codes, from the list in include/pw85/status.h."""

import re
from pathlib import Path

STATUS_H = Path(__file__).resolve().parents[1] / "include" / "pw85" / "status.h"
ENTRY = re.compile(r'X\((\w+), (\w+), (\d+),\s*((?:"[^"]*"\s*)+)\)')


def status_codes():
    """(name in C, name in C++, value, text) for each code."""
    source = STATUS_H.read_text(encoding="utf-8").replace("\\\n", "\n")
    for c_name, cpp_name, value, literals in ENTRY.findall(source):
        yield c_name, cpp_name, value, "".join(re.findall(r'"([^"]*)"', literals))
