"""The command ``pw85``. Exit statuses: 0 clean, 1 overlaps, 2 bad input or a bad command line, 130 interrupted."""

from __future__ import annotations

import multiprocessing
import os
import sys
import threading
from typing import Any

import click

from .._core import version
from ..formats import discard_unfinished
from .check import check
from .convert import convert
from .draw import draw
from .pack import pack, relax
from .plot import plot


@click.group(context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 110})
@click.version_option(version(), prog_name="pw85")
def pw85() -> None:
    """Ellipsoids in files of simulation programs: which overlap, and what they look like."""


for _command in (check, draw, plot, convert, pack, relax):
    pw85.add_command(_command)


def main() -> None:
    """Runs the command in a thread of its own, so that an interruption need not wait for a long computation."""
    outcome = [2]

    def run() -> None:
        outcome[0] = _run()

    thread = threading.Thread(target=run, daemon=True)
    thread.start()
    try:
        thread.join()
    except KeyboardInterrupt:
        _interrupt()
    sys.exit(outcome[0])


def _interrupt() -> None:
    discard_unfinished()
    for process in multiprocessing.active_children():
        process.kill()
    os.write(2, b"\npw85: interrupted\n")
    os._exit(130)


def _run() -> int:
    try:
        status: Any = pw85.main(standalone_mode=False)
        sys.stdout.flush()
        return int(status or 0)
    except click.ClickException as error:
        error.show()
    except (BrokenPipeError, SystemExit):  # the reader of a pipe has seen enough; SystemExit is what Click makes of that
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
    except OSError as error:
        _complain(f"{error.filename or 'the output'}: {_reason(error)}")
    except ImportError as error:
        _complain(f"the Python package {error.name} is needed for this: install it")
    except MemoryError:
        _complain("there is not enough memory for this frame")
    except ValueError as error:
        _complain(str(error))
    except click.exceptions.Abort:
        return 130
    return 2


def _reason(error: OSError) -> str:
    if isinstance(error, PermissionError):
        return "permission denied: change its permissions, or work on a copy"
    if isinstance(error, FileNotFoundError):
        return "there is no such file or directory: see whether the name is right"
    return error.strerror or str(error)


def _complain(sentence: str) -> None:
    click.echo(f"pw85: {sentence}", err=True)
