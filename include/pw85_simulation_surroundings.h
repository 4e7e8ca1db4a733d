/* SPDX-License-Identifier: BSD-3-Clause */
/** @file pw85_simulation_surroundings.h
 * @brief Walls, a mesh, fields, a potential of the caller and a pair potential, which act on the
 * particles of a simulation in addition to their hard cores. pw85_simulation.h includes this header
 * and has the conventions.
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

/** Sets the hard walls of a simulation, and removes the walls that it had. Walls are a part of the
 * state that pw85_hard_ellipsoids_save() writes.
 *
 * A particle may touch a wall. The decisions are exact for the form of the particle, and for the
 * rounded square of a radius. For a cylinder whose axis is not along x, y or z, they are exact for
 * rounded projections.
 *
 * In a periodic cell a wall must be its own image. Therefore the periodic vectors of the cell must
 * be parallel to a plane, or to the axis of a cylinder; the cell must not be periodic in other
 * directions. Spheres and boxes require a simulation without a periodic vector. In two dimensions
 * normals must have no component along z, and axes must be along z.
 *
 * With walls, event chains (pw85_hard_ellipsoids_chain()) and compression are not possible.
 *
 * @param simulation a simulation
 * @param num_walls number of walls; 0 removes all
 * @param walls [num_walls] they are copied
 * @param[out] overlap [optional; -1 on error] indices of the first particle that a wall cuts, and
 *        of that wall; -1 if there is none
 * @return #PW85_SUCCESS; #PW85_EOVERLAP if a wall cuts a particle; #PW85_EINVAL, also for a wall
 *        that a simulation of this cell or these dimensions cannot have; #PW85_ENOMEM. Nothing
 *        changes on error */
PW85_API int pw85_hard_ellipsoids_set_walls(pw85_hard_ellipsoids *simulation, size_t num_walls,
                                            pw85_wall const *walls, int32_t overlap[2]);

/** Sets the hard mesh of a simulation, and removes the mesh that it had. No particle may overlap a
 * triangle of the mesh. The mesh is a part of the state that pw85_hard_ellipsoids_save() writes.
 *
 * A particle may touch a triangle. The decisions are those of pw85_mesh_overlap(). The mesh is a
 * surface, with particles on both sides. Particles stay on their side, because a sweep limits the
 * translation of a particle to twice its shortest semi-axis, whatever the steps are.
 * pw85_hard_ellipsoids_tune() takes this limit into account. The limit suffices if coordinates are
 * below 10⁸ times the semi-axis. pw85_hard_ellipsoids_try() and insertions can place particles on
 * both sides.
 *
 * In a periodic cell the mesh is also periodic: give the mesh of one cell. With a mesh, volume
 * moves, event chains and compression are not possible.
 *
 * @param simulation a simulation of three dimensions
 * @param num_vertices [number of vertices] at most 2³¹ - 1
 * @param vertices [num_vertices×3; length] they are copied
 * @param num_triangles [number of triangles] at most 2³¹ - 1; 0 for no mesh
 * @param triangles [num_triangles×3; index] indices of vertices, from 0; they are copied
 * @param[out] overlap [optional; -1 on error] indices of the first particle that the mesh or a wall
 *        cuts, and of the triangle next to it or of the wall; -1 if there is none
 * @return #PW85_SUCCESS; #PW85_EOVERLAP if the mesh cuts a particle; #PW85_EINVAL as for
 *        pw85_mesh_create(), in two dimensions, if the mesh is wider than 16 periods of the cell,
 *        and if more than 2¹⁴ images of a particle may intersect the mesh; #PW85_ENOMEM. Nothing
 *        changes on error */
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
    /** principal axis, from 0 to 2; read for an aligning field only. */
    int axis;
    /** where a harmonic field is zero; not read for others. */
    double point[3];
    /** direction, gradient, or stiffness along x, y and z. */
    double vector[3];
    /** factor of the energy, in units of k_B T; may be negative. */
    double strength;
} pw85_field;

/** Sets the fields of a simulation, and removes the fields that it had. The energies of several
 * fields add up. Fields are a part of the state that pw85_hard_ellipsoids_save() writes.
 *
 * The probability density of a configuration without overlaps is then proportional to e^(-βU),
 * where U is the sum of the energies of all particles.
 *
 * In a periodic cell a field must be its own image. Therefore the periodic vectors must be
 * perpendicular to a gradient, and must have no component along which a harmonic field is stiff.
 * With fields, event chains and compression are not possible.
 *
 * @param simulation a simulation
 * @param num_fields number of fields; 0 removes all
 * @param fields [num_fields] they are copied
 * @return #PW85_SUCCESS; #PW85_EINVAL, also for a field that a simulation of this cell cannot have;
 *        #PW85_EPOTENTIAL if the energy of a particle is not finite; #PW85_ENOMEM. Nothing changes
 *        on error */
PW85_API int pw85_hard_ellipsoids_set_fields(pw85_hard_ellipsoids *simulation, size_t num_fields,
                                             pw85_field const *fields);

/** The energy βU of a particle in the caller's potential. +infinity forbids the position.
 *
 * The result must depend only on the arguments, and be the same for all images in a periodic cell.
 * Several threads call the function at the same time. The arguments are the context of
 * pw85_hard_ellipsoids_set_potential(), and the index, the centre, the quaternion (w, x, y, z) of
 * length one and the semi-axes of the particle. The centre is not wrapped into the cell. */
typedef double pw85_potential(void *context, int32_t particle, double const center[3],
                              double const quaternion[4], double const semi_axes[3]);

/** Sets the potential of a simulation, in addition to its fields, or removes it.
 *
 * The target is that of pw85_hard_ellipsoids_set_fields(). If the potential returns NaN or
 * -infinity, the sweep or trial ends with #PW85_EPOTENTIAL, and the simulation returns to the state
 * before this sweep or trial.
 *
 * A restored simulation that had a potential makes no trials (#PW85_EPOTENTIAL) until this
 * potential is set again. The function refuses a potential that gives another energy for the saved
 * state. To use such a potential, first remove the old one.
 *
 * @param simulation a simulation
 * @param potential [optional] the function, or null for none
 * @param context [optional] first argument of each call of the function
 * @return #PW85_SUCCESS; #PW85_EINVAL for a potential that differs from that of the restored state;
 *        #PW85_EPOTENTIAL if the energy of a particle is not finite. Nothing changes on error */
PW85_API int pw85_hard_ellipsoids_set_potential(pw85_hard_ellipsoids *simulation,
                                                pw85_potential *potential, void *context);

/** Sets or removes a pair potential in addition to the hard cores: a law that gives βU as a
 * function of μ². A law is a part of the state that pw85_hard_ellipsoids_save() writes.
 *
 * With a law, the probability density of a configuration without overlaps is proportional to
 * e^(-βU), where U is the sum of the energies of all pairs, including all images. Pair energies are
 * rounded to multiples of 2⁻³² k_B T. The bits of a trajectory therefore do not depend on the
 * number of threads.
 *
 * Trials take longer, because the neighbour lists contain all pairs within the cutoff of the law.
 * pw85_hard_ellipsoids_try(), pw85_hard_ellipsoids_insert() and pw85_hard_ellipsoids_compress()
 * test only for overlaps. Event chains are not possible with a law: a chain ends displacements only
 * at contacts of hard cores.
 *
 * @param simulation a simulation
 * @param law [optional] #PW85_LAW_INVERSE_POWERS or #PW85_LAW_TABLE, which is copied; null, or the
 *        kind 0, removes the law
 * @return #PW85_SUCCESS; #PW85_EINVAL, also for a law that pw85_law_forces_pairs() does not allow;
 *        for a soft repulsion, which ends where the hard cores begin; for pair energies above 2²⁰
 *        k_B T, by a simple bound; for a cutoff of μ² that is not above 1, where hard cores touch,
 *        or that is above 10⁶; #PW85_ENOMEM. Nothing changes on error */
PW85_API int pw85_hard_ellipsoids_set_law(pw85_hard_ellipsoids *simulation, pw85_law const *law);

/** @} */

#ifdef __cplusplus
}
#endif

#endif
