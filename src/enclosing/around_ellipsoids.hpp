// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The smallest ellipsoid around ellipsoids:
///
/// 1. The ellipsoids that reach farthest along the coordinates are the first active ones.
/// 2. The smallest ellipsoid around the active ones is found (max_det.hpp).
/// 3. The ellipsoids that protrude most from it become active (at most 4 (n + 1)); those that are
///    far inside and have almost no weight become inactive. Steps 2 and 3 are repeated until no
///    ellipsoid protrudes by more than a part of the tolerance.
/// 4. The moments W_i are those of at most n + 1 points of each active ellipsoid. The weights of
///    the points bound the least volume (certificate.hpp). The points are moved into their
///    ellipsoids, with a proof.
/// 5. The ellipsoid is rounded, and enlarged until all ellipsoids are proved to be inside.
#ifndef PW85_ENCLOSING_AROUND_ELLIPSOIDS_HPP_INCLUDED
#define PW85_ENCLOSING_AROUND_ELLIPSOIDS_HPP_INCLUDED

#include <pw85/any_dimension/containment.hpp>

#include "../base/array.hpp"
#include "certificate.hpp"
#include "cholesky.hpp"

namespace pw85::detail::enclosing {

PW85_FUNCTION inline std::size_t extent(int n) noexcept { return static_cast<std::size_t>(n); }

/// Computes the Cholesky factor B of a form, with rows of the length n: the ellipsoid is the image
/// of the unit ball. A form that is not definite to twice the digits of double gets a tiny pivot.
void factor_of(int n, double const *form, Wide *b) noexcept;

/// Ellipsoids of the caller: rows of centres and of packed forms.
struct Ellipsoids {
    int n;
    std::size_t m;
    double const *centers, *forms;

    double const *center(std::size_t i) const noexcept { return centers + i * extent(n); }
    double const *form(std::size_t i) const noexcept
    {
        return forms + i * extent(any_dimension::packed_size(n));
    }
};

/// A centre and a packed form.
struct Body {
    double center[max_dimension], form[max_packed];
};

class AroundEllipsoids {
  public:
    explicit AroundEllipsoids(Ellipsoids const &bodies) noexcept : bodies_(bodies)
    {
        frame_.n = bodies.n;
    }

    /// Returns success, or no_convergence if the excess is larger than the tolerance: in both cases
    /// there is an ellipsoid.
    Status run(double tolerance) noexcept;

    double center(int i) const noexcept { return cloud_.units[i].to_caller(outer_.center[i]); }
    double form(int i, int j) const noexcept
    {
        return (cloud_.units[i] * cloud_.units[j])
            .to_caller(outer_.form[any_dimension::packed_index(bodies_.n, i, j)]);
    }
    double excess() const noexcept { return excess_; }

  private:
    Status status_of_input() const noexcept;
    Status choose_units() noexcept;
    Body body(std::size_t i) const noexcept;
    bool is_active(std::size_t i) const noexcept;
    bool activate(std::size_t i) noexcept;
    bool begin() noexcept;
    bool update_frame() noexcept;
    void find_map(std::size_t i, Wide *map) noexcept;
    Status enclose_active(double difference, bool is_final) noexcept;
    Wide read_outer() noexcept;
    template <class Search> bool read(Search const &search) noexcept;
    template <class Search> Status read_wider(Search const &search, double difference) noexcept;
    void round_outer(double factor) noexcept;
    double reach(std::size_t i, bool roughly) noexcept;
    double measure() noexcept;
    void drop_idle(double gap) noexcept;
    bool activate_protruding(double gap) noexcept;
    bool add_point(Body const &one, double const *from_center, double weight) noexcept;
    bool add_contacts(std::size_t k) noexcept;
    bool is_inside(std::size_t i) noexcept;
    bool are_inside() noexcept;
    Status certify(double gap, double tolerance) noexcept;

    Ellipsoids bodies_;
    Cloud cloud_{};               ///< the contact points, and the units, of all numbers below
    Frame frame_;                 ///< of the outer ellipsoid
    Wide covariance_[max_packed]; ///< its form over n, a lower triangle
    Body outer_;
    double inverse_[max_packed], excess_ = 0.0;
    Array<std::size_t> active_;
    Array<Square<double>> moments_; ///< W of the active ones
    Array<double> multipliers_;     ///< their λ/ρ, which are the ν of containment.hpp
    Array<double> kappa2_, nu_, points_, weights_;
    Array<std::size_t> indices_;
    any_dimension::ReachWorkspace<double> memory_;
    // Of single functions, too large for the stack.
    Square<Wide> factor_, columns_, map_;
    Square<double> moments_factor_, vectors_;
};

} // namespace pw85::detail::enclosing

#endif
