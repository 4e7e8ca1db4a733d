// SPDX-License-Identifier: BSD-3-Clause
// The C API of the trials of simulations, and of what is there afterwards.
#include <algorithm>

#include "../base/c_arrays.hpp"
#include "chains.hpp"
#include "hard_ellipsoids.hpp"

using namespace pw85;
using namespace pw85::detail;
using namespace pw85::detail::simulation;

namespace {

bool is_change_type(int type) noexcept
{
    return type >= 0 && type <= static_cast<int>(ChangeType::aspect);
}

/// Returns the status of trials of the volume.
int check_change(Engine const &engine, double pressure, int type) noexcept
{
    if (!is_change_type(type))
        return note_cause(PW85_EINVAL, "change", "must be a constant PW85_CHANGE_...", 0, 0, type);
    if (type != PW85_CHANGE_ASPECT && !(pressure > 0.0))
        return note_cause(PW85_EINVAL, "pressure", "must be > 0", 0, 0, pressure);
    if (!engine.particles.all().is_closed())
        return note_cause(PW85_EINVAL, "simulation",
                          engine.particles.all().dimensions == 2
                              ? "must have a cell that is periodic along its first two vectors"
                              : "must have a cell that is periodic along its three vectors");
    if (engine.hamiltonian.external.mesh.exists())
        return note_cause(PW85_EINVAL, "simulation", "must have no mesh");
    return PW85_SUCCESS;
}

/// Calls work() in a session until it fails or was called often enough.
template <class Work> int repeat(Engine &engine, std::size_t times, Work const &work) noexcept
{
    Session const session(engine);
    int status = session.status;
    for (std::size_t k = 0; k < times && status == PW85_SUCCESS; ++k) status = work();
    return status;
}

/// Runs sweeps, each followed by a trial of the volume if there is a pressure, and tunes the steps.
int tune(Engine &engine, std::size_t num_sweeps, double acceptance, double pressure,
         ChangeType type) noexcept
{
    std::fill_n(engine.parameters.species_counts, max_species, Counts{});
    int const status = repeat(engine, num_sweeps, [&] {
        Counts const before = engine.parameters.counts;
        if (int const bad = engine.sweeps.run()) return bad;
        if (pressure > 0.0 || type == ChangeType::aspect)
            if (int const bad = engine.volume_moves.run(pressure, type)) return bad;
        engine.parameters.tune(before, acceptance, engine.particles.copy(),
                               engine.hamiltonian.external);
        return int{PW85_SUCCESS};
    });
    if (status == PW85_SUCCESS) engine.parameters.counts = {};
    return status;
}

/// Runs event chains along a direction, or along random ones if it is zero.
int make_chains(Engine &engine, std::size_t num_chains, double length, Vector3 const &direction,
                PressureSample &sample) noexcept
{
    auto const n = static_cast<std::uint32_t>(engine.particles.all().size());
    bool const random = largest_coordinate(direction) == 0.0;
    Chains chains(engine.particles.change());
    if (int const status = chains.prepare()) return status;
    for (std::size_t k = 0; k < num_chains && n > 0; ++k) {
        Stream stream(engine.parameters.seed, engine.parameters.step++, UINT32_MAX);
        std::size_t const first = stream.below(n);
        Vector3 const along =
            unit(random ? stream.in_ball(engine.particles.all().dimensions) : direction);
        if (int const status = chains.run({first, along, length}, sample)) return status;
    }
    if (chains.own_images_may_touch()) sample.transfers = quiet_nan<double>();
    return PW85_SUCCESS;
}

/// Copies z of the centre, and x and y of the quaternion, from the old particle to the moved one in
/// two dimensions. Returns a status, which says whether the particle stays in its plane.
int keep_in_plane(Particle const &before, Particle &moved) noexcept
{
    if (moved.center[2] != before.center[2])
        return note_cause(PW85_EINVAL, "center", "must be in the plane of the ellipses", 0, 2,
                          moved.center[2]);
    if (moved.quaternion[1] != 0.0 || moved.quaternion[2] != 0.0)
        return note_cause(PW85_EINVAL, "quaternion",
                          "must be a rotation about z, which keeps the ellipse in its plane");
    moved.center[2] = before.center[2];
    for (int d = 1; d <= 2; ++d) moved.quaternion[d] = before.quaternion[d];
    return PW85_SUCCESS;
}

/// Sets the centre or the quaternion of a particle. Null keeps the old one. Returns a status.
int place(Engine const &engine, double const *center, double const *quaternion,
          Particle &moved) noexcept
{
    Particle const before = moved;
    if (center != nullptr) moved.center = c_api::load_vector<3>(center);
    if (quaternion != nullptr) moved.quaternion = unit(c_api::load_vector<4>(quaternion));
    if (engine.particles.all().dimensions == 2)
        if (int const status = keep_in_plane(before, moved)) return status;
    return quaternion == nullptr
               ? int{PW85_SUCCESS}
               : make_particle(moved.center, moved.quaternion, moved.semi_axes, moved);
}

/// Tries another centre or quaternion of a particle. Null keeps the old one.
int try_placement(Engine &engine, std::size_t particle, double const *center,
                  double const *quaternion, bool take, int &is_free) noexcept
{
    Particle moved = engine.particles.all().get(particle);
    if (int const status = place(engine, center, quaternion, moved)) return status;
    bool found = false;
    ExternalPotential const &external = engine.hamiltonian.external;
    if (int const status = external.check_potential()) return status;
    double const energy = external.energy(particle, moved, engine.particles.all().dimensions);
    if (elementary::isnan(energy)) return ExternalPotential::refuse_energy();
    is_free = 0;
    if (energy == infinity<double>() || external.cuts(moved, engine.particles.all().dimensions))
        return PW85_SUCCESS;
    is_free = -1;
    int const status = engine.try_placement(particle, moved, take, found);
    if (status == PW85_SUCCESS) is_free = found;
    if (status != PW85_EINVAL) return status;
    return note_cause(status, "center", "must not be too far away from the cell for its images");
}

/// Copies the first images to arrays of some capacity.
void store(Array<NearImage> const &found, std::size_t capacity, std::int32_t *particles,
           std::int32_t *images, double *separations) noexcept
{
    for (std::size_t k = 0; k < minimum(capacity, found.size()); ++k) {
        NearImage const &near = found[k];
        if (particles != nullptr) particles[k] = near.particle;
        if (images != nullptr) std::copy_n(near.image.n, 3, images + 3 * k);
        if (separations != nullptr) c_api::store(near.r12, separations + 3 * k);
    }
}

/// Computes the direction of chains, zero for random ones. Returns a status.
int load_direction(Engine const &engine, double const *direction, Vector3 &along) noexcept
{
    along = direction == nullptr ? Vector3{} : c_api::load_vector<3>(direction);
    if (engine.particles.all().dimensions != 2) return PW85_SUCCESS;
    if (along[2] != 0.0)
        return note_cause(PW85_EINVAL, "direction", "must be in the plane", 0, 2, along[2]);
    along[2] = -0.0; // as Stream::in_disc()
    return PW85_SUCCESS;
}

} // namespace

int pw85::detail::hard_ellipsoids_sweep(pw85_hard_ellipsoids &simulation,
                                        size_t num_sweeps) noexcept
{
    Engine &engine = simulation.engine;
    return repeat(engine, num_sweeps, [&] { return engine.sweeps.run(); });
}

int pw85::detail::hard_ellipsoids_chain(pw85_hard_ellipsoids &simulation, size_t num_chains,
                                        double length, double const direction[3],
                                        double *compressibility) noexcept
{
    if (!simulation.engine.hamiltonian.is_hard())
        return note_cause(PW85_EINVAL, "simulation",
                          "must have no walls, mesh, fields, potential or law: use sweeps");
    Vector3 along;
    if (int const status = load_direction(simulation.engine, direction, along)) return status;
    PressureSample sample{};
    int const status = make_chains(simulation.engine, num_chains, length, along, sample);
    if (status == PW85_ECONVERGENCE)
        return note_cause(status, "length",
                          "must let chains advance: particles block each other within rounding "
                          "errors, or the length is too long",
                          0, 0, length);
    if (status == PW85_SUCCESS && compressibility != nullptr)
        *compressibility = sample.compressibility();
    return status;
}

int pw85::detail::hard_ellipsoids_volume_moves(pw85_hard_ellipsoids &simulation, size_t num_moves,
                                               double pressure, int change) noexcept
{
    Engine &engine = simulation.engine;
    if (int const status = check_change(engine, pressure, change)) return status;
    return repeat(engine, num_moves, [&] {
        return engine.volume_moves.run(pressure, static_cast<ChangeType>(change));
    });
}

int pw85::detail::hard_ellipsoids_tune(pw85_hard_ellipsoids &simulation, size_t num_sweeps,
                                       double acceptance, double pressure, int change) noexcept
{
    if (pressure > 0.0 || change == PW85_CHANGE_ASPECT)
        if (int const status = check_change(simulation.engine, pressure, change)) return status;
    return tune(simulation.engine, num_sweeps, acceptance, pressure,
                static_cast<ChangeType>(change));
}

int pw85::detail::hard_ellipsoids_neighbors(pw85_hard_ellipsoids &simulation, size_t particle,
                                            size_t capacity, size_t *count, int32_t *particles,
                                            int32_t *images, double *separations) noexcept
{
    if (int const status = check_index(simulation.engine, particle)) return status;
    Array<NearImage> found;
    if (int const status = simulation.engine.find_neighbors(particle, found)) return status;
    *count = found.size();
    store(found, capacity, particles, images, separations);
    return PW85_SUCCESS;
}

int pw85::detail::hard_ellipsoids_try(pw85_hard_ellipsoids &simulation, size_t particle,
                                      double const center[3], double const quaternion[4], int take,
                                      int *is_free) noexcept
{
    if (int const status = check_index(simulation.engine, particle)) return status;
    return try_placement(simulation.engine, particle, center, quaternion, take != 0, *is_free);
}

int pw85::detail::hard_ellipsoids_compress(pw85_hard_ellipsoids &simulation, int take,
                                           double *factor) noexcept
{
    Engine &engine = simulation.engine;
    if (!engine.hamiltonian.external.is_empty())
        return note_cause(PW85_EINVAL, "simulation",
                          "must have no walls, mesh, fields or potential");
    double found = 0.0;
    Session const session(engine);
    int status = session.status;
    if (status == PW85_SUCCESS) status = engine.volume_moves.compress(take != 0, found);
    if (status == PW85_SUCCESS) *factor = found;
    return status;
}

int pw85::detail::hard_ellipsoids_check(pw85_hard_ellipsoids const &simulation,
                                        int32_t pair[2]) noexcept
{
    return simulation.engine.check(pair);
}

pw85_system pw85_hard_ellipsoids_system(pw85_hard_ellipsoids const *simulation)
{
    if (simulation == nullptr) return {0, nullptr, nullptr, nullptr, {0, 0, 0}};
    return simulation->engine.particles.all().system();
}

double const *pw85_hard_ellipsoids_quaternions(pw85_hard_ellipsoids const *simulation)
{
    if (simulation == nullptr) return nullptr;
    return reinterpret_cast<double const *>(simulation->engine.particles.all().quaternions.data());
}

double const *pw85_hard_ellipsoids_semi_axes(pw85_hard_ellipsoids const *simulation)
{
    if (simulation == nullptr) return nullptr;
    return reinterpret_cast<double const *>(simulation->engine.particles.all().semi_axes.data());
}
