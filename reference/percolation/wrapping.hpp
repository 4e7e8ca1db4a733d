// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Random, overlapping spheroids in a periodic cube, and how many of them it takes until a cluster
/// wraps around the cube.
#ifndef PW85_REFERENCE_WRAPPING_HPP_INCLUDED
#define PW85_REFERENCE_WRAPPING_HPP_INCLUDED

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include <pw85/pw85.hpp>
#include <pw85/systems.hpp>

#include "periodic_clusters.hpp"

namespace pw85_reference {

/// What a realisation is made of.
struct Spheroids {
    double aspect; ///< the semi-axes are 1, 1 and `aspect`
    double side;   ///< edge of the cube
};

/// The random numbers of one realisation. The C++ standard defines the generator and its seeding,
/// so all compilers give the same numbers.
class Draws {
  public:
    Draws(Spheroids const &spheroids, std::uint64_t seed, std::uint64_t realization)
    {
        std::vector<std::uint32_t> words;
        for (std::uint64_t const word :
             {seed, realization, std::bit_cast<std::uint64_t>(spheroids.aspect),
              std::bit_cast<std::uint64_t>(spheroids.side)}) {
            words.push_back(static_cast<std::uint32_t>(word));
            words.push_back(static_cast<std::uint32_t>(word >> 32));
        }
        std::seed_seq sequence(words.begin(), words.end());
        generator_.seed(sequence);
    }

    /// A point between 0 and `side` along each edge.
    pw85::Vector<double, 3> in_cube(double side)
    {
        double const x = uniform(), y = uniform(), z = uniform();
        return {side * x, side * y, side * z};
    }

    /// A vector of any length up to 1, whose direction is uniformly distributed.
    pw85::Vector<double, 3> direction()
    {
        pw85::Vector<double, 3> x;
        do x = in_cube(2.0) - pw85::Vector<double, 3>{1.0, 1.0, 1.0};
        while (dot(x, x) > 1.0 || dot(x, x) == 0.0);
        return x;
    }

  private:
    /// A multiple of 2⁻⁵³ from 0 up to but not including 1.
    double uniform() { return static_cast<double>(generator_() >> 11) * 0x1p-53; }

    std::mt19937_64 generator_;
};

/// For each edge of the cube the number of particles with which a cluster first wraps around it; 0
/// if none does.
using WrappingNumbers = std::array<std::size_t, 3>;

/// Spheroids at independent, uniformly distributed positions with uniformly distributed
/// orientations. They may overlap.
class Realization {
  public:
    Realization(Spheroids const &spheroids, std::uint64_t seed, std::uint64_t realization)
        : spheroids_(spheroids), draws_(spheroids, seed, realization)
    {
        for (std::size_t d = 0; d < 3; ++d) cell_[d][static_cast<int>(d)] = spheroids.side;
    }

    /// Adds spheroids until there are num_particles. The first ones do not depend on how many
    /// follow.
    void grow(std::size_t num_particles)
    {
        while (centers_.size() < num_particles) {
            centers_.push_back(draws_.in_cube(spheroids_.side));
            q_.push_back(pw85::spheroid(1.0, spheroids_.aspect, draws_.direction()).q);
        }
    }

    pw85::Particles particles() const { return {centers_, q_, &cell_}; }

  private:
    Spheroids spheroids_;
    Draws draws_;
    pw85::Cell cell_{};
    std::vector<pw85::Vector<double, 3>> centers_;
    std::vector<pw85::SymmetricMatrix<double, 3>> q_;
};

/// The pairs of a list that overlap, sorted by the later particle of the pair: those of particle n
/// are the entries from first[n] up to but not including first[n + 1] of `pairs`, which are indices
/// in the list.
struct SortedOverlaps {
    std::vector<std::size_t> first, pairs;

    SortedOverlaps(std::size_t num_particles, std::span<pw85::IndexPair const> list,
                   std::vector<unsigned char> const &overlap)
        : first(num_particles + 2)
    {
        auto const later = [=](std::size_t k) {
            return static_cast<std::size_t>(std::max(list[k][0], list[k][1]));
        };
        for (std::size_t k = 0; k < list.size(); ++k) first[later(k) + 2] += overlap[k];
        for (std::size_t n = 0; n < num_particles; ++n) first[n + 2] += first[n + 1];
        pairs.resize(first.back());
        for (std::size_t k = 0; k < list.size(); ++k)
            if (overlap[k] == 1) pairs[first[later(k) + 1]++] = k;
    }
};

/// Inserts particles one after the other, and joins each with those before it that it overlaps.
///
/// @param[out] numbers those of all particles
/// @return the status of the neighbour list or of the overlap tests
inline pw85::Status insert(pw85::Particles const &particles, WrappingNumbers &numbers)
{
    numbers = {};
    std::size_t const num_particles = particles.centers.size();
    pw85::Neighbors neighbors;
    auto status = neighbors_create(particles, {}, neighbors);
    if (status != pw85::Status::success) return status;
    auto const list = neighbors.list();
    std::vector<unsigned char> overlap(list.pairs.size());
    status = overlap_pairs(list, particles, overlap);
    if (status != pw85::Status::success) return status;

    SortedOverlaps const sorted(num_particles, list.pairs, overlap);
    PeriodicClusters clusters(num_particles);
    for (std::size_t n = 0; n < num_particles && std::ranges::find(numbers, 0u) != numbers.end();
         ++n)
        for (std::size_t k = sorted.first[n]; k < sorted.first[n + 1]; ++k) {
            std::size_t const pair = sorted.pairs[k];
            auto const [i, j] = list.pairs[pair];
            auto const loop = clusters.join(static_cast<std::size_t>(i),
                                            static_cast<std::size_t>(j), list.images[pair]);
            for (std::size_t d = 0; d < 3; ++d)
                if (loop[d] != 0 && numbers[d] == 0) numbers[d] = n + 1;
        }
    return status;
}

/// Adds spheroids to a realisation until clusters wrap around all edges of the cube.
///
/// @param num_particles how many to begin with; the result does not depend on this number
/// @param[out] numbers none is 0
/// @return as for insert()
inline pw85::Status insert_until_wrapped(Realization realization, std::size_t num_particles,
                                         WrappingNumbers &numbers)
{
    for (;; num_particles += num_particles / 4 + 1) {
        realization.grow(num_particles);
        auto const status = insert(realization.particles(), numbers);
        if (status != pw85::Status::success || std::ranges::find(numbers, 0u) == numbers.end())
            return status;
    }
}

} // namespace pw85_reference

#endif
