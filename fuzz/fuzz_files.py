# SPDX-License-Identifier: BSD-3-Clause
"""Reads broken files until a time is over: python3 fuzz/fuzz_files.py FORMAT SECONDS [SEED], with the package on PYTHONPATH.

Each input is a file of fuzz/files with some bytes changed. It is a finding if reading it ends with anything but systems or a
FileError, takes more than MEMORY bytes or SECONDS_PER_FILE, or ends the process. A finding is kept as finding.FORMAT.N; put it into
fuzz/files when it is mended. Without arguments, all files of fuzz/files are read once, which is a test.
HDF5's library itself crashes, or never ends, on some broken files: these are counted apart.
"""

from __future__ import annotations

import contextlib
import gzip
import os
import pathlib
import random
import resource
import signal
import sys
import tempfile
import time
import warnings

import pypw85

CORPUS = pathlib.Path(__file__).parent / "files"
SUFFIXES = {"lammps-dump": "dump", "lammps-data": "data", "gsd": "gsd", "xyz": "xyz", "hdf5": "h5", "csv": "csv", "splats": "ply",
            "microstructpy": "txt", "gzip": "gz", "spz": "spz", "splat": "splat",
            "labels": "npy"}  # fmt: skip
MEMORY, SECONDS_PER_FILE = 1 << 29, 20
WORDS = [b"nan", b"inf", b"-inf", b"1e20", b"1e308", b"-1", b"0", b"2000000000", b"99999999999999999999", b"1e-320", b"\n", b"\r", b" ",
         b",", b"=", b'"', b"#", b":", b"\0", b"\xff", "\u00a0".encode(), "\u00b2".encode(), b"1_0", b"0x10", b"T", b"pp", b"id",
         b"\x00\x00\x00\x80", b"\xff" * 8]  # fmt: skip


def mutated(data: bytes, others: list[bytes], chance: random.Random) -> bytes:
    """Some bytes changed, moved, taken away, doubled, or replaced by a word that readers may stumble over."""
    result = bytearray(data)
    for _ in range(chance.choice([1, 1, 1, 2, 4, 16])):
        start = chance.randrange(len(result) + 1)
        end = min(len(result), start + chance.choice([1, 1, 2, 4, 8, 64, 512]))
        piece = bytes(result[start:end])
        kind = chance.randrange(7)
        if kind == 0 and piece:
            result[start] ^= 1 << chance.randrange(8)
        elif kind == 1 and piece:
            result[start:end] = bytes(chance.randrange(256) for _ in piece)
        elif kind == 2:
            del result[start:end]
        elif kind == 3:
            result[start:start] = piece * chance.choice([1, 1, 2, 1000])
        elif kind == 4:
            result[start:end] = chance.choice(WORDS)
        elif kind == 5:
            result[start:start] = chance.choice(WORDS)
        else:
            other = chance.choice(others)
            where = chance.randrange(len(other) + 1)
            result[start:end] = other[where : where + chance.choice([4, 16, 64, 256])]
    return bytes(result)


def limit() -> None:
    """Of memory, and of time for what does not return to Python."""
    resource.setrlimit(resource.RLIMIT_CPU, (2 * SECONDS_PER_FILE, 2 * SECONDS_PER_FILE))
    with open("/proc/self/statm") as file:
        now = int(file.read().split()[0]) * resource.getpagesize()
    resource.setrlimit(resource.RLIMIT_AS, (now + MEMORY, now + MEMORY))


def problem(path: str, format: str | None) -> str | None:
    """What is wrong with how a file is read."""

    def too_long(*_: object) -> None:
        raise TimeoutError(f"more than {SECONDS_PER_FILE} seconds")

    signal.signal(signal.SIGALRM, too_long)
    signal.alarm(SECONDS_PER_FILE)
    try:
        for number, system in enumerate(pypw85.frames(path, format=format, shape=(1.0, 1.0, 1.0))):
            with contextlib.suppress(ValueError):  # a name, for instance, that no format can hold
                pypw85.write(path + ".again.h5", system)
            if number == 3:
                break
    except pypw85.FileError as error:
        return None if str(error).isprintable() and str(error).startswith(path) else f"the message {error}"
    except BaseException as error:
        return f"{type(error).__name__}: {error}"
    finally:
        signal.alarm(0)
    return None


_CRASH = "the process ended"


def in_a_process(path: str, format: str | None) -> str | None:
    """As above, in a copy of this process, which may end."""
    reader, writer = os.pipe()
    child = os.fork()
    if child == 0:
        limit()
        os.write(writer, (problem(path, format) or "").encode(errors="backslashreplace")[:4000])
        os._exit(0)
    os.close(writer)
    with open(reader, "rb") as answer:
        wrong = answer.read().decode()
    _, status = os.waitpid(child, 0)
    return _CRASH if status else wrong or None


def read_corpus() -> int:
    failures = 0
    with tempfile.TemporaryDirectory() as folder:
        for file in sorted(CORPUS.iterdir()):
            copy = os.path.join(folder, file.name)
            pathlib.Path(copy).write_bytes(file.read_bytes())
            wrong = in_a_process(copy, None)
            print(f"{file.name}: {wrong or 'ok'}")
            failures += wrong is not None
    return failures


def fuzz(format: str, seconds: float, seed: int) -> int:
    suffix, chance = SUFFIXES[format], random.Random(seed)
    corpus = [file.read_bytes() for file in sorted(CORPUS.glob(f"*.{suffix}"))]
    if format == "gzip":
        corpus += [gzip.compress(file.read_bytes()) for file in sorted(CORPUS.glob("*.dump"))]
    found, crashes, tried, end = 0, 0, 0, time.monotonic() + seconds
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, f"a.{suffix}")
        while time.monotonic() < end:
            data = mutated(chance.choice(corpus), corpus, chance)
            pathlib.Path(path).write_bytes(data)
            tried += 1
            wrong = in_a_process(path, None if format in ("gzip", "spz", "splat") else format)
            if format == "hdf5" and wrong == _CRASH:
                crashes += 1
            elif wrong is not None:
                pathlib.Path(f"finding.{format}.{found}").write_bytes(data)
                print(f"finding.{format}.{found}: {wrong}", flush=True)
                found += 1
    print(f"{format}: {tried} files in {seconds:g} s, {found} findings, {crashes} crashes or endless loops of HDF5", flush=True)
    return found


if __name__ == "__main__":
    warnings.simplefilter("ignore")
    import gsd.hoomd  # noqa: F401 (before memory is limited)
    import h5py  # noqa: F401

    if len(sys.argv) == 1:
        sys.exit(read_corpus() != 0)
    sys.exit(fuzz(sys.argv[1], float(sys.argv[2]), int(sys.argv[3]) if len(sys.argv) > 3 else 0) != 0)
