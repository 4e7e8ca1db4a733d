/// @file
/// The support of an ellipsoid: how far it reaches in some direction, and where.
#ifndef PW85_DISTANCE_SUPPORT_HPP_INCLUDED
#define PW85_DISTANCE_SUPPORT_HPP_INCLUDED

#include <pw85/contact/evaluation.hpp>

namespace pw85::detail {

/// The point of an ellipsoid that is farthest along n, Qn/α, and α.
template <class T, int D> struct Support {
    Vector<T, D> point;
    T extent;
};

template <class T, int D>
PW85_FUNCTION inline Support<T, D> support(SymmetricMatrix<T, D> const &q, Vector<T, D> const &n) noexcept
{
    Vector<T, D> const point = product(q, n);
    T const extent = square_root(positive_form(q, n, point));
    return {T(T(1) / extent) * point, extent};
}

/// support() of a valid form of any size: in a unit of its own none of its products underflows to zero.
template <class T, int D>
PW85_FUNCTION inline Support<T, D> support_of_any(SymmetricMatrix<T, D> const &q, Vector<T, D> const &n) noexcept
{
    int const unit = half_exponent(largest_diagonal(q));
    Support<T, D> const s = support(times_power_of_two(q, -2 * unit), n);
    return {times_power_of_two(s.point, unit), times_power_of_two(s.extent, unit)};
}

} // namespace pw85::detail

#endif
