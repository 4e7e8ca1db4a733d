/* SPDX-License-Identifier: BSD-3-Clause */
/* The questions of ellipsoids: made by api/r.py from the headers of the C API. */
/* clang-format off */
#include "pw85_r.h"

static int ellipsoid_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    for (*row = 0; *row < n; ++*row) {
        size_t const i = *row;
        int const status = pw85_ellipsoid(in[0] + 3 * i, in[1] + 9 * i, (double *)out[0] + 6 * i);
        if (status != 0) return status;
    }
    return 0;
}

static struct pw85_question const ellipsoid_question = {
    "ellipsoid",
    {
        [1] = {ellipsoid_3, false, 2,
               {{"semi_axes", PW85_VALUES, 3, 0}, {"rotation", PW85_VALUES, 9, 1}}, 1, {6}, {"xx",
                   "xy", "xz", "yy", "yz", "zz"}},
    },
};

static SEXP call_ellipsoid(SEXP semi_axes, SEXP rotation)
{
    SEXP const given[] = {semi_axes, rotation};
    return pw85_rows(&ellipsoid_question, 0, 2, given);
}

static int ellipsoid_quaternion_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_ellipsoid_quaternion_batch(n, in[0], in[1], out[0]);
}

static struct pw85_question const ellipsoid_quaternion_question = {
    "ellipsoid_quaternion",
    {
        [1] = {ellipsoid_quaternion_3, false, 2,
               {{"semi_axes", PW85_VALUES, 3, 0}, {"quaternion", PW85_VALUES, 4, 1}}, 1, {6}, {"xx",
                   "xy", "xz", "yy", "yz", "zz"}},
    },
};

static SEXP call_ellipsoid_quaternion(SEXP semi_axes, SEXP quaternion)
{
    SEXP const given[] = {semi_axes, quaternion};
    return pw85_rows(&ellipsoid_quaternion_question, 0, 2, given);
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

static struct pw85_question const ellipse_question = {
    "ellipse",
    {
        [0] = {ellipse_2, false, 3,
               {{"a", PW85_VALUES, 1, 0}, {"b", PW85_VALUES, 1, 1}, {"angle", PW85_VALUES, 1, 2}},
                   1, {3}, {"xx", "xy", "yy"}},
    },
};

static SEXP call_ellipse(SEXP a, SEXP b, SEXP angle)
{
    SEXP const given[] = {a, b, angle};
    return pw85_rows(&ellipse_question, 0, 3, given);
}

static int contact_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_contact_batch(n, in[0], in[1], in[2], out[0], out[1]);
}

static int contact_2(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_contact_batch_2d(n, in[0], in[1], in[2], out[0], out[1]);
}

static struct pw85_question const contact_question = {
    "contact",
    {
        [0] = {contact_2, false, 3,
               {{"r12", PW85_SEPARATION, 2, 0}, {"q1", PW85_FORM1, 3, 0}, {"q2", PW85_FORM2, 3, 0}},
                   2, {1, 1}, {"mu2", "lambda"}},
        [1] = {contact_3, false, 3,
               {{"r12", PW85_SEPARATION, 3, 0}, {"q1", PW85_FORM1, 6, 0}, {"q2", PW85_FORM2, 6, 0}},
                   2, {1, 1}, {"mu2", "lambda"}},
    },
};

static SEXP call_contact(SEXP x, SEXP y)
{
    SEXP const given[] = {x, y};
    return pw85_rows(&contact_question, 2, 0, given);
}

static int contact_rounded_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_contact_rounded_batch(n, in[0], in[1], in[2], out[0], out[1]);
}

static struct pw85_question const contact_rounded_question = {
    "contact_rounded",
    {
        [1] = {contact_rounded_3, false, 3,
               {{"r12", PW85_SEPARATION, 3, 0}, {"q1", PW85_FORM1, 6, 0}, {"q2", PW85_FORM2, 6, 0}},
                   2, {1, 1}, {"mu2", "lambda"}},
    },
};

static SEXP call_contact_rounded(SEXP x, SEXP y)
{
    SEXP const given[] = {x, y};
    return pw85_rows(&contact_rounded_question, 2, 0, given);
}

static int condition_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_condition_batch(n, in[0], in[1], in[2], in[3], out[0]);
}

static struct pw85_question const condition_question = {
    "condition",
    {
        [1] = {condition_3, false, 4,
               {{"r12", PW85_SEPARATION, 3, 0}, {"q1", PW85_FORM1, 6, 0}, {"q2", PW85_FORM2, 6, 0},
                   {"lambda", PW85_VALUES, 1, 0}}, 1, {1}, {"cond"}},
    },
};

static SEXP call_condition(SEXP x, SEXP y, SEXP lambda)
{
    SEXP const given[] = {x, y, lambda};
    return pw85_rows(&condition_question, 2, 1, given);
}

static int contact_function_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_contact_function_batch(n, in[0], in[1], in[2], out[0], out[1]);
}

static struct pw85_question const contact_function_question = {
    "contact_function",
    {
        [1] = {contact_function_3, false, 3,
               {{"r12", PW85_SEPARATION, 3, 0}, {"q1", PW85_FORM1, 6, 0}, {"q2", PW85_FORM2, 6, 0}},
                   2, {1, 1}, {"mu2", "lambda"}},
    },
};

static SEXP call_contact_function(SEXP x, SEXP y)
{
    SEXP const given[] = {x, y};
    return pw85_rows(&contact_function_question, 2, 0, given);
}

static int contact_geometry_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_contact_geometry_batch(n, in[0], in[1], in[2], in[3], out[0], out[1]);
}

static int contact_geometry_2(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_contact_geometry_batch_2d(n, in[0], in[1], in[2], in[3], out[0], out[1]);
}

static struct pw85_question const contact_geometry_question = {
    "contact_geometry",
    {
        [0] = {contact_geometry_2, false, 4,
               {{"r12", PW85_SEPARATION, 2, 0}, {"q1", PW85_FORM1, 3, 0}, {"q2", PW85_FORM2, 3, 0},
                   {"lambda", PW85_VALUES, 1, 0}}, 2, {2, 2}, {"point_x", "point_y", "normal_x",
                   "normal_y"}},
        [1] = {contact_geometry_3, false, 4,
               {{"r12", PW85_SEPARATION, 3, 0}, {"q1", PW85_FORM1, 6, 0}, {"q2", PW85_FORM2, 6, 0},
                   {"lambda", PW85_VALUES, 1, 0}}, 2, {3, 3}, {"point_x", "point_y", "point_z",
                   "normal_x", "normal_y", "normal_z"}},
    },
};

static SEXP call_contact_geometry(SEXP x, SEXP y, SEXP lambda)
{
    SEXP const given[] = {x, y, lambda};
    return pw85_rows(&contact_geometry_question, 2, 1, given);
}

static int contact_gradient_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_contact_gradient_batch(n, in[0], in[1], in[2], in[3], out[0], out[1], out[2]);
}

static int contact_gradient_2(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_contact_gradient_batch_2d(n, in[0], in[1], in[2], in[3], out[0], out[1], out[2]);
}

static struct pw85_question const contact_gradient_question = {
    "contact_gradient",
    {
        [0] = {contact_gradient_2, false, 4,
               {{"r12", PW85_SEPARATION, 2, 0}, {"q1", PW85_FORM1, 3, 0}, {"q2", PW85_FORM2, 3, 0},
                   {"lambda", PW85_VALUES, 1, 0}}, 3, {2, 3, 3}, {"d_r12_x", "d_r12_y", "d_q1_xx",
                   "d_q1_xy", "d_q1_yy", "d_q2_xx", "d_q2_xy", "d_q2_yy"}},
        [1] = {contact_gradient_3, false, 4,
               {{"r12", PW85_SEPARATION, 3, 0}, {"q1", PW85_FORM1, 6, 0}, {"q2", PW85_FORM2, 6, 0},
                   {"lambda", PW85_VALUES, 1, 0}}, 3, {3, 6, 6}, {"d_r12_x", "d_r12_y", "d_r12_z",
                   "d_q1_xx", "d_q1_xy", "d_q1_xz", "d_q1_yy", "d_q1_yz", "d_q1_zz", "d_q2_xx",
                   "d_q2_xy", "d_q2_xz", "d_q2_yy", "d_q2_yz", "d_q2_zz"}},
    },
};

static SEXP call_contact_gradient(SEXP x, SEXP y, SEXP lambda)
{
    SEXP const given[] = {x, y, lambda};
    return pw85_rows(&contact_gradient_question, 2, 1, given);
}

static int contact_torque_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_contact_torque_batch(n, in[0], in[1], in[2], in[3], out[0], out[1]);
}

static int contact_torque_2(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_contact_torque_batch_2d(n, in[0], in[1], in[2], in[3], out[0], out[1]);
}

static struct pw85_question const contact_torque_question = {
    "contact_torque",
    {
        [0] = {contact_torque_2, false, 4,
               {{"r12", PW85_SEPARATION, 2, 0}, {"q1", PW85_FORM1, 3, 0}, {"q2", PW85_FORM2, 3, 0},
                   {"lambda", PW85_VALUES, 1, 0}}, 2, {1, 1}, {"d_rot1", "d_rot2"}},
        [1] = {contact_torque_3, false, 4,
               {{"r12", PW85_SEPARATION, 3, 0}, {"q1", PW85_FORM1, 6, 0}, {"q2", PW85_FORM2, 6, 0},
                   {"lambda", PW85_VALUES, 1, 0}}, 2, {3, 3}, {"d_rot1_x", "d_rot1_y", "d_rot1_z",
                   "d_rot2_x", "d_rot2_y", "d_rot2_z"}},
    },
};

static SEXP call_contact_torque(SEXP x, SEXP y, SEXP lambda)
{
    SEXP const given[] = {x, y, lambda};
    return pw85_rows(&contact_torque_question, 2, 1, given);
}

static int contact_hessian_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_contact_hessian_batch(n, in[0], in[1], in[2], in[3], out[0]);
}

static int contact_hessian_2(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_contact_hessian_batch_2d(n, in[0], in[1], in[2], in[3], out[0]);
}

static struct pw85_question const contact_hessian_question = {
    "contact_hessian",
    {
        [0] = {contact_hessian_2, false, 4,
               {{"r12", PW85_SEPARATION, 2, 0}, {"q1", PW85_FORM1, 3, 0}, {"q2", PW85_FORM2, 3, 0},
                   {"lambda", PW85_VALUES, 1, 0}}, 1, {16}, {"1", "2", "3", "4", "5", "6", "7", "8",
                   "9", "10", "11", "12", "13", "14", "15", "16"}},
        [1] = {contact_hessian_3, false, 4,
               {{"r12", PW85_SEPARATION, 3, 0}, {"q1", PW85_FORM1, 6, 0}, {"q2", PW85_FORM2, 6, 0},
                   {"lambda", PW85_VALUES, 1, 0}}, 1, {81}, {"1", "2", "3", "4", "5", "6", "7", "8",
                   "9", "10", "11", "12", "13", "14", "15", "16", "17", "18", "19", "20", "21",
                   "22", "23", "24", "25", "26", "27", "28", "29", "30", "31", "32", "33", "34",
                   "35", "36", "37", "38", "39", "40", "41", "42", "43", "44", "45", "46", "47",
                   "48", "49", "50", "51", "52", "53", "54", "55", "56", "57", "58", "59", "60",
                   "61", "62", "63", "64", "65", "66", "67", "68", "69", "70", "71", "72", "73",
                   "74", "75", "76", "77", "78", "79", "80", "81"}},
    },
};

static SEXP call_contact_hessian(SEXP x, SEXP y, SEXP lambda)
{
    SEXP const given[] = {x, y, lambda};
    return pw85_rows(&contact_hessian_question, 2, 1, given);
}

static int overlaps_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_overlap_batch(n, in[0], in[1], in[2], out[0]);
}

static int overlaps_2(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_overlap_batch_2d(n, in[0], in[1], in[2], out[0]);
}

static struct pw85_question const overlaps_question = {
    "overlaps",
    {
        [0] = {overlaps_2, true, 3,
               {{"r12", PW85_SEPARATION, 2, 0}, {"q1", PW85_FORM1, 3, 0}, {"q2", PW85_FORM2, 3, 0}},
                   1, {1}, {"overlap"}},
        [1] = {overlaps_3, true, 3,
               {{"r12", PW85_SEPARATION, 3, 0}, {"q1", PW85_FORM1, 6, 0}, {"q2", PW85_FORM2, 6, 0}},
                   1, {1}, {"overlap"}},
    },
};

static SEXP call_overlaps(SEXP x, SEXP y)
{
    SEXP const given[] = {x, y};
    return pw85_rows(&overlaps_question, 2, 0, given);
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

static struct pw85_question const compare_question = {
    "compare",
    {
        [1] = {compare_3, false, 4,
               {{"r12", PW85_SEPARATION, 3, 0}, {"q1", PW85_FORM1, 6, 0}, {"q2", PW85_FORM2, 6, 0},
                   {"mu2", PW85_VALUES, 1, 0}}, 1, {1}, {"sign"}},
    },
};

static SEXP call_compare(SEXP x, SEXP y, SEXP mu2)
{
    SEXP const given[] = {x, y, mu2};
    return pw85_rows(&compare_question, 2, 1, given);
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

static struct pw85_question const overlap_witness_question = {
    "overlap_witness",
    {
        [1] = {overlap_witness_3, false, 3,
               {{"r12", PW85_SEPARATION, 3, 0}, {"q1", PW85_FORM1, 6, 0}, {"q2", PW85_FORM2, 6, 0}},
                   3, {1, 1, 3}, {"overlap", "lambda", "point_x", "point_y", "point_z"}},
    },
};

static SEXP call_overlap_witness(SEXP x, SEXP y)
{
    SEXP const given[] = {x, y};
    return pw85_rows(&overlap_witness_question, 2, 0, given);
}

static int contains_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_contains_batch(n, in[0], in[1], in[2], out[0]);
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

static struct pw85_question const contains_question = {
    "contains",
    {
        [0] = {contains_2, true, 3,
               {{"r12", PW85_SEPARATION, 2, 0}, {"q1", PW85_FORM1, 3, 0}, {"q2", PW85_FORM2, 3, 0}},
                   1, {1}, {"contains"}},
        [1] = {contains_3, true, 3,
               {{"r12", PW85_SEPARATION, 3, 0}, {"q1", PW85_FORM1, 6, 0}, {"q2", PW85_FORM2, 6, 0}},
                   1, {1}, {"contains"}},
    },
};

static SEXP call_contains(SEXP x, SEXP y)
{
    SEXP const given[] = {x, y};
    return pw85_rows(&contains_question, 2, 0, given);
}

static int containment_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_containment_batch(n, in[0], in[1], in[2], out[0], out[1]);
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

static struct pw85_question const containment_question = {
    "containment",
    {
        [0] = {containment_2, false, 3,
               {{"r12", PW85_SEPARATION, 2, 0}, {"q1", PW85_FORM1, 3, 0}, {"q2", PW85_FORM2, 3, 0}},
                   2, {1, 2}, {"mu2", "point_x", "point_y"}},
        [1] = {containment_3, false, 3,
               {{"r12", PW85_SEPARATION, 3, 0}, {"q1", PW85_FORM1, 6, 0}, {"q2", PW85_FORM2, 6, 0}},
                   2, {1, 3}, {"mu2", "point_x", "point_y", "point_z"}},
    },
};

static SEXP call_containment(SEXP x, SEXP y)
{
    SEXP const given[] = {x, y};
    return pw85_rows(&containment_question, 2, 0, given);
}

static int closest_approach_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_closest_approach_batch(n, in[0], in[1], in[2], out[0]);
}

static int closest_approach_2(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_closest_approach_batch_2d(n, in[0], in[1], in[2], out[0]);
}

static struct pw85_question const closest_approach_question = {
    "closest_approach",
    {
        [0] = {closest_approach_2, false, 3,
               {{"direction", PW85_VALUES, 2, 0}, {"q1", PW85_FORM1, 3, 0}, {"q2", PW85_FORM2, 3,
                   0}}, 1, {1}, {"distance"}},
        [1] = {closest_approach_3, false, 3,
               {{"direction", PW85_VALUES, 3, 0}, {"q1", PW85_FORM1, 6, 0}, {"q2", PW85_FORM2, 6,
                   0}}, 1, {1}, {"distance"}},
    },
};

static SEXP call_closest_approach(SEXP x, SEXP y, SEXP direction)
{
    SEXP const given[] = {x, y, direction};
    return pw85_rows(&closest_approach_question, 2, 1, given);
}

static int volume_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_volume_batch(n, in[0], out[0]);
}

static struct pw85_question const volume_question = {
    "volume",
    {
        [1] = {volume_3, false, 1,
               {{"q", PW85_FORM1, 6, 0}}, 1, {1}, {"volume"}},
    },
};

static SEXP call_volume(SEXP x)
{
    SEXP const given[] = {x};
    return pw85_rows(&volume_question, 1, 0, given);
}

static int overlap_volume_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_overlap_volume_batch(n, in[0], in[1], in[2], out[0]);
}

static struct pw85_question const overlap_volume_question = {
    "overlap_volume",
    {
        [1] = {overlap_volume_3, false, 3,
               {{"r12", PW85_SEPARATION, 3, 0}, {"q1", PW85_FORM1, 6, 0}, {"q2", PW85_FORM2, 6, 0}},
                   1, {1}, {"volume"}},
    },
};

static SEXP call_overlap_volume(SEXP x, SEXP y)
{
    SEXP const given[] = {x, y};
    return pw85_rows(&overlap_volume_question, 2, 0, given);
}

static int overlap_volume_gradient_3(size_t n, double const *const *in, void *const *out, size_t
    *row)
{
    (void)row;
    return pw85_overlap_volume_gradient_batch(n, in[0], in[1], in[2], out[0], out[1], out[2]);
}

static struct pw85_question const overlap_volume_gradient_question = {
    "overlap_volume_gradient",
    {
        [1] = {overlap_volume_gradient_3, false, 3,
               {{"r12", PW85_SEPARATION, 3, 0}, {"q1", PW85_FORM1, 6, 0}, {"q2", PW85_FORM2, 6, 0}},
                   3, {3, 6, 6}, {"d_r12_x", "d_r12_y", "d_r12_z", "d_q1_xx", "d_q1_xy", "d_q1_xz",
                   "d_q1_yy", "d_q1_yz", "d_q1_zz", "d_q2_xx", "d_q2_xy", "d_q2_xz", "d_q2_yy",
                   "d_q2_yz", "d_q2_zz"}},
    },
};

static SEXP call_overlap_volume_gradient(SEXP x, SEXP y)
{
    SEXP const given[] = {x, y};
    return pw85_rows(&overlap_volume_gradient_question, 2, 0, given);
}

static int overlap_volume_torque_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_overlap_volume_torque_batch(n, in[0], in[1], in[2], out[0], out[1]);
}

static struct pw85_question const overlap_volume_torque_question = {
    "overlap_volume_torque",
    {
        [1] = {overlap_volume_torque_3, false, 3,
               {{"r12", PW85_SEPARATION, 3, 0}, {"q1", PW85_FORM1, 6, 0}, {"q2", PW85_FORM2, 6, 0}},
                   2, {3, 3}, {"d_rot1_x", "d_rot1_y", "d_rot1_z", "d_rot2_x", "d_rot2_y",
                   "d_rot2_z"}},
    },
};

static SEXP call_overlap_volume_torque(SEXP x, SEXP y)
{
    SEXP const given[] = {x, y};
    return pw85_rows(&overlap_volume_torque_question, 2, 0, given);
}

static int area_2(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_area_batch_2d(n, in[0], out[0]);
}

static struct pw85_question const area_question = {
    "area",
    {
        [0] = {area_2, false, 1,
               {{"q", PW85_FORM1, 3, 0}}, 1, {1}, {"area"}},
    },
};

static SEXP call_area(SEXP x)
{
    SEXP const given[] = {x};
    return pw85_rows(&area_question, 1, 0, given);
}

static int overlap_area_2(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_overlap_area_batch_2d(n, in[0], in[1], in[2], out[0]);
}

static struct pw85_question const overlap_area_question = {
    "overlap_area",
    {
        [0] = {overlap_area_2, false, 3,
               {{"r12", PW85_SEPARATION, 2, 0}, {"q1", PW85_FORM1, 3, 0}, {"q2", PW85_FORM2, 3, 0}},
                   1, {1}, {"area"}},
    },
};

static SEXP call_overlap_area(SEXP x, SEXP y)
{
    SEXP const given[] = {x, y};
    return pw85_rows(&overlap_area_question, 2, 0, given);
}

static int overlap_area_gradient_2(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_overlap_area_gradient_batch_2d(n, in[0], in[1], in[2], out[0], out[1], out[2]);
}

static struct pw85_question const overlap_area_gradient_question = {
    "overlap_area_gradient",
    {
        [0] = {overlap_area_gradient_2, false, 3,
               {{"r12", PW85_SEPARATION, 2, 0}, {"q1", PW85_FORM1, 3, 0}, {"q2", PW85_FORM2, 3, 0}},
                   3, {2, 3, 3}, {"d_r12_x", "d_r12_y", "d_q1_xx", "d_q1_xy", "d_q1_yy", "d_q2_xx",
                   "d_q2_xy", "d_q2_yy"}},
    },
};

static SEXP call_overlap_area_gradient(SEXP x, SEXP y)
{
    SEXP const given[] = {x, y};
    return pw85_rows(&overlap_area_gradient_question, 2, 0, given);
}

static int overlap_area_torque_2(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_overlap_area_torque_batch_2d(n, in[0], in[1], in[2], out[0], out[1]);
}

static struct pw85_question const overlap_area_torque_question = {
    "overlap_area_torque",
    {
        [0] = {overlap_area_torque_2, false, 3,
               {{"r12", PW85_SEPARATION, 2, 0}, {"q1", PW85_FORM1, 3, 0}, {"q2", PW85_FORM2, 3, 0}},
                   2, {1, 1}, {"d_rot1", "d_rot2"}},
    },
};

static SEXP call_overlap_area_torque(SEXP x, SEXP y)
{
    SEXP const given[] = {x, y};
    return pw85_rows(&overlap_area_torque_question, 2, 0, given);
}

static int distance_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_distance_batch(n, in[0], in[1], in[2], out[0], out[1], out[2]);
}

static int distance_2(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_distance_batch_2d(n, in[0], in[1], in[2], out[0], out[1], out[2]);
}

static struct pw85_question const distance_question = {
    "distance",
    {
        [0] = {distance_2, false, 3,
               {{"r12", PW85_SEPARATION, 2, 0}, {"q1", PW85_FORM1, 3, 0}, {"q2", PW85_FORM2, 3, 0}},
                   3, {1, 2, 2}, {"distance", "point1_x", "point1_y", "point2_x", "point2_y"}},
        [1] = {distance_3, false, 3,
               {{"r12", PW85_SEPARATION, 3, 0}, {"q1", PW85_FORM1, 6, 0}, {"q2", PW85_FORM2, 6, 0}},
                   3, {1, 3, 3}, {"distance", "point1_x", "point1_y", "point1_z", "point2_x",
                   "point2_y", "point2_z"}},
    },
};

static SEXP call_distance(SEXP x, SEXP y)
{
    SEXP const given[] = {x, y};
    return pw85_rows(&distance_question, 2, 0, given);
}

static int distance_derivatives_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_distance_derivatives_batch(n, in[0], in[1], in[2], out[0], out[1], out[2], out[3]);
}

static struct pw85_question const distance_derivatives_question = {
    "distance_derivatives",
    {
        [1] = {distance_derivatives_3, false, 3,
               {{"r12", PW85_SEPARATION, 3, 0}, {"q1", PW85_FORM1, 6, 0}, {"q2", PW85_FORM2, 6, 0}},
                   4, {3, 3, 3, 81}, {"d_r12_x", "d_r12_y", "d_r12_z", "d_rot1_x", "d_rot1_y",
                   "d_rot1_z", "d_rot2_x", "d_rot2_y", "d_rot2_z", "hessian_1", "hessian_2",
                   "hessian_3", "hessian_4", "hessian_5", "hessian_6", "hessian_7", "hessian_8",
                   "hessian_9", "hessian_10", "hessian_11", "hessian_12", "hessian_13",
                   "hessian_14", "hessian_15", "hessian_16", "hessian_17", "hessian_18",
                   "hessian_19", "hessian_20", "hessian_21", "hessian_22", "hessian_23",
                   "hessian_24", "hessian_25", "hessian_26", "hessian_27", "hessian_28",
                   "hessian_29", "hessian_30", "hessian_31", "hessian_32", "hessian_33",
                   "hessian_34", "hessian_35", "hessian_36", "hessian_37", "hessian_38",
                   "hessian_39", "hessian_40", "hessian_41", "hessian_42", "hessian_43",
                   "hessian_44", "hessian_45", "hessian_46", "hessian_47", "hessian_48",
                   "hessian_49", "hessian_50", "hessian_51", "hessian_52", "hessian_53",
                   "hessian_54", "hessian_55", "hessian_56", "hessian_57", "hessian_58",
                   "hessian_59", "hessian_60", "hessian_61", "hessian_62", "hessian_63",
                   "hessian_64", "hessian_65", "hessian_66", "hessian_67", "hessian_68",
                   "hessian_69", "hessian_70", "hessian_71", "hessian_72", "hessian_73",
                   "hessian_74", "hessian_75", "hessian_76", "hessian_77", "hessian_78",
                   "hessian_79", "hessian_80", "hessian_81"}},
    },
};

static SEXP call_distance_derivatives(SEXP x, SEXP y)
{
    SEXP const given[] = {x, y};
    return pw85_rows(&distance_derivatives_question, 2, 0, given);
}

static int penetration_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_penetration_batch(n, in[0], in[1], in[2], out[0], out[1]);
}

static int penetration_2(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_penetration_batch_2d(n, in[0], in[1], in[2], out[0], out[1]);
}

static struct pw85_question const penetration_question = {
    "penetration",
    {
        [0] = {penetration_2, false, 3,
               {{"r12", PW85_SEPARATION, 2, 0}, {"q1", PW85_FORM1, 3, 0}, {"q2", PW85_FORM2, 3, 0}},
                   2, {1, 2}, {"depth", "direction_x", "direction_y"}},
        [1] = {penetration_3, false, 3,
               {{"r12", PW85_SEPARATION, 3, 0}, {"q1", PW85_FORM1, 6, 0}, {"q2", PW85_FORM2, 6, 0}},
                   2, {1, 3}, {"depth", "direction_x", "direction_y", "direction_z"}},
    },
};

static SEXP call_penetration(SEXP x, SEXP y)
{
    SEXP const given[] = {x, y};
    return pw85_rows(&penetration_question, 2, 0, given);
}

static int signed_distance_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_signed_distance_batch(n, in[0], in[1], in[2], out[0], out[1], out[2]);
}

static int signed_distance_2(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_signed_distance_batch_2d(n, in[0], in[1], in[2], out[0], out[1], out[2]);
}

static struct pw85_question const signed_distance_question = {
    "signed_distance",
    {
        [0] = {signed_distance_2, false, 3,
               {{"r12", PW85_SEPARATION, 2, 0}, {"q1", PW85_FORM1, 3, 0}, {"q2", PW85_FORM2, 3, 0}},
                   3, {1, 2, 2}, {"distance", "point1_x", "point1_y", "point2_x", "point2_y"}},
        [1] = {signed_distance_3, false, 3,
               {{"r12", PW85_SEPARATION, 3, 0}, {"q1", PW85_FORM1, 6, 0}, {"q2", PW85_FORM2, 6, 0}},
                   3, {1, 3, 3}, {"distance", "point1_x", "point1_y", "point1_z", "point2_x",
                   "point2_y", "point2_z"}},
    },
};

static SEXP call_signed_distance(SEXP x, SEXP y)
{
    SEXP const given[] = {x, y};
    return pw85_rows(&signed_distance_question, 2, 0, given);
}

static int signed_distance_derivatives_3(size_t n, double const *const *in, void *const *out, size_t
    *row)
{
    (void)row;
    return pw85_signed_distance_derivatives_batch(n, in[0], in[1], in[2], out[0], out[1], out[2],
        out[3]);
}

static struct pw85_question const signed_distance_derivatives_question = {
    "signed_distance_derivatives",
    {
        [1] = {signed_distance_derivatives_3, false, 3,
               {{"r12", PW85_SEPARATION, 3, 0}, {"q1", PW85_FORM1, 6, 0}, {"q2", PW85_FORM2, 6, 0}},
                   4, {3, 3, 3, 81}, {"d_r12_x", "d_r12_y", "d_r12_z", "d_rot1_x", "d_rot1_y",
                   "d_rot1_z", "d_rot2_x", "d_rot2_y", "d_rot2_z", "hessian_1", "hessian_2",
                   "hessian_3", "hessian_4", "hessian_5", "hessian_6", "hessian_7", "hessian_8",
                   "hessian_9", "hessian_10", "hessian_11", "hessian_12", "hessian_13",
                   "hessian_14", "hessian_15", "hessian_16", "hessian_17", "hessian_18",
                   "hessian_19", "hessian_20", "hessian_21", "hessian_22", "hessian_23",
                   "hessian_24", "hessian_25", "hessian_26", "hessian_27", "hessian_28",
                   "hessian_29", "hessian_30", "hessian_31", "hessian_32", "hessian_33",
                   "hessian_34", "hessian_35", "hessian_36", "hessian_37", "hessian_38",
                   "hessian_39", "hessian_40", "hessian_41", "hessian_42", "hessian_43",
                   "hessian_44", "hessian_45", "hessian_46", "hessian_47", "hessian_48",
                   "hessian_49", "hessian_50", "hessian_51", "hessian_52", "hessian_53",
                   "hessian_54", "hessian_55", "hessian_56", "hessian_57", "hessian_58",
                   "hessian_59", "hessian_60", "hessian_61", "hessian_62", "hessian_63",
                   "hessian_64", "hessian_65", "hessian_66", "hessian_67", "hessian_68",
                   "hessian_69", "hessian_70", "hessian_71", "hessian_72", "hessian_73",
                   "hessian_74", "hessian_75", "hessian_76", "hessian_77", "hessian_78",
                   "hessian_79", "hessian_80", "hessian_81"}},
    },
};

static SEXP call_signed_distance_derivatives(SEXP x, SEXP y)
{
    SEXP const given[] = {x, y};
    return pw85_rows(&signed_distance_derivatives_question, 2, 0, given);
}

static int gap_inside_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_gap_inside_batch(n, in[0], in[1], in[2], out[0], out[1], out[2], out[3]);
}

static int gap_inside_2(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_gap_inside_batch_2d(n, in[0], in[1], in[2], out[0], out[1], out[2], out[3]);
}

static struct pw85_question const gap_inside_question = {
    "gap_inside",
    {
        [0] = {gap_inside_2, false, 3,
               {{"r12", PW85_SEPARATION, 2, 0}, {"q1", PW85_FORM1, 3, 0}, {"q2", PW85_FORM2, 3, 0}},
                   4, {1, 2, 2, 2}, {"gap", "point1_x", "point1_y", "point2_x", "point2_y",
                   "normal_x", "normal_y"}},
        [1] = {gap_inside_3, false, 3,
               {{"r12", PW85_SEPARATION, 3, 0}, {"q1", PW85_FORM1, 6, 0}, {"q2", PW85_FORM2, 6, 0}},
                   4, {1, 3, 3, 3}, {"gap", "point1_x", "point1_y", "point1_z", "point2_x",
                   "point2_y", "point2_z", "normal_x", "normal_y", "normal_z"}},
    },
};

static SEXP call_gap_inside(SEXP x, SEXP y)
{
    SEXP const given[] = {x, y};
    return pw85_rows(&gap_inside_question, 2, 0, given);
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

static struct pw85_question const first_contact_question = {
    "first_contact",
    {
        [1] = {first_contact_3, false, 6,
               {{"r12", PW85_SEPARATION, 3, 0}, {"q1", PW85_FORM1, 6, 0}, {"q2", PW85_FORM2, 6, 0},
                   {"motion1", PW85_VALUES, 7, 0}, {"motion2", PW85_VALUES, 7, 1}, {"t_max",
                   PW85_VALUES, 1, 2}}, 1, {1}, {"t"}},
    },
};

static SEXP call_first_contact(SEXP x, SEXP y, SEXP motion1, SEXP motion2, SEXP t_max)
{
    SEXP const given[] = {x, y, motion1, motion2, t_max};
    return pw85_rows(&first_contact_question, 2, 3, given);
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

static struct pw85_question const closest_passage_question = {
    "closest_passage",
    {
        [1] = {closest_passage_3, false, 5,
               {{"r12", PW85_SEPARATION, 3, 0}, {"q1", PW85_FORM1, 6, 0}, {"q2", PW85_FORM2, 6, 0},
                   {"velocity", PW85_VALUES, 3, 0}, {"t_max", PW85_VALUES, 1, 1}}, 2, {1, 1},
                   {"mu2", "t"}},
    },
};

static SEXP call_closest_passage(SEXP x, SEXP y, SEXP velocity, SEXP t_max)
{
    SEXP const given[] = {x, y, velocity, t_max};
    return pw85_rows(&closest_passage_question, 2, 2, given);
}

static int free_path_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_free_path_batch(n, in[0], in[1], in[2], in[3], in[4], out[0]);
}

static struct pw85_question const free_path_question = {
    "free_path",
    {
        [1] = {free_path_3, false, 5,
               {{"r12", PW85_SEPARATION, 3, 0}, {"q1", PW85_FORM1, 6, 0}, {"q2", PW85_FORM2, 6, 0},
                   {"direction", PW85_VALUES, 3, 0}, {"t_max", PW85_VALUES, 1, 1}}, 1, {1}, {"t"}},
    },
};

static SEXP call_free_path(SEXP x, SEXP y, SEXP direction, SEXP t_max)
{
    SEXP const given[] = {x, y, direction, t_max};
    return pw85_rows(&free_path_question, 2, 2, given);
}

static int hertz_contact_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_hertz_contact_batch(n, in[0], in[1], in[2], in[3], out[0], out[1], out[2], out[3],
        out[4], out[5]);
}

static struct pw85_question const hertz_contact_question = {
    "hertz_contact",
    {
        [1] = {hertz_contact_3, false, 4,
               {{"r12", PW85_SEPARATION, 3, 0}, {"q1", PW85_FORM1, 6, 0}, {"q2", PW85_FORM2, 6, 0},
                   {"normal", PW85_VALUES, 3, 0}}, 6, {1, 3, 2, 6, 1, 2}, {"depth", "point_x",
                   "point_y", "point_z", "curvatures_1", "curvatures_2", "directions_1",
                   "directions_2", "directions_3", "directions_4", "directions_5", "directions_6",
                   "radius", "ellipse_1", "ellipse_2"}},
    },
};

static SEXP call_hertz_contact(SEXP x, SEXP y, SEXP normal)
{
    SEXP const given[] = {x, y, normal};
    return pw85_rows(&hertz_contact_question, 2, 1, given);
}

static int grain_contact_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_grain_contact_batch(n, in[0], in[1], in[2], in[3], out[0], out[1], out[2], out[3],
        out[4]);
}

static struct pw85_question const grain_contact_question = {
    "grain_contact",
    {
        [1] = {grain_contact_3, false, 4,
               {{"r12", PW85_SEPARATION, 3, 0}, {"q1", PW85_FORM1, 6, 0}, {"q2", PW85_FORM2, 6, 0},
                   {"start", PW85_VALUES, 3, 0}}, 5, {3, 1, 3, 2, 1}, {"normal_x", "normal_y",
                   "normal_z", "depth", "point_x", "point_y", "point_z", "curvatures_1",
                   "curvatures_2", "radius"}},
    },
};

static SEXP call_grain_contact(SEXP x, SEXP y, SEXP start)
{
    SEXP const given[] = {x, y, start};
    return pw85_rows(&grain_contact_question, 2, 1, given);
}

static int grain_radius_gradient_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_grain_radius_gradient_batch(n, in[0], in[1], in[2], in[3], out[0], out[1], out[2]);
}

static struct pw85_question const grain_radius_gradient_question = {
    "grain_radius_gradient",
    {
        [1] = {grain_radius_gradient_3, false, 4,
               {{"r12", PW85_SEPARATION, 3, 0}, {"q1", PW85_FORM1, 6, 0}, {"q2", PW85_FORM2, 6, 0},
                   {"normal", PW85_VALUES, 3, 0}}, 3, {3, 3, 3}, {"d_r12_x", "d_r12_y", "d_r12_z",
                   "d_rot1_x", "d_rot1_y", "d_rot1_z", "d_rot2_x", "d_rot2_y", "d_rot2_z"}},
    },
};

static SEXP call_grain_radius_gradient(SEXP x, SEXP y, SEXP normal)
{
    SEXP const given[] = {x, y, normal};
    return pw85_rows(&grain_radius_gradient_question, 2, 1, given);
}

static int surface_area_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_surface_area_batch(n, in[0], out[0]);
}

static struct pw85_question const surface_area_question = {
    "surface_area",
    {
        [1] = {surface_area_3, false, 1,
               {{"q", PW85_FORM1, 6, 0}}, 1, {1}, {"area"}},
    },
};

static SEXP call_surface_area(SEXP x)
{
    SEXP const given[] = {x};
    return pw85_rows(&surface_area_question, 1, 0, given);
}

static int second_moments_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_second_moments_batch(n, in[0], out[0]);
}

static int second_moments_2(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_second_moments_batch_2d(n, in[0], out[0]);
}

static struct pw85_question const second_moments_question = {
    "second_moments",
    {
        [0] = {second_moments_2, false, 1,
               {{"q", PW85_FORM1, 3, 0}}, 1, {3}, {"xx", "xy", "yy"}},
        [1] = {second_moments_3, false, 1,
               {{"q", PW85_FORM1, 6, 0}}, 1, {6}, {"xx", "xy", "xz", "yy", "yz", "zz"}},
    },
};

static SEXP call_second_moments(SEXP x)
{
    SEXP const given[] = {x};
    return pw85_rows(&second_moments_question, 1, 0, given);
}

static int shell_moments_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_shell_moments_batch(n, in[0], out[0]);
}

static int shell_moments_2(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_shell_moments_batch_2d(n, in[0], out[0]);
}

static struct pw85_question const shell_moments_question = {
    "shell_moments",
    {
        [0] = {shell_moments_2, false, 1,
               {{"q", PW85_FORM1, 3, 0}}, 1, {3}, {"xx", "xy", "yy"}},
        [1] = {shell_moments_3, false, 1,
               {{"q", PW85_FORM1, 6, 0}}, 1, {6}, {"xx", "xy", "xz", "yy", "yz", "zz"}},
    },
};

static SEXP call_shell_moments(SEXP x)
{
    SEXP const given[] = {x};
    return pw85_rows(&shell_moments_question, 1, 0, given);
}

static int perimeter_2(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_perimeter_batch_2d(n, in[0], out[0]);
}

static struct pw85_question const perimeter_question = {
    "perimeter",
    {
        [0] = {perimeter_2, false, 1,
               {{"q", PW85_FORM1, 3, 0}}, 1, {1}, {"perimeter"}},
    },
};

static SEXP call_perimeter(SEXP x)
{
    SEXP const given[] = {x};
    return pw85_rows(&perimeter_question, 1, 0, given);
}

static int contact_derivatives_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_contact_derivatives_batch(n, in[0], in[1], in[2], out[0], out[1], out[2], out[3],
        out[4], out[5], out[6]);
}

static struct pw85_question const contact_derivatives_question = {
    "contact_derivatives",
    {
        [1] = {contact_derivatives_3, false, 3,
               {{"r12", PW85_SEPARATION, 3, 0}, {"q1", PW85_FORM1, 6, 0}, {"q2", PW85_FORM2, 6, 0}},
                   7, {1, 1, 3, 3, 3, 3, 3}, {"mu2", "lambda", "point_x", "point_y", "point_z",
                   "normal_x", "normal_y", "normal_z", "d_r12_x", "d_r12_y", "d_r12_z", "d_rot1_x",
                   "d_rot1_y", "d_rot1_z", "d_rot2_x", "d_rot2_y", "d_rot2_z"}},
    },
};

static SEXP call_contact_derivatives(SEXP x, SEXP y)
{
    SEXP const given[] = {x, y};
    return pw85_rows(&contact_derivatives_question, 2, 0, given);
}

static int bounding_boxes_3(size_t n, double const *const *in, void *const *out, size_t *row)
{
    (void)row;
    return pw85_bounding_boxes(n, in[0], out[0]);
}

static struct pw85_question const bounding_boxes_question = {
    "bounding_boxes",
    {
        [1] = {bounding_boxes_3, false, 1,
               {{"q", PW85_FORM1, 6, 0}}, 1, {3}, {"x", "y", "z"}},
    },
};

static SEXP call_bounding_boxes(SEXP x)
{
    SEXP const given[] = {x};
    return pw85_rows(&bounding_boxes_question, 1, 0, given);
}

R_CallMethodDef const pw85_questions[] = {
    {"ellipsoid", (DL_FUNC)&call_ellipsoid, 2},
    {"ellipsoid_quaternion", (DL_FUNC)&call_ellipsoid_quaternion, 2},
    {"ellipse", (DL_FUNC)&call_ellipse, 3},
    {"contact", (DL_FUNC)&call_contact, 2},
    {"contact_rounded", (DL_FUNC)&call_contact_rounded, 2},
    {"condition", (DL_FUNC)&call_condition, 3},
    {"contact_function", (DL_FUNC)&call_contact_function, 2},
    {"contact_geometry", (DL_FUNC)&call_contact_geometry, 3},
    {"contact_gradient", (DL_FUNC)&call_contact_gradient, 3},
    {"contact_torque", (DL_FUNC)&call_contact_torque, 3},
    {"contact_hessian", (DL_FUNC)&call_contact_hessian, 3},
    {"overlaps", (DL_FUNC)&call_overlaps, 2},
    {"compare", (DL_FUNC)&call_compare, 3},
    {"overlap_witness", (DL_FUNC)&call_overlap_witness, 2},
    {"contains", (DL_FUNC)&call_contains, 2},
    {"containment", (DL_FUNC)&call_containment, 2},
    {"closest_approach", (DL_FUNC)&call_closest_approach, 3},
    {"volume", (DL_FUNC)&call_volume, 1},
    {"overlap_volume", (DL_FUNC)&call_overlap_volume, 2},
    {"overlap_volume_gradient", (DL_FUNC)&call_overlap_volume_gradient, 2},
    {"overlap_volume_torque", (DL_FUNC)&call_overlap_volume_torque, 2},
    {"area", (DL_FUNC)&call_area, 1},
    {"overlap_area", (DL_FUNC)&call_overlap_area, 2},
    {"overlap_area_gradient", (DL_FUNC)&call_overlap_area_gradient, 2},
    {"overlap_area_torque", (DL_FUNC)&call_overlap_area_torque, 2},
    {"distance", (DL_FUNC)&call_distance, 2},
    {"distance_derivatives", (DL_FUNC)&call_distance_derivatives, 2},
    {"penetration", (DL_FUNC)&call_penetration, 2},
    {"signed_distance", (DL_FUNC)&call_signed_distance, 2},
    {"signed_distance_derivatives", (DL_FUNC)&call_signed_distance_derivatives, 2},
    {"gap_inside", (DL_FUNC)&call_gap_inside, 2},
    {"first_contact", (DL_FUNC)&call_first_contact, 5},
    {"closest_passage", (DL_FUNC)&call_closest_passage, 4},
    {"free_path", (DL_FUNC)&call_free_path, 4},
    {"hertz_contact", (DL_FUNC)&call_hertz_contact, 3},
    {"grain_contact", (DL_FUNC)&call_grain_contact, 3},
    {"grain_radius_gradient", (DL_FUNC)&call_grain_radius_gradient, 3},
    {"surface_area", (DL_FUNC)&call_surface_area, 1},
    {"second_moments", (DL_FUNC)&call_second_moments, 1},
    {"shell_moments", (DL_FUNC)&call_shell_moments, 1},
    {"perimeter", (DL_FUNC)&call_perimeter, 1},
    {"contact_derivatives", (DL_FUNC)&call_contact_derivatives, 2},
    {"bounding_boxes", (DL_FUNC)&call_bounding_boxes, 1},
    {NULL, NULL, 0},
};
