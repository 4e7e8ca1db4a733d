// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Walls and fields of a simulation, for C++. Their contracts are those of
/// pw85_simulation_surroundings.h.
#ifndef PW85_SIMULATION_SURROUNDINGS_HPP_INCLUDED
#define PW85_SIMULATION_SURROUNDINGS_HPP_INCLUDED

#include <pw85_simulation_surroundings.h>

#include <pw85/algebra/vector.hpp>

namespace pw85 {

/// A hard wall: see pw85_hard_ellipsoids_set_walls().
struct Wall : pw85_wall {
    /// Returns the half-space normal·x >= offset.
    [[gnu::always_inline]] static Wall plane(Vector<double, 3> const &normal,
                                             double offset) noexcept
    {
        return make(PW85_WALL_PLANE, {}, normal, offset);
    }

    /// Makes a wall of the outside of a sphere.
    [[gnu::always_inline]] static Wall sphere(Vector<double, 3> const &center,
                                              double radius) noexcept
    {
        return make(PW85_WALL_SPHERE, center, {}, radius);
    }

    /// Makes a wall of the outside of a cylinder, given by a point of its axis.
    [[gnu::always_inline]] static Wall
    cylinder(Vector<double, 3> const &point, Vector<double, 3> const &axis, double radius) noexcept
    {
        return make(PW85_WALL_CYLINDER, point, axis, radius);
    }

    /// Makes a wall of the outside of a box, given by its corners.
    [[gnu::always_inline]] static Wall box(Vector<double, 3> const &lower,
                                           Vector<double, 3> const &upper) noexcept
    {
        return make(PW85_WALL_BOX, lower, upper, 0.0);
    }

  private:
    [[gnu::always_inline]] static Wall make(int kind, Vector<double, 3> const &point,
                                            Vector<double, 3> const &vector, double size) noexcept
    {
        return {{kind, {point[0], point[1], point[2]}, {vector[0], vector[1], vector[2]}, size}};
    }
};

/// A field that acts on each particle: see pw85_hard_ellipsoids_set_fields().
struct Field : pw85_field {
    /// βU = gradient·x.
    [[gnu::always_inline]] static Field linear(Vector<double, 3> const &gradient) noexcept
    {
        return make(PW85_FIELD_LINEAR, 0, {}, gradient, 1.0);
    }

    /// βU = V gradient·x, with the volume V of the particle.
    [[gnu::always_inline]] static Field weight(Vector<double, 3> const &gradient) noexcept
    {
        return make(PW85_FIELD_WEIGHT, 0, {}, gradient, 1.0);
    }

    /// βU = Σ_d stiffness_d (x_d - center_d)²/2.
    [[gnu::always_inline]] static Field harmonic(Vector<double, 3> const &center,
                                                 Vector<double, 3> const &stiffness) noexcept
    {
        return make(PW85_FIELD_HARMONIC, 0, center, stiffness, 1.0);
    }

    /// βU = -strength (3 cos²θ - 1)/2, with the angle θ between a direction and a principal axis, 0
    /// to 2.
    [[gnu::always_inline]] static Field aligning(Vector<double, 3> const &direction,
                                                 double strength, int axis = 2) noexcept
    {
        return make(PW85_FIELD_ALIGNING, axis, {}, direction, strength);
    }

  private:
    [[gnu::always_inline]] static Field make(int kind, int axis, Vector<double, 3> const &point,
                                             Vector<double, 3> const &vector,
                                             double strength) noexcept
    {
        return {{kind,
                 axis,
                 {point[0], point[1], point[2]},
                 {vector[0], vector[1], vector[2]},
                 strength}};
    }
};

static_assert(sizeof(Wall) == sizeof(pw85_wall) && sizeof(Field) == sizeof(pw85_field));

} // namespace pw85

#endif
