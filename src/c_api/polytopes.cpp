// SPDX-License-Identifier: BSD-3-Clause
// The functions of many rows that are not those of one row, row by row: many ellipsoids and one
// polytope.
#include <pw85_batch.h>

#include <climits>

#include <pw85/shapes/overlap_polytope.hpp>

#include "../base/c_arrays.hpp"
#include "../rows/each_row.hpp"

using namespace pw85;
using namespace pw85::detail;
using namespace pw85::detail::kernels;

namespace {

/// The half-spaces of a polytope, in arrays of the caller.
struct Planes {
    std::size_t count;
    double const *normals, *offsets;

    bool can_be_read() const noexcept
    {
        return count == 0 || (count <= PTRDIFF_MAX / (PW85_DIM * sizeof(double)) &&
                              !c_api::any_null(normals, offsets));
    }

    /// Records why the arrays cannot be read.
    int refuse(char const *function) const noexcept
    {
        return refuse_arrays(function, "num_planes", count, NamedArray{"normals", normals},
                             NamedArray{"offsets", offsets});
    }

    /// Records why an ellipsoid or the planes are refused.
    int checked_row(int status, char const *function, double const *center,
                    double const *q) const noexcept
    {
        return checked(status, [&](int bad) {
            std::size_t const n = minimum<std::size_t>(count, INT_MAX / 3);
            return refuse_call(
                bad, function, Argument("center", center, 3), Argument("q", q, 6, limit::definite),
                Argument("normals", n > 0 ? normals : q, 3 * n, limit::rows_not_zero),
                Argument("offsets", n > 0 ? offsets : q, n));
        });
    }
};

/// Computes the contact function of one ellipsoid and a polytope. The function is not inlined, so
/// that the compiler cannot move its arithmetic out of the default floating-point environment.
[[gnu::noinline]] int contact_planes(Planes const &planes, double const *center, double const *q,
                                     double *mu2, double *point) noexcept
{
    auto const c = contact_polytope(planes.count, planes.normals, planes.offsets,
                                    c_api::load_matrix<3>(q), c_api::load_vector<3>(center));
    if (mu2 != nullptr) *mu2 = c.mu2;
    c_api::store(c.point, point);
    return planes.checked_row(static_cast<int>(c.status), "pw85_contact_polytope", center, q);
}

/// Returns whether one ellipsoid overlaps a polytope, as one byte.
[[gnu::noinline]] int overlap_planes(Planes const &planes, double const *center, double const *q,
                                     unsigned char *overlap) noexcept
{
    auto const answer = overlap_polytope(planes.count, planes.normals, planes.offsets,
                                         c_api::load_matrix<3>(q), c_api::load_vector<3>(center));
    *overlap = answer.status == Status::success ? answer.overlap : static_cast<unsigned char>(-1);
    return planes.checked_row(static_cast<int>(answer.status), "pw85_overlap_polytope", center, q);
}

} // namespace

int pw85_contact_polytope_batch(size_t num_ellipsoids, double const *centers, double const *q,
                                size_t num_planes, double const *normals, double const *offsets,
                                double *mu2, double *point)
{
    Planes const planes{num_planes, normals, offsets};
    if (!planes.can_be_read()) return planes.refuse("pw85_contact_polytope_batch");
    if (num_ellipsoids > max_rows)
        return refuse_arrays("pw85_contact_polytope_batch", "num_ellipsoids", num_ellipsoids);
    auto const contact = [&](auto... arguments) { return contact_planes(planes, arguments...); };
    static constexpr char const *names[] = {"pw85_contact_polytope_batch", "centers", "q", "mu2",
                                            "point"};
    return each_row(names, num_ellipsoids, contact, RowsOf<3>{centers}, RowsOf<6>{q},
                    OptionalRowsOf<1>{mu2}, OptionalRowsOf<3>{point});
}

int pw85_overlap_polytope_batch(size_t num_ellipsoids, double const *centers, double const *q,
                                size_t num_planes, double const *normals, double const *offsets,
                                unsigned char *overlap)
{
    Planes const planes{num_planes, normals, offsets};
    if (!planes.can_be_read()) return planes.refuse("pw85_overlap_polytope_batch");
    if (num_ellipsoids > max_rows)
        return refuse_arrays("pw85_overlap_polytope_batch", "num_ellipsoids", num_ellipsoids);
    auto const decide = [&](auto... arguments) { return overlap_planes(planes, arguments...); };
    static constexpr char const *names[] = {"pw85_overlap_polytope_batch", "centers", "q",
                                            "overlap"};
    return each_row(names, num_ellipsoids, decide, RowsOf<3>{centers}, RowsOf<6>{q},
                    RowsOf<1, unsigned char>{overlap});
}
