// SPDX-License-Identifier: GPL-2.0-only
// Asks the fixes with rigid bodies for the masses of these.
#include "body_masses.hpp"

using namespace LAMMPS_NS;

namespace pw85_lammps {

void BodyMasses::start_run()
{
    fixes_.clear();
    for (int k = 0; k < modify->nfix; ++k)
        if (modify->fix[k]->rigid_flag) fixes_.push_back(modify->fix[k]);
}

void BodyMasses::read()
{
    masses_.assign(atom->rmass, atom->rmass + atom->nlocal);
    masses_.resize(static_cast<std::size_t>(atom->nlocal + atom->nghost));
    for (Fix *const fix : fixes_) {
        int dimension = 0;
        auto const *const bodies = static_cast<int const *>(fix->extract("body", dimension));
        auto const *const masses =
            static_cast<double const *>(fix->extract("masstotal", dimension));
        if (!bodies || !masses) continue;
        for (int i = 0; i < atom->nlocal; ++i)
            if (bodies[i] >= 0) masses_[static_cast<std::size_t>(i)] = masses[bodies[i]];
    }
}

int BodyMasses::pack(int count, int const *atoms, double *buffer) const
{
    for (int k = 0; k < count; ++k) buffer[k] = masses_[static_cast<std::size_t>(atoms[k])];
    return count;
}

void BodyMasses::unpack(int count, int first, double const *buffer)
{
    for (int k = 0; k < count; ++k) masses_[static_cast<std::size_t>(first + k)] = buffer[k];
}

} // namespace pw85_lammps
