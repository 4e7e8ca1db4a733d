// SPDX-License-Identifier: BSD-3-Clause
// Compares the batch functions with the functions for one pair, and with themselves: the result for
// a pair depends only on the pair.
#include <cstdint>
#include <cstring>
#include <memory>

#include <glib.h>

#include <pw85/batch.hpp>
#include <pw85/systems.hpp>

#include "../cases.hpp"
#include "../condition_number.hpp"
#include "../draws.hpp"
#include "../failures.hpp"
#include "../reference_data.hpp"
#include "batch_data.hpp"

using namespace pw85_tests;

namespace {

// g_assert_cmpmem() converts between int and size_t.
void assert_same_bytes(void const *actual, void const *expected, std::size_t size)
{
    g_assert_true(size == 0 || std::memcmp(actual, expected, size) == 0);
}

constexpr double u = 0x1p-53;

// The reference data, with the bound of the functions for one pair: 4 u cond for μ² (half an ulp
// more for the rounding of the reference itself is far below it).
PW85_TEST("/batch/problems")
{
    Failures accuracy, overlaps;
    std::vector<Pair3> pairs;
    for (auto const &p : contact_problems()) pairs.push_back(p.pair);
    BatchResult const result = run_batch(pairs);
    g_assert_cmpint(result.contact_status, ==, PW85_SUCCESS);
    g_assert_cmpint(result.overlap_status, ==, PW85_SUCCESS);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        auto const &p = contact_problems()[i];
        auto const describe = [&] { return *p.category + ": " + hex_text(p.pair); };
        double const error = pw85::detail::absolute(result.mu2[i] - p.mu2) / p.mu2;
        accuracy.check(error <= 4.0 * u * p.cond, "relative error of mu^2", error, 4.0 * u * p.cond,
                       describe);
        overlaps.check(result.overlap[i] == (p.mu2_minus_1 < 0.0), "overlap", result.overlap[i],
                       p.mu2_minus_1 < 0.0, describe);
    }
}

// λ from a batch is good enough for f there to be μ² to within the same bound.
PW85_TEST("/batch/lambda")
{
    Failures failures;
    Random random(1);
    std::vector<Pair3> pairs;
    for (int i = 0; i < draws(5000); ++i)
        pairs.push_back(random_pair<3>(random, {.aspect = 1000.0}));
    BatchResult const result = run_batch(pairs);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        auto const p = convert<long double>(pairs[i]);
        auto const truth = pw85::contact(p.r12, p.q1, p.q2);
        auto const f =
            pw85::detail::evaluate_f(static_cast<long double>(result.lambda[i]), p.r12, p.q1, p.q2);
        double const loss = static_cast<double>((truth.mu2 - f) / truth.mu2);
        double const bound = 4.0 * u * static_cast<double>(condition_number(p, truth.lambda));
        failures.check(loss <= bound, "relative loss of f at lambda", loss, bound,
                       [&] { return hex_text(pairs[i]); });
    }
}

struct Expected {
    double out[2];
    int overlap, contact_status, overlap_status;
};

Expected one_by_one(Pair3 const &p)
{
    Expected e{};
    e.contact_status = pw85_contact(p.r12.coordinates, p.q1.entries, p.q2.entries, e.out);
    e.overlap_status = pw85_overlap(p.r12.coordinates, p.q1.entries, p.q2.entries, &e.overlap);
    return e;
}

// Hard, easy and invalid pairs in one block: the same marks and statuses, the same answers, and
// numbers that differ by no more than twice the 4 u cond of either.
PW85_TEST("/batch/mixed")
{
    Failures failures;
    Random random(2);
    for (int block = 0; block < 20; ++block) {
        auto const pairs = mixed_pairs(random, 1000);
        BatchResult const result = run_batch(pairs);
        int first_contact = 0, first_overlap = 0;
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            Expected const e = one_by_one(pairs[i]);
            if (first_contact == 0) first_contact = e.contact_status;
            if (first_overlap == 0) first_overlap = e.overlap_status;
            auto const describe = [&] { return hex_text(pairs[i]); };
            unsigned char const mark = static_cast<unsigned char>(e.overlap);
            failures.check(result.overlap[i] == mark, "overlap", result.overlap[i], mark, describe);
            bool const bad = e.contact_status != 0;
            failures.check(std::isnan(result.mu2[i]) == bad && std::isnan(result.lambda[i]) == bad,
                           "mark", result.mu2[i], e.out[0], describe);
            if (bad || e.out[0] == 0.0) continue;
            auto const wide = convert<long double>(pairs[i]);
            auto const lambda = pw85::contact(wide.r12, wide.q1, wide.q2).lambda;
            double const cond = static_cast<double>(condition_number(wide, lambda));
            double const difference = std::fabs(result.mu2[i] / e.out[0] - 1.0);
            failures.check(difference <= 8.0 * u * cond, "difference from pw85_contact", difference,
                           8.0 * u * cond, describe);
        }
        g_assert_cmpint(result.contact_status, ==, first_contact);
        g_assert_cmpint(result.overlap_status, ==, first_overlap);
    }
}

// Every size up to 40, at every position of a larger batch: the same bits.
PW85_TEST("/batch/sizes_and_positions")
{
    Failures failures;
    Random random(3);
    auto const pairs = mixed_pairs(random, 80);
    BatchResult const whole = run_batch(pairs);
    for (std::size_t n = 0; n <= 40; ++n)
        for (std::size_t first = 0; first <= 40; ++first) {
            BatchResult const part = run_batch(pairs, first, n);
            for (std::size_t i = 0; i < n; ++i)
                failures.check(part.same_row(i, whole, first + i), "mu^2", part.mu2[i],
                               whole.mu2[first + i], [&] { return hex_text(pairs[first + i]); });
        }
}

// Any order, large batches: the same bits.
PW85_TEST("/batch/order")
{
    Failures failures;
    Random random(4);
    std::size_t const n = 20011; // a prime: stepping through it reaches every row
    auto const pairs = mixed_pairs(random, n);
    BatchResult const straight = run_batch(pairs);
    for (std::size_t const stride : {std::size_t{7}, std::size_t{9973}}) {
        std::vector<Pair3> shuffled(n);
        for (std::size_t i = 0; i < n; ++i) shuffled[i] = pairs[i * stride % n];
        BatchResult const result = run_batch(shuffled);
        for (std::size_t i = 0; i < n; ++i)
            failures.check(result.same_row(i, straight, i * stride % n), "mu^2", result.mu2[i],
                           straight.mu2[i * stride % n], [&] { return hex_text(shuffled[i]); });
    }
}

/// Numbers at an address that is a multiple of 8 but of no higher power of two.
class Unaligned {
  public:
    explicit Unaligned(std::size_t n) : bytes_(new double[n + 16])
    {
        auto const address = reinterpret_cast<std::uintptr_t>(bytes_.get());
        start_ = bytes_.get() + (address % 16 == 0 ? 1 : 2);
    }
    double *data() { return start_; }

  private:
    std::unique_ptr<double[]> bytes_;
    double *start_;
};

PW85_TEST("/batch/unaligned")
{
    Random random(5);
    std::size_t const n = 333;
    auto const pairs = mixed_pairs(random, n);
    BatchResult const expected = run_batch(pairs);
    Unaligned r12(3 * n), q1(6 * n), q2(6 * n), mu2(n), lambda(n);
    std::vector<unsigned char> overlap(n + 1);
    for (std::size_t i = 0; i < n; ++i) {
        std::memcpy(r12.data() + 3 * i, pairs[i].r12.coordinates, 3 * sizeof(double));
        std::memcpy(q1.data() + 6 * i, pairs[i].q1.entries, 6 * sizeof(double));
        std::memcpy(q2.data() + 6 * i, pairs[i].q2.entries, 6 * sizeof(double));
    }
    pw85_contact_batch(n, r12.data(), q1.data(), q2.data(), mu2.data(), lambda.data());
    pw85_overlap_batch(n, r12.data(), q1.data(), q2.data(), overlap.data() + 1);
    assert_same_bytes(mu2.data(), expected.mu2.data(), n * sizeof(double));
    assert_same_bytes(lambda.data(), expected.lambda.data(), n * sizeof(double));
    assert_same_bytes(overlap.data() + 1, expected.overlap.data(), n);
    // Without λ, the same μ².
    std::vector<double> alone(n);
    pw85_contact_batch(n, r12.data(), q1.data(), q2.data(), alone.data(), nullptr);
    assert_same_bytes(alone.data(), expected.mu2.data(), n * sizeof(double));
}

// The status is that of the first bad pair, whatever comes after, in blocks of other threads too.
PW85_TEST("/batch/first_status")
{
    Random random(6);
    std::vector<Pair3> pairs;
    for (int i = 0; i < 30000; ++i) pairs.push_back(random_pair<3>(random, {}));
    for (auto const &[first, second] :
         {std::pair<std::size_t, std::size_t>{17, 3}, {29999, 4097}, {12000, 11999}}) {
        auto bad = pairs;
        bad[first].q1[0] = -1.0;
        bad[second].r12[1] = std::numeric_limits<double>::quiet_NaN();
        BatchResult const result = run_batch(bad);
        g_assert_cmpint(result.contact_status, ==, PW85_EINVAL);
        g_assert_cmpint(result.overlap_status, ==, PW85_EINVAL);
        bad[0].q2[5] = 0.0;
        BatchResult const other = run_batch(bad);
        g_assert_cmpint(other.contact_status, ==, PW85_ENOTPD);
        g_assert_cmpint(other.overlap_status, ==, PW85_ENOTPD);
        for (std::size_t const i : {std::size_t{0}, first, second}) {
            g_assert_true(std::isnan(other.mu2[i]) && std::isnan(other.lambda[i]));
            g_assert_cmpint(other.overlap[i], ==, 255);
        }
    }
}

PW85_TEST("/batch/spans")
{
    Random random(7);
    std::size_t const n = 700;
    auto const pairs = mixed_pairs(random, n);
    BatchResult const expected = run_batch(pairs);
    std::vector<Vector3> r12;
    std::vector<Form3> q1, q2;
    for (Pair3 const &p : pairs) {
        r12.push_back(p.r12);
        q1.push_back(p.q1);
        q2.push_back(p.q2);
    }
    std::vector<double> mu2(n), lambda(n);
    std::vector<unsigned char> overlap(n);
    auto const status = pw85::contact_batch(r12, q1, q2, mu2, lambda);
    g_assert_cmpint(static_cast<int>(status), ==, expected.contact_status);
    g_assert_cmpint(static_cast<int>(pw85::overlap_batch(r12, q1, q2, overlap)), ==,
                    expected.overlap_status);
    assert_same_bytes(mu2.data(), expected.mu2.data(), n * sizeof(double));
    assert_same_bytes(lambda.data(), expected.lambda.data(), n * sizeof(double));
    assert_same_bytes(overlap.data(), expected.overlap.data(), n);
    mu2.pop_back();
    g_assert_true(pw85::contact_batch(r12, q1, q2, mu2) == pw85::Status::invalid_argument);
    g_assert_true(pw85::contact_batch(r12, q1, q2, lambda, mu2) == pw85::Status::invalid_argument);
    g_assert_true(pw85::contact_batch(pw85::Vectors{}, {}, {}, {}) == pw85::Status::success);
}

PW85_TEST("/batch/float_spans")
{
    Failures failures;
    Random random(8);
    std::size_t const n = 700;
    std::vector<pw85::Vector<float, 3>> r12;
    std::vector<pw85::SymmetricMatrix<float, 3>> q1, q2;
    for (std::size_t i = 0; i < n; ++i) {
        auto const p = convert<float>(random_pair<3>(random, {}));
        r12.push_back(p.r12);
        q1.push_back(p.q1);
        q2.push_back(p.q2);
    }
    std::vector<float> mu2(n), lambda(n);
    g_assert_true(pw85::contact_batch(r12, q1, q2, mu2, lambda) == pw85::Status::success);
    for (std::size_t i = 0; i < n; ++i) {
        auto const p = convert<double>(Sample<float, 3>{r12[i], q1[i], q2[i]});
        auto const c = pw85::contact(p.r12, p.q1, p.q2);
        // Rounding to float, twice that for a value that is close to half-way.
        failures.check(std::fabs(mu2[i] / c.mu2 - 1.0) <= 0x1p-23, "mu^2", mu2[i], c.mu2,
                       [&] { return hex_text(p); });
        failures.check(std::fabs(lambda[i] - c.lambda) <= 0x1p-23, "lambda", lambda[i], c.lambda,
                       [&] { return hex_text(p); });
    }
}

} // namespace
