// SPDX-License-Identifier: BSD-3-Clause
// Makes neighbour lists while each allocation in turn fails: there is an error, no list, and no
// leak (which the sanitizers would find).
#include <cstddef>
#include <vector>

#include <glib.h>

#include <pw85/systems.hpp>

#include "../cases.hpp"
#include "../random_pairs.hpp"
#include "../refused_memory.hpp"

using pw85_tests::granted;

namespace {

PW85_TEST("/neighbors_memory/refused")
{
    pw85_tests::Random random(111);
    std::vector<pw85::Vector<double, 3>> centers;
    std::vector<pw85::SymmetricMatrix<double, 3>> q;
    for (int i = 0; i < 3000; ++i) {
        centers.push_back(
            {random.uniform(0.0, 9.0), random.uniform(0.0, 9.0), random.uniform(0.0, 9.0)});
        q.push_back(random.form(1.0, 3.0));
    }
    pw85::Cell const cell{{{9.0, 0.0, 0.0}, {0.0, 9.0, 0.0}, {0.0, 0.0, 9.0}}};
    long refused = 0;
    for (;; ++refused) {
        pw85::Neighbors list;
        granted = refused;
        pw85::Status const status = neighbors_create({centers, q, &cell}, {}, list);
        if (granted >= 0) { // the request to be refused was not made
            g_assert_true(status == pw85::Status::success);
            g_assert_cmpuint(list.pairs().size(), >, 10000);
            break;
        }
        g_assert_true(status == pw85::Status::out_of_memory);
        g_assert_true(list.get() == nullptr);
    }
    g_assert_cmpint(refused, >=, 13);
}

} // namespace
