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

/** Scales the cell in all directions alike. */
#define PW85_CHANGE_ISOTROPIC 0

/** Scales the cell along x, y or z, chosen at random; in two dimensions along x or y. */
#define PW85_CHANGE_AXIS 1

/** Scales the cell along x, y or z, or shears it, chosen at random. A shear adds a multiple of a
 * later coordinate to an earlier one; in two dimensions, of y to x. A cell whose vectors are a
 * lower triangular matrix therefore stays one. */
#define PW85_CHANGE_TRICLINIC 2

/** Scales the cell along x, y or z, chosen at random, and along the two other directions such that
 * the volume stays the same up to rounding errors; in two dimensions along x and y, at constant
 * area. The function does not read the pressure. */
#define PW85_CHANGE_ASPECT 3

/** Makes sweeps. A sweep has as many trials as there are particles.
 *
 * The cell is divided into domains, with a random origin for each sweep. Threads work on domains
 * that are not neighbours at the same time: all domains of one colour, then those of another, in
 * random order. A domain gets as many trials as it has particles, each of a random particle of the
 * domain. A trial that leaves its domain is rejected. The division therefore does not change during
 * a sweep, and a trial and its reverse have the same proposal probability: a sweep is in detailed
 * balance.
 *
 * A translation is by a random point of a ball. A rotation multiplies the quaternion from the left
 * by (1, v), with a random point v of a ball. An exchange swaps the semi-axes of two particles of a
 * domain. In two dimensions a translation is a random vector in a disc, and a rotation about z
 * multiplies by (1, 0, 0, v), with v uniform in an interval around 0: rotations by an angle and by
 * its negative are equally probable.
 *
 * @param simulation a simulation
 * @param num_sweeps how many
 * @return #PW85_SUCCESS, #PW85_EINVAL; #PW85_ENOMEM, after which the last sweep is not complete;
 *        #PW85_EPOTENTIAL as for pw85_hard_ellipsoids_set_potential() */
PW85_API int pw85_hard_ellipsoids_sweep(pw85_hard_ellipsoids *simulation, size_t num_sweeps);

/** Makes event chains, which translate many particles at once and give the pressure.
 *
 * In a chain a random particle moves along a direction until it touches another one. This one then
 * moves along the same direction until it touches a third, and so on. The chain ends when the sum
 * of the distances that its particles have moved is its length. No chain leads to an overlap:
 * pw85_free_path() gives the distances, and the exact overlap test checks each position. Chains do
 * not rotate particles: use also sweeps of rotations.
 *
 * Chains along random directions are in detailed balance. Chains along one direction keep the
 * uniform distribution, without detailed balance, but do not change the coordinates across it. Let
 * x be the coordinate along the direction of the particle that moves; it jumps at each contact.
 * βP/ρ along the direction is the mean of (x_last - x_first)/length over chains (Michel, Kapfer and
 * Krauth 2014). To estimate its error, make blocks of chains.
 *
 * @param simulation a simulation
 * @param num_chains how many
 * @param length [length; > 0] of each chain, in the unit of length. For comparison, the mean
 *        distance between contacts times the number of particles is a long chain
 * @param direction [optional; != 0] of any length, in two dimensions without z; or null for a
 *        random direction of each chain, isotropic
 * @param[out] compressibility [optional; NaN on error] βP/ρ along the directions, by these chains.
 *        NaN without chains or particles. NaN also if the shortest vector of the lattice is at most
 *        twice the longest semi-axis: a particle could then touch its own image if it turned. Such
 *        contacts contribute to the pressure, but chains do not find them, because images move with
 *        their particle
 * @return #PW85_SUCCESS; #PW85_EINVAL, also for a direction out of the plane, with walls, a mesh,
 *        fields, a potential or a law, and if a particle spans more than 2²⁰ bins of a cell that is
 *        very skewed or small; #PW85_ENOMEM, or #PW85_ECONVERGENCE if particles block each other
 *        within rounding errors, or if the length is more than some 10¹⁵ distances between
 *        contacts: after both the last chain is not complete */
PW85_API int pw85_hard_ellipsoids_chain(pw85_hard_ellipsoids *simulation, size_t num_chains,
                                        double length, double const direction[3],
                                        double *compressibility);

/** Tries changes of the cell, and of all centres with it, at constant pressure.
 *
 * A trial multiplies the coordinates by a random matrix E, which is as probable as its inverse. If
 * there is no overlap afterwards, the trial is accepted with the probability min(1, (det E)^(N+1)
 * exp(-βP V (det E - 1))). The exponent also has minus the change of βU of a potential. With a law
 * of pairs, the probability has the factor min(1, e^(-βΔU)), where ΔU is the change of the energy
 * of pairs. In two dimensions E changes only x and y, and V is the area.
 *
 * The density of the volumes of N particles is therefore that of V^N exp(-βPV) for each type of
 * change, and types may be mixed. At given volume, the logarithmic lengths and the shears of the
 * cell are distributed uniformly. A fluid does not limit the shears.
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

/** Makes sweeps, and changes the steps after each of them towards an acceptance ratio. It sets all
 * counts to zero at the end.
 *
 * Use it only to equilibrate: trials are not in detailed balance while the steps change.
 * Translations become at most half as long as the longest semi-axis, which keeps the Verlet lists
 * short. They become longer only where particles are far apart.
 *
 * @param simulation a simulation
 * @param num_sweeps how many
 * @param acceptance [> 0; <= 1] the target of the acceptance ratio
 * @param pressure [>= 0] βP as for pw85_hard_ellipsoids_volume_moves(), for one trial of the volume
 *        after each sweep; 0 for none, except for #PW85_CHANGE_ASPECT
 * @param change [as pw85_hard_ellipsoids_volume_moves()]
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOMEM; #PW85_EPOTENTIAL as for
 *        pw85_hard_ellipsoids_set_potential() */
PW85_API int pw85_hard_ellipsoids_tune(pw85_hard_ellipsoids *simulation, size_t num_sweeps,
                                       double acceptance, double pressure, int change);

/** Sets the fractions of the trials of a sweep that are translations, rotations, both at once, and
 * exchanges.
 *
 * @param simulation a simulation
 * @param fractions [>= 0] they are divided by their sum, which must be positive
 * @return #PW85_SUCCESS, #PW85_EINVAL */
PW85_API int pw85_hard_ellipsoids_set_fractions(pw85_hard_ellipsoids *simulation,
                                                double const fractions[4]);

/** Sets the largest changes of a trial.
 *
 * The neighbour lists reach three times as far as a translation, so their memory grows with its
 * third power. In a cell that becomes smaller, translations are shortened to its longest vector.
 *
 * @param simulation a simulation
 * @param steps [> 0] three numbers: the length of a translation; the tangent of half of the angle
 *        of a rotation, at most 1; the relative change of a length of the cell or the shear, at
 *        most 1. In a cell that is periodic along its three vectors, or in two dimensions along the
 *        first two, a translation is at most as long as the longest vector.
 * @return #PW85_SUCCESS, #PW85_EINVAL */
PW85_API int pw85_hard_ellipsoids_set_steps(pw85_hard_ellipsoids *simulation,
                                            double const steps[3]);

/** Returns the largest changes of a trial.
 *
 * @param simulation a simulation
 * @param[out] steps [as pw85_hard_ellipsoids_set_steps()]
 * @return #PW85_SUCCESS, #PW85_EINVAL */
PW85_API int pw85_hard_ellipsoids_steps(pw85_hard_ellipsoids const *simulation, double steps[3]);

/** Sets the largest translations and rotations of some species, in place of all steps of species
 * set before. A species is all particles with the same semi-axes.
 *
 * Other particles have the steps of pw85_hard_ellipsoids_set_steps(). pw85_hard_ellipsoids_tune()
 * tunes the steps of each species by its own trials. They are a part of the state that
 * pw85_hard_ellipsoids_save() writes.
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
 * @param[out] steps [num_kinds×2; NaN on error] translation and rotation of each species; those of
 *        pw85_hard_ellipsoids_steps() for a species without its own
 * @return #PW85_SUCCESS, #PW85_EINVAL */
PW85_API int pw85_hard_ellipsoids_kind_steps(pw85_hard_ellipsoids const *simulation,
                                             size_t num_kinds, double const *semi_axes,
                                             double *steps);

/** Returns the numbers of trials since the simulation was made or tuned: translations, rotations,
 * both at once, exchanges, volume.
 *
 * @param simulation a simulation
 * @param[out] trials [optional; -1 on error] how many there were
 * @param[out] accepted [optional; -1 on error] how many of them were accepted
 * @return #PW85_SUCCESS, #PW85_EINVAL */
PW85_API int pw85_hard_ellipsoids_counts(pw85_hard_ellipsoids const *simulation, int64_t trials[5],
                                         int64_t accepted[5]);

/** @} */

#ifdef __cplusplus
}
#endif

#endif
