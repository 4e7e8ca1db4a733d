// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The area of the common part of two ellipses by one or two chords: the fast way, without a
/// branch on data, for numbers and for packs of lanes. overlap_volume.hpp takes it where it is
/// accurate for certain, and crossings (section.hpp) elsewhere. src/simd/lanes/two_dimensions.hpp
/// computes many rows.
///
/// A joint linear map makes the smaller ellipse the unit circle about 0. The other one is c + G z
/// with |z| <= 1. With homogeneous coordinates the bodies are B(X, X) <= 0 with B = diag(1, 1, -1)
/// and A(X, X) <= 0, as in rim_axis.hpp. Where A - tB is singular it is a pair of lines through the
/// crossings, which have the chords. No rounding error of t or of the lines needs a bound of its
/// own: see is_close().
#ifndef PW85_VOLUME_CHORD_AREA_HPP_INCLUDED
#define PW85_VOLUME_CHORD_AREA_HPP_INCLUDED

#include <pw85/algebra/error_free.hpp>
#include <pw85/overlap/containment.hpp>
#include <pw85/volume/volume.hpp>

namespace pw85::detail {

/// x·y with each product rounded. So a pack, which fuses a product and a sum elsewhere, gives the
/// bits of a number.
template <class T>
PW85_FUNCTION inline T rounded_dot(Vector<T, 2> const &x, Vector<T, 2> const &y) noexcept
{
    return T(x[0] * y[0]) + T(x[1] * y[1]);
}

/// A pair of ellipses with the smaller one as the unit circle, and what leads back. The factors of
/// Cholesky give a lower triangular G, which needs no principal axes.
template <class T> struct CirclePair {
    Vector<T, 2> center;             ///< c
    T g00, g10, g11;                 ///< G
    T i00, i10, i11;                 ///< G⁻¹
    T inverse_l00, l10, inverse_l11; ///< the Cholesky factor of the circle's form
    T area;                          ///< determinant of that factor
    /// the pair (Q1, Q2) or (Q2, Q1), the circle's form first
    Vector<T, 2> r12;
    SymmetricMatrix<T, 2> ball, other;
    typename ScalarTraits<T>::Mask swapped; ///< true if it is (Q2, Q1)
};

template <class T>
PW85_FUNCTION inline CirclePair<T> circle_pair(Vector<T, 2> const &r12,
                                               SymmetricMatrix<T, 2> const &q1,
                                               SymmetricMatrix<T, 2> const &q2) noexcept
{
    T const det1 = T(q1[0] * q1[2]) - T(q1[1] * q1[1]), det2 = T(q2[0] * q2[2]) - T(q2[1] * q2[1]);
    auto const swapped = det1 > det2;
    CirclePair<T> p{};
    p.swapped = swapped;
    for (int k = 0; k < 3; ++k) {
        p.ball[k] = select(swapped, q2[k], q1[k]);
        p.other[k] = select(swapped, q1[k], q2[k]);
    }
    for (int i = 0; i < 2; ++i) p.r12[i] = select(swapped, T(-r12[i]), r12[i]);
    T const l00 = square_root(p.ball[0]), k00 = square_root(p.other[0]);
    p.inverse_l00 = T(1) / l00;
    T const inverse_k00 = T(1) / k00, k10 = T(p.other[1] * inverse_k00);
    p.l10 = T(p.ball[1] * p.inverse_l00);
    T const l11 = square_root(T(p.ball[2] - T(p.l10 * p.l10))),
            k11 = square_root(T(p.other[2] - T(k10 * k10)));
    p.inverse_l11 = T(1) / l11;
    p.area = T(l00 * l11);
    p.g00 = T(k00 * p.inverse_l00);
    p.g10 = T(T(k10 - T(p.l10 * p.g00)) * p.inverse_l11);
    p.g11 = T(k11 * p.inverse_l11);
    p.i00 = T(l00 * inverse_k00);
    p.i11 = T(l11 / k11);
    p.i10 = -T(T(p.g10 * p.i00) * p.i11);
    p.center[0] = T(p.r12[0] * p.inverse_l00);
    p.center[1] = T(T(p.r12[1] - T(p.l10 * p.center[0])) * p.inverse_l11);
    return p;
}

/// Returns a root of x = z³ with a relative error below 2.2e-5 (scripts/chord_bounds.py), for a
/// positive normal number: a third of the exponent, and one step of Halley's method.
PW85_FUNCTION inline double third_of_exponent(double x) noexcept
{
    static_assert(std::numeric_limits<double>::is_iec559);
    auto const high = __builtin_bit_cast(std::uint64_t, x) >> 32;
    return __builtin_bit_cast(double, (((high * 0x55555556u) >> 32) + 0x2a9f7893u) << 32);
}

template <class T> PW85_FUNCTION inline T rough_cube_root(T const &x) noexcept
{
    T const z = third_of_exponent(x), cube = T(T(z * z) * z);
    return T(T(z * T(cube + T(x + x))) / T(T(cube + cube) + x));
}

/// The depressed cubic y³ + 3p y + 2q with y = t - mean.
template <class T> struct DepressedCubic {
    T mean, p, q;
};

/// The lowest of three roots, or the only one, before Newton's method. One root is -a + p/a with a³
/// = q + √(q² + p³) for q >= 0: the error is below 2.2e-5 (a + |p|/a). The lowest of three is
/// -2√-p cos φ with cos 3φ = q/√-p³, and cos φ is a smooth function of cos(3φ/2) =
/// √((1 + cos 3φ)/2): the error is below 4.1e-7 √-p, of which the polynomial has 4e-7.
template <class T> PW85_FUNCTION inline T rough_cubic_root(DepressedCubic<T> const &f) noexcept
{
    T const p3 = T(T(f.p * f.p) * f.p), discriminant = T(f.q * f.q) + p3;
    auto const one = discriminant > T(0);
    T single = T(0), lowest = T(0);
    if (any_of(one)) {
        T const a = rough_cube_root(
            T(absolute(f.q) + square_root(maximum(discriminant, smallest_number<T>()))));
        T const size = T(a - f.p / a);
        single = select(f.q < T(0), size, T(-size));
    }
    if (any_of(!one)) {
        T const m = square_root(maximum(T(-f.p), smallest_number<T>())),
                cosine = f.q / T(T(m * m) * m);
        T const w = square_root(maximum(T(T(0.5) + T(T(0.5) * cosine)), T(0))), w2 = T(w * w);
        // cos(⅔ arccos w) on [0, 1] to 2e-7, by interpolation at Chebyshev's points
        // (scripts/chord_bounds.py)
        T const low = T(T(0.5000001859693854) + T(T(0.5773319020745302) * w)) +
                      T(w2 * T(T(-0.11080547089782618) + T(T(0.051474763346229496) * w)));
        T const high = T(T(-0.02639974934913003) + T(T(0.010501753595596982) * w)) +
                       T(w2 * T(-0.002103491010332317));
        lowest = -T(T(m + m) * T(low + T(T(w2 * w2) * high)));
    }
    return select(one, single, lowest);
}

/// A root t of det(A - tB) = 0, t³ - (τ + 1 - g) t² + (δ + τ - δ|c|²) t - δ = 0, where τ and δ are
/// trace and determinant of G⁻ᵀG⁻¹ and g = |G⁻¹c|². There is one real root if there are two
/// crossings. If there are four, the lines of the lowest root are chords beyond which the other
/// body is inside the circle.
template <class T>
PW85_FUNCTION inline T pencil_root(T const &trace, T const &det, T const &g, T const &c2) noexcept
{
    T const third = T(1.0 / 3.0), e1 = T(trace + T(T(1) - g)), e2 = T(det + trace) - T(det * c2);
    T const mean = T(e1 * third), m2 = T(mean * mean);
    DepressedCubic<T> const f{mean, T(T(e2 * third) - m2),
                              T(T(0.5) * T(T(T(e2 * mean) - det) - T(T(2) * T(m2 * mean))))};
    T y = rough_cubic_root(f);
    for (int step = 0; step < 2; ++step) {
        T const y2 = T(y * y);
        y = y - T(T(T(T(y2 + T(T(3) * f.p)) * y) + T(f.q + f.q)) / T(T(3) * T(y2 + f.p)));
    }
    return T(f.mean + y);
}

/// A - tB, a symmetric matrix of homogeneous coordinates.
template <class T> struct LinePair {
    T m00, m01, m02, m11, m12, m22;
};

/// The null vector: the column of the adjugate with the largest diagonal entry.
template <class T> PW85_FUNCTION inline Vector<T, 3> null_vector(LinePair<T> const &m) noexcept
{
    T const a00 = T(m.m11 * m.m22) - T(m.m12 * m.m12), a11 = T(m.m00 * m.m22) - T(m.m02 * m.m02),
            a22 = T(m.m00 * m.m11) - T(m.m01 * m.m01), a01 = T(m.m02 * m.m12) - T(m.m01 * m.m22),
            a02 = T(m.m01 * m.m12) - T(m.m02 * m.m11), a12 = T(m.m01 * m.m02) - T(m.m00 * m.m12);
    T const d0 = absolute(a00), d1 = absolute(a11), d2 = absolute(a22);
    auto const second = d1 > d0;
    Vector<T, 3> const w{select(second, a01, a00), select(second, a11, a01),
                         select(second, a12, a02)};
    auto const third = d2 > maximum(d0, d1);
    return {select(third, a02, w[0]), select(third, a12, w[1]), select(third, a22, w[2])};
}

/// The polar line of w = (w0, w1, w2), where the lines meet, has the distance κ from 0 and the
/// direction ℓ, across e = (w0, w1)/|(w0, w1)|. The point κe + hζℓ with h² = 1 - κ² is on one of
/// the lines if it satisfies a quadratic equation in ζ. The sign of the derivative at `inner`, the
/// root that is nearer to 0, is that of `slope`; at `outer` it is the opposite.
template <class T> struct ChordAxis {
    Vector<T, 2> e;
    T kappa, half; ///< κ and h
    T inner, outer, slope, leading;
    typename ScalarTraits<T>::Mask two,
        clear; ///< true if both roots are in (-1, 1); true if the outer one is not near ±1
};

template <class T> PW85_FUNCTION inline ChordAxis<T> chord_axis(LinePair<T> const &m) noexcept
{
    auto const w = null_vector(m);
    T const inverse = T(1) / square_root(T(w[0] * w[0]) + T(w[1] * w[1]));
    ChordAxis<T> axis{};
    axis.e = {T(w[0] * inverse), T(w[1] * inverse)};
    axis.kappa = T(w[2] * inverse);
    axis.half = square_root(T(T(T(1) - axis.kappa) * T(T(1) + axis.kappa)));
    Vector<T, 2> const o{T(axis.kappa * axis.e[0]), T(axis.kappa * axis.e[1])},
        l{T(-T(axis.half * axis.e[1])), T(axis.half * axis.e[0])};
    Vector<T, 2> const image{T(T(m.m00 * o[0]) + T(m.m01 * o[1])) + m.m02,
                             T(T(m.m01 * o[0]) + T(m.m11 * o[1])) + m.m12};
    T const last = T(T(m.m02 * o[0]) + T(m.m12 * o[1])) + m.m22;
    T const constant = T(rounded_dot(o, image) + last), b = rounded_dot(l, image);
    T const leading = T(T(T(l[0] * l[0]) * m.m00) + T(T(l[1] * l[1]) * m.m11)) +
                      T(T(2) * T(T(l[0] * l[1]) * m.m01));
    T const root = square_root(T(T(b * b) - T(constant * leading)));
    T const sum = select(b < T(0), T(root - b), T(-T(b + root)));
    axis.slope = b;
    axis.leading = leading;
    axis.inner = constant / sum;
    axis.outer = sum / leading;
    T const excess = T(absolute(sum) - absolute(leading));
    axis.two = excess < T(0);
    axis.clear = absolute(excess) > T(negative_power_of_two<T>(16) * absolute(leading));
    return axis;
}

/// xy less its rounded value `product` (T. J. Dekker). Each step is exact: a pack gives the bits of
/// a number.
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
/// The line x·p = d counts, with x as computed: its distances from both centres in the metrics are
/// d/√(xᵀQ1x) and (d - x·r)/√(xᵀQ2x). No error of c and G, which may be huge compared with the
/// bodies, moves it. With s and v of the manual (docs/overlap_volume.rst), a chord 2s', and M² =
/// (Σ|x_i|√q_ii)², the share of s of a form is at least s'M²/W with W² = xᵀQx for a flat arc.
///
/// - A form errs by 4uM². Its chord moves by 2uM²/W, and the area changes by 4us.
/// - The root, the difference and the quotient are three roundings of a distance of at most W: 6us.
///   x·r is computed with twice the digits.
/// - Of the areas of the segments, the factors are those of forms that differ by at most
///   3u√(q_ii q_jj): 3us. All other roundings are some 10u of segments that are below v.
///
/// So 13us of 16us and 10uv of 64uv are taken.
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

/// A chord with what is beyond it: the circle's segment, which n points to, is not in the other
/// body, and the other body's segment is in the circle.
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
    // the other body's chord on the line, relative to the foot of 0
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
/// segments that the formula below gives its area. `area` is in units of the area of the circle
/// over π.
///
/// Both segments of a chord have the same line, so the area is stationary with respect to it: if
/// the ends of the two chords on the line differ by ε, the area errs by a triangle of the area
/// ½ε²/|ρ|, where ρ is the derivative of ε by a shift of the line.
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
/// H(y)/(1 + y)², and 1 + y = 2/(1 + cos α). For α > π/2 it is π less that of π - α.
template <class T> PW85_FUNCTION inline T unit_segment(T const &sine, T const &cosine) noexcept
{
    T const c = absolute(cosine), t = sine / T(T(1) + c);
    T const acute = T(T(T(T(0.25) * T(sine * sine)) * t) * segment_function(T(t * t)));
    return select(cosine < T(0), T(circle_constant<T>() - acute), acute);
}

/// Tests by the supports in two directions whether certainly neither body is inside the other one.
/// The supports are in units of the bodies: underflow is negligible beside the other errors.
template <class T> PW85_FUNCTION inline typename ScalarTraits<T>::Mask
neither_inside(Supports<T> const &a, Supports<T> const &b) noexcept
{
    auto const lower = [](T const &x, T const &error) { return maximum(T(x - error), T(0)); };
    return exceeds(T(a.other + a.other_error), lower(a.ball, a.ball_error),
                   lower(absolute(a.offset), a.offset_error)) &&
           exceeds(T(b.ball + b.ball_error), lower(b.other, b.other_error),
                   lower(absolute(b.offset), b.offset_error));
}

/// The area, and whether it is certain that it is within the bound and that there is a crossing.
template <class T> struct ChordArea {
    T area;
    typename ScalarTraits<T>::Mask certain;
};

/// The square of the smallest half of the axis in the circle. Where the ellipses nearly touch from
/// inside, crossings (section.hpp) are taken.
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

/// A - tB with the root t.
template <class T> PW85_FUNCTION inline LinePair<T> line_pair(CirclePair<T> const &p) noexcept
{
    Vector<T, 2> const &c = p.center;
    Vector<T, 2> const u{T(p.i00 * c[0]), T(p.i10 * c[0]) + T(p.i11 * c[1])};
    T const p00 = T(p.i00 * p.i00) + T(p.i10 * p.i10), p01 = T(p.i10 * p.i11),
            p11 = T(p.i11 * p.i11), det = T(T(p.i00 * p.i00) * p11);
    T const g = rounded_dot(u, u), t = pencil_root(T(p00 + p11), det, g, rounded_dot(c, c));
    return {
        T(p00 - t),        p01, -T(T(p.i00 * u[0]) + T(p.i10 * u[1])), T(p11 - t), -T(p.i11 * u[1]),
        T(T(g - T(1)) + t)};
}

/// The chords of a pair, with the areas of segments in units of both bodies: `kept` of the circle
/// and `caps` of the other body. `certain` is as in ChordArea.
template <class T> struct CommonChords {
    T kept, caps, area;
    SharedChord<T> first, second;
    typename ScalarTraits<T>::Mask two, certain;
};

/// The circle, less its segments beyond the chords, and the segments of the other body beyond them.
/// With one chord, the first two are the segment on the other side. For a pair that overlaps and
/// passes the fast checks.
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
