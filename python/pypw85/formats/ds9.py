# SPDX-License-Identifier: BSD-3-Clause
"""Regions of SAOImage DS9 in pixels: ellipses and circles, ``ellipse(x,y,a,b,angle)``, in a system of the image."""

from __future__ import annotations

import itertools
import os
import re
from collections.abc import Iterator

import numpy as np

from .._system import System
from ._conventions import named, sense_in_words
from ._frames import Frame, Location
from ._options import Options
from ._table import Lines

SUFFIXES: tuple[str, ...] = ()
_SYSTEMS = ("image", "physical", "detector", "amplifier", "linear", "fk4", "fk5", "icrs", "galactic", "ecliptic", "b1950", "j2000", "wcs")
_OF_PIXELS = ("image", "physical")
_START = re.compile(rf"# Region file format: DS9|(?:#.*\n|global .*\n|(?:{'|'.join(_SYSTEMS)})[ \t\r]*[;\n]\s*)*"
                    r"[+-]?(?:ellipse|circle) *\(", re.IGNORECASE)  # fmt: skip
# Those of a composite region have || behind them.
_REGION = re.compile(r"\+?\s*(ellipse|circle)\s*[( ]\s*([^)|#]*)\)?\s*(?:\|\|)?\s*(?:#.*)?", re.IGNORECASE)
# Names that users give, in which there may be semicolons
_TEXT = re.compile(r"=\s*(\{[^}]*\}|\"[^\"]*\"|'[^']*')")
_COMMENT = re.compile(r"#.*|global\b.*|$", re.IGNORECASE)


def recognise(start: bytes) -> bool:
    """By the mark, or by a region behind comments and the name of a system."""
    return _START.match(start.decode("utf-8", errors="replace")) is not None


def locate(path: os.PathLike[str]) -> Iterator[Location]:
    yield Location(0)


def load(path: os.PathLike[str], location: Location, options: Options) -> System:
    rows, numbers = [], []
    with Lines(path, location) as lines:
        system, taken = "", set[str]()
        while (line := lines.next()) is not None:
            line = _TEXT.sub("", line)
            for part in filter(None, map(str.strip, itertools.chain([line] if line.startswith("#") else line.split(";")))):
                if part.lower() in _SYSTEMS:
                    system = part.lower()
                elif not _COMMENT.fullmatch(part):
                    rows.append(_ellipse(lines, part, system))
                    numbers.append(lines.number)
                    taken.add(system)
                    if len(taken) > 1:
                        raise lines.error(f"the regions are in several systems, {' and '.join(sorted(taken))}: save all in image")
    if not rows:
        raise lines.error("there are no regions: the file is truncated; write it again")
    values = np.array(rows)
    convention = next(named("ds9"))
    frame = Frame(
        path, location, values[:, :2], shapes=values[:, 2:4], angles=np.radians(values[:, 4]), lengths=convention.meaning, lines=numbers,
        periodic=(False, False, False), dimensions=2,
        source=f"convention ds9, system {' '.join(taken)}, lengths as {convention.meaning}, angle in {convention.unit}, "
               f"{sense_in_words(convention.zero, convention.sense)}, centre of the first pixel at {convention.first}",
    )  # fmt: skip
    return frame.system(options)


def _ellipse(lines: Lines, region: str, system: str) -> list[float]:
    """Centre, semi-axes and angle in degrees."""
    found = _REGION.fullmatch(region)
    if found is None:
        raise lines.error(f"'{region[:40]}' is not an ellipse or circle, and only these can be checked: remove it")
    if system not in _OF_PIXELS:
        raise lines.error(f"the regions are in the system '{system or 'none'}': save them in the system image")
    words = found[2].replace(",", " ")
    if re.search(r"[^-+.0-9eEip\s]", words):
        raise lines.error(f"the region has units other than pixels, '{found[2][:40]}': save it in the system image")
    other = "p" if system == "image" else "i"
    if re.search(rf"{other}(?=\s|$)", words):
        raise lines.error(f"the region is in the system {system}, with lengths in pixels of another, '{found[2][:40]}': save it in the "
                          "system image")  # fmt: skip
    words = re.sub(r"[ip](?=\s|$)", "", words)
    if found[1].lower() == "circle":
        x, y, radius = lines.numbers(words, 3, "a circle")
        return [x, y, radius, radius, 0.0]
    if len(words.split()) > 5:
        raise lines.error("the ellipse is an annulus of several: only single ones can be checked; remove it")
    return lines.numbers(words, 5, "an ellipse")
