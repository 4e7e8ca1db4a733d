// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The functions of pw85/pw85.hpp for doubles, computed by the compiled library (link with pw85).
///
///     #include <pw85/linked.hpp>
///     auto const [overlap, tier, status] = pw85::overlap(r12, q1, q2); // calls pw85_overlap()
///
/// Names, arguments, results and contracts are those of pw85.hpp, which this header includes. A
/// call with doubles takes the function of this header, since it is not a template: the solver is
/// not compiled again, and the library computes with the instruction set of the processor.
///
/// The functions have external linkage: exported inline functions of modules may call them. They
/// are always inlined: no unit runs the code of another one. They are not for device code.
// Made by api/committed.py: templates of pw85.hpp
// clang-format off
/// @file
/// Calls with other numbers take the templates, and so do these functions with doubles, of which
/// the C API leaves out a part of the result or which constant expressions call: spheroid(),
/// ellipsoid(), ellipsoid_quaternion(), ellipsoid_factor(), bounding_box(), decide_overlap(),
/// overlap_witness(), hertz(), distance_plane().
// clang-format on
#ifndef PW85_LINKED_HPP_INCLUDED
#define PW85_LINKED_HPP_INCLUDED

#include <pw85.h>
#include <pw85_batch.h>

#include <pw85/pw85.hpp>

#define PW85_LINKED [[gnu::always_inline]] inline

namespace pw85 {

namespace detail {

PW85_LINKED pw85_motion in_c(Motion<double, 3> const &m) noexcept
{
    return {{m.velocity[0], m.velocity[1], m.velocity[2]},
            {m.angular_velocity[0], m.angular_velocity[1], m.angular_velocity[2]},
            m.growth};
}

/// The numbers of a member of a result.
template <class Member> PW85_LINKED double *out(Member &member) noexcept
{
    return reinterpret_cast<double *>(&member);
}

} // namespace detail

// Made by api/committed.py: functions of pw85.h
// clang-format off
/// Computes ellipse() by pw85_ellipse().
PW85_LINKED Form<double, 2> ellipse(double a, double b, double angle) noexcept
{
    Form<double, 2> found{};
    found.status = static_cast<StatusCode>(pw85_ellipse(a, b, angle, detail::out(found.q)));
    return found;
}

/// Computes contact() by pw85_contact().
PW85_LINKED Contact<double> contact(Vector<double, 3> const &r12,
                                    SymmetricMatrix<double, 3> const &q1,
                                    SymmetricMatrix<double, 3> const &q2) noexcept
{
    Contact<double> found{};
    double out[2];
    found.status = static_cast<StatusCode>(pw85_contact(r12.coordinates, q1.entries, q2.entries,
                                                        out));
    found.mu2 = out[0];
    found.lambda = out[1];
    return found;
}

/// Computes contact() by pw85_contact_2d().
PW85_LINKED Contact<double> contact(Vector<double, 2> const &r12,
                                    SymmetricMatrix<double, 2> const &q1,
                                    SymmetricMatrix<double, 2> const &q2) noexcept
{
    Contact<double> found{};
    double out[2];
    found.status = static_cast<StatusCode>(pw85_contact_2d(r12.coordinates, q1.entries, q2.entries,
                                                           out));
    found.mu2 = out[0];
    found.lambda = out[1];
    return found;
}

/// Computes contact_rounded() by pw85_contact_rounded().
PW85_LINKED Contact<double> contact_rounded(Vector<double, 3> const &r12,
                                            SymmetricMatrix<double, 3> const &q1,
                                            SymmetricMatrix<double, 3> const &q2) noexcept
{
    Contact<double> found{};
    double out[2];
    found.status = static_cast<StatusCode>(pw85_contact_rounded(r12.coordinates, q1.entries,
                                                                q2.entries, out));
    found.mu2 = out[0];
    found.lambda = out[1];
    return found;
}

/// Computes contact_factored() by pw85_contact_factored().
PW85_LINKED Contact<double> contact_factored(Vector<double, 3> const &r12,
                                             Factor<double, 3> const &s1,
                                             Factor<double, 3> const &s2) noexcept
{
    Contact<double> found{};
    double out[2];
    found.status = static_cast<StatusCode>(pw85_contact_factored(r12.coordinates, s1.entries,
                                                                 s2.entries, out));
    found.mu2 = out[0];
    found.lambda = out[1];
    return found;
}

/// Computes condition() by pw85_condition().
PW85_LINKED Condition<double> condition(Vector<double, 3> const &r12,
                                        SymmetricMatrix<double, 3> const &q1,
                                        SymmetricMatrix<double, 3> const &q2,
                                        double lambda) noexcept
{
    Condition<double> found{};
    found.status = static_cast<StatusCode>(pw85_condition(r12.coordinates, q1.entries, q2.entries,
                                                          lambda, detail::out(found.condition)));
    return found;
}

/// Computes contact_geometry() by pw85_contact_geometry().
PW85_LINKED ContactGeometry<double, 3> contact_geometry(Vector<double, 3> const &r12,
                                                        SymmetricMatrix<double, 3> const &q1,
                                                        SymmetricMatrix<double, 3> const &q2,
                                                        double lambda) noexcept
{
    ContactGeometry<double, 3> found{};
    found.status = static_cast<StatusCode>(pw85_contact_geometry(r12.coordinates, q1.entries,
                                                                 q2.entries, lambda,
                                                                 detail::out(found.point),
                                                                 detail::out(found.normal)));
    return found;
}

/// Computes contact_geometry() by pw85_contact_geometry_2d().
PW85_LINKED ContactGeometry<double, 2> contact_geometry(Vector<double, 2> const &r12,
                                                        SymmetricMatrix<double, 2> const &q1,
                                                        SymmetricMatrix<double, 2> const &q2,
                                                        double lambda) noexcept
{
    ContactGeometry<double, 2> found{};
    found.status = static_cast<StatusCode>(pw85_contact_geometry_2d(r12.coordinates, q1.entries,
                                                                    q2.entries, lambda,
                                                                    detail::out(found.point),
                                                                    detail::out(found.normal)));
    return found;
}

/// Computes contact_gradient() by pw85_contact_gradient().
PW85_LINKED ContactGradient<double, 3> contact_gradient(Vector<double, 3> const &r12,
                                                        SymmetricMatrix<double, 3> const &q1,
                                                        SymmetricMatrix<double, 3> const &q2,
                                                        double lambda) noexcept
{
    ContactGradient<double, 3> found{};
    found.status = static_cast<StatusCode>(pw85_contact_gradient(r12.coordinates, q1.entries,
                                                                 q2.entries, lambda,
                                                                 detail::out(found.r12),
                                                                 detail::out(found.q1),
                                                                 detail::out(found.q2)));
    return found;
}

/// Computes contact_gradient() by pw85_contact_gradient_2d().
PW85_LINKED ContactGradient<double, 2> contact_gradient(Vector<double, 2> const &r12,
                                                        SymmetricMatrix<double, 2> const &q1,
                                                        SymmetricMatrix<double, 2> const &q2,
                                                        double lambda) noexcept
{
    ContactGradient<double, 2> found{};
    found.status = static_cast<StatusCode>(pw85_contact_gradient_2d(r12.coordinates, q1.entries,
                                                                    q2.entries, lambda,
                                                                    detail::out(found.r12),
                                                                    detail::out(found.q1),
                                                                    detail::out(found.q2)));
    return found;
}

/// Computes contact_geometry_factored() by pw85_contact_geometry_factored().
PW85_LINKED ContactGeometry<double, 3> contact_geometry_factored(Vector<double, 3> const &r12,
                                                                 Factor<double, 3> const &s1,
                                                                 Factor<double, 3> const &s2,
                                                                 double lambda) noexcept
{
    ContactGeometry<double, 3> found{};
    found.status = static_cast<StatusCode>(pw85_contact_geometry_factored(
        r12.coordinates, s1.entries, s2.entries, lambda, detail::out(found.point),
        detail::out(found.normal)));
    return found;
}

/// Computes contact_gradient_factored() by pw85_contact_gradient_factored().
PW85_LINKED FactorGradient<double, 3> contact_gradient_factored(Vector<double, 3> const &r12,
                                                                Factor<double, 3> const &s1,
                                                                Factor<double, 3> const &s2,
                                                                double lambda) noexcept
{
    FactorGradient<double, 3> found{};
    found.status = static_cast<StatusCode>(pw85_contact_gradient_factored(r12.coordinates,
                                                                          s1.entries, s2.entries,
                                                                          lambda,
                                                                          detail::out(found.r12),
                                                                          detail::out(found.s1),
                                                                          detail::out(found.s2)));
    return found;
}

/// Computes contact_torque() by pw85_contact_torque().
PW85_LINKED ContactTorque<double, 3> contact_torque(Vector<double, 3> const &r12,
                                                    SymmetricMatrix<double, 3> const &q1,
                                                    SymmetricMatrix<double, 3> const &q2,
                                                    double lambda) noexcept
{
    ContactTorque<double, 3> found{};
    found.status = static_cast<StatusCode>(pw85_contact_torque(r12.coordinates, q1.entries,
                                                               q2.entries, lambda,
                                                               detail::out(found.rotation1),
                                                               detail::out(found.rotation2)));
    return found;
}

/// Computes contact_torque() by pw85_contact_torque_2d().
PW85_LINKED ContactTorque<double, 2> contact_torque(Vector<double, 2> const &r12,
                                                    SymmetricMatrix<double, 2> const &q1,
                                                    SymmetricMatrix<double, 2> const &q2,
                                                    double lambda) noexcept
{
    ContactTorque<double, 2> found{};
    found.status = static_cast<StatusCode>(pw85_contact_torque_2d(r12.coordinates, q1.entries,
                                                                  q2.entries, lambda,
                                                                  detail::out(found.rotation1),
                                                                  detail::out(found.rotation2)));
    return found;
}

/// Computes contact_hessian() by pw85_contact_hessian().
PW85_LINKED ContactHessian<double, 3> contact_hessian(Vector<double, 3> const &r12,
                                                      SymmetricMatrix<double, 3> const &q1,
                                                      SymmetricMatrix<double, 3> const &q2,
                                                      double lambda) noexcept
{
    ContactHessian<double, 3> found{};
    found.status = static_cast<StatusCode>(pw85_contact_hessian(r12.coordinates, q1.entries,
                                                                q2.entries, lambda,
                                                                detail::out(found.entries)));
    return found;
}

/// Computes contact_hessian() by pw85_contact_hessian_2d().
PW85_LINKED ContactHessian<double, 2> contact_hessian(Vector<double, 2> const &r12,
                                                      SymmetricMatrix<double, 2> const &q1,
                                                      SymmetricMatrix<double, 2> const &q2,
                                                      double lambda) noexcept
{
    ContactHessian<double, 2> found{};
    found.status = static_cast<StatusCode>(pw85_contact_hessian_2d(r12.coordinates, q1.entries,
                                                                   q2.entries, lambda,
                                                                   detail::out(found.entries)));
    return found;
}

/// Computes overlap() by pw85_overlap().
PW85_LINKED Overlap overlap(Vector<double, 3> const &r12, SymmetricMatrix<double, 3> const &q1,
                            SymmetricMatrix<double, 3> const &q2) noexcept
{
    Overlap found{};
    int overlap_in_c = -1;
    found.status = static_cast<StatusCode>(pw85_overlap(r12.coordinates, q1.entries, q2.entries,
                                                        &overlap_in_c));
    found.overlap = overlap_in_c == 1;
    found.tier = OverlapTier::unknown;
    return found;
}

/// Computes overlap() by pw85_overlap_2d().
PW85_LINKED Overlap overlap(Vector<double, 2> const &r12, SymmetricMatrix<double, 2> const &q1,
                            SymmetricMatrix<double, 2> const &q2) noexcept
{
    Overlap found{};
    int overlap_in_c = -1;
    found.status = static_cast<StatusCode>(pw85_overlap_2d(r12.coordinates, q1.entries, q2.entries,
                                                           &overlap_in_c));
    found.overlap = overlap_in_c == 1;
    found.tier = OverlapTier::unknown;
    return found;
}

/// Computes overlap_factored() by pw85_overlap_factored().
PW85_LINKED Overlap overlap_factored(Vector<double, 3> const &r12, Factor<double, 3> const &s1,
                                     Factor<double, 3> const &s2) noexcept
{
    Overlap found{};
    int overlap_in_c = -1;
    found.status = static_cast<StatusCode>(pw85_overlap_factored(r12.coordinates, s1.entries,
                                                                 s2.entries, &overlap_in_c));
    found.overlap = overlap_in_c == 1;
    found.tier = OverlapTier::unknown;
    return found;
}

/// Computes contains() by pw85_contains().
PW85_LINKED Containment contains(Vector<double, 3> const &r12, SymmetricMatrix<double, 3> const &q1,
                                 SymmetricMatrix<double, 3> const &q2) noexcept
{
    Containment found{};
    int contains_in_c = -1;
    found.status = static_cast<StatusCode>(pw85_contains(r12.coordinates, q1.entries, q2.entries,
                                                         &contains_in_c));
    found.contains = contains_in_c == 1;
    return found;
}

/// Computes contains() by pw85_contains_2d().
PW85_LINKED Containment contains(Vector<double, 2> const &r12, SymmetricMatrix<double, 2> const &q1,
                                 SymmetricMatrix<double, 2> const &q2) noexcept
{
    Containment found{};
    int contains_in_c = -1;
    found.status = static_cast<StatusCode>(pw85_contains_2d(r12.coordinates, q1.entries, q2.entries,
                                                            &contains_in_c));
    found.contains = contains_in_c == 1;
    return found;
}

/// Computes containment() by pw85_containment().
PW85_LINKED ContainmentScale<double, 3> containment(Vector<double, 3> const &r12,
                                                    SymmetricMatrix<double, 3> const &q1,
                                                    SymmetricMatrix<double, 3> const &q2) noexcept
{
    ContainmentScale<double, 3> found{};
    found.status = static_cast<StatusCode>(pw85_containment(r12.coordinates, q1.entries, q2.entries,
                                                            detail::out(found.mu2),
                                                            detail::out(found.point)));
    return found;
}

/// Computes containment() by pw85_containment_2d().
PW85_LINKED ContainmentScale<double, 2> containment(Vector<double, 2> const &r12,
                                                    SymmetricMatrix<double, 2> const &q1,
                                                    SymmetricMatrix<double, 2> const &q2) noexcept
{
    ContainmentScale<double, 2> found{};
    found.status = static_cast<StatusCode>(pw85_containment_2d(r12.coordinates, q1.entries,
                                                               q2.entries, detail::out(found.mu2),
                                                               detail::out(found.point)));
    return found;
}

/// Computes volume() by pw85_volume().
PW85_LINKED Volume<double> volume(SymmetricMatrix<double, 3> const &q) noexcept
{
    Volume<double> found{};
    found.status = static_cast<StatusCode>(pw85_volume(q.entries, detail::out(found.volume)));
    return found;
}

/// Computes area() by pw85_area_2d().
PW85_LINKED Area<double> area(SymmetricMatrix<double, 2> const &q) noexcept
{
    Area<double> found{};
    found.status = static_cast<StatusCode>(pw85_area_2d(q.entries, detail::out(found.area)));
    return found;
}

/// Computes surface_area() by pw85_surface_area().
PW85_LINKED Area<double> surface_area(SymmetricMatrix<double, 3> const &q) noexcept
{
    Area<double> found{};
    found.status = static_cast<StatusCode>(pw85_surface_area(q.entries, detail::out(found.area)));
    return found;
}

/// Computes perimeter() by pw85_perimeter_2d().
PW85_LINKED Perimeter<double> perimeter(SymmetricMatrix<double, 2> const &q) noexcept
{
    Perimeter<double> found{};
    found.status = static_cast<StatusCode>(pw85_perimeter_2d(q.entries,
                                                             detail::out(found.perimeter)));
    return found;
}

/// Computes second_moments() by pw85_second_moments().
PW85_LINKED Moments<double, 3> second_moments(SymmetricMatrix<double, 3> const &q) noexcept
{
    Moments<double, 3> found{};
    found.status = static_cast<StatusCode>(pw85_second_moments(q.entries,
                                                               detail::out(found.moments)));
    return found;
}

/// Computes second_moments() by pw85_second_moments_2d().
PW85_LINKED Moments<double, 2> second_moments(SymmetricMatrix<double, 2> const &q) noexcept
{
    Moments<double, 2> found{};
    found.status = static_cast<StatusCode>(pw85_second_moments_2d(q.entries,
                                                                  detail::out(found.moments)));
    return found;
}

/// Computes from_moments() by pw85_from_moments().
PW85_LINKED Form<double, 3> from_moments(SymmetricMatrix<double, 3> const &second_moments) noexcept
{
    Form<double, 3> found{};
    found.status = static_cast<StatusCode>(pw85_from_moments(second_moments.entries,
                                                             detail::out(found.q)));
    return found;
}

/// Computes from_moments() by pw85_from_moments_2d().
PW85_LINKED Form<double, 2> from_moments(SymmetricMatrix<double, 2> const &second_moments) noexcept
{
    Form<double, 2> found{};
    found.status = static_cast<StatusCode>(pw85_from_moments_2d(second_moments.entries,
                                                                detail::out(found.q)));
    return found;
}

/// Computes shell_moments() by pw85_shell_moments().
PW85_LINKED Moments<double, 3> shell_moments(SymmetricMatrix<double, 3> const &q) noexcept
{
    Moments<double, 3> found{};
    found.status = static_cast<StatusCode>(pw85_shell_moments(q.entries,
                                                              detail::out(found.moments)));
    return found;
}

/// Computes shell_moments() by pw85_shell_moments_2d().
PW85_LINKED Moments<double, 2> shell_moments(SymmetricMatrix<double, 2> const &q) noexcept
{
    Moments<double, 2> found{};
    found.status = static_cast<StatusCode>(pw85_shell_moments_2d(q.entries,
                                                                 detail::out(found.moments)));
    return found;
}

/// Computes inertia() by pw85_inertia().
PW85_LINKED Inertia<double> inertia(SymmetricMatrix<double, 3> const &q, int shell) noexcept
{
    Inertia<double> found{};
    found.status = static_cast<StatusCode>(pw85_inertia(q.entries, shell,
                                                        detail::out(found.inertia)));
    return found;
}

/// Computes overlap_volume() by pw85_overlap_volume().
PW85_LINKED Volume<double> overlap_volume(Vector<double, 3> const &r12,
                                          SymmetricMatrix<double, 3> const &q1,
                                          SymmetricMatrix<double, 3> const &q2) noexcept
{
    Volume<double> found{};
    found.status = static_cast<StatusCode>(pw85_overlap_volume(r12.coordinates, q1.entries,
                                                               q2.entries,
                                                               detail::out(found.volume)));
    return found;
}

/// Computes overlap_area() by pw85_overlap_area_2d().
PW85_LINKED Area<double> overlap_area(Vector<double, 2> const &r12,
                                      SymmetricMatrix<double, 2> const &q1,
                                      SymmetricMatrix<double, 2> const &q2) noexcept
{
    Area<double> found{};
    found.status = static_cast<StatusCode>(pw85_overlap_area_2d(r12.coordinates, q1.entries,
                                                                q2.entries,
                                                                detail::out(found.area)));
    return found;
}

/// Computes overlap_volume_gradient() by pw85_overlap_volume_gradient().
PW85_LINKED OverlapVolumeGradient<double> overlap_volume_gradient(
    Vector<double, 3> const &r12, SymmetricMatrix<double, 3> const &q1,
    SymmetricMatrix<double, 3> const &q2) noexcept
{
    OverlapVolumeGradient<double> found{};
    found.status = static_cast<StatusCode>(pw85_overlap_volume_gradient(r12.coordinates, q1.entries,
                                                                        q2.entries,
                                                                        detail::out(found.r12),
                                                                        detail::out(found.q1),
                                                                        detail::out(found.q2)));
    return found;
}

/// Computes overlap_volume_torque() by pw85_overlap_volume_torque().
PW85_LINKED OverlapVolumeTorque<double> overlap_volume_torque(
    Vector<double, 3> const &r12, SymmetricMatrix<double, 3> const &q1,
    SymmetricMatrix<double, 3> const &q2) noexcept
{
    OverlapVolumeTorque<double> found{};
    found.status = static_cast<StatusCode>(pw85_overlap_volume_torque(
        r12.coordinates, q1.entries, q2.entries, detail::out(found.rotation1),
        detail::out(found.rotation2)));
    return found;
}

/// Computes overlap_area_gradient() by pw85_overlap_area_gradient_2d().
PW85_LINKED OverlapAreaGradient<double> overlap_area_gradient(
    Vector<double, 2> const &r12, SymmetricMatrix<double, 2> const &q1,
    SymmetricMatrix<double, 2> const &q2) noexcept
{
    OverlapAreaGradient<double> found{};
    found.status = static_cast<StatusCode>(pw85_overlap_area_gradient_2d(r12.coordinates,
                                                                         q1.entries, q2.entries,
                                                                         detail::out(found.r12),
                                                                         detail::out(found.q1),
                                                                         detail::out(found.q2)));
    return found;
}

/// Computes overlap_area_torque() by pw85_overlap_area_torque_2d().
PW85_LINKED OverlapAreaTorque<double> overlap_area_torque(
    Vector<double, 2> const &r12, SymmetricMatrix<double, 2> const &q1,
    SymmetricMatrix<double, 2> const &q2) noexcept
{
    OverlapAreaTorque<double> found{};
    found.status = static_cast<StatusCode>(pw85_overlap_area_torque_2d(
        r12.coordinates, q1.entries, q2.entries, detail::out(found.rotation1),
        detail::out(found.rotation2)));
    return found;
}

/// Computes overlap_volume_plane() by pw85_overlap_volume_plane().
PW85_LINKED Volume<double> overlap_volume_plane(Vector<double, 3> const &normal, double offset,
                                                SymmetricMatrix<double, 3> const &q) noexcept
{
    Volume<double> found{};
    found.status = static_cast<StatusCode>(pw85_overlap_volume_plane(normal.coordinates, offset,
                                                                     q.entries,
                                                                     detail::out(found.volume)));
    return found;
}

/// Computes compare() by pw85_compare().
PW85_LINKED Comparison compare(Vector<double, 3> const &r12, SymmetricMatrix<double, 3> const &q1,
                               SymmetricMatrix<double, 3> const &q2, double mu2) noexcept
{
    Comparison found{};
    found.status = static_cast<StatusCode>(pw85_compare(r12.coordinates, q1.entries, q2.entries,
                                                        mu2, &found.sign));
    return found;
}

/// Computes closest_approach() by pw85_closest_approach().
PW85_LINKED ClosestApproach<double> closest_approach(Vector<double, 3> const &direction,
                                                     SymmetricMatrix<double, 3> const &q1,
                                                     SymmetricMatrix<double, 3> const &q2) noexcept
{
    ClosestApproach<double> found{};
    found.status = static_cast<StatusCode>(pw85_closest_approach(direction.coordinates, q1.entries,
                                                                 q2.entries,
                                                                 detail::out(found.distance)));
    return found;
}

/// Computes closest_approach() by pw85_closest_approach_2d().
PW85_LINKED ClosestApproach<double> closest_approach(Vector<double, 2> const &direction,
                                                     SymmetricMatrix<double, 2> const &q1,
                                                     SymmetricMatrix<double, 2> const &q2) noexcept
{
    ClosestApproach<double> found{};
    found.status = static_cast<StatusCode>(pw85_closest_approach_2d(direction.coordinates,
                                                                    q1.entries, q2.entries,
                                                                    detail::out(found.distance)));
    return found;
}

/// Computes distance() by pw85_distance_geometry().
PW85_LINKED Distance<double, 3> distance(Vector<double, 3> const &r12,
                                         SymmetricMatrix<double, 3> const &q1,
                                         SymmetricMatrix<double, 3> const &q2) noexcept
{
    Distance<double, 3> found{};
    found.status = static_cast<StatusCode>(pw85_distance_geometry(r12.coordinates, q1.entries,
                                                                  q2.entries,
                                                                  detail::out(found.distance),
                                                                  detail::out(found.point1),
                                                                  detail::out(found.point2),
                                                                  detail::out(found.normal)));
    return found;
}

/// Computes distance() by pw85_distance_geometry_2d().
PW85_LINKED Distance<double, 2> distance(Vector<double, 2> const &r12,
                                         SymmetricMatrix<double, 2> const &q1,
                                         SymmetricMatrix<double, 2> const &q2) noexcept
{
    Distance<double, 2> found{};
    found.status = static_cast<StatusCode>(pw85_distance_geometry_2d(r12.coordinates, q1.entries,
                                                                     q2.entries,
                                                                     detail::out(found.distance),
                                                                     detail::out(found.point1),
                                                                     detail::out(found.point2),
                                                                     detail::out(found.normal)));
    return found;
}

/// Computes distance_derivatives() by pw85_distance_derivatives().
PW85_LINKED DistanceDerivatives<double> distance_derivatives(
    Vector<double, 3> const &r12, SymmetricMatrix<double, 3> const &q1,
    SymmetricMatrix<double, 3> const &q2) noexcept
{
    DistanceDerivatives<double> found{};
    found.status = static_cast<StatusCode>(pw85_distance_derivatives(r12.coordinates, q1.entries,
                                                                     q2.entries,
                                                                     detail::out(found.r12),
                                                                     detail::out(found.rotation1),
                                                                     detail::out(found.rotation2),
                                                                     detail::out(found.hessian)));
    return found;
}

/// Computes penetration() by pw85_penetration().
PW85_LINKED Penetration<double, 3> penetration(Vector<double, 3> const &r12,
                                               SymmetricMatrix<double, 3> const &q1,
                                               SymmetricMatrix<double, 3> const &q2) noexcept
{
    Penetration<double, 3> found{};
    found.status = static_cast<StatusCode>(pw85_penetration(r12.coordinates, q1.entries, q2.entries,
                                                            detail::out(found.depth),
                                                            detail::out(found.direction)));
    return found;
}

/// Computes penetration() by pw85_penetration_2d().
PW85_LINKED Penetration<double, 2> penetration(Vector<double, 2> const &r12,
                                               SymmetricMatrix<double, 2> const &q1,
                                               SymmetricMatrix<double, 2> const &q2) noexcept
{
    Penetration<double, 2> found{};
    found.status = static_cast<StatusCode>(pw85_penetration_2d(r12.coordinates, q1.entries,
                                                               q2.entries, detail::out(found.depth),
                                                               detail::out(found.direction)));
    return found;
}

/// Computes gap_inside() by pw85_gap_inside().
PW85_LINKED GapInside<double, 3> gap_inside(Vector<double, 3> const &r12,
                                            SymmetricMatrix<double, 3> const &q1,
                                            SymmetricMatrix<double, 3> const &q2) noexcept
{
    GapInside<double, 3> found{};
    found.status = static_cast<StatusCode>(pw85_gap_inside(r12.coordinates, q1.entries, q2.entries,
                                                           detail::out(found.gap),
                                                           detail::out(found.point1),
                                                           detail::out(found.point2),
                                                           detail::out(found.normal)));
    return found;
}

/// Computes gap_inside() by pw85_gap_inside_2d().
PW85_LINKED GapInside<double, 2> gap_inside(Vector<double, 2> const &r12,
                                            SymmetricMatrix<double, 2> const &q1,
                                            SymmetricMatrix<double, 2> const &q2) noexcept
{
    GapInside<double, 2> found{};
    found.status = static_cast<StatusCode>(pw85_gap_inside_2d(r12.coordinates, q1.entries,
                                                              q2.entries, detail::out(found.gap),
                                                              detail::out(found.point1),
                                                              detail::out(found.point2),
                                                              detail::out(found.normal)));
    return found;
}

/// Computes signed_distance() by pw85_signed_distance_geometry().
PW85_LINKED Distance<double, 3> signed_distance(Vector<double, 3> const &r12,
                                                SymmetricMatrix<double, 3> const &q1,
                                                SymmetricMatrix<double, 3> const &q2) noexcept
{
    Distance<double, 3> found{};
    found.status = static_cast<StatusCode>(pw85_signed_distance_geometry(
        r12.coordinates, q1.entries, q2.entries, detail::out(found.distance),
        detail::out(found.point1), detail::out(found.point2), detail::out(found.normal)));
    return found;
}

/// Computes signed_distance() by pw85_signed_distance_geometry_2d().
PW85_LINKED Distance<double, 2> signed_distance(Vector<double, 2> const &r12,
                                                SymmetricMatrix<double, 2> const &q1,
                                                SymmetricMatrix<double, 2> const &q2) noexcept
{
    Distance<double, 2> found{};
    found.status = static_cast<StatusCode>(pw85_signed_distance_geometry_2d(
        r12.coordinates, q1.entries, q2.entries, detail::out(found.distance),
        detail::out(found.point1), detail::out(found.point2), detail::out(found.normal)));
    return found;
}

/// Computes signed_distance_derivatives() by pw85_signed_distance_derivatives().
PW85_LINKED DistanceDerivatives<double> signed_distance_derivatives(
    Vector<double, 3> const &r12, SymmetricMatrix<double, 3> const &q1,
    SymmetricMatrix<double, 3> const &q2) noexcept
{
    DistanceDerivatives<double> found{};
    found.status = static_cast<StatusCode>(pw85_signed_distance_derivatives(
        r12.coordinates, q1.entries, q2.entries, detail::out(found.r12),
        detail::out(found.rotation1), detail::out(found.rotation2), detail::out(found.hessian)));
    return found;
}

/// Computes first_contact() by pw85_first_contact().
PW85_LINKED FirstContact<double> first_contact(Vector<double, 3> const &r12,
                                               SymmetricMatrix<double, 3> const &q1,
                                               SymmetricMatrix<double, 3> const &q2,
                                               Motion<double, 3> const &motion1,
                                               Motion<double, 3> const &motion2,
                                               double t_max) noexcept
{
    FirstContact<double> found{};
    pw85_motion const motion1_in_c = detail::in_c(motion1);
    pw85_motion const motion2_in_c = detail::in_c(motion2);
    found.status = static_cast<StatusCode>(pw85_first_contact(r12.coordinates, q1.entries,
                                                              q2.entries, &motion1_in_c,
                                                              &motion2_in_c, t_max,
                                                              detail::out(found.time)));
    return found;
}

/// Computes closest_passage() by pw85_closest_passage().
PW85_LINKED ClosestPassage<double> closest_passage(Vector<double, 3> const &r12,
                                                   SymmetricMatrix<double, 3> const &q1,
                                                   SymmetricMatrix<double, 3> const &q2,
                                                   Vector<double, 3> const &velocity,
                                                   double t_max) noexcept
{
    ClosestPassage<double> found{};
    found.status = static_cast<StatusCode>(pw85_closest_passage(r12.coordinates, q1.entries,
                                                                q2.entries, velocity.coordinates,
                                                                t_max, detail::out(found.mu2),
                                                                detail::out(found.time)));
    return found;
}

/// Computes free_path() by pw85_free_path().
PW85_LINKED FreePath<double> free_path(Vector<double, 3> const &r12,
                                       SymmetricMatrix<double, 3> const &q1,
                                       SymmetricMatrix<double, 3> const &q2,
                                       Vector<double, 3> const &direction, double t_max) noexcept
{
    FreePath<double> found{};
    found.status = static_cast<StatusCode>(pw85_free_path(r12.coordinates, q1.entries, q2.entries,
                                                          direction.coordinates, t_max,
                                                          detail::out(found.length)));
    return found;
}

/// Computes curvature() by pw85_curvature().
PW85_LINKED Curvature<double> curvature(Vector<double, 3> const &normal,
                                        SymmetricMatrix<double, 3> const &q) noexcept
{
    Curvature<double> found{};
    double directions[6];
    found.status = static_cast<StatusCode>(pw85_curvature(normal.coordinates, q.entries,
                                                          detail::out(found.curvatures),
                                                          directions));
    found.direction1 = {directions[0], directions[1], directions[2]};
    found.direction2 = {directions[3], directions[4], directions[5]};
    return found;
}

/// Computes hertz_contact() by pw85_hertz_contact().
PW85_LINKED HertzContact<double> hertz_contact(Vector<double, 3> const &r12,
                                               SymmetricMatrix<double, 3> const &q1,
                                               SymmetricMatrix<double, 3> const &q2,
                                               Vector<double, 3> const &normal) noexcept
{
    HertzContact<double> found{};
    double directions[6];
    found.status = static_cast<StatusCode>(pw85_hertz_contact(
        r12.coordinates, q1.entries, q2.entries, normal.coordinates, detail::out(found.depth),
        detail::out(found.point), detail::out(found.relative.curvatures), directions,
        detail::out(found.hertz.radius), detail::out(found.hertz.ellipse)));
    found.relative.direction1 = {directions[0], directions[1], directions[2]};
    found.relative.direction2 = {directions[3], directions[4], directions[5]};
    found.relative.status = found.status;
    found.hertz.status = found.status;
    return found;
}

/// Computes grain_contact() by pw85_grain_contact().
PW85_LINKED GrainContact<double> grain_contact(Vector<double, 3> const &r12,
                                               SymmetricMatrix<double, 3> const &q1,
                                               SymmetricMatrix<double, 3> const &q2,
                                               Vector<double, 3> const &start) noexcept
{
    GrainContact<double> found{};
    found.status = static_cast<StatusCode>(pw85_grain_contact(r12.coordinates, q1.entries,
                                                              q2.entries, start.coordinates,
                                                              detail::out(found.normal),
                                                              detail::out(found.depth),
                                                              detail::out(found.point),
                                                              detail::out(found.curvatures),
                                                              detail::out(found.radius)));
    return found;
}

/// Computes grain_radius_gradient() by pw85_grain_radius_gradient().
PW85_LINKED GrainRadiusGradient<double> grain_radius_gradient(
    Vector<double, 3> const &r12, SymmetricMatrix<double, 3> const &q1,
    SymmetricMatrix<double, 3> const &q2, Vector<double, 3> const &normal) noexcept
{
    GrainRadiusGradient<double> found{};
    found.status = static_cast<StatusCode>(pw85_grain_radius_gradient(
        r12.coordinates, q1.entries, q2.entries, normal.coordinates, detail::out(found.r12),
        detail::out(found.rotation1), detail::out(found.rotation2)));
    return found;
}

/// Computes grain_contact_wall() by pw85_grain_contact_wall().
PW85_LINKED GrainWallContact<double> grain_contact_wall(
    Vector<double, 3> const &normal, double offset, Vector<double, 3> const &direction,
    double curvature, SymmetricMatrix<double, 3> const &q) noexcept
{
    GrainWallContact<double> found{};
    found.status = static_cast<StatusCode>(pw85_grain_contact_wall(normal.coordinates, offset,
                                                                   direction.coordinates, curvature,
                                                                   q.entries,
                                                                   detail::out(found.depth),
                                                                   detail::out(found.point),
                                                                   detail::out(found.curvatures),
                                                                   detail::out(found.radius)));
    return found;
}

/// Computes distance_plane_derivatives() by pw85_distance_plane_derivatives().
PW85_LINKED PlaneDerivatives<double> distance_plane_derivatives(
    Vector<double, 3> const &normal, SymmetricMatrix<double, 3> const &q) noexcept
{
    PlaneDerivatives<double> found{};
    found.status = static_cast<StatusCode>(pw85_distance_plane_derivatives(
        normal.coordinates, q.entries, detail::out(found.center), detail::out(found.rotation)));
    return found;
}

/// Computes contact_plane() by pw85_contact_plane().
PW85_LINKED PlaneContact<double, 3> contact_plane(Vector<double, 3> const &normal, double offset,
                                                  SymmetricMatrix<double, 3> const &q) noexcept
{
    PlaneContact<double, 3> found{};
    found.status = static_cast<StatusCode>(pw85_contact_plane(normal.coordinates, offset, q.entries,
                                                              detail::out(found.mu2),
                                                              detail::out(found.point)));
    return found;
}

/// Computes contact_plane_derivatives() by pw85_contact_plane_derivatives().
PW85_LINKED PlaneDerivatives<double> contact_plane_derivatives(
    Vector<double, 3> const &normal, double offset, SymmetricMatrix<double, 3> const &q) noexcept
{
    PlaneDerivatives<double> found{};
    found.status = static_cast<StatusCode>(pw85_contact_plane_derivatives(
        normal.coordinates, offset, q.entries, detail::out(found.center),
        detail::out(found.rotation)));
    return found;
}

/// Computes distance_box() by pw85_distance_box().
PW85_LINKED SurfaceDistance<double, 3> distance_box(Vector<double, 3> const &lower,
                                                    Vector<double, 3> const &upper,
                                                    SymmetricMatrix<double, 3> const &q) noexcept
{
    SurfaceDistance<double, 3> found{};
    found.status = static_cast<StatusCode>(pw85_distance_box(lower.coordinates, upper.coordinates,
                                                             q.entries, detail::out(found.distance),
                                                             detail::out(found.point),
                                                             detail::out(found.normal)));
    return found;
}

/// Computes distance_cylinder() by pw85_distance_cylinder().
PW85_LINKED SurfaceDistance<double, 3> distance_cylinder(
    Vector<double, 3> const &axis, double radius, Vector<double, 3> const &center,
    SymmetricMatrix<double, 3> const &q) noexcept
{
    SurfaceDistance<double, 3> found{};
    found.status = static_cast<StatusCode>(pw85_distance_cylinder(axis.coordinates, radius,
                                                                  center.coordinates, q.entries,
                                                                  detail::out(found.distance),
                                                                  detail::out(found.point),
                                                                  detail::out(found.normal)));
    return found;
}

/// Computes distance_point() by pw85_distance_point().
PW85_LINKED SurfaceDistance<double, 3> distance_point(Vector<double, 3> const &r,
                                                      SymmetricMatrix<double, 3> const &q) noexcept
{
    SurfaceDistance<double, 3> found{};
    found.status = static_cast<StatusCode>(pw85_distance_point(r.coordinates, q.entries,
                                                               detail::out(found.distance),
                                                               detail::out(found.point),
                                                               detail::out(found.normal)));
    return found;
}

/// Computes distance_point() by pw85_distance_point_2d().
PW85_LINKED SurfaceDistance<double, 2> distance_point(Vector<double, 2> const &r,
                                                      SymmetricMatrix<double, 2> const &q) noexcept
{
    SurfaceDistance<double, 2> found{};
    found.status = static_cast<StatusCode>(pw85_distance_point_2d(r.coordinates, q.entries,
                                                                  detail::out(found.distance),
                                                                  detail::out(found.point),
                                                                  detail::out(found.normal)));
    return found;
}

/// Computes intersect_line() by pw85_intersect_line().
PW85_LINKED Chord<double> intersect_line(Vector<double, 3> const &origin,
                                         Vector<double, 3> const &direction,
                                         SymmetricMatrix<double, 3> const &q) noexcept
{
    Chord<double> found{};
    double t[2];
    found.status = static_cast<StatusCode>(pw85_intersect_line(origin.coordinates,
                                                               direction.coordinates, q.entries,
                                                               t));
    found.enter = t[0];
    found.leave = t[1];
    return found;
}

/// Computes contact_segment() by pw85_contact_segment().
PW85_LINKED ShapeContact<double, 3> contact_segment(Vector<double, 3> const &end1,
                                                    Vector<double, 3> const &end2,
                                                    SymmetricMatrix<double, 3> const &q) noexcept
{
    ShapeContact<double, 3> found{};
    found.status = static_cast<StatusCode>(pw85_contact_segment(end1.coordinates, end2.coordinates,
                                                                q.entries, detail::out(found.mu2),
                                                                detail::out(found.point)));
    return found;
}

/// Computes contact_triangle() by pw85_contact_triangle().
PW85_LINKED ShapeContact<double, 3> contact_triangle(Vector<double, 3> const &vertex1,
                                                     Vector<double, 3> const &vertex2,
                                                     Vector<double, 3> const &vertex3,
                                                     SymmetricMatrix<double, 3> const &q) noexcept
{
    ShapeContact<double, 3> found{};
    found.status = static_cast<StatusCode>(pw85_contact_triangle(vertex1.coordinates,
                                                                 vertex2.coordinates,
                                                                 vertex3.coordinates, q.entries,
                                                                 detail::out(found.mu2),
                                                                 detail::out(found.point)));
    return found;
}

/// Computes contact_box() by pw85_contact_box().
PW85_LINKED ShapeContact<double, 3> contact_box(Vector<double, 3> const &lower,
                                                Vector<double, 3> const &upper,
                                                SymmetricMatrix<double, 3> const &q) noexcept
{
    ShapeContact<double, 3> found{};
    found.status = static_cast<StatusCode>(pw85_contact_box(lower.coordinates, upper.coordinates,
                                                            q.entries, detail::out(found.mu2),
                                                            detail::out(found.point)));
    return found;
}

/// Computes overlap_segment() by pw85_overlap_segment().
PW85_LINKED ShapeOverlap overlap_segment(Vector<double, 3> const &end1,
                                         Vector<double, 3> const &end2,
                                         SymmetricMatrix<double, 3> const &q) noexcept
{
    ShapeOverlap found{};
    int overlap_in_c = -1;
    found.status = static_cast<StatusCode>(pw85_overlap_segment(end1.coordinates, end2.coordinates,
                                                                q.entries, &overlap_in_c));
    found.overlap = overlap_in_c == 1;
    return found;
}

/// Computes overlap_triangle() by pw85_overlap_triangle().
PW85_LINKED ShapeOverlap overlap_triangle(Vector<double, 3> const &vertex1,
                                          Vector<double, 3> const &vertex2,
                                          Vector<double, 3> const &vertex3,
                                          SymmetricMatrix<double, 3> const &q) noexcept
{
    ShapeOverlap found{};
    int overlap_in_c = -1;
    found.status = static_cast<StatusCode>(pw85_overlap_triangle(vertex1.coordinates,
                                                                 vertex2.coordinates,
                                                                 vertex3.coordinates, q.entries,
                                                                 &overlap_in_c));
    found.overlap = overlap_in_c == 1;
    return found;
}

/// Computes overlap_box() by pw85_overlap_box().
PW85_LINKED ShapeOverlap overlap_box(Vector<double, 3> const &lower, Vector<double, 3> const &upper,
                                     SymmetricMatrix<double, 3> const &q) noexcept
{
    ShapeOverlap found{};
    int overlap_in_c = -1;
    found.status = static_cast<StatusCode>(pw85_overlap_box(lower.coordinates, upper.coordinates,
                                                            q.entries, &overlap_in_c));
    found.overlap = overlap_in_c == 1;
    return found;
}

/// Computes distance_segment() by pw85_distance_segment().
PW85_LINKED ShapeDistance<double> distance_segment(Vector<double, 3> const &end1,
                                                   Vector<double, 3> const &end2,
                                                   SymmetricMatrix<double, 3> const &q) noexcept
{
    ShapeDistance<double> found{};
    found.status = static_cast<StatusCode>(pw85_distance_segment(end1.coordinates, end2.coordinates,
                                                                 q.entries,
                                                                 detail::out(found.distance),
                                                                 detail::out(found.point1),
                                                                 detail::out(found.point2),
                                                                 detail::out(found.normal)));
    return found;
}

/// Computes distance_triangle() by pw85_distance_triangle().
PW85_LINKED ShapeDistance<double> distance_triangle(Vector<double, 3> const &vertex1,
                                                    Vector<double, 3> const &vertex2,
                                                    Vector<double, 3> const &vertex3,
                                                    SymmetricMatrix<double, 3> const &q) noexcept
{
    ShapeDistance<double> found{};
    found.status = static_cast<StatusCode>(pw85_distance_triangle(vertex1.coordinates,
                                                                  vertex2.coordinates,
                                                                  vertex3.coordinates, q.entries,
                                                                  detail::out(found.distance),
                                                                  detail::out(found.point1),
                                                                  detail::out(found.point2),
                                                                  detail::out(found.normal)));
    return found;
}

/// Computes distance_solid_box() by pw85_distance_solid_box().
PW85_LINKED ShapeDistance<double> distance_solid_box(Vector<double, 3> const &lower,
                                                     Vector<double, 3> const &upper,
                                                     SymmetricMatrix<double, 3> const &q) noexcept
{
    ShapeDistance<double> found{};
    found.status = static_cast<StatusCode>(pw85_distance_solid_box(lower.coordinates,
                                                                   upper.coordinates, q.entries,
                                                                   detail::out(found.distance),
                                                                   detail::out(found.point1),
                                                                   detail::out(found.point2),
                                                                   detail::out(found.normal)));
    return found;
}

/// Computes contact_capsule() by pw85_contact_capsule().
PW85_LINKED ShapeContact<double, 3> contact_capsule(Vector<double, 3> const &end1,
                                                    Vector<double, 3> const &end2, double radius,
                                                    SymmetricMatrix<double, 3> const &q) noexcept
{
    ShapeContact<double, 3> found{};
    found.status = static_cast<StatusCode>(pw85_contact_capsule(end1.coordinates, end2.coordinates,
                                                                radius, q.entries,
                                                                detail::out(found.mu2),
                                                                detail::out(found.point)));
    return found;
}

/// Computes overlap_capsule() by pw85_overlap_capsule().
PW85_LINKED ShapeOverlap overlap_capsule(Vector<double, 3> const &end1,
                                         Vector<double, 3> const &end2, double radius,
                                         SymmetricMatrix<double, 3> const &q) noexcept
{
    ShapeOverlap found{};
    int overlap_in_c = -1;
    found.status = static_cast<StatusCode>(pw85_overlap_capsule(end1.coordinates, end2.coordinates,
                                                                radius, q.entries, &overlap_in_c));
    found.overlap = overlap_in_c == 1;
    return found;
}

/// Computes distance_capsule() by pw85_distance_capsule().
PW85_LINKED ShapeDistance<double> distance_capsule(Vector<double, 3> const &end1,
                                                   Vector<double, 3> const &end2, double radius,
                                                   SymmetricMatrix<double, 3> const &q) noexcept
{
    ShapeDistance<double> found{};
    found.status = static_cast<StatusCode>(pw85_distance_capsule(end1.coordinates, end2.coordinates,
                                                                 radius, q.entries,
                                                                 detail::out(found.distance),
                                                                 detail::out(found.point1),
                                                                 detail::out(found.point2),
                                                                 detail::out(found.normal)));
    return found;
}

/// Computes contact_segment() by pw85_contact_segment_2d().
PW85_LINKED ShapeContact<double, 2> contact_segment(Vector<double, 2> const &end1,
                                                    Vector<double, 2> const &end2,
                                                    SymmetricMatrix<double, 2> const &q) noexcept
{
    ShapeContact<double, 2> found{};
    found.status = static_cast<StatusCode>(pw85_contact_segment_2d(end1.coordinates,
                                                                   end2.coordinates, q.entries,
                                                                   detail::out(found.mu2),
                                                                   detail::out(found.point)));
    return found;
}

/// Computes contact_box() by pw85_contact_box_2d().
PW85_LINKED ShapeContact<double, 2> contact_box(Vector<double, 2> const &lower,
                                                Vector<double, 2> const &upper,
                                                SymmetricMatrix<double, 2> const &q) noexcept
{
    ShapeContact<double, 2> found{};
    found.status = static_cast<StatusCode>(pw85_contact_box_2d(lower.coordinates, upper.coordinates,
                                                               q.entries, detail::out(found.mu2),
                                                               detail::out(found.point)));
    return found;
}

/// Computes overlap_segment() by pw85_overlap_segment_2d().
PW85_LINKED ShapeOverlap overlap_segment(Vector<double, 2> const &end1,
                                         Vector<double, 2> const &end2,
                                         SymmetricMatrix<double, 2> const &q) noexcept
{
    ShapeOverlap found{};
    int overlap_in_c = -1;
    found.status = static_cast<StatusCode>(pw85_overlap_segment_2d(end1.coordinates,
                                                                   end2.coordinates, q.entries,
                                                                   &overlap_in_c));
    found.overlap = overlap_in_c == 1;
    return found;
}

/// Computes overlap_box() by pw85_overlap_box_2d().
PW85_LINKED ShapeOverlap overlap_box(Vector<double, 2> const &lower, Vector<double, 2> const &upper,
                                     SymmetricMatrix<double, 2> const &q) noexcept
{
    ShapeOverlap found{};
    int overlap_in_c = -1;
    found.status = static_cast<StatusCode>(pw85_overlap_box_2d(lower.coordinates, upper.coordinates,
                                                               q.entries, &overlap_in_c));
    found.overlap = overlap_in_c == 1;
    return found;
}
// clang-format on

/// Computes contact_polytope() by pw85_contact_polytope_batch(), which takes a centre.
PW85_LINKED ShapeContact<double, 3> contact_polytope(std::size_t n, double const *normals,
                                                     double const *offsets,
                                                     SymmetricMatrix<double, 3> const &q,
                                                     Vector<double, 3> const &center = {}) noexcept
{
    ShapeContact<double, 3> found{};
    found.status = static_cast<StatusCode>(
        pw85_contact_polytope_batch(1, center.coordinates, q.entries, n, normals, offsets,
                                    &found.mu2, found.point.coordinates));
    return found;
}

/// Computes overlap_polytope() by pw85_overlap_polytope_batch(), which takes a centre.
PW85_LINKED ShapeOverlap overlap_polytope(std::size_t n, double const *normals,
                                          double const *offsets,
                                          SymmetricMatrix<double, 3> const &q,
                                          Vector<double, 3> const &center = {}) noexcept
{
    ShapeOverlap found{};
    unsigned char answer = 0;
    found.status = static_cast<StatusCode>(pw85_overlap_polytope_batch(
        1, center.coordinates, q.entries, n, normals, offsets, &answer));
    found.overlap = answer == 1;
    return found;
}

} // namespace pw85

#undef PW85_LINKED

#endif
