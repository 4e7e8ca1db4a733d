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
#include <limits>
#include <vector>

#include <pw85.h>

#include "child_processes.hpp"
#include "fcl_bodies.hpp"
#include "least_time.hpp"
#include "signed_distance_cases.hpp"

using namespace pw85_bench;
using pw85_tests::Random;

namespace {

constexpr int pairs_of_each_kind = 1000;
constexpr Sizes sizes{0.002, 0.2};

double signed_distance(Case const &c)
{
    auto const &s = c.pair;
    double d = 0.0;
    pw85_signed_distance(s.r12.coordinates, s.q1.entries, s.q2.entries, &d, nullptr, nullptr);
    return d;
}

double distance_by_fcl(Bodies const &b)
{
    auto const found = fcl_signed_distance(b);
    return found ? found->min_distance : std::numeric_limits<double>::quiet_NaN();
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
    double const time = least_time(items.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) sink = call(items[i]);
    });
    static_cast<void>(sink);
    return time;
}

void compare(double distance)
{
    Random random(1560);
    auto const cases = draw_cases(random, sizes, distance, pairs_of_each_kind);
    std::vector<Bodies> bodies;
    for (Case const &c : cases)
        bodies.emplace_back(c.pair.r12.coordinates, c.pair.q1.entries, c.pair.q2.entries);
    auto const by_fcl = call_in_children(bodies.size(), std::numeric_limits<double>::quiet_NaN(),
                                         [&](std::size_t i) { return distance_by_fcl(bodies[i]); });
    std::vector<Bodies> answered;
    Errors ours, theirs;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        ours.add(signed_distance(cases[i]), cases[i].distance);
        theirs.add(by_fcl[i], cases[i].distance);
        if (!std::isnan(by_fcl[i])) answered.push_back(bodies[i]);
    }
    double const per_cent = 100.0 / pairs_of_each_kind;
    std::printf("%g,%.1e,%.1e,%.3g,%.0f,%.1e,%.1e,%.3g,%.3g,%.0f\n", 1000.0 * distance,
                ours.median(), ours.largest(), per_cent * (ours.wrong + ours.failed),
                time_of(cases, signed_distance), theirs.median(), theirs.largest(),
                per_cent * theirs.wrong, per_cent * theirs.failed,
                time_of(answered, distance_by_fcl));
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
