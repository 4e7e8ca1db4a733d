// SPDX-License-Identifier: BSD-3-Clause
// The C API, many rows with lanes: contact of two ellipsoids.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85_batch.h>

#include "../rows/many_pairs.hpp"
#include "../simd/lanes/contact.hpp"

using namespace pw85::detail::kernels;

int pw85_contact_batch(size_t n, double const *r12, double const *q1, double const *q2, double *mu2,
                       double *lambda)
{
    static constexpr char const *names[] = {"pw85_contact_batch", "r12", "q1", "q2", "mu2"};
    return compute_rows(names, n, PairArrays<3>{r12, q1, q2}, ContactArrays{mu2, lambda}, r12, q1,
                        q2, mu2);
}

int pw85_closest_approach_batch(size_t n, double const *directions, double const *q1,
                                double const *q2, double *distance)
{
    static constexpr char const *names[] = {"pw85_closest_approach_batch", "directions", "q1", "q2",
                                            "distance"};
    return compute_rows(names, n, Directions{{directions, q1, q2}}, ApproachArray{distance},
                        directions, q1, q2, distance);
}
