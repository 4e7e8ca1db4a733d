// SPDX-License-Identifier: BSD-3-Clause
// Made by api/rust.py from the headers of the C API.

use crate::{c_char, c_int, pw85_motion};

extern "C" {
    /// Returns the version of the library that is linked.
    pub fn pw85_version() -> *const c_char;
    /// Returns the meaning of a status, as a short text without a full stop.
    pub fn pw85_strerror(status: c_int) -> *const c_char;
    /// Switches the reproducible mode on or off, for all threads of the process.
    pub fn pw85_set_reproducible(on: c_int) -> c_int;
    /// Returns whether the reproducible mode of pw85_set_reproducible() is on.
    pub fn pw85_is_reproducible(on: *mut c_int) -> c_int;
    /// Computes the quadratic form of a spheroid, Q = a² I + (c² - a²) n nᵀ with \|n\| = 1.
    pub fn pw85_spheroid(a: f64, c: f64, n: *const f64, q: *mut f64);
    /// Computes the quadratic form of an ellipsoid, Q = R diag(semi_axes²) Rᵀ.
    pub fn pw85_ellipsoid(semi_axes: *const f64, rotation: *const f64, q: *mut f64) -> c_int;
    /// Computes the quadratic form of an ellipsoid whose orientation is a quaternion.
    pub fn pw85_ellipsoid_quaternion(
        semi_axes: *const f64,
        quaternion: *const f64,
        q: *mut f64,
    ) -> c_int;
    /// Computes a factor S of the quadratic form of an ellipsoid, Q = S Sᵀ.
    pub fn pw85_ellipsoid_factor(
        semi_axes: *const f64,
        quaternion: *const f64,
        s: *mut f64,
    ) -> c_int;
    /// Computes the quadratic form (xx, xy, yy) of an ellipse.
    pub fn pw85_ellipse(a: f64, b: f64, angle: f64, q: *mut f64) -> c_int;
    /// Computes the contact function of two ellipsoids.
    pub fn pw85_contact(r12: *const f64, q1: *const f64, q2: *const f64, out: *mut f64) -> c_int;
    /// Computes the contact function of two ellipsoids, with μ² correctly rounded.
    pub fn pw85_contact_rounded(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        out: *mut f64,
    ) -> c_int;
    /// Computes the contact function of two ellipsoids that are given by factors of their forms,
    /// Q1 = S1 S1ᵀ and Q2 = S2 S2ᵀ.
    pub fn pw85_contact_factored(
        r12: *const f64,
        s1: *const f64,
        s2: *const f64,
        out: *mut f64,
    ) -> c_int;
    /// Computes the entrywise condition number of the contact function.
    pub fn pw85_condition(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        lambda: f64,
        cond: *mut f64,
    ) -> c_int;
    /// Computes the contact function of two ellipsoids as pw85 1.0 did, by Brent's method.
    pub fn pw85_contact_function(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        out: *mut f64,
    ) -> c_int;
    /// Computes the point at which the ellipsoids, scaled by μ, touch, and their common normal
    /// there.
    pub fn pw85_contact_geometry(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        lambda: f64,
        point: *mut f64,
        normal: *mut f64,
    ) -> c_int;
    /// Computes the contact point and the normal of ellipsoids that are given by factors of their
    /// forms.
    pub fn pw85_contact_geometry_factored(
        r12: *const f64,
        s1: *const f64,
        s2: *const f64,
        lambda: f64,
        point: *mut f64,
        normal: *mut f64,
    ) -> c_int;
    /// Computes the derivatives of μ² with respect to r12 and the forms.
    pub fn pw85_contact_gradient(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        lambda: f64,
        d_r12: *mut f64,
        d_q1: *mut f64,
        d_q2: *mut f64,
    ) -> c_int;
    /// Computes the derivatives of μ² for ellipsoids that are given by factors of their forms.
    pub fn pw85_contact_gradient_factored(
        r12: *const f64,
        s1: *const f64,
        s2: *const f64,
        lambda: f64,
        d_r12: *mut f64,
        d_s1: *mut f64,
        d_s2: *mut f64,
    ) -> c_int;
    /// Computes the derivatives of μ² with respect to rotations of the ellipsoids.
    pub fn pw85_contact_torque(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        lambda: f64,
        d_rot1: *mut f64,
        d_rot2: *mut f64,
    ) -> c_int;
    /// Computes the second derivatives of μ² with respect to r12 and rotations of the ellipsoids.
    pub fn pw85_contact_hessian(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        lambda: f64,
        hessian: *mut f64,
    ) -> c_int;
    /// Tests whether two ellipsoids overlap, μ² \< 1.
    pub fn pw85_overlap(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        overlap: *mut c_int,
    ) -> c_int;
    /// Tests whether two ellipsoids that are given by factors of their forms overlap, Q1 = S1 S1ᵀ
    /// and Q2 = S2 S2ᵀ.
    pub fn pw85_overlap_factored(
        r12: *const f64,
        s1: *const f64,
        s2: *const f64,
        overlap: *mut c_int,
    ) -> c_int;
    /// Compares μ² with a number mu2 \>= 0, and returns the sign of μ² - mu2.
    pub fn pw85_compare(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        mu2: f64,
        sign: *mut c_int,
    ) -> c_int;
    /// Tests whether two ellipsoids overlap, as pw85_overlap() does, and returns a number or a
    /// point that proves the answer.
    pub fn pw85_overlap_witness(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        overlap: *mut c_int,
        lambda: *mut f64,
        point: *mut f64,
    ) -> c_int;
    /// Tests whether ellipsoid 2 is inside ellipsoid 1.
    pub fn pw85_contains(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        contains: *mut c_int,
    ) -> c_int;
    /// Computes the least factor by which ellipsoid 1 must be scaled about its centre to contain
    /// ellipsoid 2, and a point where the two then touch.
    pub fn pw85_containment(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        mu2: *mut f64,
        point: *mut f64,
    ) -> c_int;
    /// Computes the distance of closest approach of two ellipsoids along a direction.
    pub fn pw85_closest_approach(
        direction: *const f64,
        q1: *const f64,
        q2: *const f64,
        distance: *mut f64,
    ) -> c_int;
    /// Computes the volume of an ellipsoid, (4/3)π √det q.
    pub fn pw85_volume(q: *const f64, volume: *mut f64) -> c_int;
    /// Computes the volume V of the intersection of two ellipsoids.
    pub fn pw85_overlap_volume(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        volume: *mut f64,
    ) -> c_int;
    /// Computes the derivatives of the volume V of the intersection of two ellipsoids.
    pub fn pw85_overlap_volume_gradient(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        d_r12: *mut f64,
        d_q1: *mut f64,
        d_q2: *mut f64,
    ) -> c_int;
    /// Computes the derivatives of the volume V of the intersection with respect to rotations of
    /// the ellipsoids.
    pub fn pw85_overlap_volume_torque(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        d_rot1: *mut f64,
        d_rot2: *mut f64,
    ) -> c_int;
    /// Computes the area of an ellipse, π √det q.
    pub fn pw85_area_2d(q: *const f64, area: *mut f64) -> c_int;
    /// Computes the area of the intersection of two ellipses.
    pub fn pw85_overlap_area_2d(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        area: *mut f64,
    ) -> c_int;
    /// Computes the derivatives of the area of the intersection of two ellipses.
    pub fn pw85_overlap_area_gradient_2d(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        d_r12: *mut f64,
        d_q1: *mut f64,
        d_q2: *mut f64,
    ) -> c_int;
    /// Computes the derivatives of the area of the intersection with respect to the angles of
    /// both ellipses.
    pub fn pw85_overlap_area_torque_2d(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        d_rot1: *mut f64,
        d_rot2: *mut f64,
    ) -> c_int;
    /// Computes the contact function of two ellipses.
    pub fn pw85_contact_2d(r12: *const f64, q1: *const f64, q2: *const f64, out: *mut f64) -> c_int;
    /// Computes the point at which the ellipses, scaled by μ, touch, and their common normal
    /// there.
    pub fn pw85_contact_geometry_2d(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        lambda: f64,
        point: *mut f64,
        normal: *mut f64,
    ) -> c_int;
    /// Computes the derivatives of μ² of two ellipses.
    pub fn pw85_contact_gradient_2d(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        lambda: f64,
        d_r12: *mut f64,
        d_q1: *mut f64,
        d_q2: *mut f64,
    ) -> c_int;
    /// Computes the derivatives of μ² with respect to the angles of two ellipses.
    pub fn pw85_contact_torque_2d(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        lambda: f64,
        d_rot1: *mut f64,
        d_rot2: *mut f64,
    ) -> c_int;
    /// Computes the second derivatives of μ² of two ellipses.
    pub fn pw85_contact_hessian_2d(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        lambda: f64,
        hessian: *mut f64,
    ) -> c_int;
    /// Tests whether two ellipses overlap.
    pub fn pw85_overlap_2d(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        overlap: *mut c_int,
    ) -> c_int;
    /// Tests whether ellipse 2 is inside ellipse 1.
    pub fn pw85_contains_2d(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        contains: *mut c_int,
    ) -> c_int;
    /// Computes the least factor by which ellipse 1 must be scaled to contain ellipse 2.
    pub fn pw85_containment_2d(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        mu2: *mut f64,
        point: *mut f64,
    ) -> c_int;
    /// Computes the distance of closest approach of two ellipses.
    pub fn pw85_closest_approach_2d(
        direction: *const f64,
        q1: *const f64,
        q2: *const f64,
        distance: *mut f64,
    ) -> c_int;
    /// Computes the distance of the surfaces of two ellipsoids, and the points where they are
    /// closest.
    pub fn pw85_distance(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        distance: *mut f64,
        point1: *mut f64,
        point2: *mut f64,
    ) -> c_int;
    /// Computes the distance of two ellipsoids, as pw85_distance() does, with the closest points
    /// and the normal there.
    pub fn pw85_distance_geometry(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        distance: *mut f64,
        point1: *mut f64,
        point2: *mut f64,
        normal: *mut f64,
    ) -> c_int;
    /// Computes the derivatives of the distance of two ellipsoids.
    pub fn pw85_distance_derivatives(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        d_r12: *mut f64,
        d_rot1: *mut f64,
        d_rot2: *mut f64,
        hessian: *mut f64,
    ) -> c_int;
    /// Computes the penetration depth of two ellipsoids that overlap, and its direction.
    pub fn pw85_penetration(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        depth: *mut f64,
        direction: *mut f64,
    ) -> c_int;
    /// Computes the signed distance of two ellipsoids, and the points where it is reached.
    pub fn pw85_signed_distance(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        distance: *mut f64,
        point1: *mut f64,
        point2: *mut f64,
    ) -> c_int;
    /// Computes the signed distance of two ellipsoids, as pw85_signed_distance() does, with the
    /// points where it is reached and the normal there.
    pub fn pw85_signed_distance_geometry(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        distance: *mut f64,
        point1: *mut f64,
        point2: *mut f64,
        normal: *mut f64,
    ) -> c_int;
    /// Computes the derivatives of the signed distance of two ellipsoids.
    pub fn pw85_signed_distance_derivatives(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        d_r12: *mut f64,
        d_rot1: *mut f64,
        d_rot2: *mut f64,
        hessian: *mut f64,
    ) -> c_int;
    /// Computes the least gap between the surface of ellipsoid 1 and an ellipsoid 2 inside it.
    pub fn pw85_gap_inside(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        gap: *mut f64,
        point1: *mut f64,
        point2: *mut f64,
        normal: *mut f64,
    ) -> c_int;
    /// Computes the distance of two ellipses.
    pub fn pw85_distance_2d(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        distance: *mut f64,
        point1: *mut f64,
        point2: *mut f64,
    ) -> c_int;
    /// Computes the distance of two ellipses with the closest points and the normal.
    pub fn pw85_distance_geometry_2d(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        distance: *mut f64,
        point1: *mut f64,
        point2: *mut f64,
        normal: *mut f64,
    ) -> c_int;
    /// Computes the penetration depth of two ellipses.
    pub fn pw85_penetration_2d(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        depth: *mut f64,
        direction: *mut f64,
    ) -> c_int;
    /// Computes the signed distance of two ellipses.
    pub fn pw85_signed_distance_2d(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        distance: *mut f64,
        point1: *mut f64,
        point2: *mut f64,
    ) -> c_int;
    /// Computes the signed distance of two ellipses with the points where it is reached and the
    /// normal.
    pub fn pw85_signed_distance_geometry_2d(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        distance: *mut f64,
        point1: *mut f64,
        point2: *mut f64,
        normal: *mut f64,
    ) -> c_int;
    /// Computes the least gap of ellipse 2 inside ellipse 1.
    pub fn pw85_gap_inside_2d(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        gap: *mut f64,
        point1: *mut f64,
        point2: *mut f64,
        normal: *mut f64,
    ) -> c_int;
    /// Computes the time of the first contact of two moving ellipsoids.
    pub fn pw85_first_contact(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        motion1: *const pw85_motion,
        motion2: *const pw85_motion,
        t_max: f64,
        t: *mut f64,
    ) -> c_int;
    /// Computes the least μ² while ellipsoid 2 translates past ellipsoid 1 on a straight path,
    /// and the time of this minimum.
    pub fn pw85_closest_passage(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        velocity: *const f64,
        t_max: f64,
        mu2: *mut f64,
        t: *mut f64,
    ) -> c_int;
    /// Computes the free path of ellipsoid 1.
    pub fn pw85_free_path(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        direction: *const f64,
        t_max: f64,
        t: *mut f64,
    ) -> c_int;
    /// Computes the Cholesky factorisation A = L Lᵀ.
    pub fn pw85__cholesky_decomp(a: *const f64, l: *mut f64);
    /// Solves L Lᵀ x = b.
    pub fn pw85__cholesky_solve(l: *const f64, b: *const f64, x: *mut f64);
    /// Computes f, the residual g = μ2² - μ1² = -f' and its derivative g'.
    pub fn pw85__residual(
        lambda: f64,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        out: *mut f64,
    );
    /// Computes -f(λ), with all parameters in one array, as the callback of a minimiser.
    pub fn pw85_f_neg(lambda: f64, params: *const f64) -> f64;
    /// Computes the principal curvatures of the surface of an ellipsoid, and their directions, at
    /// the point with a given normal.
    pub fn pw85_curvature(
        normal: *const f64,
        q: *const f64,
        curvatures: *mut f64,
        directions: *mut f64,
    ) -> c_int;
    /// Computes the effective radius of Hertz's theory for two elastic bodies, and the shape of
    /// the contact ellipse.
    pub fn pw85_hertz(curvatures: *const f64, radius: *mut f64, ellipse: *mut f64) -> c_int;
    /// Computes the geometry of the contact of two grains along a given normal, for laws of
    /// contact such as Hertz's.
    pub fn pw85_hertz_contact(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        normal: *const f64,
        depth: *mut f64,
        point: *mut f64,
        curvatures: *mut f64,
        directions: *mut f64,
        radius: *mut f64,
        ellipse: *mut f64,
    ) -> c_int;
    /// Finds the common normal of two grains by Newton's method, and computes their contact along
    /// it.
    pub fn pw85_grain_contact(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        start: *const f64,
        normal: *mut f64,
        depth: *mut f64,
        point: *mut f64,
        curvatures: *mut f64,
        radius: *mut f64,
    ) -> c_int;
    /// Computes the derivatives of the radius of pw85_grain_contact().
    pub fn pw85_grain_radius_gradient(
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        normal: *const f64,
        d_r12: *mut f64,
        d_rot1: *mut f64,
        d_rot2: *mut f64,
    ) -> c_int;
    /// Computes the contact of a grain with its centre at 0 and a wall.
    pub fn pw85_grain_contact_wall(
        normal: *const f64,
        offset: f64,
        direction: *const f64,
        curvature: f64,
        q: *const f64,
        depth: *mut f64,
        point: *mut f64,
        curvatures: *mut f64,
        radius: *mut f64,
    ) -> c_int;
    /// Computes the surface area of an ellipsoid, 4π abc R_G(1/a², 1/b², 1/c²), with Carlson's
    /// integral R_G.
    pub fn pw85_surface_area(q: *const f64, area: *mut f64) -> c_int;
    /// Computes the mean of x xᵀ over a uniform solid ellipsoid, about its centre.
    pub fn pw85_second_moments(q: *const f64, moments: *mut f64) -> c_int;
    /// Computes the form of the uniform solid ellipsoid with given second moments.
    pub fn pw85_from_moments(second_moments: *const f64, q: *mut f64) -> c_int;
    /// Computes the mean of x xᵀ over the surface of an ellipsoid, about its centre.
    pub fn pw85_shell_moments(q: *const f64, moments: *mut f64) -> c_int;
    /// Computes the inertia tensor of a solid body or of a shell of unit density, about its
    /// centre.
    pub fn pw85_inertia(q: *const f64, shell: c_int, inertia: *mut f64) -> c_int;
    /// Computes the perimeter of an ellipse, 8 R_G(0, a², b²), with Carlson's integral R_G.
    pub fn pw85_perimeter_2d(q: *const f64, perimeter: *mut f64) -> c_int;
    /// Computes the mean of x xᵀ over a uniform ellipse, about its centre.
    pub fn pw85_second_moments_2d(q: *const f64, moments: *mut f64) -> c_int;
    /// Computes the form of the uniform ellipse with given second moments.
    pub fn pw85_from_moments_2d(second_moments: *const f64, q: *mut f64) -> c_int;
    /// Computes the mean of x xᵀ over the perimeter of an ellipse, about its centre.
    pub fn pw85_shell_moments_2d(q: *const f64, moments: *mut f64) -> c_int;
    /// Computes the distance from an ellipsoid with its centre at 0 to the half-space normal·x
    /// \>= offset.
    pub fn pw85_distance_plane(
        normal: *const f64,
        offset: f64,
        q: *const f64,
        distance: *mut f64,
        point: *mut f64,
    ) -> c_int;
    /// Computes the derivatives of the distance to a half-space, which do not depend on its
    /// offset.
    pub fn pw85_distance_plane_derivatives(
        normal: *const f64,
        q: *const f64,
        d_center: *mut f64,
        d_rot: *mut f64,
    ) -> c_int;
    /// Computes the contact function of an ellipsoid with its centre at 0 and the half-space
    /// normal·x \>= offset.
    pub fn pw85_contact_plane(
        normal: *const f64,
        offset: f64,
        q: *const f64,
        mu2: *mut f64,
        point: *mut f64,
    ) -> c_int;
    /// Computes the derivatives of μ² of pw85_contact_plane().
    pub fn pw85_contact_plane_derivatives(
        normal: *const f64,
        offset: f64,
        q: *const f64,
        d_center: *mut f64,
        d_rot: *mut f64,
    ) -> c_int;
    /// Computes the distance from an ellipsoid with its centre at 0 to the nearest face of a box
    /// that contains it.
    pub fn pw85_distance_box(
        lower: *const f64,
        upper: *const f64,
        q: *const f64,
        distance: *mut f64,
        point: *mut f64,
        normal: *mut f64,
    ) -> c_int;
    /// Computes the distance from an ellipsoid to the wall of a cylinder of infinite length that
    /// contains it.
    pub fn pw85_distance_cylinder(
        axis: *const f64,
        radius: f64,
        center: *const f64,
        q: *const f64,
        distance: *mut f64,
        point: *mut f64,
        normal: *mut f64,
    ) -> c_int;
    /// Computes the distance from a point to the surface of an ellipsoid.
    pub fn pw85_distance_point(
        r: *const f64,
        q: *const f64,
        distance: *mut f64,
        point: *mut f64,
        normal: *mut f64,
    ) -> c_int;
    /// Computes the interval t\[0\] \<= t \<= t\[1\] in which the line origin + t·direction is
    /// inside an ellipsoid.
    pub fn pw85_intersect_line(
        origin: *const f64,
        direction: *const f64,
        q: *const f64,
        t: *mut f64,
    ) -> c_int;
    /// Computes the volume of the part of an ellipsoid that is in the half-space normal·x \<=
    /// offset, where x is relative to the centre of the ellipsoid.
    pub fn pw85_overlap_volume_plane(
        normal: *const f64,
        offset: f64,
        q: *const f64,
        volume: *mut f64,
    ) -> c_int;
    /// Computes the contact function of an ellipsoid and a segment.
    pub fn pw85_contact_segment(
        end1: *const f64,
        end2: *const f64,
        q: *const f64,
        mu2: *mut f64,
        point: *mut f64,
    ) -> c_int;
    /// Computes the contact function of an ellipsoid and a triangle.
    pub fn pw85_contact_triangle(
        vertex1: *const f64,
        vertex2: *const f64,
        vertex3: *const f64,
        q: *const f64,
        mu2: *mut f64,
        point: *mut f64,
    ) -> c_int;
    /// Computes the contact function of an ellipsoid and a solid box with sides along the axes.
    pub fn pw85_contact_box(
        lower: *const f64,
        upper: *const f64,
        q: *const f64,
        mu2: *mut f64,
        point: *mut f64,
    ) -> c_int;
    /// Computes the contact function of an ellipsoid and a polytope.
    pub fn pw85_contact_polytope(
        n: usize,
        normals: *const f64,
        offsets: *const f64,
        q: *const f64,
        mu2: *mut f64,
        point: *mut f64,
    ) -> c_int;
    /// Tests whether an ellipsoid and a segment overlap, μ² \< 1.
    pub fn pw85_overlap_segment(
        end1: *const f64,
        end2: *const f64,
        q: *const f64,
        overlap: *mut c_int,
    ) -> c_int;
    /// Tests whether an ellipsoid and a triangle overlap, μ² \< 1.
    pub fn pw85_overlap_triangle(
        vertex1: *const f64,
        vertex2: *const f64,
        vertex3: *const f64,
        q: *const f64,
        overlap: *mut c_int,
    ) -> c_int;
    /// Tests whether an ellipsoid and a solid box with sides along the axes overlap, μ² \< 1.
    pub fn pw85_overlap_box(
        lower: *const f64,
        upper: *const f64,
        q: *const f64,
        overlap: *mut c_int,
    ) -> c_int;
    /// Tests whether an ellipsoid and a polytope overlap, μ² \< 1.
    pub fn pw85_overlap_polytope(
        n: usize,
        normals: *const f64,
        offsets: *const f64,
        q: *const f64,
        overlap: *mut c_int,
    ) -> c_int;
    /// Computes the signed distance of an ellipsoid and a segment, and the points where it is
    /// reached.
    pub fn pw85_distance_segment(
        end1: *const f64,
        end2: *const f64,
        q: *const f64,
        distance: *mut f64,
        point1: *mut f64,
        point2: *mut f64,
        normal: *mut f64,
    ) -> c_int;
    /// Computes the signed distance of an ellipsoid and a triangle, and the points where it is
    /// reached.
    pub fn pw85_distance_triangle(
        vertex1: *const f64,
        vertex2: *const f64,
        vertex3: *const f64,
        q: *const f64,
        distance: *mut f64,
        point1: *mut f64,
        point2: *mut f64,
        normal: *mut f64,
    ) -> c_int;
    /// Computes the signed distance of an ellipsoid and a solid box with sides along the axes,
    /// and the points where it is reached.
    pub fn pw85_distance_solid_box(
        lower: *const f64,
        upper: *const f64,
        q: *const f64,
        distance: *mut f64,
        point1: *mut f64,
        point2: *mut f64,
        normal: *mut f64,
    ) -> c_int;
    /// Computes the contact function of an ellipsoid and a capsule.
    pub fn pw85_contact_capsule(
        end1: *const f64,
        end2: *const f64,
        radius: f64,
        q: *const f64,
        mu2: *mut f64,
        point: *mut f64,
    ) -> c_int;
    /// Tests whether an ellipsoid and a capsule overlap, μ² \< 1.
    pub fn pw85_overlap_capsule(
        end1: *const f64,
        end2: *const f64,
        radius: f64,
        q: *const f64,
        overlap: *mut c_int,
    ) -> c_int;
    /// Computes the signed distance of an ellipsoid and a capsule, and the points where it is
    /// reached.
    pub fn pw85_distance_capsule(
        end1: *const f64,
        end2: *const f64,
        radius: f64,
        q: *const f64,
        distance: *mut f64,
        point1: *mut f64,
        point2: *mut f64,
        normal: *mut f64,
    ) -> c_int;
    /// Computes the distance from a point to the perimeter of an ellipse.
    pub fn pw85_distance_point_2d(
        r: *const f64,
        q: *const f64,
        distance: *mut f64,
        point: *mut f64,
        normal: *mut f64,
    ) -> c_int;
    /// Computes the contact function of an ellipse and a segment.
    pub fn pw85_contact_segment_2d(
        end1: *const f64,
        end2: *const f64,
        q: *const f64,
        mu2: *mut f64,
        point: *mut f64,
    ) -> c_int;
    /// Computes the contact function of an ellipse and a solid rectangle with sides along the
    /// axes.
    pub fn pw85_contact_box_2d(
        lower: *const f64,
        upper: *const f64,
        q: *const f64,
        mu2: *mut f64,
        point: *mut f64,
    ) -> c_int;
    /// Tests whether an ellipse and a segment overlap.
    pub fn pw85_overlap_segment_2d(
        end1: *const f64,
        end2: *const f64,
        q: *const f64,
        overlap: *mut c_int,
    ) -> c_int;
    /// Tests whether an ellipse and a solid rectangle with sides along the axes overlap.
    pub fn pw85_overlap_box_2d(
        lower: *const f64,
        upper: *const f64,
        q: *const f64,
        overlap: *mut c_int,
    ) -> c_int;
    /// Computes pw85_ellipsoid_quaternion() for n ellipsoids, with bitwise equal results.
    pub fn pw85_ellipsoid_quaternion_batch(
        n: usize,
        semi_axes: *const f64,
        quaternions: *const f64,
        q: *mut f64,
    ) -> c_int;
    /// Computes pw85_ellipsoid_factor() for n ellipsoids, with bitwise equal results.
    pub fn pw85_ellipsoid_factor_batch(
        n: usize,
        semi_axes: *const f64,
        quaternions: *const f64,
        s: *mut f64,
    ) -> c_int;
    /// Computes pw85_contact() for n pairs.
    pub fn pw85_contact_batch(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        mu2: *mut f64,
        lambda: *mut f64,
    ) -> c_int;
    /// Computes pw85_contact_rounded() for n pairs, with bitwise equal results.
    pub fn pw85_contact_rounded_batch(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        mu2: *mut f64,
        lambda: *mut f64,
    ) -> c_int;
    /// Computes pw85_contact_factored() for n pairs, with bitwise equal results.
    pub fn pw85_contact_factored_batch(
        n: usize,
        r12: *const f64,
        s1: *const f64,
        s2: *const f64,
        mu2: *mut f64,
        lambda: *mut f64,
    ) -> c_int;
    /// Computes pw85_condition() for n pairs, with bitwise equal results.
    pub fn pw85_condition_batch(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        lambda: *const f64,
        cond: *mut f64,
    ) -> c_int;
    /// Computes pw85_contact_function() for n pairs, with bitwise equal results.
    pub fn pw85_contact_function_batch(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        mu2: *mut f64,
        lambda: *mut f64,
    ) -> c_int;
    /// Computes pw85_contact_geometry() for n pairs, with bitwise equal results.
    pub fn pw85_contact_geometry_batch(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        lambda: *const f64,
        point: *mut f64,
        normal: *mut f64,
    ) -> c_int;
    /// Computes pw85_contact_geometry_factored() for n pairs, with bitwise equal results.
    pub fn pw85_contact_geometry_factored_batch(
        n: usize,
        r12: *const f64,
        s1: *const f64,
        s2: *const f64,
        lambda: *const f64,
        point: *mut f64,
        normal: *mut f64,
    ) -> c_int;
    /// Computes pw85_contact_gradient() for n pairs, with bitwise equal results.
    pub fn pw85_contact_gradient_batch(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        lambda: *const f64,
        d_r12: *mut f64,
        d_q1: *mut f64,
        d_q2: *mut f64,
    ) -> c_int;
    /// Computes pw85_contact_gradient_factored() for n pairs, with bitwise equal results.
    pub fn pw85_contact_gradient_factored_batch(
        n: usize,
        r12: *const f64,
        s1: *const f64,
        s2: *const f64,
        lambda: *const f64,
        d_r12: *mut f64,
        d_s1: *mut f64,
        d_s2: *mut f64,
    ) -> c_int;
    /// Computes pw85_contact_torque() for n pairs, with bitwise equal results.
    pub fn pw85_contact_torque_batch(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        lambda: *const f64,
        d_rot1: *mut f64,
        d_rot2: *mut f64,
    ) -> c_int;
    /// Computes pw85_contact_hessian() for n pairs, with bitwise equal results.
    pub fn pw85_contact_hessian_batch(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        lambda: *const f64,
        hessian: *mut f64,
    ) -> c_int;
    /// Computes pw85_overlap() for n pairs, with the same answers.
    pub fn pw85_overlap_batch(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        overlap: *mut u8,
    ) -> c_int;
    /// Computes pw85_overlap_factored() for n pairs, with the same answers.
    pub fn pw85_overlap_factored_batch(
        n: usize,
        r12: *const f64,
        s1: *const f64,
        s2: *const f64,
        overlap: *mut u8,
    ) -> c_int;
    /// Computes pw85_compare() for n pairs, with the same signs.
    pub fn pw85_compare_batch(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        mu2: *const f64,
        sign: *mut c_int,
    ) -> c_int;
    /// Computes pw85_overlap_witness() for n pairs, with the same results.
    pub fn pw85_overlap_witness_batch(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        overlap: *mut u8,
        lambda: *mut f64,
        point: *mut f64,
    ) -> c_int;
    /// Computes pw85_contains() for n pairs, with the same answers.
    pub fn pw85_contains_batch(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        contains: *mut u8,
    ) -> c_int;
    /// Computes pw85_containment() for n pairs, with bitwise equal results.
    pub fn pw85_containment_batch(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        mu2: *mut f64,
        point: *mut f64,
    ) -> c_int;
    /// Computes pw85_closest_approach() for n pairs.
    pub fn pw85_closest_approach_batch(
        n: usize,
        directions: *const f64,
        q1: *const f64,
        q2: *const f64,
        distance: *mut f64,
    ) -> c_int;
    /// Computes pw85_volume() for n ellipsoids, with bitwise equal results.
    pub fn pw85_volume_batch(n: usize, q: *const f64, volume: *mut f64) -> c_int;
    /// Computes pw85_overlap_volume() for n pairs, with bitwise equal results.
    pub fn pw85_overlap_volume_batch(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        volume: *mut f64,
    ) -> c_int;
    /// Computes pw85_overlap_volume_gradient() for n pairs, with bitwise equal results.
    pub fn pw85_overlap_volume_gradient_batch(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        d_r12: *mut f64,
        d_q1: *mut f64,
        d_q2: *mut f64,
    ) -> c_int;
    /// Computes pw85_overlap_volume_torque() for n pairs, with bitwise equal results.
    pub fn pw85_overlap_volume_torque_batch(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        d_rot1: *mut f64,
        d_rot2: *mut f64,
    ) -> c_int;
    /// Computes pw85_area_2d() for n ellipses, with bitwise equal results.
    pub fn pw85_area_batch_2d(n: usize, q: *const f64, area: *mut f64) -> c_int;
    /// Computes pw85_overlap_area_2d() for n pairs, with bitwise equal results.
    pub fn pw85_overlap_area_batch_2d(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        area: *mut f64,
    ) -> c_int;
    /// Computes pw85_overlap_area_gradient_2d() for n pairs, with bitwise equal results.
    pub fn pw85_overlap_area_gradient_batch_2d(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        d_r12: *mut f64,
        d_q1: *mut f64,
        d_q2: *mut f64,
    ) -> c_int;
    /// Computes pw85_overlap_area_torque_2d() for n pairs, with bitwise equal results.
    pub fn pw85_overlap_area_torque_batch_2d(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        d_rot1: *mut f64,
        d_rot2: *mut f64,
    ) -> c_int;
    /// Computes pw85_contact_2d() for n pairs.
    pub fn pw85_contact_batch_2d(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        mu2: *mut f64,
        lambda: *mut f64,
    ) -> c_int;
    /// Computes pw85_contact_geometry_2d() for n pairs, with bitwise equal results.
    pub fn pw85_contact_geometry_batch_2d(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        lambda: *const f64,
        point: *mut f64,
        normal: *mut f64,
    ) -> c_int;
    /// Computes pw85_contact_gradient_2d() for n pairs, with bitwise equal results.
    pub fn pw85_contact_gradient_batch_2d(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        lambda: *const f64,
        d_r12: *mut f64,
        d_q1: *mut f64,
        d_q2: *mut f64,
    ) -> c_int;
    /// Computes pw85_contact_torque_2d() for n pairs, with bitwise equal results.
    pub fn pw85_contact_torque_batch_2d(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        lambda: *const f64,
        d_rot1: *mut f64,
        d_rot2: *mut f64,
    ) -> c_int;
    /// Computes pw85_contact_hessian_2d() for n pairs, with bitwise equal results.
    pub fn pw85_contact_hessian_batch_2d(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        lambda: *const f64,
        hessian: *mut f64,
    ) -> c_int;
    /// Computes pw85_overlap_2d() for n pairs.
    pub fn pw85_overlap_batch_2d(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        overlap: *mut u8,
    ) -> c_int;
    /// Computes pw85_closest_approach_2d() for n pairs, with bitwise equal results.
    pub fn pw85_closest_approach_batch_2d(
        n: usize,
        directions: *const f64,
        q1: *const f64,
        q2: *const f64,
        distance: *mut f64,
    ) -> c_int;
    /// Computes pw85_distance() for n pairs.
    pub fn pw85_distance_batch(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        distance: *mut f64,
        point1: *mut f64,
        point2: *mut f64,
    ) -> c_int;
    /// Computes pw85_distance_geometry() for n pairs.
    pub fn pw85_distance_geometry_batch(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        distance: *mut f64,
        point1: *mut f64,
        point2: *mut f64,
        normal: *mut f64,
    ) -> c_int;
    /// Computes pw85_distance_derivatives() for n pairs, with bitwise equal results.
    pub fn pw85_distance_derivatives_batch(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        d_r12: *mut f64,
        d_rot1: *mut f64,
        d_rot2: *mut f64,
        hessian: *mut f64,
    ) -> c_int;
    /// Computes pw85_penetration() for n pairs, with bitwise equal results.
    pub fn pw85_penetration_batch(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        depth: *mut f64,
        direction: *mut f64,
    ) -> c_int;
    /// Computes pw85_signed_distance() for n pairs.
    pub fn pw85_signed_distance_batch(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        distance: *mut f64,
        point1: *mut f64,
        point2: *mut f64,
    ) -> c_int;
    /// Computes pw85_signed_distance_geometry() for n pairs.
    pub fn pw85_signed_distance_geometry_batch(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        distance: *mut f64,
        point1: *mut f64,
        point2: *mut f64,
        normal: *mut f64,
    ) -> c_int;
    /// Computes pw85_signed_distance_derivatives() for n pairs, with bitwise equal results.
    pub fn pw85_signed_distance_derivatives_batch(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        d_r12: *mut f64,
        d_rot1: *mut f64,
        d_rot2: *mut f64,
        hessian: *mut f64,
    ) -> c_int;
    /// Computes pw85_gap_inside() for n pairs, with bitwise equal results.
    pub fn pw85_gap_inside_batch(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        gap: *mut f64,
        point1: *mut f64,
        point2: *mut f64,
        normal: *mut f64,
    ) -> c_int;
    /// Computes pw85_distance_2d() for n pairs, with bitwise equal results.
    pub fn pw85_distance_batch_2d(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        distance: *mut f64,
        point1: *mut f64,
        point2: *mut f64,
    ) -> c_int;
    /// Computes pw85_distance_geometry_2d() for n pairs, with bitwise equal results.
    pub fn pw85_distance_geometry_batch_2d(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        distance: *mut f64,
        point1: *mut f64,
        point2: *mut f64,
        normal: *mut f64,
    ) -> c_int;
    /// Computes pw85_penetration_2d() for n pairs, with bitwise equal results.
    pub fn pw85_penetration_batch_2d(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        depth: *mut f64,
        direction: *mut f64,
    ) -> c_int;
    /// Computes pw85_signed_distance_2d() for n pairs, with bitwise equal results.
    pub fn pw85_signed_distance_batch_2d(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        distance: *mut f64,
        point1: *mut f64,
        point2: *mut f64,
    ) -> c_int;
    /// Computes pw85_signed_distance_geometry_2d() for n pairs, with bitwise equal results.
    pub fn pw85_signed_distance_geometry_batch_2d(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        distance: *mut f64,
        point1: *mut f64,
        point2: *mut f64,
        normal: *mut f64,
    ) -> c_int;
    /// Computes pw85_gap_inside_2d() for n pairs, with bitwise equal results.
    pub fn pw85_gap_inside_batch_2d(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        gap: *mut f64,
        point1: *mut f64,
        point2: *mut f64,
        normal: *mut f64,
    ) -> c_int;
    /// Computes pw85_first_contact() for n pairs, with bitwise equal results.
    pub fn pw85_first_contact_batch(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        motion1: *const pw85_motion,
        motion2: *const pw85_motion,
        t_max: f64,
        t: *mut f64,
    ) -> c_int;
    /// Computes pw85_closest_passage() for n pairs.
    pub fn pw85_closest_passage_batch(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        velocity: *const f64,
        t_max: f64,
        mu2: *mut f64,
        t: *mut f64,
    ) -> c_int;
    /// Computes pw85_free_path() for n pairs, with bitwise equal results.
    pub fn pw85_free_path_batch(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        directions: *const f64,
        t_max: *const f64,
        t: *mut f64,
    ) -> c_int;
    /// Computes pw85_curvature() for n ellipsoids, with bitwise equal results.
    pub fn pw85_curvature_batch(
        n: usize,
        normals: *const f64,
        q: *const f64,
        curvatures: *mut f64,
        directions: *mut f64,
    ) -> c_int;
    /// Computes pw85_hertz() for n contacts, with bitwise equal results.
    pub fn pw85_hertz_batch(
        n: usize,
        curvatures: *const f64,
        radius: *mut f64,
        ellipse: *mut f64,
    ) -> c_int;
    /// Computes pw85_hertz_contact() for n pairs, with bitwise equal results.
    pub fn pw85_hertz_contact_batch(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        normals: *const f64,
        depth: *mut f64,
        point: *mut f64,
        curvatures: *mut f64,
        directions: *mut f64,
        radius: *mut f64,
        ellipse: *mut f64,
    ) -> c_int;
    /// Computes pw85_grain_contact() for n pairs.
    pub fn pw85_grain_contact_batch(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        starts: *const f64,
        normal: *mut f64,
        depth: *mut f64,
        point: *mut f64,
        curvatures: *mut f64,
        radius: *mut f64,
    ) -> c_int;
    /// Computes pw85_grain_radius_gradient() for n pairs, with bitwise equal results.
    pub fn pw85_grain_radius_gradient_batch(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        normals: *const f64,
        d_r12: *mut f64,
        d_rot1: *mut f64,
        d_rot2: *mut f64,
    ) -> c_int;
    /// Computes pw85_grain_contact_wall() for n ellipsoids and walls, with bitwise equal results.
    pub fn pw85_grain_contact_wall_batch(
        n: usize,
        normals: *const f64,
        offsets: *const f64,
        directions: *const f64,
        curvature: *const f64,
        q: *const f64,
        depth: *mut f64,
        point: *mut f64,
        curvatures: *mut f64,
        radius: *mut f64,
    ) -> c_int;
    /// Computes pw85_surface_area() for n ellipsoids, with bitwise equal results.
    pub fn pw85_surface_area_batch(n: usize, q: *const f64, area: *mut f64) -> c_int;
    /// Computes pw85_second_moments() for n ellipsoids, with bitwise equal results.
    pub fn pw85_second_moments_batch(n: usize, q: *const f64, moments: *mut f64) -> c_int;
    /// Computes pw85_from_moments() for n ellipsoids, with bitwise equal results.
    pub fn pw85_from_moments_batch(n: usize, second_moments: *const f64, q: *mut f64) -> c_int;
    /// Computes pw85_shell_moments() for n ellipsoids, with bitwise equal results.
    pub fn pw85_shell_moments_batch(n: usize, q: *const f64, moments: *mut f64) -> c_int;
    /// Computes pw85_inertia() for n ellipsoids, with bitwise equal results.
    pub fn pw85_inertia_batch(n: usize, q: *const f64, shell: c_int, inertia: *mut f64) -> c_int;
    /// Computes pw85_perimeter_2d() for n ellipses, with bitwise equal results.
    pub fn pw85_perimeter_batch_2d(n: usize, q: *const f64, perimeter: *mut f64) -> c_int;
    /// Computes pw85_second_moments_2d() for n ellipses, with bitwise equal results.
    pub fn pw85_second_moments_batch_2d(n: usize, q: *const f64, moments: *mut f64) -> c_int;
    /// Computes pw85_from_moments_2d() for n ellipses, with bitwise equal results.
    pub fn pw85_from_moments_batch_2d(n: usize, second_moments: *const f64, q: *mut f64) -> c_int;
    /// Computes pw85_shell_moments_2d() for n ellipses, with bitwise equal results.
    pub fn pw85_shell_moments_batch_2d(n: usize, q: *const f64, moments: *mut f64) -> c_int;
    /// Computes pw85_distance_plane() for n ellipsoids and half-spaces, with bitwise equal
    /// results.
    pub fn pw85_distance_plane_batch(
        n: usize,
        normals: *const f64,
        offsets: *const f64,
        q: *const f64,
        distance: *mut f64,
        point: *mut f64,
    ) -> c_int;
    /// Computes pw85_distance_plane_derivatives() for n ellipsoids and half-spaces, with bitwise
    /// equal results.
    pub fn pw85_distance_plane_derivatives_batch(
        n: usize,
        normals: *const f64,
        q: *const f64,
        d_center: *mut f64,
        d_rot: *mut f64,
    ) -> c_int;
    /// Computes pw85_contact_plane() for n ellipsoids and half-spaces, with bitwise equal
    /// results.
    pub fn pw85_contact_plane_batch(
        n: usize,
        normals: *const f64,
        offsets: *const f64,
        q: *const f64,
        mu2: *mut f64,
        point: *mut f64,
    ) -> c_int;
    /// Computes pw85_contact_plane_derivatives() for n ellipsoids and half-spaces, with bitwise
    /// equal results.
    pub fn pw85_contact_plane_derivatives_batch(
        n: usize,
        normals: *const f64,
        offsets: *const f64,
        q: *const f64,
        d_center: *mut f64,
        d_rot: *mut f64,
    ) -> c_int;
    /// Computes pw85_distance_box() for n ellipsoids and boxes, with bitwise equal results.
    pub fn pw85_distance_box_batch(
        n: usize,
        lower: *const f64,
        upper: *const f64,
        q: *const f64,
        distance: *mut f64,
        point: *mut f64,
        normal: *mut f64,
    ) -> c_int;
    /// Computes pw85_distance_cylinder() for n ellipsoids and cylinders, with bitwise equal
    /// results.
    pub fn pw85_distance_cylinder_batch(
        n: usize,
        axis: *const f64,
        radius: *const f64,
        center: *const f64,
        q: *const f64,
        distance: *mut f64,
        point: *mut f64,
        normal: *mut f64,
    ) -> c_int;
    /// Computes pw85_distance_point() for n points and ellipsoids, with bitwise equal results.
    pub fn pw85_distance_point_batch(
        n: usize,
        r: *const f64,
        q: *const f64,
        distance: *mut f64,
        point: *mut f64,
        normal: *mut f64,
    ) -> c_int;
    /// Computes pw85_intersect_line() for n lines and ellipsoids, with bitwise equal results.
    pub fn pw85_intersect_line_batch(
        n: usize,
        origin: *const f64,
        directions: *const f64,
        q: *const f64,
        enter: *mut f64,
        leave: *mut f64,
    ) -> c_int;
    /// Computes pw85_overlap_volume_plane() for n ellipsoids and half-spaces, with bitwise equal
    /// results.
    pub fn pw85_overlap_volume_plane_batch(
        n: usize,
        normals: *const f64,
        offsets: *const f64,
        q: *const f64,
        volume: *mut f64,
    ) -> c_int;
    /// Computes pw85_contact_segment() for n ellipsoids and segments.
    pub fn pw85_contact_segment_batch(
        n: usize,
        end1: *const f64,
        end2: *const f64,
        q: *const f64,
        mu2: *mut f64,
        point: *mut f64,
    ) -> c_int;
    /// Computes pw85_contact_triangle() for n ellipsoids and triangles.
    pub fn pw85_contact_triangle_batch(
        n: usize,
        vertex1: *const f64,
        vertex2: *const f64,
        vertex3: *const f64,
        q: *const f64,
        mu2: *mut f64,
        point: *mut f64,
    ) -> c_int;
    /// Computes pw85_contact_box() for n ellipsoids and boxes.
    pub fn pw85_contact_box_batch(
        n: usize,
        lower: *const f64,
        upper: *const f64,
        q: *const f64,
        mu2: *mut f64,
        point: *mut f64,
    ) -> c_int;
    /// Computes pw85_overlap_segment() for n ellipsoids and segments, with the same answers.
    pub fn pw85_overlap_segment_batch(
        n: usize,
        end1: *const f64,
        end2: *const f64,
        q: *const f64,
        overlap: *mut u8,
    ) -> c_int;
    /// Computes pw85_overlap_triangle() for n ellipsoids and triangles, with the same answers.
    pub fn pw85_overlap_triangle_batch(
        n: usize,
        vertex1: *const f64,
        vertex2: *const f64,
        vertex3: *const f64,
        q: *const f64,
        overlap: *mut u8,
    ) -> c_int;
    /// Computes pw85_overlap_box() for n ellipsoids and boxes, with the same answers.
    pub fn pw85_overlap_box_batch(
        n: usize,
        lower: *const f64,
        upper: *const f64,
        q: *const f64,
        overlap: *mut u8,
    ) -> c_int;
    /// Computes pw85_distance_segment() for n ellipsoids and segments, with bitwise equal
    /// results.
    pub fn pw85_distance_segment_batch(
        n: usize,
        end1: *const f64,
        end2: *const f64,
        q: *const f64,
        distance: *mut f64,
        point1: *mut f64,
        point2: *mut f64,
        normal: *mut f64,
    ) -> c_int;
    /// Computes pw85_distance_triangle() for n ellipsoids and triangles, with bitwise equal
    /// results.
    pub fn pw85_distance_triangle_batch(
        n: usize,
        vertex1: *const f64,
        vertex2: *const f64,
        vertex3: *const f64,
        q: *const f64,
        distance: *mut f64,
        point1: *mut f64,
        point2: *mut f64,
        normal: *mut f64,
    ) -> c_int;
    /// Computes pw85_distance_solid_box() for n ellipsoids and boxes, with bitwise equal results.
    pub fn pw85_distance_solid_box_batch(
        n: usize,
        lower: *const f64,
        upper: *const f64,
        q: *const f64,
        distance: *mut f64,
        point1: *mut f64,
        point2: *mut f64,
        normal: *mut f64,
    ) -> c_int;
    /// Computes pw85_contact_capsule() for n ellipsoids and capsules, with bitwise equal results.
    pub fn pw85_contact_capsule_batch(
        n: usize,
        end1: *const f64,
        end2: *const f64,
        radius: *const f64,
        q: *const f64,
        mu2: *mut f64,
        point: *mut f64,
    ) -> c_int;
    /// Computes pw85_overlap_capsule() for n ellipsoids and capsules, with the same answers.
    pub fn pw85_overlap_capsule_batch(
        n: usize,
        end1: *const f64,
        end2: *const f64,
        radius: *const f64,
        q: *const f64,
        overlap: *mut u8,
    ) -> c_int;
    /// Computes pw85_distance_capsule() for n ellipsoids and capsules, with bitwise equal
    /// results.
    pub fn pw85_distance_capsule_batch(
        n: usize,
        end1: *const f64,
        end2: *const f64,
        radius: *const f64,
        q: *const f64,
        distance: *mut f64,
        point1: *mut f64,
        point2: *mut f64,
        normal: *mut f64,
    ) -> c_int;
    /// Computes pw85_distance_point_2d() for n points and ellipses, with bitwise equal results.
    pub fn pw85_distance_point_batch_2d(
        n: usize,
        r: *const f64,
        q: *const f64,
        distance: *mut f64,
        point: *mut f64,
        normal: *mut f64,
    ) -> c_int;
    /// Computes pw85_contact_segment_2d() for n ellipses and segments, with bitwise equal
    /// results.
    pub fn pw85_contact_segment_batch_2d(
        n: usize,
        end1: *const f64,
        end2: *const f64,
        q: *const f64,
        mu2: *mut f64,
        point: *mut f64,
    ) -> c_int;
    /// Computes pw85_contact_box_2d() for n ellipses and boxes, with bitwise equal results.
    pub fn pw85_contact_box_batch_2d(
        n: usize,
        lower: *const f64,
        upper: *const f64,
        q: *const f64,
        mu2: *mut f64,
        point: *mut f64,
    ) -> c_int;
    /// Computes pw85_overlap_segment_2d() for n ellipses and segments, with the same answers.
    pub fn pw85_overlap_segment_batch_2d(
        n: usize,
        end1: *const f64,
        end2: *const f64,
        q: *const f64,
        overlap: *mut u8,
    ) -> c_int;
    /// Computes pw85_overlap_box_2d() for n ellipses and boxes, with the same answers.
    pub fn pw85_overlap_box_batch_2d(
        n: usize,
        lower: *const f64,
        upper: *const f64,
        q: *const f64,
        overlap: *mut u8,
    ) -> c_int;
    /// Computes pw85_contact(), pw85_contact_geometry(), pw85_contact_gradient() and
    /// pw85_contact_torque() for n pairs in one call.
    pub fn pw85_contact_derivatives_batch(
        n: usize,
        r12: *const f64,
        q1: *const f64,
        q2: *const f64,
        mu2: *mut f64,
        lambda: *mut f64,
        point: *mut f64,
        normal: *mut f64,
        d_r12: *mut f64,
        d_rot1: *mut f64,
        d_rot2: *mut f64,
    ) -> c_int;
    /// Computes pw85_contact_polytope() for many ellipsoids and one polytope.
    pub fn pw85_contact_polytope_batch(
        num_ellipsoids: usize,
        centers: *const f64,
        q: *const f64,
        num_planes: usize,
        normals: *const f64,
        offsets: *const f64,
        mu2: *mut f64,
        point: *mut f64,
    ) -> c_int;
    /// Tests which of many ellipsoids overlap one polytope, such as the frustum of a camera.
    pub fn pw85_overlap_polytope_batch(
        num_ellipsoids: usize,
        centers: *const f64,
        q: *const f64,
        num_planes: usize,
        normals: *const f64,
        offsets: *const f64,
        overlap: *mut u8,
    ) -> c_int;
    /// Tests whether an ellipsoid overlaps any of n others.
    pub fn pw85_overlap_any(
        q1: *const f64,
        n: usize,
        r12: *const f64,
        q2: *const f64,
        any: *mut c_int,
    ) -> c_int;
    /// Computes the bounding boxes of n ellipsoids, with sides along the coordinate axes.
    pub fn pw85_bounding_boxes(n: usize, q: *const f64, half_widths: *mut f64) -> c_int;
    /// Computes the ellipsoid of least volume around points, up to a tolerance, with a proof.
    pub fn pw85_enclosing_ellipsoid(
        n: c_int,
        m: usize,
        points: *const f64,
        tolerance: f64,
        center: *mut f64,
        q: *mut f64,
        excess: *mut f64,
    ) -> c_int;
    /// Computes the ellipsoid of least volume around ellipsoids, up to a tolerance, with a proof.
    pub fn pw85_enclosing_ellipsoid_of(
        n: c_int,
        m: usize,
        centers: *const f64,
        forms: *const f64,
        tolerance: f64,
        center: *mut f64,
        q: *mut f64,
        excess: *mut f64,
    ) -> c_int;
    /// Makes random points, distributed uniformly in an ellipsoid with its centre at 0, or on its
    /// surface.
    pub fn pw85_random_points(
        q: *const f64,
        surface: c_int,
        seed: usize,
        num_points: usize,
        points: *mut f64,
    ) -> c_int;
}
