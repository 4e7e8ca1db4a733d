/// @file
/// Scales a pair by powers of two, so that all intermediate results stay in range. validate.hpp, evaluation.hpp, refinement.hpp and
/// the loaders of pairs (kernels/rows.hpp) use this file.
#ifndef PW85_CONTACT_SCALING_HPP_INCLUDED
#define PW85_CONTACT_SCALING_HPP_INCLUDED

#include <pw85/algebra/powers_of_two.hpp>

namespace pw85::detail {

/// A pair of ellipsoids in units of their own. The true forms and separation are Q1, Q2/ratio² and r12, each times a power of two.
///
/// With τ = λ/(1-λ), every formula of the solver uses t = τ/ratio². So the forms in M = Q1 + t Q2 have similar magnitudes for any
/// ratio of sizes.
template <class T, int D> struct Pair {
    Vector<T, D> r12;
    SymmetricMatrix<T, D> q1, q2;
    T ratio; ///< the size of the units of ellipsoid 1 over that of ellipsoid 2; not small
};

/// A pair as the caller gives it: both ellipsoids are in the same units.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION constexpr Pair<T, D>
pair_of(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2) noexcept
{
    return {r12, q1, q2, T(1)};
}

/// A pair in units that keep every intermediate result in range, and the exponents that lead back to the units of the caller.
template <class T, int D> struct ScaledPair {
    Pair<T, D> pair;
    int length;   ///< r12 is that of the pair times 2^length
    int form;     ///< Q1 is that of the pair times 4^form, and μ² that of the pair times 4^(length - form)
    bool swapped; ///< whether the ellipsoids are exchanged and r12 is reversed
};

/// A pair is not scaled if the magnitudes of r12 and of the diagonals are between this limit and its inverse. The largest numbers
/// in the solver are of degree 25 in M and 10 in r12 (halley_step() on the rational form). For ordinary aspect ratios they are in
/// the range of double. For other pairs the search on the rational form gives up, and the search on the factorised form takes over,
/// whose numbers are small. Other types are scaled to order one.
template <class T> PW85_FUNCTION constexpr T unscaled_limit() noexcept
{
    using Lane = typename ScalarTraits<T>::Lane;
    return T(std::numeric_limits<Lane>::max_exponent >= 1024 ? 0x1p24 : 4.0);
}

/// Whether a pair of such magnitudes needs no scaling. `r` is the magnitude of r12; `q1` and `q2` are the largest diagonal entries.
/// The result is false if r is NaN.
template <class T>
PW85_FUNCTION constexpr typename ScalarTraits<T>::Mask is_in_range(T const &r, T const &q1, T const &q2) noexcept
{
    T const limit = unscaled_limit<T>();
    T const largest = maximum(r, maximum(q1, q2));
    T const smallest = minimum(r, minimum(q1, q2));
    return largest < limit && smallest * limit > T(1);
}

/// The largest ratio of units that is kept. Beyond it the smaller ellipsoid acts as a point on the larger one, to far below the
/// precision of any scalar. The limit leaves 2^24 for t, which is of order one or a ratio of similar forms.
template <class T> PW85_FUNCTION constexpr int ratio_exponent_limit() noexcept
{
    return std::numeric_limits<typename ScalarTraits<T>::Lane>::max_exponent - 24;
}

/// Brings a pair with finite entries and positive diagonals into range. The scaling is exact.
template <class T, int D> PW85_FUNCTION inline ScaledPair<T, D> scale(Pair<T, D> const &pair) noexcept
{
    auto const &[r12, q1, q2, ratio] = pair;
    T const r = largest_coordinate(r12);
    if (is_in_range(r, largest_diagonal(q1), largest_diagonal(q2))) return {pair, 0, 0, false};
    int const er = r > T(0) ? binary_exponent(r) : 0;
    int const e1 = half_exponent(largest_diagonal(q1)), e2 = half_exponent(largest_diagonal(q2));
    // The diagonals of a pair in range are between 2^-24 and 2^24, so half their exponents differ by at most 24. Such a pair is not
    // exchanged. So scaling changes no bit of the result.
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
