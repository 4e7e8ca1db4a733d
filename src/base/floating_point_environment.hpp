// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Computes in the default floating-point environment of IEEE 754, whatever the caller's
/// environment is. All functions of the C API use it.
///
/// Results are checked after they are computed, so that intermediate numbers of valid input may
/// overflow or be NaN. The caller does not see this: status flags and traps stay as they were. The
/// caller's modes do not change a result: rounding is to nearest, and subnormal numbers are kept.
/// (A program that is linked with -ffast-math flushes them to zero in all of its threads.)
#ifndef PW85_BASE_FLOATING_POINT_ENVIRONMENT_HPP_INCLUDED
#define PW85_BASE_FLOATING_POINT_ENVIRONMENT_HPP_INCLUDED

#include <type_traits>

#ifdef __SSE2_MATH__
#include <xmmintrin.h>
#else
#include <cfenv>
#endif

namespace pw85::detail {
namespace {

/// Sets the default environment while the object lives, then restores the caller's. The register is
/// written only if it has to change: a write that clears a flag costs some 80 ns on Intel's
/// processors. Callers mostly have the default modes and the flag of inexact results, so that
/// nothing changes. The compiler may move arithmetic that it sees out of the object's scope. So
/// only threads have an object of their own, for calls of kernels; everything else uses
/// in_default_environment().
class DefaultEnvironment {
  public:
    DefaultEnvironment(DefaultEnvironment const &) = delete;
    DefaultEnvironment &operator=(DefaultEnvironment const &) = delete;

#ifdef __SSE2_MATH__
    [[gnu::always_inline]] DefaultEnvironment() noexcept : caller_(_mm_getcsr())
    {
        if ((caller_ & ~status_flags) != default_modes) _mm_setcsr(default_modes);
    }
    [[gnu::always_inline]] ~DefaultEnvironment()
    {
        if (_mm_getcsr() != caller_) _mm_setcsr(caller_);
    }

  private:
    static constexpr unsigned status_flags = 0x3f, default_modes = 0x1f80; // all traps off

    unsigned caller_;
#else
    [[gnu::always_inline]] DefaultEnvironment() noexcept
    {
        std::fegetenv(&caller_);
        std::fesetenv(FE_DFL_ENV);
    }
    [[gnu::always_inline]] ~DefaultEnvironment() { std::fesetenv(&caller_); }

  private:
    std::fenv_t caller_;
#endif
};

/// Returns the result of function(), computed in the default environment. The barriers pass the
/// data of the function through memory, so that the compiler cannot move its arithmetic out of the
/// scope of the environment.
template <class Function>
[[gnu::always_inline]] inline auto in_default_environment(Function const &function) noexcept
{
    DefaultEnvironment const environment;
    Function const *own = &function;
    asm volatile("" : "+r"(own) : : "memory");
    if constexpr (std::is_void_v<decltype(function())>) {
        (*own)();
        asm volatile("" : : : "memory");
    } else {
        auto const result = (*own)();
        asm volatile("" : : "m"(result) : "memory");
        return result;
    }
}

/// The result of a function that the compiler cannot see through, as those of kernels are: nothing
/// has to pass through memory.
template <class Result, class... Parameters, class... Arguments>
[[gnu::always_inline]] inline Result
in_default_environment(Result (*function)(Parameters...) noexcept, Arguments... arguments) noexcept
{
    DefaultEnvironment const environment;
    return function(arguments...);
}

} // namespace
} // namespace pw85::detail

#endif
