/* SPDX-License-Identifier: BSD-3-Clause */
/** @file pw85_simulation_surroundings.h
 * @brief Walls, a mesh, fields, a potential and a law of pairs of a simulation, which act on
 * particles beside their hard cores. pw85_simulation.h includes this header and has the
 * conventions.
 */
#ifndef PW85_SIMULATION_SURROUNDINGS_H_INCLUDED
#define PW85_SIMULATION_SURROUNDINGS_H_INCLUDED

#include <pw85_simulation_state.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @name Walls and a mesh of a simulation
 * @{ */

/** A hard wall: the half-space vector·x >= size, as for pw85_distance_plane(). */
#define PW85_WALL_PLANE 0

/** A hard wall: everything outside the sphere with the centre `point` and the radius `size`; in two
 * dimensions, outside the disc. */
#define PW85_WALL_SPHERE 1

/** A hard wall: everything outside the cylinder of infinite length and radius `size`, whose axis
 * goes through `point` along `vector`. */
#define PW85_WALL_CYLINDER 2

/** A hard wall: everything outside the box with the lower corner `point` and the upper corner
 * `vector`; in two dimensions, outside the rectangle. */
#define PW85_WALL_BOX 3

/** A hard wall of a simulation: see pw85_hard_ellipsoids_set_walls(). */
typedef struct pw85_wall {
    /** #PW85_WALL_PLANE, #PW85_WALL_SPHERE, #PW85_WALL_CYLINDER or #PW85_WALL_BOX. */
    int kind;
    /** a point; not read for a plane. */
    double point[3];
    /** normal, axis or corner; not read for a sphere. */
    double vector[3];
    /** offset or radius; not read for a box. */
    double size;
} pw85_wall;

/** Sets the hard walls of a simulation, in place of those that it has. Walls are a part of the
 * state that pw85_hard_ellipsoids_save() writes.
 *
 * A particle may touch a wall. The decisions are exact for the semi-axes of the particle as they
 * are in its form, and for the rounded square of a radius. For a cylinder whose axis is not along
 * x, y or z, they are exact for rounded projections.
 *
 * In a periodic cell a wall is the same in all images. The periodic vectors of the cell must be
 * along the plane, or along the axis of the cylinder, and the cell must not be periodic in the
 * direction across. Spheres and boxes require a simulation without a periodic vector. In two
 * dimensions normals have no z, and axes are along z.
 *
 * With walls, event chains (pw85_hard_ellipsoids_chain()) and compression are not possible.
 *
 * @param simulation a simulation
 * @param num_walls how many; 0 for none
 * @param walls [num_walls] they are copied
 * @param[out] overlap [optional; -1 on error] the first particle that a wall cuts, and the wall; -1
 *        if there is none
 * @return #PW85_SUCCESS; #PW85_EOVERLAP if a wall cuts a particle; #PW85_EINVAL, also for a wall
 *        that a simulation of this cell or these dimensions cannot have; #PW85_ENOMEM. Nothing
 *        changes on error */
PW85_API int pw85_hard_ellipsoids_set_walls(pw85_hard_ellipsoids *simulation, size_t num_walls,
                                            pw85_wall const *walls, int32_t overlap[2]);

/** Sets the hard mesh of a simulation, in place of the one that it has: triangles that no particle
 * may overlap. The mesh is a part of the state that pw85_hard_ellipsoids_save() writes.
 *
 * A particle may touch a triangle. The decisions are those of pw85_mesh_overlap(). The mesh is a
 * surface, with particles on both sides. They stay on their side, because no translation of a
 * particle in a sweep is longer than twice its shortest semi-axis, whatever the steps are.
 * pw85_hard_ellipsoids_tune() takes this limit into account. It holds if coordinates are below 10⁸
 * times the semi-axis. pw85_hard_ellipsoids_try() and insertions place particles on both sides.
 *
 * In a periodic cell the mesh is also periodic: give the mesh of one cell. With a mesh, trials of
 * the volume, event chains and compression are not possible, because the cell cannot change.
 *
 * @param simulation a simulation of three dimensions
 * @param num_vertices [number of vertices] at most 2³¹ - 1
 * @param vertices [num_vertices×3; length] they are copied
 * @param num_triangles [number of triangles] at most 2³¹ - 1; 0 for no mesh
 * @param triangles [num_triangles×3; index] indices of vertices, from 0; they are copied
 * @param[out] overlap [optional; -1 on error] the first particle that the mesh or a wall cuts, and
 *        the triangle next to it or the wall; -1 if there is none
 * @return #PW85_SUCCESS; #PW85_EOVERLAP if the mesh cuts a particle; #PW85_EINVAL as for
 *        pw85_mesh_create(), in two dimensions, if the mesh is wider than 16 periods of the cell,
 *        and if more than 2¹⁴ images of a particle may meet the mesh; #PW85_ENOMEM. Nothing changes
 *        on error */
PW85_API int pw85_hard_ellipsoids_set_mesh(pw85_hard_ellipsoids *simulation, size_t num_vertices,
                                           double const *vertices, size_t num_triangles,
                                           int32_t const *triangles, int32_t overlap[2]);

/** @} */

/** @name Energies of a simulation
 * @{ */

/** A field: βU = strength vector·x, with the centre x of the particle. */
#define PW85_FIELD_LINEAR 0

/** A field: βU = strength V vector·x, with the volume V of the particle, or its area in two
 * dimensions: its weight minus its buoyancy. */
#define PW85_FIELD_WEIGHT 1

/** A field: βU = strength Σ_d vector_d (x_d - point_d)²/2. */
#define PW85_FIELD_HARMONIC 2

/** A field: βU = -strength (3 cos²θ - 1)/2, with the angle θ between `vector` and principal axis
 * number `axis` of the particle. */
#define PW85_FIELD_ALIGNING 3

/** A field that acts on each particle of a simulation: see pw85_hard_ellipsoids_set_fields(). */
typedef struct pw85_field {
    /** #PW85_FIELD_LINEAR, #PW85_FIELD_WEIGHT, #PW85_FIELD_HARMONIC or
     * #PW85_FIELD_ALIGNING. */
    int kind;
    /** principal axis, from 0 to 2; it matters for an aligning field only. */
    int axis;
    /** where a harmonic field is zero; not read for others. */
    double point[3];
    /** direction, gradient, or stiffness along x, y and z. */
    double vector[3];
    /** factor of the energy, in the unit of k_B T; may be negative. */
    double strength;
} pw85_field;

/** Sets the fields of a simulation, in place of those that it has. Their energies add. Fields are a
 * part of the state that pw85_hard_ellipsoids_save() writes.
 *
 * The target is then the density e^(-βU) of all configurations without overlaps, where U is the sum
 * of the energies of all particles.
 *
 * In a periodic cell a field is the same in all images. The periodic vectors must be across a
 * gradient, and have no component along which a harmonic field is stiff. With fields, event chains
 * and compression are not possible.
 *
 * @param simulation a simulation
 * @param num_fields how many; 0 for none
 * @param fields [num_fields] they are copied
 * @return #PW85_SUCCESS; #PW85_EINVAL, also for a field that a simulation of this cell cannot have;
 *        #PW85_EPOTENTIAL if the energy of a particle is not finite; #PW85_ENOMEM. Nothing changes
 *        on error */
PW85_API int pw85_hard_ellipsoids_set_fields(pw85_hard_ellipsoids *simulation, size_t num_fields,
                                             pw85_field const *fields);

/** The energy βU of a particle in the caller's potential. +infinity forbids the position.
 *
 * The function must depend only on its arguments, and be the same in all images of a periodic cell.
 * Several threads call it at once. Its arguments are the context of
 * pw85_hard_ellipsoids_set_potential(), the index of the particle, its centre, which is not wrapped
 * into the cell, its quaternion (w, x, y, z) of length one, and its semi-axes. */
typedef double pw85_potential(void *context, int32_t particle, double const center[3],
                              double const quaternion[4], double const semi_axes[3]);

/** Sets the potential of a simulation, in addition to its fields, or removes it.
 *
 * The target is that of pw85_hard_ellipsoids_set_fields(). If the potential returns NaN or
 * -infinity, the sweep or trial ends with #PW85_EPOTENTIAL, and the simulation is in the state
 * before this sweep or trial.
 *
 * If a simulation with a potential is restored, it makes no trials (#PW85_EPOTENTIAL) until its
 * potential is set again. A potential that gives the saved state another energy is refused. To use
 * such a potential, remove the old one before.
 *
 * @param simulation a simulation
 * @param potential [optional] the function, or null for none
 * @param context [optional] first argument of each call of the function
 * @return #PW85_SUCCESS; #PW85_EINVAL for another potential than that of the restored state;
 *        #PW85_EPOTENTIAL if the energy of a particle is not finite. Nothing changes on error */
PW85_API int pw85_hard_ellipsoids_set_potential(pw85_hard_ellipsoids *simulation,
                                                pw85_potential *potential, void *context);

/** Sets an energy of pairs beside the hard cores, or removes it: a law of μ², with βU in the place
 * of U. A law is a part of the state that pw85_hard_ellipsoids_save() writes.
 *
 * With a law the target is the density e^(-βU) of all configurations without overlaps, where U has
 * the energies of all pairs, all images included. Energies of pairs are rounded to multiples of
 * 2⁻³² k_B T. The bits of a trajectory therefore do not depend on the number of threads.
 *
 * Trials take longer, because the neighbour lists have all pairs that the law reaches.
 * pw85_hard_ellipsoids_try(), pw85_hard_ellipsoids_insert() and pw85_hard_ellipsoids_compress()
 * test only for overlaps. Event chains are not possible: they end at contacts, and a law would have
 * to end them wherever the energy of a pair has grown by a random amount.
 *
 * @param simulation a simulation
 * @param law [optional] #PW85_LAW_INVERSE_POWERS or #PW85_LAW_TABLE, which is copied; none for
 *        null, and for the kind 0
 * @return #PW85_SUCCESS; #PW85_EINVAL, also for a law that pw85_law_forces_pairs() does not allow;
 *        for a soft repulsion, which ends where the hard cores begin; for energies of pairs above
 *        2²⁰ k_B T, by a simple bound; for a cutoff of μ² that is not above 1, where hard cores
 *        touch, or that is above 10⁶; #PW85_ENOMEM. Nothing changes on error */
PW85_API int pw85_hard_ellipsoids_set_law(pw85_hard_ellipsoids *simulation, pw85_law const *law);

/** @} */

#ifdef __cplusplus
}
#endif

#endif
