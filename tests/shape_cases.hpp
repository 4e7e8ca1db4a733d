// SPDX-License-Identifier: BSD-3-Clause
// Segments, triangles and boxes beside ellipsoids: random cases, the functions of each kind, and
// what their errors may be.
#ifndef PW85_TESTS_SHAPE_CASES_HPP_INCLUDED
#define PW85_TESTS_SHAPE_CASES_HPP_INCLUDED

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <pw85.h>
#include <pw85_batch.h>

#include "failures.hpp"
#include "random_pairs.hpp"
#include "shapes_truth.hpp"

namespace pw85_tests {

/// A segment, a triangle or a box (by its corners), and an ellipsoid.
template <std::size_t N, class T = double> struct Case {
    pw85::Vector<T, 3> points[N];
    pw85::SymmetricMatrix<T, 3> q;
};

template <std::size_t N> std::string text(Case<N> const &c)
{
    std::string all = "q = " + hex_text(c.q.entries, 6);
    for (auto const &x : c.points) all += ", " + hex_text(x.coordinates, 3);
    return all;
}

template <class To, std::size_t N, class From> Case<N, To> convert(Case<N, From> const &c)
{
    Case<N, To> wide{};
    for (std::size_t k = 0; k < N; ++k) wide.points[k] = convert<To>(c.points[k]);
    wide.q = convert<To>(c.q);
    return wide;
}

template <std::size_t N> Case<N> scaled(Case<N> c, int length, int form)
{
    for (auto &x : c.points) x = pw85::detail::times_power_of_two(x, length);
    c.q = pw85::detail::times_power_of_two(c.q, 2 * form);
    return c;
}

// The three kinds of sets, with one interface.

struct Segment {
    static constexpr std::size_t size = 2;
    static constexpr char const *name = "segment";

    static NearestTruth truth(Case<2, Wide> const &c) { return nearest_in_hull(c.points, c.q); }
    template <class T> static pw85::ShapeContact<T> contact(Case<2, T> const &c)
    {
        return pw85::contact_segment(c.points[0], c.points[1], c.q);
    }
    static int contact_in_c(Case<2> const &c, double *mu2, double *point)
    {
        return pw85_contact_segment(c.points[0].coordinates, c.points[1].coordinates, c.q.entries,
                                    mu2, point);
    }
    static int contact_batch(std::size_t n, double const *const *points, double const *q,
                             double *mu2, double *point)
    {
        return pw85_contact_segment_batch(n, points[0], points[1], q, mu2, point);
    }
    template <class T> static pw85::ShapeOverlap overlap(Case<2, T> const &c)
    {
        return pw85::overlap_segment(c.points[0], c.points[1], c.q);
    }
    template <class T> static bool overlaps_exactly(Case<2, T> const &c)
    {
        return pw85::detail::overlaps_exactly(c.points, c.q);
    }
    static int overlap_in_c(Case<2> const &c, int *overlap)
    {
        return pw85_overlap_segment(c.points[0].coordinates, c.points[1].coordinates, c.q.entries,
                                    overlap);
    }
    static int overlap_batch(std::size_t n, double const *const *points, double const *q,
                             unsigned char *overlap)
    {
        return pw85_overlap_segment_batch(n, points[0], points[1], q, overlap);
    }
};

struct Triangle {
    static constexpr std::size_t size = 3;
    static constexpr char const *name = "triangle";

    static NearestTruth truth(Case<3, Wide> const &c) { return nearest_in_hull(c.points, c.q); }
    template <class T> static pw85::ShapeContact<T> contact(Case<3, T> const &c)
    {
        return pw85::contact_triangle(c.points[0], c.points[1], c.points[2], c.q);
    }
    static int contact_in_c(Case<3> const &c, double *mu2, double *point)
    {
        return pw85_contact_triangle(c.points[0].coordinates, c.points[1].coordinates,
                                     c.points[2].coordinates, c.q.entries, mu2, point);
    }
    static int contact_batch(std::size_t n, double const *const *points, double const *q,
                             double *mu2, double *point)
    {
        return pw85_contact_triangle_batch(n, points[0], points[1], points[2], q, mu2, point);
    }
    template <class T> static pw85::ShapeOverlap overlap(Case<3, T> const &c)
    {
        return pw85::overlap_triangle(c.points[0], c.points[1], c.points[2], c.q);
    }
    template <class T> static bool overlaps_exactly(Case<3, T> const &c)
    {
        return pw85::detail::overlaps_exactly(c.points, c.q);
    }
    static int overlap_in_c(Case<3> const &c, int *overlap)
    {
        return pw85_overlap_triangle(c.points[0].coordinates, c.points[1].coordinates,
                                     c.points[2].coordinates, c.q.entries, overlap);
    }
    static int overlap_batch(std::size_t n, double const *const *points, double const *q,
                             unsigned char *overlap)
    {
        return pw85_overlap_triangle_batch(n, points[0], points[1], points[2], q, overlap);
    }
};

struct Box {
    static constexpr std::size_t size = 2;
    static constexpr char const *name = "box";

    static NearestTruth truth(Case<2, Wide> const &c)
    {
        return nearest_in_box(c.points[0], c.points[1], c.q);
    }
    template <class T> static pw85::ShapeContact<T> contact(Case<2, T> const &c)
    {
        return pw85::contact_box(c.points[0], c.points[1], c.q);
    }
    static int contact_in_c(Case<2> const &c, double *mu2, double *point)
    {
        return pw85_contact_box(c.points[0].coordinates, c.points[1].coordinates, c.q.entries, mu2,
                                point);
    }
    static int contact_batch(std::size_t n, double const *const *points, double const *q,
                             double *mu2, double *point)
    {
        return pw85_contact_box_batch(n, points[0], points[1], q, mu2, point);
    }
    template <class T> static pw85::ShapeOverlap overlap(Case<2, T> const &c)
    {
        return pw85::overlap_box(c.points[0], c.points[1], c.q);
    }
    template <class T> static bool overlaps_exactly(Case<2, T> const &c)
    {
        return pw85::detail::box_overlaps_exactly(c.points[0], c.points[1], c.q);
    }
    static int overlap_in_c(Case<2> const &c, int *overlap)
    {
        return pw85_overlap_box(c.points[0].coordinates, c.points[1].coordinates, c.q.entries,
                                overlap);
    }
    static int overlap_batch(std::size_t n, double const *const *points, double const *q,
                             unsigned char *overlap)
    {
        return pw85_overlap_box_batch(n, points[0], points[1], q, overlap);
    }
};

/// A point near which a set lies: at any direction and distance, or close to the surface of the
/// ellipsoid.
inline Vector3 random_place(Random &random, Form3 const &q, int n)
{
    if (n % 2 == 0) return random.log_uniform(0.01, 10.0) * random.direction<3>();
    return random.log_uniform(0.5, 2.0) * pw85::detail::support(q, random.direction<3>()).point;
}

/// Balls, needles and discs to aspect ratio 1e6; sets from 1e-6 to 1e4 times their size, slivers
/// among them.
template <class Shape> Case<Shape::size> random_case(Random &random, int n)
{
    double const aspects[] = {1.0, 10.0, 1e3, 1e6};
    Case<Shape::size> c{{}, random.form(1.0, random.log_uniform(1.0, aspects[n % 4]))};
    Vector3 const place = random_place(random, c.q, n / 4);
    double const size = n % 3 == 0 ? 1.0 : random.log_uniform(1e-6, 1e4);
    for (auto &x : c.points)
        x = pw85::detail::add_scaled(place, size * random.uniform(0.0, 1.0), random.direction<3>());
    if constexpr (std::is_same_v<Shape, Triangle>) {
        double const thickness = random.log_uniform(1e-17, 1.0), t = random.uniform(-1.0, 2.0);
        for (int i = 0; n % 5 == 0 && i < 3; ++i)
            c.points[2][i] = c.points[0][i] + t * (c.points[1][i] - c.points[0][i]) +
                             thickness * size * random.normal();
    }
    if constexpr (std::is_same_v<Shape, Box>)
        for (int i = 0; i < 3; ++i) {
            auto &[lower, upper] = c.points;
            if (random.uniform(0.0, 1.0) < 0.1) upper[i] = lower[i];
            if (lower[i] > upper[i]) std::swap(lower[i], upper[i]);
        }
    return c;
}

/// Triangles whose normal is much smaller than the terms of its coordinates, with the nearest point
/// of their plane in the middle. The edges are combinations of two vectors u and v. The
/// coefficients are successive numbers of Fibonacci, whose determinant is 1 or -1, so that the
/// normal is that of u and v, however long the edges are. The factor makes the products inexact.
inline std::vector<Case<3>> slivers()
{
    std::vector<Case<3>> cases;
    for (double const factor : {0x100007p0, 0x123457p0, 0xfedcbp0})
        for (double const distance : {7.0, 1001.0}) {
            Vector3 const u{2 * factor, -factor, 0}, v{2 * factor, 0, -factor};
            Vector3 const middle{distance * factor, 2 * distance * factor, 2 * distance * factor};
            double previous = 1, number = 1;
            for (int k = 0; k < 34; ++k) {
                double const next = previous + number;
                auto const e1 = number * u + next * v, e2 = previous * u + number * v,
                           a = middle - (e1 + e2);
                cases.push_back({{a, a + 3.0 * e1, a + 3.0 * e2}, {1, 0, 0, 1, 0, 1}});
                previous = number;
                number = next;
            }
        }
    return cases;
}

/// A triangle of moderate height beside the ellipsoid whose length is 1e2 to 1e14 times its height,
/// in the metric of Q: with one vertex far away, with two on opposite sides, or with two on the
/// same side.
inline Case<3> long_sliver(Random &random, int n)
{
    double const aspects[] = {1.0, 10.0, 1e3, 1e6};
    auto const axes = random.semi_axes(1.0, random.log_uniform(1.0, aspects[n % 4]));
    auto const turn = n % 5 == 0 ? pw85::Vector<double, 4>{1, 0, 0, 0} : random.direction<4>();
    auto const s = pw85::ellipsoid_factor(axes, turn).s;
    Vector3 const place = random.log_uniform(0.1, 10.0) * random.direction<3>(),
                  along = random.direction<3>();
    Vector3 const across = random.direction<3>();
    double const height = random.log_uniform(0.1, 10.0),
                 length = height * random.log_uniform(1e2, 1e14);
    double const second[] = {0.5 * height, -random.uniform(0.0, 1.0) * length,
                             random.uniform(0.0, 1.0) * length};
    Vector3 const points[] = {
        pw85::detail::add_scaled(place, length, along),
        pw85::detail::add_scaled(pw85::detail::add_scaled(place, height, across), second[n % 3],
                                 along),
        pw85::detail::add_scaled(place, -height * random.uniform(0.0, 2.0), across)};
    Case<3> c{{}, pw85::ellipsoid_quaternion(axes, turn).q};
    for (int k = 0; k < 3; ++k)
        for (int i = 0; i < 3; ++i)
            c.points[(k + n / 3) % 3][i] = pw85::dot(Vector3{s(i, 0), s(i, 1), s(i, 2)}, points[k]);
    return c;
}

/// An ellipsoid along the axes whose aspect ratio is 1e6 to 1e15, a needle or a disc, and a set
/// that is about as long.
template <class Shape> Case<Shape::size> beside_thin_form(Random &random, int n)
{
    double const thin = 1.0 / random.log_uniform(1e6, 1e15);
    Case<Shape::size> c{};
    for (int i = 0; i < 3; ++i) c.q(i, i) = (i == n % 3) == (n % 2 == 0) ? thin * thin : 1.0;
    double const size = random.log_uniform(0.05, 20.0);
    for (auto &x : c.points)
        for (int i = 0; i < 3; ++i) x[i] = size * random.uniform(-1.0, 1.0);
    for (int i = 0; std::is_same_v<Shape, Box> && i < 3; ++i)
        if (c.points[0][i] > c.points[1][i]) std::swap(c.points[0][i], c.points[1][i]);
    return c;
}

/// Sets that have the centre: a segment from a to -k a, and a triangle of which the centre is a
/// mean with small integers as weights.
template <class Shape> Case<Shape::size> around_center(Random &random, int n)
{
    Case<Shape::size> c{{}, random.form(1.0, random.log_uniform(1.0, 1e3))};
    auto const integers = [&](double limit) {
        Vector3 x{};
        for (int i = 0; i < 3; ++i) x[i] = std::floor(random.uniform(-limit, limit + 1));
        return x;
    };
    Vector3 const a = integers(n % 2 == 0 ? 1e6 : 4e15);
    c.points[0] = a;
    c.points[1] = n % 2 == 0 ? -(1.0 + n % 5) * a : -a;
    if constexpr (Shape::size == 3) {
        if (n % 3 != 0) c.points[1] = integers(1e6);
        c.points[2] = n % 3 == 0 ? integers(1e6) : -(1.0 + n % 4) * (c.points[0] + c.points[1]);
    }
    return c;
}

/// Sets at distances such that |μ² - 1| is from 1e-17 to 1/2, for numbers of type T. Returns false
/// if they are closer than what 50 digits can tell.
template <class Shape, class T>
bool draw_near_touch(Random &random, int n, Case<Shape::size, T> &c, bool &overlaps)
{
    auto drawn = random_case<Shape>(random, n);
    auto const mu2 = static_cast<double>(Shape::truth(convert<Wide>(drawn)).mu2);
    if (!(mu2 > 1e-12)) return false;
    double const factor = std::sqrt((1 + random.sign() * random.log_uniform(1e-17, 0.5)) / mu2);
    for (auto &x : drawn.points) x = factor * x;
    c = convert<T>(drawn);
    if (Shape::overlap(c).status != pw85::Status::success)
        return false; // a form that is not definite when it is rounded
    Wide const excess = Shape::truth(convert<Wide>(c)).mu2 - 1;
    overlaps = excess < 0;
    return abs(excess) > Wide("1e-30");
}

/// What T may err by.
template <class T> Wide bound_of(NearestTruth const &truth)
{
    return 80 * Wide(pw85::detail::unit_roundoff<T>()) * truth.sensitivity;
}

/// What the rounding of the coordinates of the point may change of μ² besides: an error of second
/// order (nearest_point.hpp).
template <class T> Wide bound_of_rounding(NearestTruth const &truth)
{
    Wide const error = 80 * Wide(pw85::detail::unit_roundoff<T>());
    return error * error * truth.square;
}

/// Checks a contact function of a case that was scaled: its μ², and that the point is as near. The
/// truth is that of the numbers before they are scaled. Returns the error in units of u S.
template <class Shape, class T>
double check_contact(Case<Shape::size> const &c, pw85::ShapeContact<T> const &found,
                     NearestTruth const &truth, int length, int form, Failures &failures)
{
    auto const describe = [&] {
        return std::string(Shape::name) + ": " + text(scaled(c, length, form));
    };
    failures.check(found.status == pw85::Status::success, "status",
                   static_cast<double>(found.status), 0, describe);
    Wide const mu2 = ldexp(Wide(found.mu2), 2 * (form - length));
    WideVector point{};
    for (int i = 0; i < 3; ++i) point[i] = ldexp(Wide(found.point[i]), -length);
    Wide const bound = bound_of<T>(truth),
               attained = pw85::dot(point, pw85::product(inverse(convert<Wide>(c.q)), point));
    failures.check(abs(Wide(mu2 - truth.mu2)) <= bound, "mu2", static_cast<double>(mu2),
                   static_cast<double>(truth.mu2), describe);
    failures.check(abs(Wide(attained - truth.mu2)) <= bound + bound_of_rounding<T>(truth), "point",
                   static_cast<double>(attained), static_cast<double>(truth.mu2), describe);
    return bound > 0 ? static_cast<double>(Wide(80 * abs(Wide(mu2 - truth.mu2)) / bound)) : 0.0;
}

} // namespace pw85_tests

#endif
