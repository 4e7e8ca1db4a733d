// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Drives the lane kernels: it divides the rows among threads, and computes the rows that
/// lanes leave over by scalar_fallback() of the question (simd/lanes/). The files c_api/*_lanes.cpp
/// call compute_rows(), lists and simulations the functions below it.
#ifndef PW85_ROWS_MANY_PAIRS_HPP_INCLUDED
#define PW85_ROWS_MANY_PAIRS_HPP_INCLUDED

#include "../base/c_arrays.hpp"
#include "../simd/lanes.hpp"
#include "../simd/lanes/overlap.hpp"
#include "each_row.hpp"

namespace pw85::detail::kernels {
namespace {

// scalar_fallback() of a question computes a pair by the functions for one pair, writes it to the
// first row of the output arrays, and returns its status.
//
// refuse_pair() computes a pair by the function of the C API, which records the cause of a refusal,
// and returns its status. It is scalar_fallback() for questions that have none of their own.

template <class AnyTarget, class Pair, class Arrays>
int refuse_pair(AnyTarget const &target, Pair const &pair, Arrays const &out) noexcept
{
    return scalar_fallback(target, pair, out);
}

/// Rows that are read one by one. Rows of pairs are gathered.
template <class Rows>
concept SingleRows = !requires
{
    Rows::dimension;
};

/// Records the cause for row i, and returns its status.
template <class Rows, class Arrays>
int refuse_row_of(Target const &target, Rows const &rows, Arrays const &out, std::size_t i) noexcept
{
    constexpr std::uint16_t first = 0;
    PairRow<Rows::dimension> pair;
    gather_of<Rows>(target)(rows.from(i), &first, 1, &pair);
    return refuse_pair(target, pair, out.from(i));
}

template <SingleRows Rows, class Arrays>
int refuse_row_of(Target const &, Rows const &rows, Arrays const &out, std::size_t i) noexcept
{
    return scalar_fallback(rows.from(i), out.from(i));
}

/// Computes the pairs that lanes left over.
template <class Rows, class Arrays>
Failure scalar_fallback_all(Target const &target, Rows const &rows, Arrays const &out,
                            Worklist const &rejected_lanes) noexcept
{
    // with 4, common volumes of rows take more stack than pw85.h promises
    constexpr std::size_t group = 3;
    auto const gather = gather_of<Rows>(target);
    PairRow<Rows::dimension> pairs[group];
    Failure first{0, 0};
    for (std::size_t k = 0; k < rejected_lanes.size; k += group) {
        std::uint16_t const *const indices = rejected_lanes.indices + k;
        std::size_t const count = minimum(group, rejected_lanes.size - k);
        gather(rows, indices, count, pairs);
        for (std::size_t i = 0; i < count; ++i)
            first.update({indices[i], scalar_fallback(target, pairs[i], out.from(indices[i]))});
    }
    return first;
}

/// Computes the rows of other kinds that lanes left over.
template <SingleRows Rows, class Arrays>
Failure scalar_fallback_all(Target const &, Rows const &rows, Arrays const &out,
                            Worklist const &rejected_lanes) noexcept
{
    Failure first{0, 0};
    for (std::size_t k = 0; k < rejected_lanes.size; ++k) {
        std::size_t const i = rejected_lanes.indices[k];
        first.update({i, scalar_fallback(rows.from(i), out.from(i))});
    }
    return first;
}

} // namespace

/// Computes n pairs in the default floating-point environment. Questions may have one of their own.
template <class Rows, class Arrays> static Failure
compute(Target const &target, Rows const &rows, std::size_t n, Arrays const &out) noexcept
{
    auto const compute_lanes = compute_of<Rows, Arrays>(target);
    Worklist rejected_lanes;
    Failure first{0, 0};
    for (std::size_t begin = 0; begin < n;) {
        Rows const rest = rows.from(begin);
        Arrays const rest_out = out.from(begin);
        std::size_t const done = compute_lanes(rest, n - begin, rest_out, rejected_lanes);
        Failure const bad = scalar_fallback_all(target, rest, rest_out, rejected_lanes);
        first.update({begin + bad.index, bad.status});
        begin += done;
    }
    return first;
}

namespace {

/// Arrays that choose the number of rows that a thread computes at a time.
template <class Arrays>
concept ArraysWithBlock = requires
{
    Arrays::rows_of_block;
};

template <class Arrays> constexpr std::size_t rows_of_block = block;
template <ArraysWithBlock Arrays> constexpr std::size_t rows_of_block<Arrays> =
    Arrays::rows_of_block;

/// Computes n pairs in parallel, and returns the status of the first bad one.
template <class Rows, class Arrays>
int compute_all(std::size_t n, Rows const &rows, Arrays const &out) noexcept
{
    Target const &target = chosen();
    auto const compute_block = [&](Range range) {
        Failure const bad =
            compute(target, rows.from(range.begin), range.end - range.begin, out.from(range.begin));
        return Failure{range.begin + bad.index, bad.status};
    };
    Failure const first = for_blocks(n, compute_block, rows_of_block<Arrays>);
    return refuse_first(first, [&](std::size_t i) { return refuse_row_of(target, rows, out, i); });
}

/// Computes the n rows of a call, which must have all `needed` arrays. The names are those of
/// refuse_rows().
template <class Rows, class Arrays, class... Needed>
int compute_rows(char const *const (&names)[sizeof...(Needed) + 1], std::size_t n, Rows const &rows,
                 Arrays const &out, Needed *...needed) noexcept
{
    if (n == 0) return PW85_SUCCESS;
    if (n > max_rows || c_api::any_null(needed...))
        return refuse_rows(names, n, (needed == nullptr)...);
    return compute_all(n, rows, out);
}

/// The number of pairs that are tested at a time: slightly more than the neighbours of a particle
/// in a dense system.
constexpr std::size_t any_chunk_size = 32;

/// Finds the first pair that overlaps or is bad, and sets `any` to 1, or 0 if there is none. For a
/// bad pair it sets `any` to -1 and returns the status of the pair.
template <class Rows> int find_overlap(Rows const &rows, std::size_t n, int &any) noexcept
{
    Target const &target = chosen();
    unsigned char answers[any_chunk_size];
    for (std::size_t begin = 0; begin < n; begin += any_chunk_size) {
        std::size_t const count = minimum(any_chunk_size, n - begin);
        Failure const bad = compute(target, rows.from(begin), count, OverlapArray{answers});
        std::size_t found = 0;
        while (found < count && answers[found] == 0) ++found;
        if (found == count) continue;
        any = answers[found] == 1 ? 1 : -1;
        if (any == 1) return PW85_SUCCESS;
        return refuse_first({begin + bad.index, bad.status}, [&](std::size_t i) {
            return refuse_row_of(target, rows, OverlapArray{answers}, i);
        });
    }
    any = 0;
    return PW85_SUCCESS;
}

} // namespace
} // namespace pw85::detail::kernels

#endif
