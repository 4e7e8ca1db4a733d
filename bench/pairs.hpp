// Blocks of random pairs that stay in the cache.
#ifndef PW85_BENCH_PAIRS_HPP_INCLUDED
#define PW85_BENCH_PAIRS_HPP_INCLUDED

#include <vector>

#include <random_pairs.hpp>

namespace pw85_bench {

/// A pair with the maximiser, for the functions that take it.
struct BenchPair {
    pw85_tests::Sample<double, 3> pair;
    double lambda;
};

inline constexpr int block_size = 4096;

/// Pairs of general ellipsoids of the given aspect ratio (the middle semi-axis log-uniform between the others), of sizes
/// within a factor of 2; μ² is log-uniform from 1/4 to 4, so that half of them overlap.
inline std::vector<BenchPair> make_block(double aspect)
{
    pw85_tests::Random random(static_cast<std::uint64_t>(aspect));
    std::vector<BenchPair> block;
    while (block.size() < block_size) {
        pw85_tests::Sample<double, 3> p{random.direction<3>(), random.form(1.0, aspect),
                                        random.form(random.log_uniform(0.5, 2.0), aspect)};
        double const mu2 = pw85::contact(p.r12, p.q1, p.q2).mu2;
        p.r12 = pw85::times(std::sqrt(random.log_uniform(0.25, 4.0) / mu2), p.r12);
        block.push_back({p, pw85::contact(p.r12, p.q1, p.q2).lambda});
    }
    return block;
}

} // namespace pw85_bench

#endif
