// SPDX-License-Identifier: BSD-3-Clause
// Runs the tiers of a device on the contact problems, as target regions of OpenMP. They are
// compiled for another machine, which here is the processor of this one. Usage: offload PROBLEMS
#include <cmath>
#include <cstdio>
#include <vector>

#include <omp.h>

#include "../../src/gpu/work.hpp"

using namespace pw85;
using namespace pw85::detail::gpu;

namespace {

/// As tests/gpu/problems.cpp writes them.
struct Problem {
    double pair[15], mu2, cond;
    double overlap;
};

/// What a thread of the device says.
struct Answer {
    double mu2;
    unsigned char overlap, host; ///< host: left to the host
};

std::vector<Problem> read(char const *path)
{
    std::vector<Problem> problems;
    std::FILE *const file = std::fopen(path, "rb");
    if (file == nullptr) return problems;
    for (Problem p; std::fread(&p, sizeof p, 1, file) == 1;) problems.push_back(p);
    std::fclose(file);
    return problems;
}

} // namespace

int main(int argc, char **argv)
{
    std::vector<Problem> const problems = read(argc > 1 ? argv[1] : "");
    std::vector<Answer> answers(problems.size());
    Problem const *const p = problems.data();
    Answer *const a = answers.data();
    std::size_t const n = problems.size();
    int on_host = 1;
#pragma omp target teams distribute parallel for map(to : p [0:n]) map(from : a [0:n])
    for (std::size_t i = 0; i < n; ++i) {
        Pair3 const pair = load(Pairs{p[i].pair, p[i].pair + 3, p[i].pair + 9}, 0);
        double lambda;
        if (!attempt(ContactArrays{&a[i].mu2, &lambda}, pair, 0))
            fallback(ContactArrays{&a[i].mu2, &lambda}, pair, 0);
        OverlapArray const out{&a[i].overlap};
        a[i].host = !attempt(out, pair, 0) && !fallback(out, pair, 0);
    }
#pragma omp target map(from : on_host)
    on_host = omp_is_initial_device();

    int wrong = 0, undecided = 0;
    double worst = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        double const error = std::fabs(a[i].mu2 - p[i].mu2) / (p[i].mu2 * 0x1p-53 * p[i].cond);
        bool const good = error <= 4.0 && (a[i].host || a[i].overlap == p[i].overlap);
        worst = std::fmax(worst, error);
        undecided += a[i].host;
        wrong += !good;
        if (!good && wrong <= 5)
            std::printf("problem %zu: mu2 %a, overlap %d\n", i, a[i].mu2, a[i].overlap);
    }
    std::printf("%zu problems, %d wrong, %d left to the host, largest error %.2f u cond, %s\n", n,
                wrong, undecided, worst, on_host ? "not offloaded" : "offloaded");
    return n < 10000 || wrong != 0 || on_host;
}
