"""The contact function along straight ways, and the closest passages."""

import numpy as np
import pypw85
from style import BLUE, GREEN, ORANGE, figure, save

Q1 = pypw85.ellipsoid_quaternion([2.0, 1.2, 0.7], [0.9, 0.2, -0.3, 0.2])
Q2 = pypw85.ellipsoid_quaternion([0.7, 0.9, 1.9], [0.8, 0.4, 0.1, -0.3])
WAYS = [
    ([-5, 2.8, 1.4], [1, 0, 0], "passes"),
    ([-5, 0.5, 0], [1, 0.1, 0.1], "overlaps on its way"),
    ([-5, 3.5, 0], [0.45, 0, 0], "ends before"),
]
END = 8.0

fig, ax = figure()
t = np.linspace(0, END, 401)
for (r12, velocity, label), color in zip(WAYS, (BLUE, ORANGE, GREEN)):
    r12, velocity = np.array(r12), np.array(velocity)
    mu2, _ = pypw85.contact(r12 + t[:, np.newaxis] * velocity, Q1, Q2)
    least, when = pypw85.closest_passage(r12, Q1, Q2, velocity, END)
    ax.plot(t, mu2, color=color, label=label)
    ax.plot(when, least, "o", color=color, clip_on=False, zorder=3)
ax.axhline(1.0, color="black", linestyle=":", linewidth=1)
ax.set(xlabel="$t$", ylabel="$\\mu^2$", xlim=(0, END), ylim=(0, 8))
ax.legend()
save(fig, "closest_passage.svg")
