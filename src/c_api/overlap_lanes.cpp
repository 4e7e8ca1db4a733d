// SPDX-License-Identifier: BSD-3-Clause
// The C API, many rows with lanes: overlaps.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85_batch.h>

#include "../rows/many_pairs.hpp"
#include "../simd/lanes/overlap.hpp"

using namespace pw85::detail::kernels;

int pw85_overlap_batch(size_t n, double const *r12, double const *q1, double const *q2,
                       unsigned char *overlap)
{
    static constexpr char const *names[] = {"pw85_overlap_batch", "r12", "q1", "q2", "overlap"};
    return compute_rows(names, n, PairArrays<3>{r12, q1, q2}, OverlapArray{overlap}, r12, q1, q2,
                        overlap);
}
