// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The rows of pairs that kernels read. They are plain data and the same for every target, because
/// units that are compiled for different processors exchange them. rows.hpp loads them into packs.
#ifndef PW85_SIMD_PAIRS_HPP_INCLUDED
#define PW85_SIMD_PAIRS_HPP_INCLUDED

#include <cstddef>
#include <cstdint>

#include <pw85/attributes.hpp>

#include "../periodic/lattice.hpp"

namespace pw85::detail::kernels {

/// Row `index` of an array of rows of `width` numbers.
template <class Number> [[gnu::always_inline]] PW85_FUNCTION inline Number *
row_of(Number *rows, int width, std::size_t index) noexcept
{
    return rows + static_cast<std::size_t>(width) * index;
}

/// Returns the pointer to a row of an array that may be null.
template <class Number> [[gnu::always_inline]] PW85_FUNCTION inline Number *
row_or_null(Number *rows, int width, std::size_t index) noexcept
{
    return rows == nullptr ? nullptr : row_of(rows, width, index);
}

// Rows of pairs. from(k) is the same rows without the first k.

/// Arrays of separations and forms: n×3, n×6, n×6 in three dimensions.
template <int D> struct PairArrays {
    static constexpr int dimension = D;
    static constexpr int form = D * (D + 1) / 2;
    double const *r12, *q1, *q2;

    PW85_MEMBER PairArrays from(std::size_t begin) const noexcept
    {
        return {row_of(r12, D, begin), row_of(q1, form, begin), row_of(q2, form, begin)};
    }
};

/// Pairs with a direction instead of the separation. Its length does not matter.
struct Directions {
    static constexpr int dimension = 3;
    PairArrays<3> arrays;

    PW85_MEMBER Directions from(std::size_t begin) const noexcept { return {arrays.from(begin)}; }
};

/// One ellipsoid and n others: r12 n×3, q2 n×6.
struct OneToMany {
    static constexpr int dimension = 3;
    double const *q1, *r12, *q2;

    PW85_MEMBER OneToMany from(std::size_t begin) const noexcept
    {
        return {q1, row_of(r12, 3, begin), row_of(q2, 6, begin)};
    }
};

/// One ellipsoid and others of a system, given by their indices. Images are chosen as for
/// NeighborList.
struct OneToIndexed {
    static constexpr int dimension = 3;
    double const *center, *q1;
    std::int32_t const *others;
    double const *centers, *q;
    std::int32_t const *images; ///< null, or one row for each of the others
    double const *cell;         ///< null without periodicity
    Lattice const *lattice;     ///< null, or prepared for nearest images

    [[gnu::always_inline]] OneToIndexed from(std::size_t begin) const noexcept
    {
        return {center, q1,     others + begin, centers, q, row_or_null(images, 3, begin),
                cell,   lattice};
    }
};

/// A neighbour list: pairs (i, j) of rows of centers (N×3) and q (N×6). `images` gives the image of
/// j as multiples of the rows of `cell`. Without `images` the image is the nearest one in the
/// lattice. Without both it is j itself.
struct NeighborList {
    static constexpr int dimension = 3;
    std::int32_t const *pairs;
    double const *centers, *q;
    std::int32_t const *images; ///< null, or one row per pair
    double const *cell;         ///< null without periodicity
    Lattice const *lattice;     ///< null, or prepared for nearest images

    PW85_MEMBER NeighborList from(std::size_t begin) const noexcept
    {
        return {row_of(pairs, 2, begin), centers, q, row_or_null(images, 3, begin), cell, lattice};
    }
};

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

/// True if the kernel of some rows and arrays is in lanes256/, because registers of 512 bits gain
/// less than a factor of 1.3.
template <class Rows, class Arrays> inline constexpr bool has_lanes256 = false;

/// The numbers of one pair.
template <int D> struct PairRow {
    double r12[std::size_t(D)], q1[std::size_t(D * (D + 1) / 2)], q2[std::size_t(D * (D + 1) / 2)];
};

} // namespace pw85::detail::kernels

#endif
