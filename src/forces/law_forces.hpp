// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Sums energy, forces, torques and virial of a law over the pairs of a neighbour list.
/// pw85_law_forces_pairs() (sums.cpp) calls sum_law().
///
/// The pairs are divided into blocks of a fixed size, for any number of threads. The threads take
/// blocks in turn, and write their derivatives into a ring of slots, which remain in the cache.
/// Each thread adds the terms of all blocks, one after the other, to its own particles
/// (forces.hpp). So the terms are added in the order of the pairs, and the bits of the sums do not
/// depend on the number of threads.
#ifndef PW85_FORCES_LAW_FORCES_HPP_INCLUDED
#define PW85_FORCES_LAW_FORCES_HPP_INCLUDED

#include <algorithm>
#include <atomic>
#include <new>
#include <thread>

#include "../base/array.hpp"
#include "../base/owner.hpp"
#include "../rows/many_pairs.hpp"
#include "../simd/lanes/derivatives.hpp"
#include "../simd/lanes/laws.hpp"
#include "../simd/lanes/overlap.hpp"
#include "forces.hpp"

namespace pw85::detail::kernels {
namespace {

/// The number of pairs per block, a multiple of the chunks of all kernels for contact functions on
/// x86. The derivatives of a block take 60 kB; several blocks fit into a second-level cache.
constexpr std::size_t law_block = 504;
static_assert(law_block <= most_listed);

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
    PairsWithForce with_force;

    PairGradients gradients() const noexcept
    {
        return {size, list, d_u, d_r12, d_rot1, d_rot2, r12};
    }
};

/// Selects the pairs that overlap, and the bad pairs, whose errors the computation of derivatives
/// reports.
inline void select_overlaps(Target const &target, NeighborList const &rows, std::size_t n,
                            LawBlock &made) noexcept
{
    compute(target, rows, n, OverlapArray{made.overlap});
    std::size_t size = 0;
    for (std::size_t k = 0; k < n; ++k) {
        std::copy_n(row_of(rows.pairs, 2, k), 2, row_of(made.pairs, 2, size));
        if (rows.images != nullptr)
            std::copy_n(row_of(rows.images, 3, k), 3, row_of(made.images, 3, size));
        size += made.overlap[k] != 0;
    }
    made.size = size;
    made.list = rows;
    made.list.pairs = made.pairs;
    if (rows.images != nullptr) made.list.images = made.images;
}

/// Computes the derivatives of a block of n pairs, and the sum of its energies. With soft
/// repulsion, pairs that do not overlap need no derivatives. The kernel needs an array for λ. It
/// gets that of the slopes, which are computed last.
template <class Law> Failure compute_block(Target const &target, NeighborList const &rows,
                                           std::size_t n, Law const &law, PairSums const &sums,
                                           LawBlock &made, double &energy) noexcept
{
    made.size = n;
    made.list = rows;
    if constexpr (std::is_same_v<Law, SoftRepulsion>) select_overlaps(target, rows, n, made);
    bool const forces = sums.forces != nullptr || sums.virial != nullptr,
               torques = sums.torques != nullptr;
    Failure const bad = compute(
        target, made.list, made.size,
        DerivativeArrays{made.mu2, made.d_u, nullptr, nullptr, forces ? made.d_r12 : nullptr,
                         torques ? made.d_rot1 : nullptr, torques ? made.d_rot2 : nullptr,
                         sums.virial != nullptr ? made.r12 : nullptr});
    LawSums const evaluated = evaluate_of<Law>(target)(law, made.size, made.mu2, made.d_u);
    energy = evaluated.energy;
    list_pairs(made.d_u, {0, made.size}, evaluated.with_force, made.with_force);
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

/// A place for the derivatives of one block at a time.
struct LawSlot {
    LawBlock made;
    Range particles; ///< a range that contains all particles of the block
    /// number of blocks that have been written into the slot
    std::atomic<std::size_t> computed = 0;
    std::atomic<std::size_t> added = 0; ///< number of blocks whose terms a thread has added
};

/// The slots, which the blocks take in turn, and the sums of all blocks.
struct LawRing {
    LawSlot *slots;
    std::size_t num_slots, threads;
    BlockSums *sums;
    std::atomic<std::size_t> taken = 0; ///< number of blocks that threads have taken

    LawSlot &slot(std::size_t number) const noexcept { return slots[number % num_slots]; }
    std::size_t round(std::size_t number) const noexcept { return number / num_slots; }

    bool is_computed(std::size_t number) const noexcept
    {
        return slot(number).computed.load(std::memory_order_acquire) > round(number);
    }

    /// Takes the next block before `end` if all threads have added the earlier blocks of its slot.
    bool take(std::size_t end, std::size_t &number) noexcept
    {
        number = taken.load(std::memory_order_relaxed);
        while (number < end &&
               slot(number).added.load(std::memory_order_acquire) == threads * round(number))
            if (taken.compare_exchange_weak(number, number + 1, std::memory_order_relaxed))
                return true;
        return false;
    }
};

/// Returns the number of slots. A thread that is delayed holds the others up only when all slots
/// are full.
constexpr std::size_t num_slots(std::size_t threads) noexcept
{
    return threads > 1 ? 8 * threads : 1;
}

/// Returns the smallest range that contains all particles of a block.
inline Range particles_of(LawBlock const &made) noexcept
{
    std::int32_t first = INT32_MAX, last = -1;
    for (std::size_t k = 0; k < 2 * made.size; ++k) {
        first = minimum(first, made.list.pairs[k]);
        last = maximum(last, made.list.pairs[k]);
    }
    return {static_cast<std::size_t>(first), static_cast<std::size_t>(last + 1)};
}

/// Computes block k of a problem, with its energy and virial.
template <class Law> Failure compute_block(LawProblem<Law> const &problem, std::size_t k,
                                           LawBlock &made, BlockSums &sums) noexcept
{
    std::size_t const pair = k * law_block;
    Failure const bad = compute_block(chosen(), problem.rows.from(pair),
                                      minimum(law_block, problem.num_pairs - pair), problem.law,
                                      problem.sums, made, sums.energy);
    std::fill_n(sums.virial, 9, 0.0);
    if (problem.sums.virial != nullptr) add_virial(made.gradients(), made.with_force, sums.virial);
    return {pair + bad.index, bad.status};
}

/// The work of one thread. It adds the terms of the next block as soon as this block is computed.
/// Otherwise it takes a block, or waits for other threads if all slots are full. In a list that is
/// sorted in space, the particles of a block belong to one thread. While this thread adds their
/// terms, the others compute.
template <class Law>
Failure sum_law(LawProblem<Law> const &problem, std::size_t thread, LawRing &ring) noexcept
{
    ForceSum const own(problem.sums, share(problem.num_particles, ring.threads, thread));
    Failure first{0, 0};
    for (std::size_t next = 0, taken = 0; next < problem.num_blocks();) {
        if (ring.is_computed(next)) {
            LawSlot &slot = ring.slot(next++);
            if (own.meets(slot.particles)) own.add(slot.made.gradients(), slot.made.with_force);
            slot.added.fetch_add(1, std::memory_order_release);
        } else if (ring.take(problem.num_blocks(), taken)) {
            LawSlot &slot = ring.slot(taken);
            first.update(compute_block(problem, taken, slot.made, ring.sums[taken]));
            slot.particles =
                ring.threads > 1 ? particles_of(slot.made) : Range{0, problem.num_particles};
            slot.computed.fetch_add(1, std::memory_order_release);
        } else {
            std::this_thread::yield();
        }
    }
    return first;
}

/// Adds the sums of all blocks, in their order.
inline void add_blocks(BlockSums const *blocks, std::size_t n, double *energy,
                       double *virial) noexcept
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

/// Returns the number of threads that share n pairs.
inline std::size_t threads_for(std::size_t n) noexcept
{
    return n > block ? minimum(most_threads(), n / law_block) : 1;
}

/// Sums in parallel, and returns the status of the first bad pair.
template <class Law> int sum_law(LawProblem<Law> const &problem, double *energy) noexcept
{
    std::size_t const threads = threads_for(problem.num_pairs), count = num_slots(threads);
    Owner<LawSlot[]> const slots(new (std::nothrow) LawSlot[count]);
    Array<BlockSums> block_sums;
    if (slots == nullptr || !block_sums.resize(problem.num_blocks()))
        return refuse(PW85_ENOMEM, "pw85_law_forces_pairs", nullptr, 0);
    LawRing ring{slots.get(), count, 1, block_sums.data()};
    Failure first{0, 0};
    in_each_thread(threads, [&] {
        ThreadNumber const team = this_thread();
#pragma omp single
        ring.threads = team.threads; // may be fewer than were asked for
        Failure const own = sum_law(problem, team.thread, ring);
#pragma omp critical(pw85_batch)
        first.update(own);
    });
    add_blocks(block_sums.data(), problem.num_blocks(), energy, problem.sums.virial);
    return refuse_first(first, [&](std::size_t n) {
        constexpr std::uint16_t row = 0;
        PairRow<3> pair;
        gather_of<NeighborList>(chosen())(problem.rows.from(n), &row, 1, &pair);
        return refuse_contact(pair);
    });
}

} // namespace
} // namespace pw85::detail::kernels

#endif
