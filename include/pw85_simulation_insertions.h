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

/** @name Places, insertions and removals of particles
 * @{ */

/** Tests whether a particle would be free of overlaps at another position, and moves it there if
 * wanted.
 *
 * The test is exact. It includes all images, also those of the particle itself. A position at which
 * a wall cuts the particle, or which a potential forbids, is not free. Counts and random numbers do
 * not change. A position near the present one takes about as long as a trial of a sweep. Any other
 * position takes a new list of all neighbours.
 *
 * @param simulation a simulation
 * @param particle index, from 0
 * @param center [length; optional] new centre, anywhere in the cell or its images, or null for the
 *        present one
 * @param quaternion [optional; != 0] new orientation (w, x, y, z), of any length, or null for the
 *        present one
 * @param take not 0 to leave the particle there if it is free
 * @param[out] is_free [-1 on error] 1 or 0
 * @return #PW85_SUCCESS; #PW85_EINVAL, also for a free position that is too far away for
 *        pw85_neighbors_create(), and in two dimensions for one out of the plane: another z, or x
 *        or y of the quaternion not 0; #PW85_ENOTPD; #PW85_ENOMEM; #PW85_EPOTENTIAL if the
 *        potential returns NaN there */
PW85_API int pw85_hard_ellipsoids_try(pw85_hard_ellipsoids *simulation, size_t particle,
                                      double const center[3], double const quaternion[4], int take,
                                      int *is_free);

/** Tests whether a new particle would be free of overlaps, and inserts it as the last one if
 * wanted.
 *
 * The test is exact. It includes walls and the images of the particle itself. A position that the
 * potential forbids is not free. The time is proportional to the number of particles.
 *
 * Pointers that pw85_hard_ellipsoids_system() and similar functions returned before stay readable
 * as long as the simulation lives. They have the old number of particles, and no longer show the
 * present state.
 *
 * @param simulation a simulation
 * @param center [length] anywhere in the cell or its images
 * @param quaternion [!= 0] (w, x, y, z), of any length
 * @param semi_axes [length; > 0] lengths of the principal semi-axes, as for
 *        pw85_hard_ellipsoids_insertion_weight()
 * @param take not 0 to insert the particle if it is free
 * @param[out] is_free [-1 on error] 1 or 0
 * @return #PW85_SUCCESS; #PW85_EINVAL, also for a centre that is too far away for
 *        pw85_neighbors_create(), and in two dimensions for one out of the plane; #PW85_ENOTPD;
 *        #PW85_ENOMEM, also for more than 2³¹ - 1 particles; #PW85_EPOTENTIAL if the potential
 *        returns NaN there, or that of a restored simulation is not set. Nothing changes on
 *        error */
PW85_API int pw85_hard_ellipsoids_insert(pw85_hard_ellipsoids *simulation, double const center[3],
                                         double const quaternion[4], double const semi_axes[3],
                                         int take, int *is_free);

/** Removes a particle. The last particle gets its index. For older pointers see
 * pw85_hard_ellipsoids_insert().
 *
 * @param simulation a simulation
 * @param particle index, from 0
 * @return #PW85_SUCCESS; #PW85_EINVAL, also if there is no such particle; #PW85_EPOTENTIAL if the
 *        potential of a restored simulation is not set, because the energy would change */
PW85_API int pw85_hard_ellipsoids_remove(pw85_hard_ellipsoids *simulation, size_t particle);

/** Computes the mean of e^(-βU) of a particle that is inserted at random, where a position that is
 * not free counts as 0: Widom's insertions. The particles of the simulation do not change.
 *
 * U is the energy of the particle in fields and potential. With a law, it also has the energies of
 * its pairs with all others and with its own images. Position and orientation are uniform, the
 * position in the cell. The function reads also the vectors of the cell that are not periodic: the
 * cell begins at the origin, and walls may be within it.
 *
 * With the mean w over many states, βμ = ln ρ - ln w for another particle of this species, where ρ
 * is the density of the species in the inverse cube of the unit of length. To estimate the error of
 * w, make blocks of states.
 *
 * @param simulation a simulation with a cell, whose three vectors are independent, in two
 *        dimensions the first two
 * @param num_trials how many insertions
 * @param semi_axes [length; > 0] of the particle; at most 32 times the shortest vector of the
 *        lattice of images; with a law this holds for the semi-axes of all particles times √c,
 *        where c is the cutoff of μ²
 * @param[out] weight [NaN on error] the mean; without fields, potential and law the fraction of the
 *        positions that are free; NaN without trials
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ENOMEM; #PW85_EPOTENTIAL as for
 *        pw85_hard_ellipsoids_set_potential() */
PW85_API int pw85_hard_ellipsoids_insertion_weight(pw85_hard_ellipsoids *simulation,
                                                   size_t num_trials, double const semi_axes[3],
                                                   double *weight);

/** Tries insertions and removals of particles, at constant activities: the grand canonical
 * ensemble, if sweeps move the particles.
 *
 * Each trial is an insertion or a removal of a particle of one of the species, all equally
 * probable. A particle belongs to the species that has its semi-axes. Particles of other species
 * stay, and so do particles outside of the cell along vectors that are not periodic.
 *
 * An insertion is at a random position with a random orientation. If the particle is free, it is
 * accepted with the probability min(1, z V/(N + 1) e^(-βU)). A removal of a random particle of the
 * species is accepted with the probability min(1, N/(z V) e^(βU)). Here N is the number of
 * particles of the species. In two dimensions V is the area. An ideal gas therefore has the density
 * z of each species, and Poisson distributions of the numbers of particles.
 *
 * A potential must not depend on the index of a particle here, because removals change it. For
 * older pointers see pw85_hard_ellipsoids_insert().
 *
 * @param simulation a simulation with a cell, whose three vectors are independent, in two
 *        dimensions the first two
 * @param num_moves how many trials
 * @param num_kinds number of species, at least 1
 * @param semi_axes [num_kinds×3; length; > 0] those of each species, all different, as for
 *        pw85_hard_ellipsoids_insertion_weight()
 * @param activities [num_kinds; 1/length³; > 0] z = e^(βμ)/Λ³ of each species, in the inverse cube
 *        of the unit of length, in two dimensions in its inverse square
 * @param[out] counts [optional; -1 on error] four numbers of this call: insertions, accepted
 *        insertions, removals, accepted removals; -1 if it is refused before the first trial
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD; #PW85_ENOMEM, or #PW85_EPOTENTIAL as for
 *        pw85_hard_ellipsoids_set_potential(), after which the trials that were made before
 *        remain */
PW85_API int pw85_hard_ellipsoids_insertion_moves(pw85_hard_ellipsoids *simulation,
                                                  size_t num_moves, size_t num_kinds,
                                                  double const *semi_axes, double const *activities,
                                                  int64_t counts[4]);

/** @} */

#ifdef __cplusplus
}
#endif

#endif
