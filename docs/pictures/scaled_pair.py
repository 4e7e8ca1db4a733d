"""Two ellipsoids, the pair scaled by μ, their contact point and common normal; for light pages and for dark ones."""

import numpy as np
import pypw85
from mpl_toolkits.mplot3d import proj3d
from style import BLUE, ORANGE, SKY, YELLOW, plt, save

CENTERS = np.array([[0.0, 0.0, 0.0], [3.4, 1.4, 0.9]])
FORMS = [
    pypw85.ellipsoid_quaternion([1.8, 1.2, 0.7], [0.9, 0.2, -0.3, 0.2]),
    pypw85.ellipsoid_quaternion([0.7, 0.9, 1.9], [0.8, 0.4, 0.1, -0.3]),
]


def surface(center, q, scale):
    """Points (3, 41, 81) on an ellipsoid scaled about its centre."""
    theta, phi = np.linspace(0, np.pi, 41)[:, np.newaxis], np.linspace(0, 2 * np.pi, 81)
    sphere = np.stack(np.broadcast_arrays(np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)))
    return center[:, np.newaxis, np.newaxis] + scale * np.tensordot(np.linalg.cholesky(pypw85.full(q)), sphere, axes=1)


def annotate(ax, where, text, offset):
    """A label off the ellipsoids, with a line to the point it names."""
    x, y, _ = proj3d.proj_transform(*where, ax.get_proj())
    arrow = {"arrowstyle": "-", "linewidth": 0.8, "color": plt.rcParams["text.color"]}
    ax.annotate(text, (x, y), offset, textcoords="offset points", ha="center", fontsize=11, arrowprops=arrow, zorder=6)


def draw(name, ink, paper, wires):
    plt.rcParams.update({"text.color": ink, "figure.facecolor": paper, "savefig.facecolor": paper})
    r12 = CENTERS[1] - CENTERS[0]
    mu2, lambda_ = pypw85.contact(r12, *FORMS)
    point, normal = pypw85.contact_geometry(r12, *FORMS, lambda_)
    x0 = CENTERS[0] + point

    fig = plt.figure(figsize=(8, 4.6))
    ax = fig.add_axes((-0.1, -0.55, 1.2, 2.1), projection="3d", computed_zorder=False)
    for center, q, light, dark in zip(CENTERS, FORMS, (SKY, YELLOW), wires):
        ax.plot_surface(*surface(center, q, 1.0), color=light, rcount=41, ccount=81, linewidth=0, zorder=1)
        ax.plot_wireframe(
            *surface(center, q, np.sqrt(mu2)), color=dark, rcount=14, ccount=20, linewidth=0.5, alpha=0.7, zorder=2
        )
    ax.plot(*np.stack(CENTERS, axis=1), color=ink, linestyle=":", linewidth=1, zorder=4)
    ax.scatter(*x0, color=ink, s=35, zorder=5)
    ax.quiver(*x0, *(1.1 * normal), color=ink, linewidth=2, arrow_length_ratio=0.25, zorder=5)
    ax.view_init(22, -68)
    ax.set_aspect("equal")
    ax.set_axis_off()
    annotate(ax, x0, "contact point $x_0$", (-50, 85))
    annotate(ax, x0 + 0.8 * normal, "common normal", (30, 105))
    fig.text(0.03, 0.92, f"$\\mu^2 = {mu2:.3f}$, $\\lambda = {lambda_:.3f}$", fontsize=13)
    fig.text(
        0.03, 0.015, "solid: the two ellipsoids; wires: both scaled by $\\mu$; dotted: centre to centre", fontsize=11
    )
    ax.set_facecolor("none")
    save(fig, name)


draw("scaled_pair.png", "black", "white", (BLUE, ORANGE))
draw("scaled_pair-dark.png", "white", "none", (SKY, YELLOW))
