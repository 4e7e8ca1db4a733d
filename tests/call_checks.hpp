// SPDX-License-Identifier: BSD-3-Clause
// What a call of any function must do, with valid arguments and with one that is spoiled.
#ifndef PW85_TESTS_CALL_CHECKS_HPP_INCLUDED
#define PW85_TESTS_CALL_CHECKS_HPP_INCLUDED

#include <cmath>
#include <string>
#include <vector>

#include "failures.hpp"
#include "marks.hpp"

namespace pw85_tests {

/// Three pairs: apart, overlapping, and of unlike sizes.
inline std::vector<Sample<double, 3>> const three_pairs = {
    {{3.0, 2.5, 2.0}, {2.0, 0.0, 0.0, 2.0, 0.0, 3.0}, {2.0, 0.0, 0.0, 2.0, 0.5, 3.0}},
    {{1.5, 0.5, 0.25}, {4.0, 0.5, 0.0, 3.0, 0.0, 2.0}, {1.0, 0.0, 0.25, 2.0, 0.0, 1.0}},
    {{1.0, 1.0, 1.0}, {0.25, 0.0, 0.0, 0.25, 0.0, 0.25}, {4.0, 0.0, 0.0, 2.0, 0.0, 3.0}}};

/// Calls a function: its status is what it should be, or the number that it returns is NaN where it
/// should be, and nothing is written where it should not be.
inline void expect(Failures &failures, Call &call, std::string const &what, int expected)
{
    Answer const answer = call();
    auto const text = [&] { return what + ": " + call.text(); };
    Result const result = call.function().result;
    failures.check(result != Result::status || answer.status == expected, "status", answer.status,
                   expected, text);
    failures.check(result != Result::real || std::isnan(answer.real) == (expected != PW85_SUCCESS),
                   "number", answer.real, expected, text);
    failures.check(guards_intact(call), "guards", 0.0, 1.0, text);
}

/// The same of a call whose parameter `k` is spoiled, in its first row if it has rows: that row of
/// the outputs is marked. What is wrong with all rows, as a null pointer or a parameter of a law,
/// is found before anything is written.
inline void expect_error(Failures &failures, Call &call, std::size_t k, std::string const &what,
                         int expected)
{
    expect(failures, call, what, expected);
    Parameter const &p = call.parameter(k);
    bool const of_first_row = !p.shape.empty() && p.shape[0].parameter >= 0 &&
                              call[k].pointer != nullptr && std::string(p.name) != "parameters";
    bool const of_rows = call.is_of_rows();
    failures.check((of_rows && !of_first_row) || first_rows_marked(call), "outputs marked", 0.0,
                   1.0, [&] { return what + ": " + call.text(); });
}

/// Calls `visit` with each function and each parameter of it that a program gives numbers, real
/// ones or motions. Building blocks that compute with what they get are left out.
template <class Visit> void for_each_real_input(Visit const &visit)
{
    for (Function const &function : declared_functions()) {
        std::string const name = function.name;
        if (name.rfind("pw85__cholesky", 0) == 0 || name.find("legacy__") != std::string::npos)
            continue;
        for (std::size_t k = 0; k < function.parameters.size(); ++k) {
            Parameter const &p = function.parameters[k];
            if (!p.output && (p.type == Type::real || p.type == Type::motion)) visit(function, k);
        }
    }
}

} // namespace pw85_tests

#endif
