// SPDX-License-Identifier: BSD-3-Clause
// Computes lattice vectors and moves boxes by them. The comment in periodicity.hpp derives the
// bounds on rounding errors.
#include "periodicity.hpp"

#include <cstdlib>

#include "../periodic/nearest_image.hpp"
#include "../periodic/periodic_cell.hpp"

namespace pw85::detail::neighbors {

namespace {

double largest_entry(Vector<double, 3> const &v) noexcept
{
    return maximum(maximum(elementary::abs(v[0]), elementary::abs(v[1])), elementary::abs(v[2]));
}

} // namespace

bool Periodicity::prepare(double const *cell, int const *periodic) noexcept
{
    any_ = cell != nullptr;
    if (!any_) return true;
    double completed[9], reduced[9], multiples[3][3];
    kernels::Lattice lattice;
    if (!kernels::complete(cell, periodic, completed) ||
        !kernels::reduce(completed, reduced, multiples) || !kernels::prepare(reduced, lattice))
        return false;
    for (int k = 0; k < 3; ++k) {
        periodic_[k] = periodic[k] != 0;
        for (int d = 0; d < 3 && periodic_[k]; ++d) {
            for (int l = 0; l < 3; ++l) {
                basis_[k][d] += multiples[k][l] * completed[3 * l + d];
                size_[k][d] += elementary::abs(multiples[k][l] * completed[3 * l + d]);
            }
            dual_[k][d] = lattice.dual[k][d];
            multiples_[k][d] = multiples[k][d];
        }
    }
    return true;
}

double Periodicity::shortest() const noexcept
{
    double least = infinity<double>();
    for (int k = 0; k < 3; ++k)
        if (periodic_[k])
            least = minimum(least, elementary::sqrt(basis_[k][0] * basis_[k][0] +
                                                    basis_[k][1] * basis_[k][1] +
                                                    basis_[k][2] * basis_[k][2]));
    return least;
}

double Periodicity::multiples_in(Vector<double, 3> const &point, int k) const noexcept
{
    return nearest_integer(dual_[k][0] * point[0] + dual_[k][1] * point[1] +
                           dual_[k][2] * point[2]);
}

bool Periodicity::reduce(Vector<double, 3> const &point, LatticeVector &vector) const noexcept
{
    vector = {};
    if (!any_) return true;
    for (int k = 0; k < 3; ++k) {
        double const n = multiples_in(point, k);
        if (!(elementary::abs(n) <= most_multiples)) return false;
        vector.of_reduced.n[k] = static_cast<std::int32_t>(n);
    }
    return set_multiples_of_cell(vector);
}

Vector<double, 3> Periodicity::wrapped(Vector<double, 3> const &point) const noexcept
{
    Vector<double, 3> wrapped = point;
    for (int k = 0; k < 3 && any_; ++k)
        for (int d = 0; d < 3; ++d) wrapped[d] -= multiples_in(point, k) * basis_[k][d];
    return wrapped;
}

Vector<double, 3> Periodicity::sum(Multiples const &multiples,
                                   double const (&vectors)[3][3]) const noexcept
{
    Vector<double, 3> total = {0.0, 0.0, 0.0};
    for (int k = 0; k < 3; ++k)
        for (int d = 0; d < 3; ++d) total[d] += multiples.n[k] * vectors[k][d];
    return total;
}

Box Periodicity::wrapped(Vector<double, 3> const &center, Vector<double, 3> const &half_widths,
                         Multiples const &multiples) const noexcept
{
    Vector<double, 3> move = {0.0, 0.0, 0.0}, size = {0.0, 0.0, 0.0};
    if (any_) {
        Multiples const magnitudes = {
            {std::abs(multiples.n[0]), std::abs(multiples.n[1]), std::abs(multiples.n[2])}};
        move = sum(multiples, basis_);
        size = sum(magnitudes, size_);
    }
    Box box;
    for (int d = 0; d < 3; ++d) {
        double const wrapped = center[d] - move[d];
        double const extent =
            half_widths[d] + margin * (elementary::abs(center[d]) + size[d] + half_widths[d]);
        box.lower[d] = wrapped - extent;
        box.upper[d] = wrapped + extent;
    }
    return box;
}

Box Periodicity::moved(Box const &box, Multiples const &multiples) const noexcept
{
    Multiples const magnitudes = {
        {std::abs(multiples.n[0]), std::abs(multiples.n[1]), std::abs(multiples.n[2])}};
    Vector<double, 3> const move = sum(multiples, basis_), size = sum(magnitudes, size_);
    Box result;
    for (int d = 0; d < 3; ++d) {
        result.lower[d] =
            box.lower[d] + move[d] - margin * (size[d] + elementary::abs(box.lower[d]));
        result.upper[d] =
            box.upper[d] + move[d] + margin * (size[d] + elementary::abs(box.upper[d]));
    }
    return result;
}

// An image that intersects the box is moved by at most the width of the box along each axis.
Vector<double, 3> Periodicity::reach(Box const &box) const noexcept
{
    Vector<double, 3> reach = {0.0, 0.0, 0.0};
    for (int k = 0; k < 3; ++k) {
        if (!periodic_[k]) continue;
        for (int d = 0; d < 3; ++d)
            reach[k] += elementary::abs(dual_[k][d]) * (box.upper[d] - box.lower[d]);
        // at most one more than the exact value, for rounding errors
        reach[k] = elementary::floor(1.0 + reach[k]);
    }
    return reach;
}

bool Periodicity::set_multiples_of_cell(LatticeVector &vector) const noexcept
{
    for (int l = 0; l < 3; ++l) {
        double n = 0.0;
        for (int k = 0; k < 3; ++k) n += vector.of_reduced.n[k] * multiples_[k][l];
        if (!(elementary::abs(n) <= most_multiples)) return false;
        vector.of_cell.n[l] = static_cast<std::int32_t>(n);
    }
    return true;
}

Vector<double, 3> Periodicity::dual_of_cell(int l) const noexcept
{
    Vector<double, 3> dual = {0.0, 0.0, 0.0};
    for (int k = 0; k < 3; ++k)
        for (int d = 0; d < 3; ++d) dual[d] += multiples_[k][l] * dual_[k][d];
    return dual;
}

// The factor of two covers the rounding errors of the reduced vectors. These vectors are far from
// linearly dependent.
double Periodicity::dual_of_cell_bound(int l) const noexcept
{
    double bound = 0.0;
    for (int k = 0; k < 3; ++k)
        bound += 2.0 * elementary::abs(multiples_[k][l]) *
                 largest_entry({dual_[k][0], dual_[k][1], dual_[k][2]});
    return bound;
}

} // namespace pw85::detail::neighbors
