// SPDX-License-Identifier: BSD-3-Clause
// The C API of curvatures and of Hertzian contacts whose results consist of several values.
#include <pw85.h>

#include <pw85/distance/hertz.hpp>

#include "../base/c_arrays.hpp"
#include "../base/floating_point_environment.hpp"

using namespace pw85;
using namespace pw85::detail;
using namespace pw85::detail::c_api;

namespace {

void store_curvature(Curvature<double> const &c, double *curvatures, double *directions) noexcept
{
    store(c.curvatures, curvatures);
    if (directions == nullptr) return;
    store(c.direction1, directions);
    store(c.direction2, directions + PW85_DIM);
}

void store_hertz(HertzEllipse<double> const &h, double *radius, double *ellipse) noexcept
{
    if (radius != nullptr) *radius = h.radius;
    store(h.ellipse, ellipse);
}

} // namespace

int pw85_curvature(double const normal[3], double const q[6], double curvatures[2],
                   double directions[6])
{
    if (any_null(normal, q)) return null_pointer(curvatures, 2, directions, 6);
    return in_default_environment([&] {
        auto const c = curvature(load_vector<3>(normal), load_matrix<3>(q));
        store_curvature(c, curvatures, directions);
        return static_cast<int>(c.status);
    });
}

int pw85_hertz_contact(double const r12[3], double const q1[6], double const q2[6],
                       double const normal[3], double *depth, double point[3], double curvatures[2],
                       double directions[6], double *radius, double ellipse[2])
{
    if (any_null(r12, q1, q2, normal))
        return null_pointer(depth, 1, point, PW85_DIM, curvatures, 2, directions, 6, radius, 1,
                            ellipse, 2);
    return in_default_environment([&] {
        auto const c = hertz_contact(load_vector<3>(r12), load_matrix<3>(q1), load_matrix<3>(q2),
                                     load_vector<3>(normal));
        if (depth != nullptr) *depth = c.depth;
        store(c.point, point);
        store_curvature(c.relative, curvatures, directions);
        store_hertz(c.hertz, radius, ellipse);
        return static_cast<int>(c.status);
    });
}
