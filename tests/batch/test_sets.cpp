// SPDX-License-Identifier: BSD-3-Clause
// The functions of many ellipsoids and convex sets, which use lanes: against brute force in 50
// digits, against the functions of one, and with bad rows among the others.
#include <cstring>
#include <limits>
#include <vector>

#include <glib.h>

#include "../draws.hpp"
#include "../shape_cases.hpp"

using namespace pw85_tests;

namespace {

/// What a function of many gives. A row more than it computes shows whether it writes too much.
struct Results {
    std::vector<double> mu2, point;
    std::vector<unsigned char> overlap;
    int contact_status, overlap_status;

    explicit Results(std::size_t n) : mu2(n + 1, 7.0), point(3 * n + 3, 7.0), overlap(n + 1, 7) {}

    pw85::ShapeContact<double> contact(std::size_t n) const
    {
        return {mu2[n], {point[3 * n], point[3 * n + 1], point[3 * n + 2]}, pw85::Status::success};
    }

    bool is_same(std::size_t n, Results const &other, std::size_t m) const
    {
        return std::memcmp(&mu2[n], &other.mu2[m], sizeof(double)) == 0 &&
               std::memcmp(&point[3 * n], &other.point[3 * m], 3 * sizeof(double)) == 0 &&
               overlap[n] == other.overlap[m];
    }
};

/// Rows of arrays.
template <class Shape> struct Rows {
    std::vector<double> points[Shape::size], q;

    explicit Rows(std::vector<Case<Shape::size>> const &cases)
    {
        for (auto const &c : cases) {
            for (std::size_t k = 0; k < Shape::size; ++k)
                points[k].insert(points[k].end(), c.points[k].coordinates,
                                 c.points[k].coordinates + 3);
            q.insert(q.end(), c.q.entries, c.q.entries + 6);
        }
    }

    Results compute(std::size_t begin, std::size_t n) const
    {
        double const *first[Shape::size];
        for (std::size_t k = 0; k < Shape::size; ++k) first[k] = points[k].data() + 3 * begin;
        Results results(n);
        results.contact_status = Shape::contact_batch(n, first, q.data() + 6 * begin,
                                                      results.mu2.data(), results.point.data());
        results.overlap_status =
            Shape::overlap_batch(n, first, q.data() + 6 * begin, results.overlap.data());
        return results;
    }
};

/// The results of the functions of one, as those of one row.
template <class Shape> Results compute_one(Case<Shape::size> const &c)
{
    Results results(1);
    int overlap = 7;
    results.contact_status = Shape::contact_in_c(c, results.mu2.data(), results.point.data());
    results.overlap_status = Shape::overlap_in_c(c, &overlap);
    results.overlap[0] = static_cast<unsigned char>(overlap);
    return results;
}

/// A row that is refused, of one kind after the other.
template <class Shape> Case<Shape::size> spoiled(Case<Shape::size> c, int n)
{
    double const infinity = std::numeric_limits<double>::infinity(),
                 nan = std::numeric_limits<double>::quiet_NaN();
    auto &last = c.points[Shape::size - 1];
    switch (n % 5) {
    case 0:
        c.q[0] = -c.q[0];
        break;
    case 1:
        c.q[n / 5 % 6] = nan;
        break;
    case 2:
        last[n / 5 % 3] = n % 2 == 0 ? nan : infinity;
        break;
    case 3:
        c.q = {1, 1, 1, 1, 1, 1};
        break;
    default:
        c.q[4] = infinity;
    }
    return c;
}

/// A row like no other: its centre in the set or at its end, equal points, or sizes that need other
/// units.
template <class Shape> Case<Shape::size> unusual(Case<Shape::size> c, int n)
{
    switch (n % 4) {
    case 0:
        for (auto &x : c.points) x = {0, 0, 0};
        return c;
    case 1:
        for (auto &x : c.points) x = c.points[0];
        return c;
    case 2:
        c.points[0] = {0, 0, 0};
        if constexpr (std::is_same_v<Shape, Box>)
            for (int i = 0; i < 3; ++i) c.points[1][i] = std::abs(c.points[1][i]);
        return c;
    default:
        return scaled(c, 300, 300);
    }
}

/// Hostile rows of any sizes: random ones, some near contact, some unusual and some bad, then
/// slivers.
template <class Shape> std::vector<Case<Shape::size>> mixed_cases(std::size_t count)
{
    Random random(1200);
    std::vector<Case<Shape::size>> cases;
    for (int n = 0; cases.size() < count; ++n) {
        auto c = random_case<Shape>(random, n);
        bool overlaps = false;
        if (n % 3 == 1 && !draw_near_touch<Shape, double>(random, n, c, overlaps)) continue;
        if (n % 16 == 5) c = spoiled<Shape>(c, n / 16);
        if (n % 16 == 11) c = unusual<Shape>(c, n / 16);
        int const exponent = n % 7 % 3 - 1;
        cases.push_back(scaled(c, 40 * exponent, 40 * exponent));
    }
    if constexpr (std::is_same_v<Shape, Triangle>) {
        // which pass the fast checks
        for (auto const &c : slivers()) cases.push_back(scaled(c, -32, 0));
        for (int n = 0; n < 400; ++n) cases.push_back(long_sliver(random, n));
    }
    for (int n = 0; n < 100; ++n) cases.push_back(beside_thin_form<Shape>(random, n));
    return cases;
}

// Each row of many has the status and the overlap of one. Its contact function has the error of
// one, and is NaN where that of one is.
template <class Shape> void test_rows()
{
    Failures failures;
    auto const cases = mixed_cases<Shape>(static_cast<std::size_t>(draws(4000)));
    auto const many = Rows<Shape>(cases).compute(0, cases.size());
    int first_bad = PW85_SUCCESS;
    double worst = 0;
    for (std::size_t n = 0; n < cases.size(); ++n) {
        auto const one = compute_one<Shape>(cases[n]);
        auto const describe = [&] { return std::string(Shape::name) + ": " + text(cases[n]); };
        if (first_bad == PW85_SUCCESS) first_bad = one.contact_status;
        failures.check(many.overlap[n] == one.overlap[0], "overlap", many.overlap[n],
                       one.overlap[0], describe);
        if (one.contact_status != PW85_SUCCESS)
            failures.check(many.is_same(n, one, 0), "bad row", many.mu2[n], one.mu2[0], describe);
        else if (one.mu2[0] > 0)
            worst = std::max(worst, check_contact<Shape>(cases[n], many.contact(n),
                                                         Shape::truth(convert<Wide>(cases[n])), 0,
                                                         0, failures));
        else
            failures.check(many.mu2[n] == 0, "around the centre", many.mu2[n], 0, describe);
    }
    g_test_message("largest error %.3g u S", worst);
    g_assert_cmpint(first_bad, !=, PW85_SUCCESS);
    g_assert_cmpint(many.contact_status, ==, first_bad);
    g_assert_cmpint(many.overlap_status, ==, first_bad);
}

// The bits of a row depend on the row alone: not on its place, nor on the number of rows. Nothing
// is written behind the last row.
template <class Shape> void test_places()
{
    constexpr std::size_t most = 40;
    Failures failures;
    auto const cases = mixed_cases<Shape>(2 * most);
    Rows<Shape> const rows(cases);
    auto const all = rows.compute(0, cases.size());
    for (std::size_t n = 1; n <= most; ++n)
        for (std::size_t const begin : {std::size_t{0}, std::size_t{1}, n}) {
            auto const some = rows.compute(begin, n);
            for (std::size_t k = 0; k < n; ++k)
                failures.check(some.is_same(k, all, begin + k), "row", some.mu2[k],
                               all.mu2[begin + k], [&] { return text(cases[begin + k]); });
            failures.check(some.is_same(n, Results(0), 0), "behind the last row", some.mu2[n], 7.0,
                           [&] { return std::to_string(n) + " rows"; });
        }
}

// In the reproducible mode the bits of many are those of one.
template <class Shape> void test_reproducible()
{
    Failures failures;
    auto const cases = mixed_cases<Shape>(static_cast<std::size_t>(draws(16000)));
    int before = 0;
    pw85_is_reproducible(&before);
    pw85_set_reproducible(1);
    auto const many = Rows<Shape>(cases).compute(0, cases.size());
    for (std::size_t n = 0; n < cases.size(); ++n) {
        auto const one = compute_one<Shape>(cases[n]);
        failures.check(many.is_same(n, one, 0), "bits", many.mu2[n], one.mu2[0],
                       [&] { return text(cases[n]); });
    }
    pw85_set_reproducible(before);
}

// Outputs and arrays that are null.
template <class Shape> void test_null()
{
    auto const cases = mixed_cases<Shape>(64);
    Rows<Shape> const rows(cases);
    auto const all = rows.compute(0, cases.size());
    double const *first[Shape::size];
    for (std::size_t k = 0; k < Shape::size; ++k) first[k] = rows.points[k].data();
    std::vector<double> mu2(64), point(3 * 64);
    std::vector<unsigned char> overlap(64, 7);
    g_assert_cmpint(Shape::contact_batch(64, first, rows.q.data(), mu2.data(), nullptr), ==,
                    all.contact_status);
    g_assert_cmpint(Shape::contact_batch(64, first, rows.q.data(), nullptr, point.data()), ==,
                    all.contact_status);
    g_assert_cmpint(Shape::contact_batch(64, first, rows.q.data(), nullptr, nullptr), ==,
                    all.contact_status);
    g_assert_cmpint(std::memcmp(mu2.data(), all.mu2.data(), 64 * sizeof(double)), ==, 0);
    g_assert_cmpint(std::memcmp(point.data(), all.point.data(), 3 * 64 * sizeof(double)), ==, 0);
    g_assert_cmpint(Shape::overlap_batch(64, first, rows.q.data(), nullptr), ==, PW85_EINVAL);
    g_assert_cmpint(Shape::contact_batch(64, first, nullptr, mu2.data(), nullptr), ==, PW85_EINVAL);
    g_assert_cmpint(Shape::overlap_batch(SIZE_MAX / 2, first, rows.q.data(), overlap.data()), ==,
                    PW85_EINVAL);
    first[Shape::size - 1] = nullptr;
    g_assert_cmpint(Shape::overlap_batch(64, first, rows.q.data(), overlap.data()), ==,
                    PW85_EINVAL);
    g_assert_cmpint(overlap[0], ==, 7);
    g_assert_cmpint(Shape::contact_batch(0, first, nullptr, nullptr, nullptr), ==, PW85_SUCCESS);
}

template <class Shape> void add_tests()
{
    std::string const prefix = std::string("/sets/") + Shape::name;
    g_test_add_func((prefix + "/rows").c_str(), test_rows<Shape>);
    g_test_add_func((prefix + "/places").c_str(), test_places<Shape>);
    g_test_add_func((prefix + "/reproducible").c_str(), test_reproducible<Shape>);
    g_test_add_func((prefix + "/null").c_str(), test_null<Shape>);
}

} // namespace

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, nullptr);
    add_tests<Segment>();
    add_tests<Triangle>();
    add_tests<Box>();
    return g_test_run();
}
