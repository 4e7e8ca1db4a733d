// SPDX-License-Identifier: BSD-3-Clause
// A pair of ellipsoids as test data. It is printed in hexadecimal floating point, which can be
// pasted into a test.
#ifndef PW85_TESTS_SAMPLE_HPP_INCLUDED
#define PW85_TESTS_SAMPLE_HPP_INCLUDED

#include <cstdio>
#include <string>
#include <type_traits>

#include <pw85/pw85.hpp>

namespace pw85_tests {

using Vector3 = pw85::Vector<double, 3>;
using Form3 = pw85::SymmetricMatrix<double, 3>;

template <class T, int D> struct Sample {
    pw85::Vector<T, D> r12;
    pw85::SymmetricMatrix<T, D> q1, q2;
};

/// The same numbers in another type: exact if it is wider.
template <class To, class From, int D> pw85::Vector<To, D> convert(pw85::Vector<From, D> const &x)
{
    pw85::Vector<To, D> y{};
    for (int i = 0; i < D; ++i) y[i] = static_cast<To>(x[i]);
    return y;
}

template <class To, class From, int D>
pw85::SymmetricMatrix<To, D> convert(pw85::SymmetricMatrix<From, D> const &a)
{
    pw85::SymmetricMatrix<To, D> b{};
    for (int k = 0; k < b.size; ++k) b[k] = static_cast<To>(a[k]);
    return b;
}

template <class To, class From, int D> Sample<To, D> convert(Sample<From, D> const &s)
{
    return {convert<To>(s.r12), convert<To>(s.q1), convert<To>(s.q2)};
}

inline void print_hex(char (&text)[64], double x) { std::snprintf(text, sizeof text, "%a", x); }
inline void print_hex(char (&text)[64], long double x)
{
    std::snprintf(text, sizeof text, "%La", x);
}

template <class T> std::string hex_text(T const *x, int count)
{
    std::string text = "{";
    for (int i = 0; i < count; ++i) {
        char number[64];
        print_hex(number, x[i]);
        text += (i == 0 ? "" : ", ") + std::string(number);
    }
    return text + "}";
}

/// The inputs of a failing case.
template <class T, int D> std::string hex_text(Sample<T, D> const &s)
{
    auto const d =
        convert<std::conditional_t<std::is_same_v<T, long double>, long double, double>>(s);
    return "r12 = " + hex_text(d.r12.coordinates, D) +
           ", q1 = " + hex_text(d.q1.entries, d.q1.size) +
           ", q2 = " + hex_text(d.q2.entries, d.q2.size);
}

} // namespace pw85_tests

#endif
