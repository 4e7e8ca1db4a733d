// SPDX-License-Identifier: BSD-3-Clause
// Prints the time of the functions that take factors beside that of the functions that take forms,
// on the same pairs, as CSV, in nanoseconds. Half of the pairs overlap: μ² is log-uniform from 1/4
// to 4.
#include <cmath>
#include <cstdio>
#include <vector>

#include <pw85.h>

#include <factors.hpp>

#include "least_time.hpp"
#include "pairs.hpp"

using namespace pw85_bench;
using pw85_tests::Factors;
using pw85_tests::Random;

namespace {

struct Item {
    Factors<double, 3> factors;
    Pair forms;
    double lambda;
};

std::vector<Item> random_items(double aspect)
{
    Random random(static_cast<std::uint64_t>(aspect));
    std::vector<Item> items;
    for (int n = 0; n < block_size; ++n) {
        Item x{};
        for (auto const &[s, q] :
             {std::pair{&x.factors.s1, &x.forms.q1}, {&x.factors.s2, &x.forms.q2}}) {
            auto const axes = random.semi_axes(random.log_uniform(0.5, 2.0), aspect);
            auto const turn = random.direction<4>();
            *s = pw85::ellipsoid_factor(axes, turn).s;
            *q = pw85::ellipsoid_quaternion(axes, turn).q;
        }
        auto const direction = random.direction<3>();
        double const mu2 = pw85::contact(direction, x.forms.q1, x.forms.q2).mu2;
        x.factors.r12 = x.forms.r12 = std::sqrt(random.log_uniform(0.25, 4.0) / mu2) * direction;
        x.lambda = pw85::contact(x.forms.r12, x.forms.q1, x.forms.q2).lambda;
        items.push_back(x);
    }
    return items;
}

#define PW85_BENCH_FORMS(x) (x).forms.r12.coordinates, (x).forms.q1.entries, (x).forms.q2.entries
#define PW85_BENCH_FACTORS(x)                                                                      \
    (x).factors.r12.coordinates, (x).factors.s1.entries, (x).factors.s2.entries

struct Function {
    char const *name;
    void (*call)(Item const &);
};

double out[3][9];
int answer;

constexpr Function functions[] = {
    {"contact", [](Item const &x) { pw85_contact(PW85_BENCH_FORMS(x), out[0]); }},
    {"contact_factored",
     [](Item const &x) { pw85_contact_factored(PW85_BENCH_FACTORS(x), out[0]); }},
    {"overlap", [](Item const &x) { pw85_overlap(PW85_BENCH_FORMS(x), &answer); }},
    {"overlap_factored",
     [](Item const &x) { pw85_overlap_factored(PW85_BENCH_FACTORS(x), &answer); }},
    {"contact_geometry",
     [](Item const &x) { pw85_contact_geometry(PW85_BENCH_FORMS(x), x.lambda, out[0], out[1]); }},
    {"contact_geometry_factored",
     [](Item const &x) {
         pw85_contact_geometry_factored(PW85_BENCH_FACTORS(x), x.lambda, out[0], out[1]);
     }},
    {"contact_gradient",
     [](Item const &x) {
         pw85_contact_gradient(PW85_BENCH_FORMS(x), x.lambda, out[0], out[1], out[2]);
     }},
    {"contact_gradient_factored",
     [](Item const &x) {
         pw85_contact_gradient_factored(PW85_BENCH_FACTORS(x), x.lambda, out[0], out[1], out[2]);
     }},
    {"condition", [](Item const &x) { pw85_condition(PW85_BENCH_FORMS(x), x.lambda, out[0]); }},
};

} // namespace

int main()
{
    std::vector<std::vector<Item>> blocks;
    for (double const aspect : {2.0, 10.0, 100.0, 1000.0}) blocks.push_back(random_items(aspect));
    std::puts("function,aspect_2,aspect_10,aspect_100,aspect_1000");
    for (auto const &[name, call] : functions) {
        std::printf("%s", name);
        for (auto const &items : blocks)
            std::printf(",%.3g", least_time(items.size(), [&](std::size_t begin, std::size_t end) {
                            for (std::size_t i = begin; i < end; ++i) call(items[i]);
                        }));
        std::puts("");
    }
    return 0;
}
