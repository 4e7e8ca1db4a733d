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
            words.refuse("has a shear that is not along the wall: use wiggle or rotate to move it across");
        speed_[static_cast<std::size_t>(axis)] = words.coordinate("speed");
    } else if (words.skip("rotate")) {
        kind_ = Kind::rotate;
        for (double &x : pivot_) x = words.coordinate("place of its axis");
        for (double &x : direction_) x = words.coordinate("direction of its axis");
        double const length = std::sqrt(dot(direction_, direction_));
        if (!(length > 0.0)) words.refuse("has an axis of rotation without direction");
        direction_ = (1.0 / length) * direction_;
        frequency_ = parse_frequency(words);
        spin_ = frequency_ * direction_;
    }
}

void WallMotion::move_to(double time)
{
    double const angle = frequency_ * time;
    if (kind_ == Kind::wiggle) {
        shift_ = amplitude_ * (1.0 - std::cos(angle)) * direction_;
        speed_ = amplitude_ * frequency_ * std::sin(angle) * direction_;
    }
    if (kind_ == Kind::rotate) turn(angle);
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
    Vector const images[3] = {product(form, axes_[0]), product(form, axes_[1]), product(form, axes_[2])};
    return {pivot_ + Vector{dot(axes_[0], r), dot(axes_[1], r), dot(axes_[2], r)},
            {dot(axes_[0], images[0]), dot(axes_[0], images[1]), dot(axes_[0], images[2]), dot(axes_[1], images[1]),
             dot(axes_[1], images[2]), dot(axes_[2], images[2])},
            radius};
}

GrainGeometry WallMotion::to_space(GrainGeometry const &contact) const
{
    auto const turned = [this](Vector const &x) { return x[0] * axes_[0] + x[1] * axes_[1] + x[2] * axes_[2]; };
    return {turned(contact.normal), contact.depth, turned(contact.arm1), turned(contact.arm2), contact.radius};
}

} // namespace pw85_lammps
