# SPDX-License-Identifier: BSD-3-Clause
"""Columns that number pictures, planes, times or samples. The rows of a table are one system, so each of these has one value."""

from __future__ import annotations

import re
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ._column_names import matches, plain_name
from ._conventions import Convention
from ._errors import for_option
from ._options import Options
from ._table import Lines, Table

# What may follow a word that names a series
_END = r"(s|id|no|nr|num|number|index|idx|name)?"
_SERIES = re.compile(r"(slice|frame|image|picture|\w*step|timepoint|time|timestamp|snapshot|iter(ation)?|cycle|plane|zplane|layer|scan|"
                     r"(source)?file|sample|stack|replica|replicate|rep|repeat|realization|realisation|run|trial|specimen|scene|"
                     r"increment|sim(ulation)?|config(uration)?|experiment|dump|movie|batch|patient|subject|animal|dataset)"
                     rf"{_END}|t[munµ]?s?|date(time)?|(series|study|image|sop|scan|patient)\w*uid|(sub)?volume(id|no|nr|index|idx|name)|"
                     r"((elapsed|sim|epoch)?time(stamp)?|elapsed)([munµ]?s|sec(onds?)?|min(utes?)?|h)?")
# The same in tables of programs that measure pictures
_PICTURES = re.compile(r"(metadata)?(well|site|field|fieldofview|fov|tile|crop|position|movie|video|experiment|dataset|channel|series|"
                       r"section|(image|file)?path|epoch|tp|tindex|condition|animal|mouse|patient|subject|date|day)"
                       rf"{_END}")  # fmt: skip
# Columns with the same value for one body at several times or for the spheres of one body, and of tables of pictures those that number
# the bodies of each
_TRACKS = re.compile(rf"(track|trajectory|traj|clump|rigid(body)?|multisphere|glued(sphere)?|metaparticle|agglomerate){_END}|"
                     r"idmultisphere|body(id|no|nr|num|number|index|idx)")
_LABELS = re.compile(r"labels?|object(number|id|label)")
# Labels of ImageJ are TITLE:REGION:SLICE; REGION and SLICE may lack (Analyzer.getFileName, 1.53t). A region of a stack has the
# name SLICE-Y-X (RoiManager.getLabel).
_LABEL = re.compile(r"(?:[^:]*:)+(\d+)|[^:]*:(\d{4,})-\d{4,}-\d{4,}.*")


def columns_of_series(columns: Sequence[str], dimensions: int, options: Options, convention: Convention | None) -> list[str]:
    """Names columns of series, of ellipses also the third coordinate of their centres, and the labels of ImageJ."""
    third = "centerz" if convention is None or not convention.third else convention.third
    words = [_SERIES, _TRACKS] + [_PICTURES, _LABELS] * (convention is not None and convention.first != "")
    found = [name for name in columns if any(one.fullmatch(plain_name(name)) for one in words) or
             (dimensions == 2 and plain_name(name).endswith(third))]  # fmt: skip
    return [name for name in found if name not in (options.ignore_columns or ())]


def check_series(table: Table, names: Sequence[str], convention: Convention | None, lines: Lines) -> None:
    """Refuses rows of several pictures, planes or times, whose bodies would be taken as one system."""
    for name in names:
        rows = table[name].tolist()
        is_title = name == "Label" and convention is not None and convention.name == "imagej"
        if not is_title and (_TRACKS.fullmatch(plain_name(name)) or _LABELS.fullmatch(plain_name(name))):
            _check_tracks(name, rows, table.line, lines)
            continue
        if is_title and len({*rows}) == len(rows):
            rows = [*map(_picture_of, rows)]
        values = list(dict.fromkeys(rows))
        if len(values) > 1:
            lines.number = table.line + rows.index(values[1])
            raise lines.error(f"the column {name} has several values, {values[0]} and {values[1]}: write the rows of one of them, or say "
                              f"that all are bodies of one system (--ignore-columns {for_option([name])})")  # fmt: skip


def columns_of_clumps(columns: Sequence[str], options: Options) -> list[str]:
    """Names columns of a frame that number bodies of several spheres."""
    return [name for name in columns if matches(_TRACKS, name) and name not in (options.ignore_columns or ())]


def check_clumps(table: Table, names: Sequence[str], lines: Lines) -> None:
    """Refuses bodies of several spheres: spheres of one body may overlap. LIGGGHTS writes 0 for single spheres."""
    for name in names:
        _check_tracks(name, [f"{number:g}" if number > 0 else "" for number in table[name].tolist()], table.line, lines)


def _picture_of(label: str) -> str:
    """The title and the slice of a label of ImageJ, without the region."""
    found = _LABEL.fullmatch(label)
    title = "" if label.isdecimal() else label.partition(":")[0]
    return f"{title}:{found[1] or found[2]}" if found else title


def _check_tracks(name: str, rows: list[str], line: int, lines: Lines) -> None:
    """Refuses a track that is there twice: its body at two times."""
    seen = set[str]()
    for k, row in enumerate(rows):
        if row in seen and row.isdecimal():
            lines.number = line + k
            raise lines.error(f"the column {name} has {row} twice, as for one body at two times, in two pictures, or of several spheres: "
                              "write the rows of one, or say that all are bodies of one system (--ignore-columns "
                              f"{for_option([name])})")  # fmt: skip
        seen.add(row)


def check_repeated(numbers: NDArray[np.int64] | None, ids: str, line: int, lines: Lines) -> None:
    """Refuses rows of which most have an id that is there twice, as in several frames one behind the other."""
    if numbers is None or (np.diff(numbers) > 0).all():
        return
    _, first, counts = np.unique(numbers, return_index=True, return_counts=True)
    if (counts > 1).sum() > 1 and 2 * counts[counts > 1].sum() > len(numbers):
        lines.number = line + int(np.setdiff1d(np.arange(len(numbers)), first)[0])
        times = f"each id {counts[0]} times" if counts.min() == counts.max() else f"most ids up to {counts.max()} times"
        raise lines.error(f"the column {ids} has {times}, as for {counts.max()} frames or pictures: write the rows of one of them, or say "
                          f"that all are bodies of one system (--ignore-columns {for_option([ids])})")  # fmt: skip
