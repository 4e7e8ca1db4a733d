// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The particles of a simulation and their cell. neighborhood.hpp finds their neighbours,
/// particles.hpp copies them for trials.
#ifndef PW85_SIMULATION_CONFIGURATION_HPP_INCLUDED
#define PW85_SIMULATION_CONFIGURATION_HPP_INCLUDED

#include <span>

#include <pw85_systems.h>

#include <pw85/contact/forms.hpp>
#include <pw85/distance/bounding_box.hpp>

#include "../base/huge_pages.hpp"
#include "../neighbors/periodicity.hpp"

namespace pw85::detail::simulation {

using neighbors::Multiples;
using Vector3 = Vector<double, 3>;
using Quaternion = Vector<double, 4>;
using Form3 = SymmetricMatrix<double, 3>;

[[gnu::always_inline]] inline bool are_equal(Vector3 const &x, Vector3 const &y) noexcept
{
    return x[0] == y[0] && x[1] == y[1] && x[2] == y[2];
}

/// Prefetches the cache lines of some objects. They are loaded while other work continues.
template <class T>
[[gnu::always_inline]] inline void prefetch(T const *first, std::size_t count) noexcept
{
    constexpr std::size_t line = 64;
    auto const *const bytes = reinterpret_cast<char const *>(first);
    std::size_t const size = count * sizeof(T);
    for (std::size_t k = 0; k < size; k += line) __builtin_prefetch(bytes + k);
    if (size > 0) __builtin_prefetch(bytes + size - 1);
}

/// Shape, position and orientation of a particle. The form and the half-widths of its bounding box
/// follow from the rest.
struct Particle {
    Vector3 center;
    Quaternion quaternion;
    Vector3 semi_axes;
    Form3 q;
    Vector3 half_widths;

    /// Computes form and half-widths. Returns false if the rounded form is not positive definite.
    [[gnu::always_inline]] bool shape() noexcept
    {
        auto const form = ellipsoid_quaternion(semi_axes, quaternion);
        auto const box = bounding_box(form.q);
        q = form.q;
        half_widths = box.half_widths;
        return box.status == Status::success;
    }
};

struct Cell {
    double vectors[9]; ///< rows are vectors; only insertions read those that are not periodic
    int periodic[3];
    bool exists = false;

    /// Returns the vectors, or null without a cell.
    double const *given() const noexcept { return exists ? vectors : nullptr; }

    /// Finds the lattice. Returns false if the periodic vectors are not independent.
    [[nodiscard]] bool find_lattice(neighbors::Periodicity &lattice) const noexcept
    {
        return lattice.prepare(given(), periodic);
    }

    [[gnu::always_inline]] Vector3 vector(int k) const noexcept
    {
        return {vectors[3 * k], vectors[3 * k + 1], vectors[3 * k + 2]};
    }

    /// Multiples of the periodic vectors. The translation of the negative multiples is the negative
    /// one, to the last bit.
    [[gnu::always_inline]] Vector3 translation(Multiples const &image) const noexcept
    {
        Vector3 sum = {0.0, 0.0, 0.0};
        for (int k = 0; k < 3 && exists; ++k)
            for (int d = 0; d < 3 && image.n[k] != 0; ++d)
                sum[d] += image.n[k] * vectors[3 * k + d];
        return sum;
    }
};

/// Returns the vector from a centre to that of an image of another particle, moved by a
/// translation. The engine and the chains decide about these rounded separations.
[[gnu::always_inline]] inline Vector3 separation(Vector3 const &from, Vector3 const &to,
                                                 Vector3 const &translation) noexcept
{
    return (to - from) + translation;
}

/// The centres are never wrapped into the cell. So a separation of two particles is always rounded
/// in the same way, and a pair without overlap stays one until one of its particles moves or the
/// cell changes.
///
/// In two dimensions all centres have the same z, and a principal axis of each particle, the third
/// one, is along z. So the forms are block diagonal, and overlaps are those of the ellipses in the
/// plane, whatever the third semi-axes are. The first two vectors of the cell have no z, and the
/// third is along z and not periodic. Moves keep the bits of all that: z of centres and of the
/// cell, and x and y of quaternions.
struct Configuration {
    Array<Vector3> centers, semi_axes, half_widths;
    Array<Quaternion> quaternions;
    Array<Form3> q;
    Cell cell;
    int dimensions = 3; ///< 2 or 3

    std::size_t size() const noexcept { return size_; }

    /// Capacity of the arrays, in particles.
    std::size_t capacity() const noexcept { return centers.size(); }

    /// Changes the number of particles, up to the capacity. New ones have no values yet.
    void set_size(std::size_t n) noexcept { size_ = n; }

    /// Returns whether the system has a volume: it is periodic along all vectors of its dimensions.
    [[gnu::always_inline]] bool is_closed() const noexcept
    {
        return cell.exists && cell.periodic[0] && cell.periodic[1] &&
               (dimensions == 2 || cell.periodic[2]);
    }

    /// Returns the volume of the cell, or its area in two dimensions.
    [[gnu::always_inline]] double volume() const noexcept
    {
        Vector3 const a = cell.vector(0), b = cell.vector(1);
        return absolute(dimensions == 2 ? a[0] * b[1] - a[1] * b[0]
                                        : dot(a, cross(b, cell.vector(2))));
    }

    /// Returns the length of the longest vector of a closed cell, or else infinity. A longer
    /// translation leads to places that shorter ones reach, too.
    [[gnu::always_inline]] double longest_useful_translation() const noexcept
    {
        if (!is_closed()) return infinity<double>();
        double longest = 0.0;
        for (int k = 0; k < dimensions; ++k) longest = maximum(longest, magnitude(cell.vector(k)));
        return longest;
    }

    /// Returns whether a centre is between the origin and the end of each vector that is not
    /// periodic. Along the others it has an image that is.
    [[gnu::always_inline]] bool is_in_cell(Vector3 const &center) const noexcept
    {
        Vector3 const a = cell.vector(0), b = cell.vector(1);
        Vector3 const c = dimensions == 2 ? Vector3{0.0, 0.0, 1.0} : cell.vector(2);
        Vector3 const across[3] = {cross(b, c), cross(c, a), cross(a, b)};
        double const all = dot(a, across[0]);
        bool inside = true;
        for (int k = 0; k < dimensions; ++k) {
            double const part = dot(across[k], center) / all;
            inside = inside && (cell.periodic[k] || (part >= 0.0 && part < 1.0));
        }
        return inside;
    }

    /// Returns the length of the longest semi-axis in the space of its dimensions; 0 without
    /// particles.
    [[gnu::always_inline]] double longest_semi_axis() const noexcept
    {
        double longest = 0.0;
        for (Vector3 const &axes : std::span(semi_axes.data(), size()))
            for (int d = 0; d < dimensions; ++d) longest = maximum(longest, axes[d]);
        return longest;
    }

    [[nodiscard, gnu::always_inline]] bool resize(std::size_t n) noexcept
    {
        if (!centers.resize(n) || !semi_axes.resize(n) || !half_widths.resize(n) ||
            !quaternions.resize(n) || !q.resize(n))
            return false;
        for (Array<Vector3> *vectors : {&centers, &semi_axes, &half_widths})
            prefer_huge_pages(*vectors);
        prefer_huge_pages(quaternions);
        prefer_huge_pages(q);
        size_ = n;
        return true;
    }

    [[gnu::always_inline]] Particle get(std::size_t i) const noexcept
    {
        return {centers[i], quaternions[i], semi_axes[i], q[i], half_widths[i]};
    }

    [[gnu::always_inline]] void set(std::size_t i, Particle const &particle) noexcept
    {
        centers[i] = particle.center;
        quaternions[i] = particle.quaternion;
        semi_axes[i] = particle.semi_axes;
        q[i] = particle.q;
        half_widths[i] = particle.half_widths;
    }

    /// Brings a particle into the cache.
    [[gnu::always_inline]] void prefetch(std::size_t i) const noexcept
    {
        simulation::prefetch(&centers[i], 1);
        simulation::prefetch(&semi_axes[i], 1);
        simulation::prefetch(&half_widths[i], 1);
        simulation::prefetch(&quaternions[i], 1);
        simulation::prefetch(&q[i], 1);
    }

    /// Returns the vector from the centre of particle i to that of an image of particle j. The
    /// separation from j to i is the negative one, to the last bit.
    [[gnu::always_inline]] Vector3 separation(std::size_t i, std::size_t j,
                                              Vector3 const &translation) const noexcept
    {
        return simulation::separation(centers[i], centers[j], translation);
    }

    /// Returns a view for the C API.
    pw85_system system() const noexcept
    {
        return {size(),
                reinterpret_cast<double const *>(centers.data()),
                reinterpret_cast<double const *>(q.data()),
                cell.given(),
                {cell.periodic[0], cell.periodic[1], cell.periodic[2]}};
    }

  private:
    std::size_t size_ = 0;
};

} // namespace pw85::detail::simulation

#endif
