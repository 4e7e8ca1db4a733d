// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Calls functions of pw85_systems.h with spans. The functions here compare the sizes of lists and
/// systems, and convert them to the structs of C.
#ifndef PW85_SYSTEMS_CALLS_HPP_INCLUDED
#define PW85_SYSTEMS_CALLS_HPP_INCLUDED

#include <pw85_systems.h>

#include <algorithm>

#include <pw85/batch/calls.hpp>
#include <pw85/systems/values.hpp>

namespace pw85::detail {

template <> struct ElementOf<std::int64_t> {
    using Type = std::int64_t;
};
template <std::size_t N> struct ElementOf<std::array<std::int32_t, N>> {
    static_assert(sizeof(std::array<std::int32_t, N>) == N * sizeof(std::int32_t));
    using Type = std::int32_t;
};

static_assert(sizeof(Cell) == 9 * sizeof(double));

static inline double const *in_c(Cell const *cell) noexcept
{
    return reinterpret_cast<double const *>(cell);
}

static inline double *in_c(Cell *cell) noexcept { return reinterpret_cast<double *>(cell); }

static inline pw85_law in_c(Law const &law) noexcept
{
    return {law.kind, law.parameters.size(), law.parameters.data()};
}

/// Converts a list. Images are null in C if there are none, which means the nearest images.
static inline pw85_pair_list in_c(PairList const &list) noexcept
{
    return {list.pairs.size(), in_c(list.pairs), list.images.empty() ? nullptr : in_c(list.images)};
}

/// Converts a system. It has as many particles as there are centres, or as there are forms if
/// centres are left out.
static inline pw85_system in_c(Particles const &particles) noexcept
{
    return {(std::max)(particles.centers.size(), particles.q.size()),
            in_c(particles.centers),
            in_c(particles.q),
            in_c(particles.cell),
            {particles.periodic[0], particles.periodic[1], particles.periodic[2]}};
}

/// Calls a function of a list and a system, with rows for each pair, if all sizes are consistent.
template <class Function, class... Rows>
static StatusCode call_pairs(Function const &function, PairList const &list,
                             Particles const &particles, Rows... rows) noexcept
{
    if (!have_rows(list.pairs.size(), optional(list.images), rows...) ||
        !has_rows(particles.centers.size(), particles.q))
        return StatusCode::invalid_argument;
    pw85_pair_list const c_list = in_c(list);
    pw85_system const system = in_c(particles);
    return static_cast<StatusCode>(function(&c_list, &system, in_c(rows)...));
}

} // namespace pw85::detail

#endif
