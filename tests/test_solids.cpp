// SPDX-License-Identifier: BSD-3-Clause
// Tests of the signed distance of an ellipsoid and a segment, a triangle or a box
// (include/pw85/distance/solids.hpp).
//
// Where they are apart, the truth in 50 digits proves itself: the width of a slab between them is a
// lower bound of the distance, and the distance of two of their points is an upper bound. Where
// they overlap, many other directions are tried.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glib.h>

#include <pw85.h>
#include <pw85/distance/solids.hpp>

#include "draws.hpp"
#include "rotated.hpp"
#include "shape_cases.hpp"

using namespace pw85_tests;

namespace {

constexpr double u = 0x1p-53;

template <class T> using Distance = pw85::ShapeDistance<T>;

// The three kinds of sets by the functions in C and C++.

struct SegmentDistance : Segment {
    using Kind = Segment;
    template <class T> static Distance<T> in_cpp(Case<2, T> const &c)
    {
        return pw85::distance_segment(c.points[0], c.points[1], c.q);
    }
    static int in_c(Case<2> const &c, double *distance, double *point1, double *point2,
                    double *normal)
    {
        return pw85_distance_segment(c.points[0].coordinates, c.points[1].coordinates, c.q.entries,
                                     distance, point1, point2, normal);
    }
};

struct TriangleDistance : Triangle {
    using Kind = Triangle;
    template <class T> static Distance<T> in_cpp(Case<3, T> const &c)
    {
        return pw85::distance_triangle(c.points[0], c.points[1], c.points[2], c.q);
    }
    static int in_c(Case<3> const &c, double *distance, double *point1, double *point2,
                    double *normal)
    {
        return pw85_distance_triangle(c.points[0].coordinates, c.points[1].coordinates,
                                      c.points[2].coordinates, c.q.entries, distance, point1,
                                      point2, normal);
    }
};

struct BoxDistance : Box {
    using Kind = Box;
    template <class T> static Distance<T> in_cpp(Case<2, T> const &c)
    {
        return pw85::distance_solid_box(c.points[0], c.points[1], c.q);
    }
    static int in_c(Case<2> const &c, double *distance, double *point1, double *point2,
                    double *normal)
    {
        return pw85_distance_solid_box(c.points[0].coordinates, c.points[1].coordinates,
                                       c.q.entries, distance, point1, point2, normal);
    }
};

template <class Shape> Distance<double> distance_in_c(Case<Shape::size> const &c)
{
    Distance<double> d{};
    d.status = static_cast<pw85::Status>(Shape::in_c(c, &d.distance, d.point1.coordinates,
                                                     d.point2.coordinates, d.normal.coordinates));
    return d;
}

Distance<Wide> convert_distance(Distance<double> const &d)
{
    return {d.distance, convert<Wide>(d.point1), convert<Wide>(d.point2), convert<Wide>(d.normal),
            d.status};
}

/// The vertices of a set.
template <class Shape, class T>
std::vector<pw85::Vector<T, 3>> vertices(Case<Shape::size, T> const &c)
{
    if constexpr (!std::is_base_of_v<Box, Shape>) {
        return {c.points, c.points + Shape::size};
    } else {
        std::vector<pw85::Vector<T, 3>> corners;
        for (int code = 0; code < 8; ++code)
            corners.push_back(
                {c.points[code & 1][0], c.points[code >> 1 & 1][1], c.points[code >> 2][2]});
        return corners;
    }
}

/// The width of the slab that is normal to a vector of any length.
template <class Shape, class T>
T width_along(Case<Shape::size, T> const &c, pw85::Vector<T, 3> const &n)
{
    using std::sqrt;
    auto const points = vertices<Shape>(c);
    T least = pw85::dot(n, points[0]);
    for (auto const &x : points) least = std::min(least, pw85::dot(n, x));
    T const half_width = sqrt(pw85::dot(n, pw85::product(c.q, n)));
    return (least - half_width) / sqrt(pw85::dot(n, n));
}

/// Σ of the contract.
template <class Shape> Wide sensitivity(Case<Shape::size, Wide> const &c, WideVector const &n)
{
    Wide farthest = 0;
    for (auto const &x : vertices<Shape>(c)) farthest = std::max(farthest, norm(x));
    return farthest + absolute_form(c.q, n) / (2 * pw85::detail::support(c.q, n).extent);
}

/// How far a point of the truth is from the set, as a check of the truth.
template <class Shape> Wide distance_from_set(Case<Shape::size, Wide> const &c, WideVector const &x)
{
    if constexpr (std::is_base_of_v<Box, Shape>) {
        Wide most = 0;
        for (int i = 0; i < 3; ++i)
            most = std::max({most, c.points[0][i] - x[i], x[i] - c.points[1][i]});
        return most;
    } else {
        WideForm const ball{1, 0, 0, 1, 0, 1};
        auto moved = c;
        for (auto &y : moved.points) y = y - x;
        moved.q = ball;
        return sqrt(std::max(Wide(0), Shape::truth(moved).mu2));
    }
}

/// The distance in 50 digits. If they are apart, the points prove it.
template <class Shape>
Distance<Wide> proved_distance(Case<Shape::size, Wide> const &c, Failures &failures)
{
    auto const d = Shape::in_cpp(c);
    auto const describe = [] { return std::string("the truth"); };
    Wide const scale = sensitivity<Shape>(c, d.normal), tiny = Wide("1e-30") * scale;
    failures.check(abs(Wide(width_along<Shape>(c, d.normal) - d.distance)) <= tiny, "lower bound",
                   static_cast<double>(d.distance), 0.0, describe);
    if (d.distance < 0) return d;
    Wide const upper = norm(d.point2 - d.point1);
    failures.check(upper - d.distance <= tiny, "upper bound", static_cast<double>(upper),
                   static_cast<double>(d.distance), describe);
    Wide const on_surface = pw85::dot(d.point1, pw85::product(inverse(c.q), d.point1)) - 1;
    failures.check(abs(on_surface) <= Wide("1e-28"), "surface", static_cast<double>(on_surface),
                   0.0, describe);
    failures.check(distance_from_set<Shape>(c, d.point2) <= tiny, "set",
                   static_cast<double>(distance_from_set<Shape>(c, d.point2)), 0.0, describe);
    return d;
}

/// Checks a result of C, in units of 2^exponent; returns the error in units of u Σ.
template <class Shape> double check(Case<Shape::size> const &c, Distance<Wide> const &truth,
                                    int exponent, Failures &failures)
{
    auto const found = distance_in_c<Shape>(scaled(c, exponent, exponent));
    auto const wide = convert<Wide>(c);
    auto const describe = [&] { return text(c); };
    Wide const distance = pw85::detail::times_power_of_two(Wide(found.distance), -exponent),
               unit = u * sensitivity<Shape>(wide, truth.normal);
    Wide const error = abs(Wide(distance - truth.distance)) / unit;
    failures.check(found.status == pw85::Status::success && error <= 16, "distance", found.distance,
                   static_cast<double>(truth.distance), describe);
    return static_cast<double>(error);
}

/// The points are on the surface and in the set, up to rounding errors, and differ by the distance
/// along the normal. The factor 2^18 is that of pw85_signed_distance().
template <class Shape> void check_points(Case<Shape::size> const &c, Failures &failures)
{
    auto const d = convert_distance(distance_in_c<Shape>(c));
    auto const wide = convert<Wide>(c);
    Wide reach = sqrt(pw85::detail::largest_diagonal(wide.q));
    for (auto const &x : vertices<Shape>(wide)) reach = std::max(reach, norm(x));
    Wide const bound = 0x1p18 * u * reach;
    auto const describe = [&] { return text(c); };
    auto const check_size = [&](char const *what, Wide const &size) {
        failures.check(size <= bound, what, static_cast<double>(size), static_cast<double>(bound),
                       describe);
    };
    check_size("points", norm(d.point2 - d.point1 - d.distance * d.normal));
    check_size("set", distance_from_set<Shape>(wide, d.point2));
    check_size("surface", abs(pw85::distance_point(d.point1, wide.q).distance));
    check_size("unit normal", abs(norm(d.normal) - 1) * reach);
}

template <class Shape> void test_random()
{
    Failures failures;
    Random random(900);
    double worst = 0;
    for (int n = 0; n < draws(8000); ++n) {
        auto const c = random_case<typename Shape::Kind>(random, n);
        auto const truth = proved_distance<Shape>(convert<Wide>(c), failures);
        for (int const exponent : {0, n % 2 == 0 ? 40 : -40})
            worst = std::max(worst, check<Shape>(c, truth, exponent, failures));
        if (n % 4 < 3) check_points<Shape>(c, failures); // aspect ratios up to 10³
    }
    g_test_message("largest error %.3g u sum", worst);
}

/// The ellipsoid and the set of other sizes, near the ends of the range.
template <class Shape> void test_sizes()
{
    Failures failures;
    Random random(910);
    for (int n = 0; n < draws(400); ++n) {
        auto const c = random_case<typename Shape::Kind>(random, n);
        auto const truth = proved_distance<Shape>(convert<Wide>(c), failures);
        for (int const exponent : {-480, 480}) check<Shape>(c, truth, exponent, failures);
    }
}

/// A set that overlaps an ellipsoid with an aspect ratio up to 100, deep or shallow, and often with
/// a vertex, an edge or a face through the centre or in a plane of symmetry.
template <class Shape> Case<Shape::size> overlapping_case(Random &random, int n)
{
    for (;;) {
        Case<Shape::size> c{{},
                            random.form(1.0, random.log_uniform(1.0, n % 3 == 0 ? 100.0 : 5.0))};
        if (n % 5 == 0) c.q = {1.0, 0.0, 0.0, n % 2 == 0 ? 1.0 : 0.25, 0.0, 0.0625};
        double const size = random.log_uniform(0.1, 4.0);
        Vector3 const place = random.uniform(0.0, 1.0) * random.direction<3>();
        for (auto &x : c.points) x = pw85::detail::add_scaled(place, size, random.direction<3>());
        for (int i = 0; i < 3; ++i) {
            if (n % 4 == 1) c.points[0][i] = 0.0;
            if (n % 4 == 2) c.points[1][i] = -c.points[0][i];
            if (n % 4 == 3 && i > 0) c.points[0][i] = c.points[1][i] = 0.0;
            if (std::is_base_of_v<Box, Shape> && c.points[0][i] > c.points[1][i])
                std::swap(c.points[0][i], c.points[1][i]);
        }
        int overlap = 0;
        Shape::overlap_in_c(c, &overlap);
        if (overlap == 1) return c;
    }
}

/// Climbs from n to a local maximum of the width.
template <class Shape> double climb(Case<Shape::size> const &c, Vector3 n, Random &random)
{
    double best = width_along<Shape>(c, n);
    for (double step = 0.5; step > 1e-7;) {
        bool found = false;
        for (int k = 0; k < 8 && !found; ++k) {
            auto const tried = pw85::detail::add_scaled(n, step, random.direction<3>());
            double const width = width_along<Shape>(c, tried);
            found = width > best;
            if (found) best = width, n = 1.0 / norm(tried) * tried;
        }
        if (!found) step *= 0.5;
    }
    return best;
}

/// No other direction separates by a shorter way. The factor 64 is for the rounding errors of the
/// widths in this test, with half-widths of 0.01 and coordinates up to 6.
template <class Shape> void test_depths()
{
    Failures failures;
    Random random(920);
    for (int n = 0; n < draws(1600); ++n) {
        auto const c = overlapping_case<Shape>(random, n);
        auto const describe = [&] { return text(c); };
        auto const truth = proved_distance<Shape>(convert<Wide>(c), failures);
        check<Shape>(c, truth, 0, failures);
        check_points<Shape>(c, failures);
        double const found = distance_in_c<Shape>(c).distance;
        failures.check(found <= 0, "sign", found, 0.0, describe);
        for (int k = 0; k < 12; ++k) {
            double const other = climb<Shape>(c, random.direction<3>(), random);
            failures.check(other <= found + 64 * u * 100, "another direction", other, found,
                           describe);
        }
    }
}

/// Moves the set or turns the ellipsoid in 50 digits. The third derivative of the distance is below
/// 1e12 here, so that the central differences err by less than 1e-18.
template <class Shape> void test_derivatives()
{
    Failures failures;
    Random random(930);
    for (int n = 0; n < draws(200); ++n) {
        auto const c = n % 2 == 0 ? overlapping_case<Shape>(random, 20 * n + 4)
                                  : random_case<typename Shape::Kind>(random, 4 * n);
        auto const wide = convert<Wide>(c);
        auto const d = Shape::in_cpp(wide);
        auto const direction = convert<Wide>(random.direction<3>());
        Wide const h = Wide("1e-15");
        auto const moved = [&](Wide const &step) {
            auto other = wide;
            for (auto &x : other.points) x = x + step * direction;
            return Shape::in_cpp(other).distance;
        };
        auto const turned = [&](Wide const &step) {
            auto other = wide;
            other.q = rotated(wide.q, step * direction);
            return Shape::in_cpp(other).distance;
        };
        auto const describe = [&] { return text(c); };
        auto const compare = [&](char const *what, Wide const &difference, Wide const &derivative) {
            failures.check(abs(difference - derivative) <= Wide("1e-12"), what,
                           static_cast<double>(difference), static_cast<double>(derivative),
                           describe);
        };
        compare("translation", (moved(h) - moved(-h)) / (2 * h), pw85::dot(d.normal, direction));
        compare("rotation", (turned(h) - turned(-h)) / (2 * h),
                pw85::dot(pw85::cross(d.normal, d.point1), direction));
    }
}

/// The distance is positive only if the set is apart and negative only if it overlaps, also of sets
/// that touch up to rounding errors.
template <class Shape> void test_signs()
{
    Failures failures;
    Random random(940);
    for (int n = 0; n < draws(8000); ++n) {
        auto c = random_case<typename Shape::Kind>(random, n);
        double const mu2 = Shape::contact(c).mu2, factor = 1.0 / std::sqrt(mu2);
        if (!(mu2 > 0)) continue;
        for (auto &x : c.points) x = factor * x;
        int overlap = 0;
        Shape::overlap_in_c(c, &overlap);
        double const distance = distance_in_c<Shape>(c).distance;
        failures.check(overlap == 1 ? distance <= 0 : distance >= 0, "sign", distance, overlap,
                       [&] { return text(c); });
    }
}

template <class Shape> void add_tests()
{
    auto const add = [](char const *what, void (*test)()) {
        std::string const path = std::string("/solids/") + Shape::name + "/" + what;
        g_test_add_func(path.c_str(), test);
    };
    add("random", test_random<Shape>);
    add("sizes", test_sizes<Shape>);
    add("depths", test_depths<Shape>);
    add("derivatives", test_derivatives<Shape>);
    add("signs", test_signs<Shape>);
}

/// Sets without a length or an area are a point, of which pw85_distance_point() has the answer.
void test_points()
{
    Failures failures;
    Random random(950);
    for (int n = 0; n < draws(800); ++n) {
        auto const q = random.form(1.0, random.log_uniform(1.0, 1e3));
        auto const x = random_place(random, q, n);
        double expected, point[3], normal[3];
        pw85_distance_point(x.coordinates, q.entries, &expected, point, normal);
        Case<2> const two{{x, x}, q};
        Case<3> const three{{x, x, x}, q};
        for (double const found : {distance_in_c<SegmentDistance>(two).distance,
                                   distance_in_c<TriangleDistance>(three).distance,
                                   distance_in_c<BoxDistance>(two).distance})
            failures.check(found == expected || std::fabs(found) <= 1e-15, "point", found, expected,
                           [&] { return text(two); });
    }
}

/// A ball of radius 2 and the unit cube about its centre: the shortest way is along an axis, 2.5.
/// Outside, the nearest point of a box is its corner.
void test_by_hand()
{
    double const ball[6] = {4, 0, 0, 4, 0, 4}, half[3] = {0.5, 0.5, 0.5},
                 minus[3] = {-0.5, -0.5, -0.5}, far[3] = {3, 3, 3}, near[3] = {2, 2, 2};
    double distance, point1[3], point2[3], normal[3];
    pw85_distance_solid_box(minus, half, ball, &distance, point1, point2, normal);
    g_assert_cmpfloat(distance, ==, -2.5);
    pw85_distance_solid_box(near, far, ball, &distance, point1, point2, normal);
    g_assert_cmpfloat(std::fabs(distance - (std::sqrt(12.0) - 2.0)), <=, 8 * u);
    g_assert_cmpfloat(point2[0], ==, 2.0);
}

/// The set is a point, farther away by up to 2^1535 than the ellipsoid is large, or overlaps a ball
/// and reaches to the ends of the range of double.
void test_far_sets()
{
    auto const check = [](auto shape, auto const &c, double expected, double error) {
        auto const d = distance_in_c<decltype(shape)>(c);
        g_assert_true(d.status == pw85::Status::success);
        g_assert_cmpfloat(std::fabs(d.distance - expected), <=, error);
        g_assert_cmpfloat(std::fabs(norm(d.normal) - 1), <=, 8 * u);
    };
    for (int const size : {-1074, -1000, 0, 1000})
        for (int const exponent : {500, 800, 1022}) {
            pw85::SymmetricMatrix<double, 3> q{};
            q[0] = q[3] = q[5] = std::ldexp(1.0, size);
            double const far = std::ldexp(1.0, exponent), most = 1.5 * far - std::sqrt(q[0]);
            Vector3 const x{far, far, 0.5 * far};
            check(SegmentDistance{}, Case<2>{{x, x}, q}, most, 16 * u * far);
            check(TriangleDistance{}, Case<3>{{x, x, x}, q}, most, 16 * u * far);
            check(BoxDistance{}, Case<2>{{x, x}, q}, most, 16 * u * far);
        }
    double const end = std::numeric_limits<double>::max();
    pw85::SymmetricMatrix<double, 3> const ball{1, 0, 0, 1, 0, 1};
    check(SegmentDistance{}, Case<2>{{{-end, 0.5, 0}, {end, 0.5, 0}}, ball}, -0.5, 0);
    check(TriangleDistance{}, Case<3>{{{-end, 5, 0}, {end, 5, 0}, {0, 5, 1}}, ball}, 4, 0);
    check(BoxDistance{}, Case<2>{{{-end, -end, -end}, {end, end, -0.5}}, ball}, -0.5, 0);
}

/// A needle along x beside a segment that is 2^1326 times as long as the needle is thick. Its
/// elliptic section with semi-axes 3 s and s is turned, and the segment is at x + s n, where n is
/// the normal at the point x of the section. The entries have terms up to 9 s² and the point has
/// some up to 4 s, each with a few roundings.
void test_long_segment()
{
    for (int const exponent : {-360, -400, -426}) {
        double const s = std::ldexp(1.0, exponent), length = std::ldexp(1.0, 900);
        pw85::SymmetricMatrix<double, 3> q{};
        q(0, 0) = std::ldexp(1.0, -600);
        q(1, 1) = (9 * 0.36 + 0.64) * s * s;
        q(1, 2) = 8 * 0.48 * s * s;
        q(2, 2) = (9 * 0.64 + 0.36) * s * s;
        double const n[2] = {-0.28, 0.96}; // (0.6, 0.8), turned
        double const extent = std::sqrt(9 * 0.36 + 0.64);
        double const y = (9 * 0.6 * 0.6 - 0.8 * 0.8) * s / extent + n[0] * s,
                     z = (9 * 0.6 * 0.8 + 0.8 * 0.6) * s / extent + n[1] * s;
        auto const d =
            distance_in_c<SegmentDistance>(Case<2>{{{-length, y, z}, {length, y, z}}, q});
        g_assert_true(d.status == pw85::Status::success);
        g_assert_cmpfloat(std::fabs(d.distance - s), <=, 64 * u * s);
        g_assert_cmpfloat(std::fabs(d.normal[1] - n[0]), <=, 64 * u);
        g_assert_cmpfloat(std::fabs(d.normal[2] - n[1]), <=, 64 * u);
    }
}

/// A ball of radius 1 touches the plane x = 1 exactly.
void test_touching()
{
    double const ball[6] = {1, 0, 0, 1, 0, 1}, lower[3] = {1, -1, -1}, upper[3] = {2, 1, 1},
                 third[3] = {1, 1, -3};
    double distance, point1[3], point2[3], normal[3];
    pw85_distance_solid_box(lower, upper, ball, &distance, point1, point2, normal);
    g_assert_cmpfloat(distance, ==, 0.0);
    g_assert_cmpfloat(normal[0], ==, 1.0);
    double const vertex[3] = {1, 1, 5};
    pw85_distance_triangle(lower, vertex, third, ball, &distance, point1, point2, normal);
    g_assert_cmpfloat(distance, ==, 0.0);
}

/// A matrix such as those of Eigen.
struct Called {
    double entries_of_columns[9];
    double operator()(int i, int j) const { return entries_of_columns[3 * j + i]; }
};

/// A pose by a matrix of any type is that by nine numbers. The matrix turns x to y, y to z and z to
/// x, so that its transpose is another one.
void test_rotations()
{
    pw85::Vector<double, 3> const axes{1, 2, 3};
    double const flat[9] = {0, 0, 1, 1, 0, 0, 0, 1, 0};
    double const rows[3][3] = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
    std::array<std::array<double, 3>, 3> const arrays{{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}};
    std::array<Vector3, 3> const vectors{{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}};
    std::array<double, 9> const nine{0, 0, 1, 1, 0, 0, 0, 1, 0};
    pw85::Factor<double, 3> const factor{{0, 0, 1, 1, 0, 0, 0, 1, 0}};
    Called const called{{0, 1, 0, 0, 0, 1, 1, 0, 0}};
    auto const expected = pw85::ellipsoid(axes, flat);
    g_assert_cmpfloat(expected.q[0], ==, 9.0);
    g_assert_cmpfloat(expected.q[3], ==, 1.0);
    auto const same = [&](pw85::Form<double, 3> const &form) {
        g_assert_true(form.status == pw85::Status::success);
        for (int k = 0; k < 6; ++k) g_assert_cmpfloat(form.q[k], ==, expected.q[k]);
    };
    same(pw85::ellipsoid(axes, rows));
    same(pw85::ellipsoid(axes, arrays));
    same(pw85::ellipsoid(axes, vectors));
    same(pw85::ellipsoid(axes, nine));
    same(pw85::ellipsoid(axes, factor));
    same(pw85::ellipsoid(axes, called));
    pw85::SymmetricMatrix<double, 3> const half_turn{-1, 0, 0, -1, 0, 1};
    g_assert_cmpfloat(pw85::ellipsoid(axes, half_turn).q[5], ==, 9.0);
    pw85::Vector<float, 3> const floats{1, 2, 3};
    g_assert_cmpfloat(double(pw85::ellipsoid(floats, rows).q[0]), ==, 9.0);
    double const stretched[3][3] = {{0, 0, 2}, {1, 0, 0}, {0, 1, 0}};
    g_assert_true(pw85::ellipsoid(axes, stretched).status == pw85::Status::invalid_argument);
}

} // namespace

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, nullptr);
    add_tests<SegmentDistance>();
    add_tests<TriangleDistance>();
    add_tests<BoxDistance>();
    g_test_add_func("/solids/points", test_points);
    g_test_add_func("/solids/by_hand", test_by_hand);
    g_test_add_func("/solids/far_sets", test_far_sets);
    g_test_add_func("/solids/long_segment", test_long_segment);
    g_test_add_func("/solids/touching", test_touching);
    g_test_add_func("/solids/rotations", test_rotations);
    return g_test_run();
}
