// SPDX-License-Identifier: BSD-3-Clause
// Every function of the libraries writes the outputs of its contract and nothing else, and returns
// the right status. It is called with valid arguments, and with NaN, infinities and null pointers
// in the place of each argument.
#include <limits>
#include <string>

#include <glib.h>

#include "call_checks.hpp"
#include "cases.hpp"

using namespace pw85_tests;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                 infinity = std::numeric_limits<double>::infinity();

// The first pair is apart: of all numbers, only the direction of its depth and a point in both are
// NaN.
PW85_TEST("/outputs/valid")
{
    Failures failures;
    for (Function const &function : declared_functions()) {
        Call call(function, three_pairs);
        expect(failures, call, "valid", PW85_SUCCESS);
        for (std::size_t k = 0; k < call.size(); ++k) {
            Parameter const &p = call.parameter(k);
            if (!p.output) continue;
            auto const text = [&] { return std::string(p.name) + " of " + call.text(); };
            failures.check(call.all_written(k), "all written", 0.0, 1.0, text);
            bool const in_both = std::string(function.name).find("witness") != std::string::npos &&
                                 is_one_of(p.name, {"point"});
            bool const inside =
                std::string(function.name).find("gap_inside") != std::string::npos &&
                is_one_of(p.name, {"point1", "point2", "normal"});
            bool const is_number =
                p.type == Type::real && !is_one_of(p.name, {"direction"}) && !in_both && !inside;
            for (std::size_t i = 0; is_number && i < call.row_length(k); ++i)
                failures.check(!is_marked(call, k, i), "a number", 0.0, 1.0, text);
        }
    }
    g_assert_cmpint(failures.checked(), >, 100);
}

// No number may be NaN or infinite, but for a time. Sums of forces are NaN where a number that goes
// into them is.
PW85_TEST("/outputs/not_finite")
{
    Failures failures;
    for_each_real_input([&](Function const &function, std::size_t k) {
        std::string const name = function.parameters[k].name;
        if (std::string(function.name) == "pw85_contact_forces_pairs") return;
        for (double const bad : {nan, infinity, -infinity})
            for (std::size_t i = 0;; ++i) {
                Call call(function, three_pairs);
                Numbers const x = numbers(call, k);
                if (i == x.size || (bad == infinity && is_one_of(name, {"t_max", "end", "mu2"})))
                    break;
                x.begin[i] = bad;
                expect_error(failures, call, k, "not finite in " + name, PW85_EINVAL);
            }
    });
}

PW85_TEST("/outputs/null")
{
    Failures failures;
    for (Function const &function : declared_functions()) {
        for (std::size_t k = 0; k < function.parameters.size(); ++k) {
            Parameter const &p = function.parameters[k];
            if (!p.pointer || p.nullable) continue;
            Call call(function, three_pairs);
            call[k].pointer = nullptr;
            expect_error(failures, call, k, std::string("null for ") + p.name, PW85_EINVAL);
        }
    }
}

// No rows need no arrays, and more rows than memory can have are refused before anything is
// written. The planes of a polytope are those of all rows.
PW85_TEST("/outputs/numbers_of_rows")
{
    Failures failures;
    for (Function const &function : declared_functions()) {
        std::string const name = function.name;
        if (function.parameters.empty() || function.parameters[0].type != Type::size ||
            name.find("_batch") == name.npos || name.find("polytope") != name.npos)
            continue;
        Call many(function, three_pairs), none(function, three_pairs);
        auto const before = many.outputs();
        for (std::size_t const n :
             {SIZE_MAX, SIZE_MAX / 6, SIZE_MAX / 48, SIZE_MAX / 48 + 1, SIZE_MAX / 96 + 1}) {
            many[0].size = n;
            int const status = many().status;
            failures.check(status == PW85_EINVAL, "status", status, PW85_EINVAL,
                           [&] { return name; });
        }
        many[0].size = 3;
        failures.check(many.outputs() == before, "outputs", 0.0, 1.0, [&] { return name; });
        none[0].size = 0;
        for (std::size_t k = 0; k < none.size(); ++k)
            if (none.parameter(k).pointer) none[k].pointer = nullptr;
        int const status = none().status;
        failures.check(status == PW85_SUCCESS, "status", status, 0.0, [&] { return name; });
    }
    g_assert_cmpint(failures.checked(), >, 350);
}

// All that may be null is, and each of them: `images` go with a cell, `next_pair` with `next`,
// derivatives with the outputs that need them, and a cell with a list that was made with one.
PW85_TEST("/outputs/optional")
{
    Failures failures;
    for (Function const &function : declared_functions()) {
        Call none(function, three_pairs);
        for (std::size_t k = 0; k < none.size(); ++k)
            if (none.parameter(k).nullable) none[k].pointer = nullptr;
        expect(failures, none, "all null that may be", PW85_SUCCESS);
        for (std::size_t k = 0; k < function.parameters.size(); ++k) {
            Parameter const &p = function.parameters[k];
            if (!p.nullable) continue;
            bool const is_derivative = !p.output && std::string(p.name).rfind("d_", 0) == 0;
            Call call(function, three_pairs);
            call[k].pointer = nullptr;
            for (std::size_t j = 0; j < call.size(); ++j)
                if ((is_one_of(p.name, {"cell"}) &&
                     is_one_of(call.parameter(j).name, {"images"})) ||
                    (is_one_of(p.name, {"next"}) &&
                     is_one_of(call.parameter(j).name, {"next_pair"})))
                    call[j].pointer = nullptr;
            expect(failures, call, std::string("null for ") + p.name,
                   is_derivative ? PW85_EINVAL : PW85_SUCCESS);
        }
    }
}

} // namespace
