// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// How a wall moves: not at all, back and forth, along itself, or around an axis.
#ifndef PW85_LAMMPS_WALL_MOTION_HPP_INCLUDED
#define PW85_LAMMPS_WALL_MOTION_HPP_INCLUDED

#include "wall_surface.hpp"

namespace pw85_lammps {

/// The time that has passed in the steps of runs. Their numbers do not give it, because both they and the time step may be set anew.
class WallClock {
  public:
    /// Adds steps, which may be negative.
    void advance(double steps, double timestep)
    {
        if (timestep != timestep_) *this = {time(), timestep};
        steps_ += steps;
    }

    double time() const { return start_ + steps_ * timestep_; }

    WallClock() = default;

  private:
    WallClock(double start, double timestep) : start_(start), timestep_(timestep) {}

    double start_ = 0.0, timestep_ = 0.0; ///< when the time step became what it is, and the time step
    double steps_ = 0.0;                  ///< since then
};

/// The motion of a rigid wall. The coordinates of the wall are those of space at time 0.
class WallMotion {
  public:
    /// Reads `wiggle DIM AMPLITUDE PERIOD | shear DIM SPEED | rotate PX PY PZ AX AY AZ PERIOD`, or nothing.
    void parse(Words &words, WallSurface const &surface);

    /// Moves the wall to where it is at a time.
    void move_to(double time);

    /// A grain with its centre, form and bounding radius in space, in the coordinates of the wall.
    Grain to_wall(Vector const &center, double const *form, double radius) const;

    /// A contact in the coordinates of the wall, in space.
    GrainGeometry to_space(GrainGeometry const &contact) const;

    /// The velocity of the point of the wall that is at a place in space.
    Vector velocity(Vector const &place) const { return speed_ + cross(spin_, place - pivot_); }

    /// The angular velocity.
    Vector const &spin() const { return spin_; }

  private:
    enum class Kind { none, wiggle, shear, rotate };

    void turn(double angle);

    Kind kind_ = Kind::none;
    Vector direction_{}; ///< of the motion, or of the axis of rotation
    double amplitude_ = 0.0, frequency_ = 0.0;
    Vector pivot_{}, shift_{}, speed_{}, spin_{};
    Vector axes_[3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}; ///< of the wall, in space
};

} // namespace pw85_lammps

#endif
