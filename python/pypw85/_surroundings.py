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
    """A hard wall of a simulation: see `HardEllipsoids.set_walls`.

    In two dimensions, points and vectors may be given as (x, y).
    """

    kind: int
    point: tuple[float, float, float]
    vector: tuple[float, float, float]
    size: float

    @classmethod
    def plane(cls, normal: ArrayLike, offset: float) -> Wall:
        """The half-space normal·x >= offset.

        Parameters
        ----------
        normal : (3,) array_like
            Into the wall, of any length > 0.
        offset : float

        Returns
        -------
        Wall
        """
        return cls(0, (0.0, 0.0, 0.0), _vector("Wall.plane: normal", normal), real(offset, "Wall.plane: offset"))

    @classmethod
    def sphere(cls, center: ArrayLike, radius: float) -> Wall:
        """A wall that fills everything outside a sphere; in two dimensions, outside a disc.

        Parameters
        ----------
        center : (3,) array_like
        radius : float

        Returns
        -------
        Wall
        """
        return cls(1, _vector("Wall.sphere: center", center), (0.0, 0.0, 0.0), real(radius, "Wall.sphere: radius"))

    @classmethod
    def cylinder(cls, point: ArrayLike, axis: ArrayLike, radius: float) -> Wall:
        """A wall that fills everything outside a cylinder of infinite length.

        Parameters
        ----------
        point : (3,) array_like
            Of the axis.
        axis : (3,) array_like
            Of any length > 0.
        radius : float

        Returns
        -------
        Wall
        """
        return cls(2, _vector("Wall.cylinder: point", point), _vector("Wall.cylinder: axis", axis), real(radius, "Wall.cylinder: radius"))

    @classmethod
    def box(cls, lower: ArrayLike, upper: ArrayLike) -> Wall:
        """A wall that fills everything outside a box; in two dimensions, outside a rectangle.

        Parameters
        ----------
        lower, upper : (3,) array_like
            Corners.

        Returns
        -------
        Wall
        """
        return cls(3, _vector("Wall.box: lower", lower), _vector("Wall.box: upper", upper), 0.0)


class Field(NamedTuple):
    """A field that acts on each particle of a simulation: see `HardEllipsoids.set_fields`.

    Energies are in the unit of k_B T. In two dimensions, points and vectors may be given as (x, y).
    """

    kind: int
    axis: int
    point: tuple[float, float, float]
    vector: tuple[float, float, float]
    strength: float

    @classmethod
    def linear(cls, gradient: ArrayLike) -> Field:
        """βU = gradient·x, with the centre x.

        Parameters
        ----------
        gradient : (3,) array_like

        Returns
        -------
        Field
        """
        return cls(0, 0, (0.0, 0.0, 0.0), _vector("Field.linear: gradient", gradient), 1.0)

    @classmethod
    def weight(cls, gradient: ArrayLike) -> Field:
        """βU = V gradient·x, with the volume V of the particle, or its area in two dimensions: weight less buoyancy.

        Parameters
        ----------
        gradient : (3,) array_like
            β times the difference of mass densities times the acceleration, upwards.

        Returns
        -------
        Field
        """
        return cls(1, 0, (0.0, 0.0, 0.0), _vector("Field.weight: gradient", gradient), 1.0)

    @classmethod
    def harmonic(cls, center: ArrayLike, stiffness: ArrayLike) -> Field:
        """βU = Σ_d stiffness_d (x_d - center_d)²/2.

        Parameters
        ----------
        center : (3,) array_like
        stiffness : (3,) array_like
            Along x, y and z; 0 where the field does not act.

        Returns
        -------
        Field
        """
        return cls(2, 0, _vector("Field.harmonic: center", center), _vector("Field.harmonic: stiffness", stiffness), 1.0)

    @classmethod
    def aligning(cls, direction: ArrayLike, strength: float, axis: SupportsIndex = 2) -> Field:
        """βU = -strength (3 cos²θ - 1)/2, with the angle θ between a direction and a principal axis of the particle.

        Parameters
        ----------
        direction : (3,) array_like
            Of any length > 0.
        strength : float
            Negative to align the axes across the direction.
        axis : int
            Number of the principal axis, from 0 to 2.

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
