// SPDX-License-Identifier: BSD-3-Clause
// The bodies of pairs, for libraries whose ellipsoids have semi-axes and a place.
#ifndef PW85_BENCH_BODIES_HPP_INCLUDED
#define PW85_BENCH_BODIES_HPP_INCLUDED

#include <principal_axes.hpp>

#include "peer.hpp"

namespace pw85_bench {

/// Calls `add` with the principal axes and the centre of the two bodies of each pair in turn. The
/// first one is at the origin.
template <class Add> void for_each_body(std::vector<Forms> const &pairs, Add const &add)
{
    for (Forms const &pair : pairs) {
        add(PrincipalAxes(pair.q1), Eigen::Vector3d::Zero());
        add(PrincipalAxes(pair.q2), Eigen::Vector3d(pair.r12));
    }
}

} // namespace pw85_bench

#endif
