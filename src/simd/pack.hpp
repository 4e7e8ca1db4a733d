// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The scalar of the lane kernels: a pack of as many doubles as a register of the target holds,
/// with the arithmetic that algebra/scalar.hpp asks for. The lane kernels use it, and
/// set/one_set.cpp computes a single row with it.
///
/// A product has a type of its own. If something is added to it or subtracted from it, and the
/// target has fused multiply-add, the product becomes part of that instruction. So the source
/// decides what is fused, not the compiler, and a lane gives the same bits in any surrounding code.
/// Units that use packs are compiled without contraction. With PW85_ROUNDED_PRODUCTS, which folders
/// of sources define, packs fuse nothing: they give the bits of the functions for one pair.
#ifndef PW85_SIMD_PACK_HPP_INCLUDED
#define PW85_SIMD_PACK_HPP_INCLUDED

#include <cstddef>
#include <cstdint>
#include <cstring>

#include <pw85/algebra/scalar.hpp>

#include "registers.hpp"

/// Each kernel is compiled into one function, so the compiler's limits on inlining must not apply.
#define PW85_INLINE __attribute__((always_inline)) inline

namespace pw85::detail {
inline namespace PW85_PACKS {

/// A mask of all lanes.
inline constexpr unsigned all_lanes = (1u << lanes) - 1u;

/// The compiler's vectors of N numbers.
template <std::size_t N> struct VectorOf {
    typedef double Doubles __attribute__((vector_size(N * sizeof(double))));
    typedef std::int64_t Integers __attribute__((vector_size(N * sizeof(double))));
};
using Register = VectorOf<lanes>::Doubles;

#if defined(PW85_LANES_AVX512)
using MaskRegister = x86::Mask;
#elif defined(PW85_LANES_SVE)
typedef svbool_t MaskRegister __attribute__((arm_sve_vector_bits(__ARM_FEATURE_SVE_BITS)));

/// Bit i in lane i.
PW85_INLINE svuint64_t bit_of_lane() noexcept
{
    return svlsl_x(svptrue_b64(), svdup_u64(1), svindex_u64(0, 1));
}
#else
using MaskRegister = VectorOf<lanes>::Integers;
#endif

/// One truth value per lane.
struct PackMask {
    MaskRegister bits;

    /// Returns the truth values as bits: bit i is that of lane i.
    PW85_INLINE unsigned to_bits() const noexcept
    {
#if defined(PW85_LANES_AVX512)
        return bits;
#elif defined(PW85_LANES_SVE)
        return static_cast<unsigned>(svorv(bits, bit_of_lane()));
#elif defined(PW85_LANES_X86)
        return x86::signs(reinterpret_cast<Register>(bits));
#elif defined(__wasm_simd128__)
        return wasm_i64x2_bitmask(reinterpret_cast<v128_t>(bits));
#else
        unsigned all = 0;
        for (std::size_t i = 0; i < lanes; ++i) all |= static_cast<unsigned>(bits[i] & 1) << i;
        return all;
#endif
    }

    /// Returns the inverse of to_bits().
    static PW85_INLINE PackMask from_bits(unsigned all) noexcept
    {
#if defined(PW85_LANES_AVX512)
        return {static_cast<x86::Mask>(all)};
#elif defined(PW85_LANES_SVE)
        return {svcmpne(svptrue_b64(), svand_x(svptrue_b64(), bit_of_lane(), all), 0)};
#else
        MaskRegister bits;
        for (std::size_t i = 0; i < lanes; ++i) bits[i] = -static_cast<std::int64_t>(all >> i & 1u);
        return {bits};
#endif
    }
};

#if defined(PW85_LANES_AVX512)
PW85_INLINE PackMask operator&&(PackMask x, PackMask y) noexcept
{
    return {x86::both(x.bits, y.bits)};
}
PW85_INLINE PackMask operator||(PackMask x, PackMask y) noexcept
{
    return {x86::either(x.bits, y.bits)};
}
PW85_INLINE PackMask operator!(PackMask x) noexcept { return {x86::inverse(x.bits)}; }
#elif defined(PW85_LANES_SVE)
PW85_INLINE PackMask operator&&(PackMask x, PackMask y) noexcept
{
    return {svand_z(svptrue_b64(), x.bits, y.bits)};
}
PW85_INLINE PackMask operator||(PackMask x, PackMask y) noexcept
{
    return {svorr_z(svptrue_b64(), x.bits, y.bits)};
}
PW85_INLINE PackMask operator!(PackMask x) noexcept { return {svnot_z(svptrue_b64(), x.bits)}; }
#else
PW85_INLINE PackMask operator&&(PackMask x, PackMask y) noexcept { return {x.bits & y.bits}; }
PW85_INLINE PackMask operator||(PackMask x, PackMask y) noexcept { return {x.bits | y.bits}; }
PW85_INLINE PackMask operator!(PackMask x) noexcept { return {~x.bits}; }
#endif

#if defined(PW85_LANES_SVE)
PW85_INLINE bool any_of(PackMask mask) noexcept { return svptest_any(svptrue_b64(), mask.bits); }
PW85_INLINE bool all_of(PackMask mask) noexcept { return !any_of(!mask); }
#elif defined(__wasm_simd128__)
PW85_INLINE bool any_of(PackMask mask) noexcept
{
    return wasm_v128_any_true(reinterpret_cast<v128_t>(mask.bits));
}
PW85_INLINE bool all_of(PackMask mask) noexcept
{
    return wasm_i64x2_all_true(reinterpret_cast<v128_t>(mask.bits));
}
#else
PW85_INLINE bool any_of(PackMask mask) noexcept { return mask.to_bits() != 0; }
PW85_INLINE bool all_of(PackMask mask) noexcept { return mask.to_bits() == all_lanes; }
#endif

struct Product;

/// One double per lane.
struct Pack {
    Register v;

    Pack() = default;
    PW85_INLINE Pack(Register x) noexcept : v(x) {}
    PW85_INLINE Pack(double x) noexcept : v(x - Register{}) {}
    PW85_INLINE Pack(Product const &p) noexcept;

    PW85_INLINE double operator[](std::size_t i) const noexcept { return v[i]; }
};

/// A product before rounding.
struct Product {
    Register x, y;
};

PW85_INLINE Pack::Pack(Product const &p) noexcept : v(p.x * p.y) {}

PW85_INLINE Product operator*(Pack const &x, Pack const &y) noexcept { return {x.v, y.v}; }
PW85_INLINE Pack operator/(Pack const &x, Pack const &y) noexcept { return x.v / y.v; }
PW85_INLINE Pack operator+(Pack const &x, Pack const &y) noexcept { return x.v + y.v; }
PW85_INLINE Pack operator-(Pack const &x, Pack const &y) noexcept { return x.v - y.v; }
PW85_INLINE Pack operator-(Pack const &x) noexcept { return -x.v; }

#if defined(PW85_ROUNDED_PRODUCTS)
PW85_INLINE Pack operator+(Product const &p, Pack const &z) noexcept { return p.x * p.y + z.v; }
PW85_INLINE Pack operator-(Product const &p, Pack const &z) noexcept { return p.x * p.y - z.v; }
PW85_INLINE Pack operator-(Pack const &z, Product const &p) noexcept { return z.v - p.x * p.y; }
#elif defined(PW85_LANES_X86)
PW85_INLINE Pack operator+(Product const &p, Pack const &z) noexcept
{
    return x86::product_plus(p.x, p.y, z.v);
}
PW85_INLINE Pack operator-(Product const &p, Pack const &z) noexcept
{
    return x86::product_minus(p.x, p.y, z.v);
}
PW85_INLINE Pack operator-(Pack const &z, Product const &p) noexcept
{
    return x86::minus_product(p.x, p.y, z.v);
}
#elif defined(PW85_LANES_SVE)
PW85_INLINE Pack operator+(Product const &p, Pack const &z) noexcept
{
    return svmla_x(svptrue_b64(), z.v, p.x, p.y);
}
PW85_INLINE Pack operator-(Product const &p, Pack const &z) noexcept
{
    return svnmls_x(svptrue_b64(), z.v, p.x, p.y);
}
PW85_INLINE Pack operator-(Pack const &z, Product const &p) noexcept
{
    return svmls_x(svptrue_b64(), z.v, p.x, p.y);
}
#elif defined(PW85_LANES_NEON)
PW85_INLINE Pack operator+(Product const &p, Pack const &z) noexcept
{
    return vfmaq_f64(z.v, p.x, p.y);
}
PW85_INLINE Pack operator-(Product const &p, Pack const &z) noexcept
{
    return vfmaq_f64(-z.v, p.x, p.y);
}
PW85_INLINE Pack operator-(Pack const &z, Product const &p) noexcept
{
    return vfmsq_f64(z.v, p.x, p.y);
}
#endif
PW85_INLINE Pack operator+(Pack const &z, Product const &p) noexcept { return p + z; }
PW85_INLINE Pack operator+(Product const &p, Product const &q) noexcept { return p + Pack(q); }
PW85_INLINE Pack operator-(Product const &p, Product const &q) noexcept { return p - Pack(q); }

#if defined(PW85_LANES_AVX512)
PW85_INLINE PackMask operator<(Pack const &x, Pack const &y) noexcept
{
    return {x86::compare<x86::less>(x.v, y.v, all_lanes)};
}
PW85_INLINE PackMask operator<=(Pack const &x, Pack const &y) noexcept
{
    return {x86::compare<x86::less_or_equal>(x.v, y.v, all_lanes)};
}
PW85_INLINE PackMask operator==(Pack const &x, Pack const &y) noexcept
{
    return {x86::compare<x86::equal>(x.v, y.v, all_lanes)};
}
PW85_INLINE Pack select(PackMask mask, Pack const &yes, Pack const &no) noexcept
{
    return x86::blend(mask.bits, no.v, yes.v);
}
#elif defined(PW85_LANES_SVE)
PW85_INLINE PackMask operator<(Pack const &x, Pack const &y) noexcept
{
    return {svcmplt(svptrue_b64(), x.v, y.v)};
}
PW85_INLINE PackMask operator<=(Pack const &x, Pack const &y) noexcept
{
    return {svcmple(svptrue_b64(), x.v, y.v)};
}
PW85_INLINE PackMask operator==(Pack const &x, Pack const &y) noexcept
{
    return {svcmpeq(svptrue_b64(), x.v, y.v)};
}
PW85_INLINE Pack select(PackMask mask, Pack const &yes, Pack const &no) noexcept
{
    return svsel(mask.bits, yes.v, no.v);
}
#else
PW85_INLINE PackMask operator<(Pack const &x, Pack const &y) noexcept { return {x.v < y.v}; }
PW85_INLINE PackMask operator<=(Pack const &x, Pack const &y) noexcept { return {x.v <= y.v}; }
PW85_INLINE PackMask operator==(Pack const &x, Pack const &y) noexcept { return {x.v == y.v}; }
PW85_INLINE Pack select(PackMask mask, Pack const &yes, Pack const &no) noexcept
{
    return mask.bits ? yes.v : no.v;
}
#endif
PW85_INLINE PackMask operator>(Pack const &x, Pack const &y) noexcept { return y < x; }
PW85_INLINE PackMask operator>=(Pack const &x, Pack const &y) noexcept { return y <= x; }

// If either operand is NaN, the instructions return the second one, as select(y > x, y, x) does.
#if defined(PW85_LANES_X86)
PW85_INLINE Pack maximum(Pack const &x, Pack const &y) noexcept { return x86::maximum(y.v, x.v); }
PW85_INLINE Pack minimum(Pack const &x, Pack const &y) noexcept { return x86::minimum(y.v, x.v); }
#elif defined(__wasm_simd128__) // its operands are in the other order
PW85_INLINE Pack maximum(Pack const &x, Pack const &y) noexcept
{
    return reinterpret_cast<Register>(
        wasm_f64x2_pmax(reinterpret_cast<v128_t>(x.v), reinterpret_cast<v128_t>(y.v)));
}
PW85_INLINE Pack minimum(Pack const &x, Pack const &y) noexcept
{
    return reinterpret_cast<Register>(
        wasm_f64x2_pmin(reinterpret_cast<v128_t>(x.v), reinterpret_cast<v128_t>(y.v)));
}
#else
PW85_INLINE Pack maximum(Pack const &x, Pack const &y) noexcept { return select(y > x, y, x); }
PW85_INLINE Pack minimum(Pack const &x, Pack const &y) noexcept { return select(y < x, y, x); }
#endif

PW85_INLINE Pack absolute(Pack const &x) noexcept
{
    return reinterpret_cast<Register>(reinterpret_cast<VectorOf<lanes>::Integers>(x.v) & INT64_MAX);
}

PW85_INLINE Pack square_root(Pack const &x) noexcept
{
#if defined(PW85_LANES_X86)
    return x86::square_root(x.v);
#elif defined(PW85_LANES_SVE)
    return svsqrt_x(svptrue_b64(), x.v);
#elif defined(PW85_LANES_NEON)
    return vsqrtq_f64(x.v);
#elif defined(__wasm_simd128__)
    return reinterpret_cast<Register>(wasm_f64x2_sqrt(reinterpret_cast<v128_t>(x.v)));
#else
    Register root = x.v;
    for (std::size_t i = 0; i < lanes; ++i) root[i] = __builtin_sqrt(root[i]);
    return root;
#endif
}

#if defined(PW85_ROUNDED_PRODUCTS)
/// Computes the bits of the function of two doubles.
PW85_INLINE Pack coarse_root_of_ratio(Pack const &x, Pack const &y) noexcept
{
    typedef std::uint64_t Bits __attribute__((vector_size(lanes * sizeof(double))));
    constexpr auto one = __builtin_bit_cast(std::uint64_t, 1.0);
    return reinterpret_cast<Register>(
        (reinterpret_cast<Bits>(x.v) - reinterpret_cast<Bits>(y.v) + 2 * one) >> 1);
}
#endif

#if defined(PW85_LANES_AVX512) && !defined(PW85_ROUNDED_PRODUCTS)
// An estimate with a relative error of 2^-14, improved by one step of Newton's method, which
// doubles the number of correct digits.
PW85_INLINE Pack rough_quotient(Pack const &x, Pack const &y) noexcept
{
    Pack const r = x86::rough_reciprocal(y.v);
    return x * (r + r * (Pack(1.0) - y * r));
}
PW85_INLINE Pack rough_root(Pack const &x) noexcept
{
    Pack const r = x86::rough_reciprocal_root(x.v), half = Pack(0.5), root = x * r;
    return root + root * (half - half * root * r);
}

// To choose a point, the estimates themselves are enough. Their relative errors add up to less than
// 2^-13.
PW85_INLINE Pack coarse_quotient(Pack const &x, Pack const &y) noexcept
{
    return x * Pack(x86::rough_reciprocal(y.v));
}
PW85_INLINE Pack coarse_root_of_ratio(Pack const &x, Pack const &y) noexcept
{
    return x86::rough_reciprocal_root(Pack(coarse_quotient(y, x)).v);
}
#else
PW85_INLINE Pack rough_quotient(Pack const &x, Pack const &y) noexcept { return x / y; }
PW85_INLINE Pack rough_root(Pack const &x) noexcept { return square_root(x); }
PW85_INLINE Pack coarse_quotient(Pack const &x, Pack const &y) noexcept { return x / y; }
#endif

} // namespace PW85_PACKS
} // namespace pw85::detail

template <> struct pw85::ScalarTraits<pw85::detail::Pack> {
    using Lane = double;
    using Mask = pw85::detail::PackMask;
    static constexpr int lanes = static_cast<int>(pw85::detail::lanes);
};

namespace pw85::detail {
inline namespace PW85_PACKS {

PW85_INLINE double first_lane(Pack const &x) noexcept { return x[0]; }

} // namespace PW85_PACKS

template <> PW85_INLINE Pack load_lanes<Pack>(double const *x) noexcept
{
    Pack p;
    std::memcpy(&p.v, x, sizeof p.v);
    return p;
}

} // namespace pw85::detail

#endif
