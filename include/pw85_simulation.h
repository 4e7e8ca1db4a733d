/* SPDX-License-Identifier: BSD-3-Clause */
/** @file pw85_simulation.h
 * @brief Monte Carlo simulations of hard ellipsoids.
 *
 * The conventions are those of pw85.h.
 */
#ifndef PW85_SIMULATION_H_INCLUDED
#define PW85_SIMULATION_H_INCLUDED

#include <pw85_systems.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @name Monte Carlo of hard ellipsoids
 *
 * A simulation owns particles, cell, lists of neighbours, random numbers and counts. Particles
 * never overlap: each trial is decided by the exact overlap test, for the separations of centres as
 * rounded to doubles. The target is the uniform distribution of all configurations without
 * overlaps, at constant volume or, with trials of the volume, at constant pressure.
 *
 * The random numbers are those of Philox4x32-10 (Salmon and others 2011), selected by the seed and
 * the number of the step. So the same calls give the same trajectory, bit by bit, with any number
 * of threads and after pw85_hard_ellipsoids_restore().
 *
 * One simulation may be used by one thread at a time; the functions themselves run in parallel.
 *
 * A simulation of two dimensions (pw85_hard_ellipsoids_set_dimensions()) is one of hard ellipses in
 * a plane of z.
 * @{ */

/** A simulation. The library owns it. */
typedef struct pw85_hard_ellipsoids pw85_hard_ellipsoids;

/** Scales the cell in all directions alike. */
#define PW85_CHANGE_ISOTROPIC 0

/** Scales the cell along x, y or z, chosen at random; in two dimensions along x or y. */
#define PW85_CHANGE_AXIS 1

/** Scales the cell along x, y or z, or shears it, chosen at random. A shear adds a multiple of a
 * later coordinate to an earlier one, so that a cell whose vectors are a lower triangular
 * matrix stays one. In two dimensions that is a multiple of y, added to x. */
#define PW85_CHANGE_TRICLINIC 2

/** Scales the cell along x, y or z, chosen at random, and along the two others such that the
 * volume stays as it is, up to rounding errors; in two dimensions along x and y, at constant
 * area. The pressure is not read. */
#define PW85_CHANGE_ASPECT 3

/** A hard wall: the half-space vector·x >= size. As that of pw85_distance_plane(). */
#define PW85_WALL_PLANE 0

/** A hard wall: all that is outside of the sphere with the centre `point` and the radius `size`;
 * in two dimensions, of the disc. */
#define PW85_WALL_SPHERE 1

/** A hard wall: all that is outside of the cylinder of infinite length whose axis goes through
 * `point` along `vector`, with the radius `size`. */
#define PW85_WALL_CYLINDER 2

/** A hard wall: all that is outside of the box with the lower corner `point` and the upper
 * corner `vector`; in two dimensions, of the rectangle. */
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

/** A field: βU = strength vector·x, with the centre x of the particle. */
#define PW85_FIELD_LINEAR 0

/** A field: βU = strength V vector·x, with the volume V of the particle, or its area in two
 * dimensions. Weight less buoyancy. */
#define PW85_FIELD_WEIGHT 1

/** A field: βU = strength Σ_d vector_d (x_d - point_d)²/2. */
#define PW85_FIELD_HARMONIC 2

/** A field: βU = -strength (3 cos²θ - 1)/2, with the angle θ between `vector` and the principal
 * axis number `axis` of the particle. */
#define PW85_FIELD_ALIGNING 3

/** A field that acts on each particle of a simulation: see pw85_hard_ellipsoids_set_fields(). */
typedef struct pw85_field {
    /** #PW85_FIELD_LINEAR, #PW85_FIELD_WEIGHT, #PW85_FIELD_HARMONIC or #PW85_FIELD_ALIGNING. */
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

/** The energy βU of a particle in the caller's potential: +infinity forbids the place. It
 * depends on nothing but its arguments, is called by several threads at once, and is the same
 * in all images of a periodic cell. Centres are not wrapped into the cell. Arguments: what
 * pw85_hard_ellipsoids_set_potential() was given, the index of the particle, its centre, its
 * quaternion (w, x, y, z) of length one, and its semi-axes. */
typedef double pw85_potential(void *context, int32_t particle, double const center[3],
                              double const quaternion[4], double const semi_axes[3]);

/** Makes a simulation. The arrays are copied.
 *
 * In the beginning, half of the trials are translations and half are rotations. The memory is some
 * 420 bytes per particle, 24 more with trials of the volume, and 8 for each of its neighbours.
 * While neighbours are listed, there are at least 10 more for each of them.
 *
 * @param system at most 2³¹ - 1 particles as for pw85_neighbors_create(); `q` may be null, it is
 *        not read. The cell may be smaller than a particle, whose images must not overlap either.
 * @param semi_axes num_particles×3: lengths of the principal semi-axes of each particle, > 0, whose
 *        squares are in the range of double
 * @param quaternions num_particles×4: (w, x, y, z), of any lengths > 0
 * @param seed selects the random numbers
 * @param[out] pair the first two particles that overlap, the same for a particle and its own image;
 *        -1 if no particles overlap; may be null
 * @param[out] simulation null on error; to be destroyed by pw85_hard_ellipsoids_destroy()
 * @return #PW85_SUCCESS; #PW85_EOVERLAP if particles overlap; #PW85_EINVAL and #PW85_ENOTPD as
 *        for pw85_neighbors_create(); #PW85_ENOMEM */
PW85_API int pw85_hard_ellipsoids_create(pw85_system const *system, double const *semi_axes,
                                         double const *quaternions, size_t seed, int32_t pair[2],
                                         pw85_hard_ellipsoids **simulation);

/** Makes a simulation one of hard ellipses in a plane of z, or again one of ellipsoids. A new
 * simulation has three dimensions.
 *
 * In two dimensions the ellipses are the sections of the ellipsoids with the plane. They overlap
 * where the ellipsoids do, whatever the third semi-axes are. Translations are by a point of a disc,
 * rotations are about z, and the area of the cell takes the place of its volume. No function
 * changes a bit of z of the centres and of the vectors of the cell, or of x and y of the
 * quaternions. A translation (pw85_hard_ellipsoids_set_steps()) that is longer than the longest
 * vector of the cell becomes as long as that where the cell is periodic along both of its vectors.
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
 * @param[out] dimensions 2 or 3; -1 on error
 * @return #PW85_SUCCESS, #PW85_EINVAL */
PW85_API int pw85_hard_ellipsoids_dimensions(pw85_hard_ellipsoids const *simulation,
                                             int *dimensions);

/** Sets the hard walls of a simulation, in place of those that it has.
 *
 * A particle may touch a wall. The decisions are exact, for the semi-axes of the particle as they
 * are in its form, and for the rounded square of a radius; for the axis of a cylinder that is not
 * along x, y or z they are those of rounded projections. Walls are a part of the state that
 * pw85_hard_ellipsoids_save() writes.
 *
 * A wall is the same in all images of a periodic cell: the periodic vectors of the cell are along
 * the plane, or along the axis of the cylinder. In the direction across, the cell is not periodic.
 * Spheres and boxes are for simulations without a periodic vector. In two dimensions normals have
 * no z, and axes are along z.
 *
 * There are no event chains (pw85_hard_ellipsoids_chain()) and no compression with walls.
 *
 * @param simulation a simulation
 * @param num_walls how many; 0 for none
 * @param walls num_walls: they are copied
 * @param[out] overlap the first particle that a wall cuts, and the wall; -1 if there is none; may
 *        be null
 * @return #PW85_SUCCESS; #PW85_EOVERLAP if a wall cuts a particle, #PW85_EINVAL, also for a wall
 *         that a simulation of this cell or these dimensions cannot have, #PW85_ENOMEM: nothing
 *         changes then */
PW85_API int pw85_hard_ellipsoids_set_walls(pw85_hard_ellipsoids *simulation, size_t num_walls,
                                            pw85_wall const *walls, int32_t overlap[2]);

/** Sets the hard mesh of a simulation, in place of the one that it has: triangles that no particle
 * meets, beside the walls.
 *
 * A particle may touch a triangle. The decisions are those of pw85_mesh_overlap(). The mesh is a
 * surface: particles are on both sides of it, and stay on their side, because no translation of a
 * particle in a sweep is longer than twice its shortest semi-axis, whatever the steps are.
 * pw85_hard_ellipsoids_tune() knows this limit. It holds where coordinates are below 10⁸ times the
 * semi-axis. pw85_hard_ellipsoids_try() and insertions place particles on both sides.
 *
 * In a periodic cell the mesh is repeated with it, so that the mesh of one cell is enough. The cell
 * cannot change: there are no trials of the volume, no event chains and no compression with a mesh.
 * The mesh is a part of the state that pw85_hard_ellipsoids_save() writes.
 *
 * @param simulation a simulation of three dimensions
 * @param num_vertices number of vertices, at most 2³¹ - 1
 * @param vertices num_vertices×3: they are copied
 * @param num_triangles number of triangles, at most 2³¹ - 1; 0 for no mesh
 * @param triangles num_triangles×3: indices of vertices, from 0; they are copied
 * @param[out] overlap the first particle that the mesh or a wall cuts, and the triangle next to it
 *        or the wall; -1 if there is none; may be null
 * @return #PW85_SUCCESS; #PW85_EOVERLAP if the mesh cuts a particle; #PW85_EINVAL as for
 *         pw85_mesh_create(), in two dimensions, and for a mesh that is wider than 16 periods of
 *         the cell; #PW85_ENOMEM: nothing changes then */
PW85_API int pw85_hard_ellipsoids_set_mesh(pw85_hard_ellipsoids *simulation, size_t num_vertices,
                                           double const *vertices, size_t num_triangles,
                                           int32_t const *triangles, int32_t overlap[2]);

/** Sets the fields of a simulation, in place of those that it has. Their energies add.
 *
 * With fields the target is the density e^(-βU) of all configurations without overlaps, where U is
 * the sum of the energies of all particles. Fields are a part of the state that
 * pw85_hard_ellipsoids_save() writes.
 *
 * A field is the same in all images of a periodic cell: the periodic vectors are across a gradient,
 * and have no component along which a harmonic field is stiff. There are no event chains and no
 * compression with fields.
 *
 * @param simulation a simulation
 * @param num_fields how many; 0 for none
 * @param fields num_fields: they are copied
 * @return #PW85_SUCCESS; #PW85_EINVAL, also for a field that a simulation of this cell cannot
 *         have, #PW85_EPOTENTIAL if the energy of a particle is not finite, #PW85_ENOMEM:
 *         nothing changes then */
PW85_API int pw85_hard_ellipsoids_set_fields(pw85_hard_ellipsoids *simulation, size_t num_fields,
                                             pw85_field const *fields);

/** Sets the potential of a simulation, beside its fields, or none.
 *
 * The target is that of pw85_hard_ellipsoids_set_fields(). If the potential returns NaN or
 * -infinity, the sweep or trial ends with #PW85_EPOTENTIAL, and the simulation is in the state
 * before this sweep or trial.
 *
 * A simulation of pw85_hard_ellipsoids_restore() whose potential has not been set again makes no
 * trials (#PW85_EPOTENTIAL). Another potential, which gives the state that was saved another
 * energy, is refused. To use another one, set none before.
 *
 * @param simulation a simulation
 * @param potential the function, or null for none
 * @param context what the function gets as its first argument; may be null
 * @return #PW85_SUCCESS; #PW85_EINVAL for another potential than that of the state that was
 *         restored, #PW85_EPOTENTIAL if the energy of a particle is not finite: nothing changes
 *         then */
PW85_API int pw85_hard_ellipsoids_set_potential(pw85_hard_ellipsoids *simulation,
                                                pw85_potential *potential, void *context);

/** Sets an energy of pairs beside the hard cores, or none: a law of μ², with βU in the place of U.
 *
 * With a law the target is the density e^(-βU) of all configurations without overlaps, where U has
 * the energies of all pairs, all images included. Energies of pairs are rounded to multiples of
 * 2⁻³² k_B T, so that the bits of a trajectory do not depend on the number of threads. A law is a
 * part of the state that pw85_hard_ellipsoids_save() writes.
 *
 * Trials take longer, because the lists of neighbours have all pairs that the law reaches.
 * pw85_hard_ellipsoids_try(), pw85_hard_ellipsoids_insert() and pw85_hard_ellipsoids_compress() ask
 * for overlaps only. There are no event chains with a law: these end at contacts, and a law would
 * have to end them wherever the energy of a pair has grown by a random amount.
 *
 * @param simulation a simulation
 * @param law #PW85_LAW_INVERSE_POWERS or #PW85_LAW_TABLE, which is copied; none for null,
 *        and for the kind 0
 * @return #PW85_SUCCESS; #PW85_EINVAL, also for a law that pw85_law_forces_pairs() does not allow,
 *         for a soft repulsion, which ends where the hard cores begin, for energies of pairs above
 *         10⁶ k_B T by a simple bound, and for a cutoff beyond μ = 1000; #PW85_ENOMEM: nothing
 *         changes then */
PW85_API int pw85_hard_ellipsoids_set_law(pw85_hard_ellipsoids *simulation, pw85_law const *law);

/** The energy of all particles in the fields, the potential and the law of pairs, in the unit of
 * k_B T.
 *
 * @param simulation a simulation
 * @param[out] energy the sum in the order of the particles, and then of the pairs; 0 without
 *        fields, potential and law; NaN on error
 * @return #PW85_SUCCESS, #PW85_EINVAL; #PW85_EPOTENTIAL if the potential of a restored
 *        simulation is not set, or if it returns NaN; #PW85_ENOMEM, with a law */
PW85_API int pw85_hard_ellipsoids_energy(pw85_hard_ellipsoids const *simulation, double *energy);

/** The virial of the law of pairs, W = -2 Σ μ² dβU/dμ², which the pressure has beside that of the
 * hard cores.
 *
 * If the cell and all centres grow by the factor 1 + ε, μ² of each pair grows by (1 + ε)², and βU
 * of all pairs by -ε W. So in d dimensions βPV = N + (n'(0) + W)/d, where n(ε) is the mean number
 * of pairs with μ < 1 + ε, in the presence of the law. At constant pressure the mean of all this
 * gives that pressure.
 *
 * @param simulation a simulation
 * @param[out] virial the sum over all pairs and images, in the unit of k_B T; 0 without a law; NaN
 *        on error
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOMEM */
PW85_API int pw85_hard_ellipsoids_law_virial(pw85_hard_ellipsoids const *simulation,
                                             double *virial);

/** Makes sweeps. A sweep has as many trials as there are particles.
 *
 * For each sweep the cell is divided into domains with a random origin. Domains that are not
 * neighbours are worked on at the same time. Each gets as many trials as it has particles, each of
 * a random particle of the domain, and the domains of one colour come after those of another, in
 * random order. A trial that leaves its domain is rejected. So the division does not change during
 * a sweep, the way back of each trial is as probable as the trial, and a sweep is in detailed
 * balance.
 *
 * A translation is by a point of a ball. A rotation multiplies the quaternion by (1, v) from the
 * left, v a point of a ball. An exchange swaps the semi-axes of two particles of a domain. In two
 * dimensions a translation is by a point of a disc, and a rotation about z multiplies by (1, 0, 0,
 * v), v uniform in an interval around 0, so that turns by an angle and by its negative are equally
 * probable.
 *
 * @param simulation a simulation
 * @param num_sweeps how many
 * @return #PW85_SUCCESS, #PW85_EINVAL; #PW85_ENOMEM, after which the last sweep is not complete;
 *         #PW85_EPOTENTIAL as for pw85_hard_ellipsoids_set_potential() */
PW85_API int pw85_hard_ellipsoids_sweep(pw85_hard_ellipsoids *simulation, size_t num_sweeps);

/** Makes event chains, which translate many particles at once and give the pressure.
 *
 * For each chain a random particle moves along a direction until it touches another one. This one
 * moves on from there, and so on, until the sum of the ways is the length of the chain. No chain
 * leads to an overlap (pw85_free_path(), and the exact overlap test of each place). Chains do not
 * rotate particles: use sweeps of rotations, too.
 *
 * Chains along one direction keep the uniform distribution, without detailed balance, but do not
 * change the coordinates across it. Chains along random directions are in detailed balance. βP/ρ,
 * along the direction, is the mean of (x_last - x_first)/length over chains, where x is the
 * coordinate along the direction of the particle that moves, which jumps at each contact (Michel,
 * Kapfer and Krauth 2014). Make blocks of chains to see its error.
 *
 * @param simulation a simulation
 * @param num_chains how many
 * @param length of each chain, > 0, in the unit of length. It is long if it is the mean way between
 *        contacts times the number of particles
 * @param direction of any length > 0, in two dimensions without z; or null for a random direction
 *        of each chain, isotropic
 * @param[out] compressibility βP/ρ along the directions, by these chains; may be null. NaN on
 *        error, without chains or particles, and where a particle could touch its own image if it
 *        turned: where the shortest vector of the lattice is not longer than twice the longest
 *        semi-axis. Such contacts are a part of the pressure that chains do not find, because
 *        images move with their particle.
 * @return #PW85_SUCCESS; #PW85_EINVAL, also for a direction that is zero or out of the plane,
 *         and with walls, a mesh, fields or a potential; #PW85_ENOMEM or #PW85_ECONVERGENCE
 *         (particles block each other within rounding errors, or the length is more than some
 *         10¹⁵ ways), after which the last chain is not complete */
PW85_API int pw85_hard_ellipsoids_chain(pw85_hard_ellipsoids *simulation, size_t num_chains,
                                        double length, double const direction[3],
                                        double *compressibility);

/** Tries changes of the cell and of all centres with it, at constant pressure.
 *
 * The coordinates are multiplied by a random matrix E. It is as probable as its inverse. The trial
 * is accepted with the probability min(1, (det E)^(N+1) exp(-βP V (det E - 1))) if there is no
 * overlap afterwards. So the density of volumes of N particles is that of V^N exp(-βPV) for each
 * kind of change, and the kinds may be mixed. The logarithmic lengths and the shears of the cell
 * are distributed uniformly otherwise; a fluid does not limit the shears. In two dimensions E
 * changes x and y only, and V is the area. With a potential, its change is a part of the exponent.
 *
 * @param simulation a simulation with a cell that is periodic along its three vectors, in two
 *        dimensions along the first two
 * @param num_moves number of trials
 * @param pressure βP, > 0, in the inverse cube of the unit of length, in two dimensions in its
 *        inverse square; for #PW85_CHANGE_ASPECT any number
 * @param change #PW85_CHANGE_ISOTROPIC, #PW85_CHANGE_AXIS, #PW85_CHANGE_TRICLINIC or
 *        #PW85_CHANGE_ASPECT
 * @return #PW85_SUCCESS; #PW85_EINVAL, also with a mesh; #PW85_ENOMEM; #PW85_EPOTENTIAL as for
 *        pw85_hard_ellipsoids_set_potential() */
PW85_API int pw85_hard_ellipsoids_volume_moves(pw85_hard_ellipsoids *simulation, size_t num_moves,
                                               double pressure, int change);

/** Makes sweeps, and changes the steps after each of them towards an acceptance. Then it sets all
 * counts to zero.
 *
 * Trials are not in detailed balance while the steps change: use this to equilibrate only.
 * Translations become at most half as long as the longest semi-axis. Only where particles are far
 * apart may they become longer, so that the lists of neighbours stay short.
 *
 * @param simulation a simulation
 * @param num_sweeps how many
 * @param acceptance the desired part of the trials that is accepted, > 0 and at most 1
 * @param pressure βP as for pw85_hard_ellipsoids_volume_moves(), for one trial of the volume after
 *        each sweep; 0 for none, except for #PW85_CHANGE_ASPECT
 * @param change as for pw85_hard_ellipsoids_volume_moves()
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOMEM; #PW85_EPOTENTIAL as for
 *        pw85_hard_ellipsoids_set_potential() */
PW85_API int pw85_hard_ellipsoids_tune(pw85_hard_ellipsoids *simulation, size_t num_sweeps,
                                       double acceptance, double pressure, int change);

/** Sets the parts of the trials of a sweep that are translations, rotations, both at once, and
 * exchanges.
 *
 * @param simulation a simulation
 * @param fractions not negative; they are divided by their sum, which is positive
 * @return #PW85_SUCCESS, #PW85_EINVAL */
PW85_API int pw85_hard_ellipsoids_set_fractions(pw85_hard_ellipsoids *simulation,
                                                double const fractions[4]);

/** Sets the largest changes of a trial.
 *
 * The lists of neighbours reach three times as far as a translation. So their memory grows with its
 * third power.
 *
 * @param simulation a simulation
 * @param steps positive: the length of a translation, in a cell that is periodic along its three
 *        vectors, or in two dimensions along the first two, at most that of the longest one; the
 *        tangent of half of the angle of a rotation, at most 1; the relative change of a length of
 *        the cell or the shear, at most 1
 * @return #PW85_SUCCESS, #PW85_EINVAL */
PW85_API int pw85_hard_ellipsoids_set_steps(pw85_hard_ellipsoids *simulation,
                                            double const steps[3]);

/** The largest changes of a trial.
 *
 * @param simulation a simulation
 * @param[out] steps as for pw85_hard_ellipsoids_set_steps()
 * @return #PW85_SUCCESS, #PW85_EINVAL */
PW85_API int pw85_hard_ellipsoids_steps(pw85_hard_ellipsoids const *simulation, double steps[3]);

/** Sets the largest translations and rotations of particles with some semi-axes, in place of all
 * such steps that there are. Other particles have those of pw85_hard_ellipsoids_set_steps().
 * pw85_hard_ellipsoids_tune() tunes the steps of each kind by its own trials. They are a part of
 * the state that pw85_hard_ellipsoids_save() writes.
 *
 * @param simulation a simulation
 * @param num_kinds at most 16; 0 for none
 * @param semi_axes num_kinds×3: those of each kind, all different
 * @param steps num_kinds×2: translation and rotation, as for pw85_hard_ellipsoids_set_steps()
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOMEM: nothing changes on error */
PW85_API int pw85_hard_ellipsoids_set_kind_steps(pw85_hard_ellipsoids *simulation, size_t num_kinds,
                                                 double const *semi_axes, double const *steps);

/** The largest translations and rotations of particles with some semi-axes.
 *
 * @param simulation a simulation
 * @param num_kinds how many
 * @param semi_axes num_kinds×3: any
 * @param[out] steps num_kinds×2: translation and rotation of each; those of all others where they
 *        have none of their own
 * @return #PW85_SUCCESS, #PW85_EINVAL */
PW85_API int pw85_hard_ellipsoids_kind_steps(pw85_hard_ellipsoids const *simulation,
                                             size_t num_kinds, double const *semi_axes,
                                             double *steps);

/** The numbers of trials since the simulation was made or tuned: translations, rotations, both at
 * once, exchanges, volume.
 *
 * @param simulation a simulation
 * @param[out] trials how many there were; -1 on error; may be null
 * @param[out] accepted how many of them were accepted; -1 on error; may be null
 * @return #PW85_SUCCESS, #PW85_EINVAL */
PW85_API int pw85_hard_ellipsoids_counts(pw85_hard_ellipsoids const *simulation, int64_t trials[5],
                                         int64_t accepted[5]);

/** The images of particles whose bounding boxes meet that of one particle, ordered by their
 * indices, then by their images. Particles that the given one may touch or overlap are among them.
 * The order and the numbers depend on the present state alone.
 *
 * @param simulation a simulation
 * @param particle index, from 0
 * @param capacity how many images the arrays can have; with 0 the function only counts
 * @param[out] count how many images there are, which may be more than `capacity`; 0 on error
 * @param[out] particles capacity: index of each; the first `count` are written, as of the next
 *        arrays, which may all be null
 * @param[out] images capacity×3: multiples of the vectors of the cell, to be added to the centre of
 *        that particle, or null
 * @param[out] separations capacity×3: from the centre of the given particle to that of the image,
 *        or null
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOMEM */
PW85_API int pw85_hard_ellipsoids_neighbors(pw85_hard_ellipsoids *simulation, size_t particle,
                                            size_t capacity, size_t *count, int32_t *particles,
                                            int32_t *images, double *separations);

/** Whether a particle would be free of overlaps at another place, by the exact test; and moves it
 * there, if wanted. All images are tested, those of the particle itself, too. Counts and random
 * numbers stay as they are.
 *
 * A place near the present one takes about as long as a trial of a sweep. For other places, a new
 * list of all neighbours is made. A place that a wall cuts, or that a potential forbids, is not
 * free.
 *
 * @param simulation a simulation
 * @param particle index, from 0
 * @param center new centre, anywhere in the cell or its images, or null for the present one
 * @param quaternion new orientation (w, x, y, z), of any length > 0, or null for the present one
 * @param take whether the particle shall stay there if it is free
 * @param[out] is_free 1 or 0; -1 on error
 * @return #PW85_SUCCESS; #PW85_EINVAL, also for a free place that is too far away for
 *         pw85_neighbors_create(), and in two dimensions for one out of the plane: another z, or
 *         x or y of the quaternion not 0; #PW85_ENOTPD; #PW85_ENOMEM; #PW85_EPOTENTIAL if the
 *         potential returns NaN there */
PW85_API int pw85_hard_ellipsoids_try(pw85_hard_ellipsoids *simulation, size_t particle,
                                      double const center[3], double const quaternion[4], int take,
                                      int *is_free);

/** Whether a new particle would be free of overlaps, by the exact test; and inserts it as the last
 * one, if wanted. Its own images and walls are tested, too. A place that the potential forbids is
 * not free.
 *
 * The pointers of pw85_hard_ellipsoids_system() and the like are of the old number of particles.
 * They may be read as long as the simulation lives, but do not show its present state any more. The
 * time is proportional to the number of particles.
 *
 * @param simulation a simulation
 * @param center anywhere in the cell or its images
 * @param quaternion (w, x, y, z), of any length > 0
 * @param semi_axes lengths of the principal semi-axes, as for
 *        pw85_hard_ellipsoids_insertion_weight()
 * @param take whether the particle shall be inserted if it is free
 * @param[out] is_free 1 or 0; -1 on error
 * @return #PW85_SUCCESS; #PW85_EINVAL, also for a centre that is too far away for
 *         pw85_neighbors_create(), and in two dimensions for one out of the plane; #PW85_ENOTPD;
 *         #PW85_ENOMEM, also for more than 2³¹ - 1 particles; #PW85_EPOTENTIAL if the potential
 *         returns NaN there, or that of a restored simulation is not set: nothing changes on
 *         error */
PW85_API int pw85_hard_ellipsoids_insert(pw85_hard_ellipsoids *simulation, double const center[3],
                                         double const quaternion[4], double const semi_axes[3],
                                         int take, int *is_free);

/** Removes a particle. The last one takes its index. Pointers as for pw85_hard_ellipsoids_insert().
 *
 * @param simulation a simulation
 * @param particle index, from 0
 * @return #PW85_SUCCESS; #PW85_EINVAL, also if there is no such particle; #PW85_EPOTENTIAL if the
 *         potential of a restored simulation is not set, whose energy would be another one */
PW85_API int pw85_hard_ellipsoids_remove(pw85_hard_ellipsoids *simulation, size_t particle);

/** The mean of e^(-βU) of a particle that is inserted at random, 0 where it is not free: Widom's
 * insertions. The particles stay as they are. U is its energy in fields and potential, and with a
 * law that of its pairs with all others and with its own images.
 *
 * The place is uniform in the cell, and so is the orientation. Vectors of the cell that are not
 * periodic are read: the cell begins at the origin, and walls may be within it. With the mean w
 * over many states, βμ = ln ρ - ln w for another particle of this kind, where ρ is the density of
 * its kind in the unit of the inverse cube of length. Make blocks of states to see the error of w.
 *
 * @param simulation a simulation with a cell, whose three vectors are independent, in two
 *        dimensions the first two
 * @param num_trials how many insertions
 * @param semi_axes of the particle, > 0; at most 32 times the shortest vector of the lattice of
 *        images; with a law also if they, and those of the other particles, are enlarged by the
 *        root of the cutoff
 * @param[out] weight the mean, without fields and law the part of the places that are free; NaN on
 *        error and without trials
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD, #PW85_ENOMEM; #PW85_EPOTENTIAL as for
 *        pw85_hard_ellipsoids_set_potential() */
PW85_API int pw85_hard_ellipsoids_insertion_weight(pw85_hard_ellipsoids *simulation,
                                                   size_t num_trials, double const semi_axes[3],
                                                   double *weight);

/** Tries insertions and removals of particles, at constant activities: the grand canonical
 * ensemble, if sweeps move the particles.
 *
 * Each trial is an insertion or a removal of a particle of one of the kinds, all equally probable.
 * A particle is of the kind that has its semi-axes. Particles of other kinds stay. An insertion at
 * a random place and with a random orientation is accepted with the probability min(1, z V/(N + 1)
 * e^(-βU)) if the particle is free, and a removal of a random particle of the kind with min(1, N/(z
 * V) e^(βU)), where N is the number of particles of the kind. Particles that are out of the cell,
 * along vectors that are not periodic, stay. So an ideal gas has the density z of each kind, and
 * the numbers of its particles are distributed by Poisson's law. In two dimensions V is the area.
 * A potential must not depend on the index of a particle here, which removals change. Pointers as
 * for pw85_hard_ellipsoids_insert().
 *
 * @param simulation a simulation with a cell, whose three vectors are independent, in two
 *        dimensions the first two
 * @param num_moves how many trials
 * @param num_kinds at least 1
 * @param semi_axes num_kinds×3: those of each kind, all different, as for
 *        pw85_hard_ellipsoids_insertion_weight()
 * @param activities num_kinds: z = e^(βμ)/Λ³ of each kind, > 0, in the inverse cube of the unit of
 *        length, in two dimensions in its inverse square
 * @param[out] counts insertions, those that were accepted, removals, those that were accepted, of
 *        this call; -1 where nothing was tried; may be null
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD; #PW85_ENOMEM, or #PW85_EPOTENTIAL as for
 *         pw85_hard_ellipsoids_set_potential(), after which the trials that were made before
 *         remain */
PW85_API int pw85_hard_ellipsoids_insertion_moves(pw85_hard_ellipsoids *simulation,
                                                  size_t num_moves, size_t num_kinds,
                                                  double const *semi_axes, double const *activities,
                                                  int64_t counts[4]);

/** How far cell and centres can be compressed before particles touch: the factor of all lengths,
 * the same in all directions, in two dimensions in those of the plane; and compresses, if wanted.
 * Particles keep their sizes. The factor is that of the least μ of all pairs, 1/μ, enlarged by no
 * more than rounding errors require: the exact test finds no overlap after the coordinates are
 * multiplied by the factor and rounded. A law of pairs has no influence on it.
 *
 * @param simulation a simulation
 * @param take whether the cell and the centres shall be multiplied by the factor
 * @param[out] factor at most 1; 0, and nothing is changed, if there are no pairs; NaN on error
 * @return #PW85_SUCCESS; #PW85_EINVAL, also if particles are too far apart for a list of
 *         neighbours, and with walls, a mesh, fields or a potential; #PW85_ENOMEM */
PW85_API int pw85_hard_ellipsoids_compress(pw85_hard_ellipsoids *simulation, int take,
                                           double *factor);

/** Searches all particles for overlaps, by a neighbour list of its own.
 *
 * @param simulation a simulation
 * @param[out] pair as for pw85_hard_ellipsoids_create(); a particle that a wall cuts, and -1
 * @return #PW85_SUCCESS if there is no overlap, #PW85_EOVERLAP, #PW85_EINVAL, #PW85_ENOMEM */
PW85_API int pw85_hard_ellipsoids_check(pw85_hard_ellipsoids const *simulation, int32_t pair[2]);

/** Particles and cell: pointers to the arrays of the simulation. They are valid until it is
 * destroyed, and show its present state as long as no particles are inserted or removed. Centres
 * are not wrapped into the cell.
 *
 * @param simulation a simulation, or null
 * @return the system; without particles for null */
PW85_API pw85_system pw85_hard_ellipsoids_system(pw85_hard_ellipsoids const *simulation);

/** The orientations, num_particles×4, as pw85_hard_ellipsoids_system() gives the rest.
 *
 * @param simulation a simulation, or null
 * @return quaternions (w, x, y, z) of length one; null for null */
PW85_API double const *pw85_hard_ellipsoids_quaternions(pw85_hard_ellipsoids const *simulation);

/** The semi-axes, num_particles×3, as pw85_hard_ellipsoids_system() gives the rest.
 *
 * @param simulation a simulation, or null
 * @return the lengths; null for null */
PW85_API double const *pw85_hard_ellipsoids_semi_axes(pw85_hard_ellipsoids const *simulation);

/** The number of bytes that pw85_hard_ellipsoids_save() writes.
 *
 * @param simulation a simulation, or null
 * @return the number; 0 for null */
PW85_API size_t pw85_hard_ellipsoids_num_bytes(pw85_hard_ellipsoids const *simulation);

/** Writes the whole state of a simulation as bytes: 80 for each particle and some hundreds. They
 * can be read on machines of the same kind. Of the caller's potential they only have the energy.
 *
 * @param simulation a simulation
 * @param num_bytes pw85_hard_ellipsoids_num_bytes()
 * @param[out] bytes num_bytes
 * @return #PW85_SUCCESS, #PW85_EINVAL; #PW85_EPOTENTIAL if the energy in the caller's potential is
 *        not finite: nothing is written then */
PW85_API int pw85_hard_ellipsoids_save(pw85_hard_ellipsoids const *simulation, size_t num_bytes,
                                       unsigned char *bytes);

/** Makes a simulation from the bytes of another, which it continues bit by bit.
 *
 * @param num_bytes number of bytes
 * @param bytes num_bytes
 * @param[out] simulation null on error; to be destroyed by pw85_hard_ellipsoids_destroy()
 * @return #PW85_SUCCESS; #PW85_EINVAL, also for bytes of another kind of machine or of another
 *         version; #PW85_EINVAL, #PW85_EOVERLAP, #PW85_ENOTPD, #PW85_EPOTENTIAL if bytes have
 *         been changed to a state that is not possible; #PW85_ENOMEM */
PW85_API int pw85_hard_ellipsoids_restore(size_t num_bytes, unsigned char const *bytes,
                                          pw85_hard_ellipsoids **simulation);

/** Frees a simulation.
 *
 * @param simulation a simulation, or null */
PW85_API void pw85_hard_ellipsoids_destroy(pw85_hard_ellipsoids *simulation);

/** @} */

#ifdef __cplusplus
}
#endif

#endif
