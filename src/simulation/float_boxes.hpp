// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Bounding boxes in single precision, 32 bytes for a particle. By them the engine passes over most
/// neighbours of a particle.
///
/// Centres are differences from an origin. All numbers are divided by the longest semi-axis of the
/// ellipsoids, enlarged by the reach of energies (pair_energy.hpp), so that they are in range. Let
/// S bound the coordinates of centres and translations, and h the half-widths. The difference of
/// two centres, moved by a translation, errs by less than 8 v S, with v = 2⁻²⁴, and the sum of two
/// half-widths by less than 4 v h. The margin is 2⁻¹⁸ (S + h). That is eight times as much, because
/// particles move farther than S says if the cell has grown since the rows were made.
#ifndef PW85_SIMULATION_FLOAT_BOXES_HPP_INCLUDED
#define PW85_SIMULATION_FLOAT_BOXES_HPP_INCLUDED

#include <algorithm>

#include "../base/parallel.hpp"
#include "neighborhood.hpp"

namespace pw85::detail::simulation {

class FloatBoxes {
    typedef float Float4 __attribute__((vector_size(16)));
    typedef std::int32_t Int4 __attribute__((vector_size(16)));
    typedef std::int64_t Int2 __attribute__((vector_size(16)));

  public:
    struct RoughBox {
        Float4 center, half_widths; ///< the last coordinate is 0
    };

    [[nodiscard]] bool resize(std::size_t num_particles, std::size_t num_images) noexcept
    {
        return boxes_.resize(num_particles) && translations_.resize(num_images);
    }

    /// Stores the boxes of all particles, and the translations of the rows. They hold until the
    /// rows or the cell change, for particles that move by at most `room` along any axis.
    [[gnu::always_inline]] void refresh(Configuration const &configuration,
                                        Neighborhood const &neighborhood, double longest,
                                        double reach, double room) noexcept
    {
        per_unit_ = 1.0 / (reach * longest);
        per_half_width_ = 1.0 / longest;
        if (boxes_.size() > 0) origin_ = configuration.centers[0];
        double farthest = room + set_all(configuration).distance;
        for (std::size_t k = 0; k < neighborhood.num_images(); ++k) {
            Vector3 const &translation = neighborhood.translation(static_cast<std::int32_t>(k));
            translations_[k] = scaled(per_unit_, translation);
            farthest = std::max(farthest, largest_coordinate(translation));
        }
        auto const margin = static_cast<float>(0x1p-18 * (farthest * per_unit_ + 1.0));
        margin_ = Float4{margin, margin, margin, 0.0F};
    }

    /// Takes note of the present centre and half-widths of particle i.
    [[gnu::always_inline]] void set(std::size_t i, Configuration const &configuration) noexcept
    {
        boxes_[i] = {scaled(per_unit_, configuration.centers[i] - origin_),
                     scaled(per_half_width_, configuration.half_widths[i])};
    }

    /// Brings the box of a particle into the cache.
    [[gnu::always_inline]] void prefetch(std::size_t i) const noexcept
    {
        simulation::prefetch(&boxes_[i], 1);
    }

    /// The box of a particle with the margin.
    [[gnu::always_inline]] RoughBox with_margin(std::size_t i) const noexcept
    {
        return {boxes_[i].center, boxes_[i].half_widths + margin_};
    }

    /// Whether a box with margin may intersect the box of an image. NaN, after an overflow, means
    /// that it may.
    [[gnu::always_inline]] bool may_meet(RoughBox const &box,
                                         Neighbor const &neighbor) const noexcept
    {
        RoughBox const &other = boxes_[static_cast<std::size_t>(neighbor.index)];
        Float4 const r =
            (other.center - box.center) + translations_[static_cast<std::size_t>(neighbor.image)];
        Float4 const distance = reinterpret_cast<Float4>(reinterpret_cast<Int4>(r) & 0x7fffffff);
        auto const apart = reinterpret_cast<Int2>(distance > box.half_widths + other.half_widths);
        return (apart[0] | apart[1]) == 0;
    }

  private:
    /// The largest coordinate of some centres, from the origin on.
    struct Farthest {
        double distance = 0.0;

        void add(Farthest const &other) noexcept { distance = std::max(distance, other.distance); }
    };

    [[gnu::always_inline]] Farthest set_all(Configuration const &configuration) noexcept
    {
        auto const part = [&](std::size_t begin, std::size_t end) {
            Farthest farthest;
            for (std::size_t i = begin; i < end; ++i) {
                set(i, configuration);
                farthest.add({largest_coordinate(configuration.centers[i] - origin_)});
            }
            return farthest;
        };
        return of_all_parts<Farthest>(boxes_.size(), part, block);
    }

    [[gnu::always_inline]] static Float4 scaled(double factor, Vector3 const &x) noexcept
    {
        return Float4{static_cast<float>(factor * x[0]), static_cast<float>(factor * x[1]),
                      static_cast<float>(factor * x[2]), 0.0F};
    }

    Array<RoughBox> boxes_;
    Array<Float4> translations_;
    Float4 margin_{};
    Vector3 origin_{};
    double per_unit_ = 1.0, per_half_width_ = 1.0;
};

} // namespace pw85::detail::simulation

#endif
