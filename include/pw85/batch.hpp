// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Many pairs at once, from C++: `std::span` over the functions of pw85_batch.h (link with pw85).
///
/// The contracts are those of pw85_batch.h: a bad pair is marked (NaN, or 255 for overlaps) and the
/// status of the first one is returned. Sizes that do not fit together are
/// `Status::invalid_argument` before anything is written. Empty spans are fine. Outputs with a
/// default may be left out.
///
/// pw85/batch/rows.hpp has the functions that take nothing but rows, pw85/batch/pairs.hpp those
/// that C does not have: single precision, and one ellipsoid against many.
#ifndef PW85_BATCH_HPP_INCLUDED
#define PW85_BATCH_HPP_INCLUDED

#include <pw85/batch/pairs.hpp>
#include <pw85/batch/rows.hpp>

#endif
