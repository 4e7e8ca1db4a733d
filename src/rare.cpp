// SPDX-License-Identifier: BSD-3-Clause
// The one instance for doubles of the tiers that hardly ever run. Arguments are references, so that each function is a jump into its
// template.
#include <pw85/contact/contact_factored.hpp>
#include <pw85/distance/distance_derivatives.hpp>
#include <pw85/distance/hertz.hpp>
#include <pw85/motion/closest_passage.hpp>
#include <pw85/overlap/contact_rounded.hpp>
#include <pw85/overlap/containment_factor.hpp>
#include <pw85/overlap/exact_containment.hpp>
#include <pw85/overlap/exact_factored.hpp>
#include <pw85/overlap/witness.hpp>
#include <pw85/shapes/exact_polytope.hpp>
#include <pw85/shapes/exact_shapes.hpp>
#include <pw85/shapes/triangle.hpp>
#include <pw85/volume/overlap_volume_derivatives.hpp>

#define PW85_RARE_DEFINED(name, parameters, arguments)                                                                 \
    auto name parameters noexcept->decltype(name<> arguments) { return name<> arguments; }
#define PW85_DEFINE(functions) functions(PW85_RARE_DEFINED, double, 2) functions(PW85_RARE_DEFINED, double, 3)
#define PW85_DEFINE_IN_SPACE(functions) functions(PW85_RARE_DEFINED, double)

namespace pw85::detail {

PW85_DEFINE(PW85_RARE_DEFINITE)
PW85_DEFINE(PW85_RARE_SOLVER)
PW85_DEFINE(PW85_RARE_GEOMETRY)
PW85_DEFINE(PW85_RARE_FACTORED)
PW85_DEFINE(PW85_RARE_DISTANCE)
PW85_DEFINE(PW85_RARE_EXACT)
PW85_DEFINE(PW85_RARE_EXACT_FACTORED)
PW85_DEFINE(PW85_RARE_EXACT_CONTAINMENT)
PW85_DEFINE(PW85_RARE_ROUNDED)
PW85_DEFINE(PW85_RARE_WITNESS)
PW85_DEFINE(PW85_RARE_GAUGE)
PW85_DEFINE(PW85_RARE_MEASURE)
PW85_DEFINE(PW85_RARE_RIM_FRAME)
PW85_DEFINE_IN_SPACE(PW85_RARE_DISTANCE_DERIVATIVES)
PW85_DEFINE_IN_SPACE(PW85_RARE_CURVATURE)
PW85_DEFINE_IN_SPACE(PW85_RARE_HERTZ)
PW85_DEFINE_IN_SPACE(PW85_RARE_PASSAGE)
PW85_DEFINE_IN_SPACE(PW85_RARE_RIM_INTEGRALS)
PW85_DEFINE_IN_SPACE(PW85_RARE_SEGMENT)
PW85_DEFINE_IN_SPACE(PW85_RARE_TRIANGLE)
PW85_DEFINE_IN_SPACE(PW85_RARE_EXACT_SHAPES)
PW85_DEFINE_IN_SPACE(PW85_RARE_EXACT_POLYTOPE)

} // namespace pw85::detail
