// SPDX-License-Identifier: GPL-2.0-only
// What makes the results of fix pw85/hpmc independent of processors: the random numbers
// (random.hpp), and exact positions and cells (checkerboard.hpp).
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <utility>

#include <glib.h>

#include "checkerboard.hpp"
#include "random.hpp"

using namespace pw85_lammps;

namespace {

/// Seeds, sweeps and tasks have numbers of their own, also beyond 32 bits of sweeps and tasks.
void test_streams()
{
    std::uint64_t const many = std::uint64_t{1} << 32;
    std::set<std::uint32_t> first;
    for (std::uint32_t const seed : {1u, 2u})
        for (std::uint64_t const sweep : {std::uint64_t{0}, std::uint64_t{1}, many})
            for (std::uint64_t const task : {std::uint64_t{0}, std::uint64_t{1}, many, many + 1})
                first.insert(Stream(seed, sweep, task).bits());
    g_assert_cmpuint(first.size(), ==, 24);
    Stream random(1, 2, 3);
    for (int k = 0; k < 1000; ++k) {
        double const x = random.uniform();
        g_assert_true(x >= 0.0 && x < 1.0);
        g_assert_cmpuint(random.below(3), <, 3);
        Vector const in_ball = random.in_ball();
        g_assert_cmpfloat(dot(in_ball, in_ball), <=, 1.0);
    }
}

/// Returns whether a + b has no rounding error (Knuth's sum of two numbers).
bool adds_exactly(double a, double b)
{
    double const sum = a + b, part = sum - a;
    return (a - (sum - part)) + (b - part) == 0.0;
}

ExactBox random_box(Stream &random, bool is_sheared)
{
    double const size = std::ldexp(1.0, static_cast<int>(random.below(40)) - 20);
    Vector lower, upper, tilts{};
    for (std::size_t k = 0; k < 3; ++k) {
        lower[k] = size * (random.uniform() - 0.5);
        upper[k] = lower[k] + size * (0.001 + random.uniform());
    }
    auto const tilt = [&](std::size_t k) {
        return (random.uniform() - 0.5) * (upper[k] - lower[k]);
    };
    if (is_sheared) tilts = {tilt(0), tilt(0), tilt(1)};
    ExactBox const box = exact_box(lower, upper, tilts, is_sheared);
    Vector ends;
    for (std::size_t k = 0; k < 3; ++k) {
        ends[k] = box.upper(k);
        double const most = std::abs(lower[k]) + std::abs(upper[k]) + size * (is_sheared ? 1 : 0);
        double const error = (is_sheared ? 0x1p-43 : 0x1p-49) * most;
        g_assert_cmpfloat(box.lower[k], <=, lower[k]);
        g_assert_cmpfloat(box.upper(k), >=, upper[k]);
        g_assert_cmpfloat(lower[k] - box.lower[k], <=, error);
        g_assert_cmpfloat(box.upper(k) - upper[k], <=, error);
        g_assert_cmpfloat(std::abs(box.tilts[k] - tilts[k]), <=, error);
    }
    g_assert_true(exact_box(box.lower, ends, box.tilts, is_sheared) == box);
    return box;
}

/// A position in the box, as LAMMPS has them.
Vector random_position(ExactBox const &box, Stream &random)
{
    Vector const fractions{random.uniform(), random.uniform(), random.uniform()};
    Vector x = box.lower + box.combination(fractions);
    for (std::size_t k = 0; k < 3; ++k) x[k] = box.rounded(k, x[k]);
    return x;
}

void test_exact_box()
{
    Stream random(5, 0, 0);
    for (int n = 0; n < 10000; ++n) {
        ExactBox const box = random_box(random, n % 2 != 0);
        Vector const x = random_position(box, random), y = random_position(box, random);
        Vector image;
        for (double &number : image) number = static_cast<double>(random.below(3)) - 1.0;
        Vector const shift = box.combination(image);
        for (std::size_t k = 0; k < 3; ++k) {
            g_assert_true(adds_exactly(x[k], shift[k]));
            g_assert_true(adds_exactly(x[k] + shift[k], -y[k]));
            g_assert_cmpfloat(x[k] + shift[k] - y[k], ==, x[k] - (y[k] - shift[k]));
        }
        // What LAMMPS's conversion to fractions and back does to a position is undone by rounding.
        Vector const back = box.lower + box.combination(box.fractions(x.data()));
        for (std::size_t k = 0; k < 3; ++k) g_assert_cmpfloat(box.rounded(k, back[k]), ==, x[k]);
    }
    // rounding reaches a power of two
    double const below = std::nextafter(1.0, 0.0);
    ExactBox const up = exact_box({0.0, 0.0, 0.0}, {below, below, below}, {}, false);
    g_assert_cmpfloat(up.upper(0), ==, 1.0);
    g_assert_cmpfloat(up.units[0], ==, 0x1p-50);
}

/// The heights of a sheared box are the distances of its faces.
void test_heights()
{
    ExactBox const box = exact_box({0.0, 0.0, 0.0}, {3.0, 2.0, 4.0}, {1.0, 0.0, 0.0}, true);
    Vector const heights = box.heights();
    g_assert_cmpfloat(std::abs(heights[0] - 3.0 * 2.0 / std::sqrt(5.0)), <=, 1e-15);
    // Edges without tilts, of any length.
    Stream random(9, 0, 0);
    for (int n = 0; n < 1000; ++n) {
        ExactBox const upright = random_box(random, false);
        g_assert_true(upright.heights() == upright.edges);
        ExactBox const sheared = random_box(random, true);
        Vector const a = sheared.combination({1.0, 0.0, 0.0}),
                     b = sheared.combination({0.0, 1.0, 0.0}),
                     c = sheared.combination({0.0, 0.0, 1.0});
        Vector const area = cross(b, c);
        double const expected = std::abs(dot(a, area)) / std::sqrt(dot(area, area));
        g_assert_cmpfloat(std::abs(sheared.heights()[0] - expected), <=, 1e-13 * expected);
    }
    g_assert_cmpfloat(heights[1], ==, 2.0);
    g_assert_cmpfloat(heights[2], ==, 4.0);
    Checkerboard const cells(box, {2, 4, 2});
    g_assert_cmpfloat(cells.height(1), ==, 0.5);
}

void test_cells()
{
    for (Vector const &tilts : {Vector{0.0, 0.0, 0.0}, Vector{2.0, -1.0, 3.0}}) {
        ExactBox const box =
            exact_box({-1.0, -1.0, -1.0}, {5.0, 5.0, 5.0}, tilts, tilts != Vector{});
        Checkerboard const cells(box, {4, 6, 2});
        std::array<int, 3> const counts{4, 6, 2};
        auto const place = [&](Vector const &f) { return box.lower + box.combination(f); };
        Vector const fractions{1.6 / 6.0, 4.9 / 6.0, 5.9 / 6.0};
        Checkerboard::Cell const cell = cells.cell(place(fractions).data());
        g_assert_true((cell == Checkerboard::Cell{1, 4, 1}));
        g_assert_cmpint(Checkerboard::colour(cell), ==, 5);
        g_assert_cmpint(cells.index(cell), ==, 1 + 4 * (4 + 6));
        g_assert_true(cells.is_inside(cell, place(fractions).data()));
        // Sides of cells, with their guards, along each direction
        for (std::size_t k = 0; k < 3; ++k) {
            double const lower = static_cast<double>(cell[k]) / counts[k],
                         upper = static_cast<double>(cell[k] + 1) / counts[k],
                         unit = box.units[k] / box.edges[k];
            for (auto const &[fraction, inside] :
                 {std::pair(lower + 14.0 * unit, false), std::pair(lower + 18.0 * unit, true),
                  std::pair(upper - 18.0 * unit, true), std::pair(upper - 14.0 * unit, false)}) {
                Vector f = fractions;
                f[k] = fraction;
                g_assert_true(cells.is_inside(cell, place(f).data()) == inside);
            }
        }
    }
}

/// A box that is longer by a cell holds all shifts by less than a cell.
void test_lengthened()
{
    Stream random(6, 0, 0);
    for (int n = 0; n < 1000; ++n) {
        ExactBox const box = random_box(random, false);
        int const count = 2 + 2 * static_cast<int>(random.below(5));
        ExactBox const longer = Checkerboard::lengthened(box, 2, count);
        Checkerboard const cells(longer, {2, 2, count});
        double const cell = box.edges[2] / (count - 1);
        g_assert_cmpfloat(std::abs(cells.height(2) - cell), <=, 4.0 * box.units[2]);
        g_assert_cmpfloat(longer.edges[0], ==, box.edges[0]);
        double const largest = 1.0 - 0x1p-53;
        Vector const shift = cells.in_cell({0.0, 0.0, n == 0 ? largest : random.uniform()});
        double const last = box.upper(2) - box.units[2];
        g_assert_true(adds_exactly(last, shift[2]));
        g_assert_cmpfloat(last + shift[2], <, longer.upper(2));
    }
}

void test_counts()
{
    for (bool const is_periodic : {true, false})
        g_assert_cmpint(Checkerboard::largest_count(1e300, 1e-300, is_periodic), ==, 1024);
    Stream random(8, 0, 0);
    for (int n = 0; n < 10000; ++n) {
        // Of 40 bits, so that the heights are exact.
        double const diameter = std::ldexp(std::floor(0x1p40 * (0.5 + 0.5 * random.uniform())),
                                           static_cast<int>(random.below(81)) - 80);
        int const count = 2 + 2 * static_cast<int>(random.below(20));
        for (bool const is_periodic : {true, false}) {
            double const height = (is_periodic ? count : count - 1) * diameter;
            g_assert_cmpint(Checkerboard::largest_count(height, diameter, is_periodic), ==, count);
            g_assert_cmpint(
                Checkerboard::largest_count(std::nextafter(height, 0.0), diameter, is_periodic), ==,
                count - 2);
        }
    }
    int const expected[][2] = {{2, 2},       {4, 4},   {6, 6},   {8, 8},   {10, 8},
                               {12, 12},     {14, 12}, {18, 16}, {22, 20}, {24, 24},
                               {34, 24 + 8}, {36, 36}, {46, 36}};
    for (auto const &[largest, count] : expected)
        g_assert_cmpint(Checkerboard::default_count(largest), ==, count);
}

} // namespace

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, nullptr);
    g_test_add_func("/checkerboard/streams", test_streams);
    g_test_add_func("/checkerboard/exact-box", test_exact_box);
    g_test_add_func("/checkerboard/heights", test_heights);
    g_test_add_func("/checkerboard/lengthened", test_lengthened);
    g_test_add_func("/checkerboard/cells", test_cells);
    g_test_add_func("/checkerboard/counts", test_counts);
    return g_test_run();
}
