#include "gsl_brent.hpp"

#include <cmath>
#include <cstddef>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_min.h>

namespace pw85::brent {

namespace {

// The pair with t = unit·x/(1-x): x is the λ of the forms Q1 and unit·Q2, which are of like size where it matters, so
// that an absolute tolerance on x means what it says. `odds` = ratio²·unit takes x/(1-x) to τ = λ/(1-λ).
struct Problem {
    Pair<double, 3> pair;
    SymmetricMatrix<double, 3> q2;
    double unit;
    double odds;
};

Problem make_problem(Pair<double, 3> const &pair, double unit) noexcept
{
    return {pair, blend(unit, pair.q2, 0.0, pair.q2), unit, pair.ratio * (pair.ratio * unit)};
}

// -f at x, over its limit for large odds: finite and non-positive in [0, 1], zero at the ends only.
double objective(double x, void *data) noexcept
{
    auto const &p = *static_cast<Problem const *>(data);
    double const f = evaluate_f(x, p.pair.r12, p.pair.q1, p.q2);
    return -f / (x + (1 - x) / p.odds);
}

// The minimiser of the objective to within lambda_atol, in at most max_iterations. GSL reports errors through a
// process-wide handler that aborts by default; none can arise: the end points enclose a minimum and all values are
// finite.
double minimize(Problem &problem, Options const &options) noexcept
{
    gsl_function function{objective, &problem};
    alignas(std::max_align_t) unsigned char state[256];
    gsl_min_fminimizer minimizer{};
    minimizer.type = gsl_min_fminimizer_brent;
    minimizer.state = state;
    double const middle = objective(0.5, &problem);
    if (minimizer.type->size > sizeof state || !(middle < 0.0)) return 0.5;
    gsl_min_fminimizer_set_with_values(&minimizer, &function, 0.5, middle, 0.0, 0.0, 1.0, 0.0);
    for (int i = 0; i < options.max_iterations; ++i) {
        gsl_min_fminimizer_iterate(&minimizer);
        if (minimizer.x_upper - minimizer.x_lower < options.lambda_atol) break;
    }
    return minimizer.x_minimum;
}

// The maximiser by Brent's method, with units chosen anew until it is not near an end.
double maximizer_by_brent(Pair<double, 3> const &pair, Options const &options) noexcept
{
    constexpr int max_rounds = 8;
    constexpr double margin = 0x1p-8;
    double unit = times_power_of_two(1.0, binary_exponent(initial_guess(pair))), x = 0.5;
    for (int round = 0; round < max_rounds; ++round) {
        Problem problem = make_problem(pair, unit);
        x = minimize(problem, options);
        double const t = unit * (x / (1.0 - x));
        if (x > margin && x < 1.0 - margin) return t;
        unit = times_power_of_two(1.0, binary_exponent(t));
    }
    return unit;
}

// Newton-Raphson iterations on the residual in logarithmic form, h = log(μ2/μ1) as a function of log t: it has the root
// of μ2² - μ1² and is linear for ellipsoids of very different sizes, where f is flat. Then the value of f where they
// end.
Maximum<double> refine(Pair<double, 3> const &pair, double t, Options const &options) noexcept
{
    Candidate<double> candidate{t, 1.0, 0.0};
    for (int i = 0;; ++i) {
        auto const factors = factorize_blend(1.0, pair.q1, candidate.t, pair.q2);
        Jet<double> const jet = evaluate_jet(pair, factors, solve(factors, pair.r12));
        Slope<double> const s = slope(jet, pair.ratio, candidate.t);
        candidate.k = s.k / s.weight;
        if (i == options.newton_iterations) break;
        double const h = std::log(pair.ratio * candidate.t * std::sqrt(jet.b / jet.a));
        candidate.t *= std::exp(-h / candidate.k);
    }
    auto const last = last_evaluation(pair, candidate, Precision::working);
    if (!last.certain) return maximize_factorized(pair, candidate, 0);
    return to_maximum(last.value, 0, true);
}

} // namespace

Contact<double> contact_function(Vector<double, 3> const &r12, SymmetricMatrix<double, 3> const &q1,
                                 SymmetricMatrix<double, 3> const &q2, Options const &options) noexcept
{
    ScaledPair<double, 3> scaled;
    Status const status = validate(r12, q1, q2, scaled);
    if (status != Status::success) return failed_contact<double>(status);
    if (largest_coordinate(r12) == 0.0) return {0.0, 0.5, Status::success};
    return unscale(scaled, refine(scaled.pair, maximizer_by_brent(scaled.pair, options), options));
}

} // namespace pw85::brent
