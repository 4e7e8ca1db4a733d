!> Do a thin disk and a rod overlap? Prints the contact function of the two, then checks
!> it: with the factor mu the two touch, in one point and with one tangent plane.
program tutorial
  use, intrinsic :: iso_c_binding, only: c_double
  use, intrinsic :: iso_fortran_env, only: error_unit
  use pw85
  implicit none

  ! An oblate spheroid: equatorial radius 10, polar radius 0.1, axis z.
  real(c_double), parameter :: x1(3) = [-0.5_c_double, 0.4_c_double, -0.7_c_double]
  real(c_double), parameter :: n1(3) = [0.0_c_double, 0.0_c_double, 1.0_c_double]
  real(c_double), parameter :: a1 = 10.0_c_double, c1 = 0.1_c_double

  ! A prolate spheroid: equatorial radius 0.5, polar radius 5, axis x.
  real(c_double), parameter :: x2(3) = [0.2_c_double, -0.3_c_double, 0.4_c_double]
  real(c_double), parameter :: n2(3) = [1.0_c_double, 0.0_c_double, 0.0_c_double]
  real(c_double), parameter :: a2 = 0.5_c_double, c2 = 5.0_c_double

  real(c_double) :: r12(3), q1(6), q2(6), out(2), mu2, lambda
  real(c_double) :: point(3), from1(3), from2(3), gradient1(3), gradient2(3)

  r12 = x2 - x1
  call pw85_spheroid(a1, c1, n1, q1)
  call pw85_spheroid(a2, c2, n2, q2)

  call check(pw85_contact(r12, q1, q2, out))
  mu2 = out(1)
  lambda = out(2)
  print '(a, f7.5)', 'mu^2 = ', mu2
  print '(a, f8.6)', 'lambda = ', lambda
  print '(3a/)', 'The spheroids ', &
    trim(merge('overlap       ', 'do not overlap', mu2 < 1)), '.'

  ! The point where the spheroids touch when they are scaled by mu, from the centre of
  ! either. The second output of this function, the normal, may be left out.
  call check(pw85_contact_geometry(r12, q1, q2, lambda, point))
  from1 = point
  from2 = point - r12

  ! Scaling by mu multiplies the forms by mu**2.
  gradient1 = surface_gradient(mu2 * q1, from1)
  gradient2 = surface_gradient(mu2 * q2, from2)
  print '(a)', 'contact point = ' // text(x1 + point)
  print '(a, f12.10)', 'on spheroid 1, scaled: ', dot_product(from1, gradient1)
  print '(a, f12.10)', 'on spheroid 2, scaled: ', dot_product(from2, gradient2)
  print '(a)', 'normal to spheroid 1 = ' // text(gradient1 / norm2(gradient1))
  print '(a)', 'normal to spheroid 2 = ' // text(gradient2 / norm2(gradient2))

contains

  subroutine check(status)
    integer, intent(in) :: status
    if (status == pw85_success) return
    write (error_unit, '(a)') pw85_strerror(status)
    error stop 1
  end subroutine check

  !> The gradient of (m - c)^T Q^-1 (m - c), which is 1 on the surface of the ellipsoid,
  !> over 2, for x = m - c.
  function surface_gradient(q, x) result(gradient)
    real(c_double), intent(in) :: q(6), x(3)
    real(c_double) :: gradient(3), l(6)
    call pw85__cholesky_decomp(q, l)
    call pw85__cholesky_solve(l, x, gradient)
  end function surface_gradient

  !> (x, y, z) with six decimals.
  function text(x)
    real(c_double), intent(in) :: x(3)
    character(:), allocatable :: text
    character(16) :: numbers(3)
    write (numbers, '(f16.6)') x
    text = '(' // trim(adjustl(numbers(1))) // ', ' // &
      trim(adjustl(numbers(2))) // ', ' // &
           trim(adjustl(numbers(3))) // ')'
  end function text

end program tutorial
