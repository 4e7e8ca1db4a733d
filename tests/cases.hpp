// SPDX-License-Identifier: BSD-3-Clause
// Test cases that register themselves where they stand, and the main function that runs them.
#ifndef PW85_TESTS_CASES_HPP_INCLUDED
#define PW85_TESTS_CASES_HPP_INCLUDED

#include <vector>

#include <glib.h>

namespace pw85_tests {

struct TestCase {
    char const *path;
    void (*run)();
};

/// All cases of a program, in the order of their definitions.
inline std::vector<TestCase> &test_cases()
{
    static std::vector<TestCase> all;
    return all;
}

struct TestRegistration {
    TestRegistration(char const *path, void (*run)()) { test_cases().push_back({path, run}); }
};

} // namespace pw85_tests

#define PW85_JOINED(a, b) a##b
#define PW85_OF_LINE(name, line) PW85_JOINED(name, line)

/// Registers a function that is not defined as a case, such as the instance of a template.
#define PW85_ADD_TEST(path, ...)                                                                   \
    pw85_tests::TestRegistration const PW85_OF_LINE(registration_of_line_, __LINE__)(path,         \
                                                                                     __VA_ARGS__)

/// The head of a test case, before its body, in an unnamed namespace: PW85_TEST("/shapes/spheres").
#define PW85_TEST(path)                                                                            \
    void PW85_OF_LINE(test_of_line_, __LINE__)();                                                  \
    PW85_ADD_TEST(path, PW85_OF_LINE(test_of_line_, __LINE__));                                    \
    void PW85_OF_LINE(test_of_line_, __LINE__)()

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, nullptr);
    for (pw85_tests::TestCase const &one : pw85_tests::test_cases())
        g_test_add_func(one.path, one.run);
    return g_test_run();
}

#endif
