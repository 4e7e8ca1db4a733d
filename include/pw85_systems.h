/* SPDX-License-Identifier: BSD-3-Clause */
/** @file pw85_systems.h
 * @brief Systems of particles: lists of pairs, periodic cells, neighbour lists and triangle meshes.
 *
 * The conventions are those of pw85.h, and for rows, bad rows and threads those of pw85_batch.h.
 */
#ifndef PW85_SYSTEMS_H_INCLUDED
#define PW85_SYSTEMS_H_INCLUDED

#include <pw85.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @name Lists of pairs
 * @{ */

/** Particles, with or without a periodic cell. The caller owns the struct and its arrays. Functions
 * only read them, and do not use them after the call. If a function does not read a member, its
 * contract says so, and the member may be null.
 *
 * If there is a cell, `periodic` states along which of its vectors the system is periodic: at least
 * one entry must not be 0. The other cell vectors may be zero or NaN. Without a cell, functions do
 * not read `periodic`. */
typedef struct pw85_system {
    /** [number of particles] 0 is allowed, and pointers may then be null. */
    size_t num_particles;
    /** [num_particles×3; length; near the cell] centres, anywhere in space. */
    double const *centers;
    /** [num_particles×6; length²; definite] forms. */
    double const *q;
    /** [3×3; length; optional; a periodic row; independent rows] rows are the
     * vectors of the cell, of which at least one is periodic; null for a system
     * without periodic images. */
    double const *cell;
    /** not 0 for each cell vector along which the system is periodic. */
    int periodic[3];
} pw85_system;

/** Pairs of particles of a system. The caller owns the struct and its arrays. Functions only read
 * them, and do not use them after the call. */
typedef struct pw85_pair_list {
    /** [number of pairs] 0 is allowed, and pointers may then be null. */
    size_t num_pairs;
    /** [num_pairs×2; index] indices (i, j) of particles, from 0. */
    int32_t const *pairs;
    /** [num_pairs×3; optional; needs cell] multiples of the cell vectors, as given,
     * to add to the centre of j; multiples of vectors that are not periodic
     * count as 0; null for the nearest images. */
    int32_t const *images;
} pw85_pair_list;

/** Tests whether an ellipsoid overlaps any of n listed particles of a system. This is the overlap
 * test of a Monte Carlo trial move.
 *
 * With `images`, the function tests one image of each listed particle, as in a neighbour list.
 * Without `images`, in a periodic cell, the function tests the nearest images, and the answer is
 * valid for all images of these particles and of the ellipsoid itself. The nearest images suffice
 * if one of them overlaps, or if pw85_nearest_image_limit() of these particles and the ellipsoid is
 * at least 1. Otherwise the status is #PW85_EINVAL, and pw85_last_error() returns `images` as the
 * argument: call the function again with the images of a neighbour list.
 *
 * In such a small cell the ellipsoid can also overlap its own images. A neighbour list contains
 * these images, with the index of the ellipsoid. Write the trial ellipsoid into the arrays of the
 * system before the call, so that this index refers to the trial ellipsoid.
 *
 * @param center [length] centre of the ellipsoid
 * @param q1 [length²; definite] form of the ellipsoid
 * @param system the particles. Without `images`, reduce the cell once by pw85_cell_reduce() to save
 *        time; particles that are more than 2⁵⁰ vectors of the reduced cell from the ellipsoid are
 *        bad. With `images` the cell may be singular.
 * @param n [number of others] 0 is allowed
 * @param indices [n; index] of particles, from 0; the index of the ellipsoid itself is allowed only
 *        with `images`
 * @param images [n×3; optional; needs cell] multiples of the cell vectors, as given, to add to the
 *        centres of these particles; or null for all images
 * @param[out] any [-1 on error] 1 or 0
 * @return as for pw85_overlap_any(); #PW85_EINVAL also if the nearest images do not decide */
PW85_API int pw85_overlap_any_indices(double const center[3], double const q1[6],
                                      pw85_system const *system, size_t n, int32_t const *indices,
                                      int32_t const *images, int *any);

/** Computes the contact function of the pairs of a list; see pw85_contact().
 *
 * In a periodic cell a pair is particle i and one image of particle j: the image that `images`
 * gives, or the image whose centre is nearest. The function finds the nearest image in any cell,
 * however skewed. If the cell is small or particles are large, another image can have a smaller μ²:
 * see pw85_nearest_image_limit().
 *
 * @param list the pairs
 * @param system the particles. Without `images`, a pair is bad if its centres are more than 2⁵⁰
 *        vectors of the reduced cell apart: rounding errors are then larger than the cell. Reducing
 *        a cell costs several hundred nanoseconds per call: see pw85_cell_reduce(). With `images`
 *        the cell may be singular.
 * @param[out] mu2 [num_pairs]
 * @param[out] lambda [num_pairs; optional]
 * @return as for pw85_contact_batch() */
PW85_API int pw85_contact_pairs(pw85_pair_list const *list, pw85_system const *system, double *mu2,
                                double *lambda);

/** Tests whether the pairs of a list overlap; see pw85_overlap().
 *
 * @param list,system [as pw85_contact_pairs()]
 * @param[out] overlap [num_pairs] 1, 0, or 255 for a bad pair
 * @return as for pw85_contact_pairs() */
PW85_API int pw85_overlap_pairs(pw85_pair_list const *list, pw85_system const *system,
                                unsigned char *overlap);

/** Computes the volumes of the intersections of the pairs of a list; see pw85_overlap_volume().
 *
 * The sum of these volumes counts a region that is inside three ellipsoids three times.
 *
 * @param list,system [as pw85_contact_pairs()]
 * @param[out] volume [num_pairs; length³]
 * @return as for pw85_contact_pairs() */
PW85_API int pw85_overlap_volume_pairs(pw85_pair_list const *list, pw85_system const *system,
                                       double *volume);

/** Computes μ², its derivatives, points and normals for the pairs of a list; see
 * pw85_contact_derivatives_batch().
 *
 * @param list,system [as pw85_contact_pairs()]
 * @param[out] mu2,lambda [num_pairs; optional]
 * @param[out] point [num_pairs×3; length; optional]
 * @param[out] normal,d_rot1,d_rot2 [num_pairs×3; optional]
 * @param[out] d_r12 [num_pairs×3; 1/length; optional]
 * @return as for pw85_contact_pairs() */
PW85_API int pw85_contact_derivatives_pairs(pw85_pair_list const *list, pw85_system const *system,
                                            double *mu2, double *lambda, double *point,
                                            double *normal, double *d_r12, double *d_rot1,
                                            double *d_rot2);

/** Computes the forces, torques and virial of a pair energy U(μ²) by summing over the pairs. Each
 * term is a derivative of pw85_contact_derivatives_pairs() times dU/dμ².
 *
 * The terms are added in the order of the pairs. The results are therefore bitwise equal for any
 * number of threads. Each thread reads all pairs, and adds the terms of its own particles.
 *
 * @param list the pairs; without pairs the sums are 0
 * @param system [as pw85_contact_pairs(); without q; or NaN; or far away] `q` may be null, and
 *        without pairs also `centers`
 * @param d_u [num_pairs; energy; or NaN] dU/dμ²; if it is 0, the pair contributes nothing, even if
 *        its derivatives are NaN
 * @param d_r12 [num_pairs×3; 1/length; optional if not needed; or NaN] derivatives of μ²; may be
 *        null if no output needs them
 * @param d_rot1,d_rot2 [num_pairs×3; optional if not needed; or NaN] derivatives of μ²; may be null
 *        if no output needs them
 * @param[out] forces [num_particles×3; energy/length; optional] -∂U/∂centre
 * @param[out] torques [num_particles×3; energy; optional] -∂U/∂(rotation vector) about the centre
 * @param[out] virial [3×3; energy; optional] Σ r12 ⊗ force on the second particle of each pair,
 *        row-major; divided by the volume, it is the contribution of contacts to the pressure
 *        tensor
 * @return #PW85_SUCCESS, also if a NaN in the input makes some of the sums NaN; #PW85_EINVAL as for
 *        pw85_contact_pairs(), before anything is written */
PW85_API int pw85_contact_forces_pairs(pw85_pair_list const *list, pw85_system const *system,
                                       double const *d_u, double const *d_r12, double const *d_rot1,
                                       double const *d_rot2, double *forces, double *torques,
                                       double *virial);

/** A soft repulsion: U = ε/α (1 - μ)^α for μ < 1, and U = 0 for μ >= 1. Parameters: ε, and α >= 1.
 * α = 2 is a harmonic repulsion, and α = 2.5 is the exponent of Hertz's law. */
#define PW85_LAW_SOFT_REPULSION 1

/** Powers of 1/μ: U = A μ⁻ⁿ - B μ⁻ᵐ - U_c for μ² < c, and U = 0 for μ² >= c. The shift U_c makes U
 * = 0 at μ² = c. Parameters: A, n, B, m, and c > 0, with n > m > 0. The parameters (4ε, 12, 4ε, 6,
 * c) give the Lennard-Jones potential with μ instead of r/σ, as Perram and others define it. With c
 * = 2^(1/3) this potential is only repulsive. */
#define PW85_LAW_INVERSE_POWERS 2

/** A table of at least two points, which divide the range a <= μ² <= b into equal intervals. In
 * each interval U is the cubic polynomial of μ² that has the given values and derivatives at both
 * ends. U is linear for μ² < a, and 0 for μ² >= b. Parameters: a, b > a, then U and dU/dμ² of point
 * 0, U and dU/dμ² of point 1, and so on. */
#define PW85_LAW_TABLE 3

/** The energy U(μ²) of a pair, the same for all pairs. The caller owns the struct and its array.
 * Functions only read them, and do not use them after the call. */
typedef struct pw85_law {
    /** #PW85_LAW_SOFT_REPULSION, #PW85_LAW_INVERSE_POWERS or #PW85_LAW_TABLE. */
    int kind;
    /** number of parameters, as the description of the kind states. */
    size_t num_parameters;
    /** [num_parameters] all finite, in the order of the description of the kind. */
    double const *parameters;
} pw85_law;

/** Computes the total energy, the forces, the torques and the virial of the pairs of a list. The
 * energy of a pair is a function of μ², the law.
 *
 * The forces and torques are bitwise equal to those of pw85_contact_forces_pairs(), with one
 * exception: a soft repulsion ignores pairs that do not overlap but whose μ² is rounded to less
 * than 1. The results are bitwise equal for any number of threads. Concentric ellipsoids exert no
 * forces. For particles of several species, make one list and one call for each law.
 *
 * The call takes little more time than pw85_contact_derivatives_pairs(). For a soft repulsion it
 * takes less, because pairs that do not overlap need no derivatives.
 *
 * @param list the pairs; without pairs the sums are 0
 * @param system [as pw85_contact_pairs()]
 * @param law the energy of a pair
 * @param[out] energy [energy; optional] ΣU
 * @param[out] forces [num_particles×3; energy/length; optional] -∂U/∂centre
 * @param[out] torques [num_particles×3; energy; optional] -∂U/∂(rotation vector) about the centre
 * @param[out] virial [3×3; energy; optional] Σ r12 ⊗ force on the second particle of each pair,
 *        row-major
 * @return as for pw85_contact_pairs(); sums to which a bad pair contributes are NaN. #PW85_EINVAL
 *        also for a kind or parameters that are not allowed; #PW85_ENOMEM if one megabyte per
 *        thread cannot be allocated. In both cases nothing is written. */
PW85_API int pw85_law_forces_pairs(pw85_pair_list const *list, pw85_system const *system,
                                   pw85_law const *law, double *energy, double *forces,
                                   double *torques, double *virial);

/** Computes the times of the first contacts of the pairs of a list, and the first contact of each
 * particle, for event-driven simulations; see pw85_first_contact().
 *
 * Each pair keeps the image of j that it has at time 0. Bad pairs are not events.
 *
 * @param list,system [as pw85_contact_pairs()]
 * @param motions [num_particles; mixed units; > 0 until t_max]
 * @param t_max [as pw85_first_contact()] for all pairs
 * @param[out] t [num_pairs; time; member time]
 * @param[out] next [num_particles; time; optional] the least t of the pairs of each particle, or
 *        infinity if there is none
 * @param[out] next_pair [num_particles; optional] the index of that pair, the first one if several
 *        have this t; -1 if there is none. It must be null if `next` is null
 * @return as for pw85_contact_pairs(); #PW85_ECONVERGENCE as for pw85_first_contact() */
PW85_API int pw85_first_contact_pairs(pw85_pair_list const *list, pw85_system const *system,
                                      pw85_motion const *motions, double t_max, double *t,
                                      double *next, int64_t *next_pair);

/** @}
 * @name Periodic cells
 * @{ */

/** Computes a reduced cell of a lattice: adding or subtracting its other vectors makes none of its
 * vectors shorter.
 *
 * Compute the reduced cell once and store it: the functions of pair lists reduce any other cell
 * again in each call. Rectangular cells are reduced, and so are cells whose vectors have equal
 * lengths and angles between 60 and 120 degrees. The reduced vectors are integer combinations of
 * the cell vectors, and are rounded. `images` for one of the two cells are not valid for the other.
 *
 * @param cell [3×3; length; independent rows] rows are the vectors
 * @param[out] reduced [3×3; length; member cell] may be the same array as cell
 * @return #PW85_SUCCESS or #PW85_EINVAL */
PW85_API int pw85_cell_reduce(double const cell[9], double reduced[9]);

/** Computes the nearest images that the functions of pair lists use if `images` is null. The
 * results are the vectors between the centres, and values for `images`.
 *
 * If you pass these `images` to the functions of pair lists, they need no search, and each pair
 * keeps its image. The images remain the nearest ones until a particle has moved by about half a
 * cell.
 *
 * @param num_pairs [number of pairs]
 * @param pairs [num_pairs×2; index] indices (i, j) of particles, from 0
 * @param system [without q; with cell] the particles, in a cell as for pw85_contact_pairs(): `cell`
 *        is not null; `q` may be null
 * @param[out] r12 [num_pairs×3; length; optional] from particle i to the image of particle j; NaN
 *        for a bad pair
 * @param[out] images [num_pairs×3; optional] multiples of the vectors of the cell, as given;
 *        INT32_MIN for a bad pair
 * @return as for pw85_contact_batch(); a pair is bad if a centre is not finite, or if a requested
 *        multiple is beyond 2³¹ - 1 */
PW85_API int pw85_nearest_images(size_t num_pairs, int32_t const *pairs, pw85_system const *system,
                                 double *r12, int32_t *images);

/** Computes the limit of μ² below which an image of a pair of these particles is always the nearest
 * image.
 *
 * If the limit is at least 1, pw85_overlap_pairs() with nearest images misses no overlap of any
 * image. A μ² of pw85_contact_pairs() below the limit is the smallest of all images. If you need
 * larger values of μ², list all relevant images and pass them as `images`.
 *
 * In a rectangular cell the limit is the smallest value of (L/4h)² over the three directions. Here
 * L is the side of the cell, and h is the largest half-width of the bounding boxes of the
 * particles. The limit is at least 1 if no box is wider than half the cell. In other cells the
 * directions are those of the faces of the Voronoi cell of the lattice.
 *
 * @param system [without centers; with cell] the particles, in a cell: `cell` is not null;
 *        `centers` may be null
 * @param[out] mu2 the limit; infinity without particles
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOTPD */
PW85_API int pw85_nearest_image_limit(pw85_system const *system, double *mu2);

/** @}
 * @name Neighbour lists
 * @{ */

/** A neighbour list: all pairs of particles whose bounding boxes intersect, with periodic images.
 * The library owns it. Pass its pairs to pw85_contact_pairs() and similar functions. */
typedef struct pw85_neighbors pw85_neighbors;

/** Makes a neighbour list: the pairs (i, j, image) whose bounding boxes are at most `skin` apart
 * along each axis, for ellipsoids scaled by `scale`.
 *
 * The condition is |r_d| <= scale (√Qi_dd + √Qj_dd) + skin for d = x, y, z, with the vector r from
 * the centre of i to the centre of the image of j. The list therefore contains all pairs with μ² <=
 * scale². After the particles have moved, it still contains all these pairs as long as
 * pw85_neighbors_holds() returns 1.
 *
 * Each pair is listed once, with i < j. An image of i itself is listed with i = j; of two opposite
 * images, the list contains the one whose first multiple other than 0 is positive. The list may
 * also contain pairs whose boxes are too far apart by rounding errors (2⁻⁴⁸ of the coordinates).
 * The order of the pairs follows the particles in space. It depends only on the input, not on the
 * number of threads.
 *
 * The time is proportional to the numbers of particles and pairs, for all sizes and positions,
 * unless most particles are in a region that is smaller than the system by a factor of 2²¹. The
 * memory is at most 200 bytes per particle and 64 per pair while the list is made. The list itself
 * has 48 bytes per particle and 20 per pair (8 without a cell).
 *
 * @param system at most 2³¹ - 1 particles, anywhere in space or in the cell and its images, up to
 *        2²⁹ cells away; the cell may be skewed and small without limit
 * @param scale [> 0] factor of the ellipsoids
 * @param skin [length; >= 0] in the unit of the semi-axes
 * @param[out] list [null on error] the list; free it by pw85_neighbors_destroy()
 * @return #PW85_SUCCESS; #PW85_EINVAL, also if an image is more than 2²⁹ vectors away;
 *        #PW85_ENOTPD; #PW85_ENOMEM. pw85_neighbors_check() returns the index of the bad particle.
 *        */
PW85_API int pw85_neighbors_create(pw85_system const *system, double scale, double skin,
                                   pw85_neighbors **list);

/** Finds the invalid particle after pw85_neighbors_create() has failed; the arguments are those of
 * pw85_neighbors_create().
 *
 * @param system,scale,skin [as pw85_neighbors_create()]
 * @param[out] particle [num_particles on error] index of the first bad particle: its centre or form
 *        is invalid, or it is too far away; num_particles if there is none, 0 if `system` is null
 * @return the status that this particle causes; the status that another argument causes, with
 *        `particle` = num_particles; or #PW85_SUCCESS, if only the memory or the number of images
 *        can be the cause */
PW85_API int pw85_neighbors_check(pw85_system const *system, double scale, double skin,
                                  size_t *particle);

/** Tests whether a list still contains all pairs whose boxes intersect (without skin), after
 * particles have moved or rotated, or the cell has changed.
 *
 * If the answer is 1, no pair is missing, for any image. If the answer is 0, pairs may be missing.
 * The answer is 1 if each box is within its old box, enlarged by half the skin on each side. A
 * translation that all particles share does not matter. If the cell has changed, the present boxes
 * are first mapped back by the linear map from the present periodic cell vectors to the old ones.
 * If the centres follow the cell when it shrinks or is sheared, about any point, only the changes
 * of the boxes use up the skin. Otherwise the displacements of the centres relative to the cell
 * also use up the skin.
 *
 * While the list is in use, do not wrap the centres into the cell, and do not reduce or flip the
 * vectors of the cell: `images` are multiples of these vectors.
 *
 * @param list [of as many particles] a list
 * @param system [with cell; or far away] the particles of the list at their present positions, with
 *        their present forms and cell. The cell must be periodic along the same vectors as for the
 *        list; `cell` must not be null if the list has one.
 * @param[out] holds [-1 on error] 1 or 0
 * @return #PW85_SUCCESS; the status of the first bad particle; #PW85_EINVAL, also if only one of
 *        list and system has a cell, or if the two cells are periodic along different vectors */
PW85_API int pw85_neighbors_holds(pw85_neighbors const *list, pw85_system const *system,
                                  int *holds);

/** Returns the pairs of a list and, if it has a cell, their images. The pointers refer to arrays of
 * the list, and are valid until it is destroyed.
 *
 * @param list [optional] a list
 * @return the pairs; no pairs if `list` is null */
PW85_API pw85_pair_list pw85_neighbors_list(pw85_neighbors const *list);

/** Frees a list.
 *
 * @param list [optional] a list */
PW85_API void pw85_neighbors_destroy(pw85_neighbors *list);

/** @}
 * @name Triangle meshes
 *
 * These functions are for ellipsoids and a mesh of triangles, such as a wall. The mesh is a
 * surface: an ellipsoid inside a closed mesh overlaps the mesh only if it overlaps a triangle. The
 * coordinates of the vertices relative to the centre are rounded to doubles. The results are then
 * bitwise equal to those of pw85_contact_triangle() and pw85_overlap_triangle() for all triangles.
 * A bounding volume hierarchy saves most of the work.
 * @{ */

/** A triangle mesh and its bounding volume hierarchy. The library owns it. Any number of threads
 * may use it at the same time. */
typedef struct pw85_mesh pw85_mesh;

/** Makes a mesh. The function copies the arrays.
 *
 * The memory is at most 300 bytes per triangle while the mesh is made, and 150 afterwards.
 *
 * @param num_vertices [number of vertices] at most 2³¹ - 1
 * @param vertices [num_vertices×3; length]
 * @param num_triangles [number of triangles] at most 2³¹ - 1
 * @param triangles [num_triangles×3; index] indices of vertices, from 0. A triangle without area is
 *        a segment or a point.
 * @param[out] mesh [null on error] the mesh; free it by pw85_mesh_destroy()
 * @return #PW85_SUCCESS, #PW85_EINVAL, #PW85_ENOMEM */
PW85_API int pw85_mesh_create(size_t num_vertices, double const *vertices, size_t num_triangles,
                              int32_t const *triangles, pw85_mesh **mesh);

/** Computes the contact function of an ellipsoid and a mesh: the least μ² of all triangles.
 *
 * The time is about 20 µs for 1,000 triangles, and about twice that for 10,000 triangles. It is
 * longer if many triangles are equally near, if the aspect ratio of the ellipsoid is above several
 * thousand, or if semi-axes and distances differ by more than a factor of 1e30.
 *
 * @param mesh a mesh
 * @param center [length] of the ellipsoid
 * @param q [length²; definite] form of the ellipsoid
 * @param[out] mu2 [optional] square of the factor by which the ellipsoid must be scaled to touch
 *        the mesh; infinity if the mesh has no triangles
 * @param[out] point [length; optional] the point at which the scaled ellipsoid touches, relative to
 *        its centre; NaN if the mesh has no triangles
 * @param[out] triangle [optional; -1 on error] index of the nearest triangle, or the first one of
 *        several; -1 if the mesh has none
 * @return #PW85_SUCCESS; #PW85_EINVAL, also if the coordinates of a vertex relative to the centre
 *        overflow; #PW85_ENOTPD */
PW85_API int pw85_mesh_contact(pw85_mesh const *mesh, double const center[3], double const q[6],
                               double *mu2, double point[3], int32_t *triangle);

/** Tests whether an ellipsoid and a mesh overlap, μ² < 1 for any triangle. If they only touch, they
 * do not overlap. The answer is exact for the rounded coordinates relative to the centre.
 *
 * @param mesh,center,q [as pw85_mesh_contact()]
 * @param[out] overlap [-1 on error] 1 or 0
 * @return as for pw85_mesh_contact() */
PW85_API int pw85_mesh_overlap(pw85_mesh const *mesh, double const center[3], double const q[6],
                               int *overlap);

/** Computes the signed distance of an ellipsoid and a mesh: the least value of
 * pw85_distance_triangle() over all triangles, with bitwise equal results.
 *
 * If the ellipsoid overlaps no triangle, the result is the distance of the ellipsoid and the
 * surface, with the closest points. Otherwise it is minus the largest depth of a single triangle:
 * every translation that separates the ellipsoid from the mesh is at least as long. The bounds on
 * errors, the proof by the normal and the derivatives are those of pw85_distance_triangle() for the
 * nearest triangle. No other triangle has a smaller lower bound on its distance.
 *
 * The signed distance to the solid that a closed mesh bounds is different. If the ellipsoid
 * overlaps no triangle, it is the distance if the centre is outside, and minus the distance if the
 * centre is inside. A mesh is closed if each edge of a triangle is also an edge of another
 * triangle, in the opposite direction; vertices with equal coordinates are the same. A point is
 * inside if the winding number of the mesh around it is not 0. If the centre is on the surface, up
 * to 2⁻⁹⁰ of the size of the mesh, `inside` is the answer for a point infinitely near the centre.
 *
 * The time is about 0.15 ms for 1,000 triangles. It is longer if the ellipsoid overlaps many
 * triangles. If the aspect ratio of the ellipsoid is above about 10⁶, the function computes all
 * triangles.
 *
 * @param mesh,center,q [as pw85_mesh_contact()]
 * @param[out] distance [length; optional] negative if they overlap; infinity if the mesh has no
 *        triangles
 * @param[out] point1 [length; optional] the point of the ellipsoid that is nearest to the mesh, or
 *        deepest, relative to its centre; NaN if the mesh has no triangles
 * @param[out] point2 [length; optional] the point of the mesh that is nearest to the ellipsoid, or
 *        deepest, relative to the centre of the ellipsoid; NaN if the mesh has no triangles
 * @param[out] normal [optional] unit vector out of the ellipsoid at point1; point2 - point1 is
 *        `distance` times it; NaN if the mesh has no triangles
 * @param[out] triangle [as pw85_mesh_contact()]
 * @param[out] inside [optional; -1 on error] 1 if the centre is inside a closed mesh, 0 if it is
 *        outside; -1 if the mesh is not closed
 * @return as for pw85_mesh_contact() */
PW85_API int pw85_mesh_distance(pw85_mesh const *mesh, double const center[3], double const q[6],
                                double *distance, double point1[3], double point2[3],
                                double normal[3], int32_t *triangle, int32_t *inside);

/** Computes pw85_mesh_contact() for n ellipsoids and one mesh, in parallel, with bitwise equal
 * results.
 *
 * @param mesh a mesh
 * @param n [number of ellipsoids]
 * @param centers [n×3; length]
 * @param q [n×6; length²; definite]
 * @param[out] mu2 [n; optional]
 * @param[out] point [n×3; length; optional]
 * @param[out] triangle [n; optional] -1 also for a bad row
 * @return as for pw85_contact_batch() */
PW85_API int pw85_mesh_contact_batch(pw85_mesh const *mesh, size_t n, double const *centers,
                                     double const *q, double *mu2, double *point,
                                     int32_t *triangle);

/** Computes pw85_mesh_overlap() for n ellipsoids and one mesh, in parallel.
 *
 * @param mesh a mesh
 * @param n [number of ellipsoids]
 * @param centers [n×3; length]
 * @param q [n×6; length²; definite]
 * @param[out] overlap [n] 1 or 0; 255 for a bad row
 * @return as for pw85_contact_batch() */
PW85_API int pw85_mesh_overlap_batch(pw85_mesh const *mesh, size_t n, double const *centers,
                                     double const *q, unsigned char *overlap);

/** Computes pw85_mesh_distance() for n ellipsoids and one mesh, in parallel, with bitwise equal
 * results.
 *
 * @param mesh a mesh
 * @param n [number of ellipsoids]
 * @param centers [n×3; length]
 * @param q [n×6; length²; definite]
 * @param[out] distance [n; length; optional]
 * @param[out] point1,point2 [n×3; length; optional]
 * @param[out] normal [n×3; optional]
 * @param[out] triangle [n; optional] -1 also for a bad row
 * @param[out] inside [n; optional] -1 also for a bad row
 * @return as for pw85_contact_batch() */
PW85_API int pw85_mesh_distance_batch(pw85_mesh const *mesh, size_t n, double const *centers,
                                      double const *q, double *distance, double *point1,
                                      double *point2, double *normal, int32_t *triangle,
                                      int32_t *inside);

/** Frees a mesh.
 *
 * @param mesh [optional] a mesh */
PW85_API void pw85_mesh_destroy(pw85_mesh *mesh);

/** @} */

#ifdef __cplusplus
}
#endif

#endif
