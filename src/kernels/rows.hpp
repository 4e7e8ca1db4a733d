/// @file
/// Loads of pairs, one per lane, from rows in memory.
#ifndef PW85_KERNELS_ROWS_HPP_INCLUDED
#define PW85_KERNELS_ROWS_HPP_INCLUDED

#include <cstring>

#include <pw85/scaling.hpp>

#include "kernels.hpp"
#include "nearest_image.hpp"
#include "pack.hpp"

namespace pw85 {
namespace {

using LanePair = Pair<Pack, 3>;

/// Two neighbouring columns.
struct Columns {
    Pack first, second;
};

/// Two doubles of every other row.
template <std::size_t N>
PW85_INLINE typename VectorOf<N>::Doubles gather_twos(double const *const *rows, std::size_t column) noexcept
{
    if constexpr (N == 2) {
        typename VectorOf<2>::Doubles two;
        std::memcpy(&two, rows[0] + column, sizeof two);
        return two;
    } else {
#if defined(PW85_LANES_AVX512) || defined(PW85_LANES_AVX2)
        auto const low = gather_twos<N / 2>(rows, column), high = gather_twos<N / 2>(rows + N / 2, column);
        if constexpr (N == 4) return _mm256_insertf128_pd(_mm256_castpd128_pd256(low), high, 1);
#if defined(PW85_LANES_AVX512)
        else
            return _mm512_insertf64x4(_mm512_castpd256_pd512(low), high, 1);
#endif
#endif
    }
}

/// Columns `column` and `column` + 1 of as many rows as there are lanes, by shuffles in registers.
PW85_INLINE Columns load_columns(double const *const *rows, std::size_t column) noexcept
{
    Register const even = gather_twos<lanes>(rows, column), odd = gather_twos<lanes>(rows + 1, column);
#if defined(PW85_LANES_AVX512)
    return {_mm512_unpacklo_pd(even, odd), _mm512_unpackhi_pd(even, odd)};
#elif defined(PW85_LANES_AVX2)
    return {_mm256_unpacklo_pd(even, odd), _mm256_unpackhi_pd(even, odd)};
#else
    return {Register{even[0], odd[0]}, Register{even[1], odd[1]}};
#endif
}

PW85_INLINE Vector<Pack, 3> load_vectors(double const *const *rows) noexcept
{
    Columns const xy = load_columns(rows, 0), yz = load_columns(rows, 1);
    return {xy.first, xy.second, yz.second};
}

#if defined(PW85_LANES_AVX512)
/// The first four columns: row i beside row i + 4, transposed by fours.
PW85_INLINE void load_four_columns(double const *const *rows, SymmetricMatrix<Pack, 3> &a) noexcept
{
    __m512d two[4];
    for (std::size_t i = 0; i < 4; ++i)
        two[i] = _mm512_insertf64x4(_mm512_castpd256_pd512(_mm256_loadu_pd(rows[i])), _mm256_loadu_pd(rows[i + 4]), 1);
    __m512d const even01 = _mm512_unpacklo_pd(two[0], two[1]), odd01 = _mm512_unpackhi_pd(two[0], two[1]);
    __m512d const even23 = _mm512_unpacklo_pd(two[2], two[3]), odd23 = _mm512_unpackhi_pd(two[2], two[3]);
    __m512i const low = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13),
                  high = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
    a[0] = _mm512_permutex2var_pd(even01, low, even23);
    a[1] = _mm512_permutex2var_pd(odd01, low, odd23);
    a[2] = _mm512_permutex2var_pd(even01, high, even23);
    a[3] = _mm512_permutex2var_pd(odd01, high, odd23);
}
#else
PW85_INLINE void load_four_columns(double const *const *rows, SymmetricMatrix<Pack, 3> &a) noexcept
{
    for (std::size_t column = 0; column < 4; column += 2) {
        Columns const c = load_columns(rows, column);
        a[static_cast<int>(column)] = c.first;
        a[static_cast<int>(column) + 1] = c.second;
    }
}
#endif

PW85_INLINE SymmetricMatrix<Pack, 3> load_matrices(double const *const *rows) noexcept
{
    SymmetricMatrix<Pack, 3> a;
    load_four_columns(rows, a);
    Columns const last = load_columns(rows, 4);
    a[4] = last.first;
    a[5] = last.second;
    return a;
}

/// The pairs of the batch form.
struct BatchRows {
    kernels::PairArrays arrays;

    PW85_INLINE LanePair load(std::size_t const *indices) const noexcept
    {
        double const *r12[lanes], *q1[lanes], *q2[lanes];
        for (std::size_t i = 0; i < lanes; ++i) {
            r12[i] = arrays.r12 + 3 * indices[i];
            q1[i] = arrays.q1 + 6 * indices[i];
            q2[i] = arrays.q2 + 6 * indices[i];
        }
        return {load_vectors(r12), load_matrices(q1), load_matrices(q2), Pack(1.0)};
    }

    PW85_INLINE void prefetch(std::size_t, std::size_t) const noexcept {}

    /// The pairs from `begin` on.
    PW85_INLINE BatchRows from(std::size_t begin) const noexcept
    {
        return {{arrays.r12 + 3 * begin, arrays.q1 + 6 * begin, arrays.q2 + 6 * begin}};
    }
};

/// Pairs whose particles are asked for ahead: a chunk of the contact function with 8 lanes.
inline constexpr std::size_t prefetch_distance = 128;

/// The pairs of a neighbour list.
struct ParticleRows {
    kernels::NeighborList list;

    PW85_INLINE LanePair load(std::size_t const *indices) const noexcept
    {
        double const *center1[lanes], *center2[lanes], *q1[lanes], *q2[lanes];
        for (std::size_t i = 0; i < lanes; ++i) {
            auto const first = static_cast<std::size_t>(list.pairs[2 * indices[i]]);
            auto const second = static_cast<std::size_t>(list.pairs[2 * indices[i] + 1]);
            center1[i] = list.centers + 3 * first;
            center2[i] = list.centers + 3 * second;
            q1[i] = list.q + 6 * first;
            q2[i] = list.q + 6 * second;
        }
        Vector<Pack, 3> const x = load_vectors(center1), y = load_vectors(center2);
        Vector<Pack, 3> r12 = {y[0] - x[0], y[1] - x[1], y[2] - x[2]};
        if (list.images != nullptr)
            r12 = add_images(r12, indices);
        else if (list.lattice != nullptr)
            r12 = nearest_image(*list.lattice, r12);
        return {r12, load_matrices(q1), load_matrices(q2), Pack(1.0)};
    }

    /// Particles of neighbouring pairs may be anywhere in memory: asks for those of the next pairs, up to end, well before
    /// they are used.
    PW85_INLINE void prefetch(std::size_t begin, std::size_t end) const noexcept
    {
        for (std::size_t k = 2 * begin; k < 2 * end && k < 2 * begin + 2 * prefetch_distance; ++k) {
            auto const particle = static_cast<std::size_t>(list.pairs[k]);
            __builtin_prefetch(list.centers + 3 * particle);
            __builtin_prefetch(list.q + 6 * particle);
            __builtin_prefetch(list.q + 6 * particle + 5);
        }
    }

    /// The pairs from `begin` on.
    PW85_INLINE ParticleRows from(std::size_t begin) const noexcept
    {
        ParticleRows rest = *this;
        rest.list.pairs += 2 * begin;
        if (rest.list.images != nullptr) rest.list.images += 3 * begin;
        return rest;
    }

  private:
    /// Separations plus the cell vectors that the list adds to the second particles.
    PW85_INLINE Vector<Pack, 3> add_images(Vector<Pack, 3> r12, std::size_t const *indices) const noexcept
    {
        for (std::size_t row = 0; row < 3; ++row) {
            double multiples[lanes];
            for (std::size_t i = 0; i < lanes; ++i) multiples[i] = list.images[3 * indices[i] + row];
            Pack const n = load_lanes<Pack>(multiples);
            for (int d = 0; d < 3; ++d) r12[d] = r12[d] + n * Pack(list.cell[3 * row + static_cast<std::size_t>(d)]);
        }
        return r12;
    }
};

/// Bits of the first `count` lanes.
PW85_INLINE unsigned live_lanes(std::size_t count) noexcept { return count >= lanes ? all_lanes : (1u << count) - 1u; }

/// Some pairs of a chunk, by their offsets from its first one; the last pack is filled up with the last pair again.
template <std::size_t Capacity> class OffsetList {
    static_assert(Capacity % lanes == 0 && Capacity <= 65536);

  public:
    PW85_INLINE explicit OffsetList(std::size_t begin) noexcept : begin_(begin) {}

    PW85_INLINE void push(std::size_t offset) noexcept { offsets_[size_++] = static_cast<std::uint16_t>(offset); }
    /// The offsets stay where they are until push() overwrites them.
    PW85_INLINE void clear() noexcept { size_ = 0; }
    PW85_INLINE std::size_t begin() const noexcept { return begin_; }
    PW85_INLINE std::size_t size() const noexcept { return size_; }
    PW85_INLINE std::size_t packs() const noexcept { return (size_ + lanes - 1) / lanes; }
    PW85_INLINE std::size_t offset(std::size_t k, std::size_t i) const noexcept { return offsets_[k * lanes + i]; }

    /// To be called between the last push() and load().
    PW85_INLINE void pad() noexcept
    {
        for (std::size_t i = size_; i < packs() * lanes; ++i) offsets_[i] = offsets_[size_ - 1];
    }

    template <class Rows> PW85_INLINE LanePair load(Rows const &rows, std::size_t k) const noexcept
    {
        std::size_t indices[lanes];
        for (std::size_t i = 0; i < lanes; ++i) indices[i] = begin_ + offset(k, i);
        return rows.load(indices);
    }

  private:
    std::size_t begin_, size_ = 0;
    std::uint16_t offsets_[Capacity];
};

/// Loads neighbouring pairs; lanes beyond the last one repeat it.
template <class Rows>
PW85_INLINE LanePair load_neighbors(Rows const &rows, std::size_t begin, std::size_t count) noexcept
{
    std::size_t indices[lanes];
    for (std::size_t i = 0; i < lanes; ++i) indices[i] = begin + (i < count ? i : count - 1);
    return rows.load(indices);
}

/// Calls visit(index, r12, q1, q2) for each pair of a list.
template <class Rows, std::size_t Capacity, class Visit>
inline void visit_pairs(Rows const &rows, OffsetList<Capacity> &list, Visit visit) noexcept
{
    list.pad();
    for (std::size_t k = 0; k < list.packs(); ++k) {
        LanePair const pair = list.load(rows, k);
        for (std::size_t i = 0; i < lanes && k * lanes + i < list.size(); ++i) {
            double r12[3], q1[6], q2[6];
            for (int d = 0; d < 3; ++d) r12[d] = pair.r12[d][i];
            for (int e = 0; e < 6; ++e) {
                q1[e] = pair.q1[e][i];
                q2[e] = pair.q2[e][i];
            }
            visit(list.begin() + list.offset(k, i), r12, q1, q2);
        }
    }
}

} // namespace
} // namespace pw85

#endif
