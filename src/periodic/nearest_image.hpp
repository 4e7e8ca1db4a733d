// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Finds the nearest image of a separation in a lattice that lattice.hpp has prepared. rows.hpp
/// calls it for each pair of a list; image_finder.hpp and the neighbour lists call it as well.
#ifndef PW85_PERIODIC_NEAREST_IMAGE_HPP_INCLUDED
#define PW85_PERIODIC_NEAREST_IMAGE_HPP_INCLUDED

#include <pw85/algebra/symmetric.hpp>

#include "lattice.hpp"

namespace pw85::detail {

/// The nearest integer to x, for |x| < 2^51. The function uses no rounding instruction, which old
/// processors lack.
template <class T> PW85_FUNCTION inline T nearest_integer(T const &x) noexcept
{
    T const shift = T(0x1.8p52);
    return (x + shift) - shift;
}

/// The largest multiple of a basis vector that is subtracted from a separation. Within this limit
/// the multiples of a valid pair are rounded to an eighth of the vector. Then nearest_integer() is
/// still correct, although the sum of the products has an error.
inline constexpr double most_multiples_of_basis = 0x1p50;

/// The nearest image of a separation (list_shifts() of lattice.cpp has the proof). The first
/// coordinate is NaN if the separation is too large to find the nearest image.
template <class T> PW85_FUNCTION inline Vector<T, 3> nearest_image(kernels::Lattice const &lattice,
                                                                   Vector<T, 3> const &r) noexcept
{
    Vector<T, 3> x = r;
    T most = T(0);
    for (int i = 0; i < 3; ++i) {
        double const *dual = lattice.dual[i], *basis = lattice.basis[i];
        T const n = nearest_integer(T(T(dual[0]) * r[0] + T(dual[1]) * r[1] + T(dual[2]) * r[2]));
        for (int d = 0; d < 3; ++d) x[d] = x[d] - n * T(basis[d]);
        most = maximum(most, absolute(n));
    }
    T best = T(0), move[3] = {T(0), T(0), T(0)};
    for (int k = 0; k < lattice.num_shifts; ++k) {
        double const v[3] = {lattice.shift[0][k], lattice.shift[1][k], lattice.shift[2][k]};
        T const projection = x[0] * T(v[0]) + x[1] * T(v[1]) + x[2] * T(v[2]);
        T const gain = absolute(projection) - T(lattice.half_square[k]);
        auto const better = gain > best;
        T const sign = select(projection < T(0), T(-1), T(1));
        best = select(better, gain, best);
        for (int d = 0; d < 3; ++d) move[d] = select(better, T(sign * T(v[d])), move[d]);
    }
    for (int d = 0; d < 3; ++d) x[d] = x[d] - move[d];
    x[0] = select(most > T(most_multiples_of_basis), quiet_nan<T>(), x[0]);
    return x;
}

} // namespace pw85::detail

#endif
