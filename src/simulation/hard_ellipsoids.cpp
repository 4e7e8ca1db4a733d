// SPDX-License-Identifier: BSD-3-Clause
// The C API of the simulations of hard ellipsoids.
#include <cmath>
#include <cstring>
#include <memory>
#include <new>

#include <pw85_simulation.h>

#include "../base/c_arrays.hpp"
#include "chains.hpp"
#include "hard_ellipsoids.hpp"

using namespace pw85;
using namespace pw85::detail;
using namespace pw85::detail::simulation;
using pw85::detail::c_api::any_null;

namespace {

/// What a saved simulation begins with. The mark tells the order of the bytes, the number of
/// dimensions, and whether the environment follows after the particles: a version that does not
/// know one of these refuses it.
struct Header {
    std::uint64_t mark;
    std::size_t num_particles;
    Parameters parameters;
    Cell cell;
};

constexpr std::uint64_t mark_of_space = 0x70773835'6d630001u, mark_of_plane = 0x70773835'6d630002u,
                        mark_of_environment = 2; ///< is added

/// What stands before the steps of kinds, walls and fields of a saved simulation.
struct SavedEnvironment {
    std::size_t num_kinds, num_walls, num_fields;
    double energy; ///< of the caller's potential
    int has_potential;
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

bool has_no_z(Vector3 const &vector) noexcept { return vector[2] == 0.0; }

/// Whether nothing stands out of a plane of z: see Configuration.
bool is_planar(Configuration const &configuration) noexcept
{
    Cell const &cell = configuration.cell;
    Vector3 const upright = cell.vector(2);
    bool planar =
        !cell.exists || (cell.periodic[2] == 0 && has_no_z(cell.vector(0)) &&
                         has_no_z(cell.vector(1)) && upright[0] == 0.0 && upright[1] == 0.0);
    for (std::size_t i = 0; i < configuration.size(); ++i) {
        Quaternion const &turn = configuration.quaternions[i];
        planar = planar && configuration.centers[i][2] == configuration.centers[0][2] &&
                 turn[1] == 0.0 && turn[2] == 0.0;
    }
    return planar;
}

/// Makes a simulation of n particles. load(i) returns particle i, and set(engine) sets the rest,
/// and returns a status.
template <class Load, class Set> int make(std::size_t n, Cell const &cell, Load const &load,
                                          Set const &set, std::int32_t *pair,
                                          pw85_hard_ellipsoids *&simulation) noexcept
{
    if (n > INT32_MAX) return PW85_EINVAL;
    std::unique_ptr<pw85_hard_ellipsoids> made(new (std::nothrow) pw85_hard_ellipsoids);
    if (made == nullptr || !made->engine.configuration.resize(n)) return PW85_ENOMEM;
    Engine &engine = made->engine;
    engine.configuration.cell = cell;
    for (std::size_t i = 0; i < n; ++i) {
        auto const [center, quaternion, axes] = load(i);
        Particle particle;
        if (int const status = make_particle(center, quaternion, axes, particle)) return status;
        engine.configuration.set(i, particle);
    }
    if (int const status = set(engine)) return status;
    if (engine.configuration.dimensions == 2 && !is_planar(engine.configuration))
        return PW85_EINVAL;
    if (int const status = engine.environment.check(engine.configuration, nullptr)) return status;
    if (int const status = engine.start()) return status;
    if (int const status = engine.check(pair)) return status;
    simulation = made.release();
    return PW85_SUCCESS;
}

int create(pw85_system const &system, double const *semi_axes, double const *quaternions,
           std::size_t seed, std::int32_t *pair, pw85_hard_ellipsoids *&simulation) noexcept
{
    if (system.num_particles > 0 && any_null(system.centers, semi_axes, quaternions))
        return PW85_EINVAL;
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

bool is_kind(int kind) noexcept
{
    return kind >= 0 && kind <= static_cast<int>(ChangeKind::aspect);
}

bool can_change(Engine const &engine, double pressure, int kind) noexcept
{
    bool const has_pressure = kind == PW85_CHANGE_ASPECT || pressure > 0.0;
    return is_kind(kind) && has_pressure && std::isfinite(pressure) &&
           engine.configuration.is_closed();
}

/// Begins, calls work() until it fails or was called often enough, and ends.
template <class Work> int repeat(Engine &engine, std::size_t times, Work const &work) noexcept
{
    int status = engine.begin();
    for (std::size_t k = 0; k < times && status == PW85_SUCCESS; ++k) status = work();
    engine.end();
    return status;
}

/// One sweep after the other, each followed by a trial of the volume if there is a pressure.
int tune(Engine &engine, std::size_t num_sweeps, double acceptance, double pressure,
         ChangeKind kind) noexcept
{
    std::fill_n(engine.counts_of_kinds, most_kinds, Counts{});
    int const status = repeat(engine, num_sweeps, [&] {
        Counts const before = engine.parameters.counts;
        if (int const bad = engine.sweep()) return bad;
        if (pressure > 0.0 || kind == ChangeKind::aspect)
            if (int const bad = engine.try_volume(pressure, kind)) return bad;
        engine.tune(before, acceptance);
        return int{PW85_SUCCESS};
    });
    if (status == PW85_SUCCESS) engine.parameters.counts = {};
    return status;
}

/// Event chains along a direction, or along random ones if it is zero.
int make_chains(Engine &engine, std::size_t num_chains, double length, Vector3 const &direction,
                ChainSums &sums) noexcept
{
    auto const n = static_cast<std::uint32_t>(engine.configuration.size());
    bool const random = largest_coordinate(direction) == 0.0;
    Chains chains(engine.configuration);
    engine.forget();
    if (int const status = chains.prepare()) return status;
    for (std::size_t k = 0; k < num_chains && n > 0; ++k) {
        Stream stream(engine.parameters.seed, engine.parameters.step++, UINT32_MAX);
        std::size_t const first = stream.below(n);
        Vector3 const along =
            unit(random ? stream.in_ball(engine.configuration.dimensions) : direction);
        if (int const status = chains.run(first, along, length, sums)) return status;
    }
    if (chains.own_images_may_touch()) sums.transfers = quiet_nan<double>();
    return PW85_SUCCESS;
}

/// Gives what moves in a plane of z the bits of z, and of x and y of the quaternion, of the
/// particle before. Returns false if it would leave the plane.
bool keep_in_plane(Particle const &before, Particle &moved) noexcept
{
    bool const stays = moved.center[2] == before.center[2] && moved.quaternion[1] == 0.0 &&
                       moved.quaternion[2] == 0.0;
    moved.center[2] = before.center[2];
    for (int d = 1; d <= 2; ++d) moved.quaternion[d] = before.quaternion[d];
    return stays;
}

/// Tries another centre or quaternion of a particle. Null keeps what there is.
int try_placement(Engine &engine, std::size_t particle, double const *center,
                  double const *quaternion, bool take, int &is_free) noexcept
{
    Particle const before = engine.configuration.get(particle);
    Particle moved = before;
    if (center != nullptr) moved.center = c_api::load_vector<3>(center);
    if (!is_finite(moved.center)) return PW85_EINVAL;
    if (quaternion != nullptr) moved.quaternion = unit(c_api::load_vector<4>(quaternion));
    if (engine.configuration.dimensions == 2 && !keep_in_plane(before, moved)) return PW85_EINVAL;
    if (quaternion != nullptr) {
        if (ellipsoid_quaternion(moved.semi_axes, moved.quaternion).status != Status::success)
            return PW85_EINVAL;
        if (!moved.shape()) return PW85_ENOTPD;
    }
    bool found = false;
    Environment const &environment = engine.environment;
    if (environment.lacks_potential) return PW85_EPOTENTIAL;
    double const energy = environment.energy(particle, moved, engine.configuration.dimensions);
    if (std::isnan(energy)) return PW85_EPOTENTIAL;
    is_free = 0;
    if (energy == HUGE_VAL || environment.cuts(moved, engine.configuration.dimensions))
        return PW85_SUCCESS;
    is_free = -1;
    int const status = engine.try_placement(particle, moved, take, found);
    if (status == PW85_SUCCESS) is_free = found;
    return status;
}

/// Copies the first images to arrays of some capacity.
void store(Array<NearImage> const &found, std::size_t capacity, std::int32_t *particles,
           std::int32_t *images, double *separations) noexcept
{
    for (std::size_t k = 0; k < std::min(capacity, found.size()); ++k) {
        NearImage const &near = found[k];
        if (particles != nullptr) particles[k] = near.particle;
        if (images != nullptr) std::copy_n(near.image.n, 3, images + 3 * k);
        if (separations != nullptr) c_api::store(near.r12, separations + 3 * k);
    }
}

/// Whether these can be the largest changes of trials. For negative steps, no list of neighbours
/// would ever hold.
bool are_steps(double translation, double rotation, double volume) noexcept
{
    return translation > 0.0 && std::isfinite(translation) && rotation > 0.0 && rotation <= 1.0 &&
           volume > 0.0 && volume <= 1.0;
}

/// Whether these can be the steps of kinds, all different.
bool are_kinds(Array<KindSteps> const &kinds) noexcept
{
    bool allowed = kinds.size() <= most_kinds;
    for (std::size_t k = 0; k < kinds.size() && allowed; ++k) {
        allowed = are_steps(kinds[k].translation, kinds[k].rotation, 1.0) &&
                  is_finite(kinds[k].semi_axes);
        for (std::size_t j = 0; j < k; ++j) allowed = allowed && !kinds[j].has(kinds[k].semi_axes);
    }
    return allowed;
}

/// Whether a simulation can have these parameters. The sum of the fractions is 1 up to rounding
/// errors.
bool are_parameters(Parameters const &parameters) noexcept
{
    double sum = 0.0;
    for (double const fraction : parameters.fractions) {
        if (!(fraction >= 0.0)) return false;
        sum += fraction;
    }
    return absolute(sum - 1.0) <= 0x1p-48 &&
           are_steps(parameters.translation, parameters.rotation, parameters.volume);
}

/// The longest translation that is of use: a longer one leads to places that shorter ones reach,
/// too.
double most_useful_translation(Configuration const &configuration) noexcept
{
    if (!configuration.is_closed()) return HUGE_VAL;
    double longest = 0.0;
    for (int k = 0; k < configuration.dimensions; ++k)
        longest = std::max(longest, magnitude(configuration.cell.vector(k)));
    return longest;
}

/// Sets the dimensions of a simulation whose state allows it. Returns a status.
int set_dimensions(Engine &engine, int dimensions) noexcept
{
    if (dimensions == 2 && !is_planar(engine.configuration)) return PW85_EINVAL;
    int const before = std::exchange(engine.configuration.dimensions, dimensions);
    bool const is_allowed = engine.environment.check(engine.configuration, nullptr) == PW85_SUCCESS;
    engine.configuration.dimensions = before;
    if (!is_allowed) return PW85_EINVAL;
    engine.set_dimensions(dimensions);
    double &translation = engine.parameters.translation;
    double const longest = most_useful_translation(engine.configuration);
    translation = std::min(translation, longest);
    for (std::size_t k = 0; k < engine.kinds.size(); ++k)
        engine.kinds[k].translation = std::min(engine.kinds[k].translation, longest);
    return PW85_SUCCESS;
}

std::size_t num_bytes(std::size_t num_particles) noexcept
{
    return sizeof(Header) + num_particles * sizeof(SavedParticle);
}

/// Whether there is more to save than particles and parameters.
bool has_more(Engine const &engine) noexcept
{
    return !engine.environment.is_empty() || engine.kinds.size() > 0;
}

std::size_t num_bytes(Engine const &engine) noexcept
{
    Environment const &environment = engine.environment;
    std::size_t const of_particles = num_bytes(engine.configuration.size());
    if (!has_more(engine)) return of_particles;
    return of_particles + sizeof(SavedEnvironment) + engine.kinds.size() * sizeof(KindSteps) +
           environment.walls.size() * sizeof(pw85_wall) +
           environment.fields.size() * sizeof(pw85_field);
}

/// Writes an object behind others, and returns where the next one is written.
template <class Object> unsigned char *append(unsigned char *bytes, Object const &object) noexcept
{
    std::memcpy(bytes, &object, sizeof object);
    return bytes + sizeof object;
}

/// A copy of a wall or a field whose bytes between members, and numbers that are not read, are
/// zero.
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

void save_environment(Engine const &engine, unsigned char *bytes) noexcept
{
    Environment const &environment = engine.environment;
    Configuration const &configuration = engine.configuration;
    bool const has_potential = environment.potential != nullptr;
    SavedEnvironment saved;
    std::memset(static_cast<void *>(&saved), 0, sizeof saved);
    saved.num_kinds = engine.kinds.size();
    saved.num_walls = environment.walls.size();
    saved.num_fields = environment.fields.size();
    saved.has_potential = has_potential || environment.lacks_potential;
    saved.energy = has_potential
                       ? environment.energy_of_potential(
                             configuration, [&](std::size_t i) { return configuration.centers[i]; })
                       : environment.saved_energy;
    bytes = append(bytes, saved);
    for (std::size_t k = 0; k < saved.num_kinds; ++k) bytes = append(bytes, engine.kinds[k]);
    for (std::size_t k = 0; k < saved.num_walls; ++k)
        bytes = append(bytes, without_padding(environment.walls[k]));
    for (std::size_t k = 0; k < saved.num_fields; ++k)
        bytes = append(bytes, without_padding(environment.fields[k]));
}

/// Reads elements of an array, and goes on behind them. Returns a status.
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

/// Reads what save_environment() has written. Returns a status.
int load_environment(std::size_t size, unsigned char const *bytes, Engine &engine) noexcept
{
    SavedEnvironment saved;
    if (size < sizeof saved) return PW85_EINVAL;
    std::memcpy(&saved, bytes, sizeof saved);
    Environment &environment = engine.environment;
    std::size_t rest = size - sizeof saved;
    bytes += sizeof saved;
    if (int const status = read(bytes, rest, saved.num_kinds, engine.kinds)) return status;
    if (int const status = read(bytes, rest, saved.num_walls, environment.walls)) return status;
    if (int const status = read(bytes, rest, saved.num_fields, environment.fields)) return status;
    if (rest != 0 || !are_kinds(engine.kinds)) return PW85_EINVAL;
    environment.lacks_potential = saved.has_potential != 0;
    environment.saved_energy = saved.energy;
    return PW85_SUCCESS;
}

int restore(std::size_t size, unsigned char const *bytes,
            pw85_hard_ellipsoids *&simulation) noexcept
{
    Header header;
    if (size < sizeof header) return PW85_EINVAL;
    std::memcpy(&header, bytes, sizeof header);
    bool const has_environment = header.mark == mark_of_space + mark_of_environment ||
                                 header.mark == mark_of_plane + mark_of_environment;
    if (has_environment) header.mark -= mark_of_environment;
    bool const is_of_plane = header.mark == mark_of_plane;
    if ((header.mark != mark_of_space && !is_of_plane) || header.num_particles > INT32_MAX)
        return PW85_EINVAL;
    std::size_t const of_particles = num_bytes(header.num_particles);
    if (has_environment ? size < of_particles : size != of_particles) return PW85_EINVAL;
    if (!are_parameters(header.parameters)) return PW85_EINVAL;
    auto const load = [&](std::size_t i) {
        SavedParticle particle;
        std::memcpy(&particle, bytes + num_bytes(i), sizeof particle);
        return particle;
    };
    auto const set = [&](Engine &engine) {
        engine.parameters = header.parameters;
        engine.configuration.dimensions = is_of_plane ? 2 : 3;
        if (!has_environment) return int{PW85_SUCCESS};
        return load_environment(size - of_particles, bytes + of_particles, engine);
    };
    return make(header.num_particles, header.cell, load, set, nullptr, simulation);
}

} // namespace

int pw85_hard_ellipsoids_create(pw85_system const *system, double const *semi_axes,
                                double const *quaternions, size_t seed, int32_t pair[2],
                                pw85_hard_ellipsoids **simulation)
{
    if (pair != nullptr) pair[0] = pair[1] = -1;
    if (any_null(simulation)) return PW85_EINVAL;
    *simulation = nullptr;
    if (any_null(system)) return PW85_EINVAL;
    return in_default_environment(
        [&] { return create(*system, semi_axes, quaternions, seed, pair, *simulation); });
}

void pw85_hard_ellipsoids_destroy(pw85_hard_ellipsoids *simulation) { delete simulation; }

int pw85_hard_ellipsoids_set_dimensions(pw85_hard_ellipsoids *simulation, int dimensions)
{
    if (any_null(simulation) || (dimensions != 2 && dimensions != 3)) return PW85_EINVAL;
    return in_default_environment([&] { return set_dimensions(simulation->engine, dimensions); });
}

int pw85_hard_ellipsoids_dimensions(pw85_hard_ellipsoids const *simulation, int *dimensions)
{
    if (dimensions != nullptr) *dimensions = -1;
    if (any_null(simulation, dimensions)) return PW85_EINVAL;
    *dimensions = simulation->engine.configuration.dimensions;
    return PW85_SUCCESS;
}

int pw85_hard_ellipsoids_sweep(pw85_hard_ellipsoids *simulation, size_t num_sweeps)
{
    if (any_null(simulation)) return PW85_EINVAL;
    return in_default_environment([&] {
        Engine &engine = simulation->engine;
        return repeat(engine, num_sweeps, [&] { return engine.sweep(); });
    });
}

int pw85_hard_ellipsoids_chain(pw85_hard_ellipsoids *simulation, size_t num_chains, double length,
                               double const direction[3], double *compressibility)
{
    if (compressibility != nullptr) *compressibility = quiet_nan<double>();
    if (any_null(simulation) || !(length > 0.0 && std::isfinite(length))) return PW85_EINVAL;
    if (!simulation->engine.environment.is_empty()) return PW85_EINVAL;
    return in_default_environment([&] {
        Vector3 along = direction == nullptr ? Vector3{} : c_api::load_vector<3>(direction);
        if (!is_finite(along) || (direction != nullptr && largest_coordinate(along) == 0.0))
            return int{PW85_EINVAL};
        if (simulation->engine.configuration.dimensions == 2) {
            if (along[2] != 0.0) return int{PW85_EINVAL};
            along[2] = -0.0; // as Stream::in_disc()
        }
        ChainSums sums{};
        int const status = make_chains(simulation->engine, num_chains, length, along, sums);
        if (status == PW85_SUCCESS && compressibility != nullptr)
            *compressibility =
                sums.length > 0.0 ? 1.0 + sums.transfers / sums.length : quiet_nan<double>();
        return status;
    });
}

int pw85_hard_ellipsoids_volume_moves(pw85_hard_ellipsoids *simulation, size_t num_moves,
                                      double pressure, int change)
{
    if (any_null(simulation) || !can_change(simulation->engine, pressure, change))
        return PW85_EINVAL;
    return in_default_environment([&] {
        Engine &engine = simulation->engine;
        return repeat(engine, num_moves,
                      [&] { return engine.try_volume(pressure, static_cast<ChangeKind>(change)); });
    });
}

int pw85_hard_ellipsoids_tune(pw85_hard_ellipsoids *simulation, size_t num_sweeps,
                              double acceptance, double pressure, int change)
{
    if (any_null(simulation) || !(acceptance > 0.0 && acceptance <= 1.0) || !(pressure >= 0.0))
        return PW85_EINVAL;
    bool const changes_cell = pressure > 0.0 || change == PW85_CHANGE_ASPECT;
    if (changes_cell && !can_change(simulation->engine, pressure, change)) return PW85_EINVAL;
    return in_default_environment([&] {
        return tune(simulation->engine, num_sweeps, acceptance, pressure,
                    static_cast<ChangeKind>(change));
    });
}

int pw85_hard_ellipsoids_set_fractions(pw85_hard_ellipsoids *simulation, double const fractions[4])
{
    if (any_null(simulation) || any_null(fractions)) return PW85_EINVAL;
    return in_default_environment([&] {
        double sum = 0.0;
        for (int k = 0; k < num_particle_moves; ++k) {
            if (!(fractions[k] >= 0.0)) return int{PW85_EINVAL};
            sum += fractions[k];
        }
        if (!(sum > 0.0) || !std::isfinite(sum)) return int{PW85_EINVAL};
        for (int k = 0; k < num_particle_moves; ++k)
            simulation->engine.parameters.fractions[k] = fractions[k] / sum;
        return int{PW85_SUCCESS};
    });
}

int pw85_hard_ellipsoids_set_steps(pw85_hard_ellipsoids *simulation, double const steps[3])
{
    if (any_null(simulation) || any_null(steps)) return PW85_EINVAL;
    return in_default_environment([&] {
        Engine &engine = simulation->engine;
        if (!are_steps(steps[0], steps[1], steps[2]) ||
            steps[0] > most_useful_translation(engine.configuration))
            return int{PW85_EINVAL};
        engine.parameters.translation = steps[0];
        engine.parameters.rotation = steps[1];
        engine.parameters.volume = steps[2];
        return int{PW85_SUCCESS};
    });
}

int pw85_hard_ellipsoids_steps(pw85_hard_ellipsoids const *simulation, double steps[3])
{
    if (any_null(simulation) || any_null(steps)) return c_api::null_pointer(steps, 3);
    Parameters const &parameters = simulation->engine.parameters;
    c_api::store(Vector3{parameters.translation, parameters.rotation, parameters.volume}, steps);
    return PW85_SUCCESS;
}

int pw85_hard_ellipsoids_set_kind_steps(pw85_hard_ellipsoids *simulation, size_t num_kinds,
                                        double const *semi_axes, double const *steps)
{
    if (any_null(simulation) || num_kinds > most_kinds ||
        (num_kinds > 0 && any_null(semi_axes, steps)))
        return PW85_EINVAL;
    return in_default_environment([&] {
        Engine &engine = simulation->engine;
        Array<KindSteps> kinds;
        if (!kinds.resize(num_kinds)) return int{PW85_ENOMEM};
        double const longest = most_useful_translation(engine.configuration);
        for (std::size_t k = 0; k < num_kinds; ++k) {
            kinds[k] = {c_api::load_vector<3>(semi_axes + 3 * k), steps[2 * k], steps[2 * k + 1]};
            if (!(kinds[k].translation <= longest)) return int{PW85_EINVAL};
        }
        if (!are_kinds(kinds)) return int{PW85_EINVAL};
        engine.kinds = std::move(kinds);
        return int{PW85_SUCCESS};
    });
}

int pw85_hard_ellipsoids_kind_steps(pw85_hard_ellipsoids const *simulation, size_t num_kinds,
                                    double const *semi_axes, double *steps)
{
    if (any_null(simulation) || (num_kinds > 0 && any_null(semi_axes, steps))) {
        for (std::size_t k = 0; k < 2 * num_kinds && steps != nullptr; ++k)
            steps[k] = quiet_nan<double>();
        return PW85_EINVAL;
    }
    for (std::size_t k = 0; k < num_kinds; ++k) {
        KindSteps const own = simulation->engine.steps_of(c_api::load_vector<3>(semi_axes + 3 * k));
        steps[2 * k] = own.translation;
        steps[2 * k + 1] = own.rotation;
    }
    return PW85_SUCCESS;
}

int pw85_hard_ellipsoids_counts(pw85_hard_ellipsoids const *simulation, int64_t trials[5],
                                int64_t accepted[5])
{
    if (any_null(simulation)) {
        if (trials != nullptr) std::fill_n(trials, 5, -1);
        if (accepted != nullptr) std::fill_n(accepted, 5, -1);
        return PW85_EINVAL;
    }
    Counts const &counts = simulation->engine.parameters.counts;
    if (trials != nullptr) std::copy_n(counts.trials, 5, trials);
    if (accepted != nullptr) std::copy_n(counts.accepted, 5, accepted);
    return PW85_SUCCESS;
}

int pw85_hard_ellipsoids_neighbors(pw85_hard_ellipsoids *simulation, size_t particle,
                                   size_t capacity, size_t *count, int32_t *particles,
                                   int32_t *images, double *separations)
{
    if (count != nullptr) *count = 0;
    if (any_null(simulation, count) || particle >= simulation->engine.configuration.size())
        return PW85_EINVAL;
    return in_default_environment([&] {
        Array<NearImage> found;
        if (int const status = simulation->engine.find_neighbors(particle, found)) return status;
        *count = found.size();
        store(found, capacity, particles, images, separations);
        return int{PW85_SUCCESS};
    });
}

int pw85_hard_ellipsoids_try(pw85_hard_ellipsoids *simulation, size_t particle,
                             double const center[3], double const quaternion[4], int take,
                             int *is_free)
{
    if (is_free != nullptr) *is_free = -1;
    if (any_null(simulation, is_free) || particle >= simulation->engine.configuration.size())
        return PW85_EINVAL;
    return in_default_environment([&] {
        return try_placement(simulation->engine, particle, center, quaternion, take != 0, *is_free);
    });
}

int pw85_hard_ellipsoids_compress(pw85_hard_ellipsoids *simulation, int take, double *factor)
{
    if (factor != nullptr) *factor = quiet_nan<double>();
    if (any_null(simulation, factor) || !simulation->engine.environment.is_empty())
        return PW85_EINVAL;
    return in_default_environment([&] {
        double found = 0.0;
        Engine &engine = simulation->engine;
        int const status = repeat(engine, 1, [&] { return engine.compress(take != 0, found); });
        if (status == PW85_SUCCESS) *factor = found;
        return status;
    });
}

int pw85_hard_ellipsoids_check(pw85_hard_ellipsoids const *simulation, int32_t pair[2])
{
    if (pair != nullptr) pair[0] = pair[1] = -1;
    if (any_null(simulation)) return PW85_EINVAL;
    return in_default_environment([&] { return simulation->engine.check(pair); });
}

pw85_system pw85_hard_ellipsoids_system(pw85_hard_ellipsoids const *simulation)
{
    if (simulation == nullptr) return {0, nullptr, nullptr, nullptr, {0, 0, 0}};
    return simulation->engine.configuration.system();
}

double const *pw85_hard_ellipsoids_quaternions(pw85_hard_ellipsoids const *simulation)
{
    if (simulation == nullptr) return nullptr;
    return reinterpret_cast<double const *>(simulation->engine.configuration.quaternions.data());
}

double const *pw85_hard_ellipsoids_semi_axes(pw85_hard_ellipsoids const *simulation)
{
    if (simulation == nullptr) return nullptr;
    return reinterpret_cast<double const *>(simulation->engine.configuration.semi_axes.data());
}

size_t pw85_hard_ellipsoids_num_bytes(pw85_hard_ellipsoids const *simulation)
{
    return simulation == nullptr ? 0 : num_bytes(simulation->engine);
}

int pw85_hard_ellipsoids_save(pw85_hard_ellipsoids const *simulation, size_t size,
                              unsigned char *bytes)
{
    if (any_null(simulation) || any_null(bytes)) return PW85_EINVAL;
    if (size != pw85_hard_ellipsoids_num_bytes(simulation)) return PW85_EINVAL;
    Configuration const &configuration = simulation->engine.configuration;
    Header header;
    // no byte between members is left to chance
    std::memset(static_cast<void *>(&header), 0, sizeof header);
    header.mark = configuration.dimensions == 2 ? mark_of_plane : mark_of_space;
    if (has_more(simulation->engine)) header.mark += mark_of_environment;
    header.num_particles = configuration.size();
    header.parameters = simulation->engine.parameters;
    header.cell = configuration.cell;
    std::memcpy(bytes, &header, sizeof header);
    for (std::size_t i = 0; i < configuration.size(); ++i) {
        SavedParticle const particle{configuration.centers[i], configuration.quaternions[i],
                                     configuration.semi_axes[i]};
        std::memcpy(bytes + num_bytes(i), &particle, sizeof particle);
    }
    if (!has_more(simulation->engine)) return PW85_SUCCESS;
    return in_default_environment([&] {
        save_environment(simulation->engine, bytes + num_bytes(configuration.size()));
        return int{PW85_SUCCESS};
    });
}

int pw85_hard_ellipsoids_restore(size_t num_bytes, unsigned char const *bytes,
                                 pw85_hard_ellipsoids **simulation)
{
    if (any_null(simulation)) return PW85_EINVAL;
    *simulation = nullptr;
    if (any_null(bytes)) return PW85_EINVAL;
    return in_default_environment([&] { return restore(num_bytes, bytes, *simulation); });
}
