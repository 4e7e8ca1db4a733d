// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The contacts of grains of many pairs, one pair per lane. The kernel takes the steps of
/// distance/grain_contact.hpp.
///
/// A pair is left over if its forms are not clearly definite, its lengths are far from one, it has
/// no minimum, or its curvatures have a ratio beyond that of the fit for Hertz's radius.
#ifndef PW85_SIMD_LANES_GRAINS_HPP_INCLUDED
#define PW85_SIMD_LANES_GRAINS_HPP_INCLUDED

#include "../pairs.hpp"

namespace pw85::detail::kernels {

/// Contacts of grains, and the directions from which the searches start, which are input. Any
/// pointer but `starts` may be null.
struct GrainArrays {
    double const *starts;
    double *normal, *depth, *point, *curvatures, *radius;

    [[gnu::always_inline]] GrainArrays from(std::size_t begin) const noexcept
    {
        return {row_of(starts, 3, begin),          row_or_null(normal, 3, begin),
                row_or_null(depth, 1, begin),      row_or_null(point, 3, begin),
                row_or_null(curvatures, 2, begin), row_or_null(radius, 1, begin)};
    }
};

} // namespace pw85::detail::kernels

#ifdef PW85_KERNEL
#include <pw85/distance/grain_contact.hpp>

namespace pw85::detail {
namespace {

/// No number of a search is of a degree above 6 in the lengths, whose squares may be 2^±100.
PW85_INLINE PackMask is_in_range(LanePair<3> const &pair) noexcept
{
    Pack const one = largest_diagonal(pair.q1), other = largest_diagonal(pair.q2),
               square = Pack(dot(pair.r12, pair.r12));
    Pack const largest = maximum(one, maximum(other, square)), smallest = minimum(one, other);
    return largest < Pack(0x1p100) && smallest > Pack(0x1p-100) && is_clearly_definite(pair.q1) &&
           is_clearly_definite(pair.q2);
}

PW85_INLINE DistancePair<Pack, 3> grain_pair(LanePair<3> const &pair) noexcept
{
    return {pair.r12, pair.q1, pair.q2, Pack(1.0), Pack(1.0)};
}

/// Stores the contacts of a pack; returns the lanes that are done.
PW85_INLINE PackMask store_contacts(GrainStep<Pack> const &step, LanePair<3> const &pair,
                                    std::size_t left, kernels::GrainArrays const &out) noexcept
{
    auto const contact = contact_of(step, pair.r12);
    Pack const smaller = contact.curvatures[0], larger = contact.curvatures[1];
    if (out.normal != nullptr) store_rows(contact.normal, left, out.normal);
    if (out.depth != nullptr) store_lanes(contact.depth, left, out.depth);
    if (out.point != nullptr) store_rows(contact.point, left, out.point);
    for (std::size_t i = 0; out.curvatures != nullptr && i < lanes && i < left; ++i) {
        out.curvatures[2 * i] = smaller[i];
        out.curvatures[2 * i + 1] = larger[i];
    }
    if (out.radius != nullptr) store_lanes(fitted_radius(smaller, larger), left, out.radius);
    return is_found(step) && is_in_range(pair) &&
           negative_power_of_two<Pack>(fitted_ratio_exponent) * larger <= smaller;
}

/// One pack: a second one would not stay in the registers beside the first.
template <class Rows> constexpr std::size_t chunk_size<Rows, kernels::GrainArrays> = lanes;

/// Searches for the contacts of a pack, and stores them; returns the lanes that are done. The
/// result of a lane depends on its own pair alone: once it has converged, its normal stays, and
/// another step gives the same.
PW85_INLINE PackMask search_contacts(LanePair<3> const &pair, Vector<Pack, 3> normal,
                                     std::size_t left, kernels::GrainArrays const &out) noexcept
{
    for (int i = 1;; ++i) {
        // a new object: to assign it would copy it through memory
        GrainStep<Pack> const step = grain_step(grain_pair(pair), normal);
        PackMask const active = is_too_long(step);
        if (i == max_grain_steps || !any_of(active)) return store_contacts(step, pair, left, out);
        for (int d = 0; d < 3; ++d) normal[d] = select(active, step.normal[d], normal[d]);
    }
}

/// Computes the contacts of a chunk. scalar_fallback() overwrites those that are left over.
template <class Rows> PW85_INLINE void compute_chunk(Rows const &rows, Chunk const &chunk,
                                                     kernels::GrainArrays const &out,
                                                     kernels::Worklist &rejected_lanes) noexcept
{
    auto const part = out.from(chunk.begin);
    LanePair<3> const pair = load_consecutive(rows, chunk.begin, chunk.count);
    Vector<Pack, 3> start;
    load_rows<3>(part.starts, chunk.count, start);
    PackMask const done =
        search_contacts(pair, Pack(Pack(1.0) / magnitude(start)) * start, chunk.count, part);
    for_lanes(live_lanes(chunk.count) & ~done.to_bits(),
              [&](unsigned i) { rejected_lanes.push(chunk.begin + i); });
}

} // namespace
} // namespace pw85::detail

#else
#include <pw85.h>

#include "../targets.hpp"

namespace pw85::detail::kernels {

static inline int scalar_fallback(Target const &, PairRow<3> const &pair,
                                  GrainArrays const &out) noexcept
{
    return pw85_grain_contact(pair.r12, pair.q1, pair.q2, out.starts, out.normal, out.depth,
                              out.point, out.curvatures, out.radius);
}

} // namespace pw85::detail::kernels

#endif
#endif
