// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Bounding boxes in single precision, 32 bytes for a particle. By them the engine passes over most
/// neighbours of a particle.
///
/// Centres are differences from an origin. All numbers are divided by the longest semi-axis of the
/// ellipsoids, enlarged by the reach of energies (pair_energy.hpp), which brings them into range.
/// Let S bound the coordinates of centres and translations, and h the half-widths. A bound of a box
/// errs by less than v (S + h), with v = 2⁻²⁴. The bounds of the other box err as much, as much
/// again by their margin, and by 3 v (S + h) by a translation. The sum is less than 8 v (S + h),
/// and less than 12 v S because S is at least 2 h. The margin is 2⁻¹⁸ S. That is five times as
/// much, because particles move farther than S says if the cell has grown since the rows were made,
/// or if their fixed boxes were moved: then up to 2 S (covers()).
#ifndef PW85_SIMULATION_FLOAT_BOXES_HPP_INCLUDED
#define PW85_SIMULATION_FLOAT_BOXES_HPP_INCLUDED

#include "../base/parallel.hpp"
#include "neighborhood.hpp"

namespace pw85::detail::simulation {

class FloatBoxes {
    typedef float Float4 __attribute__((vector_size(16)));
    typedef std::int32_t Int4 __attribute__((vector_size(16)));
    typedef std::int64_t Int2 __attribute__((vector_size(16)));

  public:
    /// The last coordinates are 0. The signs are such that an instruction compares three bounds.
    struct RoughBox {
        Float4 lower, negative_upper;
    };

    /// The search for boxes that may meet that of a particle: the bounds that they must not exceed,
    /// with the margin, and where the boxes are. NaN, after an overflow, means that a box may meet
    /// it.
    class Search {
      public:
        [[gnu::always_inline]] explicit Search(FloatBoxes const &all, std::size_t i) noexcept
            : boxes_(all.boxes_.data()), translations_(all.translations_.data()),
              lower_(all.margin_ - boxes_[i].negative_upper),
              negative_upper_(all.margin_ - boxes_[i].lower)
        {
        }

        /// Returns whether the box of a particle, not moved, may meet it.
        [[gnu::always_inline]] bool may_meet(std::int32_t index) const noexcept
        {
            RoughBox const &other = boxes_[static_cast<std::size_t>(index)];
            return is_none((other.lower > lower_) | (other.negative_upper > negative_upper_));
        }

        /// Returns whether the box of an image may meet it.
        [[gnu::always_inline]] bool may_meet(Neighbor const &neighbor) const noexcept
        {
            RoughBox const &other = boxes_[static_cast<std::size_t>(neighbor.index)];
            Float4 const &translation = translations_[static_cast<std::size_t>(neighbor.image)];
            return is_none((other.lower > lower_ - translation) |
                           (other.negative_upper > negative_upper_ + translation));
        }

      private:
        RoughBox const *boxes_;
        Float4 const *translations_;
        Float4 lower_, negative_upper_;
    };

    [[nodiscard, gnu::always_inline]] bool resize(std::size_t num_particles,
                                                  std::size_t num_images) noexcept
    {
        if (!boxes_.resize(num_particles) || !translations_.resize(num_images)) return false;
        prefer_huge_pages(boxes_);
        return true;
    }

    /// Stores the boxes of all particles, and the translations of the rows. They hold until the
    /// rows or the cell change, for particles that move by at most `displacement` along any axis,
    /// which is at least two half-widths.
    [[gnu::always_inline]] void refresh(Configuration const &configuration,
                                        Neighborhood const &neighborhood, double longest,
                                        double reach, double displacement) noexcept
    {
        per_unit_ = 1.0 / (reach * longest);
        per_half_width_ = 1.0 / longest;
        if (boxes_.size() > 0) origin_ = configuration.centers[0];
        double farthest = displacement + set_all(configuration).distance;
        for (std::size_t k = 0; k < neighborhood.num_images(); ++k) {
            Vector3 const &translation = neighborhood.translation(static_cast<std::int32_t>(k));
            translations_[k] = rounded(per_unit_ * translation);
            farthest = maximum(farthest, largest_coordinate(translation));
        }
        farthest_center_ = 2.0 * farthest - displacement;
        auto const margin = static_cast<float>(0x1p-18 * (farthest * per_unit_));
        margin_ = Float4{margin, margin, margin, 0.0F};
    }

    /// Returns whether the margin holds for a particle that moves away from this centre by at most
    /// the displacement of refresh().
    bool covers(Vector3 const &center) const noexcept
    {
        return largest_coordinate(center - origin_) <= farthest_center_;
    }

    /// Takes note of the present centre and half-widths of particle i.
    [[gnu::always_inline]] void set(std::size_t i, Configuration const &configuration) noexcept
    {
        Vector3 const center = per_unit_ * (configuration.centers[i] - origin_),
                      half_widths = per_half_width_ * configuration.half_widths[i];
        boxes_[i] = {rounded(center - half_widths), -rounded(center + half_widths)};
    }

    /// Brings the box of a particle into the cache.
    [[gnu::always_inline]] void prefetch(std::size_t i) const noexcept
    {
        simulation::prefetch(&boxes_[i], 1);
    }

    [[gnu::always_inline]] Search search(std::size_t i) const noexcept { return Search(*this, i); }

  private:
    /// The largest coordinate of some centres, from the origin on.
    struct Farthest {
        double distance = 0.0;

        void add(Farthest const &other) noexcept { distance = maximum(distance, other.distance); }
    };

    [[gnu::always_inline]] Farthest set_all(Configuration const &configuration) noexcept
    {
        auto const part = [&](std::size_t begin, std::size_t end) __attribute__((always_inline))
        {
            Farthest farthest;
            for (std::size_t i = begin; i < end; ++i) {
                set(i, configuration);
                farthest.add({largest_coordinate(configuration.centers[i] - origin_)});
            }
            return farthest;
        };
        return of_all_parts<Farthest>(boxes_.size(), part, block);
    }

    [[gnu::always_inline]] static Float4 rounded(Vector3 const &x) noexcept
    {
        return Float4{static_cast<float>(x[0]), static_cast<float>(x[1]), static_cast<float>(x[2]),
                      0.0F};
    }

    [[gnu::always_inline]] static bool is_none(Int4 const &mask) noexcept
    {
#if defined(__SSE2__)
        return __builtin_ia32_movmskps(reinterpret_cast<Float4>(mask)) == 0;
#else
        auto const halves = reinterpret_cast<Int2>(mask);
        return (halves[0] | halves[1]) == 0;
#endif
    }

    Array<RoughBox> boxes_;
    Array<Float4> translations_;
    Float4 margin_{};
    Vector3 origin_{};
    double per_unit_ = 1.0, per_half_width_ = 1.0, farthest_center_ = 0.0;
};

} // namespace pw85::detail::simulation

#endif
