#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Volumes of common parts to 22 digits, for tests/volume_truths.inc.

    scripts/volume_truths.py >tests/volume_truths.inc

Two computations that share nothing have to agree, and share nothing with the library either. The first is printed. The second
converges slowly where the number of crossings depends on the direction, so that only five digits are compared:

- Slices: one ellipsoid becomes the unit ball, the principal axes of the other one become the axes. The common area of a disc and an
  axis-parallel ellipse is a sum of sectors between their crossings, which are roots of a quartic. It is integrated over the heights,
  between the heights at which the number of crossings changes.
- Radii: the common part is star-shaped about a common point. A third of the cube of the shorter radius is integrated over directions, in
  polar angles about a fixed direction in space, between the angles at which the radii are equal.
"""

import sys
from itertools import pairwise

from mpmath import atan2, cholesky, cos, eigsy, findroot, inverse, matrix, mp, mpf, pi, polyroots, quad, sin, sqrt

mp.dps = 32

# Forms by their six entries, as doubles: the squares and products are exact.
CASES = [
    # r12, q1, q2
    ((0, 0, 1.5), (100, 0, 0, 1, 0, 1), (1, 0, 0, 100, 0, 1)),  # semi-axes 10, 1, 1 and the same turned by 90° about z
    ((0.5, 0.25, -0.125), (4, 0.5, 0, 1, 0.25, 2.25), (1, 0, 0.5, 2, -0.5, 3)),
    ((1, -0.5, 0.75), (1, 0.25, 0.125, 1.5, 0.5, 2), (2, -0.5, 0.25, 1, 0.125, 0.75)),
    ((0.125, 0.25, 0.0625), (16, 1, 2, 0.5, 0.125, 1), (1, 0, 0, 1, 0, 1)),  # a long one through a ball
    ((0.125, 0.25, 0.0625), (16, 1, 2, 9, 0.125, 0.5), (1, 0, 0, 1, 0, 1)),  # a flat one through a ball
    ((1.25, 0.5, 0.5), (1, 0, 0, 1, 0, 1), (0.25, 0.0625, 0, 0.5, 0, 1)),  # a lens
]


def symmetric(q):
    return matrix([[q[0], q[1], q[2]], [q[1], q[3], q[4]], [q[2], q[4], q[5]]])


def outside(x, y, c, b):
    return ((x - c[0]) / b[0]) ** 2 + ((y - c[1]) / b[1]) ** 2 - 1


def crossings(a2, c, b):
    """The angles at which the circle about 0 with the squared radius a2 crosses an axis-parallel ellipse with centre c and semi-axes b."""
    a = sqrt(a2)
    p = [-1, 0, -2, 0, -1]  # with t = tan(θ/2) on the circle: a quartic in t
    # a (1 - t²) - center (1 + t²), and 2 a t - center (1 + t²), over half
    for u in ([(a - c[0]) / b[0], 0, (-a - c[0]) / b[0]], [-c[1] / b[1], 2 * a / b[1], -c[1] / b[1]]):
        for i in range(3):
            for j in range(3):
                p[i + j] += u[i] * u[j]
    roots = polyroots(p[::-1], maxsteps=400, extraprec=200)
    return sorted(2 * atan2(mp.re(t), 1) for t in roots if abs(mp.im(t)) < mpf(10) ** -25 * (1 + abs(t)))


def common_area(a2, c, b):
    """The common area of that disc and that ellipse."""
    a, angles = sqrt(a2), crossings(a2, c, b)
    if len(angles) < 2:
        if outside(a, 0, c, b) < 0:
            return pi * a2
        return pi * b[0] * b[1] if c[0] ** 2 + c[1] ** 2 < a2 and b[0] * b[1] < a2 else mpf(0)
    area = mpf(0)
    for k, start in enumerate(angles):
        end = angles[(k + 1) % len(angles)] + (2 * pi if k + 1 == len(angles) else 0)
        middle = (start + end) / 2
        if outside(a * cos(middle), a * sin(middle), c, b) < 0:
            area += a2 * (end - start) / 2  # ½∮ x dy - y dx along the circle
            continue
        # along the ellipse, from the crossing at `start` to that at `end`
        first, last = ((a * cos(t) - c[0], a * sin(t) - c[1]) for t in (start, end))
        e0, e1 = atan2(first[1] / b[1], first[0] / b[0]), atan2(last[1] / b[1], last[0] / b[0])
        while e1 < e0:
            e1 += 2 * pi
        dx, dy = last[0] - first[0], last[1] - first[1]
        area += (b[0] * b[1] * (e1 - e0) + c[0] * dy - c[1] * dx) / 2
    return area


def by_slices(r, q1, q2):
    lower = cholesky(symmetric(q1))
    inner = inverse(lower)
    values, vectors = eigsy(inner * symmetric(q2) * inner.T)
    c = vectors.T * (inner * matrix(r))
    axes = [sqrt(v) for v in values]

    def section(z):
        share = 1 - ((z - c[2]) / axes[2]) ** 2
        root = sqrt(share) if share > 0 else None
        return 1 - z * z, (c[0], c[1]), root and (axes[0] * root, axes[1] * root)

    low, high = max(-mpf(1), c[2] - axes[2]), min(mpf(1), c[2] + axes[2])

    def area(z):
        a2, center, b = section(z)
        return common_area(a2, center, b) if a2 > 0 and b else mpf(0)

    n = 120
    shares = [(k + mpf(1) / 3) / n for k in range(n)]
    shares += [s for k in range(1, 40) for s in (mpf(2) ** -k / 200, 1 - mpf(2) ** -k / 200)]  # near the ends, sections are small
    grid = [low + (high - low) * share for share in sorted(shares)]
    ends = [low]
    for x, y in pairwise(grid):
        kind = len(crossings(*section(x)))
        if kind == len(crossings(*section(y))):
            continue
        for _ in range(100):
            middle = (x + y) / 2
            x, y = (middle, y) if len(crossings(*section(middle))) == kind else (x, middle)
        ends.append(x)
    ends.append(high)
    # The area has singularities near the real axis, too: parts of each interval.
    volume = sum(quad(area, [x + (y - x) * k / 8 for k in range(9)]) for x, y in pairwise(ends))
    return volume * lower[0, 0] * lower[1, 1] * lower[2, 2]


def by_radii(r, q1, q2):
    forms = [inverse(symmetric(q1)), inverse(symmetric(q2))]
    centers = [matrix([0, 0, 0]), matrix(r)]

    # a common point: between the centres, where both are below 1
    def level(k, x):
        d = x - centers[k]
        return (d.T * forms[k] * d)[0]

    share = min((max(level(0, matrix(r) * s), level(1, matrix(r) * s)), s) for s in (mpf(k) / 64 for k in range(65)))
    assert share[0] < 1
    point = matrix(r) * share[1]

    def radius(k, n):
        d = point - centers[k]
        a, b, c = (n.T * forms[k] * n)[0], (n.T * forms[k] * d)[0], (d.T * forms[k] * d)[0] - 1
        root = sqrt(b * b - a * c)
        return -c / (b + root) if b > 0 else (root - b) / a

    def direction(theta, phi):
        return matrix([sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta)])

    def along(phi):
        def difference(theta):
            n = direction(theta, phi)
            return radius(0, n) - radius(1, n)

        n = 48
        grid = [pi * k / n for k in range(n + 1)]
        values = [difference(t) for t in grid]
        ends = [mpf(0)]
        for k in range(n):
            if values[k] * values[k + 1] < 0:
                ends.append(findroot(difference, (grid[k], grid[k + 1]), solver="anderson"))
        ends.append(pi)

        def cone(theta):
            n = direction(theta, phi)
            return min(radius(0, n), radius(1, n)) ** 3 * sin(theta) / 3

        return sum(quad(cone, [x, y], method="gauss-legendre") for x, y in pairwise(ends))

    return along


def periodic_mean(function, digits):
    """The mean over a turn, by the trapezoidal rule."""
    n = 16
    total = sum(function(2 * pi * k / n) for k in range(n))
    mean = total / n
    while n < 512:
        total += sum(function(2 * pi * (k + mpf(1) / 2) / n) for k in range(n))
        n *= 2
        before, mean = mean, total / n
        if abs(mean - before) < mpf(10) ** (-digits / 2) * mean:
            return mean
    return mean


def main():
    print("// Volumes of common parts: r12, q1, q2, volume. Made by scripts/volume_truths.py.")
    for r, q1, q2 in CASES:
        slices = by_slices(r, q1, q2)
        mp.dps = 18
        along = by_radii(r, q1, q2)
        radii = periodic_mean(along, 16) * 2 * pi
        mp.dps = 32
        print(mp.nstr(slices, 25), mp.nstr(radii, 25), file=sys.stderr)
        assert abs(slices - radii) < mpf(10) ** -5 * slices
        rows = ", ".join("{" + ", ".join(repr(float(x)) for x in row) + "}" for row in (r, q1, q2))
        print(f'{{{rows}, "{mp.nstr(slices, 22)}"}},')


main()
