// SPDX-License-Identifier: BSD-3-Clause
// Prints the distribution of the correct decimal digits of f in both forms, as CSV, over /F of the
// reference data without λ = 0 and 1, where f = 0. A row has the per cent of values with so many
// digits, floor(-log10(relative error)); the last row is for 16 or more.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include <pw85_legacy.h>

#include <reference_data.hpp>

using namespace pw85_tests;

namespace {

constexpr int num_bins = 17;

int correct_digits(double actual, double expected)
{
    double const error = std::fabs((actual - expected) / expected);
    if (error == 0.0) return num_bins - 1;
    if (!(error < 1.0)) return 0;
    return std::min(num_bins - 1, static_cast<int>(-std::log10(error)));
}

struct Histograms {
    long factorised[num_bins] = {}, rational[num_bins] = {};
    long total = 0;

    void add(Sample<double, 3> const &p, double lambda, double expected)
    {
        double const *r12 = p.r12.coordinates, *q1 = p.q1.entries, *q2 = p.q2.entries;
        double params[PW85_DIM + 2 * PW85_SYM];
        std::copy_n(r12, 3, params);
        std::copy_n(q1, 6, params + 3);
        std::copy_n(q2, 6, params + 9);
        ++factorised[correct_digits(-pw85_f_neg(lambda, params), expected)];
        ++rational[correct_digits(pw85_legacy_f2(lambda, r12, q1, q2, nullptr), expected)];
        ++total;
    }
};

} // namespace

int main()
{
    auto const &grid = spheroid_grid();
    Histograms h;
    for (std::size_t i = 0; i < grid.spheroids.size(); ++i)
        for (std::size_t j = 0; j < grid.spheroids.size(); ++j)
            for (std::size_t k = 0; k < grid.directions.size(); ++k)
                for (std::size_t l = 1; l + 1 < grid.lambdas.size(); ++l)
                    h.add({grid.directions[k], grid.spheroids[i], grid.spheroids[j]},
                          grid.lambdas[l], grid.f_at(i, j, k, l));
    std::puts("correct_digits,percent_factorised,percent_rational");
    auto const percent = [&](long count) {
        return 100.0 * static_cast<double>(count) / static_cast<double>(h.total);
    };
    for (int i = 0; i < num_bins; ++i)
        std::printf("%d,%.4f,%.4f\n", i, percent(h.factorised[i]), percent(h.rational[i]));
    return 0;
}
