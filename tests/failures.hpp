// SPDX-License-Identifier: BSD-3-Clause
// Counts and prints the failures of a test case that runs over many inputs.
#ifndef PW85_TESTS_FAILURES_HPP_INCLUDED
#define PW85_TESTS_FAILURES_HPP_INCLUDED

#include <string>

#include <glib.h>

namespace pw85_tests {

/// Prints the first failures with their inputs, counts all, and fails the running case at the end
/// of its scope.
class Failures {
  public:
    Failures() = default;
    Failures(Failures const &) = delete;
    Failures &operator=(Failures const &) = delete;

    ~Failures()
    {
        if (failed_ > 0) g_test_fail_printf("%ld of %ld checks failed", failed_, checked_);
        if (checked_ == 0) g_test_fail_printf("nothing was checked");
    }

    /// Takes note of one check; `describe` returns the inputs as text, and is called for the first
    /// failures only.
    template <class Describe>
    bool check(bool ok, char const *what, double actual, double bound, Describe describe)
    {
        ++checked_;
        if (ok) return true;
        if (++failed_ <= shown) {
            std::string const inputs = describe();
            g_test_message("%s: %a (%.17g), bound or expected %a (%.17g); %s", what, actual, actual,
                           bound, bound, inputs.c_str());
        }
        return false;
    }

    long checked() const { return checked_; }

  private:
    static constexpr long shown = 5;
    long checked_ = 0, failed_ = 0;
};

} // namespace pw85_tests

#endif
