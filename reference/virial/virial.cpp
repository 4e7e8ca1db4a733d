// SPDX-License-Identifier: BSD-3-Clause
// Monte Carlo of a virial coefficient of hard ellipsoids: docs/reference/virial.rst has the method.
//
//     virial A B C ORDER SAMPLES SEED [FIRST]
//
// A, B and C are the semi-axes, ORDER is from 2 to 6. The samples have the numbers FIRST (0), FIRST
// + 1, ...; each of them has random numbers of its own, so that runs with the same seed and other
// numbers are independent, and the number of threads does not matter. Prints B_ORDER / B2^(ORDER-1)
// with its standard error, and B2 in units of the volume of an ellipsoid with its standard error.
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include "cluster.hpp"

namespace {

using namespace virial;

struct Task {
    Vector3 semi_axes;
    int order;
    std::uint64_t samples, seed, first;
};

/// What was found: how many samples are each graph, and how many ellipsoids were tried.
struct Counts {
    std::vector<std::uint64_t> graphs;
    std::uint64_t trials = 0;
};

struct Estimate {
    double value, error;
};

[[noreturn]] void refuse(char const *text, char const *name)
{
    throw std::invalid_argument(std::string(name) + " is not a valid number: " + text);
}

double real(char const *text, char const *name)
{
    char *end = nullptr;
    double const value = std::strtod(text, &end);
    if (end == text || *end != '\0') refuse(text, name);
    return value;
}

template <class T> T integer(char const *text, char const *name)
{
    T value{};
    auto const [end, error] = std::from_chars(text, text + std::strlen(text), value);
    if (error != std::errc{} || *end != '\0') refuse(text, name);
    return value;
}

void require(bool condition, char const *text)
{
    if (!condition) throw std::invalid_argument(text);
}

Task read_task(int argc, char **argv)
{
    require(argc == 7 || argc == 8, "usage: virial A B C ORDER SAMPLES SEED [FIRST]");
    Task task{{real(argv[1], "A"), real(argv[2], "B"), real(argv[3], "C")},
              integer<int>(argv[4], "ORDER"),
              integer<std::uint64_t>(argv[5], "SAMPLES"),
              integer<std::uint64_t>(argv[6], "SEED"),
              argc == 8 ? integer<std::uint64_t>(argv[7], "FIRST") : 0};
    for (double const axis : task.semi_axes.coordinates)
        require(axis >= 1e-3 && axis <= 1e3, "the semi-axes must be from 0.001 to 1000");
    require(task.order >= 2 && task.order <= most_particles, "ORDER must be from 2 to 6");
    require(task.samples >= 2 && task.samples <= std::uint64_t{1} << 53,
            "SAMPLES must be from 2 to 2^53");
    require(task.first <= std::uint64_t{1} << 53, "FIRST must be at most 2^53");
    return task;
}

Counts sample(Task const &task)
{
    Clusters const clusters(task.semi_axes);
    auto const trees = weighted_trees(task.order);
    Counts counts{std::vector<std::uint64_t>(number_of_graphs(task.order))};
#pragma omp parallel
    {
        Counts own{std::vector<std::uint64_t>(counts.graphs.size())};
#pragma omp for
        for (std::uint64_t k = 0; k < task.samples; ++k) {
            Stream random(task.seed, task.first + k, static_cast<std::uint32_t>(task.order));
            auto const &tree = trees[random.below(static_cast<std::uint32_t>(trees.size()))];
            ++own.graphs[clusters.overlaps(tree, random, own.trials)];
        }
#pragma omp critical
        {
            for (std::size_t graph = 0; graph < own.graphs.size(); ++graph)
                counts.graphs[graph] += own.graphs[graph];
            counts.trials += own.trials;
        }
    }
    return counts;
}

/// B_n / B2^(n-1) = (1-n)/n! 2^(n-1) t ⟨w/t'⟩: w is the sum of Mayer's diagrams of the overlaps, t'
/// the weight of the trees in their graph, and t that of all trees.
Estimate ratio(Task const &task, Counts const &counts)
{
    int const n = task.order;
    auto const mayer = mayer_sums(n), trees = tree_sums(n);
    double sum = 0.0, sum_of_squares = 0.0;
    for (std::size_t graph = 0; graph < counts.graphs.size(); ++graph) {
        if (counts.graphs[graph] == 0) continue;
        double const value = static_cast<double>(mayer[graph]) / trees[graph],
                     count = static_cast<double>(counts.graphs[graph]);
        sum += count * value;
        sum_of_squares += count * value * value;
    }
    double factor = 1 - n;
    for (int k = 1; k <= n; ++k) factor /= k;
    factor *= trees.back() * std::ldexp(1.0, n - 1);
    auto const samples = static_cast<double>(task.samples);
    double const mean = sum / samples, variance = sum_of_squares / samples - mean * mean;
    return {factor * mean,
            std::abs(factor) * std::sqrt(std::fmax(variance, 0.0) / (samples - 1.0))};
}

/// Each neighbour is found with the same probability in each trial. The relative variance of the
/// number of trials is 1 - probability.
Estimate b2(Task const &task, Counts const &counts)
{
    double const found = static_cast<double>(task.samples) * (task.order - 1);
    double const probability = found / static_cast<double>(counts.trials);
    double const value = Clusters(task.semi_axes).bound_on_b2() * probability;
    return {value, value * std::sqrt((1.0 - probability) / found)};
}

} // namespace

int main(int argc, char **argv)
{
    try {
        Task const task = read_task(argc, argv);
        Counts const counts = sample(task);
        auto const [value, error] = ratio(task, counts);
        auto const [second, error_of_second] = b2(task, counts);
        std::printf("%.17g %.17g %.17g %.17g\n", value, error, second, error_of_second);
    } catch (std::exception const &error) {
        std::fprintf(stderr, "virial: %s\n", error.what());
        return 2;
    }
}
