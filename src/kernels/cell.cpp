// Periodic cells in the C API.
#include <pw85.h>

#include <algorithm>
#include <cmath>

#include <pw85/bounding_box.hpp>

#include "../c_arrays.hpp"
#include "lattice.hpp"
#include "parallel.hpp"

using namespace pw85;
using namespace pw85::kernels;
using pw85::c_api::any_null;

namespace {

/// The largest vᵀQv/|v|⁴ over the faces of a lattice's Voronoi cell, half-way to vectors v: see item 3 of lattice.hpp. (Other vectors
/// give no more: v/|v|² is in the hull of those of the faces.)
double largest_width(Lattice const &lattice, SymmetricMatrix<double, 3> const &q) noexcept
{
    double largest = 0.0;
    for (int n = 1; n <= 13; ++n) { // coordinates -1, 0 or 1; one of each ± couple
        int const a = (n + 13) / 9 - 1, b = (n + 13) / 3 % 3 - 1, c = (n + 13) % 3 - 1;
        Vector<double, 3> v;
        for (int d = 0; d < 3; ++d) v[d] = a * lattice.basis[0][d] + b * lattice.basis[1][d] + c * lattice.basis[2][d];
        largest = std::max(largest, quadratic_form(q, times(1.0 / dot(v, v), v)));
    }
    return largest;
}

// An image that is not the nearest has r·v >= ½|v|² for a face v. μ is the maximum of r·n over the sum of the two half-widths along
// n, √(nᵀQ1n) + √(nᵀQ2n), for any n: so it is at least ¼|v|²/√(vᵀQv), Q the wider of the two along v.
int nearest_image_limit(std::size_t n, double const *q, double const *cell, double *mu2) noexcept
{
    Lattice lattice;
    if (!prepare(cell, lattice)) return PW85_EINVAL;
    double largest = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        auto const form = c_api::load_matrix<3>(q + 6 * i);
        if (Status const status = validate(form); status != Status::success) return static_cast<int>(status);
        largest = std::max(largest, largest_width(lattice, form));
    }
    *mu2 = largest > 0.0 ? 0.0625 / largest : HUGE_VAL;
    return PW85_SUCCESS;
}

} // namespace

int pw85_cell_reduce(double const cell[9], double reduced[9])
{
    if (any_null(reduced)) return PW85_EINVAL;
    DefaultEnvironment const environment;
    if (!any_null(cell) && reduce(cell, reduced)) return PW85_SUCCESS;
    c_api::store_nan(reduced, 9);
    return PW85_EINVAL;
}

int pw85_nearest_image_limit(size_t n, double const *q, double const *cell, double *mu2)
{
    if (any_null(mu2)) return PW85_EINVAL;
    *mu2 = quiet_nan<double>();
    if (n > max_rows || any_null(cell) || (n > 0 && any_null(q))) return PW85_EINVAL;
    return in_default_environment([&] { return nearest_image_limit(n, q, cell, mu2); });
}
