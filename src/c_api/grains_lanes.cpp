// SPDX-License-Identifier: BSD-3-Clause
// The C API, many rows with lanes: curvature and contact of grains.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85_batch.h>

#include "../rows/many_pairs.hpp"
#include "../simd/lanes/grains.hpp"

using namespace pw85::detail::kernels;

int pw85_grain_contact_batch(size_t n, double const *r12, double const *q1, double const *q2,
                             double const *starts, double *normal, double *depth, double *point,
                             double *curvatures, double *radius)
{
    static constexpr char const *names[] = {"pw85_grain_contact_batch", "r12", "q1", "q2",
                                            "starts"};
    return compute_rows(names, n, PairArrays<3>{r12, q1, q2},
                        GrainArrays{starts, normal, depth, point, curvatures, radius}, r12, q1, q2,
                        starts);
}
