// SPDX-License-Identifier: BSD-3-Clause
// Tests of the exact tier of the overlap test alone. The reference is Sturm's theorem in integers
// of any size.
#include <cmath>
#include <limits>

#include <glib.h>

#include "draws.hpp"
#include "failures.hpp"
#include "random_pairs.hpp"
#include "reference_data.hpp"
#include "sturm.hpp"

using namespace pw85_tests;

namespace {

template <class T, int D> pw85::Decision decide(Sample<T, D> const &s)
{
    return pw85::detail::decide_exactly(s.r12, s.q1, s.q2);
}

/// How often each kind of roots came up.
struct Kinds {
    long apart = 0, overlapping = 0;
    long tangent = 0;         ///< a double positive root
    long negative_double = 0; ///< and a complex pair
    long real_double = 0;     ///< a double root, all roots real
    long pair = 0;            ///< a complex pair and some positive coefficient
};

/// Compares one pair, and the same pair exchanged, with the oracle.
template <class T, int D> void compare(Sample<T, D> const &s, Failures &failures, Kinds &kinds)
{
    auto const p = quartic(s);
    Roots const roots = roots_of(p);
    auto const expected = roots.positive > 0 ? pw85::Decision::apart : pw85::Decision::overlap;
    Sample<T, D> const exchanged{-s.r12, s.q2, s.q1};
    for (auto const &sample : {s, exchanged}) {
        auto const decision = decide(sample);
        failures.check(decision == expected, "decision", static_cast<double>(decision),
                       static_cast<double>(expected), [&] { return hex_text(sample); });
        int const sign = pw85::detail::compare_exactly(sample.r12, sample.q1, sample.q2, T(1));
        failures.check(sign == sign_of(roots), "sign", sign, sign_of(roots),
                       [&] { return hex_text(sample); });
    }
    bool positive_coefficient = false;
    for (auto const &coefficient : p)
        positive_coefficient = positive_coefficient || coefficient > 0;
    kinds.apart += roots.positive > 0;
    kinds.overlapping += roots.positive == 0;
    kinds.tangent += roots.positive == 1;
    kinds.negative_double += roots.multiple && roots.real == 1 && positive_coefficient;
    kinds.real_double += roots.multiple && roots.real == D;
    kinds.pair += !roots.multiple && roots.real == D - 1 && positive_coefficient;
}

void report(Kinds const &kinds)
{
    g_test_message("%ld apart, %ld of them tangent, %ld overlap; %ld double roots beside real "
                   "ones, %ld beside a pair; "
                   "%ld pairs",
                   kinds.apart, kinds.tangent, kinds.overlapping, kinds.real_double,
                   kinds.negative_double, kinds.pair);
}

// As close to tangency as rounding lets them be.
template <class T, int D> void test_random()
{
    Failures failures;
    Kinds kinds;
    Random random(110 + D);
    for (int n = 0; n < draws(1000); ++n) {
        double const mu2 = n % 2 == 0 ? 1.0 : random.uniform(0.5, 2.0);
        auto const s = random_pair<D>(random, {.aspect = n % 3 == 0 ? 1e3 : 3.0,
                                               .size_ratio = n % 5 == 0 ? 1e6 : 2.0,
                                               .mu2_min = mu2,
                                               .mu2_max = mu2});
        compare(convert<T>(s), failures, kinds);
    }
    report(kinds);
    g_assert_cmpint(kinds.apart, >, draws(200));
    g_assert_cmpint(kinds.overlapping, >, draws(200));
    g_assert_cmpint(kinds.pair, >, draws(100));
}

int random_integer(Random &random, int limit)
{
    return static_cast<int>(std::floor(random.uniform(-limit, limit + 1)));
}

/// L Lᵀ of small integers, or a diagonal, often with equal entries.
template <int D> pw85::SymmetricMatrix<double, D> small_form(Random &random, int limit)
{
    pw85::SymmetricMatrix<double, D> q{};
    bool const diagonal = random.uniform(0.0, 1.0) < 0.5;
    double l[std::size_t(D)][std::size_t(D)] = {};
    for (int i = 0; i < D; ++i) {
        for (int j = 0; j < i && !diagonal; ++j) l[i][j] = random_integer(random, limit);
        l[i][i] = 1 + std::abs(random_integer(random, limit));
    }
    for (int i = 0; i < D; ++i)
        for (int j = i; j < D; ++j)
            for (int k = 0; k < D; ++k) q(i, j) += l[i][k] * l[j][k];
    return q;
}

// Spheres, spheroids, separations along axes: multiple roots of every kind. Powers of two change
// nothing.
template <int D> void test_small_integers()
{
    Failures failures;
    Kinds kinds;
    Random random(120 + D);
    for (int n = 0; n < draws(20000); ++n) {
        Sample<double, D> s{};
        int const limit = 1 + n % 3;
        s.q1 = small_form<D>(random, limit);
        s.q2 = small_form<D>(random, limit);
        for (int i = 0; i < D; ++i)
            s.r12[i] = n % (i + 2) == 0 ? 0 : random_integer(random, 4 * limit);
        double const length = n % 4 == 0 ? std::ldexp(1.0, random_integer(random, 500)) : 1.0;
        s.r12 = length * s.r12;
        s.q1 = length * length * s.q1;
        s.q2 = length * length * s.q2;
        compare(s, failures, kinds);
    }
    report(kinds);
    g_assert_cmpint(kinds.tangent, >, draws(100));
    g_assert_cmpint(kinds.real_double, >, draws(100));
    g_assert_cmpint(kinds.pair, >, draws(100));
    if (D == 3) g_assert_cmpint(kinds.negative_double, >, draws(20));
}

/// A form L Lᵀ stretched along the axes by powers of two.
pw85::SymmetricMatrix<double, 3> stretched(pw85::SymmetricMatrix<double, 3> q,
                                           int const (&exponents)[3])
{
    for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j) q(i, j) = std::ldexp(q(i, j), exponents[i] + exponents[j]);
    return q;
}

// Coordinates from 2^-limit to 2^limit. Where forms and coordinates are stretched alike the pair
// stays what it was, as near to contact as it was; otherwise it is any.
void test_spans(gconstpointer data)
{
    int const limit = GPOINTER_TO_INT(data);
    Failures failures;
    Kinds kinds;
    Random random(130);
    for (int n = 0; n < 300; ++n) {
        int exponents[3];
        for (int &exponent : exponents) exponent = random_integer(random, limit);
        Sample<double, 3> s = random_pair<3>(
            random, {.mu2_min = n % 4 < 2 ? 1.0 : 0.5, .mu2_max = n % 4 < 2 ? 1.0 : 2.0});
        if (n % 8 >= 4) s = {{2, 3, 6}, small_form<3>(random, 2), small_form<3>(random, 2)};
        for (int i = 0; i < 3; ++i) s.r12[i] = std::ldexp(s.r12[i], exponents[i]);
        if (n % 2 == 0 && limit < 512) {
            s.q1 = stretched(s.q1, exponents);
            s.q2 = stretched(s.q2, exponents);
        }
        compare(s, failures, kinds);
    }
    report(kinds);
    g_assert_cmpint(kinds.apart, >, 50);
    g_assert_cmpint(kinds.overlapping, >, 25);
}

// Forms at one end of the range with off-diagonal entries at the other, and coordinates that reach
// as far: the memory is needed to the last limb.
template <class T> void test_widest()
{
    using Limits = std::numeric_limits<T>;
    Failures failures;
    T const tiny = Limits::denorm_min(), large = Limits::max(),
            radius2 = std::ldexp(T(1), Limits::max_exponent - 2);
    T const diameter = 2 * std::sqrt(radius2), far = std::nextafter(2 * diameter, T(0));
    pw85::SymmetricMatrix<T, 3> const ball{radius2, 0, 0, radius2, 0, radius2};
    pw85::SymmetricMatrix<T, 3> const blob{radius2, tiny, -tiny, radius2, tiny, radius2};
    pw85::SymmetricMatrix<T, 3> const flat{large, tiny, 0, large, 0, tiny},
        full{large, tiny, -tiny, large, tiny, large};
    using S = Sample<T, 3>;
    struct {
        S pair;
        bool overlap;
    } const cases[] = {
        {{{large, -large, tiny}, full, full}, false},
        {{{2 * far, -far, tiny}, full, full}, false},
        {{{far, -far, tiny}, full, full}, false},
        {{{far, far, tiny}, full, flat}, false},
        {{{diameter, tiny, tiny}, full, full}, true},
        {{{tiny, tiny, tiny}, full, flat}, true},
        {{{diameter, 0, 0}, ball, ball}, false},
        {{{diameter, tiny, 0}, ball, ball}, false},
        {{{diameter, 0, 0}, ball, blob}, false}, // a slightly turned plane separates them
        {{{std::nextafter(diameter, T(0)), tiny, 0}, ball, ball}, true},
        {{{std::nextafter(diameter, large), tiny, 0}, blob, blob}, false},
    };
    int widest = 0;
    for (auto const &[pair, overlap] : cases) {
        auto const decision = decide(pair);
        failures.check(decision == (overlap ? pw85::Decision::overlap : pw85::Decision::apart),
                       "decision", static_cast<double>(decision), overlap,
                       [p = pair] { return hex_text(p); });
        auto const numbers = pw85::detail::exact::to_numbers(pair.r12, pair.q1, pair.q2);
        if (!is_far(numbers)) widest = std::max(widest, bits(numbers));
    }
    g_assert_cmpint(widest, ==, pw85::detail::exact::max_bits<T>());
}

// Where bounding boxes are taken for a proof they are one, just within and beyond that limit.
void test_far()
{
    Failures failures;
    Kinds kinds;
    for (double const r : {4.0, std::nextafter(4.0, 0.0)})
        for (double const a : {std::nextafter(4.0, 0.0), 4.0, std::nextafter(8.0, 0.0)}) {
            compare(Sample<double, 3>{{r, 0, 0}, {a, 0, 0, a, 0, a}, {a, 0, 0, a, 0, a}}, failures,
                    kinds);
            compare(Sample<double, 2>{{0, r}, {a, 0, a}, {a, 0, a}}, failures, kinds);
        }
    g_assert_cmpint(kinds.tangent, ==, 2);
}

// All contact problems, the tangent ones included, past the tiers that decide most of them.
void test_problems()
{
    Failures failures;
    long tangent = 0;
    for (auto const &p : contact_problems()) {
        auto const expected = p.mu2_minus_1 < 0.0 ? pw85::Decision::overlap : pw85::Decision::apart;
        auto const decision = decide(p.pair);
        tangent += p.mu2_minus_1 == 0.0;
        failures.check(decision == expected, "decision", static_cast<double>(decision),
                       static_cast<double>(expected),
                       [&] { return *p.category + ": " + hex_text(p.pair); });
    }
    g_assert_cmpint(tangent, >=, 1000);
}

} // namespace

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, nullptr);
    g_test_add_func("/exact/random/float", test_random<float, 3>);
    g_test_add_func("/exact/random/double", test_random<double, 3>);
    g_test_add_func("/exact/random/long_double", test_random<long double, 3>);
    g_test_add_func("/exact/random/2d", test_random<double, 2>);
    g_test_add_func("/exact/small_integers/2d", test_small_integers<2>);
    g_test_add_func("/exact/small_integers/3d", test_small_integers<3>);
    g_test_add_data_func("/exact/spans/100", GINT_TO_POINTER(100), test_spans);
    g_test_add_data_func("/exact/spans/490", GINT_TO_POINTER(490), test_spans);
    g_test_add_data_func("/exact/spans/1020", GINT_TO_POINTER(1020), test_spans);
    g_test_add_func("/exact/widest/float", test_widest<float>);
    g_test_add_func("/exact/widest/double", test_widest<double>);
    g_test_add_func("/exact/widest/long_double", test_widest<long double>);
    g_test_add_func("/exact/far", test_far);
    g_test_add_func("/exact/problems", test_problems);
    return g_test_run();
}
