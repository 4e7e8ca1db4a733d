// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The smallest ellipsoid around ellipsoids, as the smallest one around points of them:
///
/// 1. The points where some of the ellipsoids meet conjugate axes, and where all of them together
///    reach farthest along the coordinates, are the first points.
/// 2. The smallest ellipsoid around the points is found (smallest.hpp).
/// 3. For each ellipsoid that protrudes from it, the point that protrudes most joins the points (at
///    most 4 (n + 1) of the worst). Each point that is near the surface is replaced by the point of
///    its own ellipsoid that is farthest along the normal there, if that one protrudes. Back to
///    step 2, until nothing protrudes by more than a part of the tolerance.
/// 4. The ellipsoid is enlarged until all ellipsoids are proved to be inside.
///
/// The points are rounded into their ellipsoids, which is proved, too. So the bound that the
/// weights of the points give for the least volume (certificate.hpp) is one for the ellipsoids.
#ifndef PW85_ENCLOSING_AROUND_ELLIPSOIDS_HPP_INCLUDED
#define PW85_ENCLOSING_AROUND_ELLIPSOIDS_HPP_INCLUDED

#include <memory>

#include <pw85/any_dimension/containment.hpp>

#include "smallest.hpp"

namespace pw85::detail::enclosing {

/// Ellipsoids of the caller: rows of centres and of packed forms.
struct Ellipsoids {
    int n;
    std::size_t m;
    double const *centers, *forms;

    double const *center(std::size_t i) const noexcept
    {
        return centers + i * static_cast<std::size_t>(n);
    }
    double const *form(std::size_t i) const noexcept
    {
        return forms + i * static_cast<std::size_t>(any_dimension::packed_size(n));
    }
};

/// An ellipsoid around points, in the units of the caller, and the inverse of its form.
struct OuterEllipsoid {
    int n;
    double center[max_dimension], form[max_packed], inverse[max_packed];
};

class AroundEllipsoids {
  public:
    explicit AroundEllipsoids(Ellipsoids const &bodies) noexcept : bodies_(bodies) {}

    /// Returns success, or no_convergence if the excess is larger than the tolerance: in both cases
    /// there is an ellipsoid.
    Status run(double tolerance) noexcept;

    Search const &search() const noexcept { return *search_; }

  private:
    Status status_of_input() const noexcept;
    bool add_point(std::size_t owner, double const *from_center) noexcept;
    bool add_support(std::size_t owner, double const *normal) noexcept;
    bool add_first_points() noexcept;
    Status enclose_points(double tolerance) noexcept;
    double reach(std::size_t i, double *point, double &nu) noexcept;
    double measure() noexcept;
    bool drop_last_inside(double gap) noexcept;
    bool add_protruding(double gap) noexcept;
    bool follow_normals(double gap) noexcept;
    bool is_inside(std::size_t i) noexcept;
    bool are_inside() noexcept;
    Status certify(double gap, double tolerance) noexcept;

    Ellipsoids bodies_;
    OuterEllipsoid outer_;
    Array<double> points_, kappa2_, nu_;
    Array<std::size_t> owners_;
    std::unique_ptr<Search> search_;
    any_dimension::ReachWorkspace<double> memory_;
};

} // namespace pw85::detail::enclosing

#endif
