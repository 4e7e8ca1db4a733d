// SPDX-License-Identifier: BSD-3-Clause
// Tests of the area of the common part by chords (include/pw85/volume/chord_area.hpp).
#include <cmath>

#include <glib.h>

#include <pw85.h>

#include "cases.hpp"
#include "common_part_cases.hpp"
#include "draws.hpp"

using namespace pw85_tests;

namespace {

constexpr double u = 0x1p-53;

using Fine = FineMeasure;
using Pair2 = Sample<double, 2>;

/// Checks the area of the template against the contract.
void check_area(Failures &failures, Pair2 const &p)
{
    check_bound(failures, p, pw85::overlap_area(p.r12, p.q1, p.q2).area, measure(convert<Fine>(p)));
}

/// Ellipses of aspect ratios to 10⁵ and size ratios to 10⁵, one of them with another aspect ratio.
Pair2 extreme_pair(Random &random)
{
    PairOptions options{};
    options.aspect = random.log_uniform(1.0, 1e5);
    auto p = random_pair<2>(random, options);
    auto const n = random.direction<2>();
    double const size = random.log_uniform(1e-5, 1e5),
                 more = random.log_uniform(1.0, 1e3) * (p.q1(0, 0) + p.q1(1, 1));
    for (int i = 0; i < 2; ++i)
        for (int j = i; j < 2; ++j) p.q1(i, j) = size * (p.q1(i, j) + more * n[i] * n[j]);
    double const mu2 = pw85::contact(p.r12, p.q1, p.q2).mu2;
    p.r12 = std::sqrt(random.uniform(0.01, 1.0) / mu2) * p.r12;
    return p;
}

/// Pairs whose errors were 6 and 34 times the bound by joint frames of 53 digits alone.
constexpr Pair2 crossed_needles[] = {
    {{{-0x1.1c3233469939ep-1, 0x1.89693beae4445p-13}},
     {{0x1.b4ee6823f482ap-2, 0x1.8d4f0cb0a3cdap-7, 0x1.e1ea102410d02p-4}},
     {{0x1.01db4b20fefa3p-24, -0x1.4f64ce91b238fp-12, 0x1.9022c02746c8dp+1}}},
    {{{-0x1.070bf3f8cc6fap+0, 0x1.1a2b6a097f0b4p-1}},
     {{0x1.983912d27042bp+0, 0x1.e5ba8e583b5ap-1, 0x1.def37eeecdad7p+1}},
     {{0x1.c8ab835bfd6edp-18, 0x1.83d773c65b30fp-10, 0x1.4c508353b789dp-2}}},
    // whose chords have no margin: 8 and 1.7 times
    {{{-0x1.4d12bf45b16c7p-1, 0x1.4096e6ab5f459p-1}},
     {{0x1.1a5cab26440fdp-1, -0x1.dc3fc793fb1b1p-4, 0x1.1913fadb546cep-4}},
     {{0x1.686be1ba594e6p-27, 0x1.f42c921f1372bp-15, 0x1.2c94ce78c4f26p-1}}},
    {{{-0x1.bee8718adf345p-1, -0x1.c07b0f78d98c1p-1}},
     {{0x1.a17c3f64befcap-1, 0x1.8c1ebc23edb2bp-3, 0x1.086a682226073p-4}},
     {{0x1.d957c006abb05p-13, 0x1.5ef6d81ce9bc9p-7, 0x1.05cf0aaa0fd4bp-1}}},
};

PW85_TEST("/overlap_area/extremes")
{
    Failures failures;
    for (auto const &p : crossed_needles) check_area(failures, p);
    Random random(930);
    for (int n = 0; n < draws(8000); ++n) {
        auto const p = extreme_pair(random);
        check_area(failures, p);
    }
}

/// Pairs that touch from inside, or nearly, with surfaces that osculate among them.
PW85_TEST("/overlap_area/touching")
{
    Failures failures;
    Random random(931);
    for (int n = 0; n < draws(4000); ++n) {
        PairOptions options{};
        options.aspect = 5.0;
        auto p = random_pair<2>(random, options);
        auto const x = random.direction<2>();
        auto const point = [&](auto const &q) {
            return 1.0 / std::sqrt(pw85::detail::quadratic_form(q, x)) * pw85::product(q, x);
        };
        p.r12 = point(p.q1) - point(p.q2) + random.sign() * random.log_uniform(1e-14, 1e-2) * x;
        check_area(failures, p);
    }
}

/// The chords are used for nearly all pairs, with the bits of the C function, and for none of which
/// one is inside the other one.
PW85_TEST("/overlap_area/certain")
{
    Failures failures;
    Random random(932);
    int parts = 0, certain = 0;
    for (int n = 0; n < draws(8000); ++n) {
        PairOptions options{};
        options.aspect = n % 2 == 0 ? 3.0 : 30.0;
        options.mu2_min = 1e-3;
        options.mu2_max = 1.0;
        auto p = random_pair<2>(random, options);
        if (n % 5 == 0) { // next to internal tangency
            p.r12 = 0.01 * p.r12;
            double const scale = pw85::containment(p.r12, p.q1, p.q2).mu2;
            p.q1 = scale * (1.0 + random.sign() * random.log_uniform(0x1p-52, 1e-3)) * p.q1;
        }
        if (!pw85::overlap(p.r12, p.q1, p.q2).overlap) continue;
        bool const inside = pw85::contains(p.r12, p.q1, p.q2).contains ||
                            pw85::contains(-p.r12, p.q2, p.q1).contains;
        auto const found = pw85::detail::chord_area(p.r12, p.q1, p.q2);
        if (n % 5 != 0 && !inside) {
            ++parts;
            certain += found.certain;
        }
        failures.check(!(found.certain && inside), "certain", found.area, 0.0,
                       [&] { return hex_text(p); });
        failures.check(!found.certain || found.area == measured(p), "area", found.area, measured(p),
                       [&] { return hex_text(p); });
    }
    g_assert_cmpint(certain, >, 9 * parts / 10);
}

PW85_TEST("/overlap_area/decisions") { check_decisions<2>(933, draws(8000)); }

/// No two directions show that an ellipse inside the other one reaches beyond it.
PW85_TEST("/overlap_area/directions")
{
    Failures failures;
    Random random(936);
    for (int n = 0; n < draws(8000); ++n) {
        PairOptions options{};
        auto p = random_pair<2>(random, options);
        p.r12 = 0.3 * p.r12;
        double const scale = pw85::containment(p.r12, p.q1, p.q2).mu2;
        p.q1 = scale * (n % 2 == 0 ? 1.0 + 0x1p-50 : 0.5) * p.q1;
        bool const inside = pw85::contains(p.r12, p.q1, p.q2).contains;
        auto const pair = pw85::detail::circle_pair(p.r12, p.q1, p.q2);
        bool shown = false;
        for (int k = 0; k < 64; ++k) {
            auto const x = pw85::detail::supports(pair, random.direction<2>());
            shown = shown || pw85::detail::neither_inside(x, x);
        }
        failures.check(!(inside && shown), "shown", shown, inside, [&] { return hex_text(p); });
    }
}

/// Segments of all angles against α - sin α cos α in 50 digits.
PW85_TEST("/overlap_area/segment")
{
    Failures failures;
    Random random(934);
    for (int n = 0; n < draws(8000); ++n) {
        Wide const alpha =
            n % 2 == 0 ? Wide(random.uniform(0.0, 3.14)) : Wide(random.log_uniform(1e-8, 1.0));
        double const sine = static_cast<double>(Wide(sin(alpha))),
                     cosine = static_cast<double>(Wide(cos(alpha)));
        // the angle of the rounded numbers
        Wide const angle = atan2(Wide(sine), Wide(cosine)), truth = angle - sin(angle) * cos(angle);
        double const area = pw85::detail::unit_segment(sine, cosine),
                     error = std::abs(static_cast<double>(Wide(Wide(area) / truth - 1)));
        // 6u for sine, cosine and their tangent, and 6u for products and the polynomial
        failures.check(error <= 12.0 * u, "segment", error, 12.0 * u,
                       [&] { return std::to_string(sine) + " " + std::to_string(cosine); });
    }
}

/// The first approximation of a root of y³ + 3py + 2q against that root in 38 digits.
PW85_TEST("/overlap_area/rough_root")
{
    Failures failures;
    Random random(935);
    for (int n = 0; n < draws(8000); ++n) {
        double const p = random.sign() * random.log_uniform(1e-3, 1e3),
                     q = random.sign() * random.log_uniform(1e-4, 1e4);
        double const rough = pw85::detail::rough_cubic_root<double>({0.0, p, q});
        double const discriminant = q * q + p * p * p;
        double const a = std::cbrt(std::abs(q) + std::sqrt(std::fmax(discriminant, 0.0)));
        double const error =
            discriminant > 0.0 ? 2.2e-5 * (a + std::abs(p) / a) : 4.1e-7 * std::sqrt(-p);
        auto const value = [&](double y) {
            return static_cast<double>(
                Fine((Fine(y) * Fine(y) + 3 * Fine(p)) * Fine(y) + 2 * Fine(q)));
        };
        // one root or the lowest one: negative below, positive above until the next root
        double const below = value(rough - error), above = value(rough + error);
        failures.check(below <= 0.0 && above >= 0.0, "root", rough, error,
                       [&] { return std::to_string(p) + " " + std::to_string(q); });
    }
}

} // namespace
