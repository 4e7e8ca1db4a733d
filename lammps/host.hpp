// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// Includes the headers of LAMMPS, and hides the differences between its versions. All files of this folder include it.
#ifndef PW85_LAMMPS_HOST_HPP_INCLUDED
#define PW85_LAMMPS_HOST_HPP_INCLUDED

// The fmt on a machine may be newer than that for which the headers of LAMMPS were written. Release 9 of fmt removed a function
// that error.h names inside templates. The styles never use these templates, so a declaration of the name is enough.
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
#include <lammps/memory.h>
#include <lammps/modify.h>
#include <lammps/neigh_list.h>
#include <lammps/neighbor.h>
#include <lammps/pair.h>
#include <lammps/pointers.h>
#include <lammps/update.h>
#include <lammps/utils.h>

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

/// Sends per-atom values from owners to ghosts; `Owner` is a Pair or a Compute. Releases of LAMMPS from 2022 on overload one name;
/// earlier ones have one name for each kind of owner.
template <class Communicator, class Owner> void forward_to_ghosts(Communicator &comm, Owner *owner)
{
    if constexpr (requires { comm.forward_comm(owner); }) {
        comm.forward_comm(owner);
    } else if constexpr (requires(LAMMPS_NS::Pair * &pair) { pair = owner; }) {
        comm.forward_comm_pair(owner);
    } else {
        comm.forward_comm_compute(owner);
    }
}

/// Sends per-atom values from ghosts back to their owners.
template <class Communicator> void reverse_to_owners(Communicator &comm, LAMMPS_NS::Compute *owner)
{
    if constexpr (requires { comm.reverse_comm(owner); }) {
        comm.reverse_comm(owner);
    } else {
        comm.reverse_comm_compute(owner);
    }
}

/// Sends rows of different lengths from ghosts back to their owners.
template <class Communicator> void reverse_rows_to_owners(Communicator &comm, LAMMPS_NS::Fix *owner)
{
    if constexpr (requires { comm.reverse_comm_variable(owner); }) {
        comm.reverse_comm_variable(owner);
    } else {
        comm.reverse_comm_fix_variable(owner);
    }
}

} // namespace pw85_lammps

#endif
