"""Draws two ellipsoids, the pair scaled by μ, and the point where that pair touches, from the output of the library.

Usage: contact.py LIBRARY [PICTURE]: LIBRARY is libpw85.so, PICTURE the file to write (contact.png next to this program). A file
beside it, whose name ends in -dark, gets the picture for dark pages: with white ink, and no background. The ellipsoids have a
principal axis across the plane that is drawn.
"""

import ctypes
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np


def array(values):
    return (ctypes.c_double * len(values))(*values)


def call(function, *arguments):
    status = function(*arguments)
    if status != 0:
        raise RuntimeError(f"{function.__name__}: status {status}")


def form(library, semi_axes, angle):
    q = array([0.0] * 6)
    quaternion = array([np.cos(angle / 2), 0.0, 0.0, np.sin(angle / 2)])
    call(library.pw85_ellipsoid_quaternion, array(semi_axes), quaternion, q)
    return q


def outline(q, center, scale):
    """Points of the section z = 0: the unit circle mapped by the Cholesky factor of the form."""
    factor = np.linalg.cholesky(np.array([[q[0], q[1]], [q[1], q[3]]]))
    angles = np.linspace(0.0, 2.0 * np.pi, 400)
    return center[:, np.newaxis] + scale * factor @ np.array([np.cos(angles), np.sin(angles)])


def draw(library, path, ink, paper):
    plt.rcParams.update({"text.color": ink, "savefig.facecolor": paper})
    center1, center2 = np.array([0.0, 0.0]), np.array([3.6, 1.7])
    q1, q2 = form(library, [2.2, 1.0, 1.0], 0.35), form(library, [1.5, 0.6, 1.0], -0.9)
    r12 = array([*(center2 - center1), 0.0])
    out, point, normal = array([0.0] * 2), array([0.0] * 3), array([0.0] * 3)
    call(library.pw85_contact, r12, q1, q2, out)
    call(library.pw85_contact_geometry, r12, q1, q2, ctypes.c_double(out[1]), point, normal)
    mu, point, normal = np.sqrt(out[0]), center1 + np.array(point[:2]), np.array(normal[:2])

    figure, axes = plt.subplots(figsize=(7.5, 4.2), layout="constrained")
    tangent = np.array([-normal[1], normal[0]])
    for q, center, color, label in ((q1, center1, "C0", "1"), (q2, center2, "C1", "2")):
        axes.fill(*outline(q, center, 1.0), color=color, alpha=0.55)
        axes.plot(*outline(q, center, mu), color=color)
        axes.annotate(label, center - 0.5 * tangent, ha="center", va="center", color="white", fontsize=14)
    line = np.array([point - 1.6 * tangent, point + 1.6 * tangent])
    axes.plot(line[:, 0], line[:, 1], "--", color="gray", linewidth=1)
    axes.annotate("", point + 0.9 * normal, point, arrowprops={"arrowstyle": "->", "color": ink})
    axes.plot(*point, "o", color=ink, markersize=5)
    axes.set_title(f"μ² = {out[0]:.4f},  λ = {out[1]:.4f}: scaled by μ = {mu:.4f}, the ellipsoids touch")
    axes.set_aspect("equal")
    axes.set_axis_off()
    figure.savefig(path, dpi=120)


if __name__ == "__main__":
    pw85 = ctypes.CDLL(str(Path(sys.argv[1]).resolve()))
    picture = Path(sys.argv[2]) if len(sys.argv) > 2 else Path(__file__).with_name("contact.png")
    draw(pw85, picture, "black", "white")
    draw(pw85, picture.with_stem(f"{picture.stem}-dark"), "white", "none")
