// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Many pairs at once, from C++: `std::span` over the functions of pw85_batch.h (link with pw85).
///
/// The contracts are those of pw85_batch.h: a bad pair is marked (NaN, or 255 for overlaps) and the
/// status of the first one is returned. If the sizes of spans are inconsistent, the status is
/// `Status::invalid_argument`, and nothing is written. Spans may be empty. Outputs with a default
/// value are optional.
///
/// pw85/batch/rows.hpp has the functions whose arguments are all rows. pw85/batch/pairs.hpp has two
/// functions that C does not have: for single precision, and for one ellipsoid and many others.
#ifndef PW85_BATCH_HPP_INCLUDED
#define PW85_BATCH_HPP_INCLUDED

#include <pw85/batch/pairs.hpp>
#include <pw85/batch/rows.hpp>

#endif
