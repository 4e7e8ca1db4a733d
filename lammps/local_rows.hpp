// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// Local arrays, which computes and fixes give to `dump local`.
#ifndef PW85_LAMMPS_LOCAL_ROWS_HPP_INCLUDED
#define PW85_LAMMPS_LOCAL_ROWS_HPP_INCLUDED

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace pw85_lammps {

/// Rows of numbers, and LAMMPS's pointers to them.
template <std::size_t columns> class LocalRows {
  public:
    using Row = std::array<double, columns>;

    void clear() { rows_.clear(); }
    void add(Row const &row) { rows_.push_back(row); }

    /// Makes the rows the local array of a Compute or a Fix, until rows are added or cleared.
    template <class Owner> void publish(Owner &owner)
    {
        pointers_.resize(rows_.size());
        std::transform(rows_.begin(), rows_.end(), pointers_.begin(),
                       [](Row &row) { return row.data(); });
        owner.array_local = pointers_.data();
        owner.size_local_rows = static_cast<int>(rows_.size());
    }

    double bytes() const
    {
        return static_cast<double>(rows_.capacity() * sizeof(Row) +
                                   pointers_.capacity() * sizeof(double *));
    }

  private:
    std::vector<Row> rows_;
    std::vector<double *> pointers_;
};

} // namespace pw85_lammps

#endif
