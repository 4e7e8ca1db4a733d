"""The measured numbers of README and manual, from docs/measurements.json, which bench/measure.py writes."""

import hashlib
import json
from pathlib import Path

RESULTS = Path(__file__).resolve().parent / "measurements.json"


def read():
    return json.loads(RESULTS.read_text(encoding="utf-8"))


def read_table(name):
    """Rows of a measured table, as dictionaries."""
    return read()["tables"][name]


def accuracy_of_all_problems():
    """The row of the table of errors that has all contact problems of the reference data."""
    return next(row for row in read_table("accuracy") if row["aspect_from"] == "all")


def number_of_contact_problems():
    return int(accuracy_of_all_problems()["pairs"])


def conditions(table=None):
    """A sentence on the machine, that of a table which was measured apart from the others if it is given."""
    results = read()
    c = results.get("apart", {}).get(table, results["conditions"])
    busy = f", load average {c['load_average']:g}" if (c["load_average"] or 0) > c["processors"] else ""
    return f"pw85 {c['version']}, {c['processor']}, {c['compiler']}, {c['date']}{busy}"


def source(table):
    """What a picture says of the table that it shows: it is out of date if the table says something else."""
    text = json.dumps(read_table(table), sort_keys=True)
    return f"{RESULTS.name}: {table}, SHA-256 {hashlib.sha256(text.encode()).hexdigest()}"


def source_of_file(path):
    """The same of a picture that shows a file."""
    return f"{path.name}: SHA-256 {hashlib.sha256(path.read_bytes()).hexdigest()}"
