// SPDX-License-Identifier: BSD-3-Clause
// The C API of two ellipsoids in n dimensions, by hand: api/declarations.py has no extents such as
// n (n + 1)/2.
#include <cstdint>

#include <pw85.h>
#include <pw85_any_dimension.h>

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

/// The first status that is not success.
class FirstStatus {
  public:
    void take(Status status) noexcept
    {
        if (first_ == Status::success) first_ = status;
    }
    int value() const noexcept { return static_cast<int>(first_); }

  private:
    Status first_ = Status::success;
};

/// The forms and separations of rows of one n.
struct Rows {
    int n;
    double const *r12, *q1, *q2;

    /// Tests if an argument is wrong, or if the bytes of `num_pairs` rows cannot be counted.
    bool are_wrong(Size num_pairs) const noexcept
    {
        return n < 1 || n > PW85_ND_MAX || any_null(r12, q1, q2) ||
               num_pairs > PTRDIFF_MAX / (static_cast<Size>(packed_size(n)) * sizeof(double));
    }
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

/// Row k of an output, or null.
double *row(double *x, int size, Size k) noexcept
{
    return x == nullptr ? x : x + k * static_cast<Size>(size);
}

/// The length of an output of this many numbers per row. It is 0 if n is wrong: then nothing is
/// known of the array.
int length(int n, int size) noexcept { return n < 1 || n > PW85_ND_MAX ? 0 : size; }

void store_nan(int n, NdGeometry const &out) noexcept
{
    for (double *x : {out.point, out.normal, out.d_r12})
        pw85::detail::c_api::store_nan(x, length(n, n));
    for (double *x : {out.d_q1, out.d_q2})
        pw85::detail::c_api::store_nan(x, length(n, packed_size(n)));
}

[[gnu::noinline]] Status geometry_of(int n, double const *r12, double const *q1, double const *q2,
                                     double lambda, NdGeometry const &out) noexcept
{
    Status const status =
        in_default_environment([&] { return nd_contact_geometry(n, r12, q1, q2, lambda, out); });
    if (status != Status::success) store_nan(n, out);
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
        store_nan(n, out);
        return null_pointer();
    }
    return static_cast<int>(geometry_of(n, r12, q1, q2, lambda, out));
}

int pw85_nd_compare(int n, double const *r12, double const *q1, double const *q2, double mu2,
                    int *sign)
{
    if (sign == nullptr) return null_pointer();
    *sign = -2;
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

int pw85_nd_contact_batch(size_t num_pairs, int n, double const *r12, double const *q1,
                          double const *q2, double *mu2, double *lambda)
{
    Rows const rows{n, r12, q1, q2};
    if (rows.are_wrong(num_pairs) || any_null(mu2)) return num_pairs > 0 ? null_pointer() : 0;
    FirstStatus first;
    for (Size k = 0; k < num_pairs; ++k) {
        double out[2];
        first.take(static_cast<Status>(
            pw85_nd_contact(n, rows.r12_of(k), rows.q1_of(k), rows.q2_of(k), out)));
        mu2[k] = out[0];
        if (lambda != nullptr) lambda[k] = out[1];
    }
    return first.value();
}

int pw85_nd_contact_geometry_batch(size_t num_pairs, int n, double const *r12, double const *q1,
                                   double const *q2, double const *lambda, double *point,
                                   double *normal, double *d_r12, double *d_q1, double *d_q2)
{
    Rows const rows{n, r12, q1, q2};
    if (rows.are_wrong(num_pairs) || any_null(lambda)) return num_pairs > 0 ? null_pointer() : 0;
    FirstStatus first;
    for (Size k = 0; k < num_pairs; ++k)
        first.take(geometry_of(n, rows.r12_of(k), rows.q1_of(k), rows.q2_of(k), lambda[k],
                               {row(point, n, k), row(normal, n, k), row(d_r12, n, k),
                                row(d_q1, packed_size(n), k), row(d_q2, packed_size(n), k)}));
    return first.value();
}

int pw85_nd_overlap_batch(size_t num_pairs, int n, double const *r12, double const *q1,
                          double const *q2, unsigned char *overlap)
{
    Rows const rows{n, r12, q1, q2};
    if (rows.are_wrong(num_pairs) || any_null(overlap)) return num_pairs > 0 ? null_pointer() : 0;
    FirstStatus first;
    for (Size k = 0; k < num_pairs; ++k) {
        int answer;
        first.take(static_cast<Status>(
            pw85_nd_overlap(n, rows.r12_of(k), rows.q1_of(k), rows.q2_of(k), &answer)));
        overlap[k] = static_cast<unsigned char>(answer);
    }
    return first.value();
}
