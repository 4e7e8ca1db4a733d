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
#include "kernels.hpp"

namespace pw85::detail::kernels {

namespace {

Vector<double, 3> const &view_vector(double const *x) noexcept { return c_api::view<Vector<double, 3>>(x); }

SymmetricMatrix<double, 3> const &view_matrix(double const *a) noexcept
{
    return c_api::view<SymmetricMatrix<double, 3>>(a);
}

int contact(double const *r12, double const *q1, double const *q2, double *out) noexcept
{
    auto const c = pw85::contact(view_vector(r12), view_matrix(q1), view_matrix(q2));
    out[0] = c.mu2;
    out[1] = c.lambda;
    return static_cast<int>(c.status);
}

int contact_factored(double const *r12, double const *s1, double const *s2, double *out) noexcept
{
    auto const c =
        pw85::contact_factored(c_api::load_vector<3>(r12), c_api::load_factor<3>(s1), c_api::load_factor<3>(s2));
    out[0] = c.mu2;
    out[1] = c.lambda;
    return static_cast<int>(c.status);
}

int contact_rounded(double const *r12, double const *q1, double const *q2, double *out) noexcept
{
    auto const c =
        pw85::contact_rounded(c_api::load_vector<3>(r12), c_api::load_matrix<3>(q1), c_api::load_matrix<3>(q2));
    out[0] = c.mu2;
    out[1] = c.lambda;
    return static_cast<int>(c.status);
}

int store_overlap(Overlap const &o, int *overlap) noexcept
{
    *overlap = o.status == Status::success ? static_cast<int>(o.overlap) : -1;
    return static_cast<int>(o.status);
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
    return store_overlap(overlap_near_contact(pair_of(r, m1, m2)), overlap);
}

int overlap_factored(double const *r12, double const *s1, double const *s2, int *overlap) noexcept
{
    return store_overlap(
        pw85::overlap_factored(c_api::load_vector<3>(r12), c_api::load_factor<3>(s1), c_api::load_factor<3>(s2)),
        overlap);
}

int contains(double const *r12, double const *q1, double const *q2, int *contains) noexcept
{
    auto const answer = pw85::contains(view_vector(r12), view_matrix(q1), view_matrix(q2));
    if (answer.status == Status::success) *contains = answer.contains;
    return static_cast<int>(answer.status);
}

int contact_geometry_factored(double const *r12, double const *s1, double const *s2, double lambda, double *point,
                              double *normal) noexcept
{
    auto const g = pw85::contact_geometry_factored(c_api::load_vector<3>(r12), c_api::load_factor<3>(s1),
                                                   c_api::load_factor<3>(s2), lambda);
    c_api::store(g.point, point);
    c_api::store(g.normal, normal);
    return static_cast<int>(g.status);
}

int contact_gradient_factored(double const *r12, double const *s1, double const *s2, double lambda, double *d_r12,
                              double *d_s1, double *d_s2) noexcept
{
    auto const g = pw85::contact_gradient_factored(c_api::load_vector<3>(r12), c_api::load_factor<3>(s1),
                                                   c_api::load_factor<3>(s2), lambda);
    c_api::store(g.r12, d_r12);
    c_api::store(g.s1, d_s1);
    c_api::store(g.s2, d_s2);
    return static_cast<int>(g.status);
}

int contact_geometry(double const *r12, double const *q1, double const *q2, double lambda, double *point,
                     double *normal) noexcept
{
    auto const g = pw85::contact_geometry(c_api::load_vector<3>(r12), c_api::load_matrix<3>(q1),
                                          c_api::load_matrix<3>(q2), lambda);
    c_api::store(g.point, point);
    c_api::store(g.normal, normal);
    return static_cast<int>(g.status);
}

int contact_gradient(double const *r12, double const *q1, double const *q2, double lambda, double *d_r12, double *d_q1,
                     double *d_q2) noexcept
{
    auto const g = pw85::contact_gradient(c_api::load_vector<3>(r12), c_api::load_matrix<3>(q1),
                                          c_api::load_matrix<3>(q2), lambda);
    c_api::store(g.r12, d_r12);
    c_api::store(g.q1, d_q1);
    c_api::store(g.q2, d_q2);
    return static_cast<int>(g.status);
}

int contact_torque(double const *r12, double const *q1, double const *q2, double lambda, double *d_rot1,
                   double *d_rot2) noexcept
{
    auto const t =
        pw85::contact_torque(c_api::load_vector<3>(r12), c_api::load_matrix<3>(q1), c_api::load_matrix<3>(q2), lambda);
    c_api::store(t.rotation1, d_rot1);
    c_api::store(t.rotation2, d_rot2);
    return static_cast<int>(t.status);
}

int contact_hessian(double const *r12, double const *q1, double const *q2, double lambda, double *hessian) noexcept
{
    auto const h =
        pw85::contact_hessian(c_api::load_vector<3>(r12), c_api::load_matrix<3>(q1), c_api::load_matrix<3>(q2), lambda);
    std::memcpy(hessian, h.entries, sizeof h.entries);
    return static_cast<int>(h.status);
}

int closest_approach(double const *direction, double const *q1, double const *q2, double *distance) noexcept
{
    auto const c =
        pw85::closest_approach(c_api::load_vector<3>(direction), c_api::load_matrix<3>(q1), c_api::load_matrix<3>(q2));
    *distance = c.distance;
    return static_cast<int>(c.status);
}

int distance(double const *r12, double const *q1, double const *q2, double *distance, double *point1,
             double *point2) noexcept
{
    auto const d = pw85::distance(c_api::load_vector<3>(r12), c_api::load_matrix<3>(q1), c_api::load_matrix<3>(q2));
    if (distance != nullptr) *distance = d.distance;
    c_api::store(d.point1, point1);
    c_api::store(d.point2, point2);
    return static_cast<int>(d.status);
}

int distance_derivatives(double const *r12, double const *q1, double const *q2, double *d_r12, double *d_rot1,
                         double *d_rot2, double *hessian) noexcept
{
    auto const d =
        pw85::distance_derivatives(c_api::load_vector<3>(r12), c_api::load_matrix<3>(q1), c_api::load_matrix<3>(q2));
    c_api::store(d.r12, d_r12);
    c_api::store(d.rotation1, d_rot1);
    c_api::store(d.rotation2, d_rot2);
    if (hessian != nullptr) std::memcpy(hessian, d.hessian, sizeof d.hessian);
    return static_cast<int>(d.status);
}

Motion<double, 3> load_motion(pw85_motion const &m) noexcept
{
    return {c_api::load_vector<3>(m.velocity), c_api::load_vector<3>(m.angular_velocity), m.growth};
}

int first_contact(double const *r12, double const *q1, double const *q2, pw85_motion const *motion1,
                  pw85_motion const *motion2, double end, double *time) noexcept
{
    auto const c = pw85::first_contact(c_api::load_vector<3>(r12), c_api::load_matrix<3>(q1), c_api::load_matrix<3>(q2),
                                       load_motion(*motion1), load_motion(*motion2), end);
    *time = c.time;
    return static_cast<int>(c.status);
}

} // namespace

extern OnePairKernels const PW85_ONE_PAIR_KERNELS;
OnePairKernels const PW85_ONE_PAIR_KERNELS = {
    contact,          overlap,          contact_geometry, contact_gradient,          contact_torque,
    contact_hessian,  closest_approach, distance,         distance_derivatives,      first_contact,
    contact_factored, contact_rounded,  overlap_factored, contact_geometry_factored, contact_gradient_factored,
    contains};

} // namespace pw85::detail::kernels
