/// @file
/// Functions of many pairs, ellipsoids, points or lines, one row for each: the functions of pw85.h, on spans.
///
/// Made from pw85.h by api/committed.py.
#ifndef PW85_BATCH_ROWS_HPP_INCLUDED
#define PW85_BATCH_ROWS_HPP_INCLUDED

#include <pw85/batch/calls.hpp>

namespace pw85 {

/// @name Contact of two ellipsoids
/// @{

/// volume() for many ellipsoids: see pw85_volume_batch().
///
/// @param q one for each ellipsoid
/// @param[out] volume one for each ellipsoid
/// @return Status::success, or the status of the first bad ellipsoid; Status::invalid_argument if a pointer is null and
/// n > 0
static inline Status volume_batch(Forms q, std::span<double> volume) noexcept
{
    return detail::call_rows(pw85_volume_batch, q, volume);
}

/// overlap_volume() for many pairs: see pw85_overlap_volume_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] volume one for each pair
/// @return as for contact_batch()
static inline Status overlap_volume_batch(Vectors r12, Forms q1, Forms q2, std::span<double> volume) noexcept
{
    return detail::call_rows(pw85_overlap_volume_batch, r12, q1, q2, volume);
}

/// overlap_volume_gradient() for many pairs: see pw85_overlap_volume_gradient_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] d_r12,d_q1,d_q2 one for each pair, or empty
/// @return as for contact_batch()
static inline Status overlap_volume_gradient_batch(Vectors r12, Forms q1, Forms q2, std::span<Vector<double, 3>> d_r12,
                                                   std::span<SymmetricMatrix<double, 3>> d_q1 = {},
                                                   std::span<SymmetricMatrix<double, 3>> d_q2 = {}) noexcept
{
    return detail::call_rows(pw85_overlap_volume_gradient_batch, r12, q1, q2, d_r12, d_q1, d_q2);
}

/// overlap_volume_torque() for many pairs: see pw85_overlap_volume_torque_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] d_rot1,d_rot2 one for each pair, or empty
/// @return as for contact_batch()
static inline Status overlap_volume_torque_batch(Vectors r12, Forms q1, Forms q2, std::span<Vector<double, 3>> d_rot1,
                                                 std::span<Vector<double, 3>> d_rot2 = {}) noexcept
{
    return detail::call_rows(pw85_overlap_volume_torque_batch, r12, q1, q2, d_rot1, d_rot2);
}

/// overlap_volume_plane() for many ellipsoids and half-spaces: see pw85_overlap_volume_plane_batch().
///
/// @param normals,offsets,q one for each ellipsoid
/// @param[out] volume one for each ellipsoid
/// @return as for volume_batch()
static inline Status overlap_volume_plane_batch(Vectors normals, std::span<double const> offsets, Forms q,
                                                std::span<double> volume) noexcept
{
    return detail::call_rows(pw85_overlap_volume_plane_batch, normals, offsets, q, volume);
}

/// area() for many ellipses: see pw85_area_batch_2d().
///
/// @param q one for each ellipse
/// @param[out] area one for each ellipse
/// @return as for volume_batch()
static inline Status area_batch(FlatForms q, std::span<double> area) noexcept
{
    return detail::call_rows(pw85_area_batch_2d, q, area);
}

/// overlap_area() for many pairs of ellipses: see pw85_overlap_area_batch_2d().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] area one for each pair
/// @return as for contact_batch()
static inline Status overlap_area_batch(FlatVectors r12, FlatForms q1, FlatForms q2, std::span<double> area) noexcept
{
    return detail::call_rows(pw85_overlap_area_batch_2d, r12, q1, q2, area);
}

/// @}

/// @name Many pairs
/// @{

/// contact() for many pairs: see pw85_contact_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] mu2 one for each pair
/// @param[out] lambda one for each pair, or empty
/// @return Status::success, Status::invalid_argument, or the status of the first bad pair
static inline Status contact_batch(Vectors r12, Forms q1, Forms q2, std::span<double> mu2,
                                   std::span<double> lambda = {}) noexcept
{
    return detail::call_rows(pw85_contact_batch, r12, q1, q2, mu2, lambda);
}

/// overlap() for many pairs: see pw85_overlap_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] overlap one for each pair: 1, 0, or 255 for a bad pair
/// @return as for contact_batch()
static inline Status overlap_batch(Vectors r12, Forms q1, Forms q2, std::span<unsigned char> overlap) noexcept
{
    return detail::call_rows(pw85_overlap_batch, r12, q1, q2, overlap);
}

/// contact_rounded() for many pairs: see pw85_contact_rounded_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] mu2,lambda one for each pair, or empty
/// @return as for contact_batch(), or Status::no_convergence as for contact_rounded()
static inline Status contact_rounded_batch(Vectors r12, Forms q1, Forms q2, std::span<double> mu2,
                                           std::span<double> lambda = {}) noexcept
{
    return detail::call_rows(pw85_contact_rounded_batch, r12, q1, q2, mu2, lambda);
}

/// overlap_factored() for many pairs: see pw85_overlap_factored_batch().
///
/// @param r12,s1,s2 one for each pair
/// @param[out] overlap one for each pair: 1, 0, or 255 for a bad pair
/// @return as for contact_batch(), or Status::no_convergence as for overlap_factored()
static inline Status overlap_factored_batch(Vectors r12, std::span<Factor<double, 3> const> s1,
                                            std::span<Factor<double, 3> const> s2,
                                            std::span<unsigned char> overlap) noexcept
{
    return detail::call_rows(pw85_overlap_factored_batch, r12, s1, s2, overlap);
}

/// compare() for many pairs: see pw85_compare_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param mu2 one for each pair, >= 0; may be infinity
/// @param[out] sign one for each pair: -1, 0 or 1, or 2 for a bad pair
/// @return as for contact_batch()
static inline Status compare_batch(Vectors r12, Forms q1, Forms q2, std::span<double const> mu2,
                                   std::span<int> sign) noexcept
{
    return detail::call_rows(pw85_compare_batch, r12, q1, q2, mu2, sign);
}

/// overlap_witness() for many pairs: see pw85_overlap_witness_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] overlap one for each pair: 1, 0, or 255 for a bad pair
/// @param[out] lambda one for each pair, or empty; NaN where the ellipsoids are not apart
/// @param[out] point one for each pair, or empty; NaN where they do not overlap
/// @return as for contact_batch(), or Status::no_convergence as for overlap_witness()
static inline Status overlap_witness_batch(Vectors r12, Forms q1, Forms q2, std::span<unsigned char> overlap,
                                           std::span<double> lambda = {},
                                           std::span<Vector<double, 3>> point = {}) noexcept
{
    return detail::call_rows(pw85_overlap_witness_batch, r12, q1, q2, overlap, lambda, point);
}

/// contains() for many pairs: see pw85_contains_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] contains one for each pair: 1, 0, or 255 for a bad pair
/// @return as for contact_batch()
static inline Status contains_batch(Vectors r12, Forms q1, Forms q2, std::span<unsigned char> contains) noexcept
{
    return detail::call_rows(pw85_contains_batch, r12, q1, q2, contains);
}

/// containment() for many pairs: see pw85_containment_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] mu2,point one for each pair, or empty
/// @return as for contact_batch()
static inline Status containment_batch(Vectors r12, Forms q1, Forms q2, std::span<double> mu2,
                                       std::span<Vector<double, 3>> point = {}) noexcept
{
    return detail::call_rows(pw85_containment_batch, r12, q1, q2, mu2, point);
}

/// closest_passage() for many pairs: see pw85_closest_passage_batch().
///
/// @param r12,q1,q2,velocity one for each pair
/// @param t_max the end of the time, >= 0; may be infinity
/// @param[out] mu2 one for each pair
/// @param[out] t one for each pair, or empty
/// @return as for contact_batch()
static inline Status closest_passage_batch(Vectors r12, Forms q1, Forms q2, Vectors velocity, double t_max,
                                           std::span<double> mu2, std::span<double> t = {}) noexcept
{
    return detail::call_rows(pw85_closest_passage_batch, r12, q1, q2, velocity, t_max, mu2, t);
}

/// free_path() for many pairs: see pw85_free_path_batch().
///
/// @param r12,q1,q2,direction one for each pair
/// @param t_max one for each pair, each >= 0; may be infinity
/// @param[out] t one for each pair
/// @return as for contact_batch(); the causes of free_path()
static inline Status free_path_batch(Vectors r12, Forms q1, Forms q2, Vectors direction, std::span<double const> t_max,
                                     std::span<double> t) noexcept
{
    return detail::call_rows(pw85_free_path_batch, r12, q1, q2, direction, t_max, t);
}

/// closest_approach() for many pairs: see pw85_closest_approach_batch().
///
/// @param directions one for each pair, of any lengths > 0
/// @param q1,q2 one for each pair
/// @param[out] distance one for each pair
/// @return as for contact_batch(); a zero direction is Status::invalid_argument
static inline Status closest_approach_batch(Vectors directions, Forms q1, Forms q2, std::span<double> distance) noexcept
{
    return detail::call_rows(pw85_closest_approach_batch, directions, q1, q2, distance);
}

/// contact_factored() for many pairs: see pw85_contact_factored_batch().
///
/// @param r12,s1,s2 one for each pair
/// @param[out] mu2,lambda one for each pair, or empty
/// @return as for contact_batch()
static inline Status contact_factored_batch(Vectors r12, std::span<Factor<double, 3> const> s1,
                                            std::span<Factor<double, 3> const> s2, std::span<double> mu2,
                                            std::span<double> lambda = {}) noexcept
{
    return detail::call_rows(pw85_contact_factored_batch, r12, s1, s2, mu2, lambda);
}

/// condition() for many pairs: see pw85_condition_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param lambda one for each pair, as contact_batch() returns them
/// @param[out] cond one for each pair
/// @return as for contact_batch()
static inline Status condition_batch(Vectors r12, Forms q1, Forms q2, std::span<double const> lambda,
                                     std::span<double> cond) noexcept
{
    return detail::call_rows(pw85_condition_batch, r12, q1, q2, lambda, cond);
}

/// pw85_contact_function() for many pairs: see pw85_contact_function_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] mu2,lambda one for each pair, or empty
/// @return as for contact_batch()
static inline Status contact_function_batch(Vectors r12, Forms q1, Forms q2, std::span<double> mu2,
                                            std::span<double> lambda = {}) noexcept
{
    return detail::call_rows(pw85_contact_function_batch, r12, q1, q2, mu2, lambda);
}

/// contact_geometry() for many pairs: see pw85_contact_geometry_batch().
///
/// @param r12 one for each pair, r12 != 0
/// @param q1,q2,lambda one for each pair
/// @param[out] point,normal one for each pair, or empty
/// @return as for contact_batch(); r12 = 0 and lambda outside [0, 1] are Status::invalid_argument
static inline Status contact_geometry_batch(Vectors r12, Forms q1, Forms q2, std::span<double const> lambda,
                                            std::span<Vector<double, 3>> point,
                                            std::span<Vector<double, 3>> normal = {}) noexcept
{
    return detail::call_rows(pw85_contact_geometry_batch, r12, q1, q2, lambda, point, normal);
}

/// contact_gradient() for many pairs: see pw85_contact_gradient_batch().
///
/// @param r12,q1,q2,lambda one for each pair
/// @param[out] d_r12,d_q1,d_q2 one for each pair, or empty
/// @return as for contact_batch(); lambda outside [0, 1] is Status::invalid_argument
static inline Status contact_gradient_batch(Vectors r12, Forms q1, Forms q2, std::span<double const> lambda,
                                            std::span<Vector<double, 3>> d_r12,
                                            std::span<SymmetricMatrix<double, 3>> d_q1 = {},
                                            std::span<SymmetricMatrix<double, 3>> d_q2 = {}) noexcept
{
    return detail::call_rows(pw85_contact_gradient_batch, r12, q1, q2, lambda, d_r12, d_q1, d_q2);
}

/// contact_geometry_factored() for many pairs: see pw85_contact_geometry_factored_batch().
///
/// @param r12 one for each pair, r12 != 0
/// @param s1,s2,lambda one for each pair
/// @param[out] point,normal one for each pair, or empty
/// @return as for contact_batch(); r12 = 0 and lambda outside [0, 1] are Status::invalid_argument
static inline Status contact_geometry_factored_batch(Vectors r12, std::span<Factor<double, 3> const> s1,
                                                     std::span<Factor<double, 3> const> s2,
                                                     std::span<double const> lambda, std::span<Vector<double, 3>> point,
                                                     std::span<Vector<double, 3>> normal = {}) noexcept
{
    return detail::call_rows(pw85_contact_geometry_factored_batch, r12, s1, s2, lambda, point, normal);
}

/// contact_gradient_factored() for many pairs: see pw85_contact_gradient_factored_batch().
///
/// @param r12,s1,s2,lambda one for each pair
/// @param[out] d_r12,d_s1,d_s2 one for each pair, or empty
/// @return as for contact_batch(); lambda outside [0, 1] is Status::invalid_argument
static inline Status contact_gradient_factored_batch(Vectors r12, std::span<Factor<double, 3> const> s1,
                                                     std::span<Factor<double, 3> const> s2,
                                                     std::span<double const> lambda, std::span<Vector<double, 3>> d_r12,
                                                     std::span<Factor<double, 3>> d_s1 = {},
                                                     std::span<Factor<double, 3>> d_s2 = {}) noexcept
{
    return detail::call_rows(pw85_contact_gradient_factored_batch, r12, s1, s2, lambda, d_r12, d_s1, d_s2);
}

/// contact_torque() for many pairs: see pw85_contact_torque_batch().
///
/// @param r12,q1,q2,lambda one for each pair
/// @param[out] d_rot1,d_rot2 one for each pair, or empty
/// @return as for contact_gradient_batch()
static inline Status contact_torque_batch(Vectors r12, Forms q1, Forms q2, std::span<double const> lambda,
                                          std::span<Vector<double, 3>> d_rot1,
                                          std::span<Vector<double, 3>> d_rot2 = {}) noexcept
{
    return detail::call_rows(pw85_contact_torque_batch, r12, q1, q2, lambda, d_rot1, d_rot2);
}

/// contact_hessian() for many pairs: see pw85_contact_hessian_batch().
///
/// @param r12 one for each pair, r12 != 0
/// @param q1,q2,lambda one for each pair
/// @param[out] hessian one for each pair
/// @return as for contact_batch(); r12 = 0 and lambda outside [0, 1] are Status::invalid_argument
static inline Status contact_hessian_batch(Vectors r12, Forms q1, Forms q2, std::span<double const> lambda,
                                           std::span<std::array<double, 81>> hessian) noexcept
{
    return detail::call_rows(pw85_contact_hessian_batch, r12, q1, q2, lambda, hessian);
}

/// contact() for many pairs of ellipses: see pw85_contact_batch_2d().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] mu2 one for each pair
/// @param[out] lambda one for each pair, or empty
/// @return Status::success, Status::invalid_argument, or the status of the first bad pair
static inline Status contact_batch(FlatVectors r12, FlatForms q1, FlatForms q2, std::span<double> mu2,
                                   std::span<double> lambda = {}) noexcept
{
    return detail::call_rows(pw85_contact_batch_2d, r12, q1, q2, mu2, lambda);
}

/// overlap() for many pairs of ellipses: see pw85_overlap_batch_2d().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] overlap one for each pair: 1, 0, or 255 for a bad pair
/// @return as for contact_batch()
static inline Status overlap_batch(FlatVectors r12, FlatForms q1, FlatForms q2,
                                   std::span<unsigned char> overlap) noexcept
{
    return detail::call_rows(pw85_overlap_batch_2d, r12, q1, q2, overlap);
}

/// contact_geometry() for many pairs of ellipses: see pw85_contact_geometry_batch_2d().
///
/// @param r12 one for each pair, r12 != 0
/// @param q1,q2,lambda one for each pair
/// @param[out] point,normal one for each pair, or empty
/// @return as for contact_batch(); r12 = 0 and lambda outside [0, 1] are Status::invalid_argument
static inline Status contact_geometry_batch(FlatVectors r12, FlatForms q1, FlatForms q2, std::span<double const> lambda,
                                            std::span<Vector<double, 2>> point,
                                            std::span<Vector<double, 2>> normal = {}) noexcept
{
    return detail::call_rows(pw85_contact_geometry_batch_2d, r12, q1, q2, lambda, point, normal);
}

/// contact_gradient() for many pairs of ellipses: see pw85_contact_gradient_batch_2d().
///
/// @param r12,q1,q2,lambda one for each pair
/// @param[out] d_r12,d_q1,d_q2 one for each pair, or empty
/// @return as for contact_gradient_batch()
static inline Status contact_gradient_batch(FlatVectors r12, FlatForms q1, FlatForms q2, std::span<double const> lambda,
                                            std::span<Vector<double, 2>> d_r12,
                                            std::span<SymmetricMatrix<double, 2>> d_q1 = {},
                                            std::span<SymmetricMatrix<double, 2>> d_q2 = {}) noexcept
{
    return detail::call_rows(pw85_contact_gradient_batch_2d, r12, q1, q2, lambda, d_r12, d_q1, d_q2);
}

/// contact_torque() for many pairs of ellipses: see pw85_contact_torque_batch_2d().
///
/// @param r12,q1,q2,lambda one for each pair
/// @param[out] d_rot1,d_rot2 one for each pair, or empty
/// @return as for contact_gradient_batch()
static inline Status contact_torque_batch(FlatVectors r12, FlatForms q1, FlatForms q2, std::span<double const> lambda,
                                          std::span<double> d_rot1, std::span<double> d_rot2 = {}) noexcept
{
    return detail::call_rows(pw85_contact_torque_batch_2d, r12, q1, q2, lambda, d_rot1, d_rot2);
}

/// contact_hessian() for many pairs of ellipses: see pw85_contact_hessian_batch_2d().
///
/// @param r12 one for each pair, r12 != 0
/// @param q1,q2,lambda one for each pair
/// @param[out] hessian one for each pair
/// @return as for contact_batch(); r12 = 0 and lambda outside [0, 1] are Status::invalid_argument
static inline Status contact_hessian_batch(FlatVectors r12, FlatForms q1, FlatForms q2, std::span<double const> lambda,
                                           std::span<std::array<double, 16>> hessian) noexcept
{
    return detail::call_rows(pw85_contact_hessian_batch_2d, r12, q1, q2, lambda, hessian);
}

/// closest_approach() for many pairs of ellipses: see pw85_closest_approach_batch_2d().
///
/// @param directions one for each pair, of any lengths > 0
/// @param q1,q2 one for each pair
/// @param[out] distance one for each pair
/// @return as for closest_approach_batch()
static inline Status closest_approach_batch(FlatVectors directions, FlatForms q1, FlatForms q2,
                                            std::span<double> distance) noexcept
{
    return detail::call_rows(pw85_closest_approach_batch_2d, directions, q1, q2, distance);
}

/// contact(), contact_geometry(), contact_gradient() and contact_torque() for many pairs: see
/// pw85_contact_derivatives_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] out one row for each pair in all spans, or in some: see pw85_contact_derivatives_batch()
/// @return as for contact_batch()
static inline Status contact_derivatives_batch(Vectors r12, Forms q1, Forms q2, DerivativeSpans const &out) noexcept
{
    return detail::call_rows(pw85_contact_derivatives_batch, r12, q1, q2, out.mu2, out.lambda, out.point, out.normal,
                             out.d_r12, out.d_rot1, out.d_rot2);
}

/// distance() for many pairs: see pw85_distance_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] distance one for each pair, or empty
/// @param[out] point1,point2 one for each pair, or empty, relative to the centres of the first ellipsoids
/// @return as for contact_batch(); Status::no_convergence, too
static inline Status distance_batch(Vectors r12, Forms q1, Forms q2, std::span<double> distance,
                                    std::span<Vector<double, 3>> point1 = {},
                                    std::span<Vector<double, 3>> point2 = {}) noexcept
{
    return detail::call_rows(pw85_distance_batch, r12, q1, q2, distance, point1, point2);
}

/// distance_derivatives() for many pairs: see pw85_distance_derivatives_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] d_r12,d_rot1,d_rot2,hessian one for each pair, or empty
/// @return as for contact_batch()
static inline Status distance_derivatives_batch(Vectors r12, Forms q1, Forms q2, std::span<Vector<double, 3>> d_r12,
                                                std::span<Vector<double, 3>> d_rot1 = {},
                                                std::span<Vector<double, 3>> d_rot2 = {},
                                                std::span<std::array<double, 81>> hessian = {}) noexcept
{
    return detail::call_rows(pw85_distance_derivatives_batch, r12, q1, q2, d_r12, d_rot1, d_rot2, hessian);
}

/// distance() for many pairs of ellipses: see pw85_distance_batch_2d().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] distance,point1,point2 one for each pair, or empty
/// @return as for contact_batch()
static inline Status distance_batch(FlatVectors r12, FlatForms q1, FlatForms q2, std::span<double> distance,
                                    std::span<Vector<double, 2>> point1 = {},
                                    std::span<Vector<double, 2>> point2 = {}) noexcept
{
    return detail::call_rows(pw85_distance_batch_2d, r12, q1, q2, distance, point1, point2);
}

/// penetration() for many pairs: see pw85_penetration_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] depth one for each pair, or empty
/// @param[out] direction one for each pair, or empty; NaN for pairs that do not overlap
/// @return as for contact_batch(); Status::no_convergence, too
static inline Status penetration_batch(Vectors r12, Forms q1, Forms q2, std::span<double> depth,
                                       std::span<Vector<double, 3>> direction = {}) noexcept
{
    return detail::call_rows(pw85_penetration_batch, r12, q1, q2, depth, direction);
}

/// signed_distance() for many pairs: see pw85_signed_distance_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] distance,point1,point2 one for each pair, or empty
/// @return as for contact_batch(); Status::no_convergence, too
static inline Status signed_distance_batch(Vectors r12, Forms q1, Forms q2, std::span<double> distance,
                                           std::span<Vector<double, 3>> point1 = {},
                                           std::span<Vector<double, 3>> point2 = {}) noexcept
{
    return detail::call_rows(pw85_signed_distance_batch, r12, q1, q2, distance, point1, point2);
}

/// signed_distance_derivatives() for many pairs: see pw85_signed_distance_derivatives_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] d_r12,d_rot1,d_rot2,hessian one for each pair, or empty
/// @return as for contact_batch(); Status::no_convergence, too
static inline Status signed_distance_derivatives_batch(Vectors r12, Forms q1, Forms q2,
                                                       std::span<Vector<double, 3>> d_r12,
                                                       std::span<Vector<double, 3>> d_rot1 = {},
                                                       std::span<Vector<double, 3>> d_rot2 = {},
                                                       std::span<std::array<double, 81>> hessian = {}) noexcept
{
    return detail::call_rows(pw85_signed_distance_derivatives_batch, r12, q1, q2, d_r12, d_rot1, d_rot2, hessian);
}

/// curvature() for many ellipsoids: see pw85_curvature_batch().
///
/// @param normals one for each ellipsoid, of any lengths > 0
/// @param q one for each ellipsoid
/// @param[out] curvatures,directions one for each ellipsoid, or empty
/// @return as for contact_batch(); a zero normal is Status::invalid_argument
static inline Status curvature_batch(Vectors normals, Forms q, std::span<std::array<double, 2>> curvatures,
                                     std::span<std::array<double, 6>> directions = {}) noexcept
{
    return detail::call_rows(pw85_curvature_batch, normals, q, curvatures, directions);
}

/// hertz() for many contacts: see pw85_hertz_batch().
///
/// @param curvatures one for each contact, > 0
/// @param[out] radius,ellipse one for each contact, or empty
/// @return as for contact_batch(); a curvature that is not positive is Status::invalid_argument
static inline Status hertz_batch(std::span<std::array<double, 2> const> curvatures, std::span<double> radius,
                                 std::span<std::array<double, 2>> ellipse = {}) noexcept
{
    return detail::call_rows(pw85_hertz_batch, curvatures, radius, ellipse);
}

/// hertz_contact() for many pairs: see pw85_hertz_contact_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param normals one for each pair, of any lengths > 0
/// @param[out] depth,point,curvatures,directions,radius,ellipse one for each pair, or empty
/// @return as for contact_batch(); a zero normal is Status::invalid_argument
static inline Status hertz_contact_batch(Vectors r12, Forms q1, Forms q2, Vectors normals, std::span<double> depth,
                                         std::span<Vector<double, 3>> point = {},
                                         std::span<std::array<double, 2>> curvatures = {},
                                         std::span<std::array<double, 6>> directions = {},
                                         std::span<double> radius = {},
                                         std::span<std::array<double, 2>> ellipse = {}) noexcept
{
    return detail::call_rows(pw85_hertz_contact_batch, r12, q1, q2, normals, depth, point, curvatures, directions,
                             radius, ellipse);
}

/// distance_plane() for many ellipsoids and half-spaces: see pw85_distance_plane_batch().
///
/// @param normals,offsets,q one for each ellipsoid
/// @param[out] distance,point one for each ellipsoid, or empty
/// @return as for contact_batch(); a zero normal is Status::invalid_argument
static inline Status distance_plane_batch(Vectors normals, std::span<double const> offsets, Forms q,
                                          std::span<double> distance, std::span<Vector<double, 3>> point = {}) noexcept
{
    return detail::call_rows(pw85_distance_plane_batch, normals, offsets, q, distance, point);
}

/// distance_plane_derivatives() for many ellipsoids and half-spaces: see pw85_distance_plane_derivatives_batch().
///
/// @param normals,q one for each ellipsoid
/// @param[out] d_center,d_rot one for each ellipsoid, or empty
/// @return as for distance_plane_batch()
static inline Status distance_plane_derivatives_batch(Vectors normals, Forms q, std::span<Vector<double, 3>> d_center,
                                                      std::span<Vector<double, 3>> d_rot = {}) noexcept
{
    return detail::call_rows(pw85_distance_plane_derivatives_batch, normals, q, d_center, d_rot);
}

/// contact_plane() for many ellipsoids and half-spaces: see pw85_contact_plane_batch().
///
/// @param normals,offsets,q one for each ellipsoid
/// @param[out] mu2,point one for each ellipsoid, or empty
/// @return as for distance_plane_batch()
static inline Status contact_plane_batch(Vectors normals, std::span<double const> offsets, Forms q,
                                         std::span<double> mu2, std::span<Vector<double, 3>> point = {}) noexcept
{
    return detail::call_rows(pw85_contact_plane_batch, normals, offsets, q, mu2, point);
}

/// contact_plane_derivatives() for many ellipsoids and half-spaces: see pw85_contact_plane_derivatives_batch().
///
/// @param normals,offsets,q one for each ellipsoid
/// @param[out] d_center,d_rot one for each ellipsoid, or empty
/// @return as for distance_plane_batch()
static inline Status contact_plane_derivatives_batch(Vectors normals, std::span<double const> offsets, Forms q,
                                                     std::span<Vector<double, 3>> d_center,
                                                     std::span<Vector<double, 3>> d_rot = {}) noexcept
{
    return detail::call_rows(pw85_contact_plane_derivatives_batch, normals, offsets, q, d_center, d_rot);
}

/// distance_box() for many ellipsoids and boxes: see pw85_distance_box_batch().
///
/// @param lower,upper one for each ellipsoid; lower <= upper
/// @param q one for each ellipsoid
/// @param[out] distance,point,normal one for each ellipsoid, or empty
/// @return as for contact_batch(); lower > upper is Status::invalid_argument
static inline Status distance_box_batch(Vectors lower, Vectors upper, Forms q, std::span<double> distance,
                                        std::span<Vector<double, 3>> point = {},
                                        std::span<Vector<double, 3>> normal = {}) noexcept
{
    return detail::call_rows(pw85_distance_box_batch, lower, upper, q, distance, point, normal);
}

/// distance_cylinder() for many ellipsoids and cylinders: see pw85_distance_cylinder_batch().
///
/// @param axis one for each ellipsoid, of any lengths > 0
/// @param radius one for each ellipsoid, > 0
/// @param center,q one for each ellipsoid
/// @param[out] distance,point,normal one for each ellipsoid, or empty
/// @return as for contact_batch(); a zero axis and a radius that is not positive are Status::invalid_argument
static inline Status distance_cylinder_batch(Vectors axis, std::span<double const> radius, Vectors center, Forms q,
                                             std::span<double> distance, std::span<Vector<double, 3>> point = {},
                                             std::span<Vector<double, 3>> normal = {}) noexcept
{
    return detail::call_rows(pw85_distance_cylinder_batch, axis, radius, center, q, distance, point, normal);
}

/// distance_point() for many points and ellipsoids: see pw85_distance_point_batch().
///
/// @param r,q one for each point
/// @param[out] distance,point,normal one for each point, or empty
/// @return as for contact_batch()
static inline Status distance_point_batch(Vectors r, Forms q, std::span<double> distance,
                                          std::span<Vector<double, 3>> point = {},
                                          std::span<Vector<double, 3>> normal = {}) noexcept
{
    return detail::call_rows(pw85_distance_point_batch, r, q, distance, point, normal);
}

/// intersect_line() for many lines and ellipsoids: see pw85_intersect_line_batch().
///
/// @param origin one for each line
/// @param directions one for each line, of any lengths > 0
/// @param q one for each line
/// @param[out] enter,leave one for each line, or empty: where a line enters and leaves, as t; NaN if it misses its
/// ellipsoid
/// @return as for contact_batch(); a zero direction is Status::invalid_argument
static inline Status intersect_line_batch(Vectors origin, Vectors directions, Forms q, std::span<double> enter,
                                          std::span<double> leave = {}) noexcept
{
    return detail::call_rows(pw85_intersect_line_batch, origin, directions, q, enter, leave);
}

/// contact_segment() for many ellipsoids and segments: see pw85_contact_segment_batch().
///
/// @param end1,end2,q one for each ellipsoid
/// @param[out] mu2,point one for each ellipsoid, or empty
/// @return as for contact_batch()
static inline Status contact_segment_batch(Vectors end1, Vectors end2, Forms q, std::span<double> mu2,
                                           std::span<Vector<double, 3>> point = {}) noexcept
{
    return detail::call_rows(pw85_contact_segment_batch, end1, end2, q, mu2, point);
}

/// contact_triangle() for many ellipsoids and triangles: see pw85_contact_triangle_batch().
///
/// @param vertex1,vertex2,vertex3,q one for each ellipsoid
/// @param[out] mu2,point one for each ellipsoid, or empty
/// @return as for contact_batch()
static inline Status contact_triangle_batch(Vectors vertex1, Vectors vertex2, Vectors vertex3, Forms q,
                                            std::span<double> mu2, std::span<Vector<double, 3>> point = {}) noexcept
{
    return detail::call_rows(pw85_contact_triangle_batch, vertex1, vertex2, vertex3, q, mu2, point);
}

/// contact_box() for many ellipsoids and boxes: see pw85_contact_box_batch().
///
/// @param lower,upper one for each ellipsoid; lower <= upper
/// @param q one for each ellipsoid
/// @param[out] mu2,point one for each ellipsoid, or empty
/// @return as for contact_batch(); lower > upper is Status::invalid_argument
static inline Status contact_box_batch(Vectors lower, Vectors upper, Forms q, std::span<double> mu2,
                                       std::span<Vector<double, 3>> point = {}) noexcept
{
    return detail::call_rows(pw85_contact_box_batch, lower, upper, q, mu2, point);
}

/// overlap_segment() for many ellipsoids and segments: see pw85_overlap_segment_batch().
///
/// @param end1,end2,q one for each ellipsoid
/// @param[out] overlap one for each ellipsoid: 1 or 0, 255 for a bad row
/// @return as for contact_batch()
static inline Status overlap_segment_batch(Vectors end1, Vectors end2, Forms q,
                                           std::span<unsigned char> overlap) noexcept
{
    return detail::call_rows(pw85_overlap_segment_batch, end1, end2, q, overlap);
}

/// overlap_triangle() for many ellipsoids and triangles: see pw85_overlap_triangle_batch().
///
/// @param vertex1,vertex2,vertex3,q one for each ellipsoid
/// @param[out] overlap one for each ellipsoid: 1 or 0, 255 for a bad row
/// @return as for contact_batch()
static inline Status overlap_triangle_batch(Vectors vertex1, Vectors vertex2, Vectors vertex3, Forms q,
                                            std::span<unsigned char> overlap) noexcept
{
    return detail::call_rows(pw85_overlap_triangle_batch, vertex1, vertex2, vertex3, q, overlap);
}

/// overlap_box() for many ellipsoids and boxes: see pw85_overlap_box_batch().
///
/// @param lower,upper one for each ellipsoid; lower <= upper
/// @param q one for each ellipsoid
/// @param[out] overlap one for each ellipsoid: 1 or 0, 255 for a bad row
/// @return as for contact_batch(); lower > upper is Status::invalid_argument
static inline Status overlap_box_batch(Vectors lower, Vectors upper, Forms q, std::span<unsigned char> overlap) noexcept
{
    return detail::call_rows(pw85_overlap_box_batch, lower, upper, q, overlap);
}

/// first_contact() for many pairs: see pw85_first_contact_batch().
///
/// @param r12,q1,q2,motion1,motion2 one for each pair
/// @param t_max the time up to which contacts count, >= 0; may be infinity
/// @param[out] t one for each pair
/// @return as for contact_batch(); Status::no_convergence, too
static inline Status first_contact_batch(Vectors r12, Forms q1, Forms q2, std::span<Motion<double, 3> const> motion1,
                                         std::span<Motion<double, 3> const> motion2, double t_max,
                                         std::span<double> t) noexcept
{
    return detail::call_rows(pw85_first_contact_batch, r12, q1, q2, motion1, motion2, t_max, t);
}

/// @}

/// @name Many forms
/// @{

/// ellipsoid_factor() for many ellipsoids: see pw85_ellipsoid_factor_batch().
///
/// @param semi_axes one for each ellipsoid, as for ellipsoid_factor()
/// @param quaternions one for each ellipsoid: (w, x, y, z), of any lengths > 0
/// @param[out] s one for each ellipsoid
/// @return Status::success, Status::invalid_argument
static inline Status ellipsoid_factor_batch(Vectors semi_axes, std::span<Vector<double, 4> const> quaternions,
                                            std::span<Factor<double, 3>> s) noexcept
{
    return detail::call_rows(pw85_ellipsoid_factor_batch, semi_axes, quaternions, s);
}

/// ellipsoid_quaternion() for many ellipsoids: see pw85_ellipsoid_quaternion_batch().
///
/// @param semi_axes one for each ellipsoid, as for ellipsoid_quaternion()
/// @param quaternions one for each ellipsoid: (w, x, y, z), of any lengths > 0
/// @param[out] q one for each ellipsoid
/// @return Status::success, Status::invalid_argument
static inline Status ellipsoid_quaternion_batch(Vectors semi_axes, std::span<Vector<double, 4> const> quaternions,
                                                std::span<SymmetricMatrix<double, 3>> q) noexcept
{
    return detail::call_rows(pw85_ellipsoid_quaternion_batch, semi_axes, quaternions, q);
}

/// Tight boxes, with sides along the axes, around many ellipsoids: see pw85_bounding_boxes().
///
/// @param q one for each ellipsoid
/// @param[out] half_widths one for each ellipsoid: √Qxx, √Qyy, √Qzz, in the unit of the semi-axes
/// @return Status::success, Status::invalid_argument, or the status of the first bad form
static inline Status bounding_boxes(Forms q, std::span<Vector<double, 3>> half_widths) noexcept
{
    return detail::call_rows(pw85_bounding_boxes, q, half_widths);
}

/// @}

} // namespace pw85

#endif
