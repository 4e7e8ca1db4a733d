// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// Registers the styles with LAMMPS: as a plugin, or by a call of pw85_lammps_register() if LAMMPS
/// was built without plugins.
#include "compute_contact.hpp"
#include "compute_grains.hpp"
#include "compute_order.hpp"
#include "compute_overlap.hpp"
#include "compute_pressure.hpp"
#include "fix_fire.hpp"
#include "fix_heat.hpp"
#include "fix_hpmc.hpp"
#include "fix_pour.hpp"
#include "fix_wall.hpp"
#include "pair_contact.hpp"
#include "pair_granular.hpp"
#include "pair_hard.hpp"

#include <pw85/version.h>

using namespace LAMMPS_NS;

namespace {

template <class Style> Compute *create_compute(LAMMPS *lammps, int narg, char **arg)
{
    return new Style(lammps, narg, arg);
}

template <class Style> Fix *create_fix(LAMMPS *lammps, int narg, char **arg)
{
    return new Style(lammps, narg, arg);
}

template <class Style> Pair *create_pair(LAMMPS *lammps) { return new Style(lammps); }

/// The C interface of plugins, as published in lammpsplugin.h (which LAMMPS does not install).
struct Plugin {
    char const *version, *style, *name, *info, *author;
    void *creator, *handle;
};

struct Entry {
    char const *style, *name;
    void *creator;
};

using RegisterPlugin = void (*)(Plugin *, void *);

} // namespace

#define PW85_LAMMPS_API extern "C" __attribute__((visibility("default")))

/// Adds the styles to a running LAMMPS, given as the pointer that its Python module and its C
/// library pass around.
PW85_LAMMPS_API void pw85_lammps_register(void *lammps)
{
    auto *const lmp = static_cast<LAMMPS *>(lammps);
    (*lmp->modify->compute_map)["pw85/overlap"] = create_compute<pw85_lammps::ComputeOverlap>;
    (*lmp->modify->compute_map)["pw85/contact"] = create_compute<pw85_lammps::ComputeContact>;
    (*lmp->modify->compute_map)["pw85/grains"] = create_compute<pw85_lammps::ComputeGrains>;
    (*lmp->modify->compute_map)["pw85/order"] = create_compute<pw85_lammps::ComputeOrder>;
    (*lmp->modify->compute_map)["pw85/pressure"] = create_compute<pw85_lammps::ComputePressure>;
    (*lmp->modify->fix_map)["pw85/fire"] = create_fix<pw85_lammps::FixFire>;
    (*lmp->modify->fix_map)["pw85/heat"] = create_fix<pw85_lammps::FixHeat>;
    (*lmp->modify->fix_map)["pw85/hpmc"] = create_fix<pw85_lammps::FixHpmc>;
    (*lmp->modify->fix_map)["pw85/pour"] = create_fix<pw85_lammps::FixPour>;
    (*lmp->modify->fix_map)["wall/pw85"] = create_fix<pw85_lammps::FixWall>;
    (*lmp->force->pair_map)["pw85/contact"] = create_pair<pw85_lammps::PairContact>;
    (*lmp->force->pair_map)["pw85/granular"] = create_pair<pw85_lammps::PairGranular>;
    (*lmp->force->pair_map)["pw85/hard"] = create_pair<pw85_lammps::PairHard>;
}

/// The entry point of `plugin load`. It states no version of LAMMPS, because the installed headers
/// do not contain it.
PW85_LAMMPS_API void lammpsplugin_init(void *lammps, void *handle, void *register_function)
{
    auto const add = reinterpret_cast<RegisterPlugin>(register_function);
    auto const info = "contact function of ellipsoids, pw85 " PW85_VERSION;
    auto const author = "the authors of pw85";
    using namespace pw85_lammps;
    Entry const entries[] = {
        {"compute", "pw85/overlap", reinterpret_cast<void *>(create_compute<ComputeOverlap>)},
        {"compute", "pw85/contact", reinterpret_cast<void *>(create_compute<ComputeContact>)},
        {"compute", "pw85/grains", reinterpret_cast<void *>(create_compute<ComputeGrains>)},
        {"compute", "pw85/order", reinterpret_cast<void *>(create_compute<ComputeOrder>)},
        {"compute", "pw85/pressure", reinterpret_cast<void *>(create_compute<ComputePressure>)},
        {"fix", "pw85/fire", reinterpret_cast<void *>(create_fix<FixFire>)},
        {"fix", "pw85/heat", reinterpret_cast<void *>(create_fix<FixHeat>)},
        {"fix", "pw85/hpmc", reinterpret_cast<void *>(create_fix<FixHpmc>)},
        {"fix", "pw85/pour", reinterpret_cast<void *>(create_fix<FixPour>)},
        {"fix", "wall/pw85", reinterpret_cast<void *>(create_fix<FixWall>)},
        {"pair", "pw85/contact", reinterpret_cast<void *>(create_pair<PairContact>)},
        {"pair", "pw85/granular", reinterpret_cast<void *>(create_pair<PairGranular>)},
        {"pair", "pw85/hard", reinterpret_cast<void *>(create_pair<PairHard>)},
    };
    for (auto const &[style, name, creator] : entries) {
        Plugin plugin{nullptr, style, name, info, author, creator, handle};
        add(&plugin, lammps);
    }
}
