"""An ellipsoid, scaled until it touches a segment, a triangle and a box, in a plane of symmetry of all of them."""

import numpy as np
import pypw85
from style import BLACK, BLUE, ORANGE, SKY, figure, save

ANGLE = np.radians(25)
Q = pypw85.ellipsoid_quaternion([2.0, 1.0, 0.8], [np.cos(ANGLE / 2), 0.0, 0.0, np.sin(ANGLE / 2)])
SEGMENT = np.array([[2.0, 2.6, 0.0], [3.6, -1.0, 0.0]])
TRIANGLE = np.array([[-3.4, 2.4, 0.0], [-1.2, 2.6, 0.0], [-2.6, 0.9, 0.0]])
BOX = np.array([[0.5, -2.6, -1.0], [2.5, -1.1, 1.0]])


def outline(mu):
    """The section z = 0 of the ellipsoid, scaled by mu. z is a principal axis."""
    angle = np.linspace(0, 2 * np.pi, 201)
    return mu * np.linalg.cholesky([[Q[0], Q[1]], [Q[1], Q[3]]]) @ [np.cos(angle), np.sin(angle)]


def draw(ax, title, polygon, mu2, point):
    ax.fill(*outline(1.0), color=BLUE, alpha=0.5)
    ax.plot(*outline(np.sqrt(mu2)), color=BLUE, linestyle="--", linewidth=1.0)
    ax.fill(*polygon.T, facecolor=ORANGE, edgecolor=ORANGE, alpha=0.6, linewidth=2.0)
    ax.plot(0, 0, "k+")
    ax.plot(*point[:2], "o", color=BLACK, markersize=5)
    ax.plot([0, point[0]], [0, point[1]], color=SKY, linewidth=0.8)
    ax.set(title=f"{title}: μ = {np.sqrt(mu2):.3f}", aspect="equal", xlim=(-4.2, 4.2), ylim=(-3.2, 3.2))


def main():
    fig, axes = figure(3, width=10, height=3.2)
    draw(axes[0], "segment", SEGMENT[:, :2], *pypw85.contact_segment(*SEGMENT, Q))
    draw(axes[1], "triangle", TRIANGLE[:, :2], *pypw85.contact_triangle(*TRIANGLE, Q))
    (left, low, _), (right, high, _) = BOX
    corners = np.array([[left, low], [right, low], [right, high], [left, high]])
    draw(axes[2], "box", corners, *pypw85.contact_box(*BOX, Q))
    save(fig, "shapes.svg")


main()
