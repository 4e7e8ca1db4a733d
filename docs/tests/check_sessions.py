"""Whether sessions at Python's prompt in the pages go as they say. Usage: check_sessions.py FOLDER

Each page is one session, in the folder of the page. Pages run one after the other, in processes of their own, which have NumPy and the
package from the start.
"""

import doctest
import os
import sys
import tempfile
from pathlib import Path

import numpy as np
import pypw85  # noqa: F401

np.set_printoptions(legacy="1.21")  # numbers are printed bare, as NumPy did before 2.0


def run(page):
    """Runs the session of a page in a copy of its folder, so that it may write files."""
    with tempfile.TemporaryDirectory(prefix="pw85-session-") as folder:
        for other in page.parent.glob("*.dump"):
            (Path(folder) / other.name).write_bytes(other.read_bytes())
        os.chdir(folder)
        failed, attempted = doctest.testfile(str(page), module_relative=False, encoding="utf-8")
        os.chdir("/")
    print(f"{page}: {attempted} lines, {failed} failed")
    return 1 if failed or not attempted else 0


def run_apart(page):
    """Runs the session of a page in a copy of this process, and returns its exit status."""
    sys.stdout.flush()
    child = os.fork()
    if child == 0:
        sys.exit(run(page))
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])


def main():
    path = Path(sys.argv[1]).resolve()
    pages = [page for page in sorted(path.rglob("*.rst")) if ">>> " in page.read_text(encoding="utf-8")]
    codes = [run_apart(page) for page in pages]
    return 1 if any(codes) or len(pages) < 5 else 0


sys.exit(main())
