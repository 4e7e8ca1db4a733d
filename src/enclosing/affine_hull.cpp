// SPDX-License-Identifier: BSD-3-Clause
// The smallest ellipsoid around points in a hyperplane.
#include <new>

#include "../base/owner.hpp"
#include "affine_hull.hpp"

namespace pw85::detail::enclosing {

namespace {

/// Finds the longest of m rows of n numbers, and the square of its length.
std::size_t find_longest(int n, std::size_t m, double const *rows, double &square) noexcept
{
    std::size_t longest = 0;
    square = 0.0;
    for (std::size_t i = 0; i < m; ++i) {
        double sum = 0.0;
        for (int k = 0; k < n; ++k, ++rows) sum += *rows * *rows;
        if (sum > square) square = sum, longest = i;
    }
    return longest;
}

/// Subtracts the projections of m rows of n numbers onto a unit vector.
void subtract_from_rows(int n, std::size_t m, double const *vector, double *rows) noexcept
{
    for (std::size_t i = 0; i < m; ++i, rows += n) {
        double product = 0.0;
        for (int k = 0; k < n; ++k) product += vector[k] * rows[k];
        for (int k = 0; k < n; ++k) rows[k] -= product * vector[k];
    }
}

} // namespace

/// Finds a basis of the differences from the first point: each vector is the longest difference
/// that is left after projection onto the ones before, until all are short, or there are n - 1.
/// Returns whether there is memory.
bool AffineHullSearch::find_basis() noexcept
{
    auto const columns = static_cast<std::size_t>(cloud_.n);
    if (!rows_.resize(cloud_.m * columns)) return false;
    for (std::size_t i = 0; i < cloud_.m; ++i)
        for (int k = 0; k < cloud_.n; ++k)
            rows_[i * columns + static_cast<std::size_t>(k)] =
                cloud_.coordinate(i, k) - cloud_.coordinate(0, k);
    for (; basis_.size < cloud_.n - 1; ++basis_.size) {
        double square = 0.0;
        std::size_t const longest = find_longest(cloud_.n, cloud_.m, rows_.data(), square);
        if (square <= 0x1p-48) break;
        double *const next = basis_.vectors[basis_.size];
        // NOLINTNEXTLINE(clang-analyzer-core.uninitialized.Assign): all rows are written above
        for (std::size_t k = 0; k < columns; ++k) next[k] = rows_[longest * columns + k];
        subtract_projection(basis_, next);
        normalize(cloud_.n, next);
        subtract_from_rows(cloud_.n, cloud_.m, next, rows_.data());
    }
    return true;
}

/// Computes the coordinates of the points along the basis, relative to the first point.
void AffineHullSearch::find_coordinates() noexcept
{
    std::size_t end = 0;
    for (std::size_t i = 0; i < cloud_.m; ++i)
        for (int j = 0; j < basis_.size; ++j) {
            double sum = 0.0;
            for (int k = 0; k < cloud_.n; ++k)
                sum += basis_.vectors[j][k] * (cloud_.coordinate(i, k) - cloud_.coordinate(0, k));
            rows_[end++] = sum;
        }
}

/// Computes the centre Bᵀc and the form BᵀQB from those along the basis, whose rows are B.
void AffineHullSearch::lift(Search const &search) noexcept
{
    for (int i = 0; i < cloud_.n; ++i) {
        for (int j = 0; j <= i; ++j)
            for (int a = 0; a < basis_.size; ++a)
                for (int b = 0; b < basis_.size; ++b)
                    form_[at(i, j)] += basis_.vectors[a][i] * basis_.vectors[b][j] *
                                       search.form(a < b ? a : b, a < b ? b : a);
        for (int a = 0; a < basis_.size; ++a) center_[i] += basis_.vectors[a][i] * search.center(a);
    }
    excess_ = search.excess();
}

Status AffineHullSearch::run(double tolerance) noexcept
{
    if (choose_scale(cloud_) == Status::invalid_argument) return Status::invalid_argument;
    if (!find_basis()) return Status::out_of_memory;
    for (; basis_.size > 0; --basis_.size) {
        Status const status = search_along_basis(tolerance);
        if (status != Status::not_positive_definite) return status;
    }
    return Status::success; // one point
}

/// Finds the smallest ellipsoid around the coordinates.
Status AffineHullSearch::search_along_basis(double tolerance) noexcept
{
    find_coordinates();
    Owner<Search> const search(new (std::nothrow) Search(basis_.size, cloud_.m, rows_.data()));
    if (search == nullptr) return Status::out_of_memory;
    Status const status = search->run(tolerance);
    if (status == Status::success || status == Status::no_convergence) lift(*search);
    return status;
}

double AffineHullSearch::center(int i) const noexcept
{
    double const first = cloud_.points[i];
    return cloud_.scale[i] == 0.0 ? first
                                  : cloud_.units[i].to_caller(first * cloud_.scale[i] + center_[i]);
}

double AffineHullSearch::form(int i, int j) const noexcept
{
    return (cloud_.units[i] * cloud_.units[j]).to_caller(form_[at(j, i)]);
}

} // namespace pw85::detail::enclosing
