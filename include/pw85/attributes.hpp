// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Function attributes: host or device, and linkage.
#ifndef PW85_ATTRIBUTES_HPP_INCLUDED
#define PW85_ATTRIBUTES_HPP_INCLUDED

// Functions for host and device. Code for a device can call only functions that are compiled for
// it.
#if defined(__CUDACC__) || defined(__CUDA__)
#define PW85_ANYWHERE __attribute__((host)) __attribute__((device))
#else
#define PW85_ANYWHERE
#endif

namespace pw85::detail {

/// True if this is compiled for a device. Extended numbers are too large and too slow for its
/// threads.
#ifdef __CUDA_ARCH__
inline constexpr bool is_for_device = true;
#else
inline constexpr bool is_for_device = false;
#endif

} // namespace pw85::detail

// The library's build defines PW85_BUILDING: the instruction set of the unit, `baseline` for most.
// A unit that has the code of PW85_SHARED_BY_QUESTIONS() itself defines PW85_SHARED_HERE. One that
// takes nothing from other units defines PW85_ALL_HERE.
#if defined(PW85_BUILDING) && !defined(PW85_ALL_HERE)
#define PW85_RARE_ELSEWHERE 1
#ifndef PW85_SHARED_HERE
#define PW85_SHARED_WITH PW85_BUILDING
#endif
#endif

/// Stands before every function of the templates. Internal linkage: the linker cannot replace the
/// function by code that was compiled with other flags.
#define PW85_FUNCTION PW85_ANYWHERE static

/// PW85_RARE stands before functions that hardly ever run: those with wider numbers or integers.
///
/// Units of the library, and units that define PW85_RARE_ELSEWHERE, take these functions for
/// doubles from src/rare/, where they are compiled once: a function for doubles goes before the
/// template. PW85_RARE_TIER(name) follows a template of that name, before what calls it, and
/// declares its functions for doubles in two and three dimensions. PW85_RARE_TIER_OF() takes other
/// arguments of the template. api/rare.py reads these lines. No other template of the name may be
/// declared before.
#ifdef PW85_RARE_ELSEWHERE
#define PW85_RARE_TIER_OF(name, ...) [[gnu::cold]] decltype(name<__VA_ARGS__>) name;
#else
#define PW85_RARE_TIER_OF(name, ...)
#endif
#define PW85_RARE_TIER(name) PW85_RARE_TIER_OF(name, double, 2) PW85_RARE_TIER_OF(name, double, 3)
#define PW85_RARE [[gnu::noinline, gnu::cold]] PW85_FUNCTION

/// Code that many functions call, and that no caller inlines, is declared in the same way by
/// PW85_SHARED_BY_QUESTIONS(). Units of the library take it from units for their instruction set
/// (src/simd/shared/), in the namespace PW85_SHARED_WITH. Each unit runs only what was compiled
/// with its own flags.
#ifdef PW85_SHARED_WITH
#define PW85_SHARED_BY_QUESTIONS_OF(name, ...)                                                     \
    inline namespace PW85_SHARED_WITH {                                                            \
    decltype(detail::name<__VA_ARGS__>) name;                                                      \
    }
#else
#define PW85_SHARED_BY_QUESTIONS_OF(name, ...)
#endif
#define PW85_SHARED_BY_QUESTIONS(name)                                                             \
    PW85_SHARED_BY_QUESTIONS_OF(name, double, 2) PW85_SHARED_BY_QUESTIONS_OF(name, double, 3)

/// Stands before every member function of types that devices use. The linker cannot use it for
/// another unit. The tests of the library's answers, whose units have the same flags, define it as
/// nothing, to compile in less time.
#ifndef PW85_MEMBER
#define PW85_MEMBER [[gnu::always_inline]] PW85_ANYWHERE
#endif

#endif
