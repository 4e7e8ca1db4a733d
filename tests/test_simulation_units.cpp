// SPDX-License-Identifier: BSD-3-Clause
// Simulations of hard ellipsoids in other units: after all functions that take lengths, each number
// is that of the same simulation in units of one, to the last bit.
#include <array>
#include <cmath>
#include <vector>

#include <glib.h>

#include "cases.hpp"
#include "hard_particles.hpp"

using namespace pw85_tests;

namespace {

/// Exponents of units of length. Volumes and their inverses must be numbers, so all are below 341.
constexpr int exponents[] = {-300, -240, -140, -125, -40, 40, 125, 140, 240, 300};

struct System {
    Start start;
    int dimensions;

    /// Returns the same system with another length of the unit.
    Start in(double unit) const
    {
        Start other = start;
        for (auto *vectors : {&other.centers, &other.semi_axes})
            for (Vector3 &x : *vectors) x = unit * x;
        for (Vector3 &x : other.cell) x = unit * x;
        return other;
    }
};

System sheared_space()
{
    System system{lattice(3), 3};
    system.start.cell[1][0] = 1.0;
    system.start.cell[2][0] = -0.5;
    return system;
}

/// Ellipses of two kinds in a sheared cell.
System sheared_plane()
{
    constexpr int n = 5;
    System system{{}, 2};
    for (int k = 0; k < n * n; ++k)
        system.start.add({1.25 * (k % n), 2.6 * (k / n), 0.5},
                         k % 3 == 0 ? Vector3{0.45, 0.9, 0.5} : Vector3{0.5, 1.2, 0.5});
    system.start.cell = box(1.25 * n, 2.6 * n, 4.0);
    system.start.cell[1][0] = 1.0;
    system.start.periodic = {1, 1, 0};
    return system;
}

/// Calls functions of a simulation, and collects their numbers in units of one.
class Run {
  public:
    Run(System const &system, double unit)
        : unit_(unit), measure_(system.dimensions == 2 ? unit * unit : unit * unit * unit),
          simulation_(system.in(unit).simulation())
    {
        expect(simulation_.set_dimensions(system.dimensions));
        expect(simulation_.set_steps({0.1 * unit, 0.1, 0.02}));
    }

    void move_particles()
    {
        expect(simulation_.sweep(3));
        for (CellChange const change :
             {CellChange::isotropic, CellChange::axis, CellChange::triclinic, CellChange::aspect}) {
            expect(simulation_.volume_moves(5, 2.0 / measure_, change));
            expect(simulation_.sweep(1));
        }
        expect(simulation_.tune(4, 0.4, 2.0 / measure_));
        add_length(simulation_.steps().translation);
    }

    void run_chains()
    {
        double z;
        expect(simulation_.chain(30, 4.0 * unit_, z));
        add(z);
    }

    void compress()
    {
        double factor;
        expect(simulation_.compress(false, factor));
        add(factor);
        expect(simulation_.volume_moves(5, 1e-3 / measure_));
    }

    /// Inserts and removes particles with an activity, in units of one.
    void insert(double activity)
    {
        std::vector<Vector3> const axes{unit_ * Vector3{0.2, 0.25, 0.2}};
        double weight;
        expect(simulation_.insertion_weight(40, axes[0], weight));
        add(weight);
        std::array<double, 1> const activities{activity / measure_};
        std::array<std::int64_t, 4> counts;
        expect(simulation_.insertion_moves(80, axes, activities, counts));
        for (std::int64_t const count : counts) add(static_cast<double>(count));
        bool is_free;
        Vector3 const center = simulation_.system().num_particles == 0
                                   ? Vector3{0.0, 0.0, 0.0}
                                   : centers()[simulation_.system().num_particles - 1];
        expect(simulation_.insert(center + unit_ * Vector3{0.3, 0.3, 0.0}, {1.0, 0.0, 0.0, 0.0},
                                  axes[0], true, is_free));
        add(is_free);
    }

    void remove_all()
    {
        while (simulation_.system().num_particles > 0) expect(simulation_.remove(0));
    }

    void visit_neighbors()
    {
        for (std::size_t i = 0; i < simulation_.system().num_particles; ++i) {
            std::size_t count;
            std::vector<std::int32_t> particles(1000);
            std::vector<Vector3> separations(1000);
            expect(simulation_.neighbors(i, count, particles, {}, separations));
            for (std::size_t k = 0; k < count; ++k) {
                add(particles[k]);
                for (int d = 0; d < 3; ++d) add_length(separations[k][d]);
            }
            bool is_free;
            expect(simulation_.try_placement(i, centers()[i] + unit_ * Vector3{0.05, 0.05, 0.0},
                                             simulation_.quaternions()[i], true, is_free));
            add(is_free);
        }
    }

    /// Adds the state, and returns all numbers.
    std::vector<double> const &finish()
    {
        expect_no_overlap(simulation_);
        pw85_system const system = simulation_.system();
        for (std::size_t i = 0; i < system.num_particles; ++i) {
            for (int d = 0; d < 3; ++d) add_length(centers()[i][d]);
            for (int d = 0; d < 3; ++d) add_length(simulation_.semi_axes()[i][d]);
            for (int d = 0; d < 4; ++d) add(simulation_.quaternions()[i][d]);
        }
        for (int k = 0; k < 9; ++k) add_length(system.cell[k]);
        for (std::int64_t const count : simulation_.counts().accepted)
            add(static_cast<double>(count));
        return numbers_;
    }

  private:
    static void expect(Status status)
    {
        g_assert_cmpint(static_cast<int>(status), ==, PW85_SUCCESS);
    }

    Vector3 const *centers() const
    {
        return reinterpret_cast<Vector3 const *>(simulation_.system().centers);
    }

    void add(double x) { numbers_.push_back(x); }
    void add_length(double x) { numbers_.push_back(x / unit_); }

    double unit_, measure_; ///< of lengths; of volumes, or of areas
    HardEllipsoids simulation_;
    std::vector<double> numbers_;
};

/// Compares what some calls give in units of one and in others.
template <class Calls> void compare_units(System const &system, Calls const &calls)
{
    auto const numbers_in = [&](double unit) {
        Run run(system, unit);
        calls(run);
        return run.finish();
    };
    std::vector<double> const expected = numbers_in(1.0);
    for (int const exponent : exponents) {
        std::vector<double> const found = numbers_in(std::ldexp(1.0, exponent));
        g_assert_cmpuint(found.size(), ==, expected.size());
        for (std::size_t k = 0; k < found.size(); ++k)
            if (found[k] != expected[k])
                g_test_fail_printf("unit 2^%d: number %zu is %a instead of %a", exponent, k,
                                   found[k], expected[k]);
    }
}

PW85_TEST("/simulation_units/particles")
{
    for (System const &system : {sheared_space(), sheared_plane()})
        compare_units(system, [](Run &run) {
            run.move_particles();
            run.visit_neighbors();
            run.compress();
        });
}

PW85_TEST("/simulation_units/chains")
{
    for (System const &system : {sheared_space(), sheared_plane()})
        compare_units(system, [](Run &run) {
            run.run_chains();
            run.move_particles();
            run.run_chains();
        });
}

PW85_TEST("/simulation_units/insertions")
{
    for (System const &system : {sheared_space(), sheared_plane()})
        compare_units(system, [](Run &run) {
            run.insert(4.0);
            run.move_particles();
            run.insert(4.0);
        });
}

// An empty cell has no particles whose size could be the unit of the bins.
PW85_TEST("/simulation_units/empty")
{
    for (System const &system : {sheared_space(), sheared_plane()})
        compare_units(system, [](Run &run) {
            run.remove_all();
            run.insert(200.0);
            run.visit_neighbors();
        });
}

} // namespace
