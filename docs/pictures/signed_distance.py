"""Level lines of the signed distance of two ellipsoids, as ellipsoid 2 moves in a plane."""

import numpy as np
from style import BLACK, BLUE, GREEN, ORANGE, figure, save

import pypw85


def main():
    q1 = pypw85.from_rotation_vector([3.0, 1.0, 1.0], [0, 0, 0.4])
    q2 = pypw85.from_rotation_vector([1.0, 0.5, 0.5], [0, 0, -0.6])
    x, y = np.meshgrid(np.linspace(-6, 6, 181), np.linspace(-4, 4, 121))
    r12 = np.stack([x, y, np.zeros_like(x)], axis=-1)
    distance = pypw85.signed_distance(r12, q1, q2)[0]
    fig, ax = figure(height=3.8)
    ax.contour(x, y, distance, levels=[0.5, 1, 1.5, 2], colors=BLUE, linewidths=1)
    ax.contour(x, y, distance, levels=[-1, -0.75, -0.5, -0.25], colors=ORANGE, linewidths=1, linestyles="solid")
    ax.contour(x, y, distance, levels=[0], colors=BLACK, linewidths=2)
    for center in ([3.6, 0.2], [1.2, 1.6], [-2.0, -3.2]):
        start = np.array([*center, 0.0])
        normal = pypw85.signed_distance_derivatives(start, q1, q2)[0]
        ax.annotate("", start[:2] + 0.7 * normal[:2], center, arrowprops={"arrowstyle": "->", "color": GREEN})
        ax.plot(*center, "o", color=GREEN, markersize=3)
    ax.set(xlabel="$x$ of the centre of ellipsoid 2", ylabel="$y$", aspect="equal")
    save(fig, "signed_distance.svg")


main()
