// SPDX-License-Identifier: BSD-3-Clause
// The library over the contact problems, from two threads at once where there are threads. Usage:
// portable_library PROBLEMS
#include <pw85.h>
#include <pw85_batch.h>
#include <pw85_legacy.h>

#include <cstring>
#include <thread>

#include "problems.hpp"

using namespace pw85_tests;

namespace {

bool check_one_by_one(std::vector<Problem> const &problems)
{
    Answers contacts("pw85_contact"), by_brent("pw85_contact_function"), overlaps("pw85_overlap");
    for (Problem const &p : problems) {
        double out[2];
        int overlap = -1, status = pw85_contact(p.r12, p.q1, p.q2, out);
        contacts.add_contact(p, status, out[0]);
        status = pw85_contact_function(p.r12, p.q1, p.q2, out);
        by_brent.add_contact(p, status, out[0]);
        status = pw85_overlap(p.r12, p.q1, p.q2, &overlap);
        overlaps.add_overlap(p, status, overlap);
    }
    bool const right = contacts.summarize(), right_by_brent = by_brent.summarize();
    return overlaps.summarize() && right && right_by_brent;
}

/// What the functions for many pairs take and give.
struct Arrays {
    std::vector<double> r12, q1, q2, mu2;
    std::vector<unsigned char> overlap;

    explicit Arrays(std::vector<Problem> const &problems)
        : mu2(problems.size()), overlap(problems.size())
    {
        for (Problem const &p : problems) {
            r12.insert(r12.end(), p.r12, p.r12 + 3);
            q1.insert(q1.end(), p.q1, p.q1 + 6);
            q2.insert(q2.end(), p.q2, p.q2 + 6);
        }
    }

    void compute()
    {
        pw85_contact_batch(mu2.size(), r12.data(), q1.data(), q2.data(), mu2.data(), nullptr);
        pw85_overlap_batch(mu2.size(), r12.data(), q1.data(), q2.data(), overlap.data());
    }
};

bool check_many(std::vector<Problem> const &problems)
{
    Arrays arrays(problems), others(problems);
#ifdef PW85_TESTS_THREADS
    std::thread thread([&] { others.compute(); });
    arrays.compute();
    thread.join();
#else
    others.compute();
    arrays.compute();
#endif
    Answers contacts("pw85_contact_batch"), overlaps("pw85_overlap_batch"),
        threads("in another thread");
    for (std::size_t i = 0; i < problems.size(); ++i) {
        contacts.add_contact(problems[i], 0, arrays.mu2[i]);
        overlaps.add_overlap(problems[i], 0, arrays.overlap[i]);
        threads.add_contact(problems[i], arrays.mu2[i] == others.mu2[i] ? 0 : 1, others.mu2[i]);
    }
    bool const right = contacts.summarize(), same = threads.summarize();
    return overlaps.summarize() && right && same;
}

/// A function of the other library, and bad input.
bool check_rest()
{
    double const sphere[6] = {1.0, 0.0, 0.0, 1.0, 0.0, 1.0}, r12[3] = {0.0, 0.0, 3.0}, flat[6] = {};
    double out[2], mu2 = 0.0;
    int const status = pw85_legacy_contact_function2(r12, sphere, sphere, out);
    return status == PW85_SUCCESS && std::fabs(out[0] - 2.25) < 1e-12 &&
           pw85_contact(r12, sphere, flat, out) == PW85_ENOTPD && out[0] != out[0] &&
           pw85_contact_batch(1, nullptr, sphere, sphere, &mu2, nullptr) == PW85_EINVAL &&
           std::strcmp(pw85_version(), PW85_VERSION) == 0;
}

} // namespace

int main(int, char **argv)
{
    auto const problems = read_problems(argv[1]);
    bool const right = check_one_by_one(problems), right_many = check_many(problems);
    return check_rest() && right && right_many ? 0 : 1;
}
