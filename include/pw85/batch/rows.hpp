// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Functions of many pairs, ellipsoids, points or lines, one row for each: the functions of
/// pw85_batch.h, on spans.
#ifndef PW85_BATCH_ROWS_HPP_INCLUDED
#define PW85_BATCH_ROWS_HPP_INCLUDED

#include <pw85_batch.h>

#include <pw85/batch/calls.hpp>

namespace pw85 {

// Made by api/committed.py: rows of pw85_batch.h
// clang-format off
/// @name Many pairs
/// @{

/// Computes ellipsoid_quaternion() for many ellipsoids, with bitwise equal results: see
/// pw85_ellipsoid_quaternion_batch().
///
/// @param semi_axes one for each ellipsoid; > 0
/// @param quaternions one for each ellipsoid; not zero
/// @param[out] q one for each ellipsoid
/// @return as for ellipsoid_quaternion(), of the first bad ellipsoid
static inline StatusCode ellipsoid_quaternion_batch(
    Vectors semi_axes, std::span<Vector<double, 4> const> quaternions,
    std::span<SymmetricMatrix<double, 3>> q) noexcept
{
    return detail::call_rows(pw85_ellipsoid_quaternion_batch, semi_axes, quaternions, q);
}

/// Computes ellipsoid_factor() for many ellipsoids, with bitwise equal results: see
/// pw85_ellipsoid_factor_batch().
///
/// @param semi_axes one for each ellipsoid; > 0
/// @param quaternions one for each ellipsoid; not zero
/// @param[out] s one for each ellipsoid
/// @return as for ellipsoid_factor(), of the first bad ellipsoid
static inline StatusCode ellipsoid_factor_batch(Vectors semi_axes,
                                                std::span<Vector<double, 4> const> quaternions,
                                                std::span<Factor<double, 3>> s) noexcept
{
    return detail::call_rows(pw85_ellipsoid_factor_batch, semi_axes, quaternions, s);
}

/// Computes contact() for many pairs: see pw85_contact_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] mu2 one for each pair
/// @param[out] lambda one for each pair, or empty
/// @return as for contact(), of the first bad pair
static inline StatusCode contact_batch(Vectors r12, Forms q1, Forms q2, std::span<double> mu2,
                                       std::span<double> lambda = {}) noexcept
{
    return detail::call_rows(pw85_contact_batch, r12, q1, q2, mu2, lambda);
}

/// Computes contact_rounded() for many pairs, with bitwise equal results: see
/// pw85_contact_rounded_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] mu2,lambda one for each pair, or empty
/// @return as for contact_rounded(), of the first bad pair
static inline StatusCode contact_rounded_batch(Vectors r12, Forms q1, Forms q2,
                                               std::span<double> mu2,
                                               std::span<double> lambda = {}) noexcept
{
    return detail::call_rows(pw85_contact_rounded_batch, r12, q1, q2, mu2, lambda);
}

/// Computes contact_factored() for many pairs, with bitwise equal results: see
/// pw85_contact_factored_batch().
///
/// @param r12,s1,s2 one for each pair
/// @param[out] mu2,lambda one for each pair, or empty
/// @return as for contact_factored(), of the first bad pair
static inline StatusCode contact_factored_batch(Vectors r12, std::span<Factor<double, 3> const> s1,
                                                std::span<Factor<double, 3> const> s2,
                                                std::span<double> mu2,
                                                std::span<double> lambda = {}) noexcept
{
    return detail::call_rows(pw85_contact_factored_batch, r12, s1, s2, mu2, lambda);
}

/// Computes condition() for many pairs, with bitwise equal results: see pw85_condition_batch().
///
/// @param r12,q1,q2,lambda one for each pair
/// @param[out] cond one for each pair
/// @return as for condition(), of the first bad pair
static inline StatusCode condition_batch(Vectors r12, Forms q1, Forms q2,
                                         std::span<double const> lambda,
                                         std::span<double> cond) noexcept
{
    return detail::call_rows(pw85_condition_batch, r12, q1, q2, lambda, cond);
}

/// Computes pw85_contact_function() for many pairs, with bitwise equal results: see
/// pw85_contact_function_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] mu2,lambda one for each pair, or empty
/// @return as for pw85_contact_function(), of the first bad pair
static inline StatusCode contact_function_batch(Vectors r12, Forms q1, Forms q2,
                                                std::span<double> mu2,
                                                std::span<double> lambda = {}) noexcept
{
    return detail::call_rows(pw85_contact_function_batch, r12, q1, q2, mu2, lambda);
}

/// Computes contact_geometry() for many pairs, with bitwise equal results: see
/// pw85_contact_geometry_batch().
///
/// @param r12 one for each pair; not zero
/// @param q1,q2,lambda one for each pair
/// @param[out] point,normal one for each pair, or empty
/// @return as for contact_geometry(), of the first bad pair
static inline StatusCode contact_geometry_batch(Vectors r12, Forms q1, Forms q2,
                                                std::span<double const> lambda,
                                                std::span<Vector<double, 3>> point,
                                                std::span<Vector<double, 3>> normal = {}) noexcept
{
    return detail::call_rows(pw85_contact_geometry_batch, r12, q1, q2, lambda, point, normal);
}

/// Computes contact_geometry_factored() for many pairs, with bitwise equal results: see
/// pw85_contact_geometry_factored_batch().
///
/// @param r12 one for each pair; not zero
/// @param s1,s2,lambda one for each pair
/// @param[out] point,normal one for each pair, or empty
/// @return as for contact_geometry_factored(), of the first bad pair
static inline StatusCode contact_geometry_factored_batch(
    Vectors r12, std::span<Factor<double, 3> const> s1, std::span<Factor<double, 3> const> s2,
    std::span<double const> lambda, std::span<Vector<double, 3>> point,
    std::span<Vector<double, 3>> normal = {}) noexcept
{
    return detail::call_rows(pw85_contact_geometry_factored_batch, r12, s1, s2, lambda, point,
                             normal);
}

/// Computes contact_gradient() for many pairs, with bitwise equal results: see
/// pw85_contact_gradient_batch().
///
/// @param r12,q1,q2,lambda one for each pair
/// @param[out] d_r12,d_q1,d_q2 one for each pair, or empty
/// @return as for contact_gradient(), of the first bad pair
static inline StatusCode contact_gradient_batch(
    Vectors r12, Forms q1, Forms q2, std::span<double const> lambda,
    std::span<Vector<double, 3>> d_r12, std::span<SymmetricMatrix<double, 3>> d_q1 = {},
    std::span<SymmetricMatrix<double, 3>> d_q2 = {}) noexcept
{
    return detail::call_rows(pw85_contact_gradient_batch, r12, q1, q2, lambda, d_r12, d_q1, d_q2);
}

/// Computes contact_gradient_factored() for many pairs, with bitwise equal results: see
/// pw85_contact_gradient_factored_batch().
///
/// @param r12,s1,s2,lambda one for each pair
/// @param[out] d_r12,d_s1,d_s2 one for each pair, or empty
/// @return as for contact_gradient_factored(), of the first bad pair
static inline StatusCode contact_gradient_factored_batch(
    Vectors r12, std::span<Factor<double, 3> const> s1, std::span<Factor<double, 3> const> s2,
    std::span<double const> lambda, std::span<Vector<double, 3>> d_r12,
    std::span<Factor<double, 3>> d_s1 = {}, std::span<Factor<double, 3>> d_s2 = {}) noexcept
{
    return detail::call_rows(pw85_contact_gradient_factored_batch, r12, s1, s2, lambda, d_r12, d_s1,
                             d_s2);
}

/// Computes contact_torque() for many pairs, with bitwise equal results: see
/// pw85_contact_torque_batch().
///
/// @param r12,q1,q2,lambda one for each pair
/// @param[out] d_rot1,d_rot2 one for each pair, or empty
/// @return as for contact_torque(), of the first bad pair
static inline StatusCode contact_torque_batch(Vectors r12, Forms q1, Forms q2,
                                              std::span<double const> lambda,
                                              std::span<Vector<double, 3>> d_rot1,
                                              std::span<Vector<double, 3>> d_rot2 = {}) noexcept
{
    return detail::call_rows(pw85_contact_torque_batch, r12, q1, q2, lambda, d_rot1, d_rot2);
}

/// Computes contact_hessian() for many pairs, with bitwise equal results: see
/// pw85_contact_hessian_batch().
///
/// @param r12 one for each pair; not zero
/// @param q1,q2,lambda one for each pair
/// @param[out] hessian one for each pair
/// @return as for contact_hessian(), of the first bad pair
static inline StatusCode contact_hessian_batch(Vectors r12, Forms q1, Forms q2,
                                               std::span<double const> lambda,
                                               std::span<std::array<double, 81>> hessian) noexcept
{
    return detail::call_rows(pw85_contact_hessian_batch, r12, q1, q2, lambda, hessian);
}

/// Computes overlap() for many pairs, with the same answers: see pw85_overlap_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] overlap one for each pair: 1, 0, or 255 for a bad pair
/// @return as for overlap(), of the first bad pair
static inline StatusCode overlap_batch(Vectors r12, Forms q1, Forms q2,
                                       std::span<unsigned char> overlap) noexcept
{
    return detail::call_rows(pw85_overlap_batch, r12, q1, q2, overlap);
}

/// Computes overlap_factored() for many pairs, with the same answers: see
/// pw85_overlap_factored_batch().
///
/// @param r12,s1,s2 one for each pair
/// @param[out] overlap one for each pair: 1, 0, or 255 for a bad pair
/// @return as for overlap_factored(), of the first bad pair
static inline StatusCode overlap_factored_batch(Vectors r12, std::span<Factor<double, 3> const> s1,
                                                std::span<Factor<double, 3> const> s2,
                                                std::span<unsigned char> overlap) noexcept
{
    return detail::call_rows(pw85_overlap_factored_batch, r12, s1, s2, overlap);
}

/// Computes compare() for many pairs, with the same signs: see pw85_compare_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param mu2 one for each pair; >= 0; may be infinite
/// @param[out] sign one for each pair: -1, 0 or 1, or 2 for a bad pair
/// @return as for compare(), of the first bad pair
static inline StatusCode compare_batch(Vectors r12, Forms q1, Forms q2, std::span<double const> mu2,
                                       std::span<int> sign) noexcept
{
    return detail::call_rows(pw85_compare_batch, r12, q1, q2, mu2, sign);
}

/// Computes overlap_witness() for many pairs, with the same results: see
/// pw85_overlap_witness_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] overlap one for each pair: 1, 0, or 255 for a bad pair
/// @param[out] lambda one for each pair, or empty: NaN where the ellipsoids are not apart
/// @param[out] point one for each pair, or empty: NaN where they do not overlap
/// @return as for overlap_witness(), of the first bad pair
static inline StatusCode overlap_witness_batch(Vectors r12, Forms q1, Forms q2,
                                               std::span<unsigned char> overlap,
                                               std::span<double> lambda = {},
                                               std::span<Vector<double, 3>> point = {}) noexcept
{
    return detail::call_rows(pw85_overlap_witness_batch, r12, q1, q2, overlap, lambda, point);
}

/// Computes contains() for many pairs, with the same answers: see pw85_contains_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] contains one for each pair: 1, 0, or 255 for a bad pair
/// @return as for contains(), of the first bad pair
static inline StatusCode contains_batch(Vectors r12, Forms q1, Forms q2,
                                        std::span<unsigned char> contains) noexcept
{
    return detail::call_rows(pw85_contains_batch, r12, q1, q2, contains);
}

/// Computes containment() for many pairs, with bitwise equal results: see pw85_containment_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] mu2,point one for each pair, or empty
/// @return as for containment(), of the first bad pair
static inline StatusCode containment_batch(Vectors r12, Forms q1, Forms q2, std::span<double> mu2,
                                           std::span<Vector<double, 3>> point = {}) noexcept
{
    return detail::call_rows(pw85_containment_batch, r12, q1, q2, mu2, point);
}

/// Computes closest_approach() for many pairs: see pw85_closest_approach_batch().
///
/// @param directions one for each pair; not zero
/// @param q1,q2 one for each pair
/// @param[out] distance one for each pair
/// @return as for closest_approach(), of the first bad pair
static inline StatusCode closest_approach_batch(Vectors directions, Forms q1, Forms q2,
                                                std::span<double> distance) noexcept
{
    return detail::call_rows(pw85_closest_approach_batch, directions, q1, q2, distance);
}

/// Computes volume() for many ellipsoids, with bitwise equal results: see pw85_volume_batch().
///
/// @param q one for each ellipsoid
/// @param[out] volume one for each ellipsoid
/// @return as for volume(), of the first bad ellipsoid
static inline StatusCode volume_batch(Forms q, std::span<double> volume) noexcept
{
    return detail::call_rows(pw85_volume_batch, q, volume);
}

/// Computes overlap_volume() for many pairs, with bitwise equal results: see
/// pw85_overlap_volume_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] volume one for each pair
/// @return as for overlap_volume(), of the first bad pair
static inline StatusCode overlap_volume_batch(Vectors r12, Forms q1, Forms q2,
                                              std::span<double> volume) noexcept
{
    return detail::call_rows(pw85_overlap_volume_batch, r12, q1, q2, volume);
}

/// Computes overlap_volume_gradient() for many pairs, with bitwise equal results: see
/// pw85_overlap_volume_gradient_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] d_r12,d_q1,d_q2 one for each pair, or empty
/// @return as for overlap_volume_gradient(), of the first bad pair
static inline StatusCode overlap_volume_gradient_batch(
    Vectors r12, Forms q1, Forms q2, std::span<Vector<double, 3>> d_r12,
    std::span<SymmetricMatrix<double, 3>> d_q1 = {},
    std::span<SymmetricMatrix<double, 3>> d_q2 = {}) noexcept
{
    return detail::call_rows(pw85_overlap_volume_gradient_batch, r12, q1, q2, d_r12, d_q1, d_q2);
}

/// Computes overlap_volume_torque() for many pairs, with bitwise equal results: see
/// pw85_overlap_volume_torque_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] d_rot1,d_rot2 one for each pair, or empty
/// @return as for overlap_volume_torque(), of the first bad pair
static inline StatusCode overlap_volume_torque_batch(
    Vectors r12, Forms q1, Forms q2, std::span<Vector<double, 3>> d_rot1,
    std::span<Vector<double, 3>> d_rot2 = {}) noexcept
{
    return detail::call_rows(pw85_overlap_volume_torque_batch, r12, q1, q2, d_rot1, d_rot2);
}

/// Computes area() for many ellipses, with bitwise equal results: see pw85_area_batch_2d().
///
/// @param q one for each ellipse
/// @param[out] area one for each ellipse
/// @return as for area(), of the first bad ellipse
static inline StatusCode area_batch(FlatForms q, std::span<double> area) noexcept
{
    return detail::call_rows(pw85_area_batch_2d, q, area);
}

/// Computes overlap_area() for many pairs of ellipses, with bitwise equal results: see
/// pw85_overlap_area_batch_2d().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] area one for each pair
/// @return as for overlap_area(), of the first bad pair
static inline StatusCode overlap_area_batch(FlatVectors r12, FlatForms q1, FlatForms q2,
                                            std::span<double> area) noexcept
{
    return detail::call_rows(pw85_overlap_area_batch_2d, r12, q1, q2, area);
}

/// Computes overlap_area_gradient() for many pairs of ellipses, with bitwise equal results: see
/// pw85_overlap_area_gradient_batch_2d().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] d_r12,d_q1,d_q2 one for each pair, or empty
/// @return as for overlap_area_gradient(), of the first bad pair
static inline StatusCode overlap_area_gradient_batch(
    FlatVectors r12, FlatForms q1, FlatForms q2, std::span<Vector<double, 2>> d_r12,
    std::span<SymmetricMatrix<double, 2>> d_q1 = {},
    std::span<SymmetricMatrix<double, 2>> d_q2 = {}) noexcept
{
    return detail::call_rows(pw85_overlap_area_gradient_batch_2d, r12, q1, q2, d_r12, d_q1, d_q2);
}

/// Computes overlap_area_torque() for many pairs of ellipses, with bitwise equal results: see
/// pw85_overlap_area_torque_batch_2d().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] d_rot1,d_rot2 one for each pair, or empty
/// @return as for overlap_area_torque(), of the first bad pair
static inline StatusCode overlap_area_torque_batch(FlatVectors r12, FlatForms q1, FlatForms q2,
                                                   std::span<double> d_rot1,
                                                   std::span<double> d_rot2 = {}) noexcept
{
    return detail::call_rows(pw85_overlap_area_torque_batch_2d, r12, q1, q2, d_rot1, d_rot2);
}

/// Computes contact() for many pairs of ellipses: see pw85_contact_batch_2d().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] mu2 one for each pair
/// @param[out] lambda one for each pair, or empty
/// @return as for contact(), of the first bad pair
static inline StatusCode contact_batch(FlatVectors r12, FlatForms q1, FlatForms q2,
                                       std::span<double> mu2,
                                       std::span<double> lambda = {}) noexcept
{
    return detail::call_rows(pw85_contact_batch_2d, r12, q1, q2, mu2, lambda);
}

/// Computes contact_geometry() for many pairs of ellipses, with bitwise equal results: see
/// pw85_contact_geometry_batch_2d().
///
/// @param r12 one for each pair; not zero
/// @param q1,q2,lambda one for each pair
/// @param[out] point,normal one for each pair, or empty
/// @return as for contact_geometry(), of the first bad pair
static inline StatusCode contact_geometry_batch(FlatVectors r12, FlatForms q1, FlatForms q2,
                                                std::span<double const> lambda,
                                                std::span<Vector<double, 2>> point,
                                                std::span<Vector<double, 2>> normal = {}) noexcept
{
    return detail::call_rows(pw85_contact_geometry_batch_2d, r12, q1, q2, lambda, point, normal);
}

/// Computes contact_gradient() for many pairs of ellipses, with bitwise equal results: see
/// pw85_contact_gradient_batch_2d().
///
/// @param r12,q1,q2,lambda one for each pair
/// @param[out] d_r12,d_q1,d_q2 one for each pair, or empty
/// @return as for contact_gradient(), of the first bad pair
static inline StatusCode contact_gradient_batch(
    FlatVectors r12, FlatForms q1, FlatForms q2, std::span<double const> lambda,
    std::span<Vector<double, 2>> d_r12, std::span<SymmetricMatrix<double, 2>> d_q1 = {},
    std::span<SymmetricMatrix<double, 2>> d_q2 = {}) noexcept
{
    return detail::call_rows(pw85_contact_gradient_batch_2d, r12, q1, q2, lambda, d_r12, d_q1,
                             d_q2);
}

/// Computes contact_torque() for many pairs of ellipses, with bitwise equal results: see
/// pw85_contact_torque_batch_2d().
///
/// @param r12,q1,q2,lambda one for each pair
/// @param[out] d_rot1,d_rot2 one for each pair, or empty
/// @return as for contact_torque(), of the first bad pair
static inline StatusCode contact_torque_batch(FlatVectors r12, FlatForms q1, FlatForms q2,
                                              std::span<double const> lambda,
                                              std::span<double> d_rot1,
                                              std::span<double> d_rot2 = {}) noexcept
{
    return detail::call_rows(pw85_contact_torque_batch_2d, r12, q1, q2, lambda, d_rot1, d_rot2);
}

/// Computes contact_hessian() for many pairs of ellipses, with bitwise equal results: see
/// pw85_contact_hessian_batch_2d().
///
/// @param r12 one for each pair; not zero
/// @param q1,q2,lambda one for each pair
/// @param[out] hessian one for each pair
/// @return as for contact_hessian(), of the first bad pair
static inline StatusCode contact_hessian_batch(FlatVectors r12, FlatForms q1, FlatForms q2,
                                               std::span<double const> lambda,
                                               std::span<std::array<double, 16>> hessian) noexcept
{
    return detail::call_rows(pw85_contact_hessian_batch_2d, r12, q1, q2, lambda, hessian);
}

/// Computes overlap() for many pairs of ellipses: see pw85_overlap_batch_2d().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] overlap one for each pair: 1, 0, or 255 for a bad pair
/// @return as for overlap(), of the first bad pair
static inline StatusCode overlap_batch(FlatVectors r12, FlatForms q1, FlatForms q2,
                                       std::span<unsigned char> overlap) noexcept
{
    return detail::call_rows(pw85_overlap_batch_2d, r12, q1, q2, overlap);
}

/// Computes closest_approach() for many pairs of ellipses, with bitwise equal results: see
/// pw85_closest_approach_batch_2d().
///
/// @param directions one for each pair; not zero
/// @param q1,q2 one for each pair
/// @param[out] distance one for each pair
/// @return as for closest_approach(), of the first bad pair
static inline StatusCode closest_approach_batch(FlatVectors directions, FlatForms q1, FlatForms q2,
                                                std::span<double> distance) noexcept
{
    return detail::call_rows(pw85_closest_approach_batch_2d, directions, q1, q2, distance);
}

/// Computes distance() for many pairs: see pw85_distance_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] distance,point1,point2 one for each pair, or empty
/// @return as for distance(), of the first bad pair
static inline StatusCode distance_batch(Vectors r12, Forms q1, Forms q2, std::span<double> distance,
                                        std::span<Vector<double, 3>> point1 = {},
                                        std::span<Vector<double, 3>> point2 = {}) noexcept
{
    return detail::call_rows(pw85_distance_batch, r12, q1, q2, distance, point1, point2);
}

/// Computes pw85_distance_geometry() for many pairs: see pw85_distance_geometry_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] distance,point1,point2,normal one for each pair, or empty
/// @return as for pw85_distance_geometry(), of the first bad pair
static inline StatusCode distance_geometry_batch(Vectors r12, Forms q1, Forms q2,
                                                 std::span<double> distance,
                                                 std::span<Vector<double, 3>> point1 = {},
                                                 std::span<Vector<double, 3>> point2 = {},
                                                 std::span<Vector<double, 3>> normal = {}) noexcept
{
    return detail::call_rows(pw85_distance_geometry_batch, r12, q1, q2, distance, point1, point2,
                             normal);
}

/// Computes distance_derivatives() for many pairs, with bitwise equal results: see
/// pw85_distance_derivatives_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] d_r12,d_rot1,d_rot2,hessian one for each pair, or empty
/// @return as for distance_derivatives(), of the first bad pair
static inline StatusCode distance_derivatives_batch(
    Vectors r12, Forms q1, Forms q2, std::span<Vector<double, 3>> d_r12,
    std::span<Vector<double, 3>> d_rot1 = {}, std::span<Vector<double, 3>> d_rot2 = {},
    std::span<std::array<double, 81>> hessian = {}) noexcept
{
    return detail::call_rows(pw85_distance_derivatives_batch, r12, q1, q2, d_r12, d_rot1, d_rot2,
                             hessian);
}

/// Computes penetration() for many pairs, with bitwise equal results: see pw85_penetration_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] depth,direction one for each pair, or empty
/// @return as for penetration(), of the first bad pair
static inline StatusCode penetration_batch(Vectors r12, Forms q1, Forms q2, std::span<double> depth,
                                           std::span<Vector<double, 3>> direction = {}) noexcept
{
    return detail::call_rows(pw85_penetration_batch, r12, q1, q2, depth, direction);
}

/// Computes signed_distance() for many pairs: see pw85_signed_distance_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] distance,point1,point2 one for each pair, or empty
/// @return as for signed_distance(), of the first bad pair
static inline StatusCode signed_distance_batch(Vectors r12, Forms q1, Forms q2,
                                               std::span<double> distance,
                                               std::span<Vector<double, 3>> point1 = {},
                                               std::span<Vector<double, 3>> point2 = {}) noexcept
{
    return detail::call_rows(pw85_signed_distance_batch, r12, q1, q2, distance, point1, point2);
}

/// Computes pw85_signed_distance_geometry() for many pairs: see
/// pw85_signed_distance_geometry_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] distance,point1,point2,normal one for each pair, or empty
/// @return as for pw85_signed_distance_geometry(), of the first bad pair
static inline StatusCode signed_distance_geometry_batch(
    Vectors r12, Forms q1, Forms q2, std::span<double> distance,
    std::span<Vector<double, 3>> point1 = {}, std::span<Vector<double, 3>> point2 = {},
    std::span<Vector<double, 3>> normal = {}) noexcept
{
    return detail::call_rows(pw85_signed_distance_geometry_batch, r12, q1, q2, distance, point1,
                             point2, normal);
}

/// Computes signed_distance_derivatives() for many pairs, with bitwise equal results: see
/// pw85_signed_distance_derivatives_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] d_r12,d_rot1,d_rot2,hessian one for each pair, or empty
/// @return as for signed_distance_derivatives(), of the first bad pair
static inline StatusCode signed_distance_derivatives_batch(
    Vectors r12, Forms q1, Forms q2, std::span<Vector<double, 3>> d_r12,
    std::span<Vector<double, 3>> d_rot1 = {}, std::span<Vector<double, 3>> d_rot2 = {},
    std::span<std::array<double, 81>> hessian = {}) noexcept
{
    return detail::call_rows(pw85_signed_distance_derivatives_batch, r12, q1, q2, d_r12, d_rot1,
                             d_rot2, hessian);
}

/// Computes gap_inside() for many pairs, with bitwise equal results: see pw85_gap_inside_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] gap,point1,point2,normal one for each pair, or empty
/// @return as for gap_inside(), of the first bad pair
static inline StatusCode gap_inside_batch(Vectors r12, Forms q1, Forms q2, std::span<double> gap,
                                          std::span<Vector<double, 3>> point1 = {},
                                          std::span<Vector<double, 3>> point2 = {},
                                          std::span<Vector<double, 3>> normal = {}) noexcept
{
    return detail::call_rows(pw85_gap_inside_batch, r12, q1, q2, gap, point1, point2, normal);
}

/// Computes distance() for many pairs of ellipses, with bitwise equal results: see
/// pw85_distance_batch_2d().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] distance,point1,point2 one for each pair, or empty
/// @return as for distance(), of the first bad pair
static inline StatusCode distance_batch(FlatVectors r12, FlatForms q1, FlatForms q2,
                                        std::span<double> distance,
                                        std::span<Vector<double, 2>> point1 = {},
                                        std::span<Vector<double, 2>> point2 = {}) noexcept
{
    return detail::call_rows(pw85_distance_batch_2d, r12, q1, q2, distance, point1, point2);
}

/// Computes pw85_distance_geometry_2d() for many pairs of ellipses, with bitwise equal results: see
/// pw85_distance_geometry_batch_2d().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] distance,point1,point2,normal one for each pair, or empty
/// @return as for pw85_distance_geometry_2d(), of the first bad pair
static inline StatusCode distance_geometry_batch(FlatVectors r12, FlatForms q1, FlatForms q2,
                                                 std::span<double> distance,
                                                 std::span<Vector<double, 2>> point1 = {},
                                                 std::span<Vector<double, 2>> point2 = {},
                                                 std::span<Vector<double, 2>> normal = {}) noexcept
{
    return detail::call_rows(pw85_distance_geometry_batch_2d, r12, q1, q2, distance, point1, point2,
                             normal);
}

/// Computes penetration() for many pairs of ellipses, with bitwise equal results: see
/// pw85_penetration_batch_2d().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] depth,direction one for each pair, or empty
/// @return as for penetration(), of the first bad pair
static inline StatusCode penetration_batch(FlatVectors r12, FlatForms q1, FlatForms q2,
                                           std::span<double> depth,
                                           std::span<Vector<double, 2>> direction = {}) noexcept
{
    return detail::call_rows(pw85_penetration_batch_2d, r12, q1, q2, depth, direction);
}

/// Computes signed_distance() for many pairs of ellipses, with bitwise equal results: see
/// pw85_signed_distance_batch_2d().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] distance,point1,point2 one for each pair, or empty
/// @return as for signed_distance(), of the first bad pair
static inline StatusCode signed_distance_batch(FlatVectors r12, FlatForms q1, FlatForms q2,
                                               std::span<double> distance,
                                               std::span<Vector<double, 2>> point1 = {},
                                               std::span<Vector<double, 2>> point2 = {}) noexcept
{
    return detail::call_rows(pw85_signed_distance_batch_2d, r12, q1, q2, distance, point1, point2);
}

/// Computes pw85_signed_distance_geometry_2d() for many pairs of ellipses, with bitwise equal
/// results: see pw85_signed_distance_geometry_batch_2d().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] distance,point1,point2,normal one for each pair, or empty
/// @return as for pw85_signed_distance_geometry_2d(), of the first bad pair
static inline StatusCode signed_distance_geometry_batch(
    FlatVectors r12, FlatForms q1, FlatForms q2, std::span<double> distance,
    std::span<Vector<double, 2>> point1 = {}, std::span<Vector<double, 2>> point2 = {},
    std::span<Vector<double, 2>> normal = {}) noexcept
{
    return detail::call_rows(pw85_signed_distance_geometry_batch_2d, r12, q1, q2, distance, point1,
                             point2, normal);
}

/// Computes gap_inside() for many pairs of ellipses, with bitwise equal results: see
/// pw85_gap_inside_batch_2d().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] gap,point1,point2,normal one for each pair, or empty
/// @return as for gap_inside(), of the first bad pair
static inline StatusCode gap_inside_batch(FlatVectors r12, FlatForms q1, FlatForms q2,
                                          std::span<double> gap,
                                          std::span<Vector<double, 2>> point1 = {},
                                          std::span<Vector<double, 2>> point2 = {},
                                          std::span<Vector<double, 2>> normal = {}) noexcept
{
    return detail::call_rows(pw85_gap_inside_batch_2d, r12, q1, q2, gap, point1, point2, normal);
}

/// Computes first_contact() for many pairs, with bitwise equal results: see
/// pw85_first_contact_batch().
///
/// @param r12,q1,q2,motion1,motion2 one for each pair
/// @param t_max the last time at which a contact counts; for all rows; >= 0; may be infinite
/// @param[out] t one for each pair
/// @return as for first_contact(), of the first bad pair
static inline StatusCode first_contact_batch(Vectors r12, Forms q1, Forms q2,
                                             std::span<Motion<double, 3> const> motion1,
                                             std::span<Motion<double, 3> const> motion2,
                                             double t_max, std::span<double> t) noexcept
{
    return detail::call_rows(pw85_first_contact_batch, r12, q1, q2, motion1, motion2, t_max, t);
}

/// Computes closest_passage() for many pairs: see pw85_closest_passage_batch().
///
/// @param r12,q1,q2,velocity one for each pair
/// @param t_max the end of the path; for all rows; >= 0; may be infinite
/// @param[out] mu2 one for each pair
/// @param[out] t one for each pair, or empty
/// @return as for closest_passage(), of the first bad pair
static inline StatusCode closest_passage_batch(Vectors r12, Forms q1, Forms q2, Vectors velocity,
                                               double t_max, std::span<double> mu2,
                                               std::span<double> t = {}) noexcept
{
    return detail::call_rows(pw85_closest_passage_batch, r12, q1, q2, velocity, t_max, mu2, t);
}

/// Computes free_path() for many pairs, with bitwise equal results: see pw85_free_path_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param directions one for each pair; not zero
/// @param t_max one for each pair; >= 0; may be infinite
/// @param[out] t one for each pair
/// @return as for free_path(), of the first bad pair
static inline StatusCode free_path_batch(Vectors r12, Forms q1, Forms q2, Vectors directions,
                                         std::span<double const> t_max,
                                         std::span<double> t) noexcept
{
    return detail::call_rows(pw85_free_path_batch, r12, q1, q2, directions, t_max, t);
}

/// Computes curvature() for many ellipsoids, with bitwise equal results: see
/// pw85_curvature_batch().
///
/// @param normals one for each ellipsoid; not zero
/// @param q one for each ellipsoid
/// @param[out] curvatures,directions one for each ellipsoid, or empty
/// @return as for curvature(), of the first bad ellipsoid
static inline StatusCode curvature_batch(Vectors normals, Forms q,
                                         std::span<std::array<double, 2>> curvatures,
                                         std::span<std::array<double, 6>> directions = {}) noexcept
{
    return detail::call_rows(pw85_curvature_batch, normals, q, curvatures, directions);
}

/// Computes hertz() for many contacts, with bitwise equal results: see pw85_hertz_batch().
///
/// @param curvatures one for each contact; > 0
/// @param[out] radius,ellipse one for each contact, or empty
/// @return as for hertz(), of the first bad contact
static inline StatusCode hertz_batch(std::span<std::array<double, 2> const> curvatures,
                                     std::span<double> radius,
                                     std::span<std::array<double, 2>> ellipse = {}) noexcept
{
    return detail::call_rows(pw85_hertz_batch, curvatures, radius, ellipse);
}

/// Computes hertz_contact() for many pairs, with bitwise equal results: see
/// pw85_hertz_contact_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param normals one for each pair; not zero
/// @param[out] depth,point,curvatures,directions,radius,ellipse one for each pair, or empty
/// @return as for hertz_contact(), of the first bad pair
static inline StatusCode hertz_contact_batch(Vectors r12, Forms q1, Forms q2, Vectors normals,
                                             std::span<double> depth,
                                             std::span<Vector<double, 3>> point = {},
                                             std::span<std::array<double, 2>> curvatures = {},
                                             std::span<std::array<double, 6>> directions = {},
                                             std::span<double> radius = {},
                                             std::span<std::array<double, 2>> ellipse = {}) noexcept
{
    return detail::call_rows(pw85_hertz_contact_batch, r12, q1, q2, normals, depth, point,
                             curvatures, directions, radius, ellipse);
}

/// Computes grain_contact() for many pairs: see pw85_grain_contact_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param starts one for each pair; not zero
/// @param[out] normal,depth,point,curvatures,radius one for each pair, or empty
/// @return as for grain_contact(), of the first bad pair
static inline StatusCode grain_contact_batch(Vectors r12, Forms q1, Forms q2, Vectors starts,
                                             std::span<Vector<double, 3>> normal,
                                             std::span<double> depth = {},
                                             std::span<Vector<double, 3>> point = {},
                                             std::span<std::array<double, 2>> curvatures = {},
                                             std::span<double> radius = {}) noexcept
{
    return detail::call_rows(pw85_grain_contact_batch, r12, q1, q2, starts, normal, depth, point,
                             curvatures, radius);
}

/// Computes grain_radius_gradient() for many pairs, with bitwise equal results: see
/// pw85_grain_radius_gradient_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param normals one for each pair; not zero
/// @param[out] d_r12,d_rot1,d_rot2 one for each pair, or empty
/// @return as for grain_radius_gradient(), of the first bad pair
static inline StatusCode grain_radius_gradient_batch(
    Vectors r12, Forms q1, Forms q2, Vectors normals, std::span<Vector<double, 3>> d_r12,
    std::span<Vector<double, 3>> d_rot1 = {}, std::span<Vector<double, 3>> d_rot2 = {}) noexcept
{
    return detail::call_rows(pw85_grain_radius_gradient_batch, r12, q1, q2, normals, d_r12, d_rot1,
                             d_rot2);
}

/// Computes grain_contact_wall() for many ellipsoids and walls, with bitwise equal results: see
/// pw85_grain_contact_wall_batch().
///
/// @param normals one for each ellipsoid; not zero
/// @param offsets one for each ellipsoid
/// @param directions one for each ellipsoid; not zero
/// @param curvature,q one for each ellipsoid
/// @param[out] depth,point,curvatures,radius one for each ellipsoid, or empty
/// @return as for grain_contact_wall(), of the first bad ellipsoid
static inline StatusCode grain_contact_wall_batch(Vectors normals, std::span<double const> offsets,
                                                  Vectors directions,
                                                  std::span<double const> curvature, Forms q,
                                                  std::span<double> depth,
                                                  std::span<Vector<double, 3>> point = {},
                                                  std::span<std::array<double, 2>> curvatures = {},
                                                  std::span<double> radius = {}) noexcept
{
    return detail::call_rows(pw85_grain_contact_wall_batch, normals, offsets, directions, curvature,
                             q, depth, point, curvatures, radius);
}

/// Computes surface_area() for many ellipsoids, with bitwise equal results: see
/// pw85_surface_area_batch().
///
/// @param q one for each ellipsoid
/// @param[out] area one for each ellipsoid
/// @return as for surface_area(), of the first bad ellipsoid
static inline StatusCode surface_area_batch(Forms q, std::span<double> area) noexcept
{
    return detail::call_rows(pw85_surface_area_batch, q, area);
}

/// Computes second_moments() for many ellipsoids, with bitwise equal results: see
/// pw85_second_moments_batch().
///
/// @param q one for each ellipsoid
/// @param[out] moments one for each ellipsoid
/// @return as for second_moments(), of the first bad ellipsoid
static inline StatusCode second_moments_batch(
    Forms q, std::span<SymmetricMatrix<double, 3>> moments) noexcept
{
    return detail::call_rows(pw85_second_moments_batch, q, moments);
}

/// Computes from_moments() for many ellipsoids, with bitwise equal results: see
/// pw85_from_moments_batch().
///
/// @param second_moments one for each ellipsoid
/// @param[out] q one for each ellipsoid
/// @return as for from_moments(), of the first bad ellipsoid
static inline StatusCode from_moments_batch(Forms second_moments,
                                            std::span<SymmetricMatrix<double, 3>> q) noexcept
{
    return detail::call_rows(pw85_from_moments_batch, second_moments, q);
}

/// Computes shell_moments() for many ellipsoids, with bitwise equal results: see
/// pw85_shell_moments_batch().
///
/// @param q one for each ellipsoid
/// @param[out] moments one for each ellipsoid
/// @return as for shell_moments(), of the first bad ellipsoid
static inline StatusCode shell_moments_batch(Forms q,
                                             std::span<SymmetricMatrix<double, 3>> moments) noexcept
{
    return detail::call_rows(pw85_shell_moments_batch, q, moments);
}

/// Computes inertia() for many ellipsoids, with bitwise equal results: see pw85_inertia_batch().
///
/// @param q one for each ellipsoid
/// @param shell 0 for a solid body, any other number for a shell; for all rows
/// @param[out] inertia one for each ellipsoid
/// @return as for inertia(), of the first bad ellipsoid
static inline StatusCode inertia_batch(Forms q, int shell,
                                       std::span<SymmetricMatrix<double, 3>> inertia) noexcept
{
    return detail::call_rows(pw85_inertia_batch, q, shell, inertia);
}

/// Computes perimeter() for many ellipses, with bitwise equal results: see
/// pw85_perimeter_batch_2d().
///
/// @param q one for each ellipse
/// @param[out] perimeter one for each ellipse
/// @return as for perimeter(), of the first bad ellipse
static inline StatusCode perimeter_batch(FlatForms q, std::span<double> perimeter) noexcept
{
    return detail::call_rows(pw85_perimeter_batch_2d, q, perimeter);
}

/// Computes second_moments() for many ellipses, with bitwise equal results: see
/// pw85_second_moments_batch_2d().
///
/// @param q one for each ellipse
/// @param[out] moments one for each ellipse
/// @return as for second_moments(), of the first bad ellipse
static inline StatusCode second_moments_batch(
    FlatForms q, std::span<SymmetricMatrix<double, 2>> moments) noexcept
{
    return detail::call_rows(pw85_second_moments_batch_2d, q, moments);
}

/// Computes from_moments() for many ellipses, with bitwise equal results: see
/// pw85_from_moments_batch_2d().
///
/// @param second_moments one for each ellipse
/// @param[out] q one for each ellipse
/// @return as for from_moments(), of the first bad ellipse
static inline StatusCode from_moments_batch(FlatForms second_moments,
                                            std::span<SymmetricMatrix<double, 2>> q) noexcept
{
    return detail::call_rows(pw85_from_moments_batch_2d, second_moments, q);
}

/// Computes shell_moments() for many ellipses, with bitwise equal results: see
/// pw85_shell_moments_batch_2d().
///
/// @param q one for each ellipse
/// @param[out] moments one for each ellipse
/// @return as for shell_moments(), of the first bad ellipse
static inline StatusCode shell_moments_batch(FlatForms q,
                                             std::span<SymmetricMatrix<double, 2>> moments) noexcept
{
    return detail::call_rows(pw85_shell_moments_batch_2d, q, moments);
}

/// Computes distance_plane() for many ellipsoids and half-spaces, with bitwise equal results: see
/// pw85_distance_plane_batch().
///
/// @param normals one for each ellipsoid; not zero
/// @param offsets,q one for each ellipsoid
/// @param[out] distance,point one for each ellipsoid, or empty
/// @return as for distance_plane(), of the first bad ellipsoid
static inline StatusCode distance_plane_batch(Vectors normals, std::span<double const> offsets,
                                              Forms q, std::span<double> distance,
                                              std::span<Vector<double, 3>> point = {}) noexcept
{
    return detail::call_rows(pw85_distance_plane_batch, normals, offsets, q, distance, point);
}

/// Computes distance_plane_derivatives() for many ellipsoids and half-spaces, with bitwise equal
/// results: see pw85_distance_plane_derivatives_batch().
///
/// @param normals one for each ellipsoid; not zero
/// @param q one for each ellipsoid
/// @param[out] d_center,d_rot one for each ellipsoid, or empty
/// @return as for distance_plane_derivatives(), of the first bad ellipsoid
static inline StatusCode distance_plane_derivatives_batch(
    Vectors normals, Forms q, std::span<Vector<double, 3>> d_center,
    std::span<Vector<double, 3>> d_rot = {}) noexcept
{
    return detail::call_rows(pw85_distance_plane_derivatives_batch, normals, q, d_center, d_rot);
}

/// Computes contact_plane() for many ellipsoids and half-spaces, with bitwise equal results: see
/// pw85_contact_plane_batch().
///
/// @param normals one for each ellipsoid; not zero
/// @param offsets,q one for each ellipsoid
/// @param[out] mu2,point one for each ellipsoid, or empty
/// @return as for contact_plane(), of the first bad ellipsoid
static inline StatusCode contact_plane_batch(Vectors normals, std::span<double const> offsets,
                                             Forms q, std::span<double> mu2,
                                             std::span<Vector<double, 3>> point = {}) noexcept
{
    return detail::call_rows(pw85_contact_plane_batch, normals, offsets, q, mu2, point);
}

/// Computes contact_plane_derivatives() for many ellipsoids and half-spaces, with bitwise equal
/// results: see pw85_contact_plane_derivatives_batch().
///
/// @param normals one for each ellipsoid; not zero
/// @param offsets,q one for each ellipsoid
/// @param[out] d_center,d_rot one for each ellipsoid, or empty
/// @return as for contact_plane_derivatives(), of the first bad ellipsoid
static inline StatusCode contact_plane_derivatives_batch(
    Vectors normals, std::span<double const> offsets, Forms q,
    std::span<Vector<double, 3>> d_center, std::span<Vector<double, 3>> d_rot = {}) noexcept
{
    return detail::call_rows(pw85_contact_plane_derivatives_batch, normals, offsets, q, d_center,
                             d_rot);
}

/// Computes distance_box() for many ellipsoids and boxes, with bitwise equal results: see
/// pw85_distance_box_batch().
///
/// @param lower,upper one for each ellipsoid; `lower` <= `upper`
/// @param q one for each ellipsoid
/// @param[out] distance,point,normal one for each ellipsoid, or empty
/// @return as for distance_box(), of the first bad ellipsoid
static inline StatusCode distance_box_batch(Vectors lower, Vectors upper, Forms q,
                                            std::span<double> distance,
                                            std::span<Vector<double, 3>> point = {},
                                            std::span<Vector<double, 3>> normal = {}) noexcept
{
    return detail::call_rows(pw85_distance_box_batch, lower, upper, q, distance, point, normal);
}

/// Computes distance_cylinder() for many ellipsoids and cylinders, with bitwise equal results: see
/// pw85_distance_cylinder_batch().
///
/// @param axis one for each ellipsoid; not zero
/// @param radius one for each ellipsoid; > 0
/// @param center,q one for each ellipsoid
/// @param[out] distance,point,normal one for each ellipsoid, or empty
/// @return as for distance_cylinder(), of the first bad ellipsoid
static inline StatusCode distance_cylinder_batch(Vectors axis, std::span<double const> radius,
                                                 Vectors center, Forms q,
                                                 std::span<double> distance,
                                                 std::span<Vector<double, 3>> point = {},
                                                 std::span<Vector<double, 3>> normal = {}) noexcept
{
    return detail::call_rows(pw85_distance_cylinder_batch, axis, radius, center, q, distance, point,
                             normal);
}

/// Computes distance_point() for many points and ellipsoids, with bitwise equal results: see
/// pw85_distance_point_batch().
///
/// @param r,q one for each point
/// @param[out] distance,point,normal one for each point, or empty
/// @return as for distance_point(), of the first bad point
static inline StatusCode distance_point_batch(Vectors r, Forms q, std::span<double> distance,
                                              std::span<Vector<double, 3>> point = {},
                                              std::span<Vector<double, 3>> normal = {}) noexcept
{
    return detail::call_rows(pw85_distance_point_batch, r, q, distance, point, normal);
}

/// Computes intersect_line() for many lines and ellipsoids, with bitwise equal results: see
/// pw85_intersect_line_batch().
///
/// @param origin one for each line
/// @param directions one for each line; not zero
/// @param q one for each line
/// @param[out] enter,leave one for each line, or empty
/// @return as for intersect_line(), of the first bad line
static inline StatusCode intersect_line_batch(Vectors origin, Vectors directions, Forms q,
                                              std::span<double> enter,
                                              std::span<double> leave = {}) noexcept
{
    return detail::call_rows(pw85_intersect_line_batch, origin, directions, q, enter, leave);
}

/// Computes overlap_volume_plane() for many ellipsoids and half-spaces, with bitwise equal results:
/// see pw85_overlap_volume_plane_batch().
///
/// @param normals one for each ellipsoid; not zero
/// @param offsets,q one for each ellipsoid
/// @param[out] volume one for each ellipsoid
/// @return as for overlap_volume_plane(), of the first bad ellipsoid
static inline StatusCode overlap_volume_plane_batch(Vectors normals,
                                                    std::span<double const> offsets, Forms q,
                                                    std::span<double> volume) noexcept
{
    return detail::call_rows(pw85_overlap_volume_plane_batch, normals, offsets, q, volume);
}

/// Computes contact_segment() for many ellipsoids and segments: see pw85_contact_segment_batch().
///
/// @param end1,end2,q one for each ellipsoid
/// @param[out] mu2,point one for each ellipsoid, or empty
/// @return as for contact_segment(), of the first bad ellipsoid
static inline StatusCode contact_segment_batch(Vectors end1, Vectors end2, Forms q,
                                               std::span<double> mu2,
                                               std::span<Vector<double, 3>> point = {}) noexcept
{
    return detail::call_rows(pw85_contact_segment_batch, end1, end2, q, mu2, point);
}

/// Computes contact_triangle() for many ellipsoids and triangles: see
/// pw85_contact_triangle_batch().
///
/// @param vertex1,vertex2,vertex3,q one for each ellipsoid
/// @param[out] mu2,point one for each ellipsoid, or empty
/// @return as for contact_triangle(), of the first bad ellipsoid
static inline StatusCode contact_triangle_batch(Vectors vertex1, Vectors vertex2, Vectors vertex3,
                                                Forms q, std::span<double> mu2,
                                                std::span<Vector<double, 3>> point = {}) noexcept
{
    return detail::call_rows(pw85_contact_triangle_batch, vertex1, vertex2, vertex3, q, mu2, point);
}

/// Computes contact_box() for many ellipsoids and boxes: see pw85_contact_box_batch().
///
/// @param lower,upper one for each ellipsoid; `lower` <= `upper`
/// @param q one for each ellipsoid
/// @param[out] mu2,point one for each ellipsoid, or empty
/// @return as for contact_box(), of the first bad ellipsoid
static inline StatusCode contact_box_batch(Vectors lower, Vectors upper, Forms q,
                                           std::span<double> mu2,
                                           std::span<Vector<double, 3>> point = {}) noexcept
{
    return detail::call_rows(pw85_contact_box_batch, lower, upper, q, mu2, point);
}

/// Computes overlap_segment() for many ellipsoids and segments, with the same answers: see
/// pw85_overlap_segment_batch().
///
/// @param end1,end2,q one for each ellipsoid
/// @param[out] overlap one for each ellipsoid: 1, 0, or 255 for a bad ellipsoid
/// @return as for overlap_segment(), of the first bad ellipsoid
static inline StatusCode overlap_segment_batch(Vectors end1, Vectors end2, Forms q,
                                               std::span<unsigned char> overlap) noexcept
{
    return detail::call_rows(pw85_overlap_segment_batch, end1, end2, q, overlap);
}

/// Computes overlap_triangle() for many ellipsoids and triangles, with the same answers: see
/// pw85_overlap_triangle_batch().
///
/// @param vertex1,vertex2,vertex3,q one for each ellipsoid
/// @param[out] overlap one for each ellipsoid: 1, 0, or 255 for a bad ellipsoid
/// @return as for overlap_triangle(), of the first bad ellipsoid
static inline StatusCode overlap_triangle_batch(Vectors vertex1, Vectors vertex2, Vectors vertex3,
                                                Forms q, std::span<unsigned char> overlap) noexcept
{
    return detail::call_rows(pw85_overlap_triangle_batch, vertex1, vertex2, vertex3, q, overlap);
}

/// Computes overlap_box() for many ellipsoids and boxes, with the same answers: see
/// pw85_overlap_box_batch().
///
/// @param lower,upper one for each ellipsoid; `lower` <= `upper`
/// @param q one for each ellipsoid
/// @param[out] overlap one for each ellipsoid: 1, 0, or 255 for a bad ellipsoid
/// @return as for overlap_box(), of the first bad ellipsoid
static inline StatusCode overlap_box_batch(Vectors lower, Vectors upper, Forms q,
                                           std::span<unsigned char> overlap) noexcept
{
    return detail::call_rows(pw85_overlap_box_batch, lower, upper, q, overlap);
}

/// Computes distance_segment() for many ellipsoids and segments, with bitwise equal results: see
/// pw85_distance_segment_batch().
///
/// @param end1,end2,q one for each ellipsoid
/// @param[out] distance,point1,point2,normal one for each ellipsoid, or empty
/// @return as for distance_segment(), of the first bad ellipsoid
static inline StatusCode distance_segment_batch(Vectors end1, Vectors end2, Forms q,
                                                std::span<double> distance,
                                                std::span<Vector<double, 3>> point1 = {},
                                                std::span<Vector<double, 3>> point2 = {},
                                                std::span<Vector<double, 3>> normal = {}) noexcept
{
    return detail::call_rows(pw85_distance_segment_batch, end1, end2, q, distance, point1, point2,
                             normal);
}

/// Computes distance_triangle() for many ellipsoids and triangles, with bitwise equal results: see
/// pw85_distance_triangle_batch().
///
/// @param vertex1,vertex2,vertex3,q one for each ellipsoid
/// @param[out] distance,point1,point2,normal one for each ellipsoid, or empty
/// @return as for distance_triangle(), of the first bad ellipsoid
static inline StatusCode distance_triangle_batch(Vectors vertex1, Vectors vertex2, Vectors vertex3,
                                                 Forms q, std::span<double> distance,
                                                 std::span<Vector<double, 3>> point1 = {},
                                                 std::span<Vector<double, 3>> point2 = {},
                                                 std::span<Vector<double, 3>> normal = {}) noexcept
{
    return detail::call_rows(pw85_distance_triangle_batch, vertex1, vertex2, vertex3, q, distance,
                             point1, point2, normal);
}

/// Computes distance_solid_box() for many ellipsoids and boxes, with bitwise equal results: see
/// pw85_distance_solid_box_batch().
///
/// @param lower,upper one for each ellipsoid; `lower` <= `upper`
/// @param q one for each ellipsoid
/// @param[out] distance,point1,point2,normal one for each ellipsoid, or empty
/// @return as for distance_solid_box(), of the first bad ellipsoid
static inline StatusCode distance_solid_box_batch(Vectors lower, Vectors upper, Forms q,
                                                  std::span<double> distance,
                                                  std::span<Vector<double, 3>> point1 = {},
                                                  std::span<Vector<double, 3>> point2 = {},
                                                  std::span<Vector<double, 3>> normal = {}) noexcept
{
    return detail::call_rows(pw85_distance_solid_box_batch, lower, upper, q, distance, point1,
                             point2, normal);
}

/// Computes contact_capsule() for many ellipsoids and capsules, with bitwise equal results: see
/// pw85_contact_capsule_batch().
///
/// @param end1,end2 one for each ellipsoid
/// @param radius one for each ellipsoid; >= 0
/// @param q one for each ellipsoid
/// @param[out] mu2,point one for each ellipsoid, or empty
/// @return as for contact_capsule(), of the first bad ellipsoid
static inline StatusCode contact_capsule_batch(Vectors end1, Vectors end2,
                                               std::span<double const> radius, Forms q,
                                               std::span<double> mu2,
                                               std::span<Vector<double, 3>> point = {}) noexcept
{
    return detail::call_rows(pw85_contact_capsule_batch, end1, end2, radius, q, mu2, point);
}

/// Computes overlap_capsule() for many ellipsoids and capsules, with the same answers: see
/// pw85_overlap_capsule_batch().
///
/// @param end1,end2 one for each ellipsoid
/// @param radius one for each ellipsoid; >= 0
/// @param q one for each ellipsoid
/// @param[out] overlap one for each ellipsoid: 1, 0, or 255 for a bad ellipsoid
/// @return as for overlap_capsule(), of the first bad ellipsoid
static inline StatusCode overlap_capsule_batch(Vectors end1, Vectors end2,
                                               std::span<double const> radius, Forms q,
                                               std::span<unsigned char> overlap) noexcept
{
    return detail::call_rows(pw85_overlap_capsule_batch, end1, end2, radius, q, overlap);
}

/// Computes distance_capsule() for many ellipsoids and capsules, with bitwise equal results: see
/// pw85_distance_capsule_batch().
///
/// @param end1,end2 one for each ellipsoid
/// @param radius one for each ellipsoid; >= 0
/// @param q one for each ellipsoid
/// @param[out] distance,point1,point2,normal one for each ellipsoid, or empty
/// @return as for distance_capsule(), of the first bad ellipsoid
static inline StatusCode distance_capsule_batch(Vectors end1, Vectors end2,
                                                std::span<double const> radius, Forms q,
                                                std::span<double> distance,
                                                std::span<Vector<double, 3>> point1 = {},
                                                std::span<Vector<double, 3>> point2 = {},
                                                std::span<Vector<double, 3>> normal = {}) noexcept
{
    return detail::call_rows(pw85_distance_capsule_batch, end1, end2, radius, q, distance, point1,
                             point2, normal);
}

/// Computes distance_point() for many points and ellipses, with bitwise equal results: see
/// pw85_distance_point_batch_2d().
///
/// @param r,q one for each point
/// @param[out] distance,point,normal one for each point, or empty
/// @return as for distance_point(), of the first bad point
static inline StatusCode distance_point_batch(FlatVectors r, FlatForms q,
                                              std::span<double> distance,
                                              std::span<Vector<double, 2>> point = {},
                                              std::span<Vector<double, 2>> normal = {}) noexcept
{
    return detail::call_rows(pw85_distance_point_batch_2d, r, q, distance, point, normal);
}

/// Computes contact_segment() for many ellipses and segments, with bitwise equal results: see
/// pw85_contact_segment_batch_2d().
///
/// @param end1,end2,q one for each ellipse
/// @param[out] mu2,point one for each ellipse, or empty
/// @return as for contact_segment(), of the first bad ellipse
static inline StatusCode contact_segment_batch(FlatVectors end1, FlatVectors end2, FlatForms q,
                                               std::span<double> mu2,
                                               std::span<Vector<double, 2>> point = {}) noexcept
{
    return detail::call_rows(pw85_contact_segment_batch_2d, end1, end2, q, mu2, point);
}

/// Computes contact_box() for many ellipses and boxes, with bitwise equal results: see
/// pw85_contact_box_batch_2d().
///
/// @param lower,upper one for each ellipse; `lower` <= `upper`
/// @param q one for each ellipse
/// @param[out] mu2,point one for each ellipse, or empty
/// @return as for contact_box(), of the first bad ellipse
static inline StatusCode contact_box_batch(FlatVectors lower, FlatVectors upper, FlatForms q,
                                           std::span<double> mu2,
                                           std::span<Vector<double, 2>> point = {}) noexcept
{
    return detail::call_rows(pw85_contact_box_batch_2d, lower, upper, q, mu2, point);
}

/// Computes overlap_segment() for many ellipses and segments, with the same answers: see
/// pw85_overlap_segment_batch_2d().
///
/// @param end1,end2,q one for each ellipse
/// @param[out] overlap one for each ellipse: 1, 0, or 255 for a bad ellipse
/// @return as for overlap_segment(), of the first bad ellipse
static inline StatusCode overlap_segment_batch(FlatVectors end1, FlatVectors end2, FlatForms q,
                                               std::span<unsigned char> overlap) noexcept
{
    return detail::call_rows(pw85_overlap_segment_batch_2d, end1, end2, q, overlap);
}

/// Computes overlap_box() for many ellipses and boxes, with the same answers: see
/// pw85_overlap_box_batch_2d().
///
/// @param lower,upper one for each ellipse; `lower` <= `upper`
/// @param q one for each ellipse
/// @param[out] overlap one for each ellipse: 1, 0, or 255 for a bad ellipse
/// @return as for overlap_box(), of the first bad ellipse
static inline StatusCode overlap_box_batch(FlatVectors lower, FlatVectors upper, FlatForms q,
                                           std::span<unsigned char> overlap) noexcept
{
    return detail::call_rows(pw85_overlap_box_batch_2d, lower, upper, q, overlap);
}

/// Computes contact(), contact_geometry(), contact_gradient() and contact_torque() for many pairs
/// in one call: see pw85_contact_derivatives_batch().
///
/// @param r12,q1,q2 one for each pair
/// @param[out] out rows in all spans, or in some: see pw85_contact_derivatives_batch()
/// @return as for contact_batch()
static inline StatusCode contact_derivatives_batch(Vectors r12, Forms q1, Forms q2,
                                                   DerivativeSpans const &out) noexcept
{
    return detail::call_rows(pw85_contact_derivatives_batch, r12, q1, q2, out.mu2, out.lambda,
                             out.point, out.normal, out.d_r12, out.d_rot1, out.d_rot2);
}

/// @}

/// @name Many forms
/// @{

/// Computes the bounding boxes of many ellipsoids, with sides along the coordinate axes: see
/// pw85_bounding_boxes().
///
/// @param q one for each ellipsoid
/// @param[out] half_widths one for each ellipsoid: √Qxx, √Qyy, √Qzz, in the unit of the semi-axes
/// @return Status::success, Status::invalid_argument, or the status of the first bad form
static inline StatusCode bounding_boxes(Forms q, std::span<Vector<double, 3>> half_widths) noexcept
{
    return detail::call_rows(pw85_bounding_boxes, q, half_widths);
}

/// @}
// clang-format on

} // namespace pw85

#endif
