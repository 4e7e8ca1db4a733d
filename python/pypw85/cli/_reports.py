# SPDX-License-Identifier: BSD-3-Clause
"""Files with the results of `pw85 check`. Files are written atomically."""

from __future__ import annotations

import contextlib
import json
from typing import Any, NamedTuple
from collections.abc import Callable, Iterator

import numpy as np

from .._system import Contacts, Report
from ..formats import replacing

_COLUMNS = ("frame", "step", "id1", "id2", "image_a", "image_b", "image_c", "mu", "overlap", "x", "y", "z", "nx", "ny", "nz")


class Found(NamedTuple):
    """A report and its frame. `contact_ids` and `worst_ids` are the ids of the particles of its pairs; `measures` are numbers of the whole
    system by their names; `source` and `notes` say what was taken of the file."""

    frame: int
    step: int
    cell: Any | None
    periodic: tuple[bool, ...]
    report: Report
    contact_ids: Any
    worst_ids: Any
    measures: dict[str, Any]
    source: str
    notes: tuple[str, ...]

    def table(self) -> Any:
        """Contacts by columns."""
        contacts = self.report.contacts
        n = len(contacts.mu)
        columns = [np.full(n, self.frame), np.full(n, self.step), self.contact_ids, contacts.images, contacts.mu,
                   contacts.overlap, contacts.point, contacts.normal]  # fmt: skip
        kinds = [(name, "i8") for name in _COLUMNS[:7]] + [(name, "f8") for name in _COLUMNS[7:]]
        flat = [part for column in columns for part in np.reshape(column, (n, -1)).T] if n else [np.empty(0)] * 15
        return np.rec.fromarrays(flat, dtype=kinds)


Add = Callable[[Found], None]


@contextlib.contextmanager
def csv_report(path: str) -> Iterator[Add]:
    file: Any  # the types of NumPy ask of savetxt() a file of bytes
    with replacing(path) as temporary, open(temporary, "w", encoding="utf-8") as file:
        file.write(",".join(_COLUMNS) + "\n")

        def add(found: Found) -> None:
            np.savetxt(file, found.table(), fmt=7 * ["%d"] + ["%.17g", "%d"] + 6 * ["%.17g"], delimiter=",")

        yield add


@contextlib.contextmanager
def json_report(path: str) -> Iterator[Add]:
    with replacing(path) as temporary, open(temporary, "w", encoding="utf-8") as file:
        file.write('{"frames": [')
        separator = "\n"

        def add(found: Found) -> None:
            nonlocal separator
            file.write(separator + json.dumps(_as_json(found)))
            separator = ",\n"

        yield add
        file.write("\n]}\n")


def _as_json(found: Found) -> dict[str, Any]:
    report = found.report._asdict()
    report.pop("worst"), report.pop("contacts")
    cell = None if found.cell is None else found.cell.tolist()
    contacts = [_contact(*row) for row in zip(found.contact_ids.tolist(), *_lists(found.report.contacts))]
    return {"frame": found.frame, "step": found.step, "cell": cell, "periodic": found.periodic, "source": found.source,
            "notes": found.notes, **report, **found.measures, "contacts": contacts}  # fmt: skip


def _lists(contacts: Contacts) -> Iterator[list[Any]]:
    """Columns as lists, with None for NaN, which JSON does not have: point and normal at a common centre."""
    for column in map(np.asarray, contacts[1:]):
        plain: Any = column.astype(object)
        plain[plain != plain] = None
        yield plain.tolist()


def _contact(ids: Any, image: Any, mu: float, overlap: bool, point: Any, normal: Any) -> dict[str, Any]:
    return {"ids": ids, "image": image, "mu": mu, "overlap": overlap, "point": point, "normal": normal}


@contextlib.contextmanager
def hdf5_report(path: str) -> Iterator[Add]:
    """Two tables: frames and contacts."""
    import h5py

    with replacing(path) as temporary, h5py.File(temporary, "w") as file:

        def append(name: str, rows: Any) -> None:
            if name not in file:
                file.create_dataset(name, (0,), rows.dtype, maxshape=(None,))
            data = file[name]
            data.resize(len(data) + len(rows), axis=0)
            if len(rows):
                data[-len(rows) :] = rows

        def add(found: Found) -> None:
            report = found.report
            numbers = {"frame": found.frame, "step": found.step, "particles": report.particles,
                       "pairs_tested": report.pairs_tested, "overlaps": report.overlaps, "dimensions": report.dimensions}  # fmt: skip
            measures = {"packing_fraction": report.packing_fraction, "smallest_mu": report.smallest_mu,
                        "density": found.measures["density"], "nematic_order": found.measures["nematic_order"]}  # fmt: skip
            kinds = [(name, "i8") for name in numbers] + [(name, "f8") for name in measures]
            row = (*numbers.values(), *(np.nan if value is None else value for value in measures.values()))
            append("frames", np.array([row], dtype=kinds))
            append("contacts", found.table())

        yield add
