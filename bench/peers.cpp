// SPDX-License-Identifier: BSD-3-Clause
// Compares FCL with this library on the same pairs: the overlap test and the distance. measure.py
// runs it.
//
// Half of the pairs overlap, with the given |μ² - 1|; the distances are those of the other half.
// Times are in nanoseconds, the least of several passes over a block. Wrong and failed results are
// in per cent. Errors are absolute, where the largest semi-axis of the first ellipsoid is 1. The
// rounding errors of the principal axes (principal_axes.hpp) are far below them.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <limits>

#include <pw85.h>

#include "fcl_bodies.hpp"
#include "least_time.hpp"
#include "pairs.hpp"

using namespace pw85_bench;

namespace {

/// The distance by FCL; NaN if FCL throws an exception.
double fcl_distance(Bodies const &b, fcl::GJKSolverType solver)
{
    fcl::DistanceRequestd request;
    request.gjk_solver_type = solver;
    fcl::DistanceResultd result;
    try {
        return fcl::distance(&b.first.shape, b.first.place, &b.second.shape, b.second.place,
                             request, result);
    } catch (std::exception const &) {
        return std::numeric_limits<double>::quiet_NaN();
    }
}

bool overlap(Pair const &x)
{
    int result = 0;
    pw85_overlap(x.r12.coordinates, x.q1.entries, x.q2.entries, &result);
    return result == 1;
}

double distance(Pair const &x)
{
    double result = 0.0;
    pw85_distance(x.r12.coordinates, x.q1.entries, x.q2.entries, &result, nullptr, nullptr);
    return result;
}

/// Nanoseconds per item. The results are stored, so that the compiler cannot remove the calls.
template <class Items, class Call> double time_of(Items const &items, Call call)
{
    double volatile sink = 0.0;
    double const time = least_time(items.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) sink = static_cast<double>(call(items[i]));
    });
    static_cast<void>(sink);
    return time;
}

struct Solver {
    char const *name;
    fcl::GJKSolverType type;
};

void compare(std::vector<Pair> const &pairs, std::vector<Bodies> const &bodies,
             Solver const &solver)
{
    std::vector<Pair> apart;
    std::vector<Bodies> bodies_apart;
    int wrong = 0, failed = 0;
    double largest = 0.0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        bool const overlaps = overlap(pairs[i]);
        if (fcl_collide(bodies[i], solver.type) != overlaps) ++wrong;
        if (overlaps) continue;
        apart.push_back(pairs[i]);
        bodies_apart.push_back(bodies[i]);
        double const found = fcl_distance(bodies[i], solver.type);
        if (!(found >= 0.0)) // FCL returns -1 for pairs that it considers as overlapping
            ++failed;
        else
            largest = std::max(largest, std::abs(found - distance(pairs[i])));
    }
    auto const fcl_collides = [&](Bodies const &b) { return fcl_collide(b, solver.type); };
    auto const fcl_distances = [&](Bodies const &b) { return fcl_distance(b, solver.type); };
    std::printf("%s,%.0f,%.0f,%.3g,%.0f,%.0f,%.3g,%.1e\n", solver.name, time_of(pairs, overlap),
                time_of(bodies, fcl_collides), 100.0 * wrong / static_cast<double>(pairs.size()),
                time_of(apart, distance), time_of(bodies_apart, fcl_distances),
                100.0 * failed / static_cast<double>(apart.size()), largest);
}

} // namespace

int main()
{
    std::printf(
        "aspect,excess,solver,overlap,overlap_fcl,wrong,distance,distance_fcl,failed,error\n");
    for (double const aspect : {2.0, 10.0, 100.0})
        for (double const excess : {0.5, 1e-2, 1e-4, 1e-6}) {
            auto const pairs = random_block(aspect, excess, 1000);
            std::vector<Bodies> bodies;
            for (Pair const &x : pairs)
                bodies.emplace_back(x.r12.coordinates, x.q1.entries, x.q2.entries);
            for (Solver const solver :
                 {Solver{"libccd", fcl::GST_LIBCCD}, Solver{"indep", fcl::GST_INDEP}}) {
                std::printf("%g,%g,", aspect, excess);
                compare(pairs, bodies, solver);
            }
        }
    return 0;
}
