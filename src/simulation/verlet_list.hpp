// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The Verlet list of the particles of a session: the rows of neighborhood.hpp and the float boxes
/// by which most neighbours are passed over. sweep.cpp and volume_moves.cpp ask it for overlaps and
/// energies.
///
/// A list knows the number of particles, the dimensions, the reach of energies and the generation
/// of the copy (particles.hpp) that it was made for. It holds for another generation if all
/// particles are in their fixed boxes.
#ifndef PW85_SIMULATION_VERLET_LIST_HPP_INCLUDED
#define PW85_SIMULATION_VERLET_LIST_HPP_INCLUDED

#include "float_boxes.hpp"
#include "pair_energy.hpp"
#include "particles.hpp"

namespace pw85::detail::simulation {

class VerletList {
  public:
    /// Returns whether this list still holds for the copy of a session.
    bool holds(Particles const &particles, double reach) noexcept;

    /// Makes a list for the copy of a session. Returns a status. On error there is no list.
    int rebuild(Particles const &particles, double reach, double skin) noexcept;

    /// Takes the cell and the centres of a copy, after a change of both, as long as all particles
    /// are in their fixed boxes. Returns false if the cell is singular.
    [[nodiscard]] bool deform(Particles const &particles) noexcept;

    /// Returns how far apart along each axis the centres of two particles are, at most, if
    /// recenter() may have to list their pair; infinity if it cannot be called.
    double reach_of_recentered() const noexcept { return rows_.reach_of_recentered(0.5 * widest_); }

    /// Centres the fixed box of a particle at its present position.
    ///
    /// @param skin that of a new list
    /// @param near all particles with images within reach_of_recentered(), and maybe others
    /// @return a status, PW85_EINVAL if a new list is needed; on error nothing changes
    int recenter(std::size_t i, Configuration const &all, double skin,
                 std::span<std::int32_t const> near) noexcept
    {
        if (!(skin <= skin_ && boxes_.covers(all.centers[i]))) return PW85_EINVAL;
        return rows_.recenter(i, all, reach_, skin_, near);
    }

    /// Returns whether all particles are in their fixed boxes, and stay there if they move by
    /// `displacement` along any axis; false without a list.
    bool holds_all(Configuration const &all, double displacement = 0.0) const noexcept;

    /// As holds_all(), for one particle.
    [[gnu::always_inline]] bool holds(std::size_t i, Configuration const &all,
                                      double displacement = 0.0) const noexcept
    {
        return rows_.holds(i, all.centers[i], reach_ * all.half_widths[i], displacement);
    }

    /// Takes note of the present centre and half-widths of particle i.
    [[gnu::always_inline]] void update(std::size_t i, Configuration const &all) noexcept
    {
        boxes_.set(i, all);
    }

    /// Asks for what a trial of particle i reads.
    [[gnu::always_inline]] void prefetch(std::size_t i) const noexcept
    {
        boxes_.prefetch(i);
        rows_.prefetch(i);
    }

    Neighborhood const &rows() const noexcept { return rows_; }

    /// Returns whether particle i overlaps any of its neighbours that have is_read(j). Other
    /// particles are not read.
    template <class IsRead> [[gnu::always_inline]] bool
    overlaps(std::size_t i, Configuration const &all, IsRead const &is_read) const noexcept
    {
        Candidates found;
        auto const search = boxes_.search(i);
        Row const row = rows_.row(i);
        auto const overlaps_found = [&] {
            return overlaps_any(i, all, found.images, std::exchange(found.count, 0));
        };
        // in parts: there is memory for all of a part
        auto const add_all = [&](std::size_t size, auto const &add) {
            for (std::size_t begin = 0; begin < size; begin += most_candidates) {
                std::size_t const end = minimum(size, begin + most_candidates);
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

    /// Returns whether any particles overlap.
    bool any_overlaps(Configuration const &all) const noexcept;

    /// Returns the energy of particle i and those of its neighbours that have is_read(j).
    template <class IsRead> EnergySum energy(std::size_t i, Configuration const &all,
                                             PairEnergy const &law,
                                             IsRead const &is_read) const noexcept
    {
        EnergyCollector pairs(law);
        auto const search = boxes_.search(i);
        Row const row = rows_.row(i);
        for (std::size_t k = 0; k < row.size(); ++k) {
            Neighbor const neighbor = row[k];
            auto const j = static_cast<std::size_t>(neighbor.index);
            // An image of the particle itself is in its row twice, as n and as -n.
            if (is_read(j) && search.may_meet(neighbor))
                pairs.add(all.separation(i, j, rows_.translation(neighbor.image)), all.q[i],
                          all.q[j], j == i ? 1 : 2);
        }
        return pairs.sum();
    }

    /// Returns the energy of all pairs.
    EnergySum energy_of_all(Configuration const &all, PairEnergy const &law) const noexcept;

  private:
    /// Images that are tested together.
    static constexpr std::size_t most_candidates = 64;
    static_assert(2 * most_candidates <= kernels::most_images);

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

    void refresh_boxes(Particles const &particles) noexcept;
    bool overlaps_image(std::size_t i, Configuration const &all,
                        Neighbor const &image) const noexcept;
    bool overlaps_any(std::size_t i, Configuration const &all, Neighbor const *images,
                      std::size_t count) const noexcept;

    Neighborhood rows_;
    FloatBoxes boxes_;
    std::uint64_t generation_ = 0;
    int dimensions_ = 0;
    double reach_ = 0.0, skin_ = 0.0;
    /// Between two rebuilds a particle moves by at most twice the half-width of its fixed box along
    /// an axis, which is no longer than this.
    double widest_ = 0.0;
};

} // namespace pw85::detail::simulation

#endif
