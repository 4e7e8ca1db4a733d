// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The sign of the maximum over t > 0 of a quartic p = at⁴ + bt³ + ct² + dt + e, in integers.
/// exact.hpp and exact_factored.hpp call sign_of_quartic(), and exact_containment.hpp calls
/// has_real_roots().
///
/// sign_of_quartic() is for a p of which two roots are negative, counted with multiplicity, and the
/// first and the last coefficient, too. The invariants of p are I = 12ae - 3bd + c² and J = 72ace +
/// 9bcd - 27ad² - 27eb² - 2c³. Everything holds with a = 0 for a cubic with one negative root.
#ifndef PW85_OVERLAP_EXACT_QUARTIC_HPP_INCLUDED
#define PW85_OVERLAP_EXACT_QUARTIC_HPP_INCLUDED

#include <pw85/algebra/wide_integer.hpp>

namespace pw85::detail::exact {

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

/// The coefficients of p, by powers of t.
struct Quartic {
    WideInteger coefficients[5];
};

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

/// Computes the sign of the discriminant, which is that of 4I³ - J². It uses the memory of a
/// quartic sum.
PW85_FUNCTION inline int sign_of_discriminant(WideInteger i, WideInteger twice_j,
                                              Sizes const &sizes, Limb *memory) noexcept
{
    if (i.sign < 0) return -1;
    WideSum const square = zero_sum(memory, sizes.quartic);
    add_product(square, 1, i, i);
    multiply(square, 16);
    return compare_products(value(square), i, twice_j, twice_j);
}

/// Computes the sign of the subdiscriminant if the discriminant is zero: that of 2aJ + I(3b² -
/// 8ac). It uses the memory of a quadratic sum.
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

/// Computes the sign of the double root if there is one and the other roots are real and simple. It
/// uses the memory of two quadratic sums. The second one may be that of the last two coefficients.
///
/// Let x be the double root, and H the Hessian of p as a binary form. The covariant 2J p + I H is k
/// (t - x)⁴ with k = 2aJ + I(3b² - 8ac) > 0. Its second coefficient gives -4kx = 2bJ + 4I(bc -
/// 6ad). As J² = 4I³, this has the sign of bc - 6ad + s b √I, where s is the sign of J.
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
///
/// Two roots are negative. The two others are either real or a complex pair. If all roots are real,
/// there is a positive root, because a coefficient is positive.
template <class Make> PW85_FUNCTION inline int
sign_of_maximum(Quartic const &p, Sizes const &sizes, Limb *memory, Make const &make) noexcept
{
    Limb *const quadratic = memory + 5 * sizes.coefficient, *const cubic =
                                                                quadratic + sizes.quadratic;
    WideInteger const twice_j = exact::twice_j(p, sizes, cubic, quadratic);
    WideInteger const i = invariant_i(p, sizes, quadratic);
    int const sign = sign_of_discriminant(i, twice_j, sizes, memory);
    // The discriminant is negative for a complex pair. If it is zero, two roots coincide.
    if (sign != 0) return sign;
    // The subdiscriminant, the sum over i, j, k of (xi-xj)²(xj-xk)²(xk-xi)², is negative for a
    // complex pair beside a negative double root, and not negative if all roots are real. Then p
    // touches zero if and only if the positive roots coincide. No three roots coincide, because two
    // are negative. So if the subdiscriminant is zero, there are two double roots, and the positive
    // one is double. If it is positive, there is one double root.
    int const other = sign_of_subdiscriminant(make(), i, twice_j, sizes, memory);
    return other <= 0 ? other
                      : sign_of_double_root(make(), i, twice_j.sign, sizes, cubic, memory) < 0;
}

/// Returns whether all roots of a quartic are real, if two of them are known to be real. The memory
/// and make() are those of sign_of_maximum().
template <class Make> PW85_FUNCTION inline bool
has_real_roots(Quartic const &p, Sizes const &sizes, Limb *memory, Make const &make) noexcept
{
    return sign_of_maximum(p, sizes, memory, make) >= 0;
}

/// The sign of the maximum over t > 0 of the quartic that make() computes, in memory of `total`
/// limbs. Without a positive coefficient there is never a positive root. If all roots are real,
/// there is a positive root if and only if there is a positive coefficient: Descartes' rule of
/// signs is exact then.
template <class Make> PW85_FUNCTION inline int sign_of_quartic(Sizes const &sizes, Limb *memory,
                                                               Make const &make) noexcept
{
    Quartic const p = make();
    auto const &c = p.coefficients;
    if (c[1].sign <= 0 && c[2].sign <= 0 && c[3].sign <= 0) return -1;
    return sign_of_maximum(p, sizes, memory, make);
}

} // namespace pw85::detail::exact

#endif
