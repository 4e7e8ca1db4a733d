// SPDX-License-Identifier: GPL-2.0-only
// The springs of contacts: their rows by atom, and the messages that carry them.
#include "contact_history.hpp"

#include <lammps/output.h>

#include <algorithm>
#include <unordered_map>

using namespace LAMMPS_NS;

namespace pw85_lammps {

namespace {

/// The name is in capitals, which LAMMPS uses for styles that input scripts cannot use.
constexpr char history_style[] = "PW85/HISTORY";

Fix *create(LAMMPS *lammps, int narg, char **arg) { return new ContactHistory(lammps, narg, arg); }

} // namespace

ContactHistory::ContactHistory(LAMMPS *lammps, int narg, char **arg) : Fix(lammps, narg, arg)
{
    nevery = 1;
    restart_peratom = 1;
    create_attribute = 1;
    maxexchange_dynamic = 1;
    comm_forward = 1;
    comm_reverse = 1 + stored_size;
    stores_ids = 1;
    grow_arrays(atom->nmax);
    atom->add_callback(Atom::GROW);
    atom->add_callback(Atom::RESTART);
}

ContactHistory::~ContactHistory()
{
    atom->delete_callback(id, Atom::GROW);
    atom->delete_callback(id, Atom::RESTART);
}

ContactHistory *ContactHistory::add(Modify &modify, std::string const &id)
{
    (*modify.fix_map)[history_style] = create;
    modify.add_fix(id + " all " + history_style);
    return static_cast<ContactHistory *>(modify.fix[modify.find_fix(id)]);
}

int ContactHistory::setmask()
{
    return FixConst::PRE_EXCHANGE | FixConst::MIN_PRE_EXCHANGE | FixConst::PRE_NEIGHBOR |
           FixConst::MIN_PRE_NEIGHBOR | FixConst::END_OF_STEP | FixConst::POST_RUN;
}

void ContactHistory::start_step(NeighList const &list, bool turns)
{
    // Looks up the contacts of a new list. A list that is made without pre_exchange() gets the
    // contacts that were stored last.
    if (!is_complete_ && neighbor->ncalls == num_lists_) return;
    num_lists_ = neighbor->ncalls;
    turns_ = turns;
    step_ = 0;
    places_.clear();
    contacts_.clear();
    steps_.clear();
    turning_.clear();
    place_contacts(list);
}

/// Assigns memory to the contacts that are stored by atom, in the order of the atoms in the list,
/// in which memory is then read.
void ContactHistory::place_contacts(NeighList const &list)
{
    for (int row = 0; row < list.inum; ++row) {
        int const i = list.ilist[row];
        for (int k = 0; k < list.numneigh[i]; ++k)
            place_contact(i, list.firstneigh[i][k] & NEIGHMASK);
    }
}

/// Assigns memory to the contact of the next entry of the list, if it has one.
void ContactHistory::place_contact(int i, int j)
{
    places_.push_back(nowhere);
    auto const first = stored_.begin() + static_cast<std::ptrdiff_t>(rows_[index(i)].first);
    auto const last = first + static_cast<std::ptrdiff_t>(rows_[index(i)].count);
    tagint const partner = atom->tag[j];
    auto const found =
        std::find_if(first, last, [partner](Stored const &s) { return s.partner == partner; });
    if (found == last) return;
    places_.back() = add_contact();
    contacts_.back() = {i, j, found->springs.sliding, {}};
    if (turns_) turning_.back() = {found->springs.rolling, found->springs.twisting};
}

std::uint32_t ContactHistory::add_contact()
{
    contacts_.emplace_back();
    steps_.push_back(0);
    if (turns_) turning_.emplace_back();
    return static_cast<std::uint32_t>(contacts_.size() - 1);
}

void ContactHistory::finish_step()
{
    ++step_;
    is_complete_ = false;
    num_atoms_ = atom->nlocal + atom->nghost;
}

// Forgets the contacts in a rerun: its states come from a file without springs, and their atoms
// have other indices than those of the step before.
void ContactHistory::setup_pre_exchange()
{
    if (is_rerun(*input)) {
        contacts_.clear();
        steps_.clear();
        stored_.clear();
        std::fill(rows_.begin(), rows_.end(), Row{});
        is_complete_ = true;
    }
    complete();
}

// LAMMPS writes restart files after the last fix has ended its step.
void ContactHistory::end_of_step()
{
    if (output->next_restart == update->ntimestep) complete();
}

void ContactHistory::complete()
{
    if (!is_complete_) {
        if (atom->nlocal + atom->nghost != num_atoms_)
            stop_one(*error, "Contacts of pair pw85/granular are lost, because a fix has inserted "
                             "or removed atoms before they were "
                             "stored: put the pair_style command before the fix command");
        share_contacts();
        stored_.clear();
        for (int i = 0; i < atom->nlocal; ++i) {
            std::vector<Stored> const &all = shared_[index(i)];
            rows_[index(i)] = {stored_.size(), all.size(), all.empty() ? 0 : atom->tag[i]};
            stored_.insert(stored_.end(), all.begin(), all.end());
        }
        shared_.clear();
        is_complete_ = true;
    }
    int const own = row_head + stored_size * longest_row();
    MPI_Allreduce(&own, &maxexchange, 1, MPI_INT, MPI_MAX, world);
}

/// Stores all contacts with both atoms.
void ContactHistory::share_contacts()
{
    shared_.assign(index(atom->nlocal + atom->nghost), {});
    bool const shares = force->newton_pair;
    for (Contact const &c : contacts_) {
        if (steps_[place(c)] < step_) continue;
        Turning const turned = turning(c);
        Springs const springs{c.sliding, turned.rolling, turned.twisting};
        shared_[index(c.i)].push_back({atom->tag[c.j], springs});
        if (c.j < atom->nlocal || shares)
            shared_[index(c.j)].push_back({atom->tag[c.i], springs.reversed()});
    }
    if (shares) bring_rows_home();
}

/// Adds the rows of ghosts to those of their owners.
void ContactHistory::bring_rows_home()
{
    num_sent_.clear();
    if (comm->style == 0) return reverse_rows_to_owners(*comm, this);
    // With comm_style tiled LAMMPS has no messages of different sizes: each ghost sends one contact
    // after the other. Some contacts come to a ghost on another processor, which forwards them.
    num_sent_.resize(shared_.size());
    while (is_any_left()) reverse_to_owners(*comm, this);
}

/// Returns whether ghosts on any processor have contacts that they have not sent.
bool ContactHistory::is_any_left() const
{
    int left = 0;
    for (std::size_t i = index(atom->nlocal); i < shared_.size(); ++i)
        left |= num_sent_[i] < shared_[i].size() ? 1 : 0;
    MPI_Allreduce(MPI_IN_PLACE, &left, 1, MPI_INT, MPI_MAX, world);
    return left != 0;
}

// Updates the stored tags. Commands between runs may renumber the atoms, remove some, and reuse
// their tags (delete_atoms, create_atoms).
void ContactHistory::follow_tags()
{
    stored_tags_.clear();
    for (int i = 0; i < atom->nlocal; ++i) stored_tags_.push_back(rows_[index(i)].tag);
    stored_tags_.resize(index(atom->nlocal + atom->nghost));
    forward_to_ghosts(*comm, this);
    std::unordered_map<tagint, tagint> tags; // by the stored one
    for (int i = 0; i < atom->nlocal + atom->nghost; ++i)
        if (stored_tags_[index(i)] != 0) tags[stored_tags_[index(i)]] = atom->tag[i];
    for (int i = 0; i < atom->nlocal; ++i) {
        Row &row = rows_[index(i)];
        if (row.count == 0) continue;
        row.tag = atom->tag[i];
        for (std::size_t k = row.first; k < row.first + row.count; ++k) {
            auto const found = tags.find(stored_[k].partner);
            stored_[k].partner = found == tags.end() ? 0 : found->second; // no atom has the tag 0
        }
    }
}

int ContactHistory::longest_row() const
{
    std::size_t longest = 0;
    for (int i = 0; i < atom->nlocal; ++i) longest = std::max(longest, rows_[index(i)].count);
    return static_cast<int>(longest);
}

void ContactHistory::grow_arrays(int nmax) { rows_.resize(index(nmax)); }

double *ContactHistory::write(Stored const &contact, double *buffer)
{
    *buffer++ = static_cast<double>(contact.partner);
    return contact.springs.write(buffer);
}

ContactHistory::Stored ContactHistory::read(double const *buffer)
{
    return {static_cast<tagint>(buffer[0]), Springs::read(buffer + 1)};
}

int ContactHistory::pack_exchange(int i, double *buffer)
{
    Row const row = rows_[index(i)];
    double *end = buffer;
    *end++ = static_cast<double>(row.count);
    *end++ = static_cast<double>(row.tag);
    for (std::size_t k = row.first; k < row.first + row.count; ++k) end = write(stored_[k], end);
    return static_cast<int>(end - buffer);
}

int ContactHistory::unpack_exchange(int i, double *buffer)
{
    auto const count = static_cast<std::size_t>(buffer[0]);
    rows_[index(i)] = {stored_.size(), count, static_cast<tagint>(buffer[1])};
    for (std::size_t k = 0; k < count; ++k)
        stored_.push_back(read(buffer + row_head + stored_size * k));
    return row_head + stored_size * static_cast<int>(count);
}

// In a restart file, the first number of an atom is how many there are.
int ContactHistory::pack_restart(int i, double *buffer)
{
    buffer[0] = size_restart(i);
    return 1 + pack_exchange(i, buffer + 1);
}

void ContactHistory::unpack_restart(int i, int which)
{
    double *numbers = atom->extra[i];
    for (int k = 0; k < which; ++k) numbers += static_cast<int>(numbers[0]);
    std::vector<double> contacts = restarted_contacts(numbers, row_head, stored_size);
    unpack_exchange(i, contacts.data());
}

int ContactHistory::size_restart(int i)
{
    return 1 + row_head + stored_size * static_cast<int>(rows_[index(i)].count);
}

int ContactHistory::maxsize_restart() { return 1 + maxexchange; }

int ContactHistory::pack_forward_comm(int count, int *atoms, double *buffer, int, int *)
{
    for (int k = 0; k < count; ++k) buffer[k] = static_cast<double>(stored_tags_[index(atoms[k])]);
    return count;
}

void ContactHistory::unpack_forward_comm(int count, int first, double *buffer)
{
    for (int k = 0; k < count; ++k) stored_tags_[index(first + k)] = static_cast<tagint>(buffer[k]);
}

int ContactHistory::pack_reverse_comm_size(int count, int first)
{
    std::size_t size = 0;
    for (int i = first; i < first + count; ++i) size += 1 + stored_size * shared_[index(i)].size();
    return static_cast<int>(size);
}

int ContactHistory::pack_reverse_comm(int count, int first, double *buffer)
{
    double *end = buffer;
    for (int i = first; i < first + count; ++i) {
        std::vector<Stored> const &row = shared_[index(i)];
        if (num_sent_.empty()) {
            *end++ = static_cast<double>(row.size());
            for (Stored const &contact : row) end = write(contact, end);
        } else {
            std::size_t &sent = num_sent_[index(i)];
            bool const sends = sent < row.size();
            *end++ = sends ? 1.0 : 0.0;
            end = write(sends ? row[sent++] : Stored{}, end);
        }
    }
    return static_cast<int>(end - buffer);
}

void ContactHistory::unpack_reverse_comm(int count, int *atoms, double *buffer)
{
    for (int k = 0; k < count; ++k) {
        auto const size = static_cast<std::size_t>(*buffer++);
        for (std::size_t c = 0; c < size; ++c, buffer += stored_size)
            shared_[index(atoms[k])].push_back(read(buffer));
        if (!num_sent_.empty() && size == 0) buffer += stored_size;
    }
}

double ContactHistory::memory_usage()
{
    return static_cast<double>(places_.capacity() * sizeof(std::uint32_t) +
                               contacts_.capacity() * (sizeof(Contact) + sizeof(bigint)) +
                               turning_.capacity() * sizeof(Turning) +
                               stored_.capacity() * sizeof(Stored) +
                               rows_.capacity() * sizeof(Row));
}

} // namespace pw85_lammps
