// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The registers that the packs of a unit (pack.hpp) are made of: how many doubles they hold, for
/// the instruction set of the unit and the macros that it defines first, and the namespace of its
/// packs.
#ifndef PW85_SIMD_REGISTERS_HPP_INCLUDED
#define PW85_SIMD_REGISTERS_HPP_INCLUDED

#include <cstddef>

#include "../base/x86.hpp"

// At most one of PW85_LANES_AVX512, _AVX2, _SVE512, _SVE256 and _NEON is defined, by the set. A
// unit that defines PW85_TWO_LANES has PW85_LANES_FMA instead of _AVX2: two doubles, with fused
// multiply-add. PW85_FOUR_LANES takes four doubles where registers have eight.
#define PW85_SET_avx512 1
#define PW85_SET_avx2 2
#define PW85_SET_sve512 3
#define PW85_SET_sve256 4
#define PW85_SET_neon 5
#define PW85_SET_NUMBER(name) PW85_SET_##name
#define PW85_SET(name) PW85_SET_NUMBER(name)
#if PW85_SET(PW85_BUILDING) == 1 && !defined(PW85_FOUR_LANES)
#define PW85_LANES_AVX512
#elif PW85_SET(PW85_BUILDING) == 2 && defined(PW85_TWO_LANES)
#define PW85_LANES_FMA
#elif PW85_SET(PW85_BUILDING) == 2 || PW85_SET(PW85_BUILDING) == 1
#define PW85_LANES_AVX2
#elif PW85_SET(PW85_BUILDING) == 3
#define PW85_LANES_SVE512
#elif PW85_SET(PW85_BUILDING) == 4
#define PW85_LANES_SVE256
#elif PW85_SET(PW85_BUILDING) == 5
#define PW85_LANES_NEON
#endif
#if defined(PW85_LANES_SVE512) || defined(PW85_LANES_SVE256)
#define PW85_LANES_SVE
#include <arm_sve.h>
#elif defined(PW85_LANES_NEON)
#include <arm_neon.h>
#elif defined(__SSE2__)
#define PW85_LANES_X86
#elif defined(__wasm_simd128__)
#include <wasm_simd128.h>
#endif

// The namespace of packs is named after what they depend on, so that units for the same instruction
// set can pass packs to each other.
#if defined(PW85_LANES_AVX512)
#define PW85_PACKS_OF(kind) kind##_avx512
#elif defined(PW85_LANES_AVX2)
#define PW85_PACKS_OF(kind) kind##_avx2
#elif defined(PW85_LANES_FMA)
#define PW85_PACKS_OF(kind) kind##_fma
#elif defined(PW85_LANES_SVE512)
#define PW85_PACKS_OF(kind) kind##_sve512
#elif defined(PW85_LANES_SVE256)
#define PW85_PACKS_OF(kind) kind##_sve256
#elif defined(PW85_LANES_NEON)
#define PW85_PACKS_OF(kind) kind##_neon
#else
#define PW85_PACKS_OF(kind) kind##_baseline
#if !defined(PW85_ROUNDED_PRODUCTS)
#define PW85_ROUNDED_PRODUCTS // there are no others
#endif
#endif
#if defined(PW85_ROUNDED_PRODUCTS)
#define PW85_PACKS PW85_PACKS_OF(rounded_packs)
#else
#define PW85_PACKS PW85_PACKS_OF(packs)
#endif

namespace pw85::detail {
inline namespace PW85_PACKS {

#if defined(PW85_LANES_AVX512)
inline constexpr std::size_t lanes = 8;
#elif defined(PW85_LANES_AVX2)
inline constexpr std::size_t lanes = 4;
#elif defined(PW85_LANES_SVE)
inline constexpr std::size_t lanes = __ARM_FEATURE_SVE_BITS / 64;
#else
inline constexpr std::size_t lanes = 2;
#endif

} // namespace PW85_PACKS
} // namespace pw85::detail

#endif
