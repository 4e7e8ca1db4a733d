// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// Stores the springs of contacts. It keeps them when atoms move to other processors, and in restart files.
#ifndef PW85_LAMMPS_CONTACT_HISTORY_HPP_INCLUDED
#define PW85_LAMMPS_CONTACT_HISTORY_HPP_INCLUDED

#include "contact_law.hpp"
#include "host.hpp"
#include "vectors.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace pw85_lammps {

/// The springs of all contacts, by atom and the tag of its partner. It is a fix, because LAMMPS moves and saves only data of fixes.
///
/// In a step of a run, a contact is stored with the atom for which the neighbour list has the pair. complete() stores it with both
/// atoms, as each of them sees it. So the contact is found again after a new list, whichever atom has the pair then.
/// If an atom touches two periodic images of another one, the images share their springs. The normals are where the next search of the same
/// pair starts. They are neither moved nor saved.
class ContactHistory final : public LAMMPS_NS::Fix {
  public:
    ContactHistory(LAMMPS_NS::LAMMPS *lammps, int narg, char **arg);
    ~ContactHistory() override;

    /// Adds a history to the fixes of a running LAMMPS; its owner removes it.
    static ContactHistory *add(LAMMPS_NS::Modify &modify, std::string const &id);

    /// Starts a new step. find() then gives springs of the step before, until finish_step() replaces them by those that store() got.
    void start_step();

    /// A contact of an atom.
    struct Contact {
        LAMMPS_NS::tagint partner;
        int index; ///< of the partner while the neighbour list is that of the step, then -1
        Springs springs;
        Vector normal;
    };

    /// The contact of a pair in the step before, or null for a new one. Atom i is owned. The normal is valid if the index is j.
    Contact const *find(int i, int j) const;

    /// Stores the springs and the normal of a pair. The pairs of an atom i follow each other.
    void store(int i, int j, Springs const &springs, Vector const &normal);
    void finish_step();

    int setmask() override;
    void setup_pre_exchange() override { complete(); }
    void pre_exchange() override { complete(); }
    void min_pre_exchange() override { complete(); }
    void end_of_step() override;
    void post_run() override { complete(); }

    void grow_arrays(int nmax) override;
    void copy_arrays(int from, int to, int) override { rows_[index(to)] = rows_[index(from)]; }
    void set_arrays(int i) override { rows_[index(i)] = {}; }
    int pack_exchange(int i, double *buffer) override;
    int unpack_exchange(int i, double *buffer) override;
    int pack_restart(int i, double *buffer) override;
    void unpack_restart(int i, int which) override;
    int size_restart(int i) override;
    int maxsize_restart() override;
    int pack_reverse_comm_size(int count, int first) override;
    int pack_reverse_comm(int count, int first, double *buffer) override;
    void unpack_reverse_comm(int count, int *atoms, double *buffer) override;
    double memory_usage() override;

  private:
    /// A range of contacts_.
    struct Row {
        std::size_t first, count;
    };

    static constexpr int contact_size = 1 + Springs::size; ///< numbers that a message has for each contact

    static std::size_t index(int i) { return static_cast<std::size_t>(i); }
    void complete();
    void append(int i, std::vector<Contact> const &more, std::vector<Contact> &all);
    int longest_row() const;
    static double *write(Contact const &contact, double *buffer);
    static Contact read(double const *buffer);

    std::vector<Contact> contacts_, next_;
    std::vector<Row> rows_, next_rows_;          ///< by owned atom
    std::vector<std::vector<Contact>> mirrored_; ///< by owned atom and ghost, while complete() works
    bool is_complete_ = true;
    int num_atoms_ = 0; ///< owned atoms and ghosts of the step
};

} // namespace pw85_lammps

#endif
