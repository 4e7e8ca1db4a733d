// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Decides whether a list still has all pairs after particles and cell have changed.
/// pw85_neighbors_holds() (neighbors.cpp) calls it.
///
/// The list was made for centres c_i, half-widths H_i that include half of the skin, and periodic
/// vectors a_l. Now they are c'_i, h'_i and a'_l. A matrix K takes the vectors back, a'_l (I + K) =
/// a_l, and does not change vectors orthogonal to them. The pair (i, j, n) is r' = c'_j - c'_i + Σ
/// n_l a'_l apart now, and was r = c_j - c_i + Σ n_l a_l apart. For all multiples n, r = r' (I +
/// K) - (w_j - w_i) with w_i = c'_i (I + K) - c_i.
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

    /// Returns the interval [w_d - s_d, w_d + s_d] of a particle along each axis d, with s = H - g
    /// and g_d = Σ_e |δ_ed + K_ed| h'_e. An empty interval has a lower end above its upper end.
    ///
    /// Boxes intersect now if |r'_d| <= h'_id + h'_jd along each axis. Then |r_d| <= g_id + g_jd +
    /// |w_jd - w_id|. The list has all pairs with |r_d| <= H_id + H_jd. So it has this pair, and
    /// all others, if the intervals of all particles have a point in common for each d. This point
    /// is a motion that all particles share, and the list does not depend on it. Intervals have a
    /// common point if any two of them have one.
    Box shared_motions(BoxExtent const &now, BoxExtent const &then) const noexcept;

    /// Returns the box of a particle in the cell for which the list was made: the centre c'_i (I +
    /// K) and the half-widths g.
    BoxExtent taken_back(BoxExtent const &now) const noexcept;

    /// Returns the largest |K_ed|.
    double largest_gradient() const noexcept;

  private:
    /// Adds the error that the rounding of K causes for one periodic vector, as it is now and as it
    /// was then: a_l = a'_l (I + K) + ρ_l, and r has Σ n_l ρ_l in addition. Here n_l is the product
    /// of r' - c'_j + c'_i with a vector D_l that is dual to a'_l, and |D_l| is the largest entry
    /// of D_l. Let |x| be the sum of the magnitudes of x. So s_id must shrink by (|c'_i| + |h'_i|)
    /// Σ_l |D_l| |ρ_ld|.
    void add_error(double dual_bound, double const *now, double const *then) noexcept;

    /// Returns g_d for half-widths h'.
    double half_width(int d, Vector<double, 3> const &now) const noexcept;

    double gradient_[3][3] = {}; ///< K
    double error_[3] = {};       ///< s_d shrinks by this times |c'| + |h'|
};

} // namespace pw85::detail::neighbors

#endif
