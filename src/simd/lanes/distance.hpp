// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The distances of many pairs, one pair per lane. The kernel drives the search of
/// distance/normal_search.hpp by the polynomials.
///
/// A slab between two ellipsoids that is wider than its rounding error proves that they are apart.
/// A pair is left over in three cases: no such slab is found, because the ellipsoids overlap or
/// nearly touch; the pair fails the fast checks; or the closest points are not accurate.
#ifndef PW85_SIMD_LANES_DISTANCE_HPP_INCLUDED
#define PW85_SIMD_LANES_DISTANCE_HPP_INCLUDED

#include "../pairs.hpp"
#include "../targets.hpp"
#include "../worklist.hpp"

namespace pw85::detail::kernels {

/// Distances, closest points and normals. Any pointer may be null.
struct DistanceArrays {
    double *distance, *point1, *point2, *normal = nullptr;

    [[gnu::always_inline]] DistanceArrays from(std::size_t begin) const noexcept
    {
        return {row_or_null(distance, 1, begin), row_or_null(point1, 3, begin),
                row_or_null(point2, 3, begin), row_or_null(normal, 3, begin)};
    }
};

/// Computes the distances of the pairs in a list whose last pack is filled (pad()). Those that are
/// not certain are left over, and nothing is written for them.
using ListedDistances = void(PairArrays<3> const &, std::uint16_t const *indices, std::size_t count,
                             DistanceArrays const &, Worklist &rejected_lanes) noexcept;

#define PW85_DECLARE_LISTED_DISTANCES(target, one_pair, lanes256, available)                       \
    namespace target {                                                                             \
    ListedDistances listed_distances;                                                              \
    }
PW85_EACH_TARGET(PW85_DECLARE_LISTED_DISTANCES)
#undef PW85_DECLARE_LISTED_DISTANCES

} // namespace pw85::detail::kernels

#ifdef PW85_KERNEL
#include <pw85/distance/distance.hpp>

namespace pw85::detail {
namespace {

PW85_INLINE DistancePair<Pack, 3> with_units(LanePair<3> const &pair) noexcept
{
    return {pair.r12, pair.q1, pair.q2, Pack(1.0), Pack(1.0)};
}

/// Stores the distances, closest points and normals of consecutive pairs. In `d`, point 2 is
/// relative to its own centre.
PW85_INLINE void store_distances(Distance<Pack, 3> const &d, Vector<Pack, 3> const &r12,
                                 std::size_t first, std::size_t left,
                                 kernels::DistanceArrays const &out) noexcept
{
    if (out.distance != nullptr) store_lanes(d.distance, left, out.distance + first);
    if (out.point1 != nullptr) store_rows(d.point1, left, out.point1 + 3 * first);
    Vector<Pack, 3> point2;
    for (int i = 0; i < 3; ++i) point2[i] = r12[i] - d.point2[i];
    if (out.point2 != nullptr) store_rows(point2, left, out.point2 + 3 * first);
    if (out.normal != nullptr) store_rows(d.normal, left, out.normal + 3 * first);
}

/// Stores distances, points and normals of the lanes of some bits in the rows of a list.
PW85_INLINE void scatter_distances(Distance<Pack, 3> const &d, Vector<Pack, 3> const &r12,
                                   unsigned bits, std::uint16_t const *indices,
                                   kernels::DistanceArrays const &out) noexcept
{
    for_lanes(bits, [&](unsigned i) {
        std::size_t const row = indices[i];
        if (out.distance != nullptr) out.distance[row] = d.distance[i];
        for (int k = 0; k < 3; ++k) {
            if (out.point1 != nullptr) kernels::row_of(out.point1, 3, row)[k] = d.point1[k][i];
            if (out.point2 != nullptr)
                kernels::row_of(out.point2, 3, row)[k] = r12[k][i] - d.point2[k][i];
            if (out.normal != nullptr) kernels::row_of(out.normal, 3, row)[k] = d.normal[k][i];
        }
    });
}

/// Takes the last step of a search, calls store(distances), and returns the lanes that are certain.
/// Both points are relative to their own centres.
template <class Store> PW85_INLINE PackMask finish_search(LanePair<3> const &pair,
                                                          Multipliers<Pack> const &x,
                                                          Store const &store) noexcept
{
    auto const last = take_last_step(with_units(pair), x);
    auto const slab = accurate_slab_along(with_units(pair), last.u);
    store(distance_across(slab)); // before the tests: registers
    return last.found && passes_fast_checks(pair) && is_wide(with_units(pair), slab) &&
           is_accurate(with_units(pair), slab);
}

/// Computes the distances of a chunk. scalar_fallback() overwrites those that are not certain.
template <class Rows> PW85_INLINE void compute_chunk(Rows const &rows, Chunk const &chunk,
                                                     kernels::DistanceArrays const &out,
                                                     kernels::Worklist &rejected_lanes) noexcept
{
    LanePair<3> pairs[packs_per_chunk];
    NormalSearch<Pack> searches[packs_per_chunk];
    auto const [begin, count, end] = chunk;
    prefetch(rows, begin + prefetch_distance, count, end);
    std::size_t const packs = (count + lanes - 1) / lanes;
    for (std::size_t k = 0; k < packs; ++k) {
        pairs[k] = load_consecutive(rows, begin + k * lanes, count - k * lanes);
        searches[k] = start_search(with_units(pairs[k]));
    }
    run(searches, packs, max_normal_steps,
        [&](std::size_t k) { take_step(searches[k], with_units(pairs[k])); });
    for (std::size_t k = 0; k < packs; ++k) {
        std::size_t const first = begin + k * lanes, left = count - k * lanes;
        auto const &pair = pairs[k];
        PackMask const done = finish_search(pair, searches[k].x, [&](Distance<Pack, 3> const &d) {
            store_distances(d, pair.r12, first, left, out);
        });
        for_lanes(live_lanes(left) & ~done.to_bits(),
                  [&](unsigned i) { rejected_lanes.push(first + i); });
    }
}

} // namespace
} // namespace pw85::detail

#else
#include <pw85.h>

#include "../one_pair.hpp"

namespace pw85::detail::kernels {

static inline int scalar_fallback(Target const &target, PairRow<3> const &pair,
                                  DistanceArrays const &out) noexcept
{
    return PW85_OF_PAIR(target, distance_geometry)(pair.r12, pair.q1, pair.q2, out.distance,
                                                   out.point1, out.point2, out.normal);
}

static inline int refuse_pair(Target const &, PairRow<3> const &pair,
                              DistanceArrays const &) noexcept
{
    return pw85_distance(pair.r12, pair.q1, pair.q2, nullptr, nullptr, nullptr);
}

} // namespace pw85::detail::kernels

#endif
#endif
