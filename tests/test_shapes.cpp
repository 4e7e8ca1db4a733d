// SPDX-License-Identifier: BSD-3-Clause
// Tests of an ellipsoid and convex sets (include/pw85/shapes/) against brute force in 50 digits.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <glib.h>

#include <pw85.h>

#include "draws.hpp"
#include "integer_maps.hpp"
#include "shape_cases.hpp"

using namespace pw85_tests;

namespace {

/// The contact function in C, which is compiled per instruction set.
template <class Shape> pw85::ShapeContact<double> contact_in_c(Case<Shape::size> const &c)
{
    pw85::ShapeContact<double> found{};
    found.status =
        static_cast<pw85::Status>(Shape::contact_in_c(c, &found.mu2, found.point.coordinates));
    return found;
}

/// Checks the contact functions of one case in other units.
template <class Shape, class T> double check(Case<Shape::size> const &c, NearestTruth const &truth,
                                             int length, int form, Failures &failures)
{
    auto const in_units = scaled(c, length, form);
    if constexpr (std::is_same_v<T, double>)
        check_contact<Shape, double>(c, contact_in_c<Shape>(in_units), truth, length, form,
                                     failures);
    return check_contact<Shape, T>(c, Shape::contact(convert<T>(in_units)), truth, length, form,
                                   failures);
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

// The ellipsoid up to 1e300 times smaller or larger than the distance of the set, and both near the
// ends of the range.
template <class Shape> void test_sizes()
{
    Failures failures;
    Random random(610);
    for (int n = 0; n < draws(400); ++n) {
        auto const c = random_case<Shape>(random, n);
        auto const truth = Shape::truth(convert<Wide>(c));
        for (int const length : {-480, 0, 480})
            for (int const form : {-480, 0, 480})
                if (std::abs(length - form) < 500)
                    check<Shape, double>(c, truth, length, form, failures);
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

// Without the test of the normal (triangle.hpp), its rounding error would count. The smaller unit
// is one in which nothing is scaled.
void test_slivers()
{
    Failures failures;
    for (auto const &c : slivers()) {
        auto const truth = Triangle::truth(convert<Wide>(c));
        for (int const length : {0, -32}) check<Triangle, double>(c, truth, length, 0, failures);
    }
}

/// Checks the contact functions of one case in units of 2^0 and 2^±40, and that the exact answer
/// agrees where it can be told.
template <class Shape>
void check_with_overlap(Case<Shape::size> const &c, int n, Failures &failures)
{
    auto const truth = Shape::truth(convert<Wide>(c));
    for (int const exponent : {0, n % 2 == 0 ? 40 : -40}) {
        auto const in_units = scaled(c, exponent, exponent);
        check<Shape, double>(c, truth, exponent, exponent, failures);
        int overlap = 7;
        Shape::overlap_in_c(in_units, &overlap);
        double const mu2 = contact_in_c<Shape>(in_units).mu2;
        if (abs(Wide(truth.mu2 - 1)) > bound_of<double>(truth))
            failures.check((mu2 < 1) == (overlap == 1), "overlap", overlap, mu2,
                           [&] { return text(in_units); });
    }
}

// The place of the nearest point of the plane is lost in rounding errors before the normal is.
void test_long_slivers()
{
    Failures failures;
    Random random(640);
    for (int n = 0; n < draws(8000); ++n)
        check_with_overlap<Triangle>(long_sliver(random, n), n, failures);
    Case<3> const far_vertex{{{799999995, -599999992, -900000007}, {-1, 2, 9}, {-9, 9, 0}},
                             {1, 0, 0, 1, 0, 1}};
    check_with_overlap<Triangle>(far_vertex, 0, failures);
}

template <class T> void test_long_slivers_of()
{
    Failures failures;
    Random random(641);
    for (int n = 0; n < draws(400); ++n) {
        auto c = long_sliver(random, 2 * n); // of aspect ratios that float can tell
        if (n % 2 == 1) c.q = {1, 0, 0, 1, 0, 1};
        for (auto &x : c.points) x = convert<double>(convert<float>(x));
        c.q = convert<double>(convert<float>(c.q));
        if (Triangle::contact(c).status != pw85::Status::success) continue;
        check<Triangle, T>(c, Triangle::truth(convert<Wide>(c)), 0, 0, failures);
    }
}

// The rounding of coordinates counts to second order: at aspect ratio A it changes μ² by up to A²
// u².
template <class Shape> void test_thin_forms()
{
    Failures failures;
    Random random(642);
    for (int n = 0; n < draws(2000); ++n)
        check_with_overlap<Shape>(beside_thin_form<Shape>(random, n), n, failures);
}

// μ² is 0 where the set has the centre, whatever the point of the set is that rounding finds.
template <class Shape, class T> void test_around_center()
{
    Failures failures;
    Random random(643);
    for (int n = 0; n < draws(400); ++n) {
        auto const c = around_center<Shape>(random, n);
        if (Shape::truth(convert<Wide>(c)).mu2 > Wide("1e-60")) continue; // rounded
        auto const describe = [&] { return text(c); };
        auto const found = Shape::contact(convert<T>(c));
        bool const is_zero =
            found.mu2 == T(0) && pw85::detail::largest_coordinate(found.point) == T(0);
        failures.check(is_zero, "mu2", static_cast<double>(found.mu2), 0, describe);
        if constexpr (std::is_same_v<T, double>)
            for (int const exponent : {-400, -40, 0, 40, 400}) {
                double const in_c = contact_in_c<Shape>(scaled(c, exponent, exponent)).mu2;
                failures.check(in_c == 0, "mu2 in C", in_c, 0, describe);
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
template <class Shape, class T>
void expect_overlap(Case<Shape::size, T> const &c, bool expected, Failures &failures)
{
    auto const describe = [&] {
        return std::string(Shape::name) + ": " + text(convert<double>(c));
    };
    auto const answer = Shape::overlap(c);
    failures.check(answer.status == pw85::Status::success && answer.overlap == expected, "overlap",
                   answer.overlap, expected, describe);
    bool const exactly = Shape::overlaps_exactly(c);
    failures.check(exactly == expected, "overlaps_exactly", exactly, expected, describe);
    if constexpr (std::is_same_v<T, double>) {
        int in_c = 7;
        Shape::overlap_in_c(c, &in_c);
        failures.check(in_c == expected, "pw85_overlap", in_c, expected, describe);
    }
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

// Small integers: the ellipsoid and the set touch exactly, at vertices, on edges and inside of
// faces.
template <class Shape> void test_small_integers()
{
    Failures failures;
    Random random(670);
    int touching = 0, overlapping = 0;
    for (int n = 0; n < draws(20000); ++n) {
        Case<Shape::size> c{};
        auto const integer = [&](int limit) { return double(random_integer(random, limit)); };
        c.q = mapped_ball(IntegerMap<3>{{{1 + std::abs(integer(2)), 0, 0},
                                         {integer(1), 1 + std::abs(integer(2)), 0},
                                         {integer(1), integer(1), 1}}});
        for (auto &x : c.points) x = {integer(3), integer(3), integer(3)};
        for (int i = 0; i < 3; ++i)
            if (std::is_same_v<Shape, Box> && c.points[0][i] > c.points[1][i])
                std::swap(c.points[0][i], c.points[1][i]);
        Wide const excess = Shape::truth(convert<Wide>(c)).mu2 - 1;
        // a ratio of integers below 1e7 is not closer to 1
        bool const touches = abs(excess) < Wide("1e-40");
        expect_overlap<Shape>(scaled(c, n % 601 - 300, n % 601 - 300), !touches && excess < 0,
                              failures);
        touching += touches;
        overlapping += !touches && excess < 0;
    }
    g_test_message("%d touch, %d overlap", touching, overlapping);
    g_assert_cmpint(touching, >, draws(200));
    g_assert_cmpint(overlapping, >, draws(2000));
}

// One unit in the last place on either side of an exact touch, for an ellipsoid that an integer map
// makes of a ball.
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
    pw85::Vector<T, 3> const a{large, tiny, -tiny}, b{-large, tiny, large}, c{tiny, -large, tiny},
        d{tiny, tiny, -tiny};
    pw85::SymmetricMatrix<T, 3> const wide{large, tiny, -tiny, large, tiny, large},
        ball{1, tiny, -tiny, 1, tiny, 1};
    for (auto const &q : {wide, ball}) {
        bool const is_wide = q[0] > T(1);
        expect_overlap<Segment, T>({{a, b}, q}, false, failures);
        expect_overlap<Segment, T>({{a, d}, q}, true, failures);
        expect_overlap<Segment, T>({{d, d}, q}, true, failures);
        expect_overlap<Triangle, T>({{a, b, c}, q}, false, failures);
        expect_overlap<Triangle, T>({{a, {-large, -tiny, tiny}, c}, q}, true, failures);
        expect_overlap<Box, T>({{{T(1) / 2, tiny, -large}, {large, large, large}}, q}, true,
                               failures);
        expect_overlap<Box, T>({{{T(1), tiny, -large}, {large, large, large}}, q}, is_wide,
                               failures);
    }
}

void expect(char const *what, pw85::ShapeContact<double> const &c, double mu2, Vector3 const &point)
{
    Failures failures;
    auto const describe = [&] {
        return std::string(what) + ", point " + hex_text(c.point.coordinates, 3);
    };
    failures.check(c.status == pw85::Status::success && c.mu2 == mu2, "mu2", c.mu2, mu2, describe);
    for (int i = 0; i < 3; ++i)
        failures.check(c.point[i] == point[i], "point", c.point[i], point[i], describe);
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
    expect("around 0", pw85::contact_triangle<double>({4, 4, 0}, {-4, 4, 0}, {0, -4, 0}, q), 0,
           zero);
    expect("flat box", pw85::contact_box<double>({2, -1, -1}, {2, 1, 1}, q), 1, a);
    expect("a point", pw85::contact_box(b, b, q), 5, b);
    expect("box around 0", pw85::contact_box<double>({-1, -2, -3}, {1, 2, 3}, q), 0, zero);
    expect("0 on a face", pw85::contact_box<double>({0, -2, -3}, {1, 2, 3}, q), 0, zero);
    expect("half-space", pw85::contact_box<double>({-1e300, -1e300, 4}, {1e300, 1e300, 1e300}, q),
           1, {0, 0, 4});
    expect("tiny", pw85::contact_segment<double>({0x1p-500, 0, 0}, {0x1p-500, 0x1p500, 0}, q),
           0x1p-1002, {0x1p-500, 0, 0});
    Vector3 const distant{0x1p500, 0, 0};
    Form3 const small{0x1p-600, 0, 0, 0x1p-600, 0, 0x1p-600};
    expect("beyond the range", pw85::contact_segment(distant, distant, small),
           std::numeric_limits<double>::infinity(), distant);
}

/// Every number of a call that is refused is NaN.
template <class Shape> void refused(Case<Shape::size> const &c, int status)
{
    double mu2 = 0, point[3] = {};
    g_assert_cmpint(Shape::contact_in_c(c, &mu2, point), ==, status);
    g_assert_true(std::isnan(mu2) && std::isnan(point[0]) && std::isnan(point[1]) &&
                  std::isnan(point[2]));
    int overlap = 7;
    g_assert_cmpint(Shape::overlap_in_c(c, &overlap), ==, status);
    g_assert_cmpint(overlap, ==, -1);
}

template <class Shape> void test_status()
{
    Random random(650);
    auto const good = random_case<Shape>(random, 0);
    for (Form3 const &bad :
         {Form3{1, 2, 0, 1, 0, 1}, Form3{1, 0, 0, 0, 0, 1}, Form3{1, 1, 1, 1, 1, 1}}) {
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

/// Up to eight half-spaces, in two of three cases around a point, with normals of any length; in
/// the third one of small integers, so that planes are parallel, and more than three of them meet
/// in a point.
Planes random_planes(Random &random, int n)
{
    Planes planes;
    Vector3 const place = random.log_uniform(0.1, 10.0) * random.direction<3>();
    double const size = n % 3 == 1 ? random.log_uniform(1e-4, 10.0) : 1.0;
    for (int k = 0; k <= n % 8; ++k) {
        Vector3 g = random.log_uniform(1e-3, 1e3) * random.direction<3>();
        double offset =
            pw85::dot(g, place) + size * std::sqrt(pw85::dot(g, g)) * random.uniform(-0.3, 1.0);
        if (n % 3 == 2) {
            for (int i = 0; i < 3; ++i) g[i] = random_integer(random, 3);
            if (pw85::dot(g, g) == 0) g[k % 3] = 1;
            offset = random_integer(random, 9);
        }
        planes.normals.insert(planes.normals.end(), g.coordinates, g.coordinates + 3);
        planes.offsets.push_back(offset);
    }
    return planes;
}

std::string text(Planes const &planes, Form3 const &q)
{
    return "q = " + hex_text(q.entries, 6) + ", normals " +
           hex_text(planes.normals.data(), static_cast<int>(planes.normals.size())) + ", offsets " +
           hex_text(planes.offsets.data(), static_cast<int>(planes.offsets.size()));
}

void check_polytope(Planes const &planes, Form3 const &q, NearestTruth const &truth, int length,
                    int form, Failures &failures)
{
    auto moved = planes;
    for (double &offset : moved.offsets) offset = std::ldexp(offset, length);
    auto const found =
        pw85::contact_polytope(moved.offsets.size(), moved.normals.data(), moved.offsets.data(),
                               pw85::detail::times_power_of_two(q, 2 * form));
    auto const describe = [&] { return text(planes, q); };
    failures.check(found.status == pw85::Status::success, "status",
                   static_cast<double>(found.status), 0, describe);
    bool const empty = !(found.mu2 <= std::numeric_limits<double>::max());
    failures.check(empty == (truth.mu2 < 0), "empty", empty, truth.mu2 < 0, describe);
    if (empty || truth.mu2 < 0) return;
    Wide const mu2 = ldexp(Wide(found.mu2), 2 * (form - length)),
               bound = 32 * Wide(0x1p-53) * truth.sensitivity;
    failures.check(abs(Wide(mu2 - truth.mu2)) <= bound, "mu2", static_cast<double>(mu2),
                   static_cast<double>(truth.mu2), describe);
    if (!(truth.mu2 > 0))
        failures.check(found.mu2 == 0 && found.point[0] == 0, "inside", found.mu2, 0, describe);
}

// The point is not compared: of a needle, μ² is determined better than where it touches. Needles to
// aspect ratio 1e4, because whether planes have a common point is decided up to rounding errors.
void test_polytope()
{
    Failures failures;
    Random random(680);
    int empty = 0, inside = 0;
    for (int n = 0; n < draws(6000); ++n) {
        auto const q = random.form(1.0, random.log_uniform(1.0, n % 2 == 0 ? 10.0 : 1e4));
        auto const planes = random_planes(random, n);
        auto const truth = nearest_in_polytope(planes, convert<Wide>(q));
        check_polytope(planes, q, truth, 0, 0, failures);
        int const length = n % 2 == 0 ? 400 : -400;
        check_polytope(planes, q, truth, length, length + 40 * (n % 3 - 1), failures);
        empty += truth.mu2 < 0;
        inside += truth.mu2 == 0;
    }
    g_test_message("%d empty, %d around the centre", empty, inside);
    g_assert_cmpint(empty, >, draws(150));
    g_assert_cmpint(inside, >, draws(600));
}

// A ball from thousands of tangent planes: the nearest point is near that of the ball, and in all
// half-spaces.
void test_many_planes()
{
    Failures failures;
    Random random(690);
    Form3 const q{1, 0, 0, 1, 0, 1};
    Vector3 const center{3, 4, 12};
    for (std::size_t const count : {std::size_t{50}, std::size_t{500}, std::size_t{5000}}) {
        Planes planes;
        for (std::size_t k = 0; k < count; ++k) {
            auto const g = random.direction<3>();
            planes.normals.insert(planes.normals.end(), g.coordinates, g.coordinates + 3);
            planes.offsets.push_back(pw85::dot(g, center) + 1);
        }
        auto const found =
            pw85::contact_polytope(count, planes.normals.data(), planes.offsets.data(), q);
        double const reach = 13 - std::sqrt(found.mu2),
                     bound = 1 + 30.0 / static_cast<double>(count);
        auto const describe = [&] { return text(planes, q); };
        failures.check(found.status == pw85::Status::success && reach >= 1 && reach < bound, "ball",
                       reach, bound, describe);
        Planes active;
        for (std::size_t k = 0; k < count; ++k) {
            Vector3 const g{planes.normals[3 * k], planes.normals[3 * k + 1],
                            planes.normals[3 * k + 2]};
            double const slack = planes.offsets[k] - pw85::dot(g, found.point);
            failures.check(slack > -1e-13, "slack", slack, -1e-13, describe);
            if (slack > 1e-13) continue;
            active.normals.insert(active.normals.end(), g.coordinates, g.coordinates + 3);
            active.offsets.push_back(planes.offsets[k]);
        }
        auto const truth = nearest_in_polytope(active, convert<Wide>(q));
        failures.check(abs(Wide(truth.mu2 - found.mu2)) <= 32 * Wide(0x1p-53) * truth.sensitivity,
                       "mu2", found.mu2, static_cast<double>(truth.mu2), describe);
    }
}

void test_polytope_status()
{
    Form3 const q{4, 0, 0, 1, 0, 16};
    double const nan = std::numeric_limits<double>::quiet_NaN(),
                 infinity = std::numeric_limits<double>::infinity();
    double const slab[6] = {1, 0, 0, -1, 0, 0}, apart[2] = {-1, -1}, flat[2] = {2, -2},
                 one[1] = {-2};
    expect("the whole space", pw85::contact_polytope<double>(0, nullptr, nullptr, q), 0, {0, 0, 0});
    expect("half-space", pw85::contact_polytope(1, slab, one, q), 1, {-2, 0, 0});
    expect("flat", pw85::contact_polytope(2, slab, flat, q), 1, {2, 0, 0});
    auto const empty = pw85::contact_polytope(2, slab, apart, q);
    g_assert_true(empty.status == pw85::Status::success && empty.mu2 == infinity &&
                  std::isnan(empty.point[0]));
    auto const refused = [&](double const *normals, double const *offsets, Form3 const &form,
                             pw85::Status status) {
        auto const found = pw85::contact_polytope(1, normals, offsets, form);
        g_assert_true(found.status == status && std::isnan(found.mu2) &&
                      std::isnan(found.point[2]));
    };
    double const zero[3] = {0, 0, 0};
    refused(zero, one, q, pw85::Status::invalid_argument);
    refused(slab, one, {1, 2, 0, 1, 0, 1}, pw85::Status::not_positive_definite);
    for (double const bad : {nan, infinity, -infinity}) {
        double const normal[3] = {1, bad, 0};
        refused(normal, one, q, pw85::Status::invalid_argument);
        refused(slab, &bad, q, pw85::Status::invalid_argument);
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
    g_test_add_func((prefix + "/thin_forms").c_str(), test_thin_forms<Shape>);
    if constexpr (!std::is_same_v<Shape, Box>) {
        g_test_add_func((prefix + "/around_center/double").c_str(),
                        test_around_center<Shape, double>);
        g_test_add_func((prefix + "/around_center/long_double").c_str(),
                        test_around_center<Shape, long double>);
    }
    g_test_add_func((prefix + "/near_touch/double").c_str(), test_near_touch<Shape, double>);
    g_test_add_func((prefix + "/near_touch/float").c_str(), test_near_touch<Shape, float>);
    g_test_add_func((prefix + "/small_integers").c_str(), test_small_integers<Shape>);
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
    g_test_add_func("/shapes/slivers", test_slivers);
    g_test_add_func("/shapes/long_slivers", test_long_slivers);
    g_test_add_func("/shapes/long_slivers/float", test_long_slivers_of<float>);
    g_test_add_func("/shapes/long_slivers/long_double", test_long_slivers_of<long double>);
    g_test_add_func("/shapes/beside_touch", test_beside_touch);
    g_test_add_func("/shapes/polytope/random", test_polytope);
    g_test_add_func("/shapes/polytope/many_planes", test_many_planes);
    g_test_add_func("/shapes/polytope/status", test_polytope_status);
    g_test_add_func("/shapes/widest/float", test_widest<float>);
    g_test_add_func("/shapes/widest/double", test_widest<double>);
    return g_test_run();
}
