"""f(λ), its maximum, and the scale factors of both ellipsoids, in λ and in log τ."""

import numpy as np
import pypw85
from style import BLACK, BLUE, GREEN, ORANGE, figure, save

Q1 = pypw85.ellipsoid_quaternion([4.0, 2.0, 0.5], [0.9, 0.3, 0.2, 0.1])
Q2 = pypw85.spheroid(0.6, 1.5, [1.0, 1.0, 0.5])
R12 = np.array([2.2, 1.2, 1.5])
DISC, NEEDLE = pypw85.spheroid(1.0, 1e-3, [0.3, 0.2, 1.0]), pypw85.spheroid(1e-3, 1.0, [1.0, 0.2, 0.6])


def scale_factors(lambda_, r12=R12, q1=Q1, q2=Q2):
    """(f, μ1², μ2²) from f = λμ1² + (1-λ)μ2² and f' = μ1² - μ2²."""
    out = np.empty(lambda_.shape + (3,))
    f = pypw85.legacy.f1(lambda_, r12, q1, q2, out)
    return f, f + (1 - lambda_) * out[:, 1], f - lambda_ * out[:, 1]


def draw_in_lambda(ax, mu2, best):
    lambda_ = np.linspace(0, 1, 801)
    f, mu1, mu2_ = scale_factors(lambda_)
    ax.plot(lambda_, mu1, color=BLUE, label="$\\mu_1^2$, ellipsoid 1 reaches $x_0(\\lambda)$")
    ax.plot(lambda_, mu2_, color=ORANGE, label="$\\mu_2^2$, ellipsoid 2 reaches $x_0(\\lambda)$")
    ax.plot(lambda_, f, color=GREEN, linewidth=2.5, label="$f(\\lambda)$")
    ax.fill_between(lambda_, f, np.maximum(mu1, mu2_), color=GREEN, alpha=0.12, label="where $\\mu^2$ may lie")
    ax.plot(best, mu2, "o", color=BLACK, zorder=5)
    ax.annotate(f"$\\mu^2 = {mu2:.3f}$", (best, mu2), (best - 0.14, mu2 + 0.75), arrowprops={"arrowstyle": "-"})
    ax.axhline(1, color=BLACK, linewidth=0.8, linestyle=":")
    box = {"facecolor": "white", "edgecolor": "none", "alpha": 0.85, "pad": 1}
    ax.text(0.99, 1.06, "a maximum above 1: apart", ha="right", va="bottom", fontsize=9, bbox=box)
    ax.set(xlabel="$\\lambda$", ylabel="square of a scale factor", xlim=(0, 1), ylim=(0, 3.2 * mu2))
    ax.legend(fontsize=9, loc="upper center", frameon=True, framealpha=0.9)


def draw_in_log_tau(ax):
    x = np.linspace(-12, 12, 801)
    pairs = (("the pair on the left", BLUE, Q1, Q2), ("disc and needle of aspect 1000", ORANGE, DISC, NEEDLE))
    for label, colour, q1, q2 in pairs:
        _, mu1, mu2 = scale_factors(1 / (1 + np.exp(-x)), R12, q1, q2)
        best = pypw85.contact(R12, q1, q2)[1]
        ax.plot(x, 0.5 * np.log(mu2 / mu1), color=colour, label=label)
        ax.plot(np.log(best / (1 - best)), 0, "o", color=BLACK, zorder=5)
    ax.plot(x, x, color=BLACK, linewidth=0.8, linestyle=":", label="slope 1, as for spheres")
    ax.set(xlabel="$\\log\\,\\tau = \\log[\\lambda/(1-\\lambda)]$", ylabel="$h = \\log(\\mu_2/\\mu_1)$")
    ax.set(xlim=(-12, 12), ylim=(-12, 12), title="the root of $h$ is the maximum of $f$")
    ax.legend(fontsize=9, loc="upper left", frameon=True, framealpha=0.9)


def main():
    mu2, best = pypw85.contact(R12, Q1, Q2)
    fig, (left, right) = figure(2, width=10)
    draw_in_lambda(left, mu2, best)
    draw_in_log_tau(right)
    save(fig, "function_f.svg")


main()
