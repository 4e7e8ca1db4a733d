// libFuzzer target: raw bytes as doubles into every public function. A success must not come with a NaN in the outputs, an
// error must.
#include <pw85.h>
#include <pw85_legacy.h>
#include <pw85_zheng.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <vector>

#include "../src/gpu/work.hpp"
#include "../tests/systems.hpp"

using pw85_tests::list_of;
using pw85_tests::system_of;

namespace {

// The arguments of one pair.
struct Input {
    double r12[3], q1[6], q2[6], lambda, axes[3], rotation[9];
    std::uint8_t form, scale;
};

[[noreturn]] void fail(char const *function, Input const &in)
{
    std::fprintf(stderr, "%s\n", function);
    auto const *x = reinterpret_cast<double const *>(&in);
    for (std::size_t i = 0; i < offsetof(Input, form) / sizeof *x; ++i) std::fprintf(stderr, "%a\n", x[i]);
    __builtin_trap();
}

bool has_nan(double const *x, int n)
{
    return std::any_of(x, x + n, [](double y) { return std::isnan(y); });
}
bool all_nan(double const *x, int n)
{
    return std::all_of(x, x + n, [](double y) { return std::isnan(y); });
}

void check(char const *function, Input const &in, int status, double const *out, int n)
{
    if (status == PW85_SUCCESS ? has_nan(out, n) : !all_nan(out, n)) fail(function, in);
    // Memory is nothing that one row can lack, nor a device what the host does without.
    if (status < PW85_SUCCESS || status > PW85_ECONVERGENCE) fail(function, in);
}

void check_builders(Input const &in)
{
    double q[6];
    check("ellipsoid", in, pw85_ellipsoid(in.axes, in.rotation, q), q, 6);
    check("ellipsoid_quaternion", in, pw85_ellipsoid_quaternion(in.axes, in.rotation, q), q, 6);
    check("ellipse", in, pw85_ellipse(in.axes[0], in.axes[1], in.axes[2], q), q, 3);
    pw85_spheroid(in.axes[0], in.axes[1], in.rotation, q);
    if (has_nan(q, 6) != all_nan(q, 6)) fail("spheroid", in);
}

void check_pair(Input const &in)
{
    double out[3], point[6], gradient[15], torque[6], hessian[81];
    auto const *r = in.r12, *a = in.q1, *b = in.q2;
    int const status = pw85_contact(r, a, b, out);
    check("contact", in, status, out, 2);
    double const lambda = status == PW85_SUCCESS ? out[1] : in.lambda;
    if (status == PW85_SUCCESS && !(out[0] >= 0 && lambda >= 0 && lambda <= 1)) fail("contact: range", in);
    check("contact_function", in, pw85_contact_function(r, a, b, out), out, 2);
    check("contact_geometry", in, pw85_contact_geometry(r, a, b, lambda, point, point + 3), point, 6);
    check("contact_gradient", in, pw85_contact_gradient(r, a, b, lambda, gradient, gradient + 3, gradient + 9),
          gradient, 15);
    check("contact_torque", in, pw85_contact_torque(r, a, b, lambda, torque, torque + 3), torque, 6);
    check("contact_hessian", in, pw85_contact_hessian(r, a, b, lambda, hessian), hessian, 81);
    check("closest_approach", in, pw85_closest_approach(r, a, b, out), out, 1);
    check("closest_approach_2d", in, pw85_closest_approach_2d(r, a, b, out), out, 1);
    check("legacy 1", in, pw85_legacy_contact_function1(r, a, b, out), out, 2);
    check("zheng_ellipses", in, pw85_zheng_ellipses(r, a, b, out), out, 1);
    check("zheng_ellipsoids", in, pw85_zheng_ellipsoids(r, a, b, out), out, 1);
    int overlap = 7;
    int const overlap_status = pw85_overlap(r, a, b, &overlap);
    if (overlap_status != status) fail("overlap: status", in);
    if (overlap_status == PW85_SUCCESS ? overlap != 0 && overlap != 1 : overlap != -1) fail("overlap", in);
}

// What is inside overlaps.
void check_containment(Input const &in)
{
    int overlap = 7, contains = 7;
    int const status = pw85_overlap(in.r12, in.q1, in.q2, &overlap);
    if (pw85_contains(in.r12, in.q1, in.q2, &contains) != status) fail("contains: status", in);
    if (status == PW85_SUCCESS ? contains != 0 && contains != 1 : contains != -1) fail("contains", in);
    if (contains == 1 && overlap != 1) fail("contains: no overlap", in);
    unsigned char code = 7;
    if (pw85_contains_batch(1, in.r12, in.q1, in.q2, &code) != status) fail("contains_batch: status", in);
    if (code != static_cast<unsigned char>(contains)) fail("contains_batch", in);
}

void check_flat_pair(Input const &in)
{
    double out[2], point[4], gradient[8], torque[2], hessian[16];
    auto const *r = in.r12, *a = in.q1, *b = in.q2;
    int const status = pw85_contact_2d(r, a, b, out);
    check("contact_2d", in, status, out, 2);
    double const lambda = status == PW85_SUCCESS ? out[1] : in.lambda;
    check("contact_geometry_2d", in, pw85_contact_geometry_2d(r, a, b, lambda, point, point + 2), point, 4);
    check("contact_gradient_2d", in, pw85_contact_gradient_2d(r, a, b, lambda, gradient, gradient + 2, gradient + 5),
          gradient, 8);
    check("contact_torque_2d", in, pw85_contact_torque_2d(r, a, b, lambda, torque, torque + 1), torque, 2);
    check("contact_hessian_2d", in, pw85_contact_hessian_2d(r, a, b, lambda, hessian), hessian, 16);
    int overlap = 7;
    if (pw85_overlap_2d(r, a, b, &overlap) != status) fail("overlap_2d: status", in);
    if (status == PW85_SUCCESS ? overlap != 0 && overlap != 1 : overlap != -1) fail("overlap_2d", in);
    unsigned char code = 7;
    if (pw85_overlap_batch_2d(1, r, a, b, &code) != status) fail("overlap_batch_2d: status", in);
    check("contact_batch_2d", in, pw85_contact_batch_2d(1, r, a, b, out, out + 1), out, 2);
}

// Points and derivatives of a pair that overlaps are NaN.
void check_distance(Input const &in)
{
    double distance, points[6], derivatives[90];
    int overlap;
    int const status = pw85_overlap(in.r12, in.q1, in.q2, &overlap);
    if (pw85_distance(in.r12, in.q1, in.q2, &distance, points, points + 3) != status) fail("distance: status", in);
    check("distance", in, status, &distance, 1);
    if (distance < 0) fail("distance: negative", in);
    bool const apart = status == PW85_SUCCESS && overlap == 0;
    if (apart ? has_nan(points, 6) : !all_nan(points, 6)) fail("distance: points", in);
    if (pw85_distance_derivatives(in.r12, in.q1, in.q2, derivatives, derivatives + 3, derivatives + 6,
                                  derivatives + 9) != status)
        fail("distance_derivatives: status", in);
    if (apart ? has_nan(derivatives, 90) : !all_nan(derivatives, 90)) fail("distance_derivatives", in);
    double depth;
    int const depth_status = pw85_penetration(in.r12, in.q1, in.q2, &depth, points);
    if (depth_status != status && depth_status != PW85_ECONVERGENCE) fail("penetration: status", in);
    check("penetration", in, depth_status, &depth, 1);
    if (depth_status == PW85_SUCCESS && (overlap == 1 ? has_nan(points, 3) || depth < 0 : depth != 0))
        fail("penetration", in);
    check("distance_2d", in, pw85_distance_2d(in.r12, in.q1, in.q2, &distance, points, points + 2), &distance, 1);
}

void check_walls(Input const &in)
{
    double out[7];
    auto const *r = in.r12, *q = in.q1, *x = in.axes, *y = in.rotation;
    check("distance_plane", in, pw85_distance_plane(r, in.lambda, q, out, out + 1), out, 4);
    check("distance_plane_derivatives", in, pw85_distance_plane_derivatives(r, q, out, out + 3), out, 6);
    check("contact_plane", in, pw85_contact_plane(r, in.lambda, q, out, out + 1), out, 4);
    check("contact_plane_derivatives", in, pw85_contact_plane_derivatives(r, in.lambda, q, out, out + 3), out, 6);
    check("distance_box", in, pw85_distance_box(x, y, q, out, out + 1, out + 4), out, 7);
    check("distance_cylinder", in, pw85_distance_cylinder(x, in.lambda, r, q, out, out + 1, out + 4), out, 7);
    check("distance_point", in, pw85_distance_point(r, q, out, out + 1, out + 4), out, 7);
    int const status = pw85_intersect_line(x, r, q, out);
    if (std::isnan(out[0]) != std::isnan(out[1]) || out[0] > out[1]) fail("intersect_line", in);
    if (status != PW85_SUCCESS && !all_nan(out, 2)) fail("intersect_line: status", in);
}

// A row is what the function of one row gives, to the last bit.
void check_row(char const *function, Input const &in, int one_status, double const *one, int status, double const *row,
               int n)
{
    if (status != one_status || std::memcmp(one, row, static_cast<std::size_t>(n) * sizeof *one) != 0)
        fail(function, in);
}

void check_rows_of_pairs(Input const &in)
{
    double one[90], row[90];
    auto const *r = in.r12, *a = in.q1, *b = in.q2;
    double const x = in.lambda;
    check_row("contact_function_batch", in, pw85_contact_function(r, a, b, one), one,
              pw85_contact_function_batch(1, r, a, b, row, row + 1), row, 2);
    check_row("contact_geometry_batch", in, pw85_contact_geometry(r, a, b, x, one, one + 3), one,
              pw85_contact_geometry_batch(1, r, a, b, &x, row, row + 3), row, 6);
    check_row("contact_gradient_batch", in, pw85_contact_gradient(r, a, b, x, one, one + 3, one + 9), one,
              pw85_contact_gradient_batch(1, r, a, b, &x, row, row + 3, row + 9), row, 15);
    check_row("contact_torque_batch", in, pw85_contact_torque(r, a, b, x, one, one + 3), one,
              pw85_contact_torque_batch(1, r, a, b, &x, row, row + 3), row, 6);
    check_row("contact_hessian_batch", in, pw85_contact_hessian(r, a, b, x, one), one,
              pw85_contact_hessian_batch(1, r, a, b, &x, row), row, 81);
    check_row("distance_derivatives_batch", in, pw85_distance_derivatives(r, a, b, one, one + 3, one + 6, one + 9), one,
              pw85_distance_derivatives_batch(1, r, a, b, row, row + 3, row + 6, row + 9), row, 90);
}

void check_rows_of_ellipses(Input const &in)
{
    double one[16], row[16];
    auto const *r = in.r12, *a = in.q1, *b = in.q2;
    double const x = in.lambda;
    check_row("contact_geometry_batch_2d", in, pw85_contact_geometry_2d(r, a, b, x, one, one + 2), one,
              pw85_contact_geometry_batch_2d(1, r, a, b, &x, row, row + 2), row, 4);
    check_row("contact_gradient_batch_2d", in, pw85_contact_gradient_2d(r, a, b, x, one, one + 2, one + 5), one,
              pw85_contact_gradient_batch_2d(1, r, a, b, &x, row, row + 2, row + 5), row, 8);
    check_row("contact_torque_batch_2d", in, pw85_contact_torque_2d(r, a, b, x, one, one + 1), one,
              pw85_contact_torque_batch_2d(1, r, a, b, &x, row, row + 1), row, 2);
    check_row("contact_hessian_batch_2d", in, pw85_contact_hessian_2d(r, a, b, x, one), one,
              pw85_contact_hessian_batch_2d(1, r, a, b, &x, row), row, 16);
    check_row("closest_approach_batch_2d", in, pw85_closest_approach_2d(r, a, b, one), one,
              pw85_closest_approach_batch_2d(1, r, a, b, row), row, 1);
    check_row("distance_batch_2d", in, pw85_distance_2d(r, a, b, one, one + 1, one + 3), one,
              pw85_distance_batch_2d(1, r, a, b, row, row + 1, row + 3), row, 5);
}

void check_rows_of_walls(Input const &in)
{
    double one[7], row[7];
    auto const *r = in.r12, *q = in.q1, *x = in.axes, *y = in.rotation;
    double const number = in.lambda;
    check_row("distance_plane_batch", in, pw85_distance_plane(r, number, q, one, one + 1), one,
              pw85_distance_plane_batch(1, r, &number, q, row, row + 1), row, 4);
    check_row("distance_plane_derivatives_batch", in, pw85_distance_plane_derivatives(r, q, one, one + 3), one,
              pw85_distance_plane_derivatives_batch(1, r, q, row, row + 3), row, 6);
    check_row("contact_plane_batch", in, pw85_contact_plane(r, number, q, one, one + 1), one,
              pw85_contact_plane_batch(1, r, &number, q, row, row + 1), row, 4);
    check_row("contact_plane_derivatives_batch", in, pw85_contact_plane_derivatives(r, number, q, one, one + 3), one,
              pw85_contact_plane_derivatives_batch(1, r, &number, q, row, row + 3), row, 6);
    check_row("distance_box_batch", in, pw85_distance_box(x, y, q, one, one + 1, one + 4), one,
              pw85_distance_box_batch(1, x, y, q, row, row + 1, row + 4), row, 7);
    check_row("distance_cylinder_batch", in, pw85_distance_cylinder(x, number, r, q, one, one + 1, one + 4), one,
              pw85_distance_cylinder_batch(1, x, &number, r, q, row, row + 1, row + 4), row, 7);
    check_row("distance_point_batch", in, pw85_distance_point(r, q, one, one + 1, one + 4), one,
              pw85_distance_point_batch(1, r, q, row, row + 1, row + 4), row, 7);
    check_row("intersect_line_batch", in, pw85_intersect_line(x, r, q, one), one,
              pw85_intersect_line_batch(1, x, r, q, row, row + 1), row, 2);
}

// Rows are what single calls give; distances but for rounding.
void check_rows_of_distances(Input const &in)
{
    double one[7], row[7];
    auto const *r = in.r12, *a = in.q1, *b = in.q2;
    int const status = pw85_distance(r, a, b, one, one + 1, one + 4);
    if (pw85_distance_batch(1, r, a, b, row, row + 1, row + 4) != status) fail("distance_batch: status", in);
    check("distance_batch", in, status, row, 1);
    if (std::isnan(one[1]) != std::isnan(row[1])) fail("distance_batch: points", in);
    check_row("penetration_batch", in, pw85_penetration(r, a, b, one, one + 1), one,
              pw85_penetration_batch(1, r, a, b, row, row + 1), row, 4);
}

// Times are not negative and not after the end; infinity is none.
void check_motion(Input const &in)
{
    auto const *x = in.rotation;
    pw85_motion const motions[2] = {{{x[0], x[1], x[2]}, {x[3], x[4], x[5]}, x[6]},
                                    {{x[6], x[7], x[8]}, {x[0], x[2], x[4]}, in.lambda}};
    pw85_motion const slide{{x[0], x[1], x[2]}, {0, 0, 0}, 0}, still{};
    double const end = in.axes[0];
    double t, batch, list[1], next[2];
    std::int64_t next_pair[2];
    auto const check_time = [&](pw85_motion const &a, pw85_motion const &b) {
        int const status = pw85_first_contact(in.r12, in.q1, in.q2, &a, &b, end, &t);
        check("first_contact", in, status, &t, 1);
        if (status == PW85_SUCCESS && !(t >= 0 && (t <= end || std::isinf(t)))) fail("first_contact: range", in);
        if (pw85_first_contact_batch(1, in.r12, in.q1, in.q2, &a, &b, end, &batch) != status)
            fail("first_contact_batch: status", in);
        if (status == PW85_SUCCESS && t != batch) fail("first_contact_batch", in);
    };
    check_time(slide, still);
    check_time(motions[0], motions[1]);
    double centers[6] = {0, 0, 0, in.r12[0], in.r12[1], in.r12[2]}, forms[12];
    std::memcpy(forms, in.q1, sizeof in.q1);
    std::memcpy(forms + 6, in.q2, sizeof in.q2);
    std::int32_t const pairs[2] = {0, 1};
    check("first_contact_pairs", in,
          pw85_first_contact_pairs(list_of(1, pairs), system_of(2, centers, forms, nullptr), motions, end, list, next,
                                   next_pair),
          list, 1);
}

void check_batch(Input const &in)
{
    double mu2[1], lambda[1];
    unsigned char overlap = 7;
    int const status = pw85_contact_batch(1, in.r12, in.q1, in.q2, mu2, lambda);
    check("contact_batch", in, status, mu2, 1);
    check("contact_batch: lambda", in, status, lambda, 1);
    if (pw85_overlap_batch(1, in.r12, in.q1, in.q2, &overlap) != status) fail("overlap_batch: status", in);
    if (status == PW85_SUCCESS ? overlap > 1 : overlap != 255) fail("overlap_batch", in);
    double centers[6] = {0, 0, 0, in.r12[0], in.r12[1], in.r12[2]}, forms[12];
    std::memcpy(forms, in.q1, sizeof in.q1);
    std::memcpy(forms + 6, in.q2, sizeof in.q2);
    std::int32_t const pairs[2] = {0, 1};
    check("contact_pairs", in,
          pw85_contact_pairs(list_of(1, pairs), system_of(2, centers, forms, nullptr), mu2, lambda), mu2, 1);
    pw85_contact_pairs(list_of(1, pairs), system_of(2, centers, forms, in.rotation), mu2, lambda);
    pw85_contact_pairs(list_of(1, pairs), system_of(2, centers, forms, in.rotation, true), mu2, lambda);
    pw85_overlap_pairs(list_of(1, pairs), system_of(2, centers, forms, in.rotation), &overlap);
    double limit, out[17];
    pw85_contact_derivatives_pairs(list_of(1, pairs), system_of(2, centers, forms, in.rotation), out, out + 1, out + 2,
                                   out + 5, out + 8, out + 11, out + 14);
    double vector[3] = {};
    std::int32_t image[3];
    if (pw85_nearest_images(1, pairs, system_of(2, centers, nullptr, in.rotation), vector, image) == PW85_SUCCESS &&
        has_nan(vector, 3))
        fail("nearest_images", in);
    check("nearest_image_limit", in, pw85_nearest_image_limit(system_of(2, nullptr, forms, in.rotation), &limit),
          &limit, 1);
}

// What a device does with a pair, here: it answers as the host, marks what is not valid, or leaves it to the host.
void check_device(Input const &in)
{
    using namespace pw85::detail::gpu;
    double mu2, lambda, out[17], contact[2];
    unsigned char overlap = 7, expected;
    // Where a pivot is zero to rounding, what is rounded in another way may judge the form differently; this function is not fused,
    // as what a device does is not here.
    int const status = pw85_contact_function(in.r12, in.q1, in.q2, contact);
    bool const agreed = pw85_overlap_batch(1, in.r12, in.q1, in.q2, &expected) == status;
    Pair3 const pair = load(Pairs{in.r12, in.q1, in.q2}, 0);
    ContactArrays const contacts{&mu2, &lambda};
    if (!attempt(contacts, pair, 0)) settle(contacts, pair, 0);
    check("device: contact", in, status, &mu2, 1);
    OverlapArray const overlaps{&overlap};
    bool const answered = attempt(overlaps, pair, 0) || settle(overlaps, pair, 0);
    if (agreed && answered && overlap != expected) fail("device: overlap", in);
    DerivativeArrays const derivatives{out, out + 1, out + 2, out + 5, out + 8, out + 11, out + 14};
    if (!attempt(derivatives, pair, 0)) settle(derivatives, pair, 0);
    check("device: derivatives", in, status, out + 8, 9);
}

// A pair at r12 = 0 has derivatives, but no point and no normal.
void check_rows(Input const &in)
{
    double mu2, out[17];
    int any = 7;
    int const status = pw85_contact_derivatives_batch(1, in.r12, in.q1, in.q2, &mu2, out, out + 1, out + 4, out + 7,
                                                      out + 10, out + 13);
    check("contact_derivatives_batch", in, status, &mu2, 1);
    check("contact_derivatives_batch: derivatives", in, status, out + 7, 9);
    if (pw85_overlap_any(in.q1, 1, in.r12, in.q2, &any) != status) fail("overlap_any: status", in);
    if (status == PW85_SUCCESS ? any != 0 && any != 1 : any != -1) fail("overlap_any", in);
    check("closest_approach_batch", in, pw85_closest_approach_batch(1, in.r12, in.q1, in.q2, out), out, 1);
    check("bounding_boxes", in, pw85_bounding_boxes(1, in.q1, out), out, 3);
    check("ellipsoid_quaternion_batch", in, pw85_ellipsoid_quaternion_batch(1, in.axes, in.rotation, out), out, 6);
    check("cell_reduce", in, pw85_cell_reduce(in.rotation, out), out, 9);
}

// The images of large particles in a small cell are too many to list.
bool are_few(Input const &in)
{
    double mu2;
    return pw85_nearest_image_limit(system_of(1, nullptr, in.q1, in.rotation), &mu2) == PW85_SUCCESS && mu2 > 1e-2 &&
           pw85_nearest_image_limit(system_of(1, nullptr, in.q2, in.rotation), &mu2) == PW85_SUCCESS && mu2 > 1e-2;
}

void check_neighbors(Input const &in)
{
    double centers[6] = {0, 0, 0, in.r12[0], in.r12[1], in.r12[2]}, forms[12];
    std::memcpy(forms, in.q1, sizeof in.q1);
    std::memcpy(forms + 6, in.q2, sizeof in.q2);
    double const *const cell = are_few(in) ? in.rotation : nullptr;
    pw85_neighbors *list;
    std::size_t particle = 7;
    int holds = 7;
    int const status = pw85_neighbors_create(system_of(2, centers, forms, cell), 1.0, 0.0, &list);
    if (pw85_neighbors_check(system_of(2, centers, forms, cell), 1.0, 0.0, &particle) != status && list != nullptr)
        fail("neighbors_check", in);
    if ((status == PW85_SUCCESS) != (list != nullptr)) fail("neighbors_create", in);
    pw85_neighbors_holds(list, system_of(2, centers, forms, cell), &holds);
    if (holds != (list != nullptr ? 1 : -1)) fail("neighbors_holds", in);
    pw85_pair_list const found = pw85_neighbors_list(list);
    for (std::size_t k = 0; k < 2 * found.num_pairs; ++k)
        if (found.pairs[k] < 0 || found.pairs[k] > 1) fail("neighbors_list: pairs", in);
    if (found.num_pairs > 0 && (found.images != nullptr) != (cell != nullptr)) fail("neighbors_list: images", in);
    std::int32_t const other = 1, pair[2] = {0, 1};
    double sums[21];
    int any = 7;
    int const any_status =
        pw85_overlap_any_indices(centers, forms, system_of(2, centers, forms, nullptr), 1, &other, nullptr, &any);
    if (any_status == PW85_SUCCESS ? any != 0 && any != 1 : any != -1) fail("overlap_any_indices", in);
    pw85_contact_forces_pairs(list_of(1, pair), system_of(2, centers, nullptr, nullptr), in.axes, in.q1, in.q2,
                              in.rotation, sums, sums + 6, sums + 12);
    pw85_neighbors_destroy(list);
}

void check_building_blocks(Input const &in)
{
    double out[6], params[15], b[4];
    pw85__cholesky_decomp(in.q1, out);
    pw85__cholesky_solve(out, in.r12, b);
    pw85__residual(in.lambda, in.r12, in.q1, in.q2, out);
    std::memcpy(params, in.r12, sizeof in.r12);
    std::memcpy(params + 3, in.q1, sizeof in.q1);
    std::memcpy(params + 9, in.q2, sizeof in.q2);
    pw85_f_neg(in.lambda, params);
    pw85_legacy_f1(in.lambda, in.r12, in.q1, in.q2, out);
    pw85_legacy_f2(in.lambda, in.r12, in.q1, in.q2, out);
    pw85_legacy_f2_derivatives(in.lambda, in.r12, in.q1, in.q2, out);
    pw85_legacy_contact_function2(in.r12, in.q1, in.q2, out);
    pw85_legacy__det_sym(in.q1);
    pw85_legacy__xT_adjA_x(in.r12, in.q1);
    pw85_legacy__detQ_as_poly(in.q1, in.q2, in.q1, in.q2, b);
    pw85_legacy__rT_adjQ_r_as_poly(in.r12, in.q1, in.q2, in.q1, out);
    pw85_strerror(in.form);
    pw85_version();
}

// Raw bytes rarely make a positive definite matrix: most inputs are turned into L Lᵀ with entries of like magnitude.
void make_definite(double *q, int exponent)
{
    double l[6];
    for (int k = 0; k < 6; ++k) {
        int e = 0;
        l[k] = std::isfinite(q[k]) ? std::frexp(q[k], &e) : 0.5;
        l[k] = std::ldexp(l[k], e % 24);
    }
    for (double *d : {&l[0], &l[3], &l[5]}) *d = std::fabs(*d) + 0x1p-30;
    double const a[6] = {l[0] * l[0],
                         l[0] * l[1],
                         l[0] * l[2],
                         l[1] * l[1] + l[3] * l[3],
                         l[1] * l[2] + l[3] * l[4],
                         l[2] * l[2] + l[4] * l[4] + l[5] * l[5]};
    for (int k = 0; k < 6; ++k) q[k] = std::ldexp(a[k], 2 * exponent);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const *data, std::size_t size)
{
    Input in{};
    std::memcpy(&in, data, std::min(size, sizeof in));
    if (in.form % 4 != 0) {
        make_definite(in.q1, in.form % 4 == 1 ? 0 : in.scale - 128);
        make_definite(in.q2, in.form % 4 == 3 ? 128 - in.scale : 0);
    }
    check_builders(in);
    check_pair(in);
    check_flat_pair(in);
    check_containment(in);
    check_distance(in);
    check_rows_of_distances(in);
    check_rows_of_pairs(in);
    check_rows_of_ellipses(in);
    check_rows_of_walls(in);
    check_motion(in);
    check_walls(in);
    check_batch(in);
    check_device(in);
    check_rows(in);
    check_neighbors(in);
    check_building_blocks(in);
    return 0;
}
