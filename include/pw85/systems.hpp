// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Systems of particles, from C++: the functions of pw85_systems.h on `std::span` (link with pw85),
/// and their contracts. If an index is out of range, the status is `Status::invalid_argument`, and
/// nothing is written.
///
/// In the folder systems/, lists.hpp has the functions with rows for the pairs of a list, sums.hpp
/// sums of forces, periodic.hpp cells and images, neighbors.hpp neighbour lists, meshes.hpp
/// triangle meshes.
#ifndef PW85_SYSTEMS_HPP_INCLUDED
#define PW85_SYSTEMS_HPP_INCLUDED

#include <pw85/systems/lists.hpp>
#include <pw85/systems/meshes.hpp>
#include <pw85/systems/neighbors.hpp>
#include <pw85/systems/periodic.hpp>
#include <pw85/systems/sums.hpp>

#endif
