// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Moves two ellipsoids that are far apart until they are near. They cannot touch while the spheres
/// around them, whose radii change as the ellipsoids grow, are apart.
///
/// Let the sum of the radii be R + G x after a time x, let c = r × v, and let t = -(r·v)/v² be the
/// time at which the centres are nearest.
///
/// 1. The spheres touch where |r + v x| = R + G x. The discriminant of this quadratic equation is
///    (GR - r·v)² - (v² - G²)(r² - R²). If r is large, this expression is rounding noise. The equal
///    expression |R v - G r|² - |c|² is accurate.
/// 2. The centres are then at r + v x = (v × c)/v² + (x - t) v, and x - t = (G (R v² - G r·v) - v²
///    root)/(v² (v² - G²)), with the root of the discriminant. So the distance of the centres is
///    correct to rounding, even if the path up to this time is much longer.
/// 3. Items 1 and 2 need an accurate c. Its coordinates are sums of exact products, and only these
///    sums are rounded.
#ifndef PW85_MOTION_APPROACH_HPP_INCLUDED
#define PW85_MOTION_APPROACH_HPP_INCLUDED

#include <pw85/algebra/error_free.hpp>
#include <pw85/motion/translation.hpp>

namespace pw85::detail {

/// A sum with a relative error of a few u, even if the terms cancel. Each partial sum is kept as a
/// sum of numbers whose digits do not overlap (J. R. Shewchuk, Discrete Comput. Geom. 18, 305,
/// 1997).
template <class T, std::size_t N> PW85_FUNCTION inline T exact_sum(T const (&terms)[N]) noexcept
{
    T parts[N];
    for (std::size_t n = 0; n < N; ++n) {
        T carried = terms[n];
        for (std::size_t k = 0; k < n; ++k) {
            CompensatedSum<T> sum{parts[k], T(0)};
            add(sum, carried);
            parts[k] = sum.rest;
            carried = sum.sum;
        }
        parts[n] = carried;
    }
    T sum = parts[0];
    for (std::size_t n = 1; n < N; ++n) sum = sum + parts[n];
    return sum;
}

/// ab - cd, with a relative error of a few u.
template <class T> PW85_FUNCTION inline T difference_of_products(T const &a, T const &b, T const &c,
                                                                 T const &d) noexcept
{
    Parts<T> const x = split(a), y = split(b), z = split(c), w = split(d);
    T const terms[8] = {x.low * y.low,  -(z.low * w.low),  x.low * y.high,  -(z.low * w.high),
                        x.high * y.low, -(z.high * w.low), x.high * y.high, -(z.high * w.high)};
    return exact_sum(terms);
}

/// x × y. Each coordinate has a relative error of a few u.
template <class T> PW85_FUNCTION inline Vector<T, 3> accurate_cross(Vector<T, 3> const &x,
                                                                    Vector<T, 3> const &y) noexcept
{
    return {difference_of_products(x[1], y[2], x[2], y[1]),
            difference_of_products(x[2], y[0], x[0], y[2]),
            difference_of_products(x[0], y[1], x[1], y[0])};
}

template <class T> PW85_FUNCTION inline Vector<T, 1> accurate_cross(Vector<T, 2> const &x,
                                                                    Vector<T, 2> const &y) noexcept
{
    return {difference_of_products(x[0], y[1], x[1], y[0])};
}

/// The sum of the radii of two spheres, and its rate.
template <class T> struct Reach {
    T radius, growth;
};

/// The reach of spheres around two bodies, from their longest semi-axes and rates of growth. The
/// radii are enlarged by a thousandth, which covers rounding.
template <class T> PW85_FUNCTION inline Reach<T>
reach_of_spheres(TwoLanes<T> const &semi_axes, TwoLanes<T> const &growth) noexcept
{
    auto const radii = TwoLanes<T>(T(1) + T(0x1p-10)) * semi_axes;
    return {sum_of_lanes(radii), sum_of_lanes(growth * radii)};
}

/// The reach after some time. From this time on, a negative rate is replaced by 0, so the spheres
/// touch no later than the true ones.
template <class T>
PW85_FUNCTION inline Reach<T> reach_after(Reach<T> const &start, T const &time) noexcept
{
    return {start.radius + start.growth * time, maximum(start.growth, T(0))}; // NaN remains
}

/// √(|x|² - |y|²), or a negative number if |x| < |y|. The squares may be beyond the range of T.
template <class T, int D, int E>
PW85_FUNCTION inline T root_of_difference(Vector<T, D> const &x, Vector<T, E> const &y) noexcept
{
    T const largest = maximum(largest_coordinate(x), largest_coordinate(y));
    if (!(largest > T(0))) return largest;
    Unit const unit = is_in_range(largest, largest, largest) ? Unit{} : unit_of(largest);
    Vector<T, D> const a = unit.to_local(x);
    Vector<T, E> const b = unit.to_local(y);
    T const square = dot(a, a) - dot(b, b);
    return square < T(0) ? T(-1) : unit.to_caller(square_root(square));
}

/// The moment c = r × v of two centres.
template <class T, int D> using Moment = Vector<T, rotation_axes<D>>;

/// Time at which two spheres that are apart meet (item 1).
template <class T> struct Meeting {
    T time; ///< infinity if they do not meet
    T root; ///< the root of the discriminant
};

template <class T, int D> PW85_FUNCTION inline Meeting<T>
meeting_of_spheres(Vector<T, D> const &r12, Vector<T, D> const &velocity, Reach<T> const &reach,
                   Moment<T, D> const &moment) noexcept
{
    auto const &[radius, growth] = reach;
    T const root = root_of_difference(add_scaled(radius * velocity, T(-growth), r12), moment);
    T const speed = dot(velocity, velocity) - growth * growth,
            approach = growth * radius - dot(r12, velocity);
    bool const meets = (approach > T(0) || speed < T(0)) && root >= T(0);
    T const excess = dot(r12, r12) - radius * radius;
    return {meets ? nearer_root(excess, approach, speed, root) : infinity<T>(), root};
}

/// The vector between the centres when the spheres touch. If it is short, it is computed by item 2,
/// because the rounding errors of r12 + t velocity would matter.
template <class T, int D> PW85_FUNCTION inline Vector<T, D>
r12_at_meeting(Vector<T, D> const &r12, Vector<T, D> const &velocity, Reach<T> const &reach,
               Moment<T, D> const &moment, Meeting<T> const &meeting) noexcept
{
    auto const &[radius, growth] = reach;
    T const nearer = radius + growth * meeting.time;
    if (!(nearer * nearer < T(0x1p-6) * dot(r12, r12)))
        return add_scaled(r12, meeting.time, velocity);
    // Then |v| > 7 G, because the centres move by at least 7/8 of |r| while the spheres grow by
    // less than 1/8 of it.
    T const square = dot(velocity, velocity), speed = square - growth * growth;
    T const later =
        (growth * (radius * square - growth * dot(r12, velocity)) / square - meeting.root) / speed;
    return add_scaled(T(T(-1) / square) * turning(moment, velocity), later, velocity);
}

template <class T, int D>
PW85_FUNCTION inline bool only_translates(Motion<T, D> const &motion) noexcept
{
    return largest_coordinate(motion.angular_velocity) == T(0) && motion.growth == T(0);
}

template <class T, int D> PW85_FUNCTION inline Vector<T, D>
relative_velocity(Motion<T, D> const &motion1, Motion<T, D> const &motion2) noexcept
{
    return motion2.velocity - motion1.velocity;
}

/// Two ellipsoids that move, and the time up to which contacts count.
template <class T, int D> struct MovingEllipsoids {
    Vector<T, D> r12;
    SymmetricMatrix<T, D> q1, q2;
    Motion<T, D> motion1, motion2;
    T end;
};

/// Returns whether the largest coordinate of r12 is more than 32 times the root of the largest
/// diagonal entry. If it is not, rounding of positions causes errors of at most a few hundred u
/// times the longest semi-axis. Overflow or underflow of the squares does not change the answer.
template <class T, int D>
PW85_FUNCTION inline bool is_remote(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                                    SymmetricMatrix<T, D> const &q2) noexcept
{
    T const r = T(0x1p-5) * largest_coordinate(r12);
    return T(r * r) > maximum(largest_diagonal(q1), largest_diagonal(q2));
}

/// The units of a remote pair, of which at least one ellipsoid moves. In the unit of time the
/// centres or the surfaces move by about the distance of the centres.
template <class T, int D>
PW85_FUNCTION inline Units units_of_remote(MovingEllipsoids<T, D> const &moving) noexcept
{
    auto const &[r12, q1, q2, motion1, motion2, end] = moving;
    Unit const length = unit_of(r12), form1 = unit_of(q1), form2 = unit_of(q2);
    Unit rate = larger_unit(
        smallest_unit(), largest_coordinate(relative_velocity(motion1, motion2)), Unit{} / length);
    rate = larger_unit(rate, T(absolute(motion1.growth)), form1 / length);
    rate = larger_unit(rate, T(absolute(motion2.growth)), form2 / length);
    return {length, form1, form2, false, Unit{} / rate};
}

/// The largest angle after which the orientation of a body is known to a thousandth of a radian, if
/// the angle has a relative error of u.
template <class T> PW85_FUNCTION constexpr T longest_turn() noexcept
{
    return T(0x1p-10 / unit_roundoff<T>());
}

/// Returns whether a form that has rotated is still determined: its rounding error, a few u times
/// its largest entry, is less than its pivots.
template <class T, int D>
PW85_FUNCTION inline bool is_known_form(SymmetricMatrix<T, D> const &q) noexcept
{
    auto const factors = factorize(q, T(0));
    T least = factors.pivots[0];
    for (int i = 1; i < D; ++i) least = minimum(least, factors.pivots[i]);
    return least > T(12 * D * unit_roundoff<T>()) * largest_diagonal(q);
}

/// Rotates and grows an ellipsoid for some time, in the unit of the body. Returns false if its size
/// leaves the range of T, or if rounding errors no longer determine its orientation or its form.
template <class T, int D>
PW85_FUNCTION inline bool let_move(SymmetricMatrix<T, D> &q, Motion<T, D> &motion,
                                   Body<T, D> const &body, Unit form, T const &time) noexcept
{
    if (only_translates(motion)) return true;
    q = form.to_caller(form_of(body_at(body, turning_form(body), time)), 2);
    motion.growth = motion.growth / (T(1) + body.growth * time);
    T const size = largest_diagonal(q);
    return is_finite(q) && size > smallest_number<T>() && body.rate * time <= longest_turn<T>() &&
           (body.rate == T(0) || is_known_form(q));
}

/// Moves a remote pair until the spheres around its ellipsoids touch, and returns that time:
/// infinity if they do not touch before the end, NaN if a number leaves the range of T.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline T
advance_until_spheres_meet(MovingEllipsoids<T, D> &moving) noexcept
{
    T const speed = largest_coordinate(relative_velocity(moving.motion1, moving.motion2)),
            none = T(0);
    if (speed == none && moving.motion1.growth == none && moving.motion2.growth == none)
        return infinity<T>();
    Units const units = units_of_remote(moving);
    auto const [r12, q1, q2, scale1, scale2] =
        in_units(moving.r12, moving.q1, moving.q2, units).pair;
    auto const body1 = to_body(q1, moving.motion1, units.time),
               body2 = to_body(q2, moving.motion2, units.time);
    auto const velocity =
        units.velocity().to_local(relative_velocity(moving.motion1, moving.motion2));
    auto reach = reach_after(reach_of_spheres(TwoLanes<T>(scale1 * square_root(body1.most),
                                                          scale2 * square_root(body2.most)),
                                              TwoLanes<T>(body1.growth, body2.growth)),
                             T(0));
    T const least = Unit{std::numeric_limits<T>::min_exponent + 8}.as<T>();
    if (!(reach.growth < infinity<T>())) return quiet_nan<T>();
    bool const in_range = reach.radius > least;
    reach.radius = maximum(reach.radius, least);
    auto const moment = accurate_cross(r12, velocity);
    auto const meeting = meeting_of_spheres(r12, velocity, reach, moment);
    if (meeting.time >= units.time.to_local(moving.end)) return infinity<T>();
    T const time = units.time.to_caller(meeting.time);
    moving.r12 = units.length.to_caller(r12_at_meeting(r12, velocity, reach, moment, meeting));
    // rounding cuts off no contact
    moving.end = moving.end - time + T(4 * unit_roundoff<T>()) * moving.end;
    bool const known = let_move(moving.q1, moving.motion1, body1, units.first, meeting.time) &&
                       let_move(moving.q2, moving.motion2, body2, units.second, meeting.time);
    return in_range && known && time < infinity<T>() ? time : quiet_nan<T>();
}

PW85_SHARED_BY_QUESTIONS_OF(advance_until_spheres_meet, double, 3)

} // namespace pw85::detail

#endif
