// SPDX-License-Identifier: BSD-3-Clause
// Prints the errors of signed distances against 50 digits, of this library and of FCL, as CSV.
// measure.py runs it.
//
// The bodies are those on which Drake measures its proximity queries: sizes from 2 mm to 20 cm, in
// metres. Here each semi-axis is log-uniform in this range. The pairs have a random normal and the
// given signed distance, up to the rounding of their data; the truth is for the data as rounded.
// Pairs whose depth along this normal is not the least one are drawn again. Errors are in metres,
// times in nanoseconds. Wrong signs and failures of FCL are in per cent. FCL runs as Drake runs it:
// libccd with signed distances. FCL as Debian builds it ends the process for some pairs, by an
// assertion. So it runs in child processes, and these count as failed.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <limits>
#include <vector>

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <pw85.h>

#include <random_pairs.hpp>
#include <stationary_width.hpp>

#include "fcl_bodies.hpp"
#include "least_time.hpp"

using namespace pw85_tests;

namespace {

constexpr int pairs_of_each_kind = 1000;

struct Case {
    Sample<double, 3> pair;
    Wide truth;
};

double signed_distance(Sample<double, 3> const &s)
{
    double d = 0.0;
    pw85_signed_distance(s.r12.coordinates, s.q1.entries, s.q2.entries, &d, nullptr, nullptr);
    return d;
}

/// Two random ellipsoids at a signed distance.
Sample<double, 3> draw_pair(Random &random, double distance)
{
    auto const form = [&] {
        auto const axis = [&] { return random.log_uniform(0.002, 0.2); };
        return pw85::ellipsoid_quaternion<double>({axis(), axis(), axis()}, random.direction<4>())
            .q;
    };
    Sample<double, 3> s{{}, form(), form()};
    auto const n = random.direction<3>();
    s.r12 =
        pw85::detail::support(s.q1, n).point + pw85::detail::support(s.q2, n).point + distance * n;
    return s;
}

std::vector<Case> draw_cases(Random &random, double distance)
{
    std::vector<Case> cases;
    while (cases.size() < pairs_of_each_kind) {
        auto const s = draw_pair(random, distance);
        pw85::Vector<double, 3> normal;
        if (pw85_signed_distance_derivatives(s.r12.coordinates, s.q1.entries, s.q2.entries,
                                             normal.coordinates, nullptr, nullptr,
                                             nullptr) != PW85_SUCCESS)
            continue;
        auto const found = stationary_width(convert<Wide>(s), convert<Wide>(normal));
        double const width = static_cast<double>(found.width);
        if (found.residual <= Wide("1e-20") && std::fabs(width - distance) <= 1e-6 * 0.002)
            cases.push_back({s, found.width});
    }
    return cases;
}

/// The signed distance by FCL; NaN if FCL throws an exception.
double fcl_signed_distance(pw85_bench::Bodies const &b)
{
    fcl::DistanceRequestd request(true, true);
    request.gjk_solver_type = fcl::GST_LIBCCD;
    request.distance_tolerance = 1e-6;
    fcl::DistanceResultd result;
    try {
        return fcl::distance(&b.first.shape, b.first.place, &b.second.shape, b.second.place,
                             request, result);
    } catch (std::exception const &) {
        return std::numeric_limits<double>::quiet_NaN();
    }
}

/// The signed distances of all bodies by FCL; NaN where FCL throws an exception or ends the
/// process. A child writes its results to shared memory; the next child goes on behind the pair at
/// which one ended.
std::vector<double> fcl_signed_distances(std::vector<pw85_bench::Bodies> const &bodies)
{
    std::size_t const n = bodies.size(), bytes = (n + 1) * sizeof(double);
    auto *const shared = static_cast<double *>(
        mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
    double volatile &next = shared[n];
    std::fill_n(shared, n, std::numeric_limits<double>::quiet_NaN());
    while (next < static_cast<double>(n)) {
        if (fork() == 0) {
            // no text of the assertion
            if (std::freopen("/dev/null", "w", stderr) == nullptr) _exit(1);
            while (next < static_cast<double>(n)) {
                auto const i = static_cast<std::size_t>(next);
                next = next + 1.0;
                shared[i] = fcl_signed_distance(bodies[i]);
            }
            _exit(0);
        }
        wait(nullptr);
    }
    std::vector<double> const found(shared, shared + n);
    munmap(shared, bytes);
    return found;
}

struct Errors {
    std::vector<double> all;
    int failed = 0, wrong = 0;

    void add(double found, Wide const &truth)
    {
        if (std::isnan(found)) {
            ++failed;
            return;
        }
        double const exact = static_cast<double>(truth);
        if (std::fabs(exact) > 1e-15 && (found > 0.0) != (exact > 0.0)) ++wrong;
        all.push_back(std::fabs(static_cast<double>(Wide(found - truth))));
    }

    double median()
    {
        std::nth_element(all.begin(), all.begin() + static_cast<long>(all.size() / 2), all.end());
        return all[all.size() / 2];
    }
    double largest() const { return *std::max_element(all.begin(), all.end()); }
};

template <class Items, class Call> double time_of(Items const &items, Call call)
{
    double volatile sink = 0.0;
    double const time =
        pw85_bench::least_time(items.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) sink = call(items[i]);
        });
    static_cast<void>(sink);
    return time;
}

void compare(double distance)
{
    Random random(1560);
    auto const cases = draw_cases(random, distance);
    std::vector<pw85_bench::Bodies> bodies;
    for (Case const &c : cases)
        bodies.emplace_back(c.pair.r12.coordinates, c.pair.q1.entries, c.pair.q2.entries);
    auto const by_fcl = fcl_signed_distances(bodies);
    std::vector<pw85_bench::Bodies> answered;
    Errors ours, theirs;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        ours.add(signed_distance(cases[i].pair), cases[i].truth);
        theirs.add(by_fcl[i], cases[i].truth);
        if (!std::isnan(by_fcl[i])) answered.push_back(bodies[i]);
    }
    double const per_cent = 100.0 / pairs_of_each_kind;
    std::printf("%g,%.1e,%.1e,%.3g,%.0f,%.1e,%.1e,%.3g,%.3g,%.0f\n", 1000.0 * distance,
                ours.median(), ours.largest(), per_cent * (ours.wrong + ours.failed),
                time_of(cases, [](Case const &c) { return signed_distance(c.pair); }),
                theirs.median(), theirs.largest(), per_cent * theirs.wrong,
                per_cent * theirs.failed, time_of(answered, fcl_signed_distance));
}

} // namespace

int main()
{
    std::printf("millimetres,median,largest,wrong,time,median_fcl,largest_fcl,wrong_fcl,failed_fcl,"
                "time_fcl\n");
    for (double const distance : {-1e-3, -1e-5, -1e-9, 0.0, 1e-9, 1e-5, 1e-3, 0.1})
        compare(distance);
    return 0;
}
