#!/usr/bin/python3
"""Finds the constants of the margins against rounding errors, by maximising the worst case.

Every formula that a margin guards is written below in the order of the C++ code, rounding by rounding. With z_k(1 + δ_k) for each
rounded result, |δ_k| <= u, the error of the result is Σ δ_k z_k ∂f/∂z_k to first order, which is at most u Σ |z_k ∂f/∂z_k|. One
reverse sweep gives this sum. The sum divided by the form of the margin is maximised over pairs of positive definite forms,
separations and t, by climbing from many random starts at once. All formulas are homogeneous in the units of each axis, so that M =
Q1 + t Q2 has a unit diagonal without loss of generality. A fused multiplication and addition removes one δ_k, so that the sum loses
a term: the constants hold with and without fusion.

    rounding_bounds.py [--starts N] [--steps N]

prints the worst cases, the margins that they need, and the constants of the headers. It fails if a constant is too small, or more
than a third larger than necessary.
"""

import argparse
import pathlib
import re
import sys

import numpy as np


class Rounded:
    """A result of arithmetic for many samples at once, with its operands."""

    def __init__(self, tape, value, parents=(), rounded=True):
        self.tape, self.value, self.parents, self.rounded = tape, value, parents, rounded
        self.index = len(tape)
        tape.append(self)

    def lift(self, x):
        return x if isinstance(x, Rounded) else Rounded(self.tape, x + 0.0 * self.value, rounded=False)

    def __add__(self, other):
        other = self.lift(other)
        return Rounded(self.tape, self.value + other.value, ((self, 1.0), (other, 1.0)))

    def __sub__(self, other):
        other = self.lift(other)
        return Rounded(self.tape, self.value - other.value, ((self, 1.0), (other, -1.0)))

    def __mul__(self, other):
        other = self.lift(other)
        return Rounded(self.tape, self.value * other.value, ((self, other.value), (other, self.value)))

    def __truediv__(self, other):
        q = self.value / other.value
        return Rounded(self.tape, q, ((self, 1.0 / other.value), (other, -q / other.value)))

    def exactly(self):
        """The same result, for an operation without rounding: a comparison, or a change of sign or by a power of two."""
        self.rounded = False
        return self

    __radd__, __rmul__ = __add__, __mul__


def worst_case(result):
    """Σ |z_k ∂(result)/∂z_k|, in units of u."""
    adjoints = [0.0] * len(result.tape)
    adjoints[result.index] = np.ones_like(result.value)
    total = np.zeros_like(result.value)
    for node in reversed(result.tape[: result.index + 1]):
        adjoint = adjoints[node.index]
        if node.rounded:
            total = total + np.abs(adjoint * node.value)
        for parent, slope in node.parents:
            adjoints[parent.index] = adjoints[parent.index] + adjoint * slope
    return total


# The formulas of include/pw85, for matrices as {(i, j): entry} with i <= j.


def at(a, i, j):
    return a[(i, j) if i <= j else (j, i)]


def total(terms):
    terms = list(terms)
    result = terms[0]
    for term in terms[1:]:
        result = result + term
    return result


def blend(q1, t, q2):
    return {k: q1[k] + t * q2[k] for k in q1}


def adjugate(m, d):
    if d == 2:
        return {(0, 0): m[1, 1], (0, 1): (m[0, 1] * -1.0).exactly(), (1, 1): m[0, 0]}
    return {
        (0, 0): m[1, 1] * m[2, 2] - m[1, 2] * m[1, 2],
        (0, 1): m[0, 2] * m[1, 2] - m[0, 1] * m[2, 2],
        (0, 2): m[0, 1] * m[1, 2] - m[0, 2] * m[1, 1],
        (1, 1): m[0, 0] * m[2, 2] - m[0, 2] * m[0, 2],
        (1, 2): m[0, 1] * m[0, 2] - m[0, 0] * m[1, 2],
        (2, 2): m[0, 0] * m[1, 1] - m[0, 1] * m[0, 1],
    }


def determinant(m, adj, d):
    return total(m[0, j] * adj[0, j] for j in range(d))


def product(a, x):
    return [total(at(a, i, j) * x[j] for j in range(len(x))) for i in range(len(x))]


def dot(x, y):
    return total(a * b for a, b in zip(x, y))


def quadratic_form(a, x):
    d = len(x)
    diagonal = total(a[i, i] * (x[i] * x[i]) for i in range(d))
    rest = total(a[i, j] * ((x[i] + x[i]).exactly() * x[j]) for j in range(1, d) for i in range(j))
    return diagonal + rest


def factorize(a, d):
    lower, pivots, reciprocals = {}, [], []
    for j in range(d):
        pivot = a[j, j]
        for k in range(j):
            pivot = pivot - lower[j, k] * (lower[j, k] * pivots[k])
        pivots.append(pivot)
        reciprocals.append(pivot.lift(1.0) / pivot)
        for i in range(j + 1, d):
            entry = a[j, i]
            for k in range(j):
                entry = entry - lower[i, k] * (lower[j, k] * pivots[k])
            lower[i, j] = entry * reciprocals[j]
    return lower, pivots, reciprocals


def solve(factors, x):
    lower, _, reciprocals = factors
    x, d = list(x), len(x)
    for i in range(1, d):
        for j in range(i):
            x[i] = x[i] - lower[i, j] * x[j]
    for i in reversed(range(d)):
        x[i] = x[i] * reciprocals[i]
        for j in range(i + 1, d):
            x[i] = x[i] - lower[j, i] * x[j]
    return x


class Sample:
    """Pairs for which M = Q1 + t Q2 has a unit diagonal. The parameters, an array (number, samples), are the factors of Q1 and t
    Q2, r, log t, and a direction."""

    def __init__(self, parameters, d, size=None):
        n, self.d = parameters.shape[1], d
        g1, g2, r, other = np.split(parameters[: 2 * d * d + 2 * d], [d * d, 2 * d * d, 2 * d * d + d])
        log_t = np.clip(parameters[-1], -12.0, 12.0)
        g1, g2 = (np.moveaxis(g.reshape(d, d, n), 2, 0) for g in (g1, g2))
        unit = 1.0 / np.sqrt((g1**2).sum(2) + (g2**2).sum(2))[:, :, None]
        g1, g2 = unit * g1, unit * g2
        self.t = np.exp(log_t)
        self.p, self.p2 = g1 @ np.swapaxes(g1, 1, 2), g2 @ np.swapaxes(g2, 1, 2)
        self.m = self.p + self.p2
        self.det = np.linalg.det(self.m)
        self.r = r.T
        self.solution = np.linalg.solve(self.m, self.r[:, :, None])[:, :, 0]
        self.square = np.einsum("ni,ni->n", self.r, self.solution)  # R
        if size is not None:
            scale = 1.0 / np.sqrt(size(self))
            self.r, self.solution = scale[:, None] * self.r, scale[:, None] * self.solution
            self.square = scale**2 * self.square
        # A direction of errors of s, of length 1 and orthogonal to s in the scalar product of M; it is stored multiplied by M.
        v = other.T - (np.einsum("ni,ni->n", other.T, self.r) / self.square)[:, None] * self.solution
        mv = np.einsum("nij,nj->ni", self.m, v)
        any_mv = np.einsum("nij,nj->ni", self.m, other.T)  # not orthogonal to s
        self.any_mv = any_mv / np.sqrt(np.einsum("ni,ni->n", other.T, any_mv))[:, None]
        self.mv = mv / np.sqrt(np.einsum("ni,ni->n", v, mv))[:, None]
        self.tape = []

    def f(self):
        return self.square * self.t / (1.0 + self.t)

    def square1(self):  # A
        return np.einsum("ni,nij,nj->n", self.solution, self.p, self.solution)

    def square2(self):  # t²B
        return np.einsum("ni,nij,nj->n", self.solution, self.p2, self.solution) * self.t

    def number(self, x):
        return Rounded(self.tape, x, rounded=False)

    def matrix(self, a):
        return {(i, j): self.number(a[:, i, j]) for i in range(self.d) for j in range(i, self.d)}

    def vector(self, x):
        return [self.number(x[:, i]) for i in range(self.d)]

    def pair(self):
        q2 = self.p2 / self.t[:, None, None]
        return self.vector(self.r), self.matrix(self.p), self.matrix(q2), self.number(self.t)


def quartic(sample):
    """evaluate_quartic(): b, a, form."""
    r, q1, q2, t = sample.pair()
    m = blend(q1, t, q2)
    adj = adjugate(m, sample.d)
    s = product(adj, r)
    return determinant(m, adj, sample.d), dot(r, s), quadratic_form(q2, s), t


def apart(parameters, d):
    """shows_apart(): t a - (1 + t)(b + margin), over (1 + t) P, where f = 1."""
    sample = Sample(parameters, d, Sample.f)
    b, a, _, t = quartic(sample)
    return worst_case((t * a - (t + 1.0) * (b + 0.0)).exactly()) / (1.0 + sample.t)


def inside1(parameters, d):
    """shows_inside1(): a b - t form and b², over a P, where A = 1: a larger r only adds to a."""
    sample = Sample(parameters, d, Sample.square1)
    b, a, form, t = quartic(sample)
    return worst_case(((a * b - t * form) + 0.0 - b * b).exactly()) / (sample.det * sample.square)


def inside2(parameters, d):
    """shows_inside2(): t² form and b², over t a P, where t²B = 1."""
    sample = Sample(parameters, d, Sample.square2)
    b, _a, form, t = quartic(sample)
    return worst_case((t * (t * form + 0.0) - b * b).exactly()) / (sample.t * sample.det * sample.square)


def separation(parameters, d):
    """is_well_conditioned(): a, over a P/d."""
    sample = Sample(parameters, d)
    _, a, _, _ = quartic(sample)
    return worst_case(a) / sample.square


def adjugate_solution(parameters, d):
    """last_evaluation() by the adjugate: the error of s orthogonal to s in the norm of M, over u/d."""
    sample = Sample(parameters, d)
    r, q1, q2, t = sample.pair()
    s = product(adjugate(blend(q1, t, q2), d), r)
    error = total((x * y).exactly() for x, y in zip(sample.vector(sample.mv), s))
    for node in sample.tape[error.index - d + 1 :]:
        node.rounded = False
    return worst_case(error) / np.sqrt(sample.square)


def factorized_solution(parameters, d):
    """last_evaluation() by factorisation: the same, over u condition()."""
    sample = Sample(parameters, d)
    r, q1, q2, t = sample.pair()
    s = solve(factorize(blend(q1, t, q2), d), r)
    error = total((x * y).exactly() for x, y in zip(sample.vector(sample.mv), s))
    for node in sample.tape[error.index - d + 1 :]:
        node.rounded = False
    condition = np.trace(np.linalg.inv(sample.m), axis1=1, axis2=2)
    return worst_case(error) / np.sqrt(sample.square) / condition


def correction(parameters, d):
    """refine(): the error in the norm of M, in all directions, of a correction by factorisation from a rounded residual, relative
    to the error that it corrects, over u condition()."""
    sample = Sample(parameters, d)
    _, q1, q2, t = sample.pair()
    residual = [x + 0.0 for x in sample.vector(sample.r)]
    c = solve(factorize(blend(q1, t, q2), d), residual)
    error = total((x * y).exactly() for x, y in zip(sample.vector(sample.any_mv), c))
    for node in sample.tape[error.index - d + 1 :]:
        node.rounded = False
    condition = np.trace(np.linalg.inv(sample.m), axis1=1, axis2=2)
    return worst_case(error) / np.sqrt(sample.square) / condition


def value(parameters, d):
    """stationary_value() of an exact s: over μ² cond."""
    sample = Sample(parameters, d)
    r, q1, q2, t = sample.pair()
    s = sample.vector(sample.solution)
    complement = t.lift(1.0) / (t + 1.0)
    rs = dot(r, s)
    mu2 = t * complement * rs * (rs / (quadratic_form(q1, s) + t * quadratic_form(q2, s))) + 0.0
    x = np.abs(sample.solution)
    forms = np.einsum("ni,nij,nj->n", x, np.abs(sample.p) + np.abs(sample.p2), x)
    cond = (forms + 2.0 * (x * np.abs(sample.r)).sum(1)) / sample.square
    return worst_case(mu2) / np.abs(mu2.value) / cond


def definite(parameters, d):
    """is_clearly_definite(): the determinant, and that of the pivots of factorize(), which are then positive, over P."""
    sample = Sample(parameters, d)
    a = sample.matrix(sample.m)
    if d == 2:
        by_products = a[0, 0] * a[1, 1] - a[0, 1] * a[0, 1]
    else:
        adj = adjugate(a, d)
        by_products = determinant(a, adj, d)
    errors = worst_case(by_products)
    _, pivots, _ = factorize(sample.matrix(sample.m), d)
    result = pivots[0]
    for pivot in pivots[1:]:
        result = (result * pivot).exactly()
    return errors + worst_case(result)


class Margin:
    """A constant of a header: the dimensions for which it holds, and its smallest admissible value for a worst case."""

    def __init__(self, worst, header, pattern, needed=lambda found: found, dimensions=(2, 3)):
        self.worst, self.header, self.pattern = worst, header, pattern
        self.needed, self.dimensions = needed, dimensions

    def constant(self, include):
        with open(include / "pw85" / self.header, encoding="utf-8") as header:
            return int(re.search(self.pattern + r"\D*?(\d+)", header.read())[1])


# The forms of the margins inside contain a, whose error is 5 %; terms of second order add 1 %. is_certain() admits an error of 2u,
# and a comparison one of u, where cond >= 3.
MARGINS = [
    Margin(apart, "overlap/quartic.hpp", "apart_margin ="),
    Margin(inside1, "overlap/quartic.hpp", "inside1_margin =", lambda found: 1.06 * found),
    Margin(inside2, "overlap/quartic.hpp", "inside2_margin =", lambda found: 1.06 * found),
    Margin(separation, "overlap/quartic.hpp", "least_conditioning =", lambda found: found / 0.05),
    Margin(adjugate_solution, "contact/rational_search.hpp", "adjugate_error ="),
    Margin(factorized_solution, "contact/factorized_search.hpp", "factorization_error ="),
    Margin(correction, "contact/factorized_search.hpp", "correction_error ="),
    Margin(value, "overlap/comparison.hpp", "value_margin =", lambda found: found + 1.0),
    Margin(definite, "algebra/symmetric.hpp", r"definite_margin = D == 2 \?", dimensions=(2,)),
    Margin(definite, "algebra/symmetric.hpp", r"definite_margin = D == 2 \? \d+ :", dimensions=(3,)),
]


def maximise(ratio, d, starts, steps, rng):
    """The largest ratio found. Each step changes some of the parameters by an additive or multiplicative amount of any size. A few
    times the worse half of the samples is replaced by the better half."""
    count = 2 * d * d + 2 * d + 1
    parameters = rng.normal(size=(count, starts)) * 10.0 ** rng.uniform(-2.0, 0.0, size=(count, starts))
    parameters[-1] = rng.uniform(-2.0, 2.0, size=starts)

    def safe(x):
        with np.errstate(all="ignore"):
            try:
                values = ratio(x, d)
            except np.linalg.LinAlgError:
                return np.zeros(starts)
            ok = Sample(x, d).det > 1e-7
        return np.where(ok & np.isfinite(values), values, 0.0)

    best = safe(parameters)
    for step in range(steps):
        size = 10.0 ** rng.uniform(-4.0, 0.0, size=starts)
        where = rng.random((count, starts)) < rng.choice([0.1, 0.3, 1.0])
        noise = size * rng.normal(size=(count, starts)) * where
        trial = parameters * (1.0 + noise) if step % 2 else parameters + noise
        values = safe(trial)
        better = values > best
        parameters[:, better], best[better] = trial[:, better], values[better]
        if step % (steps // 4 + 1) == steps // 4:
            order = np.argsort(best)
            half = starts // 2
            parameters[:, order[:half]] = parameters[:, order[-half:]]
            best[order[:half]] = best[order[-half:]]
    return best.max()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--starts", type=int, default=512)
    parser.add_argument("--steps", type=int, default=4000)
    parser.add_argument("--include", type=pathlib.Path, default=pathlib.Path(__file__).parents[1] / "include")
    arguments = parser.parse_args()
    rng = np.random.default_rng(1)
    failures = 0
    print(f"{'worst case':22}{'D':>4}{'found':>8}{'needed':>8}{'constant':>10}")
    for margin in MARGINS:
        found = max(maximise(margin.worst, d, arguments.starts, arguments.steps, rng) for d in margin.dimensions)
        needed, constant = margin.needed(found), margin.constant(arguments.include)
        tight = needed <= constant <= 4 / 3 * needed
        failures += not tight
        dimensions = ", ".join(map(str, margin.dimensions))
        print(
            f"{margin.worst.__name__:22}{dimensions:>4}{found:8.2f}{needed:8.2f}{constant:10}{'' if tight else '  not tight'}",
            flush=True,
        )
    return failures > 0


if __name__ == "__main__":
    sys.exit(main())
