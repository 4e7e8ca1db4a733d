// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The table of the functions for one pair that are compiled per instruction set: one_pair.cpp has one for each, and chosen() returns the
/// one to call.
#ifndef PW85_KERNELS_ONE_PAIR_HPP_INCLUDED
#define PW85_KERNELS_ONE_PAIR_HPP_INCLUDED

#include <pw85.h>

#include "kernels.hpp"

namespace pw85::detail::kernels {

/// A pointer to a kernel that has the parameters of a function of the C API.
template <class Function> struct KernelOf;
template <class Result, class... Parameters> struct KernelOf<Result(Parameters...)> {
    using Pointer = Result (*)(Parameters...) noexcept;
};
template <class Function> using Kernel = typename KernelOf<Function>::Pointer;

/// Functions for one pair, with the contracts of the C API for inputs that are not null, except that answers are
/// written on success alone. api/shims.py reads this list.
struct OnePairKernels {
    Kernel<decltype(pw85_contact)> contact;
    Kernel<decltype(pw85_overlap)> overlap;
    Kernel<decltype(pw85_contact_geometry)> contact_geometry;
    Kernel<decltype(pw85_contact_gradient)> contact_gradient;
    Kernel<decltype(pw85_contact_torque)> contact_torque;
    Kernel<decltype(pw85_contact_hessian)> contact_hessian;
    Kernel<decltype(pw85_closest_approach)> closest_approach;
    Kernel<decltype(pw85_distance)> distance;
    Kernel<decltype(pw85_distance_derivatives)> distance_derivatives;
    Kernel<decltype(pw85_first_contact)> first_contact;
    Kernel<decltype(pw85_contact_factored)> contact_factored;
    Kernel<decltype(pw85_contact_rounded)> contact_rounded;
    Kernel<decltype(pw85_overlap_factored)> overlap_factored;
    Kernel<decltype(pw85_contact_geometry_factored)> contact_geometry_factored;
    Kernel<decltype(pw85_contact_gradient_factored)> contact_gradient_factored;
    Kernel<decltype(pw85_contains)> contains;
};

} // namespace pw85::detail::kernels

#endif
