// SPDX-License-Identifier: BSD-3-Clause
// Walls, fields and potentials of simulations: against independent configurations and quadrature,
// with threads, saved states and bad input.
#include <algorithm>
#include <array>
#include <atomic>
#include <climits>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include <glib.h>

#include <pw85/pw85.hpp>
#include <pw85/simulation.hpp>
#include <pw85_systems.h>

#include "cases.hpp"
#include "hard_particles.hpp"
#include "saved_sections.hpp"
#include "threads.hpp"

using namespace pw85_tests;

namespace {

using pw85::Field;
using pw85::Wall;
using Form = pw85::SymmetricMatrix<double, 3>;

/// A simulation without a cell, or with one that is repeated along some vectors.
HardEllipsoids make(Start const &start, bool has_cell = false, std::size_t seed = 1)
{
    HardEllipsoids simulation;
    pw85::IndexPair pair;
    pw85::Particles const particles{
        start.centers, {}, has_cell ? &start.cell : nullptr, start.periodic};
    g_assert_true(hard_ellipsoids_create(particles, start.semi_axes, start.quaternions, seed,
                                         simulation, pair) == Status::success);
    return simulation;
}

HardEllipsoids one_particle(Vector3 const &axes, Vector3 const &center = {})
{
    Start start;
    start.add(center, axes);
    return make(start);
}

void set_walls(HardEllipsoids &simulation, std::vector<Wall> const &walls)
{
    pw85::IndexPair overlap;
    g_assert_true(simulation.set_walls(walls, overlap) == Status::success);
    g_assert_true(overlap[0] == -1 && overlap[1] == -1);
}

Vector3 center_of(HardEllipsoids const &simulation, std::size_t i)
{
    double const *const x = simulation.system().centers + 3 * i;
    return {x[0], x[1], x[2]};
}

Form form_of(HardEllipsoids const &simulation, std::size_t i)
{
    Form q;
    std::copy_n(simulation.system().q + 6 * i, 6, q.entries);
    return q;
}

/// The mean of the integrand g over the density f by Simpson's rule.
template <class Density, class Value>
double average(double from, double to, Density const &density, Value const &value)
{
    constexpr int n = 2000;
    double sum = 0.0, weights = 0.0;
    for (int k = 0; k <= n; ++k) {
        double const x = from + (to - from) * k / n, w = (k == 0 || k == n ? 1.0
                                                          : k % 2          ? 4.0
                                                                           : 2.0) *
                                                         density(x);
        sum += w * value(x);
        weights += w;
    }
    return sum / weights;
}

/// One or two ellipsoids within walls that let no particle pass.
struct Confined {
    char const *name;
    std::vector<Wall> walls;
    Vector3 half_sides; ///< of a box around 0 with all centres
    std::function<bool(Vector3 const &, Form const &)> is_inside;
    int dimensions = 3;
};

/// What is compared: moments of the centres and forms of the particles.
using Moments = std::array<double, 6>;

Moments moments_of(std::vector<Vector3> const &centers, std::vector<Form> const &forms)
{
    Moments m{};
    for (std::size_t i = 0; i < centers.size(); ++i) {
        for (std::size_t d = 0; d < 3; ++d) {
            m[d] += centers[i][static_cast<int>(d)] * centers[i][static_cast<int>(d)];
            m[3 + d] += forms[i](static_cast<int>(d), static_cast<int>(d));
        }
    }
    return m;
}

/// Independent configurations of n particles: uniform ones, without those that have overlaps or are
/// not inside.
std::array<Blocks, 6> independent(Confined const &confined, std::vector<Vector3> const &axes,
                                  int samples)
{
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    std::array<Blocks, 6> blocks = {Blocks(samples / 50), Blocks(samples / 50),
                                    Blocks(samples / 50), Blocks(samples / 50),
                                    Blocks(samples / 50), Blocks(samples / 50)};
    bool const is_flat = confined.dimensions == 2;
    for (int k = 0; k < samples;) {
        std::vector<Vector3> centers;
        std::vector<Form> forms;
        bool free = true;
        for (Vector3 const &one : axes) {
            Vector3 x;
            for (int d = 0; d < 3; ++d) x[d] = confined.half_sides[d] * uniform(random);
            Quaternion turn = {normal(random), normal(random), normal(random), normal(random)};
            if (is_flat) turn[1] = turn[2] = x[2] = 0.0;
            forms.push_back(pw85::ellipsoid_quaternion(one, turn / std::sqrt(dot(turn, turn))).q);
            free = free && confined.is_inside(x, forms.back());
            for (std::size_t j = 0; j < centers.size() && free; ++j)
                free = pw85::contact(x - centers[j], forms[j], forms.back()).mu2 >= 1.0;
            centers.push_back(x);
        }
        if (!free) continue;
        Moments const m = moments_of(centers, forms);
        for (std::size_t d = 0; d < 6; ++d) blocks[d].add(m[d]);
        ++k;
    }
    return blocks;
}

void expect_moments(Confined const &confined, std::vector<Vector3> const &axes,
                    std::vector<Vector3> const &places)
{
    int const samples = g_test_perf() ? 200000 : 4000;
    Start start;
    for (std::size_t i = 0; i < axes.size(); ++i) start.add(places[i], axes[i]);
    HardEllipsoids simulation = make(start);
    if (confined.dimensions == 2) g_assert_true(simulation.set_dimensions(2) == Status::success);
    set_walls(simulation, confined.walls);
    g_assert_true(simulation.set_steps({0.4, 0.5, 0.1}) == Status::success);
    auto const expected = independent(confined, axes, samples);
    std::array<Blocks, 6> found = {Blocks(samples / 50), Blocks(samples / 50),
                                   Blocks(samples / 50), Blocks(samples / 50),
                                   Blocks(samples / 50), Blocks(samples / 50)};
    for (int k = 0; k < samples; ++k) {
        g_assert_true(simulation.sweep(12) == Status::success);
        std::vector<Vector3> centers;
        std::vector<Form> forms;
        for (std::size_t i = 0; i < axes.size(); ++i) {
            centers.push_back(center_of(simulation, i));
            forms.push_back(form_of(simulation, i));
            g_assert_true(confined.is_inside(centers[i], forms[i]));
        }
        Moments const m = moments_of(centers, forms);
        for (std::size_t d = 0; d < 6; ++d) found[d].add(m[d]);
    }
    for (std::size_t d = 0; d < 6; ++d) {
        if (confined.dimensions == 2 && (d == 2 || d == 5)) continue;
        found[d].expect(confined.name, expected[d].mean(), 4.0 * expected[d].error());
    }
    expect_no_overlap(simulation);
}

bool is_below(Vector3 const &normal, double offset, Vector3 const &x, Form const &q)
{
    return pw85::distance_plane(normal, offset - dot(normal, x), q).distance >= 0.0;
}

Confined in_planes()
{
    Vector3 const slanted = {0.6, 0.0, 0.8};
    std::vector<Wall> planes;
    std::vector<std::pair<Vector3, double>> half_spaces;
    for (Vector3 const &n : {Vector3{1, 0, 0}, Vector3{-1, 0, 0}, Vector3{0, 2, 0},
                             Vector3{0, -2, 0}, Vector3{0, 0, -1}, slanted})
        half_spaces.emplace_back(n, n[1] != 0.0 ? 2.4 : 1.2);
    for (auto const &[n, offset] : half_spaces) planes.push_back(Wall::plane(n, offset));
    return {"planes", planes, {1.2, 1.2, 2.4}, [=](Vector3 const &x, Form const &q) {
                return std::all_of(half_spaces.begin(), half_spaces.end(), [&](auto const &h) {
                    return is_below(h.first, h.second, x, q);
                });
            }};
}

Confined in_cylinder(char const *name, Vector3 const &axis, Vector3 const &end)
{
    return {
        name,
        {Wall::cylinder({0.1, 0.0, 0.0}, axis, 1.1), Wall::plane(end, 1.0), Wall::plane(-end, 1.0)},
        {1.3, 1.4, 1.4},
        [=](Vector3 const &x, Form const &q) {
            return pw85::distance_cylinder(axis, 1.1, x - Vector3{0.1, 0.0, 0.0}, q).distance >=
                       0.0 &&
                   is_below(end, 1.0, x, q) && is_below(-end, 1.0, x, q);
        }};
}

/// Walls of all kinds. Whether a particle is inside is decided by distances, which share no
/// decision with the simulation.
std::vector<Confined> confinements()
{
    std::vector<Confined> all = {in_planes()};
    all.push_back({"sphere",
                   {Wall::sphere({0.1, 0, 0}, 1.3)},
                   {1.4, 1.3, 1.3},
                   [](Vector3 const &x, Form const &q) {
                       Form const ball = {{1.69, 0, 0, 1.69, 0, 1.69}};
                       return pw85::containment(x - Vector3{0.1, 0, 0}, ball, q).mu2 <= 1.0;
                   }});
    all.push_back({"box",
                   {Wall::box({-1.1, -1.0, -1.3}, {1.1, 1.0, 1.3})},
                   {1.1, 1.0, 1.3},
                   [](Vector3 const &x, Form const &q) {
                       return pw85::distance_box(Vector3{-1.1, -1.0, -1.3} - x,
                                                 Vector3{1.1, 1.0, 1.3} - x, q)
                                  .distance >= 0.0;
                   }});
    all.push_back(in_cylinder("cylinder", {0.0, 0.0, 2.0}, {0, 0, 1}));
    all.push_back(in_cylinder("slanted cylinder", {0.0, 1.0, 0.25}, {0, 1, 0}));
    return all;
}

PW85_TEST("/surroundings/walls")
{
    for (Confined const &confined : confinements()) {
        expect_moments(confined, {{0.2, 0.5, 0.8}}, {{0, 0, 0}});
        expect_moments(confined, {{0.2, 0.3, 0.6}, {0.3, 0.3, 0.4}}, {{-0.3, 0, 0}, {0.4, 0, 0}});
    }
}

/// Vertices and triangles.
struct Surface {
    std::vector<Vector3> vertices;
    std::vector<std::array<std::int32_t, 3>> triangles;

    Status set(HardEllipsoids &simulation, pw85::IndexPair &overlap) const
    {
        return simulation.set_mesh(vertices, triangles, overlap);
    }
};

/// The surface of a cube around a point, of two triangles for each face.
Surface cube(Vector3 const &middle, double half)
{
    Surface surface{{},
                    {{0, 1, 3},
                     {0, 3, 2},
                     {4, 5, 7},
                     {4, 7, 6},
                     {0, 1, 5},
                     {0, 5, 4},
                     {2, 3, 7},
                     {2, 7, 6},
                     {0, 2, 6},
                     {0, 6, 4},
                     {1, 3, 7},
                     {1, 7, 5}}};
    for (int k = 0; k < 8; ++k) {
        Vector3 corner = middle;
        for (int d = 0; d < 3; ++d) corner[d] += k >> d & 1 ? half : -half;
        surface.vertices.push_back(corner);
    }
    return surface;
}

void set_mesh(HardEllipsoids &simulation, Surface const &surface)
{
    pw85::IndexPair overlap;
    g_assert_true(surface.set(simulation, overlap) == Status::success);
    g_assert_true(overlap[0] == -1 && overlap[1] == -1);
}

bool have_same_places(HardEllipsoids const &a, HardEllipsoids const &b)
{
    std::size_t const n = a.system().num_particles;
    return n == b.system().num_particles &&
           std::equal(a.system().centers, a.system().centers + 3 * n, b.system().centers) &&
           std::equal(a.system().q, a.system().q + 6 * n, b.system().q);
}

// A mesh decides as the box of its faces does, for centres inside: in thousands of placements, and
// in sweeps, bit by bit.
PW85_TEST("/surroundings/mesh")
{
    Start start;
    start.add({-0.3, 0, 0}, {0.2, 0.3, 0.6});
    start.add({0.4, 0, 0}, {0.3, 0.25, 0.4});
    HardEllipsoids meshed = make(start), boxed = make(start);
    set_mesh(meshed, cube({}, 1.0));
    set_walls(boxed, {Wall::box({-1, -1, -1}, {1, 1, 1})});
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    auto const any = [&] { return Vector3{uniform(random), uniform(random), uniform(random)}; };
    int num_free = 0;
    for (int k = 0; k < 4000; ++k) {
        Vector3 const center = any(), v = any();
        Quaternion const turn{uniform(random), v[0], v[1], v[2]};
        bool by_mesh = false, by_box = false;
        g_assert_true(meshed.try_placement(0, center, turn, false, by_mesh) == Status::success);
        g_assert_true(boxed.try_placement(0, center, turn, false, by_box) == Status::success);
        g_assert_true(by_mesh == by_box);
        num_free += by_mesh;
    }
    g_assert_cmpint(num_free, >, 200);
    for (HardEllipsoids *const one : {&meshed, &boxed})
        g_assert_true(one->set_steps({0.39, 0.5, 0.1}) == Status::success &&
                      one->sweep(5000) == Status::success);
    g_assert_true(have_same_places(meshed, boxed));
    expect_no_overlap(meshed);
}

// Trials of any length lead through no surface, and tune() does not ask for longer ones.
PW85_TEST("/surroundings/steps_in_mesh")
{
    Start start;
    start.add({-0.3, 0, 0}, {0.2, 0.3, 0.6});
    start.add({0.4, 0, 0}, {0.3, 0.25, 0.4});
    HardEllipsoids simulation = make(start);
    set_mesh(simulation, cube({}, 1.0));
    g_assert_true(simulation.set_steps({2.5, 0.5, 0.1}) == Status::success);
    g_assert_true(simulation.set_fractions({0.4, 0.3, 0.2, 0.1}) == Status::success);
    for (int k = 0; k < 2000; ++k) {
        g_assert_true(simulation.sweep(5) == Status::success);
        for (std::size_t const i : {0U, 1U})
            g_assert_true(pw85::detail::largest_coordinate(center_of(simulation, i)) < 1.0);
    }
    // Outside there is room for long steps. The longest ones are those of the thicker particle.
    for (bool const has_kinds : {false, true}) {
        Start far;
        far.add({3, 0, 0}, {0.1, 0.3, 3});
        far.add({-5, 0, 0}, {0.05, 0.25, 3});
        HardEllipsoids free = make(far);
        set_mesh(free, cube({}, 1.0));
        std::vector<pw85::TrialSteps> const steps(has_kinds ? 2 : 0, {0.05, 0.3, 0.1});
        std::span const kinds(far.semi_axes.data(), steps.size());
        g_assert_true(free.set_kind_steps(kinds, steps) == Status::success);
        g_assert_true(free.set_steps({1.4, 0.5, 0.1}) == Status::success);
        g_assert_true(free.tune(300, 0.1) == Status::success);
        auto const longest = [&](std::size_t i) {
            return free.kind_steps(far.semi_axes[i]).translation;
        };
        g_assert_cmpfloat_with_epsilon(longest(0), 0.2, 1e-6);
        g_assert_cmpfloat_with_epsilon(longest(1), has_kinds ? 0.1 : 0.2, 1e-6);
    }
}

// Where rounding errors may have left no ball in the particle, it stays where it is.
PW85_TEST("/surroundings/flat_particle_in_mesh")
{
    HardEllipsoids simulation = one_particle({1e-9, 1.0, 1.0});
    set_mesh(simulation, cube({}, 5.0));
    g_assert_true(simulation.set_steps({0.5, 1e-9, 0.1}) == Status::success &&
                  simulation.sweep(50) == Status::success);
    g_assert_true(pw85::detail::largest_coordinate(center_of(simulation, 0)) == 0.0);
}

// A cube at the corner of a sheared cell that is repeated along some of its vectors: places
// anywhere, against the meshes of all images, one by one.
PW85_TEST("/surroundings/mesh_of_cell")
{
    std::mt19937_64 random(6);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    Surface const surface = cube({0.1, 0.2, 0.1}, 0.5);
    for (std::array<int, 3> const &periodic :
         {std::array{1, 1, 1}, std::array{1, 1, 0}, std::array{0, 1, 0}}) {
        Start start;
        start.add({1.4, 1.3, 1.5}, {0.1, 0.2, 0.3});
        start.cell = {{{2.6, 0, 0}, {0.9, 2.4, 0}, {-0.7, 0.4, 2.5}}};
        start.periodic = periodic;
        HardEllipsoids simulation = make(start, true);
        set_mesh(simulation, surface);
        int num_free = 0;
        for (int k = 0; k < 600; ++k) {
            Vector3 center, multiples;
            for (int d = 0; d < 3; ++d) multiples[d] = std::round(3.0 * uniform(random));
            for (int d = 0; d < 3; ++d) center[d] = 1.5 * uniform(random);
            auto const moved = [&](Vector3 x, Vector3 const &n) {
                for (int l = 0; l < 3; ++l)
                    for (int d = 0; d < 3; ++d)
                        x[d] += periodic[std::size_t(l)] * n[l] * start.cell[std::size_t(l)][d];
                return x;
            };
            center = moved(center, multiples);
            Quaternion turn = {uniform(random), uniform(random), uniform(random), uniform(random)};
            turn = turn / std::sqrt(dot(turn, turn));
            auto const q = pw85::ellipsoid_quaternion({0.1, 0.2, 0.3}, turn).q;
            bool expected = true, found = false;
            for (int n = 0; n < 343 && expected; ++n) {
                Vector3 const other = {n % 7 - 3.0, n / 7 % 7 - 3.0, n / 49 - 3.0};
                Vector3 const x = moved(center, other - multiples);
                if (dot(x, x) > 4.0) continue; // the cube and the particle are within 1.7
                for (auto const &[i, j, l] : surface.triangles)
                    expected =
                        expected && !pw85::overlap_triangle(surface.vertices[std::size_t(i)] - x,
                                                            surface.vertices[std::size_t(j)] - x,
                                                            surface.vertices[std::size_t(l)] - x, q)
                                         .overlap;
            }
            g_assert_true(simulation.try_placement(0, center, turn, false, found) ==
                          Status::success);
            if (found != expected) g_test_fail_printf("%a %a %a", center[0], center[1], center[2]);
            num_free += found;
        }
        g_assert_true(num_free > 100 && num_free < 550);
        g_assert_true(simulation.sweep(50) == Status::success);
        g_assert_true(simulation.volume_moves(1, 1.0) == Status::invalid_argument);
        double factor;
        g_assert_true(simulation.compress(true, factor) == Status::invalid_argument);
        g_assert_true(simulation.chain(1, 1.0, factor) == Status::invalid_argument);
    }
}

// A floor and a ceiling of one cell are those of all cells: the same bits as with planes, with
// insertions, any number of threads, and after restarts.
PW85_TEST("/surroundings/mesh_of_slab")
{
    double const width = 4.0, height = 5.0;
    auto const run = [&](bool has_mesh, int threads, bool restarts) {
        Threads const used(threads);
        HardEllipsoids simulation;
        pw85::IndexPair pair;
        pw85::Cell const cell = {{{width, 0, 0}, {0.5 * width, width, 0}, {0, 0, height}}};
        pw85::Particles const particles{{}, {}, &cell, {1, 1, 0}};
        g_assert_true(hard_ellipsoids_create(particles, {}, {}, 3, simulation, pair) ==
                      Status::success);
        g_assert_true(simulation.set_steps({0.4, 0.5, 0.1}) == Status::success);
        if (has_mesh) {
            Surface surface;
            for (double const z : {0.0, height}) {
                auto const first = static_cast<std::int32_t>(surface.vertices.size());
                for (Vector3 const &x :
                     {Vector3{0, 0, z}, Vector3{width, 0, z}, Vector3{1.5 * width, width, z},
                      Vector3{0.5 * width, width, z}})
                    surface.vertices.push_back(x);
                surface.triangles.push_back({first, first + 1, first + 2});
                surface.triangles.push_back({first, first + 2, first + 3});
            }
            set_mesh(simulation, surface);
        } else {
            set_walls(simulation, {Wall::plane({0, 0, -1}, 0.0), Wall::plane({0, 0, 1}, height)});
        }
        std::vector<Vector3> const axes = {{0.3, 0.6, 0.4}};
        std::vector<double> const activities = {2.0};
        std::array<std::int64_t, 4> counts;
        for (int k = 0; k < 10; ++k) {
            g_assert_true(simulation.insertion_moves(300, axes, activities, counts) ==
                          Status::success);
            g_assert_true(simulation.sweep(3) == Status::success);
            if (!restarts) continue;
            HardEllipsoids again;
            g_assert_true(hard_ellipsoids_restore(bytes_of(simulation), again) == Status::success);
            simulation = std::move(again);
        }
        return simulation;
    };
    HardEllipsoids const expected = run(false, 1, false), meshed = run(true, 1, false);
    g_assert_cmpuint(meshed.system().num_particles, >, 20);
    g_assert_true(have_same_places(meshed, expected));
    g_assert_true(bytes_of(run(true, 2, false)) == bytes_of(meshed));
    g_assert_true(bytes_of(run(true, 2, true)) == bytes_of(meshed));
}

// What is refused leaves the simulation as it was.
PW85_TEST("/surroundings/bad_mesh")
{
    Start start;
    start.add({0, 0, 0}, {0.2, 0.3, 0.6});
    start.add({0.9, 0, 0}, {0.2, 0.3, 0.6});
    HardEllipsoids simulation = make(start), none;
    auto const before = bytes_of(simulation);
    Surface const good = cube({}, 1.0);
    pw85::IndexPair overlap;
    g_assert_true(good.set(simulation, overlap) == Status::overlap);
    g_assert_true(overlap[0] == 1 && overlap[1] >= 10); // the faces at x = 1
    Surface bad = cube({}, 2.0);
    bad.vertices[5][1] = NAN;
    g_assert_true(bad.set(simulation, overlap) == Status::invalid_argument && overlap[0] == -1);
    bad = cube({}, 2.0);
    bad.triangles[3][2] = 8;
    g_assert_true(bad.set(simulation, overlap) == Status::invalid_argument);
    g_assert_true(bytes_of(simulation) == before);
    g_assert_true(good.set(none, overlap) == Status::invalid_argument);
    g_assert_cmpint(
        pw85_hard_ellipsoids_set_mesh(simulation.get(), 8, nullptr, 1, nullptr, nullptr), ==,
        PW85_EINVAL);

    set_mesh(simulation, cube({}, 2.0));
    g_assert_true(simulation.set_dimensions(2) == Status::invalid_argument);
    auto const meshed = bytes_of(simulation);
    HardEllipsoids again;
    g_assert_true(hard_ellipsoids_restore(meshed, again) == Status::success &&
                  bytes_of(again) == meshed);
    set_mesh(simulation, {});
    g_assert_true(bytes_of(simulation) == before);

    HardEllipsoids flat = make(start);
    g_assert_true(flat.set_dimensions(2) == Status::success &&
                  cube({}, 2.0).set(flat, overlap) == Status::invalid_argument);
    start.cell = box(3, 3, 3);
    start.periodic = {1, 0, 0};
    HardEllipsoids narrow = make(start, true);
    g_assert_true(cube({}, 25.0).set(narrow, overlap) == Status::invalid_argument);
}

// The third semi-axes have no influence: they are longer than the walls are wide.
PW85_TEST("/surroundings/walls_of_the_plane")
{
    auto const flat = [](Form const &q) {
        return pw85::SymmetricMatrix<double, 2>{{q(0, 0), q(0, 1), q(1, 1)}};
    };
    auto const in_disc = [=](Vector3 const &x, Form const &q) {
        return pw85::containment(pw85::Vector<double, 2>{x[0] - 0.1, x[1]}, {{1.44, 0, 1.44}},
                                 flat(q))
                   .mu2 <= 1.0;
    };
    std::vector<Confined> const all = {
        {"disc", {Wall::sphere({0.1, 0, 0}, 1.2)}, {1.3, 1.2, 0}, in_disc, 2},
        {"cylinder of the plane",
         {Wall::cylinder({0.1, 0, 3}, {0, 0, 1}, 1.2)},
         {1.3, 1.2, 0},
         in_disc,
         2},
        {"rectangle",
         {Wall::box({-1.0, -1.2, 0}, {1.0, 1.2, 0})},
         {1.0, 1.2, 0},
         [](Vector3 const &x, Form const &q) {
             return std::sqrt(q(0, 0)) + std::fabs(x[0]) <= 1.0 &&
                    std::sqrt(q(1, 1)) + std::fabs(x[1]) <= 1.2;
         },
         2}};
    for (Confined const &confined : all)
        expect_moments(confined, {{0.2, 0.6, 9.0}, {0.3, 0.4, 0.1}}, {{-0.3, 0, 0}, {0.4, 0, 0}});
}

// What touches a wall is free; what is beyond it by the last bit is not.
PW85_TEST("/surroundings/touching")
{
    double const beyond = 1.0 + 0x1p-52;
    struct {
        Wall wall;
        Vector3 touching;
    } const cases[] = {{Wall::plane({0, 0, 3}, 6.0), {0, 0, 1.5}},
                       {Wall::sphere({1, 0, 0}, 2.5), {1, 2, 0}},
                       {Wall::cylinder({0, 5, 1}, {0, 1, 0}, 2.5), {2, -7, 1}},
                       {Wall::box({-1, -1, -1}, {2, 2, 2}), {1.5, 0, 1.5}}};
    Quaternion const upright = {1, 0, 0, 0};
    for (auto const &[wall, touching] : cases) {
        HardEllipsoids simulation = one_particle({0.5, 0.5, 0.5}, {1, 0.5, 1});
        set_walls(simulation, {wall});
        bool is_free;
        g_assert_true(simulation.try_placement(0, touching, upright, true, is_free) ==
                          Status::success &&
                      is_free);
        expect_no_overlap(simulation);
        g_assert_true(simulation.try_placement(0, beyond * touching, upright, true, is_free) ==
                      Status::success);
        if (is_free) g_test_fail_printf("wall %d", wall.kind);
        set_walls(simulation, {wall});
        HardEllipsoids other = one_particle({0.5, 0.5, 0.5}, beyond * touching);
        pw85::IndexPair overlap;
        auto const before = bytes_of(other);
        Wall const walls[] = {Wall::plane({0, 0, 1}, 100.0), wall};
        g_assert_true(other.set_walls(walls, overlap) == Status::overlap);
        g_assert_true(overlap[0] == 0 && overlap[1] == 1 && bytes_of(other) == before);
    }
}

// The centre is beyond the plane, by products below the least double.
PW85_TEST("/surroundings/tiny_plane")
{
    HardEllipsoids simulation =
        one_particle({0x1p-80, 0x1p-80, 0x1p-80}, {0x1p-75, 0x1p-75, 0x1p-75});
    Wall const walls[] = {Wall::plane({0x1p-1000, 0x1p-1000, 0x1p-1000}, 0x1p-1074)};
    pw85::IndexPair overlap;
    g_assert_true(simulation.set_walls(walls, overlap) == Status::overlap);
}

double second_legendre(double c) { return 1.5 * c * c - 0.5; }

// One particle in each field, against integrals.
PW85_TEST("/surroundings/fields")
{
    int const samples = g_test_perf() ? 1000000 : 200000;
    Blocks height(samples / 50), weighed(samples / 50), square(samples / 50), order(samples / 50);
    HardEllipsoids falling = one_particle({0.5, 0.5, 0.5}), heavy = one_particle({0.25, 0.25, 0.5}),
                   trapped = one_particle({0.5, 0.5, 0.5}), aligned = one_particle({0.3, 0.9, 0.5});
    std::vector<Wall> const slit = {Wall::plane({0, 0, -1}, 1.0), Wall::plane({0, 0, 1}, 1.0)};
    constexpr double volume = 4.0 / 3.0 * 3.14159265358979323846 * 0.25 * 0.25 * 0.5;
    set_walls(falling, slit);
    set_walls(heavy, slit);
    Field const linear[] = {Field::linear({0, 0, 2.0}), Field::linear({0, 0, 1.0})};
    Field const weight = Field::weight({0, 0, 20.0});
    Field const trap[] = {Field::harmonic({1.0, 0.0, 0.0}, {2.0, 4.0, 1.0}),
                          Field::aligning({0, 0, 1}, 1.0)};
    Field const aligning = Field::aligning({0.6, 0.0, 0.8}, 2.5, 1);
    g_assert_true(falling.set_fields(linear) == Status::success);
    g_assert_true(heavy.set_fields({&weight, 1}) == Status::success);
    g_assert_true(heavy.set_fractions({1, 0, 0, 0}) == Status::success);
    g_assert_true(trapped.set_fields(trap) == Status::success);
    g_assert_true(aligned.set_fields({&aligning, 1}) == Status::success);
    for (HardEllipsoids *const simulation : {&falling, &heavy, &trapped, &aligned})
        g_assert_true(simulation->set_steps({0.7, 1.0, 0.1}) == Status::success);
    for (int k = 0; k < samples; ++k) {
        for (HardEllipsoids *const simulation : {&falling, &heavy, &trapped, &aligned})
            g_assert_true(simulation->sweep(4) == Status::success);
        height.add(center_of(falling, 0)[2]);
        weighed.add(center_of(heavy, 0)[2]);
        Vector3 const x = center_of(trapped, 0);
        square.add(2.0 * (x[0] - 1.0) * (x[0] - 1.0) + 4.0 * x[1] * x[1] + x[2] * x[2]);
        Quaternion const t = aligned.quaternions()[0];
        Vector3 const axis = {2 * (t[1] * t[2] - t[0] * t[3]), 1 - 2 * (t[1] * t[1] + t[3] * t[3]),
                              2 * (t[2] * t[3] + t[0] * t[1])};
        order.add(second_legendre(0.6 * axis[0] + 0.8 * axis[2]));
    }
    auto const z = [](double x) { return x; };
    height.expect("linear field", average(
                                      -0.5, 0.5, [](double x) { return std::exp(-3.0 * x); }, z));
    weighed.expect("weight",
                   average(
                       -0.5, 0.5, [](double x) { return std::exp(-20.0 * volume * x); }, z));
    square.expect("harmonic field", 3.0);
    order.expect("aligning field",
                 average(
                     0.0, 1.0, [](double c) { return std::exp(2.5 * second_legendre(c)); },
                     second_legendre));
    double energy;
    g_assert_true(falling.energy(energy) == Status::success);
    g_assert_cmpfloat(std::fabs(energy - 3.0 * center_of(falling, 0)[2]), <, 1e-14);
}

// Two spheres in a harmonic field: their distance has the density r² e^(-kr²/4) from contact on,
// and their centre of mass is not disturbed by contacts.
PW85_TEST("/surroundings/two_spheres")
{
    int const samples = g_test_perf() ? 400000 : 40000;
    constexpr double k = 3.0;
    Start start;
    start.add({-0.6, 0, 0}, {0.5, 0.5, 0.5});
    start.add({0.6, 0, 0}, {0.5, 0.5, 0.5});
    HardEllipsoids simulation = make(start);
    Field const trap = Field::harmonic({}, {k, k, k});
    g_assert_true(simulation.set_fields({&trap, 1}) == Status::success);
    g_assert_true(simulation.set_fractions({1, 0, 0, 0}) == Status::success);
    g_assert_true(simulation.set_steps({0.8, 0.1, 0.1}) == Status::success);
    Blocks distance(samples / 50), middle(samples / 50), energies(samples / 50);
    for (int n = 0; n < samples; ++n) {
        g_assert_true(simulation.sweep(10) == Status::success);
        Vector3 const r = center_of(simulation, 1) - center_of(simulation, 0);
        Vector3 const c = 0.5 * (center_of(simulation, 1) + center_of(simulation, 0));
        distance.add(dot(r, r));
        middle.add(dot(c, c));
        double energy;
        g_assert_true(simulation.energy(energy) == Status::success);
        energies.add(energy);
    }
    double const expected = average(
        1.0, 9.0, [](double r) { return r * r * std::exp(-0.25 * k * r * r); },
        [](double r) { return r * r; });
    distance.expect("squared distance", expected);
    middle.expect("squared centre of mass", 1.5 / k);
    energies.expect("energy", 0.25 * k * expected + 1.5);
}

// Two unlike particles at fixed places exchange their semi-axes: the states have the weights e^-U.
PW85_TEST("/surroundings/exchange")
{
    Start start;
    start.add({0, 0, 0}, {0.3, 0.3, 0.3});
    start.add({0, 0, 2}, {0.4, 0.4, 0.4});
    HardEllipsoids simulation = make(start);
    Field const weight = Field::weight({0, 0, 3.0});
    g_assert_true(simulation.set_fields({&weight, 1}) == Status::success);
    g_assert_true(simulation.set_fractions({0, 0, 0, 1}) == Status::success);
    Blocks upper(2000);
    for (int k = 0; k < 100000; ++k) {
        g_assert_true(simulation.sweep(3) == Status::success);
        upper.add(simulation.semi_axes()[1][0] > 0.35);
    }
    double const difference = 3.0 * 2.0 * 4.0 / 3.0 * 3.14159265358979323846 * (0.064 - 0.027);
    upper.expect("the larger one is above", 1.0 / (1.0 + std::exp(difference)));
}

/// A potential with a period, which acts on orientations and kinds, too, and counts its calls.
struct Waves {
    double period, strength;
    double operator()(std::int32_t, Vector3 const &x, Quaternion const &t,
                      Vector3 const &axes) const noexcept
    {
        double const phase = x[2] / period;
        return strength * axes[2] * std::cos(2.0 * 3.14159265358979323846 * phase) *
               (t[0] * t[0] + t[3] * t[3]);
    }
};

/// lattice() in a cell that is repeated along x, y and maybe z.
Start slab(int n, bool along_z)
{
    Start start = lattice(n);
    start.periodic = {1, 1, along_z};
    return start;
}

// The same bits with any number of threads, and from a saved state on.
PW85_TEST("/surroundings/threads_and_restart")
{
    constexpr int n = 12;
    Waves const waves{2.6 * n, 0.5};
    std::vector<Wall> const walls = {Wall::plane({0, 0, -1}, 2.0), Wall::plane({0, 0, 1}, 2.6 * n)};
    for (bool const along_z : {false, true}) {
        Field const field = along_z ? Field::aligning({0, 1, 2}, 1.5) : Field::linear({0, 0, 0.3});
        auto const run = [&](int threads, bool restarts) {
            Threads const used(threads);
            HardEllipsoids simulation = make(slab(n, along_z), true);
            if (!along_z) set_walls(simulation, walls);
            g_assert_true(simulation.set_fields({&field, 1}) == Status::success);
            g_assert_true(simulation.set_potential(waves) == Status::success);
            g_assert_true(simulation.set_fractions({4, 4, 1, 1}) == Status::success);
            g_assert_true(simulation.tune(3, 0.4, along_z ? 1.0 : 0.0) == Status::success);
            g_assert_true(simulation.sweep(4) == Status::success);
            if (restarts) {
                HardEllipsoids again;
                auto const bytes = bytes_of(simulation);
                g_assert_true(hard_ellipsoids_restore(bytes, again) == Status::success);
                g_assert_true(bytes_of(again) == bytes);
                double energy;
                g_assert_true(again.sweep(1) == Status::bad_potential &&
                              again.energy(energy) == Status::bad_potential);
                g_assert_true(again.volume_moves(along_z ? 1 : 0, 1.0) ==
                              (along_z ? Status::bad_potential : Status::invalid_argument));
                Waves const other{2.6 * n, 0.4};
                g_assert_true(again.set_potential(other) == Status::invalid_argument);
                g_assert_true(bytes_of(again) == bytes);
                g_assert_true(again.set_potential(waves) == Status::success);
                simulation = std::move(again);
            }
            g_assert_true(simulation.sweep(4) == Status::success);
            if (along_z) g_assert_true(simulation.volume_moves(5, 1.0) == Status::success);
            expect_no_overlap(simulation);
            return bytes_of(simulation);
        };
        auto const expected = run(1, false);
        g_assert_true(run(3, false) == expected);
        g_assert_true(run(1, true) == expected);
        g_assert_true(run(2, true) == expected);
    }
}

// A potential that computes what a field does gives the same trajectory.
PW85_TEST("/surroundings/potential_as_field")
{
    Start const start = slab(4, false);
    std::vector<Wall> const walls = {Wall::plane({0, 0, -1}, 2.0), Wall::plane({0, 0, 1}, 10.4)};
    HardEllipsoids first = make(start, true), second = make(start, true);
    Field const field = Field::linear({0, 0, 0.7});
    auto const potential = [](std::int32_t, Vector3 const &x, Quaternion const &, Vector3 const &) {
        return dot(Vector3{0, 0, 0.7}, x);
    };
    set_walls(first, walls);
    set_walls(second, walls);
    g_assert_true(first.set_fields({&field, 1}) == Status::success);
    g_assert_true(second.set_potential(potential) == Status::success);
    g_assert_true(first.sweep(20) == Status::success && second.sweep(20) == Status::success);
    double one = 0.0, other = 1.0;
    g_assert_true(first.energy(one) == Status::success && second.energy(other) == Status::success);
    g_assert_true(one == other);
    for (std::size_t i = 0; i < start.centers.size(); ++i)
        g_assert_true(center_of(first, i)[2] == center_of(second, i)[2]);
}

// One particle that keeps its place in the cell: with it, its energy changes. V has the density V
// e^-PV e^-U(V).
PW85_TEST("/surroundings/volume")
{
    constexpr double pressure = 2.0, g = 4.0;
    Start start;
    start.add({0, 0, 0.75}, {1e-3, 1e-3, 1e-3});
    start.cell = box(1, 1, 1);
    HardEllipsoids simulation = make(start, true);
    auto const potential = [](std::int32_t, Vector3 const &x, Quaternion const &, Vector3 const &) {
        return g * x[2];
    };
    g_assert_true(simulation.set_potential(potential) == Status::success);
    g_assert_true(simulation.set_steps({0.1, 0.1, 0.7}) == Status::success);
    Blocks volumes(20000);
    for (int k = 0; k < 2000000; ++k) {
        g_assert_true(simulation.volume_moves(1, pressure) == Status::success);
        double const *const c = simulation.system().cell;
        volumes.add(c[0] * c[4] * c[8]);
    }
    volumes.expect("volume", average(
                                 0.0, 20.0,
                                 [](double v) {
                                     return v * std::exp(-pressure * v - g * 0.75 * std::cbrt(v));
                                 },
                                 [](double v) { return v; }));
}

// Each point has a site of its own, by its index: an Einstein crystal, whose mean energy is 3/2 for
// each point.
PW85_TEST("/surroundings/sites")
{
    Start start;
    for (int k = 0; k < 216; ++k)
        start.add({double(k % 6), double(k / 6 % 6), double(k / 36)}, {1e-6, 1e-6, 1e-6});
    start.cell = box(6, 6, 6);
    HardEllipsoids simulation = make(start, true);
    auto const potential = [&](std::int32_t i, Vector3 const &x, Quaternion const &,
                               Vector3 const &) {
        Vector3 const r = x - start.centers[static_cast<std::size_t>(i)];
        return 100.0 * dot(r, r);
    };
    g_assert_true(simulation.set_potential(potential) == Status::success);
    g_assert_true(simulation.set_fractions({1, 0, 0, 0}) == Status::success);
    g_assert_true(simulation.set_steps({0.2, 0.1, 0.1}) == Status::success);
    g_assert_true(simulation.sweep(100) == Status::success);
    Blocks energies(40);
    for (int k = 0; k < 2000; ++k) {
        double energy = 0.0;
        g_assert_true(simulation.sweep(2) == Status::success &&
                      simulation.energy(energy) == Status::success);
        energies.add(energy / 216.0);
    }
    energies.expect("energy of a point", 1.5);
}

// NaN in the second sweep of a call: the state is that between the two.
PW85_TEST("/surroundings/nan_in_second_sweep")
{
    std::atomic<int> calls = 0, most = INT_MAX;
    auto const potential = [&](std::int32_t, Vector3 const &x, Quaternion const &,
                               Vector3 const &) {
        return ++calls > most ? double{NAN} : 0.1 * std::sin(x[0]);
    };
    HardEllipsoids simulation = make(slab(6, true), true), other = make(slab(6, true), true);
    g_assert_true(other.set_potential(potential) == Status::success &&
                  other.sweep(3) == Status::success);
    g_assert_true(simulation.set_potential(potential) == Status::success &&
                  simulation.sweep(2) == Status::success);
    int const before = calls;
    g_assert_true(other.sweep(1) == Status::success);
    most = calls + (calls - before) + (calls - before) / 2;
    g_assert_true(simulation.sweep(3) == Status::bad_potential);
    most = INT_MAX;
    g_assert_true(other.set_potential(nullptr, nullptr) == Status::success);
    g_assert_true(simulation.set_potential(nullptr, nullptr) == Status::success);
    HardEllipsoids third = make(slab(6, true), true);
    g_assert_true(third.set_potential(potential) == Status::success &&
                  third.sweep(3) == Status::success);
    g_assert_true(third.set_potential(nullptr, nullptr) == Status::success);
    g_assert_true(bytes_of(third) == bytes_of(simulation) && bytes_of(third) != bytes_of(other));
}

// A sweep with NaN leaves the state before it, whichever thread finds it.
PW85_TEST("/surroundings/nan")
{
    Threads const used(2);
    Start const start = slab(6, true);
    for (double const bad : {double{NAN}, -HUGE_VAL}) {
        HardEllipsoids simulation = make(start, true);
        bool is_bad = false;
        auto const potential = [&](std::int32_t i, Vector3 const &x, Quaternion const &,
                                   Vector3 const &) {
            return is_bad && i == 100 ? bad : 0.1 * std::sin(x[0]);
        };
        g_assert_true(simulation.set_potential(potential) == Status::success);
        g_assert_true(simulation.sweep(3) == Status::success);
        auto const before = bytes_of(simulation);
        is_bad = true;
        g_assert_true(simulation.sweep(2) == Status::bad_potential);
        g_assert_true(simulation.volume_moves(1, 1.0) == Status::bad_potential);
        bool is_free;
        g_assert_true(simulation.try_placement(100, {0, 0, 0}, {1, 0, 0, 0}, true, is_free) ==
                      Status::bad_potential);
        double energy;
        g_assert_true(simulation.energy(energy) == Status::bad_potential && std::isnan(energy));
        std::vector<unsigned char> unwritten(before.size(), 7);
        g_assert_true(simulation.save(unwritten) == Status::bad_potential);
        g_assert_true(unwritten == std::vector<unsigned char>(before.size(), 7));
        is_bad = false;
        g_assert_true(bytes_of(simulation) == before);
        g_assert_true(simulation.sweep(2) == Status::success);
        HardEllipsoids other = make(start, true);
        g_assert_true(other.set_potential(potential) == Status::success &&
                      other.sweep(5) == Status::success);
        g_assert_true(bytes_of(other) == bytes_of(simulation));
    }
}

// Places where the potential is infinite are forbidden.
PW85_TEST("/surroundings/infinity")
{
    HardEllipsoids simulation = one_particle({0.5, 0.5, 0.5});
    auto const potential = [](std::int32_t, Vector3 const &x, Quaternion const &, Vector3 const &) {
        return dot(x, x) > 1.0 ? HUGE_VAL : 0.0;
    };
    g_assert_true(simulation.set_potential(potential) == Status::success);
    g_assert_true(simulation.set_steps({1.0, 0.1, 0.1}) == Status::success);
    Blocks squares(1000);
    for (int k = 0; k < 50000; ++k) {
        g_assert_true(simulation.sweep(5) == Status::success);
        Vector3 const x = center_of(simulation, 0);
        squares.add(dot(x, x));
    }
    squares.expect("points of a ball", 0.6);
    bool is_free;
    g_assert_true(simulation.try_placement(0, {2, 0, 0}, {1, 0, 0, 0}, true, is_free) ==
                      Status::success &&
                  !is_free);
    HardEllipsoids outside = one_particle({0.5, 0.5, 0.5}, {2, 0, 0});
    g_assert_true(outside.set_potential(potential) == Status::bad_potential);
    g_assert_true(outside.sweep(1) == Status::success);
}

void expect_refused(HardEllipsoids &simulation, Wall const &wall)
{
    pw85::IndexPair overlap;
    auto const before = bytes_of(simulation);
    if (simulation.set_walls({&wall, 1}, overlap) != Status::invalid_argument ||
        bytes_of(simulation) != before)
        g_test_fail_printf("wall %d: %a %a %a, %a", wall.kind, wall.vector[0], wall.vector[1],
                           wall.vector[2], wall.size);
}

void expect_refused(HardEllipsoids &simulation, Field const &field)
{
    auto const before = bytes_of(simulation);
    if (simulation.set_fields({&field, 1}) != Status::invalid_argument ||
        bytes_of(simulation) != before)
        g_test_fail_printf("field %d: %a %a %a, %a", field.kind, field.vector[0], field.vector[1],
                           field.vector[2], field.strength);
}

PW85_TEST("/surroundings/bad_input")
{
    HardEllipsoids simulation = make(slab(2, false), true);
    for (Wall const &wall :
         {Wall::plane({0, 0, 0}, 9.0), Wall::plane({0, 0, 1}, double{NAN}),
          Wall::plane({0, NAN, 1}, 9.0), Wall::plane({1, 0, 0}, 99.0),
          Wall::plane({0, 1e-9, 1}, 99.0), Wall::sphere({0, 0, 0}, 99.0),
          Wall::cylinder({0, 0, 0}, {0, 0, 1}, 99.0), Wall::cylinder({0, 0, 0}, {1, 0, 0}, 99.0),
          Wall::box({-99, -99, -99}, {99, 99, 99}), Wall{{4, {}, {0, 0, 1}, 1.0}},
          Wall{{-1, {}, {0, 0, 1}, 1.0}}})
        expect_refused(simulation, wall);
    for (Field const &field :
         {Field::linear({1, 0, 0}), Field::linear({0, NAN, 1}), Field::weight({0, 1, 1}),
          Field::harmonic({}, {0, 1, 1}), Field::harmonic({NAN, 0, 0}, {0, 0, 1}),
          Field::aligning({0, 0, 0}, 1.0), Field::aligning({0, 0, 1}, NAN),
          Field::aligning({0, 0, 1}, 1, 3), Field::aligning({0, 0, 1}, 1.0, -1),
          Field::aligning({1e200, 0, 1}, 1.0), Field{{4, 0, {}, {}, 1.0}},
          Field{{-1, 0, {}, {}, 1.0}}})
        expect_refused(simulation, field);
    HardEllipsoids alone = one_particle({0.5, 0.5, 0.5});
    for (Wall const &wall :
         {Wall::sphere({0, 0, NAN}, 9.0), Wall::sphere({}, 0.0), Wall::sphere({}, -9.0),
          Wall::sphere({}, HUGE_VAL), Wall::sphere({}, 1e200), Wall::sphere({}, 1e-200),
          Wall::cylinder({}, {0, 0, 0}, 9.0), Wall::cylinder({}, {0, 0, 1}, -9.0),
          Wall::cylinder({NAN, 0, 0}, {0, 0, 1}, 9.0), Wall::box({1, -9, -9}, {-1, 9, 9}),
          Wall::box({-9, -9, -9}, {9, NAN, 9})})
        expect_refused(alone, wall);
    Field const oblique = Field::linear({1e308, 1e308, 0});
    expect_refused(simulation, oblique);
    Field const huge = Field::linear({1e308, 0, 0});
    HardEllipsoids far_away = one_particle({0.5, 0.5, 0.5}, {1e10, 0, 0});
    g_assert_true(far_away.set_fields({&huge, 1}) == Status::bad_potential);
    Field const down = Field::linear({-1e308, 0, 0});
    HardEllipsoids falling = one_particle({0.5, 0.5, 0.5}, {1.5, 0, 0});
    g_assert_true(falling.set_fields({&down, 1}) == Status::success &&
                  falling.set_steps({3.0, 0.1, 0.1}) == Status::success &&
                  falling.set_fractions({1, 0, 0, 0}) == Status::success);
    g_assert_true(falling.sweep(1000) == Status::bad_potential);
    g_assert_true(center_of(falling, 0)[0] < 1.8);
    pw85::IndexPair overlap;
    g_assert_cmpint(pw85_hard_ellipsoids_set_walls(alone.get(), 1, nullptr, nullptr), ==,
                    PW85_EINVAL);
    g_assert_cmpint(pw85_hard_ellipsoids_set_walls(alone.get(), 0, nullptr, nullptr), ==,
                    PW85_SUCCESS);
    g_assert_cmpint(pw85_hard_ellipsoids_set_fields(alone.get(), 1, nullptr), ==, PW85_EINVAL);
    g_assert_cmpint(pw85_hard_ellipsoids_energy(alone.get(), nullptr), ==, PW85_EINVAL);
    HardEllipsoids none;
    double energy = 0.0;
    g_assert_true(none.set_walls({}, overlap) == Status::invalid_argument);
    g_assert_true(none.set_fields({}) == Status::invalid_argument);
    g_assert_true(none.set_potential(nullptr, nullptr) == Status::invalid_argument);
    g_assert_true(none.energy(energy) == Status::invalid_argument && std::isnan(energy));
}

// What does not know of walls and energies is refused, and walls of one number of dimensions are
// not those of another.
PW85_TEST("/surroundings/refusals")
{
    double number;
    Wall const walls[] = {Wall::plane({0, 0, 1}, 9.0), Wall::sphere({0, 0, 3}, 4.0)};
    Field const field = Field::linear({1, 0, 0});
    auto const potential = [](auto const &...) { return 1.0; };
    for (int k = 0; k < 4; ++k) {
        HardEllipsoids simulation = one_particle({0.5, 0.5, 2.0}, {0, 0, 3});
        if (k < 2) set_walls(simulation, {walls[k]});
        if (k == 2) g_assert_true(simulation.set_fields({&field, 1}) == Status::success);
        if (k == 3) g_assert_true(simulation.set_potential(potential) == Status::success);
        g_assert_true(simulation.chain(1, 1.0, number) == Status::invalid_argument);
        g_assert_true(simulation.compress(true, number) == Status::invalid_argument);
        g_assert_true(simulation.set_dimensions(2) ==
                      (k == 0 ? Status::invalid_argument : Status::success));
        set_walls(simulation, {});
        g_assert_true(simulation.set_fields({}) == Status::success);
        g_assert_true(simulation.set_potential(nullptr, nullptr) == Status::success);
        g_assert_true(simulation.chain(1, 1.0, number) == Status::success);
    }
    HardEllipsoids flat = one_particle({0.5, 0.5, 5.0}, {0, 0, 3});
    g_assert_true(flat.set_dimensions(2) == Status::success);
    set_walls(flat, {walls[1]});
    g_assert_true(flat.set_dimensions(3) == Status::invalid_argument && flat.dimensions() == 2);
}

// Bytes that say something else about walls, fields or the potential.
PW85_TEST("/surroundings/changed_bytes")
{
    HardEllipsoids simulation = one_particle({0.5, 0.5, 0.5});
    Wall const walls[] = {Wall::plane({0, 0, 1}, 9.0), Wall::sphere({}, 4.0)};
    Field const field = Field::aligning({1, 0, 0}, 3.0);
    set_walls(simulation, {walls[0], walls[1]});
    g_assert_true(simulation.set_fields({&field, 1}) == Status::success);
    auto const bytes = bytes_of(simulation);
    HardEllipsoids other;
    g_assert_true(hard_ellipsoids_restore(bytes, other) == Status::success &&
                  bytes_of(other) == bytes);
    g_assert_true(other.sweep(5) == Status::success && simulation.sweep(5) == Status::success);
    g_assert_true(bytes_of(other) == bytes_of(simulation));
    for (std::size_t const k : {2U, 5U}) { // the point and the vector of the field
        Bytes const changed = with_word(bytes, "FIELDS", k, word_of(NAN));
        g_assert_true(hard_ellipsoids_restore(changed, other) ==
                      (k == 2 ? Status::success : Status::invalid_argument));
    }
    Bytes const inward = with_word(bytes, "WALLS", 15, word_of(0.25)); // the radius of the sphere
    g_assert_true(hard_ellipsoids_restore(inward, other) == Status::overlap);
}

} // namespace
