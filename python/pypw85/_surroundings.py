# SPDX-License-Identifier: BSD-3-Clause
"""Walls, fields and potentials of simulations."""

from __future__ import annotations

import ctypes
from typing import Any, NamedTuple, SupportsIndex
from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import reals
from ._numbers import integer, real
from ._words import shown
from ._typing import Floats

# No function is in the first page of the memory.
_LEAST_ADDRESS = 4096

Potential = Callable[[int, Floats, Floats, Floats], float]

_DOUBLES = ctypes.POINTER(ctypes.c_double)
_FUNCTION = ctypes.CFUNCTYPE(ctypes.c_double, ctypes.c_void_p, ctypes.c_int32, _DOUBLES, _DOUBLES, _DOUBLES)


def _vector(name: str, value: ArrayLike) -> tuple[float, float, float]:
    array = reals(value, name)
    if array.shape not in ((3,), (2,)):
        raise ValueError(f"the shape of {name} must be (3,), not {array.shape}")
    x, y, z = [*array.tolist(), 0.0][:3]
    return x, y, z


class Wall(NamedTuple):
    """A hard wall of a simulation, for `HardEllipsoids.set_walls`.

    Make walls by `Wall.plane`, `Wall.sphere`, `Wall.cylinder` and `Wall.box`. Lengths are in the unit of the system. For a
    two-dimensional simulation, points and vectors may be given as (x, y).

    Examples
    --------
    A slit between two plates at z = 0 and z = 5:

    >>> import pypw85
    >>> slit = [pypw85.Wall.plane([0, 0, -1], 0), pypw85.Wall.plane([0, 0, 1], 5)]
    >>> one = pypw85.System.from_axes([[0, 0, 2]], [[0.5, 0.5, 1]], [[1, 0, 0, 0]])
    >>> simulation = pypw85.HardEllipsoids(one)
    >>> simulation.set_walls(slit)
    >>> simulation.sweep(1000)
    >>> bool(0 < simulation.centers[0, 2] < 5)
    True
    """

    kind: int
    point: tuple[float, float, float]
    vector: tuple[float, float, float]
    size: float

    @classmethod
    def plane(cls, normal: ArrayLike, offset: float) -> Wall:
        """A wall that fills the half-space normal·x >= offset. Particles are on the other side.

        Parameters
        ----------
        normal : (3,) array_like
            Normal of the surface, pointing into the wall, of any length > 0.
        offset : float
            The distance of the surface from the origin along the normal, multiplied by the length of the normal.

        Returns
        -------
        Wall
        """
        return cls(0, (0.0, 0.0, 0.0), _vector("Wall.plane: normal", normal), real(offset, "Wall.plane: offset"))

    @classmethod
    def sphere(cls, center: ArrayLike, radius: float) -> Wall:
        """A wall that fills everything outside a sphere; in two dimensions, outside a disc. Particles are inside.

        Parameters
        ----------
        center : (3,) array_like
            Centre of the sphere.
        radius : float
            Radius of the sphere, > 0.

        Returns
        -------
        Wall
        """
        return cls(1, _vector("Wall.sphere: center", center), (0.0, 0.0, 0.0), real(radius, "Wall.sphere: radius"))

    @classmethod
    def cylinder(cls, point: ArrayLike, axis: ArrayLike, radius: float) -> Wall:
        """A wall that fills everything outside a cylinder of infinite length. Particles are inside.

        Parameters
        ----------
        point : (3,) array_like
            Any point on the axis of the cylinder.
        axis : (3,) array_like
            Direction of the axis, of any length > 0.
        radius : float
            Radius of the cylinder, > 0.

        Returns
        -------
        Wall
        """
        return cls(2, _vector("Wall.cylinder: point", point), _vector("Wall.cylinder: axis", axis), real(radius, "Wall.cylinder: radius"))

    @classmethod
    def box(cls, lower: ArrayLike, upper: ArrayLike) -> Wall:
        """A wall that fills everything outside a box; in two dimensions, outside a rectangle. Particles are inside.

        Parameters
        ----------
        lower, upper : (3,) array_like
            Corners with the smallest and the largest coordinates. The edges are parallel to x, y and z.

        Returns
        -------
        Wall
        """
        return cls(3, _vector("Wall.box: lower", lower), _vector("Wall.box: upper", upper), 0.0)


class Field(NamedTuple):
    """An external field that acts on each particle of a simulation, for `HardEllipsoids.set_fields`.

    Make fields by `Field.linear`, `Field.weight`, `Field.harmonic` and `Field.aligning`. Energies are in units of k_B T: βU is the energy
    of one particle. For a two-dimensional simulation, points and vectors may be given as (x, y).

    Examples
    --------
    >>> import pypw85
    >>> one = pypw85.System.from_axes([[0, 0, 2]], [[1, 1, 1]], [[1, 0, 0, 0]])
    >>> simulation = pypw85.HardEllipsoids(one)
    >>> trap = pypw85.Field.harmonic([0, 0, 0], [1, 1, 1])
    >>> simulation.set_fields([pypw85.Field.linear([0, 0, 0.5]), trap])
    >>> simulation.energy()  # 0.5 z + z²/2
    3.0
    """

    kind: int
    axis: int
    point: tuple[float, float, float]
    vector: tuple[float, float, float]
    strength: float

    @classmethod
    def linear(cls, gradient: ArrayLike) -> Field:
        """A field with βU = gradient·x, where x is the centre of the particle.

        Parameters
        ----------
        gradient : (3,) array_like
            Gradient of βU, in the inverse unit of length. The force is its negative.

        Returns
        -------
        Field
        """
        return cls(0, 0, (0.0, 0.0, 0.0), _vector("Field.linear: gradient", gradient), 1.0)

    @classmethod
    def weight(cls, gradient: ArrayLike) -> Field:
        """A field with βU = V gradient·x, where V is the volume of the particle (its area in two dimensions): weight less buoyancy.

        Parameters
        ----------
        gradient : (3,) array_like
            β (ρ_particle - ρ_liquid) g with the mass densities ρ and the acceleration g, as a vector that points upwards.

        Returns
        -------
        Field
        """
        return cls(1, 0, (0.0, 0.0, 0.0), _vector("Field.weight: gradient", gradient), 1.0)

    @classmethod
    def harmonic(cls, center: ArrayLike, stiffness: ArrayLike) -> Field:
        """A harmonic trap with βU = Σ_d stiffness_d (x_d - center_d)²/2, where x is the centre of the particle.

        Parameters
        ----------
        center : (3,) array_like
            Centre of the trap.
        stiffness : (3,) array_like
            Stiffness along x, y and z, in the inverse square of the unit of length; 0 along a direction in which the trap does not act.

        Returns
        -------
        Field
        """
        return cls(2, 0, _vector("Field.harmonic: center", center), _vector("Field.harmonic: stiffness", stiffness), 1.0)

    @classmethod
    def aligning(cls, direction: ArrayLike, strength: float, axis: SupportsIndex = 2) -> Field:
        """A field with βU = -strength (3 cos²θ - 1)/2, where θ is the angle between a direction and a principal axis of the particle.

        Parameters
        ----------
        direction : (3,) array_like
            A vector of any length > 0.
        strength : float
            Positive to align the axes parallel to the direction, negative to align them perpendicular to it.
        axis : int
            The principal axis: 0, 1 or 2, in the order of the semi-axes of the particle.

        Returns
        -------
        Field
        """
        vector = _vector("Field.aligning: direction", direction)
        number, size = integer(axis, "Field.aligning: axis", 0, 2), real(strength, "Field.aligning: strength")
        return cls(3, number, (0.0, 0.0, 0.0), vector, size)


def checked_wall(wall: Wall, name: str) -> Wall:
    """A wall with an integer, two vectors and a number, whatever they mean."""
    point, vector = _vector(f"{name}: point", wall.point), _vector(f"{name}: vector", wall.vector)
    return Wall(integer(wall.kind, f"{name}: kind", None), point, vector, real(wall.size, f"{name}: size"))


def checked_field(field: Field, name: str) -> Field:
    """A field with two integers, two vectors and a number, whatever they mean."""
    kind, axis = integer(field.kind, f"{name}: kind", None), integer(field.axis, f"{name}: axis", None)
    point, vector = _vector(f"{name}: point", field.point), _vector(f"{name}: vector", field.vector)
    return Field(kind, axis, point, vector, real(field.strength, f"{name}: strength"))


class CompiledPotential:
    """The address of a function of C, which calls one of Python, or is given."""

    def __init__(self, address: int, context: int, kept: Any = None) -> None:
        self.address, self.context, self.kept = address, context, kept
        self.errors: list[BaseException] = []

    def take_error(self) -> BaseException | None:
        """The first exception of the function since the last call."""
        first = self.errors[0] if self.errors else None
        self.errors.clear()
        return first


def compile_potential(potential: Potential | int, context: int) -> CompiledPotential:
    """Makes a function of C that calls one of Python. Exceptions are kept, and become NaN."""
    if not callable(potential):
        if not isinstance(potential, (int, np.integer)):
            raise TypeError("HardEllipsoids.set_potential: potential must be a function, or the address of one as an integer, not "
                            f"{shown(potential)}")  # fmt: skip
        number = integer(potential, "HardEllipsoids.set_potential: potential", _LEAST_ADDRESS, 2**64 - 1)
        return CompiledPotential(number, integer(context, "HardEllipsoids.set_potential: context", 0, 2**64 - 1))
    function, as_array = potential, np.ctypeslib.as_array

    def call(_: Any, particle: int, center: Any, quaternion: Any, semi_axes: Any) -> float:
        try:
            return float(function(particle, as_array(center, (3,)), as_array(quaternion, (4,)), as_array(semi_axes, (3,))))
        except BaseException as error:
            made.errors.append(error)
            return float("nan")

    compiled = _FUNCTION(call)
    pointer = ctypes.cast(compiled, ctypes.c_void_p).value
    assert pointer is not None
    made = CompiledPotential(pointer, 0, compiled)
    return made
