// SPDX-License-Identifier: BSD-3-Clause
// Defines the functions of compiled_once.hpp.
#ifndef PW85_TESTS_ORACLE_DEFINE_ONCE_HPP_INCLUDED
#define PW85_TESTS_ORACLE_DEFINE_ONCE_HPP_INCLUDED

#include "compiled_once.hpp"

#define PW85_ONCE_DEFINED(name, parameters, arguments)                                             \
    auto name parameters noexcept->decltype(name<> arguments) { return name<> arguments; }

/// In the namespace PW85_SHARED_WITH, where `name` is the function itself.
#define PW85_ONCE_SHARED(name, parameters, arguments)                                              \
    auto name parameters noexcept->decltype(detail::name<> arguments)                              \
    {                                                                                              \
        return detail::name<> arguments;                                                           \
    }

#endif
