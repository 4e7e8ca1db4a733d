// SPDX-License-Identifier: BSD-3-Clause
// Compares systems that are periodic along some of the vectors of their cell with all images one by
// one. Tests systems and lists that are errors.
#include <glib.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <pw85/pw85.hpp>
#include <pw85/systems.hpp>

#include "../cases.hpp"
#include "../draws.hpp"
#include "../failures.hpp"
#include "../random_pairs.hpp"
#include "../systems.hpp"

using namespace pw85_tests;

namespace {

using Periodic = std::array<int, 3>;
using pw85::Status;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Those with one or two periodic vectors.
constexpr Periodic some_periodic[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1},
                                      {1, 1, 0}, {0, 1, 1}, {1, 0, 1}};

/// A cell that is nearly rectangular, so that few multiples of its vectors matter; those that are
/// not periodic are NaN.
struct System {
    std::vector<Vector3> centers;
    std::vector<Form3> q;
    pw85::Cell cell;
    Periodic periodic;

    System(Random &random, Periodic const &some, std::size_t n, double side, double size)
        : periodic(some)
    {
        for (std::size_t k = 0; k < 3; ++k)
            for (int d = 0; d < 3; ++d)
                cell[k][d] = some[k] == 0 ? nan
                                          : side * (random.uniform(-0.2, 0.2) +
                                                    (d == static_cast<int>(k) ? 1.0 : 0.0));
        for (std::size_t i = 0; i < n; ++i) {
            centers.push_back(
                Vector3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)});
            for (int d = 0; d < 3; ++d) centers[i][d] *= side;
            q.push_back(random.form(size, random.log_uniform(1.0, 5.0)));
        }
    }

    pw85::Particles particles() const { return {centers, q, &cell, periodic}; }

    /// A vector plus multiples of those of the cell that are periodic.
    Vector3 moved(Vector3 x, pw85::Image const &image) const
    {
        for (std::size_t k = 0; k < 3; ++k)
            for (int d = 0; d < 3 && periodic[k] != 0; ++d) x[d] += image[k] * cell[k][d];
        return x;
    }

    Vector3 separation(std::size_t i, std::size_t j) const
    {
        Vector3 r;
        for (int d = 0; d < 3; ++d) r[d] = centers[j][d] - centers[i][d];
        return r;
    }

    std::string text() const
    {
        std::string all = "cell = ";
        for (auto const &row : cell) all += hex_text(row.coordinates, 3);
        for (auto const &center : centers) all += "center = " + hex_text(center.coordinates, 3);
        return all;
    }
};

/// Visits multiples up to `reach` of the periodic vectors.
template <class Visit> void visit_images(Periodic const &periodic, int reach, Visit visit)
{
    auto const limit = [&](std::size_t k) { return periodic[k] != 0 ? reach : 0; };
    for (int a = -limit(0); a <= limit(0); ++a)
        for (int b = -limit(1); b <= limit(1); ++b)
            for (int c = -limit(2); c <= limit(2); ++c) visit(pw85::Image{a, b, c});
}

std::vector<pw85::IndexPair> all_pairs(std::size_t n)
{
    std::vector<pw85::IndexPair> pairs;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < i; ++j)
            pairs.push_back({static_cast<std::int32_t>(i), static_cast<std::int32_t>(j)});
    return pairs;
}

// The images, added to the second particles, give the vectors, and none of another image is
// shorter.
PW85_TEST("/partly_periodic/nearest_images")
{
    Failures failures;
    Random random(171);
    for (Periodic const &some : some_periodic)
        for (int n = 0; n < draws(20); ++n) {
            System const s(random, some, 8, 3.0, 0.5);
            auto const pairs = all_pairs(8);
            std::vector<Vector3> r12(pairs.size());
            std::vector<pw85::Image> images(pairs.size());
            g_assert_true(nearest_images(pairs, s.particles(), r12, images) == Status::success);
            for (std::size_t k = 0; k < pairs.size(); ++k) {
                auto const r = s.separation(static_cast<std::size_t>(pairs[k][0]),
                                            static_cast<std::size_t>(pairs[k][1]));
                Vector3 const expected = s.moved(r, images[k]);
                double const nearest = pw85::dot(r12[k], r12[k]);
                for (int d = 0; d < 3; ++d) {
                    bool const good = std::fabs(r12[k][d] - expected[d]) <= 1e-13 * 3.0 * 10;
                    failures.check(good, "vector", r12[k][d], expected[d],
                                   [&] { return s.text(); });
                }
                for (std::size_t l = 0; l < 3; ++l)
                    failures.check(some[l] != 0 || images[k][l] == 0, "multiple", images[k][l], 0.0,
                                   [&] { return s.text(); });
                visit_images(some, 4, [&](pw85::Image const &image) {
                    auto const other = s.moved(r, image);
                    failures.check(pw85::dot(other, other) >= nearest * (1.0 - 1e-12), "nearer",
                                   pw85::dot(other, other), nearest, [&] { return s.text(); });
                });
            }
        }
}

/// What the functions of lists find: bits.
struct Answers {
    std::vector<double> mu2, derivative_mu2;
    std::vector<unsigned char> overlap;

    Answers(pw85::PairList const &list, pw85::Particles const &particles)
        : mu2(list.pairs.size()), derivative_mu2(list.pairs.size()), overlap(list.pairs.size())
    {
        g_assert_true(contact_pairs(list, particles, mu2) == Status::success);
        g_assert_true(overlap_pairs(list, particles, overlap) == Status::success);
        g_assert_true(contact_derivatives_pairs(list, particles, {derivative_mu2}) ==
                      Status::success);
    }
};

// Functions of lists take the same images, those that are given or the nearest; multiples of the
// other vectors count as 0.
PW85_TEST("/partly_periodic/lists")
{
    Failures failures;
    Random random(172);
    for (Periodic const &some : some_periodic)
        for (int n = 0; n < draws(20); ++n) {
            System const s(random, some, 8, 3.0, 1.0);
            auto const pairs = all_pairs(8);
            std::vector<Vector3> r12(pairs.size());
            std::vector<pw85::Image> images(pairs.size());
            g_assert_true(nearest_images(pairs, s.particles(), r12, images) == Status::success);
            Answers const nearest({pairs}, s.particles()), given({pairs, images}, s.particles());
            for (auto &image : images)
                for (std::size_t l = 0; l < 3; ++l)
                    if (some[l] == 0) image[l] = 7;
            Answers const more({pairs, images}, s.particles());
            for (std::size_t k = 0; k < pairs.size(); ++k) {
                auto const describe = [&] { return s.text(); };
                auto const i = static_cast<std::size_t>(pairs[k][0]),
                           j = static_cast<std::size_t>(pairs[k][1]);
                double const expected = pw85::contact(r12[k], s.q[i], s.q[j]).mu2;
                for (auto const *const answers : {&nearest, &given, &more}) {
                    failures.check(std::fabs(answers->mu2[k] / expected - 1.0) <= 1e-10, "mu2",
                                   answers->mu2[k], expected, describe);
                    failures.check(std::fabs(answers->derivative_mu2[k] / expected - 1.0) <= 1e-10,
                                   "derivatives", answers->derivative_mu2[k], expected, describe);
                    failures.check(answers->overlap[k] == (expected < 1.0), "overlap",
                                   answers->overlap[k], expected, describe);
                }
                failures.check(more.mu2[k] == given.mu2[k], "other multiples", more.mu2[k],
                               given.mu2[k], describe);
            }
        }
}

// The limit is the least |v|⁴/(16 vᵀQv) of the lattice vectors v, and beyond it another image than
// the nearest may overlap.
PW85_TEST("/partly_periodic/limit")
{
    Failures failures;
    Random random(173);
    for (Periodic const &some : some_periodic)
        for (int n = 0; n < draws(20); ++n) {
            System const s(random, some, 4, 3.0, random.log_uniform(0.3, 3.0));
            double expected = HUGE_VAL, limit = 0.0;
            visit_images(some, 3, [&](pw85::Image const &image) {
                if (image == pw85::Image{}) return;
                Vector3 const v = s.moved({0.0, 0.0, 0.0}, image);
                double const square = pw85::dot(v, v);
                for (auto const &form : s.q)
                    expected = std::min(
                        expected, square * square / (16.0 * pw85::detail::quadratic_form(form, v)));
            });
            g_assert_true(nearest_image_limit(s.particles(), limit) == Status::success);
            failures.check(std::fabs(limit / expected - 1.0) <= 1e-12, "limit", limit, expected,
                           [&] { return s.text(); });
        }
}

// One against others, all images of them and of itself: refused only where the limit is below one.
PW85_TEST("/partly_periodic/overlap_any_indices")
{
    Failures failures;
    Random random(174);
    int counts[3] = {};
    for (Periodic const &some : some_periodic)
        for (int n = 0; n < draws(200); ++n) {
            System const s(random, some, 4, 3.0, random.log_uniform(0.3, 1.5));
            bool expected = false;
            for (std::size_t j = 0; j < 4; ++j)
                visit_images(some, 5, [&](pw85::Image const &image) {
                    if (j == 0 && image == pw85::Image{}) return;
                    expected =
                        expected ||
                        pw85::overlap(s.moved(s.separation(0, j), image), s.q[0], s.q[j]).overlap;
                });
            std::vector<std::int32_t> const others = {1, 2, 3};
            double limit = 0.0;
            int any = 7;
            g_assert_true(nearest_image_limit(s.particles(), limit) == Status::success);
            Status const status =
                overlap_any_indices(s.centers[0], s.q[0], others, s.particles(), any);
            bool const refused = status == Status::invalid_argument && any == -1 && limit < 1.0;
            failures.check(refused || (status == Status::success && any == expected), "any", any,
                           expected, [&] { return s.text(); });
            ++counts[any + 1];
        }
    for (int const count : counts) g_assert_cmpint(count, >, draws(50));
}

// A cell of which no vector is periodic is refused, and so are periodic vectors that are not
// independent.
PW85_TEST("/partly_periodic/bad_cells")
{
    Random random(175);
    System s(random, {1, 1, 1}, 2, 3.0, 0.5);
    std::vector<pw85::IndexPair> const pairs = {{0, 1}};
    std::vector<pw85::Image> const images(1);
    std::vector<std::int32_t> const others = {1};
    std::vector<Vector3> r12(1);
    double mu2[1], limit = 7.0;
    int any = 7, holds = 7;
    pw85::Neighbors list, other;
    g_assert_true(neighbors_create(s.particles(), {}, list) == Status::success);
    s.cell[1] = 2.0 * s.cell[0];
    for (Periodic const &bad : {Periodic{0, 0, 0}, Periodic{1, 1, 0}}) {
        s.periodic = bad;
        g_assert_true(contact_pairs({pairs}, s.particles(), mu2) == Status::invalid_argument);
        bool const none = bad[0] == 0; // given images need no lattice
        g_assert_true((contact_pairs({pairs, images}, s.particles(), mu2) == Status::success) !=
                      none);
        g_assert_true(pw85::nearest_images(pairs, s.particles(), r12) == Status::invalid_argument);
        g_assert_true(nearest_image_limit(s.particles(), limit) == Status::invalid_argument &&
                      std::isnan(limit));
        g_assert_true(overlap_any_indices(s.centers[0], s.q[0], others, s.particles(), any) ==
                      Status::invalid_argument);
        g_assert_cmpint(any, ==, -1);
        g_assert_true(neighbors_create(s.particles(), {}, other) == Status::invalid_argument);
        g_assert_true(neighbors_holds(list, s.particles(), holds) == Status::invalid_argument);
        g_assert_cmpint(holds, ==, -1);
    }
}

// A list holds for a system that is periodic along the same vectors.
PW85_TEST("/partly_periodic/other_directions")
{
    Random random(176);
    System s(random, {1, 1, 1}, 5, 3.0, 0.5);
    pw85::Neighbors list;
    s.periodic = {1, 0, 1};
    g_assert_true(neighbors_create(s.particles(), {1.0, 0.1}, list) == Status::success);
    int holds = 7;
    s.periodic = {2, 0, -1};
    g_assert_true(neighbors_holds(list, s.particles(), holds) == Status::success && holds == 1);
    s.periodic = {1, 1, 1};
    g_assert_true(neighbors_holds(list, s.particles(), holds) == Status::invalid_argument &&
                  holds == -1);
}

// Null structs, before anything is written but what says so.
PW85_TEST("/partly_periodic/null")
{
    double const x[6] = {1.0, 0.0, 0.0, 1.0, 0.0, 1.0};
    std::int32_t const pairs[2] = {0, 0};
    PairListArgument const list = list_of(1, pairs), no_pairs = list_of(0, nullptr);
    SystemArgument const system = system_of(1, x, x, nullptr);
    double out = 7.0;
    unsigned char overlap = 7;
    g_assert_cmpint(pw85_contact_pairs(nullptr, system, &out, nullptr), ==, PW85_EINVAL);
    g_assert_cmpint(pw85_contact_pairs(list, nullptr, &out, nullptr), ==, PW85_EINVAL);
    g_assert_cmpint(pw85_contact_pairs(no_pairs, nullptr, &out, nullptr), ==, PW85_EINVAL);
    g_assert_cmpint(pw85_overlap_pairs(nullptr, system, &overlap), ==, PW85_EINVAL);
    g_assert_cmpint(pw85_overlap_pairs(list, nullptr, &overlap), ==, PW85_EINVAL);
    g_assert_cmpint(pw85_contact_derivatives_pairs(list, nullptr, &out, nullptr, nullptr, nullptr,
                                                   nullptr, nullptr, nullptr),
                    ==, PW85_EINVAL);
    g_assert_cmpint(pw85_contact_forces_pairs(nullptr, system, x, x, x, x, &out, &out, &out), ==,
                    PW85_EINVAL);
    g_assert_cmpint(pw85_contact_forces_pairs(list, nullptr, x, x, x, x, &out, &out, &out), ==,
                    PW85_EINVAL);
    pw85_motion const motion = {};
    g_assert_cmpint(pw85_first_contact_pairs(nullptr, system, &motion, 1.0, &out, &out, nullptr),
                    ==, PW85_EINVAL);
    g_assert_cmpint(pw85_first_contact_pairs(list, nullptr, &motion, 1.0, &out, &out, nullptr), ==,
                    PW85_EINVAL);
    g_assert_cmpint(pw85_nearest_images(1, pairs, nullptr, &out, nullptr), ==, PW85_EINVAL);
    g_assert_true(out == 7.0 && overlap == 7);
    g_assert_cmpint(pw85_nearest_image_limit(nullptr, &out), ==, PW85_EINVAL);
    g_assert_true(std::isnan(out));
    int any = 7, holds = 7;
    g_assert_cmpint(pw85_overlap_any_indices(x, x, nullptr, 0, nullptr, nullptr, &any), ==,
                    PW85_EINVAL);
    pw85_neighbors *made = nullptr;
    g_assert_cmpint(pw85_neighbors_create(system, 1.0, 0.0, &made), ==, PW85_SUCCESS);
    g_assert_cmpint(pw85_neighbors_holds(made, nullptr, &holds), ==, PW85_EINVAL);
    g_assert_true(any == -1 && holds == -1);
    pw85_neighbors_destroy(made);
    std::size_t particle = 7;
    g_assert_cmpint(pw85_neighbors_create(nullptr, 1.0, 0.0, &made), ==, PW85_EINVAL);
    g_assert_cmpint(pw85_neighbors_check(nullptr, 1.0, 0.0, &particle), ==, PW85_EINVAL);
    g_assert_true(made == nullptr && particle == 0);
}

} // namespace
