// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The status of a form and of a pair, and units in which all numbers of a valid pair stay in
/// range. Every function checks its input here before it computes anything.
#ifndef PW85_CONTACT_SCALING_HPP_INCLUDED
#define PW85_CONTACT_SCALING_HPP_INCLUDED

#include <pw85/algebra/definite.hpp>
#include <pw85/algebra/two_lanes.hpp>
#include <pw85/algebra/units.hpp>
#include <pw85/status.hpp>

namespace pw85::detail {

/// A pair of ellipsoids in units of their own. The true forms and separation are Q1, Q2/ratio² and
/// r12, each times a power of two. `Q` is the type of q1 and q2. They are the forms, or factors of
/// the forms.
///
/// With τ = λ/(1-λ), every formula of the solver uses t = τ/ratio². So the forms in M = Q1 + t Q2
/// have similar magnitudes for any ratio of sizes.
template <class T, int D, class Q = SymmetricMatrix<T, D>> struct Pair {
    Vector<T, D> r12;
    Q q1, q2;
    T ratio; ///< the size of the units of ellipsoid 1 over that of ellipsoid 2; not small
};

/// A pair that is given by factors of the forms.
template <class T, int D> using FactoredPair = Pair<T, D, Factor<T, D>>;

/// A pair as the caller gives it: both ellipsoids are in the same units.
template <class T, int D, class Q> [[gnu::always_inline]] PW85_FUNCTION constexpr Pair<T, D, Q>
pair_of(Vector<T, D> const &r12, Q const &q1, Q const &q2) noexcept
{
    return {r12, q1, q2, T(1)};
}

/// A pair in units that keep every intermediate result in range.
template <class T, int D, class Q = SymmetricMatrix<T, D>> using ScaledPair = Scaled<Pair<T, D, Q>>;

/// A pair of which each ellipsoid has a unit of its own, scale1 and scale2 times that of r12.
template <class T, int D> struct DistancePair {
    Vector<T, D> r12;
    SymmetricMatrix<T, D> q1, q2;
    T scale1, scale2;
};

template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline Scaled<DistancePair<T, D>>
in_units(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2,
         Units const &units) noexcept
{
    auto const &[length, unit1, unit2, swapped, time] = units;
    return {{length.to_local(r12), unit1.to_local(q1), unit2.to_local(q2), (unit1 / length).as<T>(),
             (unit2 / length).as<T>()},
            units};
}

/// Scales a valid pair that is apart to bring its numbers into range.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline Scaled<DistancePair<T, D>>
scale_distance(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
               SymmetricMatrix<T, D> const &q2) noexcept
{
    return in_units(r12, q1, q2, {unit_of(r12), unit_of(q1), unit_of(q2), false, {}});
}

/// Converts a pair to the type F.
template <class F, class T, int D>
PW85_FUNCTION constexpr DistancePair<F, D> finer(DistancePair<T, D> const &pair) noexcept
{
    return {converted<F>(pair.r12), converted<F>(pair.q1), converted<F>(pair.q2), F(pair.scale1),
            F(pair.scale2)};
}

/// A pair is not scaled if the magnitudes of r12 and of the diagonals are between this limit and
/// its inverse. The largest numbers in the solver are of degree 25 in M and 10 in r12
/// (halley_step() on the rational form). For ordinary aspect ratios they are in the range of
/// double. For other pairs the search on the rational form gives up, and the search on the
/// factorised form takes over, whose numbers are small. Other types are scaled to order one.
template <class T> PW85_FUNCTION constexpr T unscaled_limit() noexcept
{
    using Lane = typename ScalarTraits<T>::Lane;
    return T(std::numeric_limits<Lane>::max_exponent >= 1024 ? 0x1p24 : 4.0);
}

/// Returns whether a pair of such magnitudes needs no scaling. `r` is the magnitude of r12; `q1`
/// and `q2` are the largest diagonal entries. The result is false if r is NaN.
template <class T> PW85_FUNCTION constexpr typename ScalarTraits<T>::Mask
is_in_range(T const &r, T const &q1, T const &q2) noexcept
{
    T const limit = unscaled_limit<T>();
    T const largest = maximum(r, maximum(q1, q2));
    T const smallest = minimum(r, minimum(q1, q2));
    return largest < limit && smallest * limit > T(1);
}

/// The largest ratio of units that is kept. Above it the smaller ellipsoid has the same effect as a
/// point, up to errors far below the roundoff of any scalar. The limit leaves 2^24 for t, which is
/// of order one or a ratio of similar forms.
template <class T> PW85_FUNCTION constexpr int ratio_exponent_limit() noexcept
{
    return std::numeric_limits<typename ScalarTraits<T>::Lane>::max_exponent - 24;
}

/// The square of a length that is similar to the longest semi-axis.
template <class T, int D>
PW85_FUNCTION constexpr T squared_size(SymmetricMatrix<T, D> const &q) noexcept
{
    return largest_diagonal(q);
}

template <class T, int D> PW85_FUNCTION constexpr T squared_size(Factor<T, D> const &s) noexcept
{
    T const largest = largest_entry(s);
    return largest * largest;
}

/// Brings a pair into range. Its entries must be finite and its sizes positive. The scaling is
/// exact.
template <class T, int D, class Q>
PW85_FUNCTION inline ScaledPair<T, D, Q> scale(Pair<T, D, Q> const &pair) noexcept
{
    auto const &[r12, q1, q2, ratio] = pair;
    T const r = largest_coordinate(r12);
    if (is_in_range(r, squared_size(q1), squared_size(q2))) return {pair, {}};
    Unit const unit1 = unit_of(q1), unit2 = unit_of(q2);
    // The squared sizes of a pair in range are between 2^-24 and 2^24, so the exponents differ by
    // at most 24. Such a pair is not exchanged. So scaling changes no bit of the result.
    bool const swapped = unit1.exponent < unit2.exponent - 24;
    Units const units{unit_of(r12), swapped ? unit2 : unit1, swapped ? unit1 : unit2, swapped, {}};
    Unit const relative = smaller_of(units.first / units.second, {ratio_exponent_limit<T>()});
    return {{units.length.to_local(units.reordered(r12)), units.first.to_local(swapped ? q2 : q1),
             units.second.to_local(swapped ? q1 : q2), relative.as<T>()},
            units};
}

/// validate() for a form of any size that may be nearly singular.
template <class T, int D>
PW85_RARE StatusCode validate_scaled(SymmetricMatrix<T, D> const &q) noexcept
{
    if (!is_finite(q)) return StatusCode::invalid_argument;
    if (!has_positive_diagonal(q)) return StatusCode::not_positive_definite;
    bool const definite = is_positive_definite(unit_of(q).to_local(q));
    return definite ? StatusCode::success : StatusCode::not_positive_definite;
}

PW85_RARE_TIER(validate_scaled)

/// The status of one form.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline StatusCode
validate(SymmetricMatrix<T, D> const &q) noexcept
{
    T const largest = largest_diagonal(q);
    bool const clear = is_in_range(largest, largest, largest) && is_clearly_definite(q);
    return clear ? StatusCode::success : validate_scaled(q);
}

/// The status of a pair. If it is success, `scaled` becomes the pair in range.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline StatusCode
validate_pair(Pair<T, D> const &pair, ScaledPair<T, D> &scaled) noexcept
{
    auto const &[r12, q1, q2, ratio] = pair;
    if (!(is_finite(r12) && is_finite(q1) && is_finite(q2))) return StatusCode::invalid_argument;
    if (!(has_positive_diagonal(q1) && has_positive_diagonal(q2)))
        return StatusCode::not_positive_definite;
    scaled = scale(pair);
    bool const definite =
        is_positive_definite(scaled.pair.q1) && is_positive_definite(scaled.pair.q2);
    return definite ? StatusCode::success : StatusCode::not_positive_definite;
}

PW85_SHARED_BY_QUESTIONS(validate_pair)

/// Returns whether λ is in [0, 1] and a pair is valid.
template <class T, int D>
PW85_FUNCTION inline bool is_valid(T const &lambda, Pair<T, D> const &pair) noexcept
{
    ScaledPair<T, D> scaled;
    return lambda >= T(0) && lambda <= T(1) && validate_pair(pair, scaled) == StatusCode::success;
}

/// Returns whether a pair is valid and in range and has r12 != 0, tested with products only. The
/// result is true for almost all such pairs. The function is always inlined to keep the pair in
/// registers.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline typename ScalarTraits<T>::Mask
passes_fast_checks(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                   SymmetricMatrix<T, D> const &q2) noexcept
{
    return is_in_range(sum_of_magnitudes(r12), largest_diagonal(q1), largest_diagonal(q2)) &&
           is_clearly_definite(q1) && is_clearly_definite(q2);
}

template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline typename ScalarTraits<T>::Mask
passes_fast_checks(Pair<T, D> const &pair) noexcept
{
    return passes_fast_checks(pair.r12, pair.q1, pair.q2);
}

/// Tests one pair in this way, from both forms side by side and their adjugates.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline typename ScalarTraits<T>::Mask
passes_fast_checks(Vector<T, D> const &r12, SymmetricMatrix<TwoLanes<T>, D> const &q,
                   SymmetricMatrix<TwoLanes<T>, D> const &adjugate_of_q) noexcept
{
    auto const largest = largest_diagonal(q);
    return both_of(is_in_range(TwoLanes<T>(sum_of_magnitudes(r12)), largest, largest) &&
                   is_clearly_definite(q, adjugate_of_q));
}

} // namespace pw85::detail

#endif
