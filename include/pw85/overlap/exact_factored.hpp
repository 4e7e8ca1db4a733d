// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Decides in integers whether ellipsoids overlap that are given by factors, Qi = Si Siᵀ. It is the
/// last tier of overlap_factored.hpp. The quartic is that of exact.hpp with m = 1, for the exact
/// products.
///
/// Let c_j be the 2D columns of S1 and S2, and let t_j be 1 for columns of S1 and t for columns of
/// S2. Then M = Σ t_j c_j c_jᵀ, and the formula of Cauchy and Binet gives det M as the sum of (Π
/// t_j) det(columns)² over all choices of D columns, and rᵀ adj(M) r as the same sum with r and D -
/// 1 columns. So no product Si Siᵀ is needed.
#ifndef PW85_OVERLAP_EXACT_FACTORED_HPP_INCLUDED
#define PW85_OVERLAP_EXACT_FACTORED_HPP_INCLUDED

#include <pw85/contact/factor.hpp>
#include <pw85/overlap/exact.hpp>

namespace pw85::detail {

namespace exact {

/// The vectors of a pair: r12, the columns of S1, and the columns of S2.
template <class T, int D> struct ExactColumns {
    BinaryFraction<T> x[std::size_t(2 * D + 1)][std::size_t(D)];
    BitRange r, s; ///< ranges of the coordinates of r12, and of the entries of both factors
};

template <class T, int D> PW85_FUNCTION inline ExactColumns<T, D>
to_columns(Vector<T, D> const &r12, Factor<T, D> const &s1, Factor<T, D> const &s2) noexcept
{
    ExactColumns<T, D> columns;
    columns.r = columns.s = no_digits();
    for (int i = 0; i < D; ++i) {
        columns.r.include(columns.x[0][i] = to_binary_fraction(r12[i]));
        for (int j = 0; j < D; ++j) {
            columns.s.include(columns.x[1 + j][i] = to_binary_fraction(s1(i, j)));
            columns.s.include(columns.x[1 + D + j][i] = to_binary_fraction(s2(i, j)));
        }
    }
    return columns;
}

/// Returns whether the sizes of the numbers show that the bounding boxes are apart. The half-widths
/// are below √3 2^s.high, and a coordinate of r12 is at least 2^(r.high - 1).
template <class T, int D>
PW85_FUNCTION inline bool is_far(ExactColumns<T, D> const &columns) noexcept
{
    return columns.r.high >= columns.s.high + 3;
}

/// The determinants are multiples of 2^unit.
template <class T, int D> PW85_FUNCTION inline int unit(ExactColumns<T, D> const &columns) noexcept
{
    return (D - 1) * columns.s.low + minimum(columns.r.low, columns.s.low);
}

/// The coefficients of p are smaller than 2^(2 unit + bits). A determinant has up to 6 terms, and a
/// coefficient is a sum of up to 27 squares of determinants.
template <class T, int D> PW85_FUNCTION inline int bits(ExactColumns<T, D> const &columns) noexcept
{
    return 2 * ((D - 1) * columns.s.high + maximum(columns.r.high, columns.s.high) -
                unit(columns)) +
           10;
}

/// The largest value of bits() for which there is memory. It suffices if all numbers of a pair that
/// is not far are multiples of some power of two, and smaller than its product with 2^1500.
inline constexpr int max_bits_of_columns = 6 * 1500 + 2 * 2 + 10;

/// The coordinates of D vectors as numbers of a monomial.
template <class T, int D> struct SquareOfNumbers {
    BinaryFraction<T> x[std::size_t(D * D)];
    int exponent;
};

template <class T, int D>
PW85_FUNCTION inline int unit(SquareOfNumbers<T, D> const &square) noexcept
{
    return square.exponent;
}

/// Returns the determinant of D columns in symbols, which stand for the columns one after the
/// other.
template <int D> PW85_FUNCTION constexpr Polynomial symbolic_determinant() noexcept
{
    Vector<Polynomial, D> columns[std::size_t(D)];
    for (int j = 0; j < D; ++j)
        for (int i = 0; i < D; ++i) columns[j][i] = variable(D * j + i);
    return detail::determinant(columns);
}

/// The determinant of the vectors whose bits are set in `choice`, in units of 2^unit().
template <class T, int D> PW85_FUNCTION inline WideInteger
determinant_of(ExactColumns<T, D> const &columns, unsigned choice, WideSum sum) noexcept
{
    static constexpr auto symbolic = symbolic_determinant<D>();
    SquareOfNumbers<T, D> square;
    square.exponent = unit(columns);
    int index = 0;
    for (int k = 0; k <= 2 * D; ++k)
        for (int i = 0; i < D && (choice >> k & 1u) != 0; ++i) square.x[index++] = columns.x[k][i];
    for (int i = 0; i < symbolic.size; ++i) add(sum, evaluate<D>(square, symbolic.terms[i]), 1);
    return value(sum);
}

/// Memory for a determinant.
PW85_FUNCTION constexpr int limbs_of_determinant(int bits) noexcept { return limbs_for(bits / 2); }

/// Computes the coefficients of p, in memory for five of them. It also uses memory for a
/// determinant.
template <class T, int D> [[gnu::noinline]] static Quartic
make_quartic(ExactColumns<T, D> const &columns, Limb *memory, Limb *scratch) noexcept
{
    int const n = bits(columns), size = Sizes(n).coefficient;
    constexpr unsigned second = ((1u << D) - 1u) << (D + 1);
    WideSum sums[5];
    for (int k = 0; k < 5; ++k) sums[k] = zero_sum(memory + k * size, size);
    for (unsigned choice = 0; choice < 2u << (2 * D); ++choice) {
        if (std::popcount(choice) != D) continue;
        auto const d = determinant_of(columns, choice, zero_sum(scratch, limbs_of_determinant(n)));
        int const power = std::popcount(choice & second);
        bool const with_r12 = (choice & 1u) != 0;
        add_product(sums[power + 1], with_r12 ? 1 : -1, d, d);
        if (!with_r12) add_product(sums[power], -1, d, d);
    }
    return {{value(sums[0]), value(sums[1]), value(sums[2]), value(sums[3]), value(sums[4])}};
}

} // namespace exact

/// Decides whether two ellipsoids overlap, for the numbers exactly as given. The factors must be
/// regular, and r12 not zero. The result is Decision::none only if there is no memory for the
/// digits (max_bits_of_columns). It uses a fixed array on the stack, of 11.6 KiB.
template <class T, int D>
requires exact::is_decidable<T> PW85_RARE Decision decide_factored_exactly(Vector<T, D> const &r12,
                                                                           Factor<T, D> const &s1,
                                                                           Factor<T, D> const &s2)
noexcept
{
    using namespace exact;
    Limb memory[std::size_t(Sizes(max_bits_of_columns).total +
                            limbs_of_determinant(max_bits_of_columns))];
    auto const columns = to_columns(r12, s1, s2);
    if (is_far(columns)) return Decision::apart;
    if (bits(columns) > max_bits_of_columns) return Decision::none;
    Sizes const sizes(bits(columns));
    bool const overlap = sign_of_quartic(sizes, memory, [&] {
                             return make_quartic(columns, memory, memory + sizes.total);
                         }) < 0;
    return to_decision(!overlap, overlap);
}

PW85_RARE_TIER_OF(decide_factored_exactly, double, 3)

} // namespace pw85::detail

#endif
