/// @file
/// Normalisation of a pair by powers of two.
#ifndef PW85_CONTACT_SCALING_HPP_INCLUDED
#define PW85_CONTACT_SCALING_HPP_INCLUDED

#include <pw85/algebra/powers_of_two.hpp>

namespace pw85::detail {

/// A pair of ellipsoids in units of their own: the true forms and separation are Q1, Q2/ratio² and r12, all three
/// times a power of two.
///
/// With τ = λ/(1-λ), every formula below is written in t = τ/ratio², so that M = Q1 + t Q2 blends forms of like
/// magnitude however much the sizes differ.
template <class T, int D> struct Pair {
    Vector<T, D> r12;
    SymmetricMatrix<T, D> q1, q2;
    T ratio; ///< size of the units of ellipsoid 1 over that of ellipsoid 2, not small
};

/// A pair as the caller gives it: both ellipsoids are in the same units.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION constexpr Pair<T, D>
pair_of(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2) noexcept
{
    return {r12, q1, q2, T(1)};
}

/// A pair in units that keep every intermediate result in range, and the way back.
template <class T, int D> struct ScaledPair {
    Pair<T, D> pair;
    int length;   ///< r12 is the pair's times 2^length
    int form;     ///< Q1 is the pair's times 4^form, and μ² the pair's times 4^(length - form)
    bool swapped; ///< whether the roles of the ellipsoids were exchanged, and r12 reversed
};

/// Magnitudes of r12 and of the diagonals up to which, and down to the inverse of which, a pair is not scaled. The largest
/// numbers that the solver forms are of degree 25 in M and 10 in r12 (halley_step() on the rational form): ordinary aspect
/// ratios leave the range of double enough room, and where they do not, the rational form gives up and the factorised one
/// takes over, whose numbers are small. Other types are scaled to order one.
template <class T> PW85_FUNCTION constexpr T unscaled_limit() noexcept
{
    using Lane = typename ScalarTraits<T>::Lane;
    return T(std::numeric_limits<Lane>::max_exponent >= 1024 ? 0x1p24 : 4.0);
}

/// Whether a pair of such magnitudes needs no scaling: `r` of r12, `q1` and `q2` the largest diagonal entries. False where r
/// is NaN.
template <class T>
PW85_FUNCTION constexpr typename ScalarTraits<T>::Mask is_in_range(T const &r, T const &q1, T const &q2) noexcept
{
    T const limit = unscaled_limit<T>();
    T const largest = maximum(r, maximum(q1, q2));
    T const smallest = minimum(r, minimum(q1, q2));
    return largest < limit && smallest * limit > T(1);
}

/// The largest ratio of units that is kept: beyond it the smaller ellipsoid is a point to the larger one, to far
/// below the precision of any scalar. It leaves 2^24 for t, which is of order one or a ratio of like forms.
template <class T> PW85_FUNCTION constexpr int ratio_exponent_limit() noexcept
{
    return std::numeric_limits<typename ScalarTraits<T>::Lane>::max_exponent - 24;
}

/// Brings a pair with finite entries and positive diagonals into range, exactly.
template <class T, int D> PW85_FUNCTION inline ScaledPair<T, D> scale(Pair<T, D> const &pair) noexcept
{
    auto const &[r12, q1, q2, ratio] = pair;
    T const r = largest_coordinate(r12);
    if (is_in_range(r, largest_diagonal(q1), largest_diagonal(q2))) return {pair, 0, 0, false};
    int const er = r > T(0) ? binary_exponent(r) : 0;
    int const e1 = half_exponent(largest_diagonal(q1)), e2 = half_exponent(largest_diagonal(q2));
    // Half the exponents of diagonals between the inverse of 2^24 and that, in range, differ by at most 24: such pairs are not
    // exchanged, so scaling changes no bit of the result.
    bool const swapped = e1 < e2 - 24;
    int const difference = swapped ? e2 - e1 : e1 - e2, limit = ratio_exponent_limit<T>();

    ScaledPair<T, D> scaled{};
    scaled.pair.r12 = times_power_of_two(swapped ? -r12 : r12, -er);
    scaled.pair.q1 = swapped ? times_power_of_two(q2, -2 * e2) : times_power_of_two(q1, -2 * e1);
    scaled.pair.q2 = swapped ? times_power_of_two(q1, -2 * e1) : times_power_of_two(q2, -2 * e2);
    scaled.pair.ratio = times_power_of_two(T(1), difference < limit ? difference : limit);
    scaled.length = er;
    scaled.form = swapped ? e2 : e1;
    scaled.swapped = swapped;
    return scaled;
}

} // namespace pw85::detail

#endif
