// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// Neighbour lists, and pairs taken from them in batches.
#ifndef PW85_LAMMPS_NEIGHBOURS_HPP_INCLUDED
#define PW85_LAMMPS_NEIGHBOURS_HPP_INCLUDED

#include <pw85.h>

#include "host.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pw85_lammps {

/// A half neighbour list with the cutoffs of the pair style, rebuilt whenever the pair style's is.
///
/// It is a pair style without forces: asking for a list in the name of a compute takes a header that LAMMPS does not
/// install. A pair style that has the same kind of list (most have) shares it at no cost; with others (full lists,
/// hybrid styles, granular ones) LAMMPS builds this one.
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

/// The cutoffs of the pair style for which neighbour lists were made; the pair style itself may change after a run.
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
        std::copy_n(squares[t] + 1, num_types, &squares_[stride_ * static_cast<std::size_t>(t) + 1]);
}

/// Pairs of a neighbour list, in batches: enough of them for the threads of the batch functions (4096 pairs for each at a time), and
/// few enough for a cache.
class PairBatch {
  public:
    static constexpr std::size_t capacity = 32768;

    PairBatch() : pairs(2 * capacity), special(capacity), mu2(capacity), lambda(capacity), overlaps(capacity) {}

    /// Calls `use()` for batches of all the pairs of the list for which `keep(i, j)` is true; i is owned.
    template <class Keep, class Use> void run(LAMMPS_NS::NeighList const &list, Keep keep, Use use);

    std::size_t size() const { return size_; }

    /// The pairs, of the particles themselves.
    pw85_pair_list list() const { return {size_, pairs.data(), nullptr}; }

    std::vector<std::int32_t> pairs;     ///< (i, j) by local index
    std::vector<unsigned char> special;  ///< 0, or which of the weights of special_bonds holds
    std::vector<double> mu2, lambda;     ///< room for results
    std::vector<unsigned char> overlaps; ///< room for results

  private:
    std::size_t size_ = 0;
};

template <class Keep, class Use> void PairBatch::run(LAMMPS_NS::NeighList const &list, Keep keep, Use use)
{
    size_ = 0;
    for (int row = 0; row < list.inum; ++row) {
        int const i = list.ilist[row], count = list.numneigh[i];
        int const *const neighbours = list.firstneigh[i];
        for (int k = 0; k < count; ++k) {
            int const j = neighbours[k] & NEIGHMASK;
            pairs[2 * size_] = i;
            pairs[2 * size_ + 1] = j;
            special[size_] = static_cast<unsigned char>(neighbours[k] >> SBBITS & 3);
            // Which pairs are kept is hard to predict: no branch.
            size_ += keep(i, j) ? 1 : 0;
            if (size_ < capacity) continue;
            use();
            size_ = 0;
        }
    }
    if (size_ > 0) use();
    size_ = 0;
}

} // namespace pw85_lammps

#endif
