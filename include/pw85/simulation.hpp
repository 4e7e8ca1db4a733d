// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Monte Carlo of hard ellipsoids for C++. The members call the functions of the compiled library
/// (link with pw85), and their contracts are those of pw85_simulation.h.
///
/// In the folder simulation/, hard_ellipsoids.hpp has the simulation, surroundings.hpp walls and
/// fields, trials.hpp steps, fractions and counts of trials; random_addition.hpp has random
/// sequential addition.
#ifndef PW85_SIMULATION_HPP_INCLUDED
#define PW85_SIMULATION_HPP_INCLUDED

#include <pw85/simulation/addition.hpp>
#include <pw85/simulation/hard_ellipsoids.hpp>
#include <pw85/simulation/random_addition.hpp>
#include <pw85/simulation/surroundings.hpp>
#include <pw85/simulation/trials.hpp>
#include <pw85/systems.hpp>

#endif
