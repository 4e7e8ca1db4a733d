// SPDX-License-Identifier: BSD-3-Clause
// The scale of a cloud of points.
#include "cloud.hpp"

namespace pw85::detail::enclosing {

namespace {

struct Range {
    double lowest, highest;
    bool finite;
};

Range range_of(Cloud const &cloud, int k) noexcept
{
    auto const stride = static_cast<std::size_t>(cloud.n);
    double const *x = cloud.points + k;
    Range range{x[0], x[0], true};
    for (std::size_t i = 0; i < cloud.m; ++i) {
        double const y = x[i * stride];
        range.lowest = y < range.lowest ? y : range.lowest;
        range.highest = y > range.highest ? y : range.highest;
        range.finite &= y - y == 0.0;
    }
    return range;
}

} // namespace

Status choose_scale(Cloud &cloud) noexcept
{
    Status status = Status::success;
    for (int k = 0; k < cloud.n; ++k) {
        Range const range = range_of(cloud, k);
        if (!range.finite) return Status::invalid_argument;
        double const half = 0.5 * range.highest - 0.5 * range.lowest;
        if (half == 0.0) {
            status = Status::not_positive_definite;
            continue;
        }
        Unit const unit{binary_exponent(half) + 1};
        if (unit < Unit{-max_exponent} || Unit{max_exponent} < unit)
            return Status::invalid_argument;
        cloud.units[k] = unit;
        cloud.scale[k] = unit.to_local(1.0);
    }
    return status;
}

} // namespace pw85::detail::enclosing
