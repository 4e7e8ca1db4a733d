// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Bounds of the signed distances of an ellipsoid and the triangles of a mesh, for search.hpp.
/// mesh_distance.cpp includes this file.
///
/// The proof of a bound is a unit vector n: the signed distance of the ellipsoid and any set in a
/// box is at least the least n·y of the box minus the half-width α = √(nᵀQn) of the ellipsoid
/// (solids.hpp). Two vectors are tried for a box. One is normal to the scaled ellipsoid that
/// touches the box, which is sharp for a box that is near. The other one is along the nearest point
/// of the box from the centre, which is sharp for a box that is far.
///
/// The computed distance of a triangle may be less than the exact one, by 16 u Σ (pw85_shapes.h).
/// With the largest eigenvalue Λ and the least one λ of Q, Σ is at most R + 3 Λ/(2√λ) for the
/// distance R of the farthest corner of the box, because Σ|n_i Q_ij n_j| is at most (Σ|n_i| √Q_ii)²
/// and so at most 3 Λ, and α >= √λ. The margin is four times that: the computed least n·y - α of a
/// unit vector errs by less than 12 u Σ, and one whose length errs by 4 u adds 4 u (R + α).
#ifndef PW85_MESHES_DISTANCE_BOUNDS_HPP_INCLUDED
#define PW85_MESHES_DISTANCE_BOUNDS_HPP_INCLUDED

#include "search.hpp"

namespace pw85::detail::meshes {
namespace {

class DistanceBounds {
  public:
    explicit DistanceBounds(Ellipsoid const &ellipsoid) noexcept
        : ellipsoid_(ellipsoid), largest_ratio_(largest_ratio(ellipsoid.form()))
    {
    }

    double of_triangle(Triangle const &triangle, Vector3 const &n) const noexcept
    {
        auto const hull = ellipsoid_.in_unit(ellipsoid_.relative(triangle));
        return bound(hull, largest_magnitudes(hull), n);
    }

    double of_box(neighbors::Box const &box, Vector3 const &n) const noexcept
    {
        auto const relative = ellipsoid_.relative(box);
        return bound(relative, largest_magnitudes(relative), n);
    }

    Candidate improved(neighbors::Box const &box, Candidate const &first) const noexcept
    {
        auto const relative = ellipsoid_.relative(box);
        Vector3 const sizes = largest_magnitudes(relative),
                      nearest = nearest_corner(relative.lower, relative.upper);
        if (!(largest_coordinate(nearest) * range > 1.0 && sum_of(sizes) < range)) return first;
        auto const s = relative.template nearest<true, true>(ellipsoid_.form()).normal.direction;
        Candidate best = first;
        for (Vector3 const &along : {s, nearest}) {
            double const length = elementary::sqrt(dot(along, along));
            if (!(length > 0.0 && length < infinity<double>())) continue;
            Vector3 const n = (1.0 / length) * along;
            double const found = bound(relative, sizes, n);
            if (found > best.bound) best = {found, first.number, n};
        }
        return best;
    }

  private:
    /// Returns an upper bound of 3 Λ/(2√λ), infinite if the form is not clearly definite. Its
    /// largest diagonal entry is below 4, so Λ < 12. As in margin_of_contact(), 1/λ is at most the
    /// trace of Q⁻¹, and that at most four times the computed one.
    static double largest_ratio(Form3 const &q) noexcept
    {
        if (!is_clearly_definite(q)) return infinity<double>();
        auto const adj = adjugate(q);
        double const inverse = 4.0 * (adj(0, 0) + adj(1, 1) + adj(2, 2)) / determinant(q, adj);
        return 18.0 * elementary::sqrt(inverse);
    }

    /// Bound that a unit vector proves for a box or a triangle with coordinates up to `sizes`.
    template <class Shape>
    double bound(Shape const &shape, Vector3 const &sizes, Vector3 const &n) const noexcept
    {
        double const form = quadratic_form(ellipsoid_.form(), n), reach = sum_of(sizes);
        if (!(form > 0.0 && reach < range)) return -infinity<double>();
        constexpr double error = 64 * unit_roundoff<double>();
        return shape.least_projection(n) - elementary::sqrt(form) -
               error * (reach + largest_ratio_);
    }

    Ellipsoid const &ellipsoid_;
    double largest_ratio_;
};

} // namespace
} // namespace pw85::detail::meshes

#endif
