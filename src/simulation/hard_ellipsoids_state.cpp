// SPDX-License-Identifier: BSD-3-Clause
// The C API of the states of simulations: how they are made, saved and restored.
#include <cmath>
#include <cstddef>
#include <cstring>
#include <memory>
#include <new>
#include <utility>

#include "../base/c_arrays.hpp"
#include "hard_ellipsoids.hpp"

using namespace pw85;
using namespace pw85::detail;
using namespace pw85::detail::simulation;

namespace {

/// Header of a saved simulation. The mark tells the order of the bytes, the number of dimensions,
/// and whether a law, a mesh and the external potential follow after the particles, in this order:
/// a version that does not know one of these refuses it.
struct Header {
    std::uint64_t mark;
    std::size_t num_particles;
    Parameters parameters;
    Cell cell;
};

constexpr std::uint64_t mark_of_space = 0x70773835'6d630001u, mark_of_plane = 1,
                        mark_of_environment = 2, mark_of_law = 4,
                        mark_of_mesh = 8; ///< are added

/// Numbers that precede the steps of species, walls and fields of a saved simulation.
struct SavedExternalPotential {
    std::size_t num_species, num_walls, num_fields;
    double energy; ///< of the caller's potential
    int has_potential;
};

/// Numbers that precede the parameters of a saved law.
struct SavedLaw {
    std::int64_t kind;
    std::size_t num_parameters;
};

/// Counts that precede the vertices and triangles of a saved mesh.
struct SavedMesh {
    std::size_t num_vertices, num_triangles;
};

/// The numbers of a particle that are saved. The others follow from them.
struct SavedParticle {
    Vector3 center;
    Quaternion quaternion;
    Vector3 semi_axes;
};

/// A compression of n ellipsoids by the relative volume δ makes no overlap with the probability
/// exp(-n (Z - 1) δ). The first step of the volume suits Z = 11.
constexpr Parameters first_parameters(std::size_t seed, double shortest, std::size_t n) noexcept
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
    neighbors::Periodicity periodicity;
    if (periodicity.prepare(cell.exists ? cell.vectors : nullptr, cell.periodic))
        return PW85_SUCCESS;
    return note_cause(PW85_EINVAL, "cell",
                      "must have finite, independent vectors, one of them periodic");
}

bool has_no_z(Vector3 const &vector) noexcept { return vector[2] == 0.0; }

/// Returns a status, which says whether nothing stands out of a plane of z: see Configuration.
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
    std::unique_ptr<pw85_hard_ellipsoids> made(new (std::nothrow) pw85_hard_ellipsoids);
    if (made == nullptr || !made->engine.configuration.resize(n)) return PW85_ENOMEM;
    Engine &engine = made->engine;
    engine.configuration.cell = cell;
    for (std::size_t i = 0; i < n; ++i) {
        auto const [center, quaternion, axes] = load(i);
        Particle particle;
        if (!(absolute(dot(quaternion, quaternion) - 1.0) <= 0x1p-48)) return PW85_EINVAL;
        if (int const status = make_particle(center, quaternion, axes, particle)) return status;
        engine.configuration.set(i, particle);
    }
    if (int const status = check_cell(cell)) return status;
    if (int const status = set(engine)) return status;
    if (engine.configuration.dimensions == 2)
        if (int const status = check_plane(engine.configuration)) return status;
    if (int const status = engine.external.check(engine.configuration, nullptr)) return status;
    if (int const status = engine.start()) return status;
    if (int const status = engine.check(pair)) return status;
    simulation = made.release();
    return PW85_SUCCESS;
}

int create(pw85_system const &system, double const *semi_axes, double const *quaternions,
           std::size_t seed, std::int32_t *pair, pw85_hard_ellipsoids *&simulation) noexcept
{
    double shortest = HUGE_VAL;
    auto const load = [&](std::size_t i) {
        SavedParticle particle{c_api::load_vector<3>(system.centers + 3 * i),
                               c_api::load_vector<4>(quaternions + 4 * i),
                               c_api::load_vector<3>(semi_axes + 3 * i)};
        particle.quaternion = unit(particle.quaternion);
        for (double const length : particle.semi_axes.coordinates)
            shortest = std::min(shortest, length);
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
    if (dimensions == 2)
        if (int const status = check_plane(engine.configuration)) return status;
    int const before = std::exchange(engine.configuration.dimensions, dimensions);
    int const status = engine.external.check(engine.configuration, nullptr);
    engine.configuration.dimensions = before;
    if (status != PW85_SUCCESS) return PW85_EINVAL;
    engine.set_dimensions(dimensions);
    double &translation = engine.parameters.translation;
    double const longest = most_useful_translation(engine.configuration);
    translation = std::min(translation, longest);
    for (std::size_t k = 0; k < engine.species.size(); ++k)
        engine.species[k].translation = std::min(engine.species[k].translation, longest);
    return PW85_SUCCESS;
}

std::size_t num_bytes(std::size_t num_particles) noexcept
{
    return sizeof(Header) + num_particles * sizeof(SavedParticle);
}

std::size_t num_bytes(PairEnergy const &pair_energy) noexcept
{
    if (!pair_energy.exists()) return 0;
    return sizeof(SavedLaw) + pair_energy.law().num_parameters * sizeof(double);
}

std::size_t num_bytes(MeshWall const &mesh) noexcept
{
    if (!mesh.exists()) return 0;
    return sizeof(SavedMesh) + mesh.vertices.size() * sizeof(double) +
           mesh.triangles.size() * sizeof(std::int32_t);
}

/// Returns whether there is more to save than particles, parameters and a law.
bool has_more(Engine const &engine) noexcept
{
    return !engine.external.is_empty() || engine.species.size() > 0;
}

std::size_t num_bytes(Engine const &engine) noexcept
{
    ExternalPotential const &external = engine.external;
    std::size_t const of_particles = num_bytes(engine.configuration.size()) +
                                     num_bytes(engine.pair_energy) + num_bytes(external.mesh);
    if (!has_more(engine)) return of_particles;
    return of_particles + sizeof(SavedExternalPotential) +
           engine.species.size() * sizeof(SpeciesSteps) +
           external.walls.size() * sizeof(pw85_wall) + external.fields.size() * sizeof(pw85_field);
}

/// Writes an object behind others, and returns where the next one is written.
template <class Object> unsigned char *append(unsigned char *bytes, Object const &object) noexcept
{
    std::memcpy(bytes, &object, sizeof object);
    return bytes + sizeof object;
}

/// A copy of a wall or a field whose bytes between members are zero.
template <class Object> Object without_padding(Object const &object) noexcept
{
    Object copy;
    std::memset(static_cast<void *>(&copy), 0, sizeof copy);
    copy.kind = object.kind;
    std::copy_n(object.point, 3, copy.point);
    std::copy_n(object.vector, 3, copy.vector);
    if constexpr (requires { object.size; }) {
        copy.size = object.size;
    } else {
        copy.axis = object.axis;
        copy.strength = object.strength;
    }
    return copy;
}

/// Writes the elements of an array, and returns where the next object is written.
template <class Element>
unsigned char *append_all(unsigned char *bytes, Array<Element> const &elements) noexcept
{
    std::memcpy(bytes, elements.data(), elements.size() * sizeof(Element));
    return bytes + elements.size() * sizeof(Element);
}

/// Writes the mesh, if there is one, and returns where the next object is written.
unsigned char *save_mesh(MeshWall const &mesh, unsigned char *bytes) noexcept
{
    if (!mesh.exists()) return bytes;
    bytes = append(bytes, SavedMesh{mesh.vertices.size() / 3, mesh.triangles.size() / 3});
    return append_all(append_all(bytes, mesh.vertices), mesh.triangles);
}

/// Writes the law, if there is one, and returns where the next object is written.
unsigned char *save_law(PairEnergy const &pair_energy, unsigned char *bytes) noexcept
{
    if (!pair_energy.exists()) return bytes;
    pw85_law const law = pair_energy.law();
    bytes = append(bytes, SavedLaw{law.kind, law.num_parameters});
    std::size_t const size = law.num_parameters * sizeof(double);
    std::memcpy(bytes, law.parameters, size);
    return bytes + size;
}

/// Returns the energy of the caller's potential, or that of the state that was restored while it
/// waits for its potential.
double energy_to_save(Engine const &engine) noexcept
{
    ExternalPotential const &external = engine.external;
    Configuration const &configuration = engine.configuration;
    if (external.potential == nullptr) return external.saved_energy;
    return external.energy_of_potential(configuration,
                                        [&](std::size_t i) { return configuration.centers[i]; });
}

void save_environment(Engine const &engine, double energy, unsigned char *bytes) noexcept
{
    ExternalPotential const &external = engine.external;
    SavedExternalPotential saved;
    std::memset(static_cast<void *>(&saved), 0, sizeof saved);
    saved.num_species = engine.species.size();
    saved.num_walls = external.walls.size();
    saved.num_fields = external.fields.size();
    saved.has_potential = external.potential != nullptr || external.lacks_potential;
    saved.energy = energy;
    bytes = append(bytes, saved);
    for (std::size_t k = 0; k < saved.num_species; ++k) bytes = append(bytes, engine.species[k]);
    for (std::size_t k = 0; k < saved.num_walls; ++k)
        bytes = append(bytes, without_padding(external.walls[k]));
    for (std::size_t k = 0; k < saved.num_fields; ++k)
        bytes = append(bytes, without_padding(external.fields[k]));
}

/// Writes the whole state. Returns a status.
int save(Engine const &engine, unsigned char *bytes) noexcept
{
    double const energy = energy_to_save(engine);
    // A state without a finite energy could not have its potential again: see set_potential().
    if (!std::isfinite(energy))
        return note_cause(PW85_EPOTENTIAL, "potential",
                          "must give an energy that is finite, because it is saved");
    Configuration const &configuration = engine.configuration;
    Header header;
    // no byte between members is left to chance
    std::memset(static_cast<void *>(&header), 0, sizeof header);
    header.mark = mark_of_space;
    if (configuration.dimensions == 2) header.mark += mark_of_plane;
    if (engine.external.mesh.exists()) header.mark += mark_of_mesh;
    if (has_more(engine)) header.mark += mark_of_environment;
    if (engine.pair_energy.exists()) header.mark += mark_of_law;
    header.num_particles = configuration.size();
    header.parameters = engine.parameters;
    header.cell = configuration.cell;
    std::memcpy(bytes, &header, sizeof header);
    for (std::size_t i = 0; i < configuration.size(); ++i) {
        SavedParticle const particle{configuration.centers[i], configuration.quaternions[i],
                                     configuration.semi_axes[i]};
        std::memcpy(bytes + num_bytes(i), &particle, sizeof particle);
    }
    bytes = save_law(engine.pair_energy, bytes + num_bytes(configuration.size()));
    bytes = save_mesh(engine.external.mesh, bytes);
    if (has_more(engine)) save_environment(engine, energy, bytes);
    return PW85_SUCCESS;
}

/// Reads elements of an array, and advances past them. Returns a status.
template <class Element> int read(unsigned char const *&bytes, std::size_t &rest, std::size_t n,
                                  Array<Element> &elements) noexcept
{
    if (n > rest / sizeof(Element)) return PW85_EINVAL;
    if (!elements.resize(n)) return PW85_ENOMEM;
    std::memcpy(elements.data(), bytes, n * sizeof(Element));
    bytes += n * sizeof(Element);
    rest -= n * sizeof(Element);
    return PW85_SUCCESS;
}

/// Reads what save_law() has written, and advances past it. Returns a status.
int load_law(std::size_t &rest, unsigned char const *&bytes, Engine &engine) noexcept
{
    SavedLaw saved;
    if (rest < sizeof saved) return PW85_EINVAL;
    std::memcpy(&saved, bytes, sizeof saved);
    bytes += sizeof saved;
    rest -= sizeof saved;
    Array<double> parameters;
    if (int const status = read(bytes, rest, saved.num_parameters, parameters)) return status;
    if (saved.kind <= 0 || saved.kind > INT32_MAX) return PW85_EINVAL;
    pw85_law const law = {static_cast<int>(saved.kind), parameters.size(), parameters.data()};
    return engine.pair_energy.set(&law);
}

/// Reads what save_mesh() has written, and advances past it. Returns a status.
int load_mesh(std::size_t &rest, unsigned char const *&bytes, Cell const &cell,
              MeshWall &mesh) noexcept
{
    SavedMesh saved;
    if (rest < sizeof saved) return PW85_EINVAL;
    std::memcpy(&saved, bytes, sizeof saved);
    bytes += sizeof saved;
    rest -= sizeof saved;
    if (saved.num_vertices > INT32_MAX || saved.num_triangles > INT32_MAX) return PW85_EINVAL;
    if (int const status = read(bytes, rest, 3 * saved.num_vertices, mesh.vertices)) return status;
    if (int const status = read(bytes, rest, 3 * saved.num_triangles, mesh.triangles))
        return status;
    return mesh.prepare(cell);
}

/// Reads what save_environment() has written. Returns a status.
int load_environment(std::size_t size, unsigned char const *bytes, Engine &engine) noexcept
{
    SavedExternalPotential saved;
    if (size < sizeof saved) return PW85_EINVAL;
    std::memcpy(&saved, bytes, sizeof saved);
    ExternalPotential &external = engine.external;
    std::size_t rest = size - sizeof saved;
    bytes += sizeof saved;
    if (int const status = read(bytes, rest, saved.num_species, engine.species)) return status;
    if (int const status = read(bytes, rest, saved.num_walls, external.walls)) return status;
    if (int const status = read(bytes, rest, saved.num_fields, external.fields)) return status;
    if (rest != 0 || check_kinds(engine.species) != PW85_SUCCESS || !std::isfinite(saved.energy))
        return PW85_EINVAL;
    external.lacks_potential = saved.has_potential != 0;
    external.saved_energy = saved.energy;
    return PW85_SUCCESS;
}

int restore(std::size_t size, unsigned char const *bytes,
            pw85_hard_ellipsoids *&simulation) noexcept
{
    Header header;
    if (size < sizeof header) return PW85_EINVAL;
    std::memcpy(&header, bytes, sizeof header);
    std::uint64_t const marks = header.mark - mark_of_space;
    if (marks >= 2 * mark_of_mesh || header.num_particles > INT32_MAX) return PW85_EINVAL;
    std::size_t const of_particles = num_bytes(header.num_particles);
    if (size < of_particles) return PW85_EINVAL;
    if (bytes[offsetof(Header, cell) + offsetof(Cell, exists)] > 1) return PW85_EINVAL; // no bool
    if (!are_parameters(header.parameters)) return PW85_EINVAL;
    auto const load = [&](std::size_t i) {
        SavedParticle particle;
        std::memcpy(&particle, bytes + num_bytes(i), sizeof particle);
        return particle;
    };
    auto const set = [&](Engine &engine) {
        engine.parameters = header.parameters;
        engine.configuration.dimensions = (marks & mark_of_plane) != 0 ? 2 : 3;
        std::size_t rest = size - of_particles;
        unsigned char const *next = bytes + of_particles;
        if ((marks & mark_of_law) != 0)
            if (int const status = load_law(rest, next, engine)) return status;
        if ((marks & mark_of_mesh) != 0)
            if (int const status = load_mesh(rest, next, header.cell, engine.external.mesh))
                return status;
        if ((marks & mark_of_environment) != 0) return load_environment(rest, next, engine);
        return rest == 0 ? int{PW85_SUCCESS} : int{PW85_EINVAL};
    };
    return make(header.num_particles, header.cell, load, set, nullptr, simulation);
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
    *dimensions = simulation.engine.configuration.dimensions;
    return PW85_SUCCESS;
}

size_t pw85_hard_ellipsoids_num_bytes(pw85_hard_ellipsoids const *simulation)
{
    return simulation == nullptr ? 0 : num_bytes(simulation->engine);
}

int pw85::detail::hard_ellipsoids_save(pw85_hard_ellipsoids const &simulation, size_t size,
                                       unsigned char *bytes) noexcept
{
    if (size != num_bytes(simulation.engine))
        return note_cause(PW85_EINVAL, "num_bytes", "must be pw85_hard_ellipsoids_num_bytes()");
    return save(simulation.engine, bytes);
}

int pw85::detail::hard_ellipsoids_restore(size_t size, unsigned char const *bytes,
                                          pw85_hard_ellipsoids *&simulation) noexcept
{
    int const status = restore(size, bytes, simulation);
    if (status != PW85_EINVAL) return status;
    return note_cause(status, "bytes",
                      "must be a state that this version saved on this type of machine");
}
