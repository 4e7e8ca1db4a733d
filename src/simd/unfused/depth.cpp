// SPDX-License-Identifier: BSD-3-Clause
// The depth and the signed distance of one pair. Depths have the bits of lanes (lanes/depth.hpp).
#include "../one_pair.hpp"

#include <pw85/distance/signed_distance.hpp>

#include "../../base/c_arrays.hpp"

#define PW85_IS_BASELINE_baseline 1
#define PW85_IS_BASELINE_OF(name) PW85_IS_BASELINE_##name
#define PW85_IS_BASELINE(name) PW85_IS_BASELINE_OF(name)

namespace pw85::detail {

namespace kernels::baseline {

bool prove_globally(DepthSearch<double, 3> &search) noexcept;

#if PW85_IS_BASELINE(PW85_BUILDING)
bool prove_globally(DepthSearch<double, 3> &search) noexcept
{
    return detail::prove_globally<double, 3>(search);
}
#endif

} // namespace kernels::baseline

// Proofs without a certificate have the same bits and take the same time for each instruction set.
// So that of the baseline serves all; the call in the template finds it.
#if !PW85_IS_BASELINE(PW85_BUILDING)
using kernels::baseline::prove_globally; // NOLINT(misc-unused-using-decls)
#endif

} // namespace pw85::detail

namespace pw85::detail::kernels {

using namespace c_api;

namespace PW85_BUILDING {

int penetration(double const *r12, double const *q1, double const *q2, double *depth,
                double *direction) noexcept
{
    auto const &r = view_vector<3>(r12);
    auto const &m1 = view_matrix<3>(q1), &m2 = view_matrix<3>(q2);
    auto const start = start_depth(r, m1, m2);
    if (start.decision == Decision::apart) { // no result passes through memory
        constexpr double nan = quiet_nan<double>();
        return put(StatusCode::success, 0.0, depth, Vector<double, 3>{nan, nan, nan}, direction);
    }
    auto const found = find_depth(r, m1, m2, start).result;
    return put(found.status, found.depth, depth, found.direction, direction);
}

int signed_distance_geometry(double const *r12, double const *q1, double const *q2, double *length,
                             double *point1, double *point2, double *normal) noexcept
{
    auto const &r = view_vector<3>(r12);
    auto const &m1 = view_matrix<3>(q1), &m2 = view_matrix<3>(q2);
    auto const found = find_depth(r, m1, m2);
    if (found.apart) return distance_geometry(r12, q1, q2, length, point1, point2, normal);
    auto const result = signed_distance_overlapping(r, m1, m2, found.result);
    return put(result.status, result.distance, length, result.point1, point1, result.point2, point2,
               result.normal, normal);
}

int signed_distance(double const *r12, double const *q1, double const *q2, double *length,
                    double *point1, double *point2) noexcept
{
    return signed_distance_geometry(r12, q1, q2, length, point1, point2, nullptr);
}

int signed_distance_derivatives(double const *r12, double const *q1, double const *q2,
                                double *d_r12, double *d_rot1, double *d_rot2,
                                double *hessian) noexcept
{
    auto const &r = view_vector<3>(r12);
    auto const &m1 = view_matrix<3>(q1), &m2 = view_matrix<3>(q2);
    auto const found = find_depth(r, m1, m2);
    if (found.apart) return distance_derivatives(r12, q1, q2, d_r12, d_rot1, d_rot2, hessian);
    auto const result = signed_derivatives_overlapping(r, m1, m2, found.result);
    return put(result.status, result.r12, d_r12, result.rotation1, d_rot1, result.rotation2, d_rot2,
               result.hessian, hessian);
}

} // namespace PW85_BUILDING

} // namespace pw85::detail::kernels
