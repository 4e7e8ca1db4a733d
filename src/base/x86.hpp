// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The instructions of x86-64 that the compilers' vectors do not have, for registers of two, four
/// and eight doubles. GCC would read all of <immintrin.h> in 0.6 s for each unit, and so it has its
/// built-in functions instead.
#ifndef PW85_BASE_X86_HPP_INCLUDED
#define PW85_BASE_X86_HPP_INCLUDED

#if defined(__SSE2__)

#if defined(__clang__) || !defined(__GNUC__)
#if defined(__AVX__)
#include <immintrin.h>
#else
#include <emmintrin.h>
#endif
#define PW85_X86_2(builtin, name) _mm_##name##_pd
#define PW85_X86_4(builtin, name) _mm256_##name##_pd
#define PW85_X86_8(builtin, name) _mm512_##name##_pd
#else
#define PW85_X86_2(builtin, name) __builtin_ia32_##builtin##pd
#define PW85_X86_4(builtin, name) __builtin_ia32_##builtin##pd256
#define PW85_X86_8(builtin, name) PW85_X86_8_##name
#define PW85_X86_ALL 0xff, 4 // in all lanes, with the current rounding mode
#define PW85_X86_8_max(x, y) __builtin_ia32_maxpd512_mask(x, y, Eight(), PW85_X86_ALL)
#define PW85_X86_8_min(x, y) __builtin_ia32_minpd512_mask(x, y, Eight(), PW85_X86_ALL)
#define PW85_X86_8_sqrt(x) __builtin_ia32_sqrtpd512_mask(x, Eight(), -1, 4)
#define PW85_X86_8_fmadd(x, y, z) __builtin_ia32_vfmaddpd512_mask(x, y, z, PW85_X86_ALL)
#define PW85_X86_8_fmsub(x, y, z) __builtin_ia32_vfmsubpd512_mask(x, y, z, PW85_X86_ALL)
#define PW85_X86_8_fnmadd(x, y, z) __builtin_ia32_vfnmaddpd512_mask(x, y, z, PW85_X86_ALL)
#define PW85_X86_8_rcp14(x) __builtin_ia32_rcp14pd512_mask(x, Eight(), 0xff)
#define PW85_X86_8_rsqrt14(x) __builtin_ia32_rsqrt14pd512_mask(x, Eight(), 0xff)
#define PW85_X86_BUILT_IN
#endif
#define PW85_X86_INLINE [[gnu::always_inline]] inline

namespace pw85::detail::x86 {

typedef double Two __attribute__((vector_size(16)));
typedef double Four __attribute__((vector_size(32)));
typedef double Eight __attribute__((vector_size(64)));

// If either operand of maximum() and minimum() is NaN, the result is the second one.
#define PW85_X86_ARITHMETIC(Register, OF)                                                          \
    PW85_X86_INLINE Register maximum(Register x, Register y) noexcept                              \
    {                                                                                              \
        return OF(max, max)(x, y);                                                                 \
    }                                                                                              \
    PW85_X86_INLINE Register minimum(Register x, Register y) noexcept                              \
    {                                                                                              \
        return OF(min, min)(x, y);                                                                 \
    }                                                                                              \
    PW85_X86_INLINE Register square_root(Register x) noexcept { return OF(sqrt, sqrt)(x); }

// x y + z, x y - z and z - x y, rounded once.
#define PW85_X86_FUSED(Register, OF)                                                               \
    PW85_X86_INLINE Register product_plus(Register x, Register y, Register z) noexcept             \
    {                                                                                              \
        return OF(vfmadd, fmadd)(x, y, z);                                                         \
    }                                                                                              \
    PW85_X86_INLINE Register product_minus(Register x, Register y, Register z) noexcept            \
    {                                                                                              \
        return OF(vfmsub, fmsub)(x, y, z);                                                         \
    }                                                                                              \
    PW85_X86_INLINE Register minus_product(Register x, Register y, Register z) noexcept            \
    {                                                                                              \
        return OF(vfnmadd, fnmadd)(x, y, z);                                                       \
    }

// Bit i is the sign of number i. The bits that are in both registers.
#define PW85_X86_BITS(Register, OF)                                                                \
    PW85_X86_INLINE unsigned signs(Register x) noexcept                                            \
    {                                                                                              \
        return static_cast<unsigned>(OF(movmsk, movemask)(x));                                     \
    }                                                                                              \
    PW85_X86_INLINE Register both(Register x, Register y) noexcept { return OF(and, and)(x, y); }

PW85_X86_ARITHMETIC(Two, PW85_X86_2)
PW85_X86_BITS(Two, PW85_X86_2)
#if defined(__AVX__)
PW85_X86_ARITHMETIC(Four, PW85_X86_4)
PW85_X86_BITS(Four, PW85_X86_4)
PW85_X86_INLINE Four join(Two low, Two high) noexcept
{
#if defined(PW85_X86_BUILT_IN)
    return __builtin_ia32_vinsertf128_pd256(__builtin_ia32_pd256_pd(low), high, 1);
#else
    return _mm256_insertf128_pd(_mm256_castpd128_pd256(low), high, 1);
#endif
}
#endif
#if defined(__FMA__)
PW85_X86_FUSED(Two, PW85_X86_2)
PW85_X86_FUSED(Four, PW85_X86_4)
#endif

#if defined(__AVX512F__) && defined(__AVX512DQ__)
#define PW85_X86_HAS_EIGHT
PW85_X86_ARITHMETIC(Eight, PW85_X86_8)
PW85_X86_FUSED(Eight, PW85_X86_8)

/// Reciprocals, and reciprocal roots, with relative errors below 2^-14.
PW85_X86_INLINE Eight rough_reciprocal(Eight x) noexcept { return PW85_X86_8(rcp14, rcp14)(x); }
PW85_X86_INLINE Eight rough_reciprocal_root(Eight x) noexcept
{
    return PW85_X86_8(rsqrt14, rsqrt14)(x);
}

/// One bit for each number.
using Mask = unsigned char;
enum Relation : int { equal = 0x00, less = 0x11, less_or_equal = 0x12, greater_or_equal = 0x1d };

#if defined(PW85_X86_BUILT_IN)
/// The bits of `among` where the relation holds; not for NaN.
template <Relation relation> PW85_X86_INLINE Mask compare(Eight x, Eight y, Mask among) noexcept
{
    return __builtin_ia32_cmppd512_mask(x, y, relation, among, 4);
}
PW85_X86_INLINE Eight blend(Mask mask, Eight no, Eight yes) noexcept
{
    return __builtin_ia32_blendmpd_512_mask(no, yes, mask);
}
PW85_X86_INLINE Eight join(Four low, Four high) noexcept
{
    return __builtin_ia32_insertf64x4_mask(__builtin_ia32_pd512_256pd(low), high, 1, Eight(), 0xff);
}
PW85_X86_INLINE Mask both(Mask x, Mask y) noexcept { return __builtin_ia32_kandqi(x, y); }
PW85_X86_INLINE Mask either(Mask x, Mask y) noexcept { return __builtin_ia32_korqi(x, y); }
PW85_X86_INLINE Mask inverse(Mask x) noexcept { return __builtin_ia32_knotqi(x); }
#else
template <Relation relation> PW85_X86_INLINE Mask compare(Eight x, Eight y, Mask among) noexcept
{
    return _mm512_mask_cmp_pd_mask(among, x, y, relation);
}
PW85_X86_INLINE Eight blend(Mask mask, Eight no, Eight yes) noexcept
{
    return _mm512_mask_blend_pd(mask, no, yes);
}
PW85_X86_INLINE Eight join(Four low, Four high) noexcept
{
    return _mm512_insertf64x4(_mm512_castpd256_pd512(low), high, 1);
}
PW85_X86_INLINE Mask both(Mask x, Mask y) noexcept { return _kand_mask8(x, y); }
PW85_X86_INLINE Mask either(Mask x, Mask y) noexcept { return _kor_mask8(x, y); }
PW85_X86_INLINE Mask inverse(Mask x) noexcept { return _knot_mask8(x); }
#endif
#endif

} // namespace pw85::detail::x86

#endif

#endif
