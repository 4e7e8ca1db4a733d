// SPDX-License-Identifier: BSD-3-Clause
// The C API: contact of two ellipsoids.
//
// Made from pw85.h by api/committed.py.
// clang-format off
#include <pw85.h>

#include <pw85/contact/condition.hpp>
#include <pw85/overlap/compare.hpp>
#include <pw85/overlap/containment_factor.hpp>
#include <pw85/overlap/witness.hpp>

#include "../c_arrays.hpp"
#include "../floating_point_environment.hpp"
#include "../kernels/one_pair.hpp"

using namespace pw85::detail;
using namespace pw85::detail::c_api;

int pw85_contact(double const r12[3], double const q1[6], double const q2[6], double out[2])
{
    if (any_null(r12, q1, q2, out)) return null_pointer(out, 2);
    return in_default_environment(kernels::chosen().one_pair->contact, r12, q1, q2, out);
}

int pw85_contact_rounded(double const r12[3], double const q1[6], double const q2[6], double out[2])
{
    if (any_null(r12, q1, q2, out)) return null_pointer(out, 2);
    return in_default_environment(kernels::chosen().one_pair->contact_rounded, r12, q1, q2, out);
}

int pw85_contact_factored(double const r12[3], double const s1[9], double const s2[9], double out[2])
{
    if (any_null(r12, s1, s2, out)) return null_pointer(out, 2);
    return in_default_environment(kernels::chosen().one_pair->contact_factored, r12, s1, s2, out);
}

int pw85_condition(double const r12[3], double const q1[6], double const q2[6], double lambda, double *cond)
{
    if (any_null(r12, q1, q2, cond)) return null_pointer(cond, 1);
    return in_default_environment([&] {
        return put(pw85::condition(load_vector<3>(r12), load_matrix<3>(q1), load_matrix<3>(q2), lambda), cond);
    });
}

int pw85_contact_geometry(double const r12[3], double const q1[6], double const q2[6], double lambda, double point[3],
                          double normal[3])
{
    if (any_null(r12, q1, q2)) return null_pointer(point, 3, normal, 3);
    return in_default_environment(kernels::chosen().one_pair->contact_geometry, r12, q1, q2, lambda, point, normal);
}

int pw85_contact_geometry_factored(double const r12[3], double const s1[9], double const s2[9], double lambda,
                                   double point[3], double normal[3])
{
    if (any_null(r12, s1, s2)) return null_pointer(point, 3, normal, 3);
    return in_default_environment(kernels::chosen().one_pair->contact_geometry_factored, r12, s1, s2, lambda, point,
                                  normal);
}

int pw85_contact_gradient(double const r12[3], double const q1[6], double const q2[6], double lambda, double d_r12[3],
                          double d_q1[6], double d_q2[6])
{
    if (any_null(r12, q1, q2)) return null_pointer(d_r12, 3, d_q1, 6, d_q2, 6);
    return in_default_environment(kernels::chosen().one_pair->contact_gradient, r12, q1, q2, lambda, d_r12, d_q1, d_q2);
}

int pw85_contact_gradient_factored(double const r12[3], double const s1[9], double const s2[9], double lambda,
                                   double d_r12[3], double d_s1[9], double d_s2[9])
{
    if (any_null(r12, s1, s2)) return null_pointer(d_r12, 3, d_s1, 9, d_s2, 9);
    return in_default_environment(kernels::chosen().one_pair->contact_gradient_factored, r12, s1, s2, lambda, d_r12,
                                  d_s1, d_s2);
}

int pw85_contact_torque(double const r12[3], double const q1[6], double const q2[6], double lambda, double d_rot1[3],
                        double d_rot2[3])
{
    if (any_null(r12, q1, q2)) return null_pointer(d_rot1, 3, d_rot2, 3);
    return in_default_environment(kernels::chosen().one_pair->contact_torque, r12, q1, q2, lambda, d_rot1, d_rot2);
}

int pw85_contact_hessian(double const r12[3], double const q1[6], double const q2[6], double lambda, double hessian[81])
{
    if (any_null(r12, q1, q2, hessian)) return null_pointer(hessian, 81);
    return in_default_environment(kernels::chosen().one_pair->contact_hessian, r12, q1, q2, lambda, hessian);
}

int pw85_overlap(double const r12[3], double const q1[6], double const q2[6], int *overlap)
{
    if (any_null(overlap)) return PW85_EINVAL;
    *overlap = -1;
    if (any_null(r12, q1, q2)) return PW85_EINVAL;
    return in_default_environment(kernels::chosen().one_pair->overlap, r12, q1, q2, overlap);
}

int pw85_overlap_factored(double const r12[3], double const s1[9], double const s2[9], int *overlap)
{
    if (any_null(overlap)) return PW85_EINVAL;
    *overlap = -1;
    if (any_null(r12, s1, s2)) return PW85_EINVAL;
    return in_default_environment(kernels::chosen().one_pair->overlap_factored, r12, s1, s2, overlap);
}

int pw85_compare(double const r12[3], double const q1[6], double const q2[6], double mu2, int *sign)
{
    if (any_null(sign)) return PW85_EINVAL;
    *sign = 2;
    if (any_null(r12, q1, q2)) return PW85_EINVAL;
    return in_default_environment([&] {
        return put(pw85::compare(load_vector<3>(r12), load_matrix<3>(q1), load_matrix<3>(q2), mu2), sign);
    });
}

int pw85_overlap_witness(double const r12[3], double const q1[6], double const q2[6], int *overlap, double *lambda,
                         double point[3])
{
    store_nan(lambda, 1);
    store_nan(point, 3);
    if (any_null(overlap)) return PW85_EINVAL;
    *overlap = -1;
    if (any_null(r12, q1, q2)) return PW85_EINVAL;
    return in_default_environment([&] {
        return put(pw85::overlap_witness(load_vector<3>(r12), load_matrix<3>(q1), load_matrix<3>(q2)), overlap, lambda,
                   nullptr, point);
    });
}

int pw85_contains(double const r12[3], double const q1[6], double const q2[6], int *contains)
{
    if (any_null(contains)) return PW85_EINVAL;
    *contains = -1;
    if (any_null(r12, q1, q2)) return PW85_EINVAL;
    return in_default_environment(kernels::chosen().one_pair->contains, r12, q1, q2, contains);
}

int pw85_containment(double const r12[3], double const q1[6], double const q2[6], double *mu2, double point[3])
{
    if (any_null(r12, q1, q2)) return null_pointer(mu2, 1, point, 3);
    return in_default_environment([&] {
        return put(pw85::containment(load_vector<3>(r12), load_matrix<3>(q1), load_matrix<3>(q2)), mu2, point);
    });
}

int pw85_closest_approach(double const direction[3], double const q1[6], double const q2[6], double *distance)
{
    if (any_null(direction, q1, q2, distance)) return null_pointer(distance, 1);
    return in_default_environment(kernels::chosen().one_pair->closest_approach, direction, q1, q2, distance);
}
