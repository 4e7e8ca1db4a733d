"""Whether docs/other_programs.toml is complete, its true numbers are right, and its scripts run the versions that it names.

Usage: check_other_programs.py SOURCE, with pypw85 in the path
"""

import math
import os
import re
import string
import sys
import tomllib
from pathlib import Path

import pypw85

SOURCE = Path(sys.argv[1])
FINDINGS = SOURCE / "findings"
KINDS = {"engine", "simulation", "viewer", "analysis"}
STATEMENTS = {"lengths", "scale", "quaternion", "mass", "margin", "depth", "tolerance", "wrong"}
KEYS = {"name", "kind", "packages", "script", "established"} | STATEMENTS
AXES = (1, 2, 3)


def form(*axes):
    return pypw85.ellipsoid_quaternion(axes, [1, 0, 0, 0])


def shell(a, c):
    """The largest moment of a thin sheet on the spheroid (a, a, c), divided by its mass, by the midpoint rule in the polar angle. Its
    error is of the order of 1/steps² of the number."""
    area = about_x = about_z = 0
    steps = 20000
    for i in range(steps):
        t = math.pi * (i + 0.5) / steps
        r, z = a * math.sin(t), c * math.cos(t)
        strip = r * math.hypot(a * math.cos(t), c * math.sin(t))
        area += strip
        about_x += strip * (r * r / 2 + z * z)
        about_z += strip * r * r
    return max(about_x, about_z) / area


def half_normal():
    """The radius within which half of a normal distribution in space is, by bisection of its closed distribution."""
    low, high = 0, 4
    while high - low > 1e-9:
        r = (low + high) / 2
        inside = math.erf(r / math.sqrt(2)) - math.sqrt(2 / math.pi) * r * math.exp(-r * r / 2)
        low, high = (r, high) if inside < 0.5 else (low, r)
    return low


def depth(x):
    return -float(pypw85.signed_distance([x, 0, 0], form(*AXES), form(*AXES))[0])


def moments(factor):
    """(b² + c²) times a factor, and so on: 1/5 for the ellipsoid, 1/3 for the box around it."""
    a, b, c = AXES
    return [factor * (b * b + c * c), factor * (a * a + c * c), factor * (a * a + b * b)]


TRUTHS = {
    "volume": lambda: float(pypw85.volume(form(*AXES))),
    "moments": lambda: moments(1 / 5),
    "box_moments": lambda: moments(1 / 3),
    "support": lambda: math.sqrt(sum(a * a for a in AXES) / 3),
    "nearest_inside": lambda: -float(pypw85.distance_point([0, 0.5, 0.5], form(*AXES))[0]),
    "nearest_axis": lambda: -float(pypw85.distance_point([0, 0, 1], form(*AXES))[0]),
    "half_depth": lambda: depth(1),
    "tenth_depth": lambda: depth(1.9),
    "mesh_ratio": lambda: math.sqrt(3 / 5),
    "disc_shell": lambda: shell(1, 0.01),
    "needle_shell": lambda: shell(0.01, 1),
    "half_normal": half_normal,
    "normal_95": lambda: math.sqrt(-2 * math.log(0.05)),
}


def wrong_truths(truths):
    """Numbers that are not the true ones, rounded to as many decimals as they have, and names without a computation."""
    yield from (f"the truths are not those that are computed: {name}" for name in truths.keys() ^ TRUTHS.keys())
    for name in truths.keys() & TRUTHS.keys():
        stated, computed = truths[name]["value"], TRUTHS[name]()
        pairs = zip(stated, computed, strict=True) if isinstance(stated, list) else [(stated, computed)]
        for number, true in pairs:
            decimals = len(str(number).partition(".")[2])
            if not abs(number - true) <= 0.5000001 * 10**-decimals:
                yield f"{name} is stated as {number}, and computed as {true!r}"


def wrong_keys(program):
    name = program.get("name", "a program without a name")
    yield from (f"{name}: unknown key {key}" for key in program.keys() - KEYS)
    yield from (f"{name}: no {key}" for key in ("name", "kind", "packages") if not program.get(key))
    if program.get("kind") not in KINDS:
        yield f"{name}: kind must be one of {sorted(KINDS)}, not {program.get('kind')!r}"
    if not STATEMENTS & program.keys():
        yield f"{name}: says nothing"
    if ("script" in program) == ("established" in program):
        yield f"{name}: needs either a script or what was run"
    for key in STATEMENTS & program.keys():
        if not program[key].endswith(".") and key != "quaternion":
            yield f"{name}: {key} does not end with a full stop"


def wrong_references(program, truths):
    """Placeholders without a truth, scripts that are not there or run another version."""
    for key in STATEMENTS & program.keys():
        for _, field, _, _ in string.Formatter().parse(program[key]):
            if field is not None and field not in truths:
                yield f"{program['name']}: {key} refers to {field!r}, which is no truth"
    for package in program["packages"]:
        if not re.fullmatch(r"(@?[^@=]+)[@=]\d\S*", package):
            yield f"{program['name']}: {package!r} has no version"
    if "script" in program:
        yield from wrong_script(program)


def wrong_script(program):
    path = FINDINGS / f"{program['script']}.sh"
    if not os.access(path, os.X_OK):
        yield f"{program['name']}: {path} is not an executable file"
        return
    text = path.read_text(encoding="utf-8")
    version = re.search(r"^version=(\S+)$", text, re.MULTILINE)
    text = text.replace("$version", version[1]) if version else text
    yield from (f"{path.name} does not run {package}" for package in program["packages"] if package not in text)


def main():
    data = tomllib.loads((SOURCE / "docs" / "other_programs.toml").read_text(encoding="utf-8"))
    programs, truths = data["program"], data["truths"]
    found = list(wrong_truths(truths))
    for program in programs:
        found += [*wrong_keys(program), *wrong_references(program, truths)]
    names = [program["name"] for program in programs]
    found += [f"{name} is there twice" for name in names if names.count(name) > 1]
    print("\n".join(found) or f"{len(programs)} programs, {len(truths)} true numbers")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
