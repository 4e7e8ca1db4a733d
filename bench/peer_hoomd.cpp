// SPDX-License-Identifier: BSD-3-Clause
// The overlap test of HOOMD-blue 2 for ellipsoids (hoomd/hpmc/ShapeEllipsoid.h) as its simulations
// call it: from semi-axes and quaternions, with their mixed precision. For side_by_side.cpp.
#include <vector>

#include "hoomd_shapes.hpp"
#include "peer.hpp"

namespace {

using pw85_bench::HoomdShape;

hpmc::ShapeEllipsoid shape(double const *q)
{
    HoomdShape const made(q);
    return {made.orientation, made.lengths};
}

class PeerHoomd final : public pw85_bench::Peer {
  public:
    void take(pw85_bench::Rows rows) override
    {
        pairs_.clear();
        for (std::size_t i = 0; i < rows.n; ++i) {
            double const *r = rows.r12 + 3 * i;
            pairs_.push_back(
                {shape(rows.q1 + 6 * i), shape(rows.q2 + 6 * i), vec3<Scalar>(r[0], r[1], r[2])});
        }
    }
    /// If the test cannot decide, it counts an error and reports no overlap.
    void decide(std::size_t begin, std::size_t end, unsigned char *overlap) const override
    {
        unsigned int errors = 0;
        for (std::size_t i = begin; i < end; ++i)
            overlap[i] =
                hpmc::test_overlap(pairs_[i].r12, pairs_[i].first, pairs_[i].second, errors);
    }

  private:
    struct Pair {
        hpmc::ShapeEllipsoid first, second;
        vec3<Scalar> r12;
    };
    std::vector<Pair> pairs_;
};

} // namespace

std::unique_ptr<pw85_bench::Peer> pw85_bench::peer_hoomd() { return std::make_unique<PeerHoomd>(); }
