// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Defines the functions of PW85_SHARED_BY_QUESTIONS() (attributes.hpp), as rare/define.hpp those
/// that hardly ever run.
#ifndef PW85_SIMD_DEFINE_SHARED_HPP_INCLUDED
#define PW85_SIMD_DEFINE_SHARED_HPP_INCLUDED

#include "../base/signatures.hpp"

#define PW85_SHARED_DEFINED(name, parameters, arguments)                                           \
    auto name parameters noexcept->decltype(detail::name<> arguments)                              \
    {                                                                                              \
        return detail::name<> arguments;                                                           \
    }
#define PW85_DEFINE_SHARED(name, ...) PW85_SIGNATURE_##name(PW85_SHARED_DEFINED, __VA_ARGS__)

#endif
