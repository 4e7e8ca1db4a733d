// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The kernel for the contact function with contact points, normals and derivatives, one pair per
/// lane. lanes_derivatives.cpp and lanes_lists.cpp define it.
///
/// The kernel evaluates the formulas of contact/geometry.hpp at the λ of the contact function
/// (lane_contact.hpp), as the functions for one pair do. Ill-conditioned pairs are left over with
/// their λ.
#ifndef PW85_SIMD_LANE_DERIVATIVES_HPP_INCLUDED
#define PW85_SIMD_LANE_DERIVATIVES_HPP_INCLUDED

#include <utility>

#include <pw85/contact/geometry.hpp>

#include "lane_contact.hpp"

namespace pw85::detail {
namespace {

/// Register m of the three registers that hold x0, y0, z0, x1, y1 ... in this order. With k = m
/// lanes + j, element j is coordinate k % 3 of lane k / 3.
template <std::size_t m, std::size_t... j>
PW85_INLINE Register interleave(Vector<Pack, 3> const &x, std::index_sequence<j...>) noexcept
{
    Register const xy = __builtin_shufflevector(
        x[0].v, x[1].v,
        ((m * lanes + j) % 3 == 1 ? lanes + (m * lanes + j) / 3 : (m * lanes + j) / 3)...);
    return __builtin_shufflevector(xy, x[2].v,
                                   ((m * lanes + j) % 3 == 2 ? lanes + (m * lanes + j) / 3 : j)...);
}

/// Stores the vectors of the first `count` lanes in consecutive rows. scalar_fallback() overwrites
/// those that are not certain.
PW85_INLINE void store_rows(Vector<Pack, 3> const &x, std::size_t count, double *rows) noexcept
{
    constexpr auto all = std::make_index_sequence<lanes>();
    Register const interleaved[3] = {interleave<0>(x, all), interleave<1>(x, all),
                                     interleave<2>(x, all)};
    std::memcpy(rows, interleaved, 3 * sizeof(double) * (count < lanes ? count : lanes));
}

/// Stores the derivatives of consecutive pairs at their λ, and returns the lanes in which they are
/// accurate.
PW85_INLINE PackMask store_derivatives(LanePair<3> const &pair, Pack const &lambda,
                                       kernels::DerivativeArrays const &out,
                                       std::size_t count) noexcept
{
    auto const [at, accurate] = fast_tangency(pair, lambda);
    if (out.r12 != nullptr) store_rows(pair.r12, count, out.r12);
    if (out.point != nullptr) store_rows(tangency_point(at, pair.q1), count, out.point);
    if (out.normal != nullptr) store_rows(tangency_normal(at), count, out.normal);
    if (out.d_r12 != nullptr) store_rows(separation_gradient(at), count, out.d_r12);
    auto const gradients = rotation_gradients(at, pair.q1, pair.q2);
    if (out.d_rot1 != nullptr) store_rows(gradients.first, count, out.d_rot1);
    if (out.d_rot2 != nullptr) store_rows(gradients.second, count, out.d_rot2);
    return accurate;
}

/// Stores the contact functions and derivatives of a chunk.
template <class Rows> PW85_INLINE void compute_chunk(Rows const &rows, Chunk const &chunk,
                                                     kernels::DerivativeArrays const &out,
                                                     kernels::Worklist &rejected_lanes) noexcept
{
    contact_chunk(rows, chunk, rejected_lanes,
                  [&](LanePair<3> const &pair, StationaryValue<Pack> const &value,
                      PackMask certified, std::size_t first, std::size_t left) {
                      auto const part = out.from(first);
                      Pack const lambda = select(certified, value.lambda, quiet_nan<Pack>());
                      if (part.mu2 != nullptr) store_lanes(value.mu2, left, part.mu2);
                      store_lanes(lambda, left, part.lambda);
                      return (certified && store_derivatives(pair, lambda, part, left)).to_bits();
                  });
}

} // namespace
} // namespace pw85::detail

#endif
