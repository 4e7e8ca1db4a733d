// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The sign of μ² - m in integers, for any number m > 0. It is the last tier of compare.hpp and,
/// with m = 1, of overlap.hpp.
///
/// The ellipsoids of the forms m Q1 and m Q2 are apart, touch or overlap if μ² - m is positive,
/// zero or negative. With a(t) = rᵀ adj(Q1 + t Q2) r and b(t) = det(Q1 + t Q2), they are apart or
/// tangent if and only if the quartic p(t) = t a(t) - m (1 + t) b(t) has a root t > 0
/// (quartic.hpp). The first and the last coefficient of p are negative.
///
/// 1. Two roots are negative, counted with multiplicity. Let Q1 = I and Q2 = diag(d), d1 >= d2 >=
///    d3 > 0. This is no restriction, because a congruence multiplies p by a positive number. For m
///    = 1, p(-1/di) = -(ri²/di) Π (1 - dj/di) over j != i, which is <= 0, >= 0 and <= 0. So there
///    are two roots between the three points. If a value is zero, the roots are limits of such
///    roots.
/// 2. The two other roots are either real or a complex pair. The discriminant is negative for a
///    complex pair. If the discriminant is zero, two roots coincide. Then the next subdiscriminant
///    (the sum over i, j, k of (xi-xj)²(xj-xk)²(xk-xi)²) is negative for a complex pair beside a
///    negative double root, and not negative if all roots are real.
/// 3. If all roots are real, Descartes' rule of signs is exact: there is a positive root if and
///    only if there is a positive coefficient. Without a positive coefficient there is never a
///    positive root.
/// 4. Let I = 12ae - 3bd + c² and J = 72ace + 9bcd - 27ad² - 27eb² - 2c³ for p = at⁴ + bt³ + ct² +
///    dt + e. The discriminant has the sign of 4I³ - J². If the discriminant is zero, the
///    subdiscriminant has the sign of 2aJ + I(3b² - 8ac).
/// 5. If all roots are real and two are positive, the ellipsoids are tangent if and only if the
///    positive roots coincide. Then the discriminant is zero. No three roots coincide, because two
///    are negative. So if the subdiscriminant is zero, there are two double roots, and the positive
///    one is double. If it is positive, there is one double root x. Let H be the Hessian of p as a
///    binary form. The covariant 2J p + I H is k (t - x)⁴ with k = 2aJ + I(3b² - 8ac) > 0. Its
///    second coefficient gives -4kx = 2bJ + 4I(bc - 6ad). As J² = 4I³, this has the sign of bc -
///    6ad + s b √I, where s is the sign of J.
/// 6. In two dimensions p is a cubic with one negative root. Everything above holds with a = 0.
#ifndef PW85_OVERLAP_EXACT_HPP_INCLUDED
#define PW85_OVERLAP_EXACT_HPP_INCLUDED

#include <type_traits>

#include <pw85/algebra/extended_number.hpp>
#include <pw85/contact/rational.hpp>
#include <pw85/overlap/decision.hpp>

namespace pw85::detail {

namespace exact {

// The functions that compute a(t) and b(t) also give their terms, if they are called with symbols
// instead of numbers.

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

/// The rational form, with b multiplied by m, in the symbols x. The symbols stand for r12, q1, q2
/// and m in this order.
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

/// The empty range.
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

/// Whether the sizes of the numbers show that the bounding boxes of m Q1 and m Q2 are apart. The
/// half-widths are below √2^high_of_forms(), and a coordinate is at least 2^(r.high - 1).
template <class T, int D> PW85_FUNCTION inline bool is_far(Numbers<T, D> const &numbers) noexcept
{
    return 2 * numbers.r.high >= high_of_forms(numbers) + 4;
}

// A term of p is a product of D - 1 entries of the forms and of two more factors: either two
// coordinates, or one more entry and m. No coefficient has more than 72 terms: 36 in rᵀ adj r,
// where a cofactor has up to 4, and 18 in each of two coefficients of det.

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

/// The numbers of limbs of sums that are computed from coefficients below 2^bits. One bit is for
/// the sign.
struct Sizes {
    int coefficient;
    /// up to 83 products of two coefficients; fits into the memory of two coefficients
    int quadratic;
    int cubic; ///< 2J: 274 products of three coefficients
    /// 16I²: 16·16² products of four coefficients; fits into the memory of the five coefficients
    int quartic;
    int total;

    [[gnu::always_inline]] explicit constexpr Sizes(int bits) noexcept
        : coefficient(limbs_for(bits + 4)), quadratic(limbs_for(2 * bits + 8)),
          cubic(limbs_for(3 * bits + 10)), quartic(limbs_for(4 * bits + 13)),
          total(5 * coefficient + quadratic + cubic)
    {
    }
};

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

/// The coefficients of p, by powers of t.
struct Quartic {
    WideInteger coefficients[5];
};

/// Computes the coefficients in units of 2^unit(), in memory for five of them.
template <class T, int D>
[[gnu::noinline]] static Quartic make_quartic(Numbers<T, D> const &numbers, Limb *memory) noexcept
{
    static constexpr auto form = symbolic_form<D>();
    int const size = Sizes(bits(numbers)).coefficient;
    WideSum sums[5];
    for (int k = 0; k < 5; ++k) sums[k] = zero_sum(memory + k * size, size);
    for (int k = 0; k < 3; ++k)
        for (int i = 0; i < form.a[k].size; ++i)
            add(sums[k + 1], evaluate<D + 1>(numbers, form.a[k].terms[i]), 1);
    for (int k = 0; k < 4; ++k)
        for (int i = 0; i < form.b[k].size; ++i) {
            auto const term = evaluate<D + 1>(numbers, form.b[k].terms[i]);
            add(sums[k], term, -1);
            add(sums[k + 1], term, -1);
        }
    return {{value(sums[0]), value(sums[1]), value(sums[2]), value(sums[3]), value(sums[4])}};
}

/// Computes 2J in the memory of a cubic sum. It also uses the memory of a quadratic sum.
[[gnu::noinline]] PW85_FUNCTION inline WideInteger twice_j(Quartic const &p, Sizes const &sizes,
                                                           Limb *memory, Limb *scratch) noexcept
{
    auto const &[e, d, c, b, a] = p.coefficients;
    WideSum const sum = zero_sum(memory, sizes.cubic);
    WideSum square = zero_sum(scratch, sizes.quadratic);
    add_product(square, -1, d, d);
    add_product(sum, 1, a, value(square));
    square = zero_sum(scratch, sizes.quadratic);
    add_product(square, -1, b, b);
    add_product(sum, 1, e, value(square));
    multiply(sum, 27);
    WideSum const rest = zero_sum(scratch, sizes.quadratic);
    add_product(rest, 1, a, e);
    multiply(rest, 8);
    add_product(rest, 1, b, d);
    multiply(rest, 9);
    add_product(rest, -1, c, c);
    add_product(rest, -1, c, c);
    add_product(sum, 1, c, value(rest));
    multiply(sum, 2);
    return value(sum);
}

PW85_FUNCTION inline WideInteger invariant_i(Quartic const &p, Sizes const &sizes,
                                             Limb *memory) noexcept
{
    auto const &[e, d, c, b, a] = p.coefficients;
    WideSum const sum = zero_sum(memory, sizes.quadratic);
    add_product(sum, 1, a, e);
    multiply(sum, 4);
    add_product(sum, -1, b, d);
    multiply(sum, 3);
    add_product(sum, 1, c, c);
    return value(sum);
}

/// The sign of the discriminant. It uses the memory of a quartic sum.
PW85_FUNCTION inline int sign_of_discriminant(WideInteger i, WideInteger twice_j,
                                              Sizes const &sizes, Limb *memory) noexcept
{
    if (i.sign < 0) return -1;
    WideSum const square = zero_sum(memory, sizes.quartic);
    add_product(square, 1, i, i);
    multiply(square, 16);
    return compare_products(value(square), i, twice_j, twice_j);
}

/// The sign of the subdiscriminant if the discriminant is zero. It uses the memory of a quadratic
/// sum.
PW85_FUNCTION inline int sign_of_subdiscriminant(Quartic const &p, WideInteger i,
                                                 WideInteger twice_j, Sizes const &sizes,
                                                 Limb *memory) noexcept
{
    auto const &[e, d, c, b, a] = p.coefficients;
    WideSum const sum = zero_sum(memory, sizes.quadratic);
    add_product(sum, -1, a, c);
    multiply(sum, 8);
    for (int n = 0; n < 3; ++n) add_product(sum, 1, b, b);
    WideInteger const k = value(sum);
    int const left = i.sign * k.sign, right = -a.sign * twice_j.sign;
    return left != right ? (left > right ? 1 : -1) : left * compare_products(i, k, a, twice_j);
}

/// The sign of the double root if there is one and the other roots are real and simple. It uses the
/// memory of two quadratic sums. The second one may be that of the last two coefficients.
PW85_FUNCTION inline int sign_of_double_root(Quartic const &p, WideInteger i, int sign_of_j,
                                             Sizes const &sizes, Limb *first, Limb *second) noexcept
{
    auto const &[e, d, c, b, a] = p.coefficients;
    WideSum const sum = zero_sum(first, sizes.quadratic);
    add_product(sum, -1, a, d);
    multiply(sum, 6);
    add_product(sum, 1, b, c);
    WideInteger const k = value(sum);
    WideSum const square = zero_sum(second, sizes.quadratic);
    add_product(square, 1, b, b);
    int const left = k.sign, right = -sign_of_j * b.sign;
    return left != right ? (left > right ? -1 : 1)
                         : -left * compare_products(k, k, value(square), i);
}

/// The sign of the maximum of p over t > 0, for a p with a positive coefficient. p is the first
/// thing in its memory of `total` limbs, and is overwritten. make() computes it there again.
template <class Make> PW85_FUNCTION inline int
sign_of_maximum(Quartic const &p, Sizes const &sizes, Limb *memory, Make const &make) noexcept
{
    Limb *const quadratic = memory + 5 * sizes.coefficient, *const cubic =
                                                                quadratic + sizes.quadratic;
    WideInteger const twice_j = exact::twice_j(p, sizes, cubic, quadratic);
    WideInteger const i = invariant_i(p, sizes, quadratic);
    int const sign = sign_of_discriminant(i, twice_j, sizes, memory);
    if (sign != 0) return sign;
    int const other = sign_of_subdiscriminant(make(), i, twice_j, sizes, memory);
    return other <= 0 ? other
                      : sign_of_double_root(make(), i, twice_j.sign, sizes, cubic, memory) < 0;
}

/// Whether all roots of a quartic are real, if two of them are known to be real. The memory and
/// make() are those of sign_of_maximum().
template <class Make> PW85_FUNCTION inline bool
has_real_roots(Quartic const &p, Sizes const &sizes, Limb *memory, Make const &make) noexcept
{
    return sign_of_maximum(p, sizes, memory, make) >= 0;
}

/// The sign of the maximum over t > 0 of the quartic that make() computes, in memory of `total`
/// limbs.
template <class Make> PW85_FUNCTION inline int sign_of_quartic(Sizes const &sizes, Limb *memory,
                                                               Make const &make) noexcept
{
    Quartic const p = make();
    auto const &c = p.coefficients;
    if (c[1].sign <= 0 && c[2].sign <= 0 && c[3].sign <= 0) return -1;
    return sign_of_maximum(p, sizes, memory, make);
}

/// The sign of μ² - m, in memory of `total` limbs for bits(numbers).
template <class T, int D>
PW85_FUNCTION inline int sign_of_difference(Numbers<T, D> const &numbers, Limb *memory) noexcept
{
    if (is_far(numbers)) return 1;
    return sign_of_quartic(Sizes(bits(numbers)), memory,
                           [&] { return make_quartic(numbers, memory); });
}

} // namespace exact

/// Decides whether two ellipsoids overlap, for the numbers exactly as given. The result is never
/// Decision::none. It uses a fixed array on the stack: 9 KiB for double, 1.3 KiB for float, 141 KiB
/// for the long double of x86.
template <class T, int D>
requires exact::is_decidable<T> PW85_RARE Decision decide_exactly(Vector<T, D> const &r12,
                                                                  SymmetricMatrix<T, D> const &q1,
                                                                  SymmetricMatrix<T, D> const &q2)
noexcept
{
    using namespace exact;
    Limb memory[std::size_t(Sizes(max_bits<T>()).total)];
    bool const overlap = sign_of_difference(to_numbers(r12, q1, q2), memory) < 0;
    return to_decision(!overlap, overlap);
}

/// The sign of μ² - m for the numbers exactly as given. m must be positive, and a multiple of half
/// of the smallest positive number: it is a number of the type, or in the middle of two. It uses a
/// fixed array on the stack: 10 KiB for double.
template <class T, int D>
requires exact::is_decidable<T> PW85_RARE int
compare_exactly(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                SymmetricMatrix<T, D> const &q2, exact::BinaryFraction<T> const &m) noexcept
{
    using namespace exact;
    Limb memory[std::size_t(Sizes(max_bits<T>(std::numeric_limits<T>::max_exponent) + 1).total)];
    return sign_of_difference(to_numbers(r12, q1, q2, m), memory);
}

#define PW85_RARE_EXACT(rare, T, D)                                                                \
    rare(decide_exactly,                                                                           \
         (Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,                                \
          SymmetricMatrix<T, D> const &q2),                                                        \
         (r12, q1, q2)) rare(compare_exactly,                                                      \
                             (Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,            \
                              SymmetricMatrix<T, D> const &q2, exact::BinaryFraction<T> const &m), \
                             (r12, q1, q2, m))
PW85_RARE_TIER(PW85_RARE_EXACT)

template <class T, int D>
requires exact::is_decidable<T> PW85_FUNCTION inline int
compare_exactly(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                SymmetricMatrix<T, D> const &q2, T const &m) noexcept
{
    return compare_exactly(r12, q1, q2, exact::to_binary_fraction(m));
}

} // namespace pw85::detail

#endif
