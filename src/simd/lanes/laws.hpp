// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Laws: the energy U(μ²) of a pair and its derivative with respect to μ², one pair per lane.
/// forces/law_forces.hpp sums the results; simulations take energies.
///
/// Each law has a function evaluate(). It gives NaN for NaN. Concentric ellipsoids have no force
/// for any law. So if U has no derivative at μ = 0, evaluate() gives 0 for it.
#ifndef PW85_SIMD_LANES_LAWS_HPP_INCLUDED
#define PW85_SIMD_LANES_LAWS_HPP_INCLUDED

#include <cstddef>

#include "../targets.hpp"

namespace pw85::detail::kernels {

/// U = ε/α (1 - μ)^α for μ < 1, otherwise 0.
struct SoftRepulsion {
    double energy, exponent;
};

/// U = A μ^-n - B μ^-m - `shift` for μ² < `mu2_max`, otherwise 0.
struct InversePowers {
    double repulsion, n, attraction, m, mu2_max, shift;
};

/// U by cubic Hermite interpolation between points that are equally spaced in μ², and 0 from the
/// last point on. The derivative is that of the polynomial, so forces conserve the energy. Before
/// the first point, U is linear.
struct LawTable {
    double mu2_min, mu2_max;
    std::size_t intervals;
    double const *points; ///< U and its derivative, two numbers per point
};

/// The sum of U over some pairs, and the number of pairs whose derivative is not zero.
struct LawSums {
    double energy;
    std::size_t with_force;
};

/// Writes the derivatives of U at n numbers μ².
template <class Law>
using EvaluateLaw = LawSums(Law const &, std::size_t n, double const *mu2, double *d_u) noexcept;

#define PW85_DECLARE_LAWS(target, one_pair, lanes256, available)                                   \
    namespace target {                                                                             \
    template <class Law>                                                                           \
    LawSums evaluate(Law const &, std::size_t, double const *, double *) noexcept;                 \
    }
PW85_EACH_TARGET(PW85_DECLARE_LAWS)
#undef PW85_DECLARE_LAWS

} // namespace pw85::detail::kernels

#ifdef PW85_KERNEL
#include "../power.hpp"

namespace pw85::detail {
namespace {

/// The energies of pairs, and the derivatives.
struct LawValues {
    Pack u, d_u;
};

/// The difference 1 - μ is computed from 1 - μ², which is exact near contact.
PW85_INLINE LawValues evaluate(kernels::SoftRepulsion const &law, Pack const &mu2) noexcept
{
    Pack const mu = square_root(mu2), gap = (Pack(1.0) - mu2) / (Pack(1.0) + mu);
    Pack const slope = Pack(law.energy) * power(gap, law.exponent - 1.0);
    Pack const u = Pack(slope * gap) / Pack(law.exponent), d_u = -slope / (mu + mu);
    PackMask const apart = mu2 >= Pack(1.0);
    return {select(apart, Pack(0.0), u), select(apart || mu2 == Pack(0.0), Pack(0.0), d_u)};
}

/// The smaller power is a factor: no infinities are subtracted at μ = 0.
PW85_INLINE LawValues evaluate(kernels::InversePowers const &law, Pack const &mu2) noexcept
{
    Pack const x = Pack(1.0) / mu2, weak = power(x, 0.5 * law.m),
               ratio = power(x, 0.5 * (law.n - law.m));
    Pack const u =
        weak * Pack(Pack(law.repulsion) * ratio - Pack(law.attraction)) - Pack(law.shift);
    Pack const slope = Pack(law.n * law.repulsion) * ratio - Pack(law.m * law.attraction);
    Pack const d_u = Pack(-0.5 * x) * Pack(weak * slope);
    PackMask const apart = mu2 >= Pack(law.mu2_max);
    return {select(apart, Pack(0.0), u), select(apart || mu2 == Pack(0.0), Pack(0.0), d_u)};
}

/// The intervals in which positions >= 0 are, as whole numbers in lanes, and the rows of their
/// first points. A position on a point may belong to either interval. The sum of a number and
/// `bias` is rounded to a whole number, whose low bits count from `bias`.
struct Intervals {
    Pack begin;
    double const *rows[lanes];

    PW85_INLINE Intervals(Pack const &position, double const *points) noexcept
    {
        constexpr double bias = 0x1.8p52;
        Pack const biased = (position - Pack(0.5)) + Pack(bias);
        begin = biased - Pack(bias);
        std::uint64_t bits[lanes];
        std::memcpy(bits, &biased.v, sizeof bits);
        for (std::size_t i = 0; i < lanes; ++i)
            rows[i] = points + 2 * (bits[i] - __builtin_bit_cast(std::uint64_t, bias));
    }
};

PW85_INLINE LawValues evaluate(kernels::LawTable const &law, Pack const &mu2) noexcept
{
    auto const count = static_cast<double>(law.intervals);
    double const width = (law.mu2_max - law.mu2_min) / count, per_interval = 1.0 / width;
    Pack const position = Pack(per_interval) * (mu2 - Pack(law.mu2_min));
    // The nearest position that has an interval behind it; 0 for NaN.
    Intervals const intervals(minimum(Pack(count - 1.0), maximum(Pack(0.0), position)), law.points);
    Pack p[4]; // value and derivative at both ends
    ColumnLoader<Pack, 4>::load(intervals.rows, p);
    Pack const x = position - intervals.begin, chord = Pack(per_interval) * (p[2] - p[0]);
    Pack const square = Pack(3.0) * chord - Pack(2.0) * p[1] - p[3],
               cube = p[1] + p[3] - Pack(2.0) * chord;
    PackMask const before = x < Pack(0.0), apart = mu2 >= Pack(law.mu2_max);
    // the mean derivative up to x
    Pack const mean = select(before, p[1], p[1] + x * Pack(square + x * cube));
    Pack const d_u =
        select(before, p[1], p[1] + x * Pack(Pack(2.0) * square + Pack(3.0 * x) * cube));
    Pack const u = p[0] + Pack(x * Pack(width)) * mean;
    return {select(apart, Pack(0.0), u), select(apart, Pack(0.0), d_u)};
}

/// Computes the values of a law, pack by pack. Lanes beyond the last pair repeat that pair, and do
/// not enter the sum.
template <class Law> kernels::LawSums evaluate_law(Law const &given, std::size_t n,
                                                   double const *mu2, double *d_u) noexcept
{
    Law const law = given; // so that no store to d_u may change it
    Pack energies = Pack(0.0), counts = Pack(0.0);
    for (std::size_t k = 0; k < n; k += lanes) {
        std::size_t const left = n - k;
        LawValues const values = evaluate(law, load_numbers(mu2 + k, left));
        store_lanes(values.d_u, left, d_u + k);
        PackMask const live = PackMask::from_bits(live_lanes(left));
        energies = energies + select(live, values.u, Pack(0.0));
        counts = counts + select(live && !(values.d_u == Pack(0.0)), Pack(1.0), Pack(0.0));
    }
    double energy = 0.0, count = 0.0;
    for (std::size_t i = 0; i < lanes; ++i) {
        energy += energies[i];
        count += counts[i];
    }
    return {energy, static_cast<std::size_t>(count)};
}

} // namespace
} // namespace pw85::detail

#else
#include <pw85_systems.h>

#include "../../base/c_arrays.hpp"
#include "../../base/floating_point_environment.hpp"
#include "../../base/member_complaint.hpp"
#include "../../base/parallel.hpp"

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

/// The function of a target.
template <class Law> auto evaluate_of(Target const &target) noexcept
{
    return PW85_OF_LANES(target, EvaluateLaw<Law>, evaluate);
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
    everywhere.mu2_max = infinity<double>();
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
#endif
