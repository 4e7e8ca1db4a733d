// SPDX-License-Identifier: BSD-3-Clause
// Systems of spheroids in a cubic periodic cell, for systems.cpp and growth.cpp.
#ifndef PW85_BENCH_SPHEROIDS_HPP_INCLUDED
#define PW85_BENCH_SPHEROIDS_HPP_INCLUDED

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <pw85/pw85.hpp>
#include <pw85/systems.hpp>

#include <random_pairs.hpp>

namespace pw85_bench {

/// Spheroids with semi-axes 1, 1 and `aspect` at random places.
struct System {
    std::vector<pw85::Vector<double, 3>> centers;
    std::vector<pw85::SymmetricMatrix<double, 3>> q;
    pw85::Cell cell{};

    System(std::size_t n, double aspect, double packing_fraction)
    {
        pw85_tests::Random random(131);
        double const volume = pw85::volume(pw85::spheroid(1.0, aspect, {0.0, 0.0, 1.0}).q).volume;
        double const side = std::cbrt(static_cast<double>(n) * volume / packing_fraction);
        for (std::size_t i = 0; i < n; ++i) {
            centers.push_back(
                {random.uniform(0.0, side), random.uniform(0.0, side), random.uniform(0.0, side)});
            q.push_back(pw85::spheroid(1.0, aspect, random.direction<3>()).q);
        }
        for (std::size_t d = 0; d < 3; ++d) cell[d][static_cast<int>(d)] = side;
    }

    pw85::Particles particles() const { return {centers, q, &cell}; }

    /// Numbers the particles along columns of the given width, so that neighbours are near in
    /// memory.
    void sort(double width)
    {
        auto const key = [=](pw85::Vector<double, 3> const &x) {
            return std::array{std::floor(x[0] / width), std::floor(x[1] / width), x[2]};
        };
        std::sort(centers.begin(), centers.end(),
                  [&](auto const &a, auto const &b) { return key(a) < key(b); });
    }
};

} // namespace pw85_bench

#endif
