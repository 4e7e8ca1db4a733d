/* SPDX-License-Identifier: BSD-3-Clause */
/** @file pw85_simulation_state.h
 * @brief Simulations of hard ellipsoids: how they are made and saved, and their particles. A part
 * of pw85_simulation.h, which includes it and has the conventions.
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

/** Makes a simulation. The arrays are copied.
 *
 * In a new simulation half of the trials are translations and half are rotations. The memory is
 * some 420 bytes per particle, 24 more with trials of the volume, and 8 for each of its neighbours.
 * While neighbours are listed, there are at least 10 more for each of them.
 *
 * @param system [without q] at most 2³¹ - 1 particles as for pw85_neighbors_create(); `q` may be
 *        null, it is not read. The cell may be smaller than a particle, whose images must not
 *        overlap either.
 * @param semi_axes [num_particles×3; length; > 0; finite square] lengths of the principal semi-axes
 *        of each particle, whose squares are in the range of double
 * @param quaternions [num_particles×4; != 0] (w, x, y, z), of any lengths
 * @param seed selects the random numbers
 * @param[out] pair [optional; -1 on error] the first two particles that overlap, the same for a
 *        particle and its own image; -1 if no particles overlap
 * @param[out] simulation [null on error] to be destroyed by pw85_hard_ellipsoids_destroy()
 * @return #PW85_SUCCESS; #PW85_EOVERLAP if particles overlap; #PW85_EINVAL and #PW85_ENOTPD as
 *        for pw85_neighbors_create(); #PW85_ENOMEM, also for particles so long that a list of
 *        neighbours has more than 2¹⁵ images of the cell, or 2¹³ pairs per particle */
PW85_API int pw85_hard_ellipsoids_create(pw85_system const *system, double const *semi_axes,
                                         double const *quaternions, size_t seed, int32_t pair[2],
                                         pw85_hard_ellipsoids **simulation);

/** Makes a simulation one of hard ellipses in a plane z = const, or again one of ellipsoids. A new
 * simulation has three dimensions.
 *
 * In two dimensions the ellipses are the sections of the ellipsoids with the plane. They overlap
 * where the ellipsoids do, whatever the third semi-axes are. Translations are by a point of a disc,
 * rotations are about z, and the area of the cell takes the place of its volume. No function
 * changes z of the centres and of the cell vectors, or x and y of the quaternions. The largest
 * translation of a trial (pw85_hard_ellipsoids_set_steps()) is reduced to the length of the longest
 * cell vector if the cell is periodic along both of its vectors.
 *
 * @param simulation a simulation
 * @param dimensions 2 or 3
 * @return #PW85_SUCCESS; #PW85_EINVAL, and nothing changes, for other numbers, and for 2 unless
 *         the state is planar: all centres have the same z, x and y of all quaternions are 0,
 *         and without a cell, or the first two vectors of the cell have no z, and the third is
 *         along z and not periodic; or for walls or a mesh that such a simulation cannot have */
PW85_API int pw85_hard_ellipsoids_set_dimensions(pw85_hard_ellipsoids *simulation, int dimensions);

/** The number of dimensions of a simulation.
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

/** Particles and cell: pointers to the arrays of the simulation. They are valid until it is
 * destroyed, and show its present state as long as no particles are inserted or removed. Centres
 * are not wrapped into the cell.
 *
 * @param simulation [optional] a simulation
 * @return the system; without particles for null */
PW85_API pw85_system pw85_hard_ellipsoids_system(pw85_hard_ellipsoids const *simulation);

/** The orientations, num_particles×4, as pw85_hard_ellipsoids_system() gives the rest.
 *
 * @param simulation [optional] a simulation
 * @return quaternions (w, x, y, z) of length one; null for null */
PW85_API double const *pw85_hard_ellipsoids_quaternions(pw85_hard_ellipsoids const *simulation);

/** The semi-axes, num_particles×3, as pw85_hard_ellipsoids_system() gives the rest.
 *
 * @param simulation [optional] a simulation
 * @return the lengths; null for null */
PW85_API double const *pw85_hard_ellipsoids_semi_axes(pw85_hard_ellipsoids const *simulation);

/** @} */

/** @name Saved simulations
 * @{ */

/** The number of bytes that pw85_hard_ellipsoids_save() writes.
 *
 * @param simulation [optional] a simulation
 * @return the number; 0 for null */
PW85_API size_t pw85_hard_ellipsoids_num_bytes(pw85_hard_ellipsoids const *simulation);

/** Writes the whole state of a simulation as bytes: 80 for each particle and some hundreds. They
 * are the same on every machine, and have a checksum: see the chapter on Monte Carlo. They contain
 * the energy of the caller's potential, but not the function.
 *
 * @param simulation a simulation
 * @param num_bytes pw85_hard_ellipsoids_num_bytes()
 * @param[out] bytes [num_bytes]
 * @return #PW85_SUCCESS, #PW85_EINVAL; #PW85_EPOTENTIAL if the energy in the caller's potential is
 *        not finite: nothing is written then */
PW85_API int pw85_hard_ellipsoids_save(pw85_hard_ellipsoids const *simulation, size_t num_bytes,
                                       unsigned char *bytes);

/** Makes a simulation from the bytes of another, which it continues bit by bit. The bytes may be of
 * another machine or of an earlier version.
 *
 * @param num_bytes [number of bytes]
 * @param bytes [num_bytes]
 * @param[out] simulation [null on error] to be destroyed by pw85_hard_ellipsoids_destroy()
 * @return #PW85_SUCCESS; #PW85_EINVAL, also for bytes that are incomplete or have been changed, and
 *         for those of a later format; #PW85_EINVAL, #PW85_EOVERLAP, #PW85_ENOTPD,
 *         #PW85_EPOTENTIAL if they are a state that is not possible; #PW85_ENOMEM */
PW85_API int pw85_hard_ellipsoids_restore(size_t num_bytes, unsigned char const *bytes,
                                          pw85_hard_ellipsoids **simulation);

/** @} */

#ifdef __cplusplus
}
#endif

#endif
