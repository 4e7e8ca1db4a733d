// SPDX-License-Identifier: BSD-3-Clause
// Prints the largest relative errors of the distance of closest approach by aspect ratio, as CSV:
// for the contact function and for the algorithms of Zheng et al. The reference is the contact
// function with 50 digits. Usage: closest_approach [PAIRS]
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include <pw85_zheng.h>

#include <random_pairs.hpp>
#include <wide.hpp>

using namespace pw85_tests;

namespace {

using Function = int (*)(double const *, double const *, double const *, double *);

/// The relative error of a distance; infinity if the distance is not a number.
template <int D>
double relative_error(Function function, Sample<double, D> const &p, Wide const &exact)
{
    double distance;
    function(p.r12.coordinates, p.q1.entries, p.q2.entries, &distance);
    double const error = static_cast<double>(Wide(abs(Wide(distance - exact)) / exact));
    return std::isnan(error) ? HUGE_VAL : error;
}

/// The errors of `by_contact`, then those of `by_zheng`.
template <int D> void print_errors(int pairs, double aspect, Function by_contact, Function by_zheng)
{
    Random random(2008);
    double contact = 0.0, zheng = 0.0;
    for (int i = 0; i < pairs; ++i) {
        auto const p = random_pair<D>(random, {.aspect = aspect, .aspect_min = aspect});
        auto const wide = convert<Wide>(p);
        Wide const exact = pw85::closest_approach(wide.r12, wide.q1, wide.q2).distance;
        contact = std::max(contact, relative_error(by_contact, p, exact));
        zheng = std::max(zheng, relative_error(by_zheng, p, exact));
    }
    std::printf(",%.1g,%.1g", contact, zheng);
}

} // namespace

int main(int argc, char **argv)
{
    int const pairs = argc > 1 ? std::atoi(argv[1]) : 1000;
    if (argc > 2 || pairs < 1) {
        std::fprintf(stderr, "usage: %s [PAIRS]\n", argv[0]);
        return 1;
    }
    std::puts("aspect,pairs,contact_ellipses,zheng_ellipses,contact_ellipsoids,zheng_ellipsoids");
    for (double const aspect : {1.0, 10.0, 100.0, 1e3, 1e4}) {
        std::printf("%g,%d", aspect, pairs);
        print_errors<2>(pairs, aspect, pw85_closest_approach_2d, pw85_zheng_ellipses);
        print_errors<3>(pairs, aspect, pw85_closest_approach, pw85_zheng_ellipsoids);
        std::puts("");
    }
    return 0;
}
