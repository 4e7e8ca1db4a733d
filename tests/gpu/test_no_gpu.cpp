// SPDX-License-Identifier: BSD-3-Clause
// Tests the statuses if no device can be used. There is one run for each way in which a driver can
// fail.
#include <cmath>
#include <vector>

#include <glib.h>

#include <pw85_gpu.h>

#include "../batch/batch_data.hpp"
#include "../cases.hpp"

using namespace pw85_tests;

namespace {

constexpr std::size_t n = 1000;

struct Arrays {
    std::vector<double> r12, q1, q2;
};

Arrays arrays()
{
    Random random(710);
    Arrays a;
    for (std::size_t i = 0; i < n; ++i) {
        auto const p = random_pair<3>(random, {});
        a.r12.insert(a.r12.end(), p.r12.coordinates, p.r12.coordinates + 3);
        a.q1.insert(a.q1.end(), p.q1.entries, p.q1.entries + 6);
        a.q2.insert(a.q2.end(), p.q2.entries, p.q2.entries + 6);
    }
    return a;
}

bool all_nan(std::vector<double> const &x)
{
    bool nan = true;
    for (double const y : x) nan = nan && std::isnan(y);
    return nan;
}

/// PW85_FAILS names the functions that must fail: all, or those of overlaps.
bool fails(char const *function)
{
    return g_strcmp0(g_getenv("PW85_FAILS"), "all") == 0 ||
           g_strcmp0(g_getenv("PW85_FAILS"), function) == 0;
}

PW85_TEST("/no_gpu/contact")
{
    Arrays const a = arrays();
    std::vector<double> mu2(n, 1.0), lambda(n, 1.0), vectors(3 * n, 1.0);
    int const expected = fails("contact") ? PW85_EDEVICE : PW85_SUCCESS;
    g_assert_cmpint(
        pw85_gpu_contact_host(n, a.r12.data(), a.q1.data(), a.q2.data(), mu2.data(), lambda.data()),
        ==, expected);
    g_assert_true(all_nan(mu2) == (expected != PW85_SUCCESS));
    g_assert_true(all_nan(lambda) == (expected != PW85_SUCCESS));
    g_assert_cmpint(pw85_gpu_contact_derivatives_host(n, a.r12.data(), a.q1.data(), a.q2.data(),
                                                      nullptr, nullptr, vectors.data(), nullptr,
                                                      nullptr, nullptr, nullptr),
                    ==, expected);
    g_assert_true(all_nan(vectors) == (expected != PW85_SUCCESS));
}

PW85_TEST("/no_gpu/overlap")
{
    Arrays const a = arrays();
    std::vector<unsigned char> overlap(n, 1);
    int const expected = fails("overlap") ? PW85_EDEVICE : PW85_SUCCESS;
    g_assert_cmpint(
        pw85_gpu_overlap_host(n, a.r12.data(), a.q1.data(), a.q2.data(), overlap.data()), ==,
        expected);
    if (expected != PW85_SUCCESS)
        for (unsigned char const x : overlap) g_assert_cmpint(x, ==, 255);
}

PW85_TEST("/no_gpu/device_pointers")
{
    Arrays const a = arrays();
    std::vector<double> mu2(n, 1.0);
    if (!fails("all")) return;
    // Memory of the host would be an invalid argument if there were a device.
    int const status = pw85_gpu_contact_batch(nullptr, n, a.r12.data(), a.q1.data(), a.q2.data(),
                                              mu2.data(), nullptr);
    g_assert_true(status == PW85_EDEVICE || status == PW85_EINVAL);
    g_assert_cmpfloat(mu2[0], ==, 1.0);
}

PW85_TEST("/no_gpu/sentence")
{
    g_assert_nonnull(g_strstr_len(pw85_strerror(PW85_EDEVICE), -1, "GPU"));
}

PW85_TEST("/no_gpu/everything_else")
{
    Arrays const a = arrays();
    std::vector<double> mu2(n);
    g_assert_cmpint(
        pw85_contact_batch(n, a.r12.data(), a.q1.data(), a.q2.data(), mu2.data(), nullptr), ==,
        PW85_SUCCESS);
    int count = 1;
    bool const absent = g_strcmp0(g_getenv("PW85_DEVICES"), "0") == 0;
    g_assert_cmpint(pw85_gpu_count(&count), ==, absent ? PW85_EDEVICE : PW85_SUCCESS);
    g_assert_cmpint(count, ==, absent ? 0 : 1);
}

} // namespace
