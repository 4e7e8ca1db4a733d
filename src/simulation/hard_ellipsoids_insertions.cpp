// SPDX-License-Identifier: BSD-3-Clause
// The C API of insertions and removals of particles: see insertions.hpp.

#include "../base/c_arrays.hpp"
#include "hard_ellipsoids.hpp"
#include "insertions.hpp"

using namespace pw85;
using namespace pw85::detail;
using namespace pw85::detail::simulation;

namespace {

/// Minimum number of trials after which the bins are rebuilt; with more particles, their number.
constexpr std::size_t least_trials = 256;

constexpr Quaternion upright = {1.0, 0.0, 0.0, 0.0};

/// Returns the status of semi-axes of particles that are inserted. With energies of pairs, those of
/// all particles matter.
int check_axes(Engine const &engine, Vector3 const &semi_axes, bool with_energies) noexcept
{
    Particle particle;
    if (int const status = make_particle({}, upright, semi_axes, particle)) return status;
    neighbors::Periodicity periodicity;
    if (!engine.particles.all().cell.find_lattice(periodicity))
        return note_cause(PW85_EINVAL, "simulation", "must have a cell with independent vectors");
    double longest = 0.0;
    for (int d = 0; d < engine.particles.all().dimensions; ++d)
        longest = maximum(longest, semi_axes[d]);
    if (with_energies && engine.hamiltonian.pairs.exists())
        longest = engine.hamiltonian.pairs.reach() *
                  maximum(longest, engine.particles.all().longest_semi_axis());
    if (longest <= 32.0 * periodicity.shortest()) return PW85_SUCCESS;
    return note_cause(PW85_EINVAL, "semi_axes",
                      "must be at most 32 times the shortest vector of the lattice, with a law of "
                      "pairs also if enlarged by its reach",
                      0, 0, longest);
}

/// Returns the status of a simulation in which particles are to be inserted at random.
int check_cell(Engine const &engine) noexcept
{
    Configuration const &all = engine.particles.all();
    if (!all.cell.exists || !(all.volume() > 0.0 && elementary::isfinite(all.volume())))
        return note_cause(PW85_EINVAL, "simulation", "must have a cell with independent vectors");
    return engine.hamiltonian.external.check_potential();
}

int mean_weight(Engine &engine, std::size_t num_trials, Vector3 const &semi_axes,
                double &mean) noexcept
{
    if (int const status = check_cell(engine)) return status;
    if (int const status = check_axes(engine, semi_axes, true)) return status;
    Insertions insertions(engine);
    if (int const status = insertions.prepare(0)) return status;
    double sum = 0.0;
    for (std::size_t k = 0; k < num_trials; ++k) {
        double weight;
        if (int const status = insertions.try_weight(semi_axes, weight)) return status;
        sum += weight;
    }
    mean = num_trials > 0 ? sum / static_cast<double>(num_trials) : quiet_nan<double>();
    return PW85_SUCCESS;
}

/// Reads the species, and counts their particles. Returns a status.
int load_species(Engine const &engine, std::size_t num_kinds, double const *semi_axes,
                 double const *activities, Array<Species> &species) noexcept
{
    if (num_kinds == 0 || num_kinds > INT32_MAX)
        return note_cause(PW85_EINVAL, "num_kinds", "must be > 0 and below 2³¹");
    if (!species.resize(num_kinds)) return PW85_ENOMEM;
    for (std::size_t k = 0; k < num_kinds; ++k) {
        species[k] = {c_api::load_vector<3>(semi_axes + 3 * k), activities[k], 0};
        if (!(activities[k] > 0.0 && elementary::isfinite(activities[k]))) return PW85_EINVAL;
        if (int const status = check_axes(engine, species[k].semi_axes, true)) return status;
        for (std::size_t j = 0; j < k; ++j)
            if (are_equal(species[j].semi_axes, species[k].semi_axes))
                return note_cause(PW85_EINVAL, "semi_axes", "must differ from those before", k);
        for (std::size_t i = 0; i < engine.particles.all().size(); ++i)
            species[k].count +=
                are_equal(species[k].semi_axes, engine.particles.all().semi_axes[i]);
    }
    return PW85_SUCCESS;
}

int insertion_moves(Engine &engine, std::size_t num_moves, std::span<Species> species,
                    InsertionCounts &counts) noexcept
{
    for (std::size_t done = 0; done < num_moves;) {
        std::size_t const count =
            minimum(num_moves - done, maximum(least_trials, engine.particles.all().size()));
        Insertions insertions(engine);
        if (int const status = insertions.prepare(count)) return status;
        for (std::size_t k = 0; k < count; ++k)
            if (int const status = insertions.try_exchange(species, counts)) return status;
        done += count;
    }
    return PW85_SUCCESS;
}

/// Returns whether a particle may be in the simulation, wherever the others are. In two dimensions
/// it gets the bits of z of the others. Returns a status.
int check_placement(Engine const &engine, Particle &particle) noexcept
{
    Configuration const &all = engine.particles.all();
    if (all.dimensions == 2) {
        double const height = all.size() > 0 ? all.centers[0][2] : particle.center[2];
        if (particle.center[2] != height)
            return note_cause(PW85_EINVAL, "center", "must be in the plane of the ellipses", 0, 2,
                              particle.center[2]);
        if (particle.quaternion[1] != 0.0 || particle.quaternion[2] != 0.0)
            return note_cause(PW85_EINVAL, "quaternion", "must be a rotation about z");
        particle.center[2] = height;
    }
    pw85_system const alone{1,
                            particle.center.coordinates,
                            particle.q.entries,
                            all.cell.given(),
                            {all.cell.periodic[0], all.cell.periodic[1], all.cell.periodic[2]}};
    std::size_t bad;
    int const status = pw85_neighbors_check(&alone, 1.0, 0.0, &bad);
    if (status != PW85_EINVAL) return status;
    return note_cause(status, "center", "must not be too far away from the cell for its images");
}

int insert(Engine &engine, Particle &particle, bool take, int &is_free) noexcept
{
    ExternalPotential const &external = engine.hamiltonian.external;
    if (int const status = external.check_potential()) return status;
    if (int const status = check_axes(engine, particle.semi_axes, false)) return status;
    if (int const status = check_placement(engine, particle)) return status;
    Configuration const &all = engine.particles.all();
    double const energy = external.energy(all.size(), particle, all.dimensions);
    if (elementary::isnan(energy)) return ExternalPotential::refuse_energy();
    Insertions insertions(engine);
    bool found = false;
    if (int const status = insertions.prepare(0)) return status;
    if (energy < infinity<double>())
        if (int const status = insertions.test(particle, found)) return status;
    if (found && take)
        if (int const status = engine.particles.add(particle)) return status;
    is_free = found;
    return PW85_SUCCESS;
}

} // namespace

int pw85::detail::hard_ellipsoids_insertion_weight(pw85_hard_ellipsoids &simulation,
                                                   size_t num_trials, double const semi_axes[3],
                                                   double *weight) noexcept
{
    double mean = 0.0;
    int const status =
        mean_weight(simulation.engine, num_trials, c_api::load_vector<3>(semi_axes), mean);
    if (status == PW85_SUCCESS) *weight = mean;
    return status;
}

int pw85::detail::hard_ellipsoids_insertion_moves(pw85_hard_ellipsoids &simulation,
                                                  size_t num_moves, size_t num_kinds,
                                                  double const *semi_axes, double const *activities,
                                                  int64_t counts[4]) noexcept
{
    Engine &engine = simulation.engine;
    Array<Species> species;
    InsertionCounts made{};
    if (int const status = check_cell(engine)) return status;
    if (int const status = load_species(engine, num_kinds, semi_axes, activities, species))
        return status;
    int const status = insertion_moves(engine, num_moves, {species.data(), species.size()}, made);
    if (counts == nullptr) return status;
    counts[0] = made.insertions;
    counts[1] = made.inserted;
    counts[2] = made.removals;
    counts[3] = made.removed;
    return status;
}

int pw85::detail::hard_ellipsoids_insert(pw85_hard_ellipsoids &simulation, double const center[3],
                                         double const quaternion[4], double const semi_axes[3],
                                         int take, int *is_free) noexcept
{
    Particle particle;
    int const status =
        make_particle(c_api::load_vector<3>(center), unit(c_api::load_vector<4>(quaternion)),
                      c_api::load_vector<3>(semi_axes), particle);
    return status == PW85_SUCCESS ? insert(simulation.engine, particle, take != 0, *is_free)
                                  : status;
}

int pw85::detail::hard_ellipsoids_remove(pw85_hard_ellipsoids &simulation, size_t particle) noexcept
{
    if (int const status = check_index(simulation.engine, particle)) return status;
    if (int const status = simulation.engine.hamiltonian.external.check_potential()) return status;
    simulation.engine.particles.remove(particle);
    return PW85_SUCCESS;
}
