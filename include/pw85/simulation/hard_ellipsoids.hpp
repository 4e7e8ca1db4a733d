// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Simulations of hard ellipsoids, for C++. The members call the functions of the compiled library
/// (link with pw85), and their contracts are those of pw85_simulation.h.
#ifndef PW85_SIMULATION_HARD_ELLIPSOIDS_HPP_INCLUDED
#define PW85_SIMULATION_HARD_ELLIPSOIDS_HPP_INCLUDED

#include <pw85_simulation.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include <pw85/simulation/surroundings.hpp>
#include <pw85/simulation/trials.hpp>
#include <pw85/systems/calls.hpp>

namespace pw85 {

/// A simulation and its memory; it can be moved, not copied.
class HardEllipsoids {
  public:
    /// An empty simulation, which functions refuse with Status::invalid_argument.
    HardEllipsoids() noexcept = default;
    /// Takes ownership of a simulation of the C API, which may be null.
    [[gnu::always_inline]] explicit HardEllipsoids(pw85_hard_ellipsoids *simulation) noexcept
        : simulation_(simulation)
    {
    }

    [[gnu::always_inline]] StatusCode set_dimensions(int dimensions) noexcept
    {
        return static_cast<StatusCode>(pw85_hard_ellipsoids_set_dimensions(get(), dimensions));
    }

    /// 2 or 3; -1 for a null simulation.
    [[gnu::always_inline]] int dimensions() const noexcept
    {
        int dimensions;
        static_cast<void>(pw85_hard_ellipsoids_dimensions(get(), &dimensions));
        return dimensions;
    }

    /// @param[out] overlap the first particle that a wall cuts, and the wall; or -1
    [[gnu::always_inline]] StatusCode set_walls(std::span<Wall const> walls,
                                                IndexPair &overlap) noexcept
    {
        return static_cast<StatusCode>(
            pw85_hard_ellipsoids_set_walls(get(), walls.size(), walls.data(), overlap.data()));
    }

    /// Sets the hard mesh, or none without triangles; see pw85_hard_ellipsoids_set_mesh().
    ///
    /// @param triangles indices of vertices, from 0
    /// @param[out] overlap the first particle that meets a triangle, and this triangle; or -1
    [[gnu::always_inline]] StatusCode
    set_mesh(std::span<Vector<double, 3> const> vertices,
             std::span<std::array<std::int32_t, 3> const> triangles, IndexPair &overlap) noexcept
    {
        return static_cast<StatusCode>(pw85_hard_ellipsoids_set_mesh(
            get(), vertices.size(), detail::in_c(vertices), triangles.size(),
            detail::in_c(triangles), overlap.data()));
    }

    [[gnu::always_inline]] StatusCode set_fields(std::span<Field const> fields) noexcept
    {
        return static_cast<StatusCode>(
            pw85_hard_ellipsoids_set_fields(get(), fields.size(), fields.data()));
    }

    /// Sets the law of the energies of pairs; see pw85_hard_ellipsoids_set_law().
    [[gnu::always_inline]] StatusCode set_law(Law const &law) noexcept
    {
        pw85_law const c_law = {law.kind, law.parameters.size(), law.parameters.data()};
        return static_cast<StatusCode>(pw85_hard_ellipsoids_set_law(get(), &c_law));
    }

    /// Takes the law away.
    [[gnu::always_inline]] StatusCode set_law(std::nullptr_t) noexcept
    {
        return static_cast<StatusCode>(pw85_hard_ellipsoids_set_law(get(), nullptr));
    }

    /// Sets a potential: energy(particle, center, quaternion, semi_axes) returns βU of a particle.
    /// It must not throw exceptions.
    ///
    /// @param energy lives as long as the simulation uses it
    template <class Energy>
    [[gnu::always_inline]] StatusCode set_potential(Energy const &energy) noexcept
    {
        pw85_potential *const call = [](void *context, std::int32_t particle, double const *center,
                                        double const *quaternion,
                                        double const *semi_axes) -> double {
            auto const &[x, y, z] = *reinterpret_cast<double const(*)[3]>(center);
            auto const &[w, i, j, k] = *reinterpret_cast<double const(*)[4]>(quaternion);
            auto const &[a, b, c] = *reinterpret_cast<double const(*)[3]>(semi_axes);
            return (*static_cast<Energy const *>(context))(particle, Vector<double, 3>{x, y, z},
                                                           Vector<double, 4>{w, i, j, k},
                                                           Vector<double, 3>{a, b, c});
        };
        return static_cast<StatusCode>(
            pw85_hard_ellipsoids_set_potential(get(), call, const_cast<Energy *>(&energy)));
    }

    /// Sets a potential of the C API, or none for null.
    [[gnu::always_inline]] StatusCode set_potential(pw85_potential *potential,
                                                    void *context) noexcept
    {
        return static_cast<StatusCode>(
            pw85_hard_ellipsoids_set_potential(get(), potential, context));
    }

    /// @param[out] energy of all particles in fields and potential, in the unit of k_B T
    [[gnu::always_inline]] StatusCode energy(double &energy) const noexcept
    {
        return static_cast<StatusCode>(pw85_hard_ellipsoids_energy(get(), &energy));
    }

    /// @param[out] virial of the law of pairs; see pw85_hard_ellipsoids_law_virial()
    [[gnu::always_inline]] StatusCode law_virial(double &virial) const noexcept
    {
        return static_cast<StatusCode>(pw85_hard_ellipsoids_law_virial(get(), &virial));
    }

    [[gnu::always_inline]] StatusCode sweep(std::size_t num_sweeps) noexcept
    {
        return static_cast<StatusCode>(pw85_hard_ellipsoids_sweep(get(), num_sweeps));
    }

    [[gnu::always_inline]] StatusCode
    volume_moves(std::size_t num_moves, double pressure,
                 CellChange change = CellChange::isotropic) noexcept
    {
        return static_cast<StatusCode>(pw85_hard_ellipsoids_volume_moves(get(), num_moves, pressure,
                                                                         static_cast<int>(change)));
    }

    /// Event chains along random directions.
    [[gnu::always_inline]] StatusCode chain(std::size_t num_chains, double length,
                                            double &compressibility) noexcept
    {
        return static_cast<StatusCode>(
            pw85_hard_ellipsoids_chain(get(), num_chains, length, nullptr, &compressibility));
    }

    /// Event chains along one direction.
    [[gnu::always_inline]] StatusCode chain(std::size_t num_chains, double length,
                                            Vector<double, 3> const &direction,
                                            double &compressibility) noexcept
    {
        return static_cast<StatusCode>(pw85_hard_ellipsoids_chain(
            get(), num_chains, length, direction.coordinates, &compressibility));
    }

    /// @param pressure 0 for no trials of the volume
    [[gnu::always_inline]] StatusCode tune(std::size_t num_sweeps, double acceptance,
                                           double pressure = 0.0,
                                           CellChange change = CellChange::isotropic) noexcept
    {
        return static_cast<StatusCode>(pw85_hard_ellipsoids_tune(
            get(), num_sweeps, acceptance, pressure, static_cast<int>(change)));
    }

    [[gnu::always_inline]] StatusCode set_fractions(TrialFractions const &fractions) noexcept
    {
        double const all[4] = {fractions.translation, fractions.rotation, fractions.both,
                               fractions.exchange};
        return static_cast<StatusCode>(pw85_hard_ellipsoids_set_fractions(get(), all));
    }

    [[gnu::always_inline]] StatusCode set_steps(TrialSteps const &steps) noexcept
    {
        double const all[3] = {steps.translation, steps.rotation, steps.volume};
        return static_cast<StatusCode>(pw85_hard_ellipsoids_set_steps(get(), all));
    }

    /// NaN for a null simulation.
    [[gnu::always_inline]] TrialSteps steps() const noexcept
    {
        double all[3];
        static_cast<void>(pw85_hard_ellipsoids_steps(get(), all));
        return {all[0], all[1], all[2]};
    }

    /// Steps of particles with some semi-axes, in place of all such steps: only translation and
    /// rotation are read.
    [[gnu::always_inline]] StatusCode set_kind_steps(Vectors semi_axes,
                                                     std::span<TrialSteps const> steps) noexcept
    {
        double all[2 * 16];
        std::size_t const n = steps.size();
        if (n > 16 || semi_axes.size() != n) return StatusCode::invalid_argument;
        for (std::size_t k = 0; k < n; ++k) {
            all[2 * k] = steps[k].translation;
            all[2 * k + 1] = steps[k].rotation;
        }
        return static_cast<StatusCode>(
            pw85_hard_ellipsoids_set_kind_steps(get(), n, detail::in_c(semi_axes), all));
    }

    /// Steps of particles with these semi-axes; NaN for a null simulation.
    [[gnu::always_inline]] TrialSteps kind_steps(Vector<double, 3> const &semi_axes) const noexcept
    {
        double own[2];
        static_cast<void>(pw85_hard_ellipsoids_kind_steps(get(), 1, semi_axes.coordinates, own));
        return {own[0], own[1], steps().volume};
    }

    /// -1 for a null simulation.
    [[gnu::always_inline]] TrialCounts counts() const noexcept
    {
        TrialCounts counts;
        static_cast<void>(
            pw85_hard_ellipsoids_counts(get(), counts.trials.data(), counts.accepted.data()));
        return counts;
    }

    /// Images near a particle. Arrays without elements are not written.
    ///
    /// @param[out] count of all images; the arrays get as many of them as the shortest one can have
    [[gnu::always_inline]] StatusCode
    neighbors(std::size_t particle, std::size_t &count, std::span<std::int32_t> particles = {},
              std::span<std::array<std::int32_t, 3>> images = {},
              std::span<Vector<double, 3>> separations = {}) noexcept
    {
        std::size_t capacity = SIZE_MAX;
        for (std::size_t const size : {particles.size(), images.size(), separations.size()})
            if (size > 0 && size < capacity) capacity = size;
        return static_cast<StatusCode>(pw85_hard_ellipsoids_neighbors(
            get(), particle, capacity, &count, particles.empty() ? nullptr : particles.data(),
            images.empty() ? nullptr : images.front().data(),
            separations.empty() ? nullptr : separations.front().coordinates));
    }

    /// Tries a place of a particle, and takes it if it is free and `take`.
    [[gnu::always_inline]] StatusCode try_placement(std::size_t particle,
                                                    Vector<double, 3> const &center,
                                                    Vector<double, 4> const &quaternion, bool take,
                                                    bool &is_free) noexcept
    {
        int found;
        int const status =
            pw85_hard_ellipsoids_try(get(), particle, center.coordinates, quaternion.coordinates,
                                     static_cast<int>(take), &found);
        is_free = found == 1;
        return static_cast<StatusCode>(status);
    }

    /// Tries a new particle, and inserts it if it is free and `take`. Take views of the particles
    /// again afterwards.
    [[gnu::always_inline]] StatusCode insert(Vector<double, 3> const &center,
                                             Vector<double, 4> const &quaternion,
                                             Vector<double, 3> const &semi_axes, bool take,
                                             bool &is_free) noexcept
    {
        int found;
        int const status =
            pw85_hard_ellipsoids_insert(get(), center.coordinates, quaternion.coordinates,
                                        semi_axes.coordinates, static_cast<int>(take), &found);
        is_free = found == 1;
        return static_cast<StatusCode>(status);
    }

    /// Removes a particle, whose index the last one takes. Take views again afterwards.
    [[gnu::always_inline]] StatusCode remove(std::size_t particle) noexcept
    {
        return static_cast<StatusCode>(pw85_hard_ellipsoids_remove(get(), particle));
    }

    /// @param[out] weight mean of e^-βU of a particle that is inserted at random, 0 where it
    /// overlaps others
    [[gnu::always_inline]] StatusCode insertion_weight(std::size_t num_trials,
                                                       Vector<double, 3> const &semi_axes,
                                                       double &weight) noexcept
    {
        return static_cast<StatusCode>(pw85_hard_ellipsoids_insertion_weight(
            get(), num_trials, semi_axes.coordinates, &weight));
    }

    /// Insertions and removals at constant activities. Take views again afterwards.
    ///
    /// @param[out] counts insertions, accepted ones, removals, accepted ones
    [[gnu::always_inline]] StatusCode insertion_moves(std::size_t num_moves, Vectors semi_axes,
                                                      std::span<double const> activities,
                                                      std::array<std::int64_t, 4> &counts) noexcept
    {
        counts = {-1, -1, -1, -1};
        if (semi_axes.size() != activities.size()) return StatusCode::invalid_argument;
        return static_cast<StatusCode>(pw85_hard_ellipsoids_insertion_moves(
            get(), num_moves, activities.size(), detail::in_c(semi_axes), activities.data(),
            counts.data()));
    }

    /// @param[out] factor of all lengths, with which particles nearly touch
    [[gnu::always_inline]] StatusCode compress(bool take, double &factor) noexcept
    {
        return static_cast<StatusCode>(
            pw85_hard_ellipsoids_compress(get(), static_cast<int>(take), &factor));
    }

    /// @param[out] pair the first overlap, or -1
    [[gnu::always_inline]] StatusCode check(IndexPair &pair) const noexcept
    {
        return static_cast<StatusCode>(pw85_hard_ellipsoids_check(get(), pair.data()));
    }

    /// Centres, forms and cell. They are valid as long as this object lives, and show the present
    /// state until particles are inserted or removed.
    [[gnu::always_inline]] pw85_system system() const noexcept
    {
        return pw85_hard_ellipsoids_system(get());
    }

    /// Of length one; valid as long as system() is.
    [[gnu::always_inline]] std::span<Vector<double, 4> const> quaternions() const noexcept
    {
        return {
            reinterpret_cast<Vector<double, 4> const *>(pw85_hard_ellipsoids_quaternions(get())),
            system().num_particles};
    }

    /// Valid as long as system() is.
    [[gnu::always_inline]] Vectors semi_axes() const noexcept
    {
        return {reinterpret_cast<Vector<double, 3> const *>(pw85_hard_ellipsoids_semi_axes(get())),
                system().num_particles};
    }

    /// Returns the length of the array that save() fills.
    [[gnu::always_inline]] std::size_t num_bytes() const noexcept
    {
        return pw85_hard_ellipsoids_num_bytes(get());
    }

    [[gnu::always_inline]] StatusCode save(std::span<unsigned char> bytes) const noexcept
    {
        return static_cast<StatusCode>(
            pw85_hard_ellipsoids_save(get(), bytes.size(), bytes.data()));
    }

    [[gnu::always_inline]] pw85_hard_ellipsoids *get() const noexcept { return simulation_.get(); }

  private:
    struct Destroy {
        [[gnu::always_inline]] void operator()(pw85_hard_ellipsoids *simulation) const noexcept
        {
            pw85_hard_ellipsoids_destroy(simulation);
        }
    };
    std::unique_ptr<pw85_hard_ellipsoids, Destroy> simulation_;
};

/// Makes a simulation: see pw85_hard_ellipsoids_create().
///
/// @param particles centres and cell; the forms are not read
/// @param semi_axes,quaternions one for each particle
/// @param seed selects the random numbers
/// @param[out] simulation null on error
/// @param[out] pair the first overlap, or -1
/// @return Status::success, Status::overlap, Status::invalid_argument,
/// Status::not_positive_definite, Status::out_of_memory
static inline StatusCode hard_ellipsoids_create(Particles const &particles, Vectors semi_axes,
                                                std::span<Vector<double, 4> const> quaternions,
                                                std::size_t seed, HardEllipsoids &simulation,
                                                IndexPair &pair) noexcept
{
    simulation = HardEllipsoids();
    pair = {-1, -1};
    std::size_t const n = particles.centers.size();
    if (semi_axes.size() != n || quaternions.size() != n) return StatusCode::invalid_argument;
    pw85_hard_ellipsoids *made = nullptr;
    pw85_system const system = detail::in_c(particles);
    int const status = pw85_hard_ellipsoids_create(
        &system, detail::in_c(semi_axes), detail::in_c(quaternions), seed, pair.data(), &made);
    simulation = HardEllipsoids(made);
    return static_cast<StatusCode>(status);
}

/// Makes a simulation from saved bytes: see pw85_hard_ellipsoids_restore().
///
/// @param bytes from HardEllipsoids::save()
/// @param[out] simulation null on error
/// @return Status::success, Status::invalid_argument, Status::overlap,
/// Status::not_positive_definite, Status::bad_potential, Status::out_of_memory
static inline StatusCode hard_ellipsoids_restore(std::span<unsigned char const> bytes,
                                                 HardEllipsoids &simulation) noexcept
{
    pw85_hard_ellipsoids *made = nullptr;
    int const status = pw85_hard_ellipsoids_restore(bytes.size(), bytes.data(), &made);
    simulation = HardEllipsoids(made);
    return static_cast<StatusCode>(status);
}

} // namespace pw85

#endif
