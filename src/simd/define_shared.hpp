// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Defines the functions of PW85_SHARED_BY_QUESTIONS() (attributes.hpp), as rare/define.hpp those
/// that hardly ever run.
#ifndef PW85_SIMD_DEFINE_SHARED_HPP_INCLUDED
#define PW85_SIMD_DEFINE_SHARED_HPP_INCLUDED

#define PW85_DEFINE_SHARED(name, parameters, arguments)                                            \
    auto name parameters noexcept->decltype(detail::name<> arguments)                              \
    {                                                                                              \
        return detail::name<> arguments;                                                           \
    }

#endif
