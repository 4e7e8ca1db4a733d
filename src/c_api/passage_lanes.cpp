// SPDX-License-Identifier: BSD-3-Clause
// The C API, many rows with lanes: closest passages and free paths.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85_batch.h>

#include "../rows/many_pairs.hpp"
#include "../simd/lanes/passage.hpp"

using namespace pw85::detail::kernels;

int pw85_closest_passage_batch(size_t n, double const *r12, double const *q1, double const *q2,
                               double const *velocity, double t_max, double *mu2, double *t)
{
    static constexpr char const *names[] = {"pw85_closest_passage_batch", "r12", "q1", "q2",
                                            "velocity", "mu2"};
    return compute_rows(names, n, PairArrays<3>{r12, q1, q2},
                        PassageArrays{velocity, t_max, mu2, t}, r12, q1, q2, velocity, mu2);
}
