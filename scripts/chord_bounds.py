#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Proves the bounds of the approximations in chord_axis.hpp and chord_area.hpp of include/pw85/volume, with their constants.

Usage: chord_bounds.py HEADER...

1. A function f that is analytic in the ellipse with the foci 0 and 1 and the sum 5/2 of its semi-axes, with |f| <= M there, differs from
   its interpolant at n + 1 Chebyshev points of [0, 1] by at most 4 M 5^-n/4 (L. N. Trefethen, Approximation Theory and Approximation
   Practice, theorem 8.2, with rho = 5).
2. A polynomial of degree n is at most 1/cos(n pi/2N) times its largest value at N Chebyshev points (H. Ehlich and K. Zeller, 1964).

So the values of an error at N points bound it everywhere. The ellipse has the ends -0.8 and 1.8, so that Re z >= -0.8 and |z| <= 1.8, and
its border is at least 0.8 from 0. The cube root is bounded on cells of the first mantissa digits, in rational numbers.
"""

import re
import sys
from decimal import Decimal, getcontext
from fractions import Fraction
from pathlib import Path

getcontext().prec = 60
DEGREE, POINTS = 40, 400
UNIT_ROUNDOFF = Decimal(2) ** -53


def sine_and_cosine(x):
    """Of a small angle, by their series."""
    sine, cosine, term, k = Decimal(0), Decimal(0), Decimal(1), 0
    while abs(term) > Decimal(10) ** -70:
        if k % 2 == 0:
            cosine += term if k % 4 == 0 else -term
        else:
            sine += term if k % 4 == 1 else -term
        k += 1
        term = term * x / k
    return sine, cosine


def pi():
    """By J. Machin's formula."""

    def arctangent(n):
        total, power, k = Decimal(0), Decimal(1) / n, 0
        while power > Decimal(10) ** -70:
            total += power / (2 * k + 1) * (1 if k % 2 == 0 else -1)
            power /= n * n
            k += 1
        return total

    return 4 * (4 * arctangent(5) - arctangent(239))


def chebyshev_points():
    angle = pi() / (2 * POINTS)
    return [(1 + sine_and_cosine((2 * k + 1) * angle)[1]) / 2 for k in range(POINTS)]


def bound_everywhere(error, largest):
    """A bound on |error| over [0, 1], with |error| <= largest in the ellipse."""
    rest = Decimal(largest) / 5**DEGREE
    at_points = max(abs(error(x)) for x in chebyshev_points())
    growth = sine_and_cosine(DEGREE * pi() / (2 * POINTS))[1]
    return (at_points + rest) / growth + rest


def polynomial(coefficients, x):
    value = Decimal(0)
    for c in reversed(coefficients):
        value = value * x + c
    return value


def exact(number):
    return Decimal(float.fromhex(number) if "0x" in number else float(number))


def segment_function(y):
    """H(y) by the series of L. Euler, atan(t)/t = sum of (2n)!!/(2n + 1)!! x^n/(1 + y) with x = y/(1 + y) <= 1/2."""
    x, term, total, n = y / (1 + y), Decimal(1), Decimal(0), 0
    while term > Decimal(10) ** -65:
        total += term
        n += 1
        term *= x * 2 * n / (2 * n + 1)
    return (2 * (1 + y) * total - 2 * (1 - y)) / y


def segment_error(text):
    """A bound on the relative error of the polynomial for H. As atan(t)/t >= 1 - y/3, H >= 16/3 + 2/3 (y - y^2).

    In the ellipse |atan(t)/t| <= 5, as it is the integral of 1/(1 + y s^2) for s from 0 to 1. So |H| <= (2 * 2.8^2 * 5 + 2 * 2.8)/0.8.
    This is below 105.
    """
    body = re.search(r"constexpr double c\[18\] = \{(.*?)\};", text, re.DOTALL)[1]
    c = [exact(x) for x in re.findall(r"-?0x1[0-9a-fp.+-]*", body)]
    assert len(c) == 18, c
    largest = 105 + sum(abs(x) * Decimal("1.8") ** k for k, x in enumerate(c))
    return bound_everywhere(lambda y: polynomial(c, y) - segment_function(y), largest) / (Decimal(16) / 3)


def two_thirds(w):
    """cos(2/3 arccos w) = 2 s^2 - 1, with the root s in [0.86, 1] of 4 s^3 - 3 s = w."""
    s = Decimal(1)
    for _ in range(12):
        s -= (4 * s**3 - 3 * s - w) / (12 * s * s - 3)
    return 2 * s * s - 1


def cosine_error(text):
    """A bound on the error of the polynomial. With w = cos z, |sinh(Im z)| <= |w| <= 1.8, so that |cos(2z/3)| < 2 in the ellipse."""
    body = re.search(r"T const low = T\(T\(0\.5(.*?)lowest = ", text, re.DOTALL)[0]
    c = [exact(x) for x in re.findall(r"-?0\.\d{6,}", body)]
    assert len(c) == 7, c
    largest = 2 + sum(abs(x) * Decimal("1.8") ** k for k, x in enumerate(c))
    return bound_everywhere(lambda w: polynomial(c, w) - two_thirds(w), largest)


def power_of_two(high):
    """The number whose upper 32 bits are `high`, the other ones being zero."""
    exponent, mantissa = (high >> 20) - 1023, high & 0xFFFFF
    return Fraction(2**20 + mantissa, 2**20) * Fraction(2) ** exponent


def cube_root_error(text):
    """A bound on the relative error of rough_cube_root(), but for roundings.

    3 * 0x55555556 = 2^32 + 2, so that the product gives the whole part of a third for numbers below 2^31. So a factor of 8 of x is one of 2
    of z, and one range of x is enough. A step of Halley's method takes z^3/x = q to q ((q + 2)/(2q + 1))^3, which increases with q.
    """
    factor, offset = (int(x, 16) for x in re.search(r"high \* (0x\w+)u\) >> 32\) \+ (0x\w+)u", text).groups())
    assert 3 * factor == 2**32 + 2
    cells, first, worst = 2**10, 1023 << 20, Fraction(0)
    for low in range(first, first + (3 << 20), cells):
        z = [power_of_two((factor * high >> 32) + offset) for high in (low, low + cells)]
        x = [power_of_two(high) for high in (low, low + cells)]
        for q in (z[0] ** 3 / x[1], z[1] ** 3 / x[0]):
            cube = q * ((q + 2) / (2 * q + 1)) ** 3
            worst = max(worst, abs(cube - 1))
    worst /= 3 - 2 * worst  # that of the root, as 1 - (1 - e)^3 >= 3 e (1 - e)
    return Decimal(worst.numerator) / Decimal(worst.denominator)


# The bounds that the header states.
BOUNDS = [
    ("segment_function", segment_error, Decimal("0.6") * UNIT_ROUNDOFF),
    ("cos(2/3 arccos w)", cosine_error, Decimal("2e-7")),
    ("rough_cube_root", cube_root_error, Decimal("2.2e-5")),
]


def main():
    text = "".join(Path(header).read_text(encoding="utf-8") for header in sys.argv[1:])
    failed = False
    for name, error, limit in BOUNDS:
        found = error(text)
        failed |= found > limit
        print(f"{name}: {found:.3e}, limit {limit:.3e}{' EXCEEDED' if found > limit else ''}")
    sys.exit(failed)


if __name__ == "__main__":
    main()
