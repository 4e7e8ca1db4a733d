// SPDX-License-Identifier: BSD-3-Clause
// Tiers that hardly ever run: the operations of extended numbers.
#include <pw85/algebra/extended_number.hpp>

#include "define.hpp"

namespace pw85::detail::exact {

Extended<double> operator+(Extended<double> const &x, Extended<double> const &y) noexcept
{
    return operator+<>(x, y);
}

Extended<double> operator*(Extended<double> const &x, Extended<double> const &y) noexcept
{
    return operator*<>(x, y);
}

PW85_DEFINE_OF(reciprocal, double)
PW85_DEFINE_OF(sqrt, double)

} // namespace pw85::detail::exact
