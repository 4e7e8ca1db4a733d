// For choices.py: the mean number of evaluations of f that the solver needs, the largest, and the per cent of pairs that it solves by
// factorisation, over random pairs of several aspect ratios.
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include <pw85/pw85.hpp>

#include "pairs.hpp"

using namespace pw85_bench;

int main(int argc, char **argv)
{
    int const pairs = argc > 1 ? std::atoi(argv[1]) : 4000;
    for (double const aspect : {2.0, 10.0, 100.0, 1e4, 1e6}) {
        double sum = 0.0, factorized = 0.0;
        int largest = 0;
        for (Pair const &pair : random_block(aspect, 0.0, pairs)) {
            auto const scaled = pw85::scale(pair.r12, pair.q1, pair.q2).pair;
            auto const maximum = pw85::maximize(scaled);
            auto state = pw85::start_search(scaled, pw85::initial_guess(scaled));
            for (int i = 0; i < pw85::max_rational_steps && state.active; ++i) pw85::take_step(state, scaled.ratio);
            sum += maximum.evaluations;
            factorized += 100.0 * !pw85::last_evaluation(scaled, state.candidate).certain;
            largest = std::max(largest, maximum.evaluations);
        }
        std::printf("%g,%.3f,%d,%.3g\n", aspect, sum / pairs, largest, factorized / pairs);
    }
    return 0;
}
