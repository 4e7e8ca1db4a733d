// SPDX-License-Identifier: BSD-3-Clause
// The C API of objects: the functions of pw85_systems.h.
//
// Made from pw85_systems.h by api/committed.py.
// clang-format off
#include "../base/checked_call.hpp"
#include "../base/objects.hpp"

using namespace pw85::detail;

int pw85_neighbors_create(pw85_system const *system, double scale, double skin,
                          pw85_neighbors **list)
{
    auto const system_given = value_or_empty(system);
    mark(list, 1, nullptr);
    auto const work = [&] { return neighbors_create(*system, scale, skin, *list); };
    return checked_call(
        "pw85_neighbors_create", work, Argument("system", system),
        Argument::rows("centers", system_given.centers, system_given.num_particles, 3),
        Argument::rows("q", system_given.q, system_given.num_particles, 6, limit::definite),
        Argument("scale", scale, limit::positive), Argument("skin", skin, limit::from_zero),
        Argument("list", list));
}

int pw85_neighbors_check(pw85_system const *system, double scale, double skin, size_t *particle)
{
    auto const system_given = value_or_empty(system);
    mark(particle, 1, system_given.num_particles);
    auto const work = [&] { return neighbors_check(*system, scale, skin, particle); };
    return checked_call(
        "pw85_neighbors_check", work, Argument("system", system),
        Argument::rows("centers", system_given.centers, system_given.num_particles, 3),
        Argument::rows("q", system_given.q, system_given.num_particles, 6, limit::definite),
        Argument("scale", scale, limit::positive), Argument("skin", skin, limit::from_zero),
        Argument("particle", particle));
}

int pw85_neighbors_holds(pw85_neighbors const *list, pw85_system const *system, int *holds)
{
    auto const system_given = value_or_empty(system);
    mark(holds, 1, -1);
    auto const work = [&] { return neighbors_holds(*list, *system, holds); };
    return checked_call(
        "pw85_neighbors_holds", work, Argument("list", list), Argument("system", system),
        Argument::rows("centers", system_given.centers, system_given.num_particles, 3),
        Argument::rows("q", system_given.q, system_given.num_particles, 6, limit::definite),
        Argument("holds", holds));
}

int pw85_mesh_create(size_t num_vertices, double const *vertices, size_t num_triangles,
                     int32_t const *triangles, pw85_mesh **mesh)
{
    mark(mesh, 1, nullptr);
    auto const work = [&] { return mesh_create(num_vertices, vertices, num_triangles, triangles,
                                               *mesh); };
    return checked_call("pw85_mesh_create", work,
                        Argument::rows("vertices", vertices, num_vertices, 3),
                        Argument::array("triangles", triangles, num_triangles),
                        Argument("mesh", mesh));
}

int pw85_mesh_contact(pw85_mesh const *mesh, double const center[3], double const q[6], double *mu2,
                      double point[3], int32_t *triangle)
{
    mark(mu2, 1, quiet_nan<double>());
    mark(point, 3, quiet_nan<double>());
    mark(triangle, 1, -1);
    auto const work = [&] { return mesh_contact(*mesh, center, q, mu2, point, triangle); };
    return checked_call("pw85_mesh_contact", work, Argument("mesh", mesh),
                        Argument("center", center, 3), Argument("q", q, 6, limit::definite));
}

int pw85_mesh_overlap(pw85_mesh const *mesh, double const center[3], double const q[6],
                      int *overlap)
{
    mark(overlap, 1, -1);
    auto const work = [&] { return mesh_overlap(*mesh, center, q, overlap); };
    return checked_call("pw85_mesh_overlap", work, Argument("mesh", mesh),
                        Argument("center", center, 3), Argument("q", q, 6, limit::definite),
                        Argument("overlap", overlap));
}

int pw85_mesh_distance(pw85_mesh const *mesh, double const center[3], double const q[6],
                       double *distance, double point1[3], double point2[3], double normal[3],
                       int32_t *triangle, int32_t *inside)
{
    mark(distance, 1, quiet_nan<double>());
    mark(point1, 3, quiet_nan<double>());
    mark(point2, 3, quiet_nan<double>());
    mark(normal, 3, quiet_nan<double>());
    mark(triangle, 1, -1);
    mark(inside, 1, -1);
    auto const work = [&] { return mesh_distance(*mesh, center, q, distance, point1, point2, normal,
                                                 triangle, inside); };
    return checked_call("pw85_mesh_distance", work, Argument("mesh", mesh),
                        Argument("center", center, 3), Argument("q", q, 6, limit::definite));
}

int pw85_mesh_contact_batch(pw85_mesh const *mesh, size_t n, double const *centers, double const *q,
                            double *mu2, double *point, int32_t *triangle)
{
    auto const work = [&] { return mesh_contact_batch(*mesh, n, centers, q, mu2, point,
                                                      triangle); };
    return checked_call("pw85_mesh_contact_batch", work, Argument("mesh", mesh),
                        Argument::rows("centers", centers, n, 3),
                        Argument::rows("q", q, n, 6, limit::definite));
}

int pw85_mesh_overlap_batch(pw85_mesh const *mesh, size_t n, double const *centers, double const *q,
                            unsigned char *overlap)
{
    auto const work = [&] { return mesh_overlap_batch(*mesh, n, centers, q, overlap); };
    return checked_call("pw85_mesh_overlap_batch", work, Argument("mesh", mesh),
                        Argument::rows("centers", centers, n, 3),
                        Argument::rows("q", q, n, 6, limit::definite),
                        Argument::array("overlap", overlap, n));
}

int pw85_mesh_distance_batch(pw85_mesh const *mesh, size_t n, double const *centers,
                             double const *q, double *distance, double *point1, double *point2,
                             double *normal, int32_t *triangle, int32_t *inside)
{
    auto const work = [&] { return mesh_distance_batch(*mesh, n, centers, q, distance, point1,
                                                       point2, normal, triangle, inside); };
    return checked_call("pw85_mesh_distance_batch", work, Argument("mesh", mesh),
                        Argument::rows("centers", centers, n, 3),
                        Argument::rows("q", q, n, 6, limit::definite));
}
