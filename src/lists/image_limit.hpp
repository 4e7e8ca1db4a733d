// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Decides whether only the nearest images in a lattice can overlap. pw85_nearest_image_limit()
/// (cell.cpp) and pw85_overlap_any_indices() (lists.cpp) use it.
///
/// An image that is not the nearest has r·v >= ½|v|² for a vector v to a face of the lattice's
/// Voronoi cell. The coordinates of v are -1, 0 or 1 (list_shifts() of lattice.cpp). μ is the
/// maximum over n of r·n divided by the sum of the two half-widths along n, √(nᵀQ1n) + √(nᵀQ2n). So
/// μ is at least ¼|v|²/√(vᵀQv), where Q is the wider of the two forms along v. (Other vectors v
/// give no smaller value, because v/|v|² is in the convex hull of those of the faces.)
#ifndef PW85_LISTS_IMAGE_LIMIT_HPP_INCLUDED
#define PW85_LISTS_IMAGE_LIMIT_HPP_INCLUDED

#include <cstddef>
#include <cstdint>

#include "../base/c_arrays.hpp"
#include "../simd/pairs.hpp"

namespace pw85::detail::kernels {
namespace {

/// Calls visit(v) for the vectors with coordinates -1, 0 or 1, but for only one of v and -v. It
/// leaves out vectors of length zero, which occur if fewer than three vectors are periodic.
template <class Visit> void for_face_vectors(Lattice const &lattice, Visit const &visit) noexcept
{
    for (int n = 1; n <= 13; ++n) {
        int const a = (n + 13) / 9 - 1, b = (n + 13) / 3 % 3 - 1, c = (n + 13) % 3 - 1;
        Vector<double, 3> v;
        for (int d = 0; d < 3; ++d)
            v[d] = a * lattice.basis[0][d] + b * lattice.basis[1][d] + c * lattice.basis[2][d];
        if (v[0] != 0.0 || v[1] != 0.0 || v[2] != 0.0) visit(v);
    }
}

/// Returns the largest vᵀQv/|v|⁴, for one form. The limit of μ² is 1/16 of its inverse.
inline double largest_relative_width(Lattice const &lattice,
                                     SymmetricMatrix<double, 3> const &q) noexcept
{
    double largest = 0.0;
    for_face_vectors(lattice, [&](auto const &v) {
        largest = maximum(largest, quadratic_form(q, 1.0 / dot(v, v) * v));
    });
    return largest;
}

/// The largest value of largest_relative_width() at which images that are not the nearest do not
/// overlap.
constexpr double relative_width_limit = 0.0625;

/// Returns whether the diagonal entries Q_dd alone show that all relative widths are within the
/// limit. `squares` are the largest of these entries. The first test uses vᵀQv <= |v|² ΣQ_dd, where
/// the basis has the shortest vectors. The second test uses vᵀQv <= (Σ|v_d|√Q_dd)².
inline bool have_narrow_boxes(Lattice const &lattice, double const (&squares)[3]) noexcept
{
    double shortest = infinity<double>();
    for (auto const &b : lattice.basis)
        if (double const square = b[0] * b[0] + b[1] * b[1] + b[2] * b[2]; square > 0.0)
            shortest = minimum(shortest, square);
    if (squares[0] + squares[1] + squares[2] <= relative_width_limit * shortest) return true;
    double const x = elementary::sqrt(squares[0]), y = elementary::sqrt(squares[1]),
                 z = elementary::sqrt(squares[2]);
    bool narrow = true;
    for_face_vectors(lattice, [&](auto const &v) {
        narrow = narrow && 4.0 * (elementary::abs(v[0]) * x + elementary::abs(v[1]) * y +
                                  elementary::abs(v[2]) * z) <=
                               dot(v, v);
    });
    return narrow;
}

/// Returns whether only the nearest images of the other ellipsoids can overlap the first one, and
/// no image of the first one can overlap it.
inline bool nearest_images_suffice(OneToIndexed const &rows, std::size_t n) noexcept
{
    double squares[3] = {rows.q1[0], rows.q1[3], rows.q1[5]};
    for (std::size_t k = 0; k < n; ++k) {
        double const *const q = row_of(rows.q, 6, static_cast<std::size_t>(rows.others[k]));
        squares[0] = maximum(squares[0], q[0]);
        squares[1] = maximum(squares[1], q[3]);
        squares[2] = maximum(squares[2], q[5]);
    }
    if (have_narrow_boxes(*rows.lattice, squares)) return true;
    bool narrow = largest_relative_width(*rows.lattice, c_api::load_matrix<3>(rows.q1)) <=
                  relative_width_limit;
    for (std::size_t k = 0; k < n && narrow; ++k) {
        double const *const q = row_of(rows.q, 6, static_cast<std::size_t>(rows.others[k]));
        narrow =
            largest_relative_width(*rows.lattice, c_api::load_matrix<3>(q)) <= relative_width_limit;
    }
    return narrow;
}

} // namespace
} // namespace pw85::detail::kernels

#endif
