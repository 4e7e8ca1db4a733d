// SPDX-License-Identifier: BSD-3-Clause
// The contact function by Brent's method (brent.hpp): the method finds a candidate, and the search
// on the factorised form refines it. contact_function.cpp calls contact_function(), which calls
// minimize() of brent_gsl.cpp or brent_boost.cpp.
#include "brent.hpp"

#include "brent_minimizer.hpp"

namespace pw85::detail::brent {

namespace {

// A pair in the variable x with t = unit·x/(1-x). x is the λ of the forms Q1 and unit·Q2. These are
// of similar size near the maximum. So x is not near 0 or 1 there, and an absolute tolerance on x
// is meaningful. `odds` = ratio²·unit converts x/(1-x) to τ = λ/(1-λ).
struct PairInUnit {
    Vector<double, 3> r12;
    SymmetricMatrix<double, 3> q1, q2;
    double odds_against; // 1/odds
};

PairInUnit in_unit(Pair<double, 3> const &pair, double unit) noexcept
{
    return {pair.r12, pair.q1, unit * pair.q2, 1.0 / (pair.ratio * (pair.ratio * unit))};
}

// Computes -f at x, in a form that stays in range for large odds. The result is finite and
// non-positive in [0, 1], and zero only at the ends.
double objective(double x, void *data) noexcept
{
    auto const &p = *static_cast<PairInUnit const *>(data);
    return -evaluate_f(x, p.r12, p.q1, p.q2) / (x + (1.0 - x) * p.odds_against);
}

Maximum<double> maximize(Pair<double, 3> const &pair, Options const &options) noexcept
{
    Candidate<double> candidate{maximizer_by_brent(pair, options).t, 1.0, 0.0};
    bool const converged = refine(pair, candidate, options);
    auto const last = last_factorized_evaluation(pair, candidate, Precision::working);
    return converged && last.certified ? to_maximum(last, 0, true)
                                       : maximize_factorized(pair, candidate, 0);
}

} // namespace

// A unit is good if x ends far from 0 and 1. Then lambda_atol, 1e-6, is a tolerance of
// lambda_atol/margin = 2.6e-4 on log t. If t is off by a factor less than 1/lambda_atol, the next
// round, with t as its unit, finds it. Pairs of general ellipsoids need at most 1 round at aspect
// ratio 10, 2 at 1e6 and 3 at any aspect ratio (tests/test_brent.cpp).
BrentResult maximizer_by_brent(Pair<double, 3> const &pair, Options const &options) noexcept
{
    constexpr int max_rounds = 3;
    constexpr double margin = 0x1p-8;
    double unit = unit_of(initial_guess(pair)).as<double>();
    for (int round = 1;; ++round) {
        PairInUnit in = in_unit(pair, unit);
        double const x = minimize({objective, &in}, options), t = unit * (x / (1.0 - x));
        if ((x > margin && x < 1.0 - margin) || round == max_rounds) return {t, round};
        unit = unit_of(t).as<double>();
    }
}

bool refine(Pair<double, 3> const &pair, Candidate<double> &candidate,
            Options const &options) noexcept
{
    int evaluations = 0;
    return search_in_steps(pair, candidate, Precision::working, evaluations, options.halley_steps);
}

Contact<double> contact_function(Vector<double, 3> const &r12, SymmetricMatrix<double, 3> const &q1,
                                 SymmetricMatrix<double, 3> const &q2,
                                 Options const &options) noexcept
{
    auto const pair = pair_of(r12, q1, q2);
    if (passes_fast_checks(pair)) return to_contact(maximize(pair, options));
    ScaledPair<double, 3> scaled;
    Status const status = validate_pair(pair, scaled);
    if (status != Status::success) return all_nan<Contact<double>>(status);
    if (largest_coordinate(r12) == 0.0) return {0.0, 0.5, Status::success};
    return unscale(scaled, maximize(scaled.pair, options));
}

} // namespace pw85::detail::brent
