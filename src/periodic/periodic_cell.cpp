// SPDX-License-Identifier: BSD-3-Clause
// Replaces the vectors of a cell that are not periodic by others with which lattice.hpp can reduce
// it. periodic_cell.hpp lists the callers.
#include "periodic_cell.hpp"

#include <pw85/algebra/vector.hpp>

namespace pw85::detail::kernels {

namespace {

double largest_entry(Vector<double, 3> const &v) noexcept
{
    return maximum(maximum(elementary::abs(v[0]), elementary::abs(v[1])), elementary::abs(v[2]));
}

/// Returns a vector along x × y of the given length; zero if x and y are parallel.
Vector<double, 3> normal(Vector<double, 3> const &x, Vector<double, 3> const &y,
                         double length) noexcept
{
    Vector<double, 3> const product =
        cross(1.0 / largest_entry(x) * x, 1.0 / largest_entry(y) * y); // entries are at most 2
    double const largest = largest_entry(product);
    if (!(largest > 0.0)) return {0.0, 0.0, 0.0};
    Vector<double, 3> const direction = 1.0 / largest * product;
    return length / elementary::sqrt(dot(direction, direction)) * direction;
}

/// Returns the axis that makes the greatest angle with a vector.
Vector<double, 3> axis_across(Vector<double, 3> const &v) noexcept
{
    Vector<double, 3> axis = {0.0, 0.0, 0.0};
    int least = 0;
    for (int d = 1; d < 3; ++d)
        if (elementary::abs(v[d]) < elementary::abs(v[least])) least = d;
    axis[least] = 1.0;
    return axis;
}

/// Replaces the vectors that are not periodic.
void complete(Vector<double, 3> (&rows)[3], int const *periodic) noexcept
{
    for (int k = 0; k < 3; ++k) {
        int const next = (k + 1) % 3, last = (k + 2) % 3;
        if (periodic[k] && !periodic[next] && !periodic[last]) {
            rows[next] = normal(rows[k], axis_across(rows[k]), largest_entry(rows[k]));
            rows[last] = normal(rows[k], rows[next], largest_entry(rows[k]));
        } else if (!periodic[k] && periodic[next] && periodic[last]) {
            rows[k] = normal(rows[next], rows[last],
                             maximum(largest_entry(rows[next]), largest_entry(rows[last])));
        }
    }
}

/// Copies the periodic vectors of a cell, and sets the others to zero. It returns false if no
/// vector is periodic, or if a periodic one is not finite.
bool select_periodic(double const *cell, int const *periodic, double (&vectors)[9]) noexcept
{
    bool finite = true;
    for (int k = 0; k < 9; ++k) {
        vectors[k] = periodic[k / 3] ? cell[k] : 0.0;
        finite = finite && elementary::isfinite(vectors[k]);
    }
    return finite && (periodic[0] || periodic[1] || periodic[2]);
}

/// Prepares the lattice of a completed cell.
bool prepare_completed(double const *completed, int const *periodic, Lattice &lattice) noexcept
{
    if (!prepare(completed, lattice)) return false;
    for (int k = 0; k < 3; ++k)
        for (int d = 0; d < 3 && !periodic[k]; ++d) lattice.basis[k][d] = lattice.dual[k][d] = 0.0;
    return true;
}

} // namespace

bool complete(double const *cell, int const *periodic, double (&completed)[9]) noexcept
{
    if (!select_periodic(cell, periodic, completed)) return false;
    if (periodic[0] && periodic[1] && periodic[2]) return true;
    Vector<double, 3> rows[3];
    for (int k = 0; k < 9; ++k) rows[k / 3][k % 3] = completed[k];
    complete(rows, periodic);
    for (int k = 0; k < 9; ++k) completed[k] = rows[k / 3][k % 3];
    return true;
}

bool prepare(double const *cell, int const *periodic, Lattice &lattice) noexcept
{
    double completed[9];
    return complete(cell, periodic, completed) && prepare_completed(completed, periodic, lattice);
}

bool prepare(double const *cell, int const *periodic, bool given, Images &images) noexcept
{
    images.nearest = cell != nullptr && !given;
    if (cell == nullptr) return !given;
    if (given) return select_periodic(cell, periodic, images.cell);
    return complete(cell, periodic, images.cell) &&
           prepare_completed(images.cell, periodic, images.lattice);
}

} // namespace pw85::detail::kernels
