"""The effective radius of two spheroids that touch side by side, as one turns about the normal."""

import numpy as np
from matplotlib.patches import Ellipse
from style import BLACK, BLUE, GREEN, ORANGE, figure, save

import pypw85

ASPECT = 5.0


def main():
    angles = np.linspace(0, 90, 181)
    turns = np.radians(angles)
    axes = np.stack([np.cos(turns), np.sin(turns), np.zeros_like(turns)], axis=-1)
    q1, q2 = pypw85.spheroid(1, ASPECT, [1, 0, 0]), pypw85.spheroid(1, ASPECT, axes)
    contact = pypw85.hertz_contact([0, 0, 2], q1, q2, [0, 0, 1])
    curvatures, directions, radius, ellipse = contact[2:]
    fig, ax = figure()
    ax.plot(angles, radius, color=BLUE, label="$R$")
    ax.plot(angles, 1 / np.sqrt(curvatures.prod(axis=-1)), "--", color=ORANGE, label="$1/\\sqrt{\\kappa_1\\kappa_2}$")
    ax.axhline(0.5 * ASPECT ** (1 / 3), color=BLACK, linestyle=":", linewidth=1, label="spheres of the same volume")
    for k in (20, 60, 100, 140, 176):
        (dx, dy), size = directions[k, 0, :2], 2 * np.sqrt(ellipse[k])
        inset = ax.inset_axes([angles[k] / 90 - 0.09, 0.0, 0.18, 0.26])
        inset.add_patch(Ellipse((0, 0), *size, angle=np.degrees(np.arctan2(dy, dx)), fill=False, color=GREEN))
        inset.set(xlim=(-5, 5), ylim=(-5, 5), aspect="equal")
        inset.axis("off")
    ax.set(xlabel="angle between the axes (degrees)", ylabel="radius, in units of the equatorial one", xlim=(0, 90), ylim=(0, 4))
    ax.legend()
    save(fig, "curvature.svg")


main()
