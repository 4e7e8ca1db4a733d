// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The particles of event chains (chains.hpp), in the order of their bins. A body is the number of
/// a particle in that order.
#ifndef PW85_SIMULATION_CHAIN_BODIES_HPP_INCLUDED
#define PW85_SIMULATION_CHAIN_BODIES_HPP_INCLUDED

#include "bins.hpp"

namespace pw85::detail::simulation {

/// A particle, as the search for contacts reads it. The root of the trace of its form, and the
/// inverse, measure its size.
struct ChainBody {
    Vector3 center, half_widths;
    Form3 q; ///< in the unit of ChainBodies
    double root, inverse_root;
};

/// An image of a body.
struct BodyImage {
    Vector3 translation;
    std::size_t body;

    bool operator==(BodyImage const &other) const noexcept
    {
        return body == other.body && largest_coordinate(translation - other.translation) == 0.0;
    }
};

/// A plane between the body that moves and an image.
struct SeparatingPlane {
    BodyImage image;
    Vector3 normal; ///< points to the image; zero without a plane

    bool exists() const noexcept { return largest_coordinate(normal) > 0.0; }
};

class ChainBodies {
  public:
    explicit ChainBodies(Configuration &configuration) noexcept : configuration_(configuration) {}

    /// Reads the configuration. Returns a status.
    int prepare() noexcept;

    /// Returns whether a particle could touch its own image if it turned.
    bool own_images_may_touch() const noexcept { return own_images_may_touch_; }

    /// Returns the longest of all semi-axes, in the caller's unit.
    double longest_semi_axis() const noexcept { return longest_; }

    /// Returns the unit of length of the forms, a power of two near the longest semi-axis.
    Unit length_unit() const noexcept { return unit_; }

    /// Returns the body of a particle of the configuration.
    std::size_t body_of(std::size_t particle) const noexcept
    {
        return static_cast<std::size_t>(numbers_[particle]);
    }

    [[gnu::always_inline]] ChainBody const &operator[](std::size_t i) const noexcept
    {
        return bodies_[i];
    }

    /// Calls visit_one(j, cell) for the images of bodies whose boxes intersect a box (bins.hpp).
    /// The bodies may be anywhere in memory, so they are prefetched.
    template <class Visit> [[gnu::always_inline]] void
    visit(Vector3 const &center, Vector3 const &half_widths, Visit const &visit_one) const noexcept
    {
        bins_.visit(center, half_widths, [&](std::size_t j, Multiples const &cell) {
            if (!visit_one(j, cell)) return;
            prefetch(&bodies_[j], 1);
            bins_.prefetch(j);
        });
    }

    /// Returns the image of body j whose centre is in a cell.
    [[gnu::always_inline]] BodyImage image_in(Multiples const &cell, std::size_t j) const noexcept
    {
        return {configuration_.cell.translation(bins_.image_in(cell, j)), j};
    }

    /// Returns whether body i, with its centre at a position, does not overlap an image: by a plane
    /// if there is one, or else by the exact test. If the plane does not separate the two, its
    /// normal becomes zero, and the plane is not used again.
    bool is_free_of(SeparatingPlane &plane, std::size_t i, Vector3 const &center) const noexcept;

    /// Moves body i, and its particle of the configuration.
    void move(std::size_t i, Vector3 const &center) noexcept;

  private:
    ChainBody read(std::size_t particle) const noexcept;
    bool separates(SeparatingPlane const &plane, std::size_t i,
                   Vector3 const &center) const noexcept;

    Configuration &configuration_;
    Bins bins_;
    Array<ChainBody> bodies_;
    Array<std::int32_t> numbers_; ///< the bodies of the particles of the configuration
    double longest_ = 0.0;
    bool own_images_may_touch_ = false;
    Unit unit_{};
};

} // namespace pw85::detail::simulation

#endif
