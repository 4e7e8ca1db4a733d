// The C API of one pair of ellipsoids. The functions check for null pointers; the core checks everything else.
#include <pw85.h>

#include <pw85/pw85.hpp>

#include "brent.hpp"
#include "c_arrays.hpp"
#include "floating_point_environment.hpp"
#include "kernels/kernels.hpp"

using namespace pw85;
using namespace pw85::detail;
using namespace pw85::detail::c_api;

namespace {

template <int D> int store_form(Form<double, D> const &form, double *q) noexcept
{
    store(form.q, q);
    return static_cast<int>(form.status);
}

int store_contact(Contact<double> const &contact, double out[2]) noexcept
{
    out[0] = contact.mu2;
    out[1] = contact.lambda;
    return static_cast<int>(contact.status);
}

} // namespace

char const *pw85_version(void) { return PW85_VERSION; }

char const *pw85_strerror(int status) { return pw85::strerror(static_cast<Status>(status)); }

int pw85_set_reproducible(int on)
{
    if (on != 0 && on != 1) return PW85_EINVAL;
    kernels::set_reproducible(on == 1);
    return PW85_SUCCESS;
}

int pw85_is_reproducible(int *on)
{
    if (any_null(on)) return PW85_EINVAL;
    *on = kernels::is_reproducible() ? 1 : 0;
    return PW85_SUCCESS;
}

void pw85_spheroid(double a, double c, double const n[3], double q[6])
{
    if (any_null(n, q)) return store_nan(q, PW85_SYM);
    in_default_environment([&] { store(spheroid(a, c, load_vector<3>(n)).q, q); });
}

int pw85_ellipsoid(double const semi_axes[3], double const rotation[9], double q[6])
{
    if (any_null(semi_axes, rotation, q)) return null_pointer(q, PW85_SYM);
    double r[9];
    for (int i = 0; i < 9; ++i) r[i] = rotation[i];
    return in_default_environment([&] { return store_form(ellipsoid(load_vector<3>(semi_axes), r), q); });
}

int pw85_ellipsoid_quaternion(double const semi_axes[3], double const quaternion[4], double q[6])
{
    if (any_null(semi_axes, quaternion, q)) return null_pointer(q, PW85_SYM);
    return in_default_environment(
        [&] { return store_form(ellipsoid_quaternion(load_vector<3>(semi_axes), load_vector<4>(quaternion)), q); });
}

int pw85_ellipsoid_factor(double const semi_axes[3], double const quaternion[4], double s[9])
{
    if (any_null(semi_axes, quaternion, s)) return null_pointer(s, 9);
    return in_default_environment([&] {
        auto const factor = ellipsoid_factor(load_vector<3>(semi_axes), load_vector<4>(quaternion));
        store(factor.s, s);
        return static_cast<int>(factor.status);
    });
}

int pw85_ellipse(double a, double b, double angle, double q[3])
{
    if (any_null(q)) return PW85_EINVAL;
    return in_default_environment([&] { return store_form(ellipse(a, b, angle), q); });
}

int pw85_contact(double const r12[3], double const q1[6], double const q2[6], double out[2])
{
    if (any_null(r12, q1, q2, out)) return null_pointer(out, 2);
    return in_default_environment(kernels::chosen().one_pair->contact, r12, q1, q2, out);
}

int pw85_contact_rounded(double const r12[3], double const q1[6], double const q2[6], double out[2])
{
    if (any_null(r12, q1, q2, out)) return null_pointer(out, 2);
    return in_default_environment(kernels::chosen().one_pair->contact_rounded, r12, q1, q2, out);
}

int pw85_contact_factored(double const r12[3], double const s1[9], double const s2[9], double out[2])
{
    if (any_null(r12, s1, s2, out)) return null_pointer(out, 2);
    return in_default_environment(kernels::chosen().one_pair->contact_factored, r12, s1, s2, out);
}

int pw85_condition(double const r12[3], double const q1[6], double const q2[6], double lambda, double *cond)
{
    if (any_null(r12, q1, q2, cond)) return null_pointer(cond, 1);
    return in_default_environment([&] {
        auto const c = condition(load_vector<3>(r12), load_matrix<3>(q1), load_matrix<3>(q2), lambda);
        *cond = c.condition;
        return static_cast<int>(c.status);
    });
}

int pw85_contact_function(double const r12[3], double const q1[6], double const q2[6], double out[2])
{
    if (any_null(r12, q1, q2, out)) return null_pointer(out, 2);
    constexpr brent::Options options{PW85_LAMBDA_ATOL, PW85_MAX_ITER, PW85_NR_ITER};
    // Brent's method is that of another library, whose arithmetic depends on how that was compiled.
    if (kernels::is_reproducible()) return pw85_contact(r12, q1, q2, out);
    return in_default_environment([&] {
        return store_contact(
            brent::contact_function(load_vector<3>(r12), load_matrix<3>(q1), load_matrix<3>(q2), options), out);
    });
}

int pw85_contact_geometry(double const r12[3], double const q1[6], double const q2[6], double lambda, double point[3],
                          double normal[3])
{
    if (any_null(r12, q1, q2)) return null_pointer(point, PW85_DIM, normal, PW85_DIM);
    return in_default_environment(kernels::chosen().one_pair->contact_geometry, r12, q1, q2, lambda, point, normal);
}

int pw85_contact_gradient(double const r12[3], double const q1[6], double const q2[6], double lambda, double d_r12[3],
                          double d_q1[6], double d_q2[6])
{
    if (any_null(r12, q1, q2)) return null_pointer(d_r12, PW85_DIM, d_q1, PW85_SYM, d_q2, PW85_SYM);
    return in_default_environment(kernels::chosen().one_pair->contact_gradient, r12, q1, q2, lambda, d_r12, d_q1, d_q2);
}

int pw85_contact_geometry_factored(double const r12[3], double const s1[9], double const s2[9], double lambda,
                                   double point[3], double normal[3])
{
    if (any_null(r12, s1, s2)) return null_pointer(point, PW85_DIM, normal, PW85_DIM);
    auto const function = kernels::chosen().one_pair->contact_geometry_factored;
    return in_default_environment(function, r12, s1, s2, lambda, point, normal);
}

int pw85_contact_gradient_factored(double const r12[3], double const s1[9], double const s2[9], double lambda,
                                   double d_r12[3], double d_s1[9], double d_s2[9])
{
    if (any_null(r12, s1, s2)) return null_pointer(d_r12, PW85_DIM, d_s1, 9, d_s2, 9);
    auto const function = kernels::chosen().one_pair->contact_gradient_factored;
    return in_default_environment(function, r12, s1, s2, lambda, d_r12, d_s1, d_s2);
}

int pw85_contact_torque(double const r12[3], double const q1[6], double const q2[6], double lambda, double d_rot1[3],
                        double d_rot2[3])
{
    if (any_null(r12, q1, q2)) return null_pointer(d_rot1, PW85_DIM, d_rot2, PW85_DIM);
    return in_default_environment(kernels::chosen().one_pair->contact_torque, r12, q1, q2, lambda, d_rot1, d_rot2);
}

int pw85_contact_hessian(double const r12[3], double const q1[6], double const q2[6], double lambda, double hessian[81])
{
    if (any_null(r12, q1, q2, hessian)) return null_pointer(hessian, 81);
    return in_default_environment(kernels::chosen().one_pair->contact_hessian, r12, q1, q2, lambda, hessian);
}

int pw85_overlap(double const r12[3], double const q1[6], double const q2[6], int *overlap)
{
    if (any_null(overlap)) return PW85_EINVAL;
    *overlap = -1;
    if (any_null(r12, q1, q2)) return PW85_EINVAL;
    return in_default_environment(kernels::chosen().one_pair->overlap, r12, q1, q2, overlap);
}

int pw85_overlap_factored(double const r12[3], double const s1[9], double const s2[9], int *overlap)
{
    if (any_null(overlap)) return PW85_EINVAL;
    *overlap = -1;
    if (any_null(r12, s1, s2)) return PW85_EINVAL;
    return in_default_environment(kernels::chosen().one_pair->overlap_factored, r12, s1, s2, overlap);
}

int pw85_compare(double const r12[3], double const q1[6], double const q2[6], double mu2, int *sign)
{
    if (any_null(sign)) return PW85_EINVAL;
    *sign = 2;
    if (any_null(r12, q1, q2)) return PW85_EINVAL;
    DefaultEnvironment const environment;
    auto const answer = pw85::compare(load_vector<3>(r12), load_matrix<3>(q1), load_matrix<3>(q2), mu2);
    *sign = answer.sign;
    return static_cast<int>(answer.status);
}

int pw85_overlap_witness(double const r12[3], double const q1[6], double const q2[6], int *overlap, double *lambda,
                         double point[3])
{
    store_nan(lambda, 1);
    store_nan(point, PW85_DIM);
    if (any_null(overlap)) return PW85_EINVAL;
    *overlap = -1;
    if (any_null(r12, q1, q2)) return PW85_EINVAL;
    DefaultEnvironment const environment;
    auto const witness = pw85::overlap_witness(load_vector<3>(r12), load_matrix<3>(q1), load_matrix<3>(q2));
    if (witness.status == Status::success) *overlap = witness.overlap;
    if (lambda != nullptr) *lambda = witness.lambda;
    store(witness.point, point);
    return static_cast<int>(witness.status);
}

int pw85_contains(double const r12[3], double const q1[6], double const q2[6], int *contains)
{
    if (any_null(contains)) return PW85_EINVAL;
    *contains = -1;
    if (any_null(r12, q1, q2)) return PW85_EINVAL;
    return in_default_environment(kernels::chosen().one_pair->contains, r12, q1, q2, contains);
}

int pw85_containment(double const r12[3], double const q1[6], double const q2[6], double *mu2, double point[3])
{
    if (any_null(r12, q1, q2)) return null_pointer(mu2, 1, point, PW85_DIM);
    return in_default_environment([&] {
        auto const c = pw85::containment(load_vector<3>(r12), load_matrix<3>(q1), load_matrix<3>(q2));
        if (mu2 != nullptr) *mu2 = c.mu2;
        store(c.point, point);
        return static_cast<int>(c.status);
    });
}

int pw85_closest_approach(double const direction[3], double const q1[6], double const q2[6], double *distance)
{
    if (any_null(direction, q1, q2, distance)) return null_pointer(distance, 1);
    return in_default_environment(kernels::chosen().one_pair->closest_approach, direction, q1, q2, distance);
}

void pw85__cholesky_decomp(double const a[6], double l[6])
{
    if (any_null(a, l)) return store_nan(l, PW85_SYM);
    in_default_environment([&] { store(cholesky(load_matrix<3>(a)), l); });
}

void pw85__cholesky_solve(double const l[6], double const b[3], double x[3])
{
    if (any_null(l, b, x)) return store_nan(x, PW85_DIM);
    in_default_environment([&] { store(cholesky_solve(load_matrix<3>(l), load_vector<3>(b)), x); });
}

void pw85__residual(double lambda, double const r12[3], double const q1[6], double const q2[6], double out[3])
{
    if (any_null(r12, q1, q2, out)) return store_nan(out, 3);
    in_default_environment([&] {
        auto const f = checked_derivatives(lambda, load_vector<3>(r12), load_matrix<3>(q1), load_matrix<3>(q2));
        out[0] = f.f;
        out[1] = -f.first;
        out[2] = -f.second;
    });
}

double pw85_f_neg(double lambda, double const *params)
{
    if (any_null(params)) return quiet_nan<double>();
    return in_default_environment([&] {
        return -checked_f(lambda, load_vector<3>(params), load_matrix<3>(params + 3), load_matrix<3>(params + 9));
    });
}
