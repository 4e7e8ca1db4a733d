// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Calls of functions that work on objects of the library: neighbour lists, meshes, simulations.
/// Their shims are made (src/c_api/objects_*.cpp).
#ifndef PW85_BASE_CHECKED_CALL_HPP_INCLUDED
#define PW85_BASE_CHECKED_CALL_HPP_INCLUDED

#include <pw85/algebra/scalar.hpp>

#include "floating_point_environment.hpp"
#include "last_error.hpp"

namespace pw85::detail {
namespace {

/// Fills an output with what it is on error, unless it is null.
template <class Output, class Value>
[[gnu::always_inline]] inline void mark(Output *output, std::size_t count, Value value) noexcept
{
    for (std::size_t k = 0; output != nullptr && k < count; ++k)
        output[k] = static_cast<Output>(value);
}

/// A struct of arguments, or an empty one for null.
template <class Struct>
[[gnu::always_inline]] inline Struct value_or_empty(Struct const *given) noexcept
{
    return given == nullptr ? Struct{} : *given;
}

/// Returns whether an argument is not null, and within its limits if it is of one row. Inlined with
/// constant limits, this takes some instructions.
[[gnu::always_inline]] inline bool is_good(Argument const &one) noexcept
{
    if (one.is_null()) return (one.limits & limit::optional) != 0;
    if (one.columns > 0) return true;
    bool good = !(one.limits & limit::not_zero);
    for (std::size_t i = 0; i < one.count; ++i) good = good || !is_zero(one.numbers()[i]);
    for (std::size_t i = 0; i < one.count; ++i) {
        double const x = one.numbers()[i];
        bool const may_be = (one.limits & limit::may_be_infinite) && !is_nan(x);
        good = good && (is_finite(x) || may_be) && is_within(x, one.limits);
    }
    return good;
}

/// Records the cause that was noted, or else the first argument that explains the status.
template <class... Arguments> [[gnu::cold, gnu::noinline]] int
refuse_noted_call(int status, char const *function, Arguments... arguments) noexcept
{
    Argument const listed[] = {arguments...};
    return refuse_noted(status, function, listed, sizeof...(arguments));
}

/// Calls work(), which returns a status, if the arguments are within their limits. The cause of a
/// refusal is recorded.
template <class Work, class... Arguments> [[gnu::always_inline]] inline int
checked_call(char const *function, Work const &work, Arguments... arguments) noexcept
{
    int status = PW85_EINVAL;
    if ((is_good(arguments) && ...)) [[likely]]
        status = in_default_environment(work);
    if (status != PW85_SUCCESS) [[unlikely]]
        return refuse_noted_call(status, function, arguments...);
    return status;
}

} // namespace
} // namespace pw85::detail

#endif
