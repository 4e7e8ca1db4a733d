"""Draws the ellipsoids of a dump file (box with right angles): seen along an axis, and cut in the middle. Overlapping ones are red.

    python3 draw.py file.dump picture.png [x|y|z]

Without an axis they are seen from above.
"""

import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import EllipseCollection

# The coordinates to the right, upwards, and along the view, by its axis. The eye is where z or x is large, or y is small.
VIEWS = {"x": [1, 2, 0], "y": [0, 2, 1], "z": [0, 1, 2]}


def read_last_snapshot(path):
    """Edges of the box, which axes are periodic, and the columns of the last snapshot by name."""
    lines = Path(path).read_text(encoding="utf-8").splitlines()
    start = max(i for i, line in enumerate(lines) if line == "ITEM: TIMESTEP")
    count = int(lines[start + 3])
    bounds = np.array([line.split()[:2] for line in lines[start + 5:start + 8]], dtype=float)
    periodic = [word == "pp" for word in lines[start + 4].split()[-3:]]
    names = lines[start + 8].split()[2:]
    rows = np.array([line.split() for line in lines[start + 9:start + 9 + count]], dtype=float)
    return bounds, periodic, dict(zip(names, rows.T))


def with_images(centers, bounds, periodic, *others):
    """Repeats everything to the left and right, above and below, where the box is periodic."""
    for axis in (0, 1):
        if periodic[axis]:
            shift = np.eye(3)[axis] * (bounds[axis, 1] - bounds[axis, 0])
            centers = np.concatenate([centers - shift, centers, centers + shift])
            others = [np.concatenate([values] * 3) for values in others]
    return centers, *others


def forms(columns):
    """Quadratic forms R diag(semi-axes²) Rᵀ; LAMMPS gives diameters and quaternions (w, i, j, k)."""
    squares = np.stack([columns[f"c_shape[{k}]"] / 2 for k in (1, 2, 3)], axis=1) ** 2
    w, i, j, k = (columns[f"c_shape[{n}]"] for n in (4, 5, 6, 7))
    rotation = np.array([[w*w + i*i - j*j - k*k, 2*(i*j - w*k), 2*(i*k + w*j)],
                         [2*(i*j + w*k), w*w - i*i + j*j - k*k, 2*(j*k - w*i)],
                         [2*(i*k - w*j), 2*(j*k + w*i), w*w - i*i - j*j + k*k]]).transpose(2, 0, 1)
    return np.einsum("nab,nb,ncb->nac", rotation, squares, rotation)


def ellipses(axes, centers, q, colors, **style):
    """Adds ellipses {m : (m - c)ᵀ q⁻¹ (m - c) = 1} to a plot, in the order given."""
    squares, directions = np.linalg.eigh(q)
    angles = np.degrees(np.arctan2(directions[:, 1, 1], directions[:, 0, 1]))
    minor, major = 2 * np.sqrt(squares.T)
    axes.add_collection(EllipseCollection(major, minor, angles, units="xy", offsets=centers, facecolors=colors,
                                          offset_transform=axes.transData, **style))


def draw(path, picture, axis="z"):
    bounds, periodic, columns = read_last_snapshot(path)
    axes_of_picture = VIEWS[axis]
    bounds, periodic = bounds[axes_of_picture], [periodic[k] for k in axes_of_picture]
    base = np.where(columns["c_overlap"][:, None] > 0, [0.85, 0.25, 0.2], [0.45, 0.6, 0.8])
    centers = np.stack([columns["xyz"[k]] for k in axes_of_picture], axis=1)
    q = forms(columns)[:, axes_of_picture][:, :, axes_of_picture]
    centers, q, base = with_images(centers, bounds, periodic, q, base)
    figure, (whole, cut) = plt.subplots(1, 2, figsize=(12, 6.5), constrained_layout=True)

    # The projection of an ellipsoid is the ellipse of the upper left block of its form; the farther, the darker.
    near = (centers[:, 2] - bounds[2, 0]) / (bounds[2, 1] - bounds[2, 0])
    if axis == "y":
        near = 1 - near
    order = np.argsort(near)
    shade = base * (0.35 + 0.65 * np.clip(near, 0, 1))[:, None]
    ellipses(whole, centers[order, :2], q[order, :2, :2], shade[order], edgecolors="black", linewidths=0.3)
    overlapping = np.count_nonzero(columns["c_overlap"])
    whole.set_title(f"seen along {axis}: {len(columns['id'])} ellipsoids, {overlapping} of them overlap")

    # Cut by the plane where the third coordinate is c3 + h: centre and form of the ellipse by completing the square.
    h = bounds[2].mean() - centers[:, 2]
    met = h ** 2 < q[:, 2, 2]
    h, q, centers = h[met], q[met], centers[met]
    rest = q[:, :2, :2] - q[:, :2, 2:] * q[:, 2:, :2] / q[:, 2:, 2:]
    scale = 1 - h ** 2 / q[:, 2, 2]
    ellipses(cut, centers[:, :2] + q[:, :2, 2] * (h / q[:, 2, 2])[:, None], rest * scale[:, None, None], base[met],
             edgecolors="black", linewidths=0.6, alpha=0.7)
    cut.set_title("cut in the middle")

    names = ["xyz"[k] for k in axes_of_picture]
    for axes in (whole, cut):
        axes.set(xlim=bounds[0], ylim=bounds[1], aspect="equal", xlabel=names[0], ylabel=names[1])
    figure.savefig(picture, dpi=110)


if __name__ == "__main__":
    draw(*sys.argv[1:])
