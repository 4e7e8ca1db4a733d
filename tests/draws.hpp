// SPDX-License-Identifier: BSD-3-Clause
#ifndef PW85_TESTS_DRAWS_HPP_INCLUDED
#define PW85_TESTS_DRAWS_HPP_INCLUDED

#include <glib.h>

namespace pw85_tests {

/// How many random inputs a test takes, of `count`: all with the argument `-m thorough`, an eighth
/// with `-m quick`.
inline int draws(int count) { return g_test_thorough() ? count : (count + 7) / 8; }

} // namespace pw85_tests

#endif
