// SPDX-License-Identifier: BSD-3-Clause
// Clusters in a periodic cell and the insertion of spheroids, against a search through the images
// of all particles.
#include <algorithm>
#include <set>
#include <string>

#include <glib.h>

#include "draws.hpp"
#include "failures.hpp"
#include "wrapping.hpp"

using namespace pw85_reference;
using namespace pw85_tests;

namespace {

struct Bond {
    std::size_t i, j;
    pw85::Image image;
};

/// Along which edges of the cell the first particles are connected with other images of themselves,
/// by a search through the images of all particles up to `range` cells away.
std::array<bool, 3> wraps(std::vector<Bond> const &bonds, std::size_t num_particles,
                          std::int32_t range)
{
    using Vertex = std::pair<std::size_t, pw85::Image>;
    std::vector<std::vector<Vertex>> next(num_particles);
    for (auto const &[i, j, image] : bonds)
        if (std::max(i, j) < num_particles) {
            next[i].push_back({j, image});
            next[j].push_back({i, add_scaled({}, -1, image)});
        }
    std::array<bool, 3> wraps{};
    std::vector<bool> reached(num_particles);
    for (std::size_t start = 0; start < num_particles; ++start) {
        if (reached[start]) continue;
        std::vector<Vertex> open = {{start, {}}};
        std::set<Vertex> seen(open.begin(), open.end());
        while (!open.empty()) {
            auto const [i, image] = open.back();
            open.pop_back();
            reached[i] = true;
            for (std::size_t d = 0; d < 3; ++d)
                wraps[d] = wraps[d] || (i == start && image[d] != 0);
            for (auto const &[j, step] : next[i]) {
                auto const there = add_scaled(image, 1, step);
                bool const near = std::ranges::all_of(
                    there, [=](std::int32_t n) { return std::abs(n) <= range; });
                if (near && seen.insert({j, there}).second) open.push_back({j, there});
            }
        }
    }
    return wraps;
}

std::string text(std::vector<Bond> const &bonds)
{
    std::string text;
    for (auto const &[i, j, n] : bonds)
        for (auto const x : {static_cast<int>(i), static_cast<int>(j), n[0], n[1], n[2]})
            text += std::to_string(x) + ' ';
    return text;
}

/// Random bonds between few particles. Most lead to the same cell or to a next one, as overlaps do.
/// A loop visits each particle once at most, so it leads no farther than there are particles.
void test_clusters()
{
    constexpr int num_particles = 5;
    std::mt19937_64 random(1);
    auto const below = [&](std::uint64_t n) { return random() % n; };
    Failures failures;
    for (int k = draws(80); k > 0; --k) {
        PeriodicClusters clusters(num_particles);
        std::vector<Bond> bonds;
        std::array<bool, 3> found{};
        while (bonds.size() < 7) {
            Bond bond = {below(num_particles), below(num_particles), {}};
            bond.image[below(3)] = static_cast<std::int32_t>(below(3)) - 1;
            bonds.push_back(bond);
            auto const loop = clusters.join(bond.i, bond.j, bond.image);
            auto const expected = wraps(bonds, num_particles, num_particles);
            for (std::size_t d = 0; d < 3; ++d) {
                found[d] = found[d] || loop[d] != 0;
                failures.check(found[d] == expected[d], "wraps", found[d], expected[d],
                               [&] { return text(bonds); });
            }
        }
    }
}

/// All bonds between particles, from overlap tests of the images up to two cells away.
std::vector<Bond> bonds_of(pw85::Particles const &particles)
{
    std::vector<Bond> bonds;
    double const side = (*particles.cell)[0][0];
    for (std::size_t i = 0; i < particles.q.size(); ++i)
        for (std::size_t j = i; j < particles.q.size(); ++j)
            for (std::int32_t k = 0; k < 125; ++k) {
                pw85::Image const n = {k / 25 - 2, k / 5 % 5 - 2, k % 5 - 2};
                auto const cells =
                    pw85::Vector<double, 3>{double(n[0]), double(n[1]), double(n[2])};
                auto const r12 = particles.centers[j] - particles.centers[i] + side * cells;
                if ((i != j || n != pw85::Image{}) &&
                    overlap(r12, particles.q[i], particles.q[j]).overlap)
                    bonds.push_back({i, j, n});
            }
    return bonds;
}

/// The numbers of insert(), by searches after each particle.
WrappingNumbers search(pw85::Particles const &particles)
{
    WrappingNumbers numbers{};
    auto const bonds = bonds_of(particles);
    for (std::size_t n = 1;
         n <= particles.q.size() && std::ranges::find(numbers, 0u) != numbers.end(); ++n) {
        auto const found = wraps(bonds, n, 2);
        for (std::size_t d = 0; d < 3; ++d)
            if (found[d] && numbers[d] == 0) numbers[d] = n;
    }
    return numbers;
}

/// The cubes are so small that a particle overlaps several images of another one, or its own.
void test_insertion()
{
    constexpr std::size_t num_particles = 14;
    Failures failures;
    for (Spheroids const &spheroids :
         {Spheroids{1.0, 3.2}, {1.0, 1.9}, {0.125, 2.6}, {3.0, 7.0}, {3.0, 4.0}})
        for (unsigned k = 0; k < static_cast<unsigned>(draws(8)); ++k) {
            Realization realization(spheroids, 7, k);
            realization.grow(num_particles);
            WrappingNumbers numbers, all;
            g_assert_true(insert(realization.particles(), numbers) == pw85::Status::success);
            g_assert_true(insert_until_wrapped(Realization(spheroids, 7, k), 1, all) ==
                          pw85::Status::success);
            auto const expected = search(realization.particles());
            for (std::size_t d = 0; d < 3; ++d) {
                auto const check = [&](char const *what, bool ok, std::size_t number) {
                    failures.check(ok, what, double(number), double(expected[d]), [&] {
                        return "aspect " + std::to_string(spheroids.aspect) + ", realisation " +
                               std::to_string(k);
                    });
                };
                check("insert", numbers[d] == expected[d], numbers[d]);
                check("insert_until_wrapped",
                      expected[d] == 0 ? all[d] > num_particles : all[d] == expected[d], all[d]);
            }
        }
}

/// A coordinate of a uniformly distributed direction is uniform between -1 and 1: its square has
/// the mean 1/3 and the variance 4/45, its fourth power has 1/5 and 16/225. The product of two
/// coordinates has the mean 0 and the variance 1/15.
void test_directions()
{
    constexpr int n = 40000;
    Draws draws({1.0, 1.0}, 3, 0);
    double second[3] = {}, fourth[3] = {}, mixed[3] = {};
    for (int k = 0; k < n; ++k) {
        auto const x = draws.direction();
        for (int d = 0; d < 3; ++d) {
            double const square = x[d] * x[d] / dot(x, x);
            second[d] += square / n;
            fourth[d] += square * square / n;
            mixed[d] += x[d] * x[(d + 1) % 3] / dot(x, x) / n;
        }
    }
    double const five_errors = 5.0 / std::sqrt(n);
    for (int d = 0; d < 3; ++d) {
        g_assert_cmpfloat(std::abs(second[d] - 1.0 / 3.0), <, five_errors * std::sqrt(4.0 / 45.0));
        g_assert_cmpfloat(std::abs(fourth[d] - 1.0 / 5.0), <,
                          five_errors * std::sqrt(16.0 / 225.0));
        g_assert_cmpfloat(std::abs(mixed[d]), <, five_errors * std::sqrt(1.0 / 15.0));
    }
}

} // namespace

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, nullptr);
    g_test_add_func("/percolation/clusters", test_clusters);
    g_test_add_func("/percolation/insertion", test_insertion);
    g_test_add_func("/percolation/directions", test_directions);
    return g_test_run();
}
