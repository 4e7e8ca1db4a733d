// SPDX-License-Identifier: BSD-3-Clause
// The exact order of μ² and a number, by Sturm's theorem in integers of any size.
#ifndef PW85_TESTS_STURM_HPP_INCLUDED
#define PW85_TESTS_STURM_HPP_INCLUDED

#include <algorithm>
#include <cmath>
#include <vector>

#include "oracle/exact_numbers.hpp"
#include "sample.hpp"

namespace pw85_tests {

/// By increasing powers, without leading zeros.
using Polynomial = std::vector<Integer>;
using PolynomialMatrix = std::vector<std::vector<Polynomial>>;

inline void trim(Polynomial &p)
{
    while (!p.empty() && p.back() == 0) p.pop_back();
}

/// sum += factor·x y.
inline void add_product(Polynomial &sum, int factor, Polynomial const &x, Polynomial const &y)
{
    if (x.empty() || y.empty()) return;
    sum.resize(std::max(sum.size(), x.size() + y.size() - 1));
    for (std::size_t i = 0; i < x.size(); ++i)
        for (std::size_t j = 0; j < y.size(); ++j) sum[i + j] += factor * x[i] * y[j];
    trim(sum);
}

/// By expansion along the first row.
inline Polynomial determinant(PolynomialMatrix const &a)
{
    if (a.size() == 1) return a[0][0];
    Polynomial sum;
    for (std::size_t j = 0; j < a.size(); ++j) {
        PolynomialMatrix minor;
        for (std::size_t i = 1; i < a.size(); ++i) {
            minor.push_back(a[i]);
            minor.back().erase(minor.back().begin() + static_cast<std::ptrdiff_t>(j));
        }
        add_product(sum, j % 2 == 0 ? 1 : -1, a[0][j], determinant(minor));
    }
    return sum;
}

/// Binary digits of x after the point.
template <class T> int digits_after_point(T const &x)
{
    if (x == 0) return 0;
    int exponent = 0, digits = 0;
    for (T fraction = std::frexp(x, &exponent); fraction != std::trunc(fraction); fraction *= 2)
        ++digits;
    return digits - exponent;
}

/// x·2^shift, an integer.
template <class T> Integer shifted(T const &x, int shift)
{
    int exponent = 0;
    Integer const mantissa(std::ldexp(std::frexp(x, &exponent), 64));
    int const n = exponent - 64 + shift;
    return n >= 0 ? Integer(mantissa << n) : Integer(mantissa / (Integer(1) << -n));
}

/// a(t) = rᵀ adj(Q1 + t Q2) r and b(t) = det(Q1 + t Q2), both times the same positive number. a is
/// minus the determinant of the bordered matrix.
struct RationalPolynomials {
    Polynomial a, b;
};

template <class T, int D> RationalPolynomials rational_polynomials(Sample<T, D> const &s)
{
    int shift = 0;
    for (int i = 0; i < D; ++i) shift = std::max(shift, digits_after_point(s.r12[i]));
    for (int k = 0; k < s.q1.size; ++k)
        shift = std::max(
            {shift, digits_after_point(s.q1[k]) / 2 + 1, digits_after_point(s.q2[k]) / 2 + 1});
    PolynomialMatrix blend(D, std::vector<Polynomial>(D)),
        bordered(D + 1, std::vector<Polynomial>(D + 1));
    for (int i = 0; i < D; ++i) {
        auto const row = static_cast<std::size_t>(i);
        for (int j = 0; j < D; ++j) {
            auto const column = static_cast<std::size_t>(j);
            blend[row][column] = {shifted(s.q1(i, j), 2 * shift), shifted(s.q2(i, j), 2 * shift)};
            trim(blend[row][column]);
            bordered[row][column] = blend[row][column];
        }
        bordered[row][D] = {shifted(s.r12[i], shift)};
        trim(bordered[row][D]);
        bordered[D][row] = bordered[row][D];
    }
    RationalPolynomials p{{}, determinant(blend)};
    add_product(p.a, -1, {Integer(1)}, determinant(bordered));
    return p;
}

/// t a(t) - m (1 + t) b(t) for m = factor/2^point, times a positive number.
inline Polynomial quartic(RationalPolynomials const &f, Integer const &factor, int point)
{
    Polynomial p;
    add_product(p, 1, {0, Integer(1) << point}, f.a);
    add_product(p, -1, {factor, factor}, f.b);
    return p;
}

template <class T, int D> Polynomial quartic(Sample<T, D> const &s, T const &m = T(1))
{
    int const point = digits_after_point(m) > 0 ? digits_after_point(m) : 0;
    return quartic(rational_polynomials(s), shifted(m, point), point);
}

/// A positive multiple of minus the remainder of x by y.
inline Polynomial negative_remainder(Polynomial x, Polynomial const &y)
{
    while (x.size() >= y.size()) {
        Integer const lead = y.back() < 0 ? Integer(-x.back()) : x.back(), divisor = abs(y.back());
        std::size_t const offset = x.size() - y.size();
        for (std::size_t i = 0; i < x.size(); ++i) {
            x[i] *= divisor;
            if (i >= offset) x[i] -= lead * y[i - offset];
        }
        trim(x);
    }
    for (auto &coefficient : x) coefficient = -coefficient;
    return x;
}

inline int changes_of_sign(std::vector<Integer> const &values)
{
    int changes = 0, last = 0;
    for (auto const &value : values) {
        if (value.sign() * last < 0) ++changes;
        if (value != 0) last = value.sign();
    }
    return changes;
}

/// What is known of the roots of p, p(0) != 0.
struct Roots {
    int positive, real; ///< numbers of distinct roots
    bool multiple;
};

/// By Sturm's theorem.
inline Roots roots_of(Polynomial const &p)
{
    std::vector<Polynomial> sequence{p, Polynomial()};
    for (std::size_t i = 1; i < p.size(); ++i)
        sequence[1].push_back(static_cast<unsigned>(i) * p[i]);
    while (!sequence.back().empty())
        sequence.push_back(negative_remainder(sequence[sequence.size() - 2], sequence.back()));
    sequence.pop_back();
    std::vector<Integer> below, at_zero, above;
    for (auto const &q : sequence) {
        below.push_back(q.size() % 2 == 0 ? Integer(-q.back()) : q.back());
        at_zero.push_back(q.front());
        above.push_back(q.back());
    }
    int const at_infinity = changes_of_sign(above);
    return {changes_of_sign(at_zero) - at_infinity, changes_of_sign(below) - at_infinity,
            sequence.back().size() > 1};
}

/// The sign of μ² - m: the quartic is negative at both ends of t > 0, and is positive between two
/// simple roots.
inline int sign_of(Roots const &roots)
{
    return roots.positive == 0 ? -1 : roots.positive == 1 ? 0 : 1;
}

/// The sign of μ² - m, m > 0.
template <class T, int D> int true_sign(Sample<T, D> const &s, T const &m)
{
    return sign_of(roots_of(quartic(s, m)));
}

/// The sign of μ² - (m + spacing/2), for m >= 0 and a power of two.
template <class T>
int true_sign_of_middle(RationalPolynomials const &f, T const &m, T const &spacing)
{
    int const point = std::max(0, digits_after_point(spacing)) + 1;
    return sign_of(
        roots_of(quartic(f, Integer(shifted(m, point) + shifted(spacing, point - 1)), point)));
}

} // namespace pw85_tests

#endif
