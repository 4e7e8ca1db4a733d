#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Volumes and areas of common parts to 30 digits, and their derivatives, for tests/volume_truths.inc and tests/area_truths.inc.

    scripts/volume_truths.py            writes both files; quarter of an hour, or an hour without python3-gmpy2

Two computations that share nothing have to agree, and share nothing with the library either:

- Slices: one ellipsoid becomes the unit ball, the principal axes of the other one become the axes. The common area of a disc and an
  axis-parallel ellipse is a sum of sectors between their crossings, which are roots of a quartic. It is integrated over the heights.
  All singular heights, real or complex, are known: the ends of both bodies, and the roots of the discriminant of the pencil of both
  sections, a polynomial of degree 8. Between real ones, the root of the distance removes the singularity; next to complex ones,
  intervals are shorter than twice the distance. So Gauss's rule of 60 nodes has more digits than are asked for.
- Radii: the common part is star-shaped about a common point. A third of the cube of the shorter radius is integrated over
  directions, where the smaller ellipsoid is the unit ball. In a half-plane through the point the radii are those of two ellipses, and the
  integral along an arc is elementary in its eccentric angle. The angles of the half-planes are divided until Gauss's rule has converged.

The derivatives are integrals of n·δx over the surfaces, in the half-planes of the second way. A directional derivative is compared with
a difference quotient of the first way.

The areas of ellipses are the sums of sectors, and the integral of half of the square of the shorter radius over the directions.
"""

import multiprocessing
import sys
from itertools import combinations, pairwise

from mpmath import atan, atan2, cholesky, cos, eig, eigsy, inverse, isfinite, log10, matrix, mp, mpc, mpf, nstr, pi, polyroots, sin, sqrt

DIGITS = 30  # that both ways have to have in common
mp.dps = 80


def rotated(axes, turn):
    """The form of an ellipsoid with these squared semi-axes, turned by an integer quaternion, as the nearest doubles."""
    w, x, y, z = (mpf(t) for t in turn)
    n = w * w + x * x + y * y + z * z
    r = [
        [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
    ]
    return tuple(float(sum(r[i][k] * r[j][k] * axes[k] for k in range(3)) / n / n) for i in range(3) for j in range(i, 3))


U = 2.0**-52
A, B = (4, 0.5, 0, 1, 0.25, 2.25), (1, 0, 0.5, 2, -0.5, 3)


def scaled(factor, q):
    return tuple(factor * x for x in q)


# Forms by their six entries, as doubles.
CASES = [
    # name, r12, q1, q2
    ("rods of aspect 10 across each other", (0, 0, 1.5), (100, 0, 0, 1, 0, 1), (1, 0, 0, 100, 0, 1)),
    ("two of one kind", (0.5, 0.25, -0.125), A, B),
    ("others", (1, -0.5, 0.75), (1, 0.25, 0.125, 1.5, 0.5, 2), (2, -0.5, 0.25, 1, 0.125, 0.75)),
    ("a long one through a ball", (0.125, 0.25, 0.0625), (16, 1, 2, 0.5, 0.125, 1), (1, 0, 0, 1, 0, 1)),
    ("a flat one through a ball", (0.125, 0.25, 0.0625), (16, 1, 2, 9, 0.125, 0.5), (1, 0, 0, 1, 0, 1)),
    ("a lens", (1.25, 0.5, 0.5), (1, 0, 0, 1, 0, 1), (0.25, 0.0625, 0, 0.5, 0, 1)),
    ("a needle of aspect 2^20 and a ball", (0.5, 0.75, 0.25), (2.0**40, 0, 0, 1, 0, 1), (2.25, 0, 0, 2.25, 0, 2.25)),
    ("a thin needle through another shape", (0.5, 0.75, 0.25), (2.25, 0, 0, 2.0**-40, 0, 2.0**-40), A),
    ("a disc of aspect 2^20 in another shape", (0.5, -0.25, 0.5), B, (1, 0, 0, 1, 0, 2.0**-40)),
    ("a turned disc of aspect 10^6", (0.25, 0.5, -0.375), rotated((1, 1, 1e-12), (3, 1, 2, 1)), A),
    ("needles of aspect 10^6, turned", (0.125, 0.25, 0.0625), rotated((1e12, 1, 1), (3, 1, 2, 1)), rotated((1, 1e12, 1), (4, -1, 1, 2))),
    ("a thin lens, 1e-6", None, A, B),
    ("a thin lens, 1e-12", None, A, B),
    ("sizes 2^200", (2.0**199, 2.0**198, -(2.0**197)), scaled(2.0**400, A), scaled(2.0**400, B)),
    ("sizes 2^-200", (2.0**-201, 2.0**-202, -(2.0**-203)), scaled(2.0**-400, A), scaled(2.0**-400, B)),
    ("a ball in a ball but for an ulp", (0.5 + U / 2, 0, 0), (1, 0, 0, 1, 0, 1), (0.25, 0, 0, 0.25, 0, 0.25)),
    ("one in the other but for an ulp", (1 + U, 0, 0), (4, 0, 0, 1, 0, 2.25), (1, 0, 0, 0.1875, 0, 0.4375)),
    ("a small one at a large one", (-63.5, 2, 1), (0.25, 0.0625, 0, 0.5, 0.125, 0.75), (4096, 128, 64, 3072, 0, 2048)),
    ("a rim that nearly crosses itself", (0.0078125, 0.00390625, 0.25), (1, 0, 0, 1, 0, 1), (0.5, 0.03125, 0, 2.25, 0, 0.5625)),
]

# Ellipses by their three entries.
PLANAR_CASES = [
    ("two crossings", (0.5, 0.25), (4, 0.5, 1), (1, -0.25, 2)),
    ("four crossings", (0.125, 0.0625), (4, 0.5, 1), (1, -0.25, 3)),
    ("a lens", (1.25, 0.5), (1, 0, 1), (0.25, 0.0625, 0.5)),
    ("needles of aspect 2^20 across each other", (0.25, 0.5), (2.0**40, 0, 1), (1, 0, 2.0**40)),
    ("a thin needle through a circle", (0.25, 0.5), (4, 0, 2.0**-40), (1, 0, 1)),
    ("a turned needle of aspect 10^6", (0.25, 0.5), None, (1, 0, 1)),
    ("a thin lens, 1e-6", None, (4, 0.5, 1), (1, -0.25, 2)),
    ("a thin lens, 1e-12", None, (4, 0.5, 1), (1, -0.25, 2)),
    ("sizes 2^200", (2.0**199, 2.0**198), (2.0**402, 2.0**399, 2.0**400), (2.0**400, -(2.0**398), 2.0**401)),
    ("sizes 2^-200", (2.0**-201, 2.0**-202), (2.0**-398, 2.0**-401, 2.0**-400), (2.0**-400, -(2.0**-402), 2.0**-399)),
    ("a circle in a circle but for an ulp", (0.5 + U / 2, 0), (1, 0, 1), (0.25, 0, 0.25)),
    ("one in the other but for an ulp", (1 + U, 0), (4, 0, 1), (1, 0, 0.1875)),
    ("a small one at a large one", (-63.5, 2), (0.25, 0.0625, 0.5), (4096, 128, 3072)),
    ("four crossings, two of them near each other", (0.25 + 2.0**-30, 0), (1, 0, 1), (0.5625, 0, 4)),
]


# --- linear algebra of small lists ------------------------------------------------------------------------------------------------


def symmetric(q):
    """A form by its entries as a matrix."""
    n = 3 if len(q) == 6 else 2
    m, entries = matrix(n, n), iter(q)
    for i in range(n):
        for j in range(i, n):
            m[i, j] = m[j, i] = mpf(next(entries))
    return m


def rows_of(m):
    return [[m[i, j] for j in range(m.cols)] for i in range(m.rows)]


def dot(x, y):
    return sum(a * b for a, b in zip(x, y, strict=True))


def times(m, x):
    return [dot(row, x) for row in m]


def combined(*terms):
    return [sum(f * x[i] for f, x in terms) for i in range(len(terms[0][1]))]


def unit(x):
    size = sqrt(dot(x, x))
    return [a / size for a in x]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def scale_of(q1, q2):
    """A power of two near the size of the pair, by which it is divided first."""
    return mpf(2) ** int(mp.nint(mp.log(max(q1[0], q2[0]), 2) / 2))


def positions(r, q1, q2, depth):
    """A position in the direction r, rounded to doubles, where the pair overlaps by this fraction of the way to touching. The contact
    function is the largest value of a concave function."""
    q1, q2, r = symmetric(q1), symmetric(q2), matrix(r)

    def mu2(x):
        return x * (1 - x) * (r.T * inverse((1 - x) * q1 + x * q2) * r)[0]

    low, high = mpf(0), mpf(1)
    for _ in range(250):
        a, b = low + (high - low) * mpf("0.382"), low + (high - low) * mpf("0.618")
        low, high = (a, high) if mu2(a) < mu2(b) else (low, b)
    factor = (1 - mpf(depth)) / sqrt(mu2((low + high) / 2))
    return tuple(float(x * factor) for x in r)


# --- rules ------------------------------------------------------------------------------------------------------------------------


NODES = {}


def nodes_of(count):
    """Gauss's rule on [-1, 1]."""
    if (count, mp.prec) not in NODES:
        prec, points = mp.prec, []
        with mp.extraprec(40):
            legendre = [(mpf(k) * 2 - 1) / k for k in range(1, count + 1)], [(mpf(k) - 1) / k for k in range(1, count + 1)]
            for i in range(count):
                x = cos(pi * (i + mpf(3) / 4) / (count + mpf(1) / 2))
                for _ in range(30):
                    p, q = mpf(1), mpf(0)
                    for a, b in zip(*legendre, strict=True):
                        p, q = a * x * p - b * q, p
                    slope = count * (x * p - q) / (x * x - 1)
                    step = p / slope
                    x -= step
                    if abs(step) < mpf(2) ** (-prec - 10):
                        break
                points.append((x, 2 / ((1 - x * x) * slope * slope)))
        NODES[count, prec] = points
    return NODES[count, mp.prec]


def on_panel(function, x, y, count):
    half, middle = (y - x) / 2, (x + y) / 2
    return half * sum(weight * function(middle + half * node) for node, weight in nodes_of(count))


def graded(x, y, singular, floor):
    """[x, y] in intervals that are at most twice as long as their distance from singular points."""
    stack, panels = [(x, y)], []
    while stack:
        a, b = stack.pop()
        middle, half = (a + b) / 2, (b - a) / 2
        distance = min((max(abs(mp.re(s) - middle) - half, mpf(0)) + abs(mp.im(s)) for s in singular), default=mpf("inf"))
        if distance >= half:
            panels.append((a, b))
        elif b - a > floor:
            stack += [(a, middle), (middle, b)]
    return panels


# --- slices -----------------------------------------------------------------------------------------------------------------------


def crossings(a2, c, p, e):
    """The angles at which the circle about 0 with the squared radius a2 crosses the ellipse Σ p_i (x_i - c_i)² = e."""
    a = sqrt(a2)
    f = [-e, 0, -2 * e, 0, -e]  # with t = tan(θ/2) on the circle: a quartic in t
    for weight, u in zip(p, ([a - c[0], 0, -a - c[0]], [-c[1], 2 * a, -c[1]]), strict=True):
        for i in range(3):
            for j in range(3):
                f[i + j] += weight * u[i] * u[j]
    largest = max(abs(x) for x in f)
    f = [x / largest for x in f]
    while abs(f[-1]) < mpf(10) ** -mp.dps:
        f.pop()
    roots = polyroots(f[::-1], maxsteps=2000, extraprec=4 * mp.prec)
    return sorted(2 * atan(mp.re(t)) for t in roots if abs(mp.im(t)) < mpf(10) ** (-mp.dps // 2) * (1 + abs(t)))


def common_area(a2, c, p, e):
    """The common area of that disc and that ellipse, as ½∮ x dy - y dx along its arcs."""
    a, b, angles = sqrt(a2), [sqrt(e / x) for x in p], crossings(a2, c, p, e)

    def outside(x, y):
        return p[0] * (x - c[0]) ** 2 + p[1] * (y - c[1]) ** 2 > e

    if len(angles) < 2:
        if not outside(a, 0):
            return pi * a2
        return pi * b[0] * b[1] if c[0] ** 2 + c[1] ** 2 < a2 and b[0] * b[1] < a2 else mpf(0)
    area = mpf(0)
    for k, start in enumerate(angles):
        end = angles[(k + 1) % len(angles)] + (2 * pi if k + 1 == len(angles) else 0)
        middle = (start + end) / 2
        if not outside(a * cos(middle), a * sin(middle)):
            area += a2 * (end - start) / 2
            continue
        first, last = ((a * cos(t) - c[0], a * sin(t) - c[1]) for t in (start, end))
        e0, e1 = atan2(first[1] / b[1], first[0] / b[0]), atan2(last[1] / b[1], last[0] / b[0])
        while e1 < e0:
            e1 += 2 * pi
        area += (b[0] * b[1] * (e1 - e0) + c[0] * (last[1] - first[1]) - c[1] * (last[0] - first[0])) / 2
    return area


def product_of(a, b):
    c = [mpf(0)] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            c[i + j] += x * y
    return c


def sum_of(*terms):
    return [sum((f * t[i] for f, t in terms if i < len(t)), mpf(0)) for i in range(max(len(t) for _, t in terms))]


def roots_of(f):
    largest = max(abs(x) for x in f)
    f = [x / largest for x in f]
    while f and abs(f[-1]) < mpf(10) ** (10 - mp.dps):
        f.pop()
    return polyroots(f[::-1], maxsteps=5000, extraprec=6 * mp.prec) if len(f) > 1 else []


def singular_heights(c, p):
    """The heights at which the sections x² + y² = 1 - z² and Σ p_i (x_i - c_i)² = 1 - p_z (z - c_z)² touch, real or complex, and those
    at which one of them is a point. The cubic (p0-t)(p1-t)(γ-e+ts) - c0²p0²(p1-t) - c1²p1²(p0-t) in t has a double root there."""
    s = [mpf(1), mpf(0), mpf(-1)]
    e = [1 - p[2] * c[2] ** 2, 2 * p[2] * c[2], -p[2]]
    rest = sum_of((mpf(-1), e), (1, [p[0] * c[0] ** 2 + p[1] * c[1] ** 2]))  # γ - e
    b = [(p[i] * c[i]) ** 2 for i in (0, 1)]
    k3 = s
    k2 = sum_of((-(p[0] + p[1]), s), (1, rest))
    k1 = sum_of((p[0] * p[1], s), (-(p[0] + p[1]), rest), (1, [b[0] + b[1]]))
    k0 = sum_of((p[0] * p[1], rest), (1, [-b[0] * p[1] - b[1] * p[0]]))
    mul = product_of
    discriminant = sum_of(
        (18, mul(mul(k3, k2), mul(k1, k0))),
        (-4, mul(mul(k2, k2), mul(k2, k0))),
        (1, mul(mul(k2, k2), mul(k1, k1))),
        (-4, mul(mul(k3, k1), mul(k1, k1))),
        (-27, mul(mul(k3, k3), mul(k0, k0))),
    )
    half = 1 / sqrt(p[2])
    return [mpc(x) for x in (-1, 1, c[2] - half, c[2] + half)] + [mpc(x) for x in roots_of(discriminant)]


def by_slices(r, q1, q2, count=60):
    size = scale_of(q1, q2)
    lower = cholesky(symmetric([mpf(x) / size**2 for x in q1]))
    inner = inverse(lower)
    values, vectors = eigsy(inner * symmetric([mpf(x) / size**2 for x in q2]) * inner.T)
    c = list(vectors.T * (inner * matrix([mpf(x) / size for x in r])))
    p = [1 / v for v in values]
    low, high = max(-mpf(1), c[2] - 1 / sqrt(p[2])), min(mpf(1), c[2] + 1 / sqrt(p[2]))
    singular, floor = singular_heights(c, p), mpf(10) ** (-DIGITS - 8)

    def area(z):
        a2, e = 1 - z * z, 1 - p[2] * (z - c[2]) ** 2
        return common_area(a2, c, p[:2], e) if a2 > 0 and e > 0 else mpf(0)

    span = high - low
    real = [mp.re(s) for s in singular if abs(mp.im(s)) < floor * span and low + floor * span < mp.re(s) < high - floor * span]
    ends, total = sorted([low, high, *real]), mpf(0)
    for x, y in pairwise(ends):
        if y - x < floor * span:
            continue
        for end, sign in ((x, 1), (y, -1)):  # z = end ± w²
            far = sqrt((y - x) / 2)
            others = [sqrt(sign * (s - end)) for s in singular if abs(s - end) > floor * span]
            others += [-s for s in others]

            def height(w, end=end, sign=sign):
                return 2 * w * area(end + sign * w * w)

            for a, b in graded(mpf(0), far, others, mpf(10) ** (-DIGITS / 2 - 4) * far):
                total += on_panel(height, a, b, count)
    return total * lower[0, 0] * lower[1, 1] * lower[2, 2] * size**3


# --- radii ------------------------------------------------------------------------------------------------------------------------


class Body:
    """(x - center)ᵀ inverse (x - center) <= 1."""

    def __init__(self, center, q):
        self.center, self.inverse = [mpf(x) for x in center], rows_of(inverse(q))

    def homogeneous(self):
        pc = times(self.inverse, self.center)
        rows = [[*row, -x] for row, x in zip(self.inverse, pc, strict=True)]
        return matrix([*rows, [*[-x for x in pc], dot(self.center, pc) - 1]])

    def chord(self, point, direction):
        """Where a line enters and leaves."""
        d = combined((1, point), (-1, self.center))
        pd, pl = times(self.inverse, d), times(self.inverse, direction)
        a, b, c = dot(direction, pl), dot(direction, pd), dot(d, pd) - 1
        root = b * b - a * c
        return None if root <= 0 else ((-b - sqrt(root)) / a, (-b + sqrt(root)) / a)


def axes_of_rim(bodies):
    """Lines about which the curve where both surfaces intersect may turn: those conjugate to two vertices of cones of the pencil."""
    forms = [body.homogeneous() for body in bodies]
    with mp.extradps(mp.dps):
        _, vectors = eig(inverse(forms[0]) * forms[1])
    vertices = []
    for j in range(4):
        v = [vectors[i, j] for i in range(4)]
        pivot = max(v, key=abs)
        v = [x / pivot for x in v]
        if max(abs(mp.im(x)) for x in v) < mpf(10) ** (-mp.dps // 3):
            vertices.append(matrix([mp.re(x) for x in v]))
    planes = [[list(form * v) for form in forms] for v in vertices]
    for i, j in combinations(range(len(vertices)), 2):
        # The plane conjugate to a vertex is the same for both bodies, as they are multiples of each other.
        n1, n2 = planes[i][0], planes[j][0]
        direction = cross(n1[:3], n2[:3])
        if dot(direction, direction) == 0:
            continue
        direction = unit(direction)
        m = matrix([n1[:3], n2[:3], direction])
        point = list(mp.lu_solve(m, matrix([-n1[3], -n2[3], 0])))
        yield point, direction


def sections_of(bodies, point, direction, across):
    """Both ellipses in the plane of (z, ρ), relative to the point: a ball |y - m|² <= K by y = m + a cos E + b sin E."""
    sections = []
    for body in bodies:
        d = combined((1, point), (-1, body.center))
        pl, pf, pd = times(body.inverse, direction), times(body.inverse, across), times(body.inverse, d)
        a, b, c = dot(direction, pl), dot(direction, pf), dot(across, pf)
        h0, h1, g = dot(direction, pd), dot(across, pd), 1 - dot(d, pd)
        det = a * c - b * b
        m = [(b * h1 - c * h0) / det, (b * h0 - a * h1) / det]
        k = g - (m[0] * h0 + m[1] * h1)
        root, l11 = sqrt(k), sqrt(a)
        l22 = sqrt(det / a)
        # rows of L⁻ᵀ: L = [[l11, 0], [b/l11, l22]]
        basis = [root / l11, mpf(0)], [-root * b / (a * l22), root / l22]
        sections.append({"form": (a, b, c), "linear": (h0, h1), "gap": g, "m": m, "k": k, "basis": basis, "l": (l11, b / l11, l22)})
    return sections


def inverse_radius(s, x, y):
    """1/r in the direction (x, y): the larger root of g y² - 2hy - a = 0."""
    a = s["form"][0] * x * x + 2 * s["form"][1] * x * y + s["form"][2] * y * y
    h = s["linear"][0] * x + s["linear"][1] * y
    return (h + sqrt(h * h + a * s["gap"])) / s["gap"]


def shared_directions(s1, s2):
    """The angles in (0, π) at which both radii are equal, from a quartic of the tangent."""
    g1, g2 = s1["gap"], s2["gap"]
    n = [-(g2 * s1["form"][i] - g1 * s2["form"][i]) * (2 if i == 1 else 1) for i in range(3)]  # of 1, t, t²
    d = [2 * (g2 * s1["linear"][i] - g1 * s2["linear"][i]) for i in range(2)]
    # g y² - 2hy - a = 0 for both: y = n/d
    a = [s1["form"][0], 2 * s1["form"][1], s1["form"][2]]
    quartic = sum_of((g1, product_of(n, n)), (-2, product_of(list(s1["linear"]), product_of(n, d))), (-1, product_of(a, product_of(d, d))))
    angles = []
    for t in roots_of(quartic):
        if abs(mp.im(t)) > mpf(10) ** (-mp.dps // 3) * (1 + abs(t)):
            continue
        t = mp.re(t)
        x, y = 1 / sqrt(1 + t * t), t / sqrt(1 + t * t)
        if y < 0:
            x, y = -x, -y
        y1, y2 = inverse_radius(s1, x, y), inverse_radius(s2, x, y)
        if abs(y1 - y2) < mpf(10) ** (-mp.dps // 4) * (y1 + y2):
            angles.append(atan2(y, x))
    return sorted(angles)


def eccentric(s, theta):
    x, y = cos(theta), sin(theta)
    r = 1 / inverse_radius(s, x, y)
    z, rho = r * x - s["m"][0], r * y - s["m"][1]
    l11, l21, l22 = s["l"]
    return atan2(l22 * rho, l11 * z + l21 * rho)


def powers(e0, e1):
    """∫ cos^i E sin^j E dE for i + j <= 3."""
    c0, s0, c1, s1 = cos(e0), sin(e0), cos(e1), sin(e1)
    e, sc = e1 - e0, s1 * c1 - s0 * c0
    d_c3, d_s3 = (c1**3 - c0**3) / 3, (s1**3 - s0**3) / 3
    return {
        (0, 0): e,
        (1, 0): s1 - s0,
        (0, 1): c0 - c1,
        (2, 0): (e + sc) / 2,
        (0, 2): (e - sc) / 2,
        (1, 1): (s1 * s1 - s0 * s0) / 2,
        (3, 0): (s1 - s0) - d_s3,
        (2, 1): -d_c3,
        (1, 2): d_s3,
        (0, 3): (c0 - c1) + d_c3,
    }


INDEX = ((0, 0), (1, 0), (0, 1))  # 1, cos E, sin E


def moment(i, *more):
    return tuple(sum(INDEX[k][n] for k in (i, *more)) for n in (0, 1))


def half_plane(bodies, point, direction, across):
    """The integrand over φ: of the volume, of ∂V/∂r12, and of ∂V/∂Q of both bodies, and the number of directions with equal radii."""
    sections = sections_of(bodies, point, direction, across)
    angles = [mpf(0), *shared_directions(*sections), pi]
    numbers = [mpf(0)] * 16
    for t0, t1 in pairwise(angles):
        middle = (t0 + t1) / 2
        radii = [inverse_radius(s, cos(middle), sin(middle)) for s in sections]
        k = 0 if radii[0] > radii[1] else 1
        s, body = sections[k], bodies[k]
        e0, e1 = eccentric(s, t0), eccentric(s, t1)
        while e1 < e0:
            e1 += 2 * pi
        j = powers(e0, e1)
        (z0, za, zb), (r0, ra, rb) = ((s["m"][i], s["basis"][0][i], s["basis"][1][i]) for i in (0, 1))
        # ⅓ ∫ ρ (z dρ - ρ dz), the integral of ⅓ r³ sin θ dθ
        sweep = (za * rb - zb * ra, z0 * rb - r0 * zb, r0 * za - z0 * ra)
        rho = (r0, ra, rb)
        numbers[0] += sum(rho[a] * sweep[b] * j[moment(a, b)] for a in range(3) for b in range(3)) / 3
        # w = P (x - c) by 1, cos E, sin E
        start = times(body.inverse, combined((1, point), (-1, body.center), (z0, direction), (r0, across)))
        w = [start, *(times(body.inverse, combined((z, direction), (r, across))) for z, r in ((za, ra), (zb, rb)))]
        measure = (za * rb - zb * ra) / s["k"]
        if k == 1:
            ones = [measure * sum(rho[a] * j[moment(a, b)] for a in range(3)) for b in range(3)]
            for i in range(3):
                numbers[1 + i] += sum(ones[b] * w[b][i] for b in range(3))
        twos = [[measure * sum(rho[a] * j[moment(a, b, c)] for a in range(3)) / 2 for c in range(3)] for b in range(3)]
        n = 4 + 6 * k
        for i in range(3):
            for l in range(i, 3):
                numbers[n] += sum(twos[b][c] * w[b][i] * w[c][l] for b in range(3) for c in range(3))
                n += 1
    return numbers, len(angles) - 2


def by_radii(r, q1, q2, count=32):
    """The volume, and its derivatives with respect to r12 and the stored entries of both forms."""
    size = scale_of(q1, q2)  # mpmath's cholesky() refuses small matrices
    forms = [symmetric(q1), symmetric(q2)]
    lower = size * cholesky(min(forms, key=mp.det) / size**2)
    inner = inverse(lower)
    q1, q2 = (inner * q * inner.T for q in forms)
    bodies = [Body([0, 0, 0], q1), Body(list(inner * matrix(r)), q2)]
    for point, direction in axes_of_rim(bodies):
        chords = [body.chord(point, direction) for body in bodies]
        if None in chords:
            continue
        low, high = max(c[0] for c in chords), min(c[1] for c in chords)
        if low >= high:
            continue
        point = combined((1, point), ((low + high) / 2, direction))
        side = unit(cross(direction, [1, 0, 0] if abs(direction[0]) < 0.6 else [0, 1, 0]))
        up = cross(direction, side)
        angles = [mpf(2 * k) + 1 / mpf(3) for k in range(7)]
        kinds = {half_plane(bodies, point, direction, combined((cos(t), side), (sin(t), up)))[1] for t in angles}
        if len(kinds) == 1 and kinds <= {1, 2}:
            break
    else:
        raise ValueError("no axis")

    def integrand(phi):
        numbers, kind = half_plane(bodies, point, direction, combined((cos(phi), side), (sin(phi), up)))
        assert kind in kinds, "a half-plane with another number of crossings"
        return matrix(numbers)

    stack = [(2 * pi * k / 8, 2 * pi * (k + 1) / 8) for k in range(8)]
    stack = [(a, b, on_panel(integrand, a, b, count)) for a, b in stack]
    reference = [abs(sum(entry[2][i] for entry in stack)) for i in range(16)]
    tolerance = mpf(10) ** (-DIGITS - 4)
    total = matrix([mpf(0)] * 16)
    while stack:
        a, b, coarse = stack.pop()
        middle = (a + b) / 2
        halves = [(a, middle, on_panel(integrand, a, middle, count)), (middle, b, on_panel(integrand, middle, b, count))]
        fine = halves[0][2] + halves[1][2]
        # the derivatives with respect to forms need the largest entry of each only
        scales = [reference[0], *[max(reference[1:4])] * 3, *[max(reference[4:10])] * 6, *[max(reference[10:16])] * 6]
        if all(abs(fine[i] - coarse[i]) <= tolerance * scales[i] for i in range(16)):
            total += fine
        elif b - a < mpf(10) ** (-DIGITS - 20):
            raise ValueError("no convergence")
        else:
            stack += halves
    det = lower[0, 0] * lower[1, 1] * lower[2, 2]
    gradient = [total[0] * det, *(det * inner.T * matrix(list(total)[1:4]))]
    for k in (4, 10):
        tensor = det * inner.T * symmetric(list(total)[k : k + 6]) * inner
        gradient += [tensor[i, j] * (1 if i == j else 2) for i in range(3) for j in range(i, 3)]
    return gradient


# --- the plane --------------------------------------------------------------------------------------------------------------------


def area_by_sectors(r, q1, q2):
    size = scale_of(q1, q2)
    lower = cholesky(symmetric([mpf(x) / size**2 for x in q1]))
    inner = inverse(lower)
    values, vectors = eigsy(inner * symmetric([mpf(x) / size**2 for x in q2]) * inner.T)
    c = list(vectors.T * (inner * matrix([mpf(x) / size for x in r])))
    return common_area(mpf(1), c, [1 / v for v in values], mpf(1)) * lower[0, 0] * lower[1, 1] * size**2


def area_by_radii(r, q1, q2, count=60):
    """½ ∫ r² dθ of the shorter radius, about the middle of the common part of a line through both centres."""
    size = scale_of(q1, q2)
    forms = [symmetric([mpf(x) / size**2 for x in q]) for q in (q1, q2)]
    bodies = [Body([0, 0], forms[0]), Body([mpf(x) / size for x in r], forms[1])]

    def level(k, x):
        d = combined((1, x), (-1, bodies[k].center))
        return dot(d, times(bodies[k].inverse, d))

    # A common point: the one next to both centres, by the matrix of the contact function.
    low, high = mpf(0), mpf(1)
    for _ in range(400):
        x = (low + high) / 2
        s = inverse((1 - x) * forms[0] + x * forms[1]) * matrix(bodies[1].center)
        point = list((1 - x) * forms[0] * s)
        low, high = (low, x) if level(0, point) < level(1, point) else (x, high)
    assert level(0, point) < 1 and level(1, point) < 1
    sections = sections_of(bodies, point, [mpf(1), mpf(0)], [mpf(0), mpf(1)])
    total = mpf(0)
    for sign in (1, -1):  # both halves of the plane
        for s in sections:
            s["form"] = (s["form"][0], sign * s["form"][1], s["form"][2])
            s["linear"] = (s["linear"][0], sign * s["linear"][1])
        angles = [mpf(0), *shared_directions(*sections), pi]
        for t0, t1 in pairwise(angles):
            middle = (t0 + t1) / 2
            radii = [inverse_radius(s, cos(middle), sin(middle)) for s in sections]
            s = sections[0 if radii[0] > radii[1] else 1]
            # singular where the root of 1/r is 0, and where 1/r is 0
            a, b, c = s["form"]
            h0, h1 = s["linear"]
            g = s["gap"]
            singular = []
            for f in ([a, 2 * b, c], [h0 * h0 + g * a, 2 * (h0 * h1 + g * b), h1 * h1 + g * c]):
                singular += [atan(t) + k * pi for t in roots_of(f) for k in (-1, 0, 1, 2)]

            def sector(theta, s=s):
                return 1 / inverse_radius(s, cos(theta), sin(theta)) ** 2 / 2

            for x, y in graded(t0, t1, singular, mpf(10) ** -60):
                total += on_panel(sector, x, y, count)
        for s in sections:
            s["form"] = (s["form"][0], sign * s["form"][1], s["form"][2])
            s["linear"] = (s["linear"][0], sign * s["linear"][1])
    return total * size**2


# --- the files --------------------------------------------------------------------------------------------------------------------


def shared_digits(a, b):
    return DIGITS + 6 if a == b else int(-log10(abs(a - b) / abs(a)))


def directional(r, q1, q2, gradient):
    """A derivative in a direction that changes all data, by slices, and by the gradient: the digits that they share."""
    direction = [mpf(k * k % 7 - 3) / 16 for k in range(1, 16)]
    scale = [sqrt(mpf(q1[0]))] * 3 + [mpf(q1[0])] * 12
    steps = [d * s for d, s in zip(direction, scale, strict=True)]
    h = mpf(10) ** -7

    def volume(k):
        data = [mpf(x) + k * h * d for x, d in zip((*r, *q1, *q2), steps, strict=True)]
        return by_slices(data[:3], data[3:9], data[9:])

    quotient = (45 * (volume(1) - volume(-1)) - 9 * (volume(2) - volume(-2)) + (volume(3) - volume(-3))) / (60 * h)
    return shared_digits(sum(g * d for g, d in zip(gradient[1:], steps, strict=True)), quotient)


def complete(case):
    """A case with its position, and a form that is made of angles."""
    name, r, q1, q2 = case
    if "turned needle" in name and q1 is None:
        full = rotated((1, 1e-12, 1), (3, 0, 0, 1))
        q1 = (full[0], full[1], full[3])
    if r is None:
        r = positions((1, 0.5, -0.25)[: 3 if len(q1) == 6 else 2], q1, q2, name.split(", ")[1])
    return name, r, q1, q2


def space_case(n):
    name, r, q1, q2 = complete(CASES[n])
    gradient = by_radii(r, q1, q2)
    slices = by_slices(r, q1, q2)
    digits = shared_digits(slices, gradient[0])
    check = directional(r, q1, q2, gradient) if n == 2 else None
    print(f"{name}: {digits} digits of the volume" + (f", {check} of a derivative" if check else ""), file=sys.stderr)
    return name, r, q1, q2, slices, digits, gradient


def plane_case(n):
    name, r, q1, q2 = complete(PLANAR_CASES[n])
    sectors, radii = area_by_sectors(r, q1, q2), area_by_radii(r, q1, q2)
    digits = shared_digits(sectors, radii)
    print(f"{name}: {digits} digits of the area", file=sys.stderr)
    return name, r, q1, q2, sectors, digits


def braces(numbers):
    return "{" + ", ".join(float(x).hex() for x in numbers) + "}"


def write(name, rows):
    text = f"// {name.capitalize()}s of common parts by two ways: r12, q1, q2, the {name}, the digits that both ways share"
    text += "; ∂V/∂r12, ∂V/∂q1, ∂V/∂q2. " if name == "volume" else ". "
    lines = [text + "Made by scripts/volume_truths.py."]
    for case, r, q1, q2, measure, digits, *gradient in rows:
        assert isfinite(measure) and digits >= DIGITS, case
        parts = [*map(braces, (r, q1, q2)), f'"{nstr(measure, DIGITS)}"', str(min(digits, DIGITS))]
        if gradient:
            parts.append("{" + ", ".join(f'"{nstr(x, 25)}"' for x in gradient[0][1:]) + "}")
        lines += [f"// {case}", "{" + ", ".join(parts) + "},"]
    with open(f"tests/{name}_truths.inc", "w") as file:
        file.write("\n".join(lines) + "\n")


def main():
    with multiprocessing.Pool(2) as pool:
        write("area", pool.map(plane_case, range(len(PLANAR_CASES)), 1))
        write("volume", pool.map(space_case, range(len(CASES)), 1))


if __name__ == "__main__":
    main()
