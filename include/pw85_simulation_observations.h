/* SPDX-License-Identifier: BSD-3-Clause */
/** @file pw85_simulation_observations.h
 * @brief Observations of a simulation: energies, neighbours, overlaps, and the largest compression
 * without overlaps. pw85_simulation.h includes this header and has the conventions.
 */
#ifndef PW85_SIMULATION_OBSERVATIONS_H_INCLUDED
#define PW85_SIMULATION_OBSERVATIONS_H_INCLUDED

#include <pw85_simulation_state.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @name Observations of a simulation
 * @{ */

/** Computes the sum of the energies of all particles in the fields and the potential, and of all
 * pairs by the law, in units of k_B T.
 *
 * @param simulation a simulation
 * @param[out] energy [NaN on error] the sum, in the order of the particles and then of the pairs; 0
 *        without fields, potential and law
 * @return #PW85_SUCCESS, #PW85_EINVAL; #PW85_EPOTENTIAL if the potential of a restored simulation
 *        is not set, or if it returns NaN; #PW85_ENOMEM, with a law */
PW85_API int pw85_hard_ellipsoids_energy(pw85_hard_ellipsoids const *simulation, double *energy);

/** Computes the virial of the pair potential, W = -2 Σ μ² dβU/dμ², which adds to the pressure of
 * the hard cores.
 *
 * If the cell and all centres grow by the factor 1 + ε, μ² of each pair grows by (1 + ε)², and βU
 * of all pairs by -ε W. In d dimensions therefore βPV = N + (n'(0) + W)/d, where n(ε) is the mean
 * number of pairs with μ < 1 + ε in a system with the law. At constant pressure P, the mean of the
 * right-hand side equals the mean of βPV.
 *
 * @param simulation a simulation
 * @param[out] virial [NaN on error] the sum over all pairs and images, in units of k_B T; 0 without
 *        a law
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOMEM */
PW85_API int pw85_hard_ellipsoids_law_virial(pw85_hard_ellipsoids const *simulation,
                                             double *virial);

/** Lists the images of particles whose bounding boxes intersect that of a given particle. The list
 * contains all images that this particle may touch or overlap.
 *
 * The order is by index, then by image. Order and numbers depend only on the present state.
 *
 * @param simulation a simulation
 * @param particle index, from 0
 * @param capacity number of images for which the arrays have space; with 0 the function only counts
 * @param[out] count [0 on error] number of images, which may be more than `capacity`
 * @param[out] particles [capacity; optional] index of each image; the function writes the first
 *        `count` rows of this array and of the next two, as far as `capacity` allows
 * @param[out] images [capacity×3; optional] multiples of the vectors of the cell, to be added to
 *        the centre of that particle
 * @param[out] separations [capacity×3; length; optional] from the centre of the given particle to
 *        that of the image
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOMEM */
PW85_API int pw85_hard_ellipsoids_neighbors(pw85_hard_ellipsoids *simulation, size_t particle,
                                            size_t capacity, size_t *count, int32_t *particles,
                                            int32_t *images, double *separations);

/** Searches all particles for overlaps. The search makes a new neighbour list.
 *
 * @param simulation a simulation
 * @param[out] pair [as pw85_hard_ellipsoids_create()] if a wall cuts a particle, the index of this
 *        particle, and -1
 * @return #PW85_SUCCESS if there is no overlap, #PW85_EOVERLAP, #PW85_EINVAL, #PW85_ENOMEM */
PW85_API int pw85_hard_ellipsoids_check(pw85_hard_ellipsoids const *simulation, int32_t pair[2]);

/** Computes the factor by which the cell and the centres can be compressed until particles touch,
 * and on request compresses them. The sizes of the particles do not change.
 *
 * The factor is the same in all directions, in two dimensions in the directions of the plane. It is
 * 1/μ for the least μ of all pairs, slightly enlarged because of rounding errors: after the
 * coordinates are multiplied by the factor and rounded, the exact test finds no overlap. A law does
 * not change the factor.
 *
 * @param simulation a simulation
 * @param take not 0 to multiply the cell and the centres by the factor
 * @param[out] factor [NaN on error] at most 1; if there are no pairs it is 0, and nothing is
 *        changed
 * @return #PW85_SUCCESS; #PW85_EINVAL, also if particles are too far apart for a neighbour list,
 *        and with walls, a mesh, fields or a potential; #PW85_ENOMEM */
PW85_API int pw85_hard_ellipsoids_compress(pw85_hard_ellipsoids *simulation, int take,
                                           double *factor);

/** @} */

#ifdef __cplusplus
}
#endif

#endif
