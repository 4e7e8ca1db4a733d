// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The first contact of two ellipsoids that rotate and grow. first_contact.hpp calls
/// advance_to_contact().
///
/// All steps in time are proved free of contact: by the spheres around the ellipsoids while they
/// are distant (approach.hpp), and then by turning_bound.hpp. The search ends at a time at which f
/// is 1 up to rounding.
#ifndef PW85_MOTION_ROTATION_HPP_INCLUDED
#define PW85_MOTION_ROTATION_HPP_INCLUDED

#include <pw85/motion/approach.hpp>
#include <pw85/motion/turning_bound.hpp>

namespace pw85::detail {

/// Bodies at time 0, and the data from which later states are computed.
template <class T, int D> struct TurningPair {
    BodyPair<T, D> start;
    TurningForm<TwoLanes<T>, D> forms;
    Reach<T> spheres; ///< of spheres around the bodies at the start
};

template <class T, int D>
PW85_FUNCTION inline TurningPair<T, D> turning_pair(BodyPair<T, D> const &start) noexcept
{
    T const unit = square_root(start.tangent); // of forms over that of r12
    return {
        start, turning_form(start.bodies),
        reach_of_spheres(TwoLanes<T>(unit, T(unit / start.ratio)) * square_root(start.bodies.most),
                         start.bodies.growth)};
}

template <class T, int D> PW85_FUNCTION inline BodyPair<T, D>
pair_at(TurningPair<T, D> const &turning, T const &time) noexcept
{
    auto const &[r12, bodies, ratio, velocity, tangent] = turning.start;
    return {add_scaled(r12, time, velocity), body_at(bodies, turning.forms, TwoLanes<T>(time)),
            ratio, velocity, tangent};
}

/// Returns how long the spheres around the ellipsoids remain apart after some time, or zero if they
/// are too near for a step that is worth its cost. The error of the moment is at most 4 u |r| |v|.
/// The margin of the radii covers this error if |r| is below 2^40 times the sum of the radii.
template <class T, int D>
PW85_FUNCTION inline T time_apart(TurningPair<T, D> const &turning, T const &time) noexcept
{
    Vector<T, D> const &velocity = turning.start.velocity,
                       r12 = add_scaled(turning.start.r12, time, velocity);
    auto const reach = reach_after(turning.spheres, time);
    T const square = dot(r12, r12);
    if (!(square - reach.radius * reach.radius > T(0.0625) * square)) return T(0);
    return meeting_of_spheres(r12, velocity, reach, cross(r12, velocity)).time;
}

/// t at the maximum of f.
template <class T, int D> PW85_FUNCTION inline T maximiser(BodyPair<T, D> const &moving) noexcept
{
    auto const forms = form_of(moving.bodies);
    Pair<T, D> pair{moving.r12, {}, {}, moving.ratio};
    for (int k = 0; k < forms.size; ++k) {
        pair.q1[k] = first_of(forms[k]);
        pair.q2[k] = second_of(forms[k]);
    }
    auto const m = maximize(pair);
    T const t = m.lambda / m.complement / pair.ratio / pair.ratio;
    return maximum(smallest_number<T>(), minimum(largest_number<T>(), t));
}

/// Returns whether the numbers are finite, and rounding errors still leave orientations and forms
/// determined. Valid arguments can lead to the opposite: sizes may grow out of the range of T,
/// angles may grow until their rounding errors exceed a thousandth of a radian, and a form may be
/// so slender that f has no correct digit after a rotation.
template <class T, int D> PW85_FUNCTION inline bool
is_known(BodyPair<T, D> const &moving, StateAtTime<T, D> const &state, T const &time) noexcept
{
    T const f = state.excess + state.target;
    return state.excess * T(0) == T(0) &&
           maximum(first_of(moving.bodies.rate), second_of(moving.bodies.rate)) * time <=
               longest_turn<T>() &&
           (state.turning_slack <= f || time == T(0));
}

/// Returns whether the excess of f over 1 is above rounding.
template <class T, int D>
PW85_FUNCTION constexpr bool is_clear(StateAtTime<T, D> const &state) noexcept
{
    return state.excess > state.slack;
}

/// Returns whether a state suffices whose t comes from an earlier time: f is at its maximum, or
/// near its maximum and above 1 by more than rounding.
template <class T, int D>
PW85_FUNCTION constexpr bool is_enough(StateAtTime<T, D> const &state) noexcept
{
    return state.nearby &&
           (is_clear(state) || state.newton * state.newton <= T(unit_roundoff<T>()));
}

/// Returns whether a pair for which f does not exceed 1 by more than rounding moves apart, and
/// overlaps by no more than a pair that has just collided.
template <class T, int D> PW85_FUNCTION constexpr bool
just_separates(StateAtTime<T, D> const &state, BoundAtLambda<T> const &bound) noexcept
{
    return bound.clearance.p[1] > T(0) && state.excess >= -T(touching_tolerance) * state.slack;
}

/// Ends a search in which no step advances the time. The result is a contact if f exceeds 1 by no
/// more than the change of f during the rounding error of the time.
template <class T, int D> PW85_FUNCTION inline FirstContact<T>
end_of_steps(StateAtTime<T, D> const &state, BoundAtLambda<T> const &bound, T const &time) noexcept
{
    T const change = T(4 * unit_roundoff<T>()) * time * absolute(bound.clearance.p[1]);
    if (state.excess <= state.slack + change) return {time, StatusCode::success};
    return all_nan<FirstContact<T>>(StatusCode::no_convergence);
}

/// The largest number of steps of first_contact(), a choice: some ten thousand radians of rotation
/// without contact.
inline constexpr int max_advances = 100000;

/// first_contact() of a valid pair, in a unit of time in which its rates are below 2. A pair that
/// has been apart touches when f no longer exceeds 1 by more than rounding. A pair that has not
/// been apart yet may move apart first. t follows the maximum of f; if it is too far from the
/// maximum, the search for the maximum restarts. The steps do not depend on the end of the time.
template <class T, int D> PW85_FUNCTION inline FirstContact<T>
advance_to_contact(TurningPair<T, D> const &turning, T const &end) noexcept
{
    T time = T(0), t = T(0);
    bool apart = false, lost = true;
    for (int i = 0; i < max_advances; ++i) {
        T const wait = time_apart(turning, time);
        time = time + wait;
        if (time > end || time == infinity<T>()) return {infinity<T>(), StatusCode::success};
        auto const moving = pair_at(turning, time);
        bool const sought = lost || wait > T(0);
        if (sought) t = maximiser(moving);
        auto const here = state_at_time(moving, t);
        if (!is_known(moving, here, time))
            return all_nan<FirstContact<T>>(StatusCode::no_convergence);
        lost = !(sought || is_enough(here));
        if (lost) continue;
        if (apart && !is_clear(here)) return {time, StatusCode::success};
        auto const ahead = bound_at_lambda(moving, here, t);
        if (!is_clear(here) && !just_separates(here, ahead)) return {time, StatusCode::success};
        apart = apart || is_clear(here);
        T const x = safe_time(ahead.clearance, certain_excess(here), here.slack),
                log_t = here.newton + ahead.rate * x;
        if (!(time + x > time)) return end_of_steps(here, ahead, time);
        time = time + x;
        lost = !(here.nearby && absolute(log_t) < T(1));
        t = t * exponential(Step<T>{log_t, T(1)});
    }
    return all_nan<FirstContact<T>>(StatusCode::no_convergence);
}

} // namespace pw85::detail

#endif
