// SPDX-License-Identifier: BSD-3-Clause
// Tests of periodic cells: reduction, nearest images in cases that depend on each lattice vector
// that can matter, multiples of images, and the limit up to which nearest images suffice.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <glib.h>

#include <pw85/systems.hpp>

#include "../cases.hpp"
#include "../draws.hpp"
#include "../failures.hpp"
#include "../systems.hpp"
#include "batch_data.hpp"

using namespace pw85_tests;

namespace {

constexpr double u = 0x1p-53;

using Multiples = std::array<int, 3>;

constexpr Form3 unit_sphere{1.0, 0.0, 0.0, 1.0, 0.0, 1.0};

Vector3 combine(pw85::Cell const &cell, Multiples const &k, Vector3 x = {})
{
    for (std::size_t i = 0; i < 3; ++i)
        for (int d = 0; d < 3; ++d) x[d] += k[i] * cell[i][d];
    return x;
}

double square(Vector3 const &x) { return pw85::dot(x, x); }

std::string cell_text(pw85::Cell const &cell)
{
    return "cell = " + hex_text(cell[0].coordinates, 3) + hex_text(cell[1].coordinates, 3) +
           hex_text(cell[2].coordinates, 3);
}

/// Visits all multiples up to `reach`.
template <class Visit> void visit_multiples(int reach, Visit visit)
{
    for (int i = -reach; i <= reach; ++i)
        for (int j = -reach; j <= reach; ++j)
            for (int k = -reach; k <= reach; ++k) visit(Multiples{i, j, k});
}

/// Few binary digits, so that sums of multiples are exact.
double rounded(double x) { return std::round(x * 0x1p20) * 0x1p-20; }

pw85::Cell random_cell(Random &random, double flatness)
{
    pw85::Cell cell;
    for (std::size_t i = 0; i < 3; ++i)
        for (int d = 0; d < 3; ++d)
            cell[i][d] = rounded((d == 2 ? flatness : 1.0) * random.uniform(-1.0, 1.0));
    return cell;
}

double volume(pw85::Cell const &cell) { return pw85::dot(cell[0], pw85::cross(cell[1], cell[2])); }

/// Whether no vector gets shorter by adding up to two of each other one.
void check_reduced(Failures &failures, pw85::Cell const &cell, pw85::Cell const &reduced)
{
    double longest = 0.0;
    for (auto const &b : reduced) longest = std::max(longest, square(b));
    visit_multiples(2, [&](Multiples const &k) {
        for (std::size_t i = 0; i < 3; ++i) {
            if (std::abs(k[i]) != 1) continue;
            double const length = square(combine(reduced, k));
            failures.check(length >= square(reduced[i]) - 0x1p-40 * longest,
                           "square of a shorter vector", length, square(reduced[i]),
                           [&] { return cell_text(cell) + " reduced " + cell_text(reduced); });
        }
    });
}

/// Whether both cells span one lattice: of like volume, and one with integer coordinates in the
/// other.
void check_same_lattice(Failures &failures, pw85::Cell const &cell, pw85::Cell const &reduced)
{
    auto const describe = [&] { return cell_text(cell) + " reduced " + cell_text(reduced); };
    double const v = volume(reduced);
    failures.check(std::fabs(volume(cell) - v) <= 1e-9 * std::fabs(v), "volume", v, volume(cell),
                   describe);
    for (auto const &a : cell)
        for (std::size_t i = 0; i < 3; ++i) {
            double const x =
                pw85::dot(a, pw85::cross(reduced[(i + 1) % 3], reduced[(i + 2) % 3])) / v;
            failures.check(std::fabs(x - std::round(x)) <= 1e-6, "coordinate", x, std::round(x),
                           describe);
        }
}

// Cells of all shapes, flat ones too, by many kinds of vectors.
PW85_TEST("/lattice/reduce")
{
    Failures failures;
    Random random(31);
    for (int n = 0; n < draws(3000); ++n) {
        pw85::Cell const compact = random_cell(random, n % 2 == 0 ? 1.0 : 1e-3),
                         cell = skew(random, compact, n % 20);
        if (!(std::fabs(volume(compact)) > 1e-7)) continue;
        auto const [reduced, status] = pw85::cell_reduce(cell);
        g_assert_true(status == pw85::Status::success);
        check_reduced(failures, cell, reduced);
        check_same_lattice(failures, compact, reduced);
        // What is reduced stays as it is, in place too.
        double again[9];
        std::memcpy(again, &reduced, sizeof again);
        g_assert_cmpint(pw85_cell_reduce(again, again), ==, PW85_SUCCESS);
        g_assert_true(std::memcmp(again, &reduced, sizeof again) == 0);
    }
}

// Three vectors of like length at almost 120 degrees in almost one plane: only their sum is
// shorter.
PW85_TEST("/lattice/reduce_triples")
{
    Failures failures;
    for (double const height : {0.25, 0x1p-8, 0x1p-16})
        for (int signs = 0; signs < 8; ++signs) {
            pw85::Cell cell = {{{2, 0, height}, {-1, 1.75, height}, {-1, -1.75, height}}};
            for (std::size_t i = 0; i < 3; ++i)
                if (signs >> i & 1) cell[i] = -cell[i];
            auto const [reduced, status] = pw85::cell_reduce(cell);
            g_assert_true(status == pw85::Status::success);
            check_reduced(failures, cell, reduced);
            check_same_lattice(failures, cell, reduced);
        }
}

// Lengths as extreme as those of particles may be; and what is not a cell.
PW85_TEST("/lattice/reduce_range")
{
    for (double const scale : {0x1p-498, 0x1p-101, 0x1p-99, 1.0, 0x1p99, 0x1p101, 0x1p498}) {
        double const cell[9] = {scale, 0, 0, 5 * scale, scale, 0, -3 * scale, 7 * scale, scale};
        double const expected[9] = {scale, 0, 0, 0, scale, 0, 0, 0, scale};
        double reduced[9];
        g_assert_cmpint(pw85_cell_reduce(cell, reduced), ==, PW85_SUCCESS);
        for (int k = 0; k < 9; ++k) g_assert_cmpfloat(reduced[k], ==, expected[k]);
    }
    double const nan = std::numeric_limits<double>::quiet_NaN();
    double const bad[][9] = {{},
                             {1, 0, 0, 0, 1, 0, 1, 1, 0},
                             {0.3, 0.1, 0.7, 3 * 0.3, 3 * 0.1, 3 * 0.7, 0, 0, 1},
                             {1, 0, 0, 0, nan, 0, 0, 0, 1},
                             {1, 0, 0, 0, HUGE_VAL, 0, 0, 0, 1}};
    for (auto const &cell : bad) {
        double reduced[9] = {};
        g_assert_cmpint(pw85_cell_reduce(cell, reduced), ==, PW85_EINVAL);
        for (double const x : reduced) g_assert_true(std::isnan(x));
    }
    double reduced[9] = {};
    g_assert_cmpint(pw85_cell_reduce(nullptr, reduced), ==, PW85_EINVAL);
    g_assert_true(std::isnan(reduced[0]));
    g_assert_cmpint(pw85_cell_reduce(bad[0], nullptr), ==, PW85_EINVAL);
}

/// Quarters of the squared distances of the nearest images, as the library sees them: μ² of unit
/// spheres.
std::vector<double> quarter_squares(pw85::Cell const &cell, std::vector<Vector3> const &r12)
{
    std::vector<Vector3> centers = {{0, 0, 0}};
    centers.insert(centers.end(), r12.begin(), r12.end());
    std::vector<Form3> const q(centers.size(), unit_sphere);
    std::vector<pw85::IndexPair> pairs;
    for (std::size_t k = 0; k < r12.size(); ++k)
        pairs.push_back({0, static_cast<std::int32_t>(k) + 1});
    std::vector<double> mu2(r12.size());
    g_assert_true(pw85::contact_pairs({pairs}, {centers, q, &cell}, mu2) == pw85::Status::success);
    return mu2;
}

/// One of ±k.
Multiples positive(Multiples k)
{
    int const leading = k[0] != 0 ? k[0] : k[1] != 0 ? k[1] : k[2];
    if (leading < 0)
        for (int &x : k) x = -x;
    return k;
}

/// Checks separations with coordinates up to ½ in a reduced cell, and counts by which lattice
/// vectors they get nearer, if no other vector will do: the runner-up is longer by 1 % at least.
void check_shifts(Failures &failures, Random &random, pw85::Cell const &cell,
                  std::map<Multiples, int> &decided)
{
    std::vector<Vector3> separations;
    std::vector<double> expected;
    for (int n = 0; n < 100; ++n) {
        Vector3 r{};
        for (auto const &b : cell) {
            double const y = rounded(random.uniform(-0.5, 0.5)) * 0.9375;
            for (int d = 0; d < 3; ++d) r[d] += y * b[d];
        }
        double nearest = HUGE_VAL, second = HUGE_VAL;
        Multiples best{};
        visit_multiples(2, [&](Multiples const &k) {
            double const distance = square(combine(cell, k, r));
            second = std::min(second, std::max(nearest, distance));
            if (distance < nearest) best = k;
            nearest = std::min(nearest, distance);
        });
        if (second > 1.01 * nearest) ++decided[positive(best)];
        separations.push_back(r);
        expected.push_back(nearest / 4.0);
    }
    auto const actual = quarter_squares(cell, separations);
    for (std::size_t n = 0; n < actual.size(); ++n)
        failures.check(std::fabs(actual[n] - expected[n]) <= 1e-12,
                       "quarter of the squared distance", actual[n], expected[n],
                       [&] { return cell_text(cell) + hex_text(separations[n].coordinates, 3); });
}

// Each lattice vector that a separation may be moved by is the only right one for some.
PW85_TEST("/lattice/every_shift")
{
    Failures failures;
    Random random(32);
    std::map<Multiples, int> decided;
    for (int n = 0; n < draws(4000); ++n) {
        auto const [cell, status] = pw85::cell_reduce(random_cell(random, 1.0));
        if (status == pw85::Status::success) check_shifts(failures, random, cell, decided);
    }
    g_assert_cmpuint(decided.size(), ==, 10); // nine couples, and none
    for (auto const &[k, count] : decided) g_assert_cmpint(count, >=, 5);
}

// One vector orthogonal to both others: two couples, whichever vector it is.
PW85_TEST("/lattice/shifts_of_prisms")
{
    Failures failures;
    Random random(33);
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (double const x : {-0.5, -0.4375, 0.25, 0.5}) {
            pw85::Cell cell{};
            cell[axis][2] = 0.75;
            cell[(axis + 1) % 3][0] = 1.0;
            cell[(axis + 2) % 3][0] = x;
            cell[(axis + 2) % 3][1] = 0.875;
            std::map<Multiples, int> decided;
            for (int n = 0; n < 30; ++n) check_shifts(failures, random, cell, decided);
            g_assert_cmpuint(decided.size(), ==, 3);
            for (auto const &[k, count] : decided) g_assert_cmpint(count, >=, 5);
        }
}

// Two vectors orthogonal to each other, but not to the third: all nine couples, whichever vector it
// is.
PW85_TEST("/lattice/shifts_of_oblique_cells")
{
    Failures failures;
    Random random(36);
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (double const x : {-0.25, 0.4375})
            for (double const y : {-0.3125, 0.375}) {
                pw85::Cell cell{};
                cell[(axis + 1) % 3][0] = 1.0;
                cell[(axis + 2) % 3][1] = 0.875;
                cell[axis] = {x, y, 0.75};
                std::map<Multiples, int> decided;
                for (int n = 0; n < 30; ++n) check_shifts(failures, random, cell, decided);
                g_assert_cmpuint(decided.size(), >=, 4);
            }
}

// A list with images is a batch of the separations that they mean, for any cell that is finite.
PW85_TEST("/lattice/images")
{
    Random random(34);
    pw85::Cell const cells[] = {skew(random, random_cell(random, 1.0), 3),
                                {{{4, 0, 0}, {1, 5, 0}, {0, 0, 0}}}}; // periodic in two directions
    for (auto const &cell : cells) {
        std::size_t const n = 9000, num_particles = 100;
        std::vector<Vector3> centers;
        std::vector<Form3> q;
        for (std::size_t i = 0; i < num_particles; ++i) {
            Vector3 x;
            for (int d = 0; d < 3; ++d) x[d] = rounded(random.uniform(0.0, 4.0));
            centers.push_back(x);
            q.push_back(random.form(1.0, 3.0));
        }
        std::vector<pw85::IndexPair> pairs;
        std::vector<pw85::Image> images;
        std::vector<Pair3> separations;
        for (std::size_t k = 0; k < n; ++k) {
            auto const index = [&] {
                return static_cast<std::int32_t>(random.uniform(0.0, num_particles));
            };
            auto const multiple = [&] {
                return static_cast<std::int32_t>(random.uniform(-3.0, 4.0));
            };
            auto const [i, j] = pairs.emplace_back(pw85::IndexPair{index(), index()});
            auto const [a, b, c] =
                images.emplace_back(pw85::Image{multiple(), multiple(), multiple()});
            Pair3 p{combine(cell, {a, b, c}), q[static_cast<std::size_t>(i)],
                    q[static_cast<std::size_t>(j)]};
            for (int d = 0; d < 3; ++d)
                p.r12[d] += centers[static_cast<std::size_t>(j)][d] -
                            centers[static_cast<std::size_t>(i)][d];
            separations.push_back(p);
        }
        BatchResult const expected = run_batch(separations);
        BatchResult result{std::vector<double>(n), std::vector<double>(n),
                           std::vector<unsigned char>(n), 0, 0};
        pw85::Particles const particles{centers, q, &cell};
        g_assert_true(pw85::contact_pairs({pairs, images}, particles, result.mu2, result.lambda) ==
                      pw85::Status::success);
        g_assert_true(pw85::overlap_pairs({pairs, images}, particles, result.overlap) ==
                      pw85::Status::success);
        for (std::size_t k = 0; k < n; ++k) g_assert_true(result.same_row(k, expected, k));
    }
}

// The images, added to the second particles, give the vectors; the vectors are the shortest of
// those around; and functions of lists find the same images. Cells by skewed vectors, particles
// many cells apart.
PW85_TEST("/lattice/nearest_images")
{
    Failures failures;
    Random random(36);
    for (int n = 0; n < 300; ++n) {
        pw85::Cell const compact = random_cell(random, 1.0), cell = skew(random, compact, n % 12);
        if (!(std::fabs(volume(compact)) > 1e-3)) continue;
        std::vector<pw85::Vector<double, 3>> centers(20), r12(100);
        std::vector<pw85::IndexPair> pairs(100);
        std::vector<pw85::Image> images(100);
        for (auto &x : centers)
            x = {random.uniform(-30, 30), random.uniform(-30, 30), random.uniform(-30, 30)};
        for (auto &pair : pairs)
            for (auto &i : pair) i = static_cast<std::int32_t>(random.uniform(0.0, 20.0));
        auto const text = [&] { return cell_text(cell); };
        g_assert_true(pw85::nearest_images(pairs, {centers, {}, &cell}, r12, images) ==
                      pw85::Status::success);
        for (std::size_t k = 0; k < pairs.size(); ++k) {
            auto const &x = centers[static_cast<std::size_t>(pairs[k][0])],
                       &y = centers[static_cast<std::size_t>(pairs[k][1])];
            auto const shift = combine(cell, {images[k][0], images[k][1], images[k][2]});
            for (int d = 0; d < 3; ++d)
                failures.check(std::fabs(y[d] - x[d] + shift[d] - r12[k][d]) <= 1e-10, "image",
                               r12[k][d], y[d] - x[d] + shift[d], text);
            visit_multiples(1, [&](Multiples const &m) {
                auto other = combine(compact, m);
                for (int d = 0; d < 3; ++d) other[d] += r12[k][d];
                failures.check(square(other) >= square(r12[k]) - 1e-10, "nearer", square(other),
                               square(r12[k]), text);
            });
        }
    }
}

PW85_TEST("/lattice/nearest_images/arguments")
{
    double const nan = std::numeric_limits<double>::quiet_NaN();
    double const cell[9] = {2, 0, 0, 0, 2, 0, 0, 0, 2}, flat[9] = {2, 0, 0, 0, 2, 0, 2, 2, 0};
    double const centers[12] = {0, 0, 0, 1e12, 0, 0, nan, 0, 0, 7, 0, 0};
    std::int32_t const pairs[8] = {0, 3, 0, 1, 1, 2, 3, 3}, outside[2] = {0, 4};
    double r12[12];
    std::int32_t images[12];
    g_assert_cmpint(
        pw85_nearest_images(4, pairs, system_of(4, centers, nullptr, cell), r12, images), ==,
        PW85_EINVAL);
    double const expected[4] = {-1.0, nan, nan, 0.0};
    std::int32_t const multiples[4] = {-4, INT32_MIN, INT32_MIN, 0};
    for (int k = 0; k < 4; ++k) {
        g_assert_true(std::isnan(expected[k]) ? std::isnan(r12[3 * k])
                                              : std::fabs(r12[3 * k]) == -expected[k]);
        g_assert_true(images[3 * k] == multiples[k] || (k == 0 && images[0] == -3));
    }
    g_assert_cmpint(
        pw85_nearest_images(2, pairs, system_of(4, centers, nullptr, cell), r12, nullptr), ==,
        PW85_SUCCESS);
    g_assert_cmpint(
        pw85_nearest_images(2, pairs, system_of(4, centers, nullptr, cell), nullptr, nullptr), ==,
        PW85_SUCCESS);
    g_assert_cmpint(
        pw85_nearest_images(0, nullptr, system_of(0, nullptr, nullptr, nullptr), nullptr, nullptr),
        ==, PW85_SUCCESS);
    for (double const *bad : {flat, static_cast<double const *>(nullptr)})
        g_assert_cmpint(
            pw85_nearest_images(1, pairs, system_of(4, centers, nullptr, bad), r12, images), ==,
            PW85_EINVAL);
    g_assert_cmpint(
        pw85_nearest_images(1, outside, system_of(4, centers, nullptr, cell), r12, images), ==,
        PW85_EINVAL);
    g_assert_cmpint(
        pw85_nearest_images(1, nullptr, system_of(4, centers, nullptr, cell), r12, images), ==,
        PW85_EINVAL);
    g_assert_cmpint(
        pw85_nearest_images(1, pairs, system_of(4, nullptr, nullptr, cell), r12, images), ==,
        PW85_EINVAL);
}

PW85_TEST("/lattice/image_arguments")
{
    double const x[6] = {1.0, 0.0, 0.0, 1.0, 0.0, 1.0}, cell[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    std::int32_t const pairs[2] = {0, 0}, image[3] = {3, 0, 0};
    double mu2 = 7.0;
    unsigned char overlap = 7;
    g_assert_cmpint(
        pw85_contact_pairs(list_of(1, pairs, image), system_of(1, x, x, nullptr), &mu2, nullptr),
        ==, PW85_EINVAL);
    g_assert_cmpint(
        pw85_overlap_pairs(list_of(1, pairs, image), system_of(1, x, x, nullptr), &overlap), ==,
        PW85_EINVAL);
    for (double const bad : {std::numeric_limits<double>::quiet_NaN(), HUGE_VAL}) {
        double const bad_cell[9] = {1, 0, 0, 0, bad, 0, 0, 0, 1};
        g_assert_cmpint(pw85_contact_pairs(list_of(1, pairs, image), system_of(1, x, x, bad_cell),
                                           &mu2, nullptr),
                        ==, PW85_EINVAL);
        g_assert_cmpint(
            pw85_overlap_pairs(list_of(1, pairs, image), system_of(1, x, x, bad_cell), &overlap),
            ==, PW85_EINVAL);
    }
    g_assert_true(mu2 == 7.0 && overlap == 7);
    // A particle and its own image, three cells away.
    g_assert_cmpint(
        pw85_contact_pairs(list_of(1, pairs, image), system_of(1, x, x, cell), &mu2, nullptr), ==,
        PW85_SUCCESS);
    g_assert_cmpint(
        pw85_overlap_pairs(list_of(1, pairs, image), system_of(1, x, x, cell), &overlap), ==,
        PW85_SUCCESS);
    g_assert_true(std::fabs(mu2 - 2.25) <= 4 * u * 2.25 && overlap == 0);
    std::vector<Vector3> const centers(2);
    std::vector<Form3> const q(2, unit_sphere);
    std::vector<pw85::IndexPair> const list = {{0, 1}};
    std::vector<pw85::Image> const two_images(2);
    pw85::Cell const cubic = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    std::vector<double> out(1);
    g_assert_true(pw85::contact_pairs({list, two_images}, {centers, q, &cubic}, out) ==
                  pw85::Status::invalid_argument);
}

/// A system, and what the functions for cells say of it.
struct CellAnswers {
    pw85::Cell reduced;
    double limit;
    std::vector<Vector3> r12;
    std::vector<pw85::Image> images;
    std::vector<pw85::IndexPair> neighbors;
    std::vector<pw85::Image> neighbor_images;
    std::vector<unsigned char> overlap;

    CellAnswers(pw85::Cell const &cell, std::vector<Vector3> const &centers,
                std::vector<Form3> const &q)
    {
        auto const good = [](pw85::Status status) {
            g_assert_true(status == pw85::Status::success);
        };
        auto const result = pw85::cell_reduce(cell);
        good(result.status);
        reduced = result.cell;
        good(pw85::nearest_image_limit({{}, q, &cell}, limit));
        std::vector<pw85::IndexPair> pairs;
        for (std::int32_t i = 0; i < static_cast<std::int32_t>(q.size()); ++i)
            for (std::int32_t j = 0; j < i; ++j) pairs.push_back({i, j});
        r12.resize(pairs.size());
        images.resize(pairs.size());
        overlap.resize(pairs.size());
        pw85::Particles const particles{centers, q, &cell};
        good(pw85::nearest_images(pairs, particles, r12, images));
        good(pw85::overlap_pairs({pairs}, particles, overlap));
        pw85::Neighbors list;
        good(neighbors_create(particles, {}, list));
        neighbors.assign(list.pairs().begin(), list.pairs().end());
        neighbor_images.assign(list.images().begin(), list.images().end());
    }

    /// Whether these are the answers to the same in a unit that is so many times as large.
    bool are_scaled(CellAnswers const &other, double unit) const
    {
        bool same = limit == other.limit && images == other.images &&
                    neighbors == other.neighbors && neighbor_images == other.neighbor_images &&
                    overlap == other.overlap;
        for (std::size_t k = 0; k < r12.size(); ++k)
            same = same && are_scaled(r12[k], other.r12[k], unit);
        for (std::size_t k = 0; k < 3; ++k)
            same = same && are_scaled(reduced[k], other.reduced[k], unit);
        return same;
    }

  private:
    static bool are_scaled(Vector3 const &x, Vector3 const &y, double unit)
    {
        return x[0] == unit * y[0] && x[1] == unit * y[1] && x[2] == unit * y[2];
    }
};

// Powers of two change nothing but the unit, up to the sizes that particles may have, nor does
// skewness: what is right for one size, which other tests check, is for all.
PW85_TEST("/lattice/units")
{
    Failures failures;
    Random random(37);
    for (int n = 0; n < draws(150); ++n) {
        pw85::Cell const compact = random_cell(random, n % 3 == 0 ? 0.25 : 1.0),
                         cell = skew(random, compact, n % 16);
        if (!(std::fabs(volume(compact)) > 1e-2)) continue;
        std::vector<Vector3> centers;
        std::vector<Form3> q;
        for (int i = 0; i < 8; ++i) {
            centers.push_back(
                {random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0)});
            q.push_back(random.form(random.log_uniform(0.05, 0.5), 3.0));
        }
        CellAnswers const expected(cell, centers, q);
        for (int const exponent : {-498, -300, -110, -101, -100, -99, -98, -40, 40, 95, 98, 99, 100,
                                   101, 110, 300, 498}) {
            double const unit = std::ldexp(1.0, exponent);
            pw85::Cell scaled = cell;
            for (auto &row : scaled) row = unit * row;
            auto scaled_centers = centers;
            for (auto &center : scaled_centers) center = unit * center;
            auto forms = q;
            for (auto &form : forms)
                for (int k = 0; k < 6; ++k) form[k] *= unit * unit;
            failures.check(CellAnswers(scaled, scaled_centers, forms).are_scaled(expected, unit),
                           "answers in the unit", unit, 1, [&] { return cell_text(cell); });
        }
    }
}

/// The limit over all vectors near the origin, of which those that are no faces of the Voronoi cell
/// do not matter.
double expected_limit(pw85::Cell const &reduced, std::vector<Form3> const &q)
{
    double limit = HUGE_VAL;
    visit_multiples(2, [&](Multiples const &k) {
        Vector3 const v = combine(reduced, k);
        if (k == Multiples{}) return;
        for (Form3 const &form : q)
            limit = std::min(limit, square(v) * square(v) /
                                        (16.0 * pw85::detail::quadratic_form(form, v)));
    });
    return limit;
}

// The limit is what it is said to be, and no image that is not the nearest is below it.
PW85_TEST("/lattice/limit")
{
    Failures failures;
    Random random(35);
    for (int n = 0; n < 60; ++n) {
        pw85::ReducedCell const reduced =
            pw85::cell_reduce(random_cell(random, n % 3 == 0 ? 0.25 : 1.0));
        if (reduced.status != pw85::Status::success) continue;
        pw85::Cell const &cell = reduced.cell;
        pw85::Cell const skewed = skew(random, cell, n % 4);
        std::vector<Form3> q;
        for (int i = 0; i < 3; ++i)
            q.push_back(random.form(random.log_uniform(0.03, 0.3), random.log_uniform(1.0, 10.0)));
        double limit = 0.0;
        g_assert_true(pw85::nearest_image_limit({{}, q, &skewed}, limit) == pw85::Status::success);
        double const expected = expected_limit(cell, q);
        auto const describe = [&] { return cell_text(skewed); };
        failures.check(std::fabs(limit / expected - 1.0) <= 1e-11, "limit", limit, expected,
                       describe);
        for (int trial = 0; trial < 20; ++trial) {
            Vector3 r{};
            for (int d = 0; d < 3; ++d) r[d] = random.uniform(-1.0, 1.0);
            double nearest = HUGE_VAL;
            visit_multiples(4, [&](Multiples const &k) {
                nearest = std::min(nearest, square(combine(cell, k, r)));
            });
            visit_multiples(4, [&](Multiples const &k) {
                Vector3 const x = combine(cell, k, r);
                if (square(x) <= nearest * (1.0 + 1e-9)) return;
                for (Form3 const &form : q) {
                    double const mu2 = pw85::contact(x, form, q[0]).mu2;
                    failures.check(mu2 >= limit * (1.0 - 1e-9), "mu^2 of another image", mu2, limit,
                                   describe);
                }
            });
        }
    }
}

// Needles along each of the lattice vectors that can be half-way through a face: of the
// body-centred lattice, by bases of all signs, they are the vectors of the basis, three sums of two
// and one of three.
PW85_TEST("/lattice/limit_of_needles")
{
    Failures failures;
    for (int signs = 0; signs < 8; ++signs) {
        pw85::Cell cell = {{{-1, 1, 1}, {1, -1, 1}, {1, 1, -1}}};
        for (std::size_t i = 0; i < 3; ++i)
            if (signs >> i & 1) cell[i] = -cell[i];
        visit_multiples(1, [&](Multiples const &k) {
            if (k == Multiples{}) return;
            std::vector<Form3> const needle = {pw85::spheroid(0x1p-6, 0.5, combine(cell, k)).q};
            double limit = 0.0;
            g_assert_true(pw85::nearest_image_limit({{}, needle, &cell}, limit) ==
                          pw85::Status::success);
            double const expected = expected_limit(cell, needle);
            failures.check(std::fabs(limit / expected - 1.0) <= 1e-13, "limit", limit, expected,
                           [&] { return cell_text(cell) + hex_text(needle[0].entries, 6); });
        });
    }
}

PW85_TEST("/lattice/limit_arguments")
{
    double const cell[9] = {8, 0, 0, 0, 4, 0, 0, 0, 6}, singular[9] = {1, 0, 0, 0, 1, 0, 1, 1, 0};
    double const q[12] = {1, 0, 0, 1, 0, 1, 4, 0, 0, 0.25, 0, 1};
    double mu2 = 7.0;
    g_assert_cmpint(pw85_nearest_image_limit(system_of(2, nullptr, q, cell), &mu2), ==,
                    PW85_SUCCESS);
    g_assert_cmpfloat(mu2, ==, 1.0); // both 8/(4·2) and 4/(4·1)
    g_assert_cmpint(pw85_nearest_image_limit(system_of(0, nullptr, nullptr, cell), &mu2), ==,
                    PW85_SUCCESS);
    g_assert_cmpfloat(mu2, ==, HUGE_VAL);
    double const nan = std::numeric_limits<double>::quiet_NaN();
    double const not_finite[6] = {1, 0, nan, 1, 0, 1}, indefinite[6] = {1, 2, 0, 1, 0, 1};
    auto const check = [&](int expected, std::size_t n, double const *forms, double const *c) {
        mu2 = 7.0;
        g_assert_cmpint(pw85_nearest_image_limit(system_of(n, nullptr, forms, c), &mu2), ==,
                        expected);
        g_assert_true(std::isnan(mu2));
    };
    check(PW85_EINVAL, 1, not_finite, cell);
    check(PW85_ENOTPD, 1, indefinite, cell);
    check(PW85_EINVAL, 1, q, singular);
    for (int k = 0; k < 9; ++k)
        for (double const entry :
             {nan, HUGE_VAL, k % 4 == 0 ? 0.0 : nan, k % 4 == 0 ? 0x1p-60 : nan}) {
            double bad[9];
            std::copy_n(cell, 9, bad);
            bad[k] = entry;
            check(PW85_EINVAL, 1, q, bad);
        }
    check(PW85_EINVAL, 1, q, nullptr);
    check(PW85_EINVAL, 1, nullptr, cell);
    check(PW85_EINVAL, SIZE_MAX / 8, q, cell);
    g_assert_cmpint(pw85_nearest_image_limit(system_of(1, nullptr, q, cell), nullptr), ==,
                    PW85_EINVAL);
}

} // namespace
