!> Which of a thousand grains in a periodic cell overlap, and the normals of contacts:
!> a neighbour list, exact overlap tests, and the contact function of its pairs.
program grains
  use, intrinsic :: iso_c_binding, only: c_double, c_f_pointer, c_int8_t, c_int32_t, &
    c_int64_t, c_loc, c_ptr, c_size_t
  use, intrinsic :: iso_fortran_env, only: error_unit
  use pw85
  implicit none
  integer, parameter :: n = 1000
  real(c_double), parameter :: semi_axes(3) = [0.5_c_double, 0.7_c_double, 1.1_c_double]

  ! The library reads the arrays of a system by their addresses: they must be targets.
  real(c_double), target :: centers(3, n), q(6, n), cell(3, 3)
  type(pw85_system) :: system
  type(c_ptr) :: neighbors
  type(pw85_pair_list) :: list
  integer(c_int32_t), pointer :: pairs(:, :)
  integer(c_int8_t), allocatable :: overlap(:)
  real(c_double), allocatable :: mu2(:), normals(:, :)
  real(c_double) :: quaternion(4)
  integer(c_int64_t) :: state = 1
  integer :: i, k, deepest

  do i = 1, n
    do k = 1, 3
      centers(k, i) = 20 * uniform()
    end do
    do k = 1, 4
      quaternion(k) = uniform() - 0.5_c_double
    end do
    call check(pw85_ellipsoid_quaternion(semi_axes, quaternion, q(:, i)))
  end do
  cell = 0
  do k = 1, 3
    cell(k, k) = 20 ! column k is vector k
  end do

  system = pw85_system(int(n, c_size_t), c_loc(centers), c_loc(q), c_loc(cell), &
    periodic=[1, 1, 1])
  call check(pw85_neighbors_create(system, 1.0_c_double, 0.0_c_double, neighbors))
  ! The arrays of the list are valid until pw85_neighbors_destroy(). Indices begin at 0.
  list = pw85_neighbors_list(neighbors)
  call c_f_pointer(list%pairs, pairs, [2, int(list%num_pairs)])
  allocate (overlap(list%num_pairs), mu2(list%num_pairs), normals(3, list%num_pairs))
  call check(pw85_overlap_pairs(list, system, overlap))
  call check(pw85_contact_derivatives_pairs(list, system, mu2, normal=normals))

  deepest = minloc(mu2, 1)
  print '(i0, a, i0, a)', list%num_pairs, ' pairs of boxes intersect, ', &
    count(overlap == 1), ' pairs of grains overlap'
  print '(a, f8.6, 2(a, i0))', 'smallest mu^2 = ', mu2(deepest), ', grains ', &
    pairs(1, deepest), ' and ', pairs(2, deepest)
  print '(a, 2(f7.4, a), f6.4, a)', 'normal there: (', normals(1, deepest), ', ', &
    normals(2, deepest), ', ', normals(3, deepest), ')'
  call pw85_neighbors_destroy(neighbors)

contains

  !> Numbers in [0, 1) that are the same everywhere.
  real(c_double) function uniform()
    state = modulo(1664525_c_int64_t * state + 1013904223_c_int64_t, 2_c_int64_t**32)
    uniform = state / 4294967296.0_c_double
  end function uniform

  subroutine check(status)
    integer, intent(in) :: status
    if (status == pw85_success) return
    write (error_unit, '(a)') pw85_strerror(status)
    error stop 1
  end subroutine check
end program grains
