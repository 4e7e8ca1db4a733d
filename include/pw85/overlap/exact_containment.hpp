// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Decides in integers whether ellipsoid 2 is inside ellipsoid 1. containment.hpp calls
/// contains_exactly(). The integers are those of exact_numbers.hpp. scripts/containment_roots.py
/// checks the criterion in rational numbers against 60 digits.
///
/// For r != 0, ellipsoid 2 is inside if and only if K(w) = Q1 - (1 + 1/w) Q2 - (1 + w) r rᵀ is
/// positive semidefinite for some w > 0. Proof: Inside means that √(nᵀQ2n) + |n·r| <= √(nᵀQ1n) for
/// all n. If K(w) >= 0 this holds, because (x + y)² <= (1 + 1/w) x² + (1 + w) y². The other
/// direction is the S-lemma: xᵀQ1⁻¹x <= 1 follows from (x - r)ᵀQ2⁻¹(x - r) <= 1 only if it follows
/// with some multiplier ν, 0 < ν < 1. The Schur complement of that inequality is K >= 0 for w =
/// ν/(1 - ν).
///
/// Let N = Q1 - Q2, B(w) = det(wN - Q2) = n0 w³ - n1 w² + n2 w - n3, A(w) = rᵀ adj(wN - Q2) r = m0
/// w² - m1 w + m2 and p(w) = det(w K(w)) = B(w) - w (1 + w) A(w). Ellipses are flat ellipsoids with
/// one more root of B at 0, and with m2 = n3 = 0. Everything holds for them.
#ifndef PW85_OVERLAP_EXACT_CONTAINMENT_HPP_INCLUDED
#define PW85_OVERLAP_EXACT_CONTAINMENT_HPP_INCLUDED

#include <pw85/overlap/exact.hpp>

namespace pw85::detail {

namespace exact {

/// A weighted sum of the coefficients of the rational form of Q1 + t Q2. The weights are for a(t),
/// then for b(t), by increasing powers of t.
struct Combination {
    static constexpr int size = 7;

    signed char weights[size];
};

PW85_FUNCTION constexpr Combination operator*(int factor, Combination x) noexcept
{
    for (auto &weight : x.weights) weight = static_cast<signed char>(factor * weight);
    return x;
}

PW85_FUNCTION constexpr Combination operator+(Combination x, Combination const &y) noexcept
{
    for (int k = 0; k < x.size; ++k)
        x.weights[k] = static_cast<signed char>(x.weights[k] + y.weights[k]);
    return x;
}

PW85_FUNCTION constexpr Combination operator-(Combination const &x, Combination const &y) noexcept
{
    return x + -1 * y;
}

/// The coefficients of A and B, from wN - Q2 = w (Q1 + t Q2) with t = -(1 + 1/w), and those of p.
namespace nested {
static constexpr Combination m0{{1, -1, 1}}, m1{{0, 1, -2}}, m2{{0, 0, 1}};
static constexpr Combination n0{{0, 0, 0, 1, -1, 1, -1}}, n1{{0, 0, 0, 0, 1, -2, 3}},
    n2{{0, 0, 0, 0, 0, 1, -3}}, n3{{0, 0, 0, 0, 0, 0, 1}};

static constexpr Combination difference[3] = {n0, n1, n2};
static constexpr Combination quartic[5] = {-1 * n3, n2 - m2, m1 - n1 - m2, n0 + m1 - m0, -1 * m0};

/// The coefficients of A, and of p', p''/2 and p'''/6 where A = 0, by increasing powers of w. Where
/// A = 0, w A' = m1 w - 2 m2 and m0 w² = m1 w - m2. This gives
///     p'    = (3 n0 - m1) w² + (2 m2 - 2 n1 - m1) w + (n2 + 2 m2),
///     p''/2 = 3 (n0 - m0 - m1) w + (m1 - n1 + 5 m2),        p'''/6 = -4 m0 w + (n0 + m1 - m0).
static constexpr Combination first[6] = {m0,         m1, m2, n2 + 2 * m2, 2 * m2 - 2 * n1 - m1,
                                         3 * n0 - m1};
static constexpr Combination second[6] = {m0, m1, m2, m1 - n1 + 5 * m2, 3 * (n0 - m0 - m1), {}};
static constexpr Combination third[6] = {m0, m1, m2, n0 + m1 - m0, -4 * m0, {}};
} // namespace nested

/// The bits that a combination needs beyond bits(). It has up to 288 terms (the linear coefficient
/// of p''' has 4·72) instead of 72.
static constexpr int extra_bits = 2;

static constexpr Limb unit_limb[1] = {1};
static constexpr WideInteger one{unit_limb, 1, 1};

template <std::size_t Count> struct WideIntegers {
    WideInteger values[Count];

    [[gnu::always_inline]] WideInteger operator[](int k) const noexcept { return values[k]; }
};

/// Adds a number, times its weight in each combination, to the sums.
template <std::size_t Count>
PW85_FUNCTION inline void add_weighted(WideSum const (&sums)[Count],
                                       Combination const (&combinations)[Count], int k,
                                       WideInteger x) noexcept
{
    for (int i = 0; i < int(Count); ++i) {
        int const weight = combinations[i].weights[k];
        Limb const factor = static_cast<Limb>(weight < 0 ? -weight : weight);
        if (weight != 0) add_product(sums[i], weight < 0 ? -1 : 1, x, {&factor, 1, 1});
    }
}

/// Computes combinations in units of 2^unit(), in memory for them. The scratch memory holds one
/// coefficient of the form.
template <std::size_t Count, class T, int D>
[[gnu::noinline]] PW85_FUNCTION inline WideIntegers<Count>
combine(Numbers<T, D> const &numbers, Combination const (&combinations)[Count], Sizes const &sizes,
        Limb *memory, Limb *scratch) noexcept
{
    static constexpr auto form = symbolic_form<D>();
    int const size = sizes.coefficient;
    WideSum sums[Count];
    for (int i = 0; i < int(Count); ++i) sums[i] = zero_sum(memory + i * size, size);
    for (int k = 0; k < 3; ++k) {
        WideSum const sum = zero_sum(scratch, size);
        for (int i = 0; i < form.a[k].size; ++i)
            add(sum, evaluate<D + 1>(numbers, form.a[k].terms[i]), 1);
        add_weighted(sums, combinations, k, value(sum));
    }
    for (int k = 0; k < 4; ++k) {
        WideSum const sum = zero_sum(scratch, size);
        for (int i = 0; i < form.b[k].size; ++i)
            add(sum, evaluate<D + 1>(numbers, form.b[k].terms[i]), 1);
        add_weighted(sums, combinations, 3 + k, value(sum));
    }
    WideIntegers<Count> result;
    for (int i = 0; i < int(Count); ++i) result.values[i] = value(sums[i]);
    return result;
}

/// sign·x y + sign2·u v in memory for a quadratic sum.
PW85_FUNCTION inline WideInteger sum_of_products(WideInteger x, WideInteger y, int sign2,
                                                 WideInteger u, WideInteger v, Sizes const &sizes,
                                                 Limb *memory) noexcept
{
    WideSum const sum = zero_sum(memory, sizes.quadratic);
    add_product(sum, 1, x, y);
    add_product(sum, sign2, u, v);
    return value(sum);
}

/// Returns the sign of x y + sign2·u v.
PW85_FUNCTION inline int sign_of_products(WideInteger x, WideInteger y, int sign2, WideInteger u,
                                          WideInteger v) noexcept
{
    int const left = x.sign * y.sign, right = -sign2 * u.sign * v.sign;
    return left != right ? (left > right ? 1 : -1) : left * compare_products(x, y, u, v);
}

/// The sign at ω of a polynomial c0 + c1 w + c2 w². Its coefficients follow those of A in
/// `combinations`.
///
/// m0 times the polynomial is y w + x at both roots of A, with x = m0 c0 - m2 c2 and y = m0 c1 + m1
/// c2. The product of the two values has the sign of x² + y (m1 c0 + m2 c1). Their sum has the sign
/// of s = m1 y + 2 m0 x, and their difference that of y. If the product is zero, one value is zero.
/// It is the value at ω if s and y have opposite signs.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline int
sign_at_larger_root(Numbers<T, D> const &numbers, Combination const (&combinations)[6],
                    Sizes const &sizes, Limb *memory) noexcept
{
    auto const values =
        combine(numbers, combinations, sizes, memory, memory + 6 * sizes.coefficient);
    auto const m0 = values[0], m1 = values[1], m2 = values[2], c0 = values[3], c1 = values[4],
               c2 = values[5];
    Limb *const products = memory + 6 * sizes.coefficient;
    WideInteger const x = sum_of_products(m0, c0, -1, m2, c2, sizes, products);
    WideInteger const y = sum_of_products(m0, c1, 1, m1, c2, sizes, products + sizes.quadratic);
    WideInteger const z = sum_of_products(m1, c0, 1, m2, c1, sizes, products + 2 * sizes.quadratic);
    int const product = sign_of_products(x, x, 1, y, z);
    if (product < 0) return y.sign;
    WideSum const twice = zero_sum(products + 2 * sizes.quadratic, sizes.quadratic);
    for (int n = 0; n < 2; ++n) add_product(twice, 1, x, one);
    int const sum = sign_of_products(m1, y, 1, m0, value(twice));
    return product > 0 || sum == y.sign ? sum : 0;
}

/// Returns whether all roots of p are real and positive, as they are if ellipsoid 2 is inside. N
/// must be positive definite. Descartes' rule comes first, so most pairs that are not inside do not
/// need the discriminant.
///
/// Let λ1 >= λ2 >= λ3 > 0 be the roots of B. p has degree 4, and is the quartic of exact.hpp at t =
/// -(1 + 1/w). So two of its roots are in [λ3, λ1], counted with multiplicity. Its first
/// coefficient -m0 and its last coefficient -n3 are negative. For w > λ1, K(w) >= 0 means
/// p(w) >= 0. There p/B = 1 - w (1 + w) rᵀ(wN - Q2)⁻¹r, which is -∞ at infinity, is positive
/// between two roots or nowhere. So if ellipsoid 2 is inside, all roots are real and positive, and
/// by Descartes' rule the coefficients alternate in sign.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline bool
has_positive_roots(Numbers<T, D> const &numbers, Sizes const &sizes, Limb *memory) noexcept
{
    auto const make = [&] {
        auto const values = combine(numbers, nested::quartic, sizes, memory, memory + sizes.total);
        return Quartic{{values[0], values[1], values[2], values[3], values[4]}};
    };
    auto const p = make();
    if (p.coefficients[1].sign <= 0 || p.coefficients[2].sign >= 0 || p.coefficients[3].sign <= 0)
        return false;
    return has_real_roots(p, sizes, memory, make);
}

/// Returns whether p shows that ellipsoid 2 is inside. All roots of p must be real and positive.
///
/// Let ω be the larger root of A. A congruence makes N = I and Q2 diagonal. Then A = Σ ri² Π (w -
/// λj) over j != i, so λ2 <= ω <= λ1. For w in (ω, λ1), A > 0 and B <= 0, so p < 0. At λ1 > ω, B =
/// 0 and p < 0. So a root that exceeds ω exceeds λ1, and ellipsoid 2 is inside if p has such a
/// root.
template <class T, int D> [[gnu::noinline]] PW85_FUNCTION inline bool
has_root_for_inside(Numbers<T, D> const &numbers, Sizes const &sizes, Limb *memory) noexcept
{
    // p has real roots and a negative first coefficient. So by the Taylor series at ω, no root
    // exceeds ω if and only if no derivative of p is positive at ω. p itself is not positive there,
    // because p(ω) = B(ω) <= 0.
    if (sign_at_larger_root(numbers, nested::third, sizes, memory) > 0) return true;
    int const second = sign_at_larger_root(numbers, nested::second, sizes, memory);
    if (second > 0) return true;
    int const first = sign_at_larger_root(numbers, nested::first, sizes, memory);
    // If no root exceeds ω, K(w) >= 0 is possible at w = λ1 only. If K(λ1) >= 0, r is orthogonal to
    // the eigenvectors of λ1. Also ω = λ1, because A(λ1) = 0 and A > 0 beyond ω. Let p = B ψ, where
    // ψ is regular and ψ(λ1) >= 0. As no root is larger, ψ(λ1) = 0. So ω is at least a double root
    // of p, and p'(ω) = 0.
    if (first != 0) return first > 0;
    // Conversely, let p'(ω) = 0, and let no root exceed ω. Then p(ω) = 0, too. If ω is a simple
    // root of A, B'(ω) = ω (1 + ω) A'(ω) is positive. So ω = λ1 > λ2 and ψ(λ1) = 0, and ellipsoid 2
    // is inside. If ω is a double root of A, B'(ω) = 0, so ω = λ1 = λ2. (The case ω = λ2 = λ3 < λ1
    // is excluded: A(λ1) != 0 leaves r along the eigenvector of λ1, and both roots of ψ, if real,
    // exceed λ1.) Then p''(ω) = B''(ω) ψ(λ1), so inside means p''(ω) = 0.
    auto const a = combine(numbers, nested::second, sizes, memory, memory + 6 * sizes.coefficient);
    WideSum const product = zero_sum(memory + 6 * sizes.coefficient, sizes.quadratic);
    add_product(product, 1, a[0], a[2]);
    multiply(product, 4);
    return second == 0 || sign_of_products(a[1], a[1], -1, value(product), one) != 0;
}

/// Returns the number of limbs that the functions above need.
PW85_FUNCTION constexpr int limbs_for_containment(Sizes const &sizes) noexcept
{
    return maximum(sizes.total + sizes.coefficient, 6 * sizes.coefficient + 3 * sizes.quadratic);
}

} // namespace exact

/// Returns whether ellipsoid 2 is inside ellipsoid 1, for the numbers of a valid pair exactly as
/// given. It uses 11 KiB of the stack for double.
///
/// If K(w) >= 0, then N - Q2/w >= 0, so N is positive definite. If r = 0, inside means N >= 0. The
/// coefficients of B show both. The roots of B are real if N is positive definite: they are the
/// eigenvalues of N⁻¹Q2.
template <class T, int D>
requires exact::is_decidable<T> PW85_RARE bool
contains_exactly(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                 SymmetricMatrix<T, D> const &q2) noexcept
{
    using namespace exact;
    Limb memory[std::size_t(limbs_for_containment(Sizes(max_bits<T>() + extra_bits)))];
    auto const numbers = to_numbers(r12, q1, q2);
    if (is_far(numbers)) return false;
    Sizes const sizes(bits(numbers) + extra_bits);
    auto const n =
        combine(numbers, nested::difference, sizes, memory, memory + 6 * sizes.coefficient);
    int const least = minimum(n[0].sign, minimum(n[1].sign, n[2].sign));
    if (largest_coordinate(r12) == T(0)) return least >= 0;
    return least > 0 && has_positive_roots(numbers, sizes, memory) &&
           has_root_for_inside(numbers, sizes, memory);
}

PW85_RARE_TIER(contains_exactly)

} // namespace pw85::detail

#endif
