"""Which splats of a scene of 3D Gaussian splatting a camera sees: exactly, by their centres, and by bounding spheres.

Usage: cull_splats.py [--times] [FILE.ply or number of random splats]
"""

import sys
import tempfile
from pathlib import Path
from time import perf_counter

import numpy as np
import pypw85

PROPERTIES = ["x", "y", "z", *(f"scale_{k}" for k in range(3)), *(f"rot_{k}" for k in range(4))]
CONFIDENCE, QUANTILE = 0.99, 11.344866730144373  # of the χ² distribution with three degrees of freedom


def write_splats(path, positions, semi_axes, quaternions):
    """Writes a PLY file. Scales are logarithms of standard deviations; quaternions begin with their real parts."""
    columns = np.hstack([positions, np.log(semi_axes), quaternions])
    names = "".join(f"property float {name}\n" for name in PROPERTIES)
    head = f"ply\nformat binary_little_endian 1.0\nelement vertex {len(columns)}\n{names}end_header\n"
    Path(path).write_bytes(head.encode() + columns.astype("<f4").tobytes())


def read_splats(path):
    """Reads positions, standard deviations and quaternions. The vertices come first in the file, and may have other properties."""
    types = {"char": "i1", "uchar": "u1", "short": "<i2", "ushort": "<u2", "int": "<i4", "uint": "<u4",
             "float": "<f4", "float32": "<f4", "double": "<f8", "float64": "<f8"}  # fmt: skip
    data = Path(path).read_bytes()
    head, mark, body = data.partition(b"end_header\n")
    lines = [line.split() for line in head.decode("ascii").splitlines()]
    if not mark or ["format", "binary_little_endian", "1.0"] not in lines:
        raise ValueError(f"{path} is no binary PLY file")
    elements = [k for k, line in enumerate(lines) if line[:1] == ["element"]]
    if not elements or lines[elements[0]][1] != "vertex":
        raise ValueError(f"{path} does not begin with vertices")
    first, end = elements[0], [*elements[1:], len(lines)][0]
    row = np.dtype([(name, types[kind]) for word, kind, name in lines[first + 1 : end] if word == "property"])
    vertices = np.frombuffer(body, row, int(lines[first][2]))
    columns = np.stack([vertices[name].astype(float) for name in PROPERTIES], axis=1)
    return columns[:, :3], np.exp(columns[:, 3:6]), columns[:, 6:]


def random_splats(count):
    """Small, flat or long splats in a cube around the camera."""
    random = np.random.default_rng(1)
    positions = random.uniform(-20, 20, size=(count, 3))
    return positions, np.exp(random.normal(-2, 1, size=(count, 3))), random.normal(size=(count, 4))


def frustum(eye, forward, up, height, aspect, near, far):
    """The six planes of what a camera sees: normals and offsets. The height is the tangent of half of the angle of view."""
    forward = forward / np.linalg.norm(forward)
    right = np.cross(forward, up)
    right /= np.linalg.norm(right)
    up = np.cross(right, forward)
    sides = [side - extent * forward for axis, extent in ((right, aspect * height), (up, height)) for side in (axis, -axis)]
    normals = np.array([*sides, -forward, forward])
    return normals, normals @ eye + [0, 0, 0, 0, -near, far]


def are_seen_by_spheres(centers, semi_axes, normals, offsets):
    """Whether no plane has a bounding sphere outside."""
    lengths = np.linalg.norm(normals, axis=1)
    return ((centers @ normals.T - offsets) / lengths < semi_axes.max(axis=1)[:, np.newaxis]).all(axis=1)


def timed(function, *arguments):
    start = perf_counter()
    return function(*arguments), perf_counter() - start


arguments = [argument for argument in sys.argv[1:] if argument != "--times"]
source = arguments[0] if arguments else "10000"
if source.isdigit():
    with tempfile.TemporaryDirectory() as folder:
        write_splats(f"{folder}/splats.ply", *random_splats(int(source)))
        centers, deviations, quaternions = read_splats(f"{folder}/splats.ply")
else:
    centers, deviations, quaternions = read_splats(source)

# A splat is the ellipsoid that has the share CONFIDENCE of its Gaussian.
semi_axes = np.sqrt(QUANTILE) * deviations
eye, forward, upward = np.zeros(3), np.array([1.0, 2, 0.5]), np.array([0.0, 0, 1])
planes = frustum(eye, forward, upward, 0.5, 16 / 9, 0.1, 15.0)
q, of_forms = timed(pypw85.ellipsoid_quaternion, semi_axes, quaternions)
exact, of_exact = timed(pypw85.overlap_polytope, centers, q, *planes)
by_centers, of_centers = timed(lambda: (centers @ planes[0].T <= planes[1]).all(axis=1))
by_spheres, of_spheres = timed(are_seen_by_spheres, centers, semi_axes, *planes)

print(f"{len(q)} splats at {CONFIDENCE:.0%}, of which the camera sees")
for name, seen, time in (
    ("exactly", exact, of_exact),
    ("by centres", by_centers, of_centers),
    ("by bounding spheres", by_spheres, of_spheres),
):
    line = f"{name:20} {seen.sum():7} {(exact & ~seen).sum():7} missing {(seen & ~exact).sum():7} too many"
    print(line + (f" {1e3 * time:5.0f} ms" if "--times" in sys.argv else ""))
if "--times" in sys.argv:
    print(f"forms of the splats: {1e3 * of_forms:.0f} ms")
