# SPDX-License-Identifier: BSD-3-Clause
"""Splats in PLY files: those of 3D and 2D Gaussian splatting, and those that SuperSplat and splat-transform compress."""

from __future__ import annotations

import os
import re
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .._ply import Header, check_end, read_header, rows_of
from .._typing import Floats
from . import _comments
from ._errors import FileError, for_option
from ._options import Options
from ._gaussians import Gaussians

_POSITION, _ROTATION = ["x", "y", "z"], [f"rot_{k}" for k in range(4)]
# Properties that do not change shapes: colours, normals, labels.
_HARMLESS = re.compile(r"n[xyz]2?|normal_?\d|f_dc_\d+|f_rest_\d+|opacity|(?:diffuse_)?(?:red|green|blue|alpha)|[rgba]|confidence|segment|"
                       r"(?:f_)?sem(?:antic)?(?:_\d+)?|obj_dc_\d+|(?:\w+_)?(?:label|id|class)|mask|state|lod|lod_level|intensity|"
                       r"(?:base_color|albedo(?:_rest)?|specular|diffuse|incidents_(?:dc|rest)|roughness|metallic)(?:_?\d+)?")  # fmt: skip
_LINEAR = re.compile(r"\bscales?\b.*\b(linear|activated|lengths?|not log)|\b(linear|activated)\b.*\bscal", re.IGNORECASE)
_CHUNK = 256
_PACKED = ["packed_position", "packed_rotation", "packed_scale"]


def read_ply(path: os.PathLike[str], options: Options) -> Gaussians:
    with open(path, "rb") as file:
        content = file.read()
    try:
        header = read_header(content)
        check_end(content, header)
        vertex = header.element("vertex")
        names = [] if vertex is None else [one.name for one in vertex.properties]
        names = _without_ignored(path, names, options)
        if "packed_scale" in names:
            return _uncompressed(path, content, header, names, options)
        _check_properties(path, names)
        _check_comments(path, content[: header.size], options)
        _refuse_packed(path, {} if vertex is None else {one.name: one.kind for one in vertex.properties})
        rows = rows_of(content, header, "vertex")
        return _plain(path, {name: rows[name] for name in names}, options)
    except ValueError as error:
        raise error if isinstance(error, FileError) else FileError(path, str(error), 0) from None


def _without_ignored(path: os.PathLike[str], names: list[str], options: Options) -> list[str]:
    for name in options.ignore_columns or ():
        if name not in names:
            raise FileError(path, f"there is no property {name} for --ignore-columns, but {' '.join(names)[:200]}: name one of these", 0)
    return [name for name in names if name not in (options.ignore_columns or ())]


def _check_properties(path: os.PathLike[str], names: list[str]) -> None:
    missing = [name for name in (*_POSITION, "scale_0", "scale_1", *_ROTATION) if name not in names]
    if missing:
        raise FileError(path, f"there is no property {missing[0]} of splats, but {' '.join(names)[:200]}: write splats with x y z, scale_0 "
                        "scale_1 scale_2 (two for discs) and rot_0 rot_1 rot_2 rot_3", 0)  # fmt: skip
    _refuse_unknown(path, names, {*_POSITION, *_ROTATION, "scale_0", "scale_1", "scale_2", "filter_3D"})


def _check_comments(path: os.PathLike[str], start: bytes, options: Options) -> None:
    """Refuses comments that contradict what is taken: the order of quaternions, and scales that are logarithms."""
    texts = [line.decode("latin-1") for line in re.findall(rb"^(?:comment|obj_info)[ \t]+([^\r\n]*)", start, re.MULTILINE)]
    for text in texts:
        if options.scales is None and _LINEAR.search(text):
            raise FileError(path, f"the comment '{text[:80]}' says that scales are lengths, and they are logarithms in other files: say "
                            "which (--scales linear or --scales log)", 0)  # fmt: skip
    cure = "say the order (--quaternion)", "write w first, or remove it"  # of splats, no option says it
    meaning = _comments.Meaning(order="wxyz")
    _comments.check(texts, meaning, lambda reason: FileError(path, f"the comment {reason.replace(*cure)}", 0))


def _refuse_packed(path: os.PathLike[str], kinds: dict[str, str]) -> None:
    """Whole numbers stand for others, in a way of the program that wrote them."""
    for name in (*_POSITION, *_ROTATION, "scale_0", "scale_1", "scale_2"):
        if not kinds.get(name, "f").startswith("f"):
            raise FileError(path, f"the property {name} has whole numbers, which are packed in a way that is not known: write the splats "
                            "with properties of the type float", 0)  # fmt: skip


def _refuse_unknown(path: os.PathLike[str], names: list[str], used: set[str]) -> None:
    """Every property is used, or does not change shapes."""
    unknown = [name for name in names if name not in used and not _HARMLESS.fullmatch(name)]
    if unknown:
        raise FileError(path, f"splats have the property '{unknown[0][:80]}', which is not known and may change their shape: leave it out "
                        f"if it does not (--ignore-columns {for_option(unknown)})", 0)  # fmt: skip


def _columns(rows: dict[str, NDArray[Any]], names: list[str]) -> Floats:
    return np.stack([rows[name].astype(np.float64) for name in names], axis=1)


def _plain(path: os.PathLike[str], rows: dict[str, NDArray[Any]], options: Options) -> Gaussians:
    scales = [name for name in ("scale_0", "scale_1", "scale_2") if name in rows]
    values = _columns(rows, scales)
    said = " ".join(scales)
    if options.scales == "linear":
        _refuse_negative(path, values)
        lengths, said = values, f"({said})" if "filter_3D" in rows else said
    else:
        _refuse_doubtful(path, values, options, said)
        with np.errstate(over="ignore"):
            lengths = np.exp(values)
        said = f"exp({said})"
    if "filter_3D" in rows:
        lengths = np.hypot(lengths, rows["filter_3D"].astype(np.float64)[:, None])
        said = f"√({said}² + filter_3D²)"
    if len(scales) == 2:
        # The smoothing filter of a disc acts across it, too.
        across = np.abs(rows["filter_3D"].astype(np.float64)) if "filter_3D" in rows else np.zeros(len(lengths))
        lengths = np.column_stack([lengths, across])
        said += " of discs"
    return Gaussians(_columns(rows, _POSITION), lengths, _columns(rows, _ROTATION), said, " ".join(_ROTATION))


def _refuse_negative(path: os.PathLike[str], values: Floats) -> None:
    wrong = (values < 0).any(axis=1)
    if wrong.any():
        splat = int(wrong.argmax())
        raise FileError(path, f"splat {splat + 1} has the scale {values[splat].min():g}, which is not a length: the scales are logarithms, "
                        "leave out --scales linear", 0)  # fmt: skip


def _refuse_doubtful(path: os.PathLike[str], values: Floats, options: Options, names: str) -> None:
    """Lengths are never negative. Their logarithms are in every usual scene, where most splats are smaller than the unit."""
    if options.scales is None and len(values) and (values >= 0).all() and values.any():
        raise FileError(path, f"{names} are all >= 0, and may be lengths or logarithms of lengths: use --scales linear or "
                        "--scales log", 0)  # fmt: skip


def _uncompressed(path: os.PathLike[str], content: bytes, header: Header, names: list[str], options: Options) -> Gaussians:
    """Chunks of 256 splats have bounds, between which positions and logarithms of lengths are whole numbers."""
    if options.scales is not None:
        raise FileError(path, "the scales of compressed PLY files are always logarithms: leave out --scales", 0)
    chunk, vertex = header.element("chunk"), header.element("vertex")
    assert vertex is not None
    bounds = [f"{end}_{stem}{axis}" for stem in ("", "scale_") for end in ("min", "max") for axis in "xyz"]
    for element, needed in ((chunk, bounds), (vertex, _PACKED)):
        there = {} if element is None else {one.name: one.kind for one in element.properties}
        wrong = [name for name in needed if there.get(name) != ("u4" if needed is _PACKED else "f4")]
        if wrong:
            raise FileError(path, f"there is no property {wrong[0]} as in compressed PLY files: the file is broken; write it again", 0)
    _refuse_unknown(path, names, {*_PACKED, "packed_color"})
    if chunk is None or chunk.number != -(-vertex.number // _CHUNK):
        raise FileError(path, f"{vertex.number} splats need {-(-vertex.number // _CHUNK)} chunks of {_CHUNK}, and there are "
                        f"{0 if chunk is None else chunk.number}: the file is broken; write it again", 0)  # fmt: skip
    low_high = _columns(rows_of(content, header, "chunk"), bounds)
    rows = rows_of(content, header, "vertex")
    position, rotation, scale = (rows[name].astype(np.uint32) for name in _PACKED)
    limits = low_high[np.arange(vertex.number) // _CHUNK]
    with np.errstate(over="ignore", invalid="ignore"):
        lengths = np.exp(_between(limits[:, 6:9], limits[:, 9:], scale))
    return Gaussians(
        _between(limits[:, :3], limits[:, 3:6], position), lengths, _rotations(rotation), "exp(packed_scale)", "packed_rotation"
    )


def _between(low: Floats, high: Floats, packed: NDArray[np.uint32]) -> Floats:
    """Whole numbers of 11, 10 and 11 bits: 0 is the lower bound, the largest the upper."""
    shares = np.stack([(packed >> 21) / 2047, (packed >> 11 & 1023) / 1023, (packed & 2047) / 2047], axis=1)
    values: Floats = low * (1 - shares) + high * shares
    return values


def _rotations(packed: NDArray[np.uint32]) -> Floats:
    """Two bits say which component is the largest and left out. The three others have ten bits, from -√½ to √½."""
    three = np.stack([packed >> 20 & 1023, packed >> 10 & 1023, packed & 1023], axis=1) / 1023 - 0.5
    return completed(np.sqrt(2.0) * three, (packed >> 30).astype(np.intp))


def completed(three: Floats, place: NDArray[np.intp]) -> Floats:
    """Unit quaternions from three of their components, in order, and the place of the fourth, which is not negative."""
    largest = np.sqrt(np.maximum(0, 1 - (three * three).sum(axis=1)))
    four = np.empty((len(three), 4))
    others = np.arange(3) + (np.arange(3) >= place[:, None])
    np.put_along_axis(four, others, three, axis=1)
    np.put_along_axis(four, place[:, None], largest[:, None], axis=1)
    return four
