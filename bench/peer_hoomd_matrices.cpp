// SPDX-License-Identifier: BSD-3-Clause
// The overlap test of HOOMD-blue 2 for ellipsoids (hoomd/hpmc/ShapeEllipsoid.h) alone, on matrices
// that are ready, in double. For side_by_side.cpp.
//
// This file is compiled without the mixed precision of peer_hoomd.cpp. It calls no member function
// of HOOMD's shapes, because those have the same names with either precision.
#include <array>
#include <vector>

#include "hoomd_shapes.hpp"
#include "peer.hpp"

namespace {

using pw85_bench::HoomdShape;
static_assert(std::is_same_v<hpmc::OverlapReal, double>);

class PeerHoomdMatrices final : public pw85_bench::Peer {
  public:
    void take(pw85_bench::Rows rows) override
    {
        pairs_.clear();
        for (std::size_t i = 0; i < rows.n; ++i) {
            double const *r = rows.r12 + 3 * i;
            pairs_.push_back({matrix(rows.q1 + 6 * i, vec3<double>(0, 0, 0)),
                              matrix(rows.q2 + 6 * i, vec3<double>(r[0], r[1], r[2]))});
        }
    }
    /// A pair that the test cannot decide counts as no overlap, as in HOOMD-blue. The test reads
    /// the matrices only.
    void decide(std::size_t begin, std::size_t end, unsigned char *overlap) const override
    {
        for (std::size_t i = begin; i < end; ++i) {
            Pair &pair = pairs_[i];
            overlap[i] = hpmc::detail::test_overlap_ellipsoids(
                             pair.first.data(), pair.second.data()) == ELLIPSOID_OVERLAP_TRUE;
        }
    }

  private:
    using Matrix = std::array<double, 10>;
    struct Pair {
        Matrix first, second;
    };

    static Matrix matrix(double const *q, vec3<double> const &center)
    {
        HoomdShape const shape(q);
        Matrix result;
        hpmc::detail::compute_ellipsoid_matrix(result.data(), center, shape.orientation,
                                               shape.lengths);
        return result;
    }

    mutable std::vector<Pair> pairs_;
};

} // namespace

std::unique_ptr<pw85_bench::Peer> pw85_bench::peer_hoomd_matrices()
{
    return std::make_unique<PeerHoomdMatrices>();
}
