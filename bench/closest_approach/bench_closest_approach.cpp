// Time of one distance of closest approach: through the contact function, by the algorithms of Zheng et al. as the
// library has them, and by their method as published. The argument is the aspect ratio; the time is that of one pair.
#include <benchmark/benchmark.h>

#include <pw85_zheng.h>

#include "random_cases.hpp"

using namespace pw85_bench;

namespace {

constexpr int pairs = 1024;

template <class Case, class Distance>
void run(benchmark::State &state, std::vector<Case> const &cases, Distance distance)
{
    std::size_t i = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(distance(cases[i]));
        i = (i + 1) % cases.size();
    }
}

std::vector<EllipseCase> ellipse_cases(benchmark::State const &state)
{
    return RandomCases().ellipses(pairs, static_cast<double>(state.range(0)));
}

std::vector<EllipsoidCase> ellipsoid_cases(benchmark::State const &state)
{
    return RandomCases().ellipsoids(pairs, static_cast<double>(state.range(0)));
}

template <class Function, class Case> double call(Function function, Case const &c)
{
    double distance;
    function(c.direction.coordinates, c.q1.entries, c.q2.entries, &distance);
    return distance;
}

void closest_approach_2d(benchmark::State &state)
{
    run(state, ellipse_cases(state), [](EllipseCase const &c) { return call(pw85_closest_approach_2d, c); });
}

void zheng_ellipses(benchmark::State &state)
{
    run(state, ellipse_cases(state), [](EllipseCase const &c) { return call(pw85_zheng_ellipses, c); });
}

void closest_approach(benchmark::State &state)
{
    run(state, ellipsoid_cases(state), [](EllipsoidCase const &c) { return call(pw85_closest_approach, c); });
}

void zheng_ellipsoids(benchmark::State &state)
{
    run(state, ellipsoid_cases(state), [](EllipsoidCase const &c) { return call(pw85_zheng_ellipsoids, c); });
}

void published_ellipses(benchmark::State &state)
{
    run(state, ellipse_cases(state), [](EllipseCase const &c) { return published::ellipses(c.ellipse1, c.ellipse2); });
}

void published_ellipsoids(benchmark::State &state)
{
    run(state, ellipsoid_cases(state),
        [](EllipsoidCase const &c) { return published::ellipsoids(c.ellipsoid1, c.ellipsoid2, c.direction); });
}

void aspects(benchmark::internal::Benchmark *b) { b->ArgName("aspect")->Arg(1)->Arg(4)->Arg(100)->Arg(10000); }

BENCHMARK(closest_approach_2d)->Apply(aspects);
BENCHMARK(zheng_ellipses)->Apply(aspects);
BENCHMARK(published_ellipses)->Apply(aspects);
BENCHMARK(closest_approach)->Apply(aspects);
BENCHMARK(zheng_ellipsoids)->Apply(aspects);
BENCHMARK(published_ellipsoids)->Apply(aspects);

} // namespace

BENCHMARK_MAIN();
