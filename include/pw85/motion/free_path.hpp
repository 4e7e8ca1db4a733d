// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Free path of an ellipsoid: how far it can move along a direction before it touches another
/// ellipsoid.
///
/// Ellipsoid 1 moves by x d, x >= 0, so that the separation is r - x d. The search of
/// translation.hpp finds the contact and its normal. free_by_normal(), with bounds on its rounding
/// errors, then gives a length that is certainly free, whatever the error of the search.
#ifndef PW85_MOTION_FREE_PATH_HPP_INCLUDED
#define PW85_MOTION_FREE_PATH_HPP_INCLUDED

#include <pw85/contact/contact.hpp>
#include <pw85/contact/geometry.hpp>
#include <pw85/motion/first_contact.hpp>

namespace pw85 {

/// Free path of an ellipsoid.
template <class T> struct FreePath {
    T length; ///< in units of the direction; infinity without contact
    StatusCode status;
};

} // namespace pw85

namespace pw85::detail {

/// An upper bound on √(nᵀQn). Each of the D² terms n_i Q_ij n_j undergoes 2D roundings at most, and
/// the sum of their magnitudes is at most D Σ Q_ii n_i², since |Q_ij| <= √(Q_ii Q_jj). One more u
/// covers the rounding of this bound.
template <class T, int D> PW85_FUNCTION inline T half_width_bound(SymmetricMatrix<T, D> const &q,
                                                                  Vector<T, D> const &n) noexcept
{
    T diagonal = T(0);
    for (int i = 0; i < D; ++i) diagonal = diagonal + q(i, i) * n[i] * n[i];
    T const u = T(unit_roundoff<T>()), form = maximum(T(0), dot(n, product(q, n)));
    return square_root(T(form + T(D * (2 * D + 1)) * u * diagonal)) * (T(1) + T(4) * u);
}

/// A bound on the free path by a normal n, in the units of a scaled pair and velocity -d.
///
/// Let h_k = √(nᵀQ_k n) be the half-widths along some n with n·d > 0. The ellipsoids are on
/// different sides of a plane across n while n·(r - x d) > h_1 + h_2. So there is no contact before
/// x = (n·r - h_1 - h_2)/(n·d). The largest of these bounds is the x of the contact, for the n that
/// is the normal of the tangent plane at the contact. The bound is stationary at this n, so its
/// error is of second order in the error of n. Suppose that the plane across n certainly separates
/// the ellipsoids. If n·d is certainly negative, the ellipsoids move apart; if n·d is exactly 0,
/// the plane continues to separate them. In both cases there is no contact, and the result is
/// infinity.
///
/// The bounds on the rounding errors are D u Σ|n_i r_i| for n·r, u (h_1 + h_2) for the sum of the
/// half-widths, D u Σ|n_i d_i| for n·d, and a few u for the results of the other operations.
template <class T, int D> PW85_FUNCTION inline T free_by_normal(ScaledPair<T, D> const &scaled,
                                                                Vector<T, D> const &velocity,
                                                                Vector<T, D> const &n) noexcept
{
    auto const &[r12, q1, q2, ratio] = scaled.pair;
    T const u = T(unit_roundoff<T>());
    T const fastest = T(T(D + 1) * u) * magnitude_of_dot(n, velocity) - dot(n, velocity);
    if (!(fastest >= T(0))) return infinity<T>();
    T const unit = scaled.units.mu().to_local(T(1));
    T const widths = unit * (half_width_bound(q1, n) + half_width_bound(q2, n) / ratio);
    T const gap = dot(n, r12) - widths;
    T const free = gap - u * (T(D + 1) * magnitude_of_dot(n, r12) + T(2) * widths);
    if (fastest == T(0)) return free >= T(0) ? infinity<T>() : T(0);
    return maximum(T(0), free / fastest * (T(1) - T(8) * u));
}

/// Result of the search for the contact of a translation, in the units of the caller: the normal
/// of a plane that separates the ellipsoids until they touch, or at `until` if they do not touch.
template <class T, int D> struct SeparatingPlane {
    Vector<T, D> normal;
    /// If the contact grazes: the normal before the contact is this one, less `turn` times the time
    /// until the contact, to first order. Zero otherwise.
    Vector<T, D> turn;
    T until;
    bool meets;    ///< true if the search found a contact
    bool overlaps; ///< at the start, or touches and approaches; then no plane
    StatusCode status;
};

/// A contact grazes if (n·v)² is below 2^-grazing_exponent |n|²|v|². Up to aspect ratio 10⁵, this
/// holds wherever free_before_grazing() is needed, where (n·v)² is of the order of u S vᵀM⁻¹v.
inline constexpr int grazing_exponent = 10;

/// The plane for a valid pair that is not remote.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline SeparatingPlane<T, D>
plane_of_translation(ScaledPair<T, D> const &scaled, Vector<T, D> const &velocity,
                     T const &end) noexcept
{
    auto const &[pair, units] = scaled;
    auto const &[r12, q1, q2, ratio] = pair;
    Unit const time = time_of_translation(units, velocity);
    auto const v = units.reordered((units.length / time).to_local(velocity));
    T const last = time.to_local(end);
    auto const found =
        find_translation_contact(TranslatingPair<T, D>{pair, v, tangent_in_units<T>(units)}, last);
    if (found.status != StatusCode::success) return {r12, {}, T(0), false, false, found.status};
    auto const n = solve_blend(T(1), q1, found.t, q2, add_scaled(r12, found.shown, v));
    T const closing = dot(n, v);
    Vector<T, D> turn{};
    if (closing * closing < negative_power_of_two<T>(grazing_exponent) * T(dot(n, n) * dot(v, v)))
        turn = time.to_local(solve_blend(T(1), q1, found.t, q2, v));
    bool const to_end = found.time < infinity<T>() || !(found.shown < last);
    return {units.reordered(n),
            units.reordered(turn),
            to_end ? end : time.to_caller(found.shown),
            found.time < infinity<T>(),
            !(found.time > T(0)),
            StatusCode::success};
}

/// The plane for a valid pair that is remote. It is found where the spheres around the ellipsoids
/// meet. If the spheres do not touch, the normal is zero, which means a path without contact.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline SeparatingPlane<T, D>
plane_from_afar(Pair<T, D> const &pair, Vector<T, D> const &velocity, T const &end) noexcept
{
    MovingEllipsoids<T, D> m{pair.r12, pair.q1, pair.q2, {}, {velocity, {}, T(0)}, end};
    T waited = T(0);
    for (int i = 0; i < max_translation_steps && is_remote(m.r12, m.q1, m.q2); ++i) {
        T const wait = advance_until_spheres_meet(m);
        if (!(wait < infinity<T>()))
            return {{},    {},    wait,
                    false, false, wait > T(0) ? StatusCode::success : StatusCode::no_convergence};
        waited = waited + wait;
    }
    auto plane = plane_of_translation(scale(pair_of(m.r12, m.q1, m.q2)), velocity, m.end);
    plane.until = plane.until == m.end ? end : minimum(end, T(waited + plane.until));
    return plane;
}

PW85_SHARED_BY_QUESTIONS_OF(plane_of_translation, double, 3)
PW85_SHARED_BY_QUESTIONS_OF(plane_from_afar, double, 3)

/// Computes a longer free path from normals before a grazing contact, if possible.
///
/// Where the path touches along the surface, n·d vanishes at the contact, and the rounding error ε
/// of the gap over n·d is no longer small. The plane at a time s before has n·d = κ s with κ =
/// dᵀM⁻¹d. It meets the path s/2 before the contact, less ε/(κ s). So the best s is about √(ε/κ).
/// The path then ends before the contact by about s, where μ² exceeds one by about ε. The distance
/// s/2 + ε/(κ s) that a plane leaves gives an estimate of ε, which is improved once. Every normal
/// gives a valid bound, so errors of s and of n only make the path shorter.
template <class T, int D>
PW85_FUNCTION inline T free_before_grazing(ScaledPair<T, D> const &scaled,
                                           Vector<T, D> const &velocity, Vector<T, D> const &n,
                                           Vector<T, D> const &turn, T free) noexcept
{
    T const growth = dot(turn, velocity), u = T(unit_roundoff<T>());
    if (!(growth > T(0))) return free;
    auto const &r12 = scaled.pair.r12;
    // n·d vanishes where the ellipsoids are nearest, later than the contact by n·d/κ
    T const late = dot(n, velocity) / growth, contact = late - dot(r12, turn) / growth;
    T s = maximum(T(0), late) + square_root(T(T(16) * u * magnitude_of_dot(n, r12)) / growth);
    for (int step = 0; step < 3; ++step) {
        T const found = free_by_normal(scaled, velocity, add_scaled(n, -s, turn));
        if (found > free && found < infinity<T>()) free = found;
        T const left = contact - found - T(0.5) * s;
        s = left > T(0) ? square_root(T(left * s)) : T(T(0.5) * s);
    }
    return free;
}

/// free_path() of a valid pair with r12 != 0.
template <class T, int D>
PW85_FUNCTION inline FreePath<T> free_path_of(ScaledPair<T, D> const &scaled,
                                              Pair<T, D> const &pair, Vector<T, D> const &velocity,
                                              T const &end) noexcept
{
    auto const plane = is_remote(pair.r12, pair.q1, pair.q2)
                           ? plane_from_afar(pair, velocity, end)
                           : plane_of_translation(scaled, velocity, end);
    if (plane.status != StatusCode::success) return all_nan<FreePath<T>>(plane.status);
    if (plane.overlaps) return {T(0), StatusCode::success};
    Units const &units = scaled.units;
    Unit const time = time_of_translation(units, velocity);
    auto const v = units.reordered((units.length / time).to_local(velocity)),
               n = units.reordered(plane.normal),
               turn = time.to_caller(units.reordered(plane.turn));
    T free = free_by_normal(scaled, v, n);
    // Beyond the point at which the ellipsoids are nearest, n proves nothing. Rounding can lead the
    // search there.
    if (plane.meets && !(free < infinity<T>()) && dot(turn, v) > T(0)) free = T(0);
    free = free_before_grazing(scaled, v, n, turn, free);
    T const length = time.to_caller(free);
    return {length < plane.until ? length : infinity<T>(), StatusCode::success};
}

} // namespace pw85::detail

namespace pw85 {

template <class T, int D>
PW85_FUNCTION inline FreePath<T> free_path(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                                           SymmetricMatrix<T, D> const &q2,
                                           Vector<T, D> const &direction, T const &end) noexcept
{
    using namespace detail;
    bool const valid = end >= T(0) && is_finite(direction) && largest_coordinate(direction) > T(0);
    if (!valid) return all_nan<FreePath<T>>(StatusCode::invalid_argument);
    auto const pair = pair_of(r12, q1, q2);
    ScaledPair<T, D> scaled{pair, {}};
    StatusCode const status =
        passes_fast_checks(pair) ? StatusCode::success : validate_pair(pair, scaled);
    if (status != StatusCode::success) return all_nan<FreePath<T>>(status);
    if (largest_coordinate(r12) == T(0)) return {T(0), StatusCode::success};
    return free_path_of(scaled, pair, -direction, end);
}

} // namespace pw85

#endif
