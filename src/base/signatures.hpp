// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The parameters and arguments of functions that are compiled once (attributes.hpp), as
/// define(name, (parameters), (arguments)).
//
// Made from the headers by api/committed.py.
// clang-format off
#ifndef PW85_BASE_SIGNATURES_HPP_INCLUDED
#define PW85_BASE_SIGNATURES_HPP_INCLUDED

#define PW85_SIGNATURE_advance_until_spheres_meet(define, T, D) \
    define(advance_until_spheres_meet, (MovingEllipsoids<T, D> &moving), (moving))
#define PW85_SIGNATURE_area_derivatives_finely(define, T) \
    define(area_derivatives_finely, (JointFrame<T, 2> const &frame), (frame))
#define PW85_SIGNATURE_box_overlaps_exactly(define, T) \
    define(box_overlaps_exactly, (Vector<T, 3> const &lower, Vector<T, 3> const &upper, \
           SymmetricMatrix<T, 3> const &q), (lower, upper, q))
#define PW85_SIGNATURE_call_contains(define, T, D) \
    define(call_contains, (Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, \
           SymmetricMatrix<T, D> const &q2), (r12, q1, q2))
#define PW85_SIGNATURE_call_overlap(define, T, D) \
    define(call_overlap, (Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, \
           SymmetricMatrix<T, D> const &q2), (r12, q1, q2))
#define PW85_SIGNATURE_check_planes(define, T) \
    define(check_planes, (Polytope<T> const &polytope), (polytope))
#define PW85_SIGNATURE_compare_exactly(define, T, D) \
    define(compare_exactly, (Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, \
           SymmetricMatrix<T, D> const &q2, exact::BinaryFraction<T> const &m), (r12, q1, q2, m))
#define PW85_SIGNATURE_contact_points_scaled(define, T, N, Find) \
    define(contact_points_scaled, (Vector<T, 3> const (&points)[N], SymmetricMatrix<T, 3> const \
           &q, Find const &find), (points, q, find))
#define PW85_SIGNATURE_contact_polytope_exactly(define, T) \
    define(contact_polytope_exactly, (std::size_t n, T const *normals, T const *offsets, \
           SymmetricMatrix<T, 3> const &q, Vector<T, 3> const &center), (n, normals, offsets, q, \
           center))
#define PW85_SIGNATURE_contact_with_all_digits(define, T, N, Find) \
    define(contact_with_all_digits, (Vector<T, 3> const (&points)[N], SymmetricMatrix<T, 3> const \
           &q, Find const &find), (points, q, find))
#define PW85_SIGNATURE_contains_exactly(define, T, D) \
    define(contains_exactly, (Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, \
           SymmetricMatrix<T, D> const &q2), (r12, q1, q2))
#define PW85_SIGNATURE_curvature_finer(define, T) \
    define(curvature_finer, (Vector<T, 3> const &normal, SymmetricMatrix<T, 3> const &scaled), \
           (normal, scaled))
#define PW85_SIGNATURE_decide_by_certified_value(define, T, D) \
    define(decide_by_certified_value, (Pair<T, D> const &pair, T const &tangent), (pair, tangent))
#define PW85_SIGNATURE_decide_by_extended(define, T, D) \
    define(decide_by_extended, (Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, \
           SymmetricMatrix<T, D> const &q2, T const &lambda), (r12, q1, q2, lambda))
#define PW85_SIGNATURE_decide_exactly(define, T, D) \
    define(decide_exactly, (Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, \
           SymmetricMatrix<T, D> const &q2), (r12, q1, q2))
#define PW85_SIGNATURE_decide_factored_exactly(define, T, D) \
    define(decide_factored_exactly, (Vector<T, D> const &r12, Factor<T, D> const &s1, Factor<T, D> \
           const &s2), (r12, s1, s2))
#define PW85_SIGNATURE_decide_polytope(define, T) \
    define(decide_polytope, (Polytope<T> const &given), (given))
#define PW85_SIGNATURE_find_capsule_finer(define, T) \
    define(find_capsule_finer, (Capsule<T> const &capsule, SymmetricMatrix<T, 3> const &q), \
           (capsule, q))
#define PW85_SIGNATURE_find_closest_passage_wider(define, T) \
    define(find_closest_passage_wider, (StraightPath<T> const &path), (path))
#define PW85_SIGNATURE_find_finer(define, T, N, Find) \
    define(find_finer, (Vector<T, 3> const (&points)[N], SymmetricMatrix<T, 3> const &q, Find \
           const &find), (points, q, find))
#define PW85_SIGNATURE_find_with_all_digits(define, T) \
    define(find_with_all_digits, (Capsule<T> const &capsule, SymmetricMatrix<T, 3> const &q), \
           (capsule, q))
#define PW85_SIGNATURE_form_of_any_axes(define, T) \
    define(form_of_any_axes, (Vector<T, 3> const &semi_axes, Vector<T, 4> const &quaternion), \
           (semi_axes, quaternion))
#define PW85_SIGNATURE_gap_contained(define, T, D) \
    define(gap_contained, (Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, \
           SymmetricMatrix<T, D> const &q2), (r12, q1, q2))
#define PW85_SIGNATURE_gap_curvatures_finer(define, T) \
    define(gap_curvatures_finer, (CurvedWall<T> const &wall, SymmetricMatrix<T, 3> const &scaled), \
           (wall, scaled))
#define PW85_SIGNATURE_has_positive_minors(define, T, D) \
    define(has_positive_minors, (SymmetricMatrix<T, D> const &a), (a))
#define PW85_SIGNATURE_hertz_facing_finer(define, T) \
    define(hertz_facing_finer, (DistancePair<T, 3> const &pair, Vector<T, 3> const &normal), \
           (pair, normal))
#define PW85_SIGNATURE_last_factorized_evaluation(define, T, D) \
    define(last_factorized_evaluation, (Pair<T, D> const &pair, Candidate<T> const &candidate, \
           Precision precision), (pair, candidate, precision))
#define PW85_SIGNATURE_maximize(define, T, D) \
    define(maximize, (Pair<T, D> const &pair), (pair))
#define PW85_SIGNATURE_maximize_factorized(define, T, D) \
    define(maximize_factorized, (Pair<T, D> const &pair, Candidate<T> const &start, int \
           evaluations), (pair, start, evaluations))
#define PW85_SIGNATURE_maximize_precisely(define, T, D) \
    define(maximize_precisely, (ScaledPair<T, D> const &scaled, Vector<T, D> const &r12), (scaled, \
           r12))
#define PW85_SIGNATURE_maximize_wider(define, T, D) \
    define(maximize_wider, (Pair<T, D> const &pair, T const &t, int evaluations), (pair, t, \
           evaluations))
#define PW85_SIGNATURE_measure_of(define, T, D) \
    define(measure_of, (SymmetricMatrix<T, D> const &q), (q))
#define PW85_SIGNATURE_measure_part_finely(define, T, D) \
    define(measure_part_finely, (Vector<T, D> const &r12, SymmetricMatrix<T, D> const &q1, \
           SymmetricMatrix<T, D> const &q2), (r12, q1, q2))
#define PW85_SIGNATURE_minimize_dual_wider(define, T, D) \
    define(minimize_dual_wider, (Pair<T, D> const &pair), (pair))
#define PW85_SIGNATURE_overlap_of_any(define, T, Shape) \
    define(overlap_of_any, (Shape const &shape, SymmetricMatrix<T, 3> const &q), (shape, q))
#define PW85_SIGNATURE_overlaps_exactly(define, T, N) \
    define(overlaps_exactly, (Vector<T, 3> const (&points)[N], SymmetricMatrix<T, 3> const &q), \
           (points, q))
#define PW85_SIGNATURE_overlaps_with_more_digits(define, T) \
    define(overlaps_with_more_digits, (Capsule<T> const &capsule, SymmetricMatrix<T, 3> const &q), \
           (capsule, q))
#define PW85_SIGNATURE_part_derivatives_finely(define, T) \
    define(part_derivatives_finely, (Vector<T, 3> const &r12, SymmetricMatrix<T, 3> const &q1, \
           SymmetricMatrix<T, 3> const &q2), (r12, q1, q2))
#define PW85_SIGNATURE_plane_from_afar(define, T, D) \
    define(plane_from_afar, (Pair<T, D> const &pair, Vector<T, D> const &velocity, T const &end), \
           (pair, velocity, end))
#define PW85_SIGNATURE_plane_of_translation(define, T, D) \
    define(plane_of_translation, (ScaledPair<T, D> const &scaled, Vector<T, D> const &velocity, T \
           const &end), (scaled, velocity, end))
#define PW85_SIGNATURE_plane_part_derivatives_finely(define, T) \
    define(plane_part_derivatives_finely, (Vector<T, 2> const &r12, SymmetricMatrix<T, 2> const \
           &q1, SymmetricMatrix<T, 2> const &q2), (r12, q1, q2))
#define PW85_SIGNATURE_polytope_overlaps_exactly(define, T) \
    define(polytope_overlaps_exactly, (std::size_t n, T const *normals, T const *offsets, \
           SymmetricMatrix<T, 3> const &q, Vector<T, 3> const &center), (n, normals, offsets, q, \
           center))
#define PW85_SIGNATURE_reciprocal(define, T) \
    define(reciprocal, (Extended<T> const &x), (x))
#define PW85_SIGNATURE_refined_derivatives(define, T) \
    define(refined_derivatives, (DistancePair<T, 3> const &pair, FoundSlab<T, 3> const &slab), \
           (pair, slab))
#define PW85_SIGNATURE_refined_distance(define, T, D) \
    define(refined_distance, (DistancePair<T, D> const &pair, FoundSlab<T, D> const &slab), (pair, \
           slab))
#define PW85_SIGNATURE_rim_frame_finely(define, T) \
    define(rim_frame_finely, (JointFrame<T, 3> const &frame), (frame))
#define PW85_SIGNATURE_round_by_doubled_numbers(define, T, D) \
    define(round_by_doubled_numbers, (Pair<T, D> const &pair, ScaledPair<T, D> const &scaled, \
           MaximumBounds<T> const &bounds), (pair, scaled, bounds))
#define PW85_SIGNATURE_search_doubled(define, T, D) \
    define(search_doubled, (FactoredPair<T, D> const &pair, T const &t), (pair, t))
#define PW85_SIGNATURE_search_in_steps(define, T, D) \
    define(search_in_steps, (Pair<T, D> const &pair, Candidate<T> &candidate, Precision precision, \
           int &evaluations, int max_steps), (pair, candidate, precision, evaluations, max_steps))
#define PW85_SIGNATURE_search_polytope(define, T) \
    define(search_polytope, (Polytope<T> const &polytope, T const &limit), (polytope, limit))
#define PW85_SIGNATURE_sheet_moments(define, T, D) \
    define(sheet_moments, (SymmetricMatrix<T, D> const &q), (q))
#define PW85_SIGNATURE_solve_blend_extended(define, T, D) \
    define(solve_blend_extended, (T const &w1, SymmetricMatrix<T, D> const &q1, T const &w2, \
           SymmetricMatrix<T, D> const &q2, Vector<T, D> const &x), (w1, q1, w2, q2, x))
#define PW85_SIGNATURE_sqrt(define, T) \
    define(sqrt, (Extended<T> const &x), (x))
#define PW85_SIGNATURE_surface_of(define, T, D) \
    define(surface_of, (SymmetricMatrix<T, D> const &q), (q))
#define PW85_SIGNATURE_validate_pair(define, T, D) \
    define(validate_pair, (Pair<T, D> const &pair, ScaledPair<T, D> &scaled), (pair, scaled))
#define PW85_SIGNATURE_validate_scaled(define, T, D) \
    define(validate_scaled, (SymmetricMatrix<T, D> const &q), (q))

#endif
