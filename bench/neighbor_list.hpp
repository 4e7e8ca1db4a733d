// SPDX-License-Identifier: BSD-3-Clause
// Makes a neighbour list like those of simulations: uniformly random centres, and all pairs closer
// than a cutoff. speed.cpp and gpu.cpp use it.
#ifndef PW85_BENCH_NEIGHBOR_LIST_HPP_INCLUDED
#define PW85_BENCH_NEIGHBOR_LIST_HPP_INCLUDED

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <random_pairs.hpp>

namespace pw85_bench {

/// Particles in a cube with periodic faces, and pairs (i, j), i < j, sorted by i.
struct NeighborSystem {
    double side;
    std::vector<pw85::Vector<double, 3>> centers;
    std::vector<pw85::SymmetricMatrix<double, 3>> q;
    std::vector<std::array<std::int32_t, 2>> pairs;

    std::array<double, 9> cell() const { return {side, 0, 0, 0, side, 0, 0, 0, side}; }

    /// Another cell of the same lattice, with skewed vectors.
    std::array<double, 9> skewed_cell() const
    {
        return {side, 0, 0, side, side, 0, -side, 2 * side, side};
    }
};

/// The particles in each cell of a grid of n×n×n cells.
inline std::vector<std::vector<std::int32_t>> bucket(NeighborSystem const &system, int n)
{
    std::vector<std::vector<std::int32_t>> buckets(static_cast<std::size_t>(n * n * n));
    for (std::size_t i = 0; i < system.centers.size(); ++i) {
        int index = 0;
        for (int d = 0; d < 3; ++d)
            index = index * n +
                    std::min(n - 1, static_cast<int>(system.centers[i][d] / system.side * n));
        buckets[static_cast<std::size_t>(index)].push_back(static_cast<std::int32_t>(i));
    }
    return buckets;
}

inline bool are_close(NeighborSystem const &system, std::int32_t i, std::int32_t j, double cutoff)
{
    double square = 0.0;
    for (int d = 0; d < 3; ++d) {
        double const x = system.centers[static_cast<std::size_t>(j)][d] -
                         system.centers[static_cast<std::size_t>(i)][d];
        double const nearest = x - system.side * std::round(x / system.side);
        square += nearest * nearest;
    }
    return square < cutoff * cutoff;
}

/// All pairs closer than `cutoff`.
inline void list_pairs(NeighborSystem &system, double cutoff)
{
    int const n = std::max(3, static_cast<int>(system.side / cutoff));
    auto const buckets = bucket(system, n);
    auto const at = [&](int x, int y, int z) -> std::vector<std::int32_t> const & {
        return buckets[static_cast<std::size_t>((((x + n) % n) * n + (y + n) % n) * n +
                                                (z + n) % n)];
    };
    for (int x = 0; x < n; ++x)
        for (int y = 0; y < n; ++y)
            for (int z = 0; z < n; ++z)
                for (int k = 0; k < 27; ++k)
                    for (std::int32_t const i : at(x, y, z))
                        for (std::int32_t const j :
                             at(x + k / 9 - 1, y + k / 3 % 3 - 1, z + k % 3 - 1))
                            if (i < j && are_close(system, i, j, cutoff))
                                system.pairs.push_back({i, j});
    std::sort(system.pairs.begin(), system.pairs.end());
}

/// Makes `num_particles` ellipsoids of the given aspect ratio with about 20 pairs each, of which
/// about half overlap. Sorted particles are numbered by their position, plane by plane and row by
/// row; otherwise the numbers are random.
inline NeighborSystem make_system(std::size_t num_particles, double aspect, bool sorted)
{
    pw85_tests::Random random(99);
    NeighborSystem system{std::cbrt(static_cast<double>(num_particles)), {}, {}, {}};
    for (std::size_t i = 0; i < num_particles; ++i) {
        pw85::Vector<double, 3> x;
        for (int d = 0; d < 3; ++d) x[d] = random.uniform(0.0, system.side);
        system.centers.push_back(x);
    }
    if (sorted)
        std::sort(system.centers.begin(), system.centers.end(), [](auto const &a, auto const &b) {
            auto const key = [](auto const &x) {
                return std::array{std::floor(x[0] / 2), std::floor(x[1] / 2), x[2]};
            };
            return key(a) < key(b);
        });
    // At density one there are 40 neighbours within the cutoff, that is 20 pairs per particle. With
    // a semi-axis of 0.8 cutoffs, about half of them overlap at moderate aspect ratios.
    double const cutoff = std::cbrt(40.0 * 3.0 / (4.0 * std::numbers::pi));
    for (std::size_t i = 0; i < num_particles; ++i)
        system.q.push_back(random.form(0.8 * cutoff, aspect));
    list_pairs(system, cutoff);
    return system;
}

} // namespace pw85_bench

#endif
