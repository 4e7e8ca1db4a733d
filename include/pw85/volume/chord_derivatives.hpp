// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The derivatives of the area of the intersection of two ellipses by the chords of chord_area.hpp.
/// overlap_area_derivatives.hpp uses them where it is certain that their errors are within the
/// bound.
///
/// Let x·p = d b be the line of a chord in space, with b² = xᵀQx of the circle's form, d the
/// distance of the chord and s half of its length in units of the circle, w² = xᵀQx of the other
/// form, and γ the cosine of half of the angle of its segment.
///
/// 1. ∫ n ds along an arc equals ∫ n ds along its chord: 2s √det Q x/b, with Q the form of the
///    circle.
/// 2. In the metric of its body, an arc with the half angle α about the unit vector m has ∫ n nᵀ ds
///    = (α - sin α cos α) I + 2 sin α cos α m mᵀ: the area of its segment, and its chord. In space
///    I is Q⁻¹ and m mᵀ is x xᵀ/(xᵀQx). ∂A/∂Q is the integral times ½ √det Q.
/// 3. The arc of the circle with the normal -m has the same area and chord as the whole circle
///    without the one with m. So each chord has the part -s d of the circle and s γ b/w of the
///    other body: both bodies have the same chord.
#ifndef PW85_VOLUME_CHORD_DERIVATIVES_HPP_INCLUDED
#define PW85_VOLUME_CHORD_DERIVATIVES_HPP_INCLUDED

#include <pw85/volume/chord_area.hpp>

namespace pw85::detail {

/// The derivatives with respect to r12 and to both forms as matrices, and a flag: true if it is
/// certain that their errors are within the bound.
template <class T> struct ChordDerivatives {
    Vector<T, 2> r12;
    SymmetricMatrix<T, 2> q1, q2;
    bool certain;
};

/// The largest number of c and G times 1 + |l10|/l11 for which chords give the derivatives. c and G
/// err by up to 4u times this, 64u, because l10 c0 is subtracted from a coordinate that is then
/// divided by l11. The bound for all errors is 256u times the area of the circle, which is 804u.
inline constexpr double largest_number_of_chords = 16.0;

template <class T> PW85_FUNCTION inline bool are_numbers_accurate(CirclePair<T> const &p) noexcept
{
    T const center = maximum(absolute(p.center[0]), absolute(p.center[1])),
            other = maximum(maximum(p.g00, absolute(p.g10)), p.g11),
            skew = T(T(1) + absolute(T(p.l10 * p.inverse_l11)));
    return T(maximum(center, other) * skew) <= T(largest_number_of_chords);
}

/// The largest distance of a crossing from the line of its chord for which chords give the
/// derivatives, in units of u s. An end that is η from the line moves along the circle by η/s. So
/// both ends change the sum of the chords by up to 128u for each chord. The bound for all errors is
/// 804u.
inline constexpr double largest_shift_of_chord = 64.0;

/// If the ends of the two chords on the line differ by ε, the crossing is ε/ρ from the line
/// (SharedChord).
template <class T> PW85_FUNCTION inline bool is_line_accurate(SharedChord<T> const &c) noexcept
{
    T const limit = T(T(largest_shift_of_chord * unit_roundoff<T>()) * c.half);
    auto const end = [&](int k) {
        return absolute(c.mismatch[k]) <= T(limit * absolute(c.slope[k]));
    };
    return end(0) && end(1);
}

/// Adds the contributions of a chord: that of the circle to q1, that of the other body to q2.
template <class T> PW85_FUNCTION inline void
add_chord(ChordDerivatives<T> &sum, CirclePair<T> const &p, SharedChord<T> const &c) noexcept
{
    auto const x = direction_in_space(p, c.normal);
    T const half = T(T(c.half * p.area) / c.unit), circle = T(T(half * c.distance) / c.unit),
            other = T(T(half * c.cosine) / c.width);
    for (int i = 0; i < 2; ++i) {
        sum.r12[i] = sum.r12[i] + T(T(half + half) * x[i]);
        for (int j = i; j < 2; ++j) {
            T const square = T(x[i] * x[j]);
            sum.q1(i, j) = sum.q1(i, j) - T(circle * square);
            sum.q2(i, j) = sum.q2(i, j) + T(other * square);
        }
    }
    sum.certain = sum.certain && is_line_accurate(c);
}

/// ½ a √det Q Q⁻¹, with the area a of segments in units of the area of the body over π.
template <class T> PW85_FUNCTION inline SymmetricMatrix<T, 2>
part_of_segments(SymmetricMatrix<T, 2> const &q, T const &root, T const &segments) noexcept
{
    return T(T(T(0.5) * segments) / root) * adjugate(q);
}

/// Computes the derivatives. The pair must overlap and pass the fast checks.
template <class T>
PW85_FUNCTION inline ChordDerivatives<T> chord_derivatives(Vector<T, 2> const &r12,
                                                           SymmetricMatrix<T, 2> const &q1,
                                                           SymmetricMatrix<T, 2> const &q2) noexcept
{
    auto const p = circle_pair(r12, q1, q2);
    if (!are_numbers_accurate(p)) return {};
    auto const c = common_chords(p);
    if (!c.certain) return {};
    ChordDerivatives<T> d{{},
                          part_of_segments(p.ball, p.area, c.kept),
                          part_of_segments(p.other, T(p.area * T(p.g00 * p.g11)), c.caps),
                          true};
    add_chord(d, p, c.first);
    if (c.two) add_chord(d, p, c.second);
    if (p.swapped) return {-d.r12, d.q2, d.q1, d.certain};
    return d;
}

} // namespace pw85::detail

#endif
