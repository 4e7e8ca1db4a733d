// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A number or a point that proves the answer of the overlap test. pw85.hpp and the C API use this
/// file. It calls overlap.hpp for the answer, extended numbers for candidates, and integers for the
/// proof (exact_witness.hpp).
///
/// 1. f is concave. So if f(λ) > 1 for any number λ of the type, then f > 1 also at one of the two
///    numbers next to the maximiser. The maximiser computed with extended numbers errs by far less
///    than half the spacing of numbers. The maximiser, rounded, and its two neighbours are tried.
/// 2. The point x0 of the maximiser is as deep inside ellipsoid 1 as inside ellipsoid 2, relative
///    to the sizes of both. Near contact the intersection is a thin lens about x0 in the common
///    tangent plane, and x0 may leave the lens when it is rounded. In that case the points of a
///    lattice about x0 are tried. One coordinate is computed from the others, so that the point is
///    as near as possible to the plane. Points within the thickness of the lens are tested in
///    integers.
#ifndef PW85_OVERLAP_WITNESS_HPP_INCLUDED
#define PW85_OVERLAP_WITNESS_HPP_INCLUDED

#include <pw85/algebra/all_nan.hpp>
#include <pw85/contact/contact.hpp>
#include <pw85/contact/geometry.hpp>
#include <pw85/overlap/exact_witness.hpp>
#include <pw85/overlap/overlap.hpp>

namespace pw85 {

/// A witness that two ellipsoids overlap, or that they are apart.
template <class T, int D> struct OverlapWitness {
    bool overlap;
    T lambda; ///< a λ with f > 1, if they are apart
    /// unit normal of a plane that separates them to rounding, from 1 to 2, if they are apart
    Vector<T, D> direction;
    /// a point inside both, relative to the centre of ellipsoid 1, if they overlap
    Vector<T, D> point;
    StatusCode status;
};

} // namespace pw85

namespace pw85::detail {

/// Returns whether floating-point numbers show that f(λ) > 1. The t of λ has two roundings, and log
/// f changes by no more than log t does.
template <class T, int D> PW85_FUNCTION inline bool
exceeds_one_clearly(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                    SymmetricMatrix<T, D> const &q2, T const &lambda) noexcept
{
    if (!(lambda > T(0) && lambda < T(1)) || !passes_fast_checks(r12, q1, q2)) return false;
    T const t = lambda / T(T(1) - lambda);
    if (!(t * unscaled_limit<T>() > T(1) && t < unscaled_limit<T>())) return false;
    auto e = evaluate_quartic(Pair<T, D>{r12, q1, q2, T(1)}, t);
    e.b = e.b + T(T(4) * T(unit_roundoff<T>())) * e.diagonal;
    return shows_apart(e, t);
}

/// The maximum of f from extended numbers, rounded to numbers of the type.
template <class T, int D> struct PreciseMaximum {
    T lambda;                   ///< rounded
    T below_one;                ///< 1 - μ², rounded
    Vector<T, D> point, offset; ///< x0, rounded, and the rounding error of x0
    Vector<T, D> normal;        ///< the common normal at contact, of any length
};

/// The number of Halley's steps after those of the search. Each leaves an error in log t of about
/// the cube of the error before. The search ends with at most 2^-15, and three steps leave less
/// than 2^-300.
inline constexpr int steps_to_all_digits = 3;

/// The maximiser t of a pair, to all digits of the type W, by a search that starts at `guess`.
template <class W, int D> [[gnu::noinline]] PW85_FUNCTION inline W
precise_maximiser(Pair<W, D> const &pair, W const &guess) noexcept
{
    Candidate<W> candidate{guess, W(1), W(0)};
    int evaluations = 0;
    search(pair, candidate, Precision::working, evaluations);
    W t = candidate.t;
    for (int n = 0; n < steps_to_all_digits; ++n) {
        auto const factors = factorize_blend(W(1), pair.q1, t, pair.q2);
        auto const s = slope(evaluate_jet(pair, factors, solve(factors, pair.r12)), pair.ratio, t);
        t = t * exponential(halley_step(s));
    }
    return t;
}

/// x·2^exponent.
template <class T> PW85_FUNCTION inline exact::Extended<T> scaled_by(exact::Extended<T> const &x,
                                                                     int exponent) noexcept
{
    return with_exponent(x, x.exponent + exponent);
}

/// Computes the maximum with extended numbers, for a valid pair with r12 != 0.
template <class T, int D> PW85_RARE PreciseMaximum<T, D>
maximize_precisely(ScaledPair<T, D> const &scaled, Vector<T, D> const &r12) noexcept
{
    using W = exact::Extended<T>;
    auto const pair = widened<W>(scaled.pair);
    W const t = precise_maximiser(pair, initial_guess(pair)), tau = pair.ratio * pair.ratio * t,
            complement = W(1) / (W(1) + tau);
    auto const s = solve(factorize_blend(W(1), pair.q1, t, pair.q2), pair.r12),
               x = product(pair.q1, s);
    W const mu2 = scaled_by(tau * complement * dot(pair.r12, s), 2 * scaled.units.mu().exponent);
    PreciseMaximum<T, D> result{rounded(scaled.units.swapped ? complement : tau * complement),
                                rounded(W(1) - mu2),
                                {},
                                {},
                                {}};
    for (int i = 0; i < D; ++i) {
        W const relative = scaled_by(x[i], scaled.units.length.exponent),
                coordinate = scaled.units.swapped ? W(r12[i]) + relative : relative;
        result.point[i] = rounded(coordinate);
        result.offset[i] = rounded(coordinate - W(result.point[i]));
        result.normal[i] = rounded(s[i]);
    }
    return result;
}

/// The distance from |x| to the next larger number.
template <class T> PW85_FUNCTION inline T spacing(T const &x) noexcept
{
    using Limits = std::numeric_limits<T>;
    int const exponent = x == T(0) ? Limits::min_exponent - 1 : binary_exponent(absolute(x));
    return times_power_of_two(T(1),
                              maximum(exponent + 1, int{Limits::min_exponent}) - Limits::digits);
}

/// The decision by extended numbers whether f(λ) > 1. If M is scaled to a unit diagonal, its
/// determinant is above 2^-214 for double, so f errs by less than 2^-150 of itself. For float these
/// numbers are 2^-98 and 2^-80. The margins are 2^-79 and 2^-36.
template <class T, int D>
PW85_RARE Decision decide_by_extended(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                                      SymmetricMatrix<T, D> const &q2, T const &lambda) noexcept
{
    using W = exact::Extended<T>;
    W const margin(negative_power_of_two<T>(3 * mantissa_digits<T>() / 2));
    W const f = evaluate_f(W(lambda), converted<W>(r12), converted<W>(q1), converted<W>(q2));
    return to_decision(f > W(1) + margin, f < W(1) - margin);
}

PW85_RARE_TIER_OF(maximize_precisely, double, 3)
PW85_RARE_TIER_OF(decide_by_extended, double, 3)

/// Returns whether f(λ) > 1. Extended numbers decide all pairs whose bounding boxes are apart by a
/// factor of two. Integers decide the rest.
template <class T, int D>
PW85_FUNCTION inline bool exceeds_one(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                                      SymmetricMatrix<T, D> const &q2, T const &lambda) noexcept
{
    if (!(lambda > T(0) && lambda < T(1))) return false;
    Decision const decision = decide_by_extended(r12, q1, q2, lambda);
    return decision == Decision::apart ||
           (decision == Decision::none && exceeds_one_exactly(r12, q1, q2, lambda));
}

/// A λ with f(λ) > 1, or NaN if none is found, for a valid pair with r12 != 0. It also tries half a
/// spacing below the maximiser, because below a power of two the spacing of numbers is half as
/// large.
template <class T, int D>
PW85_FUNCTION inline T find_lambda(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                                   SymmetricMatrix<T, D> const &q2, T const &guess,
                                   ScaledPair<T, D> const &scaled) noexcept
{
    if (exceeds_one_clearly(r12, q1, q2, guess)) return guess;
    T const best = maximize_precisely(scaled, r12).lambda, step = spacing(best),
            half = T(0.5) * step;
    T const tried[] = {best, T(best - half), T(best - step), T(best + step)};
    for (T const &lambda : tried)
        if (exceeds_one(r12, q1, q2, lambda)) return lambda;
    return quiet_nan<T>();
}

/// Returns whether a point is inside both ellipsoids.
template <class T, int D>
PW85_FUNCTION inline bool is_inside_both(Vector<T, D> const &x, Vector<T, D> const &r12,
                                         SymmetricMatrix<T, D> const &q1,
                                         SymmetricMatrix<T, D> const &q2) noexcept
{
    return is_finite(x) && is_inside_exactly(x, Vector<T, D>{}, q1) &&
           is_inside_exactly(x, r12, q2);
}

/// The size of the lattice of item 2: the number of points on either side of x0 along each axis,
/// and the largest number of points that are tested in integers.
inline constexpr int lattice_reach = 20, max_lattice_points = 256;

/// The axis along which the coordinate is computed from the others. Of the axes along which the
/// normal is not small, it is the one on which the spacing of numbers moves a point least across
/// the plane.
template <class T, int D>
PW85_FUNCTION inline int axis_across(PreciseMaximum<T, D> const &at) noexcept
{
    int best = -1;
    T const largest = largest_coordinate(at.normal);
    auto const shift = [&](int i) { return T(absolute(at.normal[i]) * spacing(at.point[i])); };
    for (int i = 0; i < D; ++i)
        if (T(T(8) * absolute(at.normal[i])) >= largest && (best < 0 || shift(i) < shift(best)))
            best = i;
    return best;
}

/// The distance from x0 to the plane of the lattice, times the length of the normal. Along the
/// normal the lens reaches from x0 as far as 1 - μ times the half-width of either ellipsoid. The
/// plane is in the middle of the lens, but at most a few spacings from x0, because needles that
/// cross have a narrow lens.
template <class T, int D> PW85_FUNCTION inline T plane_of_lattice(PreciseMaximum<T, D> const &at,
                                                                  Vector<T, D> const &r12) noexcept
{
    T middle = T(0), limit = T(0);
    for (int i = 0; i < D; ++i) {
        middle = middle + at.normal[i] * (at.point[i] - T(0.5) * r12[i]);
        limit = limit + T(4) * absolute(at.normal[i]) * spacing(at.point[i]);
    }
    return minimum(limit, maximum(T(-limit), T(T(0.5) * at.below_one * middle)));
}

/// A point of the lattice, and its distance from the plane times the length of the normal. Points
/// are counted from the middle of the lattice.
template <class T, int D> struct LatticePoint {
    Vector<T, D> x;
    T distance;
};

template <class T, int D> PW85_FUNCTION inline LatticePoint<T, D>
lattice_point(PreciseMaximum<T, D> const &at, T const &plane, int across, int index) noexcept
{
    LatticePoint<T, D> p{at.point, T(0)};
    T const finest = T(spacing(largest_coordinate(at.point)) * T(unit_roundoff<float>()));
    T sum = -plane;
    for (int i = 0; i < D; ++i) {
        if (i == across) continue;
        int const place = index % (2 * lattice_reach + 1),
                  steps = place % 2 == 0 ? place / 2 : -(place + 1) / 2;
        index /= 2 * lattice_reach + 1;
        p.x[i] = at.point[i] + T(steps) * maximum(spacing(at.point[i]), finest);
        sum = sum + at.normal[i] * ((p.x[i] - at.point[i]) - at.offset[i]);
    }
    T const wanted = at.offset[across] - sum / at.normal[across];
    p.x[across] = at.point[across] + wanted;
    p.distance = absolute(T(((p.x[across] - at.point[across]) - wanted) * at.normal[across]));
    return p;
}

/// A point inside both ellipsoids near x0, or NaN if none is found. The lens is thinner than 1 - μ²
/// times r12 along the normal.
template <class T, int D> PW85_FUNCTION inline Vector<T, D>
search_lens(PreciseMaximum<T, D> const &at, Vector<T, D> const &r12,
            SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2) noexcept
{
    T const thickness = at.below_one * magnitude_of_dot(at.normal, r12),
            plane = plane_of_lattice(at, r12);
    int const across = axis_across(at), side = 2 * lattice_reach + 1,
              count = D == 3 ? side * side : side;
    for (int index = 0, tried = 0; across >= 0 && index < count && tried < max_lattice_points;
         ++index) {
        auto const p = lattice_point(at, plane, across, index);
        if (!(p.distance < thickness)) continue;
        ++tried;
        if (is_inside_both(p.x, r12, q1, q2)) return p.x;
    }
    Vector<T, D> none{};
    set_nan(none);
    return none;
}

/// A point inside both ellipsoids, or NaN if none is found, for a valid pair with r12 != 0.
template <class T, int D> PW85_FUNCTION inline Vector<T, D>
find_point(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
           SymmetricMatrix<T, D> const &q2, Vector<T, D> const &guess,
           ScaledPair<T, D> const &scaled) noexcept
{
    return is_inside_both(guess, r12, q1, q2)
               ? guess
               : search_lens(maximize_precisely(scaled, r12), r12, q1, q2);
}

/// Fills in the proof of the answer, for a valid pair with r12 != 0. `lambda` is the maximiser to
/// rounding. For multiprecision numbers the proof is correct to rounding.
template <class T, int D> PW85_FUNCTION inline void prove(OverlapWitness<T, D> &witness,
                                                          T const &lambda, Vector<T, D> const &r12,
                                                          SymmetricMatrix<T, D> const &q1,
                                                          SymmetricMatrix<T, D> const &q2) noexcept
{
    auto const geometry = contact_geometry(r12, q1, q2, lambda);
    if (!witness.overlap) witness.direction = geometry.normal;
    if constexpr (exact::is_decidable<T>) {
        ScaledPair<T, D> scaled{};
        validate_pair(pair_of(r12, q1, q2), scaled);
        if (witness.overlap)
            witness.point = find_point(r12, q1, q2, geometry.point, scaled);
        else
            witness.lambda = find_lambda(r12, q1, q2, lambda, scaled);
        bool const proved = witness.lambda > T(0) || is_finite(witness.point);
        if (!proved && compare_exactly(r12, q1, q2, T(1)) != 0)
            witness.status = StatusCode::no_convergence;
    } else if (witness.overlap) {
        witness.point = geometry.point;
    } else {
        witness.lambda = lambda;
    }
}

} // namespace pw85::detail

namespace pw85 {

template <class T, int D>
PW85_FUNCTION inline OverlapWitness<T, D> overlap_witness(Vector<T, D> const &r12,
                                                          SymmetricMatrix<T, D> const &q1,
                                                          SymmetricMatrix<T, D> const &q2) noexcept
{
    using namespace detail;
    Overlap const answer = call_overlap(r12, q1, q2);
    OverlapWitness<T, D> witness{answer.overlap, quiet_nan<T>(), {}, {}, answer.status};
    set_nan(witness.direction);
    set_nan(witness.point);
    if (answer.status != StatusCode::success) return witness;
    if (largest_coordinate(r12) == T(0))
        witness.point = {};
    else
        prove(witness, contact(r12, q1, q2).lambda, r12, q1, q2);
    return witness;
}

} // namespace pw85

#endif
