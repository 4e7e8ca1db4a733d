# SPDX-License-Identifier: GPL-2.0-only
"""Contacts of all pairs of ellipsoids and all their images, through the functions of pw85 for one pair."""

import ctypes
import os

import numpy as np

LIBRARY = ctypes.CDLL(os.environ["PW85_LIBRARY"])
UNIT_ROUNDOFF = 2.0 ** -53


def call(name, *arguments):
    """Calls a function of pw85 with arrays; the last argument is the output."""
    pointers = [a if a is None or isinstance(a, (ctypes.c_double, ctypes.c_size_t)) else a.ctypes.data_as(ctypes.c_void_p)
                for a in arguments]
    status = getattr(LIBRARY, name)(*pointers)
    if status != 0:
        inputs = [[float(x).hex() for x in np.ravel(a)] for a in arguments[:-1] if isinstance(a, np.ndarray)]
        raise RuntimeError(f"{name}: status {status} for {inputs}")
    return arguments[-1]


def forms(system):
    return np.array([call("pw85_ellipsoid_quaternion", a, q, np.empty(6))
                     for a, q in zip(system.semi_axes, system.quaternions)])


def images(system, reach):
    """Translations to all images of the box that can hold a neighbour of something in the box."""
    if not system.periodic:
        return np.zeros((1, 3))
    heights = 1.0 / np.linalg.norm(np.linalg.inv(system.cell), axis=0)
    counts = np.ceil(reach / heights).astype(int) + 1  # one more: centres may have left the box
    grid = np.mgrid[tuple(slice(-n, n + 1) for n in counts)].reshape(3, -1).T
    return grid @ system.cell


def pairs(system, reach):
    """All (i, j, r12) with i < j, or j an image of i, and a distance below reach; each pair of images once."""
    for shift in images(system, reach):
        separations = system.centers[None, :, :] + shift - system.centers[:, None, :]
        close = np.argwhere((separations ** 2).sum(axis=2) < reach ** 2)
        for i, j in close:
            if i < j or (i == j and tuple(shift) > (0.0, 0.0, 0.0)):
                yield int(i), int(j), np.ascontiguousarray(separations[i, j])


def overlap(r12, q1, q2):
    return int(call("pw85_overlap", r12, q1, q2, np.zeros(1, dtype=np.intc))[0])


def overlaps(r12, q1, q2):
    """The same for many pairs, rows of arrays: 0 or 1 for each."""
    rows = [np.ascontiguousarray(a, dtype=float) for a in (r12, q1, q2)]
    return call("pw85_overlap_batch", ctypes.c_size_t(len(r12)), *rows, np.empty(len(r12), dtype=np.uint8))


def contact(r12, q1, q2):
    """μ², λ, point, normal, and a bound on the change of μ² that rounding in LAMMPS can cause."""
    mu2, lam = call("pw85_contact", r12, q1, q2, np.empty(2))
    point, normal, d_r, d_q1, d_q2 = np.empty(3), np.empty(3), np.empty(3), np.empty(6), np.empty(6)
    call("pw85_contact_geometry", r12, q1, q2, ctypes.c_double(lam), point, normal)
    call("pw85_contact_gradient", r12, q1, q2, ctypes.c_double(lam), d_r, d_q1, d_q2)
    sensitivity = {"position": np.abs(d_r).sum(), "form": np.abs(d_q1).sum() + np.abs(d_q2).sum(),
                   "entries": np.abs(d_r * r12).sum() + np.abs(d_q1 * q1).sum() + np.abs(d_q2 * q2).sum()}
    return mu2, lam, point, normal, sensitivity


def tolerance(system, sensitivity):
    """Bound on the difference of two values of μ² for the same pair, to first order.

    Each value carries 4 u cond from the solver. Positions are wrapped and shifted by vectors of the box, and pass
    through fractional coordinates if it is triclinic: fewer than 16 roundings of numbers no larger than three edges.
    Quaternions are normalised, and forms built from them, with fewer than 32 roundings relative to the largest form.
    """
    size, form = 3.0 * np.abs(system.cell).max(), system.semi_axes.max() ** 2
    return UNIT_ROUNDOFF * (8.0 * sensitivity["entries"] + 16.0 * size * sensitivity["position"]
                            + 32.0 * form * sensitivity["form"])


class Expected:
    """What the computes must say about a system."""

    def __init__(self, system, reach):
        count = len(system.centers)
        all_forms = forms(system)
        self.overlapping_pairs, self.neighbours, self.smallest = 0, np.zeros(count), np.full(count, np.inf)
        self.contacts = {}
        for i, j, r12 in pairs(system, reach):
            overlaps = overlap(r12, all_forms[i], all_forms[j])
            self.overlapping_pairs += overlaps
            for k in (i, j):
                self.neighbours[k] += overlaps
            mu2, _, point, normal, sensitivity = contact(r12, all_forms[i], all_forms[j])
            for k in (i, j):
                self.smallest[k] = min(self.smallest[k], mu2)
            bound = tolerance(system, sensitivity)
            self.contacts.setdefault((i + 1, j + 1), []).append((mu2, bound, point, normal))
