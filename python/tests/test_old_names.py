# SPDX-License-Identifier: BSD-3-Clause
"""Names of the Python packages of pw85 1.0 and 2.0 that the manual of 1.0 does not explain."""

import os
import pathlib
import sys

import numpy as np
import pytest

import pypw85
import pypw85.utils

Q = np.array([1.0, 0, 0, 1, 0, 1])


def test_f_neg(random_pairs):
    pairs = random_pairs(10)
    np.testing.assert_array_equal(pypw85.f_neg(0.25, *pairs), -pypw85.f(0.25, *pairs))
    assert pypw85.f_neg(0.5, np.array([3.0, 0, 0]), Q, Q) == -2.25
    with pytest.raises(pypw85.PW85Error):
        pypw85.f_neg(0.5, [3, 0, 0], Q, -Q)


def test_lambda_atol():
    assert pypw85.lambda_atol == 1e-6
    header = pathlib.Path(os.environ["PYPW85_SOURCE"]) / "include" / "pw85.h"
    assert f"PW85_LAMBDA_ATOL {pypw85.lambda_atol:.0e}".replace("e-06", "e-6") in header.read_text(encoding="utf-8")


def test_metadata():
    keys = {"author", "author_email", "description", "license", "name", "url", "version", "year"}
    assert set(pypw85.metadata) == keys
    assert pypw85.metadata["version"] == pypw85.__version__
    assert pypw85.metadata["license"] == "BSD-3-Clause"


def test_in_place_calls():
    """Version 2.0 returned nothing but status 0 and wrote to arrays; an old program that ignores results works."""
    q, l, x, out = np.empty(6), np.empty(6), np.empty(3), np.empty(2)
    pypw85.spheroid(1.0, 2.0, np.array([0.0, 0, 1]), q)
    np.testing.assert_array_equal(q, [1, 0, 0, 1, 0, 4])
    pypw85._cholesky_decomp(q, l)
    np.testing.assert_array_equal(l, [1, 0, 0, 1, 0, 2])
    pypw85._cholesky_solve(l, np.array([1.0, 2, 8]), x)
    np.testing.assert_array_equal(x, [1, 2, 2])
    pypw85.contact_function(np.array([3.0, 0, 0]), Q, Q, out)
    np.testing.assert_array_equal(out, [2.25, 0.5])


@pytest.mark.parametrize(
    ("system", "file"),
    [
        ("linux", ".pypw85/pypw85.cfg"),
        ("darwin", "Library/Application Support/pypw85/pypw85.cfg"),
        ("win32", "pypw85/pypw85.cfg"),
    ],
)
def test_configuration(system, file, tmp_path, monkeypatch):
    """The file that programs for version 1.0 have: its names are those of 1.0's own pypw85/utils.py."""
    for name in ("HOME", "USERPROFILE", "APPDATA"):
        monkeypatch.setenv(name, str(tmp_path))
    monkeypatch.setattr(sys, "platform", system)
    configuration = tmp_path / file
    with pytest.raises(RuntimeError, match="the configuration file .*pypw85.cfg does not exist"):
        pypw85.utils.get_config_option("datadir")
    configuration.parent.mkdir(parents=True)
    configuration.write_text("[pw85]\nlibpw85 = /usr/lib/libpw85.so\ndatadir = /données/100%\n", encoding="utf-8")
    assert pypw85.utils.get_config_dir() == str(configuration.parent)
    assert pypw85.utils.get_config_option("datadir") == "/données/100%"
    with pytest.raises(KeyError, match="other"):
        pypw85.utils.get_config_option("other")
