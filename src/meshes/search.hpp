// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Finds the triangles of a mesh that may be nearest to an ellipsoid, or may overlap it. mesh.cpp
/// and mesh_distance.cpp call search().
///
/// The search goes down the tree. It visits near boxes first, and skips a box if every triangle in
/// it is proved to be too far away. What far means, and how it is proved, is said by a class of
/// bounds: ContactBounds (contact_bounds.hpp) or DistanceBounds (distance_bounds.hpp). Each proof
/// is a vector. That of a box is tried for its children first, because it costs little.
///
/// Bounds are below computed numbers, too. So a box is skipped only if the computed number of each
/// of its triangles is above the limit, and the answer is that of a search of all triangles, bit by
/// bit.
#ifndef PW85_MESHES_SEARCH_HPP_INCLUDED
#define PW85_MESHES_SEARCH_HPP_INCLUDED

#include <pw85/shapes/overlap_shapes.hpp>

#include "mesh.hpp"

namespace pw85::detail::meshes {
namespace {

using Vector3 = Vector<double, 3>;
using Form3 = SymmetricMatrix<double, 3>;

/// Bounds are computed if coordinates are below this limit and above its inverse. Forms are in the
/// range 10^±76; no square overflows.
constexpr double range = 0x1p100;

/// An ellipsoid, and its form in the unit of length in which the largest diagonal entry is in [1,
/// 4).
class Ellipsoid {
  public:
    Ellipsoid(Vector3 const &center, Form3 const &q) noexcept : center_(center), q_(q)
    {
        Unit const unit = unit_of(q);
        form_ = unit.to_local(q);
        per_unit_ = unit.to_local(1.0);
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

    double in_unit(double length) const noexcept { return per_unit_ * length; }

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

/// Returns the largest magnitudes of the coordinates of a box.
inline Vector3 largest_magnitudes(SolidBox<double> const &box) noexcept
{
    Vector3 sizes;
    for (int d = 0; d < 3; ++d) sizes[d] = maximum(absolute(box.lower[d]), absolute(box.upper[d]));
    return sizes;
}

inline Vector3 largest_magnitudes(Hull<double, 3> const &triangle) noexcept
{
    Vector3 sizes{0.0, 0.0, 0.0};
    for (auto const &x : triangle.points)
        for (int d = 0; d < 3; ++d) sizes[d] = maximum(sizes[d], absolute(x[d]));
    return sizes;
}

/// A box or a triangle that the search has not skipped yet.
struct Candidate {
    double bound; ///< no computed number is smaller
    std::size_t number;
    Vector3 normal; ///< the vector that proves the bound; zero if there is none
};

/// Calls visit(triangle) for all triangles whose computed number may be at most a limit. visit()
/// returns the new limit; one below all bounds ends the search. Bounds has three functions:
/// of_triangle(triangle, vector) and of_box(box, vector) are what a vector proves, and
/// improved(box, candidate) looks for a better vector.
template <class Bounds, class Visit> class Search {
  public:
    Search(pw85_mesh const &mesh, Bounds const &bounds, double limit, Visit const &visit) noexcept
        : mesh_(mesh), bounds_(bounds), limit_(limit), visit_(visit)
    {
    }

    void run() noexcept
    {
        if (mesh_.triangles.size() > 0) descend(mesh_.tree.top_level(), {0.0, 0, {0.0, 0.0, 0.0}});
    }

  private:
    bool skips(double bound) const noexcept { return bound > limit_; }

    // child() and visit() are functions of their own: their numbers are not on the stack once for
    // each level.

    [[gnu::noinline]] void visit(Triangle const &triangle) noexcept { limit_ = visit_(triangle); }

    [[gnu::noinline]] Candidate child(int level, std::size_t number,
                                      Vector3 const &normal) const noexcept
    {
        if (level == 0)
            return {bounds_.of_triangle(mesh_.triangles[number], normal), number, normal};
        neighbors::Box const box = mesh_.tree.box(level, number);
        Candidate const first{bounds_.of_box(box, normal), number, normal};
        return skips(first.bound) ? first : bounds_.improved(box, first);
    }

    std::size_t count(int level, std::size_t block) const noexcept
    {
        std::size_t const below = std::size_t{1} << 3 * level; // triangles in a box of this level
        std::size_t const boxes = (mesh_.triangles.size() + below - 1) / below;
        return minimum<std::size_t>(neighbors::width, boxes - block * neighbors::width);
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
    Bounds const &bounds_;
    double limit_;
    Visit const &visit_;
};

template <class Bounds, class Visit>
void search(pw85_mesh const &mesh, Bounds const &bounds, double limit, Visit const &visit) noexcept
{
    Search<Bounds, Visit>(mesh, bounds, limit, visit).run();
}

} // namespace
} // namespace pw85::detail::meshes

#endif
