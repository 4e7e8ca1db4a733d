// SPDX-License-Identifier: BSD-3-Clause
// Runs a test case with each of the two solvers of the contact function.
#ifndef PW85_TESTS_SOLVERS_HPP_INCLUDED
#define PW85_TESTS_SOLVERS_HPP_INCLUDED

#include <string>

#include <glib.h>

#include <pw85.h>

namespace pw85_tests {

/// A solver under test; passed to the cases as data.
struct Solver {
    char const *name;
    int (*call)(double const *r12, double const *q1, double const *q2, double *out);
};

inline constexpr Solver solvers[] = {{"contact", pw85_contact},
                                     {"contact_function", pw85_contact_function}};

/// Adds a case for each, `folder`/(name of the solver)/`name`.
inline void add_for_each_solver(std::string const &folder, std::string const &name,
                                GTestDataFunc test)
{
    for (auto const &solver : solvers)
        g_test_add_data_func((folder + "/" + solver.name + "/" + name).c_str(), &solver, test);
}

} // namespace pw85_tests

#endif
