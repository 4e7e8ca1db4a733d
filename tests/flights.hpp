// SPDX-License-Identifier: BSD-3-Clause
// Random pairs of moving ellipsoids, with independent formulas for their positions at a given time.
#ifndef PW85_TESTS_FLIGHTS_HPP_INCLUDED
#define PW85_TESTS_FLIGHTS_HPP_INCLUDED

#include <algorithm>
#include <cmath>

#include <pw85.h>
#include <pw85/motion/first_contact.hpp>

#include "condition_number.hpp"
#include "failures.hpp"
#include "random_pairs.hpp"
#include "rotated.hpp"

namespace pw85_tests {

template <class T, int D> struct Flight {
    Sample<T, D> start;
    pw85::Motion<T, D> motion1, motion2;
    T end;
};

template <class T, int D> std::string motion_text(pw85::Motion<T, D> const &m)
{
    return hex_text(m.velocity.coordinates, D) + ", " +
           hex_text(m.angular_velocity.coordinates, D == 3 ? 3 : 1) + ", " + hex_text(&m.growth, 1);
}

template <class T, int D> std::string flight_text(Flight<T, D> const &f)
{
    return hex_text(f.start) + ", motions {" + motion_text(f.motion1) + "}, {" +
           motion_text(f.motion2) + "}, end = " + hex_text(&f.end, 1);
}

template <class T, int D> pw85::FirstContact<T> first_contact(Flight<T, D> const &f)
{
    return pw85::first_contact(f.start.r12, f.start.q1, f.start.q2, f.motion1, f.motion2, f.end);
}

inline pw85_motion c_motion(pw85::Motion<double, 3> const &m)
{
    pw85_motion c{{}, {}, m.growth};
    std::copy_n(m.velocity.coordinates, 3, c.velocity);
    std::copy_n(m.angular_velocity.coordinates, 3, c.angular_velocity);
    return c;
}

/// In double and three dimensions by the C API.
inline pw85::FirstContact<double> first_contact(Flight<double, 3> const &f)
{
    pw85_motion const motion1 = c_motion(f.motion1), motion2 = c_motion(f.motion2);
    pw85::FirstContact<double> c{};
    c.status = static_cast<pw85::Status>(pw85_first_contact(f.start.r12.coordinates,
                                                            f.start.q1.entries, f.start.q2.entries,
                                                            &motion1, &motion2, f.end, &c.time));
    return c;
}

template <class T> pw85::SymmetricMatrix<T, 3>
turned_form(pw85::SymmetricMatrix<T, 3> const &q, pw85::Motion<T, 3> const &m, T const &time)
{
    using std::cos, std::sin;
    T const rate = norm(m.angular_velocity), size = T(1) + m.growth * time, half = rate * time / 2;
    T const s = rate > T(0) ? T(sin(half) / rate) : T(0), c = cos(half);
    auto const &w = m.angular_velocity;
    auto const r =
        pw85::detail::rotation_matrix(pw85::Vector<T, 4>{c, s * w[0], s * w[1], s * w[2]}, T(1));
    pw85::SymmetricMatrix<T, 3> result{};
    for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j)
            for (int k = 0; k < 3; ++k)
                for (int l = 0; l < 3; ++l)
                    result(i, j) +=
                        r.entries[3 * i + k] * q(k, l) * r.entries[3 * j + l] * size * size;
    return result;
}

template <class T> pw85::SymmetricMatrix<T, 2>
turned_form(pw85::SymmetricMatrix<T, 2> const &q, pw85::Motion<T, 2> const &m, T const &time)
{
    using std::cos, std::sin;
    T const angle = m.angular_velocity[0] * time, c = cos(angle), s = sin(angle),
            size = T(1) + m.growth * time;
    T const xx = c * c * q[0] - 2 * s * c * q[1] + s * s * q[2],
            xy = s * c * (q[0] - q[2]) + (c * c - s * s) * q[1],
            yy = s * s * q[0] + 2 * s * c * q[1] + c * c * q[2];
    return T(size * size) * pw85::SymmetricMatrix<T, 2>{xx, xy, yy};
}

/// The pair at some time, by formulas of its own.
template <class T, int D> Sample<T, D> pair_at(Flight<T, D> const &f, T const &time)
{
    Sample<T, D> p{f.start.r12, turned_form(f.start.q1, f.motion1, time),
                   turned_form(f.start.q2, f.motion2, time)};
    for (int i = 0; i < D; ++i) p.r12[i] += (f.motion2.velocity[i] - f.motion1.velocity[i]) * time;
    return p;
}

template <class T, int D> T mu2_at(Flight<T, D> const &f, T const &time)
{
    auto const p = pair_at(f, time);
    return pw85::contact(p.r12, p.q1, p.q2).mu2;
}

/// S of pw85_first_contact(): what relative errors of one in the numbers of a flight, and in the
/// forms of what turns or grows, change μ² by at most, at some time.
template <class T, int D> T sensitivity(Flight<T, D> const &f, T const &time)
{
    auto const p = pair_at(f, time);
    auto const lambda = pw85::contact(p.r12, p.q1, p.q2).lambda;
    auto const g = pw85::contact_gradient(p.r12, p.q1, p.q2, lambda);
    auto const &m1 = f.motion1, &m2 = f.motion2;
    T sum = condition_number(p, lambda);
    for (int i = 0; i < D; ++i) {
        T const way = time * (pw85::detail::absolute(m1.velocity[i]) +
                              pw85::detail::absolute(m2.velocity[i]));
        sum += pw85::detail::absolute(g.r12[i]) * (pw85::detail::absolute(f.start.r12[i]) + way);
    }
    auto const of_form = [&](pw85::SymmetricMatrix<T, D> const &d,
                             pw85::SymmetricMatrix<T, D> const &q, pw85::Motion<T, D> const &m) {
        T const rate = norm(m.angular_velocity) + pw85::detail::absolute(m.growth);
        T gradient = T(0), size = T(0);
        for (int k = 0; k < q.size; ++k) {
            gradient += pw85::detail::absolute(d[k]);
            size = pw85::detail::maximum(size, T(pw85::detail::absolute(q[k])));
        }
        return rate > T(0) ? T(gradient * size * (T(1) + time * rate)) : T(0);
    };
    return sum + of_form(g.q1, p.q1, m1) + of_form(g.q2, p.q2, m2);
}

/// By how much μ² may differ from 1 at the time of first contact, in units of u S. A pair touches
/// where f is 1 up to the slack of slack_of_form(), 12 D u Σ M_ii s_i² over rᵀM⁻¹r, which is at
/// most 12 D u (cond - 2); the last step of a translation may be wrong by as much again; and f
/// itself errs by 4 u cond: 76 u cond in all. Rounding of positions comes to less than 16 u times
/// their part of S; that of forms that turn was measured: all in all 18 u S is the most that was
/// seen.
inline constexpr double touching_error = 80.0;

template <class To, class From, int D>
pw85::Motion<To, D> convert_motion(pw85::Motion<From, D> const &m)
{
    return {convert<To>(m.velocity), convert<To>(m.angular_velocity), static_cast<To>(m.growth)};
}

template <class To, class From, int D> Flight<To, D> convert_flight(Flight<From, D> const &f)
{
    return {convert<To>(f.start), convert_motion<To>(f.motion1), convert_motion<To>(f.motion2),
            static_cast<To>(f.end)};
}

/// The same flight in units of length and time that are smaller by powers of two.
template <int D> Flight<double, D> in_units(Flight<double, D> const &f, int length, int time)
{
    auto const motion = [&](pw85::Motion<double, D> const &m) {
        return pw85::Motion<double, D>{pw85::detail::times_power_of_two(m.velocity, length - time),
                                       pw85::detail::times_power_of_two(m.angular_velocity, -time),
                                       std::ldexp(m.growth, -time)};
    };
    return {{pw85::detail::times_power_of_two(f.start.r12, length),
             pw85::detail::times_power_of_two(f.start.q1, 2 * length),
             pw85::detail::times_power_of_two(f.start.q2, 2 * length)},
            motion(f.motion1),
            motion(f.motion2),
            std::ldexp(f.end, time)};
}

/// What moves in a random flight.
enum class Moving { centres, all };

template <int D> pw85::Motion<double, D> random_motion(Random &random, double speed, Moving moving)
{
    pw85::Motion<double, D> m{speed * random.uniform(0.0, 1.0) * random.direction<D>(), {}, 0.0};
    if (moving == Moving::centres) return m;
    double const rate = random.uniform(0.0, 1.0) < 0.2 ? 0.0 : random.log_uniform(0.01, 10.0);
    m.angular_velocity = rate * (random.direction < D == 3 ? 3 : 1 > ());
    m.growth = random.uniform(0.0, 1.0) < 0.5 ? 0.0 : random.uniform(-0.3, 0.3);
    return m;
}

/// Pairs that are apart and most of which touch before long, many of them barely.
template <int D> Flight<double, D> random_flight(Random &random, double aspect, Moving moving)
{
    double const speed = random.log_uniform(0.01, 1.0);
    Flight<double, D> f{
        random_pair<D>(random, {.aspect = aspect, .mu2_min = 1.001, .mu2_max = 30.0}),
        random_motion<D>(random, speed, moving), random_motion<D>(random, speed, moving), 3.0};
    double const closing = random.uniform(0.0, 2.0);
    for (int i = 0; i < D; ++i) f.motion2.velocity[i] -= closing * f.start.r12[i] / f.end;
    return f;
}

/// The form of a needle or a disc in space, or of a slender ellipse, with the largest semi-axis
/// `size`.
template <int D> pw85::SymmetricMatrix<double, D> slender_form(Random &random, double size,
                                                               double aspect, bool needle)
{
    double const least = size / aspect;
    if constexpr (D == 2)
        return random_form<2>(random, size, aspect);
    else
        return pw85::ellipsoid_quaternion(
                   pw85::Vector<double, 3>{least, needle ? least : size, size},
                   random.direction<4>())
            .q;
}

/// A needle, and a needle or a disc of another size, that turn while one passes the other, slowly
/// or fast. Their contact function is huge on most of the way.
template <int D> Flight<double, D> slender_flight(Random &random, double aspect, double slowest)
{
    double const speed = random.log_uniform(slowest, 2.0), size = random.log_uniform(0.1, 1.0);
    bool const needle = random.uniform(0.0, 1.0) < 0.5;
    Flight<double, D> f{{random.uniform(1.5, 3.0) * random.direction<D>(),
                         slender_form<D>(random, 1.0, aspect, true),
                         slender_form<D>(random, size, aspect, needle)},
                        {},
                        {},
                        3.0 / speed};
    f.motion2.velocity = -speed / norm(f.start.r12) * f.start.r12 +
                         random.uniform(0.0, 0.5) * speed * random.direction<D>();
    for (auto *m : {&f.motion1, &f.motion2})
        m->angular_velocity =
            random.log_uniform(0.2, 10.0) * random.direction<pw85::detail::rotation_axes<D>>();
    return f;
}

} // namespace pw85_tests

#endif
