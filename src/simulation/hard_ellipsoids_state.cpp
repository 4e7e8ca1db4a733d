// SPDX-License-Identifier: BSD-3-Clause
// The C API of the states of simulations: how they are made, saved and restored.
#include <new>
#include <utility>

#include "../base/c_arrays.hpp"
#include "../base/owner.hpp"
#include "hard_ellipsoids.hpp"
#include "sections.hpp"

namespace pw85::detail::simulation {
namespace {

/// The numbers of a particle that are saved. The others follow from them.
struct SavedParticle {
    Vector3 center;
    Quaternion quaternion;
    Vector3 semi_axes;
};

// The numbers of objects in the order of a saved state: see visit_numbers().

void each_number(Is<SavedParticle> auto &particle, auto const &visit) noexcept
{
    visit(particle.center, particle.quaternion, particle.semi_axes);
}

void each_number(Is<Parameters> auto &all, auto const &visit) noexcept
{
    visit(all.seed, all.step, all.translation, all.rotation, all.volume, all.fractions,
          all.counts.trials, all.counts.accepted);
}

void each_number(Is<SpeciesSteps> auto &steps, auto const &visit) noexcept
{
    visit(steps.semi_axes, steps.translation, steps.rotation);
}

void each_number(Is<pw85_wall> auto &wall, auto const &visit) noexcept
{
    visit(wall.kind, wall.point, wall.vector, wall.size);
}

void each_number(Is<pw85_field> auto &field, auto const &visit) noexcept
{
    visit(field.kind, field.axis, field.point, field.vector, field.strength);
}

} // namespace
} // namespace pw85::detail::simulation

using namespace pw85;
using namespace pw85::detail;
using namespace pw85::detail::simulation;

namespace {

/// A compression of n ellipsoids by the relative volume δ makes no overlap with the probability
/// exp(-n (Z - 1) δ). The first step of the volume suits Z = 11.
Parameters first_parameters(std::size_t seed, double shortest, std::size_t n) noexcept
{
    Parameters parameters{};
    parameters.seed = seed;
    parameters.translation = 0.2 * shortest;
    parameters.rotation = 0.05;
    parameters.volume = 0.1 / static_cast<double>(n + 1);
    parameters.fractions[translation] = parameters.fractions[rotation] = 0.5;
    return parameters;
}

Cell cell_of(pw85_system const &system) noexcept
{
    Cell cell{};
    cell.exists = system.cell != nullptr;
    for (int k = 0; k < 9 && cell.exists; ++k) cell.vectors[k] = system.cell[k];
    for (int k = 0; k < 3 && cell.exists; ++k) cell.periodic[k] = system.periodic[k] != 0;
    return cell;
}

/// Returns the status of a cell whose images are to be found.
int check_cell(Cell const &cell) noexcept
{
    neighbors::Periodicity periodicity; // which does not read the other vectors
    bool finite = true;
    for (int k = 0; k < 3 && cell.exists; ++k) finite = finite && is_finite(cell.vector(k));
    if (finite && cell.find_lattice(periodicity)) return PW85_SUCCESS;
    return note_cause(PW85_EINVAL, "cell",
                      "must have finite, independent vectors, one of them periodic");
}

bool has_no_z(Vector3 const &vector) noexcept { return vector[2] == 0.0; }

/// Returns a status, which says whether all particles and the cell are in a plane of z: see
/// Configuration.
int check_plane(Configuration const &configuration) noexcept
{
    Cell const &cell = configuration.cell;
    Vector3 const upright = cell.vector(2);
    for (std::size_t i = 0; i < configuration.size(); ++i) {
        Quaternion const &turn = configuration.quaternions[i];
        if (configuration.centers[i][2] != configuration.centers[0][2])
            return note_cause(PW85_EINVAL, "centers", "must all have the same z in two dimensions",
                              i, 2, configuration.centers[i][2]);
        if (turn[1] != 0.0 || turn[2] != 0.0)
            return note_cause(PW85_EINVAL, "quaternions",
                              "must be rotations about z in two dimensions", i, 1, turn[1]);
    }
    if (!cell.exists || (cell.periodic[2] == 0 && has_no_z(cell.vector(0)) &&
                         has_no_z(cell.vector(1)) && upright[0] == 0.0 && upright[1] == 0.0))
        return PW85_SUCCESS;
    return note_cause(PW85_EINVAL, "cell",
                      "must have its first two vectors in the plane, and the third along z and not "
                      "periodic");
}

/// Makes a simulation of n particles. load(i) returns particle i, and set(engine) sets the rest,
/// and returns a status.
template <class Load, class Set> int make(std::size_t n, Cell const &cell, Load const &load,
                                          Set const &set, std::int32_t *pair,
                                          pw85_hard_ellipsoids *&simulation) noexcept
{
    if (n > INT32_MAX) return note_cause(PW85_EINVAL, "num_particles", "must be below 2³¹");
    Owner<pw85_hard_ellipsoids> made(new (std::nothrow) pw85_hard_ellipsoids);
    if (made == nullptr) return PW85_ENOMEM;
    Engine &engine = made->engine;
    Configuration &all = engine.particles.change();
    if (!all.resize(n)) return PW85_ENOMEM;
    all.cell = cell;
    for (std::size_t i = 0; i < n; ++i) {
        auto const [center, quaternion, axes] = load(i);
        Particle particle;
        if (!(absolute(dot(quaternion, quaternion) - 1.0) <= 0x1p-48)) return PW85_EINVAL;
        if (int const status = make_particle(center, quaternion, axes, particle)) return status;
        all.set(i, particle);
    }
    if (int const status = check_cell(cell)) return status;
    if (int const status = set(engine)) return status;
    if (all.dimensions == 2)
        if (int const status = check_plane(all)) return status;
    // First, because a mesh tests all images of a particle, which are few if none of them overlap.
    if (int const status = find_first_overlap(all, pair)) return status;
    if (int const status = engine.hamiltonian.external.check(all, nullptr)) return status;
    simulation = made.release();
    return PW85_SUCCESS;
}

int create(pw85_system const &system, double const *semi_axes, double const *quaternions,
           std::size_t seed, std::int32_t *pair, pw85_hard_ellipsoids *&simulation) noexcept
{
    double shortest = infinity<double>();
    auto const load = [&](std::size_t i) {
        SavedParticle particle{c_api::load_vector<3>(system.centers + 3 * i),
                               c_api::load_vector<4>(quaternions + 4 * i),
                               c_api::load_vector<3>(semi_axes + 3 * i)};
        particle.quaternion = unit(particle.quaternion);
        for (double const length : particle.semi_axes.coordinates)
            shortest = minimum(shortest, length);
        return particle;
    };
    auto const set = [&](Engine &engine) {
        engine.parameters =
            first_parameters(seed, system.num_particles > 0 ? shortest : 1.0, system.num_particles);
        return int{PW85_SUCCESS};
    };
    return make(system.num_particles, cell_of(system), load, set, pair, simulation);
}

/// Sets the dimensions of a simulation whose state allows it. Returns a status.
int set_dimensions(Engine &engine, int dimensions) noexcept
{
    Configuration &all = engine.particles.change();
    if (dimensions == 2)
        if (int const status = check_plane(all)) return status;
    int const before = std::exchange(all.dimensions, dimensions);
    if (engine.hamiltonian.external.check(all, nullptr) != PW85_SUCCESS) {
        all.dimensions = before;
        return PW85_EINVAL;
    }
    engine.parameters.limit_translations(all.longest_useful_translation());
    return PW85_SUCCESS;
}

/// Writes the state, with the energy of the caller's potential.
void write_sections(Engine const &engine, double energy, Writer &writer) noexcept
{
    Configuration const &all = engine.particles.all();
    ExternalPotential const &external = engine.hamiltonian.external;
    writer.section(settings, all.dimensions, engine.parameters);
    if (all.cell.exists) writer.section(cell, all.cell.vectors, all.cell.periodic);
    writer.section_of(particles, all.size(), [&](std::size_t i) {
        return SavedParticle{all.centers[i], all.quaternions[i], all.semi_axes[i]};
    });
    pw85_law const own = engine.hamiltonian.pairs.law();
    if (engine.hamiltonian.pairs.exists())
        writer.section(law, own.kind, std::span(own.parameters, own.num_parameters));
    if (external.mesh.exists())
        writer.section(mesh, external.mesh.vertices.size() / 3, external.mesh.vertices,
                       external.mesh.triangles);
    if (engine.parameters.species.size() > 0) writer.section(species, engine.parameters.species);
    if (external.walls.size() > 0) writer.section(walls, external.walls);
    if (external.fields.size() > 0) writer.section(fields, external.fields);
    if (external.potential != nullptr || external.lacks_potential)
        writer.section(potential, energy);
}

/// Writes a state of `size` bytes, or only counts them if the pointer is null.
std::size_t write(Engine const &engine, double energy, std::size_t size,
                  unsigned char *bytes) noexcept
{
    Writer writer(bytes);
    writer.begin(size);
    write_sections(engine, energy, writer);
    writer.end();
    return writer.num_bytes();
}

/// Returns the energy of the caller's potential, or that of the state that was restored while it
/// waits for its potential.
double energy_to_save(Engine const &engine) noexcept
{
    ExternalPotential const &external = engine.hamiltonian.external;
    return external.potential == nullptr ? external.saved_energy
                                         : external.energy_of_potential(engine.particles.all());
}

/// Writes the whole state. Returns a status.
int save(Engine const &engine, std::size_t size, unsigned char *bytes) noexcept
{
    double const energy = energy_to_save(engine);
    // A state without a finite energy could not have its potential again: see set_potential().
    if (!elementary::isfinite(energy))
        return note_cause(PW85_EPOTENTIAL, "potential",
                          "must give an energy that is finite, because it is saved");
    write(engine, energy, size, bytes);
    return PW85_SUCCESS;
}

/// Returns a status.
int read_law(Reader &section, PairEnergy &pair_energy) noexcept
{
    if (!section.exists()) return PW85_SUCCESS;
    pw85_law read{};
    Array<double> parameters;
    section.read(read.kind);
    section.read_array(parameters);
    if (int const status = section.finish()) return status;
    if (read.kind == 0) return PW85_EINVAL;
    read.num_parameters = parameters.size();
    read.parameters = parameters.data();
    return pair_energy.set(&read);
}

/// Returns a status.
int read_mesh(Reader &section, Cell const &cell, MeshWall &mesh) noexcept
{
    if (!section.exists()) return PW85_SUCCESS;
    std::size_t num_vertices;
    section.read(num_vertices);
    if (num_vertices > section.remaining<Vector3>()) return PW85_EINVAL;
    section.read_array(3 * num_vertices, mesh.vertices);
    section.read_array(mesh.triangles);
    if (int const status = section.finish()) return status;
    return mesh.triangles.size() % 3 == 0 ? mesh.prepare(cell) : int{PW85_EINVAL};
}

/// Reads a section of objects, which need not exist. Returns a status.
template <class Object> int read_objects(Reader &section, Array<Object> &objects) noexcept
{
    section.read_array(objects);
    return section.finish();
}

/// Returns a status.
int read_potential(Reader &section, ExternalPotential &external) noexcept
{
    external.lacks_potential = section.exists();
    if (section.exists()) section.read(external.saved_energy);
    return elementary::isfinite(external.saved_energy) ? section.finish() : int{PW85_EINVAL};
}

/// Returns a status.
int read_cell(Reader &section, Cell &cell) noexcept
{
    cell.exists = section.exists();
    if (section.exists()) section.read(cell.vectors, cell.periodic);
    for (int const periodic : cell.periodic)
        if (periodic != 0 && periodic != 1) return PW85_EINVAL;
    return section.finish();
}

int restore(Reader (&sections)[num_sections], pw85_hard_ellipsoids *&simulation) noexcept
{
    int dimensions;
    Parameters parameters;
    sections[settings].read(dimensions, parameters);
    Cell cell_read{};
    if (sections[settings].finish() != PW85_SUCCESS || !sections[particles].exists() ||
        (dimensions != 2 && dimensions != 3) ||
        read_cell(sections[cell], cell_read) != PW85_SUCCESS)
        return PW85_EINVAL;
    auto const load = [&](std::size_t) {
        SavedParticle particle;
        sections[particles].read(particle);
        return particle;
    };
    auto const set = [&](Engine &engine) {
        engine.parameters = std::move(parameters);
        engine.particles.change().dimensions = dimensions;
        ExternalPotential &external = engine.hamiltonian.external;
        for (int const status :
             {sections[particles].finish(), read_law(sections[law], engine.hamiltonian.pairs),
              read_mesh(sections[mesh], cell_read, external.mesh),
              read_objects(sections[species], engine.parameters.species),
              read_objects(sections[walls], external.walls),
              read_objects(sections[fields], external.fields),
              read_potential(sections[potential], external)})
            if (status != PW85_SUCCESS) return status;
        if (!are_parameters(engine.parameters, engine.particles.all())) return int{PW85_EINVAL};
        return check_kinds(engine.parameters.species, engine.particles.all());
    };
    return make(sections[particles].remaining<SavedParticle>(), cell_read, load, set, nullptr,
                simulation);
}

} // namespace

int pw85::detail::hard_ellipsoids_create(pw85_system const &system, double const *semi_axes,
                                         double const *quaternions, size_t seed, int32_t pair[2],
                                         pw85_hard_ellipsoids *&simulation) noexcept
{
    return create(system, semi_axes, quaternions, seed, pair, simulation);
}

void pw85_hard_ellipsoids_destroy(pw85_hard_ellipsoids *simulation) { delete simulation; }

int pw85::detail::hard_ellipsoids_set_dimensions(pw85_hard_ellipsoids &simulation,
                                                 int dimensions) noexcept
{
    if (dimensions != 2 && dimensions != 3)
        return note_cause(PW85_EINVAL, "dimensions", "must be 2 or 3", 0, 0, dimensions);
    return set_dimensions(simulation.engine, dimensions);
}

int pw85::detail::hard_ellipsoids_dimensions(pw85_hard_ellipsoids const &simulation,
                                             int *dimensions) noexcept
{
    *dimensions = simulation.engine.particles.all().dimensions;
    return PW85_SUCCESS;
}

size_t pw85_hard_ellipsoids_num_bytes(pw85_hard_ellipsoids const *simulation)
{
    return simulation == nullptr ? 0 : write(simulation->engine, 0.0, 0, nullptr);
}

int pw85::detail::hard_ellipsoids_save(pw85_hard_ellipsoids const &simulation, size_t size,
                                       unsigned char *bytes) noexcept
{
    if (size != pw85_hard_ellipsoids_num_bytes(&simulation))
        return note_cause(PW85_EINVAL, "num_bytes", "must be pw85_hard_ellipsoids_num_bytes()");
    return save(simulation.engine, size, bytes);
}

int pw85::detail::hard_ellipsoids_restore(size_t size, unsigned char const *bytes,
                                          pw85_hard_ellipsoids *&simulation) noexcept
{
    Reader sections[num_sections];
    if (char const *const requirement = find_sections(size, bytes, sections))
        return note_cause(PW85_EINVAL, "bytes", requirement);
    int const status = restore(sections, simulation);
    if (status != PW85_EINVAL) return status;
    return note_cause(status, "bytes", not_a_state);
}
