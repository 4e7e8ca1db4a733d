// SPDX-License-Identifier: BSD-3-Clause
// The C API of two ellipsoids in n dimensions, by hand: api/declarations.py has no extents such as
// n (n + 1)/2.
#include <cstdint>

#include <pw85.h>
#include <pw85_any_dimension.h>

#include <pw85/any_dimension/containment.hpp>
#include <pw85/any_dimension/distance.hpp>
#include <pw85/any_dimension/geometry.hpp>
#include <pw85/any_dimension/overlap.hpp>

#include "../base/c_arrays.hpp"
#include "../base/floating_point_environment.hpp"

using namespace pw85;
using namespace pw85::detail::c_api;
using pw85::detail::in_default_environment;
using pw85::detail::any_dimension::packed_size;

static_assert(PW85_ND_MAX == pw85::detail::any_dimension::max_dimension);

namespace {

using Size = std::size_t;

constexpr double nan = pw85::detail::quiet_nan<double>();

/// The forms and separations of rows of one n.
struct Rows {
    Size count;
    int n;
    double const *r12, *q1, *q2;

    double const *r12_of(Size k) const noexcept { return r12 + k * static_cast<Size>(n); }
    double const *q1_of(Size k) const noexcept
    {
        return q1 + k * static_cast<Size>(packed_size(n));
    }
    double const *q2_of(Size k) const noexcept
    {
        return q2 + k * static_cast<Size>(packed_size(n));
    }
};

/// Calls function(k, r12, q1, q2), which returns a status, for each row. Returns the first status
/// that is not success; PW85_EINVAL if n is wrong, if there are rows and no arrays for them, or if
/// the bytes of the rows cannot be counted. `others` are further arrays that must not be null.
template <class Function, class... Others>
int for_each_row(Rows const &rows, Function const &function, Others... others) noexcept
{
    if (rows.n < 1 || rows.n > PW85_ND_MAX) return PW85_EINVAL;
    if (rows.count == 0) return PW85_SUCCESS;
    Size const bytes = static_cast<Size>(packed_size(rows.n)) * sizeof(double);
    if (any_null(rows.r12, rows.q1, rows.q2, others...) || rows.count > PTRDIFF_MAX / bytes)
        return null_pointer();
    int first = PW85_SUCCESS;
    for (Size k = 0; k < rows.count; ++k) {
        int const status = function(k, rows.r12_of(k), rows.q1_of(k), rows.q2_of(k));
        if (first == PW85_SUCCESS) first = status;
    }
    return first;
}

/// Row k of an output, or null.
double *row(double *x, int size, Size k) noexcept
{
    return x == nullptr ? x : x + k * static_cast<Size>(size);
}

/// Returns the length of an output of this many numbers per row. It is 0 if n is wrong: then
/// nothing is known of the array.
int length(int n, int size) noexcept { return n < 1 || n > PW85_ND_MAX ? 0 : size; }

void store_all_nan(int n, NdGeometry const &out) noexcept
{
    for (double *x : {out.point, out.normal, out.d_r12}) store_nan(x, length(n, n));
    for (double *x : {out.d_q1, out.d_q2}) store_nan(x, length(n, packed_size(n)));
}

[[gnu::noinline]] Status geometry_of(int n, double const *r12, double const *q1, double const *q2,
                                     double lambda, NdGeometry const &out) noexcept
{
    Status const status =
        in_default_environment([&] { return nd_contact_geometry(n, r12, q1, q2, lambda, out); });
    if (status != Status::success) store_all_nan(n, out);
    return status;
}

} // namespace

int pw85_nd_contact(int n, double const *r12, double const *q1, double const *q2, double out[2])
{
    if (any_null(r12, q1, q2, out)) return null_pointer(out, 2);
    auto const result = in_default_environment([&] { return nd_contact(n, r12, q1, q2); });
    return put(result.status, result.mu2, out, result.lambda, out + 1);
}

int pw85_nd_contact_geometry(int n, double const *r12, double const *q1, double const *q2,
                             double lambda, double *point, double *normal, double *d_r12,
                             double *d_q1, double *d_q2)
{
    NdGeometry const out{point, normal, d_r12, d_q1, d_q2};
    if (any_null(r12, q1, q2)) {
        store_all_nan(n, out);
        return null_pointer();
    }
    return static_cast<int>(geometry_of(n, r12, q1, q2, lambda, out));
}

int pw85_nd_compare(int n, double const *r12, double const *q1, double const *q2, double mu2,
                    int *sign)
{
    if (sign == nullptr) return null_pointer();
    *sign = 2;
    if (any_null(r12, q1, q2)) return null_pointer();
    auto const result = in_default_environment([&] { return nd_compare(n, r12, q1, q2, mu2); });
    if (result.status == Status::success) *sign = result.sign;
    return put(result.status);
}

int pw85_nd_overlap(int n, double const *r12, double const *q1, double const *q2, int *overlap)
{
    if (overlap == nullptr) return null_pointer();
    *overlap = -1;
    if (any_null(r12, q1, q2)) return null_pointer();
    auto const result = in_default_environment([&] { return nd_overlap(n, r12, q1, q2); });
    return put(result.status, result.overlap, overlap);
}

int pw85_nd_contains(int n, double const *r12, double const *q1, double const *q2, int *contains)
{
    if (contains == nullptr) return null_pointer();
    *contains = -1;
    if (any_null(r12, q1, q2)) return null_pointer();
    auto const result = in_default_environment([&] { return nd_contains(n, r12, q1, q2); });
    return put(result.status, result.contains, contains);
}

int pw85_nd_containment(int n, double const *r12, double const *q1, double const *q2, double *mu2,
                        double *point)
{
    store(nan, mu2);
    store_nan(point, length(n, n));
    if (any_null(r12, q1, q2)) return null_pointer();
    auto const result =
        in_default_environment([&] { return nd_containment(n, r12, q1, q2, point); });
    return put(result.status, result.mu2, mu2);
}

int pw85_nd_distance(int n, double const *r12, double const *q1, double const *q2, double *distance,
                     double *point1, double *point2, double *normal)
{
    store(nan, distance);
    for (double *x : {point1, point2, normal}) store_nan(x, length(n, n));
    if (any_null(r12, q1, q2)) return null_pointer();
    auto const result = in_default_environment([&] {
        return nd_distance(n, r12, q1, q2, {point1, point2, normal});
    });
    return put(result.status, result.distance, distance);
}

int pw85_nd_contact_batch(size_t num_pairs, int n, double const *r12, double const *q1,
                          double const *q2, double *mu2, double *lambda)
{
    auto const contact = [&](Size k, auto... pair) {
        double out[2];
        int const status = pw85_nd_contact(n, pair..., out);
        mu2[k] = out[0];
        if (lambda != nullptr) lambda[k] = out[1];
        return status;
    };
    return for_each_row({num_pairs, n, r12, q1, q2}, contact, mu2);
}

int pw85_nd_contact_geometry_batch(size_t num_pairs, int n, double const *r12, double const *q1,
                                   double const *q2, double const *lambda, double *point,
                                   double *normal, double *d_r12, double *d_q1, double *d_q2)
{
    int const size = packed_size(n);
    auto const geometry = [&](Size k, auto... pair) {
        return static_cast<int>(geometry_of(n, pair..., lambda[k],
                                            {row(point, n, k), row(normal, n, k), row(d_r12, n, k),
                                             row(d_q1, size, k), row(d_q2, size, k)}));
    };
    return for_each_row({num_pairs, n, r12, q1, q2}, geometry, lambda);
}

int pw85_nd_overlap_batch(size_t num_pairs, int n, double const *r12, double const *q1,
                          double const *q2, unsigned char *overlap)
{
    auto const decide = [&](Size k, auto... pair) {
        int answer;
        int const status = pw85_nd_overlap(n, pair..., &answer);
        overlap[k] = static_cast<unsigned char>(answer);
        return status;
    };
    return for_each_row({num_pairs, n, r12, q1, q2}, decide, overlap);
}

int pw85_nd_compare_batch(size_t num_pairs, int n, double const *r12, double const *q1,
                          double const *q2, double const *mu2, int *sign)
{
    auto const compare = [&](Size k, auto... pair) {
        int const status = pw85_nd_compare(n, pair..., mu2[k], sign + k);
        if (status != PW85_SUCCESS) sign[k] = 2;
        return status;
    };
    return for_each_row({num_pairs, n, r12, q1, q2}, compare, mu2, sign);
}

int pw85_nd_contains_batch(size_t num_pairs, int n, double const *r12, double const *q1,
                           double const *q2, unsigned char *contains)
{
    auto const decide = [&](Size k, auto... pair) {
        int answer;
        int const status = pw85_nd_contains(n, pair..., &answer);
        contains[k] = static_cast<unsigned char>(answer);
        return status;
    };
    return for_each_row({num_pairs, n, r12, q1, q2}, decide, contains);
}

int pw85_nd_containment_batch(size_t num_pairs, int n, double const *r12, double const *q1,
                              double const *q2, double *mu2, double *point)
{
    auto const scale = [&](Size k, auto... pair) {
        return pw85_nd_containment(n, pair..., row(mu2, 1, k), row(point, n, k));
    };
    return for_each_row({num_pairs, n, r12, q1, q2}, scale);
}

int pw85_nd_distance_batch(size_t num_pairs, int n, double const *r12, double const *q1,
                           double const *q2, double *distance, double *point1, double *point2,
                           double *normal)
{
    auto const find = [&](Size k, auto... pair) {
        return pw85_nd_distance(n, pair..., row(distance, 1, k), row(point1, n, k),
                                row(point2, n, k), row(normal, n, k));
    };
    return for_each_row({num_pairs, n, r12, q1, q2}, find);
}
