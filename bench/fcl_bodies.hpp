// SPDX-License-Identifier: BSD-3-Clause
// Converts ellipsoids to bodies of FCL, for peers.cpp and peer_fcl.cpp.
#ifndef PW85_BENCH_FCL_BODIES_HPP_INCLUDED
#define PW85_BENCH_FCL_BODIES_HPP_INCLUDED

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

} // namespace pw85_bench

#endif
