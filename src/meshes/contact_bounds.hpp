// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Bounds of the contact function of an ellipsoid and the triangles of a mesh, for search.hpp.
/// mesh.cpp includes this file.
///
/// The proof of a bound is a vector s: the least xᵀQ⁻¹x in a box is at least (s·y)²/(sᵀQs), where y
/// is the point of the box with the least s·y (Separation in overlap_shapes.hpp). The bound is
/// sharp if s is the normal at the nearest point of the box.
///
/// The computed μ² of a triangle may be less than the exact one, by 80 u S (pw85.h). A Margin is
/// twice that. By Cauchy's inequality |s_i| <= μ √(Q⁻¹)_ii. So the first part of S is at most
/// (Σ|s_i| √Q_ii)² <= 3 μ² Σ Q_ii (Q⁻¹)_ii, and the second part is at most 2 μ Σ V_i √(Q⁻¹)_ii if
/// no coordinate i in the box is larger than V_i.
#ifndef PW85_MESHES_CONTACT_BOUNDS_HPP_INCLUDED
#define PW85_MESHES_CONTACT_BOUNDS_HPP_INCLUDED

#include "search.hpp"

namespace pw85::detail::meshes {
namespace {

/// The largest error of a computed μ² downwards.
struct Margin {
    double factor;   ///< of μ²
    Vector3 weights; ///< of μ times the largest coordinates

    double reduced(double mu2, Vector3 const &sizes) const noexcept
    {
        return maximum(0.0, mu2 - factor * mu2 - elementary::sqrt(mu2) * dot(weights, sizes));
    }
};

/// Returns the margin of contact_triangle(). If the form is not clearly definite,
/// contact_triangle() uses numbers of more digits, and rounds the result. Rounding errors of
/// adj(Q)_ii and det Q are at most a half of these numbers if the form is clearly definite
/// (definite.hpp). The quotient is then at least a quarter of the exact one.
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

class ContactBounds {
  public:
    ContactBounds(Ellipsoid const &ellipsoid, Margin const &margin) noexcept
        : ellipsoid_(ellipsoid), margin_(margin)
    {
    }

    double of_triangle(Triangle const &triangle, Vector3 const &s) const noexcept
    {
        auto const hull = ellipsoid_.in_unit(ellipsoid_.relative(triangle));
        return bound(hull, hull.magnitudes(s), s);
    }

    double of_box(neighbors::Box const &box, Vector3 const &s) const noexcept
    {
        auto const relative = ellipsoid_.relative(box);
        return bound(relative, largest_magnitudes(relative), s);
    }

    Candidate improved(neighbors::Box const &box, Candidate const &first) const noexcept
    {
        auto const relative = ellipsoid_.relative(box);
        Vector3 const sizes = largest_magnitudes(relative);
        double const nearest = largest_coordinate(nearest_corner(relative.lower, relative.upper));
        if (!(nearest * range > 1.0 && sum_of(sizes) < range)) return first;
        auto const s = relative.template nearest<true, true>(ellipsoid_.form()).normal.direction;
        return {bound(relative, sizes, s), first.number, s};
    }

  private:
    /// Bound that a vector proves for a box or a triangle with largest coordinates `sizes`, or 0.
    template <class Shape>
    double bound(Shape const &shape, Vector3 const &sizes, Vector3 const &s) const noexcept
    {
        auto const [least, form] = separation(shape, ellipsoid_.form(), s);
        if (!(least > 0.0 && form > 0.0 && sum_of(sizes) < range)) return 0.0;
        constexpr double rounding = 1.0 - 16.0 * unit_roundoff<double>();
        return margin_.reduced(rounding * (least * least / form), sizes);
    }

    Ellipsoid const &ellipsoid_;
    Margin margin_;
};

} // namespace
} // namespace pw85::detail::meshes

#endif
