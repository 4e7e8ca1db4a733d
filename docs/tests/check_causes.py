"""Whether the functions of pw85.h return the statuses of their causes, and whether contracts name just these causes.

Each function is called with valid arguments, and with each of them spoiled as api/causes.py says: it must return the status of the
cause where its contract names the cause, and success where it does not. Usage: check_causes.py LIBRARY
"""

import ctypes
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "api"))
from causes import CAUSES
from declarations import functions_with_status
from parameters import OBJECTS
from public_headers import ONE_ROW
from statuses import status_codes

STATUSES = {name: int(value) for name, _, value, _ in status_codes()}
ROWS = 2
SPHERE, CIRCLE = [1.0, 0, 0, 1, 0, 1], [1.0, 0, 1]
HUGE = 2**64 - 1

# One row of each input; what is not here is 1.
VALID = {
    **dict.fromkeys(("q", "q1", "q2", "second_moments"), SPHERE),
    **dict.fromkeys(("r12", "r", "d_r12", "d_rot1", "d_rot2"), (3.0, 2, 1)),
    **dict.fromkeys(("direction", "directions", "start", "starts", "normal", "normals", "axis"), (0.0, 0, 1)),
    **dict.fromkeys(("motion1", "motion2", "motions"), (0.0,) * 7),
    **dict.fromkeys(("quaternion", "quaternions"), (1.0, 0, 0, 0)),
    **dict.fromkeys(
        ("n", "num_pairs", "num_particles", "num_ellipsoids", "num_planes", "num_points", "num_vertices", "num_triangles"), ROWS
    ),
    "m": 6,
    "points": [[1.0, 0], [-1, 0], [0, 1], [0, -1], [1, 1], [0.5, 0.25]],
    "kind": 1,
    "on": 1,
    "shell": 1,
    "surface": 0,
    "seed": 1,
    **dict.fromkeys(("velocity", "velocities"), (0.5, 0, 1)),
    "num_parameters": 2,
    "parameters": [1.0, 2.0],
    "semi_axes": [3.0, 2, 1],
    "curvature": 0.5,
    "curvatures": [1.0, 2.0],
    **dict.fromkeys(("rotation", "s1", "s2"), np.eye(3).ravel()),
    "lambda": 0.5,
    "offset": 5.0,
    "lower": [-9.0] * 3,
    "upper": [9.0] * 3,
    "radius": 99.0,
    "center": [8.0, 8, 8],
    "centers": [[0.0, 0, 0], [3, 2, 1]],
    "origin": [-5.0, 0, 0],
    **dict.fromkeys(("end1", "vertex1"), (3.0, 2, 1)),
    **dict.fromkeys(("end2", "vertex2"), (3.0, -2, 1)),
    "vertex3": (3.0, 0, 4),
    "vertices": (3.0, 2, 1),
    "triangles": np.array([[0, 1, 0], [1, 0, 1]], dtype=np.int32),
    "pairs": np.array([[0, 1], [1, 0]], dtype=np.int32),
    "indices": np.array([0, 1], dtype=np.int32),
    "images": None,
    "cell": np.diag([20.0, 20, 20]),
}
# Functions without objects that keep no record.
SILENT = ("pw85_neighbors_check",)
# The overlap of concentric grains has no minimum.
NO_MINIMUM = ("pw85_grain_contact", "pw85_grain_radius_gradient", "pw85_grain_contact_batch", "pw85_grain_radius_gradient_batch")
PLANE = {
    **dict.fromkeys(("q", "q1", "q2", "second_moments"), CIRCLE), **dict.fromkeys(("direction", "directions"), (0.0, 1)), "r12": [3.0, 2],
    "lower": [-9.0] * 2, "upper": [9.0] * 2, "r": [3.0, 2], "end1": [3.0, 2], "end2": [3.0, -2],
}  # fmt: skip


# Those of one function.
OWN = {"pw85_enclosing_ellipsoid_of": {"m": ROWS, "centers": [[0.0, 0], [3, 1]], "forms": CIRCLE}}


class Parameter:
    def __init__(self, one, function):
        self.declared = one
        self.name = one.name
        self.is_pointer = one.pointer
        self.is_input = one.const or not self.is_pointer
        self.is_real = one.type in ("double", "pw85_motion")
        self.object = one.type if one.is_handle() and one.const else None
        self.rows = 1 if self.name in ("cell", "rotation") else ROWS
        self.type = ctypes.c_void_p if self.is_pointer else ctypes.c_double if self.is_real else ctypes.c_size_t
        self.values = VALID | (PLANE if function.endswith("_2d") else {}) | OWN.get(function, {})

    def valid(self):
        """A valid argument, with room for all rows; outputs have room for anything."""
        if not self.is_input:
            return np.zeros(1024)
        value = self.values.get(self.name, 1.0)
        if not self.is_pointer or value is None:
            return value
        return np.array(value if np.ndim(value) > 1 else np.tile(value, (self.rows, 1)))

    def columns(self):
        return self.valid().size // self.rows

    def with_entry(self, entry, value):
        array = self.valid()
        array.reshape(-1)[entry] = value
        return array


def spoiled_null(p):
    return [None] if p.is_pointer else []


def spoiled_by(value):
    def spoiled(p):
        if not (p.is_input and p.is_real):
            return []
        return [p.with_entry(i, value) for i in range(p.columns())] if p.is_pointer else [value]

    return spoiled


def of_rows(p, *rows):
    return [np.tile(row, (ROWS, 1)) for row in rows]


def of_numbers(p, *numbers):
    return [np.full(ROWS, number) for number in numbers] if p.is_pointer else list(numbers)


def spoiled_index(p):
    return [p.with_entry(i, value) for i in (0, 1) for value in (-1, ROWS, 2**31 - 1)]


SPOILED = {
    "null": spoiled_null,
    "NaN": spoiled_by(np.nan),
    "infinity": spoiled_by(np.inf),
    "not definite": lambda p: of_rows(p, *np.eye(len(p.valid()[0]))[[0, -1]], -p.valid()[0], 0 * p.valid()[0]),
    "not positive": lambda p: [p.with_entry(0, 0.0), p.with_entry(p.columns() - 1, -1.0)] if p.is_pointer else [0.0, -1.0],
    "negative": lambda p: of_numbers(p, -1.0),
    "no rotation": lambda p: [1.00001 * p.valid(), 0 * p.valid()],
    "zero": lambda p: [0 * p.valid()],
    "concentric": lambda p: [0 * p.valid()],
    "lambda": lambda p: of_numbers(p, -0.001, 1.001),
    "empty box": lambda p: [p.with_entry(0, 9.5)],
    "shrinks": lambda p: [p.with_entry(6, -2.0)],
    "index": spoiled_index,
    "size": lambda p: [HUGE],
    "range": lambda p: [1e200 * p.valid(), 1e-200 * p.valid()],
    "far": lambda p: [p.with_entry(0, 1e300)],
    "dimension": lambda p: [0, 17, HUGE],
    "singular": lambda p: [0 * p.valid(), np.ones((3, 3))],
}


class PairList(ctypes.Structure):
    _fields_ = [("num_pairs", ctypes.c_size_t), ("pairs", ctypes.c_void_p), ("images", ctypes.c_void_p)]


class System(ctypes.Structure):
    _fields_ = [
        ("num_particles", ctypes.c_size_t),
        *((name, ctypes.c_void_p) for name in ("centers", "q", "cell")),
        ("periodic", ctypes.c_int * 3),
    ]


class Law(ctypes.Structure):
    _fields_ = [("kind", ctypes.c_int), ("num_parameters", ctypes.c_size_t), ("parameters", ctypes.c_void_p)]


STRUCTS = {"pw85_pair_list": PairList, "pw85_system": System, "pw85_law": Law}


class Error(ctypes.Structure):
    _fields_ = [
        ("status", ctypes.c_int),
        *((name, ctypes.c_char_p) for name in ("function", "argument", "requirement")),
        ("row", ctypes.c_size_t),
        ("entry", ctypes.c_size_t),
        ("value", ctypes.c_double),
    ]


class Caller:
    def __init__(self, library):
        self.library = ctypes.CDLL(library)
        self.objects = {name: ctypes.c_void_p() for name in OBJECTS}
        centers, q, cell = np.array(VALID["centers"]), np.tile(SPHERE, (ROWS, 1)), VALID["cell"]
        system = System(ROWS, *(array.ctypes.data for array in (centers, q, cell)), (1, 1, 1))
        self.library.pw85_neighbors_create(
            ctypes.byref(system), ctypes.c_double(1), ctypes.c_double(1), ctypes.byref(self.objects["pw85_neighbors"])
        )
        arrays = np.tile(VALID["vertices"], (ROWS, 1)), VALID["triangles"]
        vertices, triangles = (ctypes.c_void_p(array.ctypes.data) for array in arrays)
        rows = ctypes.c_size_t(ROWS)
        self.library.pw85_mesh_create(rows, vertices, rows, triangles, ctypes.byref(self.objects["pw85_mesh"]))

    def last_error(self):
        """The cause of the last refusal, which is forgotten."""
        error = Error()
        self.library.pw85_last_error(ctypes.byref(error))
        return error

    def status(self, function, changes):
        """The status of a call with valid arguments but for the changes."""
        values, numbers = {}, {}
        for p in parameters(function):
            value = values[p.name] = changes.get(p.name, self.objects[p.object].value if p.object else p.valid())
            numbers[p.name] = p.type(value.ctypes.data if isinstance(value, np.ndarray) else value)
        arguments = []
        for one in function.parameters:
            if not one.is_struct():
                arguments.append(numbers[one.name])
            elif changes.get(one.name, one) is None:
                arguments.append(None)
            else:
                read = {name: numbers[name].value for name in one.member_names() & numbers.keys()}
                struct = STRUCTS[one.type](**read)
                if isinstance(struct, System):
                    struct.periodic[:] = changes.get("periodic", (1, 1, 1))
                arguments.append(ctypes.byref(struct))
        return getattr(self.library, function.name)(*arguments)


def parameters(function):
    return [Parameter(one, function.name) for one in function.flattened]


def changes(cause, p):
    """The arguments that provoke a cause by a parameter."""
    if cause.key == "not periodic":
        return [{"periodic": (0, 0, 0)}]
    if cause.key == "no cell":
        return [{"cell": None, "images": np.zeros((ROWS, 3), dtype=np.int32)}]
    if cause.key == "other list":
        return [{"num_particles": 1}]
    if p.name == "next":
        return [{"next": None, "next_pair": None}]  # the second must be null with the first
    return [{p.name: value} for value in SPOILED[cause.key](p)]


def shown(value):
    return [float(x).hex() for x in np.ravel(value)] if isinstance(value, np.ndarray) else value


def has_record(function):
    """Whether the function records its refusals."""
    is_of_list = function.header == "pw85_systems.h" and not any(one.is_handle() for one in function.parameters)
    return (function.header in (*ONE_ROW, "pw85_batch.h", "pw85_enclosing.h") or is_of_list) and function.name not in SILENT


def is_told(function, cause):
    """Whether pw85_last_error() names the function and its argument: in functions of many rows the causes that are not those of a row."""
    if function.header in ONE_ROW:
        return has_record(function) and cause.key != "size"  # an integer has no attributes
    is_of_cloud = function.header == "pw85_enclosing.h" and cause.key in ("NaN", "infinity", "not positive", "dimension")
    return has_record(function) and (is_of_cloud or cause.key in ("null", "size", "index", "singular", "not periodic"))


def wrong_cause(caller, function, cause, p, change, status):
    """What is wrong about the record of a refusal; nothing if it is right."""
    error = caller.last_error()
    if has_record(function) and error.status != status:
        return f"{function.name}, {cause.key}: pw85_last_error() tells of status {error.status}, not {status}"
    if not is_told(function, cause) or status == STATUSES["PW85_ECONVERGENCE"]:
        return ""
    told = (error.function or b"").decode(), (error.argument or b"").decode()
    name = "periodic" if cause.key == "not periodic" else p.name
    return "" if told == (function.name, name) else f"{function.name}, {cause.key} of {p.name}: pw85_last_error() tells of {told}"


def complaints(caller, function):
    if caller.status(function, {}) != 0:
        yield f"{function.name} returns {caller.status(function, {})} for valid arguments"
    for struct in (one.name for one in function.parameters if one.is_struct()):
        if caller.status(function, {struct: None}) != STATUSES["PW85_EINVAL"]:
            yield f"{function.name}: {caller.status(function, {struct: None})} where {struct} is null"
    for cause in CAUSES:
        for p in parameters(function):
            if not cause.can_have(p.declared):
                continue
            expected = STATUSES[cause.status] if cause.is_named(p.declared) else 0
            if cause.key == "concentric" and function.name in NO_MINIMUM:
                expected = STATUSES["PW85_ECONVERGENCE"]
            if cause.key == "far" and function.name in OWN:  # of extents that are too large
                expected = STATUSES["PW85_EINVAL"]
            for change in changes(cause, p):
                caller.last_error()
                status = caller.status(function, change)
                if status and (wrong := wrong_cause(caller, function, cause, p, change, status)):
                    yield wrong
                if status != expected:
                    values = ", ".join(f"{name} = {shown(value)}" for name, value in change.items())
                    yield f"{function.name}, {cause.key}: {status} instead of {expected} for {values}"


def main():
    caller = Caller(sys.argv[1])
    listed = functions_with_status()
    found = [text for function in listed if not function.is_of_simulations() for text in complaints(caller, function)]
    print("\n".join(found))
    print(f"{len(listed)} functions, {len(found)} complaints")
    return 1 if found or len(listed) < 40 else 0


if __name__ == "__main__":
    sys.exit(main())
