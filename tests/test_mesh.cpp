// SPDX-License-Identifier: BSD-3-Clause
// Tests of ellipsoids and triangle meshes against all triangles, one by one.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include <glib.h>

#include <pw85/systems.hpp>

#include "cases.hpp"
#include "draws.hpp"
#include "failures.hpp"
#include "mesh_cases.hpp"
#include "shapes_truth.hpp"

using namespace pw85_tests;

namespace {

using pw85::Status;
using pw85_tests::convert;
using pw85_tests::nan; // not the function of <cmath>
constexpr Form3 unit_sphere{1, 0, 0, 1, 0, 1};

/// The least μ² of all triangles, one by one.
pw85::MeshContact nearest_of_all(Soup const &soup, Case const &c)
{
    pw85::MeshContact best{infinity, {nan, nan, nan}, -1, Status::success};
    for (std::size_t k = 0; k < soup.triangles.size(); ++k) {
        Vector3 const a = soup.relative(k, 0, c.center), b = soup.relative(k, 1, c.center),
                      d = soup.relative(k, 2, c.center);
        double mu2 = 0;
        Vector3 point{};
        int const status = pw85_contact_triangle(a.coordinates, b.coordinates, d.coordinates,
                                                 c.q.entries, &mu2, point.coordinates);
        g_assert_cmpint(status, ==, PW85_SUCCESS);
        if (mu2 < best.mu2) best = {mu2, point, static_cast<std::int32_t>(k), Status::success};
    }
    return best;
}

/// Whether any triangle overlaps, in integers.
bool overlaps_any(Soup const &soup, Case const &c)
{
    for (std::size_t k = 0; k < soup.triangles.size(); ++k) {
        Vector3 const points[3] = {soup.relative(k, 0, c.center), soup.relative(k, 1, c.center),
                                   soup.relative(k, 2, c.center)};
        if (pw85::detail::overlaps_exactly(points, c.q)) return true;
    }
    return false;
}

void expect_nearest(Soup const &soup, pw85::Mesh const &mesh, Case const &c, Failures &failures)
{
    auto const found = pw85::mesh_contact(mesh, c.center, c.q), expected = nearest_of_all(soup, c);
    auto const describe = [&] {
        return std::to_string(soup.triangles.size()) + " triangles, " + text(c);
    };
    failures.check(found.status == Status::success, "status", static_cast<double>(found.status), 0,
                   describe);
    failures.check(found.triangle == expected.triangle, "triangle", found.triangle,
                   expected.triangle, describe);
    failures.check(found.mu2 == expected.mu2, "mu2", found.mu2, expected.mu2, describe);
    for (int i = 0; i < 3; ++i)
        failures.check(found.point[i] == expected.point[i], "point", found.point[i],
                       expected.point[i], describe);
}

void expect_overlap(pw85::Mesh const &mesh, Case const &c, bool expected, Failures &failures)
{
    auto const found = pw85::mesh_overlap(mesh, c.center, c.q);
    failures.check(found.status == Status::success && found.overlap == expected, "overlap",
                   found.overlap, expected, [&] { return text(c); });
}

// The bits of the least of all triangles.
PW85_TEST("/mesh/nearest")
{
    Failures failures;
    Random random(700);
    for_each_case(random, draws(240), 12,
                  [&](Soup const &soup, pw85::Mesh const &mesh, Case const &c, int) {
                      expect_nearest(soup, mesh, c, failures);
                  });
}

// The same where the ellipsoid touches many triangles at equal distances up to rounding errors: an
// ellipsoid that an integer map makes of a ball above a grid, and centres on the axis of a sphere
// of triangles.
PW85_TEST("/mesh/equally_near")
{
    Failures failures;
    Random random(701);
    for (int n = 0; n < draws(200); ++n) {
        bool const sphere = n % 2 == 0;
        Soup const soup = grid(10 + n % 7, sphere);
        double const height = random.log_uniform(1e-8, 1e8);
        Case c{{0, 0, height},
               random.form(sphere ? 1.0 : height, random.log_uniform(1.0, n % 4 < 2 ? 10.0 : 1e4))};
        if (sphere) c = {{0, 0, 0}, Form3{height, 0, 0, height, 0, height}};
        expect_nearest(soup, soup.mesh(), c, failures);
    }
}

// Ellipsoids of which the box that is in the way can only be skipped if no margin is kept: sizes
// that differ much.
PW85_TEST("/mesh/far_and_small")
{
    Failures failures;
    Random random(702);
    for (int n = 0; n < draws(200); ++n) {
        Soup const soup = grid(12, true);
        double const size = std::pow(10.0, -(n % 120));
        Case c = random_case(random, n);
        c.q = size * size * c.q;
        if (n % 2 == 0)
            c.center = soup.vertices[static_cast<std::size_t>(n) % soup.vertices.size()];
        for (int i = 0; n % 4 == 0 && i < 3; ++i) c.center[i] += random.normal() * size;
        expect_nearest(soup, soup.mesh(), c, failures);
    }
}

// Against integers, and against 50 digits where these can tell.
PW85_TEST("/mesh/overlap")
{
    Failures failures;
    Random random(703);
    int overlapping = 0, checked = 0;
    auto const check = [&](Soup const &soup, pw85::Mesh const &mesh, Case c, int k) {
        auto const near = nearest_of_all(soup, c);
        // The ellipsoid that touches, up to rounding errors.
        if (k % 2 == 0 && near.mu2 > 1e-12 && near.mu2 < 1e12) c.q = near.mu2 * c.q;
        bool const expected = overlaps_any(soup, c);
        expect_overlap(mesh, c, expected, failures);
        overlapping += expected;
        ++checked;
    };
    for_each_case(random, draws(160), 8, check);
    g_test_message("%d of %d overlap", overlapping, checked);
    g_assert_cmpint(overlapping, >, checked / 8);
    g_assert_cmpint(overlapping, <, 7 * checked / 8);
}

// A sphere that touches the plane of a grid exactly, and its neighbours by one unit in the last
// place.
PW85_TEST("/mesh/touching")
{
    Failures failures;
    Soup const soup = grid(20, false);
    auto const mesh = soup.mesh();
    for (double const place : {0.0, 0.25, 0.5, 3.0, 7.75})
        for (int exponent = -20; exponent < 5; ++exponent) {
            double const height = std::ldexp(1.0, exponent), square = height * height;
            Case c{{place, place / 2, height}, Form3{square, 0, 0, square, 0, square}};
            expect_overlap(mesh, c, false, failures);
            c.q[5] = std::nextafter(square, infinity);
            expect_overlap(mesh, c, true, failures);
            c.q[5] = std::nextafter(square, 0.0);
            expect_overlap(mesh, c, false, failures);
        }
}

// Against 50 digits: the distance of a ball from the corner, edges and faces of a cube.
PW85_TEST("/mesh/wide")
{
    Failures failures;
    Random random(704);
    Soup const soup = random_soup(random, 200);
    auto const mesh = soup.mesh();
    for (int n = 0; n < draws(64); ++n) {
        Case const c = random_case(random, n % 3);
        NearestTruth best;
        for (std::size_t k = 0; k < soup.triangles.size(); ++k) {
            WideVector const points[3] = {convert<Wide>(soup.relative(k, 0, c.center)),
                                          convert<Wide>(soup.relative(k, 1, c.center)),
                                          convert<Wide>(soup.relative(k, 2, c.center))};
            auto const one = nearest_in_hull(points, convert<Wide>(c.q));
            if (best.mu2 < 0 || one.mu2 < best.mu2) best = one;
        }
        auto const found = pw85::mesh_contact(mesh, c.center, c.q);
        Wide const bound = 80 * Wide(0x1p-53) * best.sensitivity,
                   error = abs(Wide(found.mu2) - best.mu2);
        failures.check(error <= bound, "mu2", double(error), double(bound),
                       [&] { return text(c); });
    }
}

// The bits of many are those of one, and bad rows are marked.
PW85_TEST("/mesh/batch")
{
    constexpr std::size_t rows = 1000, bad = 600;
    Random random(705);
    Soup const soup = random_soup(random, 300);
    auto const mesh = soup.mesh();
    std::vector<Vector3> centers, point(rows);
    std::vector<Form3> q;
    std::vector<double> mu2(rows);
    std::vector<std::int32_t> triangle(rows);
    std::vector<unsigned char> overlap(rows);
    for (std::size_t n = 0; n < rows; ++n) {
        auto const c = random_case(random, static_cast<int>(n));
        centers.push_back(c.center);
        q.push_back(c.q);
    }
    q[bad][0] = -1;
    centers[bad + 1][1] = nan;
    g_assert_true(pw85::mesh_contact_batch(mesh, centers, q, {mu2, point, triangle}) ==
                  Status::not_positive_definite);
    g_assert_true(pw85::mesh_overlap_batch(mesh, centers, q, overlap) ==
                  Status::not_positive_definite);
    for (std::size_t n = 0; n < rows; ++n) {
        auto const one = pw85::mesh_contact(mesh, centers[n], q[n]);
        bool const is_bad = n == bad || n == bad + 1;
        g_assert_true((one.status != Status::success) == is_bad && std::isnan(mu2[n]) == is_bad);
        g_assert_cmpint(std::memcmp(&one.mu2, &mu2[n], sizeof one.mu2), ==, 0);
        g_assert_cmpint(std::memcmp(&one.point, &point[n], sizeof one.point), ==, 0);
        g_assert_cmpint(one.triangle, ==, triangle[n]);
        g_assert_cmpint(overlap[n], ==,
                        is_bad ? 255 : pw85::mesh_overlap(mesh, centers[n], q[n]).overlap);
    }
    std::vector<double> alone(rows);
    pw85::mesh_contact_batch(mesh, centers, q, {alone, {}, {}});
    g_assert_cmpint(std::memcmp(alone.data(), mu2.data(), rows * sizeof(double)), ==, 0);
    g_assert_true(pw85::mesh_contact_batch(mesh, centers, {}, {mu2, {}, {}}) ==
                  Status::invalid_argument);
    g_assert_true(pw85::mesh_overlap_batch(mesh, centers, q, {}) == Status::invalid_argument);
    g_assert_true(pw85::mesh_contact_batch(mesh, {}, {}, {}) == Status::success);
    g_assert_true(pw85::mesh_contact_batch({}, centers, q, {mu2, {}, {}}) ==
                  Status::invalid_argument);
}

Status create(std::vector<Vector3> const &vertices, std::vector<Indices> const &triangles)
{
    pw85::Mesh mesh;
    auto const status = pw85::mesh_create(vertices, triangles, mesh);
    g_assert_true((mesh.get() != nullptr) == (status == Status::success));
    return status;
}

PW85_TEST("/mesh/bad_input")
{
    std::vector<Vector3> const vertices{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
    g_assert_true(create(vertices, {{0, 1, 2}}) == Status::success);
    g_assert_true(create(vertices, {{0, 1, 3}}) == Status::invalid_argument);
    g_assert_true(create(vertices, {{0, 1, 2}, {-1, 1, 2}}) == Status::invalid_argument);
    g_assert_true(create({}, {{0, 0, 0}}) == Status::invalid_argument);
    for (double const x : {nan, infinity, -infinity})
        // not used, but bad
        g_assert_true(create({{0, 0, 1}, {0, x, 0}}, {{0, 0, 0}}) == Status::invalid_argument);
    pw85_mesh *mesh = nullptr;
    g_assert_cmpint(pw85_mesh_create(std::size_t{1} << 31, &vertices[0][0], 0, nullptr, &mesh), ==,
                    PW85_EINVAL);
    g_assert_cmpint(pw85_mesh_create(1, nullptr, 0, nullptr, &mesh), ==, PW85_EINVAL);
    g_assert_cmpint(pw85_mesh_create(0, nullptr, 0, nullptr, nullptr), ==, PW85_EINVAL);
    pw85_mesh_destroy(nullptr);
}

// A mesh without triangles; vertices whose distance from the centre overflows; a μ² that overflows.
PW85_TEST("/mesh/ends_of_range")
{
    pw85::Mesh const empty = Soup{}.mesh();
    auto const none = pw85::mesh_contact(empty, {0, 0, 0}, unit_sphere);
    g_assert_true(none.status == Status::success && none.mu2 == infinity &&
                  std::isnan(none.point[0]));
    g_assert_cmpint(none.triangle, ==, -1);
    g_assert_false(pw85::mesh_overlap(empty, {0, 0, 0}, unit_sphere).overlap);
    double const large = 1.5e308;
    auto const far = Soup{{{large, 0, 0}, {1, 0, 0}}, {{0, 0, 0}, {1, 1, 1}}}.mesh();
    g_assert_true(pw85::mesh_contact(far, {-large, 0, 0}, unit_sphere).status ==
                  Status::invalid_argument);
    g_assert_true(pw85::mesh_overlap(far, {-large, 0, 0}, unit_sphere).status ==
                  Status::invalid_argument);
    g_assert_cmpint(pw85::mesh_contact(far, {0, 0, 0}, unit_sphere).triangle, ==, 1);
    auto const farthest = Soup{{{large, 0, 0}}, {{0, 0, 0}, {0, 0, 0}}}.mesh();
    auto const found = pw85::mesh_contact(farthest, {0, 0, 0}, unit_sphere);
    g_assert_true(found.mu2 == infinity && found.triangle == 0 && found.point[0] == large);
}

// One far vertex makes a sliver, of which the nearest point is inside. The other triangle is
// farther away.
PW85_TEST("/mesh/far_vertex")
{
    Soup const soup{{{799999995, -599999992, -900000007},
                     {-1, 2, 9},
                     {-9, 9, 0},
                     {0, 0, -3},
                     {1, 0, -3},
                     {0, 1, -3}},
                    {{3, 4, 5}, {0, 1, 2}}};
    auto const mesh = soup.mesh();
    double const expected = 1.7121111309598007;
    for (Vector3 const &center : {Vector3{0, 0, 0}, Vector3{0x1p-30, 0, 0}}) {
        auto const found = pw85::mesh_contact(mesh, center, unit_sphere);
        g_assert_cmpint(found.triangle, ==, 1);
        g_assert_cmpfloat(std::abs(found.mu2 - expected), <, 1e-8);
        g_assert_false(pw85::mesh_overlap(mesh, center, unit_sphere).overlap);
    }
    auto const larger = pw85::mesh_contact(mesh, {0, 0, 0}, {4, 0, 0, 4, 0, 4});
    g_assert_cmpfloat(larger.mu2, <, 1);
    g_assert_true(pw85::mesh_overlap(mesh, {0, 0, 0}, {4, 0, 0, 4, 0, 4}).overlap);
}

} // namespace
