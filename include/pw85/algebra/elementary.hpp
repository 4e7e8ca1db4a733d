// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Elementary functions of float, double and long double. Code writes `using elementary::sqrt;`
/// instead of `using std::sqrt;`; scalar.hpp includes this file for all other headers.
///
/// The functions of `std::` are inline. Translation units that are compiled without inlining share
/// one copy of each. The linker may take this copy from the unit that was compiled for the newest
/// processor. The functions here belong to one unit each.
#ifndef PW85_ALGEBRA_ELEMENTARY_HPP_INCLUDED
#define PW85_ALGEBRA_ELEMENTARY_HPP_INCLUDED

#include <pw85/attributes.hpp>

namespace pw85::detail::elementary {

#define PW85_ELEMENTARY(type, suffix)                                                              \
    PW85_FUNCTION constexpr type abs(type x) noexcept { return __builtin_fabs##suffix(x); }        \
    PW85_FUNCTION inline type sqrt(type x) noexcept { return __builtin_sqrt##suffix(x); }          \
    PW85_FUNCTION inline type cbrt(type x) noexcept { return __builtin_cbrt##suffix(x); }          \
    PW85_FUNCTION inline type floor(type x) noexcept { return __builtin_floor##suffix(x); }        \
    PW85_FUNCTION inline type ceil(type x) noexcept { return __builtin_ceil##suffix(x); }          \
    PW85_FUNCTION inline type round(type x) noexcept { return __builtin_round##suffix(x); }        \
    PW85_FUNCTION inline type nearbyint(type x) noexcept                                           \
    {                                                                                              \
        return __builtin_nearbyint##suffix(x);                                                     \
    }                                                                                              \
    PW85_FUNCTION inline type fma(type x, type y, type z) noexcept                                 \
    {                                                                                              \
        return __builtin_fma##suffix(x, y, z);                                                     \
    }                                                                                              \
    PW85_FUNCTION constexpr bool isfinite(type x) noexcept { return __builtin_isfinite(x); }       \
    PW85_FUNCTION constexpr bool isnan(type x) noexcept { return __builtin_isnan(x); }             \
    PW85_FUNCTION inline type exp(type x) noexcept { return __builtin_exp##suffix(x); }            \
    PW85_FUNCTION inline type log(type x) noexcept { return __builtin_log##suffix(x); }            \
    PW85_FUNCTION inline type sin(type x) noexcept { return __builtin_sin##suffix(x); }            \
    PW85_FUNCTION inline type cos(type x) noexcept { return __builtin_cos##suffix(x); }            \
    PW85_FUNCTION inline type atan2(type y, type x) noexcept                                       \
    {                                                                                              \
        return __builtin_atan2##suffix(y, x);                                                      \
    }                                                                                              \
    PW85_FUNCTION inline type frexp(type x, int *exponent) noexcept                                \
    {                                                                                              \
        return __builtin_frexp##suffix(x, exponent);                                               \
    }                                                                                              \
    PW85_FUNCTION inline type ldexp(type x, int exponent) noexcept                                 \
    {                                                                                              \
        return __builtin_ldexp##suffix(x, exponent);                                               \
    }                                                                                              \
    PW85_FUNCTION inline int ilogb(type x) noexcept { return __builtin_ilogb##suffix(x); }

PW85_ELEMENTARY(float, f)
PW85_ELEMENTARY(double, )
PW85_ELEMENTARY(long double, l)
#undef PW85_ELEMENTARY

} // namespace pw85::detail::elementary

#endif
