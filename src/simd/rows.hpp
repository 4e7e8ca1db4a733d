// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Loads pairs from their rows in memory, one pair per lane of a scalar. The lane kernels
/// (lanes/gather.hpp) and the code for devices (gpu/work.hpp) use it.
#ifndef PW85_SIMD_ROWS_HPP_INCLUDED
#define PW85_SIMD_ROWS_HPP_INCLUDED

#include <pw85/contact/scaling.hpp>

#include "../periodic/nearest_image.hpp"
#include "pairs.hpp"

namespace pw85::detail {

template <class T> inline constexpr std::size_t lanes_of = ScalarTraits<T>::lanes;

/// Loads the first N columns of as many rows as `T` has lanes, one row per lane. This version is
/// for one lane; gather.hpp has that for packs.
template <class T, int N> struct ColumnLoader {
    PW85_MEMBER static void load(double const *const *rows, T *columns) noexcept
    {
        for (int n = 0; n < N; ++n) columns[n] = rows[0][n];
    }
};

template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline Vector<T, D>
load_vectors(double const *const *rows) noexcept
{
    Vector<T, D> x;
    ColumnLoader<T, D>::load(rows, x.coordinates);
    return x;
}

template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline SymmetricMatrix<T, D>
load_matrices(double const *const *rows) noexcept
{
    SymmetricMatrix<T, D> a;
    ColumnLoader<T, SymmetricMatrix<T, D>::size>::load(rows, a.entries);
    return a;
}

template <class T, int D> [[gnu::always_inline]] PW85_FUNCTION inline Pair<T, D>
load_pairs(kernels::PairArrays<D> const &arrays, std::size_t const *indices) noexcept
{
    double const *r12[lanes_of<T>], *q1[lanes_of<T>], *q2[lanes_of<T>];
    for (std::size_t i = 0; i < lanes_of<T>; ++i) {
        auto const row = arrays.from(indices[i]);
        r12[i] = row.r12;
        q1[i] = row.q1;
        q2[i] = row.q2;
    }
    return {load_vectors<T, D>(r12), load_matrices<T, D>(q1), load_matrices<T, D>(q2), T(1)};
}

/// The direction is scaled to order one, as in the function for one pair. A direction of length
/// zero becomes NaN.
template <class T> [[gnu::always_inline]] PW85_FUNCTION inline Pair<T, 3>
load_pairs(kernels::Directions const &directions, std::size_t const *indices) noexcept
{
    Pair<T, 3> pair = load_pairs<T>(directions.arrays, indices);
    T const largest = largest_coordinate(pair.r12);
    for (int d = 0; d < 3; ++d) pair.r12[d] = pair.r12[d] / largest;
    return pair;
}

template <class T> [[gnu::always_inline]] PW85_FUNCTION inline Pair<T, 3>
load_pairs(kernels::OneToMany const &others, std::size_t const *indices) noexcept
{
    double const *r12[lanes_of<T>], *q2[lanes_of<T>];
    for (std::size_t i = 0; i < lanes_of<T>; ++i) {
        auto const row = others.from(indices[i]);
        r12[i] = row.r12;
        q2[i] = row.q2;
    }
    SymmetricMatrix<T, 3> q1;
    for (int e = 0; e < 6; ++e) q1[e] = T(others.q1[e]);
    return {load_vectors<T, 3>(r12), q1, load_matrices<T, 3>(q2), T(1)};
}

/// Adds to the separations the multiples of cell vectors that rows.images gives for the second
/// particles.
template <class T, class Rows> [[gnu::always_inline]] PW85_FUNCTION inline Vector<T, 3>
add_images(Rows const &rows, Vector<T, 3> r12, std::size_t const *indices) noexcept
{
    for (int row = 0; row < 3; ++row) {
        double multiples[lanes_of<T>];
        for (std::size_t i = 0; i < lanes_of<T>; ++i)
            multiples[i] = kernels::row_of(rows.images, 3, indices[i])[row];
        T const n = load_lanes<T>(multiples);
        for (int d = 0; d < 3; ++d) r12[d] = r12[d] + n * T(rows.cell[3 * row + d]);
    }
    return r12;
}

/// The separations of the images that `rows` selects: given images, nearest images, or the
/// particles themselves.
template <class T, class Rows> [[gnu::always_inline]] PW85_FUNCTION inline Vector<T, 3>
image_separations(Rows const &rows, Vector<T, 3> const &r12, std::size_t const *indices) noexcept
{
    if (rows.images != nullptr) return add_images(rows, r12, indices);
    return rows.lattice != nullptr ? nearest_image(*rows.lattice, r12) : r12;
}

template <class T> [[gnu::always_inline]] PW85_FUNCTION inline Pair<T, 3>
load_pairs(kernels::OneToIndexed const &rows, std::size_t const *indices) noexcept
{
    double const *centers[lanes_of<T>], *q2[lanes_of<T>];
    for (std::size_t i = 0; i < lanes_of<T>; ++i) {
        auto const other = static_cast<std::size_t>(rows.others[indices[i]]);
        centers[i] = kernels::row_of(rows.centers, 3, other);
        q2[i] = kernels::row_of(rows.q, 6, other);
    }
    Vector<T, 3> const y = load_vectors<T, 3>(centers);
    Vector<T, 3> const r12 = {y[0] - T(rows.center[0]), y[1] - T(rows.center[1]),
                              y[2] - T(rows.center[2])};
    SymmetricMatrix<T, 3> q1;
    for (int e = 0; e < 6; ++e) q1[e] = T(rows.q1[e]);
    return {image_separations(rows, r12, indices), q1, load_matrices<T, 3>(q2), T(1)};
}

template <class T> [[gnu::always_inline]] PW85_FUNCTION inline Vector<T, 3>
load_separations(kernels::NeighborList const &list, std::size_t const *indices) noexcept
{
    double const *center1[lanes_of<T>], *center2[lanes_of<T>];
    for (std::size_t i = 0; i < lanes_of<T>; ++i) {
        std::int32_t const *const pair = kernels::row_of(list.pairs, 2, indices[i]);
        center1[i] = kernels::row_of(list.centers, 3, static_cast<std::size_t>(pair[0]));
        center2[i] = kernels::row_of(list.centers, 3, static_cast<std::size_t>(pair[1]));
    }
    Vector<T, 3> const x = load_vectors<T, 3>(center1), y = load_vectors<T, 3>(center2);
    Vector<T, 3> const r12 = {y[0] - x[0], y[1] - x[1], y[2] - x[2]};
    return image_separations(list, r12, indices);
}

template <class T> [[gnu::always_inline]] PW85_FUNCTION inline Pair<T, 3>
load_pairs(kernels::NeighborList const &list, std::size_t const *indices) noexcept
{
    double const *q1[lanes_of<T>], *q2[lanes_of<T>];
    for (std::size_t i = 0; i < lanes_of<T>; ++i) {
        std::int32_t const *const pair = kernels::row_of(list.pairs, 2, indices[i]);
        q1[i] = kernels::row_of(list.q, 6, static_cast<std::size_t>(pair[0]));
        q2[i] = kernels::row_of(list.q, 6, static_cast<std::size_t>(pair[1]));
    }
    return {load_separations<T>(list, indices), load_matrices<T, 3>(q1), load_matrices<T, 3>(q2),
            T(1)};
}

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
