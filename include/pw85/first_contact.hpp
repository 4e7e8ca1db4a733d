/// @file
/// The time of the first contact of two ellipsoids that translate, rotate about their centres and grow.
#ifndef PW85_FIRST_CONTACT_HPP_INCLUDED
#define PW85_FIRST_CONTACT_HPP_INCLUDED

#include <pw85/advance.hpp>
#include <pw85/contact.hpp>

namespace pw85 {

template <class T, int D> PW85_FUNCTION inline bool is_valid_motion(Motion<T, D> const &motion, T const &end) noexcept
{
    bool const finite =
        is_finite(motion.velocity) && is_finite(motion.angular_velocity) && motion.growth * T(0) == T(0);
    return finite && (motion.growth >= T(0) || T(1) + motion.growth * end > T(0));
}

template <class T, int D> PW85_FUNCTION inline bool only_translates(Motion<T, D> const &motion) noexcept
{
    return largest_coordinate(motion.angular_velocity) == T(0) && motion.growth == T(0);
}

/// The largest of the rates at which the two turn and grow.
template <class T, int D>
PW85_FUNCTION inline T fastest(Motion<T, D> const &motion1, Motion<T, D> const &motion2) noexcept
{
    T const turning =
        maximum(largest_coordinate(motion1.angular_velocity), largest_coordinate(motion2.angular_velocity));
    return maximum(turning, maximum(absolute(motion1.growth), absolute(motion2.growth)));
}

/// The larger of an exponent and that of x.
template <class T> PW85_FUNCTION inline int larger_exponent(int exponent, T const &x) noexcept
{
    return x > T(0) && binary_exponent(x) > exponent ? binary_exponent(x) : exponent;
}

/// first_contact() of a valid pair, in the unit of time in which the largest rate is of order one.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline FirstContact<T>
first_contact_of_motion(ScaledPair<T, D> const &scaled, Vector<T, D> const &velocity, Motion<T, D> const &motion1,
                        Motion<T, D> const &motion2, T const &end) noexcept
{
    Pair<T, D> const &pair = scaled.pair;
    int const none = std::numeric_limits<T>::min_exponent;
    int length = larger_exponent(half_exponent(largest_diagonal(pair.q1)), largest_coordinate(pair.r12));
    length = larger_exponent(length, T(square_root(largest_diagonal(pair.q2)) / pair.ratio));
    int const across = larger_exponent(none, largest_coordinate(velocity)) - scaled.length - length;
    int const rate = larger_exponent(across, fastest(motion1, motion2));
    auto const first = to_body(pair.q1, scaled.swapped ? motion2 : motion1, rate),
               second = to_body(pair.q2, scaled.swapped ? motion1 : motion2, rate);
    Vector<T, D> const v = times_power_of_two(velocity, -scaled.length - rate);
    T const tangent = times_power_of_two(T(1), 2 * (scaled.form - scaled.length));
    auto const moving = moving_pair(
        BodyPair<T, D>{pair.r12, scaled.swapped ? times(T(-1), v) : v, {first, second}, pair.ratio, tangent});
    auto result = advance_to_contact(moving, times_power_of_two(end, rate));
    result.time = times_power_of_two(result.time, -rate);
    return result;
}

template <class T, int D>
PW85_FUNCTION inline FirstContact<T> first_contact(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                                                   SymmetricMatrix<T, D> const &q2, Motion<T, D> const &motion1,
                                                   Motion<T, D> const &motion2, T const &end) noexcept
{
    bool const valid = end >= T(0) && is_valid_motion(motion1, end) && is_valid_motion(motion2, end);
    if (!valid) return {quiet_nan<T>(), Status::invalid_argument};
    ScaledPair<T, D> scaled{{r12, q1, q2, T(1)}, 0, 0, false};
    if (!is_ordinary(r12, q1, q2)) {
        Status const status = validate(r12, q1, q2, scaled);
        if (status != Status::success) return {quiet_nan<T>(), status};
    }
    if (largest_coordinate(r12) == T(0)) return {T(0), Status::success};
    Vector<T, D> const velocity = moved(motion2.velocity, T(-1), motion1.velocity);
    if (only_translates(motion1) && only_translates(motion2))
        return first_contact_of_translation(scaled, velocity, end);
    return first_contact_of_motion(scaled, velocity, motion1, motion2, end);
}

} // namespace pw85

#endif
