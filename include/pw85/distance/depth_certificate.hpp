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

/// Returns whether item 5 proves that a quartic is positive for c > 0, from bounds from below of
/// its coefficients. They may have relative errors far below 64u.
template <class T>
PW85_FUNCTION inline typename ScalarTraits<T>::Mask is_positive(T const (&k)[5]) noexcept
{
    auto const ends = k[4] > T(0) && k[0] > T(0);
    auto proved = ends && k[3] >= T(0) && k[2] >= T(0) && k[1] >= T(0), open = ends && !proved;
    if (!any_of(open)) return proved;
    T const a = square_root(k[4]), b = square_root(k[0]), ab = a * b,
            margin = T(64 * unit_roundoff<T>());
    T const least = T(-0.53125) * minimum(T(k[3] / a), T(k[1] / b)); // makes x and y positive
    T mu = maximum(T(T(2) * square_root(ab)), least);
    for (int i = 0; i < 4; ++i) { // one is enough for most
        T const up = T(2) * a * mu, down = T(2) * b * mu;
        T const x = k[3] + up - margin * (absolute(k[3]) + up),
                y = k[1] + down - margin * (absolute(k[1]) + down);
        open = open && x > T(0) && y > T(0);
        if (!any_of(open)) return proved;
        T const root = square_root(T(x * y)), rest = T(2) * ab + mu * mu;
        auto const now =
            open && k[2] - rest + T(2) * root >= margin * (absolute(k[2]) + rest + root);
        proved = proved || now;
        open = open && !now;
        if (!any_of(open)) return proved;
        mu = (a * y + b * x) / root;
    }
    return proved;
}

/// Twice the mixed discriminant of two matrices of two rows, less a margin of 64u of the sum of
/// products. `size` is the diagonal of a semidefinite matrix that bounds the entries of `b`.
template <class T> PW85_FUNCTION inline T mixed_discriminant(SymmetricMatrix<T, 2> const &a,
                                                             SymmetricMatrix<T, 2> const &b,
                                                             Vector<T, 2> const &size) noexcept
{
    return a(0, 0) * b(1, 1) + a(1, 1) * b(0, 0) - T(2) * a(0, 1) * b(0, 1) -
           T(64 * unit_roundoff<T>()) * (a(0, 0) * size[1] + a(1, 1) * size[0]);
}

/// The matrices of item 4, in a basis across n: bounds of B1 and B2 from below and of R from above.
template <class T, int D> struct CertificateForms {
    SymmetricMatrix<T, D> b1, b2, r;
};

/// Returns whether the quartic proves item 3, or N alone, because b(t) >= tᵀ(B1 + B2)t. The
/// products in the entries of B1, B2 and R are at most those of the diagonals, because these
/// matrices are semidefinite. So the entries of N err by less than 4u of the sums of the diagonals,
/// and N is definite if its determinant exceeds 64u of their product.
template <class T> PW85_FUNCTION inline typename ScalarTraits<T>::Mask
is_inside_sum(CertificateForms<T, 2> const &forms) noexcept
{
    auto const &[b1, b2, r] = forms;
    auto const n = blend(blend(b1, T(1), b2), T(-1), r);
    Vector<T, 2> const d1{b1(0, 0), b1(1, 1)}, d2{b2(0, 0), b2(1, 1)},
        all{d1[0] + d2[0] + r(0, 0), d1[1] + d2[1] + r(1, 1)};
    T const half = T(0.5), margin = T(64 * unit_roundoff<T>()),
            determinant = n(0, 0) * n(1, 1) - n(0, 1) * n(0, 1) - margin * (all[0] * all[1]);
    auto const by_sum = n(0, 0) > margin * all[0] && determinant > T(0);
    if (all_of(by_sum)) return by_sum;
    T const k[5] = {half * mixed_discriminant(b2, b2, d2), mixed_discriminant(b2, n, all),
                    determinant + mixed_discriminant(b1, b2, d2), mixed_discriminant(b1, n, all),
                    half * mixed_discriminant(b1, b1, d1)};
    auto const definite = d1[0] > T(0) && d2[0] > T(0);
    return any_of(definite) ? by_sum || (definite && is_positive(k)) : by_sum;
}

template <class T>
PW85_FUNCTION inline bool is_inside_sum(CertificateForms<T, 1> const &forms) noexcept
{
    T const b1 = forms.b1[0], b2 = forms.b2[0], r = forms.r[0],
            slack = T(64 * unit_roundoff<T>()) * (b1 + b2 + r);
    return b1 > T(0) && b2 > T(0) && b1 + b2 - r + T(2) * square_root(T(b1 * b2)) >= slack;
}

/// The rounding errors of the points Qn/α, and the sizes √(trace Q) of the ellipsoids, from 1/α.
///
/// With √X = size/α, a point errs by at most 8uX size in plain arithmetic, and by (3 + 2√X)u size
/// if X > 1024, where the product is accurate (support.hpp). Near 1024 the larger bound is taken.
template <class T> struct PointErrors {
    TwoLanes<T> size, spread, error; ///< spread is √X
};

template <class T, int D> PW85_FUNCTION inline PointErrors<T>
point_errors(SymmetricMatrix<TwoLanes<T>, D> const &q, TwoLanes<T> const &inverses) noexcept
{
    using Two = TwoLanes<T>;
    auto const size = square_root(trace(q)), spread = size * inverses;
    auto const growth = select(Two(T(33)) < spread, spread, Two(spread * spread));
    return {size, spread, Two(T(9 * unit_roundoff<T>())) * growth * size};
}

/// The bound of B of both ellipsoids from below, in the basis of the tangents.
///
/// An entry of Q errs by less than 20u trace Q (two products, and the errors of the tangents), one
/// of ppᵀ by less than 2|p| error + error² + 20u|p|², and |p|² <= trace Q. The eigenvalues of a
/// matrix of two rows err by at most twice as much.
template <class T, int D> PW85_FUNCTION inline SymmetricMatrix<TwoLanes<T>, D - 1>
curvatures_below(SymmetricMatrix<TwoLanes<T>, D> const &q, DirectionState<T, D> const &at,
                 Vector<T, D> const (&tangents)[std::size_t(D - 1)],
                 PointErrors<T> const &points) noexcept
{
    using Two = TwoLanes<T>;
    auto const margin =
        points.size * (Two(T(128 * unit_roundoff<T>())) * points.size + Two(T(8)) * points.error);
    SymmetricMatrix<Two, D - 1> b{};
    for (int i = 0; i < D - 1; ++i) {
        auto const tangent = converted<Two>(tangents[i]), column = product(q, tangent);
        auto const along = at.inverses * dot(tangent, at.products);
        for (int j = 0; j <= i; ++j) {
            auto const other = converted<Two>(tangents[j]);
            b(j, i) = dot(other, column) - along * dot(other, at.products);
        }
        b(i, i) = b(i, i) - margin;
    }
    return b;
}

/// One of two matrices side by side.
template <class T, int D> PW85_FUNCTION inline SymmetricMatrix<T, D>
first_of(SymmetricMatrix<TwoLanes<T>, D> const &a) noexcept
{
    SymmetricMatrix<T, D> first{};
    for (int k = 0; k < a.size; ++k) first[k] = first_of(a[k]);
    return first;
}

template <class T, int D> PW85_FUNCTION inline SymmetricMatrix<T, D>
second_of(SymmetricMatrix<TwoLanes<T>, D> const &a) noexcept
{
    SymmetricMatrix<T, D> second{};
    for (int k = 0; k < a.size; ++k) second[k] = second_of(a[k]);
    return second;
}

/// Computes the directions orthogonal to the unit vector n: the columns of the reflection that
/// exchanges n and the last axis. Their errors are below (1 + 4√2)u. Those of fill_tangents(),
/// which chooses an axis, are below (1 + 3.2)u.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline void
fill_tangents_by_last_axis(Vector<T, D> const &n,
                           Vector<T, D> (&tangents)[std::size_t(D - 1)]) noexcept
{
    T const &pole = n[D - 1];
    T const size = T(1) + absolute(pole);
    Vector<T, D> v = n;
    v[D - 1] = pole + select(pole < T(0), T(-1), T(1));
    for (int i = 0; i < D - 1; ++i) {
        tangents[i] = T(-n[i] / size) * v;
        tangents[i][i] = tangents[i][i] + T(1);
    }
}

/// Returns whether the certificate proves that no direction needs less than the best shift, minus
/// twice its rounding error ρ. `at` is the state from which follow_normal() has found the best
/// direction, whose last correction is not in it.
///
/// d0 is within 1.5ρ of the best shift. So δ is between ρ/2 and 7ρ/2, σ is at most ℓ times the best
/// shift plus 5ρℓ, and |e|² <= 2(δ²|P|² + ℓ²|w|²) gives |e|²/(δ(2ℓ - δ)) <= 7ρ|P|²/ℓ + 4ℓ|w|²/ρ for
/// 7ρ <= 2ℓ. α and β have a relative error below 106,496 u (support.hpp), which a factor of 1 +
/// 2^18 u covers. f errs by η <= 4ρ|r| + 2ℓ times the error of w. So ffᵀ is at most (1 + 2^-9)ffᵀ +
/// 2^10 η² I with the computed f.
template <class T, int D> PW85_FUNCTION inline typename ScalarTraits<T>::Mask
is_certified(DepthSearch<T, D> const &search, DirectionState<T, D> const &at) noexcept
{
    auto const &r12 = search.r12;
    auto const &q1 = search.q1, &q2 = search.q2;
    Shift<T> const &best = search.best;
    Vector<T, D> const n = at.scale * at.n;
    T const u = T(unit_roundoff<T>()), rho = best.rounding, d = best.length - T(2) * rho;
    auto const touches = !(d > T(0)); // the pair overlaps: all shifts are positive
    if (all_of(touches)) return touches;
    auto const q = side_by_side(q1, q2);
    T const l = sum_of_lanes(at.extents) * at.scale, distance = sum_of_magnitudes(r12),
            h = dot(n, r12) - T(8) * u * distance - rho;
    auto const points =
        point_errors(q, TwoLanes<T>(TwoLanes<T>(T(dot(at.n, at.n) * at.scale)) * at.factors));
    T const spread = maximum(first_of(points.spread), second_of(points.spread));
    auto const is_clear =
        h > T(0) && T(7) * rho <= T(2) * l && spread * spread <= largest_spread<T>();
    if (!any_of(is_clear)) return touches;
    Vector<T, D> const off = project(off_surface(at, r12), n);
    T const reach = sum_of_lanes(points.size) + distance,
            error = sum_of_lanes(points.error) + T(16) * u * reach,
            w = square_root(dot(off, off)) + error, eta = T(4) * rho * distance + T(2) * l * error;
    T const inverse = T(1) / (d * h), factor = T(1) + T(0x1p18 * u);
    T const diagonal =
        factor * ((best.length + T(5) * rho) * l + T(7) * rho * reach * reach / l +
                  T(4) * l * (w * w) / rho + T(2) * w * reach + T(2048) * (eta * eta) * inverse);
    Vector<T, D> tangents[std::size_t(D - 1)];
    fill_tangents_by_last_axis(n, tangents);
    auto const below = curvatures_below(q, at, tangents, points);
    CertificateForms<T, D - 1> forms{first_of(below), second_of(below), {}};
    Vector<T, D - 1> f{};
    for (int i = 0; i < D - 1; ++i) {
        f[i] = best.length * dot(tangents[i], r12) - l * dot(tangents[i], off);
        for (int j = 0; j <= i; ++j)
            forms.r(j, i) = (factor + negative_power_of_two<T>(9)) * inverse * f[i] * f[j];
        forms.r(i, i) = forms.r(i, i) + diagonal;
    }
    return touches || (is_clear && is_inside_sum(forms));
}

} // namespace pw85::detail

#endif
