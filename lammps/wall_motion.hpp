// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// Motion of a wall: as a function of time, by variables, or as a body with a mass under its load.
#ifndef PW85_LAMMPS_WALL_MOTION_HPP_INCLUDED
#define PW85_LAMMPS_WALL_MOTION_HPP_INCLUDED

#include "equal_value.hpp"
#include "wall_surface.hpp"

#include <array>
#include <string>

namespace pw85_lammps {

/// The time that has passed in the steps of runs. The numbers of the steps do not give it, because
/// commands may change them and the time step.
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

    /// step at which the time step was last changed, and the time step
    double start_ = 0.0, timestep_ = 0.0;
    double steps_ = 0.0; ///< since then
};

/// The motion of a rigid wall. The coordinates of the wall are those of space at time 0.
class WallMotion {
  public:
    /// Reads `wiggle DIM AMPLITUDE PERIOD | shear DIM SPEED | rotate PX PY PZ AX AY AZ PERIOD |
    /// linear VX VY VZ | variable DX DY DZ VX VY VZ | servo DIM FORCE MASS DAMPING`, or nothing.
    void parse(Words &words, WallSurface const &surface);

    /// Returns whether values follow from variables of the input script.
    bool has_variables() const { return kind_ == Kind::variable || force_.is_variable(); }

    /// Reads the variables of the motion or of the force of a servo. All processors call this
    /// together.
    void read_variables(LAMMPS_NS::LAMMPS &lammps, std::string const &style);

    /// Moves the wall to its position at a time.
    void move_to(double time);

    /// Moves the wall to its position in the step after a time. Variables are not read: their
    /// displacement changes by their velocity.
    void move_on(double time, double timestep);

    /// Displacement and speed of a servo.
    struct ServoState {
        double shift = 0.0, speed = 0.0;
    };

    bool is_at_rest() const { return kind_ == Kind::none; }
    bool is_servo() const { return kind_ == Kind::servo; }
    ServoState const &servo_state() const { return servo_; }
    void set_servo_state(ServoState const &state);

    /// Makes the first half of a step of velocity Verlet, as for the grains: the speed of the servo
    /// changes by half a step, and the servo moves.
    void start_servo_step(double timestep);

    /// Makes the second half of the step, with the force of the grains on the wall. A time step of
    /// zero sets up a run.
    /// @param per_mass LAMMPS's factor from force over mass to acceleration
    void finish_servo_step(Vector const &load, double timestep, double per_mass);

    /// Returns a point of the wall in space.
    Vector to_space(Vector const &point) const;

    /// Returns the displacement of the wall along itself or in space, without rotation; speed()
    /// returns the velocity.
    Vector const &shift() const { return shift_; }
    Vector const &speed() const { return speed_; }

    /// Returns the point through which the axis of a rotation goes, or the origin.
    Vector const &pivot() const { return pivot_; }

    /// Returns a grain with its centre, form and bounding radius in space, in the coordinates of
    /// the wall.
    Grain to_wall(Vector const &center, double const *form, double radius) const;

    /// Returns a contact in the coordinates of the wall, in space.
    GrainGeometry to_space(GrainGeometry const &contact) const;

    /// Returns the velocity of the point of the wall that is at a place in space.
    Vector velocity(Vector const &place) const { return speed_ + cross(spin_, place - pivot_); }

    /// Returns the angular velocity.
    Vector const &spin() const { return spin_; }

  private:
    enum class Kind { none, wiggle, shear, rotate, linear, variable, servo };

    void parse_rotation(Words &words);
    void parse_servo(Words &words);

    void turn(double angle);
    Vector turned(Vector const &x) const;

    Kind kind_ = Kind::none;
    Vector direction_{}; ///< of the motion, or of the axis of rotation
    double amplitude_ = 0.0, frequency_ = 0.0;
    Vector pivot_{}, shift_{}, speed_{}, spin_{};
    /// displacement and velocity
    std::array<EqualValue, 6> variables_{};
    EqualValue force_; ///< on a servo
    /// of a servo; target: the value of force_
    double mass_ = 1.0, drag_ = 0.0, target_ = 0.0, acceleration_ = 0.0;
    ServoState servo_;
    /// of the wall, in space
    Vector axes_[3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
};

} // namespace pw85_lammps

#endif
