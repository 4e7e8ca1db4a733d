// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Decides in integers whether a number or a point proves that two ellipsoids are apart, or that
/// they overlap. witness.hpp calls it. The integers are those of exact_numbers.hpp.
///
/// 1. f(λ) > 1 if and only if Σ c_k λ^k (1-λ)^(4-k) > 0, with the coefficients c of the quartic of
///    exact.hpp for m = 1.
/// 2. A point x is inside the ellipsoid of the form Q about the centre c if and only if (x-c)ᵀ
///    adj(Q) (x-c) < det Q.
#ifndef PW85_OVERLAP_EXACT_WITNESS_HPP_INCLUDED
#define PW85_OVERLAP_EXACT_WITNESS_HPP_INCLUDED

#include <pw85/overlap/exact.hpp>

namespace pw85::detail {

namespace exact {

/// (x-c)ᵀ adj(Q) (x-c) and det Q in symbols, which stand for x, c and Q in this order.
struct InsideTest {
    Polynomial square, determinant;
};

template <int D> PW85_FUNCTION constexpr InsideTest symbolic_inside_test() noexcept
{
    Vector<Polynomial, D> y{};
    SymmetricMatrix<Polynomial, D> q{};
    for (int i = 0; i < D; ++i) y[i] = variable(i) - variable(D + i);
    for (int k = 0; k < q.size; ++k) q[k] = variable(2 * D + k);
    auto const adj = adjugate(q);
    return {quadratic_form(adj, outer_weights(y)), determinant(q, adj)};
}

/// Converts the numbers of a point, a centre and a form, in the order of symbolic_inside_test().
/// bits() and unit() hold for both polynomials, because the coefficients of their terms add up to
/// 78.
template <class T, int D>
PW85_FUNCTION inline Numbers<T, D> to_numbers_of_point(Vector<T, D> const &x,
                                                       Vector<T, D> const &center,
                                                       SymmetricMatrix<T, D> const &q) noexcept
{
    Numbers<T, D> numbers;
    numbers.r = numbers.q = no_digits();
    numbers.m = {0, 0};
    int index = 0;
    for (int i = 0; i < D; ++i) numbers.r.include(numbers.x[index++] = to_binary_fraction(x[i]));
    for (int i = 0; i < D; ++i)
        numbers.r.include(numbers.x[index++] = to_binary_fraction(center[i]));
    for (int k = 0; k < q.size; ++k)
        numbers.q.include(numbers.x[index++] = to_binary_fraction(q[k]));
    return numbers;
}

/// The integers l and 2^e - l of a number l/2^e in (0, 1), in memory for both.
struct Shares {
    WideInteger first, second;
};

template <class T> PW85_FUNCTION constexpr int limbs_of_share(int e) noexcept
{
    return maximum(limbs_for(e + 2), limbs_for(std::numeric_limits<T>::digits) + 1);
}

template <class T> PW85_FUNCTION inline Shares to_shares(BinaryFraction<T> const &lambda, int e,
                                                         int size, Limb *memory) noexcept
{
    WideSum const first = zero_sum(memory, size), second = zero_sum(memory + size, size);
    add(first, lambda.magnitude, 0, 1);
    add(second, Digits<1>{{Limb{1} << (e % limb_bits)}}, e / limb_bits, 1);
    add(second, lambda.magnitude, 0, -1);
    return {value(first), value(second)};
}

/// Memory for sign_at(): the coefficients, two sums, two shares and two powers.
template <class T> PW85_FUNCTION constexpr int limbs_for_shares(int bits, int e) noexcept
{
    return 5 * limbs_for(bits + 4) + 2 * limbs_for(bits + 4 * e + 8) + 2 * limbs_of_share<T>(e) +
           2 * limbs_for(4 * e + 4);
}

/// The sign of f(λ) - 1, by Horner's scheme. The sums alternate between two places in memory, and
/// so do the powers.
template <class T, int D> PW85_FUNCTION inline int
sign_at(Numbers<T, D> const &numbers, BinaryFraction<T> const &lambda, Limb *memory) noexcept
{
    int const n = bits(numbers), e = -lambda.exponent, size = limbs_for(n + 4 * e + 8),
              power_size = limbs_for(4 * e + 4);
    Limb *const sums = memory + 5 * limbs_for(n + 4), *const shares = sums + 2 * size;
    Limb *const powers = shares + 2 * limbs_of_share<T>(e);
    Quartic const p = make_quartic(numbers, memory);
    auto const [first, second] = to_shares(lambda, e, limbs_of_share<T>(e), shares);
    WideInteger sum = p.coefficients[4], power = second;
    for (int k = 3; k >= 0; --k) {
        WideSum const next = zero_sum(sums + (k % 2) * size, size);
        add_product(next, 1, sum, first);
        add_product(next, 1, p.coefficients[k], power);
        sum = value(next);
        if (k == 0) break;
        WideSum const next_power = zero_sum(powers + (k % 2) * power_size, power_size);
        add_product(next_power, 1, power, second);
        power = value(next_power);
    }
    return sum.sign;
}

} // namespace exact

/// Returns whether f(λ) > 1 for the numbers exactly as given, 0 < λ < 1. The bounding boxes must
/// not be apart by a factor of two. It uses 9 KiB of the stack for double.
template <class T, int D>
requires exact::is_decidable<T>
[[gnu::noinline]] static bool exceeds_one_exactly(Vector<T, D> const &r12,
                                                  SymmetricMatrix<T, D> const &q1,
                                                  SymmetricMatrix<T, D> const &q2,
                                                  T const &lambda) noexcept
{
    using namespace exact;
    constexpr int digits = std::numeric_limits<T>::digits - std::numeric_limits<T>::min_exponent;
    Limb memory[limbs_for_shares<T>(max_bits<T>(), digits)];
    auto const numbers = to_numbers(r12, q1, q2);
    return !is_far(numbers) && sign_at(numbers, to_binary_fraction(lambda), memory) > 0;
}

/// Returns whether a point is inside an ellipsoid and not on its surface, for the numbers exactly
/// as given. If the coordinates are so large that the memory would not suffice, the point is
/// outside.
template <class T, int D>
requires exact::is_decidable<T>
[[gnu::noinline]] static bool is_inside_exactly(Vector<T, D> const &x, Vector<T, D> const &center,
                                                SymmetricMatrix<T, D> const &q) noexcept
{
    using namespace exact;
    static constexpr auto test = symbolic_inside_test<D>();
    Limb memory[std::size_t(Sizes(max_bits<T>()).coefficient)];
    auto const numbers = to_numbers_of_point(x, center, q);
    if (bits(numbers) > max_bits<T>()) return false;
    WideSum const sum = zero_sum(memory, Sizes(bits(numbers)).coefficient);
    for (int i = 0; i < test.square.size; ++i)
        add(sum, evaluate<D + 1>(numbers, test.square.terms[i]), 1);
    for (int i = 0; i < test.determinant.size; ++i)
        add(sum, evaluate<D>(numbers, test.determinant.terms[i]), -1);
    return value(sum).sign < 0;
}

} // namespace pw85::detail

#endif
