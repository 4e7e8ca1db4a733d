// SPDX-License-Identifier: BSD-3-Clause
// Compares neighbour lists with all pairs and all images in a wider type. Tests bad input, and how
// long a list stays valid.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <random>
#include <set>
#include <vector>

#include <glib.h>

#include <pw85/systems.hpp>

#include "../cases.hpp"
#include "../draws.hpp"
#include "../failures.hpp"
#include "../random_pairs.hpp"
#include "../systems.hpp"
#include "../threads.hpp"

using namespace pw85_tests;

namespace {

using Wide = long double;
using pw85::Status;

constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                 infinity = std::numeric_limits<double>::infinity();
constexpr Form3 unit_sphere{1.0, 0.0, 0.0, 1.0, 0.0, 1.0};

struct System {
    std::vector<Vector3> centers;
    std::vector<Form3> q;
    bool has_cell = false;
    pw85::Cell cell{};
    std::array<int, 3> periodic = {1, 1, 1};
    pw85::NeighborOptions options;

    /// Without the cell where none of its vectors is periodic, which functions refuse.
    pw85::Particles particles() const
    {
        return {centers, q, is_periodic(0) || is_periodic(1) || is_periodic(2) ? &cell : nullptr,
                periodic};
    }
    bool is_periodic(std::size_t k) const { return has_cell && periodic[k] != 0; }

    void add(Vector3 const &center, Form3 const &form)
    {
        centers.push_back(center);
        q.push_back(form);
    }
};

/// A pair and its image, as a list has it.
struct Neighbor {
    pw85::IndexPair pair;
    pw85::Image image;
    auto operator<=>(Neighbor const &) const = default;
};

/// The pairs of a list, sorted; a duplicate would stay.
std::vector<Neighbor> sorted(pw85::Neighbors const &list)
{
    std::vector<Neighbor> result;
    for (std::size_t k = 0; k < list.pairs().size(); ++k)
        result.push_back(
            {list.pairs()[k], list.images().empty() ? pw85::Image{} : list.images()[k]});
    std::sort(result.begin(), result.end());
    return result;
}

/// How far apart the boxes of two particles are along the axis where they are farthest, skin
/// deducted.
Wide gap(System const &system, Neighbor const &n)
{
    auto const i = static_cast<std::size_t>(n.pair[0]), j = static_cast<std::size_t>(n.pair[1]);
    Wide largest = -std::numeric_limits<Wide>::infinity();
    for (int d = 0; d < 3; ++d) {
        Wide r = static_cast<Wide>(system.centers[j][d]) - system.centers[i][d];
        for (std::size_t k = 0; k < 3 && system.has_cell; ++k)
            r += static_cast<Wide>(n.image[k]) * system.cell[k][d];
        Wide const reach = std::sqrt(static_cast<Wide>(system.q[i](d, d))) +
                           std::sqrt(static_cast<Wide>(system.q[j](d, d)));
        largest =
            std::max(largest, std::fabs(r) - system.options.scale * reach - system.options.skin);
    }
    return largest;
}

using WideVector = pw85::Vector<Wide, 3>;

/// x less its part along y.
WideVector across(WideVector x, WideVector const &y)
{
    Wide const part = pw85::dot(x, y) / pw85::dot(y, y);
    for (int d = 0; d < 3; ++d) x[d] -= part * y[d];
    return x;
}

/// The dual basis of the periodic vectors, in the space that they span; zero for the others.
std::array<WideVector, 3> dual(System const &system)
{
    std::array<WideVector, 3> result{};
    for (std::size_t k = 0; k < 3; ++k) {
        if (!system.is_periodic(k)) continue;
        WideVector vectors[3]; // number k, and the others, if they are periodic
        int count = 0;
        for (std::size_t const l : {k, (k + 1) % 3, (k + 2) % 3})
            for (int d = 0; d < 3 && system.is_periodic(l); count += d == 2, ++d)
                vectors[count][d] = system.cell[l][d];
        if (count == 3) vectors[2] = across(vectors[2], vectors[1]);
        for (int l = 1; l < count; ++l) vectors[0] = across(vectors[0], vectors[l]);
        result[k] = 1 / pw85::dot(vectors[0], vectors[0]) * vectors[0];
    }
    return result;
}

/// The first and the last multiple of each vector that can bring j near enough to i.
struct Multiples {
    int first[3], last[3];
};

Multiples multiples(System const &system, std::array<WideVector, 3> const &dual, std::size_t i,
                    std::size_t j)
{
    Multiples result;
    Wide reach = system.options.skin;
    for (int d = 0; d < 3; ++d)
        reach +=
            system.options.scale * (std::sqrt(system.q[i](d, d)) + std::sqrt(system.q[j](d, d)));
    for (std::size_t k = 0; k < 3; ++k) {
        Wide middle = 0;
        for (int d = 0; d < 3; ++d)
            middle -= dual[k][d] * (static_cast<Wide>(system.centers[j][d]) - system.centers[i][d]);
        Wide const length = std::sqrt(pw85::dot(dual[k], dual[k])) * reach + 1e-6L;
        result.first[k] = static_cast<int>(std::ceil(middle - length));
        result.last[k] = static_cast<int>(std::floor(middle + length));
    }
    return result;
}

/// Everything that can be near, each pair once.
template <class Visit> void visit_all(System const &system, Visit visit)
{
    auto const basis = dual(system);
    for (std::size_t i = 0; i < system.q.size(); ++i)
        for (std::size_t j = i; j < system.q.size(); ++j) {
            auto const m = multiples(system, basis, i, j);
            for (int a = m.first[0]; a <= m.last[0]; ++a)
                for (int b = m.first[1]; b <= m.last[1]; ++b)
                    for (int c = m.first[2]; c <= m.last[2]; ++c) {
                        if (i == j && std::array{a, b, c} <= std::array{0, 0, 0}) continue;
                        visit(Neighbor{{static_cast<int>(i), static_cast<int>(j)}, {a, b, c}});
                    }
        }
}

std::string text(System const &system, Neighbor const &n)
{
    std::string result = "pair " + std::to_string(n.pair[0]) + ' ' + std::to_string(n.pair[1]) +
                         " image " + std::to_string(n.image[0]) + ' ' + std::to_string(n.image[1]) +
                         ' ' + std::to_string(n.image[2]);
    for (std::int32_t const i : n.pair) {
        auto const k = static_cast<std::size_t>(i);
        result +=
            "\n  " + hex_text(system.centers[k].coordinates, 3) + hex_text(system.q[k].entries, 6);
    }
    for (auto const &row : system.cell) result += "\n  " + hex_text(row.coordinates, 3);
    return result;
}

/// Compares a list with all that there can be; returns the number of its pairs. Pairs whose gap is
/// nothing but rounding may be there or not.
std::size_t check(Failures &failures, System const &system)
{
    pw85::Neighbors list;
    Status const status = neighbors_create(system.particles(), system.options, list);
    failures.check(status == Status::success, "status", static_cast<double>(status), 0,
                   [] { return ""; });
    auto const actual = sorted(list);
    double largest = 0.0;
    for (auto const &c : system.centers)
        largest = std::max({largest, std::fabs(c[0]), std::fabs(c[1]), std::fabs(c[2])});
    double const rounding = 0x1p-40 * (largest + 1.0);
    std::vector<Neighbor> expected;
    visit_all(system, [&](Neighbor const &n) {
        Wide const g = gap(system, n);
        bool const listed = std::binary_search(actual.begin(), actual.end(), n);
        if (listed) expected.push_back(n);
        auto const describe = [&] { return text(system, n); };
        failures.check(listed ? g <= rounding : g > 0, listed ? "superfluous" : "missing",
                       static_cast<double>(g), 0, describe);
    });
    std::sort(expected.begin(), expected.end());
    failures.check(expected == actual, "pairs that are twice there, or in another form",
                   static_cast<double>(actual.size()), static_cast<double>(expected.size()),
                   [] { return ""; });
    return actual.size();
}

enum class Kind { none, rectangular, triclinic, skewed };

/// A cell with sides of about `side`.
pw85::Cell random_cell(Random &random, Kind kind, double side)
{
    pw85::Cell cell{};
    for (std::size_t k = 0; k < 3; ++k)
        cell[k][static_cast<int>(k)] = side * random.uniform(0.5, 1.5);
    if (kind == Kind::rectangular) return cell;
    for (std::size_t k = 0; k < 3; ++k)
        for (int d = 0; d < 3; ++d) cell[k][d] += side * random.uniform(-0.3, 0.3);
    if (kind == Kind::triclinic) return cell;
    for (std::size_t const k : {std::size_t{1}, std::size_t{2}})
        for (int d = 0; d < 3; ++d)
            cell[k][d] += std::round(random.uniform(-3.0, 3.0)) * cell[k - 1][d];
    return cell;
}

System random_system(Random &random, std::size_t n, Kind kind, double side)
{
    System system;
    system.has_cell = kind != Kind::none;
    if (system.has_cell) system.cell = random_cell(random, kind, side);
    for (int &periodic : system.periodic) periodic = random.uniform(0.0, 1.0) < 0.7;
    system.options.scale = random.log_uniform(0.5, 2.0);
    system.options.skin = random.sign() > 0.0 ? 0.0 : random.uniform(0.0, 0.5);
    for (std::size_t i = 0; i < n; ++i) {
        Vector3 center;
        for (int d = 0; d < 3; ++d) center[d] = side * random.uniform(-1.0, 1.0);
        system.add(center, random.form(1.0, random.log_uniform(1.0, 20.0)));
    }
    return system;
}

// Every kind of cell, smaller and larger than the particles, periodic along any of its vectors;
// centres outside of it, too.
PW85_TEST("/neighbors/brute_force")
{
    Failures failures;
    Random random(101);
    std::size_t pairs = 0, systems = 0;
    for (Kind const kind : {Kind::none, Kind::rectangular, Kind::triclinic, Kind::skewed})
        for (double const side : {1.0, 3.0, 10.0})
            for (std::size_t const n : std::initializer_list<std::size_t>{0, 1, 2, 7, 40}) {
                if (side < 2.0 && n > 7) continue;
                for (int repeat = 0; repeat < draws(n < 40 ? 6 : 2); ++repeat, ++systems)
                    pairs += check(failures, random_system(random, n, kind, side));
            }
    g_test_message("%zu pairs in %zu systems", pairs, systems);
    g_assert_cmpint(static_cast<int>(pairs), >, draws(10000));
}

// Enough for several tasks and levels.
PW85_TEST("/neighbors/many")
{
    Failures failures;
    Random random(102);
    for (Kind const kind : {Kind::none, Kind::rectangular}) {
        System system = random_system(random, 1500, kind, 25.0);
        system.options = {1.0, 0.1};
        g_assert_cmpuint(check(failures, system), >, 100);
    }
}

/// Ellipsoids on a lattice with vectors of length one, whose boxes meet along the first axis alone,
/// numbered at random.
System rods_on_a_lattice(int side)
{
    System system;
    system.has_cell = true;
    for (std::size_t k = 0; k < 3; ++k) system.cell[k][static_cast<int>(k)] = side;
    for (int i = 0; i < side * side * side; ++i)
        system.add({double(i / side / side), double(i / side % side), double(i % side)},
                   {0.36, 0, 0, 0.16, 0, 0.16});
    std::mt19937_64 shuffle(107);
    std::shuffle(system.centers.begin(), system.centers.end(), shuffle);
    return system;
}

/// The one that follows in a row of rods on a lattice; the first of its image in the next cell
/// after the last.
Neighbor next_in_row(std::vector<std::int32_t> const &number_at, int side, int k)
{
    int const plane = side * side;
    std::int32_t const i = number_at[static_cast<std::size_t>(k)],
                       j = number_at[static_cast<std::size_t>((k + plane) % (plane * side))];
    std::int32_t const image = k / plane == side - 1 ? 1 : 0;
    return i < j ? Neighbor{{i, j}, {image, 0, 0}} : Neighbor{{j, i}, {-image, 0, 0}};
}

// More than what threads find before they add it to the list, which so has to grow, and parts of
// space.
PW85_TEST("/neighbors/growing")
{
    Threads const one(1);
    constexpr int side = 52;
    System const system = rods_on_a_lattice(side);
    std::vector<std::int32_t> number_at(system.centers.size());
    for (std::size_t i = 0; i < number_at.size(); ++i) {
        Vector3 const &x = system.centers[i];
        number_at[static_cast<std::size_t>((x[0] * side + x[1]) * side + x[2])] =
            static_cast<std::int32_t>(i);
    }
    std::vector<Neighbor> expected;
    for (int k = 0; k < side * side * side; ++k)
        expected.push_back(next_in_row(number_at, side, k));
    std::sort(expected.begin(), expected.end());
    pw85::Neighbors list;
    g_assert_true(neighbors_create(system.particles(), system.options, list) == Status::success);
    g_assert_true(sorted(list) == expected);
}

// Sizes that differ by 10⁴, and crowds in a vast space.
PW85_TEST("/neighbors/sizes")
{
    Failures failures;
    Random random(103);
    System system;
    for (std::size_t i = 0; i < 1500; ++i) {
        double const spread = i % 3 == 0 ? 1e-6 : 1.0;
        Vector3 center;
        for (int d = 0; d < 3; ++d) center[d] = 10.0 + spread * random.uniform(-1.0, 1.0);
        system.add(center, random.form(i % 100 == 0 ? 0.2 : random.log_uniform(2e-5, 0.1), 5.0));
    }
    system.add({1e9, -1e9, 1e9}, unit_sphere);
    g_assert_cmpuint(check(failures, system), >, 10000);
}

// Boxes that touch exactly are pairs, as they are after many cells.
PW85_TEST("/neighbors/touching")
{
    System system;
    system.add({0.0, 0.0, 0.0}, unit_sphere);
    system.add({2.0, 2.0, -2.0}, unit_sphere);
    pw85::Neighbors list;
    g_assert_true(neighbors_create(system.particles(), {}, list) == Status::success);
    g_assert_cmpuint(list.pairs().size(), ==, 1);
    g_assert_true(list.images().empty());
    system.centers[1][0] = 2.0 + 0x1p-40;
    g_assert_true(neighbors_create(system.particles(), {}, list) == Status::success);
    g_assert_cmpuint(list.pairs().size(), ==, 0);
    system.has_cell = true;
    system.cell = {{{4.0, 0.0, 0.0}, {0.0, 8.0, 0.0}, {0.0, 0.0, 8.0}}};
    system.centers[1] = {2.0 + 4.0e6, 0.5 - 8.0e6, 0.0};
    g_assert_true(neighbors_create(system.particles(), {}, list) == Status::success);
    std::vector<Neighbor> const expected{{{0, 1}, {-1000001, 1000000, 0}},
                                         {{0, 1}, {-1000000, 1000000, 0}}};
    g_assert_true(sorted(list) == expected);
    // Boxes that meet by less than the rounding of the products with the cell's side, which are
    // exact in the wider type.
    Random random(106);
    int met = 0;
    for (int trial = 0; trial < draws(1000); ++trial) {
        double const side = 5.0 + std::floor(random.uniform(0.0, 0x1p40)) * 0x1p-40,
                     n = std::floor(random.uniform(1e5, 5e5));
        system.cell[0][0] = side;
        system.centers[0][0] = std::floor(random.uniform(0.0, 0x1p40)) * 0x1p-40;
        system.centers[1][0] =
            static_cast<double>(2.0L + system.centers[0][0] - static_cast<Wide>(n) * side);
        Neighbor const touching{{0, 1}, {static_cast<std::int32_t>(n), 1000000, 0}};
        if (gap(system, touching) > 0) continue;
        ++met;
        g_assert_true(neighbors_create(system.particles(), {}, list) == Status::success);
        g_assert_true(sorted(list) == std::vector{touching});
    }
    g_assert_cmpint(met, >, draws(300));
}

// The same bytes from any number of threads.
PW85_TEST("/neighbors/threads")
{
    Random random(104);
    System const system = random_system(random, 20000, Kind::triclinic, 30.0);
    pw85::Neighbors one;
    Threads const first(1);
    g_assert_true(neighbors_create(system.particles(), system.options, one) == Status::success);
    g_assert_cmpuint(one.pairs().size(), >, 10000);
    for (int const threads : {2, 3, 7}) {
        pw85::Neighbors many;
        Threads const used(threads);
        g_assert_true(neighbors_create(system.particles(), system.options, many) ==
                      Status::success);
        g_assert_true(std::ranges::equal(one.pairs(), many.pairs()));
        g_assert_true(std::ranges::equal(one.images(), many.images()));
    }
}

// Particles that move and turn within the skin bring no new pair; those that leave it are noticed.
PW85_TEST("/neighbors/holds")
{
    Failures failures;
    Random random(105);
    int counts[2] = {};
    for (int trial = 0; trial < 60; ++trial) {
        System system = random_system(random, 30, Kind::triclinic, 5.0);
        system.periodic = {1, 1, 0};
        system.options = {1.0, 0.4};
        pw85::Neighbors list;
        g_assert_true(neighbors_create(system.particles(), system.options, list) ==
                      Status::success);
        auto const before = sorted(list);
        double const step = trial % 3 == 0 ? 0.21 : 0.15;
        for (std::size_t i = 0; i < system.q.size(); ++i) {
            for (int d = 0; d < 3; ++d) system.centers[i][d] += step * random.uniform(-1.0, 1.0);
            for (int k = 0; k < 6; ++k) system.q[i][k] *= 1.02;
        }
        int holds = 7;
        g_assert_true(neighbors_holds(list, system.particles(), holds) == Status::success);
        ++counts[holds];
        if (holds == 0) continue;
        system.options.skin = 0.0;
        visit_all(system, [&](Neighbor const &n) {
            if (gap(system, n) <= 0)
                failures.check(std::binary_search(before.begin(), before.end(), n), "new pair", 0,
                               0, [&] { return text(system, n); });
        });
    }
    g_assert_cmpint(counts[0], >, 5);
    g_assert_cmpint(counts[1], >, 5);
}

using Matrix = double[3][3];

Vector3 product(Matrix const &f, Vector3 const &x)
{
    Vector3 y = {0.0, 0.0, 0.0};
    for (int d = 0; d < 3; ++d)
        for (int e = 0; e < 3; ++e) y[d] += f[d][e] * x[e];
    return y;
}

enum class Change { shrunk, grown, sheared, turned, any };

/// How a system changes with a parameter t: the cell, and with it the centres, about a point, or
/// nothing but the cell; each particle moves and grows besides.
struct Course {
    Change change;
    bool centers_follow, particles_move;
    Vector3 about;
    Matrix rate;
    std::vector<Vector3> velocities;

    Course(Random &random, Change kind, bool follow, std::size_t n)
        : change(kind), centers_follow(follow), rate{}
    {
        for (int d = 0; d < 3; ++d) {
            about[d] = random.uniform(-5.0, 5.0);
            for (int e = 0; e < 3; ++e)
                if (change == Change::any) rate[d][e] = random.uniform(-1.0, 1.0);
            if (change == Change::shrunk || change == Change::grown)
                rate[d][d] = change == Change::grown ? 1.0 : -1.0;
        }
        if (change == Change::sheared || change == Change::turned) rate[0][1] = random.sign();
        particles_move = random.sign() > 0.0;
        for (std::size_t i = 0; i < n; ++i)
            velocities.push_back(
                {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)});
    }

    System at(double t, System system) const
    {
        Matrix f;
        for (int d = 0; d < 3; ++d)
            for (int e = 0; e < 3; ++e) f[d][e] = (d == e ? 1.0 : 0.0) + t * rate[d][e];
        if (change == Change::turned) {
            f[0][0] = f[1][1] = std::cos(t);
            f[0][1] = rate[0][1] * std::sin(t);
            f[1][0] = -f[0][1];
        }
        for (auto &row : system.cell) row = product(f, row);
        for (std::size_t i = 0; i < system.q.size(); ++i) move(i, t, f, system);
        return system;
    }

  private:
    void move(std::size_t i, double t, Matrix const &f, System &system) const
    {
        Vector3 &center = system.centers[i];
        Vector3 from = center;
        for (int d = 0; d < 3; ++d) from[d] -= about[d];
        Vector3 const image = product(f, from);
        for (int d = 0; d < 3; ++d) {
            if (centers_follow) center[d] = about[d] + image[d];
            if (particles_move) center[d] += t * velocities[i][d];
        }
        if (change == Change::turned) system.q[i] = turned(f, system.q[i]);
        for (int k = 0; k < 6 && particles_move; ++k) system.q[i][k] *= 1.0 + 0.1 * t;
    }

    /// f q fᵀ
    static Form3 turned(Matrix const &f, Form3 const &q)
    {
        Form3 result{};
        for (int d = 0; d < 3; ++d)
            for (int e = d; e < 3; ++e)
                for (int k = 0; k < 9; ++k)
                    result(d, e) += f[d][k / 3] * q(k / 3, k % 3) * f[e][k % 3];
        return result;
    }
};

bool holds_now(pw85::Neighbors const &list, System const &system)
{
    int holds = 7;
    g_assert_true(neighbors_holds(list, system.particles(), holds) == Status::success);
    g_assert_true(holds == 0 || holds == 1);
    return holds == 1;
}

/// The last t of a course, before the cell is all too small, at which a list is found to hold.
double last_held(pw85::Neighbors const &list, System const &system, Course const &course)
{
    double held = 0.0, first = 0.7;
    for (int step = 0; step < 20; ++step) {
        double const t = 0.5 * (held + first);
        (holds_now(list, course.at(t, system)) ? held : first) = t;
    }
    return held;
}

/// Every pair whose boxes meet must be in a list that holds, after changes of the cell, too.
void check_held(Failures &failures, pw85::Neighbors const &list, System const &then, System now,
                double t)
{
    auto const before = sorted(list);
    now.options.skin = 0.0;
    visit_all(now, [&](Neighbor const &n) {
        if (gap(now, n) <= 0)
            failures.check(std::binary_search(before.begin(), before.end(), n),
                           "missing after a change", t, 0,
                           [&] { return text(then, n) + "\nnow " + text(now, n); });
    });
}

// Cells that shrink, grow, are sheared and turned, with the centres and without them: as far as the
// list holds nothing is missing.
PW85_TEST("/neighbors/holds_cell")
{
    Failures failures;
    Random random(108);
    for (Kind const kind : {Kind::rectangular, Kind::triclinic, Kind::skewed})
        for (Change const change :
             {Change::shrunk, Change::grown, Change::sheared, Change::turned, Change::any})
            for (int repeat = 0; repeat < draws(16); ++repeat) {
                System system = random_system(random, 12, kind, repeat % 4 < 2 ? 2.0 : 4.0);
                system.options.skin = random.uniform(0.1, 2.0);
                Course const course(random, change, repeat % 2 == 0, system.q.size());
                pw85::Neighbors list;
                g_assert_true(neighbors_create(system.particles(), system.options, list) ==
                              Status::success);
                g_assert_true(holds_now(list, system));
                double const t = last_held(list, system, course);
                g_assert_cmpfloat(t, >, 0.0);
                check_held(failures, list, system, course.at(t, system), t);
            }
}

// A large cell that shrinks with its centres, about whatever point, takes no more of the skin than
// its particles become larger by comparison: half-widths are 1, half the skin is 0.1.
PW85_TEST("/neighbors/holds_scaled")
{
    Random random(109);
    System system;
    system.has_cell = true;
    system.cell = {{{1000.0, 0.0, 0.0}, {200.0, 1000.0, 0.0}, {0.0, -300.0, 1000.0}}};
    system.options.skin = 0.2;
    for (int i = 0; i < 1000; ++i)
        system.add({random.uniform(0.0, 1e3), random.uniform(0.0, 1e3), random.uniform(0.0, 1e3)},
                   unit_sphere);
    pw85::Neighbors list;
    g_assert_true(neighbors_create(system.particles(), system.options, list) == Status::success);
    for (auto const &[t, expected] :
         {std::pair{1.0 / 11.0 - 1e-9, true}, {1.0 / 11.0 + 1e-9, false}}) {
        Course course(random, Change::shrunk, true, system.q.size());
        course.particles_move = false;
        g_assert_true(holds_now(list, course.at(t, system)) == expected);
        course.centers_follow = false;
        g_assert_false(holds_now(list, course.at(t, system)));
    }
}

// Two spheres that met no image in a cell of side 6 meet several in one of side 5.
PW85_TEST("/neighbors/holds_smaller_cell")
{
    System system;
    for (int i = 0; i < 2; ++i)
        system.add({3.0 * i, 3.0 * i, 0.0}, {1.44, 0.0, 0.0, 1.44, 0.0, 1.44});
    system.has_cell = true;
    system.options.skin = 0.4;
    for (std::size_t k = 0; k < 3; ++k) system.cell[k][static_cast<int>(k)] = 6.0;
    pw85::Neighbors list;
    g_assert_true(neighbors_create(system.particles(), system.options, list) == Status::success);
    g_assert_cmpuint(list.pairs().size(), ==, 0);
    g_assert_true(holds_now(list, system));
    System small = system;
    for (std::size_t k = 0; k < 3; ++k) small.cell[k][static_cast<int>(k)] = 5.0;
    g_assert_false(holds_now(list, small));
    int holds = 7;
    for (double const bad : {nan, infinity, 0.0}) {
        small.cell[1][1] = bad;
        g_assert_true(neighbors_holds(list, small.particles(), holds) == Status::invalid_argument &&
                      holds == -1);
    }
    small.has_cell = false;
    g_assert_true(neighbors_holds(list, small.particles(), holds) == Status::invalid_argument &&
                  holds == -1);
    g_assert_true(neighbors_create(small.particles(), small.options, list) == Status::success);
    g_assert_true(neighbors_holds(list, system.particles(), holds) == Status::invalid_argument &&
                  holds == -1);
}

// A list does not see where all particles are, nor take motion beyond the range of numbers for one
// that they share.
PW85_TEST("/neighbors/holds_shared_motion")
{
    Random random(110);
    System system = random_system(random, 5000, Kind::none, 30.0);
    system.options = {1.0, 0.4};
    pw85::Neighbors list;
    g_assert_true(neighbors_create(system.particles(), system.options, list) == Status::success);
    System moved = system;
    for (auto &center : moved.centers) center[1] += 1e6;
    g_assert_true(holds_now(list, moved));
    moved.centers[4567][1] -= 0.21;
    g_assert_true(holds_now(list, moved));
    moved.centers[2345][1] += 0.21;
    g_assert_false(holds_now(list, moved));
    system.q = moved.q = {unit_sphere, unit_sphere};
    system.centers.assign(2, {0.0, -1.7e308, 0.0});
    moved.centers.assign(2, {0.0, 1.7e308, 0.0});
    g_assert_true(neighbors_create(system.particles(), system.options, list) == Status::success);
    g_assert_false(holds_now(list, moved));
}

// Turning alone can take a particle out of its box.
PW85_TEST("/neighbors/holds_turned")
{
    System system;
    system.add({0.0, 0.0, 0.0}, {9.0, 0.0, 0.0, 1.0, 0.0, 1.0});
    system.options.skin = 1.0;
    pw85::Neighbors list;
    g_assert_true(neighbors_create(system.particles(), system.options, list) == Status::success);
    int holds = 7;
    for (auto const &[length, expected] : {std::pair{1.0, 1}, {1.5, 1}, {1.5 + 0x1p-40, 0}}) {
        system.q[0] = {9.0, 0.0, 0.0, length * length, 0.0, 1.0};
        g_assert_true(neighbors_holds(list, system.particles(), holds) == Status::success);
        g_assert_cmpint(holds, ==, expected);
    }
    system.add({9.0, 0.0, 0.0}, unit_sphere);
    g_assert_true(neighbors_holds(list, system.particles(), holds) ==
                  Status::invalid_argument); // another system's list
    g_assert_cmpint(holds, ==, -1);
    system.centers = {{nan, 0.0, 0.0}};
    system.q.resize(1);
    g_assert_true(neighbors_holds(list, system.particles(), holds) == Status::invalid_argument);
    g_assert_cmpint(holds, ==, -1);
}

/// The status of a system and the particle that is to blame.
void expect(System const &system, Status expected, std::size_t expected_particle)
{
    pw85::Neighbors list;
    std::size_t particle = 77;
    g_assert_cmpint(static_cast<int>(neighbors_create(system.particles(), system.options, list)),
                    ==, static_cast<int>(expected));
    g_assert_true(list.get() == nullptr);
    g_assert_true(neighbors_check(system.particles(), system.options, particle) == expected);
    g_assert_cmpuint(particle, ==, expected_particle);
}

System three_spheres()
{
    System system;
    for (int i = 0; i < 3; ++i) system.add({3.0 * i, 0.0, 0.0}, unit_sphere);
    system.has_cell = true;
    system.cell = {{{9.0, 0.0, 0.0}, {0.0, 9.0, 0.0}, {0.0, 0.0, 9.0}}};
    return system;
}

PW85_TEST("/neighbors/bad_particles")
{
    for (double const bad : {nan, infinity, -infinity, 1e300}) {
        System system = three_spheres();
        system.centers[1][2] = bad;
        expect(system, Status::invalid_argument, 1);
    }
    for (Form3 const &form :
         {Form3{}, Form3{1.0, 2.0, 0.0, 1.0, 0.0, 1.0}, Form3{1.0, 0.0, 0.0, -1.0, 0.0, 1.0}}) {
        System system = three_spheres();
        system.q[2] = form;
        expect(system, Status::not_positive_definite, 2);
        system.q[0][5] = nan;
        expect(system, Status::invalid_argument, 0);
    }
    System system = three_spheres();
    system.q[1] = {1e300, 0.0, 0.0, 1e300, 0.0, 1e300};
    system.options.scale = 1e200;
    expect(system, Status::invalid_argument, 1);
}

PW85_TEST("/neighbors/bad_cells")
{
    System system = three_spheres();
    for (Vector3 const &row : {Vector3{}, Vector3{nan, 0.0, 0.0}, Vector3{9.0, 0.0, 0.0},
                               Vector3{infinity, 0.0, 0.0}, Vector3{9.0, 9.0, 0.0}}) {
        system.cell[2] = row;
        system.periodic = {1, 1, 1};
        expect(system, Status::invalid_argument, 3);
        system.periodic = {0, 0, 1};
        if (!(std::isfinite(row[0]) && row[0] > 0.0)) expect(system, Status::invalid_argument, 3);
        system.periodic = {1, 1, 0}; // the third does not matter
        pw85::Neighbors list;
        g_assert_true(neighbors_create(system.particles(), system.options, list) ==
                      Status::success);
    }
}

// Options out of range, null pointers, counts that overflow; images beyond the numbers that there
// are.
PW85_TEST("/neighbors/arguments")
{
    for (double const bad : {0.0, -1.0, nan, infinity}) {
        System system = three_spheres();
        system.options.scale = bad;
        expect(system, Status::invalid_argument, 3);
        if (bad == 0.0) continue;
        system.options = {1.0, bad};
        expect(system, Status::invalid_argument, 3);
    }
    double const x[6] = {1.0, 0.0, 0.0, 1.0, 0.0, 1.0};
    pw85_neighbors *list = reinterpret_cast<pw85_neighbors *>(&list);
    int holds = 7;
    std::size_t particle = 7;
    for (int missing = 0; missing < 3; ++missing) {
        std::size_t const n = missing == 2 ? std::size_t{1} << 31 : 1;
        double const *const centers = missing == 0 ? nullptr : x, *const q =
                                                                      missing == 1 ? nullptr : x;
        g_assert_cmpint(pw85_neighbors_create(system_of(n, centers, q, nullptr), 1.0, 0.0, &list),
                        ==, PW85_EINVAL);
        g_assert_null(list);
        g_assert_cmpint(
            pw85_neighbors_check(system_of(n, centers, q, nullptr), 1.0, 0.0, &particle), ==,
            PW85_EINVAL);
        g_assert_cmpuint(particle, ==, n);
    }
    g_assert_cmpint(pw85_neighbors_create(system_of(1, x, x, nullptr), 1.0, 0.0, nullptr), ==,
                    PW85_EINVAL);
    g_assert_cmpint(pw85_neighbors_check(system_of(1, x, x, nullptr), 1.0, 0.0, nullptr), ==,
                    PW85_EINVAL);
    g_assert_cmpint(pw85_neighbors_holds(nullptr, system_of(1, x, x, nullptr), &holds), ==,
                    PW85_EINVAL);
    g_assert_cmpint(holds, ==, -1);
    g_assert_cmpint(pw85_neighbors_create(system_of(1, x, x, nullptr), 1.0, 0.0, &list), ==,
                    PW85_SUCCESS);
    g_assert_cmpint(pw85_neighbors_holds(list, system_of(1, x, x, nullptr), nullptr), ==,
                    PW85_EINVAL);
    g_assert_cmpint(pw85_neighbors_holds(list, system_of(1, nullptr, x, nullptr), &holds), ==,
                    PW85_EINVAL);
    g_assert_cmpint(pw85_neighbors_holds(list, system_of(1, x, x, nullptr), &holds), ==,
                    PW85_SUCCESS);
    g_assert_cmpint(holds, ==, 1);
    pw85_neighbors_destroy(list);
    pw85_neighbors_destroy(nullptr);
    g_assert_cmpuint(pw85_neighbors_list(nullptr).num_pairs, ==, 0);
    g_assert_null(pw85_neighbors_list(nullptr).pairs);
    g_assert_null(pw85_neighbors_list(nullptr).images);
}

// More images than memory can hold, or than fit into their numbers: refused at once.
PW85_TEST("/neighbors/too_many")
{
    System system = three_spheres();
    for (std::size_t k = 0; k < 3; ++k) system.cell[k][static_cast<int>(k)] = 1e-5;
    pw85::Neighbors list;
    g_assert_true(neighbors_create(system.particles(), system.options, list) ==
                  Status::out_of_memory);
    g_assert_true(list.get() == nullptr);
    // The reduced cell is (0, 0, ±1), (1, 0, 0) and (0, 1, 0), but in multiples of the given one
    // two of them are far away.
    system = three_spheres();
    system.cell = {{{1.0, 0.0, 0.0}, {0x1p33, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
    g_assert_true(neighbors_create(system.particles(), system.options, list) ==
                  Status::invalid_argument);
}

// Nothing at all, with and without a cell.
PW85_TEST("/neighbors/empty")
{
    System const system = three_spheres();
    for (bool const has_cell : {false, true}) {
        double const *const cell = has_cell ? system.cell[0].coordinates : nullptr;
        pw85_neighbors *list = nullptr;
        int holds = 7;
        g_assert_cmpint(
            pw85_neighbors_create(system_of(0, nullptr, nullptr, cell), 1.0, 0.0, &list), ==,
            PW85_SUCCESS);
        g_assert_nonnull(list);
        g_assert_cmpuint(pw85_neighbors_list(list).num_pairs, ==, 0);
        g_assert_cmpint(pw85_neighbors_holds(list, system_of(0, nullptr, nullptr, cell), &holds),
                        ==, PW85_SUCCESS);
        g_assert_cmpint(holds, ==, 1);
        pw85_neighbors_destroy(list);
    }
}

} // namespace
