// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The search for the next event of a chain (chains.hpp): the first contact of a body on a stage.
///
/// 1. The bins give the images whose boxes meet that of the body on the stage.
/// 2. path_bounds.hpp gives lower bounds of the paths to them. Images with bounds below the length
///    of the stage are obstacles.
/// 3. The search improves the least bounds until the least one is that of a contact. There a
///    tangent plane between the two ellipsoids gives a free path with bounds on the rounding errors
///    (motion/free_path.hpp).
#ifndef PW85_SIMULATION_CONTACT_SEARCH_HPP_INCLUDED
#define PW85_SIMULATION_CONTACT_SEARCH_HPP_INCLUDED

#include <optional>

#include "../base/list.hpp"
#include "chain_bodies.hpp"

namespace pw85::detail::simulation {

/// A part of a chain: a body moves along a direction, until it touches another one or to the end.
struct Stage {
    std::size_t body;
    Vector3 direction; ///< of length one
    double length;
};

/// An image that may be touched on a stage. All lengths are in the unit of the bodies.
struct Obstacle {
    SeparatingPlane plane; ///< its image, and the plane between the two until they touch
    Vector3 r12;           ///< from the centre of the body that moves, at its start
    double size;           ///< MovingPair::size (path_bounds.hpp)
    double bound;          ///< no contact before this path
    double t, step;        ///< state of the search for a larger bound
    bool is_exact;         ///< the bound is the path to the contact
};

class ContactSearch {
  public:
    explicit ContactSearch(ChainBodies const &bodies) noexcept : bodies_(bodies) {}

    /// Begins a chain.
    void begin() noexcept { passed_.reset(); }

    /// Finds the longest path without contact on the next stage. Returns false without memory.
    [[nodiscard]] bool run(Stage const &stage) noexcept;

    /// Returns the longest path without contact, at most the length of the stage.
    double path() const noexcept { return path_; }

    /// Returns whether the path ends at a contact, with touched().
    bool ends_at_contact() const noexcept { return path_ < stage_.length; }
    Obstacle const &touched() const noexcept { return obstacles_.last(); }

    /// Returns whether the body is free with its centre at a position on the path. The bounds of
    /// all images that are not compared are longer than the path.
    bool is_free(Vector3 const &center) noexcept;

    /// Returns the body that moves next, touched(), after the body has moved or not.
    std::size_t pass_on(bool has_moved) noexcept;

  private:
    /// An image near the path, as the bins find it: a body and the cell of the image's centre.
    struct Near {
        Multiples cell;
        std::size_t body;
    };

    bool find_near() noexcept;
    void list_obstacles() noexcept;
    void insert_touched(Obstacle (&pair)[2], std::size_t count) noexcept;
    void insert(Obstacle const &obstacle) noexcept;
    void improve() noexcept;
    void find_contact() noexcept;

    ChainBodies const &bodies_;
    Stage stage_{};
    double length_ = 0.0; ///< of the stage, in the unit of the bodies
    double path_ = 0.0;
    List<Near> near_;
    List<Obstacle> obstacles_; ///< those with the least bounds last
    /// between the body and the one that touched it. The body moves away from this plane, so it
    /// cannot touch that image again.
    std::optional<SeparatingPlane> passed_;
};

} // namespace pw85::detail::simulation

#endif
