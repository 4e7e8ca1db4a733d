// SPDX-License-Identifier: BSD-3-Clause
// Volumes and areas of common parts by the C functions, and checks of their contract.
#ifndef PW85_TESTS_COMMON_PART_CASES_HPP_INCLUDED
#define PW85_TESTS_COMMON_PART_CASES_HPP_INCLUDED

#include <cmath>

#include <glib.h>

#include <pw85.h>

#include "failures.hpp"
#include "random_pairs.hpp"
#include "wide.hpp"

namespace pw85_tests {

using FineMeasure = Multiprecision<20>;

inline FineMeasure measure(Sample<FineMeasure, 3> const &p)
{
    return pw85::overlap_volume(p.r12, p.q1, p.q2).volume;
}

inline FineMeasure measure(Sample<FineMeasure, 2> const &p)
{
    return pw85::overlap_area(p.r12, p.q1, p.q2).area;
}

template <int D> double measured(Sample<double, D> const &p)
{
    double found = 0.0;
    g_assert_cmpint((D == 3 ? pw85_overlap_volume : pw85_overlap_area_2d)(
                        p.r12.coordinates, p.q1.entries, p.q2.entries, &found),
                    ==, PW85_SUCCESS);
    return found;
}

template <int D> double whole(pw85::SymmetricMatrix<double, D> const &q)
{
    double found = 0.0;
    g_assert_cmpint((D == 3 ? pw85_volume : pw85_area_2d)(q.entries, &found), ==, PW85_SUCCESS);
    return found;
}

template <int D> double smaller_of(Sample<double, D> const &p)
{
    return std::fmin(whole(p.q1), whole(p.q2));
}

/// s of the contract: Σ|r_i ∂V/∂r_i| + Σ √(q_ii q_jj) |∂V/∂q_ij|, over the stored entries of both
/// forms, by the derivatives in 38 digits. It counts only by its size.
template <int D> double sensitivity(Sample<double, D> const &p)
{
    auto const exact = convert<FineMeasure>(p);
    auto const add = [&](auto const &d) {
        FineMeasure sum = 0;
        for (int i = 0; i < D; ++i) {
            sum += abs(exact.r12[i] * d.r12[i]);
            for (int j = i; j < D; ++j)
                sum += sqrt(FineMeasure(exact.q1(i, i) * exact.q1(j, j))) * abs(d.q1(i, j)) +
                       sqrt(FineMeasure(exact.q2(i, i) * exact.q2(j, j))) * abs(d.q2(i, j));
        }
        return static_cast<double>(sum);
    };
    if constexpr (D == 3)
        return add(pw85::overlap_volume_gradient(exact.r12, exact.q1, exact.q2));
    else
        return add(pw85::overlap_area_gradient(exact.r12, exact.q1, exact.q2));
}

/// Checks a value against the contract.
template <int D> void check_bound(Failures &failures, Sample<double, D> const &p, double actual,
                                  FineMeasure const &truth)
{
    constexpr double u = 0x1p-53;
    double const error = std::abs(static_cast<double>(FineMeasure(FineMeasure(actual) - truth)));
    double const smaller = smaller_of(p);
    if (error <= 64.0 * u * smaller) { // no need of the sensitivity
        failures.check(true, "error", error, error, [] { return std::string(); });
        return;
    }
    double const bound = u * (64.0 * smaller + 16.0 * sensitivity(p));
    failures.check(error <= bound, "error", error, bound, [&] { return hex_text(p); });
}

/// Checks that a measure is exactly 0 or that of a whole body where the exact decisions say so, in
/// any order of the two, also next to tangency.
template <int D> void check_decisions(unsigned seed, int count)
{
    Failures failures;
    Random random(seed);
    for (int n = 0; n < count; ++n) {
        PairOptions options{};
        auto p = random_pair<D>(random, options);
        if (n % 3 == 0) p.r12 = std::sqrt(1.0 / pw85::contact(p.r12, p.q1, p.q2).mu2) * p.r12;
        if (n % 3 == 1) { // next to internal tangency
            p.r12 = 0.01 * p.r12;
            double const scale = pw85::containment(p.r12, p.q1, p.q2).mu2 *
                                 (1.0 + random.uniform(-2.0, 2.0) * 0x1p-52);
            p.q1 = scale * p.q1;
        }
        bool const apart = !pw85::overlap(p.r12, p.q1, p.q2).overlap,
                   inside2 = pw85::contains(p.r12, p.q1, p.q2).contains,
                   inside1 = pw85::contains(-p.r12, p.q2, p.q1).contains;
        double const actual = measured(p), smaller = smaller_of(p);
        bool const fits = apart     ? actual == 0.0
                          : inside2 ? actual == whole(p.q2)
                          : inside1 ? actual == whole(p.q1)
                                    // 0: a lens of rounding errors
                                    : actual >= 0.0 && actual <= smaller;
        failures.check(fits, "measure", actual, smaller, [&] { return hex_text(p); });
        double const exchanged = measured(Sample<double, D>{-p.r12, p.q2, p.q1});
        failures.check(std::abs(exchanged - actual) <= 1e-13 * smaller, "exchanged", exchanged,
                       actual, [&] { return hex_text(p); });
    }
}

} // namespace pw85_tests

#endif
