// SPDX-License-Identifier: BSD-3-Clause
// Tests of the reference data: its checksum, its shape, and the relations between its values.
#include <glib.h>

#include "cases.hpp"
#include "failures.hpp"
#include "reference_data.hpp"

using namespace pw85_tests;

namespace {

PW85_TEST("/reference_data/checksum")
{
    gchar *contents = nullptr, *expected = nullptr;
    gsize length = 0;
    std::string const sum_path = std::string(reference_data_path()) + ".sha256";
    g_assert_true(g_file_get_contents(reference_data_path(), &contents, &length, nullptr));
    g_assert_true(g_file_get_contents(sum_path.c_str(), &expected, nullptr, nullptr));
    gchar *actual = g_compute_checksum_for_data(G_CHECKSUM_SHA256,
                                                reinterpret_cast<guchar const *>(contents), length);
    expected[64] = '\0';
    g_assert_cmpstr(actual, ==, expected);
    g_free(actual);
    g_free(expected);
    g_free(contents);
}

PW85_TEST("/reference_data/grid/shape")
{
    auto const &grid = spheroid_grid();
    g_assert_cmpuint(grid.radii.size(), ==, 3);
    g_assert_cmpfloat(grid.radii[0], ==, 0.0199);
    g_assert_cmpfloat(grid.radii[1], ==, 1.999);
    g_assert_cmpfloat(grid.radii[2], ==, 9.999);
    g_assert_cmpuint(grid.directions.size(), ==, 12);
    g_assert_cmpuint(grid.lambdas.size(), ==, 11);
    g_assert_cmpuint(grid.spheroids.size(), ==, 108);
    g_assert_cmpuint(grid.f.size(), ==, 108u * 108u * 12u * 11u);
}

PW85_TEST("/reference_data/contact/coverage")
{
    auto const &problems = contact_problems();
    g_assert_cmpuint(problems.size(), >=, 10000);
    double nearest = 1.0, largest_cond = 0.0;
    int tangent = 0;
    for (auto const &p : problems) {
        double const distance = pw85::detail::absolute(p.mu2_minus_1);
        if (distance > 0.0 && distance < nearest) nearest = distance;
        if (p.cond > largest_cond) largest_cond = p.cond;
        tangent += distance == 0.0;
    }
    g_assert_cmpfloat(nearest, <, 2e-15);
    g_assert_cmpfloat(largest_cond, >, 1e9);
    g_assert_cmpint(tangent, ==, 1000);
}

// Crossed pairs are tip to tip, near contact, and among those found are the three that showed what
// was wrong with λ on a plateau: in the batch, in its overlaps, and for one pair.
PW85_TEST("/reference_data/contact/crossed")
{
    int drawn = 0, found = 0, known = 0;
    for (auto const &p : contact_problems()) {
        drawn += *p.category == "crossed";
        if (*p.category == "crossed")
            g_assert_cmpfloat(pw85::detail::absolute(p.mu2_minus_1), <, 0.1);
        found += *p.category == "crossed_found";
        double const x = p.pair.r12[0];
        known +=
            x == -0x1.4698768475adcp-2 || x == -0x1.8163e57088631p-1 || x == 0x1.8d996658961cp+0;
    }
    g_assert_cmpint(drawn, ==, 2000);
    g_assert_cmpint(found, >=, 240);
    g_assert_cmpint(known, ==, 3);
}

// What follows from the definitions: λ inside (0, 1), cond >= 1, and mu2 and mu2_minus_1 one
// number.
PW85_TEST("/reference_data/contact/consistency")
{
    Failures failures;
    for (auto const &p : contact_problems()) {
        auto const describe = [&] { return *p.category + ": " + hex_text(p.pair); };
        failures.check(p.lambda > 0.0 && p.lambda < 1.0, "lambda", p.lambda, 1.0, describe);
        failures.check(p.cond >= 1.0, "cond", p.cond, 1.0, describe);
        double const difference = pw85::detail::absolute((p.mu2 - 1.0) - p.mu2_minus_1);
        failures.check(difference <= 0x1p-53 * (1.0 + p.mu2), "mu2 - 1", difference, 0x1p-53,
                       describe);
    }
}

} // namespace
