// SPDX-License-Identifier: BSD-3-Clause
// The signed distance in a wider type, from a normal that is nearly the best one.
#ifndef PW85_TESTS_STATIONARY_WIDTH_HPP_INCLUDED
#define PW85_TESTS_STATIONARY_WIDTH_HPP_INCLUDED

#include <pw85/distance/curvature.hpp>

#include "sample.hpp"
#include "wide.hpp"

namespace pw85_tests {

/// The width of the slab between the ellipsoids along n, times |n|.
template <class T> T width_along(Sample<T, 3> const &p, pw85::Vector<T, 3> const &n)
{
    return pw85::dot(n, p.r12) - pw85::detail::support(p.q1, n).extent -
           pw85::detail::support(p.q2, n).extent;
}

/// A stationary width, the size of the last residual of its condition, which tells how exact the
/// normal is, and the unit normal.
struct StationaryWidth {
    Wide width, residual;
    pw85::Vector<Wide, 3> normal;
};

/// The stationary value of the width near n by Newton's method. The value errs by the square of the
/// residual.
inline StationaryWidth stationary_width(Sample<Wide, 3> const &p, pw85::Vector<Wide, 3> n)
{
    using namespace pw85::detail;
    Wide residual = 1;
    for (int i = 0; i < 30 && residual > Wide("1e-40"); ++i) {
        n = Wide(1 / square_root(dot(n, n))) * n;
        SurfaceElement<Wide, 3> const elements[2] = {surface_element(p.q1, Wide(1), n),
                                                     surface_element(p.q2, Wide(1), n)};
        auto const w = project(p.r12 - (elements[0].point + elements[1].point), n);
        n = n + solve(factorize(stiffness_across(elements, width_along(p, n), n), Wide(0)), w);
        residual = square_root(dot(w, w));
    }
    n = Wide(1 / square_root(dot(n, n))) * n;
    return {width_along(p, n), residual, n};
}

} // namespace pw85_tests

#endif
