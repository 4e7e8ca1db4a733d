// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Defines the one instance for doubles of tiers that hardly ever run (PW85_RARE, attributes.hpp).
/// Each file of this folder defines those of one question, and takes the others from their files.
/// Programs with the static library get only what they call.
#ifndef PW85_RARE_DEFINE_HPP_INCLUDED
#define PW85_RARE_DEFINE_HPP_INCLUDED

#include "../base/signatures.hpp"

// Arguments are references: each function is a jump into its template.
#define PW85_RARE_DEFINED(name, parameters, arguments)                                             \
    auto name parameters noexcept->decltype(name<> arguments) { return name<> arguments; }
#define PW85_DEFINE_OF(name, ...) PW85_SIGNATURE_##name(PW85_RARE_DEFINED, __VA_ARGS__)
#define PW85_DEFINE(name) PW85_DEFINE_OF(name, double, 2) PW85_DEFINE_OF(name, double, 3)

#endif
