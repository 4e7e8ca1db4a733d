// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The laws of the C API for the kernels: sums of forces and simulations take them.
#ifndef PW85_ROWS_LAWS_HPP_INCLUDED
#define PW85_ROWS_LAWS_HPP_INCLUDED

#include <pw85_systems.h>

#include <algorithm>
#include <cmath>

#include "../base/c_arrays.hpp"
#include "many_pairs.hpp"

namespace pw85::detail::kernels {
namespace {

/// Returns whether a law has the parameters of its kind, with values that the kind allows.
inline bool is_valid(pw85_law const &law) noexcept
{
    std::size_t const n = law.num_parameters;
    double const *const x = law.parameters;
    if (c_api::any_null(x) || n > max_rows ||
        !std::all_of(x, x + n, [](double number) { return std::isfinite(number); }))
        return false;
    switch (law.kind) {
    case PW85_LAW_SOFT_REPULSION:
        return n == 2 && x[1] >= 1.0;
    case PW85_LAW_INVERSE_POWERS:
        return n == 5 && x[1] > x[3] && x[3] > 0.0 && x[4] > 0.0;
    case PW85_LAW_TABLE:
        return n >= 6 && n % 2 == 0 && x[1] > x[0];
    default:
        return false;
    }
}

/// The energy of one pair.
template <class Law> double energy_of(Law const &law, double mu2) noexcept
{
    double d_u;
    return evaluate_of<Law>(chosen())(law, 1, &mu2, &d_u).energy;
}

/// The law with the shift by which its energy at the cutoff is 0.
inline InversePowers shifted(InversePowers law) noexcept
{
    InversePowers everywhere = law;
    everywhere.mu2_max = HUGE_VAL;
    in_default_environment([&] { law.shift = energy_of(everywhere, law.mu2_max); });
    return law;
}

/// Calls use() with what the kernels take for a valid law.
template <class Use> auto with_law(pw85_law const &law, Use const &use) noexcept
{
    double const *const x = law.parameters;
    switch (law.kind) {
    case PW85_LAW_SOFT_REPULSION:
        return use(SoftRepulsion{x[0], x[1]});
    case PW85_LAW_INVERSE_POWERS:
        return use(shifted({x[0], x[1], x[2], x[3], x[4], 0.0}));
    default:
        return use(LawTable{x[0], x[1], law.num_parameters / 2 - 2, x + 2});
    }
}

} // namespace
} // namespace pw85::detail::kernels

#endif
