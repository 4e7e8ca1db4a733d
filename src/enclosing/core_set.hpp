// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The weights of a few points: the maximum of log det V(u) - (n + 1) Σ u_i over u >= 0, with V(u)
/// = Σ u_i y_i y_iᵀ and y = (w, 1). At the maximum κ_i = y_iᵀ V⁻¹ y_i is n + 1 where u_i > 0 and at
/// most n + 1 elsewhere, and the weights have the sum 1.
///
/// The method is the reduced Newton method for the dual problem of P. Sun and R. M. Freund, Oper.
/// Res. 52, 690 (2004), in lifted points. It keeps t_i = n + 1 - κ_i as a variable and solves
///
///     (H + diag(t/u)) δu = θ/u - (n + 1 - κ),    H_ij = (y_iᵀ V⁻¹ y_j)²,
///
/// for smaller and smaller θ. About 20 steps give all digits, where steps of M. J. Todd and E. A.
/// Yıldırım, Discrete Appl. Math. 155, 1731 (2007), take a number proportional to 1/tolerance until
/// they converge linearly. Points that are equal, or more than a minimum needs, are harmless: they
/// only make H singular.
#ifndef PW85_ENCLOSING_CORE_SET_HPP_INCLUDED
#define PW85_ENCLOSING_CORE_SET_HPP_INCLUDED

#include "../base/array.hpp"
#include "cloud.hpp"

namespace pw85::detail::enclosing {

class CoreSet {
  public:
    explicit CoreSet(int n) noexcept : rows_(static_cast<std::size_t>(n) + 1) {}

    /// Allocates memory for this number of points. Returns false if there is no memory.
    bool reserve(std::size_t count) noexcept;

    std::size_t size() const noexcept { return size_; }
    std::size_t const *points() const noexcept { return points_.data(); }
    double const *weights() const noexcept { return weights_.data(); }
    /// Returns the coordinates w of a point, for the caller to set before solve().
    double *coordinates(std::size_t i) noexcept { return &coordinates_[i * rows_]; }

    bool contains(std::size_t point) const noexcept;
    void append(std::size_t point, double weight) noexcept;
    /// Removes points that have almost no weight and are far inside: κ <= (n + 1)(1 - 4 gap). If
    /// more than half of the capacity is used, removes all points that have less than 5 % of the
    /// mean weight.
    void remove_idle(double gap) noexcept;

    /// Improves the weights until max κ <= n + 1 + n gap, or as far as rounding errors permit.
    void solve(double gap) noexcept;

  private:
    bool evaluate() noexcept;
    bool solve_newton(double theta) noexcept;
    double advance() noexcept;
    void normalize() noexcept;

    std::size_t rows_, size_ = 0;
    Array<std::size_t> points_;
    Array<double> weights_, slacks_, kappa_, steps_, coordinates_, solved_, hessian_;
};

} // namespace pw85::detail::enclosing

#endif
