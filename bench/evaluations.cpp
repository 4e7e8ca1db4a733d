// SPDX-License-Identifier: BSD-3-Clause
// Prints the numbers of evaluations of f that the solvers need, and the per cent of overlaps that
// each tier decides, by aspect ratio, as CSV. Usage: evaluations [PAIRS]
//
// Beside the fast solver it runs Brent's method on f in λ as in pw85 1.0, which takes one
// evaluation per iteration and one for each of three Newton-Raphson steps.
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_min.h>

#include <pw85.h>

#include "pairs.hpp"

using namespace pw85_bench;

namespace {

struct CountedMinusF {
    Pair const *pair;
    int evaluations;
};

double minus_f(double lambda, void *data)
{
    auto &counted = *static_cast<CountedMinusF *>(data);
    ++counted.evaluations;
    return -pw85::detail::evaluate_f(lambda, counted.pair->r12, counted.pair->q1, counted.pair->q2);
}

int evaluations_by_brent(Pair const &pair, gsl_min_fminimizer *minimizer)
{
    CountedMinusF counted{&pair, 0};
    gsl_function function{minus_f, &counted};
    gsl_min_fminimizer_set(minimizer, &function, 0.5, 0.0, 1.0);
    for (int i = 0; i < PW85_MAX_ITER; ++i) {
        gsl_min_fminimizer_iterate(minimizer);
        if (minimizer->x_upper - minimizer->x_lower < PW85_LAMBDA_ATOL) break;
    }
    return counted.evaluations + PW85_NR_ITER;
}

struct Count {
    double sum = 0.0;
    int largest = 0;

    void add(int n)
    {
        sum += n;
        largest = std::max(largest, n);
    }
};

void print_row(double aspect, int pairs, gsl_min_fminimizer *minimizer)
{
    Count brent, fast;
    double tiers[3] = {};
    for (Pair const &pair : random_block(aspect, 0.0, pairs)) {
        brent.add(evaluations_by_brent(pair, minimizer));
        fast.add(pw85::detail::maximize(
                     pw85::detail::scale(pw85::detail::pair_of(pair.r12, pair.q1, pair.q2)).pair)
                     .evaluations);
        tiers[static_cast<int>(pw85::overlap(pair.r12, pair.q1, pair.q2).tier)] += 100.0 / pairs;
    }
    std::printf("%g,%d,%.2f,%d,%.2f,%d,%.3g,%.3g,%.3g\n", aspect, pairs, fast.sum / pairs,
                fast.largest, brent.sum / pairs, brent.largest, tiers[0], tiers[1], tiers[2]);
}

} // namespace

int main(int argc, char **argv)
{
    int const pairs = argc > 1 ? std::atoi(argv[1]) : 20000;
    if (argc > 2 || pairs < 1) {
        std::fprintf(stderr, "usage: %s [PAIRS]\n", argv[0]);
        return 1;
    }
    gsl_set_error_handler_off();
    gsl_min_fminimizer *const minimizer = gsl_min_fminimizer_alloc(gsl_min_fminimizer_brent);
    std::puts("aspect,pairs,mean_contact,largest_contact,mean_brent,largest_brent,percent_quartic,"
              "percent_contact,"
              "percent_exact");
    for (double const aspect : {1.0, 2.0, 5.0, 10.0, 30.0, 100.0, 300.0, 1e3, 3e3, 1e4, 1e5, 1e6})
        print_row(aspect, pairs, minimizer);
    gsl_min_fminimizer_free(minimizer);
    return 0;
}
