// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The tight box around an ellipsoid, with sides along the axes. The batch kernels and the
/// neighbour lists call bounding_box(), which calls validate().
#ifndef PW85_DISTANCE_BOUNDING_BOX_HPP_INCLUDED
#define PW85_DISTANCE_BOUNDING_BOX_HPP_INCLUDED

#include <pw85/algebra/all_nan.hpp>
#include <pw85/contact/scaling.hpp>

namespace pw85 {

/// The half-widths of the box: along each axis the ellipsoid reaches this far from its centre, in
/// both directions. They are NaN if the status is not success.
template <class T, int D> struct BoundingBox {
    Vector<T, D> half_widths;
    StatusCode status;
};

// The half-width along axis i is the support of the ellipsoid in this direction, √Q_ii.
template <class T, int D>
PW85_FUNCTION inline BoundingBox<T, D> bounding_box(SymmetricMatrix<T, D> const &q) noexcept
{
    StatusCode const status = detail::validate(q);
    if (status != StatusCode::success) return detail::all_nan<BoundingBox<T, D>>(status);
    BoundingBox<T, D> box{{}, StatusCode::success};
    for (int i = 0; i < D; ++i) box.half_widths[i] = detail::square_root(q(i, i));
    return box;
}

} // namespace pw85

#endif
