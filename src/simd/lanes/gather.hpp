// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Loads packs of pairs from rows in memory, one pair per lane: consecutive pairs, or pairs
/// given by a list of indices; and stores packs of results. The kernels use it; rows.hpp has the
/// part that does not depend on the instruction set.
#ifndef PW85_SIMD_LANES_GATHER_HPP_INCLUDED
#define PW85_SIMD_LANES_GATHER_HPP_INCLUDED

#include <cstring>
#include <type_traits>
#include <utility>

#include "../pack.hpp"
#include "../rows.hpp"
#include "../worklist.hpp"

namespace pw85::detail {
namespace {

#if defined(PW85_LANES_SVE)
} // namespace

/// Loads each column by one gather instruction.
template <int N> struct ColumnLoader<Pack, N> {
    static PW85_INLINE void load(double const *const *rows, Pack *columns) noexcept
    {
        std::uint64_t addresses[lanes];
        std::memcpy(addresses, rows, sizeof addresses);
        svuint64_t const first = svld1(svptrue_b64(), addresses);
        for (int column = 0; column < N; ++column)
            columns[column] = svld1_gather_offset_f64(svptrue_b64(), first, 8 * column);
    }
};

namespace {
#else
/// Two consecutive columns.
struct Columns {
    Pack first, second;
};

/// Loads N consecutive numbers.
template <std::size_t N>
PW85_INLINE typename VectorOf<N>::Doubles load_register(double const *x) noexcept
{
    typename VectorOf<N>::Doubles numbers;
    std::memcpy(&numbers, x, sizeof numbers);
    return numbers;
}

/// Loads two doubles from every second row.
template <std::size_t N> PW85_INLINE typename VectorOf<N>::Doubles
gather_twos(double const *const *rows, int column) noexcept
{
    if constexpr (N == 2) {
        return load_register<2>(rows[0] + column);
    } else {
#if defined(PW85_LANES_AVX512) || defined(PW85_LANES_AVX2)
        auto const low = gather_twos<N / 2>(rows, column),
                   high = gather_twos<N / 2>(rows + N / 2, column);
        return x86::join(low, high);
#endif
    }
}

#if defined(PW85_LANES_AVX512)
/// The first, or the second, of each two numbers in turns.
PW85_INLINE Register low_halves(Register x, Register y) noexcept
{
    return __builtin_shufflevector(x, y, 0, 8, 2, 10, 4, 12, 6, 14);
}
PW85_INLINE Register high_halves(Register x, Register y) noexcept
{
    return __builtin_shufflevector(x, y, 1, 9, 3, 11, 5, 13, 7, 15);
}
#endif

/// Loads columns `column` and `column` + 1 of as many rows as there are lanes, and transposes them
/// in registers.
PW85_INLINE Columns load_columns(double const *const *rows, int column) noexcept
{
    Register const even = gather_twos<lanes>(rows, column),
                   odd = gather_twos<lanes>(rows + 1, column);
#if defined(PW85_LANES_AVX512)
    return {low_halves(even, odd), high_halves(even, odd)};
#elif defined(PW85_LANES_AVX2)
    return {__builtin_shufflevector(even, odd, 0, 4, 2, 6),
            __builtin_shufflevector(even, odd, 1, 5, 3, 7)};
#else
    return {Register{even[0], odd[0]}, Register{even[1], odd[1]}};
#endif
}

#if defined(PW85_LANES_AVX512)
/// Loads the first four columns. Rows i and i + 4 share a register, so there are two transpositions
/// of 4×4 numbers.
PW85_INLINE void load_four_columns(double const *const *rows, Pack *columns) noexcept
{
    Register two[4];
    for (std::size_t i = 0; i < 4; ++i)
        two[i] = x86::join(load_register<4>(rows[i]), load_register<4>(rows[i + 4]));
    Register const even01 = low_halves(two[0], two[1]), odd01 = high_halves(two[0], two[1]);
    Register const even23 = low_halves(two[2], two[3]), odd23 = high_halves(two[2], two[3]);
    columns[0] = __builtin_shufflevector(even01, even23, 0, 1, 8, 9, 4, 5, 12, 13);
    columns[1] = __builtin_shufflevector(odd01, odd23, 0, 1, 8, 9, 4, 5, 12, 13);
    columns[2] = __builtin_shufflevector(even01, even23, 2, 3, 10, 11, 6, 7, 14, 15);
    columns[3] = __builtin_shufflevector(odd01, odd23, 2, 3, 10, 11, 6, 7, 14, 15);
}
#else
PW85_INLINE void load_four_columns(double const *const *rows, Pack *columns) noexcept
{
    for (int column = 0; column < 4; column += 2) {
        Columns const c = load_columns(rows, column);
        columns[column] = c.first;
        columns[column + 1] = c.second;
    }
}
#endif

} // namespace

/// Loads columns in twos. If N is odd, the last two overlap with a column that is already loaded.
template <int N> struct ColumnLoader<Pack, N> {
    static PW85_INLINE void load(double const *const *rows, Pack *columns) noexcept
    {
        if constexpr (N >= 4) load_four_columns(rows, columns);
        if constexpr (N == 3) columns[0] = load_columns(rows, 0).first;
        Columns const last = load_columns(rows, N - 2);
        columns[N - 2] = last.first;
        columns[N - 1] = last.second;
    }
};

namespace {
#endif

template <int D> using LanePair = Pair<Pack, D>;
template <class Rows> using LanePairOf = LanePair<Rows::dimension>;

/// The number of pairs by which particles are prefetched ahead.
inline constexpr std::size_t prefetch_distance = 128;

/// `count` consecutive pairs from `begin` on, which are computed together. `end` is the number of
/// all pairs.
struct Chunk {
    std::size_t begin, count, end;
};

/// Consecutive rows of arrays need no prefetch by software.
template <class Rows>
PW85_INLINE void prefetch(Rows const &, std::size_t, std::size_t, std::size_t) noexcept
{
}

/// Prefetches the particles of `count` pairs of a list, from pair `begin` on and below pair `end`.
/// The particles may be anywhere in memory.
PW85_INLINE void prefetch(kernels::NeighborList const &list, std::size_t begin, std::size_t count,
                          std::size_t end) noexcept
{
    for (std::size_t k = 2 * begin; k < 2 * end && k < 2 * (begin + count); ++k) {
        auto const particle = static_cast<std::size_t>(list.pairs[k]);
        __builtin_prefetch(list.centers + 3 * particle);
        __builtin_prefetch(list.q + 6 * particle);
        __builtin_prefetch(list.q + 6 * particle + 5);
    }
}

#if defined(PW85_LANES_AVX512)
/// Takes the numbers of z[0], of z[1] where `from1` has a bit, and of z[2] where `from2` has a bit.
PW85_INLINE Register blend_three(Register const *z, unsigned char from1,
                                 unsigned char from2) noexcept
{
    return x86::blend(from2, x86::blend(from1, z[0], z[1]), z[2]);
}

/// Loads eight consecutive rows of three numbers. The numbers of a column have different positions
/// in the three registers that hold them, and blends collect them. A permutation then brings them
/// into the order of the rows.
PW85_INLINE void load_eight_rows(double const *rows, Vector<Pack, 3> &columns) noexcept
{
    Register const z[3] = {load_register<8>(rows), load_register<8>(rows + 8),
                           load_register<8>(rows + 16)};
    constexpr unsigned char places0 = 0b01001001, places1 = 0b10010010, places2 = 0b00100100;
    columns[0] = __builtin_shufflevector(blend_three(z, places1, places2), Register(), 0, 3, 6, 1,
                                         4, 7, 2, 5);
    columns[1] = __builtin_shufflevector(blend_three(z, places2, places0), Register(), 1, 4, 7, 2,
                                         5, 0, 3, 6);
    columns[2] = __builtin_shufflevector(blend_three(z, places0, places1), Register(), 2, 5, 0, 3,
                                         6, 1, 4, 7);
}

/// Loads eight consecutive rows of six numbers. The same holds for two columns side by side, which
/// share 128 bits, and for four rows, which take three registers.
PW85_INLINE void load_eight_rows(double const *rows, SymmetricMatrix<Pack, 3> &columns) noexcept
{
    Register z[6];
    for (int k = 0; k < 6; ++k) z[k] = load_register<8>(rows + 8 * k);
    constexpr unsigned char part1 = 0b00001100, part2 = 0b00110000, ends = 0b11000011;
    Register const low01 = blend_three(z, part2, part1), high01 = blend_three(z + 3, part2, part1);
    Register const low23 = blend_three(z, ends, part2), high23 = blend_three(z + 3, ends, part2);
    Register const low45 = blend_three(z, part1, ends), high45 = blend_three(z + 3, part1, ends);
    columns[0] = __builtin_shufflevector(low01, high01, 0, 6, 4, 2, 8, 14, 12, 10);
    columns[1] = __builtin_shufflevector(low01, high01, 1, 7, 5, 3, 9, 15, 13, 11);
    columns[2] = __builtin_shufflevector(low23, high23, 2, 0, 6, 4, 10, 8, 14, 12);
    columns[3] = __builtin_shufflevector(low23, high23, 3, 1, 7, 5, 11, 9, 15, 13);
    columns[4] = __builtin_shufflevector(low45, high45, 4, 2, 0, 6, 12, 10, 8, 14);
    columns[5] = __builtin_shufflevector(low45, high45, 5, 3, 1, 7, 13, 11, 9, 15);
}

/// Loads the first eight pairs. There are no loads but those of whole registers, and half as many
/// shuffles as for pairs of a list.
PW85_INLINE LanePair<3> load_eight(kernels::PairArrays<3> const &arrays) noexcept
{
    LanePair<3> pair;
    load_eight_rows(arrays.r12, pair.r12);
    load_eight_rows(arrays.q1, pair.q1);
    load_eight_rows(arrays.q2, pair.q2);
    pair.ratio = Pack(1.0);
    return pair;
}
#endif

/// Loads the pairs with the given indices.
template <class Rows>
PW85_INLINE LanePairOf<Rows> load(Rows const &rows, std::size_t const *indices) noexcept
{
    return load_pairs<Pack>(rows, indices);
}

/// Particles of lists, and their images, need much code, and are compiled once for
/// all kernels of a file. This costs no time, because packs do not stay in registers.
[[gnu::noinline, gnu::flatten]] inline LanePair<3> load(kernels::NeighborList const &list,
                                                        std::size_t const *indices) noexcept
{
    return load_pairs<Pack>(list, indices);
}

[[gnu::noinline, gnu::flatten]] inline LanePair<3> load(kernels::OneToIndexed const &rows,
                                                        std::size_t const *indices) noexcept
{
    return load_pairs<Pack>(rows, indices);
}

/// Loads `count` consecutive pairs. Lanes beyond the last pair repeat it.
template <class Rows> PW85_INLINE LanePairOf<Rows>
load_consecutive(Rows const &rows, std::size_t begin, std::size_t count) noexcept
{
#if defined(PW85_LANES_AVX512)
    if constexpr (std::is_same_v<Rows, kernels::PairArrays<3>>)
        if (count >= lanes) return load_eight(rows.from(begin));
#endif
    std::size_t indices[lanes];
    for (std::size_t i = 0; i < lanes; ++i) indices[i] = begin + (i < count ? i : count - 1);
    return load(rows, indices);
}

/// Fills the last pack of a list with copies of its last pair. Call this between the last push()
/// and load_listed().
template <std::size_t Capacity> PW85_INLINE void pad(kernels::IndexList<Capacity> &list) noexcept
{
    static_assert(Capacity % lanes == 0);
    for (std::size_t i = list.size; i % lanes != 0; ++i)
        list.indices[i] = list.indices[list.size - 1];
}

/// Loads as many pairs of a list as there are lanes.
template <class Rows>
PW85_INLINE LanePairOf<Rows> load_listed(Rows const &rows, std::uint16_t const *list) noexcept
{
    std::size_t indices[lanes];
    for (std::size_t i = 0; i < lanes; ++i) indices[i] = list[i];
    return load(rows, indices);
}

/// Copies the pairs of a list of indices into memory, with the separations and images that lanes
/// compute.
template <class Rows>
[[gnu::flatten]] void gather(Rows const &rows, std::uint16_t const *list, std::size_t count,
                             kernels::PairRow<Rows::dimension> *pairs) noexcept
{
    for (std::size_t k = 0; k < count; k += lanes) {
        std::size_t indices[lanes];
        for (std::size_t i = 0; i < lanes; ++i)
            indices[i] = list[k + i < count ? k + i : count - 1];
        auto const pack = load(rows, indices);
        for (std::size_t i = 0; i < lanes && k + i < count; ++i) {
            auto &pair = pairs[k + i];
            for (int d = 0; d < Rows::dimension; ++d) pair.r12[d] = pack.r12[d][i];
            for (int e = 0; e < pack.q1.size; ++e) {
                pair.q1[e] = pack.q1[e][i];
                pair.q2[e] = pack.q2[e][i];
            }
        }
    }
}

/// Returns a mask of the first `count` lanes; all lanes if there are fewer.
PW85_INLINE unsigned live_lanes(std::size_t count) noexcept
{
    return count >= lanes ? all_lanes : (1u << count) - 1u;
}

/// Calls visit(lane) for each lane whose bit is set.
template <class Visit> PW85_INLINE void for_lanes(unsigned bits, Visit const &visit) noexcept
{
    for (; bits != 0; bits &= bits - 1) visit(static_cast<unsigned>(__builtin_ctz(bits)));
}

/// Loads one number for each of `count` consecutive pairs. Lanes beyond the last pair repeat it.
PW85_INLINE Pack load_numbers(double const *x, std::size_t count) noexcept
{
    if (count >= lanes) return load_lanes<Pack>(x);
    double numbers[lanes];
    for (std::size_t i = 0; i < lanes; ++i) numbers[i] = x[i < count ? i : count - 1];
    return load_lanes<Pack>(numbers);
}

/// Stores one number for each of `count` consecutive pairs.
PW85_INLINE void store_lanes(Pack const &x, std::size_t count, double *out) noexcept
{
    if (count >= lanes)
        std::memcpy(out, &x.v, sizeof x.v);
    else
        for (std::size_t i = 0; i < count; ++i) out[i] = x[i];
}

/// Loads consecutive rows of N numbers. Lanes beyond the last row repeat it.
template <int N, class Columns>
PW85_INLINE void load_rows(double const *first, std::size_t count, Columns &columns) noexcept
{
#if defined(PW85_LANES_AVX512)
    if (count >= lanes) return load_eight_rows(first, columns);
#endif
    double const *rows[lanes];
    for (std::size_t i = 0; i < lanes; ++i)
        rows[i] = kernels::row_of(first, N, i < count ? i : count - 1);
    ColumnLoader<Pack, N>::load(rows, &columns[0]);
}

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
    if (count >= lanes)
        std::memcpy(rows, interleaved, sizeof interleaved); // three stores, not a call
    else
        std::memcpy(rows, interleaved, 3 * sizeof(double) * count);
}

} // namespace
} // namespace pw85::detail

#endif
