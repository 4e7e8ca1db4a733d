// SPDX-License-Identifier: GPL-2.0-only
// The springs of contacts: their rows by atom, and the messages that carry them.
#include "contact_history.hpp"

#include <lammps/output.h>

#include <algorithm>
#include <utility>

using namespace LAMMPS_NS;

namespace pw85_lammps {

namespace {

/// The name is in capitals, which LAMMPS uses for styles that input scripts cannot use.
constexpr char style_name[] = "PW85/HISTORY";

Fix *create(LAMMPS *lammps, int narg, char **arg) { return new ContactHistory(lammps, narg, arg); }

} // namespace

ContactHistory::ContactHistory(LAMMPS *lammps, int narg, char **arg) : Fix(lammps, narg, arg)
{
    nevery = 1;
    restart_peratom = 1;
    create_attribute = 1;
    maxexchange_dynamic = 1;
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
    (*modify.fix_map)[style_name] = create;
    modify.add_fix(id + " all " + style_name);
    return static_cast<ContactHistory *>(modify.fix[modify.find_fix(id)]);
}

int ContactHistory::setmask()
{
    return FixConst::PRE_EXCHANGE | FixConst::MIN_PRE_EXCHANGE | FixConst::END_OF_STEP | FixConst::POST_RUN;
}

void ContactHistory::start_step()
{
    next_.clear();
    next_rows_.assign(rows_.size(), Row{});
}

ContactHistory::Contact const *ContactHistory::find(int i, int j) const
{
    Row const row = rows_[index(i)];
    tagint const partner = atom->tag[j];
    for (std::size_t k = row.first; k < row.first + row.count; ++k)
        if (contacts_[k].partner == partner) return &contacts_[k];
    return nullptr;
}

void ContactHistory::store(int i, int j, Springs const &springs, Vector const &normal)
{
    Row &row = next_rows_[index(i)];
    if (row.count == 0) row.first = next_.size();
    ++row.count;
    next_.push_back({atom->tag[j], j, springs, normal});
}

void ContactHistory::finish_step()
{
    std::swap(contacts_, next_);
    std::swap(rows_, next_rows_);
    is_complete_ = false;
    num_atoms_ = atom->nlocal + atom->nghost;
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
            stop_one(
                *error,
                "Contacts of pair pw85/granular are lost, because a fix has inserted or removed atoms before they were "
                "stored: put the pair_style command before the fix command");
        mirrored_.assign(index(atom->nlocal + atom->nghost), {});
        bool const shares = force->newton_pair;
        for (int i = 0; i < atom->nlocal; ++i) {
            Row const row = rows_[index(i)];
            for (std::size_t k = row.first; k < row.first + row.count; ++k) {
                Contact const &c = contacts_[k];
                if (c.index < atom->nlocal || shares)
                    mirrored_[index(c.index)].push_back({atom->tag[i], -1, c.springs.reversed(), {}});
            }
        }
        if (shares) reverse_rows_to_owners(*comm, this);
        std::vector<Contact> all;
        all.reserve(2 * contacts_.size());
        for (int i = 0; i < atom->nlocal; ++i) append(i, mirrored_[index(i)], all);
        contacts_ = std::move(all);
        mirrored_.clear();
        is_complete_ = true;
    }
    int const own = 1 + contact_size * longest_row();
    MPI_Allreduce(&own, &maxexchange, 1, MPI_INT, MPI_MAX, world);
}

/// Moves the contacts of an atom, and more of them, to the end of a new vector.
void ContactHistory::append(int i, std::vector<Contact> const &more, std::vector<Contact> &all)
{
    Row &row = rows_[index(i)];
    std::size_t const first = all.size();
    for (std::size_t k = row.first; k < row.first + row.count; ++k) {
        all.push_back(contacts_[k]);
        all.back().index = -1;
    }
    all.insert(all.end(), more.begin(), more.end());
    row = {first, all.size() - first};
}

int ContactHistory::longest_row() const
{
    std::size_t longest = 0;
    for (int i = 0; i < atom->nlocal; ++i) longest = std::max(longest, rows_[index(i)].count);
    return static_cast<int>(longest);
}

void ContactHistory::grow_arrays(int nmax) { rows_.resize(index(nmax)); }

double *ContactHistory::write(Contact const &contact, double *buffer)
{
    *buffer++ = static_cast<double>(contact.partner);
    return contact.springs.write(buffer);
}

ContactHistory::Contact ContactHistory::read(double const *buffer)
{
    return {static_cast<tagint>(buffer[0]), -1, Springs::read(buffer + 1), {}};
}

int ContactHistory::pack_exchange(int i, double *buffer)
{
    Row const row = rows_[index(i)];
    double *end = buffer;
    *end++ = static_cast<double>(row.count);
    for (std::size_t k = row.first; k < row.first + row.count; ++k) end = write(contacts_[k], end);
    return static_cast<int>(end - buffer);
}

int ContactHistory::unpack_exchange(int i, double *buffer)
{
    auto const count = static_cast<std::size_t>(buffer[0]);
    rows_[index(i)] = {contacts_.size(), count};
    for (std::size_t k = 0; k < count; ++k) contacts_.push_back(read(buffer + 1 + contact_size * k));
    return 1 + contact_size * static_cast<int>(count);
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
    unpack_exchange(i, numbers + 1);
}

int ContactHistory::size_restart(int i) { return 2 + contact_size * static_cast<int>(rows_[index(i)].count); }

int ContactHistory::maxsize_restart() { return 1 + maxexchange; }

int ContactHistory::pack_reverse_comm_size(int count, int first)
{
    std::size_t size = 0;
    for (int i = first; i < first + count; ++i) size += 1 + contact_size * mirrored_[index(i)].size();
    return static_cast<int>(size);
}

int ContactHistory::pack_reverse_comm(int count, int first, double *buffer)
{
    double *end = buffer;
    for (int i = first; i < first + count; ++i) {
        *end++ = static_cast<double>(mirrored_[index(i)].size());
        for (Contact const &contact : mirrored_[index(i)]) end = write(contact, end);
    }
    return static_cast<int>(end - buffer);
}

void ContactHistory::unpack_reverse_comm(int count, int *atoms, double *buffer)
{
    for (int k = 0; k < count; ++k) {
        auto const size = static_cast<std::size_t>(*buffer++);
        for (std::size_t c = 0; c < size; ++c, buffer += contact_size)
            mirrored_[index(atoms[k])].push_back(read(buffer));
    }
}

double ContactHistory::memory_usage()
{
    return static_cast<double>((contacts_.capacity() + next_.capacity()) * sizeof(Contact) +
                               (rows_.capacity() + next_rows_.capacity()) * sizeof(Row));
}

} // namespace pw85_lammps
