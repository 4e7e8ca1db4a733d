#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks the criterion of include/pw85/overlap/exact_containment.hpp in rational numbers against 60 digits.

Usage: containment_roots.py [PAIRS]

The criterion is written out here anew, for rational pairs of ellipses and ellipsoids: random ones near tangency, and small
integers with their coincidences. The truth is the least value of g(nu) = nu + r^T (Q1 - Q2/nu)^-1 r by golden section. The
script fails if the two differ for a pair, or if a branch of the criterion was never taken.
"""

import random
import sys
from collections import Counter
from decimal import Decimal, getcontext
from fractions import Fraction

getcontext().prec = 60
GOLDEN = (Decimal(5).sqrt() - 1) / 2


def gap(r, q1, q2, nu):
    """g(nu) - 1 in decimals; infinite where Q1 - Q2/nu is not positive definite."""
    n = len(r)
    m = [[q1[i][j] - q2[i][j] / nu for j in range(n)] for i in range(n)]
    x, value = list(r), nu - 1
    for k in range(n):
        if m[k][k] <= 0:
            return Decimal("Infinity")
        value += x[k] * x[k] / m[k][k]
        for i in range(k + 1, n):
            factor = m[i][k] / m[k][k]
            x[i] -= factor * x[k]
            for j in range(k + 1, n):
                m[i][j] -= factor * m[k][j]
    return value


def least_gap(r, q1, q2):
    """The least of g(nu) - 1 over 0 < nu <= 2."""

    def decimals(x):
        return [decimals(y) for y in x] if isinstance(x, list) else Decimal(x.numerator) / Decimal(x.denominator)

    r, q1, q2 = decimals(r), decimals(q1), decimals(q2)
    low, high = Decimal(0), Decimal(2)
    while gap(r, q1, q2, high) == Decimal("Infinity"):
        high *= 2
    for _ in range(250):
        left, right = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
        at_left, at_right = gap(r, q1, q2, left), gap(r, q1, q2, right)
        if at_left == Decimal("Infinity") or at_left > at_right:
            low = left
        else:
            high = right
    return gap(r, q1, q2, high)


def adjugate(q):
    if len(q) == 2:
        return [[q[1][1], -q[0][1]], [-q[1][0], q[0][0]]]
    rows = range(3)
    return [
        [
            q[(j + 1) % 3][(i + 1) % 3] * q[(j + 2) % 3][(i + 2) % 3] - q[(j + 1) % 3][(i + 2) % 3] * q[(j + 2) % 3][(i + 1) % 3]
            for j in rows
        ]
        for i in rows
    ]


def contract(a, b):
    return sum(x * y for rows in zip(a, b) for x, y in zip(*rows))


def shifted_form(r, q1, q2):
    """m0, m1, m2 and n0, n1, n2, n3: in two dimensions those of a flat pair of ellipsoids, with m2 = n3 = 0."""
    n = [[x - y for x, y in zip(*rows)] for rows in zip(q1, q2)]
    outer = [[x * y for y in r] for x in r]
    adj1, adj2 = adjugate(n), adjugate(q2)
    det1, det2 = (contract([a[0]], [q[0]]) for a, q in ((adj1, n), (adj2, q2)))
    if len(r) == 2:
        return contract(outer, adj1), contract(outer, adj2), 0, det1, contract(adj1, q2), det2, 0
    total = adjugate([[x + y for x, y in zip(*rows)] for rows in zip(n, q2)])
    mixed = [[x - y - z for x, y, z in zip(*rows)] for rows in zip(total, adj1, adj2)]
    forms = (contract(outer, adj1), contract(outer, mixed), contract(outer, adj2))
    return *forms, det1, contract(adj1, q2), contract(adj2, n), det2


def sign(x):
    return (x > 0) - (x < 0)


def sign_at_larger_root(m, c0, c1, c2):
    """The sign of c0 + c1 w + c2 w^2 at the larger root of m0 w^2 - m1 w + m2."""
    m0, m1, m2 = m
    x, y = m0 * c0 - c2 * m2, m0 * c1 + c2 * m1
    product = sign(x * x + y * (m1 * c0 + m2 * c1))
    total = sign(m1 * y + 2 * m0 * x)
    if product < 0:
        return sign(y)
    return total if product > 0 or total == sign(y) else 0


def has_real_roots(a, b, c, d, e):
    """Whether all roots of a quartic are real, of which two are known to be."""
    i = 12 * a * e - 3 * b * d + c * c
    j = 72 * a * c * e + 9 * b * c * d - 27 * a * d * d - 27 * e * b * b - 2 * c**3
    discriminant = 4 * i**3 - j * j
    return discriminant > 0 or (discriminant == 0 and 2 * a * j + i * (3 * b * b - 8 * a * c) >= 0)


def contains(r, q1, q2):
    """Whether ellipsoid 2 is inside ellipsoid 1, and the branch that says so."""
    m0, m1, m2, n0, n1, n2, n3 = shifted_form(r, q1, q2)
    if not any(r):
        return n0 >= 0 and n1 >= 0 and n2 >= 0, "concentric"
    if not (n0 > 0 and n1 > 0 and n2 > 0):
        return False, "difference"
    p3, p2, p1 = n0 - m0 + m1, m1 - n1 - m2, n2 - m2
    if not (p3 > 0 and p2 < 0 and p1 > 0):
        return False, "coefficients"
    if not has_real_roots(-m0, p3, p2, p1, -n3):
        return False, "complex"
    m = (m0, m1, m2)
    first = sign_at_larger_root(m, n2 + 2 * m2, 2 * m2 - 2 * n1 - m1, 3 * n0 - m1)
    if first > 0:
        return True, "first derivative"
    second = sign_at_larger_root(m, m1 - n1 + 5 * m2, 3 * (n0 - m0 - m1), 0)
    if second > 0:
        return True, "second derivative"
    if sign_at_larger_root(m, p3, -4 * m0, 0) > 0:
        return True, "third derivative"
    if first < 0:
        return False, "real"
    if m1 * m1 != 4 * m0 * m2:
        return True, "double root"
    return second == 0, "root of higher order" if second == 0 else "double root of both"


def random_form(rng, dimension, limit):
    """L L^T of small integers, often diagonal."""
    diagonal = rng.random() < 0.5
    lower = [[0] * dimension for _ in range(dimension)]
    for i in range(dimension):
        for j in range(i):
            lower[i][j] = 0 if diagonal else rng.randint(-limit, limit)
        lower[i][i] = rng.randint(1, limit)
    return [[Fraction(sum(x * y for x, y in zip(p, q))) for q in lower] for p in lower]


def draw(rng, number):
    """A pair: small integers, or one scaled to be near tangency."""
    dimension = 2 + number % 2
    q1, q2 = (random_form(rng, dimension, limit) for limit in (5, 3))
    r = [Fraction(rng.randint(-2, 2), rng.choice([1, 2, 4])) for _ in range(dimension)]
    if number % 3 == 0:
        r = [x * rng.randint(0, 1) for x in r]
    if number % 3 != 1:
        return r, q1, q2
    gap_of_pair = least_gap(r, q1, q2)
    if not any(r) or gap_of_pair == Decimal("Infinity"):
        return r, q1, q2
    factor = Fraction(1 + gap_of_pair) * (1 + Fraction(rng.choice([-1, 1]), 10 ** rng.randint(1, 20)))
    return r, [[factor * x for x in row] for row in q1], q2


def tangent_flat_pair(dimension, number):
    """A pair that touches where Q1 - Q2/nu is singular, an ellipsoid in a ball, or one that is moved a little from there.

    The largest semi-axis c lies at height h in the unit ball. At nu = c^2 the gauge nu + h^2/(1 - s^2/nu) is 1 if the semi-axis s
    along the height is that of s^2 = c^2 (1 - h^2/(1 - c^2)).
    """
    c2 = Fraction(16, 25)
    h = Fraction(3, 5) * Fraction(number % 5 + 1, 8)
    s2 = c2 * (1 - h * h / (1 - c2))
    wide = c2 if number % 2 == 0 else c2 / 2
    axes = [c2, s2] if dimension == 2 else [c2, wide, s2]
    r = [Fraction(0)] * (dimension - 1) + [h * (1 + Fraction(number % 3 - 1, 1000))]
    one = [[Fraction(int(i == j)) for j in range(dimension)] for i in range(dimension)]
    return r, one, [[axes[i] * (i == j) for j in range(dimension)] for i in range(dimension)]


def main():
    pairs = int(sys.argv[1]) if len(sys.argv) > 1 else 2000
    rng = random.Random(85)
    branches, wrong = Counter(), 0
    special = [tangent_flat_pair(dimension, n) for dimension in (2, 3) for n in range(30)]
    for pair in special + [draw(rng, number) for number in range(pairs)]:
        answer, branch = contains(*pair)
        truth = least_gap(*pair)
        branches[branch] += 1
        # Golden section is right to some 1e-48 here, and no pair that is not tangent is as near as 1e-40.
        if answer != (truth < Decimal("1e-40")):
            wrong += 1
            print("wrong:", answer, branch, f"{truth:.3e}", [[str(x) for x in pair[0]], *map(str, pair[1:])])
    print(dict(branches))
    return wrong != 0 or len(branches) < 11


if __name__ == "__main__":
    sys.exit(main())
