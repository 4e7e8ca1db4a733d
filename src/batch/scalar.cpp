// The functions for one pair, compiled once per instruction set.
#include <pw85/overlap.hpp>

#include "../c_arrays.hpp"
#include "kernels.hpp"

namespace pw85::batch {

namespace {

int contact(double const *r12, double const *q1, double const *q2, double *out) noexcept
{
    auto const c = pw85::contact(c_api::load_vector<3>(r12), c_api::load_matrix<3>(q1), c_api::load_matrix<3>(q2));
    out[0] = c.mu2;
    out[1] = c.lambda;
    return static_cast<int>(c.status);
}

int overlap(double const *r12, double const *q1, double const *q2, int *overlap) noexcept
{
    auto const o = pw85::overlap(c_api::load_vector<3>(r12), c_api::load_matrix<3>(q1), c_api::load_matrix<3>(q2));
    *overlap = o.status == Status::success ? static_cast<int>(o.overlap) : -1;
    return static_cast<int>(o.status);
}

} // namespace

extern ScalarKernels const PW85_SCALAR_KERNELS;
ScalarKernels const PW85_SCALAR_KERNELS = {contact, overlap};

} // namespace pw85::batch
