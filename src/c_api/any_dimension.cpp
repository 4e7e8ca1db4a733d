// SPDX-License-Identifier: BSD-3-Clause
// The C API of two ellipsoids in n dimensions, by hand: api/shims.py makes functions of arrays with
// fixed sizes for each pair.
#include <cstdint>

#include <pw85.h>
#include <pw85_any_dimension.h>

#include "../any_dimension/causes.hpp"
#include "../any_dimension/functions.hpp"
#include "../base/c_arrays.hpp"
#include "../base/floating_point_environment.hpp"

using namespace pw85;
using namespace pw85::detail::c_api;
using pw85::detail::Argument, pw85::detail::checked, pw85::detail::NamedArray;
using pw85::detail::in_default_environment;
namespace compiled = pw85::detail::compiled;
using pw85::detail::any_dimension::packed_size;

static_assert(PW85_ND_MAX == pw85::detail::any_dimension::max_dimension);

namespace limit = pw85::detail::limit;

namespace {

using Size = std::size_t;

constexpr double not_a_number = pw85::detail::quiet_nan<double>();

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

/// Returns the length of an output of this many numbers per row. It is 0 if n is wrong: then
/// nothing is known of the array.
int length(int n, int size) noexcept { return n < 1 || n > PW85_ND_MAX ? 0 : size; }

/// Records the cause of a status of one pair. `others` are further arguments.
template <class... Others>
[[gnu::cold, gnu::noinline]] int refuse_pair(int status, char const *function, int n,
                                             double const *r12, double const *q1, double const *q2,
                                             Others... others) noexcept
{
    auto const size = static_cast<Size>(length(n, packed_size(n)));
    Argument const listed[] = {Argument("r12", r12, static_cast<Size>(length(n, n))),
                               Argument("q1", q1, size), Argument("q2", q2, size), others...};
    return pw85::detail::any_dimension::refuse_pair(status, function, n, listed,
                                                    3 + sizeof...(others));
}

/// Calls a function of one row.
using CallRow = int (*)(void const *function, Rows const &rows, Size k);

/// for_each_row() with the function behind a pointer.
[[gnu::noinline]] int call_rows(char const *name, Rows const &rows, CallRow call,
                                void const *function, NamedArray const &first,
                                NamedArray const &second) noexcept
{
    if (rows.n < 1 || rows.n > PW85_ND_MAX)
        return pw85::detail::any_dimension::refuse_dimension(name, rows.n);
    if (rows.count == 0) return PW85_SUCCESS;
    Size const bytes = static_cast<Size>(packed_size(rows.n)) * sizeof(double);
    if (any_null(rows.r12, rows.q1, rows.q2, first.pointer, second.pointer) ||
        rows.count > PTRDIFF_MAX / bytes)
        return pw85::detail::refuse_arrays(name, "num_pairs", rows.count,
                                           NamedArray{"r12", rows.r12}, NamedArray{"q1", rows.q1},
                                           NamedArray{"q2", rows.q2}, first, second);
    Size bad = rows.count;
    for (Size k = 0; k < rows.count; ++k)
        if (call(function, rows, k) != PW85_SUCCESS && bad == rows.count) bad = k;
    // Bad rows after the first one have recorded their causes, too.
    return bad == rows.count ? PW85_SUCCESS
                             : pw85::detail::refuse_row(call(function, rows, bad), bad);
}

/// Calls function(k, r12, q1, q2), which returns a status, for each row. Returns the first status
/// that is not success, and records its cause with the row; PW85_EINVAL if n is wrong, if there are
/// rows and no arrays for them, or if the bytes of the rows cannot be counted. `first` and `second`
/// are further arrays that must not be null.
template <class Function> int for_each_row(char const *name, Rows const &rows,
                                           Function const &function, NamedArray first,
                                           NamedArray second) noexcept
{
    auto const call = [](void const *given, Rows const &all, Size k) {
        return (*static_cast<Function const *>(given))(k, all.r12_of(k), all.q1_of(k),
                                                       all.q2_of(k));
    };
    return call_rows(name, rows, call, &function, first, second);
}
template <class Function> int for_each_row(char const *name, Rows const &rows,
                                           Function const &function, NamedArray first) noexcept
{
    return for_each_row(name, rows, function, first, first);
}
template <class Function>
int for_each_row(char const *name, Rows const &rows, Function const &function) noexcept
{
    return for_each_row(name, rows, function, NamedArray{"r12", rows.r12});
}

/// Row k of an output, or null.
double *row(double *x, int size, Size k) noexcept
{
    return x == nullptr ? x : x + k * static_cast<Size>(size);
}

void store_all_nan(int n, NdGeometry const &out) noexcept
{
    for (double *x : {out.point, out.normal, out.d_r12}) store_nan(x, length(n, n));
    for (double *x : {out.d_q1, out.d_q2}) store_nan(x, length(n, packed_size(n)));
}

} // namespace

int pw85_nd_contact(int n, double const *r12, double const *q1, double const *q2, double out[2])
{
    auto const work = [&] {
        if (any_null(r12, q1, q2, out)) return null_pointer(out, 2);
        auto const result = in_default_environment(compiled::nd_contact, n, r12, q1, q2);
        return put(result.status, result.mu2, out, result.lambda, out + 1);
    };
    return checked(work(), [&](int status) PW85_IN_COLD_PATH {
        return refuse_pair(status, "pw85_nd_contact", n, r12, q1, q2, Argument("out", out));
    });
}

int pw85_nd_contact_geometry(int n, double const *r12, double const *q1, double const *q2,
                             double lambda, double *point, double *normal, double *d_r12,
                             double *d_q1, double *d_q2)
{
    NdGeometry const out{point, normal, d_r12, d_q1, d_q2};
    auto status = Status::invalid_argument;
    if (!any_null(r12, q1, q2))
        status = in_default_environment(compiled::nd_contact_geometry, n, r12, q1, q2, lambda, out);
    if (status == Status::success) [[likely]]
        return PW85_SUCCESS;
    store_all_nan(n, out);
    return refuse_pair(static_cast<int>(status), "pw85_nd_contact_geometry", n, r12, q1, q2,
                       Argument("lambda", lambda, limit::unit_interval),
                       Argument("r12", r12, static_cast<Size>(length(n, n)), limit::not_zero));
}

int pw85_nd_compare(int n, double const *r12, double const *q1, double const *q2, double mu2,
                    int *sign)
{
    auto const work = [&] {
        if (sign == nullptr) return null_pointer();
        *sign = 2;
        if (any_null(r12, q1, q2)) return null_pointer();
        auto const result = in_default_environment(compiled::nd_compare, n, r12, q1, q2, mu2);
        if (result.status == Status::success) *sign = result.sign;
        return put(result.status);
    };
    return checked(work(), [&](int status) PW85_IN_COLD_PATH {
        return refuse_pair(status, "pw85_nd_compare", n, r12, q1, q2,
                           Argument("mu2", mu2, limit::from_zero | limit::may_be_infinite),
                           Argument("sign", sign));
    });
}

int pw85_nd_overlap(int n, double const *r12, double const *q1, double const *q2, int *overlap)
{
    auto const work = [&] {
        if (overlap == nullptr) return null_pointer();
        *overlap = -1;
        if (any_null(r12, q1, q2)) return null_pointer();
        auto const result = in_default_environment(compiled::nd_overlap, n, r12, q1, q2);
        return put(result.status, result.overlap, overlap);
    };
    return checked(work(), [&](int status) PW85_IN_COLD_PATH {
        return refuse_pair(status, "pw85_nd_overlap", n, r12, q1, q2, Argument("overlap", overlap));
    });
}

int pw85_nd_contains(int n, double const *r12, double const *q1, double const *q2, int *contains)
{
    auto const work = [&] {
        if (contains == nullptr) return null_pointer();
        *contains = -1;
        if (any_null(r12, q1, q2)) return null_pointer();
        auto const result = in_default_environment(compiled::nd_contains, n, r12, q1, q2);
        return put(result.status, result.contains, contains);
    };
    return checked(work(), [&](int status) PW85_IN_COLD_PATH {
        return refuse_pair(status, "pw85_nd_contains", n, r12, q1, q2,
                           Argument("contains", contains));
    });
}

int pw85_nd_containment(int n, double const *r12, double const *q1, double const *q2, double *mu2,
                        double *point)
{
    auto const work = [&] {
        store(not_a_number, mu2);
        store_nan(point, length(n, n));
        if (any_null(r12, q1, q2)) return null_pointer();
        auto const result = in_default_environment(compiled::nd_containment, n, r12, q1, q2, point);
        return put(result.status, result.mu2, mu2);
    };
    return checked(work(), [&](int status) PW85_IN_COLD_PATH {
        return refuse_pair(status, "pw85_nd_containment", n, r12, q1, q2);
    });
}

int pw85_nd_distance(int n, double const *r12, double const *q1, double const *q2, double *distance,
                     double *point1, double *point2, double *normal)
{
    auto const work = [&] {
        store(not_a_number, distance);
        for (double *x : {point1, point2, normal}) store_nan(x, length(n, n));
        if (any_null(r12, q1, q2)) return null_pointer();
        auto const result = in_default_environment(compiled::nd_distance, n, r12, q1, q2,
                                                   NdClosestPoints{point1, point2, normal});
        return put(result.status, result.distance, distance);
    };
    return checked(work(), [&](int status) PW85_IN_COLD_PATH {
        return refuse_pair(status, "pw85_nd_distance", n, r12, q1, q2);
    });
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
    return for_each_row("pw85_nd_contact_batch", {num_pairs, n, r12, q1, q2}, contact,
                        NamedArray{"mu2", mu2});
}

int pw85_nd_contact_geometry_batch(size_t num_pairs, int n, double const *r12, double const *q1,
                                   double const *q2, double const *lambda, double *point,
                                   double *normal, double *d_r12, double *d_q1, double *d_q2)
{
    int const size = packed_size(n);
    auto const geometry = [&](Size k, auto... pair) {
        return pw85_nd_contact_geometry(n, pair..., lambda[k], row(point, n, k), row(normal, n, k),
                                        row(d_r12, n, k), row(d_q1, size, k), row(d_q2, size, k));
    };
    return for_each_row("pw85_nd_contact_geometry_batch", {num_pairs, n, r12, q1, q2}, geometry,
                        NamedArray{"lambda", lambda});
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
    return for_each_row("pw85_nd_overlap_batch", {num_pairs, n, r12, q1, q2}, decide,
                        NamedArray{"overlap", overlap});
}

int pw85_nd_compare_batch(size_t num_pairs, int n, double const *r12, double const *q1,
                          double const *q2, double const *mu2, int *sign)
{
    auto const compare = [&](Size k, auto... pair) {
        int const status = pw85_nd_compare(n, pair..., mu2[k], sign + k);
        if (status != PW85_SUCCESS) sign[k] = 2;
        return status;
    };
    return for_each_row("pw85_nd_compare_batch", {num_pairs, n, r12, q1, q2}, compare,
                        NamedArray{"mu2", mu2}, NamedArray{"sign", sign});
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
    return for_each_row("pw85_nd_contains_batch", {num_pairs, n, r12, q1, q2}, decide,
                        NamedArray{"contains", contains});
}

int pw85_nd_containment_batch(size_t num_pairs, int n, double const *r12, double const *q1,
                              double const *q2, double *mu2, double *point)
{
    auto const scale = [&](Size k, auto... pair) {
        return pw85_nd_containment(n, pair..., row(mu2, 1, k), row(point, n, k));
    };
    return for_each_row("pw85_nd_containment_batch", {num_pairs, n, r12, q1, q2}, scale);
}

int pw85_nd_distance_batch(size_t num_pairs, int n, double const *r12, double const *q1,
                           double const *q2, double *distance, double *point1, double *point2,
                           double *normal)
{
    auto const find = [&](Size k, auto... pair) {
        return pw85_nd_distance(n, pair..., row(distance, 1, k), row(point1, n, k),
                                row(point2, n, k), row(normal, n, k));
    };
    return for_each_row("pw85_nd_distance_batch", {num_pairs, n, r12, q1, q2}, find);
}
