// What side_by_side.cpp asks of a library: which pairs of a block overlap. Nothing of pw85 is included here, since version 2.0
// gave other things the same names.
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
    /// Makes of the pairs what the library takes; they stay where they are.
    virtual void take(Rows) = 0;
    /// 1 for pairs that the library says overlap, 0 for others, from one up to another. This is what is timed.
    virtual void decide(std::size_t begin, std::size_t end, unsigned char *overlap) const = 0;
};

std::unique_ptr<Peer> peer_pw85_2();
std::unique_ptr<Peer> peer_hoomd();
std::unique_ptr<Peer> peer_fcl();

} // namespace pw85_bench

#endif
