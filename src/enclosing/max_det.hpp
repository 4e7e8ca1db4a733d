// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The smallest ellipsoid around a few ellipsoids, as the maximum of a determinant under linear
/// matrix inequalities: L. Vandenberghe, S. Boyd and S.-P. Wu, SIAM J. Matrix Anal. Appl. 19, 499
/// (1998).
///
/// Let d = n + 1. Ellipsoid i is the image of the unit ball, (x, 1) = L_i (y, 1) with |y| <= 1. The
/// outer ellipsoid is the set (x, 1)ᵀ Z (x, 1) <= d. It holds ellipsoid i if and only if
///
///     S_i = d e eᵀ + λ_i J - L_iᵀ Z L_i,    e = (0, ..., 0, 1),    J = diag(1, ..., 1, -1),
///
/// is positive semidefinite for some λ_i (S-lemma). Its volume is least where -log det Z is. The
/// dual problem has moments W_i = Σ w (y, 1)(y, 1)ᵀ of points of the unit sphere, positive
/// semidefinite with tr J W_i = 0, and V = Σ L_i W_i L_iᵀ. The difference of the two volumes,
///
///     -log det Z - (log det V + d - d Σ (W_i)_dd) = Σ tr S_i W_i + (tr Z V - d - log det Z V),
///
/// is zero where S_i W_i = 0 and Z V = 1.
///
/// 1. Begin with W_i = diag(1/n, ..., 1/n, 1)/(m α), Z = α V⁻¹ and λ_i = d/2, with α so small that
///    all S_i are positive definite.
/// 2. Newton's step for S_i W_i = θ and Z V = 1, with δW = θ S⁻¹ - W - sym(W δS S⁻¹) and δV = Z⁻¹ -
///    V - sym(V δZ Z⁻¹) (C. Helmberg, F. Rendl, R. J. Vanderbei and H. Wolkowicz, SIAM J. Optim. 6,
///    342 (1996)). It is an equation for δZ, from which δλ_i are eliminated.
/// 3. Go along it while all matrices remain positive definite, choose a smaller θ, back to step 2.
///
/// About 15 steps reach a difference of 10⁻⁷ in double precision. Further steps need T = Wide.
#ifndef PW85_ENCLOSING_MAX_DET_HPP_INCLUDED
#define PW85_ENCLOSING_MAX_DET_HPP_INCLUDED

#include "../base/array.hpp"
#include "cloud.hpp"

namespace pw85::detail::enclosing {

inline constexpr std::size_t max_lifted = max_dimension + 1;

/// A d×d matrix, with rows of the length d.
template <class T> struct Square {
    T x[max_lifted * max_lifted];
};

template <class T> class MaxDet {
  public:
    /// Makes room for ellipsoids in n dimensions. Returns false if there is no memory.
    bool reserve(int n, std::size_t count) noexcept;

    std::size_t size() const noexcept { return count_; }
    /// Returns L_i, which the caller sets.
    Square<T> &map(std::size_t i) noexcept { return blocks_[i].map; }
    Square<T> const &z() const noexcept { return z_; }
    T const &lambda(std::size_t i) const noexcept { return blocks_[i].lambda; }
    /// W_i.
    Square<T> const &moments(std::size_t i) const noexcept { return blocks_[i].moments; }

    void begin() noexcept;
    /// Begins at the result of a search for the same ellipsoids.
    template <class U> void begin_at(MaxDet<U> const &other) noexcept;

    /// Improves Z and W until the difference is not above `gap`, or as far as rounding errors
    /// permit. Returns the difference.
    double solve(double gap) noexcept;

  private:
    template <class U> friend class MaxDet;
    struct Block {
        Square<T> map, slack, inverse, moments, coupling, slack_step, moment_step;
        T lambda, pull, stiffness; ///< λ, θ tr J S⁻¹, and tr J W J S⁻¹
    };

    bool evaluate() noexcept;
    double distance_from_inverse() const noexcept;
    void assemble(T const &theta) noexcept;
    bool find_steps(T const &theta) noexcept;
    bool is_definite_at(Square<T> const &x, Square<T> const &step, T const &share) const noexcept;
    double advance() noexcept;
    void multiply(T const *a, T const *b, bool transposed, T *c) const noexcept;
    bool invert(T const *a, T *inverse) const noexcept;
    void add_operator(T const *p, T const *q, T const *coupling, T const &stiffness) noexcept;

    std::size_t d_ = 0, size_of_step_ = 0, count_ = 0;
    Square<T> z_, v_, z_inverse_, z_step_;
    Array<Block> blocks_;
    Array<T> hessian_, step_;
    T product_; ///< Σ tr S_i W_i
};

template <class T> template <class U> void MaxDet<T>::begin_at(MaxDet<U> const &other) noexcept
{
    for (std::size_t k = 0; k < d_ * d_; ++k) z_.x[k] = T(other.z_.x[k]);
    for (std::size_t i = 0; i < count_; ++i) {
        blocks_[i].lambda = T(other.blocks_[i].lambda);
        for (std::size_t k = 0; k < d_ * d_; ++k)
            blocks_[i].moments.x[k] = T(other.blocks_[i].moments.x[k]);
    }
}

extern template class MaxDet<double>;
extern template class MaxDet<Wide>;

} // namespace pw85::detail::enclosing

#endif
