// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Simulations that have everything a state can have. Their numbers are exact or correctly rounded,
/// so that they are the same on every machine.
#ifndef PW85_TESTS_SAVED_SIMULATIONS_HPP_INCLUDED
#define PW85_TESTS_SAVED_SIMULATIONS_HPP_INCLUDED

#include <pw85.h>
#include <pw85_simulation.h>

#include <memory>
#include <vector>

namespace pw85_tests {

struct DestroySimulation {
    void operator()(pw85_hard_ellipsoids *simulation) const
    {
        pw85_hard_ellipsoids_destroy(simulation);
    }
};
using SimulationPointer = std::unique_ptr<pw85_hard_ellipsoids, DestroySimulation>;

/// The caller's potential.
inline double quadratic_potential(void *, std::int32_t particle, double const *center,
                                  double const *, double const *)
{
    return 0.125 * particle * center[2] * center[2];
}

/// Restores a state, and sets its potential again. Null if it is refused.
inline SimulationPointer restored(std::vector<unsigned char> const &bytes)
{
    pw85_hard_ellipsoids *made = nullptr;
    pw85_hard_ellipsoids_restore(bytes.size(), bytes.data(), &made);
    return SimulationPointer(made);
}

/// Empty if the state cannot be saved.
inline std::vector<unsigned char> state_of(SimulationPointer const &simulation)
{
    std::vector<unsigned char> bytes(pw85_hard_ellipsoids_num_bytes(simulation.get()));
    int const status = pw85_hard_ellipsoids_save(simulation.get(), bytes.size(), bytes.data());
    return status == PW85_SUCCESS ? bytes : std::vector<unsigned char>{};
}

/// 18 particles of two species between walls. Null if a call fails.
inline SimulationPointer simulation_in_space()
{
    std::vector<double> centers, semi_axes, quaternions;
    for (int i = 0; i < 18; ++i) {
        for (double const x : {3.0 * (i % 3), 3.0 * (i / 3 % 3), 3.0 * (i / 9)})
            centers.push_back(x - 0x1p-44);
        for (double const x : {0.5, 0.75, i % 2 == 0 ? 1.25 : 1.0}) semi_axes.push_back(x);
        for (double const x : {1.0, 0.1 * i, 0.3, -0.7}) quaternions.push_back(x);
    }
    double const cell[9] = {9.0, 0.0, 0.0, 0.0, 9.25, 0.0, 0.0, 0.0, 8.0};
    pw85_system const system = {18, centers.data(), nullptr, cell, {1, 1, 0}};
    pw85_hard_ellipsoids *made = nullptr;
    pw85_hard_ellipsoids_create(&system, semi_axes.data(), quaternions.data(), 77, nullptr, &made);
    SimulationPointer simulation(made);
    double const parameters[] = {0.25, 12.0, 1.0, 6.0, 1.5};
    pw85_law const law = {PW85_LAW_INVERSE_POWERS, 5, parameters};
    pw85_wall const walls[] = {{PW85_WALL_PLANE, {}, {0.0, 0.0, 1.0}, 6.0},
                               {PW85_WALL_PLANE, {}, {0.0, 0.0, -1.0}, 4.0}};
    pw85_field const fields[] = {{PW85_FIELD_LINEAR, 0, {}, {0.0, 0.0, 1.0}, 0.1},
                                 {PW85_FIELD_ALIGNING, 2, {}, {1.0, 0.0, 1.0}, -0.4}};
    double const vertices[] = {4.0, 4.0, 5.5, 5.0, 4.0, 5.5, 4.0, 5.0, 5.5, 5.0, 5.0, 5.75};
    std::int32_t const triangles[] = {0, 1, 2, 1, 2, 3};
    double const fractions[] = {0.5, 0.25, 0.25, 0.0}, kind[] = {0.5, 0.75, 1.25},
                 steps[] = {0.2, 0.1};
    bool const done =
        pw85_hard_ellipsoids_set_law(made, &law) == PW85_SUCCESS &&
        pw85_hard_ellipsoids_set_walls(made, 2, walls, nullptr) == PW85_SUCCESS &&
        pw85_hard_ellipsoids_set_fields(made, 2, fields) == PW85_SUCCESS &&
        pw85_hard_ellipsoids_set_mesh(made, 4, vertices, 2, triangles, nullptr) == PW85_SUCCESS &&
        pw85_hard_ellipsoids_set_fractions(made, fractions) == PW85_SUCCESS &&
        pw85_hard_ellipsoids_set_kind_steps(made, 1, kind, steps) == PW85_SUCCESS &&
        pw85_hard_ellipsoids_set_potential(made, quadratic_potential, nullptr) == PW85_SUCCESS &&
        pw85_hard_ellipsoids_sweep(made, 3) == PW85_SUCCESS;
    return done ? std::move(simulation) : nullptr;
}

/// Six ellipses without a cell. Null if a call fails.
inline SimulationPointer simulation_in_plane()
{
    std::vector<double> centers, semi_axes, quaternions;
    for (int i = 0; i < 6; ++i) {
        for (double const x : {2.5 * (i % 3), 2.5 * (i / 3), 1.0}) centers.push_back(x);
        for (double const x : {0.5, 1.0, 3.0}) semi_axes.push_back(x);
        for (double const x : {1.0, 0.0, 0.0, 0.2 * i}) quaternions.push_back(x);
    }
    pw85_system const system = {6, centers.data(), nullptr, nullptr, {}};
    pw85_hard_ellipsoids *made = nullptr;
    pw85_hard_ellipsoids_create(&system, semi_axes.data(), quaternions.data(), 2, nullptr, &made);
    SimulationPointer simulation(made);
    bool const done = pw85_hard_ellipsoids_set_dimensions(made, 2) == PW85_SUCCESS &&
                      pw85_hard_ellipsoids_sweep(made, 3) == PW85_SUCCESS;
    return done ? std::move(simulation) : nullptr;
}

} // namespace pw85_tests

#endif
