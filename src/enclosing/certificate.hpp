// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Proofs for an ellipsoid whose centre and form are doubles: every point is inside, and its volume
/// exceeds the least volume by at most a share.
///
/// Let u = 2⁻⁵³. Operations on Doubled numbers err by at most 4u² of the magnitudes of the terms
/// (sums), 8u² (products) and 16u² (quotients) of the result. A sum of n <= 16 products therefore
/// errs by at most (8 + 4 · 16) u² < 80u² of the sum of the magnitudes. The constants below are at
/// least twice what follows from that, which also covers the roundings of the bounds themselves.
///
/// 1. Let A be any matrix and P = A Q Aᵀ with |P - 1| <= η < 1 in the row-sum norm. Then Q⁻¹ = Aᵀ
///    P⁻¹ A, so zᵀQ⁻¹z <= |A z|²/(1 - η). Hence |A (x - c)|² <= 1 - η proves that x is inside.
/// 2. Let u_i >= 0 be weights with the sum 1, and S the covariance of the points with these
///    weights. Every ellipsoid around the points has det Q' >= nⁿ det S: the mean of (x_i -
///    c')ᵀQ'⁻¹(x_i - c') is at most 1 and at least tr Q'⁻¹S >= n (det S/det Q')^(1/n). So
///    volume/least <= √(det Q/(nⁿ det S)).
/// 3. With T = n A S Aᵀ this ratio is √(det P/det T). Let T = t (1 + D), t = tr T/n, |D| <= F < 1
///    in the Frobenius norm. As tr D = 0, log det T >= n log t - F²/(2 (1 - F)); and log det P <= n
///    η.
#ifndef PW85_ENCLOSING_CERTIFICATE_HPP_INCLUDED
#define PW85_ENCLOSING_CERTIFICATE_HPP_INCLUDED

#include "frame.hpp"

namespace pw85::detail::enclosing {

class Certificate {
  public:
    /// Sets the centre and the form, a lower triangle, both in the units of the cloud. Returns
    /// false if the form is not positive definite, or too close to a singular one for the proofs.
    bool prepare(Cloud const &cloud, double const *center, double const *form) noexcept;

    /// Returns the relative change of |A z|² by a relative change of u of each entry of the form.
    double sensitivity() const noexcept { return sensitivity_; }

    /// Returns an upper bound of |A (x - c)|² - (1 - η), not above 0 if the point is proved to be
    /// inside.
    double protrusion(std::size_t point) const noexcept;

    /// Returns the largest bound of these points, and of all points. Those of all points are
    /// compared in double precision first.
    double largest_protrusion(std::size_t count, std::size_t const *points) const noexcept;
    double largest_protrusion() const noexcept;

    /// Returns an upper bound of volume/least - 1 by the weights of some points.
    double excess(std::size_t count, std::size_t const *points,
                  double const *weights) const noexcept;

  private:
    double error_of(int row, Wide const *z) const noexcept;
    double add_moments(std::size_t point, double weight, Wide *first, Wide *second) const noexcept;
    double ratio_excess(Wide const *t, double error) const noexcept;

    Cloud const *cloud_;
    Frame frame_;
    double eta_, sensitivity_;
};

} // namespace pw85::detail::enclosing

#endif
