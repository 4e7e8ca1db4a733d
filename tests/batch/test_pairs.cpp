// SPDX-License-Identifier: BSD-3-Clause
// The functions for neighbour lists give the same as a batch of the separations, and nearest images
// are right in any periodic cell.
#include <algorithm>
#include <cstdint>
#include <initializer_list>

#include <glib.h>

#include <pw85/batch.hpp>
#include <pw85/systems.hpp>

#include "../cases.hpp"
#include "../draws.hpp"
#include "../failures.hpp"
#include "../systems.hpp"
#include "batch_data.hpp"

using namespace pw85_tests;

namespace {

constexpr double u = 0x1p-53;

using Wide3 = pw85::Vector<long double, 3>;

/// Particles and a list of pairs of them.
struct System {
    std::vector<Vector3> centers;
    std::vector<Form3> q;
    std::vector<pw85::IndexPair> pairs;

    System(Random &random, std::size_t num_particles, std::size_t num_pairs, double size)
    {
        for (std::size_t i = 0; i < num_particles; ++i) {
            Vector3 x;
            for (int d = 0; d < 3; ++d) x[d] = random.uniform(0.0, size);
            centers.push_back(x);
            q.push_back(random.form(1.0, random.log_uniform(1.0, 10.0)));
        }
        auto const n = static_cast<double>(num_particles);
        for (std::size_t k = 0; k < num_pairs; ++k)
            pairs.push_back({static_cast<std::int32_t>(random.uniform(0.0, n)),
                             static_cast<std::int32_t>(random.uniform(0.0, n))});
    }

    Vector3 const &center(std::size_t k, int end) const
    {
        return centers[static_cast<std::size_t>(pairs[k][static_cast<std::size_t>(end)])];
    }
    Form3 const &form(std::size_t k, int end) const
    {
        return q[static_cast<std::size_t>(pairs[k][static_cast<std::size_t>(end)])];
    }
};

BatchResult run_pairs(System const &system, pw85::Cell const *cell = nullptr)
{
    std::size_t const n = system.pairs.size();
    BatchResult result{std::vector<double>(n), std::vector<double>(n),
                       std::vector<unsigned char>(n), 0, 0};
    pw85::Particles const particles{system.centers, system.q, cell};
    result.contact_status =
        static_cast<int>(pw85::contact_pairs({system.pairs}, particles, result.mu2, result.lambda));
    result.overlap_status =
        static_cast<int>(pw85::overlap_pairs({system.pairs}, particles, result.overlap));
    return result;
}

// Without a cell: the bits of a batch of the differences of the centres, also for a particle with
// itself, and bad ones.
PW85_TEST("/pairs/like_batch")
{
    Failures failures;
    Random random(11);
    for (std::size_t const n :
         std::initializer_list<std::size_t>{0, 1, 2, 7, 8, 9, 31, 1000, 20000}) {
        System system(random, 300, n, 10.0);
        if (n == 1000) {
            system.q[17][3] = -1.0;
            system.centers[40][2] = std::numeric_limits<double>::quiet_NaN();
            system.centers[41][0] = HUGE_VAL;
            system.pairs[0] = {3, 3};
        }
        std::vector<Pair3> pairs(n);
        for (std::size_t k = 0; k < n; ++k) {
            for (int d = 0; d < 3; ++d)
                pairs[k].r12[d] = system.center(k, 1)[d] - system.center(k, 0)[d];
            pairs[k].q1 = system.form(k, 0);
            pairs[k].q2 = system.form(k, 1);
        }
        BatchResult const result = run_pairs(system), expected = run_batch(pairs);
        g_assert_cmpint(result.contact_status, ==, expected.contact_status);
        g_assert_cmpint(result.overlap_status, ==, expected.overlap_status);
        for (std::size_t k = 0; k < n; ++k)
            failures.check(result.same_row(k, expected, k), "mu^2", result.mu2[k], expected.mu2[k],
                           [&] { return hex_text(pairs[k]); });
        if (n == 1000)
            g_assert_true(result.mu2[0] == 0.0 && result.lambda[0] == 0.5 &&
                          result.overlap[0] == 1);
    }
}

template <class T>
pw85::Vector<T, 3> combine(pw85::Cell const &cell, T a, T b, T c, pw85::Vector<T, 3> x)
{
    for (int d = 0; d < 3; ++d)
        x[d] += a * static_cast<T>(cell[0][d]) + b * static_cast<T>(cell[1][d]) +
                c * static_cast<T>(cell[2][d]);
    return x;
}

/// Calls visit(x) with those of 729 images x of r whose squared length is, to rounding, at most the
/// least one so far. Most are passed over in doubles: where there is no long double in hardware, it
/// costs a hundred times as much.
template <class Visit> void visit_nearest(pw85::Cell const &cell, Wide3 const &r, Visit visit)
{
    // Squares are below 2^18, and each of two errs by less than 16 u of that.
    double const slack = 0x1p-30;
    double nearest = HUGE_VAL;
    for (int i = -4; i <= 4; ++i)
        for (int j = -4; j <= 4; ++j)
            for (int k = -4; k <= 4; ++k) {
                Vector3 const rough = combine<double>(cell, i, j, k, convert<double>(r));
                g_assert_cmpfloat(pw85::dot(rough, rough), <, 3 * 0x1p16);
                if (pw85::dot(rough, rough) > nearest + slack) continue;
                nearest = std::min(nearest, pw85::dot(rough, rough));
                visit(combine<long double>(cell, i, j, k, r));
            }
}

/// The squared distance of the nearest of 729 images around the one with coordinates in [-1/2,
/// 1/2]: enough for a cell whose vectors are of like length and at angles above 45 degrees.
long double nearest_square(pw85::Cell const &cell, Wide3 r)
{
    auto const a = convert<long double>(cell[0]), b = convert<long double>(cell[1]),
               c = convert<long double>(cell[2]);
    long double const volume = pw85::dot(a, pw85::cross(b, c));
    r = combine<long double>(cell, -std::round(pw85::dot(r, pw85::cross(b, c)) / volume),
                             -std::round(pw85::dot(r, pw85::cross(c, a)) / volume),
                             -std::round(pw85::dot(r, pw85::cross(a, b)) / volume), r);
    long double nearest = HUGE_VALL;
    visit_nearest(cell, r, [&](Wide3 const &x) { nearest = std::min(nearest, pw85::dot(x, x)); });
    return nearest;
}

/// A compact cell: a cube with entries disturbed by up to 0.4 of its side.
pw85::Cell compact_cell(Random &random, double side)
{
    pw85::Cell cell;
    for (int i = 0; i < 3; ++i)
        for (int d = 0; d < 3; ++d)
            cell[static_cast<std::size_t>(i)][d] = side * ((i == d) + random.uniform(-0.4, 0.4));
    // Few binary digits, so that integer combinations are exact.
    for (auto &row : cell)
        for (int d = 0; d < 3; ++d) row[d] = std::round(row[d] * 0x1p20) * 0x1p-20;
    return cell;
}

std::string cell_text(pw85::Cell const &cell)
{
    return "cell = " + hex_text(cell[0].coordinates, 3) + hex_text(cell[1].coordinates, 3) +
           hex_text(cell[2].coordinates, 3);
}

/// The distance that the library takes, seen through unit spheres, against brute force in the
/// compact cell.
void check_distances(Failures &failures, Random &random, pw85::Cell const &compact,
                     pw85::Cell const &cell, double spread)
{
    System system(random, 40, 300, spread);
    for (Form3 &q : system.q) q = {1.0, 0.0, 0.0, 1.0, 0.0, 1.0};
    BatchResult const result = run_pairs(system, &cell);
    g_assert_cmpint(result.contact_status, ==, PW85_SUCCESS);
    for (std::size_t k = 0; k < system.pairs.size(); ++k) {
        Wide3 r;
        for (int d = 0; d < 3; ++d)
            r[d] = static_cast<long double>(system.center(k, 1)[d]) -
                   static_cast<long double>(system.center(k, 0)[d]);
        double const expected = static_cast<double>(nearest_square(compact, r)) / 4.0;
        // Rounding of the difference and of three multiples of lattice vectors, each below u times
        // the spread; squared.
        double const slack = 8.0 * u * spread * std::sqrt(expected) + 4.0 * u * expected;
        double const error = std::fabs(result.mu2[k] - expected);
        failures.check(error <= slack, "quarter of the squared distance", result.mu2[k], expected,
                       [&] {
                           return cell_text(cell) + hex_text(system.center(k, 0).coordinates, 3) +
                                  hex_text(system.center(k, 1).coordinates, 3);
                       });
    }
}

PW85_TEST("/pairs/cells")
{
    Failures failures;
    Random random(12);
    for (int n = 0; n < draws(300); ++n) {
        pw85::Cell const compact = compact_cell(random, 8.0);
        for (int const steps : {0, 1, 2, 4, 8, 12}) {
            pw85::Cell const cell = skew(random, compact, steps);
            check_distances(failures, random, compact, cell, n % 2 == 0 ? 16.0 : 200.0);
        }
    }
}

// Lattices with many images at the same distance: cubic, hexagonal, face- and body-centred, flat
// and needle-like.
PW85_TEST("/pairs/special_cells")
{
    Failures failures;
    Random random(13);
    double const h = 0.5, s = 0.75; // 0.75 stands for sin 60°, with few digits
    pw85::Cell const cells[] = {
        {{{4, 0, 0}, {0, 4, 0}, {0, 0, 4}}},    {{{4, 0, 0}, {4 * h, 4 * s, 0}, {0, 0, 8}}},
        {{{0, 4, 4}, {4, 0, 4}, {4, 4, 0}}},    {{{-4, 4, 4}, {4, -4, 4}, {4, 4, -4}}},
        {{{4, 0, 0}, {0, 16, 0}, {0, 0, 0.5}}}, {{{4, 0, 0}, {2, 4, 0}, {2, 2, 4}}},
        {{{4, 0, 0}, {-2, 4, 0}, {-2, -2, 4}}},
    };
    for (auto const &cell : cells)
        for (int const steps : {0, 3, 10})
            check_distances(failures, random, cell, skew(random, cell, steps), 16.0);
}

// For ellipsoids: the contact function of one of the nearest images.
PW85_TEST("/pairs/contact_in_cell")
{
    Failures failures;
    Random random(14);
    for (int n = 0; n < draws(50); ++n) {
        pw85::Cell const compact = compact_cell(random, 8.0), cell = skew(random, compact, 3);
        System const system(random, 40, 300, 8.0);
        BatchResult const result = run_pairs(system, &cell);
        for (std::size_t k = 0; k < system.pairs.size(); ++k) {
            Wide3 r;
            for (int d = 0; d < 3; ++d) r[d] = system.center(k, 1)[d] - system.center(k, 0)[d];
            long double const nearest = nearest_square(compact, r);
            double closest = HUGE_VAL;
            visit_nearest(compact, r, [&](Wide3 const &x) {
                if (pw85::dot(x, x) > nearest * (1.0L + 1e-14L)) return;
                double const mu2 =
                    pw85::contact(convert<double>(x), system.form(k, 0), system.form(k, 1)).mu2;
                closest = std::min(closest, std::fabs(result.mu2[k] - mu2));
            });
            // 4 u cond for aspect 10 is below 1e-13; the rounding of r by u·8 in 1e-13, too.
            failures.check(closest <= 1e-12 * std::max(1.0, result.mu2[k]),
                           "distance to the next mu^2", closest, 0.0,
                           [&] { return cell_text(cell); });
            int const overlap = result.mu2[k] < 1.0;
            if (std::fabs(result.mu2[k] - 1.0) > 1e-12)
                failures.check(result.overlap[k] == overlap, "overlap", result.overlap[k], overlap,
                               [&] { return cell_text(cell); });
        }
    }
}

// Cells as small and as large as semi-axes may be.
PW85_TEST("/pairs/cell_sizes")
{
    for (double const scale : {0x1p-490, 0x1p-100, 0x1p100, 0x1p490}) {
        pw85::Cell const cell = {
            {{4 * scale, 0, 0}, {0, 4 * scale, 0}, {scale, 4 * scale, 4 * scale}}};
        std::vector<Vector3> const centers = {{0, 0, 0}, {3 * scale, 3 * scale, 3 * scale}};
        double const q = scale * scale;
        std::vector<Form3> const forms(2, Form3{q, 0, 0, q, 0, q});
        std::vector<pw85::IndexPair> const pairs = {{0, 1}};
        std::vector<double> mu2(1);
        auto const status = pw85::contact_pairs({pairs}, {centers, forms, &cell}, mu2);
        g_assert_cmpint(static_cast<int>(status), ==, PW85_SUCCESS);
        // (3, 3, 3) - (1, 4, 4) = (2, -1, -1): the squared distance is 6 in units of the scale.
        g_assert_cmpfloat(std::fabs(mu2[0] - 1.5), <=, 1e-14);
    }
}

// Up to 2⁵⁰ cells away the nearest image is told, though to an eighth of a cell only; beyond it
// pairs are bad, unless the cell is not periodic there. Lists are long enough for lanes, and for
// what these leave.
PW85_TEST("/pairs/far_centers")
{
    pw85::Cell const cell = {{{2, 0, 0}, {0, 2, 0}, {0, 0, 2}}};
    std::vector<Vector3> const centers = {
        {0, 0, 0}, {0x1p51, 0, 0}, {0x1.01p51, 0, 0}, {0, -0x1p60, 0}, {0, 0, 1e300}};
    std::vector<Form3> const forms(5, Form3{0.16, 0, 0, 0.16, 0, 0.16});
    for (bool const periodic : {true, false})
        for (std::int32_t k = 1; k < 5; ++k) {
            std::vector<pw85::IndexPair> const pairs(20, {0, k});
            pw85::Particles const particles{
                centers,
                forms,
                &cell,
                {periodic || k != 2, periodic || k != 3, periodic || k != 4}};
            bool const bad = periodic && k > 1;
            auto const expected = bad ? pw85::Status::invalid_argument : pw85::Status::success;
            std::vector<double> mu2(20), lambda(20), t(20);
            std::vector<unsigned char> overlap(20);
            std::vector<Vector3> r12(20);
            std::vector<pw85::Motion<double, 3>> const motions(5);
            g_assert_true(pw85::contact_pairs({pairs}, particles, mu2, lambda) == expected);
            g_assert_true(pw85::overlap_pairs({pairs}, particles, overlap) == expected);
            g_assert_true(pw85::first_contact_pairs({pairs}, particles, motions, 1.0, {t}) ==
                          expected);
            g_assert_true(pw85::nearest_images(pairs, particles, r12, {}) == expected);
            for (std::size_t n = 0; n < 20; ++n) {
                g_assert_true(std::isnan(mu2[n]) == bad && std::isnan(lambda[n]) == bad &&
                              std::isnan(t[n]) == bad);
                g_assert_true(overlap[n] == (bad ? 255 : k == 1) && std::isnan(r12[n][0]) == bad);
            }
            std::vector<std::int32_t> const others(20, k);
            int any = 7;
            g_assert_true(pw85::overlap_any_indices(centers[0], forms[0], others, particles, any) ==
                          expected);
            g_assert_cmpint(any, ==, bad ? -1 : k == 1);
        }
}

PW85_TEST("/pairs/bad_cells")
{
    double const nan = std::numeric_limits<double>::quiet_NaN();
    pw85::Cell const cells[] = {
        {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}},
        {{{1, 0, 0}, {0, 1, 0}, {1, 1, 0}}},
        {{{0.3, 0.1, 0.7}, {0.6, 0.2, 1.4}, {0, 0, 1}}},
        {{{0.3, 0.1, 0.7}, {3 * 0.3, 3 * 0.1, 3 * 0.7}, {0, 0, 1}}},
        {{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}}},
        {{{1, 0, 0}, {0, nan, 0}, {0, 0, 1}}},
        {{{1, 0, 0}, {0, 1, 0}, {0, HUGE_VAL, 1}}},
    };
    Random random(15);
    System const system(random, 5, 20, 3.0);
    for (auto const &cell : cells) {
        std::vector<double> mu2(20, 7.0), lambda(20, 7.0);
        std::vector<unsigned char> overlap(20, 7);
        pw85::Particles const particles{system.centers, system.q, &cell};
        g_assert_true(pw85::contact_pairs({system.pairs}, particles, mu2, lambda) ==
                      pw85::Status::invalid_argument);
        g_assert_true(pw85::overlap_pairs({system.pairs}, particles, overlap) ==
                      pw85::Status::invalid_argument);
        for (std::size_t k = 0; k < 20; ++k)
            g_assert_true(mu2[k] == 7.0 && lambda[k] == 7.0 && overlap[k] == 7);
    }
}

// Indices out of range are found before anything is written, wherever they are.
PW85_TEST("/pairs/bad_indices")
{
    Random random(16);
    System system(random, 50, 200000, 10.0);
    std::size_t const n = system.pairs.size();
    std::vector<double> mu2(n, 7.0), lambda(n, 7.0);
    std::vector<unsigned char> overlap(n, 7);
    for (std::size_t const k : {std::size_t{0}, n / 2, n - 1})
        for (std::int32_t const bad : {-1, 50, INT32_MAX, INT32_MIN})
            for (std::size_t const end : std::initializer_list<std::size_t>{0, 1}) {
                std::int32_t const good = system.pairs[k][end];
                system.pairs[k][end] = bad;
                pw85::Particles const particles{system.centers, system.q};
                auto const status = pw85::contact_pairs({system.pairs}, particles, mu2, lambda);
                g_assert_true(status == pw85::Status::invalid_argument);
                g_assert_true(pw85::overlap_pairs({system.pairs}, particles, overlap) == status);
                system.pairs[k][end] = good;
            }
    g_assert_true(std::all_of(mu2.begin(), mu2.end(), [](double x) { return x == 7.0; }));
    g_assert_true(std::all_of(lambda.begin(), lambda.end(), [](double x) { return x == 7.0; }));
    g_assert_true(
        std::all_of(overlap.begin(), overlap.end(), [](unsigned char x) { return x == 7; }));
}

PW85_TEST("/pairs/arguments")
{
    double const x[6] = {1.0, 0.0, 0.0, 1.0, 0.0, 1.0}, cell[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    std::int32_t const pairs[2] = {0, 0};
    double mu2 = 7.0, lambda = 7.0;
    unsigned char overlap = 7;
    g_assert_cmpint(pw85_contact_pairs(list_of(0, nullptr), system_of(0, nullptr, nullptr, nullptr),
                                       nullptr, nullptr),
                    ==, PW85_SUCCESS);
    g_assert_cmpint(
        pw85_overlap_pairs(list_of(0, nullptr), system_of(0, nullptr, nullptr, nullptr), nullptr),
        ==, PW85_SUCCESS);
    g_assert_cmpint(
        pw85_contact_pairs(list_of(1, nullptr), system_of(1, x, x, cell), &mu2, &lambda), ==,
        PW85_EINVAL);
    g_assert_cmpint(
        pw85_contact_pairs(list_of(1, pairs), system_of(1, nullptr, x, cell), &mu2, &lambda), ==,
        PW85_EINVAL);
    g_assert_cmpint(
        pw85_contact_pairs(list_of(1, pairs), system_of(1, x, nullptr, cell), &mu2, &lambda), ==,
        PW85_EINVAL);
    g_assert_cmpint(
        pw85_contact_pairs(list_of(1, pairs), system_of(1, x, x, cell), nullptr, &lambda), ==,
        PW85_EINVAL);
    g_assert_cmpint(pw85_contact_pairs(list_of(1, pairs), system_of(0, x, x, cell), &mu2, &lambda),
                    ==, PW85_EINVAL);
    g_assert_cmpint(pw85_overlap_pairs(list_of(1, nullptr), system_of(1, x, x, cell), &overlap), ==,
                    PW85_EINVAL);
    g_assert_cmpint(pw85_overlap_pairs(list_of(1, pairs), system_of(1, nullptr, x, cell), &overlap),
                    ==, PW85_EINVAL);
    g_assert_cmpint(pw85_overlap_pairs(list_of(1, pairs), system_of(1, x, nullptr, cell), &overlap),
                    ==, PW85_EINVAL);
    g_assert_cmpint(pw85_overlap_pairs(list_of(1, pairs), system_of(1, x, x, cell), nullptr), ==,
                    PW85_EINVAL);
    for (std::size_t const n : {SIZE_MAX, SIZE_MAX / 2, SIZE_MAX / 8, SIZE_MAX / 96 + 1}) {
        g_assert_cmpint(
            pw85_contact_pairs(list_of(n, pairs), system_of(1, x, x, cell), &mu2, &lambda), ==,
            PW85_EINVAL);
        g_assert_cmpint(
            pw85_contact_pairs(list_of(1, pairs), system_of(n, x, x, cell), &mu2, &lambda), ==,
            PW85_EINVAL);
        g_assert_cmpint(pw85_overlap_pairs(list_of(n, pairs), system_of(1, x, x, cell), &overlap),
                        ==, PW85_EINVAL);
    }
    g_assert_true(mu2 == 7.0 && lambda == 7.0 && overlap == 7);
    // A particle with itself; λ left out.
    g_assert_cmpint(pw85_contact_pairs(list_of(1, pairs), system_of(1, x, x, cell), &mu2, nullptr),
                    ==, PW85_SUCCESS);
    g_assert_cmpint(pw85_overlap_pairs(list_of(1, pairs), system_of(1, x, x, nullptr), &overlap),
                    ==, PW85_SUCCESS);
    g_assert_true(mu2 == 0.0 && lambda == 7.0 && overlap == 1);
}

// A part of a list gives the bits of the whole list.
PW85_TEST("/pairs/parts")
{
    Random random(17);
    pw85::Cell const cell = skew(random, compact_cell(random, 8.0), 4);
    System system(random, 100, 10000, 8.0);
    BatchResult const whole = run_pairs(system, &cell);
    System part = system;
    for (std::size_t const first : {std::size_t{1}, std::size_t{4097}, std::size_t{9993}}) {
        part.pairs.assign(system.pairs.begin() + static_cast<std::ptrdiff_t>(first),
                          system.pairs.end());
        BatchResult const result = run_pairs(part, &cell);
        for (std::size_t k = 0; k < part.pairs.size(); ++k)
            g_assert_true(result.same_row(k, whole, first + k));
    }
}

} // namespace
