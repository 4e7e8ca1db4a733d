// Random pairs of ellipsoids that move, and where they are at some time by formulas of their own.
#ifndef PW85_TESTS_FLIGHTS_HPP_INCLUDED
#define PW85_TESTS_FLIGHTS_HPP_INCLUDED

#include <algorithm>
#include <cmath>

#include <pw85.h>
#include <pw85/first_contact.hpp>

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
    return hex_text(m.velocity.coordinates, D) + ", " + hex_text(m.angular_velocity.coordinates, D == 3 ? 3 : 1) +
           ", " + hex_text(&m.growth, 1);
}

template <class T, int D> std::string flight_text(Flight<T, D> const &f)
{
    return hex_text(f.start) + ", motions {" + motion_text(f.motion1) + "}, {" + motion_text(f.motion2) +
           "}, end = " + hex_text(&f.end, 1);
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
    c.status = static_cast<pw85::Status>(pw85_first_contact(f.start.r12.coordinates, f.start.q1.entries,
                                                            f.start.q2.entries, &motion1, &motion2, f.end, &c.time));
    return c;
}

template <class T> pw85::SymmetricMatrix<T, 3> turned_form(pw85::SymmetricMatrix<T, 3> const &q,
                                                           pw85::Motion<T, 3> const &m, T const &time)
{
    using std::cos, std::sin;
    T const rate = norm(m.angular_velocity), size = T(1) + m.growth * time, half = rate * time / 2;
    T const s = rate > T(0) ? T(sin(half) / rate) : T(0), c = cos(half);
    auto const &w = m.angular_velocity;
    auto const r = pw85::rotation_matrix(pw85::Vector<T, 4>{c, s * w[0], s * w[1], s * w[2]}, T(1));
    pw85::SymmetricMatrix<T, 3> result{};
    for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j)
            for (int k = 0; k < 3; ++k)
                for (int l = 0; l < 3; ++l)
                    result(i, j) += r.entries[3 * i + k] * q(k, l) * r.entries[3 * j + l] * size * size;
    return result;
}

template <class T> pw85::SymmetricMatrix<T, 2> turned_form(pw85::SymmetricMatrix<T, 2> const &q,
                                                           pw85::Motion<T, 2> const &m, T const &time)
{
    using std::cos, std::sin;
    T const angle = m.angular_velocity[0] * time, c = cos(angle), s = sin(angle), size = T(1) + m.growth * time;
    T const xx = c * c * q[0] - 2 * s * c * q[1] + s * s * q[2], xy = s * c * (q[0] - q[2]) + (c * c - s * s) * q[1],
            yy = s * s * q[0] + 2 * s * c * q[1] + c * c * q[2];
    return pw85::times(T(size * size), pw85::SymmetricMatrix<T, 2>{xx, xy, yy});
}

/// The pair at some time, by formulas of its own.
template <class T, int D> Sample<T, D> pair_at(Flight<T, D> const &f, T const &time)
{
    Sample<T, D> p{f.start.r12, turned_form(f.start.q1, f.motion1, time), turned_form(f.start.q2, f.motion2, time)};
    for (int i = 0; i < D; ++i) p.r12[i] += (f.motion2.velocity[i] - f.motion1.velocity[i]) * time;
    return p;
}

template <class T, int D> T mu2_at(Flight<T, D> const &f, T const &time)
{
    auto const p = pair_at(f, time);
    return pw85::contact(p.r12, p.q1, p.q2).mu2;
}

template <class To, class From, int D> pw85::Motion<To, D> convert_motion(pw85::Motion<From, D> const &m)
{
    return {convert<To>(m.velocity), convert<To>(m.angular_velocity), static_cast<To>(m.growth)};
}

template <class To, class From, int D> Flight<To, D> convert_flight(Flight<From, D> const &f)
{
    return {convert<To>(f.start), convert_motion<To>(f.motion1), convert_motion<To>(f.motion2), static_cast<To>(f.end)};
}

/// What moves in a random flight.
enum class Moving { centres, all };

template <int D> pw85::Motion<double, D> random_motion(Random &random, double speed, Moving moving)
{
    pw85::Motion<double, D> m{pw85::times(speed * random.uniform(0.0, 1.0), random.direction<D>()), {}, 0.0};
    if (moving == Moving::centres) return m;
    double const rate = random.uniform(0.0, 1.0) < 0.2 ? 0.0 : random.log_uniform(0.01, 10.0);
    m.angular_velocity = pw85::times(rate, random.direction < D == 3 ? 3 : 1 > ());
    m.growth = random.uniform(0.0, 1.0) < 0.5 ? 0.0 : random.uniform(-0.3, 0.3);
    return m;
}

/// Pairs that are apart and most of which touch before long, many of them barely.
template <int D> Flight<double, D> random_flight(Random &random, double aspect, Moving moving)
{
    double const speed = random.log_uniform(0.01, 1.0);
    Flight<double, D> f{random_pair<D>(random, {.aspect = aspect, .mu2_min = 1.001, .mu2_max = 30.0}),
                        random_motion<D>(random, speed, moving), random_motion<D>(random, speed, moving), 3.0};
    double const closing = random.uniform(0.0, 2.0);
    for (int i = 0; i < D; ++i) f.motion2.velocity[i] -= closing * f.start.r12[i] / f.end;
    return f;
}

} // namespace pw85_tests

#endif
