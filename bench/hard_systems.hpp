// SPDX-License-Identifier: BSD-3-Clause
// Systems of equal hard ellipsoids for the measurements of Monte Carlo. monte_carlo.cpp and
// public_monte_carlo.cpp use it.
#ifndef PW85_BENCH_HARD_SYSTEMS_HPP_INCLUDED
#define PW85_BENCH_HARD_SYSTEMS_HPP_INCLUDED

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <random>
#include <vector>

#include <pw85/simulation.hpp>

namespace pw85_bench {

using Vector3 = pw85::Vector<double, 3>;
using Quaternion = pw85::Vector<double, 4>;

inline void require(bool condition, char const *what)
{
    if (condition) return;
    std::fprintf(stderr, "%s\n", what);
    std::exit(1);
}

/// Equal ellipsoids in an upright cell; with two dimensions, ellipses in the plane.
struct System {
    int dimensions;
    Vector3 semi_axes;
    std::vector<Vector3> centers;
    std::vector<Quaternion> quaternions;
    Vector3 sides;

    pw85::HardEllipsoids simulate(pw85::TrialSteps const &steps) const
    {
        pw85::Cell const cell{{{sides[0], 0.0, 0.0}, {0.0, sides[1], 0.0}, {0.0, 0.0, sides[2]}}};
        std::vector<Vector3> const all(centers.size(), semi_axes);
        pw85::HardEllipsoids simulation;
        pw85::IndexPair pair;
        pw85::Particles const particles{centers, {}, &cell, {1, 1, dimensions == 3}};
        require(hard_ellipsoids_create(particles, all, quaternions, 1, simulation, pair) ==
                    pw85::Status::success,
                "no simulation");
        require(simulation.set_dimensions(dimensions) == pw85::Status::success, "no dimensions");
        require(simulation.set_steps(steps) == pw85::Status::success, "no steps");
        return simulation;
    }

    /// Takes over the state of a simulation of this system.
    void take(pw85::HardEllipsoids const &simulation)
    {
        pw85_system const now = simulation.system();
        std::copy_n(reinterpret_cast<Vector3 const *>(now.centers), centers.size(),
                    centers.begin());
        std::copy_n(simulation.quaternions().data(), quaternions.size(), quaternions.begin());
        for (int d = 0; d < 3; ++d) sides[d] = now.cell[4 * d];
    }

    /// Repeats the system along each axis.
    System repeated(int x, int y, int z) const
    {
        System whole{dimensions, semi_axes, {}, {}, {x * sides[0], y * sides[1], z * sides[2]}};
        for (int k = 0; k < x * y * z; ++k) {
            Vector3 const shift = {k % x * sides[0], k / x % y * sides[1], k / x / y * sides[2]};
            for (Vector3 const &center : centers) whole.centers.push_back(center + shift);
            whole.quaternions.insert(whole.quaternions.end(), quaternions.begin(),
                                     quaternions.end());
        }
        return whole;
    }

    /// Numbers the particles in random order.
    void shuffle()
    {
        std::vector<std::size_t> order(centers.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::shuffle(order.begin(), order.end(), std::mt19937_64(1));
        System const before = *this;
        for (std::size_t i = 0; i < order.size(); ++i) {
            centers[i] = before.centers[order[i]];
            quaternions[i] = before.quaternions[order[i]];
        }
    }
};

/// Parallel ellipsoids on a lattice with some distances along the axes.
inline System lattice(int dimensions, Vector3 const &semi_axes, int const (&numbers)[3],
                      Vector3 const &distances)
{
    System system{dimensions, semi_axes, {}, {}, {}};
    for (int k = 0; k < numbers[0] * numbers[1] * numbers[2]; ++k) {
        int const place[3] = {k % numbers[0], k / numbers[0] % numbers[1],
                              k / numbers[0] / numbers[1]};
        Vector3 center;
        for (int d = 0; d < 3; ++d) center[d] = distances[d] * place[d];
        system.centers.push_back(center);
        system.quaternions.push_back({1.0, 0.0, 0.0, 0.0});
    }
    for (int d = 0; d < 3; ++d) system.sides[d] = distances[d] * numbers[d];
    return system;
}

} // namespace pw85_bench

#endif
