// SPDX-License-Identifier: BSD-3-Clause
// Runs a random search for pairs on which a function exceeds its bound, and tests the reference of
// this search.

#include "cases.hpp"
#include "draws.hpp"
#include "failures.hpp"
#include "reference_data.hpp"
#include "worst_pairs.hpp"

using namespace pw85_tests;

namespace {

// The judge, which is the core itself in a wide type, against the reference data: it is off by
// their rounding only.
PW85_TEST("/worst_pairs/truth")
{
    Failures failures;
    for (auto const &p : contact_problems()) {
        auto const exact = truth<Wide>(p.pair);
        auto const check = [&](char const *what, Wide const &actual, double expected) {
            double const error = static_cast<double>(Wide(abs(Wide(actual - expected))));
            failures.check(error <= 0x1p-53 * std::fabs(expected), what, error,
                           0x1p-53 * std::fabs(expected),
                           [&] { return *p.category + ": " + hex_text(p.pair); });
        };
        check("mu^2", exact.mu2, p.mu2);
        check("lambda", exact.lambda, p.lambda);
        check("cond", exact.cond, p.cond);
        if (p.mu2_minus_1 != 0.0) check("mu^2 - 1", Wide(exact.mu2 - 1), p.mu2_minus_1);
    }
}

PW85_TEST("/worst_pairs/bounds")
{
    Failures failures;
    for (double aspect = 1.0; aspect < 1e6; aspect *= 10.0) {
        WorstPairs worst(aspect, 10.0 * aspect);
        worst.search(draws(4000));
        for (int f = 0; f < num_searched; ++f)
            for (auto const &found : worst.worst(f))
                failures.check(found.error <= bounds[static_cast<std::size_t>(f)], searched[f],
                               found.error, bounds[static_cast<std::size_t>(f)],
                               [&] { return hex_text(found.pair); });
    }
}

} // namespace
