// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The time of the first contact of two ellipsoids that translate, rotate about their centres and
/// grow.
#ifndef PW85_MOTION_FIRST_CONTACT_HPP_INCLUDED
#define PW85_MOTION_FIRST_CONTACT_HPP_INCLUDED

#include <pw85/contact/validate.hpp>
#include <pw85/motion/rotation.hpp>

namespace pw85::detail {

template <class T, int D>
PW85_FUNCTION inline bool is_valid_motion(Motion<T, D> const &motion, T const &end) noexcept
{
    bool const finite = is_finite(motion.velocity) && is_finite(motion.angular_velocity) &&
                        motion.growth * T(0) == T(0);
    return finite && (motion.growth >= T(0) || T(1) + motion.growth * end > T(0));
}

/// The largest of the rates at which the two turn and grow.
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
PW85_FUNCTION inline FirstContact<T> in_unit_of_time(FirstContact<T> result, int exponent) noexcept
{
    T const time = times_power_of_two(result.time, exponent);
    if (result.time < infinity<T>() && !(time < infinity<T>()))
        return all_nan<FirstContact<T>>(StatusCode::no_convergence);
    return {time, result.status};
}

/// μ² of a tangent pair in the units of a Pair. It is limited to the range of T: ellipsoids with
/// centres so near overlap anyway.
template <class T, int D>
PW85_FUNCTION inline T tangent_in_units(ScaledPair<T, D> const &scaled) noexcept
{
    int const exponent = scaled.form - scaled.length,
              limit = std::numeric_limits<T>::max_exponent / 4;
    return times_power_of_two(T(1), 2 * (exponent < limit ? exponent : limit));
}

/// A valid pair that only translates, in the unit of time in which the speed is of order one. The
/// unit of the caller is 2^-exponent of this one.
template <class T, int D> struct ScaledTranslation {
    Vector<T, D> velocity;
    int exponent;
};

template <class T, int D> PW85_FUNCTION inline ScaledTranslation<T, D>
scale_translation(ScaledPair<T, D> const &scaled, Vector<T, D> const &velocity) noexcept
{
    T const largest = largest_coordinate(velocity);
    int const unit = largest > T(0) ? binary_exponent(largest) : 0;
    return {times_power_of_two(scaled.swapped ? -velocity : velocity, -unit), scaled.length - unit};
}

/// first_contact() of a valid pair that only translates.
template <class T, int D>
PW85_FUNCTION inline FirstContact<T> first_contact_of_translation(ScaledPair<T, D> const &scaled,
                                                                  Vector<T, D> const &velocity,
                                                                  T const &end) noexcept
{
    auto const [v, exponent] = scale_translation(scaled, velocity);
    TranslatingPair<T, D> const moving{scaled.pair, v, tangent_in_units(scaled)};
    auto const found = find_translation_contact(moving, times_power_of_two(end, -exponent));
    return in_unit_of_time(FirstContact<T>{found.time, found.status}, exponent);
}

/// first_contact() of a valid pair, in the unit of time in which the largest rate is of order one.
/// The rate of the velocity is its quotient by the distance of the centres, or by the larger of the
/// sizes if this is larger.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline FirstContact<T>
first_contact_of_motion(ScaledPair<T, D> const &scaled, Vector<T, D> const &velocity,
                        Motion<T, D> const &motion1, Motion<T, D> const &motion2,
                        T const &end) noexcept
{
    Pair<T, D> const &pair = scaled.pair;
    T const size = maximum(square_root(largest_diagonal(pair.q1)),
                           T(square_root(largest_diagonal(pair.q2)) / pair.ratio));
    int const length = larger_exponent(binary_exponent(size) + scaled.form,
                                       largest_coordinate(pair.r12), scaled.length);
    int const across =
        larger_exponent((std::numeric_limits<int>::min)(), largest_coordinate(velocity), -length);
    int const rate = larger_exponent(across, fastest(motion1, motion2), 0);
    auto const first = to_body(pair.q1, scaled.swapped ? motion2 : motion1, rate),
               second = to_body(pair.q2, scaled.swapped ? motion1 : motion2, rate);
    Vector<T, D> const v = times_power_of_two(velocity, -scaled.length - rate);
    auto const moving = moving_pair(BodyPair<T, D>{
        pair.r12, scaled.swapped ? -v : v, {first, second}, pair.ratio, tangent_in_units(scaled)});
    return in_unit_of_time(advance_to_contact(moving, times_power_of_two(end, rate)), -rate);
}

/// first_contact() of a valid pair that is not remote.
template <class T, int D> PW85_FUNCTION inline FirstContact<T>
first_contact_nearby(ScaledPair<T, D> const &scaled, Motion<T, D> const &motion1,
                     Motion<T, D> const &motion2, T const &end) noexcept
{
    Vector<T, D> const velocity = relative_velocity(motion1, motion2);
    if (only_translates(motion1) && only_translates(motion2))
        return first_contact_of_translation(scaled, velocity, end);
    return first_contact_of_motion(scaled, velocity, motion1, motion2, end);
}

/// first_contact() of a valid pair that is remote: it comes near before it touches.
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
    ScaledPair<T, D> scaled{pair, 0, 0, false, 0};
    if (!passes_fast_checks(pair)) {
        StatusCode const status = validate(pair, scaled);
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
