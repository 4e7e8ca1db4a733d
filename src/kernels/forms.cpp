// Forms in bulk.
#include <pw85.h>

#include <pw85/bounding_box.hpp>
#include <pw85/forms.hpp>

#include "../c_arrays.hpp"
#include "parallel.hpp"

using namespace pw85;
using namespace pw85::kernels;
using pw85::c_api::any_null;

namespace {

/// Calls make(row), which returns a status, for n rows; returns that of the first bad one.
template <class Make> int for_rows(std::size_t n, Make const &make) noexcept
{
    return for_all(n, [&](Range range) {
        Failure first{0, 0};
        for (std::size_t i = range.begin; i < range.end; ++i) first.update({i, static_cast<int>(make(i))});
        return first;
    });
}

} // namespace

int pw85_ellipsoid_quaternion_batch(size_t n, double const *semi_axes, double const *quaternions, double *q)
{
    if (n == 0) return PW85_SUCCESS;
    if (n > max_rows || any_null(semi_axes, quaternions, q)) return PW85_EINVAL;
    return for_rows(n, [=](std::size_t i) {
        auto const form =
            ellipsoid_quaternion(c_api::load_vector<3>(semi_axes + 3 * i), c_api::load_vector<4>(quaternions + 4 * i));
        c_api::store(form.q, q + 6 * i);
        return form.status;
    });
}

int pw85_bounding_boxes(size_t n, double const *q, double *half_widths)
{
    if (n == 0) return PW85_SUCCESS;
    if (n > max_rows || any_null(q, half_widths)) return PW85_EINVAL;
    return for_rows(n, [=](std::size_t i) {
        auto const box = bounding_box(c_api::load_matrix<3>(q + 6 * i));
        c_api::store(box.half_widths, half_widths + 3 * i);
        return box.status;
    });
}
