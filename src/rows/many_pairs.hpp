// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Drives the lane kernels: it divides the pairs among threads, and computes the pairs that lanes
/// leave over by the function for one pair. The files of this folder and lists/lists.cpp call
/// compute_all() and find_overlap().
#ifndef PW85_ROWS_MANY_PAIRS_HPP_INCLUDED
#define PW85_ROWS_MANY_PAIRS_HPP_INCLUDED

#include <algorithm>
#include <cmath>

#include <pw85.h>

#include "../simd/lanes.hpp"
#include "../simd/one_pair.hpp"
#include "each_row.hpp"

namespace pw85::detail::kernels {
namespace {

// scalar_fallback() computes a pair by the functions for one pair, writes it to the first row of
// the output arrays, and returns its status.

template <int D>
int scalar_fallback(Target const &target, PairRow<D> const &pair, ContactArrays const &out) noexcept
{
    double contact[2];
    int const status = (D == 3 ? PW85_OF_PAIR(target, contact) : pw85_contact_2d)(pair.r12, pair.q1,
                                                                                  pair.q2, contact);
    *out.mu2 = contact[0];
    if (out.lambda != nullptr) *out.lambda = contact[1];
    return status;
}

template <int D>
int scalar_fallback(Target const &target, PairRow<D> const &pair, OverlapArray const &out) noexcept
{
    int overlap = -1; // stays where the pair is bad, and becomes 255
    int const status = (D == 3 ? PW85_OF_PAIR(target, overlap)
                               : pw85_overlap_2d)(pair.r12, pair.q1, pair.q2, &overlap);
    *out.overlap = static_cast<unsigned char>(overlap);
    return status;
}

/// A template of what is not used, for the same reason as that for DistanceArrays below.
template <class AnyTarget>
int scalar_fallback(AnyTarget const &, PairRow<2> const &pair, AreaArray const &out) noexcept
{
    return pw85_overlap_area_2d(pair.r12, pair.q1, pair.q2, out.area);
}

inline int scalar_fallback(Target const &target, PairRow<3> const &pair,
                           ApproachArray const &out) noexcept
{
    return PW85_OF_PAIR(target, closest_approach)(pair.r12, pair.q1, pair.q2, out.distance);
}

/// A template of what chooses the function, so that the part `contact` does not refer to the part
/// `geometry` without optimisation either.
template <class AnyTarget> int scalar_fallback(AnyTarget const &target, PairRow<3> const &pair,
                                               DistanceArrays const &out) noexcept
{
    return PW85_OF_PAIR(target, distance)(pair.r12, pair.q1, pair.q2, out.distance, out.point1,
                                          out.point2);
}

inline int scalar_fallback(Target const &, PairRow<3> const &pair,
                           PassageArrays const &out) noexcept
{
    double t;
    int const status =
        pw85_closest_passage(pair.r12, pair.q1, pair.q2, out.velocities, out.t_max, out.mu2, &t);
    if (out.t != nullptr) *out.t = t;
    return status;
}

inline int scalar_fallback(Target const &, PairRow<3> const &pair, GrainArrays const &out) noexcept
{
    return pw85_grain_contact(pair.r12, pair.q1, pair.q2, out.starts, out.normal, out.depth,
                              out.point, out.curvatures, out.radius);
}

/// Only the contact function decides the status: a concentric pair is valid, although it has no
/// normal. If λ is NaN, the derivatives are NaN too.
inline int scalar_fallback(Target const &target, PairRow<3> const &pair,
                           DerivativeArrays const &out) noexcept
{
    auto const &[r12, q1, q2] = pair;
    int status = 0;
    if (out.r12 != nullptr) std::copy_n(r12, 3, out.r12);
    if (std::isnan(*out.lambda)) {
        double contact[2];
        status = PW85_OF_PAIR(target, contact)(r12, q1, q2, contact);
        if (out.mu2 != nullptr) *out.mu2 = contact[0];
        *out.lambda = contact[1];
    }
    PW85_OF_PAIR(target, contact_geometry)(r12, q1, q2, *out.lambda, out.point, out.normal);
    PW85_OF_PAIR(target, contact_gradient)(r12, q1, q2, *out.lambda, out.d_r12, nullptr, nullptr);
    PW85_OF_PAIR(target, contact_torque)(r12, q1, q2, *out.lambda, out.d_rot1, out.d_rot2);
    return status;
}

inline int scalar_fallback(SetRows<Segments> const &row, SetContactArrays const &out) noexcept
{
    return pw85_contact_segment(row.points[0], row.points[1], row.q, out.mu2, out.point);
}

inline int scalar_fallback(SetRows<Triangles> const &row, SetContactArrays const &out) noexcept
{
    return pw85_contact_triangle(row.points[0], row.points[1], row.points[2], row.q, out.mu2,
                                 out.point);
}

inline int scalar_fallback(SetRows<Boxes> const &row, SetContactArrays const &out) noexcept
{
    return pw85_contact_box(row.points[0], row.points[1], row.q, out.mu2, out.point);
}

inline int overlap_of_one(SetRows<Segments> const &row, int *overlap) noexcept
{
    return pw85_overlap_segment(row.points[0], row.points[1], row.q, overlap);
}

inline int overlap_of_one(SetRows<Triangles> const &row, int *overlap) noexcept
{
    return pw85_overlap_triangle(row.points[0], row.points[1], row.points[2], row.q, overlap);
}

inline int overlap_of_one(SetRows<Boxes> const &row, int *overlap) noexcept
{
    return pw85_overlap_box(row.points[0], row.points[1], row.q, overlap);
}

template <class Set> int scalar_fallback(SetRows<Set> const &row, OverlapArray const &out) noexcept
{
    int overlap = -1;
    int const status = overlap_of_one(row, &overlap);
    *out.overlap = static_cast<unsigned char>(overlap); // -1, for a bad row, becomes 255
    return status;
}

inline int scalar_fallback(SetRows<Lines> const &row, ChordArrays const &out) noexcept
{
    double t[2];
    int const status = pw85_intersect_line(row.points[0], row.points[1], row.q, t);
    if (out.enter != nullptr) *out.enter = t[0];
    if (out.leave != nullptr) *out.leave = t[1];
    return status;
}

// refuse_pair() computes a pair by the function of the C API, which records the cause of a refusal,
// and returns its status. That of the others is scalar_fallback().

template <class AnyTarget, class Pair, class Arrays>
int refuse_pair(AnyTarget const &target, Pair const &pair, Arrays const &out) noexcept
{
    return scalar_fallback(target, pair, out);
}

inline int refuse_contact(PairRow<3> const &pair) noexcept
{
    double contact[2];
    return pw85_contact(pair.r12, pair.q1, pair.q2, contact);
}

inline int refuse_pair(Target const &, PairRow<3> const &pair, ContactArrays const &) noexcept
{
    return refuse_contact(pair);
}

inline int refuse_pair(Target const &, PairRow<3> const &pair, DerivativeArrays const &) noexcept
{
    return refuse_contact(pair);
}

inline int refuse_pair(Target const &, PairRow<3> const &pair, OverlapArray const &) noexcept
{
    int overlap;
    return pw85_overlap(pair.r12, pair.q1, pair.q2, &overlap);
}

/// A template for the same reason as scalar_fallback() for DistanceArrays.
template <class AnyTarget>
int refuse_pair(AnyTarget const &, PairRow<3> const &pair, DistanceArrays const &) noexcept
{
    return pw85_distance(pair.r12, pair.q1, pair.q2, nullptr, nullptr, nullptr);
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

/// The kernels' rows have directions of length one, which are NaN for zero vectors.
inline int refuse_row_of(Target const &, Directions const &rows, ApproachArray const &,
                         std::size_t i) noexcept
{
    auto const row = rows.arrays.from(i);
    double distance;
    return pw85_closest_approach(row.r12, row.q1, row.q2, &distance);
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
    // with 5, overlaps of lists take more stack in AVX-512 than pw85.h promises
    constexpr std::size_t group = 4;
    auto const gather = gather_of<Rows>(target);
    PairRow<Rows::dimension> pairs[group];
    Failure first{0, 0};
    for (std::size_t k = 0; k < rejected_lanes.size; k += group) {
        std::uint16_t const *const indices = rejected_lanes.indices + k;
        std::size_t const count = std::min(group, rejected_lanes.size - k);
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

/// Computes n pairs in the default floating-point environment.
template <class Rows, class Arrays>
Failure compute(Target const &target, Rows const &rows, std::size_t n, Arrays const &out) noexcept
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

/// Derivatives need an array for λ. If the caller gives none, the pairs are computed in parts with
/// an array on the stack.
template <class Rows> Failure compute(Target const &target, Rows const &rows, std::size_t n,
                                      DerivativeArrays const &out) noexcept
{
    if (out.lambda != nullptr) return compute<Rows, DerivativeArrays>(target, rows, n, out);
    constexpr std::size_t part_size = 128;
    double lambda[part_size];
    Failure first{0, 0};
    for (std::size_t begin = 0; begin < n; begin += part_size) {
        DerivativeArrays part = out.from(begin);
        part.lambda = lambda;
        Failure const bad = compute<Rows, DerivativeArrays>(target, rows.from(begin),
                                                            std::min(part_size, n - begin), part);
        first.update({begin + bad.index, bad.status});
    }
    return first;
}

/// Computes n pairs in parallel, up to `pairs_of_block` of them by a thread at a time, and returns
/// the status of the first bad one.
template <class Rows, class Arrays> int compute_all(std::size_t n, Rows const &rows,
                                                    Arrays const &out,
                                                    std::size_t pairs_of_block = block) noexcept
{
    Target const &target = chosen();
    auto const compute_block = [&](Range range) {
        Failure const bad =
            compute(target, rows.from(range.begin), range.end - range.begin, out.from(range.begin));
        return Failure{range.begin + bad.index, bad.status};
    };
    Failure const first = for_blocks(n, compute_block, pairs_of_block);
    return refuse_first(first, [&](std::size_t i) { return refuse_row_of(target, rows, out, i); });
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
        std::size_t const count = std::min(any_chunk_size, n - begin);
        Failure const bad = compute(target, rows.from(begin), count, OverlapArray{answers});
        unsigned char const *const found =
            std::find_if(answers, answers + count, [](int x) { return x != 0; });
        if (found == answers + count) continue;
        any = *found == 1 ? 1 : -1;
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
