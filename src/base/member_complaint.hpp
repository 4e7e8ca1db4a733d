// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Complaints about structs of the caller: laws, walls, fields. They name the member.
#ifndef PW85_BASE_MEMBER_COMPLAINT_HPP_INCLUDED
#define PW85_BASE_MEMBER_COMPLAINT_HPP_INCLUDED

#include <limits>

#include "last_error.hpp"

namespace pw85::detail {

/// A requirement that a member of a struct does not meet. `text` is null if it meets all.
struct MemberComplaint {
    char const *member = nullptr, *text = nullptr;
    double value = std::numeric_limits<double>::quiet_NaN();
    std::size_t entry = 0; ///< of a member that is an array
};

namespace {

/// Returns a complaint about the first of n numbers of a member that is not finite.
inline MemberComplaint unless_finite(char const *member, char const *text, double const *x,
                                     std::size_t n) noexcept
{
    for (std::size_t k = 0; k < n; ++k)
        if (!is_finite(x[k])) return {member, text, x[k], k};
    return {};
}

/// Notes a complaint about a struct, which is a row of an array, and returns PW85_EINVAL.
inline int note_complaint(MemberComplaint const &found, std::size_t row = 0) noexcept
{
    return note_cause(PW85_EINVAL, found.member, found.text, row, found.entry, found.value);
}

} // namespace
} // namespace pw85::detail

#endif
