// SPDX-License-Identifier: BSD-3-Clause
// The contact function of pw85 2.0 for side_by_side.cpp. Its header defines functions with the
// names of this library, so that it needs a translation unit of its own.
#include <limits>

#include <pw85/pw85.hpp>

#include "peer.hpp"

namespace {

class Peer2 final : public pw85_bench::Peer {
  public:
    void take(pw85_bench::Rows rows) override { rows_ = rows; }
    void decide(std::size_t begin, std::size_t end, unsigned char *overlap) const override
    {
        for (std::size_t i = begin; i < end; ++i) {
            double out[2];
            pw85::contact_function(rows_.r12 + 3 * i, rows_.q1 + 6 * i, rows_.q2 + 6 * i, out);
            overlap[i] = out[0] < 1.0;
        }
    }

  private:
    pw85_bench::Rows rows_{};
};

} // namespace

std::unique_ptr<pw85_bench::Peer> pw85_bench::peer_pw85_2() { return std::make_unique<Peer2>(); }
