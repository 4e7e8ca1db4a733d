// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Hard walls around the particles of a simulation. external_potential.hpp holds them;
/// external_potential.cpp calls it.
///
/// 1. A particle is free of a wall if it has no inner point in the wall: it may touch the wall. The
///    decision depends on nothing but the particle and the wall, so a trial that a wall rejects is
///    in detailed balance.
/// 2. A half-space is decided by overlap_polytope() for the polytope of this one plane, exactly,
///    for the doubles as they are given. A box is the half-spaces of its faces.
/// 3. A sphere is decided by contains() for the ball whose form has the rounded square of the
///    radius, and the rounded difference of the centres. What is outside of a cylinder is decided
///    by contains() for the projections on the plane across the axis. They are not rounded for an
///    axis along a coordinate axis.
/// 4. In two dimensions half-spaces have no z in their normals, a sphere is a disc in the plane of
///    the particles, the axis of a cylinder is along z, and a box has no faces across z.
/// 5. Most particles are far from the wall, where their bounding boxes decide.
#ifndef PW85_SIMULATION_WALLS_HPP_INCLUDED
#define PW85_SIMULATION_WALLS_HPP_INCLUDED

#include <pw85_simulation.h>

#include "../base/member_complaint.hpp"
#include "configuration.hpp"

namespace pw85::detail::simulation {

/// Checks whether a simulation can have a wall: its numbers are allowed, and it is repeated with
/// the cell and suits the dimensions.
MemberComplaint complaint_of(pw85_wall const &wall, Configuration const &configuration) noexcept;

/// Returns whether a particle has inner points in a wall.
bool cuts(pw85_wall const &wall, Particle const &particle, int dimensions) noexcept;

/// Says why a wall is refused that cuts a particle with this centre. If the centre is in the wall,
/// a number of the wall may have another sign than was meant.
MemberComplaint complaint_of_cut(pw85_wall const &wall, Vector3 const &center,
                                 int dimensions) noexcept;

/// Returns whether something that does not change along a vector stays the same if it is moved by
/// the periodic vectors of a cell: whether these vectors have no component along `normal`, up to
/// rounding errors.
bool is_repeated_across(Vector3 const &normal, Cell const &cell) noexcept;

} // namespace pw85::detail::simulation

#endif
