// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The laws of the C API for the kernels: sums of forces and simulations take them.
#ifndef PW85_ROWS_LAWS_HPP_INCLUDED
#define PW85_ROWS_LAWS_HPP_INCLUDED

#include <pw85_systems.h>

#include <algorithm>
#include <cmath>

#include "../base/c_arrays.hpp"
#include "../base/member_complaint.hpp"
#include "many_pairs.hpp"

namespace pw85::detail::kernels {
namespace {

/// Checks the kind of a law, and the number of parameters.
inline MemberComplaint of_kind(pw85_law const &law) noexcept
{
    std::size_t const n = law.num_parameters;
    auto const unless = [=](bool is_right, char const *text) {
        return is_right ? MemberComplaint{}
                        : MemberComplaint{"num_parameters", text, static_cast<double>(n)};
    };
    switch (law.kind) {
    case PW85_LAW_SOFT_REPULSION:
        return unless(n == 2, "must be 2 for this kind");
    case PW85_LAW_INVERSE_POWERS:
        return unless(n == 5, "must be 5 for this kind");
    case PW85_LAW_TABLE:
        return unless(n >= 6 && n % 2 == 0 && n <= max_rows,
                      "must be even and at least 6 for this kind");
    default:
        return {"kind", "must be a constant PW85_LAW_...", static_cast<double>(law.kind)};
    }
}

/// Checks the parameters of a law, whose number is right.
inline MemberComplaint of_parameters(pw85_law const &law) noexcept
{
    double const *const x = law.parameters;
    if (c_api::any_null(x)) return {"parameters", "must not be null"};
    auto const entry = [=](std::size_t i, char const *text) {
        return MemberComplaint{"parameters", text, x[i], i};
    };
    MemberComplaint const finite =
        unless_finite("parameters", "must be finite", x, law.num_parameters);
    if (finite.text != nullptr) return finite;
    if (law.kind == PW85_LAW_SOFT_REPULSION && !(x[1] >= 1.0))
        return entry(1, "must have an exponent that is >= 1");
    if (law.kind == PW85_LAW_INVERSE_POWERS && !(x[1] > x[3] && x[3] > 0.0))
        return entry(x[3] > 0.0 ? 1 : 3, "must have exponents n > m > 0");
    if (law.kind == PW85_LAW_INVERSE_POWERS && !(x[4] > 0.0))
        return entry(4, "must have a cutoff that is > 0");
    if (law.kind == PW85_LAW_TABLE && !(x[1] > x[0]))
        return entry(1, "must have a range whose end is above its begin");
    return {};
}

/// Checks a law.
inline MemberComplaint complaint_of(pw85_law const &law) noexcept
{
    MemberComplaint const found = of_kind(law);
    return found.text != nullptr ? found : of_parameters(law);
}

/// The energy of one pair.
template <class Law> double energy_of(Law const &law, double mu2) noexcept
{
    double d_u;
    return evaluate_of<Law>(chosen())(law, 1, &mu2, &d_u).energy;
}

/// Returns the law with the shift by which its energy at the cutoff is 0.
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
