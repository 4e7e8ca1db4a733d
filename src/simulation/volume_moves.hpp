// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Trials of the volume, and compression, in a session.
#ifndef PW85_SIMULATION_VOLUME_MOVES_HPP_INCLUDED
#define PW85_SIMULATION_VOLUME_MOVES_HPP_INCLUDED

#include "change.hpp"
#include "model.hpp"

namespace pw85::detail::simulation {

class VolumeMoves {
  public:
    [[gnu::always_inline]] explicit VolumeMoves(Model &model) noexcept : model_(model) {}

    /// Tries one change of the volume. The pressure is that times β. Returns a status.
    ///
    /// The trial multiplies the vectors of the cell and all centres by a matrix E from the right
    /// (change.hpp). E and its inverse are equally probable. The volume V then changes to V det E,
    /// and the density of the states of N particles, V^N exp(-βPV) dV, gives the probability min(1,
    /// (det E)^(N+1) exp(-βP V (det E - 1))) of acceptance. One factor det E comes from the choice
    /// of a multiple of V instead of a difference. In two dimensions the area takes the place of V,
    /// and E changes x and y only. The overlap test is the last step.
    int run(double pressure, ChangeType type) noexcept;

    /// Computes the least isotropic factor of cell and centres without overlap, at most 1; 0 if
    /// there is nothing to overlap. If `take`, it is applied. Returns a status.
    int compress(bool take, double &factor) noexcept;

  private:
    double energy_change(Change const &change) noexcept;
    void apply(Change const &change) noexcept;
    int revert(bool list_is_new) noexcept;
    template <class AcceptEnergy> int
    change_cell(Change const &change, AcceptEnergy const &accept_energy, Outcome &outcome) noexcept;

    Model &model_;
    Cell old_cell_{};            ///< before the trial
    Array<Vector3> old_centers_; ///< before the trial
};

} // namespace pw85::detail::simulation

#endif
