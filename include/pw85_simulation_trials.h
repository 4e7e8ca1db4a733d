/* SPDX-License-Identifier: BSD-3-Clause */
/** @file pw85_simulation_trials.h
 * @brief Trials of a simulation: sweeps, event chains, changes of the cell, and their steps.
 * pw85_simulation.h includes this header and has the conventions.
 */
#ifndef PW85_SIMULATION_TRIALS_H_INCLUDED
#define PW85_SIMULATION_TRIALS_H_INCLUDED

#include <pw85_simulation_state.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @name Trials
 * @{ */

/** Scales the cell by the same factor in all directions. */
#define PW85_CHANGE_ISOTROPIC 0

/** Scales the cell along x, y or z, chosen at random; in two dimensions along x or y. */
#define PW85_CHANGE_AXIS 1

/** Scales the cell along x, y or z, or shears it, chosen at random. A shear adds a multiple of y or
 * z to x, or of z to y; in two dimensions, of y to x. A cell whose vectors are a lower triangular
 * matrix therefore remains lower triangular. */
#define PW85_CHANGE_TRICLINIC 2

/** Scales the cell along x, y or z, chosen at random, and along the two other directions such that
 * the volume is constant up to rounding errors; in two dimensions along x and y, at constant area.
 * The pressure is not used. */
#define PW85_CHANGE_ASPECT 3

/** Makes sweeps. The number of trials in a sweep is the number of particles.
 *
 * The cell is divided into domains, with a random origin for each sweep (checkerboard
 * decomposition). Domains of one colour are not neighbours, and threads work on them at the same
 * time: first on all domains of one colour, then on those of another, in random order. A domain
 * gets as many trials as it has particles, each for a random particle of the domain. A trial that
 * leaves its domain is rejected. Therefore the numbers of particles in the domains do not change
 * during a sweep, a trial and its reverse have the same proposal probability, and a sweep satisfies
 * detailed balance.
 *
 * A translation is a random vector in a ball. A rotation multiplies the quaternion from the left by
 * (1, v), with a random vector v in a ball. An exchange swaps the semi-axes of two particles of a
 * domain. In two dimensions a translation is a random vector in a disc, and a rotation about z
 * multiplies by (1, 0, 0, v), with v uniform in an interval around 0: rotations by an angle and by
 * its negative are equally probable.
 *
 * @param simulation a simulation
 * @param num_sweeps number of sweeps
 * @return #PW85_SUCCESS, #PW85_EINVAL; #PW85_ENOMEM, after which the last sweep is not complete;
 *        #PW85_EPOTENTIAL as for pw85_hard_ellipsoids_set_potential() */
PW85_API int pw85_hard_ellipsoids_sweep(pw85_hard_ellipsoids *simulation, size_t num_sweeps);

/** Makes event chains, which translate many particles at once and give the pressure.
 *
 * In a chain, a random particle moves along a direction until it touches another one. This second
 * particle then moves along the same direction until it touches a third one, and so on. The chain
 * ends when the sum of the displacements is its length. No chain leads to an overlap:
 * pw85_free_path() computes the displacements, and the exact overlap test checks each position.
 * Chains do not rotate particles: alternate them with sweeps of rotations.
 *
 * Chains along random directions satisfy detailed balance. Chains along one direction keep the
 * uniform distribution without detailed balance (global balance), but do not change the coordinates
 * perpendicular to it. Let x be the coordinate along the direction of the particle that moves; it
 * jumps at each contact. βP/ρ along the direction is the mean of (x_last - x_first)/length over
 * chains (Michel, Kapfer and Krauth 2014). To estimate its error, make blocks of chains.
 *
 * @param simulation a simulation
 * @param num_chains number of chains
 * @param length [length; > 0] of each chain, in the unit of length. The mean free path times the
 *        number of particles would be a long chain
 * @param direction [optional; != 0] of any length, in two dimensions with z = 0; or null for an
 *        isotropic random direction for each chain
 * @param[out] compressibility [optional; NaN on error] βP/ρ along the directions, by these chains.
 *        NaN without chains or particles. NaN also if the shortest vector of the lattice is at most
 *        twice the longest semi-axis: a rotated particle could then touch its own image. Such
 *        contacts contribute to the pressure, but chains do not find them, because images move with
 *        their particle
 * @return #PW85_SUCCESS; #PW85_EINVAL, also for a direction out of the plane in two dimensions, for
 *        a simulation with walls, a mesh, fields, a potential or a law, and if a particle spans
 *        more than 2²⁰ bins of a very skewed or small cell; #PW85_ENOMEM, or #PW85_ECONVERGENCE if
 *        particles block each other within rounding errors, or if the length is more than about
 *        10¹⁵ free paths: after both errors the last chain is not complete */
PW85_API int pw85_hard_ellipsoids_chain(pw85_hard_ellipsoids *simulation, size_t num_chains,
                                        double length, double const direction[3],
                                        double *compressibility);

/** Makes volume moves: trial changes of the cell and of all centres with it, at constant pressure.
 *
 * A trial multiplies the coordinates by a random matrix E, which is as probable as its inverse. If
 * there is no overlap afterwards, the trial is accepted with the probability min(1, (det E)^(N+1)
 * exp(-βP V (det E - 1) - βΔU)), where ΔU is the change of the energy in fields and potential. With
 * a pair potential, the probability has another factor min(1, e^(-βΔU')), where ΔU' is the change
 * of the pair energy. In two dimensions E changes only x and y, and V is the area.
 *
 * The probability density of the volume V of N particles is therefore proportional to V^N
 * exp(-βPV), times the probability that random configurations have no overlap. This holds for each
 * type of change, and types may be mixed. At given volume, the logarithms of the lengths and the
 * shears of the cell have uniform distributions. In a fluid nothing limits the shears.
 *
 * @param simulation a simulation with a cell that is periodic along its three vectors, in two
 *        dimensions along the first two
 * @param num_moves [number of trials]
 * @param pressure [1/length³] βP, > 0, in the inverse cube of the unit of length, in two dimensions
 *        in its inverse square; for #PW85_CHANGE_ASPECT any number
 * @param change #PW85_CHANGE_ISOTROPIC, #PW85_CHANGE_AXIS, #PW85_CHANGE_TRICLINIC or
 *        #PW85_CHANGE_ASPECT
 * @return #PW85_SUCCESS; #PW85_EINVAL, also with a mesh; #PW85_ENOMEM; #PW85_EPOTENTIAL as for
 *        pw85_hard_ellipsoids_set_potential() */
PW85_API int pw85_hard_ellipsoids_volume_moves(pw85_hard_ellipsoids *simulation, size_t num_moves,
                                               double pressure, int change);

/** @} */

/** @name Steps and counts of trials
 * @{ */

/** Makes sweeps, and adjusts the step sizes after each sweep towards an acceptance ratio. The
 * function sets all counts to zero at the end.
 *
 * Use it only to equilibrate: detailed balance does not hold while the step sizes change.
 * Translations become at most half as long as the longest semi-axis, which keeps the Verlet lists
 * short. They become longer only if particles are far apart.
 *
 * @param simulation a simulation
 * @param num_sweeps number of sweeps
 * @param acceptance [> 0; <= 1] the target of the acceptance ratio
 * @param pressure [>= 0] βP as for pw85_hard_ellipsoids_volume_moves(), for one volume move after
 *        each sweep; 0 for no volume moves, except for #PW85_CHANGE_ASPECT
 * @param change [as pw85_hard_ellipsoids_volume_moves()]
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOMEM; #PW85_EPOTENTIAL as for
 *        pw85_hard_ellipsoids_set_potential() */
PW85_API int pw85_hard_ellipsoids_tune(pw85_hard_ellipsoids *simulation, size_t num_sweeps,
                                       double acceptance, double pressure, int change);

/** Sets which fractions of the trials of a sweep are translations, rotations, both at once, and
 * exchanges.
 *
 * @param simulation a simulation
 * @param fractions [>= 0] they are divided by their sum, which must be positive
 * @return #PW85_SUCCESS, #PW85_EINVAL */
PW85_API int pw85_hard_ellipsoids_set_fractions(pw85_hard_ellipsoids *simulation,
                                                double const fractions[4]);

/** Sets the step sizes: the largest changes of a trial.
 *
 * The neighbour lists reach three times as far as a translation, so their memory grows with the
 * third power of the largest translation. If the cell becomes smaller, translations are limited to
 * its longest vector.
 *
 * @param simulation a simulation
 * @param steps [> 0] three numbers: the length of a translation; the tangent of half of the angle
 *        of a rotation, at most 1; the relative change of a length of the cell or the shear, at
 *        most 1. In a cell that is periodic along its three vectors, or in two dimensions along the
 *        first two, a translation is at most as long as the longest vector.
 * @return #PW85_SUCCESS, #PW85_EINVAL */
PW85_API int pw85_hard_ellipsoids_set_steps(pw85_hard_ellipsoids *simulation,
                                            double const steps[3]);

/** Returns the step sizes: the largest changes of a trial.
 *
 * @param simulation a simulation
 * @param[out] steps [as pw85_hard_ellipsoids_set_steps()]
 * @return #PW85_SUCCESS, #PW85_EINVAL */
PW85_API int pw85_hard_ellipsoids_steps(pw85_hard_ellipsoids const *simulation, double steps[3]);

/** Sets the largest translations and rotations of some species, and removes all step sizes of
 * species that were set before. A species is all particles with the same semi-axes.
 *
 * Other particles have the step sizes of pw85_hard_ellipsoids_set_steps().
 * pw85_hard_ellipsoids_tune() tunes the step sizes of each species by its own trials. The step
 * sizes are a part of the state that pw85_hard_ellipsoids_save() writes.
 *
 * @param simulation a simulation
 * @param num_kinds number of species, at most 16; 0 for none
 * @param semi_axes [num_kinds×3; length] those of each species, all different
 * @param steps [num_kinds×2; > 0] translation and rotation, as for pw85_hard_ellipsoids_set_steps()
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOMEM. Nothing changes on error */
PW85_API int pw85_hard_ellipsoids_set_kind_steps(pw85_hard_ellipsoids *simulation, size_t num_kinds,
                                                 double const *semi_axes, double const *steps);

/** Returns the largest translations and rotations of some species, which are particles with the
 * same semi-axes.
 *
 * @param simulation a simulation
 * @param num_kinds number of species
 * @param semi_axes [num_kinds×3; length] those of each species
 * @param[out] steps [num_kinds×2; NaN on error] largest translation and rotation of each species;
 *        those of pw85_hard_ellipsoids_steps() for a species without its own step sizes
 * @return #PW85_SUCCESS, #PW85_EINVAL */
PW85_API int pw85_hard_ellipsoids_kind_steps(pw85_hard_ellipsoids const *simulation,
                                             size_t num_kinds, double const *semi_axes,
                                             double *steps);

/** Returns the numbers of trials since the simulation was made or tuned: translations, rotations,
 * both at once, exchanges, volume moves.
 *
 * @param simulation a simulation
 * @param[out] trials [optional; -1 on error] number of trials
 * @param[out] accepted [optional; -1 on error] number of accepted trials
 * @return #PW85_SUCCESS, #PW85_EINVAL */
PW85_API int pw85_hard_ellipsoids_counts(pw85_hard_ellipsoids const *simulation, int64_t trials[5],
                                         int64_t accepted[5]);

/** @} */

#ifdef __cplusplus
}
#endif

#endif
