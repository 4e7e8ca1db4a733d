// SPDX-License-Identifier: BSD-3-Clause
// Tests of distances to triangle meshes: against all triangles one by one, in 50 digits, and by the
// solid angles under which a closed mesh is seen.
#include <algorithm>
#include <cstring>

#include <pw85/distance/solids.hpp>

#include "cases.hpp"
#include "draws.hpp"
#include "mesh_cases.hpp"
#include "shapes_truth.hpp"

using namespace pw85_tests;

namespace {

using pw85::Status;
using pw85_tests::convert;
using pw85_tests::nan; // not the function of <cmath>

/// The least distance of all triangles, one by one.
pw85::MeshDistance nearest_of_all(Soup const &soup, Case const &c)
{
    pw85::MeshDistance best{infinity, {nan, nan, nan}, {nan, nan, nan}, {nan, nan, nan}, -1,
                            0,        Status::success};
    for (std::size_t k = 0; k < soup.triangles.size(); ++k) {
        Vector3 const a = soup.relative(k, 0, c.center), b = soup.relative(k, 1, c.center),
                      d = soup.relative(k, 2, c.center);
        pw85::MeshDistance one{};
        int const status = pw85_distance_triangle(
            a.coordinates, b.coordinates, d.coordinates, c.q.entries, &one.distance,
            one.point1.coordinates, one.point2.coordinates, one.normal.coordinates);
        g_assert_cmpint(status, ==, PW85_SUCCESS);
        one.triangle = static_cast<std::int32_t>(k);
        if (one.distance < best.distance) best = one;
    }
    return best;
}

bool same_bits(Vector3 const &a, Vector3 const &b) { return std::memcmp(&a, &b, sizeof a) == 0; }

void expect_nearest(Soup const &soup, pw85::Mesh const &mesh, Case const &c, Failures &failures)
{
    auto const found = pw85::mesh_distance(mesh, c.center, c.q), expected = nearest_of_all(soup, c);
    auto const describe = [&] {
        return std::to_string(soup.triangles.size()) + " triangles, " + text(c);
    };
    failures.check(found.status == Status::success, "status", static_cast<double>(found.status), 0,
                   describe);
    failures.check(found.triangle == expected.triangle, "triangle", found.triangle,
                   expected.triangle, describe);
    failures.check(found.distance == expected.distance, "distance", found.distance,
                   expected.distance, describe);
    failures.check(same_bits(found.point1, expected.point1), "point1", found.point1[0],
                   expected.point1[0], describe);
    failures.check(same_bits(found.point2, expected.point2), "point2", found.point2[0],
                   expected.point2[0], describe);
    failures.check(same_bits(found.normal, expected.normal), "normal", found.normal[0],
                   expected.normal[0], describe);
}

// The bits of the least of all triangles.
PW85_TEST("/mesh_distance/nearest")
{
    Failures failures;
    Random random(800);
    for_each_case(random, draws(120), 8,
                  [&](Soup const &soup, pw85::Mesh const &mesh, Case const &c, int) {
                      expect_nearest(soup, mesh, c, failures);
                  });
}

// Many triangles at equal distances up to rounding errors: a ball in the middle of a sphere of
// triangles, and one above a grid.
PW85_TEST("/mesh_distance/equally_near")
{
    Failures failures;
    Random random(801);
    for (int n = 0; n < draws(80); ++n) {
        bool const sphere = n % 2 == 0;
        Soup soup = grid(10 + n % 7, sphere);
        double const height = random.log_uniform(1e-8, 1e8), square = 0.25 * height * height;
        Case c{{0, 0, sphere ? 0 : height}, Form3{square, 0, 0, square, 0, square}};
        if (n % 4 == 1) c.q = random.form(height, random.log_uniform(1.0, 1e4));
        if (n % 8 == 3) { // a plane that is oblique to the axes, with rounded vertices
            Vector3 const a = random.direction<3>(), b = random.direction<3>();
            for (auto &x : soup.vertices) x = pw85::detail::add_scaled(x[0] * a, x[1], b);
        }
        expect_nearest(soup, soup.mesh(), c, failures);
    }
}

// In 50 digits, with the bound of pw85_distance_triangle(): R of the triangle that is nearest in
// these digits, and the normal there.
PW85_TEST("/mesh_distance/wide")
{
    Failures failures;
    Random random(802);
    Soup const soup = random_soup(random, 60);
    auto const mesh = soup.mesh();
    for (int n = 0; n < draws(64); ++n) {
        Case const c = random_case(random, n);
        auto const q = convert<Wide>(c.q);
        pw85::ShapeDistance<Wide> best{};
        Wide reach = -1;
        for (std::size_t k = 0; k < soup.triangles.size(); ++k) {
            WideVector const points[3] = {convert<Wide>(soup.relative(k, 0, c.center)),
                                          convert<Wide>(soup.relative(k, 1, c.center)),
                                          convert<Wide>(soup.relative(k, 2, c.center))};
            auto const one = pw85::distance_triangle(points[0], points[1], points[2], q);
            if (reach >= 0 && one.distance >= best.distance) continue;
            best = one;
            reach = 0;
            for (auto const &x : points) reach = std::max(reach, Wide(sqrt(pw85::dot(x, x))));
        }
        Wide terms = 0;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) terms += abs(best.normal[i] * q(i, j) * best.normal[j]);
        Wide const extent = sqrt(pw85::detail::quadratic_form(q, best.normal)),
                   bound = 16 * Wide(0x1p-53) * (reach + terms / (2 * extent));
        auto const found = pw85::mesh_distance(mesh, c.center, c.q);
        Wide const error = abs(Wide(found.distance) - best.distance);
        failures.check(error <= bound, "distance", double(error), double(bound),
                       [&] { return text(c); });
    }
}

/// A torus about the z axis, or about a turned one, as a grid of n by n squares.
Soup torus(int n, double thickness)
{
    Soup soup;
    auto const index = [n](int i, int j) { return (i % n) * n + j % n; };
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            double const theta = 2 * std::numbers::pi * i / n, phi = 2 * std::numbers::pi * j / n;
            double const r = 1 + thickness * std::cos(theta);
            soup.vertices.push_back(
                {r * std::cos(phi), r * std::sin(phi), thickness * std::sin(theta)});
            soup.triangles.push_back({index(i, j), index(i, j + 1), index(i + 1, j)});
            soup.triangles.push_back({index(i + 1, j), index(i, j + 1), index(i + 1, j + 1)});
        }
    return soup;
}

/// The cube of the points with coordinates from -1 to 1. Each triangle has vertices of its own, as
/// in an STL file.
Soup cube()
{
    Soup soup;
    for (int axis = 0; axis < 3; ++axis)
        for (double const side : {-1.0, 1.0}) {
            auto const corner = [&](double u, double v) {
                Vector3 x;
                x[axis] = side;
                x[(axis + 1) % 3] = u;
                x[(axis + 2) % 3] = side * v;
                return x;
            };
            auto const add = [&](Vector3 const &a, Vector3 const &b, Vector3 const &c) {
                auto const first = static_cast<std::int32_t>(soup.vertices.size());
                for (auto const &x : {a, b, c}) soup.vertices.push_back(x);
                soup.triangles.push_back({first, first + 1, first + 2});
            };
            add(corner(-1, -1), corner(1, -1), corner(1, 1));
            add(corner(-1, -1), corner(1, 1), corner(-1, 1));
        }
    return soup;
}

/// The octahedron with the vertices ±1 on the axes.
Soup octahedron()
{
    Soup soup;
    for (int d = 0; d < 3; ++d)
        for (double const x : {-1.0, 1.0}) {
            soup.vertices.push_back({0, 0, 0});
            soup.vertices.back()[d] = x;
        }
    for (int k = 0; k < 8; ++k) {
        int const i = k & 1, j = 2 + (k >> 1 & 1), l = 4 + (k >> 2);
        bool const even = (i + j + l) % 2 == 0;
        soup.triangles.push_back({i, even ? l : j, even ? j : l});
    }
    return soup;
}

/// How often a closed mesh winds around a point, by the solid angles of its triangles (A. van
/// Oosterom and J. Strackee, IEEE Trans. Biomed. Eng. 30, 125, 1983).
double winding(Soup const &soup, Vector3 const &point)
{
    double sum = 0;
    for (std::size_t k = 0; k < soup.triangles.size(); ++k) {
        Vector3 const a = soup.relative(k, 0, point), b = soup.relative(k, 1, point),
                      c = soup.relative(k, 2, point);
        double const x = std::sqrt(dot(a, a)), y = std::sqrt(dot(b, b)), z = std::sqrt(dot(c, c));
        sum += std::atan2(dot(a, pw85::cross(b, c)),
                          x * y * z + dot(a, b) * z + dot(b, c) * x + dot(c, a) * y);
    }
    return sum / (2 * std::numbers::pi);
}

Soup closed_soup(int n)
{
    Soup soup = n % 5 == 0   ? octahedron()
                : n % 3 == 0 ? cube()
                             : torus(3 + n % 11, 0.1 + 0.05 * (n % 7));
    if (n % 2 == 0)
        for (auto &t : soup.triangles) std::swap(t[0], t[1]); // inward
    return soup;
}

// Inside and outside for points anywhere, and for those with coordinates of vertices, above and
// below edges and corners.
PW85_TEST("/mesh_distance/inside")
{
    Failures failures;
    Random random(803);
    int inside = 0, points = 0;
    for (int n = 0; n < draws(400); ++n) {
        Soup soup = closed_soup(n);
        Vector3 point{random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5),
                      random.uniform(-1.5, 1.5)};
        auto const place = static_cast<std::size_t>(random.uniform(0.0, 1.0) *
                                                    static_cast<double>(soup.vertices.size()));
        if (n % 4 > 0) point[0] = soup.vertices[place][0];
        if (n % 4 > 1) point[1] = soup.vertices[place][1];
        if (n % 4 == 3) point[2] = 0.5 * soup.vertices[place][2];
        Form3 const ball{1e-4, 0, 0, 1e-4, 0, 1e-4};
        if (nearest_of_all(soup, {point, ball}).distance < 0) continue; // on the surface
        ++points;
        int const expected = std::lround(winding(soup, point)) != 0 ? 1 : 0;
        inside += expected;
        for (int const exponent : {0, 40, -40, 400, -400}) {
            Soup other = soup;
            other.scale(exponent);
            Case const c{
                pw85::detail::times_power_of_two(point, exponent),
                pw85::detail::times_power_of_two(Form3{1e-4, 0, 0, 1e-4, 0, 1e-4}, 2 * exponent)};
            auto const found = pw85::mesh_distance(other.mesh(), c.center, c.q);
            failures.check(found.inside == expected, "inside", found.inside, expected,
                           [&] { return std::to_string(n) + " 2^" + std::to_string(exponent); });
        }
    }
    g_assert_cmpint(points, >, draws(400) / 2);
    g_assert_cmpint(inside, >, points / 8);
    g_assert_cmpint(inside, <, 7 * points / 8);
}

// A mesh is not closed if a triangle is missing, doubled or turned.
PW85_TEST("/mesh_distance/closed")
{
    Soup const soup = cube();
    auto const inside_of = [](Soup const &one) {
        return pw85::mesh_distance(one.mesh(), {0.25, 0, 0}, {1, 0, 0, 1, 0, 1}).inside;
    };
    g_assert_cmpint(inside_of(soup), ==, 1);
    for (std::size_t k = 0; k < soup.triangles.size(); ++k) {
        Soup missing = soup, doubled = soup, turned = soup, degenerate = soup;
        missing.triangles.erase(missing.triangles.begin() + static_cast<std::ptrdiff_t>(k));
        doubled.triangles.push_back(doubled.triangles[k]);
        std::swap(turned.triangles[k][0], turned.triangles[k][2]);
        degenerate.triangles.push_back({soup.triangles[k][0], soup.triangles[k][0], 0});
        g_assert_cmpint(inside_of(missing), ==, -1);
        g_assert_cmpint(inside_of(doubled), ==, -1);
        g_assert_cmpint(inside_of(turned), ==, -1);
        g_assert_cmpint(inside_of(degenerate), ==, 1); // its two edges cancel each other
    }
    g_assert_cmpint(inside_of(grid(5, false)), ==, -1);
    g_assert_cmpint(inside_of(Soup{}), ==, -1);
}

// A ball of radius 1/2 in and about the cube.
PW85_TEST("/mesh_distance/by_hand")
{
    auto const mesh = cube().mesh();
    Form3 const ball{0.25, 0, 0, 0.25, 0, 0.25};
    auto const inside = pw85::mesh_distance(mesh, {0.25, 0, 0}, ball);
    g_assert_true(inside.distance == 0.25 && inside.inside == 1 && inside.normal[0] == 1);
    g_assert_true(inside.point1[0] == 0.5 && inside.point2[0] == 0.75);
    auto const outside = pw85::mesh_distance(mesh, {3, 0, 0}, ball);
    g_assert_true(outside.distance == 1.5 && outside.inside == 0 && outside.normal[0] == -1);
    auto const across = pw85::mesh_distance(mesh, {1.25, 0, 0}, ball);
    g_assert_true(across.distance == -0.25 && across.inside == 0);
}

// The bits of many are those of one, and bad rows are marked.
PW85_TEST("/mesh_distance/batch")
{
    constexpr std::size_t rows = 100, bad = 60;
    Random random(805);
    auto const mesh = torus(7, 0.3).mesh();
    std::vector<Vector3> centers, point1(rows), point2(rows), normal(rows);
    std::vector<Form3> q;
    std::vector<double> distance(rows), alone(rows);
    std::vector<std::int32_t> triangle(rows), inside(rows);
    for (std::size_t n = 0; n < rows; ++n) {
        auto const c = random_case(random, static_cast<int>(n % 3));
        centers.push_back(c.center);
        q.push_back(c.q);
    }
    q[bad][0] = -1;
    centers[bad + 1][1] = nan;
    g_assert_true(pw85::mesh_distance_batch(mesh, centers, q,
                                            {distance, point1, point2, normal, triangle, inside}) ==
                  Status::not_positive_definite);
    for (std::size_t n = 0; n < rows; ++n) {
        auto const one = pw85::mesh_distance(mesh, centers[n], q[n]);
        bool const is_bad = n == bad || n == bad + 1;
        g_assert_true((one.status != Status::success) == is_bad);
        g_assert_true(std::isnan(distance[n]) == is_bad && (inside[n] == -1) == is_bad);
        g_assert_true((triangle[n] == -1) == is_bad && triangle[n] == one.triangle);
        g_assert_true(std::memcmp(&one.distance, &distance[n], sizeof(double)) == 0);
        g_assert_true(same_bits(one.point1, point1[n]) && same_bits(one.point2, point2[n]));
        g_assert_true(same_bits(one.normal, normal[n]) && one.inside == inside[n]);
    }
    pw85::mesh_distance_batch(mesh, centers, q, {alone, {}, {}, {}, {}, {}});
    g_assert_cmpint(std::memcmp(alone.data(), distance.data(), rows * sizeof(double)), ==, 0);
    g_assert_true(pw85::mesh_distance_batch(mesh, centers, {}, {distance, {}, {}, {}, {}, {}}) ==
                  Status::invalid_argument);
    g_assert_true(pw85::mesh_distance_batch(mesh, {}, {}, {}) == Status::success);
    g_assert_true(pw85::mesh_distance_batch({}, centers, q, {}) == Status::invalid_argument);
}

// A mesh without triangles; vertices whose distance from the centre overflows.
PW85_TEST("/mesh_distance/ends_of_range")
{
    Form3 const ball{1, 0, 0, 1, 0, 1};
    auto const none = pw85::mesh_distance(Soup{}.mesh(), {0, 0, 0}, ball);
    g_assert_true(none.status == Status::success && none.distance == infinity &&
                  std::isnan(none.point1[0]) && std::isnan(none.normal[0]));
    g_assert_cmpint(none.triangle, ==, -1);
    double const large = 1.5e308;
    auto const far = Soup{{{large, 0, 0}, {1, 0, 0}}, {{0, 0, 0}, {1, 1, 1}}}.mesh();
    g_assert_true(pw85::mesh_distance(far, {-large, 0, 0}, ball).status ==
                  Status::invalid_argument);
    g_assert_cmpint(pw85::mesh_distance(far, {0, 0, 0}, ball).triangle, ==, 1);
}

} // namespace
