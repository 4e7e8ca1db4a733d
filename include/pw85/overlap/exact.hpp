// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The sign of μ² - m in integers, for any number m > 0. It is the last tier of compare.hpp and,
/// with m = 1, of overlap.hpp.
///
/// The ellipsoids of the forms m Q1 and m Q2 are apart, touch or overlap if μ² - m is positive,
/// zero or negative. With a(t) = rᵀ adj(Q1 + t Q2) r and b(t) = det(Q1 + t Q2) (exact_numbers.hpp),
/// they are apart or tangent if and only if the quartic p(t) = t a(t) - m (1 + t) b(t) has a root
/// t > 0 (quartic.hpp). They are tangent if p has a positive root and no positive value: if its
/// positive roots coincide. exact_quartic.hpp decides this by the coefficients of p. In two
/// dimensions p is a cubic.
#ifndef PW85_OVERLAP_EXACT_HPP_INCLUDED
#define PW85_OVERLAP_EXACT_HPP_INCLUDED

#include <pw85/overlap/decision.hpp>
#include <pw85/overlap/exact_numbers.hpp>
#include <pw85/overlap/exact_quartic.hpp>

namespace pw85::detail {

namespace exact {

/// Computes the coefficients of p in units of 2^unit(), in memory for five of them. The first and
/// the last one are negative.
///
/// Two roots of p are negative, counted with multiplicity. Proof: Let Q1 = I and Q2 = diag(d), d1
/// >= d2 >= d3 > 0. This does not restrict the proof, because a congruence multiplies p by a
/// positive number. For m = 1, p(-1/di) = -(ri²/di) Π (1 - dj/di) over j != i, which is <= 0, >= 0
/// and <= 0. So there are two roots between the three points. If a value is zero, the roots are
/// limits of such roots. In two dimensions p has one negative root.
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
/// Decision::none. The function uses a fixed array on the stack: 9 KiB for double, 1.2 KiB for
/// float, 140 KiB for the long double of x86.
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

PW85_RARE_TIER(decide_exactly)
PW85_RARE_TIER_OF(compare_exactly, double, 3)

template <class T, int D>
requires exact::is_decidable<T> PW85_FUNCTION inline int
compare_exactly(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                SymmetricMatrix<T, D> const &q2, T const &m) noexcept
{
    return compare_exactly(r12, q1, q2, exact::to_binary_fraction(m));
}

} // namespace pw85::detail

#endif
