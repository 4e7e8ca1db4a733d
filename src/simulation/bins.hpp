/// @file
/// The particles of a simulation by their places. The event chains (chains.cpp) ask for the neighbours of a particle, and move it.
///
/// 1. Vector k of the cell is divided into equal parts if it is periodic. A bin is a parallelepiped of parts. It has a list of the
///    particles whose centres are in it, after they are moved into the cell.
/// 2. A box intersects some consecutive parts of each vector, maybe more than there are. Part number p + m parts is that of the image m
///    cells on. So the search also finds several images of a particle in a small cell.
/// 3. Boxes are stored in single precision, one cache line for a particle. The margin, 2⁻²⁰ times the largest sum of the magnitudes in a
///    coordinate, is 16 times the unit roundoff, which bounds the rounding errors of the eight operations from the centres on.
#ifndef PW85_SIMULATION_BINS_HPP_INCLUDED
#define PW85_SIMULATION_BINS_HPP_INCLUDED

#include <algorithm>
#include <cmath>

#include "configuration.hpp"

namespace pw85::detail::simulation {

class Bins {
  public:
    /// Divides the cell into parts not much smaller than `side`, but not into many more bins than particles. Returns a status.
    int prepare(Configuration const &configuration, double side) noexcept;

    /// Takes note of the new centre of particle i.
    void move(std::size_t i, Vector3 const &center) noexcept;

    /// Calls visit_one(j, image) for each image of a particle whose box intersects a box, and for some that are very near. The image is
    /// that of the configuration, whose centres are not moved into the cell.
    template <class Visit> [[gnu::always_inline]] void visit(Vector3 const &center, Vector3 const &half_widths,
                                                             Visit const &visit_one) const noexcept
    {
        Part first[3];
        Multiples home;
        for (int k = 0; k < 3; ++k) home.n[k] = find_range(k, center, half_widths, first[k]);
        Query query{{}, {}, {}};
        for (int d = 0; d < 3; ++d) query.reach[d] = static_cast<float>(half_widths[d]) + margin_;
        Vector3 const from = center - cell_.translation(home);
        auto const &[x, y, z] = first;
        for (Part a = x; a.left > 0; next(0, a))
            for (Part b = y; b.left > 0; next(1, b))
                for (Part c = z; c.left > 0; next(2, c)) {
                    std::int32_t const j = first_[bin_of(a.number, b.number, c.number)];
                    if (j < 0) continue;
                    Multiples const cell{{a.cell, b.cell, c.cell}};
                    Vector3 const shift = cell_.translation(cell) - from;
                    for (int d = 0; d < 3; ++d) query.shift[d] = static_cast<float>(shift[d]);
                    for (int k = 0; k < 3; ++k) query.cell.n[k] = cell.n[k] + home.n[k];
                    visit_bin(j, query, visit_one);
                }
    }

  private:
    /// A particle in the list of its bin.
    struct Entry {
        std::int32_t next, previous; ///< particles; -1 at the ends
        std::int32_t bin;
        Multiples cell;                  ///< the cell of its centre
        float center[3], half_widths[3]; ///< of its box, moved into the cell
    };

    /// One of consecutive parts of a vector: its number within the cell, the cell that it is in, and how many are left.
    struct Part {
        std::int32_t number, cell, left;
    };

    /// What is compared with the boxes of a bin.
    struct Query {
        float shift[3], reach[3]; ///< from the centre of the box to the cell of the bin, and its half-widths
        Multiples cell;
    };

    std::size_t bin_of(std::int32_t x, std::int32_t y, std::int32_t z) const noexcept
    {
        auto const size = [](std::int32_t number) { return static_cast<std::size_t>(number); };
        return (size(x) * size(parts_[1]) + size(y)) * size(parts_[2]) + size(z);
    }

    [[gnu::always_inline]] void next(int k, Part &part) const noexcept
    {
        --part.left;
        if (++part.number < parts_[k]) return;
        part.number = 0;
        ++part.cell;
    }

    template <class Visit>
    [[gnu::always_inline]] void visit_bin(std::int32_t j, Query const &query, Visit const &visit_one) const noexcept
    {
        for (; j >= 0; j = entries_[static_cast<std::size_t>(j)].next) {
            Entry const &entry = entries_[static_cast<std::size_t>(j)];
            bool meets = true;
            for (int d = 0; d < 3; ++d)
                meets &= absolute(entry.center[d] + query.shift[d]) <= entry.half_widths[d] + query.reach[d];
            auto const &[x, y, z] = entry.cell.n;
            auto const &[a, b, c] = query.cell.n;
            if (meets) visit_one(static_cast<std::size_t>(j), Multiples{{a - x, b - y, c - z}});
        }
    }

    /// Finds the parts of vector k in which centres of boxes that intersect a box may be, in cells relative to that of the centre. Returns
    /// the cell of the centre.
    std::int32_t find_range(int k, Vector3 const &center, Vector3 const &half_widths, Part &first) const noexcept;

    bool fill(Configuration const &configuration) noexcept;
    void insert(std::size_t i, std::int32_t bin) noexcept;
    void remove(std::size_t i) noexcept;
    std::int32_t locate(Vector3 const &center, Entry &entry) const noexcept;

    Cell cell_{};
    std::int32_t parts_[3] = {1, 1, 1};
    Vector3 dual_[3] = {};
    Vector3 largest_ = {}; ///< of the half-widths of all boxes
    float margin_ = 0.0F;
    Array<std::int32_t> first_;
    Array<Entry> entries_;
};

} // namespace pw85::detail::simulation

#endif
