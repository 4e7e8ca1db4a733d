// SPDX-License-Identifier: BSD-3-Clause
// Event chains of hard ellipsoids: their pressure against Carnahan and Starling, and what each
// chain keeps.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

#include <glib.h>

#include <pw85.h>
#include <pw85/simulation.hpp>
#include <pw85_simulation.h>
#include <pw85_systems.h>

#include "cases.hpp"
#include "draws.hpp"

using namespace pw85_tests;

namespace {

struct Destroy {
    void operator()(pw85_hard_ellipsoids *simulation) const
    {
        pw85_hard_ellipsoids_destroy(simulation);
    }
};
using Simulation = std::unique_ptr<pw85_hard_ellipsoids, Destroy>;

/// Ellipsoids of revolution about z on a lattice that is stretched as they are, in a sheared
/// periodic cell.
struct Lattice {
    int per_side;
    double aspect, fraction, size; ///< `size` is the unit of length
    double offset = 0.0;           ///< of all coordinates

    std::size_t count() const { return static_cast<std::size_t>(per_side * per_side * per_side); }

    Simulation make(std::size_t seed) const
    {
        double const side = size * std::cbrt(std::numbers::pi / (6 * fraction)),
                     length = side * per_side;
        double const cell[9] = {length, 0, 0, length, length, 0, 0, 0, aspect * length};
        std::vector<double> centers, semi_axes, quaternions;
        for (int k = 0; k < per_side * per_side * per_side; ++k) {
            centers.insert(centers.end(), {offset + side * (k % per_side),
                                           offset + side * (k / per_side % per_side),
                                           offset + aspect * side * (k / per_side / per_side)});
            semi_axes.insert(semi_axes.end(), {0.5 * size, 0.5 * size, 0.5 * aspect * size});
            quaternions.insert(quaternions.end(), {1, 0, 0, 0});
        }
        pw85_system const system{count(), centers.data(), nullptr, cell, {1, 1, 1}};
        pw85_hard_ellipsoids *simulation = nullptr;
        g_assert_cmpint(pw85_hard_ellipsoids_create(&system, semi_axes.data(), quaternions.data(),
                                                    seed, nullptr, &simulation),
                        ==, PW85_SUCCESS);
        return Simulation(simulation);
    }
};

std::vector<double> centers_of(Simulation const &simulation)
{
    pw85_system const system = pw85_hard_ellipsoids_system(simulation.get());
    return {system.centers, system.centers + 3 * system.num_particles};
}

double chain(Simulation const &simulation, std::size_t num_chains, double length,
             double const *direction)
{
    double z = 7;
    g_assert_cmpint(pw85_hard_ellipsoids_chain(simulation.get(), num_chains, length, direction, &z),
                    ==, PW85_SUCCESS);
    return z;
}

bool is_free(Simulation const &simulation)
{
    return pw85_hard_ellipsoids_check(simulation.get(), nullptr) == PW85_SUCCESS;
}

struct Mean {
    double value, error;
};

/// βP/ρ by blocks of chains. Between them there are as many along random directions: chains along
/// one direction leave the coordinates across it as they are.
Mean mean_of_blocks(Simulation const &simulation, int num_blocks, std::size_t num_chains,
                    double length, double const *direction)
{
    double sum = 0, squares = 0;
    for (int k = 0; k < num_blocks; ++k) {
        chain(simulation, num_chains, length, nullptr);
        double const z = chain(simulation, num_chains, length, direction);
        sum += z;
        squares += z * z;
    }
    double const mean = sum / num_blocks;
    return {mean, std::sqrt((squares / num_blocks - mean * mean) / (num_blocks - 1))};
}

double carnahan_starling(double f) { return (1 + f + f * f - f * f * f) / std::pow(1 - f, 3); }

void check_pressure(Lattice const &lattice, double const *direction)
{
    auto const simulation = lattice.make(1);
    double const length = 15 * lattice.size;
    chain(simulation, lattice.count(), length, nullptr);
    auto const z = mean_of_blocks(simulation, 20, 30, length, direction);
    double const expected = carnahan_starling(lattice.fraction);
    g_test_message("βP/ρ = %g ± %g, expected %g", z.value, z.error, expected);
    g_assert_cmpfloat(z.error, <, 0.02 * expected);
    // of a few hundred particles
    g_assert_cmpfloat(std::abs(z.value - expected), <, 4 * z.error + 0.005 * expected);
    g_assert_true(is_free(simulation));
}

// Hard spheres; and parallel ellipsoids, which are spheres in other units along z, so that βP/ρ is
// the same along all directions.
PW85_TEST("/event_chains/pressure")
{
    double const oblique[3] = {1, 2, -2}, axis[3] = {0, 0, 3};
    check_pressure({7, 1.0, 0.3, 1.0}, nullptr);
    check_pressure({7, 1.0, 0.4, 0x1p40}, oblique);
    check_pressure({7, 3.0, 0.3, 0x1p-40}, axis);
    check_pressure({7, 0.25, 0.2, 1.0}, nullptr);
}

// The sum of all ways is the sum of the lengths: that of the centres along the direction, to
// rounding. The other coordinates keep theirs.
PW85_TEST("/event_chains/length")
{
    Lattice const lattice{6, 2.0, 0.4, 1.0};
    auto const simulation = lattice.make(2);
    double const direction[3] = {2, -1, 2};
    for (double const length : {1e-3, 1.0, 0x1.23456789abcdep5, 1e3}) {
        auto const before = centers_of(simulation);
        chain(simulation, 10, length, direction);
        auto const after = centers_of(simulation);
        double sum = 0, across = 0;
        for (std::size_t k = 0; k < before.size(); ++k) {
            double const moved = after[k] - before[k];
            sum += moved * direction[k % 3] / 3;
            // orthogonal to the direction
            across += k % 3 == 0 ? moved : k % 3 == 1 ? 2 * moved : 0;
        }
        g_assert_cmpfloat(std::abs(sum - 10 * length), <, 1e-11 * (1 + length));
        g_assert_cmpfloat(std::abs(across), <, 1e-11 * (1 + length));
    }
    g_assert_true(is_free(simulation));
}

// In a cell of one particle nothing is touched: its images move with it. If it could touch them by
// turning, the pressure is unknown.
PW85_TEST("/event_chains/one_particle")
{
    auto const simulation = Lattice{1, 2.0, 0.5, 1.0}.make(3);
    double const direction[3] = {0, 0, 2};
    g_assert_true(std::isnan(chain(simulation, 1, 100.0, direction)));
    g_assert_cmpfloat(std::abs(centers_of(simulation)[2] - 100.0), <, 1e-12);
    g_assert_true(is_free(simulation));
    auto const spheres = Lattice{1, 1.0, 0.5, 1.0}.make(3);
    g_assert_cmpfloat(chain(spheres, 1, 100.0, direction), ==, 1.0);
    g_assert_true(std::isnan(chain(spheres, 0, 100.0, direction)));
}

/// βP/ρ by a chain of two spheroids with the longest semi-axis 1, one of which is at the middle of
/// the cell.
double z_of_two(double unit, double const *vectors, std::array<int, 3> const &periodic)
{
    double cell[9], centers[6] = {}, semi_axes[6];
    for (int k = 0; k < 9; ++k) cell[k] = unit * vectors[k];
    for (int k = 0; k < 9; ++k) centers[3 + k % 3] += 0.5 * cell[k];
    for (int k = 0; k < 6; ++k) semi_axes[k] = unit * (k == 4 ? 1.0 : 0.25);
    // the second one along (1, 1, 1)
    double const quaternions[8] = {1, 0, 0, 0, 1.577, 0.577, 0, -0.577};
    pw85_system const system{2, centers, nullptr, cell, {periodic[0], periodic[1], periodic[2]}};
    pw85_hard_ellipsoids *made = nullptr;
    g_assert_cmpint(pw85_hard_ellipsoids_create(&system, semi_axes, quaternions, 1, nullptr, &made),
                    ==, PW85_SUCCESS);
    return chain(Simulation(made), 20, 30 * unit, nullptr);
}

// The shortest vector of the lattice decides, wherever it is among the vectors of the cell, and
// whether or not it is one of them.
PW85_TEST("/event_chains/own_images")
{
    for (double const unit : {1.0, 0x1p40, 0x1p-40})
        for (bool const may_touch : {false, true}) {
            double const side = 2.0 + (may_touch ? -1e-9 : 1e-9);
            double const box[9] = {9, 0, 0, 0, 9, 0, 0, 0, side},
                         first[9] = {side, 0, 0, 0, 9, 0, 0, 0, 9},
                         // two vectors differ by the short one
                skew[9] = {9, 0, 0, 9, side, 0, 0, 0, 9};
            for (double const *const cell : {box, first, skew})
                g_assert_cmpint(std::isnan(z_of_two(unit, cell, {1, 1, 1})), ==, may_touch);
            g_assert_cmpint(std::isnan(z_of_two(unit, box, {0, 1, 1})), ==, may_touch);
            g_assert_false(std::isnan(z_of_two(unit, box, {1, 1, 0})));
        }
}

// Two spheres of diameter 1 on a line, in a cell of length 5: after a contact the other one moves
// by 3 to the image of the first. So βP/ρ = 1 + 1/3, that of two rods on a line (Tonks): 1/2 + 1/2
// · 5/(5 - 2).
PW85_TEST("/event_chains/line")
{
    double const centers[6] = {0, 0, 0, 1.7, 0, 0}, semi_axes[6] = {0.5, 0.5, 0.5, 0.5, 0.5, 0.5},
                 quaternions[8] = {1, 0, 0, 0, 1, 0, 0, 0}, cell[9] = {5, 0, 0, 0, 9, 0, 0, 0, 9},
                 direction[3] = {1, 0, 0};
    pw85_system const system{2, centers, nullptr, cell, {1, 0, 0}};
    pw85_hard_ellipsoids *made = nullptr;
    g_assert_cmpint(pw85_hard_ellipsoids_create(&system, semi_axes, quaternions, 4, nullptr, &made),
                    ==, PW85_SUCCESS);
    Simulation const simulation(made);
    double const length = 3e5; // 1e5 ways
    g_assert_cmpfloat(std::abs(chain(simulation, 1, length, direction) - 4.0 / 3), <, 2e-5);
}

// Without a cell, particles move a million times farther away than they are at the start, and small
// ones still do not pass each other. The large third one makes stages long.
PW85_TEST("/event_chains/unbounded")
{
    double const centers[9] = {0, 0, 0, 1.7, 0, 0, 0, 0, 1e4},
                 semi_axes[9] = {0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 1e3, 1e3, 1e3},
                 quaternions[12] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, direction[3] = {1, 0, 0};
    pw85_system const system{3, centers, nullptr, nullptr, {0, 0, 0}};
    for (std::size_t seed = 1; seed <= 4; ++seed) {
        pw85_hard_ellipsoids *made = nullptr;
        g_assert_cmpint(
            pw85_hard_ellipsoids_create(&system, semi_axes, quaternions, seed, nullptr, &made), ==,
            PW85_SUCCESS);
        Simulation const simulation(made);
        chain(simulation, 30, 1e7, direction);
        auto const after = centers_of(simulation);
        g_test_message("seed %zu: from %a to %a", seed, after[0], after[3]);
        g_assert_cmpfloat(after[3] - after[0], >=, 1.0);
        g_assert_true(is_free(simulation));
    }
}

// Chains, rotations and translations: long runs of slender ellipsoids in a dense system, never with
// an overlap.
PW85_TEST("/event_chains/never_overlaps")
{
    auto const simulation = Lattice{5, 8.0, 0.5, 1.0}.make(5);
    for (int k = 0; k < draws(24); ++k) {
        chain(simulation, 50, 10.0, nullptr);
        g_assert_true(is_free(simulation));
        g_assert_cmpint(pw85_hard_ellipsoids_sweep(simulation.get(), 2), ==, PW85_SUCCESS);
    }
}

/// Ellipsoids of several sizes on a lattice, with room around them in two directions, after some
/// sweeps.
Simulation make_mixture(std::size_t seed)
{
    constexpr int per_side = 6;
    constexpr double side = 1.2, aspect = 1.5, length = side * per_side;
    double const cell[9] = {length, 0, 0, length / 2, length, 0, 0, 0, aspect * length};
    std::vector<double> centers, semi_axes, quaternions;
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform(0.35, 0.5);
    for (int k = 0; k < per_side * per_side * per_side; ++k) {
        double const size = uniform(random);
        centers.insert(centers.end(), {side * (k % per_side), side * (k / per_side % per_side),
                                       aspect * side * (k / per_side / per_side)});
        semi_axes.insert(semi_axes.end(), {size, size, aspect * size});
        quaternions.insert(quaternions.end(), {1, 0, 0, 0});
    }
    pw85_system const system{centers.size() / 3, centers.data(), nullptr, cell, {0, 1, 0}};
    pw85_hard_ellipsoids *made = nullptr;
    g_assert_cmpint(pw85_hard_ellipsoids_create(&system, semi_axes.data(), quaternions.data(), seed,
                                                nullptr, &made),
                    ==, PW85_SUCCESS);
    g_assert_cmpint(pw85_hard_ellipsoids_sweep(made, 20), ==, PW85_SUCCESS);
    return Simulation(made);
}

// Particles that touch without a way before: the plane between the two may not hide the first one
// from the second. If it did, the second one could not move at all.
PW85_TEST("/event_chains/no_way")
{
    double const direction[3] = {1, 0, 0};
    for (std::size_t seed = 1; seed <= 8; ++seed) {
        auto const simulation = make_mixture(seed);
        for (int k = 0; k < 4; ++k) chain(simulation, 20, 20.0, k % 2 ? direction : nullptr);
        g_assert_true(is_free(simulation));
    }
}

/// Two ellipsoids of which the first would touch the second on a way that is long enough, or nearly
/// so.
struct Approach {
    double centers[6], semi_axes[6], quaternions[8], direction[3], q[2][6], length;

    explicit Approach(std::mt19937_64 &random)
    {
        std::normal_distribution<double> normal;
        std::uniform_real_distribution<double> uniform(-1.0, 1.0);
        double const unit = std::exp2(std::round(40.0 * uniform(random)));
        for (double &x : semi_axes) x = unit * std::pow(8.0, uniform(random));
        for (double &x : quaternions) x = normal(random);
        double const gap = 2.0 * *std::max_element(semi_axes, semi_axes + 6);
        for (int d = 0; d < 3; ++d) {
            centers[d] = unit * normal(random);
            double const way = gap * normal(random);
            centers[3 + d] = centers[d] + way * (1.0 + 4.0 / 3.0);
            direction[d] = way + 0.2 * gap * normal(random);
        }
        double const size = std::hypot(direction[0], direction[1], direction[2]);
        for (double &x : direction) x /= size;
        length = 20.0 * gap;
        for (int k = 0; k < 2; ++k)
            pw85_ellipsoid_quaternion(semi_axes + 3 * k, quaternions + 4 * k, q[k]);
    }

    /// After the first has moved.
    double mu2(double way) const
    {
        double r12[3], out[2] = {0, 0}; // μ² and λ
        for (int d = 0; d < 3; ++d) r12[d] = centers[3 + d] - centers[d] - way * direction[d];
        pw85_contact(r12, q[0], q[1], out);
        return out[0];
    }
};

// The way of a particle ends at the contact, as pw85_free_path() and the contact function say: not
// later, and not before.
PW85_TEST("/event_chains/ways")
{
    std::mt19937_64 random(11);
    int touched = 0;
    for (int k = 0; k < draws(4000); ++k) {
        Approach const a(random);
        pw85_system const system{2, a.centers, nullptr, nullptr, {0, 0, 0}};
        pw85_hard_ellipsoids *made = nullptr;
        if (pw85_hard_ellipsoids_create(&system, a.semi_axes, a.quaternions,
                                        1 + static_cast<std::size_t>(k), nullptr,
                                        &made) != PW85_SUCCESS)
            continue; // they overlap
        Simulation const simulation(made);
        chain(simulation, 1, a.length, a.direction);
        auto const after = centers_of(simulation);
        double way = 0, r12[3], path = 0;
        for (int d = 0; d < 3; ++d) {
            way += (after[static_cast<std::size_t>(d)] - a.centers[d]) * a.direction[d];
            r12[d] = a.centers[3 + d] - a.centers[d];
        }
        g_assert_cmpint(pw85_free_path(r12, a.q[0], a.q[1], a.direction, a.length, &path), ==,
                        PW85_SUCCESS);
        bool const touches = path < a.length;
        bool const second_first = !(way > 0) || (!touches && after[3] != a.centers[3]);
        if (second_first) continue;
        touched += touches;
        double const mu2 = a.mu2(way);
        if (touches ? !(way <= path * (1 + 0x1p-40) && std::abs(mu2 - 1) < 0x1p-32)
                    : !(way > a.length * (1 - 0x1p-40)))
            g_test_fail_printf("%d: way %a of %a, free path %a, mu2 %a", k, way, a.length, path,
                               mu2);
    }
    g_assert_cmpint(touched, >, draws(4000) / 10);
}

// Far from the origin, places are rounded by much more than free paths are. Ways end so many
// roundings before a contact that particles stay free.
PW85_TEST("/event_chains/far_away")
{
    auto const simulation = Lattice{4, 1.5, 0.4, 1.0, 0x1p30}.make(5);
    for (int k = 0; k < 500; ++k) {
        chain(simulation, 1, 1.0, nullptr);
        g_assert_true(is_free(simulation));
    }
}

// A way passes another sphere by less than the place at its end is rounded. So the place may
// overlap it, though the way has no contact.
PW85_TEST("/event_chains/passing_far_away")
{
    std::mt19937_64 random(13);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    double const direction[3] = {0.8, 0.6, 0}, across[3] = {-0.6, 0.8, 0},
                 quaternions[8] = {1, 0, 0, 0, 1, 0, 0, 0};
    for (double const unit : {1.0, 0x1p40, 0x1p-40})
        for (int k = 0; k < 1000; ++k) {
            double const far = 0x1p40, along = 3.0 + uniform(random),
                         gap = 0x1p-13 * uniform(random);
            double centers[6], semi_axes[6];
            for (int d = 0; d < 3; ++d) {
                double const r12 = along * direction[d] + (1.0 + gap) * across[d];
                centers[d] = unit * far * uniform(random);
                centers[3 + d] = centers[d] + unit * r12;
                semi_axes[d] = semi_axes[3 + d] = 0.5 * unit;
            }
            pw85_system const system{2, centers, nullptr, nullptr, {0, 0, 0}};
            pw85_hard_ellipsoids *made = nullptr;
            g_assert_cmpint(pw85_hard_ellipsoids_create(&system, semi_axes, quaternions,
                                                        static_cast<std::size_t>(k), nullptr,
                                                        &made),
                            ==, PW85_SUCCESS);
            Simulation const simulation(made);
            chain(simulation, 1, unit * along, direction);
            if (!is_free(simulation))
                g_test_fail_printf("unit %a, from %a %a %a to %a %a %a by %a", unit, centers[0],
                                   centers[1], centers[2], centers[3], centers[4], centers[5],
                                   along);
        }
}

// One of two spheres is stored millions of cells away. A way ends some roundings of the coordinates
// of the particle that moves before a contact, but the separation is rounded by those of the other
// one: to multiples of 2⁻²⁶, of which 0.6 is none. A chain of 2⁻²¹ often ends that near to a
// contact. The test of the place prevents overlaps.
PW85_TEST("/event_chains/far_partner")
{
    double const far = 2.5 * 0x1p25, cell[9] = {2.5, 0, 0, 0, 2.5, 0, 0, 0, 2.5},
                 direction[3] = {0.8, 0.6, 0}, centers[6] = {0, 0, 0, far + 0.6 + 0x1p-22, 0, 0},
                 semi_axes[6] = {0.3, 0.3, 0.3, 0.3, 0.3, 0.3},
                 quaternions[8] = {1, 0, 0, 0, 1, 0, 0, 0};
    pw85_system const system{2, centers, nullptr, cell, {1, 1, 1}};
    pw85_hard_ellipsoids *made = nullptr;
    g_assert_cmpint(pw85_hard_ellipsoids_create(&system, semi_axes, quaternions, 3, nullptr, &made),
                    ==, PW85_SUCCESS);
    Simulation const simulation(made);
    for (int k = 0; k < 500; ++k) {
        chain(simulation, 1, 0x1p-21, direction);
        g_assert_true(is_free(simulation));
    }
}

// The same as passing_far_away, but only the other sphere is stored far away, so that its
// translation is long and the coordinates of the particle that moves are short. Spheres that touch
// within the rounding of places may block each other.
PW85_TEST("/event_chains/passing_far_partner")
{
    std::mt19937_64 random(14);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    double const edge = 0x1p13, direction[3] = {0.8, 0.6, 0}, across[3] = {-0.6, 0.8, 0},
                 quaternions[8] = {1, 0, 0, 0, 1, 0, 0, 0},
                 cell[9] = {edge, 0, 0, 0, edge, 0, 0, 0, edge};
    int successful = 0;
    for (int k = 0; k < 1000; ++k) {
        double const along = 3.0 + uniform(random), gap = 0x1p-13 * uniform(random);
        double centers[6], semi_axes[6];
        for (int d = 0; d < 3; ++d) {
            double const r12 = along * direction[d] + (1.0 + gap) * across[d];
            centers[d] = uniform(random);
            centers[3 + d] = centers[d] + r12 + edge * std::round(0x1p25 * uniform(random));
            semi_axes[d] = semi_axes[3 + d] = 0.5;
        }
        pw85_system const system{2, centers, nullptr, cell, {1, 1, 1}};
        pw85_hard_ellipsoids *made = nullptr;
        g_assert_cmpint(pw85_hard_ellipsoids_create(&system, semi_axes, quaternions,
                                                    static_cast<std::size_t>(k), nullptr, &made),
                        ==, PW85_SUCCESS);
        Simulation const simulation(made);
        double z;
        int const status = pw85_hard_ellipsoids_chain(simulation.get(), 1, along, direction, &z);
        g_assert_true(status == PW85_SUCCESS || status == PW85_ECONVERGENCE);
        successful += status == PW85_SUCCESS;
        if (!is_free(simulation))
            g_test_fail_printf("from %a %a %a to %a %a %a by %a", centers[0], centers[1],
                               centers[2], centers[3], centers[4], centers[5], along);
    }
    g_assert_cmpint(successful, >, 900);
}

// The seed determines each bit, also after the simulation is saved and restored between chains.
// Another seed gives others.
PW85_TEST("/event_chains/reproducible")
{
    Lattice const lattice{5, 2.0, 0.4, 1.0};
    auto const first = lattice.make(6), second = lattice.make(6), third = lattice.make(7);
    double const z = chain(first, 20, 7.0, nullptr);
    g_assert_cmpfloat(chain(second, 20, 7.0, nullptr), ==, z);
    g_assert_true(centers_of(first) == centers_of(second));
    g_assert_cmpfloat(chain(third, 20, 7.0, nullptr), !=, z);
    std::vector<unsigned char> bytes(pw85_hard_ellipsoids_num_bytes(first.get()));
    g_assert_cmpint(pw85_hard_ellipsoids_save(first.get(), bytes.size(), bytes.data()), ==,
                    PW85_SUCCESS);
    pw85_hard_ellipsoids *restored = nullptr;
    g_assert_cmpint(pw85_hard_ellipsoids_restore(bytes.size(), bytes.data(), &restored), ==,
                    PW85_SUCCESS);
    Simulation const resumed(restored);
    chain(resumed, 5, 7.0, nullptr);
    chain(second, 2, 7.0, nullptr);
    chain(second, 3, 7.0, nullptr);
    g_assert_true(centers_of(resumed) == centers_of(second));
}

// The members of C++ make the same chains.
PW85_TEST("/event_chains/members")
{
    Lattice const lattice{4, 1.5, 0.3, 1.0};
    auto const in_c = lattice.make(9);
    pw85::HardEllipsoids in_cpp(lattice.make(9).release());
    double z = 7;
    g_assert_true(in_cpp.chain(6, 3.0, z) == pw85::Status::success);
    g_assert_cmpfloat(z, ==, chain(in_c, 6, 3.0, nullptr));
    pw85::Vector<double, 3> const direction{1.0, 2.0, -0.5};
    g_assert_true(in_cpp.chain(6, 3.0, direction, z) == pw85::Status::success);
    g_assert_cmpfloat(z, ==, chain(in_c, 6, 3.0, direction.coordinates));
}

PW85_TEST("/event_chains/bad_input")
{
    auto const simulation = Lattice{2, 1.0, 0.3, 1.0}.make(8);
    double const zero[3] = {0, 0, 0}, nan[3] = {1, NAN, 0}, good[3] = {1, 0, 0};
    auto const before = centers_of(simulation);
    auto const status = [&](double length, double const *direction) {
        double z = 7;
        int const result = pw85_hard_ellipsoids_chain(simulation.get(), 3, length, direction, &z);
        g_assert_true(std::isnan(z));
        return result;
    };
    for (double const length : {0.0, -1.0, static_cast<double>(NAN), HUGE_VAL})
        g_assert_cmpint(status(length, good), ==, PW85_EINVAL);
    g_assert_cmpint(status(1.0, zero), ==, PW85_EINVAL);
    g_assert_cmpint(status(1.0, nan), ==, PW85_EINVAL);
    g_assert_cmpint(pw85_hard_ellipsoids_chain(nullptr, 3, 1.0, good, nullptr), ==, PW85_EINVAL);
    g_assert_true(centers_of(simulation) == before);
    g_assert_true(std::isnan(chain(simulation, 0, 1.0, good)));
}

} // namespace
