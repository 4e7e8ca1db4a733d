// SPDX-License-Identifier: BSD-3-Clause
// Compares the functions for devices with those for the host, on a device or with the driver of
// fake_driver.cpp.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <thread>
#include <vector>

#include <dlfcn.h>
#include <glib.h>

#include <pw85_gpu.h>

#include "../batch/batch_data.hpp"
#include "../condition_number.hpp"
#include "../failures.hpp"
#include "../random_pairs.hpp"
#include "../reference_data.hpp"
#include "../systems.hpp"
#include "device.hpp"

using namespace pw85_tests;

namespace {

constexpr double u = 0x1p-53;

/// Pairs in arrays.
struct Columns {
    std::vector<double> r12, q1, q2;

    explicit Columns(std::vector<Pair3> const &pairs)
    {
        for (Pair3 const &p : pairs) {
            r12.insert(r12.end(), p.r12.coordinates, p.r12.coordinates + 3);
            q1.insert(q1.end(), p.q1.entries, p.q1.entries + 6);
            q2.insert(q2.end(), p.q2.entries, p.q2.entries + 6);
        }
    }
};

/// The same on the device.
struct DeviceColumns {
    DeviceArray<double> r12, q1, q2;

    explicit DeviceColumns(Columns const &c) : r12(c.r12), q1(c.q1), q2(c.q2) {}
};

/// What the device says of pairs.
BatchResult run_on_device(std::vector<Pair3> const &pairs)
{
    std::size_t const n = pairs.size();
    DeviceColumns const in{Columns(pairs)};
    DeviceArray<double> const mu2(n), lambda(n);
    DeviceArray<unsigned char> const overlap(n);
    Stream const stream;
    BatchResult result{{}, {}, {}, 0, 0};
    result.contact_status = pw85_gpu_contact_batch(stream.handle(), n, in.r12.get(), in.q1.get(),
                                                   in.q2.get(), mu2.get(), lambda.get());
    result.overlap_status = pw85_gpu_overlap_batch(stream.handle(), n, in.r12.get(), in.q1.get(),
                                                   in.q2.get(), overlap.get());
    stream.wait();
    result.mu2 = mu2.values();
    result.lambda = lambda.values();
    result.overlap = overlap.values();
    return result;
}

std::vector<Pair3> all_problems()
{
    std::vector<Pair3> pairs;
    for (ContactProblem const &p : contact_problems()) pairs.push_back(p.pair);
    return pairs;
}

void test_problems()
{
    Failures failures;
    auto const &problems = contact_problems();
    auto const result = run_on_device(all_problems());
    g_assert_cmpint(result.contact_status, ==, PW85_SUCCESS);
    g_assert_cmpint(result.overlap_status, ==, PW85_SUCCESS);
    double worst = 0.0;
    for (std::size_t i = 0; i < problems.size(); ++i) {
        ContactProblem const &p = problems[i];
        auto const describe = [&] { return hex_text(p.pair) + ", " + *p.category; };
        double const error = std::fabs(result.mu2[i] - p.mu2) / p.mu2 / (u * p.cond);
        worst = std::fmax(worst, error);
        failures.check(error <= 4.0, "error in u cond", error, 4.0, describe);
        failures.check(result.overlap[i] == (p.mu2_minus_1 < 0.0), "overlap", result.overlap[i],
                       p.mu2_minus_1 < 0.0, describe);
    }
    g_test_message("%zu problems, largest error %.2f u cond", problems.size(), worst);
}

// Bad pairs among good ones, and whatever goes beyond the first stage.
void test_like_host()
{
    Failures failures;
    Random random(700);
    for (std::size_t const n : {std::size_t{1}, std::size_t{127}, std::size_t{128},
                                std::size_t{129}, std::size_t{20000}}) {
        auto const pairs = mixed_pairs(random, n);
        auto const host = run_batch(pairs), result = run_on_device(pairs);
        g_assert_cmpint(result.contact_status, ==, PW85_SUCCESS);
        g_assert_cmpint(result.overlap_status, ==, PW85_SUCCESS);
        for (std::size_t i = 0; i < n; ++i) {
            auto const describe = [&] { return hex_text(pairs[i]); };
            failures.check(result.overlap[i] == host.overlap[i], "overlap", result.overlap[i],
                           host.overlap[i], describe);
            bool const bad = std::isnan(host.mu2[i]);
            failures.check(std::isnan(result.mu2[i]) == bad && std::isnan(result.lambda[i]) == bad,
                           "NaN", result.mu2[i], host.mu2[i], describe);
            if (bad || host.mu2[i] == 0.0) continue;
            auto const wide = convert<long double>(pairs[i]);
            double const cond = static_cast<double>(
                condition_number(wide, static_cast<long double>(host.lambda[i])));
            // Either errs by 4 u cond at most.
            double const error = std::fabs(result.mu2[i] / host.mu2[i] - 1.0), bound = 8 * u * cond;
            failures.check(error <= bound || !std::isfinite(bound), "difference", error, bound,
                           describe);
        }
    }
}

/// Five vectors per pair: point, normal, d_r12, d_rot1, d_rot2.
struct Vectors {
    DeviceArray<double> rows[5];
    explicit Vectors(std::size_t n)
        : rows{DeviceArray<double>(3 * n), DeviceArray<double>(3 * n), DeviceArray<double>(3 * n),
               DeviceArray<double>(3 * n), DeviceArray<double>(3 * n)}
    {
    }
};

double largest(double const *x)
{
    return std::fmax(std::fabs(x[0]), std::fmax(std::fabs(x[1]), std::fabs(x[2])));
}

/// The vectors of a pair by the functions for one pair, and the numbers to which errors are
/// relative.
struct ExpectedVectors {
    double of[5][3], scale[5];

    ExpectedVectors(Pair3 const &p, double lambda)
    {
        double const *const r = p.r12.coordinates, *const q1 = p.q1.entries,
                            *const q2 = p.q2.entries;
        pw85_contact_geometry(r, q1, q2, lambda, of[0], of[1]);
        pw85_contact_gradient(r, q1, q2, lambda, of[2], nullptr, nullptr);
        pw85_contact_torque(r, q1, q2, lambda, of[3], of[4]);
        double const torque = largest(of[2]) * largest(r);
        for (int k = 0; k < 5; ++k)
            scale[k] = k < 3 ? largest(of[k]) : std::fmax(largest(of[k]), torque);
    }
};

// Those of the functions for one pair at the same λ: either errs by 64 u aspect² of the largest
// coordinate and what the adjugate adds, at most 2^-28 (tests/batch/test_derivatives.cpp), or is as
// exact.
void test_derivatives()
{
    Failures failures;
    Random random(701);
    std::vector<Pair3> pairs = mixed_pairs(random, 300);
    std::size_t const num_mixed = pairs.size();
    for (int i = 0; i < 3000; ++i) pairs.push_back(random_pair<3>(random, {.aspect = 30.0}));
    std::size_t const n = pairs.size();
    DeviceColumns const in{Columns(pairs)};
    DeviceArray<double> const mu2(n), lambda(n);
    Vectors const v(n);
    Stream const stream;
    g_assert_cmpint(pw85_gpu_contact_derivatives_batch(
                        stream.handle(), n, in.r12.get(), in.q1.get(), in.q2.get(), mu2.get(),
                        lambda.get(), v.rows[0].get(), v.rows[1].get(), v.rows[2].get(),
                        v.rows[3].get(), v.rows[4].get()),
                    ==, PW85_SUCCESS);
    stream.wait();
    auto const lambdas = lambda.values(), mu2s = mu2.values();
    auto const host = run_batch(pairs);
    std::vector<double> rows[5];
    for (int k = 0; k < 5; ++k) rows[k] = v.rows[k].values();
    for (std::size_t i = 0; i < n; ++i) {
        ExpectedVectors const expected(pairs[i], lambdas[i]);
        auto const describe = [&] { return hex_text(pairs[i]); };
        failures.check(std::isnan(mu2s[i]) == std::isnan(host.mu2[i]), "NaN", mu2s[i], host.mu2[i],
                       describe);
        for (std::size_t j = 0; j < 15; ++j) {
            std::size_t const k = j / 3;
            double const x = rows[k][3 * i + j % 3], y = expected.of[k][j % 3];
            auto const number = [&] { return describe() + ", number " + std::to_string(j); };
            failures.check(std::isnan(x) == std::isnan(y), "NaN of a vector", x, y, number);
            if (i < num_mixed || std::isnan(y)) continue;
            double const bound = 2 * (64 * u * 900 + 0x1p-28) * expected.scale[k];
            failures.check(std::fabs(x - y) <= bound, "coordinate", std::fabs(x - y), bound,
                           number);
        }
    }
}

/// Particles whose centres, and a cell whose vectors, are multiples of a power of two, so that
/// separations are exact.
struct System {
    static constexpr std::size_t num_particles = 500, num_pairs = 5000;
    std::vector<double> centers, q;
    std::vector<std::int32_t> pairs, images;
    double cell[9] = {8.0, 0.0, 0.0, 1.5, 7.0, 0.0, -2.25, 0.5, 9.0};

    explicit System(Random &random)
    {
        for (std::size_t i = 0; i < num_particles; ++i) {
            for (int d = 0; d < 3; ++d)
                centers.push_back(std::round(random.uniform(-10.0, 10.0) * 0x1p20) * 0x1p-20);
            auto const form = random.form(4.0, random.log_uniform(1.0, 100.0));
            q.insert(q.end(), form.entries, form.entries + 6);
        }
        for (std::size_t k = 0; k < 2 * num_pairs; ++k)
            pairs.push_back(
                static_cast<std::int32_t>(random.uniform(0.0, static_cast<double>(num_particles))));
        for (std::size_t k = 0; k < 3 * num_pairs; ++k)
            images.push_back(static_cast<std::int32_t>(std::floor(random.uniform(-1.0, 2.0))));
    }
};

struct ListCase {
    bool cell, images, open; ///< open: not periodic along one of the vectors
};

/// What is computed for the pairs of a list.
struct ListResults {
    std::vector<double> mu2, forces;
    std::vector<unsigned char> overlaps;
};

ListResults on_device(System const &s, ListCase const &c)
{
    double const *const cell = c.cell ? s.cell : nullptr;
    std::size_t const n = System::num_pairs;
    DeviceArray<double> const centers(s.centers), q(s.q), mu2(n), lambda(n), force(3 * n);
    DeviceArray<std::int32_t> const pairs(s.pairs), images(s.images);
    DeviceArray<unsigned char> const overlap(n);
    auto const list = list_of(n, pairs.get(), c.images ? images.get() : nullptr);
    auto const system = system_of(System::num_particles, centers.get(), q.get(), cell, c.open);
    Stream const stream;
    g_assert_cmpint(pw85_gpu_contact_pairs(stream.handle(), list, system, mu2.get(), lambda.get()),
                    ==, PW85_SUCCESS);
    g_assert_cmpint(pw85_gpu_overlap_pairs(stream.handle(), list, system, overlap.get()), ==,
                    PW85_SUCCESS);
    g_assert_cmpint(pw85_gpu_contact_derivatives_pairs(stream.handle(), list, system, nullptr,
                                                       nullptr, nullptr, nullptr, force.get(),
                                                       nullptr, nullptr),
                    ==, PW85_SUCCESS);
    stream.wait();
    return {mu2.values(), force.values(), overlap.values()};
}

ListResults on_host(System const &s, ListCase const &c)
{
    std::size_t const n = System::num_pairs;
    ListResults made{std::vector<double>(n), std::vector<double>(3 * n),
                     std::vector<unsigned char>(n)};
    std::vector<double> lambda(n);
    auto const list = list_of(n, s.pairs.data(), c.images ? s.images.data() : nullptr);
    auto const system = system_of(System::num_particles, s.centers.data(), s.q.data(),
                                  c.cell ? s.cell : nullptr, c.open);
    pw85_contact_pairs(list, system, made.mu2.data(), lambda.data());
    pw85_overlap_pairs(list, system, made.overlaps.data());
    pw85_contact_derivatives_pairs(list, system, nullptr, nullptr, nullptr, nullptr,
                                   made.forces.data(), nullptr, nullptr);
    return made;
}

void test_lists(void const *data)
{
    auto const &list_case = *static_cast<ListCase const *>(data);
    Failures failures;
    Random random(702);
    System const s(random);
    auto const device = on_device(s, list_case), host = on_host(s, list_case);
    int overlapping = 0;
    for (std::size_t k = 0; k < System::num_pairs; ++k) {
        auto const describe = [&] { return "pair " + std::to_string(k); };
        overlapping += device.overlaps[k];
        failures.check(device.overlaps[k] == host.overlaps[k], "overlap", device.overlaps[k],
                       host.overlaps[k], describe);
        // cond is at most 2 + 2 (largest semi-axis)²/(smallest pivot of a blend): forms of aspect
        // 100, 1e5 is ample.
        failures.check(std::fabs(device.mu2[k] - host.mu2[k]) <= 8 * u * 1e5 * host.mu2[k], "mu2",
                       device.mu2[k], host.mu2[k], describe);
        double const *const x = &device.forces[3 * k], *const y = &host.forces[3 * k];
        double const size = std::fabs(y[0]) + std::fabs(y[1]) + std::fabs(y[2]);
        for (int d = 0; d < 3; ++d)
            failures.check(std::fabs(x[d] - y[d]) <= 1e-6 * size, "d_r12", x[d], y[d], describe);
    }
    g_test_message("%d of %zu overlap", overlapping, System::num_pairs);
    g_assert_cmpint(overlapping, >, 10);
}

// Marked, although the arrays have a good particle there.
void test_bad_indices()
{
    Random random(703);
    System s(random);
    std::size_t const particles = System::num_particles - 1;
    for (std::int32_t &i : s.pairs) i %= static_cast<std::int32_t>(particles);
    s.pairs[2 * 7] = static_cast<std::int32_t>(particles);
    s.pairs[2 * 9 + 1] = -1;
    std::size_t const n = 20;
    DeviceArray<double> const centers(s.centers), q(s.q), mu2(n), lambda(n);
    DeviceArray<std::int32_t> const pairs(s.pairs);
    DeviceArray<unsigned char> const overlap(n);
    Stream const stream;
    g_assert_cmpint(pw85_gpu_contact_pairs(stream.handle(), list_of(n, pairs.get()),
                                           system_of(particles, centers.get(), q.get(), nullptr),
                                           mu2.get(), lambda.get()),
                    ==, PW85_SUCCESS);
    g_assert_cmpint(pw85_gpu_overlap_pairs(stream.handle(), list_of(n, pairs.get()),
                                           system_of(particles, centers.get(), q.get(), nullptr),
                                           overlap.get()),
                    ==, PW85_SUCCESS);
    stream.wait();
    auto const mu2s = mu2.values(), lambdas = lambda.values();
    auto const overlaps = overlap.values();
    for (std::size_t k = 0; k < n; ++k) {
        bool const bad = k == 7 || k == 9;
        g_assert_true(std::isnan(mu2s[k]) == bad);
        g_assert_true(std::isnan(lambdas[k]) == bad);
        g_assert_true((overlaps[k] == 255) == bad);
    }
}

void test_arguments()
{
    Random random(704);
    DeviceColumns const in{Columns(mixed_pairs(random, 4))};
    DeviceArray<double> const out(4);
    DeviceArray<unsigned char> const overlap(4);
    DeviceArray<std::int32_t> const pairs(std::vector<std::int32_t>{0, 1});
    double const *const r12 = in.r12.get(), *const q1 = in.q1.get(), *const q2 = in.q2.get();
    double own[36] = {};
    double const singular[9] = {}, bad[9] = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, HUGE_VAL};
    auto const contact = [&](std::size_t n, double const *r, double *mu2, double *lambda) {
        return pw85_gpu_contact_batch(nullptr, n, r, q1, q2, mu2, lambda);
    };
    g_assert_cmpint(pw85_gpu_contact_batch(nullptr, 0, nullptr, nullptr, nullptr, nullptr, nullptr),
                    ==, PW85_SUCCESS);
    g_assert_cmpint(contact(4, nullptr, out.get(), nullptr), ==, PW85_EINVAL);
    g_assert_cmpint(contact(4, r12, nullptr, nullptr), ==, PW85_EINVAL);
    g_assert_cmpint(contact(SIZE_MAX, r12, out.get(), nullptr), ==, PW85_EINVAL);
    // Memory that is not the device's.
    g_assert_cmpint(contact(4, own, out.get(), nullptr), ==, PW85_EINVAL);
    g_assert_cmpint(contact(4, r12, out.get(), own), ==, PW85_EINVAL);
    g_assert_cmpint(
        pw85_gpu_overlap_batch(nullptr, 4, r12, q1, q2, reinterpret_cast<unsigned char *>(own)), ==,
        PW85_EINVAL);
    g_assert_cmpint(pw85_gpu_overlap_batch(nullptr, 4, r12, q1, nullptr, overlap.get()), ==,
                    PW85_EINVAL);
    auto const contact_pairs = [&](pw85_pair_list const *list, double const *cell) {
        return pw85_gpu_contact_pairs(nullptr, list, system_of(2, r12, q1, cell), out.get(),
                                      nullptr);
    };
    for (double const *cell : {singular, bad})
        g_assert_cmpint(contact_pairs(list_of(1, pairs.get()), cell), ==, PW85_EINVAL);
    // Images without a cell.
    g_assert_cmpint(contact_pairs(list_of(1, pairs.get(), pairs.get()), nullptr), ==, PW85_EINVAL);
    g_assert_cmpint(contact_pairs(list_of(1, nullptr), nullptr), ==, PW85_EINVAL);
    g_assert_cmpint(pw85_gpu_count(nullptr), ==, PW85_EINVAL);
    int count = 0;
    g_assert_cmpint(pw85_gpu_count(&count), ==, PW85_SUCCESS);
    g_assert_cmpint(count, >=, 1);
}

/// A function of pw85_gpu.h with its pointers, of which the last may be null, and a number of rows.
struct Function {
    char const *name;
    std::size_t num_required;
    std::vector<void *> pointers;
    int (*call)(std::size_t n, void *const *p);
};

template <class T = double> T *as(void *pointer) { return static_cast<T *>(pointer); }

/// Two rows of arrays of the device.
struct DeviceRows {
    DeviceColumns in;
    DeviceArray<double> out{6};
    DeviceArray<unsigned char> codes{2};
    DeviceArray<std::int32_t> pairs{std::vector<std::int32_t>{0, 1, 1, 0}};
};

std::vector<Function> batch_functions(DeviceRows const &rows)
{
    void *const r = rows.in.r12.get(), *const a = rows.in.q1.get(), *const b = rows.in.q2.get(),
                *const x = rows.out.get(), *const c = rows.codes.get();
    return {
        {"contact_batch",
         4,
         {r, a, b, x, x},
         [](std::size_t n, void *const *p) {
             return pw85_gpu_contact_batch(nullptr, n, as(p[0]), as(p[1]), as(p[2]), as(p[3]),
                                           as(p[4]));
         }},
        {"overlap_batch",
         4,
         {r, a, b, c},
         [](std::size_t n, void *const *p) {
             return pw85_gpu_overlap_batch(nullptr, n, as(p[0]), as(p[1]), as(p[2]),
                                           as<unsigned char>(p[3]));
         }},
        {"derivatives_batch",
         3,
         {r, a, b, x, x},
         [](std::size_t n, void *const *p) {
             return pw85_gpu_contact_derivatives_batch(nullptr, n, as(p[0]), as(p[1]), as(p[2]),
                                                       as(p[3]), nullptr, nullptr, nullptr,
                                                       as(p[4]), nullptr, nullptr);
         }},
    };
}

std::vector<Function> pairs_functions(DeviceRows const &rows)
{
    void *const r = rows.in.r12.get(), *const a = rows.in.q1.get(), *const list = rows.pairs.get(),
                *const x = rows.out.get(), *const c = rows.codes.get();
    return {
        {"contact_pairs",
         4,
         {list, r, a, x, x},
         [](std::size_t n, void *const *p) {
             return pw85_gpu_contact_pairs(nullptr, list_of(n, as<int>(p[0])),
                                           system_of(2, as(p[1]), as(p[2]), nullptr), as(p[3]),
                                           as(p[4]));
         }},
        {"overlap_pairs",
         4,
         {list, r, a, c},
         [](std::size_t n, void *const *p) {
             return pw85_gpu_overlap_pairs(nullptr, list_of(n, as<int>(p[0])),
                                           system_of(2, as(p[1]), as(p[2]), nullptr),
                                           as<unsigned char>(p[3]));
         }},
        {"derivatives_pairs",
         3,
         {list, r, a, x, x},
         [](std::size_t n, void *const *p) {
             return pw85_gpu_contact_derivatives_pairs(
                 nullptr, list_of(n, as<int>(p[0])), system_of(2, as(p[1]), as(p[2]), nullptr),
                 as(p[3]), nullptr, nullptr, as(p[4]), nullptr, nullptr, nullptr);
         }},
    };
}

std::vector<Function> host_functions(Columns &own)
{
    void *const r0 = own.r12.data(), *const a0 = own.q1.data(), *const b0 = own.q2.data();
    static double results[12];
    static unsigned char overlaps[2];
    return {
        {"contact_host",
         4,
         {r0, a0, b0, results, results + 2},
         [](std::size_t n, void *const *p) {
             return pw85_gpu_contact_host(n, as(p[0]), as(p[1]), as(p[2]), as(p[3]), as(p[4]));
         }},
        {"overlap_host",
         4,
         {r0, a0, b0, overlaps},
         [](std::size_t n, void *const *p) {
             return pw85_gpu_overlap_host(n, as(p[0]), as(p[1]), as(p[2]), as<unsigned char>(p[3]));
         }},
        {"derivatives_host",
         3,
         {r0, a0, b0, results, results + 2},
         [](std::size_t n, void *const *p) {
             return pw85_gpu_contact_derivatives_host(n, as(p[0]), as(p[1]), as(p[2]), as(p[3]),
                                                      nullptr, nullptr, nullptr, as(p[4]), nullptr,
                                                      nullptr);
         }},
    };
}

// Each function: nothing for no rows, whatever the pointers; no pointer that must be there may be
// null, any other may.
void test_null_pointers()
{
    Random random(708);
    Columns own(mixed_pairs(random, 2));
    DeviceRows const rows{DeviceColumns(own)};
    std::vector<Function> all = batch_functions(rows);
    for (auto const &functions : {pairs_functions(rows), host_functions(own)})
        all.insert(all.end(), functions.begin(), functions.end());
    for (Function const &f : all) {
        g_test_message("%s", f.name);
        std::vector<void *> const none(f.pointers.size(), nullptr);
        g_assert_cmpint(f.call(0, none.data()), ==, PW85_SUCCESS);
        g_assert_cmpint(f.call(0, f.pointers.data()), ==, PW85_SUCCESS);
        g_assert_cmpint(f.call(SIZE_MAX, f.pointers.data()), ==, PW85_EINVAL);
        int const expected = f.call(2, f.pointers.data());
        for (std::size_t k = 0; k < f.pointers.size(); ++k) {
            auto pointers = f.pointers;
            pointers[k] = nullptr;
            g_assert_cmpint(f.call(2, pointers.data()), ==,
                            k < f.num_required ? PW85_EINVAL : expected);
        }
    }
    device().synchronize(nullptr);
}

// Rows of results, each array wanted alone, and nothing behind them: also where blocks of threads
// are not full, or pairs are bad.
void test_outputs()
{
    Random random(709);
    for (std::size_t const n : {std::size_t{1}, std::size_t{127}, std::size_t{130}}) {
        auto const pairs = mixed_pairs(random, n);
        DeviceColumns const in{Columns(pairs)};
        std::size_t const widths[] = {1, 1, 3, 3, 3, 3, 3};
        std::vector<std::vector<double>> together;
        for (int alone = -1; alone < 7; ++alone) {
            std::vector<std::unique_ptr<DeviceArray<double>>> arrays;
            double *out[7];
            for (int k = 0; k < 7; ++k) {
                arrays.push_back(std::make_unique<DeviceArray<double>>(
                    std::vector<double>(widths[k] * n + 8, 0x1p-99)));
                out[k] = alone < 0 || alone == k ? arrays.back()->get() : nullptr;
            }
            g_assert_cmpint(pw85_gpu_contact_derivatives_batch(
                                nullptr, n, in.r12.get(), in.q1.get(), in.q2.get(), out[0], out[1],
                                out[2], out[3], out[4], out[5], out[6]),
                            ==, PW85_SUCCESS);
            device().synchronize(nullptr);
            for (std::size_t k = 0; k < 7; ++k) {
                auto const values = arrays[k]->values();
                for (std::size_t i = 0; i < values.size(); ++i)
                    g_assert_true((values[i] != 0x1p-99) ==
                                  (out[k] != nullptr && i < widths[k] * n));
                if (alone < 0)
                    together.push_back(values);
                else if (out[k] != nullptr)
                    g_assert_true(std::memcmp(values.data(), together[k].data(),
                                              values.size() * sizeof values[0]) == 0);
            }
        }
    }
}

// Pieces of 2^17 pairs, of which some are bad; two threads. The third piece of the contacts takes
// the memory of the first one; the others have two.
void test_host_arrays()
{
    Random random(705);
    auto pairs = mixed_pairs(random, 20000);
    std::size_t const n = (std::size_t{1} << 18) + 1000, few = n / 2 + 1000;
    for (std::size_t i = pairs.size(); i < n; ++i) pairs.push_back(pairs[i % 10000]);
    Columns const c(pairs);
    std::vector<double> host_mu2(n);
    std::vector<unsigned char> host_overlap(few);
    int const host_status =
        pw85_contact_batch(n, c.r12.data(), c.q1.data(), c.q2.data(), host_mu2.data(), nullptr);
    pw85_overlap_batch(few, c.r12.data(), c.q1.data(), c.q2.data(), host_overlap.data());
    auto const run = [&] {
        std::vector<double> mu2(n), lambda(n), d_r12(3 * few), d_rot2(3 * few);
        std::vector<unsigned char> overlap(few);
        g_assert_cmpint(pw85_gpu_contact_host(n, c.r12.data(), c.q1.data(), c.q2.data(), mu2.data(),
                                              lambda.data()),
                        ==, host_status);
        g_assert_cmpint(
            pw85_gpu_overlap_host(few, c.r12.data(), c.q1.data(), c.q2.data(), overlap.data()), ==,
            host_status);
        g_assert_cmpint(pw85_gpu_contact_derivatives_host(
                            few, c.r12.data(), c.q1.data(), c.q2.data(), nullptr, nullptr, nullptr,
                            nullptr, d_r12.data(), nullptr, d_rot2.data()),
                        ==, host_status);
        for (std::size_t i = 0; i < n; ++i) {
            bool const is_bad = std::isnan(host_mu2[i]);
            g_assert_true(std::isnan(mu2[i]) == is_bad && std::isnan(lambda[i]) == is_bad);
            // Rounding may leave these pairs few digits: the same pair in both places, not more.
            g_assert_true(is_bad || std::fabs(mu2[i] - host_mu2[i]) <= 1e-2 * host_mu2[i]);
            if (i >= few) continue;
            g_assert_cmpint(overlap[i], ==, host_overlap[i]);
            g_assert_true(std::isnan(d_r12[3 * i + 1]) == is_bad);
        }
    };
    std::thread other(run);
    run();
    other.join();
}

// Calls return while the device does nothing: the results come later, those of the host's tests,
// too.
void test_no_waiting()
{
    auto const hold =
        reinterpret_cast<void (*)(int)>(dlsym(dlopen("libcuda.so.1", RTLD_NOW), "fake_hold"));
    if (hold == nullptr) return g_test_skip("only the fake driver can be held");
    Random random(706);
    auto const pairs = mixed_pairs(random, 3000);
    std::size_t const n = pairs.size();
    DeviceColumns const in{Columns(pairs)};
    std::vector<unsigned char> const before(n, 77);
    DeviceArray<double> const mu2[] = {DeviceArray<double>(n), DeviceArray<double>(n)};
    DeviceArray<unsigned char> const overlap[] = {DeviceArray<unsigned char>(before),
                                                  DeviceArray<unsigned char>(before)};
    Stream const streams[2];
    hold(1);
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 2; ++k) {
            void *const stream = streams[k].handle();
            g_assert_cmpint(pw85_gpu_overlap_batch(stream, n, in.r12.get(), in.q1.get(),
                                                   in.q2.get(), overlap[k].get()),
                            ==, PW85_SUCCESS);
            g_assert_cmpint(pw85_gpu_contact_batch(stream, n, in.r12.get(), in.q1.get(),
                                                   in.q2.get(), mu2[k].get(), nullptr),
                            ==, PW85_SUCCESS);
        }
    // Held, and so not written to by another thread.
    for (auto const &array : overlap)
        g_assert_true(std::equal(before.begin(), before.end(), array.get()));
    hold(0);
    auto const host = run_batch(pairs);
    for (int k = 0; k < 2; ++k) {
        streams[k].wait();
        g_assert_true(overlap[k].values() == host.overlap);
    }
}

// What calls allocate goes back; mailboxes stay for later calls, and are not one for each.
void test_memory()
{
    auto const blocks =
        reinterpret_cast<std::size_t (*)()>(dlsym(dlopen("libcuda.so.1", RTLD_NOW), "fake_blocks"));
    if (blocks == nullptr) return g_test_skip("only the fake driver can say");
    Random random(707);
    auto const pairs = mixed_pairs(random, 1000);
    run_on_device(pairs);
    std::size_t const before = blocks();
    for (int i = 0; i < 10; ++i) run_on_device(pairs);
    // Two calls are under way at once where the first has not left its mailbox yet.
    g_assert_cmpuint(blocks(), <=, before + 1);
}

constexpr ListCase list_cases[] = {{false, false, false},
                                   {true, false, false},
                                   {true, true, false},
                                   {true, false, true},
                                   {true, true, true}};

} // namespace

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, nullptr);
    pw85::detail::gpu::Context const context(pw85::detail::gpu::driver());
    g_test_add_func("/gpu/host_arrays", test_host_arrays); // one of its threads has no context
    g_test_add_func("/gpu/problems", test_problems);
    g_test_add_func("/gpu/like_host", test_like_host);
    g_test_add_func("/gpu/derivatives", test_derivatives);
    g_test_add_data_func("/gpu/lists/without_cell", &list_cases[0], test_lists);
    g_test_add_data_func("/gpu/lists/nearest", &list_cases[1], test_lists);
    g_test_add_data_func("/gpu/lists/images", &list_cases[2], test_lists);
    g_test_add_data_func("/gpu/lists/open/nearest", &list_cases[3], test_lists);
    g_test_add_data_func("/gpu/lists/open/images", &list_cases[4], test_lists);
    g_test_add_func("/gpu/lists/bad_indices", test_bad_indices);
    g_test_add_func("/gpu/arguments", test_arguments);
    g_test_add_func("/gpu/null_pointers", test_null_pointers);
    g_test_add_func("/gpu/outputs", test_outputs);
    g_test_add_func("/gpu/no_waiting", test_no_waiting);
    g_test_add_func("/gpu/memory", test_memory);
    return g_test_run();
}
