// SPDX-License-Identifier: BSD-3-Clause
// Counts the steps of the searches for choices.py, over random pairs of several aspect ratios.
//
// Without arguments it prints the mean and the largest number of evaluations of f that the solver
// needs, and the per cent of pairs that it solves by factorisation. With "distance" it prints the
// steps of the search for the normal, for pairs that are apart. With numbers it prints the per cent
// of pairs that the test on the quartic leaves undecided at the first 1, 2, ... of these points
// about the first t, and after 1, 2, ... tests at the points of the fixed-point map.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <pw85/pw85.hpp>

#include "pairs.hpp"

using namespace pw85_bench;

namespace {

constexpr int num_pairs = 4000;

void count_evaluations(double aspect)
{
    double sum = 0.0, factorized = 0.0;
    int largest = 0;
    for (Pair const &pair : random_block(aspect, 0.0, num_pairs)) {
        auto const scaled =
            pw85::detail::scale(pw85::detail::pair_of(pair.r12, pair.q1, pair.q2)).pair;
        auto const maximum = pw85::detail::maximize(scaled);
        auto search = pw85::detail::start_search(scaled);
        run(search, scaled, pw85::detail::max_rational_steps);
        sum += maximum.evaluations;
        factorized += 100.0 * !pw85::detail::last_evaluation(scaled, search.candidate).certified;
        largest = std::max(largest, maximum.evaluations);
    }
    std::printf("%g,%.3f,%d,%.3g\n", aspect, sum / num_pairs, largest, factorized / num_pairs);
}

struct NormalCount {
    /// steps on the polynomials, and solutions of linear equations for a last step
    int steps = 0, solutions = 0;
    bool found = false;
};

/// Runs find_normal() and counts its steps.
NormalCount count_steps(pw85::detail::DistancePair<double, 3> const &pair,
                        pw85::detail::Multipliers<double> const &start)
{
    NormalCount count;
    auto search = pw85::detail::start_search(pair, start);
    for (; search.active && count.steps < pw85::detail::max_normal_steps; ++count.steps)
        take_step(search, pair);
    if (search.active) return count;
    auto last = take_last_step(pair, search.x);
    for (; !last.found && count.solutions < pw85::detail::max_last_steps; ++count.solutions)
        last = take_last_step(pair, factorize_normal(pair, last.next), last.next);
    ++count.solutions;
    count.found = last.found;
    return count;
}

/// The mean numbers of steps and solutions, and the per cent of pairs whose search starts again,
/// and whose search is nested.
void count_normals(double aspect)
{
    double steps = 0.0, solutions = 0.0, anew = 0.0, nested = 0.0;
    for (Pair const &p : random_block(aspect, 0.0, num_pairs)) {
        pw85::detail::DistancePair<double, 3> const pair{2.0 * p.r12, p.q1, p.q2, 1.0, 1.0};
        NormalCount const first = count_steps(pair, initial_multipliers(pair));
        NormalCount const second =
            first.found ? NormalCount{} : count_steps(pair, touching_multipliers(pair));
        steps += first.steps + second.steps;
        solutions += first.solutions + second.solutions;
        anew += 100.0 * !first.found;
        nested += 100.0 * !(first.found || second.found);
    }
    std::printf("%g,%.3f,%.3f,%.3g,%.3g\n", aspect, steps / num_pairs, solutions / num_pairs,
                anew / num_pairs, nested / num_pairs);
}

using ScaledPair = pw85::detail::Pair<double, 3>;

bool is_decided(ScaledPair const &pair, double t)
{
    auto const certainty = pw85::detail::test_quartic(pw85::detail::evaluate_quartic(pair, t), t);
    return certainty.apart || certainty.overlap;
}

/// The number of points up to the one that decides; larger than the number of points if none does.
std::size_t deciding_point(ScaledPair const &pair, std::vector<double> const &points)
{
    auto const weights = pw85::detail::outer_weights(pair.r12);
    double const center =
        pw85::detail::coarse_root_of_ratio(pw85::detail::quadratic_form(pair.q1, weights),
                                           pw85::detail::quadratic_form(pair.q2, weights));
    std::size_t n = 0;
    while (n < points.size() && !is_decided(pair, center * points[n])) ++n;
    return n + 1;
}

/// The number of tests along the fixed-point map up to the one that decides; larger than the limit
/// if none does.
std::size_t deciding_test(ScaledPair const &pair, std::size_t most)
{
    double t = pw85::detail::initial_guess(pair);
    std::size_t n = 0;
    for (; n < most && !is_decided(pair, t); ++n)
        t = std::sqrt(pw85::detail::fixed_point_square(pw85::detail::evaluate_quartic(pair, t), t));
    return n + 1;
}

void count_tests(double aspect, std::vector<double> const &points)
{
    constexpr std::size_t most = 5;
    std::vector<double> by_points(points.size() + 1), by_map(most + 1);
    for (Pair const &pair : random_block(aspect, 0.0, num_pairs)) {
        ScaledPair const p{pair.r12, pair.q1, pair.q2, 1.0};
        for (std::size_t n = 1; n < deciding_point(p, points); ++n)
            by_points[n] += 100.0 / num_pairs;
        for (std::size_t n = 1; n < deciding_test(p, most); ++n) by_map[n] += 100.0 / num_pairs;
    }
    std::printf("%g", aspect);
    for (std::size_t n = 1; n <= points.size(); n *= 2) std::printf(",%.3g", by_points[n]);
    for (std::size_t n = 1; n <= most; ++n) std::printf(",%.3g", by_map[n]);
    std::puts("");
}

} // namespace

int main(int argc, char **argv)
{
    if (argc > 1 && std::strcmp(argv[1], "distance") == 0) {
        for (double const aspect : {2.0, 10.0, 100.0, 1e3, 1e4}) count_normals(aspect);
        return 0;
    }
    std::vector<double> points;
    for (int i = 1; i < argc; ++i) points.push_back(std::atof(argv[i]));
    if (argc == 1)
        for (double const aspect : {2.0, 10.0, 100.0, 1e4, 1e6}) count_evaluations(aspect);
    else
        for (double const aspect : {2.0, 10.0, 100.0}) count_tests(aspect, points);
    return 0;
}
