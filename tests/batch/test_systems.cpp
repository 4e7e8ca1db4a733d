// SPDX-License-Identifier: BSD-3-Clause
// Distances of closest approach of many pairs, one ellipsoid against many, and many forms give the
// same as the calls one by one.
#include <algorithm>
#include <cmath>

#include <glib.h>

#include <pw85/batch.hpp>
#include <pw85/systems.hpp>

#include "../cases.hpp"
#include "../condition_number.hpp"
#include "../draws.hpp"
#include "../failures.hpp"
#include "../systems.hpp"
#include "batch_data.hpp"

using namespace pw85_tests;

namespace {

constexpr double u = 0x1p-53;

using Vector4 = pw85::Vector<double, 4>;

/// Columns of a vector of pairs.
struct Columns {
    std::vector<Vector3> r12;
    std::vector<Form3> q1, q2;

    explicit Columns(std::vector<Pair3> const &pairs)
    {
        for (Pair3 const &p : pairs) {
            r12.push_back(p.r12);
            q1.push_back(p.q1);
            q2.push_back(p.q2);
        }
    }
};

// Marks and statuses as one by one, any direction's length; distances within twice the bound of
// either, which is half that of μ², 4 u cond, and some roundings.
PW85_TEST("/systems/closest_approach")
{
    Failures failures;
    Random random(61);
    auto pairs = mixed_pairs(random, 20000);
    for (std::size_t i = 0; i < pairs.size(); i += 3)
        pairs[i].r12 =
            std::ldexp(1.0, static_cast<int>(random.uniform(-1000.0, 1000.0))) * pairs[i].r12;
    Columns const columns(pairs);
    std::vector<double> distance(pairs.size());
    auto const status = pw85::closest_approach_batch(columns.r12, columns.q1, columns.q2, distance);
    int first = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        auto const &p = pairs[i];
        double expected;
        int const own =
            pw85_closest_approach(p.r12.coordinates, p.q1.entries, p.q2.entries, &expected);
        if (first == 0) first = own;
        auto const describe = [&] { return hex_text(p); };
        failures.check(std::isnan(distance[i]) == (own != 0), "mark", distance[i], expected,
                       describe);
        if (own != 0) continue;
        double const largest =
            std::fmax(std::fabs(p.r12[0]), std::fmax(std::fabs(p.r12[1]), std::fabs(p.r12[2])));
        Sample<double, 3> scaled = p;
        for (int d = 0; d < 3; ++d) scaled.r12[d] = p.r12[d] / largest;
        auto const wide = convert<long double>(scaled);
        double const cond = static_cast<double>(
            condition_number(wide, pw85::contact(wide.r12, wide.q1, wide.q2).lambda));
        double const bound = (4 * cond + 8) * u * expected,
                     error = std::fabs(distance[i] - expected);
        failures.check(error <= bound, "difference of distances", error, bound, describe);
    }
    g_assert_cmpint(static_cast<int>(status), ==, first);
}

// Sizes for which the square of the distance leaves the range of double, though the distance does
// not.
PW85_TEST("/systems/closest_approach_range")
{
    for (double const q : {0x1p-1074, 0x1p-1040, 0x1p-1000, 1.0, 0x1p1000, 0x1p1022}) {
        Pair3 const p{{3, 0, 4}, {q, 0, 0, q, 0, q}, {q, 0, 0, q, 0, q}};
        std::vector<double> distance(1);
        auto const status = pw85::closest_approach_batch(std::span(&p.r12, 1), std::span(&p.q1, 1),
                                                         std::span(&p.q2, 1), distance);
        g_assert_cmpint(static_cast<int>(status), ==, PW85_SUCCESS);
        g_assert_cmpfloat(std::fabs(distance[0] / (2.0 * std::sqrt(q)) - 1.0), <=, 8 * u);
    }
}

// Any number, at any position: the same bits.
PW85_TEST("/systems/closest_approach_positions")
{
    Random random(62);
    Columns const columns(mixed_pairs(random, 9000));
    std::vector<double> whole(9000);
    pw85::closest_approach_batch(columns.r12, columns.q1, columns.q2, whole);
    for (std::size_t const first : {std::size_t{1}, std::size_t{4095}})
        for (std::size_t const n : {std::size_t{1}, std::size_t{9}, std::size_t{130}}) {
            std::vector<double> part(n);
            pw85::closest_approach_batch(pw85::Vectors(columns.r12).subspan(first, n),
                                         pw85::Forms(columns.q1).subspan(first, n),
                                         pw85::Forms(columns.q2).subspan(first, n), part);
            g_assert_true(std::memcmp(part.data(), whole.data() + first, n * sizeof(double)) == 0);
        }
}

/// What a loop over pw85_overlap() says.
int any_one_by_one(Form3 const &q1, std::vector<Vector3> const &r12, std::vector<Form3> const &q2,
                   int &any)
{
    any = 0;
    for (std::size_t i = 0; i < r12.size() && any == 0; ++i) {
        int const status = pw85_overlap(r12[i].coordinates, q1.entries, q2[i].entries, &any);
        if (status != 0) return status;
    }
    return 0;
}

// Others in any order, bad ones among them: the first that overlaps or is bad decides.
PW85_TEST("/systems/overlap_any")
{
    Failures failures;
    Random random(63);
    int counts[3] = {};
    for (int n = 0; n < draws(20000); ++n) {
        auto const size = static_cast<std::size_t>(random.uniform(0.0, n % 10 == 0 ? 200.0 : 20.0));
        Form3 const q1 = random.form(1.0, 5.0);
        std::vector<Vector3> r12;
        std::vector<Form3> q2;
        for (std::size_t i = 0; i < size; ++i) {
            double const distance =
                random.uniform(0.0, 1.0) < 0.03 ? 0.5 : random.uniform(1.2, 2.5);
            r12.push_back(distance * random.direction<3>());
            q2.push_back(random.form(1.0, 5.0));
            if (random.uniform(0.0, 1.0) < 0.01) q2.back()[3] = -1.0;
        }
        int expected, actual = 7;
        int const status = any_one_by_one(q1, r12, q2, expected);
        auto const describe = [&] {
            return "q1 = " + hex_text(q1.entries, 6) + ", trial " + std::to_string(n);
        };
        failures.check(static_cast<int>(pw85::overlap_any(q1, r12, q2, actual)) == status, "status",
                       status, 0, describe);
        failures.check(actual == expected, "any", actual, expected, describe);
        ++counts[expected + 1];
    }
    for (int const count : counts) g_assert_cmpint(count, >, draws(100));
}

// Others beyond the first that overlaps are not looked at: neither theirs nor the status of one
// that overlaps is bad.
PW85_TEST("/systems/overlap_any_order")
{
    double const nan = std::numeric_limits<double>::quiet_NaN();
    Form3 const sphere{1, 0, 0, 1, 0, 1};
    std::vector<Form3> const q2(100, sphere);
    for (std::size_t const hit :
         {std::size_t{0}, std::size_t{7}, std::size_t{31}, std::size_t{32}, std::size_t{99}}) {
        std::vector<Vector3> r12(100, Vector3{3, 0, 0});
        int any = 7;
        r12[hit] = {1, 0, 0};
        g_assert_true(pw85::overlap_any(sphere, r12, q2, any) == pw85::Status::success);
        g_assert_cmpint(any, ==, 1);
        for (std::size_t i = hit + 1; i < 100; ++i) r12[i][1] = nan;
        g_assert_true(pw85::overlap_any(sphere, r12, q2, any) == pw85::Status::success);
        g_assert_cmpint(any, ==, 1);
        r12[hit][1] = nan;
        g_assert_true(pw85::overlap_any(sphere, r12, q2, any) == pw85::Status::invalid_argument);
        g_assert_cmpint(any, ==, -1);
    }
}

// By indices: the nearest images of the others in any order, in a cell or without one.
PW85_TEST("/systems/overlap_any_indices")
{
    Failures failures;
    Random random(66);
    pw85::Cell const cell{{{6.0, 0.0, 0.0}, {2.0, 5.0, 0.0}, {-1.0, 1.0, 7.0}}};
    std::vector<Vector3> centers;
    std::vector<Form3> q;
    for (int i = 0; i < 50; ++i) {
        centers.push_back(
            {random.uniform(-9.0, 9.0), random.uniform(-9.0, 9.0), random.uniform(-9.0, 9.0)});
        q.push_back(random.form(1.0, 4.0));
    }
    int counts[2] = {};
    for (int n = 0; n < draws(4000); ++n) {
        std::vector<std::int32_t> others(
            static_cast<std::size_t>(random.uniform(0.0, n % 9 == 0 ? 80.0 : 9.0)));
        for (auto &other : others) other = static_cast<std::int32_t>(random.uniform(0.0, 50.0));
        Vector3 const center{random.uniform(-9.0, 9.0), random.uniform(-9.0, 9.0),
                             random.uniform(-9.0, 9.0)};
        Form3 const form = random.form(1.0, 4.0);
        centers.push_back(center); // the one as a particle of a list
        q.push_back(form);
        pw85::Particles const particles{centers, q, n % 2 == 0 ? &cell : nullptr};
        std::vector<pw85::IndexPair> pairs;
        for (auto const other : others) pairs.push_back({50, other});
        std::vector<unsigned char> overlap(pairs.size());
        g_assert_true(overlap_pairs({pairs}, particles, overlap) == pw85::Status::success);
        int const expected = std::count(overlap.begin(), overlap.end(), 1) > 0;
        int any = 7;
        pw85::Status const status = overlap_any_indices(center, form, others, particles, any);
        failures.check(status == pw85::Status::success && any == expected, "any", any, expected,
                       [&] { return hex_text(center.coordinates, 3) + hex_text(form.entries, 6); });
        ++counts[expected];
        centers.pop_back();
        q.pop_back();
    }
    for (int const count : counts) g_assert_cmpint(count, >, draws(200));
    std::int32_t const indices[2] = {0, 50};
    int any = 7;
    double const singular[9] = {}, *x = centers[0].coordinates, *form = q[0].entries;
    std::int32_t const image[3] = {1, 0, 0};
    double const infinite[9] = {6.0, 0.0, HUGE_VAL};
    auto const call = [&](std::size_t n, std::int32_t const *images, double const *cell_or_null) {
        any = 7;
        return pw85_overlap_any_indices(x, form, system_of(50, x, form, cell_or_null), n, indices,
                                        images, &any);
    };
    g_assert_true(call(2, nullptr, nullptr) == PW85_EINVAL && any == -1);
    g_assert_true(call(1, nullptr, singular) == PW85_EINVAL && any == -1);
    g_assert_true(call(0, nullptr, singular) == PW85_EINVAL && any == -1);
    g_assert_true(call(0, nullptr, cell[0].coordinates) == PW85_SUCCESS && any == 0);
    g_assert_true(call(0, nullptr, nullptr) == PW85_SUCCESS && any == 0);
    g_assert_true(call(1, nullptr, nullptr) == PW85_SUCCESS && any == 1);
    g_assert_true(call(1, image, nullptr) == PW85_EINVAL && any == -1);
    g_assert_true(call(1, image, infinite) == PW85_EINVAL && any == -1);
    g_assert_true(call(1, image, singular) == PW85_SUCCESS && any == 1);
    g_assert_true(call(1, image, cell[0].coordinates) == PW85_SUCCESS && any == 0);
    g_assert_cmpint(pw85_overlap_any_indices(x, form, system_of(50, x, form, nullptr), 1, nullptr,
                                             nullptr, &any),
                    ==, PW85_EINVAL);
    g_assert_cmpint(pw85_overlap_any_indices(x, form, system_of(50, x, form, nullptr), 1, indices,
                                             nullptr, nullptr),
                    ==, PW85_EINVAL);
}

/// A particle and others in a cell, larger or smaller than they are.
struct SmallSystem {
    std::vector<Vector3> centers;
    std::vector<Form3> q;
    pw85::Cell cell;

    SmallSystem(Random &random, int n, double side) : cell{}
    {
        for (std::size_t k = 0; k < 3; ++k)
            for (int d = 0; d < 3; ++d)
                cell[k][d] = side * (static_cast<int>(k) == d ? random.uniform(0.8, 1.5)
                                                              : random.uniform(-0.2, 0.2));
        for (int i = 0; i < n; ++i) {
            Vector3 center{};
            for (std::size_t k = 0; k < 3; ++k) {
                double const multiple = random.uniform(0.0, 1.0);
                for (int d = 0; d < 3; ++d) center[d] += multiple * cell[k][d];
            }
            centers.push_back(center);
            q.push_back(random.form(random.uniform(0.1, 1.0), 4.0));
        }
    }

    pw85::Particles particles() const { return {centers, q, &cell}; }

    /// Whether the first one overlaps any image of another one, or of itself. Semi-axes are at most
    /// 1, and sides at least 1.2, so that images farther away do not matter.
    bool overlaps() const
    {
        for (std::size_t j = 0; j < q.size(); ++j)
            for (int n = 0; n < 11 * 11 * 11; ++n) {
                if (j == 0 && n == 5 * (11 * 11 + 11 + 1)) continue;
                Vector3 r{};
                for (int d = 0; d < 3; ++d)
                    r[d] = centers[j][d] - centers[0][d] + (n / 121 - 5) * cell[0][d] +
                           (n / 11 % 11 - 5) * cell[1][d] + (n % 11 - 5) * cell[2][d];
                if (pw85::dot(r, r) < 4.0 && pw85::overlap(r, q[0], q[j]).overlap) return true;
            }
        return false;
    }

    std::string text() const
    {
        std::string result;
        for (auto const &row : cell) result += hex_text(row.coordinates, 3);
        for (std::size_t i = 0; i < q.size(); ++i)
            result += "\n  " + hex_text(centers[i].coordinates, 3) + hex_text(q[i].entries, 6);
        return result;
    }
};

/// What a neighbour list says of the first one, by images.
int any_of_list(SmallSystem const &system)
{
    pw85::Neighbors list;
    g_assert_true(neighbors_create(system.particles(), {}, list) == pw85::Status::success);
    std::vector<std::int32_t> others;
    std::vector<pw85::Image> images;
    for (std::size_t k = 0; k < list.pairs().size(); ++k) {
        auto const [i, j] = list.pairs()[k];
        if (i != 0) continue;
        others.push_back(j);
        images.push_back(list.images()[k]);
    }
    int any = 7;
    g_assert_true(overlap_any_indices(system.centers[0], system.q[0], others, images,
                                      system.particles(), any) == pw85::Status::success);
    return any;
}

// Cells larger and smaller than the particles: the answer is about all images, or an error. It is
// one only where the limit of nearest images is below 1; and lists of images decide everywhere.
PW85_TEST("/systems/overlap_any_images")
{
    Failures failures;
    Random random(68);
    int counts[2][2] = {}, refused = 0; // by the answer, and whether nearest images are not all
    for (int trial = 0; trial < draws(1200); ++trial) {
        SmallSystem const system(random, 1 + trial % 24, random.log_uniform(1.5, 8.0));
        int const expected = system.overlaps();
        failures.check(any_of_list(system) == expected, "any by images", any_of_list(system),
                       expected, [&] { return system.text(); });
        std::vector<std::int32_t> others;
        for (int i = 1; i < static_cast<int>(system.q.size()); ++i) others.push_back(i);
        double limit;
        g_assert_true(nearest_image_limit(system.particles(), limit) == pw85::Status::success);
        int any = 7;
        pw85::Status const status =
            overlap_any_indices(system.centers[0], system.q[0], others, system.particles(), any);
        bool const good = status == pw85::Status::success
                              ? any == expected
                              : status == pw85::Status::invalid_argument && any == -1;
        failures.check(good && (status == pw85::Status::success || limit < 1.0), "any", any,
                       expected, [&] { return system.text(); });
        if (status == pw85::Status::success)
            ++counts[expected][limit < 1.0];
        else
            ++refused;
    }
    for (int const count : {counts[0][0], counts[1][0], counts[1][1], refused})
        g_assert_cmpint(count, >, draws(40));
    g_assert_cmpint(counts[0][1], ==, 0);
}

// Rows as one by one, in threads too: the same bits, marks, and the status of the first bad one.
PW85_TEST("/systems/forms")
{
    Random random(64);
    std::size_t const n = 10001;
    std::vector<Vector3> semi_axes(n), half_widths(n);
    std::vector<Vector4> quaternions(n);
    std::vector<Form3> q(n);
    for (std::size_t i = 0; i < n; ++i) {
        semi_axes[i] = random.log_uniform(1e-150, 1e150) * random.semi_axes(1.0, 100.0);
        quaternions[i] = random.log_uniform(1e-3, 1e3) * random.direction<4>();
    }
    g_assert_true(pw85::ellipsoid_quaternion_batch(semi_axes, quaternions, q) ==
                  pw85::Status::success);
    g_assert_true(pw85::bounding_boxes(q, half_widths) == pw85::Status::success);
    semi_axes[7000][1] = 0.0;
    quaternions[300] = {};
    g_assert_true(pw85::ellipsoid_quaternion_batch(semi_axes, quaternions, q) ==
                  pw85::Status::invalid_argument);
    for (std::size_t i = 0; i < n; ++i) {
        Form3 expected;
        pw85_ellipsoid_quaternion(semi_axes[i].coordinates, quaternions[i].coordinates,
                                  expected.entries);
        bool const bad = i == 300 || i == 7000;
        for (int k = 0; k < 6; ++k)
            g_assert_true(bad ? std::isnan(q[i][k]) : q[i][k] == expected[k]);
        for (int d = 0; d < 3 && !bad; ++d)
            g_assert_cmpfloat(half_widths[i][d], ==, std::sqrt(q[i](d, d)));
    }
}

// A box is touched by the ellipsoid on each side, at ± Q e/√(eᵀQe), and by no point of it left.
PW85_TEST("/systems/bounding_boxes")
{
    Failures failures;
    Random random(65);
    for (int n = 0; n < draws(1000); ++n) {
        Form3 const q = random.form(1.0, 20.0);
        Vector3 half_widths;
        g_assert_cmpint(pw85_bounding_boxes(1, q.entries, half_widths.coordinates), ==,
                        PW85_SUCCESS);
        auto const inverse = pw85::detail::factorize(q, 0.0);
        for (int d = 0; d < 3; ++d) {
            Vector3 const column = {q(0, d), q(1, d), q(2, d)};
            Vector3 const touching = 1.0 / half_widths[d] * column;
            double const level = pw85::dot(touching, pw85::detail::solve(inverse, touching));
            failures.check(std::fabs(level - 1.0) <= 1e-12 &&
                               std::fabs(touching[d] - half_widths[d]) <= 4 * u,
                           "level", level, 1.0, [&] { return hex_text(q.entries, 6); });
        }
    }
    double const nan = std::numeric_limits<double>::quiet_NaN();
    double const forms[5][6] = {{1, 0, 0, 4, 0, 9},
                                {1, 2, 0, 1, 0, 1},
                                {1, 0, 0, nan, 0, 1},
                                {1, 0, 0, 0, 0, 1},
                                {1, 0, 0, 1, 0, 1}};
    double boxes[5][3];
    g_assert_cmpint(pw85_bounding_boxes(5, forms[0], boxes[0]), ==, PW85_ENOTPD);
    g_assert_cmpint(pw85_bounding_boxes(3, forms[2], boxes[2]), ==, PW85_EINVAL);
    double const zeros[6] = {};
    g_assert_cmpint(pw85_bounding_boxes(1, zeros, boxes[1]), ==, PW85_ENOTPD);
    g_assert_true(boxes[0][0] == 1.0 && boxes[0][1] == 2.0 && boxes[0][2] == 3.0 &&
                  boxes[4][2] == 1.0);
    for (int const bad : {1, 2, 3})
        for (double const x : boxes[bad]) g_assert_true(std::isnan(x));
    g_assert_true(
        pw85::bounding_box(pw85::SymmetricMatrix<float, 2>{4.0f, 1.0f, 9.0f}).half_widths[1] ==
        3.0f);
}

PW85_TEST("/systems/arguments")
{
    double const x[6] = {1.0, 0.0, 0.0, 1.0, 0.0, 1.0};
    int any = 7;
    std::size_t const huge = SIZE_MAX / 48 + 1;
    g_assert_cmpint(pw85_overlap_any(nullptr, 0, nullptr, nullptr, &any), ==, PW85_SUCCESS);
    g_assert_cmpint(any, ==, 0);
    g_assert_cmpint(pw85_overlap_any(x, 1, x, x, nullptr), ==, PW85_EINVAL);
    for (int missing = 0; missing < 4; ++missing) {
        any = 7;
        g_assert_cmpint(pw85_overlap_any(missing == 0 ? nullptr : x, missing == 3 ? huge : 1,
                                         missing == 1 ? nullptr : x, missing == 2 ? nullptr : x,
                                         &any),
                        ==, PW85_EINVAL);
        g_assert_cmpint(any, ==, -1);
    }
}

} // namespace
