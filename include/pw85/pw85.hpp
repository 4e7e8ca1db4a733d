/// @file
/// The contact function of Perram and Wertheim for two ellipsoids: the C++ entry header.
///
/// Everything is a template over the scalar `T` (float, double, long double, a multiprecision number) and, where it
/// makes sense, the dimension `D` (2 or 3); inline, noexcept, without allocation, exceptions or state. See pw85.h for
/// the definitions and the meaning of each function; here results are values, with a `status` that is
/// `pw85::Status::success` or says why every number in them is NaN.
///
///     using namespace pw85;
///     Vector r12{1.0, 0.0, 0.0};
///     auto [q1, ok1] = ellipsoid_quaternion(Vector{3.0, 2.0, 1.0}, Vector{1.0, 0.0, 0.0, 0.0});
///     auto [q2, ok2] = spheroid(1.0, 2.0, Vector{0.0, 1.0, 0.0});
///     auto [mu2, lambda, status] = contact(r12, q1, q2);
///
/// Arguments: `r12` = c2 - c1, `q1` and `q2` the quadratic forms, all in one unit of length; `lambda` a maximiser found
/// by contact().
#ifndef PW85_PW85_HPP_INCLUDED
#define PW85_PW85_HPP_INCLUDED

#include <pw85/status.hpp>
#include <pw85/symmetric.hpp>

namespace pw85 {

template <class T, int D> struct Form;            // q, status
template <class T> struct Contact;                // mu2, lambda, status
template <class T, int D> struct ContactGeometry; // point, normal, status
template <class T, int D> struct ContactGradient; // r12, q1, q2, status
template <class T> struct ContactTorque;          // rotation1, rotation2, status
template <class T> struct ClosestApproach;        // distance, status
template <class T, int D> struct BoundingBox;     // half_widths, status
struct Overlap;                                   // overlap, tier, status
template <class T, int D> struct OverlapWitness;  // overlap, lambda, direction, point, status
template <class T, int D> struct Distance;        // distance, point1, point2, normal, status
template <class T> struct DistanceDerivatives;    // r12, rotation1, rotation2, hessian, status
template <class T, int D> struct SurfaceDistance; // distance, point, normal, status
template <class T> struct PlaneDerivatives;       // center, rotation, status
template <class T, int D> struct PlaneContact;    // mu2, point, status
template <class T> struct Chord;                  // enter, leave, status
template <class T, int D> struct Motion;          // velocity, angular_velocity, growth
template <class T> struct FirstContact;           // time, status

/// Form of a spheroid with equatorial radius `a`, polar radius `c`, and axis along `n`.
template <class T> PW85_FUNCTION constexpr Form<T, 3> spheroid(T const &a, T const &c, Vector<T, 3> n) noexcept;

/// Form of a general ellipsoid; the columns of the row-major `rotation` are its principal directions.
template <class T>
PW85_FUNCTION constexpr Form<T, 3> ellipsoid(Vector<T, 3> const &semi_axes, T const (&rotation)[9]) noexcept;

/// Form of a general ellipsoid oriented by the quaternion (w, x, y, z), of any length > 0.
template <class T> PW85_FUNCTION constexpr Form<T, 3> ellipsoid_quaternion(Vector<T, 3> const &semi_axes,
                                                                           Vector<T, 4> quaternion) noexcept;

/// Form of an ellipse with semi-axes `a` and `b`, the first at `angle` (radians) from the x axis.
template <class T> PW85_FUNCTION inline Form<T, 2> ellipse(T const &a, T const &b, T const &angle) noexcept;

/// Half-widths of the tight box with sides along the axes.
template <class T, int D> PW85_FUNCTION inline BoundingBox<T, D> bounding_box(SymmetricMatrix<T, D> const &q) noexcept;

/// The contact function μ² and its maximiser λ.
template <class T, int D> PW85_FUNCTION inline Contact<T>
contact(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2) noexcept;

/// Contact point and common normal of the ellipsoids scaled by μ.
template <class T, int D>
PW85_FUNCTION inline ContactGeometry<T, D> contact_geometry(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                                                            SymmetricMatrix<T, D> const &q2, T const &lambda) noexcept;

/// Derivatives of μ² with respect to r12 and the stored entries of q1 and q2.
template <class T, int D>
PW85_FUNCTION inline ContactGradient<T, D> contact_gradient(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                                                            SymmetricMatrix<T, D> const &q2, T const &lambda) noexcept;

/// Derivatives of μ² with respect to rotations of the ellipsoids about their own centres.
template <class T>
PW85_FUNCTION inline ContactTorque<T> contact_torque(Vector<T, 3> const &r12, SymmetricMatrix<T, 3> const &q1,
                                                     SymmetricMatrix<T, 3> const &q2, T const &lambda) noexcept;

/// Whether two ellipsoids overlap, μ² < 1, decided exactly for the numbers given.
template <class T, int D> PW85_FUNCTION inline Overlap overlap(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                                                               SymmetricMatrix<T, D> const &q2) noexcept;

/// The same with what shows it: a separating direction, or a point inside both.
template <class T, int D> PW85_FUNCTION inline OverlapWitness<T, D>
overlap_witness(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2) noexcept;

/// Distance of closest approach along `direction`, of any length > 0.
template <class T, int D> PW85_FUNCTION inline ClosestApproach<T>
closest_approach(Vector<T, D> direction, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2) noexcept;

/// Distance of the surfaces, closest points and common normal; zero and NaN points if the ellipsoids overlap.
template <class T, int D> PW85_FUNCTION inline Distance<T, D>
distance(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2) noexcept;

/// First and second derivatives of the distance with respect to r12 and rotations of the ellipsoids about their own centres.
template <class T>
PW85_FUNCTION inline DistanceDerivatives<T> distance_derivatives(Vector<T, 3> const &r12,
                                                                 SymmetricMatrix<T, 3> const &q1,
                                                                 SymmetricMatrix<T, 3> const &q2) noexcept;

/// The time of the first contact of two ellipsoids that move, not after `end`; infinity if there is none.
template <class T, int D>
PW85_FUNCTION inline FirstContact<T> first_contact(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                                                   SymmetricMatrix<T, D> const &q2, Motion<T, D> const &motion1,
                                                   Motion<T, D> const &motion2, T const &end) noexcept;

/// Distance from an ellipsoid with its centre at 0 to the half-space normal·x >= offset.
template <class T, int D> PW85_FUNCTION inline SurfaceDistance<T, D>
distance_plane(Vector<T, D> const &normal, T const &offset, SymmetricMatrix<T, D> const &q) noexcept;

/// Derivatives of the distance to a half-space with respect to the centre of the ellipsoid and to rotations about it.
template <class T> PW85_FUNCTION inline PlaneDerivatives<T>
distance_plane_derivatives(Vector<T, 3> const &normal, SymmetricMatrix<T, 3> const &q) noexcept;

/// Contact function of an ellipsoid with its centre at 0 and the half-space normal·x >= offset.
template <class T, int D> PW85_FUNCTION inline PlaneContact<T, D>
contact_plane(Vector<T, D> const &normal, T const &offset, SymmetricMatrix<T, D> const &q) noexcept;

/// Distance from an ellipsoid with its centre at 0 to the nearest face of the box lower <= x <= upper around it.
template <class T, int D> PW85_FUNCTION inline SurfaceDistance<T, D>
distance_box(Vector<T, D> const &lower, Vector<T, D> const &upper, SymmetricMatrix<T, D> const &q) noexcept;

/// Distance from an ellipsoid to the wall of a cylinder around it, whose axis goes through 0.
template <class T>
PW85_FUNCTION inline SurfaceDistance<T, 3> distance_cylinder(Vector<T, 3> axis, T const &radius,
                                                             Vector<T, 3> const &center,
                                                             SymmetricMatrix<T, 3> const &q) noexcept;

/// Distance from the point r, relative to the centre, to the surface of an ellipsoid; negative inside.
template <class T, int D> PW85_FUNCTION inline SurfaceDistance<T, D>
distance_point(Vector<T, D> const &r, SymmetricMatrix<T, D> const &q) noexcept;

/// The part of the line origin + t·direction, relative to the centre, that is in an ellipsoid.
template <class T, int D> PW85_FUNCTION inline Chord<T>
intersect_line(Vector<T, D> const &origin, Vector<T, D> const &direction, SymmetricMatrix<T, D> const &q) noexcept;

} // namespace pw85

#include <pw85/bounding_box.hpp>
#include <pw85/closest_approach.hpp>
#include <pw85/contact.hpp>
#include <pw85/distance.hpp>
#include <pw85/distance_derivatives.hpp>
#include <pw85/first_contact.hpp>
#include <pw85/forms.hpp>
#include <pw85/geometry.hpp>
#include <pw85/line.hpp>
#include <pw85/nearest.hpp>
#include <pw85/overlap.hpp>
#include <pw85/walls.hpp>

#endif
