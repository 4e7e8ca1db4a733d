# SPDX-License-Identifier: BSD-3-Clause
"""The commands of a task page run literally, with few particles and sweeps."""

import csv
import importlib.util
import os
import pathlib
import re
import subprocess
import sys

import pytest

import pypw85

SOURCE = pathlib.Path(os.environ["PYPW85_SOURCE"])


def test_nematic(tmp_path):
    """From start to picture: packings without overlaps, a line with the order of each run, and two pictures."""
    (tmp_path / "bin").mkdir()
    (tmp_path / "bin" / "pw85").write_text(f'#!/bin/sh\nexec {sys.executable} -m pypw85.cli "$@"\n')
    (tmp_path / "bin" / "pw85").chmod(0o755)
    environment = {**os.environ, "PATH": f"{tmp_path / 'bin'}:{os.environ['PATH']}", "NUMBER": "32", "SWEEPS": "40", "FRACTIONS": "0.40"}
    done = subprocess.run(["sh", SOURCE / "docs/tasks/nematic/session.sh"], cwd=tmp_path, env=environment, capture_output=True,
                          encoding="utf-8")  # fmt: skip
    assert (done.returncode, done.stderr) == (0, "")
    packed = r"(isotropic|aligned)-0\.40\.csv: 32 ellipsoids without overlaps, fraction 0\.4, .*"
    forms = [packed, packed, r"series\.png: 4 samples up to sweep 40", r"aligned-0\.40\.h5: hdf5, lengths semi_axes as radii, .*"]
    for line, form in zip(done.stdout.splitlines(), forms, strict=True):
        assert re.fullmatch(form, line), line
    header, *orders = (tmp_path / "orders.csv").read_text().splitlines()
    assert header == "volume fraction,start,nematic order,error,mark" and len(orders) == 2
    assert all(re.fullmatch(r"0\.40,(isotropic|aligned),\d\.\d+,-,\?", line) for line in orders), orders
    starts = [pypw85.read(tmp_path / f"{start}-0.40.csv") for start in ("isotropic", "aligned")]
    assert pypw85.nematic_order(starts[0]) < 0.5 and pypw85.nematic_order(starts[1]) > 0.999999
    assert all((tmp_path / name).stat().st_size > 10000 for name in ("series.png", "nematic.png"))


def test_check_of_orders(tmp_path, monkeypatch, capsys):
    """The check of the table runs the commands again. It sees another order, and a run that is missing, and knows no error of a `-`."""
    source = SOURCE / "docs/tasks/nematic/orders.py"
    orders = importlib.util.module_from_spec(importlib.util.spec_from_file_location("orders", source))
    orders.__spec__.loader.exec_module(orders)
    monkeypatch.setattr(orders, "HERE", tmp_path)
    header = "volume fraction,start,nematic order,error,mark\n"
    (tmp_path / "orders.csv").write_text(header + "0.40,isotropic,0.1,0.01,\n0.40,aligned,0.12,-,?\n")
    # A session that stands for the commands, with the numbers that it is given
    session = 'echo "volume fraction,start,nematic order,error,mark" >orders.csv; for f in $FRACTIONS; do\n'
    for isotropic, aligned, status, line in (
        ("0.15,0.009,", "0.9,0.01,", 0, "2 runs: the orders of the page are those of its commands\n"),
        ("0.15,0.007,", "0.9,-,?", 1, "0.40 isotropic: the page has 0.1 ± 0.01, and the commands give 0.15 ± 0.007\n"),
    ):
        rows = f'echo "$f,isotropic,{isotropic}" >>orders.csv; echo "$f,aligned,{aligned}" >>orders.csv; done\n'
        (tmp_path / "session.sh").write_text(session + 'test "$NUMBER $SWEEPS" = "32 40" || exit 1\n' + rows)
        assert orders.main(["--check", "32", "40", "0.40"]) == status and capsys.readouterr().out == line
    assert orders.main(["--check", "32", "40", "0.45"]) == 1 and capsys.readouterr().out.count("only one of the tables has this run") == 4
    with pytest.raises(SystemExit, match="Usage"):
        orders.main(["--check"])


def test_orders_of_the_page():
    """The table of the page has the numbers of the reference program."""
    page = (SOURCE / "docs/tasks/nematic.rst").read_text(encoding="utf-8")
    with (SOURCE / "reference/equation_of_state/equation_of_state.csv").open(encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(file) if row["aspect"] == "3" and row["ensemble"] == "NVT"]
    for start, fraction in (("random", "0.45"), ("aligned", "0.55"), ("aligned", "0.56")):
        (row,) = (row for row in rows if (row["start"], row["target"]) == (start, fraction))
        assert f"{float(row['order']):.4f} ± {float(row['order_error']):.4f}" in page
