# SPDX-License-Identifier: BSD-3-Clause
"""PLY files: their header, and where the rows of each element are. Errors are ValueError, without the name of the file."""

from __future__ import annotations

import re
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ._typing import Floats
from ._words import counted

Buffer = bytes | memoryview
_END = re.compile(rb"^end_header[ \t\r]*\n", re.MULTILINE)
# Types of NumPy by the names of types, of which some have two
_KINDS = dict(zip("char int8 uchar uint8 short int16 ushort uint16 int int32 uint uint32 float float32 double float64".split(),
                  "i1 i1 u1 u1 i2 i2 u2 u2 i4 i4 u4 u4 f4 f4 f8 f8".split()))  # fmt: skip
_ORDERS = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}


class Property(NamedTuple):
    """`kind` is a type of NumPy; `length` is that of the number before a list, or empty."""

    name: str
    kind: str
    length: str = ""


class Element(NamedTuple):
    name: str
    number: int
    properties: list[Property]

    @property
    def has_lists(self) -> bool:
        return any(one.length for one in self.properties)

    def row(self, order: str) -> np.dtype[Any]:
        """The type of a row without lists."""
        return np.dtype([(one.name, order + one.kind) for one in self.properties])


class Header(NamedTuple):
    """`order` is that of bytes, "<" or ">", or empty for text. The rows begin behind `size` bytes."""

    order: str
    elements: list[Element]
    size: int

    def element(self, name: str) -> Element | None:
        return next((one for one in self.elements if one.name == name), None)


def read_header(content: Buffer) -> Header:
    """The header at the start of a file."""
    end = _END.search(content)
    if bytes(content[:3]) != b"ply" or end is None:
        raise ValueError("the file must begin with the header of a PLY file: it is truncated, or has another format")
    lines = bytes(content[: end.start()]).decode("latin-1").splitlines()
    order, elements = None, []
    for number, line in enumerate(lines, 1):
        words = line.split()
        if words[:1] == ["format"] and len(words) > 1:
            order = _ORDERS.get(words[1])
        elif words[:1] == ["element"]:
            elements.append(_element(words, number))
        elif words[:1] == ["property"]:
            if not elements:
                raise ValueError(f"line {number}: a property must follow its element: correct the header")
            elements[-1].properties.append(_property(words, number, elements[-1]))
    if order is None:
        raise ValueError(f"the format in the header must be one of {', '.join(_ORDERS)}: correct it")
    return Header(order, elements, end.end())


def _element(words: list[str], number: int) -> Element:
    if len(words) != 3 or not re.fullmatch(r"[0-9]{1,18}", words[2]):
        raise ValueError(f"line {number}: an element must have a name and a number, not '{' '.join(words)[:80]}'")
    return Element(words[1], int(words[2]), [])


def _property(words: list[str], number: int, element: Element) -> Property:
    kinds = [_KINDS.get(word, "") for word in words[1:-1] if word != "list"]
    if len(kinds) != (2 if words[1:2] == ["list"] else 1) or not all(kinds) or (kinds[0][0] == "f" and len(kinds) > 1):
        raise ValueError(f"line {number}: a property must have a type of PLY and a name, not '{' '.join(words)[:80]}'")
    if any(one.name == words[-1] for one in element.properties):
        raise ValueError(f"line {number}: the element {element.name} has two properties {words[-1]}: rename one")
    return Property(words[-1], kinds[-1], kinds[0] if len(kinds) > 1 else "")


def end_of(content: Buffer, header: Header, element: Element, start: int) -> int:
    """Position of the end of the rows of an element that begin at `start`; not beyond the end of the file."""
    if not header.order:
        return _end_of_lines(content, element.number, start)
    if not element.has_lists:
        return min(len(content), start + element.number * element.row(header.order).itemsize)
    for _ in range(element.number):
        if start >= len(content):
            break
        for one in element.properties:
            size = np.dtype(one.kind).itemsize
            if one.length:
                width = np.dtype(one.length).itemsize
                size *= max(0, int.from_bytes(content[start : start + width], "little" if header.order == "<" else "big"))
                start += width
            start += size
    return min(len(content), start)


def _end_of_lines(content: Buffer, count: int, start: int) -> int:
    """Position behind a number of lines that are not blank."""
    text = bytes(content[start:])
    place = 0
    while count and place < len(text):
        end = text.find(b"\n", place)
        end = len(text) if end < 0 else end + 1
        count -= bool(text[place:end].strip())
        place = end
    return start + place


def check_end(content: Buffer, header: Header) -> None:
    """Refuses more rows than the header says, in text and in files without lists."""
    total = sum(element.number for element in header.elements)
    if not header.order:
        rest = bytes(content[header.size :])
        if rest.count(b"\n") > total - 1 and (there := sum(1 for line in rest.splitlines() if line.strip())) > total:
            raise ValueError(f"{counted(there, 'row')} instead of {total} follow the header: correct its numbers")
    elif not any(element.has_lists for element in header.elements):
        end = header.size + sum(element.number * element.row(header.order).itemsize for element in header.elements)
        if bytes(content[end:]).strip():
            raise ValueError(f"{counted(len(content) - end, 'byte')} follow the {total} rows that the header says: correct its numbers")


def rows_of(content: Buffer, header: Header, name: str) -> dict[str, NDArray[Any]]:
    """The columns of an element without lists, which the header must have. Other elements are passed over, before and behind it."""
    element, place = header.element(name), header.size
    assert element is not None
    for before in header.elements[: header.elements.index(element)]:
        place = end_of(content, header, before, place)
    if element.has_lists:
        raise ValueError(f"the element '{name}' has lists, which are not read: write it without them")
    if not header.order:
        table = _table_of_text(content, header, element, place)
        return {one.name: table[:, k] for k, one in enumerate(element.properties)}
    row = element.row(header.order)
    there = (len(content) - place) // row.itemsize if row.itemsize else 0
    _check_count(element, there)
    rows = np.frombuffer(content, row, element.number, place)
    return {one.name: rows[one.name] for one in element.properties}


def _check_count(element: Element, there: int) -> None:
    if there < element.number:
        what = "splats" if element.name == "vertex" else f"rows of '{element.name}'"
        raise ValueError(f"the file ends after {there} of {element.number} {what}: it is truncated; write it again")


def _table_of_text(content: Buffer, header: Header, element: Element, place: int) -> Floats:
    lines = bytes(content[place : end_of(content, header, element, place)]).splitlines()
    first = bytes(content[:place]).count(b"\n") + 1
    rows = []
    for number, line in enumerate(lines, first):
        if not (words := line.split()):
            continue
        try:
            rows.append(np.array(words, dtype=np.float64))
        except ValueError:
            raise ValueError(f"line {number}: '{line.decode('latin-1')[:80]}' must be numbers: correct it") from None
        if len(words) != len(element.properties):
            raise ValueError(f"line {number}: the line must have {len(element.properties)} numbers, not {len(words)}: correct it")
    _check_count(element, len(rows))
    return np.array(rows).reshape(-1, len(element.properties))
