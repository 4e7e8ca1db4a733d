/* SPDX-License-Identifier: BSD-3-Clause */
/* The functions of ellipsoids: made by api/octave.py from the headers of the C API. */
/* clang-format off */
#include "pw85_octave.h"

static int area_2(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_area_batch_2d(n, in[0], out[0]);
}

static int bounding_boxes_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_bounding_boxes(n, in[0], out[0]);
}

static int closest_approach_2(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_closest_approach_batch_2d(n, in[0], in[1], in[2], out[0]);
}

static int closest_approach_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_closest_approach_batch(n, in[0], in[1], in[2], out[0]);
}

static int closest_passage_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    for (*row = 0; *row < n; ++*row) {
        size_t const i = *row;
        int const status = pw85_closest_passage(in[0] + 3 * i, in[1] + 6 * i, in[2] + 6 * i, in[3] +
            3 * i, in[4][i], (double *)out[0] + 1 * i, (double *)out[1] + 1 * i);
        if (status != 0) return status;
    }
    return 0;
}

static int compare_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    for (*row = 0; *row < n; ++*row) {
        size_t const i = *row;
        int integer0;
        int const status = pw85_compare(in[0] + 3 * i, in[1] + 6 * i, in[2] + 6 * i, in[3][i],
            &integer0);
        if (status != 0) return status;
        ((double *)out[0])[i] = (double)integer0;
    }
    return 0;
}

static int condition_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_condition_batch(n, in[0], in[1], in[2], in[3], out[0]);
}

static int contact_2(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_contact_batch_2d(n, in[0], in[1], in[2], out[0], out[1]);
}

static int contact_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_contact_batch(n, in[0], in[1], in[2], out[0], out[1]);
}

static int contact_derivatives_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_contact_derivatives_batch(n, in[0], in[1], in[2], out[0], out[1], out[2], out[3],
        out[4], out[5], out[6]);
}

static int contact_function_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_contact_function_batch(n, in[0], in[1], in[2], out[0], out[1]);
}

static int contact_geometry_2(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_contact_geometry_batch_2d(n, in[0], in[1], in[2], in[3], out[0], out[1]);
}

static int contact_geometry_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_contact_geometry_batch(n, in[0], in[1], in[2], in[3], out[0], out[1]);
}

static int contact_gradient_2(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_contact_gradient_batch_2d(n, in[0], in[1], in[2], in[3], out[0], out[1], out[2]);
}

static int contact_gradient_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_contact_gradient_batch(n, in[0], in[1], in[2], in[3], out[0], out[1], out[2]);
}

static int contact_hessian_2(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_contact_hessian_batch_2d(n, in[0], in[1], in[2], in[3], out[0]);
}

static int contact_hessian_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_contact_hessian_batch(n, in[0], in[1], in[2], in[3], out[0]);
}

static int contact_rounded_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_contact_rounded_batch(n, in[0], in[1], in[2], out[0], out[1]);
}

static int contact_torque_2(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_contact_torque_batch_2d(n, in[0], in[1], in[2], in[3], out[0], out[1]);
}

static int contact_torque_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_contact_torque_batch(n, in[0], in[1], in[2], in[3], out[0], out[1]);
}

static int containment_2(size_t n, double const *const *in, void *const *out, size_t *row)
{
    for (*row = 0; *row < n; ++*row) {
        size_t const i = *row;
        int const status = pw85_containment_2d(in[0] + 2 * i, in[1] + 3 * i, in[2] + 3 * i, (double
            *)out[0] + 1 * i, (double *)out[1] + 2 * i);
        if (status != 0) return status;
    }
    return 0;
}

static int containment_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_containment_batch(n, in[0], in[1], in[2], out[0], out[1]);
}

static int contains_2(size_t n, double const *const *in, void *const *out, size_t *row)
{
    for (*row = 0; *row < n; ++*row) {
        size_t const i = *row;
        int integer0;
        int const status = pw85_contains_2d(in[0] + 2 * i, in[1] + 3 * i, in[2] + 3 * i, &integer0);
        if (status != 0) return status;
        ((unsigned char *)out[0])[i] = (unsigned char)integer0;
    }
    return 0;
}

static int contains_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_contains_batch(n, in[0], in[1], in[2], out[0]);
}

static int distance_2(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_distance_batch_2d(n, in[0], in[1], in[2], out[0], out[1], out[2]);
}

static int distance_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_distance_batch(n, in[0], in[1], in[2], out[0], out[1], out[2]);
}

static int distance_derivatives_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_distance_derivatives_batch(n, in[0], in[1], in[2], out[0], out[1], out[2], out[3]);
}

static int distance_geometry_2(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_distance_geometry_batch_2d(n, in[0], in[1], in[2], out[0], out[1], out[2], out[3]);
}

static int distance_geometry_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_distance_geometry_batch(n, in[0], in[1], in[2], out[0], out[1], out[2], out[3]);
}

static int ellipse_2(size_t n, double const *const *in, void *const *out, size_t *row)
{
    for (*row = 0; *row < n; ++*row) {
        size_t const i = *row;
        int const status = pw85_ellipse(in[0][i], in[1][i], in[2][i], (double *)out[0] + 3 * i);
        if (status != 0) return status;
    }
    return 0;
}

static int ellipsoid_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    for (*row = 0; *row < n; ++*row) {
        size_t const i = *row;
        int const status = pw85_ellipsoid(in[0] + 3 * i, in[1] + 9 * i, (double *)out[0] + 6 * i);
        if (status != 0) return status;
    }
    return 0;
}

static int ellipsoid_quaternion_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_ellipsoid_quaternion_batch(n, in[0], in[1], out[0]);
}

static int first_contact_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    for (*row = 0; *row < n; ++*row) {
        size_t const i = *row;
        int const status = pw85_first_contact(in[0] + 3 * i, in[1] + 6 * i, in[2] + 6 * i,
            (pw85_motion const *)(in[3] + 7 * i), (pw85_motion const *)(in[4] + 7 * i), in[5][i],
            (double *)out[0] + 1 * i);
        if (status != 0) return status;
    }
    return 0;
}

static int free_path_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_free_path_batch(n, in[0], in[1], in[2], in[3], in[4], out[0]);
}

static int gap_inside_2(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_gap_inside_batch_2d(n, in[0], in[1], in[2], out[0], out[1], out[2], out[3]);
}

static int gap_inside_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_gap_inside_batch(n, in[0], in[1], in[2], out[0], out[1], out[2], out[3]);
}

static int grain_contact_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_grain_contact_batch(n, in[0], in[1], in[2], in[3], out[0], out[1], out[2], out[3],
        out[4]);
}

static int grain_radius_gradient_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_grain_radius_gradient_batch(n, in[0], in[1], in[2], in[3], out[0], out[1], out[2]);
}

static int hertz_contact_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_hertz_contact_batch(n, in[0], in[1], in[2], in[3], out[0], out[1], out[2], out[3],
        out[4], out[5]);
}

static int overlap_2(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_overlap_batch_2d(n, in[0], in[1], in[2], out[0]);
}

static int overlap_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_overlap_batch(n, in[0], in[1], in[2], out[0]);
}

static int overlap_area_2(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_overlap_area_batch_2d(n, in[0], in[1], in[2], out[0]);
}

static int overlap_area_gradient_2(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_overlap_area_gradient_batch_2d(n, in[0], in[1], in[2], out[0], out[1], out[2]);
}

static int overlap_area_torque_2(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_overlap_area_torque_batch_2d(n, in[0], in[1], in[2], out[0], out[1]);
}

static int overlap_volume_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_overlap_volume_batch(n, in[0], in[1], in[2], out[0]);
}

static int overlap_volume_gradient_3(size_t n, double const *const *in, void *const *out, size_t
    *row)
{
    (void)row;
    return pw85_overlap_volume_gradient_batch(n, in[0], in[1], in[2], out[0], out[1], out[2]);
}

static int overlap_volume_torque_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_overlap_volume_torque_batch(n, in[0], in[1], in[2], out[0], out[1]);
}

static int overlap_witness_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    for (*row = 0; *row < n; ++*row) {
        size_t const i = *row;
        int integer0;
        int const status = pw85_overlap_witness(in[0] + 3 * i, in[1] + 6 * i, in[2] + 6 * i,
            &integer0, (double *)out[1] + 1 * i, (double *)out[2] + 3 * i);
        if (status != 0) return status;
        ((double *)out[0])[i] = (double)integer0;
    }
    return 0;
}

static int penetration_2(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_penetration_batch_2d(n, in[0], in[1], in[2], out[0], out[1]);
}

static int penetration_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_penetration_batch(n, in[0], in[1], in[2], out[0], out[1]);
}

static int perimeter_2(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_perimeter_batch_2d(n, in[0], out[0]);
}

static int second_moments_2(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_second_moments_batch_2d(n, in[0], out[0]);
}

static int second_moments_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_second_moments_batch(n, in[0], out[0]);
}

static int shell_moments_2(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_shell_moments_batch_2d(n, in[0], out[0]);
}

static int shell_moments_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_shell_moments_batch(n, in[0], out[0]);
}

static int signed_distance_2(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_signed_distance_batch_2d(n, in[0], in[1], in[2], out[0], out[1], out[2]);
}

static int signed_distance_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_signed_distance_batch(n, in[0], in[1], in[2], out[0], out[1], out[2]);
}

static int signed_distance_derivatives_3(size_t n, double const *const *in, void *const *out, size_t
    *row)
{
    (void)row;
    return pw85_signed_distance_derivatives_batch(n, in[0], in[1], in[2], out[0], out[1], out[2],
        out[3]);
}

static int signed_distance_geometry_2(size_t n, double const *const *in, void *const *out, size_t
    *row)
{
    (void)row;
    return pw85_signed_distance_geometry_batch_2d(n, in[0], in[1], in[2], out[0], out[1], out[2],
        out[3]);
}

static int signed_distance_geometry_3(size_t n, double const *const *in, void *const *out, size_t
    *row)
{
    (void)row;
    return pw85_signed_distance_geometry_batch(n, in[0], in[1], in[2], out[0], out[1], out[2],
        out[3]);
}

static int surface_area_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_surface_area_batch(n, in[0], out[0]);
}

static int volume_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_volume_batch(n, in[0], out[0]);
}

struct pw85_question const pw85_questions[] = {
    {"area", 1, false, {
        [0] = {area_2, false, 1, {{"q", PW85_FORM1, 3}}, 1, {1}},
    }},
    {"bounding_boxes", 1, false, {
        [1] = {bounding_boxes_3, false, 1, {{"q", PW85_FORM1, 6}}, 1, {3}},
    }},
    {"closest_approach", 2, false, {
        [0] = {closest_approach_2, false, 3, {{"direction", PW85_VALUES, 2}, {"q1", PW85_FORM1, 3},
            {"q2", PW85_FORM2, 3}}, 1, {1}},
        [1] = {closest_approach_3, false, 3, {{"direction", PW85_VALUES, 3}, {"q1", PW85_FORM1, 6},
            {"q2", PW85_FORM2, 6}}, 1, {1}},
    }},
    {"closest_passage", 2, true, {
        [1] = {closest_passage_3, false, 5, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6},
            {"q2", PW85_FORM2, 6}, {"velocity", PW85_VALUES, 3}, {"t_max", PW85_VALUES, 1}}, 2, {1,
            1}},
    }},
    {"compare", 2, false, {
        [1] = {compare_3, false, 4, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6}, {"q2",
            PW85_FORM2, 6}, {"mu2", PW85_VALUES, 1}}, 1, {1}},
    }},
    {"condition", 2, false, {
        [1] = {condition_3, false, 4, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6}, {"q2",
            PW85_FORM2, 6}, {"lambda", PW85_VALUES, 1}}, 1, {1}},
    }},
    {"contact", 2, false, {
        [0] = {contact_2, false, 3, {{"r12", PW85_SEPARATION, 2}, {"q1", PW85_FORM1, 3}, {"q2",
            PW85_FORM2, 3}}, 2, {1, 1}},
        [1] = {contact_3, false, 3, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6}, {"q2",
            PW85_FORM2, 6}}, 2, {1, 1}},
    }},
    {"contact_derivatives", 2, false, {
        [1] = {contact_derivatives_3, false, 3, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6},
            {"q2", PW85_FORM2, 6}}, 7, {1, 1, 3, 3, 3, 3, 3}},
    }},
    {"contact_function", 2, false, {
        [1] = {contact_function_3, false, 3, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6},
            {"q2", PW85_FORM2, 6}}, 2, {1, 1}},
    }},
    {"contact_geometry", 2, false, {
        [0] = {contact_geometry_2, false, 4, {{"r12", PW85_SEPARATION, 2}, {"q1", PW85_FORM1, 3},
            {"q2", PW85_FORM2, 3}, {"lambda", PW85_VALUES, 1}}, 2, {2, 2}},
        [1] = {contact_geometry_3, false, 4, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6},
            {"q2", PW85_FORM2, 6}, {"lambda", PW85_VALUES, 1}}, 2, {3, 3}},
    }},
    {"contact_gradient", 2, false, {
        [0] = {contact_gradient_2, false, 4, {{"r12", PW85_SEPARATION, 2}, {"q1", PW85_FORM1, 3},
            {"q2", PW85_FORM2, 3}, {"lambda", PW85_VALUES, 1}}, 3, {2, 3, 3}},
        [1] = {contact_gradient_3, false, 4, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6},
            {"q2", PW85_FORM2, 6}, {"lambda", PW85_VALUES, 1}}, 3, {3, 6, 6}},
    }},
    {"contact_hessian", 2, false, {
        [0] = {contact_hessian_2, false, 4, {{"r12", PW85_SEPARATION, 2}, {"q1", PW85_FORM1, 3},
            {"q2", PW85_FORM2, 3}, {"lambda", PW85_VALUES, 1}}, 1, {16}},
        [1] = {contact_hessian_3, false, 4, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6},
            {"q2", PW85_FORM2, 6}, {"lambda", PW85_VALUES, 1}}, 1, {81}},
    }},
    {"contact_rounded", 2, false, {
        [1] = {contact_rounded_3, false, 3, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6},
            {"q2", PW85_FORM2, 6}}, 2, {1, 1}},
    }},
    {"contact_torque", 2, false, {
        [0] = {contact_torque_2, false, 4, {{"r12", PW85_SEPARATION, 2}, {"q1", PW85_FORM1, 3},
            {"q2", PW85_FORM2, 3}, {"lambda", PW85_VALUES, 1}}, 2, {1, 1}},
        [1] = {contact_torque_3, false, 4, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6},
            {"q2", PW85_FORM2, 6}, {"lambda", PW85_VALUES, 1}}, 2, {3, 3}},
    }},
    {"containment", 2, false, {
        [0] = {containment_2, false, 3, {{"r12", PW85_SEPARATION, 2}, {"q1", PW85_FORM1, 3}, {"q2",
            PW85_FORM2, 3}}, 2, {1, 2}},
        [1] = {containment_3, false, 3, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6}, {"q2",
            PW85_FORM2, 6}}, 2, {1, 3}},
    }},
    {"contains", 2, false, {
        [0] = {contains_2, true, 3, {{"r12", PW85_SEPARATION, 2}, {"q1", PW85_FORM1, 3}, {"q2",
            PW85_FORM2, 3}}, 1, {1}},
        [1] = {contains_3, true, 3, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6}, {"q2",
            PW85_FORM2, 6}}, 1, {1}},
    }},
    {"distance", 2, false, {
        [0] = {distance_2, false, 3, {{"r12", PW85_SEPARATION, 2}, {"q1", PW85_FORM1, 3}, {"q2",
            PW85_FORM2, 3}}, 3, {1, 2, 2}},
        [1] = {distance_3, false, 3, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6}, {"q2",
            PW85_FORM2, 6}}, 3, {1, 3, 3}},
    }},
    {"distance_derivatives", 2, false, {
        [1] = {distance_derivatives_3, false, 3, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1,
            6}, {"q2", PW85_FORM2, 6}}, 4, {3, 3, 3, 81}},
    }},
    {"distance_geometry", 2, false, {
        [0] = {distance_geometry_2, false, 3, {{"r12", PW85_SEPARATION, 2}, {"q1", PW85_FORM1, 3},
            {"q2", PW85_FORM2, 3}}, 4, {1, 2, 2, 2}},
        [1] = {distance_geometry_3, false, 3, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6},
            {"q2", PW85_FORM2, 6}}, 4, {1, 3, 3, 3}},
    }},
    {"ellipse", 0, false, {
        [0] = {ellipse_2, false, 3, {{"a", PW85_VALUES, 1}, {"b", PW85_VALUES, 1}, {"angle",
            PW85_VALUES, 1}}, 1, {3}},
    }},
    {"ellipsoid", 0, false, {
        [1] = {ellipsoid_3, false, 2, {{"semi_axes", PW85_VALUES, 3}, {"rotation", PW85_VALUES, 9}},
            1, {6}},
    }},
    {"ellipsoid_quaternion", 0, false, {
        [1] = {ellipsoid_quaternion_3, false, 2, {{"semi_axes", PW85_VALUES, 3}, {"quaternion",
            PW85_VALUES, 4}}, 1, {6}},
    }},
    {"first_contact", 2, true, {
        [1] = {first_contact_3, false, 6, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6},
            {"q2", PW85_FORM2, 6}, {"motion1", PW85_VALUES, 7}, {"motion2", PW85_VALUES, 7},
            {"t_max", PW85_VALUES, 1}}, 1, {1}},
    }},
    {"free_path", 2, true, {
        [1] = {free_path_3, false, 5, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6}, {"q2",
            PW85_FORM2, 6}, {"direction", PW85_VALUES, 3}, {"t_max", PW85_VALUES, 1}}, 1, {1}},
    }},
    {"gap_inside", 2, false, {
        [0] = {gap_inside_2, false, 3, {{"r12", PW85_SEPARATION, 2}, {"q1", PW85_FORM1, 3}, {"q2",
            PW85_FORM2, 3}}, 4, {1, 2, 2, 2}},
        [1] = {gap_inside_3, false, 3, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6}, {"q2",
            PW85_FORM2, 6}}, 4, {1, 3, 3, 3}},
    }},
    {"grain_contact", 2, false, {
        [1] = {grain_contact_3, false, 4, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6},
            {"q2", PW85_FORM2, 6}, {"start", PW85_VALUES, 3}}, 5, {3, 1, 3, 2, 1}},
    }},
    {"grain_radius_gradient", 2, false, {
        [1] = {grain_radius_gradient_3, false, 4, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1,
            6}, {"q2", PW85_FORM2, 6}, {"normal", PW85_VALUES, 3}}, 3, {3, 3, 3}},
    }},
    {"hertz_contact", 2, false, {
        [1] = {hertz_contact_3, false, 4, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6},
            {"q2", PW85_FORM2, 6}, {"normal", PW85_VALUES, 3}}, 6, {1, 3, 2, 6, 1, 2}},
    }},
    {"overlap", 2, false, {
        [0] = {overlap_2, true, 3, {{"r12", PW85_SEPARATION, 2}, {"q1", PW85_FORM1, 3}, {"q2",
            PW85_FORM2, 3}}, 1, {1}},
        [1] = {overlap_3, true, 3, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6}, {"q2",
            PW85_FORM2, 6}}, 1, {1}},
    }},
    {"overlap_area", 2, false, {
        [0] = {overlap_area_2, false, 3, {{"r12", PW85_SEPARATION, 2}, {"q1", PW85_FORM1, 3}, {"q2",
            PW85_FORM2, 3}}, 1, {1}},
    }},
    {"overlap_area_gradient", 2, false, {
        [0] = {overlap_area_gradient_2, false, 3, {{"r12", PW85_SEPARATION, 2}, {"q1", PW85_FORM1,
            3}, {"q2", PW85_FORM2, 3}}, 3, {2, 3, 3}},
    }},
    {"overlap_area_torque", 2, false, {
        [0] = {overlap_area_torque_2, false, 3, {{"r12", PW85_SEPARATION, 2}, {"q1", PW85_FORM1, 3},
            {"q2", PW85_FORM2, 3}}, 2, {1, 1}},
    }},
    {"overlap_volume", 2, false, {
        [1] = {overlap_volume_3, false, 3, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6},
            {"q2", PW85_FORM2, 6}}, 1, {1}},
    }},
    {"overlap_volume_gradient", 2, false, {
        [1] = {overlap_volume_gradient_3, false, 3, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1,
            6}, {"q2", PW85_FORM2, 6}}, 3, {3, 6, 6}},
    }},
    {"overlap_volume_torque", 2, false, {
        [1] = {overlap_volume_torque_3, false, 3, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1,
            6}, {"q2", PW85_FORM2, 6}}, 2, {3, 3}},
    }},
    {"overlap_witness", 2, false, {
        [1] = {overlap_witness_3, false, 3, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6},
            {"q2", PW85_FORM2, 6}}, 3, {1, 1, 3}},
    }},
    {"penetration", 2, false, {
        [0] = {penetration_2, false, 3, {{"r12", PW85_SEPARATION, 2}, {"q1", PW85_FORM1, 3}, {"q2",
            PW85_FORM2, 3}}, 2, {1, 2}},
        [1] = {penetration_3, false, 3, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6}, {"q2",
            PW85_FORM2, 6}}, 2, {1, 3}},
    }},
    {"perimeter", 1, false, {
        [0] = {perimeter_2, false, 1, {{"q", PW85_FORM1, 3}}, 1, {1}},
    }},
    {"second_moments", 1, false, {
        [0] = {second_moments_2, false, 1, {{"q", PW85_FORM1, 3}}, 1, {3}},
        [1] = {second_moments_3, false, 1, {{"q", PW85_FORM1, 6}}, 1, {6}},
    }},
    {"shell_moments", 1, false, {
        [0] = {shell_moments_2, false, 1, {{"q", PW85_FORM1, 3}}, 1, {3}},
        [1] = {shell_moments_3, false, 1, {{"q", PW85_FORM1, 6}}, 1, {6}},
    }},
    {"signed_distance", 2, false, {
        [0] = {signed_distance_2, false, 3, {{"r12", PW85_SEPARATION, 2}, {"q1", PW85_FORM1, 3},
            {"q2", PW85_FORM2, 3}}, 3, {1, 2, 2}},
        [1] = {signed_distance_3, false, 3, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6},
            {"q2", PW85_FORM2, 6}}, 3, {1, 3, 3}},
    }},
    {"signed_distance_derivatives", 2, false, {
        [1] = {signed_distance_derivatives_3, false, 3, {{"r12", PW85_SEPARATION, 3}, {"q1",
            PW85_FORM1, 6}, {"q2", PW85_FORM2, 6}}, 4, {3, 3, 3, 81}},
    }},
    {"signed_distance_geometry", 2, false, {
        [0] = {signed_distance_geometry_2, false, 3, {{"r12", PW85_SEPARATION, 2}, {"q1",
            PW85_FORM1, 3}, {"q2", PW85_FORM2, 3}}, 4, {1, 2, 2, 2}},
        [1] = {signed_distance_geometry_3, false, 3, {{"r12", PW85_SEPARATION, 3}, {"q1",
            PW85_FORM1, 6}, {"q2", PW85_FORM2, 6}}, 4, {1, 3, 3, 3}},
    }},
    {"surface_area", 1, false, {
        [1] = {surface_area_3, false, 1, {{"q", PW85_FORM1, 6}}, 1, {1}},
    }},
    {"volume", 1, false, {
        [1] = {volume_3, false, 1, {{"q", PW85_FORM1, 6}}, 1, {1}},
    }},
};

size_t const pw85_num_questions = sizeof pw85_questions / sizeof *pw85_questions;
