// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The volume of an ellipsoid, (4/3)π √det Q, and the area of an ellipse, π √det Q.
#ifndef PW85_VOLUME_VOLUME_HPP_INCLUDED
#define PW85_VOLUME_VOLUME_HPP_INCLUDED

#include <pw85/algebra/all_nan.hpp>
#include <pw85/algebra/unit_ball.hpp>
#include <pw85/contact/scaling.hpp>

namespace pw85 {

/// The volume of an ellipsoid or of an intersection, in the third power of the unit of length. It
/// is NaN if the status is not success.
template <class T> struct Volume {
    T volume;
    StatusCode status;
};

/// The area of an ellipse or of an intersection, in the square of the unit of length. It is NaN if
/// the status is not success.
template <class T> struct Area {
    T area;
    StatusCode status;
};

} // namespace pw85

namespace pw85::detail {

/// The volume of an ellipsoid or the area of an ellipse whose form is valid, from pivots that are
/// computed with twice the digits.
///
/// With the unit roundoff w of these digits, rounding errors of the pivots act like changes of q_ij
/// by at most 8 w √(q_ii q_jj). These change √det Q by a fraction of at most 4 w (Σ √(q_ii P_ii))²
/// with P = Q⁻¹. By Kantorovich's inequality q_ii P_ii is at most κ/4 + 1 for the ratio κ of the
/// largest eigenvalue to the smallest one. So the fraction is below 9 w κ + 36 w. The error of the
/// expanded determinant would be proportional to κ² for needles.
template <class T, int D> PW85_RARE T measure_of(SymmetricMatrix<T, D> const &q) noexcept
{
    using Fine = Finer<T>;
    Unit const unit = unit_of(q);
    auto const factors = factorize(converted<Fine>(unit.to_local(q)), Fine(0));
    Fine det = factors.pivots[0];
    for (int i = 1; i < D; ++i) det = det * factors.pivots[i];
    Fine const pi = fine_circle_constant<T>();
    Fine const of_ball = D == 3 ? Fine(Fine(Fine(4) * pi) / Fine(3)) : pi;
    using pw85::detail::sqrt;
    return unit.to_caller(rounded(Fine(of_ball * square_root(det))), D);
}

PW85_RARE_TIER(measure_of)

} // namespace pw85::detail

namespace pw85 {

/// The volume of an ellipsoid.
template <class T> PW85_FUNCTION inline Volume<T> volume(SymmetricMatrix<T, 3> const &q) noexcept
{
    StatusCode const status = detail::validate(q);
    if (status != StatusCode::success) return detail::all_nan<Volume<T>>(status);
    return {detail::measure_of(q), status};
}

/// The area of an ellipse.
template <class T> PW85_FUNCTION inline Area<T> area(SymmetricMatrix<T, 2> const &q) noexcept
{
    StatusCode const status = detail::validate(q);
    if (status != StatusCode::success) return detail::all_nan<Area<T>>(status);
    return {detail::measure_of(q), status};
}

} // namespace pw85

#endif
