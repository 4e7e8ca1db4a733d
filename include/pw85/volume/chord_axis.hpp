// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The axis of the chords of two ellipses: the polar line of the point at which the lines of the
/// chords intersect. chord_area.hpp computes the area of the intersection of the ellipses from it.
/// The functions have no branch on data, and take numbers or packs of numbers (SIMD).
///
/// A joint linear map makes the smaller ellipse the unit circle about 0. The other one is c + G z
/// with |z| <= 1. With homogeneous coordinates the bodies are B(X, X) <= 0 with B = diag(1, 1, -1)
/// and A(X, X) <= 0, as in rim_axis.hpp. Where A - tB is singular, it describes a pair of lines
/// through the crossings. The chords are on these lines.
#ifndef PW85_VOLUME_CHORD_AXIS_HPP_INCLUDED
#define PW85_VOLUME_CHORD_AXIS_HPP_INCLUDED

#include <pw85/algebra/elementary.hpp>
#include <pw85/algebra/symmetric.hpp>

namespace pw85::detail {

/// x·y with each product rounded. Elsewhere packs fuse a product and a sum; here the results for
/// packs and for numbers are bitwise equal.
template <class T>
PW85_FUNCTION inline T rounded_dot(Vector<T, 2> const &x, Vector<T, 2> const &y) noexcept
{
    return T(x[0] * y[0]) + T(x[1] * y[1]);
}

/// A pair of ellipses with the smaller one as the unit circle, and the map back to the given pair.
/// Cholesky factors give a lower triangular G, so no principal axes are needed.
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

} // namespace pw85::detail

#endif
