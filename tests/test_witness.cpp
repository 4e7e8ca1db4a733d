// SPDX-License-Identifier: BSD-3-Clause
// What pw85_overlap_witness() returns as a proof is one, checked in rational numbers.
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include <glib.h>

#include <pw85.h>
#include <pw85_batch.h>

#include "cases.hpp"
#include "draws.hpp"
#include "failures.hpp"
#include "oracle/exact_numbers.hpp"
#include "random_pairs.hpp"
#include "reference_data.hpp"
#include "sample.hpp"

using namespace pw85_tests;

namespace {

using Matrix = std::vector<std::vector<Rational>>;

Rational determinant(Matrix const &a)
{
    if (a.empty()) return 1;
    Rational sum = 0;
    for (std::size_t j = 0; j < a.size(); ++j) {
        Matrix minor(a.begin() + 1, a.end());
        for (auto &row : minor) row.erase(row.begin() + static_cast<std::ptrdiff_t>(j));
        Rational const term = a[0][j] * determinant(minor);
        sum = j % 2 == 0 ? sum + term : sum - term;
    }
    return sum;
}

/// det A - weight·xᵀ adj(A) x, the determinant of A bordered by x: positive if xᵀA⁻¹x < 1/weight
/// for a definite A.
Rational excess(Matrix a, std::vector<Rational> const &x, Rational const &weight)
{
    std::vector<Rational> last;
    for (std::size_t i = 0; i < x.size(); ++i) {
        a[i].push_back(x[i]);
        last.push_back(weight * x[i]);
    }
    last.push_back(1);
    a.push_back(last);
    return determinant(a);
}

template <class T, int D> Matrix blend(Rational const &a, pw85::SymmetricMatrix<T, D> const &p,
                                       Rational const &b, pw85::SymmetricMatrix<T, D> const &q)
{
    Matrix m(D, std::vector<Rational>(D));
    for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j)
            m[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] =
                a * Rational(p(i, j)) + b * Rational(q(i, j));
    return m;
}

/// Whether f(λ) > 1.
template <class T, int D> bool proves_apart(Sample<T, D> const &s, T const &lambda)
{
    if (!(lambda > 0 && lambda < 1)) return false;
    Rational const l = lambda, rest = 1 - l;
    std::vector<Rational> r;
    for (int i = 0; i < D; ++i) r.push_back(s.r12[i]);
    return excess(blend(rest, s.q1, l, s.q2), r, l * rest) < 0;
}

template <class T, int D> bool is_inside(pw85::Vector<T, D> const &x,
                                         pw85::Vector<T, D> const &center,
                                         pw85::SymmetricMatrix<T, D> const &q)
{
    std::vector<Rational> y;
    for (int i = 0; i < D; ++i) y.push_back(Rational(x[i]) - Rational(center[i]));
    return excess(blend(1, q, 0, q), y, 1) > 0;
}

template <class T, int D> bool proves_overlap(Sample<T, D> const &s, pw85::Vector<T, D> const &x)
{
    return pw85::detail::is_finite(x) && is_inside(x, pw85::Vector<T, D>{}, s.q1) &&
           is_inside(x, s.r12, s.q2);
}

struct Found {
    long apart = 0, overlapping = 0, nothing = 0;
};

/// Expects more than so many proofs of either kind.
void expect_enough(Found const &found, long least)
{
    g_test_message("%ld apart, %ld overlap, %ld without a proof", found.apart, found.overlapping,
                   found.nothing);
    g_assert_cmpint(found.apart, >, least);
    g_assert_cmpint(found.overlapping, >, least);
}

/// Checks the proof for a pair and for the same pair exchanged. False if none was found.
template <class T, int D> bool expect_proof(Sample<T, D> const &s, Failures &failures, Found &found)
{
    bool proved = true;
    for (auto const &sample : {s, Sample<T, D>{-s.r12, s.q2, s.q1}}) {
        auto const describe = [&] { return hex_text(sample); };
        auto const witness = pw85::overlap_witness(sample.r12, sample.q1, sample.q2);
        bool const overlap = pw85::overlap(sample.r12, sample.q1, sample.q2).overlap;
        failures.check(witness.overlap == overlap, "overlap", witness.overlap, overlap, describe);
        if (witness.status == pw85::Status::no_convergence) {
            proved = false;
            failures.check(std::isnan(witness.lambda) && std::isnan(witness.point[0]), "nothing", 0,
                           1, describe);
        } else {
            failures.check(witness.status == pw85::Status::success, "status", 0, 1, describe);
            failures.check(std::isnan(overlap ? witness.lambda : witness.point[0]),
                           "what does not apply", 0, 1, describe);
            failures.check(overlap ? proves_overlap(sample, witness.point)
                                   : proves_apart(sample, witness.lambda),
                           "proof", static_cast<double>(witness.lambda), overlap, describe);
        }
    }
    ++(!proved                                    ? found.nothing
       : pw85::overlap(s.r12, s.q1, s.q2).overlap ? found.overlapping
                                                  : found.apart);
    return proved;
}

// Pairs of all kinds with |μ² - 1| from 1e-14 on: a proof is always found.
template <class T, int D> void test_random()
{
    Failures failures;
    Found found;
    Random random(700 + D);
    bool const coarse = std::is_same_v<T, float>;
    for (int n = 0; n < draws(2000); ++n) {
        double const aspect = coarse ? 20.0 : n % 4 == 0 ? 1e8 : n % 4 == 1 ? 1e3 : 5.0;
        double const mu2 = 1 + random.sign() * random.log_uniform(coarse ? 1e-5 : 1e-13, 0.5);
        auto const s =
            convert<T>(n % 3 == 0 ? crossed_pair<D>(random, aspect)
                                  : random_pair<D>(random, {.aspect = aspect,
                                                            .size_ratio = n % 5 == 0 ? 1e4 : 2.0,
                                                            .mu2_min = mu2,
                                                            .mu2_max = mu2}));
        if (pw85::overlap(s.r12, s.q1, s.q2).status != pw85::Status::success)
            continue; // not definite when it is rounded
        auto const describe = [&] { return hex_text(s); };
        double const distance =
            std::fabs(static_cast<double>(pw85::contact(s.r12, s.q1, s.q2).mu2) - 1);
        bool const proved = expect_proof(s, failures, found);
        failures.check(proved || distance < (coarse ? 1e-6 : 1e-14), "found", distance, 0,
                       describe);
    }
    expect_enough(found, draws(400));
}

// A million pairs, with `-m perf`: aspect ratios to 1e8, crossed needles and ribbons, unlike sizes,
// |μ² - 1| from 1e-16 on. Prints where no proof was found, by |μ² - 1|.
PW85_TEST("/witness/million")
{
    if (!g_test_perf()) return;
    Failures failures;
    Found found;
    Random random(705);
    long without[20] = {}, all[20] = {};
    for (int n = 0; n < 1000000; ++n) {
        double const aspect = random.log_uniform(1.0, n % 4 == 0 ? 1e8 : n % 4 == 1 ? 1e4 : 10.0);
        double const mu2 = 1 + random.sign() * random.log_uniform(n % 8 == 0 ? 1e-16 : 1e-13, 0.5);
        auto const s = n % 5 == 0
                           ? crossed_pair<3>(random, aspect)
                           : random_pair<3>(random, {.aspect = aspect,
                                                     .size_ratio = n % 7 == 0 ? 1e6 : 2.0,
                                                     .mu2_min = mu2,
                                                     .mu2_max = mu2,
                                                     .aspect_min = n % 2 == 0 ? aspect : 1.0});
        auto const witness = pw85::overlap_witness(s.r12, s.q1, s.q2);
        if (witness.status != pw85::Status::success &&
            witness.status != pw85::Status::no_convergence)
            continue;
        bool const proved = witness.status == pw85::Status::success,
                   tangent = proved && !witness.overlap && !(witness.lambda > 0);
        bool const right =
            !proved || tangent ||
            (witness.overlap ? proves_overlap(s, witness.point) : proves_apart(s, witness.lambda));
        failures.check(right, "proof", witness.lambda, witness.overlap,
                       [&] { return hex_text(s); });
        ++(!proved ? found.nothing : witness.overlap ? found.overlapping : found.apart);
        double const distance = std::fabs(pw85::contact(s.r12, s.q1, s.q2).mu2 - 1);
        auto const decade =
            static_cast<std::size_t>(distance > 1e-18 ? -std::log10(distance) : 18.0);
        ++all[decade];
        if (proved) continue;
        ++without[decade];
        if (without[decade] <= 2)
            g_test_message("no proof, overlap %d: %s", witness.overlap, hex_text(s).c_str());
    }
    for (int k = 0; k < 20; ++k)
        if (all[k] > 0)
            g_test_message("|mu2 - 1| from 1e-%d to 1e-%d: %ld of %ld without a proof", k + 1, k,
                           without[k], all[k]);
    expect_enough(found, 400000);
}

// Sizes from 1e-150 to 1e150.
PW85_TEST("/witness/sizes")
{
    Failures failures;
    Found found;
    Random random(710);
    for (int n = 0; n < draws(100); ++n) {
        auto s = random_pair<3>(random,
                                {.aspect = n % 2 == 0 ? 1e3 : 3.0, .mu2_min = 0.9, .mu2_max = 1.1});
        int const exponent = n % 5 == 0 ? 490 : n % 5 == 1 ? -490 : 40 * (n % 5 - 3);
        s.r12 = std::ldexp(1.0, exponent) * s.r12;
        for (int k = 0; k < 6; ++k) {
            s.q1[k] = std::ldexp(s.q1[k], 2 * exponent);
            s.q2[k] = std::ldexp(s.q2[k], 2 * exponent);
        }
        bool const proved = expect_proof(s, failures, found);
        failures.check(proved, "found", n, 0, [&] { return hex_text(s); });
    }
    // One is a point to the other, and proves nothing by a λ near 1 that is not a double unless
    // they are apart by more than rounding.
    for (double const size : {0x1p-480, 0x1p-100, 0x1p-60})
        for (double const distance : {0x1p-30, -0x1p-30}) {
            double const small = size * size;
            Sample<double, 3> const s{
                {1 + distance, 0, 0}, {1, 0, 0, 1, 0, 1}, {small, 0, 0, small, 0, small}};
            failures.check(expect_proof(s, failures, found), "found", size, 0,
                           [&] { return hex_text(s); });
        }
}

/// Ellipsoids that touch: unit balls in contact, and a linear map of small integers.
Sample<double, 3> touching_pair(Random &random, int n)
{
    double const quadruples[][4] = {{1, 2, 2, 3},  {2, 3, 6, 7}, {1, 4, 8, 9},
                                    {6, 6, 7, 11}, {0, 3, 4, 5}, {0, 0, 2, 2}};
    auto const &quadruple = quadruples[n % 6];
    double l[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int i = 0; i < 3 && n >= 12; ++i) {
        for (int j = 0; j < i; ++j) l[i][j] = std::floor(random.uniform(-9, 10));
        l[i][i] = std::floor(random.uniform(1, 10));
    }
    double const a1 = quadruple[3] / 4, a2 = quadruple[3] - a1;
    Sample<double, 3> s{};
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) {
            s.r12[i] += l[i][k] * quadruple[k];
            for (int j = i; j < 3; ++j) {
                s.q1(i, j) += l[i][k] * l[j][k] * a1 * a1;
                s.q2(i, j) += l[i][k] * l[j][k] * a2 * a2;
            }
        }
    return s;
}

// Tangent pairs have no proof, and pairs as near to them as doubles are have one, or none is found.
PW85_TEST("/witness/tangent")
{
    Failures failures;
    Found found;
    Random random(720);
    for (int n = 0; n < draws(600); ++n) {
        auto const s = touching_pair(random, n);
        int overlap = 7;
        double lambda = 7, point[3] = {7, 7, 7};
        int const status = pw85_overlap_witness(s.r12.coordinates, s.q1.entries, s.q2.entries,
                                                &overlap, &lambda, point);
        failures.check(status == PW85_SUCCESS && overlap == 0 && std::isnan(lambda) &&
                           std::isnan(point[0]),
                       "tangent", status, overlap, [&] { return hex_text(s); });
        failures.check(std::isnan(pw85::overlap_witness(s.r12, s.q1, s.q2).lambda),
                       "tangent in the headers", lambda, 0, [&] { return hex_text(s); });
        for (double const towards : {0.0, 1e300}) {
            auto near = s;
            for (int const k : {0, 3, 5}) near.q1[k] = std::nextafter(s.q1[k], towards);
            expect_proof(near, failures, found);
        }
    }
    expect_enough(found, draws(100));
}

// Balls at λ = 1/2 that are apart by the smallest numbers: λ = 1/2 proves it.
PW85_TEST("/witness/barely_apart")
{
    Failures failures;
    Found found;
    for (double const y : {0x1p-20, 0x1p-60, 0x1p-500, std::numeric_limits<double>::denorm_min()}) {
        Sample<double, 3> const s{{2, y, 0}, {1, 0, 0, 1, 0, 1}, {1, 0, 0, 1, 0, 1}};
        failures.check(expect_proof(s, failures, found), "found", y, 0,
                       [&] { return hex_text(s); });
    }
    g_assert_cmpint(found.apart, ==, 4);
}

// Each tier alone, at any λ and at any point.
template <int D> void test_tiers()
{
    Failures failures;
    Random random(730 + D);
    long above = 0, inside = 0, clearly = 0;
    for (int n = 0; n < draws(2000); ++n) {
        double const mu2 = n % 2 == 0 ? 1.0 : random.log_uniform(0.5, 1.9);
        auto const s = random_pair<D>(
            random, {.aspect = n % 4 == 0 ? 1e6 : 4.0, .mu2_min = mu2, .mu2_max = mu2});
        double const best = pw85::contact(s.r12, s.q1, s.q2).lambda;
        double const lambda =
            n % 3 == 0 ? best : std::fmin(1 - 0x1p-53, best * random.log_uniform(0.5, 1.9));
        auto const describe = [&] { return hex_text(s) + ", lambda = " + hex_text(&lambda, 1); };
        bool const expected = proves_apart(s, lambda);
        bool const exactly = pw85::detail::exceeds_one_exactly(s.r12, s.q1, s.q2, lambda);
        failures.check(exactly == expected, "exceeds_one_exactly", exactly, expected, describe);
        bool const clear = pw85::detail::exceeds_one_clearly(s.r12, s.q1, s.q2, lambda);
        failures.check(expected || !clear, "exceeds_one_clearly", clear, expected, describe);
        auto const decision = pw85::detail::decide_by_extended(s.r12, s.q1, s.q2, lambda);
        bool const decided = decision != pw85::Decision::none;
        failures.check(!decided || (decision == pw85::Decision::apart) == expected,
                       "decide_by_extended", decided, expected, describe);
        auto x = pw85::contact_geometry(s.r12, s.q1, s.q2, best).point;
        for (int i = 0; i < D; ++i)
            x[i] *= 1 + random.sign() * (n % 3 == 0 ? 0x1p-52 : 0.1) * random.uniform(0, 1);
        bool const within = is_inside(x, s.r12, s.q2);
        bool const found = pw85::detail::is_inside_exactly(x, s.r12, s.q2);
        failures.check(found == within, "is_inside_exactly", found, within, describe);
        above += expected;
        clearly += clear;
        inside += within;
    }
    g_test_message("%ld above, %ld clearly, %ld inside", above, clearly, inside);
    g_assert_cmpint(clearly, >, draws(200));
    g_assert_cmpint(above, >, clearly);
    g_assert_cmpint(inside, >, draws(300));
}

// All contact problems: a proof, or they touch, or they nearly do.
PW85_TEST("/witness/problems")
{
    Failures failures;
    Found found;
    std::size_t index = 0;
    for (auto const &p : contact_problems()) {
        if (++index % static_cast<std::size_t>(stride(8)) != 0 || p.mu2_minus_1 == 0.0) continue;
        bool const proved = expect_proof(p.pair, failures, found);
        failures.check(proved || std::fabs(p.mu2_minus_1) < 1e-15, "found", p.mu2_minus_1, 0,
                       [&] { return *p.category + ": " + hex_text(p.pair); });
    }
    g_test_message("%ld apart, %ld overlap, %ld without a proof", found.apart, found.overlapping,
                   found.nothing);
}

// Many pairs, with and without the outputs that may be null.
PW85_TEST("/witness/batch")
{
    Random random(740);
    std::size_t const n = 700, wrong = 300;
    std::vector<double> r12, q1, q2, lambda(n, 7), point(3 * n, 7);
    std::vector<unsigned char> overlap(n, 7);
    for (std::size_t i = 0; i < n; ++i) {
        auto s = random_pair<3>(random, {});
        if (i == wrong) s.q2[0] = -1;
        r12.insert(r12.end(), s.r12.coordinates, s.r12.coordinates + 3);
        q1.insert(q1.end(), s.q1.entries, s.q1.entries + 6);
        q2.insert(q2.end(), s.q2.entries, s.q2.entries + 6);
    }
    for (bool const all : {true, false}) {
        double *const l = all ? lambda.data() : nullptr, *const p = all ? point.data() : nullptr;
        g_assert_cmpint(
            pw85_overlap_witness_batch(n, r12.data(), q1.data(), q2.data(), overlap.data(), l, p),
            ==, PW85_ENOTPD);
        for (std::size_t i = 0; i < n; ++i) {
            int answer = 7;
            double one[4] = {7, 7, 7, 7};
            pw85_overlap_witness(&r12[3 * i], &q1[6 * i], &q2[6 * i], &answer, one, one + 1);
            g_assert_cmpint(overlap[i], ==, i == wrong ? 255 : answer);
            g_assert_true(std::memcmp(one, &lambda[i], sizeof(double)) == 0);
            g_assert_true(std::memcmp(one + 1, &point[3 * i], 3 * sizeof(double)) == 0);
        }
    }
}

PW85_ADD_TEST("/witness/random/float", test_random<float, 3>);
PW85_ADD_TEST("/witness/random/double", test_random<double, 3>);
PW85_ADD_TEST("/witness/random/2d", test_random<double, 2>);
PW85_ADD_TEST("/witness/tiers/2d", test_tiers<2>);
PW85_ADD_TEST("/witness/tiers/3d", test_tiers<3>);

} // namespace
