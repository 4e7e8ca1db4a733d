// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The random particles of a random sequential addition: one for each attempt.
#ifndef PW85_ADDITION_ATTEMPTS_HPP_INCLUDED
#define PW85_ADDITION_ATTEMPTS_HPP_INCLUDED

#include <algorithm>

#include <pw85/algebra/philox.hpp>
#include <pw85/contact/forms.hpp>

#include "divisions.hpp"
#include "packing.hpp"

namespace pw85::detail::sequential_addition {
namespace {

/// A species of particles: its semi-axes. In two dimensions no decision uses the third.
template <int D> struct Species {
    Vector<double, 3> axes;

    double inner() const noexcept
    {
        return *std::min_element(axes.coordinates, axes.coordinates + D);
    }
    double outer() const noexcept
    {
        return *std::max_element(axes.coordinates, axes.coordinates + D);
    }
};

/// A part of all positions and angles of a species: the number of the part along each vector of the
/// cell, and among the angles.
template <int D> struct Voxel {
    std::uint64_t corner[std::size_t(D)];
    std::uint64_t angle;
    std::uint32_t species;
};

/// The orientation by three random numbers, of which ellipses need the first: an angle from 0 to π;
/// or as Shoemake (Graphics Gems III, 1992) has it.
template <int D> Vector<double, 4> random_quaternion(double u, double v, double w) noexcept
{
    if constexpr (D == 2)
        return {elementary::cos(pi / 2 * u), 0.0, 0.0, elementary::sin(pi / 2 * u)};
    double const s = elementary::sqrt(1 - u), t = elementary::sqrt(u);
    return {t * elementary::cos(2 * pi * w), s * elementary::sin(2 * pi * v),
            s * elementary::cos(2 * pi * v), t * elementary::sin(2 * pi * w)};
}

template <int D>
Form<D> form_of(Species<D> const &species, Vector<double, 4> const &quaternion) noexcept
{
    auto const q = ellipsoid_quaternion(species.axes, quaternion).q;
    if constexpr (D == 2)
        return {q[0], q[1], q[3]};
    else
        return q;
}

/// Draws a particle in a voxel.
template <int D> Particle<D> draw(Stream &random, Voxel<D> const &voxel,
                                  Divisions<D> const &divisions, Species<D> const &species,
                                  Cell<D> const &cell) noexcept
{
    Particle<D> one;
    for (int i = 0; i < D; ++i)
        one.place[i] = minimum((static_cast<double>(voxel.corner[i]) + random.uniform()) /
                                   static_cast<double>(divisions.places[i]),
                               0x1.fffffffffffffp-1); // the last number below 1
    double const u = (static_cast<double>(voxel.angle) + random.uniform()) /
                     static_cast<double>(divisions.angles),
                 v = D == 3 ? random.uniform() : 0.0, w = D == 3 ? random.uniform() : 0.0;
    one.center = cell.point(one.place);
    one.quaternion = random_quaternion<D>(u, v, w);
    one.body = {form_of(species, one.quaternion), species.outer(),
                radius_inside(species.outer(), species.inner())};
    one.species = voxel.species;
    return one;
}

} // namespace
} // namespace pw85::detail::sequential_addition

#endif
