// SPDX-License-Identifier: BSD-3-Clause
// The sums over graphs (graphs.hpp), against numbers of graphs, Ree and Hoover's diagrams of B4,
// and particles on a ring of sites, whose virial series follows from the grand partition function.
// The moments of the random rotations (cluster.hpp).
#include <cmath>

#include <glib.h>

#include "cluster.hpp"

using namespace virial;

namespace {

using Series = std::vector<double>; // by powers from 0 to most_particles

double factorial(int n) { return n == 0 ? 1.0 : n * factorial(n - 1); }

// Cayley's formula; the numbers of labelled biconnected graphs are those of F. Harary and E. M.
// Palmer, Graphical Enumeration (1973).
void test_numbers()
{
    int const biconnected[] = {1, 1, 10, 238, 11368};
    for (int n = 2; n <= most_particles; ++n) {
        int found = 0, trees = 0;
        for (Graph graph = 0; graph < number_of_graphs(n); ++graph) {
            found += is_biconnected(graph, n);
            trees += is_tree(graph, n);
        }
        g_assert_cmpint(found, ==, biconnected[n - 2]);
        g_assert_cmpint(trees, ==, static_cast<int>(std::lround(std::pow(n, n - 2))));
    }
}

// The branches of a tree are its edges, and each begins at a vertex that is reached. A graph's sum
// counts exactly the trees in it.
void test_trees()
{
    for (int n = 2; n <= most_particles; ++n) {
        auto const trees = weighted_trees(n);
        std::vector<int> times(number_of_graphs(n));
        for (auto const &branches : trees) {
            Graph graph = 0;
            unsigned reached = 1;
            for (auto const &[i, j] : branches) {
                g_assert_true((reached >> i & 1) && !(reached >> j & 1));
                reached |= 1u << j;
                graph |= edge(i, j);
            }
            ++times[graph];
        }
        for (Graph graph = 0; graph < times.size(); ++graph)
            g_assert_cmpint(times[graph], ==, weight_of_tree(graph, n));
        g_assert_cmpint(tree_sums(n).back(), ==, static_cast<int>(trees.size()));
    }
}

// All graphs that count contain a tree that is sampled.
void test_coverage()
{
    for (int n = 2; n <= most_particles; ++n) {
        auto const mayer = mayer_sums(n), trees = tree_sums(n);
        for (Graph graph = 0; graph < mayer.size(); ++graph)
            g_assert_true(mayer[graph] == 0 || trees[graph] > 0);
    }
}

// B4 = -3/24 (-2 [complete] + 3 [square]): F. H. Ree and W. G. Hoover, Fifth and sixth virial
// coefficients for hard spheres and hard disks, Journal of Chemical Physics 40, 939 (1964).
void test_four()
{
    auto const mayer = mayer_sums(4);
    for (Graph graph = 0; graph < mayer.size(); ++graph) {
        bool const complete = graph == mayer.size() - 1;
        bool const square = std::popcount(graph) == 4 && is_biconnected(graph, 4);
        g_assert_cmpint(mayer[graph], ==, complete ? -2 : square ? 1 : 0);
    }
}

/// A ring of sites; the bits of `excluded` are the distances, in either direction, of which two
/// particles cannot be.
struct Ring {
    int sites;
    unsigned excluded;

    bool excludes(int x, int y) const
    {
        int const distance = (x - y + sites) % sites;
        return excluded >> distance & 1 || excluded >> (sites - distance) % sites & 1;
    }
};

/// B_n = (1-n)/n! Σ of the Mayer sum over the places of all particles but the first.
double virial_coefficient(Ring const &ring, int n)
{
    auto const mayer = mayer_sums(n);
    int places[most_particles] = {};
    long sum = 0;
    for (bool ended = false; !ended;) {
        Graph graph = 0;
        for (int j = 1; j < n; ++j)
            for (int i = 0; i < j; ++i)
                if (ring.excludes(places[i], places[j])) graph |= edge(i, j);
        sum += mayer[graph];
        int k = 1;
        while (k < n && ++places[k] == ring.sites) places[k++] = 0;
        ended = k == n;
    }
    return (1 - n) / factorial(n) * static_cast<double>(sum);
}

Series product(Series const &x, Series const &y)
{
    Series z(most_particles + 1);
    for (std::size_t i = 0; i < z.size(); ++i)
        for (std::size_t j = 0; i + j < z.size(); ++j) z[i + j] += x[i] * y[j];
    return z;
}

/// The pressure by powers of the activity, ln Ξ / sites. The coefficients of Ξ are the numbers of
/// ways to place particles.
Series pressure(Ring const &ring)
{
    Series partition(most_particles + 1), logarithm(most_particles + 1);
    for (unsigned occupied = 0; occupied < 1u << ring.sites; ++occupied) {
        bool allowed = std::popcount(occupied) <= most_particles;
        for (int j = 1; allowed && j < ring.sites; ++j)
            for (int i = 0; i < j; ++i)
                allowed = allowed && !(occupied >> i & occupied >> j & 1 && ring.excludes(i, j));
        if (allowed) partition[static_cast<std::size_t>(std::popcount(occupied))] += 1.0;
    }
    for (std::size_t k = 1; k < logarithm.size(); ++k) { // of Ξ' = (ln Ξ)' Ξ
        logarithm[k] = partition[k];
        for (std::size_t l = 1; l < k; ++l)
            logarithm[k] -=
                static_cast<double>(l) / static_cast<double>(k) * logarithm[l] * partition[k - l];
    }
    for (auto &coefficient : logarithm) coefficient /= ring.sites;
    return logarithm;
}

// The pressure is Σ B_n ρ^n, with the density ρ = z dp/dz, since all sites are alike. Some hundred
// terms are summed, each with a relative error of some 2⁻⁵³. A wrong sum of one graph changes a
// coefficient by at least 5/6!.
void test_rings()
{
    for (auto const &ring : {Ring{8, 0x01}, Ring{12, 0x03}, Ring{8, 0xab}, Ring{11, 0x0b},
                             Ring{12, 0x47}, Ring{9, 0x1f}}) {
        auto const p = pressure(ring);
        Series density = p, power(p.size()), sum(p.size());
        for (std::size_t k = 0; k < p.size(); ++k) density[k] = static_cast<double>(k) * p[k];
        power[0] = 1.0;
        double largest = 0.0;
        for (int n = 1; n <= most_particles; ++n) {
            power = product(power, density);
            double const coefficient = n == 1 ? 1.0 : virial_coefficient(ring, n);
            for (std::size_t k = 0; k < p.size(); ++k) {
                sum[k] += coefficient * power[k];
                largest = std::fmax(largest, std::fabs(coefficient * power[k]));
            }
        }
        for (std::size_t k = 0; k < p.size(); ++k)
            if (std::fabs(sum[k] - p[k]) > 1e-12 * largest) {
                g_test_message("%d sites, distances 0x%x, power %zu: %a, but %a", ring.sites,
                               ring.excluded, k, sum[k], p[k]);
                g_test_fail();
            }
    }
}

// Each entry x of a uniform rotation is distributed as the coordinate of a uniform point of the
// unit sphere, uniformly from -1 to 1: x² has the mean 1/3 and the variance 4/45, x⁴ has the mean
// 1/5 and the variance 16/225.
void test_rotations()
{
    constexpr int samples = 100000;
    double squares[9] = {}, fourths[9] = {};
    Stream random(1, 2, 3);
    for (int n = 0; n < samples; ++n) {
        auto const rotation = pw85::detail::rotation_matrix(random_rotation(random));
        for (int k = 0; k < 9; ++k) {
            double const square = rotation.entries[k] * rotation.entries[k];
            squares[k] += square / samples;
            fourths[k] += square * square / samples;
        }
    }
    for (int k = 0; k < 9; ++k) {
        g_assert_cmpfloat_with_epsilon(squares[k], 1.0 / 3.0,
                                       5.0 * std::sqrt(4.0 / 45.0 / samples));
        g_assert_cmpfloat_with_epsilon(fourths[k], 1.0 / 5.0,
                                       5.0 * std::sqrt(16.0 / 225.0 / samples));
    }
}

} // namespace

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, nullptr);
    g_test_add_func("/virial_clusters/numbers", test_numbers);
    g_test_add_func("/virial_clusters/trees", test_trees);
    g_test_add_func("/virial_clusters/coverage", test_coverage);
    g_test_add_func("/virial_clusters/four", test_four);
    g_test_add_func("/virial_clusters/rings", test_rings);
    g_test_add_func("/virial_clusters/rotations", test_rotations);
    return g_test_run();
}
