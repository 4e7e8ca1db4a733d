// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// Includes the headers of LAMMPS, and hides the differences between its versions. All files of
/// this folder include it.
#ifndef PW85_LAMMPS_HOST_HPP_INCLUDED
#define PW85_LAMMPS_HOST_HPP_INCLUDED

// The fmt on a machine may be newer than that for which the headers of LAMMPS were written. Release
// 9 of fmt removed a function that error.h names inside templates. The styles never use these
// templates, so a declaration of the name is enough.
#if __has_include(<lammps/fmt/format.h>)
#include <lammps/fmt/format.h>
#else
#include <fmt/format.h>
#endif
#if FMT_VERSION >= 90000
namespace fmt {
template <class... Args, class... Rest> void make_args_checked(Rest &&...) = delete;
}
#endif

#include <lammps/atom.h>
#include <lammps/comm.h>
#include <lammps/compute.h>
#include <lammps/domain.h>
#include <lammps/error.h>
#include <lammps/fix.h>
#include <lammps/force.h>
#include <lammps/group.h>
#include <lammps/input.h>
#include <lammps/memory.h>
#include <lammps/modify.h>
#include <lammps/neigh_list.h>
#include <lammps/neighbor.h>
#include <lammps/pair.h>
#include <lammps/pointers.h>
#include <lammps/region.h>
#include <lammps/update.h>
#include <lammps/utils.h>

#if __has_include(<lammps/atom_vec_ellipsoid.h>)
#include <lammps/atom_vec_ellipsoid.h>
#else
namespace LAMMPS_NS {
/// Installed headers lack this class. It derives from AtomVec alone, so both have one address. The
/// function is virtual in LAMMPS; its name for the linker is the same.
class AtomVecEllipsoid {
  public:
    void unpack_comm_bonus(int count, int first, double *buffer);
    void clear_bonus();
    void set_shape(int i, double a, double b, double c);
};
} // namespace LAMMPS_NS
#endif

#if __has_include(<lammps/atom_vec.h>)
#include <lammps/atom_vec.h>
#else
namespace LAMMPS_NS {
/// Replaces LAMMPS's class if its header is not installed.
class AtomVec {
  public:
    void create_atom(int type, double *x);
};
} // namespace LAMMPS_NS
#endif

#include <array>
#include <cstring>
#include <string>

namespace pw85_lammps {

/// Stops LAMMPS with a message. All processors call this together.
[[noreturn]] inline void stop_all(LAMMPS_NS::Error &error, std::string const &message,
                                  char const *file = __builtin_FILE(), int line = __builtin_LINE())
{
    error.all(file, line, message);
}

/// Stops LAMMPS with a message. Any processor may call this alone.
[[noreturn]] inline void stop_one(LAMMPS_NS::Error &error, std::string const &message,
                                  char const *file = __builtin_FILE(), int line = __builtin_LINE())
{
    error.one(file, line, message);
}

/// Stops LAMMPS if the forces of different pairs have different time steps. All processors call
/// this together.
inline void refuse_respa(LAMMPS_NS::LAMMPS &lammps, std::string const &style)
{
    if (std::string(lammps.update->integrate_style).rfind("respa", 0) == 0)
        stop_all(*lammps.error,
                 style + " does not work with run_style respa: use run_style verlet");
}

/// Sends per-atom values from owners to ghosts; `Owner` is a Pair, a Fix or a Compute. Releases of
/// LAMMPS from 2022 on overload one name; earlier ones have one name for each kind of owner.
template <class Communicator, class Owner> void forward_to_ghosts(Communicator &comm, Owner *owner)
{
    if constexpr (requires { comm.forward_comm(owner); }) {
        comm.forward_comm(owner);
    } else if constexpr (requires(LAMMPS_NS::Pair * &pair) { pair = owner; }) {
        comm.forward_comm_pair(owner);
    } else if constexpr (requires(LAMMPS_NS::Fix * &fix) { fix = owner; }) {
        comm.forward_comm_fix(owner);
    } else {
        comm.forward_comm_compute(owner);
    }
}

/// Sends per-atom values from ghosts back to their owners; `Owner` is a Fix or a Compute.
template <class Communicator, class Owner> void reverse_to_owners(Communicator &comm, Owner *owner)
{
    if constexpr (requires { comm.reverse_comm(owner); }) {
        comm.reverse_comm(owner);
    } else if constexpr (requires(LAMMPS_NS::Fix * &fix) { fix = owner; }) {
        comm.reverse_comm_fix(owner);
    } else {
        comm.reverse_comm_compute(owner);
    }
}

/// Sends rows of different lengths from ghosts back to their owners. LAMMPS cannot do this with
/// `comm_style tiled`.
template <class Communicator> void reverse_rows_to_owners(Communicator &comm, LAMMPS_NS::Fix *owner)
{
    if constexpr (requires { comm.reverse_comm_variable(owner); }) {
        comm.reverse_comm_variable(owner);
    } else {
        comm.reverse_comm_fix_variable(owner);
    }
}

/// Returns whether atoms of style ellipsoid may be superellipsoids. Releases of LAMMPS from March
/// 2026 on have these.
template <class Atoms> bool has_superellipsoids(Atoms const &atom)
{
    if constexpr (requires { atom.superellipsoid_flag; }) return atom.superellipsoid_flag != 0;
    return false;
}

/// Sets the quaternions (w, i, j, k) of all owned atoms, which must have shapes. The function by
/// which LAMMPS unpacks the quaternions of ghosts is the only one that does not change them.
inline void set_quaternions(LAMMPS_NS::Atom &atom, double *quaternions)
{
    auto *const style =
        reinterpret_cast<LAMMPS_NS::AtomVecEllipsoid *>(atom.style_match("ellipsoid"));
    style->unpack_comm_bonus(atom.nlocal, 0, quaternions);
}

/// Forgets the ghosts. Afterwards atoms can be added.
inline void forget_ghosts(LAMMPS_NS::Atom &atom)
{
    atom.nghost = 0;
    reinterpret_cast<LAMMPS_NS::AtomVecEllipsoid *>(atom.style_match("ellipsoid"))->clear_bonus();
}

/// Adds an atom to those of this processor, which has no ghosts.
inline void create_ellipsoid(LAMMPS_NS::Atom &atom, int type, std::array<double, 3> x,
                             std::array<double, 3> const &semi_axes,
                             std::array<double, 4> quaternion)
{
    auto *const style =
        reinterpret_cast<LAMMPS_NS::AtomVecEllipsoid *>(atom.style_match("ellipsoid"));
    atom.avec->create_atom(type, x.data());
    style->set_shape(atom.nlocal - 1, semi_axes[0], semi_axes[1], semi_axes[2]);
    style->unpack_comm_bonus(1, atom.nlocal - 1, quaternion.data());
}

/// Returns the region with an ID, or null. Releases of LAMMPS from 2022 on have another name for
/// this.
template <class Domain> LAMMPS_NS::Region *find_region(Domain &domain, std::string const &id)
{
    if constexpr (requires { domain.get_region_by_id(id); }) {
        return domain.get_region_by_id(id);
    } else {
        int const index = domain.find_region(id);
        return index < 0 ? nullptr : domain.regions[index];
    }
}

/// The command of the input script that LAMMPS works on. In some releases its name is a protected
/// member, which a derived class may read.
struct CurrentCommand : LAMMPS_NS::Input {
    static char const *name(LAMMPS_NS::Input const &input)
    {
        return input.*(&CurrentCommand::command);
    }
};

/// Returns whether LAMMPS takes the states of the atoms from a file, one after the other.
inline bool is_rerun(LAMMPS_NS::Input const &input)
{
    char const *const name = CurrentCommand::name(input);
    return name && std::strcmp(name, "rerun") == 0;
}

} // namespace pw85_lammps

#endif
