// SPDX-License-Identifier: BSD-3-Clause
// The reduced Newton method for the weights of a few points.
#include "core_set.hpp"

#include "cholesky.hpp"

namespace pw85::detail::enclosing {

namespace {

/// Least pivot, as a fraction of its diagonal entry.
constexpr double least_pivot = 0x1p-50;

} // namespace

bool CoreSet::reserve(std::size_t count) noexcept
{
    return points_.resize(count) && weights_.resize(count) && slacks_.resize(count) &&
           kappa_.resize(count) && steps_.resize(count) && coordinates_.resize(count * rows_) &&
           solved_.resize(count * rows_) && hessian_.resize(count * count);
}

bool CoreSet::contains(std::size_t point) const noexcept
{
    for (std::size_t i = 0; i < size_; ++i)
        if (points_[i] == point) return true;
    return false;
}

void CoreSet::append(std::size_t point, double weight) noexcept
{
    points_[size_] = point;
    weights_[size_] = weight;
    kappa_[size_] = static_cast<double>(rows_);
    ++size_;
}

void CoreSet::remove_idle(double gap) noexcept
{
    auto const d = static_cast<double>(rows_);
    bool const crowded = 2 * size_ > points_.size();
    double const least = crowded ? 0.05 / static_cast<double>(size_) : 1e-4 / (d * d);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size_; ++i) {
        bool const inside = crowded || kappa_[i] < d * (1.0 - 4.0 * gap);
        if (inside && weights_[i] < least) continue;
        points_[kept] = points_[i];
        weights_[kept] = weights_[i];
        kappa_[kept++] = kappa_[i];
    }
    size_ = kept;
}

/// Computes κ and L⁻¹ y of each point. Returns false if V is singular.
bool CoreSet::evaluate() noexcept
{
    double v[(max_dimension + 1) * (max_dimension + 1)] = {};
    for (std::size_t i = 0; i < size_; ++i) {
        double const *const y = coordinates(i);
        for (std::size_t k = 0; k < rows_; ++k)
            for (std::size_t l = 0; l <= k; ++l) v[k * rows_ + l] += weights_[i] * y[k] * y[l];
    }
    factorize(rows_, v, least_pivot);
    bool finite = true;
    for (std::size_t i = 0; i < size_; ++i) {
        double *const g = &solved_[i * rows_];
        for (std::size_t k = 0; k < rows_; ++k) g[k] = coordinates(i)[k];
        substitute(rows_, v, g);
        kappa_[i] = dot(rows_, g, g);
        finite &= kappa_[i] - kappa_[i] == 0.0;
    }
    return finite;
}

bool CoreSet::solve_newton(double theta) noexcept
{
    auto const d = static_cast<double>(rows_);
    for (std::size_t i = 0; i < size_; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            double const product = dot(rows_, &solved_[i * rows_], &solved_[j * rows_]);
            hessian_[i * size_ + j] = product * product;
        }
        hessian_[i * size_ + i] += slacks_[i] / weights_[i];
        steps_[i] = theta / weights_[i] - (d - kappa_[i]);
    }
    factorize(size_, hessian_.data(), least_pivot);
    substitute(size_, hessian_.data(), steps_.data());
    substitute_back(size_, hessian_.data(), steps_.data());
    bool finite = true;
    for (std::size_t i = 0; i < size_; ++i) finite &= steps_[i] - steps_[i] == 0.0;
    if (!finite) return false;
    // The step of t follows from u t + u δt + t δu = θ. It replaces κ, which is computed again.
    for (std::size_t i = 0; i < size_; ++i)
        kappa_[i] = (theta - slacks_[i] * steps_[i]) / weights_[i] - slacks_[i];
    return true;
}

/// Takes the step, or the part of it in which no weight and no slack loses more than 95 % of its
/// size. Returns this part.
double CoreSet::advance() noexcept
{
    double share = 1.0;
    auto const limit = [&](double x, double step) {
        if (step < 0.0 && -step * share > 0.95 * x) share = 0.95 * x / -step;
    };
    for (std::size_t i = 0; i < size_; ++i) {
        limit(weights_[i], steps_[i]);
        limit(slacks_[i], kappa_[i]);
    }
    for (std::size_t i = 0; i < size_; ++i) {
        weights_[i] += share * steps_[i];
        slacks_[i] += share * kappa_[i];
    }
    return share;
}

void CoreSet::normalize() noexcept
{
    double total = 0.0;
    for (std::size_t i = 0; i < size_; ++i) total += weights_[i];
    for (std::size_t i = 0; i < size_; ++i) {
        weights_[i] /= total;
        kappa_[i] *= total;
    }
}

void CoreSet::solve(double gap) noexcept
{
    auto const d = static_cast<double>(rows_), count = static_cast<double>(size_);
    for (std::size_t i = 0; i < size_; ++i) slacks_[i] = 1.0;
    double share = 0.0;
    for (int step = 0; step < 80 && evaluate(); ++step) {
        double product = 0.0, total = 0.0, largest = 0.0;
        for (std::size_t i = 0; i < size_; ++i) {
            product += weights_[i] * slacks_[i];
            total += weights_[i];
            largest = kappa_[i] > largest ? kappa_[i] : largest;
        }
        if (largest * total <= d + (d - 1.0) * gap || product < 0x1p-60) break;
        double const theta = product / count * (share > 0.7 ? 0.1 : 0.5);
        if (!solve_newton(theta)) break;
        share = advance();
    }
    evaluate();
    normalize();
}

} // namespace pw85::detail::enclosing
