// Evaluations of f that the solvers need, and the tiers that decide overlaps, against the aspect ratio, as CSV.
//
// Usage: evaluations [PAIRS] > evaluations.csv
//
// Random pairs of general ellipsoids with μ between 0.9 and 1.1. Beside the fast solver: Brent's method on f in λ as pw85
// 1.0 had it, with one evaluation per iteration and one for each of three Newton-Raphson steps.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_min.h>

#include <pw85.h>
#include <pw85/pw85.hpp>

namespace {

using Vector3 = pw85::Vector<double, 3>;
using Form3 = pw85::SymmetricMatrix<double, 3>;

struct RandomPair {
    Vector3 r12;
    Form3 q1, q2;
};

class RandomPairs {
  public:
    RandomPair next(double aspect)
    {
        RandomPair pair{{normal_(bits_), normal_(bits_), normal_(bits_)}, form(aspect), form(aspect)};
        double const mu = 0.9 + 0.2 * uniform_(bits_);
        double const scale = mu / std::sqrt(pw85::contact(pair.r12, pair.q1, pair.q2).mu2);
        pair.r12 = pw85::times(scale, pair.r12);
        return pair;
    }

  private:
    Form3 form(double aspect)
    {
        Vector3 const semi_axes{1.0, std::pow(aspect, -uniform_(bits_)), 1.0 / aspect};
        pw85::Vector<double, 4> const turn{normal_(bits_), normal_(bits_), normal_(bits_), normal_(bits_)};
        return pw85::ellipsoid_quaternion(semi_axes, turn).q;
    }

    std::mt19937_64 bits_{1985};
    std::normal_distribution<double> normal_;
    std::uniform_real_distribution<double> uniform_;
};

struct CountedMinusF {
    RandomPair const *pair;
    int evaluations;
};

double minus_f(double lambda, void *data)
{
    auto &counted = *static_cast<CountedMinusF *>(data);
    ++counted.evaluations;
    return -pw85::evaluate_f(lambda, counted.pair->r12, counted.pair->q1, counted.pair->q2);
}

int evaluations_by_brent(RandomPair const &pair, gsl_min_fminimizer *minimizer)
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
    RandomPairs random;
    Count brent, fast;
    double tiers[3] = {};
    for (int i = 0; i < pairs; ++i) {
        RandomPair const pair = random.next(aspect);
        brent.add(evaluations_by_brent(pair, minimizer));
        fast.add(pw85::maximize(pw85::scale(pair.r12, pair.q1, pair.q2).pair).evaluations);
        tiers[static_cast<int>(pw85::overlap(pair.r12, pair.q1, pair.q2).tier)] += 100.0 / pairs;
    }
    std::printf("%g,%.2f,%d,%.2f,%d,%.3g,%.3g,%.3g\n", aspect, fast.sum / pairs, fast.largest, brent.sum / pairs,
                brent.largest, tiers[0], tiers[1], tiers[2]);
}

} // namespace

int main(int argc, char **argv)
{
    int const pairs = argc > 1 ? std::max(1, std::atoi(argv[1])) : 20000;
    gsl_set_error_handler_off();
    gsl_min_fminimizer *const minimizer = gsl_min_fminimizer_alloc(gsl_min_fminimizer_brent);
    std::puts("aspect,mean_contact,largest_contact,mean_brent,largest_brent,percent_quartic,"
              "percent_contact,percent_exact");
    for (double const aspect : {1.0, 2.0, 5.0, 10.0, 30.0, 100.0, 300.0, 1e3, 3e3, 1e4, 1e5, 1e6})
        print_row(aspect, pairs, minimizer);
    gsl_min_fminimizer_free(minimizer);
}
