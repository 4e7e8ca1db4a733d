// How much work the solver and the overlap test do: over random pairs at each aspect ratio and over the contact problems,
// the histogram of the number of evaluations of f by contact(), and the per cent of pairs that each tier of overlap()
// decides.
#include <cstdio>
#include <map>

#include <reference_data.hpp>

#include "pairs.hpp"

using namespace pw85_bench;
using pw85_tests::Sample;

namespace {

struct Work {
    std::map<int, int> evaluations;
    int tiers[3] = {};
    int total = 0;

    void add(Sample<double, 3> const &p)
    {
        ++evaluations[pw85::maximize(pw85::scale(p.r12, p.q1, p.q2).pair).evaluations];
        ++tiers[static_cast<int>(pw85::overlap(p.r12, p.q1, p.q2).tier)];
        ++total;
    }

    void print(char const *what) const
    {
        long sum = 0;
        for (auto const &[count, pairs] : evaluations) sum += static_cast<long>(count) * pairs;
        std::printf("%s: %d pairs, %.2f evaluations on average\n  evaluations:", what, total,
                    static_cast<double>(sum) / total);
        for (auto const &[count, pairs] : evaluations) std::printf("  %d: %.3g %%", count, 100.0 * pairs / total);
        std::printf("\n  overlap decided by  quartic: %.3g %%  contact: %.3g %%  exact: %.3g %%\n",
                    100.0 * tiers[0] / total, 100.0 * tiers[1] / total, 100.0 * tiers[2] / total);
    }
};

} // namespace

int main()
{
    for (double const aspect : {2.0, 10.0, 100.0, 1000.0}) {
        Work work;
        for (auto const &x : make_block(aspect)) work.add(x.pair);
        char title[40];
        std::snprintf(title, sizeof title, "aspect %g", aspect);
        work.print(title);
    }
    Work work;
    for (auto const &p : pw85_tests::contact_problems()) work.add(p.pair);
    work.print("contact problems");
    return 0;
}
