// SPDX-License-Identifier: BSD-3-Clause
// Monte Carlo of hard ellipsoids, and of hard ellipses, while each allocation in turn fails: there
// is an error, and no overlap then or later. Random sequential addition, while each allocation in
// turn fails: it continues, to saturation.
#include <cmath>
#include <vector>

#include <glib.h>

#include <pw85/pw85.hpp>
#include <pw85/simulation.hpp>

#include "cases.hpp"
#include "refused_memory.hpp"

using pw85::HardEllipsoids;
using pw85::Status;
using pw85_tests::granted;

namespace {

constexpr double pressure = 3.0;

/// Upright particles on a lattice: spheroids, or ellipses. The steps are long, so that the lists of
/// neighbours are soon made anew.
HardEllipsoids make_simulation(int dimensions)
{
    constexpr double a = 1.3, c = 2.7;
    int const n = dimensions == 2 ? 8 : 4, layers = dimensions == 2 ? 1 : n;
    std::vector<pw85::Vector<double, 3>> centers;
    for (int k = 0; k < n * n * layers; ++k)
        centers.push_back({a * (k % n), c * (k / n % n), a * (k / n / n)});
    std::vector<pw85::Vector<double, 3>> const semi_axes(centers.size(), {0.5, 1.2, 0.5});
    std::vector<pw85::Vector<double, 4>> const quaternions(centers.size(), {1.0, 0.0, 0.0, 0.0});
    pw85::Cell const cell{{{a * n, 0.0, 0.0}, {0.0, c * n, 0.0}, {0.0, 0.0, a * n}}};
    HardEllipsoids simulation;
    pw85::IndexPair pair;
    pw85::Particles const particles{centers, {}, &cell, {1, 1, dimensions == 3}};
    g_assert_true(hard_ellipsoids_create(particles, semi_axes, quaternions, 1, simulation, pair) ==
                  Status::success);
    g_assert_true(simulation.set_dimensions(dimensions) == Status::success);
    g_assert_true(simulation.set_steps({0.15, 0.1, 0.6}) == Status::success);
    g_assert_true(simulation.sweep(30) == Status::success);
    return simulation;
}

void expect_no_overlap(HardEllipsoids const &simulation)
{
    pw85::IndexPair pair;
    g_assert_true(simulation.check(pair) == Status::success);
}

std::vector<double> centers_and_cell(HardEllipsoids const &simulation)
{
    pw85_system const system = simulation.system();
    std::vector<double> numbers(system.centers, system.centers + 3 * system.num_particles);
    numbers.insert(numbers.end(), system.cell, system.cell + 9);
    return numbers;
}

/// Refuses each request of a call of a simulation of some dimensions in turn, of which there are at
/// least some, to the same simulation. The simulation goes on after each refusal.
template <class Call> void refuse_each(long least, int dimensions, Call const &call)
{
    HardEllipsoids simulation = make_simulation(dimensions);
    std::vector<unsigned char> bytes(simulation.num_bytes());
    g_assert_true(simulation.save(bytes) == Status::success);
    for (long refused = 0;; ++refused) {
        g_assert_true(hard_ellipsoids_restore(bytes, simulation) == Status::success);
        g_assert_true(simulation.sweep(3) == Status::success);
        granted = refused;
        Status const status = call(simulation);
        bool const all_granted = granted.exchange(-1) >= 0;
        g_assert_true(status == (all_granted ? Status::success : Status::out_of_memory));
        expect_no_overlap(simulation);
        g_assert_true(simulation.sweep(4) == Status::success);
        g_assert_true(simulation.volume_moves(1, pressure) == Status::success);
        expect_no_overlap(simulation);
        if (!all_granted) continue;
        g_test_message("%ld refusals", refused);
        g_assert_cmpint(refused, >=, least);
        return;
    }
}

PW85_TEST("/hard_ellipsoids_memory/sweep")
{
    for (int const dimensions : {3, 2})
        refuse_each(13, dimensions,
                    [](HardEllipsoids &simulation) { return simulation.sweep(10); });
}

// The trial for which memory is refused changes nothing.
PW85_TEST("/hard_ellipsoids_memory/volume")
{
    auto const change_volumes = [](HardEllipsoids &simulation) {
        Status status = Status::success;
        for (int k = 0; k < 15 && status == Status::success; ++k) {
            auto const before = centers_and_cell(simulation);
            status = simulation.volume_moves(1, pressure);
            if (status != Status::success) g_assert_true(centers_and_cell(simulation) == before);
        }
        return status;
    };
    for (int const dimensions : {3, 2}) refuse_each(13, dimensions, change_volumes);
}

PW85_TEST("/hard_ellipsoids_memory/chain")
{
    auto const make_chains = [](HardEllipsoids &simulation) {
        double z;
        return simulation.chain(3, 5.0, z);
    };
    for (int const dimensions : {3, 2}) refuse_each(8, dimensions, make_chains);
}

// The trials that were made before the refusal remain. The arrays grow several times.
PW85_TEST("/hard_ellipsoids_memory/insertions")
{
    pw85::Vector<double, 3> const kind = {0.05, 0.05, 0.05};
    double const activity = 50.0;
    auto const exchange = [&](HardEllipsoids &simulation) {
        std::array<std::int64_t, 4> counts;
        Status const status = simulation.insertion_moves(600, {&kind, 1}, {&activity, 1}, counts);
        if (status == Status::success) g_assert_cmpint(counts[1] - counts[3], >, 50);
        return status;
    };
    auto const insert = [&](HardEllipsoids &simulation) {
        std::size_t const before = simulation.system().num_particles;
        bool is_free;
        Status const status =
            simulation.insert({0.65, 1.35, 0.0}, {1, 0, 0, 0}, kind, true, is_free);
        g_assert_cmpuint(simulation.system().num_particles, ==,
                         before + (status == Status::success && is_free));
        return status;
    };
    auto const weigh = [&](HardEllipsoids &simulation) {
        double weight;
        return simulation.insertion_weight(3, kind, weight);
    };
    for (int const dimensions : {3, 2}) {
        refuse_each(8, dimensions, exchange);
        refuse_each(8, dimensions, insert);
        refuse_each(6, dimensions, weigh);
    }
}

/// Adds discs until the packing is saturated. Returns how often the memory was refused.
int fill(pw85::RandomAddition &addition)
{
    auto end = pw85::AdditionEnd::none;
    int refusals = 0;
    while (end != pw85::AdditionEnd::saturated) {
        Status const status = addition.advance(INFINITY, 100000, end);
        g_assert_true(status == Status::success || status == Status::out_of_memory);
        refusals += status == Status::out_of_memory;
    }
    return refusals;
}

PW85_TEST("/hard_ellipsoids_memory/random_addition")
{
    double const edge = 20.0;
    pw85::Cell const cell{{{edge, 0, 0}, {0, edge, 0}, {0, 0, 1}}};
    std::vector<pw85::Vector<double, 3>> const disc = {{1, 1, 1}};
    for (long refused = 0;; ++refused) {
        pw85::RandomAddition addition;
        granted = refused;
        Status const made = random_addition_create(2, cell, disc, 1, addition);
        int const refusals = made == Status::success ? fill(addition) : 1;
        bool const all_granted = granted.exchange(-1) >= 0;
        g_assert_cmpint(refusals, ==, !all_granted);
        if (made != Status::success) continue;
        std::size_t const n = addition.state().num_particles;
        std::vector<pw85::Vector<double, 3>> centers(n);
        g_assert_true(addition.particles(centers) == Status::success);
        g_assert_cmpuint(n, >, 55); // discs of a fraction of 0.43
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < i; ++j) {
                auto r = centers[i] - centers[j];
                for (int d = 0; d < 2; ++d) r[d] -= edge * std::round(r[d] / edge);
                g_assert_cmpfloat(dot(r, r), >=, 4 * (1 - 1e-12));
            }
        if (!all_granted) continue;
        g_test_message("%ld refusals", refused);
        g_assert_cmpint(refused, >=, 12);
        return;
    }
}

} // namespace
