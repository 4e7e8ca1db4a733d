// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The depths of many overlaps, one pair per lane, with the bits of one pair: the kernel drives the
/// turns of the normal (distance/depth_turns.hpp) and the certificate of their end
/// (distance/depth_certificate.hpp).
///
/// The first step of the contact search gives a direction to start from, and shows that some pairs
/// are apart. The others are collected, so that all lanes are in use. A certificate of a positive
/// depth proves that a pair overlaps. A pair is left over if it fails the fast checks, if that step
/// tells no start, or if the minimum has no certificate.
///
/// With two lanes all pairs are left over: one pair already computes with both forms side by side.
#ifndef PW85_SIMD_LANES_DEPTH_HPP_INCLUDED
#define PW85_SIMD_LANES_DEPTH_HPP_INCLUDED

#include "../pairs.hpp"

namespace pw85::detail::kernels {

/// Depths and directions. Either pointer may be null.
struct DepthArrays {
    /// a few hundred microseconds of work
    static constexpr std::size_t rows_of_block = 1024;
    double *depth, *direction;

    PW85_MEMBER DepthArrays from(std::size_t begin) const noexcept
    {
        return {row_or_null(depth, 1, begin), row_or_null(direction, 3, begin)};
    }

    PW85_MEMBER void store(std::size_t i, double length, double x, double y,
                           double z) const noexcept
    {
        if (depth != nullptr) depth[i] = length;
        if (direction == nullptr) return;
        direction[3 * i] = x;
        direction[3 * i + 1] = y;
        direction[3 * i + 2] = z;
    }
};

} // namespace pw85::detail::kernels

#ifdef PW85_KERNEL
#include <pw85/distance/depth_certificate.hpp>

namespace pw85::detail {
namespace {

/// The number of pairs that are started before the paths of those among them that overlap.
inline constexpr std::size_t depth_chunk_size = 64;
template <class Rows> constexpr std::size_t chunk_size<Rows, kernels::DepthArrays> =
    depth_chunk_size;

/// Pairs of a chunk that are apart, and others with t of start_depth().
struct StartedList {
    kernels::IndexList<depth_chunk_size> apart, pairs;
    double t[depth_chunk_size];

    PW85_INLINE void push(std::size_t index, double start) noexcept
    {
        t[pairs.size] = start;
        pairs.push(index);
    }

    /// Fills the last pack.
    PW85_INLINE void pad() noexcept
    {
        for (std::size_t i = pairs.size; i % lanes != 0; ++i) t[i] = t[pairs.size - 1];
        pw85::detail::pad(pairs);
    }
};

/// Lists the pairs of a chunk that are apart, and those that have a start. The others are left
/// over.
template <class Rows>
[[gnu::noinline, gnu::flatten]] inline void start_depths(Rows const &rows, Chunk const &chunk,
                                                         StartedList &list,
                                                         kernels::Worklist &rejected_lanes) noexcept
{
    for (std::size_t k = 0; k < chunk.count; k += lanes) {
        std::size_t const first = chunk.begin + k, left = chunk.count - k;
        auto const pair = load_consecutive(rows, first, left);
        auto const start = start_by_quartic(pair.r12, pair.q1, pair.q2);
        Pack const t = step_from(start, pair.r12, pair.q1, pair.q2);
        auto const value = evaluate_quartic(start.quartic, t);
        PackMask const beyond = seems_apart(value, t), has_start = t > smallest_number<Pack>() &&
                                                                   t < largest_number<Pack>() &&
                                                                   !beyond;
        PackMask apart = test_by_coefficients(value, t).apart;
        if (any_of(beyond && !apart)) // by the adjugate, whose rounding errors are smaller
            apart = apart || test_quartic(evaluate_quartic(pair, t), t).apart;
        unsigned const live = live_lanes(left) & start.passes.to_bits(),
                       decided = live & apart.to_bits(),
                       started = live & ~decided & has_start.to_bits();
        for_lanes(decided, [&](unsigned i) { list.apart.push(first + i); });
        for_lanes(started, [&](unsigned i) { list.push(first + i, t[i]); });
        for_lanes(live_lanes(left) & ~(decided | started),
                  [&](unsigned i) { rejected_lanes.push(first + i); });
    }
}

/// A pair, with its forms side by side.
struct SidePair {
    Vector<Pack, 3> r12;
    SymmetricMatrix<TwoLanes<Pack>, 3> q;
};

PW85_INLINE void replace(PackMask mask, DirectionState<Pack, 3> &old,
                         DirectionState<Pack, 3> const &at) noexcept
{
    old.n = selected(mask, at.n, old.n);
    old.products = selected(mask, at.products, old.products);
    old.extents = selected(mask, at.extents, old.extents);
    old.inverses = selected(mask, at.inverses, old.inverses);
    old.factors = selected(mask, at.factors, old.factors);
    old.inverse_square = select(mask, at.inverse_square, old.inverse_square);
    old.scale = select(mask, at.scale, old.scale);
}

/// The ends of the paths that follow_normal() has found, with their corrections, and states whose
/// directions separate the pair.
struct PathEnds {
    DirectionState<Pack, 3> at;
    Vector<Pack, 3> correction;
    PackMask found, separate;
};

/// The states of paths that follow_normals() takes at most. More than ten are rare.
inline constexpr int max_lane_states = 16;

/// Turns that are taken in part: half of the turn, or half of the part before.
struct PartsOfTurns {
    Vector<Pack, 3> n, turn; ///< the turn from n
    Pack length, slack;      ///< the length of n, and what the part may add to it
    Pack factor;             ///< the part
    PackMask taken;          ///< the paths that are at a part

    /// Shortens the turns of the lanes of a mask, and returns those whose parts are too short.
    PW85_INLINE PackMask shorten(PackMask in, Pack const &slack_now,
                                 TurnedPath<Pack, 3> &path) noexcept
    {
        slack = select(in, slack_now, slack);
        factor = select(in, Pack(Pack(0.5) * select(taken, factor, Pack(1.0))), factor);
        path.n = selected(in, turned(n, factor, turn, path.is_large), path.n);
        return in && factor < Pack(1.0 / (1 << max_turn_halves));
    }

    /// Takes the states in `longer` as parts, and keeps the state and the turn of the other paths.
    PW85_INLINE void keep(PackMask longer, DirectionState<Pack, 3> const &at,
                          Vector<Pack, 3> const &next) noexcept
    {
        taken = longer;
        n = selected(longer, n, at.n);
        turn = selected(longer, turn, next);
        length = select(longer, length, at.length);
    }
};

/// Replaces paths by shorter ones.
PW85_INLINE void replace(PackMask mask, TurnedPath<Pack, 3> &old,
                         TurnedPath<Pack, 3> const &shorter) noexcept
{
    old.n = selected(mask, shorter.n, old.n);
    old.square = select(mask, shorter.square, old.square);
    old.accurate = (mask && shorter.accurate) || (!mask && old.accurate);
    old.is_large = (mask && shorter.is_large) || (!mask && old.is_large);
}

/// follow_normal() from the directions in which ellipsoids touch.
[[gnu::noinline, gnu::flatten]] inline void follow_normals(SidePair const &pair, Pack const &t,
                                                           PathEnds &ends) noexcept
{
    PackMask const none = PackMask::from_bits(0);
    auto const traces = trace(pair.q);
    SymmetricMatrix<Pack, 3> form;
    for (int k = 0; k < 6; ++k) form[k] = first_of(pair.q[k]) + t * second_of(pair.q[k]);
    Pack const distance = sum_of_magnitudes(pair.r12);
    TurnedPath<Pack, 3> path{product(adjugate(form), pair.r12), Pack(1.0), none, none, none};
    PartsOfTurns parts{{}, {}, infinity<Pack>(), Pack(0.0), Pack(1.0), none};
    SymmetricMatrix<Pack, 3> inverse{};
    ends.found = ends.separate = none;
    PackMask active = trace(form) < Pack(0x1p80);
    for (int i = 0; i < max_lane_states; ++i) {
        auto const at = state_along(pair.q, pair.r12, path.n, path.accurate);
        Pack const slack = select(parts.taken, parts.slack, slack_of_path(at, traces, distance));
        PackMask const is_longer = active && !(at.length <= parts.length + slack);
        PackMask const separate = active && !is_longer && at.length < -slack;
        if (any_of(separate)) replace(separate, ends.at, at);
        ends.separate = ends.separate || separate;
        active = active && !separate;
        PackMask ended = active && path.converged && !(is_longer || parts.taken);
        if (any_of(ended)) {
            auto const correction = correction_at(at, pair.r12, inverse);
            ended = ended && is_last(correction, at);
            replace(ended, ends.at, at);
            ends.correction = selected(ended, correction.turn, ends.correction);
            ends.found = ends.found || ended;
            active = active && !ended;
        }
        auto shorter = path;
        if (any_of(is_longer)) active = active && !parts.shorten(is_longer, slack, shorter);
        if (!any_of(active)) break;
        Vector<Pack, 3> turn;
        PackMask const newton = normal_turn(pair.q, pair.r12, at, turn, inverse);
        add_turn(path, at, turn, newton);
        parts.keep(is_longer, at, turn);
        if (any_of(is_longer)) replace(is_longer, path, shorter);
    }
}

/// The depths at the ends of paths, and those that are certain.
struct LaneDepths {
    Vector<Pack, 3> direction;
    Pack depth;
    PackMask certain, apart;
};

[[gnu::noinline, gnu::flatten]] inline void
certify_depths(SidePair const &pair, PathEnds const &ends, LaneDepths &depths) noexcept
{
    auto const &at = ends.at;
    Shift<Pack> const along = shift_along(Pack(at.scale) * at.n, pair.r12, pair.q);
    DepthSearch<Pack, 3> const search{pair.r12, first_of(pair.q), second_of(pair.q),
                                      corrected(at, ends.correction), along};
    depths.direction = search.direction;
    depths.depth = along.length;
    depths.apart = ends.separate && along.length < Pack(-2.0) * along.rounding;
    depths.certain =
        ends.found && along.length > Pack(2.0) * along.rounding && is_certified(search, at);
}

template <class Rows>
PW85_INLINE SidePair load_sides(Rows const &rows, std::uint16_t const *indices) noexcept
{
    auto const pair = load_listed(rows, indices);
    return {pair.r12, side_by_side(pair.q1, pair.q2)};
}

/// Computes the depths of the pairs in a list, and calls store(pair, depths, indices, certain) with
/// the bits of the lanes that are certain. The others are left over.
template <class Rows, class Store>
PW85_INLINE void compute_depths(Rows const &rows, StartedList &list,
                                kernels::Worklist &rejected_lanes, Store const &store) noexcept
{
    list.pad();
    PathEnds ends{};
    for (std::size_t k = 0; k < list.pairs.size; k += lanes) {
        std::uint16_t const *const indices = list.pairs.indices + k;
        auto const pair = load_sides(rows, indices);
        LaneDepths depths;
        follow_normals(pair, load_lanes<Pack>(list.t + k), ends);
        certify_depths(pair, ends, depths);
        unsigned const live = live_lanes(list.pairs.size - k), certain = depths.certain.to_bits(),
                       apart = depths.apart.to_bits();
        store(pair, depths, indices, live & certain);
        for_lanes(live & apart, [&](unsigned i) { list.apart.push(indices[i]); });
        for_lanes(live & ~(certain | apart), [&](unsigned i) { rejected_lanes.push(indices[i]); });
    }
}

/// Leaves all pairs of a chunk over.
PW85_INLINE void reject_all(Chunk const &chunk, kernels::Worklist &rejected_lanes) noexcept
{
    for (std::size_t i = 0; i < chunk.count; ++i) rejected_lanes.push(chunk.begin + i);
}

template <class Rows> PW85_INLINE void compute_chunk(Rows const &rows, Chunk const &chunk,
                                                     kernels::DepthArrays const &out,
                                                     kernels::Worklist &rejected_lanes) noexcept
{
    if constexpr (lanes == 2) return reject_all(chunk, rejected_lanes);
    StartedList list;
    start_depths(rows, chunk, list, rejected_lanes);
    compute_depths(
        rows, list, rejected_lanes,
        [&](auto const &, LaneDepths const &found, std::uint16_t const *indices, unsigned certain) {
            auto const &n = found.direction;
            for_lanes(certain, [&](unsigned i) {
                out.store(indices[i], found.depth[i], n[0][i], n[1][i], n[2][i]);
            });
        });
    constexpr double nan = quiet_nan<double>();
    for (std::size_t k = 0; k < list.apart.size; ++k)
        out.store(list.apart.indices[k], 0.0, nan, nan, nan);
}

} // namespace
} // namespace pw85::detail

#else
#include <pw85.h>

#include "../one_pair.hpp"

namespace pw85::detail::kernels {

static inline int scalar_fallback(Target const &target, PairRow<3> const &pair,
                                  DepthArrays const &out) noexcept
{
    return PW85_OF_PAIR(target, penetration)(pair.r12, pair.q1, pair.q2, out.depth, out.direction);
}

static inline int refuse_pair(Target const &, PairRow<3> const &pair, DepthArrays const &) noexcept
{
    return pw85_penetration(pair.r12, pair.q1, pair.q2, nullptr, nullptr);
}

} // namespace pw85::detail::kernels

#endif
#endif
