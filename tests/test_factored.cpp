// SPDX-License-Identifier: BSD-3-Clause
// The contact function of ellipsoids that are given by factors of their forms, against 200 digits:
// for the factors as given, and for semi-axes and quaternions as given. And the condition number.
#include <algorithm>
#include <cmath>
#include <limits>

#include <glib.h>

#include <pw85.h>
#include <pw85/pw85.hpp>
#include <pw85_batch.h>

#include "cases.hpp"
#include "draws.hpp"
#include "factors.hpp"
#include "failures.hpp"

using namespace pw85_tests;

namespace {

/// μ², λ and the fraction c by which μ² changes at most, for fractions of the entries.
template <class T, int D> Truth<TruthOfFactors> truth_of(Factors<T, D> const &p)
{
    auto const w = squared(p);
    auto const c = pw85::contact(w.r12, w.q1, w.q2);
    TruthOfFactors const complement = 1 - c.lambda;
    pw85::SymmetricMatrix<TruthOfFactors, D> m{};
    for (int k = 0; k < m.size; ++k) m[k] = complement * w.q1[k] + c.lambda * w.q2[k];
    auto const n = pw85::detail::solve(pw85::detail::factorize(m, TruthOfFactors(0)), w.r12);
    TruthOfFactors sum = 0;
    auto const add = [&](pw85::Factor<T, D> const &s, TruthOfFactors const &weight) {
        for (int j = 0; j < D; ++j) {
            TruthOfFactors along = 0, magnitudes = 0;
            for (int i = 0; i < D; ++i) {
                along += n[i] * TruthOfFactors(s(i, j));
                magnitudes += abs(TruthOfFactors(n[i] * TruthOfFactors(s(i, j))));
            }
            sum += weight * abs(along) * magnitudes;
        }
    };
    add(p.s1, complement);
    add(p.s2, c.lambda);
    for (int i = 0; i < D; ++i) sum += abs(TruthOfFactors(n[i] * w.r12[i]));
    return {c.mu2, c.lambda, 2 * c.lambda * complement * sum / c.mu2};
}

template <class T, int D> void check_error(Factors<T, D> const &p, double bound, Failures &failures)
{
    auto const describe = [&] { return hex_text(p); };
    auto const actual = pw85::contact_factored(p.r12, p.s1, p.s2);
    if (!failures.check(actual.status == pw85::Status::success, "status",
                        static_cast<double>(actual.status), 0.0, describe))
        return;
    auto const exact = truth_of(p);
    double const error = error_in_units(actual.mu2, exact);
    failures.check(error <= bound, "error in u c", error, bound, describe);
    auto const swapped = pw85::contact_factored(-p.r12, p.s2, p.s1);
    double const other = error_in_units(swapped.mu2, exact);
    failures.check(other <= bound, "error of the swapped pair in u c", other, bound, describe);
}

/// The error is below 4 u c for factors of all kinds, aspect ratios to 1e12 and sizes to 2^±40.
PW85_TEST("/factored/error")
{
    Failures failures;
    Random random(27);
    for (int n = 0; n < draws(4000); ++n) {
        double const aspect =
            // mixed columns of 1e6 are nearly dependent
            random.log_uniform(1.0, n % 4 == 1 ? 1e5 : 1e12);
        check_error(random_factors(random, n % 4, aspect, random.log_uniform(0x1p-40, 0x1p40)), 4.0,
                    failures);
    }
}

/// The semi-axes and rotations as given, in 200 digits.
Sample<TruthOfFactors, 3> exact_pair(pw85::Vector<double, 3> const &r12,
                                     pw85::Vector<double, 3> const (&axes)[2],
                                     pw85::Vector<double, 4> const (&turns)[2])
{
    using pw85::detail::converted;
    return {converted<TruthOfFactors>(r12),
            pw85::ellipsoid_quaternion(converted<TruthOfFactors>(axes[0]),
                                       converted<TruthOfFactors>(turns[0]))
                .q,
            pw85::ellipsoid_quaternion(converted<TruthOfFactors>(axes[1]),
                                       converted<TruthOfFactors>(turns[1]))
                .q};
}

/// The digits of slender ellipsoids: at aspect ratio 100, 1e4 and 1e6 the relative error against
/// the truth for the semi-axes and quaternions as given is below 1e-14, 1e-12 and 1e-12.
PW85_TEST("/factored/digits")
{
    Failures failures;
    Random random(28);
    struct Row {
        double aspect, bound;
    };
    for (auto const &[aspect, bound] : {Row{1e2, 1e-14}, Row{1e4, 1e-12}, Row{1e6, 1e-12}}) {
        double worst = 0.0, worst_packed = 0.0;
        for (int n = 0; n < draws(2000); ++n) {
            pw85::Vector<double, 3> const axes[2] = {
                random.semi_axes(1.0, aspect),
                random.semi_axes(random.log_uniform(0.5, 2.0), aspect)};
            pw85::Vector<double, 4> const turns[2] = {random.direction<4>(), random.direction<4>()};
            auto const r12 = random.direction<3>();
            auto const exact = exact_pair(r12, axes, turns);
            TruthOfFactors const mu2 = pw85::contact(exact.r12, exact.q1, exact.q2).mu2;
            double s1[9], s2[9], q1[6], q2[6], out[2], packed[2];
            pw85_ellipsoid_factor(axes[0].coordinates, turns[0].coordinates, s1);
            pw85_ellipsoid_factor(axes[1].coordinates, turns[1].coordinates, s2);
            pw85_contact_factored(r12.coordinates, s1, s2, out);
            pw85_ellipsoid_quaternion(axes[0].coordinates, turns[0].coordinates, q1);
            pw85_ellipsoid_quaternion(axes[1].coordinates, turns[1].coordinates, q2);
            pw85_contact(r12.coordinates, q1, q2, packed);
            double const error = std::fabs(static_cast<double>(TruthOfFactors(out[0] / mu2 - 1)));
            worst = std::max(worst, error);
            worst_packed = std::max(
                worst_packed, std::fabs(static_cast<double>(TruthOfFactors(packed[0] / mu2 - 1))));
            failures.check(error <= bound, "relative error", error, bound, [&] {
                return pw85_tests::hex_text(r12.coordinates, 3) + pw85_tests::hex_text(s1, 9) +
                       pw85_tests::hex_text(s2, 9);
            });
        }
        g_test_message("aspect ratio %g: largest relative error %.1e by factors, %.1e by forms",
                       aspect, worst, worst_packed);
    }
}

/// Needles that cross tip to tip, where h' is tiny.
PW85_TEST("/factored/crossed")
{
    Failures failures;
    Random random(29);
    for (int n = 0; n < draws(1000); ++n) {
        double const thin = 1.0 / random.log_uniform(10.0, 1e30),
                     tilt = random.sign() * random.log_uniform(1e-14, 1e-2);
        auto const turn = random_rotation(random);
        pw85::Factor<double, 3> const a{{1.0, 0.0, 0.0, 0.0, thin, 0.0, 0.0, 0.0, thin}};
        pw85::Factor<double, 3> const b{{thin, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, thin}};
        pw85::Vector<double, 3> r12{};
        pw85::Vector<double, 3> const body{1.0 + tilt, random.sign() * (1.0 + tilt),
                                           random.uniform(-1.0, 1.0) * thin};
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 3; ++k) r12[i] += turn(i, k) * body[k];
        check_error(Factors<double, 3>{r12, product(turn, a), product(turn, b)}, 4.0, failures);
    }
}

/// The corrected evaluation alone: it errs by less than 4 u c wherever it is certain, however far t
/// is from the maximum and whatever h'' the search found.
PW85_TEST("/factored/corrected")
{
    namespace d = pw85::detail;
    Failures failures;
    Random random(34);
    int certified = 0;
    int const count = draws(4000);
    for (int n = 0; n < count; ++n) {
        auto const p =
            random_factors(random, n % 4, random.log_uniform(1.0, n % 2 == 0 ? 1e3 : 1e5),
                           random.log_uniform(0x1p-10, 0x1p10));
        auto const pair = d::pair_of(p.r12, p.s1, p.s2);
        auto const exact = truth_of(p);
        double const off = random.sign() * random.log_uniform(1e-12, 1e-4);
        double const t =
            static_cast<double>(TruthOfFactors(exact.lambda / (1 - exact.lambda))) * (1.0 + off);
        double const k2 = random.sign() * random.log_uniform(1e-3, 1e300);
        auto const describe = [&] { return hex_text(p) + ", t = " + pw85_tests::hex_text(&t, 1); };
        auto const last = d::last_evaluation(pair, d::rounded_forms(pair), {t, 0.0, k2});
        double const error = error_in_units(last.value.mu2, exact);
        bool const negative =
            d::last_evaluation(pair, d::rounded_forms(pair), {-t, 0.0, k2}).certified;
        failures.check(!negative, "certain at -t", negative, 0.0, describe);
        failures.check(!last.certified || error <= 4.0, "corrected evaluation", error, 4.0,
                       describe);
        certified += last.certified;
    }
    g_test_message("%d of %d evaluations certain", certified, count);
    g_assert_cmpint(certified, >, count / 2);
    g_assert_cmpint(certified, <, count);
}

template <class T, int D> void test_scalar()
{
    Failures failures;
    Random random(30);
    for (int n = 0; n < draws(300); ++n) {
        Factors<T, D> p{};
        for (int i = 0; i < D; ++i) p.r12[i] = static_cast<T>(random.normal());
        for (int i = 0; i < D * D; ++i) {
            p.s1.entries[i] = static_cast<T>(random.normal());
            p.s2.entries[i] = static_cast<T>(random.normal());
        }
        check_error(p, 4.0, failures);
    }
}

/// Powers of two change no bit; and sizes of both ellipsoids and the distance may be anywhere from
/// 2^-490 to 2^490.
PW85_TEST("/factored/scales")
{
    Failures failures;
    Random random(31);
    for (int n = 0; n < draws(1000); ++n) {
        auto const p = random_factors(random, 0, 100.0, 1.0);
        auto const expected = pw85::contact_factored(p.r12, p.s1, p.s2);
        int const e = static_cast<int>(random.uniform(-490.0, 490.0));
        using pw85::detail::times_power_of_two;
        Factors<double, 3> const scaled{times_power_of_two(p.r12, e), times_power_of_two(p.s1, e),
                                        times_power_of_two(p.s2, e)};
        auto const actual = pw85::contact_factored(scaled.r12, scaled.s1, scaled.s2);
        failures.check(actual.mu2 == expected.mu2, "μ² of a scaled pair", actual.mu2, expected.mu2,
                       [&] { return hex_text(scaled); });
        failures.check(actual.lambda == expected.lambda, "λ of a scaled pair", actual.lambda,
                       expected.lambda, [&] { return hex_text(scaled); });
        Factors<double, 3> const unlike{p.r12, p.s1, times_power_of_two(p.s2, -std::abs(e))};
        check_error(unlike, 4.0, failures);
    }
}

PW85_TEST("/factored/status")
{
    double const s[9] = {1.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 3.0}, r12[3] = {1.0, 2.0, 3.0},
                 zero[3] = {};
    double out[2];
    auto const status = [&](double const *r, double const *s1, double const *s2) {
        out[0] = out[1] = 7.0;
        int const result = pw85_contact_factored(r, s1, s2, out);
        g_assert_true(result == PW85_SUCCESS || (std::isnan(out[0]) && std::isnan(out[1])));
        return result;
    };
    g_assert_cmpint(status(r12, s, s), ==, PW85_SUCCESS);
    g_assert_cmpint(status(zero, s, s), ==, PW85_SUCCESS);
    g_assert_true(out[0] == 0.0 && out[1] == 0.5);
    double const parallel[9] = {1.0, 1.0, 0.0, 2.0, 2.0, 0.0, 0.0, 0.0, 3.0}, none[9] = {};
    double const no_column[9] = {1.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 1.0, 0.0};
    double const unlike[9] = {0x1p-130, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
    for (double const *bad : {parallel, none, no_column, unlike}) {
        g_assert_cmpint(status(r12, bad, s), ==, PW85_ENOTPD);
        g_assert_cmpint(status(r12, s, bad), ==, PW85_ENOTPD);
        g_assert_cmpint(status(zero, s, bad), ==, PW85_ENOTPD);
    }
}

/// The condition number against its definition in 200 digits, also for ellipsoids of unlike sizes
/// in either order.
PW85_TEST("/factored/condition")
{
    Failures failures;
    Random random(33);
    for (int n = 0; n < draws(2000); ++n) {
        auto const s = random_pair<3>(random, {random.log_uniform(1.0, 1e5), 0x1p30, 0.01, 100.0});
        double const lambda = pw85::contact(s.r12, s.q1, s.q2).lambda;
        double cond = 0.0;
        int const status =
            pw85_condition(s.r12.coordinates, s.q1.entries, s.q2.entries, lambda, &cond);
        double const exact = static_cast<double>(
            condition_number(convert<TruthOfFactors>(s), TruthOfFactors(lambda)));
        failures.check(status == PW85_SUCCESS && std::fabs(cond / exact - 1.0) <= 1e-2,
                       "condition number", cond, exact, [&] { return pw85_tests::hex_text(s); });
        failures.check(cond >= 3.0 - 1e-12, "least condition number", cond, 3.0,
                       [&] { return pw85_tests::hex_text(s); });
    }
}

PW85_ADD_TEST("/factored/scalars/float", test_scalar<float, 3>);
PW85_ADD_TEST("/factored/scalars/long-double", test_scalar<long double, 3>);
PW85_ADD_TEST("/factored/scalars/plane", test_scalar<double, 2>);

} // namespace
