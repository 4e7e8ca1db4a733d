// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Finds the triangles of a mesh that may be nearest to an ellipsoid, or may overlap it. mesh.cpp
/// calls search().
///
/// The search goes down the tree. It visits near boxes first, and skips a box if every triangle in
/// it is proved to be too far away. The proof is a vector s: the least xᵀQ⁻¹x in the box is at
/// least (s·y)²/(sᵀQs), where y is the point of the box with the least s·y (Separation in
/// overlap_shapes.hpp). The bound is sharp if s is the normal at the nearest point of the box. The
/// normal of a box is tried for its children first, because it costs little.
///
/// The computed μ² of a triangle may be less than the exact one, by 80 u S (pw85.h). A Margin is
/// twice that. So a box is skipped only if the computed μ² of each of its triangles is above the
/// limit, and the answer is that of a search of all triangles, bit by bit. By Cauchy's inequality
/// |s_i| <= μ √(Q⁻¹)_ii. So the first part of S is at most (Σ|s_i| √Q_ii)² <= 3 μ² Σ Q_ii (Q⁻¹)_ii,
/// and the second part is at most 2 μ Σ V_i √(Q⁻¹)_ii if no coordinate i in the box is larger than
/// V_i.
#ifndef PW85_MESHES_SEARCH_HPP_INCLUDED
#define PW85_MESHES_SEARCH_HPP_INCLUDED

#include <algorithm>

#include <pw85/shapes/overlap_shapes.hpp>

#include "mesh.hpp"

namespace pw85::detail::meshes {
namespace {

using Vector3 = Vector<double, 3>;
using Form3 = SymmetricMatrix<double, 3>;

/// Bounds are computed if coordinates are below this limit and above its inverse. Forms are in the
/// range 10^±76, so that no square overflows.
constexpr double range = 0x1p100;

/// Margin by which a computed μ² may be smaller than μ².
struct Margin {
    double factor;   ///< of μ²
    Vector3 weights; ///< of μ times the largest coordinates

    double reduced(double mu2, Vector3 const &sizes) const noexcept
    {
        return std::max(0.0, mu2 - factor * mu2 - elementary::sqrt(mu2) * dot(weights, sizes));
    }
};

/// The margin of contact_triangle(). If the form is not clearly definite, contact_triangle() uses
/// numbers of more digits, and rounds the result. Rounding errors of adj(Q)_ii and det Q are at
/// most a half of these numbers if the form is clearly definite (definite.hpp), so that the
/// quotient is at least a quarter of the exact one.
inline Margin margin_of_contact(Form3 const &q) noexcept
{
    constexpr double u = unit_roundoff<double>(), error = 2 * 80 * u;
    if (!is_clearly_definite(q)) return {16.0 * u, {0.0, 0.0, 0.0}};
    auto const adj = adjugate(q);
    double const reciprocal = 4.0 / determinant(q, adj);
    Margin margin{0.0, {}};
    for (int i = 0; i < 3; ++i) {
        double const inverse = adj(i, i) * reciprocal;
        margin.factor += error * 3.0 * q(i, i) * inverse;
        margin.weights[i] = error * 2.0 * elementary::sqrt(inverse);
    }
    return margin;
}

/// An ellipsoid, and its form in the unit of length in which the largest diagonal entry is in [1,
/// 4).
class Ellipsoid {
  public:
    Ellipsoid(Vector3 const &center, Form3 const &q) noexcept : center_(center), q_(q)
    {
        int const exponent = half_exponent(largest_diagonal(q));
        form_ = times_power_of_two(q, -2 * exponent);
        per_unit_ = times_power_of_two(1.0, -exponent);
    }

    Form3 const &q() const noexcept { return q_; }
    Form3 const &form() const noexcept { return form_; }

    /// Relative to the centre, in the given unit of length.
    Hull<double, 3> relative(Triangle const &triangle) const noexcept
    {
        auto const &[a, b, c] = triangle.vertices;
        return {{a - center_, b - center_, c - center_}};
    }

    /// Returns the box relative to the centre, in the unit of the form. Rounding keeps the order of
    /// numbers: the box has all of its triangles here, too.
    SolidBox<double> relative(neighbors::Box const &box) const noexcept
    {
        SolidBox<double> relative{};
        for (int d = 0; d < 3; ++d) {
            relative.lower[d] = (box.lower[d] - center_[d]) * per_unit_;
            relative.upper[d] = (box.upper[d] - center_[d]) * per_unit_;
        }
        return relative;
    }

    Hull<double, 3> in_unit(Hull<double, 3> triangle) const noexcept
    {
        for (auto &x : triangle.points) x = per_unit_ * x;
        return triangle;
    }

  private:
    Vector3 center_;
    Form3 q_, form_;
    double per_unit_;
};

/// A box or a triangle that the search has not skipped yet.
struct Candidate {
    double bound; ///< no computed μ² is smaller
    std::size_t number;
    Vector3 normal; ///< the vector that proves the bound; zero if there is none
};

/// Calls visit(triangle) for all triangles whose computed μ² may be at most a limit. visit()
/// returns the new limit; less than 0 ends the search.
template <class Visit> class Search {
  public:
    Search(pw85_mesh const &mesh, Ellipsoid const &ellipsoid, Margin const &margin, double limit,
           Visit const &visit) noexcept
        : mesh_(mesh), ellipsoid_(ellipsoid), margin_(margin), limit_(limit), visit_(visit)
    {
    }

    void run() noexcept
    {
        if (mesh_.triangles.size() > 0) descend(mesh_.tree.top_level(), {0.0, 0, {0.0, 0.0, 0.0}});
    }

  private:
    bool skips(double bound) const noexcept { return bound > limit_; }

    /// Returns the lower bound of μ² that a vector proves for a box or a triangle whose largest
    /// coordinates are `sizes`, or 0.
    template <class Shape>
    double bound(Shape const &shape, Vector3 const &sizes, Vector3 const &s) const noexcept
    {
        auto const [least, form] = separation(shape, ellipsoid_.form(), s);
        if (!(least > 0.0 && form > 0.0 && sum_of(sizes) < range)) return 0.0;
        constexpr double rounding = 1.0 - 16.0 * unit_roundoff<double>();
        return margin_.reduced(rounding * (least * least / form), sizes);
    }

    Candidate candidate(neighbors::Box const &box, std::size_t number,
                        Vector3 const &normal) const noexcept
    {
        auto const relative = ellipsoid_.relative(box);
        Vector3 sizes;
        for (int d = 0; d < 3; ++d)
            sizes[d] = std::max(absolute(relative.lower[d]), absolute(relative.upper[d]));
        Candidate const first{bound(relative, sizes, normal), number, normal};
        double const nearest = largest_coordinate(nearest_corner(relative.lower, relative.upper));
        if (skips(first.bound) || !(nearest * range > 1.0 && sum_of(sizes) < range)) return first;
        auto const s = relative.template nearest<true, true>(ellipsoid_.form()).normal.direction;
        return {bound(relative, sizes, s), number, s};
    }

    Candidate candidate(Triangle const &triangle, std::size_t number,
                        Vector3 const &normal) const noexcept
    {
        auto const hull = ellipsoid_.in_unit(ellipsoid_.relative(triangle));
        return {bound(hull, hull.magnitudes(normal), normal), number, normal};
    }

    // child() and visit() are functions of their own, so that their numbers do not lie on the stack
    // once for each level.

    [[gnu::noinline]] void visit(Triangle const &triangle) noexcept { limit_ = visit_(triangle); }

    [[gnu::noinline]] Candidate child(int level, std::size_t number,
                                      Vector3 const &normal) const noexcept
    {
        if (level == 0) return candidate(mesh_.triangles[number], number, normal);
        return candidate(mesh_.tree.box(level, number), number, normal);
    }

    std::size_t count(int level, std::size_t block) const noexcept
    {
        std::size_t const below = std::size_t{1} << 3 * level; // triangles in a box of this level
        std::size_t const boxes = (mesh_.triangles.size() + below - 1) / below;
        return std::min<std::size_t>(neighbors::width, boxes - block * neighbors::width);
    }

    /// Inserts a candidate into a sorted array.
    static void insert(Candidate const &one, Candidate *sorted, std::size_t &size) noexcept
    {
        std::size_t place = size++;
        for (; place > 0 && sorted[place - 1].bound > one.bound; --place)
            sorted[place] = sorted[place - 1];
        sorted[place] = one;
    }

    [[gnu::noinline]] void descend(int level, Candidate const &parent) noexcept
    {
        Candidate children[neighbors::width];
        std::size_t size = 0;
        for (std::size_t k = 0; k < count(level, parent.number); ++k) {
            Candidate const one = child(level, parent.number * neighbors::width + k, parent.normal);
            if (!skips(one.bound)) insert(one, children, size);
        }
        for (std::size_t k = 0; k < size && !skips(children[k].bound); ++k) {
            if (level == 0)
                visit(mesh_.triangles[children[k].number]);
            else
                descend(level - 1, children[k]);
        }
    }

    pw85_mesh const &mesh_;
    Ellipsoid const &ellipsoid_;
    Margin margin_;
    double limit_;
    Visit const &visit_;
};

} // namespace
} // namespace pw85::detail::meshes

#endif
