# SPDX-License-Identifier: BSD-3-Clause
"""Writes the contact problems of the reference data as plain doubles, as a machine has them, for programs that have no HDF5.

A row is r12 (3), q1 (6), q2 (6), mu2, mu2_minus_1, lambda, cond. Usage: export_problems.py REFERENCE_DATA OUTPUT big|little
"""

import sys

import h5py
import numpy as np

with h5py.File(sys.argv[1]) as file:
    contact = file["contact"]
    columns = [contact[name][...].reshape(len(contact["mu2"]), -1)
               for name in ("r12", "q1", "q2", "mu2", "mu2_minus_1", "lambda", "cond")]
np.hstack(columns).astype({"little": "<f8", "big": ">f8"}[sys.argv[3]]).tofile(sys.argv[2])
