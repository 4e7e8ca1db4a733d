// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// What the computes over pairs of ellipsoids have in common.
#ifndef PW85_LAMMPS_COMPUTE_PAIRS_HPP_INCLUDED
#define PW85_LAMMPS_COMPUTE_PAIRS_HPP_INCLUDED

#include "ellipsoids.hpp"
#include "neighbours.hpp"

namespace pw85_lammps {

/// A compute over the pairs of ellipsoids of its group, with one value per atom that ghosts return to their owners.
class ComputePairs : public LAMMPS_NS::Compute {
  public:
    ComputePairs(LAMMPS_NS::LAMMPS *lammps, int narg, char **arg);

    void init() override;
    int pack_forward_comm(int count, int *atoms, double *buffer, int pbc_flag, int *pbc) override;
    void unpack_forward_comm(int count, int first, double *buffer) override;
    int pack_reverse_comm(int count, int first, double *buffer) override;
    void unpack_reverse_comm(int count, int *atoms, double *buffer) override;
    double memory_usage() override;

  protected:
    /// Brings forms of owned and ghost ellipsoids up to date, and sets all values per atom.
    /// @param reach scale factor of the ellipsoids up to which no contact may be missed
    void begin(double reach, double initial_value);

    /// Adds what ghosts gathered to the values of their owners.
    void end();

    /// How a value that a ghost gathered enters that of its owner.
    virtual double merge(double value, double from_ghost) const = 0;

    /// Atoms with a smaller index get the values that pairs add to them: all if newton is on, else those owned. A pair
    /// with another atom is in the list of another processor too.
    int num_counted() const { return force->newton_pair ? atom->nlocal + atom->nghost : atom->nlocal; }

    double &value(int i) { return values_[static_cast<std::size_t>(i)]; }

    Ellipsoids ellipsoids;
    NeighbourList neighbours;
    PairBatch batch;

  private:
    std::vector<double> values_;
    bool checked_ = false;
};

} // namespace pw85_lammps

#endif
