"""Ellipsoids at rest in the hopper of examples/python/hopper.py, from the side, without those in front."""

import sys

import numpy as np
import pypw85
from style import BLACK, BLUE, HERE, ORANGE, figure, save

EXAMPLE = HERE.parents[1] / "examples/python"
sys.path.insert(0, str(EXAMPLE))
from hopper import fill  # noqa: E402

SIDE = [0, 2]


def outline(center, q):
    """Points (2, 25) on the projection of an ellipsoid to the plane of the picture."""
    angle = np.linspace(0, 2 * np.pi, 25)
    root = np.linalg.cholesky(pypw85.full(q)[np.ix_(SIDE, SIDE)])
    return center[SIDE][:, np.newaxis] + root @ [np.cos(angle), np.sin(angle)]


mesh = pypw85.Mesh.read(EXAMPLE / "hopper.stl")
centers, q = fill(mesh, 150)
leans = mesh.contact(centers, q)[0] < 1.05
fig, ax = figure(width=4.4, height=4.8)
for triangle in mesh.triangles:
    ax.plot(*mesh.vertices[np.append(triangle, triangle[0])][:, SIDE].T, color=BLACK, linewidth=0.4, alpha=0.5)
for n in np.argsort(-centers[:, 1]):  # the nearest to the eye comes last
    if centers[n, 1] > -0.4:
        ax.fill(*outline(centers[n], q[n]), facecolor=ORANGE if leans[n] else BLUE, edgecolor="white", linewidth=0.5)
ax.set_aspect("equal")
ax.axis("off")
save(fig, "filled_hopper.svg")
