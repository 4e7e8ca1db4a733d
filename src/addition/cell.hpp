// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The periodic cell of a random sequential addition.
#ifndef PW85_ADDITION_CELL_HPP_INCLUDED
#define PW85_ADDITION_CELL_HPP_INCLUDED

#include <pw85/algebra/vector.hpp>

namespace pw85::detail::sequential_addition {
namespace {

/// A cell by its D vectors. Places are coordinates in units of these vectors.
template <int D> class Cell {
  public:
    /// Takes the vectors from the rows of a matrix 3×3, divided by a unit of length.
    Cell(double const *rows, double unit) noexcept
    {
        for (int i = 0; i < D; ++i)
            for (int k = 0; k < D; ++k) vectors_[i][k] = rows[3 * i + k] / unit;
        for (int i = 0; i < D; ++i) edges_ += edge(i);
    }

    Vector<double, D> const &operator[](int i) const noexcept { return vectors_[i]; }

    Vector<double, D> point(Vector<double, D> const &place) const noexcept
    {
        Vector<double, D> x{};
        for (int i = 0; i < D; ++i) x = add_scaled(x, place[i], vectors_[i]);
        return x;
    }

    double edge(int i) const noexcept { return magnitude(vectors_[i]); }

    /// The sum of the lengths of the vectors.
    double edges() const noexcept { return edges_; }

    /// The distance between two opposite faces; NaN or 0 if the vectors are not independent.
    double height(int i) const noexcept
    {
        if constexpr (D == 2) {
            return absolute(cross(vectors_[0], vectors_[1])[0]) / edge(1 - i);
        } else {
            Vector<double, 3> const n = cross(vectors_[(i + 1) % 3], vectors_[(i + 2) % 3]);
            return absolute(dot(n, vectors_[i])) / magnitude(n);
        }
    }

  private:
    Vector<double, D> vectors_[std::size_t(D)];
    double edges_ = 0.0;
};

} // namespace
} // namespace pw85::detail::sequential_addition

#endif
