// SPDX-License-Identifier: BSD-3-Clause
// Measures how the time per pair or particle grows with their number, and what a second thread
// gains. measure.py runs it.
//
// The rows are `function,number,time,speed_up,limit`: number of pairs, or of particles for
// neighbours; nanoseconds per pair or particle with one thread; the gain by a second thread of the
// library; and the gain of two independent threads with one problem each, which is what the machine
// gives two programs. The arguments are the largest number, 1e7 by default, and the name of the
// only function to measure.
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>

#include "pairs.hpp"
#include <pw85/batch.hpp>

#include "spheroids.hpp"
#include "thread_gain.hpp"

using namespace pw85_bench;

namespace {

using Vector3 = pw85::Vector<double, 3>;
using Form = pw85::SymmetricMatrix<double, 3>;

/// One call of the library, and over how many pairs or particles its time is divided.
struct Problem {
    std::size_t number;
    std::function<void()> run;
};

/// Arrays of pairs of aspect ratio 10, which repeat a block.
struct Arrays {
    std::vector<Vector3> r12;
    std::vector<Form> q1, q2;
    std::vector<double> mu2, lambda;
    std::vector<unsigned char> overlap;

    explicit Arrays(std::size_t n) : mu2(n), lambda(n), overlap(n)
    {
        auto const block = random_block(10.0);
        for (std::size_t i = 0; i < n; ++i) {
            auto const &pair = block[i % block.size()];
            r12.push_back(pair.r12);
            q1.push_back(pair.q1);
            q2.push_back(pair.q2);
        }
    }
};

Problem contact_batch(std::size_t n)
{
    auto const x = std::make_shared<Arrays>(n);
    return {n, [=] { pw85::contact_batch(x->r12, x->q1, x->q2, x->mu2, x->lambda); }};
}

Problem overlap_batch(std::size_t n)
{
    auto const x = std::make_shared<Arrays>(n);
    return {n, [=] { pw85::overlap_batch(x->r12, x->q1, x->q2, x->overlap); }};
}

Problem neighbors(std::size_t n)
{
    auto const system = std::make_shared<System>(n, 10.0, 0.5);
    return {n, [=] {
                pw85::Neighbors list;
                neighbors_create(system->particles(), {}, list);
            }};
}

/// Spheroids of aspect ratio 3, sorted in space, with a list of some n pairs.
struct Listed {
    static constexpr double pairs_per_particle = 7.0;
    System system;
    pw85::Neighbors list;
    std::vector<double> mu2, lambda;
    std::vector<unsigned char> overlap;
    std::vector<Vector3> d_r12, d_rot1, d_rot2, forces, torques;

    explicit Listed(std::size_t n)
        : system(static_cast<std::size_t>(static_cast<double>(n) / pairs_per_particle), 3.0, 0.5)
    {
        system.sort(6.0);
        neighbors_create(system.particles(), {}, list);
    }
};

Problem overlap_pairs(std::size_t n)
{
    auto const x = std::make_shared<Listed>(n);
    x->overlap.resize(x->list.pairs().size());
    return {x->overlap.size(),
            [=] { pw85::overlap_pairs(x->list.list(), x->system.particles(), x->overlap); }};
}

Problem contact_pairs(std::size_t n)
{
    auto const x = std::make_shared<Listed>(n);
    x->mu2.resize(x->list.pairs().size());
    return {x->mu2.size(),
            [=] { pw85::contact_pairs(x->list.list(), x->system.particles(), x->mu2); }};
}

Problem derivatives_pairs(std::size_t n)
{
    auto const x = std::make_shared<Listed>(n);
    std::size_t const pairs = x->list.pairs().size();
    for (auto *numbers : {&x->mu2, &x->lambda}) numbers->resize(pairs);
    for (auto *rows : {&x->d_r12, &x->d_rot1, &x->d_rot2}) rows->resize(pairs);
    return {pairs, [=] {
                pw85::DerivativeSpans const out = {x->mu2,   x->lambda, {},       {},
                                                   x->d_r12, x->d_rot1, x->d_rot2};
                pw85::contact_derivatives_pairs(x->list.list(), x->system.particles(), out);
            }};
}

Problem law_forces_pairs(std::size_t n)
{
    auto const x = std::make_shared<Listed>(n);
    for (auto *rows : {&x->forces, &x->torques}) rows->resize(x->system.q.size());
    return {x->list.pairs().size(), [=] {
                constexpr double lennard_jones[] = {4.0, 12.0, 4.0, 6.0, 1e300};
                double energy;
                pw85::law_forces_pairs(x->list.list(), x->system.particles(),
                                       {PW85_LAW_INVERSE_POWERS, lennard_jones}, energy,
                                       {x->forces, x->torques});
            }};
}

struct Function {
    char const *name;
    Problem (*make)(std::size_t);
    double largest; ///< number, for which 16 GB and a minute suffice
};

constexpr Function functions[] = {{"contact_batch", contact_batch, 1e7},
                                  {"overlap_batch", overlap_batch, 1e7},
                                  {"neighbors", neighbors, 1e6},
                                  {"overlap_pairs", overlap_pairs, 1e7},
                                  {"contact_pairs", contact_pairs, 1e7},
                                  {"contact_derivatives_pairs", derivatives_pairs, 1e7},
                                  {"law_forces_pairs", law_forces_pairs, 1e7}};

} // namespace

int main(int argc, char **argv)
{
    double const largest = argc > 1 ? std::atof(argv[1]) : 1e7;
    std::printf("function,number,time,speed_up,limit\n");
    for (Function const &function : functions) {
        if (argc > 2 && std::string(argv[2]) != function.name) continue;
        for (double number = 1e3; number <= std::min(largest, function.largest); number *= 10.0) {
            auto const n = static_cast<std::size_t>(number);
            Problem const first = function.make(n), second = function.make(n);
            Gain const gain = measure_threads({2e-3, 0.2, 5, 200}, first.run, second.run);
            std::printf("%s,%zu,%.3g,%.2f,%.2f\n", function.name, first.number,
                        1e9 * gain.seconds / static_cast<double>(first.number), gain.speed_up,
                        gain.limit);
            std::fflush(stdout);
        }
    }
    return 0;
}
