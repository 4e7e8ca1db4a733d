// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The time of the first contact of two ellipsoids that translate, rotate about their centres and
/// grow.
#ifndef PW85_MOTION_FIRST_CONTACT_HPP_INCLUDED
#define PW85_MOTION_FIRST_CONTACT_HPP_INCLUDED

#include <pw85/contact/scaling.hpp>
#include <pw85/motion/rotation.hpp>

namespace pw85::detail {

template <class T, int D>
PW85_FUNCTION inline bool is_valid_motion(Motion<T, D> const &motion, T const &end) noexcept
{
    bool const finite = is_finite(motion.velocity) && is_finite(motion.angular_velocity) &&
                        motion.growth * T(0) == T(0);
    return finite && (motion.growth >= T(0) || T(1) + motion.growth * end > T(0));
}

/// The largest of the rates at which the two ellipsoids rotate and grow.
template <class T, int D>
PW85_FUNCTION inline T fastest(Motion<T, D> const &motion1, Motion<T, D> const &motion2) noexcept
{
    T const turning = maximum(largest_coordinate(motion1.angular_velocity),
                              largest_coordinate(motion2.angular_velocity));
    return maximum(turning, maximum(absolute(motion1.growth), absolute(motion2.growth)));
}

/// A time in the caller's unit. A finite time that is too large for T is an error, because infinity
/// would mean that there is no contact.
template <class T>
PW85_FUNCTION inline FirstContact<T> in_unit_of_time(FirstContact<T> result, Unit unit) noexcept
{
    T const time = unit.to_caller(result.time);
    if (result.time < infinity<T>() && !(time < infinity<T>()))
        return all_nan<FirstContact<T>>(StatusCode::no_convergence);
    return {time, result.status};
}

/// μ² of a tangent pair in the units of a Pair. It is limited to the range of T; where the limit
/// matters, the centres are so near that the ellipsoids overlap.
template <class T> PW85_FUNCTION inline T tangent_in_units(Units const &units) noexcept
{
    Unit const largest{std::numeric_limits<T>::max_exponent / 4};
    return smaller_of(units.first / units.length, largest).to_caller(T(1), 2);
}

/// The unit of time in which the speed of a translation is of order one.
template <class T, int D> PW85_FUNCTION inline Unit
time_of_translation(Units const &units, Vector<T, D> const &velocity) noexcept
{
    return units.length / unit_of(velocity);
}

/// The unit of time in which the largest rate is of order one. The rate of the velocity is the
/// velocity divided by the distance of the centres or by the larger ellipsoid's size, whichever is
/// larger.
template <class T, int D> PW85_FUNCTION inline Unit time_of_motion(ScaledPair<T, D> const &scaled,
                                                                   Vector<T, D> const &velocity,
                                                                   T const &fastest) noexcept
{
    auto const &[pair, units] = scaled;
    T const size = maximum(square_root(largest_diagonal(pair.q1)),
                           T(square_root(largest_diagonal(pair.q2)) / pair.ratio));
    Unit const length =
        larger_unit(units.first * unit_of(size), largest_coordinate(pair.r12), units.length);
    return Unit{} /
           larger_unit(larger_unit(smallest_unit(), largest_coordinate(velocity), Unit{} / length),
                       fastest, {});
}

/// first_contact() of a valid pair that only translates, in its units.
template <class T, int D>
PW85_FUNCTION inline FirstContact<T> first_contact_of_translation(ScaledPair<T, D> const &scaled,
                                                                  Vector<T, D> const &velocity,
                                                                  T const &end) noexcept
{
    auto const found = find_translation_contact(
        TranslatingPair<T, D>{scaled.pair, velocity, tangent_in_units<T>(scaled.units)}, end);
    return {found.time, found.status};
}

/// first_contact() of a valid pair in which an ellipsoid rotates or grows, in its units.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline FirstContact<T>
first_contact_of_motion(ScaledPair<T, D> const &scaled, Unit time, Vector<T, D> const &velocity,
                        Motion<T, D> const &motion1, Motion<T, D> const &motion2,
                        T const &end) noexcept
{
    auto const &[pair, units] = scaled;
    auto const &first = units.swapped ? motion2 : motion1,
               &second = units.swapped ? motion1 : motion2;
    auto const bodies =
        to_body(side_by_side(pair.q1, pair.q2),
                side_by_side(time.to_local(first.angular_velocity, -1),
                             time.to_local(second.angular_velocity, -1)),
                TwoLanes<T>(time.to_local(first.growth, -1), time.to_local(second.growth, -1)));
    return advance_to_contact(turning_pair(BodyPair<T, D>{pair.r12, bodies, pair.ratio, velocity,
                                                          tangent_in_units<T>(units)}),
                              end);
}

/// first_contact() of a valid pair that is not remote.
template <class T, int D> PW85_FUNCTION inline FirstContact<T>
first_contact_nearby(ScaledPair<T, D> const &scaled, Motion<T, D> const &motion1,
                     Motion<T, D> const &motion2, T const &end) noexcept
{
    Units const &units = scaled.units;
    bool const translates = only_translates(motion1) && only_translates(motion2);
    Vector<T, D> const velocity = relative_velocity(motion1, motion2);
    Unit const time = translates ? time_of_translation(units, velocity)
                                 : time_of_motion(scaled, velocity, fastest(motion1, motion2));
    auto const v = units.reordered((units.length / time).to_local(velocity));
    T const last = time.to_local(end);
    return in_unit_of_time(translates
                               ? first_contact_of_translation(scaled, v, last)
                               : first_contact_of_motion(scaled, time, v, motion1, motion2, last),
                           time);
}

/// first_contact() of a valid pair that is remote. The pair is first moved until it is near
/// (approach.hpp).
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline FirstContact<T>
first_contact_from_afar(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                        SymmetricMatrix<T, D> const &q2, Motion<T, D> const &motion1,
                        Motion<T, D> const &motion2, T const &end) noexcept
{
    MovingEllipsoids<T, D> m{r12, q1, q2, motion1, motion2, end};
    T waited = T(0);
    for (int i = 0; i < max_translation_steps && is_remote(m.r12, m.q1, m.q2); ++i) {
        T const wait = advance_until_spheres_meet(m);
        if (!(wait < infinity<T>()))
            return {wait, wait > T(0) ? StatusCode::success : StatusCode::no_convergence};
        waited = waited + wait;
    }
    if (is_remote(m.r12, m.q1, m.q2)) return all_nan<FirstContact<T>>(StatusCode::no_convergence);
    auto const rest =
        first_contact_nearby(scale(pair_of(m.r12, m.q1, m.q2)), m.motion1, m.motion2, m.end);
    T const time = waited + rest.time;
    return {time > end ? infinity<T>() : time, rest.status};
}

} // namespace pw85::detail

namespace pw85 {

template <class T, int D> PW85_FUNCTION inline FirstContact<T>
first_contact(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
              SymmetricMatrix<T, D> const &q2, Motion<T, D> const &motion1,
              Motion<T, D> const &motion2, T const &end) noexcept
{
    using namespace detail;
    bool const valid =
        end >= T(0) && is_valid_motion(motion1, end) && is_valid_motion(motion2, end);
    if (!valid) return all_nan<FirstContact<T>>(StatusCode::invalid_argument);
    auto const pair = pair_of(r12, q1, q2);
    ScaledPair<T, D> scaled{pair, {}};
    if (!passes_fast_checks(pair)) {
        StatusCode const status = validate_pair(pair, scaled);
        if (status != StatusCode::success) return all_nan<FirstContact<T>>(status);
    }
    if (largest_coordinate(r12) == T(0)) return {T(0), StatusCode::success};
    if (!is_finite(relative_velocity(motion1, motion2)))
        return all_nan<FirstContact<T>>(StatusCode::no_convergence);
    if (is_remote(r12, q1, q2)) return first_contact_from_afar(r12, q1, q2, motion1, motion2, end);
    return first_contact_nearby(scaled, motion1, motion2, end);
}

} // namespace pw85

#endif
