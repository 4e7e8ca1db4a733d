/* SPDX-License-Identifier: BSD-3-Clause */
/* The functions of ellipsoids: made by api/r.py from the headers of the C API. */
/* clang-format off */
#include "pw85_r.h"

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
    {"area", 1, {
        [0] = {area_2, false, 1, {{"q", PW85_FORM1, 3}}, 1, {1}, {"area"}},
    }},
    {"bounding_boxes", 1, {
        [1] = {bounding_boxes_3, false, 1, {{"q", PW85_FORM1, 6}}, 1, {3}, {"x", "y", "z"}},
    }},
    {"closest_approach", 2, {
        [0] = {closest_approach_2, false, 3, {{"direction", PW85_VALUES, 2}, {"q1", PW85_FORM1, 3},
            {"q2", PW85_FORM2, 3}}, 1, {1}, {"distance"}},
        [1] = {closest_approach_3, false, 3, {{"direction", PW85_VALUES, 3}, {"q1", PW85_FORM1, 6},
            {"q2", PW85_FORM2, 6}}, 1, {1}, {"distance"}},
    }},
    {"closest_passage", 2, {
        [1] = {closest_passage_3, false, 5, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6},
            {"q2", PW85_FORM2, 6}, {"velocity", PW85_VALUES, 3}, {"t_max", PW85_VALUES, 1}}, 2, {1,
            1}, {"mu2", "t"}},
    }},
    {"compare", 2, {
        [1] = {compare_3, false, 4, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6}, {"q2",
            PW85_FORM2, 6}, {"mu2", PW85_VALUES, 1}}, 1, {1}, {"sign"}},
    }},
    {"condition", 2, {
        [1] = {condition_3, false, 4, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6}, {"q2",
            PW85_FORM2, 6}, {"lambda", PW85_VALUES, 1}}, 1, {1}, {"cond"}},
    }},
    {"contact", 2, {
        [0] = {contact_2, false, 3, {{"r12", PW85_SEPARATION, 2}, {"q1", PW85_FORM1, 3}, {"q2",
            PW85_FORM2, 3}}, 2, {1, 1}, {"mu2", "lambda"}},
        [1] = {contact_3, false, 3, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6}, {"q2",
            PW85_FORM2, 6}}, 2, {1, 1}, {"mu2", "lambda"}},
    }},
    {"contact_derivatives", 2, {
        [1] = {contact_derivatives_3, false, 3, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6},
            {"q2", PW85_FORM2, 6}}, 7, {1, 1, 3, 3, 3, 3, 3}, {"mu2", "lambda", "point_x",
            "point_y", "point_z", "normal_x", "normal_y", "normal_z", "d_r12_x", "d_r12_y",
            "d_r12_z", "d_rot1_x", "d_rot1_y", "d_rot1_z", "d_rot2_x", "d_rot2_y", "d_rot2_z"}},
    }},
    {"contact_function", 2, {
        [1] = {contact_function_3, false, 3, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6},
            {"q2", PW85_FORM2, 6}}, 2, {1, 1}, {"mu2", "lambda"}},
    }},
    {"contact_geometry", 2, {
        [0] = {contact_geometry_2, false, 4, {{"r12", PW85_SEPARATION, 2}, {"q1", PW85_FORM1, 3},
            {"q2", PW85_FORM2, 3}, {"lambda", PW85_VALUES, 1}}, 2, {2, 2}, {"point_x", "point_y",
            "normal_x", "normal_y"}},
        [1] = {contact_geometry_3, false, 4, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6},
            {"q2", PW85_FORM2, 6}, {"lambda", PW85_VALUES, 1}}, 2, {3, 3}, {"point_x", "point_y",
            "point_z", "normal_x", "normal_y", "normal_z"}},
    }},
    {"contact_gradient", 2, {
        [0] = {contact_gradient_2, false, 4, {{"r12", PW85_SEPARATION, 2}, {"q1", PW85_FORM1, 3},
            {"q2", PW85_FORM2, 3}, {"lambda", PW85_VALUES, 1}}, 3, {2, 3, 3}, {"d_r12_x", "d_r12_y",
            "d_q1_xx", "d_q1_xy", "d_q1_yy", "d_q2_xx", "d_q2_xy", "d_q2_yy"}},
        [1] = {contact_gradient_3, false, 4, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6},
            {"q2", PW85_FORM2, 6}, {"lambda", PW85_VALUES, 1}}, 3, {3, 6, 6}, {"d_r12_x", "d_r12_y",
            "d_r12_z", "d_q1_xx", "d_q1_xy", "d_q1_xz", "d_q1_yy", "d_q1_yz", "d_q1_zz", "d_q2_xx",
            "d_q2_xy", "d_q2_xz", "d_q2_yy", "d_q2_yz", "d_q2_zz"}},
    }},
    {"contact_hessian", 2, {
        [0] = {contact_hessian_2, false, 4, {{"r12", PW85_SEPARATION, 2}, {"q1", PW85_FORM1, 3},
            {"q2", PW85_FORM2, 3}, {"lambda", PW85_VALUES, 1}}, 1, {16}, {"1", "2", "3", "4", "5",
            "6", "7", "8", "9", "10", "11", "12", "13", "14", "15", "16"}},
        [1] = {contact_hessian_3, false, 4, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6},
            {"q2", PW85_FORM2, 6}, {"lambda", PW85_VALUES, 1}}, 1, {81}, {"1", "2", "3", "4", "5",
            "6", "7", "8", "9", "10", "11", "12", "13", "14", "15", "16", "17", "18", "19", "20",
            "21", "22", "23", "24", "25", "26", "27", "28", "29", "30", "31", "32", "33", "34",
            "35", "36", "37", "38", "39", "40", "41", "42", "43", "44", "45", "46", "47", "48",
            "49", "50", "51", "52", "53", "54", "55", "56", "57", "58", "59", "60", "61", "62",
            "63", "64", "65", "66", "67", "68", "69", "70", "71", "72", "73", "74", "75", "76",
            "77", "78", "79", "80", "81"}},
    }},
    {"contact_rounded", 2, {
        [1] = {contact_rounded_3, false, 3, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6},
            {"q2", PW85_FORM2, 6}}, 2, {1, 1}, {"mu2", "lambda"}},
    }},
    {"contact_torque", 2, {
        [0] = {contact_torque_2, false, 4, {{"r12", PW85_SEPARATION, 2}, {"q1", PW85_FORM1, 3},
            {"q2", PW85_FORM2, 3}, {"lambda", PW85_VALUES, 1}}, 2, {1, 1}, {"d_rot1", "d_rot2"}},
        [1] = {contact_torque_3, false, 4, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6},
            {"q2", PW85_FORM2, 6}, {"lambda", PW85_VALUES, 1}}, 2, {3, 3}, {"d_rot1_x", "d_rot1_y",
            "d_rot1_z", "d_rot2_x", "d_rot2_y", "d_rot2_z"}},
    }},
    {"containment", 2, {
        [0] = {containment_2, false, 3, {{"r12", PW85_SEPARATION, 2}, {"q1", PW85_FORM1, 3}, {"q2",
            PW85_FORM2, 3}}, 2, {1, 2}, {"mu2", "point_x", "point_y"}},
        [1] = {containment_3, false, 3, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6}, {"q2",
            PW85_FORM2, 6}}, 2, {1, 3}, {"mu2", "point_x", "point_y", "point_z"}},
    }},
    {"contains", 2, {
        [0] = {contains_2, true, 3, {{"r12", PW85_SEPARATION, 2}, {"q1", PW85_FORM1, 3}, {"q2",
            PW85_FORM2, 3}}, 1, {1}, {"contains"}},
        [1] = {contains_3, true, 3, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6}, {"q2",
            PW85_FORM2, 6}}, 1, {1}, {"contains"}},
    }},
    {"distance", 2, {
        [0] = {distance_2, false, 3, {{"r12", PW85_SEPARATION, 2}, {"q1", PW85_FORM1, 3}, {"q2",
            PW85_FORM2, 3}}, 3, {1, 2, 2}, {"distance", "point1_x", "point1_y", "point2_x",
            "point2_y"}},
        [1] = {distance_3, false, 3, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6}, {"q2",
            PW85_FORM2, 6}}, 3, {1, 3, 3}, {"distance", "point1_x", "point1_y", "point1_z",
            "point2_x", "point2_y", "point2_z"}},
    }},
    {"distance_derivatives", 2, {
        [1] = {distance_derivatives_3, false, 3, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1,
            6}, {"q2", PW85_FORM2, 6}}, 4, {3, 3, 3, 81}, {"d_r12_x", "d_r12_y", "d_r12_z",
            "d_rot1_x", "d_rot1_y", "d_rot1_z", "d_rot2_x", "d_rot2_y", "d_rot2_z", "hessian_1",
            "hessian_2", "hessian_3", "hessian_4", "hessian_5", "hessian_6", "hessian_7",
            "hessian_8", "hessian_9", "hessian_10", "hessian_11", "hessian_12", "hessian_13",
            "hessian_14", "hessian_15", "hessian_16", "hessian_17", "hessian_18", "hessian_19",
            "hessian_20", "hessian_21", "hessian_22", "hessian_23", "hessian_24", "hessian_25",
            "hessian_26", "hessian_27", "hessian_28", "hessian_29", "hessian_30", "hessian_31",
            "hessian_32", "hessian_33", "hessian_34", "hessian_35", "hessian_36", "hessian_37",
            "hessian_38", "hessian_39", "hessian_40", "hessian_41", "hessian_42", "hessian_43",
            "hessian_44", "hessian_45", "hessian_46", "hessian_47", "hessian_48", "hessian_49",
            "hessian_50", "hessian_51", "hessian_52", "hessian_53", "hessian_54", "hessian_55",
            "hessian_56", "hessian_57", "hessian_58", "hessian_59", "hessian_60", "hessian_61",
            "hessian_62", "hessian_63", "hessian_64", "hessian_65", "hessian_66", "hessian_67",
            "hessian_68", "hessian_69", "hessian_70", "hessian_71", "hessian_72", "hessian_73",
            "hessian_74", "hessian_75", "hessian_76", "hessian_77", "hessian_78", "hessian_79",
            "hessian_80", "hessian_81"}},
    }},
    {"distance_geometry", 2, {
        [0] = {distance_geometry_2, false, 3, {{"r12", PW85_SEPARATION, 2}, {"q1", PW85_FORM1, 3},
            {"q2", PW85_FORM2, 3}}, 4, {1, 2, 2, 2}, {"distance", "point1_x", "point1_y",
            "point2_x", "point2_y", "normal_x", "normal_y"}},
        [1] = {distance_geometry_3, false, 3, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6},
            {"q2", PW85_FORM2, 6}}, 4, {1, 3, 3, 3}, {"distance", "point1_x", "point1_y",
            "point1_z", "point2_x", "point2_y", "point2_z", "normal_x", "normal_y", "normal_z"}},
    }},
    {"ellipse", 0, {
        [0] = {ellipse_2, false, 3, {{"a", PW85_VALUES, 1}, {"b", PW85_VALUES, 1}, {"angle",
            PW85_VALUES, 1}}, 1, {3}, {"xx", "xy", "yy"}},
    }},
    {"ellipsoid", 0, {
        [1] = {ellipsoid_3, false, 2, {{"semi_axes", PW85_VALUES, 3}, {"rotation", PW85_VALUES, 9}},
            1, {6}, {"xx", "xy", "xz", "yy", "yz", "zz"}},
    }},
    {"ellipsoid_quaternion", 0, {
        [1] = {ellipsoid_quaternion_3, false, 2, {{"semi_axes", PW85_VALUES, 3}, {"quaternion",
            PW85_VALUES, 4}}, 1, {6}, {"xx", "xy", "xz", "yy", "yz", "zz"}},
    }},
    {"first_contact", 2, {
        [1] = {first_contact_3, false, 6, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6},
            {"q2", PW85_FORM2, 6}, {"motion1", PW85_VALUES, 7}, {"motion2", PW85_VALUES, 7},
            {"t_max", PW85_VALUES, 1}}, 1, {1}, {"t"}},
    }},
    {"free_path", 2, {
        [1] = {free_path_3, false, 5, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6}, {"q2",
            PW85_FORM2, 6}, {"direction", PW85_VALUES, 3}, {"t_max", PW85_VALUES, 1}}, 1, {1},
            {"t"}},
    }},
    {"gap_inside", 2, {
        [0] = {gap_inside_2, false, 3, {{"r12", PW85_SEPARATION, 2}, {"q1", PW85_FORM1, 3}, {"q2",
            PW85_FORM2, 3}}, 4, {1, 2, 2, 2}, {"gap", "point1_x", "point1_y", "point2_x",
            "point2_y", "normal_x", "normal_y"}},
        [1] = {gap_inside_3, false, 3, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6}, {"q2",
            PW85_FORM2, 6}}, 4, {1, 3, 3, 3}, {"gap", "point1_x", "point1_y", "point1_z",
            "point2_x", "point2_y", "point2_z", "normal_x", "normal_y", "normal_z"}},
    }},
    {"grain_contact", 2, {
        [1] = {grain_contact_3, false, 4, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6},
            {"q2", PW85_FORM2, 6}, {"start", PW85_VALUES, 3}}, 5, {3, 1, 3, 2, 1}, {"normal_x",
            "normal_y", "normal_z", "depth", "point_x", "point_y", "point_z", "curvatures_1",
            "curvatures_2", "radius"}},
    }},
    {"grain_radius_gradient", 2, {
        [1] = {grain_radius_gradient_3, false, 4, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1,
            6}, {"q2", PW85_FORM2, 6}, {"normal", PW85_VALUES, 3}}, 3, {3, 3, 3}, {"d_r12_x",
            "d_r12_y", "d_r12_z", "d_rot1_x", "d_rot1_y", "d_rot1_z", "d_rot2_x", "d_rot2_y",
            "d_rot2_z"}},
    }},
    {"hertz_contact", 2, {
        [1] = {hertz_contact_3, false, 4, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6},
            {"q2", PW85_FORM2, 6}, {"normal", PW85_VALUES, 3}}, 6, {1, 3, 2, 6, 1, 2}, {"depth",
            "point_x", "point_y", "point_z", "curvatures_1", "curvatures_2", "directions_1",
            "directions_2", "directions_3", "directions_4", "directions_5", "directions_6",
            "radius", "ellipse_1", "ellipse_2"}},
    }},
    {"overlap", 2, {
        [0] = {overlap_2, true, 3, {{"r12", PW85_SEPARATION, 2}, {"q1", PW85_FORM1, 3}, {"q2",
            PW85_FORM2, 3}}, 1, {1}, {"overlap"}},
        [1] = {overlap_3, true, 3, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6}, {"q2",
            PW85_FORM2, 6}}, 1, {1}, {"overlap"}},
    }},
    {"overlap_area", 2, {
        [0] = {overlap_area_2, false, 3, {{"r12", PW85_SEPARATION, 2}, {"q1", PW85_FORM1, 3}, {"q2",
            PW85_FORM2, 3}}, 1, {1}, {"area"}},
    }},
    {"overlap_area_gradient", 2, {
        [0] = {overlap_area_gradient_2, false, 3, {{"r12", PW85_SEPARATION, 2}, {"q1", PW85_FORM1,
            3}, {"q2", PW85_FORM2, 3}}, 3, {2, 3, 3}, {"d_r12_x", "d_r12_y", "d_q1_xx", "d_q1_xy",
            "d_q1_yy", "d_q2_xx", "d_q2_xy", "d_q2_yy"}},
    }},
    {"overlap_area_torque", 2, {
        [0] = {overlap_area_torque_2, false, 3, {{"r12", PW85_SEPARATION, 2}, {"q1", PW85_FORM1, 3},
            {"q2", PW85_FORM2, 3}}, 2, {1, 1}, {"d_rot1", "d_rot2"}},
    }},
    {"overlap_volume", 2, {
        [1] = {overlap_volume_3, false, 3, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6},
            {"q2", PW85_FORM2, 6}}, 1, {1}, {"volume"}},
    }},
    {"overlap_volume_gradient", 2, {
        [1] = {overlap_volume_gradient_3, false, 3, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1,
            6}, {"q2", PW85_FORM2, 6}}, 3, {3, 6, 6}, {"d_r12_x", "d_r12_y", "d_r12_z", "d_q1_xx",
            "d_q1_xy", "d_q1_xz", "d_q1_yy", "d_q1_yz", "d_q1_zz", "d_q2_xx", "d_q2_xy", "d_q2_xz",
            "d_q2_yy", "d_q2_yz", "d_q2_zz"}},
    }},
    {"overlap_volume_torque", 2, {
        [1] = {overlap_volume_torque_3, false, 3, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1,
            6}, {"q2", PW85_FORM2, 6}}, 2, {3, 3}, {"d_rot1_x", "d_rot1_y", "d_rot1_z", "d_rot2_x",
            "d_rot2_y", "d_rot2_z"}},
    }},
    {"overlap_witness", 2, {
        [1] = {overlap_witness_3, false, 3, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6},
            {"q2", PW85_FORM2, 6}}, 3, {1, 1, 3}, {"overlap", "lambda", "point_x", "point_y",
            "point_z"}},
    }},
    {"penetration", 2, {
        [0] = {penetration_2, false, 3, {{"r12", PW85_SEPARATION, 2}, {"q1", PW85_FORM1, 3}, {"q2",
            PW85_FORM2, 3}}, 2, {1, 2}, {"depth", "direction_x", "direction_y"}},
        [1] = {penetration_3, false, 3, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6}, {"q2",
            PW85_FORM2, 6}}, 2, {1, 3}, {"depth", "direction_x", "direction_y", "direction_z"}},
    }},
    {"perimeter", 1, {
        [0] = {perimeter_2, false, 1, {{"q", PW85_FORM1, 3}}, 1, {1}, {"perimeter"}},
    }},
    {"second_moments", 1, {
        [0] = {second_moments_2, false, 1, {{"q", PW85_FORM1, 3}}, 1, {3}, {"xx", "xy", "yy"}},
        [1] = {second_moments_3, false, 1, {{"q", PW85_FORM1, 6}}, 1, {6}, {"xx", "xy", "xz", "yy",
            "yz", "zz"}},
    }},
    {"shell_moments", 1, {
        [0] = {shell_moments_2, false, 1, {{"q", PW85_FORM1, 3}}, 1, {3}, {"xx", "xy", "yy"}},
        [1] = {shell_moments_3, false, 1, {{"q", PW85_FORM1, 6}}, 1, {6}, {"xx", "xy", "xz", "yy",
            "yz", "zz"}},
    }},
    {"signed_distance", 2, {
        [0] = {signed_distance_2, false, 3, {{"r12", PW85_SEPARATION, 2}, {"q1", PW85_FORM1, 3},
            {"q2", PW85_FORM2, 3}}, 3, {1, 2, 2}, {"distance", "point1_x", "point1_y", "point2_x",
            "point2_y"}},
        [1] = {signed_distance_3, false, 3, {{"r12", PW85_SEPARATION, 3}, {"q1", PW85_FORM1, 6},
            {"q2", PW85_FORM2, 6}}, 3, {1, 3, 3}, {"distance", "point1_x", "point1_y", "point1_z",
            "point2_x", "point2_y", "point2_z"}},
    }},
    {"signed_distance_derivatives", 2, {
        [1] = {signed_distance_derivatives_3, false, 3, {{"r12", PW85_SEPARATION, 3}, {"q1",
            PW85_FORM1, 6}, {"q2", PW85_FORM2, 6}}, 4, {3, 3, 3, 81}, {"d_r12_x", "d_r12_y",
            "d_r12_z", "d_rot1_x", "d_rot1_y", "d_rot1_z", "d_rot2_x", "d_rot2_y", "d_rot2_z",
            "hessian_1", "hessian_2", "hessian_3", "hessian_4", "hessian_5", "hessian_6",
            "hessian_7", "hessian_8", "hessian_9", "hessian_10", "hessian_11", "hessian_12",
            "hessian_13", "hessian_14", "hessian_15", "hessian_16", "hessian_17", "hessian_18",
            "hessian_19", "hessian_20", "hessian_21", "hessian_22", "hessian_23", "hessian_24",
            "hessian_25", "hessian_26", "hessian_27", "hessian_28", "hessian_29", "hessian_30",
            "hessian_31", "hessian_32", "hessian_33", "hessian_34", "hessian_35", "hessian_36",
            "hessian_37", "hessian_38", "hessian_39", "hessian_40", "hessian_41", "hessian_42",
            "hessian_43", "hessian_44", "hessian_45", "hessian_46", "hessian_47", "hessian_48",
            "hessian_49", "hessian_50", "hessian_51", "hessian_52", "hessian_53", "hessian_54",
            "hessian_55", "hessian_56", "hessian_57", "hessian_58", "hessian_59", "hessian_60",
            "hessian_61", "hessian_62", "hessian_63", "hessian_64", "hessian_65", "hessian_66",
            "hessian_67", "hessian_68", "hessian_69", "hessian_70", "hessian_71", "hessian_72",
            "hessian_73", "hessian_74", "hessian_75", "hessian_76", "hessian_77", "hessian_78",
            "hessian_79", "hessian_80", "hessian_81"}},
    }},
    {"signed_distance_geometry", 2, {
        [0] = {signed_distance_geometry_2, false, 3, {{"r12", PW85_SEPARATION, 2}, {"q1",
            PW85_FORM1, 3}, {"q2", PW85_FORM2, 3}}, 4, {1, 2, 2, 2}, {"distance", "point1_x",
            "point1_y", "point2_x", "point2_y", "normal_x", "normal_y"}},
        [1] = {signed_distance_geometry_3, false, 3, {{"r12", PW85_SEPARATION, 3}, {"q1",
            PW85_FORM1, 6}, {"q2", PW85_FORM2, 6}}, 4, {1, 3, 3, 3}, {"distance", "point1_x",
            "point1_y", "point1_z", "point2_x", "point2_y", "point2_z", "normal_x", "normal_y",
            "normal_z"}},
    }},
    {"surface_area", 1, {
        [1] = {surface_area_3, false, 1, {{"q", PW85_FORM1, 6}}, 1, {1}, {"area"}},
    }},
    {"volume", 1, {
        [1] = {volume_3, false, 1, {{"q", PW85_FORM1, 6}}, 1, {1}, {"volume"}},
    }},
};

size_t const pw85_num_questions = sizeof pw85_questions / sizeof *pw85_questions;
