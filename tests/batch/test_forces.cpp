// Compares forces, torques and virial of a list with the derivative of the energy of the whole system. The bits are the same with
// any number of threads.
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <vector>

#include <glib.h>

#include <pw85/neighbors.hpp>
#include <pw85/pw85.hpp>

#include "../failures.hpp"
#include "../random_pairs.hpp"
#include "../systems.hpp"

#ifdef _OPENMP
#include <omp.h>
#endif

using namespace pw85_tests;

namespace {

using Vector3 = pw85::Vector<double, 3>;
using Form3 = pw85::SymmetricMatrix<double, 3>;
using Matrix3 = std::array<Vector3, 3>;

/// A system with its neighbours, and soft contacts: U = (1 - μ²)² for each pair that overlaps.
struct System {
    std::vector<Vector3> centers;
    std::vector<Form3> q;
    pw85::Cell cell{{{7.0, 0.0, 0.0}, {2.0, 6.0, 0.0}, {-1.0, 1.5, 8.0}}};
    pw85::Neighbors list;

    pw85::Particles particles() const { return {centers, q, &cell}; }

    double energy() const
    {
        std::vector<double> mu2(list.pairs().size());
        g_assert_true(contact_pairs(list.list(), particles(), mu2) == pw85::Status::success);
        double sum = 0.0;
        for (double const x : mu2) sum += x < 1.0 ? (1.0 - x) * (1.0 - x) : 0.0;
        return sum;
    }
};

System make_system(std::size_t n, double size)
{
    Random random(121);
    System system;
    for (std::size_t i = 0; i < n; ++i) {
        system.centers.push_back({random.uniform(0.0, 7.0), random.uniform(0.0, 7.0), random.uniform(0.0, 7.0)});
        system.q.push_back(random.form(size, 3.0));
    }
    g_assert_true(neighbors_create(system.particles(), {1.0, 0.3}, system.list) == pw85::Status::success);
    return system;
}

/// What the library sums up.
struct Forces {
    std::vector<Vector3> forces, torques;
    Matrix3 virial;
    double scalar_virial = 0.0; ///< Σ -2 μ² U'

    explicit Forces(System const &system) : forces(system.q.size()), torques(system.q.size())
    {
        std::size_t const n = system.list.pairs().size();
        std::vector<double> mu2(n), d_u(n);
        std::vector<Vector3> d_r12(n), d_rot1(n), d_rot2(n);
        pw85::DerivativeSpans derivatives;
        derivatives.mu2 = mu2;
        derivatives.d_r12 = d_r12;
        derivatives.d_rot1 = d_rot1;
        derivatives.d_rot2 = d_rot2;
        g_assert_true(contact_derivatives_pairs(system.list.list(), system.particles(), derivatives) ==
                      pw85::Status::success);
        for (std::size_t k = 0; k < n; ++k) {
            d_u[k] = mu2[k] < 1.0 ? 2.0 * (mu2[k] - 1.0) : 0.0;
            scalar_virial -= 2.0 * mu2[k] * d_u[k];
            if (d_u[k] == 0.0) d_r12[k][0] = std::numeric_limits<double>::quiet_NaN(); // left out
        }
        g_assert_true(contact_forces_pairs(system.list.list(), system.particles(), d_u, derivatives,
                                           {forces, torques, &virial}) == pw85::Status::success);
    }
};

/// The derivative of the energy by a central difference, whose error is of the order of the square of the step.
double slope(System &system, std::function<void(System &, double)> const &move)
{
    constexpr double step = 1e-5;
    System const before{system.centers, system.q, system.cell, {}};
    double energy[2];
    for (int side = 0; side < 2; ++side) {
        move(system, side == 0 ? -step : step);
        energy[side] = system.energy();
        system.centers = before.centers;
        system.q = before.q;
        system.cell = before.cell;
    }
    return (energy[1] - energy[0]) / (2.0 * step);
}

/// A form turned by a small angle about an axis.
Form3 turned(Form3 const &q, int axis, double angle)
{
    int const x = (axis + 1) % 3, y = (axis + 2) % 3;
    double const c = std::cos(angle), s = std::sin(angle);
    Form3 result = q;
    result(x, x) = c * c * q(x, x) - 2.0 * c * s * q(x, y) + s * s * q(y, y);
    result(y, y) = s * s * q(x, x) + 2.0 * c * s * q(x, y) + c * c * q(y, y);
    result(x, y) = c * s * (q(x, x) - q(y, y)) + (c * c - s * s) * q(x, y);
    result(axis, x) = c * q(axis, x) - s * q(axis, y);
    result(axis, y) = s * q(axis, x) + c * q(axis, y);
    return result;
}

// Forces, torques about each axis; and the virial, by a strain of the cell and the centres.
void test_energy()
{
    Failures failures;
    System system = make_system(60, 1.2);
    Forces const sums(system);
    double const tolerance =
        1e-6; // that of the differences, of energies of the order of 10 and their third derivatives
    auto const none = [] { return ""; };
    for (std::size_t i = 0; i < system.q.size(); i += 7)
        for (int d = 0; d < 3; ++d) {
            double const force = -slope(system, [=](System &s, double x) { s.centers[i][d] += x; });
            failures.check(std::fabs(force - sums.forces[i][d]) <= tolerance, "force", sums.forces[i][d], force, none);
            double const torque = -slope(system, [=](System &s, double x) { s.q[i] = turned(s.q[i], d, x); });
            failures.check(std::fabs(torque - sums.torques[i][d]) <= tolerance, "torque", sums.torques[i][d], torque,
                           none);
        }
    for (std::size_t a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) {
            // Coordinates b grow by x times coordinates a.
            double const virial = -slope(system, [=](System &s, double x) {
                for (auto &c : s.centers) c[b] += x * c[static_cast<int>(a)];
                for (auto &row : s.cell) row[b] += x * row[static_cast<int>(a)];
            });
            failures.check(std::fabs(virial - sums.virial[a][b]) <= 10 * tolerance, "virial", sums.virial[a][b], virial,
                           none);
        }
    double const trace = sums.virial[0][0] + sums.virial[1][1] + sums.virial[2][2];
    failures.check(std::fabs(trace - sums.scalar_virial) <= 1e-11, "trace", trace, sums.scalar_virial, none);
}

void test_threads()
{
#ifdef _OPENMP
    System const system = make_system(400, 1.0);
    g_assert_cmpuint(system.list.pairs().size(), >, 5000);
    omp_set_num_threads(1);
    Forces const one(system);
    for (int const threads : {2, 3, 16}) {
        omp_set_num_threads(threads);
        Forces const many(system);
        g_assert_true(std::memcmp(one.forces.data(), many.forces.data(), 400 * sizeof(Vector3)) == 0);
        g_assert_true(std::memcmp(one.torques.data(), many.torques.data(), 400 * sizeof(Vector3)) == 0);
        g_assert_true(std::memcmp(&one.virial, &many.virial, sizeof one.virial) == 0);
    }
#else
    g_test_skip("built without OpenMP");
#endif
}

// Nothing is zero; what an output needs must be there; indices are checked.
void test_arguments()
{
    double x[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, forces[6], torques[6], virial[9];
    std::int32_t const pairs[2] = {0, 1}, outside[2] = {0, 2};
    std::fill_n(forces, 6, 7.0);
    g_assert_cmpint(pw85_contact_forces_pairs(list_of(0, nullptr), system_of(2, nullptr, nullptr, nullptr), nullptr,
                                              nullptr, nullptr, nullptr, forces, torques, virial),
                    ==, PW85_SUCCESS);
    for (double const y : forces) g_assert_cmpfloat(y, ==, 0.0);
    for (double const y : virial) g_assert_cmpfloat(y, ==, 0.0);
    auto const call = [&](std::int32_t const *list, double const *c, double const *u, double const *r,
                          double const *turn, double const *cell) {
        return pw85_contact_forces_pairs(list_of(1, list), system_of(2, c, nullptr, cell), u, r, turn, x, forces,
                                         torques, virial);
    };
    forces[0] = 7.0;
    g_assert_cmpint(call(nullptr, x, x, x, x, nullptr), ==, PW85_EINVAL);
    g_assert_cmpint(call(outside, x, x, x, x, nullptr), ==, PW85_EINVAL);
    g_assert_cmpint(call(pairs, nullptr, x, x, x, nullptr), ==, PW85_EINVAL);
    g_assert_cmpint(call(pairs, x, nullptr, x, x, nullptr), ==, PW85_EINVAL);
    g_assert_cmpint(call(pairs, x, x, nullptr, x, nullptr), ==, PW85_EINVAL);
    g_assert_cmpint(call(pairs, x, x, x, nullptr, nullptr), ==, PW85_EINVAL);
    double const singular[9] = {};
    g_assert_cmpint(call(pairs, x, x, x, x, singular), ==, PW85_EINVAL);
    g_assert_cmpfloat(forces[0], ==, 7.0);
    g_assert_cmpint(call(pairs, x, x, x, x, nullptr), ==, PW85_SUCCESS);
    g_assert_cmpfloat(forces[0], ==, 1.0);
    g_assert_cmpfloat(forces[3], ==, -1.0);
    g_assert_cmpint(pw85_contact_forces_pairs(list_of(1, pairs), system_of(2, x, nullptr, nullptr), x, x, nullptr,
                                              nullptr, forces, nullptr, nullptr),
                    ==, PW85_SUCCESS);
}

} // namespace

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, nullptr);
    g_test_add_func("/forces/energy", test_energy);
    g_test_add_func("/forces/threads", test_threads);
    g_test_add_func("/forces/arguments", test_arguments);
    return g_test_run();
}
