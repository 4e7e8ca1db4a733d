// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Monte Carlo of hard ellipsoids. hard_ellipsoids.cpp offers it in the C API.
///
/// The target is the uniform distribution of all configurations without overlaps. A trial is
/// accepted if it leads to no overlap. It is in detailed balance with this target, if the trial
/// that leads back is equally probable. Walls, fields and a potential (external_potential.hpp) may
/// reject a trial before the overlap test, energies of pairs (pair_energy.hpp) after it.
#ifndef PW85_SIMULATION_ENGINE_HPP_INCLUDED
#define PW85_SIMULATION_ENGINE_HPP_INCLUDED

#include <memory>

#include "change.hpp"
#include "domain_scheduler.hpp"
#include "domains.hpp"
#include "external_potential.hpp"
#include "float_boxes.hpp"
#include "memory_order.hpp"
#include "pair_energy.hpp"

namespace pw85::detail::simulation {

/// The types of trials, in the order of the C API: a translation by a point of a ball; a rotation
/// by the quaternion (1, v), in which v is a point of a ball and its negative belongs to the
/// reverse move; both; an exchange of the semi-axes of two particles of a domain; and a change of
/// the volume.
///
/// In two dimensions (configuration.hpp) translations are by a point of a disc. A rotation is by
/// the quaternion (1, 0, 0, v), v uniform in an interval around 0. Its angle, 2 atan(v), is an odd
/// function of v, and angles about z add. So the density of the angle is even, and the reverse move
/// is equally probable.
enum Move {
    translation,
    rotation,
    both,
    exchange,
    num_particle_moves,
    volume = num_particle_moves,
    num_moves
};

/// Trials and how many of them were accepted, by type.
struct Counts {
    std::int64_t trials[num_moves], accepted[num_moves];

    void add(Counts const &other) noexcept
    {
        for (int k = 0; k < num_moves; ++k) {
            trials[k] += other.trials[k];
            accepted[k] += other.accepted[k];
        }
    }

    void subtract(Counts const &other) noexcept
    {
        for (int k = 0; k < num_moves; ++k) {
            trials[k] -= other.trials[k];
            accepted[k] -= other.accepted[k];
        }
    }
};

/// The steps of particles with these semi-axes, and what became of their trials. Steps may depend
/// on the semi-axes of the particle, because a translation or a rotation does not change these.
struct SpeciesSteps {
    Vector3 semi_axes;
    double translation, rotation;

    [[gnu::always_inline]] bool has(Vector3 const &axes) const noexcept
    {
        return axes[0] == semi_axes[0] && axes[1] == semi_axes[1] && axes[2] == semi_axes[2];
    }
};

/// Maximum number of species with their own step sizes.
inline constexpr std::size_t max_species = 16;

/// Parameters of a simulation in addition to its particles.
struct Parameters {
    /// `step` counts sweeps, chains, and trials of the volume, of insertions and of removals: it
    /// selects the random numbers
    std::uint64_t seed, step;
    double translation, rotation, volume; ///< the largest changes of a trial
    double fractions[num_particle_moves]; ///< of the types of trials in a sweep; their sum is 1
    Counts counts;
};

/// An image of a particle near another one, and the separation from the centre of that one.
struct NearImage {
    std::int32_t particle;
    Multiples image;
    Vector3 r12;
};

/// Progress of the work on a domain.
struct Progress {
    Stream stream;
    std::uint32_t remaining; ///< trials that remain
};

/// The work on a domain. Each thread has its own: threads do not write to the same cache lines.
struct DomainRun {
    Progress progress;
    Label domain;
    ReadableDomains readable;
    std::span<std::int32_t const> next; ///< members of the domain that follows in the order
    Counts counts;
    Counts *counts_by_species; ///< counts of the species that have steps of their own; null without
};

/// Arrays that a configuration has outgrown. The caller may still read them: see
/// pw85_hard_ellipsoids_system().
struct RetiredArrays {
    Array<Vector3> centers, semi_axes;
    Array<Quaternion> quaternions;
    Array<Form3> q;
    std::unique_ptr<RetiredArrays> older;

    ~RetiredArrays(); // not inline: the linker would merge copies
};

/// Finds an overlap by a list of neighbours of its own, and returns PW85_EOVERLAP and the first
/// pair; PW85_SUCCESS if there is none.
int find_first_overlap(Configuration const &configuration, std::int32_t *pair) noexcept;

class Engine {
  public:
    Configuration configuration; ///< in the caller's order; as it was before the session
    Parameters parameters{};
    ExternalPotential external;              ///< changes outside of sessions
    PairEnergy pair_energy;                  ///< to be changed by set_law()
    Array<SpeciesSteps> species;             ///< with steps of their own: at most max_species
    Counts species_counts[max_species] = {}; ///< since tuning began

    Engine() noexcept; // not inline, as that of RetiredArrays
    ~Engine();

    /// To be called after the configuration is set. Rows are not made yet: in two dimensions they
    /// are shorter where the third semi-axes are long. Returns a status.
    int start() noexcept;

    /// To be called for a configuration that allows it, outside of sessions.
    void set_dimensions(int dimensions) noexcept;

    /// Makes translations no longer than `longest`, because the cell has become smaller.
    void limit_translations(double longest) noexcept;

    /// Sets the law of the energies of pairs, outside of sessions. Returns a status.
    int set_law(pw85_law const *law) noexcept;

    /// Returns whether nothing but the hard cores acts on the particles.
    bool is_hard() const noexcept { return external.is_empty() && !pair_energy.exists(); }

    /// Computes the energy of all pairs of the configuration, by a list of neighbours of its own.
    /// Returns a status.
    int energy_of_pairs(double &energy) const noexcept;

    /// Calls work() in a session, and returns its status. In a session, sweeps, trials of the
    /// volume and compress() change a copy of the configuration. At its end the configuration
    /// becomes the copy, whether or not they were successful.
    template <class Work> [[gnu::always_inline]] int in_session(Work const &work) noexcept
    {
        int status = begin();
        if (status == PW85_SUCCESS) status = work();
        end();
        return status;
    }

    /// To be called after something else has moved particles of the configuration.
    void forget() noexcept { is_taken_ = false; }

    /// Makes as many trials as there are particles. Returns a status. With fields or a potential,
    /// the configuration first becomes the copy, because a sweep that fails goes back to it.
    ///
    /// A sweep divides the cell at random (domains.hpp). For a given division, each domain gets as
    /// many trials as it has particles, each of a random particle, and a trial that leaves the
    /// domain is rejected. So trials are reversible: the particles of each domain stay the same.
    /// The order of the colours is random, and all orders are equally probable. So a sweep is in
    /// detailed balance, too.
    int sweep() noexcept;

    /// Tries one change of the volume. The pressure is that times β.
    ///
    /// The trial multiplies the vectors of the cell and all centres by a matrix E from the right
    /// (change.hpp). E and its inverse are equally probable. The volume V then changes to V det E,
    /// and the density of the states of N particles, V^N exp(-βPV) dV, gives the probability min(1,
    /// (det E)^(N+1) exp(-βP V (det E - 1))) of acceptance. One factor det E comes from the choice
    /// of a multiple of V instead of a difference. In two dimensions the area takes the place of V,
    /// and E changes x and y only. The overlap test is the last step.
    int try_volume(double pressure, ChangeType type) noexcept;

    /// Finds the images whose bounding boxes meet that of a particle, ordered by particles and
    /// multiples. Returns a status.
    int find_neighbors(std::size_t particle, Array<NearImage> &found) noexcept;

    /// Returns whether a particle is free at another place. If so and if `take`, it stays there.
    /// Returns a status.
    int try_placement(std::size_t particle, Particle const &moved, bool take,
                      bool &is_free) noexcept;

    /// Computes the least isotropic factor of cell and centres without overlap, at most 1; 0 if
    /// there is nothing to overlap. If `take`, it is applied, in a session. Returns a status.
    int compress(bool take, double &factor) noexcept;

    /// Adds a particle as the last one. Returns a status.
    int add(Particle const &particle) noexcept;

    /// Removes a particle. The last one takes its number.
    void remove(std::size_t particle) noexcept;

    /// As find_first_overlap(); then the first particle that a wall cuts, and -1.
    int check(std::int32_t *pair) const noexcept;

    /// Changes the largest changes of a trial towards an acceptance, by the counts since `before`,
    /// and those of the species.
    void tune(Counts const &before, double acceptance) noexcept;

    /// The number of the species of a particle with steps of its own, or how many there are.
    std::size_t species_of(Vector3 const &semi_axes) const noexcept
    {
        std::size_t k = 0;
        while (k < species.size() && !species[k].has(semi_axes)) ++k;
        return k;
    }

    /// Returns the steps of particles with these semi-axes.
    SpeciesSteps steps_of(Vector3 const &semi_axes) const noexcept
    {
        std::size_t const k = species_of(semi_axes);
        return k < species.size()
                   ? species[k]
                   : SpeciesSteps{semi_axes, parameters.translation, parameters.rotation};
    }

  private:
    /// Outcome of a trial move. Decisions are those of the exact overlap test for the rounded
    /// separations. The Verlet list only saves work. If a trial that would be accepted leaves
    /// its fixed box, it is `unlisted`, and the domain stops before this trial. The Verlet list
    /// is then rebuilt, and the domain continues with the same random numbers. So the list does not
    /// influence the result.
    enum class Outcome { rejected, accepted, unlisted, failed };

    /// Images that are tested together.
    static constexpr std::size_t most_candidates = 64;
    static_assert(2 * most_candidates <= kernels::most_images);

    void measure() noexcept;
    int rebuild_list() noexcept;
    int begin() noexcept;
    void end() noexcept;
    int order() noexcept;
    void refresh_boxes() noexcept;
    bool set_cell() noexcept;
    bool all_within_skin(double displacement) const noexcept;

    /// Returns whether particle i is in its fixed box, and stays there if it moves by
    /// `displacement` along any axis.
    [[gnu::always_inline]] bool is_within_skin(std::size_t i,
                                               double displacement = 0.0) const noexcept
    {
        return neighborhood_.holds(i, ordered_.centers[i],
                                   pair_energy.reach() * ordered_.half_widths[i], displacement);
    }

    /// Images that may overlap a particle.
    struct Candidates {
        Neighbor images[2 * most_candidates];
        std::size_t count = 0;

        /// Adds the image if `may_overlap`, without a branch, which would often be mispredicted.
        [[gnu::always_inline]] void add(Neighbor const &image, bool may_overlap) noexcept
        {
            images[count] = image;
            count += may_overlap;
        }
    };

    /// Adds the neighbours of particle i that may overlap it and have is_read(j). Other particles
    /// are not read. Returns false if test(), which is called when there is no room for more, finds
    /// an overlap.
    template <class IsRead>
    [[gnu::always_inline]] bool overlaps(std::size_t i, IsRead const &is_read) const noexcept
    {
        Candidates found;
        auto const search = boxes_.search(i);
        Row const row = neighborhood_.row(i);
        auto const overlaps_found = [&] {
            return overlaps_any(i, found.images, std::exchange(found.count, 0));
        };
        // in parts: there is memory for all of a part
        auto const add_all = [&](std::size_t size, auto const &add) {
            for (std::size_t begin = 0; begin < size; begin += most_candidates) {
                std::size_t const end = std::min(size, begin + most_candidates);
                for (std::size_t k = begin; k < end; ++k) add(k);
                if (found.count >= most_candidates && overlaps_found()) return true;
            }
            return false;
        };
        std::int32_t const *const unmoved = row.unmoved().data();
        return add_all(row.unmoved().size(),
                       [&](std::size_t k) {
                           std::int32_t const j = unmoved[k];
                           if (is_read(static_cast<std::size_t>(j)))
                               found.add({j, 0}, search.may_meet(j));
                       }) ||
               add_all(row.num_moved(),
                       [&](std::size_t k) {
                           Neighbor const neighbor = row.moved(k);
                           if (is_read(static_cast<std::size_t>(neighbor.index)))
                               found.add(neighbor, search.may_meet(neighbor));
                       }) ||
               (found.count > 0 && overlaps_found());
    }

    bool overlaps(std::size_t i, ReadableDomains const &readable) const noexcept;
    bool overlaps_image(std::size_t i, Neighbor const &image) const noexcept;
    bool overlaps_any(std::size_t i, Neighbor const *images, std::size_t count) const noexcept;

    [[gnu::always_inline]] void put(std::size_t i, Particle const &particle) noexcept
    {
        ordered_.set(i, particle);
        boxes_.set(i, ordered_);
    }

    /// Asks for what a trial of particle i reads.
    [[gnu::always_inline]] void prefetch(std::size_t i) const noexcept
    {
        ordered_.prefetch(i);
        boxes_.prefetch(i);
        neighborhood_.prefetch(i);
    }

    bool run(std::size_t position) noexcept;
    ReadableDomains set_readable(Label domain, std::uint8_t mark) noexcept;
    void run(DomainRun &run) noexcept;
    Move choose(Stream &stream) const noexcept;
    Outcome try_move(Move move, std::size_t i, DomainRun &run) noexcept;
    Outcome try_exchange(std::size_t i, std::size_t j, DomainRun &run) noexcept;
    Outcome acceptance_of(std::size_t const *particles, Particle const *moved, std::size_t count,
                          Stream &stream) const noexcept;
    int run_all() noexcept;
    int fail(Counts const &before) noexcept;
    double energy_change(Change const &change) noexcept;
    template <class Overlaps, class Accept>
    Outcome accept_or_revert(std::size_t const *particles, Particle const *moved, std::size_t count,
                             Overlaps const &overlaps_others,
                             Accept const &accept_energy_change) noexcept;
    template <class IsRead>
    EnergySum energy_of_row(std::size_t i, IsRead const &is_read) const noexcept;
    EnergySum energy_of(std::size_t const *particles, std::size_t count,
                        ReadableDomains const &readable) const noexcept;
    EnergySum energy_of_rows() const noexcept;
    static Outcome acceptance_of_change(EnergySum const &before, EnergySum const &after,
                                        Stream &stream) noexcept;
    Outcome acceptance_of_energies(std::size_t const *particles, Particle *old,
                                   Particle const *moved, std::size_t count,
                                   DomainRun &run) noexcept;

    /// Returns whether the energies of pairs accept particles in their new places.
    [[gnu::always_inline]] Outcome acceptance_of_pairs(std::size_t const *particles, Particle *old,
                                                       Particle const *moved, std::size_t count,
                                                       DomainRun &run) noexcept
    {
        return pair_energy.exists() ? acceptance_of_energies(particles, old, moved, count, run)
                                    : Outcome::accepted;
    }

    bool any_overlaps() const noexcept;
    template <class Accept> int change_cell(Change const &change,
                                            Accept const &accept_energy_change,
                                            Outcome &outcome) noexcept;
    void apply(Change const &change) noexcept;
    int undo(bool rows_are_new) noexcept;
    double longest_translation() const noexcept;
    double skin() const noexcept;

    Configuration ordered_; ///< in the order of places; rows, boxes and domains belong to it
    MemoryOrder memory_order_;
    /// by places: whether a particle may differ from that of the configuration
    Array<std::uint8_t> moved_;
    std::atomic<bool> has_failed_{false}; ///< true if the energy of a trial of this sweep was NaN
    bool is_started_ = false;             ///< true if the orders belong to the present particles
    std::unique_ptr<RetiredArrays> retired_;
    bool is_taken_ = false; ///< true if it is the configuration, or one that follows from it
    int num_rows_ = 0;      ///< number of times that sweeps rebuilt the Verlet list
    double skin_of_rows_ = 0.0;
    Neighborhood neighborhood_;
    FloatBoxes boxes_;
    Domains domains_;
    DomainScheduler scheduler_;
    Array<std::uint8_t> marks_;  ///< of the domains, by threads (ReadableDomains)
    Array<Progress> progress_;   ///< in the order of turns
    Array<Vector3> old_centers_; ///< before a trial of the volume
    Cell old_cell_{};
    double longest_ = 0.0;    ///< of all semi-axes
    double anisotropy_ = 0.0; ///< by how much the semi-axes of a particle differ, at most
    /// by how much the lengths of a semi-axis differ between particles, at most
    double spread_ = 0.0;
};

} // namespace pw85::detail::simulation

#endif
