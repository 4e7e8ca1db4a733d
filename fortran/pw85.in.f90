! SPDX-License-Identifier: BSD-3-Clause
!> The contact function of Perram and Wertheim for two ellipsoids: the C API of pw85.h,
!> pw85_legacy.h and pw85_zheng.h.
!>
!> Those headers say what each function computes, in which units, and which statuses it returns.
!> Names and order of arguments are the same here. Vectors are real(c_double) arrays of 3 numbers,
!> symmetric matrices of 6: (xx, xy, xz, yy, yz, zz); 2 and 3 in two dimensions. Where C has rows of
!> numbers, Fortran has columns: r12(:, i), q1(:, i) and pairs(:, i) belong to pair i, cell(:, k) is
!> vector k of the periodic cell. Indices of particles count from 0, as in C. Numbers of pairs are
!> integer(c_size_t).
!>
!> Functions return a status, pw85_success or another of the codes below. When the status is not
!> pw85_success, all outputs are NaN. Arguments that may be null in C are optional here; name the
!> arguments that follow one that is left out.
!>
!> Compile with a compiler of Fortran 2018 (its optional arguments of C functions), and link with
!> pw85; with pw85_legacy too if functions of pw85_legacy.h or pw85_zheng.h are called.
module pw85
  use, intrinsic :: iso_c_binding, only: c_char, c_double, c_f_pointer, c_int, c_int8_t, &
    c_int32_t, c_int64_t, c_funptr, c_null_ptr, c_ptr, c_size_t
  implicit none
  private

  !> The version of this module (pw85_version() is that of the library), constants of the headers,
  !> and statuses.
  !@ constants

  !> How an ellipsoid moves: at time t its semi-axes are 1 + growth*t times those at time 0.
  type, bind(C), public :: pw85_motion
    real(c_double) :: velocity(3) = 0
    real(c_double) :: angular_velocity(3) = 0
    real(c_double) :: growth = 0
  end type pw85_motion

  !> Particles, in a periodic cell or not: pw85_system(n, c_loc(centers), c_loc(q), c_loc(cell)) of
  !> arrays that are targets.
  type, bind(C), public :: pw85_system
    integer(c_size_t) :: num_particles = 0
    type(c_ptr) :: centers = c_null_ptr !< of 3 x num_particles numbers
    type(c_ptr) :: q = c_null_ptr !< of 6 x num_particles numbers
    type(c_ptr) :: cell = c_null_ptr !< of 3 x 3 numbers, or null if nothing is periodic
    !> not 0 for each vector of the cell along which there are images
    integer(c_int) :: periodic(3) = 1
  end type pw85_system

  !> Pairs of particles: pw85_pair_list(n, c_loc(pairs)) or pw85_pair_list(n, c_loc(pairs),
  !> c_loc(images)) of arrays that are targets.
  type, bind(C), public :: pw85_pair_list
    integer(c_size_t) :: num_pairs = 0
    type(c_ptr) :: pairs = c_null_ptr !< of 2 x num_pairs indices
    !> of 3 x num_pairs multiples of the cell's vectors, or null for the nearest images
    type(c_ptr) :: images = c_null_ptr
  end type pw85_pair_list

  !> The energy of a pair: pw85_law(pw85_law_soft_repulsion, 2_c_size_t, c_loc(parameters)) of an
  !> array that is a target.
  type, bind(C), public :: pw85_law
    integer(c_int) :: kind = 0
    integer(c_size_t) :: num_parameters = 0
    type(c_ptr) :: parameters = c_null_ptr !< of num_parameters numbers
  end type pw85_law

  !> A hard wall of a simulation: see pw85_hard_ellipsoids_set_walls().
  type, bind(C), public :: pw85_wall
    integer(c_int) :: kind = 0
    real(c_double) :: point(3) = 0
    real(c_double) :: vector(3) = 0
    real(c_double) :: size = 0
  end type pw85_wall

  !> A field that acts on each particle of a simulation: see pw85_hard_ellipsoids_set_fields().
  type, bind(C), public :: pw85_field
    integer(c_int) :: kind = 0
    integer(c_int) :: axis = 0
    real(c_double) :: point(3) = 0
    real(c_double) :: vector(3) = 0
    real(c_double) :: strength = 1
  end type pw85_field

  !@ names

  !@ interfaces

  !> Two ellipsoids in n dimensions, from 1 to 16: the C API of pw85_any_dimension.h. Vectors have n
  !> numbers, forms n (n + 1)/2.
  public :: pw85_nd_contact
  public :: pw85_nd_contact_geometry
  public :: pw85_nd_overlap
  public :: pw85_nd_compare
  public :: pw85_nd_contact_batch
  public :: pw85_nd_contact_geometry_batch
  public :: pw85_nd_overlap_batch
  public :: pw85_nd_compare_batch
  public :: pw85_nd_contains
  public :: pw85_nd_contains_batch
  public :: pw85_nd_containment
  public :: pw85_nd_containment_batch
  public :: pw85_nd_distance
  public :: pw85_nd_distance_batch

  interface
    function pw85_nd_contact(n, r12, q1, q2, out) &
      result(status) bind(C, name='pw85_nd_contact')
      import
      integer(c_int), value :: n
      real(c_double), intent(in) :: r12(*), q1(*), q2(*)
      real(c_double), intent(out) :: out(2)
      integer(c_int) :: status
    end function pw85_nd_contact

    function pw85_nd_contact_geometry(n, r12, q1, q2, lambda, point, normal, d_r12, &
      d_q1, d_q2) &
      result(status) bind(C, name='pw85_nd_contact_geometry')
      import
      integer(c_int), value :: n
      real(c_double), intent(in) :: r12(*), q1(*), q2(*)
      real(c_double), value :: lambda
      real(c_double), intent(out), optional :: point(*), normal(*), d_r12(*), d_q1(*), d_q2(*)
      integer(c_int) :: status
    end function pw85_nd_contact_geometry

    function pw85_nd_overlap(n, r12, q1, q2, overlap) &
      result(status) bind(C, name='pw85_nd_overlap')
      import
      integer(c_int), value :: n
      real(c_double), intent(in) :: r12(*), q1(*), q2(*)
      integer(c_int), intent(out) :: overlap
      integer(c_int) :: status
    end function pw85_nd_overlap

    function pw85_nd_compare(n, r12, q1, q2, mu2, sign) &
      result(status) bind(C, name='pw85_nd_compare')
      import
      integer(c_int), value :: n
      real(c_double), intent(in) :: r12(*), q1(*), q2(*)
      real(c_double), value :: mu2
      integer(c_int), intent(out) :: sign
      integer(c_int) :: status
    end function pw85_nd_compare

    function pw85_nd_contact_batch(num_pairs, n, r12, q1, q2, mu2, lambda) &
      result(status) bind(C, name='pw85_nd_contact_batch')
      import
      integer(c_size_t), value :: num_pairs
      integer(c_int), value :: n
      real(c_double), intent(in) :: r12(*), q1(*), q2(*)
      real(c_double), intent(out) :: mu2(*)
      real(c_double), intent(out), optional :: lambda(*)
      integer(c_int) :: status
    end function pw85_nd_contact_batch

    function pw85_nd_contact_geometry_batch(num_pairs, n, r12, q1, q2, lambda, point, &
      normal, d_r12, d_q1, d_q2) &
      result(status) bind(C, name='pw85_nd_contact_geometry_batch')
      import
      integer(c_size_t), value :: num_pairs
      integer(c_int), value :: n
      real(c_double), intent(in) :: r12(*), q1(*), q2(*)
      real(c_double), intent(in) :: lambda(*)
      real(c_double), intent(out), optional :: point(*), normal(*), d_r12(*), d_q1(*), d_q2(*)
      integer(c_int) :: status
    end function pw85_nd_contact_geometry_batch

    function pw85_nd_overlap_batch(num_pairs, n, r12, q1, q2, overlap) &
      result(status) bind(C, name='pw85_nd_overlap_batch')
      import
      integer(c_size_t), value :: num_pairs
      integer(c_int), value :: n
      real(c_double), intent(in) :: r12(*), q1(*), q2(*)
      integer(c_int8_t), intent(out) :: overlap(*)
      integer(c_int) :: status
    end function pw85_nd_overlap_batch

    function pw85_nd_compare_batch(num_pairs, n, r12, q1, q2, mu2, sign) &
      result(status) bind(C, name='pw85_nd_compare_batch')
      import
      integer(c_size_t), value :: num_pairs
      integer(c_int), value :: n
      real(c_double), intent(in) :: r12(*), q1(*), q2(*), mu2(*)
      integer(c_int), intent(out) :: sign(*)
      integer(c_int) :: status
    end function pw85_nd_compare_batch

    function pw85_nd_contains(n, r12, q1, q2, contains) &
      result(status) bind(C, name='pw85_nd_contains')
      import
      integer(c_int), value :: n
      real(c_double), intent(in) :: r12(*), q1(*), q2(*)
      integer(c_int), intent(out) :: contains
      integer(c_int) :: status
    end function pw85_nd_contains

    function pw85_nd_contains_batch(num_pairs, n, r12, q1, q2, contains) &
      result(status) bind(C, name='pw85_nd_contains_batch')
      import
      integer(c_size_t), value :: num_pairs
      integer(c_int), value :: n
      real(c_double), intent(in) :: r12(*), q1(*), q2(*)
      integer(c_int8_t), intent(out) :: contains(*)
      integer(c_int) :: status
    end function pw85_nd_contains_batch

    function pw85_nd_containment(n, r12, q1, q2, mu2, point) &
      result(status) bind(C, name='pw85_nd_containment')
      import
      integer(c_int), value :: n
      real(c_double), intent(in) :: r12(*), q1(*), q2(*)
      real(c_double), intent(out), optional :: mu2, point(*)
      integer(c_int) :: status
    end function pw85_nd_containment

    function pw85_nd_containment_batch(num_pairs, n, r12, q1, q2, mu2, point) &
      result(status) bind(C, name='pw85_nd_containment_batch')
      import
      integer(c_size_t), value :: num_pairs
      integer(c_int), value :: n
      real(c_double), intent(in) :: r12(*), q1(*), q2(*)
      real(c_double), intent(out), optional :: mu2(*), point(*)
      integer(c_int) :: status
    end function pw85_nd_containment_batch

    function pw85_nd_distance(n, r12, q1, q2, distance, point1, point2, normal) &
      result(status) bind(C, name='pw85_nd_distance')
      import
      integer(c_int), value :: n
      real(c_double), intent(in) :: r12(*), q1(*), q2(*)
      real(c_double), intent(out), optional :: distance, point1(*), point2(*), normal(*)
      integer(c_int) :: status
    end function pw85_nd_distance

    function pw85_nd_distance_batch(num_pairs, n, r12, q1, q2, distance, point1, point2, &
      normal) &
      result(status) bind(C, name='pw85_nd_distance_batch')
      import
      integer(c_size_t), value :: num_pairs
      integer(c_int), value :: n
      real(c_double), intent(in) :: r12(*), q1(*), q2(*)
      real(c_double), intent(out), optional :: distance(*), point1(*), point2(*), normal(*)
      integer(c_int) :: status
    end function pw85_nd_distance_batch
  end interface

  ! The C library.
  interface
    function c_strlen(text) result(length) bind(C, name='strlen')
      import
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

  !> Quadratic form of a general ellipsoid; rotation(:, k) is the direction of semi_axes(k).
  function pw85_ellipsoid(semi_axes, rotation, q) result(status)
    real(c_double), intent(in) :: semi_axes(3), rotation(3, 3)
    real(c_double), intent(out) :: q(6)
    integer(c_int) :: status
    status = c_ellipsoid(semi_axes, transpose(rotation), q)
  end function pw85_ellipsoid

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
