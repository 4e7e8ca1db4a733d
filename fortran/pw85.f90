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
  integer(c_int), parameter, public :: pw85_version_major = 3
  integer(c_int), parameter, public :: pw85_version_minor = 1
  integer(c_int), parameter, public :: pw85_version_patch = 0
  integer(c_int), parameter, public :: pw85_dim = 3
  integer(c_int), parameter, public :: pw85_sym = 6
  real(c_double), parameter, public :: pw85_lambda_atol = 1e-6_c_double
  integer(c_int), parameter, public :: pw85_max_iter = 25
  integer(c_int), parameter, public :: pw85_nr_iter = 3
  integer(c_int), parameter, public :: pw85_law_soft_repulsion = 1
  integer(c_int), parameter, public :: pw85_law_inverse_powers = 2
  integer(c_int), parameter, public :: pw85_law_table = 3
  integer(c_int), parameter, public :: pw85_wall_plane = 0
  integer(c_int), parameter, public :: pw85_wall_sphere = 1
  integer(c_int), parameter, public :: pw85_wall_cylinder = 2
  integer(c_int), parameter, public :: pw85_wall_box = 3
  integer(c_int), parameter, public :: pw85_field_linear = 0
  integer(c_int), parameter, public :: pw85_field_weight = 1
  integer(c_int), parameter, public :: pw85_field_harmonic = 2
  integer(c_int), parameter, public :: pw85_field_aligning = 3
  integer(c_int), parameter, public :: pw85_change_isotropic = 0
  integer(c_int), parameter, public :: pw85_change_axis = 1
  integer(c_int), parameter, public :: pw85_change_triclinic = 2
  integer(c_int), parameter, public :: pw85_change_aspect = 3
  integer(c_int), parameter, public :: pw85_addition_continues = 0
  integer(c_int), parameter, public :: pw85_addition_saturated = 1
  integer(c_int), parameter, public :: pw85_addition_attempts = 2
  integer(c_int), parameter, public :: pw85_addition_particles = 3
  integer(c_int), parameter, public :: pw85_success = 0
  integer(c_int), parameter, public :: pw85_einval = 1
  integer(c_int), parameter, public :: pw85_enotpd = 2
  integer(c_int), parameter, public :: pw85_econvergence = 3
  integer(c_int), parameter, public :: pw85_enomem = 4
  integer(c_int), parameter, public :: pw85_edevice = 5
  integer(c_int), parameter, public :: pw85_eoverlap = 6
  integer(c_int), parameter, public :: pw85_epotential = 7

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

  public :: pw85_version
  public :: pw85_strerror
  public :: pw85_set_reproducible
  public :: pw85_is_reproducible
  public :: pw85_spheroid
  public :: pw85_ellipsoid
  public :: pw85_ellipsoid_quaternion
  public :: pw85_ellipsoid_factor
  public :: pw85_ellipse
  public :: pw85_contact
  public :: pw85_contact_rounded
  public :: pw85_contact_factored
  public :: pw85_condition
  public :: pw85_contact_function
  public :: pw85_contact_geometry
  public :: pw85_contact_geometry_factored
  public :: pw85_contact_gradient
  public :: pw85_contact_gradient_factored
  public :: pw85_contact_torque
  public :: pw85_contact_hessian
  public :: pw85_overlap
  public :: pw85_overlap_factored
  public :: pw85_compare
  public :: pw85_overlap_witness
  public :: pw85_contains
  public :: pw85_containment
  public :: pw85_closest_approach
  public :: pw85_volume
  public :: pw85_overlap_volume
  public :: pw85_overlap_volume_gradient
  public :: pw85_overlap_volume_torque
  public :: pw85_area_2d
  public :: pw85_overlap_area_2d
  public :: pw85_overlap_area_gradient_2d
  public :: pw85_overlap_area_torque_2d
  public :: pw85_contact_2d
  public :: pw85_contact_geometry_2d
  public :: pw85_contact_gradient_2d
  public :: pw85_contact_torque_2d
  public :: pw85_contact_hessian_2d
  public :: pw85_overlap_2d
  public :: pw85_contains_2d
  public :: pw85_containment_2d
  public :: pw85_closest_approach_2d
  public :: pw85_distance
  public :: pw85_distance_geometry
  public :: pw85_distance_derivatives
  public :: pw85_penetration
  public :: pw85_signed_distance
  public :: pw85_signed_distance_geometry
  public :: pw85_signed_distance_derivatives
  public :: pw85_gap_inside
  public :: pw85_distance_2d
  public :: pw85_distance_geometry_2d
  public :: pw85_penetration_2d
  public :: pw85_signed_distance_2d
  public :: pw85_signed_distance_geometry_2d
  public :: pw85_gap_inside_2d
  public :: pw85_first_contact
  public :: pw85_closest_passage
  public :: pw85_free_path
  public :: pw85__cholesky_decomp
  public :: pw85__cholesky_solve
  public :: pw85__residual
  public :: pw85_f_neg
  public :: pw85_curvature
  public :: pw85_hertz
  public :: pw85_hertz_contact
  public :: pw85_grain_contact
  public :: pw85_grain_radius_gradient
  public :: pw85_grain_contact_wall
  public :: pw85_surface_area
  public :: pw85_second_moments
  public :: pw85_from_moments
  public :: pw85_shell_moments
  public :: pw85_inertia
  public :: pw85_perimeter_2d
  public :: pw85_second_moments_2d
  public :: pw85_from_moments_2d
  public :: pw85_shell_moments_2d
  public :: pw85_distance_plane
  public :: pw85_distance_plane_derivatives
  public :: pw85_contact_plane
  public :: pw85_contact_plane_derivatives
  public :: pw85_distance_box
  public :: pw85_distance_cylinder
  public :: pw85_distance_point
  public :: pw85_intersect_line
  public :: pw85_overlap_volume_plane
  public :: pw85_contact_segment
  public :: pw85_contact_triangle
  public :: pw85_contact_box
  public :: pw85_contact_polytope
  public :: pw85_overlap_segment
  public :: pw85_overlap_triangle
  public :: pw85_overlap_box
  public :: pw85_overlap_polytope
  public :: pw85_distance_segment
  public :: pw85_distance_triangle
  public :: pw85_distance_solid_box
  public :: pw85_contact_capsule
  public :: pw85_overlap_capsule
  public :: pw85_distance_capsule
  public :: pw85_distance_point_2d
  public :: pw85_contact_segment_2d
  public :: pw85_contact_box_2d
  public :: pw85_overlap_segment_2d
  public :: pw85_overlap_box_2d
  public :: pw85_ellipsoid_quaternion_batch
  public :: pw85_ellipsoid_factor_batch
  public :: pw85_contact_batch
  public :: pw85_contact_rounded_batch
  public :: pw85_contact_factored_batch
  public :: pw85_condition_batch
  public :: pw85_contact_function_batch
  public :: pw85_contact_geometry_batch
  public :: pw85_contact_geometry_factored_batch
  public :: pw85_contact_gradient_batch
  public :: pw85_contact_gradient_factored_batch
  public :: pw85_contact_torque_batch
  public :: pw85_contact_hessian_batch
  public :: pw85_overlap_batch
  public :: pw85_overlap_factored_batch
  public :: pw85_compare_batch
  public :: pw85_overlap_witness_batch
  public :: pw85_contains_batch
  public :: pw85_containment_batch
  public :: pw85_closest_approach_batch
  public :: pw85_volume_batch
  public :: pw85_overlap_volume_batch
  public :: pw85_overlap_volume_gradient_batch
  public :: pw85_overlap_volume_torque_batch
  public :: pw85_area_batch_2d
  public :: pw85_overlap_area_batch_2d
  public :: pw85_overlap_area_gradient_batch_2d
  public :: pw85_overlap_area_torque_batch_2d
  public :: pw85_contact_batch_2d
  public :: pw85_contact_geometry_batch_2d
  public :: pw85_contact_gradient_batch_2d
  public :: pw85_contact_torque_batch_2d
  public :: pw85_contact_hessian_batch_2d
  public :: pw85_overlap_batch_2d
  public :: pw85_closest_approach_batch_2d
  public :: pw85_distance_batch
  public :: pw85_distance_geometry_batch
  public :: pw85_distance_derivatives_batch
  public :: pw85_penetration_batch
  public :: pw85_signed_distance_batch
  public :: pw85_signed_distance_geometry_batch
  public :: pw85_signed_distance_derivatives_batch
  public :: pw85_gap_inside_batch
  public :: pw85_distance_batch_2d
  public :: pw85_distance_geometry_batch_2d
  public :: pw85_penetration_batch_2d
  public :: pw85_signed_distance_batch_2d
  public :: pw85_signed_distance_geometry_batch_2d
  public :: pw85_gap_inside_batch_2d
  public :: pw85_first_contact_batch
  public :: pw85_closest_passage_batch
  public :: pw85_free_path_batch
  public :: pw85_curvature_batch
  public :: pw85_hertz_batch
  public :: pw85_hertz_contact_batch
  public :: pw85_grain_contact_batch
  public :: pw85_grain_radius_gradient_batch
  public :: pw85_grain_contact_wall_batch
  public :: pw85_surface_area_batch
  public :: pw85_second_moments_batch
  public :: pw85_from_moments_batch
  public :: pw85_shell_moments_batch
  public :: pw85_inertia_batch
  public :: pw85_perimeter_batch_2d
  public :: pw85_second_moments_batch_2d
  public :: pw85_from_moments_batch_2d
  public :: pw85_shell_moments_batch_2d
  public :: pw85_distance_plane_batch
  public :: pw85_distance_plane_derivatives_batch
  public :: pw85_contact_plane_batch
  public :: pw85_contact_plane_derivatives_batch
  public :: pw85_distance_box_batch
  public :: pw85_distance_cylinder_batch
  public :: pw85_distance_point_batch
  public :: pw85_intersect_line_batch
  public :: pw85_overlap_volume_plane_batch
  public :: pw85_contact_segment_batch
  public :: pw85_contact_triangle_batch
  public :: pw85_contact_box_batch
  public :: pw85_overlap_segment_batch
  public :: pw85_overlap_triangle_batch
  public :: pw85_overlap_box_batch
  public :: pw85_distance_segment_batch
  public :: pw85_distance_triangle_batch
  public :: pw85_distance_solid_box_batch
  public :: pw85_contact_capsule_batch
  public :: pw85_overlap_capsule_batch
  public :: pw85_distance_capsule_batch
  public :: pw85_distance_point_batch_2d
  public :: pw85_contact_segment_batch_2d
  public :: pw85_contact_box_batch_2d
  public :: pw85_overlap_segment_batch_2d
  public :: pw85_overlap_box_batch_2d
  public :: pw85_contact_derivatives_batch
  public :: pw85_contact_polytope_batch
  public :: pw85_overlap_polytope_batch
  public :: pw85_overlap_any
  public :: pw85_bounding_boxes
  public :: pw85_enclosing_ellipsoid
  public :: pw85_enclosing_ellipsoid_of
  public :: pw85_random_points
  public :: pw85_overlap_any_indices
  public :: pw85_contact_pairs
  public :: pw85_overlap_pairs
  public :: pw85_overlap_volume_pairs
  public :: pw85_contact_derivatives_pairs
  public :: pw85_contact_forces_pairs
  public :: pw85_law_forces_pairs
  public :: pw85_first_contact_pairs
  public :: pw85_cell_reduce
  public :: pw85_nearest_images
  public :: pw85_nearest_image_limit
  public :: pw85_neighbors_create
  public :: pw85_neighbors_check
  public :: pw85_neighbors_holds
  public :: pw85_neighbors_list
  public :: pw85_neighbors_destroy
  public :: pw85_mesh_create
  public :: pw85_mesh_contact
  public :: pw85_mesh_overlap
  public :: pw85_mesh_distance
  public :: pw85_mesh_contact_batch
  public :: pw85_mesh_overlap_batch
  public :: pw85_mesh_distance_batch
  public :: pw85_mesh_destroy
  public :: pw85_hard_ellipsoids_create
  public :: pw85_hard_ellipsoids_set_dimensions
  public :: pw85_hard_ellipsoids_dimensions
  public :: pw85_hard_ellipsoids_destroy
  public :: pw85_hard_ellipsoids_system
  public :: pw85_hard_ellipsoids_quaternions
  public :: pw85_hard_ellipsoids_semi_axes
  public :: pw85_hard_ellipsoids_num_bytes
  public :: pw85_hard_ellipsoids_save
  public :: pw85_hard_ellipsoids_restore
  public :: pw85_hard_ellipsoids_set_walls
  public :: pw85_hard_ellipsoids_set_mesh
  public :: pw85_hard_ellipsoids_set_fields
  public :: pw85_hard_ellipsoids_set_potential
  public :: pw85_hard_ellipsoids_set_law
  public :: pw85_hard_ellipsoids_sweep
  public :: pw85_hard_ellipsoids_chain
  public :: pw85_hard_ellipsoids_volume_moves
  public :: pw85_hard_ellipsoids_tune
  public :: pw85_hard_ellipsoids_set_fractions
  public :: pw85_hard_ellipsoids_set_steps
  public :: pw85_hard_ellipsoids_steps
  public :: pw85_hard_ellipsoids_set_kind_steps
  public :: pw85_hard_ellipsoids_kind_steps
  public :: pw85_hard_ellipsoids_counts
  public :: pw85_hard_ellipsoids_try
  public :: pw85_hard_ellipsoids_insert
  public :: pw85_hard_ellipsoids_remove
  public :: pw85_hard_ellipsoids_insertion_weight
  public :: pw85_hard_ellipsoids_insertion_moves
  public :: pw85_hard_ellipsoids_energy
  public :: pw85_hard_ellipsoids_law_virial
  public :: pw85_hard_ellipsoids_neighbors
  public :: pw85_hard_ellipsoids_check
  public :: pw85_hard_ellipsoids_compress
  public :: pw85_random_addition_create
  public :: pw85_random_addition_advance
  public :: pw85_random_addition_state
  public :: pw85_random_addition_particles
  public :: pw85_random_addition_destroy
  public :: pw85_legacy__det_sym
  public :: pw85_legacy__xt_adja_x
  public :: pw85_legacy__detq_as_poly
  public :: pw85_legacy__rt_adjq_r_as_poly
  public :: pw85_legacy_f1
  public :: pw85_legacy_f2
  public :: pw85_legacy_f2_derivatives
  public :: pw85_legacy_contact_function1
  public :: pw85_legacy_contact_function2
  public :: pw85_zheng_ellipses
  public :: pw85_zheng_ellipsoids

  ! pw85.h
  interface

    function c_version() result(value) bind(C, name='pw85_version')
      import
      type(c_ptr) :: value
    end function c_version

    function c_strerror(status) result(value) bind(C, name='pw85_strerror')
      import
      integer(c_int), value :: status
      type(c_ptr) :: value
    end function c_strerror

    !> Switches the reproducible mode on or off, for all threads of the process.
    function pw85_set_reproducible(on) result(status) bind(C, name='pw85_set_reproducible')
      import
      integer(c_int), value :: on
      integer(c_int) :: status
    end function pw85_set_reproducible

    !> Returns whether the reproducible mode of pw85_set_reproducible() is on.
    function pw85_is_reproducible(on) result(status) bind(C, name='pw85_is_reproducible')
      import
      integer(c_int), intent(out) :: on
      integer(c_int) :: status
    end function pw85_is_reproducible

    !> Computes the quadratic form of a spheroid, Q = a² I + (c² - a²) n nᵀ with |n| = 1.
    subroutine pw85_spheroid(a, c, n, q) bind(C, name='pw85_spheroid')
      import
      real(c_double), value :: a, c
      real(c_double), intent(in) :: n(3)
      real(c_double), intent(out) :: q(6)
    end subroutine pw85_spheroid

    function c_ellipsoid(semi_axes, rotation, q) result(status) bind(C, name='pw85_ellipsoid')
      import
      real(c_double), intent(in) :: semi_axes(3), rotation(3, 3)
      real(c_double), intent(out) :: q(6)
      integer(c_int) :: status
    end function c_ellipsoid

    !> Computes the quadratic form of an ellipsoid whose orientation is a quaternion.
    function pw85_ellipsoid_quaternion(semi_axes, quaternion, q) result(status) bind(C, &
      name='pw85_ellipsoid_quaternion')
      import
      real(c_double), intent(in) :: semi_axes(3), quaternion(4)
      real(c_double), intent(out) :: q(6)
      integer(c_int) :: status
    end function pw85_ellipsoid_quaternion

    !> Computes a factor S of the quadratic form of an ellipsoid, Q = S Sᵀ. Row k in C is s(:, k).
    function pw85_ellipsoid_factor(semi_axes, quaternion, s) result(status) bind(C, &
      name='pw85_ellipsoid_factor')
      import
      real(c_double), intent(in) :: semi_axes(3), quaternion(4)
      real(c_double), intent(out) :: s(3, 3)
      integer(c_int) :: status
    end function pw85_ellipsoid_factor

    !> Computes the quadratic form (xx, xy, yy) of an ellipse.
    function pw85_ellipse(a, b, angle, q) result(status) bind(C, name='pw85_ellipse')
      import
      real(c_double), value :: a, b, angle
      real(c_double), intent(out) :: q(3)
      integer(c_int) :: status
    end function pw85_ellipse

    !> Computes the contact function of two ellipsoids.
    function pw85_contact(r12, q1, q2, out) result(status) bind(C, name='pw85_contact')
      import
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      real(c_double), intent(out) :: out(2)
      integer(c_int) :: status
    end function pw85_contact

    !> Computes the contact function of two ellipsoids, with μ² correctly rounded.
    function pw85_contact_rounded(r12, q1, q2, out) result(status) bind(C, &
      name='pw85_contact_rounded')
      import
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      real(c_double), intent(out) :: out(2)
      integer(c_int) :: status
    end function pw85_contact_rounded

    !> Computes the contact function of two ellipsoids that are given by factors of their forms, Q1
    !> = S1 S1ᵀ and Q2 = S2 S2ᵀ. Row k in C is s1(:, k), s2(:, k).
    function pw85_contact_factored(r12, s1, s2, out) result(status) bind(C, &
      name='pw85_contact_factored')
      import
      real(c_double), intent(in) :: r12(3), s1(3, 3), s2(3, 3)
      real(c_double), intent(out) :: out(2)
      integer(c_int) :: status
    end function pw85_contact_factored

    !> Computes the entrywise condition number of the contact function.
    function pw85_condition(r12, q1, q2, lambda, cond) result(status) bind(C, name='pw85_condition')
      import
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      real(c_double), value :: lambda
      real(c_double), intent(out) :: cond
      integer(c_int) :: status
    end function pw85_condition

    !> Computes the contact function of two ellipsoids as pw85 1.0 did, by Brent's method.
    function pw85_contact_function(r12, q1, q2, out) result(status) bind(C, &
      name='pw85_contact_function')
      import
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      real(c_double), intent(out) :: out(2)
      integer(c_int) :: status
    end function pw85_contact_function

    !> Computes the point at which the ellipsoids, scaled by μ, touch, and their common normal
    !> there.
    function pw85_contact_geometry(r12, q1, q2, lambda, point, normal) result(status) bind(C, &
      name='pw85_contact_geometry')
      import
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      real(c_double), value :: lambda
      real(c_double), intent(out), optional :: point(3), normal(3)
      integer(c_int) :: status
    end function pw85_contact_geometry

    !> Computes the contact point and the normal of ellipsoids that are given by factors of their
    !> forms. Row k in C is s1(:, k), s2(:, k).
    function pw85_contact_geometry_factored(r12, s1, s2, lambda, point, normal) result(status) &
      bind(C, name='pw85_contact_geometry_factored')
      import
      real(c_double), intent(in) :: r12(3), s1(3, 3), s2(3, 3)
      real(c_double), value :: lambda
      real(c_double), intent(out), optional :: point(3), normal(3)
      integer(c_int) :: status
    end function pw85_contact_geometry_factored

    !> Computes the derivatives of μ² with respect to r12 and the forms.
    function pw85_contact_gradient(r12, q1, q2, lambda, d_r12, d_q1, d_q2) result(status) bind(C, &
      name='pw85_contact_gradient')
      import
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      real(c_double), value :: lambda
      real(c_double), intent(out), optional :: d_r12(3), d_q1(6), d_q2(6)
      integer(c_int) :: status
    end function pw85_contact_gradient

    !> Computes the derivatives of μ² for ellipsoids that are given by factors of their forms. Row k
    !> in C is s1(:, k), s2(:, k), d_s1(:, k), d_s2(:, k).
    function pw85_contact_gradient_factored(r12, s1, s2, lambda, d_r12, d_s1, d_s2) result(status) &
      bind(C, name='pw85_contact_gradient_factored')
      import
      real(c_double), intent(in) :: r12(3), s1(3, 3), s2(3, 3)
      real(c_double), value :: lambda
      real(c_double), intent(out), optional :: d_r12(3), d_s1(3, 3), d_s2(3, 3)
      integer(c_int) :: status
    end function pw85_contact_gradient_factored

    !> Computes the derivatives of μ² with respect to rotations of the ellipsoids.
    function pw85_contact_torque(r12, q1, q2, lambda, d_rot1, d_rot2) result(status) bind(C, &
      name='pw85_contact_torque')
      import
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      real(c_double), value :: lambda
      real(c_double), intent(out), optional :: d_rot1(3), d_rot2(3)
      integer(c_int) :: status
    end function pw85_contact_torque

    !> Computes the second derivatives of μ² with respect to r12 and rotations of the ellipsoids.
    !> Row k in C is hessian(:, k).
    function pw85_contact_hessian(r12, q1, q2, lambda, hessian) result(status) bind(C, &
      name='pw85_contact_hessian')
      import
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      real(c_double), value :: lambda
      real(c_double), intent(out) :: hessian(9, 9)
      integer(c_int) :: status
    end function pw85_contact_hessian

    !> Tests whether two ellipsoids overlap, μ² < 1.
    function pw85_overlap(r12, q1, q2, overlap) result(status) bind(C, name='pw85_overlap')
      import
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      integer(c_int), intent(out) :: overlap
      integer(c_int) :: status
    end function pw85_overlap

    !> Tests whether two ellipsoids that are given by factors of their forms overlap, Q1 = S1 S1ᵀ
    !> and Q2 = S2 S2ᵀ. Row k in C is s1(:, k), s2(:, k).
    function pw85_overlap_factored(r12, s1, s2, overlap) result(status) bind(C, &
      name='pw85_overlap_factored')
      import
      real(c_double), intent(in) :: r12(3), s1(3, 3), s2(3, 3)
      integer(c_int), intent(out) :: overlap
      integer(c_int) :: status
    end function pw85_overlap_factored

    !> Compares μ² with a number mu2 >= 0, and returns the sign of μ² - mu2.
    function pw85_compare(r12, q1, q2, mu2, sign) result(status) bind(C, name='pw85_compare')
      import
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      real(c_double), value :: mu2
      integer(c_int), intent(out) :: sign
      integer(c_int) :: status
    end function pw85_compare

    !> Tests whether two ellipsoids overlap, as pw85_overlap() does, and returns a number or a point
    !> that proves the answer.
    function pw85_overlap_witness(r12, q1, q2, overlap, lambda, point) result(status) bind(C, &
      name='pw85_overlap_witness')
      import
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      integer(c_int), intent(out) :: overlap
      real(c_double), intent(out), optional :: lambda, point(3)
      integer(c_int) :: status
    end function pw85_overlap_witness

    !> Tests whether ellipsoid 2 is inside ellipsoid 1.
    function pw85_contains(r12, q1, q2, contains) result(status) bind(C, name='pw85_contains')
      import
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      integer(c_int), intent(out) :: contains
      integer(c_int) :: status
    end function pw85_contains

    !> Computes the least factor by which ellipsoid 1 must be scaled about its centre to contain
    !> ellipsoid 2, and a point where the two then touch.
    function pw85_containment(r12, q1, q2, mu2, point) result(status) bind(C, &
      name='pw85_containment')
      import
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      real(c_double), intent(out), optional :: mu2, point(3)
      integer(c_int) :: status
    end function pw85_containment

    !> Computes the distance of closest approach of two ellipsoids along a direction.
    function pw85_closest_approach(direction, q1, q2, distance) result(status) bind(C, &
      name='pw85_closest_approach')
      import
      real(c_double), intent(in) :: direction(3), q1(6), q2(6)
      real(c_double), intent(out) :: distance
      integer(c_int) :: status
    end function pw85_closest_approach

    !> Computes the volume of an ellipsoid, (4/3)π √det q.
    function pw85_volume(q, volume) result(status) bind(C, name='pw85_volume')
      import
      real(c_double), intent(in) :: q(6)
      real(c_double), intent(out) :: volume
      integer(c_int) :: status
    end function pw85_volume

    !> Computes the volume V of the intersection of two ellipsoids.
    function pw85_overlap_volume(r12, q1, q2, volume) result(status) bind(C, &
      name='pw85_overlap_volume')
      import
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      real(c_double), intent(out) :: volume
      integer(c_int) :: status
    end function pw85_overlap_volume

    !> Computes the derivatives of the volume V of the intersection of two ellipsoids.
    function pw85_overlap_volume_gradient(r12, q1, q2, d_r12, d_q1, d_q2) result(status) bind(C, &
      name='pw85_overlap_volume_gradient')
      import
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      real(c_double), intent(out), optional :: d_r12(3), d_q1(6), d_q2(6)
      integer(c_int) :: status
    end function pw85_overlap_volume_gradient

    !> Computes the derivatives of the volume V of the intersection with respect to rotations of the
    !> ellipsoids.
    function pw85_overlap_volume_torque(r12, q1, q2, d_rot1, d_rot2) result(status) bind(C, &
      name='pw85_overlap_volume_torque')
      import
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      real(c_double), intent(out), optional :: d_rot1(3), d_rot2(3)
      integer(c_int) :: status
    end function pw85_overlap_volume_torque

    !> Computes the area of an ellipse, π √det q.
    function pw85_area_2d(q, area) result(status) bind(C, name='pw85_area_2d')
      import
      real(c_double), intent(in) :: q(3)
      real(c_double), intent(out) :: area
      integer(c_int) :: status
    end function pw85_area_2d

    !> Computes the area of the intersection of two ellipses.
    function pw85_overlap_area_2d(r12, q1, q2, area) result(status) bind(C, &
      name='pw85_overlap_area_2d')
      import
      real(c_double), intent(in) :: r12(2), q1(3), q2(3)
      real(c_double), intent(out) :: area
      integer(c_int) :: status
    end function pw85_overlap_area_2d

    !> Computes the derivatives of the area of the intersection of two ellipses.
    function pw85_overlap_area_gradient_2d(r12, q1, q2, d_r12, d_q1, d_q2) result(status) bind(C, &
      name='pw85_overlap_area_gradient_2d')
      import
      real(c_double), intent(in) :: r12(2), q1(3), q2(3)
      real(c_double), intent(out), optional :: d_r12(2), d_q1(3), d_q2(3)
      integer(c_int) :: status
    end function pw85_overlap_area_gradient_2d

    !> Computes the derivatives of the area of the intersection with respect to the angles of both
    !> ellipses.
    function pw85_overlap_area_torque_2d(r12, q1, q2, d_rot1, d_rot2) result(status) bind(C, &
      name='pw85_overlap_area_torque_2d')
      import
      real(c_double), intent(in) :: r12(2), q1(3), q2(3)
      real(c_double), intent(out), optional :: d_rot1, d_rot2
      integer(c_int) :: status
    end function pw85_overlap_area_torque_2d

    !> Computes the contact function of two ellipses.
    function pw85_contact_2d(r12, q1, q2, out) result(status) bind(C, name='pw85_contact_2d')
      import
      real(c_double), intent(in) :: r12(2), q1(3), q2(3)
      real(c_double), intent(out) :: out(2)
      integer(c_int) :: status
    end function pw85_contact_2d

    !> Computes the point at which the ellipses, scaled by μ, touch, and their common normal there.
    function pw85_contact_geometry_2d(r12, q1, q2, lambda, point, normal) result(status) bind(C, &
      name='pw85_contact_geometry_2d')
      import
      real(c_double), intent(in) :: r12(2), q1(3), q2(3)
      real(c_double), value :: lambda
      real(c_double), intent(out), optional :: point(2), normal(2)
      integer(c_int) :: status
    end function pw85_contact_geometry_2d

    !> Computes the derivatives of μ² of two ellipses.
    function pw85_contact_gradient_2d(r12, q1, q2, lambda, d_r12, d_q1, d_q2) result(status) &
      bind(C, name='pw85_contact_gradient_2d')
      import
      real(c_double), intent(in) :: r12(2), q1(3), q2(3)
      real(c_double), value :: lambda
      real(c_double), intent(out), optional :: d_r12(2), d_q1(3), d_q2(3)
      integer(c_int) :: status
    end function pw85_contact_gradient_2d

    !> Computes the derivatives of μ² with respect to the angles of two ellipses.
    function pw85_contact_torque_2d(r12, q1, q2, lambda, d_rot1, d_rot2) result(status) bind(C, &
      name='pw85_contact_torque_2d')
      import
      real(c_double), intent(in) :: r12(2), q1(3), q2(3)
      real(c_double), value :: lambda
      real(c_double), intent(out), optional :: d_rot1, d_rot2
      integer(c_int) :: status
    end function pw85_contact_torque_2d

    !> Computes the second derivatives of μ² of two ellipses. Row k in C is hessian(:, k).
    function pw85_contact_hessian_2d(r12, q1, q2, lambda, hessian) result(status) bind(C, &
      name='pw85_contact_hessian_2d')
      import
      real(c_double), intent(in) :: r12(2), q1(3), q2(3)
      real(c_double), value :: lambda
      real(c_double), intent(out) :: hessian(4, 4)
      integer(c_int) :: status
    end function pw85_contact_hessian_2d

    !> Tests whether two ellipses overlap.
    function pw85_overlap_2d(r12, q1, q2, overlap) result(status) bind(C, name='pw85_overlap_2d')
      import
      real(c_double), intent(in) :: r12(2), q1(3), q2(3)
      integer(c_int), intent(out) :: overlap
      integer(c_int) :: status
    end function pw85_overlap_2d

    !> Tests whether ellipse 2 is inside ellipse 1.
    function pw85_contains_2d(r12, q1, q2, contains) result(status) bind(C, name='pw85_contains_2d')
      import
      real(c_double), intent(in) :: r12(2), q1(3), q2(3)
      integer(c_int), intent(out) :: contains
      integer(c_int) :: status
    end function pw85_contains_2d

    !> Computes the least factor by which ellipse 1 must be scaled to contain ellipse 2.
    function pw85_containment_2d(r12, q1, q2, mu2, point) result(status) bind(C, &
      name='pw85_containment_2d')
      import
      real(c_double), intent(in) :: r12(2), q1(3), q2(3)
      real(c_double), intent(out), optional :: mu2, point(2)
      integer(c_int) :: status
    end function pw85_containment_2d

    !> Computes the distance of closest approach of two ellipses.
    function pw85_closest_approach_2d(direction, q1, q2, distance) result(status) bind(C, &
      name='pw85_closest_approach_2d')
      import
      real(c_double), intent(in) :: direction(2), q1(3), q2(3)
      real(c_double), intent(out) :: distance
      integer(c_int) :: status
    end function pw85_closest_approach_2d

    !> Computes the distance of the surfaces of two ellipsoids, and the points where they are
    !> closest.
    function pw85_distance(r12, q1, q2, distance, point1, point2) result(status) bind(C, &
      name='pw85_distance')
      import
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      real(c_double), intent(out), optional :: distance, point1(3), point2(3)
      integer(c_int) :: status
    end function pw85_distance

    !> Computes the distance of two ellipsoids, as pw85_distance() does, with the closest points and
    !> the normal there.
    function pw85_distance_geometry(r12, q1, q2, distance, point1, point2, normal) result(status) &
      bind(C, name='pw85_distance_geometry')
      import
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      real(c_double), intent(out), optional :: distance, point1(3), point2(3), normal(3)
      integer(c_int) :: status
    end function pw85_distance_geometry

    !> Computes the derivatives of the distance of two ellipsoids. Row k in C is hessian(:, k).
    function pw85_distance_derivatives(r12, q1, q2, d_r12, d_rot1, d_rot2, hessian) result(status) &
      bind(C, name='pw85_distance_derivatives')
      import
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      real(c_double), intent(out), optional :: d_r12(3), d_rot1(3), d_rot2(3), hessian(9, 9)
      integer(c_int) :: status
    end function pw85_distance_derivatives

    !> Computes the penetration depth of two ellipsoids that overlap, and its direction.
    function pw85_penetration(r12, q1, q2, depth, direction) result(status) bind(C, &
      name='pw85_penetration')
      import
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      real(c_double), intent(out), optional :: depth, direction(3)
      integer(c_int) :: status
    end function pw85_penetration

    !> Computes the signed distance of two ellipsoids, and the points where it is reached.
    function pw85_signed_distance(r12, q1, q2, distance, point1, point2) result(status) bind(C, &
      name='pw85_signed_distance')
      import
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      real(c_double), intent(out), optional :: distance, point1(3), point2(3)
      integer(c_int) :: status
    end function pw85_signed_distance

    !> Computes the signed distance of two ellipsoids, as pw85_signed_distance() does, with the
    !> points where it is reached and the normal there.
    function pw85_signed_distance_geometry(r12, q1, q2, distance, point1, point2, normal) &
      result(status) bind(C, name='pw85_signed_distance_geometry')
      import
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      real(c_double), intent(out), optional :: distance, point1(3), point2(3), normal(3)
      integer(c_int) :: status
    end function pw85_signed_distance_geometry

    !> Computes the derivatives of the signed distance of two ellipsoids. Row k in C is hessian(:,
    !> k).
    function pw85_signed_distance_derivatives(r12, q1, q2, d_r12, d_rot1, d_rot2, hessian) &
      result(status) bind(C, name='pw85_signed_distance_derivatives')
      import
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      real(c_double), intent(out), optional :: d_r12(3), d_rot1(3), d_rot2(3), hessian(9, 9)
      integer(c_int) :: status
    end function pw85_signed_distance_derivatives

    !> Computes the least gap between the surface of ellipsoid 1 and an ellipsoid 2 inside it.
    function pw85_gap_inside(r12, q1, q2, gap, point1, point2, normal) result(status) bind(C, &
      name='pw85_gap_inside')
      import
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      real(c_double), intent(out), optional :: gap, point1(3), point2(3), normal(3)
      integer(c_int) :: status
    end function pw85_gap_inside

    !> Computes the distance of two ellipses.
    function pw85_distance_2d(r12, q1, q2, distance, point1, point2) result(status) bind(C, &
      name='pw85_distance_2d')
      import
      real(c_double), intent(in) :: r12(2), q1(3), q2(3)
      real(c_double), intent(out), optional :: distance, point1(2), point2(2)
      integer(c_int) :: status
    end function pw85_distance_2d

    !> Computes the distance of two ellipses with the closest points and the normal.
    function pw85_distance_geometry_2d(r12, q1, q2, distance, point1, point2, normal) &
      result(status) bind(C, name='pw85_distance_geometry_2d')
      import
      real(c_double), intent(in) :: r12(2), q1(3), q2(3)
      real(c_double), intent(out), optional :: distance, point1(2), point2(2), normal(2)
      integer(c_int) :: status
    end function pw85_distance_geometry_2d

    !> Computes the penetration depth of two ellipses.
    function pw85_penetration_2d(r12, q1, q2, depth, direction) result(status) bind(C, &
      name='pw85_penetration_2d')
      import
      real(c_double), intent(in) :: r12(2), q1(3), q2(3)
      real(c_double), intent(out), optional :: depth, direction(2)
      integer(c_int) :: status
    end function pw85_penetration_2d

    !> Computes the signed distance of two ellipses.
    function pw85_signed_distance_2d(r12, q1, q2, distance, point1, point2) result(status) bind(C, &
      name='pw85_signed_distance_2d')
      import
      real(c_double), intent(in) :: r12(2), q1(3), q2(3)
      real(c_double), intent(out), optional :: distance, point1(2), point2(2)
      integer(c_int) :: status
    end function pw85_signed_distance_2d

    !> Computes the signed distance of two ellipses with the points where it is reached and the
    !> normal.
    function pw85_signed_distance_geometry_2d(r12, q1, q2, distance, point1, point2, normal) &
      result(status) bind(C, name='pw85_signed_distance_geometry_2d')
      import
      real(c_double), intent(in) :: r12(2), q1(3), q2(3)
      real(c_double), intent(out), optional :: distance, point1(2), point2(2), normal(2)
      integer(c_int) :: status
    end function pw85_signed_distance_geometry_2d

    !> Computes the least gap of ellipse 2 inside ellipse 1.
    function pw85_gap_inside_2d(r12, q1, q2, gap, point1, point2, normal) result(status) bind(C, &
      name='pw85_gap_inside_2d')
      import
      real(c_double), intent(in) :: r12(2), q1(3), q2(3)
      real(c_double), intent(out), optional :: gap, point1(2), point2(2), normal(2)
      integer(c_int) :: status
    end function pw85_gap_inside_2d

    !> Computes the time of the first contact of two moving ellipsoids.
    function pw85_first_contact(r12, q1, q2, motion1, motion2, t_max, t) result(status) bind(C, &
      name='pw85_first_contact')
      import
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      type(pw85_motion), intent(in) :: motion1, motion2
      real(c_double), value :: t_max
      real(c_double), intent(out) :: t
      integer(c_int) :: status
    end function pw85_first_contact

    !> Computes the least μ² while ellipsoid 2 translates past ellipsoid 1 on a straight path, and
    !> the time of this minimum.
    function pw85_closest_passage(r12, q1, q2, velocity, t_max, mu2, t) result(status) bind(C, &
      name='pw85_closest_passage')
      import
      real(c_double), intent(in) :: r12(3), q1(6), q2(6), velocity(3)
      real(c_double), value :: t_max
      real(c_double), intent(out), optional :: mu2, t
      integer(c_int) :: status
    end function pw85_closest_passage

    !> Computes the free path of ellipsoid 1.
    function pw85_free_path(r12, q1, q2, direction, t_max, t) result(status) bind(C, &
      name='pw85_free_path')
      import
      real(c_double), intent(in) :: r12(3), q1(6), q2(6), direction(3)
      real(c_double), value :: t_max
      real(c_double), intent(out) :: t
      integer(c_int) :: status
    end function pw85_free_path

    !> Computes the Cholesky factorisation A = L Lᵀ.
    subroutine pw85__cholesky_decomp(a, l) bind(C, name='pw85__cholesky_decomp')
      import
      real(c_double), intent(in) :: a(6)
      real(c_double), intent(out) :: l(6)
    end subroutine pw85__cholesky_decomp

    !> Solves L Lᵀ x = b.
    subroutine pw85__cholesky_solve(l, b, x) bind(C, name='pw85__cholesky_solve')
      import
      real(c_double), intent(in) :: l(6), b(3)
      real(c_double), intent(out) :: x(3)
    end subroutine pw85__cholesky_solve

    !> Computes f, the residual g = μ2² - μ1² = -f' and its derivative g'.
    subroutine pw85__residual(lambda, r12, q1, q2, out) bind(C, name='pw85__residual')
      import
      real(c_double), value :: lambda
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      real(c_double), intent(out) :: out(3)
    end subroutine pw85__residual

    !> Computes -f(λ), with all parameters in one array, as the callback of a minimiser.
    function pw85_f_neg(lambda, params) result(value) bind(C, name='pw85_f_neg')
      import
      real(c_double), value :: lambda
      real(c_double), intent(in) :: params(15)
      real(c_double) :: value
    end function pw85_f_neg

  end interface

  ! pw85_grains.h
  interface

    !> Computes the principal curvatures of the surface of an ellipsoid, and their directions, at
    !> the point with a given normal. Row k in C is directions(:, k).
    function pw85_curvature(normal, q, curvatures, directions) result(status) bind(C, &
      name='pw85_curvature')
      import
      real(c_double), intent(in) :: normal(3), q(6)
      real(c_double), intent(out), optional :: curvatures(2), directions(3, 2)
      integer(c_int) :: status
    end function pw85_curvature

    !> Computes the effective radius of Hertz's theory for two elastic bodies, and the shape of the
    !> contact ellipse.
    function pw85_hertz(curvatures, radius, ellipse) result(status) bind(C, name='pw85_hertz')
      import
      real(c_double), intent(in) :: curvatures(2)
      real(c_double), intent(out), optional :: radius, ellipse(2)
      integer(c_int) :: status
    end function pw85_hertz

    !> Computes the geometry of the contact of two grains along a given normal, for laws of contact
    !> such as Hertz's. Row k in C is directions(:, k).
    function pw85_hertz_contact(r12, q1, q2, normal, depth, point, curvatures, directions, radius, &
      ellipse) result(status) bind(C, name='pw85_hertz_contact')
      import
      real(c_double), intent(in) :: r12(3), q1(6), q2(6), normal(3)
      real(c_double), intent(out), optional :: depth, point(3), curvatures(2), directions(3, 2), &
        radius, ellipse(2)
      integer(c_int) :: status
    end function pw85_hertz_contact

    !> Finds the common normal of two grains by Newton's method, and computes their contact along
    !> it.
    function pw85_grain_contact(r12, q1, q2, start, normal, depth, point, curvatures, radius) &
      result(status) bind(C, name='pw85_grain_contact')
      import
      real(c_double), intent(in) :: r12(3), q1(6), q2(6), start(3)
      real(c_double), intent(out), optional :: normal(3), depth, point(3), curvatures(2), radius
      integer(c_int) :: status
    end function pw85_grain_contact

    !> Computes the derivatives of the radius of pw85_grain_contact().
    function pw85_grain_radius_gradient(r12, q1, q2, normal, d_r12, d_rot1, d_rot2) result(status) &
      bind(C, name='pw85_grain_radius_gradient')
      import
      real(c_double), intent(in) :: r12(3), q1(6), q2(6), normal(3)
      real(c_double), intent(out), optional :: d_r12(3), d_rot1(3), d_rot2(3)
      integer(c_int) :: status
    end function pw85_grain_radius_gradient

    !> Computes the contact of a grain with its centre at 0 and a wall.
    function pw85_grain_contact_wall(normal, offset, direction, curvature, q, depth, point, &
      curvatures, radius) result(status) bind(C, name='pw85_grain_contact_wall')
      import
      real(c_double), intent(in) :: normal(3)
      real(c_double), value :: offset
      real(c_double), intent(in) :: direction(3)
      real(c_double), value :: curvature
      real(c_double), intent(in) :: q(6)
      real(c_double), intent(out), optional :: depth, point(3), curvatures(2), radius
      integer(c_int) :: status
    end function pw85_grain_contact_wall

    !> Computes the surface area of an ellipsoid, 4π abc R_G(1/a², 1/b², 1/c²), with Carlson's
    !> integral R_G.
    function pw85_surface_area(q, area) result(status) bind(C, name='pw85_surface_area')
      import
      real(c_double), intent(in) :: q(6)
      real(c_double), intent(out) :: area
      integer(c_int) :: status
    end function pw85_surface_area

    !> Computes the mean of x xᵀ over a uniform solid ellipsoid, about its centre.
    function pw85_second_moments(q, moments) result(status) bind(C, name='pw85_second_moments')
      import
      real(c_double), intent(in) :: q(6)
      real(c_double), intent(out) :: moments(6)
      integer(c_int) :: status
    end function pw85_second_moments

    !> Computes the form of the uniform solid ellipsoid with given second moments.
    function pw85_from_moments(second_moments, q) result(status) bind(C, name='pw85_from_moments')
      import
      real(c_double), intent(in) :: second_moments(6)
      real(c_double), intent(out) :: q(6)
      integer(c_int) :: status
    end function pw85_from_moments

    !> Computes the mean of x xᵀ over the surface of an ellipsoid, about its centre.
    function pw85_shell_moments(q, moments) result(status) bind(C, name='pw85_shell_moments')
      import
      real(c_double), intent(in) :: q(6)
      real(c_double), intent(out) :: moments(6)
      integer(c_int) :: status
    end function pw85_shell_moments

    !> Computes the inertia tensor of a solid body or of a shell of unit density, about its centre.
    function pw85_inertia(q, shell, inertia) result(status) bind(C, name='pw85_inertia')
      import
      real(c_double), intent(in) :: q(6)
      integer(c_int), value :: shell
      real(c_double), intent(out) :: inertia(6)
      integer(c_int) :: status
    end function pw85_inertia

    !> Computes the perimeter of an ellipse, 8 R_G(0, a², b²), with Carlson's integral R_G.
    function pw85_perimeter_2d(q, perimeter) result(status) bind(C, name='pw85_perimeter_2d')
      import
      real(c_double), intent(in) :: q(3)
      real(c_double), intent(out) :: perimeter
      integer(c_int) :: status
    end function pw85_perimeter_2d

    !> Computes the mean of x xᵀ over a uniform ellipse, about its centre.
    function pw85_second_moments_2d(q, moments) result(status) bind(C, &
      name='pw85_second_moments_2d')
      import
      real(c_double), intent(in) :: q(3)
      real(c_double), intent(out) :: moments(3)
      integer(c_int) :: status
    end function pw85_second_moments_2d

    !> Computes the form of the uniform ellipse with given second moments.
    function pw85_from_moments_2d(second_moments, q) result(status) bind(C, &
      name='pw85_from_moments_2d')
      import
      real(c_double), intent(in) :: second_moments(3)
      real(c_double), intent(out) :: q(3)
      integer(c_int) :: status
    end function pw85_from_moments_2d

    !> Computes the mean of x xᵀ over the perimeter of an ellipse, about its centre.
    function pw85_shell_moments_2d(q, moments) result(status) bind(C, name='pw85_shell_moments_2d')
      import
      real(c_double), intent(in) :: q(3)
      real(c_double), intent(out) :: moments(3)
      integer(c_int) :: status
    end function pw85_shell_moments_2d

  end interface

  ! pw85_shapes.h
  interface

    !> Computes the distance from an ellipsoid with its centre at 0 to the half-space normal·x >=
    !> offset.
    function pw85_distance_plane(normal, offset, q, distance, point) result(status) bind(C, &
      name='pw85_distance_plane')
      import
      real(c_double), intent(in) :: normal(3)
      real(c_double), value :: offset
      real(c_double), intent(in) :: q(6)
      real(c_double), intent(out), optional :: distance, point(3)
      integer(c_int) :: status
    end function pw85_distance_plane

    !> Computes the derivatives of the distance to a half-space, which do not depend on its offset.
    function pw85_distance_plane_derivatives(normal, q, d_center, d_rot) result(status) bind(C, &
      name='pw85_distance_plane_derivatives')
      import
      real(c_double), intent(in) :: normal(3), q(6)
      real(c_double), intent(out), optional :: d_center(3), d_rot(3)
      integer(c_int) :: status
    end function pw85_distance_plane_derivatives

    !> Computes the contact function of an ellipsoid with its centre at 0 and the half-space
    !> normal·x >= offset.
    function pw85_contact_plane(normal, offset, q, mu2, point) result(status) bind(C, &
      name='pw85_contact_plane')
      import
      real(c_double), intent(in) :: normal(3)
      real(c_double), value :: offset
      real(c_double), intent(in) :: q(6)
      real(c_double), intent(out), optional :: mu2, point(3)
      integer(c_int) :: status
    end function pw85_contact_plane

    !> Computes the derivatives of μ² of pw85_contact_plane().
    function pw85_contact_plane_derivatives(normal, offset, q, d_center, d_rot) result(status) &
      bind(C, name='pw85_contact_plane_derivatives')
      import
      real(c_double), intent(in) :: normal(3)
      real(c_double), value :: offset
      real(c_double), intent(in) :: q(6)
      real(c_double), intent(out), optional :: d_center(3), d_rot(3)
      integer(c_int) :: status
    end function pw85_contact_plane_derivatives

    !> Computes the distance from an ellipsoid with its centre at 0 to the nearest face of a box
    !> that contains it.
    function pw85_distance_box(lower, upper, q, distance, point, normal) result(status) bind(C, &
      name='pw85_distance_box')
      import
      real(c_double), intent(in) :: lower(3), upper(3), q(6)
      real(c_double), intent(out), optional :: distance, point(3), normal(3)
      integer(c_int) :: status
    end function pw85_distance_box

    !> Computes the distance from an ellipsoid to the wall of a cylinder of infinite length that
    !> contains it.
    function pw85_distance_cylinder(axis, radius, center, q, distance, point, normal) &
      result(status) bind(C, name='pw85_distance_cylinder')
      import
      real(c_double), intent(in) :: axis(3)
      real(c_double), value :: radius
      real(c_double), intent(in) :: center(3), q(6)
      real(c_double), intent(out), optional :: distance, point(3), normal(3)
      integer(c_int) :: status
    end function pw85_distance_cylinder

    !> Computes the distance from a point to the surface of an ellipsoid.
    function pw85_distance_point(r, q, distance, point, normal) result(status) bind(C, &
      name='pw85_distance_point')
      import
      real(c_double), intent(in) :: r(3), q(6)
      real(c_double), intent(out), optional :: distance, point(3), normal(3)
      integer(c_int) :: status
    end function pw85_distance_point

    !> Computes the interval t[0] <= t <= t[1] in which the line origin + t·direction is inside an
    !> ellipsoid.
    function pw85_intersect_line(origin, direction, q, t) result(status) bind(C, &
      name='pw85_intersect_line')
      import
      real(c_double), intent(in) :: origin(3), direction(3), q(6)
      real(c_double), intent(out) :: t(2)
      integer(c_int) :: status
    end function pw85_intersect_line

    !> Computes the volume of the part of an ellipsoid that is in the half-space normal·x <= offset,
    !> where x is relative to the centre of the ellipsoid.
    function pw85_overlap_volume_plane(normal, offset, q, volume) result(status) bind(C, &
      name='pw85_overlap_volume_plane')
      import
      real(c_double), intent(in) :: normal(3)
      real(c_double), value :: offset
      real(c_double), intent(in) :: q(6)
      real(c_double), intent(out) :: volume
      integer(c_int) :: status
    end function pw85_overlap_volume_plane

    !> Computes the contact function of an ellipsoid and a segment.
    function pw85_contact_segment(end1, end2, q, mu2, point) result(status) bind(C, &
      name='pw85_contact_segment')
      import
      real(c_double), intent(in) :: end1(3), end2(3), q(6)
      real(c_double), intent(out), optional :: mu2, point(3)
      integer(c_int) :: status
    end function pw85_contact_segment

    !> Computes the contact function of an ellipsoid and a triangle.
    function pw85_contact_triangle(vertex1, vertex2, vertex3, q, mu2, point) result(status) &
      bind(C, name='pw85_contact_triangle')
      import
      real(c_double), intent(in) :: vertex1(3), vertex2(3), vertex3(3), q(6)
      real(c_double), intent(out), optional :: mu2, point(3)
      integer(c_int) :: status
    end function pw85_contact_triangle

    !> Computes the contact function of an ellipsoid and a solid box with sides along the axes.
    function pw85_contact_box(lower, upper, q, mu2, point) result(status) bind(C, &
      name='pw85_contact_box')
      import
      real(c_double), intent(in) :: lower(3), upper(3), q(6)
      real(c_double), intent(out), optional :: mu2, point(3)
      integer(c_int) :: status
    end function pw85_contact_box

    !> Computes the contact function of an ellipsoid and a polytope.
    function pw85_contact_polytope(n, normals, offsets, q, mu2, point) result(status) bind(C, &
      name='pw85_contact_polytope')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: normals(3, n), offsets(n), q(6)
      real(c_double), intent(out), optional :: mu2, point(3)
      integer(c_int) :: status
    end function pw85_contact_polytope

    !> Tests whether an ellipsoid and a segment overlap, μ² < 1.
    function pw85_overlap_segment(end1, end2, q, overlap) result(status) bind(C, &
      name='pw85_overlap_segment')
      import
      real(c_double), intent(in) :: end1(3), end2(3), q(6)
      integer(c_int), intent(out) :: overlap
      integer(c_int) :: status
    end function pw85_overlap_segment

    !> Tests whether an ellipsoid and a triangle overlap, μ² < 1.
    function pw85_overlap_triangle(vertex1, vertex2, vertex3, q, overlap) result(status) bind(C, &
      name='pw85_overlap_triangle')
      import
      real(c_double), intent(in) :: vertex1(3), vertex2(3), vertex3(3), q(6)
      integer(c_int), intent(out) :: overlap
      integer(c_int) :: status
    end function pw85_overlap_triangle

    !> Tests whether an ellipsoid and a solid box with sides along the axes overlap, μ² < 1.
    function pw85_overlap_box(lower, upper, q, overlap) result(status) bind(C, &
      name='pw85_overlap_box')
      import
      real(c_double), intent(in) :: lower(3), upper(3), q(6)
      integer(c_int), intent(out) :: overlap
      integer(c_int) :: status
    end function pw85_overlap_box

    !> Tests whether an ellipsoid and a polytope overlap, μ² < 1.
    function pw85_overlap_polytope(n, normals, offsets, q, overlap) result(status) bind(C, &
      name='pw85_overlap_polytope')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: normals(3, n), offsets(n), q(6)
      integer(c_int), intent(out) :: overlap
      integer(c_int) :: status
    end function pw85_overlap_polytope

    !> Computes the signed distance of an ellipsoid and a segment, and the points where it is
    !> reached.
    function pw85_distance_segment(end1, end2, q, distance, point1, point2, normal) result(status) &
      bind(C, name='pw85_distance_segment')
      import
      real(c_double), intent(in) :: end1(3), end2(3), q(6)
      real(c_double), intent(out), optional :: distance, point1(3), point2(3), normal(3)
      integer(c_int) :: status
    end function pw85_distance_segment

    !> Computes the signed distance of an ellipsoid and a triangle, and the points where it is
    !> reached.
    function pw85_distance_triangle(vertex1, vertex2, vertex3, q, distance, point1, point2, &
      normal) result(status) bind(C, name='pw85_distance_triangle')
      import
      real(c_double), intent(in) :: vertex1(3), vertex2(3), vertex3(3), q(6)
      real(c_double), intent(out), optional :: distance, point1(3), point2(3), normal(3)
      integer(c_int) :: status
    end function pw85_distance_triangle

    !> Computes the signed distance of an ellipsoid and a solid box with sides along the axes, and
    !> the points where it is reached.
    function pw85_distance_solid_box(lower, upper, q, distance, point1, point2, normal) &
      result(status) bind(C, name='pw85_distance_solid_box')
      import
      real(c_double), intent(in) :: lower(3), upper(3), q(6)
      real(c_double), intent(out), optional :: distance, point1(3), point2(3), normal(3)
      integer(c_int) :: status
    end function pw85_distance_solid_box

    !> Computes the contact function of an ellipsoid and a capsule.
    function pw85_contact_capsule(end1, end2, radius, q, mu2, point) result(status) bind(C, &
      name='pw85_contact_capsule')
      import
      real(c_double), intent(in) :: end1(3), end2(3)
      real(c_double), value :: radius
      real(c_double), intent(in) :: q(6)
      real(c_double), intent(out), optional :: mu2, point(3)
      integer(c_int) :: status
    end function pw85_contact_capsule

    !> Tests whether an ellipsoid and a capsule overlap, μ² < 1.
    function pw85_overlap_capsule(end1, end2, radius, q, overlap) result(status) bind(C, &
      name='pw85_overlap_capsule')
      import
      real(c_double), intent(in) :: end1(3), end2(3)
      real(c_double), value :: radius
      real(c_double), intent(in) :: q(6)
      integer(c_int), intent(out) :: overlap
      integer(c_int) :: status
    end function pw85_overlap_capsule

    !> Computes the signed distance of an ellipsoid and a capsule, and the points where it is
    !> reached.
    function pw85_distance_capsule(end1, end2, radius, q, distance, point1, point2, normal) &
      result(status) bind(C, name='pw85_distance_capsule')
      import
      real(c_double), intent(in) :: end1(3), end2(3)
      real(c_double), value :: radius
      real(c_double), intent(in) :: q(6)
      real(c_double), intent(out), optional :: distance, point1(3), point2(3), normal(3)
      integer(c_int) :: status
    end function pw85_distance_capsule

    !> Computes the distance from a point to the perimeter of an ellipse.
    function pw85_distance_point_2d(r, q, distance, point, normal) result(status) bind(C, &
      name='pw85_distance_point_2d')
      import
      real(c_double), intent(in) :: r(2), q(3)
      real(c_double), intent(out), optional :: distance, point(2), normal(2)
      integer(c_int) :: status
    end function pw85_distance_point_2d

    !> Computes the contact function of an ellipse and a segment.
    function pw85_contact_segment_2d(end1, end2, q, mu2, point) result(status) bind(C, &
      name='pw85_contact_segment_2d')
      import
      real(c_double), intent(in) :: end1(2), end2(2), q(3)
      real(c_double), intent(out), optional :: mu2, point(2)
      integer(c_int) :: status
    end function pw85_contact_segment_2d

    !> Computes the contact function of an ellipse and a solid rectangle with sides along the axes.
    function pw85_contact_box_2d(lower, upper, q, mu2, point) result(status) bind(C, &
      name='pw85_contact_box_2d')
      import
      real(c_double), intent(in) :: lower(2), upper(2), q(3)
      real(c_double), intent(out), optional :: mu2, point(2)
      integer(c_int) :: status
    end function pw85_contact_box_2d

    !> Tests whether an ellipse and a segment overlap.
    function pw85_overlap_segment_2d(end1, end2, q, overlap) result(status) bind(C, &
      name='pw85_overlap_segment_2d')
      import
      real(c_double), intent(in) :: end1(2), end2(2), q(3)
      integer(c_int), intent(out) :: overlap
      integer(c_int) :: status
    end function pw85_overlap_segment_2d

    !> Tests whether an ellipse and a solid rectangle with sides along the axes overlap.
    function pw85_overlap_box_2d(lower, upper, q, overlap) result(status) bind(C, &
      name='pw85_overlap_box_2d')
      import
      real(c_double), intent(in) :: lower(2), upper(2), q(3)
      integer(c_int), intent(out) :: overlap
      integer(c_int) :: status
    end function pw85_overlap_box_2d

  end interface

  ! pw85_batch.h
  interface

    !> Computes pw85_ellipsoid_quaternion() for n ellipsoids, with bitwise equal results.
    function pw85_ellipsoid_quaternion_batch(n, semi_axes, quaternions, q) result(status) bind(C, &
      name='pw85_ellipsoid_quaternion_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: semi_axes(3, n), quaternions(4, n)
      real(c_double), intent(out) :: q(6, n)
      integer(c_int) :: status
    end function pw85_ellipsoid_quaternion_batch

    !> Computes pw85_ellipsoid_factor() for n ellipsoids, with bitwise equal results. Row k in C is
    !> s(:, k, i).
    function pw85_ellipsoid_factor_batch(n, semi_axes, quaternions, s) result(status) bind(C, &
      name='pw85_ellipsoid_factor_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: semi_axes(3, n), quaternions(4, n)
      real(c_double), intent(out) :: s(3, 3, n)
      integer(c_int) :: status
    end function pw85_ellipsoid_factor_batch

    !> Computes pw85_contact() for n pairs.
    function pw85_contact_batch(n, r12, q1, q2, mu2, lambda) result(status) bind(C, &
      name='pw85_contact_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(3, n), q1(6, n), q2(6, n)
      real(c_double), intent(out) :: mu2(n)
      real(c_double), intent(out), optional :: lambda(n)
      integer(c_int) :: status
    end function pw85_contact_batch

    !> Computes pw85_contact_rounded() for n pairs, with bitwise equal results.
    function pw85_contact_rounded_batch(n, r12, q1, q2, mu2, lambda) result(status) bind(C, &
      name='pw85_contact_rounded_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(3, n), q1(6, n), q2(6, n)
      real(c_double), intent(out), optional :: mu2(n), lambda(n)
      integer(c_int) :: status
    end function pw85_contact_rounded_batch

    !> Computes pw85_contact_factored() for n pairs, with bitwise equal results. Row k in C is s1(:,
    !> k, i), s2(:, k, i).
    function pw85_contact_factored_batch(n, r12, s1, s2, mu2, lambda) result(status) bind(C, &
      name='pw85_contact_factored_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(3, n), s1(3, 3, n), s2(3, 3, n)
      real(c_double), intent(out), optional :: mu2(n), lambda(n)
      integer(c_int) :: status
    end function pw85_contact_factored_batch

    !> Computes pw85_condition() for n pairs, with bitwise equal results.
    function pw85_condition_batch(n, r12, q1, q2, lambda, cond) result(status) bind(C, &
      name='pw85_condition_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(3, n), q1(6, n), q2(6, n), lambda(n)
      real(c_double), intent(out) :: cond(n)
      integer(c_int) :: status
    end function pw85_condition_batch

    !> Computes pw85_contact_function() for n pairs, with bitwise equal results.
    function pw85_contact_function_batch(n, r12, q1, q2, mu2, lambda) result(status) bind(C, &
      name='pw85_contact_function_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(3, n), q1(6, n), q2(6, n)
      real(c_double), intent(out), optional :: mu2(n), lambda(n)
      integer(c_int) :: status
    end function pw85_contact_function_batch

    !> Computes pw85_contact_geometry() for n pairs, with bitwise equal results.
    function pw85_contact_geometry_batch(n, r12, q1, q2, lambda, point, normal) result(status) &
      bind(C, name='pw85_contact_geometry_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(3, n), q1(6, n), q2(6, n), lambda(n)
      real(c_double), intent(out), optional :: point(3, n), normal(3, n)
      integer(c_int) :: status
    end function pw85_contact_geometry_batch

    !> Computes pw85_contact_geometry_factored() for n pairs, with bitwise equal results. Row k in C
    !> is s1(:, k, i), s2(:, k, i).
    function pw85_contact_geometry_factored_batch(n, r12, s1, s2, lambda, point, normal) &
      result(status) bind(C, name='pw85_contact_geometry_factored_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(3, n), s1(3, 3, n), s2(3, 3, n), lambda(n)
      real(c_double), intent(out), optional :: point(3, n), normal(3, n)
      integer(c_int) :: status
    end function pw85_contact_geometry_factored_batch

    !> Computes pw85_contact_gradient() for n pairs, with bitwise equal results.
    function pw85_contact_gradient_batch(n, r12, q1, q2, lambda, d_r12, d_q1, d_q2) result(status) &
      bind(C, name='pw85_contact_gradient_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(3, n), q1(6, n), q2(6, n), lambda(n)
      real(c_double), intent(out), optional :: d_r12(3, n), d_q1(6, n), d_q2(6, n)
      integer(c_int) :: status
    end function pw85_contact_gradient_batch

    !> Computes pw85_contact_gradient_factored() for n pairs, with bitwise equal results. Row k in C
    !> is s1(:, k, i), s2(:, k, i), d_s1(:, k, i), d_s2(:, k, i).
    function pw85_contact_gradient_factored_batch(n, r12, s1, s2, lambda, d_r12, d_s1, d_s2) &
      result(status) bind(C, name='pw85_contact_gradient_factored_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(3, n), s1(3, 3, n), s2(3, 3, n), lambda(n)
      real(c_double), intent(out), optional :: d_r12(3, n), d_s1(3, 3, n), d_s2(3, 3, n)
      integer(c_int) :: status
    end function pw85_contact_gradient_factored_batch

    !> Computes pw85_contact_torque() for n pairs, with bitwise equal results.
    function pw85_contact_torque_batch(n, r12, q1, q2, lambda, d_rot1, d_rot2) result(status) &
      bind(C, name='pw85_contact_torque_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(3, n), q1(6, n), q2(6, n), lambda(n)
      real(c_double), intent(out), optional :: d_rot1(3, n), d_rot2(3, n)
      integer(c_int) :: status
    end function pw85_contact_torque_batch

    !> Computes pw85_contact_hessian() for n pairs, with bitwise equal results. Row k in C is
    !> hessian(:, k, i).
    function pw85_contact_hessian_batch(n, r12, q1, q2, lambda, hessian) result(status) bind(C, &
      name='pw85_contact_hessian_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(3, n), q1(6, n), q2(6, n), lambda(n)
      real(c_double), intent(out) :: hessian(9, 9, n)
      integer(c_int) :: status
    end function pw85_contact_hessian_batch

    !> Computes pw85_overlap() for n pairs, with the same answers.
    function pw85_overlap_batch(n, r12, q1, q2, overlap) result(status) bind(C, &
      name='pw85_overlap_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(3, n), q1(6, n), q2(6, n)
      integer(c_int8_t), intent(out) :: overlap(n)
      integer(c_int) :: status
    end function pw85_overlap_batch

    !> Computes pw85_overlap_factored() for n pairs, with the same answers. Row k in C is s1(:, k,
    !> i), s2(:, k, i).
    function pw85_overlap_factored_batch(n, r12, s1, s2, overlap) result(status) bind(C, &
      name='pw85_overlap_factored_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(3, n), s1(3, 3, n), s2(3, 3, n)
      integer(c_int8_t), intent(out) :: overlap(n)
      integer(c_int) :: status
    end function pw85_overlap_factored_batch

    !> Computes pw85_compare() for n pairs, with the same signs.
    function pw85_compare_batch(n, r12, q1, q2, mu2, sign) result(status) bind(C, &
      name='pw85_compare_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(3, n), q1(6, n), q2(6, n), mu2(n)
      integer(c_int), intent(out) :: sign(n)
      integer(c_int) :: status
    end function pw85_compare_batch

    !> Computes pw85_overlap_witness() for n pairs, with the same results.
    function pw85_overlap_witness_batch(n, r12, q1, q2, overlap, lambda, point) result(status) &
      bind(C, name='pw85_overlap_witness_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(3, n), q1(6, n), q2(6, n)
      integer(c_int8_t), intent(out) :: overlap(n)
      real(c_double), intent(out), optional :: lambda(n), point(3, n)
      integer(c_int) :: status
    end function pw85_overlap_witness_batch

    !> Computes pw85_contains() for n pairs, with the same answers.
    function pw85_contains_batch(n, r12, q1, q2, contains) result(status) bind(C, &
      name='pw85_contains_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(3, n), q1(6, n), q2(6, n)
      integer(c_int8_t), intent(out) :: contains(n)
      integer(c_int) :: status
    end function pw85_contains_batch

    !> Computes pw85_containment() for n pairs, with bitwise equal results.
    function pw85_containment_batch(n, r12, q1, q2, mu2, point) result(status) bind(C, &
      name='pw85_containment_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(3, n), q1(6, n), q2(6, n)
      real(c_double), intent(out), optional :: mu2(n), point(3, n)
      integer(c_int) :: status
    end function pw85_containment_batch

    !> Computes pw85_closest_approach() for n pairs.
    function pw85_closest_approach_batch(n, directions, q1, q2, distance) result(status) bind(C, &
      name='pw85_closest_approach_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: directions(3, n), q1(6, n), q2(6, n)
      real(c_double), intent(out) :: distance(n)
      integer(c_int) :: status
    end function pw85_closest_approach_batch

    !> Computes pw85_volume() for n ellipsoids, with bitwise equal results.
    function pw85_volume_batch(n, q, volume) result(status) bind(C, name='pw85_volume_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: q(6, n)
      real(c_double), intent(out) :: volume(n)
      integer(c_int) :: status
    end function pw85_volume_batch

    !> Computes pw85_overlap_volume() for n pairs, with bitwise equal results.
    function pw85_overlap_volume_batch(n, r12, q1, q2, volume) result(status) bind(C, &
      name='pw85_overlap_volume_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(3, n), q1(6, n), q2(6, n)
      real(c_double), intent(out) :: volume(n)
      integer(c_int) :: status
    end function pw85_overlap_volume_batch

    !> Computes pw85_overlap_volume_gradient() for n pairs, with bitwise equal results.
    function pw85_overlap_volume_gradient_batch(n, r12, q1, q2, d_r12, d_q1, d_q2) result(status) &
      bind(C, name='pw85_overlap_volume_gradient_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(3, n), q1(6, n), q2(6, n)
      real(c_double), intent(out), optional :: d_r12(3, n), d_q1(6, n), d_q2(6, n)
      integer(c_int) :: status
    end function pw85_overlap_volume_gradient_batch

    !> Computes pw85_overlap_volume_torque() for n pairs, with bitwise equal results.
    function pw85_overlap_volume_torque_batch(n, r12, q1, q2, d_rot1, d_rot2) result(status) &
      bind(C, name='pw85_overlap_volume_torque_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(3, n), q1(6, n), q2(6, n)
      real(c_double), intent(out), optional :: d_rot1(3, n), d_rot2(3, n)
      integer(c_int) :: status
    end function pw85_overlap_volume_torque_batch

    !> Computes pw85_area_2d() for n ellipses, with bitwise equal results.
    function pw85_area_batch_2d(n, q, area) result(status) bind(C, name='pw85_area_batch_2d')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: q(3, n)
      real(c_double), intent(out) :: area(n)
      integer(c_int) :: status
    end function pw85_area_batch_2d

    !> Computes pw85_overlap_area_2d() for n pairs, with bitwise equal results.
    function pw85_overlap_area_batch_2d(n, r12, q1, q2, area) result(status) bind(C, &
      name='pw85_overlap_area_batch_2d')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(2, n), q1(3, n), q2(3, n)
      real(c_double), intent(out) :: area(n)
      integer(c_int) :: status
    end function pw85_overlap_area_batch_2d

    !> Computes pw85_overlap_area_gradient_2d() for n pairs, with bitwise equal results.
    function pw85_overlap_area_gradient_batch_2d(n, r12, q1, q2, d_r12, d_q1, d_q2) result(status) &
      bind(C, name='pw85_overlap_area_gradient_batch_2d')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(2, n), q1(3, n), q2(3, n)
      real(c_double), intent(out), optional :: d_r12(2, n), d_q1(3, n), d_q2(3, n)
      integer(c_int) :: status
    end function pw85_overlap_area_gradient_batch_2d

    !> Computes pw85_overlap_area_torque_2d() for n pairs, with bitwise equal results.
    function pw85_overlap_area_torque_batch_2d(n, r12, q1, q2, d_rot1, d_rot2) result(status) &
      bind(C, name='pw85_overlap_area_torque_batch_2d')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(2, n), q1(3, n), q2(3, n)
      real(c_double), intent(out), optional :: d_rot1(n), d_rot2(n)
      integer(c_int) :: status
    end function pw85_overlap_area_torque_batch_2d

    !> Computes pw85_contact_2d() for n pairs.
    function pw85_contact_batch_2d(n, r12, q1, q2, mu2, lambda) result(status) bind(C, &
      name='pw85_contact_batch_2d')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(2, n), q1(3, n), q2(3, n)
      real(c_double), intent(out) :: mu2(n)
      real(c_double), intent(out), optional :: lambda(n)
      integer(c_int) :: status
    end function pw85_contact_batch_2d

    !> Computes pw85_contact_geometry_2d() for n pairs, with bitwise equal results.
    function pw85_contact_geometry_batch_2d(n, r12, q1, q2, lambda, point, normal) result(status) &
      bind(C, name='pw85_contact_geometry_batch_2d')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(2, n), q1(3, n), q2(3, n), lambda(n)
      real(c_double), intent(out), optional :: point(2, n), normal(2, n)
      integer(c_int) :: status
    end function pw85_contact_geometry_batch_2d

    !> Computes pw85_contact_gradient_2d() for n pairs, with bitwise equal results.
    function pw85_contact_gradient_batch_2d(n, r12, q1, q2, lambda, d_r12, d_q1, d_q2) &
      result(status) bind(C, name='pw85_contact_gradient_batch_2d')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(2, n), q1(3, n), q2(3, n), lambda(n)
      real(c_double), intent(out), optional :: d_r12(2, n), d_q1(3, n), d_q2(3, n)
      integer(c_int) :: status
    end function pw85_contact_gradient_batch_2d

    !> Computes pw85_contact_torque_2d() for n pairs, with bitwise equal results.
    function pw85_contact_torque_batch_2d(n, r12, q1, q2, lambda, d_rot1, d_rot2) result(status) &
      bind(C, name='pw85_contact_torque_batch_2d')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(2, n), q1(3, n), q2(3, n), lambda(n)
      real(c_double), intent(out), optional :: d_rot1(n), d_rot2(n)
      integer(c_int) :: status
    end function pw85_contact_torque_batch_2d

    !> Computes pw85_contact_hessian_2d() for n pairs, with bitwise equal results. Row k in C is
    !> hessian(:, k, i).
    function pw85_contact_hessian_batch_2d(n, r12, q1, q2, lambda, hessian) result(status) bind(C, &
      name='pw85_contact_hessian_batch_2d')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(2, n), q1(3, n), q2(3, n), lambda(n)
      real(c_double), intent(out) :: hessian(4, 4, n)
      integer(c_int) :: status
    end function pw85_contact_hessian_batch_2d

    !> Computes pw85_overlap_2d() for n pairs.
    function pw85_overlap_batch_2d(n, r12, q1, q2, overlap) result(status) bind(C, &
      name='pw85_overlap_batch_2d')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(2, n), q1(3, n), q2(3, n)
      integer(c_int8_t), intent(out) :: overlap(n)
      integer(c_int) :: status
    end function pw85_overlap_batch_2d

    !> Computes pw85_closest_approach_2d() for n pairs, with bitwise equal results.
    function pw85_closest_approach_batch_2d(n, directions, q1, q2, distance) result(status) &
      bind(C, name='pw85_closest_approach_batch_2d')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: directions(2, n), q1(3, n), q2(3, n)
      real(c_double), intent(out) :: distance(n)
      integer(c_int) :: status
    end function pw85_closest_approach_batch_2d

    !> Computes pw85_distance() for n pairs.
    function pw85_distance_batch(n, r12, q1, q2, distance, point1, point2) result(status) bind(C, &
      name='pw85_distance_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(3, n), q1(6, n), q2(6, n)
      real(c_double), intent(out), optional :: distance(n), point1(3, n), point2(3, n)
      integer(c_int) :: status
    end function pw85_distance_batch

    !> Computes pw85_distance_geometry() for n pairs.
    function pw85_distance_geometry_batch(n, r12, q1, q2, distance, point1, point2, normal) &
      result(status) bind(C, name='pw85_distance_geometry_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(3, n), q1(6, n), q2(6, n)
      real(c_double), intent(out), optional :: distance(n), point1(3, n), point2(3, n), normal(3, n)
      integer(c_int) :: status
    end function pw85_distance_geometry_batch

    !> Computes pw85_distance_derivatives() for n pairs, with bitwise equal results. Row k in C is
    !> hessian(:, k, i).
    function pw85_distance_derivatives_batch(n, r12, q1, q2, d_r12, d_rot1, d_rot2, hessian) &
      result(status) bind(C, name='pw85_distance_derivatives_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(3, n), q1(6, n), q2(6, n)
      real(c_double), intent(out), optional :: d_r12(3, n), d_rot1(3, n), d_rot2(3, n), hessian(9, &
        9, n)
      integer(c_int) :: status
    end function pw85_distance_derivatives_batch

    !> Computes pw85_penetration() for n pairs, with bitwise equal results.
    function pw85_penetration_batch(n, r12, q1, q2, depth, direction) result(status) bind(C, &
      name='pw85_penetration_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(3, n), q1(6, n), q2(6, n)
      real(c_double), intent(out), optional :: depth(n), direction(3, n)
      integer(c_int) :: status
    end function pw85_penetration_batch

    !> Computes pw85_signed_distance() for n pairs.
    function pw85_signed_distance_batch(n, r12, q1, q2, distance, point1, point2) result(status) &
      bind(C, name='pw85_signed_distance_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(3, n), q1(6, n), q2(6, n)
      real(c_double), intent(out), optional :: distance(n), point1(3, n), point2(3, n)
      integer(c_int) :: status
    end function pw85_signed_distance_batch

    !> Computes pw85_signed_distance_geometry() for n pairs.
    function pw85_signed_distance_geometry_batch(n, r12, q1, q2, distance, point1, point2, normal) &
      result(status) bind(C, name='pw85_signed_distance_geometry_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(3, n), q1(6, n), q2(6, n)
      real(c_double), intent(out), optional :: distance(n), point1(3, n), point2(3, n), normal(3, n)
      integer(c_int) :: status
    end function pw85_signed_distance_geometry_batch

    !> Computes pw85_signed_distance_derivatives() for n pairs, with bitwise equal results. Row k in
    !> C is hessian(:, k, i).
    function pw85_signed_distance_derivatives_batch(n, r12, q1, q2, d_r12, d_rot1, d_rot2, &
      hessian) result(status) bind(C, name='pw85_signed_distance_derivatives_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(3, n), q1(6, n), q2(6, n)
      real(c_double), intent(out), optional :: d_r12(3, n), d_rot1(3, n), d_rot2(3, n), hessian(9, &
        9, n)
      integer(c_int) :: status
    end function pw85_signed_distance_derivatives_batch

    !> Computes pw85_gap_inside() for n pairs, with bitwise equal results.
    function pw85_gap_inside_batch(n, r12, q1, q2, gap, point1, point2, normal) result(status) &
      bind(C, name='pw85_gap_inside_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(3, n), q1(6, n), q2(6, n)
      real(c_double), intent(out), optional :: gap(n), point1(3, n), point2(3, n), normal(3, n)
      integer(c_int) :: status
    end function pw85_gap_inside_batch

    !> Computes pw85_distance_2d() for n pairs, with bitwise equal results.
    function pw85_distance_batch_2d(n, r12, q1, q2, distance, point1, point2) result(status) &
      bind(C, name='pw85_distance_batch_2d')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(2, n), q1(3, n), q2(3, n)
      real(c_double), intent(out), optional :: distance(n), point1(2, n), point2(2, n)
      integer(c_int) :: status
    end function pw85_distance_batch_2d

    !> Computes pw85_distance_geometry_2d() for n pairs, with bitwise equal results.
    function pw85_distance_geometry_batch_2d(n, r12, q1, q2, distance, point1, point2, normal) &
      result(status) bind(C, name='pw85_distance_geometry_batch_2d')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(2, n), q1(3, n), q2(3, n)
      real(c_double), intent(out), optional :: distance(n), point1(2, n), point2(2, n), normal(2, n)
      integer(c_int) :: status
    end function pw85_distance_geometry_batch_2d

    !> Computes pw85_penetration_2d() for n pairs, with bitwise equal results.
    function pw85_penetration_batch_2d(n, r12, q1, q2, depth, direction) result(status) bind(C, &
      name='pw85_penetration_batch_2d')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(2, n), q1(3, n), q2(3, n)
      real(c_double), intent(out), optional :: depth(n), direction(2, n)
      integer(c_int) :: status
    end function pw85_penetration_batch_2d

    !> Computes pw85_signed_distance_2d() for n pairs, with bitwise equal results.
    function pw85_signed_distance_batch_2d(n, r12, q1, q2, distance, point1, point2) &
      result(status) bind(C, name='pw85_signed_distance_batch_2d')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(2, n), q1(3, n), q2(3, n)
      real(c_double), intent(out), optional :: distance(n), point1(2, n), point2(2, n)
      integer(c_int) :: status
    end function pw85_signed_distance_batch_2d

    !> Computes pw85_signed_distance_geometry_2d() for n pairs, with bitwise equal results.
    function pw85_signed_distance_geometry_batch_2d(n, r12, q1, q2, distance, point1, point2, &
      normal) result(status) bind(C, name='pw85_signed_distance_geometry_batch_2d')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(2, n), q1(3, n), q2(3, n)
      real(c_double), intent(out), optional :: distance(n), point1(2, n), point2(2, n), normal(2, n)
      integer(c_int) :: status
    end function pw85_signed_distance_geometry_batch_2d

    !> Computes pw85_gap_inside_2d() for n pairs, with bitwise equal results.
    function pw85_gap_inside_batch_2d(n, r12, q1, q2, gap, point1, point2, normal) result(status) &
      bind(C, name='pw85_gap_inside_batch_2d')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(2, n), q1(3, n), q2(3, n)
      real(c_double), intent(out), optional :: gap(n), point1(2, n), point2(2, n), normal(2, n)
      integer(c_int) :: status
    end function pw85_gap_inside_batch_2d

    !> Computes pw85_first_contact() for n pairs, with bitwise equal results.
    function pw85_first_contact_batch(n, r12, q1, q2, motion1, motion2, t_max, t) result(status) &
      bind(C, name='pw85_first_contact_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(3, n), q1(6, n), q2(6, n)
      type(pw85_motion), intent(in) :: motion1(n), motion2(n)
      real(c_double), value :: t_max
      real(c_double), intent(out) :: t(n)
      integer(c_int) :: status
    end function pw85_first_contact_batch

    !> Computes pw85_closest_passage() for n pairs.
    function pw85_closest_passage_batch(n, r12, q1, q2, velocity, t_max, mu2, t) result(status) &
      bind(C, name='pw85_closest_passage_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(3, n), q1(6, n), q2(6, n), velocity(3, n)
      real(c_double), value :: t_max
      real(c_double), intent(out) :: mu2(n)
      real(c_double), intent(out), optional :: t(n)
      integer(c_int) :: status
    end function pw85_closest_passage_batch

    !> Computes pw85_free_path() for n pairs, with bitwise equal results.
    function pw85_free_path_batch(n, r12, q1, q2, directions, t_max, t) result(status) bind(C, &
      name='pw85_free_path_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(3, n), q1(6, n), q2(6, n), directions(3, n), t_max(n)
      real(c_double), intent(out) :: t(n)
      integer(c_int) :: status
    end function pw85_free_path_batch

    !> Computes pw85_curvature() for n ellipsoids, with bitwise equal results. Row k in C is
    !> directions(:, k, i).
    function pw85_curvature_batch(n, normals, q, curvatures, directions) result(status) bind(C, &
      name='pw85_curvature_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: normals(3, n), q(6, n)
      real(c_double), intent(out), optional :: curvatures(2, n), directions(3, 2, n)
      integer(c_int) :: status
    end function pw85_curvature_batch

    !> Computes pw85_hertz() for n contacts, with bitwise equal results.
    function pw85_hertz_batch(n, curvatures, radius, ellipse) result(status) bind(C, &
      name='pw85_hertz_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: curvatures(2, n)
      real(c_double), intent(out), optional :: radius(n), ellipse(2, n)
      integer(c_int) :: status
    end function pw85_hertz_batch

    !> Computes pw85_hertz_contact() for n pairs, with bitwise equal results. Row k in C is
    !> directions(:, k, i).
    function pw85_hertz_contact_batch(n, r12, q1, q2, normals, depth, point, curvatures, &
      directions, radius, ellipse) result(status) bind(C, name='pw85_hertz_contact_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(3, n), q1(6, n), q2(6, n), normals(3, n)
      real(c_double), intent(out), optional :: depth(n), point(3, n), curvatures(2, n), &
        directions(3, 2, n), radius(n), ellipse(2, n)
      integer(c_int) :: status
    end function pw85_hertz_contact_batch

    !> Computes pw85_grain_contact() for n pairs.
    function pw85_grain_contact_batch(n, r12, q1, q2, starts, normal, depth, point, curvatures, &
      radius) result(status) bind(C, name='pw85_grain_contact_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(3, n), q1(6, n), q2(6, n), starts(3, n)
      real(c_double), intent(out), optional :: normal(3, n), depth(n), point(3, n), curvatures(2, &
        n), radius(n)
      integer(c_int) :: status
    end function pw85_grain_contact_batch

    !> Computes pw85_grain_radius_gradient() for n pairs, with bitwise equal results.
    function pw85_grain_radius_gradient_batch(n, r12, q1, q2, normals, d_r12, d_rot1, d_rot2) &
      result(status) bind(C, name='pw85_grain_radius_gradient_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(3, n), q1(6, n), q2(6, n), normals(3, n)
      real(c_double), intent(out), optional :: d_r12(3, n), d_rot1(3, n), d_rot2(3, n)
      integer(c_int) :: status
    end function pw85_grain_radius_gradient_batch

    !> Computes pw85_grain_contact_wall() for n ellipsoids and walls, with bitwise equal results.
    function pw85_grain_contact_wall_batch(n, normals, offsets, directions, curvature, q, depth, &
      point, curvatures, radius) result(status) bind(C, name='pw85_grain_contact_wall_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: normals(3, n), offsets(n), directions(3, n), curvature(n), &
        q(6, n)
      real(c_double), intent(out), optional :: depth(n), point(3, n), curvatures(2, n), radius(n)
      integer(c_int) :: status
    end function pw85_grain_contact_wall_batch

    !> Computes pw85_surface_area() for n ellipsoids, with bitwise equal results.
    function pw85_surface_area_batch(n, q, area) result(status) bind(C, &
      name='pw85_surface_area_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: q(6, n)
      real(c_double), intent(out) :: area(n)
      integer(c_int) :: status
    end function pw85_surface_area_batch

    !> Computes pw85_second_moments() for n ellipsoids, with bitwise equal results.
    function pw85_second_moments_batch(n, q, moments) result(status) bind(C, &
      name='pw85_second_moments_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: q(6, n)
      real(c_double), intent(out) :: moments(6, n)
      integer(c_int) :: status
    end function pw85_second_moments_batch

    !> Computes pw85_from_moments() for n ellipsoids, with bitwise equal results.
    function pw85_from_moments_batch(n, second_moments, q) result(status) bind(C, &
      name='pw85_from_moments_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: second_moments(6, n)
      real(c_double), intent(out) :: q(6, n)
      integer(c_int) :: status
    end function pw85_from_moments_batch

    !> Computes pw85_shell_moments() for n ellipsoids, with bitwise equal results.
    function pw85_shell_moments_batch(n, q, moments) result(status) bind(C, &
      name='pw85_shell_moments_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: q(6, n)
      real(c_double), intent(out) :: moments(6, n)
      integer(c_int) :: status
    end function pw85_shell_moments_batch

    !> Computes pw85_inertia() for n ellipsoids, with bitwise equal results.
    function pw85_inertia_batch(n, q, shell, inertia) result(status) bind(C, &
      name='pw85_inertia_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: q(6, n)
      integer(c_int), value :: shell
      real(c_double), intent(out) :: inertia(6, n)
      integer(c_int) :: status
    end function pw85_inertia_batch

    !> Computes pw85_perimeter_2d() for n ellipses, with bitwise equal results.
    function pw85_perimeter_batch_2d(n, q, perimeter) result(status) bind(C, &
      name='pw85_perimeter_batch_2d')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: q(3, n)
      real(c_double), intent(out) :: perimeter(n)
      integer(c_int) :: status
    end function pw85_perimeter_batch_2d

    !> Computes pw85_second_moments_2d() for n ellipses, with bitwise equal results.
    function pw85_second_moments_batch_2d(n, q, moments) result(status) bind(C, &
      name='pw85_second_moments_batch_2d')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: q(3, n)
      real(c_double), intent(out) :: moments(3, n)
      integer(c_int) :: status
    end function pw85_second_moments_batch_2d

    !> Computes pw85_from_moments_2d() for n ellipses, with bitwise equal results.
    function pw85_from_moments_batch_2d(n, second_moments, q) result(status) bind(C, &
      name='pw85_from_moments_batch_2d')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: second_moments(3, n)
      real(c_double), intent(out) :: q(3, n)
      integer(c_int) :: status
    end function pw85_from_moments_batch_2d

    !> Computes pw85_shell_moments_2d() for n ellipses, with bitwise equal results.
    function pw85_shell_moments_batch_2d(n, q, moments) result(status) bind(C, &
      name='pw85_shell_moments_batch_2d')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: q(3, n)
      real(c_double), intent(out) :: moments(3, n)
      integer(c_int) :: status
    end function pw85_shell_moments_batch_2d

    !> Computes pw85_distance_plane() for n ellipsoids and half-spaces, with bitwise equal results.
    function pw85_distance_plane_batch(n, normals, offsets, q, distance, point) result(status) &
      bind(C, name='pw85_distance_plane_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: normals(3, n), offsets(n), q(6, n)
      real(c_double), intent(out), optional :: distance(n), point(3, n)
      integer(c_int) :: status
    end function pw85_distance_plane_batch

    !> Computes pw85_distance_plane_derivatives() for n ellipsoids and half-spaces, with bitwise
    !> equal results.
    function pw85_distance_plane_derivatives_batch(n, normals, q, d_center, d_rot) result(status) &
      bind(C, name='pw85_distance_plane_derivatives_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: normals(3, n), q(6, n)
      real(c_double), intent(out), optional :: d_center(3, n), d_rot(3, n)
      integer(c_int) :: status
    end function pw85_distance_plane_derivatives_batch

    !> Computes pw85_contact_plane() for n ellipsoids and half-spaces, with bitwise equal results.
    function pw85_contact_plane_batch(n, normals, offsets, q, mu2, point) result(status) bind(C, &
      name='pw85_contact_plane_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: normals(3, n), offsets(n), q(6, n)
      real(c_double), intent(out), optional :: mu2(n), point(3, n)
      integer(c_int) :: status
    end function pw85_contact_plane_batch

    !> Computes pw85_contact_plane_derivatives() for n ellipsoids and half-spaces, with bitwise
    !> equal results.
    function pw85_contact_plane_derivatives_batch(n, normals, offsets, q, d_center, d_rot) &
      result(status) bind(C, name='pw85_contact_plane_derivatives_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: normals(3, n), offsets(n), q(6, n)
      real(c_double), intent(out), optional :: d_center(3, n), d_rot(3, n)
      integer(c_int) :: status
    end function pw85_contact_plane_derivatives_batch

    !> Computes pw85_distance_box() for n ellipsoids and boxes, with bitwise equal results.
    function pw85_distance_box_batch(n, lower, upper, q, distance, point, normal) result(status) &
      bind(C, name='pw85_distance_box_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: lower(3, n), upper(3, n), q(6, n)
      real(c_double), intent(out), optional :: distance(n), point(3, n), normal(3, n)
      integer(c_int) :: status
    end function pw85_distance_box_batch

    !> Computes pw85_distance_cylinder() for n ellipsoids and cylinders, with bitwise equal results.
    function pw85_distance_cylinder_batch(n, axis, radius, center, q, distance, point, normal) &
      result(status) bind(C, name='pw85_distance_cylinder_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: axis(3, n), radius(n), center(3, n), q(6, n)
      real(c_double), intent(out), optional :: distance(n), point(3, n), normal(3, n)
      integer(c_int) :: status
    end function pw85_distance_cylinder_batch

    !> Computes pw85_distance_point() for n points and ellipsoids, with bitwise equal results.
    function pw85_distance_point_batch(n, r, q, distance, point, normal) result(status) bind(C, &
      name='pw85_distance_point_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r(3, n), q(6, n)
      real(c_double), intent(out), optional :: distance(n), point(3, n), normal(3, n)
      integer(c_int) :: status
    end function pw85_distance_point_batch

    !> Computes pw85_intersect_line() for n lines and ellipsoids, with bitwise equal results.
    function pw85_intersect_line_batch(n, origin, directions, q, enter, leave) result(status) &
      bind(C, name='pw85_intersect_line_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: origin(3, n), directions(3, n), q(6, n)
      real(c_double), intent(out), optional :: enter(n), leave(n)
      integer(c_int) :: status
    end function pw85_intersect_line_batch

    !> Computes pw85_overlap_volume_plane() for n ellipsoids and half-spaces, with bitwise equal
    !> results.
    function pw85_overlap_volume_plane_batch(n, normals, offsets, q, volume) result(status) &
      bind(C, name='pw85_overlap_volume_plane_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: normals(3, n), offsets(n), q(6, n)
      real(c_double), intent(out) :: volume(n)
      integer(c_int) :: status
    end function pw85_overlap_volume_plane_batch

    !> Computes pw85_contact_segment() for n ellipsoids and segments.
    function pw85_contact_segment_batch(n, end1, end2, q, mu2, point) result(status) bind(C, &
      name='pw85_contact_segment_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: end1(3, n), end2(3, n), q(6, n)
      real(c_double), intent(out), optional :: mu2(n), point(3, n)
      integer(c_int) :: status
    end function pw85_contact_segment_batch

    !> Computes pw85_contact_triangle() for n ellipsoids and triangles.
    function pw85_contact_triangle_batch(n, vertex1, vertex2, vertex3, q, mu2, point) &
      result(status) bind(C, name='pw85_contact_triangle_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: vertex1(3, n), vertex2(3, n), vertex3(3, n), q(6, n)
      real(c_double), intent(out), optional :: mu2(n), point(3, n)
      integer(c_int) :: status
    end function pw85_contact_triangle_batch

    !> Computes pw85_contact_box() for n ellipsoids and boxes.
    function pw85_contact_box_batch(n, lower, upper, q, mu2, point) result(status) bind(C, &
      name='pw85_contact_box_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: lower(3, n), upper(3, n), q(6, n)
      real(c_double), intent(out), optional :: mu2(n), point(3, n)
      integer(c_int) :: status
    end function pw85_contact_box_batch

    !> Computes pw85_overlap_segment() for n ellipsoids and segments, with the same answers.
    function pw85_overlap_segment_batch(n, end1, end2, q, overlap) result(status) bind(C, &
      name='pw85_overlap_segment_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: end1(3, n), end2(3, n), q(6, n)
      integer(c_int8_t), intent(out) :: overlap(n)
      integer(c_int) :: status
    end function pw85_overlap_segment_batch

    !> Computes pw85_overlap_triangle() for n ellipsoids and triangles, with the same answers.
    function pw85_overlap_triangle_batch(n, vertex1, vertex2, vertex3, q, overlap) result(status) &
      bind(C, name='pw85_overlap_triangle_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: vertex1(3, n), vertex2(3, n), vertex3(3, n), q(6, n)
      integer(c_int8_t), intent(out) :: overlap(n)
      integer(c_int) :: status
    end function pw85_overlap_triangle_batch

    !> Computes pw85_overlap_box() for n ellipsoids and boxes, with the same answers.
    function pw85_overlap_box_batch(n, lower, upper, q, overlap) result(status) bind(C, &
      name='pw85_overlap_box_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: lower(3, n), upper(3, n), q(6, n)
      integer(c_int8_t), intent(out) :: overlap(n)
      integer(c_int) :: status
    end function pw85_overlap_box_batch

    !> Computes pw85_distance_segment() for n ellipsoids and segments, with bitwise equal results.
    function pw85_distance_segment_batch(n, end1, end2, q, distance, point1, point2, normal) &
      result(status) bind(C, name='pw85_distance_segment_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: end1(3, n), end2(3, n), q(6, n)
      real(c_double), intent(out), optional :: distance(n), point1(3, n), point2(3, n), normal(3, n)
      integer(c_int) :: status
    end function pw85_distance_segment_batch

    !> Computes pw85_distance_triangle() for n ellipsoids and triangles, with bitwise equal results.
    function pw85_distance_triangle_batch(n, vertex1, vertex2, vertex3, q, distance, point1, &
      point2, normal) result(status) bind(C, name='pw85_distance_triangle_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: vertex1(3, n), vertex2(3, n), vertex3(3, n), q(6, n)
      real(c_double), intent(out), optional :: distance(n), point1(3, n), point2(3, n), normal(3, n)
      integer(c_int) :: status
    end function pw85_distance_triangle_batch

    !> Computes pw85_distance_solid_box() for n ellipsoids and boxes, with bitwise equal results.
    function pw85_distance_solid_box_batch(n, lower, upper, q, distance, point1, point2, normal) &
      result(status) bind(C, name='pw85_distance_solid_box_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: lower(3, n), upper(3, n), q(6, n)
      real(c_double), intent(out), optional :: distance(n), point1(3, n), point2(3, n), normal(3, n)
      integer(c_int) :: status
    end function pw85_distance_solid_box_batch

    !> Computes pw85_contact_capsule() for n ellipsoids and capsules, with bitwise equal results.
    function pw85_contact_capsule_batch(n, end1, end2, radius, q, mu2, point) result(status) &
      bind(C, name='pw85_contact_capsule_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: end1(3, n), end2(3, n), radius(n), q(6, n)
      real(c_double), intent(out), optional :: mu2(n), point(3, n)
      integer(c_int) :: status
    end function pw85_contact_capsule_batch

    !> Computes pw85_overlap_capsule() for n ellipsoids and capsules, with the same answers.
    function pw85_overlap_capsule_batch(n, end1, end2, radius, q, overlap) result(status) bind(C, &
      name='pw85_overlap_capsule_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: end1(3, n), end2(3, n), radius(n), q(6, n)
      integer(c_int8_t), intent(out) :: overlap(n)
      integer(c_int) :: status
    end function pw85_overlap_capsule_batch

    !> Computes pw85_distance_capsule() for n ellipsoids and capsules, with bitwise equal results.
    function pw85_distance_capsule_batch(n, end1, end2, radius, q, distance, point1, point2, &
      normal) result(status) bind(C, name='pw85_distance_capsule_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: end1(3, n), end2(3, n), radius(n), q(6, n)
      real(c_double), intent(out), optional :: distance(n), point1(3, n), point2(3, n), normal(3, n)
      integer(c_int) :: status
    end function pw85_distance_capsule_batch

    !> Computes pw85_distance_point_2d() for n points and ellipses, with bitwise equal results.
    function pw85_distance_point_batch_2d(n, r, q, distance, point, normal) result(status) bind(C, &
      name='pw85_distance_point_batch_2d')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r(2, n), q(3, n)
      real(c_double), intent(out), optional :: distance(n), point(2, n), normal(2, n)
      integer(c_int) :: status
    end function pw85_distance_point_batch_2d

    !> Computes pw85_contact_segment_2d() for n ellipses and segments, with bitwise equal results.
    function pw85_contact_segment_batch_2d(n, end1, end2, q, mu2, point) result(status) bind(C, &
      name='pw85_contact_segment_batch_2d')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: end1(2, n), end2(2, n), q(3, n)
      real(c_double), intent(out), optional :: mu2(n), point(2, n)
      integer(c_int) :: status
    end function pw85_contact_segment_batch_2d

    !> Computes pw85_contact_box_2d() for n ellipses and boxes, with bitwise equal results.
    function pw85_contact_box_batch_2d(n, lower, upper, q, mu2, point) result(status) bind(C, &
      name='pw85_contact_box_batch_2d')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: lower(2, n), upper(2, n), q(3, n)
      real(c_double), intent(out), optional :: mu2(n), point(2, n)
      integer(c_int) :: status
    end function pw85_contact_box_batch_2d

    !> Computes pw85_overlap_segment_2d() for n ellipses and segments, with the same answers.
    function pw85_overlap_segment_batch_2d(n, end1, end2, q, overlap) result(status) bind(C, &
      name='pw85_overlap_segment_batch_2d')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: end1(2, n), end2(2, n), q(3, n)
      integer(c_int8_t), intent(out) :: overlap(n)
      integer(c_int) :: status
    end function pw85_overlap_segment_batch_2d

    !> Computes pw85_overlap_box_2d() for n ellipses and boxes, with the same answers.
    function pw85_overlap_box_batch_2d(n, lower, upper, q, overlap) result(status) bind(C, &
      name='pw85_overlap_box_batch_2d')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: lower(2, n), upper(2, n), q(3, n)
      integer(c_int8_t), intent(out) :: overlap(n)
      integer(c_int) :: status
    end function pw85_overlap_box_batch_2d

    !> Computes pw85_contact(), pw85_contact_geometry(), pw85_contact_gradient() and
    !> pw85_contact_torque() for n pairs in one call.
    function pw85_contact_derivatives_batch(n, r12, q1, q2, mu2, lambda, point, normal, d_r12, &
      d_rot1, d_rot2) result(status) bind(C, name='pw85_contact_derivatives_batch')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: r12(3, n), q1(6, n), q2(6, n)
      real(c_double), intent(out), optional :: mu2(n), lambda(n), point(3, n), normal(3, n), &
        d_r12(3, n), d_rot1(3, n), d_rot2(3, n)
      integer(c_int) :: status
    end function pw85_contact_derivatives_batch

    !> Computes pw85_contact_polytope() for many ellipsoids and one polytope.
    function pw85_contact_polytope_batch(num_ellipsoids, centers, q, num_planes, normals, offsets, &
      mu2, point) result(status) bind(C, name='pw85_contact_polytope_batch')
      import
      integer(c_size_t), value :: num_ellipsoids, num_planes
      real(c_double), intent(in) :: centers(3, num_ellipsoids), q(6, num_ellipsoids), normals(3, &
        num_planes), offsets(num_planes)
      real(c_double), intent(out), optional :: mu2(num_ellipsoids), point(3, num_ellipsoids)
      integer(c_int) :: status
    end function pw85_contact_polytope_batch

    !> Tests which of many ellipsoids overlap one polytope, such as the frustum of a camera.
    function pw85_overlap_polytope_batch(num_ellipsoids, centers, q, num_planes, normals, offsets, &
      overlap) result(status) bind(C, name='pw85_overlap_polytope_batch')
      import
      integer(c_size_t), value :: num_ellipsoids, num_planes
      real(c_double), intent(in) :: centers(3, num_ellipsoids), q(6, num_ellipsoids), normals(3, &
        num_planes), offsets(num_planes)
      integer(c_int8_t), intent(out) :: overlap(num_ellipsoids)
      integer(c_int) :: status
    end function pw85_overlap_polytope_batch

    !> Tests whether an ellipsoid overlaps any of n others.
    function pw85_overlap_any(q1, n, r12, q2, any) result(status) bind(C, name='pw85_overlap_any')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: q1(6), r12(3, n), q2(6, n)
      integer(c_int), intent(out) :: any
      integer(c_int) :: status
    end function pw85_overlap_any

    !> Computes the bounding boxes of n ellipsoids, with sides along the coordinate axes.
    function pw85_bounding_boxes(n, q, half_widths) result(status) bind(C, &
      name='pw85_bounding_boxes')
      import
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: q(6, n)
      real(c_double), intent(out) :: half_widths(3, n)
      integer(c_int) :: status
    end function pw85_bounding_boxes

  end interface

  ! pw85_enclosing.h
  interface

    !> Computes the ellipsoid of least volume around points, up to a tolerance, with a proof.
    function pw85_enclosing_ellipsoid(n, m, points, tolerance, center, q, excess) result(status) &
      bind(C, name='pw85_enclosing_ellipsoid')
      import
      integer(c_int), value :: n
      integer(c_size_t), value :: m
      real(c_double), intent(in) :: points(n, m)
      real(c_double), value :: tolerance
      real(c_double), intent(out), optional :: center(n), q(n*(n+1)/2), excess
      integer(c_int) :: status
    end function pw85_enclosing_ellipsoid

    !> Computes the ellipsoid of least volume around ellipsoids, up to a tolerance, with a proof.
    function pw85_enclosing_ellipsoid_of(n, m, centers, forms, tolerance, center, q, excess) &
      result(status) bind(C, name='pw85_enclosing_ellipsoid_of')
      import
      integer(c_int), value :: n
      integer(c_size_t), value :: m
      real(c_double), intent(in) :: centers(n, m), forms(n*(n+1)/2, m)
      real(c_double), value :: tolerance
      real(c_double), intent(out), optional :: center(n), q(n*(n+1)/2), excess
      integer(c_int) :: status
    end function pw85_enclosing_ellipsoid_of

    !> Makes random points, distributed uniformly in an ellipsoid with its centre at 0, or on its
    !> surface.
    function pw85_random_points(q, surface, seed, num_points, points) result(status) bind(C, &
      name='pw85_random_points')
      import
      integer(c_size_t), value :: seed, num_points
      real(c_double), intent(in) :: q(6)
      integer(c_int), value :: surface
      real(c_double), intent(out) :: points(3, num_points)
      integer(c_int) :: status
    end function pw85_random_points

  end interface

  ! pw85_systems.h
  interface

    !> Tests whether an ellipsoid overlaps any of n listed particles of a system.
    function pw85_overlap_any_indices(center, q1, system, n, indices, images, any) result(status) &
      bind(C, name='pw85_overlap_any_indices')
      import
      type(pw85_system), intent(in) :: system
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: center(3), q1(6)
      integer(c_int32_t), intent(in) :: indices(n)
      integer(c_int32_t), intent(in), optional :: images(3, n)
      integer(c_int), intent(out) :: any
      integer(c_int) :: status
    end function pw85_overlap_any_indices

    !> Computes the contact function of the pairs of a list.
    function pw85_contact_pairs(list, system, mu2, lambda) result(status) bind(C, &
      name='pw85_contact_pairs')
      import
      type(pw85_pair_list), intent(in) :: list
      type(pw85_system), intent(in) :: system
      real(c_double), intent(out) :: mu2(list%num_pairs)
      real(c_double), intent(out), optional :: lambda(list%num_pairs)
      integer(c_int) :: status
    end function pw85_contact_pairs

    !> Tests whether the pairs of a list overlap.
    function pw85_overlap_pairs(list, system, overlap) result(status) bind(C, &
      name='pw85_overlap_pairs')
      import
      type(pw85_pair_list), intent(in) :: list
      type(pw85_system), intent(in) :: system
      integer(c_int8_t), intent(out) :: overlap(list%num_pairs)
      integer(c_int) :: status
    end function pw85_overlap_pairs

    !> Computes the volumes of the intersections of the pairs of a list.
    function pw85_overlap_volume_pairs(list, system, volume) result(status) bind(C, &
      name='pw85_overlap_volume_pairs')
      import
      type(pw85_pair_list), intent(in) :: list
      type(pw85_system), intent(in) :: system
      real(c_double), intent(out) :: volume(list%num_pairs)
      integer(c_int) :: status
    end function pw85_overlap_volume_pairs

    !> Computes μ², its derivatives, points and normals for the pairs of a list.
    function pw85_contact_derivatives_pairs(list, system, mu2, lambda, point, normal, d_r12, &
      d_rot1, d_rot2) result(status) bind(C, name='pw85_contact_derivatives_pairs')
      import
      type(pw85_pair_list), intent(in) :: list
      type(pw85_system), intent(in) :: system
      real(c_double), intent(out), optional :: mu2(list%num_pairs), lambda(list%num_pairs), &
        point(3, list%num_pairs), normal(3, list%num_pairs), d_r12(3, list%num_pairs), d_rot1(3, &
        list%num_pairs), d_rot2(3, list%num_pairs)
      integer(c_int) :: status
    end function pw85_contact_derivatives_pairs

    !> Computes the forces, torques and virial of a pair energy U(μ²) by summing over the pairs. Row
    !> k in C is virial(:, k).
    function pw85_contact_forces_pairs(list, system, d_u, d_r12, d_rot1, d_rot2, forces, torques, &
      virial) result(status) bind(C, name='pw85_contact_forces_pairs')
      import
      type(pw85_pair_list), intent(in) :: list
      type(pw85_system), intent(in) :: system
      real(c_double), intent(in) :: d_u(list%num_pairs)
      real(c_double), intent(in), optional :: d_r12(3, list%num_pairs), d_rot1(3, list%num_pairs), &
        d_rot2(3, list%num_pairs)
      real(c_double), intent(out), optional :: forces(3, system%num_particles), torques(3, &
        system%num_particles), virial(3, 3)
      integer(c_int) :: status
    end function pw85_contact_forces_pairs

    !> Computes the total energy, the forces, the torques and the virial of the pairs of a list. Row
    !> k in C is virial(:, k).
    function pw85_law_forces_pairs(list, system, law, energy, forces, torques, virial) &
      result(status) bind(C, name='pw85_law_forces_pairs')
      import
      type(pw85_pair_list), intent(in) :: list
      type(pw85_system), intent(in) :: system
      type(pw85_law), intent(in) :: law
      real(c_double), intent(out), optional :: energy, forces(3, system%num_particles), torques(3, &
        system%num_particles), virial(3, 3)
      integer(c_int) :: status
    end function pw85_law_forces_pairs

    !> Computes the times of the first contacts of the pairs of a list, and the first contact of
    !> each particle, for event-driven simulations.
    function pw85_first_contact_pairs(list, system, motions, t_max, t, next, next_pair) &
      result(status) bind(C, name='pw85_first_contact_pairs')
      import
      type(pw85_pair_list), intent(in) :: list
      type(pw85_system), intent(in) :: system
      type(pw85_motion), intent(in) :: motions(system%num_particles)
      real(c_double), value :: t_max
      real(c_double), intent(out) :: t(list%num_pairs)
      real(c_double), intent(out), optional :: next(system%num_particles)
      integer(c_int64_t), intent(out), optional :: next_pair(system%num_particles)
      integer(c_int) :: status
    end function pw85_first_contact_pairs

    !> Computes a reduced cell of a lattice. Row k in C is cell(:, k), reduced(:, k).
    function pw85_cell_reduce(cell, reduced) result(status) bind(C, name='pw85_cell_reduce')
      import
      real(c_double), intent(in) :: cell(3, 3)
      real(c_double), intent(out) :: reduced(3, 3)
      integer(c_int) :: status
    end function pw85_cell_reduce

    !> Computes the nearest images that the functions of pair lists use if `images` is null.
    function pw85_nearest_images(num_pairs, pairs, system, r12, images) result(status) bind(C, &
      name='pw85_nearest_images')
      import
      integer(c_size_t), value :: num_pairs
      type(pw85_system), intent(in) :: system
      integer(c_int32_t), intent(in) :: pairs(2, num_pairs)
      real(c_double), intent(out), optional :: r12(3, num_pairs)
      integer(c_int32_t), intent(out), optional :: images(3, num_pairs)
      integer(c_int) :: status
    end function pw85_nearest_images

    !> Computes the limit of μ² below which an image of a pair of these particles is always the
    !> nearest image.
    function pw85_nearest_image_limit(system, mu2) result(status) bind(C, &
      name='pw85_nearest_image_limit')
      import
      type(pw85_system), intent(in) :: system
      real(c_double), intent(out) :: mu2
      integer(c_int) :: status
    end function pw85_nearest_image_limit

    !> Makes a neighbour list.
    function pw85_neighbors_create(system, scale, skin, list) result(status) bind(C, &
      name='pw85_neighbors_create')
      import
      type(pw85_system), intent(in) :: system
      real(c_double), value :: scale, skin
      type(c_ptr), intent(out) :: list
      integer(c_int) :: status
    end function pw85_neighbors_create

    !> Finds the invalid particle after pw85_neighbors_create() has failed.
    function pw85_neighbors_check(system, scale, skin, particle) result(status) bind(C, &
      name='pw85_neighbors_check')
      import
      type(pw85_system), intent(in) :: system
      real(c_double), value :: scale, skin
      integer(c_size_t), intent(out) :: particle
      integer(c_int) :: status
    end function pw85_neighbors_check

    !> Tests whether a list still contains all pairs whose boxes intersect (without skin), after
    !> particles have moved or rotated, or the cell has changed.
    function pw85_neighbors_holds(list, system, holds) result(status) bind(C, &
      name='pw85_neighbors_holds')
      import
      type(pw85_system), intent(in) :: system
      type(c_ptr), value :: list
      integer(c_int), intent(out) :: holds
      integer(c_int) :: status
    end function pw85_neighbors_holds

    !> Returns the pairs of a list and, if it has a cell, their images.
    function pw85_neighbors_list(list) result(value) bind(C, name='pw85_neighbors_list')
      import
      type(c_ptr), value :: list
      type(pw85_pair_list) :: value
    end function pw85_neighbors_list

    !> Frees a list.
    subroutine pw85_neighbors_destroy(list) bind(C, name='pw85_neighbors_destroy')
      import
      type(c_ptr), value :: list
    end subroutine pw85_neighbors_destroy

    !> Makes a mesh.
    function pw85_mesh_create(num_vertices, vertices, num_triangles, triangles, mesh) &
      result(status) bind(C, name='pw85_mesh_create')
      import
      integer(c_size_t), value :: num_vertices, num_triangles
      real(c_double), intent(in) :: vertices(3, num_vertices)
      integer(c_int32_t), intent(in) :: triangles(3, num_triangles)
      type(c_ptr), intent(out) :: mesh
      integer(c_int) :: status
    end function pw85_mesh_create

    !> Computes the contact function of an ellipsoid and a mesh.
    function pw85_mesh_contact(mesh, center, q, mu2, point, triangle) result(status) bind(C, &
      name='pw85_mesh_contact')
      import
      type(c_ptr), value :: mesh
      real(c_double), intent(in) :: center(3), q(6)
      real(c_double), intent(out), optional :: mu2, point(3)
      integer(c_int32_t), intent(out), optional :: triangle
      integer(c_int) :: status
    end function pw85_mesh_contact

    !> Tests whether an ellipsoid and a mesh overlap, μ² < 1 for any triangle.
    function pw85_mesh_overlap(mesh, center, q, overlap) result(status) bind(C, &
      name='pw85_mesh_overlap')
      import
      type(c_ptr), value :: mesh
      real(c_double), intent(in) :: center(3), q(6)
      integer(c_int), intent(out) :: overlap
      integer(c_int) :: status
    end function pw85_mesh_overlap

    !> Computes the signed distance of an ellipsoid and a mesh.
    function pw85_mesh_distance(mesh, center, q, distance, point1, point2, normal, triangle, &
      inside) result(status) bind(C, name='pw85_mesh_distance')
      import
      type(c_ptr), value :: mesh
      real(c_double), intent(in) :: center(3), q(6)
      real(c_double), intent(out), optional :: distance, point1(3), point2(3), normal(3)
      integer(c_int32_t), intent(out), optional :: triangle, inside
      integer(c_int) :: status
    end function pw85_mesh_distance

    !> Computes pw85_mesh_contact() for n ellipsoids and one mesh, in parallel, with bitwise equal
    !> results.
    function pw85_mesh_contact_batch(mesh, n, centers, q, mu2, point, triangle) result(status) &
      bind(C, name='pw85_mesh_contact_batch')
      import
      integer(c_size_t), value :: n
      type(c_ptr), value :: mesh
      real(c_double), intent(in) :: centers(3, n), q(6, n)
      real(c_double), intent(out), optional :: mu2(n), point(3, n)
      integer(c_int32_t), intent(out), optional :: triangle(n)
      integer(c_int) :: status
    end function pw85_mesh_contact_batch

    !> Computes pw85_mesh_overlap() for n ellipsoids and one mesh, in parallel.
    function pw85_mesh_overlap_batch(mesh, n, centers, q, overlap) result(status) bind(C, &
      name='pw85_mesh_overlap_batch')
      import
      integer(c_size_t), value :: n
      type(c_ptr), value :: mesh
      real(c_double), intent(in) :: centers(3, n), q(6, n)
      integer(c_int8_t), intent(out) :: overlap(n)
      integer(c_int) :: status
    end function pw85_mesh_overlap_batch

    !> Computes pw85_mesh_distance() for n ellipsoids and one mesh, in parallel, with bitwise equal
    !> results.
    function pw85_mesh_distance_batch(mesh, n, centers, q, distance, point1, point2, normal, &
      triangle, inside) result(status) bind(C, name='pw85_mesh_distance_batch')
      import
      integer(c_size_t), value :: n
      type(c_ptr), value :: mesh
      real(c_double), intent(in) :: centers(3, n), q(6, n)
      real(c_double), intent(out), optional :: distance(n), point1(3, n), point2(3, n), normal(3, n)
      integer(c_int32_t), intent(out), optional :: triangle(n), inside(n)
      integer(c_int) :: status
    end function pw85_mesh_distance_batch

    !> Frees a mesh.
    subroutine pw85_mesh_destroy(mesh) bind(C, name='pw85_mesh_destroy')
      import
      type(c_ptr), value :: mesh
    end subroutine pw85_mesh_destroy

  end interface

  ! pw85_simulation_state.h
  interface

    !> Makes a simulation.
    function pw85_hard_ellipsoids_create(system, semi_axes, quaternions, seed, pair, simulation) &
      result(status) bind(C, name='pw85_hard_ellipsoids_create')
      import
      type(pw85_system), intent(in) :: system
      integer(c_size_t), value :: seed
      real(c_double), intent(in) :: semi_axes(3, system%num_particles), quaternions(4, &
        system%num_particles)
      integer(c_int32_t), intent(out), optional :: pair(2)
      type(c_ptr), intent(out) :: simulation
      integer(c_int) :: status
    end function pw85_hard_ellipsoids_create

    !> Sets the number of dimensions of a simulation.
    function pw85_hard_ellipsoids_set_dimensions(simulation, dimensions) result(status) bind(C, &
      name='pw85_hard_ellipsoids_set_dimensions')
      import
      type(c_ptr), value :: simulation
      integer(c_int), value :: dimensions
      integer(c_int) :: status
    end function pw85_hard_ellipsoids_set_dimensions

    !> Returns the number of dimensions of a simulation.
    function pw85_hard_ellipsoids_dimensions(simulation, dimensions) result(status) bind(C, &
      name='pw85_hard_ellipsoids_dimensions')
      import
      type(c_ptr), value :: simulation
      integer(c_int), intent(out) :: dimensions
      integer(c_int) :: status
    end function pw85_hard_ellipsoids_dimensions

    !> Frees a simulation.
    subroutine pw85_hard_ellipsoids_destroy(simulation) bind(C, name='pw85_hard_ellipsoids_destroy')
      import
      type(c_ptr), value :: simulation
    end subroutine pw85_hard_ellipsoids_destroy

    !> Returns the particles and the cell.
    function pw85_hard_ellipsoids_system(simulation) result(value) bind(C, &
      name='pw85_hard_ellipsoids_system')
      import
      type(c_ptr), value :: simulation
      type(pw85_system) :: value
    end function pw85_hard_ellipsoids_system

    !> Returns the orientations, num_particles×4.
    function pw85_hard_ellipsoids_quaternions(simulation) result(value) bind(C, &
      name='pw85_hard_ellipsoids_quaternions')
      import
      type(c_ptr), value :: simulation
      type(c_ptr) :: value
    end function pw85_hard_ellipsoids_quaternions

    !> Returns the semi-axes, num_particles×3.
    function pw85_hard_ellipsoids_semi_axes(simulation) result(value) bind(C, &
      name='pw85_hard_ellipsoids_semi_axes')
      import
      type(c_ptr), value :: simulation
      type(c_ptr) :: value
    end function pw85_hard_ellipsoids_semi_axes

    !> Returns the number of bytes that pw85_hard_ellipsoids_save() writes.
    function pw85_hard_ellipsoids_num_bytes(simulation) result(value) bind(C, &
      name='pw85_hard_ellipsoids_num_bytes')
      import
      type(c_ptr), value :: simulation
      integer(c_size_t) :: value
    end function pw85_hard_ellipsoids_num_bytes

    !> Writes the whole state of a simulation as bytes.
    function pw85_hard_ellipsoids_save(simulation, num_bytes, bytes) result(status) bind(C, &
      name='pw85_hard_ellipsoids_save')
      import
      integer(c_size_t), value :: num_bytes
      type(c_ptr), value :: simulation
      integer(c_int8_t), intent(out) :: bytes(num_bytes)
      integer(c_int) :: status
    end function pw85_hard_ellipsoids_save

    !> Makes a simulation from the bytes of a saved one.
    function pw85_hard_ellipsoids_restore(num_bytes, bytes, simulation) result(status) bind(C, &
      name='pw85_hard_ellipsoids_restore')
      import
      integer(c_size_t), value :: num_bytes
      integer(c_int8_t), intent(in) :: bytes(num_bytes)
      type(c_ptr), intent(out) :: simulation
      integer(c_int) :: status
    end function pw85_hard_ellipsoids_restore

  end interface

  ! pw85_simulation_surroundings.h
  interface

    !> Sets the hard walls of a simulation, and removes the walls that it had.
    function pw85_hard_ellipsoids_set_walls(simulation, num_walls, walls, overlap) result(status) &
      bind(C, name='pw85_hard_ellipsoids_set_walls')
      import
      integer(c_size_t), value :: num_walls
      type(c_ptr), value :: simulation
      type(pw85_wall), intent(in) :: walls(num_walls)
      integer(c_int32_t), intent(out), optional :: overlap(2)
      integer(c_int) :: status
    end function pw85_hard_ellipsoids_set_walls

    !> Sets the hard mesh of a simulation, and removes the mesh that it had.
    function pw85_hard_ellipsoids_set_mesh(simulation, num_vertices, vertices, num_triangles, &
      triangles, overlap) result(status) bind(C, name='pw85_hard_ellipsoids_set_mesh')
      import
      integer(c_size_t), value :: num_vertices, num_triangles
      type(c_ptr), value :: simulation
      real(c_double), intent(in) :: vertices(3, num_vertices)
      integer(c_int32_t), intent(in) :: triangles(3, num_triangles)
      integer(c_int32_t), intent(out), optional :: overlap(2)
      integer(c_int) :: status
    end function pw85_hard_ellipsoids_set_mesh

    !> Sets the fields of a simulation, and removes the fields that it had.
    function pw85_hard_ellipsoids_set_fields(simulation, num_fields, fields) result(status) &
      bind(C, name='pw85_hard_ellipsoids_set_fields')
      import
      integer(c_size_t), value :: num_fields
      type(c_ptr), value :: simulation
      type(pw85_field), intent(in) :: fields(num_fields)
      integer(c_int) :: status
    end function pw85_hard_ellipsoids_set_fields

    !> Sets the potential of a simulation, in addition to its fields, or removes it.
    function pw85_hard_ellipsoids_set_potential(simulation, potential, context) result(status) &
      bind(C, name='pw85_hard_ellipsoids_set_potential')
      import
      type(c_ptr), value :: simulation
      type(c_funptr), value :: potential
      type(c_ptr), value :: context
      integer(c_int) :: status
    end function pw85_hard_ellipsoids_set_potential

    !> Sets or removes a pair potential in addition to the hard cores.
    function pw85_hard_ellipsoids_set_law(simulation, law) result(status) bind(C, &
      name='pw85_hard_ellipsoids_set_law')
      import
      type(pw85_law), intent(in), optional :: law
      type(c_ptr), value :: simulation
      integer(c_int) :: status
    end function pw85_hard_ellipsoids_set_law

  end interface

  ! pw85_simulation_trials.h
  interface

    !> Makes sweeps.
    function pw85_hard_ellipsoids_sweep(simulation, num_sweeps) result(status) bind(C, &
      name='pw85_hard_ellipsoids_sweep')
      import
      integer(c_size_t), value :: num_sweeps
      type(c_ptr), value :: simulation
      integer(c_int) :: status
    end function pw85_hard_ellipsoids_sweep

    !> Makes event chains, which translate many particles at once and give the pressure.
    function pw85_hard_ellipsoids_chain(simulation, num_chains, length, direction, &
      compressibility) result(status) bind(C, name='pw85_hard_ellipsoids_chain')
      import
      integer(c_size_t), value :: num_chains
      type(c_ptr), value :: simulation
      real(c_double), value :: length
      real(c_double), intent(in), optional :: direction(3)
      real(c_double), intent(out), optional :: compressibility
      integer(c_int) :: status
    end function pw85_hard_ellipsoids_chain

    !> Makes volume moves.
    function pw85_hard_ellipsoids_volume_moves(simulation, num_moves, pressure, change) &
      result(status) bind(C, name='pw85_hard_ellipsoids_volume_moves')
      import
      integer(c_size_t), value :: num_moves
      type(c_ptr), value :: simulation
      real(c_double), value :: pressure
      integer(c_int), value :: change
      integer(c_int) :: status
    end function pw85_hard_ellipsoids_volume_moves

    !> Makes sweeps, and adjusts the step sizes after each sweep towards an acceptance ratio.
    function pw85_hard_ellipsoids_tune(simulation, num_sweeps, acceptance, pressure, change) &
      result(status) bind(C, name='pw85_hard_ellipsoids_tune')
      import
      integer(c_size_t), value :: num_sweeps
      type(c_ptr), value :: simulation
      real(c_double), value :: acceptance, pressure
      integer(c_int), value :: change
      integer(c_int) :: status
    end function pw85_hard_ellipsoids_tune

    !> Sets which fractions of the trials of a sweep are translations, rotations, both at once, and
    !> exchanges.
    function pw85_hard_ellipsoids_set_fractions(simulation, fractions) result(status) bind(C, &
      name='pw85_hard_ellipsoids_set_fractions')
      import
      type(c_ptr), value :: simulation
      real(c_double), intent(in) :: fractions(4)
      integer(c_int) :: status
    end function pw85_hard_ellipsoids_set_fractions

    !> Sets the step sizes.
    function pw85_hard_ellipsoids_set_steps(simulation, steps) result(status) bind(C, &
      name='pw85_hard_ellipsoids_set_steps')
      import
      type(c_ptr), value :: simulation
      real(c_double), intent(in) :: steps(3)
      integer(c_int) :: status
    end function pw85_hard_ellipsoids_set_steps

    !> Returns the step sizes.
    function pw85_hard_ellipsoids_steps(simulation, steps) result(status) bind(C, &
      name='pw85_hard_ellipsoids_steps')
      import
      type(c_ptr), value :: simulation
      real(c_double), intent(out) :: steps(3)
      integer(c_int) :: status
    end function pw85_hard_ellipsoids_steps

    !> Sets the largest translations and rotations of some species, and removes all step sizes of
    !> species that were set before.
    function pw85_hard_ellipsoids_set_kind_steps(simulation, num_kinds, semi_axes, steps) &
      result(status) bind(C, name='pw85_hard_ellipsoids_set_kind_steps')
      import
      integer(c_size_t), value :: num_kinds
      type(c_ptr), value :: simulation
      real(c_double), intent(in) :: semi_axes(3, num_kinds), steps(2, num_kinds)
      integer(c_int) :: status
    end function pw85_hard_ellipsoids_set_kind_steps

    !> Returns the largest translations and rotations of some species, which are particles with the
    !> same semi-axes.
    function pw85_hard_ellipsoids_kind_steps(simulation, num_kinds, semi_axes, steps) &
      result(status) bind(C, name='pw85_hard_ellipsoids_kind_steps')
      import
      integer(c_size_t), value :: num_kinds
      type(c_ptr), value :: simulation
      real(c_double), intent(in) :: semi_axes(3, num_kinds)
      real(c_double), intent(out) :: steps(2, num_kinds)
      integer(c_int) :: status
    end function pw85_hard_ellipsoids_kind_steps

    !> Returns the numbers of trials since the simulation was made or tuned.
    function pw85_hard_ellipsoids_counts(simulation, trials, accepted) result(status) bind(C, &
      name='pw85_hard_ellipsoids_counts')
      import
      type(c_ptr), value :: simulation
      integer(c_int64_t), intent(out), optional :: trials(5), accepted(5)
      integer(c_int) :: status
    end function pw85_hard_ellipsoids_counts

  end interface

  ! pw85_simulation_insertions.h
  interface

    !> Tests whether a particle would have no overlaps at another position, and on request moves it
    !> there.
    function pw85_hard_ellipsoids_try(simulation, particle, center, quaternion, take, is_free) &
      result(status) bind(C, name='pw85_hard_ellipsoids_try')
      import
      integer(c_size_t), value :: particle
      type(c_ptr), value :: simulation
      real(c_double), intent(in), optional :: center(3), quaternion(4)
      integer(c_int), value :: take
      integer(c_int), intent(out) :: is_free
      integer(c_int) :: status
    end function pw85_hard_ellipsoids_try

    !> Tests whether a new particle would have no overlaps, and on request inserts it as the last
    !> particle.
    function pw85_hard_ellipsoids_insert(simulation, center, quaternion, semi_axes, take, is_free) &
      result(status) bind(C, name='pw85_hard_ellipsoids_insert')
      import
      type(c_ptr), value :: simulation
      real(c_double), intent(in) :: center(3), quaternion(4), semi_axes(3)
      integer(c_int), value :: take
      integer(c_int), intent(out) :: is_free
      integer(c_int) :: status
    end function pw85_hard_ellipsoids_insert

    !> Removes a particle.
    function pw85_hard_ellipsoids_remove(simulation, particle) result(status) bind(C, &
      name='pw85_hard_ellipsoids_remove')
      import
      integer(c_size_t), value :: particle
      type(c_ptr), value :: simulation
      integer(c_int) :: status
    end function pw85_hard_ellipsoids_remove

    !> Computes the mean of e^(-βU) over trial insertions of a particle at random positions (Widom's
    !> method).
    function pw85_hard_ellipsoids_insertion_weight(simulation, num_trials, semi_axes, weight) &
      result(status) bind(C, name='pw85_hard_ellipsoids_insertion_weight')
      import
      integer(c_size_t), value :: num_trials
      type(c_ptr), value :: simulation
      real(c_double), intent(in) :: semi_axes(3)
      real(c_double), intent(out) :: weight
      integer(c_int) :: status
    end function pw85_hard_ellipsoids_insertion_weight

    !> Makes trial insertions and removals of particles at constant activities.
    function pw85_hard_ellipsoids_insertion_moves(simulation, num_moves, num_kinds, semi_axes, &
      activities, counts) result(status) bind(C, name='pw85_hard_ellipsoids_insertion_moves')
      import
      integer(c_size_t), value :: num_moves, num_kinds
      type(c_ptr), value :: simulation
      real(c_double), intent(in) :: semi_axes(3, num_kinds), activities(num_kinds)
      integer(c_int64_t), intent(out), optional :: counts(4)
      integer(c_int) :: status
    end function pw85_hard_ellipsoids_insertion_moves

  end interface

  ! pw85_simulation_observations.h
  interface

    !> Computes the sum of the energies of all particles in the fields and the potential, and of all
    !> pairs by the law, in units of k_B T.
    function pw85_hard_ellipsoids_energy(simulation, energy) result(status) bind(C, &
      name='pw85_hard_ellipsoids_energy')
      import
      type(c_ptr), value :: simulation
      real(c_double), intent(out) :: energy
      integer(c_int) :: status
    end function pw85_hard_ellipsoids_energy

    !> Computes the virial of the pair potential, W = -2 Σ μ² dβU/dμ², which adds to the pressure of
    !> the hard cores.
    function pw85_hard_ellipsoids_law_virial(simulation, virial) result(status) bind(C, &
      name='pw85_hard_ellipsoids_law_virial')
      import
      type(c_ptr), value :: simulation
      real(c_double), intent(out) :: virial
      integer(c_int) :: status
    end function pw85_hard_ellipsoids_law_virial

    !> Lists the images of particles whose bounding boxes intersect that of a given particle.
    function pw85_hard_ellipsoids_neighbors(simulation, particle, capacity, count, particles, &
      images, separations) result(status) bind(C, name='pw85_hard_ellipsoids_neighbors')
      import
      integer(c_size_t), value :: particle, capacity
      type(c_ptr), value :: simulation
      integer(c_size_t), intent(out) :: count
      integer(c_int32_t), intent(out), optional :: particles(capacity), images(3, capacity)
      real(c_double), intent(out), optional :: separations(3, capacity)
      integer(c_int) :: status
    end function pw85_hard_ellipsoids_neighbors

    !> Searches all particles for overlaps.
    function pw85_hard_ellipsoids_check(simulation, pair) result(status) bind(C, &
      name='pw85_hard_ellipsoids_check')
      import
      type(c_ptr), value :: simulation
      integer(c_int32_t), intent(out), optional :: pair(2)
      integer(c_int) :: status
    end function pw85_hard_ellipsoids_check

    !> Computes the factor by which the cell and the centres can be compressed until particles
    !> touch, and on request compresses them.
    function pw85_hard_ellipsoids_compress(simulation, take, factor) result(status) bind(C, &
      name='pw85_hard_ellipsoids_compress')
      import
      type(c_ptr), value :: simulation
      integer(c_int), value :: take
      real(c_double), intent(out) :: factor
      integer(c_int) :: status
    end function pw85_hard_ellipsoids_compress

  end interface

  ! pw85_simulation_addition.h
  interface

    !> Makes an empty periodic cell for random sequential addition (RSA). Row k in C is cell(:, k).
    function pw85_random_addition_create(dimensions, cell, num_kinds, semi_axes, seed, addition) &
      result(status) bind(C, name='pw85_random_addition_create')
      import
      integer(c_size_t), value :: num_kinds, seed
      integer(c_int), value :: dimensions
      real(c_double), intent(in) :: cell(3, 3), semi_axes(3, num_kinds)
      type(c_ptr), intent(out) :: addition
      integer(c_int) :: status
    end function pw85_random_addition_create

    !> Makes some attempts, at least one unless the addition is at its end.
    function pw85_random_addition_advance(addition, attempts, num_particles, end) result(status) &
      bind(C, name='pw85_random_addition_advance')
      import
      integer(c_size_t), value :: num_particles
      type(c_ptr), value :: addition
      real(c_double), value :: attempts
      integer(c_int), intent(out) :: end
      integer(c_int) :: status
    end function pw85_random_addition_advance

    !> Returns the progress of an addition.
    function pw85_random_addition_state(addition, num_particles, attempts, free_share) &
      result(status) bind(C, name='pw85_random_addition_state')
      import
      type(c_ptr), value :: addition
      integer(c_size_t), intent(out) :: num_particles
      real(c_double), intent(out) :: attempts, free_share
      integer(c_int) :: status
    end function pw85_random_addition_state

    !> Copies the particles of an addition, in the order in which they were added.
    function pw85_random_addition_particles(addition, num_particles, centers, quaternions, kinds) &
      result(status) bind(C, name='pw85_random_addition_particles')
      import
      integer(c_size_t), value :: num_particles
      type(c_ptr), value :: addition
      real(c_double), intent(out) :: centers(3, num_particles)
      real(c_double), intent(out), optional :: quaternions(4, num_particles)
      integer(c_int32_t), intent(out), optional :: kinds(num_particles)
      integer(c_int) :: status
    end function pw85_random_addition_particles

    !> Frees a random sequential addition.
    subroutine pw85_random_addition_destroy(addition) bind(C, name='pw85_random_addition_destroy')
      import
      type(c_ptr), value :: addition
    end subroutine pw85_random_addition_destroy

  end interface

  ! pw85_legacy.h
  interface

    !> Computes the determinant of a symmetric matrix.
    function pw85_legacy__det_sym(a) result(value) bind(C, name='pw85_legacy__det_sym')
      import
      real(c_double), intent(in) :: a(6)
      real(c_double) :: value
    end function pw85_legacy__det_sym

    !> Computes the quadratic form of the adjugate (the transpose of the matrix of cofactors).
    function pw85_legacy__xt_adja_x(x, a) result(value) bind(C, name='pw85_legacy__xT_adjA_x')
      import
      real(c_double), intent(in) :: x(3), a(6)
      real(c_double) :: value
    end function pw85_legacy__xt_adja_x

    !> Computes the coefficients of det[(1-λ) Q1 + λ Q2] in increasing powers of λ.
    subroutine pw85_legacy__detq_as_poly(q1, q2, q3, q4, b) bind(C, &
      name='pw85_legacy__detQ_as_poly')
      import
      real(c_double), intent(in) :: q1(6), q2(6), q3(6), q4(6)
      real(c_double), intent(out) :: b(4)
    end subroutine pw85_legacy__detq_as_poly

    !> Computes the coefficients of rᵀ adj[(1-λ) Q1 + λ Q2] r in increasing powers of λ.
    subroutine pw85_legacy__rt_adjq_r_as_poly(r, q1, q2, q3, a) bind(C, &
      name='pw85_legacy__rT_adjQ_r_as_poly')
      import
      real(c_double), intent(in) :: r(3), q1(6), q2(6), q3(6)
      real(c_double), intent(out) :: a(3)
    end subroutine pw85_legacy__rt_adjq_r_as_poly

    !> Computes f(λ) and its derivatives by factorisation.
    function pw85_legacy_f1(lambda, r12, q1, q2, out) result(value) bind(C, name='pw85_legacy_f1')
      import
      real(c_double), value :: lambda
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      real(c_double), intent(out), optional :: out(3)
      real(c_double) :: value
    end function pw85_legacy_f1

    !> Computes f(λ) as a rational function of λ.
    function pw85_legacy_f2(lambda, r12, q1, q2, out) result(value) bind(C, name='pw85_legacy_f2')
      import
      real(c_double), value :: lambda
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      real(c_double), intent(out), optional :: out(1)
      real(c_double) :: value
    end function pw85_legacy_f2

    !> Computes f(λ) and its derivatives as a rational function of λ.
    subroutine pw85_legacy_f2_derivatives(lambda, r12, q1, q2, out) bind(C, &
      name='pw85_legacy_f2_derivatives')
      import
      real(c_double), value :: lambda
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      real(c_double), intent(out) :: out(3)
    end subroutine pw85_legacy_f2_derivatives

    !> Computes the contact function by plain Newton-Raphson iterations on f' from λ = 1/2, which
    !> often fail.
    function pw85_legacy_contact_function1(r12, q1, q2, out) result(status) bind(C, &
      name='pw85_legacy_contact_function1')
      import
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      real(c_double), intent(out) :: out(2)
      integer(c_int) :: status
    end function pw85_legacy_contact_function1

    !> Computes the contact function by bisection on the numerator of f' in rational form.
    function pw85_legacy_contact_function2(r12, q1, q2, out) result(status) bind(C, &
      name='pw85_legacy_contact_function2')
      import
      real(c_double), intent(in) :: r12(3), q1(6), q2(6)
      real(c_double), intent(out) :: out(2)
      integer(c_int) :: status
    end function pw85_legacy_contact_function2

  end interface

  ! pw85_zheng.h
  interface

    !> Computes the distance of closest approach of two ellipses, in closed form (the root of a
    !> quartic).
    function pw85_zheng_ellipses(direction, q1, q2, distance) result(status) bind(C, &
      name='pw85_zheng_ellipses')
      import
      real(c_double), intent(in) :: direction(2), q1(3), q2(3)
      real(c_double), intent(out) :: distance
      integer(c_int) :: status
    end function pw85_zheng_ellipses

    !> Computes the distance of closest approach of two ellipsoids.
    function pw85_zheng_ellipsoids(direction, q1, q2, distance) result(status) bind(C, &
      name='pw85_zheng_ellipsoids')
      import
      real(c_double), intent(in) :: direction(3), q1(6), q2(6)
      real(c_double), intent(out) :: distance
      integer(c_int) :: status
    end function pw85_zheng_ellipsoids

  end interface

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
