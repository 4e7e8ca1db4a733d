// SPDX-License-Identifier: BSD-3-Clause
// The C API of the superseded variants (pw85_legacy.h). It calls history/legacy.hpp.
#define PW85_ALL_HERE
#include <pw85_legacy.h>

#include <pw85/history/legacy.hpp>

#include "../base/c_arrays.hpp"
#include "../base/floating_point_environment.hpp"

using namespace pw85;
using namespace pw85::detail;
using namespace pw85::detail::c_api;

namespace {

void store_derivatives(Derivatives<double> const &f, double *out) noexcept
{
    store(Vector<double, 3>{f.f, f.first, f.second}, out);
}

/// f, f' and f'' by factorisation.
Derivatives<double> factorized(double lambda, double const *r12, double const *q1,
                               double const *q2) noexcept
{
    if (any_null(r12, q1, q2)) return invalid_derivatives<double>();
    return in_default_environment([&] {
        return checked_derivatives(lambda, load_vector<3>(r12), load_matrix<3>(q1),
                                   load_matrix<3>(q2));
    });
}

/// Computes f and its derivatives in rational form.
Derivatives<double> rational(double lambda, double const *r12, double const *q1,
                             double const *q2) noexcept
{
    if (any_null(r12, q1, q2)) return invalid_derivatives<double>();
    return in_default_environment([&] {
        return pw85::detail::legacy::checked_rational(lambda, load_vector<3>(r12),
                                                      load_matrix<3>(q1), load_matrix<3>(q2));
    });
}

int store_contact(Contact<double> const &contact, double out[2]) noexcept
{
    out[0] = contact.mu2;
    out[1] = contact.lambda;
    return static_cast<int>(contact.status);
}

} // namespace

double pw85_legacy__det_sym(double const a[6])
{
    if (any_null(a)) return quiet_nan<double>();
    return in_default_environment(
        [&] { return pw85::detail::legacy::determinant(load_matrix<3>(a)); });
}

double pw85_legacy__xT_adjA_x(double const x[3], double const a[6])
{
    if (any_null(x, a)) return quiet_nan<double>();
    return in_default_environment(
        [&] { return pw85::detail::legacy::adjugate_form(load_vector<3>(x), load_matrix<3>(a)); });
}

void pw85_legacy__detQ_as_poly(double const q1[6], double const q2[6], double const q3[6],
                               double const q4[6], double b[4])
{
    if (any_null(q1, q2, q3, q4, b)) return store_nan(b, 4);
    double coefficients[4] = {};
    in_default_environment([&] {
        pw85::detail::legacy::interpolate_cubic(pw85_legacy__det_sym(q1), pw85_legacy__det_sym(q2),
                                                pw85_legacy__det_sym(q3), pw85_legacy__det_sym(q4),
                                                coefficients);
    });
    for (int i = 0; i < 4; ++i) b[i] = coefficients[i];
}

void pw85_legacy__rT_adjQ_r_as_poly(double const r[3], double const q1[6], double const q2[6],
                                    double const q3[6], double a[3])
{
    if (any_null(r, q1, q2, q3, a)) return store_nan(a, 3);
    double coefficients[3] = {};
    in_default_environment([&] {
        pw85::detail::legacy::interpolate_quadratic(pw85_legacy__xT_adjA_x(r, q1),
                                                    pw85_legacy__xT_adjA_x(r, q2),
                                                    pw85_legacy__xT_adjA_x(r, q3), coefficients);
    });
    for (int i = 0; i < 3; ++i) a[i] = coefficients[i];
}

double pw85_legacy_f1(double lambda, double const r12[3], double const q1[6], double const q2[6],
                      double *out)
{
    auto const f = factorized(lambda, r12, q1, q2);
    store_derivatives(f, out);
    return f.f;
}

double pw85_legacy_f2(double lambda, double const r12[3], double const q1[6], double const q2[6],
                      double *out)
{
    double const f = rational(lambda, r12, q1, q2).f;
    if (out) *out = f;
    return f;
}

void pw85_legacy_f2_derivatives(double lambda, double const r12[3], double const q1[6],
                                double const q2[6], double out[3])
{
    store_derivatives(rational(lambda, r12, q1, q2), out);
}

int pw85_legacy_contact_function1(double const r12[3], double const q1[6], double const q2[6],
                                  double out[2])
{
    if (any_null(r12, q1, q2, out)) return null_pointer(out, 2);
    return in_default_environment([&] {
        return store_contact(pw85::legacy::contact_newton(load_vector<3>(r12), load_matrix<3>(q1),
                                                          load_matrix<3>(q2)),
                             out);
    });
}

int pw85_legacy_contact_function2(double const r12[3], double const q1[6], double const q2[6],
                                  double out[2])
{
    if (any_null(r12, q1, q2, out)) return null_pointer(out, 2);
    return in_default_environment([&] {
        return store_contact(pw85::legacy::contact_bisection(
                                 load_vector<3>(r12), load_matrix<3>(q1), load_matrix<3>(q2)),
                             out);
    });
}
