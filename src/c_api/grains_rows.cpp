// SPDX-License-Identifier: BSD-3-Clause
// The C API, many rows without lanes: curvature and contact of grains.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85_batch.h>

#include "../rows/each_row.hpp"

using namespace pw85::detail::kernels;

int pw85_curvature_batch(size_t n, double const *normals, double const *q, double *curvatures,
                         double *directions)
{
    static constexpr char const *names[] = {"pw85_curvature_batch", "normals", "q", "curvatures",
                                            "directions"};
    return each_row(names, n, pw85_curvature, RowsOf<3>{normals}, RowsOf<6>{q},
                    OptionalRowsOf<2>{curvatures}, OptionalRowsOf<6>{directions});
}

int pw85_hertz_batch(size_t n, double const *curvatures, double *radius, double *ellipse)
{
    static constexpr char const *names[] = {"pw85_hertz_batch", "curvatures", "radius", "ellipse"};
    return each_row(names, n, pw85_hertz, RowsOf<2>{curvatures}, OptionalRowsOf<1>{radius},
                    OptionalRowsOf<2>{ellipse});
}

int pw85_hertz_contact_batch(size_t n, double const *r12, double const *q1, double const *q2,
                             double const *normals, double *depth, double *point,
                             double *curvatures, double *directions, double *radius,
                             double *ellipse)
{
    static constexpr char const *names[] = {"pw85_hertz_contact_batch", "r12", "q1", "q2",
                                            "normals", "depth", "point", "curvatures", "directions",
                                            "radius", "ellipse"};
    return each_row(names, n, pw85_hertz_contact, RowsOf<3>{r12}, RowsOf<6>{q1}, RowsOf<6>{q2},
                    RowsOf<3>{normals}, OptionalRowsOf<1>{depth}, OptionalRowsOf<3>{point},
                    OptionalRowsOf<2>{curvatures}, OptionalRowsOf<6>{directions},
                    OptionalRowsOf<1>{radius}, OptionalRowsOf<2>{ellipse});
}

int pw85_grain_radius_gradient_batch(size_t n, double const *r12, double const *q1,
                                     double const *q2, double const *normals, double *d_r12,
                                     double *d_rot1, double *d_rot2)
{
    static constexpr char const *names[] = {"pw85_grain_radius_gradient_batch", "r12", "q1", "q2",
                                            "normals", "d_r12", "d_rot1", "d_rot2"};
    return each_row(names, n, pw85_grain_radius_gradient, RowsOf<3>{r12}, RowsOf<6>{q1},
                    RowsOf<6>{q2}, RowsOf<3>{normals}, OptionalRowsOf<3>{d_r12},
                    OptionalRowsOf<3>{d_rot1}, OptionalRowsOf<3>{d_rot2});
}

int pw85_grain_contact_wall_batch(size_t n, double const *normals, double const *offsets,
                                  double const *directions, double const *curvature,
                                  double const *q, double *depth, double *point, double *curvatures,
                                  double *radius)
{
    static constexpr char const *names[] = {"pw85_grain_contact_wall_batch", "normals", "offsets",
                                            "directions", "curvature", "q", "depth", "point",
                                            "curvatures", "radius"};
    return each_row(names, n, pw85_grain_contact_wall, RowsOf<3>{normals}, Numbers{offsets},
                    RowsOf<3>{directions}, Numbers{curvature}, RowsOf<6>{q},
                    OptionalRowsOf<1>{depth}, OptionalRowsOf<3>{point},
                    OptionalRowsOf<2>{curvatures}, OptionalRowsOf<1>{radius});
}
