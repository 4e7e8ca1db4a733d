"""The smallest ellipse around points, and that around the most central nine tenths of samples with outliers."""

import numpy as np
import pypw85
from style import BLACK, BLUE, ORANGE, figure, save


def outline(center, q):
    """Points (2, 201) on an ellipse."""
    angle = np.linspace(0, 2 * np.pi, 201)
    root = np.linalg.cholesky([[q[0], q[1]], [q[1], q[2]]])
    return np.asarray(center)[:, np.newaxis] + root @ [np.cos(angle), np.sin(angle)]


def is_on(center, q, points):
    """Whether points are on the ellipse, up to the tolerance."""
    z = (points - center).T
    return (z * np.linalg.solve([[q[0], q[1]], [q[1], q[2]]], z)).sum(axis=0) > 1 - 1e-5


random = np.random.default_rng(3)
points = random.uniform(-1, 1, (40, 2)) @ [[1.6, 0.5], [0.0, 0.8]]
samples = np.concatenate([random.normal(size=(270, 2)) @ [[0.6, 0.3], [0.0, 0.3]], random.uniform(-2, 2, (30, 2))])
fig, axes = figure(2, 9.0, 3.6)
center, q, excess = pypw85.enclosing_ellipsoid(points, 1e-9)
on = is_on(center, q, points)
axes[0].plot(*points[~on].T, "o", color=BLACK, markersize=3)
axes[0].plot(*points[on].T, "o", color=ORANGE, markersize=6)
axes[0].plot(*outline(center, q), color=BLUE)
axes[1].plot(*samples.T, "o", color=BLACK, markersize=2)
axes[1].plot(*outline(*pypw85.enclosing_ellipsoid(samples)[:2]), color=BLUE, linestyle="--")
axes[1].plot(*outline(*pypw85.credible_ellipsoid(samples, 0.9)[:2]), color=BLUE)
for ax in axes:
    ax.set_aspect("equal")
    ax.axis("off")
save(fig, "enclosing.svg")
