// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// Requests neighbour lists from LAMMPS, and takes pairs from them in batches for the batch
/// functions of pw85.
#ifndef PW85_LAMMPS_NEIGHBOURS_HPP_INCLUDED
#define PW85_LAMMPS_NEIGHBOURS_HPP_INCLUDED

#include <pw85_systems.h>

#include "host.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pw85_lammps {

/// A half neighbour list with the cutoffs of the pair style. LAMMPS rebuilds it together with the
/// list of the pair style.
///
/// It is a pair style without forces, because a compute would need a header that LAMMPS does not
/// install to request a list. Most pair styles have the same kind of list and share it at no cost;
/// for others (full lists, hybrid styles, granular styles) LAMMPS builds this list in addition.
class NeighbourList final : public LAMMPS_NS::Pair {
  public:
    explicit NeighbourList(LAMMPS_NS::LAMMPS *lammps) : Pair(lammps) { list = nullptr; }
    void request() { init_style(); }
    bool built() const { return list != nullptr; }
    LAMMPS_NS::NeighList const &get() const { return *list; }

    void compute(int, int) override {}
    void settings(int, char **) override {}
    void coeff(int, char **) override {}
};

/// The cutoffs of the pair style for which the neighbour lists were made. They are copied, because
/// the pair style may change after a run.
class CutoffTable {
  public:
    void assign(double const *const *squares, int num_types);

    double square(int t, int u) const
    {
        return squares_[stride_ * static_cast<std::size_t>(t) + static_cast<std::size_t>(u)];
    }

  private:
    std::size_t stride_ = 0;
    std::vector<double> squares_;
};

inline void CutoffTable::assign(double const *const *squares, int num_types)
{
    stride_ = static_cast<std::size_t>(num_types) + 1;
    squares_.assign(stride_ * stride_, 0.0);
    for (int t = 1; t <= num_types; ++t)
        std::copy_n(squares[t] + 1, num_types,
                    &squares_[stride_ * static_cast<std::size_t>(t) + 1]);
}

/// The pairs of a neighbour list, in batches. A batch is large enough for several threads of the
/// batch functions, which take 4096 pairs at a time, and small enough for a cache.
class PairBatch {
  public:
    static constexpr std::size_t capacity = 32768;

    PairBatch()
        : pairs(2 * capacity), entries(capacity), special(capacity), mu2(capacity),
          lambda(capacity), overlaps(capacity + 1), tested_(2 * capacity + 2), held_(capacity)
    {
    }

    /// Fills batches with the pairs of the list for which keep(i, j) is true, where i is owned, and
    /// calls use() for each batch.
    template <class Keep, class Use> void run(LAMMPS_NS::NeighList const &list, Keep keep, Use use);

    std::size_t size() const { return size_; }

    /// Keeps the pairs of the present batch that overlap, and returns their list. Calls
    /// refuse(i, j) for a pair for which the library has no answer.
    template <class Refuse> pw85_pair_list keep_overlaps(pw85_system const &system, Refuse refuse);

    /// Keeps the pairs of the present batch that overlap, and, without a test, those for which
    /// holds(entry).
    template <class Refuse, class Holds>
    pw85_pair_list keep_overlaps(pw85_system const &system, Refuse refuse, Holds holds);

    /// Returns the pairs of the present batch, without images.
    pw85_pair_list list() const { return {size_, pairs.data(), nullptr}; }

    std::vector<std::int32_t> pairs; ///< (i, j) by local index
    /// the number of each pair among all pairs of the neighbour list
    std::vector<std::uint32_t> entries;
    std::vector<unsigned char> special;  ///< 0, or the number of the weight of special_bonds
    std::vector<double> mu2, lambda;     ///< memory for results
    std::vector<unsigned char> overlaps; ///< memory for results

  private:
    template <class Refuse, class Held>
    pw85_pair_list keep_overlaps_of(pw85_pair_list const &tested, pw85_system const &system,
                                    Refuse refuse, Held is_held);

    std::size_t size_ = 0;
    std::vector<std::int32_t> tested_; ///< pairs for the overlap test
    std::vector<unsigned char> held_;  ///< true if a pair of the batch is kept without the test
};

template <class Refuse>
pw85_pair_list PairBatch::keep_overlaps(pw85_system const &system, Refuse refuse)
{
    return keep_overlaps_of(list(), system, refuse, [](std::size_t) { return false; });
}

template <class Refuse, class Holds>
pw85_pair_list PairBatch::keep_overlaps(pw85_system const &system, Refuse refuse, Holds holds)
{
    std::size_t count = 0;
    for (std::size_t k = 0; k < size_; ++k) {
        tested_[2 * count] = pairs[2 * k];
        tested_[2 * count + 1] = pairs[2 * k + 1];
        held_[k] = holds(entries[k]) ? 1 : 0;
        count += 1u - held_[k];
    }
    return keep_overlaps_of({count, tested_.data(), nullptr}, system, refuse,
                            [this](std::size_t k) { return held_[k] != 0; });
}

// Most pairs do not overlap. The overlap test shows this in a fifth of the time of the derivatives.
template <class Refuse, class Held>
pw85_pair_list PairBatch::keep_overlaps_of(pw85_pair_list const &tested, pw85_system const &system,
                                           Refuse refuse, Held is_held)
{
    pw85_overlap_pairs(&tested, &system, overlaps.data());
    std::size_t count = 0, next = 0;
    for (std::size_t k = 0; k < size_; ++k) {
        int const i = pairs[2 * k], j = pairs[2 * k + 1];
        bool const held = is_held(k);
        unsigned const overlap = held ? 1u : overlaps[next];
        if (overlap > 1) refuse(i, j);
        pairs[2 * count] = i;
        pairs[2 * count + 1] = j;
        entries[count] = entries[k];
        special[count] = special[k];
        count += overlap;
        next += held ? 0u : 1u;
    }
    return {count, pairs.data(), nullptr};
}

template <class Keep, class Use>
void PairBatch::run(LAMMPS_NS::NeighList const &list, Keep keep, Use use)
{
    size_ = 0;
    std::uint32_t entry = 0;
    for (int row = 0; row < list.inum; ++row) {
        int const i = list.ilist[row], count = list.numneigh[i];
        int const *const neighbours = list.firstneigh[i];
        for (int k = 0; k < count; ++k) {
            int const j = neighbours[k] & NEIGHMASK;
            pairs[2 * size_] = i;
            pairs[2 * size_ + 1] = j;
            entries[size_] = entry++;
            special[size_] = static_cast<unsigned char>(neighbours[k] >> SBBITS & 3);
            // There is no branch here, because a processor cannot predict which pairs are kept.
            size_ += keep(i, j) ? 1u : 0u;
            if (size_ < capacity) continue;
            use();
            size_ = 0;
        }
    }
    if (size_ > 0) use();
    size_ = 0;
}

/// Returns whether this processor reports a pair of an owned atom and a ghost.
///
/// With newton off, the pair is in the lists of two processors, or twice in one list if the ghost
/// is an image of the atom itself. Only one of them reports it: the owner of the smaller tag if the
/// sum of the tags is even, otherwise the owner of the larger tag. An atom and its own image are
/// reported from the side that sees the image at larger z, or y, or x.
inline bool belongs_here(LAMMPS_NS::Atom const &atom, int i, int j)
{
    int const ghost = std::max(i, j), owned = std::min(i, j);
    LAMMPS_NS::tagint const a = atom.tag[owned], b = atom.tag[ghost];
    if (a != b) return (a < b) == ((a % 2 + b % 2) % 2 == 0);
    double const *x = atom.x[owned], *y = atom.x[ghost];
    for (int k = 2; k >= 0; --k)
        if (x[k] != y[k]) return x[k] < y[k];
    return true;
}

} // namespace pw85_lammps

#endif
