/// @file
/// Iterative refinement of a solution of (Q1 + t Q2) s = r12, with a residual that is exact to twice the working precision: s
/// is then right to rounding in each coordinate, however ill-conditioned the matrix.
#ifndef PW85_REFINEMENT_HPP_INCLUDED
#define PW85_REFINEMENT_HPP_INCLUDED

#include <pw85/evaluation.hpp>

namespace pw85 {

/// A number as the sum of two whose products with such parts of others are exact (but for those of two low parts), so that it
/// makes no difference whether the compiler fuses them with an addition.
template <class T> struct Parts {
    T high, low;
};

PW85_FUNCTION inline double leading_bits(double x) noexcept
{
    return __builtin_bit_cast(double, __builtin_bit_cast(std::uint64_t, x) & ~std::uint64_t{0x7ffffff});
}
PW85_FUNCTION inline float leading_bits(float x) noexcept
{
    return __builtin_bit_cast(float, __builtin_bit_cast(std::uint32_t, x) & ~std::uint32_t{0xfff});
}

/// T. J. Dekker, Numer. Math. 18, 224 (1971), for types whose products are never fused.
template <class T> PW85_FUNCTION inline T leading_bits(T const &x) noexcept
{
    T const scaled = x * (T(1) + T(1) / negative_power_of_two<T>((mantissa_digits<T>() + 1) / 2));
    return scaled - (scaled - x);
}

template <class T> PW85_FUNCTION inline Parts<T> split(T const &x) noexcept
{
    T const high = leading_bits(x);
    return {high, x - high};
}

/// A sum and what its roundings left out (D. E. Knuth, The Art of Computer Programming 2, 4.2.2).
template <class T> struct CompensatedSum {
    T sum, rest;
};

template <class T> PW85_FUNCTION inline void add(CompensatedSum<T> &c, T const &x) noexcept
{
    T const sum = c.sum + x, part = sum - c.sum;
    c.rest = c.rest + ((c.sum - (sum - part)) + (x - part));
    c.sum = sum;
}

template <class T>
PW85_FUNCTION inline void subtract_product(CompensatedSum<T> &c, Parts<T> const &x, Parts<T> const &y) noexcept
{
    add(c, T(-(x.high * y.high)));
    add(c, T(-(x.high * y.low)));
    add(c, T(-(x.low * y.high)));
    add(c, T(-(x.low * y.low)));
}

/// r12 - (Q1 + t Q2) s.
template <class T, int D>
PW85_FUNCTION inline Vector<T, D> residual(Pair<T, D> const &pair, T const &t, Vector<T, D> const &s) noexcept
{
    Parts<T> const tau = split(t);
    Vector<T, D> result{};
    for (int i = 0; i < D; ++i) {
        CompensatedSum<T> sum{pair.r12[i], T(0)};
        for (int j = 0; j < D; ++j) {
            Parts<T> const x = split(s[j]), q = split(pair.q2(i, j));
            subtract_product(sum, split(pair.q1(i, j)), x);
            T const products[4] = {tau.high * q.high, tau.high * q.low, tau.low * q.high, tau.low * q.low};
            for (T const &product : products) subtract_product(sum, split(product), x);
        }
        result[i] = sum.sum + sum.rest;
    }
    return result;
}

/// Three corrections: each leaves u κ of the error, with κ the condition number of the matrix scaled to a unit diagonal.
template <class T, int D> PW85_FUNCTION inline Vector<T, D>
refine(Pair<T, D> const &pair, T const &t, Factorization<T, D> const &factors, Vector<T, D> s) noexcept
{
    for (int n = 0; n < 3; ++n) {
        Vector<T, D> const change = solve(factors, residual(pair, t, s));
        for (int i = 0; i < D; ++i) s[i] = s[i] + change[i];
    }
    return s;
}

} // namespace pw85

#endif
