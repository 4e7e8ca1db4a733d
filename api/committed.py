"""Files that are made from the headers and committed, for builds without the generators. They are written here, or compared."""

import sys
from pathlib import Path

SOURCE = Path(__file__).resolve().parent.parent


def write_or_compare(path, text, check):
    """Writes a file of the source tree; with "check" ends the program with an error if the file differs."""
    if check not in (None, "check"):
        sys.exit(f"{check}: the only option is check")
    if not check:
        path.write_text(text, encoding="utf-8")
    elif path.read_text(encoding="utf-8") != text:
        sys.exit(f"{path.relative_to(SOURCE)} is not what api/{Path(sys.argv[0]).name} makes of the headers: make it anew")
