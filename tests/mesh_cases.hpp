// SPDX-License-Identifier: BSD-3-Clause
// Meshes and ellipsoids for tests of meshes. The files test_mesh*.cpp include this file.
#ifndef PW85_TESTS_MESH_CASES_HPP_INCLUDED
#define PW85_TESTS_MESH_CASES_HPP_INCLUDED

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <glib.h>

#include <pw85/systems.hpp>

#include "failures.hpp"
#include "random_pairs.hpp"

namespace pw85_tests {
namespace {

using Indices = std::array<std::int32_t, 3>;

constexpr double infinity = std::numeric_limits<double>::infinity(),
                 nan = std::numeric_limits<double>::quiet_NaN();

/// The arrays of a mesh.
struct Soup {
    std::vector<Vector3> vertices;
    std::vector<Indices> triangles;

    pw85::Mesh mesh() const
    {
        pw85::Mesh made;
        g_assert_true(pw85::mesh_create(vertices, triangles, made) == pw85::Status::success);
        return made;
    }
    Vector3 relative(std::size_t triangle, std::size_t corner, Vector3 const &center) const
    {
        return vertices[static_cast<std::size_t>(triangles[triangle][corner])] - center;
    }
    void scale(int exponent)
    {
        for (auto &x : vertices) x = pw85::detail::times_power_of_two(x, exponent);
    }
};

/// A sphere of radius 1 or a plane, as a grid of n by n squares; in the plane many triangles are
/// equally near.
inline Soup grid(int n, bool sphere)
{
    Soup soup;
    auto const index = [n](int i, int j) { return i * (n + 1) + j; };
    for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= n; ++j) {
            double const theta = std::numbers::pi * i / n, phi = 2 * std::numbers::pi * j / n;
            Vector3 const on_sphere{std::sin(theta) * std::cos(phi),
                                    std::sin(theta) * std::sin(phi), std::cos(theta)};
            Vector3 const on_plane{double(i) - n / 2, double(j) - n / 2, 0.0};
            soup.vertices.push_back(sphere ? on_sphere : on_plane);
        }
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            soup.triangles.push_back({index(i, j), index(i + 1, j), index(i, j + 1)});
            soup.triangles.push_back({index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)});
        }
    return soup;
}

/// Triangles of all sizes anywhere, slivers, segments and points among them.
inline Soup random_soup(Random &random, int n)
{
    Soup soup;
    for (int k = 0; k < n; ++k) {
        Vector3 const place = random.uniform(0.0, 2.0) * random.direction<3>();
        double const size = random.log_uniform(1e-6, 1.0);
        auto const first = static_cast<std::int32_t>(soup.vertices.size());
        for (int corner = 0; corner < 3; ++corner)
            soup.vertices.push_back(pw85::detail::add_scaled(place, size, random.direction<3>()));
        soup.triangles.push_back(
            {first, k % 7 == 1 ? first : first + 1, k % 5 == 1 ? first : first + 2});
    }
    return soup;
}

struct Case {
    Vector3 center;
    Form3 q;
};

/// Balls, needles and discs to aspect ratio 1e6, of any size.
inline Case random_case(Random &random, int n)
{
    double const aspects[] = {1.0, 10.0, 1e3, 1e6};
    double const size = n % 3 == 0 ? 0.1 : random.log_uniform(1e-4, 10.0);
    return {random.uniform(0.0, 3.0) * random.direction<3>(),
            random.form(size, random.log_uniform(1.0, aspects[n % 4]))};
}

inline std::string text(Case const &c)
{
    return "center = " + hex_text(c.center.coordinates, 3) + ", q = " + hex_text(c.q.entries, 6);
}

/// A soup and the same in other units.
inline Soup soup_of(Random &random, int n, int exponent)
{
    Soup soup = n % 3 == 0   ? grid(8, true)
                : n % 3 == 1 ? grid(9, false)
                             : random_soup(random, 1 + 7 * n % 600);
    soup.scale(exponent);
    return soup;
}

/// Visits soups and their meshes with ellipsoids, in five units; every fourth ellipsoid has its
/// centre in the plane of a grid.
template <class Visit>
void for_each_case(Random &random, int soups, int ellipsoids, Visit const &visit)
{
    for (int n = 0; n < soups; ++n) {
        constexpr int exponents[] = {0, -40, 40, -300, 300};
        int const exponent = exponents[n % 5];
        Soup const soup = soup_of(random, n, exponent);
        auto const mesh = soup.mesh();
        for (int k = 0; k < ellipsoids; ++k) {
            Case c = random_case(random, k);
            c.center = pw85::detail::times_power_of_two(c.center, exponent);
            c.q = pw85::detail::times_power_of_two(c.q, 2 * exponent);
            if (k % 4 == 3) c.center[2] = 0.0;
            visit(soup, mesh, c, k);
        }
    }
}

} // namespace
} // namespace pw85_tests

#endif
