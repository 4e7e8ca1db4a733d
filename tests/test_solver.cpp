// SPDX-License-Identifier: BSD-3-Clause
// Tests of the solver on the pairs that are most difficult for it: the bound on its evaluations,
// and the accuracy of its result.
#include <algorithm>
#include <cmath>

#include <glib.h>

#include <pw85.h>

#include "draws.hpp"
#include "extreme_pairs.hpp"
#include "failures.hpp"
#include "wide.hpp"

using namespace pw85_tests;

namespace {

/// Searches for a root by a method that stays where it is: behind the first look, all steps are
/// probes, and bisections that halve the range of the exponents, 2^14.5 at most in log t, down to 4
/// u.
template <class T> void search_without_method(Failures &failures, T const &root, T const &start)
{
    using namespace pw85::detail;
    T const width = T(4) * unit_roundoff<T>();
    constexpr int most = 1 + max_probes<T>() + 13 + mantissa_digits<T>();
    auto search = safeguarded_search(start, 0);
    int steps = 0;
    for (; !is_narrow(search, width) && steps <= most; ++steps) {
        take_bound(search, root > search.t, search.t);
        take_step(search, search.t, T(2));
    }
    auto const describe = [&] {
        return "log10 of root and start: " + std::to_string(std::log10(root)) + ", " +
               std::to_string(std::log10(start));
    };
    failures.check(steps <= most, "steps", steps, most, describe);
    failures.check(search.lower <= root && root <= search.upper, "the root is in the bracket", 0.0,
                   0.0, describe);
}

template <class T> void search_whole_range(Failures &failures)
{
    T const smallest = pw85::detail::smallest_number<T>(),
            largest = pw85::detail::largest_number<T>();
    T const places[] = {smallest, T(3) * smallest, T(1e-30),       T(0.7),
                        T(1),     T(1e30),         largest / T(3), largest};
    for (T const &root : places)
        for (T const &start : places) search_without_method(failures, root, start);
}

void test_safeguarded_search()
{
    Failures failures;
    search_whole_range<float>(failures);
    search_whole_range<double>(failures);
    search_whole_range<long double>(failures);
}

/// A method that converges is left alone: as far as steps are free, and where they halve.
void test_safeguarded_steps()
{
    using namespace pw85::detail;
    auto search = safeguarded_search(1e3, 3);
    for (int i = 0; i < 30; ++i) {
        double const step = -0.6 * std::log(search.t), next = search.t * std::exp(step);
        take_bound(search, 1.0 > search.t, search.t);
        take_step(search, next, std::fabs(step));
        g_assert_cmpfloat(search.t, ==, next);
    }
    // A step that does not halve is not taken, once none is free.
    search = safeguarded_search(4.0, 1);
    take_bound(search, false, 4.0);
    take_step(search, 0.25, 1.5);
    g_assert_cmpfloat(search.t, ==, 0.25);
    take_bound(search, true, 0.25);
    take_step(search, 3.0, 0.8);
    g_assert_cmpfloat(search.t, ==, 1.0);
    // Nor one out of the bracket, which ends at its end.
    take_step(search, 100.0, 0.1);
    g_assert_cmpfloat(search.t, ==, 4.0);
}

void test_bound_on_evaluations()
{
    Failures failures;
    Random random(80);
    int most = 0;
    for (int n = 0; n < draws(500000); ++n) {
        auto const p = extreme_pair(random, n % 3);
        pw85::detail::ScaledPair<double, 3> scaled;
        if (pw85::detail::validate_pair(pw85::detail::pair_of(p.r12, p.q1, p.q2), scaled) !=
            pw85::Status::success)
            continue;
        auto const maximum = pw85::detail::maximize(scaled.pair);
        failures.check(maximum.converged && maximum.evaluations <= pw85::detail::max_evaluations,
                       "evaluations", maximum.evaluations, pw85::detail::max_evaluations,
                       [&] { return hex_text(p); });
        most = maximum.evaluations > most ? maximum.evaluations : most;
    }
    g_test_message("%ld pairs, at most %d evaluations", failures.checked(), most);
}

void test_extreme_shapes()
{
    Failures failures;
    Random random(81);
    for (int n = 0; n < draws(5000); ++n) {
        auto const p = extreme_pair(random, n % 3);
        double out[2];
        if (pw85_contact(p.r12.coordinates, p.q1.entries, p.q2.entries, out) != PW85_SUCCESS)
            continue;
        auto const exact = truth<Wide>(p);
        if (!(exact.mu2 > std::numeric_limits<double>::min() &&
              exact.mu2 < std::numeric_limits<double>::max()))
            continue;
        double const units = error_in_units(out[0], exact);
        failures.check(units <= 4.0, "error of mu^2 in u cond", units, 4.0,
                       [&] { return hex_text(p); });
    }
}

// Derivatives of such pairs may be infinite or zero; a product of both must not come out of it.
void test_derivatives_of_extreme_shapes()
{
    Failures failures;
    Random random(82);
    for (int n = 0; n < draws(50000); ++n) {
        auto p = extreme_pair(random, n % 3);
        p.r12 = pw85::detail::times_power_of_two(p.r12,
                                                 static_cast<int>(random.uniform(-700.0, 700.0)));
        p.q1 = pw85::detail::times_power_of_two(
            p.q1, 2 * static_cast<int>(random.uniform(-350.0, 350.0)));
        p.q2 = pw85::detail::times_power_of_two(
            p.q2, 2 * static_cast<int>(random.uniform(-350.0, 350.0)));
        double const *r12 = p.r12.coordinates, *q1 = p.q1.entries, *q2 = p.q2.entries;
        double contact[2], out[27];
        if (pw85_contact(r12, q1, q2, contact) != PW85_SUCCESS) continue;
        for (double const lambda : {contact[1], 0.0, 0x1p-1074, 1.0}) {
            int const status =
                pw85_contact_geometry(r12, q1, q2, lambda, out, out + 3) |
                pw85_contact_gradient(r12, q1, q2, lambda, out + 6, out + 9, out + 15) |
                pw85_contact_torque(r12, q1, q2, lambda, out + 21, out + 24);
            bool const any_nan = std::any_of(out, out + 27, [](double x) { return std::isnan(x); });
            failures.check(status == PW85_SUCCESS && !any_nan, "NaN, status", status, 0.0,
                           [&] { return hex_text(p) + ", lambda = " + hex_text(&lambda, 1); });
        }
    }
}

struct HardPair {
    char const *name;
    Sample<double, 3> pair;
};

HardPair const hard_pairs[] = {
    // The bracket is narrow before a point inside it was evaluated.
    {"narrow_bracket",
     {{0x1.ba708deba76fbp-6, 0x1.86e703d92e3f3p-4, 0x1.53cfd3d1df0c9p-5},
      {0x1.8af7e5c6f7dfp-7, -0x1.248a8702de56fp-5, 0x1.a5d728b13042bp-4, 0x1.b26d2c9b23c2ep-4,
       -0x1.391750c38c474p-2, 0x1.c391a875a15e1p-1},
      {0x1.8820676051e9fp+4, 0x1.144bffbb40f29p+7, 0x1.fd1bf3d0f227ep+4, 0x1.855d269d8b859p+9,
       0x1.66b96263af613p+7, 0x1.4a7edb7e1e361p+5}}},
    // h is below its rounding errors over 50 binades of t.
    {"flat",
     {{0x1.848484848p-859, 0x0.10a010000ffe4p-1022, 0x1.0abafa6a400f5p+437},
      {0x1.254b754866b31p-7, 0x1.254b7370124a1p-7, 0x1.254b7370124a1p-7, 0x1.254b71c82e548p-6,
       0x1.b49d6d40c20ebp+17, 0x1.44fc16b417b6cp+42},
      {0x1.254b71f89ec4fp-7, 0x1.254b71c82ea94p-7, 0x1.254b71c82e547p-7, 0x1.254b71c82ea94p-6,
       -0x1.79eb8d2cc0218p+4, 0x1.e754ffb677401p+15}}},
    // Halley's steps shrink slowly from afar: 0.96, 0.74, 0.17.
    {"slow_start",
     {{0x1.c0b4bbd640628p+0, 0x1.8c9472666f647p-2, -0x1.a63b977a7445cp-3},
      {0x1.da1b20485bc69p-5, 0x1.9b0b870c86b0ap-4, -0x1.50d2b616509f5p-1, 0x1.6475f6e95f702p-3,
       -0x1.2434ebf0a17fcp+0, 0x1.df599086aa21bp+2},
      {0x1.42364d081773fp+4, -0x1.989235ece7e32p+1, 0x1.fc7362c4cc395p+2, 0x1.4fab258f5e5bep+4,
       0x1.bddc2b6dfe647p+2, 0x1.9c19f6a8470a8p+2}}},
};

void test_hard_pair(void const *data)
{
    auto const &p = static_cast<HardPair const *>(data)->pair;
    Failures failures;
    double out[2];
    auto const describe = [&] { return hex_text(p); };
    int const status = pw85_contact(p.r12.coordinates, p.q1.entries, p.q2.entries, out);
    if (!failures.check(status == PW85_SUCCESS, "status", status, 0.0, describe)) return;
    double const units = error_in_units(out[0], truth<Wide>(p));
    failures.check(units <= 4.0, "error of mu^2 in u cond", units, 4.0, describe);
}

} // namespace

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, nullptr);
    g_test_add_func("/solver/safeguarded_search", test_safeguarded_search);
    g_test_add_func("/solver/safeguarded_steps", test_safeguarded_steps);
    g_test_add_func("/solver/bound_on_evaluations", test_bound_on_evaluations);
    g_test_add_func("/solver/extreme_shapes", test_extreme_shapes);
    g_test_add_func("/solver/derivatives_of_extreme_shapes", test_derivatives_of_extreme_shapes);
    for (auto const &hard : hard_pairs)
        g_test_add_data_func((std::string("/solver/") + hard.name).c_str(), &hard, test_hard_pair);
    return g_test_run();
}
