// SPDX-License-Identifier: BSD-3-Clause
// Distances of closest approach as the tests of the algorithms of Zheng and Palffy-Muhoray compare
// them.
#ifndef PW85_TESTS_ZHENG_DISTANCES_HPP_INCLUDED
#define PW85_TESTS_ZHENG_DISTANCES_HPP_INCLUDED

#include <pw85_zheng.h>

#include <pw85/history/zheng.hpp>

#include "../failures.hpp"
#include "../random_pairs.hpp"
#include "../wide.hpp"

namespace pw85_tests {

constexpr double u = 0x1p-53;

inline int zheng(Sample<double, 2> const &p, double &distance)
{
    return pw85_zheng_ellipses(p.r12.coordinates, p.q1.entries, p.q2.entries, &distance);
}

inline int zheng(Sample<double, 3> const &p, double &distance)
{
    return pw85_zheng_ellipsoids(p.r12.coordinates, p.q1.entries, p.q2.entries, &distance);
}

inline int closest_approach(Sample<double, 2> const &p, double &distance)
{
    return pw85_closest_approach_2d(p.r12.coordinates, p.q1.entries, p.q2.entries, &distance);
}

inline int closest_approach(Sample<double, 3> const &p, double &distance)
{
    return pw85_closest_approach(p.r12.coordinates, p.q1.entries, p.q2.entries, &distance);
}

/// The distance through the contact function, with 50 digits.
template <int D> Wide true_distance(Sample<Wide, D> const &p)
{
    return pw85::closest_approach(p.r12, p.q1, p.q2).distance;
}

/// |actual - expected|/expected.
template <class T> double relative_error(T const &actual, Wide const &expected)
{
    return static_cast<double>(Wide(abs(Wide(Wide(actual) - expected)) / expected));
}

/// tr Q · tr Q⁻¹, which is between the square of the aspect ratio and nine times that.
template <int D> double condition_of_form(pw85::SymmetricMatrix<double, D> const &q)
{
    auto const w = convert<Wide>(q);
    auto const adjugate = pw85::detail::adjugate(w);
    Wide trace = 0, trace_of_adjugate = 0;
    for (int i = 0; i < D; ++i) {
        trace += w(i, i);
        trace_of_adjugate += adjugate(i, i);
    }
    return static_cast<double>(
        Wide(trace * trace_of_adjugate / pw85::detail::determinant(w, adjugate)));
}

} // namespace pw85_tests

#endif
