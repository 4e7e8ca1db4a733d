// SPDX-License-Identifier: BSD-3-Clause
// Makes blocks of random pairs that fit into the cache, as arguments of the functions of one pair
// and of many. The programs that measure times use them.
#ifndef PW85_BENCH_PAIRS_HPP_INCLUDED
#define PW85_BENCH_PAIRS_HPP_INCLUDED

#include <cstring>
#include <vector>

#include <random_pairs.hpp>

namespace pw85_bench {

using Pair = pw85_tests::Sample<double, 3>;

inline constexpr int block_size = 4096;

/// Pairs of general ellipsoids of one aspect ratio (the middle semi-axis log-uniform between the
/// others), of sizes within a factor of 2; half of them overlap. μ² is log-uniform from 1/4 to 4,
/// or |μ² - 1| as given.
inline std::vector<Pair> random_block(double aspect, double excess = 0.0, int size = block_size)
{
    pw85_tests::Random random(static_cast<std::uint64_t>(aspect));
    pw85_tests::PairOptions options{
        .aspect = aspect, .mu2_min = 0.25, .mu2_max = 4.0, .aspect_min = aspect};
    std::vector<Pair> block;
    for (int i = 0; i < size; ++i) {
        if (excess > 0.0)
            options.mu2_min = options.mu2_max = i % 2 == 0 ? 1.0 - excess : 1.0 + excess;
        block.push_back(pw85_tests::random_pair<3>(random, options));
    }
    return block;
}

/// A block of pairs with their maximisers, for the functions that take λ, and in contiguous arrays,
/// for the batch functions.
struct Block {
    std::vector<Pair> pairs;
    std::vector<double> lambdas, r12, q1, q2, mu2, lambda, point1, point2;
    std::vector<double> apart; ///< separations multiplied by two, at which no pair overlaps
    /// towards the other ellipsoid, and half as fast in a random direction
    std::vector<double> velocity;
    std::vector<unsigned char> overlap;

    explicit Block(std::vector<Pair> const &block)
        : pairs(block), lambdas(size()), r12(3 * size()), q1(6 * size()), q2(6 * size()),
          mu2(size()), lambda(size()), point1(3 * size()), point2(3 * size()), apart(3 * size()),
          velocity(3 * size()), overlap(size())
    {
        pw85_tests::Random random(85);
        for (std::size_t i = 0; i < size(); ++i) {
            Pair const &p = pairs[i];
            lambdas[i] = pw85::contact(p.r12, p.q1, p.q2).lambda;
            std::memcpy(&r12[3 * i], p.r12.coordinates, sizeof p.r12);
            auto const aside = 0.5 * pw85::detail::magnitude(p.r12) * random.direction<3>();
            for (int d = 0; d < 3; ++d) {
                std::size_t const k = 3 * i + static_cast<std::size_t>(d);
                apart[k] = 2.0 * p.r12[d];
                velocity[k] = aside[d] - p.r12[d];
            }
            std::memcpy(&q1[6 * i], p.q1.entries, sizeof p.q1);
            std::memcpy(&q2[6 * i], p.q2.entries, sizeof p.q2);
        }
    }

    std::size_t size() const { return pairs.size(); }
};

} // namespace pw85_bench

#endif
