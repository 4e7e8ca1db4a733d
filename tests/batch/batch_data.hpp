// SPDX-License-Identifier: BSD-3-Clause
// Pairs in arrays for the batch functions, and the results of these.
#ifndef PW85_TESTS_BATCH_DATA_HPP_INCLUDED
#define PW85_TESTS_BATCH_DATA_HPP_INCLUDED

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include <pw85_batch.h>

#include "../random_pairs.hpp"

namespace pw85_tests {

using Pair3 = Sample<double, 3>;

/// What a batch gives back; compared bit by bit.
struct BatchResult {
    std::vector<double> mu2, lambda;
    std::vector<unsigned char> overlap;
    int contact_status, overlap_status;

    bool same_row(std::size_t i, BatchResult const &other, std::size_t j) const
    {
        return std::memcmp(&mu2[i], &other.mu2[j], sizeof(double)) == 0 &&
               std::memcmp(&lambda[i], &other.lambda[j], sizeof(double)) == 0 &&
               overlap[i] == other.overlap[j];
    }
};

/// Runs both batch functions on rows first, first + 1 ... of a vector of pairs.
inline BatchResult run_batch(std::vector<Pair3> const &pairs, std::size_t first, std::size_t n)
{
    std::vector<double> r12(3 * n), q1(6 * n), q2(6 * n);
    for (std::size_t i = 0; i < n; ++i) {
        Pair3 const &p = pairs[first + i];
        std::memcpy(r12.data() + 3 * i, p.r12.coordinates, sizeof p.r12);
        std::memcpy(q1.data() + 6 * i, p.q1.entries, sizeof p.q1);
        std::memcpy(q2.data() + 6 * i, p.q2.entries, sizeof p.q2);
    }
    BatchResult result{std::vector<double>(n), std::vector<double>(n),
                       std::vector<unsigned char>(n), 0, 0};
    result.contact_status = pw85_contact_batch(n, r12.data(), q1.data(), q2.data(),
                                               result.mu2.data(), result.lambda.data());
    result.overlap_status =
        pw85_overlap_batch(n, r12.data(), q1.data(), q2.data(), result.overlap.data());
    return result;
}

inline BatchResult run_batch(std::vector<Pair3> const &pairs)
{
    return run_batch(pairs, 0, pairs.size());
}

/// A pair that is easy (aspect up to 10), hard (up to 1e6, nearly tangent, sizes far apart), out of
/// the ordinary range, concentric, or invalid in one way or another.
inline Pair3 mixed_pair(Random &random)
{
    double const kind = random.uniform(0.0, 1.0);
    Pair3 p = random_pair<3>(
        random, {.aspect = kind < 0.5 ? 10.0 : 1e6, .size_ratio = kind < 0.7 ? 2.0 : 1e6});
    if (kind < 0.7) return p;
    double const scale = kind < 0.75 ? 0x1p300 : kind < 0.8 ? 0x1p-300 : 1.0;
    p.r12 = scale * p.r12;
    for (int k = 0; k < 6; ++k) {
        p.q1[k] *= scale * scale;
        p.q2[k] *= scale * scale;
    }
    int const place = static_cast<int>(random.uniform(0.0, 6.0));
    if (kind > 0.95)
        (kind > 0.975 ? p.q1 : p.q2)[place] = std::numeric_limits<double>::quiet_NaN();
    else if (kind > 0.93)
        p.r12[place / 2] = kind > 0.94 ? HUGE_VAL : std::numeric_limits<double>::quiet_NaN();
    else if (kind > 0.9)
        (kind > 0.915 ? p.q1 : p.q2)[0] *= -1.0;
    else if (kind > 0.87)
        p.r12 = {0.0, 0.0, 0.0};
    return p;
}

inline std::vector<Pair3> mixed_pairs(Random &random, std::size_t n)
{
    std::vector<Pair3> pairs(n);
    for (Pair3 &p : pairs) p = mixed_pair(random);
    return pairs;
}

/// The same lattice by other vectors: `count` times a multiple of up to ±4 of one vector is added
/// to another.
template <class Cell> Cell skew(Random &random, Cell cell, int count)
{
    for (int n = 0; n < count; ++n) {
        auto const i = static_cast<std::size_t>(random.uniform(0.0, 3.0));
        std::size_t const j = (i + (random.uniform(0.0, 1.0) < 0.5 ? 1 : 2)) % 3;
        double const multiple = std::round(random.uniform(-4.0, 4.0));
        for (int d = 0; d < 3; ++d) cell[i][d] += multiple * cell[j][d];
    }
    return cell;
}

} // namespace pw85_tests

#endif
