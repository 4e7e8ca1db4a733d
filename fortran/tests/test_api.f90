! SPDX-License-Identifier: BSD-3-Clause
!> Calls every function of the module once, with answers that are known or follow from another function.
program test_api
  use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
  use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_f_pointer, c_int, c_int8_t, c_int32_t, &
    c_int64_t, c_loc, c_ptr, c_size_t
  use, intrinsic :: iso_fortran_env, only: error_unit
  use pw85
  implicit none

  ! Relative to numbers of order one: some hundred roundings.
  real(c_double), parameter :: tolerance = 1e-13_c_double

  ! Spheroids with equatorial and polar radii 1, 2 and 3, 1/2; their axes are x and the diagonal of space.
  real(c_double) :: q1(6), q2(6)
  real(c_double), parameter :: r12(3) = [4.0_c_double, -1.0_c_double, 2.0_c_double]
  integer :: failures

  failures = 0
  call pw85_spheroid(1.0_c_double, 2.0_c_double, [1.0_c_double, 0.0_c_double, 0.0_c_double], q1)
  call pw85_spheroid(3.0_c_double, 0.5_c_double, [1.0_c_double, 1.0_c_double, 1.0_c_double], q2)

  call test_strings
  call test_mode
  call test_forms
  call test_contact
  call test_derivatives
  call test_two_dimensions
  call test_any_dimension
  call test_distances
  call test_surfaces
  call test_motions
  call test_walls
  call test_batch
  call test_pairs
  call test_building_blocks
  call test_legacy
  call test_errors
  if (failures > 0) error stop 1

contains

  subroutine check(ok, what)
    logical, intent(in) :: ok
    character(*), intent(in) :: what
    if (ok) return
    write (error_unit, '(2a)') 'failed: ', what
    failures = failures + 1
  end subroutine check

  elemental function close(x, y)
    real(c_double), intent(in) :: x, y
    logical :: close
    close = abs(x - y) <= tolerance * max(1.0_c_double, abs(y))
  end function close

  subroutine test_strings
    character(32) :: expected
    write (expected, '(i0, ".", i0, ".", i0)') pw85_version_major, pw85_version_minor, pw85_version_patch
    call check(pw85_version() == trim(expected), 'version')
    call check(pw85_strerror(pw85_success) == 'success', 'strerror(success)')
    call check(len(pw85_strerror(pw85_enotpd)) > 20, 'strerror(enotpd)')
    call check(pw85_strerror(-7_c_int) /= pw85_strerror(pw85_success), 'strerror(unknown)')
  end subroutine test_strings

  subroutine test_mode
    real(c_double) :: contact(2), by_brent(2)
    integer(c_int) :: on, status
    call check(pw85_set_reproducible(1_c_int) == pw85_success, 'set_reproducible')
    status = pw85_is_reproducible(on)
    call check(status == pw85_success .and. on == 1, 'is_reproducible')
    status = pw85_contact(r12, q1, q2, contact)
    status = pw85_contact_function(r12, q1, q2, by_brent)
    call check(all(abs(contact - by_brent) <= 0), 'contact_function in the reproducible mode')
    call check(pw85_set_reproducible(2_c_int) == pw85_einval, 'set_reproducible(2)')
    call check(pw85_set_reproducible(0_c_int) == pw85_success, 'set_reproducible(0)')
    status = pw85_is_reproducible(on)
    call check(status == pw85_success .and. on == 0, 'is_reproducible: off')
  end subroutine test_mode

  subroutine test_forms
    real(c_double), parameter :: semi_axes(3) = [3.0_c_double, 2.0_c_double, 1.0_c_double]
    real(c_double), parameter :: s = sqrt(0.5_c_double)
    real(c_double) :: q(6), other(6), rotation(3, 3), q2d(3)
    integer :: status
    ! A quarter of a turn from x to y, and an eighth: the columns are where the principal directions go.
    rotation = reshape([0.0_c_double, 1.0_c_double, 0.0_c_double, -1.0_c_double, 0.0_c_double, 0.0_c_double, &
                        0.0_c_double, 0.0_c_double, 1.0_c_double], [3, 3])
    status = pw85_ellipsoid(semi_axes, rotation, q)
    call check(status == pw85_success, 'ellipsoid: status')
    call check(all(close(q, [4.0_c_double, 0.0_c_double, 0.0_c_double, 9.0_c_double, 0.0_c_double, 1.0_c_double])), &
               'ellipsoid')
    rotation(:, 1) = [s, s, 0.0_c_double]
    rotation(:, 2) = [-s, s, 0.0_c_double]
    status = pw85_ellipsoid(semi_axes, rotation, q)
    call check(close(q(2), 2.5_c_double), 'ellipsoid: columns are the principal directions')
    status = pw85_ellipsoid_quaternion(semi_axes, [cos(atan(1.0_c_double) / 2), 0.0_c_double, 0.0_c_double, &
                                                   sin(atan(1.0_c_double) / 2)], other)
    call check(status == pw85_success .and. all(close(q, other)), 'ellipsoid_quaternion')
    status = pw85_ellipse(3.0_c_double, 2.0_c_double, atan(1.0_c_double), q2d)
    call check(status == pw85_success .and. all(close(q2d, [q(1), q(2), q(4)])), 'ellipse')
  end subroutine test_forms

  subroutine test_contact
    real(c_double) :: out(2), brent(2), residual(3), flat(2)
    integer(c_int) :: overlap
    integer :: status
    status = pw85_contact(r12, q1, q2, out)
    call check(status == pw85_success .and. out(1) > 0 .and. out(2) > 0 .and. out(2) < 1, 'contact')
    status = pw85_contact_function(r12, q1, q2, brent)
    call check(status == pw85_success .and. close(brent(1), out(1)), 'contact_function')
    call pw85__residual(out(2), r12, q1, q2, residual)
    call check(close(residual(1), out(1)) .and. abs(residual(2)) <= 1e-6 * abs(residual(3)), 'residual at the maximum')
    call check(close(pw85_f_neg(out(2), [r12, q1, q2]), -out(1)), 'f_neg')
    status = pw85_overlap(r12, q1, q2, overlap)
    call check(status == pw85_success .and. (overlap == 1) .eqv. (out(1) < 1), 'overlap')
    status = pw85_overlap(0.1_c_double * r12, q1, q2, overlap)
    call check(status == pw85_success .and. overlap == 1, 'overlap of near ellipsoids')
    ! Two circles with radii 1 and 2 at the distance 6.
    status = pw85_contact_2d([0.0_c_double, 6.0_c_double], [1.0_c_double, 0.0_c_double, 1.0_c_double], &
                             [4.0_c_double, 0.0_c_double, 4.0_c_double], flat)
    call check(status == pw85_success .and. close(flat(1), 4.0_c_double) .and. close(flat(2), 1.0_c_double / 3), &
               'contact_2d')
  end subroutine test_contact

  subroutine test_derivatives
    real(c_double) :: out(2), point(3), normal(3), alone(3), d_r12(3), d_q1(6), d_q2(6), torque1(3), torque2(3)
    real(c_double) :: hessian(9, 9)
    integer :: status
    status = pw85_contact(r12, q1, q2, out)
    status = pw85_contact_geometry(r12, q1, q2, out(2), point, normal)
    call check(status == pw85_success .and. close(norm2(normal), 1.0_c_double), 'contact_geometry')
    status = pw85_contact_geometry(r12, q1, q2, out(2), normal=alone)
    call check(status == pw85_success .and. all(close(alone, normal)), 'contact_geometry, one output')
    ! The contact function is of degree 2 in r12 and -1 in the forms.
    status = pw85_contact_gradient(r12, q1, q2, out(2), d_r12, d_q1, d_q2)
    call check(status == pw85_success .and. close(dot_product(d_r12, r12), 2 * out(1)), 'contact_gradient: r12')
    call check(close(dot_product(d_q1, q1) + dot_product(d_q2, q2), -out(1)), 'contact_gradient: forms')
    status = pw85_contact_gradient(r12, q1, q2, out(2), d_r12=alone)
    call check(status == pw85_success .and. all(close(alone, d_r12)), 'contact_gradient, one output')
    ! Turning everything changes nothing: d_rot1 + d_rot2 + r12 x d_r12 = 0.
    status = pw85_contact_torque(r12, q1, q2, out(2), torque1, torque2)
    alone = torque1 + torque2 + [r12(2) * d_r12(3) - r12(3) * d_r12(2), r12(3) * d_r12(1) - r12(1) * d_r12(3), &
                                 r12(1) * d_r12(2) - r12(2) * d_r12(1)]
    call check(status == pw85_success .and. all(abs(alone) <= tolerance * out(1)), 'contact_torque')
    status = pw85_contact_torque(r12, q1, q2, out(2), d_rot2=alone)
    call check(status == pw85_success .and. all(close(alone, torque2)), 'contact_torque, one output')
    ! The gradient is of degree 1 in r12, and torques of degree 2.
    status = pw85_contact_hessian(r12, q1, q2, out(2), hessian)
    call check(status == pw85_success .and. all(close(matmul(hessian(:, 1:3), r12), [d_r12, 2 * torque1, 2 * torque2])), &
               'contact_hessian')
  end subroutine test_derivatives

  subroutine test_two_dimensions
    integer(c_size_t), parameter :: n = 2
    real(c_double), parameter :: d(2) = [3.0_c_double, 1.0_c_double]
    real(c_double) :: out(2), e1(3), e2(3), point(2), normal(2), d_r12(2), d_q1(3), d_q2(3), torque1, torque2, alone
    real(c_double) :: hessian(4, 4), r(2, n), forms1(3, n), forms2(3, n), mu2(n), lambda(n)
    integer(c_int) :: overlap
    integer(c_int8_t) :: overlaps(n)
    integer :: status
    status = pw85_ellipse(3.0_c_double, 1.0_c_double, 0.3_c_double, e1)
    status = pw85_ellipse(2.0_c_double, 1.5_c_double, 2.0_c_double, e2)
    status = pw85_contact_2d(d, e1, e2, out)
    status = pw85_contact_geometry_2d(d, e1, e2, out(2), point, normal)
    call check(status == pw85_success .and. close(norm2(normal), 1.0_c_double), 'contact_geometry_2d')
    status = pw85_contact_gradient_2d(d, e1, e2, out(2), d_r12, d_q1, d_q2)
    call check(status == pw85_success .and. close(dot_product(d_r12, d), 2 * out(1)), 'contact_gradient_2d: r12')
    call check(close(dot_product(d_q1, e1) + dot_product(d_q2, e2), -out(1)), 'contact_gradient_2d: forms')
    status = pw85_contact_torque_2d(d, e1, e2, out(2), torque1, torque2)
    call check(status == pw85_success .and. abs(torque1 + torque2 + d(1) * d_r12(2) - d(2) * d_r12(1)) <= tolerance * out(1), &
               'contact_torque_2d')
    status = pw85_contact_torque_2d(d, e1, e2, out(2), d_rot2=alone)
    call check(status == pw85_success .and. close(alone, torque2), 'contact_torque_2d, one output')
    status = pw85_contact_hessian_2d(d, e1, e2, out(2), hessian)
    call check(status == pw85_success .and. all(close(matmul(hessian(:, 1:2), d), [d_r12, 2 * torque1, 2 * torque2])), &
               'contact_hessian_2d')
    status = pw85_overlap_2d(d, e1, e2, overlap)
    call check(status == pw85_success .and. (overlap == 1) .eqv. (out(1) < 1), 'overlap_2d')
    r(:, 1) = d
    r(:, 2) = 2 * d
    forms1 = spread(e1, 2, int(n))
    forms2 = spread(e2, 2, int(n))
    status = pw85_contact_batch_2d(n, r, forms1, forms2, mu2, lambda)
    call check(status == pw85_success .and. all(close(mu2, [out(1), 4 * out(1)])), 'contact_batch_2d')
    status = pw85_overlap_batch_2d(n, r, forms1, forms2, overlaps)
    call check(status == pw85_success .and. all((overlaps == 1) .eqv. (mu2 < 1)), 'overlap_batch_2d')
  end subroutine test_two_dimensions

  !> Balls of radii 1 and 2 in five dimensions, 6 apart.
  subroutine test_any_dimension
    real(c_double) :: r(5), a(15), b(15), out(2), point(5), normal(5), d_r12(5), d_q1(15), d_q2(15), mu2(1), lambda(1)
    integer(c_size_t), parameter :: one = 1
    integer(c_int) :: status, overlap, sign
    integer(c_int8_t) :: overlaps(1)
    integer(c_int) :: signs(1)
    integer :: i, k
    r = [6, 0, 0, 0, 0]
    a = 0
    k = 1
    do i = 5, 1, -1
      a(k) = 1
      k = k + i
    end do
    b = 4 * a
    status = pw85_nd_contact(5, r, a, b, out)
    call check(status == pw85_success .and. close(out(1), 4.0_c_double) .and. close(out(2), 1.0_c_double / 3), 'nd_contact')
    status = pw85_nd_contact_geometry(5, r, a, b, out(2), point, normal, d_r12, d_q1, d_q2)
    call check(status == pw85_success .and. close(point(1), 2.0_c_double) .and. close(normal(1), 1.0_c_double), &
      'nd_contact_geometry')
    call check(close(d_r12(1), 4.0_c_double / 3) .and. close(dot_product(d_q1, a) + dot_product(d_q2, b), -4.0_c_double), &
      'nd_contact_geometry: derivatives')
    status = pw85_nd_overlap(5, r, a, b, overlap)
    call check(status == pw85_success .and. overlap == 0, 'nd_overlap')
    status = pw85_nd_compare(5, r, a, b, 4.0_c_double, sign)
    call check(status == pw85_success .and. sign == 0, 'nd_compare')
    status = pw85_nd_contact_batch(one, 5, r, a, b, mu2, lambda)
    call check(status == pw85_success .and. abs(mu2(1) - out(1)) <= 0, 'nd_contact_batch')
    status = pw85_nd_contact_geometry_batch(one, 5, r, a, b, lambda, normal=normal)
    call check(status == pw85_success .and. close(normal(1), 1.0_c_double), 'nd_contact_geometry_batch')
    status = pw85_nd_overlap_batch(one, 5, r, a, b, overlaps)
    call check(status == pw85_success .and. overlaps(1) == 0, 'nd_overlap_batch')
    status = pw85_nd_compare_batch(one, 5, r, a, b, [4.5_c_double], signs)
    call check(status == pw85_success .and. signs(1) == -1, 'nd_compare_batch')
    r = [1, 0, 0, 0, 0]
    status = pw85_nd_contains(5, r, b, a, overlap)
    call check(status == pw85_success .and. overlap == 1, 'nd_contains')
    status = pw85_nd_contains_batch(one, 5, r, a, b, overlaps)
    call check(status == pw85_success .and. overlaps(1) == 0, 'nd_contains_batch')
    status = pw85_nd_containment(5, r, a, b, out(1), point)
    call check(status == pw85_success .and. close(out(1), 9.0_c_double) .and. close(point(1), 3.0_c_double), 'nd_containment')
    status = pw85_nd_containment_batch(one, 5, r, a, b, mu2)
    call check(status == pw85_success .and. abs(mu2(1) - out(1)) <= 0, 'nd_containment_batch')
    r = [6, 0, 0, 0, 0]
    status = pw85_nd_distance(5, r, a, b, out(1), point, normal=normal)
    call check(status == pw85_success .and. close(out(1), 3.0_c_double) .and. close(point(1), 1.0_c_double), 'nd_distance')
    status = pw85_nd_distance_batch(one, 5, r, a, b, mu2)
    call check(status == pw85_success .and. abs(mu2(1) - out(1)) <= 0, 'nd_distance_batch')
  end subroutine test_any_dimension


  subroutine test_distances
    real(c_double) :: out(2), distance, zheng, e1(3), e2(3)
    real(c_double), parameter :: d(2) = [3.0_c_double, 1.0_c_double]
    integer :: status
    status = pw85_contact(r12, q1, q2, out)
    status = pw85_closest_approach(r12, q1, q2, distance)
    call check(status == pw85_success .and. close(distance, norm2(r12) / sqrt(out(1))), 'closest_approach')
    status = pw85_zheng_ellipsoids(r12, q1, q2, zheng)
    call check(status == pw85_success .and. close(zheng, distance), 'zheng_ellipsoids')
    status = pw85_ellipse(3.0_c_double, 1.0_c_double, 0.3_c_double, e1)
    status = pw85_ellipse(2.0_c_double, 1.5_c_double, 2.0_c_double, e2)
    status = pw85_contact_2d(d, e1, e2, out)
    status = pw85_closest_approach_2d(d, e1, e2, distance)
    call check(status == pw85_success .and. close(distance, norm2(d) / sqrt(out(1))), 'closest_approach_2d')
    status = pw85_zheng_ellipses(d, e1, e2, zheng)
    call check(status == pw85_success .and. close(zheng, distance), 'zheng_ellipses')
  end subroutine test_distances

  subroutine test_surfaces
    real(c_double) :: apart(3), gap, point1(3), point2(3), normal(3), torque1(3), torque2(3), hessian(9, 9), alone(3)
    real(c_double) :: ellipse1(3), ellipse2(3), end1(2), end2(2)
    integer :: status
    apart = 4 * r12
    status = pw85_distance(apart, q1, q2, gap, point1, point2)
    call check(status == pw85_success .and. close(norm2(point2 - point1), gap), 'distance')
    status = pw85_distance(apart, q1, q2, alone(1))
    call check(status == pw85_success .and. abs(alone(1) - gap) <= 0, 'distance without points')
    status = pw85_distance_derivatives(apart, q1, q2, normal, torque1, torque2, hessian)
    call check(status == pw85_success .and. all(close(gap * normal, point2 - point1)), 'distance_derivatives')
    call check(all(abs(matmul(hessian(1:3, 1:3), normal)) <= tolerance), 'distance_derivatives, hessian')
    status = pw85_distance_derivatives(apart, q1, q2, d_rot2=alone)
    call check(status == pw85_success .and. all(abs(alone - torque2) <= 0), 'distance_derivatives, one output')
    status = pw85_ellipse(2.0_c_double, 1.0_c_double, 0.0_c_double, ellipse1)
    status = pw85_ellipse(1.0_c_double, 3.0_c_double, 0.0_c_double, ellipse2)
    status = pw85_distance_2d([7.0_c_double, 0.0_c_double], ellipse1, ellipse2, gap, end1, end2)
    call check(status == pw85_success .and. close(gap, 4.0_c_double) .and. close(end1(1), 2.0_c_double) &
      .and. close(end2(1), 6.0_c_double), 'distance_2d')
    status = pw85_distance(0 * r12, q1, q2, gap)
    call check(status == pw85_success .and. abs(gap) <= 0, 'distance of an overlap')
    status = pw85_penetration([0.0_c_double, 0.5_c_double, 0.0_c_double], q1, q1, gap, normal)
    call check(status == pw85_success .and. close(gap, 1.5_c_double) .and. close(abs(normal(2)), 1.0_c_double), 'penetration')
    status = pw85_penetration(apart, q1, q2, gap)
    call check(status == pw85_success .and. abs(gap) <= 0, 'penetration of pairs apart')
  end subroutine test_surfaces

  ! Unit spheres on a line, three apart, of which the last comes at speed 1/2; and the first pair grows until it touches.
  subroutine test_motions
    integer(c_size_t), parameter :: n = 2
    integer(c_int32_t), target :: pairs(2, n)
    real(c_double), target :: centers(3, 3), q(6, 3)
    real(c_double) :: r(3, n), points(3, n), t, times(n), next(3), hessians(9, 9, n), infinite
    type(pw85_motion) :: motions(3)
    integer(c_int64_t) :: next_pair(3)
    integer :: status
    pairs = reshape([0, 1, 1, 2], [2, 2])
    centers = 0
    centers(1, :) = [0.0_c_double, 3.0_c_double, 6.0_c_double]
    q = 0
    q([1, 4, 6], :) = 1
    motions(3)%velocity(1) = -0.5_c_double
    infinite = huge(1.0_c_double)
    status = pw85_first_contact(centers(:, 2), q(:, 2), q(:, 3), motions(2), motions(3), 9.0_c_double, t)
    call check(status == pw85_success .and. close(t, 2.0_c_double), 'first_contact')
    status = pw85_first_contact(centers(:, 2), q(:, 2), q(:, 3), motions(2), motions(3), 1.0_c_double, t)
    call check(status == pw85_success .and. t > infinite, 'first_contact: none')
    motions(1:2)%growth = 0.125_c_double
    r(:, 1) = centers(:, 2)
    r(:, 2) = centers(:, 3) - centers(:, 2)
    status = pw85_first_contact_batch(n, r, q(:, 1:2), q(:, 2:3), motions(1:2), motions(2:3), 9.0_c_double, times)
    call check(status == pw85_success .and. close(times(1), 4.0_c_double) .and. close(times(2), 1.6_c_double), &
      'first_contact_batch')
    status = pw85_distance_batch(n, r, q(:, 1:2), q(:, 2:3), times, point2=points)
    call check(status == pw85_success .and. all(close(times, 1.0_c_double)) .and. &
      all(close(points(1, :), 2.0_c_double)), 'distance_batch')
    r = points
    status = pw85_distance_plane_batch(n, 2 * r, 4 * times, q(:, 1:2), next(1:2))
    call check(status == pw85_success .and. all(abs(next(1:2)) <= tolerance), 'distance_plane_batch')
    r = 0.5_c_double * r
    status = pw85_penetration_batch(n, r, q(:, 1:2), q(:, 2:3), times)
    call check(status == pw85_success .and. all(close(times, 1.0_c_double)), 'penetration_batch')
    times = 0.5_c_double
    status = pw85_contact_hessian_batch(n, r, q(:, 1:2), q(:, 2:3), times, hessians)
    call check(status == pw85_success .and. all(close(hessians(1, 1, :), 0.5_c_double)), 'contact_hessian_batch')
    r(1, :) = 3
    status = pw85_first_contact_pairs(pw85_pair_list(n, c_loc(pairs)), pw85_system(3, c_loc(centers), c_loc(q)), motions, &
                                      9.0_c_double, times, next, next_pair)
    call check(status == pw85_success .and. close(times(1), 4.0_c_double) .and. close(times(2), 1.6_c_double), &
      'first_contact_pairs')
    call check(close(next(1), 4.0_c_double) .and. close(next(2), 1.6_c_double) .and. all(next_pair == [0, 1, 1]), &
      'first_contact_pairs: next events')
  end subroutine test_motions

  subroutine test_walls
    real(c_double), parameter :: q(6) = [4.0_c_double, 0.0_c_double, 0.0_c_double, 1.0_c_double, 0.0_c_double, 1.0_c_double]
    real(c_double), parameter :: x(3) = [3.0_c_double, 0.0_c_double, 0.0_c_double]
    real(c_double), parameter :: z(3) = [0.0_c_double, 0.0_c_double, 2.0_c_double]
    real(c_double) :: gap, point(3), normal(3), turn(3), t(2)
    integer :: status
    status = pw85_distance_plane(x, 15.0_c_double, q, gap, point)
    call check(status == pw85_success .and. close(gap, 3.0_c_double) .and. close(point(1), 2.0_c_double), 'distance_plane')
    status = pw85_distance_plane_derivatives(x, q, normal, turn)
    call check(status == pw85_success .and. close(normal(1), -1.0_c_double) .and. all(abs(turn) <= 0), &
      'distance_plane_derivatives')
    status = pw85_contact_plane(x, 15.0_c_double, q, gap, point)
    call check(status == pw85_success .and. close(gap, 6.25_c_double) .and. close(point(1), 5.0_c_double), 'contact_plane')
    status = pw85_contact_plane_derivatives(x, 15.0_c_double, q, normal, turn)
    call check(status == pw85_success .and. close(normal(1), -2.5_c_double) .and. all(abs(turn) <= 0), &
      'contact_plane_derivatives')
    status = pw85_distance_box(-x - z - 2, x + z + 3, q, gap, point, normal)
    call check(status == pw85_success .and. close(gap, 1.0_c_double) .and. close(point(2), -1.0_c_double) &
      .and. close(normal(2), -1.0_c_double), 'distance_box')
    status = pw85_distance_cylinder(z, 5.0_c_double, x, q, gap, point, normal)
    call check(status == pw85_success .and. close(gap, 0.0_c_double) .and. close(normal(1), 1.0_c_double), &
      'distance_cylinder')
    status = pw85_distance_point(x, q, gap, point, normal)
    call check(status == pw85_success .and. close(gap, 1.0_c_double) .and. close(point(1), 2.0_c_double), 'distance_point')
    status = pw85_distance_point(0 * x, q, gap)
    call check(status == pw85_success .and. close(gap, -1.0_c_double), 'distance_point, inside')
    status = pw85_intersect_line(-x, x, q, t)
    call check(status == pw85_success .and. close(t(1), 1.0_c_double / 3) .and. close(t(2), 5.0_c_double / 3), &
      'intersect_line')
  end subroutine test_walls

  subroutine test_batch
    integer(c_size_t), parameter :: n = 3
    real(c_double) :: r(3, n), forms1(6, n), forms2(6, n), mu2(n), alone(n), lambda(n), out(2)
    real(c_double) :: distance(n), point(3, n), d_rot2(3, n), boxes(3, n), quaternions(4, 1), form(6), x(3)
    integer(c_int8_t) :: overlap(n)
    integer(c_int) :: any_overlap
    integer :: i, status
    do i = 1, 3
      r(:, i) = i * 0.6_c_double * r12
      forms1(:, i) = q1
      forms2(:, i) = q2
    end do
    status = pw85_contact_batch(n, r, forms1, forms2, mu2, lambda)
    call check(status == pw85_success, 'contact_batch: status')
    do i = 1, 3
      status = pw85_contact(r(:, i), q1, q2, out)
      call check(close(mu2(i), out(1)) .and. abs(lambda(i) - out(2)) <= 1e-7, 'contact_batch')
    end do
    status = pw85_contact_batch(n, r, forms1, forms2, alone)
    call check(status == pw85_success .and. all(close(alone, mu2)), 'contact_batch without lambda')
    status = pw85_overlap_batch(n, r, forms1, forms2, overlap)
    call check(status == pw85_success .and. all((overlap == 1) .eqv. (mu2 < 1)), 'overlap_batch')
    forms1(1, 2) = -1
    status = pw85_overlap_batch(n, r, forms1, forms2, overlap)
    call check(status == pw85_enotpd .and. overlap(2) == -1_c_int8_t .and. all(overlap([1, 3]) >= 0), &
               'overlap_batch: bad pair')
    status = pw85_contact_batch(0_c_size_t, r, forms1, forms2, mu2, lambda)
    call check(status == pw85_success, 'contact_batch of nothing')
    forms1(1, 2) = q1(1)
    status = pw85_contact_batch(n, r, forms1, forms2, mu2, lambda)
    status = pw85_closest_approach_batch(n, r, forms1, forms2, distance)
    do i = 1, 3
      call check(status == pw85_success .and. close(distance(i), norm2(r(:, i)) / sqrt(mu2(i))), 'closest_approach_batch')
    end do
    status = pw85_contact_derivatives_batch(n, r, forms1, forms2, point=point, d_rot2=d_rot2)
    call check(status == pw85_success, 'contact_derivatives_batch')
    do i = 1, 3
      status = pw85_contact_geometry(r(:, i), q1, q2, lambda(i), x)
      call check(all(close(point(:, i), x)), 'contact_derivatives_batch: point')
      status = pw85_contact_torque(r(:, i), q1, q2, lambda(i), d_rot2=x)
      call check(all(abs(d_rot2(:, i) - x) <= 1e-12_c_double * norm2(x)), 'contact_derivatives_batch: d_rot2')
    end do
    status = pw85_overlap_any(q1, n, r, forms2, any_overlap)
    call check(status == pw85_success .and. (any_overlap == 1) .eqv. any(mu2 < 1), 'overlap_any')
    status = pw85_bounding_boxes(n, forms2, boxes)
    call check(status == pw85_success .and. all(close(boxes(:, 3)**2, q2([1, 4, 6]))), 'bounding_boxes')
    quaternions(:, 1) = [1.0_c_double, 2.0_c_double, -1.0_c_double, 0.5_c_double]
    status = pw85_ellipsoid_quaternion_batch(1_c_size_t, boxes, quaternions, forms1)
    call check(status == pw85_success, 'ellipsoid_quaternion_batch: status')
    status = pw85_ellipsoid_quaternion(boxes(:, 1), quaternions(:, 1), form)
    call check(all(close(forms1(:, 1), form)), 'ellipsoid_quaternion_batch')
  end subroutine test_batch

  subroutine test_pairs
    integer(c_size_t), parameter :: num_pairs = 2, num_particles = 3
    integer(c_int32_t), target :: pairs(2, num_pairs)
    real(c_double), target :: centers(3, num_particles), q(6, num_particles), cell(3, 3), other(3, 3), moved(3, num_particles)
    type(pw85_pair_list) :: both, one, with_images, found
    type(pw85_law) :: law
    real(c_double), target :: line(6) = [0, 100, 0, 3, 300, 3] ! of 3 μ² as a table
    real(c_double) :: energy
    type(pw85_system) :: apart, system
    real(c_double) :: mu2(num_pairs), lambda(num_pairs), nearest(3, 1)
    integer(c_int32_t) :: image(3, 1)
    real(c_double) :: out(2)
    real(c_double) :: limit, d_r12(3, 1), d_rot1(3, 1), gradient(3)
    integer(c_int32_t), target :: images(3, 1)
    integer(c_int8_t) :: overlap(num_pairs)
    real(c_double) :: forces(3, num_particles), virial(3, 3)
    type(c_ptr) :: list
    integer(c_int32_t), pointer :: neighbors(:, :), multiples(:, :)
    integer(c_size_t) :: particle
    integer(c_int) :: holds
    integer :: status
    pairs = reshape([0, 1, 2, 0], [2, 2])
    centers(:, 1) = [0.5_c_double, 0.25_c_double, -0.5_c_double]
    centers(:, 2) = centers(:, 1) + r12
    centers(:, 3) = centers(:, 1) - 2 * r12
    q(:, 1) = q1
    q(:, 2) = q2
    q(:, 3) = q2
    both = pw85_pair_list(num_pairs, c_loc(pairs))
    one = pw85_pair_list(1, c_loc(pairs))
    with_images = pw85_pair_list(1, c_loc(pairs), c_loc(images))
    apart = pw85_system(num_particles, c_loc(centers), c_loc(q))
    system = pw85_system(num_particles, c_loc(centers), c_loc(q), c_loc(cell))
    status = pw85_contact_pairs(both, apart, mu2)
    call check(status == pw85_success, 'contact_pairs: status')
    status = pw85_contact(r12, q1, q2, out)
    call check(close(mu2(1), out(1)), 'contact_pairs, first pair')
    status = pw85_contact(2 * r12, q2, q1, out)
    call check(close(mu2(2), out(1)), 'contact_pairs, second pair')
    status = pw85_overlap_pairs(both, apart, overlap)
    call check(status == pw85_success .and. all((overlap == 1) .eqv. (mu2 < 1)), 'overlap_pairs')
    ! The vectors of the cell are its columns: by the second, particle 2 is r12 - (4, 0, 0) from particle 1.
    cell(:, 1) = [0.0_c_double, 30.0_c_double, 0.0_c_double]
    cell(:, 2) = [4.0_c_double, 0.0_c_double, 0.0_c_double]
    cell(:, 3) = [1.0_c_double, 2.0_c_double, 40.0_c_double]
    status = pw85_contact_pairs(one, system, mu2, lambda)
    call check(status == pw85_success, 'contact_pairs in a cell: status')
    status = pw85_contact(r12 - cell(:, 2), q1, q2, out)
    call check(close(mu2(1), out(1)) .and. abs(lambda(1) - out(2)) <= 1e-7, 'contact_pairs in a cell')
    status = pw85_nearest_images(1_c_size_t, pairs, system, nearest, image)
    call check(status == pw85_success .and. all(close(nearest(:, 1), r12 - cell(:, 2))) .and. &
               all(image(:, 1) == [0, -1, 0]), 'nearest_images')
    status = pw85_overlap_pairs(one, system, overlap)
    call check(status == pw85_success .and. (overlap(1) == 1) .eqv. (out(1) < 1), 'overlap_pairs in a cell')
    ! The same image by its multiples, and another cell of the same lattice.
    images(:, 1) = [0, -1, 0]
    status = pw85_contact_pairs(with_images, system, mu2)
    call check(status == pw85_success .and. close(mu2(1), out(1)), 'contact_pairs with images')
    status = pw85_overlap_pairs(with_images, system, overlap)
    call check(status == pw85_success .and. (overlap(1) == 1) .eqv. (out(1) < 1), 'overlap_pairs with images')
    status = pw85_contact_pairs(with_images, apart, mu2)
    call check(status == pw85_einval, 'contact_pairs: images without a cell')
    status = pw85_contact_derivatives_pairs(one, system, mu2, lambda, d_r12=d_r12, d_rot1=d_rot1)
    call check(status == pw85_success .and. close(mu2(1), out(1)), 'contact_derivatives_pairs')
    status = pw85_contact_gradient(r12 - cell(:, 2), q1, q2, lambda(1), gradient)
    call check(status == pw85_success .and. all(close(d_r12(:, 1), gradient)), 'contact_derivatives_pairs: d_r12')
    status = pw85_contact_forces_pairs(with_images, system, [3.0_c_double], d_r12, forces=forces, virial=virial)
    call check(status == pw85_success .and. all(close(forces(:, 1), 3 * d_r12(:, 1))), 'contact_forces_pairs: force')
    call check(all(abs(forces(:, 1) + forces(:, 2)) <= 0) .and. all(abs(forces(:, 3)) <= 0), 'contact_forces_pairs: others')
    call check(close(virial(1, 1) + virial(2, 2) + virial(3, 3), -6 * mu2(1)), 'contact_forces_pairs: virial')
    law = pw85_law(pw85_law_table, 6_c_size_t, c_loc(line))
    status = pw85_law_forces_pairs(with_images, system, law, energy, forces)
    call check(status == pw85_success .and. close(energy, 3 * mu2(1)), 'law_forces_pairs: energy')
    call check(all(close(forces(:, 1), 3 * d_r12(:, 1))), 'law_forces_pairs: force')
    status = pw85_overlap_any_indices(centers(:, 1), q1, system, 1_c_size_t, pairs(2:2, 1), any=holds)
    call check(status == pw85_success .and. (holds == 1) .eqv. (mu2(1) < 1), 'overlap_any_indices')
    image(:, 1) = [1, 0, 0]
    status = pw85_overlap_any_indices(centers(:, 1), q1, system, 1_c_size_t, pairs(1:1, 1), image, holds)
    call check(status == pw85_success .and. holds == 0, 'overlap_any_indices: image of itself')
    other = 1.0e-2_c_double * cell
    system%cell = c_loc(other)
    status = pw85_overlap_any_indices(centers(:, 1), q1, system, 0_c_size_t, pairs(2:2, 1), any=holds)
    call check(status == pw85_einval .and. holds == -1, 'overlap_any_indices: nearest images do not decide')
    system%cell = c_loc(cell)
    status = pw85_nearest_image_limit(system, limit)
    call check(status == pw85_success .and. limit > 0, 'nearest_image_limit')
    system%periodic = [0, 1, 0]
    status = pw85_neighbors_create(system, 1.0_c_double, 0.5_c_double, list)
    found = pw85_neighbors_list(list)
    call check(status == pw85_success .and. found%num_pairs > 0, 'neighbors_create')
    call c_f_pointer(found%pairs, neighbors, [2_c_size_t, found%num_pairs])
    call c_f_pointer(found%images, multiples, [3_c_size_t, found%num_pairs])
    call check(all(neighbors(1, :) <= neighbors(2, :)) .and. all(neighbors < num_particles), 'neighbors_list: pairs')
    call check(any(multiples(2, :) /= 0) .and. all(multiples([1, 3], :) == 0), 'neighbors_list: images')
    moved = centers
    system%centers = c_loc(moved)
    moved(:, 1) = moved(:, 1) + 0.4_c_double
    status = pw85_neighbors_holds(list, system, holds)
    call check(status == pw85_success .and. holds == 1, 'neighbors_holds')
    moved(:, 1) = moved(:, 1) + 0.2_c_double
    status = pw85_neighbors_holds(list, system, holds)
    call check(status == pw85_success .and. holds == 0, 'neighbors_holds no more')
    other = 0.5_c_double * cell
    system%centers = c_loc(centers)
    system%cell = c_loc(other)
    status = pw85_neighbors_holds(list, system, holds)
    call check(status == pw85_success .and. holds == 0, 'neighbors_holds in another cell')
    status = pw85_neighbors_holds(list, apart, holds)
    call check(status == pw85_einval .and. holds == -1, 'neighbors_holds without its cell')
    call pw85_neighbors_destroy(list)
    status = pw85_neighbors_create(apart, 1.0_c_double, 0.0_c_double, list)
    found = pw85_neighbors_list(list)
    call check(status == pw85_success .and. .not. c_associated(found%images), 'neighbors without a cell')
    call pw85_neighbors_destroy(list)
    q(4, 2) = -1
    status = pw85_neighbors_check(apart, 1.0_c_double, 0.0_c_double, particle)
    call check(status == pw85_enotpd .and. particle == 1, 'neighbors_check')
    q(:, 2) = q2
    cell(:, 3) = cell(:, 3) + 10 * cell(:, 2)
    status = pw85_cell_reduce(cell, other)
    call check(status == pw85_success .and. maxval(abs(other)) <= 40, 'cell_reduce')
    system = pw85_system(num_particles, c_loc(centers), c_loc(q), c_loc(other))
    status = pw85_contact_pairs(one, system, mu2)
    call check(status == pw85_success .and. close(mu2(1), out(1)), 'contact_pairs in a reduced cell')
  end subroutine test_pairs

  subroutine test_building_blocks
    real(c_double), parameter :: b(3) = [1.0_c_double, 2.0_c_double, 3.0_c_double]
    real(c_double) :: l(6), x(3)
    call pw85__cholesky_decomp(q2, l)
    call check(close(l(1)**2, q2(1)) .and. close(l(1) * l(2), q2(2)), 'cholesky_decomp')
    call pw85__cholesky_solve(l, b, x)
    call check(close(q2(1) * x(1) + q2(2) * x(2) + q2(3) * x(3), b(1)), 'cholesky_solve')
  end subroutine test_building_blocks

  subroutine test_legacy
    real(c_double), parameter :: x = 0.5_c_double, guard = -1.25_c_double
    real(c_double) :: a(3), b(4), q3(6), q4(6), residual(3), d1(3), d2(3), contact(2), out(2)
    integer :: status
    call check(close(pw85_legacy__det_sym(q1), 4.0_c_double), 'det_sym')
    call check(close(pw85_legacy__xt_adja_x(r12, q1), r12(1)**2 + 4 * (r12(2)**2 + r12(3)**2)), 'xT_adjA_x')
    q3 = 2 * q1 - q2
    q4 = (q1 + q2) / 2
    call pw85_legacy__detq_as_poly(q1, q2, q3, q4, b)
    call check(close(b(1) + x * (b(2) + x * (b(3) + x * b(4))), pw85_legacy__det_sym(q4)), 'detQ_as_poly')
    call pw85_legacy__rt_adjq_r_as_poly(r12, q1, q2, q3, a)
    call check(close(a(1) + x * (a(2) + x * a(3)), pw85_legacy__xt_adja_x(r12, q4)), 'rT_adjQ_r_as_poly')
    call pw85__residual(x, r12, q1, q2, residual)
    call check(close(pw85_legacy_f1(x, r12, q1, q2), residual(1)), 'f1 without derivatives')
    call check(close(pw85_legacy_f1(x, r12, q1, q2, d1), residual(1)), 'f1')
    call check(close(pw85_legacy_f2(x, r12, q1, q2), residual(1)), 'f2 without derivatives')
    d2 = guard
    call check(close(pw85_legacy_f2(x, r12, q1, q2, d2(1:1)), residual(1)), 'f2')
    call check(close(d2(1), residual(1)) .and. all(abs(d2(2:3) - guard) <= 0), 'f2 writes one number')
    call pw85_legacy_f2_derivatives(x, r12, q1, q2, d2)
    call check(all(abs(d1 - d2) <= 1e-12 * abs(d1)), 'derivatives of f1 and f2')
    status = pw85_contact(r12, q1, q2, contact)
    status = pw85_legacy_contact_function1(r12, q1, q2, out)
    call check(status == pw85_econvergence .or. abs(out(1) - contact(1)) <= 1e-12 * contact(1), 'contact_function1')
    status = pw85_legacy_contact_function2(r12, q1, q2, out)
    call check(status == pw85_success .and. abs(out(1) - contact(1)) <= 1e-12 * contact(1), 'contact_function2')
  end subroutine test_legacy

  subroutine test_errors
    real(c_double) :: out(2), distance, bad(6)
    integer :: status
    bad = q1
    bad(4) = -1
    status = pw85_contact(r12, bad, q2, out)
    call check(status == pw85_enotpd .and. all(ieee_is_nan(out)), 'form that is not positive definite')
    status = pw85_closest_approach(0 * r12, q1, q2, distance)
    call check(status == pw85_einval .and. ieee_is_nan(distance), 'zero direction')
  end subroutine test_errors

end program test_api
