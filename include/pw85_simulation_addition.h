/* SPDX-License-Identifier: BSD-3-Clause */
/** @file pw85_simulation_addition.h
 * @brief Random sequential addition of ellipses and ellipsoids in a periodic cell.
 * pw85_simulation.h includes this header and has the conventions.
 */
#ifndef PW85_SIMULATION_ADDITION_H_INCLUDED
#define PW85_SIMULATION_ADDITION_H_INCLUDED

#include <pw85_systems.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @name Random sequential addition
 * @{ */

/** A random sequential addition: the particles that were added one after the other, and the
 * positions that may still be free. The library owns the object. Only one thread at a time may use
 * it; pw85_random_addition_advance() itself runs in parallel. */
typedef struct pw85_random_addition pw85_random_addition;

/** The addition can continue. */
#define PW85_ADDITION_CONTINUES 0

/** The packing is saturated: no position and no orientation is left for another particle. */
#define PW85_ADDITION_SATURATED 1

/** The addition has the required number of attempts. */
#define PW85_ADDITION_ATTEMPTS 2

/** The addition has the required number of particles. */
#define PW85_ADDITION_PARTICLES 3

/** Makes an empty periodic cell for random sequential addition (RSA).
 *
 * An attempt draws a species, a position and an orientation, each uniformly. The particle is added
 * if it overlaps no particle that was added before, by the exact overlap test. Added particles
 * never move. The seed and the number of the attempt select the random numbers, as for a
 * simulation. The same calls therefore give bitwise equal packings, with any number of threads, and
 * with lengths in any unit that is a power of two. If an addition stops at a limit and is then
 * continued, the packing is the same as without this limit.
 *
 * In two dimensions the particles are ellipses in the plane of x and y, which rotate about z.
 *
 * @param dimensions 2 or 3
 * @param cell [3×3; length] vectors of the cell as rows, all of them periodic, in two dimensions
 *        the first two. Opposite faces must be farther apart than 1 + 10⁻⁹ times the longest
 *        diameter of a particle. No coordinate may be larger than 2²⁵⁰ times the longest semi-axis.
 *        In two dimensions x and y of the third vector and z of the others must be 0
 * @param num_kinds [number of kinds] from 1 to 2³¹ - 1. An attempt chooses each with the same
 *        probability
 * @param semi_axes [num_kinds×3; length; > 0] none shorter than 2⁻⁴⁸⁰ times the longest one; in two
 *        dimensions the function does not use the third
 * @param seed selects the random numbers
 * @param[out] addition [null on error] the addition; free it by pw85_random_addition_destroy()
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOMEM; #PW85_ENOTPD if rounding could make the form
 *        of a species indefinite: its longest semi-axis is 2²³ times its shortest one or longer */
PW85_API int pw85_random_addition_create(int dimensions, double const cell[9], size_t num_kinds,
                                         double const *semi_axes, size_t seed,
                                         pw85_random_addition **addition);

/** Makes some attempts, at least one unless the addition is at its end. A call takes a fraction of
 * a second, so a program can show progress and stop between calls.
 *
 * Nearly all late attempts fail. Therefore the function keeps a list of voxels: small boxes of
 * positions and, in two dimensions, of angles, which together contain all free positions. It draws
 * attempts only inside the voxels. Attempts outside would fail; the function does not make them,
 * and counts their mean number. It removes a voxel if one particle overlaps every particle that
 * could be put there, and divides the other voxels again and again. The packing is saturated if no
 * voxel is left (Zhang, Phys. Rev. E 97, 043311, 2018). Voxels that are left after 30 halvings
 * count as covered, too. Ellipses and balls reach this end. Voxels of other ellipsoids contain
 * positions only, so that attempts or particles must be limited.
 *
 * The last call may exceed the given number of attempts, because one attempt inside a voxel counts
 * as several. No call exceeds the given number of particles.
 *
 * @param addition a random sequential addition
 * @param attempts [> 0; or infinite] number of attempts, of all calls together, at which to end
 * @param num_particles number of particles at which to end, from 1 to 2³¹ - 1
 * @param[out] end [-1 on error] #PW85_ADDITION_CONTINUES, or else why the addition is at its end:
 *        #PW85_ADDITION_SATURATED, #PW85_ADDITION_ATTEMPTS or #PW85_ADDITION_PARTICLES, the first
 *        of these that holds
 * @return #PW85_SUCCESS, #PW85_EINVAL; #PW85_ENOMEM, after which another call may continue */
PW85_API int pw85_random_addition_advance(pw85_random_addition *addition, double attempts,
                                          size_t num_particles, int *end);

/** Returns the progress of an addition.
 *
 * @param addition a random sequential addition
 * @param[out] num_particles [0 on error] number of particles that were added
 * @param[out] attempts [NaN on error] number of attempts. It includes the mean number of attempts
 *        at positions that are certainly covered, which are not made
 * @param[out] free_share [NaN on error] fraction of all species, positions and orientations that
 *        may still be free: 1 before there are voxels, then the fraction that is in voxels
 * @return #PW85_SUCCESS, #PW85_EINVAL */
PW85_API int pw85_random_addition_state(pw85_random_addition const *addition, size_t *num_particles,
                                        double *attempts, double *free_share);

/** Copies the particles of an addition, in the order in which they were added.
 *
 * @param addition a random sequential addition
 * @param num_particles number of particles, as pw85_random_addition_state() returns it
 * @param[out] centers [num_particles×3; length] inside the cell; in two dimensions z is 0
 * @param[out] quaternions [num_particles×4; optional] (w, x, y, z) of length one; in two dimensions
 *        x and y are 0
 * @param[out] kinds [num_particles; optional] index of the species, from 0
 * @return #PW85_SUCCESS; #PW85_EINVAL, also if the number of particles is another one. Nothing is
 *        written on error */
PW85_API int pw85_random_addition_particles(pw85_random_addition const *addition,
                                            size_t num_particles, double *centers,
                                            double *quaternions, int32_t *kinds);

/** Frees a random sequential addition.
 *
 * @param addition [optional] a random sequential addition */
PW85_API void pw85_random_addition_destroy(pw85_random_addition *addition);

/** @} */

#ifdef __cplusplus
}
#endif

#endif
