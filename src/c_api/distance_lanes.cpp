// SPDX-License-Identifier: BSD-3-Clause
// The C API, many rows with lanes: distance.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85_batch.h>

#include "../rows/many_pairs.hpp"
#include "../simd/lanes/depth.hpp"
#include "../simd/lanes/distance.hpp"
#include "../simd/lanes/signed_distance.hpp"

using namespace pw85::detail::kernels;

int pw85_distance_batch(size_t n, double const *r12, double const *q1, double const *q2,
                        double *distance, double *point1, double *point2)
{
    static constexpr char const *names[] = {"pw85_distance_batch", "r12", "q1", "q2"};
    return compute_rows(names, n, PairArrays<3>{r12, q1, q2},
                        DistanceArrays{distance, point1, point2}, r12, q1, q2);
}

int pw85_distance_geometry_batch(size_t n, double const *r12, double const *q1, double const *q2,
                                 double *distance, double *point1, double *point2, double *normal)
{
    static constexpr char const *names[] = {"pw85_distance_geometry_batch", "r12", "q1", "q2"};
    return compute_rows(names, n, PairArrays<3>{r12, q1, q2},
                        DistanceArrays{distance, point1, point2, normal}, r12, q1, q2);
}

int pw85_penetration_batch(size_t n, double const *r12, double const *q1, double const *q2,
                           double *depth, double *direction)
{
    static constexpr char const *names[] = {"pw85_penetration_batch", "r12", "q1", "q2"};
    return compute_rows(names, n, PairArrays<3>{r12, q1, q2}, DepthArrays{depth, direction}, r12,
                        q1, q2);
}

int pw85_signed_distance_batch(size_t n, double const *r12, double const *q1, double const *q2,
                               double *distance, double *point1, double *point2)
{
    static constexpr char const *names[] = {"pw85_signed_distance_batch", "r12", "q1", "q2"};
    return compute_rows(names, n, PairArrays<3>{r12, q1, q2},
                        SignedDistanceArrays{distance, point1, point2}, r12, q1, q2);
}

int pw85_signed_distance_geometry_batch(size_t n, double const *r12, double const *q1,
                                        double const *q2, double *distance, double *point1,
                                        double *point2, double *normal)
{
    static constexpr char const *names[] = {"pw85_signed_distance_geometry_batch", "r12", "q1",
                                            "q2"};
    return compute_rows(names, n, PairArrays<3>{r12, q1, q2},
                        SignedDistanceArrays{distance, point1, point2, normal}, r12, q1, q2);
}
