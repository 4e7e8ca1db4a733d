// SPDX-License-Identifier: BSD-3-Clause
// The cause of the last refusal, and what a test expects of it.
#ifndef PW85_TESTS_CAUSES_HPP_INCLUDED
#define PW85_TESTS_CAUSES_HPP_INCLUDED

#include <cmath>
#include <cstddef>
#include <optional>

#include <glib.h>

#include <pw85.h>

namespace pw85_tests {

/// Returns the cause of the last refusal in this thread, and forgets it.
inline pw85_error last_error()
{
    pw85_error error;
    g_assert_cmpint(pw85_last_error(&error), ==, PW85_SUCCESS);
    return error;
}

/// Expects a cause. `value` is NaN where the cause is not one number; without it the value is not
/// compared.
inline void expect_cause(char const *function, char const *argument, char const *requirement,
                         std::size_t row, std::size_t entry, std::optional<double> value = {})
{
    pw85_error const error = last_error();
    if (value && (std::isnan(*value) ? !std::isnan(error.value) : error.value != *value))
        g_error("%s: %s %s, not %a", function, argument, requirement, error.value);
    g_assert_cmpstr(error.function, ==, function);
    g_assert_cmpstr(error.argument, ==, argument);
    g_assert_cmpstr(error.requirement, ==, requirement);
    g_assert_cmpuint(error.row, ==, row);
    g_assert_cmpuint(error.entry, ==, entry);
    g_assert_null(last_error().function); // it is forgotten
}

} // namespace pw85_tests

#endif
