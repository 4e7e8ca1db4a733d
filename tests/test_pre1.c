/* SPDX-License-Identifier: BSD-3-Clause */
/* A program for the API before pw85 1.0. It is C and C++, and is compiled as both. */
#include <pw85_pre1.h>

#include <math.h>

#include <glib.h>

/* Old declarations took pointers to non-const double: such arrays still pass. */
static double r12[PW85_DIM] = {0.7, -0.7, 1.1};
static double q1[PW85_SYM] = {100.0, 0.0, 0.0, 100.0, 0.0, 0.01};
static double q2[PW85_SYM] = {25.0, 0.0, 0.0, 0.25, 0.0, 0.25};

static void test_full_output(void)
{
    double out[2], expected[2];
    double const mu2 = pw85_contact_function(r12, q1, q2, out);
    int const status = pw85_pre1_current_contact_function(r12, q1, q2, expected);
    g_assert_cmpint(status, ==, PW85_SUCCESS);
    g_assert_cmpfloat(mu2, ==, expected[0]);
    g_assert_cmpfloat(out[0], ==, expected[0]);
    g_assert_cmpfloat(out[1], ==, expected[1]);
    /* The value in the manual of 1.0, which erred by 3e-13. */
    g_assert_cmpfloat(fabs(mu2 - 3.362706040638343), <, 1e-12);
}

static void test_optional_output(void)
{
    double const mu2 = pw85_contact_function(r12, q1, q2, NULL);
    g_assert_cmpfloat(mu2, ==, pw85_pre1_contact_function(r12, q1, q2, NULL));
    g_assert_cmpfloat(fabs(mu2 - 3.362706040638343), <, 1e-12);
}

static void test_invalid(void)
{
    double const indefinite[PW85_SYM] = {1.0, 2.0, 0.0, 1.0, 0.0, 1.0};
    double out[2] = {0.0, 0.0};
    g_assert_true(isnan(pw85_contact_function(r12, indefinite, q2, out)));
    g_assert_true(isnan(out[0]) && isnan(out[1]));
    g_assert_true(isnan(pw85_contact_function(r12, q1, NULL, NULL)));
}

static void test_polynomials(void)
{
    double q3[PW85_SYM], q4[PW85_SYM], a[PW85_DIM], b[PW85_DIM + 1];
    for (int i = 0; i < PW85_SYM; i++) {
        q3[i] = 2.0 * q1[i] - q2[i];
        q4[i] = 0.5 * (q1[i] + q2[i]);
    }
    pw85__rT_adjQ_r_as_poly(r12, q1, q2, q3, a);
    pw85__detQ_as_poly(q1, q2, q3, q4, b);
    g_assert_cmpfloat(a[0], ==, pw85__xT_adjA_x(r12, q1));
    g_assert_cmpfloat(b[0], ==, pw85__det_sym(q1));
    g_assert_cmpfloat(fabs(pw85__det_sym(q1) - 100.0), <, 1e-12);
    /* adj(Q1) = diag(1, 1, 1e4). */
    g_assert_cmpfloat(fabs(pw85__xT_adjA_x(r12, q1) - 12100.98), <, 1e-10);
}

static void test_spheroid(void)
{
    double n[PW85_DIM] = {0.0, 0.0, 1.0}, q[PW85_SYM];
    pw85_spheroid(10.0, 0.1, n, q);
    for (int i = 0; i < PW85_SYM; i++) g_assert_cmpfloat(fabs(q[i] - q1[i]), <, 1e-13);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/pre1/contact_function/full_output", test_full_output);
    g_test_add_func("/pre1/contact_function/optional_output", test_optional_output);
    g_test_add_func("/pre1/contact_function/invalid", test_invalid);
    g_test_add_func("/pre1/polynomials", test_polynomials);
    g_test_add_func("/pre1/spheroid", test_spheroid);
    return g_test_run();
}
