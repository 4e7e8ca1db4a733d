#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Pairs in 2 to 16 dimensions against mpmath with 60 digits: contact, comparison, overlap, containment, distance, definiteness.

    PYTHONPATH=BUILD/python scripts/any_dimension_truths.py [CASES [SEED]]     20,000 cases by default, 20 minutes

Each truth is a bracket that is proved by evaluation alone, so the start of an iteration does not matter:

- contact: f(λ) <= μ² <= max(μ1², μ2²) at any λ.
- containment: (√(sᵀQ2s) + s·r)²/(sᵀQ1s) <= κ² for any s; κ² <= ν + rᵀ(Q1 - Q2/ν)⁻¹r for any ν with a positive definite matrix.
- distance: the width of the slab along any vector is at most the distance; the points of the surfaces along it are not closer.

The iterations begin at the results of the library, and go on until a bracket is narrow: 1e-35 of the value, u Σ/16 for distances. The
results must satisfy the bounds of pw85_any_dimension.h; comparisons with the doubles around μ² must have the sign of the truth. Whether a
form is positive definite follows from its pivots in 60 digits, or from fractions where a pivot is tiny.

Prints a line for each n: the largest error of μ² in units of u cond (bound 4), of κ² in units of u c (bound 2n + 20), and of the distance
in units of u Σ (bound 4); the comparisons whose sign the truth knows; the brackets of κ² or of the distance that did not become narrow; the
pairs with a form that is not positive definite. Ends with 1 if any result is wrong, and prints its pair as hexadecimal numbers.
"""

import itertools
import sys
from fractions import Fraction

import numpy as np
from mpmath import log, mp, mpf, sqrt

import pypw85

mp.dps = 60
U = mpf(2) ** -53
NARROW = mpf(10) ** -35
ASPECTS = (2, 10, 100, 1e3, 1e4, 1e6, 3e7)
ASPECTS_OF_AXES = (*ASPECTS, 1e12, 1e40)


# Linear algebra on lists of rows.


def full(n, q, scale=1):
    """A packed form as a matrix of mpf."""
    entries = iter(q)
    rows = [[mpf(0)] * n for _ in range(n)]
    for i in range(n):
        for j in range(i, n):
            rows[i][j] = rows[j][i] = mpf(float(next(entries))) * scale
    return rows


def blend(a, q1, b, q2):
    return [[a * x + b * y for x, y in zip(row1, row2)] for row1, row2 in zip(q1, q2)]


def dot(x, y):
    return mp.fdot(zip(x, y))


def times(q, x):
    return [dot(row, x) for row in q]


def factorize(q):
    """L and D of Q = L D Lᵀ, by rows. None if a pivot is not positive."""
    lower, pivots = [], []
    for i, row in enumerate(q):
        scaled = []  # L_ij D_j
        for j in range(i):
            scaled.append(row[j] - dot(scaled, lower[j]))
        factors = [x / d for x, d in zip(scaled, pivots)]
        pivot = row[i] - dot(scaled, factors)
        if pivot <= 0:
            return None
        lower.append(factors)
        pivots.append(pivot)
    return lower, pivots


def solve(factors, b):
    lower, pivots = factors
    x = []
    for row, number in zip(lower, b):
        x.append(number - dot(row, x))
    x = [y / d for y, d in zip(x, pivots)]
    for i in range(len(x) - 1, -1, -1):
        for j in range(i):
            x[j] -= lower[i][j] * x[i]
    return x


def is_definite(n, q):
    """Decided in 60 digits unless a pivot is tiny; then in fractions."""
    matrix = full(n, q)
    if any(matrix[i][i] <= 0 for i in range(n)):
        return False
    factors = factorize(matrix)
    if factors is not None and all(d > mpf(10) ** -40 * matrix[i][i] for i, d in enumerate(factors[1])):
        return True
    entries = iter(q)
    rows = [[None] * n for _ in range(n)]
    for i in range(n):
        for j in range(i, n):
            rows[i][j] = rows[j][i] = Fraction(float(next(entries)))
    for k in range(n):
        if rows[k][k] <= 0:
            return False
        for i in range(k + 1, n):
            factor = rows[i][k] / rows[k][k]
            for j in range(k + 1, n):
                rows[i][j] -= factor * rows[k][j]
    return True


# Truths.


def magnitudes(q, s):
    return mp.fsum(abs(x * y * z) for x, row in zip(s, q) for y, z in zip(row, s))


def contact_truth(r, q1, q2, lambda_):
    """μ² from below and from above, and cond."""
    lambda_ = min(max(mpf(float(lambda_)), mpf(2) ** -1100), 1 - mpf(2) ** -54)
    x, least, most = log(lambda_ / (1 - lambda_)), mpf("-inf"), mpf("inf")  # log τ, and its bracket
    for _ in range(300):
        tau = mp.exp(x)
        factors = factorize(blend(1, q1, tau, q2))
        s = solve(factors, r)
        p, q = times(q1, s), times(q2, s)
        a, b = dot(s, p), dot(s, q)
        lower, upper = tau / (1 + tau) * dot(r, s), max(a, tau * tau * b)
        if upper - lower <= NARROW * upper:
            break
        h = x + log(b / a) / 2  # increases with x, with a slope of at most 1
        least, most = (x, most) if h < 0 else (least, x)
        v = solve(factors, q)
        slope = 1 + tau * (dot(p, v) / a - dot(q, v) / b)
        x = x - h / slope if slope > 0 else mpf("nan")
        if not least < x < most:
            x = (least + most) / 2 if mp.isfinite(most - least) else max(least, min(most, 0)) - (8 if h > 0 else -8)
    else:
        raise ArithmeticError("no contact truth")
    lambda_ = tau / (1 + tau)
    n = [(1 + tau) * x for x in s]
    sums = (1 - lambda_) * magnitudes(q1, n) + lambda_ * magnitudes(q2, n) + 2 * mp.fsum(abs(x * y) for x, y in zip(r, n))
    return lower, upper, lambda_ * (1 - lambda_) / upper * sums


def containment_truth(r, q1, q2, point):
    """κ² from below and from above, and the sum c of its error bound."""
    factors = factorize(q2)
    s = solve(factors, [mpf(float(x)) - y for x, y in zip(point, r)])
    if not any(s):  # the point is the centre up to rounding
        s = solve(factorize(q1), r)
    lower, upper, best = mpf(0), mpf("inf"), None
    floor, ceiling = mpf(0), mpf("inf")  # of ν
    nu = None
    for _ in range(40):  # more are needed only where r12 has almost no part along the eigenvector of the largest ν
        along, form1, form2 = dot(s, r), dot(s, times(q1, s)), dot(s, times(q2, s))
        ratio = (sqrt(form2) + abs(along)) ** 2 / form1
        if ratio > lower:
            lower, best = ratio, (s, form1, sqrt(form2))
        if nu is None:
            nu = sqrt(ratio * form2 / form1)
        if upper - lower <= NARROW * lower:
            break
        factors = factorize(blend(1, q1, -1 / nu, q2))
        if factors is None:
            floor = nu
            nu = 2 * nu if ceiling == mpf("inf") else (nu + ceiling) / 2
            continue
        s = solve(factors, r)
        upper = min(upper, nu + dot(r, s))
        q = times(q2, s)
        form = dot(s, q)
        e = sqrt(form) / nu
        floor, ceiling = (nu, ceiling) if e > 1 else (floor, nu)
        following = nu + nu * (e - 1) / (1 + dot(q, solve(factors, q)) / form / nu)
        nu = following if floor < following < ceiling else (floor + ceiling) / 2
    else:
        return lower, upper, None
    s, form1, root2 = best
    along = mp.fsum(abs(x * y) for x, y in zip(r, s))
    sums = lower * magnitudes(q1, s) / form1 + sqrt(lower / form1) * (magnitudes(q2, s) / root2 + 2 * along)
    return lower, upper, sums


@mp.workdps(100)
def distance_truth(r, q1, q2, normal):
    """The distance from below and from above, and Σ. From u = (Q1 + t Q2 + s)⁻¹r with the t and s of a normal follows a better one.

    Ellipsoids much longer than r12 need more than 60 digits.
    """
    n = [mpf(float(x)) for x in normal]
    for _ in range(60):
        length = sqrt(dot(n, n))
        n = [x / length for x in n]
        p1, p2 = times(q1, n), times(q2, n)
        alpha, beta = sqrt(dot(n, p1)), sqrt(dot(n, p2))
        w = [x - y / alpha - z / beta for x, y, z in zip(r, p1, p2)]
        lower, upper = dot(n, r) - alpha - beta, sqrt(dot(w, w))
        sums = mp.fsum(abs(x * y) for x, y in zip(n, r)) + magnitudes(q1, n) / (2 * alpha) + magnitudes(q2, n) / (2 * beta)
        if upper - lower <= U / 16 * sums:
            return lower, upper, sums
        shift = max(alpha * lower, 0)
        m = blend(1, q1, alpha / beta, q2)
        for i, row in enumerate(m):
            row[i] += shift
        n = solve(factorize(m), r)
    return lower, upper, None


# Cases.


def random_axes(rng, n):
    return np.linalg.qr(rng.normal(size=(n, n)))[0]


def form_of(axes, lengths):
    return ((axes * lengths**2) @ axes.T)[np.triu_indices(len(lengths))]


def random_lengths(rng, n, aspect):
    lengths = aspect ** -rng.uniform(0, 1, size=n)
    lengths[0], lengths[-1] = 1, 1 / aspect
    return rng.permutation(lengths)


def random_case(rng, n, kind):
    """A pair: general, along the axes, thin in common, correlated, of one form, of unlike sizes, or padded by unit axes."""
    aspect, other = rng.choice(ASPECTS_OF_AXES if kind == "axes" else ASPECTS, size=2)
    r12 = rng.normal(size=n) * 10 ** rng.uniform(-1, 1)
    axes = random_axes(rng, n)
    if kind == "axes":
        axes = np.eye(n)
    q1 = form_of(axes, random_lengths(rng, n, aspect))
    q2 = form_of(axes if kind in ("axes", "thin") else random_axes(rng, n), random_lengths(rng, n, other))
    if kind == "thin":  # both thin along one direction, and apart across it
        lengths = np.exp(rng.uniform(-1, 1, size=(2, n)))
        lengths[:, 0] /= aspect
        q1, q2 = form_of(axes, lengths[0]), form_of(axes, lengths[1])
        r12 -= axes[:, 0] * (axes[:, 0] @ r12)
    if kind == "correlated":
        forms = []
        for power in rng.uniform(0, 14, size=2):
            units = np.exp2(rng.integers(-20, 21, size=n).astype(float))
            forms.append((np.eye(n) * 10**-power + (1 - 10**-power)) * np.outer(units, units))
        q1, q2 = (q[np.triu_indices(n)] for q in forms)
    if kind == "equal":
        q2 = q1.copy()
    if kind == "unlike":
        q2 = q2 * 4.0 ** rng.integers(-40, 41)
    if kind == "padded":
        full_forms = []
        for _ in range(2):
            q = np.eye(n)
            k = max(n // 2, 1)
            q[:k, :k] = (lambda a, x: (a * x**2) @ a.T)(random_axes(rng, k), np.exp(rng.uniform(-2, 2, size=k)))
            full_forms.append(q[np.triu_indices(n)])
        q1, q2 = full_forms
        r12[max(n // 2, 1) :] = 0
    unit = 2.0 ** rng.integers(-40, 41)
    return r12 * unit, q1 * unit**2, q2 * unit**2


KINDS = ("general", "general", "axes", "thin", "correlated", "equal", "unlike", "padded")


class Report:
    def __init__(self):
        self.wrong = 0

    def check(self, correct, what, case):
        if correct:
            return
        self.wrong += 1
        print("WRONG", what, *(" ".join(float(x).hex() for x in array) for array in case), sep="\n  ", flush=True)


def check_numbers(report, worst, case, counts):
    """Contact, comparison, overlap, containment and distance of a pair of positive definite forms."""
    r12, q1, q2 = case
    n = len(r12)
    r, full1, full2 = [mpf(float(x)) for x in r12], full(n, q1), full(n, q2)
    mu2, lambda_ = pypw85.nd_contact(r12, q1, q2)
    lower, upper, cond = contact_truth(r, full1, full2, lambda_)
    error = max(abs(mpf(float(mu2)) - lower), abs(mpf(float(mu2)) - upper)) / (U * cond * upper)
    worst["mu2"] = max(worst["mu2"], float(error))
    report.check(error <= 4, f"mu2 {float(error)}", case)
    for m in (np.nextafter(mu2, 0), mu2, np.nextafter(mu2, np.inf), 1.0):
        sign = 1 if lower > mpf(float(m)) else -1 if upper < mpf(float(m)) else None
        counts["compared"] += sign is not None
        report.check(sign is None or pypw85.nd_compare(r12, q1, q2, m) == sign, f"comparison with {float(m).hex()}", case)
    overlap = pypw85.nd_overlap(r12, q1, q2)
    report.check(not ((lower > 1 and overlap) or (upper < 1 and not overlap)), "overlap", case)
    kappa2, point = pypw85.nd_containment(r12, q1, q2)
    least, largest, c = containment_truth(r, full1, full2, point)
    if c is None:
        counts["open"] += 1
    else:
        error = max(abs(mpf(float(kappa2)) - least), abs(mpf(float(kappa2)) - largest)) / (U * c)
        worst["kappa2"] = max(worst["kappa2"], float(error))
        report.check(error <= 2 * n + 20, f"kappa2 {float(error)}", case)
    contains = pypw85.nd_contains(r12, q1, q2)
    report.check(not ((largest < 1 and not contains) or (least > 1 and contains)), "contains", case)
    try:
        found = pypw85.nd_distance(r12, q1, q2)
    except pypw85.PW85Error as error:
        report.check(False, f"distance: {error}", case)
        return mu2
    report.check((found.distance == 0 and np.isnan(found.point1).all()) if overlap else found.distance >= 0, "zero distance", case)
    if not overlap:
        least, largest, sums = distance_truth(r, full1, full2, found.normal)
        if sums is None:
            counts["open"] += 1
            return mu2
        error = max(abs(mpf(float(found.distance)) - least), abs(mpf(float(found.distance)) - largest)) / (U * sums)
        worst["distance"] = max(worst["distance"], float(error))
        report.check(error <= 4, f"distance {float(error)}", case)
    return mu2


def touching(rng, case, mu2):
    """The pair moved to μ² = 1 up to a rounding error or a little more."""
    r12, q1, q2 = case
    change = rng.choice([0, 1e-16, 1e-15, 1e-13, 1e-9]) * rng.choice([-1, 1])
    return r12 * ((1 + change) / np.sqrt(mu2)), q1, q2


def main(cases=20000, seed=75):
    rng = np.random.default_rng(seed)
    report = Report()
    print("n,cases,mu2,kappa2,distance,compared,open,refused", flush=True)
    for n in range(2, 17):
        worst = dict.fromkeys(("mu2", "kappa2", "distance"), 0.0)
        counts = dict.fromkeys(("cases", "compared", "open", "refused"), 0)
        for kind in itertools.cycle(KINDS):
            if counts["cases"] >= cases / 15:
                break
            case = random_case(rng, n, kind)
            definite = all(is_definite(n, q) for q in case[1:])
            counts["cases"] += 1
            if not definite:
                counts["refused"] += 1
                for function in (pypw85.nd_contact, pypw85.nd_overlap, pypw85.nd_contains, pypw85.nd_distance):
                    try:
                        function(*case)
                        report.check(False, f"{function.__name__} of an indefinite form", case)
                    except pypw85.PW85Error as error:
                        report.check("positive definite" in str(error), str(error), case)
                continue
            mu2 = check_numbers(report, worst, case, counts)
            counts["cases"] += 1
            check_numbers(report, worst, touching(rng, case, mu2), counts)
        numbers = [f"{worst[key]:.2f}" for key in ("mu2", "kappa2", "distance")]
        print(n, counts["cases"], *numbers, *list(counts.values())[1:], sep=",", flush=True)
    print(f"{report.wrong} wrong")
    return report.wrong > 0


if __name__ == "__main__":
    sys.exit(main(*map(int, sys.argv[1:])))
