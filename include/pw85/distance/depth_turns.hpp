// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Rotates a normal in steps ("turns") towards a local minimum of the length by which ellipsoid 2
/// must move along the normal. depth_search.hpp calls follow_normal(), and has the notation.
/// follow_normal() takes the steps of normal_turn.hpp, and corrects the last one.
#ifndef PW85_DISTANCE_DEPTH_TURNS_HPP_INCLUDED
#define PW85_DISTANCE_DEPTH_TURNS_HPP_INCLUDED

#include <pw85/distance/normal_turn.hpp>

namespace pw85::detail {

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
