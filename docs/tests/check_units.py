"""Whether the units of numbers are those that the contracts of pw85.h state. Usage: check_units.py LIBRARY

Each function of one row is called with numbers in one unit of length and of time, and in others that are powers of two of these. What
a unit in brackets says must hold bit by bit: no step of the library rounds a power of two. Bodies are general, and apart or not.
"""

import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "api"))
from check_causes import Caller
from check_causes import parameters as prepared
from declarations import ONE_ROW, functions

EXPONENTS = {"length": 6, "time": -3}
POWERS = {"": 1, "²": 2, "³": 3}
BODIES = {
    "q": [4.0, 0.3, -0.2, 2.5, 0.4, 1.7], "q1": [4.0, 0.3, -0.2, 2.5, 0.4, 1.7], "q2": [1.1, -0.2, 0.1, 3.2, 0.7, 2.3],
    "s1": [2.0, 0.1, 0.3, 0.2, 1.5, -0.1, 0.4, 0.2, 0.9], "s2": [0.8, 0.3, -0.2, 0.1, 1.2, 0.3, -0.4, 0.2, 1.9],
    "normal": [0.3, -0.5, 0.9], "direction": [0.6, 0.4, 0.3], "start": [0.6, 0.5, 0.2], "velocity": [-0.6, -0.4, -0.3],
    "motion1": [0.1, 0.2, -0.1, 0.3, 0.2, 0.1, 0.01], "motion2": [-0.5, -0.4, -0.2, 0.2, -0.1, 0.3, 0.02], "mu2": 0.7, "t_max": 5.0,
    "normals": [[0.3, -0.5, 0.9], [0.5, 0.4, 0.3]], "second_moments": [4.0, 0.3, -0.2, 2.5, 0.4, 1.7],
}  # fmt: skip
FLAT = {"q": [4.0, 0.3, 2.5], "q1": [4.0, 0.3, 2.5], "q2": [1.1, -0.2, 3.2], "direction": [0.6, 0.4], "second_moments": [4.0, 0.3, 2.5]}
POSITIONS = {
    "r12": [3.1, 2.2, 1.3], "lower": [1.5, -8.0, -7.0], "origin": [-3.0, -2.0, -1.4], "offsets": [-2.0, -1.0], "offset": 5.3,
    "curvature": 0.3,
}  # fmt: skip


def exponent(unit):
    """The power of two of a number in this unit."""
    numerator, _, denominator = unit.partition("/")
    found = 0
    for sign, part in ((1, numerator), (-1, denominator)):
        name = part.rstrip("²³")
        found += sign * EXPONENTS.get(name, 0) * POWERS[part[len(name) :]]
    return found


def factors(one):
    """The factors of the entries of a parameter; nothing where their units are not known."""
    if one.type == "pw85_motion":  # velocity, angular velocity, growth
        return np.ldexp(1.0, [exponent(unit) for unit in 3 * ["length/time"] + 4 * ["1/time"]])
    return None if one.attributes.unit == "mixed units" else np.ldexp(1.0, exponent(one.attributes.unit.removesuffix("no unit")))


def inputs(function, nearness):
    """Bodies in a general position; those near each other overlap."""
    values = BODIES | POSITIONS | (FLAT if function.name.endswith("_2d") else {})
    values |= {"r12": nearness * np.array(POSITIONS["r12"])[: 2 if function.name.endswith("_2d") else 3], "offset": nearness * 5.3}
    found = {}
    for one, p in zip(function.parameters, prepared(function)):
        if p.is_input and p.is_real:
            value = values.get(one.name, p.valid())
            found[one.name] = np.array(value, dtype=float) if one.pointer else float(value)
    return found


def results(caller, function, given):
    """The status, and the outputs by their names."""
    outputs = {one.name: np.zeros(128) for one in function.parameters if one.is_output()}
    status = caller.status(function, given | outputs)
    return status, outputs


def in_other_units(value, factor):
    """A number, or an array of rows whose entries have one factor or a factor each."""
    scaled = value * (factor if np.ndim(factor) == 0 else np.resize(factor, np.shape(value)))
    return scaled if np.ndim(value) else float(scaled)


def complaints(caller, function, nearness):
    listed = function.parameters
    given = inputs(function, nearness)
    scaled = {one.name: in_other_units(given[one.name], factors(one)) for one in listed if one.name in given}
    (status, found), (other_status, others) = results(caller, function, given), results(caller, function, scaled)
    if status != 0 or other_status != status:
        yield f"{function.name}: the status is {status}, and {other_status} in other units"
        return
    for one in listed:
        if one.name in found and one.type == "double" and factors(one) is not None:
            expected = found[one.name] * factors(one)
            if not np.array_equal(expected, others[one.name], equal_nan=True):
                k = np.flatnonzero(expected != others[one.name])[0]
                yield f"{function.name}, {one.name} [{one.attributes.unit}]: {others[one.name][k].hex()} is not {expected[k].hex()}"


def main():
    caller = Caller(sys.argv[1])
    listed = [one for header in ONE_ROW for one in functions(header) if one.type == "int" and len(one.parameters) > 1]
    found = [text for nearness in (1.0, 0.4) for one in listed for text in complaints(caller, one, nearness)]
    print("\n".join(found))
    print(f"{len(listed)} functions, {len(found)} complaints")
    return 1 if found or len(listed) < 60 else 0


if __name__ == "__main__":
    sys.exit(main())
