// Periodic cells in the C API.
#include <pw85.h>

#include <algorithm>
#include <cmath>

#include <pw85/bounding_box.hpp>

#include "../c_arrays.hpp"
#include "lattice.hpp"
#include "parallel.hpp"

using namespace pw85;
using namespace pw85::batch;
using pw85::c_api::any_null;

namespace {

/// The largest vᵀQv/|v|⁴ over the faces of the lattice's Voronoi cell, half-way to vectors v. (Any other lattice vector gives no
/// more: v/|v|² is in the hull of those of the faces.)
double largest_width(Lattice const &lattice, SymmetricMatrix<double, 3> const &q) noexcept
{
    double largest = 0.0;
    auto const try_vector = [&](Vector<double, 3> const &v) {
        largest = std::max(largest, quadratic_form(q, times(1.0 / dot(v, v), v)));
    };
    for (auto const &v : lattice.basis) try_vector(c_api::load_vector<3>(v));
    for (int k = 0; k < lattice.num_shifts; ++k)
        try_vector({lattice.shift[0][k], lattice.shift[1][k], lattice.shift[2][k]});
    return largest;
}

} // namespace

int pw85_cell_reduce(double const cell[9], double reduced[9])
{
    if (any_null(reduced)) return PW85_EINVAL;
    if (!any_null(cell) && reduce(cell, reduced)) return PW85_SUCCESS;
    c_api::store_nan(reduced, 9);
    return PW85_EINVAL;
}

// An image that is not the nearest has r·v >= ½|v|² for a face v. μ is the maximum of r·n over the sum of the two half-widths along
// n, √(nᵀQ1n) + √(nᵀQ2n), for any n: so it is at least ¼|v|²/√(vᵀQv), Q the wider of the two along v.
int pw85_nearest_image_limit(size_t n, double const *q, double const *cell, double *mu2)
{
    if (any_null(mu2)) return PW85_EINVAL;
    *mu2 = quiet_nan<double>();
    Lattice lattice;
    if (n > max_rows || any_null(cell) || (n > 0 && any_null(q)) || !prepare(cell, lattice)) return PW85_EINVAL;
    double largest = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        auto const form = c_api::load_matrix<3>(q + 6 * i);
        if (Status const status = validate(form); status != Status::success) return static_cast<int>(status);
        largest = std::max(largest, largest_width(lattice, form));
    }
    *mu2 = largest > 0.0 ? 0.0625 / largest : HUGE_VAL;
    return PW85_SUCCESS;
}
