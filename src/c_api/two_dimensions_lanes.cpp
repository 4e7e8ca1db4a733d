// SPDX-License-Identifier: BSD-3-Clause
// The C API, many rows with lanes: two dimensions.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85_batch.h>

#include "../rows/many_pairs.hpp"
#include "../simd/lanes/contact.hpp"
#include "../simd/lanes/overlap.hpp"
#include "../simd/lanes/two_dimensions.hpp"

using namespace pw85::detail::kernels;

int pw85_overlap_area_batch_2d(size_t n, double const *r12, double const *q1, double const *q2,
                               double *area)
{
    static constexpr char const *names[] = {"pw85_overlap_area_batch_2d", "r12", "q1", "q2",
                                            "area"};
    return compute_rows(names, n, PairArrays<2>{r12, q1, q2}, AreaArray{area}, r12, q1, q2, area);
}

int pw85_contact_batch_2d(size_t n, double const *r12, double const *q1, double const *q2,
                          double *mu2, double *lambda)
{
    static constexpr char const *names[] = {"pw85_contact_batch_2d", "r12", "q1", "q2", "mu2"};
    return compute_rows(names, n, PairArrays<2>{r12, q1, q2}, ContactArrays{mu2, lambda}, r12, q1,
                        q2, mu2);
}

int pw85_overlap_batch_2d(size_t n, double const *r12, double const *q1, double const *q2,
                          unsigned char *overlap)
{
    static constexpr char const *names[] = {"pw85_overlap_batch_2d", "r12", "q1", "q2", "overlap"};
    return compute_rows(names, n, PairArrays<2>{r12, q1, q2}, OverlapArray{overlap}, r12, q1, q2,
                        overlap);
}
