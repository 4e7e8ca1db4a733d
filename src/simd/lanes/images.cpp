// SPDX-License-Identifier: BSD-3-Clause
// Lanes: one ellipsoid of a simulation and images of others.
#include "chunks.hpp"

#include "images.hpp"

namespace pw85::detail::kernels::PW85_BUILDING {

[[gnu::flatten]] bool find_overlap_of_images(OneToImages const &rows, std::size_t n,
                                             Worklist &rejected_lanes) noexcept
{
    UndecidedList undecided;
    rejected_lanes.size = 0;
    return test_first(rows, n, undecided, rejected_lanes) ||
           (undecided.pairs.size > 0 && test_again(rows, n, undecided, rejected_lanes));
}

} // namespace pw85::detail::kernels::PW85_BUILDING
