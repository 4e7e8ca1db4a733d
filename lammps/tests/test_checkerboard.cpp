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

void check_words(PhiloxWords const &counter, std::uint64_t key, PhiloxWords const &expected)
{
    PhiloxWords const words = philox(counter, key);
    for (std::size_t k = 0; k < 4; ++k) g_assert_cmphex(words.word[k], ==, expected.word[k]);
}

/// The known answers that Random123, the implementation of the generator's authors, has for
/// philox4x32 with ten rounds.
void test_known_answers()
{
    check_words({{0, 0, 0, 0}}, 0, {{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}});
    std::uint32_t const ones = 0xffffffff;
    check_words({{ones, ones, ones, ones}}, ~std::uint64_t{0},
                {{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}});
    check_words({{0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}}, 0x299f31d0a4093822,
                {{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}});
}

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

/// Whether a + b has no rounding error (Knuth's sum of two numbers).
bool adds_exactly(double a, double b)
{
    double const sum = a + b, part = sum - a;
    return (a - (sum - part)) + (b - part) == 0.0;
}

void test_exact_period()
{
    Stream random(5, 0, 0);
    for (int k = 0; k < 10000; ++k) {
        double const size = std::ldexp(1.0, static_cast<int>(random.below(40)) - 20);
        double const lower = size * (random.uniform() - 0.5),
                     upper = lower + size * (0.001 + random.uniform());
        ExactPeriod const p = exact_period(lower, upper);
        g_assert_true(exact_period(p.lower, p.upper) == p);
        double const largest = std::max(std::abs(lower), std::abs(upper));
        g_assert_cmpfloat(std::abs(p.lower - lower), <=, 0x1p-49 * largest);
        g_assert_cmpfloat(std::abs(p.upper - upper), <=, 0x1p-49 * largest);
        double const x = p.rounded(p.lower + random.uniform() * p.edge());
        double const y = p.rounded(p.lower + random.uniform() * p.edge());
        for (double const shift : {-p.edge(), p.edge()}) {
            g_assert_true(adds_exactly(x, shift));
            g_assert_true(adds_exactly(x + shift, -y));
            g_assert_cmpfloat(x + shift - y, ==, x - (y - shift));
        }
    }
    // rounding reaches a power of two
    ExactPeriod const up = exact_period(0.0, std::nextafter(1.0, 0.0));
    g_assert_cmpfloat(up.upper, ==, 1.0);
    g_assert_cmpfloat(up.unit, ==, 0x1p-50);
}

void test_cells()
{
    ExactPeriod const side = exact_period(-1.0, 5.0);
    Checkerboard const cells({side, side, side}, {4, 6, 2});
    std::array<double, 3> const x{0.6, 3.9, 4.9};
    Checkerboard::Cell const cell = cells.cell(x.data());
    g_assert_true((cell == Checkerboard::Cell{1, 4, 1}));
    g_assert_cmpint(Checkerboard::colour(cell), ==, 5);
    g_assert_cmpint(cells.index(cell), ==, 1 + 4 * (4 + 6));
    g_assert_true(cells.is_inside(cell, x.data()));
    // Sides of cells, with their guards, along each direction
    for (std::size_t k = 0; k < 3; ++k) {
        double const lower = -1.0 + cell[k] * cells.edge(static_cast<int>(k)),
                     upper = lower + cells.edge(static_cast<int>(k));
        for (auto const &[place, inside] :
             {std::pair(lower + 15.0 * side.unit, false), std::pair(lower + 17.0 * side.unit, true),
              std::pair(upper - 17.0 * side.unit, true),
              std::pair(upper - 15.0 * side.unit, false)}) {
            auto y = x;
            y[k] = place;
            g_assert_true(cells.is_inside(cell, y.data()) == inside);
        }
    }
}

void test_counts()
{
    g_assert_cmpint(Checkerboard::largest_count(3.9, 2.0), ==, 0);
    g_assert_cmpint(Checkerboard::largest_count(4.0, 2.0), ==, 2);
    g_assert_cmpint(Checkerboard::largest_count(11.9, 2.0), ==, 4);
    g_assert_cmpint(Checkerboard::largest_count(1e300, 1e-300), ==, 1024);
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
    g_test_add_func("/checkerboard/known-answers", test_known_answers);
    g_test_add_func("/checkerboard/streams", test_streams);
    g_test_add_func("/checkerboard/exact-period", test_exact_period);
    g_test_add_func("/checkerboard/cells", test_cells);
    g_test_add_func("/checkerboard/counts", test_counts);
    return g_test_run();
}
