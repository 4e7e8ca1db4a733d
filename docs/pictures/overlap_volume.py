"""The common part of two ellipses at several places, and the area of it with its derivative along the way."""

import numpy as np
import pypw85
from style import BLACK, BLUE, GREEN, ORANGE, figure, save

FIRST = pypw85.ellipse(2.0, 1.2, 0.4)
SECOND = pypw85.ellipse(1.7, 0.5, -0.9)
WAY = np.array([1.0, 0.25])
PLACES = (0.2, 1.0, 1.9)


def outline(center, q):
    """Points (2, 401) on an ellipse."""
    angle = np.linspace(0, 2 * np.pi, 401)
    root = np.linalg.cholesky([[q[0], q[1]], [q[1], q[2]]])
    return np.asarray(center)[:, np.newaxis] + root @ [np.cos(angle), np.sin(angle)]


def is_inside(points, center, q):
    x = points - np.asarray(center)[:, np.newaxis]
    return np.einsum("in,ij,jn->n", x, np.linalg.inv([[q[0], q[1]], [q[1], q[2]]]), x) <= 1


fig, axes = figure(2, 9.0, 3.4)
ax = axes[0]
for place, color in zip(PLACES, (BLUE, ORANGE, GREEN)):
    ax.plot(*outline(place * WAY, SECOND), color=color)
    first, second = outline([0, 0], FIRST), outline(place * WAY, SECOND)
    rim = np.hstack([first[:, is_inside(first, place * WAY, SECOND)], second[:, is_inside(second, [0, 0], FIRST)]])
    middle = rim.mean(axis=1, keepdims=True)
    order = np.argsort(np.arctan2(*(rim - middle)[::-1]))  # the common part is convex
    ax.fill(*rim[:, order], color=color, alpha=0.3, linewidth=0)
ax.plot(*outline([0, 0], FIRST), color=BLACK)
ax.set(aspect="equal")
ax.axis("off")

ax = axes[1]
places = np.linspace(0, 3.2, 321)
area = pypw85.overlap_area_2d(places[:, np.newaxis] * WAY, FIRST, SECOND)
ax.plot(places, area, color=BLACK)
for place, color in zip(PLACES, (BLUE, ORANGE, GREEN)):
    ax.plot(place, pypw85.overlap_area_2d(place * WAY, FIRST, SECOND), "o", color=color)
ax.set(xlabel="place on the way", ylabel="common area", xlim=(0, 3.2), ylim=(0, None))
save(fig, "overlap_volume.svg")
