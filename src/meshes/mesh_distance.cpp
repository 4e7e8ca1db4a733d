// SPDX-License-Identifier: BSD-3-Clause
// The signed distance of an ellipsoid and a triangle mesh, in the C API.
#include <pw85.h>
#include <pw85_systems.h>

#include <pw85/distance/solids.hpp>

#include "../base/objects.hpp"
#include "distance_bounds.hpp"
#include "ellipsoids.hpp"
#include "winding.hpp"

using namespace pw85;
using namespace pw85::detail;
using namespace pw85::detail::c_api;
using namespace pw85::detail::meshes;

namespace {

/// The distance of a triangle, its number, and whether the centre is inside (is_inside()).
struct FoundDistance {
    ShapeDistance<double> distance;
    std::int32_t triangle;
    int inside;
};

FoundDistance failure(Status status) noexcept
{
    return {all_nan<ShapeDistance<double>>(status), -1, -1};
}

/// Returns the triangle with the least computed distance; the first one of several.
FoundDistance find_distance(pw85_mesh const &mesh, Vector3 const &center, Form3 const &q) noexcept
{
    Status const status = validate(mesh, center, q);
    FoundDistance best = failure(status);
    if (status != Status::success) return best;
    best.distance.distance = infinity<double>();
    Ellipsoid const ellipsoid(center, q);
    auto const visit = [&](Triangle const &triangle) {
        auto const &[a, b, c] = ellipsoid.relative(triangle).points;
        ShapeDistance<double> found{};
        found.status = static_cast<Status>(pw85_distance_triangle(
            a.coordinates, b.coordinates, c.coordinates, q.entries, &found.distance,
            found.point1.coordinates, found.point2.coordinates, found.normal.coordinates));
        double const least = best.distance.distance;
        bool const is_first = best.triangle < 0 || triangle.index < best.triangle;
        if (found.distance < least || (found.distance == least && is_first))
            best = {found, triangle.index, -1};
        return ellipsoid.in_unit(best.distance.distance);
    };
    search(mesh, DistanceBounds(ellipsoid), infinity<double>(), visit);
    best.inside = is_inside(mesh, center);
    return best;
}

/// Pointers to the outputs of one ellipsoid. Any may be null.
struct Outputs {
    double *distance, *point1, *point2, *normal;
    std::int32_t *triangle, *inside;

    Outputs row(std::size_t i) const noexcept
    {
        auto const at = [i](auto *x, std::size_t width) { return x ? x + width * i : x; };
        return {at(distance, 1), at(point1, 3),   at(point2, 3),
                at(normal, 3),   at(triangle, 1), at(inside, 1)};
    }

    int put(FoundDistance const &found) const noexcept
    {
        c_api::store(found.distance.distance, distance);
        c_api::store(found.distance.point1, point1);
        c_api::store(found.distance.point2, point2);
        c_api::store(found.distance.normal, normal);
        if (triangle != nullptr) *triangle = found.triangle;
        if (inside != nullptr) *inside = found.inside;
        return static_cast<int>(found.distance.status);
    }
};

} // namespace

int pw85::detail::mesh_distance(pw85_mesh const &mesh, double const center[3], double const q[6],
                                double *distance, double point1[3], double point2[3],
                                double normal[3], int32_t *triangle, int32_t *inside) noexcept
{
    return Outputs{distance, point1, point2, normal, triangle, inside}.put(
        find_distance(mesh, load_vector<3>(center), load_matrix<3>(q)));
}

int pw85::detail::mesh_distance_batch(pw85_mesh const &mesh, size_t n, double const *centers,
                                      double const *q, double *distance, double *point1,
                                      double *point2, double *normal, int32_t *triangle,
                                      int32_t *inside) noexcept
{
    Outputs const outputs{distance, point1, point2, normal, triangle, inside};
    return each_ellipsoid(n, [&](std::size_t i) {
        return outputs.row(i).put(
            find_distance(mesh, load_vector<3>(centers + 3 * i), load_matrix<3>(q + 6 * i)));
    });
}
