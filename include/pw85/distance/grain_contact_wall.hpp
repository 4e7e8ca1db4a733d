// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The contact of a grain with a wall that is curved along one direction.
///
/// Let K be the second fundamental form of the grain in the tangent plane, with the eigenvalues k1
/// <= k2, and d the direction, so that the gap has the form K + c ddᵀ with the curvature c of the
/// wall. Its determinant is det K + c N, N = d_y² K_xx - 2 d_x d_y K_xy + d_x² K_yy, which is k1
/// sin² + k2 cos² of the angle between d and the direction of k1. For c >= 0 both terms are
/// positive and nothing cancels, however much the curvatures of the gap differ: the smaller one is
/// the determinant over the larger one. If the trace is negative, the larger one is the determinant
/// over the other one, which is negative.
///
/// For c < 0 the determinant is a difference. Plain arithmetic is used if |c| N is at most half of
/// det K. Then N >= k1 bounds -c by k2/2, and the relative errors of item 2 of
/// principal_curvatures.hpp are multiplied by three at most. Other walls are computed with twice
/// the digits. The error of about 2^-100 (det K - c N) then leaves the curvatures correct to 1e-12
/// if the smaller one is at least 2^-20 times the larger one. A smaller one is set to 2^-20 times
/// the larger one.
#ifndef PW85_DISTANCE_GRAIN_CONTACT_WALL_HPP_INCLUDED
#define PW85_DISTANCE_GRAIN_CONTACT_WALL_HPP_INCLUDED

#include <pw85/distance/hertz.hpp>

namespace pw85 {

/// The contact of an ellipsoid with a wall.
template <class T> struct GrainWallContact {
    T depth;
    Vector<T, 3> point; ///< of the ellipsoid, the deepest one in the wall
    Vector<T, 2> curvatures;
    T radius;
    StatusCode status;
};

} // namespace pw85

namespace pw85::detail {

/// The least ratio of the two curvatures of a gap is 2^-least_curvature_ratio_exponent. If a grain
/// has the curvature of a cylindrical wall, the surfaces touch along a line, and Hertz's theory has
/// no finite radius.
inline constexpr int least_curvature_ratio_exponent = 20;

/// A wall at an ellipsoid, in a unit in which the form is of order one. The curvature of the wall
/// is in a unit that is not smaller: neither it nor that of the ellipsoid overflows.
template <class T> struct CurvedWall {
    Vector<T, 3> normal, direction;
    T curvature;
    Unit unit;
};

/// The eigenvalues of K + c ddᵀ in the unit of the curvature of the wall, by numbers of type W.
/// `accurate` says whether they suffice.
template <class W, class T>
PW85_FUNCTION inline Vector<T, 2> gap_curvatures_with(CurvedWall<T> const &wall,
                                                      SymmetricMatrix<T, 3> const &scaled,
                                                      bool &accurate) noexcept
{
    auto const frame = tangent_frame(converted<W>(wall.normal));
    auto const surface = curved_surface(converted<W>(scaled), frame);
    auto const k = W(wall.unit.to_local(T(1))) * surface.shape;
    Vector<W, 3> const direction = converted<W>(wall.direction);
    W const factor = W(1) / magnitude(direction), c = W(wall.curvature),
            x = factor * dot(direction, frame.e1), y = factor * dot(direction, frame.e2);
    W const own = k[0] * k[2] - k[1] * k[1],
            added = c * W(y * W(y * k[0]) - W(2) * W(x * W(y * k[1])) + x * W(x * k[2]));
    W const cx = c * x, both = own + added;
    accurate = surface.accurate && added >= W(-0.5) * own;
    auto const values =
        principal_values(SymmetricMatrix<W, 2>{k[0] + cx * x, k[1] + cx * y, k[2] + W(c * y) * y});
    W const larger = values.larger < values.root ? W(both / W(values.larger - W(2) * values.root))
                                                 : values.larger;
    W const least = W(negative_power_of_two<T>(least_curvature_ratio_exponent)) * larger;
    return {rounded(minimum(maximum(W(both / larger), least), larger)), rounded(larger)};
}

/// Computes the curvatures of the gap with twice the digits.
template <class T> PW85_RARE Vector<T, 2>
gap_curvatures_finer(CurvedWall<T> const &wall, SymmetricMatrix<T, 3> const &scaled) noexcept
{
    bool accurate;
    return gap_curvatures_with<Finer<T>>(wall, scaled, accurate);
}

PW85_RARE_TIER_OF(gap_curvatures_finer, double)

} // namespace pw85::detail

namespace pw85 {

template <class T> PW85_FUNCTION inline GrainWallContact<T>
grain_contact_wall(Vector<T, 3> const &normal, T const &offset, Vector<T, 3> direction,
                   T const &curvature_of_wall, SymmetricMatrix<T, 3> const &q) noexcept
{
    using namespace detail;
    if (scale_normal(direction) != StatusCode::success || !(curvature_of_wall * T(0) == T(0)))
        return all_nan<GrainWallContact<T>>(StatusCode::invalid_argument);
    auto const d = distance_plane(normal, offset, q);
    if (d.status != StatusCode::success) return all_nan<GrainWallContact<T>>(d.status);
    Unit const unit = unit_in_range(q);
    auto const scaled = unit.to_local(q);
    T const size = absolute(curvature_of_wall);
    Unit const relative = size > T(0) ? larger_of(Unit{}, unit_of(size) * unit) : Unit{},
               radius = unit / relative;
    CurvedWall<T> wall{normal, direction, radius.to_local(curvature_of_wall, -1), relative};
    scale_normal(wall.normal);
    bool accurate;
    auto k = gap_curvatures_with<T>(wall, scaled, accurate);
    if constexpr (!std::is_same_v<Finer<T>, T>)
        if (!accurate) k = gap_curvatures_finer(wall, scaled);
    return {-d.distance, d.point, radius.to_caller(k, -1),
            radius.to_caller(hertz_radius(k[0], k[1])), StatusCode::success};
}

} // namespace pw85

#endif
