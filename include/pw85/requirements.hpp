// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Requirements of the headers on the compiler.
///
/// NaN, infinity and rounding must be those of IEEE 754. With -ffast-math, NaN and infinity are not
/// detected, and error bounds do not hold. A program that defines PW85_ALLOW_FAST_MATH compiles
/// nevertheless, at its own risk.
#ifndef PW85_REQUIREMENTS_HPP_INCLUDED
#define PW85_REQUIREMENTS_HPP_INCLUDED

#if __cplusplus < 202002L
#error "pw85 needs C++20: compile with -std=c++20"
#include <pw85/stop> // There is no such file: compilers continue after #error, but not after this.
#endif

#ifndef PW85_ALLOW_FAST_MATH
#if defined(__FAST_MATH__) || __FINITE_MATH_ONLY__ || defined(__ASSOCIATIVE_MATH__) ||             \
    defined(__RECIPROCAL_MATH__)
#error                                                                                             \
    "pw85 needs IEEE arithmetic: compile without -ffast-math, -Ofast and their like, or define PW85_ALLOW_FAST_MATH"
#endif
#endif

#endif
