"""Prints the slope, in degrees, of the heap that heap.in has left in a dump file.

    python3 heap_angle.py heap.dump
"""

import sys

import numpy as np
from draw import forms, read_last_snapshot


def slope(columns):
    """Angle of the least-squares line through the highest points of grains, by their horizontal distance from the middle of the heap.

    The floor is divided into squares as wide as a grain is thick. Each gives the highest point of the grains with centres above it.
    Grains that touch no other one are falling. Near the top and the feet, within the width of a square, the surface is round: these
    points are left out.
    """
    heap = columns["c_overlap"] > 0
    x, y = columns["x"][heap], columns["y"][heap]
    top = columns["z"][heap] + np.sqrt(forms(columns)[heap, 2, 2])
    width = columns["c_shape[1]"].max()
    distance = np.abs(x - x.mean())
    straight = (distance > width) & (distance < distance.max() - width)
    highest = {}
    for n in np.flatnonzero(straight)[np.argsort(top[straight])]:
        highest[x[n] // width, y[n] // width] = n
    highest = list(highest.values())
    return np.degrees(np.arctan(-np.polyfit(distance[highest], top[highest], 1)[0]))


if __name__ == "__main__":
    print(f"slope of the heap in degrees: {slope(read_last_snapshot(sys.argv[1])[2]):.1f}")
