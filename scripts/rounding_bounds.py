#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Finds the worst cases of rounding errors, by climbing from many random starts at once.

The program tests/bounds/graphs.cpp runs the templates of the library on a scalar that records, and prints every formula that a
margin guards as a graph, rounding by rounding. With z_k(1 + δ_k) for each rounded result, |δ_k| <= u, the error of the result is
Σ δ_k z_k ∂f/∂z_k to first order, which is at most u Σ |z_k ∂f/∂z_k|. One reverse sweep gives this sum. The sum divided by the
form of the margin is maximised over pairs of positive definite forms, separations and t. All formulas are homogeneous in the units
of each axis, so that M = Q1 + t Q2 has a unit diagonal without loss of generality. A fused multiplication and addition removes one
δ_k, so that the sum loses a term: the constants hold with and without fusion. tests/bounds/proofs.cpp proves them.

    rounding_bounds.py GRAPHS [--starts N] [--steps N]

runs the program GRAPHS, and prints the worst cases, the margins that they need, and the constants of the headers. It fails if a
constant is too small, or larger than necessary by more than its proof allows for.
"""

import argparse
import subprocess
import sys

import numpy as np


class Formula:
    """A graph, and the constant of the headers that bounds its errors. A node is its operation, its operands, and whether its
    result is rounded."""

    def __init__(self, constant):
        self.constant, self.nodes, self.results = int(constant), [], []

    def values(self, inputs):
        """The value of each node, from those of the inputs by name."""
        values = []
        for operation, operands, _ in self.nodes:
            values.append(evaluate(operation, [values[k] for k in operands] if operation in SLOPES else operands, inputs))
        return values

    def worst_case(self, inputs, weights):
        """Σ |z_k ∂(Σ weights·results)/∂z_k|, in units of u."""
        values = self.values(inputs)
        adjoints = [0.0] * len(values)
        for result, weight in zip(self.results, weights):
            adjoints[result] = adjoints[result] + weight
        errors = 0.0
        for k in reversed(range(len(values))):
            operation, operands, rounded = self.nodes[k]
            if rounded:
                errors = errors + np.abs(adjoints[k] * values[k])
            if operation in SLOPES:
                slopes = SLOPES[operation](values[k], *(values[i] for i in operands))
                for i, slope in zip(operands, slopes):
                    adjoints[i] = adjoints[i] + adjoints[k] * slope
        return errors


# The derivatives of a result with respect to its operands.
SLOPES = {
    "+": lambda z, x, y: (1.0, 1.0),
    "-": lambda z, x, y: (1.0, -1.0),
    "*": lambda z, x, y: (y, x),
    "/": lambda z, x, y: (1.0 / y, -z / y),
    "negation": lambda z, x: (-1.0,),
}


def evaluate(operation, operands, inputs):
    match operation:
        case "input":
            return inputs[operands]
        case "constant":
            return operands
        case "+":
            return operands[0] + operands[1]
        case "-":
            return operands[0] - operands[1]
        case "*":
            return operands[0] * operands[1]
        case "/":
            return operands[0] / operands[1]
    return -operands[0]


def parse_node(words):
    match words:
        case ["input", name]:
            return "input", name, False
        case ["constant", x]:
            return "constant", float(x), False
        case ["negation", x]:
            return "negation", (int(x),), False
    operation, x, y, mark = words
    return operation, (int(x), int(y)), mark == "rounded"


def read_formulas(program):
    """The formulas by name and dimensions."""
    formulas = {}
    for line in subprocess.run([program], check=True, capture_output=True, text=True).stdout.splitlines():
        first, *rest = line.split()
        if first == "=":
            name, dimensions, constant = rest
            formula = formulas[name, int(dimensions)] = Formula(constant)
        elif first == ">":
            formula.results = [int(k) for k in rest]
        else:
            formula.nodes.append(parse_node([first, *rest]))
    return formulas


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

    def f(self):
        return self.square * self.t / (1.0 + self.t)

    def square1(self):  # A
        return np.einsum("ni,nij,nj->n", self.solution, self.p, self.solution)

    def square2(self):  # t²B
        return np.einsum("ni,nij,nj->n", self.solution, self.p2, self.solution) * self.t

    def condition(self):  # κ
        return np.trace(np.linalg.inv(self.m), axis1=1, axis2=2)

    def inputs(self):
        """The pair, by the names of formulas.hpp."""
        q2 = self.p2 / self.t[:, None, None]
        numbers = {"t": self.t, "ratio": 1.0}
        for i in range(self.d):
            numbers[f"r{i}"], numbers[f"s{i}"], numbers[f"rest{i}"] = self.r[:, i], self.solution[:, i], 0.0
            for j in range(i, self.d):
                for name, matrix in ("q1", self.p), ("q2", q2), ("m", self.m):
                    numbers[f"{name}{i}{j}"] = matrix[:, i, j]
        return numbers


# The worst cases, each over the form of its margin.


def apart(formula, parameters, d):
    """shows_apart(): t a - (1 + t)(b + margin), over (1 + t) P, where f = 1."""
    sample = Sample(parameters, d, Sample.f)
    return formula.worst_case(sample.inputs(), [1.0]) / (1.0 + sample.t)


def inside1(formula, parameters, d):
    """shows_inside1(): a b - t form and b², over a P, where A = 1: a larger r only adds to a."""
    sample = Sample(parameters, d, Sample.square1)
    return formula.worst_case(sample.inputs(), [1.0]) / (sample.det * sample.square)


def inside2(formula, parameters, d):
    """shows_inside2(): t² form and b², over t a P, where t²B = 1."""
    sample = Sample(parameters, d, Sample.square2)
    return formula.worst_case(sample.inputs(), [1.0]) / (sample.t * sample.det * sample.square)


def separation(formula, parameters, d):
    """is_well_conditioned(): a, over a P/d."""
    sample = Sample(parameters, d)
    return formula.worst_case(sample.inputs(), [1.0]) / sample.square


def adjugate_solution(formula, parameters, d):
    """last_evaluation() by the adjugate: the error of s orthogonal to s in the norm of M, over u/d."""
    sample = Sample(parameters, d)
    return formula.worst_case(sample.inputs(), sample.mv.T) / np.sqrt(sample.square)


def factorized_solution(formula, parameters, d):
    """last_evaluation() by factorisation: the same, over u condition()."""
    sample = Sample(parameters, d)
    return formula.worst_case(sample.inputs(), sample.mv.T) / np.sqrt(sample.square) / sample.condition()


def correction(formula, parameters, d):
    """refine(): the error in the norm of M, in all directions, of a correction by factorisation from a rounded residual, relative
    to the error that it corrects, over u condition()."""
    sample = Sample(parameters, d)
    return formula.worst_case(sample.inputs(), sample.any_mv.T) / np.sqrt(sample.square) / sample.condition()


def value(formula, parameters, d):
    """stationary_value() of an exact s at the maximum, where the last step is 0: over μ² cond."""
    sample = Sample(parameters, d)
    inputs = sample.inputs() | {"k": 1.0, "k2": 0.0, "ratio": np.sqrt(sample.square1() / sample.square2())}
    x = np.abs(sample.solution)
    forms = np.einsum("ni,nij,nj->n", x, np.abs(sample.p) + np.abs(sample.p2), x)
    cond = (forms + 2.0 * (x * np.abs(sample.r)).sum(1)) / sample.square
    mu2 = formula.values(inputs)[formula.results[0]]
    return formula.worst_case(inputs, [1.0]) / mu2 / cond


def definite(formula, parameters, d):
    """is_clearly_definite(): the determinant, over P."""
    return formula.worst_case(Sample(parameters, d).inputs(), [1.0])


def pivots(formula, parameters, d):
    """The product of the pivots of factorize(), over P."""
    inputs = Sample(parameters, d).inputs()
    values = formula.values(inputs)
    found = np.array([values[k] for k in formula.results])
    return formula.worst_case(inputs, found.prod(0) / found)


class Margin:
    """A constant of the headers: what it bounds, its smallest admissible value for a worst case, and how many times larger it may
    be."""

    def __init__(self, *worst, needed=lambda found: found, dimensions=(2, 3), excess=4 / 3):
        self.worst, self.needed, self.dimensions, self.excess = worst, needed, dimensions, excess

    def find(self, formulas, d, arguments, rng):
        """The largest sum of the worst cases that is found, and the constant."""
        own = [formulas[worst.__name__, d] for worst in self.worst]

        def ratio(parameters):
            return sum(worst(formula, parameters, d) for worst, formula in zip(self.worst, own))

        return maximise(ratio, d, arguments.starts, arguments.steps, rng), own[0].constant


# The forms of the margins inside contain a, whose error is 5 %; terms of second order add 1 % at least. is_certified() admits an
# error of 2u, and a comparison one of u, where cond >= 3. The theorem on factorisation counts roundings that the worst case shares.
MARGINS = [
    Margin(apart),
    Margin(inside1, needed=lambda found: 1.06 * found, excess=1.4),
    Margin(inside2, needed=lambda found: 1.06 * found),
    Margin(separation, needed=lambda found: found / 0.05),
    Margin(adjugate_solution),
    Margin(factorized_solution, excess=2.8),
    Margin(correction, excess=1.5),
    Margin(value, needed=lambda found: found + 1.0),
    Margin(definite, pivots, dimensions=(2,)),
    Margin(definite, pivots, dimensions=(3,)),
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
                values = ratio(x)
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
    parser.add_argument("graphs")
    parser.add_argument("--starts", type=int, default=512)
    parser.add_argument("--steps", type=int, default=4000)
    arguments = parser.parse_args()
    formulas, rng = read_formulas(arguments.graphs), np.random.default_rng(1)
    failures = 0
    print(f"{'worst case':22}{'D':>4}{'found':>8}{'needed':>8}{'constant':>10}")
    for margin in MARGINS:
        results = [margin.find(formulas, d, arguments, rng) for d in margin.dimensions]
        found, constant = max(found for found, _ in results), results[0][1]
        needed = margin.needed(found)
        tight = needed <= constant <= margin.excess * needed
        failures += not tight
        name, dimensions = margin.worst[0].__name__, ", ".join(map(str, margin.dimensions))
        print(f"{name:22}{dimensions:>4}{found:8.2f}{needed:8.2f}{constant:10}{'' if tight else '  not tight'}", flush=True)
    return failures > 0


if __name__ == "__main__":
    sys.exit(main())
