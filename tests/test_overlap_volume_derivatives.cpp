// SPDX-License-Identifier: BSD-3-Clause
// Tests of the derivatives of the common part (include/pw85/volume/) against their contract: the
// error of the derivative with respect to a number p is below u (256 m + 64 s), with the
// sensitivity s of this derivative to the data and its natural size m.
#include <array>
#include <cmath>
#include <cstring>

#include <glib.h>

#include <pw85.h>

#include "cases.hpp"
#include "draws.hpp"
#include "failures.hpp"
#include "random_pairs.hpp"
#include "wide.hpp"

using namespace pw85_tests;

namespace {

constexpr double u = 0x1p-53;

using Fine = Multiprecision<20>;

/// Numbers of a pair: those of r12, q1 and q2 in this order.
template <int D> constexpr int entries = D *(D + 1) / 2;
template <int D> constexpr int numbers = D + 2 * entries<D>;
template <class T, int D> using Numbers = std::array<T, std::size_t(numbers<D>)>;

template <class T, int D> T &number_of(Sample<T, D> &p, int k)
{
    if (k < D) return p.r12[k];
    return k < D + entries<D> ? p.q1[k - D] : p.q2[k - D - entries<D>];
}

/// By which numbers of the pair a number is measured: |r12_i|, or √(q_ii q_jj).
template <class T, int D> Numbers<T, D> scales_of(Sample<T, D> const &p)
{
    using std::abs, std::sqrt;
    Numbers<T, D> scales{};
    for (int i = 0; i < D; ++i) scales[std::size_t(i)] = abs(p.r12[i]);
    std::size_t k = D;
    for (auto const *q : {&p.q1, &p.q2})
        for (int i = 0; i < D; ++i)
            for (int j = i; j < D; ++j) scales[k++] = sqrt(T((*q)(i, i) * (*q)(j, j)));
    return scales;
}

template <class Derivatives, int D> Numbers<Fine, D> numbers_of(Derivatives const &d)
{
    Numbers<Fine, D> x{};
    for (int i = 0; i < D; ++i) x[std::size_t(i)] = d.r12[i];
    for (int k = 0; k < entries<D>; ++k) {
        x[std::size_t(D + k)] = d.q1[k];
        x[std::size_t(D + entries<D> + k)] = d.q2[k];
    }
    return x;
}

template <int D> Numbers<Fine, D> exact_derivatives(Sample<Fine, D> const &p)
{
    if constexpr (D == 3)
        return numbers_of<pw85::OverlapVolumeGradient<Fine>, 3>(
            pw85::overlap_volume_gradient(p.r12, p.q1, p.q2));
    else
        return numbers_of<pw85::OverlapAreaGradient<Fine>, 2>(
            pw85::overlap_area_gradient(p.r12, p.q1, p.q2));
}

template <int D> int derivatives(Sample<double, D> const &p, Numbers<double, D> &d)
{
    double *const x = d.data();
    auto const gradient = D == 3 ? pw85_overlap_volume_gradient : pw85_overlap_area_gradient_2d;
    return gradient(p.r12.coordinates, p.q1.entries, p.q2.entries, x, x + D, x + D + entries<D>);
}

template <int D> double measured(Sample<double, D> const &p)
{
    double x = 0.0;
    (D == 3 ? pw85_overlap_volume : pw85_overlap_area_2d)(p.r12.coordinates, p.q1.entries,
                                                          p.q2.entries, &x);
    return x;
}

template <int D> double whole(pw85::SymmetricMatrix<double, D> const &q)
{
    double x = 0.0;
    (D == 3 ? pw85_volume : pw85_area_2d)(q.entries, &x);
    return x;
}

/// √P_ii with the inverse P of a form.
template <int D>
std::array<double, std::size_t(D)> inverse_lengths(pw85::SymmetricMatrix<double, D> const &q)
{
    auto const wide = convert<Fine>(q);
    auto const adjugate = pw85::detail::adjugate(wide);
    Fine const determinant = pw85::detail::determinant(wide, adjugate);
    std::array<double, std::size_t(D)> lengths{};
    for (int i = 0; i < D; ++i)
        lengths[std::size_t(i)] =
            std::sqrt(static_cast<double>(Fine(adjugate(i, i) / determinant)));
    return lengths;
}

/// m of the contract.
template <int D> Numbers<double, D> natural_sizes(Sample<double, D> const &p)
{
    double const volumes[2] = {whole(p.q1), whole(p.q2)};
    bool const first = volumes[0] <= volumes[1];
    double const v = first ? volumes[0] : volumes[1];
    std::array const lengths = {inverse_lengths(p.q1), inverse_lengths(p.q2)};
    auto const &small = lengths[first ? 0 : 1];
    Numbers<double, D> m{};
    for (std::size_t i = 0; i < D; ++i) m[i] = v * small[i];
    std::size_t k = D;
    for (auto const &own : lengths)
        for (std::size_t i = 0; i < D; ++i)
            for (std::size_t j = i; j < D; ++j)
                m[k++] =
                    i == j ? v * small[i] * own[i] : v * (small[i] * own[j] + small[j] * own[i]);
    return m;
}

/// s of the contract, by difference quotients.
template <int D> Numbers<double, D> sensitivities(Sample<double, D> const &p)
{
    auto const exact = convert<Fine>(p);
    auto const scales = scales_of(exact);
    Fine const step = ldexp(Fine(1), -40);
    Numbers<double, D> s{};
    for (int k = 0; k < numbers<D>; ++k) {
        auto more = exact, less = exact;
        number_of(more, k) += step * scales[std::size_t(k)];
        number_of(less, k) -= step * scales[std::size_t(k)];
        auto const above = exact_derivatives(more), below = exact_derivatives(less);
        for (std::size_t i = 0; i < s.size(); ++i)
            s[i] += std::abs(static_cast<double>(Fine((above[i] - below[i]) / (2 * step))));
    }
    return s;
}

template <int D> Numbers<double, D> bounds_of(Sample<double, D> const &p)
{
    auto const m = natural_sizes(p), s = sensitivities(p);
    Numbers<double, D> bounds{};
    for (std::size_t i = 0; i < m.size(); ++i) bounds[i] = u * (256.0 * m[i] + 64.0 * s[i]);
    return bounds;
}

/// Checks the derivatives of a pair against the contract. Where one ellipsoid is inside the other
/// one to rounding, the common part as a whole jumps by as little, and so do its derivatives: this
/// is no test of the integrals.
template <int D> void check_numbers(Failures &failures, Sample<double, D> const &p,
                                    Numbers<double, D> const &d, Numbers<Fine, D> const &truth)
{
    auto const bounds = bounds_of(p);
    for (std::size_t i = 0; i < d.size(); ++i) {
        double const error = std::abs(static_cast<double>(Fine(Fine(d[i]) - truth[i])));
        failures.check(error <= bounds[i], "error", error, bounds[i],
                       [&] { return hex_text(p) + " number " + std::to_string(i); });
    }
}

template <int D> void check_derivatives(Failures &failures, Sample<double, D> const &p,
                                        Numbers<Fine, D> const &truth)
{
    Numbers<double, D> d{};
    g_assert_cmpint(derivatives(p, d), ==, PW85_SUCCESS);
    check_numbers(failures, p, d, truth);
}

template <int D> bool is_part(Sample<double, D> const &p)
{
    double const x = measured(p);
    return x > 0.0 && x != whole(p.q1) && x != whole(p.q2);
}

/// Pairs of all kinds.
template <int D> Sample<double, D> general_pair(Random &random, int n)
{
    PairOptions options{};
    options.aspect = n % 4 == 0 ? 1.1 : n % 4 == 1 ? 3.0 : n % 4 == 2 ? 30.0 : 1000.0;
    options.mu2_min = 1e-3;
    options.mu2_max = 1.0;
    return random_pair<D>(random, options);
}

/// Surfaces that touch from inside at a point, or nearly.
template <int D> Sample<double, D> touching_pair(Random &random, double size, double change)
{
    Sample<double, D> p{{}, random_form<D>(random, 1.0, 3.0), random_form<D>(random, size, 3.0)};
    auto const normal = random.direction<D>();
    auto const point_of = [&](auto const &q) {
        return 1.0 / std::sqrt(pw85::detail::quadratic_form(q, normal)) * pw85::product(q, normal);
    };
    p.r12 = point_of(p.q1) - point_of(p.q2) + change * normal;
    return p;
}

/// Thin lenses.
template <int D> Sample<double, D> lens(Random &random)
{
    PairOptions options{};
    options.mu2_min = options.mu2_max = 1.0;
    auto p = random_pair<D>(random, options);
    p.r12 = std::sqrt(1.0 - random.log_uniform(1e-13, 0.1)) * p.r12;
    return p;
}

/// Axes along the coordinate axes, so that the data lose nothing; aspect ratios to 10⁶.
template <int D> Sample<double, D> slender_pair(Random &random)
{
    Sample<double, D> p{};
    for (int i = 0; i < D; ++i) {
        p.q1(i, i) = random.log_uniform(1e-12, 1.0);
        p.q2(i, i) = random.log_uniform(1e-12, 1.0);
        p.r12[i] = random.uniform(-0.5, 0.5) * (std::sqrt(p.q1(i, i)) + std::sqrt(p.q2(i, i)));
    }
    return p;
}

template <int D> void test_bound()
{
    Failures failures;
    Random random(930 + D);
    for (int n = 0; n < draws(D == 3 ? 160 : 1600); ++n) {
        auto const p = n % 8 < 4 ? general_pair<D>(random, n)
                       : n % 8 == 4
                           ? touching_pair<D>(random, random.log_uniform(0.7, 1.4),
                                              random.sign() * random.log_uniform(1e-10, 1e-3))
                       : n % 8 == 5 ? lens<D>(random)
                       : n % 8 == 6 ? slender_pair<D>(random)
                                    : touching_pair<D>(random, random.log_uniform(10.0, 1e8),
                                                       random.uniform(-1.0, 0.0)); // far centres
        if (is_part(p)) check_derivatives(failures, p, exact_derivatives(convert<Fine>(p)));
    }
}

struct VolumeTruth {
    double r12[3], q1[6], q2[6];
    char const *volume;
    int digits;
    char const *derivatives[15];
};

constexpr VolumeTruth truths[] = {
#include "volume_truths.inc"
};

/// Values by surface integrals in half-planes (scripts/volume_truths.py).
PW85_TEST("/overlap_volume_derivatives/record")
{
    Failures failures;
    for (auto const &t : truths) {
        Sample<double, 3> p{};
        std::memcpy(p.r12.coordinates, t.r12, sizeof t.r12);
        std::memcpy(p.q1.entries, t.q1, sizeof t.q1);
        std::memcpy(p.q2.entries, t.q2, sizeof t.q2);
        Numbers<Fine, 3> truth{};
        for (std::size_t i = 0; i < truth.size(); ++i) truth[i] = Fine(t.derivatives[i]);
        check_derivatives(failures, p, truth);
    }
}

/// Pairs of which chords without limits would exceed the bound: the line 712 and 29 times, the
/// numbers of the frame 4.2 times.
constexpr Sample<double, 2> beyond_limits[] = {
    {{{-0x1.078806acb4492p-5, 0x1.68556022a32cdp-7}},
     {{0x1.cc7228f150422p-3, 0x1.30068898b072p-2, 0x1.c5c703fc8f7dbp-1}},
     {{0x1.9f86a67bb633ap-3, 0x1.14f78c0481d6ap-2, 0x1.d06fc65710dffp-1}}},
    {{{-0x1.8ad915f26aa18p-6, 0x1.142a660160b62p-4}},
     {{0x1.ff6fa705e19b2p-1, -0x1.e4e420efe83p-9, 0x1.f9a328669343ap-1}},
     {{0x1.df8b111fe8383p-1, 0x1.350fff4e030d8p-5, 0x1.c38d8624634e8p-1}}},
    {{{0x1.e148b14bb539cp-3, -0x1.185222d7854ccp-2}},
     {{0x1.82bcb5affae99p-11, 0x1.3f45030ab667p-6, 0x1.ffce30f61d8bbp-1}},
     {{0x1.1b3361384dee1p+1, 0x1.931bc61dfe30ep-5, 0x1.3d80a2e0053e1p-8}}},
};

/// Checks the derivatives by chords, if these say that they are within the bound.
void check_chords(Failures &failures, Sample<double, 2> const &p)
{
    auto const found = pw85::detail::chord_derivatives(p.r12, p.q1, p.q2);
    if (!found.certain) return;
    auto const &[r12, q1, q2, certain] = found;
    check_numbers(failures, p,
                  {r12[0], r12[1], q1[0], 2.0 * q1[1], q1[2], q2[0], 2.0 * q2[1], q2[2]},
                  exact_derivatives(convert<Fine>(p)));
}

/// Chords of pairs of all kinds and of sizes 2^±40. Nearly all pairs with moderate aspect ratios
/// have them.
PW85_TEST("/overlap_volume_derivatives/chords_2d")
{
    Failures failures;
    for (auto const &p : beyond_limits) check_chords(failures, p);
    Random random(937);
    int parts = 0, certain = 0;
    for (int n = 0; n < draws(4000); ++n) {
        auto p = n % 8 < 5    ? general_pair<2>(random, n)
                 : n % 8 == 5 ? touching_pair<2>(random, random.log_uniform(0.5, 2.0),
                                                 random.sign() * random.log_uniform(1e-10, 1e-1))
                 : n % 8 == 6 ? lens<2>(random)
                              : slender_pair<2>(random);
        if (!is_part(p)) continue;
        int const size = n % 3 == 0 ? 0 : n % 3 == 1 ? 40 : -40;
        p = {pw85::detail::times_power_of_two(p.r12, size),
             pw85::detail::times_power_of_two(p.q1, 2 * size),
             pw85::detail::times_power_of_two(p.q2, 2 * size)};
        check_chords(failures, p);
        if (n % 8 != 1) continue; // aspect ratios to 3
        ++parts;
        certain += pw85::detail::chord_derivatives(p.r12, p.q1, p.q2).certain;
    }
    g_assert_cmpint(certain, >, 9 * parts / 10);
}

/// Derivatives are limits of difference quotients of the area, whose formula is another one. The
/// third derivative is multiplied by the square of a step of 2⁻³⁰.
PW85_TEST("/overlap_volume_derivatives/quotients_2d")
{
    Failures failures;
    Random random(936);
    for (int n = 0; n < draws(400); ++n) {
        PairOptions options{};
        options.mu2_max = 0.9;
        auto const p = random_pair<2>(random, options);
        auto const exact = convert<Fine>(p);
        auto const scales = scales_of(exact);
        Fine const step = ldexp(Fine(1), -30);
        Numbers<double, 2> d{};
        g_assert_cmpint(derivatives(p, d), ==, PW85_SUCCESS);
        auto const area = [](auto const &x) { return pw85::overlap_area(x.r12, x.q1, x.q2).area; };
        for (int k = 0; k < numbers<2>; ++k) {
            auto more = exact, less = exact;
            number_of(more, k) += step * scales[std::size_t(k)];
            number_of(less, k) -= step * scales[std::size_t(k)];
            auto const change = static_cast<double>(Fine((area(more) - area(less)) / (2 * step)));
            double const own = d[std::size_t(k)] * static_cast<double>(scales[std::size_t(k)]);
            failures.check(std::abs(own - change) <= 1e-10 * std::fmin(whole(p.q1), whole(p.q2)),
                           "quotient", own, change,
                           [&] { return hex_text(p) + " number " + std::to_string(k); });
        }
    }
}

/// Away from the common centre, the common part falls (Brunn and Minkowski): r12·∂V/∂r12 <= 0.
template <int D> void test_falls()
{
    Failures failures;
    Random random(938);
    for (int n = 0; n < draws(400); ++n) {
        PairOptions options{};
        options.mu2_max = 1.0;
        auto const p = random_pair<D>(random, options);
        Numbers<double, D> d{};
        g_assert_cmpint(derivatives(p, d), ==, PW85_SUCCESS);
        double product = 0.0, bound = 0.0; // of a pair that nearly has one inside the other
        for (int i = 0; i < D; ++i) {
            product += p.r12[i] * d[std::size_t(i)];
            bound += 256.0 * u * std::abs(p.r12[i]) * natural_sizes(p)[std::size_t(i)];
        }
        failures.check(product <= bound, "falls", product, bound, [&] { return hex_text(p); });
    }
}

/// Rotations of an ellipse by its angle and its form: a torque is the derivative of the area of a
/// turned one. With the moment of the force all torques add up to zero.
PW85_TEST("/overlap_volume_derivatives/torques_2d")
{
    Failures failures;
    Random random(934);
    for (int n = 0; n < draws(400); ++n) {
        PairOptions options{};
        options.mu2_max = 0.9;
        auto const p = random_pair<2>(random, options);
        Numbers<double, 2> d{};
        g_assert_cmpint(derivatives(p, d), ==, PW85_SUCCESS);
        double torque1 = 0.0, torque2 = 0.0;
        g_assert_cmpint(pw85_overlap_area_torque_2d(p.r12.coordinates, p.q1.entries, p.q2.entries,
                                                    &torque1, &torque2),
                        ==, PW85_SUCCESS);
        auto const &q = p.q1; // dq under a rotation: (-2 q_xy, q_xx - q_yy, 2 q_xy)
        double const expected =
            -2.0 * q(0, 1) * d[2] + (q(0, 0) - q(1, 1)) * d[3] + 2.0 * q(0, 1) * d[4];
        double const bound =
            1e-13 * (q(0, 0) + q(1, 1)) * (std::abs(d[2]) + std::abs(d[3]) + std::abs(d[4]));
        failures.check(std::abs(torque1 - expected) <= bound, "torque", torque1, expected,
                       [&] { return hex_text(p); });
        double const rest = torque1 + torque2 + p.r12[0] * d[1] - p.r12[1] * d[0];
        failures.check(std::abs(rest) <= 1e-12 * std::fmin(whole(p.q1), whole(p.q2)), "reaction",
                       rest, 0.0, [&] { return hex_text(p); });
    }
}

PW85_ADD_TEST("/overlap_volume_derivatives/bound", test_bound<3>);
PW85_ADD_TEST("/overlap_volume_derivatives/bound_2d", test_bound<2>);
PW85_ADD_TEST("/overlap_volume_derivatives/falls", test_falls<3>);
PW85_ADD_TEST("/overlap_volume_derivatives/falls_2d", test_falls<2>);

} // namespace
