// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The contact function of many pairs with contact points, normals and derivatives, one pair per
/// lane.
///
/// The kernel evaluates the formulas of contact/geometry.hpp at the λ of the contact function
/// (contact.hpp), as the functions for one pair do. Ill-conditioned pairs are left over with their
/// λ.
#ifndef PW85_SIMD_LANES_DERIVATIVES_HPP_INCLUDED
#define PW85_SIMD_LANES_DERIVATIVES_HPP_INCLUDED

#include "../pairs.hpp"
#include "contact.hpp"

namespace pw85::detail::kernels {

/// Contact functions and derivatives. Any pointer may be null, except that kernels need `lambda`:
/// they set it to NaN for pairs that they leave over without a certain λ.
struct DerivativeArrays {
    double *mu2, *lambda;
    double *point, *normal, *d_r12, *d_rot1, *d_rot2; ///< three numbers per pair
    /// the separations of the images that the kernel chose
    double *r12 = nullptr;

    PW85_MEMBER DerivativeArrays from(std::size_t begin) const noexcept
    {
        return {row_or_null(mu2, 1, begin),    row_or_null(lambda, 1, begin),
                row_or_null(point, 3, begin),  row_or_null(normal, 3, begin),
                row_or_null(d_r12, 3, begin),  row_or_null(d_rot1, 3, begin),
                row_or_null(d_rot2, 3, begin), row_or_null(r12, 3, begin)};
    }
};

} // namespace pw85::detail::kernels

#ifdef PW85_KERNEL
#include <pw85/contact/geometry.hpp>

namespace pw85::detail {
namespace {

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

#elif !defined(PW85_FOR_DEVICES)

#include "../../base/parallel.hpp"

namespace pw85::detail::kernels {

/// Only the contact function decides the status: a concentric pair is valid, although it has no
/// normal. If λ is NaN, the derivatives are NaN too.
static inline int scalar_fallback(Target const &target, PairRow<3> const &pair,
                                  DerivativeArrays const &out) noexcept
{
    auto const &[r12, q1, q2] = pair;
    int status = 0;
    for (int d = 0; out.r12 != nullptr && d < 3; ++d) out.r12[d] = r12[d];
    if (elementary::isnan(*out.lambda)) {
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

/// Derivatives need an array for λ. If the caller gives none, the pairs are computed in parts with
/// an array on the stack.
template <class Rows> static Failure compute(Target const &target, Rows const &rows, std::size_t n,
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
                                                            minimum(part_size, n - begin), part);
        first.update({begin + bad.index, bad.status});
    }
    return first;
}

static inline int refuse_pair(Target const &target, PairRow<3> const &pair,
                              DerivativeArrays const &) noexcept
{
    return refuse_pair(target, pair, ContactArrays{});
}

} // namespace pw85::detail::kernels

#endif
#endif
