// SPDX-License-Identifier: BSD-3-Clause
// The plane that separates an ellipsoid from one that moves, which free paths and event chains
// share (PW85_SHARED_BY_QUESTIONS, attributes.hpp).
#include <pw85/motion/free_path.hpp>

#include "../simd/define_shared.hpp"

namespace pw85::detail {
inline namespace PW85_SHARED_WITH {

PW85_DEFINE_SHARED(plane_of_translation, double, 3)
PW85_DEFINE_SHARED(plane_from_afar, double, 3)

} // namespace PW85_SHARED_WITH
} // namespace pw85::detail
