// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The area of a segment of a circle: the part that a chord cuts off. section.hpp calls
/// circular_segment(), for the arcs of both ellipses: an affine map takes an arc of an ellipse to
/// an arc of a circle.
///
/// Let R be the radius, α half of the angle of the arc, and c = 2 R sin α the chord. The area of
/// the segment is R² p(α) with
///
/// 1. p(α) = α - sin α cos α = 2 sin³α Σ C(2n, n)/4ⁿ sin²ⁿα/(2n + 3) for α <= π/2;
/// 2. p(α) = 2 p(α/2) + 2 w sin α with w = sin²(α/2): the triangle of the chord and the middle of
///    the arc, and a segment on each of its other sides.
///
/// All terms are positive, so the relative error is a few u for arcs of any length, from the
/// thinnest lens to a whole circle.
#ifndef PW85_VOLUME_CIRCULAR_SEGMENT_HPP_INCLUDED
#define PW85_VOLUME_CIRCULAR_SEGMENT_HPP_INCLUDED

#include <pw85/algebra/scalar.hpp>

namespace pw85::detail {

/// The arc by its angle α: sin α >= 0 and cos α.
template <class T> struct HalfAngle {
    T sine, cosine;
};

/// α/2. If α is near π, cos(α/2) is small, and follows from sin α.
template <class T> PW85_FUNCTION inline HalfAngle<T> halved(HalfAngle<T> const &a) noexcept
{
    T const half = T(0.5);
    T const larger = square_root(T(half * T(T(1) + absolute(a.cosine)))),
            smaller = T(half * T(a.sine / larger));
    return a.cosine > T(0) ? HalfAngle<T>{smaller, larger} : HalfAngle<T>{larger, smaller};
}

/// The largest sin²α for which the series are summed. Each term is then smaller than the one before
/// it by a factor of 2⁻⁴.
template <class T> PW85_FUNCTION constexpr T largest_square_of_series() noexcept
{
    return negative_power_of_two<T>(4);
}

/// The coefficients C(2n, n)/4ⁿ/(2n + 3) for n = 1, 2, …: as many terms as the digits of T require.
template <class T> struct SegmentSeries {
    static constexpr int terms = mantissa_digits<T>() / 4 + 1;
    T coefficients[std::size_t(terms)];
};

template <class T> PW85_FUNCTION constexpr SegmentSeries<T> segment_series() noexcept
{
    SegmentSeries<T> series{};
    T coefficient = T(1);
    for (int n = 1; n <= series.terms; ++n) {
        coefficient = T(coefficient * T(2 * n - 1)) / T(2 * n);
        series.coefficients[n - 1] = coefficient / T(2 * n + 3);
    }
    return series;
}

/// Sums even and odd powers separately: two short chains of dependent operations are faster than a
/// long one.
template <class T>
PW85_FUNCTION inline T sum_of_series(SegmentSeries<T> const &series, T const &x) noexcept
{
    T const square = T(x * x);
    T sums[2] = {T(0), T(0)};
    for (int n = series.terms - 1; n >= 0; --n)
        sums[n % 2] = T(sums[n % 2] * square) + series.coefficients[n];
    return sums[0] + x * sums[1];
}

/// Σ_{n>=1} C_n xⁿ⁻¹/(2n + 3) for x <= 2⁻⁴. The compiler computes the coefficients of a native
/// type.
template <class T> PW85_FUNCTION inline T sum_of_segment_series(T const &x) noexcept
{
    if constexpr (std::is_floating_point_v<T>) {
        constexpr auto series = segment_series<T>();
        return sum_of_series(series, x);
    } else {
        return sum_of_series(segment_series<T>(), x);
    }
}

/// The area of a segment of a circle of this radius over a chord: sin α is half the chord over the
/// radius. A short arc of a huge circle keeps all numbers near the size of its chord. For sin²α <=
/// 2⁻⁴ the series of item 1 is 2 sin³α (1/3 + x Σ_{n>=1} C_n xⁿ⁻¹/(2n + 3)) with x = sin²α.
template <class T> PW85_FUNCTION inline T circular_segment(T const &half_chord, T const &radius,
                                                           T const &cosine) noexcept
{
    constexpr int most = 8;
    HalfAngle<T> angles[most + 1];
    angles[0] = {half_chord / radius, cosine};
    int n = 0;
    while (n < most && !(angles[n].cosine > T(0) &&
                         T(angles[n].sine * angles[n].sine) <= largest_square_of_series<T>())) {
        angles[n + 1] = halved(angles[n]);
        ++n;
    }
    T const s = angles[n].sine, x = T(s * s);
    T const series = T(2) * T(T(T(1) / T(3)) + x * sum_of_segment_series(x));
    if (n == 0) return T(T(series * T(half_chord * half_chord)) * s);
    T p = T(series * T(x * s));
    for (int k = n - 1; k >= 0; --k)
        p = T(2) * T(p + T(angles[k + 1].sine * angles[k + 1].sine) * angles[k].sine);
    return T(p * T(radius * radius));
}

} // namespace pw85::detail

#endif
