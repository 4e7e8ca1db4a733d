!> The contact function of Perram and Wertheim for two ellipsoids: the C API of pw85.h, pw85_legacy.h and pw85_zheng.h.
!>
!> See those headers for what each function computes; names, order of arguments and status codes are the same. Vectors
!> are real(c_double) arrays of 3 numbers, symmetric matrices of 6: (xx, xy, xz, yy, yz, zz); 2 and 3 in two dimensions.
!> Where C has rows of numbers, Fortran has columns: r12(:, i), q1(:, i) and pairs(:, i) belong to pair i, cell(:, k) is
!> vector k of the periodic cell. Indices of particles count from 0, as in C. Numbers of pairs are integer(c_size_t).
!>
!> Functions return a status, pw85_success or another of the codes below; when it is another, all outputs are NaN.
!> Outputs that may be null in C are optional here.
module pw85
  use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_double, c_f_pointer, c_int, c_int8_t, c_int32_t, &
    c_int64_t, c_loc, c_null_ptr, c_ptr, c_size_t
  implicit none
  private

  include 'pw85_version.inc'

  !> Status codes.
  integer(c_int), parameter, public :: pw85_success = 0
  integer(c_int), parameter, public :: pw85_einval = 1
  integer(c_int), parameter, public :: pw85_enotpd = 2
  integer(c_int), parameter, public :: pw85_econvergence = 3
  integer(c_int), parameter, public :: pw85_enomem = 4
  integer(c_int), parameter, public :: pw85_edevice = 5

  !> Dimension of the physical space, and number of stored entries of a symmetric matrix.
  integer(c_int), parameter, public :: pw85_dim = 3
  integer(c_int), parameter, public :: pw85_sym = 6

  !> Parameters of pw85_contact_function().
  real(c_double), parameter, public :: pw85_lambda_atol = 1e-6_c_double
  integer(c_int), parameter, public :: pw85_max_iter = 25
  integer(c_int), parameter, public :: pw85_nr_iter = 3

  !> How an ellipsoid moves: at time t its semi-axes are 1 + growth*t times those at time 0.
  type, bind(C), public :: pw85_motion
    real(c_double) :: velocity(3) = 0
    real(c_double) :: angular_velocity(3) = 0
    real(c_double) :: growth = 0
  end type pw85_motion

  public :: pw85_version, pw85_strerror
  public :: pw85_spheroid, pw85_ellipsoid, pw85_ellipsoid_quaternion, pw85_ellipse
  public :: pw85_contact, pw85_contact_function, pw85_contact_geometry, pw85_contact_gradient, pw85_contact_torque
  public :: pw85_contact_hessian, pw85_overlap, pw85_closest_approach, pw85_contact_2d, pw85_closest_approach_2d
  public :: pw85_contact_geometry_2d, pw85_contact_gradient_2d, pw85_contact_torque_2d, pw85_contact_hessian_2d
  public :: pw85_overlap_2d, pw85_contact_batch_2d, pw85_overlap_batch_2d
  public :: pw85_distance, pw85_distance_derivatives, pw85_distance_2d
  public :: pw85_penetration, pw85_distance_batch, pw85_penetration_batch, pw85_distance_plane_batch
  public :: pw85_first_contact, pw85_first_contact_batch, pw85_first_contact_pairs
  public :: pw85_contact_plane_derivatives
  public :: pw85_distance_plane, pw85_distance_plane_derivatives, pw85_contact_plane, pw85_distance_box
  public :: pw85_distance_cylinder, pw85_distance_point, pw85_intersect_line
  public :: pw85_contact_batch, pw85_overlap_batch, pw85_contact_pairs, pw85_overlap_pairs
  public :: pw85_closest_approach_batch, pw85_contact_derivatives_batch, pw85_contact_derivatives_pairs, pw85_overlap_any
  public :: pw85_overlap_any_indices, pw85_contact_forces_pairs
  public :: pw85_neighbors_create, pw85_neighbors_check, pw85_neighbors_holds, pw85_neighbors_size, pw85_neighbors_destroy
  public :: pw85_neighbors_pairs, pw85_neighbors_images
  public :: pw85_nearest_images, pw85_cell_reduce, pw85_nearest_image_limit, pw85_ellipsoid_quaternion_batch, pw85_bounding_boxes
  public :: pw85__cholesky_decomp, pw85__cholesky_solve, pw85__residual, pw85_f_neg
  public :: pw85_legacy__det_sym, pw85_legacy__xt_adja_x, pw85_legacy__detq_as_poly, pw85_legacy__rt_adjq_r_as_poly
  public :: pw85_legacy_f1, pw85_legacy_f2, pw85_legacy_f2_derivatives
  public :: pw85_legacy_contact_function1, pw85_legacy_contact_function2
  public :: pw85_zheng_ellipses, pw85_zheng_ellipsoids

  ! pw85.h
  interface

    function c_version() result(text) bind(C, name='pw85_version')
      import :: c_ptr
      type(c_ptr) :: text
    end function c_version

    function c_strerror(status) result(text) bind(C, name='pw85_strerror')
      import :: c_int, c_ptr
      integer(c_int), value :: status
      type(c_ptr) :: text
    end function c_strerror

    !> Form of a spheroid: equatorial radius a, polar radius c, axis n of any length > 0.
    subroutine pw85_spheroid(a, c, n, q) bind(C, name='pw85_spheroid')
      import :: c_double
      real(c_double), value :: a, c
      real(c_double), intent(in) :: n(3)
      real(c_double), intent(out) :: q(6)
    end subroutine pw85_spheroid

    function c_ellipsoid(semi_axes, rotation, q) result(status) bind(C, name='pw85_ellipsoid')
      import :: c_double, c_int
      real(c_double), intent(in) :: semi_axes(3), rotation(9)
      real(c_double), intent(out) :: q(6)
      integer(c_int) :: status
    end function c_ellipsoid

    !> Form of an ellipsoid oriented by the quaternion (w, x, y, z) of any length > 0.
    function pw85_ellipsoid_quaternion(semi_axes, quaternion, q) result(status) &
        bind(C, name='pw85_ellipsoid_quaternion')
      import :: c_double, c_int
      real(c_double), intent(in) :: semi_axes(3), quaternion(4)
      real(c_double), intent(out) :: q(6)
      integer(c_int) :: status
    end function pw85_ellipsoid_quaternion

    !> Form of an ellipse: semi-axes a and b, the first at the angle (radians) from the x axis.
    function pw85_ellipse(a, b, angle, q) result(status) bind(C, name='pw85_ellipse')
      import :: c_double, c_int
      real(c_double), value :: a, b, angle
      real(c_double), intent(out) :: q(3)
      integer(c_int) :: status
    end function pw85_ellipse

    !> Contact function of two ellipsoids: out = [mu**2, lambda].
    function pw85_contact(r12, q1, q2, out) result(status) bind(C, name='pw85_contact')
      import :: c_double, c_int
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      real(c_double), intent(out) :: out(2)
      integer(c_int) :: status
    end function pw85_contact

    !> The same, by Brent's method.
    function pw85_contact_function(r12, q1, q2, out) result(status) bind(C, name='pw85_contact_function')
      import :: c_double, c_int
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      real(c_double), intent(out) :: out(2)
      integer(c_int) :: status
    end function pw85_contact_function

    function c_contact_geometry(r12, q1, q2, lambda, point, normal) result(status) bind(C, name='pw85_contact_geometry')
      import :: c_double, c_int, c_ptr
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      real(c_double), value :: lambda
      type(c_ptr), value :: point, normal
      integer(c_int) :: status
    end function c_contact_geometry

    function c_contact_gradient(r12, q1, q2, lambda, d_r12, d_q1, d_q2) result(status) &
        bind(C, name='pw85_contact_gradient')
      import :: c_double, c_int, c_ptr
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      real(c_double), value :: lambda
      type(c_ptr), value :: d_r12, d_q1, d_q2
      integer(c_int) :: status
    end function c_contact_gradient

    function c_contact_torque(r12, q1, q2, lambda, d_rot1, d_rot2) result(status) bind(C, name='pw85_contact_torque')
      import :: c_double, c_int, c_ptr
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      real(c_double), value :: lambda
      type(c_ptr), value :: d_rot1, d_rot2
      integer(c_int) :: status
    end function c_contact_torque

    !> Whether two ellipsoids overlap: 1 or 0; -1 on error.
    function pw85_overlap(r12, q1, q2, overlap) result(status) bind(C, name='pw85_overlap')
      import :: c_double, c_int
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      integer(c_int), intent(out) :: overlap
      integer(c_int) :: status
    end function pw85_overlap

    !> Distance of closest approach of two ellipsoids along a direction.
    function pw85_closest_approach(direction, q1, q2, distance) result(status) bind(C, name='pw85_closest_approach')
      import :: c_double, c_int
      real(c_double), intent(in) :: direction(3), q1(6), q2(6)
      real(c_double), intent(out) :: distance
      integer(c_int) :: status
    end function pw85_closest_approach

    function c_contact_hessian(r12, q1, q2, lambda, hessian) result(status) bind(C, name='pw85_contact_hessian')
      import :: c_double, c_int, c_ptr
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      real(c_double), value :: lambda
      type(c_ptr), value :: hessian
      integer(c_int) :: status
    end function c_contact_hessian

    !> Contact function of two ellipses: out = [mu**2, lambda].
    function pw85_contact_2d(r12, q1, q2, out) result(status) bind(C, name='pw85_contact_2d')
      import :: c_double, c_int
      real(c_double), intent(in) :: r12(2), q1(3), q2(3)
      real(c_double), intent(out) :: out(2)
      integer(c_int) :: status
    end function pw85_contact_2d

    function c_contact_geometry_2d(r12, q1, q2, lambda, point, normal) result(status) &
        bind(C, name='pw85_contact_geometry_2d')
      import :: c_double, c_int, c_ptr
      real(c_double), intent(in) :: r12(2), q1(3), q2(3)
      real(c_double), value :: lambda
      type(c_ptr), value :: point, normal
      integer(c_int) :: status
    end function c_contact_geometry_2d

    function c_contact_gradient_2d(r12, q1, q2, lambda, d_r12, d_q1, d_q2) result(status) &
        bind(C, name='pw85_contact_gradient_2d')
      import :: c_double, c_int, c_ptr
      real(c_double), intent(in) :: r12(2), q1(3), q2(3)
      real(c_double), value :: lambda
      type(c_ptr), value :: d_r12, d_q1, d_q2
      integer(c_int) :: status
    end function c_contact_gradient_2d

    function c_contact_torque_2d(r12, q1, q2, lambda, d_rot1, d_rot2) result(status) &
        bind(C, name='pw85_contact_torque_2d')
      import :: c_double, c_int, c_ptr
      real(c_double), intent(in) :: r12(2), q1(3), q2(3)
      real(c_double), value :: lambda
      type(c_ptr), value :: d_rot1, d_rot2
      integer(c_int) :: status
    end function c_contact_torque_2d

    function c_contact_hessian_2d(r12, q1, q2, lambda, hessian) result(status) &
        bind(C, name='pw85_contact_hessian_2d')
      import :: c_double, c_int, c_ptr
      real(c_double), intent(in) :: r12(2), q1(3), q2(3)
      real(c_double), value :: lambda
      type(c_ptr), value :: hessian
      integer(c_int) :: status
    end function c_contact_hessian_2d

    !> Whether two ellipses overlap: 1 or 0; -1 on error.
    function pw85_overlap_2d(r12, q1, q2, overlap) result(status) bind(C, name='pw85_overlap_2d')
      import :: c_double, c_int
      real(c_double), intent(in) :: r12(2), q1(3), q2(3)
      integer(c_int), intent(out) :: overlap
      integer(c_int) :: status
    end function pw85_overlap_2d

    !> Distance of closest approach of two ellipses along a direction.
    function pw85_closest_approach_2d(direction, q1, q2, distance) result(status) &
        bind(C, name='pw85_closest_approach_2d')
      import :: c_double, c_int
      real(c_double), intent(in) :: direction(2), q1(3), q2(3)
      real(c_double), intent(out) :: distance
      integer(c_int) :: status
    end function pw85_closest_approach_2d

    function c_distance(r12, q1, q2, distance, point1, point2) result(status) bind(C, name='pw85_distance')
      import :: c_double, c_int, c_ptr
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      real(c_double), intent(out) :: distance
      type(c_ptr), value :: point1, point2
      integer(c_int) :: status
    end function c_distance

    function c_distance_derivatives(r12, q1, q2, d_r12, d_rot1, d_rot2, hessian) result(status) &
        bind(C, name='pw85_distance_derivatives')
      import :: c_double, c_int, c_ptr
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      type(c_ptr), value :: d_r12, d_rot1, d_rot2, hessian
      integer(c_int) :: status
    end function c_distance_derivatives

    function c_distance_2d(r12, q1, q2, distance, point1, point2) result(status) bind(C, name='pw85_distance_2d')
      import :: c_double, c_int, c_ptr
      real(c_double), intent(in) :: r12(2), q1(3), q2(3)
      real(c_double), intent(out) :: distance
      type(c_ptr), value :: point1, point2
      integer(c_int) :: status
    end function c_distance_2d

    function c_penetration(r12, q1, q2, depth, direction) result(status) bind(C, name='pw85_penetration')
      import :: c_double, c_int, c_ptr
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      real(c_double), intent(out) :: depth
      type(c_ptr), value :: direction
      integer(c_int) :: status
    end function c_penetration

    !> The time of the first contact of two moving ellipsoids, up to t_max; infinity if there is none.
    function pw85_first_contact(r12, q1, q2, motion1, motion2, t_max, t) result(status) bind(C, name='pw85_first_contact')
      import :: c_double, c_int, pw85_motion
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      type(pw85_motion), intent(in) :: motion1, motion2
      real(c_double), value :: t_max
      real(c_double), intent(out) :: t
      integer(c_int) :: status
    end function pw85_first_contact

    function c_distance_plane(normal, offset, q, distance, point) result(status) bind(C, name='pw85_distance_plane')
      import :: c_double, c_int, c_ptr
      real(c_double), intent(in) :: normal(3), q(6)
      real(c_double), value :: offset
      real(c_double), intent(out) :: distance
      type(c_ptr), value :: point
      integer(c_int) :: status
    end function c_distance_plane

    function c_distance_plane_derivatives(normal, q, d_center, d_rot) result(status) &
        bind(C, name='pw85_distance_plane_derivatives')
      import :: c_double, c_int, c_ptr
      real(c_double), intent(in) :: normal(3), q(6)
      type(c_ptr), value :: d_center, d_rot
      integer(c_int) :: status
    end function c_distance_plane_derivatives

    function c_contact_plane(normal, offset, q, mu2, point) result(status) bind(C, name='pw85_contact_plane')
      import :: c_double, c_int, c_ptr
      real(c_double), intent(in) :: normal(3), q(6)
      real(c_double), value :: offset
      real(c_double), intent(out) :: mu2
      type(c_ptr), value :: point
      integer(c_int) :: status
    end function c_contact_plane

    function c_contact_plane_derivatives(normal, offset, q, d_center, d_rot) result(status) &
        bind(C, name='pw85_contact_plane_derivatives')
      import :: c_double, c_int, c_ptr
      real(c_double), intent(in) :: normal(3), q(6)
      real(c_double), value :: offset
      type(c_ptr), value :: d_center, d_rot
      integer(c_int) :: status
    end function c_contact_plane_derivatives

    function c_distance_box(lower, upper, q, distance, point, normal) result(status) &
        bind(C, name='pw85_distance_box')
      import :: c_double, c_int, c_ptr
      real(c_double), intent(in) :: lower(3), upper(3), q(6)
      real(c_double), intent(out) :: distance
      type(c_ptr), value :: point, normal
      integer(c_int) :: status
    end function c_distance_box

    function c_distance_cylinder(axis, radius, center, q, distance, point, normal) result(status) &
        bind(C, name='pw85_distance_cylinder')
      import :: c_double, c_int, c_ptr
      real(c_double), intent(in) :: axis(3), center(3), q(6)
      real(c_double), value :: radius
      real(c_double), intent(out) :: distance
      type(c_ptr), value :: point, normal
      integer(c_int) :: status
    end function c_distance_cylinder

    function c_distance_point(r, q, distance, point, normal) result(status) bind(C, name='pw85_distance_point')
      import :: c_double, c_int, c_ptr
      real(c_double), intent(in) :: r(3), q(6)
      real(c_double), intent(out) :: distance
      type(c_ptr), value :: point, normal
      integer(c_int) :: status
    end function c_distance_point

    !> The part t(1) <= t <= t(2) of the line origin + t*direction in an ellipsoid; NaN if it misses.
    function pw85_intersect_line(origin, direction, q, t) result(status) bind(C, name='pw85_intersect_line')
      import :: c_double, c_int
      real(c_double), intent(in) :: origin(3), direction(3), q(6)
      real(c_double), intent(out) :: t(2)
      integer(c_int) :: status
    end function pw85_intersect_line

    function c_contact_batch(n, r12, q1, q2, mu2, lambda) result(status) bind(C, name='pw85_contact_batch')
      import :: c_double, c_int, c_ptr, c_size_t
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(3, *), q1(6, *), q2(6, *)
      real(c_double), intent(out) :: mu2(*)
      type(c_ptr), value :: lambda
      integer(c_int) :: status
    end function c_contact_batch

    !> Overlaps of n pairs: 1, 0, or -1 (255 in C, where it has no sign) for a bad pair.
    function pw85_overlap_batch(n, r12, q1, q2, overlap) result(status) bind(C, name='pw85_overlap_batch')
      import :: c_double, c_int, c_int8_t, c_size_t
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(3, *), q1(6, *), q2(6, *)
      integer(c_int8_t), intent(out) :: overlap(*)
      integer(c_int) :: status
    end function pw85_overlap_batch

    function c_contact_batch_2d(n, r12, q1, q2, mu2, lambda) result(status) &
        bind(C, name='pw85_contact_batch_2d')
      import :: c_double, c_int, c_ptr, c_size_t
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(2, *), q1(3, *), q2(3, *)
      real(c_double), intent(out) :: mu2(*)
      type(c_ptr), value :: lambda
      integer(c_int) :: status
    end function c_contact_batch_2d

    !> Overlaps of pairs of ellipses, as in pw85_overlap_batch().
    function pw85_overlap_batch_2d(n, r12, q1, q2, overlap) result(status) &
        bind(C, name='pw85_overlap_batch_2d')
      import :: c_double, c_int, c_int8_t, c_size_t
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(2, *), q1(3, *), q2(3, *)
      integer(c_int8_t), intent(out) :: overlap(*)
      integer(c_int) :: status
    end function pw85_overlap_batch_2d

    function c_contact_pairs(num_pairs, pairs, images, num_particles, centers, q, cell, mu2, lambda) &
        result(status) bind(C, name='pw85_contact_pairs')
      import :: c_double, c_int, c_int32_t, c_ptr, c_size_t
      integer(c_size_t), value :: num_pairs
      integer(c_int32_t), intent(in) :: pairs(2, *)
      type(c_ptr), value :: images
      integer(c_size_t), value :: num_particles
      real(c_double), intent(in) :: centers(3, *), q(6, *)
      type(c_ptr), value :: cell
      real(c_double), intent(out) :: mu2(*)
      type(c_ptr), value :: lambda
      integer(c_int) :: status
    end function c_contact_pairs

    function c_overlap_pairs(num_pairs, pairs, images, num_particles, centers, q, cell, overlap) result(status) &
        bind(C, name='pw85_overlap_pairs')
      import :: c_double, c_int, c_int8_t, c_int32_t, c_ptr, c_size_t
      integer(c_size_t), value :: num_pairs
      integer(c_int32_t), intent(in) :: pairs(2, *)
      type(c_ptr), value :: images
      integer(c_size_t), value :: num_particles
      real(c_double), intent(in) :: centers(3, *), q(6, *)
      type(c_ptr), value :: cell
      integer(c_int8_t), intent(out) :: overlap(*)
      integer(c_int) :: status
    end function c_overlap_pairs

    !> Distances of closest approach of n pairs, for directions of any lengths > 0.
    function pw85_closest_approach_batch(n, directions, q1, q2, distance) result(status) &
        bind(C, name='pw85_closest_approach_batch')
      import :: c_double, c_int, c_size_t
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: directions(3, *), q1(6, *), q2(6, *)
      real(c_double), intent(out) :: distance(*)
      integer(c_int) :: status
    end function pw85_closest_approach_batch

    function c_distance_batch(n, r12, q1, q2, distance, point1, point2) result(status) bind(C, name='pw85_distance_batch')
      import :: c_double, c_int, c_ptr, c_size_t
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(3, *), q1(6, *), q2(6, *)
      type(c_ptr), value :: distance, point1, point2
      integer(c_int) :: status
    end function c_distance_batch

    function c_penetration_batch(n, r12, q1, q2, depth, direction) result(status) bind(C, name='pw85_penetration_batch')
      import :: c_double, c_int, c_ptr, c_size_t
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(3, *), q1(6, *), q2(6, *)
      type(c_ptr), value :: depth, direction
      integer(c_int) :: status
    end function c_penetration_batch

    function c_distance_plane_batch(n, normals, offsets, q, distance, point) result(status) &
        bind(C, name='pw85_distance_plane_batch')
      import :: c_double, c_int, c_ptr, c_size_t
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: normals(3, *), offsets(*), q(6, *)
      type(c_ptr), value :: distance, point
      integer(c_int) :: status
    end function c_distance_plane_batch

    !> First contacts of n pairs.
    function pw85_first_contact_batch(n, r12, q1, q2, motion1, motion2, t_max, t) result(status) &
        bind(C, name='pw85_first_contact_batch')
      import :: c_double, c_int, c_size_t, pw85_motion
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(3, *), q1(6, *), q2(6, *)
      type(pw85_motion), intent(in) :: motion1(*), motion2(*)
      real(c_double), value :: t_max
      real(c_double), intent(out) :: t(*)
      integer(c_int) :: status
    end function pw85_first_contact_batch

    function c_first_contact_pairs(num_pairs, pairs, images, num_particles, centers, q, cell, motions, t_max, t, next, &
        next_pair) result(status) bind(C, name='pw85_first_contact_pairs')
      import :: c_double, c_int, c_int32_t, c_ptr, c_size_t, pw85_motion
      integer(c_size_t), value :: num_pairs
      integer(c_int32_t), intent(in) :: pairs(2, *)
      type(c_ptr), value :: images
      integer(c_size_t), value :: num_particles
      real(c_double), intent(in) :: centers(3, *), q(6, *)
      type(c_ptr), value :: cell
      type(pw85_motion), intent(in) :: motions(*)
      real(c_double), value :: t_max
      real(c_double), intent(out) :: t(*)
      type(c_ptr), value :: next, next_pair
      integer(c_int) :: status
    end function c_first_contact_pairs

    function c_nearest_images(num_pairs, pairs, num_particles, centers, cell, r12, images) result(status) &
        bind(C, name='pw85_nearest_images')
      import :: c_double, c_int, c_int32_t, c_ptr, c_size_t
      integer(c_size_t), value :: num_pairs
      integer(c_int32_t), intent(in) :: pairs(2, *)
      integer(c_size_t), value :: num_particles
      real(c_double), intent(in) :: centers(3, *), cell(3, *)
      type(c_ptr), value :: r12, images
      integer(c_int) :: status
    end function c_nearest_images

    function c_contact_derivatives_batch(n, r12, q1, q2, mu2, lambda, point, normal, d_r12, d_rot1, d_rot2) &
        result(status) bind(C, name='pw85_contact_derivatives_batch')
      import :: c_double, c_int, c_ptr, c_size_t
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(3, *), q1(6, *), q2(6, *)
      type(c_ptr), value :: mu2, lambda, point, normal, d_r12, d_rot1, d_rot2
      integer(c_int) :: status
    end function c_contact_derivatives_batch

    function c_contact_derivatives_pairs(num_pairs, pairs, images, num_particles, centers, q, cell, mu2, lambda, &
        point, normal, d_r12, d_rot1, d_rot2) result(status) bind(C, name='pw85_contact_derivatives_pairs')
      import :: c_double, c_int, c_int32_t, c_ptr, c_size_t
      integer(c_size_t), value :: num_pairs
      integer(c_int32_t), intent(in) :: pairs(2, *)
      type(c_ptr), value :: images
      integer(c_size_t), value :: num_particles
      real(c_double), intent(in) :: centers(3, *), q(6, *)
      type(c_ptr), value :: cell, mu2, lambda, point, normal, d_r12, d_rot1, d_rot2
      integer(c_int) :: status
    end function c_contact_derivatives_pairs

    !> Whether an ellipsoid overlaps any of n others: 1, 0, or -1 on error.
    function pw85_overlap_any(n, q1, r12, q2, any) result(status) bind(C, name='pw85_overlap_any')
      import :: c_double, c_int, c_size_t
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: q1(6), r12(3, *), q2(6, *)
      integer(c_int), intent(out) :: any
      integer(c_int) :: status
    end function pw85_overlap_any

    function c_overlap_any_indices(center, q1, n, indices, num_particles, centers, q, cell, any) result(status) &
        bind(C, name='pw85_overlap_any_indices')
      import :: c_double, c_int, c_int32_t, c_ptr, c_size_t
      real(c_double), intent(in) :: center(3), q1(6)
      integer(c_size_t), value :: n
      integer(c_int32_t), intent(in) :: indices(*)
      integer(c_size_t), value :: num_particles
      real(c_double), intent(in) :: centers(3, *), q(6, *)
      type(c_ptr), value :: cell
      integer(c_int), intent(out) :: any
      integer(c_int) :: status
    end function c_overlap_any_indices

    function c_contact_forces_pairs(num_pairs, pairs, images, num_particles, centers, cell, d_u, d_r12, d_rot1, d_rot2, &
        forces, torques, virial) result(status) bind(C, name='pw85_contact_forces_pairs')
      import :: c_double, c_int, c_int32_t, c_ptr, c_size_t
      integer(c_size_t), value :: num_pairs
      integer(c_int32_t), intent(in) :: pairs(2, *)
      type(c_ptr), value :: images
      integer(c_size_t), value :: num_particles
      real(c_double), intent(in) :: centers(3, *)
      type(c_ptr), value :: cell
      real(c_double), intent(in) :: d_u(*)
      type(c_ptr), value :: d_r12, d_rot1, d_rot2, forces, torques, virial
      integer(c_int) :: status
    end function c_contact_forces_pairs

    function c_neighbors_create(n, centers, q, cell, periodic, scale, skin, list) result(status) &
        bind(C, name='pw85_neighbors_create')
      import :: c_double, c_int, c_ptr, c_size_t
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: centers(3, *), q(6, *)
      type(c_ptr), value :: cell, periodic
      real(c_double), value :: scale, skin
      type(c_ptr), intent(out) :: list
      integer(c_int) :: status
    end function c_neighbors_create

    function c_neighbors_check(n, centers, q, cell, periodic, scale, skin, particle) result(status) &
        bind(C, name='pw85_neighbors_check')
      import :: c_double, c_int, c_ptr, c_size_t
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: centers(3, *), q(6, *)
      type(c_ptr), value :: cell, periodic
      real(c_double), value :: scale, skin
      integer(c_size_t), intent(out) :: particle
      integer(c_int) :: status
    end function c_neighbors_check

    !> Whether a neighbour list still has all pairs after motion: 1, 0, or -1 on error.
    function pw85_neighbors_holds(list, n, centers, q, holds) result(status) bind(C, name='pw85_neighbors_holds')
      import :: c_double, c_int, c_ptr, c_size_t
      type(c_ptr), value :: list
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: centers(3, *), q(6, *)
      integer(c_int), intent(out) :: holds
      integer(c_int) :: status
    end function pw85_neighbors_holds

    !> Number of pairs of a neighbour list.
    function pw85_neighbors_size(list) result(size) bind(C, name='pw85_neighbors_size')
      import :: c_ptr, c_size_t
      type(c_ptr), value :: list
      integer(c_size_t) :: size
    end function pw85_neighbors_size

    function c_neighbors_pairs(list) result(pairs) bind(C, name='pw85_neighbors_pairs')
      import :: c_ptr
      type(c_ptr), value :: list
      type(c_ptr) :: pairs
    end function c_neighbors_pairs

    function c_neighbors_images(list) result(images) bind(C, name='pw85_neighbors_images')
      import :: c_ptr
      type(c_ptr), value :: list
      type(c_ptr) :: images
    end function c_neighbors_images

    !> Frees a neighbour list.
    subroutine pw85_neighbors_destroy(list) bind(C, name='pw85_neighbors_destroy')
      import :: c_ptr
      type(c_ptr), value :: list
    end subroutine pw85_neighbors_destroy

    function c_cell_reduce(cell, reduced) result(status) bind(C, name='pw85_cell_reduce')
      import :: c_double, c_int
      real(c_double), intent(in) :: cell(9)
      real(c_double), intent(out) :: reduced(9)
      integer(c_int) :: status
    end function c_cell_reduce

    !> Up to which mu**2 nearest images are all there is; the vectors of the cell are its columns.
    function pw85_nearest_image_limit(n, q, cell, mu2) result(status) bind(C, name='pw85_nearest_image_limit')
      import :: c_double, c_int, c_size_t
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: q(6, *), cell(3, 3)
      real(c_double), intent(out) :: mu2
      integer(c_int) :: status
    end function pw85_nearest_image_limit

    !> Forms of n ellipsoids whose orientations are quaternions (w, x, y, z).
    function pw85_ellipsoid_quaternion_batch(n, semi_axes, quaternions, q) result(status) &
        bind(C, name='pw85_ellipsoid_quaternion_batch')
      import :: c_double, c_int, c_size_t
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: semi_axes(3, *), quaternions(4, *)
      real(c_double), intent(out) :: q(6, *)
      integer(c_int) :: status
    end function pw85_ellipsoid_quaternion_batch

    !> Half-widths of the tight boxes around n ellipsoids.
    function pw85_bounding_boxes(n, q, half_widths) result(status) bind(C, name='pw85_bounding_boxes')
      import :: c_double, c_int, c_size_t
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: q(6, *)
      real(c_double), intent(out) :: half_widths(3, *)
      integer(c_int) :: status
    end function pw85_bounding_boxes

    !> Cholesky factor of a symmetric matrix, by columns.
    subroutine pw85__cholesky_decomp(a, l) bind(C, name='pw85__cholesky_decomp')
      import :: c_double
      real(c_double), intent(in) :: a(6)
      real(c_double), intent(out) :: l(6)
    end subroutine pw85__cholesky_decomp

    subroutine pw85__cholesky_solve(l, b, x) bind(C, name='pw85__cholesky_solve')
      import :: c_double
      real(c_double), intent(in) :: l(6), b(3)
      real(c_double), intent(out) :: x(3)
    end subroutine pw85__cholesky_solve

    !> out = [f, g, g'] at lambda, with g = -f'.
    subroutine pw85__residual(lambda, r12, q1, q2, out) bind(C, name='pw85__residual')
      import :: c_double
      real(c_double), value :: lambda
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      real(c_double), intent(out) :: out(3)
    end subroutine pw85__residual

    !> -f(lambda); params = [r12, q1, q2].
    function pw85_f_neg(lambda, params) result(f) bind(C, name='pw85_f_neg')
      import :: c_double
      real(c_double), value :: lambda
      real(c_double), intent(in) :: params(15)
      real(c_double) :: f
    end function pw85_f_neg

  end interface

  ! pw85_legacy.h
  interface

    function pw85_legacy__det_sym(a) result(determinant) bind(C, name='pw85_legacy__det_sym')
      import :: c_double
      real(c_double), intent(in) :: a(6)
      real(c_double) :: determinant
    end function pw85_legacy__det_sym

    function pw85_legacy__xt_adja_x(x, a) result(form) bind(C, name='pw85_legacy__xT_adjA_x')
      import :: c_double
      real(c_double), intent(in) :: x(3), a(6)
      real(c_double) :: form
    end function pw85_legacy__xt_adja_x

    subroutine pw85_legacy__detq_as_poly(q1, q2, q3, q4, b) bind(C, name='pw85_legacy__detQ_as_poly')
      import :: c_double
      real(c_double), intent(in) :: q1(6), q2(6), q3(6), q4(6)
      real(c_double), intent(out) :: b(4)
    end subroutine pw85_legacy__detq_as_poly

    subroutine pw85_legacy__rt_adjq_r_as_poly(r, q1, q2, q3, a) bind(C, name='pw85_legacy__rT_adjQ_r_as_poly')
      import :: c_double
      real(c_double), intent(in) :: r(3), q1(6), q2(6), q3(6)
      real(c_double), intent(out) :: a(3)
    end subroutine pw85_legacy__rt_adjq_r_as_poly

    function c_legacy_f1(lambda, r12, q1, q2, out) result(f) bind(C, name='pw85_legacy_f1')
      import :: c_double, c_ptr
      real(c_double), value :: lambda
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      type(c_ptr), value :: out
      real(c_double) :: f
    end function c_legacy_f1

    function c_legacy_f2(lambda, r12, q1, q2, out) result(f) bind(C, name='pw85_legacy_f2')
      import :: c_double, c_ptr
      real(c_double), value :: lambda
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      type(c_ptr), value :: out
      real(c_double) :: f
    end function c_legacy_f2

    !> f(lambda) as a rational function, with derivatives; out = [f, f', f''].
    subroutine pw85_legacy_f2_derivatives(lambda, r12, q1, q2, out) bind(C, name='pw85_legacy_f2_derivatives')
      import :: c_double
      real(c_double), value :: lambda
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      real(c_double), intent(out) :: out(3)
    end subroutine pw85_legacy_f2_derivatives

    function pw85_legacy_contact_function1(r12, q1, q2, out) result(status) &
        bind(C, name='pw85_legacy_contact_function1')
      import :: c_double, c_int
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      real(c_double), intent(out) :: out(2)
      integer(c_int) :: status
    end function pw85_legacy_contact_function1

    function pw85_legacy_contact_function2(r12, q1, q2, out) result(status) &
        bind(C, name='pw85_legacy_contact_function2')
      import :: c_double, c_int
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      real(c_double), intent(out) :: out(2)
      integer(c_int) :: status
    end function pw85_legacy_contact_function2

  end interface

  ! pw85_zheng.h
  interface

    !> Distance of closest approach of two ellipses, by the algorithm of Zheng and Palffy-Muhoray.
    function pw85_zheng_ellipses(direction, q1, q2, distance) result(status) bind(C, name='pw85_zheng_ellipses')
      import :: c_double, c_int
      real(c_double), intent(in) :: direction(2), q1(3), q2(3)
      real(c_double), intent(out) :: distance
      integer(c_int) :: status
    end function pw85_zheng_ellipses

    !> Distance of closest approach of two ellipsoids, by the algorithm of Zheng, Iglesias and Palffy-Muhoray.
    function pw85_zheng_ellipsoids(direction, q1, q2, distance) result(status) bind(C, name='pw85_zheng_ellipsoids')
      import :: c_double, c_int
      real(c_double), intent(in) :: direction(3), q1(6), q2(6)
      real(c_double), intent(out) :: distance
      integer(c_int) :: status
    end function pw85_zheng_ellipsoids

  end interface

  ! The C library.
  interface
    function c_strlen(text) result(length) bind(C, name='strlen')
      import :: c_ptr, c_size_t
      type(c_ptr), value :: text
      integer(c_size_t) :: length
    end function c_strlen
  end interface

contains

  !> Version of the library that is linked, "major.minor.patch".
  function pw85_version() result(text)
    character(:), allocatable :: text
    text = fortran_string(c_version())
  end function pw85_version

  !> Sentence that says what a status means.
  function pw85_strerror(status) result(text)
    integer(c_int), intent(in) :: status
    character(:), allocatable :: text
    text = fortran_string(c_strerror(status))
  end function pw85_strerror

  !> Form of an ellipsoid; rotation(:, k) is the direction of semi_axes(k).
  function pw85_ellipsoid(semi_axes, rotation, q) result(status)
    real(c_double), intent(in) :: semi_axes(3), rotation(3, 3)
    real(c_double), intent(out) :: q(6)
    integer(c_int) :: status
    status = c_ellipsoid(semi_axes, reshape(transpose(rotation), [9]), q)
  end function pw85_ellipsoid

  !> Point of contact of the ellipsoids scaled by mu, relative to centre 1, and unit normal from 1 to 2.
  function pw85_contact_geometry(r12, q1, q2, lambda, point, normal) result(status)
    real(c_double), intent(in) :: r12(3), q1(6), q2(6), lambda
    real(c_double), intent(out), optional, target :: point(3), normal(3)
    integer(c_int) :: status
    status = c_contact_geometry(r12, q1, q2, lambda, address(point), address(normal))
  end function pw85_contact_geometry

  !> Derivatives of mu**2 with respect to r12 and the stored entries of q1 and q2.
  function pw85_contact_gradient(r12, q1, q2, lambda, d_r12, d_q1, d_q2) result(status)
    real(c_double), intent(in) :: r12(3), q1(6), q2(6), lambda
    real(c_double), intent(out), optional, target :: d_r12(3), d_q1(6), d_q2(6)
    integer(c_int) :: status
    status = c_contact_gradient(r12, q1, q2, lambda, address(d_r12), address(d_q1), address(d_q2))
  end function pw85_contact_gradient

  !> Derivatives of mu**2 with respect to rotations of either ellipsoid about its own centre.
  function pw85_contact_torque(r12, q1, q2, lambda, d_rot1, d_rot2) result(status)
    real(c_double), intent(in) :: r12(3), q1(6), q2(6), lambda
    real(c_double), intent(out), optional, target :: d_rot1(3), d_rot2(3)
    integer(c_int) :: status
    status = c_contact_torque(r12, q1, q2, lambda, address(d_rot1), address(d_rot2))
  end function pw85_contact_torque

  !> Second derivatives of mu**2 with respect to r12 and rotations of either ellipsoid about its own centre.
  function pw85_contact_hessian(r12, q1, q2, lambda, hessian) result(status)
    real(c_double), intent(in) :: r12(3), q1(6), q2(6), lambda
    real(c_double), intent(out), target :: hessian(9, 9)
    integer(c_int) :: status
    status = c_contact_hessian(r12, q1, q2, lambda, address(hessian))
  end function pw85_contact_hessian

  !> Point of contact of the ellipses scaled by mu, relative to centre 1, and unit normal from 1 to 2.
  function pw85_contact_geometry_2d(r12, q1, q2, lambda, point, normal) result(status)
    real(c_double), intent(in) :: r12(2), q1(3), q2(3), lambda
    real(c_double), intent(out), optional, target :: point(2), normal(2)
    integer(c_int) :: status
    status = c_contact_geometry_2d(r12, q1, q2, lambda, address(point), address(normal))
  end function pw85_contact_geometry_2d

  !> Derivatives of mu**2 of two ellipses with respect to r12 and the stored entries of q1 and q2.
  function pw85_contact_gradient_2d(r12, q1, q2, lambda, d_r12, d_q1, d_q2) result(status)
    real(c_double), intent(in) :: r12(2), q1(3), q2(3), lambda
    real(c_double), intent(out), optional, target :: d_r12(2), d_q1(3), d_q2(3)
    integer(c_int) :: status
    status = c_contact_gradient_2d(r12, q1, q2, lambda, address(d_r12), address(d_q1), address(d_q2))
  end function pw85_contact_gradient_2d

  !> Derivatives of mu**2 with respect to the angles of two ellipses, counter-clockwise.
  function pw85_contact_torque_2d(r12, q1, q2, lambda, d_rot1, d_rot2) result(status)
    real(c_double), intent(in) :: r12(2), q1(3), q2(3), lambda
    real(c_double), intent(out), optional, target :: d_rot1, d_rot2
    integer(c_int) :: status
    status = c_contact_torque_2d(r12, q1, q2, lambda, address_of_number(d_rot1), address_of_number(d_rot2))
  end function pw85_contact_torque_2d

  !> Second derivatives of mu**2 of two ellipses with respect to r12 and both angles.
  function pw85_contact_hessian_2d(r12, q1, q2, lambda, hessian) result(status)
    real(c_double), intent(in) :: r12(2), q1(3), q2(3), lambda
    real(c_double), intent(out), target :: hessian(4, 4)
    integer(c_int) :: status
    status = c_contact_hessian_2d(r12, q1, q2, lambda, address(hessian))
  end function pw85_contact_hessian_2d

  !> Distance of the surfaces of two ellipsoids and their closest points, relative to centre 1; 0 and NaN if they overlap.
  function pw85_distance(r12, q1, q2, distance, point1, point2) result(status)
    real(c_double), intent(in) :: r12(3), q1(6), q2(6)
    real(c_double), intent(out) :: distance
    real(c_double), intent(out), optional, target :: point1(3), point2(3)
    integer(c_int) :: status
    status = c_distance(r12, q1, q2, distance, address(point1), address(point2))
  end function pw85_distance

  !> Derivatives of the distance with respect to r12, rotations of either ellipsoid, and all of these twice.
  function pw85_distance_derivatives(r12, q1, q2, d_r12, d_rot1, d_rot2, hessian) result(status)
    real(c_double), intent(in) :: r12(3), q1(6), q2(6)
    real(c_double), intent(out), optional, target :: d_r12(3), d_rot1(3), d_rot2(3), hessian(9, 9)
    integer(c_int) :: status
    status = c_distance_derivatives(r12, q1, q2, address(d_r12), address(d_rot1), address(d_rot2), address(hessian))
  end function pw85_distance_derivatives

  !> Distance of two ellipses.
  function pw85_distance_2d(r12, q1, q2, distance, point1, point2) result(status)
    real(c_double), intent(in) :: r12(2), q1(3), q2(3)
    real(c_double), intent(out) :: distance
    real(c_double), intent(out), optional, target :: point1(2), point2(2)
    integer(c_int) :: status
    status = c_distance_2d(r12, q1, q2, distance, address(point1), address(point2))
  end function pw85_distance_2d

  !> Depth of an overlap: the shortest translation of ellipsoid 2 that separates, zero if they are apart, and its direction.
  function pw85_penetration(r12, q1, q2, depth, direction) result(status)
    real(c_double), intent(in) :: r12(3), q1(6), q2(6)
    real(c_double), intent(out) :: depth
    real(c_double), intent(out), optional, target :: direction(3)
    integer(c_int) :: status
    status = c_penetration(r12, q1, q2, depth, address(direction))
  end function pw85_penetration

  !> Distance from an ellipsoid at 0 to the half-space normal.x >= offset; negative if they overlap.
  function pw85_distance_plane(normal, offset, q, distance, point) result(status)
    real(c_double), intent(in) :: normal(3), offset, q(6)
    real(c_double), intent(out) :: distance
    real(c_double), intent(out), optional, target :: point(3)
    integer(c_int) :: status
    status = c_distance_plane(normal, offset, q, distance, address(point))
  end function pw85_distance_plane

  !> Derivatives of the distance to a half-space with respect to the centre and to rotations about it.
  function pw85_distance_plane_derivatives(normal, q, d_center, d_rot) result(status)
    real(c_double), intent(in) :: normal(3), q(6)
    real(c_double), intent(out), optional, target :: d_center(3), d_rot(3)
    integer(c_int) :: status
    status = c_distance_plane_derivatives(normal, q, address(d_center), address(d_rot))
  end function pw85_distance_plane_derivatives

  !> Contact function of an ellipsoid at 0 and the half-space normal.x >= offset.
  function pw85_contact_plane(normal, offset, q, mu2, point) result(status)
    real(c_double), intent(in) :: normal(3), offset, q(6)
    real(c_double), intent(out) :: mu2
    real(c_double), intent(out), optional, target :: point(3)
    integer(c_int) :: status
    status = c_contact_plane(normal, offset, q, mu2, address(point))
  end function pw85_contact_plane

  !> Derivatives of that contact function with respect to the centre and to rotations about it.
  function pw85_contact_plane_derivatives(normal, offset, q, d_center, d_rot) result(status)
    real(c_double), intent(in) :: normal(3), offset, q(6)
    real(c_double), intent(out), optional, target :: d_center(3), d_rot(3)
    integer(c_int) :: status
    status = c_contact_plane_derivatives(normal, offset, q, address(d_center), address(d_rot))
  end function pw85_contact_plane_derivatives

  !> Distance from an ellipsoid at 0 to the nearest face of a box around it.
  function pw85_distance_box(lower, upper, q, distance, point, normal) result(status)
    real(c_double), intent(in) :: lower(3), upper(3), q(6)
    real(c_double), intent(out) :: distance
    real(c_double), intent(out), optional, target :: point(3), normal(3)
    integer(c_int) :: status
    status = c_distance_box(lower, upper, q, distance, address(point), address(normal))
  end function pw85_distance_box

  !> Distance from an ellipsoid to the wall of a cylinder around it, with its axis through 0.
  function pw85_distance_cylinder(axis, radius, center, q, distance, point, normal) result(status)
    real(c_double), intent(in) :: axis(3), radius, center(3), q(6)
    real(c_double), intent(out) :: distance
    real(c_double), intent(out), optional, target :: point(3), normal(3)
    integer(c_int) :: status
    status = c_distance_cylinder(axis, radius, center, q, distance, address(point), address(normal))
  end function pw85_distance_cylinder

  !> Distance from a point, relative to the centre, to the surface of an ellipsoid; negative inside.
  function pw85_distance_point(r, q, distance, point, normal) result(status)
    real(c_double), intent(in) :: r(3), q(6)
    real(c_double), intent(out) :: distance
    real(c_double), intent(out), optional, target :: point(3), normal(3)
    integer(c_int) :: status
    status = c_distance_point(r, q, distance, address(point), address(normal))
  end function pw85_distance_point

  !> Distances and closest points of n pairs.
  function pw85_distance_batch(n, r12, q1, q2, distance, point1, point2) result(status)
    integer(c_size_t), intent(in) :: n
    real(c_double), intent(in) :: r12(3, n), q1(6, n), q2(6, n)
    real(c_double), intent(out), optional, target :: distance(n), point1(3, n), point2(3, n)
    integer(c_int) :: status
    status = c_distance_batch(n, r12, q1, q2, address(distance), address(point1), address(point2))
  end function pw85_distance_batch

  !> Depths of n pairs, and the directions of the shortest translations.
  function pw85_penetration_batch(n, r12, q1, q2, depth, direction) result(status)
    integer(c_size_t), intent(in) :: n
    real(c_double), intent(in) :: r12(3, n), q1(6, n), q2(6, n)
    real(c_double), intent(out), optional, target :: depth(n), direction(3, n)
    integer(c_int) :: status
    status = c_penetration_batch(n, r12, q1, q2, address(depth), address(direction))
  end function pw85_penetration_batch

  !> Distances of n ellipsoids and half-spaces.
  function pw85_distance_plane_batch(n, normals, offsets, q, distance, point) result(status)
    integer(c_size_t), intent(in) :: n
    real(c_double), intent(in) :: normals(3, n), offsets(n), q(6, n)
    real(c_double), intent(out), optional, target :: distance(n), point(3, n)
    integer(c_int) :: status
    status = c_distance_plane_batch(n, normals, offsets, q, address(distance), address(point))
  end function pw85_distance_plane_batch

  !> Contact function of n pairs.
  function pw85_contact_batch(n, r12, q1, q2, mu2, lambda) result(status)
    integer(c_size_t), intent(in) :: n
    real(c_double), intent(in) :: r12(3, n), q1(6, n), q2(6, n)
    real(c_double), intent(out) :: mu2(n)
    real(c_double), intent(out), optional, target :: lambda(n)
    integer(c_int) :: status
    status = c_contact_batch(n, r12, q1, q2, mu2, address(lambda))
  end function pw85_contact_batch

  !> Contact functions of pairs of ellipses, as in pw85_contact_batch().
  function pw85_contact_batch_2d(n, r12, q1, q2, mu2, lambda) result(status)
    integer(c_size_t), intent(in) :: n
    real(c_double), intent(in) :: r12(2, n), q1(3, n), q2(3, n)
    real(c_double), intent(out) :: mu2(n)
    real(c_double), intent(out), optional, target :: lambda(n)
    integer(c_int) :: status
    status = c_contact_batch_2d(n, r12, q1, q2, mu2, address(lambda))
  end function pw85_contact_batch_2d

  !> Contact function of the pairs of a neighbour list; without `cell` there is no periodic cell, without `images` the nearest
  !> ones are taken.
  function pw85_contact_pairs(num_pairs, pairs, num_particles, centers, q, cell, mu2, lambda, images) result(status)
    integer(c_size_t), intent(in) :: num_pairs, num_particles
    integer(c_int32_t), intent(in) :: pairs(2, num_pairs)
    real(c_double), intent(in) :: centers(3, num_particles), q(6, num_particles)
    real(c_double), intent(in), optional, target :: cell(3, 3)
    real(c_double), intent(out) :: mu2(num_pairs)
    real(c_double), intent(out), optional, target :: lambda(num_pairs)
    integer(c_int32_t), intent(in), optional, target :: images(3, num_pairs)
    integer(c_int) :: status
    status = c_contact_pairs(num_pairs, pairs, address_of_integers(images), num_particles, centers, q, address(cell), &
                             mu2, address(lambda))
  end function pw85_contact_pairs

  !> Nearest images of the pairs of a list: vectors, and multiples of the columns of `cell`.
  function pw85_nearest_images(num_pairs, pairs, num_particles, centers, cell, r12, images) result(status)
    integer(c_size_t), intent(in) :: num_pairs, num_particles
    integer(c_int32_t), intent(in) :: pairs(2, num_pairs)
    real(c_double), intent(in) :: centers(3, num_particles), cell(3, 3)
    real(c_double), intent(out), optional, target :: r12(3, num_pairs)
    integer(c_int32_t), intent(out), optional, target :: images(3, num_pairs)
    integer(c_int) :: status
    status = c_nearest_images(num_pairs, pairs, num_particles, centers, cell, address(r12), address_of_integers(images))
  end function pw85_nearest_images

  !> Overlaps of the pairs of a neighbour list, as in pw85_overlap_batch(); `cell` and `images` as in pw85_contact_pairs().
  function pw85_overlap_pairs(num_pairs, pairs, num_particles, centers, q, cell, overlap, images) result(status)
    integer(c_size_t), intent(in) :: num_pairs, num_particles
    integer(c_int32_t), intent(in) :: pairs(2, num_pairs)
    real(c_double), intent(in) :: centers(3, num_particles), q(6, num_particles)
    real(c_double), intent(in), optional, target :: cell(3, 3)
    integer(c_int8_t), intent(out) :: overlap(num_pairs)
    integer(c_int32_t), intent(in), optional, target :: images(3, num_pairs)
    integer(c_int) :: status
    status = c_overlap_pairs(num_pairs, pairs, address_of_integers(images), num_particles, centers, q, address(cell), &
                             overlap)
  end function pw85_overlap_pairs

  !> Whether an ellipsoid overlaps any of others of a system, by their indices from 0: 1, 0, or -1 on error. The vectors of the cell are
  !> its columns.
  function pw85_overlap_any_indices(center, q1, n, indices, num_particles, centers, q, cell, any) result(status)
    integer(c_size_t), intent(in) :: n, num_particles
    real(c_double), intent(in) :: center(3), q1(6), centers(3, num_particles), q(6, num_particles)
    integer(c_int32_t), intent(in) :: indices(n)
    real(c_double), intent(in), optional, target :: cell(3, 3)
    integer(c_int), intent(out) :: any
    integer(c_int) :: status
    status = c_overlap_any_indices(center, q1, n, indices, num_particles, centers, q, address(cell), any)
  end function pw85_overlap_any_indices

  !> Forces, torques and virial of an energy U(mu**2) of pairs: derivatives from pw85_contact_derivatives_pairs(), times d_u.
  function pw85_contact_forces_pairs(num_pairs, pairs, num_particles, centers, cell, d_u, d_r12, d_rot1, d_rot2, &
      forces, torques, virial, images) result(status)
    integer(c_size_t), intent(in) :: num_pairs, num_particles
    integer(c_int32_t), intent(in) :: pairs(2, num_pairs)
    real(c_double), intent(in) :: centers(3, num_particles), d_u(num_pairs)
    real(c_double), intent(in), optional, target :: cell(3, 3)
    real(c_double), intent(in), optional, target :: d_r12(3, num_pairs), d_rot1(3, num_pairs), d_rot2(3, num_pairs)
    real(c_double), intent(out), optional, target :: forces(3, num_particles), torques(3, num_particles), virial(3, 3)
    integer(c_int32_t), intent(in), optional, target :: images(3, num_pairs)
    integer(c_int) :: status
    status = c_contact_forces_pairs(num_pairs, pairs, address_of_integers(images), num_particles, centers, address(cell), &
                                    d_u, address(d_r12), address(d_rot1), address(d_rot2), address(forces), &
                                    address(torques), address(virial))
  end function pw85_contact_forces_pairs

  !> A list of all pairs whose boxes, scaled, are no farther apart than the skin along any axis; the vectors of the cell are its
  !> columns. Without `periodic` there are images along all of them. To be freed by pw85_neighbors_destroy().
  function pw85_neighbors_create(n, centers, q, cell, periodic, scale, skin, list) result(status)
    integer(c_size_t), intent(in) :: n
    real(c_double), intent(in) :: centers(3, n), q(6, n), scale, skin
    real(c_double), intent(in), optional, target :: cell(3, 3)
    integer(c_int32_t), intent(in), optional, target :: periodic(3)
    type(c_ptr), intent(out) :: list
    integer(c_int) :: status
    status = c_neighbors_create(n, centers, q, address(cell), address_of_integers(periodic), scale, skin, list)
  end function pw85_neighbors_create

  !> Which particle, from 0, is to blame where pw85_neighbors_create() fails; n if none is.
  function pw85_neighbors_check(n, centers, q, cell, periodic, scale, skin, particle) result(status)
    integer(c_size_t), intent(in) :: n
    real(c_double), intent(in) :: centers(3, n), q(6, n), scale, skin
    real(c_double), intent(in), optional, target :: cell(3, 3)
    integer(c_int32_t), intent(in), optional, target :: periodic(3)
    integer(c_size_t), intent(out) :: particle
    integer(c_int) :: status
    status = c_neighbors_check(n, centers, q, address(cell), address_of_integers(periodic), scale, skin, particle)
  end function pw85_neighbors_check

  !> The pairs of a neighbour list: indices from 0, as long as the list lives.
  function pw85_neighbors_pairs(list) result(pairs)
    type(c_ptr), intent(in) :: list
    integer(c_int32_t), pointer :: pairs(:, :)
    call c_f_pointer(c_neighbors_pairs(list), pairs, [2_c_size_t, pw85_neighbors_size(list)])
  end function pw85_neighbors_pairs

  !> Their images: multiples of the vectors of the cell; null without a cell.
  function pw85_neighbors_images(list) result(images)
    type(c_ptr), intent(in) :: list
    integer(c_int32_t), pointer :: images(:, :)
    images => null()
    if (c_associated(c_neighbors_images(list))) &
      call c_f_pointer(c_neighbors_images(list), images, [3_c_size_t, pw85_neighbors_size(list)])
  end function pw85_neighbors_images

  !> Contact function, contact point, normal and derivatives of n pairs.
  function pw85_contact_derivatives_batch(n, r12, q1, q2, mu2, lambda, point, normal, d_r12, d_rot1, d_rot2) &
      result(status)
    integer(c_size_t), intent(in) :: n
    real(c_double), intent(in) :: r12(3, n), q1(6, n), q2(6, n)
    real(c_double), intent(out), optional, target :: mu2(n), lambda(n)
    real(c_double), intent(out), optional, target :: point(3, n), normal(3, n), d_r12(3, n), d_rot1(3, n), d_rot2(3, n)
    integer(c_int) :: status
    status = c_contact_derivatives_batch(n, r12, q1, q2, address(mu2), address(lambda), address(point), &
                                         address(normal), address(d_r12), address(d_rot1), address(d_rot2))
  end function pw85_contact_derivatives_batch

  !> The same for the pairs of a neighbour list; `cell` and `images` as in pw85_contact_pairs().
  function pw85_contact_derivatives_pairs(num_pairs, pairs, num_particles, centers, q, cell, mu2, lambda, point, &
      normal, d_r12, d_rot1, d_rot2, images) result(status)
    integer(c_size_t), intent(in) :: num_pairs, num_particles
    integer(c_int32_t), intent(in) :: pairs(2, num_pairs)
    real(c_double), intent(in) :: centers(3, num_particles), q(6, num_particles)
    real(c_double), intent(in), optional, target :: cell(3, 3)
    real(c_double), intent(out), optional, target :: mu2(num_pairs), lambda(num_pairs), point(3, num_pairs), &
      normal(3, num_pairs), d_r12(3, num_pairs), d_rot1(3, num_pairs), d_rot2(3, num_pairs)
    integer(c_int32_t), intent(in), optional, target :: images(3, num_pairs)
    integer(c_int) :: status
    status = c_contact_derivatives_pairs(num_pairs, pairs, address_of_integers(images), num_particles, centers, q, &
                                         address(cell), address(mu2), address(lambda), address(point), &
                                         address(normal), address(d_r12), address(d_rot1), address(d_rot2))
  end function pw85_contact_derivatives_pairs

  !> First contacts of the pairs of a neighbour list, the next event of each particle, and the index of its pair, from 0 (-1 if there
  !> is none), which is not to be asked for without `next`; `cell` and `images` as in pw85_contact_pairs().
  function pw85_first_contact_pairs(num_pairs, pairs, num_particles, centers, q, cell, motions, t_max, t, next, &
      next_pair, images) result(status)
    integer(c_size_t), intent(in) :: num_pairs, num_particles
    integer(c_int32_t), intent(in) :: pairs(2, num_pairs)
    real(c_double), intent(in) :: centers(3, num_particles), q(6, num_particles), t_max
    real(c_double), intent(in), optional, target :: cell(3, 3)
    type(pw85_motion), intent(in) :: motions(num_particles)
    real(c_double), intent(out) :: t(num_pairs)
    real(c_double), intent(out), optional, target :: next(num_particles)
    integer(c_int64_t), intent(out), optional, target :: next_pair(num_particles)
    integer(c_int32_t), intent(in), optional, target :: images(3, num_pairs)
    type(c_ptr) :: indices
    integer(c_int) :: status
    indices = c_null_ptr
    if (present(next_pair)) indices = c_loc(next_pair)
    status = c_first_contact_pairs(num_pairs, pairs, address_of_integers(images), num_particles, centers, q, &
                                   address(cell), motions, t_max, t, address(next), indices)
  end function pw85_first_contact_pairs

  !> A reduced cell of the same lattice; columns are the vectors.
  function pw85_cell_reduce(cell, reduced) result(status)
    real(c_double), intent(in) :: cell(3, 3)
    real(c_double), intent(out) :: reduced(3, 3)
    real(c_double) :: rows(9)
    integer(c_int) :: status
    status = c_cell_reduce(reshape(cell, [9]), rows)
    reduced = reshape(rows, [3, 3])
  end function pw85_cell_reduce

  !> f(lambda) by factorisation; out = [f, f', f''].
  function pw85_legacy_f1(lambda, r12, q1, q2, out) result(f)
    real(c_double), intent(in) :: lambda, r12(3), q1(6), q2(6)
    real(c_double), intent(out), optional, target :: out(3)
    real(c_double) :: f
    f = c_legacy_f1(lambda, r12, q1, q2, address(out))
  end function pw85_legacy_f1

  !> f(lambda) as a rational function; out = f.
  function pw85_legacy_f2(lambda, r12, q1, q2, out) result(f)
    real(c_double), intent(in) :: lambda, r12(3), q1(6), q2(6)
    real(c_double), intent(out), optional, target :: out(1)
    real(c_double) :: f
    f = c_legacy_f2(lambda, r12, q1, q2, address(out))
  end function pw85_legacy_f2

  !> Address of an array for C: null if there is none.
  function address(x) result(pointer)
    real(c_double), intent(in), optional, target :: x(*)
    type(c_ptr) :: pointer
    pointer = c_null_ptr
    if (present(x)) pointer = c_loc(x(1))
  end function address

  function address_of_number(x) result(pointer)
    real(c_double), intent(in), optional, target :: x
    type(c_ptr) :: pointer
    pointer = c_null_ptr
    if (present(x)) pointer = c_loc(x)
  end function address_of_number

  function address_of_integers(x) result(pointer)
    integer(c_int32_t), intent(in), optional, target :: x(*)
    type(c_ptr) :: pointer
    pointer = c_null_ptr
    if (present(x)) pointer = c_loc(x(1))
  end function address_of_integers

  function fortran_string(c_text) result(text)
    type(c_ptr), intent(in) :: c_text
    character(:), allocatable :: text
    character(kind=c_char), pointer :: characters(:)
    integer(c_size_t) :: i, length
    length = c_strlen(c_text)
    call c_f_pointer(c_text, characters, [length])
    allocate (character(length) :: text)
    do i = 1, length
      text(i:i) = characters(i)
    end do
  end function fortran_string

end module pw85
