// SPDX-License-Identifier: BSD-3-Clause
// The C API, many rows without lanes: two dimensions.
//
// Made from pw85.h, pw85_grains.h and pw85_shapes.h by api/committed.py.
// clang-format off
#include <pw85_batch.h>

#include "../rows/each_row.hpp"

using namespace pw85::detail::kernels;

int pw85_area_batch_2d(size_t n, double const *q, double *area)
{
    static constexpr char const *names[] = {"pw85_area_batch_2d", "q", "area"};
    return each_row(names, n, pw85_area_2d, RowsOf<3>{q}, RowsOf<1, double>{area});
}

int pw85_overlap_area_gradient_batch_2d(size_t n, double const *r12, double const *q1,
                                        double const *q2, double *d_r12, double *d_q1, double *d_q2)
{
    static constexpr char const *names[] = {"pw85_overlap_area_gradient_batch_2d", "r12", "q1",
                                            "q2", "d_r12", "d_q1", "d_q2"};
    return each_row(names, n, pw85_overlap_area_gradient_2d, RowsOf<2>{r12}, RowsOf<3>{q1},
                    RowsOf<3>{q2}, OptionalRowsOf<2>{d_r12}, OptionalRowsOf<3>{d_q1},
                    OptionalRowsOf<3>{d_q2});
}

int pw85_overlap_area_torque_batch_2d(size_t n, double const *r12, double const *q1,
                                      double const *q2, double *d_rot1, double *d_rot2)
{
    static constexpr char const *names[] = {"pw85_overlap_area_torque_batch_2d", "r12", "q1", "q2",
                                            "d_rot1", "d_rot2"};
    return each_row(names, n, pw85_overlap_area_torque_2d, RowsOf<2>{r12}, RowsOf<3>{q1},
                    RowsOf<3>{q2}, OptionalRowsOf<1>{d_rot1}, OptionalRowsOf<1>{d_rot2});
}

int pw85_contact_geometry_batch_2d(size_t n, double const *r12, double const *q1, double const *q2,
                                   double const *lambda, double *point, double *normal)
{
    static constexpr char const *names[] = {"pw85_contact_geometry_batch_2d", "r12", "q1", "q2",
                                            "lambda", "point", "normal"};
    return each_row(names, n, pw85_contact_geometry_2d, RowsOf<2>{r12}, RowsOf<3>{q1},
                    RowsOf<3>{q2}, Numbers{lambda}, OptionalRowsOf<2>{point},
                    OptionalRowsOf<2>{normal});
}

int pw85_contact_gradient_batch_2d(size_t n, double const *r12, double const *q1, double const *q2,
                                   double const *lambda, double *d_r12, double *d_q1, double *d_q2)
{
    static constexpr char const *names[] = {"pw85_contact_gradient_batch_2d", "r12", "q1", "q2",
                                            "lambda", "d_r12", "d_q1", "d_q2"};
    return each_row(names, n, pw85_contact_gradient_2d, RowsOf<2>{r12}, RowsOf<3>{q1},
                    RowsOf<3>{q2}, Numbers{lambda}, OptionalRowsOf<2>{d_r12},
                    OptionalRowsOf<3>{d_q1}, OptionalRowsOf<3>{d_q2});
}

int pw85_contact_torque_batch_2d(size_t n, double const *r12, double const *q1, double const *q2,
                                 double const *lambda, double *d_rot1, double *d_rot2)
{
    static constexpr char const *names[] = {"pw85_contact_torque_batch_2d", "r12", "q1", "q2",
                                            "lambda", "d_rot1", "d_rot2"};
    return each_row(names, n, pw85_contact_torque_2d, RowsOf<2>{r12}, RowsOf<3>{q1}, RowsOf<3>{q2},
                    Numbers{lambda}, OptionalRowsOf<1>{d_rot1}, OptionalRowsOf<1>{d_rot2});
}

int pw85_contact_hessian_batch_2d(size_t n, double const *r12, double const *q1, double const *q2,
                                  double const *lambda, double *hessian)
{
    static constexpr char const *names[] = {"pw85_contact_hessian_batch_2d", "r12", "q1", "q2",
                                            "lambda", "hessian"};
    return each_row(names, n, pw85_contact_hessian_2d, RowsOf<2>{r12}, RowsOf<3>{q1}, RowsOf<3>{q2},
                    Numbers{lambda}, RowsOf<16, double>{hessian});
}

int pw85_closest_approach_batch_2d(size_t n, double const *directions, double const *q1,
                                   double const *q2, double *distance)
{
    static constexpr char const *names[] = {"pw85_closest_approach_batch_2d", "directions", "q1",
                                            "q2", "distance"};
    return each_row(names, n, pw85_closest_approach_2d, RowsOf<2>{directions}, RowsOf<3>{q1},
                    RowsOf<3>{q2}, RowsOf<1, double>{distance});
}

int pw85_distance_batch_2d(size_t n, double const *r12, double const *q1, double const *q2,
                           double *distance, double *point1, double *point2)
{
    static constexpr char const *names[] = {"pw85_distance_batch_2d", "r12", "q1", "q2", "distance",
                                            "point1", "point2"};
    return each_row(names, n, pw85_distance_2d, RowsOf<2>{r12}, RowsOf<3>{q1}, RowsOf<3>{q2},
                    OptionalRowsOf<1>{distance}, OptionalRowsOf<2>{point1},
                    OptionalRowsOf<2>{point2});
}

int pw85_distance_geometry_batch_2d(size_t n, double const *r12, double const *q1, double const *q2,
                                    double *distance, double *point1, double *point2,
                                    double *normal)
{
    static constexpr char const *names[] = {"pw85_distance_geometry_batch_2d", "r12", "q1", "q2",
                                            "distance", "point1", "point2", "normal"};
    return each_row(names, n, pw85_distance_geometry_2d, RowsOf<2>{r12}, RowsOf<3>{q1},
                    RowsOf<3>{q2}, OptionalRowsOf<1>{distance}, OptionalRowsOf<2>{point1},
                    OptionalRowsOf<2>{point2}, OptionalRowsOf<2>{normal});
}

int pw85_penetration_batch_2d(size_t n, double const *r12, double const *q1, double const *q2,
                              double *depth, double *direction)
{
    static constexpr char const *names[] = {"pw85_penetration_batch_2d", "r12", "q1", "q2", "depth",
                                            "direction"};
    return each_row(names, n, pw85_penetration_2d, RowsOf<2>{r12}, RowsOf<3>{q1}, RowsOf<3>{q2},
                    OptionalRowsOf<1>{depth}, OptionalRowsOf<2>{direction});
}

int pw85_signed_distance_batch_2d(size_t n, double const *r12, double const *q1, double const *q2,
                                  double *distance, double *point1, double *point2)
{
    static constexpr char const *names[] = {"pw85_signed_distance_batch_2d", "r12", "q1", "q2",
                                            "distance", "point1", "point2"};
    return each_row(names, n, pw85_signed_distance_2d, RowsOf<2>{r12}, RowsOf<3>{q1}, RowsOf<3>{q2},
                    OptionalRowsOf<1>{distance}, OptionalRowsOf<2>{point1},
                    OptionalRowsOf<2>{point2});
}

int pw85_signed_distance_geometry_batch_2d(size_t n, double const *r12, double const *q1,
                                           double const *q2, double *distance, double *point1,
                                           double *point2, double *normal)
{
    static constexpr char const *names[] = {"pw85_signed_distance_geometry_batch_2d", "r12", "q1",
                                            "q2", "distance", "point1", "point2", "normal"};
    return each_row(names, n, pw85_signed_distance_geometry_2d, RowsOf<2>{r12}, RowsOf<3>{q1},
                    RowsOf<3>{q2}, OptionalRowsOf<1>{distance}, OptionalRowsOf<2>{point1},
                    OptionalRowsOf<2>{point2}, OptionalRowsOf<2>{normal});
}

int pw85_gap_inside_batch_2d(size_t n, double const *r12, double const *q1, double const *q2,
                             double *gap, double *point1, double *point2, double *normal)
{
    static constexpr char const *names[] = {"pw85_gap_inside_batch_2d", "r12", "q1", "q2", "gap",
                                            "point1", "point2", "normal"};
    return each_row(names, n, pw85_gap_inside_2d, RowsOf<2>{r12}, RowsOf<3>{q1}, RowsOf<3>{q2},
                    OptionalRowsOf<1>{gap}, OptionalRowsOf<2>{point1}, OptionalRowsOf<2>{point2},
                    OptionalRowsOf<2>{normal});
}

int pw85_perimeter_batch_2d(size_t n, double const *q, double *perimeter)
{
    static constexpr char const *names[] = {"pw85_perimeter_batch_2d", "q", "perimeter"};
    return each_row(names, n, pw85_perimeter_2d, RowsOf<3>{q}, RowsOf<1, double>{perimeter});
}

int pw85_second_moments_batch_2d(size_t n, double const *q, double *moments)
{
    static constexpr char const *names[] = {"pw85_second_moments_batch_2d", "q", "moments"};
    return each_row(names, n, pw85_second_moments_2d, RowsOf<3>{q}, RowsOf<3, double>{moments});
}

int pw85_from_moments_batch_2d(size_t n, double const *second_moments, double *q)
{
    static constexpr char const *names[] = {"pw85_from_moments_batch_2d", "second_moments", "q"};
    return each_row(names, n, pw85_from_moments_2d, RowsOf<3>{second_moments},
                    RowsOf<3, double>{q});
}

int pw85_shell_moments_batch_2d(size_t n, double const *q, double *moments)
{
    static constexpr char const *names[] = {"pw85_shell_moments_batch_2d", "q", "moments"};
    return each_row(names, n, pw85_shell_moments_2d, RowsOf<3>{q}, RowsOf<3, double>{moments});
}

int pw85_distance_point_batch_2d(size_t n, double const *r, double const *q, double *distance,
                                 double *point, double *normal)
{
    static constexpr char const *names[] = {"pw85_distance_point_batch_2d", "r", "q", "distance",
                                            "point", "normal"};
    return each_row(names, n, pw85_distance_point_2d, RowsOf<2>{r}, RowsOf<3>{q},
                    OptionalRowsOf<1>{distance}, OptionalRowsOf<2>{point},
                    OptionalRowsOf<2>{normal});
}

int pw85_contact_segment_batch_2d(size_t n, double const *end1, double const *end2, double const *q,
                                  double *mu2, double *point)
{
    static constexpr char const *names[] = {"pw85_contact_segment_batch_2d", "end1", "end2", "q",
                                            "mu2", "point"};
    return each_row(names, n, pw85_contact_segment_2d, RowsOf<2>{end1}, RowsOf<2>{end2},
                    RowsOf<3>{q}, OptionalRowsOf<1>{mu2}, OptionalRowsOf<2>{point});
}

int pw85_contact_box_batch_2d(size_t n, double const *lower, double const *upper, double const *q,
                              double *mu2, double *point)
{
    static constexpr char const *names[] = {"pw85_contact_box_batch_2d", "lower", "upper", "q",
                                            "mu2", "point"};
    return each_row(names, n, pw85_contact_box_2d, RowsOf<2>{lower}, RowsOf<2>{upper}, RowsOf<3>{q},
                    OptionalRowsOf<1>{mu2}, OptionalRowsOf<2>{point});
}

int pw85_overlap_segment_batch_2d(size_t n, double const *end1, double const *end2, double const *q,
                                  unsigned char *overlap)
{
    static constexpr char const *names[] = {"pw85_overlap_segment_batch_2d", "end1", "end2", "q",
                                            "overlap"};
    return each_row(names, n, pw85_overlap_segment_2d, RowsOf<2>{end1}, RowsOf<2>{end2},
                    RowsOf<3>{q}, Bytes{overlap});
}

int pw85_overlap_box_batch_2d(size_t n, double const *lower, double const *upper, double const *q,
                              unsigned char *overlap)
{
    static constexpr char const *names[] = {"pw85_overlap_box_batch_2d", "lower", "upper", "q",
                                            "overlap"};
    return each_row(names, n, pw85_overlap_box_2d, RowsOf<2>{lower}, RowsOf<2>{upper}, RowsOf<3>{q},
                    Bytes{overlap});
}
