// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// Stores the springs of contacts. It keeps them when atoms move to other processors, and in
/// restart files.
#ifndef PW85_LAMMPS_CONTACT_HISTORY_HPP_INCLUDED
#define PW85_LAMMPS_CONTACT_HISTORY_HPP_INCLUDED

#include "contact_law.hpp"
#include "host.hpp"
#include "vectors.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pw85_lammps {

/// The springs of all contacts. It is a fix, because LAMMPS moves and saves only data of fixes.
///
/// In a step of a run, each entry of the neighbour list can have a contact, which stays at its
/// place in memory while the list is the same. complete() stores the contacts by atom and tag of
/// the partner, once for each of both atoms. So a contact is found again in a new list, whichever
/// of the atoms has the pair there. If an atom touches two periodic images of another one, both
/// contacts get the springs of one of them in a new list. The normals are where the next search of
/// the same pair starts. They are neither moved nor saved. At the start of a run the stored tags
/// are updated, because commands may have changed the tags of atoms.
class ContactHistory final : public LAMMPS_NS::Fix {
  public:
    ContactHistory(LAMMPS_NS::LAMMPS *lammps, int narg, char **arg);
    ~ContactHistory() override;

    /// Adds a history to the fixes of a running LAMMPS; its owner removes it.
    static ContactHistory *add(LAMMPS_NS::Modify &modify, std::string const &id);

    /// Starts a new step. find() gives springs of the step before.
    ///
    /// @param turns whether a law has springs that roll or twist; others are not stored
    void start_step(LAMMPS_NS::NeighList const &list, bool turns);

    /// The springs of a contact that roll and twist.
    struct Turning {
        Vector rolling;
        double twisting;
    };

    /// A contact of two atoms, in a cache line.
    struct alignas(64) Contact {
        int i, j;
        Vector sliding, normal; ///< the normal is unknown if is_from_before()
    };

    /// Returns whether an entry of the list had a contact in the step before. This reads no
    /// contact, whose cache lines are many.
    bool has(std::uint32_t entry) const
    {
        std::uint32_t const place = places_[entry];
        return place < steps_.size() && steps_[place] >= step_;
    }

    /// Returns the contact of an entry of the list in the step before, or null for a new one.
    Contact const *find(std::uint32_t entry) const
    {
        return has(entry) ? &contacts_[places_[entry]] : nullptr;
    }

    /// Returns whether a contact comes from before the list.
    bool is_from_before(Contact const &contact) const { return steps_[place(contact)] == 0; }

    Turning turning(Contact const &contact) const
    {
        return turns_ ? turning_[place(contact)] : Turning{};
    }

    /// Stores the contact of an entry of the list, which has atoms i and j.
    void store(std::uint32_t entry, int i, int j, Springs const &springs, Vector const &normal)
    {
        if (places_[entry] == nowhere) places_[entry] = add_contact();
        std::uint32_t const place = places_[entry];
        contacts_[place] = {i, j, springs.sliding, normal};
        steps_[place] = step_ + 1;
        if (turns_) turning_[place] = {springs.rolling, springs.twisting};
    }

    void finish_step();

    int setmask() override;
    void setup_pre_exchange() override;
    void setup_pre_neighbor() override { follow_tags(); }
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
    int pack_forward_comm(int count, int *atoms, double *buffer, int pbc_flag, int *pbc) override;
    void unpack_forward_comm(int count, int first, double *buffer) override;
    int pack_reverse_comm_size(int count, int first) override;
    int pack_reverse_comm(int count, int first, double *buffer) override;
    void unpack_reverse_comm(int count, int *atoms, double *buffer) override;
    double memory_usage() override;

  private:
    /// A contact in a message.
    struct Stored {
        LAMMPS_NS::tagint partner;
        Springs springs;
    };

    /// A range of stored_, and the tag that the atom had when the range was stored; zero if it had
    /// no contact.
    struct Row {
        std::size_t first, count;
        LAMMPS_NS::tagint tag;
    };

    /// numbers that a message has for each atom in addition to those of its contacts
    static constexpr int row_head = 2;
    /// numbers that a message has for each contact
    static constexpr int stored_size = 1 + Springs::size;
    static constexpr std::uint32_t nowhere = 0xffffffff;

    static std::size_t index(int i) { return static_cast<std::size_t>(i); }
    std::size_t place(Contact const &contact) const
    {
        return static_cast<std::size_t>(&contact - contacts_.data());
    }
    std::uint32_t add_contact();
    void place_contacts(LAMMPS_NS::NeighList const &list);
    void place_contact(int i, int j);
    void complete();
    void share_contacts();
    void bring_rows_home();
    bool is_any_left() const;
    int longest_row() const;
    void follow_tags();
    static double *write(Stored const &contact, double *buffer);
    static Stored read(double const *buffer);

    /// by entry of the list: where its contact is, if it has had one
    std::vector<std::uint32_t> places_;
    std::vector<Contact> contacts_; ///< with those that have ended since the list was made
    /// by contact: its last step, counted from a new list; in step 0 it comes from before the list
    std::vector<LAMMPS_NS::bigint> steps_;
    std::vector<Turning> turning_; ///< by contact, if turns_
    bool turns_ = false;
    /// the last finished step, counted from a new list
    LAMMPS_NS::bigint step_ = 0;
    std::vector<Stored> stored_; ///< valid if is_complete_
    std::vector<Row> rows_;      ///< by owned atom
    /// by owned atom and ghost, while complete() works
    std::vector<std::vector<Stored>> shared_;
    /// number of lists that LAMMPS had made when the indices were given
    LAMMPS_NS::bigint num_lists_ = 0;
    /// by owned atom and ghost, while follow_tags() works
    std::vector<LAMMPS_NS::tagint> stored_tags_;
    /// By owned atom and ghost, while complete() works with `comm_style tiled`: how many contacts
    /// it has sent to its owner.
    std::vector<std::size_t> num_sent_;
    bool is_complete_ = true;
    int num_atoms_ = 0; ///< owned atoms and ghosts of the step
};

} // namespace pw85_lammps

#endif
