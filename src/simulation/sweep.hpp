// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Sweeps: trials of particles by domains, at constant volume.
///
/// A sweep divides the cell at random (domains.hpp). For a given division, each domain gets as many
/// trials as it has particles, each of a random particle, and a trial that leaves the domain is
/// rejected. So trials are reversible: the particles of each domain stay the same. The order of the
/// colours is random, and all orders are equally probable. So a sweep is in detailed balance, too.
///
/// In two dimensions (configuration.hpp) translations are by a point of a disc. A rotation is by
/// the quaternion (1, 0, 0, v), v uniform in an interval around 0. Its angle, 2 atan(v), is an odd
/// function of v, and angles about z add. So the density of the angle is even, and the reverse move
/// is equally probable.
#ifndef PW85_SIMULATION_SWEEP_HPP_INCLUDED
#define PW85_SIMULATION_SWEEP_HPP_INCLUDED

#include "domain_scheduler.hpp"
#include "domains.hpp"
#include "model.hpp"

namespace pw85::detail::simulation {

/// Progress of the work on a domain.
struct Progress {
    Stream stream;
    std::uint32_t remaining; ///< trials that remain
    /// the particles of a trial that leaves the fixed box of one of them; -1 without
    std::int32_t unlisted[2] = {-1, -1};
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

class Sweeps {
  public:
    [[gnu::always_inline]] explicit Sweeps(Model &model) noexcept : model_(model) {}

    /// Makes as many trials as there are particles, in a session. Returns a status. With energies,
    /// the session commits first, because a sweep that fails goes back to that.
    int run() noexcept;

  private:
    int prepare_list() noexcept;
    int find_loose(double room, bool &are_few) noexcept;
    int prepare_domains() noexcept;
    int recenter_unlisted() noexcept;
    int recenter(std::int32_t place) noexcept;
    int recenter_all(std::span<std::int32_t const> places) noexcept;
    int run_all() noexcept;
    bool run(std::size_t position) noexcept;
    void run(DomainRun &run) noexcept;
    ReadableDomains set_readable(Label domain, std::uint8_t mark) noexcept;
    Move choose(Stream &stream) const noexcept;
    Outcome try_move(Move move, std::size_t i, DomainRun &run) noexcept;
    Outcome try_exchange(std::size_t i, std::size_t j, DomainRun &run) noexcept;
    template <std::size_t N>
    [[gnu::always_inline]] Outcome decide(Trial<N> const &trial, DomainRun &run) noexcept;
    bool overlaps(std::size_t i, ReadableDomains const &readable) const noexcept;
    EnergySum energy_of(std::span<std::size_t const> places,
                        ReadableDomains const &readable) const noexcept;
    Outcome accept_energies(std::span<std::size_t const> places, Particle const *old,
                            Particle const *moved, DomainRun &run) noexcept;

    Model &model_;
    Domains domains_;
    DomainScheduler scheduler_;
    Array<std::uint8_t> marks_; ///< of the domains, by threads (ReadableDomains)
    Array<Progress> progress_;  ///< in the order of turns
    Array<std::int32_t> loose_; ///< particles with little room in their fixed boxes
    std::size_t num_loose_ = 0;
    List<std::int32_t> near_;             ///< particles near the one whose box recenter() moves
    std::atomic<bool> has_failed_{false}; ///< true if the energy of a trial of this sweep was NaN
    int num_rebuilds_ = 0;                ///< of the Verlet list before a sweep
};

} // namespace pw85::detail::simulation

#endif
