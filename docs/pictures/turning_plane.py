"""Closest approach of the ellipses that a plane through the line of centres cuts out, as the plane turns."""

import numpy as np
import pypw85
from style import BLACK, BLUE, GREEN, ORANGE, figure, save

D = np.array([1.0, 0.0, 0.0])
E, F = np.array([0.0, 1.0, 0.0]), np.array([0.0, 0.0, 1.0])
Q1 = pypw85.ellipsoid_quaternion([10.0, 4.0, 2.0], [0.9, 0.15, 0.25, 0.3])
Q2 = pypw85.ellipsoid_quaternion([8.0, 6.0, 2.0], [0.7, -0.5, 0.3, -0.4])


def section(q, plane):
    """Form of the ellipse in the plane spanned by the columns of `plane` (3, 2)."""
    s = np.linalg.inv(plane.T @ np.linalg.inv(pypw85.full(q)) @ plane)
    return np.array([s[0, 0], s[0, 1], s[1, 1]])


def plane(theta):
    return np.stack([D, np.cos(theta) * E + np.sin(theta) * F], axis=1)


def distance(theta):
    p = plane(theta)
    return pypw85.zheng_ellipses([1.0, 0.0], section(Q1, p), section(Q2, p))


def outline(q):
    angle = np.linspace(0, 2 * np.pi, 201)
    return np.linalg.cholesky([[q[0], q[1]], [q[1], q[2]]]) @ [np.cos(angle), np.sin(angle)]


def draw_sections(ax, theta, title):
    p = plane(theta)
    shift = distance(theta)
    for q, centre, colour in ((section(Q1, p), 0.0, BLUE), (section(Q2, p), shift, ORANGE)):
        x, y = outline(q)
        ax.fill(x + centre, y, color=colour, alpha=0.5)
        ax.plot(centre, 0, "k+")
    ax.plot([0, shift], [0, 0], color=BLACK, linewidth=0.8)
    box = {"facecolor": "white", "edgecolor": "none", "alpha": 0.85, "pad": 1}
    ax.text(shift / 2, 0.5, f"{shift:.2f}", ha="center", fontsize=9, bbox=box)
    ax.set(title=title, xlabel="along the line of centres", aspect="equal", xlim=(-8, 18), ylim=(-9, 9))


def main():
    thetas = np.linspace(0, np.pi, 361)
    distances = np.array([distance(theta) for theta in thetas])
    best, worst = thetas[np.argmax(distances)], thetas[np.argmin(distances)]
    exact = pypw85.closest_approach(D, Q1, Q2)

    fig, axes = figure(3, width=10, height=3.6)
    axes[0].plot(np.degrees(thetas), distances, color=GREEN, label="ellipses in the plane")
    axes[0].axhline(exact, color=BLACK, linestyle="--", label="ellipsoids")
    axes[0].plot(np.degrees([worst, best]), [distances.min(), distances.max()], "o", color=BLACK)
    axes[0].set(
        xlabel="angle of the plane [°]", ylabel="distance of closest approach", xlim=(0, 180), xticks=range(0, 181, 45)
    )
    axes[0].set_ylim(distances.min() - 1, exact + 2.6)
    axes[0].legend(fontsize=9, loc="upper left")
    draw_sections(axes[1], worst, f"least, plane at {np.degrees(worst):.0f}°")
    draw_sections(axes[2], best, f"largest, plane at {np.degrees(best):.0f}°")
    save(fig, "turning_plane.svg")


main()
