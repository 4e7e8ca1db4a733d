// SPDX-License-Identifier: BSD-3-Clause
// Compares pw85_contact_rounded() with pw85_contact() on the same pairs, in turn, and prints what
// decides the rounding, as CSV. Usage: rounded
//
// Times are in nanoseconds per pair. `bounds` is the per cent of pairs that the first evaluation in
// doubled numbers decides, `again` that of pairs that more evaluations decide, `exact` that of
// pairs for which μ² is compared with the middle of two doubles in integers.
#include <cstdio>

#include <pw85.h>

#include "least_time.hpp"
#include "pairs.hpp"

using namespace pw85_bench;

namespace {

template <int (*contact)(double const *, double const *, double const *, double *)>
double time_of(std::vector<Pair> const &pairs)
{
    return least_time(pairs.size(), [&](std::size_t begin, std::size_t end) {
        double out[2];
        double volatile sink = 0.0;
        for (std::size_t i = begin; i < end; ++i) {
            contact(pairs[i].r12.coordinates, pairs[i].q1.entries, pairs[i].q2.entries, out);
            sink = sink + out[0];
        }
    });
}

/// What decides the rounding, in per cent of the pairs.
struct Shares {
    double bounds = 0.0, again = 0.0, exact = 0.0;
};

Shares shares_of(std::vector<Pair> const &pairs)
{
    Shares shares;
    double const one = 100.0 / static_cast<double>(pairs.size());
    for (Pair const &p : pairs) {
        auto const [contact, evaluations, comparisons] =
            pw85::detail::round_contact(pw85::detail::pair_of(p.r12, p.q1, p.q2));
        (comparisons > 0 ? shares.exact : evaluations > 1 ? shares.again : shares.bounds) += one;
    }
    return shares;
}

} // namespace

int main()
{
    std::puts("aspect,contact,rounded,ratio,bounds,again,exact");
    for (double const aspect : {2.0, 10.0, 100.0, 1e3, 1e4, 1e6}) {
        // Extended numbers take 0.2 ms.
        auto const pairs = random_block(aspect, 0.0, aspect > 1e4 ? 512 : 4096);
        double const contact = time_of<pw85_contact>(pairs),
                     rounded = time_of<pw85_contact_rounded>(pairs);
        Shares const shares = shares_of(random_block(aspect, 0.0, 20000));
        std::printf("%g,%.0f,%.0f,%.2f,%.4g,%.4g,%.4g\n", aspect, contact, rounded,
                    rounded / contact, shares.bounds, shares.again, shares.exact);
    }
    return 0;
}
