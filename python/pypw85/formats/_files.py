# SPDX-License-Identifier: BSD-3-Clause
"""Opening files. Compressed files are decompressed for reading. Files are written atomically."""

from __future__ import annotations

import contextlib
import errno
import gzip
import io
import os
import shutil
import stat
import sys
import tempfile
import time
import zlib
from typing import IO, Any, NamedTuple, TypeAlias, Union, cast
from collections.abc import Iterator

from ._errors import FileError

try:
    import fcntl
except ImportError:  # Windows
    fcntl = None  # type: ignore[assignment]

Path = Union[str, "os.PathLike[str]"]

# The name of the standard output; a file of this name is ./-
STANDARD_OUTPUT = "-"
_GZIP = b"\x1f\x8b"
# Bytes that are read from a text file at once.
READ_AHEAD = 1 << 20
# Of the folders in which files are written. A process has locked its own after a moment, far less than this.
_PREFIX, _SECONDS_TO_LOCK = ".pw85-", 60.0
# Seconds after which a lock is tried again
_MOMENT = 2e-4


class Target(NamedTuple):
    """The destination of an output: `path` is behind all links, `status` is of what is there, if anything.

    `is_replaced` is false for devices, pipes and the like: the output is copied into these.
    """

    path: str
    status: os.stat_result | None
    is_replaced: bool


def checksum(path: Path, size: int) -> int:
    """The CRC-32 of the first bytes of a file."""
    found = 0
    with open(path, "rb") as file:
        while size > 0 and (part := file.read(min(size, READ_AHEAD))):
            found, size = zlib.crc32(part, found), size - len(part)
    return found


def check_output(path: Path) -> Target:
    """Finds where an output of this name goes. Call it before the work that makes the output.

    Raises
    ------
    OSError
        Nothing can be written there.
    """
    name = os.fspath(path)
    if name == STANDARD_OUTPUT:
        return Target(name, None, False)
    if name.endswith((os.sep, os.altsep or os.sep)):
        raise _error(errno.EISDIR, path)
    try:
        status = os.stat(name)
    except FileNotFoundError:
        status = None
    target = os.path.realpath(name)
    if status is not None:
        if stat.S_ISDIR(status.st_mode):
            raise _error(errno.EISDIR, path)
        if not os.access(name, os.W_OK):
            raise _error(errno.EACCES, path)
        if not stat.S_ISREG(status.st_mode) or not _is(target, status):
            return Target(name, status, False)
    folder = os.path.dirname(target)
    if not name or not os.path.isdir(folder):
        raise _error(errno.ENOENT, path)
    if not os.access(folder, os.W_OK | os.X_OK):
        raise _error(errno.EACCES, path)
    return Target(target, status, True)


def refuse_standard_output(path: Path, what: str) -> None:
    """For outputs that must have a name."""
    if os.fspath(path) == STANDARD_OUTPUT:
        raise FileError(path, f"this is the standard output, and {what}: name a file")


def _is(path: str, status: os.stat_result) -> bool:
    """Returns whether the path leads to this file. The path of an open file in /proc may lead to none, if the file was removed."""
    try:
        return os.path.samestat(os.stat(path), status)
    except OSError:
        return False


def _error(code: int, path: Path) -> OSError:
    return OSError(code, os.strerror(code), os.fspath(path))


@contextlib.contextmanager
def replacing(path: Path) -> Iterator[str]:
    """A temporary name, whose file takes the place of `path` at the end unless something goes wrong.

    Links are followed, and a file that is replaced leaves its mode and its owner to the new one.
    """
    target = check_output(path)
    try:
        directory = tempfile.TemporaryDirectory(
            dir=os.path.dirname(target.path) if target.is_replaced else None, prefix=_PREFIX
        )
    except OSError as error:
        raise OSError(error.errno, error.strerror, os.fspath(path)) from None
    with directory as work, _held(work):
        _remove_abandoned(os.path.dirname(os.path.abspath(work)))
        _unfinished.add(work)
        try:
            temporary = os.path.join(work, os.path.basename(os.fspath(path)))
            yield temporary
            _finish(temporary, target)
        finally:
            _unfinished.discard(work)


@contextlib.contextmanager
def _held(work: str) -> Iterator[None]:
    """Locks a folder as long as a process works in it. The system takes the lock of a process that is killed away."""
    file = os.open(work, os.O_RDONLY) if fcntl is not None else -1
    try:
        if fcntl is not None:
            with contextlib.suppress(OSError):  # of a disk without locks
                fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        yield
    finally:
        if fcntl is not None:
            os.close(file)


@contextlib.contextmanager
def locked(path: Path, is_writer: bool, seconds: float) -> Iterator[None]:
    """Keeps readers out of a file while this process adds to it, or this writer while others read. Only processes
    of this package respect the lock. The wait ends after `seconds`: the process that holds the lock may be stopped."""
    file = os.open(path, os.O_RDONLY) if fcntl is not None else -1
    end = time.monotonic() + seconds
    try:
        while fcntl is not None:
            try:
                fcntl.flock(file, (fcntl.LOCK_EX if is_writer else fcntl.LOCK_SH) | fcntl.LOCK_NB)
            except BlockingIOError:
                if time.monotonic() < end:
                    time.sleep(_MOMENT)
                    continue
            except OSError:  # of a disk without locks
                pass
            break
        yield
    finally:
        if fcntl is not None:
            os.close(file)


def _remove_abandoned(folder: str) -> None:
    """Removes the folders that killed processes have left: those without a lock. A new folder may not be locked yet, and stays."""
    if fcntl is None or folder in _searched:
        return
    _searched.add(folder)
    for name in os.listdir(folder):
        work = os.path.join(folder, name)
        if name.startswith(_PREFIX) and os.path.isdir(work) and time.time() - os.path.getmtime(work) > _SECONDS_TO_LOCK:
            with contextlib.suppress(OSError):
                file = os.open(work, os.O_RDONLY)
                try:
                    fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
                    shutil.rmtree(work, ignore_errors=True)
                finally:
                    os.close(file)


def _finish(temporary: str, target: Target) -> None:
    if target.is_replaced:
        if target.status is not None:
            _take_over(target.status, temporary)
        os.replace(temporary, target.path)
        return
    if target.path == STANDARD_OUTPUT:
        with open(temporary, "rb") as source:
            sys.stdout.flush()
            shutil.copyfileobj(source, sys.stdout.buffer)
            sys.stdout.buffer.flush()
        return
    try:
        with open(temporary, "rb") as source, open(target.path, "wb") as out:
            shutil.copyfileobj(source, out)
    except OSError as error:
        raise OSError(error.errno, error.strerror, target.path) from None


def _take_over(status: os.stat_result, path: str) -> None:
    """Owner first: to change it takes special bits away."""
    if hasattr(os, "chown"):
        with contextlib.suppress(PermissionError):
            os.chown(path, status.st_uid, status.st_gid)
    os.chmod(path, stat.S_IMODE(status.st_mode))


_unfinished: set[str] = set()
# Folders in which this process has looked for what others have left
_searched: set[str] = set()


def discard_unfinished() -> None:
    """Removes the temporary files of this process. Call it before the process ends by os._exit()."""
    for work in list(_unfinished):
        shutil.rmtree(work, ignore_errors=True)


def is_compressed_name(path: Path) -> bool:
    return os.fspath(path).lower().endswith(".gz")


@contextlib.contextmanager
def create_text(path: str, compressed: bool) -> Iterator[IO[str]]:
    """A text file for writing. The bytes of a compressed one depend on nothing but its text."""
    if not compressed:
        with open(path, "w", encoding="utf-8") as file:
            yield file
        return
    with (
        open(path, "wb") as raw,
        gzip.GzipFile("", "wb", fileobj=raw, mtime=0) as packed,
        io.TextIOWrapper(cast("IO[bytes]", packed), encoding="utf-8") as file,
    ):
        yield file


def check_input(path: Path) -> os.stat_result:
    """Refuses pipes and devices: a file is read more than once, to recognise its format, to find frames, and to read them."""
    if os.fspath(path) == "-" and not os.path.exists(path):
        raise FileError(path, "files are read more than once, so the standard input is not read: name a file")
    status = os.stat(path)
    if stat.S_ISDIR(status.st_mode):
        raise FileError(path, "is a directory: name a file in it")
    if not stat.S_ISREG(status.st_mode):
        raise FileError(path, "is not a regular file: copy its content into one")
    return status


def is_compressed(path: Path) -> bool:
    with open(path, "rb") as file:
        return file.read(2) == _GZIP


# Text to read, decompressed if need be
Source: TypeAlias = io.BufferedReader | gzip.GzipFile

# A decompressor that is not in use, kept for the next frame: to decompress a file from its start takes longer for each frame.
_idle: dict[Any, gzip.GzipFile] = {}


def open_for_reading(path: Path) -> Source:
    """Opens a file, and decompresses it if it is one of gzip. Pass the result to `close_or_keep` at the end."""
    file = _idle.pop(_identity(path, check_input(path)), None)
    if file is not None:
        return file
    if is_compressed(path):
        return gzip.open(path, "rb")
    return cast("io.BufferedReader", open(path, "rb", buffering=READ_AHEAD))


def close_or_keep(path: Path, file: Source, is_sound: bool) -> None:
    """Closes a file, or keeps its decompressor if that is not at its end."""
    if is_sound and isinstance(file, gzip.GzipFile) and file.peek(1):
        for other in list(_idle):
            if (old := _idle.pop(other, None)) is not None:
                old.close()
        _idle[_identity(path, os.fstat(file.fileno()))] = file
    else:
        file.close()


def _identity(path: Path, status: os.stat_result) -> tuple[Any, ...]:
    return os.path.abspath(path), status.st_dev, status.st_ino, status.st_size, status.st_mtime_ns
