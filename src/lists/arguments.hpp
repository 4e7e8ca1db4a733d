// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Checks the arguments that the functions of lists of pairs share, and converts them for the
/// kernels. lists.cpp and the sums of forces use it.
#ifndef PW85_LISTS_ARGUMENTS_HPP_INCLUDED
#define PW85_LISTS_ARGUMENTS_HPP_INCLUDED

#include <cstdint>

#include <pw85_systems.h>

#include "../base/c_arrays.hpp"
#include "../base/last_error.hpp"
#include "../base/parallel.hpp"
#include "../periodic/periodic_cell.hpp"
#include "../simd/pairs.hpp"

namespace pw85::detail::kernels {
namespace {

/// Returns the smallest number that is not an index of a particle.
inline std::uint32_t end_of(std::size_t num_particles) noexcept
{
    return static_cast<std::uint32_t>(
        minimum<std::size_t>(num_particles, INT32_MAX + std::size_t{1}));
}

/// Returns whether n indices are at least 0 and below `end`. `end` is at most 2³¹, so the test is
/// that neither an index nor `end` - 1 - index has the sign bit. The baseline instructions have no
/// comparison of packed unsigned numbers.
inline bool are_below(std::uint32_t end, std::int32_t const *indices, std::size_t n) noexcept
{
    std::uint32_t signs = 0;
    for (std::size_t k = 0; k < n; ++k) {
        auto const index = static_cast<std::uint32_t>(indices[k]);
        signs |= index | (end - 1 - index);
    }
    return signs >> 31 == 0;
}

/// Returns whether all indices of the pairs are in range.
inline bool are_valid(std::size_t num_pairs, std::int32_t const *pairs,
                      std::size_t num_particles) noexcept
{
    auto const end = end_of(num_particles);
    return for_all(num_pairs, [=](Range range) {
               bool const valid =
                   are_below(end, pairs + 2 * range.begin, 2 * (range.end - range.begin));
               return Failure{range.begin, valid ? PW85_SUCCESS : PW85_EINVAL};
           }) == PW85_SUCCESS;
}

/// Records which pointer to a struct is null.
inline int refuse_structs(char const *function, pw85_pair_list const *list,
                          pw85_system const *system) noexcept
{
    return refuse_arrays(function, "num_pairs", 0, NamedArray{"list", list},
                         NamedArray{"system", system});
}

/// Records that there are too many particles.
inline int refuse_size(char const *function, pw85_system const &system) noexcept
{
    return refuse_arrays(function, "num_particles", system.num_particles);
}

/// Records what is wrong with a cell: no vector is periodic, or a periodic one is not finite, or
/// the vectors depend on each other.
[[gnu::cold, gnu::noinline]] inline int refuse_cell(char const *function, double const *cell,
                                                    int const *periodic) noexcept
{
    constexpr double none = quiet_nan<double>();
    if (cell == nullptr)
        return refuse(PW85_EINVAL, {0, function, "cell",
                                    "must not be null, because there are images", 0, 0, none});
    if (!(periodic[0] || periodic[1] || periodic[2]))
        return refuse(PW85_EINVAL,
                      {0, function, "periodic", "must be set along at least one vector of the cell",
                       0, 0, none});
    for (std::size_t k = 0; k < 9; ++k)
        if (periodic[k / 3] && !elementary::isfinite(cell[k]))
            return refuse(
                PW85_EINVAL,
                {0, function, "cell", "must be finite along the periodic vectors", 0, k, cell[k]});
    return refuse(PW85_EINVAL, {0, function, "cell", "must have independent rows", 0, 0, none});
}

/// Prepares the images of a system's particles: those that the caller gives, or else the nearest
/// ones.
inline int prepare_images(char const *function, pw85_system const &system, bool given,
                          Images &images) noexcept
{
    bool const prepared = in_default_environment(
        [&] { return prepare(system.cell, system.periodic, given, images); });
    if (prepared) return PW85_SUCCESS;
    return refuse_cell(function, system.cell, system.periodic);
}

/// Records the first index, in rows of `columns`, that does not belong to a particle.
[[gnu::cold, gnu::noinline]] inline int refuse_index(char const *function, char const *argument,
                                                     pw85_system const &system,
                                                     std::int32_t const *indices, std::size_t n,
                                                     std::size_t columns) noexcept
{
    auto const end = end_of(system.num_particles);
    std::size_t k = 0;
    while (k + 1 < n && are_below(end, indices + k, 1)) ++k;
    return refuse(PW85_EINVAL, {0, function, argument, "must be an index of a particle",
                                k / columns, k % columns, static_cast<double>(indices[k])});
}

/// Checks the arguments that the functions of lists share, and converts them for the kernels.
/// `made` points into `images`. Causes of refusals are recorded for `function`.
inline int prepare_list(char const *function, pw85_pair_list const &list, pw85_system const &system,
                        Images &images, NeighborList &made) noexcept
{
    if (system.num_particles > max_rows) return refuse_size(function, system);
    if (list.num_pairs > max_rows || c_api::any_null(list.pairs) ||
        c_api::any_null(system.centers, system.q))
        return refuse_arrays(function, "num_pairs", list.num_pairs, NamedArray{"pairs", list.pairs},
                             NamedArray{"centers", system.centers}, NamedArray{"q", system.q});
    if (int const status = prepare_images(function, system, list.images != nullptr, images))
        return status;
    made = {list.pairs,  system.centers, system.q,
            list.images, images.cell,    images.nearest ? &images.lattice : nullptr};
    if (are_valid(list.num_pairs, list.pairs, system.num_particles)) return PW85_SUCCESS;
    return refuse_index(function, "pairs", system, list.pairs, 2 * list.num_pairs, 2);
}

/// Returns a system for functions that read no forms. Its pointer to the forms is that to the
/// centres, because it must not be null.
inline pw85_system without_forms(pw85_system const &system) noexcept
{
    pw85_system rest = system;
    rest.q = system.centers;
    return rest;
}

} // namespace
} // namespace pw85::detail::kernels

#endif
