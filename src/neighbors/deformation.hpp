// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Decides whether a list still has all pairs after particles and cell have changed.
/// pw85_neighbors_holds() (neighbors.cpp) calls it.
///
/// 1. The list was made for centres c_i, half-widths H_i that include half of the skin, and
///    periodic vectors a_l. Now they are c'_i, h'_i and a'_l. A matrix K takes the vectors back,
///    a'_l (I + K) = a_l, and does not change vectors orthogonal to them. Now the pair (i, j, n) is
///    r' = c'_j - c'_i + Σ n_l a'_l apart. Then it was r = c_j - c_i + Σ n_l a_l apart. For all
///    multiples n,
///        r = r' (I + K) - (w_j - w_i),    w_i = c'_i (I + K) - c_i.
/// 2. Boxes intersect now if |r'_d| <= h'_id + h'_jd along each axis d. Then |r_d| <= g_id + g_jd +
///    |w_jd - w_id| with g_id = Σ_e |δ_ed + K_ed| h'_ie. The list has all pairs with |r_d| <= H_id
///    + H_jd. So it has this pair, and all others, if the intervals [w_id - s_id, w_id + s_id] of
///    all particles, s_i = H_i - g_i, have a point in common for each d. This point is a motion
///    that all particles share, and the list does not depend on it. Intervals have a common point
///    if any two of them have one.
/// 3. Roundings of K: K is computed, so that a_l = a'_l (I + K) + ρ_l, and r has Σ n_l ρ_l in
///    addition. Here n_l is the product of r' - c'_j + c'_i with a vector D_l that is dual to a'_l.
///    The largest entry of D_l is |D_l|. Let |x| be the sum of the magnitudes of x. So s_id must
///    shrink by (|c'_i| + |h'_i|) Σ_l |D_l| |ρ_ld|.
/// 4. Other roundings: those of w_id are below 4 u |w_id| + 12 u |c'_i| max|K_ed|, and those of the
///    ends of the interval are below u |w_id|. So s_id must also shrink by 16 u (|w_id| + (|c'_i| +
///    |h'_i|) max|K_ed|). Those of g_id and of differences with H_id are below 10 u H_id. The list
///    has room for these: its boxes grow by 16 u H_id, of which it needs 2 (periodicity.hpp).
#ifndef PW85_NEIGHBORS_DEFORMATION_HPP_INCLUDED
#define PW85_NEIGHBORS_DEFORMATION_HPP_INCLUDED

#include "build_tree.hpp"
#include "periodicity.hpp"

namespace pw85::detail::neighbors {

/// The linear map from the present cell of a system to the cell for which the list was made.
class Deformation {
  public:
    /// @param periodicity that of the present cell
    /// @param now the present cell: nine numbers; may be null if nothing is periodic
    /// @param then the cell for which the list was made, in the same form
    Deformation(Periodicity const &periodicity, double const *now, double const *then) noexcept;

    /// The interval of item 2 along each axis. An empty interval has a lower end above its upper
    /// end.
    Box shared_motions(Extent const &now, Extent const &then) const noexcept;

  private:
    /// Adds the error that the rounding of K causes for one periodic vector. The vector is given as
    /// it is now and as it was then.
    void add_error(double dual_bound, double const *now, double const *then) noexcept;

    double gradient_[3][3] = {}; ///< K
    double error_[3] = {};       ///< s_id shrinks by this times |c'| + |h'| (items 3 and 4)
};

} // namespace pw85::detail::neighbors

#endif
