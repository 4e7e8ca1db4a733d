// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Exact decisions in n dimensions, computed in integers: is a form positive definite, and what is
/// the sign of μ² - m? definite.hpp and overlap.hpp call them where floating-point numbers do not
/// suffice.
///
/// The polynomial is that of overlap/exact.hpp, p(t) = t a(t) - m (1 + t) b(t) with a(t) = rᵀ
/// adj(Q1 + t Q2) r and b(t) = det(Q1 + t Q2), of degree n + 1. It is negative at 0 and at
/// infinity. In the eigenbasis of the pencil, n - 1 of its roots are negative. It has no positive
/// root if the ellipsoids of m Q1 and m Q2 overlap, one double positive root if they touch, and two
/// positive roots if they are apart. Sturm's theorem counts the positive roots.
///
/// Let N be the number of bits of the integers, from the highest to the lowest bit of all entries
/// after each axis is scaled by a power of two. The coefficients have n N bits, the numbers of
/// Sturm's sequence up to 2 n (n + 1) N bits, and the time is that of n² products of such numbers.
#ifndef PW85_ANY_DIMENSION_EXACT_SIGN_HPP_INCLUDED
#define PW85_ANY_DIMENSION_EXACT_SIGN_HPP_INCLUDED

#include <pw85/any_dimension/exact_integer.hpp>
#include <pw85/any_dimension/pair.hpp>

namespace pw85::detail::any_dimension {

inline constexpr int sign_unknown = Integer::undefined; ///< there is no memory

/// Returns the power of two by which an axis is scaled: its longest extent becomes about one.
PW85_FUNCTION inline int axis_exponent(double q1, double q2) noexcept
{
    return -half_exponent(maximum(q1, q2));
}

/// Returns the exponent of the lowest bit of x 2^exponent, or `otherwise` for 0.
PW85_FUNCTION inline long lowest_bit(double x, long exponent, long otherwise) noexcept
{
    if (x == 0.0) return otherwise;
    int const e = binary_exponent(absolute(x)) - 52;
    auto const mantissa = static_cast<std::uint64_t>(times_power_of_two(absolute(x), -e));
    return minimum(otherwise, e + std::countr_zero(mantissa) + exponent);
}

/// Eliminates the first `steps` unknowns of a symmetric matrix of any size without fractions (E. H.
/// Bareiss, Math. Comput. 22, 565, 1968). Entry k of the diagonal becomes the minor of order k + 1.
/// Returns the sign of the first minor that is not positive, or 1.
PW85_FUNCTION inline int eliminate(int size, int steps, Integer *a) noexcept
{
    Integer const *previous = nullptr;
    for (int k = 0; k < steps; ++k) {
        Integer const *const pivot_row = a + row_offset(size, k);
        if (pivot_row[k].sign() != 1) return pivot_row[k].sign();
        for (int i = k + 1; i < size; ++i)
            for (int j = i; j < size; ++j) {
                Integer &entry = a[packed_index(size, i, j)];
                entry = pivot_row[k] * entry - pivot_row[i] * pivot_row[j];
                if (previous != nullptr) entry = exact_quotient(entry, *previous);
            }
        previous = pivot_row + k;
    }
    return 1;
}

/// Returns whether a form with a positive diagonal is positive definite: 1 or 0, or sign_unknown.
[[gnu::cold, gnu::noinline]] PW85_FUNCTION inline int is_definite_exactly(int n,
                                                                          double const *q) noexcept
{
    int axes[max_dimension];
    for (int i = 0; i < n; ++i) {
        double const entry = q[packed_index(n, i, i)];
        axes[i] = axis_exponent(entry, entry);
    }
    long unit = 0;
    for (int i = 0; i < n; ++i)
        for (int j = i; j < n; ++j)
            unit = lowest_bit(q[packed_index(n, i, j)], axes[i] + axes[j], unit);
    Integer a[max_packed_size];
    for (int i = 0; i < n; ++i)
        for (int j = i; j < n; ++j)
            a[packed_index(n, i, j)] =
                to_integer(q[packed_index(n, i, j)], axes[i] + axes[j] - unit);
    int const sign = eliminate(n, n - 1, a);
    int const last = sign == 1 ? a[packed_size(n) - 1].sign() : sign;
    return last == sign_unknown ? sign_unknown : last == 1;
}

/// A polynomial of a degree of at most n + 1.
struct ExactPolynomial {
    Integer c[max_dimension + 2];
    int degree = 0;

    [[gnu::always_inline]] ExactPolynomial() noexcept = default;
    [[gnu::always_inline]] ExactPolynomial(ExactPolynomial &&) noexcept = default;
    // The compiler's copy of the array has a variable of its own.
    // NOLINTNEXTLINE(*-identifier-naming)
    [[gnu::always_inline]] ExactPolynomial &operator=(ExactPolynomial &&) noexcept = default;
    [[gnu::always_inline]] ~ExactPolynomial() = default;
    [[gnu::always_inline]] void trim() noexcept
    {
        while (degree >= 0 && c[degree].sign() == 0) --degree;
    }
    [[gnu::always_inline]] Integer const &leading() const noexcept { return c[degree]; }
};

/// The numbers of a comparison as integers: r12 in units of 2^r, forms in units of 2^q.
struct IntegerInput {
    Integer r12[max_dimension], q1[max_packed_size], q2[max_packed_size];
    Integer scale_a, scale_b; ///< factors of a and b in p

    [[gnu::always_inline]] IntegerInput() noexcept = default;
    [[gnu::always_inline]] ~IntegerInput() = default;
};

PW85_FUNCTION inline void read(Input const &in, double m, IntegerInput &x) noexcept
{
    int const n = in.n;
    int axes[max_dimension];
    for (int i = 0; i < n; ++i)
        axes[i] = axis_exponent(in.q1[packed_index(n, i, i)], in.q2[packed_index(n, i, i)]);
    long q = 1 << 16, r = 1 << 16;
    for (int i = 0; i < n; ++i) {
        r = lowest_bit(in.r12[i], axes[i], r);
        for (int j = i; j < n; ++j) {
            q = lowest_bit(in.q1[packed_index(n, i, j)], axes[i] + axes[j], q);
            q = lowest_bit(in.q2[packed_index(n, i, j)], axes[i] + axes[j], q);
        }
    }
    for (int i = 0; i < n; ++i) {
        x.r12[i] = to_integer(in.r12[i], axes[i] - r);
        for (int j = i; j < n; ++j) {
            int const k = packed_index(n, i, j);
            x.q1[k] = to_integer(in.q1[k], axes[i] + axes[j] - q);
            x.q2[k] = to_integer(in.q2[k], axes[i] + axes[j] - q);
        }
    }
    long const b = q + lowest_bit(m, 0, 1 << 16), unit = minimum(2 * r, b);
    x.scale_a = to_integer(1.0, 2 * r - unit);
    x.scale_b = to_integer(m, q - unit);
}

/// Values at a matrix M = first Q1 + second Q2.
struct Minors {
    Integer bordered; ///< the determinant of M with the border r12: -r12ᵀ adj(M) r12
    Integer determinant;
    int definite = sign_unknown; ///< 1 if M is positive definite; if not, nothing is computed

    [[gnu::always_inline]] Minors() noexcept = default;
    [[gnu::always_inline]] Minors(Minors &&) noexcept = default;
    [[gnu::always_inline]] ~Minors() = default;
};

PW85_FUNCTION inline Minors evaluate(int n, IntegerInput const &x, int first, int second) noexcept
{
    Integer const weight1 = to_integer(first, 0), weight2 = to_integer(second, 0);
    Integer a[packed_size(max_dimension + 1)];
    for (int i = 0; i < n; ++i) {
        for (int j = i; j < n; ++j) {
            int const k = packed_index(n, i, j);
            a[packed_index(n + 1, i, j)] = weight1 * x.q1[k] + weight2 * x.q2[k];
        }
        a[packed_index(n + 1, i, n)] = copy(x.r12[i]);
    }
    Minors minors;
    minors.definite = eliminate(n + 1, n, a);
    minors.bordered = std::move(a[packed_size(n + 1) - 1]);
    minors.determinant = std::move(a[packed_index(n + 1, n - 1, n - 1)]);
    return minors;
}

/// Computes degree! p from the values of p at 0 … degree, by Newton's interpolation. The values are
/// overwritten.
PW85_FUNCTION inline void interpolate(int degree, Integer *values, ExactPolynomial &p) noexcept
{
    for (int k = 1; k <= degree; ++k)
        for (int t = degree; t >= k; --t) values[t] = values[t] - values[t - 1];
    // Horner's scheme: p = (… (d_n (t - n + 1)/n + d_n-1) (t - n + 2)/(n - 1) + …) t/1 + d_0
    Integer factor = to_integer(1.0, 0); // degree!/k!
    p.degree = degree;
    p.c[0] = copy(values[degree]);
    for (int k = degree - 1; k >= 0; --k) {
        factor = factor * to_integer(k + 1, 0);
        Integer const shift = to_integer(k, 0);
        for (int i = degree - k; i > 0; --i) p.c[i] = p.c[i - 1] - shift * p.c[i];
        p.c[0] = factor * values[k] - shift * p.c[0];
    }
    p.trim();
}

/// Computes a multiple of p, which a comparison needs.
PW85_FUNCTION inline void interpolate(int n, IntegerInput const &x, ExactPolynomial &p) noexcept
{
    Integer values[max_dimension + 2];
    for (int t = 0; t <= n + 1; ++t) {
        Minors const at = evaluate(n, x, 1, t); // a blend is positive definite
        values[t] = to_integer(-t, 0) * x.scale_a * at.bordered -
                    to_integer(t + 1, 0) * x.scale_b * at.determinant;
    }
    interpolate(n + 1, values, p);
}

/// Replaces x by a positive multiple of the remainder of x divided by y. The factor is |leading
/// coefficient of y|^steps.
PW85_FUNCTION inline void pseudo_remainder(ExactPolynomial &x, ExactPolynomial const &y) noexcept
{
    int const steps = x.degree - y.degree + 1;
    for (; x.degree >= y.degree; --x.degree) {
        Integer const quotient = std::move(x.c[x.degree]);
        x.c[x.degree] = Integer();
        for (int i = 0; i < x.degree; ++i) {
            x.c[i] = y.leading() * x.c[i];
            int const k = i - (x.degree - y.degree);
            if (k >= 0) x.c[i] = x.c[i] - quotient * y.c[k];
        }
    }
    if (y.leading().sign() < 0 && steps % 2 != 0)
        for (int i = 0; i <= x.degree; ++i) x.c[i].negate();
    x.trim();
}

PW85_FUNCTION inline Integer power(Integer const &x, int exponent) noexcept
{
    Integer result = to_integer(1.0, 0);
    for (int i = 0; i < exponent; ++i) result = result * x;
    return result;
}

/// Counts the changes of sign along Sturm's sequence at 0, minus at infinity.
struct SignChanges {
    int at_zero = 0, at_infinity = 0, difference = 0;

    [[gnu::always_inline]] void add(ExactPolynomial const &p) noexcept
    {
        int const zero = p.c[0].sign(), infinity = p.leading().sign();
        if (zero * at_zero < 0) ++difference;
        if (infinity * at_infinity < 0) --difference;
        if (zero != 0) at_zero = zero;
        at_infinity = infinity;
    }
};

PW85_FUNCTION inline bool is_defined(ExactPolynomial const &p) noexcept
{
    for (int i = 0; i <= p.degree; ++i)
        if (!p.c[i].is_defined()) return false;
    return true;
}

/// Calls visit(p) for each polynomial of the sequence of negative remainders that begins with a
/// pair, and overwrites the pair. Returns the last polynomial that is not zero, the greatest common
/// divisor up to a factor; null if there is no memory. The sequence is that of subresultants (G. E.
/// Collins, J. ACM 14, 128, 1967; W. S. Brown and J. F. Traub, J. ACM 18, 505, 1971): each
/// remainder is divided by the magnitude of a factor that it is known to have.
template <class Visit> [[gnu::noinline]] PW85_FUNCTION inline ExactPolynomial *
divide_repeatedly(ExactPolynomial (&pair)[2], Visit const &visit) noexcept
{
    ExactPolynomial *first = &pair[0], *second = &pair[1];
    if (first->degree < second->degree) std::swap(first, second);
    visit(*first);
    Integer leading = to_integer(1.0, 0), psi = to_integer(1.0, 0);
    while (second->degree >= 0) {
        if (!is_defined(*second)) return nullptr;
        visit(*second);
        int const delta = first->degree - second->degree;
        pseudo_remainder(*first, *second);
        Integer factor = leading * power(psi, delta);
        factor.set_sign(-1);
        for (int i = 0; i <= first->degree; ++i) first->c[i] = exact_quotient(first->c[i], factor);
        leading = copy(second->leading());
        leading.set_sign(1);
        psi = exact_quotient(power(leading, delta), power(psi, delta - 1));
        std::swap(first, second);
    }
    return is_defined(*first) ? first : nullptr;
}

/// Numbers of roots: of distinct positive roots, and of the repetitions of multiple roots.
struct RootCount {
    int positive, repeated; ///< positive is -1 if there is no memory
};

/// Counts roots by Sturm's theorem. `pair` has p, and is overwritten.
PW85_FUNCTION inline RootCount count_roots(ExactPolynomial (&pair)[2]) noexcept
{
    ExactPolynomial const &p = pair[0];
    ExactPolynomial &derivative = pair[1];
    derivative.degree = p.degree - 1;
    for (int i = 0; i < p.degree; ++i) derivative.c[i] = p.c[i + 1] * to_integer(i + 1, 0);
    SignChanges changes;
    auto const *const last =
        divide_repeatedly(pair, [&](ExactPolynomial const &x) { changes.add(x); });
    return last == nullptr ? RootCount{-1, 0} : RootCount{changes.difference, last->degree};
}

/// Returns the sign of μ² - m for a pair of positive definite forms and a finite m > 0, or
/// sign_unknown.
[[gnu::cold, gnu::noinline]] PW85_FUNCTION inline int compare_exactly(Input const &in,
                                                                      double m) noexcept
{
    if (largest_magnitude(in.n, in.r12) == 0.0) return -1;
    ExactPolynomial pair[2];
    {
        IntegerInput x;
        read(in, m, x);
        interpolate(in.n, x, pair[0]);
    }
    if (!is_defined(pair[0])) return sign_unknown;
    int const roots = count_roots(pair).positive;
    return roots < 0 ? sign_unknown : roots - 1;
}

} // namespace pw85::detail::any_dimension

#endif
