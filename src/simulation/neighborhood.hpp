// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The Verlet list of a simulation, as one row of images for each particle. verlet_list.hpp uses
/// the rows to test whether a particle overlaps any other.
///
/// 1. Particle i has a fixed box: the bounding box that it had when the rows were made, enlarged by
///    the reach of energies (pair_energy.hpp) and by half of the skin on each side. Its row has all
///    images of particles whose fixed boxes intersect its own.
/// 2. As long as all particles are within their fixed boxes, rows have all overlaps. If the cell
///    has changed, the particles are first mapped back (neighbors/deformation.hpp).
/// 3. recenter() gives a particle that leaves its fixed box another one, and adds the images that
///    this box meets to the rows. The longer rows are at the end of the memory, up to its end.
#ifndef PW85_SIMULATION_NEIGHBORHOOD_HPP_INCLUDED
#define PW85_SIMULATION_NEIGHBORHOOD_HPP_INCLUDED

#include <span>

#include "../base/list.hpp"
#include "../neighbors/deformation.hpp"
#include "../simd/lanes/images.hpp"
#include "configuration.hpp"

namespace pw85::detail::simulation {

/// Returns the image of a pair; zero in a list without cell.
static inline Multiples image_of(pw85_pair_list const &list, std::size_t pair) noexcept
{
    if (list.images == nullptr) return {{0, 0, 0}};
    std::int32_t const *const n = list.images + 3 * pair;
    return {{n[0], n[1], n[2]}};
}

/// One image of a particle. Number 0 is not translated.
using Neighbor = kernels::NumberedImage;

/// Positions of the next neighbours of a particle in its list, for those that are not moved and
/// those that are; in the first pass, their numbers.
struct Places {
    std::size_t of[2] = {};

    void count(bool is_moved) noexcept { of[is_moved] += is_moved ? 2 : 1; }
};

/// The row of a particle: first the neighbours that no translation moves, which are most, as
/// indices, then the other ones.
class Row {
  public:
    [[gnu::always_inline]] Row(std::int32_t const *begin, std::int32_t const *others,
                               std::int32_t const *end) noexcept
        : begin_(begin), others_(others), end_(end)
    {
    }

    [[gnu::always_inline]] std::span<std::int32_t const> unmoved() const noexcept
    {
        return {begin_, others_};
    }

    [[gnu::always_inline]] std::size_t num_moved() const noexcept
    {
        return static_cast<std::size_t>(end_ - others_) / 2;
    }

    [[gnu::always_inline]] Neighbor moved(std::size_t k) const noexcept
    {
        return {others_[2 * k], others_[2 * k + 1]};
    }

    std::size_t size() const noexcept { return unmoved().size() + num_moved(); }

    Neighbor operator[](std::size_t k) const noexcept
    {
        std::size_t const first = unmoved().size();
        return k < first ? Neighbor{begin_[k], 0} : moved(k - first);
    }

    [[gnu::always_inline]] void prefetch() const noexcept
    {
        simulation::prefetch(begin_, static_cast<std::size_t>(end_ - begin_));
    }

  private:
    std::int32_t const *begin_, *others_, *end_;
};

class Neighborhood {
  public:
    Neighborhood() noexcept; // not inline: the linker would merge copies

    /// Builds the rows of a configuration whose ellipsoids are enlarged by the factor `reach`.
    /// Returns a status. On error there are no rows.
    int update(Configuration const &configuration, double reach, double skin) noexcept;

    /// Returns how far apart along each axis the centres of two images may be now, at most, if
    /// their fixed boxes meet after recenter(). Returns infinity if recenter() cannot be called:
    /// the cell has changed too much, or is too small, so several images of a particle may meet.
    ///
    /// @param half_width the longest one of a fixed box
    double reach_of_recentered(double half_width) const noexcept;

    /// Centres the fixed box of particle i at its present position, as update() does.
    ///
    /// @param near all particles with images within reach_of_recentered(), and maybe others
    /// @return a status, PW85_EINVAL if there is no room for the rows; on error nothing changes
    int recenter(std::size_t i, Configuration const &configuration, double reach, double skin,
                 std::span<std::int32_t const> near) noexcept;

    /// Returns for how many particles recenter() has memory, by estimate.
    std::size_t room() const noexcept;

    /// Returns the number of rows: that of the particles, or 0 after an error.
    std::size_t size() const noexcept { return extents_.size(); }

    /// Sets the cell after a change. Returns false if it is singular.
    [[nodiscard]] bool set_cell(Cell const &cell) noexcept;

    /// Returns whether particle i, enlarged, with this centre and these half-widths, is in its
    /// fixed box, and stays there if it moves by `displacement` along any axis.
    [[gnu::always_inline]] bool holds(std::size_t i, Vector3 const &center,
                                      Vector3 const &half_widths,
                                      double displacement) const noexcept
    {
        auto const motions = deformation_.shared_motions({center, half_widths}, extents_[i]);
        bool inside = true;
        for (int d = 0; d < 3; ++d)
            inside =
                inside && motions.lower[d] <= -displacement && displacement <= motions.upper[d];
        return inside;
    }

    [[gnu::always_inline]] Row row(std::size_t i) const noexcept
    {
        std::int32_t const *const all = rows_.data();
        RowEnds const &ends = ends_[i];
        return Row(all + ends.begin, all + ends.others, all + ends.end);
    }

    /// Brings the fixed box and the row of a particle into the cache.
    [[gnu::always_inline]] void prefetch(std::size_t i) const noexcept
    {
        simulation::prefetch(&extents_[i], 1);
        row(i).prefetch();
    }

    /// Returns the translations of all images.
    Vector3 const *translations() const noexcept { return translations_.data(); }

    std::size_t num_images() const noexcept { return translations_.size(); }

    Multiples const &multiples(std::int32_t image) const noexcept
    {
        return images_[static_cast<std::size_t>(image)];
    }

    /// Returns the translation of an image, in the present cell.
    [[gnu::always_inline]] Vector3 const &translation(std::int32_t image) const noexcept
    {
        return translations_[static_cast<std::size_t>(image)];
    }

  private:
    /// Positions of the beginning of a row, of its moved neighbours, and of its end.
    struct RowEnds {
        std::size_t begin, others, end;
    };

    /// An image that a fixed box meets: its number, and that of the image of the box which the
    /// other box meets.
    struct Meeting {
        Neighbor image;
        std::int32_t back;
        bool is_new; ///< true if the row of the other particle lacks it
    };

    int rebuild_list(Configuration const &configuration, double reach, double skin) noexcept;
    bool fill_rows(std::size_t n, pw85_pair_list const &list) noexcept;
    std::size_t begin_rows(std::size_t n, std::size_t num_shares, Places *next) noexcept;
    void put(std::size_t &place, Neighbor const &moved) noexcept;
    int find_meetings(std::size_t i, neighbors::BoxExtent const &box,
                      std::span<std::int32_t const> near, std::size_t &size) noexcept;
    Multiples nearest_image(Vector3 const &from, Vector3 const &to) const noexcept;
    bool meets(neighbors::BoxExtent const &box, std::size_t j,
               Multiples const &image) const noexcept;
    std::int32_t number_of(Multiples const &image) const noexcept;
    bool has(std::size_t i, Neighbor const &image) const noexcept;
    void append(std::size_t i, Neighbor const &image) noexcept;
    bool store_extents(Configuration const &configuration, double reach, double skin) noexcept;

    Array<neighbors::BoxExtent> extents_;
    Array<RowEnds> ends_;
    Array<std::int32_t> rows_; ///< an index, or an index and the number of an image
    std::size_t used_ = 0;     ///< of rows_
    List<Meeting> meetings_;   ///< of recenter()
    Array<Multiples> images_;
    Array<Vector3> translations_;
    double cell_[9] = {};
    Vector3 dual_[3] = {}; ///< of the periodic vectors of this cell; zero for others
    neighbors::Deformation deformation_{neighbors::Periodicity(), nullptr, nullptr};
};

} // namespace pw85::detail::simulation

#endif
