/* SPDX-License-Identifier: BSD-3-Clause */
/** @file pw85_simulation.h
 * @brief Monte Carlo simulations of hard ellipsoids.
 *
 * This header includes six others:
 *
 * - pw85_simulation_state.h: how to make and save simulations, and their particles;
 * - pw85_simulation_surroundings.h: walls, meshes, fields and laws;
 * - pw85_simulation_trials.h: sweeps, event chains and changes of the cell;
 * - pw85_simulation_insertions.h: positions, insertions and removals of single particles;
 * - pw85_simulation_observations.h: energies, neighbours and overlaps;
 * - pw85_simulation_addition.h: random sequential addition, which makes packings.
 *
 * The conventions are those of pw85.h, with these additions:
 *
 * - A simulation owns its particles, cell, neighbour lists, random numbers and counts. Only one
 *   thread at a time may use it; the functions themselves run in parallel.
 * - Particles never overlap. The exact overlap test decides each trial move, for the vectors
 *   between centres as rounded to doubles. The target is the uniform distribution over all
 *   configurations without overlaps, at constant volume or, with volume moves, at constant
 *   pressure.
 * - The random numbers of a simulation come from Philox4x32-10 (Salmon and others 2011). The seed
 *   and the number of the step select them. The same calls therefore give bitwise equal
 *   trajectories, with any number of threads and after pw85_hard_ellipsoids_restore().
 * - A two-dimensional simulation (pw85_hard_ellipsoids_set_dimensions()) has hard ellipses in a
 *   plane z = const.
 */
#ifndef PW85_SIMULATION_H_INCLUDED
#define PW85_SIMULATION_H_INCLUDED

#include <pw85_simulation_addition.h>
#include <pw85_simulation_insertions.h>
#include <pw85_simulation_observations.h>
#include <pw85_simulation_state.h>
#include <pw85_simulation_surroundings.h>
#include <pw85_simulation_trials.h>

#endif
