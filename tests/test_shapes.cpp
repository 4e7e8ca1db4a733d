// Tests of an ellipsoid and convex sets (include/pw85/shapes/) against brute force in 50 digits.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <glib.h>

#include <pw85.h>

#include "draws.hpp"
#include "failures.hpp"
#include "random_pairs.hpp"
#include "shapes_truth.hpp"

using namespace pw85_tests;

namespace {

using pw85_tests::convert;
using Vector3 = pw85::Vector<double, 3>;
using Form3 = pw85::SymmetricMatrix<double, 3>;

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
        return pw85_contact_segment(c.points[0].coordinates, c.points[1].coordinates, c.q.entries, mu2, point);
    }
    static int contact_batch(std::size_t n, double const *const *points, double const *q, double *mu2, double *point)
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
        return pw85_overlap_segment(c.points[0].coordinates, c.points[1].coordinates, c.q.entries, overlap);
    }
    static int overlap_batch(std::size_t n, double const *const *points, double const *q, unsigned char *overlap)
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
        return pw85_contact_triangle(c.points[0].coordinates, c.points[1].coordinates, c.points[2].coordinates,
                                     c.q.entries, mu2, point);
    }
    static int contact_batch(std::size_t n, double const *const *points, double const *q, double *mu2, double *point)
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
        return pw85_overlap_triangle(c.points[0].coordinates, c.points[1].coordinates, c.points[2].coordinates,
                                     c.q.entries, overlap);
    }
    static int overlap_batch(std::size_t n, double const *const *points, double const *q, unsigned char *overlap)
    {
        return pw85_overlap_triangle_batch(n, points[0], points[1], points[2], q, overlap);
    }
};

struct Box {
    static constexpr std::size_t size = 2;
    static constexpr char const *name = "box";

    static NearestTruth truth(Case<2, Wide> const &c) { return nearest_in_box(c.points[0], c.points[1], c.q); }
    template <class T> static pw85::ShapeContact<T> contact(Case<2, T> const &c)
    {
        return pw85::contact_box(c.points[0], c.points[1], c.q);
    }
    static int contact_in_c(Case<2> const &c, double *mu2, double *point)
    {
        return pw85_contact_box(c.points[0].coordinates, c.points[1].coordinates, c.q.entries, mu2, point);
    }
    static int contact_batch(std::size_t n, double const *const *points, double const *q, double *mu2, double *point)
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
        return pw85_overlap_box(c.points[0].coordinates, c.points[1].coordinates, c.q.entries, overlap);
    }
    static int overlap_batch(std::size_t n, double const *const *points, double const *q, unsigned char *overlap)
    {
        return pw85_overlap_box_batch(n, points[0], points[1], q, overlap);
    }
};

/// A point near which a set lies: at any direction and distance, or close to the surface of the ellipsoid.
Vector3 random_place(Random &random, Form3 const &q, int n)
{
    if (n % 2 == 0) return random.log_uniform(0.01, 10.0) * random.direction<3>();
    return random.log_uniform(0.5, 2.0) * pw85::detail::support(q, random.direction<3>()).point;
}

/// Balls, needles and discs to aspect ratio 1e6; sets from 1e-6 to 1e4 times their size, slivers among them.
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
            c.points[2][i] =
                c.points[0][i] + t * (c.points[1][i] - c.points[0][i]) + thickness * size * random.normal();
    }
    if constexpr (std::is_same_v<Shape, Box>)
        for (int i = 0; i < 3; ++i) {
            auto &[lower, upper] = c.points;
            if (random.uniform(0.0, 1.0) < 0.1) upper[i] = lower[i];
            if (lower[i] > upper[i]) std::swap(lower[i], upper[i]);
        }
    return c;
}

/// What T may err by: 80 u S, and the same of second order (nearest.hpp).
template <class T> Wide bound_of(NearestTruth const &truth)
{
    Wide const error = 80 * Wide(pw85::detail::unit_roundoff<T>());
    return error * truth.sensitivity + error * error * truth.square;
}

/// Checks μ², and that the point is as near. The truth is that of the numbers before they are scaled.
template <class Shape, class T>
double check(Case<Shape::size> const &c, NearestTruth const &truth, int length, int form, Failures &failures)
{
    auto const moved = convert<T>(scaled(c, length, form));
    auto const found = Shape::contact(moved);
    auto const describe = [&] { return std::string(Shape::name) + ": " + text(scaled(c, length, form)); };
    failures.check(found.status == pw85::Status::success, "status", static_cast<double>(found.status), 0, describe);
    Wide const mu2 = ldexp(Wide(found.mu2), 2 * (form - length));
    WideVector point{};
    for (int i = 0; i < 3; ++i) point[i] = ldexp(Wide(found.point[i]), -length);
    Wide const bound = bound_of<T>(truth),
               attained = pw85::dot(point, pw85::product(inverse(convert<Wide>(c.q)), point));
    failures.check(abs(Wide(mu2 - truth.mu2)) <= bound, "mu2", static_cast<double>(mu2), static_cast<double>(truth.mu2),
                   describe);
    failures.check(abs(Wide(attained - truth.mu2)) <= bound, "point", static_cast<double>(attained),
                   static_cast<double>(truth.mu2), describe);
    return bound > 0 ? static_cast<double>(Wide(80 * abs(Wide(mu2 - truth.mu2)) / bound)) : 0.0;
}

template <class Shape> void test_random()
{
    Failures failures;
    Random random(600);
    double worst = 0;
    for (int n = 0; n < draws(8000); ++n) {
        auto const c = random_case<Shape>(random, n);
        auto const truth = Shape::truth(convert<Wide>(c));
        for (int const exponent : {0, n % 2 == 0 ? 40 : -40})
            worst = std::max(worst, check<Shape, double>(c, truth, exponent, exponent, failures));
    }
    g_test_message("largest error %.3g u S", worst);
}

// The ellipsoid up to 1e300 times smaller or larger than the distance of the set, and both near the ends of the range.
template <class Shape> void test_sizes()
{
    Failures failures;
    Random random(610);
    for (int n = 0; n < draws(400); ++n) {
        auto const c = random_case<Shape>(random, n);
        auto const truth = Shape::truth(convert<Wide>(c));
        for (int const length : {-480, 0, 480})
            for (int const form : {-480, 0, 480})
                if (std::abs(length - form) < 500) check<Shape, double>(c, truth, length, form, failures);
    }
}

// Every order of the vertices, and every numbering of the axes.
template <class Shape> void test_orders()
{
    Failures failures;
    Random random(620);
    for (int n = 0; n < draws(400); ++n) {
        auto c = random_case<Shape>(random, n);
        auto const truth = Shape::truth(convert<Wide>(c));
        for (int turn = 0; turn < 3; ++turn) {
            for (auto &x : c.points) x = {x[1], x[2], x[0]};
            c.q = {c.q[3], c.q[4], c.q[1], c.q[5], c.q[2], c.q[0]};
            auto moved = truth;
            for (int i = 0; i < 3; ++i) moved.point[i] = truth.point[(i + turn + 1) % 3];
            auto other = c;
            if constexpr (!std::is_same_v<Shape, Box>) {
                std::reverse(other.points, other.points + Shape::size);
                check<Shape, double>(other, moved, 0, 0, failures);
                std::rotate(other.points, other.points + 1, other.points + Shape::size);
            }
            check<Shape, double>(other, moved, 0, 0, failures);
        }
    }
}

// Other scalars. Points and forms are those of float, so that all types have the same truth.
template <class Shape, class T> void test_scalar()
{
    Failures failures;
    Random random(630);
    for (int n = 0; n < draws(400); ++n) {
        auto c = random_case<Shape>(random, 4 * n + n % 2);
        for (auto &x : c.points) x = convert<double>(convert<float>(x));
        c.q = convert<double>(convert<float>(c.q));
        if (Shape::contact(c).status != pw85::Status::success) continue;
        check<Shape, T>(c, Shape::truth(convert<Wide>(c)), 0, 0, failures);
    }
}

/// Checks the answers of all functions for one case.
template <class Shape, class T> void expect_overlap(Case<Shape::size, T> const &c, bool expected, Failures &failures)
{
    auto const describe = [&] { return std::string(Shape::name) + ": " + text(convert<double>(c)); };
    auto const answer = Shape::overlap(c);
    failures.check(answer.status == pw85::Status::success && answer.overlap == expected, "overlap", answer.overlap,
                   expected, describe);
    bool const exactly = Shape::overlaps_exactly(c);
    failures.check(exactly == expected, "overlaps_exactly", exactly, expected, describe);
    if constexpr (std::is_same_v<T, double>) {
        int in_c = 7;
        Shape::overlap_in_c(c, &in_c);
        failures.check(in_c == expected, "pw85_overlap", in_c, expected, describe);
    }
}

/// Sets at distances such that |μ² - 1| is from 1e-17 to 1/2, for numbers of type T. Returns false if they are closer than what 50
/// digits can tell.
template <class Shape, class T> bool draw_near_touch(Random &random, int n, Case<Shape::size, T> &c, bool &overlaps)
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

template <class Shape, class T> void test_near_touch()
{
    Failures failures;
    Random random(660);
    int overlapping = 0, count = 0;
    for (int n = 0; n < draws(3000); ++n) {
        Case<Shape::size, T> c{};
        bool expected = false;
        if (!draw_near_touch<Shape, T>(random, n, c, expected)) continue;
        expect_overlap<Shape>(c, expected, failures);
        overlapping += expected;
        ++count;
        if constexpr (std::is_same_v<T, double>)
            for (int const exponent : {-400, -40, 40, 400})
                expect_overlap<Shape>(scaled(c, exponent, exponent), expected, failures);
    }
    g_test_message("%d of %d overlap", overlapping, count);
    g_assert_cmpint(overlapping, >, count / 4);
    g_assert_cmpint(overlapping, <, 3 * count / 4);
}

double random_integer(Random &random, int limit) { return std::floor(random.uniform(-limit, limit + 1)); }

// Small integers: the ellipsoid and the set touch exactly, at vertices, on edges and inside of faces.
template <class Shape> void test_small_integers()
{
    Failures failures;
    Random random(670);
    int touching = 0, overlapping = 0;
    for (int n = 0; n < draws(20000); ++n) {
        Case<Shape::size> c{};
        double const l[3][3] = {{1 + std::abs(random_integer(random, 2)), 0, 0},
                                {random_integer(random, 1), 1 + std::abs(random_integer(random, 2)), 0},
                                {random_integer(random, 1), random_integer(random, 1), 1}};
        for (int i = 0; i < 3; ++i)
            for (int j = i; j < 3; ++j)
                for (int k = 0; k < 3; ++k) c.q(i, j) += l[i][k] * l[j][k];
        for (auto &x : c.points) x = {random_integer(random, 3), random_integer(random, 3), random_integer(random, 3)};
        for (int i = 0; i < 3; ++i)
            if (std::is_same_v<Shape, Box> && c.points[0][i] > c.points[1][i])
                std::swap(c.points[0][i], c.points[1][i]);
        Wide const excess = Shape::truth(convert<Wide>(c)).mu2 - 1;
        bool const touches = abs(excess) < Wide("1e-40"); // a ratio of integers below 1e7 is not closer to 1
        expect_overlap<Shape>(scaled(c, n % 601 - 300, n % 601 - 300), !touches && excess < 0, failures);
        touching += touches;
        overlapping += !touches && excess < 0;
    }
    g_test_message("%d touch, %d overlap", touching, overlapping);
    g_assert_cmpint(touching, >, draws(200));
    g_assert_cmpint(overlapping, >, draws(2000));
}

// One unit in the last place on either side of an exact touch, for an ellipsoid that an integer map makes of a ball.
void test_beside_touch()
{
    Failures failures;
    Form3 const q{25, 0, 0, 25, 0, 25};
    Vector3 const a{3, 4, 0};
    for (int n = 0; n < 64; ++n) {
        double const reach = std::ldexp(1.0, n - 20);
        Vector3 const across{-4 * reach, 3 * reach, 0}, up{0, 0, reach};
        Case<2> const edge{{a - across, a + across}, q};
        Case<3> const face{{a - across - up, a + across - up, a + up}, q};
        for (double const towards : {0.0, 1e300, 25.0}) {
            auto e = edge;
            auto f = face;
            e.q[0] = f.q[0] = std::nextafter(25.0, towards);
            bool const exact = (a - across)[0] + across[0] == 3 && (a - across)[1] + across[1] == 4;
            if (!exact) continue; // the ends are rounded
            expect_overlap<Segment>(e, towards == 1e300, failures);
            expect_overlap<Triangle>(f, towards == 1e300, failures);
        }
    }
    for (double const towards : {0.0, 1e300, 5.0}) {
        Case<2> const box{{{-9, std::nextafter(5.0, towards), -9}, {9, 7, 9}}, q};
        expect_overlap<Box>(box, towards == 0.0, failures);
    }
}

// Every limb of the integers: numbers at both ends of the range.
template <class T> void test_widest()
{
    using Limits = std::numeric_limits<T>;
    Failures failures;
    T const tiny = Limits::denorm_min(), large = Limits::max() / 2;
    pw85::Vector<T, 3> const a{large, tiny, -tiny}, b{-large, tiny, large}, c{tiny, -large, tiny}, d{tiny, tiny, -tiny};
    pw85::SymmetricMatrix<T, 3> const wide{large, tiny, -tiny, large, tiny, large}, ball{1, tiny, -tiny, 1, tiny, 1};
    for (auto const &q : {wide, ball}) {
        bool const is_wide = q[0] > T(1);
        expect_overlap<Segment, T>({{a, b}, q}, false, failures);
        expect_overlap<Segment, T>({{a, d}, q}, true, failures);
        expect_overlap<Segment, T>({{d, d}, q}, true, failures);
        expect_overlap<Triangle, T>({{a, b, c}, q}, false, failures);
        expect_overlap<Triangle, T>({{a, {-large, -tiny, tiny}, c}, q}, true, failures);
        expect_overlap<Box, T>({{{T(1) / 2, tiny, -large}, {large, large, large}}, q}, true, failures);
        expect_overlap<Box, T>({{{T(1), tiny, -large}, {large, large, large}}, q}, is_wide, failures);
    }
}

// The bits of many are those of one, and a bad row is marked.
template <class Shape> void test_batch()
{
    constexpr std::size_t rows = 1000, bad = 600;
    Random random(640);
    std::vector<double> points[Shape::size], q, mu2(rows), point(3 * rows);
    std::vector<Case<Shape::size>> cases;
    for (std::size_t n = 0; n < rows; ++n) {
        auto c = random_case<Shape>(random, static_cast<int>(n));
        if (n == bad) c.q[0] = -1;
        cases.push_back(c);
        for (std::size_t k = 0; k < Shape::size; ++k)
            points[k].insert(points[k].end(), c.points[k].coordinates, c.points[k].coordinates + 3);
        q.insert(q.end(), c.q.entries, c.q.entries + 6);
    }
    double const *first[3] = {};
    for (std::size_t k = 0; k < Shape::size; ++k) first[k] = points[k].data();
    g_assert_cmpint(Shape::contact_batch(rows, first, q.data(), mu2.data(), point.data()), ==, PW85_ENOTPD);
    for (std::size_t n = 0; n < rows; ++n) {
        double one = 0, where[3] = {};
        int const status = Shape::contact_in_c(cases[n], &one, where);
        g_assert_cmpint(status, ==, n == bad ? PW85_ENOTPD : PW85_SUCCESS);
        g_assert_cmpmem(&one, sizeof one, &mu2[n], sizeof one);
        g_assert_cmpmem(where, sizeof where, &point[3 * n], sizeof where);
    }
    g_assert_cmpint(Shape::contact_batch(rows, first, q.data(), nullptr, nullptr), ==, PW85_ENOTPD);
    std::vector<unsigned char> overlap(rows, 7);
    g_assert_cmpint(Shape::overlap_batch(rows, first, q.data(), overlap.data()), ==, PW85_ENOTPD);
    for (std::size_t n = 0; n < rows; ++n) {
        int one = 7;
        Shape::overlap_in_c(cases[n], &one);
        g_assert_cmpint(overlap[n], ==, static_cast<unsigned char>(one));
    }
    first[1] = nullptr;
    g_assert_cmpint(Shape::overlap_batch(rows, first, q.data(), overlap.data()), ==, PW85_EINVAL);
    g_assert_cmpint(Shape::contact_batch(rows, first, q.data(), mu2.data(), point.data()), ==, PW85_EINVAL);
}

void expect(char const *what, pw85::ShapeContact<double> const &c, double mu2, Vector3 const &point)
{
    Failures failures;
    auto const describe = [&] { return std::string(what) + ", point " + hex_text(c.point.coordinates, 3); };
    failures.check(c.status == pw85::Status::success && c.mu2 == mu2, "mu2", c.mu2, mu2, describe);
    for (int i = 0; i < 3; ++i) failures.check(c.point[i] == point[i], "point", c.point[i], point[i], describe);
}

// Sets that are smaller than they look, and the centre in the set: numbers that need no rounding.
void test_degenerate()
{
    Form3 const q{4, 0, 0, 1, 0, 16};
    Vector3 const a{2, 0, 0}, b{2, 2, 0}, c{2, -4, 0}, zero{0, 0, 0}, far{-2, 0, 0};
    expect("point", pw85::contact_segment(a, a, q), 1, a);
    expect("point", pw85::contact_triangle(a, a, a, q), 1, a);
    expect("on a line", pw85::contact_triangle(b, b, c, q), 1, a);
    expect("on a line", pw85::contact_triangle(b, c, c, q), 1, a);
    expect("on a line", pw85::contact_triangle(c, b, a, q), 1, a);
    expect("through 0", pw85::contact_segment(a, far, q), 0, zero);
    expect("from 0", pw85::contact_segment(zero, a, q), 0, zero);
    expect("at 0", pw85::contact_segment(zero, zero, q), 0, zero);
    expect("at 0", pw85::contact_triangle(zero, zero, zero, q), 0, zero);
    expect("from 0", pw85::contact_triangle(a, zero, b, q), 0, zero);
    expect("around 0", pw85::contact_triangle<double>({4, 4, 0}, {-4, 4, 0}, {0, -4, 0}, q), 0, zero);
    expect("flat box", pw85::contact_box<double>({2, -1, -1}, {2, 1, 1}, q), 1, a);
    expect("a point", pw85::contact_box(b, b, q), 5, b);
    expect("box around 0", pw85::contact_box<double>({-1, -2, -3}, {1, 2, 3}, q), 0, zero);
    expect("0 on a face", pw85::contact_box<double>({0, -2, -3}, {1, 2, 3}, q), 0, zero);
    expect("half-space", pw85::contact_box<double>({-1e300, -1e300, 4}, {1e300, 1e300, 1e300}, q), 1, {0, 0, 4});
    expect("tiny", pw85::contact_segment<double>({0x1p-500, 0, 0}, {0x1p-500, 0x1p500, 0}, q), 0x1p-1002,
           {0x1p-500, 0, 0});
    Vector3 const distant{0x1p500, 0, 0};
    Form3 const small{0x1p-600, 0, 0, 0x1p-600, 0, 0x1p-600};
    expect("beyond the range", pw85::contact_segment(distant, distant, small), std::numeric_limits<double>::infinity(),
           distant);
}

/// Every number of a call that is refused is NaN.
template <class Shape> void refused(Case<Shape::size> const &c, int status)
{
    double mu2 = 0, point[3] = {};
    g_assert_cmpint(Shape::contact_in_c(c, &mu2, point), ==, status);
    g_assert_true(std::isnan(mu2) && std::isnan(point[0]) && std::isnan(point[1]) && std::isnan(point[2]));
    g_assert_cmpint(Shape::contact_in_c(c, nullptr, nullptr), ==, status);
    int overlap = 7;
    g_assert_cmpint(Shape::overlap_in_c(c, &overlap), ==, status);
    g_assert_cmpint(overlap, ==, -1);
    g_assert_cmpint(Shape::overlap_in_c(c, nullptr), ==, PW85_EINVAL);
}

template <class Shape> void test_status()
{
    Random random(650);
    auto const good = random_case<Shape>(random, 0);
    double const infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
    for (double const bad : {nan, infinity, -infinity}) {
        for (std::size_t k = 0; k < Shape::size; ++k)
            for (int i = 0; i < 3; ++i) {
                auto c = good;
                c.points[k][i] = bad;
                refused<Shape>(c, PW85_EINVAL);
            }
        for (int i = 0; i < 6; ++i) {
            auto c = good;
            c.q[i] = bad;
            refused<Shape>(c, PW85_EINVAL);
        }
    }
    for (Form3 const &bad : {Form3{1, 2, 0, 1, 0, 1}, Form3{1, 0, 0, 0, 0, 1}, Form3{1, 1, 1, 1, 1, 1}}) {
        auto c = good;
        c.q = bad;
        refused<Shape>(c, PW85_ENOTPD);
        for (auto &x : c.points) x = {0, 0, 0};
        refused<Shape>(c, PW85_ENOTPD);
    }
    if constexpr (std::is_same_v<Shape, Box>) {
        auto c = good;
        c.points[0][1] = std::nextafter(c.points[1][1], 1e300);
        refused<Shape>(c, PW85_EINVAL);
    }
}

template <class Shape> void add_tests()
{
    std::string const prefix = std::string("/shapes/") + Shape::name;
    g_test_add_func((prefix + "/random").c_str(), test_random<Shape>);
    g_test_add_func((prefix + "/sizes").c_str(), test_sizes<Shape>);
    g_test_add_func((prefix + "/orders").c_str(), test_orders<Shape>);
    g_test_add_func((prefix + "/float").c_str(), test_scalar<Shape, float>);
    g_test_add_func((prefix + "/long_double").c_str(), test_scalar<Shape, long double>);
    g_test_add_func((prefix + "/near_touch/double").c_str(), test_near_touch<Shape, double>);
    g_test_add_func((prefix + "/near_touch/float").c_str(), test_near_touch<Shape, float>);
    g_test_add_func((prefix + "/small_integers").c_str(), test_small_integers<Shape>);
    g_test_add_func((prefix + "/batch").c_str(), test_batch<Shape>);
    g_test_add_func((prefix + "/status").c_str(), test_status<Shape>);
}

} // namespace

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, nullptr);
    add_tests<Segment>();
    add_tests<Triangle>();
    add_tests<Box>();
    g_test_add_func("/shapes/degenerate", test_degenerate);
    g_test_add_func("/shapes/beside_touch", test_beside_touch);
    g_test_add_func("/shapes/widest/float", test_widest<float>);
    g_test_add_func("/shapes/widest/double", test_widest<double>);
    return g_test_run();
}
