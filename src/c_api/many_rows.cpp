// SPDX-License-Identifier: BSD-3-Clause
// The C API: functions of many rows that have no lanes.
//
// Made from pw85.h and api/pw85_batch.h.in by api/committed.py.
#include <pw85_batch.h>

#include "../kernels/each_row.hpp"

using namespace pw85::detail::kernels;

int pw85_contact_rounded_batch(size_t n, double const *r12, double const *q1, double const *q2, double *mu2,
                               double *lambda)
{
    return each_row(n, pw85_contact_rounded, RowsOf<3>{r12}, RowsOf<6>{q1}, RowsOf<6>{q2}, TwoNumbers{mu2, lambda});
}

int pw85_overlap_factored_batch(size_t n, double const *r12, double const *s1, double const *s2, unsigned char *overlap)
{
    return each_row(n, pw85_overlap_factored, RowsOf<3>{r12}, RowsOf<9>{s1}, RowsOf<9>{s2}, Bytes{overlap});
}

int pw85_compare_batch(size_t n, double const *r12, double const *q1, double const *q2, double const *mu2, int *sign)
{
    return each_row(n, pw85_compare, RowsOf<3>{r12}, RowsOf<6>{q1}, RowsOf<6>{q2}, Numbers{mu2}, RowsOf<1, int>{sign});
}

int pw85_overlap_witness_batch(size_t n, double const *r12, double const *q1, double const *q2, unsigned char *overlap,
                               double *lambda, double *point)
{
    return each_row(n, pw85_overlap_witness, RowsOf<3>{r12}, RowsOf<6>{q1}, RowsOf<6>{q2}, Bytes{overlap},
                    OptionalRowsOf<1>{lambda}, OptionalRowsOf<3>{point});
}

int pw85_contains_batch(size_t n, double const *r12, double const *q1, double const *q2, unsigned char *contains)
{
    return each_row(n, pw85_contains, RowsOf<3>{r12}, RowsOf<6>{q1}, RowsOf<6>{q2}, Bytes{contains});
}

int pw85_containment_batch(size_t n, double const *r12, double const *q1, double const *q2, double *mu2, double *point)
{
    return each_row(n, pw85_containment, RowsOf<3>{r12}, RowsOf<6>{q1}, RowsOf<6>{q2}, OptionalRowsOf<1>{mu2},
                    OptionalRowsOf<3>{point});
}

int pw85_free_path_batch(size_t n, double const *r12, double const *q1, double const *q2, double const *directions,
                         double const *t_max, double *t)
{
    return each_row(n, pw85_free_path, RowsOf<3>{r12}, RowsOf<6>{q1}, RowsOf<6>{q2}, RowsOf<3>{directions},
                    Numbers{t_max}, RowsOf<1, double>{t});
}

int pw85_volume_batch(size_t n, double const *q, double *volume)
{
    return each_row(n, pw85_volume, RowsOf<6>{q}, RowsOf<1, double>{volume});
}

int pw85_overlap_volume_batch(size_t n, double const *r12, double const *q1, double const *q2, double *volume)
{
    return each_row(n, pw85_overlap_volume, RowsOf<3>{r12}, RowsOf<6>{q1}, RowsOf<6>{q2}, RowsOf<1, double>{volume});
}

int pw85_overlap_volume_gradient_batch(size_t n, double const *r12, double const *q1, double const *q2, double *d_r12,
                                       double *d_q1, double *d_q2)
{
    return each_row(n, pw85_overlap_volume_gradient, RowsOf<3>{r12}, RowsOf<6>{q1}, RowsOf<6>{q2},
                    OptionalRowsOf<3>{d_r12}, OptionalRowsOf<6>{d_q1}, OptionalRowsOf<6>{d_q2});
}

int pw85_overlap_volume_torque_batch(size_t n, double const *r12, double const *q1, double const *q2, double *d_rot1,
                                     double *d_rot2)
{
    return each_row(n, pw85_overlap_volume_torque, RowsOf<3>{r12}, RowsOf<6>{q1}, RowsOf<6>{q2},
                    OptionalRowsOf<3>{d_rot1}, OptionalRowsOf<3>{d_rot2});
}

int pw85_overlap_volume_plane_batch(size_t n, double const *normals, double const *offsets, double const *q,
                                    double *volume)
{
    return each_row(n, pw85_overlap_volume_plane, RowsOf<3>{normals}, Numbers{offsets}, RowsOf<6>{q},
                    RowsOf<1, double>{volume});
}

int pw85_area_batch_2d(size_t n, double const *q, double *area)
{
    return each_row(n, pw85_area_2d, RowsOf<3>{q}, RowsOf<1, double>{area});
}

int pw85_overlap_area_batch_2d(size_t n, double const *r12, double const *q1, double const *q2, double *area)
{
    return each_row(n, pw85_overlap_area_2d, RowsOf<2>{r12}, RowsOf<3>{q1}, RowsOf<3>{q2}, RowsOf<1, double>{area});
}

int pw85_contact_factored_batch(size_t n, double const *r12, double const *s1, double const *s2, double *mu2,
                                double *lambda)
{
    return each_row(n, pw85_contact_factored, RowsOf<3>{r12}, RowsOf<9>{s1}, RowsOf<9>{s2}, TwoNumbers{mu2, lambda});
}

int pw85_condition_batch(size_t n, double const *r12, double const *q1, double const *q2, double const *lambda,
                         double *cond)
{
    return each_row(n, pw85_condition, RowsOf<3>{r12}, RowsOf<6>{q1}, RowsOf<6>{q2}, Numbers{lambda},
                    RowsOf<1, double>{cond});
}

int pw85_contact_function_batch(size_t n, double const *r12, double const *q1, double const *q2, double *mu2,
                                double *lambda)
{
    return each_row(n, pw85_contact_function, RowsOf<3>{r12}, RowsOf<6>{q1}, RowsOf<6>{q2}, TwoNumbers{mu2, lambda});
}

int pw85_contact_geometry_batch(size_t n, double const *r12, double const *q1, double const *q2, double const *lambda,
                                double *point, double *normal)
{
    return each_row(n, pw85_contact_geometry, RowsOf<3>{r12}, RowsOf<6>{q1}, RowsOf<6>{q2}, Numbers{lambda},
                    OptionalRowsOf<3>{point}, OptionalRowsOf<3>{normal});
}

int pw85_contact_gradient_batch(size_t n, double const *r12, double const *q1, double const *q2, double const *lambda,
                                double *d_r12, double *d_q1, double *d_q2)
{
    return each_row(n, pw85_contact_gradient, RowsOf<3>{r12}, RowsOf<6>{q1}, RowsOf<6>{q2}, Numbers{lambda},
                    OptionalRowsOf<3>{d_r12}, OptionalRowsOf<6>{d_q1}, OptionalRowsOf<6>{d_q2});
}

int pw85_contact_geometry_factored_batch(size_t n, double const *r12, double const *s1, double const *s2,
                                         double const *lambda, double *point, double *normal)
{
    return each_row(n, pw85_contact_geometry_factored, RowsOf<3>{r12}, RowsOf<9>{s1}, RowsOf<9>{s2}, Numbers{lambda},
                    OptionalRowsOf<3>{point}, OptionalRowsOf<3>{normal});
}

int pw85_contact_gradient_factored_batch(size_t n, double const *r12, double const *s1, double const *s2,
                                         double const *lambda, double *d_r12, double *d_s1, double *d_s2)
{
    return each_row(n, pw85_contact_gradient_factored, RowsOf<3>{r12}, RowsOf<9>{s1}, RowsOf<9>{s2}, Numbers{lambda},
                    OptionalRowsOf<3>{d_r12}, OptionalRowsOf<9>{d_s1}, OptionalRowsOf<9>{d_s2});
}

int pw85_contact_torque_batch(size_t n, double const *r12, double const *q1, double const *q2, double const *lambda,
                              double *d_rot1, double *d_rot2)
{
    return each_row(n, pw85_contact_torque, RowsOf<3>{r12}, RowsOf<6>{q1}, RowsOf<6>{q2}, Numbers{lambda},
                    OptionalRowsOf<3>{d_rot1}, OptionalRowsOf<3>{d_rot2});
}

int pw85_contact_hessian_batch(size_t n, double const *r12, double const *q1, double const *q2, double const *lambda,
                               double *hessian)
{
    return each_row(n, pw85_contact_hessian, RowsOf<3>{r12}, RowsOf<6>{q1}, RowsOf<6>{q2}, Numbers{lambda},
                    RowsOf<81, double>{hessian});
}

int pw85_contact_geometry_batch_2d(size_t n, double const *r12, double const *q1, double const *q2,
                                   double const *lambda, double *point, double *normal)
{
    return each_row(n, pw85_contact_geometry_2d, RowsOf<2>{r12}, RowsOf<3>{q1}, RowsOf<3>{q2}, Numbers{lambda},
                    OptionalRowsOf<2>{point}, OptionalRowsOf<2>{normal});
}

int pw85_contact_gradient_batch_2d(size_t n, double const *r12, double const *q1, double const *q2,
                                   double const *lambda, double *d_r12, double *d_q1, double *d_q2)
{
    return each_row(n, pw85_contact_gradient_2d, RowsOf<2>{r12}, RowsOf<3>{q1}, RowsOf<3>{q2}, Numbers{lambda},
                    OptionalRowsOf<2>{d_r12}, OptionalRowsOf<3>{d_q1}, OptionalRowsOf<3>{d_q2});
}

int pw85_contact_torque_batch_2d(size_t n, double const *r12, double const *q1, double const *q2, double const *lambda,
                                 double *d_rot1, double *d_rot2)
{
    return each_row(n, pw85_contact_torque_2d, RowsOf<2>{r12}, RowsOf<3>{q1}, RowsOf<3>{q2}, Numbers{lambda},
                    OptionalRowsOf<1>{d_rot1}, OptionalRowsOf<1>{d_rot2});
}

int pw85_contact_hessian_batch_2d(size_t n, double const *r12, double const *q1, double const *q2, double const *lambda,
                                  double *hessian)
{
    return each_row(n, pw85_contact_hessian_2d, RowsOf<2>{r12}, RowsOf<3>{q1}, RowsOf<3>{q2}, Numbers{lambda},
                    RowsOf<16, double>{hessian});
}

int pw85_closest_approach_batch_2d(size_t n, double const *directions, double const *q1, double const *q2,
                                   double *distance)
{
    return each_row(n, pw85_closest_approach_2d, RowsOf<2>{directions}, RowsOf<3>{q1}, RowsOf<3>{q2},
                    RowsOf<1, double>{distance});
}

int pw85_distance_derivatives_batch(size_t n, double const *r12, double const *q1, double const *q2, double *d_r12,
                                    double *d_rot1, double *d_rot2, double *hessian)
{
    return each_row(n, pw85_distance_derivatives, RowsOf<3>{r12}, RowsOf<6>{q1}, RowsOf<6>{q2},
                    OptionalRowsOf<3>{d_r12}, OptionalRowsOf<3>{d_rot1}, OptionalRowsOf<3>{d_rot2},
                    OptionalRowsOf<81>{hessian});
}

int pw85_distance_batch_2d(size_t n, double const *r12, double const *q1, double const *q2, double *distance,
                           double *point1, double *point2)
{
    return each_row(n, pw85_distance_2d, RowsOf<2>{r12}, RowsOf<3>{q1}, RowsOf<3>{q2}, OptionalRowsOf<1>{distance},
                    OptionalRowsOf<2>{point1}, OptionalRowsOf<2>{point2});
}

int pw85_penetration_batch(size_t n, double const *r12, double const *q1, double const *q2, double *depth,
                           double *direction)
{
    return each_row(n, pw85_penetration, RowsOf<3>{r12}, RowsOf<6>{q1}, RowsOf<6>{q2}, OptionalRowsOf<1>{depth},
                    OptionalRowsOf<3>{direction});
}

int pw85_signed_distance_batch(size_t n, double const *r12, double const *q1, double const *q2, double *distance,
                               double *point1, double *point2)
{
    return each_row(n, pw85_signed_distance, RowsOf<3>{r12}, RowsOf<6>{q1}, RowsOf<6>{q2}, OptionalRowsOf<1>{distance},
                    OptionalRowsOf<3>{point1}, OptionalRowsOf<3>{point2});
}

int pw85_signed_distance_derivatives_batch(size_t n, double const *r12, double const *q1, double const *q2,
                                           double *d_r12, double *d_rot1, double *d_rot2, double *hessian)
{
    return each_row(n, pw85_signed_distance_derivatives, RowsOf<3>{r12}, RowsOf<6>{q1}, RowsOf<6>{q2},
                    OptionalRowsOf<3>{d_r12}, OptionalRowsOf<3>{d_rot1}, OptionalRowsOf<3>{d_rot2},
                    OptionalRowsOf<81>{hessian});
}

int pw85_curvature_batch(size_t n, double const *normals, double const *q, double *curvatures, double *directions)
{
    return each_row(n, pw85_curvature, RowsOf<3>{normals}, RowsOf<6>{q}, OptionalRowsOf<2>{curvatures},
                    OptionalRowsOf<6>{directions});
}

int pw85_hertz_batch(size_t n, double const *curvatures, double *radius, double *ellipse)
{
    return each_row(n, pw85_hertz, RowsOf<2>{curvatures}, OptionalRowsOf<1>{radius}, OptionalRowsOf<2>{ellipse});
}

int pw85_hertz_contact_batch(size_t n, double const *r12, double const *q1, double const *q2, double const *normals,
                             double *depth, double *point, double *curvatures, double *directions, double *radius,
                             double *ellipse)
{
    return each_row(n, pw85_hertz_contact, RowsOf<3>{r12}, RowsOf<6>{q1}, RowsOf<6>{q2}, RowsOf<3>{normals},
                    OptionalRowsOf<1>{depth}, OptionalRowsOf<3>{point}, OptionalRowsOf<2>{curvatures},
                    OptionalRowsOf<6>{directions}, OptionalRowsOf<1>{radius}, OptionalRowsOf<2>{ellipse});
}

int pw85_distance_plane_batch(size_t n, double const *normals, double const *offsets, double const *q, double *distance,
                              double *point)
{
    return each_row(n, pw85_distance_plane, RowsOf<3>{normals}, Numbers{offsets}, RowsOf<6>{q},
                    OptionalRowsOf<1>{distance}, OptionalRowsOf<3>{point});
}

int pw85_distance_plane_derivatives_batch(size_t n, double const *normals, double const *q, double *d_center,
                                          double *d_rot)
{
    return each_row(n, pw85_distance_plane_derivatives, RowsOf<3>{normals}, RowsOf<6>{q}, OptionalRowsOf<3>{d_center},
                    OptionalRowsOf<3>{d_rot});
}

int pw85_contact_plane_batch(size_t n, double const *normals, double const *offsets, double const *q, double *mu2,
                             double *point)
{
    return each_row(n, pw85_contact_plane, RowsOf<3>{normals}, Numbers{offsets}, RowsOf<6>{q}, OptionalRowsOf<1>{mu2},
                    OptionalRowsOf<3>{point});
}

int pw85_contact_plane_derivatives_batch(size_t n, double const *normals, double const *offsets, double const *q,
                                         double *d_center, double *d_rot)
{
    return each_row(n, pw85_contact_plane_derivatives, RowsOf<3>{normals}, Numbers{offsets}, RowsOf<6>{q},
                    OptionalRowsOf<3>{d_center}, OptionalRowsOf<3>{d_rot});
}

int pw85_distance_box_batch(size_t n, double const *lower, double const *upper, double const *q, double *distance,
                            double *point, double *normal)
{
    return each_row(n, pw85_distance_box, RowsOf<3>{lower}, RowsOf<3>{upper}, RowsOf<6>{q}, OptionalRowsOf<1>{distance},
                    OptionalRowsOf<3>{point}, OptionalRowsOf<3>{normal});
}

int pw85_distance_cylinder_batch(size_t n, double const *axis, double const *radius, double const *center,
                                 double const *q, double *distance, double *point, double *normal)
{
    return each_row(n, pw85_distance_cylinder, RowsOf<3>{axis}, Numbers{radius}, RowsOf<3>{center}, RowsOf<6>{q},
                    OptionalRowsOf<1>{distance}, OptionalRowsOf<3>{point}, OptionalRowsOf<3>{normal});
}

int pw85_distance_point_batch(size_t n, double const *r, double const *q, double *distance, double *point,
                              double *normal)
{
    return each_row(n, pw85_distance_point, RowsOf<3>{r}, RowsOf<6>{q}, OptionalRowsOf<1>{distance},
                    OptionalRowsOf<3>{point}, OptionalRowsOf<3>{normal});
}

int pw85_intersect_line_batch(size_t n, double const *origin, double const *directions, double const *q, double *enter,
                              double *leave)
{
    return each_row(n, pw85_intersect_line, RowsOf<3>{origin}, RowsOf<3>{directions}, RowsOf<6>{q},
                    TwoNumbers{enter, leave});
}

int pw85_first_contact_batch(size_t n, double const *r12, double const *q1, double const *q2,
                             pw85_motion const *motion1, pw85_motion const *motion2, double t_max, double *t)
{
    return each_row(n, pw85_first_contact, RowsOf<3>{r12}, RowsOf<6>{q1}, RowsOf<6>{q2},
                    RowsOf<1, pw85_motion const>{motion1}, RowsOf<1, pw85_motion const>{motion2}, SameNumber{t_max},
                    RowsOf<1, double>{t});
}

int pw85_ellipsoid_factor_batch(size_t n, double const *semi_axes, double const *quaternions, double *s)
{
    return each_row(n, pw85_ellipsoid_factor, RowsOf<3>{semi_axes}, RowsOf<4>{quaternions}, RowsOf<9, double>{s});
}

int pw85_ellipsoid_quaternion_batch(size_t n, double const *semi_axes, double const *quaternions, double *q)
{
    return each_row(n, pw85_ellipsoid_quaternion, RowsOf<3>{semi_axes}, RowsOf<4>{quaternions}, RowsOf<6, double>{q});
}
