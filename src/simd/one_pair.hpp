// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The functions for one pair that are compiled per instruction set: the files pair_*.cpp and
/// search_*.cpp define them, and PW85_OF_PAIR() chooses one.
#ifndef PW85_SIMD_ONE_PAIR_HPP_INCLUDED
#define PW85_SIMD_ONE_PAIR_HPP_INCLUDED

#include <pw85.h>

#include "targets.hpp"

/// Calls X(name) for each. They have the contracts of the functions of the C API of these names for
/// inputs that are not null, except that answers are written on success alone. api/shims.py reads
/// this list.
#define PW85_ONE_PAIR_FUNCTIONS(X)                                                                 \
    X(contact)                                                                                     \
    X(overlap)                                                                                     \
    X(contact_geometry)                                                                            \
    X(contact_gradient)                                                                            \
    X(contact_torque)                                                                              \
    X(contact_hessian)                                                                             \
    X(closest_approach)                                                                            \
    X(distance)                                                                                    \
    X(distance_geometry)                                                                           \
    X(distance_derivatives)                                                                        \
    X(penetration)                                                                                 \
    X(signed_distance)                                                                             \
    X(signed_distance_geometry)                                                                    \
    X(signed_distance_derivatives)                                                                 \
    X(first_contact)                                                                               \
    X(contact_factored)                                                                            \
    X(contact_rounded)                                                                             \
    X(overlap_factored)                                                                            \
    X(contact_geometry_factored)                                                                   \
    X(contact_gradient_factored)                                                                   \
    X(contains)

namespace pw85::detail::kernels {

/// The type of a function of the C API, with noexcept.
template <class Function> struct Noexcept;
template <class Result, class... Parameters> struct Noexcept<Result(Parameters...)> {
    using Function = Result(Parameters...) noexcept;
};

#define PW85_DECLARE_FUNCTION(name) Noexcept<decltype(pw85_##name)>::Function name;
#define PW85_DECLARE_ONE_PAIR(target, one_pair, lanes256, available)                               \
    namespace one_pair {                                                                           \
    PW85_ONE_PAIR_FUNCTIONS(PW85_DECLARE_FUNCTION)                                                 \
    }
PW85_EACH_TARGET(PW85_DECLARE_ONE_PAIR)
#undef PW85_DECLARE_ONE_PAIR
#undef PW85_DECLARE_FUNCTION

} // namespace pw85::detail::kernels

#endif
