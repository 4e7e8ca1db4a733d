// SPDX-License-Identifier: BSD-3-Clause
// The C API, many rows without lanes: walls, points and lines.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85_batch.h>

#include "../rows/each_row.hpp"

using namespace pw85::detail::kernels;

int pw85_distance_plane_batch(size_t n, double const *normals, double const *offsets,
                              double const *q, double *distance, double *point)
{
    static constexpr char const *names[] = {"pw85_distance_plane_batch", "normals", "offsets", "q",
                                            "distance", "point"};
    return each_row(names, n, pw85_distance_plane, RowsOf<3>{normals}, Numbers{offsets},
                    RowsOf<6>{q}, OptionalRowsOf<1>{distance}, OptionalRowsOf<3>{point});
}

int pw85_distance_plane_derivatives_batch(size_t n, double const *normals, double const *q,
                                          double *d_center, double *d_rot)
{
    static constexpr char const *names[] = {"pw85_distance_plane_derivatives_batch", "normals", "q",
                                            "d_center", "d_rot"};
    return each_row(names, n, pw85_distance_plane_derivatives, RowsOf<3>{normals}, RowsOf<6>{q},
                    OptionalRowsOf<3>{d_center}, OptionalRowsOf<3>{d_rot});
}

int pw85_contact_plane_batch(size_t n, double const *normals, double const *offsets,
                             double const *q, double *mu2, double *point)
{
    static constexpr char const *names[] = {"pw85_contact_plane_batch", "normals", "offsets", "q",
                                            "mu2", "point"};
    return each_row(names, n, pw85_contact_plane, RowsOf<3>{normals}, Numbers{offsets},
                    RowsOf<6>{q}, OptionalRowsOf<1>{mu2}, OptionalRowsOf<3>{point});
}

int pw85_contact_plane_derivatives_batch(size_t n, double const *normals, double const *offsets,
                                         double const *q, double *d_center, double *d_rot)
{
    static constexpr char const *names[] = {"pw85_contact_plane_derivatives_batch", "normals",
                                            "offsets", "q", "d_center", "d_rot"};
    return each_row(names, n, pw85_contact_plane_derivatives, RowsOf<3>{normals}, Numbers{offsets},
                    RowsOf<6>{q}, OptionalRowsOf<3>{d_center}, OptionalRowsOf<3>{d_rot});
}

int pw85_distance_box_batch(size_t n, double const *lower, double const *upper, double const *q,
                            double *distance, double *point, double *normal)
{
    static constexpr char const *names[] = {"pw85_distance_box_batch", "lower", "upper", "q",
                                            "distance", "point", "normal"};
    return each_row(names, n, pw85_distance_box, RowsOf<3>{lower}, RowsOf<3>{upper}, RowsOf<6>{q},
                    OptionalRowsOf<1>{distance}, OptionalRowsOf<3>{point},
                    OptionalRowsOf<3>{normal});
}

int pw85_overlap_volume_plane_batch(size_t n, double const *normals, double const *offsets,
                                    double const *q, double *volume)
{
    static constexpr char const *names[] = {"pw85_overlap_volume_plane_batch", "normals", "offsets",
                                            "q", "volume"};
    return each_row(names, n, pw85_overlap_volume_plane, RowsOf<3>{normals}, Numbers{offsets},
                    RowsOf<6>{q}, RowsOf<1, double>{volume});
}
