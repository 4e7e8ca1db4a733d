// SPDX-License-Identifier: BSD-3-Clause
// Whether a mesh is closed, and whether a point is inside of it (winding.hpp).
#include "winding.hpp"

#include <bit>

#include <pw85/algebra/doubled.hpp>

namespace pw85::detail::meshes {
namespace {

using Vector3 = Vector<double, 3>;
using Number = Doubled<double>;

/// SplitMix64 (G. L. Steele, D. Lea and C. H. Flood, OOPSLA 2014): each bit of the argument changes
/// about half of those of the result.
std::uint64_t mixed(std::uint64_t x) noexcept
{
    x += 0x9e3779b97f4a7c15;
    x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9;
    x = (x ^ x >> 27) * 0x94d049bb133111eb;
    return x ^ x >> 31;
}

std::uint64_t hash_of(Vector3 const &x, std::uint64_t seed) noexcept
{
    for (int d = 0; d < 3; ++d) seed = mixed(seed ^ std::bit_cast<std::uint64_t>(x[d] + 0.0));
    return seed;
}

/// Returns a number that is opposite for the opposite edge.
std::uint64_t hash_of_edge(std::uint64_t a, std::uint64_t b) noexcept
{
    return mixed(a + mixed(b)) - mixed(b + mixed(a));
}

/// -1, 0 or 1 as a - b.
int compare(double a, double b) noexcept { return (a > b) - (a < b); }

/// -1, 0 or 1 as a b - c d, exactly unless products underflow. Exchanging the products, or the
/// factors of one, changes no more than the sign.
int compare_products(double a, double b, double c, double d) noexcept
{
    double const first = a * b, second = c * d;
    int const sign = compare(first, second);
    return sign != 0 ? sign
                     : compare(elementary::fma(a, b, -first), elementary::fma(c, d, -second));
}

/// Returns the side of an edge, seen along z, on which the origin is. If it is on the edge, an
/// origin that is moved by an infinitesimal length along x, and by one that is infinitely smaller
/// along y. So the opposite edge has the opposite sign, and 0 stands for edges that are points
/// only.
int side_of_edge(Vector3 const &a, Vector3 const &b) noexcept
{
    int const sign = compare_products(a[0], b[1], a[1], b[0]);
    if (sign != 0) return sign;
    int const moved = compare(a[1], b[1]);
    return moved != 0 ? moved : compare(b[0], a[0]);
}

/// Returns the sign of a determinant.
int orientation(Vector3 const &a, Vector3 const &b, Vector3 const &c) noexcept
{
    auto const minor = [](double x, double y, double z, double w) {
        return Number(x) * Number(w) - Number(y) * Number(z);
    };
    Number const sum = Number(c[0]) * minor(a[1], a[2], b[1], b[2]) -
                       Number(c[1]) * minor(a[0], a[2], b[0], b[2]) +
                       Number(c[2]) * minor(a[0], a[1], b[0], b[1]);
    return compare(sum.high, 0.0);
}

/// Returns the orientation of a triangle if the half-line from the origin along z crosses it, or 0.
int crossing(Vector3 const (&x)[3]) noexcept
{
    int const side = side_of_edge(x[0], x[1]);
    if (side == 0 || side_of_edge(x[1], x[2]) != side || side_of_edge(x[2], x[0]) != side) return 0;
    return orientation(x[0], x[1], x[2]) == side ? side : 0;
}

/// Sums the crossings of the half-line from a point along z.
class Ray {
  public:
    Ray(pw85_mesh const &mesh, Vector3 const &point) noexcept : mesh_(mesh), point_(point)
    {
        auto const root = mesh.tree.root();
        double largest = 0.0;
        for (int d = 0; d < 3; ++d)
            largest = maximum(largest, maximum(elementary::abs(root.lower[d] - point[d]),
                                               elementary::abs(root.upper[d] - point[d])));
        exponent_ = largest > 0.0 ? -elementary::ilogb(largest) : 0;
    }

    int crossings(int level, std::size_t block) const noexcept
    {
        using neighbors::width;
        int sum = 0;
        for (std::size_t k = block * width; k < (block + 1) * width; ++k) {
            if (!meets(mesh_.tree.box(level, k))) continue;
            sum += level == 0 ? crossing_of(mesh_.triangles[k]) : crossings(level - 1, k);
        }
        return sum;
    }

  private:
    /// Tests whether the half-line may meet a box. Empty boxes are NaN.
    bool meets(neighbors::Box const &box) const noexcept
    {
        return box.lower[0] <= point_[0] && point_[0] <= box.upper[0] &&
               box.lower[1] <= point_[1] && point_[1] <= box.upper[1] && point_[2] <= box.upper[2];
    }

    /// In the unit in which the farthest vertex has a coordinate near 1.
    int crossing_of(Triangle const &triangle) const noexcept
    {
        Vector3 relative[3];
        for (int i = 0; i < 3; ++i)
            for (int d = 0; d < 3; ++d)
                relative[i][d] = elementary::ldexp(triangle.vertices[i][d] - point_[d], exponent_);
        return crossing(relative);
    }

    pw85_mesh const &mesh_;
    Vector3 point_;
    int exponent_;
};

} // namespace

// The sums of two hashes of all edges are 0 if the mesh is closed, and with the probability 2⁻¹²⁸
// otherwise.
bool is_closed(Array<Triangle> const &triangles) noexcept
{
    std::uint64_t sums[2] = {0, 0};
    for (std::size_t k = 0; k < triangles.size(); ++k)
        for (std::uint64_t const seed : {0U, 1U}) {
            std::uint64_t hashes[3];
            for (int i = 0; i < 3; ++i) hashes[i] = hash_of(triangles[k].vertices[i], seed);
            for (int i = 0; i < 3; ++i) sums[seed] += hash_of_edge(hashes[i], hashes[(i + 1) % 3]);
        }
    return triangles.size() > 0 && sums[0] == 0 && sums[1] == 0;
}

int is_inside(pw85_mesh const &mesh, Vector<double, 3> const &point) noexcept
{
    if (!mesh.is_closed) return -1;
    return Ray(mesh, point).crossings(mesh.tree.top_level(), 0) != 0 ? 1 : 0;
}

} // namespace pw85::detail::meshes
