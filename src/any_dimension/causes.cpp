// SPDX-License-Identifier: BSD-3-Clause
// The causes of refusals of functions in n dimensions.
#include "causes.hpp"

#include "../base/floating_point_environment.hpp"
#include "shared.hpp"

namespace pw85::detail::any_dimension {

int refuse_dimension(char const *function, int n) noexcept
{
    return refuse(PW85_EINVAL,
                  {0, function, "n", "must be from 1 to 16", 0, 0, static_cast<double>(n)});
}

bool is_indefinite(int n, double const *q) noexcept
{
    return in_default_environment([&] { return exact_status_of_form(n, q); }) ==
           Status::not_positive_definite;
}

int refuse_pair(int status, char const *function, int n, Argument const *arguments,
                std::size_t count) noexcept
{
    if (!is_dimension(n)) return refuse_dimension(function, n);
    if (status == PW85_ENOTPD)
        for (Argument const *form = arguments + 1; form < arguments + 3; ++form)
            if (is_indefinite(n, form->numbers()))
                return refuse(status, {0, function, form->name, "must be positive definite", 0, 0,
                                       quiet_nan<double>()});
    return refuse(status, function, arguments, count);
}

} // namespace pw85::detail::any_dimension
