// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Sorts the particles of a simulation into bins. The event chains (chain_bodies.hpp) find the
/// neighbours of a particle here, and move it. Particles are numbered here in the order of the bins
/// at the start: particles near each other in space are near in memory.
///
/// Vector k of the cell is divided into equal parts if it is periodic. A bin is a parallelepiped of
/// parts. It has the particles whose centres are in it, after they are moved into the cell, in
/// blocks of four. All its blocks but the first one are full.
///
/// Boxes are in single precision. Their unit is a power of two near the longest length of the
/// particles and the cell, so they are in range in any units of the caller.
#ifndef PW85_SIMULATION_BINS_HPP_INCLUDED
#define PW85_SIMULATION_BINS_HPP_INCLUDED

#include <bit>
#include <limits>
#include <utility>

#include "configuration.hpp"

namespace pw85::detail::simulation {

/// The side of a bin over the longest semi-axis of all particles, in searches of chains and
/// insertions.
inline constexpr double bin_size = 1.0;

class Bins {
  public:
    /// Divides the cell into parts not much smaller than `side`, but not into many more bins than
    /// particles. Returns a status.
    ///
    /// @param more how many particles may be added afterwards
    int prepare(Configuration const &configuration, double side, std::size_t more = 0) noexcept;

    /// Adds a particle. It gets the next number, or the number of a removed particle.
    void add(std::size_t i, std::size_t in_configuration, Vector3 const &center,
             Vector3 const &half_widths) noexcept;

    /// Removes particle i. Its number is free for another one.
    void take_out(std::size_t i) noexcept { remove(i); }

    /// Changes the number of particle i in the configuration.
    void rename(std::size_t i, std::size_t in_configuration) noexcept
    {
        order_[i] = static_cast<std::int32_t>(in_configuration);
    }

    /// Returns the number of a particle in the configuration.
    [[gnu::always_inline]] std::size_t number_in_configuration(std::size_t i) const noexcept
    {
        return static_cast<std::size_t>(order_[i]);
    }

    /// Moves particle i to the bin of its new centre.
    void move(std::size_t i, Vector3 const &center) noexcept;

    /// Calls visit_one(j, cell) for each image of a particle whose box intersects a given box, and
    /// for some whose boxes nearly do. `cell` is the cell in which the centre of the image is.
    ///
    /// A box intersects some consecutive parts of each vector, which may be more than the cell has.
    /// Part p + m · parts is part p of the image that is m cells further. So the search also finds
    /// several images of a particle in a small cell.
    template <class Visit> [[gnu::always_inline]] void
    visit(Vector3 const &center, Vector3 const &half_widths, Visit const &visit_one) const noexcept
    {
        Part first[3];
        Multiples home;
        for (int k = 0; k < 3; ++k) home.n[k] = find_range(k, center, half_widths, first[k]);
        Query query{{}, {}, {}};
        for (int d = 0; d < 3; ++d) query.reach[d] += to_local(half_widths[d]) + margin_;
        Vector3 const from = center - cell_.translation(home);
        auto const &[x, y, z] = first;
        for (Part a = x; a.left > 0; next(0, a, 1))
            for (Part b = y; b.left > 0; next(1, b, 1))
                for (Part c = z; c.left > 0;) {
                    Multiples const cell{{a.cell, b.cell, c.cell}};
                    Vector3 const shift = cell_.translation(cell) - from;
                    for (int d = 0; d < 3; ++d) query.shift[d] = Float4{} + to_local(shift[d]);
                    for (int k = 0; k < 3; ++k) query.cell.n[k] = cell.n[k] + home.n[k];
                    std::int32_t const count = minimum(c.left, parts_[2] - c.number);
                    std::size_t const bin = bin_of(a.number, b.number, c.number);
                    for (std::int32_t k = 0; k < count; ++k)
                        visit_bin(bin + static_cast<std::size_t>(k), query, visit_one);
                    next(2, c, count);
                }
    }

    /// Returns the image of particle j whose centre is in a cell, as that of the configuration,
    /// whose centres are not moved into the cell.
    [[gnu::always_inline]] Multiples image_in(Multiples const &cell, std::size_t j) const noexcept
    {
        auto const &home = places_[j].cell;
        return {{cell.n[0] - home.n[0], cell.n[1] - home.n[1], cell.n[2] - home.n[2]}};
    }

    /// Brings the bin position of a particle into the cache.
    [[gnu::always_inline]] void prefetch(std::size_t j) const noexcept
    {
        simulation::prefetch(&places_[j], 1);
    }

  private:
    typedef float Float4 __attribute__((vector_size(16)));
    typedef std::int32_t Int4 __attribute__((vector_size(16)));

    /// Converts a length to the unit of boxes.
    [[gnu::always_inline]] float to_local(double length) const noexcept
    {
        return static_cast<float>(per_unit_ * length);
    }

    /// The box of a particle, moved into the cell, in the unit of boxes.
    struct Box {
        float center[3], half_widths[3];
    };

    /// Up to four particles of a bin. Empty lanes have negative infinite half-widths; their boxes
    /// intersect no other box.
    struct Block {
        Float4 center[3], half_widths[3];
        std::int32_t particle[4];
        std::int32_t next; ///< block of the bin, or of those that are not in use; -1 at the end
        std::int32_t count;
    };

    /// Bin, block and lane of a particle.
    struct Place {
        std::int32_t block, lane, bin;
        Multiples cell; ///< the cell of its centre
    };

    /// One of consecutive parts of a vector: its number within the cell, the cell that it is in,
    /// and how many are left.
    struct Part {
        std::int32_t number, cell, left;
    };

    /// Box that is compared with the boxes of a bin, with the same numbers in each lane.
    struct Query {
        /// from the centre of the box to the cell of the bin, and its half-widths
        Float4 shift[3], reach[3];
        Multiples cell;
    };

    std::size_t bin_of(std::int32_t x, std::int32_t y, std::int32_t z) const noexcept
    {
        auto const size = [](std::int32_t number) { return static_cast<std::size_t>(number); };
        return (size(x) * size(parts_[1]) + size(y)) * size(parts_[2]) + size(z);
    }

    /// Advances by some parts, at most to the first part of the next cell.
    [[gnu::always_inline]] void next(int k, Part &part, std::int32_t count) const noexcept
    {
        part.left -= count;
        part.number += count;
        if (part.number < parts_[k]) return;
        part.number = 0;
        ++part.cell;
    }

    /// Compares a box with the four boxes of a block at once, in single precision. Blocks 0, 1, ...
    /// are the first ones of bins 0, 1, ...
    template <class Visit> [[gnu::always_inline]] void
    visit_bin(std::size_t bin, Query const &query, Visit const &visit_one) const noexcept
    {
        Block const *block = &blocks_[bin];
        for (;; block = &blocks_[static_cast<std::size_t>(block->next)]) {
            Int4 meets = {-1, -1, -1, -1};
            for (int d = 0; d < 3; ++d) {
                auto const bits = reinterpret_cast<Int4>(block->center[d] + query.shift[d]);
                meets &= reinterpret_cast<Float4>(bits & 0x7fffffff) <=
                         block->half_widths[d] + query.reach[d];
            }
            for (unsigned bits = to_bits(meets); bits != 0; bits &= bits - 1)
                visit_one(static_cast<std::size_t>(block->particle[std::countr_zero(bits)]),
                          query.cell);
            if (block->next < 0) return;
        }
    }

    /// Returns the bits of a mask: bit k is that of lane k.
    [[gnu::always_inline]] static unsigned to_bits(Int4 const &mask) noexcept
    {
#ifdef __SSE2__
        return static_cast<unsigned>(__builtin_ia32_movmskps(reinterpret_cast<Float4>(mask)));
#else
        return static_cast<unsigned>((mask[0] & 1) | (mask[1] & 2) | (mask[2] & 4) | (mask[3] & 8));
#endif
    }

    /// Finds the parts of vector k in which centres of boxes that intersect a box may be, in cells
    /// relative to that of the centre. Returns the cell of the centre.
    std::int32_t find_range(int k, Vector3 const &center, Vector3 const &half_widths,
                            Part &first) const noexcept;

    static Block empty_block(std::int32_t next) noexcept;
    void copy_full_block(std::int32_t from, std::int32_t to) noexcept;
    void clear(std::size_t num_bins) noexcept;
    bool sort(Configuration const &configuration, std::size_t num_bins) noexcept;
    bool fill(Configuration const &configuration) noexcept;
    void divide(double side, double most) noexcept;
    double largest_of_cell() const noexcept;
    double spanned_bins() const noexcept;
    double magnitude_of(Vector3 const &center, Box const &box) const noexcept;
    void widen_margin(double magnitude) noexcept;
    void set(Place const &place, std::int32_t particle, Box const &box) noexcept;
    Box get(Place const &place) const noexcept;
    void insert(std::size_t i, std::int32_t bin, Box const &box) noexcept;
    void insert(std::size_t i, Vector3 const &center, Vector3 const &half_widths) noexcept;
    void remove(std::size_t i) noexcept;
    std::int32_t locate(Vector3 const &center, Multiples &cell, Box &box) const noexcept;

    Block &block(std::int32_t number) noexcept { return blocks_[static_cast<std::size_t>(number)]; }

    Cell cell_{};
    double per_unit_ = 1.0; ///< of boxes
    std::int32_t parts_[3] = {1, 1, 1};
    Vector3 dual_[3] = {};
    Vector3 largest_ = {};  ///< of the half-widths of all boxes
    double farthest_ = 0.0; ///< the magnitudes that the margin covers, in the unit of boxes
    /// of the comparisons, for rounding errors (widen_margin())
    float margin_ = 0.0F;
    std::int32_t unused_ = -1; ///< the first block that is not in use
    Array<Block> blocks_;
    Array<Place> places_;
    Array<std::int32_t> order_; ///< the numbers of particles in the configuration
};

} // namespace pw85::detail::simulation

#endif
