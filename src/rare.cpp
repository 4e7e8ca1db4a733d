// The one instance of the tiers that hardly ever run (PW85_RARE): the headers declare them, and define them for programs that have no
// library.
#include <pw85/contact/contact_factored.hpp>
#include <pw85/distance/distance_derivatives.hpp>
#include <pw85/overlap/contact_rounded.hpp>
#include <pw85/overlap/exact_containment.hpp>
#include <pw85/overlap/exact_factored.hpp>
#include <pw85/overlap/witness.hpp>
#include <pw85/shapes/exact_polytope.hpp>
#include <pw85/shapes/exact_shapes.hpp>

#define PW85_INSTANTIATE(functions) functions(, double, 2) functions(, double, 3)
#define PW85_INSTANTIATE_IN_SPACE(functions) functions(, double)

namespace pw85::detail {

PW85_INSTANTIATE(PW85_RARE_DEFINITE)
PW85_INSTANTIATE(PW85_RARE_SOLVER)
PW85_INSTANTIATE(PW85_RARE_GEOMETRY)
PW85_INSTANTIATE(PW85_RARE_FACTORED)
PW85_INSTANTIATE(PW85_RARE_DISTANCE)
PW85_INSTANTIATE(PW85_RARE_EXACT)
PW85_INSTANTIATE(PW85_RARE_EXACT_FACTORED)
PW85_INSTANTIATE(PW85_RARE_EXACT_CONTAINMENT)
PW85_INSTANTIATE(PW85_RARE_ROUNDED)
PW85_INSTANTIATE(PW85_RARE_WITNESS)
PW85_INSTANTIATE_IN_SPACE(PW85_RARE_DISTANCE_DERIVATIVES)
PW85_INSTANTIATE_IN_SPACE(PW85_RARE_EXACT_SHAPES)
PW85_INSTANTIATE_IN_SPACE(PW85_RARE_EXACT_POLYTOPE)

} // namespace pw85::detail
