// SPDX-License-Identifier: GPL-2.0-only
// The words of a motion, and the coordinates of a wall that moves.
#include "wall_motion.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace pw85_lammps {

namespace {

int parse_axis(Words &words) { return words.choice<int>("axis", {{"x", 0}, {"y", 1}, {"z", 2}}); }

double parse_frequency(Words &words) { return 2.0 * std::numbers::pi / words.positive("period"); }

} // namespace

void WallMotion::parse(Words &words, WallSurface const &surface)
{
    if (words.skip("wiggle")) {
        kind_ = Kind::wiggle;
        direction_[static_cast<std::size_t>(parse_axis(words))] = 1.0;
        amplitude_ = words.coordinate("amplitude");
        frequency_ = parse_frequency(words);
    } else if (words.skip("shear")) {
        kind_ = Kind::shear;
        int const axis = parse_axis(words);
        if (!surface.slides_along(axis))
            words.refuse(
                "has a shear that is not along the wall: use wiggle or rotate to move it across");
        speed_[static_cast<std::size_t>(axis)] = words.coordinate("speed");
    } else if (words.skip("rotate")) {
        parse_rotation(words);
    } else if (words.skip("linear")) {
        kind_ = Kind::linear;
        for (double &x : speed_) x = words.coordinate("velocity");
    } else if (words.skip("variable")) {
        kind_ = Kind::variable;
        for (EqualValue &value : variables_)
            value = EqualValue::parse(words, "displacement or velocity");
    } else if (words.skip("servo")) {
        parse_servo(words);
    }
}

void WallMotion::parse_rotation(Words &words)
{
    kind_ = Kind::rotate;
    for (double &x : pivot_) x = words.coordinate("place of its axis");
    for (double &x : direction_) x = words.coordinate("direction of its axis");
    double const length = std::sqrt(dot(direction_, direction_));
    if (!(length > 0.0)) words.refuse("has an axis of rotation without direction");
    direction_ = (1.0 / length) * direction_;
    frequency_ = parse_frequency(words);
    spin_ = frequency_ * direction_;
}

void WallMotion::parse_servo(Words &words)
{
    kind_ = Kind::servo;
    direction_[static_cast<std::size_t>(parse_axis(words))] = 1.0;
    force_ = EqualValue::parse(words, "force of the servo");
    target_ = force_.number();
    mass_ = words.positive("mass of the servo");
    drag_ = words.number("damping of the servo");
}

void WallMotion::read_variables(LAMMPS_NS::LAMMPS &lammps, std::string const &style)
{
    target_ = force_.read(lammps, style);
    if (kind_ != Kind::variable) return;
    for (std::size_t k = 0; k < 3; ++k) {
        shift_[k] = variables_[k].read(lammps, style);
        speed_[k] = variables_[k + 3].read(lammps, style);
    }
}

void WallMotion::move_to(double time)
{
    double const angle = frequency_ * time;
    if (kind_ == Kind::wiggle) {
        shift_ = amplitude_ * (1.0 - std::cos(angle)) * direction_;
        speed_ = amplitude_ * frequency_ * std::sin(angle) * direction_;
    }
    if (kind_ == Kind::linear) shift_ = time * speed_;
    if (kind_ == Kind::rotate) turn(angle);
}

void WallMotion::move_on(double time, double timestep)
{
    move_to(time + timestep);
    if (kind_ == Kind::variable) shift_ = shift_ + timestep * speed_;
    if (kind_ == Kind::servo) start_servo_step(timestep);
}

void WallMotion::set_servo_state(ServoState const &state)
{
    servo_ = state;
    shift_ = state.shift * direction_;
    speed_ = state.speed * direction_;
}

void WallMotion::start_servo_step(double timestep)
{
    double const speed = servo_.speed + 0.5 * timestep * acceleration_;
    set_servo_state({servo_.shift + timestep * speed, speed});
}

void WallMotion::finish_servo_step(Vector const &load, double timestep, double per_mass)
{
    acceleration_ = per_mass * (dot(load, direction_) + target_ - drag_ * servo_.speed) / mass_;
    set_servo_state({servo_.shift, servo_.speed + 0.5 * timestep * acceleration_});
}

/// Turns the axes of the wall from where they were at first, by Rodrigues' formula.
void WallMotion::turn(double angle)
{
    double const c = std::cos(angle), s = std::sin(angle);
    for (std::size_t k = 0; k < 3; ++k) {
        Vector e{};
        e[k] = 1.0;
        axes_[k] = c * e + s * cross(direction_, e) + ((1.0 - c) * dot(direction_, e)) * direction_;
    }
}

Grain WallMotion::to_wall(Vector const &center, double const *form, double radius) const
{
    Vector const r = center - shift_ - pivot_;
    Vector const images[3] = {product(form, axes_[0]), product(form, axes_[1]),
                              product(form, axes_[2])};
    return {pivot_ + Vector{dot(axes_[0], r), dot(axes_[1], r), dot(axes_[2], r)},
            {dot(axes_[0], images[0]), dot(axes_[0], images[1]), dot(axes_[0], images[2]),
             dot(axes_[1], images[1]), dot(axes_[1], images[2]), dot(axes_[2], images[2])},
            radius};
}

Vector WallMotion::turned(Vector const &x) const
{
    return x[0] * axes_[0] + x[1] * axes_[1] + x[2] * axes_[2];
}

GrainGeometry WallMotion::to_space(GrainGeometry const &contact) const
{
    GrainGeometry in_space = contact;
    in_space.normal = turned(contact.normal);
    in_space.arm1 = turned(contact.arm1);
    in_space.arm2 = turned(contact.arm2);
    return in_space;
}

Vector WallMotion::to_space(Vector const &point) const
{
    return pivot_ + shift_ + turned(point - pivot_);
}

} // namespace pw85_lammps
