// SPDX-License-Identifier: BSD-3-Clause
// Random pairs at a given signed distance, with the truth in 50 digits, for signed_distance.cpp and
// signed_distance_peers.
#ifndef PW85_BENCH_SIGNED_DISTANCE_CASES_HPP_INCLUDED
#define PW85_BENCH_SIGNED_DISTANCE_CASES_HPP_INCLUDED

#include <cmath>
#include <vector>

#include <pw85.h>

#include <random_pairs.hpp>
#include <stationary_width.hpp>

namespace pw85_bench {

using pw85_tests::Sample, pw85_tests::Wide;

/// A pair, its signed distance, and the unit normal out of ellipsoid 1, for the data as rounded.
struct Case {
    Sample<double, 3> pair;
    Wide distance;
    pw85::Vector<Wide, 3> normal;
};

/// The range of semi-axes, which are log-uniform in it.
struct Sizes {
    double smallest, largest;
};

/// Two random ellipsoids with a random common normal, along which they are `distance` apart.
inline Sample<double, 3> draw_pair(pw85_tests::Random &random, Sizes sizes, double distance)
{
    auto const form = [&] {
        auto const axis = [&] { return random.log_uniform(sizes.smallest, sizes.largest); };
        return pw85::ellipsoid_quaternion<double>({axis(), axis(), axis()}, random.direction<4>())
            .q;
    };
    Sample<double, 3> s{{}, form(), form()};
    auto const n = random.direction<3>();
    s.r12 =
        pw85::detail::support(s.q1, n).point + pw85::detail::support(s.q2, n).point + distance * n;
    return s;
}

/// Pairs at a signed distance, up to the rounding of their data. Pairs whose depth along the normal
/// of draw_pair() is not the least one are drawn again.
inline std::vector<Case> draw_cases(pw85_tests::Random &random, Sizes sizes, double distance,
                                    std::size_t count)
{
    std::vector<Case> cases;
    while (cases.size() < count) {
        auto const s = draw_pair(random, sizes, distance);
        pw85::Vector<double, 3> normal;
        if (pw85_signed_distance_derivatives(s.r12.coordinates, s.q1.entries, s.q2.entries,
                                             normal.coordinates, nullptr, nullptr,
                                             nullptr) != PW85_SUCCESS)
            continue;
        auto const found =
            stationary_width(pw85_tests::convert<Wide>(s), pw85_tests::convert<Wide>(normal));
        double const width = static_cast<double>(found.width);
        if (found.residual <= Wide("1e-20") && std::fabs(width - distance) <= 1e-6 * sizes.smallest)
            cases.push_back({s, found.width, found.normal});
    }
    return cases;
}

} // namespace pw85_bench

#endif
