// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The functions that work on objects, each called by the function of the C API of its name.
//
// Made from the headers by api/committed.py.
// clang-format off
#ifndef PW85_BASE_OBJECTS_HPP_INCLUDED
#define PW85_BASE_OBJECTS_HPP_INCLUDED

#include <pw85_simulation.h>

namespace pw85::detail {

int neighbors_create(pw85_system const &system, double scale, double skin,
                     pw85_neighbors *&list) noexcept;
int neighbors_check(pw85_system const &system, double scale, double skin,
                    size_t *particle) noexcept;
int neighbors_holds(pw85_neighbors const &list, pw85_system const &system, int *holds) noexcept;
int mesh_create(size_t num_vertices, double const *vertices, size_t num_triangles,
                int32_t const *triangles, pw85_mesh *&mesh) noexcept;
int mesh_contact(pw85_mesh const &mesh, double const center[3], double const q[6], double *mu2,
                 double point[3], int32_t *triangle) noexcept;
int mesh_overlap(pw85_mesh const &mesh, double const center[3], double const q[6],
                 int *overlap) noexcept;
int mesh_distance(pw85_mesh const &mesh, double const center[3], double const q[6],
                  double *distance, double point1[3], double point2[3], double normal[3],
                  int32_t *triangle, int32_t *inside) noexcept;
int mesh_contact_batch(pw85_mesh const &mesh, size_t n, double const *centers, double const *q,
                       double *mu2, double *point, int32_t *triangle) noexcept;
int mesh_overlap_batch(pw85_mesh const &mesh, size_t n, double const *centers, double const *q,
                       unsigned char *overlap) noexcept;
int mesh_distance_batch(pw85_mesh const &mesh, size_t n, double const *centers, double const *q,
                        double *distance, double *point1, double *point2, double *normal,
                        int32_t *triangle, int32_t *inside) noexcept;
int hard_ellipsoids_create(pw85_system const &system, double const *semi_axes,
                           double const *quaternions, size_t seed, int32_t pair[2],
                           pw85_hard_ellipsoids *&simulation) noexcept;
int hard_ellipsoids_set_dimensions(pw85_hard_ellipsoids &simulation, int dimensions) noexcept;
int hard_ellipsoids_dimensions(pw85_hard_ellipsoids const &simulation, int *dimensions) noexcept;
int hard_ellipsoids_save(pw85_hard_ellipsoids const &simulation, size_t num_bytes,
                         unsigned char *bytes) noexcept;
int hard_ellipsoids_restore(size_t num_bytes, unsigned char const *bytes,
                            pw85_hard_ellipsoids *&simulation) noexcept;
int hard_ellipsoids_set_walls(pw85_hard_ellipsoids &simulation, size_t num_walls,
                              pw85_wall const *walls, int32_t overlap[2]) noexcept;
int hard_ellipsoids_set_mesh(pw85_hard_ellipsoids &simulation, size_t num_vertices,
                             double const *vertices, size_t num_triangles, int32_t const *triangles,
                             int32_t overlap[2]) noexcept;
int hard_ellipsoids_set_fields(pw85_hard_ellipsoids &simulation, size_t num_fields,
                               pw85_field const *fields) noexcept;
int hard_ellipsoids_set_potential(pw85_hard_ellipsoids &simulation, pw85_potential *potential,
                                  void *context) noexcept;
int hard_ellipsoids_set_law(pw85_hard_ellipsoids &simulation, pw85_law const *law) noexcept;
int hard_ellipsoids_sweep(pw85_hard_ellipsoids &simulation, size_t num_sweeps) noexcept;
int hard_ellipsoids_chain(pw85_hard_ellipsoids &simulation, size_t num_chains, double length,
                          double const direction[3], double *compressibility) noexcept;
int hard_ellipsoids_volume_moves(pw85_hard_ellipsoids &simulation, size_t num_moves,
                                 double pressure, int change) noexcept;
int hard_ellipsoids_tune(pw85_hard_ellipsoids &simulation, size_t num_sweeps, double acceptance,
                         double pressure, int change) noexcept;
int hard_ellipsoids_set_fractions(pw85_hard_ellipsoids &simulation,
                                  double const fractions[4]) noexcept;
int hard_ellipsoids_set_steps(pw85_hard_ellipsoids &simulation, double const steps[3]) noexcept;
int hard_ellipsoids_steps(pw85_hard_ellipsoids const &simulation, double steps[3]) noexcept;
int hard_ellipsoids_set_kind_steps(pw85_hard_ellipsoids &simulation, size_t num_kinds,
                                   double const *semi_axes, double const *steps) noexcept;
int hard_ellipsoids_kind_steps(pw85_hard_ellipsoids const &simulation, size_t num_kinds,
                               double const *semi_axes, double *steps) noexcept;
int hard_ellipsoids_counts(pw85_hard_ellipsoids const &simulation, int64_t trials[5],
                           int64_t accepted[5]) noexcept;
int hard_ellipsoids_try(pw85_hard_ellipsoids &simulation, size_t particle, double const center[3],
                        double const quaternion[4], int take, int *is_free) noexcept;
int hard_ellipsoids_insert(pw85_hard_ellipsoids &simulation, double const center[3],
                           double const quaternion[4], double const semi_axes[3], int take,
                           int *is_free) noexcept;
int hard_ellipsoids_remove(pw85_hard_ellipsoids &simulation, size_t particle) noexcept;
int hard_ellipsoids_insertion_weight(pw85_hard_ellipsoids &simulation, size_t num_trials,
                                     double const semi_axes[3], double *weight) noexcept;
int hard_ellipsoids_insertion_moves(pw85_hard_ellipsoids &simulation, size_t num_moves,
                                    size_t num_kinds, double const *semi_axes,
                                    double const *activities, int64_t counts[4]) noexcept;
int hard_ellipsoids_energy(pw85_hard_ellipsoids const &simulation, double *energy) noexcept;
int hard_ellipsoids_law_virial(pw85_hard_ellipsoids const &simulation, double *virial) noexcept;
int hard_ellipsoids_neighbors(pw85_hard_ellipsoids &simulation, size_t particle, size_t capacity,
                              size_t *count, int32_t *particles, int32_t *images,
                              double *separations) noexcept;
int hard_ellipsoids_check(pw85_hard_ellipsoids const &simulation, int32_t pair[2]) noexcept;
int hard_ellipsoids_compress(pw85_hard_ellipsoids &simulation, int take, double *factor) noexcept;
int random_addition_create(int dimensions, double const cell[9], size_t num_kinds,
                           double const *semi_axes, size_t seed,
                           pw85_random_addition *&addition) noexcept;
int random_addition_advance(pw85_random_addition &addition, double attempts, size_t num_particles,
                            int *end) noexcept;
int random_addition_state(pw85_random_addition const &addition, size_t *num_particles,
                          double *attempts, double *free_share) noexcept;
int random_addition_particles(pw85_random_addition const &addition, size_t num_particles,
                              double *centers, double *quaternions, int32_t *kinds) noexcept;

} // namespace pw85::detail

#endif
