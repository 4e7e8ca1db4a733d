// SPDX-License-Identifier: BSD-3-Clause
// Converts ellipsoids to bodies of FCL, and calls FCL.
#ifndef PW85_BENCH_FCL_BODIES_HPP_INCLUDED
#define PW85_BENCH_FCL_BODIES_HPP_INCLUDED

#include <exception>
#include <optional>

#include <fcl/fcl.h>

#include "principal_axes.hpp"

namespace pw85_bench {

/// The semi-axes and the pose of an ellipsoid, from the six entries of its form.
struct Body {
    fcl::Ellipsoidd shape;
    fcl::Transform3d place = fcl::Transform3d::Identity();

    Body(PrincipalAxes const &axes, double const *center) : shape(axes.lengths)
    {
        place.linear() = axes.turn;
        place.translation() = fcl::Vector3d(center);
    }
};

struct Bodies {
    Body first, second;

    Bodies(double const *r12, double const *q1, double const *q2)
        : first(PrincipalAxes(q1), fcl::Vector3d(0.0, 0.0, 0.0).data()),
          second(PrincipalAxes(q2), r12)
    {
    }
};

inline bool fcl_collide(Bodies const &b, fcl::GJKSolverType solver)
{
    fcl::CollisionRequestd request;
    request.gjk_solver_type = solver;
    fcl::CollisionResultd result;
    return fcl::collide(&b.first.shape, b.first.place, &b.second.shape, b.second.place, request,
                        result) > 0;
}

/// The signed distance as Drake asks for it: by libccd, with a tolerance of 1e-6. Nothing if FCL
/// throws an exception.
inline std::optional<fcl::DistanceResultd> fcl_signed_distance(Bodies const &b)
{
    fcl::DistanceRequestd request(true, true);
    request.gjk_solver_type = fcl::GST_LIBCCD;
    request.distance_tolerance = 1e-6;
    fcl::DistanceResultd result;
    try {
        fcl::distance(&b.first.shape, b.first.place, &b.second.shape, b.second.place, request,
                      result);
    } catch (std::exception const &) {
        return std::nullopt;
    }
    return result;
}

} // namespace pw85_bench

#endif
