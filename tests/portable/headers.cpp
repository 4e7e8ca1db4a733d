// SPDX-License-Identifier: BSD-3-Clause
// The headers over the contact problems. Usage: portable_headers PROBLEMS
#include <pw85/pw85.hpp>

#include "problems.hpp"

using namespace pw85_tests;

namespace {

pw85::SymmetricMatrix<double, 3> form(double const (&q)[6])
{
    return {q[0], q[1], q[2], q[3], q[4], q[5]};
}

} // namespace

int main(int, char **argv)
{
    Answers contacts("pw85::contact"), overlaps("pw85::overlap");
    for (Problem const &p : read_problems(argv[1])) {
        pw85::Vector<double, 3> const r12{p.r12[0], p.r12[1], p.r12[2]};
        auto const contact = pw85::contact(r12, form(p.q1), form(p.q2));
        contacts.add_contact(p, static_cast<int>(contact.status), contact.mu2);
        auto const overlap = pw85::overlap(r12, form(p.q1), form(p.q2));
        overlaps.add_overlap(p, static_cast<int>(overlap.status), overlap.overlap);
    }
    bool const right = contacts.summarize();
    return overlaps.summarize() && right ? 0 : 1;
}
