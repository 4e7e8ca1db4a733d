// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Turns of a normal towards a local minimum of the length by which ellipsoid 2 must move along it,
/// for depth_search.hpp, which has the notation. follow_normal() takes Newton's steps across the
/// normal (curvature.hpp), and corrects the last one.
#ifndef PW85_DISTANCE_DEPTH_TURNS_HPP_INCLUDED
#define PW85_DISTANCE_DEPTH_TURNS_HPP_INCLUDED

#include <pw85/algebra/two_lanes.hpp>
#include <pw85/distance/curvature.hpp>

namespace pw85::detail {

/// The roots of both numbers, by one instruction where there is one.
template <class T> PW85_FUNCTION inline TwoLanes<T> roots(TwoLanes<T> const &x) noexcept
{
    return square_root(x);
}
#if defined(__SSE2__) && !defined(__CUDA__) && !defined(__CUDACC__)
PW85_FUNCTION inline TwoLanes<double> roots(TwoLanes<double> const &x) noexcept
{
    return __builtin_ia32_sqrtpd(x.lanes);
}
#endif

/// The length by which ellipsoid 2 must move along n, its rounding error, and the ratio c of the
/// half-widths.
template <class T> struct Shift {
    T length, ratio, rounding;
};

/// From both forms side by side.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline Shift<T>
shift_along(Vector<T, D> const &n, Vector<T, D> const &r12,
            SymmetricMatrix<TwoLanes<T>, D> const &q) noexcept
{
    auto const along = converted<TwoLanes<T>>(n);
    auto const weights = outer_weights(along);
    auto const extents = roots(positive_form(q, weights)), twice = extents + extents;
    T const a = first_of(extents), b = second_of(extents);
    T const sum =
        magnitude_of_dot(n, r12) + sum_of_lanes(TwoLanes<T>(magnitude_of_form(q, along) / twice));
    return {a + b - dot(n, r12), b / a, T(8 * unit_roundoff<T>()) * sum};
}

template <class T, int D>
PW85_FUNCTION inline Shift<T> shift_along(Vector<T, D> const &n, Vector<T, D> const &r12,
                                          SymmetricMatrix<T, D> const &q1,
                                          SymmetricMatrix<T, D> const &q2) noexcept
{
    return shift_along(n, r12, side_by_side(q1, q2));
}

/// The search for the depth of a pair, with the best direction that it has found.
template <class T, int D> struct DepthSearch {
    Vector<T, D> r12;
    SymmetricMatrix<T, D> q1, q2;
    Vector<T, D> direction;
    Shift<T> best;
};

/// Both ellipsoids along a direction, side by side. The direction is n/|n|: turns do not normalise
/// n, because Qn/α and g/|n| do not need it.
template <class T, int D> struct DirectionState {
    Vector<T, D> n;
    Vector<TwoLanes<T>, D> products;        ///< Qn
    TwoLanes<T> extents, inverses, factors; ///< α = √(nᵀQn), 1/α² and 1/α
    T shift, inverse_square, scale;         ///< g(n), 1/|n|² and 1/|n|
    T length;                               ///< the shift along the unit vector, g/|n|
};

/// Those of two vectors or numbers that a mask chooses, in each lane.
template <class Mask, class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline Vector<T, D>
selected(Mask const &mask, Vector<T, D> const &yes, Vector<T, D> const &no) noexcept
{
    Vector<T, D> x{};
    for (int i = 0; i < D; ++i) x[i] = select(mask, yes[i], no[i]);
    return x;
}

template <class Mask, class T> [[gnu::always_inline]] PW85_FUNCTION inline TwoLanes<T>
selected(Mask const &mask, TwoLanes<T> const &yes, TwoLanes<T> const &no) noexcept
{
    return {select(mask, first_of(yes), first_of(no)), select(mask, second_of(yes), second_of(no))};
}

template <class Mask, class T, int D>
[[gnu::always_inline]] PW85_FUNCTION inline Vector<TwoLanes<T>, D>
selected(Mask const &mask, Vector<TwoLanes<T>, D> const &yes,
         Vector<TwoLanes<T>, D> const &no) noexcept
{
    Vector<TwoLanes<T>, D> x{};
    for (int i = 0; i < D; ++i) x[i] = selected(mask, yes[i], no[i]);
    return x;
}

/// Qn of both ellipsoids. If they are to be accurate, the points Qn/α err by less than 2^12 u of
/// their distance from the centre: in plain arithmetic by 3uX (support.hpp).
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline Vector<TwoLanes<T>, D>
both_products(SymmetricMatrix<TwoLanes<T>, D> const &q, Vector<T, D> const &n,
              typename ScalarTraits<T>::Mask accurate) noexcept
{
    auto const along = converted<TwoLanes<T>>(n);
    auto const plain = product(q, along);
    auto const most = TwoLanes<T>(T(1024)) * dot(along, plain);
    auto const is_plain = both_of(TwoLanes<T>(trace(q) * dot(along, along)) < most) || !accurate;
    if (all_of(is_plain)) return plain;
    auto const exact = accurate_product(q, along);
    return any_of(is_plain) ? selected(is_plain, plain, exact) : exact;
}

template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline DirectionState<T, D>
state_along(SymmetricMatrix<TwoLanes<T>, D> const &q, Vector<T, D> const &r12,
            Vector<T, D> const &n, typename ScalarTraits<T>::Mask accurate) noexcept
{
    auto const along = converted<TwoLanes<T>>(n), products = both_products(q, n, accurate);
    auto const forms = positive_form(q, along, products), extents = roots(forms),
               inverses = TwoLanes<T>(T(1)) / forms, factors = inverses * extents;
    T const shift = sum_of_lanes(extents) - dot(n, r12), inverse_square = T(1) / dot(n, n),
            scale = square_root(inverse_square);
    return {n, products, extents, inverses, factors, shift, inverse_square, scale, shift * scale};
}

/// r - p1 - p2. At a minimum it is along n.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline Vector<T, D>
off_surface(DirectionState<T, D> const &at, Vector<T, D> const &r12) noexcept
{
    Vector<T, D> off = r12;
    for (int i = 0; i < D; ++i)
        off[i] = off[i] - sum_of_lanes(TwoLanes<T>(at.factors * at.products[i]));
    return off;
}

/// (A1 + A2)/|n| (curvature.hpp), which is zero along n.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline SymmetricMatrix<T, D>
turn_of_sum(SymmetricMatrix<TwoLanes<T>, D> const &q, DirectionState<T, D> const &at) noexcept
{
    SymmetricMatrix<T, D> a{};
    for (int i = 0; i < D; ++i) {
        auto const row = at.inverses * at.products[i];
        for (int j = i; j < D; ++j)
            a(i, j) = sum_of_lanes(TwoLanes<T>(at.factors * (q(i, j) - row * at.products[j])));
    }
    return a;
}

/// A symmetric matrix across n: its trace and its determinant in three dimensions, one and its
/// entry in two. The least eigenvalue across n, if it is positive, is at least their ratio.
template <class T> struct MinorsAcross {
    T trace, determinant;
};

template <class T> [[gnu::always_inline]] PW85_FUNCTION inline MinorsAcross<T>
minors_across(SymmetricMatrix<T, 3> const &a, DirectionState<T, 3> const &at) noexcept
{
    auto const weights = at.inverse_square * outer_weights(at.n);
    return {trace(a) - quadratic_form(a, weights), quadratic_form(adjugate(a), weights)};
}

template <class T> [[gnu::always_inline]] PW85_FUNCTION inline MinorsAcross<T>
minors_across(SymmetricMatrix<T, 2> const &a, DirectionState<T, 2> const &at) noexcept
{
    return {T(1), trace(a) - quadratic_form(a, at.n) * at.inverse_square};
}

/// Returns whether the least eigenvalue across n is proved to exceed `floor`.
template <class T> [[gnu::always_inline]] PW85_FUNCTION inline typename ScalarTraits<T>::Mask
exceeds(MinorsAcross<T> const &minors, T const &floor) noexcept
{
    return minors.trace > T(0) && minors.determinant > floor * minors.trace;
}

/// The inverse of A across n, times the determinant of MinorsAcross: [n]A[n]ᵀ/|n|² with the matrix
/// [n] of the cross product. In two dimensions [n] is a turn by a right angle, and A is left out.
template <class T> [[gnu::always_inline]] PW85_FUNCTION inline SymmetricMatrix<T, 3>
inverse_across(SymmetricMatrix<T, 3> const &a, DirectionState<T, 3> const &at) noexcept
{
    auto const &n = at.n;
    Vector<T, 3> const m{at.inverse_square * n[0], at.inverse_square * n[1],
                         at.inverse_square * n[2]};
    // the columns of [n]A
    Vector<T, 3> const x{n[1] * a[2] - n[2] * a[1], n[2] * a[0] - n[0] * a[2],
                         n[0] * a[1] - n[1] * a[0]},
        y{n[1] * a[4] - n[2] * a[3], n[2] * a[1] - n[0] * a[4], n[0] * a[3] - n[1] * a[1]},
        z{n[1] * a[5] - n[2] * a[4], n[2] * a[2] - n[0] * a[5], n[0] * a[4] - n[1] * a[2]};
    return {m[1] * z[0] - m[2] * y[0], m[2] * x[0] - m[0] * z[0], m[0] * y[0] - m[1] * x[0],
            m[2] * x[1] - m[0] * z[1], m[0] * y[1] - m[1] * x[1], m[0] * y[2] - m[1] * x[2]};
}

template <class T> [[gnu::always_inline]] PW85_FUNCTION inline SymmetricMatrix<T, 2>
inverse_across(SymmetricMatrix<T, 2> const &, DirectionState<T, 2> const &at) noexcept
{
    T const x = at.inverse_square * at.n[0], y = at.inverse_square * at.n[1];
    return {y * at.n[1], T(-x * at.n[1]), x * at.n[0]};
}

/// Ab, with the sums written out, which keeps the numbers in registers.
template <class T> [[gnu::always_inline]] PW85_FUNCTION inline Vector<T, 3>
product_of(SymmetricMatrix<T, 3> const &a, Vector<T, 3> const &b) noexcept
{
    return {a[0] * b[0] + a[1] * b[1] + a[2] * b[2], a[1] * b[0] + a[3] * b[1] + a[4] * b[2],
            a[2] * b[0] + a[4] * b[1] + a[5] * b[2]};
}

template <class T> [[gnu::always_inline]] PW85_FUNCTION inline Vector<T, 2>
product_of(SymmetricMatrix<T, 2> const &a, Vector<T, 2> const &b) noexcept
{
    return {a[0] * b[0] + a[1] * b[1], a[1] * b[0] + a[2] * b[1]};
}

/// The turn that the curvatures alone give, from A1 + A2, its trace, and r - p1 - p2. If rounding
/// hides the lesser curvature, the turn is along the force.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline Vector<T, D>
turn_by_curvatures(SymmetricMatrix<T, D> const &turn, T const &size, Vector<T, D> const &off,
                   DirectionState<T, D> const &at) noexcept
{
    auto const curved = minors_across(turn, at);
    auto const definite = exceeds(curved, T(T(unit_roundoff<T>()) * size));
    Vector<T, D> along_force{}, step{};
    if (!all_of(definite))
        along_force = T(T(1) / size) * (off - T(dot(at.n, off) * at.inverse_square) * at.n);
    if (!any_of(definite)) return along_force;
    step = T(T(1) / curved.determinant) * product_of(inverse_across(turn, at), off);
    return selected(definite, step, along_force);
}

/// A turn of the normal towards a minimum, which lies across n: Newton's step (curvature.hpp), or,
/// where the stiffness A1 + A2 - g I is not positive definite, the step with the curvatures alone.
/// It is to be added to n. Returns whether it is Newton's step; `inverse` then is that of the
/// stiffness. A structure of results would pass through memory.
///
/// Newton's step is taken where the direction is isolated with half of the digits to spare.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline typename ScalarTraits<T>::Mask
normal_turn(SymmetricMatrix<TwoLanes<T>, D> const &q, Vector<T, D> const &r12,
            DirectionState<T, D> const &at, Vector<T, D> &step,
            SymmetricMatrix<T, D> &inverse) noexcept
{
    Vector<T, D> const off = off_surface(at, r12);
    auto const turn = turn_of_sum(q, at),
               stiffness = plus_multiple_of_identity(turn, T(-at.shift * at.inverse_square));
    T const size = trace(turn);
    auto const minors = minors_across(stiffness, at);
    auto const newton =
        exceeds(minors, T(negative_power_of_two<T>(mantissa_digits<T>() / 2) * size));
    if (any_of(newton)) {
        auto const adj = inverse_across(stiffness, at);
        Vector<T, D> const along = product_of(adj, off); // while the processor divides
        T const reciprocal = T(1) / minors.determinant;
        step = reciprocal * along;
        inverse = reciprocal * adj;
        if (all_of(newton)) return newton;
    }
    Vector<T, D> const other = turn_by_curvatures(turn, size, off, at);
    step = any_of(newton) ? selected(newton, step, other) : other;
    return newton;
}

/// The numbers of turns, and of halves of one, that follow_normal() takes at most. Three whole ones
/// are usual.
inline constexpr int max_normal_turns = 32, max_turn_halves = 8;

/// n + factor·turn, normalised after a turn by more than half a right angle.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline Vector<T, D>
turned(Vector<T, D> const &n, T const &factor, Vector<T, D> const &turn,
       typename ScalarTraits<T>::Mask is_large) noexcept
{
    Vector<T, D> const next = add_scaled(n, factor, turn);
    return any_of(is_large) ? selected(is_large, unit_along(next), next) : next;
}

/// Takes the longest part of a turn, of halves of it, that does not lengthen the shift by more than
/// `slack`. Returns false if there is none.
template <class T, int D> [[gnu::noinline, gnu::cold]] PW85_FUNCTION inline bool
take_part_of_turn(SymmetricMatrix<TwoLanes<T>, D> const &q, Vector<T, D> const &r12,
                  Vector<T, D> const &turn, bool accurate, bool is_large, T const &slack,
                  DirectionState<T, D> &at) noexcept
{
    T factor = T(1);
    for (int k = 0; k < max_turn_halves; ++k) {
        factor = T(0.5) * factor;
        auto const next = state_along(q, r12, turned(at.n, factor, turn, is_large), accurate);
        if (!(next.length <= at.length + slack)) continue;
        at = next;
        return true;
    }
    return false;
}

/// The end of a path along turns. `found` is true if the turns have converged to the best direction
/// of the search.
template <class T, int D> struct FollowedNormal {
    DirectionState<T, D> at;
    bool converged, found;
};

/// A turn with the stiffness of the state before. `change` is twice that of the length, times |n|.
template <class T, int D> struct Correction {
    Vector<T, D> turn;
    T change;
};

template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline Correction<T, D>
correction_at(DirectionState<T, D> const &at, Vector<T, D> const &r12,
              SymmetricMatrix<T, D> const &inverse) noexcept
{
    Vector<T, D> const off = off_surface(at, r12),
                       across = add_scaled(off, T(-dot(off, at.n) * at.inverse_square), at.n),
                       turn = product_of(inverse, across);
    return {turn, absolute(dot(across, turn))};
}

/// Returns whether a correction is so small that the length needs none: it changes the length by
/// less than uℓ/2, ℓ = α + β, and terms of fourth order of the length of n + x are below rounding.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline typename ScalarTraits<T>::Mask
is_last(Correction<T, D> const &correction, DirectionState<T, D> const &at) noexcept
{
    auto const &[x, change] = correction;
    T const short_square = negative_power_of_two<T>(mantissa_digits<T>() / 4 * 3);
    return change <= T(unit_roundoff<T>()) * sum_of_lanes(at.extents) &&
           dot(x, x) * at.inverse_square <= short_square;
}

/// The unit vector along n + x, with a correction x for which is_last() holds, or zero.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline Vector<T, D>
corrected(DirectionState<T, D> const &at, Vector<T, D> const &x) noexcept
{
    T const growth = at.inverse_square * (dot(at.n, x) + T(0.5) * dot(x, x));
    return T(at.scale - at.scale * growth) * (at.n + x);
}

/// Corrects the direction of a path, and keeps it if it is the best one.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline FollowedNormal<T, D>
finish_turns(DepthSearch<T, D> &search, SymmetricMatrix<TwoLanes<T>, D> const &q,
             DirectionState<T, D> const &at, Vector<T, D> const &correction,
             bool converged) noexcept
{
    Shift<T> const along = shift_along(T(at.scale) * at.n, search.r12, q);
    Vector<T, D> const direction = corrected(at, correction);
    bool const best = along.length <= search.best.length + search.best.rounding;
    if (best) {
        search.best = along;
        search.direction = direction;
    }
    return {at, converged, converged && best};
}

/// Tests if the correction after a Newton's turn t leaves an error of more than 32u, by |t|² and
/// that of the turn before: see follow_normal().
template <class T> [[gnu::always_inline]] PW85_FUNCTION inline typename ScalarTraits<T>::Mask
is_rough(T const &square, T const &last) noexcept
{
    T const u = T(unit_roundoff<T>()), tiny = negative_power_of_two<T>(mantissa_digits<T>() + 16);
    T const fourth = (last * last) * (last * last), // C² is square/last²
        left = maximum(fourth, T(square * square)) * (square * square * square);
    return both_true(square > tiny, left > T(256) * u * u * fourth); // 2C²|t|³ > 32u
}

/// The next vector of a path, and what is known of the turn to it.
template <class T, int D> struct TurnedPath {
    using Mask = typename ScalarTraits<T>::Mask;
    Vector<T, D> n;
    T square;                           ///< of the last turn
    Mask accurate, converged, is_large; ///< is_large: by more than half a right angle
};

/// Adds a turn to the vector of a state.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline void
add_turn(TurnedPath<T, D> &path, DirectionState<T, D> const &at, Vector<T, D> const &turn,
         typename ScalarTraits<T>::Mask newton) noexcept
{
    T const last = path.square;
    path.square = dot(turn, turn) * at.inverse_square;
    auto const close = both_true(newton, path.square <= negative_power_of_two<T>(14));
    path.converged = both_true(both_true(path.accurate, close), !is_rough(path.square, last));
    path.is_large = path.square > T(1);
    path.n = turned(at.n, T(1), turn, path.is_large);
    path.accurate = close;
}

/// The rounding error of a shift along a path. `distance` is the sum of the magnitudes of r.
template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline T
slack_of_path(DirectionState<T, D> const &at, TwoLanes<T> const &traces, T const &distance) noexcept
{
    T const length = dot(at.n, at.n) * at.scale;
    return T(8 * unit_roundoff<T>()) *
           (distance + length * sum_of_lanes(TwoLanes<T>(traces * at.factors)));
}

/// Follows turns from a vector n to a local minimum. The best direction is kept.
///
/// A Newton's turn t leaves an error of about C|t|²; two of them give C. At the end, the stiffness
/// of the last turn corrects the direction once more, without another state. That leaves 2C²|t|³.
/// The direction is as good as its isolation permits when this is below 32u, or after a turn below
/// 2^-(digits + 16)/2, whose C may be rounding. The correction must change the length by less than
/// uℓ/2, ℓ = α + β, which is an eighth of the rounding error ρ or less. So the length is correct up
/// to rounding without it. The last turns need accurate products: those after a turn below 2^-7.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline FollowedNormal<T, D>
follow_normal(DepthSearch<T, D> &search, Vector<T, D> const &start) noexcept
{
    auto const q = side_by_side(search.q1, search.q2);
    auto const traces = trace(q);
    T const distance = sum_of_magnitudes(search.r12);
    TurnedPath<T, D> path{start, T(1), false, false, false};
    DirectionState<T, D> at;
    Vector<T, D> step;
    SymmetricMatrix<T, D> inverse;
    for (int i = 0; i <= max_normal_turns; ++i) { // the first state stands in it, too: registers
        auto const next = state_along(q, search.r12, path.n, path.accurate);
        T const slack = slack_of_path(next, traces, distance);
        if (i == 0 || next.length <= at.length + slack) {
            at = next;
        } else {
            auto part = at; // the address of `at` would keep it in memory
            path.converged = false;
            auto const turn = step;
            if (!take_part_of_turn(q, search.r12, turn, path.accurate, path.is_large, slack, part))
                break;
            at = part;
        }
        if (i == max_normal_turns || at.length < -slack) break; // the direction separates
        if (path.converged) {
            auto const correction = correction_at(at, search.r12, inverse);
            if (is_last(correction, at)) return finish_turns(search, q, at, correction.turn, true);
        }
        bool const newton = normal_turn(q, search.r12, at, step, inverse);
        add_turn(path, at, step, newton);
    }
    return finish_turns(search, q, at, Vector<T, D>{}, false);
}

} // namespace pw85::detail

#endif
