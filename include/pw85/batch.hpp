/// @file
/// Many pairs at once, from C++: `std::span` over the functions of the compiled library (link with pw85).
///
/// The contracts are those of pw85.h: a bad pair is marked (NaN, or 255 for overlaps) and the status of the first one is
/// returned; sizes that do not fit together, or an index out of range, are `Status::invalid_argument` before anything is
/// written. Empty spans are fine. Outputs with a default may be left out.
///
/// The functions are in the headers of the folder: pw85/batch/rows.hpp has those that take nothing but rows,
/// pw85/batch/pairs.hpp more of many pairs, pw85/batch/lists.hpp those with rows for the pairs of a list, and
/// pw85/batch/systems.hpp others of systems.
#ifndef PW85_BATCH_HPP_INCLUDED
#define PW85_BATCH_HPP_INCLUDED

#include <pw85/batch/lists.hpp>
#include <pw85/batch/pairs.hpp>
#include <pw85/batch/rows.hpp>
#include <pw85/batch/systems.hpp>
#include <pw85/motion/first_contact.hpp>

#endif
