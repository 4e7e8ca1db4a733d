// SPDX-License-Identifier: BSD-3-Clause
// The functions of the C API for periodic cells: the reduced cell (lattice.hpp), and the limit up
// to which nearest images suffice (image_limit.hpp).
#include <pw85.h>
#include <pw85_systems.h>

#include <pw85/distance/bounding_box.hpp>

#include "../base/c_arrays.hpp"
#include "../base/last_error.hpp"
#include "../base/parallel.hpp"
#include "../lists/arguments.hpp"
#include "../lists/image_limit.hpp"
#include "../periodic/lattice.hpp"
#include "../periodic/periodic_cell.hpp"

using namespace pw85;
using namespace pw85::detail;
using namespace pw85::detail::kernels;
using pw85::detail::c_api::any_null;

namespace {

int nearest_image_limit(pw85_system const &system, double *mu2) noexcept
{
    Lattice lattice;
    if (!prepare(system.cell, system.periodic, lattice))
        return refuse_cell("pw85_nearest_image_limit", system.cell, system.periodic);
    double largest = 0.0;
    for (std::size_t i = 0; i < system.num_particles; ++i) {
        auto const form = c_api::load_matrix<3>(system.q + 6 * i);
        if (Status const status = validate(form); status != Status::success)
            return refuse_row(refuse_call(static_cast<int>(status), "pw85_nearest_image_limit",
                                          Argument("q", system.q + 6 * i, 6, limit::definite)),
                              i);
        largest = maximum(largest, largest_relative_width(lattice, form));
    }
    *mu2 = largest > 0.0 ? relative_width_limit / largest : infinity<double>();
    return PW85_SUCCESS;
}

} // namespace

int pw85_cell_reduce(double const cell[9], double reduced[9])
{
    if (any_null(reduced))
        return refuse_call(PW85_EINVAL, "pw85_cell_reduce", Argument("reduced", reduced));
    if (!any_null(cell) && in_default_environment([&] { return reduce(cell, reduced); }))
        return PW85_SUCCESS;
    c_api::store_nan(reduced, 9);
    return refuse_call(PW85_EINVAL, "pw85_cell_reduce",
                       Argument("cell", cell, 9, limit::independent_rows));
}

int pw85_nearest_image_limit(pw85_system const *system, double *mu2)
{
    if (any_null(mu2))
        return refuse_call(PW85_EINVAL, "pw85_nearest_image_limit", Argument("mu2", mu2));
    *mu2 = quiet_nan<double>();
    if (any_null(system))
        return refuse_call(PW85_EINVAL, "pw85_nearest_image_limit", Argument("system", system));
    if (any_null(system->cell) || (system->num_particles > 0 && any_null(system->q)))
        return refuse_call(PW85_EINVAL, "pw85_nearest_image_limit", Argument("cell", system->cell),
                           Argument("q", system->q));
    if (system->num_particles > max_rows) return refuse_size("pw85_nearest_image_limit", *system);
    return in_default_environment([&] { return nearest_image_limit(*system, mu2); });
}
