// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The overlap test of one ellipsoid of a system and images of others, up to the first overlap.
/// lanes_images.cpp defines it, once per instruction set, and simulation/verlet_list.cpp calls it.
#ifndef PW85_SIMD_IMAGES_HPP_INCLUDED
#define PW85_SIMD_IMAGES_HPP_INCLUDED

#include "rows.hpp"
#include "targets.hpp"
#include "worklist.hpp"

namespace pw85::detail {
namespace kernels {

/// An image of a particle: its index, and the number of the translation.
struct NumberedImage {
    std::int32_t index, image;
};

/// One ellipsoid and images of others of a system. A separation is (center2 - center) +
/// translation. So simulations need no copies of the particles.
struct OneToImages {
    static constexpr int dimension = 3;
    double const *center, *q1;
    NumberedImage const *images;
    double const *centers, *q;  ///< n×3, n×6
    double const *translations; ///< a row of three for each number
};

/// The largest number of images that FindOverlap is given.
inline constexpr std::size_t most_images = 256;

/// Returns whether lanes find an overlap with one of n images. They stop at the first one. If they
/// find none, `rejected_lanes` has those that need the function for one pair.
using FindOverlap = bool(OneToImages const &, std::size_t n, Worklist &rejected_lanes) noexcept;

#define PW85_DECLARE_IMAGES(target, one_pair, available)                                           \
    namespace target {                                                                             \
    FindOverlap find_overlap_of_images;                                                            \
    }
PW85_EACH_TARGET(PW85_DECLARE_IMAGES)
#undef PW85_DECLARE_IMAGES

namespace {

/// Returns the function of a target.
inline auto find_overlap_of(Target const &target) noexcept
{
    return PW85_OF_LANES(target, FindOverlap, find_overlap_of_images);
}

} // namespace

} // namespace kernels

template <class T> [[gnu::always_inline]] PW85_FUNCTION inline Pair<T, 3>
load_pairs(kernels::OneToImages const &rows, std::size_t const *indices) noexcept
{
    double const *centers[lanes_of<T>], *translations[lanes_of<T>], *q2[lanes_of<T>];
    for (std::size_t i = 0; i < lanes_of<T>; ++i) {
        kernels::NumberedImage const near = rows.images[indices[i]];
        auto const index = static_cast<std::size_t>(near.index);
        centers[i] = kernels::row_of(rows.centers, 3, index);
        q2[i] = kernels::row_of(rows.q, 6, index);
        translations[i] =
            kernels::row_of(rows.translations, 3, static_cast<std::size_t>(near.image));
    }
    Vector<T, 3> const y = load_vectors<T, 3>(centers), t = load_vectors<T, 3>(translations);
    Vector<T, 3> r12;
    for (int d = 0; d < 3; ++d) r12[d] = (y[d] - T(rows.center[d])) + t[d];
    SymmetricMatrix<T, 3> q1;
    for (int e = 0; e < 6; ++e) q1[e] = T(rows.q1[e]);
    return {r12, q1, load_matrices<T, 3>(q2), T(1)};
}

} // namespace pw85::detail

#endif
