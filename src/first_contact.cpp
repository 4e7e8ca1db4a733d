// The C API of moving ellipsoids. The function checks for null pointers; the core checks everything else.
#include <pw85.h>

#include "c_arrays.hpp"
#include "floating_point_environment.hpp"
#include "kernels/kernels.hpp"

using namespace pw85;
using namespace pw85::detail;
using namespace pw85::detail::c_api;

int pw85_first_contact(double const r12[3], double const q1[6], double const q2[6], pw85_motion const *motion1,
                       pw85_motion const *motion2, double t_max, double *t)
{
    if (any_null(r12, q1, q2, t) || any_null(motion1, motion2)) return null_pointer(t, 1);
    return in_default_environment(kernels::chosen().one_pair->first_contact, r12, q1, q2, motion1, motion2, t_max, t);
}
