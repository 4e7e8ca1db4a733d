// SPDX-License-Identifier: BSD-3-Clause
// The C API of objects: the functions of pw85_simulation_surroundings.h.
//
// Made from pw85_simulation_surroundings.h by api/committed.py.
// clang-format off
#include "../base/checked_call.hpp"
#include "../base/objects.hpp"

using namespace pw85::detail;

int pw85_hard_ellipsoids_set_walls(pw85_hard_ellipsoids *simulation, size_t num_walls,
                                   pw85_wall const *walls, int32_t overlap[2])
{
    mark(overlap, 2, -1);
    auto const work = [&] { return hard_ellipsoids_set_walls(*simulation, num_walls, walls,
                                                             overlap); };
    return checked_call("pw85_hard_ellipsoids_set_walls", work, Argument("simulation", simulation),
                        Argument::array("walls", walls, num_walls));
}

int pw85_hard_ellipsoids_set_mesh(pw85_hard_ellipsoids *simulation, size_t num_vertices,
                                  double const *vertices, size_t num_triangles,
                                  int32_t const *triangles, int32_t overlap[2])
{
    mark(overlap, 2, -1);
    auto const work = [&] { return hard_ellipsoids_set_mesh(*simulation, num_vertices, vertices,
                                                            num_triangles, triangles, overlap); };
    return checked_call("pw85_hard_ellipsoids_set_mesh", work, Argument("simulation", simulation),
                        Argument::rows("vertices", vertices, num_vertices, 3),
                        Argument::array("triangles", triangles, num_triangles));
}

int pw85_hard_ellipsoids_set_fields(pw85_hard_ellipsoids *simulation, size_t num_fields,
                                    pw85_field const *fields)
{
    auto const work = [&] { return hard_ellipsoids_set_fields(*simulation, num_fields, fields); };
    return checked_call("pw85_hard_ellipsoids_set_fields", work, Argument("simulation", simulation),
                        Argument::array("fields", fields, num_fields));
}

int pw85_hard_ellipsoids_set_potential(pw85_hard_ellipsoids *simulation, pw85_potential *potential,
                                       void *context)
{
    auto const work = [&] { return hard_ellipsoids_set_potential(*simulation, potential,
                                                                 context); };
    return checked_call("pw85_hard_ellipsoids_set_potential", work,
                        Argument("simulation", simulation));
}

int pw85_hard_ellipsoids_set_law(pw85_hard_ellipsoids *simulation, pw85_law const *law)
{
    auto const work = [&] { return hard_ellipsoids_set_law(*simulation, law); };
    return checked_call("pw85_hard_ellipsoids_set_law", work, Argument("simulation", simulation));
}
