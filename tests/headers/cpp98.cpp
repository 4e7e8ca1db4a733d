// SPDX-License-Identifier: BSD-3-Clause
// The public C headers in C++98.
#include <pw85.h>
#include <pw85_enclosing.h>
#include <pw85_gpu.h>
#include <pw85_legacy.h>
#include <pw85_zheng.h>

#if __cplusplus != 199711L
#error "not compiled as C++98"
#endif

extern "C" int overlap_in_cpp98();

// 0 where two spheres that are apart are found to be apart, 2 otherwise.
int overlap_in_cpp98()
{
    double const r12[PW85_DIM] = {3.0, 0.0, 0.0}, q[PW85_SYM] = {1.0, 0.0, 0.0, 1.0, 0.0, 1.0};
    int overlap;
    return pw85_overlap(r12, q, q, &overlap) == PW85_SUCCESS && overlap == 0 ? 0 : 2;
}
