// Tests of every status of every function that has one, with the outputs; of the version, and of the texts of statuses.
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <vector>

#include <glib.h>

#include <pw85.h>

#include "sample.hpp"

using pw85_tests::hex_text;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();

/// A valid pair, in two and three dimensions, whose parts the cases spoil.
struct Arguments {
    double r12[3] = {1.0, -2.0, 3.0};
    double q1[6] = {4.0, 0.5, 0.0, 3.0, 0.0, 2.0}, q2[6] = {1.0, 0.0, 0.25, 2.0, 0.0, 1.0};
    double flat1[3] = {4.0, 1.0, 2.0}, flat2[3] = {1.0, 0.0, 2.0};
    double lambda = 0.25;
};

/// Outputs that a function must fill with NaN when it fails.
struct Outputs {
    std::vector<double> values = std::vector<double>(82, 0.0);
    double *data() { return values.data(); }
};

/// A function of a pair, reduced to what status tests vary: pointers to r12, q1, q2 (of its dimension), λ, an output.
struct Function {
    char const *name;
    int dimension;
    int outputs;          ///< numbers written
    bool takes_lambda;    ///< and so requires it to be in [0, 1]
    bool takes_direction; ///< where zero is invalid; λ = 1/2 and success elsewhere
    std::function<int(double const *, double const *, double const *, double, double *)> call;
};

std::vector<Function> const &functions()
{
    static std::vector<Function> const list = {
        {"contact", 3, 2, false, false,
         [](auto r, auto q1, auto q2, double, double *out) { return pw85_contact(r, q1, q2, out); }},
        {"contact_function", 3, 2, false, false,
         [](auto r, auto q1, auto q2, double, double *out) { return pw85_contact_function(r, q1, q2, out); }},
        {"contact_2d", 2, 2, false, false,
         [](auto r, auto q1, auto q2, double, double *out) { return pw85_contact_2d(r, q1, q2, out); }},
        {"closest_approach", 3, 1, false, true,
         [](auto r, auto q1, auto q2, double, double *out) { return pw85_closest_approach(r, q1, q2, out); }},
        {"closest_approach_2d", 2, 1, false, true,
         [](auto r, auto q1, auto q2, double, double *out) { return pw85_closest_approach_2d(r, q1, q2, out); }},
        {"distance", 3, 1, false, false,
         [](auto r, auto q1, auto q2, double, double *out) { return pw85_distance(r, q1, q2, out, nullptr, nullptr); }},
        {"distance_2d", 2, 1, false, false,
         [](auto r, auto q1, auto q2, double, double *out) {
             return pw85_distance_2d(r, q1, q2, out, nullptr, nullptr);
         }},
        {"penetration", 3, 1, false, false,
         [](auto r, auto q1, auto q2, double, double *out) { return pw85_penetration(r, q1, q2, out, nullptr); }},
        {"first_contact", 3, 1, false, false,
         [](auto r, auto q1, auto q2, double, double *out) {
             pw85_motion const motion{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 0.5}, still{};
             return pw85_first_contact(r, q1, q2, &motion, &still, 1.0, out);
         }},
        {"first_contact of a translation", 3, 1, false, false,
         [](auto r, auto q1, auto q2, double, double *out) {
             pw85_motion const still{};
             return pw85_first_contact(r, q1, q2, &still, &still, 1.0, out);
         }},
        {"contact_geometry", 3, 6, true, true,
         [](auto r, auto q1, auto q2, double lambda, double *out) {
             return pw85_contact_geometry(r, q1, q2, lambda, out, out + 3);
         }},
        {"contact_gradient", 3, 15, true, false,
         [](auto r, auto q1, auto q2, double lambda, double *out) {
             return pw85_contact_gradient(r, q1, q2, lambda, out, out + 3, out + 9);
         }},
        {"contact_torque", 3, 6, true, false,
         [](auto r, auto q1, auto q2, double lambda,
            double *out) { return pw85_contact_torque(r, q1, q2, lambda, out, out + 3); }},
        {"contact_hessian", 3, 81, true, true,
         [](auto r, auto q1, auto q2, double lambda,
            double *out) { return pw85_contact_hessian(r, q1, q2, lambda, out); }},
        {"contact_geometry_2d", 2, 4, true, true,
         [](auto r, auto q1, auto q2, double lambda,
            double *out) { return pw85_contact_geometry_2d(r, q1, q2, lambda, out, out + 2); }},
        {"contact_gradient_2d", 2, 8, true, false,
         [](auto r, auto q1, auto q2, double lambda,
            double *out) { return pw85_contact_gradient_2d(r, q1, q2, lambda, out, out + 2, out + 5); }},
        {"contact_torque_2d", 2, 2, true, false,
         [](auto r, auto q1, auto q2, double lambda,
            double *out) { return pw85_contact_torque_2d(r, q1, q2, lambda, out, out + 1); }},
        {"contact_hessian_2d", 2, 16, true, true,
         [](auto r, auto q1, auto q2, double lambda,
            double *out) { return pw85_contact_hessian_2d(r, q1, q2, lambda, out); }},
    };
    return list;
}

void expect(Function const &f, int expected, double const *r12, double const *q1, double const *q2, double lambda)
{
    Outputs out;
    int const status = f.call(r12, q1, q2, lambda, out.data());
    if (status != expected) {
        auto const text = [](double const *x, int count) { return x ? hex_text(x, count) : "null"; };
        int const d = f.dimension, size = d * (d + 1) / 2;
        g_test_message("%s: %d instead of %d for r12 = %s, q1 = %s, q2 = %s, lambda = %a", f.name, status, expected,
                       text(r12, d).c_str(), text(q1, size).c_str(), text(q2, size).c_str(), lambda);
    }
    g_assert_cmpint(status, ==, expected);
    for (int i = 0; i < 82; ++i) {
        double const x = out.values[static_cast<std::size_t>(i)];
        if (i >= f.outputs)
            g_assert_cmpfloat(x, ==, 0.0);
        else
            g_assert_true(std::isnan(x) == (expected != PW85_SUCCESS));
    }
}

void expect(Function const &f, int expected, Arguments const &a)
{
    bool const flat = f.dimension == 2;
    expect(f, expected, a.r12, flat ? a.flat1 : a.q1, flat ? a.flat2 : a.q2, a.lambda);
}

void test_success()
{
    for (auto const &f : functions()) expect(f, PW85_SUCCESS, Arguments{});
}

void test_null_inputs()
{
    Arguments const a;
    for (auto const &f : functions()) {
        expect(f, PW85_EINVAL, nullptr, a.q1, a.q2, a.lambda);
        expect(f, PW85_EINVAL, a.r12, nullptr, a.q2, a.lambda);
        expect(f, PW85_EINVAL, a.r12, a.q1, nullptr, a.lambda);
    }
}

void test_null_outputs()
{
    Arguments const a;
    g_assert_cmpint(pw85_contact(a.r12, a.q1, a.q2, nullptr), ==, PW85_EINVAL);
    g_assert_cmpint(pw85_contact_function(a.r12, a.q1, a.q2, nullptr), ==, PW85_EINVAL);
    g_assert_cmpint(pw85_contact_2d(a.r12, a.flat1, a.flat2, nullptr), ==, PW85_EINVAL);
    g_assert_cmpint(pw85_closest_approach(a.r12, a.q1, a.q2, nullptr), ==, PW85_EINVAL);
    g_assert_cmpint(pw85_closest_approach_2d(a.r12, a.flat1, a.flat2, nullptr), ==, PW85_EINVAL);
    g_assert_cmpint(pw85_ellipse(1.0, 2.0, 0.0, nullptr), ==, PW85_EINVAL);
    g_assert_cmpint(pw85_ellipsoid(a.r12, a.q1, nullptr), ==, PW85_EINVAL);
    g_assert_cmpint(pw85_ellipsoid_quaternion(a.r12, a.q1, nullptr), ==, PW85_EINVAL);
    pw85_spheroid(1.0, 2.0, a.r12, nullptr);
    pw85__residual(0.5, a.r12, a.q1, a.q2, nullptr);
    pw85__cholesky_decomp(a.q1, nullptr);
    pw85__cholesky_solve(a.q1, a.r12, nullptr);
}

void test_null_inputs_of_builders()
{
    double const axes[3] = {1.0, 2.0, 3.0};
    double q[6] = {};
    auto const all_nan = [&] {
        for (double &x : q) {
            g_assert_true(std::isnan(x));
            x = 0.0;
        }
    };
    g_assert_cmpint(pw85_ellipsoid(nullptr, axes, q), ==, PW85_EINVAL);
    all_nan();
    g_assert_cmpint(pw85_ellipsoid(axes, nullptr, q), ==, PW85_EINVAL);
    all_nan();
    g_assert_cmpint(pw85_ellipsoid_quaternion(nullptr, axes, q), ==, PW85_EINVAL);
    all_nan();
    g_assert_cmpint(pw85_ellipsoid_quaternion(axes, nullptr, q), ==, PW85_EINVAL);
    all_nan();
    pw85_spheroid(1.0, 2.0, nullptr, q);
    all_nan();
    pw85__cholesky_decomp(nullptr, q);
    all_nan();
}

void test_not_finite()
{
    for (auto const &f : functions())
        for (double const bad : {nan, infinity, -infinity}) {
            for (int i = 0; i < f.dimension; ++i) {
                Arguments a;
                a.r12[i] = bad;
                expect(f, PW85_EINVAL, a);
            }
            for (int k = 0; k < f.dimension * (f.dimension + 1) / 2; ++k) {
                Arguments a, b;
                a.q1[k] = b.q2[k] = bad;
                if (k < 3) a.flat1[k] = b.flat2[k] = bad;
                expect(f, PW85_EINVAL, a);
                expect(f, PW85_EINVAL, b);
            }
        }
}

// Negative, indefinite, singular and zero forms; also at magnitudes where products leave the range of double. Factors are
// powers of two, so that the pivots of singular forms are zero without a rounding error.
void test_not_positive_definite()
{
    double const bad[][6] = {{-4.0, 0.0, 0.0, -3.0, 0.0, -2.0}, {1.0, 0.0, 0.0, 1.0, 0.0, -1.0},
                             {1.0, 2.0, 0.0, 1.0, 0.0, 1.0},    {1.0, 0.0, 0.0, 1.0, 1.0, 1.0},
                             {1.0, 0.0, 0.0, 0.0, 0.0, 1.0},    {0.0, 0.0, 0.0, 0.0, 0.0, 0.0},
                             {1.0, 1.0, 1.0, 1.0, 1.0, 1.0}};
    double const flat[][3] = {{-1.0, 0.0, -1.0}, {1.0, 2.0, 1.0}, {1.0, 1.0, 1.0}, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}};
    for (auto const &f : functions())
        for (double const factor : {1.0, 0x1p-500, 0x1p-990, 0x1p990})
            for (std::size_t n = 0; n < std::size(bad); ++n) {
                Arguments a, b;
                for (int k = 0; k < 6; ++k) a.q1[k] = b.q2[k] = factor * bad[n][k];
                for (int k = 0; k < 3; ++k) a.flat1[k] = b.flat2[k] = factor * flat[n % std::size(flat)][k];
                expect(f, PW85_ENOTPD, a);
                expect(f, PW85_ENOTPD, b);
            }
}

// Not even r12 = 0 hides a bad form.
void test_concentric_and_bad()
{
    double const zero[3] = {0.0, 0.0, 0.0}, bad[6] = {1.0, 2.0, 0.0, 1.0, 0.0, 1.0};
    Arguments const a;
    double out[2];
    g_assert_cmpint(pw85_contact(zero, bad, a.q2, out), ==, PW85_ENOTPD);
    g_assert_cmpint(pw85_contact_function(zero, a.q1, bad, out), ==, PW85_ENOTPD);
}

void test_zero_separation()
{
    for (auto const &f : functions()) {
        Arguments a;
        a.r12[0] = a.r12[1] = a.r12[2] = 0.0;
        expect(f, f.takes_direction ? PW85_EINVAL : PW85_SUCCESS, a);
    }
}

void test_lambda_out_of_range()
{
    for (auto const &f : functions())
        for (double const bad : {-1e-300, 1.0 + 0x1p-52, -1.0, 2.0, nan, infinity}) {
            Arguments a;
            a.lambda = bad;
            expect(f, f.takes_lambda ? PW85_EINVAL : PW85_SUCCESS, a);
        }
    for (auto const &f : functions())
        for (double const end : {0.0, 1.0}) {
            Arguments a;
            a.lambda = end;
            expect(f, PW85_SUCCESS, a);
        }
}

void test_building_blocks()
{
    Arguments const a;
    double const bad[6] = {1.0, 2.0, 0.0, 1.0, 0.0, 1.0};
    double out[3], l[6], params[15] = {1.0, -2.0, 3.0, 4.0, 0.5, 0.0, 3.0, 0.0, 2.0, 1.0, 0.0, 0.25, 2.0, 0.0, 1.0};
    auto const expect_nan = [&](double lambda, double const *r12, double const *q1, double const *q2) {
        pw85__residual(lambda, r12, q1, q2, out);
        for (double const x : out) g_assert_true(std::isnan(x));
    };
    expect_nan(0.5, nullptr, a.q1, a.q2);
    expect_nan(0.5, a.r12, nullptr, a.q2);
    expect_nan(0.5, a.r12, a.q1, nullptr);
    expect_nan(0.5, a.r12, bad, a.q2);
    expect_nan(0.5, a.r12, a.q1, bad);
    expect_nan(-0.5, a.r12, a.q1, a.q2);
    expect_nan(1.5, a.r12, a.q1, a.q2);
    expect_nan(nan, a.r12, a.q1, a.q2);
    pw85__cholesky_decomp(bad, l);
    for (double const x : l) g_assert_true(std::isnan(x));
    pw85__cholesky_solve(nullptr, a.r12, out);
    for (double const x : out) g_assert_true(std::isnan(x));
    g_assert_true(std::isnan(pw85_f_neg(0.5, nullptr)));
    g_assert_false(std::isnan(pw85_f_neg(0.5, params)));
    g_assert_true(std::isnan(pw85_f_neg(1.5, params)));
    params[4] = 100.0;
    g_assert_true(std::isnan(pw85_f_neg(0.5, params)));
}

// One list makes the enumerations and the texts.
void test_texts()
{
    g_assert_cmpint(PW85_SUCCESS, ==, 0);
    g_assert_cmpint(PW85_EINVAL, ==, 1);
    g_assert_cmpint(PW85_ENOTPD, ==, 2);
    g_assert_cmpint(PW85_ECONVERGENCE, ==, 3);
    g_assert_cmpint(PW85_ENOMEM, ==, 4);
    g_assert_cmpint(PW85_EDEVICE, ==, 5);
#define CHECK_TEXT(c_name, cpp_name, value, text)                                                                      \
    g_assert_cmpint(c_name, ==, value);                                                                                \
    g_assert_cmpint(static_cast<int>(pw85::Status::cpp_name), ==, value);                                              \
    g_assert_cmpstr(pw85_strerror(c_name), ==, text);
    PW85_STATUS_LIST(CHECK_TEXT)
#undef CHECK_TEXT
    char const *unknown = pw85_strerror(-1);
    g_assert_nonnull(unknown);
    for (int const status : {6, 1000, std::numeric_limits<int>::min(), std::numeric_limits<int>::max()})
        g_assert_cmpstr(pw85_strerror(status), ==, unknown);
    for (int i = 0; i < 6; ++i)
        for (int j = i + 1; j < 6; ++j) g_assert_cmpstr(pw85_strerror(i), !=, pw85_strerror(j));
}

void test_version()
{
    gchar *expected = g_strdup_printf("%d.%d.%d", PW85_VERSION_MAJOR, PW85_VERSION_MINOR, PW85_VERSION_PATCH);
    g_assert_cmpstr(PW85_VERSION, ==, expected);
    g_assert_cmpstr(pw85_version(), ==, PW85_VERSION);
    g_free(expected);
}

} // namespace

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, nullptr);
    g_test_add_func("/status/success", test_success);
    g_test_add_func("/status/einval/null_inputs", test_null_inputs);
    g_test_add_func("/status/einval/null_outputs", test_null_outputs);
    g_test_add_func("/status/einval/null_builders", test_null_inputs_of_builders);
    g_test_add_func("/status/einval/not_finite", test_not_finite);
    g_test_add_func("/status/einval/zero_separation", test_zero_separation);
    g_test_add_func("/status/einval/lambda", test_lambda_out_of_range);
    g_test_add_func("/status/enotpd", test_not_positive_definite);
    g_test_add_func("/status/enotpd/concentric", test_concentric_and_bad);
    g_test_add_func("/status/building_blocks", test_building_blocks);
    g_test_add_func("/status/texts", test_texts);
    g_test_add_func("/status/version", test_version);
    return g_test_run();
}
