# SPDX-License-Identifier: BSD-3-Clause
"""The command ``pw85``.

Exit statuses: 0 no overlaps, 1 overlaps, 2 invalid input or command line, 130 interrupted, 141 if the reader of a pipe has ended.
"""

from __future__ import annotations

import os
import signal
import sys
import threading
import warnings
from typing import Any

import click

from .._core import version
from ..formats import printable
from ._interruption import interrupt, is_interrupted
from ._progress import say
from .check import check
from .convert import convert
from .draw import draw
from .mc import mc
from .pack import pack, relax
from .plot import plot


@click.group(
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 110},
    epilog="pw85 COMMAND --help shows the options of a command, and examples.",
)
@click.version_option(version(), prog_name="pw85")
def pw85() -> None:
    """Check systems of ellipsoids for overlaps, draw and convert their files, make packings, and simulate hard ellipsoids."""


# For --help. A test runs them.
_EXAMPLES = {
    check: ["grains.xyz", "run.dump --frames 0:100:10 --csv contacts.csv --below 1.2", "run.dump --workers 4"],
    draw: ["grains.xyz grains.png --contacts", "run.dump last.html --frames -1"],
    plot: ["run.dump distributions.png --reach 1.5"],
    convert: ["run.dump last.data --frames -1", "centers.csv spheres.vtk --shape 0.5,0.5,0.5 --cell 8,8,8"],
    pack: [
        "packing.data -n 100 --axes 1,1,2 --axes 1.5,1.5,0.5 --fraction 0.6",
        "packing.h5 -n 100 --axes 1,1,3 --spread 0.1 --fraction 0.5 --cell 2,1,1 --voxels grains.h5",
    ],
    mc: [
        "packing.xyz --sweeps 1e3 --out run.h5",
        "packing.xyz --sweeps 1e2 --pressure 0.5 --equilibrate 20 --out npt.csv --trajectory npt.dump "
        "--trajectory-every 10",
        "packing.xyz --periodic ab --sweeps 1e2 --out slit.h5 --wall plane:0,0,-1,4 --wall plane:0,0,1,20 --field weight:0,0,0.5",
        "--resume run.h5 --sweeps 2e3",
    ],
    relax: ["grains.xyz apart.data", "run.dump apart.gsd --frames -1"],
}
for _command, _lines in _EXAMPLES.items():
    _command.epilog = "\b\nExamples:\n" + "\n".join(f"  pw85 {_command.name} {line}" for line in _lines)
    pw85.add_command(_command)


# Exit status as after SIGPIPE. The input may be valid, but some of it may not have been read.
_GONE = 128 + 13


def main() -> None:
    """Runs the command in its own thread, so that Ctrl-C need not wait for a long computation."""
    _check_streams()
    outcome, finished = [2], threading.Event()

    def run() -> None:
        try:
            outcome[0] = _run()
        finally:
            finished.set()

    threading.Thread(target=run, daemon=True).start()
    try:
        signal.signal(signal.SIGTERM, signal.default_int_handler)  # as Ctrl-C
        finished.wait()  # not join(): in Python 3.11 an interrupted join() marks the thread as ended
    except KeyboardInterrupt:
        interrupt(finished)
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, signal.SIG_IGN)  # all messages have been printed
    sys.exit(outcome[0])


def _check_streams() -> None:
    """Ends the command if the standard output is closed. Files that it opens would take the numbers of closed streams."""
    if sys.stderr is None:
        os.dup2(os.open(os.devnull, os.O_WRONLY), 2)
        sys.stderr = os.fdopen(2, "w", encoding="utf-8", closefd=False)
    if sys.stdout is None:
        _complain("the standard output is closed: redirect it to a file, or to /dev/null")
        sys.exit(2)


def _run() -> int:
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("always", UserWarning)
            _show_warnings()
            status: Any = pw85.main(standalone_mode=False)
        sys.stdout.flush()
        return int(status or 0)
    except click.ClickException as error:
        error.show()
    except (BrokenPipeError, SystemExit):  # the reader of a pipe has ended; Click turns BrokenPipeError into SystemExit
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
        return _GONE
    except OSError as error:
        _complain(f"{error.filename or 'the output'}: {_reason(error)}")
    except ImportError as error:
        _complain(f"this needs the Python package {error.name}: install it")
    except MemoryError:
        _complain("not enough memory for this frame")
    except ValueError as error:
        _complain(str(error))
    except click.exceptions.Abort:
        return _interrupted()
    except Exception:
        if is_interrupted():  # and the processes that shared the work are gone
            return _interrupted()
        raise
    return 2


def _show_warnings() -> None:
    """Prints each UserWarning, the class of the library's warnings, as one line, and other warnings as Python does."""
    others = warnings.showwarning

    def show(message: Warning | str, category: type[Warning], *where: Any, **more: Any) -> None:
        if category is UserWarning:
            say(f"pw85: warning: {printable(str(message))}", sys.stderr)
        else:
            others(message, category, *where, **more)

    warnings.showwarning = show


def _interrupted() -> int:
    _complain("interrupted")
    return 130


def _reason(error: OSError) -> str:
    if isinstance(error, PermissionError):
        return "permission denied: change its permissions, or work on a copy"
    if isinstance(error, IsADirectoryError):
        return "is a directory: name a file"
    if isinstance(error, FileNotFoundError):
        folder = os.path.dirname(os.fsdecode(error.filename or ""))
        if folder and not os.path.exists(folder):
            return f"there is no folder {folder}: create it, or use another one"
        return "no such file or directory: check the name"
    return error.strerror or str(error)


def _complain(sentence: str) -> None:
    say(f"pw85: {printable(sentence)}", sys.stderr)
