// SPDX-License-Identifier: BSD-3-Clause
// Tests of the templates of the core in float, double, long double and a wider type, in two and
// three dimensions. All have the same bound on the error, in units of the unit roundoff of the
// type.
#include <cmath>

#include <glib.h>

#include "draws.hpp"
#include "failures.hpp"
#include "random_pairs.hpp"
#include "wide.hpp"

using namespace pw85_tests;

namespace {

using Oracle = Multiprecision<100>;

/// Largest aspect ratio for which the rounded form surely is positive definite: its smallest
/// eigenvalue exceeds the rounding errors of its entries when aspect² u << 1.
template <class T> double largest_aspect()
{
    return std::fmin(1e6, std::sqrt(1e-3 / static_cast<double>(pw85::detail::unit_roundoff<T>())));
}

template <class T, int D> void test_contact()
{
    Failures failures;
    Random random(30 + D);
    int const count = std::is_floating_point_v<T> ? draws(10000) : draws(500);
    double worst = 0.0;
    int most = 0;
    for (int n = 0; n < count; ++n) {
        auto const p = convert<T>(random_pair<D>(
            random,
            {.aspect = largest_aspect<T>(), .size_ratio = 30.0, .mu2_min = 1e-3, .mu2_max = 1e3}));
        auto const c = pw85::contact(p.r12, p.q1, p.q2);
        auto const describe = [&] { return hex_text(p); };
        if (!failures.check(c.status == pw85::Status::success, "status",
                            static_cast<double>(c.status), 0.0, describe))
            continue;
        double const units = error_in_units(c.mu2, truth<Oracle>(p));
        failures.check(units <= 4.0, "error of mu^2 in u cond", units, 4.0, describe);
        int const evaluations =
            pw85::detail::maximize(
                pw85::detail::scale(pw85::detail::pair_of(p.r12, p.q1, p.q2)).pair)
                .evaluations;
        failures.check(evaluations <= pw85::detail::max_evaluations, "evaluations", evaluations,
                       pw85::detail::max_evaluations, describe);
        worst = std::fmax(worst, units);
        most = evaluations > most ? evaluations : most;
    }
    g_test_message("largest error %.2f u cond, at most %d evaluations", worst, most);
}

template <class T, int D> void test_closest_approach()
{
    Failures failures;
    Random random(40 + D);
    for (int n = 0; n < 300; ++n) {
        auto const p = convert<T>(random_pair<D>(random, {.aspect = 10.0}));
        auto const approach = pw85::closest_approach(p.r12, p.q1, p.q2);
        auto const exact = truth<Oracle>(p);
        Oracle norm2 = 0;
        for (int i = 0; i < D; ++i) norm2 += Oracle(p.r12[i]) * Oracle(p.r12[i]);
        Oracle const distance = sqrt(Oracle(norm2 / exact.mu2));
        Oracle const error = abs(Oracle(Oracle(approach.distance) - distance)) / distance;
        double const units = static_cast<double>(
            Oracle(error / (Oracle(pw85::detail::unit_roundoff<T>()) * exact.cond)));
        // Half of the 5 u cond of μ² (its own, and that of the normalised direction), and the norm.
        failures.check(units <= 4.0, "error of distance in u cond", units, 4.0,
                       [&] { return hex_text(p); });
    }
}

/// λ of a pair to the last digit of T.
template <class T, int D> T exact_lambda(Sample<T, D> const &p)
{
    return static_cast<T>(truth<Oracle>(p).lambda);
}

// The last step x of the iteration, of at most f = final_step(), is right to third order, with h'
// and h'' from before a step of at most p = penultimate_step(). With h = log(μ2/μ1), |h''| <= 2h'
// and |h'''| <= 4h' (differentiate the averages of the theory chapter once more), h' is off by 3p²
// of itself and h'' by 4p h', and log τ by 3p²f + 2pf² + 3f³ and by rounding.
template <class T, int D> void test_lambda()
{
    Failures failures;
    Random random(60 + D);
    double const u = static_cast<double>(pw85::detail::unit_roundoff<T>());
    double const last = static_cast<double>(pw85::detail::final_step<T>());
    double const previous = static_cast<double>(pw85::detail::penultimate_step<T>());
    for (int n = 0; n < draws(1000); ++n) {
        auto const p = convert<T>(random_pair<D>(random, {.aspect = 4.0}));
        T const lambda = pw85::contact(p.r12, p.q1, p.q2).lambda, exact = exact_lambda(p);
        double const error = static_cast<double>(T((lambda - exact) / (exact * (T(1) - exact))));
        // The slope is at least 1/16 and the blend's condition number at most 16.
        double const bound = 4.0 * (last * last + previous * previous) * last + 1024 * u;
        failures.check(std::fabs(error) <= bound, "error of log tau", error, bound,
                       [&] { return hex_text(p); });
    }
}

// The contact point is on both scaled ellipsoids, and the normal points from 1 to 2.
template <class T, int D> void test_geometry()
{
    Failures failures;
    Random random(50 + D);
    double const u = static_cast<double>(pw85::detail::unit_roundoff<T>());
    for (int n = 0; n < 300; ++n) {
        auto const p = convert<T>(random_pair<D>(random, {.aspect = 4.0}));
        auto const c = pw85::contact(p.r12, p.q1, p.q2);
        auto const g = pw85::contact_geometry(p.r12, p.q1, p.q2, exact_lambda(p));
        auto const describe = [&] { return hex_text(p); };
        auto const check_on_scaled = [&](pw85::SymmetricMatrix<T, D> const &q,
                                         pw85::Vector<T, D> const &x) {
            T const value = pw85::dot(x, pw85::cholesky_solve(pw85::cholesky(q), x));
            double const error = std::fabs(static_cast<double>(T(value / c.mu2 - T(1))));
            // Solutions err by the condition numbers of q and of the blend, 16 each, times a few u.
            failures.check(error <= 1024 * u, "point on the scaled ellipsoid", error, 1024 * u,
                           describe);
        };
        pw85::Vector<T, D> from2{};
        for (int i = 0; i < D; ++i) from2[i] = g.point[i] - p.r12[i];
        check_on_scaled(p.q1, g.point);
        check_on_scaled(p.q2, from2);
        double const norm = std::fabs(static_cast<double>(T(pw85::dot(g.normal, g.normal) - T(1))));
        failures.check(norm <= 16 * u, "norm of the normal", norm, 16 * u, describe);
        double const side = static_cast<double>(pw85::dot(g.normal, p.r12));
        failures.check(side > 0.0, "normal points to ellipsoid 2", side, 0.0, describe);
    }
}

template <class T, int D> void add(std::string const &type)
{
    std::string const prefix = "/scalars/" + type + "/" + std::to_string(D) + "d/";
    g_test_add_func((prefix + "contact").c_str(), test_contact<T, D>);
    g_test_add_func((prefix + "closest_approach").c_str(), test_closest_approach<T, D>);
    g_test_add_func((prefix + "lambda").c_str(), test_lambda<T, D>);
    g_test_add_func((prefix + "geometry").c_str(), test_geometry<T, D>);
}

template <class T> void add_both(std::string const &type)
{
    add<T, 2>(type);
    add<T, 3>(type);
}

} // namespace

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, nullptr);
    add_both<float>("float");
    add_both<double>("double");
    add_both<long double>("long_double");
    add_both<Wide>("wide");
    return g_test_run();
}
