// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The smallest ellipsoid around points:
///
/// 1. The outermost points along n directions are the first core set (start.hpp).
/// 2. The weights of the core set are improved (core_set.hpp); their mean and covariance are those
///    of an ellipsoid.
/// 3. The points outside of it that are farthest, in its norm, join the core set; points that
///    cannot be on the boundary of the smallest ellipsoid are no longer candidates. Steps 2 and 3
///    are repeated, each time with a tenth of the gap, until the farthest point is near the
///    ellipsoid.
/// 4. The ellipsoid is rounded to double precision and enlarged until it is proved to hold all
///    points (certificate.hpp).
#ifndef PW85_ENCLOSING_SMALLEST_HPP_INCLUDED
#define PW85_ENCLOSING_SMALLEST_HPP_INCLUDED

#include "certificate.hpp"
#include "core_set.hpp"
#include "start.hpp"

namespace pw85::detail::enclosing {

/// Points outside of an ellipsoid, in different directions, the farthest first.
struct Outermost {
    struct Point {
        std::size_t candidate;
        double kappa, w[max_dimension];
    };
    Point points[2 * (max_dimension + 1)];
    int size, limit;
};

class Search {
  public:
    /// The points must outlive the search.
    Search(int n, std::size_t m, double const *points) noexcept
        : cloud_{n, m, points, {}, {}}, core_(n)
    {
        frame_.n = n;
    }

    /// Returns success, or no_convergence if the excess is larger than the tolerance: in both cases
    /// there is an ellipsoid.
    Status run(double tolerance) noexcept;

    double center(int i) const noexcept { return cloud_.units[i].to_caller(center_[i]); }
    double form(int i, int j) const noexcept
    {
        return (cloud_.units[i] * cloud_.units[j]).to_caller(form_[at(j, i)]);
    }
    double excess() const noexcept { return excess_; }

  private:
    std::size_t capacity() const noexcept;
    bool has_memory() noexcept;
    bool begin() noexcept;
    bool update_frame() noexcept;
    void improve_weights(double gap) noexcept;
    double measure() noexcept;
    void eliminate(double gap) noexcept;
    void add_to_worst(std::size_t candidate, Outermost &worst) noexcept;
    int add_worst(double gap) noexcept;
    Status certify(double gap, double tolerance) noexcept;

    Cloud cloud_;
    Frame frame_;
    Wide covariance_[max_packed];
    CoreSet core_;
    Array<std::size_t> candidates_;
    Array<double> kappa_;
    std::size_t count_ = 0;
    Certificate certificate_;
    double triangle_[max_packed], center_[max_dimension], form_[max_packed], excess_ = 0.0;
};

} // namespace pw85::detail::enclosing

#endif
