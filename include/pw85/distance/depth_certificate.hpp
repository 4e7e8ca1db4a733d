// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A certificate for penetration.hpp that a local minimum of the shift g (depth_search.hpp) is the
/// global one, from the curvatures at the minimum. It decides most pairs; depth_minimum.hpp and
/// depth_intervals.hpp prove the others.
///
/// Let n be the direction of the minimum, α, β, p1 and p2 the half-widths and the points of the
/// surfaces along it, ℓ = α + β, P = p1 + p2, d0 = g(n), and r = P - d0 n + w with w across n (at a
/// minimum w is zero). Other directions are n + m with m = z n + t, t across n. B_i is Q_i - p_i
/// p_iᵀ across n.
///
/// 1. The half-width of ellipsoid i along n + m is the length of (p_i·(n + m), √(tᵀB_it)), because
///    Q_i n is α_i p_i. By the triangle inequality
///    (α(n + m) + β(n + m))² >= (P·(n + m))² + b(t), b(t) = (√(tᵀB1t) + √(tᵀB2t))².
/// 2. No direction needs less than d = d0 - δ, δ > 0, if this is at least ((n + m)·r + d)² for all
///    unit vectors. Their difference plus σ(1 - |n + m|²), which is zero, is a function of m. With
///    σ = d0 ℓ + δ(ℓ - d0) it has no term in z alone, and is
///        δ(2ℓ - δ) + 2e·t + d h z² + 2z f·t + b(t) - tᵀ(σI + w(P + r)ᵀ)t,
///    with h = n·r = ℓ - d0 (w·n is zero), e = δP - (ℓ - δ)w and f = d0 r - ℓw, both across n.
/// 3. It is not negative if b(t) >= tᵀRt for all t, with d > 0, h > 0 and
///        R = (σ + s)I + f fᵀ/(d h), s >= |e|²/(δ(2ℓ - δ)) + |w| |P + r|.
/// 4. b(t) is the least value over c > 0 of tᵀ((1 + c)B1 + (1 + 1/c)B2)t. So item 3 holds if and
///    only if c²B1 + cN + B2, N = B1 + B2 - R, is semidefinite for all c > 0. In two dimensions
///    these are numbers, and 2√(B1B2) >= -N is to be shown. In three they are matrices of two rows.
///    B1 and B2 are definite. So it is enough that the determinant, a quartic k4, k3, ..., k0 in c,
///    is positive for c > 0.
/// 5. With a = √k4 and b = √k0, for any number μ the quartic over c² is
///        (ac + b/c - μ)² + xc + y/c + k2 - 2ab - μ², x = k3 + 2aμ, y = k1 + 2bμ.
///    So it is at least k2 - 2ab - μ² + 2√(xy) if x and y are positive. The best μ is ac + b/c at
///    c² = y/x. μ = 2√(ab) is a start, which is exact for equal ellipsoids.
#ifndef PW85_DISTANCE_DEPTH_CERTIFICATE_HPP_INCLUDED
#define PW85_DISTANCE_DEPTH_CERTIFICATE_HPP_INCLUDED

#include <pw85/distance/depth_search.hpp>

namespace pw85::detail {

/// Returns whether bounds from below of the coefficients of a quartic prove it to be positive for
/// c > 0, by item 5. The coefficients are multiples of T, with relative errors far below 64u.
template <class T> PW85_FUNCTION inline bool is_positive(T const (&k)[5]) noexcept
{
    if (!(k[4] > T(0) && k[0] > T(0))) return false;
    if (k[3] >= T(0) && k[2] >= T(0) && k[1] >= T(0)) return true;
    T const a = square_root(k[4]), b = square_root(k[0]), ab = a * b,
            margin = T(64 * unit_roundoff<T>());
    T mu = T(2) * square_root(ab);
    for (int i = 0; i < 4; ++i) {
        T const up = T(2) * a * mu, down = T(2) * b * mu;
        T const x = k[3] + up - margin * (absolute(k[3]) + up),
                y = k[1] + down - margin * (absolute(k[1]) + down);
        if (!(x > T(0) && y > T(0))) return false;
        T const root = square_root(T(x * y)), rest = T(2) * ab + mu * mu;
        T const least = k[2] - rest + T(2) * root;
        if (least >= margin * (absolute(k[2]) + rest + root)) return true;
        mu = (a * y + b * x) / root;
    }
    return false;
}

/// Twice the mixed discriminant of two matrices of two rows, less a margin of 64u of the sum of
/// products. `size` are the diagonal entries of a semidefinite matrix that bounds `b`.
template <class T> PW85_FUNCTION inline T mixed_discriminant(SymmetricMatrix<T, 2> const &a,
                                                             SymmetricMatrix<T, 2> const &b,
                                                             Vector<T, 2> const &size) noexcept
{
    return a(0, 0) * b(1, 1) + a(1, 1) * b(0, 0) - T(2) * a(0, 1) * b(0, 1) -
           T(64 * unit_roundoff<T>()) * (a(0, 0) * size[1] + a(1, 1) * size[0]);
}

/// Returns whether item 3 is proved, from matrices that bound B1 and B2 from below and R from above.
/// The magnitudes of the products in the entries are at most those of the diagonal, because B1, B2
/// and R are semidefinite.
template <class T> PW85_FUNCTION inline bool is_inside_sum(SymmetricMatrix<T, 2> const &r,
                                                           SymmetricMatrix<T, 2> const &b1,
                                                           SymmetricMatrix<T, 2> const &b2) noexcept
{
    auto const n = blend(blend(b1, T(1), b2), T(-1), r);
    Vector<T, 2> const d1{b1(0, 0), b1(1, 1)}, d2{b2(0, 0), b2(1, 1)},
        all{d1[0] + d2[0] + r(0, 0), d1[1] + d2[1] + r(1, 1)};
    T const half = T(0.5);
    T const k[5] = {half * mixed_discriminant(b2, b2, d2), mixed_discriminant(b2, n, all),
                    half * (mixed_discriminant(n, n, {T(0), T(0)}) -
                            T(128 * unit_roundoff<T>()) * (all[0] * all[1])) +
                        mixed_discriminant(b1, b2, d2),
                    mixed_discriminant(b1, n, all), half * mixed_discriminant(b1, b1, d1)};
    return d1[0] > T(0) && d2[0] > T(0) && is_positive(k);
}

template <class T> PW85_FUNCTION inline bool is_inside_sum(SymmetricMatrix<T, 1> const &r,
                                                           SymmetricMatrix<T, 1> const &b1,
                                                           SymmetricMatrix<T, 1> const &b2) noexcept
{
    if (!(b1[0] > T(0) && b2[0] > T(0))) return false;
    T const slack = T(64 * unit_roundoff<T>()) * (b1[0] + b2[0] + r[0]);
    return b1[0] + b2[0] - r[0] + T(2) * square_root(T(b1[0] * b2[0])) >= slack;
}

/// The tangents of a direction.
template <class T, int D> struct Tangents {
    Vector<T, D> t[std::size_t(D - 1)];
};

/// B of one ellipsoid less a margin for rounding errors, from the point p, which errs by less than
/// `error`.
///
/// An entry of Q across n errs by less than 16u trace Q (two products, and the errors of the
/// tangents), one of ppᵀ by less than 2|p| error + error² + 16u|p|², and |p|² <= trace Q. A
/// symmetric matrix of D - 1 rows changes by at most twice the largest error of an entry.
template <class T, int D> PW85_FUNCTION inline SymmetricMatrix<T, D - 1>
curvature_below(SymmetricMatrix<T, D> const &q, Vector<T, D> const &p, Tangents<T, D> const &frame,
                T const &size, T const &error) noexcept
{
    T const margin = T(128 * unit_roundoff<T>()) * (size * size) + T(8) * size * error;
    SymmetricMatrix<T, D - 1> b{};
    for (int i = 0; i < D - 1; ++i) {
        Vector<T, D> const column = product(q, frame.t[i]);
        T const along = dot(frame.t[i], p);
        for (int j = 0; j <= i; ++j) b(j, i) = dot(frame.t[j], column) - along * dot(frame.t[j], p);
        b(i, i) = b(i, i) - margin;
    }
    return b;
}

/// A bound of the error of the point Qn/α: 8uX times the longest semi-axis in plain arithmetic, and
/// (3 + 2√X)u times it if X > 1024, where the product is accurate (support.hpp). `size` is √(trace
/// Q), and `spread` is √X.
template <class T> PW85_FUNCTION inline T point_error(T const &size, T const &spread) noexcept
{
    T const factor = spread > T(32) ? spread : T(spread * spread);
    return T(9 * unit_roundoff<T>()) * factor * size;
}

/// Returns whether the certificate proves that no direction needs less than the best shift, minus
/// twice its rounding error ρ. `at` is the state along the best direction.
///
/// d0 is within 1.5ρ of the best shift. So δ is between ρ/2 and 7ρ/2. Then |e|² <= 2(δ²|P|² +
/// ℓ²|w|²), and |e|²/(δ(2ℓ - δ)) <= 7ρ|P|²/ℓ + 4ℓ|w|²/ρ for 7ρ <= 2ℓ. α and β have a relative error
/// below 106,496 u (support.hpp), which is covered by a factor of 1 + 2^18 u. f errs by η <= 4ρ|r| +
/// ℓ`error`, so that ffᵀ <= (1 + 2^-10)ffᵀ + 2^11 η² I with the computed f.
template <class T, int D> PW85_FUNCTION inline bool
is_certified(DepthSearch<T, D> const &search, DirectionState<T, D> const &at) noexcept
{
    auto const &[r12, q1, q2, n, best] = search;
    T const u = T(unit_roundoff<T>()), rho = best.rounding, d = best.length - T(2) * rho;
    if (!(d > T(0))) return true; // the pair overlaps, so that all shifts are positive
    T const scale = square_root(at.square), a = first_of(at.extents) / scale,
            b = second_of(at.extents) / scale, size1 = square_root(trace(q1)),
            size2 = square_root(trace(q2)), spread1 = size1 / a, spread2 = size2 / b;
    T const l = a + b, distance = sum_of_magnitudes(r12),
            h = dot(n, r12) - T(8) * u * distance - rho;
    T const spread = maximum(spread1, spread2);
    if (!(h > T(0) && T(7) * rho <= T(2) * l && spread * spread <= largest_spread<T>()))
        return false;
    T const error1 = point_error(size1, spread1), error2 = point_error(size2, spread2);
    Vector<T, D> const off = project(off_surface(at, r12), n);
    T const error = error1 + error2 + T(16) * u * (distance + size1 + size2),
            w = square_root(dot(off, off)) + error, reach = size1 + size2 + distance;
    T const eta = T(4) * rho * distance + T(2) * l * error, one = T(1) + T(0x1p18 * u), dh = d * h;
    T const diagonal =
        one * ((best.length + T(4) * rho) * l + T(7) * rho * reach * reach / l +
               T(4) * l * (w * w) / rho + w * (reach + reach) + T(2048) * (eta * eta) / dh);
    Tangents<T, D> frame;
    fill_tangents(n, frame.t);
    auto const inverse = at.extents / at.forms;
    Vector<T, D> p1{}, p2{};
    for (int i = 0; i < D; ++i) {
        auto const p = TwoLanes<T>(inverse * at.products[i]);
        p1[i] = first_of(p);
        p2[i] = second_of(p);
    }
    T const factor = (one + negative_power_of_two<T>(9)) / dh;
    T f[std::size_t(D - 1)];
    for (int i = 0; i < D - 1; ++i)
        f[i] = best.length * dot(frame.t[i], r12) - l * dot(frame.t[i], off);
    SymmetricMatrix<T, D - 1> r{};
    for (int i = 0; i < D - 1; ++i) {
        for (int j = 0; j <= i; ++j) r(j, i) = factor * f[i] * f[j];
        r(i, i) = r(i, i) + diagonal;
    }
    return is_inside_sum(r, curvature_below(q1, p1, frame, size1, error1),
                         curvature_below(q2, p2, frame, size2, error2));
}

} // namespace pw85::detail

#endif
