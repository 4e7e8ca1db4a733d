// SPDX-License-Identifier: BSD-3-Clause
// The contact point, the normal and the derivatives of ellipsoids that are given by factors of
// their forms, against 200 digits.
#include <algorithm>
#include <cmath>
#include <vector>

#include <glib.h>

#include <pw85.h>
#include <pw85/pw85.hpp>

#include "cases.hpp"
#include "draws.hpp"
#include "factors.hpp"
#include "failures.hpp"

using namespace pw85_tests;
using pw85::detail::times_power_of_two;

namespace {

/// The numbers of a pair: r12, S1 and S2.
std::vector<TruthOfFactors> numbers_of(Factors<double, 3> const &p)
{
    std::vector<TruthOfFactors> all(p.r12.coordinates, p.r12.coordinates + 3);
    all.insert(all.end(), p.s1.entries, p.s1.entries + 9);
    all.insert(all.end(), p.s2.entries, p.s2.entries + 9);
    return all;
}

/// The pair of the exact products.
Sample<TruthOfFactors, 3> forms_of(std::vector<TruthOfFactors> const &numbers)
{
    Sample<TruthOfFactors, 3> w{};
    for (int i = 0; i < 3; ++i) {
        w.r12[i] = numbers[static_cast<std::size_t>(i)];
        for (int j = i; j < 3; ++j)
            for (int k = 0; k < 3; ++k) {
                auto const s = [&](int offset, int row) {
                    return numbers[static_cast<std::size_t>(offset + 3 * row + k)];
                };
                w.q1(i, j) += s(3, i) * s(3, j);
                w.q2(i, j) += s(12, i) * s(12, j);
            }
    }
    return w;
}

/// The results one after the other: point, normal, and the derivatives with respect to r12, S1 and
/// S2.
constexpr int starts[] = {0, 3, 6, 9, 18, 27};
char const *const names[] = {"point", "normal", "d_r12", "d_s1", "d_s2"};

/// The results by the definitions, from n = [(1-λ) Q1 + λ Q2]⁻¹ r12.
std::vector<TruthOfFactors> exact_results(std::vector<TruthOfFactors> const &numbers,
                                          TruthOfFactors const &lambda)
{
    auto const w = forms_of(numbers);
    TruthOfFactors const complement = 1 - lambda;
    pw85::SymmetricMatrix<TruthOfFactors, 3> m{};
    for (int k = 0; k < m.size; ++k) m[k] = complement * w.q1[k] + lambda * w.q2[k];
    auto const n = pw85::detail::solve(pw85::detail::factorize(m, TruthOfFactors(0)), w.r12);
    auto const point = pw85::product(w.q1, n);
    std::vector<TruthOfFactors> all;
    for (int i = 0; i < 3; ++i) all.push_back(complement * point[i]);
    for (int i = 0; i < 3; ++i) all.push_back(n[i] / sqrt(pw85::dot(n, n)));
    for (int i = 0; i < 3; ++i) all.push_back(2 * lambda * complement * n[i]);
    for (int const offset : {3, 12})
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                TruthOfFactors along = 0;
                for (int k = 0; k < 3; ++k)
                    along += n[k] * numbers[static_cast<std::size_t>(offset + 3 * k + j)];
                all.push_back(-2 * lambda * complement * (offset == 3 ? complement : lambda) *
                              n[i] * along);
            }
    return all;
}

/// The largest magnitude in the column of a number, if it belongs to a factor; the magnitude of the
/// number itself, if it belongs to r12.
TruthOfFactors unit_of(std::vector<TruthOfFactors> const &numbers, std::size_t k)
{
    if (k < 3) return abs(numbers[k]);
    std::size_t const first = k < 12 ? 3 : 12, column = first + (k - first) % 3;
    TruthOfFactors largest = 0;
    for (std::size_t i = column; i < first + 9; i += 3)
        largest = std::max(largest, TruthOfFactors(abs(numbers[i])));
    return largest;
}

/// By how much each result changes at most if each number changes by its unit, to first order.
std::vector<TruthOfFactors> sensitivities(std::vector<TruthOfFactors> const &numbers,
                                          TruthOfFactors const &lambda)
{
    auto const at = exact_results(numbers, lambda);
    TruthOfFactors const fraction("1e-40");
    std::vector<TruthOfFactors> sum(at.size(), TruthOfFactors(0));
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        auto changed = numbers;
        changed[k] += fraction * unit_of(numbers, k);
        auto const other = exact_results(changed, lambda);
        for (std::size_t i = 0; i < at.size(); ++i)
            sum[i] += abs(TruthOfFactors(other[i] - at[i])) / fraction;
    }
    return sum;
}

struct Results {
    double point[3], normal[3], d_r12[3], d_s1[9], d_s2[9];
};

Results compute(Factors<double, 3> const &p, double lambda)
{
    Results r{};
    g_assert_cmpint(pw85_contact_geometry_factored(p.r12.coordinates, p.s1.entries, p.s2.entries,
                                                   lambda, r.point, r.normal),
                    ==, PW85_SUCCESS);
    g_assert_cmpint(pw85_contact_gradient_factored(p.r12.coordinates, p.s1.entries, p.s2.entries,
                                                   lambda, r.d_r12, r.d_s1, r.d_s2),
                    ==, PW85_SUCCESS);
    return r;
}

std::vector<double> list(Results const &r)
{
    std::vector<double> all(r.point, r.point + 3);
    for (auto const &[first, count] :
         {std::pair{r.normal, 3}, {r.d_r12, 3}, {r.d_s1, 9}, {r.d_s2, 9}})
        all.insert(all.end(), first, first + count);
    return all;
}

/// The largest error of a result among its numbers, in units of u times the largest sensitivity.
double error_of(int result, std::vector<double> const &actual,
                std::vector<TruthOfFactors> const &exact, std::vector<TruthOfFactors> const &change)
{
    TruthOfFactors error = 0, largest = 0;
    for (int i = starts[result]; i < starts[result + 1]; ++i) {
        auto const k = static_cast<std::size_t>(i);
        error = std::max(error, TruthOfFactors(abs(TruthOfFactors(actual[k] - exact[k]))));
        largest = std::max(largest, change[k]);
    }
    return static_cast<double>(TruthOfFactors(error / largest)) * 0x1p53;
}

void check(Factors<double, 3> const &p, double lambda, double bound, Failures &failures,
           double (&worst)[5])
{
    auto const numbers = numbers_of(p);
    auto const actual = list(compute(p, lambda));
    auto const exact = exact_results(numbers, lambda), change = sensitivities(numbers, lambda);
    for (int result = 0; result < 5; ++result) {
        double const error = error_of(result, actual, exact, change);
        worst[result] = std::max(worst[result], error);
        failures.check(error <= bound, names[result], error, bound, [&] {
            return hex_text(p) + ", lambda = " + pw85_tests::hex_text(&lambda, 1);
        });
    }
}

/// The error of each result is at most 4 u times the change that units of the data can cause, for
/// factors of all kinds, aspect ratios to 1e10 and sizes to 2^±40.
PW85_TEST("/factored_geometry/error")
{
    Failures failures;
    Random random(70);
    double worst[5] = {};
    for (int n = 0; n < draws(400); ++n) {
        double const aspect = random.log_uniform(1.0, n % 4 == 1 ? 1e5 : 1e10);
        auto const p = random_factors(random, n % 4, aspect, random.log_uniform(0x1p-40, 0x1p40));
        double const lambda = n % 3 == 0 ? random.uniform(0.0, 1.0)
                                         : pw85::contact_factored(p.r12, p.s1, p.s2).lambda;
        check(p, lambda, 4.0, failures, worst);
    }
    for (int i = 0; i < 5; ++i) g_test_message("%s: largest error %.2f", names[i], worst[i]);
}

/// The derivatives against differences of μ² in 200 digits.
PW85_TEST("/factored_geometry/differences")
{
    Failures failures;
    Random random(71);
    for (int n = 0; n < draws(200); ++n) {
        auto const p = random_factors(random, n % 4, random.log_uniform(1.0, 100.0),
                                      random.log_uniform(0.1, 10.0));
        auto const actual = list(compute(p, pw85::contact_factored(p.r12, p.s1, p.s2).lambda));
        auto const numbers = numbers_of(p);
        TruthOfFactors const h("1e-30");
        TruthOfFactors expected = 0, sum = 0, magnitudes = 0;
        auto up = numbers, down = numbers;
        for (std::size_t k = 0; k < numbers.size(); ++k) {
            TruthOfFactors const change = random.normal() * numbers[k],
                                 term = change * actual[6 + k];
            up[k] += h * change;
            down[k] -= h * change;
            sum += term;
            magnitudes += abs(term);
        }
        auto const mu2 = [](std::vector<TruthOfFactors> const &x) {
            auto const w = forms_of(x);
            return pw85::contact(w.r12, w.q1, w.q2).mu2;
        };
        expected = (mu2(up) - mu2(down)) / (2 * h);
        double const error =
            static_cast<double>(TruthOfFactors(abs(TruthOfFactors(sum - expected)) / magnitudes));
        failures.check(error <= 1e-9, "derivative along a direction", error, 1e-9,
                       [&] { return hex_text(p); });
    }
}

/// Exchanging the ellipsoids, and powers of two: the results follow by their dimensions, for all
/// sizes that keep them in range.
PW85_TEST("/factored_geometry/symmetry")
{
    Failures failures;
    Random random(72);
    for (int n = 0; n < draws(1000); ++n) {
        auto const p = random_factors(random, n % 4, 100.0, 1.0);
        double const lambda = n % 2 == 0 ? 0.5 : 0.25;
        auto const expected = compute(p, lambda);
        int const e = n % 5 == 0 ? 40 : n % 5 == 1 ? -40 : n % 5 == 2 ? 400 : n % 5 == 3 ? -400 : 0;
        auto const size = [e](auto const &x) { return times_power_of_two(x, e); };
        auto const actual = compute({size(p.r12), size(p.s1), size(p.s2)}, lambda);
        auto const other = compute({-p.r12, p.s2, p.s1}, 1.0 - lambda);
        auto const same = [&](double const *x, double const *y, int count, int power,
                              char const *what) {
            for (int i = 0; i < count; ++i)
                failures.check(x[i] == times_power_of_two(y[i], power * e), what, x[i], y[i],
                               [&] { return hex_text(p) + ", exponent " + std::to_string(e); });
        };
        same(actual.point, expected.point, 3, 1, "scaled point");
        same(actual.normal, expected.normal, 3, 0, "scaled normal");
        same(actual.d_r12, expected.d_r12, 3, -1, "scaled d_r12");
        same(actual.d_s1, expected.d_s1, 9, -1, "scaled d_s1");
        same(actual.d_s2, expected.d_s2, 9, -1, "scaled d_s2");
        double const tolerance = 1e-12; // the order of sums differs
        auto const near = [&](double const *x, double const *y, int count, double sign,
                              char const *what) {
            double largest = 0.0, error = 0.0;
            for (int i = 0; i < count; ++i) {
                largest = std::max(largest, std::fabs(y[i]));
                error = std::max(error, std::fabs(x[i] - sign * y[i]));
            }
            failures.check(error <= tolerance * largest, what, error, tolerance * largest,
                           [&] { return hex_text(p); });
        };
        near(other.normal, expected.normal, 3, -1.0, "swapped normal");
        near(other.d_r12, expected.d_r12, 3, -1.0, "swapped d_r12");
        near(other.d_s1, expected.d_s2, 9, 1.0, "swapped d_s1");
        near(other.d_s2, expected.d_s1, 9, 1.0, "swapped d_s2");
    }
}

/// Ellipsoids of very different sizes, in either order, so that the library exchanges them: against
/// 200 digits.
PW85_TEST("/factored_geometry/unlike")
{
    Failures failures;
    Random random(73);
    double worst[5] = {};
    for (int n = 0; n < draws(200); ++n) {
        auto p = random_factors(random, n % 4, 100.0, 1.0);
        int const e = static_cast<int>(random.uniform(-100.0, 100.0));
        (n % 2 == 0 ? p.s1 : p.s2) = times_power_of_two(n % 2 == 0 ? p.s1 : p.s2, e);
        check(p, random.uniform(0.0, 1.0), 4.0, failures, worst);
        check({-p.r12, p.s2, p.s1}, random.uniform(0.0, 1.0), 4.0, failures, worst);
    }
}

PW85_TEST("/factored_geometry/status")
{
    double const s[9] = {1.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 3.0}, r12[3] = {1.0, 2.0, 3.0},
                 zero[3] = {};
    double const parallel[9] = {1.0, 1.0, 0.0, 2.0, 2.0, 0.0, 0.0, 0.0, 3.0};
    auto const check_both = [&](double const *r, double const *s1, double const *s2, double lambda,
                                int geometry, int gradient) {
        double out[30];
        std::fill(out, out + 30, 7.0);
        g_assert_cmpint(pw85_contact_geometry_factored(r, s1, s2, lambda, out, out + 3), ==,
                        geometry);
        for (int i = 0; i < 6; ++i) g_assert_true(std::isnan(out[i]) == (geometry != PW85_SUCCESS));
        g_assert_cmpint(pw85_contact_gradient_factored(r, s1, s2, lambda, out, out + 3, out + 12),
                        ==, gradient);
        for (int i = 0; i < 21; ++i)
            g_assert_true(std::isnan(out[i]) == (gradient != PW85_SUCCESS));
    };
    check_both(r12, s, s, 0.5, PW85_SUCCESS, PW85_SUCCESS);
    check_both(r12, s, s, 0.0, PW85_SUCCESS, PW85_SUCCESS);
    check_both(r12, s, s, 1.0, PW85_SUCCESS, PW85_SUCCESS);
    check_both(zero, s, s, 0.5, PW85_EINVAL, PW85_SUCCESS);
    for (double const lambda : {-0.1, 1.1, std::nan("")})
        check_both(r12, s, s, lambda, PW85_EINVAL, PW85_EINVAL);
    check_both(r12, parallel, s, 0.5, PW85_ENOTPD, PW85_ENOTPD);
    check_both(r12, s, parallel, 0.5, PW85_ENOTPD, PW85_ENOTPD);
}

} // namespace
