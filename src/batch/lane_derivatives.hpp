/// @file
/// The contact function with contact points, normals and derivatives, one pair per lane.
///
/// The contact function of a chunk comes first; the formulas of geometry.hpp follow at its λ, as the functions for one pair
/// have them. Pairs that are out of the ordinary or ill-conditioned go to those functions.
#ifndef PW85_BATCH_LANE_DERIVATIVES_HPP_INCLUDED
#define PW85_BATCH_LANE_DERIVATIVES_HPP_INCLUDED

#include <pw85/geometry.hpp>

#include "lane_contact.hpp"

namespace pw85 {
namespace {

/// Pairs whose contact functions are kept between the two passes: 2 kB.
inline constexpr std::size_t derivatives_chunk_size = 128;

/// Row `index` of an array of vectors, or null.
PW85_INLINE double *row_of(double *rows, std::size_t index) noexcept
{
    return rows == nullptr ? nullptr : rows + 3 * index;
}

/// Stores the vectors of the given lanes in rows begin, begin + 1 ..., unless the array is null.
PW85_INLINE void store_rows(Vector<Pack, 3> const &x, unsigned bits, double *rows, std::size_t begin) noexcept
{
    if (rows == nullptr) return;
    double columns[3][lanes];
    for (int d = 0; d < 3; ++d) std::memcpy(columns[d], &x[d].v, sizeof columns[d]);
    for (; bits != 0; bits &= bits - 1) {
        auto const i = static_cast<unsigned>(__builtin_ctz(bits));
        for (std::size_t d = 0; d < 3; ++d) rows[3 * (begin + i) + d] = columns[d][i];
    }
}

/// Derivatives of one pair by the functions for one; NaN where λ is. A concentric pair, which has no normal, is valid otherwise.
PW85_INLINE void derive_one(LanePair const &pair, std::size_t lane, double lambda, batch::DerivativeArrays const &out,
                            std::size_t index, batch::ScalarKernels const &scalar) noexcept
{
    double r12[3], q1[6], q2[6];
    for (int d = 0; d < 3; ++d) r12[d] = pair.r12[d][lane];
    for (int e = 0; e < 6; ++e) {
        q1[e] = pair.q1[e][lane];
        q2[e] = pair.q2[e][lane];
    }
    scalar.contact_geometry(r12, q1, q2, lambda, row_of(out.point, index), row_of(out.normal, index));
    scalar.contact_gradient(r12, q1, q2, lambda, row_of(out.d_r12, index), nullptr, nullptr);
    scalar.contact_torque(r12, q1, q2, lambda, row_of(out.d_rot1, index), row_of(out.d_rot2, index));
}

/// Derivatives of a pack of neighbouring pairs, at their λ.
PW85_INLINE void derive(LanePair const &pair, Pack const &lambda, unsigned live, batch::DerivativeArrays const &out,
                        std::size_t begin, batch::ScalarKernels const &scalar) noexcept
{
    Pack const lambda1 = complement_of(lambda);
    auto const solution = solve_by_adjugate(blend(lambda1, pair.q1, lambda, pair.q2), pair.r12);
    PackMask const good = is_accurate(solution) && is_ordinary(pair.r12, pair.q1, pair.q2) && lambda == lambda;
    Tangency<Pack, 3> const at{times(Pack(Pack(1.0) / solution.determinant), solution.s), lambda1, lambda, lambda1,
                               lambda};
    unsigned const done = good.to_bits() & live;
    auto const gradients = rotation_gradients(at, pair.q1, pair.q2);
    store_rows(tangency_point(at, pair.q1), done, out.point, begin);
    store_rows(tangency_normal(at), done, out.normal, begin);
    store_rows(separation_gradient(at), done, out.d_r12, begin);
    store_rows(gradients.first, done, out.d_rot1, begin);
    store_rows(gradients.second, done, out.d_rot2, begin);
    for (unsigned bits = live & ~done; bits != 0; bits &= bits - 1) {
        auto const i = static_cast<unsigned>(__builtin_ctz(bits));
        derive_one(pair, i, lambda[i], out, begin + i, scalar);
    }
}

/// Contact functions and derivatives of a range of pairs.
template <class Rows>
[[gnu::flatten]] inline batch::Failure derivatives_rows(Rows const &rows, batch::Range range,
                                                        batch::DerivativeArrays const &out,
                                                        batch::ScalarKernels const &scalar) noexcept
{
    batch::Failure first{0, 0};
    double mu2[derivatives_chunk_size], lambda[derivatives_chunk_size];
    for (std::size_t begin = range.begin; begin < range.end; begin += derivatives_chunk_size) {
        std::size_t const left = range.end - begin,
                          count = left < derivatives_chunk_size ? left : derivatives_chunk_size;
        Rows const chunk = rows.from(begin);
        batch::Failure const bad = contact_rows(chunk, {0, count}, {mu2, lambda}, scalar);
        first.update({begin + bad.index, bad.status});
        if (out.mu2 != nullptr) std::memcpy(out.mu2 + begin, mu2, count * sizeof(double));
        if (out.lambda != nullptr) std::memcpy(out.lambda + begin, lambda, count * sizeof(double));
        for (std::size_t i = count; i % lanes != 0; ++i) lambda[i] = lambda[count - 1];
        for (std::size_t k = 0; k < count; k += lanes)
            derive(load_neighbors(chunk, k, count - k), load_lanes<Pack>(lambda + k), live_lanes(count - k), out,
                   begin + k, scalar);
    }
    return first;
}

} // namespace
} // namespace pw85

#endif
