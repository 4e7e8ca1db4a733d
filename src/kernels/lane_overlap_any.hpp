/// @file
/// Whether one ellipsoid overlaps any of many, one of these per lane.
#ifndef PW85_KERNELS_LANE_OVERLAP_ANY_HPP_INCLUDED
#define PW85_KERNELS_LANE_OVERLAP_ANY_HPP_INCLUDED

#include "lane_overlap.hpp"

namespace pw85 {
namespace {

/// The pairs of one ellipsoid with others.
struct OneToManyRows {
    kernels::OneToMany others;

    PW85_INLINE LanePair load(std::size_t const *indices) const noexcept
    {
        double const *r12[lanes], *q2[lanes];
        for (std::size_t i = 0; i < lanes; ++i) {
            r12[i] = others.r12 + 3 * indices[i];
            q2[i] = others.q2 + 6 * indices[i];
        }
        SymmetricMatrix<Pack, 3> q1;
        for (int e = 0; e < 6; ++e) q1[e] = Pack(others.q1[e]);
        return {load_vectors(r12), q1, load_matrices(q2), Pack(1.0)};
    }

    PW85_INLINE void prefetch(std::size_t, std::size_t) const noexcept {}

    /// The pairs from `begin` on.
    PW85_INLINE OneToManyRows from(std::size_t begin) const noexcept
    {
        return {{others.q1, others.r12 + 3 * begin, others.q2 + 6 * begin}};
    }
};

/// Pairs that are tested before the answers are looked at: some more than the neighbours of a particle in a dense system.
inline constexpr std::size_t any_chunk_size = 32;

/// Looks for the first pair, by its index, that overlaps or is bad. Returns the status of a bad one, with `any` = -1.
[[gnu::flatten]] inline int overlap_any_rows(OneToManyRows const &rows, std::size_t n, int *any,
                                             kernels::ScalarKernels const &scalar) noexcept
{
    unsigned char answers[any_chunk_size];
    *any = 0;
    for (std::size_t begin = 0; begin < n; begin += any_chunk_size) {
        std::size_t const count = n - begin < any_chunk_size ? n - begin : any_chunk_size;
        kernels::Failure const bad = overlap_rows(rows.from(begin), {0, count}, answers, scalar);
        for (std::size_t i = 0; i < count; ++i) {
            if (answers[i] == 0) continue;
            *any = answers[i] == 1 ? 1 : -1;
            return *any == 1 ? static_cast<int>(Status::success) : bad.status;
        }
    }
    return static_cast<int>(Status::success);
}

} // namespace
} // namespace pw85

#endif
