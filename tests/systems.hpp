// SPDX-License-Identifier: BSD-3-Clause
// Makes systems and lists of pairs as arguments of the C API. Their arrays must live as long as the
// call.
#ifndef PW85_TESTS_SYSTEMS_HPP_INCLUDED
#define PW85_TESTS_SYSTEMS_HPP_INCLUDED

#include <pw85_systems.h>

namespace pw85_tests {

struct SystemArgument : pw85_system {
    operator pw85_system const *() const { return this; }
};

struct PairListArgument : pw85_pair_list {
    operator pw85_pair_list const *() const { return this; }
};

/// Periodic along the second vector of the cell, too, unless `open`.
inline SystemArgument system_of(size_t num_particles, double const *centers, double const *q,
                                double const *cell, bool open = false)
{
    return {{num_particles, centers, q, cell, {1, open ? 0 : 1, 1}}};
}

inline PairListArgument list_of(size_t num_pairs, int32_t const *pairs,
                                int32_t const *images = nullptr)
{
    return {{num_pairs, pairs, images}};
}

} // namespace pw85_tests

#endif
