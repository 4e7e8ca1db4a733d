// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The distance of closest approach of two ellipsoids with given orientations, along a given
/// direction. μ² is quadratic in the separation, so along a unit vector d the distance is 1/μ(d).
/// The solver (solver.hpp) computes μ².
#ifndef PW85_CONTACT_CLOSEST_APPROACH_HPP_INCLUDED
#define PW85_CONTACT_CLOSEST_APPROACH_HPP_INCLUDED

#include <pw85/contact/contact.hpp>

namespace pw85 {

/// The distance of the centres at external tangency. It is NaN if the status is not success.
template <class T> struct ClosestApproach {
    T distance;
    StatusCode status;
};

template <class T, int D>
PW85_FUNCTION inline ClosestApproach<T> closest_approach(Vector<T, D> direction,
                                                         SymmetricMatrix<T, D> const &q1,
                                                         SymmetricMatrix<T, D> const &q2) noexcept
{
    using namespace detail;
    T const largest = largest_coordinate(direction);
    if (!is_finite(direction) || !(largest > T(0)))
        return all_nan<ClosestApproach<T>>(StatusCode::invalid_argument);
    direction = direction / largest;
    auto const pair = pair_of(direction, q1, q2);
    ScaledPair<T, D> scaled{pair, {}};
    if (!passes_fast_checks(pair)) {
        StatusCode const status = validate_pair(pair, scaled);
        if (status != StatusCode::success) return all_nan<ClosestApproach<T>>(status);
    }
    Maximum<T> const maximum = maximize(scaled.pair);
    if (!maximum.converged || !(maximum.mu2 >= T(0)))
        return all_nan<ClosestApproach<T>>(StatusCode::no_convergence);
    T const norm = square_root(dot(direction, direction));
    return {scaled.units.mu().to_local(T(norm / square_root(maximum.mu2))), StatusCode::success};
}

} // namespace pw85

#endif
