/// @file
/// Sums energy, forces, torques and virial of a law over the pairs of a neighbour list. pw85_law_forces_pairs() (many_pairs.cpp)
/// calls sum_law().
///
/// The pairs are divided into blocks of a fixed size, for any number of threads. In each round, every thread computes the
/// derivatives of some blocks, which remain in the cache. Then it adds the terms of all blocks of the round to its own particles
/// (forces.hpp). So the terms are added in the order of the pairs, and the bits of the sums do not depend on the number of threads.
#ifndef PW85_KERNELS_LAW_FORCES_HPP_INCLUDED
#define PW85_KERNELS_LAW_FORCES_HPP_INCLUDED

#include "../neighbors/array.hpp"
#include "forces.hpp"
#include "many_pairs.hpp"

namespace pw85::detail::kernels {
namespace {

/// The number of pairs per block, a multiple of the chunks of all kernels for contact functions on x86. The derivatives of a block
/// take 60 kB, so that those of all rounds in progress fit into a second-level cache.
constexpr std::size_t law_block = 504;

/// The sums of a block.
struct BlockSums {
    double energy, virial[9];
};

/// The derivatives of the pairs of a block that have forces.
struct LawBlock {
    std::size_t size; ///< number of these pairs
    NeighborList list;
    double mu2[law_block], d_u[law_block];
    double r12[3 * law_block], d_r12[3 * law_block], d_rot1[3 * law_block], d_rot2[3 * law_block];
    std::int32_t pairs[2 * law_block], images[3 * law_block];
    unsigned char overlap[law_block];

    PairGradients gradients() const noexcept { return {size, list, d_u, d_r12, d_rot1, d_rot2, r12}; }
};

/// Selects the pairs that overlap, and the bad pairs, whose errors the computation of derivatives reports.
inline void select_overlaps(Kernels const &kernels, NeighborList const &rows, std::size_t n, LawBlock &made) noexcept
{
    compute(kernels, rows, n, OverlapArray{made.overlap});
    std::size_t size = 0;
    for (std::size_t k = 0; k < n; ++k) {
        std::copy_n(row_of(rows.pairs, 2, k), 2, row_of(made.pairs, 2, size));
        if (rows.images != nullptr) std::copy_n(row_of(rows.images, 3, k), 3, row_of(made.images, 3, size));
        size += made.overlap[k] != 0;
    }
    made.size = size;
    made.list = rows;
    made.list.pairs = made.pairs;
    if (rows.images != nullptr) made.list.images = made.images;
}

/// Computes the derivatives of a block of n pairs, and the sum of its energies. With soft repulsion, pairs that do not overlap need
/// no derivatives. The kernel needs an array for λ. It gets that of the slopes, which are computed last.
template <class Law> Failure compute_block(Kernels const &kernels, NeighborList const &rows, std::size_t n,
                                           Law const &law, PairSums const &sums, LawBlock &made,
                                           double &energy) noexcept
{
    made.size = n;
    made.list = rows;
    if constexpr (std::is_same_v<Law, SoftRepulsion>) select_overlaps(kernels, rows, n, made);
    bool const forces = sums.forces != nullptr || sums.virial != nullptr, torques = sums.torques != nullptr;
    Failure const bad = compute(kernels, made.list, made.size,
                                DerivativeArrays{made.mu2, made.d_u, nullptr, nullptr, forces ? made.d_r12 : nullptr,
                                                 torques ? made.d_rot1 : nullptr, torques ? made.d_rot2 : nullptr,
                                                 sums.virial != nullptr ? made.r12 : nullptr});
    LawKernel<Law> const &kernel = *kernels.lanes;
    energy = kernel.evaluate(law, made.size, made.mu2, made.d_u);
    return bad;
}

/// A law, the pairs, and the output arrays.
template <class Law> struct LawProblem {
    std::size_t num_pairs, num_particles;
    NeighborList const &rows;
    Law law;
    PairSums sums;

    std::size_t num_blocks() const noexcept { return (num_pairs + law_block - 1) / law_block; }
};

/// The number of blocks that each of several threads computes in a round. Threads wait for each other once in a round. A round
/// takes a tenth of a millisecond, so the waiting costs little.
constexpr std::size_t blocks_per_thread = 8;

/// The blocks of a round, in their order.
struct Round {
    std::size_t depth, threads; ///< blocks of a thread, number of threads

    std::size_t size() const noexcept { return depth * threads; }
};

/// The work of one thread. `all` has two rounds of blocks. While some threads still add the terms of a round, others compute the
/// blocks of the next one.
template <class Law> Failure sum_law(LawProblem<Law> const &problem, Round const &round, std::size_t thread,
                                     LawBlock *all, BlockSums *block_sums) noexcept
{
    Kernels const &kernels = chosen();
    ForceSum const own(problem.sums, share(problem.num_particles, round.threads, thread));
    Failure first{0, 0};
    bool odd = false;
    for (std::size_t begin = 0; begin < problem.num_blocks(); begin += round.size(), odd = !odd) {
        LawBlock *const blocks = all + (odd ? round.size() : 0);
        std::size_t const end = std::min(begin + round.size(), problem.num_blocks());
        Range const mine = {std::min(end, begin + thread * round.depth),
                            std::min(end, begin + (thread + 1) * round.depth)};
        for (std::size_t k = mine.begin; k < mine.end; ++k) {
            std::size_t const pair = k * law_block;
            Failure const bad =
                compute_block(kernels, problem.rows.from(pair), std::min(law_block, problem.num_pairs - pair),
                              problem.law, problem.sums, blocks[k - begin], block_sums[k].energy);
            first.update({pair + bad.index, bad.status});
        }
#pragma omp barrier
        for (std::size_t k = begin; k < end; ++k) {
            PairGradients const pairs = blocks[k - begin].gradients();
            bool const with_virial = problem.sums.virial != nullptr && k >= mine.begin && k < mine.end;
            own.add_part(pairs, {0, pairs.num_pairs}, with_virial ? block_sums[k].virial : nullptr);
        }
    }
    return first;
}

/// Adds the sums of all blocks, in their order.
inline void add_blocks(BlockSums const *blocks, std::size_t n, double *energy, double *virial) noexcept
{
    in_default_environment([&] {
        if (energy != nullptr) *energy = 0.0;
        if (virial != nullptr) std::fill_n(virial, 9, 0.0);
        for (std::size_t k = 0; k < n; ++k) {
            if (energy != nullptr) *energy += blocks[k].energy;
            for (int i = 0; virial != nullptr && i < 9; ++i) virial[i] += blocks[k].virial[i];
        }
    });
}

/// The number of threads that share n pairs.
inline std::size_t threads_for(std::size_t n) noexcept
{
#ifdef _OPENMP
    if (n > block) return std::min(static_cast<std::size_t>(omp_get_max_threads()), n / law_block);
#endif
    static_cast<void>(n);
    return 1;
}

/// Sums in parallel, and returns the status of the first bad pair.
template <class Law> int sum_law(LawProblem<Law> const &problem, double *energy) noexcept
{
    std::size_t const threads = threads_for(problem.num_pairs), depth = threads > 1 ? blocks_per_thread : 1;
    neighbors::Array<LawBlock> blocks;
    neighbors::Array<BlockSums> block_sums;
    if (!blocks.resize(2 * depth * threads) || !block_sums.resize(problem.num_blocks())) return PW85_ENOMEM;
    Failure first{0, 0};
#pragma omp parallel num_threads(static_cast <int>(threads)) if (threads > 1)
    {
        DefaultEnvironment const environment; // threads have their own
        auto const team = this_thread();
        Failure const own = sum_law(problem, {depth, team.threads}, team.thread, blocks.data(), block_sums.data());
#pragma omp critical(pw85_batch)
        first.update(own);
    }
    add_blocks(block_sums.data(), problem.num_blocks(), energy, problem.sums.virial);
    return first.status;
}

} // namespace
} // namespace pw85::detail::kernels

#endif
