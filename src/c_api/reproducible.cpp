// SPDX-License-Identifier: BSD-3-Clause
// The C API: the reproducible mode.
#include <pw85.h>

#include "../base/c_arrays.hpp"
#include "../base/last_error.hpp"
#include "../simd/targets.hpp"

using namespace pw85::detail;
using namespace pw85::detail::c_api;

int pw85_set_reproducible(int on)
{
    if (on != 0 && on != 1)
        return refuse(PW85_EINVAL, {0, "pw85_set_reproducible", "on", "must be 0 or 1", 0, 0,
                                    static_cast<double>(on)});
    kernels::set_reproducible(on == 1);
    return PW85_SUCCESS;
}

int pw85_is_reproducible(int *on)
{
    if (any_null(on)) return refuse_call(PW85_EINVAL, "pw85_is_reproducible", Argument("on", on));
    *on = kernels::is_reproducible() ? 1 : 0;
    return PW85_SUCCESS;
}
