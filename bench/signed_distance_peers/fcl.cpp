// SPDX-License-Identifier: BSD-3-Clause
// FCL, as Drake runs it.
#include <fcl_bodies.hpp>

#include "peer.hpp"

namespace {

using namespace pw85_bench;

class Fcl final : public DistancePeer {
  public:
    void take(std::vector<Forms> const &pairs) override
    {
        bodies_.clear();
        for (Forms const &pair : pairs) bodies_.emplace_back(pair.r12, pair.q1, pair.q2);
    }
    Answer measure(std::size_t i) override
    {
        auto const found = fcl_signed_distance(bodies_[i]);
        if (!found) return {};
        return answer_of_points(found->min_distance, found->nearest_points[0],
                                found->nearest_points[1]);
    }

  private:
    std::vector<Bodies> bodies_;
};

} // namespace

std::unique_ptr<DistancePeer> pw85_bench::make_fcl() { return std::make_unique<Fcl>(); }
