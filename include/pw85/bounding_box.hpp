/// @file
/// The tight box around an ellipsoid, with sides along the axes.
#ifndef PW85_BOUNDING_BOX_HPP_INCLUDED
#define PW85_BOUNDING_BOX_HPP_INCLUDED

#include <pw85/contact.hpp>

namespace pw85 {

/// Half-widths of the box: the ellipsoid reaches so far from its centre along each axis, both ways. NaN where the status is not
/// success.
template <class T, int D> struct BoundingBox {
    Vector<T, D> half_widths;
    Status status;
};

/// Status of one form.
template <class T, int D> PW85_FUNCTION inline Status validate(SymmetricMatrix<T, D> const &q) noexcept
{
    if (!is_finite(q)) return Status::invalid_argument;
    if (!has_positive_diagonal(q)) return Status::not_positive_definite;
    T const largest = largest_diagonal(q);
    if (is_in_range(largest, largest, largest) && is_clearly_definite(q)) return Status::success;
    bool const definite = is_positive_definite(times_power_of_two(q, -2 * half_exponent(largest)));
    return definite ? Status::success : Status::not_positive_definite;
}

// The support function of the ellipsoid in the direction of an axis is the root of a diagonal entry.
template <class T, int D> PW85_FUNCTION inline BoundingBox<T, D> bounding_box(SymmetricMatrix<T, D> const &q) noexcept
{
    BoundingBox<T, D> box{{}, validate(q)};
    for (int i = 0; i < D; ++i)
        box.half_widths[i] = box.status == Status::success ? square_root(q(i, i)) : quiet_nan<T>();
    return box;
}

} // namespace pw85

#endif
