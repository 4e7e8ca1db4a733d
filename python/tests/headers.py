# SPDX-License-Identifier: BSD-3-Clause
"""Tables whose columns are renamed, dropped, added and put in another order by chance, beside what their full description says."""

import warnings

import numpy as np

import pypw85

# Names of each column of a full description: all say the same, to one who knows it
POSITIONS = [("x", "y", "z"), ("X", "Y", "Z"), ("pos_x", "pos_y", "pos_z"), ("Centroid.X", "Centroid.Y", "Centroid.Z"),
             ("cx", "cy", "cz"), ("p_x", "p_y", "p_z")]  # fmt: skip
LENGTHS = [("a", "b", "c"), ("r1", "r2", "r3"), ("radius_x", "radius_y", "radius_z"), ("semi_axis_1", "semi_axis_2", "semi_axis_3"),
           ("radii_0", "radii_1", "radii_2"), ("rx", "ry", "rz"), ("Elli.R1", "Elli.R2", "Elli.R3")]  # fmt: skip
TURNS = {
    "quaternion": [("qw", "qx", "qy", "qz"), ("quatw", "quati", "quatj", "quatk"), ("Orientation.W", "Orientation.X", "Orientation.Y",
                                                                                  "Orientation.Z")],
    "euler": [("phi_deg", "theta_deg", "psi_deg"), ("yaw (deg)", "pitch (deg)", "roll (deg)"), ("phi [degrees]", "theta [degrees]",
              "psi [degrees]"), ("Elli.Azim", "Elli.Elev", "Elli.Roll"), ("azim_deg", "elev_deg", "roll_deg"), ("alpha", "beta", "gamma")],
    "direction": [("ux", "uy", "uz"), ("nx", "ny", "nz"), ("director_x", "director_y", "director_z"), ("axis_x", "axis_y", "axis_z"),
                  ("dirx", "diry", "dirz")],
    "polar": [("theta_deg", "phi_deg"), ("polar_deg", "azimuth_deg"), ("inclination", "azimuth")],
    "angle": [("angle_deg",), ("theta_deg",), ("Angle",), ("orientation",)],
}  # fmt: skip
HARMLESS = ["label", "Volume", "mass", "vx", "density", "temperature", "charge", "iteration"]
HARMFUL = ["tilt", "aspect_ratio", "blockiness1", "angle", "theta", "orientation", "shape_factor", "length", "diameter", "roll", "phi",
           "quat", "heading", "dip", "exponent", "rot_z", "w", "ez", "axis_ratio", "depth"]  # fmt: skip
# What one who knows the description says: options by which a table may be read
OPTIONS = {"euler": [{}, {"euler": "ZYX", "angle": "degrees"}, {"euler": "ZYX"}], "angle": [{}, {"angle": "degrees"}], "polar": [{}],
           "quaternion": [{}], "direction": [{}]}  # fmt: skip


class Trial:
    """A table of two ellipsoids, and their forms."""

    def __init__(self, seed):
        rng = np.random.default_rng(seed)
        self.kind = str(rng.choice(list(TURNS)))
        self.rng, self.is_flat = rng, self.kind == "angle"
        count = 2 if self.is_flat else 3
        scale = 2.0 ** rng.integers(-40, 40)
        self.axes = rng.uniform(1, 3, (2, count)) * scale
        if self.kind in ("direction", "polar"):
            self.axes[:, 1] = self.axes[:, 0]
        self.centers = np.round(rng.uniform(-9, 9, (2, count)), 3) * scale
        turns, self.matrices = zip(*(self._turn() for _ in range(2)))
        columns = self._names(POSITIONS, count) + self._names(LENGTHS, count) + self._names(TURNS[self.kind], None)
        self.table = dict(zip(columns, np.hstack([self.centers, self.axes, np.array(turns)]).T.tolist()))
        self.dropped = self.added = 0
        self.options = dict(OPTIONS[self.kind][rng.integers(len(OPTIONS[self.kind]))])
        self.count = count
        self._change(columns)
        self._say_units(columns)

    def _names(self, ways, count):
        return list(ways[self.rng.integers(len(ways))][:count])

    def _say_units(self, columns):
        """Adds units in brackets to the names of positions and lengths: one, or two that differ, which makes them other numbers."""
        if self.rng.random() < 0.7:
            return
        one, other = self.rng.choice(["mm", "um", "px"], 2, replace=False)
        is_mixed, style = self.rng.random() < 0.5, str(self.rng.choice(["{} ({})", "{} [{}]", "{}({})"]))
        positions = [name for name in columns[: self.count] if name in self.table]
        lengths = [name for name in columns[self.count : 2 * self.count] if name in self.table]
        names = {name: style.format(name, one) for name in positions}
        names |= {name: style.format(name, other if is_mixed else one) for name in lengths}
        self.table = {names.get(name, name): values for name, values in self.table.items()}
        if is_mixed and positions and lengths:
            self.axes = self.axes * 1000.0  # in the unit of the positions, about

    def _change(self, columns):
        """Drops columns or adds some, and changes the order."""
        essential = columns[self.count :]
        if self.rng.random() < 0.1:  # several, of all
            self.dropped = int(self.rng.integers(1, 4))
            for name in self.rng.choice(columns, self.dropped, replace=False):
                self.table.pop(str(name))
        elif self.rng.random() < 0.4:
            name = str(self.rng.choice(essential))
            # Without c, a and b with a direction describe a spheroid by themselves.
            self.dropped = int(name != "c" or self.kind not in ("direction", "polar"))
            if self.dropped:
                self.table.pop(name)
        for name in self.rng.choice(HARMLESS, self.rng.integers(3), replace=False):
            self.table.setdefault(str(name), [1.0, 2.0])
        if self.rng.random() < 0.4:
            name = str(self.rng.choice(HARMFUL))
            while self.kind == "angle" and self.dropped and name in ("angle", "theta", "orientation", "phi"):
                name = str(self.rng.choice(HARMFUL))  # which would be the angle in place of the one that was dropped
            self.added = int(name not in self.table)
            self.table.setdefault(name, self.rng.uniform(1, 2, 2).tolist())
        names = list(self.table)
        self.rng.shuffle(names)
        self.table = {name: self.table[name] for name in names}

    def _turn(self):
        rng = self.rng
        if self.kind == "quaternion":
            q = rng.normal(size=4)
            q /= np.linalg.norm(q)
            w, v = q[0], q[1:]
            cross = np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])
            return q, np.eye(3) + 2 * w * cross + 2 * cross @ cross
        if self.kind == "euler":
            degrees = rng.uniform(-90, 90, 3)
            return degrees, _about(2, degrees[0]) @ _about(1, degrees[1]) @ _about(0, degrees[2])
        if self.kind == "angle":
            degrees = rng.uniform(-90, 90)
            return [degrees], _about(2, degrees)
        polar, azimuth = rng.uniform(0, 180), rng.uniform(0, 360)
        matrix = _about(2, azimuth) @ _about(1, polar)
        return (matrix[:, 2] * rng.uniform(0.5, 2) if self.kind == "direction" else [polar, azimuth]), matrix

    def text(self):
        rows = [",".join(f"{values[k]:.17g}" for values in self.table.values()) for k in range(2)]
        return "\n".join([",".join(self.table), *rows]) + "\n"

    def forms(self):
        axes = np.hstack([self.axes, self.axes.min(axis=1, keepdims=True)]) if self.is_flat else self.axes
        q = [matrix @ np.diag(one**2) @ matrix.T for one, matrix in zip(axes, self.matrices)]
        return np.array(q)

    def is_refused(self, path):
        path.write_text(self.text())
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                pypw85.read(path, **self.options)
        except pypw85.FileError:
            return True
        return False

    def misread(self, path):
        """What is wrong: "" if the table is read as described, or refused with a sentence that says what to do."""
        path.write_text(self.text())
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                system = pypw85.read(path, **self.options)
        except pypw85.FileError as error:
            return "" if ":" in str(error).removeprefix(str(path)) else f"no remedy: {error}"
        wanted, k = self.forms(), 2 if self.is_flat else 3
        if len(system) == 2 and np.abs(system.centers[:, :k] - self.centers).max() > 1e-12 * np.abs(self.centers).max():
            return f"read at other places ({system.source}), options {self.options}:\n{self.text()}"
        found = np.zeros((len(system), 3, 3))
        upper = np.triu_indices(3)
        found[:, upper[0], upper[1]] = found[:, upper[1], upper[0]] = system.q
        scale = np.abs(wanted).max()
        if len(system) != 2 or np.abs(found[:, :k, :k] - wanted[:, :k, :k]).max() > 1e-12 * scale:
            return f"read as other ellipsoids ({system.source}), options {self.options}:\n{self.text()}"
        return ""


def _about(axis, degrees):
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    matrix = np.eye(3)
    i, j = (axis + 1) % 3, (axis + 2) % 3
    matrix[i, i], matrix[j, j], matrix[i, j], matrix[j, i] = c, c, -s, s
    return matrix
