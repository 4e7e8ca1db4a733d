// SPDX-License-Identifier: BSD-3-Clause
#ifndef PW85_TESTS_DRAWS_HPP_INCLUDED
#define PW85_TESTS_DRAWS_HPP_INCLUDED

#include <cstdlib>

#include <glib.h>

namespace pw85_tests {

/// Eighths of the random inputs that the tests take: 1 with the argument `-m quick`. With
/// `-m thorough` they are 8, or the number in the environment variable PW85_EIGHTHS.
inline int eighths()
{
    static int const number = [] {
        char const *const chosen = g_test_thorough() ? std::getenv("PW85_EIGHTHS") : "1";
        return chosen == nullptr ? 8 : std::atoi(chosen);
    }();
    g_assert_cmpint(number, >=, 1);
    g_assert_cmpint(number, <=, 8);
    return number;
}

/// How many random inputs a test takes, of `count`.
inline int draws(int count) { return (eighths() * count + 7) / 8; }

/// The step through a list of inputs: `step` if the test takes all inputs, and up to 8 times as
/// large if it takes fewer.
inline int stride(int step) { return 8 * step / eighths(); }

} // namespace pw85_tests

#endif
