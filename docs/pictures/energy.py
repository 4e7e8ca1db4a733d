"""Energy of two soft ellipsoids in time, for two time steps (programs/dynamics.py)."""

import pathlib
import sys

import numpy as np
from style import BLUE, ORANGE, figure, save

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "programs"))
import dynamics


def main():
    fig, ax = figure(height=3.4)
    for time_step, colour in ((0.02, ORANGE), (0.01, BLUE)):
        energies, _ = dynamics.run(time_step, duration=60.0)
        ax.plot(
            time_step * np.arange(len(energies)),
            1e3 * (energies / energies[0] - 1),
            color=colour,
            label=f"time step {time_step}",
        )
    ax.set(xlabel="time (reduced units)", ylabel="$10^3\\,(E - E_0)/E_0$", xlim=(0, 60), ylim=(-1.1, 1.0))
    ax.legend(loc="lower right", frameon=True, framealpha=0.9, ncol=2)
    save(fig, "energy.svg")


main()
