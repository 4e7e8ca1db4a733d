// SPDX-License-Identifier: BSD-3-Clause
// The parameters of HOOMD-blue's ellipsoids, for peer_hoomd.cpp and peer_hoomd_matrices.cpp.
#ifndef PW85_BENCH_HOOMD_SHAPES_HPP_INCLUDED
#define PW85_BENCH_HOOMD_SHAPES_HPP_INCLUDED

#include <hoomd/hpmc/ShapeEllipsoid.h>

#include <Eigen/Geometry>

#include "principal_axes.hpp"

namespace pw85_bench {
namespace {

/// Semi-axes and orientation of a form.
struct HoomdShape {
    hpmc::ell_params lengths;
    quat<Scalar> orientation;

    explicit HoomdShape(double const *q)
    {
        PrincipalAxes const axes(q);
        Eigen::Quaterniond const turn(axes.turn);
        lengths.x = static_cast<hpmc::OverlapReal>(axes.lengths[0]);
        lengths.y = static_cast<hpmc::OverlapReal>(axes.lengths[1]);
        lengths.z = static_cast<hpmc::OverlapReal>(axes.lengths[2]);
        lengths.ignore = 0;
        orientation = quat<Scalar>(turn.w(), vec3<Scalar>(turn.x(), turn.y(), turn.z()));
    }
};

} // namespace
} // namespace pw85_bench

#endif
