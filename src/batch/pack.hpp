/// @file
/// The lane pack: as many doubles as a register of the target holds, with the arithmetic that the templates of the core
/// ask of a scalar.
///
/// A product is a type of its own until it is used, and becomes part of a fused multiply-add where it is added to or
/// subtracted from something. So the source decides what is fused, not the compiler, and one lane gives the same bits
/// whatever code surrounds it. Units that use packs are compiled without contraction.
#ifndef PW85_BATCH_PACK_HPP_INCLUDED
#define PW85_BATCH_PACK_HPP_INCLUDED

#include <cstdint>
#include <cstring>

#include <pw85/scalar.hpp>

#if defined(__AVX512F__) || defined(__AVX2__)
#include <immintrin.h>
#endif

#define PW85_INLINE __attribute__((always_inline)) inline

namespace pw85::inline PW85_TARGET {

#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
inline constexpr int lanes = 8;
#elif defined(__AVX2__) && defined(__FMA__)
inline constexpr int lanes = 4;
#else
inline constexpr int lanes = 2;
#endif

/// A vector of N doubles of the compiler.
template <int N> struct RegisterOf {
    typedef double Doubles __attribute__((vector_size(N * sizeof(double))));
    typedef std::int64_t Integers __attribute__((vector_size(N * sizeof(double))));
};
using Register = RegisterOf<lanes>::Doubles;

/// One truth value per lane.
struct PackMask {
#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
    __mmask8 bits;

    friend PW85_INLINE PackMask operator&(PackMask x, PackMask y) noexcept { return {_kand_mask8(x.bits, y.bits)}; }
    friend PW85_INLINE PackMask operator|(PackMask x, PackMask y) noexcept { return {_kor_mask8(x.bits, y.bits)}; }
    friend PW85_INLINE PackMask operator!(PackMask x) noexcept { return {_knot_mask8(x.bits)}; }
    PW85_INLINE unsigned to_bits() const noexcept { return bits; }
#else
    RegisterOf<lanes>::Integers bits;

    friend PW85_INLINE PackMask operator&(PackMask x, PackMask y) noexcept { return {x.bits & y.bits}; }
    friend PW85_INLINE PackMask operator|(PackMask x, PackMask y) noexcept { return {x.bits | y.bits}; }
    friend PW85_INLINE PackMask operator!(PackMask x) noexcept { return {~x.bits}; }
    PW85_INLINE unsigned to_bits() const noexcept
    {
#if defined(__AVX2__)
        return static_cast<unsigned>(_mm256_movemask_pd(reinterpret_cast<__m256d>(bits)));
#else
        unsigned b = 0;
        for (int i = 0; i < lanes; ++i) b |= static_cast<unsigned>(bits[i] & 1) << i;
        return b;
#endif
    }
#endif
};

PW85_INLINE PackMask operator&&(PackMask x, PackMask y) noexcept { return x & y; }
PW85_INLINE PackMask operator||(PackMask x, PackMask y) noexcept { return x | y; }
PW85_INLINE bool any_of(PackMask mask) noexcept { return mask.to_bits() != 0; }
PW85_INLINE bool all_of(PackMask mask) noexcept { return mask.to_bits() == (1u << lanes) - 1u; }

struct Product;

/// One double per lane.
struct Pack {
    Register v;

    Pack() = default;
    PW85_INLINE Pack(Register x) noexcept : v(x) {}
    PW85_INLINE Pack(double x) noexcept : v(x - Register{}) {}
    PW85_INLINE Pack(Product const &p) noexcept;

    PW85_INLINE double operator[](int i) const noexcept { return v[i]; }
};

/// A product that has not been rounded yet.
struct Product {
    Register x, y;
};

PW85_INLINE Pack::Pack(Product const &p) noexcept : v(p.x * p.y) {}

/// x y + z and z - x y, rounded once where the target can.
PW85_INLINE Pack fused(Product const &p, Pack const &z) noexcept
{
#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
    return _mm512_fmadd_pd(p.x, p.y, z.v);
#elif defined(__AVX2__) && defined(__FMA__)
    return _mm256_fmadd_pd(p.x, p.y, z.v);
#else
    return p.x * p.y + z.v;
#endif
}

PW85_INLINE Pack fused_difference(Product const &p, Pack const &z) noexcept
{
#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
    return _mm512_fmsub_pd(p.x, p.y, z.v);
#elif defined(__AVX2__) && defined(__FMA__)
    return _mm256_fmsub_pd(p.x, p.y, z.v);
#else
    return p.x * p.y - z.v;
#endif
}

PW85_INLINE Pack fused_negative(Product const &p, Pack const &z) noexcept
{
#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
    return _mm512_fnmadd_pd(p.x, p.y, z.v);
#elif defined(__AVX2__) && defined(__FMA__)
    return _mm256_fnmadd_pd(p.x, p.y, z.v);
#else
    return z.v - p.x * p.y;
#endif
}

PW85_INLINE Product operator*(Pack const &x, Pack const &y) noexcept { return {x.v, y.v}; }
PW85_INLINE Pack operator+(Pack const &x, Pack const &y) noexcept { return x.v + y.v; }
PW85_INLINE Pack operator-(Pack const &x, Pack const &y) noexcept { return x.v - y.v; }
PW85_INLINE Pack operator-(Pack const &x) noexcept { return -x.v; }
PW85_INLINE Pack operator+(Product const &p, Pack const &z) noexcept { return fused(p, z); }
PW85_INLINE Pack operator+(Pack const &z, Product const &p) noexcept { return fused(p, z); }
PW85_INLINE Pack operator-(Product const &p, Pack const &z) noexcept { return fused_difference(p, z); }
PW85_INLINE Pack operator-(Pack const &z, Product const &p) noexcept { return fused_negative(p, z); }
PW85_INLINE Pack operator+(Product const &p, Product const &q) noexcept { return fused(p, q); }
PW85_INLINE Pack operator-(Product const &p, Product const &q) noexcept { return fused_difference(p, q); }

PW85_INLINE Pack operator/(Pack const &x, Pack const &y) noexcept { return x.v / y.v; }

#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
PW85_INLINE PackMask operator<(Pack const &x, Pack const &y) noexcept { return {_mm512_cmp_pd_mask(x.v, y.v, _CMP_LT_OQ)}; }
PW85_INLINE PackMask operator<=(Pack const &x, Pack const &y) noexcept { return {_mm512_cmp_pd_mask(x.v, y.v, _CMP_LE_OQ)}; }
PW85_INLINE PackMask operator==(Pack const &x, Pack const &y) noexcept { return {_mm512_cmp_pd_mask(x.v, y.v, _CMP_EQ_OQ)}; }
PW85_INLINE Pack select(PackMask mask, Pack const &yes, Pack const &no) noexcept { return _mm512_mask_blend_pd(mask.bits, no.v, yes.v); }
#else
PW85_INLINE PackMask operator<(Pack const &x, Pack const &y) noexcept { return {x.v < y.v}; }
PW85_INLINE PackMask operator<=(Pack const &x, Pack const &y) noexcept { return {x.v <= y.v}; }
PW85_INLINE PackMask operator==(Pack const &x, Pack const &y) noexcept { return {x.v == y.v}; }
PW85_INLINE Pack select(PackMask mask, Pack const &yes, Pack const &no) noexcept { return mask.bits ? yes.v : no.v; }
#endif
PW85_INLINE PackMask operator>(Pack const &x, Pack const &y) noexcept { return y < x; }
PW85_INLINE PackMask operator>=(Pack const &x, Pack const &y) noexcept { return y <= x; }

#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
PW85_INLINE Pack maximum(Pack const &x, Pack const &y) noexcept { return _mm512_max_pd(y.v, x.v); }
PW85_INLINE Pack minimum(Pack const &x, Pack const &y) noexcept { return _mm512_min_pd(y.v, x.v); }
#elif defined(__AVX2__) && defined(__FMA__)
PW85_INLINE Pack maximum(Pack const &x, Pack const &y) noexcept { return _mm256_max_pd(y.v, x.v); }
PW85_INLINE Pack minimum(Pack const &x, Pack const &y) noexcept { return _mm256_min_pd(y.v, x.v); }
#else
PW85_INLINE Pack maximum(Pack const &x, Pack const &y) noexcept { return select(y > x, y, x); }
PW85_INLINE Pack minimum(Pack const &x, Pack const &y) noexcept { return select(y < x, y, x); }
#endif

PW85_INLINE Pack absolute(Pack const &x) noexcept
{
    RegisterOf<lanes>::Integers const bits = reinterpret_cast<RegisterOf<lanes>::Integers>(x.v) & INT64_MAX;
    return reinterpret_cast<Register>(bits);
}

PW85_INLINE Pack square_root(Pack const &x) noexcept
{
#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
    return _mm512_sqrt_pd(x.v);
#elif defined(__AVX2__) && defined(__FMA__)
    return _mm256_sqrt_pd(x.v);
#else
    Register root;
    for (int i = 0; i < lanes; ++i) root[i] = __builtin_sqrt(x.v[i]);
    return root;
#endif
}

#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
PW85_INLINE Pack rough_quotient(Pack const &x, Pack const &y) noexcept
{
    Pack const r = _mm512_rcp14_pd(y.v);
    return x * (r + r * (Pack(1.0) - y * r));
}

PW85_INLINE Pack rough_root(Pack const &x) noexcept
{
    Pack const r = _mm512_rsqrt14_pd(x.v), half = Pack(0.5), root = x * r;
    return root + root * (half - half * root * r);
}
#else
PW85_INLINE Pack rough_quotient(Pack const &x, Pack const &y) noexcept { return x / y; }
PW85_INLINE Pack rough_root(Pack const &x) noexcept { return square_root(x); }
#endif

template <> struct ScalarTraits<Pack> {
    using Lane = double;
    using Mask = PackMask;
};

} // namespace pw85::inline PW85_TARGET

#endif
