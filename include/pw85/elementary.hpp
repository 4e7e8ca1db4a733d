/// @file
/// Elementary functions of float, double and long double, for `using elementary::sqrt;` in place of `using std::sqrt;`.
///
/// The functions of `std::` are inline: units that do without inlining share one copy, which the linker may take from the
/// unit that was compiled for the newest processor. These here belong to their unit.
#ifndef PW85_ELEMENTARY_HPP_INCLUDED
#define PW85_ELEMENTARY_HPP_INCLUDED

namespace pw85::elementary {

#define PW85_ELEMENTARY(type, suffix)                                                                                  \
    static constexpr type abs(type x) noexcept { return __builtin_fabs##suffix(x); }                                   \
    static inline type sqrt(type x) noexcept { return __builtin_sqrt##suffix(x); }                                     \
    static inline type cbrt(type x) noexcept { return __builtin_cbrt##suffix(x); }                                     \
    static inline type exp(type x) noexcept { return __builtin_exp##suffix(x); }                                       \
    static inline type log(type x) noexcept { return __builtin_log##suffix(x); }                                       \
    static inline type sin(type x) noexcept { return __builtin_sin##suffix(x); }                                       \
    static inline type cos(type x) noexcept { return __builtin_cos##suffix(x); }                                       \
    static inline type atan2(type y, type x) noexcept { return __builtin_atan2##suffix(y, x); }                        \
    static inline type frexp(type x, int *exponent) noexcept { return __builtin_frexp##suffix(x, exponent); }          \
    static inline type ldexp(type x, int exponent) noexcept { return __builtin_ldexp##suffix(x, exponent); }           \
    static inline int ilogb(type x) noexcept { return __builtin_ilogb##suffix(x); }

PW85_ELEMENTARY(float, f)
PW85_ELEMENTARY(double, )
PW85_ELEMENTARY(long double, l)
#undef PW85_ELEMENTARY

} // namespace pw85::elementary

#endif
