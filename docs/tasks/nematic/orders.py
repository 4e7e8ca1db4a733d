# SPDX-License-Identifier: BSD-3-Clause
"""Runs the commands of the page "Find a nematic" again, and checks its table with what they print.

Usage: orders.py --check NUMBER SWEEPS FRACTION...

with the numbers of the page, and the command `pw85` on the path. Of two runs whose errors are known, orders may differ by 4 errors of the
difference, and an order without an error is not compared. On the same kind of processor they are the same.
"""

import csv
import math
import os
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
# One of 16,000 differences of independent Gaussian numbers is larger.
LARGEST = 4.0


def read(path):
    """Order and error, NaN if there is none, by the volume fraction and the start."""
    with path.open(newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    number = lambda text: math.nan if text == "-" else float(text)  # noqa: E731
    return {(row["volume fraction"], row["start"]): (number(row["nematic order"]), number(row["error"])) for row in rows}


def run(number, sweeps, fractions):
    """The table of a fresh folder."""
    with tempfile.TemporaryDirectory() as folder:
        environment = {**os.environ, "NUMBER": number, "SWEEPS": sweeps, "FRACTIONS": " ".join(fractions)}
        subprocess.run(["sh", HERE / "session.sh"], cwd=folder, env=environment, check=True, stdout=subprocess.DEVNULL)
        return read(pathlib.Path(folder) / "orders.csv")


def differences(shown, found):
    """A line for each run that the tables do not have in common, or that differs too much."""
    for key in sorted(shown.keys() | found.keys()):
        if key not in shown or key not in found:
            yield f"{' '.join(key)}: only one of the tables has this run"
            continue
        (first, error), (second, other_error) = shown[key], found[key]
        if abs(first - second) > LARGEST * math.hypot(error, other_error):  # never if an error is NaN
            yield f"{' '.join(key)}: the page has {first} ± {error}, and the commands give {second} ± {other_error}"


def main(arguments):
    if len(arguments) < 4 or arguments[0] != "--check":
        sys.exit(__doc__)
    shown, found = read(HERE / "orders.csv"), run(arguments[1], arguments[2], arguments[3:])
    bad = list(differences(shown, found))
    for line in bad or [f"{len(shown)} runs: the orders of the page are those of its commands"]:
        print(line)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
