// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The numbers of a pair as integers times powers of two, and the terms of the polynomials a(t) =
/// rᵀ adj(Q1 + t Q2) r and b(t) = det(Q1 + t Q2), as products of these numbers. exact.hpp and
/// exact_containment.hpp add these terms.
///
/// The functions that compute a(t) and b(t) also give their terms, if they are called with symbols
/// instead of numbers (symbolic_form()).
#ifndef PW85_OVERLAP_EXACT_NUMBERS_HPP_INCLUDED
#define PW85_OVERLAP_EXACT_NUMBERS_HPP_INCLUDED

#include <pw85/algebra/extended_number.hpp>
#include <pw85/contact/rational.hpp>

namespace pw85::detail::exact {

/// coefficient·Π x[factors[i]] over i < degree.
struct Monomial {
    signed char coefficient, degree;
    unsigned char factors[4];
};

/// A sum of monomials.
struct Polynomial {
    Monomial terms[48];
    int size;

    Polynomial() noexcept = default;
    PW85_MEMBER constexpr Polynomial(int constant) noexcept
        : terms{{static_cast<signed char>(constant), 0, {}}}, size(constant != 0)
    {
    }
};

PW85_FUNCTION constexpr Polynomial variable(int index) noexcept
{
    Polynomial x(1);
    x.terms[0].degree = 1;
    x.terms[0].factors[0] = static_cast<unsigned char>(index);
    return x;
}

PW85_FUNCTION constexpr Monomial operator*(Monomial x, Monomial const &y) noexcept
{
    x.coefficient = static_cast<signed char>(x.coefficient * y.coefficient);
    for (int i = 0; i < y.degree; ++i) x.factors[static_cast<int>(x.degree++)] = y.factors[i];
    return x;
}

PW85_FUNCTION constexpr bool has_same_factors(Monomial const &x, Monomial const &y) noexcept
{
    bool same = x.degree == y.degree;
    for (int i = 0; i < 4; ++i) same = same && x.factors[i] == y.factors[i];
    return same;
}

PW85_FUNCTION constexpr void add(Polynomial &sum, Monomial const &term) noexcept
{
    int i = 0;
    while (i < sum.size && !has_same_factors(sum.terms[i], term)) ++i;
    if (i == sum.size)
        sum.terms[sum.size++] = term;
    else
        sum.terms[i].coefficient =
            static_cast<signed char>(sum.terms[i].coefficient + term.coefficient);
}

PW85_FUNCTION constexpr Polynomial operator*(Polynomial const &x, Polynomial const &y) noexcept
{
    Polynomial product(0);
    for (int i = 0; i < x.size; ++i)
        for (int j = 0; j < y.size; ++j) add(product, x.terms[i] * y.terms[j]);
    return product;
}

PW85_FUNCTION constexpr Polynomial operator+(Polynomial x, Polynomial const &y) noexcept
{
    for (int i = 0; i < y.size; ++i) add(x, y.terms[i]);
    return x;
}

PW85_FUNCTION constexpr Polynomial operator-(Polynomial const &x) noexcept
{
    return Polynomial(-1) * x;
}
PW85_FUNCTION constexpr Polynomial operator-(Polynomial const &x, Polynomial const &y) noexcept
{
    return x + -y;
}

/// Returns the rational form, with b multiplied by m, in the symbols x. The symbols stand for r12,
/// q1, q2 and m in this order.
template <int D> PW85_FUNCTION constexpr RationalForm<Polynomial> symbolic_form() noexcept
{
    Pair<Polynomial, D> pair{};
    int index = 0;
    for (int i = 0; i < D; ++i) pair.r12[i] = variable(index++);
    for (int k = 0; k < pair.q1.size; ++k) pair.q1[k] = variable(index++);
    for (int k = 0; k < pair.q2.size; ++k) pair.q2[k] = variable(index++);
    auto form = rational_form(pair);
    for (auto &coefficient : form.b) coefficient = coefficient * variable(index);
    return form;
}

/// A number sign·m·2^exponent with an odd integer m. The number is zero if the sign is zero. It has
/// room for one digit more than T.
template <class T> struct BinaryFraction {
    Digits<limbs_for(std::numeric_limits<T>::digits + 1)> magnitude; ///< m
    int length;                                                      ///< bits of m
    int exponent;
    int sign;
};

/// Converts a finite number exactly.
template <class T> PW85_FUNCTION inline BinaryFraction<T> to_binary_fraction(T const &x) noexcept
{
    constexpr T radix = T(2) * static_cast<T>(Limb{1} << (limb_bits - 1));
    BinaryFraction<T> result{};
    if (x == T(0)) return result;
    auto &m = result.magnitude;
    T fraction = elementary::frexp(absolute(x), &result.exponent);
    for (int i = m.size - 1; i >= 0; --i) {
        fraction *= radix;
        m.limbs[i] = static_cast<Limb>(fraction);
        fraction -= static_cast<T>(m.limbs[i]);
    }
    int const zeros = trailing_zeros(m);
    m = over_power_of_two(m, zeros);
    result.length = m.size * limb_bits - zeros;
    result.exponent -= result.length;
    result.sign = x < T(0) ? -1 : 1;
    return result;
}

/// A range of binary digits. The numbers are multiples of 2^low and smaller than 2^high.
struct BitRange {
    int low, high;

    template <class T> [[gnu::always_inline]] void include(BinaryFraction<T> const &x) noexcept
    {
        if (x.sign == 0) return;
        low = minimum(low, x.exponent);
        high = maximum(high, x.exponent + x.length);
    }
};

/// Returns the empty range.
PW85_FUNCTION constexpr BitRange no_digits() noexcept { return {1 << 24, -(1 << 24)}; }

/// The numbers of a pair and of a comparison, in the order of symbolic_form().
template <class T, int D> struct Numbers {
    BinaryFraction<T> x[std::size_t(D * (D + 2) + 1)];
    BitRange r, q, m; ///< ranges of the coordinates, of the entries of both forms, and of m
};

/// Converts the numbers of a pair and of a comparison. `m` must be positive.
template <class T, int D> PW85_FUNCTION inline Numbers<T, D>
to_numbers(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
           SymmetricMatrix<T, D> const &q2, BinaryFraction<T> const &m) noexcept
{
    Numbers<T, D> numbers;
    numbers.r = numbers.q = numbers.m = no_digits();
    int index = 0;
    for (int i = 0; i < D; ++i) numbers.r.include(numbers.x[index++] = to_binary_fraction(r12[i]));
    for (int k = 0; k < q1.size; ++k)
        numbers.q.include(numbers.x[index++] = to_binary_fraction(q1[k]));
    for (int k = 0; k < q2.size; ++k)
        numbers.q.include(numbers.x[index++] = to_binary_fraction(q2[k]));
    numbers.m.include(numbers.x[index] = m);
    return numbers;
}

template <class T, int D> PW85_FUNCTION inline Numbers<T, D>
to_numbers(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
           SymmetricMatrix<T, D> const &q2, T const &m = T(1)) noexcept
{
    return to_numbers(r12, q1, q2, to_binary_fraction(m));
}

/// The exponent of a power of two that exceeds all entries of m Q1 and m Q2.
template <class T, int D>
PW85_FUNCTION inline int high_of_forms(Numbers<T, D> const &numbers) noexcept
{
    return numbers.q.high + numbers.m.high;
}

/// Returns whether the sizes of the numbers show that the bounding boxes of m Q1 and m Q2 are
/// apart. The half-widths are below √2^high_of_forms(), and a coordinate is at least 2^(r.high -
/// 1).
template <class T, int D> PW85_FUNCTION inline bool is_far(Numbers<T, D> const &numbers) noexcept
{
    return 2 * numbers.r.high >= high_of_forms(numbers) + 4;
}

// A term of p(t) = t a(t) - m (1 + t) b(t) is a product of D - 1 entries of the forms and of two
// more factors: either two coordinates, or one more entry and m. No coefficient has more than 72
// terms: 36 in rᵀ adj r, where a cofactor has up to 4, and 18 in each of two coefficients of det.

/// The coefficients of p are multiples of 2^unit.
template <class T, int D> PW85_FUNCTION inline int unit(Numbers<T, D> const &numbers) noexcept
{
    return (D - 1) * numbers.q.low + minimum(2 * numbers.r.low, numbers.q.low + numbers.m.low);
}

/// The coefficients of p are smaller than 2^(unit + bits).
template <class T, int D> PW85_FUNCTION inline int bits(Numbers<T, D> const &numbers) noexcept
{
    return (D - 1) * numbers.q.high + maximum(2 * numbers.r.high, high_of_forms(numbers)) + 7 -
           unit(numbers);
}

/// The largest value of bits() for pairs that are not far and for m < 2^high. By default `high` is
/// for m = 1. Every number is a multiple of the smallest positive number.
template <class T> PW85_FUNCTION constexpr int max_bits(int high = 1) noexcept
{
    using Limits = std::numeric_limits<T>;
    return 3 * Limits::max_exponent + high + 3 + 7 - 4 * (Limits::min_exponent - Limits::digits);
}

/// The magnitude of the product of `Count` consecutive factors of a monomial, beginning with the
/// given one. The factors are numbers.x.
template <int Count, class N> PW85_FUNCTION inline auto
magnitude_of_product(N const &numbers, Monomial const &monomial, int first = 0) noexcept
{
    if constexpr (Count == 1)
        return numbers.x[monomial.factors[first]].magnitude;
    else
        return magnitude_of_product<Count / 2>(numbers, monomial, first) *
               magnitude_of_product<Count - Count / 2>(numbers, monomial, first + Count / 2);
}

/// The value of a monomial: sign·2^(unit() + limb_bits·position)·magnitude.
template <int N> struct Term {
    Digits<N> magnitude;
    int position;
    int sign;
};

template <int Degree, class N>
PW85_FUNCTION inline auto evaluate(N const &numbers, Monomial const &monomial) noexcept
{
    int sign = monomial.coefficient < 0 ? -1 : 1;
    // the coefficient is ±1 or ±2
    int exponent = (monomial.coefficient % 2 == 0 ? 1 : 0) - unit(numbers);
    for (int i = 0; i < Degree; ++i) {
        sign *= numbers.x[monomial.factors[i]].sign;
        exponent += numbers.x[monomial.factors[i]].exponent;
    }
    if (sign == 0) exponent = 0;
    auto const shifted =
        times_power_of_two(magnitude_of_product<Degree>(numbers, monomial), exponent % limb_bits);
    return Term<shifted.size>{shifted, exponent / limb_bits, sign};
}

template <int N> PW85_FUNCTION inline void add(WideSum sum, Term<N> const &term, int sign) noexcept
{
    if (term.sign != 0) add(sum, term.magnitude, term.position, sign * term.sign);
}

} // namespace pw85::detail::exact

#endif
