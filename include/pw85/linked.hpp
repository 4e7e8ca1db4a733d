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
/// Calls with other numbers take the templates, and so do these functions with doubles, of which
/// the C API leaves out a part of the result or which constant expressions call: spheroid(),
/// ellipsoid(), ellipsoid_quaternion(), ellipsoid_factor(), bounding_box(), decide_overlap(),
/// overlap_witness(), distance(), signed_distance(), curvature(), hertz(), hertz_contact(),
/// distance_plane(), contact_polytope(), overlap_polytope().
///
/// The functions have external linkage: exported inline functions of modules may call them. They
/// are always inlined: no unit runs the code of another one. They are not for device code.

// Made from pw85.hpp and pw85.h by api/committed.py.
// clang-format off
#ifndef PW85_LINKED_HPP_INCLUDED
#define PW85_LINKED_HPP_INCLUDED

#include <pw85.h>

#include <pw85/pw85.hpp>

#define PW85_LINKED [[gnu::always_inline]] inline

namespace pw85 {

namespace detail::linked {

// Inputs and outputs as arguments of the C API.

PW85_LINKED double in(double x) noexcept { return x; }

PW85_LINKED int in(int x) noexcept { return x; }

template <int D> PW85_LINKED double const *in(Vector<double, D> const &v) noexcept
{
    return v.coordinates;
}

template <int D> PW85_LINKED double const *in(SymmetricMatrix<double, D> const &m) noexcept
{
    return m.entries;
}

template <int D> PW85_LINKED double const *in(Factor<double, D> const &s) noexcept
{
    return s.entries;
}

template <class Number> PW85_LINKED Number *out(Number &x) noexcept { return &x; }

template <int D> PW85_LINKED double *out(Vector<double, D> &v) noexcept { return v.coordinates; }

template <int D> PW85_LINKED double *out(SymmetricMatrix<double, D> &m) noexcept
{
    return m.entries;
}

template <int D> PW85_LINKED double *out(Factor<double, D> &s) noexcept { return s.entries; }

template <std::size_t N> PW85_LINKED double *out(double (&rows)[N][N]) noexcept
{
    return &rows[0][0];
}

/// A motion, for as long as the call lasts.
struct MotionInC {
    pw85_motion motion;

    [[gnu::always_inline]] explicit MotionInC(Motion<double, 3> const &m) noexcept
        : motion{{m.velocity[0], m.velocity[1], m.velocity[2]},
                 {m.angular_velocity[0], m.angular_velocity[1], m.angular_velocity[2]},
                 m.growth}
    {
    }

    [[gnu::always_inline]] operator pw85_motion const *() const noexcept { return &motion; }
};

PW85_LINKED MotionInC in(Motion<double, 3> const &m) noexcept { return MotionInC(m); }

} // namespace detail::linked

/// Computes ellipse() by pw85_ellipse().
PW85_LINKED Form<double, 2> ellipse(double const &a, double const &b, double const &angle) noexcept
{
    using namespace detail::linked;
    Form<double, 2> result;
    int const status = pw85_ellipse(in(a), in(b), in(angle), out(result.q));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes contact() by pw85_contact().
PW85_LINKED Contact<double> contact(Vector<double, 3> const &r12,
                                    SymmetricMatrix<double, 3> const &q1,
                                    SymmetricMatrix<double, 3> const &q2) noexcept
{
    using namespace detail::linked;
    Contact<double> result;
    double numbers[2];
    int const status = pw85_contact(in(r12), in(q1), in(q2), numbers);
    result.status = static_cast<StatusCode>(status);
    result.mu2 = numbers[0];
    result.lambda = numbers[1];
    return result;
}

/// Computes contact() by pw85_contact_2d().
PW85_LINKED Contact<double> contact(Vector<double, 2> const &r12,
                                    SymmetricMatrix<double, 2> const &q1,
                                    SymmetricMatrix<double, 2> const &q2) noexcept
{
    using namespace detail::linked;
    Contact<double> result;
    double numbers[2];
    int const status = pw85_contact_2d(in(r12), in(q1), in(q2), numbers);
    result.status = static_cast<StatusCode>(status);
    result.mu2 = numbers[0];
    result.lambda = numbers[1];
    return result;
}

/// Computes contact_rounded() by pw85_contact_rounded().
PW85_LINKED Contact<double> contact_rounded(Vector<double, 3> const &r12,
                                            SymmetricMatrix<double, 3> const &q1,
                                            SymmetricMatrix<double, 3> const &q2) noexcept
{
    using namespace detail::linked;
    Contact<double> result;
    double numbers[2];
    int const status = pw85_contact_rounded(in(r12), in(q1), in(q2), numbers);
    result.status = static_cast<StatusCode>(status);
    result.mu2 = numbers[0];
    result.lambda = numbers[1];
    return result;
}

/// Computes contact_factored() by pw85_contact_factored().
PW85_LINKED Contact<double> contact_factored(Vector<double, 3> const &r12,
                                             Factor<double, 3> const &s1,
                                             Factor<double, 3> const &s2) noexcept
{
    using namespace detail::linked;
    Contact<double> result;
    double numbers[2];
    int const status = pw85_contact_factored(in(r12), in(s1), in(s2), numbers);
    result.status = static_cast<StatusCode>(status);
    result.mu2 = numbers[0];
    result.lambda = numbers[1];
    return result;
}

/// Computes condition() by pw85_condition().
PW85_LINKED Condition<double> condition(Vector<double, 3> const &r12,
                                        SymmetricMatrix<double, 3> const &q1,
                                        SymmetricMatrix<double, 3> const &q2,
                                        double const &lambda) noexcept
{
    using namespace detail::linked;
    Condition<double> result;
    int const status = pw85_condition(in(r12), in(q1), in(q2), in(lambda), out(result.condition));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes contact_geometry() by pw85_contact_geometry().
PW85_LINKED ContactGeometry<double, 3> contact_geometry(Vector<double, 3> const &r12,
                                                        SymmetricMatrix<double, 3> const &q1,
                                                        SymmetricMatrix<double, 3> const &q2,
                                                        double const &lambda) noexcept
{
    using namespace detail::linked;
    ContactGeometry<double, 3> result;
    int const status = pw85_contact_geometry(in(r12), in(q1), in(q2), in(lambda), out(result.point),
                                             out(result.normal));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes contact_geometry() by pw85_contact_geometry_2d().
PW85_LINKED ContactGeometry<double, 2> contact_geometry(Vector<double, 2> const &r12,
                                                        SymmetricMatrix<double, 2> const &q1,
                                                        SymmetricMatrix<double, 2> const &q2,
                                                        double const &lambda) noexcept
{
    using namespace detail::linked;
    ContactGeometry<double, 2> result;
    int const status = pw85_contact_geometry_2d(in(r12), in(q1), in(q2), in(lambda),
                                                out(result.point), out(result.normal));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes contact_gradient() by pw85_contact_gradient().
PW85_LINKED ContactGradient<double, 3> contact_gradient(Vector<double, 3> const &r12,
                                                        SymmetricMatrix<double, 3> const &q1,
                                                        SymmetricMatrix<double, 3> const &q2,
                                                        double const &lambda) noexcept
{
    using namespace detail::linked;
    ContactGradient<double, 3> result;
    int const status = pw85_contact_gradient(in(r12), in(q1), in(q2), in(lambda), out(result.r12),
                                             out(result.q1), out(result.q2));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes contact_gradient() by pw85_contact_gradient_2d().
PW85_LINKED ContactGradient<double, 2> contact_gradient(Vector<double, 2> const &r12,
                                                        SymmetricMatrix<double, 2> const &q1,
                                                        SymmetricMatrix<double, 2> const &q2,
                                                        double const &lambda) noexcept
{
    using namespace detail::linked;
    ContactGradient<double, 2> result;
    int const status = pw85_contact_gradient_2d(in(r12), in(q1), in(q2), in(lambda),
                                                out(result.r12), out(result.q1), out(result.q2));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes contact_geometry_factored() by pw85_contact_geometry_factored().
PW85_LINKED ContactGeometry<double, 3> contact_geometry_factored(Vector<double, 3> const &r12,
                                                                 Factor<double, 3> const &s1,
                                                                 Factor<double, 3> const &s2,
                                                                 double const &lambda) noexcept
{
    using namespace detail::linked;
    ContactGeometry<double, 3> result;
    int const status = pw85_contact_geometry_factored(in(r12), in(s1), in(s2), in(lambda),
                                                      out(result.point), out(result.normal));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes contact_gradient_factored() by pw85_contact_gradient_factored().
PW85_LINKED FactorGradient<double, 3> contact_gradient_factored(Vector<double, 3> const &r12,
                                                                Factor<double, 3> const &s1,
                                                                Factor<double, 3> const &s2,
                                                                double const &lambda) noexcept
{
    using namespace detail::linked;
    FactorGradient<double, 3> result;
    int const status = pw85_contact_gradient_factored(in(r12), in(s1), in(s2), in(lambda),
                                                      out(result.r12), out(result.s1),
                                                      out(result.s2));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes contact_torque() by pw85_contact_torque().
PW85_LINKED ContactTorque<double, 3> contact_torque(Vector<double, 3> const &r12,
                                                    SymmetricMatrix<double, 3> const &q1,
                                                    SymmetricMatrix<double, 3> const &q2,
                                                    double const &lambda) noexcept
{
    using namespace detail::linked;
    ContactTorque<double, 3> result;
    int const status = pw85_contact_torque(in(r12), in(q1), in(q2), in(lambda),
                                           out(result.rotation1), out(result.rotation2));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes contact_torque() by pw85_contact_torque_2d().
PW85_LINKED ContactTorque<double, 2> contact_torque(Vector<double, 2> const &r12,
                                                    SymmetricMatrix<double, 2> const &q1,
                                                    SymmetricMatrix<double, 2> const &q2,
                                                    double const &lambda) noexcept
{
    using namespace detail::linked;
    ContactTorque<double, 2> result;
    int const status = pw85_contact_torque_2d(in(r12), in(q1), in(q2), in(lambda),
                                              out(result.rotation1), out(result.rotation2));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes contact_hessian() by pw85_contact_hessian().
PW85_LINKED ContactHessian<double, 3> contact_hessian(Vector<double, 3> const &r12,
                                                      SymmetricMatrix<double, 3> const &q1,
                                                      SymmetricMatrix<double, 3> const &q2,
                                                      double const &lambda) noexcept
{
    using namespace detail::linked;
    ContactHessian<double, 3> result;
    int const status = pw85_contact_hessian(in(r12), in(q1), in(q2), in(lambda),
                                            out(result.entries));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes contact_hessian() by pw85_contact_hessian_2d().
PW85_LINKED ContactHessian<double, 2> contact_hessian(Vector<double, 2> const &r12,
                                                      SymmetricMatrix<double, 2> const &q1,
                                                      SymmetricMatrix<double, 2> const &q2,
                                                      double const &lambda) noexcept
{
    using namespace detail::linked;
    ContactHessian<double, 2> result;
    int const status = pw85_contact_hessian_2d(in(r12), in(q1), in(q2), in(lambda),
                                               out(result.entries));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes overlap() by pw85_overlap().
PW85_LINKED Overlap overlap(Vector<double, 3> const &r12, SymmetricMatrix<double, 3> const &q1,
                            SymmetricMatrix<double, 3> const &q2) noexcept
{
    using namespace detail::linked;
    Overlap result;
    int answer = 0;
    int const status = pw85_overlap(in(r12), in(q1), in(q2), &answer);
    result.status = static_cast<StatusCode>(status);
    result.overlap = answer == 1;
    result.tier = OverlapTier::unknown;
    return result;
}

/// Computes overlap() by pw85_overlap_2d().
PW85_LINKED Overlap overlap(Vector<double, 2> const &r12, SymmetricMatrix<double, 2> const &q1,
                            SymmetricMatrix<double, 2> const &q2) noexcept
{
    using namespace detail::linked;
    Overlap result;
    int answer = 0;
    int const status = pw85_overlap_2d(in(r12), in(q1), in(q2), &answer);
    result.status = static_cast<StatusCode>(status);
    result.overlap = answer == 1;
    result.tier = OverlapTier::unknown;
    return result;
}

/// Computes overlap_factored() by pw85_overlap_factored().
PW85_LINKED Overlap overlap_factored(Vector<double, 3> const &r12, Factor<double, 3> const &s1,
                                     Factor<double, 3> const &s2) noexcept
{
    using namespace detail::linked;
    Overlap result;
    int answer = 0;
    int const status = pw85_overlap_factored(in(r12), in(s1), in(s2), &answer);
    result.status = static_cast<StatusCode>(status);
    result.overlap = answer == 1;
    result.tier = OverlapTier::unknown;
    return result;
}

/// Computes contains() by pw85_contains().
PW85_LINKED Containment contains(Vector<double, 3> const &r12, SymmetricMatrix<double, 3> const &q1,
                                 SymmetricMatrix<double, 3> const &q2) noexcept
{
    using namespace detail::linked;
    Containment result;
    int answer = 0;
    int const status = pw85_contains(in(r12), in(q1), in(q2), &answer);
    result.status = static_cast<StatusCode>(status);
    result.contains = answer == 1;
    return result;
}

/// Computes contains() by pw85_contains_2d().
PW85_LINKED Containment contains(Vector<double, 2> const &r12, SymmetricMatrix<double, 2> const &q1,
                                 SymmetricMatrix<double, 2> const &q2) noexcept
{
    using namespace detail::linked;
    Containment result;
    int answer = 0;
    int const status = pw85_contains_2d(in(r12), in(q1), in(q2), &answer);
    result.status = static_cast<StatusCode>(status);
    result.contains = answer == 1;
    return result;
}

/// Computes containment() by pw85_containment().
PW85_LINKED ContainmentScale<double, 3> containment(Vector<double, 3> const &r12,
                                                    SymmetricMatrix<double, 3> const &q1,
                                                    SymmetricMatrix<double, 3> const &q2) noexcept
{
    using namespace detail::linked;
    ContainmentScale<double, 3> result;
    int const status = pw85_containment(in(r12), in(q1), in(q2), out(result.mu2),
                                        out(result.point));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes containment() by pw85_containment_2d().
PW85_LINKED ContainmentScale<double, 2> containment(Vector<double, 2> const &r12,
                                                    SymmetricMatrix<double, 2> const &q1,
                                                    SymmetricMatrix<double, 2> const &q2) noexcept
{
    using namespace detail::linked;
    ContainmentScale<double, 2> result;
    int const status = pw85_containment_2d(in(r12), in(q1), in(q2), out(result.mu2),
                                           out(result.point));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes volume() by pw85_volume().
PW85_LINKED Volume<double> volume(SymmetricMatrix<double, 3> const &q) noexcept
{
    using namespace detail::linked;
    Volume<double> result;
    int const status = pw85_volume(in(q), out(result.volume));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes area() by pw85_area_2d().
PW85_LINKED Area<double> area(SymmetricMatrix<double, 2> const &q) noexcept
{
    using namespace detail::linked;
    Area<double> result;
    int const status = pw85_area_2d(in(q), out(result.area));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes surface_area() by pw85_surface_area().
PW85_LINKED Area<double> surface_area(SymmetricMatrix<double, 3> const &q) noexcept
{
    using namespace detail::linked;
    Area<double> result;
    int const status = pw85_surface_area(in(q), out(result.area));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes perimeter() by pw85_perimeter_2d().
PW85_LINKED Perimeter<double> perimeter(SymmetricMatrix<double, 2> const &q) noexcept
{
    using namespace detail::linked;
    Perimeter<double> result;
    int const status = pw85_perimeter_2d(in(q), out(result.perimeter));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes second_moments() by pw85_second_moments().
PW85_LINKED Moments<double, 3> second_moments(SymmetricMatrix<double, 3> const &q) noexcept
{
    using namespace detail::linked;
    Moments<double, 3> result;
    int const status = pw85_second_moments(in(q), out(result.moments));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes second_moments() by pw85_second_moments_2d().
PW85_LINKED Moments<double, 2> second_moments(SymmetricMatrix<double, 2> const &q) noexcept
{
    using namespace detail::linked;
    Moments<double, 2> result;
    int const status = pw85_second_moments_2d(in(q), out(result.moments));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes from_moments() by pw85_from_moments().
PW85_LINKED Form<double, 3> from_moments(SymmetricMatrix<double, 3> const &second_moments) noexcept
{
    using namespace detail::linked;
    Form<double, 3> result;
    int const status = pw85_from_moments(in(second_moments), out(result.q));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes from_moments() by pw85_from_moments_2d().
PW85_LINKED Form<double, 2> from_moments(SymmetricMatrix<double, 2> const &second_moments) noexcept
{
    using namespace detail::linked;
    Form<double, 2> result;
    int const status = pw85_from_moments_2d(in(second_moments), out(result.q));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes shell_moments() by pw85_shell_moments().
PW85_LINKED Moments<double, 3> shell_moments(SymmetricMatrix<double, 3> const &q) noexcept
{
    using namespace detail::linked;
    Moments<double, 3> result;
    int const status = pw85_shell_moments(in(q), out(result.moments));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes shell_moments() by pw85_shell_moments_2d().
PW85_LINKED Moments<double, 2> shell_moments(SymmetricMatrix<double, 2> const &q) noexcept
{
    using namespace detail::linked;
    Moments<double, 2> result;
    int const status = pw85_shell_moments_2d(in(q), out(result.moments));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes inertia() by pw85_inertia().
PW85_LINKED Inertia<double> inertia(SymmetricMatrix<double, 3> const &q, int shell) noexcept
{
    using namespace detail::linked;
    Inertia<double> result;
    int const status = pw85_inertia(in(q), in(shell), out(result.inertia));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes overlap_volume() by pw85_overlap_volume().
PW85_LINKED Volume<double> overlap_volume(Vector<double, 3> const &r12,
                                          SymmetricMatrix<double, 3> const &q1,
                                          SymmetricMatrix<double, 3> const &q2) noexcept
{
    using namespace detail::linked;
    Volume<double> result;
    int const status = pw85_overlap_volume(in(r12), in(q1), in(q2), out(result.volume));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes overlap_area() by pw85_overlap_area_2d().
PW85_LINKED Area<double> overlap_area(Vector<double, 2> const &r12,
                                      SymmetricMatrix<double, 2> const &q1,
                                      SymmetricMatrix<double, 2> const &q2) noexcept
{
    using namespace detail::linked;
    Area<double> result;
    int const status = pw85_overlap_area_2d(in(r12), in(q1), in(q2), out(result.area));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes overlap_volume_gradient() by pw85_overlap_volume_gradient().
PW85_LINKED OverlapVolumeGradient<double> overlap_volume_gradient(
    Vector<double, 3> const &r12, SymmetricMatrix<double, 3> const &q1,
    SymmetricMatrix<double, 3> const &q2) noexcept
{
    using namespace detail::linked;
    OverlapVolumeGradient<double> result;
    int const status = pw85_overlap_volume_gradient(in(r12), in(q1), in(q2), out(result.r12),
                                                    out(result.q1), out(result.q2));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes overlap_volume_torque() by pw85_overlap_volume_torque().
PW85_LINKED OverlapVolumeTorque<double> overlap_volume_torque(
    Vector<double, 3> const &r12, SymmetricMatrix<double, 3> const &q1,
    SymmetricMatrix<double, 3> const &q2) noexcept
{
    using namespace detail::linked;
    OverlapVolumeTorque<double> result;
    int const status = pw85_overlap_volume_torque(in(r12), in(q1), in(q2), out(result.rotation1),
                                                  out(result.rotation2));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes overlap_area_gradient() by pw85_overlap_area_gradient_2d().
PW85_LINKED OverlapAreaGradient<double> overlap_area_gradient(
    Vector<double, 2> const &r12, SymmetricMatrix<double, 2> const &q1,
    SymmetricMatrix<double, 2> const &q2) noexcept
{
    using namespace detail::linked;
    OverlapAreaGradient<double> result;
    int const status = pw85_overlap_area_gradient_2d(in(r12), in(q1), in(q2), out(result.r12),
                                                     out(result.q1), out(result.q2));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes overlap_area_torque() by pw85_overlap_area_torque_2d().
PW85_LINKED OverlapAreaTorque<double> overlap_area_torque(
    Vector<double, 2> const &r12, SymmetricMatrix<double, 2> const &q1,
    SymmetricMatrix<double, 2> const &q2) noexcept
{
    using namespace detail::linked;
    OverlapAreaTorque<double> result;
    int const status = pw85_overlap_area_torque_2d(in(r12), in(q1), in(q2), out(result.rotation1),
                                                   out(result.rotation2));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes overlap_volume_plane() by pw85_overlap_volume_plane().
PW85_LINKED Volume<double> overlap_volume_plane(Vector<double, 3> const &normal,
                                                double const &offset,
                                                SymmetricMatrix<double, 3> const &q) noexcept
{
    using namespace detail::linked;
    Volume<double> result;
    int const status = pw85_overlap_volume_plane(in(normal), in(offset), in(q), out(result.volume));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes compare() by pw85_compare().
PW85_LINKED Comparison compare(Vector<double, 3> const &r12, SymmetricMatrix<double, 3> const &q1,
                               SymmetricMatrix<double, 3> const &q2, double const &mu2) noexcept
{
    using namespace detail::linked;
    Comparison result;
    int const status = pw85_compare(in(r12), in(q1), in(q2), in(mu2), out(result.sign));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes closest_approach() by pw85_closest_approach().
PW85_LINKED ClosestApproach<double> closest_approach(Vector<double, 3> direction,
                                                     SymmetricMatrix<double, 3> const &q1,
                                                     SymmetricMatrix<double, 3> const &q2) noexcept
{
    using namespace detail::linked;
    ClosestApproach<double> result;
    int const status = pw85_closest_approach(in(direction), in(q1), in(q2), out(result.distance));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes closest_approach() by pw85_closest_approach_2d().
PW85_LINKED ClosestApproach<double> closest_approach(Vector<double, 2> direction,
                                                     SymmetricMatrix<double, 2> const &q1,
                                                     SymmetricMatrix<double, 2> const &q2) noexcept
{
    using namespace detail::linked;
    ClosestApproach<double> result;
    int const status = pw85_closest_approach_2d(in(direction), in(q1), in(q2),
                                                out(result.distance));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes distance_derivatives() by pw85_distance_derivatives().
PW85_LINKED DistanceDerivatives<double> distance_derivatives(
    Vector<double, 3> const &r12, SymmetricMatrix<double, 3> const &q1,
    SymmetricMatrix<double, 3> const &q2) noexcept
{
    using namespace detail::linked;
    DistanceDerivatives<double> result;
    int const status = pw85_distance_derivatives(in(r12), in(q1), in(q2), out(result.r12),
                                                 out(result.rotation1), out(result.rotation2),
                                                 out(result.hessian));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes penetration() by pw85_penetration().
PW85_LINKED Penetration<double, 3> penetration(Vector<double, 3> const &r12,
                                               SymmetricMatrix<double, 3> const &q1,
                                               SymmetricMatrix<double, 3> const &q2) noexcept
{
    using namespace detail::linked;
    Penetration<double, 3> result;
    int const status = pw85_penetration(in(r12), in(q1), in(q2), out(result.depth),
                                        out(result.direction));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes penetration() by pw85_penetration_2d().
PW85_LINKED Penetration<double, 2> penetration(Vector<double, 2> const &r12,
                                               SymmetricMatrix<double, 2> const &q1,
                                               SymmetricMatrix<double, 2> const &q2) noexcept
{
    using namespace detail::linked;
    Penetration<double, 2> result;
    int const status = pw85_penetration_2d(in(r12), in(q1), in(q2), out(result.depth),
                                           out(result.direction));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes gap_inside() by pw85_gap_inside().
PW85_LINKED GapInside<double, 3> gap_inside(Vector<double, 3> const &r12,
                                            SymmetricMatrix<double, 3> const &q1,
                                            SymmetricMatrix<double, 3> const &q2) noexcept
{
    using namespace detail::linked;
    GapInside<double, 3> result;
    int const status = pw85_gap_inside(in(r12), in(q1), in(q2), out(result.gap), out(result.point1),
                                       out(result.point2), out(result.normal));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes gap_inside() by pw85_gap_inside_2d().
PW85_LINKED GapInside<double, 2> gap_inside(Vector<double, 2> const &r12,
                                            SymmetricMatrix<double, 2> const &q1,
                                            SymmetricMatrix<double, 2> const &q2) noexcept
{
    using namespace detail::linked;
    GapInside<double, 2> result;
    int const status = pw85_gap_inside_2d(in(r12), in(q1), in(q2), out(result.gap),
                                          out(result.point1), out(result.point2),
                                          out(result.normal));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes signed_distance_derivatives() by pw85_signed_distance_derivatives().
PW85_LINKED DistanceDerivatives<double> signed_distance_derivatives(
    Vector<double, 3> const &r12, SymmetricMatrix<double, 3> const &q1,
    SymmetricMatrix<double, 3> const &q2) noexcept
{
    using namespace detail::linked;
    DistanceDerivatives<double> result;
    int const status = pw85_signed_distance_derivatives(in(r12), in(q1), in(q2), out(result.r12),
                                                        out(result.rotation1),
                                                        out(result.rotation2), out(result.hessian));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes first_contact() by pw85_first_contact().
PW85_LINKED FirstContact<double> first_contact(Vector<double, 3> const &r12,
                                               SymmetricMatrix<double, 3> const &q1,
                                               SymmetricMatrix<double, 3> const &q2,
                                               Motion<double, 3> const &motion1,
                                               Motion<double, 3> const &motion2,
                                               double const &t_max) noexcept
{
    using namespace detail::linked;
    FirstContact<double> result;
    int const status = pw85_first_contact(in(r12), in(q1), in(q2), in(motion1), in(motion2),
                                          in(t_max), out(result.time));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes closest_passage() by pw85_closest_passage().
PW85_LINKED ClosestPassage<double> closest_passage(Vector<double, 3> const &r12,
                                                   SymmetricMatrix<double, 3> const &q1,
                                                   SymmetricMatrix<double, 3> const &q2,
                                                   Vector<double, 3> const &velocity,
                                                   double const &t_max) noexcept
{
    using namespace detail::linked;
    ClosestPassage<double> result;
    int const status = pw85_closest_passage(in(r12), in(q1), in(q2), in(velocity), in(t_max),
                                            out(result.mu2), out(result.time));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes free_path() by pw85_free_path().
PW85_LINKED FreePath<double> free_path(Vector<double, 3> const &r12,
                                       SymmetricMatrix<double, 3> const &q1,
                                       SymmetricMatrix<double, 3> const &q2,
                                       Vector<double, 3> const &direction,
                                       double const &t_max) noexcept
{
    using namespace detail::linked;
    FreePath<double> result;
    int const status = pw85_free_path(in(r12), in(q1), in(q2), in(direction), in(t_max),
                                      out(result.length));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes grain_contact() by pw85_grain_contact().
PW85_LINKED GrainContact<double> grain_contact(Vector<double, 3> const &r12,
                                               SymmetricMatrix<double, 3> const &q1,
                                               SymmetricMatrix<double, 3> const &q2,
                                               Vector<double, 3> start) noexcept
{
    using namespace detail::linked;
    GrainContact<double> result;
    int const status = pw85_grain_contact(in(r12), in(q1), in(q2), in(start), out(result.normal),
                                          out(result.depth), out(result.point),
                                          out(result.curvatures), out(result.radius));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes grain_radius_gradient() by pw85_grain_radius_gradient().
PW85_LINKED GrainRadiusGradient<double> grain_radius_gradient(Vector<double, 3> const &r12,
                                                              SymmetricMatrix<double, 3> const &q1,
                                                              SymmetricMatrix<double, 3> const &q2,
                                                              Vector<double, 3> normal) noexcept
{
    using namespace detail::linked;
    GrainRadiusGradient<double> result;
    int const status = pw85_grain_radius_gradient(in(r12), in(q1), in(q2), in(normal),
                                                  out(result.r12), out(result.rotation1),
                                                  out(result.rotation2));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes grain_contact_wall() by pw85_grain_contact_wall().
PW85_LINKED GrainWallContact<double> grain_contact_wall(
    Vector<double, 3> const &normal, double const &offset, Vector<double, 3> direction,
    double const &curvature_of_wall, SymmetricMatrix<double, 3> const &q) noexcept
{
    using namespace detail::linked;
    GrainWallContact<double> result;
    int const status = pw85_grain_contact_wall(in(normal), in(offset), in(direction),
                                               in(curvature_of_wall), in(q), out(result.depth),
                                               out(result.point), out(result.curvatures),
                                               out(result.radius));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes distance_plane_derivatives() by pw85_distance_plane_derivatives().
PW85_LINKED PlaneDerivatives<double> distance_plane_derivatives(
    Vector<double, 3> const &normal, SymmetricMatrix<double, 3> const &q) noexcept
{
    using namespace detail::linked;
    PlaneDerivatives<double> result;
    int const status = pw85_distance_plane_derivatives(in(normal), in(q), out(result.center),
                                                       out(result.rotation));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes contact_plane() by pw85_contact_plane().
PW85_LINKED PlaneContact<double, 3> contact_plane(Vector<double, 3> const &normal,
                                                  double const &offset,
                                                  SymmetricMatrix<double, 3> const &q) noexcept
{
    using namespace detail::linked;
    PlaneContact<double, 3> result;
    int const status = pw85_contact_plane(in(normal), in(offset), in(q), out(result.mu2),
                                          out(result.point));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes contact_plane_derivatives() by pw85_contact_plane_derivatives().
PW85_LINKED PlaneDerivatives<double> contact_plane_derivatives(
    Vector<double, 3> const &normal, double const &offset,
    SymmetricMatrix<double, 3> const &q) noexcept
{
    using namespace detail::linked;
    PlaneDerivatives<double> result;
    int const status = pw85_contact_plane_derivatives(in(normal), in(offset), in(q),
                                                      out(result.center), out(result.rotation));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes distance_box() by pw85_distance_box().
PW85_LINKED SurfaceDistance<double, 3> distance_box(Vector<double, 3> const &lower,
                                                    Vector<double, 3> const &upper,
                                                    SymmetricMatrix<double, 3> const &q) noexcept
{
    using namespace detail::linked;
    SurfaceDistance<double, 3> result;
    int const status = pw85_distance_box(in(lower), in(upper), in(q), out(result.distance),
                                         out(result.point), out(result.normal));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes distance_cylinder() by pw85_distance_cylinder().
PW85_LINKED SurfaceDistance<double, 3> distance_cylinder(
    Vector<double, 3> axis, double const &radius, Vector<double, 3> const &center,
    SymmetricMatrix<double, 3> const &q) noexcept
{
    using namespace detail::linked;
    SurfaceDistance<double, 3> result;
    int const status = pw85_distance_cylinder(in(axis), in(radius), in(center), in(q),
                                              out(result.distance), out(result.point),
                                              out(result.normal));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes distance_point() by pw85_distance_point().
PW85_LINKED SurfaceDistance<double, 3> distance_point(Vector<double, 3> const &r,
                                                      SymmetricMatrix<double, 3> const &q) noexcept
{
    using namespace detail::linked;
    SurfaceDistance<double, 3> result;
    int const status = pw85_distance_point(in(r), in(q), out(result.distance), out(result.point),
                                           out(result.normal));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes distance_point() by pw85_distance_point_2d().
PW85_LINKED SurfaceDistance<double, 2> distance_point(Vector<double, 2> const &r,
                                                      SymmetricMatrix<double, 2> const &q) noexcept
{
    using namespace detail::linked;
    SurfaceDistance<double, 2> result;
    int const status = pw85_distance_point_2d(in(r), in(q), out(result.distance), out(result.point),
                                              out(result.normal));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes intersect_line() by pw85_intersect_line().
PW85_LINKED Chord<double> intersect_line(Vector<double, 3> const &origin,
                                         Vector<double, 3> const &direction,
                                         SymmetricMatrix<double, 3> const &q) noexcept
{
    using namespace detail::linked;
    Chord<double> result;
    double numbers[2];
    int const status = pw85_intersect_line(in(origin), in(direction), in(q), numbers);
    result.status = static_cast<StatusCode>(status);
    result.enter = numbers[0];
    result.leave = numbers[1];
    return result;
}

/// Computes contact_segment() by pw85_contact_segment().
PW85_LINKED ShapeContact<double, 3> contact_segment(Vector<double, 3> const &end1,
                                                    Vector<double, 3> const &end2,
                                                    SymmetricMatrix<double, 3> const &q) noexcept
{
    using namespace detail::linked;
    ShapeContact<double, 3> result;
    int const status = pw85_contact_segment(in(end1), in(end2), in(q), out(result.mu2),
                                            out(result.point));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes contact_triangle() by pw85_contact_triangle().
PW85_LINKED ShapeContact<double, 3> contact_triangle(Vector<double, 3> const &vertex1,
                                                     Vector<double, 3> const &vertex2,
                                                     Vector<double, 3> const &vertex3,
                                                     SymmetricMatrix<double, 3> const &q) noexcept
{
    using namespace detail::linked;
    ShapeContact<double, 3> result;
    int const status = pw85_contact_triangle(in(vertex1), in(vertex2), in(vertex3), in(q),
                                             out(result.mu2), out(result.point));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes contact_box() by pw85_contact_box().
PW85_LINKED ShapeContact<double, 3> contact_box(Vector<double, 3> const &lower,
                                                Vector<double, 3> const &upper,
                                                SymmetricMatrix<double, 3> const &q) noexcept
{
    using namespace detail::linked;
    ShapeContact<double, 3> result;
    int const status = pw85_contact_box(in(lower), in(upper), in(q), out(result.mu2),
                                        out(result.point));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes overlap_segment() by pw85_overlap_segment().
PW85_LINKED ShapeOverlap overlap_segment(Vector<double, 3> const &end1,
                                         Vector<double, 3> const &end2,
                                         SymmetricMatrix<double, 3> const &q) noexcept
{
    using namespace detail::linked;
    ShapeOverlap result;
    int answer = 0;
    int const status = pw85_overlap_segment(in(end1), in(end2), in(q), &answer);
    result.status = static_cast<StatusCode>(status);
    result.overlap = answer == 1;
    return result;
}

/// Computes overlap_triangle() by pw85_overlap_triangle().
PW85_LINKED ShapeOverlap overlap_triangle(Vector<double, 3> const &vertex1,
                                          Vector<double, 3> const &vertex2,
                                          Vector<double, 3> const &vertex3,
                                          SymmetricMatrix<double, 3> const &q) noexcept
{
    using namespace detail::linked;
    ShapeOverlap result;
    int answer = 0;
    int const status = pw85_overlap_triangle(in(vertex1), in(vertex2), in(vertex3), in(q), &answer);
    result.status = static_cast<StatusCode>(status);
    result.overlap = answer == 1;
    return result;
}

/// Computes overlap_box() by pw85_overlap_box().
PW85_LINKED ShapeOverlap overlap_box(Vector<double, 3> const &lower, Vector<double, 3> const &upper,
                                     SymmetricMatrix<double, 3> const &q) noexcept
{
    using namespace detail::linked;
    ShapeOverlap result;
    int answer = 0;
    int const status = pw85_overlap_box(in(lower), in(upper), in(q), &answer);
    result.status = static_cast<StatusCode>(status);
    result.overlap = answer == 1;
    return result;
}

/// Computes distance_segment() by pw85_distance_segment().
PW85_LINKED ShapeDistance<double> distance_segment(Vector<double, 3> const &end1,
                                                   Vector<double, 3> const &end2,
                                                   SymmetricMatrix<double, 3> const &q) noexcept
{
    using namespace detail::linked;
    ShapeDistance<double> result;
    int const status = pw85_distance_segment(in(end1), in(end2), in(q), out(result.distance),
                                             out(result.point1), out(result.point2),
                                             out(result.normal));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes distance_triangle() by pw85_distance_triangle().
PW85_LINKED ShapeDistance<double> distance_triangle(Vector<double, 3> const &vertex1,
                                                    Vector<double, 3> const &vertex2,
                                                    Vector<double, 3> const &vertex3,
                                                    SymmetricMatrix<double, 3> const &q) noexcept
{
    using namespace detail::linked;
    ShapeDistance<double> result;
    int const status = pw85_distance_triangle(in(vertex1), in(vertex2), in(vertex3), in(q),
                                              out(result.distance), out(result.point1),
                                              out(result.point2), out(result.normal));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes distance_solid_box() by pw85_distance_solid_box().
PW85_LINKED ShapeDistance<double> distance_solid_box(Vector<double, 3> const &lower,
                                                     Vector<double, 3> const &upper,
                                                     SymmetricMatrix<double, 3> const &q) noexcept
{
    using namespace detail::linked;
    ShapeDistance<double> result;
    int const status = pw85_distance_solid_box(in(lower), in(upper), in(q), out(result.distance),
                                               out(result.point1), out(result.point2),
                                               out(result.normal));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes contact_capsule() by pw85_contact_capsule().
PW85_LINKED ShapeContact<double, 3> contact_capsule(Vector<double, 3> const &end1,
                                                    Vector<double, 3> const &end2,
                                                    double const &radius,
                                                    SymmetricMatrix<double, 3> const &q) noexcept
{
    using namespace detail::linked;
    ShapeContact<double, 3> result;
    int const status = pw85_contact_capsule(in(end1), in(end2), in(radius), in(q), out(result.mu2),
                                            out(result.point));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes overlap_capsule() by pw85_overlap_capsule().
PW85_LINKED ShapeOverlap overlap_capsule(Vector<double, 3> const &end1,
                                         Vector<double, 3> const &end2, double const &radius,
                                         SymmetricMatrix<double, 3> const &q) noexcept
{
    using namespace detail::linked;
    ShapeOverlap result;
    int answer = 0;
    int const status = pw85_overlap_capsule(in(end1), in(end2), in(radius), in(q), &answer);
    result.status = static_cast<StatusCode>(status);
    result.overlap = answer == 1;
    return result;
}

/// Computes distance_capsule() by pw85_distance_capsule().
PW85_LINKED ShapeDistance<double> distance_capsule(Vector<double, 3> const &end1,
                                                   Vector<double, 3> const &end2,
                                                   double const &radius,
                                                   SymmetricMatrix<double, 3> const &q) noexcept
{
    using namespace detail::linked;
    ShapeDistance<double> result;
    int const status = pw85_distance_capsule(in(end1), in(end2), in(radius), in(q),
                                             out(result.distance), out(result.point1),
                                             out(result.point2), out(result.normal));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes contact_segment() by pw85_contact_segment_2d().
PW85_LINKED ShapeContact<double, 2> contact_segment(Vector<double, 2> const &end1,
                                                    Vector<double, 2> const &end2,
                                                    SymmetricMatrix<double, 2> const &q) noexcept
{
    using namespace detail::linked;
    ShapeContact<double, 2> result;
    int const status = pw85_contact_segment_2d(in(end1), in(end2), in(q), out(result.mu2),
                                               out(result.point));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes contact_box() by pw85_contact_box_2d().
PW85_LINKED ShapeContact<double, 2> contact_box(Vector<double, 2> const &lower,
                                                Vector<double, 2> const &upper,
                                                SymmetricMatrix<double, 2> const &q) noexcept
{
    using namespace detail::linked;
    ShapeContact<double, 2> result;
    int const status = pw85_contact_box_2d(in(lower), in(upper), in(q), out(result.mu2),
                                           out(result.point));
    result.status = static_cast<StatusCode>(status);
    return result;
}

/// Computes overlap_segment() by pw85_overlap_segment_2d().
PW85_LINKED ShapeOverlap overlap_segment(Vector<double, 2> const &end1,
                                         Vector<double, 2> const &end2,
                                         SymmetricMatrix<double, 2> const &q) noexcept
{
    using namespace detail::linked;
    ShapeOverlap result;
    int answer = 0;
    int const status = pw85_overlap_segment_2d(in(end1), in(end2), in(q), &answer);
    result.status = static_cast<StatusCode>(status);
    result.overlap = answer == 1;
    return result;
}

/// Computes overlap_box() by pw85_overlap_box_2d().
PW85_LINKED ShapeOverlap overlap_box(Vector<double, 2> const &lower, Vector<double, 2> const &upper,
                                     SymmetricMatrix<double, 2> const &q) noexcept
{
    using namespace detail::linked;
    ShapeOverlap result;
    int answer = 0;
    int const status = pw85_overlap_box_2d(in(lower), in(upper), in(q), &answer);
    result.status = static_cast<StatusCode>(status);
    result.overlap = answer == 1;
    return result;
}

} // namespace pw85

#undef PW85_LINKED

#endif
