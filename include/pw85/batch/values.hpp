// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The arguments of the functions of many rows: spans of rows, and structs of several spans.
/// calls.hpp converts them to the arguments of the C API.
#ifndef PW85_BATCH_VALUES_HPP_INCLUDED
#define PW85_BATCH_VALUES_HPP_INCLUDED

#include <span>

#include <pw85/algebra/factor.hpp>
#include <pw85/motion/motion.hpp>
#include <pw85/status.hpp>

namespace pw85 {

using Vectors = std::span<Vector<double, 3> const>;
using Forms = std::span<SymmetricMatrix<double, 3> const>;

/// The separations and forms of ellipses.
using FlatVectors = std::span<Vector<double, 2> const>;
using FlatForms = std::span<SymmetricMatrix<double, 2> const>;

/// The outputs for the contact functions of pairs and their derivatives: see
/// pw85_contact_derivatives_batch().
struct DerivativeSpans {
    std::span<double> mu2 = {}, lambda = {};
    std::span<Vector<double, 3>> point = {}, normal = {}, d_r12 = {}, d_rot1 = {}, d_rot2 = {};
};

} // namespace pw85

#endif
