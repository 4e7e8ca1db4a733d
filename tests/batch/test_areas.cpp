// SPDX-License-Identifier: BSD-3-Clause
// Tests of the lanes for areas of common parts (src/simd/lanes/two_dimensions.hpp).
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include <glib.h>

#include <pw85_batch.h>

#include "../cases.hpp"
#include "../random_pairs.hpp"

using namespace pw85_tests;

namespace {

/// Rows of all kinds, bad ones among them, give the bits and the statuses of single pairs, for any
/// number of rows.
PW85_TEST("/areas/rows")
{
    Random random(935);
    constexpr std::size_t n = 1100;
    std::vector<double> r12(2 * n), q1(3 * n), q2(3 * n), areas(n);
    for (std::size_t k = 0; k < n; ++k) {
        PairOptions options{};
        options.aspect = k % 3 == 0 ? 2.0 : k % 3 == 1 ? 20.0 : 2000.0;
        options.mu2_min = 1e-3;
        auto p = random_pair<2>(random, options);
        if (k % 50 == 1) p.r12 = {0.0, 0.0};
        if (k % 50 == 2) p.q1(1, 1) = -1.0;
        if (k % 50 == 3) p.r12[0] = std::numeric_limits<double>::quiet_NaN();
        if (k % 50 == 4) p.q2 = p.q1;
        if (k % 50 == 5) p.q1 = 0x1p-400 * p.q1;
        std::copy_n(p.r12.coordinates, 2, &r12[2 * k]);
        std::copy_n(p.q1.entries, 3, &q1[3 * k]);
        std::copy_n(p.q2.entries, 3, &q2[3 * k]);
    }
    for (std::size_t count : {std::size_t(1), std::size_t(9), std::size_t(257), n}) {
        int first = PW85_SUCCESS;
        int const status =
            pw85_overlap_area_batch_2d(count, r12.data(), q1.data(), q2.data(), areas.data());
        for (std::size_t k = 0; k < count; ++k) {
            double one = 0.0;
            int const each = pw85_overlap_area_2d(&r12[2 * k], &q1[3 * k], &q2[3 * k], &one);
            if (first == PW85_SUCCESS) first = each;
            g_assert_true(std::isnan(one) ? std::isnan(areas[k])
                                          : std::memcmp(&one, &areas[k], sizeof one) == 0);
        }
        g_assert_cmpint(status, ==, first);
    }
    g_assert_cmpint(pw85_overlap_area_batch_2d(1, r12.data(), q1.data(), nullptr, areas.data()), ==,
                    PW85_EINVAL);
    g_assert_cmpint(pw85_overlap_area_batch_2d(0, nullptr, nullptr, nullptr, nullptr), ==,
                    PW85_SUCCESS);
}

} // namespace
