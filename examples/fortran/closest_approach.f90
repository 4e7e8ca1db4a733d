!> How near can two rod-like molecules of length 3 and width 1 come, side by side,
!> crossed, as a T and end to end? The distance of the centres, through the contact
!> function and by the algorithm of Zheng et al.
program closest_approach
  use, intrinsic :: iso_c_binding, only: c_double
  use pw85, only: pw85_closest_approach, pw85_spheroid, pw85_success, &
    pw85_zheng_ellipsoids
  implicit none

  real(c_double), parameter :: x(3) = [1.0_c_double, 0.0_c_double, 0.0_c_double]
  real(c_double), parameter :: y(3) = [0.0_c_double, 1.0_c_double, 0.0_c_double]
  real(c_double), parameter :: z(3) = [0.0_c_double, 0.0_c_double, 1.0_c_double]

  print '(a)', 'arrangement     distance     Zheng et al.'
  call compare('side by side', z, z)
  call compare('crossed', z, y)
  call compare('T', z, x)
  call compare('end to end', x, x)
  call compare('oblique', x + z, x - y)

contains

  !> Molecules with the given axes, the second in the direction x from the first.
  subroutine compare(arrangement, axis1, axis2)
    character(*), intent(in) :: arrangement
    real(c_double), intent(in) :: axis1(3), axis2(3)
    real(c_double) :: q1(6), q2(6), distance, zheng
    call pw85_spheroid(0.5_c_double, 1.5_c_double, axis1, q1)
    call pw85_spheroid(0.5_c_double, 1.5_c_double, axis2, q2)
    if (pw85_closest_approach(x, q1, q2, distance) /= pw85_success) error stop 1
    if (pw85_zheng_ellipsoids(x, q1, q2, zheng) /= pw85_success) error stop 1
    print '(a12, 2f15.10)', adjustl(arrangement // '            '), distance, zheng
  end subroutine compare

end program closest_approach
