// SPDX-License-Identifier: BSD-3-Clause
// What many functions call, and no caller inlines: how a remote pair is reached. It is compiled for
// the instruction sets of the functions for one pair.
#define PW85_SHARED_HERE
#include <pw85/motion/approach.hpp>

#include "../define_shared.hpp"

namespace pw85::detail {
namespace PW85_BUILDING {

PW85_DEFINE_SHARED(advance_until_spheres_meet, double, 3)

} // namespace PW85_BUILDING
} // namespace pw85::detail
