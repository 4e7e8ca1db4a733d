// SPDX-License-Identifier: BSD-3-Clause
// The functions of many rows that have no lanes give what the functions of one row give, bit by bit
// and whatever the number of threads. The test finds the functions by their names, so that a new
// function is tested as soon as it is declared.
#include <string>

#include <glib.h>

#include "../cases.hpp"
#include "../draws.hpp"
#include "../failures.hpp"
#include "../rows_of_calls.hpp"
#include "../threads.hpp"
#include "batch_data.hpp"

using namespace pw85_tests;

namespace {

/// Makes the rows of an input unlike: most numbers are scaled, some get another sign, few are NaN.
/// Forms and separations stay as the pairs have them.
void scatter(Random &random, Call &call, std::size_t k)
{
    Parameter const &p = call.parameter(k);
    std::string const name = p.name;
    bool const of_pairs = name[0] == 'q' && name != "quaternions";
    if (!p.pointer || p.output || p.type != Type::real || of_pairs || name == "r12") return;
    for (std::size_t i = 0; i < call.length(k); ++i) {
        double const kind = random.uniform(0.0, 1.0);
        double &x = call.elements<double>(k)[i];
        x *= random.uniform(0.5, 1.5);
        if (name != "lambda" && kind < 0.2) x = -x;
        if (name == "lambda" && kind < 0.02) x += 2.0;
        if (kind > 0.99) x = std::numeric_limits<double>::quiet_NaN();
    }
}

void check_rows(Failures &failures, Function const &one, Call &many, std::size_t n)
{
    int const status = many().status;
    int first_bad = 0;
    for (std::size_t row = 0; row < n; ++row) {
        OneRow const expected = call_one(one, many, row);
        if (first_bad == 0) first_bad = expected.status;
        failures.check(are_same(outputs_of(many, row), expected.out), many.function().name,
                       expected.status, 0.0, [&] { return "row " + std::to_string(row); });
    }
    failures.check(status == first_bad, "status", status, first_bad,
                   [&] { return std::string(many.function().name); });
}

/// The same bytes, and the same status, from one thread and from several.
void check_threads(Failures &failures, Call &many)
{
    Threads const first(1);
    int const status = many().status;
    auto const bytes = many.outputs();
    Threads const used(4);
    bool const same = many().status == status && many.outputs() == bytes;
    failures.check(same, "threads", 4.0, 1.0, [&] { return std::string(many.function().name); });
}

PW85_TEST("/rows/one_by_one")
{
    Failures failures;
    Random random(900);
    // more than a thread takes at a time
    std::size_t const n = static_cast<std::size_t>(draws(5000));
    auto const pairs = mixed_pairs(random, n);
    int functions = 0;
    for (Function const &function : declared_functions()) {
        Function const *const one = of_one_row(function);
        if (one == nullptr) continue;
        ++functions;
        Call many(function, pairs);
        for (std::size_t k = 0; k < many.size(); ++k) scatter(random, many, k);
        check_rows(failures, *one, many, n);
        check_threads(failures, many);
    }
    g_assert_cmpint(functions, >=, 22);
}

} // namespace
