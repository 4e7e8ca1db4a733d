// SPDX-License-Identifier: BSD-3-Clause
// The C API, many rows with lanes: volumes and intersections.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85_batch.h>

#include "../rows/many_pairs.hpp"
#include "../simd/lanes/volumes.hpp"

using namespace pw85::detail::kernels;

int pw85_overlap_volume_batch(size_t n, double const *r12, double const *q1, double const *q2,
                              double *volume)
{
    static constexpr char const *names[] = {"pw85_overlap_volume_batch", "r12", "q1", "q2",
                                            "volume"};
    return compute_rows(names, n, PairArrays<3>{r12, q1, q2}, VolumeArray{volume}, r12, q1, q2,
                        volume);
}
