// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Defines the one instance for doubles of tiers that hardly ever run (PW85_RARE, attributes.hpp).
/// Each file of this folder defines those of one question, and takes the others from their files.
/// Programs with the static library get only what they call.
#ifndef PW85_RARE_DEFINE_HPP_INCLUDED
#define PW85_RARE_DEFINE_HPP_INCLUDED

// Arguments are references: each function is a jump into its template.
#define PW85_RARE_DEFINED(name, parameters, arguments)                                             \
    auto name parameters noexcept->decltype(name<> arguments) { return name<> arguments; }
#define PW85_DEFINE(functions)                                                                     \
    functions(PW85_RARE_DEFINED, double, 2) functions(PW85_RARE_DEFINED, double, 3)
#define PW85_DEFINE_IN_SPACE(functions) functions(PW85_RARE_DEFINED, double)

#endif
