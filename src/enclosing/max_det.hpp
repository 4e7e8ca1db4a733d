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
#include "cholesky.hpp"

namespace pw85::detail::enclosing {
namespace { // around_ellipsoids.cpp alone includes it

double rounded(double x) noexcept { return x; }
double rounded(Wide const &x) noexcept { return x.high; }

/// Returns entry i of the diagonal of J.
double sign_of(std::size_t i, std::size_t d) noexcept { return i + 1 < d ? 1.0 : -1.0; }

/// Differences below this have no correct digits: S is rounded by u, and S⁻¹ by u over the
/// difference, relatively. The step for V is multiplied by S⁻¹ again.
constexpr double least_gap(double) noexcept { return 1e-9; }
constexpr double least_gap(Wide const &) noexcept { return 1e-24; }

constexpr int max_steps = 60;
/// Maximum number of successive steps that do not halve the difference; then the search ends.
constexpr int max_idle_steps = 5;

/// Returns the factor of the next θ. θ must not become small before Z V is close to 1.
double reduction(double distance, double share) noexcept
{
    if (share < 0.5) return 1.0;
    if (distance > 0.1) return distance > 0.5 ? 0.5 : 0.2;
    return share > 0.95 ? 0.03 : 0.1;
}

template <class T> class MaxDet {
  public:
    /// Allocates memory for ellipsoids in n dimensions. Returns false if there is no memory.
    bool reserve(int n, std::size_t count) noexcept;

    /// Returns L_i, which the caller sets.
    Square<T> &map(std::size_t i) noexcept { return blocks_[i].map; }
    Square<T> const &z() const noexcept { return z_; }
    T const &lambda(std::size_t i) const noexcept { return blocks_[i].lambda; }
    /// W_i.
    Square<T> const &moments(std::size_t i) const noexcept { return blocks_[i].moments; }

    void begin() noexcept;
    /// Starts at the result of a search for the same ellipsoids.
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
    double distance_from_inverse() noexcept;
    void assemble(T const &theta) noexcept;
    bool find_steps(T const &theta) noexcept;
    bool is_definite_at(Square<T> const &x, Square<T> const &step, T const &share) noexcept;
    double advance() noexcept;
    void multiply(T const *a, T const *b, bool transposed, T *c) const noexcept;
    bool invert(T const *a, T *inverse) noexcept;
    void add_operator(T const *p, T const *q, T const *coupling, T const &stiffness) noexcept;

    std::size_t d_ = 0, size_of_step_ = 0, count_ = 0;
    Square<T> z_, v_, z_inverse_, z_step_;
    Array<Block> blocks_;
    Array<T> hessian_, step_;
    T product_; ///< Σ tr S_i W_i
    // Members because they are too large for the stack.
    Square<T> first_, second_, third_, fourth_, right_, factor_;
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

template <class T> bool MaxDet<T>::reserve(int n, std::size_t count) noexcept
{
    d_ = static_cast<std::size_t>(n) + 1;
    size_of_step_ = d_ * (d_ + 1) / 2;
    count_ = count;
    return blocks_.resize(count) && hessian_.resize(size_of_step_ * size_of_step_) &&
           step_.resize(size_of_step_);
}

/// Computes c = a b or a bᵀ.
template <class T>
void MaxDet<T>::multiply(T const *a, T const *b, bool transposed, T *c) const noexcept
{
    for (std::size_t i = 0; i < d_; ++i)
        for (std::size_t j = 0; j < d_; ++j) {
            T sum = T(0);
            for (std::size_t k = 0; k < d_; ++k)
                sum = sum + a[i * d_ + k] * b[transposed ? j * d_ + k : k * d_ + j];
            c[i * d_ + j] = sum;
        }
}

/// Computes the inverse of a symmetric matrix. Returns false if it is not positive definite.
template <class T> bool MaxDet<T>::invert(T const *a, T *inverse) noexcept
{
    for (std::size_t k = 0; k < d_ * d_; ++k) factor_.x[k] = a[k];
    if (!factorize(d_, factor_.x, 0.0)) return false;
    for (std::size_t i = 0; i < d_; ++i) {
        T *const row = inverse + i * d_;
        for (std::size_t j = 0; j < d_; ++j) row[j] = T(i == j ? 1.0 : 0.0);
        substitute(d_, factor_.x, row);
        substitute_back(d_, factor_.x, row);
    }
    return true;
}

template <class T> void MaxDet<T>::begin() noexcept
{
    auto const d = static_cast<double>(d_), share = 1.0 / static_cast<double>(count_);
    for (std::size_t k = 0; k < d_ * d_; ++k) v_.x[k] = T(0);
    for (std::size_t i = 0; i < count_; ++i) {
        Block &block = blocks_[i];
        Square<T> &product = first_;
        for (std::size_t k = 0; k < d_ * d_; ++k)
            block.moments.x[k] = T(k % (d_ + 1) != 0  ? 0.0
                                   : k + 1 == d_ * d_ ? share
                                                      : share / (d - 1.0));
        multiply(block.map.x, block.moments.x, false, product.x);
        multiply(product.x, block.map.x, true, block.inverse.x);
        for (std::size_t k = 0; k < d_ * d_; ++k) v_.x[k] = v_.x[k] + block.inverse.x[k];
    }
    invert(v_.x, z_.x);
    T largest = T(0); // of tr V⁻¹ L_i L_iᵀ
    for (std::size_t i = 0; i < count_; ++i) {
        Square<T> &product = first_;
        multiply(z_.x, blocks_[i].map.x, false, product.x);
        largest = maximum(largest, dot(d_ * d_, product.x, blocks_[i].map.x));
    }
    T const alpha = T(0.25 * d) / largest;
    for (std::size_t k = 0; k < d_ * d_; ++k) z_.x[k] = alpha * z_.x[k];
    for (std::size_t i = 0; i < count_; ++i) {
        blocks_[i].lambda = T(0.5 * d);
        for (T &x : blocks_[i].moments.x) x = x / alpha;
    }
}

/// Computes S, S⁻¹, V, Z⁻¹ and Σ tr S W. Returns false if a matrix is not positive definite.
template <class T> bool MaxDet<T>::evaluate() noexcept
{
    product_ = T(0);
    for (std::size_t k = 0; k < d_ * d_; ++k) v_.x[k] = T(0);
    for (std::size_t i = 0; i < count_; ++i) {
        Block &block = blocks_[i];
        Square<T> &product = first_;
        T *const s = block.slack.x;
        multiply(z_.x, block.map.x, false, product.x);
        for (std::size_t a = 0; a < d_; ++a)
            for (std::size_t b = 0; b <= a; ++b) {
                T sum = a == b ? T(T(sign_of(a, d_)) * block.lambda) : T(0);
                if (a == b && a + 1 == d_) sum = sum + T(static_cast<double>(d_));
                for (std::size_t k = 0; k < d_; ++k)
                    sum = sum - block.map.x[k * d_ + a] * product.x[k * d_ + b];
                s[a * d_ + b] = s[b * d_ + a] = sum;
            }
        product_ = product_ + dot(d_ * d_, s, block.moments.x);
        if (!invert(s, block.inverse.x)) return false;
        multiply(block.map.x, block.moments.x, false, product.x);
        multiply(product.x, block.map.x, true, block.slack_step.x);
        for (std::size_t k = 0; k < d_ * d_; ++k) v_.x[k] = v_.x[k] + block.slack_step.x[k];
    }
    return invert(z_.x, z_inverse_.x);
}

/// Returns the Frobenius norm of a symmetric matrix with the eigenvalues of Z V - 1.
template <class T> double MaxDet<T>::distance_from_inverse() noexcept
{
    Square<T> &product = first_;
    multiply(z_.x, v_.x, false, product.x);
    double sum = 0.0;
    for (std::size_t i = 0; i < d_; ++i)
        for (std::size_t j = 0; j < d_; ++j) {
            T const one = T(i == j ? 1.0 : 0.0);
            sum += rounded((product.x[i * d_ + j] - one) * (product.x[j * d_ + i] - one));
        }
    return elementary::sqrt(sum > 0.0 ? sum : 0.0);
}

/// Adds X -> sym(P X Q) - C tr(C X)/h to the matrix of the equation, whose rows and columns are the
/// entries (a, b) with a <= b.
template <class T>
void MaxDet<T>::add_operator(T const *p, T const *q, T const *coupling, T const &stiffness) noexcept
{
    std::size_t const d = d_;
    for (std::size_t a = 0, row = 0; a < d; ++a)
        for (std::size_t b = a; b < d; ++b, ++row) {
            T *entry = &hessian_[row * size_of_step_];
            T const pull = coupling == nullptr ? T(0) : T(coupling[a * d + b] / stiffness);
            for (std::size_t c = 0; c <= a; ++c) {
                T const pa = T(0.25) * p[a * d + c], pb = T(0.25) * p[b * d + c],
                        qa = T(0.25) * q[a * d + c], qb = T(0.25) * q[b * d + c];
                for (std::size_t e = c; e < (c == a ? b + 1 : d); ++e, ++entry) {
                    *entry = *entry + (pa * q[b * d + e] + qb * p[a * d + e]) +
                             (qa * p[b * d + e] + pb * q[a * d + e]);
                    if (coupling != nullptr) *entry = *entry - pull * coupling[c * d + e];
                }
            }
        }
}

/// Assembles the equation for the step of Z. Its unknowns are the entries of the step above the
/// diagonal, twice, and those on it.
template <class T> void MaxDet<T>::assemble(T const &theta) noexcept
{
    for (std::size_t k = 0; k < hessian_.size(); ++k) hessian_[k] = T(0);
    add_operator(v_.x, z_inverse_.x, nullptr, T(1));
    right_ = z_inverse_;
    for (std::size_t i = 0; i < count_; ++i) {
        Block &block = blocks_[i];
        Square<T> &lw = first_, &ls = second_, &moved_moments = third_, &moved_inverse = fourth_,
                  &product = factor_;
        multiply(block.map.x, block.moments.x, false, lw.x);
        multiply(block.map.x, block.inverse.x, false, ls.x);
        multiply(lw.x, block.map.x, true, moved_moments.x);
        multiply(ls.x, block.map.x, true, moved_inverse.x);
        for (std::size_t a = 0; a < d_; ++a) ls.x[a * d_ + d_ - 1] = -ls.x[a * d_ + d_ - 1];
        multiply(lw.x, ls.x, true, product.x);
        T trace = T(0), stiffness = T(0);
        for (std::size_t a = 0; a < d_; ++a) {
            trace = trace + T(sign_of(a, d_)) * block.inverse.x[a * d_ + a];
            for (std::size_t b = 0; b < d_; ++b) {
                std::size_t const k = a * d_ + b;
                block.coupling.x[k] = T(0.5) * (product.x[k] + product.x[b * d_ + a]);
                stiffness = stiffness + T(sign_of(a, d_) * sign_of(b, d_)) *
                                            (block.moments.x[k] * block.inverse.x[k]);
            }
        }
        block.pull = theta * trace;
        block.stiffness = stiffness;
        add_operator(moved_moments.x, moved_inverse.x, block.coupling.x, stiffness);
        T const factor = block.pull / stiffness;
        for (std::size_t k = 0; k < d_ * d_; ++k)
            right_.x[k] = right_.x[k] - theta * moved_inverse.x[k] + factor * block.coupling.x[k];
    }
    for (std::size_t a = 0, row = 0; a < d_; ++a)
        for (std::size_t b = a; b < d_; ++b, ++row) step_[row] = right_.x[a * d_ + b];
}

/// Solves the equation, and finds the steps of λ, S and W. Returns false if they are not finite.
template <class T> bool MaxDet<T>::find_steps(T const &theta) noexcept
{
    factorize(size_of_step_, hessian_.data(), 0.0);
    substitute(size_of_step_, hessian_.data(), step_.data());
    substitute_back(size_of_step_, hessian_.data(), step_.data());
    bool finite = true;
    for (std::size_t a = 0, row = 0; a < d_; ++a)
        for (std::size_t b = a; b < d_; ++b, ++row) {
            z_step_.x[a * d_ + b] = z_step_.x[b * d_ + a] =
                a == b ? step_[row] : T(T(0.5) * step_[row]);
            double const x = rounded(step_[row]);
            finite &= x - x == 0.0;
        }
    for (std::size_t i = 0; i < count_; ++i) {
        Block &block = blocks_[i];
        Square<T> &product = first_, &other = second_;
        T const change = (block.pull + dot(d_ * d_, block.coupling.x, z_step_.x)) / block.stiffness;
        multiply(z_step_.x, block.map.x, false, product.x);
        for (std::size_t a = 0; a < d_; ++a)
            for (std::size_t b = 0; b < d_; ++b) {
                T sum = a == b ? T(T(sign_of(a, d_)) * change) : T(0);
                for (std::size_t k = 0; k < d_; ++k)
                    sum = sum - block.map.x[k * d_ + a] * product.x[k * d_ + b];
                block.slack_step.x[a * d_ + b] = sum;
            }
        multiply(block.moments.x, block.slack_step.x, false, other.x);
        multiply(other.x, block.inverse.x, false, product.x);
        for (std::size_t a = 0; a < d_; ++a)
            for (std::size_t b = 0; b < d_; ++b) {
                std::size_t const k = a * d_ + b;
                block.moment_step.x[k] = theta * block.inverse.x[k] - block.moments.x[k] -
                                         T(0.5) * (product.x[k] + product.x[b * d_ + a]);
            }
        block.pull = change; // the step of λ
    }
    return finite;
}

template <class T>
bool MaxDet<T>::is_definite_at(Square<T> const &x, Square<T> const &step, T const &share) noexcept
{
    for (std::size_t k = 0; k < d_ * d_; ++k) factor_.x[k] = x.x[k] + share * step.x[k];
    return factorize(d_, factor_.x, 0.0);
}

/// Takes the step, or 95 % of the part of it in which all matrices stay positive definite. Returns
/// the part that was taken.
template <class T> double MaxDet<T>::advance() noexcept
{
    double share = 1.0;
    auto const limit = [&](Square<T> const &x, Square<T> const &step) {
        while (share > 1e-4 && !is_definite_at(x, step, T(share))) share *= 0.9;
    };
    limit(z_, z_step_);
    for (std::size_t i = 0; i < count_; ++i) {
        limit(blocks_[i].slack, blocks_[i].slack_step);
        limit(blocks_[i].moments, blocks_[i].moment_step);
    }
    T const length = T(share < 1.0 ? 0.95 * share : 1.0);
    for (std::size_t k = 0; k < d_ * d_; ++k) z_.x[k] = z_.x[k] + length * z_step_.x[k];
    for (std::size_t i = 0; i < count_; ++i) {
        Block &block = blocks_[i];
        block.lambda = block.lambda + length * block.pull;
        for (std::size_t k = 0; k < d_ * d_; ++k)
            block.moments.x[k] = block.moments.x[k] + length * block.moment_step.x[k];
    }
    return share;
}

template <class T> double MaxDet<T>::solve(double gap) noexcept
{
    double const least = maximum(gap, least_gap(T(0)));
    double share = 1.0, difference = infinity<double>(), last = difference;
    for (int step = 0, idle = 0; step < max_steps && idle < max_idle_steps; ++step) {
        if (!evaluate()) break;
        double const distance = distance_from_inverse();
        difference = rounded(product_) + distance * distance;
        idle = difference < 0.5 * last ? 0 : idle + 1;
        if (idle == 0) last = difference;
        if (difference <= least) break;
        T const theta = product_ * T(reduction(distance, share) / static_cast<double>(count_ * d_));
        assemble(theta);
        if (!find_steps(theta)) break;
        share = advance();
    }
    return difference;
}

} // namespace
} // namespace pw85::detail::enclosing

#endif
