"""Checks that README.md says what is in the reference data. Usage: check_readme.py README DATA

The shapes of all datasets, the number of pairs of each category, and the checksum; and that the program beside it draws
the same categories.
"""

import hashlib
import re
import sys
from pathlib import Path

import h5py
import numpy as np


def dataset_rows(h5):
    """Name as in README -> shape, for each dataset."""
    shapes = {}
    h5.visititems(lambda name, item: shapes.update({name: item.shape}) if isinstance(item, h5py.Dataset) else None)
    return {("" if "contact/" in name else "/") + name.removeprefix("contact/"): shape for name, shape in shapes.items()}


def check_shapes(readme, h5):
    stated = {}
    for names, shapes in re.findall(r"^\| (`[^|]+`) \| [^|]+ \| (\([^|]+\)) \|", readme, re.MULTILINE):
        texts = re.findall(r"\(([^)]*)\)", shapes)
        stated |= {
            name: tuple(int(n) for n in text.split(",")) for name, text in zip(re.findall(r"`([^`]+)`", names), texts)
        }
    for name, shape in dataset_rows(h5).items():
        if stated.get(name) != shape:
            yield f"{name}: {shape}, README: {stated.get(name)}"


def stated_counts(readme):
    """Categories and their pairs; those in one row have as many each, written `3 × 1000`."""
    for names, count in re.findall(r"^\| (`[a-z][^|]*) \| ([0-9 ×]+) \|", readme, re.MULTILINE):
        each = int(count.split("×")[-1])
        for name in re.findall(r"`([^`]+)`", names):
            yield name, each


def check_categories(readme, group):
    names = [name.decode() for name in group["category_names"]]
    actual = dict(zip(names, np.bincount(group["category"][:], minlength=len(names))))
    stated = dict(stated_counts(readme))
    for name, count in actual.items():
        if stated.get(name) != count:
            yield f"{name}: {count} pairs, README: {stated.get(name)}"


def main():
    readme, data = Path(sys.argv[1]).read_text(encoding="utf-8"), Path(sys.argv[2])
    with h5py.File(data) as h5:
        complaints = [*check_shapes(readme, h5), *check_categories(readme, h5["contact"])]
    digest = hashlib.sha256(data.read_bytes()).hexdigest()
    for text in (readme, Path(f"{data}.sha256").read_text(encoding="utf-8")):
        if digest not in text:
            complaints.append(f"SHA-256: {digest}")
    print("\n".join(complaints))
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
