// SPDX-License-Identifier: BSD-3-Clause
// The overlap test of FCL with its default solver, libccd, for side_by_side.cpp.
#include <vector>

#include "fcl_bodies.hpp"
#include "peer.hpp"

namespace {

class PeerFcl final : public pw85_bench::Peer {
  public:
    void take(pw85_bench::Rows rows) override
    {
        bodies_.clear();
        for (std::size_t i = 0; i < rows.n; ++i)
            bodies_.emplace_back(rows.r12 + 3 * i, rows.q1 + 6 * i, rows.q2 + 6 * i);
    }
    void decide(std::size_t begin, std::size_t end, unsigned char *overlap) const override
    {
        for (std::size_t i = begin; i < end; ++i)
            overlap[i] = pw85_bench::fcl_collide(bodies_[i], fcl::GST_LIBCCD);
    }

  private:
    std::vector<pw85_bench::Bodies> bodies_;
};

} // namespace

std::unique_ptr<pw85_bench::Peer> pw85_bench::peer_fcl() { return std::make_unique<PeerFcl>(); }
