// SPDX-License-Identifier: BSD-3-Clause
// Searches for pairs whose μ² is next to the middle of two doubles, and prints them for
// data/contact_rounded.wc: the 15 numbers of r12, q1 and q2, in hexadecimal, and above them the
// distance from the middle. Usage: worst_roundings [PAIRS]
//
// Around a random pair, μ² is nearly linear in a few steps of the last place of six of its numbers.
// All sums of three steps are sorted, those of the other three as well. Two sums that add up to the
// distance of μ² from a middle are found by one pass over both. So 2^42 pairs are searched in the
// time of 2^21. The best hundred are computed in 200 digits.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include <pw85/pw85.hpp>

#include "nearly_singular.hpp"

using namespace pw85_tests;

namespace {

constexpr int reach = 64, num_kept = 100;

/// The numbers of a pair that are varied. No entry of a form that is zero is among them.
double *number(Sample<double, 3> &s, int index)
{
    double *const numbers[] = {&s.r12[0], &s.r12[1], &s.r12[2], &s.q1[0], &s.q1[3], &s.q2[5]};
    return numbers[index];
}

double unit_of(double x) { return std::ldexp(1.0, std::ilogb(x) - 52); }

Sample<double, 3> moved(Sample<double, 3> s, int index, double steps)
{
    *number(s, index) += steps * unit_of(*number(s, index));
    return s;
}

/// μ² over the distance of doubles at `at`, from the middle of two of them on.
Precise place(Sample<double, 3> const &s, double at)
{
    return precise_truth(s).mu2 / Precise(unit_of(at)) - Precise(0.5);
}

double fraction(Precise const &x) { return static_cast<double>(Precise(x - floor(x))); }

/// A sum of steps of three numbers, modulo one, and what the steps are.
struct Sum {
    double value;
    int steps;
};

std::vector<Sum> sums(double const (&slopes)[6], int first)
{
    std::vector<Sum> list;
    for (int i = 0; i < 2 * reach; ++i)
        for (int j = 0; j < 2 * reach; ++j)
            for (int k = 0; k < 2 * reach; ++k) {
                double const sum = (i - reach) * slopes[first] + (j - reach) * slopes[first + 1] +
                                   (k - reach) * slopes[first + 2];
                list.push_back({sum - std::floor(sum), (i * 2 * reach + j) * 2 * reach + k});
            }
    std::sort(list.begin(), list.end(),
              [](Sum const &x, Sum const &y) { return x.value < y.value; });
    return list;
}

Sample<double, 3> moved(Sample<double, 3> s, int first, Sum const &sum)
{
    int steps = sum.steps;
    for (int i = 2; i >= 0; --i) {
        s = moved(s, first + i, steps % (2 * reach) - reach);
        steps /= 2 * reach;
    }
    return s;
}

struct Found {
    double distance; ///< from a middle, in units of the last place
    Sample<double, 3> pair;
};

/// The pairs around `s` whose μ² is nearest to a middle by the linear law.
std::vector<Found> near_middles(Sample<double, 3> const &s, double at, double const (&slopes)[6])
{
    auto const left = sums(slopes, 0), right = sums(slopes, 3);
    double const base = fraction(place(s, at));
    std::vector<Found> found;
    for (std::size_t i = 0, j = right.size(); i < left.size(); ++i) {
        // right[j].value is the largest one with base + left + right <= 1 or 2.
        double const whole = base + left[i].value > 1.0 ? 2.0 : 1.0;
        if (i > 0 && whole > (base + left[i - 1].value > 1.0 ? 2.0 : 1.0)) j = right.size();
        while (j > 0 && base + left[i].value + right[j - 1].value > whole) --j;
        for (std::size_t const k : {j, j - 1})
            if (k < right.size()) {
                double const distance = std::fabs(base + left[i].value + right[k].value - whole);
                if (distance < 0x1p-35)
                    found.push_back({distance, moved(moved(s, 0, left[i]), 3, right[k])});
            }
    }
    std::sort(found.begin(), found.end(),
              [](Found const &x, Found const &y) { return x.distance < y.distance; });
    if (found.size() > num_kept) found.resize(num_kept);
    return found;
}

Found search(Random &random, double aspect)
{
    auto const s = random_pair<3>(random, {.aspect = aspect, .aspect_min = aspect});
    double const at = pw85::contact(s.r12, s.q1, s.q2).mu2;
    double slopes[6];
    for (int i = 0; i < 6; ++i)
        slopes[i] = static_cast<double>(
            Precise((place(moved(s, i, 256.0), at) - place(moved(s, i, -256.0), at)) / 512));
    Found best{std::numeric_limits<double>::infinity(), s};
    for (auto const &f : near_middles(s, at, slopes)) {
        double const from = fraction(place(f.pair, at)), distance = std::fmin(from, 1.0 - from);
        if (distance < best.distance && is_exactly_definite(f.pair)) best = {distance, f.pair};
    }
    return best;
}

void print(Found const &f, double aspect)
{
    std::printf("# aspect ratio %g, 2^%.1f units in the last place from a middle\n", aspect,
                std::log2(f.distance));
    for (int i = 0; i < 3; ++i) std::printf("%a,", f.pair.r12[i]);
    for (int k = 0; k < 6; ++k) std::printf("%a,", f.pair.q1[k]);
    for (int k = 0; k < 6; ++k) std::printf(k < 5 ? "%a," : "%a\n", f.pair.q2[k]);
}

} // namespace

int main(int argc, char **argv)
{
    int const pairs = argc > 1 ? std::atoi(argv[1]) : 16;
    if (argc > 2 || pairs < 1) {
        std::fprintf(stderr, "usage: %s [PAIRS]\n", argv[0]);
        return 1;
    }
    std::puts("# Pairs whose contact function is next to the middle of two doubles: r12, q1 and q2 "
              "(bench/worst_roundings.cpp).");
    Random random(800);
    for (double const aspect : {2.0, 5.0, 10.0, 100.0}) {
        std::vector<Found> found;
        for (int n = 0; n < pairs; ++n) found.push_back(search(random, aspect));
        std::sort(found.begin(), found.end(),
                  [](Found const &x, Found const &y) { return x.distance < y.distance; });
        for (std::size_t n = 0; n < std::min<std::size_t>(4, found.size()); ++n)
            print(found[n], aspect);
    }
    return 0;
}
