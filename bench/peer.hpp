// SPDX-License-Identifier: BSD-3-Clause
// The interface by which side_by_side.cpp calls the overlap test of another library. It includes
// nothing of pw85, because pw85 2.0 uses the same names.
#ifndef PW85_BENCH_PEER_HPP_INCLUDED
#define PW85_BENCH_PEER_HPP_INCLUDED

#include <cstddef>
#include <memory>

namespace pw85_bench {

/// Pairs in contiguous arrays, n×3, n×6 and n×6.
struct Rows {
    std::size_t n;
    double const *r12, *q1, *q2;
};

class Peer {
  public:
    virtual ~Peer() = default;
    /// Converts the pairs for the library. The arrays must stay valid.
    virtual void take(Rows) = 0;
    /// Writes 1 for pairs that overlap according to the library, otherwise 0, for a range of pairs.
    /// This call is timed.
    virtual void decide(std::size_t begin, std::size_t end, unsigned char *overlap) const = 0;
};

std::unique_ptr<Peer> peer_pw85_2();
std::unique_ptr<Peer> peer_hoomd();
std::unique_ptr<Peer> peer_hoomd_matrices();
std::unique_ptr<Peer> peer_fcl();

} // namespace pw85_bench

#endif
