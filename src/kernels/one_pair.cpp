// SPDX-License-Identifier: BSD-3-Clause
// The table of the functions for one pair, which call the headers of include/pw85. It is compiled for two instruction sets
// (meson.build). The functions of the C API call it by chosen() (dispatch.cpp).
#include <pw85.h>

#include <pw85/contact/closest_approach.hpp>
#include <pw85/contact/contact_factored.hpp>
#include <pw85/contact/contact_hessian.hpp>
#include <pw85/contact/geometry.hpp>
#include <pw85/contact/geometry_factored.hpp>
#include <pw85/distance/distance_derivatives.hpp>
#include <pw85/motion/first_contact.hpp>
#include <pw85/overlap/contact_rounded.hpp>
#include <pw85/overlap/containment.hpp>
#include <pw85/overlap/overlap.hpp>
#include <pw85/overlap/overlap_factored.hpp>

#include "../c_arrays.hpp"
#include "one_pair.hpp"

namespace pw85::detail::kernels {

namespace {

using namespace c_api;

Vector<double, 3> const &view_vector(double const *x) noexcept { return view<Vector<double, 3>>(x); }

SymmetricMatrix<double, 3> const &view_matrix(double const *a) noexcept { return view<SymmetricMatrix<double, 3>>(a); }

int contact(double const *r12, double const *q1, double const *q2, double *out) noexcept
{
    return put(pw85::contact(view_vector(r12), view_matrix(q1), view_matrix(q2)), out, out + 1);
}

int contact_factored(double const *r12, double const *s1, double const *s2, double *out) noexcept
{
    return put(pw85::contact_factored(load_vector<3>(r12), load_factor<3>(s1), load_factor<3>(s2)), out, out + 1);
}

int contact_rounded(double const *r12, double const *q1, double const *q2, double *out) noexcept
{
    return put(pw85::contact_rounded(load_vector<3>(r12), load_matrix<3>(q1), load_matrix<3>(q2)), out, out + 1);
}

int overlap(double const *r12, double const *q1, double const *q2, int *overlap) noexcept
{
    auto const &r = view_vector(r12);
    auto const &m1 = view_matrix(q1), &m2 = view_matrix(q2);
    // The common case returns at once: a structure of results would pass through memory.
    Decision const decision = decide_by_quartic(r, m1, m2);
    if (decision != Decision::none) {
        *overlap = decision == Decision::overlap;
        return PW85_SUCCESS;
    }
    return put(overlap_near_contact(pair_of(r, m1, m2)), overlap, nullptr);
}

int overlap_factored(double const *r12, double const *s1, double const *s2, int *overlap) noexcept
{
    return put(pw85::overlap_factored(load_vector<3>(r12), load_factor<3>(s1), load_factor<3>(s2)), overlap, nullptr);
}

int contains(double const *r12, double const *q1, double const *q2, int *contains) noexcept
{
    return put(pw85::contains(view_vector(r12), view_matrix(q1), view_matrix(q2)), contains);
}

int contact_geometry_factored(double const *r12, double const *s1, double const *s2, double lambda, double *point,
                              double *normal) noexcept
{
    return put(pw85::contact_geometry_factored(load_vector<3>(r12), load_factor<3>(s1), load_factor<3>(s2), lambda),
               point, normal);
}

int contact_gradient_factored(double const *r12, double const *s1, double const *s2, double lambda, double *d_r12,
                              double *d_s1, double *d_s2) noexcept
{
    return put(pw85::contact_gradient_factored(load_vector<3>(r12), load_factor<3>(s1), load_factor<3>(s2), lambda),
               d_r12, d_s1, d_s2);
}

int contact_geometry(double const *r12, double const *q1, double const *q2, double lambda, double *point,
                     double *normal) noexcept
{
    return put(pw85::contact_geometry(load_vector<3>(r12), load_matrix<3>(q1), load_matrix<3>(q2), lambda), point,
               normal);
}

int contact_gradient(double const *r12, double const *q1, double const *q2, double lambda, double *d_r12, double *d_q1,
                     double *d_q2) noexcept
{
    return put(pw85::contact_gradient(load_vector<3>(r12), load_matrix<3>(q1), load_matrix<3>(q2), lambda), d_r12, d_q1,
               d_q2);
}

int contact_torque(double const *r12, double const *q1, double const *q2, double lambda, double *d_rot1,
                   double *d_rot2) noexcept
{
    return put(pw85::contact_torque(load_vector<3>(r12), load_matrix<3>(q1), load_matrix<3>(q2), lambda), d_rot1,
               d_rot2);
}

int contact_hessian(double const *r12, double const *q1, double const *q2, double lambda, double *hessian) noexcept
{
    return put(pw85::contact_hessian(load_vector<3>(r12), load_matrix<3>(q1), load_matrix<3>(q2), lambda), hessian);
}

int closest_approach(double const *direction, double const *q1, double const *q2, double *distance) noexcept
{
    return put(pw85::closest_approach(load_vector<3>(direction), load_matrix<3>(q1), load_matrix<3>(q2)), distance);
}

int distance(double const *r12, double const *q1, double const *q2, double *distance, double *point1,
             double *point2) noexcept
{
    return put(pw85::distance(load_vector<3>(r12), load_matrix<3>(q1), load_matrix<3>(q2)), distance, point1, point2,
               nullptr);
}

int distance_derivatives(double const *r12, double const *q1, double const *q2, double *d_r12, double *d_rot1,
                         double *d_rot2, double *hessian) noexcept
{
    return put(pw85::distance_derivatives(load_vector<3>(r12), load_matrix<3>(q1), load_matrix<3>(q2)), d_r12, d_rot1,
               d_rot2, hessian);
}

int first_contact(double const *r12, double const *q1, double const *q2, pw85_motion const *motion1,
                  pw85_motion const *motion2, double end, double *time) noexcept
{
    return put(pw85::first_contact(load_vector<3>(r12), load_matrix<3>(q1), load_matrix<3>(q2), load_motion(*motion1),
                                   load_motion(*motion2), end),
               time);
}

} // namespace

extern OnePairKernels const PW85_ONE_PAIR_KERNELS;
OnePairKernels const PW85_ONE_PAIR_KERNELS = {
    contact,          overlap,          contact_geometry, contact_gradient,          contact_torque,
    contact_hessian,  closest_approach, distance,         distance_derivatives,      first_contact,
    contact_factored, contact_rounded,  overlap_factored, contact_geometry_factored, contact_gradient_factored,
    contains};

} // namespace pw85::detail::kernels
