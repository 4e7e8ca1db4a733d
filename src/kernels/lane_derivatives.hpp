/// @file
/// The contact function with contact points, normals and derivatives, one pair per lane.
///
/// The contact function of a chunk comes first; the formulas of geometry.hpp follow at its λ, as the functions for one pair
/// have them. Pairs that are out of the ordinary or ill-conditioned go to those functions.
#ifndef PW85_KERNELS_LANE_DERIVATIVES_HPP_INCLUDED
#define PW85_KERNELS_LANE_DERIVATIVES_HPP_INCLUDED

#include <utility>

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

/// Register m of the coordinates of vectors one after the other: x0, y0, z0, x1 ... Its element j is coordinate k % 3 of lane k / 3
/// with k = m lanes + j.
template <std::size_t m, std::size_t... j>
PW85_INLINE Register interleave(Vector<Pack, 3> const &x, std::index_sequence<j...>) noexcept
{
    Register const xy = __builtin_shufflevector(
        x[0].v, x[1].v, ((m * lanes + j) % 3 == 1 ? lanes + (m * lanes + j) / 3 : (m * lanes + j) / 3)...);
    return __builtin_shufflevector(xy, x[2].v, ((m * lanes + j) % 3 == 2 ? lanes + (m * lanes + j) / 3 : j)...);
}

/// Stores the vectors of the first `count` lanes in neighbouring rows; those that are not done will be overwritten.
PW85_INLINE void store_rows(Vector<Pack, 3> const &x, std::size_t count, double *rows) noexcept
{
    constexpr auto all = std::make_index_sequence<lanes>();
    Register const interleaved[3] = {interleave<0>(x, all), interleave<1>(x, all), interleave<2>(x, all)};
    std::memcpy(rows, interleaved, 3 * sizeof(double) * (count < lanes ? count : lanes));
}

/// Derivatives of one pair by the functions for one; NaN where λ is. A concentric pair, which has no normal, is valid otherwise.
PW85_INLINE void derive_one(LanePair const &pair, std::size_t lane, double lambda, kernels::DerivativeArrays const &out,
                            std::size_t index, kernels::ScalarKernels const &scalar) noexcept
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

/// Derivatives of a pack of neighbouring pairs, of which there are `count`, at their λ.
PW85_INLINE void derive(LanePair const &pair, Pack const &lambda, std::size_t count,
                        kernels::DerivativeArrays const &out, std::size_t begin,
                        kernels::ScalarKernels const &scalar) noexcept
{
    Pack const lambda1 = complement_of(lambda);
    auto const solution = solve_by_adjugate(blend(lambda1, pair.q1, lambda, pair.q2), pair.r12);
    PackMask const good = is_accurate(solution) && is_ordinary(pair.r12, pair.q1, pair.q2);
    Pack const reciprocal = Pack(1.0) / solution.determinant;
    Tangency<Pack, 3> const at{times(reciprocal, solution.s), lambda1, lambda, lambda1, lambda};
    if (out.point != nullptr) store_rows(tangency_point(at, pair.q1), count, row_of(out.point, begin));
    if (out.normal != nullptr) store_rows(tangency_normal(at), count, row_of(out.normal, begin));
    if (out.d_r12 != nullptr) store_rows(separation_gradient(at), count, row_of(out.d_r12, begin));
    auto const gradients = rotation_gradients(at, pair.q1, pair.q2);
    if (out.d_rot1 != nullptr) store_rows(gradients.first, count, row_of(out.d_rot1, begin));
    if (out.d_rot2 != nullptr) store_rows(gradients.second, count, row_of(out.d_rot2, begin));
    for (unsigned bits = live_lanes(count) & ~good.to_bits(); bits != 0; bits &= bits - 1) {
        auto const i = static_cast<unsigned>(__builtin_ctz(bits));
        derive_one(pair, i, lambda[i], out, begin + i, scalar);
    }
}

/// Derivatives of a chunk at its λ, which reach to the end of its last pack. Not inlined: see contact_chunk().
template <class Rows>
[[gnu::noinline, gnu::flatten]] inline void derive_chunk(Rows const &chunk, double const *lambda, std::size_t count,
                                                         kernels::DerivativeArrays const &out, std::size_t begin,
                                                         kernels::ScalarKernels const &scalar) noexcept
{
    for (std::size_t k = 0; k < count; k += lanes)
        derive(load_neighbors(chunk, k, count - k), load_lanes<Pack>(lambda + k), count - k, out, begin + k, scalar);
}

/// Contact functions and derivatives of a range of pairs.
template <class Rows> inline kernels::Failure derivatives_rows(Rows const &rows, kernels::Range range,
                                                               kernels::DerivativeArrays const &out,
                                                               kernels::ScalarKernels const &scalar) noexcept
{
    kernels::Failure first{0, 0};
    double mu2[derivatives_chunk_size], lambda[derivatives_chunk_size];
    for (std::size_t begin = range.begin; begin < range.end; begin += derivatives_chunk_size) {
        std::size_t const left = range.end - begin,
                          count = left < derivatives_chunk_size ? left : derivatives_chunk_size;
        Rows const chunk = rows.from(begin);
        kernels::Failure const bad = contact_rows(chunk, {0, count}, {mu2, lambda}, scalar);
        first.update({begin + bad.index, bad.status});
        if (out.mu2 != nullptr) std::memcpy(out.mu2 + begin, mu2, count * sizeof(double));
        if (out.lambda != nullptr) std::memcpy(out.lambda + begin, lambda, count * sizeof(double));
        // Lanes that are filling do what the last one does: numbers from nowhere could raise exceptions.
        for (std::size_t i = count; i % lanes != 0; ++i) lambda[i] = lambda[count - 1];
        derive_chunk(chunk, lambda, count, out, begin, scalar);
    }
    return first;
}

} // namespace
} // namespace pw85

#endif
