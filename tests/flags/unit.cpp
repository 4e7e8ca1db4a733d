// SPDX-License-Identifier: BSD-3-Clause
// A user's unit with all of the C++ API, to be compiled with any flags; UNIT is the name of its one
// function. UNIT_OF_DOUBLES leaves out the other types.
#include <pw85/history/legacy.hpp>
#include <pw85/history/zheng.hpp>
#include <pw85/pw85.hpp>

#include <pw85/batch.hpp>

double UNIT(double x);

using namespace pw85;

namespace {

template <class T, int D> T sum(Vector<T, D> const &x)
{
    T total = T(0);
    for (int i = 0; i < D; ++i) total = total + x[i];
    return total;
}

/// What has two dimensions, and three.
template <class T, int D>
T both(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2)
{
    auto const c = contact(r12, q1, q2);
    auto const g = contact_geometry(r12, q1, q2, c.lambda);
    auto const d = contact_gradient(r12, q1, q2, c.lambda);
    auto const w = overlap_witness(r12, q1, q2);
    auto const s = distance(T(100) * r12, q1, q2);
    auto const p = distance_plane(r12, T(2), q1);
    auto const b = distance_box(-r12, r12, q1);
    return c.mu2 + sum(g.point) + sum(g.normal) + sum(d.r12) + d.q1[0] + d.q2[1] + T(w.overlap) +
           T(overlap(r12, q1, q2).overlap) + T(contains(r12, q1, q2).contains) +
           T(compare(r12, q1, q2, T(2)).sign) + closest_approach(r12, q1, q2).distance +
           s.distance + sum(s.point1) + sum(s.normal) + p.distance + sum(p.point) + b.distance +
           sum(b.normal) + distance_point(r12, q1).distance + contact_plane(r12, T(2), q1).mu2 +
           intersect_line(r12, r12, q1).enter;
}

template <class T> T everything(T const &x)
{
    Vector<T, 3> const r12{x, T(1), T(2)};
    T const rotation[9] = {T(1), T(0), T(0), T(0), T(1), T(0), T(0), T(0), T(1)};
    auto const q1 = spheroid(x, T(2), Vector<T, 3>{T(0), T(1), T(1)}).q;
    auto const q2 = ellipsoid_quaternion(r12, Vector<T, 4>{T(1), x, T(2), T(3)}).q;
    auto const q3 = ellipsoid(r12, rotation).q;
    auto const t = contact_torque(r12, q1, q2, T(0.5));
    auto const s = distance_derivatives(T(100) * r12, q1, q2);
    auto const p = distance_plane_derivatives(r12, q1), c = contact_plane_derivatives(r12, x, q1);
    Vector<T, 2> const flat{x, T(1)};
    auto const e1 = ellipse(x, T(2), T(1)).q, e2 = ellipse(x, T(1), T(2)).q;
    return both(r12, q1, q2) + both(r12, q3, q2) + both(flat, e1, e2) + sum(t.rotation1) +
           sum(t.rotation2) + sum(s.rotation1) + s.hessian[0][0] + sum(p.center) + sum(c.rotation) +
           distance_cylinder(r12, x, r12, q1).distance + legacy::contact_newton(r12, q1, q2).mu2 +
           legacy::contact_bisection(r12, q1, q2).mu2 + zheng::ellipses(flat, e1, e2).distance +
           zheng::ellipsoids(r12, q1, q2).distance;
}

double of_batches(double x)
{
    Vector<double, 3> const r12[] = {{x, 1.0, 2.0}, {x, 2.0, 1.0}};
    SymmetricMatrix<double, 3> const q[] = {{1.0, 0.0, 0.0, 1.0, 0.0, 1.0},
                                            {2.0, 0.5, 0.0, 1.0, 0.0, 1.0}};
    double mu2[2];
    unsigned char decided[2];
    contact_batch(r12, q, q, mu2);
    overlap_batch(r12, q, q, decided);
    return mu2[0] + mu2[1] + decided[0] + decided[1];
}

} // namespace

double UNIT(double x)
{
#ifdef UNIT_OF_DOUBLES
    return everything(x) + of_batches(x);
#else
    return everything(x) + static_cast<double>(everything(static_cast<float>(x))) +
           static_cast<double>(everything(static_cast<long double>(x))) + of_batches(x);
#endif
}
