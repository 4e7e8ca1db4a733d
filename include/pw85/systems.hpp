// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Systems of particles, from C++: the functions of pw85_systems.h on `std::span` (link with pw85),
/// and their contracts. An index that is out of range is `Status::invalid_argument` before anything
/// is written.
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
