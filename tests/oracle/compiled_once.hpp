// SPDX-License-Identifier: BSD-3-Clause
// Functions of the core for the numbers that most tests have. They are compiled once, in
// once_*.cpp: a function for one type of numbers goes before the template. For doubles, tests
// define PW85_SHARED_WITH (attributes.hpp).
#ifndef PW85_TESTS_ORACLE_COMPILED_ONCE_HPP_INCLUDED
#define PW85_TESTS_ORACLE_COMPILED_ONCE_HPP_INCLUDED

#include <pw85/pw85.hpp>

#include "../../src/base/signatures.hpp"
#include "multiprecision.hpp"

namespace pw85_tests {

using Wide = Multiprecision<50>;

} // namespace pw85_tests

/// `once` is a macro of a name, parameters and arguments (signatures.hpp).
#define PW85_ONCE_DETAIL(once, T, D)                                                               \
    PW85_SIGNATURE_validate_pair(once, T, D) PW85_SIGNATURE_search_in_steps(once, T, D)            \
        PW85_SIGNATURE_last_factorized_evaluation(once, T, D) PW85_SIGNATURE_maximize(once, T, D)  \
            PW85_SIGNATURE_maximize_factorized(once, T, D)
#define PW85_ONCE_WIDER(once, T, D)                                                                \
    PW85_SIGNATURE_maximize_wider(once, T, D)                                                      \
        PW85_SIGNATURE_search_in_steps(once, pw85::detail::exact::Extended<T>, D)
#define PW85_ONCE_PAIR(T, D)                                                                       \
    (Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2)
#define PW85_ONCE_PUBLIC(once, T, D)                                                               \
    once(contact, PW85_ONCE_PAIR(T, D), (r12, q1, q2))                                             \
        once(overlap, PW85_ONCE_PAIR(T, D), (r12, q1, q2))                                         \
            once(distance, PW85_ONCE_PAIR(T, D), (r12, q1, q2))

/// All of them for one type of numbers that has wider ones, and for one that has none.
#define PW85_ONCE_SCALAR(once, T)                                                                  \
    namespace pw85::detail {                                                                       \
    PW85_ONCE_DETAIL(once, T, 2)                                                                   \
    PW85_ONCE_DETAIL(once, T, 3)                                                                   \
    PW85_ONCE_WIDER(once, T, 2)                                                                    \
    PW85_ONCE_WIDER(once, T, 3)                                                                    \
    }
#define PW85_ONCE_WIDE(once, T)                                                                    \
    namespace pw85::detail {                                                                       \
    PW85_ONCE_DETAIL(once, T, 2)                                                                   \
    PW85_ONCE_DETAIL(once, T, 3)                                                                   \
    }                                                                                              \
    namespace pw85 {                                                                               \
    PW85_ONCE_PUBLIC(once, T, 2)                                                                   \
    PW85_ONCE_PUBLIC(once, T, 3)                                                                   \
    }

#define PW85_ONCE_DECLARED(name, parameters, arguments)                                            \
    auto name parameters noexcept->decltype(name<> arguments);

PW85_ONCE_SCALAR(PW85_ONCE_DECLARED, float)
PW85_ONCE_SCALAR(PW85_ONCE_DECLARED, long double)
PW85_ONCE_WIDE(PW85_ONCE_DECLARED, pw85_tests::Wide)

#endif
