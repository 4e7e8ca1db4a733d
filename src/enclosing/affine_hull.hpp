// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The smallest ellipsoid around points in a hyperplane, within their affine hull: the smallest
/// ellipsoid around their coordinates along an orthonormal basis of it. Coordinates are rounded:
/// points can be outside by rounding errors, and there is no certificate.
#ifndef PW85_ENCLOSING_AFFINE_HULL_HPP_INCLUDED
#define PW85_ENCLOSING_AFFINE_HULL_HPP_INCLUDED

#include "basis.hpp"
#include "smallest.hpp"

namespace pw85::detail::enclosing {

class AffineHullSearch {
  public:
    /// The points must outlive the search.
    AffineHullSearch(int n, std::size_t m, double const *points) noexcept
        : cloud_{n, m, points, {}, {}}, basis_{n, 0, {}}
    {
    }

    /// Returns success, or no_convergence if the excess is larger than the tolerance: in both cases
    /// there is an ellipsoid. Directions are left out, one at least, until a search along the
    /// others has a certificate. Those along which points extend less than 2^-24 are the first.
    Status run(double tolerance) noexcept;

    double center(int i) const noexcept;
    double form(int i, int j) const noexcept;
    double excess() const noexcept { return excess_; }

  private:
    bool find_basis() noexcept;
    Status search_along_basis(double tolerance) noexcept;
    void find_coordinates() noexcept;
    void lift(Search const &search) noexcept;

    Cloud cloud_;
    Basis basis_;                       ///< of the differences of scaled points
    double center_[max_dimension] = {}; ///< relative to the first point, scaled
    double form_[max_packed] = {};      ///< the lower triangle, scaled
    double excess_ = 0.0;
    Array<double> rows_; ///< rests of differences, and then coordinates
};

} // namespace pw85::detail::enclosing

#endif
