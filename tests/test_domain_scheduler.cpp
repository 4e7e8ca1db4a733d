// SPDX-License-Identifier: BSD-3-Clause
// The order in which threads work on the domains of a sweep: each is finished once, none while one
// next to it is worked on, and all that are next to it and come first are finished before. Of
// domains that are next to each other, the order is that of their colours.
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <memory>
#include <numeric>
#include <vector>

#include <glib.h>

#include "../src/simulation/domain_scheduler.hpp"
#include "cases.hpp"
#include "threads.hpp"

using namespace pw85::detail;
using namespace pw85::detail::simulation;

namespace {

/// By how many parts two domains are apart, along the vector along which they are farthest apart.
int distance(Domains const &domains, Label a, Label b)
{
    int farthest = 0;
    for (int k = 0; k < 3; ++k) {
        int const n = static_cast<int>(domains.num_parts(k));
        int const apart = std::abs(static_cast<int>(a.part(k)) - static_cast<int>(b.part(k)));
        farthest = std::max(farthest, std::min(apart, n - apart));
    }
    return farthest;
}

/// What threads have seen. A domain is known by its position in the order.
class Log {
  public:
    Log(Domains const &domains, DomainScheduler const &scheduler)
        : size_(scheduler.size()), states_(new std::atomic<int>[scheduler.size()]),
          near_(scheduler.size())
    {
        for (std::size_t p = 0; p < size_; ++p) {
            states_[p] = waiting;
            for (std::size_t q = 0; q < size_; ++q)
                if (q != p && distance(domains, scheduler.domain(p), scheduler.domain(q)) <= 1)
                    near_[p].push_back(q);
        }
    }

    /// Works on a domain for some time, and finishes it or not.
    bool work(std::size_t p, bool finish)
    {
        if (states_[p].exchange(running) != waiting) fail("worked on twice", p, p);
        check(p);
        for (int k = 0; k < static_cast<int>(p * 2654435761u % 4096u); ++k) states_[p].load();
        check(p);
        states_[p] = finish ? finished : stopped;
        return finish;
    }

    /// Before the work goes on.
    void restart()
    {
        for (std::size_t p = 0; p < size_; ++p)
            if (states_[p] == stopped) states_[p] = waiting;
    }

    std::size_t count_finished() const
    {
        std::size_t count = 0;
        for (std::size_t p = 0; p < size_; ++p) count += states_[p] == finished;
        return count;
    }

    bool failed() const { return failed_; }

    std::vector<std::size_t> const &near(std::size_t p) const { return near_[p]; }

  private:
    enum State { waiting, running, stopped, finished };

    void check(std::size_t p)
    {
        for (std::size_t const q : near_[p]) {
            int const state = states_[q];
            if (q < p ? state != finished : state != waiting) fail("out of turn", p, q);
        }
    }

    void fail(char const *what, std::size_t p, std::size_t q)
    {
        if (!failed_.exchange(true)) g_test_message("%s: %zu beside %zu", what, p, q);
    }

    std::size_t size_;
    std::unique_ptr<std::atomic<int>[]> states_;
    std::vector<std::vector<std::size_t>> near_;
    std::atomic<bool> failed_{false};
};

/// By the parities of its parts.
unsigned color_of(Label label)
{
    unsigned color = 0;
    for (int k = 0; k < 3; ++k) color = 2 * color + label.part(k) % 2;
    return color;
}

/// All domains of a colour come before, or after, those of another colour that are next to them. No
/// colours go round in a circle.
void check_colors(DomainScheduler const &scheduler, Log const &log)
{
    std::array<std::array<bool, 8>, 8> before{};
    for (std::size_t p = 0; p < scheduler.size(); ++p)
        for (std::size_t const q : log.near(p))
            before[color_of(scheduler.domain(std::min(p, q)))]
                  [color_of(scheduler.domain(std::max(p, q)))] = true;
    std::array<std::ptrdiff_t, 8> ranks;
    for (std::size_t a = 0; a < 8; ++a) {
        ranks[a] = std::count(before[a].begin(), before[a].end(), true);
        for (std::size_t b = 0; b < 8; ++b) g_assert_false(before[a][b] && before[b][a]);
    }
    for (std::size_t a = 0; a < 8; ++a)
        for (std::size_t b = 0; b < 8; ++b) g_assert_true(!before[a][b] || ranks[a] > ranks[b]);
}

/// Particles at random in a cell that is periodic along some directions.
Configuration particles_in(double x, double y, double z, std::array<int, 3> periodic)
{
    Configuration configuration;
    constexpr std::size_t n = 20000;
    g_assert_true(configuration.resize(n));
    configuration.cell = {
        {x, 0, 0, 0, y, 0, 0, 0, z}, {periodic[0], periodic[1], periodic[2]}, true};
    Stream stream(3, 0, 0);
    for (std::size_t k = 0; k < n; ++k)
        configuration.centers[k] = {x * stream.uniform(), y * stream.uniform(),
                                    z * stream.uniform()};
    return configuration;
}

/// A domain is often next to the one before it in the order, and mostly next but one. Colour by
/// colour none would be next to it.
void check_distances(Domains const &domains, DomainScheduler const &scheduler)
{
    std::size_t next = 0, near = 0;
    for (std::size_t p = 1; p < scheduler.size(); ++p) {
        int const apart = distance(domains, scheduler.domain(p - 1), scheduler.domain(p));
        next += apart <= 1;
        near += apart <= 2;
    }
    g_test_message("%zu domains: %zu are next to the one before, %zu near it", scheduler.size(),
                   next, near);
    g_assert_cmpuint(5 * next, >, 2 * scheduler.size());
    g_assert_cmpuint(3 * near, >, 2 * scheduler.size());
}

void run(Configuration const &configuration, std::size_t least_domains, std::uint64_t seed)
{
    std::vector<std::int32_t> places(configuration.size());
    std::iota(places.begin(), places.end(), 0);
    Stream stream(seed, 0, 0);
    Domains domains;
    DomainScheduler scheduler;
    g_assert_cmpint(domains.prepare(configuration, places, 1.0, stream), ==, PW85_SUCCESS);
    g_assert_true(scheduler.prepare(domains, stream));
    g_assert_cmpuint(scheduler.size(), >=, least_domains);
    Log log(domains, scheduler);
    check_colors(scheduler, log);
    if (scheduler.size() >= 64) check_distances(domains, scheduler);
    std::vector<int> stops(scheduler.size());
    for (std::size_t p = 0; p < scheduler.size(); ++p) stops[p] = p * 40503u % 16u == 0 ? 2 : 0;
    int calls = 1;
    for (; !scheduler.for_all(domains, [&](std::size_t p) { return log.work(p, stops[p]-- <= 0); });
         ++calls)
        log.restart();
    if (log.failed())
        g_test_fail_printf("%zu domains, seed %d", scheduler.size(), static_cast<int>(seed));
    g_assert_cmpuint(log.count_finished(), ==, scheduler.size());
    g_assert_cmpint(calls, >=, 3); // some stopped twice
}

PW85_TEST("/domain_scheduler/order")
{
    for (int n = 1; n <= 4; ++n) {
        pw85_tests::Threads const used(n);
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            run(particles_in(8.5, 6.5, 10.5, {1, 1, 1}), 8 * 6 * 8, seed);
            run(particles_in(8.5, 2.5, 3.0, {1, 1, 0}), 8 * 2, seed);
            run(particles_in(1.5, 1.5, 1.5, {1, 1, 1}), 1, seed);
        }
    }
}

// Particles do not leave their domains in a sweep. So they could never pass a border that is always
// at the same place. Each tenth of a part has the border for a tenth of the seeds.
PW85_TEST("/domain_scheduler/borders")
{
    constexpr int seeds = 200;
    constexpr std::size_t tenths = 10;
    Configuration const configuration = particles_in(8.5, 6.5, 10.5, {1, 1, 1});
    std::vector<std::int32_t> places(configuration.size());
    std::iota(places.begin(), places.end(), 0);
    std::array<std::array<int, tenths>, 3> counts{};
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        Stream stream(seed, 0, 0);
        Domains domains;
        g_assert_cmpint(domains.prepare(configuration, places, 1.0, stream), ==, PW85_SUCCESS);
        for (int d = 0; d < 3; ++d)
            for (std::size_t k = 0; k < tenths; ++k) {
                Vector3 from{}, to{};
                double const tenth =
                    configuration.cell.vectors[4 * d] / (10.0 * domains.num_parts(d));
                from[d] = static_cast<double>(k) * tenth;
                to[d] = static_cast<double>(k + 1) * tenth;
                counts[static_cast<std::size_t>(d)][k] +=
                    domains.label_of(from) != domains.label_of(to);
            }
    }
    double const mean = seeds / 10.0;
    for (auto const &of_vector : counts)
        for (int const count : of_vector)
            if (std::abs(count - mean) > 5.0 * std::sqrt(mean))
                g_test_fail_printf("%d borders", count);
}

} // namespace
