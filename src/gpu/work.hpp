// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The work of one thread of a device. It runs the search and the overlap tiers of the headers for
/// one pair at a time, in two stages. device.cpp calls it on a device; the tests call it on the
/// host.
///
/// The first stage is enough for almost all pairs, and the threads of a block take the same
/// branches. It lists the other pairs, and the second stage computes them by slower methods.
/// Overlaps that are undecided even then, and pairs that are not valid, are posted to the host,
/// which computes them by pw85_overlap_batch(). Only fetch_and_increment() differs between devices.
#ifndef PW85_GPU_WORK_HPP_INCLUDED
#define PW85_GPU_WORK_HPP_INCLUDED

// Device code has no C headers, and no functions of the host.
#define PW85_FOR_DEVICES

#include <pw85/contact/geometry.hpp>
#include <pw85/overlap/overlap.hpp>

#include "../simd/lanes/derivatives.hpp"
#include "../simd/lanes/overlap.hpp"
#include "rows.hpp"

namespace pw85::detail::gpu {

using kernels::ContactArrays;
using kernels::DerivativeArrays;
using kernels::OverlapArray;

/// The largest number of pairs of a launch. Lists of them have 32-bit indices, and take little
/// memory beside the caller's arrays.
inline constexpr std::size_t chunk_size = std::size_t{1} << 23;

/// The list of the pairs that the first stage leaves to the second one, in any order.
struct Remainder {
    std::uint32_t *count, *indices;
};

/// Increments a counter that all threads share, and returns its previous value.
PW85_FUNCTION inline std::uint32_t fetch_and_increment(std::uint32_t *count) noexcept
{
#ifdef __NVCC__
    return atomicAdd(count, 1u);
#else
    return __atomic_fetch_add(count, 1u, __ATOMIC_RELAXED);
#endif
}

/// Pairs that the host computes.
struct Mailbox {
    std::uint32_t *count, *indices; ///< number of these pairs, and their indices in the output
    double *r12, *q1, *q2;          ///< their rows
    unsigned char *results;         ///< their overlaps, which the host writes
};

PW85_FUNCTION inline void store(Vector<double, 3> const &x, double *rows, std::size_t i) noexcept
{
    for (std::size_t d = 0; rows != nullptr && d < 3; ++d) rows[3 * i + d] = x[static_cast<int>(d)];
}

PW85_FUNCTION inline void store(double x, double *rows, std::size_t i) noexcept
{
    if (rows != nullptr) rows[i] = x;
}

/// Returns the search on the rational form. Use the result only if it is certain.
PW85_FUNCTION inline LastEvaluation<double> search_rationally(Pair3 const &pair) noexcept
{
    auto search = start_search(pair);
    run(search, pair, max_rational_steps);
    auto last = last_evaluation(pair, search.candidate);
    last.certified = is_accepted(pair, last);
    return last;
}

// attempt() is the first stage for one pair. It returns whether the pair is done.

PW85_FUNCTION inline bool attempt(ContactArrays const &out, Pair3 const &pair,
                                  std::size_t i) noexcept
{
    auto const last = search_rationally(pair);
    store(last.value.mu2, out.mu2, i);
    store(last.value.lambda, out.lambda, i);
    return last.certified;
}

// fallback() is the second stage for one pair. It returns false if the host must compute the pair.

PW85_FUNCTION inline bool fallback(ContactArrays const &out, Pair3 const &pair,
                                   std::size_t i) noexcept
{
    auto const c = contact(pair.r12, pair.q1, pair.q2);
    store(c.mu2, out.mu2, i);
    store(c.lambda, out.lambda, i);
    return true;
}

PW85_FUNCTION inline bool store(Decision decision, OverlapArray const &out, std::size_t i) noexcept
{
    if (decision == Decision::none) return false;
    out.overlap[i] = decision == Decision::overlap;
    return true;
}

PW85_FUNCTION inline bool attempt(OverlapArray const &out, Pair3 const &pair,
                                  std::size_t i) noexcept
{
    return store(decide_by_quartic(pair.r12, pair.q1, pair.q2), out, i);
}

PW85_FUNCTION inline bool fallback(OverlapArray const &out, Pair3 const &pair,
                                   std::size_t i) noexcept
{
    return store(decide_near_contact(pair).decision, out, i);
}

PW85_FUNCTION inline bool attempt(DerivativeArrays const &out, Pair3 const &pair,
                                  std::size_t i) noexcept
{
    auto const last = search_rationally(pair);
    double const lambda = last.value.lambda;
    auto const [at, accurate] = fast_tangency(pair, lambda);
    auto const gradients = rotation_gradients(at, pair.q1, pair.q2);
    store(last.value.mu2, out.mu2, i);
    store(lambda, out.lambda, i);
    store(tangency_point(at, pair.q1), out.point, i);
    store(tangency_normal(at), out.normal, i);
    store(separation_gradient(at), out.d_r12, i);
    store(gradients.first, out.d_rot1, i);
    store(gradients.second, out.d_rot2, i);
    return last.certified && accurate;
}

/// A concentric pair is valid, although it has no normal.
PW85_FUNCTION inline bool fallback(DerivativeArrays const &out, Pair3 const &pair,
                                   std::size_t i) noexcept
{
    auto const c = contact(pair.r12, pair.q1, pair.q2);
    store(c.mu2, out.mu2, i);
    store(c.lambda, out.lambda, i);
    auto const geometry = contact_geometry(pair.r12, pair.q1, pair.q2, c.lambda);
    store(geometry.point, out.point, i);
    store(geometry.normal, out.normal, i);
    store(contact_gradient(pair.r12, pair.q1, pair.q2, c.lambda).r12, out.d_r12, i);
    auto const torque = contact_torque(pair.r12, pair.q1, pair.q2, c.lambda);
    store(torque.rotation1, out.d_rot1, i);
    store(torque.rotation2, out.d_rot2, i);
    return true;
}

/// The first stage of `size` pairs. Each block of threads computes block_size of them.
template <class Rows, class Out> struct Attempt {
    Rows rows;
    Out out;
    std::uint32_t size;
    Remainder rest;
};

PW85_FUNCTION inline std::size_t block_count(std::size_t size, std::size_t begin) noexcept
{
    return size - begin < block_size ? size - begin : block_size;
}

/// The first step of a thread in the first stage. Then the threads of its block synchronize.
template <class Rows, class Out> PW85_FUNCTION inline void
load_tile(Attempt<Rows, Out> const &work, Tile &tile, std::size_t block, unsigned thread) noexcept
{
    std::size_t const begin = block * block_size;
    load_tile(tile, work.rows, begin, block_count(work.size, begin), thread);
}

/// The addresses to which a thread writes the results of pair i: the output arrays.
template <class Out>
PW85_FUNCTION inline Out destination(Out const &out, Tile &, unsigned, std::size_t i) noexcept
{
    return out.from(i);
}

PW85_FUNCTION inline double *destination(double const *wanted, double *here) noexcept
{
    return wanted == nullptr ? nullptr : here;
}

/// Derivatives that are numbers go to the output arrays. Derivatives that are vectors go to the
/// thread's own row of the tile, from which the thread has already loaded its pair.
PW85_FUNCTION inline DerivativeArrays destination(DerivativeArrays const &out, Tile &tile,
                                                  unsigned thread, std::size_t i) noexcept
{
    DerivativeArrays const here = out.from(i);
    double *const row = tile.row(thread);
    return {here.mu2,
            here.lambda,
            destination(out.point, row),
            destination(out.normal, row + 3),
            destination(out.d_r12, row + 6),
            destination(out.d_rot1, row + 9),
            destination(out.d_rot2, row + 12)};
}

/// The second step of a thread in the first stage.
template <class Rows, class Out> PW85_FUNCTION inline void
attempt(Attempt<Rows, Out> const &work, Tile &tile, std::size_t block, unsigned thread) noexcept
{
    std::size_t const begin = block * block_size;
    if (thread >= block_count(work.size, begin)) return;
    auto const index = static_cast<std::uint32_t>(begin + thread);
    Pair3 const pair = load(tile, work.rows, begin, thread);
    if (!attempt(destination(work.out, tile, thread, index), pair, 0))
        work.rest.indices[fetch_and_increment(work.rest.count)] = index;
}

/// True if results go through the tile. Then the threads of a block synchronize again before
/// store_tile().
template <class Out> inline constexpr bool is_staged = false;
template <> inline constexpr bool is_staged<DerivativeArrays> = true;

template <class Rows, class Out> PW85_FUNCTION inline void
store_tile(Attempt<Rows, Out> const &, Tile const &, std::size_t, unsigned) noexcept
{
}

template <class Rows>
PW85_FUNCTION inline void store_tile(Attempt<Rows, DerivativeArrays> const &work, Tile const &tile,
                                     std::size_t block, unsigned thread) noexcept
{
    std::size_t const begin = block * block_size, count = block_count(work.size, begin);
    DerivativeArrays const out = work.out.from(begin);
    copy_from_tile(tile, 0, out.point, count, thread);
    copy_from_tile(tile, 3, out.normal, count, thread);
    copy_from_tile(tile, 6, out.d_r12, count, thread);
    copy_from_tile(tile, 9, out.d_rot1, count, thread);
    copy_from_tile(tile, 12, out.d_rot2, count, thread);
}

/// The second stage. It has the pairs of the list `rest`, and the mailbox for pairs that the host
/// must compute.
template <class Rows, class Out> struct Fallback {
    Rows rows;
    Out out;
    Remainder rest;
    Mailbox mailbox;
};

/// Posts a pair to the host.
PW85_FUNCTION inline void post_request(Mailbox const &mailbox, std::uint32_t index,
                                       Pair3 const &pair) noexcept
{
    std::size_t const k = fetch_and_increment(mailbox.count);
    mailbox.indices[k] = index;
    store(pair.r12, mailbox.r12, k);
    for (std::size_t e = 0; e < 6; ++e) {
        mailbox.q1[6 * k + e] = pair.q1[static_cast<int>(e)];
        mailbox.q2[6 * k + e] = pair.q2[static_cast<int>(e)];
    }
}

/// The work of one of `threads` threads in the second stage.
template <class Rows, class Out> PW85_FUNCTION inline void
fallback(Fallback<Rows, Out> const &work, std::size_t thread, std::size_t threads) noexcept
{
    std::size_t const count = *work.rest.count;
    for (std::size_t k = thread; k < count; k += threads) {
        std::uint32_t const index = work.rest.indices[k];
        Pair3 const pair = load(work.rows, index);
        if (!fallback(work.out, pair, index)) post_request(work.mailbox, index, pair);
    }
}

/// Copies the results of the host to the output array.
struct Deliver {
    Mailbox mailbox;
    OverlapArray out;
};

PW85_FUNCTION inline void deliver(Deliver const &work, std::size_t thread,
                                  std::size_t threads) noexcept
{
    std::size_t const count = *work.mailbox.count;
    for (std::size_t k = thread; k < count; k += threads)
        work.out.overlap[work.mailbox.indices[k]] = work.mailbox.results[k];
}

// X(rows, out, name) for each combination of rows and outputs for which there is a program.
#define PW85_GPU_KERNELS(X)                                                                        \
    X(Pairs, ContactArrays, contact_batch)                                                         \
    X(Pairs, OverlapArray, overlap_batch)                                                          \
    X(Pairs, DerivativeArrays, derivatives_batch)                                                  \
    X(DeviceList, ContactArrays, contact_pairs)                                                    \
    X(DeviceList, OverlapArray, overlap_pairs)                                                     \
    X(DeviceList, DerivativeArrays, derivatives_pairs)

} // namespace pw85::detail::gpu

#endif
