/* SPDX-License-Identifier: BSD-3-Clause */
/** @file pw85_simulation_state.h
 * @brief Simulations of hard ellipsoids: how to make and save them, and their particles.
 * pw85_simulation.h includes this header and has the conventions.
 */
#ifndef PW85_SIMULATION_STATE_H_INCLUDED
#define PW85_SIMULATION_STATE_H_INCLUDED

#include <pw85_systems.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @name Simulations
 * @{ */

/** A simulation. The library owns it. */
typedef struct pw85_hard_ellipsoids pw85_hard_ellipsoids;

/** Makes a simulation. The function copies the arrays.
 *
 * In a new simulation half of the trials are translations and half are rotations. The memory is
 * about 420 bytes per particle, 24 more with volume moves, and 8 for each neighbour of a particle.
 * While a neighbour list is made, each neighbour takes at least 10 more bytes.
 *
 * @param system [without q] at most 2³¹ - 1 particles as for pw85_neighbors_create(). The function
 *        does not read `q`, which may be null. The cell may be smaller than a particle, but a
 *        particle must not overlap its own images.
 * @param semi_axes [num_particles×3; length; > 0; finite square] lengths of the principal semi-axes
 *        of each particle, whose squares are in the range of double
 * @param quaternions [num_particles×4; != 0] (w, x, y, z), of any lengths
 * @param seed selects the random numbers
 * @param[out] pair [optional; -1 on error] the first two particles that overlap; twice the same
 *        index if a particle overlaps its own image; -1 if no particles overlap
 * @param[out] simulation [null on error] the simulation; free it by pw85_hard_ellipsoids_destroy()
 * @return #PW85_SUCCESS; #PW85_EOVERLAP if particles overlap; #PW85_EINVAL and #PW85_ENOTPD as for
 *        pw85_neighbors_create(); #PW85_ENOMEM, also if particles are so long that a neighbour list
 *        has more than 2¹⁵ images of the cell, or 2¹³ pairs per particle */
PW85_API int pw85_hard_ellipsoids_create(pw85_system const *system, double const *semi_axes,
                                         double const *quaternions, size_t seed, int32_t pair[2],
                                         pw85_hard_ellipsoids **simulation);

/** Sets the number of dimensions of a simulation: 2 for hard ellipses in a plane z = const, or 3
 * for ellipsoids, as in a new simulation.
 *
 * In two dimensions the ellipses are the sections of the ellipsoids with the plane. Two ellipses
 * overlap if and only if the ellipsoids overlap, whatever the third semi-axes are. Translations are
 * vectors in a disc, rotations are about z, and areas replace volumes. No function changes z of the
 * centres and of the cell vectors, or x and y of the quaternions. If the cell is periodic along
 * both of its vectors, the largest translation of a trial (pw85_hard_ellipsoids_set_steps())
 * becomes at most the length of the longest one.
 *
 * @param simulation a simulation
 * @param dimensions 2 or 3
 * @return #PW85_SUCCESS; #PW85_EINVAL for other numbers, and for 2 in three cases: centres have
 *        different z, or x or y of a quaternion is not 0; there is a cell, and its first two
 *        vectors have a component along z, or the third one is not along z, or is periodic; there
 *        are walls or a mesh that such a simulation cannot have. Nothing changes on error */
PW85_API int pw85_hard_ellipsoids_set_dimensions(pw85_hard_ellipsoids *simulation, int dimensions);

/** Returns the number of dimensions of a simulation.
 *
 * @param simulation a simulation
 * @param[out] dimensions [-1 on error] 2 or 3
 * @return #PW85_SUCCESS, #PW85_EINVAL */
PW85_API int pw85_hard_ellipsoids_dimensions(pw85_hard_ellipsoids const *simulation,
                                             int *dimensions);

/** Frees a simulation.
 *
 * @param simulation [optional] a simulation */
PW85_API void pw85_hard_ellipsoids_destroy(pw85_hard_ellipsoids *simulation);

/** @} */

/** @name Particles of a simulation
 * @{ */

/** Returns the particles and the cell: pointers to the arrays of the simulation.
 *
 * The pointers are valid until the simulation is destroyed. The arrays contain the present state,
 * until particles are inserted or removed. Centres are not wrapped into the cell.
 *
 * @param simulation [optional] a simulation
 * @return the system; it has no particles if `simulation` is null */
PW85_API pw85_system pw85_hard_ellipsoids_system(pw85_hard_ellipsoids const *simulation);

/** Returns the orientations, num_particles×4. The pointer is valid as for
 * pw85_hard_ellipsoids_system().
 *
 * @param simulation [optional] a simulation
 * @return quaternions (w, x, y, z) of length one; null if `simulation` is null */
PW85_API double const *pw85_hard_ellipsoids_quaternions(pw85_hard_ellipsoids const *simulation);

/** Returns the semi-axes, num_particles×3. The pointer is valid as for
 * pw85_hard_ellipsoids_system().
 *
 * @param simulation [optional] a simulation
 * @return the lengths; null if `simulation` is null */
PW85_API double const *pw85_hard_ellipsoids_semi_axes(pw85_hard_ellipsoids const *simulation);

/** @} */

/** @name Saved simulations
 * @{ */

/** Returns the number of bytes that pw85_hard_ellipsoids_save() writes.
 *
 * @param simulation [optional] a simulation
 * @return the number; 0 if `simulation` is null */
PW85_API size_t pw85_hard_ellipsoids_num_bytes(pw85_hard_ellipsoids const *simulation);

/** Writes the whole state of a simulation as bytes: 80 bytes for each particle, and a few hundred
 * more.
 *
 * The format is the same on every machine, and has a checksum: see the chapter on Monte Carlo. The
 * bytes contain the energy in the caller's potential, but not the potential function.
 *
 * @param simulation a simulation
 * @param num_bytes pw85_hard_ellipsoids_num_bytes()
 * @param[out] bytes [num_bytes]
 * @return #PW85_SUCCESS, #PW85_EINVAL; #PW85_EPOTENTIAL, with nothing written, if the energy in the
 *        caller's potential is not finite */
PW85_API int pw85_hard_ellipsoids_save(pw85_hard_ellipsoids const *simulation, size_t num_bytes,
                                       unsigned char *bytes);

/** Makes a simulation from the bytes of a saved one. The new simulation continues the saved one
 * with bitwise equal results. The bytes may come from another machine, or from version 3.1 or any
 * later version up to this one.
 *
 * @param num_bytes [number of bytes]
 * @param bytes [num_bytes]
 * @param[out] simulation [null on error] the simulation; free it by pw85_hard_ellipsoids_destroy()
 * @return #PW85_SUCCESS; #PW85_EINVAL, also if the bytes are incomplete, have been changed, have a
 *        later format, or come from a version before 3.1; #PW85_EINVAL, #PW85_EOVERLAP,
 *        #PW85_ENOTPD, #PW85_EPOTENTIAL if they describe an invalid state; #PW85_ENOMEM */
PW85_API int pw85_hard_ellipsoids_restore(size_t num_bytes, unsigned char const *bytes,
                                          pw85_hard_ellipsoids **simulation);

/** @} */

#ifdef __cplusplus
}
#endif

#endif
