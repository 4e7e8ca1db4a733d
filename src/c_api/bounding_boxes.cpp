// SPDX-License-Identifier: BSD-3-Clause
// The C API, many rows: bounding boxes.
#include <pw85_batch.h>

#include <pw85/distance/bounding_box.hpp>

#include "../base/c_arrays.hpp"
#include "../rows/each_row.hpp"

using namespace pw85;
using namespace pw85::detail;
using namespace pw85::detail::kernels;

namespace {

/// Computes the bounding box of one form. The function is not inlined, so that the compiler cannot
/// move its arithmetic out of the default floating-point environment.
[[gnu::noinline]] int bounding_box_of(double const *q, double *half_widths) noexcept
{
    auto const box = bounding_box(c_api::load_matrix<3>(q));
    c_api::store(box.half_widths, half_widths);
    return checked(static_cast<int>(box.status), [&](int status) {
        return refuse_call(status, "pw85_bounding_boxes", Argument("q", q, 6, limit::definite));
    });
}

} // namespace

int pw85_bounding_boxes(size_t n, double const *q, double *half_widths)
{
    static constexpr char const *names[] = {"pw85_bounding_boxes", "q", "half_widths"};
    return each_row(names, n, bounding_box_of, RowsOf<6>{q}, RowsOf<3, double>{half_widths});
}
