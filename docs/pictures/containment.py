"""Ellipses that are inside an ellipse, cross it, and are outside of it, with the ellipse scaled to contain them."""

import numpy as np
import pypw85
from style import BLACK, BLUE, ORANGE, figure, save

OUTER = pypw85.ellipse(2.0, 1.3, 0.3)
INNER = pypw85.ellipse(0.9, 0.35, -0.6)
PLACES = np.array([[-0.5, 0.1], [1.5, 0.9], [3.0, -1.2]])


def outline(center, q, scale=1.0):
    """Points (2, 201) on an ellipse scaled about its centre."""
    angle = np.linspace(0, 2 * np.pi, 201)
    root = np.linalg.cholesky([[q[0], q[1]], [q[1], q[2]]])
    return np.asarray(center)[:, np.newaxis] + scale * root @ [np.cos(angle), np.sin(angle)]


fig, axes = figure(3, 9.0, 3.0)
for ax, place in zip(axes, PLACES):
    mu2, point = pypw85.containment_2d(place, OUTER, INNER)
    ax.fill(*outline([0, 0], OUTER), facecolor=BLUE, alpha=0.25, edgecolor=BLUE)
    ax.fill(*outline(place, INNER), facecolor=ORANGE, alpha=0.4, edgecolor=ORANGE)
    ax.plot(*outline([0, 0], OUTER, np.sqrt(mu2)), color=BLUE, linestyle="--")
    ax.plot(*point, "o", color=BLACK, markersize=5)
    ax.set_title(f"$\\kappa = {np.sqrt(mu2):.3f}$")
    ax.set(xlim=(-5.6, 5.6), ylim=(-4.0, 4.0), aspect="equal")
    ax.axis("off")
save(fig, "containment.svg")
