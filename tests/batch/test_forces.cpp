// SPDX-License-Identifier: BSD-3-Clause
// Compares forces, torques and virial of a list with the derivative of the energy of the whole
// system. The bits are the same with any number of threads.
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <vector>

#include <glib.h>

#include <pw85/pw85.hpp>
#include <pw85/systems.hpp>

#include "../cases.hpp"
#include "../failures.hpp"
#include "../random_pairs.hpp"
#include "../systems.hpp"
#include "../threads.hpp"

using namespace pw85_tests;

namespace {

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
        system.centers.push_back(
            {random.uniform(0.0, 7.0), random.uniform(0.0, 7.0), random.uniform(0.0, 7.0)});
        system.q.push_back(random.form(size, 3.0));
    }
    g_assert_true(neighbors_create(system.particles(), {1.0, 0.3}, system.list) ==
                  pw85::Status::success);
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
        g_assert_true(contact_derivatives_pairs(system.list.list(), system.particles(),
                                                derivatives) == pw85::Status::success);
        for (std::size_t k = 0; k < n; ++k) {
            d_u[k] = mu2[k] < 1.0 ? 2.0 * (mu2[k] - 1.0) : 0.0;
            scalar_virial -= 2.0 * mu2[k] * d_u[k];
            if (d_u[k] == 0.0) d_r12[k][0] = std::numeric_limits<double>::quiet_NaN(); // left out
        }
        g_assert_true(contact_forces_pairs(system.list.list(), system.particles(), d_u, derivatives,
                                           {forces, torques, &virial}) == pw85::Status::success);
    }
};

/// The derivative of the energy by a central difference, whose error is of the order of the square
/// of the step.
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
            failures.check(std::fabs(force - sums.forces[i][d]) <= tolerance, "force",
                           sums.forces[i][d], force, none);
            double const torque =
                -slope(system, [=](System &s, double x) { s.q[i] = turned(s.q[i], d, x); });
            failures.check(std::fabs(torque - sums.torques[i][d]) <= tolerance, "torque",
                           sums.torques[i][d], torque, none);
        }
    for (std::size_t a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) {
            // Coordinates b grow by x times coordinates a.
            double const virial = -slope(system, [=](System &s, double x) {
                for (auto &c : s.centers) c[b] += x * c[static_cast<int>(a)];
                for (auto &row : s.cell) row[b] += x * row[static_cast<int>(a)];
            });
            failures.check(std::fabs(virial - sums.virial[a][b]) <= 10 * tolerance, "virial",
                           sums.virial[a][b], virial, none);
        }
    double const trace = sums.virial[0][0] + sums.virial[1][1] + sums.virial[2][2];
    failures.check(std::fabs(trace - sums.scalar_virial) <= 1e-11, "trace", trace,
                   sums.scalar_virial, none);
}

PW85_TEST("/forces/threads")
{
    System const system = make_system(400, 1.0);
    g_assert_cmpuint(system.list.pairs().size(), >, 5000);
    Threads const first(1);
    Forces const one(system);
    for (int const threads : {2, 3, 16}) {
        Threads const used(threads);
        Forces const many(system);
        g_assert_true(std::memcmp(one.forces.data(), many.forces.data(), 400 * sizeof(Vector3)) ==
                      0);
        g_assert_true(std::memcmp(one.torques.data(), many.torques.data(), 400 * sizeof(Vector3)) ==
                      0);
        g_assert_true(std::memcmp(&one.virial, &many.virial, sizeof one.virial) == 0);
    }
}

// Nothing is zero; what an output needs must be there; indices are checked.
PW85_TEST("/forces/arguments")
{
    double x[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, forces[6], torques[6], virial[9];
    std::int32_t const pairs[2] = {0, 1}, outside[2] = {0, 2};
    std::fill_n(forces, 6, 7.0);
    g_assert_cmpint(pw85_contact_forces_pairs(list_of(0, nullptr),
                                              system_of(2, nullptr, nullptr, nullptr), nullptr,
                                              nullptr, nullptr, nullptr, forces, torques, virial),
                    ==, PW85_SUCCESS);
    for (double const y : forces) g_assert_cmpfloat(y, ==, 0.0);
    for (double const y : virial) g_assert_cmpfloat(y, ==, 0.0);
    auto const call = [&](std::int32_t const *list, double const *c, double const *u,
                          double const *r, double const *turn, double const *cell) {
        return pw85_contact_forces_pairs(list_of(1, list), system_of(2, c, nullptr, cell), u, r,
                                         turn, x, forces, torques, virial);
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
    g_assert_cmpint(pw85_contact_forces_pairs(list_of(1, pairs), system_of(2, x, nullptr, nullptr),
                                              x, x, nullptr, nullptr, forces, nullptr, nullptr),
                    ==, PW85_SUCCESS);
}

/// A law, its energy and derivative in long double, and the relative error that its evaluation may
/// have, in units of u: some ten operations, and the exponents times the errors of what is raised
/// to them.
struct KnownLaw {
    char const *name;
    int kind;
    std::vector<double> parameters;
    std::function<long double(long double)> u, d_u;
    double errors;
};

/// The cubic polynomials with the values and derivatives of x³ at all points are x³.
std::vector<double> cubic_table(double begin, double end, int points)
{
    std::vector<double> all = {begin, end};
    for (int k = 0; k < points; ++k) {
        double const x = begin + (end - begin) * k / (points - 1);
        all.insert(all.end(), {x * x * x, 3.0 * x * x});
    }
    return all;
}

KnownLaw soft_repulsion(char const *name, double exponent)
{
    return {name,
            PW85_LAW_SOFT_REPULSION,
            {3.0, exponent},
            [=](long double x) {
                return x < 1 ? 3 / exponent * std::pow(1 - std::sqrt(x), (long double)exponent) : 0;
            },
            [=](long double x) {
                return x < 1 ? -1.5L * std::pow(1 - std::sqrt(x), (long double)exponent - 1) /
                                   std::sqrt(x)
                             : 0;
            },
            10.0 + 4.0 * exponent};
}

KnownLaw inverse_powers(char const *name, double n, double m, double cutoff)
{
    auto const u = [=](long double x) {
        return 4 * std::pow(x, -n / 2.0L) - 3 * std::pow(x, -m / 2.0L);
    };
    return {name,
            PW85_LAW_INVERSE_POWERS,
            {4.0, n, 3.0, m, cutoff},
            [=](long double x) { return x < cutoff ? u(x) - u(cutoff) : 0; },
            [=](long double x) {
                return x < cutoff ? (-2.0L * n * std::pow(x, -n / 2.0L) +
                                     1.5L * m * std::pow(x, -m / 2.0L)) /
                                        x
                                  : 0;
            },
            20.0 + 2.0 * n};
}

std::vector<KnownLaw> known_laws()
{
    // Of x³ the interpolation subtracts values of the order of 8, and derivatives of the order of
    // 12 times up to three.
    auto const cube = [](long double x) {
        return x < 0.25L ? 0.015625L + 0.1875L * (x - 0.25L) : x < 2 ? x * x * x : 0;
    };
    auto const slope = [](long double x) { return x < 0.25L ? 0.1875L : x < 2 ? 3 * x * x : 0; };
    return {soft_repulsion("harmonic", 2.0),
            soft_repulsion("Hertz", 2.5),
            soft_repulsion("constant", 1.0),
            soft_repulsion("irrational", 2.7),
            inverse_powers("Lennard-Jones", 12.0, 6.0, 2.0),
            inverse_powers("odd powers", 9.0, 5.0, 1.5),
            inverse_powers("irrational powers", 7.3, 3.1, 3.0),
            {"table", PW85_LAW_TABLE, cubic_table(0.25, 2.0, 8), cube, slope, 600.0},
            {"two points", PW85_LAW_TABLE, cubic_table(0.25, 2.0, 2), cube, slope, 600.0}};
}

/// One pair of spheres of radius `size` with μ² = x; forces along x.
struct OnePair {
    double energy, forces[6], torques[6], virial[9];

    OnePair(KnownLaw const &law, double x, double size)
    {
        double const centers[6] = {0, 0, 0, 2.0 * size * std::sqrt(x), 0, 0}, s = size * size;
        double const q[12] = {s, 0, 0, s, 0, s, s, 0, 0, s, 0, s};
        std::int32_t const pairs[2] = {0, 1};
        pw85_law const c_law = {law.kind, law.parameters.size(), law.parameters.data()};
        g_assert_cmpint(pw85_law_forces_pairs(list_of(1, pairs), system_of(2, centers, q, nullptr),
                                              &c_law, &energy, forces, torques, virial),
                        ==, PW85_SUCCESS);
    }
};

// Energies and forces of two spheres, for which μ² = x and its derivative is 2 sqrt(x)/(2 size);
// virial -2 x U'.
PW85_TEST("/forces/laws")
{
    Failures failures;
    for (KnownLaw const &law : known_laws())
        for (double const size : {1.0, 0x1p-40, 0x1p40})
            for (double x = 1.0 / 64.0; x < 4.0; x += 1.0 / 64.0) {
                OnePair const sums(law, x, size);
                auto const text = [&] {
                    return std::string(law.name) + ", mu2 = " + hex_text(&x, 1);
                };
                // Each μ² is rounded; near contact the relative change of 1 - μ is that over 1 - μ,
                // of order 64. U at the cutoff is of the order of the energies.
                double const tolerance = 0x1p-53 * (law.errors + 64.0 * 4.0);
                double const scale = std::fabs(static_cast<double>(law.d_u(x))) +
                                     std::fabs(static_cast<double>(law.u(x)));
                auto const check = [&](char const *what, double got, long double right) {
                    auto const wanted = static_cast<double>(right);
                    failures.check(std::fabs(got - wanted) <=
                                       tolerance * (scale + 10.0 * (x < 2.0)),
                                   what, got, wanted, text);
                };
                if (std::fabs(
                        x -
                        law.parameters[law.kind == PW85_LAW_TABLE ? 1
                                                                  : law.parameters.size() - 1]) <
                        1e-9 ||
                    x == 1.0)
                    continue; // the end of the law, on either side of which μ² may be rounded
                check("energy", sums.energy, law.u(x));
                check("force", sums.forces[3] * size,
                      -law.d_u(x) * std::sqrt(static_cast<long double>(x)));
                check("virial", sums.virial[0], -2.0L * x * law.d_u(x));
                failures.check(sums.forces[0] == -sums.forces[3], "opposite", sums.forces[0],
                               -sums.forces[3], text);
            }
}

/// Sums of a law, and the same sums in two steps from the same U', which one pair of each μ² gives.
PW85_TEST("/forces/law and two steps")
{
    System const system = make_system(400, 1.0);
    std::size_t const n = system.list.pairs().size();
    std::vector<double> mu2(n), d_u(n);
    std::vector<Vector3> d_r12(n), d_rot1(n), d_rot2(n);
    pw85::DerivativeSpans derivatives{mu2, {}, {}, {}, d_r12, d_rot1, d_rot2};
    g_assert_true(contact_derivatives_pairs(system.list.list(), system.particles(), derivatives) ==
                  pw85::Status::success);
    // U = 2 μ² is a table whose derivative is 2 without rounding errors; it ends beyond all pairs,
    // or at μ² = 1.
    for (double const end : {1024.0, 1.0}) {
        std::vector<double> const table = {0.0, end, 0.0, 2.0, 2.0 * end, 2.0};
        for (std::size_t k = 0; k < n; ++k) d_u[k] = mu2[k] < end ? 2.0 : 0.0;
        std::vector<Vector3> forces(400), torques(400), expected(400), turning(400);
        Matrix3 virial, expected_virial;
        double energy, expected_energy = 0.0, size = 0.0;
        for (std::size_t k = 0; k < n; ++k) expected_energy += mu2[k] < end ? 2.0 * mu2[k] : 0.0;
        g_assert_true(contact_forces_pairs(system.list.list(), system.particles(), d_u, derivatives,
                                           {expected, turning, &expected_virial}) ==
                      pw85::Status::success);
        g_assert_true(law_forces_pairs(system.list.list(), system.particles(),
                                       {PW85_LAW_TABLE, table}, energy,
                                       {forces, torques, &virial}) == pw85::Status::success);
        g_assert_true(std::memcmp(forces.data(), expected.data(), 400 * sizeof(Vector3)) == 0);
        g_assert_true(std::memcmp(torques.data(), turning.data(), 400 * sizeof(Vector3)) == 0);
        // Sums of n terms in another order: each term is at most 2 μ² and as large as their sum is.
        for (double const x : mu2) size += x < end ? 4.0 * x : 0.0;
        double const tolerance = 0x1p-53 * static_cast<double>(n) * size;
        g_assert_cmpfloat(std::fabs(energy - expected_energy), <=, tolerance);
        for (std::size_t i = 0; i < 3; ++i)
            for (int d = 0; d < 3; ++d)
                g_assert_cmpfloat(std::fabs(virial[i][d] - expected_virial[i][d]), <=,
                                  10.0 * tolerance);
    }
}

// The forces of a soft repulsion are the derivatives of its energy.
PW85_TEST("/forces/energy of a law")
{
    Failures failures;
    System system = make_system(60, 1.2);
    std::vector<double> const parameters = {2.0, 3.0};
    pw85::Law const law = {PW85_LAW_SOFT_REPULSION, parameters};
    auto const energy_of = [&](System const &moved, pw85::ForceSpans const &out) {
        double energy = 0.0;
        g_assert_true(law_forces_pairs(system.list.list(), moved.particles(), law, energy, out) ==
                      pw85::Status::success);
        return energy;
    };
    std::vector<Vector3> forces(60), torques(60);
    energy_of(system, {forces, torques});
    constexpr double step = 1e-5; // the error is that of test_energy()
    for (std::size_t i = 0; i < 60; i += 7)
        for (int d = 0; d < 3; ++d) {
            System low{system.centers, system.q, system.cell, {}},
                high{system.centers, system.q, system.cell, {}};
            low.centers[i][d] -= step;
            high.centers[i][d] += step;
            double const force = -(energy_of(high, {}) - energy_of(low, {})) / (2.0 * step);
            failures.check(std::fabs(force - forces[i][d]) <= 1e-6, "force", forces[i][d], force,
                           [] { return ""; });
            low = {system.centers, system.q, system.cell, {}};
            high = {system.centers, system.q, system.cell, {}};
            low.q[i] = turned(low.q[i], d, -step);
            high.q[i] = turned(high.q[i], d, step);
            double const torque = -(energy_of(high, {}) - energy_of(low, {})) / (2.0 * step);
            failures.check(std::fabs(torque - torques[i][d]) <= 1e-6, "torque", torques[i][d],
                           torque, [] { return ""; });
        }
}

PW85_TEST("/forces/threads of a law")
{
    constexpr std::size_t n = 800;
    System const system = make_system(n, 1.0);
    // so that blocks take the places of earlier ones
    g_assert_cmpuint(system.list.pairs().size(), >, 15000);
    struct Sums {
        std::vector<Vector3> forces = std::vector<Vector3>(n), torques = std::vector<Vector3>(n);
        Matrix3 virial;
        double energy;
    };
    for (KnownLaw const &law : known_laws()) {
        auto const sums = [&](int threads) {
            Threads const used(threads);
            Sums all;
            g_assert_true(law_forces_pairs(system.list.list(), system.particles(),
                                           {law.kind, law.parameters}, all.energy,
                                           {all.forces, all.torques, &all.virial}) ==
                          pw85::Status::success);
            return all;
        };
        Sums const one = sums(1);
        for (int const threads : {2, 3, 16}) {
            Sums const many = sums(threads);
            g_assert_true(std::memcmp(one.forces.data(), many.forces.data(), n * sizeof(Vector3)) ==
                          0);
            g_assert_true(
                std::memcmp(one.torques.data(), many.torques.data(), n * sizeof(Vector3)) == 0);
            g_assert_true(std::memcmp(&one.virial, &many.virial, sizeof one.virial) == 0);
            g_assert_cmpfloat(one.energy, ==, many.energy);
        }
    }
}

// Laws are checked before anything is written; bad pairs make their sums NaN; concentric ellipsoids
// have no force.
PW85_TEST("/forces/arguments of a law")
{
    double const x[6] = {0, 0, 0, 1, 0, 0}, same[6] = {},
                 q[12] = {1, 0, 0, 1, 0, 1, 1, 0, 0, 1, 0, 1};
    double const flat[12] = {1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 1};
    std::int32_t const pairs[2] = {0, 1};
    double energy = 7.0, forces[6], torques[6], virial[9];
    auto const call = [&](int kind, std::vector<double> const &parameters, double const *centers,
                          double const *forms) {
        pw85_law const law = {kind, parameters.size(), parameters.data()};
        return pw85_law_forces_pairs(list_of(1, pairs), system_of(2, centers, forms, nullptr), &law,
                                     &energy, forces, torques, virial);
    };
    double const nan = std::numeric_limits<double>::quiet_NaN(), infinity = HUGE_VAL;
    struct Wrong {
        int kind;
        std::vector<double> parameters;
    };
    for (Wrong const &wrong : std::vector<Wrong>{{0, {1, 2}},
                                                 {4, {1, 2}},
                                                 {PW85_LAW_SOFT_REPULSION, {1}},
                                                 {PW85_LAW_SOFT_REPULSION, {1, 2, 3}},
                                                 {PW85_LAW_SOFT_REPULSION, {1, 0.5}},
                                                 {PW85_LAW_SOFT_REPULSION, {nan, 2}},
                                                 {PW85_LAW_INVERSE_POWERS, {1, 6, 1, 6, 1}},
                                                 {PW85_LAW_INVERSE_POWERS, {1, 6, 1, 0, 1}},
                                                 {PW85_LAW_INVERSE_POWERS, {1, 12, 1, 6, 0}},
                                                 {PW85_LAW_INVERSE_POWERS, {1, 12, 1, 6, infinity}},
                                                 {PW85_LAW_TABLE, {0, 1, 1, 1}},
                                                 {PW85_LAW_TABLE, {0, 1, 1, 1, 1}},
                                                 {PW85_LAW_TABLE, {1, 1, 1, 1, 1, 1}},
                                                 {PW85_LAW_TABLE, {0, 1, 1, 1, nan, 1}}}) {
        g_assert_cmpint(call(wrong.kind, wrong.parameters, x, q), ==, PW85_EINVAL);
        g_assert_cmpfloat(energy, ==, 7.0);
    }
    for (KnownLaw const &law : known_laws()) {
        g_assert_cmpint(call(law.kind, law.parameters, x, flat), ==, PW85_ENOTPD);
        for (double const number : {energy, forces[0], forces[5], torques[2], virial[4]})
            g_assert_true(std::isnan(number));
        g_assert_cmpint(call(law.kind, law.parameters, same, q), ==, PW85_SUCCESS);
        for (double const force : forces) g_assert_cmpfloat(force, ==, 0.0);
        g_assert_false(std::isnan(energy));
    }
}

PW85_ADD_TEST("/forces/energy", test_energy);

} // namespace
