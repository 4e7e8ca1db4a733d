"""Checks proofs of overlaps in rational numbers alone: nothing that pw85 computes is trusted.

pypw85.overlap_witness() says that two ellipsoids are apart and gives a number λ with f(λ) > 1, or that they overlap and gives a point
inside both. Without either it says that they touch. Every double is a rational number, so fractions.Fraction decides each claim:

- f(λ) = λ(1-λ) rᵀ N⁻¹ r > 1, N = (1-λ) Q1 + λ Q2: the matrix N bordered by r, with λ(1-λ) rᵀ below it and 1 in the corner, has a
  negative determinant. f > 1 somewhere in (0, 1) means that some plane separates the ellipsoids.
- x is inside of the ellipsoid of Q about c, (x-c)ᵀ Q⁻¹ (x-c) < 1: Q bordered by x - c in the same way has a positive determinant.
- They touch: p(t) = det(Q1 + t Q2) (1 - t rᵀ(Q1 + t Q2)⁻¹r/(1 + t)) (1 + t) has a positive root, and is not negative for t > 0.
"""

from fractions import Fraction
from itertools import pairwise, zip_longest

import numpy as np
import pypw85


def matrix(q):
    xx, xy, xz, yy, yz, zz = map(Fraction, q)
    return [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]


def determinant(a):
    if not a:
        return Fraction(1)
    minors = ([row[:j] + row[j + 1 :] for row in a[1:]] for j in range(len(a)))
    return sum((-1) ** j * a[0][j] * determinant(minor) for j, minor in enumerate(minors))


def bordered(a, x, weight):
    """det A (1 - weight·xᵀA⁻¹x)."""
    return determinant([[*row, y] for row, y in zip(a, x)] + [[*(weight * y for y in x), Fraction(1)]])


def blend(a, q1, b, q2):
    return [[a * x + b * y for x, y in zip(row1, row2)] for row1, row2 in zip(q1, q2)]


def proves_apart(r, q1, q2, lambda_):
    return 0 < lambda_ < 1 and bordered(blend(1 - lambda_, q1, lambda_, q2), r, lambda_ * (1 - lambda_)) < 0


def is_inside(x, center, q):
    return bordered(q, [a - b for a, b in zip(x, center)], Fraction(1)) > 0


def value(p, t):
    return sum(c * t**k for k, c in enumerate(p))


def quartic(r, q1, q2):
    """The coefficients of p by increasing powers, from its values at five points."""

    def at(t):
        return (1 + t) * bordered(blend(Fraction(1), q1, t, q2), r, t / (1 + t))

    points, p = [Fraction(k) for k in range(5)], []
    for k, t in enumerate(points):
        basis = [Fraction(1)]
        for other in points[:k]:
            basis = [a - other * b for a, b in zip([0, *basis], [*basis, 0])]
        factor = (at(t) - value(p, t)) / value(basis, t)
        p = [a + factor * b for a, b in zip_longest(p, basis, fillvalue=Fraction(0))]
    return p


def positive_roots(p):
    """How many distinct positive roots a polynomial has, by Sturm's theorem."""
    sequence = [p, [k * c for k, c in enumerate(p)][1:]]
    while any(sequence[-1]):
        rest, divisor = list(sequence[-2]), sequence[-1]
        while len(rest) >= len(divisor):
            factor, shift = rest[-1] / divisor[-1], len(rest) - len(divisor)
            rest = [c - factor * (divisor[k - shift] if k >= shift else 0) for k, c in enumerate(rest)][:-1]
        while rest and rest[-1] == 0:
            rest.pop()
        sequence.append([-c for c in rest])

    def changes(values):
        signs = [v > 0 for v in values if v != 0]
        return sum(a != b for a, b in pairwise(signs))

    used = [q for q in sequence if any(q)]
    return changes([q[0] for q in used]) - changes([q[-1] for q in used])


def claim(r12, q1, q2):
    """What the library says of a pair, if that is proved; otherwise an error."""
    overlap, lambda_, point = pypw85.overlap_witness(r12, q1, q2)
    r, forms = list(map(Fraction, r12)), (matrix(q1), matrix(q2))
    if overlap:
        x = list(map(Fraction, point))
        text, proved = "overlap", is_inside(x, [Fraction(0)] * 3, forms[0]) and is_inside(x, r, forms[1])
    elif np.isnan(lambda_):
        # p is positive at both ends of t > 0, and two of its roots are negative: one root there is a double one.
        text, proved = "touch", positive_roots(quartic(r, *forms)) == 1
    else:
        text, proved = "apart", proves_apart(r, *forms, Fraction(lambda_))
    if not proved:
        raise SystemExit(f"not proved: {text}, {r12}, {q1}, {q2}")
    return text


ball, disc, needle = (pypw85.spheroid(a, c, [0, 0, 1]) for a, c in ((1, 1), (3, 1), (0.001, 1)))
print("balls, one part in 10^15 nearer:", claim([2 - 2e-15, 0, 0], ball, ball))
print("balls that touch:", claim([2, 0, 0], ball, ball))
print("one part in 10^15 farther:", claim([2 + 2e-15, 0, 0], ball, ball))
print("a disc and a ball that touch:", claim([0, 0, 2], disc, ball))
print("a needle in a disc:", claim([2.9, 0, 0], disc, needle))
random = np.random.default_rng(1)
found = set()
for _ in range(1000):
    q1, q2 = (pypw85.ellipsoid_quaternion(random.uniform(0.1, 1, 3), random.normal(size=4)) for _ in range(2))
    r12 = random.normal(size=3)
    near = r12 / np.sqrt(pypw85.contact(r12, q1, q2)[0])  # in contact, to rounding
    found.add(claim(near * (1 + 1e-15 * random.normal()), q1, q2))
print("1000 random pairs near contact, each with a proof:", *sorted(found - {"touch"}))
