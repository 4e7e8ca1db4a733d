// SPDX-License-Identifier: BSD-3-Clause
// Any number of threads may call any function at any time. Many threads call all functions on the
// same data, and get the same bits. The test is also run with ThreadSanitizer.
#include <cstring>
#include <thread>
#include <vector>

#include <glib.h>

#include <pw85_legacy.h>

#include "cases.hpp"
#include "random_pairs.hpp"

using namespace pw85_tests;

namespace {

constexpr std::size_t num_pairs = 500;
constexpr int num_threads = 16;

struct Row {
    double values[64];
};

/// Everything that the library says of a pair, in a row of numbers.
Row call_everything(Sample<double, 3> const &p)
{
    Row row{};
    double *out = row.values;
    double const *r12 = p.r12.coordinates, *q1 = p.q1.entries, *q2 = p.q2.entries;
    pw85_contact(r12, q1, q2, out);
    double const lambda = out[1];
    pw85_contact_function(r12, q1, q2, out + 2);
    pw85_contact_geometry(r12, q1, q2, lambda, out + 4, out + 7);
    pw85_contact_gradient(r12, q1, q2, lambda, out + 10, out + 13, out + 19);
    pw85_contact_torque(r12, q1, q2, lambda, out + 25, out + 28);
    pw85_closest_approach(r12, q1, q2, out + 31);
    pw85_contact_2d(r12, q1 + 3, q2 + 3, out + 32);
    pw85_closest_approach_2d(r12, q1 + 3, q2 + 3, out + 34);
    pw85__residual(lambda, r12, q1, q2, out + 35);
    pw85__cholesky_decomp(q1, out + 38);
    pw85__cholesky_solve(out + 38, r12, out + 44);
    pw85_legacy_f1(lambda, r12, q1, q2, out + 47);
    pw85_legacy_f2_derivatives(lambda, r12, q1, q2, out + 50);
    pw85_legacy_contact_function1(r12, q1, q2, out + 53);
    pw85_legacy_contact_function2(r12, q1, q2, out + 55);
    int overlap = -1;
    pw85_overlap(r12, q1, q2, &overlap);
    out[57] = overlap;
    out[58] = static_cast<double>(std::strlen(pw85_strerror(overlap)));
    pw85_spheroid(1.0, 2.0, r12, out + 58);
    return row;
}

PW85_TEST("/threads/same_bits")
{
    Random random(110);
    std::vector<Sample<double, 3>> pairs;
    std::vector<Row> expected;
    for (std::size_t i = 0; i < num_pairs; ++i)
        pairs.push_back(random_pair<3>(random, {.aspect = 100.0}));
    for (auto const &p : pairs) expected.push_back(call_everything(p));

    std::vector<std::size_t> differences(num_threads, 0);
    std::vector<std::thread> threads;
    for (std::size_t t = 0; t < num_threads; ++t)
        threads.emplace_back([&, t] {
            for (std::size_t i = 0; i < num_pairs; ++i) {
                // Each thread starts elsewhere.
                std::size_t const k = (i + t * num_pairs / num_threads) % num_pairs;
                Row const row = call_everything(pairs[k]);
                differences[t] += std::memcmp(&row, &expected[k], sizeof row) != 0;
            }
        });
    for (auto &thread : threads) thread.join();
    for (std::size_t const n : differences) g_assert_cmpuint(n, ==, 0);
}

} // namespace
