// SPDX-License-Identifier: GPL-2.0-only
// fix pw85/heat: the temperatures of grains, their messages, and their changes.
#include "fix_heat.hpp"

#include <lammps/variable.h>

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

namespace pw85_lammps {

namespace {

constexpr char heat_style[] = "fix pw85/heat";

/// Calls use(fix) for each fix of this style.
template <class Use> void for_each_heat(Modify &modify, Use use)
{
    for (int k = 0; k < modify.nfix; ++k)
        if (auto *const heat = dynamic_cast<FixHeat *>(modify.fix[k])) use(*heat);
}

} // namespace

FixHeat::FixHeat(LAMMPS *lammps, int narg, char **arg) : Fix(lammps, narg, arg)
{
    if (!atom->rmass_flag)
        stop_all(*error, std::string(heat_style) +
                             " needs atoms with masses of their own: use atom_style ellipsoid");
    dynamic_group_allow = 1;
    restart_peratom = 1;
    create_attribute = 1;
    maxexchange = 1;
    comm_forward = 1;
    comm_reverse = 2;
    peratom_flag = 1;
    size_peratom_cols = 0;
    peratom_freq = 1;
    scalar_flag = 1;
    global_freq = 1;
    extscalar = 0; // thermodynamic output must not divide it by the number of atoms
    grow_arrays(atom->nmax);
    Words words(lmp, std::string(heat_style) + ": the command", narg - 3, arg + 3);
    parse_capacities(words);
    if (!words.skip("temperature"))
        words.refuse("lacks the word temperature, which follows the specific heats: add "
                     "temperature T");
    initial_ = words.coordinate("temperature");
    std::fill(temperatures_.begin(), temperatures_.end(), initial_);
    if (words.skip("start")) start_from(words);
    if (!words.done())
        words.refuse("has too many words: use fix ID group pw85/heat constant C | type C1 ... CN "
                     "temperature T [start v_NAME]");
    atom->add_callback(Atom::GROW);
    atom->add_callback(Atom::RESTART);
}

FixHeat::~FixHeat()
{
    atom->delete_callback(id, Atom::GROW);
    atom->delete_callback(id, Atom::RESTART);
}

/// Reads `constant C | type C1 ... CN`, as in LAMMPS's `fix heat/flow`.
void FixHeat::parse_capacities(Words &words)
{
    bool const by_type =
        words.choice<bool>("kind of specific heat", {{"constant", false}, {"type", true}});
    if (!by_type) {
        capacities_.assign(index(atom->ntypes), words.positive("specific heat"));
        return;
    }
    for (int t = 1; t <= atom->ntypes; ++t)
        capacities_.push_back(words.positive("specific heat of type " + std::to_string(t)));
}

/// Sets the temperatures of the present atoms to the values of an atom-style variable.
void FixHeat::start_from(Words &words)
{
    std::string const name = words.word("an atom-style variable v_NAME");
    int const number = name.rfind("v_", 0) == 0 ? input->variable->find(name.c_str() + 2) : -1;
    if (number < 0 || !input->variable->atomstyle(number))
        words.refuse(
            "starts from " + name +
            ", which is not an atom-style variable: define it before the fix (variable NAME "
            "atom ...), and write v_NAME");
    input->variable->compute_atom(number, 0, temperatures_.data(), 1, 0);
    for (int i = 0; i < atom->nlocal; ++i)
        if (!std::isfinite(temperature(i)))
            stop_one(*error, std::string(heat_style) + ": atom " + std::to_string(atom->tag[i]) +
                                 " (type " + std::to_string(atom->type[i]) +
                                 ") starts with a temperature that is not finite: change "
                                 "the variable " +
                                 name.substr(2));
}

FixHeat &FixHeat::require(LAMMPS &lammps, std::string const &style)
{
    FixHeat *found = nullptr;
    for_each_heat(*lammps.modify, [&found](FixHeat &heat) { found = &heat; });
    if (!found)
        stop_all(*lammps.error, style + " has a law with heat, but grains have no temperatures: "
                                        "add fix pw85/heat, or remove the word heat");
    return *found;
}

int FixHeat::setmask()
{
    return FixConst::PRE_FORCE | FixConst::MIN_PRE_FORCE | FixConst::FINAL_INTEGRATE;
}

void FixHeat::init()
{
    refuse_respa(*lmp, heat_style);
    int count = 0;
    for_each_heat(*modify, [&count](FixHeat const &) { ++count; });
    if (count > 1)
        stop_all(*error, std::string(heat_style) +
                             " is there more than once, but grains have one temperature: use one "
                             "fix for all types, whose group has the grains that change theirs");
    time_step_check_.start_run();
}

// Contacts need the temperatures of ghosts.
void FixHeat::pre_force(int)
{
    forward_to_ghosts(*comm, this);
    std::fill_n(flows_.begin(), atom->nlocal + atom->nghost, Flow{});
}

/// Updates the temperatures. If Σ G dt <= m c for the conductances G of a grain, its new
/// temperature is a mean of those before, with positive weights. Otherwise it may be outside of
/// their range.
void FixHeat::final_integrate()
{
    if (force->newton_pair) reverse_to_owners(*comm, this);
    double fastest = 0.0;
    for (int i = 0; i < atom->nlocal; ++i) {
        if (!(atom->mask[i] & groupbit)) continue;
        double const capacity = heat_capacity(i);
        Flow const &flow = flows_[index(i)];
        temperatures_[index(i)] += update->dt * flow.heat / capacity;
        fastest = std::max(fastest, flow.conductance / capacity);
    }
    time_step_check_.finish_step(*lmp, 1.0 / fastest, update->dt,
                                 std::string(heat_style) +
                                     ": the time step is so long that temperatures leave the range "
                                     "of those of the step before");
}

double FixHeat::compute_scalar()
{
    double own = 0.0, sum = 0.0;
    for (int i = 0; i < atom->nlocal; ++i)
        if (atom->mask[i] & groupbit) own += heat_capacity(i) * temperature(i);
    MPI_Allreduce(&own, &sum, 1, MPI_DOUBLE, MPI_SUM, world);
    return sum;
}

void FixHeat::grow_arrays(int nmax)
{
    temperatures_.resize(index(nmax), initial_);
    flows_.resize(index(nmax));
    vector_atom = temperatures_.data();
}

int FixHeat::pack_exchange(int i, double *buffer)
{
    buffer[0] = temperature(i);
    return 1;
}

int FixHeat::unpack_exchange(int i, double *buffer)
{
    temperatures_[index(i)] = buffer[0];
    return 1;
}

// In a restart file, the first number of an atom is how many there are.
int FixHeat::pack_restart(int i, double *buffer)
{
    buffer[0] = size_restart(i);
    return 1 + pack_exchange(i, buffer + 1);
}

void FixHeat::unpack_restart(int i, int which)
{
    double *numbers = atom->extra[i];
    for (int k = 0; k < which; ++k) numbers += static_cast<int>(numbers[0]);
    unpack_exchange(i, numbers + 1);
}

int FixHeat::pack_forward_comm(int count, int *atoms, double *buffer, int, int *)
{
    for (int k = 0; k < count; ++k) buffer[k] = temperature(atoms[k]);
    return count;
}

void FixHeat::unpack_forward_comm(int count, int first, double *buffer)
{
    std::copy_n(buffer, count, &temperatures_[index(first)]);
}

int FixHeat::pack_reverse_comm(int count, int first, double *buffer)
{
    for (int i = first; i < first + count; ++i) {
        *buffer++ = flows_[index(i)].heat;
        *buffer++ = flows_[index(i)].conductance;
    }
    return 2 * count;
}

void FixHeat::unpack_reverse_comm(int count, int *atoms, double *buffer)
{
    for (int k = 0; k < count; ++k) add(atoms[k], buffer[2 * k], buffer[2 * k + 1]);
}

double FixHeat::memory_usage()
{
    return static_cast<double>(temperatures_.capacity() * sizeof(double) +
                               flows_.capacity() * sizeof(Flow));
}

} // namespace pw85_lammps
