// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// What the computes over pairs of ellipsoids have in common.
#ifndef PW85_LAMMPS_COMPUTE_PAIRS_HPP_INCLUDED
#define PW85_LAMMPS_COMPUTE_PAIRS_HPP_INCLUDED

#include "build_record.hpp"
#include "ellipsoids.hpp"
#include "neighbours.hpp"

namespace pw85_lammps {

/// A compute over the pairs of ellipsoids of its group, with one value per atom that ghosts return to their owners.
class ComputePairs : public LAMMPS_NS::Compute {
  public:
    ComputePairs(LAMMPS_NS::LAMMPS *lammps, int narg, char **arg);
    ~ComputePairs() override;

    void init() override;
    int pack_forward_comm(int count, int *atoms, double *buffer, int pbc_flag, int *pbc) override;
    void unpack_forward_comm(int count, int first, double *buffer) override;
    int pack_reverse_comm(int count, int first, double *buffer) override;
    void unpack_reverse_comm(int count, int *atoms, double *buffer) override;
    double memory_usage() override;

  protected:
    /// Which pairs must not be missed.
    enum class Needed { contacts, all_within_cutoff };

    /// Brings positions of ghosts, and forms of all ellipsoids, up to date, and sets all values per atom.
    /// @param scale scale factor of the ellipsoids up to which they may touch
    void begin(Needed needed, double scale, double initial_value);

    /// Adds what ghosts gathered to the values of their owners.
    void end();

    /// How a value that a ghost gathered enters that of its owner.
    virtual double merge(double value, double from_ghost) const = 0;

    /// Atoms with a smaller index get the values that pairs add to them: all if newton is on, else those owned. A pair
    /// with another atom is in the list of another processor too.
    int num_counted() const { return force->newton_pair ? atom->nlocal + atom->nghost : atom->nlocal; }

    /// Whether a kind of values, last computed at some step, is that of the present: LAMMPS takes the flag back whenever
    /// something may have changed, also within a step.
    bool is_current(int kind, LAMMPS_NS::bigint step) const;

    double &value(int i) { return values_[static_cast<std::size_t>(i)]; }

    Ellipsoids ellipsoids;
    NeighbourList neighbours;
    CutoffTable cutoffs;
    PairBatch batch;

  private:
    Movement movement_since_build() const;
    void check_reach(Needed needed, double scale, Movement const &movement);

    std::string const record_id_;
    std::vector<double> values_;
    bool warned_ = false;
};

} // namespace pw85_lammps

#endif
