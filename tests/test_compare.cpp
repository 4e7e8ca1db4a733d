// SPDX-License-Identifier: BSD-3-Clause
// The sign of μ² - m, against Sturm's theorem in integers of any size.
#include <cmath>
#include <limits>
#include <vector>

#include <glib.h>

#include <pw85.h>
#include <pw85_batch.h>

#include "cases.hpp"
#include "draws.hpp"
#include "failures.hpp"
#include "integer_maps.hpp"
#include "random_pairs.hpp"
#include "reference_data.hpp"
#include "sturm.hpp"
#include "wide.hpp"

using namespace pw85_tests;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity(),
                 nan = std::numeric_limits<double>::quiet_NaN();

/// How often each sign came up, and how often floating-point numbers decided: by the quartic, and
/// by the solver.
struct Signs {
    long below = 0, equal = 0, above = 0, by_quartic = 0, decided = 0;
};

int sign_in_c(Sample<double, 3> const &s, double m)
{
    int sign = 7;
    int const status = pw85_compare(s.r12.coordinates, s.q1.entries, s.q2.entries, m, &sign);
    g_assert_cmpint(sign, ==, pw85::compare(s.r12, s.q1, s.q2, m).sign);
    return status == PW85_SUCCESS ? sign : 100 + status;
}

/// Compares each tier alone, and all together, with the right sign: for the pair and for the same
/// pair exchanged.
template <class T, int D>
void expect(Sample<T, D> const &s, T const &m, int sign, Failures &failures, Signs &signs)
{
    namespace d = pw85::detail;
    for (auto const &sample : {s, Sample<T, D>{-s.r12, s.q2, s.q1}}) {
        auto const describe = [&] { return hex_text(sample) + ", m = " + hex_text(&m, 1); };
        d::ScaledPair<T, D> scaled;
        if (d::validate_pair(d::pair_of(s.r12, s.q1, s.q2), scaled) != pw85::Status::success)
            return;
        auto const first = d::compare_by_quartic(d::pair_of(sample.r12, sample.q1, sample.q2), m);
        signs.by_quartic += first != pw85::Decision::none;
        failures.check(first == pw85::Decision::none || d::to_sign(first) == sign, "quartic",
                       d::to_sign(first), sign, describe);
        auto const decision = d::compare_by_search(scaled, m);
        signs.decided += decision != pw85::Decision::none;
        failures.check(decision == pw85::Decision::none || d::to_sign(decision) == sign, "search",
                       d::to_sign(decision), sign, describe);
        int const exactly = d::compare_exactly(sample.r12, sample.q1, sample.q2, m);
        failures.check(exactly == sign, "exactly", exactly, sign, describe);
        int const answer = pw85::compare(sample.r12, sample.q1, sample.q2, m).sign;
        failures.check(answer == sign, "compare", answer, sign, describe);
        if constexpr (std::is_same_v<T, double> && D == 3)
            failures.check(sign_in_c(sample, m) == sign, "pw85_compare", sign_in_c(sample, m), sign,
                           describe);
    }
    signs.below += sign < 0;
    signs.equal += sign == 0;
    signs.above += sign > 0;
}

/// Numbers near μ²: the doubles next to it, and at distances of any size.
template <class T> std::vector<T> numbers_near(Random &random, T const &mu2)
{
    T const up = std::numeric_limits<T>::infinity();
    T const distance = static_cast<T>(random.log_uniform(1e-15, 0.5));
    return {mu2, std::nextafter(mu2, T(0)), std::nextafter(mu2, up), (1 - distance) * mu2,
            (1 + distance) * mu2};
}

// Random pairs of all kinds, m as near to μ² as rounding lets it be, and farther.
template <class T, int D> void test_random()
{
    Failures failures;
    Signs signs;
    Random random(600 + D);
    long const count = draws(600);
    for (long n = 0; n < count; ++n) {
        double const aspect = n % 4 == 0 ? 1e3 : n % 4 == 1 ? 1e6 : 5.0;
        auto const s = convert<T>(
            n % 3 == 0
                ? crossed_pair<D>(random, aspect)
                : random_pair<D>(random, {.aspect = aspect, .size_ratio = n % 5 == 0 ? 1e6 : 2.0}));
        auto const contact = pw85::contact(s.r12, s.q1, s.q2);
        // a form that is not definite when it is rounded
        if (contact.status != pw85::Status::success) continue;
        for (T const &m : numbers_near(random, contact.mu2))
            expect(s, m, true_sign(s, m), failures, signs);
    }
    g_test_message("%ld below, %ld equal, %ld above, %ld decided by the quartic, %ld by the solver",
                   signs.below, signs.equal, signs.above, signs.by_quartic, signs.decided);
    g_assert_cmpint(signs.below, >, count);
    g_assert_cmpint(signs.by_quartic, >, count / 4); // fewest for float
    g_assert_cmpint(signs.above, >, count);
    g_assert_cmpint(signs.decided, >, count / 2); // fewest for float
}

// Sizes from 1e-150 to 1e150, together and one against the other; m as large and as small as μ² is.
PW85_TEST("/compare/sizes")
{
    Failures failures;
    Signs signs;
    Random random(610);
    for (int n = 0; n < draws(150); ++n) {
        auto s = random_pair<3>(random, {.aspect = n % 2 == 0 ? 1e3 : 3.0});
        int const unit = n % 3 == 0 ? random.sign() > 0 ? 480 : -480 : 40 * (n % 5 - 2);
        int const other = n % 4 == 0 ? 400 * (n % 3 - 1) : 0,
                  length = n % 7 == 0 ? 300 * (n % 3 - 1) : 0;
        for (int k = 0; k < 6; ++k) {
            s.q1[k] = std::ldexp(s.q1[k], 2 * unit);
            s.q2[k] =
                std::ldexp(s.q2[k], unit * other > 0 ? 2 * (unit - other) : 2 * (unit + other));
        }
        for (int i = 0; i < 3; ++i)
            s.r12[i] = std::ldexp(s.r12[i], unit * length > 0 ? unit - length : unit + length);
        double const mu2 = pw85::contact(s.r12, s.q1, s.q2).mu2;
        if (!(mu2 > 0 && mu2 < infinity)) continue;
        for (double const m : numbers_near(random, mu2))
            if (m < infinity) expect(s, m, true_sign(s, m), failures, signs);
    }
    g_assert_cmpint(signs.below, >, draws(150));
    g_assert_cmpint(signs.above, >, draws(150));
}

template <int D>
pw85::Vector<double, D> mapped_vector(IntegerMap<D> const &map, pw85::Vector<double, D> const &x)
{
    pw85::Vector<double, D> y{};
    for (int i = 0; i < D; ++i)
        for (int k = 0; k < D; ++k) y[i] += map.l[i][k] * x[k];
    return y;
}

/// Balls whose radii add up to a power of two: μ² = |r|²/(a1 + a2)² is a double. A linear map makes
/// ellipsoids of them. In some the extents across r are changed: with r along an axis and equal
/// ratios of extents, λ is what it was, and so is μ².
template <int D> void test_equal()
{
    Failures failures;
    Signs signs;
    Random random(620 + D);
    for (int n = 0; n < draws(1500); ++n) {
        double const sum = std::ldexp(1.0, 4 + n % 4),
                     a1 = 1 + std::abs(random_integer(random, 13)), a2 = sum - a1;
        double const unit = std::ldexp(1.0, 40 * (n % 9 - 4));
        auto const map = random_map<D>(random, n % 5, n % 5);
        pw85::Vector<double, D> r{}, d1{}, d2{};
        bool const along_axis = n % 3 == 0;
        double const wide1 = along_axis ? 1 + std::abs(random_integer(random, 30)) : 1,
                     wide2 = along_axis && n % 2 == 0 ? 3 : 1;
        for (int i = 0; i < D; ++i) {
            r[i] = along_axis && i > 0 ? 0.0 : 1 + random_integer(random, 40);
            d1[i] = unit * unit * a1 * a1 * (i > 0 ? wide1 : 1.0);
            d2[i] = unit * unit * a2 * a2 * (i > 0 ? wide1 * wide2 : 1.0);
        }
        double square = 0;
        for (int i = 0; i < D; ++i) square += r[i] * r[i];
        if (square == 0) continue;
        Sample<double, D> const s{unit * mapped_vector(map, r), mapped(map, d1), mapped(map, d2)};
        double const mu2 = square / (sum * sum);
        g_assert_cmpint(true_sign(s, mu2), ==, 0);
        expect(s, mu2, 0, failures, signs);
        expect(s, std::nextafter(mu2, 0.0), 1, failures, signs);
        expect(s, std::nextafter(mu2, infinity), -1, failures, signs);
    }
    g_test_message("%ld equal", signs.equal);
    g_assert_cmpint(signs.equal, >, draws(1000));
}

// Small integers: multiple roots of every kind, compared with the nearest multiple of a quarter.
template <int D> void test_small_integers()
{
    Failures failures;
    Signs signs;
    Random random(630 + D);
    for (int n = 0; n < draws(6000); ++n) {
        Sample<double, D> s{};
        for (int i = 0; i < D; ++i) s.r12[i] = n % (i + 2) == 0 ? 0 : random_integer(random, 6);
        auto const form = [&] { return mapped_ball(random_map<D>(random, 1 + n % 3, 1 + n % 3)); };
        s.q1 = form();
        s.q2 = n % 7 == 0 ? s.q1 : form();
        if (pw85::detail::largest_coordinate(s.r12) == 0) continue;
        double const m = std::fmax(1.0, std::round(4 * pw85::contact(s.r12, s.q1, s.q2).mu2)) / 4;
        expect(s, m, true_sign(s, m), failures, signs);
    }
    g_test_message("%ld below, %ld equal, %ld above", signs.below, signs.equal, signs.above);
    g_assert_cmpint(signs.below, >, draws(200));
    g_assert_cmpint(signs.equal, >, draws(40));
    g_assert_cmpint(signs.above, >, draws(200));
}

// All contact problems, with the doubles about μ².
PW85_TEST("/compare/problems")
{
    Failures failures;
    Signs signs;
    std::size_t index = 0;
    for (auto const &p : contact_problems()) {
        if (++index % static_cast<std::size_t>(stride(4)) != 0 || !(p.mu2 > 0)) continue;
        for (double const m : {p.mu2, std::nextafter(p.mu2, 0.0), std::nextafter(p.mu2, infinity)})
            expect(p.pair, m, true_sign(p.pair, m), failures, signs);
    }
    g_test_message("%ld below, %ld equal, %ld above", signs.below, signs.equal, signs.above);
}

// Every limb of the integers: forms and m at both ends of the range.
template <class T> void test_widest()
{
    using Limits = std::numeric_limits<T>;
    Failures failures;
    Signs signs;
    T const tiny = Limits::denorm_min(), large = Limits::max(),
            root = std::sqrt(std::ldexp(T(1), Limits::max_exponent - 2));
    pw85::SymmetricMatrix<T, 3> const full{large, tiny, -tiny, large, tiny, large};
    int widest = 0;
    for (T const &r : {tiny, T(1), root, 4 * root, large})
        for (T const &m : {tiny, T(0.75), T(3), root, large}) {
            Sample<T, 3> const s{{r, tiny, -tiny}, full, full};
            expect(s, m, true_sign(s, m), failures, signs);
            auto const numbers = pw85::detail::exact::to_numbers(s.r12, s.q1, s.q2, m);
            if (!is_far(numbers)) widest = std::max(widest, bits(numbers));
        }
    int const room = pw85::detail::exact::max_bits<T>(Limits::max_exponent);
    g_assert_cmpint(widest, <=, room);
    g_assert_cmpint(widest, >, room - 5);
    g_assert_cmpint(signs.below, >, 0);
    g_assert_cmpint(signs.above, >, 0);
}

// Zero and infinity, for the number and for the separation.
PW85_TEST("/compare/ends")
{
    double const tiny = std::numeric_limits<double>::denorm_min();
    Sample<double, 3> const s{{1, 2, 3}, {1, 0, 0, 1, 0, 1}, {2, 0.5, 0, 1, 0, 1}},
        concentric{{0, -0.0, 0}, s.q1, s.q2};
    g_assert_cmpint(sign_in_c(s, 0.0), ==, 1);
    g_assert_cmpint(sign_in_c(s, -0.0), ==, 1);
    g_assert_cmpint(sign_in_c(s, tiny), ==, 1);
    g_assert_cmpint(sign_in_c(s, infinity), ==, -1);
    g_assert_cmpint(sign_in_c(concentric, 0.0), ==, 0);
    g_assert_cmpint(sign_in_c(concentric, tiny), ==, -1);
    g_assert_cmpint(sign_in_c(concentric, infinity), ==, -1);
    Sample<double, 3> const huge{
        {1e150, 0, 0}, {1e-300, 0, 0, 1e-300, 0, 1e-300}, {1e-300, 0, 0, 1e-300, 0, 1e-300}};
    g_assert_cmpint(sign_in_c(huge, infinity), ==, -1);
    g_assert_cmpint(sign_in_c(huge, std::numeric_limits<double>::max()), ==, 1);
    Sample<double, 3> const small{{1e-170, 0, 0}, {1, 0, 0, 1, 0, 1}, {1, 0, 0, 1, 0, 1}};
    g_assert_cmpint(sign_in_c(small, tiny), ==, -1);
    g_assert_cmpint(sign_in_c(small, 0.0), ==, 1);
}

PW85_TEST("/compare/status")
{
    Sample<double, 3> const good{{1, 2, 3}, {9, 0, 0, 9, 0, 9}, {2, 0, 0, 1, 0, 1}};
    auto const refused = [&](Sample<double, 3> const &s, double m, int status) {
        int sign = 7;
        g_assert_cmpint(pw85_compare(s.r12.coordinates, s.q1.entries, s.q2.entries, m, &sign), ==,
                        status);
        g_assert_cmpint(sign, ==, 2);
        sign = 7;
        g_assert_cmpint(
            pw85_compare_batch(1, s.r12.coordinates, s.q1.entries, s.q2.entries, &m, &sign), ==,
            status);
        g_assert_cmpint(sign, ==, 2);
    };
    for (double const bad : {-infinity, -1.0, -std::numeric_limits<double>::denorm_min()})
        refused(good, bad, PW85_EINVAL);
    auto bad = good;
    bad.q2[0] = -1;
    for (double const m : {0.0, 1.0, infinity}) refused(bad, m, PW85_ENOTPD);
}

// Many pairs with a number each, one of them bad.
PW85_TEST("/compare/batch")
{
    Random random(640);
    std::size_t const n = 1000, wrong = 600;
    std::vector<double> r12, q1, q2, mu2;
    std::vector<int> signs(n, 7);
    for (std::size_t i = 0; i < n; ++i) {
        auto const s = random_pair<3>(random, {});
        r12.insert(r12.end(), s.r12.coordinates, s.r12.coordinates + 3);
        q1.insert(q1.end(), s.q1.entries, s.q1.entries + 6);
        q2.insert(q2.end(), s.q2.entries, s.q2.entries + 6);
        mu2.push_back(i == wrong ? -1.0 : random.log_uniform(0.01, 100.0));
    }
    g_assert_cmpint(
        pw85_compare_batch(n, r12.data(), q1.data(), q2.data(), mu2.data(), signs.data()), ==,
        PW85_EINVAL);
    for (std::size_t i = 0; i < n; ++i) {
        int sign = 7;
        pw85_compare(&r12[3 * i], &q1[6 * i], &q2[6 * i], mu2[i], &sign);
        g_assert_cmpint(signs[i], ==, i == wrong ? 2 : sign);
    }
}

// A number of 50 digits is compared to rounding.
PW85_TEST("/compare/wide")
{
    Sample<Wide, 3> const s =
        convert<Wide>(Sample<double, 3>{{3, 0, 4}, {1, 0, 0, 1, 0, 1}, {9, 0, 0, 9, 0, 9}});
    Wide const mu2 = Wide(25) / 16, change = Wide("1e-45");
    g_assert_cmpint(pw85::compare(s.r12, s.q1, s.q2, Wide(mu2 - change)).sign, ==, 1);
    g_assert_cmpint(pw85::compare(s.r12, s.q1, s.q2, Wide(mu2 + change)).sign, ==, -1);
    g_assert_cmpint(pw85::compare(s.r12, s.q1, s.q2, Wide(-1)).sign, ==, 2);
}

PW85_ADD_TEST("/compare/random/float", test_random<float, 3>);
PW85_ADD_TEST("/compare/random/double", test_random<double, 3>);
PW85_ADD_TEST("/compare/random/long_double", test_random<long double, 3>);
PW85_ADD_TEST("/compare/random/2d", test_random<double, 2>);
PW85_ADD_TEST("/compare/equal/2d", test_equal<2>);
PW85_ADD_TEST("/compare/equal/3d", test_equal<3>);
PW85_ADD_TEST("/compare/small_integers/2d", test_small_integers<2>);
PW85_ADD_TEST("/compare/small_integers/3d", test_small_integers<3>);
PW85_ADD_TEST("/compare/widest/float", test_widest<float>);
PW85_ADD_TEST("/compare/widest/double", test_widest<double>);

} // namespace
