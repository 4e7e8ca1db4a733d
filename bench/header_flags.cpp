// SPDX-License-Identifier: BSD-3-Clause
// Measures overlap and contact of one pair: the functions of the library beside the templates of
// the headers, inlined. It is compiled by several flags (meson.build), because a user's program
// chooses its own.
//
//     for program in build/bench/header_flags_*; do $program; done
#include <cstdio>

#include <pw85.h>

#include "least_time.hpp"
#include "pairs.hpp"

using namespace pw85_bench;

namespace {

/// A result that is not read.
double volatile sink;

template <class Call> double time_of(std::vector<Pair> const &pairs, Call const &call)
{
    return least_time(pairs.size(), [&](std::size_t begin, std::size_t end) {
        double sum = 0.0;
        for (std::size_t i = begin; i < end; ++i)
            sum += call(pairs[i].r12, pairs[i].q1, pairs[i].q2);
        sink = sum;
    });
}

} // namespace

int main()
{
    std::printf("%s\nns per pair       overlap: library headers  contact: library headers\n",
                PW85_BENCH_FLAGS);
    for (double const aspect : {2.0, 10.0, 100.0}) {
        auto const pairs = random_block(aspect);
        double const overlap_of_library =
            time_of(pairs, [](auto const &r12, auto const &q1, auto const &q2) {
                int overlap;
                pw85_overlap(r12.coordinates, q1.entries, q2.entries, &overlap);
                return overlap;
            });
        double const overlap_of_headers =
            time_of(pairs, [](auto const &r12, auto const &q1, auto const &q2) {
                return pw85::overlap(r12, q1, q2).overlap;
            });
        double const contact_of_library =
            time_of(pairs, [](auto const &r12, auto const &q1, auto const &q2) {
                double out[2];
                pw85_contact(r12.coordinates, q1.entries, q2.entries, out);
                return out[0];
            });
        double const contact_of_headers =
            time_of(pairs, [](auto const &r12, auto const &q1, auto const &q2) {
                return pw85::contact(r12, q1, q2).mu2;
            });
        std::printf("aspect %-5g %20.1f %7.1f %18.1f %7.1f\n", aspect, overlap_of_library,
                    overlap_of_headers, contact_of_library, contact_of_headers);
    }
    return 0;
}
