// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Status codes, and their texts.
#ifndef PW85_STATUS_HPP_INCLUDED
#define PW85_STATUS_HPP_INCLUDED

#include <pw85/attributes.hpp>
#include <pw85/requirements.hpp>
#include <pw85/status.h>

namespace pw85 {

// Xlib.h defines Status as a macro. The macro is set aside for these lines only, and StatusCode is
// the name that the headers and programs with Xlib.h use.
#pragma push_macro("Status")
#undef Status

/// Outcome of a call, with the numbers of the C API.
enum class Status : int {
#define PW85_STATUS_ENUMERATOR(c_name, name, value, text) name = value,
    PW85_STATUS_LIST(PW85_STATUS_ENUMERATOR)
#undef PW85_STATUS_ENUMERATOR
};

/// Another name of Status, for programs that include Xlib.h.
using StatusCode = Status;

#pragma pop_macro("Status")

/// Returns a sentence that says what a status means; a constant, never null.
PW85_FUNCTION constexpr char const *strerror(StatusCode status) noexcept
{
    switch (status) {
#define PW85_STATUS_CASE(c_name, name, value, text)                                                \
    case StatusCode::name:                                                                         \
        return text;
        PW85_STATUS_LIST(PW85_STATUS_CASE)
#undef PW85_STATUS_CASE
    }
    return "unknown status";
}

} // namespace pw85

#endif
