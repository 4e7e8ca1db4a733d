// The C API of pairs of ellipses. The functions check for null pointers; the core checks everything else.
#include <pw85.h>

#include <pw85/pw85.hpp>

#include "c_arrays.hpp"
#include "floating_point_environment.hpp"

using namespace pw85;
using namespace pw85::detail;
using namespace pw85::detail::c_api;

namespace {

/// Returns the status of function(r12, q1, q2), computed in the default environment.
template <class Function>
int of_ellipses(Function const &function, double const *r12, double const *q1, double const *q2) noexcept
{
    return in_default_environment(
        [&] { return static_cast<int>(function(load_vector<2>(r12), load_matrix<2>(q1), load_matrix<2>(q2))); });
}

} // namespace

int pw85_contact_2d(double const r12[2], double const q1[3], double const q2[3], double out[2])
{
    if (any_null(r12, q1, q2, out)) return null_pointer(out, 2);
    return of_ellipses(
        [&](auto const &...pair) {
            auto const c = contact(pair...);
            out[0] = c.mu2;
            out[1] = c.lambda;
            return c.status;
        },
        r12, q1, q2);
}

int pw85_contact_geometry_2d(double const r12[2], double const q1[3], double const q2[3], double lambda,
                             double point[2], double normal[2])
{
    if (any_null(r12, q1, q2)) return null_pointer(point, 2, normal, 2);
    return of_ellipses(
        [&](auto const &...pair) {
            auto const g = contact_geometry(pair..., lambda);
            store(g.point, point);
            store(g.normal, normal);
            return g.status;
        },
        r12, q1, q2);
}

int pw85_contact_gradient_2d(double const r12[2], double const q1[3], double const q2[3], double lambda,
                             double d_r12[2], double d_q1[3], double d_q2[3])
{
    if (any_null(r12, q1, q2)) return null_pointer(d_r12, 2, d_q1, 3, d_q2, 3);
    return of_ellipses(
        [&](auto const &...pair) {
            auto const g = contact_gradient(pair..., lambda);
            store(g.r12, d_r12);
            store(g.q1, d_q1);
            store(g.q2, d_q2);
            return g.status;
        },
        r12, q1, q2);
}

int pw85_contact_torque_2d(double const r12[2], double const q1[3], double const q2[3], double lambda, double *d_rot1,
                           double *d_rot2)
{
    if (any_null(r12, q1, q2)) return null_pointer(d_rot1, 1, d_rot2, 1);
    return of_ellipses(
        [&](auto const &...pair) {
            auto const t = contact_torque(pair..., lambda);
            store(t.rotation1, d_rot1);
            store(t.rotation2, d_rot2);
            return t.status;
        },
        r12, q1, q2);
}

int pw85_contact_hessian_2d(double const r12[2], double const q1[3], double const q2[3], double lambda,
                            double hessian[16])
{
    if (any_null(r12, q1, q2, hessian)) return null_pointer(hessian, 16);
    return of_ellipses(
        [&](auto const &...pair) {
            auto const h = contact_hessian(pair..., lambda);
            std::memcpy(hessian, h.entries, sizeof h.entries);
            return h.status;
        },
        r12, q1, q2);
}

int pw85_overlap_2d(double const r12[2], double const q1[3], double const q2[3], int *overlap)
{
    if (any_null(overlap)) return PW85_EINVAL;
    *overlap = -1;
    if (any_null(r12, q1, q2)) return PW85_EINVAL;
    return of_ellipses(
        [&](auto const &...pair) {
            auto const o = pw85::overlap(pair...);
            if (o.status == Status::success) *overlap = o.overlap ? 1 : 0;
            return o.status;
        },
        r12, q1, q2);
}

int pw85_contains_2d(double const r12[2], double const q1[3], double const q2[3], int *contains)
{
    if (any_null(contains)) return PW85_EINVAL;
    *contains = -1;
    if (any_null(r12, q1, q2)) return PW85_EINVAL;
    return of_ellipses(
        [&](auto const &...pair) {
            auto const c = pw85::contains(pair...);
            if (c.status == Status::success) *contains = c.contains;
            return c.status;
        },
        r12, q1, q2);
}

int pw85_containment_2d(double const r12[2], double const q1[3], double const q2[3], double *mu2, double point[2])
{
    if (any_null(r12, q1, q2)) return null_pointer(mu2, 1, point, 2);
    return of_ellipses(
        [&](auto const &...pair) {
            auto const c = pw85::containment(pair...);
            if (mu2 != nullptr) *mu2 = c.mu2;
            store(c.point, point);
            return c.status;
        },
        r12, q1, q2);
}

int pw85_closest_approach_2d(double const direction[2], double const q1[3], double const q2[3], double *distance)
{
    if (any_null(direction, q1, q2, distance)) return null_pointer(distance, 1);
    return of_ellipses(
        [&](auto const &...pair) {
            auto const c = closest_approach(pair...);
            *distance = c.distance;
            return c.status;
        },
        direction, q1, q2);
}

int pw85_distance_2d(double const r12[2], double const q1[3], double const q2[3], double *distance, double point1[2],
                     double point2[2])
{
    if (any_null(r12, q1, q2)) return null_pointer(distance, 1, point1, 2, point2, 2);
    return of_ellipses(
        [&](auto const &...pair) {
            auto const d = pw85::distance(pair...);
            if (distance != nullptr) *distance = d.distance;
            store(d.point1, point1);
            store(d.point2, point2);
            return d.status;
        },
        r12, q1, q2);
}
