// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The area of the intersection of two ellipses by one or two chords. This is the fast method,
/// without a branch on data, for numbers and for packs of numbers (SIMD). overlap_volume.hpp uses
/// it where its accuracy is certain, and crossings (section.hpp) elsewhere.
/// src/simd/lanes/two_dimensions.hpp computes many rows.
///
/// The chords are on lines through the crossings; chord_axis.hpp computes the axis of these lines.
/// Rounding errors of the axis need no separate bound: see is_close().
#ifndef PW85_VOLUME_CHORD_AREA_HPP_INCLUDED
#define PW85_VOLUME_CHORD_AREA_HPP_INCLUDED

#include <pw85/algebra/error_free.hpp>
#include <pw85/algebra/unit_ball.hpp>
#include <pw85/overlap/containment.hpp>
#include <pw85/volume/chord_axis.hpp>
#include <pw85/volume/volume.hpp>

namespace pw85::detail {

/// xy minus its rounded value `product` (T. J. Dekker, Numer. Math. 18, 224, 1971). Each step is
/// exact, so the results for packs and for numbers are bitwise equal.
template <class T>
PW85_FUNCTION inline T product_error(T const &x, T const &y, T const &product) noexcept
{
    auto const a = split(x), b = split(y);
    T const error = T(T(T(a.high * b.high) - product) + T(a.high * b.low)) + T(a.low * b.high);
    return T(error + T(a.low * b.low));
}

/// A direction x = L⁻ᵀn in space: xᵀQx of both forms, x·r, and bounds on their errors, which are
/// those of shows_outside().
///
/// The line x·p = d is defined by x as computed, with its rounding errors. Its distances from both
/// centres in the metrics are d/√(xᵀQ1x) and (d - x·r)/√(xᵀQ2x). Errors of c and G, which may be
/// huge compared with the bodies, do not move the line. With s and v of the manual
/// (docs/overlap_volume.rst), a chord 2s', and M² = (Σ|x_i|√q_ii)², the share of s of a form is at
/// least s'M²/W with W² = xᵀQx for a flat arc.
///
/// - A form errs by 4uM². Its chord moves by 2uM²/W, and the area changes by 4us.
/// - The square root, the difference and the quotient are three roundings of a distance of at most
///   W: 6us. x·r is computed with twice the digits.
/// - The areas of the segments use factors of forms whose entries differ by at most 3u√(q_ii q_jj):
///   3us. All other roundings are about 10u times segments, which are below v.
///
/// The sum is 13us + 10uv. The bound on the error is 16us + 64uv.
template <class T> struct Supports {
    T ball, other, offset, offset_rest; ///< x·r is the sum of two numbers
    T ball_error, other_error, offset_error;
};

/// L⁻ᵀn.
template <class T> PW85_FUNCTION inline Vector<T, 2>
direction_in_space(CirclePair<T> const &p, Vector<T, 2> const &normal) noexcept
{
    T const x1 = T(normal[1] * p.inverse_l11);
    return {T(T(normal[0] - T(p.l10 * x1)) * p.inverse_l00), x1};
}

template <class T> PW85_FUNCTION inline Supports<T> supports(CirclePair<T> const &p,
                                                             Vector<T, 2> const &normal) noexcept
{
    auto const x = direction_in_space(p, normal);
    T const x0 = x[0], x1 = x[1];
    T const x00 = T(x0 * x0), x01 = T(T(2) * T(x0 * x1)), x11 = T(x1 * x1);
    T const form = T(2.0 * nested_form_margin * unit_roundoff<T>()),
            product = T(nested_product_margin * unit_roundoff<T>());
    T const a = T(x0 * p.r12[0]), b = T(x1 * p.r12[1]), sum = a + b, part = sum - a;
    T const rest = T(T(a - T(sum - part)) + T(b - part)) +
                   T(product_error(x0, p.r12[0], a) + product_error(x1, p.r12[1], b));
    T const ball = T(x00 * p.ball[0]) + T(x11 * p.ball[2]),
            other = T(x00 * p.other[0]) + T(x11 * p.other[2]);
    return {ball + T(x01 * p.ball[1]),
            other + T(x01 * p.other[1]),
            sum,
            rest,
            T(form * ball),
            T(form * other),
            T(product * T(absolute(a) + absolute(b)))};
}

/// A chord that both bodies share, and the segments beyond it, on the side to which n points. There
/// the segment of the circle is outside the other body, and the segment of the other body is inside
/// the circle.
///
/// The line of ζ has the unit normal n = (κζ e + hℓ)/R and the distance d = ζ/R, and half of its
/// chord is s = h√(1 - ζ²)/R, where R² = κ²ζ² + h². Nothing cancels, however short the chord.
template <class T> struct SharedChord {
    Vector<T, 2> normal, along; ///< n, and the unit vector towards w
    Supports<T> supports;
    T distance,
        half;       ///< d and s of the circle: cosine and sine of half of the angle of its segment
    T cosine, sine; ///< cosine and sine of the other body's segment, in its metric
    T mismatch[2], slope[2]; ///< ε and ρ at both ends
    T unit, width;           ///< √(xᵀQx) of both forms: 1 up to rounding, and |Gᵀn|
};

template <class T> PW85_FUNCTION inline SharedChord<T>
shared_chord(CirclePair<T> const &p, ChordAxis<T> const &axis, T const &zeta,
             typename ScalarTraits<T>::Mask const &reversed) noexcept
{
    T const kz = T(axis.kappa * zeta), h = axis.half,
            inverse = T(1) / square_root(T(T(kz * kz) + T(h * h)));
    T const sign = select(reversed, T(-inverse), inverse), a = T(kz * sign), b = T(h * sign),
            ta = T(h * inverse), tb = T(kz * inverse);
    auto const &e = axis.e;
    SharedChord<T> c{};
    c.normal = {T(a * e[0]) - T(b * e[1]), T(a * e[1]) + T(b * e[0])};
    c.along = {T(ta * e[0]) + T(tb * e[1]), T(ta * e[1]) - T(tb * e[0])};
    c.supports = supports(p, c.normal);
    auto const &x = c.supports;
    T const d = T(zeta * sign);
    c.unit = square_root(x.ball);
    c.distance = d / c.unit;
    c.half = square_root(T(T(T(1) - c.distance) * T(T(1) + c.distance)));
    c.width = square_root(x.other);
    T const inverse_width = T(1) / c.width;
    c.cosine = T(T(T(d - x.offset) - x.offset_rest) * inverse_width);
    c.sine = square_root(T(T(T(1) - c.cosine) * T(T(1) + c.cosine)));
    Vector<T, 2> const image{T(p.g00 * c.normal[0]) + T(p.g10 * c.normal[1]),
                             T(p.g11 * c.normal[1])};
    // the chord of the other body on the line, relative to the point of the line that is nearest to
    // 0
    Vector<T, 2> const m{T(image[0] * inverse_width), T(image[1] * inverse_width)},
        top{T(p.g00 * m[0]), T(p.g10 * m[0]) + T(p.g11 * m[1])};
    T const shift = rounded_dot(c.along, top), reach = T(T(p.g00 * p.g11) * inverse_width);
    T const middle = T(rounded_dot(c.along, p.center) + T(c.cosine * shift)),
            half = T(c.sine * reach);
    T const drift = T(shift * inverse_width), inverse_half = T(1) / c.half,
            turn = T(T(c.distance * inverse_half) -
                     T(T(T(c.cosine / c.sine) * reach) * inverse_width));
    c.mismatch[0] = T(middle + T(half - c.half));
    c.mismatch[1] = T(middle - T(half - c.half));
    c.slope[0] = T(drift + turn);
    c.slope[1] = T(drift - turn);
    return c;
}

/// Tests whether each triangle of a chord is below u/4 of the area, and so small compared with both
/// segments that the formula below is valid. `area` is in units of the area of the circle over π.
///
/// Both segments of a chord have the same line, so the area is stationary with respect to it: if
/// the ends of the two chords on the line differ by ε, the error of the area is a triangle of area
/// ½ε²/|ρ|, where ρ is the derivative of ε with respect to a shift of the line.
template <class T> PW85_FUNCTION inline typename ScalarTraits<T>::Mask
is_close(SharedChord<T> const &c, T const &area) noexcept
{
    T const share = T(T(0.5 * unit_roundoff<T>()) * area);
    T const sagitta = T(negative_power_of_two<T>(9) *
                        minimum(T(c.half * c.half), T(c.width * T(c.sine * c.sine))));
    auto const end = [&](int k) {
        T const epsilon = absolute(c.mismatch[k]), rho = absolute(c.slope[k]);
        return T(epsilon * epsilon) <= T(share * rho) && epsilon <= T(sagitta * rho);
    };
    return end(0) && end(1);
}

/// H(y) = (2(1 + y)² atan(t)/t - 2(1 - y))/y with t² = y, on [0, 1], by interpolation at
/// Chebyshev's points: the relative error is below 0.6u except for roundings
/// (scripts/chord_bounds.py).
template <class T> PW85_FUNCTION inline T segment_function(T const &y) noexcept
{
    constexpr double c[18] = {
        0x1.5555555555555p+2,   0x1.11111111110c5p+0,   -0x1.381381380358ep-3,
        0x1.a01a01953497ep-5,   -0x1.7a462e13192bdp-6,  0x1.975f10ca2182fp-7,
        -0x1.e8d4bedda333ap-8,  0x1.3c35b48439cafp-8,   -0x1.afdb1d55b5d28p-9,
        0x1.3190219ea7226p-9,   -0x1.b4cb905edac33p-10, 0x1.2efa602bdd32bp-10,
        -0x1.81d024143312cp-11, 0x1.a62b3ce6d6035p-12,  -0x1.70f0a09156c57p-13,
        0x1.d79df7b6756c3p-15,  -0x1.82040060941e4p-17, 0x1.2cbbee3b3a29fp-20,
    };
    T const y2 = T(y * y), y4 = T(y2 * y2), y8 = T(y4 * y4);
    auto const four = [&](int k) {
        return T(T(c[k]) + T(T(c[k + 1]) * y)) + T(y2 * T(T(c[k + 2]) + T(T(c[k + 3]) * y)));
    };
    T const low = T(four(0) + T(y4 * four(4))), high = T(four(8) + T(y4 * four(12)));
    return low + T(y8 * T(high + T(y8 * T(T(c[16]) + T(T(c[17]) * y)))));
}

/// The area α - sin α cos α of a segment of the unit circle. With t = tan(α/2) and y = t² it is t³
/// H(y)/(1 + y)², and 1 + y = 2/(1 + cos α). For α > π/2 it is π minus the area for π - α.
template <class T> PW85_FUNCTION inline T unit_segment(T const &sine, T const &cosine) noexcept
{
    T const c = absolute(cosine), t = sine / T(T(1) + c);
    T const acute = T(T(T(T(0.25) * T(sine * sine)) * t) * segment_function(T(t * t)));
    return select(cosine < T(0), T(circle_constant<T>() - acute), acute);
}

/// Tests by the supports in two directions whether it is certain that neither body is inside the
/// other one. The supports are in units of the bodies, so underflow is negligible compared with the
/// other errors.
template <class T> PW85_FUNCTION inline typename ScalarTraits<T>::Mask
neither_inside(Supports<T> const &a, Supports<T> const &b) noexcept
{
    auto const lower = [](T const &x, T const &error) { return maximum(T(x - error), T(0)); };
    return exceeds(T(a.other + a.other_error), lower(a.ball, a.ball_error),
                   lower(absolute(a.offset), a.offset_error)) &&
           exceeds(T(b.ball + b.ball_error), lower(b.other, b.other_error),
                   lower(absolute(b.offset), b.offset_error));
}

/// The area, and a flag: true if it is certain that the error of the area is within its bound and
/// that the ellipses cross.
template <class T> struct ChordArea {
    T area;
    typename ScalarTraits<T>::Mask certain;
};

/// Smallest h² for which chords are used, with half the length h of the axis inside the circle.
/// Ellipses that nearly touch from inside have a smaller one: section.hpp computes them.
inline constexpr double smallest_square_of_axis = 0x1p-6;

/// A direction across the chord between the ends of two chords, for neither_inside().
template <class T> PW85_FUNCTION inline Vector<T, 2>
side_direction(SharedChord<T> const &a, SharedChord<T> const &b) noexcept
{
    Vector<T, 2> side{};
    for (int i = 0; i < 2; ++i)
        side[i] = T(T(a.distance * a.normal[i]) + T(a.half * a.along[i])) -
                  T(T(b.distance * b.normal[i]) + T(b.half * b.along[i]));
    return {T(-side[1]), side[0]};
}

/// The chords of a pair, with the areas of segments in units of both bodies: `kept` of the circle
/// and `caps` of the other body. `certain` is as in ChordArea.
template <class T> struct CommonChords {
    T kept, caps, area;
    SharedChord<T> first, second;
    typename ScalarTraits<T>::Mask two, certain;
};

/// Computes the area of the intersection: the circle without its segments beyond the chords, plus
/// the segments of the other body beyond them. With one chord, the circle without its segment is
/// the segment on the other side. The pair must overlap and pass the fast checks.
template <class T>
PW85_FUNCTION inline CommonChords<T> common_chords(CirclePair<T> const &p) noexcept
{
    auto const axis = chord_axis(line_pair(p));
    auto const falls = axis.slope < T(0), rises = !falls;
    CommonChords<T> c{};
    c.two = axis.two;
    auto &first = c.first = shared_chord(p, axis, axis.inner, falls);
    c.kept = unit_segment(first.half, T(-first.distance));
    c.caps = unit_segment(first.sine, first.cosine);
    auto crossing = neither_inside(first.supports, first.supports);
    if (any_of(c.two)) {
        auto &second = c.second = shared_chord(p, axis, axis.outer, rises);
        c.kept = select(c.two, T(c.kept - unit_segment(second.half, second.distance)), c.kept);
        c.caps = select(c.two, T(c.caps + unit_segment(second.sine, second.cosine)), c.caps);
        auto const across = supports(p, side_direction(first, second));
        auto const apart = neither_inside(first.supports, across);
        crossing = (c.two && apart) || (!c.two && crossing);
    }
    T const area = T(c.kept + T(T(p.g00 * p.g11) * c.caps));
    c.area = area;
    auto const close = is_close(first, area) && axis.clear &&
                       (!c.two || (is_close(c.second, area) && axis.leading > T(0)));
    auto const wide = T(axis.half * axis.half) >= T(smallest_square_of_axis) &&
                      absolute(axis.inner) < T(1) && area < T(3.125);
    c.certain = close && wide && crossing;
    return c;
}

template <class T>
PW85_FUNCTION inline ChordArea<T> chord_area(Vector<T, 2> const &r12,
                                             SymmetricMatrix<T, 2> const &q1,
                                             SymmetricMatrix<T, 2> const &q2) noexcept
{
    auto const p = circle_pair(r12, q1, q2);
    auto const c = common_chords(p);
    return {T(c.area * p.area), c.certain};
}

} // namespace pw85::detail

#endif
