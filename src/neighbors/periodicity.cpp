// Periodic images; roundings as in periodicity.hpp.
#include "periodicity.hpp"

#include <cmath>

#include "../kernels/lattice.hpp"
#include "../kernels/nearest_image.hpp"

namespace pw85::neighbors {

namespace {

double largest_entry(Vector<double, 3> const &v) noexcept
{
    return std::max({std::fabs(v[0]), std::fabs(v[1]), std::fabs(v[2])});
}

/// The product of two vectors over its length, times the given length; zero if they are parallel.
Vector<double, 3> normal(Vector<double, 3> const &x, Vector<double, 3> const &y, double length) noexcept
{
    Vector<double, 3> const product =
        cross(times(1.0 / largest_entry(x), x), times(1.0 / largest_entry(y), y)); // entries are at most 2
    double const largest = largest_entry(product);
    if (!(largest > 0.0)) return {0.0, 0.0, 0.0};
    Vector<double, 3> const direction = times(1.0 / largest, product);
    return times(length / std::sqrt(dot(direction, direction)), direction);
}

/// The axis that makes the greatest angle with a vector.
Vector<double, 3> axis_across(Vector<double, 3> const &v) noexcept
{
    Vector<double, 3> axis = {0.0, 0.0, 0.0};
    int least = 0;
    for (int d = 1; d < 3; ++d)
        if (std::fabs(v[d]) < std::fabs(v[least])) least = d;
    axis[least] = 1.0;
    return axis;
}

/// Puts vectors in the place of those that are not periodic: orthogonal to the others, and as long as the longest of them. So the
/// reduction leaves them alone.
void complete(Vector<double, 3> (&rows)[3], bool const (&periodic)[3]) noexcept
{
    for (int k = 0; k < 3; ++k) {
        int const next = (k + 1) % 3, last = (k + 2) % 3;
        if (periodic[k] && !periodic[next] && !periodic[last]) {
            rows[next] = normal(rows[k], axis_across(rows[k]), largest_entry(rows[k]));
            rows[last] = normal(rows[k], rows[next], largest_entry(rows[k]));
        } else if (!periodic[k] && periodic[next] && periodic[last]) {
            rows[k] = normal(rows[next], rows[last], std::max(largest_entry(rows[next]), largest_entry(rows[last])));
        }
    }
}

} // namespace

bool Periodicity::prepare(double const *cell, int const *periodic) noexcept
{
    Vector<double, 3> rows[3];
    for (int k = 0; k < 3; ++k) periodic_[k] = cell != nullptr && (periodic == nullptr || periodic[k] != 0);
    any_ = periodic_[0] || periodic_[1] || periodic_[2];
    if (!any_) return true;
    for (int k = 0; k < 3; ++k)
        for (int d = 0; d < 3; ++d) {
            rows[k][d] = cell[3 * k + d];
            if (periodic_[k] && !std::isfinite(rows[k][d])) return false;
        }
    complete(rows, periodic_);
    double completed[9], reduced[9], multiples[3][3];
    kernels::Lattice lattice;
    for (int k = 0; k < 9; ++k) completed[k] = rows[k / 3][k % 3];
    if (!kernels::reduce(completed, reduced, multiples) || !kernels::prepare(reduced, lattice)) return false;
    for (int k = 0; k < 3; ++k)
        for (int d = 0; d < 3 && periodic_[k]; ++d) {
            for (int l = 0; l < 3; ++l) {
                basis_[k][d] += multiples[k][l] * completed[3 * l + d];
                size_[k][d] += std::fabs(multiples[k][l] * completed[3 * l + d]);
            }
            dual_[k][d] = lattice.dual[k][d];
            multiples_[k][d] = multiples[k][d];
        }
    return true;
}

double Periodicity::multiples_in(Vector<double, 3> const &point, int k) const noexcept
{
    return nearest_integer(dual_[k][0] * point[0] + dual_[k][1] * point[1] + dual_[k][2] * point[2]);
}

bool Periodicity::reduce(Vector<double, 3> const &point, Move &move) const noexcept
{
    move = {};
    if (!any_) return true;
    for (int k = 0; k < 3; ++k) {
        double const n = multiples_in(point, k);
        if (!(std::fabs(n) <= most_multiples)) return false;
        move.reduced.n[k] = static_cast<std::int32_t>(n);
    }
    return set_own(move);
}

Vector<double, 3> Periodicity::wrapped(Vector<double, 3> const &point) const noexcept
{
    Vector<double, 3> wrapped = point;
    for (int k = 0; k < 3 && any_; ++k)
        for (int d = 0; d < 3; ++d) wrapped[d] -= multiples_in(point, k) * basis_[k][d];
    return wrapped;
}

Vector<double, 3> Periodicity::sum(Multiples const &multiples, double const (&vectors)[3][3]) const noexcept
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
        Multiples const magnitudes = {{std::abs(multiples.n[0]), std::abs(multiples.n[1]), std::abs(multiples.n[2])}};
        move = sum(multiples, basis_);
        size = sum(magnitudes, size_);
    }
    Box box;
    for (int d = 0; d < 3; ++d) {
        double const wrapped = center[d] - move[d];
        double const extent = half_widths[d] + margin * (std::fabs(center[d]) + size[d] + half_widths[d]);
        box.lower[d] = wrapped - extent;
        box.upper[d] = wrapped + extent;
    }
    return box;
}

Box Periodicity::moved(Box const &box, Multiples const &multiples) const noexcept
{
    Multiples const magnitudes = {{std::abs(multiples.n[0]), std::abs(multiples.n[1]), std::abs(multiples.n[2])}};
    Vector<double, 3> const move = sum(multiples, basis_), size = sum(magnitudes, size_);
    Box result;
    for (int d = 0; d < 3; ++d) {
        result.lower[d] = box.lower[d] + move[d] - margin * (size[d] + std::fabs(box.lower[d]));
        result.upper[d] = box.upper[d] + move[d] + margin * (size[d] + std::fabs(box.upper[d]));
    }
    return result;
}

// An image that meets the box is moved by no more than the box's width along each axis.
Vector<double, 3> Periodicity::reach(Box const &box) const noexcept
{
    Vector<double, 3> reach = {0.0, 0.0, 0.0};
    for (int k = 0; k < 3; ++k) {
        if (!periodic_[k]) continue;
        for (int d = 0; d < 3; ++d) reach[k] += std::fabs(dual_[k][d]) * (box.upper[d] - box.lower[d]);
        reach[k] = std::floor(1.0 + reach[k]); // one more than enough, for roundings
    }
    return reach;
}

bool Periodicity::set_own(Move &move) const noexcept
{
    for (int l = 0; l < 3; ++l) {
        double n = 0.0;
        for (int k = 0; k < 3; ++k) n += move.reduced.n[k] * multiples_[k][l];
        if (!(std::fabs(n) <= most_multiples)) return false;
        move.own.n[l] = static_cast<std::int32_t>(n);
    }
    return true;
}

} // namespace pw85::neighbors
