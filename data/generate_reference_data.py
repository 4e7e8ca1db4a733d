#!/usr/bin/python3
"""Generate reference values of the contact function of Perram and Wertheim.

    generate_reference_data.py [OUTPUT]

writes an HDF5 file (by default `pw85_ref_data.h5`, beside this script) whose
layout is described in README.md. The file is a function of this script alone:
same libraries, same bits.

Conventions
-----------
Vectors are (x, y, z), symmetric matrices are packed as (xx, xy, xz, yy, yz,
zz). Ellipsoid i is the set of m such that (m - ci)^T Qi^-1 (m - ci) <= 1, and
r = c2 - c1. With Q(lambda) = (1 - lambda) Q1 + lambda Q2,

    f(lambda) = lambda (1 - lambda) r^T Q(lambda)^-1 r,
    mu^2      = max f(lambda) over 0 <= lambda <= 1.

Every value is the truth for its arguments exactly as stored, that is: the
arguments are rounded to doubles first, the value is computed from these
doubles, and only the result is rounded, once, to nearest.

Why 200 digits
--------------
50 correct digits are wanted in mu^2, lambda and mu^2 - 1. On the way there,
at aspect ratio 1e6, size ratio 1e8 (3e14 for round shapes) and lambda or
1 - lambda down to 1e-15, cancellation could cost up to

    24 digits in the cofactors and the determinant of one form (aspect^4),
    30 digits where the polynomial coefficients of two forms of very different
       sizes are told apart (size ratio squared),
    16 digits in A = g - tau B (see `contact_equation`), as A / g = lambda,
    15 digits in mu^2 - 1,
    12 digits where the equation to solve is flat (slope of 1e-12 at least),

fewer than 100 altogether, and as many are left to spare. Much less is lost in
fact, since 200 digits hold most products of four doubles exactly: against 400
digits, lambda is off by 1e-186 at worst, and every dataset is the same.
"""
import functools
import pathlib
import random
import sys

import h5py
import mpmath
import numpy as np
from mpmath import mp, mpf

LAYOUT_VERSION = 1
SEED = 1985
DIGITS = 200
mp.dps = DIGITS

BRACKET_WIDTH = mpf(10)**-80  # of log tau; mu^2 is stationary, hence 1e-160
AGREEMENT = mpf(10)**-70  # relative, of the two ways to compute mu^2
EXACTLY_ONE = mpf(10)**-100  # a smaller |mu^2 - 1| is a rounding error

RADII = (0.0199, 1.999, 9.999)
LAMBDAS = tuple(i / 10 for i in range(11))
# Forms come in runs of 12 per pair of radii, within which n and -n give the
# same form; one run against another fits the window of the compressor.
F_CHUNKS = (12, 12, 12, 11)
CONTACT_ROWS_PER_CHUNK = 4096


# --- Symmetric matrices and vectors -----------------------------------------

def exact(values):
    """Doubles as multiple precision numbers; no rounding."""
    return tuple(mpf(x) for x in values)


def rounded(values):
    """Multiple precision numbers as the nearest doubles."""
    return tuple(float(x) for x in values)


def unrounded(values):
    """Multiple precision numbers as doubles, which must be exact."""
    doubles = rounded(values)
    assert exact(doubles) == tuple(values)
    return doubles


def combine(alpha, p, beta, q):
    """alpha p + beta q, of vectors or of packed matrices."""
    return tuple(alpha * x + beta * y for x, y in zip(p, q))


def inner(p, q):
    """tr(P Q)."""
    return (p[0] * q[0] + p[3] * q[3] + p[5] * q[5]
            + 2 * (p[1] * q[1] + p[2] * q[2] + p[4] * q[4]))


def outer(v):
    """v v^T."""
    x, y, z = v
    return x * x, x * y, x * z, y * y, y * z, z * z


def adjugate(q):
    """adj(Q) = det(Q) Q^-1."""
    xx, xy, xz, yy, yz, zz = q
    return (yy * zz - yz * yz, xz * yz - xy * zz, xy * yz - xz * yy,
            xx * zz - xz * xz, xy * xz - xx * yz, xx * yy - xy * xy)


def full(q):
    """The packed matrix as three rows."""
    xx, xy, xz, yy, yz, zz = q
    return (xx, xy, xz), (xy, yy, yz), (xz, yz, zz)


def congruent(rows, q):
    """L Q L^T, for L given by its rows."""
    def entry(i, j):
        return sum(rows[i][k] * full(q)[k][m] * rows[j][m]
                   for k in range(3) for m in range(3))
    return tuple(entry(i, j) for i in range(3) for j in range(i, 3))


def diagonal(semi_axes):
    """Quadratic form of the ellipsoid aligned with the coordinate axes."""
    a, b, c = semi_axes
    return a * a, 0 * a, 0 * a, b * b, 0 * a, c * c


def ldlt_pivots(q):
    """Pivots of the L D L^T decomposition, in the arithmetic of q."""
    xx, xy, xz, yy, yz, zz = q
    d1 = xx
    d2 = yy - xy / d1 * xy
    l32 = (yz - xz / d1 * xy) / d2
    return d1, d2, zz - xz / d1 * xz - l32 * d2 * l32


def is_usable(q):
    """True if q is positive definite, and seen to be so in doubles too.

    Forms of aspect ratio 1e6 are, without redrawing: rounding moves their
    eigenvalues by about 1e-16 of the largest, the smallest being 1e-12 of it.
    """
    return all(d > 0 for d in ldlt_pivots(q) + ldlt_pivots(exact(q)))


# --- The contact function ---------------------------------------------------

@functools.cache
def f_values(r12, q1, q2):
    """f at each of LAMBDAS, for arguments in doubles."""
    rr = outer(exact(r12))
    q1, q2 = exact(q1), exact(q2)
    values = []
    for x in exact(LAMBDAS):
        q = combine(1 - x, q1, x, q2)
        adj = adjugate(q)
        det = inner(adj, q) / 3
        values.append(x * (1 - x) * inner(adj, rr) / det)
    return rounded(values)


def contact_equation(r12, q1, q2):
    """The increasing function h of log tau that vanishes at the maximum of f.

    With tau = lambda / (1 - lambda), M = Q1 + tau Q2 and s = M^-1 r, f is
    stationary where A = tau^2 B, for A = s^T Q1 s and B = s^T Q2 s; h(x) is
    x + log(B / A) / 2, the slope of which lies between 0 and 1.

    No linear system is solved: g = r^T M^-1 r = A + tau B is the ratio of
    n = r^T adj(M) r (a quadratic in tau) to d = det(M) (a cubic), dg/dtau is
    -B, and the coefficients of n and d are polynomials in the entries of r12,
    q1 and q2.
    """
    rr = outer(r12)
    adj1, adj2 = adjugate(q1), adjugate(q2)
    n0, n2 = inner(adj1, rr), inner(adj2, rr)
    n1 = inner(adjugate(combine(1, q1, 1, q2)), rr) - n0 - n2
    d0, d1 = inner(adj1, q1) / 3, inner(adj1, q2)
    d2, d3 = inner(adj2, q1), inner(adj2, q2) / 3

    def h(log_tau):
        tau = mpmath.exp(log_tau)
        n, dn = n0 + tau * (n1 + tau * n2), n1 + 2 * tau * n2
        d = d0 + tau * (d1 + tau * (d2 + tau * d3))
        dd = d1 + tau * (2 * d2 + 3 * tau * d3)
        b = n * dd - dn * d  # B d^2
        a = n * d - tau * b  # A d^2
        return log_tau + mpmath.log(b / a) / 2

    return h


def increasing_root(h, start):
    """Root of h, the slope of which lies between 0 and 1 (Illinois method)."""
    a = b = start
    h_a = h_b = h(start)
    step = -h_a  # falls short of the root, unless the slope is 1
    while h_a * h_b > 0:
        a, h_a = b, h_b
        b, step = b + step, 2 * step
        h_b = h(b)
    while h_b != 0 and abs(b - a) > BRACKET_WIDTH:
        c = b - h_b * (b - a) / (h_b - h_a)
        h_c = h(c)
        if h_b * h_c < 0:
            a, h_a = b, h_b
        else:
            h_a /= 2
        b, h_b = c, h_c
    return b


def maximiser(r12, q1, q2):
    """lambda at the maximum of f, in multiple precision."""
    rr = outer(r12)
    start = mpmath.log(inner(q1, rr) / inner(q2, rr)) / 2
    x = increasing_root(contact_equation(r12, q1, q2), start)
    return 1 / (1 + mpmath.exp(-x))


def condition_number(r12, q1, q2, x, s, mu2):
    """Entrywise condition number of mu^2, for s = Q(x)^-1 r, x = lambda.

    [x (1-x) ((1-x) sum |si Q1ij sj| + x sum |si Q2ij sj|)
     + 2 x (1-x) sum |ri si|] / mu^2
    """
    ss = tuple(map(abs, outer(s)))
    forms = combine(1 - x, tuple(map(abs, q1)), x, tuple(map(abs, q2)))
    rs = sum(abs(u * v) for u, v in zip(r12, s))
    return x * (1 - x) * (inner(forms, ss) + 2 * rs) / mu2


def contact(r12, q1, q2):
    """(mu^2, lambda, cond), all in multiple precision.

    mu^2 = f(lambda) comes from a Cholesky decomposition, which takes no part
    in finding lambda; that the scale factors of the two ellipsoids at this
    lambda, mu1^2 and mu2^2, are both equal to mu^2 verifies both.
    """
    x = maximiser(r12, q1, q2)
    q = combine(1 - x, q1, x, q2)
    s = tuple(mp.cholesky_solve(mp.matrix(full(q)), mp.matrix(r12)))
    mu2 = x * (1 - x) * sum(u * v for u, v in zip(r12, s))
    for scale, form in ((1 - x, q1), (x, q2)):
        assert abs(scale**2 * inner(form, outer(s)) / mu2 - 1) < AGREEMENT
    return mu2, x, condition_number(r12, q1, q2, x, s, mu2)


def contact_record(r12, q1, q2):
    """(mu^2, mu^2 - 1, lambda, cond) in doubles, for arguments in doubles."""
    assert is_usable(q1) and is_usable(q2)
    mu2, x, cond = contact(exact(r12), exact(q1), exact(q2))
    excess = mu2 - 1
    if abs(excess) < EXACTLY_ONE:
        mu2, excess = mpf(1), mpf(0)
    return rounded((mu2, excess, x, cond))


# --- Random ellipsoids ------------------------------------------------------

class Draw:
    """Random numbers that are the same on all machines.

    `random.Random.random` is the one method the stream of which Python
    guarantees; all that follows is multiple precision.
    """

    def __init__(self, seed):
        self._random = random.Random(seed).random

    def pick(self, items):
        """One of the items."""
        return items[int(self._random() * len(items))]

    def shuffled(self, items):
        """The items in random order."""
        return sorted(items, key=lambda _: self._random())

    def uniform(self, low, high):
        """A number between low and high."""
        return low + (mpf(high) - low) * mpf(self._random())

    def power_of_ten(self, low, high):
        """A number between 10^low and 10^high, its logarithm uniform."""
        return mpf(10)**self.uniform(low, high)

    def unit_vector(self, dim):
        """A direction in dim dimensions, by rejection from the cube."""
        while True:
            v = [self.uniform(-1, 1) for _ in range(dim)]
            norm2 = sum(x * x for x in v)
            if 0 < norm2 <= 1:
                return tuple(x / mpmath.sqrt(norm2) for x in v)

    def rotation(self):
        """A rotation matrix, by rows, from a unit quaternion."""
        w, x, y, z = self.unit_vector(4)
        return ((1 - 2 * (y*y + z*z), 2 * (x*y - w*z), 2 * (x*z + w*y)),
                (2 * (x*y + w*z), 1 - 2 * (x*x + z*z), 2 * (y*z - w*x)),
                (2 * (x*z - w*y), 2 * (y*z + w*x), 1 - 2 * (x*x + y*y)))

    def semi_axes(self, aspect):
        """A flat, slender or triaxial shape, its longest semi-axis 1."""
        shortest = 1 / aspect
        middle = self.pick((1, shortest, shortest**self.uniform(0, 1)))
        return self.shuffled((mpf(1), mpf(middle), shortest))

    def shear(self):
        """A matrix of small integers, of determinant 1, by rows."""
        a, b, c, d, e, f = (self.pick(range(-2, 3)) for _ in range(6))
        lower = (1, 0, 0), (a, 1, 0), (b, c, 1)
        upper = (1, d, e), (0, 1, f), (0, 0, 1)
        return [[sum(x * y for x, y in zip(row, column))
                 for column in zip(*upper)] for row in lower]


def scaled(size, semi_axes):
    """The semi-axes of the ellipsoid blown up by size."""
    return tuple(size * a for a in semi_axes)


def turned(rotation, v):
    """The vector v turned by the rotation."""
    return tuple(sum(x * y for x, y in zip(row, v)) for row in rotation)


def oriented(rotation, semi_axes):
    """Quadratic form, in doubles, of the ellipsoid turned by the rotation."""
    return rounded(congruent(rotation, diagonal(semi_axes)))


def random_forms(draw, decades, ratio=None):
    """Two forms of independent shapes and orientations.

    decades: the range of log10 of the aspect ratios; ratio: of the longest
    semi-axis of the second to that of the first, by default 0.1 to 10.
    """
    ratio = ratio or draw.power_of_ten(-1, 1)
    size = draw.power_of_ten(-1, 1)
    return tuple(
        oriented(draw.rotation(),
                 scaled(x, draw.semi_axes(draw.power_of_ten(*decades))))
        for x in (size, size * ratio))


def placed(direction, mu2, q1, q2):
    """(r12, q1, q2) in doubles, with r12 along direction; mu2 is a target.

    mu^2 grows as |r12|^2; it misses the target by the rounding of r12.
    """
    reached = contact(direction, exact(q1), exact(q2))[0]
    return rounded(scaled(mpmath.sqrt(mu2 / reached), direction)), q1, q2


# --- Categories of pairs: each function draws one (r12, q1, q2) -------------

def general(draw, decades, log10_mu2=(-2, 2)):
    """No special position; aspect ratios and mu^2 in the ranges given."""
    return placed(draw.unit_vector(3), draw.power_of_ten(*log10_mu2),
                  *random_forms(draw, decades))


def near_tangent(draw, decades):
    """|mu^2 - 1| from 1e-1 to 1e-15, give or take the rounding of r12."""
    excess = draw.pick((-1, 1)) * draw.power_of_ten(-15, -1)
    return placed(draw.unit_vector(3), 1 + excess,
                  *random_forms(draw, decades))


def size_ratio(draw):
    """One ellipsoid up to 1e8 times the size of the other."""
    ratio = draw.power_of_ten(-8, 8)
    return placed(draw.unit_vector(3), draw.power_of_ten(-2, 2),
                  *random_forms(draw, (0, 6), ratio))


def extreme_lambda(draw):
    """lambda, or 1 - lambda, below 1e-12 (above 1e-15), by the size ratio."""
    ratio = draw.power_of_ten(13, 14.5)**draw.pick((-1, 1))
    return placed(draw.unit_vector(3), draw.power_of_ten(-2, 2),
                  *random_forms(draw, (0, 0.5), ratio))


def spheres(draw):
    """Two spheres."""
    q1, q2 = (rounded(diagonal(3 * [draw.power_of_ten(-3, 3)]))
              for _ in range(2))
    return placed(draw.unit_vector(3), draw.power_of_ten(-2, 2), q1, q2)


def identical(draw):
    """Twice the same form: lambda = 1/2."""
    q, _ = random_forms(draw, (0, 6))
    return placed(draw.unit_vector(3), draw.power_of_ten(-2, 2), q, q)


def principal_axis(draw):
    """Common tilted principal directions, r12 along one (to rounding)."""
    rotation = draw.rotation()
    q1, q2 = (oriented(rotation, draw.semi_axes(draw.power_of_ten(0, 6)))
              for _ in range(2))
    direction = draw.pick(tuple(zip(*rotation)))
    return placed(direction, draw.power_of_ten(-2, 2), q1, q2)


def coaxial_at(draw, mu):
    """Aligned spheroids, r12 along a coordinate axis; all exact, and so is mu.

    Axes of revolution and r12: in line, parallel side by side, crossed side
    by side, or T-shaped.
    """
    along, *across = draw.shuffled(range(3))
    axes = draw.pick(((along, along), (across[0], across[0]),
                      across, (along, across[0])))
    shapes = []
    for axis in axes:
        equatorial, polar = (
            draw.pick(range(1, 16)) * mpf(2)**draw.pick(range(-8, 9))
            for _ in range(2))
        shapes.append([polar if i == axis else equatorial for i in range(3)])
    distance = mu * (shapes[0][along] + shapes[1][along])
    r12 = [draw.pick((-1, 1)) * distance if i == along else mpf(0)
           for i in range(3)]
    return unrounded(r12), *(unrounded(diagonal(x)) for x in shapes)


def coaxial(draw):
    """Coaxial spheroids, mu a multiple of 1/16 (up to 3) other than 1."""
    sixteenths = draw.pick((*range(1, 16), *range(17, 49)))
    return coaxial_at(draw, mpf(sixteenths) / 16)


def coaxial_tangent(draw):
    """Coaxial spheroids, mu = 1 exactly."""
    return coaxial_at(draw, mpf(1))


PYTHAGOREAN_QUADRUPLES = (  # x^2 + y^2 + z^2 = w^2, as (x, y, z, w)
    (1, 2, 2, 3), (2, 3, 6, 7), (1, 4, 8, 9), (4, 4, 7, 9), (2, 6, 9, 11),
    (6, 6, 7, 11), (3, 4, 12, 13), (2, 5, 14, 15), (2, 10, 11, 15))


def oblique_tangent(draw):
    """Tilted triaxial ellipsoids of integer entries, mu = 1 exactly.

    For |u| = U, |v| = V, the aligned ellipsoids of semi-axes U V ui |pi| and
    U V vi |pi| have the outer normals 1 / pi and -1 / pi at c1 + V ui^2 pi
    and c2 - U vi^2 pi; they touch if r12 joins these points. Any linear map
    of the whole preserves tangency.
    """
    (*u, norm_u), (*v, norm_v) = (draw.pick(PYTHAGOREAN_QUADRUPLES)
                                  for _ in range(2))
    u, v = draw.shuffled(u), draw.shuffled(v)
    p = [draw.pick((-1, 1)) * mpf(draw.pick(range(1, 16))) for _ in range(3)]
    r12 = [(norm_v * x * x + norm_u * y * y) * z for x, y, z in zip(u, v, p)]
    rows = draw.shear()
    forms = (congruent(rows, diagonal([norm_u * norm_v * x * z
                                       for x, z in zip(w, p)]))
             for w in (u, v))
    return (unrounded([sum(x * y for x, y in zip(row, r12)) for row in rows]),
            *map(unrounded, forms))


def crossed(draw):
    """Slender shapes at right angles, tip to tip: lambda on a plateau of f.

    The long semi-axes are 1 along x and the size of the second along y. For
    r12 = (1 + tilt1, size (1 + tilt2), offset), f is, between thin layers at
    its ends, close to a line in lambda that is level if the tilts are equal.
    Then all is turned, and r12 multiplied: |mu^2 - 1| from 1e-1 to 1e-14.
    """
    def sign():
        return draw.pick((-1, 1))

    shortest = 1 / draw.power_of_ten(mpmath.log10(2000), 6)
    third = shortest**draw.pick((mpf(0.5), draw.uniform(0, 1)))
    size = draw.pick((1, draw.power_of_ten(-1, 1)))
    tilt1 = sign() * draw.power_of_ten(-14, -1)
    tilt2 = draw.pick((tilt1, sign() * draw.power_of_ten(-14, -1)))
    offset = sign() * third * draw.power_of_ten(-8, 0)
    excess = sign() * draw.power_of_ten(-14, -1)
    rotation = draw.rotation()
    r12 = (sign() * (1 + tilt1), sign() * size * (1 + tilt2), offset)
    return placed(turned(rotation, r12), 1 + excess,
                  oriented(rotation, (1, shortest, third)),
                  oriented(rotation, scaled(size, (shortest, 1, third))))


def read_found():
    """Pairs that a search for the worst errors has found (see README.md)."""
    with open(FOUND, encoding='utf-8') as file:
        for line in file:
            numbers = tuple(map(float.fromhex, line.split()))
            yield numbers[:3], numbers[3:9], numbers[9:]


FOUND = pathlib.Path(__file__).with_name('found_pairs.txt')
FOUND_PAIRS = tuple(read_found())

CATEGORIES = (  # (name, number of pairs, how to draw one of them)
    *((f'general_aspect_1e{i}_1e{i + 1}', 1000,
       functools.partial(general, decades=(i, i + 1))) for i in range(6)),
    *((f'near_tangent_aspect_1e{i}_1e{i + 2}', 1000,
       functools.partial(near_tangent, decades=(i, i + 2)))
      for i in (0, 2, 4)),
    ('size_ratio', 1500, size_ratio),
    ('extreme_lambda', 600, extreme_lambda),
    ('deep_overlap', 600,
     functools.partial(general, decades=(0, 6), log10_mu2=(-8, -2))),
    ('far_apart', 600,
     functools.partial(general, decades=(0, 6), log10_mu2=(2, 8))),
    ('spheres', 500, spheres),
    ('identical', 500, identical),
    ('principal_axis', 600, principal_axis),
    ('coaxial', 400, coaxial),
    ('coaxial_tangent', 400, coaxial_tangent),
    ('oblique_tangent', 600, oblique_tangent),
    ('crossed', 2000, crossed),
    ('crossed_found', len(FOUND_PAIRS),
     lambda _, pairs=iter(FOUND_PAIRS): next(pairs)),  # noqa: B008 (one iterator)
)


# --- The file ---------------------------------------------------------------

def icosahedron():
    """The 12 vertices, on the unit sphere, each followed by its opposite."""
    phi = (1 + mpmath.sqrt(5)) / 2
    norm = mpmath.sqrt(1 + phi**2)
    one, phi, zero = 1 / norm, phi / norm, mpf(0)
    vertices = []
    for x, y in ((one, phi), (-one, phi)):
        for v in ((zero, x, y), (x, y, zero), (y, zero, x)):
            vertices += [rounded(v), rounded(-z for z in v)]
    return vertices


def spheroid(a, c, n):
    """a^2 I + (c^2 - a^2) n n^T / |n|^2, for arguments in doubles."""
    a, c = exact((a, c))
    nn = outer(exact(n))
    identity = diagonal(exact((1, 1, 1)))
    return rounded(combine(a**2, identity,
                           (c**2 - a**2) / inner(identity, nn), nn))


def f_table(directions, spheroids):
    """f for all pairs of spheroids, all directions and all LAMBDAS."""
    return [[[f_values(max(r12, tuple(-x for x in r12)), q1, q2)
              for r12 in directions] for q2 in spheroids] for q1 in spheroids]


def contact_table(draw):
    """Columns of the contact group: the arguments, the truth, the category."""
    rows = []
    for category, (name, count, draw_pair) in enumerate(CATEGORIES):
        for _ in range(count):
            pair = draw_pair(draw)
            record = contact_record(*pair)
            assert (record[1] == 0) == name.endswith('_tangent')
            rows.append((*pair, *record, category))
    names = ('r12', 'q1', 'q2', 'mu2', 'mu2_minus_1', 'lambda', 'cond')
    columns = dict(zip((*names, 'category'), zip(*rows)))
    return {name: np.array(values, dtype='u1' if name == 'category' else 'f8')
            for name, values in columns.items()}


def write(path):
    """Compute everything and write the file."""
    options = {'compression': 'gzip', 'compression_opts': 9,
               'track_times': False}
    directions = icosahedron()
    spheroids = [spheroid(a, c, n)
                 for a in RADII for c in RADII for n in directions]
    with h5py.File(path, 'w') as h5:
        h5.attrs['version'] = LAYOUT_VERSION
        h5.attrs['generator'] = np.bytes_(pathlib.Path(__file__).name)
        h5.attrs['digits'] = DIGITS
        h5.attrs['seed'] = SEED
        for name, values in (('radii', RADII), ('directions', directions),
                             ('lambdas', LAMBDAS), ('spheroids', spheroids)):
            h5.create_dataset(name, data=np.array(values), track_times=False)
        h5.create_dataset('F', data=np.array(f_table(directions, spheroids)),
                          chunks=F_CHUNKS, **options)
        group = h5.create_group('contact')
        for name, values in contact_table(Draw(SEED)).items():
            group.create_dataset(
                name, data=values, shuffle=True,
                chunks=(CONTACT_ROWS_PER_CHUNK, *values.shape[1:]), **options)
        group.create_dataset(
            'category_names', track_times=False,
            data=np.array([name for name, *_ in CATEGORIES], dtype='S'))


if __name__ == '__main__':
    default = pathlib.Path(__file__).with_name('pw85_ref_data.h5')
    write(sys.argv[1] if len(sys.argv) > 1 else default)
