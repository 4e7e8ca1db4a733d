/* SPDX-License-Identifier: BSD-3-Clause */
/** @file pw85_simulation_insertions.h
 * @brief Single particles of a simulation: tests of other positions, insertions and removals.
 * pw85_simulation.h includes this header and has the conventions.
 */
#ifndef PW85_SIMULATION_INSERTIONS_H_INCLUDED
#define PW85_SIMULATION_INSERTIONS_H_INCLUDED

#include <pw85_simulation_state.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @name Insertions, removals and tests of positions
 * @{ */

/** Tests whether a particle would have no overlaps at another position, and on request moves it
 * there.
 *
 * The test is exact. It includes all images, also those of the particle itself. A position is not
 * free either if a wall cuts the particle there, or if the potential is infinite there. Counts and
 * random numbers do not change. For a position near the present one, the call takes about as long
 * as a trial of a sweep. For any other position, the function makes a new neighbour list.
 *
 * @param simulation a simulation
 * @param particle index, from 0
 * @param center [length; optional] new centre, anywhere in the cell or its images, or null for the
 *        present one
 * @param quaternion [optional; != 0] new orientation (w, x, y, z), of any length, or null for the
 *        present one
 * @param take not 0 to move the particle there if the position is free
 * @param[out] is_free [-1 on error] 1 or 0
 * @return #PW85_SUCCESS; #PW85_EINVAL, also for a free position that is too far away for
 *        pw85_neighbors_create(), and in two dimensions for a position out of the plane: another z,
 *        or x or y of the quaternion not 0; #PW85_ENOTPD; #PW85_ENOMEM; #PW85_EPOTENTIAL if the
 *        potential returns NaN there */
PW85_API int pw85_hard_ellipsoids_try(pw85_hard_ellipsoids *simulation, size_t particle,
                                      double const center[3], double const quaternion[4], int take,
                                      int *is_free);

/** Tests whether a new particle would have no overlaps, and on request inserts it as the last
 * particle.
 *
 * The test is exact. It includes walls and the images of the particle itself. A position that the
 * potential forbids is not free. The time is proportional to the number of particles.
 *
 * Pointers that pw85_hard_ellipsoids_system() and similar functions returned before remain readable
 * until the simulation is destroyed. Their arrays have the old number of particles, and no longer
 * show the present state.
 *
 * @param simulation a simulation
 * @param center [length] anywhere in the cell or its images
 * @param quaternion [!= 0] (w, x, y, z), of any length
 * @param semi_axes [length; > 0] lengths of the principal semi-axes, as for
 *        pw85_hard_ellipsoids_insertion_weight()
 * @param take not 0 to insert the particle if it is free
 * @param[out] is_free [-1 on error] 1 or 0
 * @return #PW85_SUCCESS; #PW85_EINVAL, also for a centre that is too far away for
 *        pw85_neighbors_create(), and in two dimensions for a position out of the plane;
 *        #PW85_ENOTPD; #PW85_ENOMEM, also for more than 2³¹ - 1 particles; #PW85_EPOTENTIAL if the
 *        potential returns NaN there, or that of a restored simulation is not set. Nothing changes
 *        on error */
PW85_API int pw85_hard_ellipsoids_insert(pw85_hard_ellipsoids *simulation, double const center[3],
                                         double const quaternion[4], double const semi_axes[3],
                                         int take, int *is_free);

/** Removes a particle. The last particle takes over its index. Pointers returned before remain
 * readable as after pw85_hard_ellipsoids_insert().
 *
 * @param simulation a simulation
 * @param particle index, from 0
 * @return #PW85_SUCCESS; #PW85_EINVAL, also if there is no such particle; #PW85_EPOTENTIAL if the
 *        potential of a restored simulation is not set, because the energy would change */
PW85_API int pw85_hard_ellipsoids_remove(pw85_hard_ellipsoids *simulation, size_t particle);

/** Computes the mean of e^(-βU) over trial insertions of a particle at random positions (Widom's
 * method). A position that is not free counts as 0. The particles of the simulation do not change.
 *
 * U is the energy of the particle in fields and potential. With a law, U includes the energies of
 * the pairs with all other particles and with its own images. Positions are uniform in the cell,
 * and orientations are uniform. The function also reads the vectors of the cell that are not
 * periodic: a corner of the cell is at the origin, and walls may be within the cell.
 *
 * Let w be the mean over many states, and ρ the number density of this species in the inverse cube
 * of the unit of length. Then βμ = ln ρ - ln w gives the chemical potential μ of the species. To
 * estimate the error of w, average w over blocks of states.
 *
 * @param simulation a simulation with a cell, whose three vectors are independent, in two
 *        dimensions the first two
 * @param num_trials number of insertions
 * @param semi_axes [length; > 0] of the particle; at most 32 times the shortest vector of the
 *        lattice of images; with a law, the semi-axes of all particles times √c must not exceed
 *        this limit, where c is the cutoff of μ²
 * @param[out] weight [NaN on error] the mean; without fields, potential and law the fraction of the
 *        positions that are free; NaN without trials
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ENOMEM; #PW85_EPOTENTIAL as for
 *        pw85_hard_ellipsoids_set_potential() */
PW85_API int pw85_hard_ellipsoids_insertion_weight(pw85_hard_ellipsoids *simulation,
                                                   size_t num_trials, double const semi_axes[3],
                                                   double *weight);

/** Makes trial insertions and removals of particles at constant activities. Together with sweeps,
 * which move the particles, these trials sample the grand canonical ensemble.
 *
 * Each trial is an insertion or a removal of a particle of one of the species, all equally
 * probable. A particle belongs to the species that has its semi-axes. Particles of other species
 * stay, and so do particles outside the cell along vectors that are not periodic.
 *
 * An insertion is at a random position with a random orientation. If the particle is free, it is
 * accepted with the probability min(1, z V/(N + 1) e^(-βU)). A removal of a random particle of the
 * species is accepted with the probability min(1, N/(z V) e^(βU)). Here N is the number of
 * particles of the species. In two dimensions V is the area. An ideal gas therefore has the density
 * z of each species, and Poisson distributions of the numbers of particles.
 *
 * Here a potential must not depend on the index of a particle, because removals change indices.
 * Pointers returned before remain readable as after pw85_hard_ellipsoids_insert().
 *
 * @param simulation a simulation with a cell, whose three vectors are independent, in two
 *        dimensions the first two
 * @param num_moves number of trials
 * @param num_kinds number of species, at least 1
 * @param semi_axes [num_kinds×3; length; > 0] semi-axes of each species, all different, as for
 *        pw85_hard_ellipsoids_insertion_weight()
 * @param activities [num_kinds; 1/length³; > 0] z = e^(βμ)/Λ³ of each species, in the inverse cube
 *        of the unit of length, in two dimensions in its inverse square
 * @param[out] counts [optional; -1 on error] four numbers of this call: insertions, accepted
 *        insertions, removals, accepted removals; -1 if it is refused before the first trial
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD; #PW85_ENOMEM, or #PW85_EPOTENTIAL as for
 *        pw85_hard_ellipsoids_set_potential(), the trials that were made before the error remain */
PW85_API int pw85_hard_ellipsoids_insertion_moves(pw85_hard_ellipsoids *simulation,
                                                  size_t num_moves, size_t num_kinds,
                                                  double const *semi_axes, double const *activities,
                                                  int64_t counts[4]);

/** @} */

#ifdef __cplusplus
}
#endif

#endif
