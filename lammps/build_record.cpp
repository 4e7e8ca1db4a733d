// SPDX-License-Identifier: GPL-2.0-only
// The record of a build: the positions as fractions of the box, and their comparison with the
// present positions.
#include "build_record.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace LAMMPS_NS;

namespace pw85_lammps {

namespace {

/// The name is in capitals, which LAMMPS uses for styles that input scripts cannot use.
constexpr char style_name[] = "PW85/BUILD";

Fix *create(LAMMPS *lammps, int narg, char **arg) { return new BuildRecord(lammps, narg, arg); }

/// Returns the Frobenius norm of (A - B) B⁻¹, for upper triangular matrices (xx, yy, zz, yz, xz,
/// xy).
double strain(double const *a, double const *b, double const *g)
{
    std::array<double, 6> d{};
    std::transform(a, a + 6, b, d.begin(), [](double x, double y) { return x - y; });
    double const entries[] = {d[0] * g[0],
                              d[1] * g[1],
                              d[2] * g[2],
                              d[1] * g[3] + d[3] * g[2],
                              d[0] * g[4] + d[5] * g[3] + d[4] * g[2],
                              d[0] * g[5] + d[5] * g[1]};
    double sum = 0.0;
    for (double const entry : entries) sum += entry * entry;
    return std::sqrt(sum);
}

} // namespace

BuildRecord::BuildRecord(LAMMPS *lammps, int narg, char **arg) : Fix(lammps, narg, arg) {}

void BuildRecord::add(Modify &modify, std::string const &id)
{
    (*modify.fix_map)[style_name] = create;
    modify.add_fix(id + " all " + style_name);
}

int BuildRecord::setmask() { return FixConst::PRE_NEIGHBOR | FixConst::MIN_PRE_NEIGHBOR; }

void BuildRecord::pre_neighbor()
{
    num_owned_ = atom->nlocal;
    num_ghosts_ = atom->nghost;
    fractions_.resize(3 * static_cast<std::size_t>(num_owned_));
    for (int i = 0; i < num_owned_; ++i)
        domain->x2lamda(atom->x[i], &fractions_[3 * static_cast<std::size_t>(i)]);
    std::copy_n(domain->h, 6, box_.begin());
    std::copy_n(domain->h_inv, 6, box_inverse_.begin());
}

Movement BuildRecord::movement() const
{
    double const own = own_displacement();
    double largest = 0.0;
    MPI_Allreduce(&own, &largest, 1, MPI_DOUBLE, MPI_MAX, world);
    return {strain(domain->h, box_.data(), box_inverse_.data()), largest};
}

double BuildRecord::own_displacement() const
{
    if (atom->nlocal != num_owned_ || atom->nghost != num_ghosts_)
        return std::numeric_limits<double>::infinity();
    // This is domain->lamda2x() in a loop that compilers can vectorise.
    std::array<double, 6> h{};
    std::copy_n(domain->h, 6, h.begin());
    double const x0 = domain->boxlo[0], y0 = domain->boxlo[1], z0 = domain->boxlo[2];
    double const *s = fractions_.data(), *x = num_owned_ > 0 ? atom->x[0] : nullptr;
    double largest = 0.0;
    for (int i = 0; i < num_owned_; ++i, s += 3, x += 3) {
        double const dx = x[0] - (h[0] * s[0] + h[5] * s[1] + h[4] * s[2] + x0);
        double const dy = x[1] - (h[1] * s[1] + h[3] * s[2] + y0);
        double const dz = x[2] - (h[2] * s[2] + z0);
        largest = std::max(largest, dx * dx + dy * dy + dz * dz);
    }
    return std::sqrt(largest);
}

double BuildRecord::memory_usage()
{
    return static_cast<double>(fractions_.capacity() * sizeof(double));
}

} // namespace pw85_lammps
