// SPDX-License-Identifier: BSD-3-Clause
//! Functions whose arguments are not rows alone: polytopes, many ellipsoids beside one, bodies and
//! shells, and the smallest ellipsoids.

use crate::error::{check, check_rows, refused, same_rows, Error};
use crate::ShapeContact;
use pw85_sys as sys;

const AS_MANY_AS_NORMALS: &str = "must have as many rows as normals";

/// Contact of an ellipsoid and a polytope, the points r with normals\[i\]·r <= offsets\[i\] relative
/// to the centre of the ellipsoid.
///
/// # Errors
///
/// There is not one offset for each normal; a normal is zero; a form is not positive definite.
///
/// ```
/// let q = [9.0, 0.0, 0.0, 4.0, 0.0, 1.0];
/// let found = pw85::contact_polytope(&[[-1.0, 0.0, 0.0]], &[-6.0], &q)?; // x >= 6
/// assert!((found.mu2 - 4.0).abs() < 1e-14);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn contact_polytope(
    normals: &[[f64; 3]],
    offsets: &[f64],
    q: &[f64; 6],
) -> Result<ShapeContact, Error> {
    let n = normals.len();
    let counts = [("offsets", offsets.len())];
    same_rows("pw85_contact_polytope", AS_MANY_AS_NORMALS, n, &counts)?;
    let (normals, offsets) = (normals.as_ptr().cast(), offsets.as_ptr());
    let mut mu2 = 0.0;
    let mut point = [0.0; 3];
    check(unsafe {
        sys::pw85_contact_polytope(
            n,
            normals,
            offsets,
            q.as_ptr(),
            &mut mu2,
            point.as_mut_ptr(),
        )
    })?;
    Ok(ShapeContact { mu2, point })
}

/// Whether an ellipsoid and a polytope overlap, exactly for the numbers given: see
/// [`contact_polytope()`]. If they only touch, they do not.
///
/// # Errors
///
/// As for [`contact_polytope()`].
///
/// ```
/// let q = [9.0, 0.0, 0.0, 4.0, 0.0, 1.0];
/// assert!(pw85::overlap_polytope(&[[-1.0, 0.0, 0.0]], &[-2.9], &q)?);
/// assert!(!pw85::overlap_polytope(&[[-1.0, 0.0, 0.0]], &[-3.0], &q)?);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn overlap_polytope(
    normals: &[[f64; 3]],
    offsets: &[f64],
    q: &[f64; 6],
) -> Result<bool, Error> {
    let n = normals.len();
    let counts = [("offsets", offsets.len())];
    same_rows("pw85_overlap_polytope", AS_MANY_AS_NORMALS, n, &counts)?;
    let (normals, offsets) = (normals.as_ptr().cast(), offsets.as_ptr());
    let mut overlap = 0;
    check(unsafe { sys::pw85_overlap_polytope(n, normals, offsets, q.as_ptr(), &mut overlap) })?;
    Ok(overlap == 1)
}

/// Whether an ellipsoid with the form `q1` overlaps any of others, with the separations `r12` from
/// its centre and the forms `q2`. The tests end at the first overlap.
///
/// # Errors
///
/// There is not one form for each separation; or the first row is bad that comes before an overlap.
///
/// ```
/// let q = [9.0, 0.0, 0.0, 4.0, 0.0, 1.0];
/// assert!(pw85::overlap_any(&q, &[[9.0, 0.0, 0.0], [5.0, 0.0, 0.0]], &[q, q])?);
/// assert!(!pw85::overlap_any(&q, &[], &[])?);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn overlap_any(q1: &[f64; 6], r12: &[[f64; 3]], q2: &[[f64; 6]]) -> Result<bool, Error> {
    let requirement = "must have as many rows as r12";
    same_rows(
        "pw85_overlap_any",
        requirement,
        r12.len(),
        &[("q2", q2.len())],
    )?;
    let (n, r12, q2) = (r12.len(), r12.as_ptr().cast(), q2.as_ptr().cast());
    let mut any = 0;
    check_rows(unsafe { sys::pw85_overlap_any(q1.as_ptr(), n, r12, q2, &mut any) })?;
    Ok(any == 1)
}

/// Tensor of inertia (xx, xy, xz, yy, yz, zz) of unit density about the centre, of the solid body
/// or, with `shell`, of its surface.
///
/// # Errors
///
/// The form is not positive definite.
///
/// ```
/// let ball = pw85::inertia(&[1.0, 0.0, 0.0, 1.0, 0.0, 1.0], false)?;
/// let truth = 0.4 * 4.0 / 3.0 * std::f64::consts::PI;
/// assert!((ball[0] - truth).abs() < 1e-14);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn inertia(q: &[f64; 6], shell: bool) -> Result<[f64; 6], Error> {
    let mut inertia = [0.0; 6];
    check(unsafe { sys::pw85_inertia(q.as_ptr(), shell.into(), inertia.as_mut_ptr()) })?;
    Ok(inertia)
}

/// The smallest ellipsoid around points or ellipsoids: its centre and how much its volume can exceed
/// the least volume, relative to that. If this exceeds the tolerance, rounding did not allow less.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Enclosing<const N: usize> {
    /// The centre.
    pub center: [f64; N],
    /// The proved bound: the volume is at most 1 + excess times the least volume.
    pub excess: f64,
}

/// The ellipsoid of least volume around points in N = 1 to 16 dimensions, up to a tolerance. `q`
/// receives its form, packed: N(N+1)/2 numbers, the rows of the upper triangle.
///
/// Every point is inside or on it, in exact arithmetic. This function allocates memory.
///
/// # Errors
///
/// A number is not finite; there are fewer than N + 1 points; the points are in a hyperplane.
///
/// ```
/// let mut q = [0.0; 3];
/// let square = [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]];
/// let found = pw85::enclosing_ellipsoid(&square, 1e-6, &mut q)?;
/// assert!(found.excess <= 1e-6 && (q[0] - 2.0).abs() < 1e-5);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn enclosing_ellipsoid<const N: usize>(
    points: &[[f64; N]],
    tolerance: f64,
    q: &mut [f64],
) -> Result<Enclosing<N>, Error> {
    packed::<N>("pw85_enclosing_ellipsoid", "q", q.len(), 1)?;
    let mut found = Enclosing {
        center: [0.0; N],
        excess: 0.0,
    };
    certified(unsafe {
        sys::pw85_enclosing_ellipsoid(
            N as i32,
            points.len(),
            points.as_ptr().cast(),
            tolerance,
            found.center.as_mut_ptr(),
            q.as_mut_ptr(),
            &mut found.excess,
        )
    })?;
    Ok(found)
}

/// The ellipsoid of least volume around ellipsoids with these centres and packed forms, one behind
/// the other: see [`enclosing_ellipsoid()`].
///
/// # Errors
///
/// A number is not finite; there is no ellipsoid; `forms` are not N(N+1)/2 numbers for each centre;
/// a form is not positive definite.
///
/// ```
/// let mut q = [0.0; 3];
/// let forms = [0.25, 0.0, 0.25, 0.25, 0.0, 0.25];
/// let found = pw85::enclosing_ellipsoid_of(&[[-1.0, 0.0], [1.0, 0.0]], &forms, 1e-6, &mut q)?;
/// assert!(found.excess <= 1e-6 && q[0] >= 2.25);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn enclosing_ellipsoid_of<const N: usize>(
    centers: &[[f64; N]],
    forms: &[f64],
    tolerance: f64,
    q: &mut [f64],
) -> Result<Enclosing<N>, Error> {
    let name = "pw85_enclosing_ellipsoid_of";
    packed::<N>(name, "forms", forms.len(), centers.len())?;
    packed::<N>(name, "q", q.len(), 1)?;
    let mut found = Enclosing {
        center: [0.0; N],
        excess: 0.0,
    };
    certified(unsafe {
        sys::pw85_enclosing_ellipsoid_of(
            N as i32,
            centers.len(),
            centers.as_ptr().cast(),
            forms.as_ptr(),
            tolerance,
            found.center.as_mut_ptr(),
            q.as_mut_ptr(),
            &mut found.excess,
        )
    })?;
    Ok(found)
}

/// Refuses numbers that are not as many as n packed forms have.
fn packed<const N: usize>(
    function: &'static str,
    argument: &'static str,
    count: usize,
    n: usize,
) -> Result<(), Error> {
    if !(1..=16).contains(&N) {
        return Err(refused(function, argument, "must be of 1 to 16 dimensions"));
    }
    if n.checked_mul(N * (N + 1) / 2) != Some(count) {
        return Err(refused(
            function,
            argument,
            "must have N(N+1)/2 numbers for each form",
        ));
    }
    Ok(())
}

/// The outputs are valid if the tolerance is not reached; the excess tells it.
fn certified(status: i32) -> Result<(), Error> {
    const NO_CONVERGENCE: i32 = 3;
    match check(status) {
        Err(_) if status == NO_CONVERGENCE => Ok(()),
        result => result,
    }
}

/// Random points of an ellipsoid with its centre at 0, uniform in its volume or, with `surface`, on
/// its surface. They depend on the form, the seed and the place in `points` alone.
///
/// # Errors
///
/// The form is not positive definite; the points are then NaN.
///
/// ```
/// let mut points = [[0.0; 3]; 4];
/// pw85::random_points(&[9.0, 0.0, 0.0, 4.0, 0.0, 1.0], false, 85, &mut points)?;
/// assert!(points.iter().all(|p| p[2].abs() <= 1.0));
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn random_points(
    q: &[f64; 6],
    surface: bool,
    seed: usize,
    points: &mut [[f64; 3]],
) -> Result<(), Error> {
    let (n, rows) = (points.len(), points.as_mut_ptr().cast());
    check(unsafe { sys::pw85_random_points(q.as_ptr(), surface.into(), seed, n, rows) })
}
