// What is_certain() promises of a last evaluation: from the s that the scalar's arithmetic gives, but with exact sums, μ² errs by
// at most 3 u, wherever the search stopped.
#include <algorithm>

#include <glib.h>

#include "crossed_pairs.hpp"
#include "failures.hpp"
#include "wide.hpp"

using namespace pw85_tests;

namespace {

/// t and the exact h' and h'' there.
template <class T, int D> pw85::Candidate<Wide> candidate_at(Sample<T, D> const &s, T const &t)
{
    auto const w = convert<Wide>(s);
    pw85::Pair<Wide, D> const pair{w.r12, w.q1, w.q2, Wide(1)};
    auto const factors = pw85::factorize_blend(Wide(1), w.q1, Wide(t), w.q2);
    auto const slope = pw85::slope(pw85::evaluate_jet(pair, factors, pw85::solve(factors, w.r12)), Wide(1), Wide(t));
    return {Wide(t), slope.k / slope.weight, slope.k2 / (slope.weight * slope.weight)};
}

/// The error of μ² in u, from an inexact s with exact sums.
template <class T, int D> double error_of_value(Sample<T, D> const &sample, pw85::Candidate<Wide> const &candidate,
                                                pw85::Vector<T, D> const &inexact, Wide const &mu2)
{
    auto const w = convert<Wide>(sample);
    auto const s = convert<Wide>(inexact);
    auto const value = pw85::stationary_value(candidate, Wide(1), pw85::quadratic_form(w.q1, s),
                                              pw85::quadratic_form(w.q2, s), pw85::dot(w.r12, s));
    return static_cast<double>(Wide(pw85::absolute(Wide(value.mu2 - mu2)) / (mu2 * pw85::unit_roundoff<T>())));
}

/// Pairs of all kinds, and t from a rounding error to a tenth away from the root.
template <class T, int D> void test_certainty()
{
    Failures failures;
    Random random(120 + D);
    double worst[2] = {};
    for (int n = 0; n < 20000; ++n) {
        double const aspect = random.log_uniform(1.0, std::is_same_v<T, float> ? 1e3 : 1e7);
        auto const s = convert<T>(n % 2 == 0 ? crossed_pair<D>(random, aspect)
                                             : random_pair<D>(random, {.aspect = aspect, .size_ratio = 10.0}));
        if (!pw85::is_ordinary(s.r12, s.q1, s.q2)) continue;
        auto const w = convert<Wide>(s);
        auto const near = pw85::contact(convert<double>(s.r12), convert<double>(s.q1), convert<double>(s.q2));
        double const u = pw85::unit_roundoff<T>(), shift = random.log_uniform(u, 0.1);
        T const t = static_cast<T>(near.lambda / (1.0 - near.lambda) * (n % 4 < 2 ? 1.0 + shift : 1.0 - shift));
        auto const exact = candidate_at(s, t);
        pw85::Candidate<T> const candidate{t, static_cast<T>(exact.k), static_cast<T>(exact.k2)};
        pw85::Pair<T, D> const pair{s.r12, s.q1, s.q2, T(1)};
        auto const m = pw85::blend(s.q1, t, s.q2);
        bool const by_adjugate = pw85::last_evaluation(pair, candidate).certain;
        bool const by_factors = pw85::last_evaluation(pair, candidate, pw85::Precision::working).certain;
        if (!by_adjugate && !by_factors) continue;
        Wide const mu2 = pw85::contact(w.r12, w.q1, w.q2).mu2;
        auto const check = [&](bool certain, pw85::Vector<T, D> const &inexact, char const *name, double &largest) {
            if (!certain) return;
            double const error = error_of_value(s, exact, inexact, mu2);
            largest = std::max(largest, error);
            failures.check(error <= 3.0, name, error, 3.0, [&] { return hex_text(s) + ", t = " + hex_text(&t, 1); });
        };
        check(by_adjugate, pw85::solve_by_adjugate(m, s.r12).s, "adjugate", worst[0]);
        check(by_factors, pw85::solve(pw85::factorize(m, static_cast<T>(u)), s.r12), "factorised", worst[1]);
    }
    g_test_message("%ld certain, at most %.2f u by the adjugate and %.2f u by factorisation", failures.checked(),
                   worst[0], worst[1]);
    g_assert_cmpint(failures.checked(), >, 2000);
}

} // namespace

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, nullptr);
    g_test_add_func("/certainty/float/2", (test_certainty<float, 2>));
    g_test_add_func("/certainty/float/3", (test_certainty<float, 3>));
    g_test_add_func("/certainty/double/2", (test_certainty<double, 2>));
    g_test_add_func("/certainty/double/3", (test_certainty<double, 3>));
    return g_test_run();
}
