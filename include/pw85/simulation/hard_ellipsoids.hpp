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
        : object_(simulation)
    {
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

    /// Makes event chains along random directions: see pw85_hard_ellipsoids_chain().
    [[gnu::always_inline]] StatusCode chain(std::size_t num_chains, double length,
                                            double &compressibility) noexcept
    {
        return static_cast<StatusCode>(
            pw85_hard_ellipsoids_chain(get(), num_chains, length, nullptr, &compressibility));
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

    [[gnu::always_inline]] pw85_hard_ellipsoids *get() const noexcept { return object_.get(); }

    // Made by api/committed.py: members of pw85_hard_ellipsoids
    // clang-format off
    /// Sets the number of dimensions of a simulation: see pw85_hard_ellipsoids_set_dimensions().
    [[gnu::always_inline]] StatusCode set_dimensions(int dimensions) noexcept
    {
        return static_cast<StatusCode>(pw85_hard_ellipsoids_set_dimensions(get(), dimensions));
    }

    /// Returns the number of dimensions of a simulation: see pw85_hard_ellipsoids_dimensions().
    [[gnu::always_inline]] int dimensions() const noexcept
    {
        int dimensions;
        static_cast<void>(pw85_hard_ellipsoids_dimensions(get(), &dimensions));
        return dimensions;
    }

    /// Returns the number of bytes that pw85_hard_ellipsoids_save() writes: see
    /// pw85_hard_ellipsoids_num_bytes().
    [[gnu::always_inline]] std::size_t num_bytes() const noexcept
    {
        return pw85_hard_ellipsoids_num_bytes(get());
    }

    /// Writes the whole state of a simulation as bytes: see pw85_hard_ellipsoids_save().
    [[gnu::always_inline]] StatusCode save(std::span<unsigned char> bytes) const noexcept
    {
        return static_cast<StatusCode>(pw85_hard_ellipsoids_save(get(), bytes.size(),
                                                                 detail::in_c(bytes)));
    }

    /// Sets the hard walls of a simulation, and removes the walls that it had: see
    /// pw85_hard_ellipsoids_set_walls().
    [[gnu::always_inline]] StatusCode set_walls(std::span<Wall const> walls,
                                                IndexPair &overlap) noexcept
    {
        return static_cast<StatusCode>(pw85_hard_ellipsoids_set_walls(get(), walls.size(),
                                                                      walls.data(),
                                                                      overlap.data()));
    }

    /// Sets the hard mesh of a simulation, and removes the mesh that it had: see
    /// pw85_hard_ellipsoids_set_mesh().
    [[gnu::always_inline]] StatusCode set_mesh(
        Vectors vertices, std::span<std::array<std::int32_t, 3> const> triangles,
        IndexPair &overlap) noexcept
    {
        return static_cast<StatusCode>(pw85_hard_ellipsoids_set_mesh(get(), vertices.size(),
                                                                     detail::in_c(vertices),
                                                                     triangles.size(),
                                                                     detail::in_c(triangles),
                                                                     overlap.data()));
    }

    /// Sets the fields of a simulation, and removes the fields that it had: see
    /// pw85_hard_ellipsoids_set_fields().
    [[gnu::always_inline]] StatusCode set_fields(std::span<Field const> fields) noexcept
    {
        return static_cast<StatusCode>(pw85_hard_ellipsoids_set_fields(get(), fields.size(),
                                                                       fields.data()));
    }

    /// Sets the potential of a simulation, in addition to its fields, or removes it: see
    /// pw85_hard_ellipsoids_set_potential().
    [[gnu::always_inline]] StatusCode set_potential(pw85_potential *potential,
                                                    void *context) noexcept
    {
        return static_cast<StatusCode>(pw85_hard_ellipsoids_set_potential(get(), potential,
                                                                          context));
    }

    /// Sets or removes a pair potential in addition to the hard cores: see
    /// pw85_hard_ellipsoids_set_law().
    [[gnu::always_inline]] StatusCode set_law(Law const &law) noexcept
    {
        pw85_law const law_in_c = detail::in_c(law);
        return static_cast<StatusCode>(pw85_hard_ellipsoids_set_law(get(), &law_in_c));
    }

    /// Makes sweeps: see pw85_hard_ellipsoids_sweep().
    [[gnu::always_inline]] StatusCode sweep(std::size_t num_sweeps) noexcept
    {
        return static_cast<StatusCode>(pw85_hard_ellipsoids_sweep(get(), num_sweeps));
    }

    /// Makes event chains, which translate many particles at once and give the pressure: see
    /// pw85_hard_ellipsoids_chain().
    [[gnu::always_inline]] StatusCode chain(std::size_t num_chains, double length,
                                            Vector<double, 3> const &direction,
                                            double &compressibility) noexcept
    {
        return static_cast<StatusCode>(pw85_hard_ellipsoids_chain(get(), num_chains, length,
                                                                  direction.coordinates,
                                                                  &compressibility));
    }

    /// Makes volume moves: see pw85_hard_ellipsoids_volume_moves().
    [[gnu::always_inline]] StatusCode volume_moves(
        std::size_t num_moves, double pressure, CellChange change = CellChange::isotropic) noexcept
    {
        return static_cast<StatusCode>(pw85_hard_ellipsoids_volume_moves(get(), num_moves, pressure,
                                                                         static_cast<int>(change)));
    }

    /// Makes sweeps, and adjusts the step sizes after each sweep towards an acceptance ratio: see
    /// pw85_hard_ellipsoids_tune().
    [[gnu::always_inline]] StatusCode tune(std::size_t num_sweeps, double acceptance,
                                           double pressure = 0.0,
                                           CellChange change = CellChange::isotropic) noexcept
    {
        return static_cast<StatusCode>(pw85_hard_ellipsoids_tune(get(), num_sweeps, acceptance,
                                                                 pressure,
                                                                 static_cast<int>(change)));
    }

    /// Sets which fractions of the trials of a sweep are translations, rotations, both at once, and
    /// exchanges: see pw85_hard_ellipsoids_set_fractions().
    [[gnu::always_inline]] StatusCode set_fractions(TrialFractions const &fractions) noexcept
    {
        auto const &[translation, rotation, both, exchange] = fractions;
        double const fractions_in_c[] = {translation, rotation, both, exchange};
        return static_cast<StatusCode>(pw85_hard_ellipsoids_set_fractions(get(), fractions_in_c));
    }

    /// Sets the step sizes: see pw85_hard_ellipsoids_set_steps().
    [[gnu::always_inline]] StatusCode set_steps(TrialSteps const &steps) noexcept
    {
        auto const &[translation, rotation, volume] = steps;
        double const steps_in_c[] = {translation, rotation, volume};
        return static_cast<StatusCode>(pw85_hard_ellipsoids_set_steps(get(), steps_in_c));
    }

    /// Returns the step sizes: see pw85_hard_ellipsoids_steps().
    [[gnu::always_inline]] TrialSteps steps() const noexcept
    {
        double steps[3];
        static_cast<void>(pw85_hard_ellipsoids_steps(get(), steps));
        return {steps[0], steps[1], steps[2]};
    }

    /// Returns the numbers of trials since the simulation was made or tuned: see
    /// pw85_hard_ellipsoids_counts().
    [[gnu::always_inline]] TrialCounts counts() const noexcept
    {
        TrialCounts found{};
        static_cast<void>(pw85_hard_ellipsoids_counts(get(), found.trials.data(),
                                                      found.accepted.data()));
        return found;
    }

    /// Tests whether a particle would have no overlaps at another position, and on request moves it
    /// there: see pw85_hard_ellipsoids_try().
    [[gnu::always_inline]] StatusCode try_placement(std::size_t particle,
                                                    Vector<double, 3> const &center,
                                                    Vector<double, 4> const &quaternion, bool take,
                                                    bool &is_free) noexcept
    {
        int is_free_in_c = -1;
        int const status = pw85_hard_ellipsoids_try(get(), particle, center.coordinates,
                                                    quaternion.coordinates, static_cast<int>(take),
                                                    &is_free_in_c);
        is_free = is_free_in_c == 1;
        return static_cast<StatusCode>(status);
    }

    /// Tests whether a new particle would have no overlaps, and on request inserts it as the last
    /// particle: see pw85_hard_ellipsoids_insert().
    [[gnu::always_inline]] StatusCode insert(Vector<double, 3> const &center,
                                             Vector<double, 4> const &quaternion,
                                             Vector<double, 3> const &semi_axes, bool take,
                                             bool &is_free) noexcept
    {
        int is_free_in_c = -1;
        int const status = pw85_hard_ellipsoids_insert(get(), center.coordinates,
                                                       quaternion.coordinates,
                                                       semi_axes.coordinates,
                                                       static_cast<int>(take), &is_free_in_c);
        is_free = is_free_in_c == 1;
        return static_cast<StatusCode>(status);
    }

    /// Removes a particle: see pw85_hard_ellipsoids_remove().
    [[gnu::always_inline]] StatusCode remove(std::size_t particle) noexcept
    {
        return static_cast<StatusCode>(pw85_hard_ellipsoids_remove(get(), particle));
    }

    /// Computes the mean of e^(-βU) over trial insertions of a particle at random positions
    /// (Widom's method): see pw85_hard_ellipsoids_insertion_weight().
    [[gnu::always_inline]] StatusCode insertion_weight(std::size_t num_trials,
                                                       Vector<double, 3> const &semi_axes,
                                                       double &weight) noexcept
    {
        return static_cast<StatusCode>(pw85_hard_ellipsoids_insertion_weight(get(), num_trials,
                                                                             semi_axes.coordinates,
                                                                             &weight));
    }

    /// Makes trial insertions and removals of particles at constant activities: see
    /// pw85_hard_ellipsoids_insertion_moves().
    [[gnu::always_inline]] StatusCode insertion_moves(std::size_t num_moves, Vectors semi_axes,
                                                      std::span<double const> activities,
                                                      std::array<std::int64_t, 4> &counts) noexcept
    {
        counts = {-1, -1, -1, -1};
        if (!detail::have_rows(semi_axes.size(), activities)) return StatusCode::invalid_argument;
        return static_cast<StatusCode>(pw85_hard_ellipsoids_insertion_moves(
            get(), num_moves, semi_axes.size(), detail::in_c(semi_axes), detail::in_c(activities),
            counts.data()));
    }

    /// Computes the sum of the energies of all particles in the fields and the potential, and of
    /// all pairs by the law, in units of k_B T: see pw85_hard_ellipsoids_energy().
    [[gnu::always_inline]] StatusCode energy(double &energy) const noexcept
    {
        return static_cast<StatusCode>(pw85_hard_ellipsoids_energy(get(), &energy));
    }

    /// Computes the virial of the pair potential, W = -2 Σ μ² dβU/dμ², which adds to the pressure
    /// of the hard cores: see pw85_hard_ellipsoids_law_virial().
    [[gnu::always_inline]] StatusCode law_virial(double &virial) const noexcept
    {
        return static_cast<StatusCode>(pw85_hard_ellipsoids_law_virial(get(), &virial));
    }

    /// Searches all particles for overlaps: see pw85_hard_ellipsoids_check().
    [[gnu::always_inline]] StatusCode check(IndexPair &pair) const noexcept
    {
        return static_cast<StatusCode>(pw85_hard_ellipsoids_check(get(), pair.data()));
    }

    /// Computes the factor by which the cell and the centres can be compressed until particles
    /// touch, and on request compresses them: see pw85_hard_ellipsoids_compress().
    [[gnu::always_inline]] StatusCode compress(bool take, double &factor) noexcept
    {
        return static_cast<StatusCode>(pw85_hard_ellipsoids_compress(get(), static_cast<int>(take),
                                                                     &factor));
    }
    // clang-format on

  private:
    struct Destroy {
        [[gnu::always_inline]] void operator()(pw85_hard_ellipsoids *object) const noexcept
        {
            pw85_hard_ellipsoids_destroy(object);
        }
    };
    std::unique_ptr<pw85_hard_ellipsoids, Destroy> object_;
};

// Made by api/committed.py: functions of pw85_simulation_state.h
// clang-format off
/// Makes a simulation: see pw85_hard_ellipsoids_create().
///
/// @param particles centres, forms and cell; sizes must fit, and indices be those of particles
/// @param semi_axes one for each particle: lengths of the principal semi-axes of each particle,
/// whose squares are in the range of double; > 0
/// @param quaternions one for each particle: (w, x, y, z), of any lengths; not zero
/// @param seed selects the random numbers
/// @param[out] simulation empty on error
/// @param[out] pair the first two particles that overlap; twice the same index if a particle
/// overlaps its own image; -1 if no particles overlap
/// @return Status::success; Status::overlap if particles overlap; Status::invalid_argument and
/// Status::not_positive_definite as for neighbors_create(); Status::out_of_memory, also if
/// particles are so long that a neighbour list has more than 2¹⁵ images of the cell, or 2¹³ pairs
/// per particle
static inline StatusCode hard_ellipsoids_create(Particles const &particles, Vectors semi_axes,
                                                std::span<Vector<double, 4> const> quaternions,
                                                std::size_t seed, HardEllipsoids &simulation,
                                                IndexPair &pair) noexcept
{
    simulation = HardEllipsoids();
    pair = {-1, -1};
    if (!detail::have_rows(particles.centers.size(), detail::optional(particles.q), semi_axes,
        quaternions)) return StatusCode::invalid_argument;
    pw85_system const particles_in_c = detail::in_c(particles);
    pw85_hard_ellipsoids *made = nullptr;
    int const status = pw85_hard_ellipsoids_create(&particles_in_c, detail::in_c(semi_axes),
                                                   detail::in_c(quaternions), seed, pair.data(),
                                                   &made);
    simulation = HardEllipsoids(made);
    return static_cast<StatusCode>(status);
}

/// Makes a simulation from the bytes of a saved one: see pw85_hard_ellipsoids_restore().
///
/// @param bytes one for each byte
/// @param[out] simulation empty on error
/// @return Status::success; Status::invalid_argument, also if the bytes are incomplete, have been
/// changed, have a later format, or come from a version before 3.1; Status::invalid_argument,
/// Status::overlap, Status::not_positive_definite, Status::bad_potential if they describe an
/// invalid state; Status::out_of_memory
static inline StatusCode hard_ellipsoids_restore(std::span<unsigned char const> bytes,
                                                 HardEllipsoids &simulation) noexcept
{
    simulation = HardEllipsoids();
    pw85_hard_ellipsoids *made = nullptr;
    int const status = pw85_hard_ellipsoids_restore(bytes.size(), detail::in_c(bytes), &made);
    simulation = HardEllipsoids(made);
    return static_cast<StatusCode>(status);
}
// clang-format on

} // namespace pw85

#endif
