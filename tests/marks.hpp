// SPDX-License-Identifier: BSD-3-Clause
// What a call reads, as numbers to be changed, and what it says of its outputs.
#ifndef PW85_TESTS_MARKS_HPP_INCLUDED
#define PW85_TESTS_MARKS_HPP_INCLUDED

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <string>

#include "calls.hpp"

namespace pw85_tests {

/// Whether name is one of some names.
inline bool is_one_of(std::string const &name, std::initializer_list<char const *> names)
{
    return std::any_of(names.begin(), names.end(),
                       [&](char const *other) { return name == other; });
}

/// Whether an element of an output says that there is no result.
inline bool is_marked(Call &call, std::size_t k, std::size_t i)
{
    switch (call.parameter(k).type) {
    case Type::real:
        return std::isnan(call.elements<double>(k)[i]);
    case Type::byte:
        return call.elements<unsigned char>(k)[i] == 255;
    case Type::integer:
        return call.elements<int>(k)[i] == (is_one_of(call.parameter(k).name, {"sign"}) ? 2 : -1);
    case Type::int32:
        return call.elements<std::int32_t>(k)[i] ==
               (is_one_of(call.parameter(k).name, {"triangle", "inside"})
                    ? -1
                    : std::numeric_limits<std::int32_t>::min());
    case Type::handle:
        return *call.elements<void *>(k) == nullptr;
    default:
        return true; // the index of a bad particle
    }
}

/// Whether the first row of each output is marked. Events and forces belong to particles, and bad
/// pairs are none of theirs.
inline bool first_rows_marked(Call &call)
{
    bool marked = true;
    for (std::size_t k = 0; k < call.size(); ++k) {
        bool const of_particles =
            is_one_of(call.parameter(k).name, {"next", "next_pair", "forces", "torques", "virial"});
        if (!call.parameter(k).output || of_particles || call[k].pointer == nullptr) continue;
        for (std::size_t i = 0; i < call.row_length(k); ++i)
            marked = marked && is_marked(call, k, i);
    }
    return marked;
}

inline bool guards_intact(Call &call)
{
    bool intact = true;
    for (std::size_t k = 0; k < call.size(); ++k)
        intact = intact && (!call.parameter(k).output || call.guards_intact(k));
    return intact;
}

/// The numbers of a parameter: a number, or the first row of an array.
struct Numbers {
    double *begin;
    std::size_t size;
};

inline Numbers numbers(Call &call, std::size_t k)
{
    Parameter const &p = call.parameter(k);
    if (!p.pointer) return {&call[k].real, 1};
    std::size_t const doubles = size_of(p.type) / sizeof(double);
    return {call.elements<double>(k), call.row_length(k) * doubles};
}

} // namespace pw85_tests

#endif
