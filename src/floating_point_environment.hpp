/// @file
/// The floating-point environment of the library: that of IEEE 754's defaults, whatever the caller's.
///
/// Pairs are computed with first and looked at afterwards, so that valid input may overflow or give NaN on the way. The caller
/// sees nothing of that: his status flags and traps are as they were. Nor do his modes change a result: rounding is to
/// nearest, and subnormal numbers are kept, which a program that is linked with -ffast-math gives up for all of its threads.
#ifndef PW85_FLOATING_POINT_ENVIRONMENT_HPP_INCLUDED
#define PW85_FLOATING_POINT_ENVIRONMENT_HPP_INCLUDED

#include <type_traits>

#ifdef __SSE2_MATH__
#include <xmmintrin.h>
#else
#include <cfenv>
#endif

namespace pw85::detail {
namespace {

/// Sets the default environment for the life of the object, and restores the caller's. The register is read, and written only where
/// it has to change: a write that takes back a flag costs some 80 ns on Intel's processors, and callers mostly have the default
/// modes and have rounded before, so that nothing changes. A compiler may move arithmetic that it sees across: only threads have one of
/// their own, for calls of kernels, and everything else is by in_default_environment().
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

/// The result of function() in the default environment. What the function refers to passes through memory, where the compiler
/// must leave it in order.
template <class Function> [[gnu::always_inline]] inline auto in_default_environment(Function const &function) noexcept
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

/// The result of a function that the compiler cannot see through, as those of kernels are: nothing has to pass through memory.
template <class Result, class... Parameters, class... Arguments> [[gnu::always_inline]] inline Result
in_default_environment(Result (*function)(Parameters...) noexcept, Arguments... arguments) noexcept
{
    DefaultEnvironment const environment;
    return function(arguments...);
}

} // namespace
} // namespace pw85::detail

#endif
