! Two ellipsoids: the contact function, the distance, and where they are closest.
program pair
  use pw85
  implicit none
  integer, parameter :: dp = kind(1d0)
  real(dp), parameter :: r12(3) = [3, 2, 1] ! from the first centre to the second
  real(dp), parameter :: axes1(3) = [3, 2, 1], turn1(4) = [1, 0, 0, 0]
  real(dp), parameter :: axes2(3) = [4, 1, 1]
  real(dp), parameter :: turn2(4) = [0.9_dp, 0.1_dp, 0.3_dp, 0.2_dp] ! w, x, y, z
  real(dp) :: q1(6), q2(6), out(2), distance, p1(3)
  integer :: status

  status = pw85_ellipsoid_quaternion(axes1, turn1, q1)
  status = pw85_ellipsoid_quaternion(axes2, turn2, q2)
  status = pw85_contact(r12, q1, q2, out)
  if (status == pw85_success) status = pw85_distance(r12, q1, q2, distance, p1)
  if (status /= pw85_success) then
    print '(a)', pw85_strerror(status)
    error stop
  end if
  print '(a, f7.5, 2a)', 'mu^2 = ', out(1), ': ', &
    trim(merge('overlap', 'apart  ', out(1) < 1))
  print '(a, f7.5, 3(a, f6.4), a)', 'distance = ', distance, ', from (', p1(1), ', ', &
    p1(2), ', ', p1(3), ')'
end program pair
