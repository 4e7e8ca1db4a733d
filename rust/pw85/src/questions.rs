// SPDX-License-Identifier: BSD-3-Clause
// Made by api/rust.py from the headers of the C API.

use crate::error::{check, check_number, check_rows, pointer, rows_of, same_rows, Error};
use crate::Motion;
use core::cmp::Ordering;
use pw85_sys as sys;

/// Why a call was refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
#[repr(i32)]
pub enum Status {
    /// `PW85_EINVAL` of C.
    InvalidArgument = 1,
    /// `PW85_ENOTPD` of C.
    NotPositiveDefinite = 2,
    /// `PW85_ECONVERGENCE` of C.
    NoConvergence = 3,
    /// `PW85_ENOMEM` of C.
    OutOfMemory = 4,
    /// `PW85_EDEVICE` of C.
    NoDevice = 5,
    /// `PW85_EOVERLAP` of C.
    Overlap = 6,
    /// `PW85_EPOTENTIAL` of C.
    BadPotential = 7,
    /// A number that this version does not know.
    Unknown = -1,
}

pub(crate) const STATUSES: [Status; 7] = [
    Status::InvalidArgument,
    Status::NotPositiveDefinite,
    Status::NoConvergence,
    Status::OutOfMemory,
    Status::NoDevice,
    Status::Overlap,
    Status::BadPotential,
];

/// Results of [`contact()`](crate::contact), [`contact_rounded()`](crate::contact_rounded),
/// [`contact_factored()`](crate::contact_factored),
/// [`contact_function()`](crate::contact_function), [`contact_2d()`](crate::contact_2d).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// `mu2`, `lambda`: μ², and the maximiser λ of f in \[0, 1\].
    pub mu2: f64,
    /// `mu2`, `lambda`: μ², and the maximiser λ of f in \[0, 1\].
    pub lambda: f64,
}

/// Results of [`contact_geometry()`](crate::contact_geometry),
/// [`contact_geometry_factored()`](crate::contact_geometry_factored).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactGeometry {
    /// The point, relative to the centre of ellipsoid 1.
    pub point: [f64; 3],
    /// Unit vector, outward from ellipsoid 1 and into ellipsoid 2.
    pub normal: [f64; 3],
}

/// Results of [`contact_gradient()`](crate::contact_gradient).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactGradient {
    /// ∂μ²/∂r12; its negative is the derivative with respect to the centre of ellipsoid 1.
    pub d_r12: [f64; 3],
    /// `d_q1`, `d_q2`: Derivatives with respect to the stored entries of q1 and q2 (a stored
    /// off-diagonal entry is two entries of the matrix).
    pub d_q1: [f64; 6],
    /// `d_q1`, `d_q2`: Derivatives with respect to the stored entries of q1 and q2 (a stored
    /// off-diagonal entry is two entries of the matrix).
    pub d_q2: [f64; 6],
}

/// Results of [`contact_gradient_factored()`](crate::contact_gradient_factored).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FactorGradient {
    /// ∂μ²/∂r12.
    pub d_r12: [f64; 3],
    /// `d_s1`, `d_s2`: Derivatives with respect to the entries of s1 and s2.
    pub d_s1: [[f64; 3]; 3],
    /// `d_s1`, `d_s2`: Derivatives with respect to the entries of s1 and s2.
    pub d_s2: [[f64; 3]; 3],
}

/// Results of [`contact_torque()`](crate::contact_torque).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactTorque {
    /// `d_rot1`, `d_rot2`: Derivatives for ellipsoids 1 and 2, per radian.
    pub d_rot1: [f64; 3],
    /// `d_rot1`, `d_rot2`: Derivatives for ellipsoids 1 and 2, per radian.
    pub d_rot2: [f64; 3],
}

/// Results of [`overlap_witness()`](crate::overlap_witness).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OverlapWitness {
    /// Whether the ellipsoids overlap.
    pub overlap: bool,
    /// λ from 0 to 1, with f(λ) \> 1, if the ellipsoids are apart; otherwise NaN.
    pub lambda: f64,
    /// A point inside both ellipsoids and on neither surface, relative to the centre of ellipsoid
    /// 1, if they overlap; otherwise NaN.
    pub point: [f64; 3],
}

/// Results of [`containment()`](crate::containment).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContainmentScale {
    /// Square of the factor.
    pub mu2: f64,
    /// A point of contact on the surface of ellipsoid 2, relative to the centre of ellipsoid 1.
    /// If r12 = 0, there are several such points, and the result is one of them. The same holds
    /// for a short r12 that has no component along the longest semi-axis of ellipsoid 2, after
    /// the linear map that makes ellipsoid 1 a unit ball.
    pub point: [f64; 3],
}

/// Results of [`overlap_volume_gradient()`](crate::overlap_volume_gradient).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OverlapVolumeGradient {
    /// ∂V/∂r12; its negative is the derivative with respect to the centre of ellipsoid 1.
    pub d_r12: [f64; 3],
    /// `d_q1`, `d_q2`: Derivatives with respect to the stored entries of q1 and q2 (a stored
    /// off-diagonal entry is two entries of the matrix).
    pub d_q1: [f64; 6],
    /// `d_q1`, `d_q2`: Derivatives with respect to the stored entries of q1 and q2 (a stored
    /// off-diagonal entry is two entries of the matrix).
    pub d_q2: [f64; 6],
}

/// Results of [`overlap_volume_torque()`](crate::overlap_volume_torque).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OverlapVolumeTorque {
    /// `d_rot1`, `d_rot2`: Derivatives for ellipsoids 1 and 2, per radian.
    pub d_rot1: [f64; 3],
    /// `d_rot1`, `d_rot2`: Derivatives for ellipsoids 1 and 2, per radian.
    pub d_rot2: [f64; 3],
}

/// Results of [`overlap_area_gradient_2d()`](crate::overlap_area_gradient_2d).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OverlapAreaGradient {
    /// ∂A/∂r12; its negative is the derivative with respect to the centre of ellipse 1.
    pub d_r12: [f64; 2],
    /// `d_q1`, `d_q2`: Derivatives with respect to the stored entries of q1 and q2 (a stored
    /// off-diagonal entry is two entries of the matrix).
    pub d_q1: [f64; 3],
    /// `d_q1`, `d_q2`: Derivatives with respect to the stored entries of q1 and q2 (a stored
    /// off-diagonal entry is two entries of the matrix).
    pub d_q2: [f64; 3],
}

/// Results of [`overlap_area_torque_2d()`](crate::overlap_area_torque_2d).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OverlapAreaTorque {
    /// `d_rot1`, `d_rot2`: Per radian.
    pub d_rot1: f64,
    /// `d_rot1`, `d_rot2`: Per radian.
    pub d_rot2: f64,
}

/// Results of [`contact_geometry_2d()`](crate::contact_geometry_2d).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactGeometry2d {
    /// The point, relative to the centre of ellipse 1.
    pub point: [f64; 2],
    /// Unit vector, outward from ellipse 1 and into ellipse 2.
    pub normal: [f64; 2],
}

/// Results of [`contact_gradient_2d()`](crate::contact_gradient_2d).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactGradient2d {
    /// ∂μ²/∂r12; its negative is the derivative with respect to the centre of ellipse 1.
    pub d_r12: [f64; 2],
    /// `d_q1`, `d_q2`: Derivatives with respect to the stored entries of q1 and q2 (a stored
    /// off-diagonal entry is two entries of the matrix).
    pub d_q1: [f64; 3],
    /// `d_q1`, `d_q2`: Derivatives with respect to the stored entries of q1 and q2 (a stored
    /// off-diagonal entry is two entries of the matrix).
    pub d_q2: [f64; 3],
}

/// Results of [`contact_torque_2d()`](crate::contact_torque_2d).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactTorque2d {
    /// `d_rot1`, `d_rot2`: Per radian.
    pub d_rot1: f64,
    /// `d_rot1`, `d_rot2`: Per radian.
    pub d_rot2: f64,
}

/// Results of [`containment_2d()`](crate::containment_2d).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContainmentScale2d {
    /// Square of the factor.
    pub mu2: f64,
    /// A point of contact on the surface of ellipse 2, relative to the centre of ellipse 1. If
    /// r12 = 0, there are several such points, and the result is one of them. The same holds for
    /// a short r12 that has no component along the longest semi-axis of ellipse 2, after the
    /// linear map that makes ellipse 1 a unit ball.
    pub point: [f64; 2],
}

/// Results of [`distance()`](crate::distance), [`signed_distance()`](crate::signed_distance).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Distance {
    /// The distance, in the unit of `r12`; zero if the ellipsoids overlap, as
    /// [`overlap()`](crate::overlap) decides.
    pub distance: f64,
    /// `point1`, `point2`: The closest points of ellipsoids 1 and 2, both relative to the centre
    /// of ellipsoid 1; NaN if the ellipsoids overlap.
    pub point1: [f64; 3],
    /// `point1`, `point2`: The closest points of ellipsoids 1 and 2, both relative to the centre
    /// of ellipsoid 1; NaN if the ellipsoids overlap.
    pub point2: [f64; 3],
}

/// Results of [`distance_geometry()`](crate::distance_geometry).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DistanceGeometry {
    /// The distance, in the unit of `r12`.
    pub distance: f64,
    /// `point1`, `point2`: The closest points of ellipsoids 1 and 2, both relative to the centre
    /// of ellipsoid 1.
    pub point1: [f64; 3],
    /// `point1`, `point2`: The closest points of ellipsoids 1 and 2, both relative to the centre
    /// of ellipsoid 1.
    pub point2: [f64; 3],
    /// Unit vector, outward from ellipsoid 1 and into ellipsoid 2: the derivative of the distance
    /// with respect to r12; NaN if the ellipsoids overlap.
    pub normal: [f64; 3],
}

/// Results of [`distance_derivatives()`](crate::distance_derivatives),
/// [`signed_distance_derivatives()`](crate::signed_distance_derivatives).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DistanceDerivatives {
    /// Derivative with respect to r12: the unit normal at the closest points, into ellipsoid 2.
    pub d_r12: [f64; 3],
    /// `d_rot1`, `d_rot2`: Derivatives with respect to rotations, as for
    /// [`contact_torque()`](crate::contact_torque).
    pub d_rot1: [f64; 3],
    /// `d_rot1`, `d_rot2`: Derivatives with respect to rotations, as for
    /// [`contact_torque()`](crate::contact_torque).
    pub d_rot2: [f64; 3],
    /// Symmetric matrix of second derivatives with respect to r12, rotation 1 and rotation 2, as
    /// for [`contact_hessian()`](crate::contact_hessian).
    pub hessian: [[f64; 9]; 9],
}

/// Results of [`penetration()`](crate::penetration).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Penetration {
    /// The depth, in the unit of `r12`; zero if the ellipsoids do not overlap, as
    /// [`overlap()`](crate::overlap) decides.
    pub depth: f64,
    /// Unit vector along which ellipsoid 2 must move; NaN if the ellipsoids do not overlap.
    pub direction: [f64; 3],
}

/// Results of [`signed_distance_geometry()`](crate::signed_distance_geometry).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SignedDistanceGeometry {
    /// The signed distance, in the unit of `r12`.
    pub distance: f64,
    /// `point1`, `point2`: The closest points of ellipsoids 1 and 2 if they are apart, or the
    /// deepest points if they overlap, both relative to the centre of ellipsoid 1. The outward
    /// normals there are opposite, and along point2 - point1.
    pub point1: [f64; 3],
    /// `point1`, `point2`: The closest points of ellipsoids 1 and 2 if they are apart, or the
    /// deepest points if they overlap, both relative to the centre of ellipsoid 1. The outward
    /// normals there are opposite, and along point2 - point1.
    pub point2: [f64; 3],
    /// Unit vector, outward from ellipsoid 1 and into ellipsoid 2: the derivative of the signed
    /// distance with respect to r12.
    pub normal: [f64; 3],
}

/// Results of [`gap_inside()`](crate::gap_inside).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GapInside {
    /// The gap, in the unit of `r12`; zero if the ellipsoids touch, or if ellipsoid 2 is not
    /// inside ellipsoid 1, as [`contains()`](crate::contains) decides.
    pub gap: f64,
    /// `point1`, `point2`: The closest points of the surfaces of ellipsoids 1 and 2, both
    /// relative to the centre of ellipsoid 1; NaN if ellipsoid 2 is not inside.
    pub point1: [f64; 3],
    /// `point1`, `point2`: The closest points of the surfaces of ellipsoids 1 and 2, both
    /// relative to the centre of ellipsoid 1; NaN if ellipsoid 2 is not inside.
    pub point2: [f64; 3],
    /// Outward unit normal of both ellipsoids at these points, from point2 to point1; the
    /// derivative of the gap with respect to r12 is its negative; NaN if ellipsoid 2 is not
    /// inside.
    pub normal: [f64; 3],
}

/// Results of [`distance_2d()`](crate::distance_2d),
/// [`signed_distance_2d()`](crate::signed_distance_2d).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Distance2d {
    /// The distance, in the unit of `r12`; zero if the ellipses overlap, as
    /// [`overlap_2d()`](crate::overlap_2d) decides.
    pub distance: f64,
    /// `point1`, `point2`: The closest points of ellipses 1 and 2, both relative to the centre of
    /// ellipse 1; NaN if the ellipses overlap.
    pub point1: [f64; 2],
    /// `point1`, `point2`: The closest points of ellipses 1 and 2, both relative to the centre of
    /// ellipse 1; NaN if the ellipses overlap.
    pub point2: [f64; 2],
}

/// Results of [`distance_geometry_2d()`](crate::distance_geometry_2d).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DistanceGeometry2d {
    /// The distance, in the unit of `r12`.
    pub distance: f64,
    /// `point1`, `point2`: The closest points of ellipses 1 and 2, both relative to the centre of
    /// ellipse 1.
    pub point1: [f64; 2],
    /// `point1`, `point2`: The closest points of ellipses 1 and 2, both relative to the centre of
    /// ellipse 1.
    pub point2: [f64; 2],
    /// Unit vector, outward from ellipse 1 and into ellipse 2: the derivative of the distance
    /// with respect to r12; NaN if the ellipses overlap.
    pub normal: [f64; 2],
}

/// Results of [`penetration_2d()`](crate::penetration_2d).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Penetration2d {
    /// The depth, in the unit of `r12`; zero if the ellipses do not overlap, as
    /// [`overlap_2d()`](crate::overlap_2d) decides.
    pub depth: f64,
    /// Unit vector along which ellipse 2 must move; NaN if the ellipses do not overlap.
    pub direction: [f64; 2],
}

/// Results of [`signed_distance_geometry_2d()`](crate::signed_distance_geometry_2d).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SignedDistanceGeometry2d {
    /// The signed distance, in the unit of `r12`.
    pub distance: f64,
    /// `point1`, `point2`: The closest points of ellipses 1 and 2 if they are apart, or the
    /// deepest points if they overlap, both relative to the centre of ellipse 1. The outward
    /// normals there are opposite, and along point2 - point1.
    pub point1: [f64; 2],
    /// `point1`, `point2`: The closest points of ellipses 1 and 2 if they are apart, or the
    /// deepest points if they overlap, both relative to the centre of ellipse 1. The outward
    /// normals there are opposite, and along point2 - point1.
    pub point2: [f64; 2],
    /// Unit vector, outward from ellipse 1 and into ellipse 2: the derivative of the signed
    /// distance with respect to r12.
    pub normal: [f64; 2],
}

/// Results of [`gap_inside_2d()`](crate::gap_inside_2d).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GapInside2d {
    /// The gap, in the unit of `r12`; zero if the ellipses touch, or if ellipse 2 is not inside
    /// ellipse 1, as [`contains_2d()`](crate::contains_2d) decides.
    pub gap: f64,
    /// `point1`, `point2`: The closest points of the surfaces of ellipses 1 and 2, both relative
    /// to the centre of ellipse 1; NaN if ellipse 2 is not inside.
    pub point1: [f64; 2],
    /// `point1`, `point2`: The closest points of the surfaces of ellipses 1 and 2, both relative
    /// to the centre of ellipse 1; NaN if ellipse 2 is not inside.
    pub point2: [f64; 2],
    /// Outward unit normal of both ellipses at these points, from point2 to point1; the
    /// derivative of the gap with respect to r12 is its negative; NaN if ellipse 2 is not inside.
    pub normal: [f64; 2],
}

/// Results of [`closest_passage()`](crate::closest_passage).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClosestPassage {
    /// The least μ²; 0 if ellipsoid 2 passes the centre of ellipsoid 1.
    pub mu2: f64,
    /// The time of the least μ², in \[0, t_max\]; 0 for a zero velocity or r12 = 0.
    pub t: f64,
}

/// Results of [`curvature()`](crate::curvature).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Curvature {
    /// Reciprocals of the radii of curvature, \> 0, the smaller one first.
    pub curvatures: [f64; 2],
    /// Unit vectors along which the surface has these curvatures. Their cross product is the unit
    /// normal. If both curvatures are equal, every direction in the tangent plane is possible,
    /// and the function chooses one.
    pub directions: [[f64; 3]; 2],
}

/// Results of [`hertz()`](crate::hertz).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HertzEllipse {
    /// The effective radius, for spheres R1 R2/(R1 + R2).
    pub radius: f64,
    /// Squares of the semi-axes of the contact ellipse, divided by the depth, along the direction
    /// of each curvature.
    pub ellipse: [f64; 2],
}

/// Results of [`hertz_contact()`](crate::hertz_contact).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HertzContact {
    /// The depth, in the unit of `r12`; negative if a slab perpendicular to the normal separates
    /// the ellipsoids.
    pub depth: f64,
    /// The point at which contact forces act, relative to the centre of ellipsoid 1: the midpoint
    /// of the two points of the surfaces with the normals n and -n.
    pub point: [f64; 3],
    /// Principal curvatures of the gap between both surfaces, \> 0, the smaller one first, as
    /// input for [`hertz()`](crate::hertz): eigenvalues of the sum of the second fundamental
    /// forms.
    pub curvatures: [f64; 2],
    /// Of these curvatures and of the contact ellipse.
    pub directions: [[f64; 3]; 2],
    /// The effective radius, for spheres R1 R2/(R1 + R2).
    pub radius: f64,
    /// Squares of the semi-axes of the contact ellipse, divided by the depth, along the direction
    /// of each curvature.
    pub ellipse: [f64; 2],
}

/// Results of [`grain_contact()`](crate::grain_contact).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GrainContact {
    /// Unit vector n.
    pub normal: [f64; 3],
    /// δ, in the unit of `r12`; negative if a slab perpendicular to the normal separates the
    /// ellipsoids.
    pub depth: f64,
    /// The midpoint of the two points of the surfaces with the normals n and -n, which are δ n
    /// apart, relative to the centre of ellipsoid 1.
    pub point: [f64; 3],
    /// Principal curvatures of the gap between both surfaces, \> 0, the smaller one first, as
    /// input for [`hertz()`](crate::hertz): eigenvalues of the sum of the second fundamental
    /// forms.
    pub curvatures: [f64; 2],
    /// The effective radius, for spheres R1 R2/(R1 + R2).
    pub radius: f64,
}

/// Results of [`grain_radius_gradient()`](crate::grain_radius_gradient).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GrainRadiusGradient {
    /// Derivative with respect to r12.
    pub d_r12: [f64; 3],
    /// `d_rot1`, `d_rot2`: Derivatives with respect to rotations, as for
    /// [`contact_torque()`](crate::contact_torque).
    pub d_rot1: [f64; 3],
    /// `d_rot1`, `d_rot2`: Derivatives with respect to rotations, as for
    /// [`contact_torque()`](crate::contact_torque).
    pub d_rot2: [f64; 3],
}

/// Results of [`grain_contact_wall()`](crate::grain_contact_wall).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GrainWallContact {
    /// Minus the distance of [`distance_plane()`](crate::distance_plane).
    pub depth: f64,
    /// The point of the ellipsoid that is deepest in the wall.
    pub point: [f64; 3],
    /// Of the gap, the smaller one first. If the smaller one is below 2⁻²⁰ times the larger one,
    /// it is set to this value, because surfaces that touch along a line have no finite radius.
    pub curvatures: [f64; 2],
    /// The effective radius, for spheres R1 R2/(R1 + R2).
    pub radius: f64,
}

/// Results of [`distance_plane()`](crate::distance_plane).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceDistance {
    /// The distance, in the unit of the semi-axes; if the two overlap, minus the depth.
    pub distance: f64,
    /// The point of the ellipsoid that is nearest to the half-space, or deepest in it.
    pub point: [f64; 3],
}

/// Results of [`distance_plane_derivatives()`](crate::distance_plane_derivatives),
/// [`contact_plane_derivatives()`](crate::contact_plane_derivatives).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlaneDerivatives {
    /// Derivative with respect to the position of the centre.
    pub d_center: [f64; 3],
    /// Derivative with respect to a small rotation vector about the centre, per radian.
    pub d_rot: [f64; 3],
}

/// Results of [`contact_plane()`](crate::contact_plane).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlaneContact {
    /// Square of the factor by which the ellipsoid must be scaled to touch; 0 if the centre is in
    /// the half-space.
    pub mu2: f64,
    /// The point at which the scaled ellipsoid touches.
    pub point: [f64; 3],
}

/// Results of [`distance_box()`](crate::distance_box).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DistanceBox {
    /// The distance; negative if the ellipsoid is not inside the box.
    pub distance: f64,
    /// The point of the ellipsoid that is nearest to that face, or farthest beyond it.
    pub point: [f64; 3],
    /// Outward unit normal of that face.
    pub normal: [f64; 3],
}

/// Results of [`distance_cylinder()`](crate::distance_cylinder).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DistanceCylinder {
    /// The distance; negative if the ellipsoid is not inside the cylinder.
    pub distance: f64,
    /// The point of the ellipsoid that is farthest from the axis, relative to the centre of the
    /// ellipsoid.
    pub point: [f64; 3],
    /// Outward unit normal of the wall there.
    pub normal: [f64; 3],
}

/// Results of [`distance_point()`](crate::distance_point).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DistancePoint {
    /// The distance; negative if the point is inside the ellipsoid.
    pub distance: f64,
    /// The point of the surface that is nearest to r, relative to the centre; one of them if
    /// there are several.
    pub point: [f64; 3],
    /// Unit vector out of the ellipsoid at this point: the derivative of the distance with
    /// respect to r.
    pub normal: [f64; 3],
}

/// Results of [`intersect_line()`](crate::intersect_line).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chord {
    /// `enter`, `leave`: The interval; its ends are lengths if `direction` has no unit; NaN if
    /// the line misses the ellipsoid.
    pub enter: f64,
    /// `enter`, `leave`: The interval; its ends are lengths if `direction` has no unit; NaN if
    /// the line misses the ellipsoid.
    pub leave: f64,
}

/// Results of [`contact_segment()`](crate::contact_segment),
/// [`contact_triangle()`](crate::contact_triangle), [`contact_box()`](crate::contact_box),
/// [`contact_capsule()`](crate::contact_capsule).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShapeContact {
    /// Square of the factor by which the ellipsoid must be scaled to touch.
    pub mu2: f64,
    /// The point of the segment at which the scaled ellipsoid touches.
    pub point: [f64; 3],
}

/// Results of [`distance_segment()`](crate::distance_segment),
/// [`distance_triangle()`](crate::distance_triangle),
/// [`distance_solid_box()`](crate::distance_solid_box),
/// [`distance_capsule()`](crate::distance_capsule).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShapeDistance {
    /// The signed distance; if the two overlap, it is minus the depth.
    pub distance: f64,
    /// The point of the ellipsoid that is nearest to the segment, or deepest.
    pub point1: [f64; 3],
    /// The point of the segment that is nearest to the ellipsoid, or deepest; relative to the
    /// centre of the ellipsoid.
    pub point2: [f64; 3],
    /// Outward unit normal of the ellipsoid at point1; point2 - point1 is `distance` times this
    /// vector.
    pub normal: [f64; 3],
}

/// Results of [`distance_point_2d()`](crate::distance_point_2d).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceDistance2d {
    /// The distance; negative if the point is inside the ellipse.
    pub distance: f64,
    /// The point of the surface that is nearest to r, relative to the centre; one of them if
    /// there are several.
    pub point: [f64; 2],
    /// Unit vector out of the ellipse at this point: the derivative of the distance with respect
    /// to r.
    pub normal: [f64; 2],
}

/// Results of [`contact_segment_2d()`](crate::contact_segment_2d),
/// [`contact_box_2d()`](crate::contact_box_2d).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShapeContact2d {
    /// Square of the factor by which the ellipse must be scaled to touch.
    pub mu2: f64,
    /// The point of the segment at which the scaled ellipse touches.
    pub point: [f64; 2],
}

/// Computes the quadratic form of a spheroid, Q = a² I + (c² - a²) n nᵀ with \|n\| = 1.
///
/// # Arguments
///
/// - `a`: Equatorial radius; \> 0. Unit: length.
/// - `c`: Polar radius; \> 0. Unit: length.
/// - `n`: Direction of the axis of revolution, of any length; not zero.
///
/// # Errors
///
/// Invalid input.
///
/// # Examples
///
/// ```
/// let found = pw85::spheroid(3.0, 1.0, &[0.0, 0.0, 1.0])?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn spheroid(a: f64, c: f64, n: &[f64; 3]) -> Result<[f64; 6], Error> {
    let mut q = [0.0; 6];
    unsafe { sys::pw85_spheroid(a, c, n.as_ptr(), q.as_mut_ptr()) };
    check_number(q[0])?;
    Ok(q)
}

/// Computes the quadratic form of an ellipsoid, Q = R diag(semi_axes²) Rᵀ.
///
/// # Arguments
///
/// - `semi_axes`: Lengths of the principal semi-axes (not diameters), whose squares are in the
///   range of double; \> 0. Unit: length.
/// - `rotation`: Matrix R, which takes the body frame to the space frame; its columns are the
///   directions of the semi-axes. Each entry of RᵀR - I must be at most 1e-6 in magnitude: single
///   precision is enough. R may be a reflection.
///
/// # Errors
///
/// A number is not finite, `semi_axes` is not positive, the square of `semi_axes` overflows or
/// underflows or `rotation` is not orthonormal.
///
/// # Examples
///
/// ```
/// let found = pw85::ellipsoid(
///     &[3.0, 2.0, 1.0],
///     &[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn ellipsoid(semi_axes: &[f64; 3], rotation: &[[f64; 3]; 3]) -> Result<[f64; 6], Error> {
    let mut q = [0.0; 6];
    check(unsafe { sys::pw85_ellipsoid(
        semi_axes.as_ptr(),
        rotation.as_ptr().cast(),
        q.as_mut_ptr(),
    ) })?;
    Ok(q)
}

/// Computes the quadratic form of an ellipsoid whose orientation is a quaternion.
///
/// # Arguments
///
/// - `semi_axes`: Lengths of the principal semi-axes (not diameters), whose squares are in the
///   range of double; \> 0. Unit: length.
/// - `quaternion`: (w, x, y, z), scalar first, which rotates the body frame into the space frame;
///   of any length, because the function normalises it; not zero.
///
/// # Errors
///
/// A number is not finite, `semi_axes` is not positive, the square of `semi_axes` overflows or
/// underflows or `quaternion` is zero.
///
/// # Examples
///
/// ```
/// let found = pw85::ellipsoid_quaternion(&[3.0, 2.0, 1.0], &[0.9, 0.1, 0.3, 0.2])?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn ellipsoid_quaternion(
    semi_axes: &[f64; 3],
    quaternion: &[f64; 4],
) -> Result<[f64; 6], Error> {
    let mut q = [0.0; 6];
    check(unsafe { sys::pw85_ellipsoid_quaternion(
        semi_axes.as_ptr(),
        quaternion.as_ptr(),
        q.as_mut_ptr(),
    ) })?;
    Ok(q)
}

/// Computes [`ellipsoid_quaternion()`](crate::ellipsoid_quaternion) for many ellipsoids, with
/// bitwise equal results.
///
/// # Arguments
///
/// - `semi_axes`: \> 0. Unit: length.
/// - `quaternions`: Not zero.
/// - `q`: Unit: length².
///
/// Row i of each slice belongs to row i of `semi_axes`.
///
/// # Errors
///
/// A slice has not as many rows as `semi_axes`, or a row is refused. The outputs of such rows are
/// NaN, 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let semi_axes = [[3.0, 2.0, 1.0]; 2];
/// let quaternions = [[0.9, 0.1, 0.3, 0.2]; 2];
/// let mut q = [[0.0; 6]; 2];
/// pw85::ellipsoid_quaternion_batch(&semi_axes, &quaternions, &mut q)?;
/// assert_eq!(q[0], q[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn ellipsoid_quaternion_batch(
    semi_axes: &[[f64; 3]],
    quaternions: &[[f64; 4]],
    q: &mut [[f64; 6]],
) -> Result<(), Error> {
    let n = semi_axes.len();
    let counts = [("quaternions", quaternions.len()), ("q", q.len())];
    same_rows("pw85_ellipsoid_quaternion_batch", "must have as many rows as semi_axes", n, &counts)?;
    check_rows(unsafe { sys::pw85_ellipsoid_quaternion_batch(
        n,
        semi_axes.as_ptr().cast(),
        quaternions.as_ptr().cast(),
        q.as_mut_ptr().cast(),
    ) })
}

/// Computes a factor S of the quadratic form of an ellipsoid, Q = S Sᵀ.
///
/// The factor keeps digits that the form loses: see
/// [`contact_factored()`](crate::contact_factored).
///
/// # Arguments
///
/// - `semi_axes`: Lengths of the principal semi-axes (not diameters), whose squares are in the
///   range of double; \> 0. Unit: length.
/// - `quaternion`: (w, x, y, z), scalar first, which rotates the body frame into the space frame;
///   not zero.
///
/// # Errors
///
/// A number is not finite, `semi_axes` is not positive, the square of `semi_axes` overflows or
/// underflows or `quaternion` is zero.
///
/// # Examples
///
/// ```
/// let found = pw85::ellipsoid_factor(&[3.0, 2.0, 1.0], &[0.9, 0.1, 0.3, 0.2])?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn ellipsoid_factor(
    semi_axes: &[f64; 3],
    quaternion: &[f64; 4],
) -> Result<[[f64; 3]; 3], Error> {
    let mut s = [[0.0; 3]; 3];
    check(unsafe { sys::pw85_ellipsoid_factor(
        semi_axes.as_ptr(),
        quaternion.as_ptr(),
        s.as_mut_ptr().cast(),
    ) })?;
    Ok(s)
}

/// Computes [`ellipsoid_factor()`](crate::ellipsoid_factor) for many ellipsoids, with bitwise
/// equal results.
///
/// # Arguments
///
/// - `semi_axes`: \> 0. Unit: length.
/// - `quaternions`: Not zero.
/// - `s`: Unit: length.
///
/// Row i of each slice belongs to row i of `semi_axes`.
///
/// # Errors
///
/// A slice has not as many rows as `semi_axes`, or a row is refused. The outputs of such rows are
/// NaN, 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let semi_axes = [[3.0, 2.0, 1.0]; 2];
/// let quaternions = [[0.9, 0.1, 0.3, 0.2]; 2];
/// let mut s = [[[0.0; 3]; 3]; 2];
/// pw85::ellipsoid_factor_batch(&semi_axes, &quaternions, &mut s)?;
/// assert_eq!(s[0], s[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn ellipsoid_factor_batch(
    semi_axes: &[[f64; 3]],
    quaternions: &[[f64; 4]],
    s: &mut [[[f64; 3]; 3]],
) -> Result<(), Error> {
    let n = semi_axes.len();
    let counts = [("quaternions", quaternions.len()), ("s", s.len())];
    same_rows("pw85_ellipsoid_factor_batch", "must have as many rows as semi_axes", n, &counts)?;
    check_rows(unsafe { sys::pw85_ellipsoid_factor_batch(
        n,
        semi_axes.as_ptr().cast(),
        quaternions.as_ptr().cast(),
        s.as_mut_ptr().cast(),
    ) })
}

/// Computes the quadratic form (xx, xy, yy) of an ellipse.
///
/// # Arguments
///
/// - `a`, `b`: Semi-axes, whose squares are in the range of double; \> 0. Unit: length.
/// - `angle`: From the x axis to the first semi-axis, counter-clockwise, in radians.
///
/// # Errors
///
/// A number is not finite, `a` is not positive, `b` is not positive, the square of `a` overflows
/// or underflows or the square of `b` overflows or underflows.
///
/// # Examples
///
/// ```
/// let found = pw85::ellipse(3.0, 2.0, 0.5)?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn ellipse(a: f64, b: f64, angle: f64) -> Result<[f64; 3], Error> {
    let mut q = [0.0; 3];
    check(unsafe { sys::pw85_ellipse(a, b, angle, q.as_mut_ptr()) })?;
    Ok(q)
}

/// Computes the contact function of two ellipsoids.
///
/// The method is a third-order iteration on log(λ/(1-λ)), which evaluates f at most 157 times.
/// The relative error of μ² is below 4 u cond, with u = 2⁻⁵³ and the condition number cond of
/// [`condition()`](crate::condition). The bound also holds for forms that are singular to working
/// precision.
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipsoid 1 to that of ellipsoid 2; it may be zero: then μ²
///   = 0 and λ = 1/2. Unit: length.
/// - `q1`, `q2`: Forms of the ellipsoids, in the square of the unit of `r12`. Unit: length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite. `Status::NoConvergence`: the bound
/// on the error cannot be proved; this has never been seen.
///
/// # Examples
///
/// ```
/// let found = pw85::contact(
///     &[3.0, 0.5, 0.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
///     &[0.25, 0.0, 0.0, 0.25, 0.0, 0.25],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn contact(r12: &[f64; 3], q1: &[f64; 6], q2: &[f64; 6]) -> Result<Contact, Error> {
    let mut out = [0.0; 2];
    check(unsafe { sys::pw85_contact(r12.as_ptr(), q1.as_ptr(), q2.as_ptr(), out.as_mut_ptr()) })?;
    Ok(Contact { mu2: out[0], lambda: out[1] })
}

/// Computes [`contact()`](crate::contact) for many pairs.
///
/// The relative error of μ² is below 4 u cond as for one pair. The last bits may differ from
/// those of [`contact()`](crate::contact).
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
///
/// Row i of each slice belongs to row i of `r12`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5, 0.0]; 2];
/// let q1 = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let q2 = [[0.25, 0.0, 0.0, 0.25, 0.0, 0.25]; 2];
/// let mut mu2 = [0.0; 2];
/// let mut lambda = [0.0; 2];
/// pw85::contact_batch(&r12, &q1, &q2, &mut mu2, Some(&mut lambda))?;
/// assert_eq!(lambda[0], lambda[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn contact_batch(
    r12: &[[f64; 3]],
    q1: &[[f64; 6]],
    q2: &[[f64; 6]],
    mu2: &mut [f64],
    lambda: Option<&mut [f64]>,
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("q1", q1.len()),
        ("q2", q2.len()),
        ("mu2", mu2.len()),
        ("lambda", rows_of(&lambda, n)),
    ];
    same_rows("pw85_contact_batch", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_contact_batch(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        mu2.as_mut_ptr(),
        pointer(lambda),
    ) })
}

/// Computes the contact function of two ellipsoids, with μ² correctly rounded.
///
/// μ² is the double nearest to the exact value for the numbers given. If two doubles are equally
/// near, it is the one whose last bit is 0. This rule includes underflow and overflow: a value of
/// 2¹⁰²⁴ - 2⁹⁷⁰ or more becomes infinity. The error of λ is less than one unit in the last place.
///
/// Every processor and every instruction set therefore gives the same μ². Exchanging the two
/// ellipsoids does not change it. Multiplying the unit of length by a power of two does not
/// change it if the data stay in the range of normal doubles.
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipsoid 1 to that of ellipsoid 2. Unit: length.
/// - `q1`, `q2`: Forms of the ellipsoids, in the square of the unit of `r12`. Unit: length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite. `Status::NoConvergence`: the last
/// digit of λ cannot be proved; this has never been seen.
///
/// # Examples
///
/// ```
/// let found = pw85::contact_rounded(
///     &[3.0, 0.5, 0.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
///     &[0.25, 0.0, 0.0, 0.25, 0.0, 0.25],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn contact_rounded(r12: &[f64; 3], q1: &[f64; 6], q2: &[f64; 6]) -> Result<Contact, Error> {
    let mut out = [0.0; 2];
    check(unsafe { sys::pw85_contact_rounded(
        r12.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        out.as_mut_ptr(),
    ) })?;
    Ok(Contact { mu2: out[0], lambda: out[1] })
}

/// Computes [`contact_rounded()`](crate::contact_rounded) for many pairs, with bitwise equal
/// results.
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
///
/// Row i of each slice belongs to row i of `r12`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5, 0.0]; 2];
/// let q1 = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let q2 = [[0.25, 0.0, 0.0, 0.25, 0.0, 0.25]; 2];
/// let mut mu2 = [0.0; 2];
/// let mut lambda = [0.0; 2];
/// pw85::contact_rounded_batch(&r12, &q1, &q2, Some(&mut mu2), Some(&mut lambda))?;
/// assert_eq!(lambda[0], lambda[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn contact_rounded_batch(
    r12: &[[f64; 3]],
    q1: &[[f64; 6]],
    q2: &[[f64; 6]],
    mu2: Option<&mut [f64]>,
    lambda: Option<&mut [f64]>,
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("q1", q1.len()),
        ("q2", q2.len()),
        ("mu2", rows_of(&mu2, n)),
        ("lambda", rows_of(&lambda, n)),
    ];
    same_rows("pw85_contact_rounded_batch", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_contact_rounded_batch(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        pointer(mu2),
        pointer(lambda),
    ) })
}

/// Computes the contact function of two ellipsoids that are given by factors of their forms, Q1 =
/// S1 S1ᵀ and Q2 = S2 S2ᵀ.
///
/// Use this function for slender ellipsoids. An entry of a form is a sum of squares of long and
/// short semi-axes, so rounding the entry loses digits of the short ones. At aspect ratios 100,
/// 10⁴ and 10⁶, rounding the forms changes μ² by about 1e-12, 1e-8 and 1e-4, and rounding the
/// factors changes μ² by less than 1e-14, 1e-12 and 1e-12.
///
/// The relative error of μ² is below 4 u c, with u = 2⁻⁵³. If each entry of s1, s2 and r12
/// changes by at most a fraction ε of itself, μ² changes by at most a fraction ε c, to first
/// order in ε.
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipsoid 1 to that of ellipsoid 2. Unit: length.
/// - `s1`, `s2`: Factors, as from [`ellipsoid_factor()`](crate::ellipsoid_factor). Any matrix S
///   is accepted if its columns, scaled to length one, span a volume above 2⁻³⁹, and if the
///   lengths of its columns differ by a factor below 2¹²⁷. Unit: length.
///
/// # Errors
///
/// A number is not finite. `Status::NoConvergence`: as for [`contact()`](crate::contact).
///
/// # Examples
///
/// ```
/// let found = pw85::contact_factored(
///     &[3.0, 0.5, 0.0],
///     &[[3.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 1.0]],
///     &[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn contact_factored(
    r12: &[f64; 3],
    s1: &[[f64; 3]; 3],
    s2: &[[f64; 3]; 3],
) -> Result<Contact, Error> {
    let mut out = [0.0; 2];
    check(unsafe { sys::pw85_contact_factored(
        r12.as_ptr(),
        s1.as_ptr().cast(),
        s2.as_ptr().cast(),
        out.as_mut_ptr(),
    ) })?;
    Ok(Contact { mu2: out[0], lambda: out[1] })
}

/// Computes [`contact_factored()`](crate::contact_factored) for many pairs, with bitwise equal
/// results.
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `s1`, `s2`: Unit: length.
///
/// Row i of each slice belongs to row i of `r12`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5, 0.0]; 2];
/// let s1 = [[[3.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 1.0]]; 2];
/// let s2 = [[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]; 2];
/// let mut mu2 = [0.0; 2];
/// let mut lambda = [0.0; 2];
/// pw85::contact_factored_batch(&r12, &s1, &s2, Some(&mut mu2), Some(&mut lambda))?;
/// assert_eq!(lambda[0], lambda[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn contact_factored_batch(
    r12: &[[f64; 3]],
    s1: &[[[f64; 3]; 3]],
    s2: &[[[f64; 3]; 3]],
    mu2: Option<&mut [f64]>,
    lambda: Option<&mut [f64]>,
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("s1", s1.len()),
        ("s2", s2.len()),
        ("mu2", rows_of(&mu2, n)),
        ("lambda", rows_of(&lambda, n)),
    ];
    same_rows("pw85_contact_factored_batch", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_contact_factored_batch(
        n,
        r12.as_ptr().cast(),
        s1.as_ptr().cast(),
        s2.as_ptr().cast(),
        pointer(mu2),
        pointer(lambda),
    ) })
}

/// Computes the entrywise condition number of the contact function.
///
/// If each entry of r12, q1 and q2 changes by at most a fraction ε of itself, μ² changes by at
/// most a fraction ε cond, to first order in ε. If the data have d accurate digits, μ² has d -
/// log10(cond) accurate digits. The condition number is of the order of one for typical pairs,
/// and of the order of the squared aspect ratio for slender ones. It is \[λ(1-λ) Σ \|n_i\| ((1-λ)
/// \|q1_ij\| + λ \|q2_ij\|) \|n_j\| + 2 λ(1-λ) Σ \|r12_i n_i\|\]/μ² with n = \[(1-λ) q1 + λ
/// q2\]⁻¹ r12, summed over i and j.
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipsoid 1 to that of ellipsoid 2. Unit: length.
/// - `q1`, `q2`: Forms of the ellipsoids, in the square of the unit of `r12`. Unit: length².
/// - `lambda`: The maximiser λ of f, from [`contact()`](crate::contact).
///
/// # Errors
///
/// A number is not finite, a form is not positive definite or λ is not in \[0, 1\].
///
/// # Examples
///
/// ```
/// let found = pw85::condition(
///     &[3.0, 0.5, 0.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
///     &[0.25, 0.0, 0.0, 0.25, 0.0, 0.25],
///     0.5,
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn condition(r12: &[f64; 3], q1: &[f64; 6], q2: &[f64; 6], lambda: f64) -> Result<f64, Error> {
    let mut cond = 0.0;
    check(unsafe { sys::pw85_condition(
        r12.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        lambda,
        &mut cond,
    ) })?;
    Ok(cond)
}

/// Computes [`condition()`](crate::condition) for many pairs, with bitwise equal results.
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
///
/// Row i of each slice belongs to row i of `r12`.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5, 0.0]; 2];
/// let q1 = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let q2 = [[0.25, 0.0, 0.0, 0.25, 0.0, 0.25]; 2];
/// let lambda = [0.5; 2];
/// let mut cond = [0.0; 2];
/// pw85::condition_batch(&r12, &q1, &q2, &lambda, &mut cond)?;
/// assert_eq!(cond[0], cond[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn condition_batch(
    r12: &[[f64; 3]],
    q1: &[[f64; 6]],
    q2: &[[f64; 6]],
    lambda: &[f64],
    cond: &mut [f64],
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("q1", q1.len()),
        ("q2", q2.len()),
        ("lambda", lambda.len()),
        ("cond", cond.len()),
    ];
    same_rows("pw85_condition_batch", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_condition_batch(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        lambda.as_ptr(),
        cond.as_mut_ptr(),
    ) })
}

/// Computes the contact function of two ellipsoids as pw85 1.0 did, by Brent's method.
///
/// Use [`contact()`](crate::contact) instead: it is several times faster, with the same error
/// bound. This function scales the ellipsoids to similar size, so that ``lambda_atol`` has the
/// same meaning for all sizes. Brent's method then maximises f, and Halley's method (in pw85 1.0,
/// Newton's method) refines the result.
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipsoid 1 to that of ellipsoid 2. Unit: length.
/// - `q1`, `q2`: Forms of the ellipsoids, in the square of the unit of `r12`. Unit: length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite. `Status::NoConvergence`: as for
/// [`contact()`](crate::contact).
///
/// # Examples
///
/// ```
/// let found = pw85::contact_function(
///     &[3.0, 0.5, 0.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
///     &[0.25, 0.0, 0.0, 0.25, 0.0, 0.25],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn contact_function(r12: &[f64; 3], q1: &[f64; 6], q2: &[f64; 6]) -> Result<Contact, Error> {
    let mut out = [0.0; 2];
    check(unsafe { sys::pw85_contact_function(
        r12.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        out.as_mut_ptr(),
    ) })?;
    Ok(Contact { mu2: out[0], lambda: out[1] })
}

/// Computes [`contact_function()`](crate::contact_function) for many pairs, with bitwise equal
/// results.
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
///
/// Row i of each slice belongs to row i of `r12`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5, 0.0]; 2];
/// let q1 = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let q2 = [[0.25, 0.0, 0.0, 0.25, 0.0, 0.25]; 2];
/// let mut mu2 = [0.0; 2];
/// let mut lambda = [0.0; 2];
/// pw85::contact_function_batch(&r12, &q1, &q2, Some(&mut mu2), Some(&mut lambda))?;
/// assert_eq!(lambda[0], lambda[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn contact_function_batch(
    r12: &[[f64; 3]],
    q1: &[[f64; 6]],
    q2: &[[f64; 6]],
    mu2: Option<&mut [f64]>,
    lambda: Option<&mut [f64]>,
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("q1", q1.len()),
        ("q2", q2.len()),
        ("mu2", rows_of(&mu2, n)),
        ("lambda", rows_of(&lambda, n)),
    ];
    same_rows("pw85_contact_function_batch", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_contact_function_batch(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        pointer(mu2),
        pointer(lambda),
    ) })
}

/// Computes the point at which the ellipsoids, scaled by μ, touch, and their common normal there.
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipsoid 1 to that of ellipsoid 2; not zero. Unit: length.
/// - `q1`, `q2`: Forms of the ellipsoids, in the square of the unit of `r12`. Unit: length².
/// - `lambda`: The maximiser λ of f, from [`contact()`](crate::contact). For another λ in \[0,
///   1\] the point is x0(λ) of the chapter on theory. It is on the surface of ellipsoid 1 scaled
///   by μ1, and on that of ellipsoid 2 scaled by μ2, where f(λ) = λ μ1² + (1-λ) μ2².
///
/// # Errors
///
/// A number is not finite, a form is not positive definite, `r12` is zero or λ is not in \[0,
/// 1\].
///
/// # Examples
///
/// ```
/// let found = pw85::contact_geometry(
///     &[3.0, 0.5, 0.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
///     &[0.25, 0.0, 0.0, 0.25, 0.0, 0.25],
///     0.5,
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn contact_geometry(
    r12: &[f64; 3],
    q1: &[f64; 6],
    q2: &[f64; 6],
    lambda: f64,
) -> Result<ContactGeometry, Error> {
    let mut point = [0.0; 3];
    let mut normal = [0.0; 3];
    check(unsafe { sys::pw85_contact_geometry(
        r12.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        lambda,
        point.as_mut_ptr(),
        normal.as_mut_ptr(),
    ) })?;
    Ok(ContactGeometry { point, normal })
}

/// Computes [`contact_geometry()`](crate::contact_geometry) for many pairs, with bitwise equal
/// results.
///
/// # Arguments
///
/// - `r12`: Not zero. Unit: length.
/// - `q1`, `q2`: Unit: length².
/// - `point`: Unit: length.
///
/// Row i of each slice belongs to row i of `r12`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5, 0.0]; 2];
/// let q1 = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let q2 = [[0.25, 0.0, 0.0, 0.25, 0.0, 0.25]; 2];
/// let lambda = [0.5; 2];
/// let mut point = [[0.0; 3]; 2];
/// let mut normal = [[0.0; 3]; 2];
/// pw85::contact_geometry_batch(&r12, &q1, &q2, &lambda, Some(&mut point), Some(&mut normal))?;
/// assert_eq!(normal[0], normal[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn contact_geometry_batch(
    r12: &[[f64; 3]],
    q1: &[[f64; 6]],
    q2: &[[f64; 6]],
    lambda: &[f64],
    point: Option<&mut [[f64; 3]]>,
    normal: Option<&mut [[f64; 3]]>,
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("q1", q1.len()),
        ("q2", q2.len()),
        ("lambda", lambda.len()),
        ("point", rows_of(&point, n)),
        ("normal", rows_of(&normal, n)),
    ];
    same_rows("pw85_contact_geometry_batch", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_contact_geometry_batch(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        lambda.as_ptr(),
        pointer(point),
        pointer(normal),
    ) })
}

/// Computes the contact point and the normal of ellipsoids that are given by factors of their
/// forms.
///
/// See [`contact_geometry()`](crate::contact_geometry).
///
/// Errors are below 4 u C for the given λ, with u = 2⁻⁵³. C is the largest change of the result,
/// to first order, if each entry of s1 and s2 changes by the largest magnitude in its column, and
/// each coordinate of r12 changes by its own magnitude.
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipsoid 1 to that of ellipsoid 2; not zero. Unit: length.
/// - `s1`, `s2`: Factors, as from [`ellipsoid_factor()`](crate::ellipsoid_factor). Any matrix S
///   is accepted if its columns, scaled to length one, span a volume above 2⁻³⁹, and if the
///   lengths of its columns differ by a factor below 2¹²⁷. Unit: length.
/// - `lambda`: The maximiser λ of f, from [`contact_factored()`](crate::contact_factored).
///
/// # Errors
///
/// A number is not finite, `r12` is zero or λ is not in \[0, 1\].
///
/// # Examples
///
/// ```
/// let found = pw85::contact_geometry_factored(
///     &[3.0, 0.5, 0.0],
///     &[[3.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 1.0]],
///     &[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
///     0.5,
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn contact_geometry_factored(
    r12: &[f64; 3],
    s1: &[[f64; 3]; 3],
    s2: &[[f64; 3]; 3],
    lambda: f64,
) -> Result<ContactGeometry, Error> {
    let mut point = [0.0; 3];
    let mut normal = [0.0; 3];
    check(unsafe { sys::pw85_contact_geometry_factored(
        r12.as_ptr(),
        s1.as_ptr().cast(),
        s2.as_ptr().cast(),
        lambda,
        point.as_mut_ptr(),
        normal.as_mut_ptr(),
    ) })?;
    Ok(ContactGeometry { point, normal })
}

/// Computes [`contact_geometry_factored()`](crate::contact_geometry_factored) for many pairs,
/// with bitwise equal results.
///
/// # Arguments
///
/// - `r12`: Not zero. Unit: length.
/// - `s1`, `s2`: Unit: length.
/// - `point`: Unit: length.
///
/// Row i of each slice belongs to row i of `r12`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5, 0.0]; 2];
/// let s1 = [[[3.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 1.0]]; 2];
/// let s2 = [[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]; 2];
/// let lambda = [0.5; 2];
/// let mut point = [[0.0; 3]; 2];
/// let mut normal = [[0.0; 3]; 2];
/// pw85::contact_geometry_factored_batch(
///     &r12,
///     &s1,
///     &s2,
///     &lambda,
///     Some(&mut point),
///     Some(&mut normal),
/// )?;
/// assert_eq!(normal[0], normal[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn contact_geometry_factored_batch(
    r12: &[[f64; 3]],
    s1: &[[[f64; 3]; 3]],
    s2: &[[[f64; 3]; 3]],
    lambda: &[f64],
    point: Option<&mut [[f64; 3]]>,
    normal: Option<&mut [[f64; 3]]>,
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("s1", s1.len()),
        ("s2", s2.len()),
        ("lambda", lambda.len()),
        ("point", rows_of(&point, n)),
        ("normal", rows_of(&normal, n)),
    ];
    same_rows("pw85_contact_geometry_factored_batch", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_contact_geometry_factored_batch(
        n,
        r12.as_ptr().cast(),
        s1.as_ptr().cast(),
        s2.as_ptr().cast(),
        lambda.as_ptr(),
        pointer(point),
        pointer(normal),
    ) })
}

/// Computes the derivatives of μ² with respect to r12 and the forms.
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipsoid 1 to that of ellipsoid 2. Unit: length.
/// - `q1`, `q2`: Forms of the ellipsoids, in the square of the unit of `r12`. Unit: length².
/// - `lambda`: The maximiser λ of f, from [`contact()`](crate::contact).
///
/// # Errors
///
/// A number is not finite, a form is not positive definite or λ is not in \[0, 1\].
///
/// # Examples
///
/// ```
/// let found = pw85::contact_gradient(
///     &[3.0, 0.5, 0.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
///     &[0.25, 0.0, 0.0, 0.25, 0.0, 0.25],
///     0.5,
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn contact_gradient(
    r12: &[f64; 3],
    q1: &[f64; 6],
    q2: &[f64; 6],
    lambda: f64,
) -> Result<ContactGradient, Error> {
    let mut d_r12 = [0.0; 3];
    let mut d_q1 = [0.0; 6];
    let mut d_q2 = [0.0; 6];
    check(unsafe { sys::pw85_contact_gradient(
        r12.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        lambda,
        d_r12.as_mut_ptr(),
        d_q1.as_mut_ptr(),
        d_q2.as_mut_ptr(),
    ) })?;
    Ok(ContactGradient { d_r12, d_q1, d_q2 })
}

/// Computes [`contact_gradient()`](crate::contact_gradient) for many pairs, with bitwise equal
/// results.
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
/// - `d_r12`: Unit: 1/length.
/// - `d_q1`, `d_q2`: Unit: 1/length².
///
/// Row i of each slice belongs to row i of `r12`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5, 0.0]; 2];
/// let q1 = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let q2 = [[0.25, 0.0, 0.0, 0.25, 0.0, 0.25]; 2];
/// let lambda = [0.5; 2];
/// let mut d_r12 = [[0.0; 3]; 2];
/// let mut d_q1 = [[0.0; 6]; 2];
/// let mut d_q2 = [[0.0; 6]; 2];
/// pw85::contact_gradient_batch(
///     &r12,
///     &q1,
///     &q2,
///     &lambda,
///     Some(&mut d_r12),
///     Some(&mut d_q1),
///     Some(&mut d_q2),
/// )?;
/// assert_eq!(d_q2[0], d_q2[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn contact_gradient_batch(
    r12: &[[f64; 3]],
    q1: &[[f64; 6]],
    q2: &[[f64; 6]],
    lambda: &[f64],
    d_r12: Option<&mut [[f64; 3]]>,
    d_q1: Option<&mut [[f64; 6]]>,
    d_q2: Option<&mut [[f64; 6]]>,
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("q1", q1.len()),
        ("q2", q2.len()),
        ("lambda", lambda.len()),
        ("d_r12", rows_of(&d_r12, n)),
        ("d_q1", rows_of(&d_q1, n)),
        ("d_q2", rows_of(&d_q2, n)),
    ];
    same_rows("pw85_contact_gradient_batch", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_contact_gradient_batch(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        lambda.as_ptr(),
        pointer(d_r12),
        pointer(d_q1),
        pointer(d_q2),
    ) })
}

/// Computes the derivatives of μ² for ellipsoids that are given by factors of their forms.
///
/// The derivative with respect to a factor S is 2 (∂μ²/∂Q) S, where ∂μ²/∂Q is a symmetric matrix.
/// A change dS of the factor changes μ² by Σ d_s_ij dS_ij. The bound on the errors is 4 u C, as
/// for [`contact_geometry_factored()`](crate::contact_geometry_factored).
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipsoid 1 to that of ellipsoid 2. Unit: length.
/// - `s1`, `s2`: Factors, as from [`ellipsoid_factor()`](crate::ellipsoid_factor). Any matrix S
///   is accepted if its columns, scaled to length one, span a volume above 2⁻³⁹, and if the
///   lengths of its columns differ by a factor below 2¹²⁷. Unit: length.
/// - `lambda`: The maximiser λ of f, from [`contact_factored()`](crate::contact_factored).
///
/// # Errors
///
/// A number is not finite or λ is not in \[0, 1\].
///
/// # Examples
///
/// ```
/// let found = pw85::contact_gradient_factored(
///     &[3.0, 0.5, 0.0],
///     &[[3.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 1.0]],
///     &[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
///     0.5,
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn contact_gradient_factored(
    r12: &[f64; 3],
    s1: &[[f64; 3]; 3],
    s2: &[[f64; 3]; 3],
    lambda: f64,
) -> Result<FactorGradient, Error> {
    let mut d_r12 = [0.0; 3];
    let mut d_s1 = [[0.0; 3]; 3];
    let mut d_s2 = [[0.0; 3]; 3];
    check(unsafe { sys::pw85_contact_gradient_factored(
        r12.as_ptr(),
        s1.as_ptr().cast(),
        s2.as_ptr().cast(),
        lambda,
        d_r12.as_mut_ptr(),
        d_s1.as_mut_ptr().cast(),
        d_s2.as_mut_ptr().cast(),
    ) })?;
    Ok(FactorGradient { d_r12, d_s1, d_s2 })
}

/// Computes [`contact_gradient_factored()`](crate::contact_gradient_factored) for many pairs,
/// with bitwise equal results.
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `s1`, `s2`: Unit: length.
/// - `d_r12`: Unit: 1/length.
/// - `d_s1`, `d_s2`: Unit: 1/length.
///
/// Row i of each slice belongs to row i of `r12`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5, 0.0]; 2];
/// let s1 = [[[3.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 1.0]]; 2];
/// let s2 = [[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]; 2];
/// let lambda = [0.5; 2];
/// let mut d_r12 = [[0.0; 3]; 2];
/// let mut d_s1 = [[[0.0; 3]; 3]; 2];
/// let mut d_s2 = [[[0.0; 3]; 3]; 2];
/// pw85::contact_gradient_factored_batch(
///     &r12,
///     &s1,
///     &s2,
///     &lambda,
///     Some(&mut d_r12),
///     Some(&mut d_s1),
///     Some(&mut d_s2),
/// )?;
/// assert_eq!(d_s2[0], d_s2[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn contact_gradient_factored_batch(
    r12: &[[f64; 3]],
    s1: &[[[f64; 3]; 3]],
    s2: &[[[f64; 3]; 3]],
    lambda: &[f64],
    d_r12: Option<&mut [[f64; 3]]>,
    d_s1: Option<&mut [[[f64; 3]; 3]]>,
    d_s2: Option<&mut [[[f64; 3]; 3]]>,
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("s1", s1.len()),
        ("s2", s2.len()),
        ("lambda", lambda.len()),
        ("d_r12", rows_of(&d_r12, n)),
        ("d_s1", rows_of(&d_s1, n)),
        ("d_s2", rows_of(&d_s2, n)),
    ];
    same_rows("pw85_contact_gradient_factored_batch", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_contact_gradient_factored_batch(
        n,
        r12.as_ptr().cast(),
        s1.as_ptr().cast(),
        s2.as_ptr().cast(),
        lambda.as_ptr(),
        pointer(d_r12),
        pointer(d_s1),
        pointer(d_s2),
    ) })
}

/// Computes the derivatives of μ² with respect to rotations of the ellipsoids.
///
/// If an ellipsoid rotates about its own centre by a small rotation vector ω, μ² changes by
/// d_rot·ω. An energy U(μ²) exerts the torque -U'(μ²) d_rot on the ellipsoid.
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipsoid 1 to that of ellipsoid 2. Unit: length.
/// - `q1`, `q2`: Forms of the ellipsoids, in the square of the unit of `r12`. Unit: length².
/// - `lambda`: The maximiser λ of f, from [`contact()`](crate::contact).
///
/// # Errors
///
/// A number is not finite, a form is not positive definite or λ is not in \[0, 1\].
///
/// # Examples
///
/// ```
/// let found = pw85::contact_torque(
///     &[3.0, 0.5, 0.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
///     &[0.25, 0.0, 0.0, 0.25, 0.0, 0.25],
///     0.5,
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn contact_torque(
    r12: &[f64; 3],
    q1: &[f64; 6],
    q2: &[f64; 6],
    lambda: f64,
) -> Result<ContactTorque, Error> {
    let mut d_rot1 = [0.0; 3];
    let mut d_rot2 = [0.0; 3];
    check(unsafe { sys::pw85_contact_torque(
        r12.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        lambda,
        d_rot1.as_mut_ptr(),
        d_rot2.as_mut_ptr(),
    ) })?;
    Ok(ContactTorque { d_rot1, d_rot2 })
}

/// Computes [`contact_torque()`](crate::contact_torque) for many pairs, with bitwise equal
/// results.
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
///
/// Row i of each slice belongs to row i of `r12`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5, 0.0]; 2];
/// let q1 = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let q2 = [[0.25, 0.0, 0.0, 0.25, 0.0, 0.25]; 2];
/// let lambda = [0.5; 2];
/// let mut d_rot1 = [[0.0; 3]; 2];
/// let mut d_rot2 = [[0.0; 3]; 2];
/// pw85::contact_torque_batch(&r12, &q1, &q2, &lambda, Some(&mut d_rot1), Some(&mut d_rot2))?;
/// assert_eq!(d_rot2[0], d_rot2[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn contact_torque_batch(
    r12: &[[f64; 3]],
    q1: &[[f64; 6]],
    q2: &[[f64; 6]],
    lambda: &[f64],
    d_rot1: Option<&mut [[f64; 3]]>,
    d_rot2: Option<&mut [[f64; 3]]>,
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("q1", q1.len()),
        ("q2", q2.len()),
        ("lambda", lambda.len()),
        ("d_rot1", rows_of(&d_rot1, n)),
        ("d_rot2", rows_of(&d_rot2, n)),
    ];
    same_rows("pw85_contact_torque_batch", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_contact_torque_batch(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        lambda.as_ptr(),
        pointer(d_rot1),
        pointer(d_rot2),
    ) })
}

/// Computes the second derivatives of μ² with respect to r12 and rotations of the ellipsoids.
///
/// The relative error of the second derivatives is a few times the relative errors of λ and of
/// 1-λ. If λ comes from [`contact()`](crate::contact), its relative error is a few u times the
/// squared aspect ratio, with u = 2⁻⁵³. If ellipsoid 1 is much larger than ellipsoid 2, the
/// relative error of 1-λ is u/(1-λ).
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipsoid 1 to that of ellipsoid 2; not zero. Unit: length.
/// - `q1`, `q2`: Forms of the ellipsoids, in the square of the unit of `r12`. Unit: length².
/// - `lambda`: The maximiser λ of f, from [`contact()`](crate::contact).
///
/// # Errors
///
/// A number is not finite, a form is not positive definite, `r12` is zero or λ is not in \[0,
/// 1\].
///
/// # Examples
///
/// ```
/// let found = pw85::contact_hessian(
///     &[3.0, 0.5, 0.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
///     &[0.25, 0.0, 0.0, 0.25, 0.0, 0.25],
///     0.5,
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn contact_hessian(
    r12: &[f64; 3],
    q1: &[f64; 6],
    q2: &[f64; 6],
    lambda: f64,
) -> Result<[[f64; 9]; 9], Error> {
    let mut hessian = [[0.0; 9]; 9];
    check(unsafe { sys::pw85_contact_hessian(
        r12.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        lambda,
        hessian.as_mut_ptr().cast(),
    ) })?;
    Ok(hessian)
}

/// Computes [`contact_hessian()`](crate::contact_hessian) for many pairs, with bitwise equal
/// results.
///
/// # Arguments
///
/// - `r12`: Not zero. Unit: length.
/// - `q1`, `q2`: Unit: length².
/// - `hessian`: Unit: mixed units.
///
/// Row i of each slice belongs to row i of `r12`.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5, 0.0]; 2];
/// let q1 = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let q2 = [[0.25, 0.0, 0.0, 0.25, 0.0, 0.25]; 2];
/// let lambda = [0.5; 2];
/// let mut hessian = [[[0.0; 9]; 9]; 2];
/// pw85::contact_hessian_batch(&r12, &q1, &q2, &lambda, &mut hessian)?;
/// assert_eq!(hessian[0], hessian[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn contact_hessian_batch(
    r12: &[[f64; 3]],
    q1: &[[f64; 6]],
    q2: &[[f64; 6]],
    lambda: &[f64],
    hessian: &mut [[[f64; 9]; 9]],
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("q1", q1.len()),
        ("q2", q2.len()),
        ("lambda", lambda.len()),
        ("hessian", hessian.len()),
    ];
    same_rows("pw85_contact_hessian_batch", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_contact_hessian_batch(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        lambda.as_ptr(),
        hessian.as_mut_ptr().cast(),
    ) })
}

/// Tests whether two ellipsoids overlap, μ² \< 1.
///
/// Tangent ellipsoids (μ² = 1) do not overlap.
///
/// The answer is exact for the numbers given. Bounds that account for rounding decide almost all
/// pairs, and exact arithmetic decides the others.
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipsoid 1 to that of ellipsoid 2; zero is an overlap.
///   Unit: length.
/// - `q1`, `q2`: Forms of the ellipsoids, in the square of the unit of `r12`. Unit: length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite.
///
/// # Examples
///
/// ```
/// let found = pw85::overlap(
///     &[3.0, 0.5, 0.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
///     &[0.25, 0.0, 0.0, 0.25, 0.0, 0.25],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn overlap(r12: &[f64; 3], q1: &[f64; 6], q2: &[f64; 6]) -> Result<bool, Error> {
    let mut overlap = 0;
    check(unsafe { sys::pw85_overlap(r12.as_ptr(), q1.as_ptr(), q2.as_ptr(), &mut overlap) })?;
    Ok(overlap == 1)
}

/// Computes [`overlap()`](crate::overlap) for many pairs, with the same answers.
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
/// - `overlap`: 1, 0, or 255 for a bad pair.
///
/// Row i of each slice belongs to row i of `r12`.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5, 0.0]; 2];
/// let q1 = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let q2 = [[0.25, 0.0, 0.0, 0.25, 0.0, 0.25]; 2];
/// let mut overlap = [0; 2];
/// pw85::overlap_batch(&r12, &q1, &q2, &mut overlap)?;
/// assert_eq!(overlap[0], overlap[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn overlap_batch(
    r12: &[[f64; 3]],
    q1: &[[f64; 6]],
    q2: &[[f64; 6]],
    overlap: &mut [u8],
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [("q1", q1.len()), ("q2", q2.len()), ("overlap", overlap.len())];
    same_rows("pw85_overlap_batch", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_overlap_batch(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        overlap.as_mut_ptr(),
    ) })
}

/// Tests whether two ellipsoids that are given by factors of their forms overlap, Q1 = S1 S1ᵀ and
/// Q2 = S2 S2ᵀ.
///
/// The answer is exact for the unrounded products S Sᵀ of the given factors.
/// [`overlap()`](crate::overlap) may give another answer, because its forms are rounded.
/// Separating planes and common points, with bounds that account for rounding, decide almost all
/// pairs. Integer arithmetic decides the others, if r12 and the entries of s1 and s2 are
/// multiples of one power of two and smaller than 2¹⁵⁰⁰ times this power.
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipsoid 1 to that of ellipsoid 2; zero is an overlap.
///   Unit: length.
/// - `s1`, `s2`: Factors, as from [`ellipsoid_factor()`](crate::ellipsoid_factor). Any matrix S
///   is accepted if its columns, scaled to length one, span a volume above 2⁻³⁹, and if the
///   lengths of its columns differ by a factor below 2¹²⁷. Unit: length.
///
/// # Errors
///
/// A number is not finite. `Status::NoConvergence`: the ellipsoids nearly touch, so that only
/// integer arithmetic can decide, and the numbers do not meet the condition above.
///
/// # Examples
///
/// ```
/// let found = pw85::overlap_factored(
///     &[3.0, 0.5, 0.0],
///     &[[3.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 1.0]],
///     &[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn overlap_factored(
    r12: &[f64; 3],
    s1: &[[f64; 3]; 3],
    s2: &[[f64; 3]; 3],
) -> Result<bool, Error> {
    let mut overlap = 0;
    check(unsafe { sys::pw85_overlap_factored(
        r12.as_ptr(),
        s1.as_ptr().cast(),
        s2.as_ptr().cast(),
        &mut overlap,
    ) })?;
    Ok(overlap == 1)
}

/// Computes [`overlap_factored()`](crate::overlap_factored) for many pairs, with the same
/// answers.
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `s1`, `s2`: Unit: length.
/// - `overlap`: 1, 0, or 255 for a bad pair.
///
/// Row i of each slice belongs to row i of `r12`.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5, 0.0]; 2];
/// let s1 = [[[3.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 1.0]]; 2];
/// let s2 = [[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]; 2];
/// let mut overlap = [0; 2];
/// pw85::overlap_factored_batch(&r12, &s1, &s2, &mut overlap)?;
/// assert_eq!(overlap[0], overlap[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn overlap_factored_batch(
    r12: &[[f64; 3]],
    s1: &[[[f64; 3]; 3]],
    s2: &[[[f64; 3]; 3]],
    overlap: &mut [u8],
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [("s1", s1.len()), ("s2", s2.len()), ("overlap", overlap.len())];
    same_rows("pw85_overlap_factored_batch", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_overlap_factored_batch(
        n,
        r12.as_ptr().cast(),
        s1.as_ptr().cast(),
        s2.as_ptr().cast(),
        overlap.as_mut_ptr(),
    ) })
}

/// Compares μ² with a number mu2 \>= 0, and returns the sign of μ² - mu2.
///
/// The sign is exact for the numbers given. [`overlap()`](crate::overlap) is the case mu2 = 1. A
/// bound on the error of μ² decides almost all pairs, and exact arithmetic decides the others.
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipsoid 1 to that of ellipsoid 2. Unit: length.
/// - `q1`, `q2`: Forms of the ellipsoids, in the square of the unit of `r12`. Unit: length².
/// - `mu2`: The number to compare with; \>= 0; may be infinite.
///
/// # Errors
///
/// A number is not finite (`mu2` may be infinite), a form is not positive definite or `mu2` is
/// negative.
///
/// # Examples
///
/// ```
/// let found = pw85::compare(
///     &[3.0, 0.5, 0.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
///     &[0.25, 0.0, 0.0, 0.25, 0.0, 0.25],
///     1.0,
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn compare(r12: &[f64; 3], q1: &[f64; 6], q2: &[f64; 6], mu2: f64) -> Result<Ordering, Error> {
    let mut sign = 0;
    check(unsafe { sys::pw85_compare(r12.as_ptr(), q1.as_ptr(), q2.as_ptr(), mu2, &mut sign) })?;
    Ok(sign.cmp(&0))
}

/// Computes [`compare()`](crate::compare) for many pairs, with the same signs.
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
/// - `mu2`: \>= 0; may be infinite.
/// - `sign`: -1, 0 or 1, or 2 for a bad pair.
///
/// Row i of each slice belongs to row i of `r12`.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5, 0.0]; 2];
/// let q1 = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let q2 = [[0.25, 0.0, 0.0, 0.25, 0.0, 0.25]; 2];
/// let mu2 = [1.0; 2];
/// let mut sign = [0; 2];
/// pw85::compare_batch(&r12, &q1, &q2, &mu2, &mut sign)?;
/// assert_eq!(sign[0], sign[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn compare_batch(
    r12: &[[f64; 3]],
    q1: &[[f64; 6]],
    q2: &[[f64; 6]],
    mu2: &[f64],
    sign: &mut [i32],
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [("q1", q1.len()), ("q2", q2.len()), ("mu2", mu2.len()), ("sign", sign.len())];
    same_rows("pw85_compare_batch", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_compare_batch(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        mu2.as_ptr(),
        sign.as_mut_ptr(),
    ) })
}

/// Tests whether two ellipsoids overlap, as [`overlap()`](crate::overlap) does, and returns a
/// number or a point that proves the answer.
///
/// If the ellipsoids are apart, the proof is a double λ with f(λ) \> 1. The function finds such a
/// double if there is one. If the ellipsoids overlap, the proof is a point inside both. The
/// function searches for this point near the contact point of the ellipsoids scaled by μ; the
/// search may fail if 1 - μ² is below 1e-13. For tangent ellipsoids there is no proof: `λ` and
/// `point` are then NaN. A proof is exact for the given doubles, and a program can verify it in
/// rational arithmetic.
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipsoid 1 to that of ellipsoid 2. Unit: length.
/// - `q1`, `q2`: Forms of the ellipsoids, in the square of the unit of `r12`. Unit: length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite. `Status::NoConvergence`: the
/// function finds no proof among the doubles; this was seen only if μ² differs from 1 by less
/// than 1e-13, at aspect ratios up to 10⁸.
///
/// # Examples
///
/// ```
/// let found = pw85::overlap_witness(
///     &[3.0, 0.5, 0.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
///     &[0.25, 0.0, 0.0, 0.25, 0.0, 0.25],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn overlap_witness(
    r12: &[f64; 3],
    q1: &[f64; 6],
    q2: &[f64; 6],
) -> Result<OverlapWitness, Error> {
    let mut overlap = 0;
    let mut lambda = 0.0;
    let mut point = [0.0; 3];
    check(unsafe { sys::pw85_overlap_witness(
        r12.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        &mut overlap,
        &mut lambda,
        point.as_mut_ptr(),
    ) })?;
    Ok(OverlapWitness { overlap: overlap == 1, lambda, point })
}

/// Computes [`overlap_witness()`](crate::overlap_witness) for many pairs, with the same results.
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
/// - `overlap`: 1, 0, or 255 for a bad pair.
/// - `lambda`: NaN where the ellipsoids are not apart.
/// - `point`: NaN where they do not overlap. Unit: length.
///
/// Row i of each slice belongs to row i of `r12`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5, 0.0]; 2];
/// let q1 = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let q2 = [[0.25, 0.0, 0.0, 0.25, 0.0, 0.25]; 2];
/// let mut overlap = [0; 2];
/// let mut lambda = [0.0; 2];
/// let mut point = [[0.0; 3]; 2];
/// pw85::overlap_witness_batch(&r12, &q1, &q2, &mut overlap, Some(&mut lambda), Some(&mut point))?;
/// assert_eq!(point[0], point[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn overlap_witness_batch(
    r12: &[[f64; 3]],
    q1: &[[f64; 6]],
    q2: &[[f64; 6]],
    overlap: &mut [u8],
    lambda: Option<&mut [f64]>,
    point: Option<&mut [[f64; 3]]>,
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("q1", q1.len()),
        ("q2", q2.len()),
        ("overlap", overlap.len()),
        ("lambda", rows_of(&lambda, n)),
        ("point", rows_of(&point, n)),
    ];
    same_rows("pw85_overlap_witness_batch", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_overlap_witness_batch(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        overlap.as_mut_ptr(),
        pointer(lambda),
        pointer(point),
    ) })
}

/// Tests whether ellipsoid 2 is inside ellipsoid 1.
///
/// Ellipsoid 2 may touch the surface of ellipsoid 1 from inside.
///
/// The answer is exact for the numbers given. Every ellipsoid contains itself.
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipsoid 1 to that of ellipsoid 2. Unit: length.
/// - `q1`, `q2`: Forms of the ellipsoids, in the square of the unit of `r12`. Unit: length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite.
///
/// # Examples
///
/// ```
/// let found = pw85::contains(
///     &[3.0, 0.5, 0.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
///     &[0.25, 0.0, 0.0, 0.25, 0.0, 0.25],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn contains(r12: &[f64; 3], q1: &[f64; 6], q2: &[f64; 6]) -> Result<bool, Error> {
    let mut contains = 0;
    check(unsafe { sys::pw85_contains(r12.as_ptr(), q1.as_ptr(), q2.as_ptr(), &mut contains) })?;
    Ok(contains == 1)
}

/// Computes [`contains()`](crate::contains) for many pairs, with the same answers.
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
/// - `contains`: 1, 0, or 255 for a bad pair.
///
/// Row i of each slice belongs to row i of `r12`.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5, 0.0]; 2];
/// let q1 = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let q2 = [[0.25, 0.0, 0.0, 0.25, 0.0, 0.25]; 2];
/// let mut contains = [0; 2];
/// pw85::contains_batch(&r12, &q1, &q2, &mut contains)?;
/// assert_eq!(contains[0], contains[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn contains_batch(
    r12: &[[f64; 3]],
    q1: &[[f64; 6]],
    q2: &[[f64; 6]],
    contains: &mut [u8],
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [("q1", q1.len()), ("q2", q2.len()), ("contains", contains.len())];
    same_rows("pw85_contains_batch", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_contains_batch(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        contains.as_mut_ptr(),
    ) })
}

/// Computes the least factor by which ellipsoid 1 must be scaled about its centre to contain
/// ellipsoid 2, and a point where the two then touch.
///
/// The square of the factor is the largest value of xᵀ q1⁻¹ x over the points x of ellipsoid 2,
/// relative to the centre of ellipsoid 1. It is at most 1 if ellipsoid 2 is inside ellipsoid 1;
/// [`contains()`](crate::contains) decides this exactly.
///
/// The relative error of the square is below 16 u c, with u = 2⁻⁵³. If each entry of r12, q1 and
/// q2 changes by at most a fraction ε of itself, the square changes by at most a fraction ε c, to
/// first order in ε. A lower and an upper bound prove the result.
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipsoid 1 to that of ellipsoid 2; it may be zero. Unit:
///   length.
/// - `q1`, `q2`: Forms of the ellipsoids, in the square of the unit of `r12`. Unit: length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite. `Status::NoConvergence`: the lower
/// and the upper bound do not agree; this has never been seen.
///
/// # Examples
///
/// ```
/// let found = pw85::containment(
///     &[3.0, 0.5, 0.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
///     &[0.25, 0.0, 0.0, 0.25, 0.0, 0.25],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn containment(
    r12: &[f64; 3],
    q1: &[f64; 6],
    q2: &[f64; 6],
) -> Result<ContainmentScale, Error> {
    let mut mu2 = 0.0;
    let mut point = [0.0; 3];
    check(unsafe { sys::pw85_containment(
        r12.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        &mut mu2,
        point.as_mut_ptr(),
    ) })?;
    Ok(ContainmentScale { mu2, point })
}

/// Computes [`containment()`](crate::containment) for many pairs, with bitwise equal results.
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
/// - `point`: Unit: length.
///
/// Row i of each slice belongs to row i of `r12`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5, 0.0]; 2];
/// let q1 = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let q2 = [[0.25, 0.0, 0.0, 0.25, 0.0, 0.25]; 2];
/// let mut mu2 = [0.0; 2];
/// let mut point = [[0.0; 3]; 2];
/// pw85::containment_batch(&r12, &q1, &q2, Some(&mut mu2), Some(&mut point))?;
/// assert_eq!(point[0], point[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn containment_batch(
    r12: &[[f64; 3]],
    q1: &[[f64; 6]],
    q2: &[[f64; 6]],
    mu2: Option<&mut [f64]>,
    point: Option<&mut [[f64; 3]]>,
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("q1", q1.len()),
        ("q2", q2.len()),
        ("mu2", rows_of(&mu2, n)),
        ("point", rows_of(&point, n)),
    ];
    same_rows("pw85_containment_batch", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_containment_batch(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        pointer(mu2),
        pointer(point),
    ) })
}

/// Computes the distance of closest approach of two ellipsoids along a direction.
///
/// This is the distance of the centres at which the ellipsoids touch from outside, if their
/// orientations are fixed and the centres are on a line along d = `direction`. It is \|d\|/μ(d),
/// where μ(d) is μ for r12 = d.
///
/// # Arguments
///
/// - `direction`: From centre 1 to centre 2, of any length; not zero.
/// - `q1`, `q2`: Forms of the ellipsoids. Unit: length².
///
/// # Errors
///
/// A number is not finite, a form is not positive definite or `direction` is zero.
/// `Status::NoConvergence`: as for [`contact()`](crate::contact).
///
/// # Examples
///
/// ```
/// let found = pw85::closest_approach(
///     &[1.0, 0.0, 0.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
///     &[0.25, 0.0, 0.0, 0.25, 0.0, 0.25],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn closest_approach(direction: &[f64; 3], q1: &[f64; 6], q2: &[f64; 6]) -> Result<f64, Error> {
    let mut distance = 0.0;
    check(unsafe { sys::pw85_closest_approach(
        direction.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        &mut distance,
    ) })?;
    Ok(distance)
}

/// Computes [`closest_approach()`](crate::closest_approach) for many pairs.
///
/// The relative error is below 2 u cond + 4 u. The last bits may differ from those of
/// [`closest_approach()`](crate::closest_approach).
///
/// # Arguments
///
/// - `directions`: Not zero.
/// - `q1`, `q2`: Unit: length².
/// - `distance`: Unit: length.
///
/// Row i of each slice belongs to row i of `directions`.
///
/// # Errors
///
/// A slice has not as many rows as `directions`, or a row is refused. The outputs of such rows
/// are NaN, 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let directions = [[1.0, 0.0, 0.0]; 2];
/// let q1 = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let q2 = [[0.25, 0.0, 0.0, 0.25, 0.0, 0.25]; 2];
/// let mut distance = [0.0; 2];
/// pw85::closest_approach_batch(&directions, &q1, &q2, &mut distance)?;
/// assert_eq!(distance[0], distance[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn closest_approach_batch(
    directions: &[[f64; 3]],
    q1: &[[f64; 6]],
    q2: &[[f64; 6]],
    distance: &mut [f64],
) -> Result<(), Error> {
    let n = directions.len();
    let counts = [("q1", q1.len()), ("q2", q2.len()), ("distance", distance.len())];
    same_rows("pw85_closest_approach_batch", "must have as many rows as directions", n, &counts)?;
    check_rows(unsafe { sys::pw85_closest_approach_batch(
        n,
        directions.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        distance.as_mut_ptr(),
    ) })
}

/// Computes the volume of an ellipsoid, (4/3)π √det q.
///
/// The relative error is below 2⁻⁵² for aspect ratios below 10⁷. For a larger aspect ratio k it
/// is below 2⁻⁵² k²/10¹⁴.
///
/// # Arguments
///
/// - `q`: Form of the ellipsoid. Unit: length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite.
///
/// # Examples
///
/// ```
/// let found = pw85::volume(&[9.0, 0.0, 0.0, 4.0, 0.0, 1.0])?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn volume(q: &[f64; 6]) -> Result<f64, Error> {
    let mut volume = 0.0;
    check(unsafe { sys::pw85_volume(q.as_ptr(), &mut volume) })?;
    Ok(volume)
}

/// Computes [`volume()`](crate::volume) for many ellipsoids, with bitwise equal results.
///
/// # Arguments
///
/// - `q`: Unit: length².
/// - `volume`: Unit: length³.
///
/// Row i of each slice belongs to row i of `q`.
///
/// # Errors
///
/// A slice has not as many rows as `q`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let q = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let mut volume = [0.0; 2];
/// pw85::volume_batch(&q, &mut volume)?;
/// assert_eq!(volume[0], volume[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn volume_batch(q: &[[f64; 6]], volume: &mut [f64]) -> Result<(), Error> {
    let n = q.len();
    let counts = [("volume", volume.len())];
    same_rows("pw85_volume_batch", "must have as many rows as q", n, &counts)?;
    check_rows(unsafe { sys::pw85_volume_batch(n, q.as_ptr().cast(), volume.as_mut_ptr()) })
}

/// Computes the volume V of the intersection of two ellipsoids.
///
/// V is 0 if the ellipsoids do not overlap, as [`overlap()`](crate::overlap) decides. V is
/// [`volume()`](crate::volume) of the smaller ellipsoid if it is inside the other one, as
/// [`contains()`](crate::contains) decides. Otherwise the error is below u (64 v + 16 s), with u
/// = 2⁻⁵³ and the volume v of the smaller ellipsoid. The term s is Σ\|r12_i ∂V/∂r12_i\| + Σ
/// √(q1_ii q1_jj) \|∂V/∂q1_ij\| + Σ √(q2_ii q2_jj) \|∂V/∂q2_ij\|, summed over coordinates and
/// stored entries, with the derivatives of
/// [`overlap_volume_gradient()`](crate::overlap_volume_gradient).
///
/// If the intersection is as thin as rounding errors, V may be 0. If the part of the smaller
/// ellipsoid outside the other one is as thin as rounding errors, V may be the volume of the
/// smaller ellipsoid.
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipsoid 1 to that of ellipsoid 2; it may be zero. Unit:
///   length.
/// - `q1`, `q2`: Forms of the ellipsoids, in the square of the unit of `r12`. Unit: length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite. `Status::NoConvergence`: one of
/// three: the linear map that makes the smaller ellipsoid a unit ball makes the other one a disc
/// thinner than 2⁻²¹; the integral does not converge; 32 digits are not enough for the bound on
/// the error, which was seen at aspect ratios above 10⁵.
///
/// # Examples
///
/// ```
/// let found = pw85::overlap_volume(
///     &[3.0, 0.5, 0.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
///     &[0.25, 0.0, 0.0, 0.25, 0.0, 0.25],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn overlap_volume(r12: &[f64; 3], q1: &[f64; 6], q2: &[f64; 6]) -> Result<f64, Error> {
    let mut volume = 0.0;
    check(unsafe { sys::pw85_overlap_volume(
        r12.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        &mut volume,
    ) })?;
    Ok(volume)
}

/// Computes [`overlap_volume()`](crate::overlap_volume) for many pairs, with bitwise equal
/// results.
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
/// - `volume`: Unit: length³.
///
/// Row i of each slice belongs to row i of `r12`.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5, 0.0]; 2];
/// let q1 = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let q2 = [[0.25, 0.0, 0.0, 0.25, 0.0, 0.25]; 2];
/// let mut volume = [0.0; 2];
/// pw85::overlap_volume_batch(&r12, &q1, &q2, &mut volume)?;
/// assert_eq!(volume[0], volume[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn overlap_volume_batch(
    r12: &[[f64; 3]],
    q1: &[[f64; 6]],
    q2: &[[f64; 6]],
    volume: &mut [f64],
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [("q1", q1.len()), ("q2", q2.len()), ("volume", volume.len())];
    same_rows("pw85_overlap_volume_batch", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_overlap_volume_batch(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        volume.as_mut_ptr(),
    ) })
}

/// Computes the derivatives of the volume V of the intersection of two ellipsoids.
///
/// The derivatives are 0 if the ellipsoids do not overlap. If one ellipsoid is inside the other
/// one, V is its volume, and only the derivatives with respect to its form are not 0.
///
/// The error of the derivative with respect to a number p is below u (256 m + 64 s), with u =
/// 2⁻⁵³. The term s is defined as for [`overlap_volume()`](crate::overlap_volume), with ∂V/∂p
/// instead of V. The term m depends on the volume v of the smaller ellipsoid, the inverse P of
/// its form, and the inverse P' of the form to which p belongs. It is v √P_ii for p = r12_i, v
/// √(P_ii P'_ii) for a diagonal entry p of a form, and v (√(P_ii P'_jj) + √(P_jj P'_ii)) for
/// another entry.
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipsoid 1 to that of ellipsoid 2. Unit: length.
/// - `q1`, `q2`: Forms of the ellipsoids, in the square of the unit of `r12`. Unit: length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite. `Status::NoConvergence`: the causes
/// of [`overlap_volume()`](crate::overlap_volume); or the surfaces touch from inside at one
/// point, up to about 10⁻¹⁷ of their size, and cross elsewhere.
///
/// # Examples
///
/// ```
/// let found = pw85::overlap_volume_gradient(
///     &[3.0, 0.5, 0.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
///     &[0.25, 0.0, 0.0, 0.25, 0.0, 0.25],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn overlap_volume_gradient(
    r12: &[f64; 3],
    q1: &[f64; 6],
    q2: &[f64; 6],
) -> Result<OverlapVolumeGradient, Error> {
    let mut d_r12 = [0.0; 3];
    let mut d_q1 = [0.0; 6];
    let mut d_q2 = [0.0; 6];
    check(unsafe { sys::pw85_overlap_volume_gradient(
        r12.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        d_r12.as_mut_ptr(),
        d_q1.as_mut_ptr(),
        d_q2.as_mut_ptr(),
    ) })?;
    Ok(OverlapVolumeGradient { d_r12, d_q1, d_q2 })
}

/// Computes [`overlap_volume_gradient()`](crate::overlap_volume_gradient) for many pairs, with
/// bitwise equal results.
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
/// - `d_r12`: Unit: length².
/// - `d_q1`, `d_q2`: Unit: length.
///
/// Row i of each slice belongs to row i of `r12`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5, 0.0]; 2];
/// let q1 = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let q2 = [[0.25, 0.0, 0.0, 0.25, 0.0, 0.25]; 2];
/// let mut d_r12 = [[0.0; 3]; 2];
/// let mut d_q1 = [[0.0; 6]; 2];
/// let mut d_q2 = [[0.0; 6]; 2];
/// pw85::overlap_volume_gradient_batch(
///     &r12,
///     &q1,
///     &q2,
///     Some(&mut d_r12),
///     Some(&mut d_q1),
///     Some(&mut d_q2),
/// )?;
/// assert_eq!(d_q2[0], d_q2[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn overlap_volume_gradient_batch(
    r12: &[[f64; 3]],
    q1: &[[f64; 6]],
    q2: &[[f64; 6]],
    d_r12: Option<&mut [[f64; 3]]>,
    d_q1: Option<&mut [[f64; 6]]>,
    d_q2: Option<&mut [[f64; 6]]>,
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("q1", q1.len()),
        ("q2", q2.len()),
        ("d_r12", rows_of(&d_r12, n)),
        ("d_q1", rows_of(&d_q1, n)),
        ("d_q2", rows_of(&d_q2, n)),
    ];
    same_rows("pw85_overlap_volume_gradient_batch", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_overlap_volume_gradient_batch(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        pointer(d_r12),
        pointer(d_q1),
        pointer(d_q2),
    ) })
}

/// Computes the derivatives of the volume V of the intersection with respect to rotations of the
/// ellipsoids.
///
/// If an ellipsoid rotates about its own centre by a small rotation vector ω, V changes by
/// d_rot·ω. An energy U(V) exerts the torque -U'(V) d_rot on the ellipsoid. With ∂V/∂r12 from
/// [`overlap_volume_gradient()`](crate::overlap_volume_gradient), d_rot1 + d_rot2 + r12 × ∂V/∂r12
/// = 0.
///
/// The derivatives are the axial vectors of 2 q1 G1 and 2 q2 G2, where G is the matrix of the
/// derivatives ∂V/∂q. Each component is a sum of products 2 q_ij G_jk. The error of a component
/// is below the sum of 2 \|q_ij\| times the bound on the error of G_jk.
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipsoid 1 to that of ellipsoid 2. Unit: length.
/// - `q1`, `q2`: Forms of the ellipsoids, in the square of the unit of `r12`. Unit: length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite. `Status::NoConvergence`: as for
/// [`overlap_volume_gradient()`](crate::overlap_volume_gradient).
///
/// # Examples
///
/// ```
/// let found = pw85::overlap_volume_torque(
///     &[3.0, 0.5, 0.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
///     &[0.25, 0.0, 0.0, 0.25, 0.0, 0.25],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn overlap_volume_torque(
    r12: &[f64; 3],
    q1: &[f64; 6],
    q2: &[f64; 6],
) -> Result<OverlapVolumeTorque, Error> {
    let mut d_rot1 = [0.0; 3];
    let mut d_rot2 = [0.0; 3];
    check(unsafe { sys::pw85_overlap_volume_torque(
        r12.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        d_rot1.as_mut_ptr(),
        d_rot2.as_mut_ptr(),
    ) })?;
    Ok(OverlapVolumeTorque { d_rot1, d_rot2 })
}

/// Computes [`overlap_volume_torque()`](crate::overlap_volume_torque) for many pairs, with
/// bitwise equal results.
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
/// - `d_rot1`, `d_rot2`: Unit: length³.
///
/// Row i of each slice belongs to row i of `r12`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5, 0.0]; 2];
/// let q1 = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let q2 = [[0.25, 0.0, 0.0, 0.25, 0.0, 0.25]; 2];
/// let mut d_rot1 = [[0.0; 3]; 2];
/// let mut d_rot2 = [[0.0; 3]; 2];
/// pw85::overlap_volume_torque_batch(&r12, &q1, &q2, Some(&mut d_rot1), Some(&mut d_rot2))?;
/// assert_eq!(d_rot2[0], d_rot2[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn overlap_volume_torque_batch(
    r12: &[[f64; 3]],
    q1: &[[f64; 6]],
    q2: &[[f64; 6]],
    d_rot1: Option<&mut [[f64; 3]]>,
    d_rot2: Option<&mut [[f64; 3]]>,
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("q1", q1.len()),
        ("q2", q2.len()),
        ("d_rot1", rows_of(&d_rot1, n)),
        ("d_rot2", rows_of(&d_rot2, n)),
    ];
    same_rows("pw85_overlap_volume_torque_batch", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_overlap_volume_torque_batch(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        pointer(d_rot1),
        pointer(d_rot2),
    ) })
}

/// Computes the area of an ellipse, π √det q.
///
/// The bound on the error is that of [`volume()`](crate::volume).
///
/// # Arguments
///
/// - `q`: Form of the ellipse. Unit: length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite.
///
/// # Examples
///
/// ```
/// let found = pw85::area_2d(&[9.0, 0.0, 4.0])?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn area_2d(q: &[f64; 3]) -> Result<f64, Error> {
    let mut area = 0.0;
    check(unsafe { sys::pw85_area_2d(q.as_ptr(), &mut area) })?;
    Ok(area)
}

/// Computes [`area_2d()`](crate::area_2d) for many ellipses, with bitwise equal results.
///
/// # Arguments
///
/// - `q`: Unit: length².
/// - `area`: Unit: length².
///
/// Row i of each slice belongs to row i of `q`.
///
/// # Errors
///
/// A slice has not as many rows as `q`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let q = [[9.0, 0.0, 4.0]; 2];
/// let mut area = [0.0; 2];
/// pw85::area_batch_2d(&q, &mut area)?;
/// assert_eq!(area[0], area[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn area_batch_2d(q: &[[f64; 3]], area: &mut [f64]) -> Result<(), Error> {
    let n = q.len();
    let counts = [("area", area.len())];
    same_rows("pw85_area_batch_2d", "must have as many rows as q", n, &counts)?;
    check_rows(unsafe { sys::pw85_area_batch_2d(n, q.as_ptr().cast(), area.as_mut_ptr()) })
}

/// Computes the area of the intersection of two ellipses; see
/// [`overlap_volume()`](crate::overlap_volume).
///
/// The bound on the error is that of [`overlap_volume()`](crate::overlap_volume), with areas
/// instead of volumes.
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipse 1 to that of ellipse 2; it may be zero. Unit:
///   length.
/// - `q1`, `q2`: Forms (xx, xy, yy) of the ellipses, in the square of the unit of `r12`. Unit:
///   length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite. `Status::NoConvergence`: one of
/// three: the linear map that makes the smaller ellipsoid a unit ball makes the other one a disc
/// thinner than 2⁻²¹; the integral does not converge; 32 digits are not enough for the bound on
/// the error, which was seen at aspect ratios above 10⁵.
///
/// # Examples
///
/// ```
/// let found = pw85::overlap_area_2d(&[3.0, 0.5], &[9.0, 0.0, 4.0], &[0.25, 0.0, 0.25])?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn overlap_area_2d(r12: &[f64; 2], q1: &[f64; 3], q2: &[f64; 3]) -> Result<f64, Error> {
    let mut area = 0.0;
    check(unsafe { sys::pw85_overlap_area_2d(r12.as_ptr(), q1.as_ptr(), q2.as_ptr(), &mut area) })?;
    Ok(area)
}

/// Computes [`overlap_area_2d()`](crate::overlap_area_2d) for many pairs, with bitwise equal
/// results.
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
/// - `area`: Unit: length².
///
/// Row i of each slice belongs to row i of `r12`.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5]; 2];
/// let q1 = [[9.0, 0.0, 4.0]; 2];
/// let q2 = [[0.25, 0.0, 0.25]; 2];
/// let mut area = [0.0; 2];
/// pw85::overlap_area_batch_2d(&r12, &q1, &q2, &mut area)?;
/// assert_eq!(area[0], area[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn overlap_area_batch_2d(
    r12: &[[f64; 2]],
    q1: &[[f64; 3]],
    q2: &[[f64; 3]],
    area: &mut [f64],
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [("q1", q1.len()), ("q2", q2.len()), ("area", area.len())];
    same_rows("pw85_overlap_area_batch_2d", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_overlap_area_batch_2d(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        area.as_mut_ptr(),
    ) })
}

/// Computes the derivatives of the area of the intersection of two ellipses; see
/// [`overlap_volume_gradient()`](crate::overlap_volume_gradient).
///
/// The bounds on the errors are those of
/// [`overlap_volume_gradient()`](crate::overlap_volume_gradient), with areas instead of volumes.
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipse 1 to that of ellipse 2. Unit: length.
/// - `q1`, `q2`: Forms (xx, xy, yy) of the ellipses, in the square of the unit of `r12`. Unit:
///   length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite. `Status::NoConvergence`: the causes
/// of [`overlap_volume()`](crate::overlap_volume); or the surfaces touch from inside at one
/// point, up to about 10⁻¹⁷ of their size, and cross elsewhere.
///
/// # Examples
///
/// ```
/// let found = pw85::overlap_area_gradient_2d(&[3.0, 0.5], &[9.0, 0.0, 4.0], &[0.25, 0.0, 0.25])?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn overlap_area_gradient_2d(
    r12: &[f64; 2],
    q1: &[f64; 3],
    q2: &[f64; 3],
) -> Result<OverlapAreaGradient, Error> {
    let mut d_r12 = [0.0; 2];
    let mut d_q1 = [0.0; 3];
    let mut d_q2 = [0.0; 3];
    check(unsafe { sys::pw85_overlap_area_gradient_2d(
        r12.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        d_r12.as_mut_ptr(),
        d_q1.as_mut_ptr(),
        d_q2.as_mut_ptr(),
    ) })?;
    Ok(OverlapAreaGradient { d_r12, d_q1, d_q2 })
}

/// Computes [`overlap_area_gradient_2d()`](crate::overlap_area_gradient_2d) for many pairs, with
/// bitwise equal results.
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
/// - `d_r12`: Unit: length.
/// - `d_q1`, `d_q2`: Unit: no unit.
///
/// Row i of each slice belongs to row i of `r12`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5]; 2];
/// let q1 = [[9.0, 0.0, 4.0]; 2];
/// let q2 = [[0.25, 0.0, 0.25]; 2];
/// let mut d_r12 = [[0.0; 2]; 2];
/// let mut d_q1 = [[0.0; 3]; 2];
/// let mut d_q2 = [[0.0; 3]; 2];
/// pw85::overlap_area_gradient_batch_2d(
///     &r12,
///     &q1,
///     &q2,
///     Some(&mut d_r12),
///     Some(&mut d_q1),
///     Some(&mut d_q2),
/// )?;
/// assert_eq!(d_q2[0], d_q2[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn overlap_area_gradient_batch_2d(
    r12: &[[f64; 2]],
    q1: &[[f64; 3]],
    q2: &[[f64; 3]],
    d_r12: Option<&mut [[f64; 2]]>,
    d_q1: Option<&mut [[f64; 3]]>,
    d_q2: Option<&mut [[f64; 3]]>,
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("q1", q1.len()),
        ("q2", q2.len()),
        ("d_r12", rows_of(&d_r12, n)),
        ("d_q1", rows_of(&d_q1, n)),
        ("d_q2", rows_of(&d_q2, n)),
    ];
    same_rows("pw85_overlap_area_gradient_batch_2d", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_overlap_area_gradient_batch_2d(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        pointer(d_r12),
        pointer(d_q1),
        pointer(d_q2),
    ) })
}

/// Computes the derivatives of the area of the intersection with respect to the angles of both
/// ellipses.
///
/// See [`overlap_volume_torque()`](crate::overlap_volume_torque). Angles are counter-clockwise.
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipse 1 to that of ellipse 2. Unit: length.
/// - `q1`, `q2`: Forms (xx, xy, yy) of the ellipses, in the square of the unit of `r12`. Unit:
///   length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite. `Status::NoConvergence`: as for
/// [`overlap_volume_gradient()`](crate::overlap_volume_gradient).
///
/// # Examples
///
/// ```
/// let found = pw85::overlap_area_torque_2d(&[3.0, 0.5], &[9.0, 0.0, 4.0], &[0.25, 0.0, 0.25])?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn overlap_area_torque_2d(
    r12: &[f64; 2],
    q1: &[f64; 3],
    q2: &[f64; 3],
) -> Result<OverlapAreaTorque, Error> {
    let mut d_rot1 = 0.0;
    let mut d_rot2 = 0.0;
    check(unsafe { sys::pw85_overlap_area_torque_2d(
        r12.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        &mut d_rot1,
        &mut d_rot2,
    ) })?;
    Ok(OverlapAreaTorque { d_rot1, d_rot2 })
}

/// Computes [`overlap_area_torque_2d()`](crate::overlap_area_torque_2d) for many pairs, with
/// bitwise equal results.
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
/// - `d_rot1`, `d_rot2`: Unit: length².
///
/// Row i of each slice belongs to row i of `r12`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5]; 2];
/// let q1 = [[9.0, 0.0, 4.0]; 2];
/// let q2 = [[0.25, 0.0, 0.25]; 2];
/// let mut d_rot1 = [0.0; 2];
/// let mut d_rot2 = [0.0; 2];
/// pw85::overlap_area_torque_batch_2d(&r12, &q1, &q2, Some(&mut d_rot1), Some(&mut d_rot2))?;
/// assert_eq!(d_rot2[0], d_rot2[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn overlap_area_torque_batch_2d(
    r12: &[[f64; 2]],
    q1: &[[f64; 3]],
    q2: &[[f64; 3]],
    d_rot1: Option<&mut [f64]>,
    d_rot2: Option<&mut [f64]>,
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("q1", q1.len()),
        ("q2", q2.len()),
        ("d_rot1", rows_of(&d_rot1, n)),
        ("d_rot2", rows_of(&d_rot2, n)),
    ];
    same_rows("pw85_overlap_area_torque_batch_2d", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_overlap_area_torque_batch_2d(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        pointer(d_rot1),
        pointer(d_rot2),
    ) })
}

/// Computes the contact function of two ellipses; see [`contact()`](crate::contact).
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipse 1 to that of ellipse 2; it may be zero: then μ² = 0
///   and λ = 1/2. Unit: length.
/// - `q1`, `q2`: Forms (xx, xy, yy) of the ellipses, in the square of the unit of `r12`. Unit:
///   length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite. `Status::NoConvergence`: the bound
/// on the error cannot be proved; this has never been seen.
///
/// # Examples
///
/// ```
/// let found = pw85::contact_2d(&[3.0, 0.5], &[9.0, 0.0, 4.0], &[0.25, 0.0, 0.25])?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn contact_2d(r12: &[f64; 2], q1: &[f64; 3], q2: &[f64; 3]) -> Result<Contact, Error> {
    let mut out = [0.0; 2];
    check(unsafe { sys::pw85_contact_2d(
        r12.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        out.as_mut_ptr(),
    ) })?;
    Ok(Contact { mu2: out[0], lambda: out[1] })
}

/// Computes [`contact_2d()`](crate::contact_2d) for many pairs; see
/// [`contact_batch()`](crate::contact_batch).
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
///
/// Row i of each slice belongs to row i of `r12`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5]; 2];
/// let q1 = [[9.0, 0.0, 4.0]; 2];
/// let q2 = [[0.25, 0.0, 0.25]; 2];
/// let mut mu2 = [0.0; 2];
/// let mut lambda = [0.0; 2];
/// pw85::contact_batch_2d(&r12, &q1, &q2, &mut mu2, Some(&mut lambda))?;
/// assert_eq!(lambda[0], lambda[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn contact_batch_2d(
    r12: &[[f64; 2]],
    q1: &[[f64; 3]],
    q2: &[[f64; 3]],
    mu2: &mut [f64],
    lambda: Option<&mut [f64]>,
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("q1", q1.len()),
        ("q2", q2.len()),
        ("mu2", mu2.len()),
        ("lambda", rows_of(&lambda, n)),
    ];
    same_rows("pw85_contact_batch_2d", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_contact_batch_2d(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        mu2.as_mut_ptr(),
        pointer(lambda),
    ) })
}

/// Computes the point at which the ellipses, scaled by μ, touch, and their common normal there.
///
/// See [`contact_geometry()`](crate::contact_geometry).
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipse 1 to that of ellipse 2; not zero. Unit: length.
/// - `q1`, `q2`: Forms (xx, xy, yy) of the ellipses, in the square of the unit of `r12`. Unit:
///   length².
/// - `lambda`: The maximiser λ of f, from [`contact_2d()`](crate::contact_2d). For another λ in
///   \[0, 1\] the point is x0(λ) of the chapter on theory. It is on the surface of ellipse 1
///   scaled by μ1, and on that of ellipse 2 scaled by μ2, where f(λ) = λ μ1² + (1-λ) μ2².
///
/// # Errors
///
/// A number is not finite, a form is not positive definite, `r12` is zero or λ is not in \[0,
/// 1\].
///
/// # Examples
///
/// ```
/// let found = pw85::contact_geometry_2d(&[3.0, 0.5], &[9.0, 0.0, 4.0], &[0.25, 0.0, 0.25], 0.5)?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn contact_geometry_2d(
    r12: &[f64; 2],
    q1: &[f64; 3],
    q2: &[f64; 3],
    lambda: f64,
) -> Result<ContactGeometry2d, Error> {
    let mut point = [0.0; 2];
    let mut normal = [0.0; 2];
    check(unsafe { sys::pw85_contact_geometry_2d(
        r12.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        lambda,
        point.as_mut_ptr(),
        normal.as_mut_ptr(),
    ) })?;
    Ok(ContactGeometry2d { point, normal })
}

/// Computes [`contact_geometry_2d()`](crate::contact_geometry_2d) for many pairs, with bitwise
/// equal results.
///
/// # Arguments
///
/// - `r12`: Not zero. Unit: length.
/// - `q1`, `q2`: Unit: length².
/// - `point`: Unit: length.
///
/// Row i of each slice belongs to row i of `r12`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5]; 2];
/// let q1 = [[9.0, 0.0, 4.0]; 2];
/// let q2 = [[0.25, 0.0, 0.25]; 2];
/// let lambda = [0.5; 2];
/// let mut point = [[0.0; 2]; 2];
/// let mut normal = [[0.0; 2]; 2];
/// pw85::contact_geometry_batch_2d(&r12, &q1, &q2, &lambda, Some(&mut point), Some(&mut normal))?;
/// assert_eq!(normal[0], normal[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn contact_geometry_batch_2d(
    r12: &[[f64; 2]],
    q1: &[[f64; 3]],
    q2: &[[f64; 3]],
    lambda: &[f64],
    point: Option<&mut [[f64; 2]]>,
    normal: Option<&mut [[f64; 2]]>,
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("q1", q1.len()),
        ("q2", q2.len()),
        ("lambda", lambda.len()),
        ("point", rows_of(&point, n)),
        ("normal", rows_of(&normal, n)),
    ];
    same_rows("pw85_contact_geometry_batch_2d", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_contact_geometry_batch_2d(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        lambda.as_ptr(),
        pointer(point),
        pointer(normal),
    ) })
}

/// Computes the derivatives of μ² of two ellipses; see
/// [`contact_gradient()`](crate::contact_gradient).
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipse 1 to that of ellipse 2. Unit: length.
/// - `q1`, `q2`: Forms (xx, xy, yy) of the ellipses, in the square of the unit of `r12`. Unit:
///   length².
/// - `lambda`: The maximiser λ of f, from [`contact_2d()`](crate::contact_2d).
///
/// # Errors
///
/// A number is not finite, a form is not positive definite or λ is not in \[0, 1\].
///
/// # Examples
///
/// ```
/// let found = pw85::contact_gradient_2d(&[3.0, 0.5], &[9.0, 0.0, 4.0], &[0.25, 0.0, 0.25], 0.5)?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn contact_gradient_2d(
    r12: &[f64; 2],
    q1: &[f64; 3],
    q2: &[f64; 3],
    lambda: f64,
) -> Result<ContactGradient2d, Error> {
    let mut d_r12 = [0.0; 2];
    let mut d_q1 = [0.0; 3];
    let mut d_q2 = [0.0; 3];
    check(unsafe { sys::pw85_contact_gradient_2d(
        r12.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        lambda,
        d_r12.as_mut_ptr(),
        d_q1.as_mut_ptr(),
        d_q2.as_mut_ptr(),
    ) })?;
    Ok(ContactGradient2d { d_r12, d_q1, d_q2 })
}

/// Computes [`contact_gradient_2d()`](crate::contact_gradient_2d) for many pairs, with bitwise
/// equal results.
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
/// - `d_r12`: Unit: 1/length.
/// - `d_q1`, `d_q2`: Unit: 1/length².
///
/// Row i of each slice belongs to row i of `r12`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5]; 2];
/// let q1 = [[9.0, 0.0, 4.0]; 2];
/// let q2 = [[0.25, 0.0, 0.25]; 2];
/// let lambda = [0.5; 2];
/// let mut d_r12 = [[0.0; 2]; 2];
/// let mut d_q1 = [[0.0; 3]; 2];
/// let mut d_q2 = [[0.0; 3]; 2];
/// pw85::contact_gradient_batch_2d(
///     &r12,
///     &q1,
///     &q2,
///     &lambda,
///     Some(&mut d_r12),
///     Some(&mut d_q1),
///     Some(&mut d_q2),
/// )?;
/// assert_eq!(d_q2[0], d_q2[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn contact_gradient_batch_2d(
    r12: &[[f64; 2]],
    q1: &[[f64; 3]],
    q2: &[[f64; 3]],
    lambda: &[f64],
    d_r12: Option<&mut [[f64; 2]]>,
    d_q1: Option<&mut [[f64; 3]]>,
    d_q2: Option<&mut [[f64; 3]]>,
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("q1", q1.len()),
        ("q2", q2.len()),
        ("lambda", lambda.len()),
        ("d_r12", rows_of(&d_r12, n)),
        ("d_q1", rows_of(&d_q1, n)),
        ("d_q2", rows_of(&d_q2, n)),
    ];
    same_rows("pw85_contact_gradient_batch_2d", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_contact_gradient_batch_2d(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        lambda.as_ptr(),
        pointer(d_r12),
        pointer(d_q1),
        pointer(d_q2),
    ) })
}

/// Computes the derivatives of μ² with respect to the angles of two ellipses; see
/// [`contact_torque()`](crate::contact_torque).
///
/// Angles are counter-clockwise.
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipse 1 to that of ellipse 2. Unit: length.
/// - `q1`, `q2`: Forms (xx, xy, yy) of the ellipses, in the square of the unit of `r12`. Unit:
///   length².
/// - `lambda`: The maximiser λ of f, from [`contact_2d()`](crate::contact_2d).
///
/// # Errors
///
/// A number is not finite, a form is not positive definite or λ is not in \[0, 1\].
///
/// # Examples
///
/// ```
/// let found = pw85::contact_torque_2d(&[3.0, 0.5], &[9.0, 0.0, 4.0], &[0.25, 0.0, 0.25], 0.5)?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn contact_torque_2d(
    r12: &[f64; 2],
    q1: &[f64; 3],
    q2: &[f64; 3],
    lambda: f64,
) -> Result<ContactTorque2d, Error> {
    let mut d_rot1 = 0.0;
    let mut d_rot2 = 0.0;
    check(unsafe { sys::pw85_contact_torque_2d(
        r12.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        lambda,
        &mut d_rot1,
        &mut d_rot2,
    ) })?;
    Ok(ContactTorque2d { d_rot1, d_rot2 })
}

/// Computes [`contact_torque_2d()`](crate::contact_torque_2d) for many pairs, with bitwise equal
/// results.
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
///
/// Row i of each slice belongs to row i of `r12`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5]; 2];
/// let q1 = [[9.0, 0.0, 4.0]; 2];
/// let q2 = [[0.25, 0.0, 0.25]; 2];
/// let lambda = [0.5; 2];
/// let mut d_rot1 = [0.0; 2];
/// let mut d_rot2 = [0.0; 2];
/// pw85::contact_torque_batch_2d(&r12, &q1, &q2, &lambda, Some(&mut d_rot1), Some(&mut d_rot2))?;
/// assert_eq!(d_rot2[0], d_rot2[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn contact_torque_batch_2d(
    r12: &[[f64; 2]],
    q1: &[[f64; 3]],
    q2: &[[f64; 3]],
    lambda: &[f64],
    d_rot1: Option<&mut [f64]>,
    d_rot2: Option<&mut [f64]>,
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("q1", q1.len()),
        ("q2", q2.len()),
        ("lambda", lambda.len()),
        ("d_rot1", rows_of(&d_rot1, n)),
        ("d_rot2", rows_of(&d_rot2, n)),
    ];
    same_rows("pw85_contact_torque_batch_2d", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_contact_torque_batch_2d(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        lambda.as_ptr(),
        pointer(d_rot1),
        pointer(d_rot2),
    ) })
}

/// Computes the second derivatives of μ² of two ellipses; see
/// [`contact_hessian()`](crate::contact_hessian).
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipse 1 to that of ellipse 2; not zero. Unit: length.
/// - `q1`, `q2`: Forms (xx, xy, yy) of the ellipses, in the square of the unit of `r12`. Unit:
///   length².
/// - `lambda`: The maximiser λ of f, from [`contact_2d()`](crate::contact_2d).
///
/// # Errors
///
/// A number is not finite, a form is not positive definite, `r12` is zero or λ is not in \[0,
/// 1\].
///
/// # Examples
///
/// ```
/// let found = pw85::contact_hessian_2d(&[3.0, 0.5], &[9.0, 0.0, 4.0], &[0.25, 0.0, 0.25], 0.5)?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn contact_hessian_2d(
    r12: &[f64; 2],
    q1: &[f64; 3],
    q2: &[f64; 3],
    lambda: f64,
) -> Result<[[f64; 4]; 4], Error> {
    let mut hessian = [[0.0; 4]; 4];
    check(unsafe { sys::pw85_contact_hessian_2d(
        r12.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        lambda,
        hessian.as_mut_ptr().cast(),
    ) })?;
    Ok(hessian)
}

/// Computes [`contact_hessian_2d()`](crate::contact_hessian_2d) for many pairs, with bitwise
/// equal results.
///
/// # Arguments
///
/// - `r12`: Not zero. Unit: length.
/// - `q1`, `q2`: Unit: length².
/// - `hessian`: Unit: mixed units.
///
/// Row i of each slice belongs to row i of `r12`.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5]; 2];
/// let q1 = [[9.0, 0.0, 4.0]; 2];
/// let q2 = [[0.25, 0.0, 0.25]; 2];
/// let lambda = [0.5; 2];
/// let mut hessian = [[[0.0; 4]; 4]; 2];
/// pw85::contact_hessian_batch_2d(&r12, &q1, &q2, &lambda, &mut hessian)?;
/// assert_eq!(hessian[0], hessian[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn contact_hessian_batch_2d(
    r12: &[[f64; 2]],
    q1: &[[f64; 3]],
    q2: &[[f64; 3]],
    lambda: &[f64],
    hessian: &mut [[[f64; 4]; 4]],
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("q1", q1.len()),
        ("q2", q2.len()),
        ("lambda", lambda.len()),
        ("hessian", hessian.len()),
    ];
    same_rows("pw85_contact_hessian_batch_2d", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_contact_hessian_batch_2d(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        lambda.as_ptr(),
        hessian.as_mut_ptr().cast(),
    ) })
}

/// Tests whether two ellipses overlap; see [`overlap()`](crate::overlap).
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipse 1 to that of ellipse 2; zero is an overlap. Unit:
///   length.
/// - `q1`, `q2`: Forms (xx, xy, yy) of the ellipses, in the square of the unit of `r12`. Unit:
///   length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite.
///
/// # Examples
///
/// ```
/// let found = pw85::overlap_2d(&[3.0, 0.5], &[9.0, 0.0, 4.0], &[0.25, 0.0, 0.25])?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn overlap_2d(r12: &[f64; 2], q1: &[f64; 3], q2: &[f64; 3]) -> Result<bool, Error> {
    let mut overlap = 0;
    check(unsafe { sys::pw85_overlap_2d(r12.as_ptr(), q1.as_ptr(), q2.as_ptr(), &mut overlap) })?;
    Ok(overlap == 1)
}

/// Computes [`overlap_2d()`](crate::overlap_2d) for many pairs; see
/// [`overlap_batch()`](crate::overlap_batch).
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
/// - `overlap`: 1, 0, or 255 for a bad pair.
///
/// Row i of each slice belongs to row i of `r12`.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5]; 2];
/// let q1 = [[9.0, 0.0, 4.0]; 2];
/// let q2 = [[0.25, 0.0, 0.25]; 2];
/// let mut overlap = [0; 2];
/// pw85::overlap_batch_2d(&r12, &q1, &q2, &mut overlap)?;
/// assert_eq!(overlap[0], overlap[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn overlap_batch_2d(
    r12: &[[f64; 2]],
    q1: &[[f64; 3]],
    q2: &[[f64; 3]],
    overlap: &mut [u8],
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [("q1", q1.len()), ("q2", q2.len()), ("overlap", overlap.len())];
    same_rows("pw85_overlap_batch_2d", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_overlap_batch_2d(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        overlap.as_mut_ptr(),
    ) })
}

/// Tests whether ellipse 2 is inside ellipse 1; see [`contains()`](crate::contains).
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipse 1 to that of ellipse 2. Unit: length.
/// - `q1`, `q2`: Forms (xx, xy, yy) of the ellipses, in the square of the unit of `r12`. Unit:
///   length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite.
///
/// # Examples
///
/// ```
/// let found = pw85::contains_2d(&[3.0, 0.5], &[9.0, 0.0, 4.0], &[0.25, 0.0, 0.25])?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn contains_2d(r12: &[f64; 2], q1: &[f64; 3], q2: &[f64; 3]) -> Result<bool, Error> {
    let mut contains = 0;
    check(unsafe { sys::pw85_contains_2d(r12.as_ptr(), q1.as_ptr(), q2.as_ptr(), &mut contains) })?;
    Ok(contains == 1)
}

/// Computes the least factor by which ellipse 1 must be scaled to contain ellipse 2; see
/// [`containment()`](crate::containment).
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipse 1 to that of ellipse 2; it may be zero. Unit:
///   length.
/// - `q1`, `q2`: Forms (xx, xy, yy) of the ellipses, in the square of the unit of `r12`. Unit:
///   length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite. `Status::NoConvergence`: the lower
/// and the upper bound do not agree; this has never been seen.
///
/// # Examples
///
/// ```
/// let found = pw85::containment_2d(&[3.0, 0.5], &[9.0, 0.0, 4.0], &[0.25, 0.0, 0.25])?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn containment_2d(
    r12: &[f64; 2],
    q1: &[f64; 3],
    q2: &[f64; 3],
) -> Result<ContainmentScale2d, Error> {
    let mut mu2 = 0.0;
    let mut point = [0.0; 2];
    check(unsafe { sys::pw85_containment_2d(
        r12.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        &mut mu2,
        point.as_mut_ptr(),
    ) })?;
    Ok(ContainmentScale2d { mu2, point })
}

/// Computes the distance of closest approach of two ellipses; see
/// [`closest_approach()`](crate::closest_approach).
///
/// # Arguments
///
/// - `direction`: From centre 1 to centre 2, of any length; not zero.
/// - `q1`, `q2`: Forms (xx, xy, yy) of the ellipses. Unit: length².
///
/// # Errors
///
/// A number is not finite, a form is not positive definite or `direction` is zero.
/// `Status::NoConvergence`: as for [`contact()`](crate::contact).
///
/// # Examples
///
/// ```
/// let found = pw85::closest_approach_2d(&[1.0, 0.0], &[9.0, 0.0, 4.0], &[0.25, 0.0, 0.25])?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn closest_approach_2d(
    direction: &[f64; 2],
    q1: &[f64; 3],
    q2: &[f64; 3],
) -> Result<f64, Error> {
    let mut distance = 0.0;
    check(unsafe { sys::pw85_closest_approach_2d(
        direction.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        &mut distance,
    ) })?;
    Ok(distance)
}

/// Computes [`closest_approach_2d()`](crate::closest_approach_2d) for many pairs, with bitwise
/// equal results.
///
/// # Arguments
///
/// - `directions`: Not zero.
/// - `q1`, `q2`: Unit: length².
/// - `distance`: Unit: length.
///
/// Row i of each slice belongs to row i of `directions`.
///
/// # Errors
///
/// A slice has not as many rows as `directions`, or a row is refused. The outputs of such rows
/// are NaN, 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let directions = [[1.0, 0.0]; 2];
/// let q1 = [[9.0, 0.0, 4.0]; 2];
/// let q2 = [[0.25, 0.0, 0.25]; 2];
/// let mut distance = [0.0; 2];
/// pw85::closest_approach_batch_2d(&directions, &q1, &q2, &mut distance)?;
/// assert_eq!(distance[0], distance[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn closest_approach_batch_2d(
    directions: &[[f64; 2]],
    q1: &[[f64; 3]],
    q2: &[[f64; 3]],
    distance: &mut [f64],
) -> Result<(), Error> {
    let n = directions.len();
    let counts = [("q1", q1.len()), ("q2", q2.len()), ("distance", distance.len())];
    same_rows("pw85_closest_approach_batch_2d", "must have as many rows as directions", n, &counts)?;
    check_rows(unsafe { sys::pw85_closest_approach_batch_2d(
        n,
        directions.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        distance.as_mut_ptr(),
    ) })
}

/// Computes the distance of the surfaces of two ellipsoids, and the points where they are
/// closest.
///
/// The distance is the largest value of n·r12 - α - β over unit vectors n, with the half-widths α
/// and β of the ellipsoids along n. Its error is below 8 u Σ, with u = 2⁻⁵³. Here Σ = Σ\|n_i
/// r12_i\| + Σ\|n_i q1_ij n_j\|/(2α) + Σ\|n_i q2_ij n_j\|/(2β), summed over all i and j, with n,
/// α and β at the closest points. Rounding the data entry by entry can change the distance by u
/// Σ.
///
/// A program can verify the result by a lower and an upper bound. For any unit vector n, n·r12 -
/// α - β is a lower bound of the distance; `distance` is this bound for the normal of
/// [`distance_derivatives()`](crate::distance_derivatives). The distance between any point of
/// ellipsoid 1 and any point of ellipsoid 2 is an upper bound, such as \|point2 - point1\|.
///
/// Let ε = 2¹⁸ u (\|r12\| + \|point1\| + \|r12 - point2\|). The vector point2 - point1 differs
/// from `distance` times n by less than ε, and the length of this vector differs from `distance`
/// by at most ε. The points are the exact closest points for a pair whose r12 differs by at most
/// ε. Each point is off its surface by less than 2¹⁸ u times the longest semi-axis of its
/// ellipsoid, plus the rounding error u \|point2\| of its coordinates.
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipsoid 1 to that of ellipsoid 2. Unit: length.
/// - `q1`, `q2`: Forms of the ellipsoids, in the square of the unit of `r12`. Unit: length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite. `Status::NoConvergence`: the error
/// bound cannot be proved with 384 binary digits; not seen up to aspect ratio 2¹⁰⁰.
///
/// # Examples
///
/// ```
/// let found = pw85::distance(
///     &[5.0, 0.5, 0.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
///     &[0.25, 0.0, 0.0, 0.25, 0.0, 0.25],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn distance(r12: &[f64; 3], q1: &[f64; 6], q2: &[f64; 6]) -> Result<Distance, Error> {
    let mut distance = 0.0;
    let mut point1 = [0.0; 3];
    let mut point2 = [0.0; 3];
    check(unsafe { sys::pw85_distance(
        r12.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        &mut distance,
        point1.as_mut_ptr(),
        point2.as_mut_ptr(),
    ) })?;
    Ok(Distance { distance, point1, point2 })
}

/// Computes [`distance()`](crate::distance) for many pairs.
///
/// Points of pairs that overlap are NaN.
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
/// - `distance`: Unit: length.
/// - `point1`, `point2`: Unit: length.
///
/// Row i of each slice belongs to row i of `r12`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[5.0, 0.5, 0.0]; 2];
/// let q1 = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let q2 = [[0.25, 0.0, 0.0, 0.25, 0.0, 0.25]; 2];
/// let mut distance = [0.0; 2];
/// let mut point1 = [[0.0; 3]; 2];
/// let mut point2 = [[0.0; 3]; 2];
/// pw85::distance_batch(&r12, &q1, &q2, Some(&mut distance), Some(&mut point1), Some(&mut point2))?;
/// assert_eq!(point2[0], point2[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn distance_batch(
    r12: &[[f64; 3]],
    q1: &[[f64; 6]],
    q2: &[[f64; 6]],
    distance: Option<&mut [f64]>,
    point1: Option<&mut [[f64; 3]]>,
    point2: Option<&mut [[f64; 3]]>,
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("q1", q1.len()),
        ("q2", q2.len()),
        ("distance", rows_of(&distance, n)),
        ("point1", rows_of(&point1, n)),
        ("point2", rows_of(&point2, n)),
    ];
    same_rows("pw85_distance_batch", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_distance_batch(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        pointer(distance),
        pointer(point1),
        pointer(point2),
    ) })
}

/// Computes the distance of two ellipsoids, as [`distance()`](crate::distance) does, with the
/// closest points and the normal there.
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipsoid 1 to that of ellipsoid 2. Unit: length.
/// - `q1`, `q2`: Forms of the ellipsoids, in the square of the unit of `r12`. Unit: length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite. `Status::NoConvergence`: as for
/// [`distance()`](crate::distance).
///
/// # Examples
///
/// ```
/// let found = pw85::distance_geometry(
///     &[5.0, 0.5, 0.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
///     &[0.25, 0.0, 0.0, 0.25, 0.0, 0.25],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn distance_geometry(
    r12: &[f64; 3],
    q1: &[f64; 6],
    q2: &[f64; 6],
) -> Result<DistanceGeometry, Error> {
    let mut distance = 0.0;
    let mut point1 = [0.0; 3];
    let mut point2 = [0.0; 3];
    let mut normal = [0.0; 3];
    check(unsafe { sys::pw85_distance_geometry(
        r12.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        &mut distance,
        point1.as_mut_ptr(),
        point2.as_mut_ptr(),
        normal.as_mut_ptr(),
    ) })?;
    Ok(DistanceGeometry { distance, point1, point2, normal })
}

/// Computes [`distance_geometry()`](crate::distance_geometry) for many pairs.
///
/// Points and normals of pairs that overlap are NaN.
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
/// - `distance`: Unit: length.
/// - `point1`, `point2`: Unit: length.
///
/// Row i of each slice belongs to row i of `r12`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[5.0, 0.5, 0.0]; 2];
/// let q1 = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let q2 = [[0.25, 0.0, 0.0, 0.25, 0.0, 0.25]; 2];
/// let mut distance = [0.0; 2];
/// let mut point1 = [[0.0; 3]; 2];
/// let mut point2 = [[0.0; 3]; 2];
/// let mut normal = [[0.0; 3]; 2];
/// pw85::distance_geometry_batch(
///     &r12,
///     &q1,
///     &q2,
///     Some(&mut distance),
///     Some(&mut point1),
///     Some(&mut point2),
///     Some(&mut normal),
/// )?;
/// assert_eq!(normal[0], normal[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn distance_geometry_batch(
    r12: &[[f64; 3]],
    q1: &[[f64; 6]],
    q2: &[[f64; 6]],
    distance: Option<&mut [f64]>,
    point1: Option<&mut [[f64; 3]]>,
    point2: Option<&mut [[f64; 3]]>,
    normal: Option<&mut [[f64; 3]]>,
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("q1", q1.len()),
        ("q2", q2.len()),
        ("distance", rows_of(&distance, n)),
        ("point1", rows_of(&point1, n)),
        ("point2", rows_of(&point2, n)),
        ("normal", rows_of(&normal, n)),
    ];
    same_rows("pw85_distance_geometry_batch", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_distance_geometry_batch(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        pointer(distance),
        pointer(point1),
        pointer(point2),
        pointer(normal),
    ) })
}

/// Computes the derivatives of the distance of two ellipsoids.
///
/// The derivatives are NaN if the ellipsoids overlap.
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipsoid 1 to that of ellipsoid 2. Unit: length.
/// - `q1`, `q2`: Forms of the ellipsoids, in the square of the unit of `r12`. Unit: length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite. `Status::NoConvergence`: as for
/// [`distance()`](crate::distance).
///
/// # Examples
///
/// ```
/// let found = pw85::distance_derivatives(
///     &[5.0, 0.5, 0.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
///     &[0.25, 0.0, 0.0, 0.25, 0.0, 0.25],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn distance_derivatives(
    r12: &[f64; 3],
    q1: &[f64; 6],
    q2: &[f64; 6],
) -> Result<DistanceDerivatives, Error> {
    let mut d_r12 = [0.0; 3];
    let mut d_rot1 = [0.0; 3];
    let mut d_rot2 = [0.0; 3];
    let mut hessian = [[0.0; 9]; 9];
    check(unsafe { sys::pw85_distance_derivatives(
        r12.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        d_r12.as_mut_ptr(),
        d_rot1.as_mut_ptr(),
        d_rot2.as_mut_ptr(),
        hessian.as_mut_ptr().cast(),
    ) })?;
    Ok(DistanceDerivatives { d_r12, d_rot1, d_rot2, hessian })
}

/// Computes [`distance_derivatives()`](crate::distance_derivatives) for many pairs, with bitwise
/// equal results.
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
/// - `d_rot1`, `d_rot2`: Unit: length.
/// - `hessian`: Unit: mixed units.
///
/// Row i of each slice belongs to row i of `r12`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[5.0, 0.5, 0.0]; 2];
/// let q1 = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let q2 = [[0.25, 0.0, 0.0, 0.25, 0.0, 0.25]; 2];
/// let mut d_r12 = [[0.0; 3]; 2];
/// let mut d_rot1 = [[0.0; 3]; 2];
/// let mut d_rot2 = [[0.0; 3]; 2];
/// let mut hessian = [[[0.0; 9]; 9]; 2];
/// pw85::distance_derivatives_batch(
///     &r12,
///     &q1,
///     &q2,
///     Some(&mut d_r12),
///     Some(&mut d_rot1),
///     Some(&mut d_rot2),
///     Some(&mut hessian),
/// )?;
/// assert_eq!(hessian[0], hessian[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn distance_derivatives_batch(
    r12: &[[f64; 3]],
    q1: &[[f64; 6]],
    q2: &[[f64; 6]],
    d_r12: Option<&mut [[f64; 3]]>,
    d_rot1: Option<&mut [[f64; 3]]>,
    d_rot2: Option<&mut [[f64; 3]]>,
    hessian: Option<&mut [[[f64; 9]; 9]]>,
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("q1", q1.len()),
        ("q2", q2.len()),
        ("d_r12", rows_of(&d_r12, n)),
        ("d_rot1", rows_of(&d_rot1, n)),
        ("d_rot2", rows_of(&d_rot2, n)),
        ("hessian", rows_of(&hessian, n)),
    ];
    same_rows("pw85_distance_derivatives_batch", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_distance_derivatives_batch(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        pointer(d_r12),
        pointer(d_rot1),
        pointer(d_rot2),
        pointer(hessian),
    ) })
}

/// Computes the penetration depth of two ellipsoids that overlap, and its direction.
///
/// The depth is the length of the shortest translation of ellipsoid 2 that separates them.
///
/// The depth is the smallest value of α + β - n·r12 over unit vectors n, with the half-widths α
/// and β of the ellipsoids along n. This function of n may have several local minima. The library
/// proves that its result is the global minimum. If several directions give the same value, the
/// result is one of them.
///
/// `depth` is the value of α + β - n·r12 for the returned direction n. Its error is below 8 u Σ,
/// with u = 2⁻⁵³ and Σ as for [`distance()`](crate::distance). No other direction has a value
/// that is smaller by more than 32 u Σ, where Σ is the larger one of the two directions.
///
/// For more than 90 % of random pairs a simple sufficient condition proves the minimum, and the
/// time is 3 to 8 times that of [`contact()`](crate::contact). For the other pairs the time is 10
/// to 60 times that of [`contact()`](crate::contact), and about 1000 times if the minimum is not
/// isolated.
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipsoid 1 to that of ellipsoid 2. Unit: length.
/// - `q1`, `q2`: Forms of the ellipsoids, in the square of the unit of `r12`. Unit: length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite. `Status::NoConvergence`: the proof
/// takes too long; this was seen only for forms that are singular to working precision.
///
/// # Examples
///
/// ```
/// let found = pw85::penetration(
///     &[3.0, 0.5, 0.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
///     &[0.25, 0.0, 0.0, 0.25, 0.0, 0.25],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn penetration(r12: &[f64; 3], q1: &[f64; 6], q2: &[f64; 6]) -> Result<Penetration, Error> {
    let mut depth = 0.0;
    let mut direction = [0.0; 3];
    check(unsafe { sys::pw85_penetration(
        r12.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        &mut depth,
        direction.as_mut_ptr(),
    ) })?;
    Ok(Penetration { depth, direction })
}

/// Computes [`penetration()`](crate::penetration) for many pairs, with bitwise equal results.
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
/// - `depth`: Unit: length.
///
/// Row i of each slice belongs to row i of `r12`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5, 0.0]; 2];
/// let q1 = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let q2 = [[0.25, 0.0, 0.0, 0.25, 0.0, 0.25]; 2];
/// let mut depth = [0.0; 2];
/// let mut direction = [[0.0; 3]; 2];
/// pw85::penetration_batch(&r12, &q1, &q2, Some(&mut depth), Some(&mut direction))?;
/// assert_eq!(direction[0], direction[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn penetration_batch(
    r12: &[[f64; 3]],
    q1: &[[f64; 6]],
    q2: &[[f64; 6]],
    depth: Option<&mut [f64]>,
    direction: Option<&mut [[f64; 3]]>,
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("q1", q1.len()),
        ("q2", q2.len()),
        ("depth", rows_of(&depth, n)),
        ("direction", rows_of(&direction, n)),
    ];
    same_rows("pw85_penetration_batch", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_penetration_batch(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        pointer(depth),
        pointer(direction),
    ) })
}

/// Computes the signed distance of two ellipsoids, and the points where it is reached.
///
/// The signed distance is the distance if the ellipsoids are apart, and minus the penetration
/// depth if they overlap.
///
/// In both cases the signed distance is the largest value of n·r12 - α - β over unit vectors n,
/// with the half-widths α and β of the ellipsoids along n. It is a continuous, convex function of
/// r12, whose gradient is a unit vector. The sign is exact: positive only if the ellipsoids are
/// apart, and negative only if they overlap, as [`overlap()`](crate::overlap) decides.
///
/// If the ellipsoids overlap, moving ellipsoid 2 by point1 - point2 is the shortest translation
/// that separates them. If several translations have this length, the result is one of them.
///
/// Errors and times are as for [`distance()`](crate::distance) if the ellipsoids are apart, and
/// as for [`penetration()`](crate::penetration) if they overlap. If the ellipsoids overlap,
/// point2 - point1 differs from `distance` times the unit normal by less than 2¹⁸ u (\|r12\| +
/// \|point1\| + \|r12 - point2\|), with u = 2⁻⁵³. This bound holds if the minimum is isolated,
/// for aspect ratios up to 10³.
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipsoid 1 to that of ellipsoid 2. Unit: length.
/// - `q1`, `q2`: Forms of the ellipsoids, in the square of the unit of `r12`. Unit: length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite. `Status::NoConvergence`: as for
/// [`distance()`](crate::distance).
///
/// # Examples
///
/// ```
/// let found = pw85::signed_distance(
///     &[3.0, 0.5, 0.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
///     &[0.25, 0.0, 0.0, 0.25, 0.0, 0.25],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn signed_distance(r12: &[f64; 3], q1: &[f64; 6], q2: &[f64; 6]) -> Result<Distance, Error> {
    let mut distance = 0.0;
    let mut point1 = [0.0; 3];
    let mut point2 = [0.0; 3];
    check(unsafe { sys::pw85_signed_distance(
        r12.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        &mut distance,
        point1.as_mut_ptr(),
        point2.as_mut_ptr(),
    ) })?;
    Ok(Distance { distance, point1, point2 })
}

/// Computes [`signed_distance()`](crate::signed_distance) for many pairs.
///
/// The errors have the same bounds. The results are bitwise equal where the ellipsoids overlap;
/// where they are apart, the last bits may differ.
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
/// - `distance`: Unit: length.
/// - `point1`, `point2`: Unit: length.
///
/// Row i of each slice belongs to row i of `r12`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5, 0.0]; 2];
/// let q1 = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let q2 = [[0.25, 0.0, 0.0, 0.25, 0.0, 0.25]; 2];
/// let mut distance = [0.0; 2];
/// let mut point1 = [[0.0; 3]; 2];
/// let mut point2 = [[0.0; 3]; 2];
/// pw85::signed_distance_batch(
///     &r12,
///     &q1,
///     &q2,
///     Some(&mut distance),
///     Some(&mut point1),
///     Some(&mut point2),
/// )?;
/// assert_eq!(point2[0], point2[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn signed_distance_batch(
    r12: &[[f64; 3]],
    q1: &[[f64; 6]],
    q2: &[[f64; 6]],
    distance: Option<&mut [f64]>,
    point1: Option<&mut [[f64; 3]]>,
    point2: Option<&mut [[f64; 3]]>,
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("q1", q1.len()),
        ("q2", q2.len()),
        ("distance", rows_of(&distance, n)),
        ("point1", rows_of(&point1, n)),
        ("point2", rows_of(&point2, n)),
    ];
    same_rows("pw85_signed_distance_batch", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_signed_distance_batch(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        pointer(distance),
        pointer(point1),
        pointer(point2),
    ) })
}

/// Computes the signed distance of two ellipsoids, as
/// [`signed_distance()`](crate::signed_distance) does, with the points where it is reached and
/// the normal there.
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipsoid 1 to that of ellipsoid 2. Unit: length.
/// - `q1`, `q2`: Forms of the ellipsoids, in the square of the unit of `r12`. Unit: length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite. `Status::NoConvergence`: as for
/// [`signed_distance()`](crate::signed_distance).
///
/// # Examples
///
/// ```
/// let found = pw85::signed_distance_geometry(
///     &[3.0, 0.5, 0.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
///     &[0.25, 0.0, 0.0, 0.25, 0.0, 0.25],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn signed_distance_geometry(
    r12: &[f64; 3],
    q1: &[f64; 6],
    q2: &[f64; 6],
) -> Result<SignedDistanceGeometry, Error> {
    let mut distance = 0.0;
    let mut point1 = [0.0; 3];
    let mut point2 = [0.0; 3];
    let mut normal = [0.0; 3];
    check(unsafe { sys::pw85_signed_distance_geometry(
        r12.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        &mut distance,
        point1.as_mut_ptr(),
        point2.as_mut_ptr(),
        normal.as_mut_ptr(),
    ) })?;
    Ok(SignedDistanceGeometry { distance, point1, point2, normal })
}

/// Computes [`signed_distance_geometry()`](crate::signed_distance_geometry) for many pairs.
///
/// The errors have the same bounds. The results are bitwise equal where the ellipsoids overlap;
/// where they are apart, the last bits may differ.
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
/// - `distance`: Unit: length.
/// - `point1`, `point2`: Unit: length.
///
/// Row i of each slice belongs to row i of `r12`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5, 0.0]; 2];
/// let q1 = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let q2 = [[0.25, 0.0, 0.0, 0.25, 0.0, 0.25]; 2];
/// let mut distance = [0.0; 2];
/// let mut point1 = [[0.0; 3]; 2];
/// let mut point2 = [[0.0; 3]; 2];
/// let mut normal = [[0.0; 3]; 2];
/// pw85::signed_distance_geometry_batch(
///     &r12,
///     &q1,
///     &q2,
///     Some(&mut distance),
///     Some(&mut point1),
///     Some(&mut point2),
///     Some(&mut normal),
/// )?;
/// assert_eq!(normal[0], normal[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn signed_distance_geometry_batch(
    r12: &[[f64; 3]],
    q1: &[[f64; 6]],
    q2: &[[f64; 6]],
    distance: Option<&mut [f64]>,
    point1: Option<&mut [[f64; 3]]>,
    point2: Option<&mut [[f64; 3]]>,
    normal: Option<&mut [[f64; 3]]>,
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("q1", q1.len()),
        ("q2", q2.len()),
        ("distance", rows_of(&distance, n)),
        ("point1", rows_of(&point1, n)),
        ("point2", rows_of(&point2, n)),
        ("normal", rows_of(&normal, n)),
    ];
    same_rows("pw85_signed_distance_geometry_batch", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_signed_distance_geometry_batch(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        pointer(distance),
        pointer(point1),
        pointer(point2),
        pointer(normal),
    ) })
}

/// Computes the derivatives of the signed distance of two ellipsoids.
///
/// At contact, the derivatives are the limits from both sides. The function has no output for
/// derivatives with respect to the entries of the forms. They are -n_i n_j/(2α) for q1 and -n_i
/// n_j/(2β) for q2, and twice that for entries off the diagonal, with n = d_r12 and the
/// half-widths α and β along n.
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipsoid 1 to that of ellipsoid 2. Unit: length.
/// - `q1`, `q2`: Forms of the ellipsoids, in the square of the unit of `r12`. Unit: length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite. `Status::NoConvergence`: as for
/// [`signed_distance()`](crate::signed_distance).
///
/// # Examples
///
/// ```
/// let found = pw85::signed_distance_derivatives(
///     &[3.0, 0.5, 0.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
///     &[0.25, 0.0, 0.0, 0.25, 0.0, 0.25],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn signed_distance_derivatives(
    r12: &[f64; 3],
    q1: &[f64; 6],
    q2: &[f64; 6],
) -> Result<DistanceDerivatives, Error> {
    let mut d_r12 = [0.0; 3];
    let mut d_rot1 = [0.0; 3];
    let mut d_rot2 = [0.0; 3];
    let mut hessian = [[0.0; 9]; 9];
    check(unsafe { sys::pw85_signed_distance_derivatives(
        r12.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        d_r12.as_mut_ptr(),
        d_rot1.as_mut_ptr(),
        d_rot2.as_mut_ptr(),
        hessian.as_mut_ptr().cast(),
    ) })?;
    Ok(DistanceDerivatives { d_r12, d_rot1, d_rot2, hessian })
}

/// Computes [`signed_distance_derivatives()`](crate::signed_distance_derivatives) for many pairs,
/// with bitwise equal results.
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
/// - `d_rot1`, `d_rot2`: Unit: length.
/// - `hessian`: Unit: mixed units.
///
/// Row i of each slice belongs to row i of `r12`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5, 0.0]; 2];
/// let q1 = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let q2 = [[0.25, 0.0, 0.0, 0.25, 0.0, 0.25]; 2];
/// let mut d_r12 = [[0.0; 3]; 2];
/// let mut d_rot1 = [[0.0; 3]; 2];
/// let mut d_rot2 = [[0.0; 3]; 2];
/// let mut hessian = [[[0.0; 9]; 9]; 2];
/// pw85::signed_distance_derivatives_batch(
///     &r12,
///     &q1,
///     &q2,
///     Some(&mut d_r12),
///     Some(&mut d_rot1),
///     Some(&mut d_rot2),
///     Some(&mut hessian),
/// )?;
/// assert_eq!(hessian[0], hessian[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn signed_distance_derivatives_batch(
    r12: &[[f64; 3]],
    q1: &[[f64; 6]],
    q2: &[[f64; 6]],
    d_r12: Option<&mut [[f64; 3]]>,
    d_rot1: Option<&mut [[f64; 3]]>,
    d_rot2: Option<&mut [[f64; 3]]>,
    hessian: Option<&mut [[[f64; 9]; 9]]>,
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("q1", q1.len()),
        ("q2", q2.len()),
        ("d_r12", rows_of(&d_r12, n)),
        ("d_rot1", rows_of(&d_rot1, n)),
        ("d_rot2", rows_of(&d_rot2, n)),
        ("hessian", rows_of(&hessian, n)),
    ];
    same_rows("pw85_signed_distance_derivatives_batch", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_signed_distance_derivatives_batch(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        pointer(d_r12),
        pointer(d_rot1),
        pointer(d_rot2),
        pointer(hessian),
    ) })
}

/// Computes the least gap between the surface of ellipsoid 1 and an ellipsoid 2 inside it.
///
/// Ellipsoid 2 can move by the gap in any direction without leaving ellipsoid 1. The gap is the
/// smallest value of α - β - n·r12 over unit vectors n, with the half-widths α and β of
/// ellipsoids 1 and 2 along n. This function of n may have several local minima. The library
/// proves that its result is the global minimum. If several directions give the same value, the
/// result is one of them.
///
/// `gap` is the value of α - β - n·r12 for the returned normal n, up to a few roundings. If the
/// minima are isolated, no other direction has a value that is smaller by more than 128 u α (1 +
/// α/β), with u = 2⁻⁵³ and α and β along the returned normal. If the minima are not isolated, as
/// for spheroids with a common axis, another direction may have a value that is smaller by up to
/// 2⁻²⁰ of the gap (2⁻⁴⁰ in two dimensions).
///
/// The time is 50 to 300 times that of [`contact()`](crate::contact) if the minima are isolated.
/// Otherwise it is up to a few tenths of a second.
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipsoid 1 to that of ellipsoid 2. Unit: length.
/// - `q1`, `q2`: Forms of the ellipsoids, in the square of the unit of `r12`. Unit: length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite. `Status::NoConvergence`: the proof
/// takes too long; this has never been seen.
///
/// # Examples
///
/// ```
/// let found = pw85::gap_inside(
///     &[0.5, 0.25, 0.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
///     &[0.25, 0.0, 0.0, 0.25, 0.0, 0.25],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn gap_inside(r12: &[f64; 3], q1: &[f64; 6], q2: &[f64; 6]) -> Result<GapInside, Error> {
    let mut gap = 0.0;
    let mut point1 = [0.0; 3];
    let mut point2 = [0.0; 3];
    let mut normal = [0.0; 3];
    check(unsafe { sys::pw85_gap_inside(
        r12.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        &mut gap,
        point1.as_mut_ptr(),
        point2.as_mut_ptr(),
        normal.as_mut_ptr(),
    ) })?;
    Ok(GapInside { gap, point1, point2, normal })
}

/// Computes [`gap_inside()`](crate::gap_inside) for many pairs, with bitwise equal results.
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
/// - `gap`: Unit: length.
/// - `point1`, `point2`: Unit: length.
///
/// Row i of each slice belongs to row i of `r12`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[0.5, 0.25, 0.0]; 2];
/// let q1 = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let q2 = [[0.25, 0.0, 0.0, 0.25, 0.0, 0.25]; 2];
/// let mut gap = [0.0; 2];
/// let mut point1 = [[0.0; 3]; 2];
/// let mut point2 = [[0.0; 3]; 2];
/// let mut normal = [[0.0; 3]; 2];
/// pw85::gap_inside_batch(
///     &r12,
///     &q1,
///     &q2,
///     Some(&mut gap),
///     Some(&mut point1),
///     Some(&mut point2),
///     Some(&mut normal),
/// )?;
/// assert_eq!(normal[0], normal[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn gap_inside_batch(
    r12: &[[f64; 3]],
    q1: &[[f64; 6]],
    q2: &[[f64; 6]],
    gap: Option<&mut [f64]>,
    point1: Option<&mut [[f64; 3]]>,
    point2: Option<&mut [[f64; 3]]>,
    normal: Option<&mut [[f64; 3]]>,
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("q1", q1.len()),
        ("q2", q2.len()),
        ("gap", rows_of(&gap, n)),
        ("point1", rows_of(&point1, n)),
        ("point2", rows_of(&point2, n)),
        ("normal", rows_of(&normal, n)),
    ];
    same_rows("pw85_gap_inside_batch", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_gap_inside_batch(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        pointer(gap),
        pointer(point1),
        pointer(point2),
        pointer(normal),
    ) })
}

/// Computes the distance of two ellipses; see [`distance()`](crate::distance).
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipse 1 to that of ellipse 2. Unit: length.
/// - `q1`, `q2`: Forms (xx, xy, yy) of the ellipses, in the square of the unit of `r12`. Unit:
///   length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite. `Status::NoConvergence`: the error
/// bound cannot be proved with 384 binary digits; not seen up to aspect ratio 2¹⁰⁰.
///
/// # Examples
///
/// ```
/// let found = pw85::distance_2d(&[5.0, 0.5], &[9.0, 0.0, 4.0], &[0.25, 0.0, 0.25])?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn distance_2d(r12: &[f64; 2], q1: &[f64; 3], q2: &[f64; 3]) -> Result<Distance2d, Error> {
    let mut distance = 0.0;
    let mut point1 = [0.0; 2];
    let mut point2 = [0.0; 2];
    check(unsafe { sys::pw85_distance_2d(
        r12.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        &mut distance,
        point1.as_mut_ptr(),
        point2.as_mut_ptr(),
    ) })?;
    Ok(Distance2d { distance, point1, point2 })
}

/// Computes [`distance_2d()`](crate::distance_2d) for many pairs, with bitwise equal results.
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
/// - `distance`: Unit: length.
/// - `point1`, `point2`: Unit: length.
///
/// Row i of each slice belongs to row i of `r12`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[5.0, 0.5]; 2];
/// let q1 = [[9.0, 0.0, 4.0]; 2];
/// let q2 = [[0.25, 0.0, 0.25]; 2];
/// let mut distance = [0.0; 2];
/// let mut point1 = [[0.0; 2]; 2];
/// let mut point2 = [[0.0; 2]; 2];
/// pw85::distance_batch_2d(&r12, &q1, &q2, Some(&mut distance), Some(&mut point1), Some(&mut point2))?;
/// assert_eq!(point2[0], point2[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn distance_batch_2d(
    r12: &[[f64; 2]],
    q1: &[[f64; 3]],
    q2: &[[f64; 3]],
    distance: Option<&mut [f64]>,
    point1: Option<&mut [[f64; 2]]>,
    point2: Option<&mut [[f64; 2]]>,
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("q1", q1.len()),
        ("q2", q2.len()),
        ("distance", rows_of(&distance, n)),
        ("point1", rows_of(&point1, n)),
        ("point2", rows_of(&point2, n)),
    ];
    same_rows("pw85_distance_batch_2d", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_distance_batch_2d(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        pointer(distance),
        pointer(point1),
        pointer(point2),
    ) })
}

/// Computes the distance of two ellipses with the closest points and the normal; see
/// [`distance_geometry()`](crate::distance_geometry).
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipse 1 to that of ellipse 2. Unit: length.
/// - `q1`, `q2`: Forms (xx, xy, yy) of the ellipses, in the square of the unit of `r12`. Unit:
///   length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite. `Status::NoConvergence`: as for
/// [`distance()`](crate::distance).
///
/// # Examples
///
/// ```
/// let found = pw85::distance_geometry_2d(&[5.0, 0.5], &[9.0, 0.0, 4.0], &[0.25, 0.0, 0.25])?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn distance_geometry_2d(
    r12: &[f64; 2],
    q1: &[f64; 3],
    q2: &[f64; 3],
) -> Result<DistanceGeometry2d, Error> {
    let mut distance = 0.0;
    let mut point1 = [0.0; 2];
    let mut point2 = [0.0; 2];
    let mut normal = [0.0; 2];
    check(unsafe { sys::pw85_distance_geometry_2d(
        r12.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        &mut distance,
        point1.as_mut_ptr(),
        point2.as_mut_ptr(),
        normal.as_mut_ptr(),
    ) })?;
    Ok(DistanceGeometry2d { distance, point1, point2, normal })
}

/// Computes [`distance_geometry_2d()`](crate::distance_geometry_2d) for many pairs, with bitwise
/// equal results.
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
/// - `distance`: Unit: length.
/// - `point1`, `point2`: Unit: length.
///
/// Row i of each slice belongs to row i of `r12`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[5.0, 0.5]; 2];
/// let q1 = [[9.0, 0.0, 4.0]; 2];
/// let q2 = [[0.25, 0.0, 0.25]; 2];
/// let mut distance = [0.0; 2];
/// let mut point1 = [[0.0; 2]; 2];
/// let mut point2 = [[0.0; 2]; 2];
/// let mut normal = [[0.0; 2]; 2];
/// pw85::distance_geometry_batch_2d(
///     &r12,
///     &q1,
///     &q2,
///     Some(&mut distance),
///     Some(&mut point1),
///     Some(&mut point2),
///     Some(&mut normal),
/// )?;
/// assert_eq!(normal[0], normal[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn distance_geometry_batch_2d(
    r12: &[[f64; 2]],
    q1: &[[f64; 3]],
    q2: &[[f64; 3]],
    distance: Option<&mut [f64]>,
    point1: Option<&mut [[f64; 2]]>,
    point2: Option<&mut [[f64; 2]]>,
    normal: Option<&mut [[f64; 2]]>,
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("q1", q1.len()),
        ("q2", q2.len()),
        ("distance", rows_of(&distance, n)),
        ("point1", rows_of(&point1, n)),
        ("point2", rows_of(&point2, n)),
        ("normal", rows_of(&normal, n)),
    ];
    same_rows("pw85_distance_geometry_batch_2d", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_distance_geometry_batch_2d(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        pointer(distance),
        pointer(point1),
        pointer(point2),
        pointer(normal),
    ) })
}

/// Computes the penetration depth of two ellipses; see [`penetration()`](crate::penetration).
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipse 1 to that of ellipse 2. Unit: length.
/// - `q1`, `q2`: Forms (xx, xy, yy) of the ellipses, in the square of the unit of `r12`. Unit:
///   length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite. `Status::NoConvergence`: the proof
/// takes too long; this was seen only for forms that are singular to working precision.
///
/// # Examples
///
/// ```
/// let found = pw85::penetration_2d(&[3.0, 0.5], &[9.0, 0.0, 4.0], &[0.25, 0.0, 0.25])?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn penetration_2d(
    r12: &[f64; 2],
    q1: &[f64; 3],
    q2: &[f64; 3],
) -> Result<Penetration2d, Error> {
    let mut depth = 0.0;
    let mut direction = [0.0; 2];
    check(unsafe { sys::pw85_penetration_2d(
        r12.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        &mut depth,
        direction.as_mut_ptr(),
    ) })?;
    Ok(Penetration2d { depth, direction })
}

/// Computes [`penetration_2d()`](crate::penetration_2d) for many pairs, with bitwise equal
/// results.
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
/// - `depth`: Unit: length.
///
/// Row i of each slice belongs to row i of `r12`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5]; 2];
/// let q1 = [[9.0, 0.0, 4.0]; 2];
/// let q2 = [[0.25, 0.0, 0.25]; 2];
/// let mut depth = [0.0; 2];
/// let mut direction = [[0.0; 2]; 2];
/// pw85::penetration_batch_2d(&r12, &q1, &q2, Some(&mut depth), Some(&mut direction))?;
/// assert_eq!(direction[0], direction[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn penetration_batch_2d(
    r12: &[[f64; 2]],
    q1: &[[f64; 3]],
    q2: &[[f64; 3]],
    depth: Option<&mut [f64]>,
    direction: Option<&mut [[f64; 2]]>,
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("q1", q1.len()),
        ("q2", q2.len()),
        ("depth", rows_of(&depth, n)),
        ("direction", rows_of(&direction, n)),
    ];
    same_rows("pw85_penetration_batch_2d", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_penetration_batch_2d(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        pointer(depth),
        pointer(direction),
    ) })
}

/// Computes the signed distance of two ellipses; see
/// [`signed_distance()`](crate::signed_distance).
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipse 1 to that of ellipse 2. Unit: length.
/// - `q1`, `q2`: Forms (xx, xy, yy) of the ellipses, in the square of the unit of `r12`. Unit:
///   length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite. `Status::NoConvergence`: as for
/// [`distance()`](crate::distance).
///
/// # Examples
///
/// ```
/// let found = pw85::signed_distance_2d(&[3.0, 0.5], &[9.0, 0.0, 4.0], &[0.25, 0.0, 0.25])?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn signed_distance_2d(
    r12: &[f64; 2],
    q1: &[f64; 3],
    q2: &[f64; 3],
) -> Result<Distance2d, Error> {
    let mut distance = 0.0;
    let mut point1 = [0.0; 2];
    let mut point2 = [0.0; 2];
    check(unsafe { sys::pw85_signed_distance_2d(
        r12.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        &mut distance,
        point1.as_mut_ptr(),
        point2.as_mut_ptr(),
    ) })?;
    Ok(Distance2d { distance, point1, point2 })
}

/// Computes [`signed_distance_2d()`](crate::signed_distance_2d) for many pairs, with bitwise
/// equal results.
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
/// - `distance`: Unit: length.
/// - `point1`, `point2`: Unit: length.
///
/// Row i of each slice belongs to row i of `r12`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5]; 2];
/// let q1 = [[9.0, 0.0, 4.0]; 2];
/// let q2 = [[0.25, 0.0, 0.25]; 2];
/// let mut distance = [0.0; 2];
/// let mut point1 = [[0.0; 2]; 2];
/// let mut point2 = [[0.0; 2]; 2];
/// pw85::signed_distance_batch_2d(
///     &r12,
///     &q1,
///     &q2,
///     Some(&mut distance),
///     Some(&mut point1),
///     Some(&mut point2),
/// )?;
/// assert_eq!(point2[0], point2[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn signed_distance_batch_2d(
    r12: &[[f64; 2]],
    q1: &[[f64; 3]],
    q2: &[[f64; 3]],
    distance: Option<&mut [f64]>,
    point1: Option<&mut [[f64; 2]]>,
    point2: Option<&mut [[f64; 2]]>,
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("q1", q1.len()),
        ("q2", q2.len()),
        ("distance", rows_of(&distance, n)),
        ("point1", rows_of(&point1, n)),
        ("point2", rows_of(&point2, n)),
    ];
    same_rows("pw85_signed_distance_batch_2d", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_signed_distance_batch_2d(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        pointer(distance),
        pointer(point1),
        pointer(point2),
    ) })
}

/// Computes the signed distance of two ellipses with the points where it is reached and the
/// normal.
///
/// See [`signed_distance_geometry()`](crate::signed_distance_geometry).
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipse 1 to that of ellipse 2. Unit: length.
/// - `q1`, `q2`: Forms (xx, xy, yy) of the ellipses, in the square of the unit of `r12`. Unit:
///   length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite. `Status::NoConvergence`: as for
/// [`signed_distance()`](crate::signed_distance).
///
/// # Examples
///
/// ```
/// let found = pw85::signed_distance_geometry_2d(&[3.0, 0.5], &[9.0, 0.0, 4.0], &[0.25, 0.0, 0.25])?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn signed_distance_geometry_2d(
    r12: &[f64; 2],
    q1: &[f64; 3],
    q2: &[f64; 3],
) -> Result<SignedDistanceGeometry2d, Error> {
    let mut distance = 0.0;
    let mut point1 = [0.0; 2];
    let mut point2 = [0.0; 2];
    let mut normal = [0.0; 2];
    check(unsafe { sys::pw85_signed_distance_geometry_2d(
        r12.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        &mut distance,
        point1.as_mut_ptr(),
        point2.as_mut_ptr(),
        normal.as_mut_ptr(),
    ) })?;
    Ok(SignedDistanceGeometry2d { distance, point1, point2, normal })
}

/// Computes [`signed_distance_geometry_2d()`](crate::signed_distance_geometry_2d) for many pairs,
/// with bitwise equal results.
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
/// - `distance`: Unit: length.
/// - `point1`, `point2`: Unit: length.
///
/// Row i of each slice belongs to row i of `r12`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5]; 2];
/// let q1 = [[9.0, 0.0, 4.0]; 2];
/// let q2 = [[0.25, 0.0, 0.25]; 2];
/// let mut distance = [0.0; 2];
/// let mut point1 = [[0.0; 2]; 2];
/// let mut point2 = [[0.0; 2]; 2];
/// let mut normal = [[0.0; 2]; 2];
/// pw85::signed_distance_geometry_batch_2d(
///     &r12,
///     &q1,
///     &q2,
///     Some(&mut distance),
///     Some(&mut point1),
///     Some(&mut point2),
///     Some(&mut normal),
/// )?;
/// assert_eq!(normal[0], normal[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn signed_distance_geometry_batch_2d(
    r12: &[[f64; 2]],
    q1: &[[f64; 3]],
    q2: &[[f64; 3]],
    distance: Option<&mut [f64]>,
    point1: Option<&mut [[f64; 2]]>,
    point2: Option<&mut [[f64; 2]]>,
    normal: Option<&mut [[f64; 2]]>,
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("q1", q1.len()),
        ("q2", q2.len()),
        ("distance", rows_of(&distance, n)),
        ("point1", rows_of(&point1, n)),
        ("point2", rows_of(&point2, n)),
        ("normal", rows_of(&normal, n)),
    ];
    same_rows("pw85_signed_distance_geometry_batch_2d", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_signed_distance_geometry_batch_2d(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        pointer(distance),
        pointer(point1),
        pointer(point2),
        pointer(normal),
    ) })
}

/// Computes the least gap of ellipse 2 inside ellipse 1; see [`gap_inside()`](crate::gap_inside).
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipse 1 to that of ellipse 2. Unit: length.
/// - `q1`, `q2`: Forms (xx, xy, yy) of the ellipses, in the square of the unit of `r12`. Unit:
///   length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite. `Status::NoConvergence`: the proof
/// takes too long; this has never been seen.
///
/// # Examples
///
/// ```
/// let found = pw85::gap_inside_2d(&[0.5, 0.25], &[9.0, 0.0, 4.0], &[0.25, 0.0, 0.25])?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn gap_inside_2d(r12: &[f64; 2], q1: &[f64; 3], q2: &[f64; 3]) -> Result<GapInside2d, Error> {
    let mut gap = 0.0;
    let mut point1 = [0.0; 2];
    let mut point2 = [0.0; 2];
    let mut normal = [0.0; 2];
    check(unsafe { sys::pw85_gap_inside_2d(
        r12.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        &mut gap,
        point1.as_mut_ptr(),
        point2.as_mut_ptr(),
        normal.as_mut_ptr(),
    ) })?;
    Ok(GapInside2d { gap, point1, point2, normal })
}

/// Computes [`gap_inside_2d()`](crate::gap_inside_2d) for many pairs, with bitwise equal results.
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
/// - `gap`: Unit: length.
/// - `point1`, `point2`: Unit: length.
///
/// Row i of each slice belongs to row i of `r12`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[0.5, 0.25]; 2];
/// let q1 = [[9.0, 0.0, 4.0]; 2];
/// let q2 = [[0.25, 0.0, 0.25]; 2];
/// let mut gap = [0.0; 2];
/// let mut point1 = [[0.0; 2]; 2];
/// let mut point2 = [[0.0; 2]; 2];
/// let mut normal = [[0.0; 2]; 2];
/// pw85::gap_inside_batch_2d(
///     &r12,
///     &q1,
///     &q2,
///     Some(&mut gap),
///     Some(&mut point1),
///     Some(&mut point2),
///     Some(&mut normal),
/// )?;
/// assert_eq!(normal[0], normal[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn gap_inside_batch_2d(
    r12: &[[f64; 2]],
    q1: &[[f64; 3]],
    q2: &[[f64; 3]],
    gap: Option<&mut [f64]>,
    point1: Option<&mut [[f64; 2]]>,
    point2: Option<&mut [[f64; 2]]>,
    normal: Option<&mut [[f64; 2]]>,
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("q1", q1.len()),
        ("q2", q2.len()),
        ("gap", rows_of(&gap, n)),
        ("point1", rows_of(&point1, n)),
        ("point2", rows_of(&point2, n)),
        ("normal", rows_of(&normal, n)),
    ];
    same_rows("pw85_gap_inside_batch_2d", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_gap_inside_batch_2d(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        pointer(gap),
        pointer(point1),
        pointer(point2),
        pointer(normal),
    ) })
}

/// Computes the time of the first contact of two moving ellipsoids.
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipsoid 1 to that of ellipsoid 2; at time 0. Unit:
///   length.
/// - `q1`, `q2`: Forms of the ellipsoids, in the square of the unit of `r12`; at time 0. Unit:
///   length².
/// - `motion1`, `motion2`: Motions of the ellipsoids; their semi-axes must be \> 0 until t_max.
///   Unit: mixed units.
/// - `t_max`: The last time at which a contact counts; \>= 0; may be infinite. Unit: time.
///
/// # Errors
///
/// A number is not finite (`t_max` may be infinite), a form is not positive definite, `t_max` is
/// negative or an ellipsoid shrinks to nothing before `t_max`. `Status::NoConvergence`: one of
/// three: the search ends after 100,000 steps, because the ellipsoids rotate near each other,
/// without contact, by more than 50,000 radians, or by more than 10,000 at aspect ratio 1000;
/// sizes, the relative velocity or the time leave the range of double; rounding errors leave no
/// digit of an orientation or a form, after more than 2⁴³ radians or at an aspect ratio above
/// 10⁷.
///
/// # Examples
///
/// ```
/// let found = pw85::first_contact(
///     &[3.0, 0.5, 0.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
///     &[0.25, 0.0, 0.0, 0.25, 0.0, 0.25],
///     &pw85::Motion { velocity: [0.0, 0.0, 0.0], ..Default::default() },
///     &pw85::Motion { velocity: [-1.0, 0.0, 0.0], ..Default::default() },
///     10.0,
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn first_contact(
    r12: &[f64; 3],
    q1: &[f64; 6],
    q2: &[f64; 6],
    motion1: &Motion,
    motion2: &Motion,
    t_max: f64,
) -> Result<f64, Error> {
    let mut t = 0.0;
    check(unsafe { sys::pw85_first_contact(
        r12.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        motion1,
        motion2,
        t_max,
        &mut t,
    ) })?;
    Ok(t)
}

/// Computes [`first_contact()`](crate::first_contact) for many pairs, with bitwise equal results.
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
/// - `motion1`, `motion2`: Unit: mixed units.
/// - `t_max`: The last time at which a contact counts; for all rows; \>= 0; may be infinite.
///   Unit: time.
/// - `t`: Unit: time.
///
/// Row i of each slice belongs to row i of `r12`.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5, 0.0]; 2];
/// let q1 = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let q2 = [[0.25, 0.0, 0.0, 0.25, 0.0, 0.25]; 2];
/// let motion1 = [pw85::Motion { velocity: [0.0, 0.0, 0.0], ..Default::default() }; 2];
/// let motion2 = [pw85::Motion { velocity: [-1.0, 0.0, 0.0], ..Default::default() }; 2];
/// let t_max = 10.0;
/// let mut t = [0.0; 2];
/// pw85::first_contact_batch(&r12, &q1, &q2, &motion1, &motion2, t_max, &mut t)?;
/// assert_eq!(t[0], t[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn first_contact_batch(
    r12: &[[f64; 3]],
    q1: &[[f64; 6]],
    q2: &[[f64; 6]],
    motion1: &[Motion],
    motion2: &[Motion],
    t_max: f64,
    t: &mut [f64],
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("q1", q1.len()),
        ("q2", q2.len()),
        ("motion1", motion1.len()),
        ("motion2", motion2.len()),
        ("t", t.len()),
    ];
    same_rows("pw85_first_contact_batch", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_first_contact_batch(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        motion1.as_ptr(),
        motion2.as_ptr(),
        t_max,
        t.as_mut_ptr(),
    ) })
}

/// Computes the least μ² while ellipsoid 2 translates past ellipsoid 1 on a straight path, and
/// the time of this minimum.
///
/// This is the minimum of the contact function for the separations r12 + t velocity, 0 \<= t \<=
/// t_max. μ² is a convex function of t, so the minimum is unique unless the velocity is zero. The
/// ellipsoids overlap somewhere on this path if and only if the exact minimum is below 1.
///
/// The error of μ² is below 8 u S, with u = 2⁻⁵³. Here S = μ² cond + 2 λ(1-λ) Σ\|n_i\|
/// (\|r12_i\| + t \|velocity_i\|), with cond, λ and n of [`condition()`](crate::condition) for
/// the pair at time t. Relative errors ε of the given numbers change μ² by at most ε S, to first
/// order.
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipsoid 1 to that of ellipsoid 2; at time 0. Unit:
///   length.
/// - `q1`, `q2`: Forms of the ellipsoids, in the square of the unit of `r12`; at time 0. Unit:
///   length².
/// - `velocity`: Velocity of ellipsoid 2 relative to ellipsoid 1; it may be zero. Unit:
///   length/time.
/// - `t_max`: The end of the path; \>= 0; may be infinite. Unit: time.
///
/// # Errors
///
/// A number is not finite (`t_max` may be infinite), a form is not positive definite or `t_max`
/// is negative. `Status::NoConvergence`: as for [`contact()`](crate::contact).
///
/// # Examples
///
/// ```
/// let found = pw85::closest_passage(
///     &[3.0, 0.5, 0.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
///     &[0.25, 0.0, 0.0, 0.25, 0.0, 0.25],
///     &[-1.0, 0.0, 0.0],
///     10.0,
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn closest_passage(
    r12: &[f64; 3],
    q1: &[f64; 6],
    q2: &[f64; 6],
    velocity: &[f64; 3],
    t_max: f64,
) -> Result<ClosestPassage, Error> {
    let mut mu2 = 0.0;
    let mut t = 0.0;
    check(unsafe { sys::pw85_closest_passage(
        r12.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        velocity.as_ptr(),
        t_max,
        &mut mu2,
        &mut t,
    ) })?;
    Ok(ClosestPassage { mu2, t })
}

/// Computes [`closest_passage()`](crate::closest_passage) for many pairs.
///
/// The error of μ² is below 8 u S as for one pair. The last bits may differ from those of
/// [`closest_passage()`](crate::closest_passage).
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
/// - `velocity`: Unit: length/time.
/// - `t_max`: The end of the path; for all rows; \>= 0; may be infinite. Unit: time.
/// - `t`: Unit: time.
///
/// Row i of each slice belongs to row i of `r12`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5, 0.0]; 2];
/// let q1 = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let q2 = [[0.25, 0.0, 0.0, 0.25, 0.0, 0.25]; 2];
/// let velocity = [[-1.0, 0.0, 0.0]; 2];
/// let t_max = 10.0;
/// let mut mu2 = [0.0; 2];
/// let mut t = [0.0; 2];
/// pw85::closest_passage_batch(&r12, &q1, &q2, &velocity, t_max, &mut mu2, Some(&mut t))?;
/// assert_eq!(t[0], t[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn closest_passage_batch(
    r12: &[[f64; 3]],
    q1: &[[f64; 6]],
    q2: &[[f64; 6]],
    velocity: &[[f64; 3]],
    t_max: f64,
    mu2: &mut [f64],
    t: Option<&mut [f64]>,
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("q1", q1.len()),
        ("q2", q2.len()),
        ("velocity", velocity.len()),
        ("mu2", mu2.len()),
        ("t", rows_of(&t, n)),
    ];
    same_rows("pw85_closest_passage_batch", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_closest_passage_batch(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        velocity.as_ptr().cast(),
        t_max,
        mu2.as_mut_ptr(),
        pointer(t),
    ) })
}

/// Computes the free path of ellipsoid 1: how far it may move until it touches ellipsoid 2.
///
/// Ellipsoid 1 moves by t times `direction`, and the separation is then r12 - t direction. If the
/// ellipsoids do not overlap at t = 0, they do not overlap at the returned t or before: rounding
/// errors make t smaller, never larger. At the returned t the ellipsoids touch up to rounding: μ²
/// \<= 1 + 80 u S, with u = 2⁻⁵³ and S as for [`first_contact()`](crate::first_contact).
///
/// t is 0 if the ellipsoids overlap at t = 0, or touch and do not separate. If they separate, an
/// overlap of at most 128 times the bound on the rounding error of μ² is ignored.
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipsoid 1 to that of ellipsoid 2. Unit: length.
/// - `q1`, `q2`: Forms of the ellipsoids, in the square of the unit of `r12`. Unit: length².
/// - `direction`: Of any length; not zero.
/// - `t_max`: The end of the path, as a multiple of `direction`: a length if `direction` is a
///   unit vector; \>= 0; may be infinite. Unit: length.
///
/// # Errors
///
/// A number is not finite (`t_max` may be infinite), a form is not positive definite, `t_max` is
/// negative or `direction` is zero. `Status::NoConvergence`: as for
/// [`first_contact()`](crate::first_contact).
///
/// # Examples
///
/// ```
/// let found = pw85::free_path(
///     &[3.0, 0.5, 0.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
///     &[0.25, 0.0, 0.0, 0.25, 0.0, 0.25],
///     &[1.0, 0.0, 0.0],
///     10.0,
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn free_path(
    r12: &[f64; 3],
    q1: &[f64; 6],
    q2: &[f64; 6],
    direction: &[f64; 3],
    t_max: f64,
) -> Result<f64, Error> {
    let mut t = 0.0;
    check(unsafe { sys::pw85_free_path(
        r12.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        direction.as_ptr(),
        t_max,
        &mut t,
    ) })?;
    Ok(t)
}

/// Computes [`free_path()`](crate::free_path) for many pairs, with bitwise equal results.
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
/// - `directions`: Not zero.
/// - `t_max`: \>= 0; may be infinite. Unit: length.
/// - `t`: Unit: length.
///
/// Row i of each slice belongs to row i of `r12`.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5, 0.0]; 2];
/// let q1 = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let q2 = [[0.25, 0.0, 0.0, 0.25, 0.0, 0.25]; 2];
/// let directions = [[1.0, 0.0, 0.0]; 2];
/// let t_max = [10.0; 2];
/// let mut t = [0.0; 2];
/// pw85::free_path_batch(&r12, &q1, &q2, &directions, &t_max, &mut t)?;
/// assert_eq!(t[0], t[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn free_path_batch(
    r12: &[[f64; 3]],
    q1: &[[f64; 6]],
    q2: &[[f64; 6]],
    directions: &[[f64; 3]],
    t_max: &[f64],
    t: &mut [f64],
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("q1", q1.len()),
        ("q2", q2.len()),
        ("directions", directions.len()),
        ("t_max", t_max.len()),
        ("t", t.len()),
    ];
    same_rows("pw85_free_path_batch", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_free_path_batch(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        directions.as_ptr().cast(),
        t_max.as_ptr(),
        t.as_mut_ptr(),
    ) })
}

/// Computes the principal curvatures of the surface of an ellipsoid, and their directions, at the
/// point with a given normal.
///
/// The relative error of each curvature is below 1e-12 for the numbers as given, up to aspect
/// ratio 10⁶. Above an aspect ratio of about 10 the function computes in double-double
/// arithmetic, with twice the digits, which takes about eight times as long.
///
/// # Arguments
///
/// - `normal`: Out of the ellipsoid, of any length; not zero.
/// - `q`: Form of the ellipsoid. Unit: length².
///
/// # Errors
///
/// A number is not finite, a form is not positive definite or `normal` is zero.
///
/// # Examples
///
/// ```
/// let found = pw85::curvature(&[1.0, 0.0, 0.0], &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0])?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn curvature(normal: &[f64; 3], q: &[f64; 6]) -> Result<Curvature, Error> {
    let mut curvatures = [0.0; 2];
    let mut directions = [[0.0; 3]; 2];
    check(unsafe { sys::pw85_curvature(
        normal.as_ptr(),
        q.as_ptr(),
        curvatures.as_mut_ptr(),
        directions.as_mut_ptr().cast(),
    ) })?;
    Ok(Curvature { curvatures, directions })
}

/// Computes [`curvature()`](crate::curvature) for many ellipsoids, with bitwise equal results.
///
/// # Arguments
///
/// - `normals`: Not zero.
/// - `q`: Unit: length².
/// - `curvatures`: Unit: 1/length.
///
/// Row i of each slice belongs to row i of `normals`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `normals`, or a row is refused. The outputs of such rows are
/// NaN, 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let normals = [[1.0, 0.0, 0.0]; 2];
/// let q = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let mut curvatures = [[0.0; 2]; 2];
/// let mut directions = [[[0.0; 3]; 2]; 2];
/// pw85::curvature_batch(&normals, &q, Some(&mut curvatures), Some(&mut directions))?;
/// assert_eq!(directions[0], directions[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn curvature_batch(
    normals: &[[f64; 3]],
    q: &[[f64; 6]],
    curvatures: Option<&mut [[f64; 2]]>,
    directions: Option<&mut [[[f64; 3]; 2]]>,
) -> Result<(), Error> {
    let n = normals.len();
    let counts = [
        ("q", q.len()),
        ("curvatures", rows_of(&curvatures, n)),
        ("directions", rows_of(&directions, n)),
    ];
    same_rows("pw85_curvature_batch", "must have as many rows as normals", n, &counts)?;
    check_rows(unsafe { sys::pw85_curvature_batch(
        n,
        normals.as_ptr().cast(),
        q.as_ptr().cast(),
        pointer(curvatures),
        pointer(directions),
    ) })
}

/// Computes the effective radius of Hertz's theory for two elastic bodies, and the shape of the
/// contact ellipse.
///
/// From these, the force and the ellipse follow as functions of the depth.
///
/// For a depth δ the force is (4/3) E\* √(radius δ³), a repulsion, and the energy is (8/15) E\*
/// √(radius δ⁵). Here 1/E\* = (1 - ν1²)/E1 + (1 - ν2²)/E2, with Young's moduli E and Poisson's
/// ratios ν. The contact area is an ellipse with semi-axes √(ellipse\[0\] δ) and √(ellipse\[1\]
/// δ). The square of their arithmetic-geometric mean is radius δ. The function evaluates the
/// complete elliptic integrals of the theory.
///
/// The relative errors are below 256 u, with u = 2⁻⁵³, if the ratio of the curvatures is at most
/// 10¹⁸.
///
/// # Arguments
///
/// - `curvatures`: Principal curvatures k1, k2 of the gap between the undeformed surfaces: at the
///   coordinates x, y along the principal directions the gap is (k1 x² + k2 y²)/2. For two
///   ellipsoids they are the curvatures of [`hertz_contact()`](crate::hertz_contact), for an
///   ellipsoid on a plane those of [`curvature()`](crate::curvature); \> 0. Unit: 1/length.
///
/// # Errors
///
/// A number is not finite or `curvatures` is not positive.
///
/// # Examples
///
/// ```
/// let found = pw85::hertz(&[1.0, 2.0])?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn hertz(curvatures: &[f64; 2]) -> Result<HertzEllipse, Error> {
    let mut radius = 0.0;
    let mut ellipse = [0.0; 2];
    check(unsafe { sys::pw85_hertz(curvatures.as_ptr(), &mut radius, ellipse.as_mut_ptr()) })?;
    Ok(HertzEllipse { radius, ellipse })
}

/// Computes [`hertz()`](crate::hertz) for many contacts, with bitwise equal results.
///
/// # Arguments
///
/// - `curvatures`: \> 0. Unit: 1/length.
/// - `radius`: Unit: length.
/// - `ellipse`: Unit: length.
///
/// Row i of each slice belongs to row i of `curvatures`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `curvatures`, or a row is refused. The outputs of such rows
/// are NaN, 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let curvatures = [[1.0, 2.0]; 2];
/// let mut radius = [0.0; 2];
/// let mut ellipse = [[0.0; 2]; 2];
/// pw85::hertz_batch(&curvatures, Some(&mut radius), Some(&mut ellipse))?;
/// assert_eq!(ellipse[0], ellipse[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn hertz_batch(
    curvatures: &[[f64; 2]],
    radius: Option<&mut [f64]>,
    ellipse: Option<&mut [[f64; 2]]>,
) -> Result<(), Error> {
    let n = curvatures.len();
    let counts = [("radius", rows_of(&radius, n)), ("ellipse", rows_of(&ellipse, n))];
    same_rows("pw85_hertz_batch", "must have as many rows as curvatures", n, &counts)?;
    check_rows(unsafe { sys::pw85_hertz_batch(
        n,
        curvatures.as_ptr().cast(),
        pointer(radius),
        pointer(ellipse),
    ) })
}

/// Computes the geometry of the contact of two grains along a given normal, for laws of contact
/// such as Hertz's.
///
/// Let n be the unit normal, and α and β the half-widths of the ellipsoids along n. The depth is
/// α + β - n·r12. A negative depth proves that the distance of the ellipsoids is at least its
/// magnitude. If the ellipsoids overlap, the depth is at least the depth of
/// [`penetration()`](crate::penetration), with equality if n is the direction of
/// [`penetration()`](crate::penetration). The usual choice of n is the normal of
/// [`contact_geometry()`](crate::contact_geometry). The depth is then (1/μ - 1) n·r12, a smooth
/// function of positions and orientations for μ \> 0. It exceeds the depth of
/// [`penetration()`](crate::penetration) by a term of second order in the depth.
///
/// The error of the depth is below 8 u Σ, with u = 2⁻⁵³ and Σ as for
/// [`distance()`](crate::distance) with this normal. The other bounds hold up to aspect ratio 10⁶
/// for the normal as given. The relative errors of curvatures, radius and ellipse are below
/// 1e-12. The point is half the sum of r12 and of one vector of each ellipsoid; its error is
/// below 1e-12 times the sum of the lengths of these vectors. The error of the directions is less
/// than 1e-12/(1 - k1/k2) radians, with the curvatures k1 \< k2.
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipsoid 1 to that of ellipsoid 2. Unit: length.
/// - `q1`, `q2`: Forms of the ellipsoids, in the square of the unit of `r12`. Unit: length².
/// - `normal`: Out of ellipsoid 1 and into ellipsoid 2, of any length; not zero.
///
/// # Errors
///
/// A number is not finite, a form is not positive definite or `normal` is zero.
///
/// # Examples
///
/// ```
/// let found = pw85::hertz_contact(
///     &[3.0, 0.5, 0.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
///     &[0.25, 0.0, 0.0, 0.25, 0.0, 0.25],
///     &[1.0, 0.0, 0.0],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn hertz_contact(
    r12: &[f64; 3],
    q1: &[f64; 6],
    q2: &[f64; 6],
    normal: &[f64; 3],
) -> Result<HertzContact, Error> {
    let mut depth = 0.0;
    let mut point = [0.0; 3];
    let mut curvatures = [0.0; 2];
    let mut directions = [[0.0; 3]; 2];
    let mut radius = 0.0;
    let mut ellipse = [0.0; 2];
    check(unsafe { sys::pw85_hertz_contact(
        r12.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        normal.as_ptr(),
        &mut depth,
        point.as_mut_ptr(),
        curvatures.as_mut_ptr(),
        directions.as_mut_ptr().cast(),
        &mut radius,
        ellipse.as_mut_ptr(),
    ) })?;
    Ok(HertzContact { depth, point, curvatures, directions, radius, ellipse })
}

/// Computes [`hertz_contact()`](crate::hertz_contact) for many pairs, with bitwise equal results.
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
/// - `normals`: Not zero.
/// - `depth`: Unit: length.
/// - `point`: Unit: length.
/// - `curvatures`: Unit: 1/length.
/// - `radius`: Unit: length.
/// - `ellipse`: Unit: length.
///
/// Row i of each slice belongs to row i of `r12`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5, 0.0]; 2];
/// let q1 = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let q2 = [[0.25, 0.0, 0.0, 0.25, 0.0, 0.25]; 2];
/// let normals = [[1.0, 0.0, 0.0]; 2];
/// let mut depth = [0.0; 2];
/// let mut point = [[0.0; 3]; 2];
/// let mut curvatures = [[0.0; 2]; 2];
/// let mut directions = [[[0.0; 3]; 2]; 2];
/// let mut radius = [0.0; 2];
/// let mut ellipse = [[0.0; 2]; 2];
/// pw85::hertz_contact_batch(
///     &r12,
///     &q1,
///     &q2,
///     &normals,
///     Some(&mut depth),
///     Some(&mut point),
///     Some(&mut curvatures),
///     Some(&mut directions),
///     Some(&mut radius),
///     Some(&mut ellipse),
/// )?;
/// assert_eq!(ellipse[0], ellipse[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn hertz_contact_batch(
    r12: &[[f64; 3]],
    q1: &[[f64; 6]],
    q2: &[[f64; 6]],
    normals: &[[f64; 3]],
    depth: Option<&mut [f64]>,
    point: Option<&mut [[f64; 3]]>,
    curvatures: Option<&mut [[f64; 2]]>,
    directions: Option<&mut [[[f64; 3]; 2]]>,
    radius: Option<&mut [f64]>,
    ellipse: Option<&mut [[f64; 2]]>,
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("q1", q1.len()),
        ("q2", q2.len()),
        ("normals", normals.len()),
        ("depth", rows_of(&depth, n)),
        ("point", rows_of(&point, n)),
        ("curvatures", rows_of(&curvatures, n)),
        ("directions", rows_of(&directions, n)),
        ("radius", rows_of(&radius, n)),
        ("ellipse", rows_of(&ellipse, n)),
    ];
    same_rows("pw85_hertz_contact_batch", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_hertz_contact_batch(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        normals.as_ptr().cast(),
        pointer(depth),
        pointer(point),
        pointer(curvatures),
        pointer(directions),
        pointer(radius),
        pointer(ellipse),
    ) })
}

/// Finds the common normal of two grains by Newton's method, and computes their contact along it.
///
/// Let α and β be the half-widths of the ellipsoids along the unit vector n. The normal is the n
/// at which the overlap δ(n) = α + β - n·r12 has a local minimum near a given direction. Since δ
/// is stationary there, a force U'(δ) n at the point conserves an energy U(δ). Start from the
/// normal of [`contact_geometry()`](crate::contact_geometry), or from that of the previous time
/// step. The search then takes one or two steps.
///
/// A minimum exists if the overlap is smaller than the least sum of radii of curvature. The
/// search ends after a step below 2⁻²² radians. At aspect ratios up to 4, the error of the normal
/// is less than 100·2⁻⁴⁴, and so are the errors of the point and the radius in units of the
/// semi-axes. The error of the depth is the square of this number, plus rounding.
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipsoid 1 to that of ellipsoid 2. Unit: length.
/// - `q1`, `q2`: Forms of the ellipsoids, in the square of the unit of `r12`. Unit: length².
/// - `start`: A direction near the normal, out of ellipsoid 1 and into ellipsoid 2, of any
///   length; not zero.
///
/// # Errors
///
/// A number is not finite, a form is not positive definite or `start` is zero.
/// `Status::NoConvergence`: the search finds no minimum.
///
/// # Examples
///
/// ```
/// let found = pw85::grain_contact(
///     &[3.0, 0.5, 0.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
///     &[0.25, 0.0, 0.0, 0.25, 0.0, 0.25],
///     &[1.0, 0.0, 0.0],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn grain_contact(
    r12: &[f64; 3],
    q1: &[f64; 6],
    q2: &[f64; 6],
    start: &[f64; 3],
) -> Result<GrainContact, Error> {
    let mut normal = [0.0; 3];
    let mut depth = 0.0;
    let mut point = [0.0; 3];
    let mut curvatures = [0.0; 2];
    let mut radius = 0.0;
    check(unsafe { sys::pw85_grain_contact(
        r12.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        start.as_ptr(),
        normal.as_mut_ptr(),
        &mut depth,
        point.as_mut_ptr(),
        curvatures.as_mut_ptr(),
        &mut radius,
    ) })?;
    Ok(GrainContact { normal, depth, point, curvatures, radius })
}

/// Computes [`grain_contact()`](crate::grain_contact) for many pairs.
///
/// The errors have the same bounds. The last bits may differ from those of
/// [`grain_contact()`](crate::grain_contact).
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
/// - `starts`: Not zero.
/// - `depth`: Unit: length.
/// - `point`: Unit: length.
/// - `curvatures`: Unit: 1/length.
/// - `radius`: Unit: length.
///
/// Row i of each slice belongs to row i of `r12`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5, 0.0]; 2];
/// let q1 = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let q2 = [[0.25, 0.0, 0.0, 0.25, 0.0, 0.25]; 2];
/// let starts = [[1.0, 0.0, 0.0]; 2];
/// let mut normal = [[0.0; 3]; 2];
/// let mut depth = [0.0; 2];
/// let mut point = [[0.0; 3]; 2];
/// let mut curvatures = [[0.0; 2]; 2];
/// let mut radius = [0.0; 2];
/// pw85::grain_contact_batch(
///     &r12,
///     &q1,
///     &q2,
///     &starts,
///     Some(&mut normal),
///     Some(&mut depth),
///     Some(&mut point),
///     Some(&mut curvatures),
///     Some(&mut radius),
/// )?;
/// assert_eq!(radius[0], radius[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn grain_contact_batch(
    r12: &[[f64; 3]],
    q1: &[[f64; 6]],
    q2: &[[f64; 6]],
    starts: &[[f64; 3]],
    normal: Option<&mut [[f64; 3]]>,
    depth: Option<&mut [f64]>,
    point: Option<&mut [[f64; 3]]>,
    curvatures: Option<&mut [[f64; 2]]>,
    radius: Option<&mut [f64]>,
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("q1", q1.len()),
        ("q2", q2.len()),
        ("starts", starts.len()),
        ("normal", rows_of(&normal, n)),
        ("depth", rows_of(&depth, n)),
        ("point", rows_of(&point, n)),
        ("curvatures", rows_of(&curvatures, n)),
        ("radius", rows_of(&radius, n)),
    ];
    same_rows("pw85_grain_contact_batch", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_grain_contact_batch(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        starts.as_ptr().cast(),
        pointer(normal),
        pointer(depth),
        pointer(point),
        pointer(curvatures),
        pointer(radius),
    ) })
}

/// Computes the derivatives of the radius of [`grain_contact()`](crate::grain_contact).
///
/// They include the change of the normal with the motion. A force that depends on the radius
/// needs these derivatives to conserve the energy.
///
/// # Arguments
///
/// - `r12`: Vector from the centre of ellipsoid 1 to that of ellipsoid 2. Unit: length.
/// - `q1`, `q2`: Forms of the ellipsoids, in the square of the unit of `r12`. Unit: length².
/// - `normal`: That of [`grain_contact()`](crate::grain_contact), of any length; not zero.
///
/// # Errors
///
/// A number is not finite, a form is not positive definite or `normal` is zero.
/// `Status::NoConvergence`: the overlap has no minimum there.
///
/// # Examples
///
/// ```
/// let found = pw85::grain_radius_gradient(
///     &[3.0, 0.5, 0.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
///     &[0.25, 0.0, 0.0, 0.25, 0.0, 0.25],
///     &[1.0, 0.0, 0.0],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn grain_radius_gradient(
    r12: &[f64; 3],
    q1: &[f64; 6],
    q2: &[f64; 6],
    normal: &[f64; 3],
) -> Result<GrainRadiusGradient, Error> {
    let mut d_r12 = [0.0; 3];
    let mut d_rot1 = [0.0; 3];
    let mut d_rot2 = [0.0; 3];
    check(unsafe { sys::pw85_grain_radius_gradient(
        r12.as_ptr(),
        q1.as_ptr(),
        q2.as_ptr(),
        normal.as_ptr(),
        d_r12.as_mut_ptr(),
        d_rot1.as_mut_ptr(),
        d_rot2.as_mut_ptr(),
    ) })?;
    Ok(GrainRadiusGradient { d_r12, d_rot1, d_rot2 })
}

/// Computes [`grain_radius_gradient()`](crate::grain_radius_gradient) for many pairs, with
/// bitwise equal results.
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
/// - `normals`: Not zero.
/// - `d_rot1`, `d_rot2`: Unit: length.
///
/// Row i of each slice belongs to row i of `r12`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5, 0.0]; 2];
/// let q1 = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let q2 = [[0.25, 0.0, 0.0, 0.25, 0.0, 0.25]; 2];
/// let normals = [[1.0, 0.0, 0.0]; 2];
/// let mut d_r12 = [[0.0; 3]; 2];
/// let mut d_rot1 = [[0.0; 3]; 2];
/// let mut d_rot2 = [[0.0; 3]; 2];
/// pw85::grain_radius_gradient_batch(
///     &r12,
///     &q1,
///     &q2,
///     &normals,
///     Some(&mut d_r12),
///     Some(&mut d_rot1),
///     Some(&mut d_rot2),
/// )?;
/// assert_eq!(d_rot2[0], d_rot2[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn grain_radius_gradient_batch(
    r12: &[[f64; 3]],
    q1: &[[f64; 6]],
    q2: &[[f64; 6]],
    normals: &[[f64; 3]],
    d_r12: Option<&mut [[f64; 3]]>,
    d_rot1: Option<&mut [[f64; 3]]>,
    d_rot2: Option<&mut [[f64; 3]]>,
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("q1", q1.len()),
        ("q2", q2.len()),
        ("normals", normals.len()),
        ("d_r12", rows_of(&d_r12, n)),
        ("d_rot1", rows_of(&d_rot1, n)),
        ("d_rot2", rows_of(&d_rot2, n)),
    ];
    same_rows("pw85_grain_radius_gradient_batch", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_grain_radius_gradient_batch(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        normals.as_ptr().cast(),
        pointer(d_r12),
        pointer(d_rot1),
        pointer(d_rot2),
    ) })
}

/// Computes the contact of a grain with its centre at 0 and a wall.
///
/// The wall is tangent to the plane normal·x = offset and is curved along at most one direction:
/// it is a plane, or a cylinder from inside or outside.
///
/// The relative errors of both curvatures and of the radius are below 1e-12 for the numbers as
/// given, up to aspect ratio 10⁶, also where the curvatures nearly cancel. The function computes
/// in double-double arithmetic, with twice the digits, in two cases: the aspect ratio is above
/// about 10; or the wall is concave (curvature \< 0), and the product of both curvatures of the
/// gap is less than half of the product of the curvatures of the ellipsoid.
///
/// # Arguments
///
/// - `normal`: Into the half-space, of any length; not zero.
/// - `offset`: In the unit of normal·x. For a unit normal it is the signed distance from 0 to the
///   plane. Unit: length.
/// - `direction`: Perpendicular to the normal, of any length, along which the wall is curved; not
///   zero.
/// - `curvature`: Of the wall along `direction`: positive if the wall is convex, 0 for a plane.
///   Unit: 1/length.
/// - `q`: Form of the ellipsoid. Unit: length².
///
/// # Errors
///
/// A number is not finite, a form is not positive definite, `normal` is zero or `direction` is
/// zero.
///
/// # Examples
///
/// ```
/// let found = pw85::grain_contact_wall(
///     &[1.0, 0.0, 0.0],
///     5.0,
///     &[1.0, 0.0, 0.0],
///     0.5,
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn grain_contact_wall(
    normal: &[f64; 3],
    offset: f64,
    direction: &[f64; 3],
    curvature: f64,
    q: &[f64; 6],
) -> Result<GrainWallContact, Error> {
    let mut depth = 0.0;
    let mut point = [0.0; 3];
    let mut curvatures = [0.0; 2];
    let mut radius = 0.0;
    check(unsafe { sys::pw85_grain_contact_wall(
        normal.as_ptr(),
        offset,
        direction.as_ptr(),
        curvature,
        q.as_ptr(),
        &mut depth,
        point.as_mut_ptr(),
        curvatures.as_mut_ptr(),
        &mut radius,
    ) })?;
    Ok(GrainWallContact { depth, point, curvatures, radius })
}

/// Computes [`grain_contact_wall()`](crate::grain_contact_wall) for many ellipsoids and walls,
/// with bitwise equal results.
///
/// # Arguments
///
/// - `normals`: Not zero.
/// - `offsets`: Unit: length.
/// - `directions`: Not zero.
/// - `curvature`: Unit: 1/length.
/// - `q`: Unit: length².
/// - `depth`: Unit: length.
/// - `point`: Unit: length.
/// - `curvatures`: Unit: 1/length.
/// - `radius`: Unit: length.
///
/// Row i of each slice belongs to row i of `normals`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `normals`, or a row is refused. The outputs of such rows are
/// NaN, 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let normals = [[1.0, 0.0, 0.0]; 2];
/// let offsets = [5.0; 2];
/// let directions = [[1.0, 0.0, 0.0]; 2];
/// let curvature = [0.5; 2];
/// let q = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let mut depth = [0.0; 2];
/// let mut point = [[0.0; 3]; 2];
/// let mut curvatures = [[0.0; 2]; 2];
/// let mut radius = [0.0; 2];
/// pw85::grain_contact_wall_batch(
///     &normals,
///     &offsets,
///     &directions,
///     &curvature,
///     &q,
///     Some(&mut depth),
///     Some(&mut point),
///     Some(&mut curvatures),
///     Some(&mut radius),
/// )?;
/// assert_eq!(radius[0], radius[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn grain_contact_wall_batch(
    normals: &[[f64; 3]],
    offsets: &[f64],
    directions: &[[f64; 3]],
    curvature: &[f64],
    q: &[[f64; 6]],
    depth: Option<&mut [f64]>,
    point: Option<&mut [[f64; 3]]>,
    curvatures: Option<&mut [[f64; 2]]>,
    radius: Option<&mut [f64]>,
) -> Result<(), Error> {
    let n = normals.len();
    let counts = [
        ("offsets", offsets.len()),
        ("directions", directions.len()),
        ("curvature", curvature.len()),
        ("q", q.len()),
        ("depth", rows_of(&depth, n)),
        ("point", rows_of(&point, n)),
        ("curvatures", rows_of(&curvatures, n)),
        ("radius", rows_of(&radius, n)),
    ];
    same_rows("pw85_grain_contact_wall_batch", "must have as many rows as normals", n, &counts)?;
    check_rows(unsafe { sys::pw85_grain_contact_wall_batch(
        n,
        normals.as_ptr().cast(),
        offsets.as_ptr(),
        directions.as_ptr().cast(),
        curvature.as_ptr(),
        q.as_ptr().cast(),
        pointer(depth),
        pointer(point),
        pointer(curvatures),
        pointer(radius),
    ) })
}

/// Computes the surface area of an ellipsoid, 4π abc R_G(1/a², 1/b², 1/c²), with Carlson's
/// integral R_G.
///
/// # Arguments
///
/// - `q`: Form of the ellipsoid. Unit: length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite.
///
/// # Examples
///
/// ```
/// let found = pw85::surface_area(&[9.0, 0.0, 0.0, 4.0, 0.0, 1.0])?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn surface_area(q: &[f64; 6]) -> Result<f64, Error> {
    let mut area = 0.0;
    check(unsafe { sys::pw85_surface_area(q.as_ptr(), &mut area) })?;
    Ok(area)
}

/// Computes [`surface_area()`](crate::surface_area) for many ellipsoids, with bitwise equal
/// results.
///
/// # Arguments
///
/// - `q`: Unit: length².
/// - `area`: Unit: length².
///
/// Row i of each slice belongs to row i of `q`.
///
/// # Errors
///
/// A slice has not as many rows as `q`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let q = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let mut area = [0.0; 2];
/// pw85::surface_area_batch(&q, &mut area)?;
/// assert_eq!(area[0], area[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn surface_area_batch(q: &[[f64; 6]], area: &mut [f64]) -> Result<(), Error> {
    let n = q.len();
    let counts = [("area", area.len())];
    same_rows("pw85_surface_area_batch", "must have as many rows as q", n, &counts)?;
    check_rows(unsafe { sys::pw85_surface_area_batch(n, q.as_ptr().cast(), area.as_mut_ptr()) })
}

/// Computes the mean of x xᵀ over a uniform solid ellipsoid, about its centre: q/5.
///
/// The error of each entry is below u times the entry, with u = 2⁻⁵³.
///
/// # Arguments
///
/// - `q`: Form of the ellipsoid. Unit: length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite.
///
/// # Examples
///
/// ```
/// let found = pw85::second_moments(&[9.0, 0.0, 0.0, 4.0, 0.0, 1.0])?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn second_moments(q: &[f64; 6]) -> Result<[f64; 6], Error> {
    let mut moments = [0.0; 6];
    check(unsafe { sys::pw85_second_moments(q.as_ptr(), moments.as_mut_ptr()) })?;
    Ok(moments)
}

/// Computes [`second_moments()`](crate::second_moments) for many ellipsoids, with bitwise equal
/// results.
///
/// # Arguments
///
/// - `q`, `moments`: Unit: length².
///
/// Row i of each slice belongs to row i of `q`.
///
/// # Errors
///
/// A slice has not as many rows as `q`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let q = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let mut moments = [[0.0; 6]; 2];
/// pw85::second_moments_batch(&q, &mut moments)?;
/// assert_eq!(moments[0], moments[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn second_moments_batch(q: &[[f64; 6]], moments: &mut [[f64; 6]]) -> Result<(), Error> {
    let n = q.len();
    let counts = [("moments", moments.len())];
    same_rows("pw85_second_moments_batch", "must have as many rows as q", n, &counts)?;
    check_rows(unsafe { sys::pw85_second_moments_batch(
        n,
        q.as_ptr().cast(),
        moments.as_mut_ptr().cast(),
    ) })
}

/// Computes the mean of x xᵀ over the surface of an ellipsoid, about its centre: the second
/// moments of a shell.
///
/// # Arguments
///
/// - `q`: Form of the ellipsoid. Unit: length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite.
///
/// # Examples
///
/// ```
/// let found = pw85::shell_moments(&[9.0, 0.0, 0.0, 4.0, 0.0, 1.0])?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn shell_moments(q: &[f64; 6]) -> Result<[f64; 6], Error> {
    let mut moments = [0.0; 6];
    check(unsafe { sys::pw85_shell_moments(q.as_ptr(), moments.as_mut_ptr()) })?;
    Ok(moments)
}

/// Computes [`shell_moments()`](crate::shell_moments) for many ellipsoids, with bitwise equal
/// results.
///
/// # Arguments
///
/// - `q`, `moments`: Unit: length².
///
/// Row i of each slice belongs to row i of `q`.
///
/// # Errors
///
/// A slice has not as many rows as `q`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let q = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let mut moments = [[0.0; 6]; 2];
/// pw85::shell_moments_batch(&q, &mut moments)?;
/// assert_eq!(moments[0], moments[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn shell_moments_batch(q: &[[f64; 6]], moments: &mut [[f64; 6]]) -> Result<(), Error> {
    let n = q.len();
    let counts = [("moments", moments.len())];
    same_rows("pw85_shell_moments_batch", "must have as many rows as q", n, &counts)?;
    check_rows(unsafe { sys::pw85_shell_moments_batch(
        n,
        q.as_ptr().cast(),
        moments.as_mut_ptr().cast(),
    ) })
}

/// Computes the perimeter of an ellipse, 8 R_G(0, a², b²), with Carlson's integral R_G.
///
/// # Arguments
///
/// - `q`: Form of the ellipse. Unit: length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite.
///
/// # Examples
///
/// ```
/// let found = pw85::perimeter_2d(&[9.0, 0.0, 4.0])?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn perimeter_2d(q: &[f64; 3]) -> Result<f64, Error> {
    let mut perimeter = 0.0;
    check(unsafe { sys::pw85_perimeter_2d(q.as_ptr(), &mut perimeter) })?;
    Ok(perimeter)
}

/// Computes [`perimeter_2d()`](crate::perimeter_2d) for many ellipses, with bitwise equal
/// results.
///
/// # Arguments
///
/// - `q`: Unit: length².
/// - `perimeter`: Unit: length.
///
/// Row i of each slice belongs to row i of `q`.
///
/// # Errors
///
/// A slice has not as many rows as `q`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let q = [[9.0, 0.0, 4.0]; 2];
/// let mut perimeter = [0.0; 2];
/// pw85::perimeter_batch_2d(&q, &mut perimeter)?;
/// assert_eq!(perimeter[0], perimeter[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn perimeter_batch_2d(q: &[[f64; 3]], perimeter: &mut [f64]) -> Result<(), Error> {
    let n = q.len();
    let counts = [("perimeter", perimeter.len())];
    same_rows("pw85_perimeter_batch_2d", "must have as many rows as q", n, &counts)?;
    check_rows(unsafe { sys::pw85_perimeter_batch_2d(
        n,
        q.as_ptr().cast(),
        perimeter.as_mut_ptr(),
    ) })
}

/// Computes the mean of x xᵀ over a uniform ellipse, about its centre: q/4.
///
/// For mass 1, its trace is the moment of inertia about the axis perpendicular to the plane.
///
/// # Arguments
///
/// - `q`: Form of the ellipse. Unit: length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite.
///
/// # Examples
///
/// ```
/// let found = pw85::second_moments_2d(&[9.0, 0.0, 4.0])?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn second_moments_2d(q: &[f64; 3]) -> Result<[f64; 3], Error> {
    let mut moments = [0.0; 3];
    check(unsafe { sys::pw85_second_moments_2d(q.as_ptr(), moments.as_mut_ptr()) })?;
    Ok(moments)
}

/// Computes [`second_moments_2d()`](crate::second_moments_2d) for many ellipses, with bitwise
/// equal results.
///
/// # Arguments
///
/// - `q`, `moments`: Unit: length².
///
/// Row i of each slice belongs to row i of `q`.
///
/// # Errors
///
/// A slice has not as many rows as `q`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let q = [[9.0, 0.0, 4.0]; 2];
/// let mut moments = [[0.0; 3]; 2];
/// pw85::second_moments_batch_2d(&q, &mut moments)?;
/// assert_eq!(moments[0], moments[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn second_moments_batch_2d(q: &[[f64; 3]], moments: &mut [[f64; 3]]) -> Result<(), Error> {
    let n = q.len();
    let counts = [("moments", moments.len())];
    same_rows("pw85_second_moments_batch_2d", "must have as many rows as q", n, &counts)?;
    check_rows(unsafe { sys::pw85_second_moments_batch_2d(
        n,
        q.as_ptr().cast(),
        moments.as_mut_ptr().cast(),
    ) })
}

/// Computes the mean of x xᵀ over the perimeter of an ellipse, about its centre: the second
/// moments of a wire.
///
/// # Arguments
///
/// - `q`: Form of the ellipse. Unit: length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite.
///
/// # Examples
///
/// ```
/// let found = pw85::shell_moments_2d(&[9.0, 0.0, 4.0])?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn shell_moments_2d(q: &[f64; 3]) -> Result<[f64; 3], Error> {
    let mut moments = [0.0; 3];
    check(unsafe { sys::pw85_shell_moments_2d(q.as_ptr(), moments.as_mut_ptr()) })?;
    Ok(moments)
}

/// Computes [`shell_moments_2d()`](crate::shell_moments_2d) for many ellipses, with bitwise equal
/// results.
///
/// # Arguments
///
/// - `q`, `moments`: Unit: length².
///
/// Row i of each slice belongs to row i of `q`.
///
/// # Errors
///
/// A slice has not as many rows as `q`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let q = [[9.0, 0.0, 4.0]; 2];
/// let mut moments = [[0.0; 3]; 2];
/// pw85::shell_moments_batch_2d(&q, &mut moments)?;
/// assert_eq!(moments[0], moments[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn shell_moments_batch_2d(q: &[[f64; 3]], moments: &mut [[f64; 3]]) -> Result<(), Error> {
    let n = q.len();
    let counts = [("moments", moments.len())];
    same_rows("pw85_shell_moments_batch_2d", "must have as many rows as q", n, &counts)?;
    check_rows(unsafe { sys::pw85_shell_moments_batch_2d(
        n,
        q.as_ptr().cast(),
        moments.as_mut_ptr().cast(),
    ) })
}

/// Computes the distance from an ellipsoid with its centre at 0 to the half-space normal·x \>=
/// offset.
///
/// The distance is (offset - α)/\|normal\| with α = √(normalᵀ q normal).
///
/// # Arguments
///
/// - `normal`: Into the half-space, of any length; not zero.
/// - `offset`: In the unit of normal·x. For a unit normal it is the signed distance from 0 to the
///   plane; for another normal it is \|normal\| times this distance. It is negative if the centre
///   is in the half-space. Unit: length.
/// - `q`: Form of the ellipsoid. Unit: length².
///
/// # Errors
///
/// A number is not finite, a form is not positive definite or `normal` is zero.
///
/// # Examples
///
/// ```
/// let found = pw85::distance_plane(&[1.0, 0.0, 0.0], 5.0, &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0])?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn distance_plane(
    normal: &[f64; 3],
    offset: f64,
    q: &[f64; 6],
) -> Result<SurfaceDistance, Error> {
    let mut distance = 0.0;
    let mut point = [0.0; 3];
    check(unsafe { sys::pw85_distance_plane(
        normal.as_ptr(),
        offset,
        q.as_ptr(),
        &mut distance,
        point.as_mut_ptr(),
    ) })?;
    Ok(SurfaceDistance { distance, point })
}

/// Computes [`distance_plane()`](crate::distance_plane) for many ellipsoids and half-spaces, with
/// bitwise equal results.
///
/// # Arguments
///
/// - `normals`: Not zero.
/// - `offsets`: Unit: length.
/// - `q`: Unit: length².
/// - `distance`: Unit: length.
/// - `point`: Unit: length.
///
/// Row i of each slice belongs to row i of `normals`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `normals`, or a row is refused. The outputs of such rows are
/// NaN, 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let normals = [[1.0, 0.0, 0.0]; 2];
/// let offsets = [5.0; 2];
/// let q = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let mut distance = [0.0; 2];
/// let mut point = [[0.0; 3]; 2];
/// pw85::distance_plane_batch(&normals, &offsets, &q, Some(&mut distance), Some(&mut point))?;
/// assert_eq!(point[0], point[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn distance_plane_batch(
    normals: &[[f64; 3]],
    offsets: &[f64],
    q: &[[f64; 6]],
    distance: Option<&mut [f64]>,
    point: Option<&mut [[f64; 3]]>,
) -> Result<(), Error> {
    let n = normals.len();
    let counts = [
        ("offsets", offsets.len()),
        ("q", q.len()),
        ("distance", rows_of(&distance, n)),
        ("point", rows_of(&point, n)),
    ];
    same_rows("pw85_distance_plane_batch", "must have as many rows as normals", n, &counts)?;
    check_rows(unsafe { sys::pw85_distance_plane_batch(
        n,
        normals.as_ptr().cast(),
        offsets.as_ptr(),
        q.as_ptr().cast(),
        pointer(distance),
        pointer(point),
    ) })
}

/// Computes the derivatives of the distance to a half-space, which do not depend on its offset.
///
/// The derivatives are -n and n × point, with the unit normal n and the point of
/// [`distance_plane()`](crate::distance_plane).
///
/// # Arguments
///
/// - `normal`: Into the half-space, of any length; not zero.
/// - `q`: Form of the ellipsoid. Unit: length².
///
/// # Errors
///
/// A number is not finite, a form is not positive definite or `normal` is zero.
///
/// # Examples
///
/// ```
/// let found = pw85::distance_plane_derivatives(&[1.0, 0.0, 0.0], &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0])?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn distance_plane_derivatives(
    normal: &[f64; 3],
    q: &[f64; 6],
) -> Result<PlaneDerivatives, Error> {
    let mut d_center = [0.0; 3];
    let mut d_rot = [0.0; 3];
    check(unsafe { sys::pw85_distance_plane_derivatives(
        normal.as_ptr(),
        q.as_ptr(),
        d_center.as_mut_ptr(),
        d_rot.as_mut_ptr(),
    ) })?;
    Ok(PlaneDerivatives { d_center, d_rot })
}

/// Computes [`distance_plane_derivatives()`](crate::distance_plane_derivatives) for many
/// ellipsoids and half-spaces, with bitwise equal results.
///
/// # Arguments
///
/// - `normals`: Not zero.
/// - `q`: Unit: length².
/// - `d_rot`: Unit: length.
///
/// Row i of each slice belongs to row i of `normals`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `normals`, or a row is refused. The outputs of such rows are
/// NaN, 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let normals = [[1.0, 0.0, 0.0]; 2];
/// let q = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let mut d_center = [[0.0; 3]; 2];
/// let mut d_rot = [[0.0; 3]; 2];
/// pw85::distance_plane_derivatives_batch(&normals, &q, Some(&mut d_center), Some(&mut d_rot))?;
/// assert_eq!(d_rot[0], d_rot[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn distance_plane_derivatives_batch(
    normals: &[[f64; 3]],
    q: &[[f64; 6]],
    d_center: Option<&mut [[f64; 3]]>,
    d_rot: Option<&mut [[f64; 3]]>,
) -> Result<(), Error> {
    let n = normals.len();
    let counts = [
        ("q", q.len()),
        ("d_center", rows_of(&d_center, n)),
        ("d_rot", rows_of(&d_rot, n)),
    ];
    same_rows("pw85_distance_plane_derivatives_batch", "must have as many rows as normals", n, &counts)?;
    check_rows(unsafe { sys::pw85_distance_plane_derivatives_batch(
        n,
        normals.as_ptr().cast(),
        q.as_ptr().cast(),
        pointer(d_center),
        pointer(d_rot),
    ) })
}

/// Computes the contact function of an ellipsoid with its centre at 0 and the half-space normal·x
/// \>= offset.
///
/// # Arguments
///
/// - `normal`: Into the half-space, of any length; not zero.
/// - `offset`: In the unit of normal·x. For a unit normal it is the signed distance from 0 to the
///   plane. Unit: length.
/// - `q`: Form of the ellipsoid. Unit: length².
///
/// # Errors
///
/// A number is not finite, a form is not positive definite or `normal` is zero.
///
/// # Examples
///
/// ```
/// let found = pw85::contact_plane(&[1.0, 0.0, 0.0], 5.0, &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0])?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn contact_plane(normal: &[f64; 3], offset: f64, q: &[f64; 6]) -> Result<PlaneContact, Error> {
    let mut mu2 = 0.0;
    let mut point = [0.0; 3];
    check(unsafe { sys::pw85_contact_plane(
        normal.as_ptr(),
        offset,
        q.as_ptr(),
        &mut mu2,
        point.as_mut_ptr(),
    ) })?;
    Ok(PlaneContact { mu2, point })
}

/// Computes [`contact_plane()`](crate::contact_plane) for many ellipsoids and half-spaces, with
/// bitwise equal results.
///
/// # Arguments
///
/// - `normals`: Not zero.
/// - `offsets`: Unit: length.
/// - `q`: Unit: length².
/// - `point`: Unit: length.
///
/// Row i of each slice belongs to row i of `normals`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `normals`, or a row is refused. The outputs of such rows are
/// NaN, 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let normals = [[1.0, 0.0, 0.0]; 2];
/// let offsets = [5.0; 2];
/// let q = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let mut mu2 = [0.0; 2];
/// let mut point = [[0.0; 3]; 2];
/// pw85::contact_plane_batch(&normals, &offsets, &q, Some(&mut mu2), Some(&mut point))?;
/// assert_eq!(point[0], point[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn contact_plane_batch(
    normals: &[[f64; 3]],
    offsets: &[f64],
    q: &[[f64; 6]],
    mu2: Option<&mut [f64]>,
    point: Option<&mut [[f64; 3]]>,
) -> Result<(), Error> {
    let n = normals.len();
    let counts = [
        ("offsets", offsets.len()),
        ("q", q.len()),
        ("mu2", rows_of(&mu2, n)),
        ("point", rows_of(&point, n)),
    ];
    same_rows("pw85_contact_plane_batch", "must have as many rows as normals", n, &counts)?;
    check_rows(unsafe { sys::pw85_contact_plane_batch(
        n,
        normals.as_ptr().cast(),
        offsets.as_ptr(),
        q.as_ptr().cast(),
        pointer(mu2),
        pointer(point),
    ) })
}

/// Computes the derivatives of μ² of [`contact_plane()`](crate::contact_plane).
///
/// The derivatives are -2μ n/α and 2μ² (n × p)/α, with the normal n as given, the point p of the
/// ellipsoid that is nearest to the half-space, and α = n·p. They are zero if the centre is in
/// the half-space.
///
/// # Arguments
///
/// - `normal`: Into the half-space, of any length; not zero.
/// - `offset`: In the unit of normal·x. For a unit normal it is the signed distance from 0 to the
///   plane. Unit: length.
/// - `q`: Form of the ellipsoid. Unit: length².
///
/// # Errors
///
/// A number is not finite, a form is not positive definite or `normal` is zero.
///
/// # Examples
///
/// ```
/// let found = pw85::contact_plane_derivatives(
///     &[1.0, 0.0, 0.0],
///     5.0,
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn contact_plane_derivatives(
    normal: &[f64; 3],
    offset: f64,
    q: &[f64; 6],
) -> Result<PlaneDerivatives, Error> {
    let mut d_center = [0.0; 3];
    let mut d_rot = [0.0; 3];
    check(unsafe { sys::pw85_contact_plane_derivatives(
        normal.as_ptr(),
        offset,
        q.as_ptr(),
        d_center.as_mut_ptr(),
        d_rot.as_mut_ptr(),
    ) })?;
    Ok(PlaneDerivatives { d_center, d_rot })
}

/// Computes [`contact_plane_derivatives()`](crate::contact_plane_derivatives) for many ellipsoids
/// and half-spaces, with bitwise equal results.
///
/// # Arguments
///
/// - `normals`: Not zero.
/// - `offsets`: Unit: length.
/// - `q`: Unit: length².
/// - `d_center`: Unit: 1/length.
///
/// Row i of each slice belongs to row i of `normals`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `normals`, or a row is refused. The outputs of such rows are
/// NaN, 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let normals = [[1.0, 0.0, 0.0]; 2];
/// let offsets = [5.0; 2];
/// let q = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let mut d_center = [[0.0; 3]; 2];
/// let mut d_rot = [[0.0; 3]; 2];
/// pw85::contact_plane_derivatives_batch(
///     &normals,
///     &offsets,
///     &q,
///     Some(&mut d_center),
///     Some(&mut d_rot),
/// )?;
/// assert_eq!(d_rot[0], d_rot[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn contact_plane_derivatives_batch(
    normals: &[[f64; 3]],
    offsets: &[f64],
    q: &[[f64; 6]],
    d_center: Option<&mut [[f64; 3]]>,
    d_rot: Option<&mut [[f64; 3]]>,
) -> Result<(), Error> {
    let n = normals.len();
    let counts = [
        ("offsets", offsets.len()),
        ("q", q.len()),
        ("d_center", rows_of(&d_center, n)),
        ("d_rot", rows_of(&d_rot, n)),
    ];
    same_rows("pw85_contact_plane_derivatives_batch", "must have as many rows as normals", n, &counts)?;
    check_rows(unsafe { sys::pw85_contact_plane_derivatives_batch(
        n,
        normals.as_ptr().cast(),
        offsets.as_ptr(),
        q.as_ptr().cast(),
        pointer(d_center),
        pointer(d_rot),
    ) })
}

/// Computes the distance from an ellipsoid with its centre at 0 to the nearest face of a box that
/// contains it.
///
/// For a box that is an obstacle, see [`distance_solid_box()`](crate::distance_solid_box).
///
/// # Arguments
///
/// - `lower`, `upper`: Corners of the box, relative to the centre of the ellipsoid; `lower` \<=
///   `upper`. Unit: length.
/// - `q`: Form of the ellipsoid. Unit: length².
///
/// # Errors
///
/// A number is not finite, a form is not positive definite or `lower` is larger than `upper`.
///
/// # Examples
///
/// ```
/// let found = pw85::distance_box(
///     &[2.0, -1.0, -1.0],
///     &[4.0, 1.0, 1.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn distance_box(
    lower: &[f64; 3],
    upper: &[f64; 3],
    q: &[f64; 6],
) -> Result<DistanceBox, Error> {
    let mut distance = 0.0;
    let mut point = [0.0; 3];
    let mut normal = [0.0; 3];
    check(unsafe { sys::pw85_distance_box(
        lower.as_ptr(),
        upper.as_ptr(),
        q.as_ptr(),
        &mut distance,
        point.as_mut_ptr(),
        normal.as_mut_ptr(),
    ) })?;
    Ok(DistanceBox { distance, point, normal })
}

/// Computes [`distance_box()`](crate::distance_box) for many ellipsoids and boxes, with bitwise
/// equal results.
///
/// # Arguments
///
/// - `lower`, `upper`: `lower` \<= `upper`. Unit: length.
/// - `q`: Unit: length².
/// - `distance`: Unit: length.
/// - `point`: Unit: length.
///
/// Row i of each slice belongs to row i of `lower`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `lower`, or a row is refused. The outputs of such rows are
/// NaN, 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let lower = [[2.0, -1.0, -1.0]; 2];
/// let upper = [[4.0, 1.0, 1.0]; 2];
/// let q = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let mut distance = [0.0; 2];
/// let mut point = [[0.0; 3]; 2];
/// let mut normal = [[0.0; 3]; 2];
/// pw85::distance_box_batch(
///     &lower,
///     &upper,
///     &q,
///     Some(&mut distance),
///     Some(&mut point),
///     Some(&mut normal),
/// )?;
/// assert_eq!(normal[0], normal[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn distance_box_batch(
    lower: &[[f64; 3]],
    upper: &[[f64; 3]],
    q: &[[f64; 6]],
    distance: Option<&mut [f64]>,
    point: Option<&mut [[f64; 3]]>,
    normal: Option<&mut [[f64; 3]]>,
) -> Result<(), Error> {
    let n = lower.len();
    let counts = [
        ("upper", upper.len()),
        ("q", q.len()),
        ("distance", rows_of(&distance, n)),
        ("point", rows_of(&point, n)),
        ("normal", rows_of(&normal, n)),
    ];
    same_rows("pw85_distance_box_batch", "must have as many rows as lower", n, &counts)?;
    check_rows(unsafe { sys::pw85_distance_box_batch(
        n,
        lower.as_ptr().cast(),
        upper.as_ptr().cast(),
        q.as_ptr().cast(),
        pointer(distance),
        pointer(point),
        pointer(normal),
    ) })
}

/// Computes the distance from an ellipsoid to the wall of a cylinder of infinite length that
/// contains it.
///
/// # Arguments
///
/// - `axis`: Direction of the axis of the cylinder, which goes through 0; of any length; not
///   zero.
/// - `radius`: Of the cylinder; \> 0. Unit: length.
/// - `center`: Of the ellipsoid. Unit: length.
/// - `q`: Form of the ellipsoid. Unit: length².
///
/// # Errors
///
/// A number is not finite, a form is not positive definite, `radius` is not positive or `axis` is
/// zero.
///
/// # Examples
///
/// ```
/// let found = pw85::distance_cylinder(
///     &[1.0, 0.0, 0.0],
///     99.0,
///     &[8.0, 8.0, 8.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn distance_cylinder(
    axis: &[f64; 3],
    radius: f64,
    center: &[f64; 3],
    q: &[f64; 6],
) -> Result<DistanceCylinder, Error> {
    let mut distance = 0.0;
    let mut point = [0.0; 3];
    let mut normal = [0.0; 3];
    check(unsafe { sys::pw85_distance_cylinder(
        axis.as_ptr(),
        radius,
        center.as_ptr(),
        q.as_ptr(),
        &mut distance,
        point.as_mut_ptr(),
        normal.as_mut_ptr(),
    ) })?;
    Ok(DistanceCylinder { distance, point, normal })
}

/// Computes [`distance_cylinder()`](crate::distance_cylinder) for many ellipsoids and cylinders,
/// with bitwise equal results.
///
/// # Arguments
///
/// - `axis`: Not zero.
/// - `radius`: \> 0. Unit: length.
/// - `center`: Unit: length.
/// - `q`: Unit: length².
/// - `distance`: Unit: length.
/// - `point`: Unit: length.
///
/// Row i of each slice belongs to row i of `axis`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `axis`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let axis = [[1.0, 0.0, 0.0]; 2];
/// let radius = [99.0; 2];
/// let center = [[8.0, 8.0, 8.0]; 2];
/// let q = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let mut distance = [0.0; 2];
/// let mut point = [[0.0; 3]; 2];
/// let mut normal = [[0.0; 3]; 2];
/// pw85::distance_cylinder_batch(
///     &axis,
///     &radius,
///     &center,
///     &q,
///     Some(&mut distance),
///     Some(&mut point),
///     Some(&mut normal),
/// )?;
/// assert_eq!(normal[0], normal[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn distance_cylinder_batch(
    axis: &[[f64; 3]],
    radius: &[f64],
    center: &[[f64; 3]],
    q: &[[f64; 6]],
    distance: Option<&mut [f64]>,
    point: Option<&mut [[f64; 3]]>,
    normal: Option<&mut [[f64; 3]]>,
) -> Result<(), Error> {
    let n = axis.len();
    let counts = [
        ("radius", radius.len()),
        ("center", center.len()),
        ("q", q.len()),
        ("distance", rows_of(&distance, n)),
        ("point", rows_of(&point, n)),
        ("normal", rows_of(&normal, n)),
    ];
    same_rows("pw85_distance_cylinder_batch", "must have as many rows as axis", n, &counts)?;
    check_rows(unsafe { sys::pw85_distance_cylinder_batch(
        n,
        axis.as_ptr().cast(),
        radius.as_ptr(),
        center.as_ptr().cast(),
        q.as_ptr().cast(),
        pointer(distance),
        pointer(point),
        pointer(normal),
    ) })
}

/// Computes the distance from a point to the surface of an ellipsoid.
///
/// # Arguments
///
/// - `r`: The point, relative to the centre of the ellipsoid. Unit: length.
/// - `q`: Form of the ellipsoid. Unit: length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite.
///
/// # Examples
///
/// ```
/// let found = pw85::distance_point(&[4.0, 2.0, 1.0], &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0])?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn distance_point(r: &[f64; 3], q: &[f64; 6]) -> Result<DistancePoint, Error> {
    let mut distance = 0.0;
    let mut point = [0.0; 3];
    let mut normal = [0.0; 3];
    check(unsafe { sys::pw85_distance_point(
        r.as_ptr(),
        q.as_ptr(),
        &mut distance,
        point.as_mut_ptr(),
        normal.as_mut_ptr(),
    ) })?;
    Ok(DistancePoint { distance, point, normal })
}

/// Computes [`distance_point()`](crate::distance_point) for many points and ellipsoids, with
/// bitwise equal results.
///
/// # Arguments
///
/// - `r`: Unit: length.
/// - `q`: Unit: length².
/// - `distance`: Unit: length.
/// - `point`: Unit: length.
///
/// Row i of each slice belongs to row i of `r`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `r`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r = [[4.0, 2.0, 1.0]; 2];
/// let q = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let mut distance = [0.0; 2];
/// let mut point = [[0.0; 3]; 2];
/// let mut normal = [[0.0; 3]; 2];
/// pw85::distance_point_batch(&r, &q, Some(&mut distance), Some(&mut point), Some(&mut normal))?;
/// assert_eq!(normal[0], normal[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn distance_point_batch(
    r: &[[f64; 3]],
    q: &[[f64; 6]],
    distance: Option<&mut [f64]>,
    point: Option<&mut [[f64; 3]]>,
    normal: Option<&mut [[f64; 3]]>,
) -> Result<(), Error> {
    let n = r.len();
    let counts = [
        ("q", q.len()),
        ("distance", rows_of(&distance, n)),
        ("point", rows_of(&point, n)),
        ("normal", rows_of(&normal, n)),
    ];
    same_rows("pw85_distance_point_batch", "must have as many rows as r", n, &counts)?;
    check_rows(unsafe { sys::pw85_distance_point_batch(
        n,
        r.as_ptr().cast(),
        q.as_ptr().cast(),
        pointer(distance),
        pointer(point),
        pointer(normal),
    ) })
}

/// Computes the interval t\[0\] \<= t \<= t\[1\] in which the line origin + t·direction is inside
/// an ellipsoid.
///
/// For a ray from the origin, intersect this interval with t \>= 0; for the segment from origin
/// to origin + direction, with 0 \<= t \<= 1. If the line is nearly tangent, rounding errors
/// decide whether it misses the ellipsoid. [`overlap_segment()`](crate::overlap_segment) decides
/// exactly whether a segment has points inside the ellipsoid.
///
/// # Arguments
///
/// - `origin`: Of the line, relative to the centre of the ellipsoid. Unit: length.
/// - `direction`: Of any length; not zero.
/// - `q`: Form of the ellipsoid. Unit: length².
///
/// # Errors
///
/// A number is not finite, a form is not positive definite or `direction` is zero.
///
/// # Examples
///
/// ```
/// let found = pw85::intersect_line(
///     &[-5.0, 0.0, 0.0],
///     &[1.0, 0.0, 0.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn intersect_line(
    origin: &[f64; 3],
    direction: &[f64; 3],
    q: &[f64; 6],
) -> Result<Chord, Error> {
    let mut t = [0.0; 2];
    check(unsafe { sys::pw85_intersect_line(
        origin.as_ptr(),
        direction.as_ptr(),
        q.as_ptr(),
        t.as_mut_ptr(),
    ) })?;
    Ok(Chord { enter: t[0], leave: t[1] })
}

/// Computes [`intersect_line()`](crate::intersect_line) for many lines and ellipsoids, with
/// bitwise equal results.
///
/// # Arguments
///
/// - `origin`: Unit: length.
/// - `directions`: Not zero.
/// - `q`: Unit: length².
/// - `enter`, `leave`: Unit: length.
///
/// Row i of each slice belongs to row i of `origin`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `origin`, or a row is refused. The outputs of such rows are
/// NaN, 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let origin = [[-5.0, 0.0, 0.0]; 2];
/// let directions = [[1.0, 0.0, 0.0]; 2];
/// let q = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let mut enter = [0.0; 2];
/// let mut leave = [0.0; 2];
/// pw85::intersect_line_batch(&origin, &directions, &q, Some(&mut enter), Some(&mut leave))?;
/// assert_eq!(leave[0], leave[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn intersect_line_batch(
    origin: &[[f64; 3]],
    directions: &[[f64; 3]],
    q: &[[f64; 6]],
    enter: Option<&mut [f64]>,
    leave: Option<&mut [f64]>,
) -> Result<(), Error> {
    let n = origin.len();
    let counts = [
        ("directions", directions.len()),
        ("q", q.len()),
        ("enter", rows_of(&enter, n)),
        ("leave", rows_of(&leave, n)),
    ];
    same_rows("pw85_intersect_line_batch", "must have as many rows as origin", n, &counts)?;
    check_rows(unsafe { sys::pw85_intersect_line_batch(
        n,
        origin.as_ptr().cast(),
        directions.as_ptr().cast(),
        q.as_ptr().cast(),
        pointer(enter),
        pointer(leave),
    ) })
}

/// Computes the volume of the part of an ellipsoid that is in the half-space normal·x \<= offset,
/// where x is relative to the centre of the ellipsoid.
///
/// # Arguments
///
/// - `normal`: Outward normal of the half-space, of any length; not zero.
/// - `offset`: In the unit of normal·x, as for [`distance_plane()`](crate::distance_plane);
///   negative if the centre is outside the half-space. Unit: length.
/// - `q`: Form of the ellipsoid. Unit: length².
///
/// # Errors
///
/// A number is not finite, a form is not positive definite or `normal` is zero.
///
/// # Examples
///
/// ```
/// let found = pw85::overlap_volume_plane(&[1.0, 0.0, 0.0], 5.0, &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0])?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn overlap_volume_plane(normal: &[f64; 3], offset: f64, q: &[f64; 6]) -> Result<f64, Error> {
    let mut volume = 0.0;
    check(unsafe { sys::pw85_overlap_volume_plane(
        normal.as_ptr(),
        offset,
        q.as_ptr(),
        &mut volume,
    ) })?;
    Ok(volume)
}

/// Computes [`overlap_volume_plane()`](crate::overlap_volume_plane) for many ellipsoids and
/// half-spaces, with bitwise equal results.
///
/// # Arguments
///
/// - `normals`: Not zero.
/// - `offsets`: Unit: length.
/// - `q`: Unit: length².
/// - `volume`: Unit: length³.
///
/// Row i of each slice belongs to row i of `normals`.
///
/// # Errors
///
/// A slice has not as many rows as `normals`, or a row is refused. The outputs of such rows are
/// NaN, 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let normals = [[1.0, 0.0, 0.0]; 2];
/// let offsets = [5.0; 2];
/// let q = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let mut volume = [0.0; 2];
/// pw85::overlap_volume_plane_batch(&normals, &offsets, &q, &mut volume)?;
/// assert_eq!(volume[0], volume[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn overlap_volume_plane_batch(
    normals: &[[f64; 3]],
    offsets: &[f64],
    q: &[[f64; 6]],
    volume: &mut [f64],
) -> Result<(), Error> {
    let n = normals.len();
    let counts = [("offsets", offsets.len()), ("q", q.len()), ("volume", volume.len())];
    same_rows("pw85_overlap_volume_plane_batch", "must have as many rows as normals", n, &counts)?;
    check_rows(unsafe { sys::pw85_overlap_volume_plane_batch(
        n,
        normals.as_ptr().cast(),
        offsets.as_ptr(),
        q.as_ptr().cast(),
        volume.as_mut_ptr(),
    ) })
}

/// Computes the contact function of an ellipsoid and a segment.
///
/// # Arguments
///
/// - `end1`, `end2`: Of the segment, relative to the centre of the ellipsoid; they may be equal:
///   the segment is then a point. Unit: length.
/// - `q`: Form of the ellipsoid. Unit: length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite.
///
/// # Examples
///
/// ```
/// let found = pw85::contact_segment(
///     &[2.0, 2.0, 1.0],
///     &[2.0, -2.0, 1.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn contact_segment(
    end1: &[f64; 3],
    end2: &[f64; 3],
    q: &[f64; 6],
) -> Result<ShapeContact, Error> {
    let mut mu2 = 0.0;
    let mut point = [0.0; 3];
    check(unsafe { sys::pw85_contact_segment(
        end1.as_ptr(),
        end2.as_ptr(),
        q.as_ptr(),
        &mut mu2,
        point.as_mut_ptr(),
    ) })?;
    Ok(ShapeContact { mu2, point })
}

/// Computes [`contact_segment()`](crate::contact_segment) for many ellipsoids and segments.
///
/// The error has the same bound. The last bits may differ.
///
/// # Arguments
///
/// - `end1`, `end2`: Unit: length.
/// - `q`: Unit: length².
/// - `point`: Unit: length.
///
/// Row i of each slice belongs to row i of `end1`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `end1`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let end1 = [[2.0, 2.0, 1.0]; 2];
/// let end2 = [[2.0, -2.0, 1.0]; 2];
/// let q = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let mut mu2 = [0.0; 2];
/// let mut point = [[0.0; 3]; 2];
/// pw85::contact_segment_batch(&end1, &end2, &q, Some(&mut mu2), Some(&mut point))?;
/// assert_eq!(point[0], point[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn contact_segment_batch(
    end1: &[[f64; 3]],
    end2: &[[f64; 3]],
    q: &[[f64; 6]],
    mu2: Option<&mut [f64]>,
    point: Option<&mut [[f64; 3]]>,
) -> Result<(), Error> {
    let n = end1.len();
    let counts = [
        ("end2", end2.len()),
        ("q", q.len()),
        ("mu2", rows_of(&mu2, n)),
        ("point", rows_of(&point, n)),
    ];
    same_rows("pw85_contact_segment_batch", "must have as many rows as end1", n, &counts)?;
    check_rows(unsafe { sys::pw85_contact_segment_batch(
        n,
        end1.as_ptr().cast(),
        end2.as_ptr().cast(),
        q.as_ptr().cast(),
        pointer(mu2),
        pointer(point),
    ) })
}

/// Computes the contact function of an ellipsoid and a triangle.
///
/// # Arguments
///
/// - `vertex1`, `vertex2`, `vertex3`: Of the triangle, relative to the centre of the ellipsoid; a
///   triangle without area is a segment or a point. Unit: length.
/// - `q`: Form of the ellipsoid. Unit: length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite.
///
/// # Examples
///
/// ```
/// let found = pw85::contact_triangle(
///     &[2.0, 2.0, 1.0],
///     &[2.0, -2.0, 1.0],
///     &[2.0, 0.0, 4.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn contact_triangle(
    vertex1: &[f64; 3],
    vertex2: &[f64; 3],
    vertex3: &[f64; 3],
    q: &[f64; 6],
) -> Result<ShapeContact, Error> {
    let mut mu2 = 0.0;
    let mut point = [0.0; 3];
    check(unsafe { sys::pw85_contact_triangle(
        vertex1.as_ptr(),
        vertex2.as_ptr(),
        vertex3.as_ptr(),
        q.as_ptr(),
        &mut mu2,
        point.as_mut_ptr(),
    ) })?;
    Ok(ShapeContact { mu2, point })
}

/// Computes [`contact_triangle()`](crate::contact_triangle) for many ellipsoids and triangles.
///
/// The error has the same bound. The last bits may differ.
///
/// # Arguments
///
/// - `vertex1`, `vertex2`, `vertex3`: Unit: length.
/// - `q`: Unit: length².
/// - `point`: Unit: length.
///
/// Row i of each slice belongs to row i of `vertex1`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `vertex1`, or a row is refused. The outputs of such rows are
/// NaN, 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let vertex1 = [[2.0, 2.0, 1.0]; 2];
/// let vertex2 = [[2.0, -2.0, 1.0]; 2];
/// let vertex3 = [[2.0, 0.0, 4.0]; 2];
/// let q = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let mut mu2 = [0.0; 2];
/// let mut point = [[0.0; 3]; 2];
/// pw85::contact_triangle_batch(&vertex1, &vertex2, &vertex3, &q, Some(&mut mu2), Some(&mut point))?;
/// assert_eq!(point[0], point[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn contact_triangle_batch(
    vertex1: &[[f64; 3]],
    vertex2: &[[f64; 3]],
    vertex3: &[[f64; 3]],
    q: &[[f64; 6]],
    mu2: Option<&mut [f64]>,
    point: Option<&mut [[f64; 3]]>,
) -> Result<(), Error> {
    let n = vertex1.len();
    let counts = [
        ("vertex2", vertex2.len()),
        ("vertex3", vertex3.len()),
        ("q", q.len()),
        ("mu2", rows_of(&mu2, n)),
        ("point", rows_of(&point, n)),
    ];
    same_rows("pw85_contact_triangle_batch", "must have as many rows as vertex1", n, &counts)?;
    check_rows(unsafe { sys::pw85_contact_triangle_batch(
        n,
        vertex1.as_ptr().cast(),
        vertex2.as_ptr().cast(),
        vertex3.as_ptr().cast(),
        q.as_ptr().cast(),
        pointer(mu2),
        pointer(point),
    ) })
}

/// Computes the contact function of an ellipsoid and a solid box with sides along the axes.
///
/// # Arguments
///
/// - `lower`, `upper`: Corners of the box, relative to the centre of the ellipsoid; a box may be
///   flat; `lower` \<= `upper`. Unit: length.
/// - `q`: Form of the ellipsoid. Unit: length².
///
/// # Errors
///
/// A number is not finite, a form is not positive definite or `lower` is larger than `upper`.
///
/// # Examples
///
/// ```
/// let found = pw85::contact_box(
///     &[2.0, -1.0, -1.0],
///     &[4.0, 1.0, 1.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn contact_box(
    lower: &[f64; 3],
    upper: &[f64; 3],
    q: &[f64; 6],
) -> Result<ShapeContact, Error> {
    let mut mu2 = 0.0;
    let mut point = [0.0; 3];
    check(unsafe { sys::pw85_contact_box(
        lower.as_ptr(),
        upper.as_ptr(),
        q.as_ptr(),
        &mut mu2,
        point.as_mut_ptr(),
    ) })?;
    Ok(ShapeContact { mu2, point })
}

/// Computes [`contact_box()`](crate::contact_box) for many ellipsoids and boxes.
///
/// The error has the same bound. The last bits may differ.
///
/// # Arguments
///
/// - `lower`, `upper`: `lower` \<= `upper`. Unit: length.
/// - `q`: Unit: length².
/// - `point`: Unit: length.
///
/// Row i of each slice belongs to row i of `lower`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `lower`, or a row is refused. The outputs of such rows are
/// NaN, 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let lower = [[2.0, -1.0, -1.0]; 2];
/// let upper = [[4.0, 1.0, 1.0]; 2];
/// let q = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let mut mu2 = [0.0; 2];
/// let mut point = [[0.0; 3]; 2];
/// pw85::contact_box_batch(&lower, &upper, &q, Some(&mut mu2), Some(&mut point))?;
/// assert_eq!(point[0], point[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn contact_box_batch(
    lower: &[[f64; 3]],
    upper: &[[f64; 3]],
    q: &[[f64; 6]],
    mu2: Option<&mut [f64]>,
    point: Option<&mut [[f64; 3]]>,
) -> Result<(), Error> {
    let n = lower.len();
    let counts = [
        ("upper", upper.len()),
        ("q", q.len()),
        ("mu2", rows_of(&mu2, n)),
        ("point", rows_of(&point, n)),
    ];
    same_rows("pw85_contact_box_batch", "must have as many rows as lower", n, &counts)?;
    check_rows(unsafe { sys::pw85_contact_box_batch(
        n,
        lower.as_ptr().cast(),
        upper.as_ptr().cast(),
        q.as_ptr().cast(),
        pointer(mu2),
        pointer(point),
    ) })
}

/// Tests whether an ellipsoid and a segment overlap, μ² \< 1.
///
/// If they only touch, they do not overlap. The answer is exact for the numbers given.
///
/// # Arguments
///
/// - `end1`, `end2`: Of the segment, relative to the centre of the ellipsoid. Unit: length.
/// - `q`: Form of the ellipsoid. Unit: length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite.
///
/// # Examples
///
/// ```
/// let found = pw85::overlap_segment(
///     &[2.0, 2.0, 1.0],
///     &[2.0, -2.0, 1.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn overlap_segment(end1: &[f64; 3], end2: &[f64; 3], q: &[f64; 6]) -> Result<bool, Error> {
    let mut overlap = 0;
    check(unsafe { sys::pw85_overlap_segment(
        end1.as_ptr(),
        end2.as_ptr(),
        q.as_ptr(),
        &mut overlap,
    ) })?;
    Ok(overlap == 1)
}

/// Computes [`overlap_segment()`](crate::overlap_segment) for many ellipsoids and segments, with
/// the same answers.
///
/// # Arguments
///
/// - `end1`, `end2`: Unit: length.
/// - `q`: Unit: length².
/// - `overlap`: 1, 0, or 255 for a bad ellipsoid.
///
/// Row i of each slice belongs to row i of `end1`.
///
/// # Errors
///
/// A slice has not as many rows as `end1`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let end1 = [[2.0, 2.0, 1.0]; 2];
/// let end2 = [[2.0, -2.0, 1.0]; 2];
/// let q = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let mut overlap = [0; 2];
/// pw85::overlap_segment_batch(&end1, &end2, &q, &mut overlap)?;
/// assert_eq!(overlap[0], overlap[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn overlap_segment_batch(
    end1: &[[f64; 3]],
    end2: &[[f64; 3]],
    q: &[[f64; 6]],
    overlap: &mut [u8],
) -> Result<(), Error> {
    let n = end1.len();
    let counts = [("end2", end2.len()), ("q", q.len()), ("overlap", overlap.len())];
    same_rows("pw85_overlap_segment_batch", "must have as many rows as end1", n, &counts)?;
    check_rows(unsafe { sys::pw85_overlap_segment_batch(
        n,
        end1.as_ptr().cast(),
        end2.as_ptr().cast(),
        q.as_ptr().cast(),
        overlap.as_mut_ptr(),
    ) })
}

/// Tests whether an ellipsoid and a triangle overlap, μ² \< 1.
///
/// If they only touch, they do not overlap. The answer is exact for the numbers given.
///
/// # Arguments
///
/// - `vertex1`, `vertex2`, `vertex3`: Of the triangle, relative to the centre of the ellipsoid.
///   Unit: length.
/// - `q`: Form of the ellipsoid. Unit: length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite.
///
/// # Examples
///
/// ```
/// let found = pw85::overlap_triangle(
///     &[2.0, 2.0, 1.0],
///     &[2.0, -2.0, 1.0],
///     &[2.0, 0.0, 4.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn overlap_triangle(
    vertex1: &[f64; 3],
    vertex2: &[f64; 3],
    vertex3: &[f64; 3],
    q: &[f64; 6],
) -> Result<bool, Error> {
    let mut overlap = 0;
    check(unsafe { sys::pw85_overlap_triangle(
        vertex1.as_ptr(),
        vertex2.as_ptr(),
        vertex3.as_ptr(),
        q.as_ptr(),
        &mut overlap,
    ) })?;
    Ok(overlap == 1)
}

/// Computes [`overlap_triangle()`](crate::overlap_triangle) for many ellipsoids and triangles,
/// with the same answers.
///
/// # Arguments
///
/// - `vertex1`, `vertex2`, `vertex3`: Unit: length.
/// - `q`: Unit: length².
/// - `overlap`: 1, 0, or 255 for a bad ellipsoid.
///
/// Row i of each slice belongs to row i of `vertex1`.
///
/// # Errors
///
/// A slice has not as many rows as `vertex1`, or a row is refused. The outputs of such rows are
/// NaN, 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let vertex1 = [[2.0, 2.0, 1.0]; 2];
/// let vertex2 = [[2.0, -2.0, 1.0]; 2];
/// let vertex3 = [[2.0, 0.0, 4.0]; 2];
/// let q = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let mut overlap = [0; 2];
/// pw85::overlap_triangle_batch(&vertex1, &vertex2, &vertex3, &q, &mut overlap)?;
/// assert_eq!(overlap[0], overlap[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn overlap_triangle_batch(
    vertex1: &[[f64; 3]],
    vertex2: &[[f64; 3]],
    vertex3: &[[f64; 3]],
    q: &[[f64; 6]],
    overlap: &mut [u8],
) -> Result<(), Error> {
    let n = vertex1.len();
    let counts = [
        ("vertex2", vertex2.len()),
        ("vertex3", vertex3.len()),
        ("q", q.len()),
        ("overlap", overlap.len()),
    ];
    same_rows("pw85_overlap_triangle_batch", "must have as many rows as vertex1", n, &counts)?;
    check_rows(unsafe { sys::pw85_overlap_triangle_batch(
        n,
        vertex1.as_ptr().cast(),
        vertex2.as_ptr().cast(),
        vertex3.as_ptr().cast(),
        q.as_ptr().cast(),
        overlap.as_mut_ptr(),
    ) })
}

/// Tests whether an ellipsoid and a solid box with sides along the axes overlap, μ² \< 1.
///
/// If they only touch, they do not overlap. The answer is exact for the numbers given.
///
/// # Arguments
///
/// - `lower`, `upper`: Corners of the box, relative to the centre of the ellipsoid; `lower` \<=
///   `upper`. Unit: length.
/// - `q`: Form of the ellipsoid. Unit: length².
///
/// # Errors
///
/// A number is not finite, a form is not positive definite or `lower` is larger than `upper`.
///
/// # Examples
///
/// ```
/// let found = pw85::overlap_box(
///     &[2.0, -1.0, -1.0],
///     &[4.0, 1.0, 1.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn overlap_box(lower: &[f64; 3], upper: &[f64; 3], q: &[f64; 6]) -> Result<bool, Error> {
    let mut overlap = 0;
    check(unsafe { sys::pw85_overlap_box(
        lower.as_ptr(),
        upper.as_ptr(),
        q.as_ptr(),
        &mut overlap,
    ) })?;
    Ok(overlap == 1)
}

/// Computes [`overlap_box()`](crate::overlap_box) for many ellipsoids and boxes, with the same
/// answers.
///
/// # Arguments
///
/// - `lower`, `upper`: `lower` \<= `upper`. Unit: length.
/// - `q`: Unit: length².
/// - `overlap`: 1, 0, or 255 for a bad ellipsoid.
///
/// Row i of each slice belongs to row i of `lower`.
///
/// # Errors
///
/// A slice has not as many rows as `lower`, or a row is refused. The outputs of such rows are
/// NaN, 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let lower = [[2.0, -1.0, -1.0]; 2];
/// let upper = [[4.0, 1.0, 1.0]; 2];
/// let q = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let mut overlap = [0; 2];
/// pw85::overlap_box_batch(&lower, &upper, &q, &mut overlap)?;
/// assert_eq!(overlap[0], overlap[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn overlap_box_batch(
    lower: &[[f64; 3]],
    upper: &[[f64; 3]],
    q: &[[f64; 6]],
    overlap: &mut [u8],
) -> Result<(), Error> {
    let n = lower.len();
    let counts = [("upper", upper.len()), ("q", q.len()), ("overlap", overlap.len())];
    same_rows("pw85_overlap_box_batch", "must have as many rows as lower", n, &counts)?;
    check_rows(unsafe { sys::pw85_overlap_box_batch(
        n,
        lower.as_ptr().cast(),
        upper.as_ptr().cast(),
        q.as_ptr().cast(),
        overlap.as_mut_ptr(),
    ) })
}

/// Computes the signed distance of an ellipsoid and a segment, and the points where it is
/// reached.
///
/// # Arguments
///
/// - `end1`, `end2`: Of the segment, relative to the centre of the ellipsoid. Unit: length.
/// - `q`: Form of the ellipsoid. Unit: length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite.
///
/// # Examples
///
/// ```
/// let found = pw85::distance_segment(
///     &[2.0, 2.0, 1.0],
///     &[2.0, -2.0, 1.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn distance_segment(
    end1: &[f64; 3],
    end2: &[f64; 3],
    q: &[f64; 6],
) -> Result<ShapeDistance, Error> {
    let mut distance = 0.0;
    let mut point1 = [0.0; 3];
    let mut point2 = [0.0; 3];
    let mut normal = [0.0; 3];
    check(unsafe { sys::pw85_distance_segment(
        end1.as_ptr(),
        end2.as_ptr(),
        q.as_ptr(),
        &mut distance,
        point1.as_mut_ptr(),
        point2.as_mut_ptr(),
        normal.as_mut_ptr(),
    ) })?;
    Ok(ShapeDistance { distance, point1, point2, normal })
}

/// Computes [`distance_segment()`](crate::distance_segment) for many ellipsoids and segments,
/// with bitwise equal results.
///
/// # Arguments
///
/// - `end1`, `end2`: Unit: length.
/// - `q`: Unit: length².
/// - `distance`: Unit: length.
/// - `point1`, `point2`: Unit: length.
///
/// Row i of each slice belongs to row i of `end1`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `end1`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let end1 = [[2.0, 2.0, 1.0]; 2];
/// let end2 = [[2.0, -2.0, 1.0]; 2];
/// let q = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let mut distance = [0.0; 2];
/// let mut point1 = [[0.0; 3]; 2];
/// let mut point2 = [[0.0; 3]; 2];
/// let mut normal = [[0.0; 3]; 2];
/// pw85::distance_segment_batch(
///     &end1,
///     &end2,
///     &q,
///     Some(&mut distance),
///     Some(&mut point1),
///     Some(&mut point2),
///     Some(&mut normal),
/// )?;
/// assert_eq!(normal[0], normal[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn distance_segment_batch(
    end1: &[[f64; 3]],
    end2: &[[f64; 3]],
    q: &[[f64; 6]],
    distance: Option<&mut [f64]>,
    point1: Option<&mut [[f64; 3]]>,
    point2: Option<&mut [[f64; 3]]>,
    normal: Option<&mut [[f64; 3]]>,
) -> Result<(), Error> {
    let n = end1.len();
    let counts = [
        ("end2", end2.len()),
        ("q", q.len()),
        ("distance", rows_of(&distance, n)),
        ("point1", rows_of(&point1, n)),
        ("point2", rows_of(&point2, n)),
        ("normal", rows_of(&normal, n)),
    ];
    same_rows("pw85_distance_segment_batch", "must have as many rows as end1", n, &counts)?;
    check_rows(unsafe { sys::pw85_distance_segment_batch(
        n,
        end1.as_ptr().cast(),
        end2.as_ptr().cast(),
        q.as_ptr().cast(),
        pointer(distance),
        pointer(point1),
        pointer(point2),
        pointer(normal),
    ) })
}

/// Computes the signed distance of an ellipsoid and a triangle, and the points where it is
/// reached.
///
/// The triangle is a surface: the shortest translation that separates the two may be to either
/// side.
///
/// # Arguments
///
/// - `vertex1`, `vertex2`, `vertex3`: Of the triangle, relative to the centre of the ellipsoid.
///   Unit: length.
/// - `q`: Form of the ellipsoid. Unit: length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite.
///
/// # Examples
///
/// ```
/// let found = pw85::distance_triangle(
///     &[2.0, 2.0, 1.0],
///     &[2.0, -2.0, 1.0],
///     &[2.0, 0.0, 4.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn distance_triangle(
    vertex1: &[f64; 3],
    vertex2: &[f64; 3],
    vertex3: &[f64; 3],
    q: &[f64; 6],
) -> Result<ShapeDistance, Error> {
    let mut distance = 0.0;
    let mut point1 = [0.0; 3];
    let mut point2 = [0.0; 3];
    let mut normal = [0.0; 3];
    check(unsafe { sys::pw85_distance_triangle(
        vertex1.as_ptr(),
        vertex2.as_ptr(),
        vertex3.as_ptr(),
        q.as_ptr(),
        &mut distance,
        point1.as_mut_ptr(),
        point2.as_mut_ptr(),
        normal.as_mut_ptr(),
    ) })?;
    Ok(ShapeDistance { distance, point1, point2, normal })
}

/// Computes [`distance_triangle()`](crate::distance_triangle) for many ellipsoids and triangles,
/// with bitwise equal results.
///
/// # Arguments
///
/// - `vertex1`, `vertex2`, `vertex3`: Unit: length.
/// - `q`: Unit: length².
/// - `distance`: Unit: length.
/// - `point1`, `point2`: Unit: length.
///
/// Row i of each slice belongs to row i of `vertex1`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `vertex1`, or a row is refused. The outputs of such rows are
/// NaN, 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let vertex1 = [[2.0, 2.0, 1.0]; 2];
/// let vertex2 = [[2.0, -2.0, 1.0]; 2];
/// let vertex3 = [[2.0, 0.0, 4.0]; 2];
/// let q = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let mut distance = [0.0; 2];
/// let mut point1 = [[0.0; 3]; 2];
/// let mut point2 = [[0.0; 3]; 2];
/// let mut normal = [[0.0; 3]; 2];
/// pw85::distance_triangle_batch(
///     &vertex1,
///     &vertex2,
///     &vertex3,
///     &q,
///     Some(&mut distance),
///     Some(&mut point1),
///     Some(&mut point2),
///     Some(&mut normal),
/// )?;
/// assert_eq!(normal[0], normal[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn distance_triangle_batch(
    vertex1: &[[f64; 3]],
    vertex2: &[[f64; 3]],
    vertex3: &[[f64; 3]],
    q: &[[f64; 6]],
    distance: Option<&mut [f64]>,
    point1: Option<&mut [[f64; 3]]>,
    point2: Option<&mut [[f64; 3]]>,
    normal: Option<&mut [[f64; 3]]>,
) -> Result<(), Error> {
    let n = vertex1.len();
    let counts = [
        ("vertex2", vertex2.len()),
        ("vertex3", vertex3.len()),
        ("q", q.len()),
        ("distance", rows_of(&distance, n)),
        ("point1", rows_of(&point1, n)),
        ("point2", rows_of(&point2, n)),
        ("normal", rows_of(&normal, n)),
    ];
    same_rows("pw85_distance_triangle_batch", "must have as many rows as vertex1", n, &counts)?;
    check_rows(unsafe { sys::pw85_distance_triangle_batch(
        n,
        vertex1.as_ptr().cast(),
        vertex2.as_ptr().cast(),
        vertex3.as_ptr().cast(),
        q.as_ptr().cast(),
        pointer(distance),
        pointer(point1),
        pointer(point2),
        pointer(normal),
    ) })
}

/// Computes the signed distance of an ellipsoid and a solid box with sides along the axes, and
/// the points where it is reached.
///
/// For a box that contains the ellipsoid, see [`distance_box()`](crate::distance_box).
///
/// # Arguments
///
/// - `lower`, `upper`: Corners of the box, relative to the centre of the ellipsoid; `lower` \<=
///   `upper`. Unit: length.
/// - `q`: Form of the ellipsoid. Unit: length².
///
/// # Errors
///
/// A number is not finite, a form is not positive definite or `lower` is larger than `upper`.
///
/// # Examples
///
/// ```
/// let found = pw85::distance_solid_box(
///     &[2.0, -1.0, -1.0],
///     &[4.0, 1.0, 1.0],
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn distance_solid_box(
    lower: &[f64; 3],
    upper: &[f64; 3],
    q: &[f64; 6],
) -> Result<ShapeDistance, Error> {
    let mut distance = 0.0;
    let mut point1 = [0.0; 3];
    let mut point2 = [0.0; 3];
    let mut normal = [0.0; 3];
    check(unsafe { sys::pw85_distance_solid_box(
        lower.as_ptr(),
        upper.as_ptr(),
        q.as_ptr(),
        &mut distance,
        point1.as_mut_ptr(),
        point2.as_mut_ptr(),
        normal.as_mut_ptr(),
    ) })?;
    Ok(ShapeDistance { distance, point1, point2, normal })
}

/// Computes [`distance_solid_box()`](crate::distance_solid_box) for many ellipsoids and boxes,
/// with bitwise equal results.
///
/// # Arguments
///
/// - `lower`, `upper`: `lower` \<= `upper`. Unit: length.
/// - `q`: Unit: length².
/// - `distance`: Unit: length.
/// - `point1`, `point2`: Unit: length.
///
/// Row i of each slice belongs to row i of `lower`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `lower`, or a row is refused. The outputs of such rows are
/// NaN, 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let lower = [[2.0, -1.0, -1.0]; 2];
/// let upper = [[4.0, 1.0, 1.0]; 2];
/// let q = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let mut distance = [0.0; 2];
/// let mut point1 = [[0.0; 3]; 2];
/// let mut point2 = [[0.0; 3]; 2];
/// let mut normal = [[0.0; 3]; 2];
/// pw85::distance_solid_box_batch(
///     &lower,
///     &upper,
///     &q,
///     Some(&mut distance),
///     Some(&mut point1),
///     Some(&mut point2),
///     Some(&mut normal),
/// )?;
/// assert_eq!(normal[0], normal[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn distance_solid_box_batch(
    lower: &[[f64; 3]],
    upper: &[[f64; 3]],
    q: &[[f64; 6]],
    distance: Option<&mut [f64]>,
    point1: Option<&mut [[f64; 3]]>,
    point2: Option<&mut [[f64; 3]]>,
    normal: Option<&mut [[f64; 3]]>,
) -> Result<(), Error> {
    let n = lower.len();
    let counts = [
        ("upper", upper.len()),
        ("q", q.len()),
        ("distance", rows_of(&distance, n)),
        ("point1", rows_of(&point1, n)),
        ("point2", rows_of(&point2, n)),
        ("normal", rows_of(&normal, n)),
    ];
    same_rows("pw85_distance_solid_box_batch", "must have as many rows as lower", n, &counts)?;
    check_rows(unsafe { sys::pw85_distance_solid_box_batch(
        n,
        lower.as_ptr().cast(),
        upper.as_ptr().cast(),
        q.as_ptr().cast(),
        pointer(distance),
        pointer(point1),
        pointer(point2),
        pointer(normal),
    ) })
}

/// Computes the contact function of an ellipsoid and a capsule.
///
/// # Arguments
///
/// - `end1`, `end2`: Of the segment, relative to the centre of the ellipsoid; they may be equal:
///   the capsule is then a ball. Unit: length.
/// - `radius`: Of the capsule; \>= 0. Unit: length.
/// - `q`: Form of the ellipsoid. Unit: length².
///
/// # Errors
///
/// A number is not finite, a form is not positive definite or `radius` is negative.
///
/// # Examples
///
/// ```
/// let found = pw85::contact_capsule(
///     &[2.0, 2.0, 1.0],
///     &[2.0, -2.0, 1.0],
///     99.0,
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn contact_capsule(
    end1: &[f64; 3],
    end2: &[f64; 3],
    radius: f64,
    q: &[f64; 6],
) -> Result<ShapeContact, Error> {
    let mut mu2 = 0.0;
    let mut point = [0.0; 3];
    check(unsafe { sys::pw85_contact_capsule(
        end1.as_ptr(),
        end2.as_ptr(),
        radius,
        q.as_ptr(),
        &mut mu2,
        point.as_mut_ptr(),
    ) })?;
    Ok(ShapeContact { mu2, point })
}

/// Computes [`contact_capsule()`](crate::contact_capsule) for many ellipsoids and capsules, with
/// bitwise equal results.
///
/// # Arguments
///
/// - `end1`, `end2`: Unit: length.
/// - `radius`: \>= 0. Unit: length.
/// - `q`: Unit: length².
/// - `point`: Unit: length.
///
/// Row i of each slice belongs to row i of `end1`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `end1`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let end1 = [[2.0, 2.0, 1.0]; 2];
/// let end2 = [[2.0, -2.0, 1.0]; 2];
/// let radius = [99.0; 2];
/// let q = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let mut mu2 = [0.0; 2];
/// let mut point = [[0.0; 3]; 2];
/// pw85::contact_capsule_batch(&end1, &end2, &radius, &q, Some(&mut mu2), Some(&mut point))?;
/// assert_eq!(point[0], point[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn contact_capsule_batch(
    end1: &[[f64; 3]],
    end2: &[[f64; 3]],
    radius: &[f64],
    q: &[[f64; 6]],
    mu2: Option<&mut [f64]>,
    point: Option<&mut [[f64; 3]]>,
) -> Result<(), Error> {
    let n = end1.len();
    let counts = [
        ("end2", end2.len()),
        ("radius", radius.len()),
        ("q", q.len()),
        ("mu2", rows_of(&mu2, n)),
        ("point", rows_of(&point, n)),
    ];
    same_rows("pw85_contact_capsule_batch", "must have as many rows as end1", n, &counts)?;
    check_rows(unsafe { sys::pw85_contact_capsule_batch(
        n,
        end1.as_ptr().cast(),
        end2.as_ptr().cast(),
        radius.as_ptr(),
        q.as_ptr().cast(),
        pointer(mu2),
        pointer(point),
    ) })
}

/// Tests whether an ellipsoid and a capsule overlap, μ² \< 1.
///
/// If they only touch, they do not overlap.
///
/// The answer is exact for the numbers given, with one exception: if 1 - μ² is positive and below
/// 2⁻³⁶⁰ (S + 2 radius \|s\|), the two count as touching.
///
/// # Arguments
///
/// - `end1`, `end2`: Of the segment, relative to the centre of the ellipsoid. Unit: length.
/// - `radius`: Of the capsule; \>= 0. Unit: length.
/// - `q`: Form of the ellipsoid. Unit: length².
///
/// # Errors
///
/// A number is not finite, a form is not positive definite or `radius` is negative.
///
/// # Examples
///
/// ```
/// let found = pw85::overlap_capsule(
///     &[2.0, 2.0, 1.0],
///     &[2.0, -2.0, 1.0],
///     99.0,
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn overlap_capsule(
    end1: &[f64; 3],
    end2: &[f64; 3],
    radius: f64,
    q: &[f64; 6],
) -> Result<bool, Error> {
    let mut overlap = 0;
    check(unsafe { sys::pw85_overlap_capsule(
        end1.as_ptr(),
        end2.as_ptr(),
        radius,
        q.as_ptr(),
        &mut overlap,
    ) })?;
    Ok(overlap == 1)
}

/// Computes [`overlap_capsule()`](crate::overlap_capsule) for many ellipsoids and capsules, with
/// the same answers.
///
/// # Arguments
///
/// - `end1`, `end2`: Unit: length.
/// - `radius`: \>= 0. Unit: length.
/// - `q`: Unit: length².
/// - `overlap`: 1, 0, or 255 for a bad ellipsoid.
///
/// Row i of each slice belongs to row i of `end1`.
///
/// # Errors
///
/// A slice has not as many rows as `end1`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let end1 = [[2.0, 2.0, 1.0]; 2];
/// let end2 = [[2.0, -2.0, 1.0]; 2];
/// let radius = [99.0; 2];
/// let q = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let mut overlap = [0; 2];
/// pw85::overlap_capsule_batch(&end1, &end2, &radius, &q, &mut overlap)?;
/// assert_eq!(overlap[0], overlap[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn overlap_capsule_batch(
    end1: &[[f64; 3]],
    end2: &[[f64; 3]],
    radius: &[f64],
    q: &[[f64; 6]],
    overlap: &mut [u8],
) -> Result<(), Error> {
    let n = end1.len();
    let counts = [
        ("end2", end2.len()),
        ("radius", radius.len()),
        ("q", q.len()),
        ("overlap", overlap.len()),
    ];
    same_rows("pw85_overlap_capsule_batch", "must have as many rows as end1", n, &counts)?;
    check_rows(unsafe { sys::pw85_overlap_capsule_batch(
        n,
        end1.as_ptr().cast(),
        end2.as_ptr().cast(),
        radius.as_ptr(),
        q.as_ptr().cast(),
        overlap.as_mut_ptr(),
    ) })
}

/// Computes the signed distance of an ellipsoid and a capsule, and the points where it is
/// reached.
///
/// # Arguments
///
/// - `end1`, `end2`: Of the segment, relative to the centre of the ellipsoid. Unit: length.
/// - `radius`: Of the capsule; \>= 0. Unit: length.
/// - `q`: Form of the ellipsoid. Unit: length².
///
/// # Errors
///
/// A number is not finite, a form is not positive definite or `radius` is negative.
///
/// # Examples
///
/// ```
/// let found = pw85::distance_capsule(
///     &[2.0, 2.0, 1.0],
///     &[2.0, -2.0, 1.0],
///     99.0,
///     &[9.0, 0.0, 0.0, 4.0, 0.0, 1.0],
/// )?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn distance_capsule(
    end1: &[f64; 3],
    end2: &[f64; 3],
    radius: f64,
    q: &[f64; 6],
) -> Result<ShapeDistance, Error> {
    let mut distance = 0.0;
    let mut point1 = [0.0; 3];
    let mut point2 = [0.0; 3];
    let mut normal = [0.0; 3];
    check(unsafe { sys::pw85_distance_capsule(
        end1.as_ptr(),
        end2.as_ptr(),
        radius,
        q.as_ptr(),
        &mut distance,
        point1.as_mut_ptr(),
        point2.as_mut_ptr(),
        normal.as_mut_ptr(),
    ) })?;
    Ok(ShapeDistance { distance, point1, point2, normal })
}

/// Computes [`distance_capsule()`](crate::distance_capsule) for many ellipsoids and capsules,
/// with bitwise equal results.
///
/// # Arguments
///
/// - `end1`, `end2`: Unit: length.
/// - `radius`: \>= 0. Unit: length.
/// - `q`: Unit: length².
/// - `distance`: Unit: length.
/// - `point1`, `point2`: Unit: length.
///
/// Row i of each slice belongs to row i of `end1`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `end1`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let end1 = [[2.0, 2.0, 1.0]; 2];
/// let end2 = [[2.0, -2.0, 1.0]; 2];
/// let radius = [99.0; 2];
/// let q = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let mut distance = [0.0; 2];
/// let mut point1 = [[0.0; 3]; 2];
/// let mut point2 = [[0.0; 3]; 2];
/// let mut normal = [[0.0; 3]; 2];
/// pw85::distance_capsule_batch(
///     &end1,
///     &end2,
///     &radius,
///     &q,
///     Some(&mut distance),
///     Some(&mut point1),
///     Some(&mut point2),
///     Some(&mut normal),
/// )?;
/// assert_eq!(normal[0], normal[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn distance_capsule_batch(
    end1: &[[f64; 3]],
    end2: &[[f64; 3]],
    radius: &[f64],
    q: &[[f64; 6]],
    distance: Option<&mut [f64]>,
    point1: Option<&mut [[f64; 3]]>,
    point2: Option<&mut [[f64; 3]]>,
    normal: Option<&mut [[f64; 3]]>,
) -> Result<(), Error> {
    let n = end1.len();
    let counts = [
        ("end2", end2.len()),
        ("radius", radius.len()),
        ("q", q.len()),
        ("distance", rows_of(&distance, n)),
        ("point1", rows_of(&point1, n)),
        ("point2", rows_of(&point2, n)),
        ("normal", rows_of(&normal, n)),
    ];
    same_rows("pw85_distance_capsule_batch", "must have as many rows as end1", n, &counts)?;
    check_rows(unsafe { sys::pw85_distance_capsule_batch(
        n,
        end1.as_ptr().cast(),
        end2.as_ptr().cast(),
        radius.as_ptr(),
        q.as_ptr().cast(),
        pointer(distance),
        pointer(point1),
        pointer(point2),
        pointer(normal),
    ) })
}

/// Computes the distance from a point to the perimeter of an ellipse; see
/// [`distance_point()`](crate::distance_point).
///
/// # Arguments
///
/// - `r`: The point, relative to the centre of the ellipse. Unit: length.
/// - `q`: Form of the ellipse. Unit: length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite.
///
/// # Examples
///
/// ```
/// let found = pw85::distance_point_2d(&[4.0, 2.0], &[9.0, 0.0, 4.0])?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn distance_point_2d(r: &[f64; 2], q: &[f64; 3]) -> Result<SurfaceDistance2d, Error> {
    let mut distance = 0.0;
    let mut point = [0.0; 2];
    let mut normal = [0.0; 2];
    check(unsafe { sys::pw85_distance_point_2d(
        r.as_ptr(),
        q.as_ptr(),
        &mut distance,
        point.as_mut_ptr(),
        normal.as_mut_ptr(),
    ) })?;
    Ok(SurfaceDistance2d { distance, point, normal })
}

/// Computes [`distance_point_2d()`](crate::distance_point_2d) for many points and ellipses, with
/// bitwise equal results.
///
/// # Arguments
///
/// - `r`: Unit: length.
/// - `q`: Unit: length².
/// - `distance`: Unit: length.
/// - `point`: Unit: length.
///
/// Row i of each slice belongs to row i of `r`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `r`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r = [[4.0, 2.0]; 2];
/// let q = [[9.0, 0.0, 4.0]; 2];
/// let mut distance = [0.0; 2];
/// let mut point = [[0.0; 2]; 2];
/// let mut normal = [[0.0; 2]; 2];
/// pw85::distance_point_batch_2d(&r, &q, Some(&mut distance), Some(&mut point), Some(&mut normal))?;
/// assert_eq!(normal[0], normal[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn distance_point_batch_2d(
    r: &[[f64; 2]],
    q: &[[f64; 3]],
    distance: Option<&mut [f64]>,
    point: Option<&mut [[f64; 2]]>,
    normal: Option<&mut [[f64; 2]]>,
) -> Result<(), Error> {
    let n = r.len();
    let counts = [
        ("q", q.len()),
        ("distance", rows_of(&distance, n)),
        ("point", rows_of(&point, n)),
        ("normal", rows_of(&normal, n)),
    ];
    same_rows("pw85_distance_point_batch_2d", "must have as many rows as r", n, &counts)?;
    check_rows(unsafe { sys::pw85_distance_point_batch_2d(
        n,
        r.as_ptr().cast(),
        q.as_ptr().cast(),
        pointer(distance),
        pointer(point),
        pointer(normal),
    ) })
}

/// Computes the contact function of an ellipse and a segment; see
/// [`contact_segment()`](crate::contact_segment).
///
/// # Arguments
///
/// - `end1`, `end2`: Of the segment, relative to the centre of the ellipse; they may be equal:
///   the segment is then a point. Unit: length.
/// - `q`: Form of the ellipse. Unit: length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite.
///
/// # Examples
///
/// ```
/// let found = pw85::contact_segment_2d(&[2.0, 2.0], &[2.0, -2.0], &[9.0, 0.0, 4.0])?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn contact_segment_2d(
    end1: &[f64; 2],
    end2: &[f64; 2],
    q: &[f64; 3],
) -> Result<ShapeContact2d, Error> {
    let mut mu2 = 0.0;
    let mut point = [0.0; 2];
    check(unsafe { sys::pw85_contact_segment_2d(
        end1.as_ptr(),
        end2.as_ptr(),
        q.as_ptr(),
        &mut mu2,
        point.as_mut_ptr(),
    ) })?;
    Ok(ShapeContact2d { mu2, point })
}

/// Computes [`contact_segment_2d()`](crate::contact_segment_2d) for many ellipses and segments,
/// with bitwise equal results.
///
/// # Arguments
///
/// - `end1`, `end2`: Unit: length.
/// - `q`: Unit: length².
/// - `point`: Unit: length.
///
/// Row i of each slice belongs to row i of `end1`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `end1`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let end1 = [[2.0, 2.0]; 2];
/// let end2 = [[2.0, -2.0]; 2];
/// let q = [[9.0, 0.0, 4.0]; 2];
/// let mut mu2 = [0.0; 2];
/// let mut point = [[0.0; 2]; 2];
/// pw85::contact_segment_batch_2d(&end1, &end2, &q, Some(&mut mu2), Some(&mut point))?;
/// assert_eq!(point[0], point[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn contact_segment_batch_2d(
    end1: &[[f64; 2]],
    end2: &[[f64; 2]],
    q: &[[f64; 3]],
    mu2: Option<&mut [f64]>,
    point: Option<&mut [[f64; 2]]>,
) -> Result<(), Error> {
    let n = end1.len();
    let counts = [
        ("end2", end2.len()),
        ("q", q.len()),
        ("mu2", rows_of(&mu2, n)),
        ("point", rows_of(&point, n)),
    ];
    same_rows("pw85_contact_segment_batch_2d", "must have as many rows as end1", n, &counts)?;
    check_rows(unsafe { sys::pw85_contact_segment_batch_2d(
        n,
        end1.as_ptr().cast(),
        end2.as_ptr().cast(),
        q.as_ptr().cast(),
        pointer(mu2),
        pointer(point),
    ) })
}

/// Computes the contact function of an ellipse and a solid rectangle with sides along the axes.
///
/// See [`contact_box()`](crate::contact_box).
///
/// # Arguments
///
/// - `lower`, `upper`: Corners of the box, relative to the centre of the ellipse; a box may be
///   flat; `lower` \<= `upper`. Unit: length.
/// - `q`: Form of the ellipse. Unit: length².
///
/// # Errors
///
/// A number is not finite, a form is not positive definite or `lower` is larger than `upper`.
///
/// # Examples
///
/// ```
/// let found = pw85::contact_box_2d(&[2.0, -1.0], &[4.0, 1.0], &[9.0, 0.0, 4.0])?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn contact_box_2d(
    lower: &[f64; 2],
    upper: &[f64; 2],
    q: &[f64; 3],
) -> Result<ShapeContact2d, Error> {
    let mut mu2 = 0.0;
    let mut point = [0.0; 2];
    check(unsafe { sys::pw85_contact_box_2d(
        lower.as_ptr(),
        upper.as_ptr(),
        q.as_ptr(),
        &mut mu2,
        point.as_mut_ptr(),
    ) })?;
    Ok(ShapeContact2d { mu2, point })
}

/// Computes [`contact_box_2d()`](crate::contact_box_2d) for many ellipses and boxes, with bitwise
/// equal results.
///
/// # Arguments
///
/// - `lower`, `upper`: `lower` \<= `upper`. Unit: length.
/// - `q`: Unit: length².
/// - `point`: Unit: length.
///
/// Row i of each slice belongs to row i of `lower`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `lower`, or a row is refused. The outputs of such rows are
/// NaN, 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let lower = [[2.0, -1.0]; 2];
/// let upper = [[4.0, 1.0]; 2];
/// let q = [[9.0, 0.0, 4.0]; 2];
/// let mut mu2 = [0.0; 2];
/// let mut point = [[0.0; 2]; 2];
/// pw85::contact_box_batch_2d(&lower, &upper, &q, Some(&mut mu2), Some(&mut point))?;
/// assert_eq!(point[0], point[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn contact_box_batch_2d(
    lower: &[[f64; 2]],
    upper: &[[f64; 2]],
    q: &[[f64; 3]],
    mu2: Option<&mut [f64]>,
    point: Option<&mut [[f64; 2]]>,
) -> Result<(), Error> {
    let n = lower.len();
    let counts = [
        ("upper", upper.len()),
        ("q", q.len()),
        ("mu2", rows_of(&mu2, n)),
        ("point", rows_of(&point, n)),
    ];
    same_rows("pw85_contact_box_batch_2d", "must have as many rows as lower", n, &counts)?;
    check_rows(unsafe { sys::pw85_contact_box_batch_2d(
        n,
        lower.as_ptr().cast(),
        upper.as_ptr().cast(),
        q.as_ptr().cast(),
        pointer(mu2),
        pointer(point),
    ) })
}

/// Tests whether an ellipse and a segment overlap; see
/// [`overlap_segment()`](crate::overlap_segment).
///
/// # Arguments
///
/// - `end1`, `end2`: Of the segment, relative to the centre of the ellipse; they may be equal:
///   the segment is then a point. Unit: length.
/// - `q`: Form of the ellipse. Unit: length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite.
///
/// # Examples
///
/// ```
/// let found = pw85::overlap_segment_2d(&[2.0, 2.0], &[2.0, -2.0], &[9.0, 0.0, 4.0])?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn overlap_segment_2d(end1: &[f64; 2], end2: &[f64; 2], q: &[f64; 3]) -> Result<bool, Error> {
    let mut overlap = 0;
    check(unsafe { sys::pw85_overlap_segment_2d(
        end1.as_ptr(),
        end2.as_ptr(),
        q.as_ptr(),
        &mut overlap,
    ) })?;
    Ok(overlap == 1)
}

/// Computes [`overlap_segment_2d()`](crate::overlap_segment_2d) for many ellipses and segments,
/// with the same answers.
///
/// # Arguments
///
/// - `end1`, `end2`: Unit: length.
/// - `q`: Unit: length².
/// - `overlap`: 1, 0, or 255 for a bad ellipse.
///
/// Row i of each slice belongs to row i of `end1`.
///
/// # Errors
///
/// A slice has not as many rows as `end1`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let end1 = [[2.0, 2.0]; 2];
/// let end2 = [[2.0, -2.0]; 2];
/// let q = [[9.0, 0.0, 4.0]; 2];
/// let mut overlap = [0; 2];
/// pw85::overlap_segment_batch_2d(&end1, &end2, &q, &mut overlap)?;
/// assert_eq!(overlap[0], overlap[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn overlap_segment_batch_2d(
    end1: &[[f64; 2]],
    end2: &[[f64; 2]],
    q: &[[f64; 3]],
    overlap: &mut [u8],
) -> Result<(), Error> {
    let n = end1.len();
    let counts = [("end2", end2.len()), ("q", q.len()), ("overlap", overlap.len())];
    same_rows("pw85_overlap_segment_batch_2d", "must have as many rows as end1", n, &counts)?;
    check_rows(unsafe { sys::pw85_overlap_segment_batch_2d(
        n,
        end1.as_ptr().cast(),
        end2.as_ptr().cast(),
        q.as_ptr().cast(),
        overlap.as_mut_ptr(),
    ) })
}

/// Tests whether an ellipse and a solid rectangle with sides along the axes overlap; see
/// [`overlap_box()`](crate::overlap_box).
///
/// # Arguments
///
/// - `lower`, `upper`: Corners of the box, relative to the centre of the ellipse; a box may be
///   flat; `lower` \<= `upper`. Unit: length.
/// - `q`: Form of the ellipse. Unit: length².
///
/// # Errors
///
/// A number is not finite, a form is not positive definite or `lower` is larger than `upper`.
///
/// # Examples
///
/// ```
/// let found = pw85::overlap_box_2d(&[2.0, -1.0], &[4.0, 1.0], &[9.0, 0.0, 4.0])?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn overlap_box_2d(lower: &[f64; 2], upper: &[f64; 2], q: &[f64; 3]) -> Result<bool, Error> {
    let mut overlap = 0;
    check(unsafe { sys::pw85_overlap_box_2d(
        lower.as_ptr(),
        upper.as_ptr(),
        q.as_ptr(),
        &mut overlap,
    ) })?;
    Ok(overlap == 1)
}

/// Computes [`overlap_box_2d()`](crate::overlap_box_2d) for many ellipses and boxes, with the
/// same answers.
///
/// # Arguments
///
/// - `lower`, `upper`: `lower` \<= `upper`. Unit: length.
/// - `q`: Unit: length².
/// - `overlap`: 1, 0, or 255 for a bad ellipse.
///
/// Row i of each slice belongs to row i of `lower`.
///
/// # Errors
///
/// A slice has not as many rows as `lower`, or a row is refused. The outputs of such rows are
/// NaN, 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let lower = [[2.0, -1.0]; 2];
/// let upper = [[4.0, 1.0]; 2];
/// let q = [[9.0, 0.0, 4.0]; 2];
/// let mut overlap = [0; 2];
/// pw85::overlap_box_batch_2d(&lower, &upper, &q, &mut overlap)?;
/// assert_eq!(overlap[0], overlap[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn overlap_box_batch_2d(
    lower: &[[f64; 2]],
    upper: &[[f64; 2]],
    q: &[[f64; 3]],
    overlap: &mut [u8],
) -> Result<(), Error> {
    let n = lower.len();
    let counts = [("upper", upper.len()), ("q", q.len()), ("overlap", overlap.len())];
    same_rows("pw85_overlap_box_batch_2d", "must have as many rows as lower", n, &counts)?;
    check_rows(unsafe { sys::pw85_overlap_box_batch_2d(
        n,
        lower.as_ptr().cast(),
        upper.as_ptr().cast(),
        q.as_ptr().cast(),
        overlap.as_mut_ptr(),
    ) })
}

/// Computes [`contact()`](crate::contact), [`contact_geometry()`](crate::contact_geometry),
/// [`contact_gradient()`](crate::contact_gradient) and
/// [`contact_torque()`](crate::contact_torque) for many pairs in one call.
///
/// The forces and torques of an energy U(μ²) follow from the results. If r12 = 0, the derivatives
/// are zero, and the point and the normal are NaN.
///
/// # Arguments
///
/// - `r12`: Unit: length.
/// - `q1`, `q2`: Unit: length².
/// - `mu2`, `lambda`: The results of [`contact()`](crate::contact).
/// - `point`: Contact points relative to the centres of the first ellipsoids. Unit: length.
/// - `normal`: Unit normals.
/// - `d_r12`: ∂μ²/∂r12. Unit: 1/length.
/// - `d_rot1`, `d_rot2`: Derivatives with respect to rotations, as for
///   [`contact_torque()`](crate::contact_torque).
///
/// Row i of each slice belongs to row i of `r12`. An output that is `None` is not written.
///
/// # Errors
///
/// A slice has not as many rows as `r12`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let r12 = [[3.0, 0.5, 0.0]; 2];
/// let q1 = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let q2 = [[0.25, 0.0, 0.0, 0.25, 0.0, 0.25]; 2];
/// let mut mu2 = [0.0; 2];
/// let mut lambda = [0.0; 2];
/// let mut point = [[0.0; 3]; 2];
/// let mut normal = [[0.0; 3]; 2];
/// let mut d_r12 = [[0.0; 3]; 2];
/// let mut d_rot1 = [[0.0; 3]; 2];
/// let mut d_rot2 = [[0.0; 3]; 2];
/// pw85::contact_derivatives_batch(
///     &r12,
///     &q1,
///     &q2,
///     Some(&mut mu2),
///     Some(&mut lambda),
///     Some(&mut point),
///     Some(&mut normal),
///     Some(&mut d_r12),
///     Some(&mut d_rot1),
///     Some(&mut d_rot2),
/// )?;
/// assert_eq!(d_rot2[0], d_rot2[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn contact_derivatives_batch(
    r12: &[[f64; 3]],
    q1: &[[f64; 6]],
    q2: &[[f64; 6]],
    mu2: Option<&mut [f64]>,
    lambda: Option<&mut [f64]>,
    point: Option<&mut [[f64; 3]]>,
    normal: Option<&mut [[f64; 3]]>,
    d_r12: Option<&mut [[f64; 3]]>,
    d_rot1: Option<&mut [[f64; 3]]>,
    d_rot2: Option<&mut [[f64; 3]]>,
) -> Result<(), Error> {
    let n = r12.len();
    let counts = [
        ("q1", q1.len()),
        ("q2", q2.len()),
        ("mu2", rows_of(&mu2, n)),
        ("lambda", rows_of(&lambda, n)),
        ("point", rows_of(&point, n)),
        ("normal", rows_of(&normal, n)),
        ("d_r12", rows_of(&d_r12, n)),
        ("d_rot1", rows_of(&d_rot1, n)),
        ("d_rot2", rows_of(&d_rot2, n)),
    ];
    same_rows("pw85_contact_derivatives_batch", "must have as many rows as r12", n, &counts)?;
    check_rows(unsafe { sys::pw85_contact_derivatives_batch(
        n,
        r12.as_ptr().cast(),
        q1.as_ptr().cast(),
        q2.as_ptr().cast(),
        pointer(mu2),
        pointer(lambda),
        pointer(point),
        pointer(normal),
        pointer(d_r12),
        pointer(d_rot1),
        pointer(d_rot2),
    ) })
}

/// Computes the bounding boxes of n ellipsoids, with sides along the coordinate axes.
///
/// # Arguments
///
/// - `q`: Unit: length².
/// - `half_widths`: √Qxx, √Qyy, √Qzz, in the unit of the semi-axes. Unit: length.
///
/// Row i of each slice belongs to row i of `q`.
///
/// # Errors
///
/// A slice has not as many rows as `q`, or a row is refused. The outputs of such rows are NaN,
/// 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let q = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let mut half_widths = [[0.0; 3]; 2];
/// pw85::bounding_boxes(&q, &mut half_widths)?;
/// assert_eq!(half_widths[0], half_widths[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn bounding_boxes(q: &[[f64; 6]], half_widths: &mut [[f64; 3]]) -> Result<(), Error> {
    let n = q.len();
    let counts = [("half_widths", half_widths.len())];
    same_rows("pw85_bounding_boxes", "must have as many rows as q", n, &counts)?;
    check_rows(unsafe { sys::pw85_bounding_boxes(
        n,
        q.as_ptr().cast(),
        half_widths.as_mut_ptr().cast(),
    ) })
}

/// Computes the form of the uniform solid ellipsoid with given second moments.
///
/// 5 times the moments, the inverse of [`second_moments()`](crate::second_moments).
///
/// For a body of another shape, the result is the ellipsoid with the second moments of the body.
/// Its volume differs from that of the body. The error of each entry is below u times the entry,
/// with u = 2⁻⁵³.
///
/// # Arguments
///
/// - `second_moments`: Mean of x xᵀ over a body, about its centre. Unit: length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite.
///
/// # Examples
///
/// ```
/// let found = pw85::from_moments(&[9.0, 0.0, 0.0, 4.0, 0.0, 1.0])?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn from_moments(second_moments: &[f64; 6]) -> Result<[f64; 6], Error> {
    let mut q = [0.0; 6];
    check(unsafe { sys::pw85_from_moments(second_moments.as_ptr(), q.as_mut_ptr()) })?;
    Ok(q)
}

/// Computes [`from_moments()`](crate::from_moments) for many ellipsoids, with bitwise equal
/// results.
///
/// # Arguments
///
/// - `second_moments`, `q`: Unit: length².
///
/// Row i of each slice belongs to row i of `second_moments`.
///
/// # Errors
///
/// A slice has not as many rows as `second_moments`, or a row is refused. The outputs of such
/// rows are NaN, 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let second_moments = [[9.0, 0.0, 0.0, 4.0, 0.0, 1.0]; 2];
/// let mut q = [[0.0; 6]; 2];
/// pw85::from_moments_batch(&second_moments, &mut q)?;
/// assert_eq!(q[0], q[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn from_moments_batch(second_moments: &[[f64; 6]], q: &mut [[f64; 6]]) -> Result<(), Error> {
    let n = second_moments.len();
    let counts = [("q", q.len())];
    same_rows("pw85_from_moments_batch", "must have as many rows as second_moments", n, &counts)?;
    check_rows(unsafe { sys::pw85_from_moments_batch(
        n,
        second_moments.as_ptr().cast(),
        q.as_mut_ptr().cast(),
    ) })
}

/// Computes the form of the uniform ellipse with given second moments: 4 times the moments; see
/// [`from_moments()`](crate::from_moments).
///
/// # Arguments
///
/// - `second_moments`: Unit: length².
///
/// # Errors
///
/// A number is not finite or a form is not positive definite.
///
/// # Examples
///
/// ```
/// let found = pw85::from_moments_2d(&[9.0, 0.0, 4.0])?;
/// println!("{found:?}");
/// # Ok::<(), pw85::Error>(())
/// ```
#[inline]
pub fn from_moments_2d(second_moments: &[f64; 3]) -> Result<[f64; 3], Error> {
    let mut q = [0.0; 3];
    check(unsafe { sys::pw85_from_moments_2d(second_moments.as_ptr(), q.as_mut_ptr()) })?;
    Ok(q)
}

/// Computes [`from_moments_2d()`](crate::from_moments_2d) for many ellipses, with bitwise equal
/// results.
///
/// # Arguments
///
/// - `second_moments`, `q`: Unit: length².
///
/// Row i of each slice belongs to row i of `second_moments`.
///
/// # Errors
///
/// A slice has not as many rows as `second_moments`, or a row is refused. The outputs of such
/// rows are NaN, 255 for truth values, 2 for signs; other rows are computed.
///
/// # Examples
///
/// ```
/// let second_moments = [[9.0, 0.0, 4.0]; 2];
/// let mut q = [[0.0; 3]; 2];
/// pw85::from_moments_batch_2d(&second_moments, &mut q)?;
/// assert_eq!(q[0], q[1]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn from_moments_batch_2d(second_moments: &[[f64; 3]], q: &mut [[f64; 3]]) -> Result<(), Error> {
    let n = second_moments.len();
    let counts = [("q", q.len())];
    same_rows("pw85_from_moments_batch_2d", "must have as many rows as second_moments", n, &counts)?;
    check_rows(unsafe { sys::pw85_from_moments_batch_2d(
        n,
        second_moments.as_ptr().cast(),
        q.as_mut_ptr().cast(),
    ) })
}
