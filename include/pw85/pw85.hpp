// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The contact function of Perram and Wertheim for two ellipsoids: C++ templates over the scalar
/// type, in headers only.
///
/// The ellipsoid with centre c and quadratic form Q is the set of the points m for which (m-c)ᵀ Q⁻¹
/// (m-c) <= 1. The matrix Q is symmetric and positive definite. Its eigenvalues are the squares of
/// the semi-axes, and its eigenvectors are their directions. For two ellipsoids with centres c1 and
/// c2, forms Q1 and Q2, and r12 = c2 - c1, the contact function is
///
///     μ² = max { f(λ), 0 <= λ <= 1 },    f(λ) = λ(1-λ) r12ᵀ [(1-λ) Q1 + λ Q2]⁻¹ r12.
///
/// The square root μ is a scale factor: if both ellipsoids are scaled by μ about their centres,
/// they touch from outside. The ellipsoids overlap if μ² < 1, touch if μ² = 1, and are apart if μ²
/// > 1.
///
///     using namespace pw85;
///     Vector r12{1.0, 0.0, 0.0};
///     Vector axes{3.0, 2.0, 1.0};
///     Vector quaternion{1.0, 0.0, 0.0, 0.0};
///     auto [q1, status1] = ellipsoid_quaternion(axes, quaternion);
///     auto [q2, status2] = spheroid(1.0, 2.0, Vector{0.0, 1.0, 0.0});
///     auto [mu2, lambda, status] = contact(r12, q1, q2);
///
/// These conventions hold for every function unless its contract says otherwise:
///
/// - `T` is float, double, long double or a multiprecision number such as those of Boost. `D` is
///   the dimension, 2 or 3. u is the unit roundoff of `T`, 2⁻⁵³ for double.
/// - A Vector has `D` coordinates. A SymmetricMatrix stores the upper triangle in row-major order:
///   (xx, xy, xz, yy, yz, zz), or (xx, xy, yy) in two dimensions.
/// - All lengths have the same unit, which the caller chooses. Forms have the square of this unit.
///   μ² and λ are dimensionless.
/// - The result is a struct that contains a Status. If the status is not Status::success, every
///   number of the result is NaN. Status::invalid_argument has two causes, in every function: a
///   number is NaN or infinite; an argument is outside the range that its description states, such
///   as "> 0". Status::not_positive_definite means that a form is not positive definite.
/// - Every function is noexcept, and constexpr if C++20 allows it. No function allocates memory,
///   has state, or prints anything.
/// - In double, no intermediate result overflows or underflows if semi-axes and distances are from
///   1e-150 to 1e150.
/// - The reproducible mode of the compiled library, pw85_set_reproducible(), does not apply to the
///   templates.
/// - The functions are compiled with the flags of the translation unit that includes them, and run
///   in the caller's floating-point environment. They do not compile with `-ffast-math` unless
///   PW85_ALLOW_FAST_MATH is defined.
///
/// Related headers:
///
/// - pw85/batch.hpp: many pairs, as spans; needs the compiled library, which chooses the
///   instruction set at run time.
/// - pw85/systems.hpp: pair lists, neighbour lists, forces, meshes and periodic cells;
///   pw85/simulation.hpp: Monte Carlo.
/// - pw85/history/legacy.hpp: the rational form of f and superseded solvers.
///   pw85/history/zheng.hpp: the distance of closest approach by the algorithms of Zheng et al.
///   Both headers are for comparison with the contact function.
/// - pw85.h: the C API of the compiled library. It also has Brent's method as in pw85 1.0, which
///   the library takes from GSL or from Boost.Math.
/// - The definitions are in the folders algebra/, contact/, overlap/, distance/, motion/, shapes/,
///   volume/ and bodies/. Each header there has one subject, and explains its mathematics at its
///   top and next to its functions. Names that are not public are in namespace pw85::detail.
#ifndef PW85_PW85_HPP_INCLUDED
#define PW85_PW85_HPP_INCLUDED

#include <pw85/algebra/matrix_entries.hpp>
#include <pw85/algebra/symmetric.hpp>
#include <pw85/status.hpp>

namespace pw85 {

template <class T, int D> struct Form;             // q, status
template <class T, int D> struct Factor;           // entries
template <class T, int D> struct EllipsoidFactor;  // s, status
template <class T> struct Contact;                 // mu2, lambda, status
template <class T> struct Condition;               // condition, status
template <class T, int D> struct ContactGeometry;  // point, normal, status
template <class T, int D> struct ContactGradient;  // r12, q1, q2, status
template <class T, int D> struct FactorGradient;   // r12, s1, s2, status
template <class T, int D> struct ContactTorque;    // rotation1, rotation2, status
template <class T, int D> struct ContactHessian;   // entries, status
template <class T> struct ClosestApproach;         // distance, status
template <class T, int D> struct BoundingBox;      // half_widths, status
struct Overlap;                                    // overlap, tier, status
struct OverlapDecision;                            // decision, tier, status
template <class T, int D> struct OverlapWitness;   // overlap, lambda, direction, point, status
struct Containment;                                // contains, status
template <class T> struct Volume;                  // volume, status
template <class T> struct Area;                    // area, status
template <class T> struct Perimeter;               // perimeter, status
template <class T, int D> struct Moments;          // moments, status
template <class T> struct Inertia;                 // inertia, status
template <class T> struct OverlapVolumeGradient;   // r12, q1, q2, status
template <class T> struct OverlapVolumeTorque;     // rotation1, rotation2, status
template <class T> struct OverlapAreaGradient;     // r12, q1, q2, status
template <class T> struct OverlapAreaTorque;       // rotation1, rotation2, status
template <class T, int D> struct ContainmentScale; // mu2, point, status
struct Comparison;                                 // sign, status
template <class T, int D> struct Distance;         // distance, point1, point2, normal, status
template <class T> struct DistanceDerivatives;     // r12, rotation1, rotation2, hessian, status
template <class T, int D> struct SurfaceDistance;  // distance, point, normal, status
template <class T> struct PlaneDerivatives;        // center, rotation, status
template <class T, int D> struct PlaneContact;     // mu2, point, status
template <class T> struct Chord;                   // enter, leave, status
template <class T> struct Curvature;               // curvatures, direction1, direction2, status
template <class T> struct HertzEllipse;            // radius, ellipse, status
template <class T> struct HertzContact;            // depth, point, relative, hertz, status
template <class T> struct GrainContact;        // normal, depth, point, curvatures, radius, status
template <class T> struct GrainRadiusGradient; // r12, rotation1, rotation2, status
template <class T> struct GrainWallContact;    // depth, point, curvatures, radius, status
template <class T, int D> struct ShapeContact; // mu2, point, status
struct ShapeOverlap;                           // overlap, status
template <class T> struct ShapeDistance;       // distance, point1, point2, normal, status
template <class T, int D> struct Penetration;  // depth, direction, status
template <class T, int D> struct GapInside;    // gap, point1, point2, normal, status
template <class T, int D> struct Motion;       // velocity, angular_velocity, growth
template <class T> struct FirstContact;        // time, status
template <class T> struct ClosestPassage;      // mu2, time, status
template <class T> struct FreePath;            // length, status

/// @name Quadratic forms
/// @{

/// Computes the form of a spheroid, Q = a² I + (c² - a²) n nᵀ with the unit vector n along the
/// axis.
///
/// @param a equatorial radius, > 0
/// @param c polar radius, > 0
/// @param n direction of the axis of revolution, of any length > 0
/// @return the form; Status::invalid_argument if a length is not positive, its square leaves the
/// range of `T`, or `n` is zero or not finite
template <class T>
PW85_FUNCTION constexpr Form<T, 3> spheroid(T const &a, T const &c, Vector<T, 3> n) noexcept;

/// Computes the form of an ellipsoid, Q = R diag(semi_axes²) Rᵀ.
///
/// @param semi_axes lengths of the principal semi-axes (not diameters), > 0, whose squares are in
/// the range of `T`
/// @param rotation 3×3 matrix R in row-major order, which takes the body frame to the space frame;
/// its columns are the principal directions. An entry of RᵀR - I may be at most 1e-6 in magnitude.
/// R may be a reflection.
/// @return the form; Status::invalid_argument
template <class T> PW85_FUNCTION constexpr Form<T, 3> ellipsoid(Vector<T, 3> const &semi_axes,
                                                                T const (&rotation)[9]) noexcept;

/// Computes the form of an ellipsoid from a rotation matrix of any type whose entry in row i and
/// column j is r(i, j) or r[i][j], or from a std::array<T, 9> in row-major order.
///
/// Such types are T[3][3], std::array<std::array<T, 3>, 3>, std::array<Vector<T, 3>, 3>, Factor<T,
/// 3>, SymmetricMatrix<T, 3> and matrices of Eigen. Entries are converted to T.
///
/// @param semi_axes,rotation as for ellipsoid()
/// @return the form; Status::invalid_argument
template <class T, class Matrix>
requires detail::IsRotationOf<T, Matrix> PW85_FUNCTION constexpr Form<T, 3>
ellipsoid(Vector<T, 3> const &semi_axes, Matrix const &rotation) noexcept;

/// Computes the form of an ellipsoid whose orientation is a quaternion.
///
/// @param semi_axes as for ellipsoid()
/// @param quaternion (w, x, y, z), scalar first, which rotates the body frame into the space frame;
/// of any length > 0
/// @return the form; Status::invalid_argument
template <class T> PW85_FUNCTION constexpr Form<T, 3>
ellipsoid_quaternion(Vector<T, 3> const &semi_axes, Vector<T, 4> const &quaternion) noexcept;

/// Computes a factor S of the form of an ellipsoid, Q = S Sᵀ, for contact_factored(). The columns
/// of S are the semi-axes as vectors.
///
/// @param semi_axes,quaternion as for ellipsoid_quaternion()
/// @return the factor; Status::invalid_argument
template <class T> PW85_FUNCTION constexpr EllipsoidFactor<T, 3>
ellipsoid_factor(Vector<T, 3> const &semi_axes, Vector<T, 4> const &quaternion) noexcept;

/// Computes the form (xx, xy, yy) of an ellipse.
///
/// @param a first semi-axis, > 0, whose square is in the range of `T`
/// @param b second semi-axis, > 0, whose square is in the range of `T`
/// @param angle from the x axis to the first semi-axis, counter-clockwise, in radians
/// @return the form; Status::invalid_argument
template <class T>
PW85_FUNCTION inline Form<T, 2> ellipse(T const &a, T const &b, T const &angle) noexcept;

/// Computes the half-widths √Q_ii of the smallest box with sides along the axes that contains an
/// ellipsoid.
///
/// @param q the form
/// @return the half-widths; Status::invalid_argument, Status::not_positive_definite
template <class T, int D>
PW85_FUNCTION inline BoundingBox<T, D> bounding_box(SymmetricMatrix<T, D> const &q) noexcept;

/// @}

/// @name Contact of two ellipsoids
/// @{

/// Computes the contact function μ² and its maximiser λ, by a third-order iteration on
/// log(λ/(1-λ)).
///
/// The relative error of μ² is below 4 u cond, with the condition number cond of condition().
///
/// @param r12 c2 - c1; it may be zero: then μ² = 0 and λ = 1/2
/// @param q1,q2 the forms, in the square of the unit of `r12`
/// @return μ² and λ in [0, 1]; Status::invalid_argument, Status::not_positive_definite,
/// Status::no_convergence (this has never been seen)
template <class T, int D>
PW85_FUNCTION inline Contact<T> contact(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                                        SymmetricMatrix<T, D> const &q2) noexcept;

/// Computes the contact function with μ² correctly rounded.
///
/// μ² is the number of the type nearest to the exact value for the numbers given. If two numbers
/// are equally near, it is the one whose last binary digit is 0. The error of λ is less than one
/// unit in the last place. For multiprecision numbers the results are those of contact().
///
/// @param r12,q1,q2 as for contact()
/// @return μ² and λ in [0, 1]; μ² is infinity if it overflows, with success;
/// Status::invalid_argument, Status::not_positive_definite, Status::no_convergence (the last digit
/// of λ cannot be proved; this has never been seen)
template <class T, int D>
PW85_FUNCTION inline Contact<T> contact_rounded(Vector<T, D> const &r12,
                                                SymmetricMatrix<T, D> const &q1,
                                                SymmetricMatrix<T, D> const &q2) noexcept;

/// Computes the contact function of ellipsoids that are given by factors of their forms, Q1 = S1
/// S1ᵀ and Q2 = S2 S2ᵀ.
///
/// For slender ellipsoids, factors keep digits that forms lose: see pw85_contact_factored() in
/// pw85.h.
///
/// @param r12 as for contact()
/// @param s1,s2 factors, in the unit of `r12`, as from ellipsoid_factor(). The contract of
/// pw85_contact_factored() states which other matrices are accepted.
/// @return μ² and λ in [0, 1]; Status::invalid_argument, Status::not_positive_definite (a factor is
/// singular, or nearly), Status::no_convergence
template <class T, int D> PW85_FUNCTION inline Contact<T>
contact_factored(Vector<T, D> const &r12, Factor<T, D> const &s1, Factor<T, D> const &s2) noexcept;

/// Computes the condition number of the contact function, entry by entry.
///
/// If each entry of r12, q1 and q2 changes by at most a fraction ε of itself, μ² changes by at most
/// a fraction ε times the condition number, to first order in ε.
///
/// @param r12,q1,q2 as for contact()
/// @param lambda the maximiser λ in [0, 1], from contact()
/// @return the condition number: at least 3, or 0 for r12 = 0; Status::invalid_argument,
/// Status::not_positive_definite
template <class T, int D> PW85_FUNCTION inline Condition<T>
condition(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, SymmetricMatrix<T, D> const &q2,
          T const &lambda) noexcept;

/// Computes the point at which the ellipsoids, scaled by μ, touch, and their common normal there.
///
/// @param r12,q1,q2 as for contact(), r12 != 0
/// @param lambda the maximiser λ, from contact(). For another λ in [0, 1] the point is x0(λ) of the
/// chapter on theory: it is on the surfaces of ellipsoid 1 scaled by μ1 and of ellipsoid 2 scaled
/// by μ2, where f(λ) = λ μ1² + (1-λ) μ2².
/// @return the point, relative to the centre of ellipsoid 1, and the unit vector out of ellipsoid 1
/// and into ellipsoid 2; Status::invalid_argument, Status::not_positive_definite
template <class T, int D> PW85_FUNCTION inline ContactGeometry<T, D>
contact_geometry(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                 SymmetricMatrix<T, D> const &q2, T const &lambda) noexcept;

/// Computes the derivatives of μ² with respect to r12 and the stored entries of both forms.
///
/// @param r12,q1,q2 as for contact()
/// @param lambda the maximiser λ in [0, 1], from contact()
/// @return ∂μ²/∂r12, whose negative is the derivative with respect to centre 1; ∂μ²/∂q1 and
/// ∂μ²/∂q2, where a stored off-diagonal entry is two entries of the matrix;
/// Status::invalid_argument, Status::not_positive_definite
template <class T, int D> PW85_FUNCTION inline ContactGradient<T, D>
contact_gradient(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                 SymmetricMatrix<T, D> const &q2, T const &lambda) noexcept;

/// Computes the contact point and the normal, as contact_geometry() does, for ellipsoids that are
/// given by factors of their forms.
///
/// @param r12 as for contact_factored(), r12 != 0
/// @param s1,s2 as for contact_factored()
/// @param lambda the maximiser λ in [0, 1], from contact_factored()
/// @return as for contact_geometry()
template <class T, int D> PW85_FUNCTION inline ContactGeometry<T, D>
contact_geometry_factored(Vector<T, D> const &r12, Factor<T, D> const &s1, Factor<T, D> const &s2,
                          T const &lambda) noexcept;

/// Computes the derivatives of μ² for ellipsoids that are given by factors, with respect to r12 and
/// the entries of both factors.
///
/// @param r12,s1,s2 as for contact_factored()
/// @param lambda the maximiser λ in [0, 1], from contact_factored()
/// @return ∂μ²/∂r12, ∂μ²/∂s1 and ∂μ²/∂s2; Status::invalid_argument, Status::not_positive_definite
template <class T, int D> PW85_FUNCTION inline FactorGradient<T, D>
contact_gradient_factored(Vector<T, D> const &r12, Factor<T, D> const &s1, Factor<T, D> const &s2,
                          T const &lambda) noexcept;

/// Computes the derivatives of μ² with respect to rotations of the ellipsoids.
///
/// If an ellipsoid rotates about its own centre by a small rotation vector ω, μ² changes by
/// rotation·ω. An energy U(μ²) exerts the torque -U'(μ²) rotation on the ellipsoid.
///
/// @param r12,q1,q2 as for contact()
/// @param lambda the maximiser λ in [0, 1], from contact()
/// @return both vectors, per radian; Status::invalid_argument, Status::not_positive_definite
template <class T, int D> PW85_FUNCTION inline ContactTorque<T, D>
contact_torque(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
               SymmetricMatrix<T, D> const &q2, T const &lambda) noexcept;

/// Computes the second derivatives of μ² with respect to r12 and rotations of the ellipsoids about
/// their own centres.
///
/// A rotation vector ω is the rotation by the angle |ω| about the direction of ω. In two dimensions
/// ω is the angle. λ varies with the pair: it always maximises f.
///
/// @param r12,q1,q2 as for contact(), r12 != 0
/// @param lambda the maximiser λ in [0, 1], from contact()
/// @return the symmetric matrix for r12, rotation 1 and rotation 2, 9×9 or 4×4;
/// Status::invalid_argument, Status::not_positive_definite
template <class T, int D> PW85_FUNCTION inline ContactHessian<T, D>
contact_hessian(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                SymmetricMatrix<T, D> const &q2, T const &lambda) noexcept;

/// Tests whether two ellipsoids overlap, μ² < 1. Tangent ellipsoids (μ² = 1) do not overlap.
///
/// For float, double and long double the answer is exact for the numbers given. Bounds that account
/// for rounding decide almost all pairs, and exact arithmetic decides the others. For
/// multiprecision numbers the answer is correct up to rounding.
///
/// @param r12,q1,q2 as for contact(); r12 = 0 is an overlap
/// @return the answer, and `tier`, the method that decided; Status::invalid_argument,
/// Status::not_positive_definite
template <class T, int D>
PW85_FUNCTION inline Overlap overlap(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                                     SymmetricMatrix<T, D> const &q2) noexcept;

/// Tests whether two ellipsoids, given by factors of their forms, overlap.
///
/// For float, double and long double the answer is exact for the unrounded products S Sᵀ of the
/// factors. For multiprecision numbers it is correct up to rounding.
///
/// @param r12 as for contact_factored(); r12 = 0 is an overlap
/// @param s1,s2 as for contact_factored()
/// @return the answer, and `tier`, the method that decided; Status::invalid_argument,
/// Status::not_positive_definite, Status::no_convergence (only integers can decide, and the numbers
/// need too many digits: see pw85_overlap_factored() in pw85.h)
template <class T, int D> PW85_FUNCTION inline Overlap
overlap_factored(Vector<T, D> const &r12, Factor<T, D> const &s1, Factor<T, D> const &s2) noexcept;

/// Tests whether two ellipsoids overlap, without exact arithmetic.
///
/// The decision is Decision::overlap or Decision::apart if floating-point arithmetic proves it. It
/// is Decision::none if the pair is too close to contact for such a proof (|μ² - 1| of a few u
/// cond). A GPU thread can call this function, and leave undecided pairs to overlap() on the host.
///
/// @param r12,q1,q2 as for overlap()
/// @return the decision, and `tier`, the method that made it; Decision::none with
/// Status::invalid_argument or Status::not_positive_definite
template <class T, int D>
PW85_FUNCTION inline OverlapDecision decide_overlap(Vector<T, D> const &r12,
                                                    SymmetricMatrix<T, D> const &q1,
                                                    SymmetricMatrix<T, D> const &q2) noexcept;

/// Tests whether two ellipsoids overlap, as overlap() does, and returns a witness that proves the
/// answer.
///
/// For float, double and long double the witness holds in exact arithmetic: a λ with f(λ) > 1, or a
/// point inside both and on neither surface. Tangent ellipsoids have no witness: `lambda` and
/// `point` are NaN, with success. For multiprecision numbers the witness is correct up to rounding.
///
/// @param r12,q1,q2 as for overlap()
/// @return the answer; if the ellipsoids are apart, a λ with f(λ) > 1, and the unit normal of a
/// plane between them, correct up to rounding; if they overlap, a point inside both, relative to
/// the centre of ellipsoid 1; the other numbers are NaN; Status::invalid_argument,
/// Status::not_positive_definite, Status::no_convergence (no witness was found, but the answer is
/// correct)
template <class T, int D>
PW85_FUNCTION inline OverlapWitness<T, D> overlap_witness(Vector<T, D> const &r12,
                                                          SymmetricMatrix<T, D> const &q1,
                                                          SymmetricMatrix<T, D> const &q2) noexcept;

/// Tests whether ellipsoid 2 is inside ellipsoid 1. An ellipsoid 2 that touches the surface from
/// inside counts as inside.
///
/// For float, double and long double the answer is exact for the numbers given. For multiprecision
/// numbers, a pair that touches up to rounding counts as inside.
///
/// @param r12,q1,q2 as for contact()
/// @return the answer; Status::invalid_argument, Status::not_positive_definite
template <class T, int D>
PW85_FUNCTION inline Containment contains(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                                          SymmetricMatrix<T, D> const &q2) noexcept;

/// Computes the least factor by which ellipsoid 1 must be scaled about its centre to contain
/// ellipsoid 2, and a point where the two then touch.
///
/// The square of the factor is the largest value of xᵀQ1⁻¹x over ellipsoid 2. Its relative error is
/// below 16 u c, with c of pw85_containment() in pw85.h.
///
/// @param r12,q1,q2 as for contact(); r12 may be zero
/// @return the square of the factor, and the point of ellipsoid 2 where the scaled ellipsoid 1
/// touches it, relative to the centre of ellipsoid 1 (one of them if there are several);
/// Status::invalid_argument, Status::not_positive_definite, Status::no_convergence
template <class T, int D>
PW85_FUNCTION inline ContainmentScale<T, D> containment(Vector<T, D> const &r12,
                                                        SymmetricMatrix<T, D> const &q1,
                                                        SymmetricMatrix<T, D> const &q2) noexcept;

/// Computes the volume of an ellipsoid, (4/3)π √det q.
///
/// @param q form of the ellipsoid
/// @return the volume; Status::invalid_argument, Status::not_positive_definite
template <class T> PW85_FUNCTION inline Volume<T> volume(SymmetricMatrix<T, 3> const &q) noexcept;

/// Computes the area of an ellipse, π √det q.
///
/// @param q form of the ellipse
/// @return the area; Status::invalid_argument, Status::not_positive_definite
template <class T> PW85_FUNCTION inline Area<T> area(SymmetricMatrix<T, 2> const &q) noexcept;

/// Computes the surface area of an ellipsoid.
///
/// @param q form of the ellipsoid
/// @return the area; Status::invalid_argument, Status::not_positive_definite
template <class T>
PW85_FUNCTION inline Area<T> surface_area(SymmetricMatrix<T, 3> const &q) noexcept;

/// Computes the perimeter of an ellipse.
///
/// @param q form of the ellipse
/// @return the perimeter; Status::invalid_argument, Status::not_positive_definite
template <class T>
PW85_FUNCTION inline Perimeter<T> perimeter(SymmetricMatrix<T, 2> const &q) noexcept;

/// Computes the mean of x xᵀ over a uniform ellipsoid or ellipse, about its centre.
///
/// @param q form of the ellipsoid or ellipse
/// @return the moments; Status::invalid_argument, Status::not_positive_definite
template <class T, int D>
PW85_FUNCTION inline Moments<T, D> second_moments(SymmetricMatrix<T, D> const &q) noexcept;

/// Computes the form of the uniform ellipsoid or ellipse with given second moments, the inverse of
/// second_moments().
///
/// @param second_moments mean of x xᵀ over a body, about its centre; positive definite
/// @return the form; Status::invalid_argument, Status::not_positive_definite
template <class T, int D>
PW85_FUNCTION inline Form<T, D> from_moments(SymmetricMatrix<T, D> const &second_moments) noexcept;

/// Computes the mean of x xᵀ over the surface of an ellipsoid or the perimeter of an ellipse, about
/// its centre.
///
/// @param q form of the ellipsoid or ellipse
/// @return the moments; Status::invalid_argument, Status::not_positive_definite
template <class T, int D>
PW85_FUNCTION inline Moments<T, D> shell_moments(SymmetricMatrix<T, D> const &q) noexcept;

/// Computes the inertia tensor of a solid body or of a shell of unit density, about its centre.
///
/// @param q form of the ellipsoid
/// @param shell 0 for a uniform solid body, any other number for a sheet of the same mass per area
/// everywhere
/// @return the tensor; Status::invalid_argument, Status::not_positive_definite
template <class T>
PW85_FUNCTION inline Inertia<T> inertia(SymmetricMatrix<T, 3> const &q, int shell) noexcept;

/// Computes the volume of the intersection of two ellipsoids.
///
/// The volume is 0 if overlap() is false, and that of the smaller ellipsoid if it is inside the
/// other one, as contains() decides. The bound on the error is that of pw85_overlap_volume() in
/// pw85.h.
///
/// @param r12,q1,q2 as for contact(); r12 may be zero
/// @return the volume; Status::invalid_argument, Status::not_positive_definite,
/// Status::no_convergence
template <class T>
PW85_FUNCTION inline Volume<T> overlap_volume(Vector<T, 3> const &r12,
                                              SymmetricMatrix<T, 3> const &q1,
                                              SymmetricMatrix<T, 3> const &q2) noexcept;

/// Computes the area of the intersection of two ellipses, as overlap_volume() computes volumes.
///
/// @param r12,q1,q2 as for overlap_volume()
/// @return the area; Status::invalid_argument, Status::not_positive_definite,
/// Status::no_convergence
template <class T>
PW85_FUNCTION inline Area<T> overlap_area(Vector<T, 2> const &r12, SymmetricMatrix<T, 2> const &q1,
                                          SymmetricMatrix<T, 2> const &q2) noexcept;

/// Computes the derivatives of overlap_volume() with respect to r12 and the stored entries of both
/// forms. A stored off-diagonal entry is two entries of the matrix.
///
/// @param r12,q1,q2 as for overlap_volume()
/// @return the derivatives; Status::invalid_argument, Status::not_positive_definite,
/// Status::no_convergence
template <class T> PW85_FUNCTION inline OverlapVolumeGradient<T>
overlap_volume_gradient(Vector<T, 3> const &r12, SymmetricMatrix<T, 3> const &q1,
                        SymmetricMatrix<T, 3> const &q2) noexcept;

/// Computes the derivatives of overlap_volume() with respect to rotations of the ellipsoids about
/// their centres, per radian.
///
/// @param r12,q1,q2 as for overlap_volume()
/// @return the derivatives; Status::invalid_argument, Status::not_positive_definite,
/// Status::no_convergence
template <class T> PW85_FUNCTION inline OverlapVolumeTorque<T>
overlap_volume_torque(Vector<T, 3> const &r12, SymmetricMatrix<T, 3> const &q1,
                      SymmetricMatrix<T, 3> const &q2) noexcept;

/// Computes the derivatives of overlap_area() with respect to r12 and the stored entries of both
/// forms. A stored off-diagonal entry is two entries of the matrix.
///
/// @param r12,q1,q2 as for overlap_volume()
/// @return the derivatives; Status::invalid_argument, Status::not_positive_definite,
/// Status::no_convergence
template <class T> PW85_FUNCTION inline OverlapAreaGradient<T>
overlap_area_gradient(Vector<T, 2> const &r12, SymmetricMatrix<T, 2> const &q1,
                      SymmetricMatrix<T, 2> const &q2) noexcept;

/// Computes the derivatives of overlap_area() with respect to the angles of the ellipses,
/// counter-clockwise, per radian.
///
/// @param r12,q1,q2 as for overlap_volume()
/// @return the derivatives; Status::invalid_argument, Status::not_positive_definite,
/// Status::no_convergence
template <class T> PW85_FUNCTION inline OverlapAreaTorque<T>
overlap_area_torque(Vector<T, 2> const &r12, SymmetricMatrix<T, 2> const &q1,
                    SymmetricMatrix<T, 2> const &q2) noexcept;

/// Computes the volume of the part of an ellipsoid that is in the half-space normal·x <= offset,
/// where x is relative to the centre of the ellipsoid.
///
/// @param normal of any length > 0
/// @param offset in the unit of normal·x; negative if the centre is outside the half-space
/// @param q form of the ellipsoid
/// @return the volume; Status::invalid_argument, Status::not_positive_definite
template <class T>
PW85_FUNCTION inline Volume<T> overlap_volume_plane(Vector<T, 3> const &normal, T const &offset,
                                                    SymmetricMatrix<T, 3> const &q) noexcept;

/// Compares μ² with a number, and returns the sign of μ² - mu2.
///
/// For float, double and long double the sign is exact for the numbers given. For multiprecision
/// numbers it is correct up to rounding.
///
/// @param r12,q1,q2 as for contact()
/// @param mu2 >= 0; may be infinity
/// @return -1, 0 or 1; 2 with Status::invalid_argument or Status::not_positive_definite
template <class T, int D>
PW85_FUNCTION inline Comparison compare(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                                        SymmetricMatrix<T, D> const &q2, T const &mu2) noexcept;

/// Computes the distance of closest approach of two ellipsoids of fixed orientation, for one
/// direction.
///
/// This is the distance of the centres at which the ellipsoids touch from outside, if the centres
/// are on a line along the vector d = `direction`. It equals |d|/μ(d), where μ(d) is the μ for r12
/// = d.
///
/// @param direction from centre 1 to centre 2, of any length > 0
/// @param q1,q2 the forms
/// @return the distance, in the unit of the semi-axes; Status::invalid_argument,
/// Status::not_positive_definite, Status::no_convergence as for contact()
template <class T, int D>
PW85_FUNCTION inline ClosestApproach<T> closest_approach(Vector<T, D> direction,
                                                         SymmetricMatrix<T, D> const &q1,
                                                         SymmetricMatrix<T, D> const &q2) noexcept;

/// @}

/// @name Distance
/// @{

/// Computes the distance of the surfaces of two ellipsoids, and the points where they are closest.
///
/// The error of the distance is below 8 u Σ, with Σ of pw85_distance() in pw85.h. Rounding each
/// entry of the data can change the distance by u Σ.
///
/// @param r12,q1,q2 as for contact()
/// @return the distance, in the unit of `r12`, the closest points of both ellipsoids, relative to
/// centre 1, and the unit normal out of ellipsoid 1 and into ellipsoid 2. If they overlap, as
/// overlap() decides, the distance is zero and the vectors are NaN, also on success;
/// Status::invalid_argument, Status::not_positive_definite, Status::no_convergence (the errors
/// cannot be bounded)
template <class T, int D>
PW85_FUNCTION inline Distance<T, D> distance(Vector<T, D> const &r12,
                                             SymmetricMatrix<T, D> const &q1,
                                             SymmetricMatrix<T, D> const &q2) noexcept;

/// Computes the first and second derivatives of the distance of two ellipsoids that are apart.
///
/// @param r12,q1,q2 as for contact()
/// @return derivatives with respect to r12 (the unit normal of distance()) and to rotations of
/// ellipsoids 1 and 2 by small vectors about their own centres, per radian; the symmetric 9×9
/// matrix of second derivatives with respect to r12, rotation 1 and rotation 2, as for
/// contact_hessian(); NaN if they overlap, also on success; Status::invalid_argument,
/// Status::not_positive_definite, Status::no_convergence as for distance()
template <class T> PW85_FUNCTION inline DistanceDerivatives<T>
distance_derivatives(Vector<T, 3> const &r12, SymmetricMatrix<T, 3> const &q1,
                     SymmetricMatrix<T, 3> const &q2) noexcept;

/// Computes the penetration depth of two ellipsoids that overlap, and its direction. The depth is
/// the length of the shortest translation of ellipsoid 2 that separates them. The function proves
/// that no translation is shorter, up to rounding.
///
/// @param r12,q1,q2 as for contact()
/// @return the depth and the direction; zero and a NaN direction if the ellipsoids do not overlap;
/// Status::invalid_argument, Status::not_positive_definite, Status::no_convergence (seen only for
/// forms that are singular to working precision)
template <class T, int D>
PW85_FUNCTION inline Penetration<T, D> penetration(Vector<T, D> const &r12,
                                                   SymmetricMatrix<T, D> const &q1,
                                                   SymmetricMatrix<T, D> const &q2) noexcept;

/// Computes the least gap between the surface of ellipsoid 1 and an ellipsoid 2 inside it. The
/// function proves that no gap is smaller, within the tolerance that pw85_gap_inside() in pw85.h
/// states.
///
/// @param r12,q1,q2 as for contact()
/// @return the gap, the closest points of both surfaces, relative to the centre of ellipsoid 1, and
/// the unit normal out of both; zero and NaN vectors if ellipsoid 2 is not inside ellipsoid 1, as
/// contains() decides; Status::invalid_argument, Status::not_positive_definite,
/// Status::no_convergence (this has never been seen)
template <class T, int D>
PW85_FUNCTION inline GapInside<T, D> gap_inside(Vector<T, D> const &r12,
                                                SymmetricMatrix<T, D> const &q1,
                                                SymmetricMatrix<T, D> const &q2) noexcept;

/// Computes the signed distance of two ellipsoids: the distance if they are apart, and minus the
/// penetration depth if they overlap.
///
/// The signed distance is the largest value of n·r12 - α - β over unit vectors n, with the
/// half-widths α and β of the ellipsoids along n. It is positive only if the ellipsoids are apart,
/// and negative only if they overlap.
///
/// @param r12,q1,q2 as for contact()
/// @return the signed distance; the closest or deepest points of the surfaces, where the outward
/// normals are opposite, relative to the centre of ellipsoid 1; the unit normal out of ellipsoid 1;
/// Status::invalid_argument, Status::not_positive_definite, Status::no_convergence as for
/// distance() and penetration()
template <class T, int D>
PW85_FUNCTION inline Distance<T, D> signed_distance(Vector<T, D> const &r12,
                                                    SymmetricMatrix<T, D> const &q1,
                                                    SymmetricMatrix<T, D> const &q2) noexcept;

/// Computes the first and second derivatives of the signed distance.
///
/// @param r12,q1,q2 as for contact()
/// @return as for distance_derivatives(), also if the ellipsoids overlap; the second derivatives
/// are then NaN, also on success, if the direction of the depth is not isolated
/// (signed_distance.hpp)
template <class T> PW85_FUNCTION inline DistanceDerivatives<T>
signed_distance_derivatives(Vector<T, 3> const &r12, SymmetricMatrix<T, 3> const &q1,
                            SymmetricMatrix<T, 3> const &q2) noexcept;

/// @}

/// @name Time
/// @{

/// Computes the time of the first contact of two ellipsoids that translate, rotate about their
/// centres and grow. No contact is missed.
///
/// @param r12,q1,q2 the pair at time 0, as for contact()
/// @param motion1,motion2 motions of the ellipsoids; their semi-axes must be > 0 until t_max
/// @param t_max the last time at which a contact counts, >= 0; may be infinity
/// @return the time; infinity if there is no contact; zero if the ellipsoids overlap at time 0,
/// except for a pair that has just collided: see pw85.h; Status::invalid_argument,
/// Status::not_positive_definite, Status::no_convergence as for pw85_first_contact() in pw85.h
template <class T, int D> PW85_FUNCTION inline FirstContact<T>
first_contact(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
              SymmetricMatrix<T, D> const &q2, Motion<T, D> const &motion1,
              Motion<T, D> const &motion2, T const &t_max) noexcept;

/// Computes the least μ² of two ellipsoids on a straight path, for the separations r12 + t
/// velocity, 0 <= t <= t_max.
///
/// The error of μ² is below 8 u S, with S of pw85_closest_passage() in pw85.h.
///
/// @param r12,q1,q2 as for contact(), at time 0
/// @param velocity of ellipsoid 2 relative to ellipsoid 1; may be zero
/// @param t_max the end of the path, >= 0; may be infinity
/// @return the least μ² and its time; Status::invalid_argument, Status::not_positive_definite,
/// Status::no_convergence as for contact()
template <class T> PW85_FUNCTION inline ClosestPassage<T>
closest_passage(Vector<T, 3> const &r12, SymmetricMatrix<T, 3> const &q1,
                SymmetricMatrix<T, 3> const &q2, Vector<T, 3> const &velocity,
                T const &t_max) noexcept;

/// Computes how far ellipsoid 1 may move along a direction until it touches ellipsoid 2. If the
/// ellipsoids do not overlap at the start, they do not overlap up to this length.
///
/// @param r12,q1,q2 as for contact()
/// @param direction of any length > 0
/// @param t_max the end of the path, in units of the length of `direction`, >= 0; may be infinity
/// @return the length, in the unit of t_max: infinity if there is no contact on the path;
/// Status::invalid_argument, Status::not_positive_definite, Status::no_convergence as for
/// pw85_first_contact() in pw85.h
template <class T, int D>
PW85_FUNCTION inline FreePath<T> free_path(Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1,
                                           SymmetricMatrix<T, D> const &q2,
                                           Vector<T, D> const &direction, T const &t_max) noexcept;

/// @}

/// @name Curvature and contact of grains
/// @{

/// Computes the principal curvatures of the surface of an ellipsoid, and their directions, at the
/// point with a given normal.
///
/// @param normal out of the ellipsoid, of any length > 0
/// @param q the form
/// @return the curvatures, the smaller one first, and the unit vectors of their directions;
/// Status::invalid_argument, Status::not_positive_definite
template <class T> PW85_FUNCTION inline Curvature<T>
curvature(Vector<T, 3> normal, SymmetricMatrix<T, 3> const &q) noexcept;

/// Computes the effective radius and the contact ellipse of Hertz's theory of two elastic bodies.
/// For a depth δ the force is (4/3) E* √(radius δ³), with E* of pw85_hertz() in pw85.h.
///
/// @param curvatures of the gap between the surfaces along two perpendicular directions, > 0
/// @return the effective radius, and the squares of the semi-axes of the contact ellipse divided by
/// the depth; Status::invalid_argument
template <class T>
PW85_FUNCTION inline HertzEllipse<T> hertz(Vector<T, 2> const &curvatures) noexcept;

/// Computes the geometry of the contact of two grains along a given normal.
///
/// @param r12,q1,q2 as for contact()
/// @param normal out of ellipsoid 1 and into ellipsoid 2, of any length > 0; usually that of
/// contact_geometry()
/// @return the depth, the point at which contact forces act, the curvatures of the gap, and the
/// results of hertz(); Status::invalid_argument, Status::not_positive_definite
template <class T> PW85_FUNCTION inline HertzContact<T>
hertz_contact(Vector<T, 3> const &r12, SymmetricMatrix<T, 3> const &q1,
              SymmetricMatrix<T, 3> const &q2, Vector<T, 3> normal) noexcept;

/// Computes the contact of two grains along their common normal: the local minimum of the overlap
/// near a direction.
///
/// @param r12,q1,q2 as for contact()
/// @param start a direction near the normal, of any length > 0; usually the normal of
/// contact_geometry()
/// @return the normal, the depth, the point at which contact forces act, the curvatures of the gap,
/// and Hertz's radius; Status::invalid_argument, Status::not_positive_definite,
/// Status::no_convergence (the search finds no minimum)
template <class T> PW85_FUNCTION inline GrainContact<T>
grain_contact(Vector<T, 3> const &r12, SymmetricMatrix<T, 3> const &q1,
              SymmetricMatrix<T, 3> const &q2, Vector<T, 3> start) noexcept;

/// Computes the derivatives of the radius of grain_contact(). They include the change of the normal
/// with the motion.
///
/// @param r12,q1,q2 as for contact()
/// @param normal that of grain_contact(), of any length > 0
/// @return the derivatives with respect to r12 and to small rotations of either ellipsoid;
/// Status::invalid_argument, Status::not_positive_definite, Status::no_convergence (the overlap has
/// no minimum there)
template <class T> PW85_FUNCTION inline GrainRadiusGradient<T>
grain_radius_gradient(Vector<T, 3> const &r12, SymmetricMatrix<T, 3> const &q1,
                      SymmetricMatrix<T, 3> const &q2, Vector<T, 3> normal) noexcept;

/// Computes the contact of a grain with its centre at 0 and a wall that is curved along at most one
/// direction.
///
/// @param normal,offset,q as for distance_plane()
/// @param direction perpendicular to the normal, of any length > 0, along which the wall is curved
/// @param curvature_of_wall positive if the wall is convex, 0 for a plane
/// @return the depth, the deepest point of the ellipsoid, the curvatures of the gap, and Hertz's
/// radius; Status::invalid_argument, Status::not_positive_definite
template <class T> PW85_FUNCTION inline GrainWallContact<T>
grain_contact_wall(Vector<T, 3> const &normal, T const &offset, Vector<T, 3> direction,
                   T const &curvature_of_wall, SymmetricMatrix<T, 3> const &q) noexcept;

/// @}

/// @name Walls, points and lines
///
/// These functions are for one ellipsoid with its centre at 0, unless their contracts say
/// otherwise. The error of a distance is below 8 u Σ, with Σ of pw85_shapes.h.
/// @{

/// Computes the distance from an ellipsoid to the half-space normal·x >= offset.
///
/// @param normal into the half-space, of any length > 0
/// @param offset in the unit of normal·x; negative if the centre is in the half-space
/// @param q the form
/// @return the distance, or minus the depth if the two overlap; the point of the ellipsoid that is
/// nearest to the half-space, or deepest in it; the unit normal; Status::invalid_argument,
/// Status::not_positive_definite
template <class T, int D>
PW85_FUNCTION inline SurfaceDistance<T, D> distance_plane(Vector<T, D> const &normal,
                                                          T const &offset,
                                                          SymmetricMatrix<T, D> const &q) noexcept;

/// Computes the derivatives of the distance to a half-space, which do not depend on its offset.
///
/// @param normal,q as for distance_plane()
/// @return derivatives with respect to the position of the centre and to small rotation vectors
/// about it, per radian; Status::invalid_argument, Status::not_positive_definite
template <class T> PW85_FUNCTION inline PlaneDerivatives<T>
distance_plane_derivatives(Vector<T, 3> const &normal, SymmetricMatrix<T, 3> const &q) noexcept;

/// Computes the contact function of an ellipsoid and the half-space normal·x >= offset.
///
/// @param normal,offset,q as for distance_plane()
/// @return the square of the factor by which the ellipsoid must be scaled to touch, or 0 if its
/// centre is in the half-space, and the point at which it then touches; Status::invalid_argument,
/// Status::not_positive_definite
template <class T, int D> PW85_FUNCTION inline PlaneContact<T, D>
contact_plane(Vector<T, D> const &normal, T const &offset, SymmetricMatrix<T, D> const &q) noexcept;

/// Computes the derivatives of the contact function of an ellipsoid and a half-space. They are zero
/// if the centre is in the half-space.
///
/// @param normal,offset,q as for distance_plane()
/// @return derivatives of μ² with respect to the position of the centre and to small rotation
/// vectors about it, per radian; Status::invalid_argument, Status::not_positive_definite
template <class T> PW85_FUNCTION inline PlaneDerivatives<T>
contact_plane_derivatives(Vector<T, 3> const &normal, T const &offset,
                          SymmetricMatrix<T, 3> const &q) noexcept;

/// Computes the distance from an ellipsoid to the nearest face of the box lower <= x <= upper
/// around it, a container. For a solid box, an obstacle, see distance_solid_box().
///
/// @param lower,upper corners of the box, relative to the centre of the ellipsoid; lower <= upper
/// @param q the form
/// @return the distance, negative if the ellipsoid is not inside the box; the point of the
/// ellipsoid that is nearest to that face, or farthest beyond it; the outward unit normal of that
/// face; Status::invalid_argument, Status::not_positive_definite
template <class T, int D>
PW85_FUNCTION inline SurfaceDistance<T, D> distance_box(Vector<T, D> const &lower,
                                                        Vector<T, D> const &upper,
                                                        SymmetricMatrix<T, D> const &q) noexcept;

/// Computes the distance from an ellipsoid to the wall of a cylinder of infinite length that
/// contains it.
///
/// @param axis direction of the axis, which goes through 0; of any length > 0
/// @param radius of the cylinder, > 0
/// @param center of the ellipsoid
/// @param q the form
/// @return the distance, negative if the ellipsoid is not inside the cylinder; the point of the
/// ellipsoid that is farthest from the axis, relative to its centre; the outward unit normal of the
/// wall there; Status::invalid_argument, Status::not_positive_definite
template <class T> PW85_FUNCTION inline SurfaceDistance<T, 3>
distance_cylinder(Vector<T, 3> axis, T const &radius, Vector<T, 3> const &center,
                  SymmetricMatrix<T, 3> const &q) noexcept;

/// Computes the distance from a point to the surface of an ellipsoid.
///
/// @param r the point, relative to the centre
/// @param q the form
/// @return the distance, negative if the point is inside; the point of the surface that is nearest
/// to `r` (one of them if there are several); the unit normal out of the ellipsoid there, which is
/// the derivative of the distance with respect to `r`; Status::invalid_argument,
/// Status::not_positive_definite
template <class T, int D> PW85_FUNCTION inline SurfaceDistance<T, D>
distance_point(Vector<T, D> const &r, SymmetricMatrix<T, D> const &q) noexcept;

/// Computes the part enter <= t <= leave of the line origin + t·direction that is in an ellipsoid.
///
/// For a ray from `origin`, intersect this part with t >= 0; for the segment from `origin` to
/// origin + direction, with 0 <= t <= 1.
///
/// @param origin of the line, relative to the centre of the ellipsoid
/// @param direction of any length > 0
/// @param q the form
/// @return the part; NaN if the line misses the ellipsoid, also on success;
/// Status::invalid_argument, Status::not_positive_definite
template <class T, int D>
PW85_FUNCTION inline Chord<T> intersect_line(Vector<T, D> const &origin,
                                             Vector<T, D> const &direction,
                                             SymmetricMatrix<T, D> const &q) noexcept;

/// @}
/// @name Shapes: an ellipsoid with its centre at 0, scaled about it until it touches a convex set
/// @{

/// Computes the contact function of an ellipsoid and a segment.
///
/// @param end1,end2 of the segment, relative to the centre; equal ends are a point
/// @param q the form
/// @return μ², and the point of the segment at which the scaled ellipsoid touches;
/// Status::invalid_argument, Status::not_positive_definite
template <class T>
PW85_FUNCTION inline ShapeContact<T, 3> contact_segment(Vector<T, 3> const &end1,
                                                        Vector<T, 3> const &end2,
                                                        SymmetricMatrix<T, 3> const &q) noexcept;

/// Computes the contact function of an ellipsoid and a triangle.
///
/// @param vertex1,vertex2,vertex3 of the triangle, relative to the centre; a triangle without area
/// is a segment or a point
/// @param q the form
/// @return μ², and the point of the triangle at which the scaled ellipsoid touches;
/// Status::invalid_argument, Status::not_positive_definite
template <class T> PW85_FUNCTION inline ShapeContact<T, 3>
contact_triangle(Vector<T, 3> const &vertex1, Vector<T, 3> const &vertex2,
                 Vector<T, 3> const &vertex3, SymmetricMatrix<T, 3> const &q) noexcept;

/// Computes the contact function of an ellipsoid and the solid box lower <= x <= upper.
///
/// @param lower,upper corners of the box, relative to the centre; lower <= upper
/// @param q the form
/// @return μ², 0 if the centre is in the box, and the point of the box at which the scaled
/// ellipsoid touches; Status::invalid_argument, Status::not_positive_definite
template <class T>
PW85_FUNCTION inline ShapeContact<T, 3> contact_box(Vector<T, 3> const &lower,
                                                    Vector<T, 3> const &upper,
                                                    SymmetricMatrix<T, 3> const &q) noexcept;

/// Computes the contact function of an ellipsoid and a polytope, the intersection of n half-spaces:
/// all x with normal·x <= offset for each plane.
///
/// For a centre at 0 the errors have the bounds of pw85_contact_polytope() in pw85_shapes.h. For
/// another centre, replace |offset_k| by |offset_k| + |normal_k|·|center| in these bounds, and the
/// factor 32 by 40. The time is proportional to n and to the number of steps, which is below 20 for
/// most polytopes.
///
/// @param n number of half-spaces; for 0 the polytope is the whole space
/// @param normals n×3, out of the polytope, of any lengths > 0
/// @param offsets n
/// @param q the form
/// @param center of the ellipsoid
/// @return μ², 0 if the centre is in the polytope, and the point of the polytope at which the
/// scaled ellipsoid touches, relative to its centre; infinity and NaN for an empty polytope;
/// Status::invalid_argument, Status::not_positive_definite, Status::no_convergence (this has never
/// been seen)
template <class T> PW85_FUNCTION inline ShapeContact<T, 3>
contact_polytope(std::size_t n, T const *normals, T const *offsets, SymmetricMatrix<T, 3> const &q,
                 Vector<T, 3> const &center = {T(0), T(0), T(0)}) noexcept;

/// Tests whether an ellipsoid and a segment overlap, μ² < 1. The answer is exact for float, double
/// and long double.
///
/// @param end1,end2,q as for contact_segment()
/// @return the answer; Status::invalid_argument, Status::not_positive_definite
template <class T>
PW85_FUNCTION inline ShapeOverlap overlap_segment(Vector<T, 3> const &end1,
                                                  Vector<T, 3> const &end2,
                                                  SymmetricMatrix<T, 3> const &q) noexcept;

/// Tests whether an ellipsoid and a triangle overlap, μ² < 1. The answer is exact for float, double
/// and long double.
///
/// @param vertex1,vertex2,vertex3,q as for contact_triangle()
/// @return the answer; Status::invalid_argument, Status::not_positive_definite
template <class T> PW85_FUNCTION inline ShapeOverlap
overlap_triangle(Vector<T, 3> const &vertex1, Vector<T, 3> const &vertex2,
                 Vector<T, 3> const &vertex3, SymmetricMatrix<T, 3> const &q) noexcept;

/// Tests whether an ellipsoid and a solid box overlap, μ² < 1. The answer is exact for float,
/// double and long double.
///
/// @param lower,upper,q as for contact_box()
/// @return the answer; Status::invalid_argument, Status::not_positive_definite
template <class T>
PW85_FUNCTION inline ShapeOverlap overlap_box(Vector<T, 3> const &lower, Vector<T, 3> const &upper,
                                              SymmetricMatrix<T, 3> const &q) noexcept;

/// Tests whether an ellipsoid and a polytope overlap, μ² < 1. An empty polytope does not overlap.
/// The answer is exact for float, double and long double.
///
/// @param n,normals,offsets,q,center as for contact_polytope()
/// @return the answer; Status::invalid_argument, Status::not_positive_definite
template <class T> PW85_FUNCTION inline ShapeOverlap
overlap_polytope(std::size_t n, T const *normals, T const *offsets, SymmetricMatrix<T, 3> const &q,
                 Vector<T, 3> const &center = {T(0), T(0), T(0)}) noexcept;

/// @}
/// @name Signed distances of an ellipsoid with its centre at 0 and a convex set
/// @{

/// Computes the signed distance of an ellipsoid and a segment, and the points where it is reached.
/// pw85_shapes.h has the bounds on the errors and the derivatives.
///
/// @param end1,end2,q as for contact_segment()
/// @return the distance; if they overlap, minus the length of the shortest translation of the set
/// that separates them; the nearest or deepest points of the ellipsoid and of the set; the unit
/// normal out of the ellipsoid there; Status::invalid_argument, Status::not_positive_definite
template <class T>
PW85_FUNCTION inline ShapeDistance<T> distance_segment(Vector<T, 3> const &end1,
                                                       Vector<T, 3> const &end2,
                                                       SymmetricMatrix<T, 3> const &q) noexcept;

/// Computes the signed distance of an ellipsoid and a triangle, which is a surface.
///
/// @param vertex1,vertex2,vertex3,q as for contact_triangle()
/// @return as for distance_segment()
template <class T> PW85_FUNCTION inline ShapeDistance<T>
distance_triangle(Vector<T, 3> const &vertex1, Vector<T, 3> const &vertex2,
                  Vector<T, 3> const &vertex3, SymmetricMatrix<T, 3> const &q) noexcept;

/// Computes the signed distance of an ellipsoid and the solid box lower <= x <= upper.
///
/// @param lower,upper,q as for contact_box()
/// @return as for distance_segment()
template <class T>
PW85_FUNCTION inline ShapeDistance<T> distance_solid_box(Vector<T, 3> const &lower,
                                                         Vector<T, 3> const &upper,
                                                         SymmetricMatrix<T, 3> const &q) noexcept;

/// @}
/// @name Capsules: an ellipsoid with its centre at 0, and the points near a segment
/// @{

/// Computes the contact function of an ellipsoid and a capsule. pw85_shapes.h has the bounds on the
/// errors.
///
/// @param end1,end2 of the segment, relative to the centre; equal ends are a ball
/// @param radius of the capsule, >= 0
/// @param q the form
/// @return μ², 0 if the centre is in the capsule, and the point of the capsule at which the scaled
/// ellipsoid touches; Status::invalid_argument, Status::not_positive_definite
template <class T>
PW85_FUNCTION inline ShapeContact<T, 3> contact_capsule(Vector<T, 3> const &end1,
                                                        Vector<T, 3> const &end2, T const &radius,
                                                        SymmetricMatrix<T, 3> const &q) noexcept;

/// Tests whether an ellipsoid and a capsule overlap, μ² < 1. For float, double and long double the
/// answer is exact, unless 1 - μ² is positive and far below the roundoff of the type: see
/// pw85_shapes.h.
///
/// @param end1,end2,radius,q as for contact_capsule()
/// @return the answer; Status::invalid_argument, Status::not_positive_definite
template <class T>
PW85_FUNCTION inline ShapeOverlap overlap_capsule(Vector<T, 3> const &end1,
                                                  Vector<T, 3> const &end2, T const &radius,
                                                  SymmetricMatrix<T, 3> const &q) noexcept;

/// Computes the signed distance of an ellipsoid and a capsule.
///
/// @param end1,end2,radius,q as for contact_capsule()
/// @return as for distance_segment()
template <class T>
PW85_FUNCTION inline ShapeDistance<T> distance_capsule(Vector<T, 3> const &end1,
                                                       Vector<T, 3> const &end2, T const &radius,
                                                       SymmetricMatrix<T, 3> const &q) noexcept;

/// @}
/// @name Shapes in the plane: an ellipse with its centre at 0, and a convex set
/// @{

/// Computes the contact function of an ellipse and a segment: see contact_segment() in three
/// dimensions.
///
/// @param end1,end2 of the segment, relative to the centre; equal ends are a point
/// @param q the form
/// @return μ², and the point of the segment at which the scaled ellipse touches;
/// Status::invalid_argument, Status::not_positive_definite
template <class T>
PW85_FUNCTION inline ShapeContact<T, 2> contact_segment(Vector<T, 2> const &end1,
                                                        Vector<T, 2> const &end2,
                                                        SymmetricMatrix<T, 2> const &q) noexcept;

/// Computes the contact function of an ellipse and the solid rectangle lower <= x <= upper: see
/// contact_box() in three dimensions.
///
/// @param lower,upper corners of the box, relative to the centre; lower <= upper
/// @param q the form
/// @return μ², 0 if the centre is in the box, and the point of the box at which the scaled ellipse
/// touches; Status::invalid_argument, Status::not_positive_definite
template <class T>
PW85_FUNCTION inline ShapeContact<T, 2> contact_box(Vector<T, 2> const &lower,
                                                    Vector<T, 2> const &upper,
                                                    SymmetricMatrix<T, 2> const &q) noexcept;

/// Tests whether an ellipse and a segment overlap, μ² < 1. The answer is exact for float, double
/// and long double.
///
/// @param end1,end2,q as for contact_segment()
/// @return the answer; Status::invalid_argument, Status::not_positive_definite
template <class T>
PW85_FUNCTION inline ShapeOverlap overlap_segment(Vector<T, 2> const &end1,
                                                  Vector<T, 2> const &end2,
                                                  SymmetricMatrix<T, 2> const &q) noexcept;

/// Tests whether an ellipse and a solid rectangle overlap, μ² < 1. The answer is exact for float,
/// double and long double.
///
/// @param lower,upper,q as for contact_box()
/// @return the answer; Status::invalid_argument, Status::not_positive_definite
template <class T>
PW85_FUNCTION inline ShapeOverlap overlap_box(Vector<T, 2> const &lower, Vector<T, 2> const &upper,
                                              SymmetricMatrix<T, 2> const &q) noexcept;

/// @}

} // namespace pw85

#include <pw85/bodies/inertia.hpp>
#include <pw85/contact/closest_approach.hpp>
#include <pw85/contact/condition.hpp>
#include <pw85/contact/contact.hpp>
#include <pw85/contact/contact_factored.hpp>
#include <pw85/contact/contact_hessian.hpp>
#include <pw85/contact/forms.hpp>
#include <pw85/contact/geometry.hpp>
#include <pw85/contact/geometry_factored.hpp>
#include <pw85/contact/rotations.hpp>
#include <pw85/distance/bounding_box.hpp>
#include <pw85/distance/capsule.hpp>
#include <pw85/distance/distance.hpp>
#include <pw85/distance/distance_derivatives.hpp>
#include <pw85/distance/gap_inside.hpp>
#include <pw85/distance/grain_contact.hpp>
#include <pw85/distance/grain_contact_wall.hpp>
#include <pw85/distance/hertz.hpp>
#include <pw85/distance/line.hpp>
#include <pw85/distance/nearest.hpp>
#include <pw85/distance/penetration.hpp>
#include <pw85/distance/signed_distance.hpp>
#include <pw85/distance/solids.hpp>
#include <pw85/distance/walls.hpp>
#include <pw85/motion/closest_passage.hpp>
#include <pw85/motion/first_contact.hpp>
#include <pw85/motion/free_path.hpp>
#include <pw85/overlap/compare.hpp>
#include <pw85/overlap/contact_rounded.hpp>
#include <pw85/overlap/containment.hpp>
#include <pw85/overlap/containment_factor.hpp>
#include <pw85/overlap/overlap.hpp>
#include <pw85/overlap/overlap_factored.hpp>
#include <pw85/overlap/witness.hpp>
#include <pw85/shapes/box.hpp>
#include <pw85/shapes/in_plane.hpp>
#include <pw85/shapes/overlap_polytope.hpp>
#include <pw85/shapes/overlap_shapes.hpp>
#include <pw85/shapes/polytope.hpp>
#include <pw85/shapes/segment.hpp>
#include <pw85/shapes/triangle.hpp>
#include <pw85/volume/half_space.hpp>
#include <pw85/volume/overlap_area_derivatives.hpp>
#include <pw85/volume/overlap_volume.hpp>
#include <pw85/volume/overlap_volume_derivatives.hpp>
#include <pw85/volume/volume.hpp>

#endif
