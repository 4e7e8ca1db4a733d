// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// Bins of the atoms of a processor and its ghosts, for fix pw85/hpmc. Atoms may change their bins
/// one after the other.
#ifndef PW85_LAMMPS_BINS_HPP_INCLUDED
#define PW85_LAMMPS_BINS_HPP_INCLUDED

#include "vectors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace pw85_lammps {

/// Each bin is a doubly linked list of local indices. Atoms beyond the bins are in the bins at
/// their sides.
class Bins {
  public:
    /// @param lower,upper the region with bins
    /// @param edge the smallest edge of a bin
    void build(int count, double const *x, Vector const &lower, Vector const &upper, double edge)
    {
        lower_ = lower;
        std::size_t num_bins = 1;
        for (std::size_t k = 0; k < counts_.size(); ++k) {
            counts_[k] = std::max(1, static_cast<int>((upper[k] - lower[k]) / edge));
            per_length_[k] = counts_[k] / (upper[k] - lower[k]);
            num_bins *= static_cast<std::size_t>(counts_[k]);
        }
        first_.assign(num_bins, none);
        atoms_.resize(static_cast<std::size_t>(count));
        // The loop runs backwards to give each list its atoms in the order of memory.
        for (int i = count - 1; i >= 0; --i)
            link(i, bin_of(x + 3 * static_cast<std::ptrdiff_t>(i)));
    }

    /// Moves an atom to the bin of its new position.
    void update(int i, double const *x)
    {
        std::size_t const bin = bin_of(x);
        if (bin == entry(i).bin) return;
        unlink(i);
        link(i, bin);
    }

    /// Calls use(j) for all atoms that may be within a distance of x, and for some that are
    /// farther.
    template <class Use> void visit(double const *x, double distance, Use use) const
    {
        std::array<int, 3> from{}, to{};
        for (std::size_t k = 0; k < counts_.size(); ++k) {
            from[k] = coordinate(k, x[k] - distance);
            to[k] = coordinate(k, x[k] + distance);
        }
        for (int c = from[2]; c <= to[2]; ++c)
            for (int b = from[1]; b <= to[1]; ++b)
                for (int a = from[0]; a <= to[0]; ++a)
                    for (int j = first_[index(a, b, c)]; j != none; j = entry(j).next) use(j);
    }

    double bytes() const
    {
        return static_cast<double>(first_.capacity() * sizeof(int) +
                                   atoms_.capacity() * sizeof(Entry));
    }

  private:
    static constexpr int none = -1;

    struct Entry {
        int next, previous;
        std::size_t bin;
    };

    Entry &entry(int i) { return atoms_[static_cast<std::size_t>(i)]; }
    Entry const &entry(int i) const { return atoms_[static_cast<std::size_t>(i)]; }

    int coordinate(std::size_t k, double x) const
    {
        double const bin = std::floor((x - lower_[k]) * per_length_[k]);
        return static_cast<int>(std::clamp(bin, 0.0, static_cast<double>(counts_[k] - 1)));
    }

    std::size_t index(int a, int b, int c) const
    {
        auto const size = [this](std::size_t k) { return static_cast<std::size_t>(counts_[k]); };
        return static_cast<std::size_t>(a) +
               size(0) * (static_cast<std::size_t>(b) + size(1) * static_cast<std::size_t>(c));
    }

    std::size_t bin_of(double const *x) const
    {
        return index(coordinate(0, x[0]), coordinate(1, x[1]), coordinate(2, x[2]));
    }

    void link(int i, std::size_t bin)
    {
        int const next = first_[bin];
        entry(i) = {next, none, bin};
        if (next != none) entry(next).previous = i;
        first_[bin] = i;
    }

    void unlink(int i)
    {
        Entry const old = entry(i);
        (old.previous == none ? first_[old.bin] : entry(old.previous).next) = old.next;
        if (old.next != none) entry(old.next).previous = old.previous;
    }

    Vector lower_{}, per_length_{};
    std::array<int, 3> counts_{};
    std::vector<int> first_;
    std::vector<Entry> atoms_;
};

} // namespace pw85_lammps

#endif
