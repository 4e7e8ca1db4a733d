// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Event chains of hard ellipsoids, after Bernard, Krauth and Wilson, Event-chain Monte Carlo
/// algorithms for hard-sphere systems (2009), doi:10.1103/PhysRevE.80.056704. hard_ellipsoids.cpp
/// offers them in the C API.
///
/// A random particle moves along a direction d until it touches another one. Then that particle
/// moves along d, and so forth, until the sum of the paths is the length of the chain. There are no
/// rejections.
///
/// For a given direction and length, the chains from all configurations and all particles are a
/// bijection that keeps volumes: the chain along -d from the last particle leads back. So the
/// uniform distribution is stationary. If the direction is random, and opposite directions are
/// equally probable, chains are in detailed balance.
#ifndef PW85_SIMULATION_CHAINS_HPP_INCLUDED
#define PW85_SIMULATION_CHAINS_HPP_INCLUDED

#include <optional>

#include <pw85/algebra/philox.hpp>

#include "../base/list.hpp"
#include "bins.hpp"

namespace pw85::detail::simulation {

/// Sums over some chains. Their βP/ρ is 1 + transfers/length, if no particle can touch its own
/// images. Michel, Kapfer and Krauth, Generalized event-chain Monte Carlo (2014),
/// doi:10.1063/1.4863991: βP/ρ, along d, is the mean of (x_last - x_first)/length. Here x is the
/// coordinate along d of the particle that moves. At each contact it jumps by the coordinate of the
/// separation.
struct ChainSums {
    double length;    ///< the sum of the paths
    double transfers; ///< the sum of the coordinates along d of the separations at contacts
    std::int64_t contacts;
};

class Chains {
  public:
    explicit Chains(Configuration &configuration) noexcept : configuration_(configuration) {}

    /// Reads the configuration. Call it after anything else has changed the configuration. Returns
    /// a status.
    int prepare() noexcept;

    /// Returns whether a particle could touch its own image if it turned. Chains do not find such
    /// contacts: the images of a particle move with it. But such contacts contribute to the
    /// pressure.
    bool own_images_may_touch() const noexcept { return own_images_may_touch_; }

    /// Runs one chain and adds to the sums. The direction has length one. Returns a status:
    /// PW85_ECONVERGENCE if the chain does not advance, because particles block each other within
    /// rounding errors.
    int run(std::size_t first, Vector3 const &direction, double length, ChainSums &sums) noexcept;

  private:
    /// Data of a particle for the search. The root of the trace of its form, and the inverse,
    /// measure its size.
    struct Body {
        Vector3 center, half_widths;
        Form3 q; ///< in the unit
        double root, inverse_root;
    };

    /// An image near the path, as the bins find it: a particle and the cell of the image's centre.
    struct Near {
        Multiples cell;
        std::size_t index;
    };

    /// An image of a particle, as the chains use it.
    struct Image {
        Vector3 translation;
        std::size_t index;

        bool operator==(Image const &other) const noexcept
        {
            return index == other.index &&
                   largest_coordinate(translation - other.translation) == 0.0;
        }
    };

    /// An image that may be touched on the path. All lengths are in the unit.
    struct Obstacle {
        Image image;
        Vector3 r12;    ///< from the centre of the particle that moves, at its start
        double size;    ///< MovingPair::size (path_bounds.hpp)
        double bound;   ///< no contact before this path
        double t, step; ///< state of the search for a larger bound
        bool is_exact;  ///< the bound is the path to the contact
        Vector3 normal; ///< of a plane between the two until they touch; zero without a plane

        bool has_plane() const noexcept { return largest_coordinate(normal) > 0.0; }
    };

    /// A plane between the particle that moves and an image.
    struct Plane {
        Image image;
        Vector3 normal; ///< points to the image; zero after the plane failed to separate the two
    };

    bool find_near(std::size_t i, Vector3 const &direction, double stage) noexcept;
    void list_obstacles(std::size_t i, Vector3 const &direction, double stage) noexcept;
    void insert_touched(std::size_t i, Vector3 const &direction, double stage, Obstacle (&pair)[2],
                        std::size_t count) noexcept;
    void insert(Obstacle const &obstacle) noexcept;
    void improve(std::size_t i, Vector3 const &direction, double stage) noexcept;
    void find_contact(std::size_t i, Vector3 const &direction, double stage) noexcept;
    double free_path_length(std::size_t i, Vector3 const &direction, double stage) noexcept;
    bool plane_separates(std::size_t i, Image const &image, Vector3 const &normal) const noexcept;
    bool is_free_of(std::size_t i, Image const &image, Vector3 &normal) const noexcept;
    bool is_free(std::size_t i) noexcept;
    double advance(std::size_t i, Vector3 const &direction, double path, bool touches,
                   double digit) noexcept;

    Configuration &configuration_;
    Bins bins_;
    Array<Body> bodies_;          ///< in the order of the bins
    Array<std::int32_t> numbers_; ///< of the particles of the configuration in that order
    List<Near> near_;
    List<Obstacle> obstacles_; ///< those with the least bounds last
    /// between the particle that moves and the one that touched it
    std::optional<Plane> last_plane_;
    double longest_ = 0.0; ///< of all semi-axes
    bool own_images_may_touch_ = false;
    Unit unit_{};
};

} // namespace pw85::detail::simulation

#endif
