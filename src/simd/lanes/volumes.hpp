// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Volumes of common parts of many pairs, one pair per lane. The kernel drives the integrals along
/// the rim (volume/rim_integrals.hpp), which give the bits of the function for one pair.
///
/// The tests of overlap.hpp decide first. Pairs that overlap are collected, so that all lanes are
/// in use. A pair is left over if three tests do not decide it, if a formula of the function for
/// one pair has a case of its own for it, if it has two rims, or if its rule needs more than 64
/// nodes.
///
/// Packs have four lanes. Eight need more stack than pw85.h promises, and two gain nothing: there
/// all pairs are left over.
#ifndef PW85_SIMD_LANES_VOLUMES_HPP_INCLUDED
#define PW85_SIMD_LANES_VOLUMES_HPP_INCLUDED

#include "../pairs.hpp"
#include "overlap.hpp"

namespace pw85::detail::kernels {

/// Volumes of common parts.
struct VolumeArray {
    /// a few hundred microseconds of work
    static constexpr std::size_t rows_of_block = 1024;
    double *volume;

    PW85_MEMBER VolumeArray from(std::size_t begin) const noexcept { return {volume + begin}; }
};

/// With the instructions of AVX-512, four lanes would gain a factor of 1.00 to 1.10.
template <> inline constexpr bool has_lanes256<PairArrays<3>, VolumeArray> = true;

} // namespace pw85::detail::kernels

#ifdef PW85_KERNEL
#include "volume_frames.hpp"

namespace pw85::detail {
namespace {

/// The sums of these rows are on the stack.
inline constexpr std::size_t volume_chunk_size = 32;
template <class Rows> constexpr std::size_t chunk_size<Rows, kernels::VolumeArray> =
    volume_chunk_size;

/// The nodes of the rules, in the order of RuleLadder.
struct LaneNodes {
    UnitVector2<double> first[5], sixteen[4], thirds[8]; ///< thirds: of the rule with 24
    UnitVector2<double> finer[8 + 16];                   ///< of the rules with 32 and 64

    LaneNodes() noexcept
    {
        RuleNodes<double> nodes;
        for (int level = 3; level <= 6; ++level) nodes.prepare(level);
        store(nodes, 0, 0, 3, first);
        store(nodes, 0, 4, 4, sixteen);
        store(nodes, 0, 5, 6, finer);
        store(nodes, 1, 0, 3, thirds);
    }

  private:
    static PW85_INLINE void store(RuleNodes<double> const &nodes, int start, int low, int high,
                                  UnitVector2<double> *out) noexcept
    {
        for (int k = low; k <= high; ++k)
            nodes.visit(
                start, k, [&](UnitVector2<double> const &theta) { *out++ = theta; },
                [&](UnitVector2<double> const &theta, UnitVector2<double> const &next) {
                    *out++ = theta;
                    *out++ = next;
                });
    }
};

PW85_INLINE UnitVector2<Pack> in_all_lanes(UnitVector2<double> const &phi) noexcept
{
    return {Pack(phi.cosine), Pack(phi.sine)};
}

/// The sums of a row that needs more nodes.
struct OpenSums {
    double coarse[3], added[3], previous;
};

/// The integrals along the rim of pairs: mean_over_half_planes() with up to 64 nodes. Lanes with 16
/// and lanes with 24 nodes are computed together.
class LaneSums {
  public:
    PW85_INLINE LaneSums(LaneNodes const &nodes, LaneFrame const &lane, LaneRim const &rim) noexcept
        : nodes_(nodes), lane_(lane), rule_(rim.rule),
          integrands_(volume_integrands(lane.axes, lane.center, rim.integration))
    {
    }

    /// Computes the rules with up to 24 nodes.
    [[gnu::noinline, gnu::flatten]] void begin() noexcept
    {
        for (int k = 0; k < 5; ++k) {
            if (k == 3) previous_ = distance(Pack(0.125), Pack(0.25));
            if (k < 4) merge(PackMask::from_bits(all_lanes));
            add_to(in_all_lanes(nodes_.first[k]), k > 1, added_);
        }
        PackMask const none = PackMask::from_bits(0);
        update(none, Pack(0.0625));
        PackMask const by_three = !converged && is_better_by_three(previous_);
        open = lane_.clear && !converged;
        if (!any_of(open)) return;
        add_rest(by_three);
        update(by_three, select(by_three, Pack(1.0 / 48.0), Pack(1.0 / 32.0)));
        open = lane_.clear && !(converged || by_three);
    }

    /// Computes the rule of the next level, 5 or 6, with twice the nodes.
    [[gnu::noinline, gnu::flatten]] void refine(int level) noexcept
    {
        int const size = 1 << (level - 2);
        merge(PackMask::from_bits(all_lanes));
        for (int k = 0; k < size; ++k)
            add_to(in_all_lanes(nodes_.finer[size - 8 + k]), true, added_);
        update(PackMask::from_bits(0), Pack(0.125 / size));
        open = lane_.clear && !converged;
    }

    PW85_INLINE void store(unsigned i, OpenSums &sums) const noexcept
    {
        for (int k = 0; k < 3; ++k) {
            sums.coarse[k] = coarse_.numbers[k][i];
            sums.added[k] = added_.numbers[k][i];
        }
        sums.previous = previous_[i];
    }

    PW85_INLINE void load(OpenSums const *sums, std::size_t const (&indices)[lanes]) noexcept
    {
        for (std::size_t i = 0; i < lanes; ++i) {
            OpenSums const &row = sums[indices[i]];
            for (int k = 0; k < 3; ++k) {
                coarse_.numbers[k].v[i] = row.coarse[k];
                added_.numbers[k].v[i] = row.added[k];
            }
            previous_.v[i] = row.previous;
        }
    }

    Pack means[3] = {Pack(0.0), Pack(0.0), Pack(0.0)};
    PackMask converged = PackMask::from_bits(0), open = converged; ///< open: needs more nodes

  private:
    /// Stores the means in the lanes that converge now.
    PW85_INLINE void update(PackMask by_three, Pack const &inverse) noexcept
    {
        Pack const change = distance(inverse, Pack(inverse + inverse)),
                   enough = enough_of_rule<Pack>();
        PackMask const converges =
            !converged && error_of_rule(change, previous_, by_three) <= Pack(enough * enough);
        auto const mean = mean_of(coarse_, added_, inverse);
        for (int i = 0; i < 3; ++i) means[i] = select(converges, mean.numbers[i], means[i]);
        converged = converged || converges;
        previous_ = change;
    }

    /// Adds the nodes of the rules with 16 and 24.
    PW85_INLINE void add_rest(PackMask by_three) noexcept
    {
        merge(!by_three);
        for (unsigned k = 0; k < (any_of(by_three) ? 8 : 4); ++k) {
            PackMask const is_coarse = k < 4 ? by_three : PackMask::from_bits(0),
                           is_added = k < 4 ? !by_three : by_three;
            RimSums<Pack, 3> sums{{}, 0};
            for (int i = 0; i < 3; ++i)
                sums.numbers[i] = select(is_coarse, coarse_.numbers[i], added_.numbers[i]);
            add_to(select(by_three, in_all_lanes(nodes_.thirds[k]),
                          in_all_lanes(nodes_.sixteen[k % 4])),
                   true, sums);
            for (int i = 0; i < 3; ++i) {
                coarse_.numbers[i] = select(is_coarse, sums.numbers[i], coarse_.numbers[i]);
                added_.numbers[i] = select(is_added, sums.numbers[i], added_.numbers[i]);
            }
        }
    }

    /// Counts the added half-planes as coarse ones in the lanes of a mask.
    PW85_INLINE void merge(PackMask in) noexcept
    {
        for (int i = 0; i < 3; ++i) {
            Pack const sum = coarse_.numbers[i] + added_.numbers[i];
            coarse_.numbers[i] = select(in, sum, coarse_.numbers[i]);
            added_.numbers[i] = select(in, Pack(0.0), added_.numbers[i]);
        }
    }

    PW85_INLINE Pack distance(Pack const &inverse, Pack const &inverse_of_coarse) const noexcept
    {
        Pack const units[3] = {Pack(1.0), Pack(1.0), Pack(1.0)};
        return change_of_means(mean_of(coarse_, added_, inverse),
                               mean_of(coarse_, RimSums<Pack, 3>{{}, 0}, inverse_of_coarse), units);
    }

    /// Adds the half-planes of a node. It is not inlined: compute() calls it at two places.
    [[gnu::noinline, gnu::flatten]] void add_to(UnitVector2<Pack> const &theta, bool has_image,
                                                RimSums<Pack, 3> &sums) const noexcept
    {
        add_integrands(integrands_, rim_direction(rule_, theta), has_image, sums);
    }

    LaneNodes const &nodes_;
    LaneFrame const &lane_;
    EllipticRule<Pack> const &rule_;
    VolumeIntegrands<Pack> integrands_;
    RimSums<Pack, 3> coarse_{{}, 0}, added_{{}, 0};
    Pack previous_ = Pack(0.0); ///< the distance of the rule before
};

/// The volumes of pairs, and the lanes for which they are those of the function for one pair.
struct LaneVolumes {
    Pack volume;
    PackMask certain;
};

PW85_INLINE LaneVolumes volumes_of(LaneFrame const &lane, LaneSums const &sums) noexcept
{
    Pack const sum = Pack(sums.means[0] + sums.means[1]) + sums.means[2], part = part_of_sum(sum),
               largest = Pack(0.999) * unit_measure<Pack, 3>();
    return {part * lane.determinant,
            lane.clear && sums.converged && absolute(sum) < infinity<Pack>() && part <= largest};
}

/// Pairs of a chunk that are computed together.
using VolumeList = kernels::IndexList<volume_chunk_size>;

/// Lists the pairs of a chunk that overlap, relative to its begin. The result of other pairs is 0.
/// Pairs that three tests do not decide are left over.
template <class Rows> [[gnu::noinline, gnu::flatten]] inline void
list_overlaps(Rows const &rows, Chunk const &chunk, double *out, VolumeList &list,
              kernels::Worklist &rejected_lanes) noexcept
{
    for (std::size_t k = 0; k < chunk.count; k += lanes) {
        std::size_t const left = chunk.count - k;
        auto const pair = load_consecutive(rows, chunk.begin + k, left);
        Pack t = first_point(pair);
        unsigned overlap = 0, decided = 0;
        for (int test = 0; test < 3 && decided != all_lanes; ++test) {
            LaneCertainty const certainty = test_lanes(pair, t);
            overlap |= certainty.overlap;
            decided |= certainty.decided;
            t = rough_root(certainty.next);
        }
        decided &= passes_fast_checks(pair).to_bits();
        unsigned const live = live_lanes(left);
        for_lanes(live, [&](unsigned i) { out[chunk.begin + k + i] = 0.0; });
        for_lanes(live & decided & overlap, [&](unsigned i) { list.push(k + i); });
        for_lanes(live & ~decided, [&](unsigned i) { rejected_lanes.push(chunk.begin + k + i); });
    }
}

/// Computes the volumes of the pairs in a list.
template <class Rows> class ChunkVolumes {
  public:
    PW85_INLINE ChunkVolumes(Rows const &rows, Chunk const &chunk, double *out,
                             kernels::Worklist &rejected_lanes) noexcept
        : rows_(rows), begin_(chunk.begin), out_(out), rejected_lanes_(rejected_lanes)
    {
    }

    PW85_INLINE void compute() noexcept
    {
        for (int level = 4; level <= 6 && list.size > 0; ++level) compute_list(level);
    }

    VolumeList list;

  private:
    /// Computes the list. Its pairs that need more nodes become the list.
    PW85_INLINE void compute_list(int level) noexcept
    {
        pad(list);
        // push() overwrites only indices that were already read
        std::size_t const size = list.size;
        list.size = 0;
        for (std::size_t k = 0; k < size; k += lanes) {
            std::size_t indices[lanes];
            for (std::size_t i = 0; i < lanes; ++i) indices[i] = list.indices[k + i];
            compute_pack(indices, live_lanes(size - k), level);
        }
    }

    [[gnu::noinline]] void compute_pack(std::size_t const (&indices)[lanes], unsigned live,
                                        int level) noexcept
    {
        LaneFrame frame;
        LaneRim rim;
        find_frame(load(rows_, indices), frame);
        find_rim(frame, rim);
        LaneSums sums(nodes_, frame, rim);
        if (level == 4) {
            sums.begin();
        } else {
            sums.load(open_, indices);
            sums.refine(level);
        }
        auto const found = volumes_of(frame, sums);
        unsigned const certain = found.certain.to_bits(),
                       open = level < 6 ? sums.open.to_bits() : 0;
        for_lanes(live & certain, [&](unsigned i) { out_[begin_ + indices[i]] = found.volume[i]; });
        for_lanes(live & open, [&](unsigned i) {
            sums.store(i, open_[indices[i]]);
            list.push(indices[i]);
        });
        for_lanes(live & ~(certain | open),
                  [&](unsigned i) { rejected_lanes_.push(begin_ + indices[i]); });
    }

    Rows const &rows_;
    std::size_t const begin_;
    double *const out_;
    kernels::Worklist &rejected_lanes_;
    LaneNodes const nodes_;
    OpenSums open_[volume_chunk_size];
};

/// Computes the volumes of a chunk.
template <class Rows> PW85_INLINE void compute_chunk(Rows const &rows, Chunk const &chunk,
                                                     kernels::VolumeArray const &out,
                                                     kernels::Worklist &rejected_lanes) noexcept
{
    if constexpr (lanes != 4) {
        for (std::size_t i = 0; i < chunk.count; ++i) rejected_lanes.push(chunk.begin + i);
        return;
    }
    Rows const rest = rows.from(chunk.begin);
    ChunkVolumes<Rows> volumes(rest, chunk, out.volume, rejected_lanes);
    list_overlaps(rows, chunk, out.volume, volumes.list, rejected_lanes);
    volumes.compute();
}

} // namespace
} // namespace pw85::detail

#else
#include <pw85.h>

#include "../targets.hpp"

namespace pw85::detail::kernels {

static inline int scalar_fallback(Target const &, PairRow<3> const &pair,
                                  VolumeArray const &out) noexcept
{
    return pw85_overlap_volume(pair.r12, pair.q1, pair.q2, out.volume);
}

} // namespace pw85::detail::kernels

#endif
#endif
