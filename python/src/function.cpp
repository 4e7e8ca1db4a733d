#include "function.hpp"

#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include <pw85.h>
#include <pw85_legacy.h>
#include <pw85_zheng.h>

namespace pypw85 {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

bool all_finite(double const *x, int count) noexcept
{
    for (int i = 0; i < count; ++i)
        if (!std::isfinite(x[i])) return false;
    return true;
}

template <auto function> int pair_result(double const *const *in, double *const *out)
{
    double result[2];
    int const status = function(in[0], in[1], in[2], result);
    *out[0] = result[0];
    *out[1] = result[1];
    return status;
}

template <auto function> int distance_result(double const *const *in, double *const *out)
{
    return function(in[0], in[1], in[2], out[0]);
}

/// Status for a function of λ and a pair that reports invalid input by NaN alone.
int status_of_value(double value, double const *r12, double const *q1, double const *q2) noexcept
{
    if (!std::isnan(value)) return PW85_SUCCESS;
    double ignored[2];
    int const status = pw85_contact(r12, q1, q2, ignored);
    return status != PW85_SUCCESS ? status : PW85_EINVAL;
}

int f(double const *const *in, double *const *out)
{
    double params[PW85_DIM + 2 * PW85_SYM];
    for (int i = 0; i < PW85_DIM; ++i) params[i] = in[1][i];
    for (int i = 0; i < PW85_SYM; ++i) {
        params[PW85_DIM + i] = in[2][i];
        params[PW85_DIM + PW85_SYM + i] = in[3][i];
    }
    *out[0] = -pw85_f_neg(*in[0], params);
    return status_of_value(*out[0], in[1], in[2], in[3]);
}

int legacy_f1(double const *const *in, double *const *out)
{
    double result[3];
    pw85_legacy_f1(*in[0], in[1], in[2], in[3], result);
    for (int i = 0; i < 3; ++i) *out[i] = result[i];
    return status_of_value(result[0], in[1], in[2], in[3]);
}

int legacy_f2(double const *const *in, double *const *out)
{
    pw85_legacy_f2(*in[0], in[1], in[2], in[3], out[0]);
    return status_of_value(*out[0], in[1], in[2], in[3]);
}

int legacy_f2_derivatives(double const *const *in, double *const *out)
{
    pw85_legacy_f2_derivatives(*in[0], in[1], in[2], in[3], out[0]);
    return status_of_value(*out[0], in[1], in[2], in[3]);
}

int spheroid(double const *const *in, double *const *out)
{
    pw85_spheroid(*in[0], *in[1], in[2], out[0]);
    return std::isnan(out[0][0]) ? PW85_EINVAL : PW85_SUCCESS;
}

template <auto function> int truth_value(double const *const *in, double *const *out)
{
    int result;
    int const status = function(in[0], in[1], in[2], &result);
    *out[0] = status == PW85_SUCCESS ? result : nan;
    return status;
}

int contact_geometry(double const *const *in, double *const *out)
{
    return pw85_contact_geometry(in[0], in[1], in[2], *in[3], out[0], out[1]);
}

int contact_gradient(double const *const *in, double *const *out)
{
    return pw85_contact_gradient(in[0], in[1], in[2], *in[3], out[0], out[1], out[2]);
}

int contact_torque(double const *const *in, double *const *out)
{
    return pw85_contact_torque(in[0], in[1], in[2], *in[3], out[0], out[1]);
}

int contact_hessian(double const *const *in, double *const *out)
{
    return pw85_contact_hessian(in[0], in[1], in[2], *in[3], out[0]);
}

int contact_geometry_2d(double const *const *in, double *const *out)
{
    return pw85_contact_geometry_2d(in[0], in[1], in[2], *in[3], out[0], out[1]);
}

int contact_gradient_2d(double const *const *in, double *const *out)
{
    return pw85_contact_gradient_2d(in[0], in[1], in[2], *in[3], out[0], out[1], out[2]);
}

int contact_torque_2d(double const *const *in, double *const *out)
{
    return pw85_contact_torque_2d(in[0], in[1], in[2], *in[3], out[0], out[1]);
}

int contact_hessian_2d(double const *const *in, double *const *out)
{
    return pw85_contact_hessian_2d(in[0], in[1], in[2], *in[3], out[0]);
}

int contact_derivatives(double const *const *in, double *const *out)
{
    return pw85_contact_derivatives_batch(1, in[0], in[1], in[2], out[0], out[1], out[2], out[3], out[4], out[5],
                                          out[6]);
}

int cell_reduce(double const *const *in, double *const *out) { return pw85_cell_reduce(in[0], out[0]); }

int bounding_boxes(double const *const *in, double *const *out) { return pw85_bounding_boxes(1, in[0], out[0]); }

template <auto function> int distance_and_points(double const *const *in, double *const *out)
{
    return function(in[0], in[1], in[2], out[0], out[1], out[2]);
}

int distance_derivatives(double const *const *in, double *const *out)
{
    return pw85_distance_derivatives(in[0], in[1], in[2], out[0], out[1], out[2], out[3]);
}

int distance_plane(double const *const *in, double *const *out)
{
    return pw85_distance_plane(in[0], *in[1], in[2], out[0], out[1]);
}

int distance_plane_derivatives(double const *const *in, double *const *out)
{
    return pw85_distance_plane_derivatives(in[0], in[1], out[0], out[1]);
}

int contact_plane(double const *const *in, double *const *out)
{
    return pw85_contact_plane(in[0], *in[1], in[2], out[0], out[1]);
}

int contact_plane_derivatives(double const *const *in, double *const *out)
{
    return pw85_contact_plane_derivatives(in[0], *in[1], in[2], out[0], out[1]);
}

int distance_cylinder(double const *const *in, double *const *out)
{
    return pw85_distance_cylinder(in[0], *in[1], in[2], in[3], out[0], out[1], out[2]);
}

int distance_point(double const *const *in, double *const *out)
{
    return pw85_distance_point(in[0], in[1], out[0], out[1], out[2]);
}

int penetration(double const *const *in, double *const *out)
{
    return pw85_penetration(in[0], in[1], in[2], out[0], out[1]);
}

pw85_motion load_motion(double const *x) noexcept { return {{x[0], x[1], x[2]}, {x[3], x[4], x[5]}, x[6]}; }

int first_contact(double const *const *in, double *const *out)
{
    pw85_motion const motion1 = load_motion(in[3]), motion2 = load_motion(in[4]);
    return pw85_first_contact(in[0], in[1], in[2], &motion1, &motion2, *in[5], out[0]);
}

int cholesky_decomp(double const *const *in, double *const *out)
{
    pw85__cholesky_decomp(in[0], out[0]);
    if (!std::isnan(out[0][0])) return PW85_SUCCESS;
    return all_finite(in[0], PW85_SYM) ? PW85_ENOTPD : PW85_EINVAL;
}

int cholesky_solve(double const *const *in, double *const *out)
{
    pw85__cholesky_solve(in[0], in[1], out[0]);
    return PW85_SUCCESS;
}

int det_sym(double const *const *in, double *const *out)
{
    *out[0] = pw85_legacy__det_sym(in[0]);
    return PW85_SUCCESS;
}

int xT_adjA_x(double const *const *in, double *const *out)
{
    *out[0] = pw85_legacy__xT_adjA_x(in[0], in[1]);
    return PW85_SUCCESS;
}

int detQ_as_poly(double const *const *in, double *const *out)
{
    pw85_legacy__detQ_as_poly(in[0], in[1], in[2], in[3], out[0]);
    return PW85_SUCCESS;
}

int rT_adjQ_r_as_poly(double const *const *in, double *const *out)
{
    pw85_legacy__rT_adjQ_r_as_poly(in[0], in[1], in[2], in[3], out[0]);
    return PW85_SUCCESS;
}

int ellipsoid(double const *const *in, double *const *out) { return pw85_ellipsoid(in[0], in[1], out[0]); }

int ellipsoid_quaternion(double const *const *in, double *const *out)
{
    return pw85_ellipsoid_quaternion(in[0], in[1], out[0]);
}

int ellipse(double const *const *in, double *const *out) { return pw85_ellipse(*in[0], *in[1], *in[2], out[0]); }

/// The pointer of a parameter of a batch function, of which `number` come before it, `inputs` of all being inputs.
template <class Pointer>
Pointer array(std::size_t inputs, std::size_t number, double const *const *in, double *const *out) noexcept
{
    if constexpr (std::is_same_v<Pointer, double const *>)
        return in[number];
    else
        return out[number - inputs];
}

template <class... Pointers>
int call_batch(int (*function)(std::size_t, Pointers...), std::size_t n, double const *const *in, double *const *out)
{
    constexpr std::size_t inputs = (std::size_t{std::is_same_v<Pointers, double const *>} + ...);
    return [&]<std::size_t... k>(std::index_sequence<k...>)
    {
        return function(n, array<Pointers>(inputs, k, in, out)...);
    }
    (std::index_sequence_for<Pointers...>{});
}

/// A function of many rows of the C API, whose arrays are in the order of the operands.
template <auto function> int batch(std::size_t n, double const *const *in, double *const *out)
{
    return call_batch(function, n, in, out);
}

/// One call for each run of rows that have the same t_max.
int first_contact_batch(std::size_t n, double const *const *in, double *const *out)
{
    static_assert(sizeof(pw85_motion) == 7 * sizeof(double));
    auto const *const motion1 = reinterpret_cast<pw85_motion const *>(in[3]);
    auto const *const motion2 = reinterpret_cast<pw85_motion const *>(in[4]);
    double const *const t_max = in[5];
    int first_bad = PW85_SUCCESS;
    for (std::size_t begin = 0, end; begin < n; begin = end) {
        end = begin + 1;
        while (end < n && t_max[end] == t_max[begin]) ++end;
        int const status =
            pw85_first_contact_batch(end - begin, in[0] + 3 * begin, in[1] + 6 * begin, in[2] + 6 * begin,
                                     motion1 + begin, motion2 + begin, t_max[begin], out[0] + begin);
        if (first_bad == PW85_SUCCESS) first_bad = status;
    }
    return first_bad;
}

} // namespace

void parse_signature(Function &function) noexcept
{
    int operand = -1;
    bool output = false;
    for (char const *c = function.signature; *c != '\0'; ++c) {
        if (*c == '>') output = true;
        if (*c == '(') {
            ++operand;
            ++(output ? function.nout : function.nin);
        }
        if (*c >= '0' && *c <= '9') {
            Core &core = function.cores[operand];
            core.dims[core.ndim++] = *c - '0';
        }
    }
}

std::vector<Function> &functions()
{
    static std::vector<Function> table{
        {"spheroid", "(),(),(3)->(6)", spheroid},
        {"ellipsoid", "(3),(3,3)->(6)", ellipsoid},
        {"ellipsoid_quaternion", "(3),(4)->(6)", ellipsoid_quaternion, false, batch<pw85_ellipsoid_quaternion_batch>},
        {"ellipse", "(),(),()->(3)", ellipse},
        {"f", "(),(3),(6),(6)->()", f},
        {"contact", "(3),(6),(6)->(),()", pair_result<pw85_contact>, false, batch<pw85_contact_batch>},
        {"contact_function", "(3),(6),(6)->(),()", pair_result<pw85_contact_function>, false,
         batch<pw85_contact_function_batch>},
        {"contact_geometry", "(3),(6),(6),()->(3),(3)", contact_geometry, false, batch<pw85_contact_geometry_batch>},
        {"contact_gradient", "(3),(6),(6),()->(3),(6),(6)", contact_gradient, false,
         batch<pw85_contact_gradient_batch>},
        {"contact_torque", "(3),(6),(6),()->(3),(3)", contact_torque, false, batch<pw85_contact_torque_batch>},
        {"contact_hessian", "(3),(6),(6),()->(9,9)", contact_hessian, false, batch<pw85_contact_hessian_batch>},
        {"contact_derivatives", "(3),(6),(6)->(),(),(3),(3),(3),(3),(3)", contact_derivatives, false,
         batch<pw85_contact_derivatives_batch>},
        {"overlap", "(3),(6),(6)->()", truth_value<pw85_overlap>, true, nullptr, pw85_overlap_batch},
        {"contains", "(3),(6),(6)->()", truth_value<pw85_contains>, true, nullptr, pw85_contains_batch, false},
        {"cell_reduce", "(3,3)->(3,3)", cell_reduce},
        {"bounding_boxes", "(6)->(3)", bounding_boxes, false, batch<pw85_bounding_boxes>},
        {"closest_approach", "(3),(6),(6)->()", distance_result<pw85_closest_approach>, false,
         batch<pw85_closest_approach_batch>},
        {"distance", "(3),(6),(6)->(),(3),(3)", distance_and_points<pw85_distance>, false, batch<pw85_distance_batch>},
        {"distance_derivatives", "(3),(6),(6)->(3),(3),(3),(9,9)", distance_derivatives, false,
         batch<pw85_distance_derivatives_batch>},
        {"distance_2d", "(2),(3),(3)->(),(2),(2)", distance_and_points<pw85_distance_2d>, false,
         batch<pw85_distance_batch_2d>},
        {"penetration", "(3),(6),(6)->(),(3)", penetration, false, batch<pw85_penetration_batch>},
        {"first_contact", "(3),(6),(6),(7),(7),()->()", first_contact, false, first_contact_batch},
        {"distance_plane", "(3),(),(6)->(),(3)", distance_plane, false, batch<pw85_distance_plane_batch>},
        {"distance_plane_derivatives", "(3),(6)->(3),(3)", distance_plane_derivatives, false,
         batch<pw85_distance_plane_derivatives_batch>},
        {"contact_plane", "(3),(),(6)->(),(3)", contact_plane, false, batch<pw85_contact_plane_batch>},
        {"contact_plane_derivatives", "(3),(),(6)->(3),(3)", contact_plane_derivatives, false,
         batch<pw85_contact_plane_derivatives_batch>},
        {"distance_box", "(3),(3),(6)->(),(3),(3)", distance_and_points<pw85_distance_box>, false,
         batch<pw85_distance_box_batch>},
        {"distance_cylinder", "(3),(),(3),(6)->(),(3),(3)", distance_cylinder, false,
         batch<pw85_distance_cylinder_batch>},
        {"distance_point", "(3),(6)->(),(3),(3)", distance_point, false, batch<pw85_distance_point_batch>},
        {"intersect_line", "(3),(3),(6)->(),()", pair_result<pw85_intersect_line>, false,
         batch<pw85_intersect_line_batch>},
        {"contact_2d", "(2),(3),(3)->(),()", pair_result<pw85_contact_2d>, false, batch<pw85_contact_batch_2d>},
        {"contact_geometry_2d", "(2),(3),(3),()->(2),(2)", contact_geometry_2d, false,
         batch<pw85_contact_geometry_batch_2d>},
        {"contact_gradient_2d", "(2),(3),(3),()->(2),(3),(3)", contact_gradient_2d, false,
         batch<pw85_contact_gradient_batch_2d>},
        {"contact_torque_2d", "(2),(3),(3),()->(),()", contact_torque_2d, false, batch<pw85_contact_torque_batch_2d>},
        {"contact_hessian_2d", "(2),(3),(3),()->(4,4)", contact_hessian_2d, false,
         batch<pw85_contact_hessian_batch_2d>},
        {"overlap_2d", "(2),(3),(3)->()", truth_value<pw85_overlap_2d>, true, nullptr, pw85_overlap_batch_2d},
        {"closest_approach_2d", "(2),(3),(3)->()", distance_result<pw85_closest_approach_2d>, false,
         batch<pw85_closest_approach_batch_2d>},
        {"zheng_ellipses", "(2),(3),(3)->()", distance_result<pw85_zheng_ellipses>},
        {"zheng_ellipsoids", "(3),(6),(6)->()", distance_result<pw85_zheng_ellipsoids>},
        {"cholesky_decomp", "(6)->(6)", cholesky_decomp},
        {"cholesky_solve", "(6),(3)->(3)", cholesky_solve},
        {"legacy_det_sym", "(6)->()", det_sym},
        {"legacy_xT_adjA_x", "(3),(6)->()", xT_adjA_x},
        {"legacy_detQ_as_poly", "(6),(6),(6),(6)->(4)", detQ_as_poly},
        {"legacy_rT_adjQ_r_as_poly", "(3),(6),(6),(6)->(3)", rT_adjQ_r_as_poly},
        {"legacy_f1", "(),(3),(6),(6)->(),(),()", legacy_f1},
        {"legacy_f2", "(),(3),(6),(6)->()", legacy_f2},
        {"legacy_f2_derivatives", "(),(3),(6),(6)->(3)", legacy_f2_derivatives},
        {"legacy_contact_function1", "(3),(6),(6)->(),()", pair_result<pw85_legacy_contact_function1>},
        {"legacy_contact_function2", "(3),(6),(6)->(),()", pair_result<pw85_legacy_contact_function2>},
    };
    return table;
}

} // namespace pypw85
