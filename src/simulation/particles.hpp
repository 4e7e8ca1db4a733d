// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The particles of a simulation: in the caller's order, and a copy in memory order on which sweeps
/// and trials of the volume work.
///
/// 1. begin_session() makes the copy that of the caller's particles. commit() copies the particles
///    that have moved since back to the caller, and roll_back() gives them up. A Session begins and
///    commits.
/// 2. A copy stays from one session to the next, until change(), add() or remove() give the caller
///    other particles. Each new copy has another generation(): what was computed for an older one,
///    like a Verlet list, does not count for it.
#ifndef PW85_SIMULATION_PARTICLES_HPP_INCLUDED
#define PW85_SIMULATION_PARTICLES_HPP_INCLUDED

#include <algorithm>
#include <span>

#include "../base/owner.hpp"
#include "configuration.hpp"

namespace pw85::detail::simulation {

/// The places of particles in memory. They follow Morton's curve: particles that are near each
/// other in the cell are near in memory. The results of a simulation do not depend on them.
class MemoryOrder {
  public:
    /// Orders the particles of a configuration. Returns a status; on error the places stay as they
    /// are.
    int prepare(Configuration const &configuration) noexcept;

    std::size_t size() const noexcept { return numbers_.size() / 2; }

    /// Returns the places of all particles.
    std::span<std::int32_t const> all() const noexcept { return {numbers_.data(), size()}; }

    std::size_t of(std::size_t particle) const noexcept
    {
        return static_cast<std::size_t>(numbers_[particle]);
    }

    std::int32_t particle(std::size_t place) const noexcept { return numbers_[size() + place]; }

  private:
    Array<std::int32_t> numbers_; ///< the places of the particles, then the particles by places
};

/// Lengths of some particles, in the space of the dimensions.
struct Sizes {
    double longest = 0.0;    ///< of all semi-axes
    double anisotropy = 0.0; ///< by how much the semi-axes of a particle differ, at most
    double spread = 0.0;     ///< by how much a semi-axis differs between particles, at most
};

/// Arrays that a configuration has outgrown. The caller may still read them: see
/// pw85_hard_ellipsoids_system().
struct RetiredArrays {
    Array<Vector3> centers, semi_axes;
    Array<Quaternion> quaternions;
    Array<Form3> q;
    Owner<RetiredArrays> older;

    ~RetiredArrays(); // not inline: the linker would merge copies
};

class Particles {
  public:
    Particles() noexcept; // not inline, as that of RetiredArrays
    ~Particles();

    /// Returns the particles in the caller's order, as they were at the last commit().
    Configuration const &all() const noexcept { return all_; }

    /// Returns the same particles, to be changed outside of sessions.
    Configuration &change() noexcept
    {
        is_copied_ = false;
        return all_;
    }

    /// Adds a particle as the last one. Returns a status.
    int add(Particle const &particle) noexcept;

    /// Removes a particle. The last one takes its number.
    void remove(std::size_t particle) noexcept;

    /// Copies the particles unless the copy is theirs. Returns a status.
    int begin_session() noexcept;

    /// Copies the particles that have moved back. A sweep moves a third of them, and their places
    /// are in random order. So the others are not copied.
    void commit() noexcept;

    /// Copies the particle at a place back.
    void commit(std::size_t place) noexcept;

    /// Gives up all that has moved since the last commit(). The session is over.
    void roll_back() noexcept { is_copied_ = false; }

    /// Commits, and recomputes the memory order. Returns a status.
    int reorder() noexcept;

    /// Returns the copy, by places in memory.
    Configuration const &copy() const noexcept { return copy_; }

    /// Returns the number of copies that were made.
    std::uint64_t generation() const noexcept { return generation_; }

    MemoryOrder const &order() const noexcept { return order_; }

    /// Returns the sizes of the particles of the copy.
    Sizes const &sizes() const noexcept { return sizes_; }

    /// Sets the particle at a place. It is not part of the next commit().
    [[gnu::always_inline]] void set(std::size_t place, Particle const &particle) noexcept
    {
        copy_.set(place, particle);
    }

    /// Makes the particle at a place part of the next commit().
    [[gnu::always_inline]] void accept(std::size_t place) noexcept { is_moved_[place] = true; }

    void accept_all() noexcept
    {
        std::fill_n(is_moved_.data(), is_moved_.size(), std::uint8_t{true});
    }

    /// Exchanges the cell and the centres of the copy for others. A second call restores them.
    void exchange_cell(Cell &cell, Array<Vector3> &centers) noexcept
    {
        std::swap(copy_.cell, cell);
        std::swap(copy_.centers, centers);
    }

  private:
    void measure() noexcept;

    Configuration all_, copy_;
    Owner<RetiredArrays> retired_;
    MemoryOrder order_;
    Array<std::uint8_t> is_moved_; ///< by places: whether a particle may differ from the caller's
    Sizes sizes_;
    std::uint64_t generation_ = 0;
    bool is_copied_ = false; ///< true if the copy is the caller's particles, or follows from them
};

} // namespace pw85::detail::simulation

#endif
