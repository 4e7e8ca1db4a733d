// SPDX-License-Identifier: BSD-3-Clause
// Measures the functions of pw85_gpu.h, and compares overlaps with those of the host. It needs a
// device, or the driver of the tests. measure.py makes a table of what it prints.
//
// The rows are `function,arrays,pairs,aspect,tangent,rate`: where the arrays are, of the device or
// of the host; the pairs of a call; the aspect ratio; the pairs that are tangent to rounding, which
// the host decides, in a million; and millions of pairs in a second, the best of five calls. For
// arrays of the host there are also the functions of pw85.h, with all threads. Usage: gpu [PAIRS
// [COMPARED]], or gpu context, which prints what measure.py says of the program
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <thread>
#include <vector>

#include <pw85_batch.h>
#include <pw85_gpu.h>

#include "gpu/device.hpp"
#include "random_pairs.hpp"
#include "systems.hpp"

using namespace pw85_tests;

namespace {

constexpr std::size_t block = std::size_t{1} << 18; // pairs that differ; the arrays repeat them

struct Block {
    std::vector<double> r12, q1, q2;
};

/// General ellipsoids, half of which overlap; so many in a million are tangent to rounding.
Block random_block(Random &random, double aspect, int tangent)
{
    Block b;
    for (std::size_t i = 0; i < block; ++i) {
        bool const touches = random.uniform(0.0, 1e6) < tangent;
        double const mu2 = touches ? 1.0 : random.log_uniform(0.1, 10.0);
        auto const p = random_pair<3>(
            random, {.aspect = aspect, .mu2_min = mu2, .mu2_max = mu2, .aspect_min = aspect});
        b.r12.insert(b.r12.end(), p.r12.coordinates, p.r12.coordinates + 3);
        b.q1.insert(b.q1.end(), p.q1.entries, p.q1.entries + 6);
        b.q2.insert(b.q2.end(), p.q2.entries, p.q2.entries + 6);
    }
    return b;
}

std::vector<double> repeated(std::vector<double> const &values, std::size_t size)
{
    std::vector<double> all(size);
    for (std::size_t i = 0; i < size; ++i) all[i] = values[i % values.size()];
    return all;
}

/// The shortest time of five calls in seconds.
template <class Call> double seconds(Call call)
{
    double shortest = 1e300;
    for (int i = 0; i < 6; ++i) { // the first call loads the program
        auto const start = std::chrono::steady_clock::now();
        g_assert_cmpint(call(), ==, PW85_SUCCESS);
        std::chrono::duration<double> const time = std::chrono::steady_clock::now() - start;
        if (i > 0 && time.count() < shortest) shortest = time.count();
    }
    return shortest;
}

/// One row of the table.
struct Row {
    char const *arrays;
    double aspect;
    int tangent;

    void print(char const *function, std::size_t pairs, double time) const
    {
        std::printf("%s,%s,%zu,%g,%d,%.3g\n", function, arrays, pairs, aspect, tangent,
                    1e-6 * static_cast<double>(pairs) / time);
        std::fflush(stdout);
    }

    /// With a stream, which is waited for.
    template <class Call> void measure(char const *function, std::size_t pairs, Call call) const
    {
        Stream const stream;
        print(function, pairs, seconds([&] {
                  int const status = call(stream.handle());
                  stream.wait();
                  return status;
              }));
    }
};

void measure_device(std::size_t n, double aspect, int tangent)
{
    Random random(900);
    Block const b = random_block(random, aspect, tangent);
    DeviceArray<double> const r12(repeated(b.r12, 3 * n)), q1(repeated(b.q1, 6 * n)),
        q2(repeated(b.q2, 6 * n));
    DeviceArray<double> const mu2(n), lambda(n), point(3 * n), normal(3 * n), d_r12(3 * n),
        d_rot1(3 * n), d_rot2(3 * n);
    DeviceArray<unsigned char> const overlap(n);
    Row const row{"device", aspect, tangent};
    row.measure("overlap_batch", n, [&](void *stream) {
        return pw85_gpu_overlap_batch(stream, n, r12.get(), q1.get(), q2.get(), overlap.get());
    });
    if (tangent > 0) return; // the others do not ask the host
    row.measure("contact_batch", n, [&](void *stream) {
        return pw85_gpu_contact_batch(stream, n, r12.get(), q1.get(), q2.get(), mu2.get(),
                                      lambda.get());
    });
    row.measure("contact_derivatives_batch", n, [&](void *stream) {
        return pw85_gpu_contact_derivatives_batch(
            stream, n, r12.get(), q1.get(), q2.get(), mu2.get(), lambda.get(), point.get(),
            normal.get(), d_r12.get(), d_rot1.get(), d_rot2.get());
    });
}

void measure_host(std::size_t n, double aspect)
{
    Random random(902);
    Block const b = random_block(random, aspect, 0);
    auto const r12 = repeated(b.r12, 3 * n), q1 = repeated(b.q1, 6 * n), q2 = repeated(b.q2, 6 * n);
    std::vector<double> mu2(n), lambda(n);
    std::vector<unsigned char> overlap(n);
    Row const row{"host", aspect, 0};
    row.print("contact_host", n, seconds([&] {
                  return pw85_gpu_contact_host(n, r12.data(), q1.data(), q2.data(), mu2.data(),
                                               lambda.data());
              }));
    row.print("overlap_host", n, seconds([&] {
                  return pw85_gpu_overlap_host(n, r12.data(), q1.data(), q2.data(), overlap.data());
              }));
    row.print("pw85_contact_batch", n, seconds([&] {
                  return pw85_contact_batch(n, r12.data(), q1.data(), q2.data(), mu2.data(),
                                            lambda.data());
              }));
    row.print("pw85_overlap_batch", n, seconds([&] {
                  return pw85_overlap_batch(n, r12.data(), q1.data(), q2.data(), overlap.data());
              }));
}

/// A list with twenty neighbours of each particle.
void measure_lists(std::size_t particles, double aspect)
{
    Random random(901);
    Block const b = random_block(random, aspect, 0);
    std::vector<std::int32_t> list;
    for (std::size_t i = 0; i < particles; ++i)
        for (std::size_t k = 1; k <= 20; ++k) {
            list.push_back(static_cast<std::int32_t>(i));
            list.push_back(static_cast<std::int32_t>((i + k * k) % particles));
        }
    std::size_t const n = list.size() / 2;
    DeviceArray<double> const centers(repeated(b.r12, 3 * particles)),
        q(repeated(b.q1, 6 * particles)), mu2(n), lambda(n);
    DeviceArray<std::int32_t> const pairs(list);
    DeviceArray<unsigned char> const overlap(n);
    double const cell[9] = {50.0, 0.0, 0.0, 0.0, 50.0, 0.0, 0.0, 0.0, 50.0};
    Row const row{"device", aspect, 0};
    row.measure("contact_pairs", n, [&](void *stream) {
        return pw85_gpu_contact_pairs(stream, list_of(n, pairs.get()),
                                      system_of(particles, centers.get(), q.get(), cell), mu2.get(),
                                      lambda.get());
    });
    row.measure("overlap_pairs", n, [&](void *stream) {
        return pw85_gpu_overlap_pairs(stream, list_of(n, pairs.get()),
                                      system_of(particles, centers.get(), q.get(), cell),
                                      overlap.get());
    });
}

/// Computes overlaps on the device and on the host, and counts those that differ.
std::size_t compare(std::size_t pairs)
{
    std::size_t different = 0, compared = 0;
    for (std::uint64_t seed = 0; compared < pairs; ++seed) {
        Random random(1000 + seed);
        Block const b = random_block(random,
                                     seed % 3 == 0   ? 2.0
                                     : seed % 3 == 1 ? 100.0
                                                     : 1e4,
                                     100'000);
        std::vector<unsigned char> host(block), device(block);
        pw85_overlap_batch(block, b.r12.data(), b.q1.data(), b.q2.data(), host.data());
        g_assert_cmpint(
            pw85_gpu_overlap_host(block, b.r12.data(), b.q1.data(), b.q2.data(), device.data()), ==,
            PW85_SUCCESS);
        for (std::size_t i = 0; i < block; ++i) different += host[i] != device[i];
        compared += block;
    }
    std::fprintf(stderr,
                 "%zu overlaps compared with the host's, a tenth of them tangent: %zu different\n",
                 compared, different);
    return different;
}

std::size_t argument(int argc, char **argv, int k, std::size_t otherwise)
{
    return argc > k ? static_cast<std::size_t>(std::strtod(argv[k], nullptr)) : otherwise;
}

} // namespace

int main(int argc, char **argv)
{
    std::size_t const n = argument(argc, argv, 1, 20'000'000),
                      compared = argument(argc, argv, 2, 10'000'000);
    if (argc == 2 && std::strcmp(argv[1], "context") == 0) {
        std::printf("{\"pw85\": \"%s\", \"compiler\": \"" PW85_BENCH_COMPILER
                    "\", \"num_cpus\": %u}\n",
                    pw85_version(), std::thread::hardware_concurrency());
        return 0;
    }
    pw85::detail::gpu::Context const context(pw85::detail::gpu::driver());
    if (context.handle() == nullptr) {
        std::fprintf(stderr, "%s\n", pw85_strerror(PW85_EDEVICE));
        return 1;
    }
    std::puts("function,arrays,pairs,aspect,tangent,rate");
    for (double const aspect : {2.0, 10.0, 100.0}) measure_device(n, aspect, 0);
    for (int const tangent : {10, 1000, 100'000}) measure_device(n / 10 + 20, 10.0, tangent);
    for (std::size_t const few : {1u, 1000u, 100'000u}) measure_device(few, 10.0, 0);
    measure_lists(n / 100 + 20, 10.0);
    measure_host(n / 4 + 20, 10.0);
    return compare(compared) != 0;
}
