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
void mark(Output *output, std::size_t count, Value value) noexcept
{
    for (std::size_t k = 0; output != nullptr && k < count; ++k)
        output[k] = static_cast<Output>(value);
}

/// A struct of arguments, or an empty one for null.
template <class Struct> Struct value_or_empty(Struct const *given) noexcept
{
    return given == nullptr ? Struct{} : *given;
}

/// Calls work(), which returns a status, if the arguments are within their limits. The cause of a
/// refusal is recorded.
template <std::size_t count, class Work> int
checked_call(char const *function, Argument const (&arguments)[count], Work const &work) noexcept
{
    int const status = in_default_environment([&] {
        int const bad = begin_call(arguments, count);
        return bad == PW85_SUCCESS ? int{work()} : bad;
    });
    return checked(status,
                   [&](int found) { return refuse_noted(found, function, arguments, count); });
}

} // namespace
} // namespace pw85::detail

#endif
