/// @file
/// Loads of pairs, one per lane, from rows in memory.
#ifndef PW85_BATCH_ROWS_HPP_INCLUDED
#define PW85_BATCH_ROWS_HPP_INCLUDED

#include <cstddef>

#include <pw85/scaling.hpp>

#include "pack.hpp"

namespace pw85::inline PW85_TARGET {

using LanePair = Pair<Pack, 3>;

/// Two neighbouring columns of as many rows as there are lanes.
struct Columns {
    Pack first, second;
};

/// N doubles: two of each row from every other row on, two rows apart.
template <int N> PW85_INLINE RegisterOf<N>::Doubles gather_twos(double const *const *rows, std::ptrdiff_t column) noexcept
{
    if constexpr (N == 2) {
        RegisterOf<2>::Doubles two;
        std::memcpy(&two, rows[0] + column, sizeof two);
        return two;
    } else {
        auto const low = gather_twos<N / 2>(rows, column), high = gather_twos<N / 2>(rows + N / 2, column);
#if defined(__AVX2__) && defined(__FMA__)
        if constexpr (N == 4)
            return _mm256_insertf128_pd(_mm256_castpd128_pd256(low), high, 1);
#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
        else
            return _mm512_insertf64x4(_mm512_castpd256_pd512(low), high, 1);
#endif
#endif
    }
}

/// Columns `column` and `column` + 1, by shuffles in registers.
PW85_INLINE Columns load_columns(double const *const *rows, std::ptrdiff_t column) noexcept
{
    Register const even = gather_twos<lanes>(rows, column), odd = gather_twos<lanes>(rows + 1, column);
#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
    return {__builtin_shufflevector(even, odd, 0, 8, 2, 10, 4, 12, 6, 14),
            __builtin_shufflevector(even, odd, 1, 9, 3, 11, 5, 13, 7, 15)};
#elif defined(__AVX2__) && defined(__FMA__)
    return {__builtin_shufflevector(even, odd, 0, 4, 2, 6), __builtin_shufflevector(even, odd, 1, 5, 3, 7)};
#else
    return {__builtin_shufflevector(even, odd, 0, 2), __builtin_shufflevector(even, odd, 1, 3)};
#endif
}

PW85_INLINE Vector<Pack, 3> load_vectors(double const *const *rows) noexcept
{
    Columns const xy = load_columns(rows, 0), yz = load_columns(rows, 1);
    return {xy.first, xy.second, yz.second};
}

PW85_INLINE SymmetricMatrix<Pack, 3> load_matrices(double const *const *rows) noexcept
{
    Columns const a = load_columns(rows, 0), b = load_columns(rows, 2), c = load_columns(rows, 4);
    return {a.first, a.second, b.first, b.second, c.first, c.second};
}

/// The pairs of the batch form: row i of three arrays.
struct BatchRows {
    double const *r12, *q1, *q2;

    PW85_INLINE LanePair load(std::size_t const *indices) const noexcept
    {
        double const *r[lanes], *p[lanes], *q[lanes];
        for (int i = 0; i < lanes; ++i) {
            r[i] = r12 + 3 * indices[i];
            p[i] = q1 + 6 * indices[i];
            q[i] = q2 + 6 * indices[i];
        }
        return {load_vectors(r), load_matrices(p), load_matrices(q), Pack(1.0)};
    }
};

} // namespace pw85::inline PW85_TARGET

#endif
