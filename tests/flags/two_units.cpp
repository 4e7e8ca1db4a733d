// SPDX-License-Identifier: BSD-3-Clause
// A program of two units with different flags, of which the plain one runs; with an argument, the
// other one does, too. The plain one and the library must be what they are without the other: they
// run on any processor, and see NaN.
#include <cmath>
#include <limits>

#include <pw85.h>
#include <pw85_batch.h>

double plain_unit(double x);
double other_unit(double x);

namespace {

bool library_sees_nan()
{
    double const r12[3] = {1.0, 2.0, std::numeric_limits<double>::quiet_NaN()},
                 q[6] = {1.0, 0.0, 0.0, 1.0, 0.0, 1.0};
    double out[2], mu2;
    int overlap = 0;
    return pw85_contact(r12, q, q, out) == PW85_EINVAL &&
           pw85_overlap(r12, q, q, &overlap) == PW85_EINVAL &&
           pw85_contact_function(r12, q, q, out) == PW85_EINVAL &&
           pw85_contact_batch(1, r12, q, q, &mu2, nullptr) == PW85_EINVAL;
}

} // namespace

int main(int argc, char **)
{
    if (!std::isfinite(plain_unit(3.0))) return 1;
    if (!std::isnan(plain_unit(std::numeric_limits<double>::quiet_NaN()))) return 2;
    if (!library_sees_nan()) return 3;
    return argc > 1 && !std::isfinite(other_unit(3.0)) ? 4 : 0;
}
