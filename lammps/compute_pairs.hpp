// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// The base class of the computes over pairs of ellipsoids (compute_contact.hpp,
/// compute_overlap.hpp).
#ifndef PW85_LAMMPS_COMPUTE_PAIRS_HPP_INCLUDED
#define PW85_LAMMPS_COMPUTE_PAIRS_HPP_INCLUDED

#include "build_record.hpp"
#include "ellipsoids.hpp"
#include "neighbours.hpp"

namespace pw85_lammps {

/// A compute over the pairs of ellipsoids of its group. It has one value per atom; ghosts send
/// their values back to the owners.
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
    /// Pairs that the compute needs.
    enum class Needed { contacts, all_within_cutoff };

    /// Updates the positions of ghosts and the forms of all ellipsoids, and sets all values per
    /// atom to `initial_value`.
    /// @param scale largest scale factor of the ellipsoids at which contacts are needed
    void begin(Needed needed, double scale, double initial_value);

    /// Merges the values of ghosts into the values of their owners.
    void end();

    /// Merges the value of a ghost into that of its owner.
    virtual double merge(double value, double from_ghost) const = 0;

    /// Returns the number of atoms to whose values pairs add: all atoms if newton is on, otherwise
    /// the owned atoms, because the list of another processor then has the pair, too.
    int num_counted() const
    {
        return force->newton_pair ? atom->nlocal + atom->nghost : atom->nlocal;
    }

    /// Returns whether values of this kind, which were last computed at `step`, are still valid.
    /// LAMMPS clears the flag whenever something may have changed, also within a step.
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
