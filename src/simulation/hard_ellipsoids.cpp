// SPDX-License-Identifier: BSD-3-Clause
// The C API of the trials of simulations, and of what is there afterwards.
#include <cmath>

#include "../base/c_arrays.hpp"
#include "../base/floating_point_environment.hpp"
#include "chains.hpp"
#include "hard_ellipsoids.hpp"

using namespace pw85;
using namespace pw85::detail;
using namespace pw85::detail::simulation;
using pw85::detail::c_api::any_null;

namespace {

bool is_change_type(int type) noexcept
{
    return type >= 0 && type <= static_cast<int>(ChangeType::aspect);
}

bool can_change(Engine const &engine, double pressure, int type) noexcept
{
    bool const has_pressure = type == PW85_CHANGE_ASPECT || pressure > 0.0;
    return is_change_type(type) && has_pressure && std::isfinite(pressure) &&
           engine.configuration.is_closed() && !engine.external.mesh.exists();
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
         ChangeType type) noexcept
{
    std::fill_n(engine.species_counts, max_species, Counts{});
    int const status = repeat(engine, num_sweeps, [&] {
        Counts const before = engine.parameters.counts;
        if (int const bad = engine.sweep()) return bad;
        if (pressure > 0.0 || type == ChangeType::aspect)
            if (int const bad = engine.try_volume(pressure, type)) return bad;
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
    ExternalPotential const &external = engine.external;
    if (external.lacks_potential) return PW85_EPOTENTIAL;
    double const energy = external.energy(particle, moved, engine.configuration.dimensions);
    if (std::isnan(energy)) return PW85_EPOTENTIAL;
    is_free = 0;
    if (energy == HUGE_VAL || external.cuts(moved, engine.configuration.dimensions))
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

} // namespace

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
    if (!simulation->engine.is_hard()) return PW85_EINVAL;
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
                      [&] { return engine.try_volume(pressure, static_cast<ChangeType>(change)); });
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
                    static_cast<ChangeType>(change));
    });
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
    if (any_null(simulation, factor) || !simulation->engine.external.is_empty()) return PW85_EINVAL;
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
