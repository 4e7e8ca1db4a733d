"""Two packings of pw85 pack, as on the page on the command: rods and plates, and rods that are packed densely."""

import numpy as np

import pypw85
from style import plt, save

plt.rcParams.update(plt.rcParamsDefault)
mixture = np.array([[0.5, 0.5, 1.5], [1.0, 1.0, 0.4]])[np.arange(200) % 2]
rods = np.tile([0.5, 0.5, 1.5], (200, 1))
figure, both = plt.subplots(1, 2, figsize=(6.5, 3.4), constrained_layout=True)
for ax, semi_axes, fraction in zip(both, (mixture, rods), (0.5, 0.68)):
    system = pypw85.pack(semi_axes, fraction, seed=1)
    system.draw(ax=ax, size=600)
    ax.set_title(f"packing fraction {system.packing_fraction:.2f}")
save(figure, "packing.png")
