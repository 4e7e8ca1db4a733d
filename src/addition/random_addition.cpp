// SPDX-License-Identifier: BSD-3-Clause
// The C API of random sequential addition: see addition.hpp.
#include <initializer_list>
#include <new>

#include <pw85_simulation.h>

#include "../base/last_error.hpp"
#include "../base/objects.hpp"
#include "../base/owner.hpp"
#include "addition.hpp"

/// An addition of ellipses or of ellipsoids: one of the two exists. Lengths are in a unit, which is
/// a power of two, so that no square overflows or underflows.
struct pw85_random_addition {
    double unit;
    pw85::detail::Owner<pw85::detail::sequential_addition::Addition<2>> flat;
    pw85::detail::Owner<pw85::detail::sequential_addition::Addition<3>> solid;

    /// Calls work() with the addition.
    template <class Work> auto visit(Work const &work) const noexcept
    {
        return flat ? work(*flat) : work(*solid);
    }
};

namespace pw85::detail::sequential_addition {
namespace {

/// The maximum number of particles and of species: their indices have 32 bits.
constexpr std::size_t max_number = 0x7fffffff;
/// The minimum of semi-axes, in units of the longest one: the square of the shortest one, and what
/// rounding takes from it, are normal numbers.
constexpr double min_semi_axis = 0x1p-480;
/// The maximum of coordinates of the vectors of the cell, in units of the longest semi-axis: the
/// square of the area of a face, whose terms are products of four of them, is finite.
constexpr double max_coordinate = 0x1p250;

/// The longest semi-axis, or NaN if a semi-axis is not finite and positive.
template <int D> double longest_of(std::size_t num_kinds, double const *semi_axes) noexcept
{
    double longest = 0.0;
    for (std::size_t i = 0; i < 3 * num_kinds; ++i) {
        if (!detail::is_finite(semi_axes[i]) || !(semi_axes[i] > 0.0)) return quiet_nan<double>();
        if (i % 3 < D) longest = maximum(longest, semi_axes[i]);
    }
    return longest;
}

/// A power of two near a length.
inline double unit_near(double length) noexcept
{
    int exponent;
    elementary::frexp(length, &exponent);
    return elementary::ldexp(1.0, minimum(exponent, 1023));
}

/// Stores the semi-axes of a species in a unit, in which the longest one of all is `longest`.
/// Returns a status.
template <int D> int load_species(double const *semi_axes, double unit, double longest,
                                  std::size_t row, Species<D> &species) noexcept
{
    for (int i = 0; i < 3; ++i)
        species.axes[i] = semi_axes[3 * row + static_cast<std::size_t>(i)] / unit;
    if (D == 2) species.axes[2] = species.inner();
    if (species.inner() < min_semi_axis * longest)
        return note_cause(PW85_EINVAL, "semi_axes",
                          "must be at least 2⁻⁴⁸⁰ times the longest semi-axis", row);
    if (radius_inside(species.outer(), species.inner()) > 0.0) return PW85_SUCCESS;
    return note_cause(PW85_ENOTPD, "semi_axes",
                      "must have a ratio below 2²³, or rounding may make the form indefinite", row);
}

/// Returns the status of a cell that must be flat.
inline int check_flat(double const *rows) noexcept
{
    for (std::size_t const i : std::initializer_list<std::size_t>{2, 5, 6, 7})
        if (rows[i] != 0.0)
            return note_cause(PW85_EINVAL, "cell",
                              "must have two vectors in the plane of x and y and one along z, in "
                              "two dimensions",
                              0, i, rows[i]);
    return PW85_SUCCESS;
}

/// Returns the status of a cell for particles with this longest semi-axis, in the unit of the cell.
template <int D> int check_cell(Cell<D> const &cell, double longest) noexcept
{
    for (int i = 0; i < D; ++i)
        if (!(largest_coordinate(cell[i]) <= max_coordinate * longest))
            return note_cause(PW85_EINVAL, "cell",
                              "must have no coordinate above 2²⁵⁰ times the longest semi-axis", 0,
                              3 * static_cast<std::size_t>(i));
    for (int i = 0; i < D; ++i)
        if (!(cell.height(i) >= 2 * longest * (1 + 1e-9)))
            return note_cause(PW85_EINVAL, "cell",
                              "must have opposite faces that are farther apart than the longest "
                              "diameter of a particle");
    return PW85_SUCCESS;
}

/// Makes an empty addition. Returns a status.
template <int D> int create(double const *rows, std::size_t num_kinds, double const *semi_axes,
                            std::uint64_t seed, double &unit, Owner<Addition<D>> &made) noexcept
{
    if (D == 2)
        if (int const status = check_flat(rows)) return status;
    double const length = longest_of<D>(num_kinds, semi_axes);
    if (!(length > 0.0)) return PW85_EINVAL;
    unit = unit_near(length);
    double const longest = length / unit;
    Array<Species<D>> all_species;
    if (!all_species.resize(num_kinds)) return PW85_ENOMEM;
    for (std::size_t k = 0; k < num_kinds; ++k)
        if (int const status = load_species(semi_axes, unit, longest, k, all_species[k]))
            return status;
    Cell<D> const cell(rows, unit);
    if (int const status = check_cell(cell, longest)) return status;
    made.reset(new (std::nothrow) Addition<D>(cell, std::move(all_species), seed));
    return made != nullptr && made->prepare() ? PW85_SUCCESS : PW85_ENOMEM;
}

/// The reason why an addition is at its end: a constant PW85_ADDITION_...
template <int D> int end_of(Addition<D> const &addition, Limits const &limits) noexcept
{
    if (addition.is_saturated()) return PW85_ADDITION_SATURATED;
    if (addition.attempts() >= limits.attempts) return PW85_ADDITION_ATTEMPTS;
    return addition.packing().size() >= limits.particles ? PW85_ADDITION_PARTICLES
                                                         : PW85_ADDITION_CONTINUES;
}

/// Copies a particle with its lengths in the caller's unit. Outputs may be null.
template <int D> void store(Particle<D> const &particle, double unit, std::size_t row,
                            double *centers, double *quaternions, std::int32_t *kinds) noexcept
{
    for (std::size_t i = 0; i < 3; ++i)
        centers[3 * row + i] = i < D ? unit * particle.center[static_cast<int>(i)] : 0.0;
    for (std::size_t i = 0; quaternions != nullptr && i < 4; ++i)
        quaternions[4 * row + i] = particle.quaternion[static_cast<int>(i)];
    if (kinds != nullptr) kinds[row] = static_cast<std::int32_t>(particle.species);
}

} // namespace
} // namespace pw85::detail::sequential_addition

namespace pw85::detail {

int random_addition_create(int dimensions, double const cell[9], size_t num_kinds,
                           double const *semi_axes, size_t seed,
                           pw85_random_addition *&addition) noexcept
{
    using sequential_addition::create, sequential_addition::max_number;
    if (dimensions != 2 && dimensions != 3)
        return note_cause(PW85_EINVAL, "dimensions", "must be 2 or 3", 0, 0, dimensions);
    if (num_kinds < 1 || num_kinds > max_number)
        return note_cause(PW85_EINVAL, "num_kinds", "must be > 0 and below 2³¹", 0, 0,
                          static_cast<double>(num_kinds));
    Owner<pw85_random_addition> made(new (std::nothrow) pw85_random_addition);
    if (made == nullptr) return PW85_ENOMEM;
    int const status = dimensions == 2
                           ? create(cell, num_kinds, semi_axes, seed, made->unit, made->flat)
                           : create(cell, num_kinds, semi_axes, seed, made->unit, made->solid);
    if (status == PW85_SUCCESS) addition = made.release();
    return status;
}

int random_addition_advance(pw85_random_addition &addition, double attempts, size_t num_particles,
                            int *end) noexcept
{
    using sequential_addition::max_number;
    if (num_particles < 1 || num_particles > max_number)
        return note_cause(PW85_EINVAL, "num_particles", "must be > 0 and below 2³¹", 0, 0,
                          static_cast<double>(num_particles));
    return addition.visit([&](auto &own) -> int {
        sequential_addition::Limits const limits{attempts, num_particles};
        if (!own.advance(limits)) return PW85_ENOMEM;
        *end = sequential_addition::end_of(own, limits);
        return PW85_SUCCESS;
    });
}

int random_addition_state(pw85_random_addition const &addition, size_t *num_particles,
                          double *attempts, double *free_share) noexcept
{
    addition.visit([&](auto const &own) {
        *num_particles = own.packing().size();
        *attempts = own.attempts();
        *free_share = own.share();
    });
    return PW85_SUCCESS;
}

int random_addition_particles(pw85_random_addition const &addition, size_t num_particles,
                              double *centers, double *quaternions, int32_t *kinds) noexcept
{
    return addition.visit([&](auto const &own) -> int {
        if (num_particles != own.packing().size())
            return note_cause(PW85_EINVAL, "num_particles",
                              "must be the number of particles of the addition", 0, 0,
                              static_cast<double>(num_particles));
        for (size_t k = 0; k < num_particles; ++k)
            sequential_addition::store(own.packing()[k], addition.unit, k, centers, quaternions,
                                       kinds);
        return PW85_SUCCESS;
    });
}

} // namespace pw85::detail

void pw85_random_addition_destroy(pw85_random_addition *addition) { delete addition; }
