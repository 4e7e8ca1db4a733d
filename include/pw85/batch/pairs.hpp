// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Functions of many pairs that differ from those of C: single precision, and one ellipsoid against
/// many. batch.hpp includes this file. It calls rows.hpp and the C API.
#ifndef PW85_BATCH_PAIRS_HPP_INCLUDED
#define PW85_BATCH_PAIRS_HPP_INCLUDED

#include <pw85/batch/rows.hpp>

namespace pw85 {

namespace detail {

/// Copies `count` rows from row `first` on, and converts them to double.
template <class Row, class Wide> static void widen(std::span<Row const> rows, std::size_t first,
                                                   std::size_t count, Wide *wide) noexcept
{
    for (std::size_t i = 0; i < count; ++i)
        for (int k = 0; k < static_cast<int>(sizeof(Row) / sizeof(float)); ++k)
            wide[i][k] = static_cast<double>(rows[first + i][k]);
}

} // namespace detail

/// @name Single precision, one against many
/// @{

/// contact() for pairs of single precision. The numbers are converted to double, the results are
/// computed in double, and rounded to float.
///
/// @param r12,q1,q2,mu2,lambda as for contact_batch() of double precision
/// @return as for contact_batch() of double precision
static inline StatusCode contact_batch(std::span<Vector<float, 3> const> r12,
                                       std::span<SymmetricMatrix<float, 3> const> q1,
                                       std::span<SymmetricMatrix<float, 3> const> q2,
                                       std::span<float> mu2, std::span<float> lambda = {}) noexcept
{
    constexpr std::size_t block = 16; // 2 KiB of stack
    std::size_t const n = mu2.size();
    if (r12.size() != n || q1.size() != n || q2.size() != n || !detail::fits(n, lambda))
        return StatusCode::invalid_argument;
    Vector<double, 3> r[block];
    SymmetricMatrix<double, 3> p[block], q[block];
    double wide_mu2[block], wide_lambda[block];
    StatusCode first_bad = StatusCode::success;
    for (std::size_t first = 0; first < n; first += block) {
        std::size_t const count = (std::min)(block, n - first);
        detail::widen(r12, first, count, r);
        detail::widen(q1, first, count, p);
        detail::widen(q2, first, count, q);
        StatusCode const status =
            contact_batch(Vectors(r, count), Forms(p, count), Forms(q, count),
                          std::span(wide_mu2, count), std::span(wide_lambda, count));
        if (first_bad == StatusCode::success) first_bad = status;
        for (std::size_t i = 0; i < count; ++i) {
            mu2[first + i] = static_cast<float>(wide_mu2[i]);
            if (!lambda.empty()) lambda[first + i] = static_cast<float>(wide_lambda[i]);
        }
    }
    return first_bad;
}

/// Returns whether an ellipsoid overlaps any of the others. The test ends at the first one that
/// overlaps or is bad: see pw85_overlap_any().
///
/// @param q1 form of the first ellipsoid
/// @param r12,q2 centres of the others relative to that of the first ellipsoid, and their forms
/// @param[out] any 1 or 0; -1 on error
/// @return Status::success, Status::invalid_argument, or the status of the first bad pair if no
/// pair before it overlaps
static inline StatusCode overlap_any(SymmetricMatrix<double, 3> const &q1, Vectors r12, Forms q2,
                                     int &any) noexcept
{
    any = -1;
    if (r12.size() != q2.size()) return StatusCode::invalid_argument;
    return static_cast<StatusCode>(
        pw85_overlap_any(q1.entries, r12.size(), detail::in_c(r12), detail::in_c(q2), &any));
}

/// @}

} // namespace pw85

#endif
